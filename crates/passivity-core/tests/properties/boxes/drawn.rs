//! Boxes of loops as they are drawn.

use passivity_core::{BigRational, Interval, Loop};
use proptest::prelude::*;

use super::Box;
use crate::common::{coefficient, q, unit};

/// An interval above zero: a point, narrow, or wide.
pub(super) fn interval() -> impl Strategy<Value = Interval<BigRational>> {
    let width = prop_oneof![3 => (1i64..65).prop_map(|n| q(n, 64)), 1 => unit()];
    (coefficient(), width, 0u8..3).prop_map(|(x, width, kind)| {
        let x = x + q(1, 64);
        let hi = match kind {
            0 => x.clone(),
            1 => &x + width / q(1000, 1),
            _ => &x + width,
        };
        Interval::new(x, hi).unwrap()
    })
}

pub(super) fn boxes() -> impl Strategy<Value = Box> {
    let option = || prop::option::weighted(0.7, interval());
    (
        (interval(), interval(), option(), option()),
        (option(), option(), option(), 0u16..3),
    )
        .prop_map(
            |((stiffness, period, viscous, coulomb), (resolution, damping, force_step, delay))| {
                Loop {
                    viscous,
                    coulomb,
                    resolution,
                    damping,
                    force_step,
                    delay,
                    ..Loop::new(stiffness, period)
                }
            },
        )
}

/// Boxes near the border of the criterion, with damping behind an encoder.
pub(super) fn boxes_pulled_both_ways() -> impl Strategy<Value = Box> {
    let around = |x: i64| {
        (x - 9..x + 10, 0i64..6)
            .prop_map(move |(n, width)| Interval::new(q(n, 20), q(n + width, 20)).unwrap())
    };
    let point_or = |x: i64| prop_oneof![Just(Interval::point(q(x, 20))), around(x)];
    (
        (point_or(20), (4i64..21, 0i64..30), around(16), around(18)),
        (
            point_or(20),
            point_or(10),
            prop::option::of(around(10)),
            0u16..2,
        ),
    )
        .prop_map(
            |(
                (stiffness, (shortest, width), viscous, coulomb),
                (resolution, damping, step, delay),
            )| {
                let period = Interval::new(q(shortest, 20), q(shortest + width, 20)).unwrap();
                Loop {
                    viscous: Some(viscous),
                    coulomb: Some(coulomb),
                    resolution: Some(resolution),
                    damping: Some(damping),
                    force_step: step,
                    delay,
                    ..Loop::new(stiffness, period)
                }
            },
        )
}

pub(super) fn any_box() -> impl Strategy<Value = Box> {
    prop_oneof![boxes(), boxes_pulled_both_ways()]
}
