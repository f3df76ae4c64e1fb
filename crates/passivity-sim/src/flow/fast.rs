//! The motion over an interval in doubles, by propagators: with an amplifier's lag or an arm.
//!
//! Where the velocity keeps its sign a whole interval is a few products. That it does is tested first,
//! by signs and slopes at both ends: see [`Fast::keeps`]. A stop is looked for in the [`Table`] of
//! propagators and in its cell by Newton's iteration on a short power series; the device then rests
//! or moves on, and what is left of the interval is a product again. What none of this decides, a
//! second stop or a velocity that just touches 0, is left to the series of the whole interval,
//! [`Flow::advance`].

use super::propagator::{Inner, Map, Rates, Short, Table, dot};
use super::{Flow, Flowed, State};
use crate::number::Double;

/// The motion of a scene over an interval.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fast {
    rates: Rates,
    /// σ; 0 without Coulomb friction.
    sigma: f64,
    coulomb: bool,
    lags: bool,
    whole: Map,
    table: Table,
    /// Whether v̇, and v̈ as well, is 0 at most once within an interval.
    single: bool,
    /// ⅛ of the most that |v̈| can be within an interval, for each unit of |v|, |p| and |e| at its
    /// start; infinite when that is not known. See [`Table::sag`].
    sag: Inner,
    /// What decides the rest.
    careful: Flow<Double>,
}

/// What was gone of an interval: the way, ∫|v|, ∫v² and ∫ev.
#[derive(Clone, Copy, Default)]
struct Gone {
    way: f64,
    path: f64,
    square: f64,
    lagging: f64,
}

/// A state at rest or about to move, with what is left of the interval.
struct Stopped {
    gone: Gone,
    /// y + F − kξ.
    net: f64,
    /// e.
    excess: f64,
    left: f64,
}

impl Fast {
    /// The propagators of a flow.
    pub(crate) fn new(flow: &Flow<Double>) -> Self {
        let [arm_damping, stiffness] = flow.arm.map_or([0.0; 2], |arm| arm.map(|x| x.0));
        let rates = Rates {
            inverse_mass: 1.0 / flow.mass.0,
            damping: flow.beta.0 + arm_damping,
            stiffness,
            rate: flow.rate.map_or(0.0, |rate| rate.0),
        };
        let table = Table::new(&rates, flow.fastest());
        // Without stiffness v̇ and v̈ are sums of the exponentials of two real rates; with it but
        // without an amplifier too, or a sine of less than half a period (ω < π).
        let half_damping = 0.5 * rates.damping * rates.inverse_mass;
        let frequency = rates.stiffness * rates.inverse_mass - half_damping * half_damping;
        let lags = flow.rate.is_some();
        Self {
            sigma: flow.sigma.map_or(0.0, |sigma| sigma.0),
            coulomb: flow.sigma.is_some(),
            lags,
            whole: table.whole(),
            single: stiffness == 0.0 || (!lags && frequency < 9.0),
            sag: table.sag(&rates),
            table,
            rates,
            careful: flow.clone(),
        }
    }

    /// The same, with what a ledger needs.
    pub(crate) fn with_ledger(mut self) -> Self {
        self.table.add_energies(&self.rates);
        self
    }

    /// The motion over an interval; `None` when numbers have overflowed. `LEDGER`, which needs
    /// [`Self::with_ledger`], says whether path and energies are wanted (else they are 0).
    #[inline]
    pub(crate) fn advance<const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
    ) -> Option<Flowed<f64>> {
        self.straight::<LEDGER>(start, command, force)
            .or_else(|| self.with_events::<LEDGER>(start, command, force))
    }

    /// The same where the velocity surely keeps its sign, else `None`.
    #[inline(always)]
    pub(crate) fn straight<const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
    ) -> Option<Flowed<f64>> {
        let (net, excess) = self.driven(start, command, force);
        let v = start.velocity;
        if !self.coulomb {
            return Some(self.whole::<LEDGER>(start, command, &[v, net, excess]));
        }
        if v == 0.0 && net.abs() <= self.sigma {
            return None;
        }
        let direction = if v == 0.0 { net } else { v };
        let inner = [v, net - self.sigma.copysign(direction), excess];
        let flowed = self.whole::<LEDGER>(start, command, &inner);
        self.keeps(&inner, &flowed.end, start.xi, direction)
            .then_some(flowed)
    }

    /// y + F − kξ at the start, and what the amplifier still has to add to it.
    #[inline(always)]
    fn driven(&self, start: &State<f64>, command: f64, force: f64) -> (f64, f64) {
        let pulled = force - self.rates.stiffness * start.xi;
        if self.lags {
            (start.output + pulled, command - start.output)
        } else {
            (command + pulled, 0.0)
        }
    }

    /// An interval in which the velocity keeps its sign.
    #[inline(always)]
    fn whole<const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        inner: &Inner,
    ) -> Flowed<f64> {
        let way = dot(&self.whole.way, inner);
        let mut gone = Gone {
            way,
            ..Gone::default()
        };
        if LEDGER {
            gone.path = way.abs();
            gone.add(self.table.whole_energies().of(inner));
        }
        let velocity = dot(&self.whole.velocity, inner);
        let [.., excess] = *inner;
        gone.ended(start, command, velocity, self.whole.excess * excess)
    }

    /// Whether the velocity has the sign of `direction` from the start to the end of an interval, or
    /// is 0 there.
    ///
    /// With v̇ = 0 at most once, v comes to 0 between ends of one sign only where it slows down at first
    /// and speeds up at the end; and if v̈ is positive at both ends, v is above both tangents there,
    /// which meet at (v₀v̇₁ + v̇₀(v̇₁ − v₁))/(v̇₁ − v̇₀).
    #[inline(always)]
    fn keeps(&self, inner: &Inner, end: &State<f64>, from: f64, direction: f64) -> bool {
        let [v, p, e] = *inner;
        let velocity = end.velocity;
        let sign = 1.0_f64.copysign(direction);
        if velocity * sign < 0.0 || velocity.is_nan() {
            return false;
        }
        let excess = self.whole.excess * e;
        let last = p + (e - excess) - self.rates.stiffness * (end.xi - from);
        let slopes = [
            p - self.rates.damping * v,
            last - self.rates.damping * velocity,
        ];
        let [first, last] = slopes.map(|slope| slope * sign);
        if self.single && (first >= 0.0 || last <= 0.0) {
            return true;
        }
        self.stays_above(inner, [velocity, excess], sign, slopes)
    }

    /// The same for a velocity that may have been less in between; its excess at the end too.
    #[inline(never)]
    fn stays_above(&self, inner: &Inner, end: [f64; 2], sign: f64, slopes: [f64; 2]) -> bool {
        let ([v, _, e], [velocity, excess]) = (*inner, end);
        if self.most_sag(inner) < (v * sign).min(velocity * sign) {
            return true;
        }
        let r = &self.rates;
        let [first, last] = slopes.map(|slope| slope * r.inverse_mass);
        let bends = |v: f64, e: f64, slope: f64| {
            (r.rate * e - r.stiffness * v - r.damping * slope) * sign > 0.0
        };
        self.single
            && bends(v, e, first)
            && bends(velocity, excess, last)
            && v * last + first * (last - velocity) > 0.0
    }

    /// How far v can be below the lesser of its ends within an interval: between points at a distance
    /// t it is at most ⅛t²·|v̈| below the line from one to the other.
    fn most_sag(&self, inner: &Inner) -> f64 {
        dot(&self.sag, &inner.map(f64::abs))
    }

    /// An interval in which the device stops, starts, or may do so.
    #[inline(never)]
    pub(crate) fn with_events<const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
    ) -> Option<Flowed<f64>> {
        self.one_event::<LEDGER>(start, command, force)
            .or_else(|| self.careful.advance_doubles(start, command, force, LEDGER))
    }

    /// The interval when there is at most one stop, and one start after it; else `None`.
    pub(super) fn one_event<const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
    ) -> Option<Flowed<f64>> {
        let cells = self.table.cells()?;
        let (net, excess) = self.driven(start, command, force);
        let v = start.velocity;
        let mut stopped = Stopped {
            gone: Gone::default(),
            net,
            excess,
            left: 1.0,
        };
        if v != 0.0 {
            let inner = [v, net - self.sigma.copysign(v), excess];
            let Some(cell) = self.crossed(&inner, cells)? else {
                return Some(self.whole::<LEDGER>(start, command, &inner));
            };
            stopped = self.stop::<LEDGER>(cell, cells, net, &inner)?;
        }
        let at_end = self.whole.excess * excess;
        let Stopped { net, excess, .. } = stopped;
        let mut inner = [0.0, net - self.sigma.copysign(net), excess];
        let mut direction = net;
        if net.abs() <= self.sigma {
            let net_at_end = net + (excess - at_end);
            if net_at_end.abs() <= self.sigma {
                return Some(stopped.gone.ended(start, command, 0.0, at_end));
            }
            // The excess falls as e^(−κt); friction lets go when the net force is ±σ.
            let then = excess + net - self.sigma.copysign(net_at_end);
            let wait = -(then / excess).ln() / self.rates.rate;
            stopped.left -= wait;
            if wait.is_nan() || stopped.left.is_nan() || stopped.left < 0.0 || wait < 0.0 {
                return None;
            }
            (inner, direction) = ([0.0, 0.0, then], net_at_end);
        }
        let velocity = self.move_on::<LEDGER>(&mut stopped, &inner, direction)?;
        Some(stopped.gone.ended(start, command, velocity, at_end))
    }

    /// The cell of the table in which the velocity first comes to 0, or that it does not; `None` when
    /// that is not decided.
    fn crossed(&self, inner: &Inner, cells: usize) -> Option<Option<usize>> {
        let [v, ..] = *inner;
        let sign = 1.0_f64.copysign(v);
        let velocity = |cell: usize| dot(&self.table.map(cell).velocity, inner) * sign;
        let (mut at, mut step) = (0, cells);
        if self.single && velocity(cells) < 0.0 {
            // It changes its sign once.
            while step > 1 {
                step /= 2;
                if velocity(at + step) > 0.0 {
                    at += step;
                }
            }
            return Some(Some(at));
        }
        at = self.first_doubt(inner, sign, 0, cells);
        if at == cells {
            return Some(None);
        }
        (velocity(at + 1) < 0.0).then_some(Some(at))
    }

    /// The first cell from `at` on, where the velocity has this sign, in which it may come to 0;
    /// `cells` when there is none before it.
    fn first_doubt(&self, inner: &Inner, sign: f64, mut at: usize, cells: usize) -> usize {
        let velocity = |cell: usize| dot(&self.table.map(cell).velocity, inner) * sign;
        let sag = self.most_sag(inner);
        let mut before = velocity(at);
        let mut step = cells - at;
        while at < cells {
            let part = step as f64 * self.table.cell;
            let next = velocity(at + step);
            if before.min(next) > sag * part * part {
                (at, before) = (at + step, next);
                // The longest step that begins here, in halves of halves.
                step = (1 << at.trailing_zeros()).min(cells - at);
            } else if step > 1 {
                step /= 2;
            } else {
                return at;
            }
        }
        cells
    }

    /// Moves to the stop in a cell; `None` when the velocity just touches 0 there.
    fn stop<const LEDGER: bool>(
        &self,
        cell: usize,
        cells: usize,
        net: f64,
        inner: &Inner,
    ) -> Option<Stopped> {
        // The error after a step of Newton's is about the square of the step.
        const CLOSE: f64 = 1.0 / (1_u64 << 40) as f64;
        let map = self.table.map(cell);
        let state = self.led(map, inner);
        let series = Short::new(&self.rates, state);
        let ([before, ..], width) = (state, self.table.cell);
        let after = dot(&self.table.map(cell + 1).velocity, inner);
        let mut time = width * (before / (before - after));
        let mut converged = false;
        for _ in 0..8 {
            let [v, slope] = series.rates(time);
            let step = v / slope;
            time = (time - step).clamp(0.0, width);
            if step.abs() <= CLOSE * width {
                converged = true;
                break;
            }
        }
        if !converged {
            return None;
        }
        let [way, _, added] = series.added(time);
        let [.., e] = *inner;
        let [.., at_cell] = state;
        let way = dot(&map.way, inner) + way;
        let excess = at_cell + added;
        let mut gone = Gone {
            way,
            ..Gone::default()
        };
        if LEDGER {
            gone.path = way.abs();
            gone.add(self.table.energies(cell).of(inner));
            gone.add(series.energies(time));
        }
        Some(Stopped {
            gone,
            net: net + (e - excess) - self.rates.stiffness * way,
            excess,
            left: (cells - cell) as f64 * width - time,
        })
    }

    /// The rest of the interval from a stop, in a direction that is kept; the velocity at its end, or
    /// `None` when it may not be kept.
    fn move_on<const LEDGER: bool>(
        &self,
        stopped: &mut Stopped,
        inner: &Inner,
        direction: f64,
    ) -> Option<f64> {
        let width = self.table.cell;
        let sign = 1.0_f64.copysign(direction);
        // At most N: a whole number that fits.
        let cells = (stopped.left / width).floor();
        let rest = stopped.left - cells * width;
        let cells = cells as usize;
        let series = Short::new(&self.rates, *inner);
        let [way, velocity, added] = series.added(rest);
        let [_, p, e] = *inner;
        let then = [velocity, p - added - self.rates.stiffness * way, e + added];
        let map = self.table.map(cells);
        let velocity = dot(&map.velocity, &then);
        let second = if self.single {
            velocity * sign < 0.0
        } else {
            // v ≥ v̇₀t − ½t²·|v̈|, with |v̈| ≤ 8·sag, in the first cell; in the last a part of one.
            let sag = self.most_sag(inner) * width;
            let last = (dot(&map.velocity, inner) * sign).min(velocity * sign);
            p * sign * self.rates.inverse_mass <= 4.0 * sag
                || cells == 0
                || self.first_doubt(inner, sign, 1, cells) < cells
                || last <= sag * width
        };
        if second {
            return None;
        }
        let way = way + dot(&map.way, &then);
        let gone = &mut stopped.gone;
        gone.way += way;
        if LEDGER {
            gone.path += way.abs();
            gone.add(series.energies(rest));
            gone.add(self.table.energies(cells).of(&then));
        }
        Some(velocity)
    }

    /// v, p and e after the time of a map.
    fn led(&self, map: &Map, inner: &Inner) -> Inner {
        let [_, p, e] = *inner;
        let excess = map.excess * e;
        let way = dot(&map.way, inner);
        let p = p + (e - excess) - self.rates.stiffness * way;
        [dot(&map.velocity, inner), p, excess]
    }
}

impl Gone {
    /// Adds to ∫v² and ∫ev.
    fn add(&mut self, [square, lagging]: [f64; 2]) {
        self.square += square;
        self.lagging += lagging;
    }

    /// The whole interval: how it ends from what was gone.
    #[inline(always)]
    fn ended(self, start: &State<f64>, command: f64, velocity: f64, excess: f64) -> Flowed<f64> {
        Flowed {
            end: State {
                xi: start.xi + self.way,
                velocity,
                output: command - excess,
            },
            path: self.path,
            square: self.square,
            work: command * self.way - self.lagging,
        }
    }
}
