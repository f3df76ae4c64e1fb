//! What comes after a stop: friction lets the device go the other way, or holds it, or holds it for a while.

use super::fast::{Attempt, Fast};
use super::turn::{Near, Onward};

/// What comes after a stop, or after a start at rest.
pub(crate) struct After {
    /// The node of the table that is nearest to where the motion on begins, and how long after it that is.
    pub(crate) node: usize,
    pub(crate) time: f64,
    /// Whether it turned there; else friction held it, or does.
    pub(super) turned: bool,
    /// The force and the excess that act from there on.
    pub(crate) push: f64,
    pub(crate) excess: f64,
    /// What the motion on is added to: the way and the velocity at the end.
    pub(crate) way: f64,
    pub(crate) velocity: f64,
    /// The direction of the motion on; 0 where the device stays.
    pub(crate) direction: f64,
}

/// What friction does at a stop.
pub(super) enum Friction {
    LetsGo,
    Holds,
    Undecided,
}

impl Fast {
    /// What friction does at a stop near this node: between the node and the stop, at most a cell apart, the
    /// velocity is at most what it is at the node, and the excess changes by at most twice κ cells of itself.
    #[inline(always)]
    pub(super) fn friction<const LAG: bool, const ARM: bool>(
        &self,
        attempt: &Attempt,
        near: &Near,
    ) -> Friction {
        let k = &self.turns;
        let net = self
            .net_after::<LAG, ARM>(attempt, [near.way, near.excess])
            .abs();
        let mut doubt = 0.0;
        if ARM {
            doubt += k.stiffness * near.velocity.abs();
        }
        if LAG {
            doubt += 2.0 * k.rate * near.excess.abs();
        }
        let doubt = doubt * k.cell;
        if net > self.sigma + doubt {
            Friction::LetsGo
        } else if net < self.sigma - doubt {
            Friction::Holds
        } else {
            Friction::Undecided
        }
    }

    /// What comes after a stop so long after a node; the way and the excess at the stop are asked for only where
    /// they matter.
    #[inline(always)]
    pub(crate) fn after_stop<const LAG: bool, const ARM: bool>(
        &self,
        attempt: &Attempt,
        node: usize,
        time: f64,
        near: &Near,
        reached: [f64; 2],
    ) -> Option<After> {
        let turns = match self.friction::<LAG, ARM>(attempt, near) {
            Friction::LetsGo => true,
            Friction::Holds => false,
            Friction::Undecided => self.net_after::<LAG, ARM>(attempt, reached).abs() > self.sigma,
        };
        if turns {
            return Some(self.turned(attempt, node, time));
        }
        let [way, _] = reached;
        self.held_after::<LAG>(attempt, node, time, way)
    }

    /// Friction holds the device at a stop so long after a node: it has stopped before friction lets go.
    #[inline(always)]
    pub(super) fn held_after<const LAG: bool>(
        &self,
        attempt: &Attempt,
        node: usize,
        time: f64,
        way: f64,
    ) -> Option<After> {
        let after = self.held::<LAG>(attempt, way)?;
        let stop = node as f64 * self.turns.cell + time;
        let start = after.node as f64 * self.turns.cell + after.time;
        (after.direction == 0.0 || start >= stop).then_some(after)
    }

    /// y + F − kξ after a way, at an excess.
    #[inline(always)]
    pub(super) fn net_after<const LAG: bool, const ARM: bool>(
        &self,
        attempt: &Attempt,
        [way, excess]: [f64; 2],
    ) -> f64 {
        let mut net = attempt.net;
        if ARM {
            net -= self.turns.stiffness * way;
        }
        if LAG {
            let [.., before] = attempt.inner;
            net += before - excess;
        }
        net
    }

    /// The device turns: friction acts the other way from here on.
    #[inline(always)]
    pub(super) fn turned(&self, attempt: &Attempt, node: usize, time: f64) -> After {
        let [v, ..] = attempt.inner;
        After {
            node,
            time,
            turned: true,
            push: (2.0 * self.sigma).copysign(v),
            excess: 0.0,
            way: attempt.way,
            velocity: attempt.velocity,
            direction: -v,
        }
    }

    /// Friction holds the device after a way, at least for a while.
    #[inline(always)]
    pub(super) fn held<const LAG: bool>(&self, attempt: &Attempt, way: f64) -> Option<After> {
        let mut after = After {
            node: self.table.cells(),
            time: 0.0,
            turned: false,
            push: 0.0,
            excess: 0.0,
            way,
            velocity: 0.0,
            direction: 0.0,
        };
        if LAG {
            let [.., excess] = attempt.inner;
            let pulled = attempt.net - self.turns.stiffness * way;
            let at_end = pulled + excess * (1.0 - self.whole.excess);
            if at_end.abs() > self.sigma {
                // The excess falls as e^(−κt); friction lets go when the net force is ±σ.
                let then = excess + pulled - self.sigma.copysign(at_end);
                let from = -(then / excess).ln() * self.over_rate;
                if !(0.0..=1.0).contains(&from) {
                    return None;
                }
                after.node = self.table.node(from);
                after.time = from - after.node as f64 * self.turns.cell;
                (after.excess, after.direction) = (then, at_end);
            }
        }
        Some(after)
    }

    /// The motion on after a stop, for its series.
    #[inline(always)]
    pub(crate) fn onward(&self, after: &After) -> Onward {
        let map = self.table.map_before_end(after.node);
        let ([_, way, lagging_way], [_, velocity, lagging_velocity]) = (map.way, map.velocity);
        Onward {
            way: [way, lagging_way],
            velocity: [velocity, lagging_velocity],
            decay: map.excess,
            push: after.push,
            excess: after.excess,
            time: after.time,
        }
    }
}
