//! Motion within an interval with an amplifier's lag or an operator's arm.
//!
//! Between reversals the motion is linear, of up to third order: M·ξ̈ = y + F − β′ξ̇ − kξ − σs with
//! ẏ = κ(u − y), where M and β′ include the arm's mass and damping, k is its stiffness and s the
//! sign of ξ̇. Its solution is the exponential of a matrix. It is evaluated by the power series of
//! that exponential on pieces short enough that rate × piece ≤ ½, where n terms leave 2⁻ⁿ/n! of the
//! first: the error is rounding, not a step size. Reversals are bracketed by the signs of ξ̇ and ξ̈
//! at the ends of a piece and found by safeguarded Newton iteration on the series. That serves every
//! kind of number; in doubles [`Fast`] does the same by propagators, and comes here for what they leave.

mod after;
mod events;
mod fast;
mod nearest;
mod power;
mod propagator;
mod short;
mod signs;
mod turn;
mod wide;

use std::cmp::Ordering;

use passivity_core::{Effect, Loop};

use crate::error::SimError;
use crate::number::{Double, Real, Undecided};
pub(crate) use fast::{Attempt, Fast, Kind};
use power::{Series, horner, terms};
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
        // At most 2·FASTEST of them.
        let pieces = i32::try_from(self.pieces).unwrap_or(i32::MAX);
        let piece = self.mass.ratio(1, pieces);
        let mut flowed = Flowed {
            end: start.clone(),
            path: R::zero(),
            square: R::zero(),
            work: R::zero(),
        };
        if self.rate.is_none() {
            flowed.end.output = command.clone();
        }
        for _ in 0..pieces {
            self.piece(&mut flowed, command, force, &piece, ledger)?;
        }
        Ok(flowed)
    }

    /// A piece of the interval, with its reversals and its time at rest.
    fn piece(
        &self,
        flowed: &mut Flowed<R>,
        command: &R,
        force: &R,
        piece: &R,
        ledger: bool,
    ) -> Result<(), Undecided> {
        // Each stop is followed by a motion the other way or by rest. More than a few within half a
        // time constant can only be rounding about a stop; the device then rests until the piece ends.
        const MOST_STOPS: u32 = 16;
        let mut left = piece.clone();
        let Some(sigma) = &self.sigma else {
            let series = self.series(&flowed.end, command, force, &R::zero(), &left);
            self.take(flowed, &series, &left.whole(1), ledger);
            return Ok(());
        };
        for _ in 0..MOST_STOPS {
            let mut direction = flowed.end.velocity.sign().ok_or(Undecided)?;
            if direction == Ordering::Equal {
                let wait = self.rest(flowed, command, force, sigma, &left)?;
                let Some(wait) = wait else { return Ok(()) };
                left = left - wait;
                direction = self.net(&flowed.end, force).sign().ok_or(Undecided)?;
            }
            let friction = match direction {
                Ordering::Less => -sigma.clone(),
                _ => sigma.clone(),
            };
            let series = self.series(&flowed.end, command, force, &friction, &left);
            let Some(at) = series.stop(direction)? else {
                self.take(flowed, &series, &left.whole(1), ledger);
                return Ok(());
            };
            self.take(flowed, &series, &at, ledger);
            flowed.end.velocity = R::zero();
            left = left.clone() - left * at;
        }
        self.idle(flowed, command, &left);
        flowed.end.velocity = R::zero();
        Ok(())
    }

    /// At rest: how long until the device starts, within `left`; `None` when it does not.
    fn rest(
        &self,
        flowed: &mut Flowed<R>,
        command: &R,
        force: &R,
        sigma: &R,
        left: &R,
    ) -> Result<Option<R>, Undecided> {
        let lets_go = |state: &State<R>| {
            let net = self.net(state, force).abs();
            Ok(net.compare(sigma).ok_or(Undecided)?.is_gt())
        };
        if lets_go(&flowed.end)? {
            return Ok(Some(R::zero()));
        }
        let after = |time: &R| State {
            output: self.output_after(&flowed.end.output, command, time),
            ..flowed.end.clone()
        };
        let later = after(left);
        if !lets_go(&later)? {
            flowed.end = later;
            return Ok(None);
        }
        // The output is monotone: the time at which it lets go is bracketed by 0 and `left`.
        let (mut low, mut high) = (R::zero(), left.clone());
        for _ in 0..left.bits() + 4 {
            let middle = (low.clone() + high.clone()).half();
            if lets_go(&after(&middle))? {
                high = middle;
            } else {
                low = middle;
            }
        }
        self.idle(flowed, command, &high);
        Ok(Some(high))
    }

    /// Lets time pass at rest.
    fn idle(&self, flowed: &mut Flowed<R>, command: &R, time: &R) {
        flowed.end.output = self.output_after(&flowed.end.output, command, time);
    }

    /// The amplifier's output after a time of at most a piece.
    fn output_after(&self, output: &R, command: &R, time: &R) -> R {
        let Some(rate) = &self.rate else {
            return command.clone();
        };
        let x = -(rate.clone() * time.clone());
        let mut term = output.clone() - command.clone();
        let mut sum = command.clone() + term.clone();
        for n in 1..terms(self.mass.bits()) {
            term = term * x.clone() * self.mass.ratio(1, n);
            sum = sum + term.clone();
        }
        sum
    }

    /// The series of the motion from a state, on a piece of length `h`, against `friction`.
    fn series(&self, from: &State<R>, command: &R, force: &R, friction: &R, h: &R) -> Series<R> {
        match (&self.rate, &self.arm) {
            (Some(_), Some(_)) => self.series_with::<true, true>(from, command, force, friction, h),
            (Some(_), None) => self.series_with::<true, false>(from, command, force, friction, h),
            (None, Some(_)) => self.series_with::<false, true>(from, command, force, friction, h),
            (None, None) => self.series_with::<false, false>(from, command, force, friction, h),
        }
    }

    /// The terms of the series; what is not there, amplifier or arm, is not in the loop over them.
    fn series_with<const LAG: bool, const ARM: bool>(
        &self,
        from: &State<R>,
        command: &R,
        force: &R,
        friction: &R,
        h: &R,
    ) -> Series<R> {
        let count = terms(h.bits());
        let damping = match &self.arm {
            Some([damping, _]) => self.beta.clone() + damping.clone(),
            None => self.beta.clone(),
        };
        let per_mass = h.clone().over(self.mass.clone());
        let damped = damping * per_mass.clone();
        let pulled = h.clone() * per_mass;
        let room = usize::try_from(count).unwrap_or(2);
        let mut output = Vec::with_capacity(if LAG { room } else { 1 });
        output.push(from.output.clone());
        let mut excess = from.output.clone() - command.clone();
        let mut xi = Vec::with_capacity(room);
        let mut before = from.xi.clone(); // c_{n−2}
        let mut latest = from.velocity.clone() * h.clone(); // c_{n−1}
        xi.extend([before.clone(), latest.clone()]);
        // y_{n−2}, with the constant forces where n = 2.
        let mut pull = from.output.clone() + force.clone() - friction.clone();
        for n in 2..count {
            // c_n = h²/(n(n − 1))·(y_{n−2} + [F − σs] − kc_{n−2} − β′(n − 1)c_{n−1}/h)/M.
            if ARM && let Some([_, stiffness]) = &self.arm {
                pull = pull - stiffness.clone() * before;
            }
            let drag = damped.clone() * latest.clone() * R::integer(n - 1);
            let next = (pull * pulled.clone() - drag) * h.ratio(1, n * (n - 1));
            xi.push(next.clone());
            before = std::mem::replace(&mut latest, next);
            pull = if LAG && let Some(rate) = &self.rate {
                excess = -(excess * rate.clone() * h.clone()) * h.ratio(1, n - 1);
                output.push(excess.clone());
                excess.clone()
            } else {
                R::zero()
            };
        }
        Series {
            xi,
            output,
            h: h.clone(),
        }
    }

    /// Takes the motion to the fraction `s` of a series, on which the velocity keeps its sign.
    fn take(&self, flowed: &mut Flowed<R>, series: &Series<R>, s: &R, ledger: bool) {
        let from = flowed.end.xi.clone();
        if ledger {
            let (square, work) = series.integrals(s);
            flowed.square = flowed.square.clone() + square;
            flowed.work = flowed.work.clone() + work;
        }
        flowed.end.xi = horner(series.xi.iter(), s);
        flowed.end.velocity = series.velocity(s);
        if self.rate.is_some() {
            flowed.end.output = horner(series.output.iter(), s);
        }
        let d = flowed.end.xi.clone() - from;
        flowed.path = flowed.path.clone() + d.abs();
    }
}

#[cfg(test)]
mod tests;
