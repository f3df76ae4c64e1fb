//! TH-START: the speed that an unforced motion never passes, in squares.

use passivity_core::extra_storage::{damping_storage, delay_storage};
use passivity_core::quantizer::held_force;
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

    fn th_start_memory_is_storage_at_the_start(
        mu in positive(), xi in position(), v in number(),
        past in prop::collection::vec(position(), 1..5), damping in nonnegative()
    ) {
        let extra = delay_storage(&past) + damping_storage(&damping, &past);
        let v2 = start::speed_squared_with_memory(&mu, &xi, &v, &extra);
        prop_assert_eq!(half() * &mu * &v2, spring::storage(&mu, &xi, &v) + extra);
        // After rest there is none.
        let rested = delay_storage(&vec![zero(); past.len()]);
        let without = start::speed_squared(&mu, &xi, &v);
        prop_assert_eq!(start::speed_squared_with_memory(&mu, &xi, &v, &rested), without.clone());
        prop_assert!(v2 >= without);
    }

    /// A force that is one sample late, and no viscous friction: in the first interval the
    /// velocity changes by (force − friction)/μ, whatever the sample before the start was.
    fn th_start_late_force_stays_below_v_with_memory(
        mu in positive(), before in position(), sigma in positive()
    ) {
        let force = held_force(&before);
        let pushed = if force > zero() { &force - &sigma } else { -&force - &sigma };
        if pushed > zero() {
            // The speed after a time τ ≤ 1, from rest at ξ = 0, squared; the criterion holds up to
            // it where −(3/2)V + σ − ½ ≥ 0.
            let extra = delay_storage(std::slice::from_ref(&before));
            let v2 = start::speed_squared_with_memory(&mu, &zero(), &zero(), &extra);
            let criterion = Criterion { viscous: q(-3, 2), coulomb: &sigma - half() };
            if start::holds_up_to(&criterion, &v2) == Some(true) {
                prop_assert!(squared(&(pushed / &mu)) <= v2);
            }
        }
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

/// From rest at ξ = 0, with a force that is one sample late and ten ticks away a sample before:
/// the speed of a device that remembers rest is 0 for ever, and this one is at 8 after a sample.
#[test]
fn th_start_forgets_nothing_that_the_controller_remembers() {
    let (mu, sigma) = (q(1, 1), q(3, 2));
    let speed = (held_force(&q(-10, 1)) - &sigma) / &mu;
    assert_eq!(speed, q(8, 1));
    assert_eq!(start::speed_squared(&mu, &zero(), &zero()), zero());
    let extra = delay_storage(&[q(10, 1)]);
    let v2 = start::speed_squared_with_memory(&mu, &zero(), &zero(), &extra);
    assert_eq!(v2, q(100, 1));
    assert!(squared(&speed) <= v2);
    // The criterion, −(3/2)V + 1 ≥ 0, held at V = 0 and does not hold at the speed that is true.
    let criterion = Criterion {
        viscous: q(-3, 2),
        coulomb: q(1, 1),
    };
    assert_eq!(start::holds_up_to(&criterion, &zero()), Some(true));
    assert_eq!(start::holds_up_to(&criterion, &v2), Some(false));
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
