//! TH-LTI: the least viscous friction that is enough at every frequency.

use num_traits::ToPrimitive as _;
use passivity_core::frequency::ViscousCost;
use passivity_core::sturm::SignOver;
use passivity_core::{BigRational, Interval, absolute_sum};
use proptest::prelude::*;

use crate::common::{half, magnitude, q, sampled, squared, zero};
use crate::transfer::{Controller, controller, finite_controller, response};

fn damped(damping: BigRational) -> Controller {
    Controller::damped(&damping).unwrap()
}

/// λ(θ) by the form of Colgate and Schenkel, in doubles.
fn colgate_schenkel([numerator, denominator]: &[Vec<f64>; 2], theta: f64) -> f64 {
    let sum = |coefficients: &[f64]| {
        coefficients
            .iter()
            .enumerate()
            .fold((0.0, 0.0), |(re, im), (j, c)| {
                let angle = theta * j as f64;
                (re + c * angle.cos(), im - c * angle.sin())
            })
    };
    let (nr, ni) = sum(numerator);
    let (dr, di) = sum(denominator);
    let size = dr * dr + di * di;
    let (hr, hi) = ((nr * dr + ni * di) / size, (ni * dr - nr * di) / size);
    // Re[(1 − e^(−iθ))H]
    let real = (1.0 - theta.cos()) * hr - theta.sin() * hi;
    real / (2.0 * (1.0 - theta.cos()))
}

fn billionth() -> BigRational {
    q(1, 1_000_000_000)
}

sampled! {
    /// Where λ(θ) ≥ β over a range of cosines, it is so on a grid of it.
    fn th_lti_cost_is_at_least_over_a_range(
        controller in controller(), ends in prop::array::uniform2(-8i64..9), beta in -12i64..13,
    ) {
        let cost = ViscousCost::of(&controller);
        let [lo, hi] = [ends.iter().min(), ends.iter().max()].map(|n| q(*n.unwrap(), 8));
        let range = Interval::hull(lo.clone(), hi.clone());
        let beta = cost.at(&((&lo + &hi) * half())) + q(beta, 8);
        let grid = (0..=64).map(|n| &lo + (&hi - &lo) * q(n, 64));
        let least = grid.map(|x| cost.at(&x)).min().unwrap();
        let said = cost.is_at_least(&beta, &range);
        prop_assert!(!said || least >= beta);
        if range.is_point() {
            prop_assert_eq!(said, least >= beta);
        }
    }

    /// The enclosure is within 10⁻⁹ of the largest value on a fine grid, and never below it.
    fn th_lti_cost_is_the_largest_on_a_grid(controller in controller()) {
        let cost = ViscousCost::of(&controller);
        let enclosure = cost.enclosure(&billionth());
        prop_assert!(enclosure.hi() - enclosure.lo() <= billionth());
        // A grid, and a finer one about its best point.
        let doubles = [controller.numerator(), controller.denominator()]
            .map(|side| side.iter().map(|c| c.to_f64().unwrap()).collect());
        let at = |theta: f64| colgate_schenkel(&doubles, theta);
        let mut span = (1e-3, std::f64::consts::PI);
        let mut best = f64::MIN;
        for _ in 0..3 {
            let step = (span.1 - span.0) / 2000.0;
            let grid = (0..=2000).map(|n| span.0 + step * f64::from(n));
            let (value, theta) = grid.map(|theta| (at(theta), theta))
                .max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            best = best.max(value);
            span = ((theta - step).max(1e-3), (theta + step).min(std::f64::consts::PI));
        }
        let at_zero = cost.at(&q(1, 1)).to_f64().unwrap();
        let best = best.max(at_zero);
        let scale = 1.0 + best.abs();
        let (lo, hi) = (enclosure.lo().to_f64().unwrap(), enclosure.hi().to_f64().unwrap());
        prop_assert!(hi >= best - 1e-9 * scale, "{} below {}", hi, best);
        // Towards θ = 0 the grid ends at 10⁻³.
        prop_assert!(lo <= best + 1e-7 * scale, "{} above {}", lo, best);
    }

    /// R/Q is ½H(1) + Σ gⱼ cos jθ, exactly, at angles whose cosine is rational.
    fn th_lti_cost_is_the_sum_of_tails(controller in finite_controller(), n in -12i64..13) {
        let x = q(n, 12);
        let mut expected = controller.at_one() * half();
        let (mut before, mut cosine) = (q(1, 1), x.clone());
        for g in controller.tail_sums(8) {
            expected += g * &cosine;
            let next = q(2, 1) * &x * &cosine - before;
            before = std::mem::replace(&mut cosine, next);
        }
        prop_assert_eq!(ViscousCost::of(&controller).at(&x), expected);
    }

    /// The ends of the enclosure are decided: enough above, too little below, with what shows it.
    fn th_lti_both_sides_of_the_border(controller in controller()) {
        let cost = ViscousCost::of(&controller);
        let enclosure = cost.enclosure(&q(1, 1000));
        let tiny = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(30));
        let beside = if enclosure.is_point() { tiny } else { zero() };
        match cost.decide(enclosure.hi()) {
            SignOver::Nonnegative(certificate) => {
                let everywhere = Interval::hull(q(-1, 1), q(1, 1));
                prop_assert!(certificate.shows(&cost.spare(enclosure.hi()), &everywhere));
            }
            SignOver::NegativeAt(x) => prop_assert!(false, "short at {}", x),
        }
        let too_little = enclosure.lo() - beside;
        // The quick answer is the same, on both sides, near and far.
        for beta in [enclosure.hi() + q(1, 1), enclosure.hi().clone(), too_little.clone(), enclosure.lo() - q(1, 1)] {
            prop_assert_eq!(cost.is_enough(&beta), cost.decide(&beta).is_nonnegative());
        }
        match cost.decide(&too_little) {
            SignOver::Nonnegative(_) => prop_assert!(false, "{} is enough", too_little),
            SignOver::NegativeAt(x) => prop_assert!(cost.at(&x) > too_little),
        }
        // Wherever it is worst, it is so within the width.
        let worst = cost.worst(&q(1, 100));
        prop_assert!(!worst.is_empty());
    }

    /// No motion draws more than the storage at the start from a loop that meets the criterion.
    fn th_lti_no_motion_draws_from_a_passive_loop(
        controller in controller(),
        start in -40i64..40,
        steps in prop::collection::vec((-30i64..31, 1i64..9), 1..60),
        seed in 0usize..4,
    ) {
        let width = q(1, 1_000_000);
        let beta = ViscousCost::of(&controller).enclosure(&width).hi().clone();
        let sigma = absolute_sum::enclosure(&controller, &width).unwrap().hi() * half();
        // Motions of one kind: any; steady; to and fro across edges; nearly of one frequency.
        let steps: Vec<BigRational> = steps.iter().enumerate().map(|(h, (n, d))| match seed {
            0 => q(*n, *d),
            1 => q(5, 1),
            2 => q(if h % 2 == 0 { 1 } else { -1 }, *d),
            _ => q((10.0 * (h as f64 * f64::from(*d as i32) / 4.0).cos()).round() as i64, 1),
        }).collect();
        let mut xi = q(start, 16);
        let stored = controller.at_one() * half() * squared(&xi);
        let c = response(&controller, steps.len());
        let rest = xi.floor() + half();
        let mut measured: Vec<BigRational> = Vec::new();
        let mut known = zero();
        let mut drawn = zero();
        for (h, d) in steps.iter().enumerate() {
            measured.push(xi.floor() + half());
            known += &c[h];
            // Before the start it rested for ever: what is left of the response acts on that.
            let mut force = -((controller.at_one() - &known) * &rest);
            for (c, q) in c.iter().zip(measured.iter().rev()) {
                force -= c * q;
            }
            drawn += force * d - &beta * squared(d) - &sigma * magnitude(d);
            prop_assert!(drawn <= stored);
            xi += d;
        }
    }
}

/// A delay of one sample: λ = ½ + cos θ.
#[test]
fn th_lti_cost_is_at_least_by_hand() {
    let cost = ViscousCost::of(&Controller::wall().delayed(1));
    let over = |lo: i64, hi: i64| Interval::hull(q(lo, 4), q(hi, 4));
    for (beta, range, reached) in [
        (q(3, 4), over(1, 3), true),
        (q(3, 4) + billionth(), over(1, 3), false),
        (q(3, 4), over(1, 1), true),
        (q(3, 4) + billionth(), over(1, 1), false),
        (q(-1, 2), over(-4, 4), true),
        (q(5, 4), over(-4, 4), false),
    ] {
        assert_eq!(
            cost.is_at_least(&beta, &range),
            reached,
            "{beta} over {range:?}"
        );
    }
    // 1/(2 − z⁻¹) at half the sampling rate: ½H(−1) = 1/6; at a quarter: ½·Re[(1 + i)/(2 + i)] = 3/10.
    let cost = ViscousCost::of(&Controller::new([q(1, 1)], [q(2, 1), q(-1, 1)]).unwrap());
    for (beta, cosine) in [(q(1, 6), -4), (q(3, 10), 0)] {
        assert!(cost.is_at_least(&beta, &over(cosine, cosine)));
        assert!(!cost.is_at_least(&(beta + billionth()), &over(cosine, cosine)));
    }
}

#[test]
fn th_lti_figures() {
    let exactly = |controller: &Controller| {
        let enclosure = ViscousCost::of(controller).enclosure(&q(1, 1_000_000));
        assert!(enclosure.is_point());
        enclosure.lo().clone()
    };
    assert_eq!(exactly(&Controller::wall()), half());
    for k in 0..5 {
        assert_eq!(
            exactly(&Controller::wall().delayed(k)),
            half() + q(i64::from(k), 1)
        );
        // Undelayed damping costs all of B.
        assert_eq!(
            exactly(&damped(q(i64::from(k), 3))),
            half() + q(i64::from(k), 3)
        );
    }
    // Largest at θ = π: met there exactly, however long the fraction is.
    let long = q(1_234_567_891_011, 1_000_000_007);
    assert_eq!(exactly(&damped(long.clone())), half() + long);
    assert_eq!(exactly(&damped(half()).delayed(1)), q(5, 4));
    assert_eq!(exactly(&damped(q(2, 1)).delayed(1)), q(41, 16));
    // B(1 − a)/(1 + a) instead of B.
    let filtered = |b: BigRational, a: BigRational| Controller::filtered_damping(&b, &a).unwrap();
    assert_eq!(exactly(&filtered(q(1, 1), half())), q(5, 6));
    let slow = exactly(&filtered(q(10, 1), q(19, 20)));
    assert_eq!(slow, half() + q(10, 39));
    assert!(slow > q(756, 1000) && slow < q(757, 1000));

    // 10⁻³⁰ less is short, exactly at the angle 60°.
    let late = ViscousCost::of(&damped(half()).delayed(1));
    let less = q(5, 4) - BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(30));
    assert!(late.decide(&q(5, 4)).is_nonnegative());
    let SignOver::NegativeAt(x) = late.decide(&less) else {
        panic!("10⁻³⁰ less is enough")
    };
    assert!(magnitude(&(x - half())) < q(1, 1_000_000));
    assert_eq!(late.worst(&q(1, 1000)), [Interval::point(half())]);
    // The plain wall is the same at every frequency.
    let flat = ViscousCost::of(&Controller::wall()).worst(&q(1, 1000));
    assert_eq!(flat, [Interval::hull(q(-1, 1), q(1, 1))]);
}

/// Wherever λ is a short fraction it is met exactly, at whatever angle: ½ + B + 1/(8B) at cos θ = 1/(4B)
/// behind a delay of one sample, and the value at θ = 0 however long it is.
#[test]
fn th_lti_short_costs_are_met_exactly() {
    let width = q(1, 1_000_000_000);
    for (n, d) in [
        (1, 3),
        (2, 5),
        (3, 4),
        (5, 7),
        (7, 5),
        (11, 4),
        (8, 9),
        (13, 6),
        (9, 2),
        (17, 12),
    ] {
        let b = q(n, d);
        let cost = ViscousCost::of(&damped(b.clone()).delayed(1));
        let lambda = half() + &b + q(1, 8) / &b;
        assert_eq!(cost.enclosure(&width), Interval::point(lambda), "{b}");
        assert_eq!(cost.at(&(q(1, 4) / &b)), half() + &b + q(1, 8) / &b);
    }
    // Of taps 1 and c the largest value, at θ = 0, is ½(1 + c) + c.
    let long = q(1_234_567_891_011, 1_000_000_007);
    let taps = Controller::new([q(1, 1), long.clone()], [q(1, 1)]).unwrap();
    let expected = half() + long * q(3, 2);
    assert_eq!(
        ViscousCost::of(&taps).enclosure(&width),
        Interval::point(expected)
    );
}

/// Where it is no fraction both ends are within the width, and one is short, the other enough.
#[test]
fn th_lti_irrational_costs_are_enclosed() {
    for (b, delay) in [
        (q(2, 1), 2),
        (q(3, 2), 2),
        (q(5, 1), 3),
        (q(100, 1), 2),
        (q(10_000, 1), 3),
    ] {
        let cost = ViscousCost::of(&damped(b.clone()).delayed(delay));
        for digits in [0, 1, 5, 12, 40] {
            let width = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(digits));
            let found = cost.enclosure(&width);
            assert!(
                !found.is_point() && found.hi() - found.lo() <= width,
                "{b} {digits}"
            );
            assert!(
                cost.decide(found.hi()).is_nonnegative()
                    && !cost.decide(found.lo()).is_nonnegative()
            );
        }
    }
}

/// Wider than 1, too, an enclosure is as wide as was asked for at most, with both ends decided.
#[test]
fn th_lti_costs_are_enclosed_in_wide_intervals() {
    for width in [q(5, 1), q(64, 1), q(1000, 1)] {
        let cost = ViscousCost::of(&damped(q(10_000, 1)).delayed(3));
        let found = cost.enclosure(&width);
        assert!(!found.is_point() && found.hi() - found.lo() <= width);
        assert!(cost.is_enough(found.hi()) && !cost.is_enough(found.lo()));
    }
}
