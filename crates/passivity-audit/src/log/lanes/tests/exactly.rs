//! Rows of known positions are written as those of the kernel's exact numbers are.

use passivity_random::draws;
use proptest::prelude::*;

use super::super::exactly::{Latest, Written as _};
use super::super::*;
use crate::ledger::Ledger;
use crate::log::header::Heading;
use crate::log::layout::Layout;
use crate::log::numbers::Numbers;
use crate::log::preview::Preview;
use crate::number::Number;
use crate::rows::Form;
use passivity_scene::Scene;

/// A wall of long decimals, on one side or on both.
fn scene() -> impl Strategy<Value = String> {
    let viscous = prop_oneof![
        Just(""),
        Just("viscous = \"0.00123456789 N s/mm\"\n"),
        Just("viscous = \"7 N s/m ± 10%\"\n")
    ];
    let coulomb = prop_oneof![Just("0.04 N"), Just("0.0432109876 N"), Just("0.04 N ± 20%")];
    let period = prop_oneof![Just("1 ms"), Just("0.987654321 ms")];
    let resolution = prop_oneof![Just("0.03 mm"), Just("0.0304567 mm"), Just("0.0078125 mm")];
    let stiffness = prop_oneof![Just("1 N/mm"), Just("1.2345 N/mm")];
    let limit = prop_oneof![
        Just(""),
        Just("max_force = \"0.3 N\"\n"),
        Just("max_force = \"0.01 N\"\n")
    ];
    (viscous, coulomb, period, resolution, stiffness, limit, any::<bool>()).prop_map(
        |(viscous, coulomb, period, resolution, stiffness, limit, one_sided)| {
            format!(
                "[device]\nmass = \"75 g\"\n{viscous}coulomb = \"{coulomb}\"\n[sampling]\nperiod = \"{period}\"\n\
                [encoder]\nresolution = \"{resolution}\"\n[wall]\nstiffness = \"{stiffness}\"\nunilateral = {one_sided}\n{limit}"
            )
        },
    )
}

/// Of rows of a log, how many are written at once: as by the kernel's numbers.
fn written(
    scene: &Scene,
    columns: &[&str],
    chunk: impl Fn(&mut Chunk),
) -> Result<[usize; 2], TestCaseError> {
    let ledger = Ledger::of_scene(scene);
    let headings = columns
        .iter()
        .map(|name| Heading::plain((*name).to_owned()));
    let layout = Layout::read(headings.collect(), None, &Preview::of_rows(&[]), scene).unwrap();
    let applied = layout.force.is_some();
    let form = Form {
        enclosures: columns.contains(&"count") || !ledger.wide().friction_is_exact(),
        force: applied,
        accounted: true,
    };
    let task = Task {
        rows: Some(form),
        ..Task::new(scene, &ledger, &layout, false)
    };
    let mut read = Chunk::new(&layout);
    chunk(&mut read);
    prop_assert!(read.complete(&layout).is_ok());
    let mut tiles = Tiles::default();
    tiles.fill(&task, &read);
    let forces = applied.then_some(&read.forces.values);
    let mut found = 0;
    let rows = read.samples.len() - 1;
    let mut latest = Latest::new();
    for i in 0..rows {
        let mut out = Vec::new();
        let (to, length) = (
            (&mut latest, &mut out),
            tiles.lengths.get(i).copied().unwrap_or_default(),
        );
        let is_written = match &read.samples {
            Samples::Any(samples) => tiles
                .exactly
                .as_ref()
                .and_then(|all| all.write((samples, forces, i), length, form, to)),
            Samples::Counts(counts) => tiles
                .exactly_counts
                .as_ref()
                .and_then(|all| all.write((counts, forces, i), length, form, to)),
        };
        if is_written.is_none() {
            prop_assert!(out.is_empty());
            continue;
        }
        found += 1;
        let row = ledger.row(&task.logged(&read, i).unwrap()).unwrap();
        let mut expected = Vec::new();
        form.write_positions(&row, &mut expected).unwrap();
        form.write_account(&row, &mut expected).unwrap();
        let [found, expected] = [out, expected].map(|text| String::from_utf8(text).unwrap());
        prop_assert_eq!(found, expected, "{} {:?}", i, task.logged(&read, i));
    }
    Ok([found, rows])
}

/// Appends decimals, or the doubles nearest to them.
fn push(readings: &mut Readings, decimals: &[(i64, u8)], doubles: bool) {
    if doubles {
        let near = |(n, k): &(i64, u8)| *n as f64 / 10_f64.powi((*k).into());
        let values = decimals.iter().map(near).collect();
        readings.push_all(Numbers::Doubles(values)).unwrap();
    } else {
        decimals
            .iter()
            .for_each(|(n, k)| readings.push_decimal(*n, *k));
    }
}

/// Appends forces to a chunk.
fn push_forces(chunk: &mut Chunk, decimals: &[(i64, u8)], doubles: bool) {
    push(&mut chunk.forces.values, decimals, doubles);
    chunk.forces.roundings.resize(decimals.len(), 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(150)))]

    #[test]
    fn rows_of_decimals_are_those_of_exact_numbers(
        scene in scene(),
        rows in prop::collection::vec((-40_000..40_000_i64, 0..4_u8, -30_000..30_000_i64, 0..6_u8, 1..2_000_000_i64), 2..40),
        (near, any, decimals) in (-20_000..20_000_i64, 0..8_u8, 0..5_u8),
        (reversed, has_force, is_even, doubles) in any::<(bool, bool, bool, [bool; 2])>(),
    ) {
        let scene = Scene::from_toml("s", &scene).unwrap();
        let position = if reversed { "x [um]" } else { "x [mm]" };
        let columns: &[&str] = match (has_force, is_even) {
            (true, false) => &[position, "t [ns]", "f [N]"],
            (false, false) => &[position, "t [ns]"],
            (true, true) => &[position, "f [N]"],
            (false, true) => &[position],
        };
        let fill = |chunk: &mut Chunk| {
            let positions: Vec<_> = rows.iter().map(|(x, how, ..)| match how {
                // Some that are close to each other, and on the ends of ticks.
                0 => (near + x % 100, decimals),
                1 => (x / 30 * 30, 2),
                2 => (x % 3000, decimals.min(3)),
                _ => (if any == 0 { x << 40 } else { *x }, decimals),
            }).collect();
            let Samples::Any(samples) = &mut chunk.samples else { return };
            push(samples, &positions, doubles[0]);
            if has_force {
                let forces: Vec<_> = rows.iter().map(|(_, _, f, k, _)| (*f, *k)).collect();
                push_forces(chunk, &forces, doubles[1]);
            }
            if !is_even {
                let mut t = 1_700_000_000_000_000_000;
                for (.., dt) in &rows {
                    chunk.times.push_decimal(t, 0);
                    t += dt;
                }
            }
        };
        written(&scene, columns, fill)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(150)))]

    #[test]
    fn rows_of_counts_are_those_of_exact_numbers(
        scene in scene(),
        rows in prop::collection::vec((-3..4_i64, 0..20_u8, -30_000..30_000_i64, 0..6_u8, 1..2_000_000_i64), 2..40),
        start in prop_oneof![2 => -20..20_i64, 1 => -1000..1000_i64],
        (has_force, is_even, doubles) in any::<(bool, bool, bool)>(),
    ) {
        let scene = Scene::from_toml("s", &scene).unwrap();
        let columns: &[&str] = match (has_force, is_even) {
            (true, false) => &["count", "t [ns]", "f [N]"],
            (false, false) => &["count", "t [ns]"],
            (true, true) => &["count", "f [N]"],
            (false, true) => &["count"],
        };
        let fill = |chunk: &mut Chunk| {
            let (mut t, mut at, mut forces) = (1_700_000_000_000_000_000, start, Vec::new());
            for (step, how, f, k, dt) in &rows {
                at += if *how == 0 { step * 1_000_000 } else { *step };
                let Samples::Counts(counts) = &mut chunk.samples else { continue };
                counts.push(at);
                // Of all sizes, and close to that of the wall.
                forces.push(if *how < 10 { (*f, *k) } else { (f / 1000 - 30 * at, 3) });
                if !is_even {
                    chunk.times.push_decimal(t, 0);
                    t += dt;
                }
            }
            if has_force {
                push_forces(chunk, &forces, doubles);
            }
        };
        written(&scene, columns, fill)?;
    }
}

#[test]
fn most_rows_of_counts_are_written_at_once() {
    let one_sided = LONG.to_owned() + "unilateral = true\nmax_force = \"1 N\"\n";
    for text in [LONG, &one_sided] {
        let scene = Scene::from_toml("s", text).unwrap();
        for (columns, doubles) in [
            (&["count", "t [ns]"][..], false),
            (&["count", "t [ns]", "f [N]"], false),
            (&["count", "t [ns]", "f [N]"], true),
            (&["count", "f [N]"], true),
        ] {
            let fill = |chunk: &mut Chunk| {
                let mut forces = Vec::new();
                for i in 0..500_i64 {
                    let at = i * i % 997 / 40;
                    let Samples::Counts(counts) = &mut chunk.samples else {
                        return;
                    };
                    counts.push(at);
                    if columns.contains(&"t [ns]") {
                        chunk.times.push_decimal(i * 987_654 + i * i % 997, 0);
                    }
                    forces.push((-at * 30 - i % 40, 3));
                }
                if columns.contains(&"f [N]") {
                    push_forces(chunk, &forces, doubles);
                }
            };
            let [found, rows] = written(&scene, columns, fill).unwrap();
            assert_eq!(found, rows, "{columns:?} {doubles}");
        }
    }
}

/// A scene of long decimals.
const LONG: &str = "[device]\nmass = \"75 g\"\nviscous = \"0.00123456789 N s/mm\"\ncoulomb = \"0.0432109876 N\"\n[sampling]\n\
    period = \"0.987654321 ms\"\n[encoder]\nresolution = \"0.0304567 mm\"\n[wall]\nstiffness = \"1.2345 N/mm\"\n";

#[test]
fn most_rows_are_written_at_once() {
    let two_sided = Scene::from_toml("s", LONG).unwrap();
    let one_sided = LONG.to_owned() + "unilateral = true\nmax_force = \"1 N\"\n";
    let one_sided = Scene::from_toml("s", &one_sided).unwrap();
    for scene in [&two_sided, &one_sided] {
        for columns in [
            &["x [um]"][..],
            &["x [um]", "t [ns]"],
            &["x [um]", "t [ns]", "f [N]"],
            &["x [um]", "f [N]"],
        ] {
            // As decimals, as doubles that are whole quarters, and as any doubles.
            for (doubles, over) in [(false, 1.0), (true, 4.0), (true, 10.0)] {
                let fill = |chunk: &mut Chunk| {
                    let Samples::Any(samples) = &mut chunk.samples else {
                        return;
                    };
                    let positions = (0..500_i32).map(|i| (i - 250) * 17 % 4001 + i % 7);
                    if doubles {
                        let positions = positions.map(|x| f64::from(x) / over).collect();
                        samples.push_all(Numbers::Doubles(positions)).unwrap();
                    } else {
                        positions.for_each(|x| samples.push_decimal(x.into(), 0));
                    }
                    for i in 0..500_i64 {
                        if columns.contains(&"t [ns]") {
                            chunk.times.push_decimal(i * 987_654 + i * i % 997, 0);
                        }
                    }
                    if columns.contains(&"f [N]") {
                        let forces: Vec<_> = (0..500).map(|i| (-(i * i % 997), 3)).collect();
                        push_forces(chunk, &forces, over == 10.0);
                    }
                };
                let [found, rows] = written(scene, columns, fill).unwrap();
                assert!(
                    10 * found > 9 * rows,
                    "{columns:?} {doubles} {over} {found} of {rows}"
                );
            }
        }
    }
}

#[test]
fn a_length_of_any_denominator_is_written() {
    let scene = Scene::from_toml("s", super::EXACT).unwrap();
    let fill = |chunk: &mut Chunk| {
        let Samples::Any(samples) = &mut chunk.samples else {
            return;
        };
        for i in 0..200_i64 {
            samples.push_decimal(i * i % 71 - 30, 1);
            chunk.dtaus.push(Number::Small(1 + i % 13, 1 + i % 4));
        }
    };
    let [found, _] = written(&scene, &["xi"], fill).unwrap();
    assert!(found > 50);
}
