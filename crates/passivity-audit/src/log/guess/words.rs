//! The words of the names of columns, and what they say.

mod motions;

pub(super) use motions::{MADE, MEASURED, NOT_MEASURED, OF_ANOTHER, PERHAPS_WANTED};

/// Those of them that are no time either: `wall_time` and `command_time` are.
pub(super) const NO_TIME: [&str; 5] = ["error", "err", "offset", "limit", "stiffness"];

/// What stands in parentheses behind a name beside its unit, and is none.
pub(super) const ASIDE: [&str; 36] = [
    "raw",
    "filtered",
    "filt",
    "estimated",
    "est",
    "left",
    "right",
    "motor",
    "joint",
    "axis",
    "link",
    "knob",
    "handle",
    "shaft",
    "output",
    "input",
    "side",
    "load",
    "master",
    "slave",
    "host",
    "system",
    "local",
    "adc",
    "dac",
    "x",
    "y",
    "z",
    "a",
    "b",
    "i",
    "j",
    "roll",
    "pitch",
    "yaw",
    "abs",
];

/// What a word says behind a force that is none: whether it is on, or how large it may be.
pub(super) const NO_FORCE: [&str; 9] = [
    "enabled",
    "enable",
    "limit",
    "flag",
    "valid",
    "mode",
    "status",
    "threshold",
    "ok",
];

/// What is no position, though its last word may be `x`: a derivative, which is named after what it is one of,
/// and other vectors.
pub(super) const NO_POSITION: [&str; 12] = [
    "dot",
    "velocity",
    "speed",
    "force",
    "torque",
    "moment",
    "effort",
    "wrench",
    "twist",
    "acceleration",
    "orientation",
    "covariance",
];

/// What a force that was held is called.
pub(super) const HELD: [&str; 6] = ["cmd", "command", "commanded", "motor", "applied", "desired"];

/// What a column is called that may have the force that a controller commands, where all its words are of these two lists:
/// `u`, `pid_out`, `/motor/cmd.data`, `par_motor`.
pub(super) const COMMANDED: [&str; 19] = [
    "u",
    "cmd",
    "command",
    "commanded",
    "control",
    "ctrl",
    "output",
    "out",
    "par",
    "rendered",
    "render",
    "dac",
    "pwm",
    "drive",
    "befehl",
    "stellwert",
    "stellgröße",
    "stellgrösse",
    "stellgroesse",
];
pub(super) const COMMANDER: [&str; 11] = [
    "actuator",
    "controller",
    "data",
    "device",
    "haptic",
    "motor",
    "pid",
    "signal",
    "value",
    "wall",
    "wrench",
];

/// What is called a force by two words at the end of its name.
pub(super) const FORCE_PAIRS: [[&str; 2]; 3] = [["t", "q"], ["load", "cell"], ["ft", "sensor"]];

/// What stands behind the letter of a force in one word, as in `Fcmd` and `Ttot`.
pub(super) const OF_FORCE: [&str; 9] = [
    "cmd", "command", "motor", "mot", "applied", "tot", "total", "out", "act",
];

/// What stands in one word before a position that was measured, as in `Motorwinkel` and `motorposition`.
pub(super) const OF_DEVICE: [&str; 21] = [
    "motor", "rotor", "servo", "dreh", "geber", "encoder", "ist", "achs", "achsen", "gelenk",
    "wellen", "knopf", "joint", "knob", "handle", "shaft", "axis", "wheel", "device", "actual",
    "antriebs",
];

/// What a count is called, as a word of a name or as a unit.
pub(super) const COUNTED: [&str; 13] = [
    "count",
    "tick",
    "cnt",
    "lsb",
    "inc",
    "increment",
    "inkr",
    "inkrement",
    "inkremente",
    "pulse",
    "step",
    "schritt",
    "schritte",
];

/// Those of them that number the rows of a log, too.
pub(super) const OF_STEPS: [&str; 3] = ["step", "schritt", "schritte"];

/// What counts sampling periods, and what counts ticks of a clock, whose length it does not say.
pub(super) const OF_PERIODS: [&str; 5] = ["sample", "seq", "sequence", "iteration", "iter"];
pub(super) const OF_TICKS: [&str; 4] = ["tick", "systick", "jiffie", "cyccnt"];

/// The signs of micro: that of its own and the Greek letter.
pub(super) const MICRO: [char; 2] = ['\u{b5}', '\u{3bc}'];

/// The sign of degrees, and those that are typed for it.
pub(super) const DEGREE: [char; 3] = ['°', 'º', '˚'];

/// What else a force that was held is called beside one that is only called `f`.
pub(super) const PERHAPS_HELD: [&str; 16] = [
    "sent",
    "sat",
    "saturated",
    "lim",
    "limited",
    "clipped",
    "clamped",
    "out",
    "output",
    "dac",
    "held",
    "act",
    "actual",
    "real",
    "tot",
    "total",
];

/// What else stands behind the letter of a force or a torque that moves, as in `Fd`, `Fwall`, `taum` and `M_soll`. Letters alone
/// are small then, or stand behind an underscore: `MS`, `TS` and `FS` are others.
pub(super) const OF_LETTER: [&str; 64] = [
    "a",
    "d",
    "e",
    "k",
    "m",
    "n",
    "r",
    "s",
    "t",
    "v",
    "w",
    "vw",
    "wall",
    "set",
    "setpoint",
    "soll",
    "ist",
    "ref",
    "des",
    "desired",
    "dem",
    "demand",
    "target",
    "goal",
    "sent",
    "sat",
    "saturated",
    "limited",
    "held",
    "actual",
    "meas",
    "measured",
    "real",
    "sens",
    "sensor",
    "ctrl",
    "ctl",
    "control",
    "dac",
    "drive",
    "dev",
    "device",
    "app",
    "appl",
    "con",
    "cont",
    "contact",
    "spring",
    "spr",
    "damp",
    "damper",
    "haptic",
    "hap",
    "virt",
    "virtual",
    "render",
    "rendered",
    "hand",
    "human",
    "user",
    "env",
    "sum",
    "net",
    "res",
];

/// Words of a small letter and one of these that are more often something else: a fact, feet, and a rate of samples.
pub(super) const NO_LETTER: [&str; 3] = ["fact", "ft", "fs"];

/// The torques of a motor, whose winding is in it and whose drive it is: words, and the starts of words.
pub(super) const OF_WINDING: [&str; 4] = ["winding", "electromagnetic", "wicklung", "antrieb"];

/// The words of a name, in lower case and in the singular; a sign of degrees is one.
pub(super) fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in name.chars() {
        let is_letter = |c: char| c.is_alphabetic() && !DEGREE.contains(&c);
        // As in `posµm`; in Greek words the letter is one like others.
        let is_micro = MICRO.contains(&c) && before.is_ascii_alphabetic();
        let continues = is_letter(c)
            && is_letter(before)
            && !is_micro
            && (before.is_uppercase() || !c.is_uppercase());
        if c.is_alphabetic() || DEGREE.contains(&c) {
            match words.last_mut() {
                Some(word) if continues => word.extend(c.to_lowercase()),
                _ => words.push(c.to_lowercase().collect()),
            }
        }
        before = c;
    }
    for word in &mut words {
        // Times in French and in Polish are no plurals.
        let is_plural = word.ends_with('s') && !["temps", "czas"].contains(&word.as_str());
        if word.len() > 3 && is_plural {
            word.pop();
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_fall_into_words() {
        for (name, expected) in [
            (
                "/joint_states/position[0]",
                &["joint", "state", "position"][..],
            ),
            ("motorTorque", &["motor", "torque"]),
            ("__time", &["time"]),
            ("field.header.stamp", &["field", "header", "stamp"]),
            ("θ", &["θ"]),
            ("Position1", &["position"]),
            ("encoder_counts", &["encoder", "count"]),
            ("phi°", &["phi", "°"]),
            ("Wegµm", &["weg", "µm"]),
            ("γραμμή", &["γραμμή"]),
        ] {
            assert_eq!(words(name), expected, "{name}");
        }
    }
}
