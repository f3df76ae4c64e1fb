//! ‖c‖₁ = Σ|cⱼ|, what a controller's response adds up to: half of it is what an encoder costs of
//! Coulomb friction (TH-LTI).
//!
//! The measured position is off by at most half a tick, so the command is off by at most ½‖c‖₁, and
//! an interval draws at most ½‖c‖₁·|D| more. Without a denominator, and with one of first order, the
//! sum is a rational; else it is enclosed, by a finite sum and a bound of what comes after it.
//!
//! # Derivation of the bounds
//!
//! Past the numerator the response obeys cⱼ = −Σ rᵢcⱼ₋ᵢ with rᵢ = dᵢ/d₀, that is sⱼ = A·sⱼ₋₁ for
//! sⱼ = (cⱼ, …, cⱼ₋ₙ₊₁) and the companion matrix A. With the matrix norm that belongs to the sum of
//! magnitudes, let ρᵢ bound the norm of the 2ⁱ-th power of A, and let ρₘ < 1. Then
//!
//! Σ_{i ≥ 0} ‖Aⁱ‖ ≤ G = (1 + ρ₀)(1 + ρ₁)…(1 + ρₘ₋₁)/(1 − ρₘ),
//!
//! because the sum of the first 2ⁱ⁺¹ norms is at most that of the first 2ⁱ times (1 + ρᵢ), and each
//! further block of 2ᵐ at most ρₘ times the block before. So
//!
//! - Σ_{j > J} |cⱼ| ≤ (G − 1)·‖s_J‖ once J is past the numerator;
//! - a response computed with an error of at most ε in each step is off by at most G·ε everywhere, and
//!   so is ‖s_J‖: an error made once is carried on by the powers of A.

use alloc::collections::VecDeque;
use alloc::vec::Vec;

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

use crate::fraction::Wide;
use crate::interval::Interval;
use crate::rational::{from_wide, to_wide};
use crate::transfer::TransferFunction;
use crate::whole::{dyadic, fraction, over_common};

/// How many terms of a response are summed up at most before it is given up.
///
/// With the slowest pole at r it takes about ln(1/width)/(1 − r).
pub const MOST_TERMS: u32 = 1 << 20;

/// Bits after the point that the powers of the companion matrix are computed to, one after the other.
const WIDTHS: [u64; 4] = [128, 512, 2048, 8192];

/// The highest power of the companion matrix that is tried, as a power of two.
const MOST_DOUBLINGS: u32 = 24;

/// An enclosure of Σ|cⱼ|, at most `width` > 0 wide, and a point for a denominator of order 0 or 1.
///
/// `None` where that takes more than [`MOST_TERMS`] terms: a pole is too near to the unit circle.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Interval, Scalar, absolute_sum, transfer::TransferFunction};
///
/// let [one, two] = [1, 2].map(BigRational::integer);
/// // Virtual damping B = 1 behind a pole of a = ½: ½‖c‖₁ = ½ + B(1 − a) = 1.
/// let filtered = TransferFunction::filtered_damping(&one, &one.clone().half()).unwrap();
/// assert_eq!(absolute_sum::enclosure(&filtered, &one), Some(Interval::point(two)));
/// ```
#[must_use]
pub fn enclosure(
    controller: &TransferFunction<BigRational>,
    width: &BigRational,
) -> Option<Interval<BigRational>> {
    match controller.denominator() {
        [] | [_] => Some(Interval::point(finite(controller))),
        [first, second] => {
            // From the last driven term on, each is −d₁/d₀ times the one before.
            let response = controller.impulse_response(controller.numerator().len().max(1));
            let ratio = (second / first).abs();
            let after = response.last()?.abs() * (&ratio / (BigRational::one() - &ratio));
            Some(Interval::point(total(&response) + after))
        }
        _ => summed(controller, width),
    }
}

/// An enclosure of ½H(1) + Σ|gⱼ| for j ≥ 1, the viscous friction that is enough for the controller
/// behind any law that is nowhere steeper, such as a one-sided or saturated wall (TH-LTI, TH-LAW).
///
/// Safe, not sharp: each later step is charged half of every product |gⱼDₕDₕ₋ⱼ|, whatever the
/// signs. As tight as [`enclosure`], and `None` where that is.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Interval, Scalar, absolute_sum, transfer::TransferFunction};
///
/// let [one, two] = [1, 2].map(BigRational::integer);
/// let late = TransferFunction::damped(&one.clone().half()).unwrap().delayed(1);
/// // g₁ = 1, g₂ = −½: 2 instead of 5/4.
/// assert_eq!(absolute_sum::viscous_bound(&late, &one), Some(Interval::point(two)));
/// ```
#[must_use]
pub fn viscous_bound(
    controller: &TransferFunction<BigRational>,
    width: &BigRational,
) -> Option<Interval<BigRational>> {
    let half = controller.at_one() / BigInt::from(2);
    let tails = enclosure(&controller.tails(), width)?;
    Some(tails.map(|end| end + &half))
}

/// ‖c‖₁ of a response that ends.
fn finite(controller: &TransferFunction<BigRational>) -> BigRational {
    total(&controller.impulse_response(controller.numerator().len()))
}

fn total(response: &[BigRational]) -> BigRational {
    let magnitudes = response.iter().map(|c| c.abs());
    magnitudes.fold(BigRational::zero(), |sum, c| sum + c)
}

fn summed(
    controller: &TransferFunction<BigRational>,
    width: &BigRational,
) -> Option<Interval<BigRational>> {
    let Terms { terms, unit, error } = Terms::of(controller, &(width / BigInt::from(2)))?;
    let sum = terms.iter().fold(BigInt::zero(), |sum, c| sum + c.abs());
    let computed = BigRational::from_integer(sum) * unit;
    Interval::new(&computed - &error, computed + error)
}

/// A response in whole multiples of a unit, cut where what comes after is small.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Terms {
    /// c₀, c₁, …, in units.
    pub(crate) terms: Vec<BigInt>,
    /// The unit.
    pub(crate) unit: BigRational,
    /// What Σ|cⱼ − the term of j| over all j is at most.
    pub(crate) error: BigRational,
}

impl Terms {
    /// The terms of a response, exact where it ends; else in fixed point, with the two errors of the
    /// derivation together at most `width` > 0. `None` like [`enclosure`].
    pub(crate) fn of(
        controller: &TransferFunction<BigRational>,
        width: &BigRational,
    ) -> Option<Self> {
        let [numerator, denominator] = whole(controller);
        let (leading, others) = denominator.split_first()?;
        if others.is_empty() {
            return Some(Self {
                terms: numerator,
                unit: BigRational::new(BigInt::one(), leading.clone()),
                error: BigRational::zero(),
            });
        }
        let growth = growth(leading, others)?;
        // So many bits that the errors of all steps together, and G times that of the state, stay
        // below a quarter of the width each.
        let whole_growth = growth.ceil().to_integer();
        let steps: BigInt = &whole_growth * &whole_growth * BigInt::from(MOST_TERMS) * 4;
        let bits = steps.bits() + width.recip().ceil().to_integer().bits();
        let one = BigInt::one() << bits;
        let unit = dyadic(BigInt::one(), bits);
        // Where the state is as small as this what comes after it is below a quarter of the width.
        let quarter = width.numer() * growth.denom() * &one;
        let enough = quarter.div_floor(&(width.denom() * growth.numer() * 4));
        let growth = to_wide(&growth);
        let error_of_a_term = growth.clone() * to_wide(&unit);
        let after = growth - Wide::new(BigInt::one(), BigInt::one());

        let mut state: VecDeque<BigInt> = others.iter().map(|_| BigInt::zero()).collect();
        let (mut terms, mut size) = (Vec::new(), BigInt::zero());
        for j in 0..usize::try_from(MOST_TERMS).ok()? {
            let driven = numerator.get(j).map_or_else(BigInt::zero, |n| n * &one);
            let past = others.iter().zip(&state);
            let rest = past.fold(driven, |rest, (d, c)| rest - d * c);
            let c = rest.div_floor(leading);
            size += c.abs();
            terms.push(c.clone());
            state.push_front(c);
            size -= state.pop_back()?.abs();
            if j + 1 >= numerator.len() && size <= enough {
                let count = Wide::new(BigInt::from(j) + 1, BigInt::one());
                let rounding = error_of_a_term.clone() * count;
                let state = Wide::new(size, one) + error_of_a_term;
                let error = from_wide(&(rounding + after * state))?;
                return Some(Self { terms, unit, error });
            }
        }
        None
    }
}

/// Numerator and denominator with whole coefficients, d₀ > 0.
fn whole(controller: &TransferFunction<BigRational>) -> [Vec<BigInt>; 2] {
    let both = [controller.numerator(), controller.denominator()].concat();
    let (mut numerator, _) = over_common(&both);
    let mut denominator = numerator.split_off(controller.numerator().len());
    if denominator.first().is_some_and(|d| d.is_negative()) {
        for c in numerator.iter_mut().chain(&mut denominator) {
            *c = -&*c;
        }
    }
    [numerator, denominator]
}

/// G of the derivation; `None` when a pole is so near to the unit circle that no power of the
/// companion matrix within the bounds is small.
fn growth(leading: &BigInt, others: &[BigInt]) -> Option<BigRational> {
    let to = |bits| growth_to(bits, leading, others);
    WIDTHS.into_iter().find_map(to)
}

/// The same with powers computed to so many bits after the point.
fn growth_to(bits: u64, leading: &BigInt, others: &[BigInt]) -> Option<BigRational> {
    let one = BigInt::one() << bits;
    let order = others.len();
    let mut power: Vec<Vec<BigInt>> = Vec::new();
    power.push(
        others
            .iter()
            .map(|d| (-d * &one).div_floor(leading))
            .collect(),
    );
    for row in 1..order {
        power.push(
            (0..order)
                .map(|k| {
                    if k + 1 == row {
                        one.clone()
                    } else {
                        BigInt::zero()
                    }
                })
                .collect(),
        );
    }
    // All in units of the last bit, rounded up. One entry of each column is rounded.
    let mut error = BigInt::one();
    let mut growth = one.clone();
    for _ in 0..MOST_DOUBLINGS {
        let computed = norm(&power);
        let bound = &computed + &error;
        if &bound + &bound <= one {
            return Some(fraction(growth, one - bound));
        }
        if &error + &error > one {
            return None;
        }
        // (A + E)² = A² + AE + E(A + E), and each entry of a column is rounded once.
        error = (&error * (computed + &bound)).div_ceil(&one) + order;
        growth = (&growth * (&one + bound)).div_ceil(&one);
        power = product(&power, bits);
    }
    None
}

/// The largest sum of magnitudes in a column.
fn norm(matrix: &[Vec<BigInt>]) -> BigInt {
    let mut columns: Vec<BigInt> = matrix.iter().map(|_| BigInt::zero()).collect();
    for row in matrix {
        for (sum, entry) in columns.iter_mut().zip(row) {
            *sum += entry.abs();
        }
    }
    columns.into_iter().max().unwrap_or_default()
}

/// The matrix times itself in fixed point, rounded down.
fn product(matrix: &[Vec<BigInt>], bits: u64) -> Vec<Vec<BigInt>> {
    let row_of = |row: &Vec<BigInt>| {
        let mut sums: Vec<BigInt> = row.iter().map(|_| BigInt::zero()).collect();
        for (factor, other) in row.iter().zip(matrix) {
            for (sum, entry) in sums.iter_mut().zip(other) {
                *sum += factor * entry;
            }
        }
        sums.into_iter().map(|sum| sum >> bits).collect()
    };
    matrix.iter().map(row_of).collect()
}
