//! Samples on encoder edges, and without an encoder where the force jumps: doubles decide them by rounding, and say so.

use crate::common::{point, q};
use passivity_scene::Point;
use passivity_sim::{Detail, ExactOutcome, Line, Method, Simulated, simulate};

/// Pseudo-random numbers, the same on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    /// A whole number from −n to n over `d`.
    fn part(&mut self, n: u64, d: u64) -> String {
        let whole = self.below(2 * n + 1).cast_signed() - n.cast_signed();
        format!("{whole}/{d}")
    }
}

/// A scene without viscous friction whose numbers have one small denominator, so that its samples
/// often fall on encoder edges.
fn scene(random: &mut Random) -> Point {
    let d = [1, 2, 3, 5, 6, 7, 10, 12][random.below(8) as usize];
    let mu = format!(
        "{}/{}",
        1 + random.below(6),
        [1, 2, 3][random.below(3) as usize]
    );
    let sigma = format!("{}/{}", random.below(3 * d), 2 * d);
    let start = [random.part(3 * d, d), random.part(2 * d, d)];
    let mut scene = point(&mu, "0", &sigma, [&start[0], &start[1]], 12);
    scene.at.viscous = None;
    if random.below(4) == 0 {
        scene.at.coulomb = None;
    }
    scene
}

/// Whether a run ended where the rationals did, and as they did.
///
/// A device that stops exactly at a sample rests from there on; rounded, it may take until within the
/// next interval. That is the same motion.
fn agree(other: &Simulated, exact: &Simulated) -> bool {
    // With μ ≥ ⅓ an interval lets a motion grow by at most √(1 + 1/(2μ)) < 1.6, so twelve keep it below 10⁴. Roundings
    // are then within the bound of `hard_cases`, 144·16ε·(10⁴ + 10⁴/μ) ≤ 144·16ε·4·10⁴; the adaptive method's order 5 has
    // the parabola of a motion without viscous friction exactly. A wrong tick moves the velocity by 1/μ ≥ 1/6.
    let near = |a: f64, b: f64| {
        assert!(b.abs() < 1e4, "{b}");
        (a - b).abs() < 144.0 * 16.0 * f64::EPSILON * 4e4
    };
    let (a, b) = (&other.end, &exact.end);
    let when =
        a.intervals.abs_diff(b.intervals) <= u64::from(b.outcome.exact == ExactOutcome::AtRest);
    a.outcome.exact == b.outcome.exact && when && near(a.xi, b.xi) && near(a.velocity, b.velocity)
}

#[test]
fn an_outcome_that_rounding_decided_says_so() {
    let mut random = Random(1);
    let (mut wrong, mut said) = ([0; 3], [0; 3]);
    for _ in 0..600 {
        let scene = scene(&mut random);
        let exact = simulate(&scene, &Method::Exact, None).unwrap();
        assert_eq!(exact.end.within_rounding_of_edge, None);
        let methods = [
            Method::ClosedForm,
            Method::Reference { digits: 20 },
            Method::Adaptive { tolerance: 1e-13 },
        ];
        for (i, method) in methods.iter().enumerate() {
            let other = simulate(&scene, method, None).unwrap();
            let warned = other.end.within_rounding_of_edge;
            said[i] += usize::from(warned.is_some());
            if !agree(&other, &exact) {
                wrong[i] += 1;
                assert!(warned.is_some(), "{method}: {other:?} {exact:?} {scene:?}");
            }
        }
    }
    eprintln!("wrong {wrong:?}, said {said:?} of 600");
    assert!(wrong[0] > 10, "the scenes no longer show it: {wrong:?}");
}

/// A scene without an encoder, one of whose first samples is where its force jumps, as far as one was found: at
/// the surface of a one-sided wall with virtual damping, or in the middle between two steps of a D/A converter.
fn on_a_jump(random: &mut Random) -> Option<Point> {
    let mut scene = scene(random);
    let at = &mut scene.at;
    at.resolution = None;
    at.unilateral = random.below(5) > 0;
    at.delay = u16::from(random.below(5) == 0);
    at.latency = (random.below(5) == 0).then(|| q("2/5"));
    let mut target = q("0");
    if random.below(2) == 0 {
        at.unilateral = true;
        at.damping = Some(q(&format!("{}/3", 1 + random.below(9))));
    } else {
        let step = q(&format!("{}/5", 1 + random.below(6)));
        let odd = 2 * random.below(7).cast_signed() - 7;
        target = step.clone() * q(&format!("{odd}/2"));
        at.force_step = Some(step);
    }
    let intervals = 1 + random.below(5);
    scene.intervals = intervals;
    for _ in 0..4 {
        let run = simulate(&scene, &Method::Exact, None).ok()?;
        let Detail::Exact([xi, _]) = &run.detail else {
            panic!("{run:?}");
        };
        let off = target.clone() - q(xi);
        if off == q("0") && run.end.intervals == intervals {
            scene.intervals = 12;
            return Some(scene);
        }
        let speed = scene.at.start_velocity.take()?;
        scene.at.start_velocity = Some(speed + off / q(&intervals.to_string()));
    }
    None
}

#[test]
fn a_force_that_jumps_without_an_encoder_says_so() {
    let mut random = Random(4);
    let (mut found, mut wrong, mut said) = (0, [0; 3], [0; 3]);
    for _ in 0..2000 {
        let Some(scene) = on_a_jump(&mut random) else {
            continue;
        };
        let mut exact = simulate(&scene, &Method::Exact, None).unwrap();
        found += 1;
        // Whether a device that stops rests at once or within the next interval is no matter of a jump.
        exact.end.outcome.exact = ExactOutcome::AtRest;
        let methods = [
            Method::ClosedForm,
            Method::Reference { digits: 20 },
            Method::Adaptive { tolerance: 1e-13 },
        ];
        for (i, method) in methods.iter().enumerate() {
            let mut other = simulate(&scene, method, None).unwrap();
            let warned = other.end.within_rounding_of_edge;
            said[i] += usize::from(warned.is_some());
            other.end.outcome.exact = ExactOutcome::AtRest;
            if !agree(&other, &exact) {
                wrong[i] += 1;
                assert!(warned.is_some(), "{method}: {other:?} {exact:?} {scene:?}");
            }
        }
    }
    eprintln!("wrong {wrong:?}, said {said:?} of {found}");
    assert!(wrong[0] > 10, "the scenes no longer show it: {wrong:?}");
}

#[test]
fn a_force_half_way_between_two_steps_is_rounded_as_the_numbers_of_the_scene_have_it() {
    // 2½ + 1.361 = 58½·0.066, and 58½ steps are rounded to 59: what samples of an encoder make is known exactly.
    let mut scene = point("9", "1/2", "0", ["2.2", "1.74"], 40);
    (scene.at.coulomb, scene.at.damping, scene.at.force_step) =
        (None, Some(q("1.361")), Some(q("0.066")));
    let end = |digits| {
        let run = simulate(&scene, &Method::Reference { digits }, None).unwrap();
        assert_eq!(run.end.within_rounding_of_edge, None);
        run.end.xi
    };
    let doubles = simulate(&scene, &Method::ClosedForm, None).unwrap().end.xi;
    for digits in [20, 30, 60] {
        assert!(
            (end(digits) - doubles).abs() < 1e-9,
            "{digits}: {}, {doubles}",
            end(digits)
        );
    }
    let enclosed = simulate(&scene, &Method::Enclosure, None).unwrap().end;
    assert_eq!(
        (enclosed.intervals, enclosed.within_rounding_of_edge),
        (40, None)
    );
}

#[test]
fn the_first_sample_on_an_edge_is_named() {
    // μ = 1, no friction, from ξ = 1/3 with ξ̇ = 7/6: u = −½, so the first sample is at 1/3 + 7/6 − ¼ = 5/4,
    // and with ξ̇ = 11/12 at 1, which doubles miss.
    let mut scene = point("1", "0", "0", ["1/3", "7/6"], 1);
    (scene.at.viscous, scene.at.coulomb) = (None, None);
    let first = |scene: &Point| {
        let run = simulate(scene, &Method::ClosedForm, None).unwrap();
        run.end.within_rounding_of_edge
    };
    scene.intervals = 2;
    assert_eq!(first(&scene), None);
    scene.at.start_velocity = Some(q("11/12"));
    assert_eq!(first(&scene), Some(1));
    // A start on an edge is there exactly, and one an ulp off a third of a tick is nowhere near one.
    for (xi, said) in [
        ("1", None),
        ("-3", None),
        ("1/3", None),
        ("0.99999999999999999999", Some(0)),
        ("1.00000000000000000001", Some(0)),
    ] {
        scene.at.start_position = Some(q(xi));
        scene.at.start_velocity = Some(q("1/7"));
        assert_eq!(first(&scene), said, "{xi}");
    }
}

#[test]
fn a_device_that_friction_holds_on_an_edge_stays_on_it() {
    // The controller remembers other samples, and the force acts late or behind an amplifier.
    let changes: [&dyn Fn(&mut Point); 3] = [
        &|p| (p.at.latency, p.at.damping) = (Some(q("1/2")), Some(q("1"))),
        &|p| (p.at.delay, p.at.time_constant) = (2, Some(q("1/5"))),
        &|p| (p.at.delay, p.at.arm_mass, p.at.arm_stiffness) = (3, Some(q("2")), Some(q("1"))),
    ];
    for change in changes {
        let mut scene = point("50", "3/5", "3/5", ["0", "0"], 40);
        change(&mut scene);
        for method in [Method::ClosedForm, Method::Adaptive { tolerance: 1e-9 }] {
            let end = simulate(&scene, &method, None).unwrap().end;
            assert_eq!(end.outcome.exact, ExactOutcome::AtRest, "{end:?}");
            assert_eq!(end.within_rounding_of_edge, None, "{end:?}");
        }
    }
}

#[test]
fn motions_off_the_edges_are_not_suspected() {
    // Of 200 scenes of 500 intervals with numbers of any kind.
    let mut random = Random(2);
    let mut said = 0;
    for i in 0..200 {
        let [mu, beta, sigma, speed] = [50, 1, 1, 4].map(|n| {
            format!(
                "{}",
                (random.below(1 << 30) + 1) as f64 * f64::from(n) / 1e9
            )
        });
        let measured = point(&mu, &beta, &sigma, ["0", &speed], 500);
        // Without an encoder, against a one-sided wall with damping, and behind steps too.
        let mut damped = measured.clone();
        (damped.at.resolution, damped.at.unilateral) = (None, true);
        damped.at.damping = Some(q("7/3"));
        let mut stepped = damped.clone();
        stepped.at.force_step = Some(q("1/7"));
        for scene in [measured, damped, stepped] {
            let end = simulate(&scene, &Method::ClosedForm, None).unwrap().end;
            if end.within_rounding_of_edge.is_some() {
                said += 1;
                eprintln!("{i}: {mu} {beta} {sigma} {speed} {end:?}");
            }
        }
    }
    assert_eq!(said, 0);
}

#[test]
fn breakaway_under_a_lagging_force_is_found_where_it_is() {
    // The device stops within an interval, the amplifier's output goes on, and overcomes friction within
    // an interval too.
    let mut random = Random(3);
    let mut broke_away = 0;
    for _ in 0..60 {
        let speed = format!("{}/7", 5 + random.below(20));
        let sigma = format!("{}/5", 6 + random.below(10));
        let mut scene = point("2", "1/10", &sigma, ["0", &speed], 6);
        scene.at.time_constant = Some(q(&format!("{}/3", 2 + random.below(6))));
        let (mut stopped, mut started) = (0, 0);
        let mut see = |line: &Line<'_>| {
            let entry = line.entry();
            stopped += usize::from(entry.v0 != 0.0 && entry.v1 == 0.0);
            started += usize::from(entry.v0 == 0.0 && entry.v1 != 0.0);
            true
        };
        let truth = simulate(&scene, &Method::Reference { digits: 30 }, Some(&mut see)).unwrap();
        broke_away += started.min(stopped);
        let run = simulate(&scene, &Method::Adaptive { tolerance: 1e-12 }, None).unwrap();
        let off = (run.end.xi - truth.end.xi)
            .abs()
            .max((run.end.velocity - truth.end.velocity).abs());
        // Six intervals of a tolerance of 10⁻¹² each, and events to the last bits of an interpolation
        // that is as good as the method to the fourth order.
        assert!(off < 1e-8, "{off:e}: {run:?} {truth:?} {scene:?}");
    }
    assert!(broke_away > 5, "{broke_away}");
}
