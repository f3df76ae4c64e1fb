//! The held force of the kernel's controller, and the account of all effects at once.
//!
//! The controller is the kernel's text, as every program runs it: measured, filtered, gated, rounded,
//! limited, late. What its force is off the law of the wall is bounded here for every combination of
//! its parts; what a step then generates is the sum of parts that other queries bound.

mod staircases;

use passivity_core::controller::Controller;
use passivity_core::extra_storage::{damping_storage, delay_storage};
use passivity_core::generation::generated;
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{Friction, Loop, Scalar as _, Step};
use passivity_terms::Term;

use super::effects::{later, past};
use super::words::{half, n, v, values};
use crate::Query;
use crate::formula::{Formula, all, any, eq, le, lt, nonnegative, positive};

pub(super) fn queries() -> Vec<Query> {
    [
        parts(),
        combinations(),
        accounts(),
        rows(),
        staircases::queries(),
    ]
    .concat()
}

/// The loop with the parts asked for: damping B, force steps δ, force limit L.
fn with_parts(unilateral: bool, damping: bool, step: bool, limit: bool) -> Loop<Term> {
    Loop {
        unilateral,
        damping: damping.then(|| v("B")),
        force_step: step.then(|| v("delta")),
        max_force: limit.then(|| v("L")),
        ..Loop::plain(Friction::new(v("beta"), v("sigma")))
    }
}

/// The numbers of a controller are what the table of parameters allows.
fn allowed() -> [Formula; 3] {
    [
        nonnegative(&v("B")),
        positive(&v("delta")),
        positive(&v("L")),
    ]
}

/// The force held from the measured positions q and q1, the sample before it.
fn held(the_loop: &Loop<Term>) -> Term {
    Controller::of(the_loop).held_force(&[v("q"), v("q1")])
}

/// The argument of the gate's floor, which lies between −1 and 0.
fn gate() -> Term {
    v("q").max(-n(1)).min(n(0))
}

/// What whole numbers say of it: its floor is −1 or 0.
fn gate_is_open_or_shut() -> Formula {
    any([eq(&gate().floor(), &-n(1)), eq(&gate().floor(), &n(0))])
}

/// Each part of the controller by itself.
fn parts() -> Vec<Query> {
    let plain = |the_loop: Loop<Term>| held(&the_loop);
    let gated = with_parts(true, true, false, false);
    let damped = v("q") + v("B") * (v("q") - v("q1"));
    let limited = with_parts(false, false, false, true);
    let order = with_parts(false, false, true, true);
    let rounded = plain(with_parts(false, false, true, false));
    let late = |delay, samples: &[Term]| {
        let the_loop = Loop {
            delay,
            ..with_parts(true, true, true, true)
        };
        Controller::of(&the_loop).held_force(samples)
    };
    let samples: Vec<Term> = ["q0", "q1", "q2", "q3", "q4"].map(v).into();
    let at_once = Controller::of(&with_parts(true, true, true, true));
    let late_by = |k: u16| {
        let seen = &samples[usize::from(k)..][..2];
        eq(&late(k, &samples), &at_once.held_force(seen))
    };
    vec![
        Query::new("TH-UNI", "gate", "the floor of the gate is −1 outside of the wall and 0 inside")
            .whole()
            .then(all([
                gate_is_open_or_shut(),
                any([lt(&v("q"), &n(0)), eq(&gate().floor(), &n(0))]),
                any([nonnegative(&v("q")), eq(&gate().floor(), &-n(1))]),
            ]))
            .but_not("it is not always open", eq(&gate().floor(), &n(0))),
        Query::new(
            "TH-UNI",
            "outside with damping",
            "outside of a one-sided wall there is no force, not even that of the damper; inside there is all of it",
        )
        .given([gate_is_open_or_shut()])
        .then(all([
            any([nonnegative(&v("q")), eq(&held(&gated), &n(0))]),
            any([lt(&v("q"), &n(0)), eq(&held(&gated), &-damped.clone())]),
        ]))
        .but_not("the damper alone would push outside", eq(&held(&gated), &-damped.clone())),
        Query::new("TH-DAMP", "force", "the damper adds B times the difference of two samples")
            .then(eq(&held(&with_parts(false, true, false, false)), &-damped))
            .but_not("it adds something", eq(&held(&with_parts(false, true, false, false)), &-v("q"))),
        Query::new("TH-DAC", "order", "rounded first and limited then: the limit need not be a whole step")
            .given([positive(&v("delta")), positive(&v("L"))])
            .then(eq(&held(&order), &rounded.clone().min(v("L")).max(-v("L"))))
            .but_not("the other order is another force", {
                let last = Controller::of(&with_parts(false, false, true, false));
                eq(&held(&order), &last.held_force(&[-held(&limited)]))
            })
            .at(values([("delta", 1, 1), ("L", 2, 3), ("q", 5, 1), ("q1", 5, 1)])),
        Query::new("TH-LAW", "force", "a force that is only limited is the law of the wall")
            .given([gate_is_open_or_shut(), positive(&v("L"))])
            .then(all([
                eq(&held(&limited), &-limited.law().force(&v("q"))),
                eq(
                    &held(&with_parts(true, false, false, true)),
                    &-with_parts(true, false, false, true).law().force(&v("q")),
                ),
            ]))
            .but_not("one-sided it is not that of both sides", eq(
                &held(&with_parts(true, false, false, true)),
                &-limited.law().force(&v("q")),
            )),
        Query::new("TH-DELAY", "force", "k samples late it is the force of the sample k before")
            .then(all([late_by(0), late_by(1), late_by(2), late_by(3)]))
            .but_not("not of the one after", {
                eq(&late(2, &samples), &at_once.held_force(&samples[1..][..2]))
            })
            .at(values([("q1", 1, 1), ("q2", 2, 1), ("q3", 3, 1), ("B", 0, 1), ("delta", 1, 1), ("L", 9, 1)])),
    ]
}

/// Whatever the parts, the force is off the law of the wall by at most B|q − q1| + ½δ.
fn combinations() -> Vec<Query> {
    let says = "the force held is off the law of the wall by at most B|q − q₁| + ½δ";
    let names: [[&'static str; 4]; 4] = [
        [
            "commands",
            "commands limited",
            "commands stepped",
            "commands stepped limited",
        ],
        [
            "commands damped",
            "commands damped limited",
            "commands damped stepped",
            "commands damped stepped limited",
        ],
        [
            "commands one sided",
            "commands one sided limited",
            "commands one sided stepped",
            "commands one sided stepped limited",
        ],
        [
            "commands one sided damped",
            "commands one sided damped limited",
            "commands one sided damped stepped",
            "commands one sided damped stepped limited",
        ],
    ];
    let mut all = Vec::new();
    for (row, names) in (0..).zip(names) {
        for (column, name) in (0..).zip(names) {
            let bit = |of: u8, bit: u8| of >> bit & 1 == 1;
            let (unilateral, damping) = (bit(row, 1), bit(row, 0));
            let (step, limit) = (bit(column, 1), bit(column, 0));
            let the_loop = with_parts(unilateral, damping, step, limit);
            let off = held(&the_loop) + the_loop.law().force(&v("q"));
            let part = |has: bool, term: Term| if has { term } else { n(0) };
            let bound =
                part(damping, v("B") * (v("q") - v("q1")).abs()) + part(step, v("delta").half());
            let gate = unilateral.then(gate_is_open_or_shut);
            let query = Query::new("TH-DAMP", name, says)
                .given(allowed())
                .given(gate)
                .then(le(&off.abs(), &bound));
            let query = if damping || step {
                query.but_not("it is not the law itself", eq(&off, &n(0)))
            } else {
                query.but_not("it is not nothing", eq(&held(&the_loop), &n(0)))
            };
            let somewhere = [
                ("B", 1, 1),
                ("delta", 1, 1),
                ("L", 9, 1),
                ("q", 9, 4),
                ("q1", 0, 1),
            ];
            all.push(query.at(values(somewhere)));
        }
    }
    all
}

/// A step under a controller with every part, k samples late.
///
/// The samples are the positions ξ(h), …, ξ(h − k − 1) as `y0`, `y1`, …, and the end of the step.
struct Account {
    /// What the step generates, less what it pays and what the storage drops by.
    whole: Term,
    /// The same as a sum of parts, none of which is above zero.
    parts: Term,
}

impl Account {
    fn of(the_loop: &Loop<Term>) -> Self {
        let k = usize::from(the_loop.delay);
        let positions: Vec<Term> = (0..=k + 1).map(|i| v(&format!("y{i}"))).collect();
        let controller = Controller::of(the_loop);
        let samples: Vec<Term> = positions.iter().map(|y| controller.measured(y)).collect();
        let held = controller.held_force(&samples);
        let (here, end) = (positions[0].clone(), v("end"));
        let law = the_loop.law();
        let (stored, stored_later) = (law.potential(&here), law.potential(&end));
        let step = Step::new(here.clone(), end);
        let generated = generated(&held, &step, &stored, &stored_later);
        let d = step.displacement();
        let ways: Vec<Term> = positions
            .windows(2)
            .map(|pair| pair[0].clone() - pair[1].clone())
            .collect();
        let late = &ways[..k];
        let delay_drop = delay_storage(late) - delay_storage(&later(late, &d));
        let damping_drop =
            damping_storage(&v("B"), &ways) - damping_storage(&v("B"), &later(&ways, &d));
        let drops = delay_drop.clone() + damping_drop.clone();
        let whole = generated - the_loop.cost().bound(&d) - drops;
        // The law held from the position itself; the late and measured sample; damping and rounding.
        let seen = law.force(&samples[k]);
        let at_once = law.force(&here);
        let by_law = stored_later - stored - at_once.clone() * d.clone() - d.square().half();
        let by_delay = (at_once - seen.clone()) * d.clone()
            - (quantization(the_loop) * d.abs()
                + n(i32::from(the_loop.delay)) * d.square()
                + delay_drop);
        let by_command = (held + seen) * d.clone() - (paid_by_command(the_loop, &d) + damping_drop);
        Self {
            whole,
            parts: by_law + by_delay + by_command,
        }
    }
}

/// How far off a measured position may be: ½ behind an encoder.
fn quantization(the_loop: &Loop<Term>) -> Term {
    if the_loop.has_encoder() { half() } else { n(0) }
}

/// B·d² + (B + ½δ)|d|, without the B of a tick where there is no encoder.
fn paid_by_command(the_loop: &Loop<Term>, d: &Term) -> Term {
    let tick = if the_loop.has_encoder() { v("B") } else { n(0) };
    v("B") * d.square() + tick * d.abs() + v("delta").half() * d.abs()
}

/// A late force that is off by g with |g| ≤ ½ + |the way since its sample|, as a law that is nowhere
/// stiffer than the wall has it.
fn late_by(k: u16, part: &'static str) -> Query {
    let (past, d) = (past(usize::from(k)), v("d"));
    let way = past.iter().fold(n(0), |sum, d| sum + d.clone());
    let drop = delay_storage(&past) - delay_storage(&later(&past, &d));
    let paid = d.abs().half() + n(i32::from(k)) * d.square() + drop;
    Query::new(
        "TH-DELAY",
        part,
        "behind an encoder and any law, the step pays ½|d| + k·d², what was stored the rest",
    )
    .given([le(&v("g").abs(), &(way.abs() + half()))])
    .then(le(&(v("g") * d), &paid))
    .not_without("not when the force is off by more", 1)
}

/// A force that is off by g with |g| ≤ B|w| + ½δ, w within a tick of the way two samples ago.
fn commanded(part: &'static str, the_loop: &Loop<Term>) -> Query {
    let (past, d) = (past(2), v("d"));
    let drop = damping_storage(&v("B"), &past) - damping_storage(&v("B"), &later(&past, &d));
    Query::new(
        "TH-DAMP",
        part,
        "damping and rounding are paid by the step, and by what was stored before",
    )
    .given(allowed())
    .given([
        le(&(v("w") - v("d2")).abs(), &quantization(the_loop).double()),
        le(&v("g").abs(), &(v("B") * v("w").abs() + v("delta").half())),
    ])
    .then(le(
        &(v("g") * d.clone()),
        &(paid_by_command(the_loop, &d) + drop),
    ))
    .not_without("not when the force is off by more", 1)
}

fn accounts() -> Vec<Query> {
    let everything = |delay, encoder: bool, unilateral| {
        let the_loop = with_parts(unilateral, true, true, true);
        Loop {
            delay,
            resolution: encoder.then(|| n(1)),
            ..the_loop
        }
    };
    let sum = |part, the_loop: Loop<Term>| {
        let Account { whole, parts } = Account::of(&the_loop);
        Query::new(
            "TH-DAMP",
            part,
            "encoder, law, delay, damping and force steps at once: costs and storages are the sums of the parts",
        )
        .then(eq(&whole, &parts))
        .but_not("the parts alone are not nothing", eq(&whole, &n(0)))
        .at(values([("delta", 1, 1), ("L", 9, 1), ("B", 1, 1), ("y0", 1, 1), ("y1", 2, 1), ("end", 3, 1)]))
    };
    vec![
        late_by(1, "one sample with a law"),
        late_by(2, "two samples with a law"),
        late_by(3, "three samples with a law"),
        commanded("command", &everything(0, true, false)),
        commanded("command without encoder", &everything(0, false, false)),
        sum("combined", everything(0, true, true)),
        sum("combined on both sides", everything(0, true, false)),
        sum(
            "combined with one sample of delay",
            everything(1, true, true),
        ),
        sum(
            "combined with two samples of delay",
            everything(2, true, true),
        ),
        sum("combined without encoder", everything(0, false, true)),
        sum(
            "combined without encoder with one sample of delay",
            everything(1, false, true),
        ),
    ]
}

/// The kernel's row under any force, and what the criterion says of it.
fn rows() -> Vec<Query> {
    let interval = |extra_storage| HeldInterval {
        step: Step::new(v("x0"), v("x1")),
        force: v("u"),
        dtau: v("dtau"),
        extra_storage,
    };
    let d = v("x1") - v("x0");
    let everything = Loop {
        delay: 1,
        ..with_parts(true, true, true, true)
    };
    let row = ledger::row(&everything, &interval(Some(v("gain"))));
    let bound = everything.cost().bound(&d) - v("gain");
    let generated_by = |the_loop: &Loop<Term>| {
        let law = the_loop.law();
        v("u") * d.clone() + law.potential(&v("x1")) - law.potential(&v("x0"))
    };
    let linear = |the_loop: &Loop<Term>| ledger::row(the_loop, &interval(None)).generated_linear;
    let plain = with_parts(false, false, false, false);
    let smooth = Loop::smooth(Friction::new(v("beta"), v("sigma")));
    let quantized = |the_loop: &Loop<Term>| {
        let law = the_loop.law();
        let row = ledger::row(the_loop, &interval(None));
        let change = law.quantized_potential(&v("x1")) - law.quantized_potential(&v("x0"));
        eq(&row.generated_quantized, &(v("u") * d.clone() + change))
    };
    vec![
        Query::new(
            "TH-INTERVAL",
            "row with effects",
            "where the criterion holds with the terms of all effects, a step that pays for what it generates is not short",
        )
        .given([
            positive(&v("dtau")),
            nonnegative(&v("B")),
            le(&row.generated_linear, &bound),
            nonnegative(&row.margin),
            le(&v("dtau"), &n(1)),
        ])
        .then(nonnegative(&row.net_linear))
        .not_without("not in an interval longer than a sampling period", 1),
        Query::new(
            "TH-INTERVAL",
            "row of any force",
            "the account is of the force that was held: its work, and the change of the wall's potential",
        )
        .then(all([
            eq(&linear(&plain), &generated_by(&plain)),
            eq(&linear(&smooth), &generated_by(&smooth)),
            eq(&linear(&everything), &generated_by(&everything)),
        ]))
        .but_not(
            "not that of the wall on both sides",
            eq(&linear(&everything), &generated_by(&plain)),
        ),
        Query::new(
            "TH-INTERVAL",
            "row of any force against the staircase",
            "against the quantized law it is the work and the change of the staircase's potential",
        )
        .given([positive(&v("L"))])
        .then(all([quantized(&plain), quantized(&everything)]))
        .but_not("the two accounts differ", {
            let row = ledger::row(&plain, &interval(None));
            eq(&row.generated_quantized, &row.generated_linear)
        }),
    ]
}
