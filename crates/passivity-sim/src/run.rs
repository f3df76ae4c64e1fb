//! Running a plan: the inner loops of the `closed-form` method.

use crate::flow::{Fast, Flowed, State};
use crate::law::{ENCODER, HeldForce, Law, Memory};
use crate::ledger::{Entry, Totals, potential_change};
use crate::motion::{Constants, Moved};
use crate::number::floor;
use crate::outcome::{End, Facts, Stop};
use crate::plan::Plan;
use crate::rounding::{Acting, Rounding, STRETCH, Seen, Stretches};

/// What watches a run; a watcher without a ledger costs nothing.
trait Watch {
    /// Whether energies are wanted.
    const LEDGER: bool;
    fn see(&mut self, entry: &Entry) -> bool;

    /// The errors, where they are wanted of every interval.
    fn rounding(&mut self) -> Option<&mut Rounding> {
        None
    }

    /// Whether everything has been seen that is looked for.
    fn is_done(&self) -> bool {
        false
    }
}

struct WithoutLedger;

impl Watch for WithoutLedger {
    const LEDGER: bool = false;
    fn see(&mut self, _: &Entry) -> bool {
        true
    }
}

/// What looks closely at how near samples are to edges.
struct Careful(Rounding);

impl Watch for Careful {
    const LEDGER: bool = false;
    fn see(&mut self, _: &Entry) -> bool {
        true
    }
    fn rounding(&mut self) -> Option<&mut Rounding> {
        Some(&mut self.0)
    }
    fn is_done(&self) -> bool {
        self.0.first().is_some()
    }
}

struct WithLedger<F> {
    totals: Totals,
    each: F,
    rounding: Option<Rounding>,
}

impl<F: FnMut(&Entry) -> bool> Watch for WithLedger<F> {
    const LEDGER: bool = true;
    fn see(&mut self, entry: &Entry) -> bool {
        self.totals.add(entry);
        (self.each)(entry)
    }
    fn rounding(&mut self) -> Option<&mut Rounding> {
        self.rounding.as_mut()
    }
}

/// The controller as the loop sees it: a function of a table, or the paper's own in line.
trait Control {
    fn held(&mut self, xi: f64) -> f64;
    fn memory(&self) -> &Memory;
}

struct Compiled<'a> {
    law: Law,
    parameters: &'a HeldForce,
    memory: Memory,
}

impl<'a> Compiled<'a> {
    fn new(plan: &'a Plan) -> Self {
        let [xi, _] = plan.start;
        Self {
            law: plan.law.law(),
            parameters: &plan.law,
            memory: plan.law.memory(xi),
        }
    }
}

impl Control for Compiled<'_> {
    #[inline(always)]
    fn held(&mut self, xi: f64) -> f64 {
        (self.law)(self.parameters, &mut self.memory, xi)
    }
    fn memory(&self) -> &Memory {
        &self.memory
    }
}

struct Encoder(Memory);

impl Control for Encoder {
    #[inline(always)]
    fn held(&mut self, xi: f64) -> f64 {
        -(floor(xi) + 0.5)
    }
    fn memory(&self) -> &Memory {
        &self.0
    }
}

/// Runs a plan to its end: outcome and final state, no ledger.
///
/// # Example
///
/// ```
/// use passivity_sim::{ExactOutcome, Plain, Plan, run};
///
/// let plan = Plan::plain(&Plain { mu: 50.0, beta: 0.4, sigma: 0.6, xi: 0.0, velocity: 10.0 }, 50_000);
/// assert_eq!(run::outcome(&plan).outcome.exact, ExactOutcome::Growing);
/// ```
#[must_use]
pub fn outcome(plan: &Plan) -> End {
    watched(plan, &mut WithoutLedger)
}

/// Runs a plan with its ledger; `each` sees every interval, and stops the run by saying `false`.
///
/// # Example
///
/// ```
/// use passivity_sim::{Plain, Plan, run};
///
/// let plan = Plan::plain(&Plain { mu: 50.0, beta: 0.6, sigma: 0.6, xi: 0.0, velocity: 1.0 }, 1000);
/// let (end, totals) = run::ledger(&plan, |_| true);
/// // S at the start is 25; what is left at rest is ½ξ², the rest was dissipated or never there.
/// let left = 0.5 * end.xi * end.xi;
/// assert!((25.0 - left + totals.generated_linear - totals.dissipated).abs() < 1e-12);
/// ```
pub fn ledger(plan: &Plan, each: impl FnMut(&Entry) -> bool) -> (End, Totals) {
    let mut watch = WithLedger {
        totals: Totals::default(),
        each,
        rounding: None,
    };
    let end = watched(plan, &mut watch);
    (end, watch.totals.settled())
}

fn watched<W: Watch>(plan: &Plan, watch: &mut W) -> End {
    let (end, near) = looped(plan, watch);
    if near { look_closely(plan, end) } else { end }
}

/// Looks for the first sample within rounding of an edge in a run that ended so: once more, with the bounds of
/// every interval, which are less than those of a stretch.
pub(crate) fn look_closely(plan: &Plan, end: End) -> End {
    let again = plan.with_intervals(plan.intervals.min(end.intervals.saturating_add(1)));
    let mut careful = Careful(Rounding::new(plan));
    looped(&again, &mut careful);
    End {
        within_rounding_of_edge: careful.0.first(),
        ..end
    }
}

/// Runs a plan in its loop; whether a sample may be within rounding of an edge.
fn looped<W: Watch>(plan: &Plan, watch: &mut W) -> (End, bool) {
    if !plan.parts.is_empty() {
        let advance = in_parts(plan, |part| over_part::<W>(part.clone()));
        return stepping(plan, Compiled::new(plan), advance, watch);
    }
    if plan.is_plain() {
        let [xi, _] = plan.start;
        return by_friction::<false, W, _>(plan, Encoder(plan.law.memory(xi)), watch);
    }
    let law = Compiled::new(plan);
    if let Some(fast) = &plan.fast {
        if W::LEDGER {
            let fast = fast.clone().with_ledger();
            let advance = |state: &State<f64>, [_, held]: [f64; 2], force| {
                fast.advance::<true>(state, held, force)
            };
            return stepping(plan, law, advance, watch);
        }
        let advance = |state: &State<f64>, [_, held]: [f64; 2], force| {
            fast.advance::<false>(state, held, force)
        };
        return stepping(plan, law, advance, watch);
    }
    if plan.forces.is_some() {
        by_friction::<true, W, _>(plan, law, watch)
    } else {
        by_friction::<false, W, _>(plan, law, watch)
    }
}

fn by_friction<const FORCE: bool, W: Watch, L: Control>(
    plan: &Plan,
    law: L,
    watch: &mut W,
) -> (End, bool) {
    match (plan.viscous, plan.coulomb) {
        (true, true) => rigid::<true, true, FORCE, W, L>(plan, law, watch),
        (true, false) => rigid::<true, false, FORCE, W, L>(plan, law, watch),
        (false, true) => rigid::<false, true, FORCE, W, L>(plan, law, watch),
        (false, false) => rigid::<false, false, FORCE, W, L>(plan, law, watch),
    }
}

/// The loop of a force that is constant over the interval.
fn rigid<const VISCOUS: bool, const COULOMB: bool, const FORCE: bool, W: Watch, L: Control>(
    plan: &Plan,
    mut law: L,
    watch: &mut W,
) -> (End, bool) {
    let k = plan.constants;
    let growth = plan.growth.clone();
    let needed = plan.law.forgets_after();
    let [mut xi, mut v] = plan.start;
    let mut resting = 0;
    // Driven by a force that friction just takes, the speed dwindles for ever and never is 0, but in
    // doubles it underflows. That is no rest: `creep` is its direction, `last` what led to it.
    let mut creep = 0.0;
    let mut last = [0.0; 2];
    let (mut stretches, mut seen) = (Stretches::new(plan), Seen::NOTHING);
    let watched = plan.law.has(ENCODER);
    let mut h = 0;
    let stop = loop {
        if h == plan.intervals || watch.is_done() {
            break Stop::Ran(h);
        }
        let size = growth.size(xi, v);
        if growth.is_past(size) {
            let state = State {
                xi,
                velocity: v,
                output: 0.0,
            };
            if growth.certain(&state, law.memory().latest_first()) {
                break Stop::Growing(h);
            }
        }
        if let Some(rounding) = watch.rounding() {
            rounding.look(h, xi);
        }
        let held = law.held(xi);
        let force = match &plan.forces {
            Some(forces) if FORCE => forces.at(h),
            _ => 0.0,
        };
        let u = if FORCE { held + force } else { held };
        if v == 0.0 {
            let [before, pull] = last;
            let vanished = before != 0.0 && pull == k.sigma.copysign(before);
            if vanished {
                creep = before;
            }
            let creeps = creep != 0.0 && u == k.sigma.copysign(creep);
            let holds = holds::<FORCE>(plan, held, h)
                && (!plan.law.lingers() || holds::<FORCE>(plan, plan.law.settled(xi), h));
            resting = if !vanished && !creeps && holds {
                resting + 1
            } else {
                0
            };
            if resting > needed {
                break Stop::Rest(h - needed);
            }
        } else {
            (resting, creep) = (0, 0.0);
        }
        last = [v, u];
        let moved = advance::<VISCOUS, COULOMB, W>(&k, xi, v, u);
        if watched {
            seen.see(moved.xi, size);
        }
        if let Some(rounding) = watch.rounding() {
            let acting = Acting {
                velocity: v,
                held,
                output: held,
                force,
            };
            rounding.follow(&acting, moved.xi);
        }
        if W::LEDGER {
            let applied = held * (moved.xi - xi);
            let entry = entry(plan, h, [xi, v], &moved, force, applied);
            if !watch.see(&entry) {
                (xi, v) = (moved.xi, moved.velocity);
                break Stop::Ran(h + 1);
            }
        }
        (xi, v) = (moved.xi, moved.velocity);
        h += 1;
        if watched && h.is_multiple_of(STRETCH.into()) {
            seen = stretches.settle(seen, h);
        }
    };
    stretches.settle(seen, h);
    (end(plan, stop, h, xi, v), stretches.near)
}

/// The motion, with what the ledger needs only when there is one.
#[inline(always)]
fn advance<const VISCOUS: bool, const COULOMB: bool, W: Watch>(
    k: &Constants,
    xi: f64,
    v: f64,
    u: f64,
) -> Moved {
    if W::LEDGER {
        k.advance::<VISCOUS, COULOMB, true>(xi, v, u)
    } else {
        k.advance::<VISCOUS, COULOMB, false>(xi, v, u)
    }
}

/// Whether the held force, with every force of the operator from now on, is one that friction takes.
#[inline(always)]
fn holds<const FORCE: bool>(plan: &Plan, held: f64, h: u64) -> bool {
    let sigma = plan.constants.sigma;
    match &plan.forces {
        Some(forces) if FORCE => {
            let [least, most] = forces.range_from(h);
            held + most <= sigma && held + least >= -sigma
        }
        _ => held.abs() <= sigma,
    }
}

/// The way over the part of an interval whose plan this is.
fn over_part<W: Watch>(mut part: Plan) -> impl FnMut(&State<f64>, f64, f64) -> Option<Flowed<f64>> {
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
fn in_parts<A>(
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
fn stepping<W: Watch>(
    plan: &Plan,
    mut law: Compiled<'_>,
    mut advance: impl FnMut(&State<f64>, [f64; 2], f64) -> Option<Flowed<f64>>,
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
    let watched = plan.law.has(ENCODER);
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
        if let Some(rounding) = watch.rounding() {
            rounding.look(h, state.xi);
        }
        let held = law.held(state.xi);
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
        let Some(flowed) = advance(&state, acting, force) else {
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
            seen = stretches.settle(seen, h);
        }
        if !go_on {
            break Stop::Ran(h);
        }
    };
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
    let sigma = plan.constants.sigma;
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

/// The account of an interval; `applied` is the work of the force that acted.
#[inline]
fn entry(plan: &Plan, h: u64, start: [f64; 2], moved: &Moved, force: f64, applied: f64) -> Entry {
    let k = &plan.constants;
    let [xi0, v0] = start;
    let d = moved.xi - xi0;
    let [linear, quantized] = potential_change(&plan.law, xi0, moved.xi);
    let dissipated = k.beta * moved.square + k.sigma * moved.path;
    let (mass, arm) = match &plan.flow {
        Some(flow) => {
            let [damping, stiffness] = flow.arm.map_or([0.0; 2], |arm| arm.map(|x| x.0));
            let arm = damping * moved.square + stiffness * d * (xi0 + 0.5 * d);
            (flow.mass.0, arm)
        }
        None => (k.mu, 0.0),
    };
    let kinetic = 0.5 * mass * (moved.velocity - v0) * (moved.velocity + v0);
    Entry {
        h,
        xi0,
        xi1: moved.xi,
        v0,
        v1: moved.velocity,
        generated_linear: applied + linear,
        generated_quantized: applied + quantized,
        dissipated,
        residual: kinetic + dissipated + arm - applied - force * d,
    }
}

/// The facts of a plan that its outcome is judged by.
pub(crate) fn facts(plan: &Plan) -> Facts {
    Facts {
        mu: plan.mass(),
        sigma: plan.constants.sigma,
        least_holding_force: plan.is_unforced().then(|| plan.least_holding_force()),
        may_grow: plan.growth.is_possible(),
        start: plan.start,
    }
}

pub(crate) fn end(plan: &Plan, stop: Stop, intervals: u64, xi: f64, velocity: f64) -> End {
    End {
        intervals,
        xi,
        velocity,
        outcome: facts(plan).judge(stop, xi, velocity, &plan.growth.words()),
        within_rounding_of_edge: None,
    }
}

/// A run of a plan, and the bounds of what ξ and ξ̇ at its end are off by.
#[cfg(test)]
pub(crate) fn with_errors(plan: &Plan) -> (End, [f64; 2]) {
    let mut careful = Careful(Rounding::new(plan));
    let (end, _) = looped(plan, &mut careful);
    (end, careful.0.errors())
}
