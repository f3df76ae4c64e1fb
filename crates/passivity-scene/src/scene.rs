//! What a scene is: the parameters of a device, its loop and a wall, each with where it was said.

use std::ops::Range;

use num_traits::Zero;
use passivity_core::{BigRational, Interval, Scalar};

use crate::effect::Effect;
use crate::exact::Exact;

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
    pub value: Exact,
    /// The value without its tolerance.
    pub nominal: Exact,
    /// The text of the value in the file, as in `9e-6 N m s/rad ± 10%`.
    pub text: String,
    /// Where the value stands in the file, in bytes.
    pub span: Range<usize>,
}

impl Given {
    /// Whether the value has a tolerance.
    #[must_use]
    pub fn has_tolerance(&self) -> bool {
        !self.value.range().is_point()
    }
}

/// A force of the operator.
#[derive(Clone, Debug, PartialEq)]
pub enum Force {
    /// The same force all the time.
    Constant(Box<Given>),
    /// One force per sampling interval, held over it; the last one stays.
    Samples {
        /// The file they came from, as the scene names it.
        path: String,
        /// The forces in SI units (KΔ in a dimensionless scene).
        values: Vec<BigRational>,
    },
}

/// The arm that holds the device: a mass on a spring and a damper fixed at the origin.
///
/// Its mass moves with the device.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// Mass or inertia.
    pub mass: Given,
    /// Viscous damping.
    pub damping: Given,
    /// Stiffness.
    pub stiffness: Given,
}

/// Where an unforced motion starts.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// Position at the first sampling instant; 0 when the file does not say.
    pub position: Given,
    /// Velocity at the first sampling instant; 0 when the file does not say.
    pub velocity: Given,
}

/// A device, its control loop, a virtual wall, and what is done with them.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The file's name without folder and extension, or what `name` in it says.
    pub name: String,
    /// How the device moves.
    pub motion: Motion,
    /// m, needed to simulate and for TH-START.
    pub inertia: Option<Given>,
    /// b.
    pub viscous: Option<Given>,
    /// c.
    pub coulomb: Option<Given>,
    /// T.
    pub period: Given,
    /// Whole samples by which the force is late.
    pub delay: Option<u16>,
    /// Δ; absent when the position is not quantized.
    pub resolution: Option<Given>,
    /// K.
    pub stiffness: Given,
    /// Whether the wall is x ≥ 0 only.
    pub unilateral: bool,
    /// B, virtual damping by backward difference.
    pub damping: Option<Given>,
    /// Saturation of the actuator.
    pub max_force: Option<Given>,
    /// Resolution of the D/A converter.
    pub force_step: Option<Given>,
    /// Time constant of the amplifier.
    pub amplifier: Option<Given>,
    /// A bound on the operator's speed that the verdict may use.
    pub max_speed: Option<Given>,
    /// The operator's force.
    pub force: Option<Force>,
    /// The operator's arm.
    pub arm: Option<Arm>,
    /// Where the motion starts.
    pub start: Option<Start>,
    /// How many sampling intervals a simulation runs.
    pub intervals: u64,
}

/// How many sampling intervals a simulation runs when the scene does not say: the paper's number.
pub const DEFAULT_INTERVALS: u64 = 50_000;

impl Scene {
    /// The effects in the scene, in the order in which they are listed everywhere.
    #[must_use]
    pub fn effects(&self) -> Vec<Effect> {
        Effect::ALL
            .into_iter()
            .filter(|effect| self.has(*effect))
            .collect()
    }

    /// Whether an effect is in the scene.
    #[must_use]
    pub fn has(&self, effect: Effect) -> bool {
        match effect {
            Effect::Hold => true,
            Effect::Viscous => self.viscous.is_some(),
            Effect::Coulomb => self.coulomb.is_some(),
            Effect::Encoder => self.resolution.is_some(),
            Effect::Delay => self.delay.is_some_and(|k| k > 0),
            Effect::Unilateral => self.unilateral,
            Effect::Damping => self.damping.is_some(),
            Effect::Saturation => self.max_force.is_some(),
            Effect::ForceStep => self.force_step.is_some(),
            Effect::Amplifier => self.amplifier.is_some(),
            Effect::Force => self.force.is_some(),
            Effect::Arm => self.arm.is_some(),
        }
    }

    /// The effects that no theorem covers in this scene.
    ///
    /// Saturation is covered (TH-LAW), but not together with virtual damping.
    #[must_use]
    pub fn not_covered(&self) -> Vec<Effect> {
        let both = self.max_force.is_some() && self.damping.is_some();
        self.effects()
            .into_iter()
            .filter(|effect| match effect {
                Effect::Amplifier | Effect::Arm => true,
                Effect::Saturation | Effect::Damping => both,
                _ => false,
            })
            .collect()
    }

    /// Whether nothing but the wall acts on the device, so that TH-START can apply.
    #[must_use]
    pub fn is_unforced(&self) -> bool {
        let no_force = match &self.force {
            None => true,
            Some(Force::Constant(force)) => {
                force.value.range().is_point() && force.value.range().lo().is_zero()
            }
            Some(Force::Samples { values, .. }) => values.iter().all(Zero::is_zero),
        };
        no_force && self.arm.is_none()
    }

    /// The unit of length: the encoder's resolution or, without an encoder, 1 in SI units.
    #[must_use]
    pub fn unit_length(&self, pi_level: usize) -> Interval<BigRational> {
        match &self.resolution {
            Some(resolution) => resolution.value.enclosure(pi_level),
            None => Interval::point(BigRational::one()),
        }
    }

    /// Whether a figure of the scene involves π, so that a finer enclosure of it can help.
    #[must_use]
    pub fn involves_pi(&self) -> bool {
        self.parameters()
            .iter()
            .any(|given| given.value.pi_power() != 0)
    }

    /// Every parameter that was given, in the order of the struct.
    #[must_use]
    pub fn parameters(&self) -> Vec<&Given> {
        let arm = self
            .arm
            .iter()
            .flat_map(|arm| [&arm.mass, &arm.damping, &arm.stiffness]);
        let start = self
            .start
            .iter()
            .flat_map(|start| [&start.position, &start.velocity]);
        let force = self.force.iter().filter_map(|force| match force {
            Force::Constant(given) => Some(&**given),
            Force::Samples { .. } => None,
        });
        [&self.inertia, &self.viscous, &self.coulomb]
            .into_iter()
            .flatten()
            .chain([&self.period])
            .chain(&self.resolution)
            .chain([&self.stiffness])
            .chain(
                [&self.damping, &self.max_force, &self.force_step]
                    .into_iter()
                    .flatten(),
            )
            .chain([&self.amplifier, &self.max_speed].into_iter().flatten())
            .chain(force)
            .chain(arm)
            .chain(start)
            .collect()
    }

    /// The same parameters, to change them.
    pub(crate) fn parameters_mut(&mut self) -> Vec<&mut Given> {
        let arm = self.arm.iter_mut();
        let arm = arm.flat_map(|arm| [&mut arm.mass, &mut arm.damping, &mut arm.stiffness]);
        let start = self.start.iter_mut();
        let start = start.flat_map(|start| [&mut start.position, &mut start.velocity]);
        let force = self.force.iter_mut().filter_map(|force| match force {
            Force::Constant(given) => Some(&mut **given),
            Force::Samples { .. } => None,
        });
        [
            &mut self.inertia,
            &mut self.viscous,
            &mut self.coulomb,
            &mut self.resolution,
        ]
        .into_iter()
        .chain([&mut self.damping, &mut self.max_force, &mut self.force_step])
        .chain([&mut self.amplifier, &mut self.max_speed])
        .flatten()
        .chain([&mut self.period, &mut self.stiffness])
        .chain(force)
        .chain(arm)
        .chain(start)
        .collect()
    }
}
