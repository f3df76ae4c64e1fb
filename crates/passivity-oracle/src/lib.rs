//! Exact energy ledgers of recorded traces, test vectors, and a line protocol for other
//! implementations.
//!
//! A trace of true positions gives every figure of the ledger exactly. A trace of encoder counts
//! gives only ξ in [n, n + 1): then every figure is an exact enclosure and every verdict has three
//! values. See [`entry`] for one interval and [`audit`] for a trace.

pub mod cell;
pub mod entry;
mod generated;
pub mod model;
pub mod number;
pub mod row;
pub mod span;

pub use cell::Cell;
pub use entry::{Entry, entry};
pub use model::Model;
pub use number::Number;
pub use span::Span;
