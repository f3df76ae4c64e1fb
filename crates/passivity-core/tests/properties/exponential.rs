//! TH-LAG: enclosures of e⁻ʸ and of roots, against figures that are known.

use num_bigint::BigInt;
use passivity_core::exponential::{decay, root};
use passivity_core::{BigRational, Interval};

use crate::common::{q, squared, zero};

/// A decimal of many digits.
fn decimal(digits: &str) -> BigRational {
    let scale = BigInt::from(10).pow(u32::try_from(digits.len()).unwrap());
    BigRational::new(digits.parse().unwrap(), scale)
}

fn unit(bits: u32) -> BigRational {
    BigRational::new(1.into(), BigInt::from(1) << bits)
}

#[test]
fn th_lag_decays_to_sixty_digits() {
    for (y, digits) in [
        (
            q(1, 1),
            "367879441171442321595523770161460867445811131031767834507836",
        ),
        (
            q(1, 2),
            "606530659712633423603799534991180453441918135487186955682892",
        ),
        (
            q(1, 10),
            "904837418035959573164249059446436621194705360980400952056257",
        ),
        (
            q(3, 1),
            "049787068367863942979342415650061776631699592188423215567627",
        ),
        (
            q(10, 1),
            "000045399929762484851535591515560550610237918088866564969259",
        ),
    ] {
        let known = decimal(digits);
        let last = BigRational::new(1.into(), BigInt::from(10).pow(60));
        for bits in [8, 64, 190] {
            let found = decay(&y, bits);
            assert!(found.hi() - found.lo() <= unit(bits), "{y} {bits}");
            assert!(
                *found.lo() <= &known + &last && known <= *found.hi(),
                "{y} {bits}: {found:?}"
            );
            assert!(
                zero() <= *found.lo() && *found.hi() <= q(1, 1),
                "{y} {bits}"
            );
        }
    }
    assert_eq!(*decay(&zero(), 64).hi(), q(1, 1));
    assert!(*decay(&zero(), 64).lo() > q(1, 1) - unit(63));
    // e > 2: from as many times as there are bits on, next to nothing.
    for y in [q(20, 1), q(21, 1)] {
        assert_eq!(decay(&y, 20), Interval::hull(zero(), unit(20)));
    }
    assert!(*decay(&q(39, 2), 20).hi() < unit(20));
}

#[test]
fn th_latency_roots_are_met_or_enclosed() {
    assert_eq!(root(&zero(), 8), Interval::point(zero()));
    assert_eq!(root(&q(9, 16), 2), Interval::point(q(3, 4)));
    // Not on a grid of two bits, but on one of three.
    assert_eq!(root(&q(9, 64), 3), Interval::point(q(3, 8)));
    assert_eq!(root(&q(9, 64), 2), Interval::hull(q(1, 4), q(1, 2)));
    for x in [q(2, 1), q(1, 3), q(85, 100), q(1, 1_000_000)] {
        for bits in [1, 10, 64] {
            let found = root(&x, bits);
            assert_eq!(found.hi() - found.lo(), unit(bits));
            assert!(squared(found.lo()) < x && x < squared(found.hi()));
        }
    }
}

/// 1 − y ≤ e⁻ʸ ≤ 1 − y + ½y², where y is far below the unit that is computed with.
#[test]
fn th_lag_decays_of_next_to_nothing() {
    for bits in [30, 50, 100, 200] {
        let y = unit(bits);
        for to in [4, 16, 64] {
            let found = decay(&y, to);
            assert!(*found.lo() <= q(1, 1) - &y + squared(&y) * q(1, 2));
            assert!(*found.hi() >= q(1, 1) - &y);
        }
    }
}

/// e⁻¹⁹⁹ is between 2⁻²⁸⁸ and 2⁻²⁸⁷, far below the unit of an enclosure of 200 bits.
#[test]
fn th_lag_decays_to_next_to_nothing() {
    let found = decay(&q(199, 1), 200);
    assert!(*found.lo() < unit(287) && unit(288) < *found.hi());
}
