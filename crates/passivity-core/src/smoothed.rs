//! A latency and a lag as a filter of the commands: what they make of the mean force over an interval.

use alloc::vec::Vec;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::absolute_sum::Terms;
use crate::actuator::Actuator;
use crate::exponential::decay;
use crate::interval::Interval;
use crate::scalar::Scalar;
use crate::transfer::TransferFunction;

/// The most terms of a lag's response.
pub const MOST_TERMS: usize = 512;

/// Bits after the point of a lag's response.
const BITS: u32 = 64;

/// What an actuator makes of a command, on average over each interval.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Interval, Scalar, actuator::Actuator, smoothed::Smoothed};
///
/// // Half a sample late: half of each command acts in the interval after it.
/// let half = BigRational::integer(1).half();
/// let late = Actuator {
///     latency: Interval::point(half.clone()),
///     time_constant: Interval::point(BigRational::integer(0)),
/// };
/// let smoothed = Smoothed::of(&late).unwrap();
/// assert_eq!(smoothed.response, [half.clone(), half]);
/// assert_eq!(smoothed.error, BigRational::integer(0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Smoothed {
    /// κ₀, κ₁, …, in samples after the command.
    pub response: Vec<BigRational>,
    /// The same as a transfer function, up to rounding.
    pub transfer: TransferFunction<BigRational>,
    /// How far the mean force may be off for a command that changes by at most 1 a sample.
    pub error: BigRational,
}

impl Smoothed {
    /// The mean of a latency's and a lag's output over an interval.
    ///
    /// With e₁ = e^(−f/θ) and e₂ = e^(−(1 − f)/θ) the output x at a sample becomes
    /// e₁e₂x + (1 − e₁)e₂p + (1 − e₂)u, where p is the command before u, and its mean is
    /// θ(1 − e₁e₂)x + [f − θ(1 − e₁)e₂]p + [1 − f − θ(1 − e₂)]u.
    ///
    /// With e₁ and e₂ off by D together the jκⱼ are off by at most 18θD/(1 − e₁e₂)³ in sum: the three
    /// weights change by at most 3θD, the powers of e = e₁e₂ by jeʲ⁻¹D, Σ jeʲ ≤ 1/(1 − e)² and
    /// Σ j(j + 1)eʲ⁻¹ = 2/(1 − e)³. Each is enclosed to 2⁻⁶⁴ and then rounded down to a multiple of 2⁻⁶⁴,
    /// so that D is at most 3·2⁻⁶⁴.
    ///
    /// Without a lag the response is exact, in the middle of the tolerances. `None` for a latency of 65 536
    /// samples and more, or a lag whose response is longer than [`MOST_TERMS`].
    #[must_use]
    pub fn of(actuator: &Actuator<Interval<BigRational>>) -> Option<Self> {
        let one = BigRational::one();
        let (latency, theta) = (actuator.latency.middle(), actuator.time_constant.middle());
        let over_box = actuator.latency.radius() + actuator.time_constant.radius();
        let whole = u16::try_from(latency.to_integer()).ok()?;
        let fraction = &latency - latency.floor();
        let rest = &one - &fraction;
        if theta == BigRational::zero() {
            let taps = [rest, fraction];
            let transfer = TransferFunction::new(taps, [one]).ok()?.delayed(whole);
            return Some(Self {
                response: transfer.numerator().to_vec(),
                transfer,
                error: over_box,
            });
        }
        let [e1, e2] = [&fraction, &rest].map(|time| {
            let enclosed = decay(&(time / &theta), BITS);
            (enclosed.middle() / unit()).floor() * unit()
        });
        let e = &e1 * &e2;
        let left = &one - &e;
        let of_output = &theta * &left;
        let of_last = &fraction - &theta * (&one - &e1) * &e2;
        let of_now = &rest - &theta * (&one - &e2);
        let (to_last, to_now) = ((&one - &e1) * &e2, &one - &e2);
        let numerator = [
            of_now.clone(),
            &of_last - &e * &of_now + &of_output * to_now,
            &of_output * to_last - &e * &of_last,
        ];
        let transfer = TransferFunction::new(numerator, [one.clone(), -e.clone()]).ok()?;
        let cube = &left * &left * &left;
        let of_decays = BigRational::integer(3 * 18) * &theta * unit() / cube;
        // By what is left of the sum after each term: Σ|Δgⱼ| is what moves the mean delay.
        let tails = Terms::of(&transfer.tails(), &unit())?;
        if tails.terms.len() > MOST_TERMS {
            return None;
        }
        let left_after = |j: usize| {
            let units = tails.terms.get(j).cloned().unwrap_or_default();
            BigRational::from_integer(units) * &tails.unit
        };
        let mut response = alloc::vec![&one - left_after(1)];
        response.extend((1..tails.terms.len()).map(|j| left_after(j) - left_after(j + 1)));
        let mut late = Vec::new();
        late.resize(usize::from(whole), BigRational::zero());
        late.append(&mut response);
        Some(Self {
            response: late,
            transfer: transfer.delayed(whole),
            error: over_box + of_decays + &tails.error,
        })
    }
}

/// What a lag's response is rounded to, 2⁻⁶⁴.
pub(crate) fn unit() -> BigRational {
    BigRational::new(BigInt::from(1), BigInt::from(1) << BITS)
}
