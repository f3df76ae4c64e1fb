//! The points of Fig. 5, every twentieth of the 1600: the closed form lies in the rigorous enclosure.
//!
//! The whole grid is gone through by `cargo bench -p passivity-sim --bench targets`.

use crate::common::paper;
use passivity_sim::{Detail, ExactOutcome, Method, simulate};

#[test]
fn closed_form_is_within_the_enclosure_and_its_outcome_is_the_same() {
    let (mut decided, mut points) = (0, 0);
    for i in 0..20 {
        for j in 0..20 {
            let index = i * 20 + j;
            if index % 5 != 3 {
                continue;
            }
            let speed = ["1/2", "1", "2", "5"][index % 4];
            let (beta, sigma) = (
                format!("{}/40", 2 * i + 1),
                format!("{}/80", 3 * (2 * j + 1)),
            );
            // Long enough for every motion that rests; a cycle is no other after more of it.
            let point = paper(&beta, &sigma, speed, 3_000);
            let fast = simulate(&point, &Method::ClosedForm, None).unwrap();
            let bound = simulate(&point, &Method::Enclosure, None).unwrap();
            points += 1;
            if bound.end.outcome.exact == ExactOutcome::Undecided {
                continue;
            }
            decided += 1;
            assert_eq!(
                fast.end.outcome, bound.end.outcome,
                "β {beta}, σ {sigma}, {speed}"
            );
            let Detail::Enclosed { ends: [xi, v], .. } = bound.detail else {
                panic!()
            };
            // The reach of the motion is at most the radius of growth or √μ·5 < 36.
            let reach = fast.end.xi.abs().max(36.0);
            for (x, [lo, hi]) in [(fast.end.xi, xi), (fast.end.velocity, v)] {
                let off = (x - lo).abs().max((x - hi).abs());
                assert!(
                    off < 1e-8 * reach,
                    "β {beta}, σ {sigma}, {speed}: {x} in [{lo}, {hi}]"
                );
            }
        }
    }
    assert_eq!(points, 80);
    assert!(
        decided * 100 >= 95 * points,
        "{decided} of {points} decided"
    );
}
