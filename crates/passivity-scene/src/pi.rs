//! Rational enclosures of π, as tight as one asks for.

use num_bigint::BigInt;
use passivity_core::{BigRational, Interval};

/// Consecutive convergents of π, below and above it: tight for their size, so that the first
/// levels stay within machine integers.
const CONVERGENTS: [(i64, i64, i64, i64); 3] = [
    (333, 106, 355, 113),
    (103_993, 33_102, 104_348, 33_215),
    (80_143_857, 25_510_582, 5_419_351, 1_725_033),
];

/// The highest level: an enclosure of width about 2⁻²⁰⁴⁸.
pub const MAX_LEVEL: usize = 9;

/// The level used for figures that are printed: at least 60 digits.
pub const PRINT_LEVEL: usize = 5;

/// A rational enclosure lo < π < hi; each level is tighter than the one before it.
///
/// Levels past [`MAX_LEVEL`] give that of `MAX_LEVEL`.
///
/// # Example
///
/// ```
/// let pi = passivity_scene::pi::enclosure(0);
/// assert_eq!(pi.lo().to_string(), "333/106");
/// assert_eq!(pi.hi().to_string(), "355/113");
/// ```
#[must_use]
pub fn enclosure(level: usize) -> Interval<BigRational> {
    let level = level.min(MAX_LEVEL);
    if let Some(&(a, b, c, d)) = CONVERGENTS.get(level) {
        return Interval::hull(ratio(a, b), ratio(c, d));
    }
    // 64, 128, … bits at levels 3, 4, …; Machin's formula in fixed point.
    let bits = 32_u64 << (level - 2);
    let (lo, hi) = machin(bits);
    let scale = BigInt::from(1) << bits;
    Interval::hull(
        BigRational::new(lo, scale.clone()),
        BigRational::new(hi, scale),
    )
}

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// Bounds of π·2^bits by π = 16·arctan(1/5) − 4·arctan(1/239).
fn machin(bits: u64) -> (BigInt, BigInt) {
    // Each series has fewer terms than bits, each off by less than 1 unit in the last place, and
    // the first term left out is below 1 as well: 20 spare bits cover (16 + 4)·(bits + 1) units
    // for every width used here.
    const SPARE: u64 = 20;
    let one = BigInt::from(1) << (bits + SPARE);
    let pi = arctan_inverse(&one, 5) * 16 - arctan_inverse(&one, 239) * 4;
    let slack = BigInt::from(20 * (bits + SPARE + 1));
    let lo = (&pi - &slack) >> SPARE;
    let hi = ((pi + slack) >> SPARE) + 1;
    (lo, hi)
}

/// arctan(1/n) in units of 1/`one`, by its alternating series.
fn arctan_inverse(one: &BigInt, n: u32) -> BigInt {
    let square = n * n;
    let mut power = one / n;
    let mut sum = BigInt::ZERO;
    let mut k = 1_u32;
    while power != BigInt::ZERO {
        let term = &power / k;
        if k % 4 == 1 {
            sum += term;
        } else {
            sum -= term;
        }
        power /= square;
        k += 2;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_level_lies_within_the_one_before() {
        for level in 1..=MAX_LEVEL {
            let (outer, inner) = (enclosure(level - 1), enclosure(level));
            assert!(
                outer.lo() < inner.lo() && inner.hi() < outer.hi(),
                "level {level}"
            );
        }
    }

    #[test]
    fn the_printed_level_has_sixty_digits_of_pi() {
        // Digits from the first 60 decimals of π as tabulated.
        let digits = "3141592653589793238462643383279502884197169399375105820974944";
        let scale = BigInt::from(10).pow(60);
        let pi = BigRational::new(digits.parse().unwrap(), scale.clone());
        let ulp = BigRational::new(1.into(), scale);
        let e = enclosure(PRINT_LEVEL);
        assert!(*e.lo() > &pi - &ulp && *e.hi() < &pi + &ulp + &ulp);
    }
}
