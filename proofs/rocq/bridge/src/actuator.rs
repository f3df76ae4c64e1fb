//! Latency, lag and filtered damping (TH-LATENCY, TH-LAG, TH-LTI).

use std::collections::VecDeque;

use passivity_core::Scalar as _;
use passivity_core::actuator::{Actuator, lag_variance, shared_variance, spare};
use passivity_core::controller::Filter;
use passivity_core::linear_part::filtered_cost;
use passivity_terms::Term;

use crate::formula::Formula;
use crate::plain::var;

/// What the formulas are compared with, beside `Definitions.v`.
pub(crate) const REQUIRED: &str = "ActuatorTactics ActuatorCost OnePole LagForm LateLag";

pub(crate) fn formulas() -> Vec<Formula> {
    let mut all = actuators();
    all.extend(filters());
    all
}

fn actuators() -> Vec<Formula> {
    let late = Actuator {
        latency: var("s"),
        time_constant: var("theta"),
    };
    let [over, square] = spare(&var("beta"), &var("m"), &var("Var"));
    let of_lag = lag_variance(&var("theta"), &var("e"));
    let shared = shared_variance(&var("theta"), &var("f"), &var("power"), &var("e"));
    let whole = var("f") * (Term::integer(1) - var("f")) + of_lag.clone() + shared;
    vec![
        Formula::new(
            "actuator::spare",
            &["beta", "m", "Var"],
            over,
            "spare_mean beta m",
        )
        .named("spare_mean")
        .by("bridge_actuator"),
        Formula::new(
            "actuator::spare",
            &["beta", "m", "Var"],
            square,
            "spare_square beta m Var",
        )
        .named("spare_square")
        .by("bridge_actuator"),
        Formula::new(
            "Actuator::mean_delay",
            &["s", "theta"],
            late.mean_delay(),
            "s + theta",
        ),
        Formula::new(
            "Actuator::variance_of_latency",
            &["s"],
            late.variance_of_latency(),
            "latency_variance (residue s)",
        )
        .by("bridge_actuator"),
        Formula::new(
            "actuator::lag_variance",
            &["theta", "e"],
            of_lag,
            "lag_variance theta",
        )
        .given("e = lag_decay theta")
        .by("bridge_actuator"),
        Formula::new(
            "actuator::shared_variance",
            &["theta", "f", "power", "e"],
            whole,
            "late_lag_variance f theta",
        )
        .named("late_lag_variance")
        .given("e = lag_decay theta")
        .given("power = late_power f theta 1")
        .by("bridge_actuator"),
    ]
}

fn filters() -> Vec<Formula> {
    let filter = Filter::filtered_damping(&var("B"), &var("a"));
    let mut past = VecDeque::from([var("B") * var("w")]);
    let command = filter.next(&[var("x1"), var("x0")], &mut past);
    let cost = filtered_cost(&var("B"), &var("a"));
    vec![
        Formula::new(
            "controller::Filter::next",
            &["B", "a", "w", "x0", "x1"],
            command,
            "x1 + B * filtered_step a w (x1 - x0)",
        )
        .named("filtered_command")
        .by("bridge_actuator"),
        Formula::new(
            "linear_part::filtered_cost",
            &["B", "a"],
            cost.viscous,
            "1 / 2 + B * filter_share a",
        )
        .named("filtered_cost_viscous")
        .by("bridge_actuator"),
        Formula::new(
            "linear_part::filtered_cost",
            &["B", "a"],
            cost.coulomb,
            "1 / 2 + B * (1 - a)",
        )
        .named("filtered_cost_coulomb")
        .by("bridge_actuator"),
    ]
}
