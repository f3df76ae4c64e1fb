//! The linear motion over a time, enclosed: v′ = a − λv.
//!
//! v(h) = E·v₀ + P₁·a and x(h) − x(0) = P₁·v₀ + P₂·a with E = e^(−λh), P₁ = h·φ₁(−λh), P₂ = h²·φ₂(−λh).
//! No library's exponential is trusted: φ₂ is its alternating series with the first term left out as its
//! error, on an argument of at most ½, and longer times are reached by doubling, in which nothing
//! cancels.

use passivity_core::Scalar as _;
use passivity_sim::{Double, Enclosed};

/// An interval of doubles with outward rounding: the simulator's.
pub(crate) type Range = Enclosed<Double>;

pub(crate) fn range(lo: f64, hi: f64) -> Range {
    Range::of_doubles(lo, hi)
}

/// E, P₁ and P₂, each between its ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Propagator {
    pub(crate) decay: [f64; 2],
    pub(crate) first: [f64; 2],
    pub(crate) second: [f64; 2],
}

/// Beyond this, time constants of a motion do not matter: e^(−2⁶⁰).
const MOST_DOUBLINGS: u32 = 61;

impl Propagator {
    /// For λ ≥ 0 and h ≥ 0, each in its interval.
    pub(crate) fn new(rate: &Range, time: &Range) -> Self {
        let whole = rate.clone() * time.clone();
        let mut doublings = 0;
        let mut scale = 1.0;
        while whole.bounds()[1] * scale > 0.5 && doublings < MOST_DOUBLINGS {
            doublings += 1;
            scale *= 0.5;
        }
        // A power of two: exact.
        let scaled = |x: &Range| x.clone() * range(scale, scale);
        let (z, mut h) = (scaled(&whole), scaled(time));
        let one = Range::one;
        let phi2 = phi2(&z);
        let phi1 = one() - z.clone() * phi2.clone();
        let mut decay = one() - z * phi1.clone();
        let mut first = h.clone() * phi1;
        let mut second = h.clone() * h.clone() * phi2;
        for _ in 0..doublings {
            second = second.clone() + h.clone() * first.clone() + decay.clone() * second;
            first = first.clone() + decay.clone() * first;
            decay = decay.clone() * decay;
            h = h.clone() + h;
        }
        let above_zero = |x: &Range| {
            let [lo, hi] = x.bounds();
            [lo.max(0.0), hi]
        };
        Self {
            decay: above_zero(&decay),
            first: above_zero(&first),
            second: above_zero(&second),
        }
    }
}

/// φ₂(−z) = ½(1 − z/3·(1 − z/4·(1 − …))) for 0 ≤ z ≤ ½; an argument beyond gives no number.
fn phi2(z: &Range) -> Range {
    let [lo, hi] = z.bounds();
    if !(lo >= 0.0 && hi <= 0.5) {
        return range(f64::NAN, f64::NAN);
    }
    // The first term left out, zⁿ/(n + 2)!, bounds the error of an alternating sum of falling terms.
    let (mut terms, mut left_out) = (1, hi / 6.0);
    while left_out > 1e-20 && terms < 16 {
        terms += 1;
        left_out *= hi / f64::from(terms + 2);
    }
    let mut sum = Range::one();
    for n in (1..terms).rev() {
        sum = Range::one() - (z.clone() * sum).over(Range::integer(n + 2));
    }
    // Twice as much and more: the bound itself was rounded.
    let error = 2.0 * left_out + f64::MIN_POSITIVE;
    sum.half() + range(-error, error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_enclosures_hold_and_are_narrow() {
        for rate in [0.0, 1e-9, 0.003, 0.2, 0.49, 0.51, 3.0, 40.0, 5e4] {
            for time in [1e-3_f64, 0.3, 1.0, 7.0] {
                let z: f64 = rate * time;
                let found = Propagator::new(&range(rate, rate), &range(time, time));
                let phi1 = if z == 0.0 { 1.0 } else { -(-z).exp_m1() / z };
                // Where the difference cancels, the series to its fourth term.
                let phi2 = match z {
                    z if z < 0.01 => 0.5 - z / 6.0 + z * z / 24.0 - z.powi(3) / 120.0,
                    z => (1.0 - phi1) / z,
                };
                let want = [(-z).exp(), time * phi1, time * time * phi2];
                let ends = [found.decay, found.first, found.second];
                for ([lo, hi], want) in ends.into_iter().zip(want) {
                    // The library's exponential and the sums above are off by some ulp, and by z⁴/720.
                    let slack = 1e-10 * want;
                    assert!(
                        lo <= want + slack && want <= hi + slack,
                        "{rate} {time}: {lo} {want} {hi}"
                    );
                    assert!(hi - lo <= 1e-12 * want + 1e-300, "{rate} {time}: {lo} {hi}");
                }
            }
        }
    }

    #[test]
    fn a_rate_and_a_time_in_intervals_enclose_those_of_their_corners() {
        let (rates, times) = ([0.1, 0.4], [0.9, 1.1]);
        let all = Propagator::new(&range(rates[0], rates[1]), &range(times[0], times[1]));
        for (rate, time) in [(0.1, 0.9), (0.1, 1.1), (0.4, 0.9), (0.4, 1.1), (0.25, 1.0)] {
            let one = Propagator::new(&range(rate, rate), &range(time, time));
            for (all, one) in [
                (all.decay, one.decay),
                (all.first, one.first),
                (all.second, one.second),
            ] {
                assert!(all[0] <= one[0] && one[1] <= all[1]);
            }
        }
    }
}
