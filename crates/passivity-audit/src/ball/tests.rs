//! Balls against exact fractions.

use super::*;
use crate::log::near_rational;
use crate::number::{Number, Written as _};
use crate::span::Span;
use passivity_core::{Ordered as _, Scalar};
use proptest::prelude::*;

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn exact(x: f64) -> BigRational {
    num_rational::BigRational::from_float(x).unwrap()
}

/// Whether a number is in a ball, where that is defined.
fn holds(ball: Ball, x: &BigRational) -> bool {
    if !ball.is_defined() {
        return true;
    }
    let off = x - exact(ball.middle);
    Scalar::abs(&off) <= exact(ball.radius)
}

proptest! {
    #[test]
    fn a_number_close_to_a_whole_one_is_known_to_be_on_its_side(
        n in prop_oneof![-3..3_i64, any::<i32>().prop_map(i64::from), any::<i64>()],
        k in 20..120_u32, m in 1..1000_i64, above: bool,
    ) {
        let off = BigRational::new(m.into(), num_bigint::BigInt::from(1000) << k);
        let whole = ratio(n, 1);
        let x = if above { &whole + &off } else { &whole - &off };
        let ball = Ball::of_reading(&Number::from(x.clone()));
        prop_assert!(holds(ball, &x));
        let floor = ball.floor();
        prop_assert!(holds(floor, &x.floor()));
        // A position of up to a million ticks that is 2^-80 of one away from a border at the least is known. Just below
        // zero there are doubles far closer to it than to the tick below.
        let is_known = floor.is_defined() || n == 0 && !above;
        prop_assert!(is_known || n.abs() > 1_000_000 || k > 70);
        // The same on the grid, where the number is on it.
        let units = &x * BigRational::from_integer(num_bigint::BigInt::from(1) << 64);
        if let (true, Ok(middle)) = (n.abs() < 1 << 40, i128::try_from(units.floor().to_integer())) {
            let span = Span::centred(middle, 2);
            let ball = Ball::of_span(span);
            prop_assert!(holds(ball, &x));
            prop_assert!(holds(ball.floor(), &x.floor()));
            let is_known = ball.floor().is_defined() || n == 0 && !above;
            prop_assert!(is_known || !span.is_within_a_tick() || n.abs() > 1_000_000);
        }
    }
}

/// A number, and a ball around it, perhaps a wide one.
fn around() -> impl Strategy<Value = (BigRational, Ball)> {
    let n = prop_oneof![-40..40_i64, any::<i32>().prop_map(i64::from), any::<i64>()];
    let wide = prop_oneof![
        Just(0.0),
        (0..60_i32, 0..3_u8).prop_map(|(bits, n)| f64::from(n) * 2_f64.powi(-bits))
    ];
    let off = -1.0..1.0_f64;
    (n, prop_oneof![1..40_i64, 1..1_000_000_000_i64], wide, off).prop_map(|(n, d, radius, off)| {
        let ball = Ball::ratio(n, d);
        // A middle that is off by at most the radius which is added, and what their sum rounds.
        let moved = Ball::exactly(off * radius) + ball;
        let radius = if radius > 0.0 {
            (moved.radius + radius) * OUTWARD
        } else {
            moved.radius
        };
        (ratio(n, d), Ball { radius, ..moved })
    })
}

proptest! {
    #[test]
    fn every_operation_holds_the_exact_result((x, a) in around(), (y, b) in around()) {
        prop_assert!(holds(a, &x) && holds(b, &y));
        let zero = ratio(0, 1);
        let mut operations = vec![
            (a + b, &x + &y),
            (a - b, &x - &y),
            (a * b, &x * &y),
            (-a, -&x),
            (a.half(), x.clone().half()),
            (a.floor(), x.floor()),
            (Scalar::abs(&a), Scalar::abs(&x)),
            (Scalar::max(a, b), Scalar::max(x.clone(), y.clone())),
            (Scalar::min(a, b), Scalar::min(x.clone(), y.clone())),
            (a.square(), x.square()),
        ];
        if y != zero {
            operations.push((a.over(b), &x / &y));
        }
        for (i, (found, exact)) in operations.into_iter().enumerate() {
            prop_assert!(holds(found, &exact), "operation {}: {:?} for {}", i, found, exact);
        }
        if let Some(found) = a.compare(&b) {
            prop_assert_eq!(found, x.cmp(&y));
        }
        if let Some(found) = a.is_nonnegative() {
            prop_assert_eq!(found, x >= zero);
        }
        if let Some(found) = a.is_positive() {
            prop_assert_eq!(found, x > zero);
        }
        if let Some(found) = a.on_grid() {
            let [lo, hi] = found.map(crate::span::on_grid);
            prop_assert!(lo <= x && x <= hi);
        }
    }

    #[test]
    fn numbers_of_a_log_are_known_to_a_few_roundings(n: i64, d in 1..i64::MAX, middle: i64) {
        let narrow = |ball: Ball, x: &BigRational, roundings: f64| {
            holds(ball, x) && ball.radius <= roundings * ROUNDING * ball.middle.abs()
        };
        prop_assert!(narrow(Ball::ratio(n, d), &ratio(n, d), 1.0));
        prop_assert_eq!(Ball::ratio(n, d), Ball::of_rational(&ratio(n, d)));
        prop_assert!(narrow(Ball::of_rational(&ratio(n, d)), &ratio(n, d), 1.0));
        prop_assert!(known_to_a_few_roundings(middle));
    }
}

/// Whether the ball around a span of no width is as narrow as it has to be: two roundings. Of a number that is within two
/// radii of a whole one, which are four roundings and what the number itself is rounded by, it may be moved: reaching
/// three radii at the most, below a power of two that is up to twice as much. The bounds' own roundings are the tenths.
fn known_to_a_few_roundings(middle: i64) -> bool {
    let middle = i128::from(middle) << 40;
    let (x, ball) = (
        crate::span::on_grid(middle),
        Ball::of_span(Span::centred(middle, 0)),
    );
    let off = near_rational(&(&x - x.round())).abs();
    let roundings = match off <= 4.6 * ROUNDING * ball.middle.abs() {
        true => 12.1,
        false => 2.1,
    };
    holds(ball, &x) && ball.radius <= roundings * ROUNDING * ball.middle.abs()
}

#[test]
fn numbers_next_to_a_whole_one_are_known_to_a_few_roundings() {
    // This one is moved to a side of a whole number: more than three roundings wide.
    assert!(known_to_a_few_roundings(-1_412_185_931_686_869_888));
}

proptest! {
    #[test]
    fn short_numbers_stay_exact(a in -1_000_000..1_000_000_i64, b in -1_000_000..1_000_000_i64, bits in 0..30_u32) {
        // A number with so many bits behind the point, as that of a tick or its half.
        let [a, b] = [a, b].map(|n| (ratio(n, 1 << bits), Ball::ratio(n, 1 << bits)));
        for (found, exact) in [
            (a.1 + b.1, &a.0 + &b.0),
            (a.1 - b.1, &a.0 - &b.0),
            (a.1 * b.1, &a.0 * &b.0),
            (a.1.half(), a.0.clone().half()),
        ] {
            prop_assert!(found.radius == 0.0 && holds(found, &exact));
        }
        // And is on the grid.
        prop_assert_eq!(a.1.to_reduced().map(|x| x.to_rational()), Some(a.0));
    }
}

#[test]
fn whole_numbers_and_rest_are_exact() {
    for ball in [
        Ball::ratio(12, 4),
        Ball::of_span(Span::centred(3 << BITS, 0)),
    ] {
        assert_eq!(ball.floor().middle, 3.0);
    }
    assert_eq!(Ball::ratio(12, 4), Ball::exactly(3.0));
    let moved = Ball::ratio(1, 3);
    let rest = moved.one_of() - moved.one_of();
    assert_eq!((rest * moved).is_nonnegative(), Some(true));
    assert_eq!((-(rest * moved)).is_nonnegative(), Some(true));
    assert_eq!(rest.on_grid(), Some([0, 0]));
}

#[test]
fn what_cannot_be_told_stays_so() {
    let third = Ball::ratio(1, 3);
    let open = third - third;
    for undefined in [
        third.over(open),
        third.over(Ball::zero()),
        Ball::exactly(f64::MAX) * Ball::exactly(f64::MAX),
        (third + third + third).floor(),
        Ball::zero() * third.over(open),
    ] {
        assert_eq!(undefined.sign(), None, "{undefined:?}");
        assert_eq!((undefined + third).sign(), None);
        assert_eq!(Scalar::max(undefined, third).sign(), None);
        assert_eq!((-undefined).on_grid(), None);
        assert_eq!(undefined.near(), None);
    }
    assert_eq!(open.sign(), None);
    assert_eq!(Ball::exactly(1e12).on_grid(), None);
}

proptest! {
    #[test]
    fn equal_fractions_are_one_ball(n: i64, d in 1..i64::MAX, times in 1..1_000_000_i64, bits in 0..62_u32) {
        for (n, d) in [(n, d), (n >> 20, d >> 20), (n >> 24, 1 << bits)] {
            let d = d.max(1);
            let (Some(m), Some(e)) = (n.checked_mul(times), d.checked_mul(times)) else { continue };
            prop_assert_eq!(Ball::ratio(n, d), Ball::ratio(m, e));
        }
    }

    #[test]
    fn a_double_is_itself(x: f64, y in prop::num::f64::NORMAL) {
        for x in [x, y] {
            let Some(number) = Number::from_f64(x) else {
                prop_assert!(!x.is_finite());
                continue;
            };
            prop_assert_eq!(number.to_rational(), exact(x));
            prop_assert_eq!(number == Number::from(exact(x)), true);
            let ball = Ball::of(&number);
            prop_assert!(holds(ball, &exact(x)));
            // But for the least of them.
            prop_assert!(ball == Ball::exactly(x) || x.abs() < 1e-250);
        }
    }
}
