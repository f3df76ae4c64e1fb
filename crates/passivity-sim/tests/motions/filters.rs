//! Controllers whose response does not end: exact motions, and what is said of rest.

use std::sync::Arc;

use crate::common::{point, q};
use passivity_core::transfer::TransferFunction;
use passivity_core::{BigRational, Controller, Scalar as _};
use passivity_scene::Point;
use passivity_sim::{Detail, ExactOutcome, Line, Method, SimError, simulate};

fn with(point: Point, numerator: &[&str], denominator: &[&str]) -> Point {
    let of = |texts: &[&str]| texts.iter().map(|text| q(text)).collect::<Vec<_>>();
    let law = TransferFunction::new(of(numerator), of(denominator)).unwrap();
    let mut point = point;
    point.at.controller = Some(Arc::new(law));
    point
}

/// The positions and velocities at the samples of an exact run, and how it ended.
fn exact(point: &Point) -> (Vec<[BigRational; 2]>, ExactOutcome) {
    let mut rows = vec![point.start()];
    let mut see = |line: &Line<'_>| {
        let Line::Exact(row) = line else {
            panic!("rationals")
        };
        rows.push([row.step.end.clone(), row.velocity[1].clone()]);
        true
    };
    let run = simulate(point, &Method::Exact, Some(&mut see)).unwrap();
    (rows, run.end.outcome.exact)
}

/// Without friction the motion over an interval is ξ + v + u/(2μ), v + u/μ.
#[test]
fn exact_motion_is_the_difference_equation() {
    let mut scene = point("4", "0", "0", ["0", "3"], 40);
    scene.at.damping = Some(q("1/2"));
    scene.at.damping_time_constant = Some(q("1"));
    let (rows, outcome) = exact(&scene);
    assert_eq!((rows.len(), outcome), (41, ExactOutcome::NeverAtRest));
    let half = q("1/2");
    let mu = q("4");
    let [mut xi, mut v] = scene.start();
    let (mut w, mut before) = (q("0"), xi.floor() + &half);
    for row in &rows {
        assert_eq!(*row, [xi.clone(), v.clone()]);
        let now = xi.floor() + &half;
        w = (w + &now - before) * &half; // a = ½
        let u = -(&now + &half * &w);
        before = now;
        xi += &v + &u / &mu * &half;
        v += u / &mu;
    }
}

#[test]
fn exact_closed_form_and_enclosure_agree() {
    // Halves and quarters, so that the exact numbers stay short.
    let base = point("16", "0", "1/4", ["0", "2"], 50);
    let scenes = [
        with(base.clone(), &["3/4", "-1/2"], &["1", "-3/4"]),
        with(base.clone(), &["1/4", "1/4"], &["1", "-1", "1/2"]),
        with(base.clone(), &["1/2", "1/2", "-1/4"], &["1", "1/4"]),
    ];
    for scene in scenes {
        let (rows, outcome) = exact(&scene);
        let fast = simulate(&scene, &Method::ClosedForm, None).unwrap();
        let bound = simulate(&scene, &Method::Enclosure, None).unwrap();
        let near = rows.last().unwrap().each_ref().map(crate::common::double);
        assert_eq!(fast.end.outcome.exact, outcome);
        assert_eq!(fast.end.intervals as usize, rows.len() - 1);
        // 50 intervals of 40 roundings of numbers below 64.
        let tolerance = 50.0 * 40.0 * 64.0 * f64::EPSILON;
        assert!(
            (fast.end.xi - near[0]).abs() < tolerance,
            "{fast:?} {near:?}"
        );
        assert!((fast.end.velocity - near[1]).abs() < tolerance);
        let Detail::Enclosed { ends, .. } = bound.detail else {
            panic!("bounds")
        };
        for ([lo, hi], x) in ends.into_iter().zip(near) {
            assert!(lo <= x && x <= hi && hi - lo < 1e-6, "{lo} {x} {hi}");
        }
    }
}

/// A device that stops while the force is still small, and is pushed back when it has grown.
#[test]
fn rest_is_not_claimed_before_the_settled_force_is_small() {
    let base = point("1", "0", "3/5", ["0", "3/2"], 400);
    let scene = with(base, &["1/8"], &["1", "-7/8"]);
    let mut rows = vec![[0.0, 1.5]];
    let mut see = |line: &Line<'_>| {
        let entry = line.entry();
        rows.push([entry.xi1, entry.v1]);
        true
    };
    let end = simulate(&scene, &Method::ClosedForm, Some(&mut see))
        .unwrap()
        .end;
    assert_eq!(end.outcome.exact, ExactOutcome::AtRest);
    let since = usize::try_from(end.outcome.at_interval.unwrap()).unwrap();
    // In another tick it stays for a while, as long as the force there is small.
    let rests = |pair: &&[[f64; 2]]| pair[0] == pair[1] && pair[0][1] == 0.0;
    let early = rows[..since].windows(2).filter(rests);
    let elsewhere = early.filter(|pair| pair[0][0].floor() != end.xi.floor());
    let intervals = elsewhere.count();
    assert!(intervals > 3, "{intervals} of {since}");
    // From the rest that is claimed the kernel's force stays within σ, 300 samples on.
    let controller = Controller::of(&scene.at);
    let exactly = |x: f64| BigRational::from_float(x).unwrap();
    let mut memory = controller.at_rest(&q("0"));
    for [xi, _] in &rows {
        let _ = controller.sample(&mut memory, &exactly(*xi));
    }
    for _ in 0..300 {
        let force = controller.sample(&mut memory, &exactly(end.xi));
        assert!(force.abs() <= q("3/5"));
    }
    let slow = simulate(&scene, &Method::Reference { digits: 30 }, None).unwrap();
    assert_eq!(slow.end.outcome, end.outcome);
}

#[test]
fn rest_is_never_certain_behind_two_poles() {
    // The force swings about its end: at rest, and yet no more than undecided.
    let base = point("1", "0", "3/5", ["1/2", "0"], 60);
    let scene = with(base, &["1/4", "1/4"], &["1", "-1", "1/2"]);
    for method in [
        Method::ClosedForm,
        Method::Exact,
        Method::Enclosure,
        Method::Reference { digits: 30 },
    ] {
        let end = simulate(&scene, &method, None).unwrap().end;
        assert_eq!(end.outcome.exact, ExactOutcome::Undecided, "{method}");
        assert_eq!((end.xi, end.velocity, end.intervals), (0.5, 0.0, 60));
    }
}

#[test]
fn numbers_that_the_controller_remembers_do_not_grow_without_bound() {
    // At rest for ever, while what is remembered of a small motion needs more and more digits.
    let base = point("1", "0", "2", ["9/10", "1"], 4000);
    let scene = with(base, &["1/7"], &["1", "-8/7", "2/7"]);
    let error = simulate(&scene, &Method::Exact, None).unwrap_err();
    assert!(matches!(error, SimError::Denominator { .. }), "{error}");
}

#[test]
fn coefficients_beyond_doubles_are_refused() {
    let base = point("1", "0", "3/5", ["0", "1"], 10);
    let error = simulate(&with(base, &["1e200"], &["1"]), &Method::ClosedForm, None).unwrap_err();
    assert_eq!(error, SimError::Filter);
    assert!(error.to_string().contains("1e120"), "{error}");
}
