//! TH-START: the speed that an unforced motion never passes, in squares.

use passivity_core::verdict::{Speeds, decide};
use passivity_core::{BigRational, Criterion, Fixed, Scalar, spring, start};
use proptest::prelude::*;

use crate::common::{half, nonnegative, number, position, positive, q, sampled, squared, zero};

fn criterion() -> impl Strategy<Value = Criterion<BigRational>> {
    let coefficient = || prop_oneof![1 => Just(zero()), 6 => number()];
    (coefficient(), coefficient()).prop_map(|(viscous, coulomb)| Criterion { viscous, coulomb })
}

/// Whether the criterion holds at every speed in (0, V], by its ends: it is linear in the speed.
fn holds_on(criterion: &Criterion<BigRational>, bound: &BigRational) -> bool {
    let at_bound = &criterion.viscous * bound + &criterion.coulomb;
    let near_rest =
        criterion.coulomb > zero() || (criterion.coulomb == zero() && criterion.viscous >= zero());
    near_rest && at_bound >= zero()
}

sampled! {
    fn th_start_speed_squared(mu in positive(), xi in position(), v in number()) {
        let expected = squared(&v) + squared(&xi) / &mu;
        prop_assert_eq!(start::speed_squared(&mu, &xi, &v), expected.clone());
        // ½μV² is the storage at the start, so while storage never grows the speed stays below V.
        prop_assert_eq!(spring::storage(&mu, &xi, &v), half() * mu * expected);
    }

    fn th_start_speed_stays_below_v(
        mu in positive(), xi in position(), v in number(), later in position(), w in number()
    ) {
        let v2 = start::speed_squared(&mu, &xi, &v);
        if spring::storage(&mu, &later, &w) <= spring::storage(&mu, &xi, &v) {
            prop_assert!(squared(&w) <= v2);
        }
    }

    fn th_start_margin_of_squares(criterion in criterion(), v2 in nonnegative()) {
        let expected = squared(&criterion.coulomb) - squared(&criterion.viscous) * &v2;
        prop_assert_eq!(start::margin_of_squares(&criterion, &v2), expected);
    }

    fn th_start_squares_say_what_roots_would(criterion in criterion(), v in positive()) {
        let v2 = squared(&v);
        prop_assert_eq!(start::holds_up_to(&criterion, &v2), Some(holds_on(&criterion, &v)));
        let decided = |speeds| decide(&criterion, &speeds).unwrap().holds;
        prop_assert_eq!(decided(Speeds::UpToSquared(v2)), holds_on(&criterion, &v));
        prop_assert_eq!(decided(Speeds::UpTo(v.clone())), holds_on(&criterion, &v));
    }

    fn th_start_at_its_critical_speed(viscous in positive(), coulomb in positive()) {
        // −viscous·V + coulomb ≥ 0 with equality at V = coulomb/viscous.
        let v2 = squared(&(&coulomb / &viscous));
        let criterion = Criterion { viscous: -viscous, coulomb };
        prop_assert_eq!(start::holds_up_to(&criterion, &v2), Some(true));
        prop_assert_eq!(start::holds_up_to(&criterion, &(v2 * q(1_000_001, 1_000_000))), Some(false));
    }

    fn th_start_without_deflection_is_10(mu in positive(), v in number()) {
        prop_assert_eq!(start::speed_squared(&mu, &zero(), &v), squared(&v));
    }
}

#[test]
fn th_start_every_combination_of_signs() {
    let case = |viscous: i32, coulomb: i32, v2: i32| {
        let criterion = Criterion {
            viscous: Fixed::integer(viscous),
            coulomb: Fixed::integer(coulomb),
        };
        start::holds_up_to(&criterion, &Fixed::integer(v2)).unwrap()
    };
    for (viscous, coulomb, up_to_4) in [
        (-1, -1, false),
        (-1, 0, false),
        (-1, 1, false),
        (-1, 2, true),
        (-1, 3, true),
        (0, -1, false),
        (0, 0, true),
        (0, 1, true),
        (1, -1, false),
        (1, -9, false),
        (1, 0, true),
        (1, 1, true),
    ] {
        assert_eq!(case(viscous, coulomb, 4), up_to_4, "{viscous} {coulomb}");
    }
    // At V = 0 the answer is that of arbitrarily small speeds.
    assert!(!case(-1, 0, 0) && !case(0, -1, 0) && !case(5, -1, 0));
    assert!(case(-1, 1, 0) && case(0, 0, 0) && case(1, 0, 0));
    let undefined = Criterion {
        viscous: Fixed::new(1, 0),
        coulomb: Fixed::integer(1),
    };
    assert_eq!(start::holds_up_to(&undefined, &Fixed::integer(1)), None);
}
