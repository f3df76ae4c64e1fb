//! TH-NDOF: the criterion for several joints, its borders and directions, by hand.

use passivity_core::decision::Enclosed as _;
use passivity_core::definite::{Form, decide_enclosed, quadratic};
use passivity_core::joint_criterion::Asked;
use passivity_core::joints::{Joint, Joints, Place, Shape};
use passivity_core::pi::pi;
use passivity_core::rational::to_wide;
use passivity_core::{BigRational, Exact, Interval, Ordered as _, Parameter, Scalar as _};
use passivity_core::{Truth, Wide};

use crate::common::q;
use crate::exact::PI;

type Device = Joints<Wide, Wide>;

fn w(n: i64, d: i64) -> Wide {
    to_wide(&q(n, d))
}

fn joint(viscous: Wide, coulomb: Wide, max_speed: Option<Wide>) -> Joint<Wide> {
    Joint {
        viscous: Some(viscous),
        coulomb: Some(coulomb),
        resolution: Some(w(2, 1)),
        max_speed,
    }
}

/// Of K = 1 and T = 1.
fn device(joints: Vec<Joint<Wide>>, shape: Shape<Wide>) -> Device {
    Joints {
        stiffness: w(1, 1),
        period: w(1, 1),
        joints,
        shape,
        unilateral: false,
    }
}

fn matrix(rows: &[&[i64]]) -> Shape<Wide> {
    let row = |row: &&[i64]| row.iter().map(|x| w(*x, 1)).collect();
    Shape::Matrix(rows.iter().map(row).collect())
}

fn direction(a: &[i64]) -> Shape<Wide> {
    Shape::Direction(a.iter().map(|x| w(*x, 1)).collect())
}

/// Joints of these frictions, without Coulomb friction and without bounds.
fn viscous(frictions: &[(i64, i64)], shape: Shape<Wide>) -> Device {
    let joints = frictions.iter().map(|b| joint(w(b.0, b.1), w(0, 1), None));
    device(joints.collect(), shape)
}

fn boxed(device: &Device) -> Joints<Interval<Wide>, Wide> {
    device
        .try_map(|_, x| Some(Interval::point(x.clone())))
        .unwrap()
}

/// The border at the hardest end, which is that at the easiest.
fn border(
    device: &Device,
    parameter: Parameter,
    joint: Option<usize>,
    asked: Asked,
) -> Option<Wide> {
    let [hardest, easiest] = boxed(device).border(Place { parameter, joint }, asked)?;
    assert_eq!(hardest, easiest);
    Some(hardest)
}

/// A joint without a bound matters where another is coupled to it, whatever it is to itself.
#[test]
fn th_ndof_bounds_help_where_all_that_is_coupled_has_one() {
    let bounds = |bounds: [bool; 2], shape| {
        let of = |bound: bool| joint(w(1, 1), w(1, 1), bound.then(|| w(3, 1)));
        device(bounds.map(of).to_vec(), shape).is_bounded()
    };
    let (apart, coupled) = (matrix(&[&[1, 0], &[0, 1]]), matrix(&[&[2, 1], &[1, 2]]));
    for (which, apart_too, coupled_too) in [
        ([true, true], true, true),
        ([true, false], true, false),
        ([false, true], true, false),
        ([false, false], false, false),
    ] {
        assert_eq!(bounds(which, apart.clone()), Some(apart_too));
        assert_eq!(bounds(which, direction(&[1, 0])), Some(apart_too));
        assert_eq!(bounds(which, coupled.clone()), Some(coupled_too));
        assert_eq!(bounds(which, direction(&[1, -1])), Some(coupled_too));
    }
}

/// cᵢ − ½Σ|Kᵢⱼ|Δⱼ − ½|K₁₂|VⱼT and Vᵢ(bᵢ − ½KᵢᵢT) more, with Δ = 2, and with K₁₂ of either sign.
#[test]
fn th_ndof_margins_up_to_bounds_by_hand() {
    for sign in [1, -1] {
        let joints = vec![
            joint(w(5, 1), w(20, 1), Some(w(3, 1))),
            joint(w(7, 1), w(30, 1), Some(w(8, 1))),
        ];
        let device = device(joints, matrix(&[&[2, sign], &[sign, 4]]));
        // At rest 20 − 3 − 4 = 13 and 30 − 5 − 3/2 = 47/2.
        let expected = [w(13 + 3 * 4, 1), w(13, 1), w(47 + 16 * 5, 2), w(47, 2)];
        assert_eq!(device.margins_up_to_bounds(), expected);
    }
}

/// diag(b) − ½T𝐊 entry by entry, and the direction that shows where it is not definite.
#[test]
fn th_ndof_viscous_form_by_hand() {
    let three = viscous(
        &[(5, 1), (7, 1), (11, 1)],
        matrix(&[&[2, -1, 3], &[-1, 4, 1], &[3, 1, 8]]),
    );
    let expected = [
        [w(4, 1), w(1, 2), w(-3, 2)],
        [w(1, 2), w(5, 1), w(-1, 2)],
        [w(-3, 2), w(-1, 2), w(7, 1)],
    ];
    assert_eq!(three.viscous_form(), expected);
    let negative = |device: &Device| match device.viscous_definite() {
        Some(Form::Negative(d)) => {
            assert!(quadratic(&device.viscous_form(), &d).is_positive() == Some(false));
            d
        }
        other => panic!("{other:?}"),
    };
    // A joint that the wall acts on and that has no friction moves alone.
    let bare = viscous(&[(9, 1), (0, 1), (9, 1)], direction(&[1, 2, 0]));
    assert_eq!(negative(&bare), [w(0, 1), w(1, 1), w(0, 1)]);
    // KT·(1 + 4/3) > 2: by aᵢ/bᵢ; the joint that the wall does not act on rests.
    let steep = viscous(&[(1, 1), (3, 1), (0, 1)], direction(&[1, 2, 0]));
    assert_eq!(negative(&steep), [w(1, 1), w(2, 3), w(0, 1)]);
}

#[test]
fn th_ndof_least_viscous_friction_by_hand() {
    let of = |device: &Device, i| border(device, Parameter::Viscous, Some(i), Asked::EverySpeed);
    // ½·a₁²/(1 − ½·a₂²/b₂).
    let pair = |b: (i64, i64), a: &[i64]| viscous(&[(1, 1), b], direction(a));
    assert_eq!(of(&pair((4, 1), &[3, 2]), 0), Some(w(9, 1)));
    // What the others leave is zero, or less.
    assert_eq!(of(&pair((2, 1), &[3, 2]), 0), None);
    assert_eq!(of(&pair((1, 1), &[3, 2]), 0), None);
    // The wall does not act on it.
    assert_eq!(of(&pair((4, 1), &[0, 2]), 0), None);
    // No such joint.
    assert_eq!(of(&pair((4, 1), &[3, 2]), 2), None);
    let square = viscous(&[(1, 1), (2, 1)], matrix(&[&[2, 1], &[1, 2]]));
    assert_eq!(of(&square, 2), None);
    // (b − 1)(2 − 1) ≥ ¼.
    assert_eq!(of(&square, 0), Some(w(5, 4)));
    // Asked at every speed the bounds do not matter, and neither does it that friction is missing.
    let mut bounded = square;
    for joint in &mut bounded.joints {
        joint.max_speed = Some(w(1, 1));
    }
    assert_eq!(of(&bounded, 0), Some(w(5, 4)));
}

/// The largest K with b − ½K𝐌 semidefinite, within 2⁻³² of it, wherever the search begins.
#[test]
fn th_ndof_largest_stiffness_of_a_matrix() {
    let with = |stiffness: Wide, b: (i64, i64), shape| {
        let mut device = viscous(&[b, b], shape);
        device.stiffness = stiffness;
        for joint in &mut device.joints {
            joint.coulomb = Some(w(1_000_000_000, 1));
        }
        border(&device, Parameter::Stiffness, None, Asked::EverySpeed)
    };
    // The eigenvalues are 3 and 1: K = 2/3.
    let square = || matrix(&[&[2, 1], &[1, 2]]);
    for now in [w(1, 1), w(1, 10), w(100, 1), w(2, 3), w(1, 1000)] {
        let found = with(now, (1, 1), square()).unwrap();
        let found = found.enclosed(64).unwrap().lo().clone();
        let most = q(2, 3);
        let least = &most * (q(1, 1) - q(1, 1 << 32));
        assert!(least <= found && found <= most);
    }
    // None is allowed without friction, and all are without a wall: there encoders ask for nothing.
    assert_eq!(with(w(1, 1), (0, 1), square()), Some(w(0, 1)));
    assert_eq!(with(w(1, 1), (1, 1), matrix(&[&[0, 0], &[0, 0]])), None);
    assert_eq!(with(w(1, 1), (1, 1), direction(&[0, 0])), None);
}

/// The same with b = 1 and 𝐌 = (π/180)·(𝟏 + 11ᵀ), whose largest eigenvalue for n joints is (n + 1)π/180, which
/// no fraction is: for as many joints as a scene may have, each decision in some thousandths of a second.
#[test]
fn th_ndof_largest_stiffness_of_a_matrix_with_pi() {
    let number = |n: i32| Interval::point(Exact::integer(n));
    let degree = pi().over(Exact::integer(180));
    for n in [2, 6, 12] {
        let entry = |i, j| degree.clone() * Exact::integer(if i == j { 2 } else { 1 });
        let row = |i| (0..n).map(|j| entry(i, j)).collect();
        let joint = |_| Joint {
            viscous: Some(number(1)),
            coulomb: Some(number(1)),
            resolution: None,
            max_speed: None,
        };
        let device = Joints {
            stiffness: number(1),
            period: number(1),
            joints: (0..n).map(joint).collect(),
            shape: Shape::Matrix((0..n).map(row).collect()),
            unilateral: false,
        };
        let place = Place {
            parameter: Parameter::Stiffness,
            joint: None,
        };
        let [found, easiest] = device.border(place, Asked::EverySpeed).unwrap();
        assert_eq!(found, easiest);
        let most = Exact::integer(2).over(degree.clone() * Exact::integer(n + 1));
        let least = most.clone() * Exact::of(&(q(1, 1) - q(1, 1 << 32)));
        assert!(least <= found && found <= most, "{n}");
    }
}

/// A joint alone whose viscous friction is ¼ less than ½KT needs as much more Coulomb friction as the bound
/// of its speed takes of it; one with more of it needs no less than at rest.
#[test]
fn th_ndof_least_coulomb_friction_up_to_a_bound() {
    for (b, expected) in [((1, 4), w(1, 1) + w(3, 4)), ((3, 4), w(1, 1))] {
        let joints = vec![joint(w(b.0, b.1), w(5, 1), Some(w(3, 1)))];
        let device = device(joints, direction(&[1]));
        let found = border(&device, Parameter::Coulomb, Some(0), Asked::UpToBounds);
        assert_eq!(found, Some(expected));
    }
    // At every speed what is missing of viscous friction is not made up for.
    let joints = vec![joint(w(1, 4), w(5, 1), Some(w(3, 1)))];
    let device = device(joints, direction(&[1]));
    assert_eq!(device.holds(Asked::UpToBounds), Some(true));
    assert_eq!(device.holds(Asked::EverySpeed), Some(false));
}

/// b − ½K over b of ¼ … ¾ and K = 1.
#[test]
fn th_ndof_viscous_over_tolerances() {
    let of = |lo: Wide, hi: Wide| {
        let joint = Joint {
            viscous: Some(Interval::new(lo, hi).unwrap()),
            coulomb: None,
            resolution: None,
            max_speed: None,
        };
        let device = Joints {
            stiffness: Interval::point(w(1, 1)),
            period: Interval::point(w(1, 1)),
            joints: vec![joint],
            shape: direction(&[1]),
            unilateral: false,
        };
        device.decide_viscous()
    };
    assert_eq!(of(w(1, 4), w(3, 4)), Truth::Depends);
    assert_eq!(of(w(1, 2), w(3, 4)), Truth::Holds);
    assert_eq!(of(w(1, 4), w(1, 3)), Truth::Fails);
}

/// A matrix that is short of semidefinite by far less than what enclosures of 64 bits leave open. Of these the
/// middle is above kπ and, of its opposite, below, by 0.42 of their width: [[kπ, x], [x, kπ]] with x = 2kπ − kπ
/// looks semidefinite where that is not counted in every entry.
#[test]
fn th_ndof_matrices_a_little_short_of_semidefinite() {
    let scale = BigRational::from_integer(num_bigint::BigInt::from(1) << 100);
    let below = |x: BigRational| (x * &scale).floor() / &scale;
    let rational = |x: &BigRational| Exact::of(x);
    for k in 1..6 {
        // The form of (1, −1) is −2⁻⁷⁹, and less than 3·2⁻¹⁰⁰ more for what is rounded.
        let of_pi = rational(&q(k, 1)) * pi();
        let last = below(&*PI * q(k, 1));
        let twice = below(&*PI * q(2 * k, 1)) + q(1, 1 << 40) * q(1, 1 << 40);
        let x = rational(&twice) - of_pi.clone();
        let rows = [vec![of_pi, x.clone()], vec![x, rational(&last)]];
        let form = decide_enclosed(&rows).unwrap();
        assert!(!form.is_semidefinite(), "{k}");
        // The same off the diagonal alone.
        let of_pi = || rational(&q(k, 1)) * pi();
        let least = || rational(&(&last - q(1, 1 << 40) * q(1, 1 << 40)));
        let rows = [vec![least(), of_pi()], vec![of_pi(), least()]];
        let form = decide_enclosed(&rows).unwrap();
        assert!(!form.is_semidefinite(), "{k}");
    }
}
