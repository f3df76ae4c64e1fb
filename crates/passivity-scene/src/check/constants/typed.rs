//! The doubles that are written, as if they were typed into the scene together.

use std::sync::Arc;

use num_traits::{One as _, Signed as _};
use passivity_core::transfer::TransferFunction;
use passivity_core::verdict::{End, Speeds};
use passivity_core::{BigRational, Enclosed, Exact, Interval, Loop, Parameter};

use super::{Target, above, below};
use crate::check::{BITS, Limit, Side, limits};
use crate::display::rounded;
use crate::number::nearest_f64;
use crate::scene::Scene;

/// What is written of a scene, beside its largest values.
const WRITTEN: [Parameter; 9] = [
    Parameter::Period,
    Parameter::Damping,
    Parameter::DampingTimeConstant,
    Parameter::Stiffness,
    Parameter::Resolution,
    Parameter::MaxForce,
    Parameter::ForceStep,
    Parameter::Latency,
    Parameter::TimeConstant,
];

/// A scene with the doubles that are written in place of its values.
#[derive(Clone)]
pub(super) struct Typed<'a, S> {
    pub(super) scene: &'a Scene,
    target: Target,
    bounds: Loop<Interval<S>>,
    speeds: Speeds<Interval<S>>,
    /// Exactly the doubles, taken to SI; of the sampling period, the reciprocal of one.
    values: Vec<(Parameter, BigRational)>,
}

impl<'a, S: Enclosed> Typed<'a, S> {
    /// The doubles beside the scene's values, on the side that passes.
    pub(super) fn of(
        scene: &'a Scene,
        target: Target,
        bounds: &Loop<Interval<S>>,
        speeds: Speeds<Interval<S>>,
    ) -> Option<Self> {
        let mut tries = vec![Vec::new()];
        for parameter in WRITTEN {
            let Some(given) = scene.given.get(parameter) else {
                continue;
            };
            let (_, in_units) = target.unit(parameter, scene.motion);
            let nominal = given.nominal.enclosure(BITS)?.map(|x| x * &in_units);
            let choices = doubles_beside(parameter, &nominal)?;
            let choices: Vec<_> = choices.into_iter().map(|x| x / &in_units).collect();
            let with_each = |values: Vec<(Parameter, BigRational)>| {
                let each = choices.clone().into_iter();
                each.map(move |value| [values.as_slice(), &[(parameter, value)]].concat())
                    .collect::<Vec<_>>()
            };
            tries = tries.into_iter().flat_map(with_each).collect();
        }
        let typed = |controller, values| Self {
            scene,
            target,
            bounds: Loop {
                controller,
                ..bounds.clone()
            },
            speeds: speeds.clone(),
            values,
        };
        // The scene's own coefficients are left where those that are doubles do not pass.
        let own = bounds.controller.clone();
        let of_doubles = own.as_deref().and_then(of_doubles).map(Arc::new);
        let mut controllers = vec![of_doubles, own];
        controllers.dedup();
        controllers.retain(|c| c.is_some() || bounds.controller.is_none());
        let mut all = controllers.into_iter().flat_map(|controller| {
            let each = tries.iter();
            each.map(|values| typed(controller.clone(), values.clone()))
                .collect::<Vec<_>>()
        });
        let first = all.next()?;
        match first.holds() {
            true => Some(first),
            false => Some(all.find(Self::holds).unwrap_or(first)),
        }
    }

    fn value(&self, parameter: Parameter) -> Option<&BigRational> {
        let mut values = self.values.iter();
        values.find_map(|(written, value)| (*written == parameter).then_some(value))
    }

    /// The unit in which a parameter is written, and how many of it one is in SI.
    pub(super) fn unit(&self, parameter: Parameter) -> (&'static str, BigRational) {
        self.target.unit(parameter, self.scene.motion)
    }

    /// The double that is written of a parameter; `None` where the scene does not have it.
    pub(super) fn double(&self, parameter: Parameter) -> Option<f64> {
        let (_, in_units) = self.unit(parameter);
        self.value(parameter).map(|x| nearest_f64(&(x * in_units)))
    }

    /// The sampling rate, Hz.
    pub(super) fn rate(&self) -> Option<f64> {
        Some(nearest_f64(&self.value(Parameter::Period)?.recip()))
    }

    /// The controller, of doubles where that passes.
    pub(super) fn controller(&self) -> Option<&TransferFunction<BigRational>> {
        self.bounds.controller.as_deref()
    }

    /// The same with another value of one parameter.
    fn with(&self, parameter: Parameter, value: BigRational) -> Self {
        let mut other = self.clone();
        other.values.retain(|(written, _)| *written != parameter);
        other.values.push((parameter, value));
        other
    }

    /// The loop with these values, each with the tolerance that it has in the scene.
    fn bounds(&self) -> Option<Loop<Interval<S>>> {
        let mut values = self.values.iter();
        values.try_fold(self.bounds.clone(), |bounds, (parameter, value)| {
            Some(bounds.with(*parameter, self.with_tolerance(*parameter, value)?))
        })
    }

    /// A value of a parameter with the tolerance that the scene gives it, in the same ratio to it.
    fn with_tolerance(&self, parameter: Parameter, value: &BigRational) -> Option<Interval<S>> {
        let value = S::of(&Exact::of(value))?;
        let (Some(given), Some(range)) =
            (self.scene.given.get(parameter), self.bounds.get(parameter))
        else {
            return Some(Interval::point(value));
        };
        let nominal = S::of(&given.nominal)?;
        if !nominal.is_positive()? {
            return Some(Interval::point(value));
        }
        let scale = value.over(nominal);
        Some(range.map(|end| end.clone() * scale.clone()))
    }

    /// The end of a parameter's tolerance on one side, as a part of the value without it.
    fn tolerance(&self, parameter: Parameter, side: Side) -> Option<BigRational> {
        let Some(given) = self.scene.given.get(parameter) else {
            return Some(BigRational::one());
        };
        let nominal = given.nominal.enclosure(BITS)?;
        let part = match side {
            _ if given.value.is_point() => BigRational::one(),
            Side::AtLeast => given.value.lo().enclosure(BITS)?.lo() / nominal.hi(),
            Side::AtMost => given.value.hi().enclosure(BITS)?.hi() / nominal.lo(),
        };
        part.is_positive().then_some(part)
    }

    fn holds(&self) -> bool {
        let bounds = self.bounds();
        bounds.is_some_and(|bounds| bounds.surely_holds(&self.speeds))
    }

    /// Whether the criterion holds with another double of one parameter, over its tolerance.
    fn holds_with(&self, parameter: Parameter, value: f64) -> bool {
        let moved = || {
            let (_, in_units) = self.unit(parameter);
            let value = BigRational::from_float(value)? / in_units;
            let moved = self.with_tolerance(parameter, &value)?;
            Some(self.bounds()?.with(parameter, moved))
        };
        moved().is_some_and(|bounds| bounds.surely_holds(&self.speeds))
    }

    /// The limit of a parameter beside the other values; also of damping where the scene has none yet.
    fn limit(&self, parameter: Parameter) -> Option<Limit> {
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
        limits::limit(parameter, self.scene, &bounds, &self.speeds)
    }

    /// The shortest double of at least five digits at an end of a limit, on its safe side, that passes
    /// over the parameter's tolerance.
    fn at_end(&self, limit: &Limit, side: Side) -> Option<f64> {
        let (_, in_units) = self.unit(limit.parameter);
        let tolerance = &self.tolerance(limit.parameter, side)?;
        let border = &(side.hardest(limit.end(side)?) * in_units / tolerance);
        let (beside, is_safe): (_, fn(&f64, &f64) -> bool) = match side {
            Side::AtLeast => (above(border), f64::ge),
            Side::AtMost => (below(border), f64::le),
        };
        let short = (5..17).filter_map(|digits| {
            let text = rounded(border, digits, side.rounding());
            let double = nearest_f64(&crate::number::parse(&text).ok()?);
            is_safe(&double, &beside).then_some(double)
        });
        // Over a tolerance less may be shown than at each of its values.
        let own = self.double(limit.parameter);
        let is_known = beside.is_finite() && !tolerance.is_one();
        let own = own.filter(|own| is_known && is_safe(own, &beside));
        let mut doubles = short.chain([beside]).chain(own);
        doubles.find(|double| self.holds_with(limit.parameter, *double))
    }

    /// These values with the largest stiffness and the ends of the damping beside them.
    pub(super) fn with_largest(&self, is_passive: bool) -> Written<'a, S> {
        let largest = |limit: &Limit| self.at_end(limit, Side::AtMost);
        let damping = self.limit(Parameter::Damping);
        let is_needed = |limit: &&Limit| limit.end(Side::AtLeast).is_some();
        let needed = damping.as_ref().filter(is_needed);
        let min_damping = needed.and_then(|limit| self.at_end(limit, Side::AtLeast));
        let max_damping = damping.as_ref().and_then(largest);
        Written {
            max_stiffness: self.limit(Parameter::Stiffness).as_ref().and_then(largest),
            max_damping: max_damping.filter(|_| needed.is_none() || min_damping.is_some()),
            min_damping,
            typed: self.clone(),
            is_passive,
        }
    }
}

/// All numbers that are written.
#[derive(Clone)]
pub(super) struct Written<'a, S> {
    pub(super) typed: Typed<'a, S>,
    pub(super) max_stiffness: Option<f64>,
    pub(super) max_damping: Option<f64>,
    pub(super) min_damping: Option<f64>,
    is_passive: bool,
}

impl<S: Enclosed> Written<'_, S> {
    /// Whether what is written to hold does: the scene's own values where its wall is passive, and
    /// each largest value beside them.
    pub(super) fn passes(&self) -> bool {
        let largest = [
            (Parameter::Stiffness, self.max_stiffness),
            (Parameter::Damping, self.max_damping),
            (Parameter::Damping, self.min_damping),
        ];
        let mut largest = largest.into_iter();
        (!self.is_passive || self.typed.holds())
            && largest.all(|(parameter, most)| {
                most.is_none_or(|most| self.typed.holds_with(parameter, most))
            })
    }

    fn with(&self, parameter: Parameter, value: BigRational) -> Self {
        Self {
            typed: self.typed.with(parameter, value),
            ..self.clone()
        }
    }

    /// The same at another sampling rate.
    pub(super) fn at_rate(&self, rate: f64) -> Option<Self> {
        let rate = BigRational::from_float(rate)?;
        let period = rate.is_positive().then(|| rate.recip())?;
        Some(self.with(Parameter::Period, period))
    }

    /// The same with the time constant of which the pole a of the damping's filter is this double:
    /// τ = aT/(1 − a).
    pub(super) fn with_pole(&self, pole: f64) -> Option<Self> {
        let pole = BigRational::from_float(pole)?;
        let rest = BigRational::one() - &pole;
        let period = self.typed.value(Parameter::Period)?;
        let tau = rest.is_positive().then(|| period * pole / rest)?;
        Some(self.with(Parameter::DampingTimeConstant, tau))
    }

    /// The pole a = τ/(T + τ) of the damping's filter, as the double beside it that passes.
    pub(super) fn pole(&self) -> Option<f64> {
        let tau = self.typed.value(Parameter::DampingTimeConstant)?;
        let pole = tau / (self.typed.value(Parameter::Period)? + tau);
        let passes = |pole: &f64| self.with_pole(*pole).is_some_and(|at| at.passes());
        [above(&pole), below(&pole)].into_iter().find(passes)
    }

    /// Whether all of it passes behind a force law that is not linear: a wall on one side, or a force
    /// that is limited.
    pub(super) fn passes_any_law(&self) -> bool {
        let mut other = self.clone();
        other.typed.bounds = other
            .typed
            .bounds
            .reshaped(|bounds| bounds.unilateral = true);
        other.passes()
    }
}

/// The doubles beside a value, the one on the safe side first; of the sampling period, those beside
/// its rate.
fn doubles_beside(parameter: Parameter, range: &Interval<BigRational>) -> Option<Vec<BigRational>> {
    let exact = |doubles: &[f64]| {
        let exact = doubles.iter().map(|x| BigRational::from_float(*x));
        exact.collect::<Option<Vec<_>>>()
    };
    // More samples, less damping and a slower filter are safe, but where the damping reads an encoder,
    // or is late, the other neighbour may be.
    let mut doubles = match parameter {
        Parameter::Period => {
            let rates = exact(&[above(&range.lo().recip()), below(&range.hi().recip())])?;
            let rates = rates.into_iter();
            let periods = rates.map(|rate| rate.is_positive().then(|| rate.recip()));
            periods.collect::<Option<Vec<_>>>()
        }
        Parameter::Damping => exact(&[below(range.lo()), above(range.hi())]),
        Parameter::DampingTimeConstant => exact(&[above(range.hi()), below(range.lo())]),
        _ => exact(&[below(range.lo())]),
    }?;
    doubles.dedup();
    Some(doubles)
}

/// The controller with the nearest double in place of each coefficient, where that is a controller.
fn of_doubles(controller: &TransferFunction<BigRational>) -> Option<TransferFunction<BigRational>> {
    let nearest = |coefficients: &[BigRational]| {
        let doubles = coefficients.iter().map(nearest_f64);
        doubles
            .map(BigRational::from_float)
            .collect::<Option<Vec<_>>>()
    };
    let [numerator, denominator] = [controller.numerator(), controller.denominator()].map(nearest);
    TransferFunction::new(numerator?, denominator?).ok()
}
