//! The formulas with units: (3), (4), (7), (11), the limits of TH-STIFF.

use passivity_core::{Loop, Parameter, stiffness};
use passivity_terms::Term;

use crate::formula::Formula;
use crate::plain::var;

const ALL: [&str; 6] = ["b", "c", "K", "T", "Delta", "v"];

/// Friction and an encoder.
fn plain() -> Loop<Term> {
    Loop {
        viscous: Some(var("b")),
        coulomb: Some(var("c")),
        resolution: Some(var("Delta")),
        ..Loop::new(var("K"), var("T"))
    }
}

/// Every effect that costs friction, with a delay of two samples.
fn full() -> Loop<Term> {
    Loop {
        damping: Some(var("B")),
        force_step: Some(var("F")),
        delay: 2,
        ..plain()
    }
}

/// No encoder, and force steps.
fn smooth() -> Loop<Term> {
    Loop {
        resolution: None,
        damping: None,
        ..full()
    }
}

pub(crate) fn formulas() -> Vec<Formula> {
    let mut all = parameters();
    all.extend(criteria());
    all.extend(limits());
    all
}

fn parameters() -> Vec<Formula> {
    let friction = plain().friction();
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
            plain().dimensionless_speed(&var("v")),
            "v * T / Delta",
        ),
    ];
    // A loop in which every parameter is the variable x, and its dimensionless form.
    let with_all = Parameter::ALL
        .iter()
        .skip(2)
        .fold(plain(), |the_loop, parameter| {
            the_loop.with(*parameter, var("x"))
        })
        .with(Parameter::Resolution, var("Delta"));
    let without = with_all.dimensionless();
    let units = [
        (Parameter::Inertia, "mu_of x K T"),
        (Parameter::Viscous, "beta_of x K T"),
        (Parameter::Coulomb, "sigma_of x K Delta"),
        (Parameter::Damping, "beta_of x K T"),
        (Parameter::MaxForce, "sigma_of x K Delta"),
        (Parameter::ForceStep, "sigma_of x K Delta"),
        (Parameter::TimeConstant, "x / T"),
        (Parameter::MaxSpeed, "x * T / Delta"),
        (Parameter::OperatorForce, "sigma_of x K Delta"),
        (Parameter::ArmMass, "mu_of x K T"),
        (Parameter::ArmDamping, "beta_of x K T"),
        (Parameter::ArmStiffness, "x / K"),
        (Parameter::StartPosition, "x / Delta"),
        (Parameter::StartVelocity, "x * T / Delta"),
    ];
    all.extend(units.into_iter().filter_map(|(parameter, equals)| {
        let term = without.get(parameter)?.clone();
        let name = parameter.row().name.replace(' ', "_").replace('Δ', "Delta");
        let formula = Formula::new(
            "Loop::dimensionless",
            &["x", "K", "T", "Delta"],
            term,
            equals,
        )
        .named(format!("dimensionless_{name}"));
        Some(
            formula
                .given("K <> 0")
                .given("T <> 0")
                .given("Delta <> 0")
                .by("bridge_units"),
        )
    }));
    all
}

fn criteria() -> Vec<Formula> {
    let with_units = full().criterion();
    let plain = plain();
    let dimensionless = plain.dimensionless_criterion();
    let smooth = smooth().criterion();
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

/// The border value of each parameter, with every effect and without.
fn limits() -> Vec<Formula> {
    let (full, plain, smooth) = (full(), plain(), smooth());
    let v = var("v");
    let with_effects = ["b", "c", "K", "T", "Delta", "v", "B", "F"];
    let undamped = Loop {
        damping: None,
        ..full.clone()
    };
    let mut all = vec![
        Formula::new(
            "stiffness::viscous_limit",
            &["b", "K", "T", "B"],
            stiffness::viscous_limit(&full),
            "viscous_limit b T 2 B",
        ),
        Formula::new(
            "stiffness::limit_at_speed",
            &with_effects,
            stiffness::limit_at_speed(&full, &v),
            "stiffness_limit b c T Delta v 2 B F",
        ),
        Formula::new(
            "stiffness::limit_at_all_speeds",
            &with_effects,
            stiffness::limit_at_all_speeds(&full),
            "Rmin (viscous_limit b T 2 B) (coulomb_limit c T Delta B F)",
        )
        .by("intros; apply f_equal2; bridge"),
        Formula::new(
            "stiffness::limit_up_to_speed",
            &with_effects,
            stiffness::limit_up_to_speed(&full, &v),
            "Rmin (stiffness_limit b c T Delta v 2 B F) (coulomb_limit c T Delta B F)",
        )
        .by("intros; apply f_equal2; bridge"),
        Formula::new(
            "stiffness::limit_at_speed",
            &ALL,
            stiffness::limit_at_speed(&plain, &v),
            "stiffness_limit b c T Delta v 0 0 0",
        )
        .named("limit_at_speed_plain"),
        Formula::new(
            "stiffness::viscous_limit",
            &["b", "K", "T"],
            stiffness::viscous_limit(&smooth),
            "viscous_limit b T 2 0",
        )
        .named("viscous_limit_smooth"),
        Formula::new(
            "stiffness::viscous_needed",
            &["b", "K", "T", "B"],
            stiffness::viscous_needed(&full),
            "b - viscous_si b K T 2 B",
        ),
        Formula::new(
            "stiffness::viscous_needed_at_speed",
            &with_effects,
            stiffness::viscous_needed_at_speed(&full, &v),
            "b - margin (viscous_si b K T 2 B) (coulomb_si c K T Delta B F) v / v",
        )
        .by("bridge_limit"),
        Formula::new(
            "stiffness::coulomb_needed",
            &["c", "K", "T", "Delta", "B", "F"],
            stiffness::coulomb_needed(&full),
            "c - coulomb_si c K T Delta B F",
        ),
        Formula::new(
            "stiffness::coulomb_needed_up_to_speed",
            &with_effects,
            stiffness::coulomb_needed_up_to_speed(&full, &v),
            "c - Rmin (coulomb_si c K T Delta B F)\n    \
             (margin (viscous_si b K T 2 B) (coulomb_si c K T Delta B F) v)",
        )
        .by("intros; apply f_equal2; [reflexivity | apply f_equal2; bridge]"),
        Formula::new(
            "stiffness::longest_period",
            &["b", "K", "B"],
            stiffness::longest_period(&full),
            "longest_period b K 2 B",
        )
        .by("bridge_limit"),
        Formula::new(
            "stiffness::longest_period_at_speed",
            &["b", "c", "K", "T", "Delta", "v", "F"],
            stiffness::longest_period_at_speed(&undamped, &v),
            "2 * best_period b c K Delta v 2 0 F",
        )
        .given("K <> 0")
        .given("v <> 0")
        .by("bridge_limit"),
        Formula::new(
            "stiffness::best_period_at_speed",
            &["b", "c", "K", "Delta", "v", "B", "F"],
            stiffness::best_period_at_speed(&full, &v),
            "best_period b c K Delta v 2 B F",
        )
        .by("bridge_limit"),
    ];
    // Without an encoder, or without damping, there are no such limits: then the generated file
    // lacks the formula, and the test that every definition is compared fails.
    let optional = [
        (
            "stiffness::coulomb_limit",
            vec!["c", "K", "T", "Delta", "B", "F"],
            stiffness::coulomb_limit(&full),
            "coulomb_limit c T Delta B F",
        ),
        (
            "stiffness::shortest_period",
            vec!["c", "K", "Delta", "B", "F"],
            stiffness::shortest_period(&full),
            "shortest_period c K Delta B F",
        ),
    ];
    all.extend(
        optional
            .into_iter()
            .filter_map(|(source, variables, limit, equals)| {
                Some(Formula::new(source, &variables, limit?, equals).by("bridge_limit"))
            }),
    );
    all.extend(stiffness::coarsest_resolution(&full).map(|coarsest| {
        Formula::new(
            "stiffness::coarsest_resolution",
            &["c", "K", "T", "Delta", "B", "F"],
            coarsest,
            "coarsest_resolution c K T B F",
        )
        .given("T <> 0")
        .given("K / 2 + B / T <> 0")
        .by("bridge_coarsest")
    }));
    all
}
