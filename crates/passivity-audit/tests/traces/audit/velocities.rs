//! Logs that have the velocity: what is said where it is not that of the positions, and what that leaves open.

use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;

use passivity_audit::{Audit, Verdict};

use super::{audited, scene};

/// A knob of 8192 counts a revolution, with viscous and Coulomb friction.
fn knob(viscous: &str, coulomb: &str) -> passivity_scene::Scene {
    scene(&format!(
        "[device]\nviscous = \"{viscous} N m s/rad\"\ncoulomb = \"{coulomb} N m\"\n[sampling]\nrate = \"1 kHz\"\n\
         [encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"0.06 N m/rad\"\n"
    ))
}

/// A swing of 4 Hz by 0.6 rad each way, of a device with so many counts a revolution, with velocities made of its own.
fn swing(counts: f64, velocity: impl Fn(usize, f64) -> f64) -> String {
    let mut csv = "t [s],count,v [rad/s]\n".to_owned();
    for i in 0..500 {
        let (sin, cos) = (8.0 * PI * 1e-3 * i as f64).sin_cos();
        let count = (0.6 * sin * counts / TAU).floor();
        let velocity = velocity(i, 0.6 * 8.0 * PI * cos);
        writeln!(csv, "{:.3},{count},{velocity:.4}", 1e-3 * i as f64).unwrap();
    }
    csv
}

fn kinds(audit: &Audit) -> Vec<&'static str> {
    audit.report().findings.iter().map(|it| it.kind).collect()
}

/// A scene with four times as many counts as the device has four times the friction of a tick.
#[test]
fn a_velocity_to_another_scale_leaves_open_what_would_hold() {
    type Velocity<'a> = &'a dyn Fn(usize, f64) -> f64;
    let noise = |i: usize| if i.is_multiple_of(2) { 11.0 } else { -11.0 };
    let cases: [(f64, Velocity<'_>, Option<&str>); 10] = [
        (8192.0, &|_, v| v, None),
        (8192.0, &|_, v| 1.4 * v, None),
        (8192.0, &|_, v| 0.7 * v, None),
        // Noise of some 100 % is no scale.
        (8192.0, &|i, v| v + noise(i), Some("velocity")),
        (8192.0, &|_, v| -v, Some("velocity_scale")),
        (8192.0, &|_, v| 0.5 * v, Some("velocity_scale")),
        (8192.0, &|_, v| 2.0 * v, Some("velocity_scale")),
        (8192.0, &|_, v| v.to_degrees(), Some("velocity_scale")),
        // Four and two counts of the scene for one of the device.
        (2048.0, &|_, v| v, Some("velocity_scale")),
        (16384.0, &|_, v| v, Some("velocity_scale")),
    ];
    for (case, (counts, velocity, kind)) in cases.iter().enumerate() {
        let csv = swing(*counts, velocity);
        for (viscous, expected) in [("4e-5", Verdict::Holds), ("0", Verdict::Fails)] {
            let coulomb = if viscous == "0" { "0" } else { "4.6e-5" };
            let audit = audited(csv.as_bytes(), &knob(viscous, coulomb), 1, 0).0;
            assert_eq!(
                kinds(&audit),
                kind.iter().copied().collect::<Vec<_>>(),
                "{case}"
            );
            let opened = *kind == Some("velocity_scale") && expected == Verdict::Holds;
            let expected = if opened { Verdict::Depends } else { expected };
            assert_eq!(audit.verdict(), expected, "{case}");
            let headline = audit.report().headline();
            assert_eq!(headline.contains("a finding leaves open"), opened, "{case}");
        }
    }
}

/// Of a slow device each step is a tick or none, whatever its velocity: over more rows it is told.
#[test]
fn the_velocity_of_a_slow_device_is_told_over_more_rows() {
    for (counts, expected) in [(8192.0, None), (2048.0, Some("velocity_scale"))] {
        for speed in [2.0, 0.5, 0.1] {
            // Up to speed · 8192/2π ticks of the scene a second, so less than 3 a row.
            let mut csv = "t [s],count,v [rad/s]\n".to_owned();
            for i in 0..3000 {
                let (time, turn) = (1e-3 * f64::from(i), 0.5 * TAU);
                let count = (speed / turn * (turn * time).sin() * counts / TAU).floor();
                writeln!(csv, "{time:.3},{count},{:.5}", speed * (turn * time).cos()).unwrap();
            }
            let whole = audited(csv.as_bytes(), &knob("4e-5", "4.6e-5"), 1, 0).0;
            assert_eq!(kinds(&whole), Vec::from_iter(expected), "{speed}");
            let opened = whole.verdict() == Verdict::Depends;
            assert_eq!(opened, expected.is_some(), "{speed}");
            // However it is cut.
            let cut = audited(csv.as_bytes(), &knob("4e-5", "4.6e-5"), 2, 300).0;
            assert_eq!(cut.to_json()["velocity"], whole.to_json()["velocity"]);
        }
    }
}

/// A column that says nothing is found, unless the device rests; where velocities agree, the text says so.
#[test]
fn a_velocity_that_is_zero_throughout_is_found_and_one_that_agrees_is_said() {
    let said = |csv: &str| {
        let audit = audited(csv.as_bytes(), &knob("4e-5", "4.6e-5"), 1, 0).0;
        assert_eq!(audit.verdict(), Verdict::Holds);
        let text = audit.to_text();
        let line = text.lines().find_map(|it| it.strip_prefix("  velocity "));
        let line = line.map(|it| it.trim().to_owned());
        (kinds(&audit), line)
    };
    let found = (vec!["zero_velocity"], None);
    assert_eq!(said(&swing(8192.0, |_, _| 0.0)), found);
    let line = "agrees with the positions, compared in 491 rows";
    let agrees = (Vec::new(), Some(line.to_owned()));
    assert_eq!(said(&swing(8192.0, |_, v| v)), agrees);
    type Count<'a> = &'a dyn Fn(usize) -> usize;
    let log = |rows: usize, count: Count<'_>| {
        (0..rows).fold("count,v [rad/s]\n".to_owned(), |csv, i| {
            csv + &format!("{},0\n", count(i))
        })
    };
    // A tick every 16 rows, a device at rest, on the border between two ticks and within one, and a few rows.
    assert_eq!(said(&log(500, &|i| i / 16)), found);
    let still = "which stay where they are";
    let cases: [(usize, Count<'_>, &str); 3] = [
        (500, &|i| i * i / 3 % 2, still),
        (500, &|_| 7, still),
        (5, &|_| 7, "of which there are too few"),
    ];
    for (rows, count, says) in cases {
        let (kinds, line) = said(&log(rows, count));
        assert!(kinds.is_empty() && line.unwrap().ends_with(says), "{says}");
    }
}

/// Where ticks are read, their size may be what is wrong; of angles it is not.
#[test]
fn what_puts_a_velocity_right_is_named() {
    let counts = swing(2048.0, |_, v| v);
    let audit = audited(counts.as_bytes(), &knob("4e-5", "4.6e-5"), 1, 0).0;
    let [finding] = &audit.report().findings[..] else {
        panic!("{}", audit.to_text());
    };
    // The ticks of a count change the factor by some percent.
    assert!(finding.says.contains("the velocity is 3.9"), "{finding:?}");
    let encoder = "the counts per revolution, or the resolution, of its encoder";
    assert!(finding.fix.contains(encoder), "{finding:?}");
    let mut angles = "t [s],x [rad],v [rad/s]\n".to_owned();
    for i in 0..100 {
        writeln!(
            angles,
            "{:.3},{:.3},4",
            1e-3 * f64::from(i),
            1e-3 * f64::from(i)
        )
        .unwrap();
    }
    let audit = audited(angles.as_bytes(), &knob("4e-5", "4.6e-5"), 1, 0).0;
    let [finding] = &audit.report().findings[..] else {
        panic!("{}", audit.to_text());
    };
    assert_eq!(
        finding.says,
        "the velocity is 4 times that of the positions"
    );
    assert!(!finding.fix.contains("encoder"), "{finding:?}");
}
