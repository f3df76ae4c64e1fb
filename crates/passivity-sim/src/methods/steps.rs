//! Fixed steps: semi-implicit Euler and the classical Runge–Kutta method, as simulators use them.
//!
//! Neither knows where the velocity is zero. Euler applies Coulomb friction as an impulse that stops
//! the device but does not turn it round; Runge–Kutta takes the sign of the velocity at each stage,
//! and sets the velocity to zero when a step turned it round though the force cannot overcome friction.

use crate::flow::{Flowed, State};
use crate::plan::Plan;

/// The right-hand side, ξ̈ and ẏ, for a scene in doubles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rates {
    inverse_mass: f64,
    drag: f64,
    stiffness: f64,
    /// κ, 0 without an amplifier's lag.
    pub(super) rate: f64,
    pub(super) lags: bool,
    pub(super) sigma: f64,
}

impl Rates {
    pub(super) fn new(plan: &Plan) -> Self {
        let flow = plan.flow.as_ref();
        let arm = flow.and_then(|flow| flow.arm);
        let [damping, stiffness] = arm.map_or([0.0; 2], |arm| arm.map(|x| x.0));
        let rate = flow.and_then(|flow| flow.rate);
        Self {
            inverse_mass: 1.0 / plan.mass(),
            drag: plan.constants.beta + damping,
            stiffness,
            rate: rate.map_or(0.0, |rate| rate.0),
            lags: rate.is_some(),
            sigma: plan.constants.sigma,
        }
    }

    /// What acts on the device but for Coulomb friction.
    pub(super) fn pull(&self, xi: f64, v: f64, output: f64, force: f64) -> f64 {
        output + force - self.drag * v - self.stiffness * xi
    }

    /// ξ̈ against friction of sign `sign`.
    pub(super) fn acceleration(&self, xi: f64, v: f64, output: f64, force: f64, sign: f64) -> f64 {
        (self.pull(xi, v, output, force) - self.sigma * sign) * self.inverse_mass
    }

    /// How long the device rests under a pull that goes to a settled one, as an amplifier's output does;
    /// ∞ where friction takes that one too.
    ///
    /// The pull at rest is settled + (pull − settled)·e^(−κt): from within ±σ it gets to one of them at
    /// most once, where e^(κt) = 1 + (±σ − pull)/(settled − ±σ).
    #[cfg(feature = "adaptive")]
    pub(super) fn wait(&self, pull: f64, settled: f64) -> f64 {
        if pull.abs() > self.sigma {
            return 0.0;
        }
        if settled.abs() <= self.sigma {
            return f64::INFINITY;
        }
        let most = self.sigma.copysign(settled);
        ((most - pull) / (settled - most)).ln_1p() / self.rate
    }

    /// ẏ.
    pub(super) fn output_rate(&self, output: f64, held: f64) -> f64 {
        self.rate * (held - output)
    }
}

/// −1, 0 or 1.
fn sign(v: f64) -> f64 {
    if v == 0.0 { 0.0 } else { v.signum() }
}

/// A run of steps over an interval, with the sums that the ledger wants.
struct Walk {
    state: State<f64>,
    path: f64,
    square: f64,
    work: f64,
}

impl Walk {
    fn new(start: &State<f64>, held: f64, lags: bool) -> Self {
        let output = if lags { start.output } else { held };
        Self {
            state: State {
                output,
                ..start.clone()
            },
            path: 0.0,
            square: 0.0,
            work: 0.0,
        }
    }

    /// Adds a step to `next` by the trapezoidal rule.
    fn to(&mut self, next: State<f64>, dt: f64) {
        let d = next.xi - self.state.xi;
        self.path += d.abs();
        let (v0, v1) = (self.state.velocity, next.velocity);
        self.square += dt * (v0 * v0 + v0 * v1 + v1 * v1) / 3.0;
        self.work += 0.5 * (self.state.output + next.output) * d;
        self.state = next;
    }

    fn end(self) -> Option<Flowed<f64>> {
        let finite = self.state.xi.is_finite() && self.state.velocity.is_finite();
        finite.then_some(Flowed {
            end: self.state,
            path: self.path,
            square: self.square,
            work: self.work,
        })
    }
}

/// Semi-implicit Euler: the new velocity moves the device.
pub(super) fn euler(
    plan: &Plan,
    substeps: u32,
) -> impl FnMut(&State<f64>, f64, f64) -> Option<Flowed<f64>> + use<> {
    let rates = Rates::new(plan);
    let dt = 1.0 / f64::from(substeps);
    move |start, held, force| {
        let mut walk = Walk::new(start, held, rates.lags);
        for _ in 0..substeps {
            let State {
                xi,
                velocity: v,
                output,
            } = walk.state;
            let free = v + dt * rates.pull(xi, v, output, force) * rates.inverse_mass;
            let most = dt * rates.sigma * rates.inverse_mass;
            let velocity = free - free.clamp(-most, most);
            let next = State {
                xi: xi + dt * velocity,
                velocity,
                output: output + dt * rates.output_rate(output, held),
            };
            walk.to(next, dt);
        }
        walk.end()
    }
}

/// The classical method of order 4.
pub(super) fn rk4(
    plan: &Plan,
    substeps: u32,
) -> impl FnMut(&State<f64>, f64, f64) -> Option<Flowed<f64>> + use<> {
    let rates = Rates::new(plan);
    let dt = 1.0 / f64::from(substeps);
    move |start, held, force| {
        let mut walk = Walk::new(start, held, rates.lags);
        let slope = |s: [f64; 3]| {
            let [xi, v, output] = s;
            let direction = if v == 0.0 {
                sign(rates.pull(xi, v, output, force))
            } else {
                sign(v)
            };
            let a = rates.acceleration(xi, v, output, force, direction);
            [v, a, rates.output_rate(output, held)]
        };
        let plus = |s: [f64; 3], k: [f64; 3], dt: f64| {
            [s[0] + dt * k[0], s[1] + dt * k[1], s[2] + dt * k[2]]
        };
        for _ in 0..substeps {
            let s = [walk.state.xi, walk.state.velocity, walk.state.output];
            let sticks = rates.pull(s[0], s[1], s[2], force).abs() <= rates.sigma;
            let next = if s[1] == 0.0 && sticks {
                [s[0], 0.0, s[2] + dt * rates.output_rate(s[2], held)]
            } else {
                let k1 = slope(s);
                let k2 = slope(plus(s, k1, 0.5 * dt));
                let k3 = slope(plus(s, k2, 0.5 * dt));
                let k4 = slope(plus(s, k3, dt));
                let sum = plus(plus(k1, plus(k2, k3, 1.0), 2.0), k4, 1.0);
                let mut next = plus(s, sum.map(|k| k / 6.0), dt);
                if s[1] * next[1] < 0.0 && sticks {
                    next[1] = 0.0;
                }
                next
            };
            walk.to(
                State {
                    xi: next[0],
                    velocity: next[1],
                    output: next[2],
                },
                dt,
            );
        }
        walk.end()
    }
}
