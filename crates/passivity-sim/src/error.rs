//! Why a scene cannot be simulated, or not by the method that was asked for.

use std::fmt;

use passivity_scene::Effect;

/// Why a simulation could not be set up or carried on.
///
/// # Example
///
/// ```
/// use passivity_core::Effect;
/// use passivity_sim::SimError;
///
/// let error = SimError::Unsupported { method: "enclosure", effects: vec![Effect::Arm] };
/// assert_eq!(
///     error.to_string(),
///     "method `enclosure` cannot simulate this scene: it has the operator's arm (`operator.arm`)"
/// );
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum SimError {
    /// The scene has no inertia.
    NoInertia,
    /// The method cannot do some of the scene's effects.
    Unsupported {
        /// The method.
        method: &'static str,
        /// The effects of the scene that it cannot do.
        effects: Vec<Effect>,
    },
    /// A parameter that is no finite double, or rounds to 0 or below where it must not.
    OutOfRange {
        /// The parameter's name.
        parameter: &'static str,
        /// What was expected.
        expected: &'static str,
    },
    /// A motion within the interval that is too fast for the power series.
    TooFast {
        /// The fastest rate, per sampling period.
        rate: f64,
        /// The largest rate that is simulated.
        limit: f64,
    },
    /// An exact position has outgrown its bound.
    Denominator {
        /// The interval at which it did.
        interval: u64,
        /// The bound, in bits.
        bits: u64,
    },
    /// A digital filter with a coefficient out of the range of doubles.
    Filter,
    /// A number that has overflowed, or a figure that has no finite value.
    NotFinite {
        /// The interval in which it did.
        interval: u64,
        /// What the figure is.
        figure: &'static str,
    },
    /// The build leaves out what was asked for.
    NotBuiltIn {
        /// What was asked for.
        what: &'static str,
        /// The feature of the crate that has it.
        feature: &'static str,
    },
    /// The method's parameter is out of its range.
    Method(String),
    /// A file that could not be read or written.
    File(String),
}

fn list(effects: &[Effect], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (i, effect) in effects.iter().enumerate() {
        let comma = if i == 0 { "" } else { ", " };
        write!(f, "{comma}{} (`{}`)", effect.words(), effect.key())?;
    }
    Ok(())
}

impl fmt::Display for SimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoInertia => f.write_str(
                "the scene has no inertia: a simulation needs `device.inertia`, `device.mass` or \
                 `dimensionless.mu`",
            ),
            Self::Unsupported { method, effects } => {
                write!(f, "method `{method}` cannot simulate this scene: it has ")?;
                list(effects, f)
            }
            Self::OutOfRange {
                parameter,
                expected,
            } => write!(f, "{parameter} cannot be simulated: expected {expected}"),
            Self::TooFast { rate, limit } => write!(
                f,
                "the amplifier, the arm or the friction acts {rate:.3e} times per sampling period: \
                 with an amplifier or an arm at most {limit} can be simulated"
            ),
            Self::Denominator { interval, bits } => write!(
                f,
                "the exact position, or what the controller remembers, needs more than {bits} bits at interval {interval}: simulate \
                 fewer intervals, or use `--method enclosure`"
            ),
            Self::Filter => f.write_str(
                "the controller's digital filter cannot be simulated: expected coefficients with a \
                 magnitude up to 1e120",
            ),
            Self::NotFinite { interval, figure } => {
                write!(f, "`{figure}` has no finite value in interval {interval}")
            }
            Self::NotBuiltIn { what, feature } => write!(
                f,
                "{what} not in this build: build it with the feature `{feature}`"
            ),
            Self::Method(message) | Self::File(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for SimError {}
