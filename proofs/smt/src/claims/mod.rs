//! The queries, by subject.

use passivity_core::Scalar as _;
use passivity_terms::Term;

use crate::Query;
use crate::formula::{Formula, eq};

mod boxes;
mod controller;
mod criterion;
mod effects;
mod errata;
mod generation;
mod limits;
mod witness;

/// Every query, in the order of the claims.
#[must_use]
pub fn all() -> Vec<Query> {
    [
        generation::queries(),
        criterion::queries(),
        limits::queries(),
        witness::queries(),
        effects::queries(),
        controller::queries(),
        boxes::queries(),
        errata::queries(),
    ]
    .concat()
}

/// The variable of that name.
fn v(name: &str) -> Term {
    Term::variable(name)
}

/// The number n.
fn n(n: i32) -> Term {
    Term::integer(n)
}

/// ½.
fn half() -> Term {
    n(1).half()
}

/// That variables have these values, n/d each: where a counterexample is near at hand.
fn values<const N: usize>(of: [(&str, i32, i32); N]) -> [Formula; N] {
    of.map(|(name, numerator, denominator)| eq(&v(name), &Term::fraction(numerator, denominator)))
}
