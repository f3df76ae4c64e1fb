//! Positions that are whole ticks apart are what an encoder counted: a finding, and no account that holds.

use std::fmt::Write as _;
use std::path::Path;

use passivity_audit::{Options, Partial, Stretch, Verdict, audit, audit_part, merge_parts};
use passivity_scene::Scene;

use crate::scratch::Scratch;

const LINEAR: &str = "[device]\nviscous = \"0.48 N s/m\"\ncoulomb = \"0.008 N\"\n[sampling]\nperiod = \"1 ms\"\n\
                      [encoder]\nresolution = \"0.01 mm\"\n[wall]\nstiffness = \"800 N/m\"\n";
/// Of a tick of 0.001534 rad.
const ROTARY: &str = "[device]\nviscous = \"1e-2 N m s/rad\"\ncoulomb = \"2e-2 N m\"\n[sampling]\nperiod = \"1 ms\"\n\
                      [encoder]\ncounts_per_revolution = 4096\n[wall]\nstiffness = \"1 N m/rad\"\n";

fn scene(text: &str) -> Scene {
    Scene::from_toml("s", text).unwrap()
}

/// A motion in whole ticks of so many samples, with rests and steps to and fro.
fn counts(samples: i32) -> impl Iterator<Item = f64> {
    (0..samples)
        .map(|i| f64::from([0, 1, 1, 3, 2, 5, 4, 4, 0, -2, -1, -3][i as usize % 12] + i / 24))
}

fn column(name: &str, positions: impl Iterator<Item = String>) -> String {
    let mut text = format!("{name}\n");
    positions.for_each(|x| writeln!(text, "{x}").unwrap());
    text
}

/// The verdict on a log, and whether its positions are found to be counts, whatever it is cut into.
fn found(text: &str, scene: &Scene) -> (Verdict, bool) {
    let log = Scratch::new("csv", text.as_bytes());
    let whole = audit(&log, scene, Options::default()).unwrap();
    assert_eq!(whole.error(), None, "{text}");
    let part = |stretch| {
        let options = Options {
            block: 64,
            ..Options::default()
        };
        let part = audit_part(Path::new(&*log), scene, stretch, options).unwrap();
        (
            format!("{stretch:?}"),
            Partial::from_json(&part.to_json().unwrap()).unwrap(),
        )
    };
    let cuts = [(0, Some(1)), (1, Some(20)), (20, Some(21)), (21, None)];
    let parts: Vec<_> = cuts
        .into_iter()
        .map(|(from, to)| part(Stretch::Samples(from, to)))
        .collect();
    let merged = merge_parts(&parts, scene).unwrap();
    assert_eq!(merged.to_json(), whole.to_json(), "{text}");
    let mut findings = whole.report().findings.iter();
    (
        whole.verdict(),
        findings.any(|finding| finding.kind == "counted_positions"),
    )
}

#[test]
fn positions_that_are_whole_ticks_apart_are_no_true_ones() {
    let (linear, rotary) = (scene(LINEAR), scene(ROTARY));
    let tick = std::f64::consts::TAU / 4096.0;
    for part in [0.0, 0.5, 0.3] {
        let at = |tick: f64| counts(64).map(move |n| (n + part) * tick);
        let logs = [
            (
                &linear,
                column("x [mm]", at(0.01).map(|x| format!("{x:.3}"))),
            ),
            (&linear, column("x [m]", at(1e-5).map(|x| x.to_string()))),
            (&rotary, column("x [rad]", at(tick).map(|x| x.to_string()))),
            (
                &rotary,
                column("x [rad]", at(tick).map(|x| format!("{x:.4}"))),
            ),
            // With a tick of few digits, and far away in single precision.
            (
                &rotary,
                column("x [rad]", at(0.001_534).map(|x| x.to_string())),
            ),
            (
                &rotary,
                column(
                    "x [rad]",
                    at(tick).map(|x| ((x + tick * 524_288.0) as f32).to_string()),
                ),
            ),
        ];
        for (scene, text) in logs {
            assert_eq!(found(&text, scene), (Verdict::Depends, true), "{text}");
        }
    }
}

#[test]
fn other_positions_are_true_ones() {
    let (linear, rotary) = (scene(LINEAR), scene(ROTARY));
    let tick = std::f64::consts::TAU / 4096.0;
    let smooth = |size: f64| (0..200).map(move |i| size * (f64::from(i) / 7.0).sin());
    let few = counts(30).map(|n| n * 0.01);
    let rest = (0..200).map(|i| 0.01 * f64::from(i / 100));
    let creep = (0..200).map(|i| 1e-4 * f64::from(i));
    let last = counts(64).map(|n| n * 0.01).chain([0.0149]);
    // Eleven steps that are others, of 6000.
    let eleven = (0..6000).map(|i| {
        let off = if i % 1000 == 999 { 0.003 } else { 0.005 };
        0.01 * f64::from(i * i % 31) + off
    });
    for (scene, text) in [
        (
            &linear,
            column("x [mm]", smooth(0.2).map(|x| format!("{x:.3}"))),
        ),
        (
            &linear,
            column("x [mm]", smooth(0.02).map(|x| x.to_string())),
        ),
        (
            &rotary,
            column("x [rad]", smooth(30.0 * tick).map(|x| format!("{x:.4}"))),
        ),
        (&linear, column("x [mm]", few.map(|x| x.to_string()))),
        (&linear, column("x [mm]", rest.map(|x| x.to_string()))),
        (&linear, column("x [mm]", creep.map(|x| x.to_string()))),
        (&linear, column("x [mm]", last.map(|x| x.to_string()))),
        (&linear, column("x [mm]", eleven.map(|x| x.to_string()))),
        // Half of what the scene's encoder counts.
        (
            &linear,
            column("x [mm]", counts(64).map(|n| (n * 0.005).to_string())),
        ),
    ] {
        assert!(!found(&text, scene).1, "{text}");
    }
    // Ticks are what these columns are in.
    let dimensionless = scene("[dimensionless]\nbeta = \"3\"\nsigma = \"3\"\n");
    for name in ["xi", "count"] {
        let text = column(name, counts(64).map(|n| n.to_string()));
        assert_eq!(found(&text, &dimensionless), (Verdict::Holds, false));
    }
    // Without an encoder there are none.
    let smooth_loop = LINEAR.replace("[encoder]\nresolution = \"0.01 mm\"\n", "");
    let text = column("x [mm]", counts(64).map(|n| (n * 0.01).to_string()));
    assert_eq!(found(&text, &scene(&smooth_loop)), (Verdict::Holds, false));
}

#[test]
fn positions_with_few_digits_are_whole_ticks_apart_by_these() {
    let micro = |tick: &str| scene(&LINEAR.replace("0.01 mm", tick));
    let smooth = |i: i32| 3.0 * (f64::from(i) / 7.0).sin();
    let written = |decimals: usize| {
        column(
            "x [mm]",
            (0..300).map(|i| format!("{:.decimals$}", smooth(i))),
        )
    };
    for (tick, decimals) in [
        ("1 um", 1),
        ("1 um", 2),
        ("1 um", 3),
        ("0.25 um", 3),
        ("0.01 mm", 1),
        ("0.01 mm", 2),
    ] {
        let text = written(decimals);
        assert!(!found(&text, &micro(tick)).1, "{tick}: {text}");
    }
    // A digit is 13.04 ticks of these.
    let fine = scene(&ROTARY.replace("4096", "8192"));
    let slow = (0..300).map(|i| format!("{:.2}", smooth(i) / 30.0));
    assert!(!found(&column("x [rad]", slow), &fine).1);
    // Steps of four ticks, with as many digits as one likes.
    let four = counts(64).map(|n| format!("{:.4}", (4.0 * n + 0.5) * 0.01));
    assert!(!found(&column("x [mm]", four), &scene(LINEAR)).1);
    // One step of a single tick among them tells.
    let one = counts(64).map(|n| 4.0 * n).chain([1.0, 2.0]);
    let one = one.map(|n| format!("{:.4}", (n + 0.5) * 0.01));
    assert!(found(&column("x [mm]", one), &scene(LINEAR)).1);
}

#[test]
fn a_few_steps_may_be_others() {
    let linear = scene(LINEAR);
    let half = |samples: i32| counts(samples).map(|n| (n + 0.53) * 0.01);
    let text = |positions: &mut dyn Iterator<Item = f64>| {
        column("x [mm]", positions.map(|x| format!("{x:.4}")))
    };
    // A row of zeros before the first reading, and a row of them later.
    let first = text(&mut std::iter::once(0.0).chain(half(320)));
    assert_eq!(found(&first, &linear), (Verdict::Depends, true));
    let later = text(&mut half(320).chain([0.0]).chain(half(320)));
    assert!(found(&later, &linear).1);
    // Of so few steps one is too many.
    let short = text(&mut std::iter::once(0.0).chain(half(240)));
    assert!(!found(&short, &linear).1);
}

#[test]
fn what_is_said_names_the_column_and_its_tick() {
    let text = column(
        "x [mm]",
        counts(64).map(|n| format!("{:.3}", (n + 0.5) * 0.01)),
    );
    let log = Scratch::new("csv", text.as_bytes());
    let audit = audit(&log, &scene(LINEAR), Options::default()).unwrap();
    let finding = &audit.report().findings[0];
    assert!(
        finding.says.starts_with("all positions are whole ticks"),
        "{}",
        finding.says
    );
    assert!(
        finding.fix.ends_with("one more is 0.01 more in `x [mm]`"),
        "{}",
        finding.fix
    );
}
