//! The formulas with units: (7), (11), the limits of TH-STIFF.

use passivity_core::Rig;
use passivity_core::effects::Effects;
use passivity_core::stiffness;
use passivity_terms::Term;

use crate::formula::Formula;
use crate::plain::var;

const ALL: [&str; 6] = ["b", "c", "K", "T", "Delta", "v"];

fn rig(effects: Effects<Term>) -> Rig<Term> {
    Rig {
        viscous: var("b"),
        coulomb: var("c"),
        stiffness: var("K"),
        period: var("T"),
        length: var("Delta"),
        effects,
    }
}

/// Every effect, with a delay of two samples.
fn full() -> Effects<Term> {
    Effects {
        encoder: true,
        delay: 2,
        damping: Some(var("B")),
        force_step: Some(var("F")),
    }
}

pub(crate) fn formulas() -> Vec<Formula> {
    let mut all = parameters();
    all.extend(criteria());
    all.extend(limits());
    all
}

fn parameters() -> Vec<Formula> {
    let rig = rig(Effects::encoder());
    let friction = rig.friction();
    vec![
        Formula::new(
            "Rig::friction",
            &["b", "K", "T"],
            friction.beta,
            "beta_of b K T",
        )
        .named("rig_beta"),
        Formula::new(
            "Rig::friction",
            &["c", "K", "Delta"],
            friction.sigma,
            "sigma_of c K Delta",
        )
        .named("rig_sigma"),
        Formula::new(
            "Rig::mu",
            &["m", "K", "T"],
            rig.mu(&var("m")),
            "mu_of m K T",
        )
        .named("rig_mu"),
        Formula::new(
            "Rig::dimensionless_speed",
            &["v", "T", "Delta"],
            rig.dimensionless_speed(&var("v")),
            "v * T / Delta",
        ),
    ]
}

fn criteria() -> Vec<Formula> {
    let with_units = rig(full()).criterion();
    let plain = rig(Effects::encoder());
    let dimensionless = plain.dimensionless_criterion();
    let smooth = rig(Effects {
        force_step: Some(var("F")),
        ..Effects::smooth()
    })
    .criterion();
    vec![
        Formula::new(
            "Rig::criterion",
            &["b", "K", "T", "B"],
            with_units.viscous,
            "viscous_si b K T 2 B",
        )
        .named("rig_viscous"),
        Formula::new(
            "Rig::criterion",
            &["c", "K", "T", "Delta", "B", "F"],
            with_units.coulomb,
            "coulomb_si c K T Delta B F",
        )
        .named("rig_coulomb"),
        Formula::new(
            "Rig::criterion",
            &["b", "K", "T"],
            plain.criterion().viscous,
            "viscous_si b K T 0 0",
        )
        .named("rig_viscous_plain"),
        Formula::new(
            "Rig::criterion",
            &["c", "K", "Delta", "T"],
            plain.criterion().coulomb,
            "coulomb_si c K T Delta 0 0",
        )
        .named("rig_coulomb_plain"),
        Formula::new(
            "Rig::criterion",
            &["c", "F"],
            smooth.coulomb,
            "coulomb_si_smooth c F",
        )
        .named("rig_coulomb_smooth"),
        Formula::new(
            "Rig::dimensionless_criterion",
            &["b", "K", "T"],
            dimensionless.viscous,
            "viscous_surplus (beta_of b K T) 0 0",
        )
        .named("dimensionless_viscous")
        .given("K <> 0")
        .given("T <> 0"),
        Formula::new(
            "Rig::dimensionless_criterion",
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
    let rig = rig(full());
    let v = var("v");
    let with_effects = ["b", "c", "K", "T", "Delta", "v", "B", "F"];
    let mut all = vec![
        Formula::new(
            "stiffness::viscous_limit",
            &["b", "K", "T", "B"],
            stiffness::viscous_limit(&rig),
            "viscous_limit b T 2 B",
        ),
        Formula::new(
            "stiffness::limit_at_speed",
            &with_effects,
            stiffness::limit_at_speed(&rig, &v),
            "stiffness_limit b c T Delta v 2 B F",
        ),
        Formula::new(
            "stiffness::limit_at_all_speeds",
            &with_effects,
            stiffness::limit_at_all_speeds(&rig),
            "Rmin (viscous_limit b T 2 B) (coulomb_limit c T Delta B F)",
        )
        .by("intros; apply f_equal2; bridge"),
        Formula::new(
            "stiffness::limit_at_speed",
            &ALL,
            stiffness::limit_at_speed(&self::rig(Effects::encoder()), &v),
            "stiffness_limit b c T Delta v 0 0 0",
        )
        .named("limit_at_speed_plain"),
    ];
    // Without an encoder there is no such limit: then the generated file lacks the formula.
    all.extend(stiffness::coulomb_limit(&rig).map(|limit| {
        Formula::new(
            "stiffness::coulomb_limit",
            &["c", "K", "T", "Delta", "B", "F"],
            limit,
            "coulomb_limit c T Delta B F",
        )
    }));
    all
}
