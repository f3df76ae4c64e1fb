//! TH-COUNTS: the closed form of the extremes of an interval between two counts, against grids.

use passivity_core::counted::{Crossing, Resistance};
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{BigRational, Friction, Loop, Step};
use proptest::prelude::*;

use crate::common::{half, magnitude, q, sampled};

/// How many steps a tick has on the grid.
const GRID: i64 = 12;

sampled! {
    /// No row between the two ticks is beyond the ends, and on the grid around the least and the most there are rows
    /// near them.
    fn th_counts_closed_form_against_a_grid(
        (from, ticks) in (-3..4_i64, -3..4_i64),
        force in -20..21_i64,
        [beta, sigma, dtau] in [0..20_i64, 0..20_i64, 1..12_i64],
    ) {
        let friction = Friction::new(q(beta, 8), q(sigma, 8));
        let (wall, dtau) = (Loop::plain(friction.clone()), q(dtau, 4));
        let force = q(force, 4);
        let crossing = Crossing { ticks: q(ticks, 1), excess: &force + q(from, 1) + half() };
        let resistance = Resistance::new(&friction, &dtau);
        let [linear, quantized] = crossing.generated();
        let ([a, b], [c, d]) = (crossing.net_at_least(&resistance), crossing.net_at_most(&resistance));
        let ranges = [linear, quantized, [a, c], [b, d]];
        let [near, far] = crossing.distances();
        let mut found: [Option<[BigRational; 2]>; 4] = [const { None }; 4];
        for (x, y) in (0..=GRID).flat_map(|x| (0..=GRID).map(move |y| (x, y))) {
            let step = Step::new(q(from, 1) + q(x, GRID), q(from + ticks, 1) + q(y, GRID));
            let distance = magnitude(&step.displacement());
            prop_assert!(near <= distance && distance <= far);
            let held = HeldInterval { step, force: force.clone(), dtau: dtau.clone(), extra_storage: None };
            let row = ledger::row(&wall, &held);
            let figures = [row.generated_linear, row.generated_quantized, row.net_linear, row.net_quantized];
            for ((range, found), here) in ranges.iter().zip(&mut found).zip(figures) {
                prop_assert!(range[0] <= here && here <= range[1]);
                *found = Some(match found.take() {
                    None => [here.clone(), here],
                    Some([least, most]) => [least.min(here.clone()), most.max(here)],
                });
            }
        }
        // A parabola is off by its bend times the square of half a step at most.
        let room = (q(beta, 8) / &dtau + half()) * q(1, 4 * GRID * GRID);
        for (range, found) in ranges.iter().zip(&found) {
            let [least, most] = found.clone().unwrap();
            prop_assert!(least - &range[0] <= room && &range[1] - most <= room);
        }
    }
}
