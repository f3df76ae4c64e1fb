//! Every method against the reference, over every effect.

use std::sync::Arc;

use crate::common::{double, paper, point, q};
use passivity_core::BigRational;
use passivity_core::transfer::TransferFunction;
use passivity_random::Random;
use passivity_scene::{Effect, Point};
use passivity_sim::{Detail, Entry, ExactOutcome, Line, Method, SimError, Simulated, simulate};

const REFERENCE: Method = Method::Reference { digits: 30 };

/// The paper's scene with each effect by itself, and with all of them.
fn scenes(intervals: u64) -> Vec<(&'static str, Point)> {
    let base = paper("3/5", "3/5", "2", intervals);
    let mut scenes = vec![("plain", base.clone())];
    let mut with = |name, change: &dyn Fn(&mut Point)| {
        let mut point = base.clone();
        change(&mut point);
        scenes.push((name, point));
    };
    with("no viscous friction", &|p| p.at.viscous = None);
    with("no Coulomb friction", &|p| p.at.coulomb = None);
    with("no friction", &|p| {
        (p.at.viscous, p.at.coulomb) = (None, None)
    });
    with("no encoder", &|p| p.at.resolution = None);
    with("delay", &|p| (p.at.delay, p.at.viscous) = (2, Some(q("3"))));
    with("unilateral", &|p| p.at.unilateral = true);
    with("damping", &|p| {
        (p.at.damping, p.at.viscous) = (Some(q("1/3")), Some(q("1")))
    });
    with("filtered damping", &|p| {
        (p.at.damping, p.at.viscous) = (Some(q("1")), Some(q("1")));
        p.at.damping_time_constant = Some(q("2"));
    });
    let law = |numerator: [&str; 3], denominator: [&str; 3]| {
        let [numerator, denominator] = [numerator, denominator].map(|of| of.map(q));
        Some(Arc::new(
            TransferFunction::new(numerator, denominator).unwrap(),
        ))
    };
    with("finite controller", &|p| {
        p.at.controller = law(["1/2", "1/4", "1/2"], ["1", "0", "0"]);
        p.at.viscous = Some(q("3"));
    });
    with("controller of second order", &|p| {
        p.at.controller = law(["1/3", "-1/5", "1/3"], ["1", "-1", "1/2"]);
        p.at.viscous = Some(q("3"));
    });
    with("filter, delay and amplifier behind one side", &|p| {
        p.at.damping = Some(q("1/2"));
        p.at.damping_time_constant = Some(q("1"));
        p.at.viscous = Some(q("4"));
        p.at.delay = 1;
        p.at.unilateral = true;
        p.at.time_constant = Some(q("1/5"));
    });
    with("saturation", &|p| p.at.max_force = Some(q("7/3")));
    with("D/A converter", &|p| p.at.force_step = Some(q("1/3")));
    with("amplifier", &|p| p.at.time_constant = Some(q("1/5")));
    with("fast amplifier", &|p| p.at.time_constant = Some(q("1/100")));
    with("constant force", &|p| p.forces = Some(vec![q("5/4")]));
    with("forces", &|p| {
        p.forces = Some((0..40).map(|i| q(&format!("{}/7", i % 9))).collect())
    });
    let arm = |p: &mut Point, mass: &str, damping: &str, stiffness: &str| {
        p.at.arm_mass = Some(q(mass));
        p.at.arm_damping = Some(q(damping));
        p.at.arm_stiffness = Some(q(stiffness));
    };
    with("arm", &|p| arm(p, "10", "1/5", "2"));
    with("stiff arm, no Coulomb friction", &|p| {
        arm(p, "1", "1/5", "400");
        p.at.coulomb = None;
    });
    with("everything", &|p| {
        p.at.viscous = Some(q("4"));
        p.at.delay = 1;
        p.at.unilateral = true;
        p.at.damping = Some(q("1/4"));
        p.at.max_force = Some(q("25/2"));
        p.at.force_step = Some(q("1/10"));
        p.at.time_constant = Some(q("1/5"));
        p.forces = Some(vec![q("-3"), q("1")]);
        arm(p, "5", "1/5", "1/10");
    });
    scenes
}

#[test]
fn closed_form_is_the_reference_with_every_effect() {
    for (name, mut point) in scenes(400) {
        if point.has(Effect::Amplifier) || point.has(Effect::Arm) {
            point.intervals = 60; // the power series takes milliseconds an interval
        }
        let fast = simulate(&point, &Method::ClosedForm, None).unwrap();
        let slow = simulate(&point, &REFERENCE, None).unwrap();
        assert_eq!(fast.end.outcome.exact, slow.end.outcome.exact, "{name}");
        assert_eq!(fast.end.intervals, slow.end.intervals, "{name}");
        // 400 intervals of some 30 roundings each, of numbers up to the reach √(μv² + ξ²) < 20, with
        // energies up to its square; growth by less than 10 over the run.
        let reach = 20.0_f64.max(slow.end.xi.abs());
        let tolerance = 400.0 * 30.0 * f64::EPSILON * reach;
        assert!(
            (fast.end.xi - slow.end.xi).abs() < tolerance,
            "{name}: {fast:?} {slow:?}"
        );
        assert!(
            (fast.end.velocity - slow.end.velocity).abs() < tolerance,
            "{name}"
        );
        let energy = tolerance * reach;
        for (a, b) in [
            (fast.totals.dissipated, slow.totals.dissipated),
            (fast.totals.generated_linear, slow.totals.generated_linear),
            (
                fast.totals.generated_quantized,
                slow.totals.generated_quantized,
            ),
        ] {
            assert!((a - b).abs() < energy, "{name}: {a} {b}");
        }
        // The balance holds to a few roundings of the energies of one interval.
        assert!(
            fast.totals.residual_max < 64.0 * f64::EPSILON * reach * reach * 50.0,
            "{name}"
        );
        assert!(
            slow.totals.residual_max < 1e-28 * reach * reach,
            "{name}: {slow:?}"
        );
    }
}

#[test]
fn friction_just_below_what_holds_never_holds() {
    for (sigma, outcome) in [
        ("0.49999999999999999", ExactOutcome::NeverAtRest),
        ("0.50000000000000001", ExactOutcome::AtRest),
    ] {
        for delay in [0, 2] {
            let mut scene = point("50", "0", sigma, ["1/4", "0"], 20);
            (scene.at.viscous, scene.at.delay) = (None, delay);
            for method in [
                Method::ClosedForm,
                Method::Exact,
                Method::Enclosure,
                REFERENCE,
            ] {
                let end = simulate(&scene, &method, None).unwrap().end;
                assert_eq!(end.outcome.exact, outcome, "{method}: {end:?}");
            }
            scene.at.time_constant = Some(q("1/5"));
            scene.at.delay = delay;
            let end = simulate(&scene, &Method::ClosedForm, None).unwrap().end;
            assert_eq!(end.outcome.exact, outcome, "{end:?}");
        }
    }
    // A step of a D/A converter that is no double, as large as σ.
    let mut scene = point("50", "0", "1/10", ["1/4", "0"], 20);
    scene.at.force_step = Some(q("1/10"));
    scene.at.max_force = Some(q("1/10"));
    let end = simulate(&scene, &Method::ClosedForm, None).unwrap().end;
    assert_eq!(end.outcome.exact, ExactOutcome::AtRest, "{end:?}");
}

#[test]
fn no_coulomb_friction_and_one_of_zero_are_the_same() {
    let mut random = Random::new(1);
    let mut compared = 0;
    for _ in 0..60 {
        let mut part = |lo, hi| q(&format!("{}/10", lo + random.below(hi - lo)));
        let mut scene = point("1", "0", "0", ["0", "0"], 25);
        scene.at.inertia = Some(part(5, 400));
        scene.at.viscous = Some(part(0, 20));
        scene.at.start_position = Some(part(0, 80));
        scene.at.start_velocity = Some(part(0, 40));
        let [lag, stiffness] = [part(0, 10), part(0, 20)];
        scene.at.time_constant = (lag != q("0")).then_some(lag);
        scene.at.arm_mass = Some(part(0, 200));
        scene.at.arm_stiffness = Some(stiffness);
        scene.forces = Some(vec![part(0, 40)]);
        let mut reach = 1.0_f64;
        let mut run = |coulomb: Option<BigRational>| {
            scene.at.coulomb = coulomb;
            let mut see = |line: &Line<'_>| {
                let Entry { xi1, v1, .. } = line.entry();
                let mass = double(scene.at.inertia.as_ref().unwrap());
                reach = reach.max(xi1.abs()).max(v1.abs() * (1.0 + mass));
                true
            };
            simulate(&scene, &Method::ClosedForm, Some(&mut see)).unwrap()
        };
        let [zero, none] = [Some(q("0")), None].map(&mut run);
        if none.end.within_rounding_of_edge.is_some() {
            continue;
        }
        compared += 1;
        // 25 intervals of some 30 roundings each of numbers up to the reach, and energies up to its square.
        let rounding = 25.0 * 30.0 * f64::EPSILON * reach * reach;
        let sums = |run: &Simulated| {
            let of = run.totals;
            let energies = [of.generated_linear, of.generated_quantized, of.dissipated];
            [[run.end.xi, run.end.velocity].as_slice(), &energies].concat()
        };
        for (a, b) in sums(&zero).into_iter().zip(sums(&none)) {
            assert!((a - b).abs() < rounding, "{a} {b} {rounding:e} {scene:?}");
        }
    }
    assert!(compared > 50, "{compared}");
}

#[test]
fn exact_method_and_closed_form_agree_without_viscous_friction() {
    for (name, mut point) in scenes(60) {
        point.at.viscous = None;
        if !Method::Exact.unsupported(&point).is_empty() {
            continue;
        }
        let exact = match simulate(&point, &Method::Exact, None) {
            Ok(exact) => exact,
            Err(SimError::Denominator { .. }) => continue,
            Err(error) => panic!("{name}: {error}"),
        };
        let fast = simulate(&point, &Method::ClosedForm, None).unwrap();
        assert_eq!(exact.totals.residual_max, 0.0, "{name}");
        assert_eq!(fast.end.outcome, exact.end.outcome, "{name}");
        let tolerance = 60.0 * 30.0 * f64::EPSILON * 20.0_f64.max(exact.end.xi.abs());
        assert!((fast.end.xi - exact.end.xi).abs() < tolerance, "{name}");
        assert!(matches!(exact.detail, Detail::Exact(_)));
    }
}

#[test]
fn enclosures_hold_the_reference() {
    for (name, point) in scenes(400) {
        let unsupported = Method::Enclosure.unsupported(&point);
        if !unsupported.is_empty() {
            let error = simulate(&point, &Method::Enclosure, None).unwrap_err();
            assert!(
                error.to_string().contains(unsupported[0].key()),
                "{name}: {error}"
            );
            continue;
        }
        let run = simulate(&point, &Method::Enclosure, None).unwrap();
        let slow = simulate(&point, &REFERENCE, None).unwrap();
        assert_eq!(run.end.outcome.exact, slow.end.outcome.exact, "{name}");
        assert_eq!(run.end.intervals, slow.end.intervals, "{name}");
        let Detail::Enclosed { ends: [xi, v], .. } = run.detail else {
            panic!("{name}")
        };
        assert!(
            xi[0] <= slow.end.xi && slow.end.xi <= xi[1],
            "{name}: {xi:?} {}",
            slow.end.xi
        );
        assert!(
            v[0] <= slow.end.velocity && slow.end.velocity <= v[1],
            "{name}"
        );
        assert!(
            xi[1] - xi[0] < 1e-6 && v[1] - v[0] < 1e-6,
            "{name}: {xi:?} {v:?}"
        );
    }
}

#[test]
fn enclosures_of_energies_hold_the_reference() {
    let behind = |time_constant: &str, latency: Option<&str>, mut point: Point| {
        point.at.time_constant = Some(q(time_constant));
        point.at.latency = latency.map(q);
        point
    };
    for (point, intervals) in [
        (paper("3/5", "2/5", "2", 300), 300),
        // A cycle that stops and starts again in each period, a device that comes to rest, and one
        // whose output lets it go in the middle of an interval.
        (behind("1/5", None, paper("3/5", "1/10", "2", 300)), 300),
        (behind("1", None, paper("3/5", "2/5", "2", 300)), 300),
        (
            behind("3", Some("3/10"), paper("1/2", "3/10", "2", 300)),
            300,
        ),
        (
            behind("2", None, point("1", "1/10", "2/5", ["3", "0"], 60)),
            60,
        ),
        (
            behind("1/10", None, point("1/2", "0", "3/10", ["3", "0"], 60)),
            60,
        ),
    ] {
        let mut rows = Vec::new();
        let mut see = |line: &Line<'_>| {
            if let Line::Enclosed(row) = line {
                rows.push((*row).clone());
            }
            true
        };
        let run = simulate(&point, &Method::Enclosure, Some(&mut see)).unwrap();
        assert_ne!(run.end.outcome.exact, ExactOutcome::Undecided, "{point:?}");
        assert_eq!(rows.len() as u64, run.end.intervals);
        assert!(run.end.intervals <= intervals);
        let mut index = 0;
        let mut compare = |line: &Line<'_>| {
            let (Line::Double(entry), row) = (line, &rows[index]) else {
                panic!("doubles")
            };
            index += 1;
            // Energies of this size are added up in a row.
            let kinetic = 50.0 * entry.v0.powi(2).max(entry.v1.powi(2));
            let potential = entry.xi0.powi(2).max(entry.xi1.powi(2));
            let size = 1.0 + potential + kinetic + entry.dissipated;
            for (x, range) in [
                (entry.xi1, &row.step.end),
                (entry.v1, &row.velocity[1]),
                (entry.generated_linear, &row.generated[0]),
                (entry.generated_quantized, &row.generated[1]),
                (entry.dissipated, &row.dissipated),
                (0.0, &row.residual),
            ] {
                let [lo, hi] = range.bounds();
                assert!(lo <= x && x <= hi, "{entry:?} {row:?}");
                assert!(hi - lo < 1e-9 * size, "{row:?}");
            }
            true
        };
        simulate(&point, &REFERENCE, Some(&mut compare)).unwrap();
        assert_eq!(index, rows.len());
    }
}

#[test]
fn enclosures_end_where_a_velocity_has_no_digits() {
    // λ > ½ and a speed below every normal double: what the reversal's time is can hardly be told.
    for speed in ["5e-324", "-5e-324", "1e-310"] {
        for (xi, sigma) in [("-1", "1/2"), ("0", "1/2"), ("3", "3/10")] {
            for beta in ["0", "1/100", "1/5", "3", "30"] {
                let scene = point("1", beta, sigma, [xi, speed], 7);
                let bound = simulate(&scene, &Method::Enclosure, None).unwrap();
                let slow = simulate(&scene, &REFERENCE, None).unwrap();
                let exact = bound.end.outcome.exact;
                assert!(exact == slow.end.outcome.exact || exact == ExactOutcome::Undecided);
                let Detail::Enclosed {
                    ends: [[lo, hi], _],
                    ..
                } = bound.detail
                else {
                    panic!()
                };
                assert!(lo <= slow.end.xi && slow.end.xi <= hi, "{lo} {hi} {slow:?}");
            }
        }
    }
}

#[test]
fn methods_of_steps_come_closer_with_more_steps() {
    // A swing without a reversal near a sample: nothing but the step size matters.
    let point = point("50", "3/5", "3/5", ["1/4", "2"], 4);
    let end = |method: Method| simulate(&point, &method, None).unwrap().end;
    let truth = end(REFERENCE);
    let off = |method| (end(method).xi - truth.xi).abs();
    let euler = [10, 100, 1000].map(|substeps| off(Method::Euler { substeps }));
    assert!(
        euler[1] < euler[0] / 5.0 && euler[2] < euler[1] / 5.0,
        "{euler:?}"
    );
    assert!(off(Method::Rk4 { substeps: 10 }) < euler[2]);
    assert!(off(Method::Adaptive { tolerance: 1e-11 }) < 1e-8);
}

#[test]
fn other_methods_run_every_effect() {
    for (name, point) in scenes(50) {
        let truth = simulate(&point, &Method::ClosedForm, None).unwrap().end;
        // With steps h, forces below 20 change the velocity by at most 20 in 50 intervals: steps that take it at their end
        // are off by ½h of that in position, and as much again by viscous friction. At each of at most ten stops one is off
        // by 2σ/μ·h in velocity, for 50 intervals. A sample in another tick, which 4000 steps avoid, moves the end by ½/μ.
        let h = 1.0 / 4000.0;
        let of_steps = (20.0 + 10.0 * 2.0 * 0.6 / 50.0 * 50.0) * h;
        // The adaptive method asks 10⁻¹⁰ of a step, of numbers below 40, and takes fewer than a hundred an interval.
        let of_adaptive = 1e-10 * 40.0 * 100.0 * 50.0;
        for (method, most) in [
            (Method::Euler { substeps: 4000 }, of_steps),
            (Method::Rk4 { substeps: 4000 }, of_steps),
            (Method::Adaptive { tolerance: 1e-10 }, of_adaptive),
        ] {
            let end = simulate(&point, &method, None).unwrap().end;
            assert!(
                (end.xi - truth.xi).abs() < most,
                "{name} {method}: {end:?} {truth:?}"
            );
        }
    }
}

#[test]
fn a_method_that_cannot_says_which_effect() {
    let mut point = paper("3/5", "3/5", "2", 10);
    point.at.time_constant = Some(q("1/5"));
    let error = simulate(&point, &Method::Exact, None).unwrap_err();
    assert_eq!(
        error,
        SimError::Unsupported {
            method: "exact",
            effects: vec![Effect::Viscous, Effect::Amplifier]
        }
    );
    point.at.inertia = None;
    assert_eq!(
        simulate(&point, &Method::ClosedForm, None).unwrap_err(),
        SimError::NoInertia
    );
}

#[test]
fn the_facts_of_the_papers_plane() {
    let exact = |beta, sigma, speed| {
        let end = simulate(
            &paper(beta, sigma, speed, 50_000),
            &Method::ClosedForm,
            None,
        )
        .unwrap()
        .end;
        end.outcome.exact
    };
    for speed in ["1/2", "1", "2", "5", "10", "50"] {
        assert_eq!(exact("3/5", "3/5", speed), ExactOutcome::AtRest);
    }
    assert_eq!(exact("2/5", "3/5", "5"), ExactOutcome::AtRest);
    assert_eq!(exact("2/5", "3/5", "10"), ExactOutcome::Growing);
    assert_eq!(exact("3/5", "2/5", "5"), ExactOutcome::NeverAtRest);
    assert_eq!(exact("1", "1/10", "5"), ExactOutcome::NeverAtRest);
}
