//! TODO
#![no_std]
#![forbid(unsafe_code)]
#![deny(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::unreachable,
    clippy::indexing_slicing
)]

pub mod account;

mod config;
mod monitor;
mod width;

pub use config::{Config, ConfigError, Parameter};
pub use monitor::{Answer, Given, Monitor, Quantity, Saturation};
pub use width::{PARAMETER_MAX, Width};
