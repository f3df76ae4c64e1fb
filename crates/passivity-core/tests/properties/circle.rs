//! TH-LTI: cosines of fractions of a turn, against those that are known.

use num_bigint::BigInt;
use passivity_core::circle::Circle;
use passivity_core::{BigRational, Interval};

use crate::common::{half, q, squared, zero};

#[test]
fn th_lti_cosines_are_enclosed() {
    let unit = |bits: u32| BigRational::new(1.into(), BigInt::from(1) << bits);
    for bits in [8, 64, 500] {
        let circle = Circle::to(bits);
        // Quarters and sixths are met.
        for (turns, cosine) in [
            (zero(), q(1, 1)),
            (q(1, 6), half()),
            (q(1, 4), zero()),
            (q(1, 3), -half()),
            (half(), q(-1, 1)),
            (q(2, 3), -half()),
            (q(7, 6), half()),
        ] {
            assert_eq!(circle.cosine(&turns), Interval::point(cosine), "{turns}");
        }
        // cos 45° and cos 30° by their squares, cos 36° by (1 + √5)/4.
        for (turns, squares) in [(q(1, 8), half()), (q(1, 12), q(3, 4))] {
            let found = circle.cosine(&turns);
            assert!(
                squared(found.lo()) < squares && squares < squared(found.hi()),
                "{turns}"
            );
            assert_eq!(found.hi() - found.lo(), unit(bits) * q(2, 1));
        }
        let found = circle.cosine(&q(1, 10));
        let root = |x: &BigRational| squared(&(x * q(4, 1) - q(1, 1)));
        assert!(root(found.lo()) < q(5, 1) && q(5, 1) < root(found.hi()));
        // And the other way round the circle.
        assert_eq!(
            circle.cosine(&q(9, 10)).lo().numer().sign(),
            num_bigint::Sign::Plus
        );
        let opposite = circle.cosine(&q(6, 10));
        let sum = opposite.middle() + found.middle();
        assert!(squared(&sum) <= squared(&(unit(bits) * q(2, 1))));
    }
}

/// Whole turns make no difference.
#[test]
fn th_lti_cosines_after_many_turns() {
    let circle = Circle::to(16);
    for turns in [q(1, 8), q(3, 10), q(9, 10)] {
        for more in [1, 2, 100] {
            let after = circle.cosine(&(&turns + q(more, 1)));
            assert_eq!(after, circle.cosine(&turns));
        }
    }
}
