//! The sections and keys of a scene file, and suggestions for misspelt ones.

use passivity_core::Parameter;

use crate::diagnostic::{Diagnostic, Kind};

/// The sections of a scene file, in the order in which they are listed; the first holds what
/// stands before any section.
const SECTIONS: [&str; 16] = [
    "",
    "device",
    "joint",
    "joint.encoder",
    "transmission",
    "motor",
    "sampling",
    "encoder",
    "wall",
    "controller",
    "amplifier",
    "operator",
    "operator.arm",
    "start",
    "run",
    "dimensionless",
];

/// The keys that are no parameters, with their sections.
const OTHER_KEYS: [&str; 21] = [
    ".name",
    "transmission.ratio",
    "transmission.motor_pulley",
    "transmission.output_pulley",
    "transmission.handle_radius",
    "encoder.side",
    "sampling.delay",
    "wall.unilateral",
    "wall.direction",
    "wall.stiffness_matrix",
    "joint.name",
    "joint.viscous",
    "joint.coulomb",
    "joint.max_speed",
    "joint.encoder",
    "joint.encoder.resolution",
    "joint.encoder.counts_per_revolution",
    "controller.numerator",
    "controller.denominator",
    "operator.arm",
    "run.intervals",
];

/// Every key with its section, `section.key`: those of the parameters and the others.
pub(super) fn all_keys() -> impl Iterator<Item = &'static str> {
    let rows = Parameter::ALL.iter().map(|parameter| parameter.row());
    let of_parameters = rows.filter(|row| !row.key.is_empty()).flat_map(|row| {
        let keys = [row.key].into_iter().chain(row.other_keys.iter().copied());
        keys.chain(row.dimensionless_key)
    });
    of_parameters.chain(OTHER_KEYS)
}

/// Words that people use for a key, with its section.
const SYNONYMS: [(&str, &str); 34] = [
    ("m", "device.inertia"),
    ("b", "device.viscous"),
    ("c", "device.coulomb"),
    ("viscous_friction", "device.viscous"),
    ("coulomb_friction", "device.coulomb"),
    ("friction", "device.coulomb"),
    ("gear_ratio", "transmission.ratio"),
    ("gear", "transmission.ratio"),
    ("n", "transmission.ratio"),
    ("t", "sampling.period"),
    ("dt", "sampling.period"),
    ("timestep", "sampling.period"),
    ("time_step", "sampling.period"),
    ("frequency", "sampling.rate"),
    ("sample_rate", "sampling.rate"),
    ("sampling_rate", "sampling.rate"),
    ("computing_time", "sampling.latency"),
    ("cutoff", "wall.damping_cutoff"),
    ("filter", "wall.damping_cutoff"),
    ("num", "controller.numerator"),
    ("den", "controller.denominator"),
    ("counts", "encoder.counts_per_revolution"),
    ("cpr", "encoder.counts_per_revolution"),
    ("ppr", "encoder.counts_per_revolution"),
    ("k", "wall.stiffness"),
    ("one_sided", "wall.unilateral"),
    ("saturation", "wall.max_force"),
    ("x0", "start.position"),
    ("v0", "start.velocity"),
    ("speed", "operator.max_speed"),
    ("steps", "run.intervals"),
    ("samples", "run.intervals"),
    ("β", "dimensionless.beta"),
    ("σ", "dimensionless.sigma"),
];

/// How alike two words must be for one to be taken as a slip of the other.
const ALIKE: f64 = 0.8;

/// The longest key that is compared with known ones.
const MAX_KEY: usize = 64;

/// The keys of a section, without its name.
fn known(section: &str) -> Vec<&'static str> {
    let in_section = |key: &'static str| {
        let (home, name) = key.rsplit_once('.')?;
        (home == section).then_some(name)
    };
    all_keys().filter_map(in_section).collect()
}

/// The names of sections: those of the file's top level.
pub(super) fn sections() -> impl Iterator<Item = &'static str> {
    let named = SECTIONS.into_iter();
    named.filter(|name| !name.is_empty() && !name.contains('.'))
}

fn closest<'a>(word: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    if word.len() > MAX_KEY {
        return None;
    }
    let word = word.to_lowercase().replace('-', "_");
    let scored = candidates.map(|c| (strsim::jaro_winkler(&word, c), c));
    scored
        .filter(|(score, _)| *score >= ALIKE)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, c)| c)
}

/// The sections that have this key, as `[wall]`.
fn homes(key: &str) -> Vec<String> {
    let split = all_keys().filter_map(|known| known.rsplit_once('.'));
    let having: Vec<&str> = split
        .filter(|(_, name)| *name == key)
        .map(|(home, _)| home)
        .collect();
    let sections = SECTIONS.iter().filter(|section| having.contains(section));
    sections.map(|section| heading(section)).collect()
}

fn heading(section: &str) -> String {
    if section.is_empty() {
        "the top of the file, before any section".to_owned()
    } else if section == "joint" {
        "[[joint]]".to_owned()
    } else {
        format!("[{section}]")
    }
}

fn list(words: impl Iterator<Item = &'static str>) -> String {
    words
        .map(|w| format!("`{w}`"))
        .collect::<Vec<_>>()
        .join(", ")
}

/// What to say of a key that its section does not have.
pub(super) fn wrong_key(section: &str, key: &str) -> Diagnostic {
    let shown = shorten(key);
    let message = if section.is_empty() {
        format!("`{shown}` is not a key that stands before the sections")
    } else {
        format!("`{shown}` is not a key of {}", heading(section))
    };
    let keys = known(section);
    let expected = match keys.as_slice() {
        [only] => format!("`{only}`"),
        keys => format!("one of {}", list(keys.iter().copied())),
    };
    let homes = homes(key);
    if !homes.is_empty() {
        return Diagnostic::new(Kind::WrongSection, message)
            .expected(expected)
            .found(format!("`{shown}`"))
            .help(Some(format!("`{shown}` belongs in {}", homes.join(" or "))));
    }
    let synonym = SYNONYMS
        .iter()
        .find(|(word, _)| *word == key.to_lowercase());
    let help = match (closest(key, keys.into_iter()), synonym) {
        (_, Some((_, meant))) => Some(format!("did you mean `{meant}`?")),
        (Some(meant), None) => Some(format!("did you mean `{meant}`?")),
        (None, None) => None,
    };
    Diagnostic::new(Kind::UnknownKey, message)
        .expected(expected)
        .found(format!("`{shown}`"))
        .help(help)
}

/// What to say of a section that no scene has.
pub(super) fn wrong_section(name: &str) -> Diagnostic {
    let shown = shorten(name);
    let help = closest(name, sections()).map(|meant| format!("did you mean `[{meant}]`?"));
    let message = format!("a scene has no section `[{shown}]`");
    Diagnostic::new(Kind::UnknownSection, message)
        .expected(format!("one of {}", list(sections())))
        .found(format!("`[{shown}]`"))
        .help(help)
}

/// The text, cut where it is too long for a message.
pub(super) fn shorten(text: &str) -> String {
    const KEPT: usize = 40;
    let mut shown: String = text
        .chars()
        .take(KEPT)
        .flat_map(char::escape_debug)
        .collect();
    if text.chars().nth(KEPT).is_some() {
        shown.push('…');
    }
    shown
}
