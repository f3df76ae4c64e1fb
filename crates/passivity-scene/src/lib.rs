//! Scene files: what a device, its loop and a virtual wall are, exactly.
//!
//! A scene is a TOML file in the field's words and units. Reading it gives exact numbers: a
//! decimal literal is the rational it spells, a tolerance a closed interval, and π (an encoder of N
//! counts per revolution has Δ = 2π/N) an enclosure that is refined until it no longer matters.
//!
//! An effect is in a [`Scene`] exactly when its key is in the file.

pub mod check;
pub mod diagnostic;
pub mod display;
pub mod effect;
pub mod exact;
pub mod explain;
pub mod json;
pub mod number;
pub mod parse;
pub mod pi;
pub mod point;
pub mod scene;
pub mod units;

pub use diagnostic::{Diagnostic, SceneError};
pub use effect::Effect;
pub use exact::Exact;
pub use point::Point;
pub use scene::{Arm, Force, Given, Motion, Scene, Start};
