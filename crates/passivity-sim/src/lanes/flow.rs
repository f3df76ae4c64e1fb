//! Scenes with an amplifier's lag or an operator's arm, in lanes.
//!
//! Intervals in which the velocity surely keeps its sign are products of the state and the propagator
//! of the scene, all lanes at once. What the scalar loop does in the others, [`decide`] does for the
//! lanes that need it, some at a time.

use super::batch::{Batch, Lane, select};
use super::law::{Laws, grow};
use super::{Points, STRANGE, WIDTH};
use crate::flow::{Event, Exponentials, Fast, State, Turning, Wide, decide};
use crate::plan::Plan;

/// How many events go side by side: a vector of AVX-512.
const SIDE_BY_SIDE: usize = 8;

/// The motions of a batch.
pub(super) struct Flows {
    laws: Laws,
    /// Whether there is an amplifier.
    pub(super) lags: bool,
    /// Its output.
    output: Lane,
    way: [Lane; 3],
    velocity: [Lane; 3],
    excess: Lane,
    damping: Lane,
    stiffness: Lane,
    /// The velocity at the end if it kept its sign.
    last: Lane,
    /// 1 where the interval of a lane has an event.
    event: Lane,
    /// For stops and starts in closed form, and 1 where that is known.
    exponentials: Exponentials<Lane>,
    closed: Lane,
}

impl Flows {
    pub(super) fn new(plan: &Plan, fast: &Fast) -> Self {
        let zero = [0.0; WIDTH];
        Self {
            laws: Laws::new(&plan.law),
            lags: fast.lags(),
            output: zero,
            way: [zero; 3],
            velocity: [zero; 3],
            excess: zero,
            damping: zero,
            stiffness: zero,
            last: zero,
            event: zero,
            exponentials: Exponentials {
                inverse_mass: zero,
                sigma: zero,
                lambda: zero,
                rate: zero,
                over: [zero; 2],
                excess: zero,
            },
            closed: zero,
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
        self.closed[lane] = 0.0;
        if let Some(of) = &fast.exponentials {
            let all = &mut self.exponentials;
            self.closed[lane] = 1.0;
            all.inverse_mass[lane] = of.inverse_mass;
            all.sigma[lane] = of.sigma;
            all.lambda[lane] = of.lambda;
            all.rate[lane] = of.rate;
            for part in 0..2 {
                all.over[part][lane] = of.over[part];
            }
            all.excess[lane] = of.excess;
        }
    }
}

/// Runs every busy lane for `intervals` intervals.
#[inline(always)]
pub(super) fn stretch(batch: &mut Batch, flows: &mut Flows, points: &Points, intervals: u32) {
    let mut events = Vec::with_capacity(WIDTH);
    for _ in 0..intervals {
        grow(batch, &flows.laws, &flows.output, points);
        flows.laws.sample(&batch.xi);
        if flows.lags {
            straight::<true>(batch, flows);
        } else {
            straight::<false>(batch, flows);
        }
        let (mut turns, mut count, mut others) = ([0; WIDTH], 0, false);
        for i in 0..WIDTH {
            let event = flows.event[i] > 0.0;
            let closed = flows.closed[i] > 0.0;
            turns[count] = i;
            count += usize::from(event & closed);
            others |= event & !closed;
        }
        for group in turns[..count].chunks(SIDE_BY_SIDE) {
            others |= !turn(batch, flows, group);
        }
        if !others {
            continue;
        }
        let mut lanes = [0; WIDTH];
        for (i, point) in points.iter().enumerate() {
            if flows.event[i] > 0.0
                && let Some(point) = point
                && let Some(fast) = &point.plan.fast
            {
                let start = State {
                    xi: batch.xi[i],
                    velocity: batch.v[i],
                    output: flows.output[i],
                };
                lanes[events.len()] = i;
                events.push(Event::new(fast, start, flows.laws.held[i], 0.0));
            }
        }
        decide::<SIDE_BY_SIDE, false>(&mut events);
        for (event, i) in events.drain(..).zip(lanes) {
            if let Some(flowed) = event.end_or_carefully::<false>() {
                let end = flowed.end;
                batch.edges.see(i, end.xi, 0.0);
                batch.xi[i] = end.xi;
                batch.v[i] = end.velocity;
                flows.output[i] = end.output;
            } else {
                batch.busy[i] = STRANGE;
            }
        }
    }
}

/// Decides events of some lanes in closed form, at most so many as go side by side; those that it decides are
/// no longer marked. Whether it has decided all.
#[inline(always)]
fn turn(batch: &mut Batch, flows: &mut Flows, group: &[usize]) -> bool {
    // The first one fills the places of those that are not there.
    let mut lanes = [group[0]; SIDE_BY_SIDE];
    lanes[..group.len()].copy_from_slice(group);
    let mut net = wide(&flows.laws.held, &lanes);
    let mut excess = Wide::splat(0.0);
    if flows.lags {
        let output = wide(&flows.output, &lanes);
        excess = net - output;
        net = output;
    }
    let of = &flows.exponentials;
    let constants = Exponentials {
        inverse_mass: wide(&of.inverse_mass, &lanes),
        sigma: wide(&of.sigma, &lanes),
        lambda: wide(&of.lambda, &lanes),
        rate: wide(&of.rate, &lanes),
        over: [wide(&of.over[0], &lanes), wide(&of.over[1], &lanes)],
        excess: wide(&of.excess, &lanes),
    };
    let turning = Turning {
        velocity: wide(&batch.v, &lanes),
        net,
        excess,
        last: wide(&flows.last, &lanes),
    };
    let ([way, velocity], decided) = turning.end(&constants);
    let output = wide(&flows.laws.held, &lanes) - constants.excess * excess;
    let mut all = true;
    for (at, &i) in group.iter().enumerate() {
        if decided[at] > 0.0 {
            batch.xi[i] += way.0[at];
            batch.v[i] = velocity.0[at];
            batch.edges.see(i, batch.xi[i], 0.0);
            flows.output[i] = output.0[at];
            flows.event[i] = 0.0;
        } else {
            all = false;
        }
    }
    all
}

/// The numbers of some lanes.
#[inline(always)]
fn wide<const W: usize>(all: &Lane, lanes: &[usize; W]) -> Wide<W> {
    let mut numbers = [0.0; W];
    for i in 0..W {
        numbers[i] = all[lanes[i] % WIDTH]; // Lanes are below it: no test of that.
    }
    Wide(numbers)
}

/// The interval of every lane whose velocity surely keeps its sign; the others are marked.
///
/// Signs are joined without short cuts, so that there is no branch.
#[inline(always)]
fn straight<const LAGS: bool>(batch: &mut Batch, flows: &mut Flows) {
    // Copies, so that no store is in the way of a load.
    let (mut xis, mut vs, mut outputs) = (batch.xi, batch.v, flows.output);
    let (mut busies, mut restings, mut events) = (batch.busy, flows.laws.resting, [0.0; WIDTH]);
    let (mut sizes, mut lasts) = ([0.0; WIDTH], [0.0; WIDTH]);
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
        let first = (p - flows.damping[i] * v) * sign;
        let last = (last - flows.damping[i] * velocity) * sign;
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
        (sizes[i], lasts[i]) = (size, velocity);
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
    flows.last = lasts;
}
