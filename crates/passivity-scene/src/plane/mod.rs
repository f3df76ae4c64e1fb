//! The plane of two parameters of a scene: where the criterion holds, and the border of it.
//!
//! A point of the plane is the scene with two of its parameters replaced by the numbers of the point,
//! all others anywhere in their tolerances. Whether the criterion holds there is decided exactly, as
//! `check` decides it (CHECK-VERDICT). The border is found a column at a time: from the formula that
//! solves the criterion for one of the two parameters (TH-STIFF) where there is one, else by halving
//! between a point that passes and one that does not. Every point of a [`Region`] is a short decimal
//! at which the criterion holds: typed into the scene, it passes.

mod column;
mod extent;
mod measured;
mod region;
mod spans;
mod window;

pub use column::{Plane, PlaneError, Speeds};
pub use extent::Extent;
pub use measured::{Measured, Measurement, Prediction};

pub use region::{Line, Region};
pub use window::{Window, window};
