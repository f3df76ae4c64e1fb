//! Exact energy ledgers of recorded traces, and a line protocol for other implementations.
//!
//! A trace of true positions gives every figure of the ledger exactly. A trace of encoder counts
//! gives only ξ in [n, n + 1): then every figure is an exact enclosure and every verdict has three
//! values. See [`entry()`] for one interval, [`run`] for many
//! and [`audit`] for a trace in a file.

pub mod audit;
pub mod cell;
pub mod entry;
mod generated;
pub mod ledger;
pub mod model;
pub mod motion;
pub mod number;
pub mod protocol;
pub mod row;
pub mod run;
pub mod span;
pub mod sum;

pub use cell::Cell;
pub use entry::{Entry, Margin, entry};
pub use ledger::{Ledger, Row, Sample};
pub use model::Model;
pub use number::Number;
pub use span::Span;
