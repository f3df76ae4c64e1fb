//! The loop of every other motion: with a latency, an amplifier or an arm, and by methods of steps.

use super::rigid::advance;
use super::{Compiled, Control, Watch, WithLedger, end, entry};
use crate::flow::{Fast, Flowed, Kind, LONG, SHORT, State};
use crate::ledger::{Entry, Totals};
use crate::motion::Moved;
use crate::outcome::{End, Stop};
use crate::plan::Plan;
use crate::rounding::{Acting, Rounding, STRETCH, Seen, Stretches, off_edge};

/// A way over an interval, from a state, the forces of the sample before and of this one, and the operator's;
/// `None` where numbers have overflowed.
pub(super) trait Advance {
    fn advance(&mut self, state: &State<f64>, acting: [f64; 2], force: f64) -> Option<Flowed<f64>>;
}

impl<F: FnMut(&State<f64>, [f64; 2], f64) -> Option<Flowed<f64>>> Advance for F {
    #[inline(always)]
    fn advance(&mut self, state: &State<f64>, acting: [f64; 2], force: f64) -> Option<Flowed<f64>> {
        self(state, acting, force)
    }
}

/// The way of an amplifier or an arm, see [`Fast::advance_in`].
struct Along<'a, const T: usize, const LAG: bool, const ARM: bool>(&'a Fast);

impl<const T: usize, const LAG: bool, const ARM: bool> Advance for Along<'_, T, LAG, ARM> {
    #[inline(always)]
    fn advance(
        &mut self,
        state: &State<f64>,
        [_, held]: [f64; 2],
        force: f64,
    ) -> Option<Flowed<f64>> {
        self.0.advance_in::<T, LAG, ARM, false>(state, held, force)
    }
}

/// The loop of a scene with an amplifier or an arm, for what is in its motion; without a ledger.
#[inline(always)]
pub(super) fn flowing<W: Watch>(
    plan: &Plan,
    fast: &Fast,
    law: impl Control,
    watch: &mut W,
) -> (End, bool) {
    match fast.kind() {
        Kind::SlowArm => stepping(plan, law, Along::<SHORT, false, true>(fast), watch),
        Kind::Arm => stepping(plan, law, Along::<LONG, false, true>(fast), watch),
        Kind::Amplifier => stepping(plan, law, Along::<LONG, true, false>(fast), watch),
        Kind::Both => stepping(plan, law, Along::<LONG, true, true>(fast), watch),
    }
}

/// The way over the part of an interval whose plan this is.
pub(super) fn over_part<W: Watch>(
    mut part: Plan,
) -> impl FnMut(&State<f64>, f64, f64) -> Option<Flowed<f64>> {
    if W::LEDGER {
        part.fast = part.fast.map(Fast::with_ledger);
    }
    move |state, held, force| {
        if let Some(fast) = &part.fast {
            return if W::LEDGER {
                fast.advance::<true>(state, held, force)
            } else {
                fast.advance::<false>(state, held, force)
            };
        }
        let (k, u) = (&part.constants, held + force);
        let moved = match (part.viscous, part.coulomb) {
            (true, true) => advance::<true, true, W>(k, state.xi, state.velocity, u),
            (true, false) => advance::<true, false, W>(k, state.xi, state.velocity, u),
            (false, true) => advance::<false, true, W>(k, state.xi, state.velocity, u),
            (false, false) => advance::<false, false, W>(k, state.xi, state.velocity, u),
        };
        Some(Flowed {
            work: held * (moved.xi - state.xi),
            end: State {
                xi: moved.xi,
                velocity: moved.velocity,
                output: held,
            },
            path: moved.path,
            square: moved.square,
        })
    }
}

/// The way over an interval, from the way over each of its parts that `make` makes.
///
/// Under the force of the sample before in all parts but the last one; see [`crate::latency`].
pub(super) fn in_parts<A>(
    plan: &Plan,
    make: impl Fn(&Plan) -> A,
) -> impl FnMut(&State<f64>, [f64; 2], f64) -> Option<Flowed<f64>>
where
    A: FnMut(&State<f64>, f64, f64) -> Option<Flowed<f64>>,
{
    let mut parts: Vec<(f64, A)> = if plan.parts.is_empty() {
        vec![(1.0, make(plan))]
    } else {
        let parts = plan.parts.iter();
        parts.map(|(time, part)| (*time, make(part))).collect()
    };
    let before = parts.len() - 1;
    move |start, [earlier, held], force| {
        let mut all = Flowed {
            end: start.clone(),
            path: 0.0,
            square: 0.0,
            work: 0.0,
        };
        for (i, (time, advance)) in parts.iter_mut().enumerate() {
            all.end.velocity *= *time;
            let command = if i < before { earlier } else { held };
            let flowed = advance(&all.end, command, force)?;
            all.end = flowed.end;
            all.end.velocity /= *time;
            all.path += flowed.path;
            all.square += flowed.square / *time;
            all.work += flowed.work;
        }
        Some(all)
    }
}

/// Runs a plan with another way over an interval, or over each of its parts: what the methods to
/// compare with are made of.
///
/// `make` makes the way of a plan from a state, a held force and the operator's force; `None` says
/// that it could not, because numbers have overflowed. With a `tolerance` of an interval, samples are
/// held against it: a method of fixed steps has none, its errors are of its steps.
pub(crate) fn stepped<A>(
    plan: &Plan,
    tolerance: Option<f64>,
    make: impl Fn(&Plan) -> A,
    each: impl FnMut(&Entry) -> bool,
) -> (End, Totals)
where
    A: FnMut(&State<f64>, f64, f64) -> Option<Flowed<f64>>,
{
    let mut watch = WithLedger {
        totals: Totals::default(),
        each,
        rounding: tolerance.map(|tolerance| Rounding::new(plan).with_tolerance(tolerance)),
    };
    let advance = in_parts(plan, make);
    let (mut end, _) = stepping(plan, Compiled::new(plan), advance, &mut watch);
    end.within_rounding_of_edge = watch.rounding.as_ref().and_then(Rounding::first);
    (end, watch.totals.settled())
}

/// The loop of a scene with a latency, an amplifier or an arm, and of every method of steps; `advance`
/// is given the force of the sample before and this one's.
#[inline(always)]
pub(super) fn stepping<W: Watch>(
    plan: &Plan,
    mut law: impl Control,
    mut advance: impl Advance,
    watch: &mut W,
) -> (End, bool) {
    let needed = plan.law.forgets_after();
    let [xi, velocity] = plan.start;
    // The amplifier has settled on what the controller commanded before the start.
    let output = plan.law.settled(xi);
    let mut earlier = output;
    let mut state = State {
        xi,
        velocity,
        output,
    };
    let (mut stretches, mut seen) = (Stretches::new(plan), Seen::NOTHING);
    let watched = plan.law.has_edges();
    let mut resting = 0;
    let mut h = 0;
    let stop = loop {
        if h == plan.intervals || watch.is_done() {
            break Stop::Ran(h);
        }
        let size = plan.growth.size(state.xi, state.velocity);
        if plan.growth.is_past(size) && plan.growth.certain(&state, law.memory().latest_first()) {
            break Stop::Growing(h);
        }
        let held = law.held(state.xi);
        if let Some(rounding) = watch.rounding() {
            rounding.look(h, law.nearest(off_edge(state.xi)));
        }
        let force = plan.forces.as_ref().map_or(0.0, |forces| forces.at(h));
        if plan.parts.is_empty() {
            earlier = held; // It acts from the sample on.
        }
        let acting = [earlier, held];
        let at_rest = state.velocity == 0.0 && rests(plan, &state, acting, h);
        resting = if at_rest { resting + 1 } else { 0 };
        if resting > needed {
            break Stop::Rest(h - needed);
        }
        let Some(flowed) = advance.advance(&state, acting, force) else {
            break Stop::Growing(h);
        };
        if watched {
            seen.see(flowed.end.xi, size);
        }
        if let Some(rounding) = watch.rounding() {
            let acting = Acting {
                velocity: state.velocity,
                held,
                output: state.output.abs().max(earlier.abs()),
                force,
            };
            rounding.follow_flow(&acting, state.xi, flowed.end.xi);
        }
        let go_on = if W::LEDGER {
            let moved = Moved {
                xi: flowed.end.xi,
                velocity: flowed.end.velocity,
                path: flowed.path,
                square: flowed.square,
            };
            let start = [state.xi, state.velocity];
            watch.see(&entry(plan, h, start, &moved, force, flowed.work))
        } else {
            true
        };
        (state, earlier) = (flowed.end, held);
        h += 1;
        if watched && h.is_multiple_of(STRETCH.into()) {
            seen.nearest = law.nearest(seen.nearest);
            seen = stretches.settle(seen, h);
        }
        if !go_on {
            break Stop::Ran(h);
        }
    };
    seen.nearest = law.nearest(seen.nearest);
    stretches.settle(seen, h);
    let end = end(plan, stop, h, state.xi, state.velocity);
    (end, stretches.near)
}

/// Whether friction takes what the amplifier gives now and in the end, with the force of the sample before
/// and this one's, and what the controller tends to, whatever the operator does.
fn rests(plan: &Plan, state: &State<f64>, [earlier, held]: [f64; 2], h: u64) -> bool {
    let [least, most] = plan
        .forces
        .as_ref()
        .map_or([0.0; 2], |forces| forces.range_from(h));
    let sigma = plan.holding;
    let (lags, stiffness) = match &plan.flow {
        Some(flow) => (
            flow.rate.is_some(),
            flow.arm.map_or(0.0, |[_, stiffness]| stiffness.0),
        ),
        None => (false, 0.0),
    };
    let now = if lags { state.output } else { earlier };
    let settled = if plan.law.lingers() {
        plan.law.settled(state.xi)
    } else {
        held
    };
    [now, earlier, held, settled].into_iter().all(|output| {
        let pull = output - stiffness * state.xi;
        pull + most <= sigma && pull + least >= -sigma
    })
}
