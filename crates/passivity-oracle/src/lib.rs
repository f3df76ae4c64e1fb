//! A line protocol for other implementations of the exact energy account: a request a line, an answer
//! a line.
//!
//! The figures are those of `passivity-audit`; see [`protocol`] for the requests.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

pub mod motion;
pub mod protocol;
