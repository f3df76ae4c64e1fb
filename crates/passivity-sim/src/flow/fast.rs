//! The motion over an interval in doubles, by propagators: with an amplifier's lag or an arm.
//!
//! Where the velocity keeps its sign a whole interval is a few products. That it does is tested first,
//! by signs and slopes at both ends: see [`Fast::keeps`]. A stop is looked for among the nodes of the
//! [`Table`] of propagators and about the nearest one on a short power series; the device then rests
//! or moves on, and what is left of the interval is such a product and series again: see
//! [`events`](super::events). What none of this decides, a second stop or a velocity that just touches 0, is
//! left to the series of the whole interval, [`Flow::advance`].

use super::nearest::partly;
use super::propagator::{Map, Table};
use super::short::{Inner, Rates};
use super::turn::{LONG, SHORT, SHORT_CELL, Turns};
use super::{Flow, Flowed, State};
use crate::number::Double;

/// The motion of a scene over an interval.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fast {
    pub(super) rates: Rates,
    /// σ; 0 without Coulomb friction.
    pub(super) sigma: f64,
    coulomb: bool,
    pub(super) lags: bool,
    pub(super) whole: Map,
    pub(super) table: Table,
    /// Whether v̇, and v̈ as well, is 0 at most once within an interval.
    pub(super) single: bool,
    /// ⅛ of the most that |v̈| can be within an interval, for each unit of |v|, |p| and |e| at its
    /// start; infinite when that is not known. See [`Table::sag`].
    pub(super) sag: Inner,
    /// The constants of series about nodes.
    pub(crate) turns: Turns,
    /// Whether the shorter ones do, without an amplifier.
    short: bool,
    /// 1/κ; 0 without an amplifier.
    pub(super) over_rate: f64,
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

/// An interval in which the velocity may not keep its sign.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Attempt {
    /// y + F − kξ at the start.
    pub(crate) net: f64,
    /// v, p and e there.
    pub(crate) inner: Inner,
    /// The way and the velocity at the end if the velocity kept its sign.
    pub(crate) way: f64,
    pub(crate) velocity: f64,
    /// Mv̇ at both ends then.
    pub(crate) slopes: [f64; 2],
}

/// What is in a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// No amplifier, and cells short against all rates.
    SlowArm,
    /// No amplifier.
    Arm,
    Amplifier,
    Both,
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
        let fastest = flow.fastest();
        let table = Table::new(&rates, fastest);
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
            turns: Turns {
                inverse_mass: rates.inverse_mass,
                lambda: rates.damping * rates.inverse_mass,
                stiffness,
                spring: stiffness * rates.inverse_mass,
                rate: rates.rate,
                driven: rates.rate * rates.inverse_mass,
                cell: table.cell,
            },
            short: !lags && fastest * table.cell <= SHORT_CELL,
            over_rate: if lags { 1.0 / rates.rate } else { 0.0 },
            table,
            rates,
            careful: flow.clone(),
        }
    }

    /// Whether signs decide where the velocity keeps its own, so that lanes can do the motion.
    pub(crate) fn in_lanes(&self) -> bool {
        self.single && self.coulomb && self.table.cells() > 0
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

    /// What is in the motion.
    pub(crate) const fn kind(&self) -> Kind {
        match (self.lags, self.rates.stiffness != 0.0) {
            (true, true) => Kind::Both,
            (true, false) => Kind::Amplifier,
            (false, _) if self.short => Kind::SlowArm,
            (false, _) => Kind::Arm,
        }
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
        match self.kind() {
            Kind::SlowArm => self.advance_in::<SHORT, false, true, LEDGER>(start, command, force),
            Kind::Arm => self.advance_in::<LONG, false, true, LEDGER>(start, command, force),
            Kind::Amplifier => self.advance_in::<LONG, true, false, LEDGER>(start, command, force),
            Kind::Both => self.advance_in::<LONG, true, true, LEDGER>(start, command, force),
        }
    }

    /// The same for what is in the motion: `T` terms of series about nodes, an amplifier, an arm.
    #[inline(always)]
    pub(crate) fn advance_in<
        const T: usize,
        const LAG: bool,
        const ARM: bool,
        const LEDGER: bool,
    >(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
    ) -> Option<Flowed<f64>> {
        match self.straight::<LAG, ARM, LEDGER>(start, command, force) {
            Ok(flowed) => Some(flowed),
            Err(attempt) => {
                let decided = self.decide::<T, LAG, ARM, LEDGER>(start, command, &attempt);
                if decided.is_some() {
                    return decided;
                }
                let Flowed {
                    end,
                    path,
                    square,
                    work,
                } = self.carefully::<LEDGER>(start, command, force)?;
                // Taken apart, so that the others need not be in memory.
                Some(Flowed {
                    end,
                    path,
                    square,
                    work,
                })
            }
        }
    }

    /// The same where the velocity surely keeps its sign, else where it would lead if it did.
    #[inline(always)]
    pub(crate) fn straight<const LAG: bool, const ARM: bool, const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
    ) -> Result<Flowed<f64>, Attempt> {
        let pulled = if ARM {
            force - self.rates.stiffness * start.xi
        } else {
            force
        };
        let (net, excess) = if LAG {
            (start.output + pulled, command - start.output)
        } else {
            (command + pulled, 0.0)
        };
        let v = start.velocity;
        if !self.coulomb {
            return Ok(self.whole::<LAG, LEDGER>(start, command, &[v, net, excess]));
        }
        let direction = if v == 0.0 { net } else { v };
        let inner = [v, net - self.sigma.copysign(direction), excess];
        let flowed = self.whole::<LAG, LEDGER>(start, command, &inner);
        let attempt = self.attempt::<LAG, ARM>(net, inner, start.xi, &flowed.end);
        let sticks = v == 0.0 && net.abs() <= self.sigma;
        if !sticks && self.keeps(&attempt, direction) {
            Ok(flowed)
        } else {
            Err(attempt)
        }
    }

    /// What is known of a motion from y + F − kξ, from v, p and e, and from ξ to this end.
    #[inline(always)]
    fn attempt<const LAG: bool, const ARM: bool>(
        &self,
        net: f64,
        inner: Inner,
        xi: f64,
        end: &State<f64>,
    ) -> Attempt {
        let [v, p, e] = inner;
        let mut last = p;
        if LAG {
            last += e - self.whole.excess * e;
        }
        if ARM {
            last -= self.rates.stiffness * (end.xi - xi);
        }
        Attempt {
            net,
            inner,
            way: partly::<LAG>(&self.whole.way, &inner),
            velocity: end.velocity,
            slopes: [
                p - self.rates.damping * v,
                last - self.rates.damping * end.velocity,
            ],
        }
    }

    /// An interval in which the velocity keeps its sign.
    #[inline(always)]
    pub(super) fn whole<const LAG: bool, const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        inner: &Inner,
    ) -> Flowed<f64> {
        let way = partly::<LAG>(&self.whole.way, inner);
        let mut gone = Gone::over(way);
        if LEDGER {
            gone.path = way.abs();
            gone.add(self.table.whole_energies().of(inner));
        }
        let velocity = partly::<LAG>(&self.whole.velocity, inner);
        let [.., excess] = *inner;
        let excess = if LAG { self.whole.excess * excess } else { 0.0 };
        gone.ended(start, command, velocity, excess)
    }

    /// The interval by the power series of the whole of it.
    #[cold]
    #[inline(never)]
    pub(crate) fn carefully<const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
    ) -> Option<Flowed<f64>> {
        self.careful.advance_doubles(start, command, force, LEDGER)
    }
}

impl Gone {
    /// A way, whatever led there.
    #[inline(always)]
    pub(super) fn over(way: f64) -> Self {
        Self {
            way,
            ..Self::default()
        }
    }

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
