//! Lanes against the scalar loops, bit by bit.

use std::sync::Arc;

use passivity_core::transfer::TransferFunction;
use passivity_core::{BigRational, Friction, Loop, Scalar};
use passivity_scene::point::{Point as Scene, Units};

use super::*;
use crate::family::Family;
use crate::law;

fn grid(mu: f64, speeds: &[f64]) -> Vec<Plain> {
    let mut points = Vec::new();
    for i in 0..20 {
        for j in 0..20 {
            for &velocity in speeds {
                points.push(Plain {
                    mu,
                    beta: (f64::from(i) + 0.5) / 20.0,
                    sigma: 1.5 * (f64::from(j) + 0.5) / 20.0,
                    xi: 0.0,
                    velocity,
                });
            }
        }
    }
    points
}

fn all(points: &[Plain], intervals: u64) -> Vec<End> {
    by(Instructions::Best, points, intervals)
}

fn by(instructions: Instructions, points: &[Plain], intervals: u64) -> Vec<End> {
    let mut queue = points.iter().copied().enumerate();
    let mut ends: Vec<Option<End>> = vec![None; points.len()];
    run_on(
        instructions,
        intervals,
        || queue.next(),
        |i, end| ends[i] = Some(end),
    );
    ends.into_iter()
        .map(|end| end.expect("every point ends"))
        .collect()
}

#[test]
fn lanes_and_scalar_loop_agree_to_the_last_bit() {
    // μ = 50 as in Fig. 5; μ = 8 takes λ past 1/16 for half of the points, μ = 1 past ½.
    for (mu, intervals) in [(50.0, 5_000), (8.0, 777), (1.0, 777)] {
        let points = grid(mu, &[0.5, 1.0, 2.0, 5.0]);
        for (point, end) in points.iter().zip(all(&points, intervals)) {
            let scalar = run::outcome(&Plan::plain(point, intervals));
            assert_eq!(end, scalar, "{point:?}");
            assert_eq!(end.xi.to_bits(), scalar.xi.to_bits(), "{point:?}");
        }
    }
}

#[test]
fn points_of_every_kind_in_any_order_end_as_they_do_alone() {
    let mut points = grid(8.0, &[2.0]);
    points.extend(grid(0.7, &[1.0]));
    points.extend(grid(50.0, &[5.0]));
    // 7 and 1200 have no common divisor: every point once, kinds mixed.
    let mixed: Vec<Plain> = (0..1200).map(|i| points[i * 7 % 1200]).collect();
    for (point, end) in mixed.iter().zip(all(&mixed, 300)) {
        assert_eq!(end, run::outcome(&Plan::plain(point, 300)), "{point:?}");
    }
}

#[test]
fn every_instruction_set_gives_the_same_bits() {
    let mut points = grid(50.0, &[1.0, 5.0]);
    points.extend(grid(4.0, &[1.0]));
    let best = by(Instructions::Best, &points, 2_000);
    for instructions in [Instructions::Avx2, Instructions::Baseline] {
        let other = by(instructions, &points, 2_000);
        for (a, b) in best.iter().zip(&other) {
            assert_eq!(a, b, "{instructions:?}");
            assert_eq!(a.xi.to_bits(), b.xi.to_bits(), "{instructions:?}");
        }
    }
}

#[test]
fn edges_are_met_in_lanes_as_in_the_scalar_loop() {
    let mut points = Vec::new();
    for sigma in [0.5_f64, 0.5_f64.next_down(), 0.5_f64.next_up(), 0.0] {
        for beta in [0.0, 0.5, 1e-300, 20.0] {
            for velocity in [0.0, 5e-324, -1.0, 1e-9] {
                for xi in [0.0, -1.0, 1.0_f64.next_down(), 1e15] {
                    points.push(Plain {
                        mu: 50.0,
                        beta,
                        sigma,
                        xi,
                        velocity,
                    });
                }
            }
        }
    }
    for intervals in [0, 1, 63, 64, 65, 1000] {
        for (point, end) in points.iter().zip(all(&points, intervals)) {
            assert_eq!(
                end,
                run::outcome(&Plan::plain(point, intervals)),
                "{point:?}"
            );
        }
    }
}

fn ratio(n: i32, d: i32) -> BigRational {
    BigRational::integer(n).over(BigRational::integer(d))
}

/// A scene with a set of the controller's effects, as bits of a law.
fn scene(effects: u8, delay: u16, mu: i32, intervals: u64) -> Scene {
    let has = |effect: u8| effects & effect != 0;
    let friction = Friction::new(BigRational::one(), BigRational::one());
    let one = BigRational::one();
    Scene {
        at: Loop {
            inertia: Some(ratio(mu, 1)),
            resolution: has(law::ENCODER).then(BigRational::one),
            delay: if has(law::DELAY) { delay } else { 0 },
            damping: has(law::DAMPING).then(|| ratio(1, 3)),
            unilateral: has(law::UNILATERAL),
            force_step: has(law::FORCE_STEP).then(|| ratio(3, 8)),
            max_force: has(law::SATURATION).then(|| ratio(5, 2)),
            ..Loop::smooth(friction)
        },
        forces: None,
        intervals,
        units: Units {
            period: one.clone(),
            length: one.clone(),
            stiffness: one,
            length_unit: None,
        },
    }
}

/// The plans of a scene over a grid of frictions and speeds.
fn plans(scene: &Scene, betas: &[f64], sigmas: &[f64], speeds: &[f64]) -> Vec<Plan> {
    let family = Family::of(scene).unwrap();
    let mut plans = Vec::new();
    for beta in betas {
        for sigma in sigmas {
            for speed in speeds {
                plans.push(family.with([*beta, *sigma, *speed]).unwrap());
            }
        }
    }
    plans
}

/// Every plan ends in the lanes as it does alone, to the last bit.
fn end_alike(instructions: Instructions, plans: &[Plan], what: &str) {
    let mut queue = plans.iter().cloned().enumerate();
    let mut seen = vec![false; plans.len()];
    run_plans(
        instructions,
        || queue.next(),
        |index, end| {
            let plan = &plans[index];
            let alone = run::outcome(plan);
            let start = plan.start;
            assert_eq!(end, alone, "{what}: {start:?} {:?}", plan.constants);
            assert_eq!(end.xi.to_bits(), alone.xi.to_bits(), "{what}");
            assert_eq!(end.velocity.to_bits(), alone.velocity.to_bits(), "{what}");
            seen[index] = true;
        },
    );
    assert!(seen.iter().all(|seen| *seen), "every plan ends");
}

#[test]
fn lanes_and_scalar_loop_agree_with_every_set_of_effects() {
    for effects in 0..64_u8 {
        let delays: &[u16] = if effects & law::DELAY == 0 {
            &[0]
        } else {
            &[1, 3]
        };
        for &delay in delays {
            // λ below 1/16, and above it for half of the points.
            for (mu, intervals) in [(50, 700), (6, 131)] {
                let scene = scene(effects, delay, mu, intervals);
                let plans = plans(
                    &scene,
                    &[0.0, 0.2, 0.7, 1.4, 2.3],
                    &[0.0, 0.2, 0.5, 0.75, 1.5],
                    &[-1.0, 0.0, 0.5, 4.0],
                );
                let what = format!("effects {effects:b}, delay {delay}, μ = {mu}");
                end_alike(Instructions::Best, &plans, &what);
            }
        }
    }
}

#[test]
fn every_instruction_set_gives_the_same_bits_with_every_effect() {
    let scene = scene(63, 2, 20, 900);
    let plans = plans(&scene, &[0.4, 1.0, 2.5], &[0.1, 0.4, 1.0], &[0.5, 2.0, 7.0]);
    for instructions in [
        Instructions::Best,
        Instructions::Avx2,
        Instructions::Baseline,
    ] {
        end_alike(instructions, &plans, &format!("{instructions:?}"));
    }
}

#[test]
fn strange_lanes_and_other_controllers_go_through_the_scalar_loop() {
    let delayed = scene(law::ENCODER | law::DELAY, 2, 50, 400);
    // Far positions, a speed that underflows, friction that just takes the force, λ above ½.
    let mut mixed = plans(
        &delayed,
        &[0.1, 30.0],
        &[0.0, 0.5, 1.5],
        &[5e-324, -3.0, 1e13],
    );
    let one_sided = scene(law::UNILATERAL, 0, 50, 400);
    mixed.extend(plans(
        &one_sided,
        &[0.0, 3.0],
        &[0.0, 0.5],
        &[-1e14, 1e14, 2.0],
    ));
    let mut longer = delayed;
    longer.intervals = 90;
    mixed.extend(plans(&longer, &[1.0], &[0.25], &[1.0]));
    end_alike(Instructions::Best, &mixed, "mixed");
}

/// Whether the lanes do every plan, each in lanes of its kind.
fn all_fit(plans: &[Plan]) -> bool {
    let fits = |plan: &Plan| Lanes::new(plan, long_series(plan)).fits(plan);
    plans.iter().all(fits)
}

#[test]
fn lanes_and_scalar_loop_agree_with_a_filter() {
    for effects in [law::DAMPING, 63] {
        for time_constant in [None, Some(ratio(1, 5))] {
            for mu in [50, 6] {
                let mut filtered = scene(law::ENCODER | effects, 1, mu, 200);
                filtered.at.damping_time_constant = Some(ratio(3, 2));
                filtered.at.time_constant = time_constant.clone();
                let plans = plans(&filtered, &[0.2, 1.5], &[0.4, 0.75], &[0.0, 0.5, 4.0]);
                assert!(plans.iter().all(|plan| plan.law.has(law::FILTER)) && all_fit(&plans));
                end_alike(Instructions::Best, &plans, "a filter");
                end_alike(Instructions::Baseline, &plans, "a filter");
            }
        }
    }
}

#[test]
fn lanes_and_scalar_loop_agree_with_every_controller() {
    let of = |numbers: &[i32]| numbers.iter().map(|n| ratio(*n, 1)).collect::<Vec<_>>();
    // Poles at ½, none, of a swing that dies away, and one alone under which rest is certain.
    for (numerator, denominator) in [
        (of(&[5, -5, 1]), of(&[4, -4, 1])),
        (of(&[4, -2, -1]), of(&[1])),
        (of(&[2, -3, 3]), of(&[2, -2, 1])),
        (of(&[3, -2]), of(&[2, -1])),
    ] {
        for effects in [0, law::DELAY, law::UNILATERAL, 63 & !law::DAMPING] {
            for (mu, intervals) in [(50, 900), (6, 131)] {
                let mut scene = scene(law::ENCODER | effects, 2, mu, intervals);
                let law = TransferFunction::new(numerator.clone(), denominator.clone());
                scene.at.controller = Some(Arc::new(law.unwrap()));
                let plans = plans(
                    &scene,
                    &[0.0, 0.7, 1.4, 2.3],
                    &[0.0, 0.5, 0.75, 1.5],
                    &[-1.0, 0.0, 0.5, 4.0],
                );
                let what = format!("effects {effects:b}, {numerator:?} over {denominator:?}");
                assert!(all_fit(&plans), "{what}");
                end_alike(Instructions::Best, &plans, &what);
            }
        }
    }
}

#[test]
fn lanes_and_scalar_loop_agree_with_a_latency() {
    for (latency, mu, intervals) in [(ratio(3, 10), 50, 900), (ratio(17, 9), 6, 300)] {
        for effects in [0, law::ENCODER, law::ENCODER | law::DAMPING, 63] {
            for filtered in [false, true] {
                let mut scene = scene(effects, 1, mu, intervals);
                scene.at.latency = Some(latency.clone());
                let damped = effects & law::DAMPING != 0;
                scene.at.damping_time_constant = (filtered && damped).then(|| ratio(1, 2));
                // λ of a part, or of both, below 1/16 and above it.
                let plans = plans(
                    &scene,
                    &[0.0, 0.2, 0.7, 1.4, 2.3],
                    &[0.0, 0.2, 0.5, 0.75, 1.5],
                    &[-1.0, 0.0, 0.5, 4.0],
                );
                let what = format!("effects {effects:b}, latency {latency}, μ = {mu}");
                assert!(all_fit(&plans), "{what}");
                for instructions in [Instructions::Best, Instructions::Baseline] {
                    end_alike(instructions, &plans, &what);
                }
            }
        }
    }
}

#[test]
fn jumps_without_an_encoder_are_met_in_lanes_as_in_the_scalar_loop() {
    for (latency, time_constant) in [(None, None), (Some((3, 10)), None), (None, Some((1, 5)))] {
        let part = |(n, d)| ratio(n, d);
        let mut scene = scene(law::UNILATERAL | law::DAMPING, 0, 50, 200);
        scene.at.start_position = Some(ratio(-1, 3));
        (scene.at.latency, scene.at.time_constant) = (latency.map(part), time_constant.map(part));
        // From −⅓ at the speed of 1/9 the device is at the surface in the third sample.
        let plans = plans(&scene, &[0.0], &[0.0, 0.5], &[1.0 / 9.0, 0.3]);
        assert!(all_fit(&plans));
        let first = run::outcome(&plans[0]).within_rounding_of_edge;
        assert_eq!(first, Some(3), "{latency:?} {time_constant:?}");
        end_alike(Instructions::Best, &plans, "a jump");
        end_alike(Instructions::Baseline, &plans, "a jump");
    }
}

#[test]
fn an_amplifier_behind_a_latency_goes_through_the_scalar_loop() {
    let mut scene = scene(law::ENCODER, 0, 50, 200);
    scene.at.latency = Some(ratio(1, 3));
    scene.at.time_constant = Some(ratio(1, 5));
    let plans = plans(&scene, &[0.2, 1.5], &[0.4, 0.75], &[0.5, 4.0]);
    assert!(
        plans
            .iter()
            .all(|plan| !Lanes::new(plan, long_series(plan)).fits(plan))
    );
    end_alike(Instructions::Best, &plans, "late and lagging");
}

#[test]
fn a_plan_of_a_family_is_that_of_its_point() {
    let mut point = scene(law::ENCODER | law::DELAY, 1, 50, 9);
    let plan = Family::of(&point).unwrap().with([0.75, 0.25, 2.0]).unwrap();
    point.at.viscous = Some(ratio(3, 4));
    point.at.coulomb = Some(ratio(1, 4));
    point.at.start_velocity = Some(ratio(2, 1));
    let own = Plan::compile(&point).unwrap();
    assert_eq!(format!("{plan:?}"), format!("{own:?}"));
}

#[test]
fn lanes_and_scalar_loop_agree_with_amplifier_and_arm() {
    let kinds: [(Option<BigRational>, Option<[BigRational; 3]>); 6] = [
        (Some(ratio(1, 5)), None),
        (Some(ratio(1, 50)), None),
        (Some(ratio(3, 1)), None),
        (None, Some([ratio(10, 1), ratio(1, 5), ratio(2, 1)])),
        (
            Some(ratio(1, 5)),
            Some([ratio(10, 1), ratio(1, 5), ratio(0, 1)]),
        ),
        // The scalar loop does this one.
        (
            Some(ratio(1, 5)),
            Some([ratio(10, 1), ratio(1, 5), ratio(2, 1)]),
        ),
    ];
    for (amplifier, arm) in kinds {
        for effects in [law::ENCODER, law::ENCODER | law::DELAY | law::DAMPING, 63] {
            for (mu, intervals) in [(50, 700), (3, 131)] {
                let mut scene = scene(effects, 1, mu, intervals);
                scene.at.time_constant = amplifier.clone();
                if let Some([mass, damping, stiffness]) = arm.clone() {
                    scene.at.arm_mass = Some(mass);
                    scene.at.arm_damping = Some(damping);
                    scene.at.arm_stiffness = Some(stiffness);
                }
                let plans = plans(
                    &scene,
                    &[0.0, 0.7, 1.4, 2.3],
                    &[0.0, 0.2, 0.5, 0.75],
                    &[-1.0, 0.0, 0.5, 4.0],
                );
                let what = format!("effects {effects:b}, μ = {mu}, {amplifier:?}, {arm:?}");
                end_alike(Instructions::Best, &plans, &what);
                end_alike(Instructions::Baseline, &plans, &what);
            }
        }
    }
}
