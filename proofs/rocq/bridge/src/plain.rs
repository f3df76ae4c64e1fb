//! The formulas of the paper: quantizer, springs, generation, dissipation, criterion, ledger.

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{
    Criterion, Friction, Loop, Quantized, Step, dissipation, generation, quantizer, region, spring,
    start, witness,
};
use passivity_terms::Term;

use crate::formula::Formula;

pub(crate) fn var(name: &str) -> Term {
    Term::variable(name)
}

fn step() -> Step<Term> {
    Step::new(var("x0"), var("x1"))
}

pub(crate) fn friction() -> Friction<Term> {
    Friction::new(var("beta"), var("sigma"))
}

pub(crate) fn criterion() -> Criterion<Term> {
    Criterion {
        viscous: var("viscous"),
        coulomb: var("coulomb"),
    }
}

pub(crate) fn formulas() -> Vec<Formula> {
    let mut all = positions();
    all.extend(generated());
    all.extend(dissipated());
    all.extend(criteria());
    all.extend(witnesses());
    all.extend(row());
    all.extend(row_of_any_force());
    all
}

fn positions() -> Vec<Formula> {
    let x = var("x");
    let q = Quantized::of(&x);
    let (mu, v) = (var("mu"), var("v"));
    vec![
        Formula::new("Quantized::of::tick", &["x"], q.tick.clone(), "floor x"),
        Formula::new(
            "Quantized::of::residue",
            &["x"],
            q.residue.clone(),
            "residue x",
        ),
        Formula::new("Quantized::measured", &["x"], q.measured(), "measured x"),
        Formula::new(
            "quantizer::held_force",
            &["x"],
            quantizer::held_force(&x),
            "held_force x",
        ),
        Formula::new(
            "spring::linear_potential",
            &["x"],
            spring::linear_potential(&x),
            "linear_potential x",
        ),
        Formula::new(
            "spring::quantization_potential",
            &["x"],
            spring::quantization_potential(&x),
            "quantization_potential x",
        ),
        Formula::new(
            "spring::quantized_potential",
            &["x"],
            spring::quantized_potential(&x),
            "quantized_potential x",
        ),
        Formula::new(
            "spring::kinetic",
            &["mu", "v"],
            spring::kinetic(&mu, &v),
            "kinetic mu v",
        ),
        Formula::new(
            "spring::storage",
            &["mu", "x", "v"],
            spring::storage(&mu, &x, &v),
            "storage mu x v",
        ),
        Formula::new(
            "spring::quantized_storage",
            &["mu", "x", "v"],
            spring::quantized_storage(&mu, &x, &v),
            "quantized_storage mu x v",
        ),
    ]
}

fn generated() -> Vec<Formula> {
    let ends = ["x0", "x1"];
    let d = var("d");
    vec![
        Formula::new(
            "Step::displacement",
            &ends,
            step().displacement(),
            "x1 - x0",
        ),
        Formula::new("Step::ticks", &ends, step().ticks(), "ticks x0 x1"),
        Formula::new(
            "generation::generated",
            &["held", "x0", "x1", "p0", "p1"],
            generation::generated(&var("held"), &step(), &var("p0"), &var("p1")),
            "generated held x0 x1 p0 p1",
        ),
        Formula::new(
            "generation::generated_linear",
            &ends,
            generation::generated_linear(&step()),
            "generated_linear x0 x1",
        ),
        Formula::new(
            "generation::quantization_effect",
            &ends,
            generation::quantization_effect(&step()),
            "quantization_effect x0 x1",
        ),
        Formula::new(
            "generation::generated_as_in_19",
            &ends,
            generation::generated_as_in_19(&step()),
            "generated_quantized x0 x1",
        ),
        Formula::new(
            "generation::generated_quantized",
            &ends,
            generation::generated_quantized(&step()),
            "generated_quantized x0 x1",
        ),
        Formula::new(
            "generation::bound_21",
            &["D"],
            generation::bound_21(&var("D")),
            "bound_21 D",
        ),
        Formula::new(
            "generation::bound_22",
            &["d"],
            generation::bound_22(&d),
            "bound_22 d",
        ),
        Formula::new(
            "generation::bound_quantized",
            &["d"],
            generation::bound_quantized(&d),
            "bound_quantized d",
        ),
    ]
}

fn dissipated() -> Vec<Formula> {
    let (d, dtau, v) = (var("d"), var("dtau"), var("v"));
    let speed = dissipation::mean_speed(&d, &dtau);
    vec![
        Formula::new(
            "Friction::power",
            &["beta", "sigma", "v"],
            friction().power(&v),
            "friction_power beta sigma v",
        ),
        Formula::new(
            "dissipation::mean_speed",
            &["d", "dtau"],
            speed.clone(),
            "mean_speed d dtau",
        ),
        Formula::new(
            "Friction::dissipated_lower",
            &["beta", "sigma", "d", "dtau"],
            friction().dissipated_lower(&d, &speed),
            "dissipated_lower beta sigma d dtau",
        ),
        Formula::new(
            "Friction::dissipated_at_constant_velocity",
            &["beta", "sigma", "v", "dtau"],
            friction().dissipated_at_constant_velocity(&v, &dtau),
            "friction_power beta sigma v * dtau",
        ),
    ]
}

fn criteria() -> Vec<Formula> {
    let plain = Criterion::of_friction(&friction());
    let names = ["viscous", "coulomb", "v"];
    let (d, v) = (var("d"), var("v"));
    let speed = dissipation::mean_speed(&d, &var("dtau"));
    vec![
        Formula::new(
            "Criterion::of_friction",
            &["beta"],
            plain.viscous,
            "viscous_surplus beta 0 0",
        )
        .named("of_friction_viscous"),
        Formula::new(
            "Criterion::of_friction",
            &["sigma"],
            plain.coulomb,
            "coulomb_surplus sigma 0 0",
        )
        .named("of_friction_coulomb"),
        Formula::new(
            "Criterion::margin",
            &names,
            criterion().margin(&v),
            "margin viscous coulomb v",
        ),
        Formula::new(
            "Criterion::margin_at_all_speeds",
            &["viscous", "coulomb"],
            criterion().margin_at_all_speeds(),
            "Rmin viscous coulomb",
        ),
        Formula::new(
            "Criterion::margin_up_to",
            &names,
            criterion().margin_up_to(&v),
            "Rmin coulomb (margin viscous coulomb v)",
        ),
        Formula::new(
            "Criterion::surplus",
            &["viscous", "coulomb", "d", "dtau"],
            criterion().surplus(&d, &speed),
            "surplus viscous coulomb d dtau",
        ),
        Formula::new(
            "Criterion::critical_sigma",
            &["beta", "v"],
            Criterion::critical_sigma(&var("beta"), &v),
            "critical_sigma beta v",
        ),
        Formula::new(
            "region::critical_speed",
            &["viscous", "coulomb"],
            region::critical_speed(&criterion()),
            "critical_speed viscous coulomb",
        ),
        Formula::new(
            "start::speed_squared",
            &["mu", "x", "v"],
            start::speed_squared(&var("mu"), &var("x"), &v),
            "start_speed_squared mu x v",
        ),
        Formula::new(
            "start::speed_squared_with_memory",
            &["mu", "x", "v", "extra"],
            start::speed_squared_with_memory(&var("mu"), &var("x"), &v, &var("extra")),
            "start_speed_squared_with_memory mu x v extra",
        ),
        Formula::new(
            "start::margin_of_squares",
            &["viscous", "coulomb", "V2"],
            start::margin_of_squares(&criterion(), &var("V2")),
            "margin_of_squares viscous coulomb V2",
        ),
    ]
}

fn witnesses() -> Vec<Formula> {
    vec![
        Formula::new(
            "witness::gain",
            &["from", "to", "beta", "sigma"],
            witness::gain(&var("from"), &var("to"), &friction()),
            "held_force from * (to - from) + held_force to * (from - to)\n    \
             - 2 * dissipated_lower beta sigma (to - from) 1",
        ),
        Formula::new(
            "witness::gain_formula",
            &["m", "a", "beta", "sigma"],
            witness::gain_formula(&var("m"), &var("a"), &friction()),
            "cycle_gain m a beta sigma",
        ),
    ]
}

fn row() -> Vec<Formula> {
    let names = ["x0", "x1", "beta", "sigma", "dtau"];
    let interval = HeldInterval::plain(step(), var("dtau"));
    let row = ledger::row(&Loop::plain(friction()), &interval);
    let lower = "dissipated_lower beta sigma (x1 - x0) dtau";
    let formula = |name: &str, term: Term, equals: String| {
        Formula::new("ledger::row", &names, term, equals).named(format!("row_{name}"))
    };
    let d = var("d");
    let jitter = ledger::jitter_bound(&friction(), &d, &dissipation::mean_speed(&d, &var("dtau")));
    vec![
        formula("generated_linear", row.generated_linear, "generated_linear x0 x1".into()),
        formula(
            "generated_quantized",
            row.generated_quantized,
            "generated_quantized x0 x1".into(),
        ),
        formula("bound_22", row.bound_22, "bound_22 (x1 - x0)".into()),
        formula("bound_quantized", row.bound_quantized, "bound_quantized (x1 - x0)".into()),
        formula("dissipated_lower", row.dissipated_lower, lower.into()),
        formula("net_linear", row.net_linear, format!("{lower} - generated_linear x0 x1"))
            .by("intros; rewrite <- (bridge_row_dissipated_lower x0 x1),\n  <- (bridge_row_generated_linear x0 x1 beta sigma dtau); reflexivity"),
        formula(
            "net_quantized",
            row.net_quantized,
            format!("{lower} - generated_quantized x0 x1"),
        )
        .by("intros; rewrite <- (bridge_row_dissipated_lower x0 x1),\n  <- (bridge_row_generated_quantized x0 x1 beta sigma dtau); reflexivity"),
        formula(
            "margin",
            row.margin,
            "margin (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0)\n    \
             (mean_speed (x1 - x0) dtau)"
                .into(),
        ),
        Formula::new(
            "ledger::jitter_bound",
            &["beta", "sigma", "d", "dtau"],
            jitter,
            "jitter_surplus beta (1 / 2) (coulomb_surplus sigma 0 0) d dtau",
        ),
        Formula::new(
            "ledger::operator_work",
            &["s0", "s1", "dissipated", "generated"],
            ledger::operator_work(&var("s0"), &var("s1"), &var("dissipated"), &var("generated")),
            "s1 - s0 + (dissipated - generated)",
        ),
        Formula::new(
            "ledger::counterparts_differ_by",
            &["x0", "x1"],
            ledger::counterparts_differ_by(&var("x0"), &var("x1")),
            "generated_quantized x0 x1 - generated_linear x0 x1",
        ),
    ]
}

/// The row of a loop with every effect, one sample late, under any force.
fn row_of_any_force() -> Vec<Formula> {
    let the_loop = Loop {
        unilateral: true,
        max_force: Some(var("L")),
        damping: Some(var("B")),
        force_step: Some(var("delta")),
        delay: 1,
        ..Loop::plain(friction())
    };
    let interval = HeldInterval {
        step: step(),
        force: var("u"),
        dtau: var("dtau"),
        extra_storage: Some(var("gain")),
    };
    let row = ledger::row(&the_loop, &interval);
    let wall = ledger::row(&Loop::plain(friction()), &interval);
    let smooth = ledger::row(&Loop::smooth(friction()), &interval);
    let against = |potential: &str| format!("generated u x0 x1 ({potential} x0) ({potential} x1)");
    let account = ["x0", "x1", "u", "beta", "sigma", "dtau", "gain"];
    let lower = "dissipated_lower beta sigma (x1 - x0) dtau";
    let net = |wall| format!("{lower} - {} - gain", against(wall));
    let formula = |name: &str, variables: &[&'static str], term: Term, equals: String| {
        Formula::new("ledger::row", variables, term, equals).named(format!("any_row_{name}"))
    };
    let effects = ["x0", "x1", "u", "L"];
    let by_law = "intros; unfold generated, controller_potential, controller_law, law_potential_of, clipped;\n  \
                  rewrite (Rmax_left 0) by lra; field";
    vec![
        formula(
            "wall",
            &effects[..3],
            wall.generated_linear,
            against("linear_potential"),
        ),
        formula(
            "wall_quantized",
            &effects[..3],
            wall.generated_quantized,
            against("quantized_potential"),
        ),
        formula(
            "wall_net",
            &account,
            wall.net_linear,
            net("linear_potential"),
        ),
        formula(
            "wall_net_quantized",
            &account,
            wall.net_quantized,
            net("quantized_potential"),
        ),
        formula(
            "smooth",
            &effects[..3],
            smooth.generated_linear,
            against("linear_potential"),
        ),
        formula(
            "smooth_quantized",
            &effects[..3],
            smooth.generated_quantized,
            against("linear_potential"),
        ),
        formula(
            "smooth_bound",
            &effects[..2],
            smooth.bound_22,
            "(x1 - x0) ^ 2 / 2".into(),
        ),
        formula(
            "effects",
            &effects,
            row.generated_linear,
            against("controller_potential true (Some L)"),
        )
        .given("0 <= L")
        .by(by_law),
        formula(
            "effects_margin",
            &["x0", "x1", "beta", "sigma", "dtau", "B", "delta"],
            row.margin,
            "margin (viscous_surplus beta 1 B) (coulomb_surplus sigma delta B)\n    \
             (mean_speed (x1 - x0) dtau)"
                .into(),
        ),
    ]
}
