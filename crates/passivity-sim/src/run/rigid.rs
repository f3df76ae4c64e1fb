//! The loops of a force that is constant over the interval, one for each set of frictions.

use super::{Control, Watch, end, entry};
use crate::flow::State;
use crate::motion::{Constants, Moved};
use crate::outcome::{End, Stop};
use crate::plan::Plan;
use crate::rounding::{Acting, STRETCH, Seen, Stretches, off_edge};

#[inline(always)]
pub(super) fn by_friction<const FORCE: bool, W: Watch, L: Control>(
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
#[inline(always)]
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
    let watched = plan.law.has_edges();
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
        let held = law.held(xi);
        if let Some(rounding) = watch.rounding() {
            rounding.look(h, law.nearest(off_edge(xi)));
        }
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
            seen.nearest = law.nearest(seen.nearest);
            seen = stretches.settle(seen, h);
        }
    };
    seen.nearest = law.nearest(seen.nearest);
    stretches.settle(seen, h);
    (end(plan, stop, h, xi, v), stretches.near)
}

/// The motion, with what the ledger needs only when there is one.
#[inline(always)]
pub(super) fn advance<const VISCOUS: bool, const COULOMB: bool, W: Watch>(
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
    let sigma = plan.holding;
    match &plan.forces {
        Some(forces) if FORCE => {
            let [least, most] = forces.range_from(h);
            held + most <= sigma && held + least >= -sigma
        }
        _ => held.abs() <= sigma,
    }
}
