//! The constants that a control program asks for, on the safe side as doubles.

use std::fmt::Write as _;

use num_traits::Signed as _;
use passivity_core::verdict::{End, Speeds};
use passivity_core::{BigRational, Enclosed, Exact, Interval, Loop, Parameter, Wide};
use schemars::JsonSchema;
use serde::Serialize;

use super::limits;
use super::text::unit_of;
use super::{BITS, Report, Verdict, check};
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
    /// The largest stiffness that is passive at these speeds beside `damping`; `None` where none is.
    pub max_stiffness: Option<f64>,
    /// The scene's virtual damping, N·s/m or N·m·s/rad.
    pub damping: f64,
    /// The largest virtual damping beside `stiffness`, and not beside `max_stiffness`; `None` where
    /// there is none, or where a digital controller is in its place.
    pub max_damping: Option<f64>,
    /// Whether a digital controller is in the place of virtual damping.
    #[serde(skip)]
    pub has_controller: bool,
    /// The sampling rate in hertz: the double at or above that of the scene, or the one below where
    /// only that is passive.
    pub rate: f64,
    /// The whole number of hertz next to it at which the same holds of every number; `None` where
    /// there is none.
    #[serde(skip)]
    pub whole_rate: Option<f64>,
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
    match bounds.try_map(|_, range| range.try_map(Wide::of)) {
        Some(wide) => of_loop(scene, &report, &wide),
        None => of_loop(scene, &report, &bounds),
    }
}

fn of_loop<S: Enclosed>(
    scene: &Scene,
    report: &Report,
    bounds: &Loop<Interval<S>>,
) -> Option<Constants> {
    let of = |parameter: Parameter| scene.given.get(parameter)?.nominal.enclosure(BITS);
    let lower = |parameter: Parameter| of(parameter).map(|x| below(x.lo()));
    let period = of(Parameter::Period)?;
    let damping = of(Parameter::Damping);
    let typed = Typed {
        scene,
        bounds,
        speeds: match report.at_every_speed {
            true => Speeds::All,
            false => bounds.speeds(),
        },
        stiffness: lower(Parameter::Stiffness)?,
        damping: damping.as_ref().map_or(0.0, |b| below(b.lo())),
        rate: above(&period.lo().recip()),
    };
    // More samples and less damping are safe, but where the damping reads an encoder, or is late, the
    // other neighbour may be.
    let tries = [typed.rate, below(&period.hi().recip())].into_iter();
    let mut tries = tries.flat_map(|rate| {
        let other = damping.as_ref().map_or(0.0, |b| above(b.hi()));
        [typed.damping, other].map(|damping| Typed {
            rate,
            damping,
            ..typed.clone()
        })
    });
    let is_passive = report.verdict == Verdict::Passive;
    let typed = tries.find(Typed::holds).unwrap_or(typed);
    let max_stiffness = typed.largest(Parameter::Stiffness);
    let max_damping = typed.largest(Parameter::Damping);
    let whole_rate = [typed.rate.ceil(), typed.rate.floor()]
        .into_iter()
        .find(|rate| {
            let at = Typed {
                rate: *rate,
                ..typed.clone()
            };
            let passes =
                |parameter, most: Option<f64>| most.is_none_or(|x| at.holds_with(parameter, x));
            (!is_passive || at.holds())
                && passes(Parameter::Stiffness, max_stiffness)
                && passes(Parameter::Damping, max_damping)
        });
    let bound = match &report.speed_bound_si {
        Some(v) if !report.at_every_speed => Some(below(v.lo())),
        _ => None,
    };
    Some(Constants {
        scene: report.scene.clone(),
        headline: report.headline(),
        because: report.because.clone(),
        binds: report.binds_text(),
        motion: scene.motion,
        stiffness: typed.stiffness,
        max_stiffness,
        damping: typed.damping,
        max_damping,
        has_controller: bounds.controller.is_some(),
        rate: typed.rate,
        whole_rate,
        max_speed: bound,
        max_force: lower(Parameter::MaxForce),
        is_passive,
    })
}

/// The doubles that are written, as if they were typed into the scene together.
#[derive(Clone)]
struct Typed<'a, S> {
    scene: &'a Scene,
    bounds: &'a Loop<Interval<S>>,
    speeds: Speeds<Interval<S>>,
    stiffness: f64,
    damping: f64,
    rate: f64,
}

impl<S: Enclosed> Typed<'_, S> {
    /// The loop with these values, each with the tolerance that it has in the scene.
    fn bounds(&self) -> Option<Loop<Interval<S>>> {
        let period = BigRational::from_float(self.rate)?;
        let values = [
            (
                Parameter::Stiffness,
                BigRational::from_float(self.stiffness)?,
            ),
            (Parameter::Damping, BigRational::from_float(self.damping)?),
            (
                Parameter::Period,
                period.is_positive().then(|| period.recip())?,
            ),
        ];
        values
            .into_iter()
            .try_fold(self.bounds.clone(), |bounds, (parameter, value)| {
                let Some(given) = self.scene.given.get(parameter) else {
                    return Some(bounds);
                };
                let nominal = S::of(&given.nominal)?;
                if nominal.is_positive() != Some(true) {
                    return Some(bounds);
                }
                let scale = S::of(&Exact::of(&value))?.over(nominal);
                let moved = bounds
                    .get(parameter)?
                    .map(|end| end.clone() * scale.clone());
                Some(bounds.with(parameter, moved))
            })
    }

    fn holds(&self) -> bool {
        let bounds = self.bounds();
        bounds.is_some_and(|bounds| bounds.surely_holds(&self.speeds))
    }

    /// Whether the criterion holds with another value of one parameter.
    fn holds_with(&self, parameter: Parameter, value: f64) -> bool {
        let moved = || {
            let value = S::of(&Exact::of(&BigRational::from_float(value)?))?;
            Some(self.bounds()?.with(parameter, Interval::point(value)))
        };
        moved().is_some_and(|bounds| bounds.surely_holds(&self.speeds))
    }

    /// The shortest double of at least five digits at or below the limit of a parameter, beside the
    /// other values, that passes; also of damping where the scene has none yet.
    fn largest(&self, parameter: Parameter) -> Option<f64> {
        let mut bounds = self.bounds()?;
        if parameter == Parameter::Damping {
            if bounds.controller.is_some() {
                return None;
            }
            if bounds.damping.is_none() {
                // From where it is looked for: as much as a sample of the spring.
                bounds.damping = Some(Interval::point(bounds.at(End::Hardest).viscous_unit()));
            }
        }
        let limit = limits::limit(parameter, self.scene, &bounds, &self.speeds)?;
        let border = limit.border.lo();
        let most = below(border);
        let short = (5..17).filter_map(|digits| {
            let text = rounded(border, digits, Rounding::Down);
            let double = nearest_f64(&crate::number::parse(&text).ok()?);
            (double <= most).then_some(double)
        });
        let mut doubles = short.chain([most]);
        doubles.find(|double| self.holds_with(parameter, *double))
    }
}

/// The smallest double that is not below a number.
fn above(x: &BigRational) -> f64 {
    -below(&-x)
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
