//! The motion by its power series, where another closed form knows it.

use approx::assert_abs_diff_eq;

use super::*;
use crate::motion::Constants;

fn plain(mass: f64, beta: f64, sigma: f64) -> Flow<Double> {
    let mut flow = Flow {
        mass: Double(mass),
        beta: Double(beta),
        sigma: Some(Double(sigma)),
        rate: None,
        arm: None,
        pieces: 1,
        whole: OnceLock::new(),
    };
    flow.pieces = flow.pieces_needed().unwrap();
    flow
}

#[test]
fn without_amplifier_and_arm_it_is_the_closed_form() {
    for (mu, beta) in [(50.0, 0.6), (2.0, 1.0), (1.0, 30.0)] {
        let (flow, k) = (plain(mu, beta, 0.3), Constants::new(mu, beta, 0.3));
        for v in [-1.2, -0.01, 0.0, 0.004, 0.3] {
            for u in [-2.5, -0.5, 0.2, 1.5] {
                let start = State {
                    xi: 0.25,
                    velocity: v,
                    output: 0.0,
                };
                let got = flow.advance_doubles(&start, u, 0.0, true).unwrap();
                let want = k.advance::<true, true, true>(0.25, v, u);
                // A few ulp of the numbers at hand, all below 3, a piece.
                let tolerance = 1e-15 * f64::from(flow.pieces + 4);
                let close = |a: f64, b: f64| (a - b).abs() < tolerance;
                assert!(
                    close(got.end.xi, want.xi)
                        && close(got.end.velocity, want.velocity)
                        && close(got.path, want.path)
                        && close(got.square, want.square)
                        && close(got.work, u * (want.xi - 0.25)),
                    "μ {mu} v {v} u {u}: {got:?} {want:?}"
                );
            }
        }
    }
}

#[test]
fn a_swing_on_an_arm_is_a_cosine_and_loses_nothing() {
    let mut flow = plain(1.0, 0.0, 0.0);
    let omega: f64 = 7.0;
    flow.arm = Some([0.0, omega * omega].map(Double));
    flow.pieces = flow.pieces_needed().unwrap();
    for sigma in [None, Some(Double(0.0))] {
        flow.sigma = sigma;
        let start = State {
            xi: 1.0,
            velocity: 0.0,
            output: 0.0,
        };
        let got = flow.advance_doubles(&start, 0.0, 0.0, true).unwrap();
        assert_abs_diff_eq!(got.end.xi, omega.cos(), epsilon = 1e-14);
        assert_abs_diff_eq!(got.end.velocity, -omega * omega.sin(), epsilon = 1e-13);
        // ∫ω² sin²(ωt) dt over the interval.
        let square = omega * omega * (0.5 - (2.0 * omega).sin() / (4.0 * omega));
        assert_abs_diff_eq!(got.square, square, epsilon = 1e-12);
    }
}

#[test]
fn coulomb_friction_takes_two_sigma_from_each_half_swing() {
    // ω = 2π, k = 1 ⇒ the turning points of a free swing lose 2σ/k each half period.
    let omega = 2.0 * std::f64::consts::PI;
    let mut flow = plain(1.0 / (omega * omega), 0.0, 0.125);
    flow.arm = Some([0.0, 1.0].map(Double));
    flow.pieces = flow.pieces_needed().unwrap();
    let start = State {
        xi: 2.0,
        velocity: 0.0,
        output: 0.0,
    };
    let got = flow.advance_doubles(&start, 0.0, 0.0, true).unwrap();
    assert_abs_diff_eq!(got.end.xi, 1.5, epsilon = 1e-13);
    assert_abs_diff_eq!(got.path, 7.0, epsilon = 1e-13);
}

#[test]
fn an_amplifier_lets_go_when_its_output_passes_friction() {
    let mut flow = plain(1.0, 0.0, 0.5);
    flow.rate = Some(Double(2.0));
    flow.pieces = flow.pieces_needed().unwrap();
    let start = State {
        xi: 0.0,
        velocity: 0.0,
        output: 0.0,
    };
    let got = flow.advance_doubles(&start, 1.0, 0.0, true).unwrap();
    // y = 1 − e^(−2t) passes ½ at t₀ = ln 2/2; then v = ∫(y − ½) = (t − t₀)/2 − (½ − e^(−2t))/2.
    let (t0, e) = (0.5 * 2.0_f64.ln(), (-2.0_f64).exp());
    let velocity = 0.5 * (1.0 - t0) - 0.5 * (0.5 - e);
    assert_abs_diff_eq!(got.end.velocity, velocity, epsilon = 1e-14);
    assert_abs_diff_eq!(got.end.output, 1.0 - e, epsilon = 1e-15);
}

#[test]
fn too_fast_an_amplifier_is_refused() {
    let mut flow = plain(1.0, 0.0, 0.5);
    flow.rate = Some(Double(5000.0));
    assert_eq!(
        flow.pieces_needed(),
        Err(SimError::TooFast {
            rate: 5000.0,
            limit: FASTEST
        })
    );
}

/// Every kind of flow: amplifier, arm, both; slow, fast, damped, springy; with and without friction.
fn flows() -> Vec<Flow<Double>> {
    let mut flows = Vec::new();
    for (mass, beta) in [(50.0, 0.6), (2.0, 1.0), (1.0, 5.0), (40.0, 0.0)] {
        for sigma in [None, Some(0.0), Some(0.3)] {
            for rate in [None, Some(0.5), Some(2.0), Some(5.0), Some(40.0)] {
                for arm in [None, Some([0.2, 2.0]), Some([0.0, 0.1]), Some([1.0, 30.0])] {
                    let mut flow = plain(mass, beta, 0.0);
                    flow.sigma = sigma.map(Double);
                    flow.rate = rate.map(Double);
                    flow.arm = arm.map(|arm| arm.map(Double));
                    flow.pieces = flow.pieces_needed().unwrap();
                    flows.push(flow);
                }
            }
        }
    }
    flows
}

#[test]
fn propagators_lead_where_the_series_of_the_interval_leads() {
    let (mut straight, mut events, mut careful) = (0_u32, 0_u32, 0_u32);
    for flow in flows() {
        let fast = Fast::new(&flow).with_ledger();
        for velocity in [-1.2, -0.05, -0.01, -1e-3, 0.0, 0.004, 0.02, 0.3] {
            for output in [-2.5, -0.31, -0.2, 0.1, 0.5, 1.5] {
                for command in [-2.5, -0.5, 0.31, 1.5] {
                    let start = State {
                        xi: 0.25,
                        velocity,
                        output,
                    };
                    let want = flow.advance_doubles(&start, command, 0.0, true).unwrap();
                    let got = fast.advance::<true>(&start, command, 0.0).unwrap();
                    let end = fast.advance::<false>(&start, command, 0.0).unwrap().end;
                    assert_eq!(end, got.end, "the ledger changes nothing");
                    match fast.straight::<true, true, false>(&start, command, 0.0) {
                        Ok(_) => straight += 1,
                        Err(attempt) => {
                            let decided =
                                fast.decide::<LONG, true, true, false>(&start, command, &attempt);
                            events += u32::from(decided.is_some());
                            careful += u32::from(decided.is_none());
                        }
                    }
                    // A dozen roundings of numbers below 4 in each piece, and in what a map is made of.
                    let tolerance = 12.0 * 4.0 * f64::EPSILON * f64::from(flow.pieces + 4);
                    let close = |a: f64, b: f64| (a - b).abs() < tolerance;
                    assert!(
                        close(got.end.xi, want.end.xi)
                            && close(got.end.velocity, want.end.velocity)
                            && close(got.end.output, want.end.output)
                            && (flow.sigma.is_none() || close(got.path, want.path))
                            && close(got.square, want.square)
                            && close(got.work, want.work),
                        "{flow:?} {start:?} {command}: {got:?} {want:?}"
                    );
                }
            }
        }
    }
    // Each way over an interval is gone, and the careful one is the rarest.
    assert!(straight > events && events > careful && careful > 0);
}
