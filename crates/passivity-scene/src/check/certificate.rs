//! The decision whether viscous friction is enough at every frequency, with what shows it (TH-LTI).
//!
//! β ≥ λ is a question about a polynomial P in x = cos θ: whether it is nowhere negative on [−1, 1].
//! The kernel answers by Sturm's theorem. A [`Certificate`] has the loop, P and Sturm's sequence with
//! its sign changes, so that another implementation can check the answer by multiplication, division
//! and signs.

use std::fmt;

use num_bigint::BigInt;
use passivity_core::frequency::ViscousCost;
use passivity_core::linear_part::{Command, LinearPart, MOST_DEGREE};
use passivity_core::polynomial::Polynomial;
use passivity_core::sturm::SignOver;
use passivity_core::transfer::TransferFunction;
use passivity_core::{BigRational, Interval, Scalar as _};
use serde::Serialize;

use super::BITS;
use super::report::Report;
use crate::scene::Scene;

/// The name of this format.
const FORMAT: &str = "passivity-check-certificate-1";

/// How close the two numbers are between which λ is shown to be: 2⁻⁶⁴.
const WIDTH_BITS: u32 = 64;

/// What viscous friction has to be at every frequency, and whether it is, with what shows both.
///
/// Serialised it is the file that `check --certificate` writes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Certificate {
    format: &'static str,
    scene: String,
    r#loop: Terms,
    cost: Bounds,
    decisions: Vec<Decision>,
}

/// The dimensionless loop, as far as λ and β depend on it.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Terms {
    beta: Ends,
    delay: u16,
    /// B of virtual damping, and the pole a of its filter: 1 + B(1 − z⁻¹)(1 − a)/(1 − az⁻¹).
    #[serde(skip_serializing_if = "Option::is_none")]
    damping: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pole: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    controller: Option<Coefficients>,
}

/// H(z) = (n₀ + n₁z⁻¹ + …)/(d₀ + d₁z⁻¹ + …), without the delay.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Coefficients {
    numerator: Vec<String>,
    denominator: Vec<String>,
}

/// The ends of what is known of a number.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Ends {
    lo: String,
    hi: String,
}

/// Two numbers that λ is between: β = `above` is not enough, β = `at_most` is.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Bounds {
    above: String,
    at_most: String,
}

/// Whether β ≥ λ, for one β.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Decision {
    beta: String,
    enough: bool,
    /// P, not negative at x = cos θ exactly when β ≥ λ(θ): its coefficients of x⁰, x¹, ….
    polynomial: Vec<String>,
    #[serde(flatten)]
    because: Because,
}

/// What shows that P is nowhere negative on [−1, 1], or that it is.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
enum Because {
    Sturm {
        /// S, of simple roots only, with P = S·M².
        simple: Vec<String>,
        /// M.
        repeated: Vec<String>,
        /// S, S′, and from then on minus the remainder of the two before, up to positive factors.
        sequence: Vec<Vec<String>>,
        /// How often the sign changes along the sequence at −1 and at 1.
        sign_changes: [usize; 2],
        /// S(0), above zero unless P is zero everywhere.
        simple_at_zero: String,
    },
    Negative {
        /// A cos θ with P(cos θ) < 0.
        at: String,
        /// P there.
        value: String,
    },
}

/// Why no certificate can be written for a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NotCertified {
    /// The scene has several joints.
    Joints,
    /// A latency or an amplifier: κ is compared by squares (TH-LATENCY, TH-LAG).
    Actuator,
    /// The force is not linear in the measured positions.
    NotLinear,
    /// A tolerance, or π, in the damping or its filter: the loop is not one but many.
    Tolerance,
    /// The polynomial has too high a degree, and a bound stands in place of λ.
    Degree,
    /// A number of the loop is undefined.
    Undefined,
}

impl fmt::Display for NotCertified {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Joints => f.write_str("a scene of several joints has no polynomial in cos θ"),
            Self::Actuator => {
                f.write_str("behind a latency or an amplifier no polynomial in cos θ decides")
            }
            Self::NotLinear => {
                f.write_str("behind a one-sided or saturated wall no polynomial in cos θ decides")
            }
            Self::Tolerance => f.write_str(
                "virtual damping or its filter has a tolerance, or π, and a certificate is of one loop",
            ),
            Self::Undefined => f.write_str("a number of the loop is undefined"),
            Self::Degree => write!(
                f,
                "the polynomial in cos θ is of a degree above {MOST_DEGREE}, and a bound stands in its place"
            ),
        }
    }
}

impl std::error::Error for NotCertified {}

impl Certificate {
    /// The certificate of a scene that was checked (TH-LTI).
    ///
    /// # Errors
    ///
    /// [`NotCertified`] where Sturm's theorem does not decide.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_scene::Scene;
    /// use passivity_scene::check::{Certificate, NotCertified, check};
    ///
    /// let late = "[dimensionless]\nbeta = \"2\"\nsigma = \"1\"\n[sampling]\ndelay = 1\n";
    /// let certificate = |text: &str| {
    ///     let scene = Scene::from_toml("late", text).unwrap();
    ///     Certificate::new(&scene, &check(&scene))
    /// };
    /// assert!(certificate(late).unwrap().is_enough());
    /// let lag = format!("{late}[amplifier]\ntime_constant = \"1\"\n");
    /// assert_eq!(certificate(&lag), Err(NotCertified::Actuator));
    /// ```
    pub fn new(scene: &Scene, report: &Report) -> Result<Self, NotCertified> {
        let part = scene.bounds().linear_part(BITS);
        let part = part.ok_or(NotCertified::Undefined)?;
        if part.actuator.is_some() {
            return Err(NotCertified::Actuator);
        }
        if !part.linear {
            return Err(NotCertified::NotLinear);
        }
        let terms = Terms::of(&part, &report.beta).ok_or(NotCertified::Tolerance)?;
        let cost = part.frequency_response().ok_or(NotCertified::Degree)?;
        let [above, at_most] = bounds(&cost);
        let mut decided = vec![report.beta.lo(), report.beta.hi(), &above, &at_most];
        decided.sort();
        decided.dedup();
        Ok(Self {
            format: FORMAT,
            scene: scene.name.clone(),
            r#loop: terms,
            decisions: decided
                .into_iter()
                .map(|beta| Decision::of(&cost, beta))
                .collect(),
            cost: Bounds {
                above: above.to_string(),
                at_most: at_most.to_string(),
            },
        })
    }

    /// Whether β ≥ λ for every β of the tolerance.
    #[must_use]
    pub fn is_enough(&self) -> bool {
        let of_beta = |decision: &&Decision| decision.beta == self.r#loop.beta.lo;
        self.decisions
            .iter()
            .find(of_beta)
            .is_some_and(|decision| decision.enough)
    }
}

impl Terms {
    /// The terms of a loop; `None` where they are not those of one loop.
    fn of(part: &LinearPart, beta: &Interval<BigRational>) -> Option<Self> {
        let mut terms = Self {
            beta: Ends {
                lo: beta.lo().to_string(),
                hi: beta.hi().to_string(),
            },
            delay: part.delay,
            damping: None,
            pole: None,
            controller: None,
        };
        match &part.command {
            Command::Controller(controller) => {
                terms.controller = Some(Coefficients::of(controller))
            }
            Command::Spring { damping, pole } => {
                let one = |x: &Interval<BigRational>| x.is_point().then(|| x.lo().clone());
                let there = |x: BigRational| (x != BigRational::zero()).then(|| x.to_string());
                terms.damping = there(one(damping)?);
                terms.pole = there(one(pole)?);
            }
        }
        Some(terms)
    }
}

impl Coefficients {
    fn of(controller: &TransferFunction<BigRational>) -> Self {
        Self {
            numerator: texts(controller.numerator()),
            denominator: texts(controller.denominator()),
        }
    }
}

impl Decision {
    fn of(cost: &ViscousCost, beta: &BigRational) -> Self {
        let polynomial = cost.spare(beta);
        let decided = cost.decide(beta);
        let of = |polynomial: &Polynomial| texts(&polynomial.coefficients());
        Self {
            beta: beta.to_string(),
            enough: decided.is_nonnegative(),
            because: match decided {
                SignOver::Nonnegative(found) => Because::Sturm {
                    simple_at_zero: found.simple.at(&BigRational::zero()).to_string(),
                    simple: of(&found.simple),
                    repeated: of(&found.repeated),
                    sequence: found.sequence.iter().map(of).collect(),
                    sign_changes: found.sign_changes,
                },
                SignOver::NegativeAt(x) => Because::Negative {
                    value: polynomial.at(&x).to_string(),
                    at: x.to_string(),
                },
            },
            polynomial: of(&polynomial),
        }
    }
}

/// λ from below and from above, at most 2·2⁻⁶⁴ apart: the first is not enough, the second is.
fn bounds(cost: &ViscousCost) -> [BigRational; 2] {
    let width = BigRational::new(1.into(), BigInt::from(1) << WIDTH_BITS);
    let enclosure = cost.enclosure(&width);
    let above = match enclosure.is_point() {
        true => enclosure.lo() - &width,
        false => enclosure.lo().clone(),
    };
    [above, enclosure.hi().clone()]
}

fn texts(numbers: &[BigRational]) -> Vec<String> {
    numbers.iter().map(BigRational::to_string).collect()
}
