//! TH-LATENCY, TH-LAG: what late force costs.

use num_traits::ToPrimitive as _;
use passivity_core::actuator::{Actuator, spare};
use passivity_core::exponential::{decay, root};
use passivity_core::{BigRational, Interval};
use proptest::prelude::*;

use crate::common::{coefficient, half, q, sampled, squared, zero};

fn actuator(latency: BigRational, time_constant: BigRational) -> Actuator<BigRational> {
    Actuator {
        latency,
        time_constant,
    }
}

fn double(x: &BigRational) -> f64 {
    x.to_f64().unwrap()
}

/// κ by its formula, in doubles.
fn kappa(mean: f64, variance: f64) -> f64 {
    let e = 0.5 + mean;
    0.5 * (e + (e * e + variance).sqrt())
}

/// The variance of G(t) = Σ P(s > t + n), integrated over the phases in doubles, and how far off it is at
/// most.
///
/// G ≤ B = L + 1 + 1/(1 − e^(−1/θ)), |G′| ≤ M = 1/θ/(1 − e^(−1/θ)) and |G″| ≤ M/θ, but at the one phase
/// where the latency ends, where G bends. The midpoint rule with steps of h is off by h²/24 of the second
/// derivative and, where it bends, by h²/4 of the first.
fn integrated(latency: f64, theta: f64) -> (f64, f64) {
    let survival = |s: f64| {
        if s < latency {
            1.0
        } else {
            (-(s - latency) / theta).exp()
        }
    };
    let late = |t: f64| (0..400).map(|n| survival(t + f64::from(n))).sum::<f64>();
    // The terms that are left out are below e^(−39).
    const STEPS: i32 = 4000;
    let phases = (0..STEPS).map(|i| late((f64::from(i) + 0.5) / f64::from(STEPS)));
    let (sum, squares) = phases.fold((0.0, 0.0), |(sum, squares), g| (sum + g, squares + g * g));
    let mean = sum / f64::from(STEPS);
    let h = 1.0 / f64::from(STEPS);
    let share = 1.0 / (1.0 - (-1.0 / theta).exp());
    let (most, slope) = (latency + 1.0 + share, share / theta);
    let bend = slope / theta;
    // As many roundings as steps, each of a sum of as many terms.
    let rounding = f64::from(STEPS) * f64::EPSILON;
    let of_mean = h * h * (bend / 24.0 + slope / 4.0) + rounding * most;
    let of_squares = (slope * slope + most * bend) / 12.0 + most * slope / 2.0;
    let of_squares = h * h * of_squares + rounding * most * most;
    assert!((mean - latency - theta).abs() < of_mean);
    let off = of_squares + (2.0 * mean + of_mean) * of_mean;
    (squares / f64::from(STEPS) - mean * mean, off)
}

sampled! {
    /// The decision without roots is that of the formula with its root.
    fn th_latency_decision(s in 0i64..60, beta in 0i64..200) {
        let (s, beta) = (q(s, 12), q(beta, 32));
        let fraction = &s - s.floor();
        let variance = &fraction * (q(1, 1) - &fraction);
        let late = actuator(s.clone(), zero());
        // β ≥ ½(e + √(e² + Var)) iff 2β − e ≥ 0 and its square is enough.
        let e = half() + &s;
        let over = q(2, 1) * &beta - &e;
        let by_squares = over >= zero() && squared(&over) >= squared(&e) + &variance;
        prop_assert_eq!(late.decide(&beta), Some(by_squares));
        let spares = spare(&beta, &s, &variance);
        prop_assert_eq!(spares.iter().all(|x| *x >= zero()), by_squares);
    }

    /// What is printed encloses the border of the decision.
    fn th_latency_enclosure(s in 0i64..60) {
        let late = actuator(q(s, 12), zero());
        let cost = late.cost(&q(1, 1_000_000)).unwrap();
        prop_assert_eq!(late.decide(cost.hi()), Some(true));
        let below = cost.lo() - q(1, 1_000_000_000);
        prop_assert_eq!(late.decide(&below), Some(false));
    }

    fn th_lag_decision(theta in 1i64..200, beta in coefficient()) {
        let slow = actuator(zero(), q(theta, 40));
        let cost = slow.cost(&q(1, 1_000_000)).unwrap();
        if beta >= *cost.hi() {
            prop_assert_eq!(slow.decide(&beta), Some(true));
        }
        if beta < *cost.lo() {
            prop_assert_eq!(slow.decide(&beta), Some(false));
        }
        // Doubles: the variance is the difference of two numbers below 26 of some four roundings each, 200ε at most, and
        // κ is off by half of that and by its own few. The enclosure is 10⁻⁶ wide at most.
        let t = double(&slow.time_constant);
        let variance = t / 2.0 / (1.0 / (2.0 * t)).tanh() - t * t;
        let off = (double(cost.lo()) - kappa(t, variance)).abs();
        prop_assert!(off < 1e-6 + 200.0 * f64::EPSILON);
        // The simple bound is above it.
        let simple = kappa(t, double(&slow.variance_bound()));
        prop_assert!(simple >= double(cost.lo()));
    }

    fn th_lag_variance_within_its_bounds(latency in 0i64..40, theta in 0i64..4000) {
        let late = actuator(q(latency, 12), q(theta, 500));
        let [coarse, fine] = [64, 256].map(|bits| late.variance(bits));
        prop_assert!(coarse.lo() <= fine.lo() && fine.hi() <= coarse.hi());
        prop_assert!(*fine.lo() >= zero() && *fine.hi() <= late.variance_bound());
        prop_assert!(double(&(fine.hi() - fine.lo())) < 1e-30);
    }
}

#[test]
fn th_latency_and_th_lag_together() {
    for (latency, theta) in [(0, 1), (3, 1), (3, 4), (7, 10), (12, 5), (25, 13), (6, 100)] {
        let late = actuator(q(latency, 10), q(theta, 10));
        let variance = late.variance(64);
        let (by_integral, off) = integrated(
            f64::from(latency as i32) / 10.0,
            f64::from(theta as i32) / 10.0,
        );
        let (lo, hi) = (double(variance.lo()), double(variance.hi()));
        assert!(
            (lo - by_integral).abs() < off && off < 1e-5,
            "{latency} {theta}: {lo} {by_integral} {off}"
        );
        assert!(hi - lo < 1e-12);
    }
}

#[test]
fn th_latency_figures() {
    let cost = |s| actuator(s, zero()).cost(&q(1, 1_000_000)).unwrap();
    assert!((double(cost(q(3, 10)).lo()) - 0.8610).abs() < 5e-5);
    assert!((double(cost(q(3, 10)).lo()) - 0.5 * (0.8 + 0.85_f64.sqrt())).abs() < 2e-6);
    // Whole samples are a delay: ½ + k, exactly.
    for k in 0..5 {
        assert_eq!(cost(q(k, 1)), Interval::point(half() + q(k, 1)));
        assert_eq!(
            actuator(q(k, 1), zero()).decide(&(half() + q(k, 1))),
            Some(true)
        );
    }
}

#[test]
fn th_lag_figures() {
    let cost = |theta| actuator(zero(), theta).cost(&q(1, 1_000_000)).unwrap();
    assert!((double(cost(q(1, 5)).lo()) - 0.7213).abs() < 5e-5);
    assert!((double(cost(q(1, 1)).lo()) - 1.5135).abs() < 5e-5);
    let simple = actuator(zero(), q(1, 5)).variance_bound();
    assert_eq!(simple, q(1, 12));
    assert!((kappa(0.2, double(&simple)) - 0.7286).abs() < 5e-5);
    // Very fast and very slow lags are decided as well.
    let fast = actuator(zero(), q(1, 1_000_000_000));
    assert_eq!(fast.decide(&(half() + q(1, 100_000))), Some(true));
    assert_eq!(fast.decide(&half()), Some(false));
    let slow = actuator(zero(), q(1_000_000, 1));
    assert_eq!(slow.decide(&q(1_000_001, 1)), Some(true));
    assert_eq!(slow.decide(&(q(1_000_000, 1) + half())), Some(false));
}

#[test]
fn th_lag_exponentials_and_roots() {
    for (n, d) in [(0, 1), (1, 1000), (1, 2), (1, 1), (7, 3), (50, 1), (100, 1)] {
        let e = decay(&q(n, d), 80);
        let exact = (-(n as f64) / d as f64).exp();
        assert!((double(e.lo()) - exact).abs() < 1e-14 && e.lo() <= e.hi());
        let tighter = decay(&q(n, d), 300);
        assert!(e.lo() <= tighter.hi() && tighter.lo() <= e.hi());
        let root = root(&q(n, d), 80);
        assert!(squared(root.lo()) <= q(n, d) && q(n, d) <= squared(root.hi()));
    }
}

/// f(1 − f) and the lesser of ½θ and 1/12.
#[test]
fn th_lag_simple_bound_by_hand() {
    for (theta, bound) in [
        (q(1, 24), q(1, 48)),
        (q(1, 6), q(1, 12)),
        (q(2, 1), q(1, 12)),
    ] {
        assert_eq!(actuator(zero(), theta.clone()).variance_bound(), bound);
        let late = actuator(q(5, 4), theta);
        assert_eq!(late.variance_bound(), q(3, 16) + bound);
    }
}

/// So slow a lag that e^(−1/θ) is 1 to the bits that are computed.
#[test]
fn th_lag_variance_of_a_lag_without_end() {
    let slow = actuator(half(), q(1 << 60, 1) * q(1 << 60, 1));
    let widest = Interval::hull(zero(), q(1, 4) + q(1, 12));
    assert_eq!(slow.variance(64), widest);
}

/// Beside κ the first enclosure does not tell, and a tighter one does; and one that is tighter is within one
/// that is not.
#[test]
fn th_lag_decisions_beside_the_border() {
    for (latency, theta) in [
        (zero(), q(1, 2)),
        (q(7, 10), q(1, 3)),
        (q(1, 3), q(3, 1)),
        (zero(), q(1_000_000, 1)),
        (q(1, 3), q(1_000_000, 1)),
    ] {
        let late = actuator(latency, theta);
        let little = squared(&squared(&squared(&q(1, 1 << 40))));
        let close = late.cost(&little).unwrap();
        assert_eq!(late.decide(close.hi()), Some(true));
        assert_eq!(late.decide(close.lo()), Some(false));
        let coarse = late.cost(&q(1, 1)).unwrap();
        assert!(coarse.lo() <= close.lo() && close.hi() <= coarse.hi());
    }
}

/// An enclosure to few bits holds one to many.
#[test]
fn th_lag_variances_hold_tighter_ones() {
    for n in 1..24 {
        for f in 1..12 {
            let late = actuator(q(f, 12), q(n, 12));
            let [coarse, fine] = [1, 64].map(|bits| late.variance(bits));
            assert!(
                coarse.lo() <= fine.lo() && fine.hi() <= coarse.hi(),
                "{n} {f}"
            );
        }
    }
}
