//! TH-NDOF: the account, the criterion and the cycles of devices of several joints.

mod by_hand;

use passivity_core::decision::Enclosed;
use passivity_core::definite::{self, Form};
use passivity_core::joint_criterion::Asked;
use passivity_core::joints::{Joint, Joints, Place, Shape};
use passivity_core::rational::to_wide;
use passivity_core::{BigRational, Interval, Parameter, Truth, Wide};
use proptest::prelude::*;

use self::by_hand::{
    lengths, matrix_of, needed_of, net_by_hand, semidefinite_by_minors, stored, torques_by_hand,
};
use crate::common::{half, magnitude, q, sampled, squared, zero};

/// A device in plain rationals.
type Device = Joints<BigRational, BigRational>;

/// A position or a displacement of one joint: on a coarse grid, or beside an edge.
fn ticks() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        3 => (-48i64..48).prop_map(|n| q(n, 16)),
        1 => (-6i64..6).prop_map(|n| q(n, 1) - q(1, 1 << 30)),
        1 => (-6i64..6, 1i64..1000).prop_map(|(n, e)| q(n, 1) + q(1, e)),
        1 => (-40i64..40).prop_map(|n| q(n, 1)),
    ]
}

/// About 1, or 1 exactly.
fn near_one() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        2 => Just(q(1, 1)),
        1 => Just(q(1, 1) - q(1, 1 << 40)),
        1 => Just(q(1, 1) + q(1, 1 << 40)),
        2 => (900i64..1100).prop_map(|n| q(n, 1000)),
    ]
}

fn positive() -> impl Strategy<Value = BigRational> {
    (1i64..40, 1i64..12).prop_map(|(n, d)| q(n, d))
}

/// Entries of a direction, or of the rows of a matrix that is made positive semidefinite.
fn entry() -> impl Strategy<Value = BigRational> {
    prop_oneof![1 => Just(zero()), 4 => (-9i64..9, 1i64..5).prop_map(|(n, d)| q(n, d))]
}

fn shape(n: usize) -> impl Strategy<Value = Shape<BigRational>> {
    let direction = prop::collection::vec(entry(), n);
    let factors = prop::collection::vec(prop::collection::vec(entry(), n), 1..=n);
    prop_oneof![
        2 => direction.prop_map(Shape::Direction),
        1 => factors.prop_map(move |factors| {
            let at = |i: usize, j: usize| factors.iter().map(|f| &f[i] * &f[j]).sum();
            let row = |i: usize| (0..n).map(|j| at(i, j)).collect();
            Shape::Matrix((0..n).map(row).collect())
        }),
    ]
}

/// Devices of one to three joints with friction at the border of the criterion, or near it.
fn device() -> impl Strategy<Value = Device> {
    (1usize..=3).prop_flat_map(|n| {
        let resolution = prop::option::weighted(0.8, positive());
        let each = (positive(), resolution, near_one());
        let joints = prop::collection::vec(each, n);
        (
            positive(),
            positive(),
            shape(n),
            joints,
            near_one(),
            any::<bool>(),
        )
            .prop_map(
                |(stiffness, period, shape, drawn, by_viscous, unilateral)| {
                    let is_direction = matches!(shape, Shape::Direction(_));
                    let joint = |(b, delta, _): &(BigRational, Option<BigRational>, _)| Joint {
                        viscous: Some(b.clone()),
                        coulomb: None,
                        resolution: delta.clone(),
                        max_speed: None,
                    };
                    let mut device = Joints {
                        stiffness,
                        period,
                        joints: drawn.iter().map(joint).collect(),
                        shape,
                        unilateral: unilateral && is_direction,
                    };
                    let needed = needed_of(&device);
                    for ((joint, needed), (.., by)) in
                        device.joints.iter_mut().zip(needed).zip(&drawn)
                    {
                        joint.coulomb = Some(needed * by);
                    }
                    // Of a direction the friction that meets Σa²/b = 2/(KT) exactly is known.
                    if let Shape::Direction(a) = &device.shape {
                        let terms = a.iter().zip(&device.joints);
                        let load: BigRational = terms
                            .map(|(a, joint)| squared(a) / joint.viscous.clone().unwrap())
                            .sum();
                        let factor =
                            &device.stiffness * &device.period * half() * load * by_viscous;
                        for joint in &mut device.joints {
                            joint.viscous = joint.viscous.take().map(|b| b * &factor);
                        }
                    }
                    device
                },
            )
    })
}

/// The device as a box of one point, in the kind of number that verdicts are made with.
fn boxed(device: &Device) -> Joints<Interval<Wide>, Wide> {
    let point = device
        .try_map(|_, x| Some(Interval::point(to_wide(x))))
        .unwrap();
    point.reshaped(device.shape.try_map(|x| Some(to_wide(x))).unwrap())
}

fn rational(x: &Wide) -> BigRational {
    x.enclosed(64).unwrap().lo().clone()
}

sampled! {
    fn th_ndof_generated_is_the_form_with_residues(
        device in device(), from in prop::collection::vec(ticks(), 3), to in prop::collection::vec(ticks(), 3)
    ) {
        let n = device.joints.len();
        let (from, to) = (&from[..n], &to[..n]);
        let bilateral = Joints { unilateral: false, ..device.clone() };
        let by_hand = net_by_hand(&frictionless(&bilateral), from, to, &q(1, 1))
            + stored(&bilateral, to) - stored(&bilateral, from);
        prop_assert_eq!(bilateral.generated(from, to), by_hand.clone());
        prop_assert_eq!(bilateral.generated_by_residues(from, to), by_hand);
        prop_assert_eq!(device.held_torques(from), torques_by_hand(&device, from));
    }

    /// Of one-sided walls as well, with what they store.
    fn th_ndof_generated_is_within_the_bound(
        device in device(), from in prop::collection::vec(ticks(), 3), to in prop::collection::vec(ticks(), 3)
    ) {
        let n = device.joints.len();
        let (from, to) = (&from[..n], &to[..n]);
        let way: Vec<BigRational> = (0..n).map(|i| (&to[i] - &from[i]) * &lengths(&device)[i]).collect();
        let generated = net_by_hand(&frictionless(&device), from, to, &q(1, 1))
            + stored(&device, to) - stored(&device, from);
        let by_hand = definite::quadratic(&matrix_of(&device), &way) * half()
            + way.iter().zip(needed_of(&device)).map(|(d, c)| magnitude(d) * c).sum::<BigRational>();
        prop_assert!(generated <= by_hand);
        prop_assert_eq!(device.bound(&way), by_hand);
    }

    fn th_ndof_definite_is_that_of_the_minors(
        rows in prop::collection::vec(prop::collection::vec(-3i64..4, 4), 1..=4)
    ) {
        let n = rows.len();
        let entry = |i: usize, j: usize| q(rows[i.max(j)][i.min(j)], 1);
        let matrix: Vec<Vec<BigRational>> =
            (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let form = definite::decide(matrix.clone()).unwrap();
        prop_assert_eq!(form.is_semidefinite(), semidefinite_by_minors(&matrix));
        if let Form::Negative(d) = form {
            prop_assert!(definite::quadratic(&matrix, &d) < zero());
        }
    }

    /// The criterion is the one of the theory, and where it fails there is a cycle that draws.
    fn th_ndof_verdict_and_its_cycle(device in device()) {
        let mut form = matrix_of(&device);
        for (i, row) in form.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let b = if i == j { device.joints[i].viscous.clone().unwrap() } else { zero() };
                *entry = b - &device.period * half() * &*entry;
            }
        }
        let by_coulomb = device.joints.iter().zip(needed_of(&device))
            .all(|(joint, needed)| joint.coulomb.clone().unwrap() >= needed);
        let expected = by_coulomb && semidefinite_by_minors(&form);
        let as_box = boxed(&device);
        prop_assert_eq!(as_box.decide(Asked::EverySpeed), if expected { Truth::Holds } else { Truth::Fails });
        let cycle = as_box.find_cycle();
        prop_assert_eq!(cycle.is_some(), !expected);
        if let Some(cycle) = cycle {
            let to: Vec<BigRational> = cycle.from.iter().zip(&cycle.step).map(|(x, d)| x + d).collect();
            let one = q(1, 1);
            let gain = net_by_hand(&device, &cycle.from, &to, &one)
                + net_by_hand(&device, &to, &cycle.from, &one);
            prop_assert!(gain > zero());
            prop_assert_eq!(rational(&cycle.gain), gain.clone());
            prop_assert_eq!(device.gain(&cycle.from, &cycle.step), gain);
        }
    }

    /// Where the verdict is passive, no motion draws more than what was stored at its start.
    fn th_ndof_passive_draws_nothing(
        device in device(),
        walk in prop::collection::vec((prop::collection::vec(ticks(), 3), 1i64..=8), 2..20)
    ) {
        let device = relieved(device);
        let n = device.joints.len();
        prop_assert!(boxed(&device).holds_at_every_speed());
        let mut drawn = zero();
        for pair in walk.windows(2) {
            let (from, to) = (&pair[0].0[..n], &pair[1].0[..n]);
            drawn += net_by_hand(&device, from, to, &q(pair[0].1, 8));
            let at_start = stored(&device, &walk[0].0[..n]);
            prop_assert!(drawn <= at_start - stored(&device, to));
        }
    }

    /// Under bounds on the joints' speeds: passive motions draw nothing, cycles keep the bounds.
    fn th_ndof_within_bounds(
        device in device(), speeds in prop::collection::vec(positive(), 3), share in 1i64..12,
        walk in prop::collection::vec(prop::collection::vec(-16i64..=16, 3), 1..20)
    ) {
        let mut device = device;
        let lengths = lengths(&device);
        for (i, joint) in device.joints.iter_mut().enumerate() {
            joint.max_speed = Some(&speeds[i] * q(share, 4));
            // Friction that may do up to the bound only.
            joint.coulomb = joint.coulomb.take().map(|c| c * q(3, 1));
            joint.viscous = joint.viscous.take().map(|b| b * q(3, 4));
        }
        let bound = |i: usize| device.joints[i].max_speed.clone().unwrap() * &device.period / &lengths[i];
        let as_box = boxed(&device);
        match as_box.decide(Asked::UpToBounds) {
            Truth::Holds => {
                let mut at: Vec<BigRational> = vec![q(1, 3); device.joints.len()];
                let start = stored(&device, &at);
                let mut drawn = zero();
                for step in walk {
                    let to: Vec<BigRational> = at.iter().enumerate()
                        .map(|(i, x)| x + bound(i) * q(step[i], 16)).collect();
                    drawn += net_by_hand(&device, &at, &to, &q(1, 1));
                    prop_assert!(drawn <= &start - stored(&device, &to));
                    at = to;
                }
            }
            Truth::Fails => {
                if let Some(cycle) = as_box.find_cycle() {
                    for (i, d) in cycle.step.iter().enumerate() {
                        prop_assert!(magnitude(d) < bound(i) || *d == zero());
                    }
                    prop_assert!(device.gain(&cycle.from, &cycle.step) > zero());
                }
            }
            Truth::Depends => prop_assert!(false, "a single device without π is decided"),
        }
    }

    /// A limit is where the criterion changes: it holds at the limit and not beyond it.
    fn th_ndof_limits_are_borders(device in device(), bounds in any::<bool>(), speed in positive()) {
        let mut device = device;
        if bounds {
            for joint in &mut device.joints {
                joint.max_speed = Some(speed.clone());
            }
        }
        let as_box = boxed(&device);
        for asked in [Asked::EverySpeed, Asked::UpToBounds] {
            for place in as_box.places().collect::<Vec<_>>() {
                if as_box.get(place).is_none() {
                    continue;
                }
                let Some([border, _]) = as_box.border(place, asked) else { continue };
                let border = rational(&border);
                if border <= zero() {
                    continue;
                }
                let at = |x: BigRational| {
                    let moved = as_box.clone().with(place, Interval::point(to_wide(&x)));
                    moved.decide(asked)
                };
                let beyond = match place.parameter {
                    Parameter::Viscous | Parameter::Coulomb => &border * q(999, 1000),
                    _ => &border * q(1001, 1000),
                };
                prop_assert_eq!(at(beyond), Truth::Fails, "{:?} {:?}", place, asked);
                let friction = [Parameter::Viscous, Parameter::Coulomb].contains(&place.parameter);
                if place.parameter == Parameter::Stiffness || (friction && device.joints.len() == 1) {
                    // One parameter of several need not be enough.
                    let suffices = at(border) == Truth::Holds;
                    prop_assert!(suffices || place.parameter != Parameter::Stiffness, "{:?}", asked);
                }
            }
        }
    }
}

fn frictionless(device: &Device) -> Device {
    let mut device = device.clone();
    for joint in &mut device.joints {
        joint.viscous = None;
        joint.coulomb = None;
    }
    device
}

/// The device with enough friction where it has too little: at the border of what its shape says.
fn relieved(mut device: Device) -> Device {
    let needed = needed_of(&device);
    for (joint, needed) in device.joints.iter_mut().zip(needed) {
        joint.coulomb = Some(needed);
    }
    while !boxed(&device).holds_at_every_speed() {
        for joint in &mut device.joints {
            joint.viscous = joint.viscous.take().map(|b| b * q(9, 8));
        }
    }
    device
}

/// What the tests ask of a box.
trait Question {
    fn holds_at_every_speed(&self) -> bool;
}

impl Question for Joints<Interval<Wide>, Wide> {
    fn holds_at_every_speed(&self) -> bool {
        self.decide(Asked::EverySpeed) == Truth::Holds
    }
}

/// The cross term matters: with c₁ at nine tenths of ½(|K₁₁|Δ₁ + |K₁₂|Δ₂) a cycle draws that crosses an
/// edge of the other joint.
#[test]
fn th_ndof_cross_term_draws() {
    let joint = |coulomb| Joint {
        viscous: Some(q(10, 1)),
        coulomb: Some(coulomb),
        resolution: Some(q(1, 1)),
        max_speed: None,
    };
    let device = Joints {
        stiffness: q(1, 1),
        period: q(1, 1),
        joints: vec![joint(q(9, 10)), joint(q(1, 1))],
        shape: Shape::Direction(vec![q(1, 1), q(1, 1)]),
        unilateral: true,
    };
    let as_box = boxed(&device);
    assert_eq!(as_box.decide(Asked::UpToBounds), Truth::Fails);
    let cycle = as_box.find_cycle().unwrap();
    assert!(cycle.step.iter().all(|d| *d != zero()));
    // Without the crossing of the other joint the same move draws nothing.
    let alone = [cycle.step[0].clone(), zero()];
    assert!(device.gain(&cycle.from, &alone) <= zero());
    let enough = device.with(
        Place {
            parameter: Parameter::Coulomb,
            joint: Some(0),
        },
        q(1, 1),
    );
    assert_eq!(boxed(&enough).decide(Asked::EverySpeed), Truth::Holds);
}
