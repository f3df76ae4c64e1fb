//! TH-ACTIVE: the cycle that draws energy, checked from the held force and friction alone.

use passivity_core::witness::{gain, gain_formula, quantized, smooth};
use passivity_core::{BigRational, Friction};
use proptest::prelude::*;

use crate::common::{
    coefficient, friction, half, magnitude, position, positive, q, sampled, squared, unit, zero,
};

/// The operator's gain: work of the force held at either end, less friction both ways (23).
fn gain_by_hand(
    from: &BigRational,
    to: &BigRational,
    friction: &Friction<BigRational>,
) -> BigRational {
    let d = to - from;
    let there = -(from.floor() + half()) * &d;
    let back = -(to.floor() + half()) * -&d;
    let spent = &friction.beta * squared(&d) + &friction.sigma * magnitude(&d);
    there + back - q(2, 1) * spent
}

/// The least whole m for which a cycle of m + a ticks gains, for some a in (0, 1].
fn least_ticks(friction: &Friction<BigRational>) -> Option<BigRational> {
    let missing = q(2, 1) * &friction.sigma - q(1, 1);
    let per_tick = q(1, 1) - q(2, 1) * &friction.beta;
    if missing < zero() {
        Some(zero())
    } else if per_tick > zero() {
        Some((missing / per_tick).floor() + q(1, 1))
    } else {
        None
    }
}

sampled! {
    fn th_active_gain_is_that_of_the_forces(from in position(), to in position(), friction in friction()) {
        prop_assert_eq!(gain(&from, &to, &friction), gain_by_hand(&from, &to, &friction));
    }

    fn th_active_formula(n in -9i64..9, m in 0i64..200, a in unit(), friction in friction()) {
        let (m, d) = (q(m, 1), q(m, 1) + &a);
        let formula = &d * (&m + q(1, 1) - q(2, 1) * &friction.beta * &d - q(2, 1) * &friction.sigma);
        prop_assert_eq!(gain_formula(&m, &a, &friction), formula.clone());
        let (from, to) = (q(n, 1) - a, q(n, 1) + m);
        prop_assert_eq!(gain_by_hand(&from, &to, &friction), formula);
    }

    /// Without a bound there is a witness exactly when β < ½ or σ < ½.
    fn th_active_witness_exists(friction in friction()) {
        let found = quantized(&friction, None);
        prop_assert_eq!(found.is_some(), friction.beta < half() || friction.sigma < half());
        if let Some(cycle) = found {
            prop_assert!(cycle.from >= zero() && cycle.to >= q(1, 1));
            prop_assert_eq!(cycle.gain.clone(), gain_by_hand(&cycle.from, &cycle.to, &friction));
            prop_assert!(cycle.gain > zero());
        }
    }

    /// Under a speed bound there is one exactly when the least cycle that gains is below it.
    fn th_active_witness_within_a_bound(friction in friction(), bound in positive()) {
        let found = quantized(&friction, Some(&bound));
        let exists = least_ticks(&friction).is_some_and(|m| m < bound);
        prop_assert_eq!(found.is_some(), exists);
        if let Some(cycle) = found {
            prop_assert!(&cycle.to - &cycle.from <= bound);
            prop_assert_eq!(cycle.gain.clone(), gain_by_hand(&cycle.from, &cycle.to, &friction));
            prop_assert!(cycle.gain > zero());
        }
    }

    /// Where the criterion holds at every speed no cycle at all gains.
    fn th_active_no_gain_where_passive(
        from in position(), to in position(), beta in coefficient(), sigma in coefficient()
    ) {
        let friction = Friction::new(beta + half(), sigma + half());
        prop_assert!(gain(&from, &to, &friction) <= zero());
    }
}

#[test]
fn th_active_exact_cycles() {
    let at = |beta, sigma| quantized(&Friction::new(beta, sigma), None).unwrap();
    // σ short: m = 0, half of the room (1 − 2σ)/(2β) = 1/6.
    let cycle = at(q(3, 5), q(2, 5));
    assert_eq!(
        (cycle.from, cycle.to, cycle.gain),
        (q(11, 12), q(1, 1), q(1, 120))
    );
    // Half of the room is 5/24; rounded down to a unit fraction, 1/5.
    let cycle = at(q(3, 5), q(1, 4));
    assert_eq!(
        (cycle.from, cycle.to, cycle.gain),
        (q(4, 5), q(1, 1), q(13, 250))
    );
    // No friction: a whole tick, one unit of force held all the way back.
    let cycle = at(zero(), zero());
    assert_eq!(
        (cycle.from, cycle.to, cycle.gain),
        (zero(), q(1, 1), q(1, 1))
    );
    // β short: the least m with m/5 > 1/5 is 2, with room 1/4 for a.
    let cycle = at(q(2, 5), q(3, 5));
    assert_eq!((cycle.from, cycle.to), (q(7, 8), q(3, 1)));
    assert_eq!(cycle.gain, q(17, 8) * q(1, 10));
    // On the corner and beyond it there is none.
    assert_eq!(quantized(&Friction::new(half(), half()), None), None);
    // A bound of exactly m leaves nothing.
    let friction = Friction::new(q(2, 5), q(3, 5));
    assert_eq!(quantized(&friction, Some(&q(2, 1))), None);
    assert_eq!(
        quantized(&friction, Some(&q(33, 16))).unwrap().from,
        // 1/16 is left, and a move of just the bound is too fast where it turns round.
        q(16, 17)
    );
}

/// Strictly below the bound, and nothing where what is left gains nothing.
#[test]
fn th_active_bounds_are_strict() {
    let friction = |beta, sigma| Friction::new(beta, sigma);
    let found = quantized(&friction(q(1, 5), zero()), Some(&q(1, 5))).unwrap();
    assert_eq!(
        (found.from, found.to, found.gain),
        (q(5, 6), q(1, 1), q(7, 45))
    );
    // m = 2 and a < 2·(1 − 2β) … : with a bound of two ticks there is no room.
    assert_eq!(quantized(&friction(q(2, 5), q(3, 5)), Some(&q(2, 1))), None);
    assert!(quantized(&friction(q(2, 5), q(3, 5)), Some(&q(5, 2))).is_some());
    // 0 → d → 0 gains 2(½d² − βd² − σd): nothing at d = σ/(½ − β), and beyond it more and more.
    let smooth = |sigma, bound: Option<BigRational>| {
        let found = smooth(&friction(q(1, 4), sigma), bound.as_ref())?;
        assert_eq!(found.from, zero());
        Some((found.to, found.gain))
    };
    assert_eq!(smooth(zero(), None), Some((q(1, 1), half())));
    assert_eq!(smooth(q(1, 8), None), Some((q(1, 1), q(1, 4))));
    assert_eq!(smooth(q(1, 8), Some(q(1, 1))), Some((q(3, 4), q(3, 32))));
    assert_eq!(smooth(q(1, 8), Some(half())), None);
    assert_eq!(smooth(zero(), Some(half())), Some((q(1, 4), q(1, 32))));
}
