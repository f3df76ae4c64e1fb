//! The power series of a motion on a short piece: its values, its stops and its integrals.

use std::cmp::Ordering;

use crate::real::{Real, Undecided};

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
pub(super) fn horner<R: Real>(coefficients: &[R], s: &R) -> R {
    let mut sum = s.zero();
    for c in coefficients.iter().rev() {
        sum = sum * s.clone() + c.clone();
    }
    sum
}

impl<R: Real> Series<R> {
    /// ξ̇ at the fraction `s`.
    pub(super) fn velocity(&self, s: &R) -> R {
        self.derivative(s, 1) / self.h.clone()
    }

    /// The first or second derivative of ξ by the fraction.
    fn derivative(&self, s: &R, order: usize) -> R {
        let mut sum = s.zero();
        for (n, c) in self.xi.iter().enumerate().skip(order).rev() {
            let n = i32::try_from(n).unwrap_or(i32::MAX);
            let factor = if order == 1 { n } else { n * (n - 1) };
            sum = sum * s.clone() + c.clone() * s.ratio(factor, 1);
        }
        sum
    }

    /// The fraction at which the velocity, of sign `direction` at first, becomes 0.
    pub(super) fn stop(&self, direction: Ordering) -> Result<Option<R>, Undecided> {
        let one = self.h.one();
        let end = self.derivative(&one, 1).sign()?;
        let high = if end == direction || end == Ordering::Equal {
            // It may have been to 0 and back: only if it slowed down first and sped up later.
            let slows = self.derivative(&self.h.zero(), 2).sign()? == direction.reverse();
            let speeds_up = self.derivative(&one, 2).sign()? == direction;
            if !(slows && speeds_up) {
                return Ok(None);
            }
            let slowest = self.crossing(2, direction.reverse(), &one)?;
            if self.derivative(&slowest, 1).sign()? == direction {
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
        let half = high.ratio(1, 2);
        let (mut low, mut high) = (high.zero(), high.clone());
        let mut at = (low.clone() + high.clone()) * half.clone();
        for _ in 0..2 * high.bits() {
            let value = self.derivative(&at, order);
            match value.sign()? {
                Ordering::Equal => return Ok(at),
                sign if sign == before => low = at.clone(),
                _ => high = at.clone(),
            }
            let width = high.clone() - low.clone();
            if width.approximate() <= at.approximate() * (-f64::from(at.bits())).exp2() {
                break;
            }
            let slope = self.slope(&at, order);
            let mut next = (low.clone() + high.clone()) * half.clone();
            if slope.sign()? != Ordering::Equal {
                let newton = at.clone() - value / slope;
                let step = (newton.clone() - at.clone()).approximate().abs();
                let inside = newton.compare(&low)? == Ordering::Greater
                    && newton.compare(&high)? == Ordering::Less;
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

    /// The derivative of [`Self::derivative`].
    fn slope(&self, s: &R, order: usize) -> R {
        let mut sum = s.zero();
        for (n, c) in self.xi.iter().enumerate().skip(order + 1).rev() {
            let n = i32::try_from(n).unwrap_or(i32::MAX);
            let factor = if order == 1 {
                n * (n - 1)
            } else {
                n * (n - 1) * (n - 2)
            };
            sum = sum * s.clone() + c.clone() * s.ratio(factor, 1);
        }
        sum
    }

    /// ∫ξ̇² and ∫yξ̇ from 0 to the fraction `s`: products of the series.
    pub(super) fn integrals(&self, s: &R) -> (R, R) {
        // Coefficients of ξ̇·h.
        let mut rates = Vec::with_capacity(self.xi.len());
        for (n, c) in self.xi.iter().enumerate().skip(1) {
            let n = i32::try_from(n).unwrap_or(i32::MAX);
            rates.push(c.clone() * s.ratio(n, 1));
        }
        // The coefficient of sⁿ⁺¹ in the integral of a product is that of sⁿ in it, over n + 1.
        let integral = |coefficient: &dyn Fn(usize) -> R| {
            let mut sum = s.zero();
            for n in (0..rates.len()).rev() {
                let over = s.ratio(1, i32::try_from(n + 1).unwrap_or(i32::MAX));
                sum = sum * s.clone() + coefficient(n) * over;
            }
            sum * s.clone()
        };
        let dot = |a: &[R], b: &[R]| {
            let pairs = a.iter().zip(b.iter().rev());
            pairs.fold(s.zero(), |sum, (x, y)| sum + x.clone() * y.clone())
        };
        let square = integral(&|n| {
            // Every pair but that of the middle is there twice.
            let half = n.div_ceil(2);
            let pairs = dot(&rates[..half], &rates[n + 1 - half..=n]);
            let twice = pairs.clone() + pairs;
            if n % 2 == 0 {
                twice + rates[half].clone() * rates[half].clone()
            } else {
                twice
            }
        });
        let work = if let [constant] = self.output.as_slice() {
            constant.clone() * (horner(&self.xi[1..], s) * s.clone())
        } else {
            integral(&|n| dot(&self.output[..=n], &rates[..=n]))
        };
        (square / self.h.clone(), work)
    }
}
