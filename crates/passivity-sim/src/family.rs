//! Scenes that differ in friction and speed at the start alone: what they share is compiled once.

use passivity_core::{BigRational, Controller, Effect, Loop};
use passivity_scene::Point;

use crate::error::SimError;
use crate::flow::{Fast, Flow};
use crate::growth::{Growth, System};
use crate::latency;
use crate::law::{self, HeldForce, controller_in_doubles, least_holding_force};
use crate::motion::Constants;
use crate::number::{Double, to_double};
use crate::plan::{Forces, Plan, in_range};

/// A scene in doubles, with its controller and the operator's forces.
#[derive(Clone, Debug)]
pub(crate) struct Family {
    the_loop: Loop<Double>,
    effects: Vec<Effect>,
    controller: Controller<Double>,
    law: HeldForce,
    forces: Option<Forces>,
    /// The parts of an interval, where a latency leaves two.
    times: Option<[f64; 2]>,
    /// How far the position at the start may be from the scene's.
    start_error: f64,
    /// See [`Plan`]; the second one of the scene's own friction.
    least_holding_force: f64,
    holding: f64,
    length_unit: &'static str,
    intervals: u64,
}

impl Family {
    /// The family of a scene's dimensionless point.
    ///
    /// # Errors
    ///
    /// A scene without inertia, or with a parameter out of the range of doubles.
    pub(crate) fn of(point: &Point) -> Result<Self, SimError> {
        let the_loop = in_doubles(point)?;
        the_loop.inertia.ok_or(SimError::NoInertia)?;
        let controller = controller_in_doubles(&point.at)?;
        let exact = law::controller(&point.at, BigRational::clone)?;
        let least = least_holding_force(&exact);
        let sigma = point.at.coulomb_friction();
        let [least_holding_force, nearest] = [&least, &sigma].map(to_double);
        let [position, _] = point.start();
        let near = to_double(&position);
        let is_exact = BigRational::from_float(near).is_some_and(|near| near == position);
        let effects = Effect::ALL.into_iter();
        Ok(Self {
            the_loop,
            effects: effects.filter(|effect| point.has(*effect)).collect(),
            law: HeldForce::compile(&controller)?.with_whole_steps(&exact),
            controller,
            forces: match &point.forces {
                Some(samples) => Some(Forces::new(samples)?),
                None => None,
            },
            times: latency::times(&point.at).map(|times| times.map(|time| to_double(&time))),
            start_error: if is_exact {
                0.0
            } else {
                f64::EPSILON * near.abs() + f64::MIN_POSITIVE
            },
            least_holding_force,
            holding: if least > sigma {
                nearest.min(least_holding_force.next_down())
            } else {
                nearest.max(least_holding_force)
            },
            length_unit: match point.units.length_unit {
                Some(unit) if !point.has(Effect::Encoder) => unit,
                _ => "ticks",
            },
            intervals: point.intervals,
        })
    }

    /// The plan of the scene itself.
    ///
    /// # Errors
    ///
    /// A motion within the interval that is too fast.
    pub(crate) fn own(&self) -> Result<Plan, SimError> {
        Ok(Plan {
            holding: self.holding,
            ..self.plan(self.the_loop.clone())?
        })
    }

    /// The plan of the scene with these β, σ and speed at the start, all of them in range.
    ///
    /// # Errors
    ///
    /// A motion within the interval that is too fast.
    pub(crate) fn with(&self, [beta, sigma, speed]: [f64; 3]) -> Result<Plan, SimError> {
        self.plan(Loop {
            viscous: Some(Double(beta)),
            coulomb: Some(Double(sigma)),
            start_velocity: Some(Double(speed)),
            ..self.the_loop.clone()
        })
    }

    fn plan(&self, the_loop: Loop<Double>) -> Result<Plan, SimError> {
        let mut parts = Vec::new();
        for time in self.times.into_iter().flatten() {
            let of_part = latency::part(&the_loop, &Double(time));
            parts.push((time, self.in_one(of_part, Vec::new())?));
        }
        self.in_one(the_loop, parts)
    }

    /// The plan whose intervals have these parts, or are led over in one.
    fn in_one(&self, the_loop: Loop<Double>, parts: Vec<(f64, Plan)>) -> Result<Plan, SimError> {
        let or_zero = |x: Option<Double>| x.map_or(0.0, |x| x.0);
        let [beta, sigma] = [the_loop.viscous, the_loop.coulomb].map(or_zero);
        let mass = the_loop.inertia.ok_or(SimError::NoInertia)?;
        let constants = Constants::new(mass.0, beta, sigma);
        let flow = Flow::compile(&the_loop, mass)?;
        let growth = if self.times.is_some() {
            Growth::never(flow.as_ref().map_or(mass.0, |flow| flow.mass.0)) // Its map from sample to sample is another one.
        } else {
            Growth::of(&System {
                controller: &self.controller,
                constants: &constants,
                flow: flow.as_ref(),
                largest_force: self.forces.as_ref().map(Forces::largest),
            })
        };
        Ok(Plan {
            parts,
            effects: self.effects.clone(),
            viscous: the_loop.viscous.is_some(),
            coulomb: the_loop.coulomb.is_some(),
            constants,
            least_holding_force: self.least_holding_force,
            holding: sigma,
            law: self.law.clone(),
            forces: self.forces.clone(),
            fast: flow.as_ref().map(Fast::new),
            flow,
            start: [the_loop.start_position, the_loop.start_velocity].map(or_zero),
            start_error: self.start_error,
            length_unit: self.length_unit,
            intervals: self.intervals,
            growth,
        })
    }
}

/// What of a dimensionless loop has a part in the motion, in doubles.
fn in_doubles(point: &Point) -> Result<Loop<Double>, SimError> {
    let moving = Loop {
        max_speed: None,
        operator_force: None,
        ..point.at.clone()
    };
    for (parameter, x) in moving.given() {
        in_range(x, parameter)?;
    }
    Ok(moving.map(|_, x| Double::from(x)))
}
