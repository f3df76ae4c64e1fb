//! How far rounding may have led a motion in doubles astray, and whether that is as far as an edge.
//!
//! As long as every sample was seen on its side of every encoder edge, the held forces are those of the
//! motion itself. (Without an encoder so are those of a D/A converter's steps; a force without steps follows the
//! position, and what is taken for its error then is said in [`HeldForce::off_jump`](crate::law::HeldForce).) Two motions under the same force come nearer to each other in ξ̇, by e^(−λ) in an
//! interval, because friction grows with the velocity, and in ξ part by φ₁ of what they differ in ξ̇. So
//! the errors follow from those of single intervals, which are roundings: of ξ̇ a dozen, each by at most
//! ½ε of a number below |ξ̇| + U/μ, U being the sum of the forces that act, and of the parameters, which
//! move the acceleration by some εU/μ; [`EACH`] covers them. ξ is off by as much, and by its own
//! rounding. A sample that is nearer to an edge than this bound may be on its other side: what comes
//! then may be another motion, and the outcome says so.
//!
//! An arm's spring drives positions together: with it the energy ½M·δξ̇² + ½k·δξ² of the difference does
//! not grow, and takes the place of δξ̇. An amplifier's output is off by its own roundings, which fade
//! with its lag.

mod coarse;

use crate::number::MAGIC;
use crate::plan::Plan;
pub(crate) use coarse::{Coarse, Seen, Stretches};

/// Intervals between two looks at whether a sample was near an edge.
pub(crate) const STRETCH: u32 = 64;

/// The roundings of an interval, of |ξ̇| + U/μ.
pub(crate) const EACH: f64 = 16.0 * f64::EPSILON;

/// The same where the interval is led over by propagators and series.
const EACH_FLOW: f64 = 4.0 * EACH;

/// The rounding of ξ itself; twice what it is, so that it is a tick where doubles have no halves.
const OF_POSITION: f64 = 2.0 * f64::EPSILON;

/// Bounds of the errors of ξ and ξ̇, carried along with a motion.
#[derive(Clone, Debug)]
pub(crate) struct Rounding {
    /// Of ξ; −∞ where no edge asks for it.
    position: f64,
    /// Of ξ̇.
    velocity: f64,
    /// Of the amplifier's output.
    output: f64,
    /// The largest |ξ| so far.
    reach: f64,
    /// The first sample that an edge is as near to, once there is one.
    first: Option<u64>,
    scene: Scene,
}

/// What of a scene the errors depend on.
#[derive(Clone, Copy, Debug)]
struct Scene {
    each: f64,
    inverse_mass: f64,
    sigma: f64,
    decay: f64,
    /// An arm's damping and stiffness.
    arm: [f64; 2],
    /// e^(−κ), without an amplifier 0.
    lag: f64,
    /// What a controller's roundings amount to, of the greatest |ξ| + 1.
    law: f64,
    /// How many samples before the present one was the one whose force may jump: with an encoder it is looked at
    /// when it is taken.
    late: u64,
}

/// What acts over an interval.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Acting {
    /// ξ̇ at its start.
    pub(crate) velocity: f64,
    /// The held force.
    pub(crate) held: f64,
    /// The amplifier's output at the start.
    pub(crate) output: f64,
    /// The operator's force.
    pub(crate) force: f64,
}

impl Rounding {
    /// At the start of a plan.
    pub(crate) fn new(plan: &Plan) -> Self {
        let [xi, velocity] = plan.start;
        let flow = plan.flow.as_ref();
        let rate = flow.and_then(|flow| flow.rate).map(|rate| rate.0);
        let arm = flow.and_then(|flow| flow.arm).map(|arm| arm.map(|x| x.0));
        let arm = arm.unwrap_or([0.0; 2]);
        let [damping, _] = arm;
        let mass = plan.mass();
        let watched = plan.law.has_edges();
        Self {
            position: if watched {
                plan.start_error
            } else {
                f64::NEG_INFINITY
            },
            velocity: 0.5 * f64::EPSILON * velocity.abs(),
            output: 0.0,
            reach: xi.abs(),
            first: None,
            scene: Scene {
                each: if flow.is_some() || !plan.parts.is_empty() {
                    EACH_FLOW
                } else {
                    EACH
                },
                inverse_mass: 1.0 / mass,
                sigma: plan.constants.sigma,
                decay: (-(plan.constants.beta + damping) / mass).exp(),
                arm,
                lag: rate.map_or(0.0, |rate| (-rate).exp()),
                law: plan.law.rounding(),
                late: if plan.law.jumps() {
                    plan.law.delay as u64
                } else {
                    0
                },
            },
        }
    }

    /// The same of a method that may be off by such a part of the state in an interval, beside rounding.
    pub(crate) fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.scene.each = EACH_FLOW + 16.0 * tolerance;
        self
    }

    /// Looks at the sample whose force was commanded at h, so far off an edge.
    pub(crate) fn look(&mut self, h: u64, off: f64) {
        if off < self.position {
            self.found(h.saturating_sub(self.scene.late));
        }
    }

    /// From here on nothing is certain, and no other sample matters.
    fn found(&mut self, h: u64) {
        self.first = Some(h);
        self.position = f64::NEG_INFINITY;
    }

    /// What ξ and ξ̇ may be off by; ξ by −∞ past the first sample that is near an edge.
    #[cfg(test)]
    pub(crate) const fn errors(&self) -> [f64; 2] {
        [self.position, self.velocity]
    }

    /// The first sample that an edge was as near to as the error.
    pub(crate) const fn first(&self) -> Option<u64> {
        self.first
    }

    /// Follows a motion without amplifier or arm over an interval that ends at `xi`.
    pub(crate) fn follow(&mut self, acting: &Acting, xi: f64) {
        let Scene {
            sigma,
            inverse_mass,
            each,
            ..
        } = self.scene;
        let mut forces = acting.held.abs() + acting.force.abs();
        if acting.velocity == 0.0 && forces <= sigma {
            return self.stick(sigma - forces);
        }
        if self.scene.law > 0.0 {
            self.reach = self.reach.max(xi.abs());
            forces += self.scene.law * (self.reach + 1.0);
        }
        let rounded =
            each * (acting.velocity.abs() + (forces + sigma) * inverse_mass) + f64::MIN_POSITIVE;
        self.position += self.velocity + rounded + OF_POSITION * xi.abs();
        self.velocity = self.scene.decay * self.velocity + rounded;
    }

    /// Friction holds the device: nothing is rounded, and if it moves after all, it is being stopped by
    /// what friction has to `spare`.
    fn stick(&mut self, spare: f64) {
        self.position += self.velocity;
        // Half of it, for its own roundings.
        self.velocity = (self.velocity - 0.5 * spare * self.scene.inverse_mass).max(0.0);
    }

    /// Follows any motion over an interval that ends at `xi`.
    pub(crate) fn follow_flow(&mut self, acting: &Acting, from: f64, xi: f64) {
        let Scene {
            each,
            inverse_mass,
            sigma,
            decay,
            arm: [damping, stiffness],
            lag,
            law,
            ..
        } = self.scene;
        self.reach = self.reach.max(from.abs()).max(xi.abs());
        let outputs = acting.held.abs() + acting.output.abs() + law * (self.reach + 1.0);
        let forces = outputs
            + acting.force.abs()
            + sigma
            + stiffness * self.reach
            + damping * acting.velocity.abs();
        let rounded = each * (acting.velocity.abs() + forces * inverse_mass) + f64::MIN_POSITIVE;
        self.output = lag * self.output + each * outputs;
        // What friction surely takes, all the interval long, moves nothing, and nothing is rounded. (Friction
        // takes energy of the difference to a device that is still moving.)
        let output = acting.held.abs().max(acting.output.abs());
        let taken = output + self.output + acting.force.abs() + stiffness * from.abs();
        let [rounded, of_position] = if acting.velocity == 0.0 && taken <= sigma {
            [0.0; 2]
        } else {
            let rounded = rounded + self.output * inverse_mass;
            [rounded, rounded + OF_POSITION * self.reach]
        };
        let drift = self.position + self.velocity + of_position;
        if stiffness > 0.0 {
            // √(M·δξ̇² + k·δξ²) over √M, and what it says of either.
            let rate = (stiffness * inverse_mass).sqrt();
            self.velocity += rounded + rate * of_position;
            self.position = drift.min(self.velocity / rate + of_position);
        } else {
            self.position = drift;
            self.velocity = decay * self.velocity + rounded;
        }
    }
}

/// How far a position is from the nearest encoder edge; for positions beyond 2⁵¹ at most a tick.
#[inline(always)]
pub(crate) fn off_edge(xi: f64) -> f64 {
    (xi - ((xi + MAGIC) - MAGIC)).abs()
}

#[cfg(all(test, feature = "multiprecision"))]
mod tests {
    use passivity_core::{BigRational, Friction, Loop, Scalar as _};
    use passivity_scene::Point;
    use passivity_scene::number::parse;
    use passivity_scene::point::Units;

    use crate::{Method, Plan, run, simulate};

    fn point(
        [mu, beta, sigma, speed]: [&str; 4],
        change: impl Fn(&mut Loop<BigRational>),
    ) -> Point {
        let q = |text: &str| parse(text).unwrap();
        let one = BigRational::one();
        let mut at = Loop {
            inertia: Some(q(mu)),
            start_position: Some(q("1/3")),
            start_velocity: Some(q(speed)),
            ..Loop::plain(Friction::new(q(beta), q(sigma)))
        };
        change(&mut at);
        Point {
            at,
            forces: None,
            intervals: 60,
            units: Units {
                period: one.clone(),
                length: one.clone(),
                stiffness: one,
                length_unit: None,
            },
        }
    }

    /// How much of its bound the error of a run is.
    fn part_of_bound(point: &Point) -> Option<f64> {
        let (end, [position, velocity]) = run::with_errors(&Plan::compile(point).unwrap());
        if end.outcome.exact == crate::ExactOutcome::Growing || position < 0.0 {
            return None;
        }
        let truth = simulate(point, &Method::Reference { digits: 60 }, None)
            .unwrap()
            .end;
        assert_eq!(end.intervals, truth.intervals, "{point:?}");
        let of = |off: f64, bound: f64| off.abs() / bound;
        let parts = [
            of(end.xi - truth.xi, position),
            of(end.velocity - truth.velocity, velocity),
        ];
        let worst = parts.into_iter().fold(0.0, f64::max);
        assert!(worst <= 1.0, "{parts:?} {end:?} {truth:?} {point:?}");
        Some(worst)
    }

    #[test]
    fn the_bounds_hold_the_error_of_every_motion() {
        let q = |text: &str| parse(text).ok();
        let mut runs = 0;
        for mu in ["1e-3", "1/7", "3", "50", "1e6"] {
            for beta in ["0", "1e-9", "1/7", "3/5", "10", "1000"] {
                for sigma in ["1/7", "4/5"] {
                    for speed in ["1/3", "-7/3"] {
                        let of = [mu, beta, sigma, speed];
                        runs += usize::from(part_of_bound(&point(of, |_| ())).is_some());
                        let damped = point(of, |at| (at.damping, at.delay) = (q("1/9"), 1));
                        runs += usize::from(part_of_bound(&damped).is_some());
                        let late = point(of, |at| at.latency = q("9/7"));
                        runs += usize::from(part_of_bound(&late).is_some());
                    }
                }
            }
        }
        assert!(runs > 100, "{runs}");
    }

    #[test]
    fn the_bounds_hold_the_error_behind_an_amplifier_and_an_arm() {
        let q = |text: &str| parse(text).ok();
        let mut runs = 0;
        for (mu, beta) in [("50", "3"), ("3", "4"), ("1/2", "1")] {
            for lag in ["1/7", "2"] {
                for stiffness in ["0", "1/3", "5"] {
                    let of = [mu, beta, "4/5", "7/3"];
                    let mut scene = point(of, |at| {
                        (at.time_constant, at.latency) = (q(lag), q("2/7"));
                        (at.arm_mass, at.arm_damping) = (q("1/3"), q("1/9"));
                        at.arm_stiffness = q(stiffness);
                    });
                    scene.intervals = 20;
                    runs += usize::from(part_of_bound(&scene).is_some());
                }
            }
        }
        assert!(runs > 10, "{runs}");
    }
}
