//! TH-COUNTS: extremes over what is known of two positions, against grids.

use passivity_core::extremes::{Parabola, farthest, nearest, through};
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{Friction, Loop, Scalar as _, Step};
use proptest::prelude::*;

use crate::common::{magnitude, q, sampled};

sampled! {
    /// Nothing on the interval is beyond the extremes, and they are reached.
    fn th_counts_parabola_against_a_grid(
        [a, s, g, k] in prop::array::uniform4(-12..13_i64),
        from in -40..41_i64,
        width in 0..60_i64,
    ) {
        let n = |n: i64| q(n, 8);
        let parabola = Parabola { square: n(a), magnitude: n(s.abs()), linear: n(g), constant: n(k) };
        let [least, most] = parabola.range(&n(from), &n(from + width)).unwrap();
        let values: Vec<_> = (0..=16 * width).map(|i| parabola.at(&q(16 * from + i, 128))).collect();
        for value in &values {
            prop_assert!(least <= *value && *value <= most);
        }
        // A vertex is at most half a step of 1/128 from the grid: α(1/256)² ≤ 13/8/65536.
        let slack = q(13, 8 * 65536);
        let near = |end| values.iter().any(|value| magnitude(&(value - &end)) <= slack);
        prop_assert!(near(least) && near(most));
    }

    /// No two positions are nearer or farther, and the two found are among them.
    fn th_counts_distances_against_a_grid(
        [a, c] in prop::array::uniform2(-12..13_i64),
        [b, d] in prop::array::uniform2(0..9_i64),
    ) {
        let (start, end) = ([q(a, 4), q(a + b, 4)], [q(c, 4), q(c + d, 4)]);
        let ends = (start.each_ref(), end.each_ref());
        let length = |[from, to]: [_; 2]| magnitude(&(to - from));
        let (near, far) = (nearest(ends.0, ends.1).unwrap(), farthest(ends.0, ends.1).unwrap());
        for pair in [near, far] {
            prop_assert!(start[0] <= *pair[0] && *pair[0] <= start[1]);
            prop_assert!(end[0] <= *pair[1] && *pair[1] <= end[1]);
        }
        for (i, j) in (0..=b).flat_map(|i| (0..=d).map(move |j| (i, j))) {
            let here = magnitude(&(q(c + j, 4) - q(a + i, 4)));
            prop_assert!(length(near) <= here && here <= length(far));
        }
    }

    /// Along each edge of two ticks generated energy is the parabola through three of its values.
    fn th_counts_edges(
        [n0, n1] in prop::array::uniform2(-3..4_i64),
        share in 0..17_i64,
        force in -9..10_i64,
        edge in 0..4_usize,
    ) {
        let wall = Loop::plain(Friction::new(q(1, 1), q(1, 1)));
        let generated = |[from, to]: [_; 2]| {
            let step = Step::new(from, to);
            ledger::generated(&wall, &HeldInterval { step, force: q(force, 2), dtau: q(1, 1), extra_storage: None })
        };
        let at = |share| {
            let along = |n: i64| q(n, 1) + q(share, 16);
            let other = |n: i64| q(n + i64::from(edge % 2 == 1), 1);
            if edge < 2 { [along(n0), other(n1)] } else { [other(n0), along(n1)] }
        };
        let d = |[from, to]: [_; 2]| to - from;
        let [first, middle, last] = [0, 8, 16].map(|share| generated(at(share)));
        for account in [0, 1] {
            let values = [&first, &middle, &last].map(|values| values[account].clone());
            let [alpha, gamma, kappa] = through(values, [d(at(0)), d(at(16))]).unwrap();
            let here = d(at(share));
            let curve = &alpha * here.square() + &gamma * &here + &kappa;
            prop_assert_eq!(curve, generated(at(share))[account].clone());
        }
    }
}
