//! The constants that a control program asks for, on the safe side as doubles.

use num_traits::Signed as _;
use passivity_core::verdict::{End, Speeds};
use passivity_core::{BigRational, Enclosed, Exact, Interval, Loop, Parameter, Wide};
use schemars::JsonSchema;
use serde::Serialize;

use super::limits;
use super::{BITS, Report, Verdict, check};
use crate::display::{Rounding, rounded};
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

mod text;
