//! The constants that a control program asks for, on the safe side as doubles.

use std::fmt::Write as _;

use passivity_core::verdict::{End, Speeds};
use passivity_core::{BigRational, Enclosed, Interval, Loop, Parameter, Wide};
use schemars::JsonSchema;
use serde::Serialize;

use super::limits::{self, Limit};
use super::text::unit_of;
use super::{BITS, Verdict, check};
use crate::display::{Rounding, rounded, wrapped};
use crate::number::nearest_f64;
use crate::scene::{Motion, Scene};

/// For which program constants are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A header in C, in SI units.
    C,
    /// CHAI3D's `cHapticDeviceInfo`: linear or angular stiffness and damping, in SI units.
    Chai3d,
    /// OpenHaptics: newtons, millimetres and hertz.
    OpenHaptics,
}

/// The constants of a scene: each number is a double on the safe side of what was proved.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Constants {
    /// The scene's name.
    pub scene: String,
    /// The verdict, and the speeds that it speaks of.
    pub headline: String,
    /// The ids of the theorems that the verdict rests on.
    pub because: Vec<&'static str>,
    /// What uses up the friction, in words.
    pub binds: String,
    /// How the device moves.
    #[serde(skip)]
    pub motion: Motion,
    /// The scene's stiffness, N/m or N·m/rad: passive where the verdict is.
    pub stiffness: f64,
    /// The largest stiffness that is passive at these speeds; `None` where none is.
    pub max_stiffness: Option<f64>,
    /// The scene's virtual damping, N·s/m or N·m·s/rad.
    pub damping: f64,
    /// The largest virtual damping beside the scene's stiffness; `None` where there is none, or where
    /// a digital controller is in its place.
    pub max_damping: Option<f64>,
    /// The sampling rate in hertz.
    pub rate: f64,
    /// The speed up to which the verdict holds, m/s or rad/s; `None` for every speed.
    pub max_speed: Option<f64>,
    /// The largest force that the scene lets the actuator give, N or N·m.
    pub max_force: Option<f64>,
    /// Whether the verdict is that the wall is passive.
    pub is_passive: bool,
}

/// The constants of a scene with units; `None` for a dimensionless one, which has none.
///
/// # Example
///
/// ```
/// use passivity_scene::{Scene, check::constants};
///
/// let text = r#"
///     [device]
///     viscous = "1 N s/m"
///     [sampling]
///     rate = "1 kHz"
///     [wall]
///     stiffness = "1 N/mm"
/// "#;
/// let constants = constants(&Scene::from_toml("viscous", text).unwrap()).unwrap();
/// assert_eq!(constants.max_stiffness, Some(2000.0)); // 2b/T, Colgate's bound
/// assert_eq!(constants.max_damping, Some(0.5)); // b − KT/2
/// ```
#[must_use]
pub fn constants(scene: &Scene) -> Option<Constants> {
    if scene.motion == Motion::Dimensionless {
        return None;
    }
    let report = check(scene);
    let bounds = scene.bounds();
    let every_speed = report.at_every_speed;
    let max_damping = match bounds.try_map(|_, range| range.try_map(Wide::of)) {
        Some(wide) => damping_limit(scene, &wide, every_speed),
        None => damping_limit(scene, &bounds, every_speed),
    };
    let of = |parameter: Parameter| {
        let given = scene.given.get(parameter)?;
        Some(given.nominal.enclosure(BITS)?.lo().clone())
    };
    let stiffest = report
        .limits
        .iter()
        .find(|l| l.parameter == Parameter::Stiffness);
    let period = of(Parameter::Period)?;
    let bound = match &report.speed_bound_si {
        Some(v) if !every_speed => Some(below(v.lo())),
        _ => None,
    };
    Some(Constants {
        scene: report.scene.clone(),
        headline: report.headline(),
        because: report.because.clone(),
        binds: report.binds_text(),
        motion: scene.motion,
        stiffness: below(&of(Parameter::Stiffness)?),
        max_stiffness: stiffest.and_then(proved),
        damping: of(Parameter::Damping).map_or(0.0, |b| below(&b)),
        max_damping: max_damping.as_ref().and_then(proved),
        rate: nearest_f64(&period.recip()),
        max_speed: bound,
        max_force: of(Parameter::MaxForce).map(|f| below(&f)),
        is_passive: report.verdict == Verdict::Passive,
    })
}

/// The limit of the virtual damping, also where the scene has none yet.
fn damping_limit<S: Enclosed>(
    scene: &Scene,
    bounds: &Loop<Interval<S>>,
    every_speed: bool,
) -> Option<Limit> {
    if bounds.controller.is_some() {
        return None;
    }
    let mut bounds = bounds.clone();
    if bounds.damping.is_none() {
        // From where it is looked for: as much as a sample of the spring.
        bounds.damping = Some(Interval::point(bounds.at(End::Hardest).viscous_unit()));
    }
    let speeds = if every_speed {
        Speeds::All
    } else {
        bounds.speeds()
    };
    limits::limit(Parameter::Damping, scene, &bounds, &speeds)
}

/// The shortest double of at least five digits at or below a limit that passed when it was typed back.
fn proved(limit: &Limit) -> Option<f64> {
    limit.printed.as_ref()?;
    let border = limit.border.lo();
    let short = (5..17).find_map(|digits| {
        let text = rounded(border, digits, Rounding::Down);
        let double = nearest_f64(&crate::number::parse(&text).ok()?);
        (below(border) >= double).then_some(double)
    });
    Some(short.unwrap_or_else(|| below(border)))
}

/// The largest double that is not above a number.
fn below(x: &BigRational) -> f64 {
    let near = nearest_f64(x);
    match BigRational::from_float(near) {
        Some(exact) if exact > *x => near.next_down(),
        _ => near,
    }
}

impl Constants {
    /// The constants as the source text of a program.
    #[must_use]
    pub fn to_source(&self, target: Target) -> String {
        let mut lines = self.comment();
        match target {
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
                // A name cannot end the comment.
                let _ = writeln!(out, " * {}", line.trim_start().replace("*/", "* /"));
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
        say("Every number is a double on the safe side: a largest value is rounded down.");
        out.push_str(" */\n");
        out
    }

    fn unit(&self, parameter: Parameter) -> &'static str {
        unit_of(parameter, self.motion)
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
            stiffness,
            "no wall is passive",
        );
        define("DAMPING", Some(self.damping), damping, "");
        define("MAX_DAMPING", self.max_damping, damping, "none is passive");
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
        let mut set = |field: String, value: Option<f64>| {
            let _ = match value {
                Some(value) => writeln!(out, "info.{field} = {value:?};"),
                None => writeln!(out, "info.{field} = 0.0; /* none is passive */"),
            };
        };
        set(format!("m_max{kind}Stiffness"), self.max_stiffness);
        set(format!("m_max{kind}Damping"), self.max_damping);
        if self.max_force.is_some() {
            set(format!("m_max{kind}{force}"), self.max_force);
        }
        let _ = writeln!(
            out,
            "/* The haptic thread must run at {:?} Hz. */",
            self.rate
        );
        self.speed_comment(out);
    }

    fn as_open_haptics(&self, out: &mut String) {
        // Newtons and millimetres; dividing by 1000 may round up by half a unit in the last place.
        let ([unit, damping_unit], factor) = match self.motion {
            Motion::Rotary => (["N m/rad", "N m s/rad"], 1.0),
            _ => (["N/mm", "N s/mm"], 1000.0),
        };
        let scaled = |value: f64| {
            let quotient = value / factor;
            if factor == 1.0 {
                quotient
            } else {
                quotient.next_down()
            }
        };
        let rate = self.rate.round();
        let _ = writeln!(
            out,
            "hdSetSchedulerRate({rate:.0}); /* Hz; the proof is for {:?} Hz */",
            self.rate
        );
        let _ = match self.max_stiffness {
            Some(k) => writeln!(
                out,
                "static const HDdouble kMaxStiffness = {:?}; /* {unit} */\n\
                 /* HL_STIFFNESS takes a part of the device's nominal largest stiffness: */\n\
                 HDdouble nominal;\n\
                 hdGetDoublev(HD_NOMINAL_MAX_STIFFNESS, &nominal); /* N/mm */\n\
                 hlMaterialf(HL_FRONT_AND_BACK, HL_STIFFNESS, kMaxStiffness < nominal ? kMaxStiffness / \
                 nominal : 1.0);",
                scaled(k)
            ),
            None => writeln!(out, "/* No wall is passive. */"),
        };
        let _ = match self.max_damping {
            Some(b) => writeln!(
                out,
                "static const HDdouble kMaxDamping = {:?}; /* {damping_unit} */",
                scaled(b)
            ),
            None => writeln!(out, "/* No virtual damping is passive. */"),
        };
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

/// The name as a C identifier in capitals.
fn identifier(name: &str) -> String {
    let letters = name.chars().map(|c| match c {
        c if c.is_ascii_alphanumeric() => c.to_ascii_uppercase(),
        _ => '_',
    });
    let name: String = letters.take(60).collect();
    match name.chars().next() {
        Some(c) if c.is_ascii_digit() => format!("WALL_{name}"),
        _ => name,
    }
}
