//! The radius beyond which divergence is certain.
//!
//! Without quantization and Coulomb friction the loop is linear from sample to sample, x′ = Ax. Let z
//! be an eigenvalue of A with |z| > 1 and ℓ its left eigenvector, ℓA = zℓ. Quantization (an error of
//! the held force of at most ½), Coulomb friction (at most σ), a D/A converter (at most ½δ) and the
//! operator's force (at most F) disturb an interval by w with |ℓw| ≤ W. So
//!
//! > |ℓx′| ≥ |z||ℓx| − W, that is |ℓx′| − R ≥ |z|(|ℓx| − R) with R = W/(|z| − 1):
//!
//! once |ℓx| > R, it grows by the factor |z| for ever, whatever the disturbances do. For the paper's
//! own scene x = (ξ, ξ̇) and everything is in closed form: A₁₁ = 1 − φ₂/μ, A₁₂ = φ₁, A₂₁ = −φ₁/μ,
//! A₂₂ = e^(−λ), and an impulse of force moves ξ by φ₂/μ at most over an interval and ξ̇ by φ₁/μ.
//!
//! A one-sided wall or a saturated actuator makes the loop no such map, and a controller whose response
//! does not end has more state than past samples: no radius is claimed there.
//! Whatever the scene, a state past [`OVERFLOW`] is reported as growing too: it would leave the range
//! of numbers next.

mod modes;

use std::cmp::Ordering;

use passivity_core::{Controller, controller::Filter};
use passivity_scene::display::significant;

use crate::flow::{Flow, State};
use crate::motion::Constants;
use crate::number::Double;
use modes::{dominant_left, transposed};

/// The magnitude of ξ or ξ̇ at which any scene is called growing.
pub(crate) const OVERFLOW: f64 = 1e140;

/// |z| − 1 below this is rounding: no growth is claimed.
const LEAST_EXCESS: f64 = 1e-12;

/// The radius is widened by this factor against rounding of its computation and of the state.
const WIDENED: f64 = 1.0 + 1e-6;

/// More samples of history than this and no radius is computed.
const MOST_HISTORY: usize = 64;

/// What growth depends on: the loop that is linear but for quantization and Coulomb friction, and what
/// drives it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct System<'a> {
    /// The controller.
    pub(crate) controller: &'a Controller<Double>,
    /// The motion under a constant force.
    pub(crate) constants: &'a Constants,
    /// The motion with an amplifier's lag or an arm, when there is one.
    pub(crate) flow: Option<&'a Flow<Double>>,
    /// The largest force of the operator, when there is one.
    pub(crate) largest_force: Option<f64>,
}

/// When divergence is certain.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Growth {
    /// ℓ over (ξ, ξ̇), scaled to 1 at ξ: |ℓx|² = (ξ + c·ξ̇)² + (s·ξ̇)².
    pub c: f64,
    /// See `c`.
    pub s: f64,
    /// The square of the radius, at most that of [`OVERFLOW`].
    pub square: f64,
    /// |z|, when a mode grows.
    pub factor: Option<f64>,
    /// The whole of ℓ when there is more state than (ξ, ξ̇); then `square` only says when to look.
    mode: Option<Mode>,
}

/// A left eigenvector over the whole state, real and imaginary part.
#[derive(Clone, Debug, PartialEq)]
struct Mode {
    left: Vec<[f64; 2]>,
    radius: f64,
    lagging: bool,
}

impl Growth {
    /// No mode grows, or none is known to: only numbers near overflow count.
    ///
    /// The norm is the root of twice the energy, ξ² + Mξ̇²: what bounds the speed of a heavy device by it
    /// ([`Coarse`](crate::rounding::Coarse)) is as small as that.
    #[must_use]
    pub(crate) fn never(mass: f64) -> Self {
        Self {
            c: 0.0,
            s: mass.sqrt().max(1.0),
            square: OVERFLOW * OVERFLOW,
            factor: None,
            mode: None,
        }
    }

    /// The growth of the paper's own scene; the held force is off by at most `error`, ½ with an
    /// encoder and 0 without.
    #[must_use]
    pub(crate) fn plain(k: &Constants, error: f64) -> Self {
        let (phi1, phi2) = (k.phi1 * k.inverse_mu, k.phi2 * k.inverse_mu);
        // det A − 1, without the cancellation of det A itself: e^(−λ) − 1 = −λφ₁ = −βφ₁/μ.
        let excess = k.inverse_mu * (k.phi1 * k.phi1 - k.beta * k.phi1 - k.decay * k.phi2);
        let (trace, det) = (1.0 - phi2 + k.decay, 1.0 + excess);
        let discriminant = 0.25 * trace * trace - det;
        let a11 = 1.0 - phi2;
        let (real, imaginary, over) = if discriminant < 0.0 {
            let over = excess / (1.0 + det.sqrt());
            (0.5 * trace, (-discriminant).sqrt(), over)
        } else {
            let root = discriminant.sqrt();
            let largest = 0.5 * trace + root.copysign(trace);
            (largest, 0.0, largest.abs() - 1.0)
        };
        if over.is_nan() || over < LEAST_EXCESS {
            return Self::never(k.mu);
        }
        let c = (real - a11) / -phi1;
        let s = imaginary / -phi1;
        let disturbance = (error + k.sigma) * (phi2 + c.hypot(s) * phi1);
        let radius = disturbance / over * WIDENED;
        if !(c.is_finite() && s.is_finite()) {
            return Self::never(k.mu);
        }
        Self {
            c,
            s,
            square: (radius * radius).min(OVERFLOW * OVERFLOW),
            factor: Some(1.0 + over),
            mode: None,
        }
    }

    /// The growth of any scene.
    pub(crate) fn of(system: &System<'_>) -> Self {
        let controller = system.controller;
        let clamped = controller.unilateral || controller.max_force.is_some();
        if clamped || !controller.filter.ends() || controller.memory() > MOST_HISTORY {
            return Self::never(system.mass());
        }
        let plain = controller.memory() == 0
            && controller.filter == Filter::wall()
            && controller.force_step.is_none();
        if plain && system.largest_force.is_none() && system.flow.is_none() {
            return Self::plain(system.constants, system.error());
        }
        Self::general(system).unwrap_or_else(|| Self::never(system.mass()))
    }

    /// Whether a mode is known to grow.
    #[must_use]
    pub(crate) const fn is_possible(&self) -> bool {
        self.factor.is_some()
    }

    /// Whether the state (ξ, ξ̇) calls for a closer look; for the paper's own scene, whether it grows.
    #[inline(always)]
    #[must_use]
    pub(crate) fn exceeds(&self, xi: f64, v: f64) -> bool {
        self.is_past(self.size(xi, v))
    }

    /// The square of a norm of the state (ξ, ξ̇).
    #[inline(always)]
    #[must_use]
    pub(crate) fn size(&self, xi: f64, v: f64) -> f64 {
        let real = xi + self.c * v;
        let imaginary = self.s * v;
        real * real + imaginary * imaginary
    }

    /// Whether a state with a norm of this square calls for a closer look.
    #[inline(always)]
    #[must_use]
    pub(crate) fn is_past(&self, size: f64) -> bool {
        // What is no number any more is past every radius too.
        !matches!(
            size.partial_cmp(&self.square),
            Some(Ordering::Less | Ordering::Equal)
        )
    }

    /// Whether divergence is certain from this state on; `samples` are those that the controller
    /// remembers, the latest first.
    #[must_use]
    pub(crate) fn certain(&self, state: &State<f64>, samples: impl Iterator<Item = f64>) -> bool {
        if !self.exceeds(state.xi, state.velocity) {
            return false;
        }
        // What is no number any more is past all numbers too.
        if !(state.xi.abs() < OVERFLOW && state.velocity.abs() < OVERFLOW) {
            return true;
        }
        let Some(mode) = &self.mode else {
            return self.is_possible();
        };
        let output = mode.lagging.then_some(state.output);
        let all = [state.xi, state.velocity]
            .into_iter()
            .chain(output)
            .chain(samples);
        let [mut real, mut imaginary] = [0.0, 0.0];
        for (x, [re, im]) in all.zip(&mode.left) {
            real += x * re;
            imaginary += x * im;
        }
        real.hypot(imaginary) > mode.radius
    }

    /// The radius in words, in this unit of length.
    #[must_use]
    pub(crate) fn words(&self, unit: &str) -> String {
        match self.factor {
            Some(factor) if self.square < OVERFLOW * OVERFLOW => format!(
                "the radius {} {unit} of the growing mode (a factor of {factor:.9} a sample): \
                 beyond it quantization and Coulomb friction cannot stop the growth",
                significant(self.mode.as_ref().map_or(self.square.sqrt(), |m| m.radius))
            ),
            _ => format!("{OVERFLOW:e} {unit}, where numbers end"),
        }
    }

    /// The growth of a scene with history, an amplifier, an arm or a force.
    fn general(system: &System<'_>) -> Option<Self> {
        let own = system.own();
        let size = own + system.controller.memory();
        // The rows of the transpose: where each unit vector leads.
        let columns: Option<Vec<Vec<f64>>> = (0..size)
            .map(|column| {
                let unit = (0..size).map(|row| f64::from(u8::from(row == column)));
                system.linear_step(&unit.collect::<Vec<_>>())
            })
            .collect();
        let (left, factor) = dominant_left(&transposed(&columns?))?;
        if factor - 1.0 < LEAST_EXCESS.max(1e-9) {
            return None;
        }
        let mut sizes = left.iter().map(|[re, im]| re.hypot(*im));
        let [xi, velocity] = [sizes.next()?, sizes.next()?];
        let output = if system.lags() { sizes.next()? } else { 0.0 };
        let remembered: f64 = sizes.sum();
        // An impulse of force moves ξ̇ by at most 1/M and ξ by at most t/M, arm and friction or not.
        let on_device =
            system.commanded_error() + system.largest_force.unwrap_or(0.0) + system.constants.sigma;
        let disturbance =
            on_device * (0.5 * xi + velocity) / system.mass() + system.commanded_error() * output;
        // What the controller remembers are samples, each off by at most ½ from the position.
        let radius = (disturbance / (factor - 1.0) + system.error() * remembered) * WIDENED;
        // |ℓx| > R needs some |x_i| > R/Σ|ℓ_i|: look once ξ or ξ̇ is that large.
        let look = radius / (xi + velocity + output + remembered);
        Some(Self {
            c: 0.0,
            s: 1.0,
            square: (look * look).min(OVERFLOW * OVERFLOW),
            factor: Some(factor),
            mode: Some(Mode {
                left,
                radius,
                lagging: system.lags(),
            }),
        })
    }
}

impl System<'_> {
    /// How far a sample may be from the position.
    fn error(&self) -> f64 {
        if self.controller.encoder { 0.5 } else { 0.0 }
    }

    /// Whether the amplifier's output is part of the state.
    fn lags(&self) -> bool {
        self.flow.is_some_and(|flow| flow.rate.is_some())
    }

    /// How many numbers the state has beside past positions: ξ, ξ̇ and an amplifier's output.
    fn own(&self) -> usize {
        2 + usize::from(self.lags())
    }

    /// The mass that moves.
    fn mass(&self) -> f64 {
        self.flow.map_or(self.constants.mu, |flow| flow.mass.0)
    }

    /// How far the commanded force may be from that of the linear filter: each sample is off by the
    /// encoder's error, the D/A converter by half a step.
    fn commanded_error(&self) -> f64 {
        let filter = &self.controller.filter;
        // cⱼ = gⱼ − gⱼ₊₁, with g₀ = H(1).
        let sums = || {
            std::iter::once(&filter.sum)
                .chain(&filter.tails)
                .map(|g| g.0)
        };
        let next = sums().skip(1).chain([0.0]);
        let gain: f64 = sums().zip(next).map(|(g, next)| (g - next).abs()).sum();
        let step = match self.controller.force_step {
            Some([Double(numerator), Double(denominator)]) => 0.5 * numerator / denominator,
            None => 0.0,
        };
        self.error() * gain + step
    }

    /// One sampling interval of the loop without quantization and Coulomb friction; `None` when
    /// numbers overflow.
    ///
    /// The state is ξ, ξ̇, the amplifier's output if there is one, and past positions, latest first.
    fn linear_step(&self, state: &[f64]) -> Option<Vec<f64>> {
        let (own, past) = state.split_at_checked(self.own())?;
        let [xi, velocity] = [*own.first()?, *own.get(1)?];
        let positions: Vec<Double> = std::iter::once(xi)
            .chain(past.iter().copied())
            .map(Double)
            .collect();
        let linear = Controller {
            encoder: false,
            force_step: None,
            ..self.controller.clone()
        };
        let Double(command) = linear.held_force(&positions);
        let mut next = match self.flow {
            Some(flow) => {
                let smooth = Flow {
                    sigma: None,
                    ..flow.clone()
                };
                let start = State {
                    xi,
                    velocity,
                    output: own.get(2).copied().unwrap_or(command),
                };
                let end = smooth.advance_doubles(&start, command, 0.0, false)?.end;
                let output = self.lags().then_some(end.output);
                [end.xi, end.velocity].into_iter().chain(output).collect()
            }
            None => {
                let moved = self
                    .constants
                    .advance::<true, false, false>(xi, velocity, command);
                vec![moved.xi, moved.velocity]
            }
        };
        next.extend(positions.iter().map(|x| x.0).take(past.len()));
        Some(next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn too_little_viscous_friction_lets_the_motion_grow() {
        let grows = |beta| Growth::plain(&Constants::new(50.0, beta, 0.6), 0.5).is_possible();
        assert!(grows(0.4) && !grows(0.6));
    }

    #[test]
    fn general_and_closed_form_agree_on_the_papers_scene() {
        let k = Constants::new(50.0, 0.3, 0.6);
        let matrix = vec![
            vec![1.0 - k.phi2 / k.mu, k.phi1],
            vec![-k.phi1 / k.mu, k.decay],
        ];
        let (left, factor) = dominant_left(&matrix).unwrap();
        let plain = Growth::plain(&k, 0.5);
        assert!((factor - plain.factor.unwrap()).abs() < 1e-12);
        // Both are |ℓx| up to a scale.
        let size = |x: [f64; 2]| {
            let part = |i: usize| x[0] * left[0][i] + x[1] * left[1][i];
            part(0).hypot(part(1))
        };
        let closed = |x: [f64; 2]| (x[0] + plain.c * x[1]).hypot(plain.s * x[1]);
        let scale = size([1.0, 0.0]) / closed([1.0, 0.0]);
        for x in [[0.0, 1.0], [1.0, 1.0], [-3.0, 0.2]] {
            assert!((size(x) / closed(x) - scale).abs() < 1e-9 * scale);
        }
    }

    #[test]
    fn past_the_radius_the_mode_grows_whatever_disturbs_it() {
        for (mu, beta, sigma) in [
            (50.0, 0.3, 0.6),
            (50.0, 0.49, 0.1),
            (0.2, 0.1, 0.3),
            (1.0, 0.0, 0.5),
        ] {
            let k = Constants::new(mu, beta, sigma);
            let growth = Growth::plain(&k, 0.5);
            let factor = growth.factor.unwrap();
            let norm = |xi: f64, v: f64| (xi + growth.c * v).hypot(growth.s * v);
            let radius = growth.square.sqrt();
            for angle in 0..64 {
                let angle = f64::from(angle) * 0.1;
                // A state just past the radius, in the basis in which the norm is round.
                let v = if growth.s == 0.0 {
                    0.0
                } else {
                    radius * angle.sin() / growth.s
                };
                let xi = if growth.s == 0.0 {
                    radius
                } else {
                    radius * angle.cos() - growth.c * v
                };
                let (xi, v) = (xi * 1.001, v * 1.001);
                for error in [-0.5, 0.0, 0.5] {
                    let moved = k.advance::<true, true, false>(xi, v, -(xi + error));
                    let (before, after) = (norm(xi, v), norm(moved.xi, moved.velocity));
                    let least = radius + factor * (before - radius);
                    assert!(after >= least * (1.0 - 1e-5), "μ {mu}: {before} → {after}");
                }
            }
        }
    }
}
