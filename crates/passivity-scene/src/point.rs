//! The dimensionless point of a scene (3), (7): what motion and ledger work with.

use passivity_core::{BigRational, Effect, Exact, Loop, Parameter, Scalar};

use crate::scene::{Motion, Scene};

/// A scene in ticks, sampling periods and KΔ, at the nominal value of every parameter.
///
/// Without an encoder the unit of length is 1 in SI units. A value with a π in it that does not
/// cancel is rational to more digits than a double has.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The dimensionless loop.
    pub at: Loop<BigRational>,
    /// The operator's force in KΔ, one per sampling interval: the last value stays.
    pub forces: Option<Vec<BigRational>>,
    /// How many sampling intervals a simulation runs.
    pub intervals: u64,
    /// T, Δ and K in SI units, to show figures in the scene's units.
    pub units: Units,
}

/// The units that a dimensionless figure is to be multiplied with, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Units {
    /// T in seconds.
    pub period: BigRational,
    /// Δ in metres or radians.
    pub length: BigRational,
    /// K in N/m or N·m/rad.
    pub stiffness: BigRational,
    /// The unit of `length`: `m` or `rad`, `None` in a dimensionless scene.
    pub length_unit: Option<&'static str>,
}

/// Bits of a value whose π does not cancel: past those of a double by far.
const BITS: u32 = 200;

/// A number as a rational: itself, or near the middle of an enclosure where it has π in it.
///
/// # Panics
///
/// Never for a number of a scene: an undefined one is refused when the scene is read.
fn rational(x: &Exact) -> BigRational {
    match x.enclosure(BITS) {
        Some(bounds) => bounds.middle(),
        None => unreachable!("a scene's numbers are defined: its units are above zero"),
    }
}

impl Point {
    /// ξ(0) and ξ̇(0), in ticks and ticks per sample; zero when the scene does not say.
    #[must_use]
    pub fn start(&self) -> [BigRational; 2] {
        let or_zero = |x: &Option<BigRational>| x.clone().unwrap_or_else(BigRational::zero);
        [
            or_zero(&self.at.start_position),
            or_zero(&self.at.start_velocity),
        ]
    }

    /// The same scene with one parameter at another value, in SI units (in K, T and Δ for a dimensionless
    /// scene); what the costs of its effects are is not computed anew.
    #[must_use]
    pub fn with(&self, parameter: Parameter, si: &BigRational) -> Self {
        let old = self.in_si();
        let old_force = old.force_unit();
        let new = old.with(parameter, si.clone());
        let force_unit = new.force_unit();
        let forces = self.forces.as_ref().map(|forces| {
            let forces = forces.iter().map(|f| f * &old_force / &force_unit);
            forces.collect()
        });
        let varied = (parameter == Parameter::OperatorForce).then(|| vec![si / &force_unit]);
        Self {
            forces: varied.or(forces),
            intervals: self.intervals,
            units: Units {
                period: new.period.clone(),
                length: new.length(),
                stiffness: new.stiffness.clone(),
                length_unit: self.units.length_unit,
            },
            at: new.dimensionless(),
        }
    }

    /// The loop in SI units.
    fn in_si(&self) -> Loop<BigRational> {
        let units = &self.units;
        let measure = Loop {
            resolution: Some(units.length.clone()),
            ..Loop::new(units.stiffness.clone(), units.period.clone())
        };
        self.at
            .map(|parameter, x| x * measure.unit(parameter.row().unit))
    }

    /// Whether an effect is in the scene.
    #[must_use]
    pub const fn has(&self, effect: Effect) -> bool {
        self.at.has(effect) || matches!((effect, &self.forces), (Effect::Force, Some(_)))
    }
}

impl Scene {
    /// The scene in dimensionless form, at its nominal values.
    #[must_use]
    pub fn point(&self) -> Point {
        let nominal = self.given.map(|_, given| given.nominal.clone());
        let units = Units {
            period: rational(&nominal.period),
            length: rational(&nominal.length()),
            stiffness: rational(&nominal.stiffness),
            length_unit: match self.motion {
                Motion::Linear => Some("m"),
                Motion::Rotary => Some("rad"),
                Motion::Dimensionless => None,
            },
        };
        let force_unit = rational(&nominal.force_unit());
        let at = nominal.dimensionless().map(|_, x| rational(x));
        let constant = at.operator_force.clone().map(|force| vec![force]);
        let samples = self
            .forces
            .as_ref()
            .map(|forces| forces.values.iter().map(|f| f / &force_unit).collect());
        Point {
            at,
            forces: samples.or(constant),
            intervals: self.intervals,
            units,
        }
    }
}
