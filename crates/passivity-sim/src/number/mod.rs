//! The numbers that a motion is computed with: doubles, rationals, numbers of any precision, and
//! rigorous intervals. The kernel's formulas run on all of them.

#[cfg(feature = "multiprecision")]
pub(crate) mod big;
pub(crate) mod directed;
pub(crate) mod double;
pub(crate) mod enclosed;
pub(crate) mod rational;
pub(crate) mod real;

pub use double::Double;
pub(crate) use double::{MAGIC, floor};
pub use enclosed::Enclosed;
pub(crate) use rational::to_double;
pub(crate) use real::{Real, Undecided};
