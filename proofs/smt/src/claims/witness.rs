//! TH-ACTIVE: the cycle that draws energy, and that there is one.

use passivity_core::witness::{gain, gain_formula, quantized, smooth};
use passivity_core::{Cycle, Friction, Scalar as _};
use passivity_terms::{Term, paths};

use super::words::{half, n, v, values};
use crate::Query;
use crate::formula::{
    Formula, all, any, eq, ge, gt, implies, le, lt, nonnegative, not, on_every_path, positive,
    taken,
};

fn friction() -> Friction<Term> {
    Friction::new(v("beta"), v("sigma"))
}

/// The ends of a cycle between n − a and n + m.
fn ends() -> (Term, Term) {
    (v("n") - v("a"), v("n") + v("m"))
}

/// x = ⌊x⌋.
fn whole(x: &Term) -> Formula {
    eq(&x.floor(), x)
}

pub(super) fn queries() -> Vec<Query> {
    let (from, to) = ends();
    let friction = friction();
    let formula = gain_formula(&v("m"), &v("a"), &friction);
    let floors = [eq(&from.floor(), &(v("n") - n(1))), eq(&to.floor(), &to)];
    let short = any([lt(&v("beta"), &half()), lt(&v("sigma"), &half())]);
    let found = paths::of(|| quantized(&friction, None));
    let smoothly = paths::of(|| smooth(&friction, None));
    let not_negative = [nonnegative(&v("beta")), nonnegative(&v("sigma"))];
    // Giving up before the last question, whether a cycle gains.
    let gave_up = |p: &&Search| p.result.is_none() && !asked_for_gain(p, &found);
    let given_up = Formula::Any(found.iter().filter(gave_up).map(taken).collect());
    let smooth_none = Formula::Any(
        smoothly
            .iter()
            .filter(|p| p.result.is_none())
            .map(taken)
            .collect(),
    );
    vec![
        Query::new(
            "TH-ACTIVE",
            "tick below",
            "for whole n and 0 < a ≤ 1 the lower end lies in tick n − 1",
        )
        .whole()
        .given([whole(&v("n")), positive(&v("a")), le(&v("a"), &n(1))])
        .then(floors[0].clone())
        .not_without("not for a above one", 1),
        Query::new(
            "TH-ACTIVE",
            "gain",
            "the gain by the forces is d(m + 1 − 2βd − 2σ)",
        )
        .given(floors)
        .given([positive(&v("a")), nonnegative(&v("m"))])
        .then(eq(&gain(&from, &to, &friction), &formula))
        .but_not(
            "not with m ticks instead of m + 1",
            eq(
                &gain(&from, &to, &friction),
                &gain_formula(&(v("m") - n(1)), &v("a"), &friction),
            ),
        )
        .at(values([
            ("n", 0, 1),
            ("m", 1, 1),
            ("a", 1, 2),
            ("beta", 0, 1),
            ("sigma", 0, 1),
        ])),
        Query::new(
            "TH-ACTIVE",
            "none where passive",
            "where β ≥ ½ and σ ≥ ½ no cycle of m and a gains",
        )
        .given([nonnegative(&v("m")), positive(&v("a")), le(&v("a"), &n(1))])
        .given([ge(&v("beta"), &half()), ge(&v("sigma"), &half())])
        .then(le(&formula, &n(0)))
        .not_without("not where σ < ½", 1),
        Query::new(
            "TH-ACTIVE",
            "ends in code",
            "a cycle that the code considers starts in tick 0",
        )
        .given(not_negative.clone())
        .then(about_cycles(&found, |cycle| {
            all([nonnegative(&cycle.from), lt(&cycle.from, &n(1))])
        }))
        .but_not(
            "it does not end there",
            about_cycles(&found, |cycle| lt(&cycle.to, &n(1))),
        ),
        Query::new(
            "TH-ACTIVE",
            "exists",
            "where β < ½ or σ < ½ the code comes to consider a cycle",
        )
        .given(not_negative.clone())
        .given([short.clone()])
        .then(not(given_up))
        .not_without("not where β ≥ ½ and σ ≥ ½", 1)
        .at(values([("beta", 1, 1), ("sigma", 1, 1)])),
        room_left(
            "room without friction",
            [("beta", 0, 1), ("sigma", 0, 1)],
            [eq(&v("beta"), &n(0)), lt(&v("sigma"), &half())],
        ),
        room_left(
            "room with less than half",
            [("beta", 1, 4), ("sigma", 1, 4)],
            [
                all([positive(&v("beta")), lt(&v("beta"), &half())]),
                lt(&v("sigma"), &half()),
            ],
        ),
        room_left(
            "room with a half",
            [("beta", 1, 2), ("sigma", 1, 4)],
            [eq(&v("beta"), &half()), lt(&v("sigma"), &half())],
        ),
        room_left(
            "room with more than half",
            [("beta", 1, 1), ("sigma", 1, 4)],
            [gt(&v("beta"), &half()), lt(&v("sigma"), &half())],
        ),
        room_left(
            "room of a long cycle without viscous friction",
            [("beta", 0, 1), ("sigma", 1, 1)],
            [eq(&v("beta"), &n(0)), ge(&v("sigma"), &half())],
        ),
        room_left(
            "room of a long cycle",
            [("beta", 1, 4), ("sigma", 1, 1)],
            [
                all([positive(&v("beta")), lt(&v("beta"), &half())]),
                ge(&v("sigma"), &half()),
            ],
        ),
        Query::new(
            "TH-ACTIVE",
            "gains",
            "where friction leaves room the cycle gains",
        )
        .given([
            nonnegative(&v("m")),
            positive(&v("a")),
            positive(&room(&v("m"), &v("a"))),
        ])
        .then(positive(&formula))
        .not_without("else it does not", 1),
        Query::new(
            "TH-SMOOTH",
            "witness",
            "without an encoder a cycle is found exactly where β < ½, and gains 2(½d² − βd² − σd)",
        )
        .given(not_negative)
        .then(all([
            implies(lt(&v("beta"), &half()), not(smooth_none.clone())),
            implies(ge(&v("beta"), &half()), smooth_none.clone()),
            on_every_path(&smoothly, |cycle| match cycle {
                Some(cycle) => {
                    let d = cycle.to.clone();
                    let gain = d.square().half() - v("beta") * d.square() - v("sigma") * d;
                    all([gt(&cycle.gain, &n(0)), eq(&cycle.gain, &gain.double())])
                }
                None => Formula::All(vec![]),
            }),
        ]))
        .but_not("not always", not(smooth_none)),
    ]
}

/// One way through the search for a cycle.
type Search = paths::Path<Option<Cycle<Term>>>;

/// What was assumed on the way to a cycle, before the last question: whether it gains.
fn on_the_way(path: &Search) -> Formula {
    let before = path.signs.len().saturating_sub(1);
    let signs = path.signs.iter().take(before).cloned().collect();
    taken(&paths::Path { signs, result: () })
}

/// Whether the last sign asked for on the path is that of the gain: a cycle was on the table.
fn asked_for_gain(path: &Search, found: &[Search]) -> bool {
    let gains = found
        .iter()
        .filter(|path| path.result.is_some())
        .filter_map(|path| path.signs.last());
    path.signs
        .last()
        .is_some_and(|last| gains.into_iter().any(|gain| gain.term == last.term))
}

/// m + 1 − 2β(m + a) − 2σ: what a cycle gains per tick of its way.
fn room(m: &Term, a: &Term) -> Term {
    let spent = v("beta") * (m.clone() + a.clone()) + v("sigma");
    m.clone() + n(1) - spent.double()
}

/// About every cycle that the code comes to consider.
fn about_cycles(found: &[Search], says: impl Fn(&Cycle<Term>) -> Formula) -> Formula {
    let part = |path: &Search| Some(implies(on_the_way(path), says(path.result.as_ref()?)));
    Formula::All(found.iter().filter_map(part).collect())
}

/// In a cycle that the code considers friction leaves room, in one of four cases.
fn room_left(part: &'static str, example: [(&str, i32, i32); 2], case: [Formula; 2]) -> Query {
    let friction = friction();
    let found = paths::of(|| quantized(&friction, None));
    let with = |times: i32| {
        about_cycles(&found, |cycle| {
            let (m, a) = (cycle.to.clone() - n(1), n(1) - cycle.from.clone());
            let bounds = all([nonnegative(&m), positive(&a), le(&a, &n(1))]);
            all([bounds, positive(&room(&m, &(a * n(times))))])
        })
    };
    let says = "in a cycle that the code considers friction leaves room: 2βa < m + 1 − 2βm − 2σ";
    Query::new("TH-ACTIVE", part, says)
        .given([nonnegative(&v("beta")), nonnegative(&v("sigma"))])
        .given(case)
        .then(with(1))
        .but_not("nothing is left of a tick", {
            about_cycles(&found, |cycle| lt(&cycle.to, &cycle.from))
        })
        .at(values(example))
}
