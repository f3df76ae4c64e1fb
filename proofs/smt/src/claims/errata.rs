//! What is false as printed: each query has an answer, and the answer is replayed on the kernel.

use passivity_core::generation::{bound_22, generated, generated_quantized};
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::quantizer::held_force;
use passivity_core::{Friction, Law, Loop, Scalar as _, Step, spring};

use super::words::{n, v};
use crate::Query;
use crate::formula::{eq, le, nonnegative, positive};

pub(super) fn queries() -> Vec<Query> {
    let step = Step::new(v("x0"), v("x1"));
    let d = step.displacement();
    let paper = Loop::plain(Friction::new(v("beta"), v("sigma")));
    let row = ledger::row(&paper, &HeldInterval::plain(step.clone(), v("dtau")));
    // Opened at x0, in the middle of an interval that began at `sample`, at constant speed.
    let opened = generated(
        &held_force(&v("sample")),
        &step,
        &spring::linear_potential(&step.start),
        &spring::linear_potential(&step.end),
    );
    let within = [
        le(&v("sample"), &v("x0")),
        le(&v("x0"), &v("x1")),
        le(&(v("x1") - v("sample")), &n(1)),
    ];
    // A model is asked for in these ticks, where floors are whole; replaying it needs no such help.
    let in_ticks = |ticks: [(&str, i32); 2]| ticks.map(|(x, tick)| eq(&v(x).floor(), &n(tick)));
    let criterion_holds = [
        nonnegative(&v("beta")),
        nonnegative(&v("sigma")),
        positive(&v("dtau")),
        le(&v("dtau"), &n(1)),
        nonnegative(&row.margin),
    ];
    vec![
        Query::new("ERR-21/22", "as printed", "E_g is at most ½d² + ½|d|")
            .given(in_ticks([("x0", 1), ("x1", 0)]))
            .then(le(&generated_quantized(&step), &bound_22(&d)))
            .refuted()
            .rescued(
                "it is where ρ₀ = ρ₁, as the paper's last step silently has it",
                [eq(
                    &(v("x0") - v("x0").floor()),
                    &(v("x1") - v("x1").floor()),
                )],
                le(&generated_quantized(&step), &bound_22(&d)),
            ),
        Query::new(
            "ERR-27",
            "as printed",
            "where (8) holds, E_g is at most E_d",
        )
        .given(in_ticks([("x0", 1), ("x1", 0)]))
        .given(criterion_holds.clone())
        .then(nonnegative(&row.net_quantized))
        .refuted()
        .rescued(
            "against the linear spring it is",
            criterion_holds,
            nonnegative(&row.net_linear),
        ),
        Query::new(
            "ERR-19-start",
            "as printed",
            "the bound holds from any instant of an interval",
        )
        .given(within.clone())
        .given(in_ticks([("sample", 0), ("x0", 1)]))
        .given([eq(&v("x1").floor(), &n(1))])
        .then(le(&opened, &bound_22(&d)))
        .refuted()
        .rescued(
            "it does where the tick is still that of the sample",
            within
                .into_iter()
                .chain([eq(&v("sample").floor(), &v("x0").floor())]),
            le(&opened, &bound_22(&d)),
        ),
        Query::new(
            "ERR-IV-C",
            "as printed",
            "switching the wall on at a depth adds nothing to what is stored",
        )
        .then(le(
            &Law::bilateral().switching_energy(false, true, &v("x")),
            &n(0),
        ))
        .refuted()
        .rescued(
            "switching it off adds nothing at any depth",
            [],
            le(
                &Law::bilateral().switching_energy(true, false, &v("x")),
                &n(0),
            ),
        ),
    ]
}
