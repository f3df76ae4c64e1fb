//! The motion within an interval, by the closed form of its parts.
//!
//! A part of s sampling periods is a whole interval of another time: with s as the unit, μ is μ/s², β is
//! β/s, a rate κ is κs and a speed v is vs, while positions and forces stay. So the loop's own closed
//! form gives every part exactly, reversals included.

use std::sync::OnceLock;

use crate::flow::{Flow, State};
use crate::law::{HeldForce, Memory};
use crate::motion::Constants;
use crate::number::Double;
use crate::plan::{Forces, Plan};

/// What a plan needs to follow a motion that is simulated elsewhere.
#[derive(Clone, Debug)]
pub(super) struct Follower {
    law: HeldForce,
    memory: Memory,
    forces: Option<Forces>,
    constants: Constants,
    viscous: bool,
    coulomb: bool,
    flow: Option<Flow<Double>>,
    /// How far into an interval the force of the sample before goes on, in periods.
    late: f64,
    /// The held force of the sample before.
    earlier: f64,
    /// The amplifier's output at the start of the next interval.
    output: f64,
}

/// What acts over an interval.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Acting {
    /// The held force.
    pub(super) held: f64,
    /// That of the sample before, which goes on as far as the latency says.
    pub(super) earlier: f64,
    /// The operator's force.
    pub(super) force: f64,
    /// The amplifier's output at the start of the interval.
    pub(super) output: f64,
}

impl Follower {
    pub(super) fn new(plan: &Plan) -> Self {
        let [xi, _] = plan.start;
        let settled = plan.law.settled(xi);
        Self {
            memory: plan.law.memory(xi),
            late: plan.late(),
            earlier: settled,
            output: settled,
            law: plan.law.clone(),
            forces: plan.forces.clone(),
            constants: plan.constants,
            viscous: plan.viscous,
            coulomb: plan.coulomb,
            flow: plan.flow.clone(),
        }
    }

    /// How far into an interval the force of the sample before goes on, in periods.
    pub(super) const fn late(&self) -> f64 {
        self.late
    }

    /// What acts over the next interval, which starts at ξ.
    pub(super) fn next(&mut self, h: u64, xi: f64) -> Acting {
        let held = (self.law.law())(&self.law, &mut self.memory, xi);
        let (earlier, output) = (self.earlier, self.output);
        self.earlier = held;
        if let Some(Double(rate)) = self.flow.as_ref().and_then(|flow| flow.rate) {
            let after = |output: f64, command: f64, time: f64| {
                command + (output - command) * (-rate * time).exp()
            };
            let then = after(output, earlier, self.late);
            self.output = after(then, held, 1.0 - self.late);
        }
        Acting {
            held,
            earlier,
            force: self.forces.as_ref().map_or(0.0, |forces| forces.at(h)),
            output,
        }
    }

    /// Where the device is and how fast after each of so many equal parts of an interval, from ξ and ξ̇.
    pub(super) fn within(
        &self,
        [xi, velocity]: [f64; 2],
        acting: &Acting,
        parts: u32,
    ) -> Vec<[f64; 2]> {
        let mut state = State {
            xi,
            velocity,
            output: acting.output,
        };
        let mut states = Vec::new();
        let end = |part: u32| f64::from(part) / f64::from(parts);
        for part in 0..parts {
            let (from, to) = (end(part), end(part + 1));
            let change = self.late.clamp(from, to);
            for (command, time) in [(acting.earlier, change - from), (acting.held, to - change)] {
                // What overflows is not drawn.
                let Some(next) = self.over(&state, command, acting.force, time) else {
                    return states;
                };
                state = next;
            }
            states.push([state.xi, state.velocity]);
        }
        states
    }

    /// The motion over a time.
    fn over(&self, from: &State<f64>, command: f64, force: f64, s: f64) -> Option<State<f64>> {
        if s <= 0.0 {
            return Some(from.clone());
        }
        let mut state = from.clone();
        state.velocity *= s;
        state = match &self.flow {
            Some(flow) => Self::flowing(flow, &state, [command, force], s)?,
            None => self.rigid(&state, command + force, s),
        };
        state.velocity /= s;
        Some(state)
    }

    fn rigid(&self, from: &State<f64>, force: f64, s: f64) -> State<f64> {
        let Constants {
            mu, beta, sigma, ..
        } = self.constants;
        let part = Constants::new(mu / (s * s), beta / s, sigma);
        let (xi, v) = (from.xi, from.velocity);
        let moved = match (self.viscous, self.coulomb) {
            (true, true) => part.advance::<true, true, false>(xi, v, force),
            (true, false) => part.advance::<true, false, false>(xi, v, force),
            (false, true) => part.advance::<false, true, false>(xi, v, force),
            (false, false) => part.advance::<false, false, false>(xi, v, force),
        };
        State {
            xi: moved.xi,
            velocity: moved.velocity,
            output: from.output,
        }
    }

    fn flowing(
        flow: &Flow<Double>,
        from: &State<f64>,
        [command, force]: [f64; 2],
        s: f64,
    ) -> Option<State<f64>> {
        let part = Flow {
            mass: Double(flow.mass.0 / (s * s)),
            beta: Double(flow.beta.0 / s),
            sigma: flow.sigma,
            rate: flow.rate.map(|rate| Double(rate.0 * s)),
            arm: flow
                .arm
                .map(|[damping, stiffness]| [Double(damping.0 / s), stiffness]),
            pieces: flow.pieces,
            whole: OnceLock::new(),
        };
        Some(part.advance_doubles(from, command, force, false)?.end)
    }
}

#[cfg(test)]
mod tests {
    use passivity_scene::Scene;

    use super::*;
    use crate::run;

    #[test]
    fn the_parts_of_an_interval_end_where_the_interval_does() {
        for more in [
            "",
            "latency = \"2/7\"\n",
            "latency = \"5/3\"\n[amplifier]\ntime_constant = \"1/5\"\n",
            "[amplifier]\ntime_constant = \"1/5\"\n",
            "[operator]\nforce = \"1/2\"\narm = { mass = \"10\", damping = \"1/3\", stiffness = \"1/4\" }\n",
        ] {
            let text = format!(
                "[dimensionless]\nmu = \"20\"\nbeta = \"2\"\nsigma = \"0.45\"\n[start]\nvelocity = \"3\"\n\
                 [run]\nintervals = 60\n[sampling]\ndelay = 1\n{more}"
            );
            let plan = Plan::compile(&Scene::from_toml("s", &text).unwrap().point()).unwrap();
            let mut follower = Follower::new(&plan);
            let mut reversals = 0;
            let mut seen = 0;
            run::ledger(&plan, |entry| {
                let acting = follower.next(entry.h, entry.xi0);
                let states = follower.within([entry.xi0, entry.v0], &acting, 16);
                let [xi, v] = states[15];
                let scale = 1.0 + entry.xi0.abs() + entry.v0.abs();
                let off = (xi - entry.xi1).abs() + (v - entry.v1).abs();
                // Sixteen parts of a dozen roundings each, at most.
                assert!(off < 1e-12 * scale, "{more} {}: {off:e}", entry.h);
                reversals += usize::from(entry.v0 * entry.v1 < 0.0);
                seen += 1;
                true
            });
            assert!(reversals > 0 && seen > 5, "{more}: {reversals} {seen}");
        }
    }
}
