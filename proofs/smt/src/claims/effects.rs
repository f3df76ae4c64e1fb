//! TH-LAW to TH-DAMP: what each effect of a loop costs a step, and all of them together.

use passivity_core::controller::rounded;
use passivity_core::extra_storage::{
    damping_storage, delay_storage, generated_by_damping, generated_by_delay,
};
use passivity_core::generation::{bound_22, generated};
use passivity_core::{Friction, Law, Loop, Scalar as _, Step, spring};
use passivity_terms::Term;

use super::words::{half, n, v, values};
use crate::Query;
use crate::formula::{all, eq, ge, gt, iff, le, nonnegative, positive};

pub(super) fn queries() -> Vec<Query> {
    [laws(), single()].concat()
}

/// ½d² + ½|d| as the theorem has it for a law: V(ξ + d) − V(ξ) − f(ξ + e)d.
fn generated_by_law(law: &Law<Term>) -> Term {
    let (xi, d) = (v("x"), v("d"));
    law.potential(&(xi.clone() + d.clone())) - law.potential(&xi) - law.force(&(xi + v("e"))) * d
}

/// V(ξ + d) − V(ξ) − f(ξ)d: with the position known.
fn held_exactly(law: &Law<Term>) -> Term {
    let (xi, d) = (v("x"), v("d"));
    law.potential(&(xi.clone() + d.clone())) - law.potential(&xi) - law.force(&xi) * d
}

/// (f(ξ) − f(ξ + e))d: what the error e of the measurement adds.
fn measured(law: &Law<Term>) -> Term {
    (law.force(&v("x")) - law.force(&(v("x") + v("e")))) * v("d")
}

fn laws() -> Vec<Query> {
    let (xi, d) = (v("x"), v("d"));
    let error = le(&v("e").abs(), &half());
    let one_sided = Law {
        lower: Some(v("lower")),
        upper: None,
    };
    let clamped = Law {
        lower: Some(v("lower")),
        upper: Some(v("upper")),
    };
    let ends = [le(&v("lower"), &n(0)), nonnegative(&v("upper"))];
    let bound = bound_22(&d);
    let (start, end) = (v("x0"), v("x1"));
    let by_encoder = |law: &Law<Term>| {
        let step = Step::new(v("x0"), v("x1"));
        generated(
            &law.held_force(&v("x0")),
            &step,
            &law.potential(&v("x0")),
            &law.potential(&v("x1")),
        )
    };
    let uni = Law::unilateral();
    let smooth_held = -start.clone();
    let smooth = generated(
        &smooth_held,
        &Step::new(start.clone(), end.clone()),
        &spring::linear_potential(&start),
        &spring::linear_potential(&end),
    );
    let displacement = end.clone() - start.clone();
    let friction = || Friction::new(v("beta"), v("sigma"));
    vec![
        Query::new(
            "TH-LAW",
            "one limit",
            "a spring with one limit of its force generates at most ½d² + ½|d|",
        )
        .given([le(&v("lower"), &n(0)), error.clone()])
        .then(le(&generated_by_law(&one_sided), &bound))
        .not_without("not with a larger error of measurement", 1),
        Query::new("TH-LAW", "two limits", "with two limits of its force it generates at most ½d² + ½|d|: the law held from the position itself, at most ½d²")
            .given(ends.clone())
            .then(le(&held_exactly(&clamped), &d.square().half()))
            .but_not("more than ¼d²", le(&held_exactly(&clamped), &d.square().half().half())),
        Query::new("TH-LAW", "two limits measured", "an error of measurement of at most ½ adds at most ½|d|")
            .given(ends.clone())
            .given([error.clone()])
            .then(le(&measured(&clamped), &d.abs().half()))
            .not_without("a larger error adds more", 1),
        Query::new("TH-LAW", "two limits sum", "both together are what the law generates")
            .then(eq(&(held_exactly(&clamped) + measured(&clamped)), &generated_by_law(&clamped)))
            .but_not("not one alone", eq(&held_exactly(&clamped), &generated_by_law(&clamped))),
        Query::new(
            "TH-LAW",
            "lipschitz",
            "the law is nowhere stiffer than the wall",
        )
        .given(ends)
        .then(le(
            &(clamped.force(&(xi.clone() + d.clone())) - clamped.force(&xi)).abs(),
            &d.abs(),
        ))
        .but_not(
            "nor is it half as stiff",
            le(
                &(clamped.force(&(xi.clone() + d.clone())) - clamped.force(&xi)).abs(),
                &d.abs().half(),
            ),
        ),
        Query::new("TH-LAW", "saturated", "a limit of the force clips it")
            .given([nonnegative(&v("limit"))])
            .then(eq(
                &Law::bilateral().saturated(v("limit")).force(&xi),
                &xi.clone().min(v("limit")).max(-v("limit")),
            ))
            .but_not(
                "it does not leave it",
                eq(&Law::bilateral().saturated(v("limit")).force(&xi), &xi),
            ),
        Query::new(
            "TH-UNI",
            "bound",
            "the wall on one side, behind an encoder, generates at most ½d² + ½|d|",
        )
        .then(le(&by_encoder(&uni), &bound_22(&displacement)))
        .but_not(
            "more than ½d²",
            le(&by_encoder(&uni), &displacement.square().half()),
        ),
        Query::new(
            "TH-UNI",
            "outside",
            "outside it pushes with nothing, and stores nothing",
        )
        // Behind the wall the tick is −1 or below: all that whole numbers say here.
        .given([le(&start.floor(), &n(-1)), le(&start, &n(0))])
        .then(all([
            eq(&uni.held_force(&start), &n(0)),
            eq(&uni.potential(&start), &n(0)),
        ]))
        .not_without("inside it does", 2),
        Query::new(
            "TH-SMOOTH",
            "step",
            "without an encoder a step generates ½d², which is all that it costs",
        )
        .then(all([
            eq(&smooth, &displacement.square().half()),
            eq(&smooth, &Loop::smooth(friction()).cost().bound(&displacement)),
        ]))
        .but_not(
            "it is less than with one",
            eq(&smooth, &bound_22(&displacement)),
        ),
        Query::new(
            "TH-SMOOTH",
            "criterion",
            "without an encoder the ½ of quantization goes",
        )
        .then(all([
            eq(
                &Loop::smooth(friction()).criterion().viscous,
                &(v("beta") - half()),
            ),
            eq(&Loop::smooth(friction()).criterion().coulomb, &v("sigma")),
        ]))
        .but_not(
            "with one it stays",
            eq(&Loop::plain(friction()).criterion().coulomb, &v("sigma")),
        ),
        Query::new(
            "TH-SMOOTH",
            "colgate",
            "without Coulomb friction the criterion is b ≥ KT/2",
        )
        .given([
            positive(&v("K")),
            positive(&v("T")),
            positive(&v("v")),
        ])
        .then(iff(
            nonnegative(&colgate().criterion().margin(&v("v"))),
            ge(&v("b"), &(v("K") * v("T")).half()),
        ))
        .but_not(
            "not b ≥ KT",
            iff(
                nonnegative(&colgate().criterion().margin(&v("v"))),
                ge(&v("b"), &(v("K") * v("T"))),
            ),
        ),
    ]
}

fn colgate() -> Loop<Term> {
    Loop {
        viscous: Some(v("b")),
        ..Loop::new(v("K"), v("T"))
    }
}

/// The last `count` displacements, the latest first.
pub(super) fn past(count: usize) -> Vec<Term> {
    (1..=count).map(|j| v(&format!("d{j}"))).collect()
}

/// The history one step later: the new displacement first, the oldest forgotten.
pub(super) fn later(past: &[Term], d: &Term) -> Vec<Term> {
    let mut later = vec![d.clone()];
    later.extend_from_slice(past);
    later.truncate(past.len());
    later
}

fn single() -> Vec<Query> {
    let (d, step, force) = (v("d"), v("delta"), v("u"));
    let rounding = rounded(&force, &step, &n(1)) - force;
    let delay = |k: u16, part: &'static str, less: &'static str| {
        let past = past(usize::from(k));
        let drop = delay_storage(&past) - delay_storage(&later(&past, &d));
        let cost = n(i32::from(k)) * d.square();
        Query::new(
            "TH-DELAY",
            part,
            "the step pays k·d², what was stored before pays the rest",
        )
        .then(le(&generated_by_delay(&past, &d), &(cost.clone() + drop)))
        .but_not(less, le(&generated_by_delay(&past, &d), &cost))
    };
    let oldest = v("d2");
    let history = past(2);
    let drop = damping_storage(&v("B"), &history) - damping_storage(&v("B"), &later(&history, &d));
    let paid = v("B") * d.square() + v("B") * d.abs();
    // What the criterion subtracts.
    let cost = Loop {
        delay: 3,
        damping: Some(v("B")),
        force_step: Some(v("delta")),
        ..Loop::plain(Friction::new(v("beta"), v("sigma")))
    }
    .cost();
    let viscous = half() + n(3) + v("B");
    let coulomb = (n(1) + v("delta")).half() + v("B");
    vec![
        Query::new(
            "TH-DAC",
            "rounding",
            "rounding to steps of δ is off by at most ½δ",
        )
        .given([positive(&step)])
        .then(le(&rounding.abs(), &step.clone().half()))
        .but_not(
            "not by at most ⅓δ",
            le(&rounding.abs(), &(step.clone() * Term::fraction(1, 3))),
        )
        .at(values([("delta", 1, 1), ("u", 1, 2)])),
        Query::new("TH-DAC", "cost", "it adds at most ½δ|d|")
            .given([positive(&step), le(&v("r").abs(), &step.clone().half())])
            .then(le(&(v("r") * d.clone()), &(step.half() * d.abs())))
            .not_without("not for a larger error", 1),
        delay(1, "one sample", "the step alone does not pay for it"),
        delay(2, "two samples", "the step alone does not pay for it"),
        delay(3, "three samples", "the step alone does not pay for it"),
        Query::new(
            "TH-DELAY",
            "one sample more",
            "if k samples are paid for, k + 1 are: the induction over the delay",
        )
        // What k samples generate is d·s, with storage w before and w1 after, where each of the
        // k weights of `w` is a half more than in `w1`; one sample more adds d·d2 and its storage.
        .given([le(
            &(d.clone() * v("s")),
            &(v("k") * d.square() + v("w") - v("w1")),
        )])
        .then(le(
            &(d.clone() * (v("s") + v("old"))),
            &((v("k") + n(1)) * d.square() + v("w") - v("w1")
                + (v("old").square() - d.square()).half()),
        ))
        .not_without("not otherwise", 1),
        Query::new(
            "TH-DAMP",
            "cost",
            "the step pays B·d² + B·|d|, what was stored before pays the rest",
        )
        .given([nonnegative(&v("B")), le(&(v("q") - oldest).abs(), &n(1))])
        .then(le(
            &generated_by_damping(&v("B"), &v("q"), &d),
            &(paid + drop),
        ))
        .not_without("not when the encoder is off by more than a tick", 1),
        Query::new(
            "TH-DAMP",
            "encoder",
            "the ticks between two samples differ from the way by less than one",
        )
        .then({
            let ticks = v("x1").floor() - v("x0").floor();
            let error = (ticks - (v("x1") - v("x0"))).abs();
            gt(&n(1), &error)
        })
        .but_not("not by less than ½", {
            let ticks = v("x1").floor() - v("x0").floor();
            let error = (ticks - (v("x1") - v("x0"))).abs();
            gt(&half(), &error)
        }),
        Query::new("TH-DELAY", "criterion", "the costs of the effects add")
            .then(all([
                eq(&cost.viscous, &viscous),
                eq(&cost.coulomb, &coulomb),
                eq(
                    &cost.bound(&d),
                    &(viscous * d.square() + coulomb.clone() * d.abs()),
                ),
            ]))
            .but_not(
                "B is charged to both",
                eq(&cost.coulomb, &(coulomb - v("B"))),
            ),
    ]
}
