//! The kernel's functions run on terms instead of numbers.
//!
//! [`Term`] implements the kernel's [`Scalar`](passivity_core::Scalar) by writing down what was
//! asked of it. So `generation::generated_linear` called with variables gives the formula that
//! its code computes, and a query to a solver, or a definition for a proof assistant, that is
//! printed from it ([`smt`], [`rocq`]) speaks of the code and not of a copy. Nothing is
//! simplified on the way.
//!
//! Functions that ask for a sign (verdicts, witnesses) are run once for each way the signs can
//! fall: see [`paths`].
//!
//! # Example
//!
//! ```
//! use passivity_core::{Step, generation::generated_linear};
//! use passivity_terms::{Term, rocq};
//!
//! let step = Step::new(Term::variable("x0"), Term::variable("x1"));
//! assert_eq!(
//!     rocq::print(&generated_linear(&step)),
//!     "(((x1 - x0) * (((x1 - x0) + ((x0 - (floor x0)) + (x0 - (floor x0)))) - 1)) / 2)"
//! );
//! ```

pub mod paths;
pub mod rocq;
pub mod smt;
mod term;

pub use term::{Node, Term};
