//! The constants as the text of a program.

use std::fmt::Write as _;

use passivity_core::{BigRational, Parameter};

use super::{Constants, Target, below};
use crate::check::text::unit_of;
use crate::display::wrapped;
use crate::scene::Motion;

impl Constants {
    /// The constants as the source text of a program.
    #[must_use]
    pub fn to_source(&self, target: Target) -> String {
        let mut lines = self.comment(target);
        match target {
            Target::C => self.as_c(&mut lines),
            Target::Chai3d => self.as_chai3d(&mut lines),
            Target::OpenHaptics => self.as_open_haptics(&mut lines),
        }
        lines
    }

    fn comment(&self, target: Target) -> String {
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
        let largest = match target {
            Target::Chai3d if self.max_stiffness.is_some() => {
                " The largest stiffness holds with the damping written beside it."
            }
            Target::C | Target::OpenHaptics
                if self.max_stiffness.is_some() && self.max_damping.is_some() =>
            {
                " The largest stiffness holds with the scene's damping, the largest damping with the \
                 scene's stiffness; the two largest values do not hold together."
            }
            _ => "",
        };
        say(&format!(
            "Every number is a double on the safe side of what was proved.{largest}"
        ));
        out.push_str(" */\n");
        out
    }

    fn unit(&self, parameter: Parameter) -> &'static str {
        unit_of(parameter, self.motion)
    }

    /// Why there is no largest damping.
    const fn no_damping(&self) -> &'static str {
        match self.has_controller {
            true => "the scene's controller is in the place of virtual damping",
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
        define("STIFFNESS", Some(self.stiffness), stiffness, "");
        define(
            "MAX_STIFFNESS",
            self.max_stiffness,
            &format!("{stiffness}, with {name}_DAMPING"),
            "no wall is passive",
        );
        define("DAMPING", Some(self.damping), damping, "");
        define(
            "MAX_DAMPING",
            self.max_damping,
            &format!("{damping}, with {name}_STIFFNESS"),
            self.no_damping(),
        );
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
            self.unit(Parameter::MaxForce),
            "not in the scene",
        );
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
                 info.m_max{kind}Damping = {:?}; /* the scene's */",
                self.damping
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
    }

    fn as_open_haptics(&self, out: &mut String) {
        let ([unit, damping_unit], factor) = match self.motion {
            Motion::Rotary => (["N m/rad", "N m s/rad"], 1),
            _ => (["N/mm", "N s/mm"], 1000),
        };
        let scaled = |value: f64| {
            let exact = BigRational::from_float(value);
            exact.map_or(0.0, |x| {
                below(&(x / BigRational::from_integer(factor.into())))
            })
        };
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
            let value = scaled(value);
            let _ = writeln!(
                out,
                "static const HDdouble {name} = {value:?}; /* {about} */"
            );
        };
        constant("kStiffness", self.stiffness, unit);
        constant("kDamping", self.damping, damping_unit);
        if let Some(most) = self.max_stiffness {
            constant("kMaxStiffness", most, &format!("{unit}, with kDamping"));
        }
        if let Some(most) = self.max_damping {
            constant(
                "kMaxDamping",
                most,
                &format!("{damping_unit}, with kStiffness"),
            );
        }
        let _ = match (self.max_stiffness, self.motion) {
            (None, _) => writeln!(out, "/* kMaxStiffness: no wall is passive. */"),
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
