//! The power series of a motion on a short piece: its values, its stops and its integrals.

use std::cmp::Ordering;

use crate::number::{Real, Undecided};

/// The series of ξ on a piece: ξ(τ) = Σ c_n·(τ/h)ⁿ, and of the output likewise; without an amplifier
/// the output is one constant.
pub(super) struct Series<R> {
    pub(super) xi: Vec<R>,
    pub(super) output: Vec<R>,
    pub(super) h: R,
}

/// How many terms leave less than 2^−bits when each is at most half the one before, over n.
pub(super) fn terms(bits: u32) -> i32 {
    let mut n = 3_u32;
    let mut gained = 0;
    while gained < bits + 4 {
        gained += 1 + n.ilog2();
        n += 1;
    }
    i32::try_from(n + 1).unwrap_or(i32::MAX)
}

/// Σ cₙsⁿ.
pub(super) fn horner<'a, R: Real + 'a>(
    coefficients: impl DoubleEndedIterator<Item = &'a R>,
    s: &R,
) -> R {
    let terms = coefficients.rev();
    terms.fold(R::zero(), |sum, c| sum * s.clone() + c.clone())
}

/// The index of a term as a factor; a series has some hundred terms.
fn factor(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

impl<R: Real> Series<R> {
    /// ξ̇ at the fraction `s`.
    pub(super) fn velocity(&self, s: &R) -> R {
        self.derivative(s, 1).over(self.h.clone())
    }

    /// A derivative of ξ by the fraction.
    fn derivative(&self, s: &R, order: usize) -> R {
        let mut sum = R::zero();
        for (n, c) in self.xi.iter().enumerate().skip(order).rev() {
            // n(n − 1)…, a factor for each order.
            let falling = (0..order).map(|i| factor(n - i)).product();
            sum = sum * s.clone() + c.clone() * R::integer(falling);
        }
        sum
    }

    /// The fraction at which the velocity, of sign `direction` at first, becomes 0.
    pub(super) fn stop(&self, direction: Ordering) -> Result<Option<R>, Undecided> {
        let one = self.h.whole(1);
        let end = self.derivative(&one, 1).sign().ok_or(Undecided)?;
        let high = if end == direction || end == Ordering::Equal {
            // It may have been to 0 and back: only if it slowed down first and sped up later.
            let slows =
                self.derivative(&R::zero(), 2).sign().ok_or(Undecided)? == direction.reverse();
            let speeds_up = self.derivative(&one, 2).sign().ok_or(Undecided)? == direction;
            if !(slows && speeds_up) {
                return Ok(None);
            }
            let slowest = self.crossing(2, direction.reverse(), &one)?;
            if self.derivative(&slowest, 1).sign().ok_or(Undecided)? == direction {
                return Ok(None);
            }
            slowest
        } else {
            one
        };
        self.crossing(1, direction, &high).map(Some)
    }

    /// Where a derivative of sign `before` at 0 ceases to have it, between 0 and `high`: Newton's
    /// iteration, with bisection whenever it leaves the bracket or shrinks it too little.
    fn crossing(&self, order: usize, before: Ordering, high: &R) -> Result<R, Undecided> {
        let (mut low, mut high) = (R::zero(), high.clone());
        let mut at = (low.clone() + high.clone()).half();
        for _ in 0..2 * high.bits() {
            let value = self.derivative(&at, order);
            match value.sign().ok_or(Undecided)? {
                Ordering::Equal => return Ok(at),
                sign if sign == before => low = at.clone(),
                _ => high = at.clone(),
            }
            let width = high.clone() - low.clone();
            if width.approximate() <= at.approximate() * (-f64::from(at.bits())).exp2() {
                break;
            }
            let slope = self.derivative(&at, order + 1);
            let mut next = (low.clone() + high.clone()).half();
            if slope.sign().ok_or(Undecided)? != Ordering::Equal {
                let newton = at.clone() - value.over(slope);
                let step = (newton.clone() - at.clone()).approximate().abs();
                let inside = newton.compare(&low).ok_or(Undecided)?.is_gt()
                    && newton.compare(&high).ok_or(Undecided)?.is_lt();
                if inside {
                    if step <= at.approximate() * (-f64::from(at.bits())).exp2() {
                        return Ok(newton);
                    }
                    next = newton;
                }
            }
            at = next;
        }
        Ok(at)
    }

    /// ∫ξ̇² and ∫yξ̇ from 0 to the fraction `s`: products of the series.
    pub(super) fn integrals(&self, s: &R) -> (R, R) {
        // Coefficients of ξ̇·h.
        let numbered = self.xi.iter().enumerate().skip(1);
        let rates: Vec<R> = numbered
            .map(|(n, c)| c.clone() * R::integer(factor(n)))
            .collect();
        // The coefficient of sⁿ⁺¹ in the integral of a product is that of sⁿ in it, over n + 1.
        let integral = |coefficient: &dyn Fn(usize) -> R| {
            let mut sum = R::zero();
            for n in (0..rates.len()).rev() {
                let over = s.ratio(1, factor(n + 1));
                sum = sum * s.clone() + coefficient(n) * over;
            }
            sum * s.clone()
        };
        // Of the coefficient of sⁿ in the product with the rates, so many products.
        let products = |with: &[R], n: usize, count: usize| {
            let pairs = with.iter().zip(rates.iter().take(n + 1).rev());
            pairs
                .take(count)
                .fold(R::zero(), |sum, (x, y)| sum + x.clone() * y.clone())
        };
        let square = integral(&|n| {
            // Every pair but that of the middle is there twice.
            let half = n.div_ceil(2);
            let twice = products(&rates, n, half).double();
            match rates.get(half) {
                Some(middle) if n % 2 == 0 => twice + middle.square(),
                _ => twice,
            }
        });
        let work = if let [constant] = self.output.as_slice() {
            constant.clone() * (horner(self.xi.iter().skip(1), s) * s.clone())
        } else {
            integral(&|n| products(&self.output, n, n + 1))
        };
        (square.over(self.h.clone()), work)
    }
}
