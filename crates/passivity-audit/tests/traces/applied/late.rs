//! Forces that come late, are to another scale and have some noise: what is said of them is true.

use std::fmt::Write as _;

use passivity_audit::Finding;

use super::{audited, three_fifths};

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
