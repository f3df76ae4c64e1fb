//! Running a plan: the inner loops of the `closed-form` method.

mod rigid;
mod steps;

use multiversion::multiversion;

use crate::flow::State;
use crate::law::{ENCODER, HeldForce, Law, Memory};
use crate::ledger::{Entry, Totals, potential_change};
use crate::motion::Moved;
use crate::number::floor;
use crate::outcome::{End, Facts, Stop};
use crate::plan::Plan;
use crate::rounding::Rounding;
use rigid::by_friction;
pub(crate) use steps::stepped;
use steps::{flowing, in_parts, over_part, stepping};

/// What watches a run; a watcher without a ledger costs nothing.
trait Watch {
    /// Whether energies are wanted.
    const LEDGER: bool;
    /// Whether nothing but the end is asked for: such runs have loops made for what is in their scene.
    const BARE: bool = false;
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
    const BARE: bool = true;
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

    /// How near to an edge the samples since this was asked before were, of positions that were so `near` to
    /// those of an encoder.
    #[inline(always)]
    fn nearest(&mut self, near: f64) -> f64 {
        near
    }
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
    fn nearest(&mut self, near: f64) -> f64 {
        if self.parameters.has(ENCODER) {
            near
        } else {
            self.memory.take_nearest()
        }
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
    bare(plan)
}

/// The bits are the same on every processor: what the wider ones have is instructions that leave their inputs.
#[multiversion(targets("x86_64+avx2"))]
fn bare(plan: &Plan) -> End {
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

#[inline(always)]
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
#[inline(always)]
fn looped<W: Watch>(plan: &Plan, watch: &mut W) -> (End, bool) {
    if !plan.parts.is_empty() {
        let advance = in_parts(plan, |part| over_part::<W>(part.clone()));
        return stepping(plan, Compiled::new(plan), advance, watch);
    }
    let [xi, _] = plan.start;
    let encoder = Encoder(plan.law.memory(xi));
    if plan.is_plain() {
        return by_friction::<false, W, _>(plan, encoder, watch);
    }
    let law = Compiled::new(plan);
    if let Some(fast) = &plan.fast {
        if W::BARE && plan.law.effects == ENCODER {
            return flowing(plan, fast, encoder, watch);
        }
        if W::BARE {
            return flowing(plan, fast, law, watch);
        }
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
        holding: plan.holding,
        least_holding_force: plan.is_unforced().then_some(plan.least_holding_force),
        may_grow: plan.growth.is_possible(),
        start: plan.start,
    }
}

pub(crate) fn end(plan: &Plan, stop: Stop, intervals: u64, xi: f64, velocity: f64) -> End {
    End {
        intervals,
        xi,
        velocity,
        outcome: facts(plan).judge(stop, xi, velocity, &plan.growth_words()),
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
