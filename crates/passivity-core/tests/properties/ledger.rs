//! TH-INTERVAL, TH-RUN, TH-JITTER: one row an interval, and the sum of them.

use passivity_core::generation::bound_22;
use passivity_core::ledger::{self, HeldInterval, Row};
use passivity_core::{BigRational, Friction, Loop, Step};
use proptest::prelude::*;

use crate::common::{
    coefficient, dimensionless, friction, half, magnitude, nonnegative, number, position, positive,
    q, sampled, squared, unit, zero,
};
use crate::law::{potential_by_cases, quantized_integral};
use crate::spring::staircase_integral;

/// The row of the paper's loop, over the step from `a` to `b`.
fn plain(
    a: &BigRational,
    b: &BigRational,
    friction: &Friction<BigRational>,
    dtau: &BigRational,
) -> Row<BigRational> {
    let step = Step::new(a.clone(), b.clone());
    let interval = HeldInterval::plain(step, dtau.clone());
    ledger::row(&Loop::plain(friction.clone()), &interval)
}

/// V(ξ) of the wall of a dimensionless loop, by cases.
pub(crate) fn potential(the_loop: &Loop<BigRational>, xi: &BigRational) -> BigRational {
    potential_by_cases(&the_loop.law(), xi)
}

/// The integral of the wall's force over the ticks, by cases; V(ξ) without an encoder.
pub(crate) fn quantized_potential(the_loop: &Loop<BigRational>, xi: &BigRational) -> BigRational {
    if the_loop.resolution.is_some() {
        quantized_integral(&the_loop.law(), xi)
    } else {
        potential(the_loop, xi)
    }
}

sampled! {
    fn th_interval_row_by_formula(a in position(), b in position(), friction in friction(), dtau in positive()) {
        let row = plain(&a, &b, &friction, &dtau);
        let d = &b - &a;
        let size = magnitude(&d);
        let work = -(a.floor() + half()) * &d;
        let linear = &work + half() * (squared(&b) - squared(&a));
        let quantized = work + staircase_integral(&b) - staircase_integral(&a);
        let dissipated = &friction.beta * squared(&d) / &dtau + &friction.sigma * &size;
        let f = &size - size.floor();
        let printed = half() * squared(&d) + half() * &size;
        prop_assert_eq!(row.bound_22, printed.clone());
        prop_assert_eq!(row.bound_quantized, printed + half() * &f * (q(1, 1) - &f));
        prop_assert_eq!(&row.generated_linear, &linear);
        prop_assert_eq!(&row.generated_quantized, &quantized);
        prop_assert_eq!(&row.dissipated_lower, &dissipated);
        prop_assert_eq!(&row.net_linear, &(&dissipated - &linear));
        prop_assert_eq!(&row.net_quantized, &(&dissipated - &quantized));
        let margin = (&friction.beta - half()) * size / dtau + &friction.sigma - half();
        prop_assert_eq!(&row.margin, &margin);
        let row = plain(&a, &b, &friction, &q(1, 1));
        prop_assert_eq!(row.violates_linear(), Some(row.net_linear < zero()));
        prop_assert_eq!(row.violates_quantized(), Some(row.net_quantized < zero()));
    }

    /// Any loop under any force, as it was logged: the account is of that force.
    fn th_interval_row_of_any_force(
        the_loop in dimensionless(), a in position(), b in position(), force in number(),
        dtau in positive(), extra_storage in prop::option::of(number())
    ) {
        let interval = HeldInterval {
            step: Step::new(a.clone(), b.clone()),
            force: force.clone(),
            dtau: dtau.clone(),
            extra_storage: extra_storage.clone(),
        };
        let row = ledger::row(&the_loop, &interval);
        let (d, stored) = (&b - &a, extra_storage.unwrap_or_else(zero));
        let size = magnitude(&d);
        let change = |at: fn(&Loop<BigRational>, &BigRational) -> BigRational| {
            &force * &d + at(&the_loop, &b) - at(&the_loop, &a)
        };
        prop_assert_eq!(&row.generated_linear, &change(potential));
        prop_assert_eq!(&row.generated_quantized, &change(quantized_potential));
        let Friction { beta, sigma } = the_loop.friction();
        let dissipated = beta * squared(&d) / &dtau + sigma * &size;
        prop_assert_eq!(&row.dissipated_lower, &dissipated);
        prop_assert_eq!(&row.net_linear, &(&dissipated - &row.generated_linear - &stored));
        prop_assert_eq!(&row.net_quantized, &(&dissipated - &row.generated_quantized - &stored));
        let criterion = crate::control_loop::criterion_written_out(&the_loop);
        prop_assert_eq!(&row.margin, &(criterion.viscous * &size / &dtau + criterion.coulomb));
        let f = &size - size.floor();
        let half_square = half() * squared(&d);
        let (bound_22, bound_quantized) = if the_loop.resolution.is_some() {
            let printed = &half_square + half() * &size;
            (printed.clone(), printed + half() * &f * (q(1, 1) - &f))
        } else {
            (half_square.clone(), half_square)
        };
        prop_assert_eq!((&row.bound_22, &row.bound_quantized), (&bound_22, &bound_quantized));
    }

    /// The central claim: where (8) holds, friction pays for what sampling generates.
    fn th_interval_criterion_implies_no_net_energy(
        a in position(), b in position(), friction in friction(), dtau in unit()
    ) {
        let row = plain(&a, &b, &friction, &dtau);
        if row.margin >= zero() {
            prop_assert!(row.generated_linear <= bound_22(&(b - a)));
            prop_assert!(row.bound_22 <= row.dissipated_lower);
            prop_assert!(row.net_linear >= zero());
        }
    }

    fn th_interval_on_the_critical_line(a in position(), b in position(), beta in coefficient(), dtau in unit()) {
        // σ is chosen so that the margin is zero: the hardest point where the claim is made.
        let speed = magnitude(&(&b - &a)) / &dtau;
        let sigma = half() - speed * (&beta - half());
        prop_assume!(sigma >= zero());
        let row = plain(&a, &b, &Friction::new(beta, sigma), &dtau);
        prop_assert_eq!(row.margin, zero());
        prop_assert!(row.net_linear >= zero());
    }

    fn th_jitter_bound(a in position(), b in position(), friction in friction(), dtau in positive()) {
        let (d, row) = (&b - &a, plain(&a, &b, &friction, &dtau));
        let size = magnitude(&d);
        let expected = (&friction.beta / &dtau - half()) * squared(&d)
            + (&friction.sigma - half()) * &size;
        let bound = ledger::jitter_bound(&friction, &d, &(size / dtau));
        prop_assert_eq!(bound.clone(), expected);
        prop_assert!(row.net_linear >= bound);
    }

    /// Any number of intervals at which (8) holds: the operator draws no more than was stored.
    fn th_run_operator_draws_at_most_the_storage(
        start in position(),
        moves in prop::collection::vec((position(), unit(), nonnegative()), 1..8),
        spare in (coefficient(), coefficient()),
        kinetic in (nonnegative(), nonnegative()),
    ) {
        let friction = Friction::new(half() + spare.0, half() + spare.1);
        // Kinetic energy at the samples in between is anybody's: it cancels.
        let mut stored = &kinetic.0 + half() * squared(&start);
        let (first, mut drawn, mut here) = (stored.clone(), zero(), start);
        for (next, dtau, lost) in moves {
            let row = plain(&here, &next, &friction, &dtau);
            let after = &kinetic.1 + half() * squared(&next);
            // Friction loses the bound at the least, and `lost` more when the speed varies.
            let dissipated = row.dissipated_lower + lost;
            let work = ledger::operator_work(&stored, &after, &dissipated, &row.generated_linear);
            prop_assert_eq!(&work, &(&after - &stored + &dissipated - &row.generated_linear));
            drawn -= work;
            stored = after;
            here = next;
        }
        prop_assert!(drawn <= first);
    }

    fn th_run_inductive_step(
        drawn in number(), stored in nonnegative(), gain in nonnegative(), dissipated in nonnegative(),
        after in nonnegative(), first in number()
    ) {
        // Invariant: drawn + stored ≤ first. It survives a step that generates no more than is lost.
        prop_assume!(&drawn + &stored <= first);
        let generated = &dissipated - gain;
        let work = ledger::operator_work(&stored, &after, &dissipated, &generated);
        prop_assert!(drawn - work + after <= first);
    }
}

/// An account that comes out even is not short.
#[test]
fn th_interval_an_even_account_is_not_short() {
    // From ½ to 1 in a sample E_gᴸ = d²/2 and E_g = 0 + …: friction that takes as much, and a little less.
    let row = |beta: BigRational| plain(&half(), &q(1, 1), &Friction::new(beta, zero()), &q(1, 1));
    let even = row(half());
    assert_eq!(
        (&even.net_linear, even.violates_linear()),
        (&zero(), Some(false))
    );
    assert_eq!(row(q(49, 100)).violates_linear(), Some(true));
    let least = (even.dissipated_lower - &even.net_quantized) / squared(&half());
    let even = row(least.clone());
    assert_eq!(
        (&even.net_quantized, even.violates_quantized()),
        (&zero(), Some(false))
    );
    assert_eq!(row(least - q(1, 100)).violates_quantized(), Some(true));
}
