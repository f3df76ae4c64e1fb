//! (16) to (22): the two springs and what one step generates.

use passivity_core::generation::{
    bound_21, bound_22, bound_quantized, generated, generated_as_in_19, generated_linear,
    generated_quantized, quantization_effect,
};
use passivity_core::quantizer::held_force;
use passivity_core::spring::{linear_potential, quantization_potential, quantized_potential};
use passivity_core::{Quantized, Scalar as _, Step, ledger};
use passivity_terms::Term;

use super::words::{half, n, v, values};
use crate::Query;
use crate::formula::{Formula, all, any, eq, ge, gt, le, lt, nonnegative};

/// A step between two positions of which nothing is known.
fn step() -> Step<Term> {
    Step::new(v("x0"), v("x1"))
}

/// (18) with the held force (5) and a potential.
fn by_18(potential: fn(&Term) -> Term) -> Term {
    let step = step();
    generated(
        &held_force(&step.start),
        &step,
        &potential(&step.start),
        &potential(&step.end),
    )
}

/// What whole numbers allow: the ticks crossed by a distance of N whole ticks and a bit.
fn ticks_are_the_whole_distance_or_one_more() -> Formula {
    let (step, zero) = (step(), n(0));
    let d = step.displacement();
    let (ticks, whole) = (step.ticks(), d.abs().floor());
    any([
        all([
            ge(&d, &zero),
            any([eq(&ticks, &whole), eq(&ticks, &(whole.clone() + n(1)))]),
        ]),
        all([
            le(&d, &zero),
            any([eq(&ticks, &-whole.clone()), eq(&ticks, &-(whole + n(1)))]),
        ]),
    ])
}

pub(super) fn queries() -> Vec<Query> {
    let step = step();
    let d = step.displacement();
    let rho_0 = Quantized::of(&step.start).residue;
    let linear = generated_linear(&step);
    let quantized = generated_quantized(&step);
    let effect = quantization_effect(&step);
    let difference = quantized.clone() - linear.clone();
    let potential_change = quantization_potential(&step.end) - quantization_potential(&step.start);
    vec![
        Query::new("EQ-16/17", "within a tick", "within a tick the potential rises by the held force times the way")
            .given([eq(&step.start.floor(), &step.end.floor())])
            .then(eq(
                &(quantized_potential(&step.end) - quantized_potential(&step.start)),
                &-(held_force(&step.start) * d.clone()),
            ))
            .not_without("across a tick it does not", 1),
        Query::new("EQ-16/17", "across a tick", "from inside a tick to its upper end the potential rises by the held force times the way")
            .given([
                eq(&step.end, &(step.start.floor() + n(1))),
                eq(&step.end.floor(), &step.end),
            ])
            .then(eq(
                &(quantized_potential(&step.end) - quantized_potential(&step.start)),
                &-(held_force(&step.start) * d.clone()),
            ))
            .but_not(
                "the linear spring's does not",
                eq(
                    &(linear_potential(&step.end) - linear_potential(&step.start)),
                    &-(held_force(&step.start) * d.clone()),
                ),
            )
            .at(values([("x0", 1, 2)])),
        Query::new("EQ-16/17", "range", "quantization adds between 0 and 1/8 to the potential")
            .then(all([
                nonnegative(&quantization_potential(&v("x"))),
                le(&quantization_potential(&v("x")), &Term::fraction(1, 8)),
            ]))
            .but_not("it can add more than 1/9", le(&quantization_potential(&v("x")), &Term::fraction(1, 9))),
        Query::new("EQ-19/20", "forms", "(19) with (20), ½D² + D(ρ₁ − ½) and the integral (18) are one")
            .then(all([
                eq(&quantized, &by_18(quantized_potential)),
                eq(&quantized, &generated_as_in_19(&step)),
            ]))
            .but_not("against the linear spring the integral is another", eq(&quantized, &by_18(linear_potential))),
        Query::new("EQ-21a", "bound", "E_gq is at most ½|D|")
            .then(le(&effect, &bound_21(&step.ticks())))
            .but_not("it can be above ¼|D|", le(&effect, &bound_21(&step.ticks()).half())),
        Query::new("TH-LIN", "identity", "the formula is the definition (18) against the linear spring")
            .then(eq(&linear, &by_18(linear_potential)))
            .but_not("against the quantized spring it is not", eq(&linear, &by_18(quantized_potential))),
        Query::new("TH-LIN", "bound", "E_gᴸ is at most ½d² + ½|d|")
            .then(le(&linear, &bound_22(&d)))
            .but_not("it can be above ½d² + ¼|d|", le(&linear, &(bound_22(&d) - d.abs().half().half()))),
        Query::new("TH-LIN", "tight", "downwards from a tick the bound is reached; upwards it is missed by (1 − ρ₀)d")
            .given([any([lt(&d, &n(0)), gt(&d, &n(0))])])
            .then(all([
                any([
                    gt(&d, &n(0)),
                    eq(&(bound_22(&d) - linear.clone()), &(rho_0.clone() * d.abs())),
                ]),
                any([
                    lt(&d, &n(0)),
                    eq(&(bound_22(&d) - linear.clone()), &((n(1) - rho_0) * d.clone())),
                ]),
            ]))
            .but_not("upwards the bound is never reached", eq(&linear, &bound_22(&d))),
        Query::new("TH-QUANT", "cases", "with N = ⌊|d|⌋ the ticks crossed are N or N + 1, in the direction of d")
            .whole()
            .then(ticks_are_the_whole_distance_or_one_more())
            .but_not("they are not always N", eq(&step.ticks().abs(), &d.abs().floor())),
        Query::new("TH-QUANT", "bound", "E_g is at most ½d² + ½|d| + ½f(1 − f)")
            .given([ticks_are_the_whole_distance_or_one_more()])
            .then(le(&quantized, &bound_quantized(&d)))
            .but_not("the printed bound (22) is too small", le(&quantized, &bound_22(&d))),
        Query::new("TH-QUANT", "tight", "downwards from a tick the bound is reached")
            .given([
                eq(&step.start.floor(), &step.start),
                lt(&d, &n(0)),
                // A move that ends on a tick crosses N ticks, any other N + 1.
                any([
                    all([
                        eq(&d.abs().floor(), &d.abs()),
                        eq(&step.ticks(), &-d.abs().floor()),
                    ]),
                    eq(&step.ticks(), &-(d.abs().floor() + n(1))),
                ]),
            ])
            .then(eq(&quantized, &bound_quantized(&d)))
            .but_not("(22) is passed", le(&quantized, &bound_22(&d))),
        Query::new("TH-QUANT", "excess", "the tight bound exceeds (22) by at most 1/8")
            .then(le(&(bound_quantized(&d) - bound_22(&d)), &Term::fraction(1, 8)))
            .but_not("it can exceed it by more than 1/9", le(&(bound_quantized(&d) - bound_22(&d)), &Term::fraction(1, 9))),
        Query::new("TH-TELESCOPE", "identity", "E_g − E_gᴸ is the change of ½ρ(1 − ρ)")
            .then(all([
                eq(&difference, &potential_change),
                eq(&ledger::counterparts_differ_by(&step.start, &step.end), &potential_change),
            ]))
            .but_not("it is not nothing", eq(&difference, &n(0))),
        Query::new("TH-TELESCOPE", "bound", "from any start to any end the change of ½ρ(1 − ρ) is within 1/8")
            .then(le(&potential_change.abs(), &Term::fraction(1, 8)))
            .but_not("it is not within 1/9", le(&potential_change.abs(), &Term::fraction(1, 9)))
            .at(values([("x0", 0, 1), ("x1", 1, 2)])),
        Query::new("TH-TELESCOPE", "sum", "the differences over two runs add up to that of both")
            .then(eq(
                &(ledger::counterparts_differ_by(&v("x0"), &v("x1"))
                    + ledger::counterparts_differ_by(&v("x1"), &v("x2"))),
                &ledger::counterparts_differ_by(&v("x0"), &v("x2")),
            ))
            .but_not(
                "the middle does not drop out when its sign is lost",
                eq(
                    &(ledger::counterparts_differ_by(&v("x0"), &v("x1"))
                        - ledger::counterparts_differ_by(&v("x1"), &v("x2"))),
                    &ledger::counterparts_differ_by(&v("x0"), &v("x2")),
                ),
            ),
        Query::new("EQ-16/17", "held force", "the force is held within half a tick of the position")
            .then(le(&(held_force(&v("x")) + v("x")).abs(), &half()))
            .but_not("not within a third", le(&(held_force(&v("x")) + v("x")).abs(), &Term::fraction(1, 3))),
    ]
}
