//! Audits in pieces: merged, they are the report of the whole, to the last byte.

use std::path::Path;

use passivity_audit::{Options, Partial, Stretch, TraceError, audit, audit_part, merge_parts};
use passivity_random::draws;
use passivity_scene::Scene;
use proptest::prelude::*;

use crate::scratch::Scratch;

fn options<'a>(law: bool, block: usize) -> Options<'a> {
    Options {
        law,
        block,
        threads: 2,
        ..Options::default()
    }
}

/// The account of a stretch as it comes out of a file.
fn part(
    path: &Path,
    scene: &Scene,
    stretch: Stretch,
    law: bool,
) -> Result<(String, Partial), TraceError> {
    let part = audit_part(path, scene, stretch, options(law, 64))?;
    let part = Partial::from_json(&part.to_json()?)?;
    Ok((format!("{stretch:?}"), part))
}

/// A stretch for each gap between cuts.
fn stretches(cuts: &[u64]) -> Vec<Stretch> {
    let mut cuts = cuts.to_vec();
    cuts.sort_unstable();
    let starts = std::iter::once(0).chain(cuts.iter().copied());
    let ends = cuts.iter().copied().map(Some).chain([None]);
    starts
        .zip(ends)
        .map(|(a, b)| Stretch::Samples(a, b))
        .collect()
}

fn scene(text: &str) -> Scene {
    Scene::from_toml("s", text).unwrap()
}

const ROTARY: &str = "[device]\ninertia = \"6.28e-6 kg m^2\"\nviscous = \"9e-6 N m s/rad ± 10%\"\n\
                      coulomb = \"2e-3 N m\"\n[sampling]\nperiod = \"1 ms\"\n[encoder]\n\
                      counts_per_revolution = 8192\n[wall]\nstiffness = \"2 N m/rad\"\n";

fn scenes() -> Vec<Scene> {
    let plain = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"1/5\"\n";
    vec![
        scene(plain),
        scene(&format!("{plain}[sampling]\ndelay = 2\n")),
        scene(&format!("{plain}[wall]\nunilateral = true\n")),
        scene(ROTARY),
        scene(&format!("{ROTARY}damping = \"1e-4 N m s/rad\"\n")),
    ]
}

/// The text of a log of a kind from a walk: its columns, the rows where its counter wraps around, mistakes and line
/// breaks.
fn text(
    kind: usize,
    walk: &[(i32, u32)],
    wraps: &[usize],
    mistake: Option<usize>,
    ending: usize,
) -> Vec<u8> {
    let header = [
        "count\n",
        "xi\n",
        "tau,count\n",
        "tau,xi\n",
        "t [ms],count,f [N m]\n",
        "t [ms],x [rad],v [rad/s],f [N m]\n",
        "xi0,xi1,dtau\n",
        "tau,count,f\n",
    ];
    let header = header[kind];
    let mut text = header.to_owned();
    let (mut at, mut time) = (0, 0.0);
    for (row, (step, late)) in walk.iter().enumerate() {
        let from = at;
        at += step;
        // A period of counts or of quarters of ticks, and back.
        let jumps = wraps.iter().filter(|wrap| **wrap == row).count();
        for _ in 0..jumps {
            at += if at < 2048 { 4096 } else { -4096 };
        }
        time += 1.0 + 0.25 * f64::from(*late);
        let quarter = f64::from(at) / 4.0;
        let force = f64::from(*late) * 1e-3 - f64::from(at) * 7.669_904e-4;
        if mistake == Some(row) {
            text.push_str(if row % 2 == 0 { "oops\n" } else { "\n" });
            continue;
        }
        match kind {
            0 => text.push_str(&format!("{at}\n")),
            1 => text.push_str(&format!("{quarter}\n")),
            2 => text.push_str(&format!("{time},{at}\n")),
            3 => text.push_str(&format!("{time},{quarter}\n")),
            4 => text.push_str(&format!("{time},{at},{force:.6}\n")),
            5 => text.push_str(&format!(
                "{time},{},{},{force:.6}\n",
                quarter / 100.0,
                step * 10
            )),
            6 => text.push_str(&format!("{from}/3,{at}/3,1\n")),
            _ => text.push_str(&format!("{time},{at},{}\n", -at)),
        }
    }
    match ending {
        0 => {}
        1 => text.push_str("\n\n"),
        // A torn last line that is whole as it stands, and one that is not.
        2 => text.truncate(text.trim_end().len()),
        _ => text.push_str("7,"),
    }
    text.into_bytes()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(75)))]

    #[test]
    fn merged_pieces_are_the_report_of_the_whole(
        kind in 0..8_usize,
        which in 0..5_usize,
        walk in prop::collection::vec((-3..4_i32, prop_oneof![4 => Just(0_u32), 1 => 0..3_u32]), 0..60),
        wraps in prop::collection::vec(0..60_usize, 0..3),
        mistake in prop::option::weighted(0.2, 0..60_usize),
        ending in 0..4_usize,
        before in prop::sample::select(vec!["", "# a log\n% of counts\n", "sep=,\n"]),
        cuts in prop::collection::vec(0..64_u64, 0..6),
        shards in 1..9_u64,
        law: bool,
    ) {
        let scenes = scenes();
        let scene = &scenes[which];
        let text = [before.as_bytes(), &text(kind, &walk, &wraps, mistake, ending)].concat();
        let log = Scratch::new("csv", &text);
        let whole = match audit(&log, scene, options(law, 100)) {
            Ok(whole) => whole,
            Err(error) => {
                // What cannot be audited cannot be audited in pieces, for the same reason.
                let refused = part(&log, scene, Stretch::Shard(1, 1), law).unwrap_err();
                prop_assert_eq!(refused.to_string(), error.to_string());
                return Ok(());
            }
        };
        let shards = (1..=shards).map(|i| Stretch::Shard(i, shards));
        for all in [stretches(&cuts), shards.collect()] {
            let parts = all.iter().rev().map(|stretch| part(&log, scene, *stretch, law));
            let parts = parts.collect::<Result<Vec<_>, _>>().unwrap();
            let merged = merge_parts(&parts, scene).unwrap();
            prop_assert_eq!(merged.to_json().to_string(), whole.to_json().to_string(), "{:?}", all);
            prop_assert_eq!(merged.to_text(), whole.to_text());
            prop_assert_eq!(merged.certificate(), whole.certificate());
        }
    }
}

/// A log with ever new durations, whose energies have no common denominator that is kept exactly.
fn of_many_durations(rows: u64, more_decimals: usize) -> Scratch {
    let mut text = "tau,xi\n".to_owned();
    let mut time = 0_u64;
    for i in 0..rows {
        time += 1_000_003 + 2 * i * i;
        let (whole, decimals) = (time / 1_000_000, time % 1_000_000);
        let more = "0".repeat(more_decimals);
        text.push_str(&format!("{whole}.{decimals:06}{more}{},{}\n", i % 7, i % 3));
    }
    Scratch::new("csv", text.as_bytes())
}

#[test]
fn pieces_are_the_whole_whatever_the_durations_and_wherever_they_are_cut() {
    for (rows, more_decimals) in [(300, 150), (998, 0), (1001, 0), (1002, 0), (1600, 0)] {
        let log = of_many_durations(rows, more_decimals);
        let scene = &scenes()[0];
        let whole = audit(&log, scene, Options::default()).unwrap();
        let parts = stretches(&[1, 250, 999, 1000, 1200, 1201]).into_iter();
        let parts = parts.map(|stretch| part(&log, scene, stretch, false));
        let parts = parts.collect::<Result<Vec<_>, _>>().unwrap();
        let merged = merge_parts(&parts, scene).unwrap();
        assert_eq!(merged.to_json(), whole.to_json(), "{rows} rows");
    }
}

/// Positions and counts around the ends of a wall, at rest at times, with forces near its own.
fn around_the_ends(header: &str, rows: i32) -> Scratch {
    let mut text = format!("{header}\n");
    let (mut state, mut at, mut time) = (1_u32, 0, 0.0);
    for row in 0..rows {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let step = i32::try_from(state >> 24).unwrap() - 128;
        at += if row % 7 < 5 { step - at / 16 } else { 0 };
        time += 1.0 + f64::from(step.abs() % 8) / 8.0;
        // Some 16 ticks to both sides.
        let xi = f64::from(at) / 32.0;
        let force = f64::from(step) * 1e-5 - xi.clamp(0.0, 6.5) * 1.534e-3;
        match header {
            "xi" => text.push_str(&format!("{xi}\n")),
            "tau,xi" => text.push_str(&format!("{time},{xi}\n")),
            "tau,count" => text.push_str(&format!("{time},{}\n", xi.floor())),
            "t [ms],count,f [N m]" => {
                text.push_str(&format!("{time},{},{force:.6}\n", xi.floor()));
            }
            _ => text.push_str(&format!("{time},{:.7},{force:.6}\n", xi * 7.67e-4)),
        }
    }
    Scratch::new("csv", text.as_bytes())
}

#[test]
fn a_log_at_the_ends_of_a_wall_is_the_same_wherever_it_is_cut() {
    let headers = [
        "xi",
        "tau,xi",
        "tau,count",
        "t [ms],count,f [N m]",
        "t [ms],x [rad],f [N m]",
    ];
    let walls = ["unilateral = true\n", "max_force = \"0.01 N m\"\n"];
    for header in headers {
        // Behind the rows that are exact in any case.
        let log = around_the_ends(header, 1250);
        for wall in walls {
            let scene = &scene(&format!("{ROTARY}{wall}"));
            let whole = audit(&log, scene, Options::default()).unwrap();
            let whole = whole.to_json().to_string();
            // At nearly every row, and at some of them.
            for block in [16, 500] {
                let cut = audit(&log, scene, options(false, block)).unwrap();
                assert_eq!(cut.to_json().to_string(), whole, "{header} {wall} {block}");
            }
            let parts = stretches(&[1001, 1002, 1003, 1066, 1200]);
            let parts = parts
                .into_iter()
                .map(|stretch| part(&log, scene, stretch, false));
            let parts = parts.collect::<Result<Vec<_>, _>>().unwrap();
            let merged = merge_parts(&parts, scene).unwrap();
            assert_eq!(merged.to_json().to_string(), whole, "{header} {wall}");
        }
    }
}

#[test]
fn a_wrap_is_found_once_wherever_a_log_is_cut() {
    let scene = &scenes()[0];
    let counts = [9, 9, 8, 4104, 4105, 4104, 8, 9, 4105, 9, 9, 10, 4106];
    let text: String = counts.iter().map(|n| format!("{n}\n")).collect();
    let log = Scratch::new("csv", format!("count\n{text}").as_bytes());
    let whole = audit(&log, scene, Options::default()).unwrap();
    let said = &whole.report().findings[0].says;
    assert!(
        said.contains("rows 3 and 4") && said.contains("4 times more"),
        "{said}"
    );
    for cut in 0..14 {
        for more in cut..14 {
            let parts = stretches(&[cut, more]).into_iter();
            let parts = parts.map(|stretch| part(&log, scene, stretch, false));
            let parts = parts.collect::<Result<Vec<_>, _>>().unwrap();
            let merged = merge_parts(&parts, scene).unwrap();
            assert_eq!(merged.to_json(), whole.to_json(), "{cut} {more}");
        }
    }
}

#[test]
fn a_clock_that_is_too_fast_is_found_wherever_a_log_is_cut() {
    let scene = &scenes()[3];
    let log = |kind: &str, time: &dyn Fn(u32) -> f64| {
        let row = |i: u32| format!("{},{}\n", time(i), i % 31 % 2 * 10);
        let text: String = (0..62).map(row).collect();
        let log = Scratch::new("csv", format!("t [ms],count\n{text}").as_bytes());
        let whole = audit(&log, scene, Options::default()).unwrap();
        assert_eq!(whole.report().findings[0].kind, kind);
        assert_ne!(whole.verdict(), passivity_audit::Verdict::Holds);
        (log, whole)
    };
    // Seconds, with a pause, that are read as milliseconds; every second row of a log; and two of three.
    let too_fast = |i: u32| f64::from(i / 31 * 2000 + i) / 1000.0;
    let logs = [
        log("fast_clock", &too_fast),
        log("undersampled", &|i| f64::from(2 * i)),
        log("undersampled", &|i| f64::from(3 * (i / 2) + 2 * (i % 2))),
    ];
    for ((log, whole), cut) in logs
        .iter()
        .flat_map(|log| [1, 30, 31, 32, 61].map(|cut| (log, cut)))
    {
        let parts = stretches(&[cut, cut + 9]).into_iter();
        let parts = parts.map(|stretch| part(log, scene, stretch, false));
        let mut parts = parts.collect::<Result<Vec<_>, _>>().unwrap();
        let merged = merge_parts(&parts, scene).unwrap();
        assert_eq!(merged.to_json(), whole.to_json(), "{cut}");
        // An account that does not count short intervals is none.
        let json = parts.swap_remove(0).1.to_json().unwrap();
        let at = json.find(",\"short\":[").unwrap();
        let end = at + json[at..].find(']').unwrap();
        let older = format!("{}{}", &json[..at], &json[end + 1..]);
        let error = Partial::from_json(&older).unwrap_err().to_string();
        assert!(error.contains("missing field `short`"), "{error}");
        // One that says that it is older may lack more.
        let older = older.replacen("partial-4", "partial-3", 1);
        let error = Partial::from_json(&older).unwrap_err().to_string();
        assert!(
            error.contains("another version of this program, 0.1.0"),
            "{error}"
        );
    }
}

#[test]
fn a_piece_of_short_forces_knows_how_long_those_of_the_log_are() {
    // The law is −(n + ½) KΔ, and from row 6 on the force is limited.
    let limited = "3,-3\n".repeat(6);
    let text = format!("count,f\n0,-0.5\n1,-1.5\n2,-2.5\n1,-1.5\n2,-2.5\n{limited}");
    let log = Scratch::new("csv", text.as_bytes());
    let scene = &scene("[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n");
    let whole = audit(&log, scene, Options::default()).unwrap().to_json();
    assert_eq!(whole["force"]["mismatches"], 6);
    let parts = stretches(&[3, 8])
        .into_iter()
        .map(|stretch| part(&log, scene, stretch, false));
    let parts = parts.collect::<Result<Vec<_>, _>>().unwrap();
    assert_eq!(merge_parts(&parts, scene).unwrap().to_json(), whole);
}

#[test]
fn compressed_logs_and_streams_are_refused() {
    let scene = &scenes()[0];
    let log = Scratch::new("csv.gz", &[0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 3]);
    let error = part(&log, scene, Stretch::Shard(1, 2), false).unwrap_err();
    assert!(error.to_string().contains("decompress"), "{error}");
    let error = part(Path::new("-"), scene, Stretch::Shard(1, 2), false).unwrap_err();
    assert!(error.to_string().contains("standard input"), "{error}");
}

#[test]
fn a_changed_account_ends_in_a_report_or_an_error() {
    let scene = &scenes()[4];
    let walk: Vec<(i32, u32)> = (0..40_i32)
        .map(|i| (i % 5 - 2, u32::from(i % 7 == 0)))
        .collect();
    let log = Scratch::new("csv", &text(5, &walk, &[30], None, 0));
    let (name, first) = part(&log, scene, Stretch::Shard(1, 2), false).unwrap();
    let second = part(&log, scene, Stretch::Shard(2, 2), false).unwrap();
    let json = first.to_json().unwrap();
    let (mut refused, mut read) = (0, 0);
    let digits = json.char_indices().filter(|(_, c)| c.is_ascii_digit());
    for (at, _) in digits.step_by(844_usize.div_ceil(draws(1) as usize)) {
        for new in [
            "",
            "-",
            "0",
            "99999999999999999999",
            "18446744073709551615",
            "null",
            "/0",
        ] {
            let changed = format!("{}{new}{}", &json[..at], &json[at + 1..]);
            let Ok(part) = Partial::from_json(&changed) else {
                refused += 1;
                continue;
            };
            match merge_parts(&[(name.clone(), part), second.clone()], scene) {
                Ok(audit) => {
                    read += 1;
                    // Whatever it says, it can be said.
                    assert!(!audit.to_text().is_empty() && audit.to_json().is_object());
                }
                Err(error) => {
                    refused += 1;
                    // Of several files it says which.
                    assert!(error.to_string().contains("Shard("), "{changed}: {error}");
                }
            }
        }
    }
    assert!(refused > 20 && read > 5, "{refused} {read}");
}
