//! The methods of simulation: the closed form, its exact, rigorous and very precise relatives, and
//! what people use today, to compare with.

#[cfg(feature = "adaptive")]
mod adaptive;
mod general;
#[cfg(feature = "multiprecision")]
mod precise;
mod steps;

use std::fmt;

use passivity_core::BigRational;
use passivity_scene::{Effect, Point};

use crate::enclosed::Enclosed;
use crate::error::SimError;
use crate::ledger::{Entry, Totals};
use crate::model::Row;
use crate::outcome::End;
use crate::plan::Plan;
use crate::run;

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
        let mut effects = Vec::new();
        let viscous = point
            .beta
            .as_ref()
            .is_some_and(|beta| *beta.numer() != 0.into());
        if *self == Self::Exact && viscous {
            effects.push(Effect::Viscous);
        }
        if matches!(self, Self::Exact | Self::Enclosure) {
            if point.amplifier.is_some() {
                effects.push(Effect::Amplifier);
            }
            if point.arm.is_some() {
                effects.push(Effect::Arm);
            }
        }
        effects
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

/// An interval of a run, in the numbers of the method.
#[derive(Clone, Debug)]
pub enum Line<'a> {
    /// Doubles.
    Double(&'a Entry),
    /// Rationals.
    Exact(&'a Row<BigRational>),
    /// Intervals of doubles.
    Enclosed(&'a Row<Enclosed<f64>>),
}

/// The state at the end in the method's own numbers, where they say more than doubles.
#[derive(Clone, Debug, PartialEq)]
pub enum Detail {
    /// Doubles are all there is.
    None,
    /// ξ and ξ̇ in lowest terms.
    Exact([String; 2]),
    /// ξ and ξ̇ in decimal.
    Digits([String; 2]),
    /// Enclosures of ξ and ξ̇, and the bits of the numbers that decided.
    Enclosed {
        /// The enclosures of ξ and ξ̇.
        ends: [[f64; 2]; 2],
        /// 53 for doubles.
        bits: u32,
    },
}

/// What a simulation gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Simulated {
    /// The state at the end and the outcome.
    pub end: End,
    /// Sums over the run.
    pub totals: Totals,
    /// The state at the end in the method's own numbers.
    pub detail: Detail,
}

/// Who sees every interval of a run; saying `false` stops it.
pub type Each<'a> = &'a mut dyn FnMut(&Line<'_>) -> bool;

/// Simulates a scene's point.
///
/// # Errors
///
/// A scene that cannot be compiled, or has effects that the method cannot do; for the exact method,
/// numbers that grow too long.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Scalar};
/// use passivity_scene::Scene;
/// use passivity_sim::{Exactly, Method, methods::simulate};
///
/// let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"0\"\nsigma = \"3/5\"\n\
///              [start]\nvelocity = \"1/4\"\n[run]\nintervals = 2000";
/// let point = Scene::from_toml("glide", scene).unwrap().point();
/// let run = simulate(&point, &Method::Exact, None).unwrap();
/// assert_eq!(run.end.outcome.exact, Exactly::AtRest);
/// ```
pub fn simulate(
    point: &Point,
    method: &Method,
    each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    planned(point, &Plan::compile(point)?, method, each)
}

/// [`simulate`] with the plan of the point compiled before.
pub(crate) fn planned(
    point: &Point,
    plan: &Plan,
    method: &Method,
    each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    let effects = method.unsupported(point);
    if !effects.is_empty() {
        return Err(SimError::Unsupported {
            method: method.name(),
            effects,
        });
    }
    let (end, totals) = match *method {
        Method::ClosedForm => run::ledger(plan, see(each)),
        Method::Euler { substeps } => run::stepped(plan, steps::euler(plan, substeps), see(each)),
        Method::Rk4 { substeps } => run::stepped(plan, steps::rk4(plan, substeps), see(each)),
        #[cfg(feature = "adaptive")]
        Method::Adaptive { tolerance } => {
            run::stepped(plan, adaptive::steps(plan, tolerance), see(each))
        }
        Method::Exact => return general::exact(point, plan, each),
        #[cfg(feature = "multiprecision")]
        Method::Reference { digits } => return precise::reference(point, plan, digits, each),
        #[cfg(feature = "multiprecision")]
        Method::Enclosure => return precise::enclosure(point, plan, each),
        #[cfg(not(feature = "adaptive"))]
        Method::Adaptive { .. } => {
            return Err(SimError::NotBuiltIn {
                what: "the method `adaptive` is",
                feature: "adaptive",
            });
        }
        #[cfg(not(feature = "multiprecision"))]
        Method::Reference { .. } | Method::Enclosure => {
            return Err(SimError::NotBuiltIn {
                what: "the methods `reference` and `enclosure` are",
                feature: "multiprecision",
            });
        }
    };
    Ok(Simulated {
        end,
        totals,
        detail: Detail::None,
    })
}

/// Shows intervals in doubles to who sees them, if anyone does.
fn see(mut each: Option<Each<'_>>) -> impl FnMut(&Entry) -> bool {
    move |entry| each.as_mut().is_none_or(|each| each(&Line::Double(entry)))
}
