//! Rows of counts several at a time are those that are computed alone.

use passivity_core::quantizer;
use passivity_random::draws;
use proptest::prelude::*;

use super::super::*;
use super::{BETWEEN, EXACT, ball, ledger};
use crate::ledger::Ledger;
use crate::log::batch::Batch;
use crate::log::chunk::{Chunk, Samples};
use crate::log::counted;
use crate::log::motion::Addend;
use crate::log::numbers::Kind;
use crate::log::scale::Scale;
use crate::log::supply::Supplied;
use crate::number::Reduced;

/// Rows as they are computed alone, and in a tile.
fn alone_and_in_a_tile(
    ledger: &Ledger,
    counts: &[i64],
    lengths: &[(i64, i64)],
    forces: Option<&Readings>,
) -> Vec<[Option<counted::Figures>; 2]> {
    let quick = Quick::of(&Wall::of(ledger).unwrap());
    let mut tile = Counted::new();
    let lasts: Vec<_> = lengths.iter().map(|(n, d)| Length(*n, *d)).collect();
    tile.fill(&quick, (counts, forces), 0, &lasts, None);
    let rows = counts.windows(2).zip(lengths).take(TILE).enumerate();
    rows.map(|(i, (pair, (n, d)))| {
        let force = forces.map(|forces| forces.ball(i).unwrap());
        let alone = quick.figures([pair[0], pair[1]], Length(*n, *d), force);
        [alone, tile.get(i)]
    })
    .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(250)))]

    #[test]
    fn rows_of_counts_are_those_that_are_computed_alone(
        start in prop_oneof![3 => -40..40_i64, 1 => -1_000_000_000..1_000_000_000_i64, 1 => any::<i32>().prop_map(i64::from)],
        steps in prop::collection::vec(prop_oneof![4 => -3..4_i64, 1 => -3000..3000_i64], 1..TILE + 9),
        lengths in prop::collection::vec((1..5000_i64, 1..5000_i64), TILE + 9),
        forces in prop::collection::vec(ball(), TILE + 9),
        exact: bool,
        applied: bool,
    ) {
        let ledger = ledger(if exact { EXACT } else { BETWEEN });
        let steps = steps.iter().scan(start, |at, step| {
            *at += step;
            Some(*at)
        });
        let counts: Vec<i64> = std::iter::once(start).chain(steps).collect();
        let mut readings = Readings::new(Kind::Force, &Scale::One);
        forces.iter().for_each(|force| readings.near.push(*force));
        let forces = applied.then_some(&readings);
        for [alone, found] in alone_and_in_a_tile(&ledger, &counts, &lengths, forces) {
            prop_assert_eq!(alone, found);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(250)))]

    #[test]
    fn sums_of_counts_are_those_of_one_row_after_the_other(
        start in prop_oneof![3 => -40..40_i64, 1 => -1_000_000_000..1_000_000_000_i64],
        steps in prop::collection::vec(prop_oneof![8 => -3..4_i64, 1 => -31..32_i64, 1 => -40..40_i64], TILE),
        lengths in prop::collection::vec((1..5000_i64, 1..5000_i64), TILE),
        forces in prop::collection::vec((-1e9..1e9_f64, 0..6, 0.0..1e-12), TILE),
        [exact, applied, running] in any::<[bool; 3]>(),
        ends in (0..TILE, 0..TILE),
        before in (-1_000_000..1_000_000_i128, 0..3_i128),
        room in (60..76_u32).prop_map(|bits| 1_i128 << bits),
    ) {
        let ledger = ledger(if exact { EXACT } else { BETWEEN });
        let mut counts = vec![start];
        counts.extend(steps.iter().scan(start, |at, step| {
            *at += step;
            Some(*at)
        }));
        let mut readings = Readings::new(Kind::Force, &Scale::One);
        for (count, (more, size, radius)) in counts.iter().zip(&forces) {
            // From far off to nearly, and just, the wall's own.
            let more = if *size == 0 { 0.0 } else { more / 1e3_f64.powi(*size) };
            let force = quantizer::held_force(&Ball::whole(*count)) + Ball::from_parts(more, radius * more.abs());
            readings.near.push(force);
        }
        let forces = applied.then_some(&readings);
        let mut tile = Counted::new();
        let lasts: Vec<_> = lengths.iter().map(|(n, d)| Length(*n, *d)).collect();
        let quick = Quick::of(&Wall::of(&ledger).unwrap());
        tile.fill(&quick, (&counts, forces), 0, &lasts, None);
        let unit = crate::span::ONE;
        let before = [before.0, before.0 + before.1].map(|n| Reduced::Small(n << 40, unit));
        let rows = tile.decided(ends.0.min(ends.1), ends.0.abs_diff(ends.1));
        let mut alone = Batch::after(Some(before), false);
        if !rows.is_empty() {
            tile.add_up(&rows, running, alone.excess()).unwrap();
            let sums = tile.sums(&rows);
            let (mut net, mut observed) = (0, 0);
            for i in rows.clone() {
                let (found, figures) = (tile.sums(&(rows.start..i + 1)), tile.figures(i).unwrap());
                net += figures.sums[3][0];
                observed += figures.observed;
                prop_assert!(sums.least_row <= figures.sums[3][0] && sums.least_net <= net);
                prop_assert!(sums.least_stored <= net + figures.stored[0] && sums.least_observed <= observed);
                let least = sums.least_supply.iter().zip(sums.least_supplied);
                let added = found.supply.iter().zip(figures.stored);
                for ((sum, end), (alone, with_end)) in added.zip(least) {
                    prop_assert!(alone <= sum && (with_end <= sum + end || !running));
                }
            }
            prop_assert_eq!((sums.sums[3][0], sums.observed), (net, observed));
        }
        for _ in 0..3 {
            // Again and again: what the energies fall below the first time, they may not the next.
            let mut together = alone.clone();
            prop_assert_eq!(together.add_tile((&mut *tile, rows.clone()), running), rows.len());
            for i in rows.clone() {
                let figures = tile.figures(i).unwrap();
                let supply = running.then(|| figures.contribution().supplied(alone.excess()).unwrap());
                prop_assert!(supply.as_ref().is_none_or(Supplied::fits));
                alone.add(&figures.addend(), supply).unwrap();
            }
            prop_assert_eq!(format!("{alone:?}"), format!("{together:?}"));
            // Room for sums that get just below what they were, or far from it.
            let added = Addend { sums: [[room; 2]; 5], observed: room, potential: [0; 2], truths: truths(tile.covers[0]) };
            let supply = Supplied { step: [room; 2], end: [0; 2], excess: alone.excess().cloned() };
            alone.add(&added, running.then_some(supply)).unwrap();
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(250)))]

    #[test]
    fn rows_by_the_law_beside_others_are_those_that_are_computed_alone(
        start in -40..40_i64,
        steps in prop::collection::vec(prop_oneof![8 => -3..4_i64, 1 => -3000..3000_i64], 1..TILE + 9),
        lengths in prop::collection::vec((1..50_000_i64, 1..50_000_i64), TILE + 9),
        forces in prop::collection::vec(ball(), TILE + 9),
    ) {
        let mut counts = vec![start];
        counts.extend(steps.iter().scan(start, |at, step| {
            *at += step;
            Some(*at)
        }));
        let mut readings = Readings::new(Kind::Force, &Scale::One);
        forces.iter().for_each(|force| readings.near.push(*force));
        let quick = Quick::of(&Wall::of(&ledger(EXACT)).unwrap());
        let lasts: Vec<_> = lengths.iter().map(|(n, d)| Length(*n, *d)).collect();
        let (mut tile, mut found) = (Counted::new(), ManyByLaw::default());
        tile.fill(&quick, (&counts, Some(&readings)), 0, &lasts, Some(&mut found));
        let rows = counts.windows(2).zip(&lasts).take(TILE);
        // A row of one period is one of exact numbers.
        let alone: Option<Vec<counted::Figures>> = rows
            .map(|(pair, length)| {
                let figures = quick.figures([pair[0], pair[1]], *length, None);
                figures.filter(|_| length.0 != length.1)
            })
            .collect();
        let found = found.from(0);
        prop_assert_eq!(found.is_some(), alone.is_some());
        for (alone, (found, answers)) in alone.iter().zip(found) {
            prop_assert_eq!((found.at, found.len), (0, alone.len()));
            let mut sums = [[0; 2]; 5];
            for row in alone {
                let ends = sums.as_flattened_mut().iter_mut();
                ends.zip(row.sums.as_flattened()).for_each(|(sum, x)| *sum += x);
            }
            prop_assert_eq!(sums, found.sums);
            let all: usize = answers.iter().map(|(_, _, times)| times).sum();
            prop_assert_eq!(all, alone.len());
            for (truths, first, times) in answers {
                let same = alone.iter().map(|row| row.truths == *truths);
                prop_assert_eq!(same.clone().position(|is| is), Some(*first));
                prop_assert_eq!(same.filter(|is| *is).count(), *times);
            }
        }
    }
}

#[test]
fn all_rows_of_a_log_of_counts_are_decided() {
    for text in [EXACT, BETWEEN] {
        let counts: Vec<i64> = (0..=TILE as i64).map(|i| (i * 7 % 23) / 3 - 4).collect();
        let lengths: Vec<_> = (0..TILE as i64).map(|i| (900 + i * 3, 1000)).collect();
        let mut forces = Readings::new(Kind::Force, &Scale::One);
        let held = counts
            .iter()
            .map(|n| quantizer::held_force(&Ball::whole(*n)));
        held.for_each(|force| {
            forces
                .near
                .push(force + Ball::from_parts(0.013, f64::EPSILON))
        });
        let mut by_law = ManyByLaw::default();
        let quick = Quick::of(&Wall::of(&ledger(text)).unwrap());
        let lasts: Vec<_> = lengths.iter().map(|(n, d)| Length(*n, *d)).collect();
        let of = (&*counts, Some(&forces));
        Counted::new().fill(&quick, of, 0, &lasts, Some(&mut by_law));
        // Of friction between two values they are computed again.
        assert_eq!(by_law.from(0).is_some(), text == EXACT);
        for forces in [None, Some(&forces)] {
            let rows = alone_and_in_a_tile(&ledger(text), &counts, &lengths, forces);
            assert_eq!(rows.len(), TILE);
            assert!(rows.iter().flatten().all(Option::is_some));
        }
    }
}

#[test]
fn forces_of_a_wall_that_ends_are_those_of_its_controller() {
    let ledger = ledger(
        "[device]\nmass = \"75 g\"\ncoulomb = \"0.04 N\"\n[sampling]\nperiod = \"1 ms\"\n[encoder]\nresolution = \"0.03 mm\"\n\
         [wall]\nstiffness = \"1 N/mm\"\nunilateral = true\nmax_force = \"0.31 N\"\n",
    );
    let counts: Vec<i64> = (-20..20).collect();
    let chunk = Chunk {
        samples: Samples::Counts(counts.clone()),
        ..Chunk::default()
    };
    let found = commanded(Wall::of(&ledger).as_ref(), &chunk);
    let controller = &ledger.near().controller;
    for (n, force) in counts.into_iter().zip(found) {
        let measured = controller.measured(&Ball::whole(n));
        let held = controller.held_force(&[measured]).near();
        // It becomes saturated in the tick from ten on: that one is left open.
        assert!(
            Some(force) == held || n == 10 && force.is_nan(),
            "{n}: {force} {held:?}"
        );
    }
}
