//! The motion within an interval, by the closed form of its parts.
//!
//! A part of s sampling periods is a whole interval of another time: with s as the unit, μ is μ/s², β is
//! β/s, a rate κ is κs and a speed v is vs, while positions and forces stay. So the loop's own closed
//! form gives every part exactly, reversals included.

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
    /// The amplifier's output at the start of the next interval.
    output: f64,
}

/// What acts over an interval.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Acting {
    /// The held force.
    pub(super) held: f64,
    /// The operator's force.
    pub(super) force: f64,
    /// The amplifier's output at the start of the interval.
    pub(super) output: f64,
}

impl Follower {
    pub(super) fn new(plan: &Plan) -> Self {
        let [xi, _] = plan.start;
        Self {
            memory: plan.law.memory(xi),
            output: plan.law.settled(xi),
            law: plan.law.clone(),
            forces: plan.forces.clone(),
            constants: plan.constants,
            viscous: plan.viscous,
            coulomb: plan.coulomb,
            flow: plan.flow.clone(),
        }
    }

    /// What acts over the next interval, which starts at ξ.
    pub(super) fn next(&mut self, h: u64, xi: f64) -> Acting {
        let held = (self.law.law())(&self.law, &mut self.memory, xi);
        let output = self.output;
        if let Some(Double(rate)) = self.flow.as_ref().and_then(|flow| flow.rate) {
            self.output = held + (output - held) * (-rate).exp();
        }
        Acting {
            held,
            force: self.forces.as_ref().map_or(0.0, |forces| forces.at(h)),
            output,
        }
    }

    /// Where the device is and how fast after each of so many equal parts of an interval, from ξ and ξ̇.
    pub(super) fn within(&self, [xi, v]: [f64; 2], acting: &Acting, parts: u32) -> Vec<[f64; 2]> {
        let s = 1.0 / f64::from(parts);
        let slower = |[xi, v]: [f64; 2]| [xi, v / s];
        let states = match &self.flow {
            Some(flow) => self.flowing(flow, [xi, v * s], acting, parts),
            None => self.rigid([xi, v * s], acting.held + acting.force, parts),
        };
        states.into_iter().map(slower).collect()
    }

    fn rigid(&self, mut at: [f64; 2], force: f64, parts: u32) -> Vec<[f64; 2]> {
        let s = 1.0 / f64::from(parts);
        let Constants {
            mu, beta, sigma, ..
        } = self.constants;
        let part = Constants::new(mu / (s * s), beta / s, sigma);
        let next = |[xi, v]: [f64; 2]| {
            let moved = match (self.viscous, self.coulomb) {
                (true, true) => part.advance::<true, true, false>(xi, v, force),
                (true, false) => part.advance::<true, false, false>(xi, v, force),
                (false, true) => part.advance::<false, true, false>(xi, v, force),
                (false, false) => part.advance::<false, false, false>(xi, v, force),
            };
            [moved.xi, moved.velocity]
        };
        let mut states = Vec::new();
        for _ in 0..parts {
            at = next(at);
            states.push(at);
        }
        states
    }

    fn flowing(
        &self,
        flow: &Flow<Double>,
        [xi, velocity]: [f64; 2],
        acting: &Acting,
        parts: u32,
    ) -> Vec<[f64; 2]> {
        let s = 1.0 / f64::from(parts);
        let part = Flow {
            mass: Double(flow.mass.0 / (s * s)),
            beta: Double(flow.beta.0 / s),
            sigma: flow.sigma,
            rate: flow.rate.map(|rate| Double(rate.0 * s)),
            arm: flow
                .arm
                .map(|[damping, stiffness]| [Double(damping.0 / s), stiffness]),
            pieces: flow.pieces,
        };
        let output = if flow.rate.is_some() {
            acting.output
        } else {
            acting.held
        };
        let mut state = State {
            xi,
            velocity,
            output,
        };
        let mut states = Vec::new();
        for _ in 0..parts {
            // What overflows is not drawn.
            let Some(flowed) = part.advance_doubles(&state, acting.held, acting.force, false)
            else {
                break;
            };
            state = flowed.end;
            states.push([state.xi, state.velocity]);
        }
        states
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
            "[amplifier]\ntime_constant = \"1/5\"\n",
            "[operator]\nforce = \"1/2\"\narm = { mass = \"10\", damping = \"1/3\", stiffness = \"1/4\" }\n",
        ] {
            let text = format!(
                "[dimensionless]\nmu = \"20\"\nbeta = \"2\"\nsigma = \"0.45\"\n[sampling]\ndelay = 1\n\
                 [start]\nvelocity = \"3\"\n[run]\nintervals = 60\n{more}"
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
