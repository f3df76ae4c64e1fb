//! TH-COUNTS: what is known of an interval from the ends of its two positions, as two encoder counts give
//! them.

use std::cmp::Ordering;

use passivity_core::extremes::{Parabola, farthest, nearest, through};
use passivity_core::generation::{generated_linear, generated_quantized};
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{Friction, Loop, Scalar as _, Step};
use passivity_terms::{Term, paths};

use super::words::{half, n, v, values};
use crate::Query;
use crate::formula::{Formula, all, any, eq, ge, implies, le, lt, positive, taken};

pub(super) fn queries() -> Vec<Query> {
    [
        parabolas(),
        distances(),
        edges(),
        lines(),
        positions(),
        sums(),
    ]
    .concat()
}

/// That the first is not above the second, nor the second above the third.
fn between(least: &Term, x: &Term, most: &Term) -> Formula {
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

/// A loop with an encoder and friction alone.
fn wall() -> Loop<Term> {
    Loop::plain(Friction::new(v("beta"), v("sigma")))
}

/// The interval from one position to another under a force F.
fn held(from: &Term, to: &Term) -> HeldInterval<Term> {
    HeldInterval {
        step: Step::new(from.clone(), to.clone()),
        force: v("F"),
        dtau: v("dtau"),
        extra_storage: None,
    }
}

/// Generated energy against the linear and against the quantized spring.
fn generated(from: &Term, to: &Term) -> [Term; 2] {
    ledger::generated(&wall(), &held(from, to))
}

/// That x is in the tick from `tick` on, whose upper end belongs to it, and is counted as it is.
fn in_tick(x: &Term, tick: &Term) -> Formula {
    let next = tick.clone() + n(1);
    let inside = all([le(tick, x), lt(x, &next), eq(&x.floor(), tick)]);
    any([inside, all([eq(x, &next), eq(&x.floor(), &next)])])
}

/// Along an edge of the rectangle generated energy is a parabola in d, and the code finds it from three of
/// its values.
fn edges() -> Vec<Query> {
    let (x, y) = (v("x"), v("y"));
    let d = y.clone() - x.clone();
    let [linear, _] = generated(&x, &y);
    let curve =
        |half: Term, position: &Term| half * d.square() + (v("F") + position.clone()) * d.clone();
    let (from, to) = (v("from"), v("to"));
    let at = |d: &Term| d.clone() * (v("A") * d.clone() + v("G")) + v("C");
    let values_at = [from.clone(), (from.clone() + to.clone()).half(), to.clone()];
    let found = paths::of(|| through(values_at.each_ref().map(at), [from.clone(), to.clone()]));
    let goal = |of: &dyn Fn(&[Term; 3]) -> Formula| {
        let part = |path: &paths::Path<Option<[Term; 3]>>| {
            Some(implies(taken(path), of(path.result.as_ref()?)))
        };
        Formula::All(found.iter().filter_map(part).collect())
    };
    let differ = any([lt(&from, &to), lt(&to, &from)]);
    // At rest nothing is generated.
    let rests = any([
        eq(&v("C"), &n(0)),
        all([lt(&n(0), &from), lt(&n(0), &to)]),
        all([lt(&from, &n(0)), lt(&to, &n(0))]),
    ]);
    let coefficient = |index: usize, name: &str| {
        let name = v(name);
        goal(&move |found: &[Term; 3]| eq(&found[index], &name))
    };
    let says = "the code finds a parabola from its values at two places and half way between them";
    vec![
        Query::new(
            "TH-COUNTS",
            "edge of the start",
            "while the start moves generated energy is −½d² + (F + ξ₁)d",
        )
        .then(eq(&linear, &curve(-n(1).half(), &y)))
        .but_not(
            "it is not ½d² + (F + ξ₁)d",
            eq(&linear, &curve(n(1).half(), &y)),
        ),
        Query::new(
            "TH-COUNTS",
            "edge of the end",
            "while the end moves generated energy is ½d² + (F + ξ₀)d",
        )
        .then(eq(&linear, &curve(n(1).half(), &x)))
        .but_not(
            "it is not −½d² + (F + ξ₀)d",
            eq(&linear, &curve(-n(1).half(), &x)),
        ),
        Query::new("TH-COUNTS", "curvature", says)
            .given([differ.clone()])
            .then(coefficient(0, "A"))
            .but_not("the curvature is not the slope", coefficient(0, "G")),
        Query::new("TH-COUNTS", "slope", says)
            .given([differ.clone(), coefficient(0, "A")])
            .then(coefficient(1, "G"))
            .but_not("the slope is not the curvature", coefficient(1, "A")),
        Query::new("TH-COUNTS", "value at rest", says)
            .given([differ, coefficient(0, "A"), coefficient(1, "G"), rests])
            .then(coefficient(2, "C"))
            .not_without("a value at rest that is not zero is not found", 1),
    ]
}

/// On a line of equal displacement net energy is between its values at two points around.
fn lines() -> Vec<Query> {
    let (x, y) = (v("x"), v("y"));
    let (back, ahead) = (v("back"), v("ahead"));
    let net = |shift: &Term| {
        let interval = held(&(x.clone() + shift.clone()), &(y.clone() + shift.clone()));
        ledger::row(&wall(), &interval)
    };
    let [first, here, last] = [&back, &n(0), &ahead].map(net);
    let inside = |[a, b, c]: [&Term; 3]| any([between(a, b, c), between(c, b, a)]);
    let says =
        "on a line of equal displacement net energy is between its values at any two points around";
    let query = |part| {
        Query::new("TH-COUNTS", part, says).given([
            positive(&v("dtau")),
            le(&back, &n(0)),
            le(&n(0), &ahead),
        ])
    };
    vec![
        query("line")
            .then(inside([&first.net_linear, &here.net_linear, &last.net_linear]))
            .but_not("it is not the same everywhere", eq(&first.net_linear, &here.net_linear)),
        Query::new("TH-COUNTS", "every line", "from every point of the rectangle a line of equal displacement leads to the edge both ways")
            .given([
                le(&v("a"), &x),
                le(&x, &v("b")),
                le(&v("c"), &y),
                le(&y, &v("d")),
                eq(&ahead, &(v("b") - x.clone()).min(v("d") - y.clone())),
                eq(&back, &-(x.clone() - v("a")).min(y.clone() - v("c"))),
            ])
            .then(all([
                le(&back, &n(0)),
                le(&n(0), &ahead),
                all([
                    between(&v("a"), &(x.clone() + back.clone()), &v("b")),
                    between(&v("c"), &(y.clone() + back.clone()), &v("d")),
                    between(&v("a"), &(x.clone() + ahead.clone()), &v("b")),
                    between(&v("c"), &(y.clone() + ahead.clone()), &v("d")),
                ]),
                any([eq(&(x.clone() + ahead.clone()), &v("b")), eq(&(y.clone() + ahead.clone()), &v("d"))]),
                any([eq(&(x.clone() + back.clone()), &v("a")), eq(&(y.clone() + back.clone()), &v("c"))]),
            ]))
            .but_not("not both at once", all([eq(&(x + ahead.clone()), &v("b")), eq(&(y + ahead), &v("d"))])),
    ]
}

/// Generated energy is extreme at the ends of a position, or where the wall balances the force; against the
/// quantized spring it is straight within a tick.
fn positions() -> Vec<Query> {
    let (lo, hi, x, other) = (v("lo"), v("hi"), v("x"), v("e"));
    let balance = (-v("F")).max(lo.clone()).min(hi.clone());
    let pair = |moving: &Term, start_moves: bool| match start_moves {
        true => generated(moving, &other),
        false => generated(&other, moving),
    };
    let linear = |part, start_moves: bool| {
        let [first, last, balanced, here] = [&lo, &hi, &balance, &x].map(|at| {
            let [linear, _] = pair(at, start_moves);
            linear
        });
        let [least, most] = [first.clone().min(last.clone()), first.max(last)];
        let says = "generated energy at a position between two ends is between its values at these and where the wall balances the force";
        let example = values([
            ("lo", 0, 1),
            ("hi", 2, 1),
            ("x", 1, 1),
            ("F", -1, 1),
            ("e", 0, 1),
        ]);
        Query::new("TH-COUNTS", part, says)
            .given([le(&lo, &x), le(&x, &hi)])
            .then(between(
                &least.clone().min(balanced.clone()),
                &here,
                &most.clone().max(balanced),
            ))
            .but_not(
                "not between those at the ends alone",
                between(&least, &here, &most),
            )
            .at(example)
    };
    let stairs = |part, start_moves: bool| {
        let [_, here] = pair(&x, start_moves);
        let [_, at_tick] = pair(&v("tick"), start_moves);
        let rise = (v("F") + v("tick") + half()) * (x.clone() - v("tick"));
        let rise = if start_moves { -rise } else { rise };
        let says = "within a tick, its upper end included, generated energy against the quantized spring changes by F + n + ½ a tick, up with the end and down with the start";
        Query::new("TH-COUNTS", part, says)
            .given([eq(&v("tick").floor(), &v("tick")), in_tick(&x, &v("tick"))])
            .then(eq(&(here - at_tick), &rise))
            .not_without("not across ticks", 1)
            .at(values([
                ("tick", 0, 1),
                ("F", 0, 1),
                ("e", 0, 1),
                ("x", 7, 2),
            ]))
    };
    let force = |force: Term| {
        let interval = HeldInterval {
            force,
            ..held(&v("x"), &v("y"))
        };
        let [linear, _] = ledger::generated(&wall(), &interval);
        linear
    };
    let [weak, some, strong] = ["F0", "F", "F1"].map(|name| force(v(name)));
    vec![
        linear("end position", false),
        linear("start position", true),
        stairs("quantized end position", false),
        stairs("quantized start position", true),
        Query::new(
            "TH-COUNTS",
            "force",
            "under a force between two ends generated energy is between its values under these",
        )
        .given([le(&v("F0"), &v("F")), le(&v("F"), &v("F1"))])
        .then(any([
            between(&weak, &some, &strong),
            between(&strong, &some, &weak),
        ]))
        .but_not(
            "not always the first way round",
            between(&weak, &some, &strong),
        ),
    ]
}

/// A residue that ends one interval starts the next: the sum over two intervals is that of E_g in the first
/// and of E_gᴸ in the second, as if this had started with the residue of the first.
fn sums() -> Vec<Query> {
    let step = |from: &str, to: &str| Step::new(v(from), v(to));
    let both = generated_linear(&step("x0", "x1")) + generated_linear(&step("x1", "x2"));
    let first = generated_quantized(&step("x0", "x1"));
    let second = generated_linear(&step("x", "x2"));
    let residue = |name: &str| v(name) - v(name).floor();
    vec![
        Query::new("TH-COUNTS", "sum", "Σ E_gᴸ over two intervals is E_g of the first and E_gᴸ of the second, from the first residue on")
            .given([
                eq(&v("x").floor(), &v("x1").floor()),
                eq(&residue("x"), &residue("x0")),
            ])
            .then(eq(&both, &(first.clone() + second.clone())))
            .not_without("not from another residue on", 1),
    ]
}
