//! Short words for variables and numbers.

use passivity_core::Scalar as _;
use passivity_terms::Term;

use crate::formula::{Formula, eq};

/// The variable of that name.
pub(super) fn v(name: &str) -> Term {
    Term::variable(name)
}

/// The number n.
pub(super) fn n(n: i32) -> Term {
    Term::integer(n)
}

/// ½.
pub(super) fn half() -> Term {
    n(1).half()
}

/// That variables have these values, n/d each: where a counterexample is near at hand.
pub(super) fn values<const N: usize>(of: [(&str, i32, i32); N]) -> [Formula; N] {
    of.map(|(name, numerator, denominator)| eq(&v(name), &Term::fraction(numerator, denominator)))
}
