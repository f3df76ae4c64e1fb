//! (23) to (27), TH-INTERVAL, TH-RUN, TH-JITTER and TH-REGION: friction against generation.

use passivity_core::dissipation::mean_speed;
use passivity_core::generation::bound_22;
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::region::critical_speed;
use passivity_core::{Criterion, Friction, Loop, Region, Scalar as _, Step, spring};
use passivity_terms::{Term, paths};

use super::words::{half, n, v};
use crate::Query;
use crate::formula::{
    Formula, all, any, eq, ge, gt, iff, implies, le, lt, nonnegative, on_every_path, positive,
};

fn friction() -> Friction<Term> {
    Friction::new(v("beta"), v("sigma"))
}

pub(super) fn queries() -> Vec<Query> {
    [dissipation(), interval(), region()].concat()
}

fn dissipation() -> Vec<Query> {
    let friction = friction();
    let (d1, d2, t1, t2) = (v("d1"), v("d2"), v("t1"), v("t2"));
    let least = |d: &Term, t: &Term| friction.dissipated_lower(d, &mean_speed(d, t));
    let (d, t) = (d1.clone() + d2.clone(), t1.clone() + t2.clone());
    let viscous =
        |d: &Term, t: &Term| Friction::new(v("beta"), n(0)).dissipated_lower(d, &mean_speed(d, t));
    let coulomb =
        |d: &Term, t: &Term| Friction::new(n(0), v("sigma")).dissipated_lower(d, &mean_speed(d, t));
    let squared = friction.beta.clone() * d1.square().over(t1.clone());
    let written_out = squared + friction.sigma.clone() * d1.abs();
    let speed = mean_speed(&d1, &t1);
    vec![
        Query::new(
            "EQ-23..26",
            "formula",
            "the least that a step dissipates is βd²/Δτ + σ|d|",
        )
        .given([positive(&t1)])
        .then(eq(&least(&d1, &t1), &written_out))
        .but_not(
            "it is not half of that",
            eq(&least(&d1, &t1).double(), &written_out),
        ),
        Query::new(
            "EQ-23..26",
            "constant velocity",
            "at constant velocity the least is what is dissipated",
        )
        .given([positive(&t1)])
        .then(eq(
            &friction.dissipated_at_constant_velocity(&v("v"), &t1),
            &least(&(v("v") * t1.clone()), &t1),
        ))
        .but_not(
            "not so over twice the time",
            eq(
                &friction.dissipated_at_constant_velocity(&v("v"), &t1),
                &least(&(v("v") * t1.clone()), &t1.double()),
            ),
        ),
        Query::new(
            "EQ-23..26",
            "merging viscous",
            "viscous friction dissipates at least as much in two pieces as in the whole (25)",
        )
        .given([nonnegative(&friction.beta), positive(&t1), positive(&t2)])
        .then(ge(
            &(viscous(&d1, &t1) + viscous(&d2, &t2)),
            &viscous(&d, &t),
        ))
        .but_not(
            "sometimes more",
            eq(&(viscous(&d1, &t1) + viscous(&d2, &t2)), &viscous(&d, &t)),
        ),
        Query::new(
            "EQ-23..26",
            "merging coulomb",
            "Coulomb friction dissipates at least as much in two pieces as in the whole (24)",
        )
        .given([nonnegative(&friction.sigma), positive(&t1), positive(&t2)])
        .then(ge(
            &(coulomb(&d1, &t1) + coulomb(&d2, &t2)),
            &coulomb(&d, &t),
        ))
        .but_not(
            "sometimes more",
            eq(&(coulomb(&d1, &t1) + coulomb(&d2, &t2)), &coulomb(&d, &t)),
        ),
        Query::new("EQ-23..26", "merging sum", "what both dissipate is the sum")
            .given([positive(&t1)])
            .then(eq(
                &least(&d1, &t1),
                &(viscous(&d1, &t1) + coulomb(&d1, &t1)),
            ))
            .but_not(
                "not viscous friction alone",
                eq(&least(&d1, &t1), &viscous(&d1, &t1)),
            ),
        Query::new(
            "EQ-27",
            "formula",
            "the surplus is (β − ½)d²/Δτ + (σ − ½)|d|",
        )
        .given([positive(&t1)])
        .then(eq(
            &Criterion::of_friction(&friction).surplus(&d1, &speed),
            &((friction.beta.clone() - half()) * d1.square().over(t1.clone())
                + (friction.sigma.clone() - half()) * d1.abs()),
        ))
        .but_not(
            "with the sign of a half changed it is another",
            eq(
                &Criterion::of_friction(&friction).surplus(&d1, &speed),
                &((friction.beta.clone() - half()) * d1.square().over(t1.clone())
                    + (friction.sigma.clone() + half()) * d1.abs()),
            ),
        ),
        Query::new(
            "EQ-27",
            "same as 8",
            "(27) holds of a move exactly where (8) holds at its mean speed",
        )
        .given([positive(&t1), any([lt(&d1, &n(0)), gt(&d1, &n(0))])])
        .then(iff(
            nonnegative(&Criterion::of_friction(&friction).surplus(&d1, &speed)),
            ge(
                &(friction.beta.clone() + friction.sigma.clone().over(speed.clone())),
                &(half() + half().over(speed.clone())),
            ),
        ))
        .but_not(
            "(8) without the half of quantization is another",
            iff(
                nonnegative(&Criterion::of_friction(&friction).surplus(&d1, &speed)),
                ge(
                    &(friction.beta.clone() + friction.sigma.clone().over(speed)),
                    &half(),
                ),
            ),
        ),
        Query::new(
            "EQ-27",
            "critical line",
            "on the line (9) the margin is zero",
        )
        .then(eq(
            &Criterion::of_friction(&Friction::new(
                v("beta"),
                Criterion::critical_sigma(&v("beta"), &v("v")),
            ))
            .margin(&v("v")),
            &n(0),
        ))
        .but_not(
            "at another speed it is not",
            eq(
                &Criterion::of_friction(&Friction::new(
                    v("beta"),
                    Criterion::critical_sigma(&v("beta"), &v("v")),
                ))
                .margin(&v("v").double()),
                &n(0),
            ),
        ),
    ]
}

fn interval() -> Vec<Query> {
    let friction = friction();
    let (step, dtau) = (Step::new(v("x0"), v("x1")), v("dtau"));
    let d = step.displacement();
    let row = ledger::row(
        &Loop::plain(friction.clone()),
        &HeldInterval::plain(step.clone(), dtau.clone()),
    );
    let jitter = ledger::jitter_bound(&friction, &d, &mean_speed(&d, &dtau));
    let jitter_written_out = (friction.beta.clone().over(dtau.clone()) - half()) * d.square()
        + (friction.sigma.clone() - half()) * d.abs();
    let work = ledger::operator_work(&v("stored"), &v("after"), &v("dissipated"), &v("generated"));
    let at_most_one = le(&dtau, &n(1));
    vec![
        Query::new("TH-INTERVAL", "first half", "whatever the step, E_gᴸ is at most ½d² + ½|d|")
            .given([positive(&dtau)])
            .then(le(&row.generated_linear, &row.bound_22))
            .but_not("E_g is not", le(&row.generated_quantized, &row.bound_22)),
        Query::new("TH-INTERVAL", "second half", "where (8) holds, ½d² + ½|d| is at most what is dissipated")
            .given([positive(&dtau), nonnegative(&row.margin), at_most_one.clone()])
            .then(le(&row.bound_22, &row.dissipated_lower))
            .not_without("not in an interval longer than a sampling period", 1),
        Query::new("TH-INTERVAL", "whole", "where (8) holds, no more is generated than dissipated")
            .given([positive(&dtau), at_most_one, nonnegative(&row.margin)])
            .then(nonnegative(&row.net_linear))
            .not_without("not where (8) does not hold", 1),
        Query::new("TH-RUN", "step", "what was drawn and what is stored stay below the storage at the start, interval by interval")
            .given([
                le(&(v("drawn") + v("stored")), &v("first")),
                le(&v("generated"), &v("dissipated")),
            ])
            .then(le(&(v("drawn") - work.clone() + v("after")), &v("first")))
            .not_without("not when more is generated than dissipated", 1),
        Query::new("TH-RUN", "end", "storage is not negative, so what was drawn stays below the storage at the start")
            .given([
                positive(&v("mu")),
                le(&(v("drawn") + spring::storage(&v("mu"), &v("x"), &v("v"))), &v("first")),
            ])
            .then(le(&v("drawn"), &v("first")))
            .not_without("not when it is not accounted for", 1),
        Query::new("TH-RUN", "quantized storage", "against the paper's own storage the account is the same up to 1/8")
            .given([positive(&v("mu"))])
            .then(all([
                nonnegative(&(spring::quantized_storage(&v("mu"), &v("x"), &v("v"))
                    - spring::storage(&v("mu"), &v("x"), &v("v")))),
                le(
                    &(spring::quantized_storage(&v("mu"), &v("x"), &v("v"))
                        - spring::storage(&v("mu"), &v("x"), &v("v"))),
                    &Term::fraction(1, 8),
                ),
            ]))
            .but_not(
                "not exactly",
                eq(
                    &spring::quantized_storage(&v("mu"), &v("x"), &v("v")),
                    &spring::storage(&v("mu"), &v("x"), &v("v")),
                ),
            ),
        Query::new("TH-JITTER", "formula", "the bound is (β/Δτ − ½)d² + (σ − ½)|d|")
            .given([positive(&dtau)])
            .then(eq(&jitter, &jitter_written_out))
            .but_not("with Δτ of one for all it is another", eq(&ledger::jitter_bound(&friction, &d, &d.abs()), &jitter_written_out)),
        Query::new("TH-JITTER", "bound", "E_d − E_gᴸ is at least the bound in an interval of any length")
            .given([positive(&dtau)])
            .then(ge(&row.net_linear, &jitter))
            .but_not("it is not the bound", eq(&row.net_linear, &jitter)),
        Query::new("TH-JITTER", "short intervals", "for Δτ ≤ 1 the criterion makes the bound non-negative")
            .given([positive(&dtau), nonnegative(&row.margin), le(&dtau, &n(1))])
            .then(nonnegative(&jitter))
            .not_without("for Δτ > 1 it does not", 1),
        Query::new("TH-JITTER", "bound of 22", "the bound is what friction dissipates less ½d² + ½|d|")
            .given([positive(&dtau)])
            .then(eq(&jitter, &(row.dissipated_lower.clone() - bound_22(&d))))
            .but_not("not less E_gᴸ", eq(&jitter, &row.net_linear)),
    ]
}

fn region() -> Vec<Query> {
    let criterion = Criterion::of_friction(&friction());
    let speed = v("v");
    let holds = nonnegative(&criterion.margin(&speed));
    let critical = critical_speed(&criterion);
    let paths = paths::of(|| Region::of(&criterion));
    let meaning = |region: &Option<Region>| match region {
        Some(Region::GloballyStable) => holds.clone(),
        Some(Region::Unstable) => crate::formula::not(holds.clone()),
        Some(Region::LocallyStable) => all([
            positive(&critical),
            iff(holds.clone(), le(&speed, &critical)),
        ]),
        Some(Region::LimitCycles) => all([
            positive(&critical),
            iff(holds.clone(), ge(&speed, &critical)),
        ]),
        None => Formula::Any(vec![]),
    };
    let swapped = |region: &Option<Region>| match region {
        Some(Region::LocallyStable) => iff(holds.clone(), ge(&speed, &critical)),
        other => meaning(other),
    };
    vec![
        Query::new(
            "TH-REGION",
            "speeds",
            "a region is the set of speeds at which the criterion holds",
        )
        .given([positive(&speed)])
        .then(on_every_path(&paths, meaning))
        .but_not(
            "with the inequality of local stability turned round it is not",
            on_every_path(&paths, swapped),
        ),
        Query::new(
            "TH-REGION",
            "all speeds",
            "where the smaller coefficient is not negative the criterion holds at every speed",
        )
        .given([
            positive(&speed),
            nonnegative(&criterion.margin_at_all_speeds()),
        ])
        .then(holds.clone())
        .not_without("else it does not", 1),
        Query::new(
            "TH-REGION",
            "up to a speed",
            "the margin up to a speed is the least of the margins up to it",
        )
        .given([positive(&speed), le(&speed, &v("bound"))])
        .then(all([
            ge(
                &criterion.margin(&speed),
                &criterion.margin_up_to(&v("bound")),
            ),
            any([
                eq(
                    &criterion.margin_up_to(&v("bound")),
                    &criterion.margin(&v("bound")),
                ),
                eq(&criterion.margin_up_to(&v("bound")), &criterion.coulomb),
            ]),
        ]))
        .but_not(
            "the margin at the bound is not",
            implies(
                positive(&speed),
                ge(&criterion.margin(&speed), &criterion.margin(&v("bound"))),
            ),
        ),
    ]
}
