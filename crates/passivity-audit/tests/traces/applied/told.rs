//! What is told of forces that are not the law's: what they are the law of, and how the scene or the columns are put right.

use std::fmt::Write as _;

use passivity_audit::{Audit, Dialect, Options, audit_csv};
use passivity_scene::Scene;

use super::{PATH, audited, law, scene, three_fifths};

/// What is found of the force, whatever the account rests on.
fn of_the_force(audit: &Audit) -> Vec<&'static str> {
    let kinds = audit.report().findings.iter().map(|f| f.kind);
    kinds.filter(|kind| *kind != "stored_energy").collect()
}

/// What was commanded before the log began is not in it: a delayed force is compared from the row on from which the log has
/// what it is made of.
#[test]
fn a_force_from_before_the_log_is_not_compared() {
    let path: Vec<i64> = (-2..30).map(|i| 2 * i).collect();
    let csv = |lag: usize, scale: f64| {
        let mut csv = "count,f\n".to_owned();
        for i in 2..path.len() {
            writeln!(csv, "{},{:.6}", path[i], law(&path, i, lag, scale)).unwrap();
        }
        csv
    };
    let delayed = |delay: usize| {
        scene(&format!(
            "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n[sampling]\ndelay = {delay}"
        ))
    };
    for lag in [1, 2] {
        let force = |csv: &str, delay: usize| {
            let audit = audited(csv, &delayed(delay));
            let report = audit.report();
            (report.force.clone().unwrap(), report.findings.clone())
        };
        let (force_in_scene, findings) = force(&csv(lag, 1.0), lag);
        assert!(force_in_scene.agrees && findings.is_empty(), "{findings:?}");
        assert_eq!(force_in_scene.compared, 30 - lag as u64);
        let (_, findings) = force(&csv(lag, 1.0), 0);
        assert!(
            findings[0].fix.ends_with(&format!("delay = {lag}")),
            "{findings:?}"
        );
        let (_, findings) = force(&csv(lag, 1000.0), lag);
        let [finding] = &findings[..] else {
            panic!("{findings:?}")
        };
        assert!(
            finding.says.contains("the force is 1000 times"),
            "{findings:?}"
        );
    }
}

/// A wall whose force is in another unit has every part of it in that unit: what is proposed makes the law that of the log.
#[test]
fn a_scale_is_one_of_all_that_the_force_is_made_of() {
    let wall = |stiffness: &str, force: &str| {
        scene(&format!(
            "[device]\nmass = \"0.05 kg\"\nviscous = \"1 N s/m\"\ncoulomb = \"0.05 N\"\n[sampling]\nperiod = \"1 ms\"\n\
             [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"{stiffness}\"\nmax_force = \"{force}\"\n"
        ))
    };
    let mut csv = "count,f [N]\n".to_owned();
    for i in 0..200 {
        let count = (30.0 * (f64::from(i) / 7.0).sin()).floor();
        let force = -2.0 * ((count + 0.5) * 0.03).clamp(-0.3, 0.3);
        writeln!(csv, "{count},{force:.3}").unwrap();
    }
    let audit = audited(&csv, &wall("1 N/mm", "0.3 N"));
    let [finding] = &audit.report().findings[..] else {
        panic!("{}", audit.to_text());
    };
    let fix = "stiffness = \"2000 N/m\", and `max_force` as many times as large;";
    assert!(finding.fix.contains(fix), "{}", finding.fix);
    let cured = audited(&csv, &wall("2000 N/m", "0.6 N"));
    assert!(
        cured.report().force.as_ref().unwrap().agrees,
        "{}",
        cured.to_text()
    );
}

/// Of forces in full digits nothing is left beside it.
#[test]
fn forces_of_a_moved_wall_are_those_of_it_to_the_last_digit() {
    let scene = scene(
        "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nperiod = \"1 ms\"\n\
         [encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"1.12 N m/rad\"\n",
    );
    for digits in [7, 9, 12] {
        let mut csv = "count,f [N m]\n".to_owned();
        for count in [1, 2, 4, 6, 7, 8, 8, 7, 5, 3, 1] {
            let force = -1.12 * f64::from(count) * std::f64::consts::TAU / 8192.0;
            writeln!(csv, "{count},{force:.digits$}").unwrap();
        }
        let audit = audited(&csv, &scene);
        let kinds = of_the_force(&audit);
        assert_eq!(kinds, ["offset"], "{}", audit.to_text());
    }
}

/// What a log has too little for is not told.
#[test]
fn nothing_is_told_of_what_a_log_does_not_show() {
    let delayed = scene("[dimensionless]\nbeta = \"30\"\nsigma = \"300\"\n[sampling]\ndelay = 3\n");
    let kinds = |csv: &str, scene: &Scene| {
        let audit = audited(csv, scene);
        (
            of_the_force(&audit),
            audit.report().force.clone().unwrap(),
            audit.to_text(),
        )
    };
    // Of no row is it known whether it agrees.
    let (found, force, text) = kinds("count,f\n0,5\n3,8\n", &delayed);
    assert!(
        !force.agrees && !force.rough && force.compared == 0,
        "{text}"
    );
    assert!(
        found.is_empty() && text.contains("so none is compared"),
        "{text}"
    );
    // Two rows that are compared are.
    let short = "count,f\n0,-0.500000\n0,-0.500000\n0,-0.500000\n2,-0.500000\n4,-0.500000\n";
    let (found, force, text) = kinds(short, &delayed);
    assert!(force.agrees && found.is_empty(), "{text}");
    // One row is a multiple of anything.
    let (found, _, text) = kinds("count,f\n0,5\n3,-8\n", &three_fifths());
    assert!(
        found == ["other_force"] && !text.contains("times"),
        "{text}"
    );
    // The scene's own delay leaves out as many rows as any of its signs.
    let turned = "count,f\n0,0.5\n0,0.5\n0,0.5\n0,0.5\n0,0.5\n0,0.5\n5,0.5\n5,0.5\n5,0.5\n5,5.5\n5,5.5\n5,5.5\n";
    let (found, force, text) = kinds(turned, &delayed);
    assert_eq!(
        (force.found.delay, force.found.mismatches),
        (3, 0),
        "{text}"
    );
    assert_eq!(found, ["sign"], "{text}");
    // A device that is held still shows no delay.
    let mut held = "count,f\n".to_owned();
    for force in [
        "-10.6", "-10.55", "-10.5", "-10.49", "-10.51", "-10.5", "-10.49", "-10.51", "-10.5",
    ] {
        writeln!(held, "10,{force}").unwrap();
    }
    let (found, _, text) = kinds(&held, &three_fifths());
    assert_eq!(found, ["other_force"], "{text}");
    // A voltage that hardly changes is no wall far away.
    let mut supply = "count,f\n".to_owned();
    for i in 0..40_i32 {
        let volts = 24.0 + f64::from((i * 13) % 7 - 3) / 100.0;
        writeln!(supply, "{},{volts:.4}", (i * 7) % 31 - 15).unwrap();
    }
    let (_, _, text) = kinds(&supply, &three_fifths());
    assert!(
        text.contains("not that of the wall's law at any delay, sign or scale"),
        "{text}"
    );
}

/// A name may have an apostrophe.
#[test]
fn a_sign_is_turned_by_words_that_a_shell_takes() {
    let mut csv = "count,motor's force\n".to_owned();
    for (i, n) in PATH.iter().enumerate() {
        writeln!(csv, "{n},{}", -law(&PATH, i, 0, 1.0)).unwrap();
    }
    let dialect = Dialect {
        columns: Some("count=count, f=motor's force".parse().unwrap()),
        ..Dialect::default()
    };
    let options = Options {
        dialect,
        ..Options::default()
    };
    let input = Box::new(std::io::Cursor::new(csv));
    let audit = audit_csv(input, &three_fifths(), options).unwrap();
    let fix = &audit.report().findings[0].fix;
    assert!(
        fix.ends_with(r"--columns 'count=count, f=-motor'\''s force'"),
        "{fix}"
    );
}

/// A controller that takes the count for the position, and not the middle of its tick, as most first ones do; and one whose
/// force has something added to it.
#[test]
fn the_force_of_a_wall_that_is_moved_is_no_other_stiffness() {
    let path: Vec<i64> = (0..60).map(|i| [0, 4, 9, 12, 9, -4][i % 6]).collect();
    let outside = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n[wall]\nunilateral = true";
    for (scene, is_bilateral) in [(three_fifths(), true), (scene(outside), false)] {
        let is_inside = |i: usize| is_bilateral || path[i] >= 0;
        for column in ["xi", "count"] {
            for (scale, ticks, says) in [
                (1.0, 0.5, "moved half a tick forward"),
                (1.0, -0.5, "moved half a tick backward"),
                (1.12, 0.5, "moved half a tick forward"),
                (1.0, 2.25, "moved 2.25 ticks forward"),
            ] {
                let moved = |i: usize| match is_inside(i) {
                    true => scale * (law(&path, i, 0, 1.0) + ticks),
                    false => 0.0,
                };
                let mut csv = format!("{column},f\n");
                for (i, n) in path.iter().enumerate() {
                    writeln!(csv, "{n},{:.6}", moved(i)).unwrap();
                }
                let audit = audited(&csv, &scene);
                let kinds = of_the_force(&audit);
                let text = audit.to_text();
                assert!(text.contains(says), "{text}");
                match scale == 1.0 {
                    true => assert_eq!(kinds, ["offset"], "{text}"),
                    false => {
                        assert_eq!(kinds, ["offset", "scale"], "{text}");
                        assert!(text.contains("the force is 1.12 times"), "{text}");
                    }
                }
            }
        }
    }
}

/// Before the first row that can be read there is no force, of no sample.
#[test]
fn nothing_is_said_of_the_forces_of_no_row() {
    let said = |csv: &'static str, scene: &Scene| {
        let audit = audit_csv(Box::new(csv.as_bytes()), scene, Options::default()).unwrap();
        assert!(audit.error().is_some());
        audit.to_text()
    };
    let text = said("tau,count,f\nx,0,0\n1,1,0\n", &three_fifths());
    assert!(!text.contains("wall's law"), "{text}");
    let delayed = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n[sampling]\ndelay = 2\n";
    let text = said("tau,count,f\n0,0,0\nx,1,0\n", &scene(delayed));
    assert!(text.contains("so none is compared"), "{text}");
}

/// Forces that are half of their last digit off, always to the same side, agree with the law, and with that of a moved wall.
#[test]
fn a_wall_that_is_moved_by_half_of_the_last_digit_is_named() {
    let counts = (0..40).map(|i| (12.0 * (f64::from(i) / 4.0).sin()).floor());
    let counts: Vec<f64> = counts.collect();
    let says = |force: &dyn Fn(f64) -> String| {
        let mut csv = "count,f\n".to_owned();
        for n in &counts {
            writeln!(csv, "{n},{}", force(*n)).unwrap();
        }
        let audit = audited(&csv, &three_fifths());
        let report = audit.report();
        assert!(report.force.as_ref().unwrap().agrees);
        let findings = report.findings.iter().map(|f| (f.kind, f.says.clone()));
        findings.collect::<Vec<_>>()
    };
    for (force, way) in [
        (
            &(|n: f64| format!("{}", -n)) as &dyn Fn(f64) -> String,
            "moved half a tick forward",
        ),
        (
            &|n: f64| format!("{}", -n - 1.0),
            "moved half a tick backward",
        ),
    ] {
        let [(kind, says)] = &says(force)[..] else {
            panic!("{way}: not one finding")
        };
        assert_eq!(*kind, "offset");
        assert!(
            says.starts_with("all forces are off the wall's law by half of") && says.ends_with(way),
            "{says}"
        );
    }
    // As they are, rounded to even numbers, and to zero.
    assert!(says(&|n| format!("{}", -n - 0.5)).is_empty());
    assert!(says(&|n| format!("{:.0}", -n - 0.5)).is_empty());
    assert!(says(&|n| format!("{:.0}", (-n - 0.5).trunc())).is_empty());
}
