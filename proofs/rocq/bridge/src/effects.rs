//! The formulas of section 4: delay, virtual damping, D/A step, force laws.

use passivity_core::controller::rounded;
use passivity_core::extra_storage;
use passivity_core::{Law, Loop, Scalar as _};
use passivity_terms::Term;

use crate::formula::Formula;
use crate::plain::{friction, var};

/// The delays that are compared: each is its own formula, as the kernel counts them.
const DELAYS: [u16; 4] = [0, 1, 2, 3];

pub(crate) fn formulas() -> Vec<Formula> {
    let mut all = criteria();
    all.extend(storages());
    all.extend(laws());
    all.extend(switching());
    all
}

/// The dimensionless loop with damping, force steps and a delay.
fn damped(delay: u16, encoder: bool) -> Loop<Term> {
    Loop {
        resolution: encoder.then(Term::one),
        damping: Some(var("B")),
        force_step: Some(var("delta")),
        delay,
        ..Loop::plain(friction())
    }
}

fn criteria() -> Vec<Formula> {
    let mut all = Vec::new();
    for delay in DELAYS {
        let the_loop = damped(delay, true);
        let criterion = the_loop.criterion();
        let formula = |source, variables: &[&'static str], term, equals: &str, name: &str| {
            let equals = equals.replace('k', &delay.to_string());
            Formula::new(source, variables, term, equals).named(format!("{name}_{delay}"))
        };
        let cost = the_loop.cost();
        all.extend([
            formula(
                "Loop::criterion",
                &["beta", "B"],
                criterion.viscous,
                "viscous_surplus beta k B",
                "criterion_viscous",
            ),
            formula(
                "Loop::criterion",
                &["sigma", "delta", "B"],
                criterion.coulomb,
                "coulomb_surplus sigma delta B",
                "criterion_coulomb",
            ),
            formula(
                "Loop::cost",
                &["B"],
                cost.viscous.clone(),
                "- viscous_surplus 0 k B",
                "cost_viscous",
            ),
            formula(
                "Loop::cost",
                &["delta", "B"],
                cost.coulomb.clone(),
                "- coulomb_surplus 0 delta B",
                "cost_coulomb",
            ),
            formula(
                "Cost::bound",
                &["d", "delta", "B"],
                cost.bound(&var("d")),
                "- (viscous_surplus 0 k B * d ^ 2 + coulomb_surplus 0 delta B * Rabs d)",
                "cost_bound",
            ),
        ]);
    }
    let plain = Loop::plain(friction()).criterion();
    let smooth = damped(1, false).criterion();
    all.extend([
        Formula::new(
            "Loop::criterion",
            &["beta"],
            plain.viscous,
            "viscous_surplus beta 0 0",
        )
        .named("criterion_viscous_plain"),
        Formula::new(
            "Loop::criterion",
            &["sigma"],
            plain.coulomb,
            "coulomb_surplus sigma 0 0",
        )
        .named("criterion_coulomb_plain"),
        Formula::new(
            "Loop::criterion",
            &["beta", "B"],
            smooth.viscous,
            "viscous_surplus beta 1 B",
        )
        .named("criterion_viscous_smooth"),
        Formula::new(
            "Loop::criterion",
            &["sigma", "delta"],
            smooth.coulomb,
            "coulomb_si_smooth sigma delta",
        )
        .named("criterion_coulomb_smooth"),
    ]);
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
    let one = Term::one();
    all.push(
        Formula::new(
            "controller::rounded",
            &["F", "delta"],
            rounded(&var("F"), &var("delta"), &one),
            "rounded_force F delta",
        )
        .by("intros; apply kernel_step"),
    );
    all
}

/// What switching a wall adds to what is stored, on and off and neither.
fn switching() -> Vec<Formula> {
    let x = var("x");
    let cases = [(false, false), (false, true), (true, false), (true, true)];
    let formula = |(was_on, is_on): (bool, bool)| {
        Formula::new(
            "Law::switching_energy",
            &["x"],
            Law::bilateral().switching_energy(was_on, is_on, &x),
            format!("switching_energy {was_on} {is_on} (linear_potential x)"),
        )
        .named(format!("switching_{was_on}_{is_on}"))
        .by("cbv beta iota delta [switching_energy]; bridge")
    };
    cases.map(formula).to_vec()
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
            "Law::quantized_potential",
            &["x", "lo", "hi"],
            Law {
                lower: Some(var("lo")),
                upper: Some(var("hi")),
            }
            .quantized_potential(&x),
            "quantized_clipped_potential lo hi x",
        )
        .named("law_quantized_potential")
        .by("intros; unfold quantized_clipped_potential, beyond, first_beyond, quantized_potential, linear_potential,\n    quantization_potential, residue; field"),
        Formula::new(
            "Law::held_force",
            &["x"],
            both.held_force(&x),
            "held_force x",
        )
        .named("law_bilateral_held"),
    ]
}
