//! Scene files: what a device, its loop and a virtual wall are, exactly.
//!
//! A scene is a TOML file in the field's words and units. Reading it gives exact numbers: a
//! decimal literal is the rational it spells, a tolerance a closed interval, and π (an encoder of N
//! counts per revolution has Δ = 2π/N) a symbol that is enclosed only where a sign is asked for.
//!
//! An effect is in a [`Scene`] exactly when its key is in the file.

#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

pub mod any;
pub mod check;
pub mod diagnostic;
pub mod display;
mod ends;
pub mod explain;
pub mod files;
pub mod joints;
pub mod json;
pub mod number;
pub mod parse;
pub mod plane;
pub mod point;
pub mod scene;
pub mod units;
pub mod written;

pub use any::AnyScene;
pub use diagnostic::{Diagnostic, SceneError};
pub use joints::JointScene;
pub use parse::{Axis, AxisError};
pub use passivity_core::{Effect, Exact};
pub use point::Point;
pub use scene::{ForceSamples, Given, Motion, Scene};
pub use written::Written;
