//! The streamed, parallel, tabled audit gives what the ledger gives row by row; and whatever a
//! file holds, it ends in a report or in an error that says where.

mod forces;
mod mistakes;
mod reports;
mod unaccounted;
mod velocities;

use std::fmt::Write as _;

use passivity_audit::{Audit, Options, Verdict, audit_csv};
use passivity_audit::{Ledger, Number, Reading, rows::Form, run::Run};
use passivity_core::BigRational;
use passivity_random::draws;
use passivity_scene::Scene;
use proptest::prelude::*;
use serde_json::Value;

fn scene(text: &str) -> Scene {
    Scene::from_toml("test", text).unwrap()
}

fn three_fifths() -> Scene {
    scene("[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"")
}

fn audited(csv: &[u8], scene: &Scene, threads: usize, block: usize) -> (Audit, String) {
    let mut rows = Vec::new();
    let options = Options {
        rows: Some(&mut rows),
        points: true,
        threads,
        block,
        law: false,
        ..Options::default()
    };
    let audit = audit_csv(Box::new(std::io::Cursor::new(csv.to_vec())), scene, options).unwrap();
    (audit, String::from_utf8(rows).unwrap())
}

/// The same by the ledger, one row after the other.
fn expected(
    samples: &[Reading],
    dtaus: &[Number],
    scene: &Scene,
    enclosures: bool,
) -> (Value, String) {
    let ledger = Ledger::of_scene(scene);
    let mut run = Run::new(&ledger);
    let form = Form {
        enclosures,
        force: false,
        accounted: true,
    };
    let mut text = format!("{}\n", form.header()).into_bytes();
    for (i, sample) in samples.iter().enumerate() {
        let dtau = i.checked_sub(1).and_then(|h| dtaus.get(h)).cloned();
        let dtau = dtau.unwrap_or(Number::whole(1));
        let row = run.step(sample.clone(), &dtau, None).unwrap();
        if let Some(row) = row {
            text.extend_from_slice((run.intervals() - 1).to_string().as_bytes());
            form.write_positions(&row, &mut text).unwrap();
            form.write_account(&row, &mut text).unwrap();
        }
    }
    (
        serde_json::to_value(run.totals().unwrap()).unwrap(),
        String::from_utf8(text).unwrap(),
    )
}

fn scenes() -> impl Strategy<Value = String> {
    let walls = prop_oneof![
        Just(String::new()),
        Just("[wall]\nunilateral = true".to_owned()),
        Just("[wall]\nmax_force = \"7/3\"".to_owned()),
        Just("[wall]\nforce_step = \"2/3\"\nunilateral = true".to_owned()),
        Just("[sampling]\ndelay = 2".to_owned()),
        Just("[sampling]\ndelay = 1\n[wall]\ndamping = \"1/4\"".to_owned()),
    ];
    // Large denominators, as π and data sheets give them: together more than 64 bits.
    let denominators = prop_oneof![Just(("", "10")), Just(("00000000", "1000000007"))];
    (1..20, 0..20, walls, prop::bool::weighted(0.2), denominators).prop_map(
        |(b, s, wall, tolerance, (zeros, d))| {
            let tolerance = if tolerance { " ± 1/100" } else { "" };
            format!(
                "[dimensionless]\nbeta = \"{b}{zeros}/{d}{tolerance}\"\nsigma = \"{s}{zeros}/{}\"\n{wall}\n",
                if zeros.is_empty() { "10" } else { "998244353" },
            )
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(75)))]

    #[test]
    fn counts_are_accounted_for_as_by_the_ledger(
        text in scenes(),
        steps in prop::collection::vec(-3..4_i64, 1..60),
        far in prop::bool::weighted(0.1),
        // Mostly one period, 20/20, as real logs have it.
        jitter in prop::option::of(prop::collection::vec(
            prop_oneof![4 => Just(20_i64), 1 => 1..40_i64],
            60,
        )),
        threads in 1..4_usize,
        block in 20..200_usize,
    ) {
        let scene = scene(&text);
        let mut at = if far { 1_i64 << 55 } else { 0 };
        let mut time = 0;
        let (mut samples, mut dtaus) = (Vec::new(), Vec::new());
        let mut csv = if jitter.is_some() { "tau,count\n" } else { "count\n" }.to_owned();
        for (i, step) in steps.iter().enumerate() {
            at += step;
            samples.push(Reading::Count(at));
            match &jitter {
                Some(jitter) => {
                    time += jitter[i];
                    if i > 0 {
                        dtaus.push(Number::Small(jitter[i], 20));
                    }
                    writeln!(csv, "{time}/20,{at}").unwrap();
                }
                None => writeln!(csv, "{at}").unwrap(),
            }
        }
        let (totals, rows) = expected(&samples, &dtaus, &scene, true);
        let (audit, written) = audited(csv.as_bytes(), &scene, threads, block);
        prop_assert_eq!(&audit.to_json()["totals"], &totals);
        prop_assert_eq!(written, rows);
        // Without rows the quick path runs: the same totals.
        let options = Options { threads, block, ..Options::default() };
        let quick = audit_csv(Box::new(std::io::Cursor::new(csv.into_bytes())), &scene, options).unwrap();
        prop_assert_eq!(&quick.to_json()["totals"], &totals);
        for field in ["running", "worst", "first", "observer", "timing"] {
            prop_assert_eq!(&quick.to_json()[field], &audit.to_json()[field], "{}", field);
        }
    }

    #[test]
    fn positions_are_accounted_for_as_by_the_ledger(
        text in scenes(),
        positions in prop::collection::vec((-60..60_i64, 1..20_i64), 1..40),
        threads in 1..4_usize,
        block in 20..200_usize,
    ) {
        let scene = scene(&text);
        let mut csv = "xi\n".to_owned();
        for (n, d) in &positions {
            writeln!(csv, "{n}/{d}").unwrap();
        }
        let samples: Vec<_> =
            positions.iter().map(|(n, d)| Reading::Exact(Number::Small(*n, *d))).collect();
        let enclosures = text.contains('±');
        let (totals, rows) = expected(&samples, &[], &scene, enclosures);
        let (audit, written) = audited(csv.as_bytes(), &scene, threads, block);
        prop_assert_eq!(&audit.to_json()["totals"], &totals);
        prop_assert_eq!(written, rows);
        // The running figures, from the rows in the report.
        let json = audit.to_json();
        prop_assert_eq!(json["rows"].as_array().unwrap().len(), positions.len() - 1);
    }

    #[test]
    fn no_bytes_stop_an_audit(
        header in prop_oneof!["xi", "count", "x \\[rad\\]", "count,t \\[s\\]", "[a-z,\"\\[\\] ]{0,20}"],
        body in prop::collection::vec(any::<u8>(), 0..300),
        digits in "[0-9\\n,.eE/\\-NaN ]{0,200}",
        block in 1..100_usize,
    ) {
        for body in [&body[..], digits.as_bytes()] {
            let csv = [header.as_bytes(), b"\n", body].concat();
            let options = Options { threads: 2, block, ..Options::default() };
            if let Ok(audit) = audit_csv(Box::new(std::io::Cursor::new(csv)), &three_fifths(), options) {
                prop_assert!(!audit.to_text().is_empty());
                prop_assert!(audit.to_json().is_object());
            }
        }
    }
}

/// The least that a sum was, from zero at the start, and after how many terms.
fn least(terms: impl Iterator<Item = BigRational>) -> (BigRational, u64) {
    let mut least = (BigRational::from_integer(0.into()), 0);
    for (term, h) in terms.zip(1..) {
        if term < least.0 {
            least = (term, h);
        }
    }
    least
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(40)))]

    #[test]
    fn lowest_energies_of_counts_are_those_of_the_walls_law(
        (b, s) in (1..6_i64, 0..6_i64),
        saturation in prop::option::of(prop::sample::select(&[7_i64, 19, 20][..])),
        unilateral: bool,
        steps in prop::collection::vec(-4..5_i64, 1..300),
        block in 40..400_usize,
    ) {
        let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
        let wall = saturation.map_or_else(String::new, |n| format!("max_force = \"{n}/3\""));
        let text = format!(
            "[dimensionless]\nbeta = \"{b}/10\"\nsigma = \"{s}/7\"\n[wall]\nunilateral = {unilateral}\n{wall}\n"
        );
        let scene = scene(&text);
        // Near enough to come back to every part of the wall.
        let at = |steps: &[i64]| steps.iter().fold(0, |at: i64, step| (at + step).clamp(-12, 12));
        let counts: Vec<i64> = (0..=steps.len()).map(|i| at(&steps[..i])).collect();
        let csv = counts.iter().fold("count\n".to_owned(), |csv, n| format!("{csv}{n}\n"));
        let options = Options { threads: 2, block, ..Options::default() };
        let audit = audit_csv(Box::new(std::io::Cursor::new(csv.into_bytes())), &scene, options).unwrap();
        let json = audit.to_json();

        let limit = saturation.map_or_else(|| ratio(1000, 1), |n| ratio(n, 3));
        let force = |x: &BigRational| match unilateral && *x < ratio(0, 1) {
            true => ratio(0, 1),
            false => x.clone().max(-&limit).min(limit.clone()),
        };
        let potential = |x: &BigRational| force(x) * (x - force(x) / ratio(2, 1));
        let ledger = Ledger::of_scene(&scene);
        let mut run = Run::new(&ledger);
        let (mut net, mut observed) = (ratio(0, 1), ratio(0, 1));
        let (mut nets, mut stored, mut observations) = (Vec::new(), Vec::new(), Vec::new());
        let ends = |n: i64| [ratio(n, 1), ratio(n + 1, 1)].map(|x| potential(&x));
        let [a, b] = ends(0);
        let at_start = a.max(b);
        for (i, n) in counts.iter().enumerate() {
            let row = run.step(Reading::Count(*n), &Number::whole(1), None).unwrap();
            let Some(row) = row else { continue };
            net += row.net_linear().unwrap().lo();
            let [a, b] = ends(*n);
            observed += force(&ratio(2 * counts[i - 1] + 1, 2)) * ratio(n - counts[i - 1], 1);
            nets.push(net.clone());
            stored.push(&net + a.min(b) - &at_start);
            observations.push(observed.clone());
        }
        let told = |at: &Value| {
            let value: BigRational = at["least"].as_str().unwrap().parse().unwrap();
            (value, at["after"].as_u64().unwrap())
        };
        prop_assert_eq!(told(&json["running"]["net_linear"]), least(nets.into_iter()));
        prop_assert_eq!(told(&json["running"]["supply"]), least(stored.into_iter()));
        prop_assert_eq!(told(&json["observer"]), least(observations.into_iter()));
    }
}

#[test]
fn running_energy_and_observer_are_what_they_say() {
    let (audit, _) = audited(b"xi\n1\n1/2\n0\n-3.5\n", &three_fifths(), 1, 0);
    let json = audit.to_json();
    // −F·d: 3/2·(−1/2), 3/2... the force held from 1 is −3/2, from 1/2 and from 0 it is −1/2.
    assert_eq!(json["observer"]["energy"], "-11/4");
    assert_eq!(json["observer"]["says"], "active");
    // Net 3/40 and potential ½(½² − 1): the lowest of −3/10, −1/10, 7.7.
    assert_eq!(json["running"]["supply"]["least"], "-3/10");
    assert_eq!(json["running"]["supply"]["after"], 1);
    assert_eq!(json["running"]["supply"]["floor"], "-1/2");
    assert_eq!(json["first"]["quantized"]["row"], 1);
    assert_eq!(audit.verdict(), Verdict::Holds);
    assert_eq!(json["rows"][2]["generated_quantized"], "8");
}

#[test]
fn a_trace_from_a_loop_that_is_not_passive_violates() {
    let scene = scene("[dimensionless]\nbeta = \"1/4\"\nsigma = \"1/4\"");
    let (audit, _) = audited(b"xi\n0\n-1\n0\n", &scene, 1, 0);
    assert_eq!(audit.verdict(), Verdict::Fails);
    assert_eq!(audit.to_json()["first_violation"]["h"], 0);
    let (audit, _) = audited(b"count\n0\n0\n0\n", &scene, 1, 0);
    assert_eq!(audit.verdict(), Verdict::Depends);
}

#[test]
fn harmless_forms_are_read() {
    let expected = audited(b"count\n1\n2\n3\n", &three_fifths(), 1, 0).1;
    for csv in [
        "count\r\n1\r\n2\r\n3\r\n",
        "\u{feff}count\n1\n2\n3",
        "\"count\"\n\"1\"\n\"2\"\n 3 \n\n\n",
        "note,count\na,1\nb,2\nc,3\n",
        "count\n1.0\n2e0\n6/2\n",
    ] {
        let (audit, rows) = audited(csv.as_bytes(), &three_fifths(), 1, 0);
        assert_eq!(audit.error(), None, "{csv:?}");
        assert_eq!(rows, expected, "{csv:?}");
    }
    // A number without its line break is read as it stands, and may have lost digits.
    for (csv, torn) in [("xi\n1\n23", true), ("xi\n1\n23\n", false), ("xi", false)] {
        let (audit, _) = audited(csv.as_bytes(), &three_fifths(), 1, 0);
        assert_eq!(audit.to_json()["last_row_unended"], torn, "{csv:?}");
        assert_eq!(
            audit.to_text().contains("may be incomplete"),
            torn,
            "{csv:?}"
        );
    }
    // A trace without an interval holds nothing.
    for csv in ["count\n", "count\n7\n", "xi0,xi1\n"] {
        let (empty, _) = audited(csv.as_bytes(), &three_fifths(), 1, 0);
        assert_eq!(empty.totals().intervals, 0);
        assert_eq!(empty.error().unwrap().kind, "empty", "{csv}");
        assert_eq!(empty.verdict(), Verdict::Broken);
    }
}

#[test]
fn units_and_counts_agree() {
    // Δ = 1/4 mm and T = 1 ms; the same motion in ticks, in millimetres and in metres.
    let scene = scene(
        "[device]\nviscous = \"1 N s/m\"\ncoulomb = \"1 N\"\n[sampling]\nperiod = \"1 ms\"\n[encoder]\nresolution = \"0.25 mm\"\n[wall]\nstiffness = \"1 N/mm\"",
    );
    let ticks = audited(b"xi\n1/2\n3\n-2\n", &scene, 1, 0).1;
    assert_eq!(
        audited(b"x [mm]\n0.125\n0.75\n-0.5\n", &scene, 1, 0).1,
        ticks
    );
    assert_eq!(
        audited(
            b"t [ms],x [m]\n7,1.25e-4\n8,0.00075\n9,-5e-4\n",
            &scene,
            1,
            0
        )
        .1,
        ticks
    );
}

#[test]
fn angles_are_enclosed_within_their_tick() {
    let scene = scene(
        "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"2 N m/rad\"",
    );
    let (radians, _) = audited(b"x [rad]\n0\n0.001\n-0.0005\n", &scene, 1, 0);
    let json = radians.to_json();
    let xi = &json["rows"][0]["xi1"];
    // 0.001·8192/2π = 1.30379…
    assert!(xi["lo"].as_str().unwrap().ends_with("/1099511627776"));
    assert!((xi["approx"].as_f64().unwrap() - 1.303_797_29).abs() < 1e-8);
    // Degrees and counts per revolution are both π times a rational: exact.
    let (degrees, _) = audited(b"x [deg]\n0\n0.0439453125\n", &scene, 1, 0);
    assert_eq!(degrees.to_json()["rows"][0]["xi1"], "1");
}

#[test]
fn uneven_sampling_is_reported() {
    let (audit, _) = audited(b"tau,xi\n0,0\n1,1\n4,2\n4.5,2\n", &three_fifths(), 1, 0);
    let timing = &audit.to_json()["timing"];
    assert_eq!(timing["late"], 1);
    assert_eq!(timing["missed_samples"], 2);
    assert_eq!(timing["first_missed_row"], 2);
    assert_eq!(timing["uneven"], 2);
    assert_eq!(
        (&timing["shortest"], &timing["longest"]),
        (&"1/2".into(), &"3".into())
    );
}

#[test]
fn a_trace_is_as_long_as_its_times_say() {
    let scene = three_fifths();
    let mut text = "tau,xi\n".to_owned();
    for h in 0..1000 {
        let _ = writeln!(text, "{}/4,{}", 10 + 5 * h, h % 7);
    }
    for block in [64, 1 << 20] {
        let (audit, _) = audited(text.as_bytes(), &scene, 3, block);
        let periods = audit.duration().expect("times").to_string();
        assert_eq!(periods, "4995/4", "{block}");
    }
    let (untimed, _) = audited(b"xi\n1\n2\n", &scene, 1, 64);
    assert_eq!(untimed.duration(), None);
}

/// Late samples are drawn late, of any kind of log, however it is cut and wherever it ends.
#[test]
fn the_course_of_energy_is_at_the_times_of_the_log() {
    let scene = three_fifths();
    let late = |h: u64| h + h / 7 * 3;
    let even = |h: u64| h;
    let xi = |h: u64| h % 5;
    type Time<'a> = &'a dyn Fn(u64) -> u64;
    type Row<'a> = &'a dyn Fn(u64) -> String;
    let ledger = |h: u64| format!("{},{},{}", xi(h), xi(h + 1), late(h + 1) - late(h));
    let logs: [(&str, Row<'_>, Time<'_>); 6] = [
        (
            "tau,count",
            &|h| format!("{},{}", 10 + late(h), xi(h)),
            &late,
        ),
        (
            "tau,xi",
            &|h| format!("{},{}/3", 10 + late(h), xi(h)),
            &late,
        ),
        ("xi0,xi1,dtau", &ledger, &late),
        ("count", &|h| xi(h).to_string(), &even),
        ("xi", &|h| format!("{}/3", xi(h)), &even),
        ("xi0,xi1", &|h| format!("{},{}", xi(h), xi(h + 1)), &even),
    ];
    for (header, row, time) in logs {
        let rows: String = (0..900).map(|h| row(h) + "\n").collect();
        for end in ["", "oops\n"] {
            let csv = format!("{header}\n{rows}{end}");
            for block in [0, 70, 2000] {
                let audit = audited(csv.as_bytes(), &scene, 2, block).0;
                let points = audit.points();
                assert!(points.len() > 400, "{header} {block}");
                for point in points {
                    assert_eq!(
                        point.time,
                        time(point.h) as f64,
                        "{header} {block} {}",
                        point.h
                    );
                }
            }
        }
    }
}

#[test]
fn a_ledger_is_a_trace() {
    let (first, rows) = audited(b"tau,xi\n0,1\n1,1/2\n3,4\n", &three_fifths(), 1, 0);
    let (second, again) = audited(rows.as_bytes(), &three_fifths(), 2, 40);
    assert_eq!(rows, again);
    assert_eq!(first.to_json()["totals"], second.to_json()["totals"]);
}

#[test]
fn a_scene_whose_force_changes_within_an_interval_is_not_accounted_for() {
    let scene =
        scene("[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n[amplifier]\ntime_constant = \"1/5\"");
    let (audit, _) = audited(b"xi\n0\n1\n", &scene, 1, 0);
    assert_eq!(audit.verdict(), Verdict::NotCovered);
}
