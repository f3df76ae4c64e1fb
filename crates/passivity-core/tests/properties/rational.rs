//! NUM-EXACT: the simplest fraction of an interval, against all of small denominators.

use passivity_core::rational::simplest_above;

use crate::common::q;

#[test]
fn num_exact_the_simplest_fraction_above() {
    let mut met = 0;
    for d in 1..=12_i64 {
        for n in 0..=3 * d {
            let lo = q(n, d);
            for (wide, parts) in [
                (1, 1),
                (5, 2),
                (1, 2),
                (1, 3),
                (2, 7),
                (1, 10),
                (1, 60),
                (1, 97),
                (1, 132),
            ] {
                let hi = &lo + q(wide, parts);
                // The first denominator that has a numerator, and its least one.
                let expected = (1..).find_map(|d| {
                    let above =
                        q((&lo * q(d, 1)).floor().to_integer().try_into().unwrap(), 1) + q(1, 1);
                    let found = above / q(d, 1);
                    (found <= hi).then_some(found)
                });
                let found = simplest_above(&lo, &hi);
                met += i32::from(found == hi);
                assert_eq!(Some(found), expected, "({lo}, {hi}]");
            }
        }
    }
    assert!(met > 50, "{met}");
}

/// A whole number that is the upper end itself.
#[test]
fn num_exact_the_simplest_fraction_is_the_upper_end() {
    assert_eq!(simplest_above(&q(1, 2), &q(1, 1)), q(1, 1));
}
