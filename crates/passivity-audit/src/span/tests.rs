//! Spans against exact fractions.

use super::*;
use proptest::prelude::*;

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// A number, and a span around it that is up to some units wide.
fn spanned() -> impl Strategy<Value = (BigRational, Span)> {
    let n = prop_oneof![-40..40_i64, any::<i32>().prop_map(i64::from), any::<i64>()];
    let wide = [0..3_u32, 0..3, 0..66].prop_map(|[a, b, bits]| {
        let of = |n: u32| i128::from(n) << bits;
        [of(a), of(b)]
    });
    (n, 1..1_000_000_000_i64, wide).prop_map(|(n, d, [below, above])| {
        let [lo, hi] = Span::ratio(n, d).ends();
        (ratio(n, d), Span::between(lo - below, hi + above))
    })
}

proptest! {
    #[test]
    fn every_operation_holds_the_exact_result((x, a) in spanned(), (y, b) in spanned()) {
        let is_right = |span: Span, x: &BigRational| !span.is_defined() || span.holds(x);
        prop_assert!(is_right(a, &x) && is_right(b, &y));
        let zero = BigRational::integer(0);
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
        for (found, exact) in operations {
            prop_assert!(is_right(found, &exact));
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
    }

    #[test]
    fn short_numbers_keep_their_digits(n in -1_000_000..1_000_000_i64, m in 1..1_000_000_i64) {
        // The radius of b is a unit at most, and rounding adds one more for each product of three: of a
        // factor's radius with the other factor, of both radii, and what is cut off. That of 1/a is below 4.
        let (a, b) = (Span::whole(n), Span::ratio(1, m));
        for (found, width) in [(a + b, 2), (a - b, 2), (b * b, 8), (b.over(a), 16)] {
            prop_assert!(n == 0 || found.width().is_some_and(|found| found <= width));
        }
        prop_assert!((a * b).width().is_some_and(|found| found <= 2 * i128::from(n.abs()) + 2));
    }
}

#[test]
fn what_does_not_fit_is_undefined() {
    let large = Span::whole(i64::MAX);
    for found in [
        large * large,
        large + large,
        large.over(Span::between(1, 1)),
        large
            .over(Span::between(1 << 80, 1 << 80))
            .over(Span::between(1 << 20, 1 << 20)),
        Span::between(0, 1 << 70),
        large.over(Span::whole(0)),
    ] {
        assert_eq!(found.sign(), None);
        assert_eq!((found + large).sign(), None);
        assert_eq!(found.below(), None);
    }
    assert_eq!(Span::between(-1, 0).floor().sign(), None);
}
