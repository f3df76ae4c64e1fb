//! TH-COUNTS: the parabola that net energy is on an edge, and the nearest and farthest positions.

use std::cmp::Ordering;

use passivity_core::Scalar as _;
use passivity_core::extremes::{Parabola, farthest, nearest};
use passivity_terms::{Term, paths};

use super::words::{n, v, values};
use crate::Query;
use crate::formula::{Formula, all, any, eq, ge, implies, le, lt, taken};

pub(super) fn queries() -> Vec<Query> {
    [parabolas(), distances()].concat()
}

/// That the first is not above the second, nor the second above the third.
pub(super) fn between(least: &Term, x: &Term, most: &Term) -> Formula {
    all([le(least, x), le(x, most)])
}

/// αd² + σ|d| + γd + κ.
fn parabola() -> Parabola<Term> {
    Parabola {
        square: v("alpha"),
        magnitude: v("sigma"),
        linear: v("gamma"),
        constant: v("kappa"),
    }
}

/// On every path through the search on one side of the kink that is possible there.
fn one_way(back: bool, says: impl Fn(&[Term; 2]) -> Formula) -> Formula {
    let found = paths::of(|| parabola().range_one_way(&v("from"), &v("to")));
    let possible = found.iter().filter(|path| {
        let other_side =
            |sign: &paths::Sign| sign.term == v("from") && (sign.sign == Ordering::Less) != back;
        !path.signs.iter().any(other_side)
    });
    let goal = possible.filter_map(|path| Some(implies(taken(path), says(path.result.as_ref()?))));
    Formula::All(goal.collect())
}

/// Nothing on one side of the kink is beyond the extremes, and they are values there.
fn parabolas() -> Vec<Query> {
    let (from, to, d) = (v("from"), v("to"), v("d"));
    let value = |d: &Term| parabola().at(d);
    let mut queries = Vec::new();
    for (contains, reached, vertex, back) in [
        (
            [
                "extremes forward",
                "extremes forward down",
                "extremes forward straight",
            ],
            "reached forward",
            "vertex forward",
            false,
        ),
        (
            [
                "extremes back",
                "extremes back down",
                "extremes back straight",
            ],
            "reached back",
            "vertex back",
            true,
        ),
    ] {
        let side = match back {
            false => vec![le(&n(0), &from), le(&from, &to)],
            true => vec![lt(&from, &n(0)), le(&to, &n(0)), le(&from, &to)],
        };
        let (near, far) = if back { (-1, -2) } else { (1, 2) };
        let signs = [
            lt(&n(0), &v("alpha")),
            lt(&v("alpha"), &n(0)),
            eq(&v("alpha"), &n(0)),
        ];
        for ((part, sign), alpha) in contains.into_iter().zip(signs).zip([1, -1, 0]) {
            let example = values([
                ("from", near.min(far), 1),
                ("to", near.max(far), 1),
                ("d", if alpha < 0 { far } else { near }, 1),
                ("alpha", alpha, 1),
            ]);
            let flat = values([("sigma", 0, 1), ("gamma", 0, 1), ("kappa", 0, 1)]);
            queries.push(
                Query::new("TH-COUNTS", part, "no value of the parabola with a kink, on one side of it, is beyond the extremes that the code finds")
                    .given(side.clone())
                    .given([sign, le(&from, &d), le(&d, &to)])
                    .then(one_way(back, |[least, most]| between(least, &value(&d), most)))
                    .but_not(
                        "a least value raised by one is passed",
                        one_way(back, |[least, most]| {
                            between(&(least.clone() + n(1)), &value(&d), most)
                        }),
                    )
                    .at(example)
                    .at(flat),
            );
        }
        // On this side |d| is d or −d, and the slope 2αd + γ ± σ.
        let at_zero = match back {
            false => v("gamma") + v("sigma"),
            true => v("gamma") - v("sigma"),
        };
        let twice = v("alpha").double();
        let height = v("kappa") - at_zero.square().over(twice.clone().double());
        let slope = |d: &Term| twice.clone() * d.clone() + at_zero.clone();
        let turns = any([
            all([lt(&slope(&from), &n(0)), lt(&n(0), &slope(&to))]),
            all([lt(&n(0), &slope(&from)), lt(&slope(&to), &n(0))]),
        ]);
        let curved = any([lt(&v("alpha"), &n(0)), lt(&n(0), &v("alpha"))]);
        let one_of = |x: &Term| {
            let inside = all([curved.clone(), turns.clone(), eq(x, &height)]);
            any([eq(x, &value(&from)), eq(x, &value(&to)), inside])
        };
        queries.push(
            Query::new("TH-COUNTS", reached, "both extremes are values at an end, or κ − (γ ± σ)²/4α where the slope changes its sign")
                .given(side.clone())
                .then(one_way(back, |[least, most]| all([one_of(least), one_of(most)])))
                .but_not(
                    "the least is not always that at the start",
                    one_way(back, |[least, _]| eq(least, &value(&from))),
                ),
        );
        queries.push(
            Query::new(
                "TH-COUNTS",
                vertex,
                "where the slope changes its sign that is a value between the ends",
            )
            .given(side)
            .given([
                curved.clone(),
                turns.clone(),
                eq(&(d.clone() * twice.clone()), &-at_zero),
            ])
            .then(all([lt(&from, &d), lt(&d, &to), eq(&value(&d), &height)]))
            .not_without("elsewhere it is not", 1),
        );
    }
    queries
}

/// Nothing between the ends is nearer than the pair that the code takes, or farther.
fn distances() -> Vec<Query> {
    let [a, b, c, d] = ["a", "b", "c", "d"].map(v);
    let (x, y) = (v("x"), v("y"));
    let length = |from: &Term, to: &Term| (to.clone() - from.clone()).abs();
    let premises = [
        le(&a, &b),
        le(&c, &d),
        le(&a, &x),
        le(&x, &b),
        le(&c, &y),
        le(&y, &d),
    ];
    let within = |[from, to]: &[&Term; 2]| all([between(&a, from, &b), between(&c, to, &d)]);
    let near = paths::of(|| nearest([&a, &b], [&c, &d]).map(|pair| pair.map(Clone::clone)));
    let far = paths::of(|| farthest([&a, &b], [&c, &d]).map(|pair| pair.map(Clone::clone)));
    let on = |found: &[paths::Path<Option<[Term; 2]>>], says: &dyn Fn([&Term; 2]) -> Formula| {
        let part = |path: &paths::Path<Option<[Term; 2]>>| {
            let pair = path.result.as_ref()?;
            let pair = pair.each_ref();
            Some(implies(taken(path), all([within(&pair), says(pair)])))
        };
        Formula::All(found.iter().filter_map(part).collect())
    };
    let here = length(&x, &y);
    let query = |part, says| Query::new("TH-COUNTS", part, says).given(premises.clone());
    vec![
        query("nearest", "of two positions between their ends none are nearer than the pair that the code takes")
            .then(on(&near, &|[from, to]| le(&length(from, to), &here)))
            .but_not("they may be farther", on(&near, &|[from, to]| ge(&length(from, to), &here))),
        query("farthest", "of two positions between their ends none are farther than the pair that the code takes")
            .then(on(&far, &|[from, to]| ge(&length(from, to), &here)))
            .but_not("they may be nearer", on(&far, &|[from, to]| le(&length(from, to), &here))),
    ]
}
