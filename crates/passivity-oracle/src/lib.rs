//! Exact energy ledgers of recorded traces, and a line protocol for other implementations.
//!
//! A trace of true positions gives every figure of the ledger exactly. A trace of encoder counts
//! gives only ξ in [n, n + 1): then every figure is an exact enclosure and every verdict has three
//! values. See [`entry()`] for one interval, [`run`] for many
//! and [`audit`] for a trace in a file.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

pub mod audit;
pub mod csv;
mod enclosure;
pub mod ends;
pub mod entry;
pub mod figure;
pub mod json;
pub mod ledger;
pub mod motion;
pub mod number;
mod parabola;
pub mod protocol;
pub mod reading;
pub mod run;
pub mod sum;

pub use ends::Ends;
pub use entry::{Entry, Margin, Recorded, entry};
pub use figure::Figure;
pub use json::NumberedRow;
pub use ledger::{Ledger, Logged, Row, Truths};
pub use number::Number;
pub use reading::Reading;
