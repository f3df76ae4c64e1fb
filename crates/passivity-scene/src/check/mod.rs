//! The verdict over a scene: passive or not, how far from the border, and what to change.
//!
//! [`check`] refines π until the verdict no longer depends on it, evaluates the kernel's
//! criterion at the corners of the tolerances, and collects every figure of the report.

mod bounds;
mod changes;
mod decide;
mod figures;
mod json;
mod report;
mod stiffest;
mod text;

pub use changes::{Change, Direction};
pub use decide::Verdict;
pub use report::{BoundSource, Report, Witness, check};
