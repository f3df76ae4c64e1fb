//! The claims as questions to solvers, for all real numbers.
//!
//! Every question is printed from the kernel's own functions, run on terms
//! ([`passivity_terms::Term`]): what the solver is asked is the code. A question has the premises
//! and the negated goal, and must be unsatisfiable; its twin has the premises alone, and its mutant
//! something changed, and both must be satisfiable: a proof of nothing and a goal that can't fail
//! are found out. The texts are committed in `queries/`, and a test compares them with the code.
//!
//! The errata are asked as printed. They must be satisfiable; the model is a counterexample in exact
//! rationals, and [`replay`] runs the kernel on it.

pub mod claims;
pub mod formula;
mod query;
pub mod replay;
pub mod run;
pub mod solvers;

pub use query::{Answer, Query, Script};
