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

sampled! {
    /// Middle ± radius are the ends, and the hull of two intervals has the least and the greatest of
    /// their four ends.
    fn num_exact_interval_middle_radius_and_hull(a in number(), b in number(), c in number(), d in number()) {
        let (ab, cd) = (Interval::hull(a.clone(), b.clone()), Interval::hull(c.clone(), d.clone()));
        prop_assert_eq!(&(ab.middle() - ab.radius()), ab.lo());
        prop_assert_eq!(&(ab.middle() + ab.radius()), ab.hi());
        let mut ends = [a, b, c, d];
        ends.sort();
        let both = ab.joined(&cd);
        prop_assert_eq!((both.lo(), both.hi()), (&ends[0], &ends[3]));
    }
}

#[test]
fn num_exact_interval_maps_both_ends_or_none() {
    let interval = Interval::hull(q(1, 1), q(2, 1));
    let halves = interval.try_map(|x| (*x < q(3, 1)).then(|| x / q(2, 1)));
    assert_eq!(halves, Some(Interval::hull(q(1, 2), q(1, 1))));
    assert_eq!(
        interval.try_map(|x| (*x < q(2, 1)).then(|| x.clone())),
        None
    );
}

#[test]
fn num_exact_interval_edge_cases() {
    let from_zero = Interval::new(zero(), q(1, 1)).unwrap();
    assert_eq!(from_zero.is_nonnegative(), Some(Truth::Holds));
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
