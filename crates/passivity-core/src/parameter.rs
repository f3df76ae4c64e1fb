//! The parameters of a control loop: one table that everything about a parameter is read from.
//!
//! The table makes the type [`Loop`] too, so that a parameter that is added here is in every loop,
//! every list and every conversion, and each `match` that does not know it fails to compile.

use alloc::sync::Arc;
use core::cmp::Ordering;

use num_rational::BigRational;

use crate::transfer::TransferFunction;

/// Which values a parameter may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Values {
    /// Values above zero.
    Positive,
    /// Zero and values above it.
    NonNegative,
    /// Values of either sign.
    Any,
}

impl Values {
    /// Whether a value with this sign is allowed.
    #[must_use]
    #[cfg_attr(prusti, prusti_contracts::ensures(matches!(sign, Ordering::Greater) ==> result))]
    pub const fn allow(self, sign: Ordering) -> bool {
        match (self, sign) {
            (Self::Any, _) | (_, Ordering::Greater) => true,
            (Self::NonNegative, Ordering::Equal) => true,
            (Self::NonNegative | Self::Positive, _) => false,
        }
    }

    /// What was expected, for an error message.
    #[must_use]
    pub const fn expected(self) -> &'static str {
        match self {
            Self::Positive => "a value above zero",
            Self::NonNegative => "zero or a value above it",
            Self::Any => "a value of either sign",
        }
    }
}

/// In which direction a parameter makes the criterion harder to meet.
///
/// The sampling period is listed as [`More`](Self::More): with an encoder and virtual damping a
/// shorter period costs Coulomb friction as well, which
/// [`Loop::decide`](crate::Loop::decide) takes into account.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hurts {
    /// The larger, the harder.
    More,
    /// The smaller, the harder.
    Less,
    /// It is no part of the criterion.
    Neither,
}

/// The unit of a parameter as a product of powers of K, T and Δ (3), (4), (7).
///
/// Divided by it, a parameter is dimensionless. With K in N/m, T in s and Δ in m the same powers
/// tell the dimension: K·T² is a mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// The power of the stiffness K.
    pub stiffness: i8,
    /// The power of the sampling period T.
    pub period: i8,
    /// The power of the length Δ.
    pub length: i8,
}

impl Unit {
    const fn new(stiffness: i8, period: i8, length: i8) -> Self {
        Self {
            stiffness,
            period,
            length,
        }
    }

    /// KT², of an inertia.
    pub const INERTIA: Self = Self::new(1, 2, 0);
    /// KT, of viscous friction and damping.
    pub const VISCOUS: Self = Self::new(1, 1, 0);
    /// KΔ, of a force.
    pub const FORCE: Self = Self::new(1, 0, 1);
    /// K, of a stiffness.
    pub const STIFFNESS: Self = Self::new(1, 0, 0);
    /// 1, of a pure number.
    pub const NONE: Self = Self::new(0, 0, 0);
    /// T, of a time.
    pub const TIME: Self = Self::new(0, 1, 0);
    /// Δ, of a position.
    pub const POSITION: Self = Self::new(0, 0, 1);
    /// Δ/T, of a speed.
    pub const SPEED: Self = Self::new(0, -1, 1);

    /// The power of the ratio n of a rigid transmission, the way of the motor over that of the
    /// device, by which a quantity at the motor is multiplied to have it at the device: 2 for
    /// inertia, damping and stiffness (n²·b), 1 for a force (n·c), −1 for a position (Δ/n).
    ///
    /// The powers leave every energy as it is: a force times a way has the power 0.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::parameter::Unit;
    ///
    /// assert_eq!(Unit::VISCOUS.transmission_power(), 2);
    /// assert_eq!(Unit::FORCE.transmission_power() + Unit::POSITION.transmission_power(), 0);
    /// ```
    #[must_use]
    pub const fn transmission_power(self) -> i8 {
        2 * self.stiffness - self.length
    }
}

/// A row of the table: all that is known of a parameter beside its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The key in a scene file, with its section; empty for what is computed from other parameters.
    pub key: &'static str,
    /// Other keys that give the same parameter: in another form, or at the motor's side of a
    /// transmission.
    pub other_keys: &'static [&'static str],
    /// The key of its dimensionless counterpart, where there is one.
    pub dimensionless_key: Option<&'static str>,
    /// Its name in words.
    pub name: &'static str,
    /// Its letter in the equations.
    pub symbol: &'static str,
    /// The letter of its dimensionless counterpart, where there is one.
    pub dimensionless_symbol: Option<&'static str>,
    /// The unit that makes it dimensionless.
    pub unit: Unit,
    /// Which values it may take.
    pub values: Values,
    /// In which direction it makes the criterion harder to meet.
    pub hurts: Hurts,
    /// The value that stands for an absent parameter; `None` where absent means that the effect is
    /// not there, or that the parameter is required.
    pub default: Option<i32>,
}

impl Row {
    const fn new(key: &'static str, name: &'static str, symbol: &'static str, unit: Unit) -> Self {
        Self {
            key,
            other_keys: &[],
            dimensionless_key: None,
            name,
            symbol,
            dimensionless_symbol: None,
            unit,
            values: Values::Positive,
            hurts: Hurts::Neither,
            default: None,
        }
    }

    const fn hurts(self, hurts: Hurts) -> Self {
        Self { hurts, ..self }
    }

    const fn values(self, values: Values) -> Self {
        Self { values, ..self }
    }

    const fn zero_by_default(self) -> Self {
        Self {
            default: Some(0),
            ..self
        }
    }

    const fn or_keys(self, other_keys: &'static [&'static str]) -> Self {
        Self { other_keys, ..self }
    }

    const fn dimensionless(self, key: &'static str, symbol: &'static str) -> Self {
        Self {
            dimensionless_key: Some(key),
            dimensionless_symbol: Some(symbol),
            ..self
        }
    }
}

macro_rules! parameters {
    (
        required { $( $(#[doc = $rdoc:literal])+ $rfield:ident: $rname:ident = $rrow:expr; )+ }
        optional { $( $(#[doc = $odoc:literal])+ $ofield:ident: $oname:ident = $orow:expr; )+ }
    ) => {
        /// A parameter of a device, its control loop, the wall, the operator or the start.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Parameter {
            $( $(#[doc = $rdoc])+ $rname, )+
            $( $(#[doc = $odoc])+ $oname, )+
        }

        impl Parameter {
            /// Every parameter, in the order of the table.
            pub const ALL: &'static [Self] = &[ $( Self::$rname, )+ $( Self::$oname, )+ ];

            /// The parameter's row of the table.
            ///
            /// # Example
            ///
            /// ```
            /// use passivity_core::Parameter;
            ///
            /// assert_eq!(Parameter::Stiffness.row().values.expected(), "a value above zero");
            /// assert_eq!(Parameter::Coulomb.row().symbol, "c");
            /// ```
            #[must_use]
            pub const fn row(self) -> Row {
                match self {
                    $( Self::$rname => $rrow, )+
                    $( Self::$oname => $orow, )+
                }
            }
        }

        /// A device, its control loop, a wall and its operator: the one description of a loop.
        ///
        /// `V` is what is known of each number: a number, an interval of them, or a text with its
        /// place in a file. A parameter that is `None` is absent, and so is its effect. Units are
        /// the caller's, as long as they agree; in a *dimensionless* loop K, T and Δ are 1, b is β,
        /// c is σ and m is μ (7), positions are in ticks and speeds in ticks per sample. Without an
        /// encoder (`resolution` absent) the unit of length is 1.
        ///
        /// # Example
        ///
        /// The paper's Maxon RE35 at K = 1 N·m/rad with Δ = 0.001 rad.
        ///
        /// ```
        /// use passivity_core::{Fixed, Loop, Scalar};
        ///
        /// let re35 = Loop {
        ///     viscous: Some(Fixed::new(9, 1_000_000)),
        ///     coulomb: Some(Fixed::new(2, 1000)),
        ///     resolution: Some(Fixed::new(1, 1000)),
        ///     ..Loop::new(Fixed::integer(1), Fixed::new(1, 1000))
        /// };
        /// assert_eq!(re35.friction().beta, Fixed::new(9, 1000));
        /// assert_eq!(re35.friction().sigma, Fixed::integer(2));
        /// ```
        #[derive(Clone, Debug, PartialEq)]
        pub struct Loop<V> {
            $( $(#[doc = $rdoc])+ pub $rfield: V, )+
            $( $(#[doc = $odoc])+ pub $ofield: Option<V>, )+
            /// k, whole samples by which the force is late (TH-DELAY).
            pub delay: u16,
            /// Whether the wall is x ≥ 0 only (TH-UNI).
            pub unilateral: bool,
            /// H(z) of a digital controller in place of the spring and its damping, in units of the
            /// stiffness (TH-LTI).
            pub controller: Option<Arc<TransferFunction<BigRational>>>,
        }

        impl<V> Loop<V> {
            /// A wall on both sides with the required parameters and nothing else.
            pub const fn new($( $rfield: V, )+) -> Self {
                Self { $( $rfield, )+ $( $ofield: None, )+ delay: 0, unilateral: false, controller: None }
            }

            /// What is known of a parameter; `None` when it is absent.
            pub const fn get(&self, parameter: Parameter) -> Option<&V> {
                match parameter {
                    $( Parameter::$rname => Some(&self.$rfield), )+
                    $( Parameter::$oname => self.$ofield.as_ref(), )+
                }
            }

            /// The same loop with one parameter at another value.
            #[must_use]
            pub fn with(mut self, parameter: Parameter, value: V) -> Self {
                match parameter {
                    $( Parameter::$rname => self.$rfield = value, )+
                    $( Parameter::$oname => self.$ofield = Some(value), )+
                }
                self
            }

            /// The same loop with every number taken through `f`; `None` when `f` gives up on one.
            pub fn try_map<U>(&self, mut f: impl FnMut(Parameter, &V) -> Option<U>) -> Option<Loop<U>> {
                Some(Loop {
                    $( $rfield: f(Parameter::$rname, &self.$rfield)?, )+
                    $( $ofield: match &self.$ofield {
                        Some(value) => Some(f(Parameter::$oname, value)?),
                        None => None,
                    }, )+
                    delay: self.delay,
                    unilateral: self.unilateral,
                    controller: self.controller.clone(),
                })
            }

            /// The same loop with every number taken through `f`.
            pub fn map<U>(&self, mut f: impl FnMut(Parameter, &V) -> U) -> Loop<U> {
                Loop {
                    $( $rfield: f(Parameter::$rname, &self.$rfield), )+
                    $( $ofield: self.$ofield.as_ref().map(|value| f(Parameter::$oname, value)), )+
                    delay: self.delay,
                    unilateral: self.unilateral,
                    controller: self.controller.clone(),
                }
            }
        }
    };
}

parameters! {
    required {
        /// K > 0, stiffness of the wall.
        stiffness: Stiffness = Row::new("wall.stiffness", "stiffness", "K", Unit::STIFFNESS)
            .hurts(Hurts::More);
        /// T > 0, sampling period.
        period: Period = Row::new("sampling.period", "sampling period", "T", Unit::TIME)
            .or_keys(&["sampling.rate"])
            .hurts(Hurts::More);
    }
    optional {
        /// m > 0, mass or moment of inertia: needed only to simulate and for TH-START.
        inertia: Inertia = Row::new("device.inertia", "inertia", "m", Unit::INERTIA)
            .or_keys(&["device.mass", "motor.inertia"])
            .dimensionless("dimensionless.mu", "μ");
        /// b ≥ 0, viscous friction; absent it is zero.
        viscous: Viscous = Row::new("device.viscous", "viscous friction", "b", Unit::VISCOUS)
            .or_keys(&["motor.viscous"])
            .values(Values::NonNegative)
            .hurts(Hurts::Less)
            .zero_by_default()
            .dimensionless("dimensionless.beta", "β");
        /// c ≥ 0, Coulomb friction; absent it is zero.
        coulomb: Coulomb = Row::new("device.coulomb", "Coulomb friction", "c", Unit::FORCE)
            .or_keys(&["motor.coulomb"])
            .values(Values::NonNegative)
            .hurts(Hurts::Less)
            .zero_by_default()
            .dimensionless("dimensionless.sigma", "σ");
        /// Δ > 0, resolution of the encoder; absent the position is known exactly (TH-SMOOTH).
        resolution: Resolution = Row::new("encoder.resolution", "encoder resolution", "Δ", Unit::POSITION)
            .or_keys(&["encoder.counts_per_revolution"])
            .hurts(Hurts::More);
        /// B ≥ 0, virtual damping by backward difference (TH-DAMP).
        damping: Damping = Row::new("wall.damping", "virtual damping", "B", Unit::VISCOUS)
            .values(Values::NonNegative)
            .hurts(Hurts::More);
        /// τ ≥ 0, time constant of a one-pole filter on the virtual damping (TH-LTI).
        damping_time_constant: DampingTimeConstant =
            Row::new("wall.damping_time_constant", "time constant of the damping's filter", "τ", Unit::TIME)
            .or_keys(&["wall.damping_cutoff"])
            .values(Values::NonNegative)
            .hurts(Hurts::Less);
        /// F_max > 0, the largest force that the actuator gives (TH-LAW).
        max_force: MaxForce = Row::new("wall.max_force", "largest force", "F_max", Unit::FORCE)
            .or_keys(&["motor.max_torque"]);
        /// F > 0, step of the force of the D/A converter (TH-DAC); δ in KΔ.
        force_step: ForceStep = Row::new("wall.force_step", "force step", "F", Unit::FORCE)
            .or_keys(&["motor.torque_step"])
            .hurts(Hurts::More);
        /// L ≥ 0, time after a sample before the output changes (TH-LATENCY); it adds to the delay.
        latency: Latency = Row::new("sampling.latency", "latency", "L", Unit::TIME)
            .values(Values::NonNegative)
            .hurts(Hurts::More);
        /// T_a > 0, time constant of the amplifier's first-order lag (TH-LAG).
        time_constant: TimeConstant =
            Row::new("amplifier.time_constant", "amplifier time constant", "T_a", Unit::TIME)
            .hurts(Hurts::More);
        /// What all but friction and D/A steps costs of viscous friction, in KT: computed from the
        /// other parameters where they say it in no closed form (TH-LTI, TH-LAG, TH-LATENCY).
        viscous_cost: ViscousCost = Row::new("", "viscous cost", "λ", Unit::NONE)
            .hurts(Hurts::More);
        /// What an encoder costs of Coulomb friction, in KΔ: computed like `viscous_cost` (TH-LTI).
        coulomb_cost: CoulombCost = Row::new("", "Coulomb cost", "½‖c‖₁", Unit::NONE)
            .values(Values::NonNegative)
            .hurts(Hurts::More);
        /// V > 0, a bound on the speed that the verdict may use.
        max_speed: MaxSpeed = Row::new("operator.max_speed", "speed bound", "V", Unit::SPEED)
            .hurts(Hurts::More);
        /// A constant force of the operator.
        operator_force: OperatorForce =
            Row::new("operator.force", "force of the operator", "F_H", Unit::FORCE)
            .values(Values::Any);
        /// Mass or inertia of the operator's arm, which moves with the device.
        arm_mass: ArmMass = Row::new("operator.arm.mass", "mass of the arm", "m_a", Unit::INERTIA)
            .values(Values::NonNegative)
            .zero_by_default();
        /// Viscous damping of the operator's arm.
        arm_damping: ArmDamping =
            Row::new("operator.arm.damping", "damping of the arm", "b_a", Unit::VISCOUS)
            .values(Values::NonNegative)
            .zero_by_default();
        /// Stiffness of the operator's arm.
        arm_stiffness: ArmStiffness =
            Row::new("operator.arm.stiffness", "stiffness of the arm", "K_a", Unit::STIFFNESS)
            .values(Values::NonNegative)
            .zero_by_default();
        /// x(0), position at the first sampling instant; absent it is zero.
        start_position: StartPosition =
            Row::new("start.position", "position at the start", "x(0)", Unit::POSITION)
            .values(Values::Any)
            .zero_by_default();
        /// v(0), velocity at the first sampling instant; absent it is zero.
        start_velocity: StartVelocity =
            Row::new("start.velocity", "velocity at the start", "v(0)", Unit::SPEED)
            .values(Values::Any)
            .zero_by_default();
    }
}
