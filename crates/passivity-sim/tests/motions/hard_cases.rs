//! Cases that break simulators, each against the reference's digits (issue: hard cases).
//!
//! The bound of the closed form's error, in doubles, after N intervals of a motion with reach R and
//! greatest speed V under forces up to U: in each interval the velocity is rounded a dozen times, each
//! by at most ½ε of a number below 2V, and the parameters are rounded once, which moves the
//! acceleration by εU/μ and the velocity by φ₁ of that: 16ε(V + φ₁U/μ) = W in all. Such errors do not
//! grow from interval to interval (the motion under a held force is not expanding), so they sum to
//! NW. Positions are off by what the velocities were, N·NW, and by their own roundings, 16NεR. A
//! sample on the other side of an edge would be a force off by a whole tick: far outside.

use crate::common::{paper, point, q};
use passivity_random::draws;
use passivity_scene::Point;
use passivity_sim::{ExactOutcome, Line, Method, Simulated, simulate};

const REFERENCE: Method = Method::Reference { digits: 60 };

/// A run with its reach and its greatest speed.
fn watched(point: &Point, method: &Method) -> (Simulated, f64, f64) {
    let (mut reach, mut speed) = (0.0_f64, 0.0_f64);
    let mut see = |line: &Line<'_>| {
        let Line::Double(entry) = line else {
            return true;
        };
        for x in [
            entry.xi0,
            entry.xi1,
            entry.v0,
            entry.v1,
            entry.dissipated,
            entry.residual,
        ] {
            assert!(!x.is_nan(), "{entry:?}");
        }
        reach = reach.max(entry.xi0.abs()).max(entry.xi1.abs());
        speed = speed.max(entry.v0.abs()).max(entry.v1.abs());
        true
    };
    let run = simulate(point, method, Some(&mut see)).unwrap();
    (run, reach, speed)
}

/// The closed form meets its bound, its balance and the reference's outcome.
fn holds(name: &str, point: &Point) -> Simulated {
    let (slow, reach, speed) = watched(point, &REFERENCE);
    let (fast, ..) = watched(point, &Method::ClosedForm);
    let (got, want) = (&fast.end, &slow.end);
    assert_eq!(
        got.outcome.exact, want.outcome.exact,
        "{name}: {got:?} {want:?}"
    );
    assert_eq!(got.outcome.paper, want.outcome.paper, "{name}");
    assert_eq!(got.intervals, want.intervals, "{name}");
    let (mu, sigma) = (&point.at.inertia, &point.at.coulomb);
    let of = |x: &Option<_>| x.as_ref().map_or(0.0, crate::common::double);
    let pull = reach
        + 1.0
        + of(sigma)
        + point
            .forces
            .iter()
            .flatten()
            .map(crate::common::double)
            .fold(0.0, f64::max);
    let n = got.intervals.max(1) as f64;
    let least = f64::MIN_POSITIVE; // below it ε is no longer relative
    // φ₁(−λ) = (1 − e^(−λ))/λ, 1 without viscous friction.
    let lambda = of(&point.at.viscous) / of(mu);
    let mean = if lambda == 0.0 {
        1.0
    } else {
        -(-lambda).exp_m1() / lambda
    };
    let velocity = 16.0 * n * f64::EPSILON * (speed + mean * pull / of(mu)) + n * least;
    let position = n * velocity + 16.0 * n * f64::EPSILON * reach;
    let off = [
        (got.xi - want.xi).abs(),
        (got.velocity - want.velocity).abs(),
    ];
    assert!(
        off[0] <= position,
        "{name}: ξ off by {:e}, bound {position:e}",
        off[0]
    );
    assert!(
        off[1] <= velocity,
        "{name}: ξ̇ off by {:e}, bound {velocity:e}",
        off[1]
    );
    // The balance of one interval: a dozen roundings of energies, none above this sum.
    let energy = of(mu) * speed * speed + 4.0 * pull * speed.max(reach);
    let residual = fast.totals.residual_max;
    // The table of docs/simulator.md, with `--nocapture`.
    let worst = (off[0] / position).max(off[1] / velocity);
    let part = residual / (16.0 * f64::EPSILON * energy + least);
    eprintln!(
        "| {name} | {} | {:.1e} | {position:.1e} | {worst:.3} | {part:.3} |",
        got.intervals, off[0]
    );
    assert!(
        residual <= 16.0 * f64::EPSILON * energy + least,
        "{name}: residual {residual:e} of {energy:e}"
    );
    fast
}

#[test]
fn beta_from_zero_through_1e_300_to_1000() {
    for beta in [
        "0", "1e-300", "1e-100", "1e-16", "1e-9", "1e-3", "1/2", "1", "10", "50", "1000",
    ] {
        holds(&format!("β = {beta}"), &paper(beta, "3/5", "2", 150));
        holds(
            &format!("β = {beta}, cycle"),
            &paper(beta, "1/10", "1/7", 150),
        );
    }
}

#[test]
fn mu_from_1e_6_to_1e9() {
    for mu in ["1e-6", "1e-3", "1/20", "1", "40", "1e4", "1e9"] {
        for beta in ["3/5", "1e-6", "0"] {
            let scene = point(mu, beta, "3/5", ["1/3", "3/2"], 120);
            let run = holds(&format!("μ = {mu}, β = {beta}"), &scene);
            assert!(run.end.xi.is_finite());
        }
    }
}

#[test]
fn samples_exactly_on_encoder_edges() {
    // The start is on an edge, exactly; the samples after it are where rationals say.
    for (start, sigma) in [
        (["1", "0"], "1/4"),
        (["-1", "1/2"], "1/2"),
        (["0", "-1"], "1/8"),
        (["3", "-2"], "1/4"),
    ] {
        let mut scene = point("4", "0", sigma, start, 12);
        let fast = holds("on edges", &scene);
        scene.at.viscous = None;
        let exact = simulate(&scene, &Method::Exact, None).unwrap();
        assert_eq!(fast.end.outcome, exact.end.outcome);
    }
}

#[test]
fn one_ulp_on_either_side_of_an_edge() {
    let one = 1.0_f64;
    let outcomes: Vec<f64> = [one.next_down(), one, one.next_up()]
        .into_iter()
        .map(|xi| {
            let mut scene = paper("3/5", "3/5", "0", 1);
            scene.at.start_position = Some(passivity_core::BigRational::from_float(xi).unwrap());
            holds("an ulp of an edge", &scene).end.velocity
        })
        .collect();
    // Below the edge the force is −½ and friction holds; from it on it is −3/2.
    assert_eq!(outcomes[0], 0.0);
    assert!(outcomes[1] < 0.0 && outcomes[2] == outcomes[1]);
}

#[test]
fn a_reversal_exactly_at_a_sample() {
    // μ = 4, u = −½, σ = ¼: deceleration 3/16, so from 3/16 the device stops as the interval ends,
    // having gone 3/32; u then is still −½, and it turns round.
    let mut scene = point("4", "0", "1/4", ["1/8", "3/16"], 1);
    let run = holds("stops at the sample", &scene);
    assert_eq!((run.end.xi, run.end.velocity), (0.125 + 0.09375, 0.0));
    scene.intervals = 40;
    holds("goes on from there", &scene);
    // And it rests there when friction takes the force.
    scene.at.coulomb = Some(q("1/2"));
    scene.at.start_velocity = Some(q("1/4"));
    let run = holds("rests at the sample", &scene);
    assert_eq!(run.end.outcome.exact, ExactOutcome::AtRest);
    assert_eq!(run.end.outcome.at_interval, Some(1));
}

#[test]
fn grazing_an_edge() {
    // The turning point lies on the edge ξ = 1 exactly, at the sample and between samples.
    for start in [["29/32", "3/16"], ["125/128", "3/32"]] {
        let scene = point("4", "0", "1/4", start, 30);
        // From ξ₀ the device goes v²/(2·3/16): to 1 in both cases, wherever it starts.
        let [xi, v] = scene.start().map(|x| crate::common::double(&x));
        assert!(xi + v * v / 0.375 <= 1.0);
        holds("grazing", &scene);
    }
}

#[test]
fn a_reversal_within_an_ulp_of_an_edge() {
    // As above the device stops as the interval ends, 3/32 on: at the edge ξ = 1, or an ulp off it.
    let start = 1.0_f64 - 0.09375;
    let next = [start.next_down(), start, start.next_up()].map(|xi| {
        let mut scene = point("4", "0", "1/4", ["0", "3/16"], 2);
        scene.at.start_position = Some(passivity_core::BigRational::from_float(xi).unwrap());
        let run = holds("turns an ulp from an edge", &scene);
        scene.intervals = 40;
        holds("goes on from there", &scene);
        run.end.velocity
    });
    // Before the edge it is drawn back by ½ − ¼, from the edge on by 3/2 − ¼, for one interval.
    assert_eq!(next, [-0.25 / 4.0, -1.25 / 4.0, -1.25 / 4.0]);
    // Between samples the edge means nothing: the motion is that of the exact turning point.
    for xi in [125.0 / 128.0, (125.0_f64 / 128.0).next_down()] {
        let mut scene = point("4", "0", "1/4", ["0", "3/32"], 30);
        scene.at.start_position = Some(passivity_core::BigRational::from_float(xi).unwrap());
        holds("turns an ulp from an edge, between samples", &scene);
    }
}

#[test]
fn twenty_thousand_intervals_of_a_cycle() {
    holds("a long cycle", &paper("3/5", "2/5", "2", 20_000));
    holds("a long fast cycle", &paper("1", "1/10", "2", 20_000));
}

#[test]
fn at_rest_at_the_start_where_friction_just_holds() {
    for (xi, sigma, exact) in [
        ("0", "1/2", ExactOutcome::AtRest),
        ("-1/2", "1/2", ExactOutcome::AtRest),
        ("3", "7/2", ExactOutcome::AtRest),
        ("4", "7/2", ExactOutcome::AtRest), // it slides first
        (
            "0",
            "4999999999999999/10000000000000000",
            ExactOutcome::NeverAtRest,
        ),
    ] {
        let run = holds(
            "rest at equality",
            &point("50", "3/5", sigma, [xi, "0"], 3000),
        );
        assert_eq!(run.end.outcome.exact, exact, "ξ = {xi}, σ = {sigma}");
        assert_eq!(
            run.end.intervals == 0,
            exact == ExactOutcome::AtRest && xi != "4"
        );
    }
}

#[test]
fn sigma_and_beta_at_one_half_and_an_ulp_either_side() {
    let half = 0.5_f64;
    let exact = |x: f64| passivity_core::BigRational::from_float(x);
    for sigma in [half.next_down(), half, half.next_up()] {
        for beta in [half.next_down(), half, half.next_up()] {
            let mut scene = paper("1/2", "1/2", "1", 400);
            (scene.at.viscous, scene.at.coulomb) = (exact(beta), exact(sigma));
            let run = holds(&format!("β = {beta:?}, σ = {sigma:?}"), &scene);
            if sigma < half {
                assert_eq!(run.end.outcome.exact, ExactOutcome::NeverAtRest);
            }
            assert_ne!(
                run.end.outcome.exact,
                ExactOutcome::Growing,
                "an ulp is not growth that is certain"
            );
        }
    }
}

#[test]
fn a_speed_that_dwindles_for_ever_is_no_rest() {
    // The force is σ to the last bit and drives the device on: friction takes it all, and what is left
    // of the speed, e^(−λ) of it in each interval, is never 0, though soon below every double.
    for (xi, speed, beta) in [
        ("-1", "5e-324", "3"),
        ("-1", "-0.4", "30"),
        ("-1/2", "1e-3", "30"),
        ("-1/2", "3", "1000"),
    ] {
        let run = holds("dwindling", &point("1", beta, "1/2", [xi, speed], 70));
        assert_eq!(run.end.intervals, 70, "{xi} {speed}");
        assert_eq!(run.end.outcome.exact, ExactOutcome::Undecided);
    }
    // It stops where it gets to a tick whose force is against it, an interval later.
    for (xi, speed, sigma) in [("0", "-3", "1/2"), ("1", "-3", "3/2")] {
        let run = holds(
            "dwindling, then stopped",
            &point("1", "1000", sigma, [xi, speed], 70),
        );
        assert_eq!(run.end.outcome.at_interval, Some(2));
    }
    // Against the force it stops.
    let run = holds("stopped", &point("1", "3", "1/2", ["0", "0.1"], 70));
    assert_eq!(run.end.outcome.exact, ExactOutcome::AtRest);
    // Out of a one-sided wall nothing but viscous friction acts.
    let mut scene = point("1", "30", "0", ["-1", "-1"], 70);
    (scene.at.unilateral, scene.at.coulomb) = (true, None);
    let run = holds("gliding", &scene);
    assert_eq!(run.end.outcome.exact, ExactOutcome::Undecided);
}

#[test]
fn subnormal_velocities() {
    for velocity in ["5e-324", "-5e-324", "1e-310", "-3e-308"] {
        for (sigma, exact) in [
            ("3/5", ExactOutcome::AtRest),
            ("2/5", ExactOutcome::NeverAtRest),
        ] {
            let run = holds("subnormal", &paper("3/5", sigma, velocity, 50));
            assert_eq!(run.end.outcome.exact, exact);
        }
    }
}

#[test]
fn a_force_that_is_huge_against_friction() {
    for force in ["1e6", "-1e12", "1e15"] {
        let mut scene = paper("3/5", "1e-3", "0", 60);
        scene.forces = Some(vec![q(force), q(force), q("0")]);
        holds(&format!("force {force}"), &scene);
    }
}

#[test]
fn parameters_that_span_fifteen_orders() {
    for (mu, beta, sigma, start) in [
        ("1e9", "1e-6", "1e-6", ["1e3", "1e-3"]),
        ("1e-6", "1e3", "1e9", ["1e6", "1e3"]),
        ("1e9", "1e9", "1e-6", ["1e-6", "1e3"]),
        ("1e7", "1e-8", "1e7", ["1e7", "1e-8"]),
    ] {
        holds(
            &format!("μ {mu} β {beta} σ {sigma}"),
            &point(mu, beta, sigma, start, 100),
        );
    }
}

#[test]
fn growth_past_every_radius_is_reported_and_no_nan() {
    // No radius is derived for so long a delay: the motion grows until numbers end.
    let mut scene = point("50", "0", "0", ["0", "1"], 1_000_000);
    scene.at.delay = 100;
    let run = simulate(&scene, &Method::ClosedForm, None).unwrap();
    assert_eq!(run.end.outcome.exact, ExactOutcome::Growing);
    assert!(run.end.xi.is_finite() && run.end.velocity.is_finite());
    assert!(run.totals.dissipated.is_finite() && run.totals.residual_max.is_finite());
    assert!(run.end.intervals < 1_000_000);
    // With a radius it ends long before.
    scene.at.delay = 3;
    let run = simulate(&scene, &Method::ClosedForm, None).unwrap();
    assert_eq!(run.end.outcome.exact, ExactOutcome::Growing);
    assert!(run.end.xi.abs() < 1e6, "{:?}", run.end);
    assert_eq!(
        simulate(&scene, &Method::Reference { digits: 30 }, None)
            .unwrap()
            .end
            .intervals,
        run.end.intervals
    );
}

/// Five million intervals of a cycle; a hundred million where `make soak` asks for twenty times as many.
#[test]
fn millions_of_intervals() {
    let intervals = draws(5_000_000);
    let scene = paper("3/5", "2/5", "2", intervals.into());
    let run = simulate(&scene, &Method::ClosedForm, None).unwrap();
    let (end, totals) = (&run.end, &run.totals);
    assert_eq!(
        (end.intervals, end.outcome.exact),
        (intervals.into(), ExactOutcome::NeverAtRest)
    );
    // (13) summed: S at the end = S at the start + ΣE_g − ΣE_d. Each interval leaves a residual of
    // rounding, bounded by its largest; the sums themselves are compensated, and good to 2ε.
    let storage = |xi: f64, v: f64| 0.5 * (50.0 * v * v + xi * xi);
    let balance = storage(0.0, 2.0) + totals.generated_linear
        - totals.dissipated
        - storage(end.xi, end.velocity);
    let rounding =
        f64::from(intervals) * 64.0 * f64::EPSILON * storage(end.xi, end.velocity).max(1e-3)
            + 4.0 * f64::EPSILON * totals.dissipated
            + 1e3 * totals.residual_max;
    assert!(balance.abs() < rounding, "{balance:e} {rounding:e}");
    // The cycle stays within a tick of the origin's edge.
    assert!(end.xi.abs() < 1.0 && end.velocity.abs() < 0.1);
}
