//! Intervals and three-valued truth.

use passivity_core::{Fixed, Interval, Scalar, Truth};
use proptest::prelude::*;

use crate::common::{number, q, sampled, zero};

sampled! {
    fn num_exact_interval_keeps_its_ends(a in number(), b in number()) {
        let interval = Interval::new(a.clone(), b.clone());
        prop_assert_eq!(interval.is_some(), a <= b);
        if let Some(interval) = interval {
            prop_assert_eq!((interval.lo(), interval.hi()), (&a, &b));
            prop_assert_eq!(interval.is_point(), a == b);
            let truth = match (a >= zero(), b >= zero()) {
                (true, _) => Truth::Holds,
                (false, true) => Truth::Depends,
                (false, false) => Truth::Fails,
            };
            prop_assert_eq!(interval.is_nonnegative(), Some(truth));
        }
    }

    fn num_exact_interval_hull_orders_its_ends(a in number(), b in number()) {
        let hull = Interval::hull(a.clone(), b.clone());
        let (lo, hi) = if a <= b { (a, b) } else { (b, a) };
        prop_assert_eq!((hull.lo(), hull.hi()), (&lo, &hi));
        let point = Interval::point(lo.clone());
        prop_assert!(point.is_point() && point.lo() == &lo && point.hi() == &lo);
    }
}

#[test]
fn num_exact_interval_edge_cases() {
    assert!(Interval::new(q(1, 1), q(1, 1)).is_some_and(|i| i.is_point()));
    let at_zero = Interval::new(q(-1, 1), zero()).unwrap();
    assert_eq!(at_zero.is_nonnegative(), Some(Truth::Depends));
    assert!(Interval::new(Fixed::new(1, 0), Fixed::one()).is_none());
    assert_eq!(Interval::point(Fixed::new(1, 0)).is_nonnegative(), None);
    assert!(!Interval::point(Fixed::new(1, 0)).is_point());
}

#[test]
fn num_exact_truth_of_the_two_ends() {
    let table = [
        (true, true, Truth::Holds, "holds"),
        (true, false, Truth::Holds, "holds"),
        (false, true, Truth::Depends, "depends"),
        (false, false, Truth::Fails, "fails"),
    ];
    for (worst, best, truth, name) in table {
        assert_eq!(Truth::over(worst, best), truth);
        assert_eq!(truth.name(), name);
    }
}
