//! Forces that come late, are to another scale and have some noise: what is said of them is true.

use std::fmt::Write as _;

use num_traits::Zero as _;
use passivity_audit::{Finding, Verdict};
use passivity_core::BigRational;

use super::{PATH, audited, audited_as, law, scene, three_fifths, trace};

/// The findings of a force that is `scale` times the law of a device that goes to and fro, `lag` samples late, and
/// off by `noise` one way and the other.
fn findings(lag: usize, scale: f64, noise: f64) -> Vec<Finding> {
    let path: Vec<f64> = (0..600)
        .map(|i| (40.0 * (f64::from(i) / 60.0).sin() - 5.0).floor())
        .collect();
    let mut csv = "count,f\n".to_owned();
    for (i, count) in path.iter().enumerate() {
        let law = -scale * (path[i.saturating_sub(lag)] + 0.5);
        let off = if i % 2 == 0 { noise } else { -noise };
        writeln!(csv, "{count},{:.6}", law + off).unwrap();
    }
    let findings = audited(&csv, &three_fifths()).report().findings.clone();
    findings
        .into_iter()
        .filter(|f| f.kind != "stored_energy")
        .collect()
}

#[test]
fn a_multiple_of_the_law_that_comes_late_is_named() {
    // Of 0.01 off a force of some 15 at the root mean square, 0.07 % are left.
    let found = findings(6, 0.5, 0.01);
    let says: Vec<&str> = found.iter().map(|f| f.says.as_str()).collect();
    assert!(says[0].starts_with("the force follows 0.5"), "{says:?}");
    assert!(
        says[0]
            .ends_with(" times the wall's law with 6 samples of delay, and the scene has no delay"),
        "{says:?}"
    );
    assert!(
        says[1].starts_with("beside that the force differs by 0.0")
            && says[1].contains("(RMS) from 0.5"),
        "{says:?}"
    );
    // Of the law itself nothing of the kind is said, and of a multiple without noise it is a finding of its own.
    let own = findings(6, 1.0, 0.01);
    assert_eq!(
        own[0].says,
        "the force follows the wall's law with 6 samples of delay, and the scene has no delay"
    );
    let kinds = |found: &[Finding]| found.iter().map(|f| f.kind).collect::<Vec<_>>();
    assert_eq!(kinds(&findings(6, 0.5, 0.0)), ["delay", "scale"]);
}

/// No delay of more than eight samples beyond the scene's is tried, so that eight is told only where it leaves nothing.
#[test]
fn a_force_that_is_later_than_is_tried_has_no_delay_proposed() {
    for lag in [9, 12, 16] {
        let found = findings(lag, 1.0, 0.0);
        let [late] = &found[..] else {
            panic!("{lag} {found:?}")
        };
        assert_eq!(late.kind, "delay");
        let says = "the force is late by 8 samples or more, and the scene has no delay;";
        assert!(late.says.starts_with(says), "{late:?}");
        assert!(!late.fix.contains("delay ="), "{late:?}");
    }
    let found = findings(8, 1.0, 0.0);
    assert_eq!(found[0].fix, "in the scene, under [sampling]: delay = 8");
    // Nearer ones are told with what is left.
    let found = findings(7, 1.0, 0.01);
    assert_eq!(found[0].fix, "in the scene, under [sampling]: delay = 7");
}

/// What delay and damping store pays for the force of the law, whose account it is part of, and not for one that was applied.
#[test]
fn a_force_that_was_applied_is_stored_nowhere() {
    for effect in ["[sampling]\ndelay = 2\n", "[wall]\ndamping = \"2\"\n"] {
        let loop_ = "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n";
        let scene = passivity_scene::Scene::from_toml("s", &format!("{loop_}{effect}")).unwrap();
        let applied = audited("xi,f\n0,0.5\n1,-0.5\n", &scene);
        let totals = serde_json::to_value(applied.totals()).unwrap();
        // ½ + ½ of what friction takes, 3/5 + 3/5, was generated.
        assert_eq!(totals["generated_linear"], "1", "{effect}");
        assert_eq!(totals["dissipated_lower"], "6/5", "{effect}");
        assert_eq!(totals["net_linear"], "1/5", "{effect}");
        assert_eq!(applied.totals().violates_linear, Some(0), "{effect}");
        assert!(applied.certificate().is_none(), "{effect}");
        let stored = "less what delay and damping stored meanwhile";
        assert!(!applied.to_text().contains(stored), "{effect}");
        let of_law = audited("xi\n0\n5\n", &scene);
        assert_eq!(of_law.totals().violates_linear, Some(1), "{effect}");
        assert!(of_law.certificate().is_some(), "{effect}");
        assert!(of_law.to_text().contains(stored), "{}", of_law.to_text());
    }
}

/// Of forces in another unit an account holds that is of no device. Forces that are zero throughout may be those of a device
/// whose motor is off.
#[test]
fn a_log_does_not_hold_by_forces_that_are_far_from_the_laws() {
    let scene = scene("[dimensionless]\nbeta = \"3/5\"\nsigma = \"6\"");
    let told = |scale: f64| {
        let audit = audited(&trace("xi", &PATH, |i| law(&PATH, i, 3, scale)), &scene);
        let running = audit.report().running.supply.clone().unwrap();
        assert!(
            running.least >= BigRational::zero(),
            "{scale}: it would hold"
        );
        (audit.verdict(), audit.report().headline())
    };
    for scale in [0.001, 0.1, 0.6, -0.1] {
        let (verdict, headline) = told(scale);
        assert_eq!(verdict, Verdict::Depends, "{scale}");
        let says = "DEPENDS: a finding leaves open whether the operator drew more";
        assert!(headline.starts_with(says), "{headline}");
    }
    for scale in [0.7, 1.4, 0.0] {
        assert_eq!(told(scale).0, Verdict::Holds, "{scale}");
    }
    let by_law = audited_as(
        &trace("xi", &PATH, |i| law(&PATH, i, 3, 0.001)),
        &scene,
        true,
        0,
    );
    assert_eq!(by_law.0.verdict(), Verdict::Holds);
}
