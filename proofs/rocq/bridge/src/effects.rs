//! The formulas of section 4: delay, virtual damping, D/A step, force laws.

use passivity_core::{Law, Loop, Scalar, controller, extra_storage};
use passivity_terms::Term;

use crate::formula::Formula;
use crate::plain::{friction, var};

/// The delays that are compared: each is its own formula, as the kernel counts them.
const DELAYS: [u16; 4] = [0, 1, 2, 3];

pub(crate) fn formulas() -> Vec<Formula> {
    let mut all = criteria();
    all.extend(storages());
    all.extend(laws());
    all
}

fn criteria() -> Vec<Formula> {
    let mut all = Vec::new();
    for delay in DELAYS {
        let the_loop = Loop {
            delay,
            damping: Some(var("B")),
            force_step: Some(var("delta")),
            ..Loop::plain(friction())
        };
        let criterion = the_loop.criterion();
        all.push(
            Formula::new(
                "Loop::criterion",
                &["beta", "B"],
                criterion.viscous,
                format!("viscous_surplus beta {delay} B"),
            )
            .named(format!("criterion_viscous_{delay}")),
        );
        all.push(
            Formula::new(
                "Loop::criterion",
                &["sigma", "delta", "B"],
                criterion.coulomb,
                "coulomb_surplus sigma delta B",
            )
            .named(format!("criterion_coulomb_{delay}")),
        );
        all.push(
            Formula::new(
                "Cost::bound",
                &["d", "delta", "B"],
                the_loop.cost().bound(&var("d")),
                format!(
                    "- (viscous_surplus 0 {delay} B * d ^ 2 + coulomb_surplus 0 delta B * Rabs d)"
                ),
            )
            .named(format!("cost_bound_{delay}")),
        );
    }
    let absent = Loop::plain(friction()).criterion();
    all.push(
        Formula::new(
            "Loop::criterion",
            &["beta"],
            absent.viscous,
            "viscous_surplus beta 0 0",
        )
        .named("criterion_viscous_plain"),
    );
    all.push(
        Formula::new(
            "Loop::criterion",
            &["sigma"],
            absent.coulomb,
            "coulomb_surplus sigma 0 0",
        )
        .named("criterion_coulomb_plain"),
    );
    all
}

/// The displacements before a sample, newest first, and the same as a function for Rocq.
fn past(length: u16) -> (Vec<&'static str>, Vec<Term>, String) {
    let names: Vec<&'static str> = ["d1", "d2", "d3", "d4"]
        .into_iter()
        .take(usize::from(length))
        .collect();
    let terms = names.iter().map(|name| var(name)).collect();
    let cases: String = (1..)
        .zip(&names)
        .map(|(j, name)| format!(" | {j}%nat => {name}"))
        .collect();
    (
        names,
        terms,
        format!("(fun j => match j with{cases} | _ => 0 end)"),
    )
}

fn storages() -> Vec<Formula> {
    let mut all = Vec::new();
    for delay in DELAYS.into_iter().filter(|k| *k > 0) {
        let (names, terms, function) = past(delay);
        all.push(
            Formula::new(
                "extra_storage::delay_storage",
                &names,
                extra_storage::delay_storage(&terms),
                format!("delay_storage {delay} {function}"),
            )
            .named(format!("delay_storage_{delay}")),
        );
    }
    for delay in DELAYS {
        let (names, terms, function) = past(delay + 1);
        let mut variables = vec!["B"];
        variables.extend(names);
        all.push(
            Formula::new(
                "extra_storage::damping_storage",
                &variables,
                extra_storage::damping_storage(&var("B"), &terms),
                format!("damping_storage {delay} B {function}"),
            )
            .named(format!("damping_storage_{delay}")),
        );
    }
    // A step as the controller keeps it: δ as a quotient by 1.
    all.push(
        Formula::new(
            "controller::rounded",
            &["F", "delta"],
            controller::rounded(&var("F"), &var("delta"), &Term::one()),
            "rounded_force F delta",
        )
        .named("rounded_force")
        .by("intros; unfold rounded_force; rewrite Rmult_1_r; field"),
    );
    all
}

fn laws() -> Vec<Formula> {
    let x = var("x");
    let saturated = |law: Law<Term>| law.saturated(var("hi"));
    let one_sided = Law::unilateral();
    let both = Law::bilateral();
    vec![
        Formula::new("Law::bilateral::force", &["x"], both.force(&x), "x").named("law_bilateral"),
        Formula::new(
            "Law::bilateral::potential",
            &["x"],
            both.potential(&x),
            "linear_potential x",
        )
        .named("law_bilateral_potential"),
        Formula::new(
            "Law::unilateral::force",
            &["x"],
            one_sided.force(&x),
            "clipped_below 0 x",
        )
        .named("law_unilateral"),
        Formula::new(
            "Law::unilateral::potential",
            &["x"],
            one_sided.potential(&x),
            "law_potential_of x (clipped_below 0 x)",
        )
        .named("law_unilateral_potential"),
        Formula::new(
            "Law::unilateral::held_force",
            &["x"],
            one_sided.held_force(&x),
            "- clipped_below 0 (measured x)",
        )
        .named("law_unilateral_held"),
        Formula::new(
            "Law::saturated::force",
            &["x", "hi"],
            saturated(both.clone()).force(&x),
            "clipped (- hi) hi x",
        )
        .named("law_saturated"),
        Formula::new(
            "Law::saturated::potential",
            &["x", "hi"],
            saturated(both.clone()).potential(&x),
            "law_potential_of x (clipped (- hi) hi x)",
        )
        .named("law_saturated_potential"),
        Formula::new(
            "Law::saturated::force",
            &["x", "hi"],
            saturated(one_sided.clone()).force(&x),
            "clipped 0 hi x",
        )
        .named("law_unilateral_saturated")
        .given("0 <= hi")
        .by("intros; unfold clipped; rewrite (Rmax_left 0 (- hi)) by lra; reflexivity"),
        Formula::new(
            "Law::held_force",
            &["x"],
            both.held_force(&x),
            "held_force x",
        )
        .named("law_bilateral_held"),
    ]
}
