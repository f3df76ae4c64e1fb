//! An adaptive method with events, from a kept crate: Dormand and Prince with dense output, stopped
//! where the velocity becomes zero and started again from there.

use std::cell::Cell;

use differential_equations::prelude::*;

use crate::flow::{Flowed, State as Motion};
use crate::methods::steps::Rates;
use crate::plan::Plan;

/// ξ, ξ̇, y, ∫ξ̇² and ∫yξ̇.
type Vector = [f64; 5];

/// The motion against friction of one sign.
struct Segment {
    rates: Rates,
    held: f64,
    force: f64,
    direction: f64,
}

impl ODE<f64, Vector> for Segment {
    fn diff(&self, _t: f64, s: &Vector, rate: &mut Vector) {
        let [xi, v, output, ..] = *s;
        let a = self
            .rates
            .acceleration(xi, v, output, self.force, self.direction);
        *rate = [
            v,
            a,
            self.rates.output_rate(output, self.held),
            v * v,
            output * v,
        ];
    }
}

/// Stops where the velocity changes its sign, and keeps the last state only.
///
/// The crate's own event detection passes over its first step, and fires again at once when it is
/// started on an event; this one looks for the wrong sign in each step.
struct UntilStop<'a> {
    direction: f64,
    end: &'a Cell<(f64, Vector)>,
    stopped: &'a Cell<bool>,
}

impl Solout<f64, Vector> for UntilStop<'_> {
    fn solout<I>(
        &mut self,
        t: f64,
        before: f64,
        now: &Vector,
        _: &Vector,
        interpolator: &mut I,
        _: &mut Solution<f64, Vector>,
    ) -> ControlFlag<f64, Vector>
    where
        I: Interpolation<f64, Vector> + ?Sized,
    {
        if now[1] * self.direction >= 0.0 || t <= before {
            self.end.set((t, *now));
            return ControlFlag::Continue;
        }
        let (mut low, mut high) = (before, t);
        let mut state = *now;
        // Bisection to the last bit: the crossing is bracketed.
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let Ok(at) = interpolator.interpolate(middle) else {
                break;
            };
            if at[1] * self.direction > 0.0 {
                low = middle;
            } else {
                high = middle;
                state = at;
            }
        }
        state[1] = 0.0;
        self.end.set((high, state));
        self.stopped.set(true);
        ControlFlag::Terminate
    }
}

pub(super) fn steps(
    plan: &Plan,
    tolerance: f64,
) -> impl FnMut(&Motion<f64>, f64, f64) -> Option<Flowed<f64>> + use<> {
    let rates = Rates::new(plan);
    move |start, held, force| {
        let output = if rates.lags { start.output } else { held };
        let mut s: Vector = [start.xi, start.velocity, output, 0.0, 0.0];
        let (mut t, mut path) = (0.0_f64, 0.0);
        // More stops than this in an interval are chatter of the method.
        for _ in 0..1000 {
            if t >= 1.0 {
                break;
            }
            let pull = rates.pull(s[0], s[1], s[2], force);
            let mut direction = s[1].signum();
            if s[1] == 0.0 {
                let settled = rates.pull(s[0], 0.0, held, force);
                let wait = rates.wait(pull, settled);
                let step = wait.min(1.0 - t);
                s[2] = held + (s[2] - held) * (-rates.rate * step).exp();
                t += step;
                if t >= 1.0 {
                    break;
                }
                direction = if wait == 0.0 { pull } else { settled }.signum();
            }
            let segment = Segment {
                rates,
                held,
                force,
                direction,
            };
            let (end, stopped) = (Cell::new((t, s)), Cell::new(false));
            let until = UntilStop {
                direction,
                end: &end,
                stopped: &stopped,
            };
            let method = ExplicitRungeKutta::dopri5().rtol(tolerance).atol(tolerance);
            let solved = IVP::ode(&segment, t, 1.0, s)
                .method(method)
                .solout(until)
                .solve();
            solved.ok()?;
            let (at, next) = end.get();
            path += (next[0] - s[0]).abs();
            // A stop at the very start leads nowhere: let the rest of the interval pass.
            t = if stopped.get() && at <= t { 1.0 } else { at };
            s = next;
            if !stopped.get() {
                break;
            }
        }
        let [xi, velocity, output, square, work] = s;
        (xi.is_finite() && velocity.is_finite()).then_some(Flowed {
            end: Motion {
                xi,
                velocity,
                output,
            },
            path,
            square,
            work,
        })
    }
}
