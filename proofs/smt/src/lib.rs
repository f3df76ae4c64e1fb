//! The claims as questions to solvers, for all real numbers.
//!
//! Every question is printed from the kernel's own functions, run on terms
//! ([`passivity_terms::Term`]): what the solver is asked is the code. A question has the premises
//! and the negated goal, and must be unsatisfiable; its twin has the premises alone, and its mutant
//! something changed, and both must be satisfiable: a proof of nothing and a goal that can't fail
//! are found out. The errata are asked as printed, and must be satisfiable too. The texts are
//! committed in `queries/`, and a test compares them with the code.
//!
//! What is satisfiable has whole floors, and its model is exact rationals: [`replay`] runs the
//! kernel on them, which has to find that they are what the solver says.

pub mod claims;
pub mod formula;
mod query;
pub mod replay;
pub mod run;
pub mod solvers;

pub use query::{Answer, Query, Script};
