//! The motion over a part of an interval, under one command.

use super::between;
use super::motion::Motion;
use crate::flow::{Flow, State};
use crate::number::{Real, Undecided};

/// A part of an interval, in its own time; see [`crate::latency`].
#[derive(Clone, Debug)]
pub(super) struct Part<R> {
    /// Its length in periods; `None` for a whole interval.
    pub(super) time: Option<R>,
    pub(super) motion: Motion<R>,
    pub(super) flow: Option<Flow<R>>,
}

/// What the motion over an interval was.
pub(super) struct Way<R> {
    pub(super) end: State<R>,
    /// E_d.
    pub(super) dissipated: R,
    /// The work of the force that acted for the held one: behind an amplifier it lags.
    pub(super) work: R,
    /// The work against the operator's arm.
    pub(super) arm: R,
}

impl<R: Real> Part<R> {
    /// The motion over the part under a command and the operator's force.
    pub(super) fn way(&self, from: &State<R>, command: &R, force: &R) -> Result<Way<R>, Undecided> {
        let Some(time) = &self.time else {
            return self.way_in_its_time(from, command, force);
        };
        let from = State {
            velocity: from.velocity.clone() * time.clone(),
            ..from.clone()
        };
        let mut way = self.way_in_its_time(&from, command, force)?;
        way.end.velocity = way.end.velocity.over(time.clone());
        Ok(way)
    }

    /// The same with the length of the part as the unit of time.
    fn way_in_its_time(
        &self,
        state: &State<R>,
        command: &R,
        force: &R,
    ) -> Result<Way<R>, Undecided> {
        let Some(flow) = &self.flow else {
            let u = command.clone() + force.clone();
            let moved = self.motion.over(&state.xi, &state.velocity, &u)?;
            return Ok(Way {
                work: command.clone() * (moved.xi.clone() - state.xi.clone()),
                end: State {
                    xi: moved.xi.decided()?,
                    velocity: moved.velocity.decided()?,
                    output: command.clone(),
                },
                dissipated: moved.dissipated,
                arm: R::zero(),
            });
        };
        let known = [&state.velocity, &state.output, command, force];
        if known.iter().any(|x| x.ends().is_some()) {
            return between::way(flow, state, command, force);
        }
        let flowed = flow.advance(state, command, force, true)?;
        let sigma = flow.sigma.clone().unwrap_or_else(R::zero);
        let arm = match &flow.arm {
            Some([damping, stiffness]) => {
                let d = flowed.end.xi.clone() - state.xi.clone();
                let middle = state.xi.clone() + d.clone().half();
                damping.clone() * flowed.square.clone() + stiffness.clone() * d * middle
            }
            None => R::zero(),
        };
        Ok(Way {
            end: flowed.end,
            dissipated: flow.beta.clone() * flowed.square + sigma * flowed.path,
            work: flowed.work,
            arm,
        })
    }
}

impl<R: Real> Way<R> {
    /// This way and the next.
    pub(super) fn and(self, next: Self) -> Self {
        Self {
            end: next.end,
            dissipated: self.dissipated + next.dissipated,
            work: self.work + next.work,
            arm: self.arm + next.arm,
        }
    }
}
