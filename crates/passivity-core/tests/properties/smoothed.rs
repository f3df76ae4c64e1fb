//! TH-LATENCY, TH-LAG: latency and lag as a filter, and what its error covers.

use passivity_core::actuator::Actuator;
use passivity_core::exponential::decay;
use passivity_core::smoothed::{MOST_TERMS, Smoothed};
use passivity_core::{BigRational, Interval};
use proptest::prelude::*;

use crate::common::{magnitude, q, sampled, zero};

/// A range by its middle and radius.
fn about(x: &BigRational, off: &BigRational) -> Interval<BigRational> {
    Interval::hull(x - off, x + off)
}

fn smoothed(
    [latency, theta]: [&BigRational; 2],
    [by, by_theta]: [&BigRational; 2],
) -> Option<Smoothed> {
    Smoothed::of(&Actuator {
        latency: about(latency, by),
        time_constant: about(theta, by_theta),
    })
}

/// e^(−f/θ) and e^(−(1 − f)/θ) of a fraction f of a sample, to so many bits.
fn decays(fraction: &BigRational, theta: &BigRational, bits: u32) -> [BigRational; 2] {
    [fraction.clone(), q(1, 1) - fraction].map(|time| decay(&(time / theta), bits).middle())
}

/// Σ κᵢ for i ≥ j, j = 1, 2, … `count`, to some 2⁻¹²⁰: what is missing of a step after j samples.
///
/// After the first sample that it acts in the output is off by e₂, and by e₁e₂ times as much a sample later;
/// the mean over a sample is off by θ(1 − e₁e₂) times what the output is off by at its start.
fn missing_of_a_step(latency: &BigRational, theta: &BigRational, count: usize) -> Vec<BigRational> {
    let (f, one) = (latency - latency.floor(), q(1, 1));
    let late: usize = latency.floor().to_string().parse().unwrap();
    let grid = q(2, 1).pow(128);
    let rounded = |x: BigRational| (x * &grid).floor() / &grid;
    let [e1, e2] = if *theta == zero() {
        [zero(), zero()]
    } else {
        decays(&f, theta, 128).map(rounded)
    };
    let mut missing = vec![one.clone(); late];
    missing.push(f + theta * (&one - &e2));
    let e = rounded(e1 * &e2);
    let mut next = rounded(theta * (one - &e) * e2);
    while missing.len() < count {
        missing.push(next.clone());
        next = rounded(next * &e);
    }
    missing
}

sampled! {
    /// For a command that changes by at most 1 a sample the mean force is off by Σ |Σ κᵢ − Σ κ̂ᵢ| at
    /// most, sums over i ≥ j: the error covers it at every actuator of the tolerances.
    fn th_latency_th_lag_the_error_covers_every_actuator(
        latency in 8i64..40, theta in 0i64..30, off in 0i64..8, off_theta in 0i64..8,
        at in -4i64..5, at_theta in -4i64..5,
    ) {
        let (latency, theta) = (q(latency, 16), q(theta, 10));
        let (off, off_theta) = (q(off, 16), &theta * q(off_theta, 16));
        let found = smoothed([&latency, &theta], [&off, &off_theta]).unwrap();
        let sum = found.response.iter().fold(zero(), |sum, k| sum + k);
        prop_assert_eq!(&sum, &q(1, 1));
        let (at, at_theta) = (&latency + off * q(at, 4), &theta + off_theta * q(at_theta, 4));
        let count = found.response.len() + 240;
        let mut rest = sum;
        let mut off = zero();
        for (j, exact) in missing_of_a_step(&at, &at_theta, count).into_iter().enumerate() {
            if let Some(k) = found.response.get(j) {
                rest -= k;
            }
            off += magnitude(&(exact - &rest));
        }
        // What is left out of the sum is below 2⁻⁷⁰: 5·e^(−240/4.2), for time constants up to 4.2, and what
        // rounding to 2⁻¹²⁸ adds.
        prop_assert!(off <= &found.error + q(1, 2).pow(70));
    }
}

/// Both radii, 54·2⁻⁶⁴·θ/(1 − e₁e₂)³ for the decays, and at most 2⁻⁶⁴ for the response.
#[test]
fn th_lag_the_error_by_hand() {
    let unit = q(1, 2).pow(64);
    for (latency, theta) in [
        (q(1, 3), q(1, 1)),
        (q(9, 4), q(7, 2)),
        (zero(), q(5, 1)),
        (q(5, 2), q(1, 5)),
    ] {
        let found = smoothed([&latency, &theta], [&q(1, 10), &q(1, 100)]).unwrap();
        let [e1, e2] =
            decays(&(&latency - latency.floor()), &theta, 64).map(|e| (e / &unit).floor() * &unit);
        let left = q(1, 1) - e1 * e2;
        let known = q(11, 100) + q(54, 1) * &theta * &unit / left.pow(3);
        let response = found.error - known;
        assert!(response > zero() && response <= unit, "{latency} {theta}");
    }
    let exact = smoothed([&q(5, 4), &zero()], [&q(1, 10), &zero()]).unwrap();
    assert_eq!(exact.response, [zero(), q(3, 4), q(1, 4)]);
    assert_eq!(exact.error, q(1, 10));
}

#[test]
fn th_lag_long_responses_are_refused() {
    let of = |theta: i64| smoothed([&zero(), &q(theta, 1)], [&zero(), &zero()]);
    let length = of(8).unwrap().response.len();
    assert!(length > 300 && length <= MOST_TERMS);
    assert_eq!(of(30), None);
    let far = smoothed([&q(65_536, 1), &zero()], [&zero(), &zero()]);
    assert_eq!(far, None);
}
