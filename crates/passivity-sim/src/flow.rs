//! Motion within an interval with an amplifier's lag or an operator's arm.
//!
//! Between reversals the motion is linear, of up to third order: M·ξ̈ = y + F − β′ξ̇ − kξ − σs with
//! ẏ = κ(u − y), where M and β′ include the arm's mass and damping, k is its stiffness and s the
//! sign of ξ̇. Its solution is the exponential of a matrix. It is evaluated by the power series of
//! that exponential on pieces short enough that rate × piece ≤ ½, where n terms leave 2⁻ⁿ/n! of the
//! first: the error is rounding, not a step size, and an interval grows by it. What a whole piece does
//! is a table that is made once. Reversals are bracketed by the signs of ξ̇ and ξ̈ at the ends of a
//! piece and found by safeguarded Newton iteration on the series. That serves every kind of number; in
//! doubles [`Fast`] does the same by propagators, and comes here for what they leave.

mod after;
mod events;
mod fast;
mod nearest;
mod power;
mod products;
mod propagator;
mod short;
mod signs;
mod table;
mod turn;
mod wide;

use std::cmp::Ordering;
use std::sync::OnceLock;

use passivity_core::{Effect, Loop};

use crate::error::SimError;
use crate::number::{Double, Real, Undecided};
use crate::series;
pub(crate) use fast::{Attempt, Fast, Kind};
use table::{Start, Table};
pub(crate) use turn::{LONG, Near, Onward, SHORT, Turns};
pub(crate) use wide::Wide;

/// The largest rate, per sampling period, that is simulated.
pub(crate) const FASTEST: f64 = 4096.0;

/// The linear motion between reversals.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Flow<R> {
    /// M = μ + the arm's mass.
    pub mass: R,
    /// β.
    pub beta: R,
    /// σ; `None` without Coulomb friction.
    pub sigma: Option<R>,
    /// κ, the reciprocal of the amplifier's time constant in sampling periods.
    pub rate: Option<R>,
    /// The arm's damping and stiffness.
    pub arm: Option<[R; 2]>,
    /// How many pieces an interval has.
    pub pieces: u32,
    /// The motion over one of them, once it was asked for.
    pub whole: OnceLock<Box<Table<R>>>,
}

/// The state that is carried from piece to piece.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State<R> {
    /// ξ.
    pub xi: R,
    /// ξ̇.
    pub velocity: R,
    /// y, the amplifier's output.
    pub output: R,
}

/// What becomes of a device at rest.
enum Rest<R> {
    Stays,
    LetsGo,
    LetsGoAfter(R),
}

/// What happened over an interval.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Flowed<R> {
    /// The state at its end.
    pub end: State<R>,
    /// ∫|ξ̇|dτ.
    pub path: R,
    /// ∫ξ̇²dτ.
    pub square: R,
    /// ∫y·ξ̇dτ, the work of the amplifier's output.
    pub work: R,
}

impl Flow<Double> {
    /// The flow of a scene with an amplifier or an arm; `None` without either.
    ///
    /// # Errors
    ///
    /// A rate above [`FASTEST`].
    pub(crate) fn compile(the_loop: &Loop<Double>, mass: Double) -> Result<Option<Self>, SimError> {
        let flow = Self::of(the_loop, mass, 1);
        if flow.rate.is_none() && flow.arm.is_none() {
            return Ok(None);
        }
        let pieces = flow.pieces_needed()?;
        Ok(Some(Self { pieces, ..flow }))
    }

    /// The largest rate of the motion, per sampling period.
    fn fastest(&self) -> f64 {
        let [damping, stiffness] = self.arm.map_or([0.0; 2], |arm| arm.map(|x| x.0));
        let amplifier = self.rate.map_or(0.0, |rate| rate.0);
        let friction = (self.beta.0 + damping) / self.mass.0;
        amplifier
            .max(friction)
            .max((stiffness / self.mass.0).sqrt())
    }

    /// How many pieces make rate × piece ≤ ½.
    fn pieces_needed(&self) -> Result<u32, SimError> {
        let rate = self.fastest();
        if rate > FASTEST {
            return Err(SimError::TooFast {
                rate,
                limit: FASTEST,
            });
        }
        // 2·rate ≤ 8192 fits, and 1 is the least.
        Ok((2.0 * rate).ceil().max(1.0) as u32)
    }

    /// For the plan: what is in the motion.
    #[must_use]
    pub(crate) fn describe(&self) -> String {
        let mut text = String::new();
        if let Some(Double(rate)) = self.rate {
            text += &format!(", amplifier ẏ = {rate}·(u − y)");
        }
        if let Some([Double(damping), Double(stiffness)]) = self.arm {
            text += &format!(
                ", arm −{damping}·ξ̇ − {stiffness}·ξ, moving mass {}",
                self.mass.0
            );
        }
        text + &format!(", {} pieces an interval", self.pieces)
    }

    /// [`advance`](Self::advance) in bare doubles; `None` when they have overflowed.
    pub(crate) fn advance_doubles(
        &self,
        start: &State<f64>,
        command: f64,
        force: f64,
        ledger: bool,
    ) -> Option<Flowed<f64>> {
        let start = start.map(|x| Double(*x));
        let flowed = self.advance(&start, &Double(command), &Double(force), ledger);
        let flowed = flowed.ok()?;
        Some(Flowed {
            end: flowed.end.map(|x| x.0),
            path: flowed.path.0,
            square: flowed.square.0,
            work: flowed.work.0,
        })
    }
}

impl<R> State<R> {
    /// The same state in other numbers.
    pub(crate) fn map<U>(&self, f: impl Fn(&R) -> U) -> State<U> {
        State {
            xi: f(&self.xi),
            velocity: f(&self.velocity),
            output: f(&self.output),
        }
    }
}

impl<R: Real> Flow<R> {
    /// The flow of a dimensionless loop whose device has this mass, on so many pieces an interval.
    pub(crate) fn of(the_loop: &Loop<R>, mass: R, pieces: u32) -> Self {
        let or_zero = |x: &Option<R>| x.clone().unwrap_or_else(R::zero);
        let has_arm = the_loop.has(Effect::Arm);
        Self {
            mass: match &the_loop.arm_mass {
                Some(arm) => mass + arm.clone(),
                None => mass,
            },
            beta: the_loop.viscous_friction(),
            sigma: the_loop.coulomb.clone(),
            rate: the_loop
                .time_constant
                .as_ref()
                .map(|time| time.whole(1).over(time.clone())),
            arm: has_arm.then(|| [&the_loop.arm_damping, &the_loop.arm_stiffness].map(or_zero)),
            pieces,
            whole: OnceLock::new(),
        }
    }

    /// Whether the operator's arm holds the device.
    #[must_use]
    pub(crate) const fn has_arm(&self) -> bool {
        self.arm.is_some()
    }

    /// What acts on the device at rest: y + F − kξ.
    #[must_use]
    pub(crate) fn net(&self, state: &State<R>, force: &R) -> R {
        let pull = state.output.clone() + force.clone();
        match &self.arm {
            Some([_, stiffness]) => pull - stiffness.clone() * state.xi.clone(),
            None => pull,
        }
    }

    /// The motion over a whole interval, `command` and `force` being constant; `ledger` says whether
    /// ∫ξ̇² and the work are wanted (else they are 0).
    ///
    /// # Errors
    ///
    /// [`Undecided`] when the numbers cannot tell a sign.
    pub(crate) fn advance(
        &self,
        start: &State<R>,
        command: &R,
        force: &R,
        ledger: bool,
    ) -> Result<Flowed<R>, Undecided> {
        let whole = self.whole.get_or_init(|| {
            // At most 2·FASTEST of them.
            let pieces = i32::try_from(self.pieces).unwrap_or(i32::MAX);
            Box::new(self.table(&self.mass.ratio(1, pieces)))
        });
        let mut flowed = Flowed {
            end: start.clone(),
            path: R::zero(),
            square: R::zero(),
            work: R::zero(),
        };
        if self.rate.is_none() {
            flowed.end.output = command.clone();
        }
        for _ in 0..self.pieces {
            self.piece(&mut flowed, command, force, whole, ledger)?;
        }
        Ok(flowed)
    }

    /// A piece of the interval, with its reversals and its time at rest.
    fn piece(
        &self,
        flowed: &mut Flowed<R>,
        command: &R,
        force: &R,
        piece: &Table<R>,
        ledger: bool,
    ) -> Result<(), Undecided> {
        // Each stop is followed by a motion the other way or by rest. More than a few within half a
        // time constant can only be rounding about a stop; the device then rests until the piece ends.
        const MOST_STOPS: u32 = 16;
        let Some(sigma) = &self.sigma else {
            let start = self.start(&flowed.end, command, force, &R::zero());
            self.take(flowed, command, piece, &start, ledger);
            return Ok(());
        };
        let mut rest_of_piece: Option<Table<R>> = None;
        for _ in 0..MOST_STOPS {
            let mut direction = flowed.end.velocity.sign().ok_or(Undecided)?;
            let mut waited = false;
            if direction == Ordering::Equal {
                let left = rest_of_piece.as_ref().unwrap_or(piece);
                match self.rest(flowed, command, force, sigma, left)? {
                    Rest::Stays => return Ok(()),
                    Rest::LetsGo => {}
                    Rest::LetsGoAfter(time) => {
                        rest_of_piece = Some(self.table(&(left.length.clone() - time)));
                        waited = true;
                    }
                }
                direction = self.net(&flowed.end, force).sign().ok_or(Undecided)?;
            }
            let table = rest_of_piece.as_ref().unwrap_or(piece);
            let friction = match direction {
                Ordering::Less => -sigma.clone(),
                _ => sigma.clone(),
            };
            let start = self.start(&flowed.end, command, force, &friction);
            // What pulled the device loose pulls it more and more.
            let stop = if waited {
                None
            } else {
                self.stop(table, &start, direction)?
            };
            let Some(at) = stop else {
                self.take(flowed, command, table, &start, ledger);
                return Ok(());
            };
            let until = at * table.length.clone();
            let after = table.length.clone() - until.clone();
            self.take(flowed, command, &self.table(&until), &start, ledger);
            flowed.end.velocity = R::zero();
            rest_of_piece = Some(self.table(&after));
        }
        if R::ENCLOSES {
            return Err(Undecided);
        }
        let left = rest_of_piece.as_ref().unwrap_or(piece);
        flowed.end.output = left.output(&flowed.end.output, command);
        Ok(())
    }

    /// What a motion against `friction` starts with.
    fn start(&self, from: &State<R>, command: &R, force: &R, friction: &R) -> Start<R> {
        let pull = command.clone() + force.clone() - friction.clone();
        Start {
            velocity: from.velocity.clone(),
            excess: from.output.clone() - command.clone(),
            pull: match &self.arm {
                Some([_, stiffness]) => pull - stiffness.clone() * from.xi.clone(),
                None => pull,
            },
        }
    }

    /// At rest for what is left of a piece, or until the device starts.
    fn rest(
        &self,
        flowed: &mut Flowed<R>,
        command: &R,
        force: &R,
        sigma: &R,
        left: &Table<R>,
    ) -> Result<Rest<R>, Undecided> {
        let lets_go = |net: &R| Ok(net.abs().compare(sigma).ok_or(Undecided)?.is_gt());
        if lets_go(&self.net(&flowed.end, force))? {
            return Ok(Rest::LetsGo);
        }
        let later = State {
            output: left.output(&flowed.end.output, command),
            ..flowed.end.clone()
        };
        let net = self.net(&later, force);
        let (Some(rate), true) = (&self.rate, lets_go(&net)?) else {
            flowed.end = later;
            return Ok(Rest::Stays);
        };
        // The output tends from y to u, and with e^(κτ) = (y − u)/(y* − u) it is y*, against which
        // friction just holds.
        let most = match net.sign().ok_or(Undecided)? {
            Ordering::Less => -sigma.clone(),
            _ => sigma.clone(),
        };
        let loose = most - (net - later.output);
        let passed = flowed.end.output.clone() - loose.clone();
        let time = series::ln_1p(&passed.over(loose.clone() - command.clone())).over(rate.clone());
        flowed.end.output = loose;
        Ok(Rest::LetsGoAfter(time))
    }

    /// Takes the motion to the end of a piece on which the velocity keeps its sign.
    fn take(
        &self,
        flowed: &mut Flowed<R>,
        command: &R,
        table: &Table<R>,
        start: &Start<R>,
        ledger: bool,
    ) {
        let end = table.end(start);
        if self.rate.is_some() {
            flowed.end.output = table.output(&flowed.end.output, command);
        }
        if ledger {
            let [square, excess] = table.integrals(self, start);
            flowed.square = flowed.square.clone() + square;
            flowed.work = flowed.work.clone() + command.clone() * end.way.clone() + excess;
        }
        flowed.path = flowed.path.clone() + end.way.abs();
        flowed.end.xi = flowed.end.xi.clone() + end.way;
        flowed.end.velocity = end.velocity;
    }
}

#[cfg(test)]
mod tests;
