//! Intervals in which the device stops, starts, or may do so: one of them, or several side by side.
#![expect(
    clippy::indexing_slicing,
    reason = "indices are those of events and lanes, from lists of them"
)]

use super::fast::{Fast, Gone};
use super::short::{Inner, Rates, Short, dot};
use super::wide::Wide;
use super::{Flowed, State};

/// What is next in an interval.
#[derive(Clone, Copy, PartialEq)]
enum Stage {
    /// A stop in this cell.
    Stop(usize),
    /// A motion to the end of the interval.
    Move,
    /// Nothing: the velocity at the end, and the excess.
    Done([f64; 2]),
    /// The velocity keeps its sign after all.
    Whole,
    /// What is left to the careful way.
    Undecided,
}

/// An interval with at most one stop, and one start after it.
pub(crate) struct Event<'a> {
    fast: &'a Fast,
    start: State<f64>,
    command: f64,
    force: f64,
    stage: Stage,
    /// v, p and e at the beginning of the stage.
    inner: Inner,
    /// The direction that the device starts in.
    direction: f64,
    /// y + F − kξ.
    net: f64,
    /// What is left of the interval.
    left: f64,
    gone: Gone,
}

impl<'a> Event<'a> {
    /// An interval under a command and the operator's force.
    #[inline(always)]
    pub(crate) fn new(fast: &'a Fast, start: State<f64>, command: f64, force: f64) -> Self {
        let (net, excess) = fast.driven(&start, command, force);
        let v = start.velocity;
        Self {
            fast,
            command,
            force,
            stage: Stage::Undecided,
            inner: [v, net - fast.sigma.copysign(v), excess],
            direction: v,
            net,
            left: 1.0,
            gone: Gone::default(),
            start,
        }
    }

    /// Finds out what is first.
    #[inline(always)]
    fn begin(&mut self) {
        let Some(cells) = self.fast.table.cells() else {
            return;
        };
        if self.start.velocity == 0.0 {
            self.rest();
            return;
        }
        self.stage = match self.fast.crossed(&self.inner, cells) {
            None => Stage::Undecided,
            Some(None) => Stage::Whole,
            Some(Some(cell)) => Stage::Stop(cell),
        };
    }

    /// The excess at the end of the interval.
    #[inline(always)]
    fn excess_at_end(&self) -> f64 {
        let (_, excess) = self.fast.driven(&self.start, self.command, 0.0);
        self.fast.whole.excess * excess
    }

    /// At rest: whether the device stays, and until when.
    #[inline(always)]
    fn rest(&mut self) {
        let [.., excess] = self.inner;
        let (net, sigma) = (self.net, self.fast.sigma);
        self.stage = Stage::Move;
        if net.abs() > sigma {
            self.inner = [0.0, net - sigma.copysign(net), excess];
            self.direction = net;
            return;
        }
        let at_end = self.excess_at_end();
        let net_at_end = net + (excess - at_end);
        if net_at_end.abs() <= sigma {
            self.stage = Stage::Done([0.0, at_end]);
            return;
        }
        // The excess falls as e^(−κt); friction lets go when the net force is ±σ.
        let then = excess + net - sigma.copysign(net_at_end);
        let wait = -(then / excess).ln() / self.fast.rates.rate;
        let left = self.left - wait;
        self.inner = [0.0, 0.0, then];
        self.direction = net_at_end;
        if wait >= 0.0 && left >= 0.0 {
            self.left = left;
        } else {
            self.stage = Stage::Undecided;
        }
    }

    /// The motion over the interval; `None` when numbers have overflowed.
    #[inline(always)]
    pub(crate) fn end_or_carefully<const LEDGER: bool>(&self) -> Option<Flowed<f64>> {
        let carefully = || {
            let Self {
                start,
                command,
                force,
                ..
            } = self;
            self.fast.carefully::<LEDGER>(start, *command, *force)
        };
        self.end::<LEDGER>().or_else(carefully)
    }

    /// The motion over the interval, if it has been decided.
    #[inline(always)]
    pub(super) fn end<const LEDGER: bool>(&self) -> Option<Flowed<f64>> {
        match self.stage {
            Stage::Done([velocity, excess]) => {
                Some(self.gone.ended(&self.start, self.command, velocity, excess))
            }
            Stage::Whole => Some(
                self.fast
                    .whole::<LEDGER>(&self.start, self.command, &self.inner),
            ),
            _ => None,
        }
    }
}

/// Leads all events to their ends, W at a time; `LEDGER` says whether energies are wanted.
///
/// No function is handed on to another in what follows, and no array mapped: only loops and direct calls
/// are compiled for the vector instructions of the caller.
#[inline(always)]
pub(crate) fn decide<const W: usize, const LEDGER: bool>(events: &mut [Event<'_>]) {
    for event in &mut *events {
        event.begin();
    }
    let mut from = 0;
    while let Some((group, count)) = next_group(events, &mut from, true) {
        stop::<W, LEDGER>(events, &group, count);
    }
    from = 0;
    while let Some((group, count)) = next_group(events, &mut from, false) {
        move_on::<W, LEDGER>(events, &group, count);
    }
}

/// The next W events that are to stop, or to move: the last ones are fewer, and the last of them fills
/// their places.
#[inline(always)]
fn next_group<const W: usize>(
    events: &[Event<'_>],
    from: &mut usize,
    stops: bool,
) -> Option<([usize; W], usize)> {
    let (mut group, mut count, mut last) = ([0; W], 0, 0);
    while *from < events.len() && count < W {
        let wanted = match events[*from].stage {
            Stage::Stop(_) => stops,
            Stage::Move => !stops,
            _ => false,
        };
        if wanted {
            last = *from;
            group[count] = last;
            count += 1;
        }
        *from += 1;
    }
    for place in group.iter_mut().skip(count) {
        *place = last;
    }
    (count > 0).then_some((group, count))
}

/// The inputs of a group of motions, side by side.
struct Group<const W: usize> {
    rates: Rates<Wide<W>>,
    /// The width of a cell.
    width: Wide<W>,
    inner: Inner<Wide<W>>,
    left: Wide<W>,
}

impl<const W: usize> Group<W> {
    #[inline(always)]
    fn of(events: &[Event<'_>], group: &[usize; W]) -> Self {
        let zero = Wide::splat(0.0);
        let mut all = Self {
            rates: Rates {
                inverse_mass: zero,
                damping: zero,
                stiffness: zero,
                rate: zero,
            },
            width: zero,
            inner: [zero; 3],
            left: zero,
        };
        for lane in 0..W {
            let event = &events[group[lane]];
            let rates = &event.fast.rates;
            all.rates.inverse_mass.0[lane] = rates.inverse_mass;
            all.rates.damping.0[lane] = rates.damping;
            all.rates.stiffness.0[lane] = rates.stiffness;
            all.rates.rate.0[lane] = rates.rate;
            all.width.0[lane] = event.fast.table.cell;
            all.left.0[lane] = event.left;
            for part in 0..3 {
                all.inner[part].0[lane] = event.inner[part];
            }
        }
        all
    }
}

/// The maps of a group, side by side: way, velocity and excess.
#[inline(always)]
fn maps<const W: usize>(
    events: &[Event<'_>],
    group: &[usize; W],
    cells: &[usize; W],
) -> (Inner<Wide<W>>, Inner<Wide<W>>, Wide<W>) {
    let zero = Wide::splat(0.0);
    let (mut way, mut velocity, mut excess) = ([zero; 3], [zero; 3], zero);
    for lane in 0..W {
        let map = events[group[lane]].fast.table.map(cells[lane]);
        for part in 0..3 {
            way[part].0[lane] = map.way[part];
            velocity[part].0[lane] = map.velocity[part];
        }
        excess.0[lane] = map.excess;
    }
    (way, velocity, excess)
}

/// Leads the events of a group to their stops, and to what comes then.
#[inline(always)]
fn stop<const W: usize, const LEDGER: bool>(
    events: &mut [Event<'_>],
    group: &[usize; W],
    count: usize,
) {
    let mut cells = [0; W];
    for lane in 0..W {
        if let Stage::Stop(cell) = events[group[lane]].stage {
            cells[lane] = cell;
        }
    }
    let all = Group::of(events, group);
    let (way, velocity, excess) = maps(events, group, &cells);
    let (rates, width) = (all.rates, all.width);
    let [_, p, e] = all.inner;
    let way_there = dot(&way, &all.inner);
    let excess = excess * e;
    let state = [
        dot(&velocity, &all.inner),
        p + (e - excess) - rates.stiffness * way_there,
        excess,
    ];
    let series = Short::new(&rates, state);
    let time = series.stop(width);
    let [way, _, added] = series.added(time);
    let (way, excess) = (way_there + way, excess + added);
    let pulled = (e - excess) - rates.stiffness * way;
    for lane in 0..count {
        let event = &mut events[group[lane]];
        let time = time.0[lane];
        if time.is_nan() {
            event.stage = Stage::Undecided;
            continue;
        }
        event.gone.way = way.0[lane];
        if LEDGER {
            let table = &event.fast.table;
            event.gone.path = way.0[lane].abs();
            event.gone.add(table.energies(cells[lane]).of(&event.inner));
            let series = event.fast.rates.series(&lane_of(&state, lane));
            event.gone.add(series.energies(time));
        }
        let there = cells[lane] as f64 * width.0[lane];
        event.left = (1.0 - there) - time;
        event.net += pulled.0[lane];
        event.inner = [0.0, 0.0, excess.0[lane]];
        event.rest();
    }
}

/// Leads the events of a group to the ends of their intervals.
#[inline(always)]
fn move_on<const W: usize, const LEDGER: bool>(
    events: &mut [Event<'_>],
    group: &[usize; W],
    count: usize,
) {
    let all = Group::of(events, group);
    let (rates, left, width) = (all.rates, all.left, all.width);
    let whole = (left / width).floor();
    let mut cells = [0; W];
    for (cells, whole) in cells.iter_mut().zip(whole.0) {
        // At most N: a whole number that fits.
        *cells = whole as usize;
    }
    let (way, velocity, _) = maps(events, group, &cells);
    let [v, p, e] = all.inner;
    let rest = left - whole * width;
    let [way_first, faster, added] = Short::new(&rates, all.inner).added(rest);
    let then = [
        v + faster,
        p - added - rates.stiffness * way_first,
        e + added,
    ];
    let (way, velocity) = (way_first + dot(&way, &then), dot(&velocity, &then));
    for lane in 0..count {
        let event = &mut events[group[lane]];
        let (cells, velocity) = (cells[lane], velocity.0[lane]);
        let then = lane_of(&then, lane);
        if event
            .fast
            .stops_again(&event.inner, &then, event.direction, cells, velocity)
        {
            event.stage = Stage::Undecided;
            continue;
        }
        event.gone.way += way.0[lane];
        if LEDGER {
            let series = event.fast.rates.series(&event.inner);
            event.gone.path += way.0[lane].abs();
            event.gone.add(series.energies(rest.0[lane]));
            event.gone.add(event.fast.table.energies(cells).of(&then));
        }
        event.stage = Stage::Done([velocity, event.excess_at_end()]);
    }
}

/// The numbers of one lane.
#[inline(always)]
fn lane_of<const W: usize>(all: &Inner<Wide<W>>, lane: usize) -> Inner {
    let [v, p, e] = all;
    [v.0[lane], p.0[lane], e.0[lane]]
}
