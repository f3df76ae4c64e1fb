//! Pictures: drawn once as SVG, written as SVG or PNG.
//!
//! Charts are drawn into SVG text, with [`svg`]; [`save`] writes it, rasterised by `resvg` with
//! a font that is part of the program when the file's name ends in `.png`. So a picture looks the
//! same on every machine.

pub mod critical;
pub mod energy;
mod file;
pub mod frame;
pub mod frequency;
mod labels;
pub mod parameters;
pub mod plane;
#[cfg(feature = "png")]
mod png;
pub mod svg;
mod ticks;
mod title;

pub use file::{PlotError, check_name, save};
#[cfg(feature = "png")]
pub use png::to_png;
pub use title::fitted;
