//! The potential of the law that a quantized position makes of a wall.

use passivity_core::{Law, Scalar as _};
use passivity_terms::Term;

use crate::Query;
use crate::claims::words::{half, n, v, values};
use crate::formula::{Formula, all, any, eq, ge, le, nonnegative};

/// What whole numbers allow: a is not below b, or at least one below it.
fn apart(a: &Term, b: &Term) -> Formula {
    any([ge(a, b), le(&(a.clone() + n(1)), b)])
}

/// The potential of the quantized law is the integral of its staircase.
pub(super) fn queries() -> Vec<Query> {
    let law = Law {
        lower: Some(v("lower")),
        upper: Some(v("upper")),
    };
    let limits = [le(&v("lower"), &n(0)), nonnegative(&v("upper"))];
    let tick = v("x0").floor();
    let next_tick = tick.clone() + n(1);
    let middle = tick.clone() + half();
    let run = v("x1") - v("x0");
    let rise = law.quantized_potential(&v("x1")) - law.quantized_potential(&v("x0"));
    // The first tick whose middle is beyond a limit; from the other side, tick n is tick −1 − n.
    let first = |limit: Term| -(half() - limit).floor();
    let (above, below) = (first(v("upper")), first(-v("lower")));
    let mirrored = |tick: &Term| -(tick.clone() + n(1));
    let whole = |tick: &Term| {
        [
            apart(tick, &above),
            apart(&mirrored(tick), &below),
            apart(tick, &n(0)),
        ]
    };
    let same_tick = [ge(&v("x1"), &v("x0")), eq(&v("x1").floor(), &tick)];
    let to_next = [eq(&v("x1"), &next_tick), eq(&v("x1").floor(), &next_tick)];
    let query = |part, says, given: &[Formula]| {
        Query::new("TH-LAW", part, says)
            .given(limits.clone())
            .given([nonnegative(&above), nonnegative(&below)])
            .given([whole(&tick), whole(&next_tick)].concat())
            .given(given.to_vec())
            .then(eq(&rise, &(law.force(&middle) * run.clone())))
            .but_not(
                "the force at the start of the tick is another",
                eq(&rise, &(law.force(&tick) * run.clone())),
            )
            .at(values([("x0", 1, 2), ("lower", -9, 1), ("upper", 9, 1)]))
    };
    vec![
        Query::new(
            "TH-LAW",
            "whole ticks",
            "a tick, which is whole, is not below another or at least one below it; the first beyond a limit is not below zero",
        )
        .whole()
        .given([nonnegative(&v("upper"))])
        .then(all([apart(&tick, &n(0)), nonnegative(&above)]))
        .but_not("not always below", le(&next_tick, &n(0))),
        query(
            "staircase",
            "within a tick the potential of the quantized law rises by the force at its middle",
            &same_tick,
        ),
        query(
            "staircase to the next tick",
            "up to the next tick it rises by the force at the middle of its own",
            &to_next,
        ),
    ]
}
