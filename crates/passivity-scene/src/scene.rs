//! What a scene is: the parameters of a device, its loop and a wall, each with where it was said.

use std::ops::Range;

use num_traits::Zero;
use passivity_core::{BigRational, Effect, Exact, Interval, Loop, Parameter, Scalar};

use crate::check::enclosure;
use crate::written::Written;

/// How the device moves, which fixes the units of everything.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Motion {
    /// Along a line: metres, newtons, kilograms.
    Linear,
    /// About an axis: radians, newton-metres, kg·m².
    Rotary,
    /// In ticks, sampling periods and KΔ: K, T and Δ are 1, m is μ, b is β, c is σ (7).
    Dimensionless,
}

/// A parameter as it was given in the scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// The key with its section, as in `device.viscous`.
    pub key: &'static str,
    /// The exact values, tolerance included, in SI units.
    pub value: Interval<Exact>,
    /// The value without its tolerance.
    pub nominal: Exact,
    /// The text of the value in the file, as in `9e-6 N m s/rad ± 10%`; empty for a default.
    pub text: String,
    /// The unit in which the file writes the value.
    pub written: Written,
    /// Where the value stands in the file, in bytes.
    pub span: Range<usize>,
    /// How the text was taken, where a reader could have taken it otherwise.
    pub remark: Option<String>,
    /// The parts at the device and at the motor, where the value is their sum.
    pub parts: Option<Box<[Self; 2]>>,
}

/// A rigid transmission between the motor and the part that the hand holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Transmission {
    /// The keys and texts that gave it.
    pub given: Vec<(&'static str, String)>,
    /// n > 0: radians of the motor for a radian, or a metre, of the device.
    pub ratio: Exact,
}

impl Given {
    /// The value 1 that K, T or Δ has in a dimensionless scene, where no file says it.
    #[must_use]
    pub fn unit(parameter: Parameter) -> Self {
        Self {
            key: parameter.row().key,
            value: Interval::point(Exact::one()),
            nominal: Exact::one(),
            text: String::new(),
            written: Written::si(""),
            span: 0..0,
            remark: None,
            parts: None,
        }
    }

    /// The sum of a value at the device and one at the motor: of the inertia.
    pub(crate) fn and(self, other: Self) -> Self {
        let parts = Some(Box::new([self.clone(), other.clone()]));
        Self {
            parts,
            value: Interval::hull(
                self.value.lo().clone() + other.value.lo().clone(),
                self.value.hi().clone() + other.value.hi().clone(),
            ),
            nominal: self.nominal + other.nominal,
            text: format!("{} and {} at the motor", self.text, other.text),
            remark: self.remark.or(other.remark),
            ..self
        }
    }

    /// What of the value is given at the motor's side of a transmission, or at the device's.
    pub(crate) fn part(&self, at_motor: bool) -> Option<&Self> {
        match self.parts.as_deref() {
            Some([device, motor]) => Some(if at_motor { motor } else { device }),
            None => (self.written.is_at_motor() == at_motor).then_some(self),
        }
    }

    /// Whether the value has a tolerance.
    #[must_use]
    pub fn has_tolerance(&self) -> bool {
        !self.value.is_point()
    }

    /// Whether the file gives a bound on one side only, which then is the nominal value.
    #[must_use]
    pub fn is_bound(&self) -> bool {
        self.has_tolerance() && [self.value.lo(), self.value.hi()].contains(&&self.nominal)
    }

    /// The nominal value as people read it, and what the file says: `0.001 N m s/rad, the bound of < 1e-3 N m s/rad`.
    #[must_use]
    pub fn nominal_text(&self) -> String {
        let value = enclosure(&Interval::point(self.nominal.clone()));
        let value = value.map_or_else(String::new, |value| self.written.text(&value, ""));
        let of = if self.is_bound() {
            "the bound of"
        } else {
            "of"
        };
        format!("{}, {of} {}", value.trim_end(), self.text)
    }

    /// Whether the value is zero, without a tolerance.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.value.is_point() && self.nominal == Exact::zero()
    }
}

/// Forces of the operator from a file: one per sampling interval, held over it; the last one stays.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceSamples {
    /// The file they came from, as the scene names it.
    pub path: String,
    /// The forces in SI units (KΔ in a dimensionless scene); at least one.
    pub values: Vec<BigRational>,
}

/// A device, its control loop, a virtual wall, and what is done with them.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The file's name without folder and extension, or what `name` in it says.
    pub name: String,
    /// How the device moves.
    pub motion: Motion,
    /// The loop, as it was given.
    pub given: Loop<Given>,
    /// What stands between the motor and the device, where the file says it.
    pub transmission: Option<Transmission>,
    /// The operator's force, where a file of samples gives it.
    pub forces: Option<ForceSamples>,
    /// How many sampling intervals a simulation runs.
    pub intervals: u64,
}

/// How many sampling intervals a simulation runs when the scene does not say: the paper's number.
pub const DEFAULT_INTERVALS: u64 = 50_000;

impl Scene {
    /// The effects in the scene, in the order in which they are listed everywhere.
    #[must_use]
    pub fn effects(&self) -> Vec<Effect> {
        let all = Effect::ALL.into_iter();
        all.filter(|effect| self.has(*effect)).collect()
    }

    /// Whether an effect is in the scene.
    #[must_use]
    pub fn has(&self, effect: Effect) -> bool {
        self.given.has(effect) || (effect == Effect::Force && self.forces.is_some())
    }

    /// The effects that no theorem covers in this scene.
    #[must_use]
    pub fn not_covered(&self) -> Vec<Effect> {
        let mut effects = self.effects();
        effects.retain(|effect| effect.theorem().is_none());
        effects
    }

    /// The effects with which a log of the scene is not accounted for: those that make the force change
    /// within an interval, and, where the log does not have the forces, those that keep in memory what
    /// was before the log.
    #[must_use]
    pub fn unaccounted(&self, has_forces: bool) -> Vec<Effect> {
        let mut effects = self.effects();
        effects.retain(|effect| match effect {
            Effect::Latency | Effect::Amplifier => true,
            Effect::DampingFilter | Effect::Controller => !has_forces,
            _ => false,
        });
        effects
    }

    /// Whether the scene says where the motion starts.
    #[must_use]
    pub const fn has_start(&self) -> bool {
        self.given.start_position.is_some() || self.given.start_velocity.is_some()
    }

    /// Whether nothing but the wall acts on the device, so that TH-START can apply.
    #[must_use]
    pub fn is_unforced(&self) -> bool {
        let no_force = self
            .given
            .operator_force
            .as_ref()
            .is_none_or(Given::is_zero);
        let samples = self.forces.iter().flat_map(|samples| &samples.values);
        no_force && samples.into_iter().all(Zero::is_zero) && !self.has(Effect::Arm)
    }

    /// The values that each parameter may have, in SI units: the box that verdicts are made of.
    #[must_use]
    pub fn bounds(&self) -> Loop<Interval<Exact>> {
        self.given.map(|_, given| given.value.clone())
    }

    /// The parameters with a tolerance that a motion depends on, which is of the device at their nominal values.
    pub fn nominal(&self) -> impl Iterator<Item = (Parameter, &Given)> {
        let given = self.parameters().into_iter();
        let moving = given.filter(|(parameter, _)| *parameter != Parameter::MaxSpeed);
        moving.filter(|(_, given)| given.has_tolerance())
    }

    /// How values of the file were taken, where a reader could have taken them otherwise.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        let transmission = self.transmission.as_ref().map(Transmission::remark);
        let of_values = self.parameters().into_iter();
        let of_values = of_values.filter_map(|(_, given)| given.remark.clone());
        transmission.into_iter().chain(of_values).collect()
    }

    /// The parameters that a person gave, in the order of the file.
    #[must_use]
    pub fn parameters(&self) -> Vec<(Parameter, &Given)> {
        let given = self.given.given();
        let mut given: Vec<_> = given.filter(|(_, given)| !given.text.is_empty()).collect();
        given.sort_by_key(|(_, given)| given.span.start);
        given
    }
}
