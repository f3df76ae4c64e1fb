//! TH-COUNTS: generated and net energy of an interval of which the ends of both positions are known, as two
//! encoder counts give them.

use passivity_core::extremes::through;
use passivity_core::generation::{generated_linear, generated_quantized};
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{Friction, Loop, Scalar as _, Step};
use passivity_terms::{Term, paths};

use super::extremes::between;
use super::words::{half, n, v, values};
use crate::Query;
use crate::formula::{Formula, all, any, eq, implies, le, lt, positive, taken};

pub(super) fn queries() -> Vec<Query> {
    [edges(), lines(), positions(), lookup(), sums()].concat()
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
pub(super) fn in_tick(x: &Term, tick: &Term) -> Formula {
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

/// What is looked up by the difference of two counts: the row is the same wherever it is.
fn lookup() -> Vec<Query> {
    let (x, y) = (v("x"), v("y"));
    let row = |shift: &Term| {
        let step = Step::new(x.clone() + shift.clone(), y.clone() + shift.clone());
        ledger::row(&wall(), &HeldInterval::plain(step, v("dtau")))
    };
    let (here, there) = (row(&n(0)), row(&v("k")));
    let moves = |position: &Term, from: &Term| {
        let there = position.clone() + v("k");
        eq(
            &there.floor(),
            &((position.clone() + from.clone()).floor() + v("k")),
        )
    };
    let same = [
        (&here.generated_linear, &there.generated_linear),
        (&here.generated_quantized, &there.generated_quantized),
        (&here.dissipated_lower, &there.dissipated_lower),
        (&here.net_linear, &there.net_linear),
        (&here.net_quantized, &there.net_quantized),
        (&here.margin, &there.margin),
    ];
    let same = Formula::All(same.into_iter().map(|(a, b)| eq(a, b)).collect());
    vec![
        Query::new("TH-COUNTS", "lookup", "under the wall's own force the row of two positions is that of the same two any whole number of ticks away")
            .given([positive(&v("dtau")), moves(&x, &n(0)), moves(&y, &n(0))])
            .then(same)
            .not_without("not a part of a tick away", 2),
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
