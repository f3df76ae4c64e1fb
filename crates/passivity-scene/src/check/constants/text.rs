//! The constants as the text of a program.

use std::fmt::{self, Write as _};

use passivity_core::Parameter;

use super::{Amount, Condition, Constants, Target};
use crate::display::wrapped;
use crate::scene::Motion;

impl Constants {
    /// The constants as the source text of a program.
    #[must_use]
    pub fn to_source(&self) -> String {
        let mut lines = self.comment();
        match self.target {
            Target::C => self.as_c(&mut lines),
            Target::Chai3d => self.as_chai3d(&mut lines),
            Target::OpenHaptics => self.as_open_haptics(&mut lines),
        }
        lines
    }

    fn comment(&self) -> String {
        let mut out = String::from("/*\n");
        let mut say = |text: &str| {
            for line in wrapped(text, 3).lines() {
                // A name can neither end the comment nor begin another.
                let line = line.trim_start().replace("*/", "* /").replace("/*", "/ *");
                let _ = writeln!(out, " * {line}");
            }
        };
        say(&format!(
            "Constants of the virtual wall «{}», written by passivity {}.",
            self.scene,
            env!("CARGO_PKG_VERSION")
        ));
        say(&format!("{}.", self.headline));
        say(&format!("Rests on {}.", self.because.join(", ")));
        say(&format!("What binds: {}.", self.binds));
        let (damping, smallest) = match self.min_damping {
            Some(_) => (
                "the smallest and the largest damping",
                " Less damping than the smallest, or none, does not pass or is not shown to.",
            ),
            None => ("the largest damping", ""),
        };
        let largest = match self.target {
            Target::Chai3d if self.max_stiffness.is_some() && self.is_late() && self.damping > 0.0 => {
                " The largest stiffness holds with the damping written beside it, and is not shown to \
                 hold with less."
                    .to_owned()
            }
            Target::Chai3d if self.max_stiffness.is_some() => {
                " The largest stiffness holds with the damping written beside it.".to_owned()
            }
            Target::C | Target::OpenHaptics
                if self.max_stiffness.is_some() && self.max_damping.is_some() =>
            {
                format!(
                    " The largest stiffness holds with the scene's damping, {damping} with the scene's \
                     stiffness; the two largest values do not hold together.{smallest}"
                )
            }
            _ => String::new(),
        };
        let tolerance = match self.has_tolerance {
            true => {
                " Each holds with the tolerance that the scene gives its parameter, in the same ratio \
                 to the number."
            }
            false => "",
        };
        let own = match (self.is_passive, self.target) {
            (true, _) | (_, Target::Chai3d | Target::OpenHaptics) => "",
            (false, Target::C) => {
                ", but for the scene's own stiffness, which is not shown to be passive"
            }
        };
        say(&format!(
            "Every number is a double on the safe side of what was proved{own}.{tolerance}{largest}"
        ));
        say(&format!(
            "The loop for which it was proved has {}.",
            self.effects.join(", ")
        ));
        say(&format!("In the scene: {}.", self.given.join("; ")));
        if let Some(law) = self.law() {
            say(law);
        }
        if !self.not_shown_with.is_empty() {
            say(&format!(
                "Nothing is shown of a loop that also has {}: put it into the scene and export again.",
                self.not_shown_with.join(", or ")
            ));
        }
        out.push_str(" */\n");
        out
    }

    fn is_late(&self) -> bool {
        self.conditions
            .iter()
            .any(|condition| condition.name == "delay")
    }

    /// How the program makes the force, where it is more than a spring.
    fn law(&self) -> Option<&'static str> {
        let is_filtered = |condition: &Condition| condition.name == "damping_time_constant";
        if self.has_controller {
            return Some(
                "The force is minus the stiffness times H(z) of the measured position, \
                 H(z) = (n0 + n1 z^-1 + ...)/(d0 + d1 z^-1 + ...).",
            );
        }
        if self.conditions.iter().any(is_filtered) {
            return Some(
                "The force of damping is minus the damping times the sampling rate times y, where \
                 y = a y + (1 - a) d at each sample: d is the measured position less that of the sample \
                 before, and a = tau/(T + tau) of the filter's time constant and the sampling period. \
                 Without the filter the damping is not shown to be passive.",
            );
        }
        self.max_damping.map(|_| {
            "The force of damping is minus the damping times the sampling rate times d: d is the \
             measured position less that of the sample before."
        })
    }

    /// What a number holds with, behind its unit: another number, and the conditions.
    fn with(&self, other: &str) -> String {
        match (other, self.conditions.is_empty()) {
            ("", true) => String::new(),
            ("", false) => ", under the conditions below".to_owned(),
            (_, true) => format!(", with {other}"),
            (_, false) => format!(", with {other} and under the conditions below"),
        }
    }

    fn unit(&self, parameter: Parameter) -> &'static str {
        self.target.unit(parameter, self.motion).0
    }

    fn force_limit(&self) -> String {
        let unit = self.unit(Parameter::MaxForce);
        format!("{unit}, to which the force is limited")
    }

    /// Why there is no largest stiffness: where the scene's own passes it is past all doubles.
    const fn no_stiffness(&self) -> &'static str {
        match self.is_passive {
            true => "no double is known for it, though the scene's wall is passive",
            false => "no wall is passive",
        }
    }

    /// Why there is no largest damping.
    fn no_damping(&self) -> &'static str {
        if self.has_controller {
            return "the scene's controller is in the place of virtual damping";
        }
        match self.is_passive && self.damping > 0.0 {
            true => "no double is known for it, though the scene's damping is passive",
            false => "none is passive",
        }
    }

    fn as_c(&self, out: &mut String) {
        let name = identifier(&self.scene);
        let guard = format!("{name}_WALL_H");
        let _ = writeln!(out, "#ifndef {guard}\n#define {guard}\n");
        let mut define = |key: &str, value: Option<f64>, unit: &str, absent: &str| {
            let _ = match value {
                Some(value) => writeln!(out, "#define {name}_{key} {value:?} /* {unit} */"),
                None => writeln!(out, "/* {name}_{key}: {absent} */"),
            };
        };
        let stiffness = self.unit(Parameter::Stiffness);
        let damping = self.unit(Parameter::Damping);
        let own = |unit: &str| format!("{unit}{}", self.with(""));
        let of_stiffness = match self.is_passive {
            true => own(stiffness),
            false => format!(
                "{stiffness}, the scene's: with {name}_DAMPING it is not shown to be passive"
            ),
        };
        define("STIFFNESS", Some(self.stiffness), &of_stiffness, "");
        define(
            "MAX_STIFFNESS",
            self.max_stiffness,
            &format!("{stiffness}{}", self.with(&format!("{name}_DAMPING"))),
            self.no_stiffness(),
        );
        define("DAMPING", Some(self.damping), &own(damping), "");
        let about = format!("{damping}{}", self.with(&format!("{name}_STIFFNESS")));
        if let Some(least) = self.min_damping {
            define("MIN_DAMPING", Some(least), &about, "");
        }
        define("MAX_DAMPING", self.max_damping, &about, self.no_damping());
        define("SAMPLING_RATE", Some(self.rate), "Hz", "");
        define(
            "MAX_SPEED",
            self.max_speed,
            self.unit(Parameter::MaxSpeed),
            "not bounded, the verdict holds at every speed or at none",
        );
        define(
            "MAX_FORCE",
            self.max_force,
            &self.force_limit(),
            "not in the scene",
        );
        write_conditions(out, &self.conditions, |condition| {
            let key = condition.name.to_ascii_uppercase();
            format!("#define {name}_{key} {}", condition.value)
        });
        let _ = writeln!(out, "\n#endif");
    }

    fn as_chai3d(&self, out: &mut String) {
        let (kind, force) = match self.motion {
            Motion::Rotary => ("Angular", "Torque"),
            _ => ("Linear", "Force"),
        };
        let _ = writeln!(
            out,
            "/* Fields of chai3d::cHapticDeviceInfo, in its SI units. */"
        );
        // The library reads both, so the largest stiffness stands beside the damping it holds with.
        let _ = match self.max_stiffness {
            Some(most) => writeln!(
                out,
                "info.m_max{kind}Stiffness = {most:?};\n\
                 info.m_max{kind}Damping = {:?}; /* the scene's{} */",
                self.damping,
                self.with("")
            ),
            None if self.is_passive => writeln!(
                out,
                "info.m_max{kind}Stiffness = {:?}; /* the scene's; the largest: {} */\n\
                 info.m_max{kind}Damping = {:?}; /* the scene's{} */",
                self.stiffness,
                self.no_stiffness(),
                self.damping,
                self.with("")
            ),
            None => writeln!(
                out,
                "info.m_max{kind}Stiffness = 0.0; /* none is passive with the scene's damping */\n\
                 info.m_max{kind}Damping = 0.0;"
            ),
        };
        if let Some(most) = self.max_force {
            let _ = writeln!(out, "info.m_max{kind}{force} = {most:?};");
        }
        let _ = writeln!(
            out,
            "/* The haptic thread must run at {:?} Hz. */",
            self.rate
        );
        self.speed_comment(out);
        write_conditions(out, &self.conditions, |condition| {
            declaration("const", "double", "", condition)
        });
    }

    fn as_open_haptics(&self, out: &mut String) {
        let [unit, damping_unit] =
            [Parameter::Stiffness, Parameter::Damping].map(|of| self.unit(of));
        let _ = match self.whole_rate {
            Some(rate) => writeln!(
                out,
                "hdSetSchedulerRate({rate:.0}); /* Hz; the scene has {:?} Hz */",
                self.rate
            ),
            None => writeln!(
                out,
                "/* Nothing is shown for a whole number of hertz; the scene has {:?} Hz. */",
                self.rate
            ),
        };
        let mut constant = |name: &str, value: f64, about: &str| {
            let _ = writeln!(
                out,
                "static const HDdouble {name} = {value:?}; /* {about} */"
            );
        };
        let about = |unit: &str, other: &str| format!("{unit}{}", self.with(other));
        constant("kStiffness", self.stiffness, &about(unit, ""));
        constant("kDamping", self.damping, &about(damping_unit, ""));
        if let Some(most) = self.max_stiffness {
            constant("kMaxStiffness", most, &about(unit, "kDamping"));
        }
        let ends = [
            ("kMinDamping", self.min_damping),
            ("kMaxDamping", self.max_damping),
        ];
        for (name, end) in ends {
            if let Some(end) = end {
                constant(name, end, &about(damping_unit, "kStiffness"));
            }
        }
        if let Some(most) = self.max_force {
            let about = self.force_limit();
            let _ = writeln!(
                out,
                "static const HDdouble kMaxForce = {most:?}; /* {about} */"
            );
        }
        let _ = match (self.max_stiffness, self.motion) {
            (None, _) => writeln!(out, "/* kMaxStiffness: {}. */", self.no_stiffness()),
            (Some(_), Motion::Rotary) => writeln!(
                out,
                "/* HL_STIFFNESS is left out: it is a part of HD_NOMINAL_MAX_STIFFNESS, which is in N/mm, \
                 and this wall turns. */"
            ),
            (Some(_), _) => writeln!(
                out,
                "/* HL_STIFFNESS takes a part of the device's nominal largest stiffness, as a float (math.h): */\n\
                 HDdouble nominal;\n\
                 hdGetDoublev(HD_NOMINAL_MAX_STIFFNESS, &nominal); /* N/mm */\n\
                 hlMaterialf(HL_FRONT_AND_BACK, HL_STIFFNESS, kMaxStiffness < nominal ? \
                 nextafterf(kMaxStiffness / nominal, 0) : 1);"
            ),
        };
        if self.max_damping.is_none() {
            let _ = writeln!(out, "/* kMaxDamping: {}. */", self.no_damping());
        }
        self.speed_comment(out);
        write_conditions(out, &self.conditions, |condition| {
            declaration("static const", "HDdouble", "k", condition)
        });
    }

    fn speed_comment(&self, out: &mut String) {
        if let Some(v) = self.max_speed {
            let unit = self.unit(Parameter::MaxSpeed);
            let _ = writeln!(
                out,
                "/* Only while the hand is never faster than {v:?} {unit}. */"
            );
        }
    }
}

impl fmt::Display for Amount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole(n) => write!(f, "{n}"),
            Self::Double(x) => write!(f, "{x:?}"),
            Self::Coefficients(all) => {
                let all: Vec<String> = all.iter().map(|x| format!("{x:?}")).collect();
                write!(f, "{{ {} }}", all.join(", "))
            }
        }
    }
}

/// The conditions, each as `declared` writes it, with what it is behind it.
fn write_conditions(
    out: &mut String,
    conditions: &[Condition],
    declared: impl Fn(&Condition) -> String,
) {
    if conditions.is_empty() {
        return;
    }
    let _ = writeln!(
        out,
        "/* Conditions: the numbers above hold only with all of these. */"
    );
    for condition in conditions {
        let about = [condition.unit, condition.about].into_iter();
        let about: Vec<&str> = about.filter(|text| !text.is_empty()).collect();
        let _ = writeln!(
            out,
            "{} /* {} */",
            declared(condition),
            about.join(", ").trim_end()
        );
    }
}

/// A condition as a constant of C++: `prefix` and its words, each but the first with a capital.
fn declaration(before: &str, double: &str, prefix: &str, condition: &Condition) -> String {
    let mut name = prefix.to_owned();
    for word in condition.name.split('_') {
        let (first, rest) = word.split_at(1);
        match name.is_empty() {
            true => name += first,
            false => name += &first.to_ascii_uppercase(),
        }
        name += rest;
    }
    let (kind, brackets) = match &condition.value {
        Amount::Whole(_) => ("int", ""),
        Amount::Double(_) => (double, ""),
        Amount::Coefficients(_) => (double, "[]"),
    };
    format!("{before} {kind} {name}{brackets} = {};", condition.value)
}

/// The name as a C identifier in capitals; letters that C does not have stay apart by their numbers.
fn identifier(name: &str) -> String {
    let letters = name.chars().map(|c| match c {
        c if c.is_ascii_alphanumeric() => c.to_ascii_uppercase().to_string(),
        c if c.is_ascii() => '_'.to_string(),
        c => format!("U{:04X}", u32::from(c)),
    });
    let name: String = letters.take(60).collect();
    match name.chars().next() {
        Some(c) if c.is_ascii_digit() => format!("WALL_{name}"),
        _ => name,
    }
}
