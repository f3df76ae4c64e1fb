//! The constants that a control program asks for, on the safe side as doubles.

use passivity_core::verdict::Speeds;
use passivity_core::{BigRational, Enclosed, Interval, Loop, Parameter, Wide};
use schemars::JsonSchema;
use serde::Serialize;

pub use self::conditions::{Amount, Condition};
use self::typed::Typed;
use super::text::unit_of;
use super::{Report, Verdict, check};
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

impl Target {
    /// The unit in which a parameter is written, and how many of it one is in SI.
    fn unit(self, parameter: Parameter, motion: Motion) -> (&'static str, BigRational) {
        let thousand = || BigRational::from_integer(1000.into());
        match (self, motion, parameter) {
            (Self::OpenHaptics, Motion::Linear, Parameter::Stiffness) => {
                ("N/mm", thousand().recip())
            }
            (Self::OpenHaptics, Motion::Linear, Parameter::Damping) => {
                ("N s/mm", thousand().recip())
            }
            (Self::OpenHaptics, Motion::Linear, Parameter::Resolution) => ("mm", thousand()),
            _ => (
                unit_of(parameter, motion),
                BigRational::from_integer(1.into()),
            ),
        }
    }
}

/// The constants of a scene: each number is a double on the safe side of what was proved, in the units of the program.
///
/// Where the scene gives a parameter a tolerance, each number of it holds with that tolerance, in the
/// same ratio to the number.
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
    /// The effects in the scene, in words.
    pub effects: Vec<&'static str>,
    /// The values of the scene that the numbers rest on, as it writes them, and what its transmission does.
    pub given: Vec<String>,
    /// The effects, in words, with which nothing is shown, because the scene does not have them.
    pub not_shown_with: Vec<&'static str>,
    /// What the control program, the device and its amplifier must be like for the numbers to hold.
    pub conditions: Vec<Condition>,
    /// The program that they are written for.
    #[serde(skip)]
    pub target: Target,
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
    /// The smallest virtual damping beside `stiffness`: less, or none, does not pass or is not shown
    /// to. `None` where all up to `max_damping` pass.
    pub min_damping: Option<f64>,
    /// Whether the scene's stiffness or damping has a tolerance.
    #[serde(skip)]
    pub has_tolerance: bool,
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
/// use passivity_scene::{Scene, check::{Target, constants}};
///
/// let text = r#"
///     [device]
///     viscous = "1 N s/m"
///     [sampling]
///     rate = "1 kHz"
///     [wall]
///     stiffness = "1 N/mm"
/// "#;
/// let constants = constants(&Scene::from_toml("viscous", text).unwrap(), Target::C).unwrap();
/// assert_eq!(constants.max_stiffness, Some(2000.0)); // 2b/T, Colgate's bound
/// assert_eq!(constants.max_damping, Some(0.5)); // b − KT/2
/// ```
#[must_use]
pub fn constants(scene: &Scene, target: Target) -> Option<Constants> {
    if scene.motion == Motion::Dimensionless {
        return None;
    }
    let report = check(scene);
    let bounds = scene.bounds();
    match bounds.try_map(|_, range| range.try_map(Wide::of)) {
        Some(wide) => of_loop(scene, target, &report, &wide),
        None => of_loop(scene, target, &report, &bounds),
    }
}

fn of_loop<S: Enclosed>(
    scene: &Scene,
    target: Target,
    report: &Report,
    bounds: &Loop<Interval<S>>,
) -> Option<Constants> {
    let speeds = match report.at_every_speed {
        true => Speeds::All,
        false => bounds.speeds(),
    };
    let is_passive = report.verdict == Verdict::Passive;
    let typed = Typed::of(scene, target, bounds, speeds)?;
    let written = typed.with_largest(is_passive);
    let pole = written.pole();
    let whole_rate = [typed.rate()?.ceil(), typed.rate()?.floor()]
        .into_iter()
        .find(|rate| {
            let at = written.at_rate(*rate);
            let pass = |pole| at.as_ref()?.with_pole(pole);
            at.as_ref().is_some_and(|at| at.passes())
                && pole.is_none_or(|pole| pass(pole).is_some_and(|at| at.passes()))
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
        effects: scene
            .effects()
            .iter()
            .map(|effect| effect.words())
            .collect(),
        given: conditions::given(scene),
        not_shown_with: conditions::not_shown_with(&written),
        conditions: conditions::of(&typed, pole),
        target,
        motion: scene.motion,
        stiffness: typed.double(Parameter::Stiffness)?,
        max_stiffness: written.max_stiffness,
        damping: typed.double(Parameter::Damping).unwrap_or(0.0),
        max_damping: written.max_damping,
        min_damping: written.min_damping,
        has_tolerance: [Parameter::Stiffness, Parameter::Damping]
            .iter()
            .filter_map(|parameter| scene.given.get(*parameter))
            .any(|given| !given.value.is_point()),
        has_controller: bounds.controller.is_some(),
        rate: typed.rate()?,
        whole_rate,
        max_speed: bound,
        max_force: typed.double(Parameter::MaxForce),
        is_passive,
    })
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

mod conditions;
mod text;
mod typed;
