//! Scenes whose force changes within the interval (TH-LATENCY): every method against the others, the
//! account of the force that was really applied, and what the theorem says of passive scenes.

use crate::common::{double, point, q};
use passivity_core::{BigRational, Scalar as _};
use passivity_scene::check::{Verdict, check};
use passivity_scene::{Point, Scene};
use passivity_sim::{Detail, ExactOutcome, Line, Method, SimError, Simulated, simulate};

/// A scene of ours with a latency in periods, in place of its delay.
fn late(mut scene: Point, latency: &str) -> Point {
    scene.at.latency = Some(q(latency));
    scene
}

/// A device that moves through some ticks, with the given friction.
fn base(beta: &str, sigma: &str) -> Point {
    point("6", beta, sigma, ["1/3", "7/5"], 40)
}

/// The scenes of the comparisons: every effect that the force goes through.
fn scenes() -> Vec<(&'static str, Point)> {
    let mut scenes = Vec::new();
    let mut with = |name, latency: &str, change: &dyn Fn(&mut Point)| {
        let mut scene = late(base("3", "4/5"), latency);
        change(&mut scene);
        scenes.push((name, scene));
    };
    with("a part of a period", "2/7", &|_| ());
    with("more than two periods", "12/5", &|_| ());
    with("beside a delay", "1/3", &|p| p.at.delay = 2);
    with("no viscous friction", "2/7", &|p| p.at.viscous = None);
    with("no Coulomb friction", "2/7", &|p| p.at.coulomb = None);
    with("no friction", "2/7", &|p| {
        (p.at.viscous, p.at.coulomb) = (None, None);
    });
    with("no encoder", "3/4", &|p| p.at.resolution = None);
    with("fast friction", "3/4", &|p| p.at.viscous = Some(q("60")));
    with("damping behind one side", "3/8", &|p| {
        (p.at.damping, p.at.unilateral) = (Some(q("1/4")), true);
    });
    with("filtered damping", "3/8", &|p| {
        (p.at.damping, p.at.damping_time_constant) = (Some(q("1/2")), Some(q("2")));
    });
    with("D/A converter and saturation", "1/8", &|p| {
        (p.at.force_step, p.at.max_force) = (Some(q("1/3")), Some(q("7/3")));
    });
    with("forces", "5/9", &|p| {
        p.forces = Some(
            (0..30)
                .map(|i| q(&format!("{}/7", i * i % 11 - 5)))
                .collect(),
        );
    });
    with("amplifier", "2/7", &|p| p.at.time_constant = Some(q("1/3")));
    with("arm", "8/7", &|p| {
        (p.at.arm_mass, p.at.arm_damping) = (Some(q("2")), Some(q("1/5")));
        p.at.arm_stiffness = Some(q("1/2"));
    });
    scenes
}

fn run(scene: &Point, method: &Method) -> Simulated {
    simulate(scene, method, None).unwrap()
}

#[test]
fn a_latency_of_whole_periods_is_a_delay() {
    for whole in [0_u16, 1, 3] {
        let mut delayed = base("3", "4/5");
        delayed.at.delay = 1 + whole;
        let mut scene = late(base("3", "4/5"), &whole.to_string());
        scene.at.delay = 1;
        for method in [
            Method::ClosedForm,
            Method::Enclosure,
            Method::Reference { digits: 30 },
        ] {
            let (a, b) = (run(&scene, &method), run(&delayed, &method));
            assert_eq!((a.end, a.totals), (b.end, b.totals), "{whole} {method}");
        }
    }
}

#[test]
fn one_interval_by_hand() {
    // μ = 1, no friction, from ξ = 3/2 with ξ̇ = 2 and a latency of ¼: for the first quarter −3/2 acts,
    // as before the start, and then too, because the sample is the same.
    let mut scene = late(point("1", "0", "0", ["3/2", "2"], 1), "1/4");
    (scene.at.viscous, scene.at.coulomb) = (None, None);
    let ends = |scene: &Point| match run(scene, &Method::Exact).detail {
        Detail::Exact([xi, v]) => [q(&xi), q(&v)],
        other => panic!("{other:?}"),
    };
    let [xi, v] = ends(&scene);
    assert_eq!([&xi, &v], [&q("11/4"), &q("1/2")]);
    // Sampled in the tick of 5/2: −3/2 for a quarter, then −5/2 for three.
    scene.intervals = 2;
    let parts = |xi: BigRational, v: BigRational, u: &str, t: &str| {
        let (u, t) = (q(u), q(t));
        let moved = &v * &t + (&u * &t * &t).half();
        [xi + moved, v + u * t]
    };
    let [xi, v] = parts(xi, v, "-3/2", "1/4");
    let want = parts(xi, v, "-5/2", "3/4");
    assert_eq!(ends(&scene), want);
    // The account is of that force: ΔS of the device is all work where there is no friction.
    let run = run(&scene, &Method::Exact);
    let energy = |xi: &BigRational, v: &BigRational| double(&(v * v + xi * xi).half());
    let gained = energy(&want[0], &want[1]) - energy(&q("3/2"), &q("2"));
    assert!(
        (run.totals.generated_linear - gained).abs() < 1e-15,
        "{run:?}"
    );
}

#[test]
fn every_method_gives_the_same_motion() {
    for (name, mut scene) in scenes() {
        if scene.at.time_constant.is_some() || scene.at.arm_mass.is_some() {
            scene.intervals = 15; // the power series takes milliseconds an interval
        }
        let slow = run(&scene, &Method::Reference { digits: 40 });
        let fast = run(&scene, &Method::ClosedForm);
        assert_eq!(fast.end.outcome.exact, slow.end.outcome.exact, "{name}");
        assert_eq!(fast.end.intervals, slow.end.intervals, "{name}");
        // Forty intervals of some sixty roundings each of numbers below 20, and of energies below their
        // square; without friction or encoder errors grow by less than 10.
        let most = 40.0 * 60.0 * f64::EPSILON * 20.0;
        let off = |a: f64, b: f64| (a - b).abs();
        assert!(
            off(fast.end.xi, slow.end.xi) < 10.0 * most,
            "{name}: {fast:?} {slow:?}"
        );
        assert!(
            off(fast.end.velocity, slow.end.velocity) < 10.0 * most,
            "{name}"
        );
        for (a, b) in [
            (fast.totals.generated_linear, slow.totals.generated_linear),
            (
                fast.totals.generated_quantized,
                slow.totals.generated_quantized,
            ),
            (fast.totals.dissipated, slow.totals.dissipated),
        ] {
            assert!(off(a, b) < 200.0 * most, "{name}: {a} {b}");
        }
        assert!(fast.totals.residual_max < 200.0 * most, "{name}");
        assert!(slow.totals.residual_max < 1e-35, "{name}");
        if Method::Enclosure.unsupported(&scene).is_empty() {
            let run = run(&scene, &Method::Enclosure);
            let Detail::Enclosed { ends: [xi, v], .. } = run.detail else {
                panic!("{name}")
            };
            assert_eq!(run.end.outcome.exact, slow.end.outcome.exact, "{name}");
            assert!(
                xi[0] <= slow.end.xi && slow.end.xi <= xi[1],
                "{name}: {xi:?}"
            );
            assert!(
                v[0] <= slow.end.velocity && slow.end.velocity <= v[1],
                "{name}: {v:?}"
            );
            // Bounds that say more than doubles do are nearer to each other than these may be off.
            let widest = 10.0 * most;
            assert!(
                xi[1] - xi[0] < widest && v[1] - v[0] < widest,
                "{name}: {xi:?} {v:?}"
            );
        }
        if Method::Exact.unsupported(&scene).is_empty() {
            match simulate(&scene, &Method::Exact, None) {
                Ok(exact) => {
                    assert_eq!(exact.totals.residual_max, 0.0, "{name}");
                    assert_eq!(exact.end.outcome, slow.end.outcome, "{name}");
                    assert!(off(exact.end.xi, slow.end.xi) < 1e-15, "{name}");
                }
                Err(error) => assert!(matches!(error, SimError::Denominator { .. }), "{error}"),
            }
        }
        // In ten intervals the device stops once or twice. A step h in which it does is off by at most 2σ/μ·h in
        // velocity, and the position by that for as long as is left. Euler's steps take the velocity at
        // their end for that within, ½h for each change of the velocity, which changes by less than 10 in all.
        // The adaptive method asks 10⁻¹¹ of a step, of numbers below 5, and takes fewer than a hundred an
        // interval. No sample of these scenes is so near an edge that this makes its tick another.
        scene.intervals = 10;
        let truth = run(&scene, &Method::ClosedForm).end;
        let stops = 2.0 * (2.0 * 0.8 / 6.0 * 1e-3) * 10.0;
        for (method, most) in [
            (Method::Euler { substeps: 1000 }, stops + 0.5e-3 * 10.0),
            (Method::Rk4 { substeps: 1000 }, stops),
            (
                Method::Adaptive { tolerance: 1e-11 },
                1e-11 * 5.0 * 100.0 * 10.0,
            ),
        ] {
            let end = run(&scene, &method).end;
            assert!(
                off(end.xi, truth.xi) < most,
                "{name} {method}: {end:?} {truth:?}"
            );
        }
    }
}

#[test]
fn the_force_of_the_sample_before_can_keep_a_device_from_rest() {
    // μ = 4, σ = 1, half a period of latency. From ξ = 9/8 with ξ̇ = −½ an operator's force of 5/2 against
    // −3/2 stops the device at the sample, at 7/8. Friction takes the force there, −½, but for half a period
    // more −3/2 acts: it goes on by 1/32 and rests from the next sample on.
    let mut scene = late(point("4", "0", "1", ["9/8", "-1/2"], 50), "1/2");
    scene.at.viscous = None;
    scene.forces = Some(vec![q("5/2"), q("0")]);
    for method in [
        Method::Exact,
        Method::ClosedForm,
        Method::Reference { digits: 30 },
    ] {
        let end = run(&scene, &method).end;
        assert_eq!(end.outcome.exact, ExactOutcome::AtRest, "{method}");
        assert_eq!(
            (end.outcome.at_interval, end.xi),
            (Some(2), 27.0 / 32.0),
            "{method}"
        );
    }
}

/// Pseudo-random whole numbers below n, the same on every machine.
fn random(seed: &mut u64, n: u64) -> u64 {
    *seed = seed
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 33) % n
}

#[test]
fn a_passive_scene_never_generates_more_than_friction_takes() {
    let mut seed = 7;
    let mut nearest = f64::INFINITY;
    for _ in 0..60 {
        let latency = format!("{}/10", 1 + random(&mut seed, 18));
        let text = |beta: &str| {
            format!(
                "[dimensionless]\nmu = \"3\"\nbeta = \"{beta}\"\nsigma = \"1/2\"\n\
                 [sampling]\nlatency = \"{latency}\"\n"
            )
        };
        let scene = |beta: &str| Scene::from_toml("late", &text(beta)).unwrap();
        // The least viscous friction that the theorem asks for, rounded up.
        let cost = check(&scene("1")).cost.viscous;
        let beta = (cost.hi() * q("1000000")).ceil();
        let beta = format!("{}/1000000", beta);
        assert_eq!(
            check(&scene(&beta)).verdict,
            Verdict::Passive,
            "{latency} {beta}"
        );
        let mut driven = scene(&beta).point();
        driven.intervals = 200;
        let size = 1 + random(&mut seed, 40);
        let force = |_| {
            q(&format!(
                "{}/4",
                random(&mut seed, 2 * size + 1).cast_signed() - size.cast_signed()
            ))
        };
        driven.forces = Some((0..200).map(force).collect());
        // From rest, at which nothing is remembered, the account must hold at every sample.
        let (mut sum, mut off) = (0.0, 0.0);
        let mut see = |line: &Line<'_>| {
            let entry = line.entry();
            sum += entry.dissipated - entry.generated_linear;
            // The balance of an interval is off by its roundings, at most 16ε of the energies in it (`hard_cases`).
            let kinetic = 1.5 * (entry.v0.powi(2) + entry.v1.powi(2));
            let potential = 0.5 * (entry.xi0.powi(2) + entry.xi1.powi(2));
            off += 16.0 * f64::EPSILON * (kinetic + potential + entry.dissipated);
            assert!(sum >= -off, "{latency} {beta} at {}: {sum}", entry.h);
            true
        };
        simulate(&driven, &Method::ClosedForm, Some(&mut see)).unwrap();
        nearest = nearest.min(sum);
    }
    assert!(nearest.is_finite());
}

#[test]
fn a_scene_that_latency_makes_active_draws_energy() {
    // β = 3/5 is enough for the wall alone, and not with nine tenths of a period of latency.
    let text = |sampling: &str| {
        format!(
            "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"1/2\"\n{sampling}\
             [start]\nvelocity = \"20\"\n[run]\nintervals = 3000\n"
        )
    };
    let scene = |sampling: &str| Scene::from_toml("late", &text(sampling)).unwrap();
    let run_of = |scene: &Scene| run(&scene.point(), &Method::ClosedForm);
    let prompt = scene("");
    assert_eq!(check(&prompt).verdict, Verdict::Passive);
    assert_eq!(run_of(&prompt).end.outcome.exact, ExactOutcome::AtRest);
    let late = scene("[sampling]\nlatency = \"9/10\"\n");
    let report = check(&late);
    assert_eq!(report.verdict, Verdict::NotPassive);
    assert!(report.witness.is_some());
    let active = run_of(&late);
    assert!(
        active.totals.generated_linear > active.totals.dissipated,
        "{active:?}"
    );
    let storage = |xi: f64, v: f64| 0.5 * (50.0 * v * v + xi * xi);
    assert!(
        storage(active.end.xi, active.end.velocity) > storage(0.0, 20.0),
        "{active:?}"
    );
}

#[test]
fn a_latency_longer_than_any_delay_is_refused() {
    let scene = late(base("3", "4/5"), "65536");
    let error = simulate(&scene, &Method::ClosedForm, None).unwrap_err();
    assert_eq!(
        error.to_string(),
        "latency cannot be simulated: expected at most 65535 sampling periods"
    );
}
