//! Energy that the scene's wall stores at the start, where the force in the log is not that wall's.

use std::fmt::Write as _;

use passivity_audit::{Audit, Judged, Options, Verdict, audit_csv};
use passivity_scene::Scene;

const FRICTION: &str = "[dimensionless]\nbeta = \"1/10\"\nsigma = \"1/10\"\n";

fn audited(log: &str, more: &str, block: usize) -> Audit {
    let scene = Scene::from_toml("s", &format!("{FRICTION}{more}")).unwrap();
    let options = Options {
        block,
        ..Options::default()
    };
    let log = Box::new(std::io::Cursor::new(log.to_owned()));
    let audit = audit_csv(log, &scene, options).unwrap();
    assert_eq!(audit.error(), None);
    audit
}

/// A force that pulls along with the motion to and fro, `by` ticks from where the log counts from.
fn pulled(column: &str, by: i64, rows: usize) -> String {
    let mut log = format!("{column},f\n");
    for i in 0..rows {
        let ahead = i % 2 == 0;
        let (at, force) = (by + i64::from(!ahead), if ahead { 1 } else { -1 });
        writeln!(log, "{at},{force}").unwrap();
    }
    log
}

fn is_stored(audit: &Audit) -> bool {
    let findings = &audit.report().findings;
    findings.iter().any(|f| f.kind == "stored_energy")
}

/// Each interval gives the hand 1 − β − σ: far from zero the scene's wall stores more than all of that.
#[test]
fn a_position_that_is_not_zero_at_the_wall_makes_nothing_hold() {
    for column in ["xi", "count"] {
        // A log of so many rows is accounted for by exact numbers, or by doubles.
        for rows in [41, 1401] {
            for (by, expected) in [(0, Verdict::Fails), (10_000, Verdict::Depends)] {
                let log = pulled(column, by, rows);
                let audit = audited(&log, "", 0);
                let said = format!("{column} {rows} {by}");
                // Of counts it is open how far each motion went.
                let expected = match column {
                    "count" => Verdict::Depends,
                    _ => expected,
                };
                assert_eq!(audit.verdict(), expected, "{said}");
                assert_eq!(audit.report().judged, Judged::Running, "{said}");
                assert_eq!(is_stored(&audit), by != 0, "{said}");
                for block in [7, 100] {
                    let again = audited(&log, "", block);
                    assert_eq!(again.to_json(), audit.to_json(), "{said}");
                }
            }
        }
    }
    let text = audited(&pulled("xi", 100, 41), "", 0).to_text();
    for line in [
        "s: DEPENDS: a finding leaves open whether the operator drew more than was stored at the start\n",
        "  stored at the start          at most 5000 KΔ² in the spring of the scene's wall\n",
        // 40 (1 − 1/5).
        "up to row 41 the operator may have drawn 32 KΔ²: the spring of the scene's wall stores at most 5000 KΔ² at the start,",
        "check that the position is 0 where the wall begins,",
    ] {
        assert!(text.contains(line), "{line}{text}");
    }
    // Outside of a wall on one side nothing is stored.
    let one_sided = "[wall]\nunilateral = true\n";
    let outside = audited(&pulled("xi", -10_000, 41), one_sided, 0);
    assert_eq!(outside.verdict(), Verdict::Fails);
}

/// What holds with nothing stored holds wherever positions are counted from.
#[test]
fn an_account_that_needs_nothing_stored_holds() {
    for column in ["xi", "count"] {
        for rows in [40, 1400] {
            let mut log = format!("{column},f\n");
            for i in 0..rows {
                // Rests where it began, then goes on against a force that is not the wall's.
                let at = 100 + 3 * i64::from(i > 9) * (i - 9);
                let part = if column == "xi" { "/7" } else { "" };
                writeln!(log, "{at}{part},-1").unwrap();
            }
            let audit = audited(&log, "", 0);
            let found = (audit.verdict(), is_stored(&audit));
            // The end of its first tick is a store of a hundred that counts leave open.
            match column {
                "xi" => assert_eq!(found, (Verdict::Holds, false), "{rows}"),
                _ => assert_eq!(found, (Verdict::Depends, true), "{rows}"),
            }
        }
    }
    // The wall's own force, late as the scene says, gives back what it stored.
    let mut log = "xi,f\n".to_owned();
    for i in 0..60_i64 {
        let at = |i: i64| 40 - i.max(0);
        writeln!(log, "{},{}", at(i), -at(i - 1) as f64 - 0.5).unwrap();
    }
    let late = audited(&log, "[sampling]\ndelay = 1\n", 0);
    assert_eq!(late.report().judged, Judged::Running);
    assert!(!is_stored(&late));
}
