//! Runs the proof harnesses of `passivity` where no model checker is.
//!
//! The harnesses in `proofs/kani` are written for the Kani model checker, which decides them for
//! every input of their domain. This crate has the same names ([`any`], [`any_where`],
//! [`assume`], [`assert`](assert()), [`cover!`], [`implies!`] and the attributes), so that the
//! same text also compiles into tests: each harness is run on *every* input where the domain is
//! small ([`Mode::Exhausted`]), and on boundary-weighted samples where it is not
//! ([`Mode::Sampled`]). A harness fails its test when
//!
//! - an assertion fails, or anything panics;
//! - no input meets its assumptions, so that it says nothing;
//! - one of its covers is never hit;
//! - it must fail and does not, or fails for another reason than the named one;
//! - it is not in the list `harnesses.toml`, or the list says something else of it.
//!
//! It is not a model checker: what it sampled, it has not proved.

pub mod copy;
mod explore;
pub mod list;
pub mod mutate;
mod record;
mod run;
mod value;

pub use explore::Mode;
pub use passivity_standin_macros::{proof, should_panic, solver, unwind};
pub use run::{Harness, check};
pub use value::Arbitrary;

/// A value of which nothing is known.
#[must_use]
#[track_caller]
pub fn any<T: Arbitrary>() -> T {
    any_where(|_| true)
}

/// A value of which only `accept` is known.
///
/// Kani takes any `FnOnce`; here the predicate is asked about many values.
#[must_use]
#[track_caller]
pub fn any_where<T: Arbitrary, F: Fn(&T) -> bool>(accept: F) -> T {
    explore::draw(accept, std::panic::Location::caller())
}

/// Goes on only where `condition` holds.
pub fn assume(condition: bool) {
    if !condition {
        explore::cut();
    }
}

/// States that `condition` holds; `message` names the claim.
#[track_caller]
pub fn assert(condition: bool, message: &'static str) {
    if !condition {
        explore::fail(message, std::panic::Location::caller());
    }
}

/// States that some input makes `condition` true; see [`cover!`].
pub fn cover(condition: bool, message: &'static str) {
    if condition {
        explore::hit(message);
    }
}

/// States that some input gets here with the condition true. The message is not optional.
#[macro_export]
macro_rules! cover {
    ($condition:expr, $message:literal $(,)?) => {
        $crate::cover($condition, $message)
    };
}

/// Whether the first condition implies the second.
#[macro_export]
macro_rules! implies {
    ($premise:expr => $conclusion:expr) => {
        !($premise) || ($conclusion)
    };
}
