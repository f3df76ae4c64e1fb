//! TH-CHECK, TH-LTI: what is said of boxes whose costs have to be computed, by hand; Δ, K and T are 1, σ is
//! 9 and V has no bound unless a line says otherwise.

use std::sync::Arc;

use passivity_core::frequency::ViscousCost;
use passivity_core::linear_part::Command;
use passivity_core::parameter::Parameter;
use passivity_core::pi::pi;
use passivity_core::rational::to_wide;
use passivity_core::verdict::Speeds;
use passivity_core::{BigRational, Enclosed, Exact, Interval, Loop, Scalar, Truth, Wide};

use crate::common::{half, q, zero};
use crate::exact::PI;
use crate::transfer::Controller;

pub(crate) type Ends = Interval<Wide>;

/// A decimal, or a fraction of two.
pub(crate) fn number(text: &str) -> BigRational {
    let (n, d) = text.split_once('/').unwrap_or((text, "1"));
    let decimal = |text: &str| {
        let (whole, digits) = text.split_once('.').unwrap_or((text, ""));
        let scale = 10_i64.pow(u32::try_from(digits.len()).unwrap());
        q(format!("{whole}{digits}").parse().unwrap(), scale)
    };
    decimal(n) / decimal(d)
}

/// 1/(1 − z⁻¹/2)²: c = 1, 1, ¾, ½, …, H(1) = ‖c‖₁ = 4, and Σ|gⱼ| = Σ jcⱼ = 8, none of which the enclosure
/// of an infinite sum ever meets exactly. λ = ½·4 + 8, at rest.
fn slow() -> Arc<Controller> {
    Arc::new(Controller::new([q(1, 1)], [q(1, 1), q(-1, 1), q(1, 4)]).unwrap())
}

/// A box and the speeds that are asked for, as in `b=1..2 k=1 V=3`; `slow` is the controller.
pub(crate) fn asked(line: &str) -> (Loop<Ends>, Speeds<Ends>) {
    let range = |text: &str| {
        let (lo, hi) = text.split_once("..").unwrap_or((text, text));
        Interval::hull(to_wide(&number(lo)), to_wide(&number(hi)))
    };
    let mut of = Loop {
        coulomb: Some(range("9")),
        resolution: Some(range("1")),
        ..Loop::new(range("1"), range("1"))
    };
    let mut speeds = Speeds::All;
    for item in line.split(' ') {
        let (key, value) = item.split_once('=').unwrap_or((item, ""));
        let parameter = match key {
            "b" => Parameter::Viscous,
            "c" => Parameter::Coulomb,
            "K" => Parameter::Stiffness,
            "T" => Parameter::Period,
            "B" => Parameter::Damping,
            "τ" => Parameter::DampingTimeConstant,
            "L" => Parameter::Latency,
            "θ" => Parameter::TimeConstant,
            "k" => {
                of.delay = value.parse().unwrap();
                continue;
            }
            "V" => {
                speeds = Speeds::UpTo(range(value));
                continue;
            }
            "V²" => {
                speeds = Speeds::UpToSquared(range(value));
                continue;
            }
            "slow" => {
                of.controller = Some(slow());
                continue;
            }
            _ => panic!("{key}"),
        };
        of = of.with(parameter, range(value));
    }
    (of, speeds)
}

pub(crate) fn assert_said(truth: Truth, lines: &[&str]) {
    for line in lines {
        let (of, speeds) = asked(line);
        assert_eq!(of.truth(&speeds), Some(truth), "{line}");
        assert_eq!(of.surely_holds(&speeds), truth == Truth::Holds, "{line}");
    }
}

/// κ(s) = ½[(½ + s) + √((½ + s)² + s(1 − s))] is 0.962347538… at 0.4 and 0.753112887… at 0.2, and the cells
/// of a box tell to about 10⁻⁶, and to 10⁻¹⁰ where one corner is the hardest.
#[test]
fn th_latency_boxes_are_cut_into_cells() {
    assert_said(
        Truth::Holds,
        &[
            "b=1 L=0.2..0.4",
            "b=0.96235 L=0.2..0.4",
            "b=0.962348 L=0.2..0.4",
            "b=0.9624 L=0..0.4",
            // 3/2 of it.
            "b=1.444 L=0.2..0.4 K=1..1.5",
            "b=1.6 L=0.2..0.4 K=1..1.5",
            "b=1.46 L=0..0.4 K=1..1.5",
        ],
    );
    assert_said(
        Truth::Fails,
        &[
            "b=0.6 L=0.2..0.4",
            "b=0.75311 L=0.2..0.4",
            "b=0.752 L=0.2..0.4 K=1..1.5",
            "b=0.7528 L=0.2..0.4 K=1..1.5",
            "b=0.49999 L=0..0.4",
            "b=0.8 L=0.2..0.4 θ=0.1..0.2",
        ],
    );
    assert_said(
        Truth::Depends,
        &[
            "b=0.9 L=0.2..0.4",
            "b=0.96234 L=0.2..0.4",
            "b=0.7532 L=0.2..0.4",
            "b=0.9 L=0.2..0.4 θ=0.1..0.2",
            "b=1.44 L=0.2..0.4 K=1..1.5",
            // All corners hold, or none does, by less than the cells tell.
            "b=0.962347538298 L=0.2..0.4",
            "b=0.7531128874149 L=0.2..0.4",
            "b=1.443521307447 L=0.2..0.4 K=1..1.5",
            "b=0.7531128874149 L=0.2..0.4 K=1..1.5",
        ],
    );
}

/// A filter leaves KT/2 + B·T/(T + 2τ) of viscous and KΔ/2 + BΔ/(T + τ) of Coulomb friction to pay.
#[test]
fn th_lti_boxes_of_filtered_damping() {
    assert_said(
        Truth::Holds,
        &[
            "b=5/6 c=1 B=1 τ=1",
            "b=5/6 c=1 B=1 τ=1..1.1",
            "b=0.84 c=1.1 B=1 τ=1..1.1 T=0.9..1",
            // Up to V = 2: c − ½ − 1/(T + τ) + (b − T/2 − T/(T + 2τ))·2 is 7/30 at T = 1 and τ = ½.
            "b=0.9 c=1.6 B=1 τ=0.5..1 T=0.5..1 V=1..2",
            "b=0.8 c=1.7 B=1 τ=0.5..1 T=0.5..1 V=1..2",
        ],
    );
    assert_said(
        Truth::Fails,
        &[
            "b=0.8333 c=1 B=1 τ=1",
            "b=5/6 c=0.9999 B=1 τ=1",
            // ½ + 1/3.2 and ½ + 1/2.1 at the slowest.
            "b=0.812 c=1.01 B=1 τ=1..1.1",
            "b=0.9 c=0.97 B=1 τ=1..1.1",
            "b=0.7 c=1.1 B=1 τ=1..1.1 T=0.9..1",
            "b=0.9 c=0.9 B=1 τ=1..1.1 T=0.9..1",
            "b=0.6 c=1 B=1 τ=0.5..1 T=0.5..1 V=1..2",
            "b=0.1 c=1.1 B=1 τ=0.5..1 T=0.5..1 V=1..2",
        ],
    );
    assert_said(
        Truth::Depends,
        &[
            "b=0.8333 c=1.01 B=1 τ=1..1.1",
            "b=0.815 c=1.01 B=1 τ=1..1.1",
            "b=0.9 c=0.98 B=1 τ=1..1.1",
            "b=0.9 c=1.02 B=1 τ=1..1.1 T=0.9..1",
            "b=0.5 c=1.6 B=1 τ=0.5..1 T=0.5..1 V=1..2",
            "b=0.8 c=1.55 B=1 τ=0.5..1 T=0.5..1 V=1..2",
            // At T = 1 c is short, 1 is asked for, and at T = 2 b, 3/2 is: at 3/2 neither is.
            "b=1.2 c=0.92 B=1 τ=1 T=1..2",
        ],
    );
}

/// The controller costs KT·10 and KΔ·2, behind a latency 4κ + 8.
#[test]
fn th_lti_boxes_beside_a_controller() {
    assert_said(
        Truth::Holds,
        &[
            "b=11 c=3 slow",
            "b=11 c=2.0000000000001 slow",
            "b=11 c=2.0000000000001 slow V=1",
            "b=11 c=2.3 slow K=1..1.1",
            // 8 + 4·0.753….
            "b=12 c=3 slow L=0.1..0.2",
            "b=12 c=2.0000000000001 slow L=0.1..0.2",
        ],
    );
    assert_said(
        Truth::Fails,
        &[
            "b=9 c=3 slow",
            "b=11 c=1.9999999999999 slow",
            "b=11 c=1.9999999999999 slow V=1",
            "b=9.5 c=2.499 slow V=1",
            "b=11 c=1.9 slow K=1..1.1",
            "b=9 c=2.3 slow K=1..1.1",
            "b=9 c=3 slow L=0.1..0.2",
            "b=13 c=1.9999999999999 slow L=0.1..0.2",
        ],
    );
    assert_said(
        Truth::Depends,
        &[
            // What an enclosure never tells.
            "b=11 c=2 slow",
            "b=13 c=2 slow L=0.1..0.2",
            "b=9.5 c=2.5 slow V=1",
            // 9.5 + 0.499/V.
            "b=9.5 c=2.499 slow V=0.5..1",
            "b=11 c=2.1 slow K=1..1.1",
            "b=10 c=2.3 slow K=1..1.1",
            "b=11 c=3 slow L=0.1..0.2",
            // The first corner holds and the last fails; the last but never tells.
            "b=10.5 c=3 slow T=1..1.1",
            "b=11 c=1.9..2 slow",
        ],
    );
    // As near to the border as 64 bits do not tell.
    let tiny = BigRational::new(1.into(), num_bigint::BigInt::from(1) << 70);
    for (off, truth) in [(tiny.clone(), Truth::Holds), (-tiny, Truth::Fails)] {
        let (of, speeds) = asked("b=11 slow");
        let coulomb = Interval::point(to_wide(&(q(2, 1) + off)));
        let of = of.with(Parameter::Coulomb, coulomb);
        assert_eq!(of.truth(&speeds), Some(truth));
        assert_eq!(of.surely_holds(&speeds), truth == Truth::Holds);
    }
}

/// Of a pole that is too near to the unit circle nothing is known of ‖c‖₁, and so of the loop.
#[test]
fn th_lti_boxes_beside_a_controller_that_forgets_too_slowly() {
    let near = q(-9_999_999_999, 10_000_000_000);
    let controller = Controller::new([q(1, 1)], [q(1, 1), zero(), near]).unwrap();
    let (of, speeds) = asked("b=11 c=3");
    let of = Loop {
        controller: Some(Arc::new(controller)),
        ..of
    };
    assert_eq!(of.truth(&speeds), Some(Truth::Depends));
    assert!(!of.surely_holds(&speeds));
}

/// With the costs of the box at hand they may be enough, and else its corners are asked.
#[test]
fn th_lti_boxes_with_their_costs_at_hand() {
    for (line, truth) in [
        ("b=11 c=3 slow", Truth::Holds),
        ("b=11 c=2 slow", Truth::Depends),
        ("b=9 c=3 slow", Truth::Fails),
        ("b=11 c=2.3 slow K=1..1.1", Truth::Holds),
        ("b=11 c=2.1 slow K=1..1.1", Truth::Depends),
        ("b=12 c=3 slow L=0.1..0.2", Truth::Holds),
    ] {
        let (of, speeds) = asked(line);
        let with = of.with_costs(64).unwrap();
        let coulomb = with.coulomb_cost.clone().unwrap();
        assert!(
            *coulomb.lo() < to_wide(&q(2, 1)) && to_wide(&q(2, 1)) < *coulomb.hi(),
            "{line}"
        );
        assert_eq!(with.truth(&speeds), Some(truth), "{line}");
    }
    // Where they do not tell, more bits may.
    let tiny = BigRational::new(1.into(), num_bigint::BigInt::from(1) << 70);
    for (off, truth) in [(tiny.clone(), Truth::Holds), (-tiny, Truth::Fails)] {
        let (of, speeds) = asked("b=11 slow");
        let coulomb = Interval::point(to_wide(&(q(2, 1) + off)));
        let with = of.with(Parameter::Coulomb, coulomb).with_costs(64).unwrap();
        assert_eq!(with.decide(&speeds), Some(Truth::Depends));
        assert_eq!(with.truth(&speeds), Some(truth));
    }
    // Behind a latency the cells enclose to 40 bits only.
    let (late, speeds) = asked("b=13 slow L=0.1..0.2");
    let less = BigRational::new(1.into(), num_bigint::BigInt::from(1) << 60);
    let coulomb = Interval::point(to_wide(&(q(2, 1) - less)));
    let late = late.with(Parameter::Coulomb, coulomb);
    assert_eq!(late.truth(&speeds), Some(Truth::Depends));
    let (damped, _) = asked("b=11 k=1 B=0.5");
    assert_eq!(damped.with_costs(64).unwrap().coulomb_cost, None);
}

/// Behind a delay of one sample λ falls with B as 3/2 − B up to ¼, and rises in the end: ½ + B + 1/(8B).
#[test]
fn th_lti_boxes_are_hardest_at_either_end_of_the_damping() {
    assert_said(
        Truth::Holds,
        &["b=1.49 k=1 B=0.01..0.3", "b=1.5 k=1 B=0.01..0.8"],
    );
    assert_said(
        Truth::Depends,
        &[
            "b=1.3 k=1 B=0.01..0.3",
            "b=1.4 k=1 B=0.1..0.8",
            "b=1.4 k=1 B=0.11..0.9",
        ],
    );
    assert_said(Truth::Fails, &["b=1.2 k=1 B=0.01..0.3"]);
}

/// Of a bound of which the square is known: (b − λ)V + c − ½ − B ≥ 0 with λ = 5/4, so V² ≤ 4.
#[test]
fn th_start_boxes_up_to_a_square() {
    assert_said(
        Truth::Holds,
        &[
            "b=1 c=1.5 k=1 B=0.5 V²=4",
            "b=1 c=1.5 k=1 B=0.5 V²=1..4",
            "b=1 c=1.5 k=1 B=0.4..0.5 V²=3.9",
        ],
    );
    assert_said(
        Truth::Fails,
        &[
            "b=1 c=1.5 k=1 B=0.5 V²=4.0001",
            "b=1 c=1.5 k=1 B=0.4..0.5 V²=9",
        ],
    );
    assert_said(
        Truth::Depends,
        &[
            "b=1 c=1.5 k=1 B=0.5 V²=3..5",
            "b=1 c=1.5 k=1 B=0.4..0.5 V²=4.1",
        ],
    );
    // Two samples late with B = 2 λ is no fraction, and 64 bits do not tell that b is 2⁻¹⁰⁰ off from λ − ½.
    let late = ViscousCost::of(&Controller::damped(&q(2, 1)).unwrap().delayed(2));
    let tiny = BigRational::new(1.into(), num_bigint::BigInt::from(1) << 100);
    let lambda = late.enclosure(&(&tiny * &tiny));
    assert!(!lambda.is_point());
    for (viscous, truth) in [
        (lambda.hi() - half() + &tiny, Truth::Holds),
        (lambda.lo() - half() - &tiny, Truth::Fails),
    ] {
        let (of, speeds) = asked("c=3 k=2 B=2 V²=1");
        let of = of.with(Parameter::Viscous, Interval::point(to_wide(&viscous)));
        assert_eq!(of.truth(&speeds), Some(truth));
    }
}

/// Times and damping of the linear part are in periods and in KT: from the least over the most to the most
/// over the least.
#[test]
fn th_lti_boxes_in_units_of_their_loops() {
    let (of, _) = asked("b=1 K=1..2 T=2..4 B=1..2 τ=1..2 L=1..2 θ=3..5 k=1");
    let ends = |lo: BigRational, hi: BigRational| Interval::hull(lo, hi);
    let part = of.linear_part(64).unwrap();
    let Command::Spring { damping, pole } = &part.command else {
        panic!("no controller")
    };
    assert_eq!(*damping, ends(q(1, 8), q(1, 1)));
    // τ/(τ + T).
    assert_eq!(*pole, ends(q(1, 5), half()));
    let actuator = part.actuator.unwrap();
    assert_eq!(actuator.latency, ends(q(1, 4), q(1, 1)));
    assert_eq!(actuator.time_constant, ends(q(3, 4), q(5, 2)));
    assert_eq!((part.delay, part.linear), (1, true));
    // The same with a period of π: each end is enclosed, and the lower one below, the upper one above.
    let exact = |x: &BigRational| Exact::of(x);
    let with_pi = of.map(|parameter, range| {
        range.map(|x| {
            let x = exact(&passivity_core::rational::from_wide(x).unwrap());
            if parameter == Parameter::Period {
                x * pi()
            } else {
                x
            }
        })
    });
    let part = with_pi.linear_part(64).unwrap();
    let actuator = part.actuator.unwrap();
    let Command::Spring { damping, pole } = &part.command else {
        panic!("no controller")
    };
    let over_pi = |n: i64, d: i64| exact(&q(n, d)).over(pi());
    let at = |tau: i64, periods: i64| {
        exact(&q(tau, 1)).over(exact(&q(tau, 1)) + exact(&q(periods, 1)) * pi())
    };
    for (found, lo, hi) in [
        (damping, over_pi(1, 8), over_pi(1, 1)),
        (pole, at(1, 4), at(2, 2)),
        (&actuator.latency, over_pi(1, 4), over_pi(1, 1)),
        (&actuator.time_constant, over_pi(3, 4), over_pi(5, 2)),
    ] {
        let close = exact(&BigRational::new(
            1.into(),
            num_bigint::BigInt::from(1) << 60,
        ));
        let [below, above] = [
            lo.clone() - exact(found.lo()),
            exact(found.hi()) - hi.clone(),
        ];
        for off in [below, above] {
            assert!(Exact::zero() < off && off < close, "{found:?}");
        }
    }
}

/// With a period of π/3 and B = ½ behind a delay of one sample b has to be u/2 + B + u²/(8B), u = π/3: decided
/// to 10⁻³⁰, at every speed and up to V = 2.
#[test]
fn th_lti_boxes_with_pi_are_decided_at_the_border() {
    let u = &*PI / num_bigint::BigInt::from(3);
    let needed = &u * half() + half() + &u * &u * q(1, 4);
    let tiny = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(30));
    let of = |viscous: &BigRational, coulomb: &BigRational| {
        let number = |x: &BigRational| Exact::of(x);
        let of = Loop {
            viscous: Some(number(viscous)),
            coulomb: Some(number(coulomb)),
            damping: Some(number(&half())),
            delay: 1,
            ..Loop::new(Exact::one(), pi().over(Exact::integer(3)))
        };
        of.map(|_, x| Interval::point(x.clone()))
    };
    for (off, truth) in [(tiny.clone(), Truth::Holds), (-tiny.clone(), Truth::Fails)] {
        let at_all = of(&(&needed + &off), &q(1, 1));
        assert_eq!(at_all.truth(&Speeds::All), Some(truth));
        let two = Interval::point(Exact::integer(2));
        let up_to = of(&(&needed + &off - half()), &q(1, 1));
        assert_eq!(up_to.truth(&Speeds::UpTo(two.clone())), Some(truth));
        assert_eq!(
            up_to.surely_holds(&Speeds::UpTo(two)),
            truth == Truth::Holds
        );
    }
    // 3/2 − z⁻¹/2 costs KT, with no damping to be enclosed.
    let controller = Controller::new([q(3, 2), q(-1, 2)], [q(1, 1)]).unwrap();
    for (off, truth) in [(tiny.clone(), Truth::Holds), (-tiny, Truth::Fails)] {
        let at = Loop {
            damping: None,
            delay: 0,
            controller: Some(Arc::new(controller.clone())),
            ..of(&(&u + off), &q(1, 1))
        };
        assert_eq!(at.truth(&Speeds::All), Some(truth));
    }
    assert_eq!(pi().enclosed(64).map(|x| x.is_point()), Some(false));
}
