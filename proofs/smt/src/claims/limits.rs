//! TH-START and TH-STIFF: how fast it can get, how stiff it may be.

use passivity_core::verdict::{Speeds, decide};
use passivity_core::{Criterion, Loop, Parameter, Scalar as _, spring, start, stiffness};
use passivity_terms::{Term, paths};

use super::words::{half, n, v};
use crate::Query;
use crate::formula::{
    Formula, all, eq, gt, iff, implies, le, lt, nonnegative, not, on_every_path, positive,
};

pub(super) fn queries() -> Vec<Query> {
    [unforced(), stiff()].concat()
}

fn criterion() -> Criterion<Term> {
    Criterion {
        viscous: v("viscous"),
        coulomb: v("coulomb"),
    }
}

/// What a yes and a no of `holds_up_to` mean at a speed up to V, given V ≥ 0.
fn unforced() -> Vec<Query> {
    let (mu, bound) = (v("mu"), v("bound"));
    let before = spring::storage(&mu, &v("x0"), &v("v0"));
    let later = spring::storage(&mu, &v("x1"), &v("v1"));
    let square = start::speed_squared(&mu, &v("x0"), &v("v0"));
    let criterion = criterion();
    let squares = paths::of(|| start::holds_up_to(&criterion, &bound.square()));
    let decided = paths::of(|| decide(&criterion, &Speeds::UpToSquared(bound.square())));
    let speed = [positive(&v("v")), le(&v("v"), &bound)];
    let holds = nonnegative(&criterion.margin(&v("v")));
    let fails_at_the_ends = crate::formula::any([
        lt(&criterion.margin(&bound), &n(0)),
        lt(&criterion.coulomb, &n(0)),
        all([eq(&criterion.coulomb, &n(0)), lt(&criterion.viscous, &n(0))]),
    ]);
    let yes = |answer: &Option<bool>| match answer {
        Some(true) => holds.clone(),
        Some(false) => fails_at_the_ends.clone(),
        None => Formula::Any(vec![]),
    };
    let no_squares = |answer: &Option<bool>| match answer {
        Some(_) => holds.clone(),
        None => Formula::Any(vec![]),
    };
    vec![
        Query::new(
            "TH-START",
            "energy",
            "while storage stays below that at the start, the speed stays below V",
        )
        .given([positive(&mu), le(&later, &before)])
        .then(le(&v("v1").square(), &square))
        .not_without("not when storage grows", 1),
        Query::new(
            "TH-START",
            "memory",
            "½μV² is the storage at the start, with what the controller remembers",
        )
        .given([positive(&mu)])
        .then(eq(
            &(mu.clone() * start::speed_squared_with_memory(&mu, &v("x0"), &v("v0"), &v("extra")))
                .half(),
            &(before.clone() + v("extra")),
        ))
        .but_not(
            "without what it remembers it is not",
            eq(
                &(mu.clone() * square.clone()).half(),
                &(before.clone() + v("extra")),
            ),
        ),
        Query::new(
            "TH-START",
            "storage of v",
            "½μV² is the storage at the start",
        )
        .given([positive(&mu)])
        .then(eq(&(mu.clone() * square.clone()).half(), &before))
        .but_not("½μξ̇² is not", eq(&spring::kinetic(&mu, &v("v0")), &before)),
        Query::new(
            "TH-START",
            "squares",
            "compared in squares, the answer is that of every speed up to V",
        )
        .given([positive(&bound)])
        .given(speed.clone())
        .then(on_every_path(&squares, yes))
        .but_not("it is not always yes", on_every_path(&squares, no_squares)),
        Query::new(
            "TH-START",
            "decision",
            "the decision up to V is that of every speed up to V",
        )
        .given([positive(&bound)])
        .given(speed)
        .then(on_every_path(&decided, |decision| {
            yes(&decision.map(|d| d.holds))
        }))
        .but_not(
            "it is not always yes",
            on_every_path(&decided, |decision| no_squares(&decision.map(|d| d.holds))),
        ),
        Query::new(
            "TH-START",
            "margin of squares",
            "for viscous < 0 < coulomb the margin of squares has the sign of the margin at V",
        )
        .given([
            positive(&bound),
            lt(&criterion.viscous, &n(0)),
            gt(&criterion.coulomb, &n(0)),
        ])
        .then(iff(
            nonnegative(&start::margin_of_squares(&criterion, &bound.square())),
            nonnegative(&criterion.margin(&bound)),
        ))
        .not_without("not for a negative coulomb", 1),
    ]
}

/// A loop in units with everything that costs friction, and its delay.
fn in_units(delay: u16) -> Loop<Term> {
    Loop {
        viscous: Some(v("b")),
        coulomb: Some(v("c")),
        resolution: Some(v("Delta")),
        damping: Some(v("B")),
        force_step: Some(v("F")),
        delay,
        ..Loop::new(v("K"), v("T"))
    }
}

fn units_are_positive() -> [Formula; 3] {
    [positive(&v("K")), positive(&v("T")), positive(&v("Delta"))]
}

fn stiff() -> Vec<Query> {
    let plain = Loop {
        damping: None,
        force_step: None,
        ..in_units(0)
    };
    let (b, c, t, delta, speed) = (v("b"), v("c"), v("T"), v("Delta"), v("v"));
    let late = in_units(2);
    let k = v("K");
    let stiffer = late.clone().with(Parameter::Stiffness, v("K1"));
    let at_speed = |the_loop: &Loop<Term>| nonnegative(&the_loop.criterion().margin(&v("v")));
    let all_speeds =
        |the_loop: &Loop<Term>| nonnegative(&the_loop.criterion().margin_at_all_speeds());
    let up_to = |the_loop: &Loop<Term>| nonnegative(&the_loop.criterion().margin_up_to(&v("v")));
    let at_period = |period: &Term| {
        late.clone()
            .with(Parameter::Period, period.clone())
            .criterion()
    };
    let shortest = stiffness::shortest_period(&late).unwrap_or_else(|| n(0));
    let best = stiffness::best_period_at_speed(&late, &v("v"));
    let times_period = at_period(&v("T1")).margin(&v("v")) * v("T1");
    let per_square = k.clone() * (n(2) + half()) * v("v");
    let peak = per_square.clone() * best.square() - v("B") * delta.clone();
    let lost = per_square * (v("T1") - best.clone()).square();
    let undamped = Loop {
        damping: None,
        ..late.clone()
    };
    let critical = passivity_core::region::critical_speed(&plain.criterion());
    let given = |query: Query| query.given(units_are_positive()).given([positive(&speed)]);
    vec![
        given(Query::new(
            "TH-STIFF",
            "closed forms",
            "without effects the limits are 2b/T, 2c/Δ and 2(bv + c)/(Tv + Δ)",
        ))
        .then(all([
            eq(
                &stiffness::viscous_limit(&plain),
                &b.double().over(t.clone()),
            ),
            eq(
                &stiffness::coulomb_limit(&plain).unwrap_or_else(|| n(0)),
                &c.double().over(delta.clone()),
            ),
            eq(
                &stiffness::limit_at_speed(&plain, &speed),
                &(b.clone() * speed.clone() + c.clone())
                    .double()
                    .over(t.clone() * speed.clone() + delta.clone()),
            ),
        ]))
        .but_not(
            "not b/T",
            eq(
                &stiffness::viscous_limit(&plain),
                &b.clone().over(t.clone()),
            ),
        ),
        given(Query::new(
            "TH-STIFF",
            "at a speed",
            "K is admissible at a speed exactly up to the limit",
        ))
        .then(iff(
            at_speed(&plain),
            le(&k, &stiffness::limit_at_speed(&plain, &speed)),
        ))
        .but_not(
            "twice the limit is too much",
            implies(
                le(&k, &stiffness::limit_at_speed(&plain, &speed).double()),
                at_speed(&plain),
            ),
        ),
        given(Query::new(
            "TH-STIFF",
            "at all speeds",
            "K is admissible at every speed exactly up to the limit",
        ))
        .then(iff(
            all_speeds(&plain),
            le(&k, &stiffness::limit_at_all_speeds(&plain)),
        ))
        .but_not(
            "it is not the larger of the two",
            iff(
                all_speeds(&plain),
                le(
                    &k,
                    &stiffness::viscous_limit(&plain)
                        .max(stiffness::coulomb_limit(&plain).unwrap_or_else(|| n(0))),
                ),
            ),
        ),
        given(Query::new(
            "TH-STIFF",
            "up to a speed",
            "K is admissible up to a speed exactly up to the limit",
        ))
        .then(iff(
            up_to(&plain),
            le(&k, &stiffness::limit_up_to_speed(&plain, &speed)),
        ))
        .but_not(
            "the limit at the speed is not enough",
            iff(
                up_to(&plain),
                le(&k, &stiffness::limit_at_speed(&plain, &speed)),
            ),
        ),
        given(Query::new(
            "TH-STIFF",
            "at a speed with effects",
            "with two samples of delay, damping and force steps the limit is exact too",
        ))
        .then(iff(
            at_speed(&late),
            le(&k, &stiffness::limit_at_speed(&late, &speed)),
        ))
        .but_not(
            "it is not that of the plain loop",
            iff(
                at_speed(&late),
                le(&k, &stiffness::limit_at_speed(&plain, &speed)),
            ),
        ),
        given(Query::new(
            "TH-STIFF",
            "at all speeds with effects",
            "with two samples of delay, damping and force steps the limit is exact too",
        ))
        .then(iff(
            all_speeds(&late),
            le(&k, &stiffness::limit_at_all_speeds(&late)),
        ))
        .but_not(
            "it is not that of the plain loop",
            iff(
                all_speeds(&late),
                le(&k, &stiffness::limit_at_all_speeds(&plain)),
            ),
        ),
        given(Query::new(
            "TH-STIFF",
            "friction needed",
            "the least friction brings the margin to zero",
        ))
        .then(all([
            eq(
                &late.clone().with(Parameter::Viscous, stiffness::viscous_needed(&late))
                .criterion()
                .viscous,
                &n(0),
            ),
            eq(
                &late.clone().with(Parameter::Coulomb, stiffness::coulomb_needed(&late))
                .criterion()
                .coulomb,
                &n(0),
            ),
            eq(
                &late.clone().with(Parameter::Viscous, stiffness::viscous_needed_at_speed(&late, &speed))
                .criterion()
                .margin(&speed),
                &n(0),
            ),
            eq(
                &late.clone().with(Parameter::Coulomb, stiffness::coulomb_needed_up_to_speed(&late, &speed))
                .criterion()
                .margin_up_to(&speed),
                &n(0),
            ),
        ]))
        .but_not(
            "twice of it does not",
            eq(
                &late.clone().with(Parameter::Viscous, stiffness::viscous_needed(&late).double())
                .criterion()
                .viscous,
                &n(0),
            ),
        ),
        given(Query::new(
            "TH-STIFF",
            "period and resolution",
            "the longest period and the coarsest encoder bring the margin to zero",
        ))
        .given([
            positive(&stiffness::longest_period(&late)),
            positive(&v("B")),
        ])
        .then(all([
            eq(
                &late.clone().with(Parameter::Period, stiffness::longest_period(&late))
                .criterion()
                .viscous,
                &n(0),
            ),
            eq(
                &late.clone().with(Parameter::Resolution, stiffness::coarsest_resolution(&late).unwrap_or_else(|| n(0)))
                .criterion()
                .coulomb,
                &n(0),
            ),
        ]))
        .but_not(
            "the period as it is need not",
            eq(&late.criterion().viscous, &n(0)),
        ),
        given(Query::new(
            "TH-STIFF",
            "shortest period",
            "what Coulomb friction has to spare, times the period, grows from zero at the shortest period",
        ))
        .given([positive(&undamped.criterion().coulomb), positive(&v("T1"))])
        .then(eq(
            &(at_period(&v("T1")).coulomb * v("T1")),
            &(undamped.criterion().coulomb * (v("T1") - shortest)),
        ))
        .but_not("it does not stay", eq(
            &at_period(&v("T1")).coulomb,
            &undamped.criterion().coulomb,
        )),
        given(Query::new(
            "TH-STIFF",
            "best period",
            "at a speed the margin times the period is a parabola that opens downwards, with its peak at the best period",
        ))
        .given([positive(&v("T1"))])
        .then(eq(&times_period, &(peak.clone() - lost)))
        .but_not("it is not flat", eq(&times_period, &peak)),
        given(Query::new(
            "TH-STIFF",
            "critical speed",
            "v_c is (c − KΔ/2)/(KT/2 − b), for b < KT/2",
        ))
        .given([lt(&b, &(k.clone() * t.clone()).half())])
        .then(all([
            eq(
                &critical,
                &(c - (k.clone() * delta).half()).over((k.clone() * t).half() - b),
            ),
            iff(at_speed(&plain), le(&speed, &critical)),
        ]))
        .but_not(
            "above it the criterion fails",
            implies(positive(&critical), at_speed(&plain)),
        ),
        given(Query::new(
            "TH-STIFF",
            "dimensionless",
            "with units and without, the criterion has the same sign",
        ))
        .then(iff(
            at_speed(&late),
            nonnegative(
                &late
                    .dimensionless_criterion()
                    .margin(&late.dimensionless_speed(&speed)),
            ),
        ))
        .but_not(
            "not at a speed that keeps its units",
            iff(
                at_speed(&late),
                nonnegative(&late.dimensionless_criterion().margin(&speed)),
            ),
        ),
        given(Query::new(
            "TH-STIFF",
            "stiffer never helps",
            "where a stiffer wall is admissible, a softer one is",
        ))
        .given([gt(&v("K1"), &k), nonnegative(&v("B")), nonnegative(&v("F"))])
        .then(implies(
            at_speed(&stiffer),
            at_speed(&late),
        ))
        .but_not(
            "but not the other way round",
            implies(
                at_speed(&late),
                not(not(at_speed(&stiffer))),
            ),
        ),
    ]
}
