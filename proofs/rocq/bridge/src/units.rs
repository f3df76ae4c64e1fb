//! The formulas with units: (7), (11), the limits of TH-STIFF.

use passivity_core::{Loop, stiffness};
use passivity_terms::Term;

use crate::formula::Formula;
use crate::plain::var;

const ALL: [&str; 6] = ["b", "c", "K", "T", "Delta", "v"];

/// The paper's loop in SI units: friction, sampling and an encoder.
fn plain() -> Loop<Term> {
    Loop {
        viscous: Some(var("b")),
        coulomb: Some(var("c")),
        resolution: Some(var("Delta")),
        ..Loop::new(var("K"), var("T"))
    }
}

/// Every effect that the criterion knows, with a delay of two samples.
fn full() -> Loop<Term> {
    Loop {
        delay: 2,
        damping: Some(var("B")),
        force_step: Some(var("F")),
        ..plain()
    }
}

pub(crate) fn formulas() -> Vec<Formula> {
    let mut all = parameters();
    all.extend(criteria());
    all.extend(limits());
    all
}

fn parameters() -> Vec<Formula> {
    let the_loop = plain();
    let friction = the_loop.friction();
    let inertia = Loop {
        inertia: Some(var("m")),
        ..plain()
    };
    let mut all = vec![
        Formula::new(
            "Loop::friction",
            &["b", "K", "T"],
            friction.beta,
            "beta_of b K T",
        )
        .named("loop_beta"),
        Formula::new(
            "Loop::friction",
            &["c", "K", "Delta"],
            friction.sigma,
            "sigma_of c K Delta",
        )
        .named("loop_sigma"),
        Formula::new(
            "Loop::dimensionless_speed",
            &["v", "T", "Delta"],
            the_loop.dimensionless_speed(&var("v")),
            "v * T / Delta",
        ),
    ];
    // If the inertia were lost, the generated file would lack the formula.
    all.extend(inertia.dimensionless().inertia.map(|mu| {
        Formula::new("Loop::dimensionless", &["m", "K", "T"], mu, "mu_of m K T")
            .named("loop_mu")
            .by("intros; unfold mu_of; f_equal; field")
    }));
    all
}

fn criteria() -> Vec<Formula> {
    let with_units = full().criterion();
    let plain = plain();
    let dimensionless = plain.dimensionless_criterion();
    let smooth = Loop {
        resolution: None,
        force_step: Some(var("F")),
        ..self::plain()
    }
    .criterion();
    vec![
        Formula::new(
            "Loop::criterion",
            &["b", "K", "T", "B"],
            with_units.viscous,
            "viscous_si b K T 2 B",
        )
        .named("loop_viscous"),
        Formula::new(
            "Loop::criterion",
            &["c", "K", "T", "Delta", "B", "F"],
            with_units.coulomb,
            "coulomb_si c K T Delta B F",
        )
        .named("loop_coulomb"),
        Formula::new(
            "Loop::criterion",
            &["b", "K", "T"],
            plain.criterion().viscous,
            "viscous_si b K T 0 0",
        )
        .named("loop_viscous_plain"),
        Formula::new(
            "Loop::criterion",
            &["c", "K", "Delta", "T"],
            plain.criterion().coulomb,
            "coulomb_si c K T Delta 0 0",
        )
        .named("loop_coulomb_plain"),
        Formula::new(
            "Loop::criterion",
            &["c", "F"],
            smooth.coulomb,
            "coulomb_si_smooth c F",
        )
        .named("loop_coulomb_smooth"),
        Formula::new(
            "Loop::dimensionless_criterion",
            &["b", "K", "T"],
            dimensionless.viscous,
            "viscous_surplus (beta_of b K T) 0 0",
        )
        .named("dimensionless_viscous")
        .given("K <> 0")
        .given("T <> 0"),
        Formula::new(
            "Loop::dimensionless_criterion",
            &["c", "K", "Delta"],
            dimensionless.coulomb,
            "coulomb_surplus (sigma_of c K Delta) 0 0",
        )
        .named("dimensionless_coulomb")
        .given("K <> 0")
        .given("Delta <> 0"),
    ]
}

fn limits() -> Vec<Formula> {
    let the_loop = full();
    let v = var("v");
    let with_effects = ["b", "c", "K", "T", "Delta", "v", "B", "F"];
    let mut all = vec![
        Formula::new(
            "stiffness::viscous_limit",
            &["b", "K", "T", "B"],
            stiffness::viscous_limit(&the_loop),
            "viscous_limit b T 2 B",
        ),
        Formula::new(
            "stiffness::limit_at_speed",
            &with_effects,
            stiffness::limit_at_speed(&the_loop, &v),
            "stiffness_limit b c T Delta v 2 B F",
        ),
        Formula::new(
            "stiffness::limit_at_all_speeds",
            &with_effects,
            stiffness::limit_at_all_speeds(&the_loop),
            "Rmin (viscous_limit b T 2 B) (coulomb_limit c T Delta B F)",
        )
        .by("intros; apply f_equal2; bridge"),
        Formula::new(
            "stiffness::limit_at_speed",
            &ALL,
            stiffness::limit_at_speed(&plain(), &v),
            "stiffness_limit b c T Delta v 0 0 0",
        )
        .named("limit_at_speed_plain"),
    ];
    // Without an encoder there is no such limit: then the generated file lacks the formula.
    all.extend(stiffness::coulomb_limit(&the_loop).map(|limit| {
        Formula::new(
            "stiffness::coulomb_limit",
            &["c", "K", "T", "Delta", "B", "F"],
            limit,
            "coulomb_limit c T Delta B F",
        )
    }));
    all
}
