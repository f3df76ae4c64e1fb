//! Proof harnesses: the kernel's own functions, run by a model checker.
//!
//! Each harness calls the generic functions of `passivity-core` at [`Dyadic`] or [`Ratio`], exact
//! numbers of bounded width, or at the kernel's own fractions, and states one claim of
//! `proofs/claims.toml`. Kani decides it for every input of the harness's domain
//! (`make prove-kani`); `cargo test` runs the same text on all inputs of a small domain and on
//! samples of a larger one. `README.md` says how to read and how to add one.
//!
//! Habits that keep a harness decidable: few symbols of 3 to 7 bits, one `any_where` a variable
//! written as a comparison, no division of two symbols, no loop over sampling intervals (one
//! interval and the step of an induction instead).

// Under Kani, `kani` is the tool's own crate. Elsewhere it is the stand-in, by the same name.
#[cfg(not(kani))]
extern crate passivity_standin as kani;

mod domain;
mod dyadic;
mod ratio;

pub use dyadic::Dyadic;
pub use ratio::Ratio;

mod actuator;
mod criterion;
mod dissipation;
mod effects;
mod errata;
mod fixed_width;
mod generation;
mod identities;
mod interval;
mod law;
mod merge;
mod monitor;
mod parts;
mod region;
mod smooth;
mod start;
mod stiffness;
mod witness;
