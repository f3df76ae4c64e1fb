//! TH-LTI, TH-LATENCY, TH-LAG: what the linear part of a loop costs over a box, by the formulas.

use std::sync::Arc;

use num_traits::ToPrimitive as _;
use passivity_core::actuator::Actuator;
use passivity_core::exponential::root;
use passivity_core::frequency::ViscousCost;
use passivity_core::linear_part::{Command, LinearPart, MOST_DEGREE};
use passivity_core::{BigRational, Interval};

use crate::common::{half, q, squared, zero};
use crate::transfer::Controller;

type Range = Interval<BigRational>;

fn point(x: BigRational) -> Range {
    Interval::point(x)
}

fn between(lo: BigRational, hi: BigRational) -> Range {
    Interval::hull(lo, hi)
}

fn spring(damping: Range, pole: Range, delay: u16) -> LinearPart {
    LinearPart {
        command: Command::Spring { damping, pole },
        delay,
        actuator: None,
        linear: true,
    }
}

fn controlled(taps: &[i64], delay: u16) -> LinearPart {
    let taps: Vec<BigRational> = taps.iter().map(|c| q(*c, 1)).collect();
    LinearPart {
        command: Command::Controller(Arc::new(Controller::new(taps, [q(1, 1)]).unwrap())),
        ..spring(point(zero()), point(zero()), delay)
    }
}

fn behind(part: LinearPart, latency: Range, time_constant: Range) -> LinearPart {
    LinearPart {
        actuator: Some(Actuator {
            latency,
            time_constant,
        }),
        ..part
    }
}

fn tiny() -> BigRational {
    q(1, 1 << 40)
}

/// ½ + B(1 − a)/(1 + a) and ½ + B(1 − a), with the least of B and the largest of a, and the other way.
#[test]
fn th_lti_linear_part_of_filtered_damping() {
    let part = spring(between(q(1, 1), q(2, 1)), between(zero(), half()), 0);
    let cost = part.cost(&tiny()).unwrap();
    assert_eq!(cost.viscous, between(q(5, 6), q(5, 2)));
    assert_eq!(cost.coulomb, between(q(1, 1), q(5, 2)));
    // Of an interval of β it is said for all of it and all of the box, or not at all.
    let decided = |lo: BigRational, hi: BigRational| part.decide(&between(lo, hi), &tiny());
    assert_eq!(decided(q(5, 2), q(3, 1)), Some(true));
    assert_eq!(decided(q(5, 2) - tiny(), q(3, 1)), None);
    assert_eq!(decided(zero(), q(5, 6)), None);
    assert_eq!(decided(zero(), q(5, 6) - tiny()), Some(false));
}

/// Behind a delay of one sample B = ½ costs 5/4, and a change of B by ¼ makes at most ¼; one of a by ¼ at
/// most 2B·¼/(1 − ½).
#[test]
fn th_lti_linear_part_is_off_by_no_more_than_its_tails() {
    let part = spring(between(q(1, 4), q(3, 4)), point(zero()), 1);
    assert_eq!(
        part.cost(&tiny()).unwrap().viscous,
        between(q(1, 1), q(3, 2))
    );
    let decided = |lo: BigRational, hi: BigRational| part.decide(&between(lo, hi), &tiny());
    assert_eq!(decided(q(3, 2), q(2, 1)), Some(true));
    assert_eq!(decided(q(3, 2) - tiny(), q(2, 1)), None);
    assert_eq!(decided(zero(), q(1, 1)), None);
    assert_eq!(decided(zero(), q(1, 1) - tiny()), Some(false));
    let part = spring(between(q(1, 1), q(2, 1)), between(zero(), half()), 1);
    let middle = Controller::filtered_damping(&q(3, 2), &q(1, 4)).unwrap();
    let middle = ViscousCost::of(&middle.delayed(1));
    assert_eq!(part.frequency_response(), Some(middle.clone()));
    let enclosed = middle.enclosure(&tiny());
    let off = half() + q(3, 1) / half() * q(1, 4);
    let cost = part.cost(&tiny()).unwrap().viscous;
    assert!(*cost.lo() >= enclosed.lo() - &off && *cost.hi() <= enclosed.hi() + &off);
    // It is in pieces: of every damping and every pole it has what they cost, and not much more.
    let mut costs = Vec::new();
    for (b, a) in (0..=4).flat_map(|b| (0..=16).map(move |a| (q(4 + b, 4), q(a, 32)))) {
        let one = spring(point(b), point(a), 1).cost(&tiny()).unwrap().viscous;
        assert!(cost.lo() <= one.lo() && one.hi() <= cost.hi());
        costs.push(one.hi().clone());
    }
    let most = costs.iter().max().unwrap();
    // Over a piece a changes by 1/16, and so u = a/(1 − a) by at most ¼: B·8·(Δu)²/8 with B = 2 is ⅛.
    assert!(*cost.hi() <= most + q(1, 8));
    // The figure of the middle, of a law that is linear and without an actuator only.
    let one_sided = LinearPart {
        linear: false,
        ..part.clone()
    };
    assert_eq!(one_sided.frequency_response(), None);
    let late = behind(part, point(half()), point(zero()));
    assert_eq!(late.frequency_response(), None);
}

/// H(1)(½ + k) + Σ|gⱼ| behind a one-sided wall, and beyond the degree that λ is decided with.
#[test]
fn th_law_linear_part_costs_its_absolute_tails() {
    let one_sided = |part: LinearPart| LinearPart {
        linear: false,
        ..part
    };
    let viscous = |part: &LinearPart| part.cost(&tiny()).unwrap().viscous;
    let damped = |delay| spring(point(half()), point(zero()), delay);
    assert_eq!(viscous(&one_sided(damped(1))), point(q(2, 1)));
    // 3 − z⁻¹: H(1) = 2, g₁ = −1; ½‖c‖₁ = 2 with any delay.
    let part = controlled(&[3, -1], 1);
    assert_eq!(viscous(&one_sided(part.clone())), point(q(4, 1)));
    assert_eq!(part.cost(&tiny()).unwrap().coulomb, point(q(2, 1)));
    assert_eq!(part.at_one(), q(2, 1));
    // The law 1 + ½(1 − z⁻¹) has two coefficients: with this delay as many as are decided exactly.
    let last = u16::try_from(MOST_DEGREE - 2).unwrap();
    let sum = |delay: u16| point(q(1, 1) + q(i64::from(delay), 1));
    assert!(viscous(&damped(last)).hi() < sum(last).lo());
    assert_eq!(viscous(&damped(last + 1)), sum(last + 1));
    // Without a delay the tails of a controller of too many coefficients.
    let long: Vec<i64> = (0..=24).map(|n| if n == 0 { 2 } else { n % 2 }).collect();
    let ones: i64 = (1..=24).map(|j| (j..=24).map(|n| n % 2).sum::<i64>()).sum();
    assert_eq!(
        viscous(&controlled(&long, 0)),
        point(q(2 + 12, 2) + q(ones, 1))
    );
}

/// κ = ½[(½ + m) + √((½ + m)² + Var)], H(1)κ + Σ|gⱼ|, decided exactly however coarse the enclosure is.
#[test]
fn th_latency_linear_part_is_decided_exactly() {
    let coarse = q(1, 1);
    let decided = |part: &LinearPart, beta: BigRational| part.decide(&point(beta), &coarse);
    let damped = |delay| spring(point(half()), point(zero()), delay);
    for (part, least) in [
        // One sample late, by the latency or by the delay: 3/2, and a damping of ½.
        (behind(damped(0), point(q(1, 1)), point(zero())), q(2, 1)),
        (behind(damped(1), point(q(1, 1)), point(zero())), q(3, 1)),
        (
            behind(controlled(&[3, -1], 0), point(q(1, 1)), point(zero())),
            q(4, 1),
        ),
        // H(1) = 0: only the tails are left.
        (
            behind(controlled(&[1, -1], 0), point(half()), point(zero())),
            q(1, 1),
        ),
        (
            behind(controlled(&[1, -1], 2), point(half()), point(q(1, 3))),
            q(1, 1),
        ),
    ] {
        assert_eq!(decided(&part, least.clone()), Some(true), "{part:?}");
        assert_eq!(
            decided(&part, least.clone() - tiny()),
            Some(false),
            "{part:?}"
        );
        let around = between(least.clone() - q(3, 1), least + q(3, 1));
        assert_eq!(part.decide(&around, &tiny()), None);
    }
    // A latency of 0.3: (2β − 0.8)² against 0.85, here at β = 43/50 and 431/500.
    let late = behind(
        spring(point(zero()), point(zero()), 0),
        point(q(3, 10)),
        point(zero()),
    );
    assert_eq!(decided(&late, q(43, 50)), Some(false));
    assert_eq!(decided(&late, q(431, 500)), Some(true));
    // The same law on one side only costs the same.
    let one_sided = LinearPart {
        linear: false,
        ..late
    };
    assert_eq!(decided(&one_sided, q(43, 50)), Some(false));
    assert_eq!(decided(&one_sided, q(431, 500)), Some(true));
}

/// Over a box the mean delay is at either end, and the variance that of the middle and off by as much as the
/// delays are wide.
#[test]
fn th_latency_linear_part_over_a_box() {
    let spring = spring(point(zero()), point(zero()), 1);
    let part = behind(spring.clone(), between(q(1, 5), q(2, 5)), point(zero()));
    let kappa = part.cost(&tiny()).unwrap().viscous;
    // 0.3·0.7 in the middle, and 0.2 more or less.
    let encloses = |x: &BigRational, mean: BigRational, variance: BigRational| {
        let least = &mean + half();
        // An enclosure as wide as was asked for holds κ.
        let root = |x: BigRational| squared(&(x * q(2, 1) - &least));
        let wanted = squared(&least) + variance;
        root(x - tiny()) <= wanted && wanted <= root(x + tiny())
    };
    assert!(encloses(kappa.lo(), q(6, 5), q(1, 100)), "{kappa:?}");
    assert!(encloses(kappa.hi(), q(7, 5), q(41, 100)), "{kappa:?}");
    // A point has no error; and both kinds of lateness add.
    let at = behind(spring.clone(), point(q(3, 10)), point(zero()));
    let at = at.cost(&tiny()).unwrap().viscous;
    assert!(encloses(at.lo(), q(13, 10), q(21, 100)) && encloses(at.hi(), q(13, 10), q(21, 100)));
    for (latency, lag) in [
        (between(zero(), q(1, 5)), between(q(3, 10), half())),
        (point(zero()), between(q(3, 10), half())),
        (between(zero(), q(1, 5)), point(q(2, 5))),
    ] {
        let part = behind(spring.clone(), latency.clone(), lag.clone());
        let kappa = part.cost(&tiny()).unwrap().viscous;
        let double = |x: &BigRational| x.to_f64().unwrap();
        let middle = Actuator {
            latency: latency.middle(),
            time_constant: lag.middle(),
        };
        let variance = double(middle.variance(128).lo());
        let wide = double(&(latency.hi() - latency.lo() + lag.hi() - lag.lo()));
        for (end, mean, off) in [
            (kappa.lo(), double(&(latency.lo() + lag.lo())), -wide),
            (kappa.hi(), double(&(latency.hi() + lag.hi())), wide),
        ] {
            let e = 1.5 + mean;
            let expected = 0.5 * (e + (e * e + (variance + off).max(0.0)).sqrt());
            // A few roundings of doubles below 4.
            assert!(
                (double(end) - expected).abs() < 1e-11,
                "{latency:?} {lag:?} {expected}"
            );
        }
    }
    // Damping is added end by end, and a controller's H(1) multiplies.
    let damped = behind(
        self::spring(between(q(1, 1), q(2, 1)), point(zero()), 0),
        point(q(1, 1)),
        point(zero()),
    );
    assert_eq!(
        damped.cost(&tiny()).unwrap().viscous,
        between(q(5, 2), q(7, 2))
    );
}

/// ½(1 + √(5/4)) for half a sample of latency: on either side of it by far less than the enclosure that was asked
/// for is wide.
#[test]
fn th_latency_linear_part_decides_points_exactly() {
    let wall = spring(point(zero()), point(zero()), 0);
    let late = behind(wall, point(half()), point(zero()));
    let root = root(&q(5, 4), 300);
    for (root, enough) in [(root.lo(), false), (root.hi(), true)] {
        let beta = (q(1, 1) + root) * half();
        assert_eq!(late.decide(&point(beta), &q(1, 1)), Some(enough));
    }
}
