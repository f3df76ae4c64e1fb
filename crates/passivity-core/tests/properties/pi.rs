//! Numbers with π in them where the first enclosure of π is too wide.

use std::cmp::Ordering::{Equal, Greater, Less};

use num_bigint::BigInt;
use passivity_core::fraction::Integer as _;
use passivity_core::pi::{Polynomial, pi};
use passivity_core::{BigRational, Exact, Ordered as _, Scalar};

use crate::common::{magnitude, q};
use crate::exact::{BITS, PI};

fn whole(n: i64) -> Polynomial {
    Polynomial::whole(BigInt::from(n))
}

#[test]
fn num_exact_pi_whole_numbers_are_known_at_once() {
    assert_eq!(whole(0).as_whole(), Some(BigInt::ZERO));
    assert_eq!(whole(-7).as_whole(), Some(BigInt::from(-7)));
    assert_eq!(Polynomial::power(1).as_whole(), None);
    assert_eq!(whole(0).signum(), Some(Equal));
    assert_eq!(whole(-7).signum(), Some(Less));
    assert_eq!(Polynomial::power(2).signum(), Some(Greater));
}

/// The first enclosure of π has 64 bits: too few from here on.
#[test]
fn num_exact_pi_enclosures_as_narrow_as_asked() {
    let pi = pi();
    for digits in [80, 200] {
        let found = pi.enclosure(digits).unwrap();
        let width = found.hi() - found.lo();
        assert!(width * BigRational::from_integer(BigInt::from(1) << digits) <= *found.hi());
        assert!(*found.lo() < *PI && *PI < *found.hi());
    }
}

/// The order of the rationals' own type, which recurses, took all of the stack for so many digits.
#[test]
fn num_exact_pi_of_many_digits_is_enclosed() {
    let digits = 20_000;
    let found = pi().enclosure(digits).unwrap();
    let width = found.hi() - found.lo();
    let scaled = width * BigRational::from_integer(BigInt::from(1) << digits);
    assert_ne!(scaled.compare(found.lo()), Some(Greater));
    assert_eq!(pi().enclosure(1 << 19), None);
}

/// ⌊π·2^bits⌋.
fn cut(bits: u32) -> BigInt {
    (&*PI * BigRational::from_integer(BigInt::from(1) << bits)).to_integer()
}

/// a + bπ.
fn linear(a: &BigInt, b: &BigInt) -> Polynomial {
    let of_pi = Polynomial::whole(b.clone()).mul(&Polynomial::power(1));
    of_pi.unwrap().add(&Polynomial::whole(a.clone())).unwrap()
}

/// A divisor that is zero at the lower end of the first enclosure of π.
#[test]
fn num_exact_pi_floor_of_a_divisor_next_to_zero() {
    let scale = BigInt::from(1) << 64;
    let divisor = linear(&-cut(64), &scale);
    let divided = |n: i64| whole(n).div_floor(&divisor).unwrap();
    let near = &*PI * BigRational::from_integer(scale) - BigRational::from_integer(cut(64));
    for n in [1, 3, 1000, -1000] {
        let expected = (q(n, 1) / &near).floor().to_integer();
        assert_eq!(divided(n).as_whole(), Some(expected), "{n}");
    }
    assert_eq!(whole(1).div_floor(&whole(0)), None);
    assert_eq!(whole(1).div_floor(&whole(-1)), None);
}

/// Quotients that are as near to a whole number as the ends of the first enclosures tell, of terms of all
/// signs: n = k·d ± a little.
#[test]
fn num_exact_pi_floors_beside_whole_numbers() {
    let value = |a: &BigInt, b: &BigInt| {
        BigRational::from_integer(a.clone()) + &*PI * BigRational::from_integer(b.clone())
    };
    let mut below = 0;
    for (i, (slope, other)) in [
        (3, -5),
        (-3, 5),
        (7, 2),
        (-7, -2),
        (1, -90),
        (-90, 1),
        (40, -41),
        (-41, 40),
    ]
    .into_iter()
    .enumerate()
    {
        for offset in [9, 40, 400, 900] {
            // d = offset + 16·slope·π/…, above zero; both in units of 2⁻²⁰⁰.
            let scale = BigInt::from(1) << 200;
            let (b_d, b_n) = (&scale * slope, &scale * other);
            let a_d = &scale * (offset + 300);
            let d = value(&a_d, &b_d);
            assert!(d > q(0, 1));
            for k in [-7_i64, -1, 1, 2, 50] {
                for (j, bits) in (56..72).enumerate() {
                    let little = d.clone() / BigRational::from_integer(BigInt::from(1) << bits);
                    let little = if (i + j) % 2 == 0 { little } else { -little };
                    // n = a + b·π is k·d and a little.
                    let a_n = (&d * q(k, 1) + little - value(&BigInt::ZERO, &b_n)).to_integer();
                    let near = value(&a_n, &b_n) / &d;
                    let expected = near.floor().to_integer();
                    below += i32::from(expected < BigInt::from(k));
                    let floor = linear(&a_n, &b_n).div_floor(&linear(&a_d, &b_d)).unwrap();
                    assert_eq!(
                        floor.as_whole(),
                        Some(expected),
                        "{slope} {other} {offset} {k} {bits}"
                    );
                }
            }
        }
    }
    assert!(below > 100);
}

/// The enclosure of a number, for print, is as tight as was asked for, whatever the sizes of its terms.
#[test]
fn num_exact_pi_enclosures_are_relative() {
    let rational = |x: &BigRational| Exact::of(x);
    for (n, d) in [
        // (π − 355/113)/(22/7 − π), both small and of either sign, and with ends of either sign.
        (pi() - rational(&q(355, 113)), rational(&q(22, 7)) - pi()),
        (rational(&q(355, 113)) - pi(), pi() * pi() * pi()),
        (pi(), rational(&q(1, 1 << 40)) * pi() * pi()),
        (
            rational(&q(-3, 1)) * pi() + rational(&q(1, 5)),
            pi() + rational(&q(1, 7)),
        ),
        (rational(&q(1, 1)), rational(&q(355, 113)) - pi()),
    ] {
        let x = n.over(d);
        for digits in [1, 20, 64, 200] {
            let found = x.enclosure(digits).unwrap();
            assert!(
                Exact::of(found.lo()) < x && x < Exact::of(found.hi()),
                "{x:?}"
            );
            // Numerator and denominator are known to that part, and the quotient to twice that, at most
            // half as much again for the part of the part.
            let width = (found.hi() - found.lo()) / magnitude(found.lo());
            let scale = BigRational::from_integer(BigInt::from(1) << digits);
            assert!(width * scale < q(5, 1), "{x:?} {digits}");
        }
    }
}

/// 2⁻⁷⁰⁰ from π: more than 256 bits are needed to tell.
#[test]
fn num_exact_pi_signs_beside_pi() {
    for bits in [70, 300, 700, BITS - 100] {
        let scale = BigInt::from(1) << bits;
        for (off, sign) in [(0, Greater), (1, Less)] {
            let near = BigRational::new(cut(bits) + off, scale.clone());
            assert_eq!(
                (pi() - Exact::of(&near)).compare(&Exact::zero()),
                Some(sign),
                "{bits}"
            );
        }
    }
}

/// Quotients that an enclosure of few bits tells, that it has one below, and that none tells.
#[test]
fn num_exact_pi_quotients_by_hand() {
    let divided = |n: Polynomial, d: Polynomial| n.div_floor(&d).unwrap().as_whole();
    assert_eq!(divided(whole(7), whole(2)), Some(BigInt::from(3)));
    assert_eq!(divided(whole(-7), whole(2)), Some(BigInt::from(-4)));
    let zero = BigInt::ZERO;
    let turns = |n: i64| linear(&zero, &(BigInt::from(n) << 80));
    let above = linear(&BigInt::from(1), &(BigInt::from(5) << 80));
    assert_eq!(divided(above, turns(1)), Some(BigInt::from(5)));
    assert_eq!(divided(turns(5), turns(1)), Some(BigInt::from(5)));
}

#[test]
fn num_exact_pi_is_below_zero() {
    assert_eq!((-pi()).compare(&Exact::zero()), Some(Less));
}

#[test]
fn num_exact_pi_is_enclosed_on_either_side_of_zero() {
    for x in [pi(), -pi()] {
        let found = x.enclosure(8).unwrap();
        assert!(Exact::of(found.lo()) < x && x < Exact::of(found.hi()));
        assert!(found.hi() - found.lo() < q(1, 16));
    }
}
