//! Scenes with an amplifier's lag or an operator's arm, in lanes.
//!
//! Intervals in which the velocity surely keeps its sign are products of the state and the propagator
//! of the scene, all lanes at once. Where the velocity comes to 0 once, the nodes of each lane's table are
//! looked up one by one, and the series about them are computed side by side. What is left goes the way of the
//! scalar loop.

use super::batch::{Batch, Lane, select};
use super::law::{Laws, grow};
use super::{Points, STRANGE, WIDTH};
use crate::flow::{Attempt, Fast, Kind, LONG, Near, Onward, SHORT, State, Turns, Wide};
use crate::plan::Plan;

/// How many events go side by side: a vector of AVX-512.
const SIDE_BY_SIDE: usize = 8;

/// The motions of a batch.
pub(super) struct Flows {
    pub(super) laws: Laws,
    /// What is in the motions.
    pub(super) kind: Kind,
    /// Its output.
    output: Lane,
    way: [Lane; 3],
    velocity: [Lane; 3],
    excess: Lane,
    damping: Lane,
    stiffness: Lane,
    /// The velocity at the end if it kept its sign, and the way there.
    last: Lane,
    gone: Lane,
    /// Mv̇ at both ends then.
    slopes: [Lane; 2],
    /// 1 where the interval of a lane has an event.
    event: Lane,
}

impl Flows {
    pub(super) fn new(plan: &Plan, fast: &Fast) -> Self {
        let zero = [0.0; WIDTH];
        Self {
            laws: Laws::new(&plan.law),
            kind: fast.kind(),
            output: zero,
            way: [zero; 3],
            velocity: [zero; 3],
            excess: zero,
            damping: zero,
            stiffness: zero,
            last: zero,
            gone: zero,
            slopes: [zero; 2],
            event: zero,
        }
    }

    pub(super) fn load(&mut self, lane: usize, plan: &Plan, fast: &Fast) {
        let propagator = fast.propagator();
        self.laws.load(lane, plan);
        let [xi, _] = plan.start;
        self.output[lane] = plan.law.settled(xi);
        for part in 0..3 {
            self.way[part][lane] = propagator.way[part];
            self.velocity[part][lane] = propagator.velocity[part];
        }
        self.excess[lane] = propagator.excess;
        self.damping[lane] = propagator.damping;
        self.stiffness[lane] = propagator.stiffness;
    }
}

/// Runs every busy lane for `intervals` intervals.
#[inline(always)]
pub(super) fn stretch(batch: &mut Batch, flows: &mut Flows, points: &Points, intervals: u32) {
    for _ in 0..intervals {
        grow(batch, &flows.laws, &flows.output, points);
        flows.laws.sample(&batch.xi);
        match flows.kind {
            Kind::Amplifier | Kind::Both => straight::<true>(batch, flows),
            Kind::SlowArm | Kind::Arm => straight::<false>(batch, flows),
        }
        let (mut turns, mut count) = ([0; WIDTH], 0);
        let (mut others, mut left) = ([0; WIDTH], 0);
        for i in 0..WIDTH {
            // In lanes a velocity of another sign at the end says that it comes to 0 once.
            let event = flows.event[i] > 0.0;
            let once = batch.v[i] * flows.last[i] < 0.0;
            turns[count] = i;
            count += usize::from(event & once);
            others[left] = i;
            left += usize::from(event & !once);
        }
        for group in turns[..count].chunks(SIDE_BY_SIDE) {
            match flows.kind {
                Kind::SlowArm => turn::<SHORT, false, true>(batch, flows, points, group),
                Kind::Arm => turn::<LONG, false, true>(batch, flows, points, group),
                // With both, signs do not decide: none of these lanes has an arm with a spring.
                Kind::Amplifier | Kind::Both => {
                    turn::<LONG, true, false>(batch, flows, points, group);
                }
            }
        }
        for &i in &others[..left] {
            alone(batch, flows, points, i);
        }
    }
}

/// The plan of a lane.
#[inline(always)]
fn fast_of(points: &Points, lane: usize) -> Option<&Fast> {
    points[lane].as_ref()?.plan.fast.as_ref()
}

/// What [`straight`] found of a lane.
#[inline(always)]
fn attempt<const LAG: bool>(batch: &Batch, flows: &Flows, i: usize) -> Attempt {
    let (v, held) = (batch.v[i], flows.laws.held[i]);
    let (now, excess) = if LAG {
        (flows.output[i], held - flows.output[i])
    } else {
        (held, 0.0)
    };
    let net = now + (0.0 - flows.stiffness[i] * batch.xi[i]);
    let direction = select(v == 0.0, net, v);
    Attempt {
        net,
        inner: [v, net - batch.sigma[i].copysign(direction), excess],
        way: flows.gone[i],
        velocity: flows.last[i],
        slopes: [flows.slopes[0][i], flows.slopes[1][i]],
    }
}

/// The interval of a lane as the scalar loop does it.
#[inline(never)]
fn alone(batch: &mut Batch, flows: &mut Flows, points: &Points, i: usize) {
    let Some(fast) = fast_of(points, i) else {
        return;
    };
    let start = State {
        xi: batch.xi[i],
        velocity: batch.v[i],
        output: flows.output[i],
    };
    let held = flows.laws.held[i];
    if let Some(flowed) = fast.advance::<false>(&start, held, 0.0) {
        let end = flowed.end;
        batch.edges.see(i, end.xi, 0.0);
        batch.xi[i] = end.xi;
        batch.v[i] = end.velocity;
        flows.output[i] = end.output;
    } else {
        batch.busy[i] = STRANGE;
    }
}

/// The intervals of some lanes in which the velocity comes to 0 once, at most so many as go side by side.
///
/// No function is handed on to another in what follows, and no array mapped: only loops and direct calls
/// are compiled for the vector instructions of the caller.
#[inline(always)]
fn turn<const T: usize, const LAG: bool, const ARM: bool>(
    batch: &mut Batch,
    flows: &mut Flows,
    points: &Points,
    group: &[usize],
) {
    let mut side = SideBySide::new();
    let mut nodes = [None; SIDE_BY_SIDE];
    for (place, &i) in group.iter().enumerate() {
        let attempt = attempt::<LAG>(batch, flows, i);
        if let Some(fast) = fast_of(points, i)
            && let Some((node, near)) = fast.near::<LAG, ARM>(&attempt.inner, fast.guess(&attempt))
        {
            nodes[place] = Some((node, near));
            side.put(place, &near, &fast.turns);
        }
    }
    let (times, found) = side.turns.stop::<T, LAG, ARM>(&side.near);
    let [ways, excesses] = side.turns.reached::<T, LAG, ARM>(&side.near, times);
    let mut ends = [None; SIDE_BY_SIDE];
    for (place, &i) in group.iter().enumerate() {
        if let Some((node, near)) = &nodes[place]
            && found[place] > 0.0
            && let Some(fast) = fast_of(points, i)
        {
            let reached = [ways.0[place], excesses.0[place]];
            let attempt = attempt::<LAG>(batch, flows, i);
            let after = fast.after_stop::<LAG, ARM>(&attempt, *node, times.0[place], near, reached);
            if let Some(after) = after {
                side.lead(place, &fast.onward(&after));
                ends[place] = Some([after.way, after.velocity, after.direction]);
            }
        }
    }
    let [ways, velocities] = side.turns.onward::<T, LAG, ARM>(&side.onward);
    for (place, &i) in group.iter().enumerate() {
        if let Some([way, velocity, direction]) = ends[place] {
            let velocity = velocity + velocities.0[place];
            if velocity * direction >= 0.0 {
                let held = flows.laws.held[i];
                let excess = select(LAG, held - flows.output[i], 0.0);
                batch.xi[i] += way + ways.0[place];
                batch.v[i] = velocity;
                batch.edges.see(i, batch.xi[i], 0.0);
                flows.output[i] = held - flows.excess[i] * excess;
                continue;
            }
        }
        alone(batch, flows, points, i);
    }
}

/// Motions with a stop, side by side.
struct SideBySide {
    turns: Turns<Wide<SIDE_BY_SIDE>>,
    near: Near<Wide<SIDE_BY_SIDE>>,
    onward: Onward<Wide<SIDE_BY_SIDE>>,
}

impl SideBySide {
    /// Of places that stay empty nothing is asked: a velocity that is 0 at once.
    #[inline(always)]
    fn new() -> Self {
        let (zero, one) = (Wide::splat(0.0), Wide::splat(1.0));
        Self {
            turns: Turns {
                inverse_mass: one,
                lambda: zero,
                stiffness: zero,
                spring: zero,
                rate: zero,
                driven: zero,
                cell: zero,
            },
            near: Near {
                way: zero,
                velocity: zero,
                slope: one,
                bend: zero,
                excess: zero,
                time: zero,
            },
            onward: Onward {
                way: [zero; 2],
                velocity: [zero; 2],
                decay: zero,
                push: zero,
                excess: zero,
                time: zero,
            },
        }
    }

    /// Takes a motion up to the node that its stop is nearest to.
    #[inline(always)]
    fn put(&mut self, place: usize, near: &Near, turns: &Turns) {
        let all = &mut self.turns;
        all.inverse_mass.0[place] = turns.inverse_mass;
        all.lambda.0[place] = turns.lambda;
        all.stiffness.0[place] = turns.stiffness;
        all.spring.0[place] = turns.spring;
        all.rate.0[place] = turns.rate;
        all.driven.0[place] = turns.driven;
        all.cell.0[place] = turns.cell;
        self.near.way.0[place] = near.way;
        self.near.velocity.0[place] = near.velocity;
        self.near.slope.0[place] = near.slope;
        self.near.bend.0[place] = near.bend;
        self.near.excess.0[place] = near.excess;
        self.near.time.0[place] = near.time;
    }

    /// Takes the motion on after a stop.
    #[inline(always)]
    fn lead(&mut self, place: usize, onward: &Onward) {
        let all = &mut self.onward;
        for part in 0..2 {
            all.way[part].0[place] = onward.way[part];
            all.velocity[part].0[place] = onward.velocity[part];
        }
        all.decay.0[place] = onward.decay;
        all.push.0[place] = onward.push;
        all.excess.0[place] = onward.excess;
        all.time.0[place] = onward.time;
    }
}

/// The interval of every lane whose velocity surely keeps its sign; the others are marked.
///
/// Signs are joined without short cuts, so that there is no branch.
#[inline(always)]
fn straight<const LAGS: bool>(batch: &mut Batch, flows: &mut Flows) {
    // Copies, so that no store is in the way of a load.
    let (mut xis, mut vs, mut outputs) = (batch.xi, batch.v, flows.output);
    let (mut busies, mut restings, mut events) = (batch.busy, flows.laws.resting, [0.0; WIDTH]);
    let (mut sizes, mut lasts, mut gone) = ([0.0; WIDTH], [0.0; WIDTH], [0.0; WIDTH]);
    let mut slopes = [[0.0; WIDTH]; 2];
    let needed = flows.laws.needed;
    let in_the_end = *flows.laws.in_the_end();
    for i in 0..WIDTH {
        let (xi, v, sigma) = (xis[i], vs[i], batch.sigma[i]);
        let (held, stiffness) = (flows.laws.held[i], flows.stiffness[i]);
        let (now, excess) = if LAGS {
            (outputs[i], held - outputs[i])
        } else {
            (held, 0.0)
        };
        let net = now + (0.0 - stiffness * xi);
        let direction = select(v == 0.0, net, v);
        let sign = 1.0_f64.copysign(direction);
        let p = net - sigma.copysign(direction);
        let [w, u] = [&flows.way, &flows.velocity];
        let way = w[0][i] * v + w[1][i] * p + w[2][i] * excess;
        let velocity = u[0][i] * v + u[1][i] * p + u[2][i] * excess;
        let end_excess = flows.excess[i] * excess;
        let end_xi = xi + way;
        let last = p + (excess - end_excess) - stiffness * (end_xi - xi);
        let first = p - flows.damping[i] * v;
        let last = last - flows.damping[i] * velocity;
        (slopes[0][i], slopes[1][i]) = (first, last);
        let (first, last) = (first * sign, last * sign);
        let sticks = (v == 0.0) & (net.abs() <= sigma);
        let keeps = !sticks & (velocity * sign >= 0.0) & ((first >= 0.0) | (last <= 0.0));

        let taken = |output: f64| (output - stiffness * xi).abs() <= sigma;
        let rests = (v == 0.0) & taken(now) & taken(held) & taken(in_the_end[i]);
        let resting = select(rests, restings[i] + 1.0, 0.0);
        let size = batch.size(i);
        let busy = busies[i];
        let busy = select((resting > needed) & (busy > 0.0), 0.0, busy);
        let goes = keeps & (busy > 0.0);
        xis[i] = select(goes, end_xi, xi);
        vs[i] = select(goes, velocity, v);
        outputs[i] = select(goes, held - end_excess, outputs[i]);
        busies[i] = busy;
        restings[i] = resting;
        events[i] = select((busy > 0.0) & !keeps, 1.0, 0.0);
        (sizes[i], lasts[i], gone[i]) = (size, velocity, way);
    }
    for i in 0..WIDTH {
        // Where an event leads is seen there.
        batch
            .edges
            .see(i, select(events[i] > 0.0, 0.5, xis[i]), sizes[i]);
    }
    for (count, busy) in batch.count.iter_mut().zip(busies) {
        *count += select(busy > 0.0, 1.0, 0.0);
    }
    (batch.xi, batch.v, batch.busy) = (xis, vs, busies);
    (flows.output, flows.laws.resting, flows.event) = (outputs, restings, events);
    (flows.last, flows.gone, flows.slopes) = (lasts, gone, slopes);
}
