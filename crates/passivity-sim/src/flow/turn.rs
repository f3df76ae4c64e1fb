//! Stops and starts in an interval where the motion is a sum of exponentials: no arm's spring, an amplifier
//! or none.
//!
//! With λ = β′/M, and κ apart from it, a motion from v, p and e has after the time t
//!
//! > v(t) = vL + ((p + e)f − eG)/M, way = vf + ((p + e)g − e∫G)/M,
//! > L = e^(−λt), f = ∫L, g = ∫f, K = e^(−κt), G = (L − K)/(κ − λ), ∫G = (f − (1 − K)/κ)/(κ − λ).
//!
//! The stop is found by Halley's iteration on v, of which v̇ and v̈ cost next to nothing more. It ends where
//! |v| is what its computation is off by, so that what is lost is a rounding of the velocity, of which an
//! interval has a dozen ([`rounding`](crate::rounding)). What it leaves undecided goes the way of
//! [`events`](super::events).

#![expect(
    clippy::indexing_slicing,
    reason = "indices are those of lanes, and constants below the length of fixed arrays"
)]

use super::fast::Fast;
use super::wide::Wide;
use super::{Flowed, State};
use crate::number::MAGIC;

/// The constants of such motions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Exponentials<T = f64> {
    pub(crate) inverse_mass: T,
    pub(crate) sigma: T,
    /// λ.
    pub(crate) lambda: T,
    /// κ, 0 without an amplifier.
    pub(crate) rate: T,
    /// 1/κ and 1/(κ − λ); 0 without an amplifier, where e is 0.
    pub(crate) over: [T; 2],
    /// e^(−κ).
    pub(crate) excess: T,
}

impl Exponentials {
    /// Those of a flow with this excess at the end of an interval, where the closed form is good to a few
    /// roundings of the forces.
    pub(super) fn of(fast: &Fast) -> Option<Self> {
        const LARGEST_LAMBDA: f64 = 0.5;
        const LEAST_APART: f64 = 0.5;
        let rates = &fast.rates;
        let lambda = rates.damping * rates.inverse_mass;
        let apart = rates.rate - lambda;
        let over = if fast.lags() {
            [1.0 / rates.rate, 1.0 / apart]
        } else {
            [0.0; 2]
        };
        let good = lambda <= LARGEST_LAMBDA && (!fast.lags() || apart >= LEAST_APART);
        (good && rates.stiffness == 0.0 && fast.in_lanes()).then_some(Self {
            inverse_mass: rates.inverse_mass,
            sigma: fast.sigma,
            lambda,
            rate: rates.rate,
            over,
            excess: fast.whole.excess,
        })
    }

    /// The constants of a single motion.
    fn single(&self) -> Exponentials<Wide<1>> {
        let one = |x: f64| Wide([x]);
        Exponentials {
            inverse_mass: one(self.inverse_mass),
            sigma: one(self.sigma),
            lambda: one(self.lambda),
            rate: one(self.rate),
            over: self.over.map(one),
            excess: one(self.excess),
        }
    }

    /// The interval from a state in which the device stands, or is to turn; `None` where that is left
    /// undecided.
    #[inline(always)]
    pub(super) fn turn(
        &self,
        start: &State<f64>,
        command: f64,
        [net, excess, last]: [f64; 3],
    ) -> Option<Flowed<f64>> {
        let turning = Turning {
            velocity: Wide([start.velocity]),
            net: Wide([net]),
            excess: Wide([excess]),
            last: Wide([last]),
        };
        let ([Wide([way]), Wide([velocity])], [decided]) = turning.end(&self.single());
        (decided > 0.0).then_some(Flowed {
            end: State {
                xi: start.xi + way,
                velocity,
                output: command - self.excess * excess,
            },
            path: 0.0,
            square: 0.0,
            work: 0.0,
        })
    }
}

/// Intervals with a stop, or from rest.
pub(crate) struct Turning<const W: usize> {
    /// ξ̇ at the start.
    pub(crate) velocity: Wide<W>,
    /// What acts on the device at rest, y + F.
    pub(crate) net: Wide<W>,
    /// e.
    pub(crate) excess: Wide<W>,
    /// ξ̇ at the end if friction kept its direction.
    pub(crate) last: Wide<W>,
}

/// What the closed form is made of at a time.
struct At<const W: usize> {
    decay: Wide<W>,
    /// f and g.
    integrals: [Wide<W>; 2],
    lag: Wide<W>,
    /// G.
    lagging: Wide<W>,
}

impl<const W: usize> Exponentials<Wide<W>> {
    /// After the time `t`, when e has decayed to the part `lag` of itself.
    #[inline(always)]
    fn at(&self, t: Wide<W>, lag: Wide<W>) -> At<W> {
        let one = Wide::splat(1.0);
        let x = self.lambda * t;
        let second = phi2(x);
        let first = one - x * second;
        let decay = one - x * first;
        let [_, apart] = self.over;
        At {
            decay,
            integrals: [t * first, t * t * second],
            lag,
            lagging: (decay - lag) * apart,
        }
    }
}

impl<const W: usize> At<W> {
    /// ξ̇ from v, p and e.
    #[inline(always)]
    fn velocity(&self, k: &Exponentials<Wide<W>>, [v, p, e]: [Wide<W>; 3]) -> Wide<W> {
        let [f, _] = self.integrals;
        v * self.decay + ((p + e) * f - e * self.lagging) * k.inverse_mass
    }

    /// The way.
    #[inline(always)]
    fn way(&self, k: &Exponentials<Wide<W>>, [v, p, e]: [Wide<W>; 3]) -> Wide<W> {
        let ([f, g], [over_rate, apart]) = (self.integrals, k.over);
        let lagging = (f - (Wide::splat(1.0) - self.lag) * over_rate) * apart;
        v * f + ((p + e) * g - e * lagging) * k.inverse_mass
    }
}

impl<const W: usize> Turning<W> {
    /// The way and the velocity at the end, and 1 where they are decided.
    #[inline(always)]
    pub(crate) fn end(&self, k: &Exponentials<Wide<W>>) -> ([Wide<W>; 2], [f64; W]) {
        let one = Wide::splat(1.0);
        let (v, e) = (self.velocity, self.excess);
        let p = self.net - k.sigma.with_sign_of(v);
        let inner = [v, p, e];
        let (time, there, mut decided) = self.stop(k, inner);
        let mut way = there.way(k, inner);

        // From rest at the stop, or from where friction lets go after it.
        let mut net = self.net + e * (one - there.lag);
        let at_end = self.net + e * (one - k.excess);
        let (mut left, mut lag) = (one - time, there.lag);
        let (mut stays, mut waits) = ([0.0; W], false);
        for i in 0..W {
            let sigma = k.sigma.0[i];
            let held = net.0[i].abs() <= sigma;
            stays[i] = if held & (at_end.0[i].abs() <= sigma) {
                1.0
            } else {
                0.0
            };
            waits |= held & (stays[i] == 0.0) & (decided[i] > 0.0);
        }
        if waits {
            self.wait(k, [&mut net, &mut left, &mut lag], &mut decided);
        }
        let pull = net - k.sigma.with_sign_of(net);
        let on = k.at(left, k.excess / lag);
        let inner = [Wide::splat(0.0), pull, e * lag];
        let (mut velocity, onward) = (on.velocity(k, inner), on.way(k, inner));
        for i in 0..W {
            // A second stop in the interval is left to others.
            let goes = velocity.0[i] * 1.0_f64.copysign(net.0[i]) >= 0.0;
            let stays = stays[i] > 0.0;
            decided[i] = if goes | stays { decided[i] } else { 0.0 };
            way.0[i] += if stays { 0.0 } else { onward.0[i] };
            velocity.0[i] = if stays { 0.0 } else { velocity.0[i] };
        }
        ([way, velocity], decided)
    }

    /// Waits until friction lets go, where it holds the device at first and not at the end: the net force is
    /// ±σ then, and the excess has fallen as e^(−κt). One motion at a time, for the logarithm.
    #[inline(never)]
    fn wait(
        &self,
        k: &Exponentials<Wide<W>>,
        [net, left, lag]: [&mut Wide<W>; 3],
        decided: &mut [f64; W],
    ) {
        for (i, decided) in decided.iter_mut().enumerate() {
            let (sigma, e) = (k.sigma.0[i], self.excess.0[i]);
            let at_end = self.net.0[i] + e * (1.0 - k.excess.0[i]);
            if net.0[i].abs() > sigma || at_end.abs() <= sigma {
                continue;
            }
            let (excess, lets_go) = (e * lag.0[i], sigma.copysign(at_end));
            let part = (excess + net.0[i] - lets_go) / excess;
            let wait = -part.ln() * k.over[0].0[i];
            left.0[i] -= wait;
            lag.0[i] *= part;
            net.0[i] = lets_go;
            if !(wait >= 0.0 && left.0[i] >= 0.0) {
                *decided = 0.0;
            }
        }
    }

    /// When the velocity is 0, what the closed form has there, and 1 where it was found.
    #[inline(always)]
    fn stop(&self, k: &Exponentials<Wide<W>>, inner: [Wide<W>; 3]) -> (Wide<W>, At<W>, [f64; W]) {
        /// From a parabola's root on, two or three are enough unless the amplifier is fast.
        const MOST_STEPS: u32 = 12;
        /// What is left of a velocity, over the speeds that it is made of.
        const LEFT: f64 = 8.0 * f64::EPSILON;
        let [v, p, e] = inner;
        let one = Wide::splat(1.0);
        // The parabola with the velocity at both ends and the slope at the start.
        let slope = p * k.inverse_mass - k.lambda * v;
        let bend = self.last - v - slope;
        let root = (slope * slope - bend * v * 4.0).sqrt();
        let mut time = Wide::splat(0.0);
        let (mut low, mut high) = ([0.0; W], [1.0; W]);
        let (mut found, mut least) = ([0.0; W], [0.0; W]);
        for i in 0..W {
            let (v, p, e) = (v.0[i], p.0[i], e.0[i]);
            let sign = 1.0_f64.copysign(v);
            let guess = 2.0 * v * sign / (root.0[i] - slope.0[i] * sign);
            let inside = (guess > 0.0) & (guess < 1.0);
            let turns = (self.last.0[i] * sign < 0.0) & (v != 0.0);
            time.0[i] = if !turns {
                0.0
            } else if inside {
                guess
            } else {
                0.5
            };
            // Where nothing turns there is nothing to be found; from rest the stop is the start.
            found[i] = if turns { 0.0 } else { 1.0 };
            least[i] = LEFT * (v.abs() + (p.abs() + 2.0 * e.abs()) * k.inverse_mass.0[i]);
        }
        let mut at = k.at(time, decayed(k.rate * time));
        for _ in 0..MOST_STEPS {
            let speed = at.velocity(k, inner);
            let mut pending = false;
            for i in 0..W {
                let before = speed.0[i] * v.0[i] > 0.0;
                low[i] = if before { time.0[i] } else { low[i] };
                high[i] = if before { high[i] } else { time.0[i] };
                let ends = speed.0[i].abs() <= least[i];
                found[i] = if ends { 1.0 } else { found[i] };
                pending |= found[i] == 0.0;
            }
            if !pending {
                break;
            }
            let slope = (p + e * (one - at.lag)) * k.inverse_mass - k.lambda * speed;
            let bend = k.rate * e * at.lag * k.inverse_mass - k.lambda * slope;
            let step = speed * slope * 2.0 / (slope * slope * 2.0 - speed * bend);
            let next = time - step;
            for i in 0..W {
                let inside = (next.0[i] > low[i]) & (next.0[i] < high[i]);
                let middle = 0.5 * (low[i] + high[i]);
                let next = if inside { next.0[i] } else { middle };
                time.0[i] = if found[i] > 0.0 { time.0[i] } else { next };
            }
            at = k.at(time, decayed(k.rate * time));
        }
        let mut decided = [0.0; W];
        for i in 0..W {
            let turns = self.last.0[i] * v.0[i] < 0.0;
            let stands = v.0[i] == 0.0;
            decided[i] = if turns || stands { found[i] } else { 0.0 };
        }
        (time, at, decided)
    }
}

/// Coefficients of φ₂(−x) = Σ (−x)ⁿ/(n + 2)!; for x ≤ ½ the first one left out is x¹⁴/16! < 2⁻⁵⁶ of the sum.
const PHI2: [f64; 14] = {
    let mut c = [0.5; 14];
    let mut n = 1;
    while n < 14 {
        c[n] = -c[n - 1] / (n + 2) as f64;
        n += 1;
    }
    c
};

/// φ₂(−x), by Estrin's scheme.
#[inline(always)]
fn phi2<const W: usize>(x: Wide<W>) -> Wide<W> {
    let c = |n: usize| Wide::splat(PHI2[n]);
    let x2 = x * x;
    let x4 = x2 * x2;
    let x8 = x4 * x4;
    let low = (c(0) + x * PHI2[1]) + x2 * (c(2) + x * PHI2[3]);
    let middle = (c(4) + x * PHI2[5]) + x2 * (c(6) + x * PHI2[7]);
    let high = (c(8) + x * PHI2[9]) + x2 * (c(10) + x * PHI2[11]);
    (low + x4 * middle) + x8 * (high + x4 * (c(12) + x * PHI2[13]))
}

/// 1/n!.
const INVERSE_FACTORIAL: [f64; 14] = {
    let mut c = [1.0; 14];
    let mut n = 1;
    while n < 14 {
        c[n] = c[n - 1] / n as f64;
        n += 1;
    }
    c
};

/// e^(−y) for 0 ≤ y ≤ 700: 2⁻ⁿ times the series of e^r, |r| ≤ ½ ln 2, of which the first term left out is
/// r¹⁴/14! < 2⁻⁵⁷.
#[inline(always)]
fn decayed<const W: usize>(y: Wide<W>) -> Wide<W> {
    // ln 2 in two parts, of which n times the first one is exact.
    const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];
    let shifted = y * std::f64::consts::LOG2_E + Wide::splat(MAGIC);
    let n = shifted - Wide::splat(MAGIC);
    let r = (n * LN_2[0] - y) + n * LN_2[1];
    let c = |n: usize| Wide::splat(INVERSE_FACTORIAL[n]);
    let r2 = r * r;
    let r4 = r2 * r2;
    let r8 = r4 * r4;
    let low = (c(0) + r) + r2 * (c(2) + r * INVERSE_FACTORIAL[3]);
    let middle = (c(4) + r * INVERSE_FACTORIAL[5]) + r2 * (c(6) + r * INVERSE_FACTORIAL[7]);
    let high = (c(8) + r * INVERSE_FACTORIAL[9]) + r2 * (c(10) + r * INVERSE_FACTORIAL[11]);
    let sum = (low + r4 * middle) + r8 * (high + r4 * (c(12) + r * INVERSE_FACTORIAL[13]));
    sum * shifted.two_to_minus()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponentials_are_those_of_the_library() {
        for i in 0..100_000 {
            let y = f64::from(i) * 0.005;
            let Wide([got]) = decayed(Wide([y]));
            let want = (-y).exp();
            assert!(
                (got - want).abs() <= 2.0 * f64::EPSILON * want,
                "{y}: {got} {want}"
            );
            let x = f64::from(i) * 5e-6;
            let Wide([got]) = phi2(Wide([x]));
            let want = crate::phi::phi2(-x); // Good to a few ulp, as this one is.
            assert!(
                (got - want).abs() <= 4.0 * f64::EPSILON * want,
                "{x}: {got} {want}"
            );
        }
    }
}
