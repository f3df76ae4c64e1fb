//! Pictures: drawn once as SVG, written as SVG or PNG.
//!
//! Charts are drawn with `plotters` into SVG text; [`save`] writes it, rasterised by `resvg` with
//! a font that is part of the program when the file's name ends in `.png`. So a picture looks the
//! same on every machine.

pub mod critical;
pub mod energy;
mod file;
pub mod frequency;
pub mod plane;
#[cfg(feature = "png")]
mod png;

pub use file::{PlotError, save};
#[cfg(feature = "png")]
pub use png::to_png;
