//! Intervals in which the device stops, starts, or may do so.

use super::after::{After, Friction};
use super::fast::{Attempt, Fast, Gone};
use super::short::Inner;
use super::turn::{Near, SHORT};
use super::wide::Wide;
use super::{Flowed, State};

/// A stop: so long after a node, near which the motion is this.
struct Stopped {
    node: usize,
    time: f64,
    near: Near,
}

impl Fast {
    /// An interval in which the device stops, starts, or may do so, at most once each; `None` when that is not
    /// decided.
    #[inline(always)]
    pub(super) fn decide<const T: usize, const LAG: bool, const ARM: bool, const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        attempt: &Attempt,
    ) -> Option<Flowed<f64>> {
        let cells = self.table.cells();
        if cells == 0 {
            return None;
        }
        let inner = &attempt.inner;
        let [v, ..] = *inner;
        if v == 0.0 {
            if attempt.net.abs() > self.sigma {
                // It starts at once.
                let turns = self.stops_again(inner, inner, attempt.net, cells, attempt.velocity);
                return (!turns).then(|| self.whole::<LAG, LEDGER>(start, command, inner));
            }
            let after = self.held::<LAG>(attempt, 0.0)?;
            return self.led::<T, LAG, ARM, LEDGER>(start, command, attempt, None, &after);
        }
        let stop = if self.is_single::<T, LAG, ARM>() && v * attempt.velocity < 0.0 {
            self.stop::<T, LAG, ARM>(inner, self.guess(attempt))?
        } else if let Some(cell) = self.crossed(*inner, cells)? {
            let middle = (cell as f64 + 0.5) * self.turns.cell;
            let stop = self.stop::<T, LAG, ARM>(inner, middle)?;
            // The first stop is in this cell; there may be others later.
            let at = stop.node as f64 * self.turns.cell + stop.time;
            if (at - middle).abs() > 0.51 * self.turns.cell {
                return None;
            }
            stop
        } else {
            return Some(self.whole::<LAG, LEDGER>(start, command, inner));
        };
        // What comes then is the same text three times, so that each has its own constants.
        let Stopped { node, time, near } = &stop;
        let after = match self.friction::<LAG, ARM>(attempt, near) {
            Friction::LetsGo => {
                let after = self.turned(attempt, *node, *time);
                return self.led::<T, LAG, ARM, LEDGER>(
                    start,
                    command,
                    attempt,
                    Some(&stop),
                    &after,
                );
            }
            Friction::Holds => {
                let [way, _] = self.reached::<T, LAG, ARM>(&stop);
                let after = self.held_after::<LAG>(attempt, *node, *time, way)?;
                return self.led::<T, LAG, ARM, LEDGER>(
                    start,
                    command,
                    attempt,
                    Some(&stop),
                    &after,
                );
            }
            Friction::Undecided => {
                let reached = self.reached::<T, LAG, ARM>(&stop);
                self.after_stop::<LAG, ARM>(attempt, *node, *time, near, reached)?
            }
        };
        self.led::<T, LAG, ARM, LEDGER>(start, command, attempt, Some(&stop), &after)
    }

    /// Whether v̇ is 0 at most once within an interval: known of an amplifier alone, and of slow arms.
    #[inline(always)]
    const fn is_single<const T: usize, const LAG: bool, const ARM: bool>(&self) -> bool {
        T == SHORT || (LAG && !ARM) || self.single
    }

    /// The interval with what comes after a stop, or after a start at rest.
    #[inline(always)]
    fn led<const T: usize, const LAG: bool, const ARM: bool, const LEDGER: bool>(
        &self,
        start: &State<f64>,
        command: f64,
        attempt: &Attempt,
        stopped: Option<&Stopped>,
        after: &After,
    ) -> Option<Flowed<f64>> {
        let (mut way, mut velocity) = (after.way, after.velocity);
        if after.direction != 0.0 {
            let onward = self.onward(after).wide();
            let [Wide([further]), Wide([faster])] =
                self.turns.single().onward::<T, LAG, ARM>(&onward);
            (way, velocity) = (way + further, velocity + faster);
            let goes = velocity * after.direction >= 0.0; // Not of what is no number.
            if !goes {
                return None;
            }
        }
        let single = self.is_single::<T, LAG, ARM>();
        let mut gone = Gone::over(way);
        if LEDGER || !single {
            let reached = match stopped {
                Some(stop) => self.reached::<T, LAG, ARM>(stop),
                None => [0.0; 2],
            };
            if !single && self.may_stop_again(attempt, after, reached, velocity) {
                return None;
            }
            if LEDGER {
                self.account(&mut gone, attempt, stopped, after, reached);
            }
        }
        let [.., excess] = attempt.inner;
        let excess = if LAG { self.whole.excess * excess } else { 0.0 };
        Some(gone.ended(start, command, velocity, excess))
    }

    /// A stop about which a first guess is known.
    #[inline(always)]
    fn stop<const T: usize, const LAG: bool, const ARM: bool>(
        &self,
        inner: &Inner,
        guess: f64,
    ) -> Option<Stopped> {
        let (node, near) = self.near::<LAG, ARM>(inner, guess)?;
        let (Wide([time]), [found]) = self.turns.single().stop::<T, LAG, ARM>(&near.wide());
        (found > 0.0).then_some(Stopped { node, time, near })
    }

    /// The way to a stop, and the excess there.
    #[inline(always)]
    fn reached<const T: usize, const LAG: bool, const ARM: bool>(
        &self,
        stop: &Stopped,
    ) -> [f64; 2] {
        let near = stop.near.wide();
        let [Wide([way]), Wide([excess])] = self
            .turns
            .single()
            .reached::<T, LAG, ARM>(&near, Wide([stop.time]));
        [way, excess]
    }

    /// v, p and e where the motion on begins.
    fn begins(&self, attempt: &Attempt, after: &After, reached: [f64; 2]) -> Inner {
        if !after.turned {
            return [0.0, 0.0, after.excess];
        }
        let [.., excess] = reached;
        let net = self.net_after::<true, true>(attempt, reached);
        [0.0, net - self.sigma.copysign(after.direction), excess]
    }

    /// Whether the motion on may come to 0 again, where signs at the end do not tell.
    #[inline(never)]
    fn may_stop_again(
        &self,
        attempt: &Attempt,
        after: &After,
        reached: [f64; 2],
        velocity: f64,
    ) -> bool {
        if after.direction == 0.0 {
            return false;
        }
        // From the node that is next.
        let cells = self.table.cells();
        let (node, first) = if after.time > 0.0 {
            ((after.node + 1).min(cells), self.turns.cell - after.time)
        } else {
            (after.node, -after.time)
        };
        let begins = self.begins(attempt, after, reached);
        let then = self.later(&begins, first);
        self.stops_again(&begins, &then, after.direction, cells - node, velocity)
    }

    /// v, p and e a time after others that is short against all rates.
    fn later(&self, inner: &Inner, time: f64) -> Inner {
        let [v, p, e] = *inner;
        let [way, faster, added] = self.rates.series(inner).added_alone(time);
        [
            v + faster,
            p - added - self.rates.stiffness * way,
            e + added,
        ]
    }

    /// What a ledger needs of such an interval.
    #[inline(never)]
    fn account(
        &self,
        gone: &mut Gone,
        attempt: &Attempt,
        stopped: Option<&Stopped>,
        after: &After,
        reached: [f64; 2],
    ) {
        let [way, _] = reached;
        gone.path = way.abs() + (gone.way - way).abs();
        if let Some(Stopped { node, time, near }) = stopped {
            gone.add(self.table.energies(*node).of(&attempt.inner));
            // p from the slope.
            let force = (near.slope + self.turns.lambda * near.velocity) / self.rates.inverse_mass;
            let series = self.rates.series(&[near.velocity, force, near.excess]);
            gone.add(series.energies(*time));
        }
        if after.direction != 0.0 {
            let begins = self.begins(attempt, after, reached);
            gone.add(self.rates.series(&begins).energies(-after.time));
            let then = self.later(&begins, -after.time);
            let left = self.table.cells() - after.node;
            gone.add(self.table.energies(left).of(&then));
        }
    }
}
