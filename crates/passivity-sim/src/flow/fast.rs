//! The motion over an interval in doubles, by propagators: with an amplifier's lag or an arm.
//!
//! Where the velocity keeps its sign a whole interval is a few products. That it does is tested first,
//! by signs and slopes at both ends: see [`Fast::keeps`]. A stop is looked for in the [`Table`] of
//! propagators and in its cell by Newton's iteration on a short power series; the device then rests
//! or moves on, and what is left of the interval is a product again. What none of this decides, a
//! second stop or a velocity that just touches 0, is left to the series of the whole interval,
//! [`Flow::advance`].

use super::events::{Event, decide};
use super::propagator::{Map, Table};
use super::short::{Inner, Rates, dot};
use super::turn::Exponentials;
use super::{Flow, Flowed, State};
use crate::number::Double;

/// The motion of a scene over an interval.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fast {
    pub(super) rates: Rates,
    /// σ; 0 without Coulomb friction.
    pub(super) sigma: f64,
    coulomb: bool,
    lags: bool,
    pub(super) whole: Map,
    pub(super) table: Table,
    /// Whether v̇, and v̈ as well, is 0 at most once within an interval.
    single: bool,
    /// ⅛ of the most that |v̈| can be within an interval, for each unit of |v|, |p| and |e| at its
    /// start; infinite when that is not known. See [`Table::sag`].
    sag: Inner,
    /// What is quicker about stops and starts, where the motion is a sum of exponentials.
    pub(crate) exponentials: Option<Exponentials>,
    /// What decides the rest.
    careful: Flow<Double>,
}

/// The map over a whole interval, for lanes.
pub(crate) struct Propagator {
    /// The way, as it depends on v, p and e.
    pub(crate) way: Inner,
    /// The velocity at the end.
    pub(crate) velocity: Inner,
    /// The excess at the end, for an excess of 1.
    pub(crate) excess: f64,
    /// β′.
    pub(crate) damping: f64,
    /// k.
    pub(crate) stiffness: f64,
}

/// What was gone of an interval: the way, ∫|v|, ∫v² and ∫ev.
#[derive(Clone, Copy, Default)]
pub(super) struct Gone {
    pub(super) way: f64,
    pub(super) path: f64,
    square: f64,
    lagging: f64,
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
        let mut fast = Self {
            sigma: flow.sigma.map_or(0.0, |sigma| sigma.0),
            coulomb: flow.sigma.is_some(),
            lags,
            whole: table.whole(),
            single: stiffness == 0.0 || (!lags && frequency < 9.0),
            sag: table.sag(&rates),
            table,
            rates,
            exponentials: None,
            careful: flow.clone(),
        };
        fast.exponentials = Exponentials::of(&fast);
        fast
    }

    /// Whether there is an amplifier.
    pub(crate) const fn lags(&self) -> bool {
        self.lags
    }

    /// Whether signs decide where the velocity keeps its own, so that lanes can do the motion.
    pub(crate) fn in_lanes(&self) -> bool {
        self.single && self.coulomb && self.table.cells().is_some()
    }

    /// The map over an interval and what [`Self::keeps`] needs beside it.
    pub(crate) const fn propagator(&self) -> Propagator {
        Propagator {
            way: self.whole.way,
            velocity: self.whole.velocity,
            excess: self.whole.excess,
            damping: self.rates.damping,
            stiffness: self.rates.stiffness,
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
    pub(super) fn driven(&self, start: &State<f64>, command: f64, force: f64) -> (f64, f64) {
        let pulled = force - self.rates.stiffness * start.xi;
        if self.lags {
            (start.output + pulled, command - start.output)
        } else {
            (command + pulled, 0.0)
        }
    }

    /// An interval in which the velocity keeps its sign.
    #[inline(always)]
    pub(super) fn whole<const LEDGER: bool>(
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
        let turned = self.turned(start, command, force);
        if !LEDGER && turned.is_some() {
            return turned;
        }
        let mut events = [Event::new(self, start.clone(), command, force)];
        decide::<1, LEDGER>(&mut events);
        let [event] = events;
        let flowed = event.end_or_carefully::<LEDGER>()?;
        // The energies do not care for a rounding of the end.
        let end = turned.map_or(flowed.end, |turned| turned.end);
        Some(Flowed { end, ..flowed })
    }

    /// The same in closed form, where there is one and it decides; without energies.
    #[inline(always)]
    pub(super) fn turned(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
    ) -> Option<Flowed<f64>> {
        let exponentials = self.exponentials.as_ref()?;
        let (net, excess) = self.driven(start, command, force);
        let v = start.velocity;
        let inner = [v, net - self.sigma.copysign(v), excess];
        let last = dot(&self.whole.velocity, &inner);
        exponentials.turn(start, command, [net, excess, last])
    }

    /// The interval by the power series of the whole of it.
    #[cold]
    pub(super) fn carefully<const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
    ) -> Option<Flowed<f64>> {
        self.careful.advance_doubles(start, command, force, LEDGER)
    }

    /// The cell of the table in which the velocity first comes to 0, or that it does not; `None` when
    /// that is not decided.
    #[inline(always)]
    pub(super) fn crossed(&self, inner: &Inner, cells: usize) -> Option<Option<usize>> {
        let [v, ..] = *inner;
        let sign = 1.0_f64.copysign(v);
        let velocity = |cell: usize| dot(&self.table.map(cell).velocity, inner) * sign;
        if self.single && velocity(cells) < 0.0 {
            return Some(Some(self.table.change(inner, sign)));
        }
        let at = self.first_doubt(inner, sign, 0, cells);
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

    /// Whether a motion from rest may come to 0 again: from `inner` it goes to `then` within a cell, and
    /// from there in so many cells to a velocity at the end of the interval.
    #[inline(always)]
    pub(super) fn stops_again(
        &self,
        inner: &Inner,
        then: &Inner,
        direction: f64,
        cells: usize,
        velocity: f64,
    ) -> bool {
        let sign = 1.0_f64.copysign(direction);
        if self.single {
            return velocity * sign < 0.0 || velocity.is_nan();
        }
        let width = self.table.cell;
        // v ≥ v̇₀t − ½t²·|v̈|, with |v̈| ≤ 8·sag, in the first part of a cell.
        let [_, p, _] = *inner;
        let first = p * sign * self.rates.inverse_mass > 4.0 * self.most_sag(inner) * width;
        !first || self.first_doubt(then, sign, 0, cells) < cells
    }
}

impl Gone {
    /// Adds to ∫v² and ∫ev.
    pub(super) fn add(&mut self, [square, lagging]: [f64; 2]) {
        self.square += square;
        self.lagging += lagging;
    }

    /// The whole interval: how it ends from what was gone.
    #[inline(always)]
    pub(super) fn ended(
        self,
        start: &State<f64>,
        command: f64,
        velocity: f64,
        excess: f64,
    ) -> Flowed<f64> {
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
