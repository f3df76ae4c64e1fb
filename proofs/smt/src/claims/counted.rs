//! TH-COUNTS: the closed form of the extremes of an interval between two counts.

use passivity_core::counted::{Arc, Bend, Crossing, Resistance};
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{Friction, Loop, Scalar as _, Step};
use passivity_terms::{Term, paths};

use super::counts::in_tick;
use super::extremes::between;
use super::words::{half, n, v, values};
use crate::Query;
use crate::formula::{Formula, all, any, eq, implies, le, lt, on_every_path};

pub(super) fn queries() -> Vec<Query> {
    [
        energy(),
        generated(),
        displacements(),
        corners(),
        arcs(),
        ends(),
    ]
    .concat()
}

fn crossing() -> Crossing<Term> {
    Crossing {
        ticks: v("k"),
        excess: v("f"),
    }
}

/// Friction, with what the vertices of its parabolas are found with.
fn friction() -> Resistance<Term> {
    let bend = |square: Term, turn| Bend {
        square,
        turn: v(turn),
    };
    Resistance {
        sigma: v("sigma"),
        own: bend(v("beta"), "T"),
        less: bend(v("beta") - half(), "T0"),
        more: bend(v("beta") + half(), "T1"),
    }
}

/// Generated energy at the places x and y within the two ticks: against the wall, and against its quantized form.
fn generated_at(x: &Term, y: &Term) -> [Term; 2] {
    let (k, f) = (v("k"), v("f"));
    let from_tick = |u: &Term| u.clone() * (f.clone() + (u.clone() - n(1)).half());
    [
        from_tick(&(k.clone() + y.clone())) - from_tick(x),
        from_tick(&k) + (f.clone() + k) * y.clone() - f.clone() * x.clone(),
    ]
}

fn in_ticks() -> [Formula; 2] {
    ["x", "y"].map(|place| between(&n(0), &v(place), &n(1)))
}

/// d = k + y − x.
fn displacement() -> Term {
    v("k") + v("y") - v("x")
}

/// What the row has is what the closed form is of.
fn energy() -> Vec<Query> {
    let (from, to, tick) = (v("xi0"), v("xi1"), v("tick"));
    let next = tick.clone() + v("k");
    let interval = HeldInterval {
        step: Step::new(from.clone(), to.clone()),
        force: v("F"),
        dtau: n(1),
        extra_storage: None,
    };
    let wall = Loop::plain(Friction::new(v("beta"), v("sigma")));
    let row = ledger::generated(&wall, &interval);
    let here = generated_at(&(from.clone() - tick.clone()), &(to.clone() - next.clone()));
    let excess = eq(&v("f"), &(v("F") + tick.clone() + half()));
    let query = |part, of: usize| {
        Query::new("TH-COUNTS", part, "generated energy between two ticks is what the closed form is of, the upper ends of the ticks included")
            .given([in_tick(&from, &tick), in_tick(&to, &next), excess.clone()])
            .then(eq(&row[of], &here[of]))
            .not_without("not with any other excess", 1)
    };
    vec![
        query("counted linear energy", 0),
        query("counted quantized energy", 1),
    ]
}

/// Generated energy is between the ends that the code finds, and reaches them.
fn generated() -> Vec<Query> {
    let (f, k) = (v("f"), v("k"));
    let (zero, one) = (n(0), n(1));
    let found = crossing().generated();
    let here = generated_at(&v("x"), &v("y"));
    let is = |place: &str, whole: Formula, other: Formula| {
        let place = v(place);
        any([
            all([whole, eq(&place, &one)]),
            all([other, eq(&place, &zero)]),
        ])
    };
    let (up, down) = (le(&zero, &f), lt(&f, &zero));
    let rise = f.clone() + k.clone();
    let (rises, falls) = (le(&zero, &rise), lt(&rise, &zero));
    let balanced = |x: Term| x.max(zero.clone()).min(one.clone());
    let at_least = [
        all([
            is("x", up.clone(), down.clone()),
            eq(&v("y"), &balanced(half() - rise.clone())),
        ]),
        all([
            is("x", up.clone(), down.clone()),
            is("y", falls.clone(), rises.clone()),
        ]),
    ];
    let at_most = [
        all([
            is("y", rises.clone(), falls.clone()),
            eq(&v("x"), &balanced(half() - f.clone())),
        ]),
        all([is("x", down, up), is("y", rises, falls)]),
    ];
    let example = values([("k", 1, 1), ("f", 0, 1), ("x", 1, 2), ("y", 1, 2)]);
    let mut queries = Vec::new();
    let names = [
        (
            ["counted linear least", "counted linear most"],
            ["linear least reached", "linear most reached"],
        ),
        (
            ["counted quantized least", "counted quantized most"],
            ["quantized least reached", "quantized most reached"],
        ),
    ];
    let reached = "the code's end is generated where both places are at an end or where the wall balances the force";
    for (of, (bounds, ends)) in names.into_iter().enumerate() {
        let ([low, high], here) = (&found[of], &here[of]);
        for (part, end, goal) in [
            (bounds[0], low, le(low, here)),
            (bounds[1], high, le(here, high)),
        ] {
            queries.push(
                Query::new("TH-COUNTS", part, "wherever within their ticks the positions are, generated energy is not beyond the end that the code finds")
                    .given(in_ticks())
                    .then(goal)
                    .but_not("it is not always there", eq(end, here))
                    .at(example.clone()),
            );
        }
        for (part, end, place) in [(ends[0], low, &at_least[of]), (ends[1], high, &at_most[of])] {
            queries.push(
                Query::new("TH-COUNTS", part, reached)
                    .given(in_ticks())
                    .given([place.clone()])
                    .then(eq(end, here))
                    .not_without("elsewhere it is not", 1)
                    .at(example.clone()),
            );
        }
    }
    queries
}

/// What is asked of k: ahead, at rest, back.
const NAMES: [[&str; 3]; 3] = [
    [
        "least linear net ahead",
        "least linear net of a tick",
        "least linear net back",
    ],
    [
        "most linear net ahead",
        "most linear net of a tick",
        "most linear net back",
    ],
    [
        "least quantized net ahead",
        "least quantized net of a tick",
        "least quantized net back",
    ],
];

/// For each displacement net energy is within the parabolas that the code takes the extremes of, and is on them where a
/// position is at an end of its tick, to which a line of equal displacement leads.
fn displacements() -> Vec<Query> {
    let (k, d) = (v("k"), displacement());
    let energies = generated_at(&v("x"), &v("y"));
    let taken = v("beta") * d.square() + v("sigma") * d.abs();
    let at_end = |end: i32| any(["x", "y"].map(|place| eq(&v(place), &n(end))));
    type Arcs = fn(&Crossing<Term>, &Resistance<Term>) -> [Arc<Term>; 2];
    let of: [(Arcs, usize, bool); 3] = [
        (Crossing::least_linear, 0, true),
        (Crossing::most_linear, 0, false),
        (Crossing::least_quantized, 1, true),
    ];
    let ways = [le(&n(1), &k), eq(&k, &n(0)), le(&k, &n(-1))];
    let mut queries = Vec::new();
    for ((arcs, account, is_least), names) in of.into_iter().zip(NAMES) {
        let found = paths::of(|| arcs(&crossing(), &friction()));
        let net = taken.clone() - energies[account].clone();
        for ((part, way), sign) in names.into_iter().zip(&ways).zip([1, 0, -1]) {
            // In which direction each part goes.
            let sides = match sign {
                1 => [1, 1],
                0 => [-1, 1],
                _ => [-1, -1],
            };
            let goal = |slack: i32| {
                on_every_path(&found, |arcs| {
                    let part = |arc: &Arc<Term>, before: bool, goes: i32| {
                        let along = n(goes) * d.clone();
                        let edge = n(goes) * k.clone();
                        // What of no tick goes back is all behind zero.
                        let is_below = before && sign != 0;
                        let here = if is_below {
                            le(&along, &edge)
                        } else {
                            le(&edge, &along)
                        };
                        let [from, to] = &arc.ends;
                        let value = arc.at(&along) + n(slack);
                        let bound = if is_least {
                            le(&value, &net)
                        } else {
                            le(&net, &value)
                        };
                        // The upper ends of the ticks are those of the least that is generated ahead.
                        let end = i32::from(is_least == (goes > 0));
                        let reached = implies(at_end(end), eq(&value, &net));
                        implies(here, all([between(from, &along, to), bound, reached]))
                    };
                    let [short, long] = arcs;
                    let [first, last] = sides;
                    all([part(short, true, first), part(long, false, last)])
                })
            };
            queries.push(
                Query::new("TH-COUNTS", part, "for each displacement net energy is within the parabola that the code takes the extremes of, and on it where a position is at an end of its tick")
                    .given(in_ticks())
                    .given([way.clone()])
                    .then(goal(0))
                    .but_not(
                        "a parabola that is moved by one is passed, or not reached",
                        goal(if is_least { 1 } else { -1 }),
                    )
                    .at(values([("x", 1, 2), ("y", 1, 2), ("k", sign, 1), ("f", 0, 1), ("beta", 1, 1), ("sigma", 1, 1)])),
            );
        }
    }
    queries
}

/// Net energy at the corners of the two ticks is what the code has there; against the quantized wall it is largest at
/// one of them.
fn corners() -> Vec<Query> {
    let k = v("k");
    let ([least, most], [first, last]) = crossing().net_at_corners(&friction());
    let net = |x: &Term, y: &Term| {
        let d = k.clone() + y.clone() - x.clone();
        let taken = v("beta") * d.square() + v("sigma") * d.abs();
        generated_at(x, y).map(|generated| taken.clone() - generated)
    };
    let (zero, one) = (n(0), n(1));
    let both = |x: &Term, y: &Term, is: &Term| {
        let [linear, quantized] = net(x, y);
        all([eq(&linear, is), eq(&quantized, is)])
    };
    let within = |x: &Term, y: &Term| {
        let [linear, quantized] = net(x, y);
        all([
            between(&least, &linear, &most),
            between(&least, &quantized, &most),
        ])
    };
    let goal = |last: &Term| {
        all([
            both(&one, &zero, &first),
            both(&zero, &one, last),
            within(&zero, &zero),
            within(&one, &one),
        ])
    };
    let reached = any([
        all([both(&zero, &zero, &most), both(&one, &one, &least)]),
        all([both(&zero, &zero, &least), both(&one, &one, &most)]),
    ]);
    let query = |part, (way, sign): (&Formula, i32), is_before: bool| {
        // What goes back is told of from the other ends of the ticks.
        let [x, y] = ["x", "y"].map(|place| match sign {
            -1 => n(1) - v(place),
            _ => v(place),
        });
        let [_, here] = net(&x, &y);
        let far = y - x;
        let (side, share, to) = match is_before {
            true => (le(&far, &zero), -far, &first),
            false => (le(&zero, &far), far, &last),
        };
        let chord = most.clone() + share * (to.clone() - most.clone());
        Query::new("TH-COUNTS", part, "where friction is not negative net energy against the quantized wall is not above the chord from one corner of the two ticks to the next")
            .given(in_ticks())
            .given([way.clone(), side, le(&n(0), &v("beta")), le(&n(0), &v("sigma"))])
            .then(le(&here, &chord))
            .but_not("with one more it is above", le(&(here.clone() + n(1)), &chord))
            .at(values([("x", 0, 1), ("y", 0, 1), ("k", sign, 1), ("f", 0, 1), ("beta", 1, 1), ("sigma", 1, 1)]))
    };
    let ways = [
        (
            ["chord before ahead", "chord behind ahead"],
            le(&n(1), &k),
            1,
        ),
        (
            ["chord before a tick", "chord behind a tick"],
            eq(&k, &n(0)),
            0,
        ),
        (
            ["chord before back", "chord behind back"],
            le(&k, &n(-1)),
            -1,
        ),
    ];
    let mut queries = Vec::new();
    for (parts, way, sign) in &ways {
        let sides = parts.iter().zip([true, false]);
        queries.extend(sides.map(|(part, is_before)| query(part, (way, *sign), is_before)));
    }
    queries.push(
        Query::new(
            "TH-COUNTS",
            "corners",
            "net energy at the corners of the two ticks is what the code has there",
        )
        .then(all([goal(&last), reached]))
        .but_not("ahead and back are not the same", goal(&first)),
    );
    queries
}

/// Nothing on a part of a parabola is beyond its ends and where it turns.
fn arcs() -> Vec<Query> {
    let (alpha, d, turn) = (v("alpha"), v("d"), v("T"));
    let (from, to) = (v("from"), v("to"));
    let arc = Arc {
        bend: Bend {
            square: alpha.clone(),
            turn: turn.clone(),
        },
        slope: v("gamma"),
        constant: v("kappa"),
        ends: [from.clone(), to.clone()],
    };
    let (here, ends, turns) = (arc.at(&d), [arc.at(&from), arc.at(&to)], arc.turn());
    let all_of = |of: fn(Term, Term) -> Term| ends.clone().into_iter().fold(turns.clone(), of);
    let [least, most] = [Term::min as fn(_, _) -> _, Term::max].map(all_of);
    let inverse = eq(&(alpha.double() * turn.clone()), &n(1));
    let (up, down) = (lt(&n(0), &alpha), lt(&alpha, &n(0)));
    let query =
        |part, of: Vec<Formula>, goal: Formula, (beyond, square, place): (Formula, i32, i32)| {
            Query::new(
                "TH-COUNTS",
                part,
                "no value on a part of a parabola is beyond those at its ends and where it turns",
            )
            .given([le(&from, &d), le(&d, &to)])
            .given(of)
            .then(goal)
            .but_not("one that is moved by one is passed", beyond)
            .at(values([
                ("from", 0, 1),
                ("to", 4, 1),
                ("d", place, 1),
                ("alpha", square, 1),
                ("gamma", 0, 1),
                ("kappa", 0, 1),
            ]))
        };
    let above = |slack: i32| le(&(least.clone() + n(slack)), &here);
    let below = |slack: i32| le(&(here.clone() + n(slack)), &most);
    let vertex = (-(arc.slope.clone() * turn))
        .max(from.clone())
        .min(to.clone());
    let bent_up = || vec![up.clone(), inverse.clone()];
    let bent_down = || vec![down.clone(), inverse.clone()];
    let straight = || vec![eq(&alpha, &n(0))];
    vec![
        query("arc up least", bent_up(), above(0), (above(1), 1, 0)),
        query("arc up most", bent_up(), below(0), (below(1), 1, 4)),
        query("arc down least", bent_down(), above(0), (above(1), -1, 4)),
        query("arc down most", bent_down(), below(0), (below(1), -1, 0)),
        query("arc straight least", straight(), above(0), (above(1), 0, 0)),
        query("arc straight most", straight(), below(0), (below(1), 0, 0)),
        Query::new(
            "TH-COUNTS",
            "arc turn",
            "where it turns is between the ends",
        )
        .given([le(&from, &to)])
        .then(all([
            between(&from, &vertex, &to),
            eq(&turns, &arc.at(&vertex)),
        ]))
        .but_not("it is not always at the start", eq(&turns, &arc.at(&from))),
    ]
}

/// How far it is from one tick to another, and what the potential is where the interval ends.
fn ends() -> Vec<Query> {
    let (k, y) = (v("k"), v("y"));
    let distance = displacement().abs();
    let found = paths::of(|| crossing().distances());
    let far = |slack: i32| {
        on_every_path(&found, |[near, far]| {
            between(&(near.clone() + n(slack)), &distance, far)
        })
    };
    let [least, most] = crossing().stored(&v("end"));
    let stored = |y: &Term| (v("end") + y.clone()).square().half() - v("f") * y.clone();
    let balance = (v("f") - v("end")).max(n(0)).min(n(1));
    let whole = any([le(&n(1), &k), eq(&k, &n(0)), le(&k, &n(-1))]);
    let in_tick = || [between(&n(0), &y, &n(1))];
    vec![
        Query::new("TH-COUNTS", "counted distances", "from one tick to another it is no nearer and no farther than the code says")
            .given(in_ticks())
            .given([whole])
            .then(far(0))
            .but_not("it may be no more than that", far(1)),
        Query::new("TH-COUNTS", "counted potential", "the potential where the interval ends, less what the excess does within the tick, is between the ends that the code finds")
            .given(in_tick())
            .then(between(&least, &stored(&y), &most))
            .but_not("it is not always the least", eq(&least, &stored(&y))),
        Query::new("TH-COUNTS", "counted potential reached", "it is least where the potential's slope is the excess, and most at an end")
            .given([eq(&y, &balance)])
            .then(all([
                between(&n(0), &y, &n(1)),
                eq(&least, &stored(&y)),
                any([eq(&most, &stored(&n(0))), eq(&most, &stored(&n(1)))]),
            ]))
            .not_without("elsewhere it is not", 1),
    ]
}
