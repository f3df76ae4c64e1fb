//! The methods of simulation by name.

use std::cmp::Ordering;
use std::fmt;

use passivity_core::{Effect, Ordered as _};
use passivity_scene::Point;

use crate::error::SimError;

/// A way to simulate a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// The closed form in doubles.
    ClosedForm,
    /// The whole motion in rational numbers, for scenes without viscous friction.
    Exact,
    /// The closed form with this many decimal digits.
    Reference {
        /// Decimal digits, 20 to 10 000.
        digits: u32,
    },
    /// Rigorous intervals, refined until they decide.
    Enclosure,
    /// Semi-implicit Euler.
    Euler {
        /// Steps in an interval, 1 to 10⁶.
        substeps: u32,
    },
    /// The classical Runge–Kutta method of order 4.
    Rk4 {
        /// Steps in an interval, 1 to 10⁶.
        substeps: u32,
    },
    /// Dormand and Prince's method of order 5 with step-size control, stopping where ξ̇ = 0.
    Adaptive {
        /// Relative and absolute tolerance of a step, 10⁻¹³ to 10⁻¹.
        tolerance: f64,
    },
}

/// The names of the methods, as `--method` takes them.
pub const NAMES: [&str; 7] = [
    "closed-form",
    "exact",
    "reference",
    "enclosure",
    "euler",
    "rk4",
    "adaptive",
];

impl Method {
    /// The method's name.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::ClosedForm => "closed-form",
            Self::Exact => "exact",
            Self::Reference { .. } => "reference",
            Self::Enclosure => "enclosure",
            Self::Euler { .. } => "euler",
            Self::Rk4 { .. } => "rk4",
            Self::Adaptive { .. } => "adaptive",
        }
    }

    /// Reads `NAME` or `NAME:PARAMETER`: `euler:10`, `reference:60`, `adaptive:1e-9`.
    ///
    /// # Errors
    ///
    /// An unknown name, or a parameter out of its range.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_sim::Method;
    ///
    /// assert_eq!(Method::parse("rk4:4"), Ok(Method::Rk4 { substeps: 4 }));
    /// assert_eq!(Method::parse("reference"), Ok(Method::Reference { digits: 50 }));
    /// let error = Method::parse("euler:0").unwrap_err().to_string();
    /// assert_eq!(error, "method `euler:0`: expected 1 to 1000000 steps an interval");
    /// ```
    pub fn parse(text: &str) -> Result<Self, SimError> {
        let (name, parameter) = match text.split_once(':') {
            Some((name, parameter)) => (name, Some(parameter)),
            None => (text, None),
        };
        let fail =
            |expected: &str| SimError::Method(format!("method `{text}`: expected {expected}"));
        let whole = |default: u32, range: std::ops::RangeInclusive<u32>, what: &str| {
            let number = match parameter {
                Some(parameter) => parameter.parse().ok(),
                None => Some(default),
            };
            number
                .filter(|n| range.contains(n))
                .ok_or_else(|| fail(&format!("{} to {} {what}", range.start(), range.end())))
        };
        match name {
            "closed-form" | "exact" | "enclosure" if parameter.is_some() => {
                Err(fail("no parameter"))
            }
            "closed-form" => Ok(Self::ClosedForm),
            "exact" => Ok(Self::Exact),
            "enclosure" => Ok(Self::Enclosure),
            "reference" => Ok(Self::Reference {
                digits: whole(50, 20..=10_000, "decimal digits")?,
            }),
            "euler" => Ok(Self::Euler {
                substeps: whole(10, 1..=1_000_000, "steps an interval")?,
            }),
            "rk4" => Ok(Self::Rk4 {
                substeps: whole(10, 1..=1_000_000, "steps an interval")?,
            }),
            "adaptive" => {
                let tolerance = parameter.map_or(Some(1e-9), |p| p.parse().ok());
                tolerance
                    .filter(|t| (1e-13..=0.1).contains(t))
                    .map(|tolerance| Self::Adaptive { tolerance })
                    .ok_or_else(|| fail("a tolerance from 1e-13 to 0.1"))
            }
            _ => Err(fail(&format!("one of {}", NAMES.join(", ")))),
        }
    }

    /// The effects of a scene that the method cannot do.
    #[must_use]
    pub fn unsupported(&self, point: &Point) -> Vec<Effect> {
        let viscous = point.at.viscous_friction().sign() != Some(Ordering::Equal);
        let cannot = |effect: &Effect| match (self, effect) {
            (Self::Exact, Effect::Viscous) => viscous,
            (Self::Exact, Effect::Amplifier) | (Self::Exact | Self::Enclosure, Effect::Arm) => true,
            _ => false,
        };
        let effects = Effect::ALL.into_iter();
        effects
            .filter(|effect| point.has(*effect) && cannot(effect))
            .collect()
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reference { digits } => write!(f, "reference:{digits}"),
            Self::Euler { substeps } => write!(f, "euler:{substeps}"),
            Self::Rk4 { substeps } => write!(f, "rk4:{substeps}"),
            Self::Adaptive { tolerance } => write!(f, "adaptive:{tolerance:e}"),
            _ => f.write_str(self.name()),
        }
    }
}
