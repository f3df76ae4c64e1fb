//! The parameters of a monitor, validated once.

use core::fmt;

use crate::width::PARAMETER_MAX;

/// What a [`Monitor`](crate::Monitor) must know of device and wall.
///
/// All of it in one unit of force, as whole numbers from 0 to [`PARAMETER_MAX`]. The crate's
/// documentation says how to choose the unit and which way to round.
///
/// # Example
///
/// ```
/// use passivity_monitor::Config;
///
/// const CONFIG: Config = match Config::new(1000, 650, 1200) {
///     Ok(config) => config,
///     Err(_) => panic!("out of range"),
/// };
/// assert_eq!(CONFIG.stiffness(), 1000);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config {
    /// K.
    pub(crate) stiffness: i64,
    viscous: i64,
    coulomb: i64,
    /// 2V and 2C at the most.
    pub(crate) twice_viscous: i64,
    pub(crate) twice_coulomb: i64,
    /// −2C at the most.
    pub(crate) minus_coulomb: i64,
    /// The energy allowed for at the start, where it is not that of the spring.
    pub(crate) stored: Option<i64>,
    /// Net energy at the least; see [`net`](crate::account::net).
    pub(crate) net: Net,
}

/// The least net energy of an interval in which the count changes by D ticks up or down, rounded down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Net {
    /// For D below [`SHORT`](Self::SHORT).
    pub(crate) short: [i64; Self::SHORT],
    /// Beyond, (`square`·x + `linear`)·x + `constant` with x = D − 1 for D below `peak`, else D.
    pub(crate) square: i64,
    pub(crate) linear: i64,
    pub(crate) constant: i64,
    pub(crate) peak: i64,
}

impl Net {
    /// How many are tabulated.
    pub(crate) const SHORT: usize = 16;

    #[inline]
    const fn of(stiffness: i64, viscous: i64, coulomb: i64) -> Self {
        let twice_viscous = plus(viscous, viscous);
        // (2V − K)d² + (2C − K)d, up to D.
        let square = minus(twice_viscous, stiffness);
        let linear = minus(plus(coulomb, coulomb), stiffness);
        // Where it has a vertex above zero it is convex, and least there.
        let (vertex, dip) = match (square > 0, linear < 0) {
            (true, true) => (
                over_rounded_up(minus(0, linear), times(2, square)),
                minus(0, over_rounded_up(times(linear, linear), times(4, square))),
            ),
            _ => (0, 0),
        };
        let mut short = [0; Self::SHORT];
        let (mut before, mut fall) = (0, 0);
        let mut rest: &mut [i64] = &mut short;
        let mut d = 0;
        while let Some((slot, others)) = rest.split_first_mut() {
            let here = times(d, plus(times(square, d), linear));
            let rising = plus(times(times(2, twice_viscous), d), linear);
            fall = match rising {
                0.. => 0,
                _ => over_rounded_up(
                    times(rising, rising),
                    times(4, plus(twice_viscous, stiffness)),
                ),
            };
            *slot = least(minus(here, fall), before);
            if d == vertex {
                *slot = least(*slot, dip);
            }
            before = here;
            d = plus(d, 1);
            rest = others;
        }
        if vertex >= d {
            return Self {
                short,
                square: 0,
                linear: 0,
                constant: dip,
                peak: 0,
            };
        }
        // It falls from D − 1 to D where square·(2D − 1) + linear is below zero: from some D on, never, or
        // always.
        let peak = if square < 0 && linear > 0 {
            plus(floor_of(minus(linear, square), times(-2, square)), 1)
        } else if square < 0 || linear < 0 && square == 0 {
            0
        } else {
            i64::MAX
        };
        Self {
            short,
            square,
            linear,
            constant: minus(0, fall),
            peak,
        }
    }
}

#[inline]
const fn least(a: i64, b: i64) -> i64 {
    if a < b { a } else { b }
}

// As in `Width`: within the range of the parameters all of these fit, and nothing is left that could
// panic.

#[inline]
const fn plus(a: i64, b: i64) -> i64 {
    debug_assert!(a.checked_add(b).is_some());
    a.wrapping_add(b)
}

#[inline]
const fn minus(a: i64, b: i64) -> i64 {
    debug_assert!(a.checked_sub(b).is_some());
    a.wrapping_sub(b)
}

#[inline]
const fn times(a: i64, b: i64) -> i64 {
    debug_assert!(a.checked_mul(b).is_some());
    a.wrapping_mul(b)
}

/// The quotient of a number of at least zero by one above zero, rounded down.
#[inline]
const fn floor_of(n: i64, divisor: i64) -> i64 {
    debug_assert!(n >= 0 && divisor > 0);
    n / if divisor > 0 { divisor } else { 1 }
}

/// The quotient of two numbers above zero, rounded up.
#[inline]
const fn over_rounded_up(n: i64, divisor: i64) -> i64 {
    plus(floor_of(minus(n, 1), divisor), 1)
}

/// A parameter of a [`Config`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Parameter {
    /// KΔ, the force of the wall's spring at one tick.
    Stiffness = 1,
    /// bΔ/T, the least force of viscous friction at one tick a sample.
    Viscous = 2,
    /// c, the least Coulomb friction.
    Coulomb = 3,
    /// The most force of viscous friction at one tick a sample.
    ViscousAtMost = 4,
    /// The most Coulomb friction.
    CoulombAtMost = 5,
    /// The energy stored at the start.
    StoredAtStart = 6,
}

/// Why there is no [`Config`] of some numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConfigError {
    /// A parameter is below zero or above its largest value.
    OutOfRange(Parameter),
    /// The most that friction takes is less than the least.
    AtMostBelowLeast(Parameter),
}

impl ConfigError {
    /// The parameter that it is about.
    #[must_use]
    pub const fn parameter(self) -> Parameter {
        match self {
            Self::OutOfRange(parameter) | Self::AtMostBelowLeast(parameter) => parameter,
        }
    }
}

impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self.parameter() {
            Parameter::Stiffness => "stiffness",
            Parameter::Viscous => "viscous friction",
            Parameter::Coulomb => "Coulomb friction",
            Parameter::ViscousAtMost => "largest viscous friction",
            Parameter::CoulombAtMost => "largest Coulomb friction",
            Parameter::StoredAtStart => "energy stored at the start",
        };
        let most = match self.parameter() {
            Parameter::StoredAtStart => 1 << 62,
            _ => PARAMETER_MAX,
        };
        match self {
            Self::OutOfRange(_) => write!(f, "the {name} is not between 0 and {most}"),
            Self::AtMostBelowLeast(_) => write!(f, "the {name} is below the least"),
        }
    }
}

impl core::error::Error for ConfigError {}

impl Config {
    /// The configuration with these parameters, and friction known exactly.
    ///
    /// # Errors
    ///
    /// [`ConfigError::OutOfRange`] for a parameter below zero or above [`PARAMETER_MAX`].
    #[inline]
    pub const fn new(stiffness: i64, viscous: i64, coulomb: i64) -> Result<Self, ConfigError> {
        if let Err(error) = in_range(stiffness, Parameter::Stiffness) {
            return Err(error);
        }
        if let Err(error) = in_range(viscous, Parameter::Viscous) {
            return Err(error);
        }
        if let Err(error) = in_range(coulomb, Parameter::Coulomb) {
            return Err(error);
        }
        Ok(Self {
            stiffness,
            viscous,
            coulomb,
            twice_viscous: times(2, viscous),
            twice_coulomb: times(2, coulomb),
            minus_coulomb: times(-2, coulomb),
            stored: None,
            net: Net::of(stiffness, viscous, coulomb),
        })
    }

    /// The same with friction that may be more, up to these values.
    ///
    /// Only *surely active* depends on them: where the device may take more than the least, less may
    /// have been given.
    ///
    /// # Errors
    ///
    /// [`ConfigError`] for a value above [`PARAMETER_MAX`] or below the least.
    #[inline]
    pub const fn with_friction_at_most(
        self,
        viscous: i64,
        coulomb: i64,
    ) -> Result<Self, ConfigError> {
        if let Err(error) = in_range(viscous, Parameter::ViscousAtMost) {
            return Err(error);
        }
        if let Err(error) = in_range(coulomb, Parameter::CoulombAtMost) {
            return Err(error);
        }
        if viscous < self.viscous {
            return Err(ConfigError::AtMostBelowLeast(Parameter::ViscousAtMost));
        }
        if coulomb < self.coulomb {
            return Err(ConfigError::AtMostBelowLeast(Parameter::CoulombAtMost));
        }
        Ok(Self {
            twice_viscous: times(2, viscous),
            twice_coulomb: times(2, coulomb),
            minus_coulomb: times(-2, coulomb),
            ..self
        })
    }

    /// The same with the energy that was stored at the start, in halves of the force unit times a tick, in
    /// place of the spring's ½Kx²: for a wall that the device starts outside of, or a device that is
    /// moving.
    ///
    /// KΔ²/8, which the account does not tell from nothing, is allowed on top, rounded up to a whole one of these
    /// halves: both bounds are of the energy beyond that.
    ///
    /// # Errors
    ///
    /// [`ConfigError::OutOfRange`] for an energy below zero or above 2⁶².
    #[inline]
    pub const fn with_stored_at_start(self, energy: i64) -> Result<Self, ConfigError> {
        if energy < 0 || energy > 1 << 62 {
            return Err(ConfigError::OutOfRange(Parameter::StoredAtStart));
        }
        let unresolved = floor_of(plus(self.stiffness, 3), 4);
        Ok(Self {
            stored: Some(plus(energy, unresolved)),
            ..self
        })
    }

    /// KΔ.
    #[must_use]
    pub const fn stiffness(&self) -> i64 {
        self.stiffness
    }

    /// bΔ/T at the least.
    #[must_use]
    pub const fn viscous(&self) -> i64 {
        self.viscous
    }

    /// c at the least.
    #[must_use]
    pub const fn coulomb(&self) -> i64 {
        self.coulomb
    }

    /// bΔ/T at the most.
    #[must_use]
    pub const fn viscous_at_most(&self) -> i64 {
        self.twice_viscous / 2
    }

    /// c at the most.
    #[must_use]
    pub const fn coulomb_at_most(&self) -> i64 {
        self.twice_coulomb / 2
    }
}

#[inline]
const fn in_range(value: i64, parameter: Parameter) -> Result<(), ConfigError> {
    if value < 0 || value > PARAMETER_MAX {
        return Err(ConfigError::OutOfRange(parameter));
    }
    Ok(())
}
