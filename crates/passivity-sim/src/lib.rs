//! Motion of a haptic device between the samples of a virtual wall, and its energy ledger.
//!
//! The force is held over each sampling interval, so the motion within it has a closed form: no
//! step size, no tolerance, at most one reversal per interval, found in closed form too. A scene
//! compiles to a [`Plan`] that holds exactly the effects it has; an effect that is not there is not
//! in the inner loop.
//!
//! Dimensionless throughout: ξ in encoder ticks, τ in sampling periods, force in KΔ, energy in
//! KΔ², μ = m/(KT²), β = b/(KT), σ = c/(KΔ). The numbers in round brackets are the paper's.
//!
//! What it is **not**: it gives no verdict (that is exact, in `passivity-core`), and it reads no
//! scene files.
//!
//! # Example
//!
//! ```
//! use passivity_sim::{ExactOutcome, Plain, Plan, run};
//!
//! // (0.6, 0.6) is globally stable: the device comes to exact rest.
//! let plan = Plan::plain(&Plain { mu: 50.0, beta: 0.6, sigma: 0.6, xi: 0.0, velocity: 1.0 }, 50_000);
//! let end = run::outcome(&plan);
//! assert_eq!(end.outcome.exact, ExactOutcome::AtRest);
//! assert!(end.intervals < 2_000);
//! ```
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

pub mod accuracy;
pub mod lanes;
#[cfg(feature = "plot")]
pub mod plot;
pub mod report;
pub mod run;
pub mod scales;
pub mod sweep;
pub mod trace;

mod error;
mod family;
mod flow;
mod growth;
mod latency;
mod law;
mod ledger;
mod method;
mod methods;
mod model;
mod motion;
mod number;
mod outcome;
mod phi;
mod plan;
mod rounding;
mod series;
mod simulated;

#[cfg(test)]
mod differential;

pub use error::SimError;
pub use ledger::{Entry, Totals};
pub use method::{Method, NAMES};
pub use methods::{simulate, simulate_beyond};
pub use model::IntervalRow;
pub use number::{Double, Enclosed};
pub use outcome::{End, ExactOutcome, Outcome, PaperOutcome};
pub use plan::{Beyond, Plain, Plan};
pub use simulated::{Detail, Each, Line, Simulated};
