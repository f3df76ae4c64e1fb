//! TH-NDOF: cycles that draw energy from a box of devices keep the bounds on speed, by hand.

use passivity_core::joint_cycle::JointCycle;
use passivity_core::joints::{Joint, Joints, Shape};
use passivity_core::rational::to_wide;
use passivity_core::witness::quantized;
use passivity_core::{BigRational, Friction, Interval, Ordered as _, Wide};
use proptest::prelude::*;

use crate::common::{half, magnitude, q, sampled, zero};

type Range = Interval<Wide>;

fn between(lo: BigRational, hi: BigRational) -> Range {
    Interval::new(to_wide(&lo), to_wide(&hi)).unwrap()
}

fn point(n: i64, d: i64) -> Range {
    between(q(n, d), q(n, d))
}

/// Without friction.
fn joint(resolution: Option<Range>, max_speed: Option<Range>) -> Joint<Range> {
    Joint {
        viscous: None,
        coulomb: None,
        resolution,
        max_speed,
    }
}

/// The cycle for K = 1 and T of ½ … 1.
fn cycle(joints: Vec<Joint<Range>>, direction: &[i64]) -> Option<JointCycle<Wide>> {
    let device = Joints {
        stiffness: point(1, 1),
        period: between(half(), q(1, 1)),
        joints,
        shape: Shape::Direction(direction.iter().map(|a| to_wide(&q(*a, 1))).collect()),
        unilateral: false,
    };
    device.find_cycle()
}

/// K, T, and for each of two joints Δ, b and c: numbers from ½ to 5.
type Device = [BigRational; 8];

/// What is gained on a cycle: Σ Δᵢ|dᵢ|·(sgn dᵢ·Σ K aᵢaⱼΔⱼMⱼ − 2bᵢΔᵢ|dᵢ|/T − 2cᵢ).
fn gain_by_hand(
    [k, t, joints @ ..]: &Device,
    a: [i64; 2],
    from: &[BigRational],
    step: &[BigRational],
) -> BigRational {
    let moved = |j: usize| (&from[j] + &step[j]).floor() - from[j].floor();
    let torque = (0..2).fold(zero(), |sum, j| {
        sum + q(a[j], 1) * &joints[3 * j] * moved(j)
    });
    let of = |i: usize| {
        let [tick, viscous, coulomb] = [0, 1, 2].map(|at| &joints[3 * i + at]);
        let way = tick * magnitude(&step[i]);
        let held = k * q(a[i], 1) * &torque * tick * &step[i];
        held - q(2, 1) * &way * (viscous * &way / t + coulomb)
    };
    of(0) + of(1)
}

sampled! {
    /// No device of the box gains less than what is said, and with one joint that moves some device
    /// gains just that, where it is above zero.
    fn th_ndof_gain_at_least_over_the_box(
        ends in prop::array::uniform8((1i64..9, 0i64..3)), a in prop::array::uniform2(-2i64..3),
        from in prop::array::uniform2(-20i64..20), step in prop::array::uniform2(-20i64..20),
        alone in any::<bool>(), little_friction in any::<bool>(),
    ) {
        let ends: Vec<[BigRational; 2]> = ends.iter().enumerate().map(|(at, (lo, more))| {
            let friction = at > 2 && at != 5 && little_friction;
            let d = if friction { 16 } else { 2 };
            [q(*lo, d), q(lo + more, d)]
        }).collect();
        let range = |at: usize| between(ends[at][0].clone(), ends[at][1].clone());
        let joint = |at: usize| Joint {
            viscous: Some(range(at + 1)),
            coulomb: Some(range(at + 2)),
            ..joint(Some(range(at)), None)
        };
        let device = Joints {
            stiffness: range(0),
            period: range(1),
            joints: vec![joint(2), joint(5)],
            shape: Shape::Direction(a.iter().map(|a| to_wide(&q(*a, 1))).collect()),
            unilateral: false,
        };
        let from: Vec<BigRational> = from.iter().map(|x| q(*x, 4)).collect();
        let mut step: Vec<BigRational> = step.iter().map(|d| q(*d, 4)).collect();
        if alone {
            step[1] = zero();
        }
        let said = device.gain_at_least(&from, &step).unwrap();
        let corners = (0..256).map(|bits: usize| {
            let device: Device = std::array::from_fn(|at| ends[at][bits >> at & 1].clone());
            gain_by_hand(&device, a, &from, &step)
        });
        let least = to_wide(&corners.min().unwrap());
        prop_assert!((least.clone() - said.clone()).is_nonnegative().unwrap());
        if alone && said.is_positive().unwrap() {
            prop_assert_eq!(least, said);
        }
    }
}

/// A wall on one side, K = 1 against b = ¾ each, at a = (1, −1): along (1, −1) or its opposite, in ticks.
#[test]
fn th_ndof_cycles_stay_inside_a_wall_on_one_side() {
    for a in [[1, -1], [-1, 1], [1, 1], [-1, -1]] {
        let pushed = || Joint {
            viscous: Some(point(3, 4)),
            coulomb: Some(point(1, 1)),
            ..joint(Some(point(1, 1)), None)
        };
        let device = Joints {
            stiffness: point(1, 1),
            period: point(1, 1),
            joints: vec![pushed(), pushed()],
            shape: Shape::Direction(a.map(|a| to_wide(&q(a, 1))).to_vec()),
            unilateral: true,
        };
        let found = device.find_cycle().unwrap();
        for (a, (x, d)) in a.iter().zip(found.from.iter().zip(&found.step)) {
            for at in [x.clone(), x + d] {
                // In ticks from the wall's surface: both sides of it begin with a tick of their own.
                let inside = if *a > 0 {
                    at.floor() >= zero()
                } else {
                    at.floor() < zero()
                };
                assert!(inside, "{found:?}");
            }
            // No further in than it takes.
            let ends = [x.floor(), (x + d).floor()];
            let nearest = if *a > 0 {
                ends.iter().min()
            } else {
                ends.iter().max()
            };
            let first = if *a > 0 { zero() } else { q(-1, 1) };
            let untouched = x.floor() == *x && (x + d).floor() == x + d;
            assert!(*nearest.unwrap() == first || untouched, "{found:?}");
        }
    }
}

/// Of Δ = 2 and at V = 2 and T = ½ at the least, half a tick is as fast as the bound: a quarter is taken, by the
/// joint that is short of Coulomb friction, and by another one in its own direction.
#[test]
fn th_ndof_cycles_over_an_edge_keep_the_slowest_bound() {
    let (ticks, speed) = (between(q(1, 1), q(2, 1)), between(q(2, 1), q(8, 1)));
    let bounded = || joint(Some(ticks.clone()), Some(speed.clone()));
    let alone = cycle(vec![bounded()], &[1]).unwrap();
    assert_eq!(alone.step, [q(1, 4)]);
    let free = || joint(Some(ticks.clone()), None);
    for (sign, step) in [(1, q(1, 4)), (-1, q(-1, 4))] {
        let both = cycle(vec![free(), bounded()], &[1, sign]).unwrap();
        assert_eq!(both.step, [q(1, 1), step]);
    }
    // Who is not coupled to it rests, and so does who has no encoder.
    let apart = cycle(vec![free(), free()], &[1, 0]).unwrap();
    assert_eq!(apart.step, [q(1, 1), zero()]);
    for sign in [1, -1] {
        let unseen = cycle(vec![free(), joint(None, None)], &[1, sign]).unwrap();
        assert_eq!(unseen.step, [q(1, 1), zero()]);
    }
}

/// With σ = ½ at the easiest end and β = ¼, at 5/4 ticks a sample: what the slowest bound leaves of the largest tick.
#[test]
fn th_ndof_cycles_of_one_joint_keep_the_slowest_bound() {
    let of = |bound: Option<Range>| {
        let joint = Joint {
            viscous: Some(point(1, 8)),
            coulomb: Some(point(1, 2)),
            ..joint(Some(between(q(1, 1), q(2, 1))), bound)
        };
        cycle(vec![joint], &[1]).unwrap().step
    };
    let friction = Friction::new(q(1, 4), half());
    let step = |bound: Option<&BigRational>| {
        let cycle = quantized(&friction, bound).unwrap();
        [cycle.to - cycle.from]
    };
    assert_eq!(of(None), step(None));
    let bounded = of(Some(between(q(5, 1), q(6, 1))));
    assert_eq!(bounded, step(Some(&q(5, 4))));
    assert_eq!(bounded, [q(6, 5)]);
}

/// b = ¾ each is enough for either joint alone and not for both: along d = a/b = (4/3, 4/3), where −dᵀ(diag(b) −
/// ½𝐊)d = 8/9, a way of s·d gains 16/9·s² − 16/3·c·s. It is twice as long as one that gains nothing, s = 3c, and
/// moves a joint by 1 at least; up to a bound it is half-way between.
#[test]
fn th_ndof_cycles_along_a_direction_by_hand() {
    let of = |coulomb: &BigRational, resolution: Option<i64>, bounds: [Option<Range>; 2]| {
        let pushed = |bound: Option<Range>| Joint {
            viscous: Some(point(3, 4)),
            coulomb: Some(between(coulomb.clone(), coulomb.clone())),
            ..joint(resolution.map(|n| point(n, 1)), bound)
        };
        let resting = joint(None, Some(point(1, 1_000_000)));
        let mut joints: Vec<_> = bounds.map(pushed).to_vec();
        joints.push(resting);
        let device = Joints {
            stiffness: point(1, 1),
            period: point(1, 1),
            joints,
            shape: Shape::Direction([1, 1, 0].map(|a| to_wide(&q(a, 1))).to_vec()),
            unilateral: false,
        };
        device.find_cycle().unwrap()
    };
    for (coulomb, s) in [(q(1, 1), q(6, 1)), (q(1, 10), q(3, 4)), (q(1, 3), q(2, 1))] {
        let found = of(&coulomb, None, [None, None]);
        let way = &s * q(4, 3);
        assert_eq!(found.step, [way.clone(), way, zero()]);
        let gain = q(16, 9) * &s * &s - q(16, 3) * coulomb * s;
        assert_eq!(found.gain, to_wide(&gain));
    }
    let bounds = || [point(10, 1), between(q(4, 1), q(6, 1))].map(Some);
    let [slow, fast] = bounds();
    for bounds in [bounds(), [fast, slow]] {
        let found = of(&half(), None, bounds);
        assert_eq!(found.step, [q(3, 1), q(3, 1), zero()]);
    }
    // To the nearest tick: 8c = 17/2 and 33/4.
    for (coulomb, ticks) in [(q(17, 16), 9), (q(33, 32), 8)] {
        let found = of(&coulomb, Some(1), [None, None]);
        assert_eq!(found.step, [q(ticks, 1), q(ticks, 1), zero()]);
        assert_eq!(found.from, [zero(), zero(), zero()]);
    }
}
