//! The queries, by subject.

use crate::Query;

mod boxes;
mod controller;
mod counted;
mod counts;
mod criterion;
mod effects;
mod errata;
mod extremes;
mod generation;
mod joints;
mod limits;
mod lti;
mod witness;
mod words;

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
        extremes::queries(),
        counts::queries(),
        counted::queries(),
        lti::queries(),
        boxes::queries(),
        joints::queries(),
        errata::queries(),
    ]
    .concat()
}
