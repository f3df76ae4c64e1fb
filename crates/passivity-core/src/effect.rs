//! The effects that a loop can have.

/// An effect of the device, the loop, the wall or the operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Effect {
    /// Sampling with a zero-order hold: in every scene.
    Hold,
    /// Viscous friction.
    Viscous,
    /// Coulomb friction.
    Coulomb,
    /// Quantization of the position by an encoder.
    Encoder,
    /// A delay of whole samples.
    Delay,
    /// A latency of any length.
    Latency,
    /// A wall on one side only.
    Unilateral,
    /// Virtual damping by backward difference.
    Damping,
    /// A one-pole filter on the virtual damping.
    DampingFilter,
    /// A digital controller in place of the spring.
    Controller,
    /// Saturation of the actuator.
    Saturation,
    /// Quantization of the force by a D/A converter.
    ForceStep,
    /// First-order lag of the amplifier.
    Amplifier,
    /// A force of the operator.
    Force,
    /// The operator's arm.
    Arm,
}

impl Effect {
    /// Every effect, in the order in which they are listed everywhere.
    pub const ALL: [Self; 15] = [
        Self::Hold,
        Self::Viscous,
        Self::Coulomb,
        Self::Encoder,
        Self::Delay,
        Self::Latency,
        Self::Unilateral,
        Self::Damping,
        Self::DampingFilter,
        Self::Controller,
        Self::Saturation,
        Self::ForceStep,
        Self::Amplifier,
        Self::Force,
        Self::Arm,
    ];

    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Hold => "zero_order_hold",
            Self::Viscous => "viscous",
            Self::Coulomb => "coulomb",
            Self::Encoder => "encoder",
            Self::Delay => "delay",
            Self::Latency => "latency",
            Self::Unilateral => "unilateral",
            Self::Damping => "damping",
            Self::DampingFilter => "damping_filter",
            Self::Controller => "controller",
            Self::Saturation => "max_force",
            Self::ForceStep => "force_step",
            Self::Amplifier => "amplifier",
            Self::Force => "operator_force",
            Self::Arm => "arm",
        }
    }

    /// What the effect is, in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Hold => "sampling with a zero-order hold",
            Self::Viscous => "viscous friction",
            Self::Coulomb => "Coulomb friction",
            Self::Encoder => "quantization by the encoder",
            Self::Delay => "delay of whole samples",
            Self::Latency => "latency before the output changes",
            Self::Unilateral => "a wall on one side only",
            Self::Damping => "virtual damping by backward difference",
            Self::DampingFilter => "one-pole filter on the virtual damping",
            Self::Controller => "a digital controller",
            Self::Saturation => "saturation of the actuator",
            Self::ForceStep => "quantization by the D/A converter",
            Self::Amplifier => "first-order lag of the amplifier",
            Self::Force => "a force of the operator",
            Self::Arm => "the operator's arm",
        }
    }

    /// The key in a scene file that brings the effect in.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Hold => "sampling.period",
            Self::Viscous => "device.viscous",
            Self::Coulomb => "device.coulomb",
            Self::Encoder => "encoder",
            Self::Delay => "sampling.delay",
            Self::Latency => "sampling.latency",
            Self::Unilateral => "wall.unilateral",
            Self::Damping => "wall.damping",
            Self::DampingFilter => "wall.damping_time_constant",
            Self::Controller => "controller",
            Self::Saturation => "wall.max_force",
            Self::ForceStep => "wall.force_step",
            Self::Amplifier => "amplifier.time_constant",
            Self::Force => "operator.force",
            Self::Arm => "operator.arm",
        }
    }

    /// The theorem that covers the effect, when there is one.
    #[must_use]
    pub const fn theorem(self) -> Option<&'static str> {
        match self {
            Self::Hold | Self::Viscous | Self::Coulomb | Self::Encoder => Some("TH-INTERVAL"),
            Self::Delay => Some("TH-DELAY"),
            Self::Latency => Some("TH-LATENCY"),
            Self::Unilateral => Some("TH-UNI"),
            Self::Damping => Some("TH-DAMP"),
            Self::DampingFilter | Self::Controller => Some("TH-LTI"),
            Self::Saturation => Some("TH-LAW"),
            Self::ForceStep => Some("TH-DAC"),
            // Passivity is a statement about every operator, and an arm is part of one.
            Self::Force | Self::Arm => Some("TH-RUN"),
            Self::Amplifier => Some("TH-LAG"),
        }
    }
}
