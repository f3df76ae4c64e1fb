//! The paper's slips, kept as exact numbers: ERR-21/22, ERR-27, ERR-19-start, ERR-IV-C.

use passivity_core::generation::{
    bound_22, generated, generated_as_in_19, generated_linear, generated_quantized,
};
use passivity_core::quantizer::held_force;
use passivity_core::{
    BigRational, Criterion, Fixed, Friction, Law, Loop, Scalar, Step, ledger, spring,
};
use proptest::prelude::*;

use crate::common::{half, position, q, sampled, squared, zero};
use crate::law::law;

#[test]
fn err_21_22_counterexample() {
    let step = Step::new(q(1, 1), q(1, 2));
    // By (18), by (19) with (20), and by the kernel's form.
    let by_18 = generated(
        &held_force(&step.start),
        &step,
        &spring::quantized_potential(&step.start),
        &spring::quantized_potential(&step.end),
    );
    assert_eq!(by_18, q(1, 2));
    assert_eq!(generated_as_in_19(&step), q(1, 2));
    assert_eq!(generated_quantized(&step), q(1, 2));
    let d = step.displacement();
    assert_eq!(half() * squared(&d) + q(1, 4), q(3, 8));
    assert_eq!(bound_22(&d), q(3, 8));
}

/// All pairs of positions on a grid of 1/16 tick over [−3, 3]: 425 of 9409 violate (22), none the
/// same bound against the linear spring; the excess is at most 1/8.
#[test]
fn err_21_22_exhausted_on_a_grid() {
    let (mut pairs, mut violations, mut largest) = (0, 0, Fixed::zero());
    for a in -48i128..=48 {
        for b in -48i128..=48 {
            let step = Step::new(Fixed::new(a, 16), Fixed::new(b, 16));
            let bound = bound_22(&step.displacement());
            let excess = generated_quantized(&step) - bound;
            pairs += 1;
            violations += i32::from(excess > Fixed::zero());
            largest = Scalar::max(largest, excess);
            assert!(generated_linear(&step) <= bound);
        }
    }
    assert_eq!((pairs, violations), (9409, 425));
    assert_eq!(largest, Fixed::new(1, 8));
}

#[test]
fn err_27_counterexample() {
    let step = Step::new(q(1, 1), q(1, 2));
    let friction = Friction::new(q(3, 5), q(3, 5));
    let criterion = Criterion::of_friction(&friction);
    let d = step.displacement();
    // At mean speed ½ the margin of (8), multiplied by the speed, is ½·1/10 + 1/10.
    assert_eq!(criterion.margin(&half()), q(3, 20));
    assert_eq!(criterion.margin(&half()) / half(), q(1, 10) + q(2, 10));
    assert_eq!(friction.dissipated_lower(&d, &half()), q(9, 20));
    assert_eq!(generated_quantized(&step), q(1, 2));
    let interval = ledger::HeldInterval::plain(step, q(1, 1));
    let row = ledger::row(&Loop::plain(friction), &interval);
    assert_eq!(row.net_quantized, q(-1, 20));
    assert_eq!(row.net_linear, q(3, 40));
    assert_eq!(row.violates_quantized(), Some(true));
    assert_eq!(row.violates_linear(), Some(false));
}

#[test]
fn err_19_start_counterexample() {
    // ξ(h) = ½ at speed 1; the account opens at h + 3/5 and closes at h + 1.
    let (sample, start, end) = (q(1, 2), q(1, 2) + q(3, 5), q(3, 2));
    let step = Step::new(start, end);
    let of = |potential: fn(&_) -> _| {
        generated(
            &held_force(&sample),
            &step,
            &potential(&step.start),
            &potential(&step.end),
        )
    };
    let bound = bound_22(&step.displacement());
    assert_eq!(bound, q(7, 25));
    assert_eq!(of(spring::quantized_potential), q(2, 5));
    assert_eq!(of(spring::linear_potential), q(8, 25));
    assert!(of(spring::linear_potential) > bound);
    // (19) at the same two positions gives something else: its start is no sampling instant.
    assert_ne!(generated_as_in_19(&step), q(2, 5));
    // From the sampling instant on, the account is in order.
    let whole = Step::new(sample, step.end.clone());
    assert!(generated_linear(&whole) <= bound_22(&whole.displacement()));
}

/// Out of the wall a tick a sample, from the depth n at which it was switched on, with β = σ = ½: the
/// criterion holds at every speed, and the operator draws ½n², at an unchanged speed.
#[test]
fn err_iv_c_counterexample() {
    let friction = Friction::new(half(), half());
    let criterion = Criterion::of_friction(&friction);
    assert_eq!(criterion.margin_at_all_speeds(), zero());
    for depth in 1..9 {
        let drawn = (1..=depth).fold(zero(), |drawn, n| {
            let step = Step::new(q(n, 1), q(n - 1, 1));
            let given = held_force(&step.start) * step.displacement();
            drawn + given - friction.dissipated_at_constant_velocity(&q(-1, 1), &q(1, 1))
        });
        assert_eq!(drawn, half() * squared(&q(depth, 1)));
        // That is what the wall had when it was switched on, and nothing was stored before.
        let injected = Law::bilateral().switching_energy(false, true, &q(depth, 1));
        assert_eq!(drawn, injected);
    }
}

/// The same with any friction: ½n² + n(1 − β − σ), above zero from some depth on.
#[test]
fn err_iv_c_whatever_friction() {
    for (beta, sigma) in [(0, 0), (1, 7), (8, 3), (9, 16)].map(|(b, s)| (q(b, 4), q(s, 4))) {
        let friction = Friction::new(beta.clone(), sigma.clone());
        let spare = q(1, 1) - beta - sigma;
        let drawn = (1..=20).map(|n| {
            let step = Step::new(q(n, 1), q(n - 1, 1));
            let given = held_force(&step.start) * step.displacement();
            given - friction.dissipated_at_constant_velocity(&q(-1, 1), &q(1, 1))
        });
        let mut sum = zero();
        for (depth, drawn) in (1..).zip(drawn) {
            sum += drawn;
            let depth = q(depth, 1);
            assert_eq!(sum, half() * squared(&depth) + &depth * &spare);
        }
        assert!(sum > zero());
    }
}

sampled! {
    fn err_iv_c_switching_energy(xi in position()) {
        let wall: Law<BigRational> = Law::bilateral();
        let stored = half() * squared(&xi);
        prop_assert_eq!(wall.switching_energy(false, true, &xi), stored.clone());
        prop_assert_eq!(wall.switching_energy(true, false, &xi), -stored);
        prop_assert_eq!(wall.switching_energy(true, true, &xi), zero());
        prop_assert_eq!(wall.switching_energy(false, false, &xi), zero());
    }

    /// Whatever the law: off at any time costs nothing, and on again gives back what off took.
    fn err_iv_c_off_never_costs(law in law(), xi in position()) {
        let (off, on) = (law.switching_energy(true, false, &xi), law.switching_energy(false, true, &xi));
        prop_assert!(off <= zero());
        prop_assert_eq!(off + on, zero());
    }
}
