//! What a digital controller costs of viscous friction, frequency by frequency (TH-LTI).
//!
//! Summed over a motion at rest for ever before its start, the force of a controller H draws at most
//! Σ λ(θ)·|D̂(θ)|², where D̂ is the spectrum of the displacements Dₕ and
//!
//! λ(θ) = ½H(1) + Σ gⱼ cos jθ = Re[(1 − e^(−iθ))H(e^(iθ))] / (2(1 − cos θ)),
//!
//! gⱼ the tail sums. Viscous friction takes β at every frequency. So it is enough exactly when
//! β ≥ λ, the largest of all λ(θ). With x = cos θ and H = N/D it is a question about a polynomial on
//! [−1, 1], because Q(x) = |D(e^(iθ))|² is a polynomial in x and positive there.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::interval::Interval;
use crate::polynomial::Polynomial;
use crate::rational;
use crate::scalar::{Ordered as _, Scalar};
use crate::sturm::{self, SignOver};
use crate::transfer::TransferFunction;
use crate::whole::{fraction, over_common};

/// λ(θ) = R(x)/Q(x) with x = cos θ, dimensionless as β is.
///
/// # Example
///
/// A delay of one sample and virtual damping of ½KT cost 5/4, not 2; at the angle 60°.
///
/// ```
/// use passivity_core::{BigRational, Interval, Scalar};
/// use passivity_core::{frequency::ViscousCost, transfer::TransferFunction};
///
/// let [one, five] = [1, 5].map(BigRational::integer);
/// let half = one.clone().half();
/// let width = half.clone().half().half().half();
/// let late = TransferFunction::damped(&half).unwrap().delayed(1);
/// let cost = ViscousCost::of(&late);
/// let least = five.half().half();
/// assert!(cost.decide(&least).is_nonnegative());
/// assert_eq!(cost.enclosure(&width), Interval::point(least));
/// assert_eq!(cost.worst(&width), [Interval::point(half)]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ViscousCost {
    /// R, in x = cos θ.
    numerator: Polynomial,
    /// Q, in x = cos θ; positive on [−1, 1].
    denominator: Polynomial,
    /// ½H(1), the mean of λ(θ) over all angles.
    mean: BigRational,
}

impl ViscousCost {
    /// The cost of a controller.
    #[must_use]
    pub fn of(controller: &TransferFunction<BigRational>) -> Self {
        // From the tail sums, Σ gⱼz⁻ʲ = T/D: R = ½H(1)·|D|² + Re(T·D̄). Nothing is divided out.
        let mean = controller.at_one().half();
        let tails = controller.tails();
        let d = controller.denominator();
        let denominator = real_part_of_product(d, d);
        let modulated = real_part_of_product(tails.numerator(), d);
        Self {
            numerator: &denominator.scaled(&mean) + &modulated,
            denominator,
            mean,
        }
    }

    /// λ(θ) at x = cos θ in [−1, 1].
    #[must_use]
    pub fn at(&self, cosine: &BigRational) -> BigRational {
        self.numerator
            .written_at(cosine)
            .over(self.denominator.written_at(cosine))
    }

    /// P = βQ − R, not negative at x = cos θ exactly when β ≥ λ(θ).
    #[must_use]
    pub fn spare(&self, beta: &BigRational) -> Polynomial {
        &self.denominator.scaled(beta) - &self.numerator
    }

    /// Whether β ≥ λ(θ) at every frequency, exactly, with the certificate or the cos θ where not.
    #[must_use]
    pub fn decide(&self, beta: &BigRational) -> SignOver {
        sturm::sign_over(&self.spare(beta), &cosines())
    }

    /// Whether β ≥ λ(θ) at every frequency, exactly: what [`decide`](Self::decide) says, without the
    /// certificate, and in less time away from the border.
    #[must_use]
    pub fn is_enough(&self, beta: &BigRational) -> bool {
        let spare = self.spare(beta);
        let plain = spare.is_plainly_positive();
        plain.unwrap_or_else(|| sturm::sign_over(&spare, &cosines()).is_nonnegative())
    }

    /// Whether λ(θ) ≥ β at every angle whose cosine is in an interval of [−1, 1].
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{BigRational, Interval, Scalar, frequency::ViscousCost};
    /// use passivity_core::transfer::TransferFunction;
    ///
    /// // A delay of one sample: λ(θ) = ½ + cos θ.
    /// let cost = ViscousCost::of(&TransferFunction::wall().delayed(1));
    /// let number = BigRational::integer;
    /// let right = Interval::hull(number(1).half(), number(1));
    /// assert!(cost.is_at_least(&number(1), &right));
    /// assert!(!cost.is_at_least(&number(1), &Interval::hull(number(0), number(1))));
    /// ```
    #[must_use]
    pub fn is_at_least(&self, beta: &BigRational, cosines: &Interval<BigRational>) -> bool {
        let over = self.spare(beta).scaled(&-BigRational::one());
        if cosines.is_point() {
            return over.sign_at(cosines.lo()) != Ordering::Less;
        }
        sturm::sign_over(&over, cosines).is_nonnegative()
    }

    /// Where β ≤ λ(θ): intervals of cos θ, from left to right, too wide by at most `width` at either
    /// end.
    #[must_use]
    pub fn short_at(&self, beta: &BigRational, width: &BigRational) -> Vec<Interval<BigRational>> {
        sturm::not_positive(&self.spare(beta), &cosines(), width)
    }

    /// An enclosure of λ, the least β that is enough at every frequency; at most `width` > 0 wide.
    ///
    /// A point where λ is the simplest fraction of what would be enclosed. Both ends are decided
    /// exactly: the upper one is enough, and the lower one is not, or is λ.
    #[must_use]
    pub fn enclosure(&self, width: &BigRational) -> Interval<BigRational> {
        let enough = |beta: &BigRational| self.is_enough(beta);
        // No mean and no value is above the largest one.
        let ends = cosines();
        let [at_lo, at_hi] = [ends.lo(), ends.hi()].map(|end| self.at(end));
        let mut lo = Scalar::max(Scalar::max(at_lo, at_hi), self.mean.clone());
        if enough(&lo) {
            return Interval::point(lo);
        }
        // Most often a peak is easily found, and nothing is above it.
        let peak = self.at(&self.peak(width));
        let quarter = width.clone().half().half();
        lo = Scalar::max(lo, (&peak / &quarter).floor() * &quarter);
        let mut step = width.clone().half();
        let mut hi = &lo + &step;
        while !enough(&hi) {
            step = step.double();
            lo = hi.clone();
            hi = &lo + &step;
        }
        // By halves, and in between from a value that is reached: in the middle of a narrow band
        // where β is short λ(θ) is all but largest.
        let mut halve = false;
        while (&hi - &lo).compare(width) == Some(Ordering::Greater) {
            let mut probe = (&lo + &hi).half();
            if !halve {
                lo = Scalar::max(lo.clone(), self.reached_above(&lo, width));
                let beyond = &lo + width.clone().half();
                probe = Scalar::min(beyond, (&lo + &hi).half());
            }
            halve = !halve;
            if enough(&probe) {
                hi = probe;
            } else {
                lo = probe;
            }
        }
        // A value that is reached may be the largest.
        if peak <= lo && enough(&lo) {
            return Interval::point(lo);
        }
        let simple = rational::simplest_above(&lo, &hi);
        if !enough(&simple) {
            return Interval::hull(simple, hi);
        }
        if sturm::has_root(&self.spare(&simple), &cosines()) {
            return Interval::point(simple);
        }
        Interval::hull(lo, simple)
    }

    /// A cos θ near which λ(θ) is largest, as far as a search from the best of a grid on finds it, by about `width` of λ.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{BigRational, Scalar, frequency::ViscousCost, transfer::TransferFunction};
    ///
    /// // A delay of one sample and damping of ½KT: 60°.
    /// let half = BigRational::integer(1).half();
    /// let late = TransferFunction::damped(&half).unwrap().delayed(1);
    /// assert_eq!(ViscousCost::of(&late).peak(&half), half);
    /// ```
    #[must_use]
    pub fn peak(&self, width: &BigRational) -> BigRational {
        let at = |x: BigRational| (self.at(&x), x);
        let grid = (-32..=32_i32).map(|n| at(BigRational::new(n.into(), 32.into())));
        let higher = |a: (BigRational, BigRational), b| if b > a { b } else { a };
        let Some(mut best) = grid.reduce(higher) else {
            return BigRational::one();
        };
        // It is off by the square of what cos θ is.
        let mut step = BigRational::new(1.into(), 64.into());
        let ends = cosines();
        while &step * &step > *width {
            let (_, x) = &best;
            let near = [x - &step, x + &step].into_iter();
            let near = near.filter(|x| ends.lo() <= x && x <= ends.hi());
            let near: Vec<_> = near.map(at).collect();
            best = near.into_iter().fold(best, higher);
            step = step.half();
        }
        best.1
    }

    /// The largest λ(θ) in the middle of a band where β is short, rounded down to whole quarters of
    /// `width`.
    fn reached_above(&self, beta: &BigRational, width: &BigRational) -> BigRational {
        let bands = self.short_at(beta, width).into_iter();
        let middles = bands.map(|band| self.at(&band.middle()));
        let most = middles.fold(beta.clone(), Scalar::max);
        let quarter = width.clone().half().half();
        (most / &quarter).floor() * quarter
    }

    /// Where λ(θ) is largest: intervals of cos θ, from left to right, that together hold every such
    /// frequency and only such where λ(θ) is within `width` of λ; single ones are about as wide.
    #[must_use]
    pub fn worst(&self, width: &BigRational) -> Vec<Interval<BigRational>> {
        self.short_at(self.enclosure(width).lo(), width)
    }
}

/// All x = cos θ.
fn cosines() -> Interval<BigRational> {
    Interval::hull(-BigRational::one(), BigRational::one())
}

/// Re[a(w)·b(w̄)] at w = e^(−iθ), as a polynomial in cos θ; from the coefficients of w⁰, w¹, ….
fn real_part_of_product(a: &[BigRational], b: &[BigRational]) -> Polynomial {
    let [(a, of_a), (b, of_b)] = [a, b].map(over_common);
    let length = a.len().max(b.len());
    let mut series: Vec<BigInt> = Vec::new();
    series.resize(length, BigInt::ZERO);
    for (i, left) in a.iter().enumerate() {
        for (j, right) in b.iter().enumerate() {
            // wⁱ·w̄ʲ has the real part cos((i − j)θ).
            if let Some(slot) = series.get_mut(i.abs_diff(j)) {
                *slot += left * right;
            }
        }
    }
    let series: Vec<_> = series.into_iter().map(BigRational::from_integer).collect();
    Polynomial::of_cosines(&series).scaled(&fraction(1.into(), of_a * of_b))
}
