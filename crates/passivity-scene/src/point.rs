//! The dimensionless point of a scene (3), (7): what verdict, motion and ledger work with.

use passivity_core::verdict::RigBox;
use passivity_core::{BigRational, Friction, Interval, Scalar};

use crate::exact::Exact;
use crate::scene::{Force, Given, Scene};

/// A scene in ticks, sampling periods and KΔ, at the nominal value of every parameter.
///
/// Without an encoder the unit of length is 1 in SI units. A value with π in it is rational to
/// more digits than a double has.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// μ, when the scene has an inertia.
    pub mu: Option<BigRational>,
    /// β, when the scene has viscous friction.
    pub beta: Option<BigRational>,
    /// σ, when the scene has Coulomb friction.
    pub sigma: Option<BigRational>,
    /// Whether an encoder quantizes the position.
    pub encoder: bool,
    /// k, whole samples of delay; 0 without.
    pub delay: u16,
    /// Whether the wall is ξ ≥ 0 only.
    pub unilateral: bool,
    /// B in KT.
    pub damping: Option<BigRational>,
    /// The largest force, in KΔ.
    pub max_force: Option<BigRational>,
    /// δ in KΔ.
    pub force_step: Option<BigRational>,
    /// The amplifier's time constant in sampling periods.
    pub amplifier: Option<BigRational>,
    /// The operator's force, in KΔ: the last value stays.
    pub force: Option<Vec<BigRational>>,
    /// The operator's arm: mass in KT², damping in KT, stiffness in K.
    pub arm: Option<[BigRational; 3]>,
    /// ξ(0) and ξ̇(0), in ticks and ticks per sample; zero when the scene does not say.
    pub start: [BigRational; 2],
    /// How many sampling intervals a simulation runs.
    pub intervals: u64,
    /// T and Δ in SI units, to show figures in the scene's units.
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
}

impl Point {
    /// β and σ, with 0 for an absent friction.
    #[must_use]
    pub fn friction(&self) -> Friction<BigRational> {
        let or_zero = |x: &Option<BigRational>| x.clone().unwrap_or_else(BigRational::zero);
        Friction::new(or_zero(&self.beta), or_zero(&self.sigma))
    }
}

impl Scene {
    /// The scene as a box of rigs, with π enclosed at `pi_level`: what verdicts are made of.
    #[must_use]
    pub fn rig_box(&self, pi_level: usize) -> RigBox {
        let or_zero = |given: &Option<Given>| match given {
            Some(given) => given.value.enclosure(pi_level),
            None => Interval::point(BigRational::zero()),
        };
        let optional = |given: &Option<Given>| given.as_ref().map(|g| g.value.enclosure(pi_level));
        RigBox {
            viscous: or_zero(&self.viscous),
            coulomb: or_zero(&self.coulomb),
            stiffness: self.stiffness.value.enclosure(pi_level),
            period: self.period.value.enclosure(pi_level),
            length: self.unit_length(pi_level),
            encoder: self.resolution.is_some(),
            delay: self.delay.unwrap_or(0),
            damping: optional(&self.damping),
            force_step: optional(&self.force_step),
        }
    }

    /// The scene in dimensionless form, at its nominal values.
    #[must_use]
    pub fn point(&self) -> Point {
        let nominal = |given: &Given| given.nominal.middle();
        let units = Units {
            period: nominal(&self.period),
            length: self
                .resolution
                .as_ref()
                .map_or_else(BigRational::one, nominal),
            stiffness: nominal(&self.stiffness),
        };
        let viscous_unit = &units.stiffness * &units.period;
        let force_unit = &units.stiffness * &units.length;
        let inertia_unit = &viscous_unit * &units.period;
        let speed_unit = &units.length / &units.period;
        let scaled = |given: &Option<Given>, unit: &BigRational| {
            given.as_ref().map(|given| nominal(given) / unit)
        };
        let force = self.force.as_ref().map(|force| match force {
            Force::Constant(given) => vec![nominal(given) / &force_unit],
            Force::Samples { values, .. } => values.iter().map(|f| f / &force_unit).collect(),
        });
        let start = match &self.start {
            Some(start) => [
                nominal(&start.position) / &units.length,
                nominal(&start.velocity) / &speed_unit,
            ],
            None => [BigRational::zero(), BigRational::zero()],
        };
        Point {
            mu: scaled(&self.inertia, &inertia_unit),
            beta: scaled(&self.viscous, &viscous_unit),
            sigma: scaled(&self.coulomb, &force_unit),
            encoder: self.resolution.is_some(),
            delay: self.delay.unwrap_or(0),
            unilateral: self.unilateral,
            damping: scaled(&self.damping, &viscous_unit),
            max_force: scaled(&self.max_force, &force_unit),
            force_step: scaled(&self.force_step, &force_unit),
            amplifier: scaled(&self.amplifier, &units.period),
            force,
            arm: self.arm.as_ref().map(|arm| {
                [
                    nominal(&arm.mass) / &inertia_unit,
                    nominal(&arm.damping) / &viscous_unit,
                    nominal(&arm.stiffness) / &units.stiffness,
                ]
            }),
            start,
            intervals: self.intervals,
            units,
        }
    }
}

/// The value `x` as a parameter that nobody gave: for defaults.
#[must_use]
pub fn default_given(key: &'static str, x: BigRational) -> Given {
    let value = Exact::point(x);
    Given {
        key,
        nominal: value.clone(),
        value,
        text: String::new(),
        span: 0..0,
    }
}
