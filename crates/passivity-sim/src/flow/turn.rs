//! A stop within an interval, and the motion on from it, by short series about nodes of the [`Table`].
//!
//! Nodes divide an interval into cells. A motion is known there as a product of its state at the start, and
//! between nodes as a power series about the nearest one. So the stop is a root of a polynomial, over half a
//! cell to either side. The motion is linear in its forces: what friction does when it changes its direction,
//! or lets go, is the answer of a device at rest to a force that begins then, and such an answer is a motion
//! known at nodes too. A motion over a part of an interval takes no exponential.
//!
//! With λ = β′/M and the derivatives d₀ = v, d₁ = p/M − λv,
//!
//! > dₙ₊₂ = (κ/M)·e·(−κ)ⁿ − (k/M)·dₙ − λ·dₙ₊₁.
//!
//! In the norm that weighs v, p/M and e/M by 1, 1/r and 1/r, r being the largest rate, a derivative is at most
//! 2r times the one before. Of T terms over ¾ of a cell c the first that is left out is, of p/M, at most
//! (2r·¾c)^(T−1)·¾c/T!: below 2⁻⁵² for T = [`LONG`] with c ≤ 1/(64r), and for T = [`SHORT`] with
//! c ≤ 1/(1024r), cells being 1/256 at most.

#![expect(
    clippy::indexing_slicing,
    reason = "indices are constants and those of terms and lanes, below the length of fixed arrays"
)]

use super::short::INVERSE;
use super::wide::Wide;

/// Terms of the series about a node.
pub(crate) const LONG: usize = 7;

/// The same where cells are short against all rates.
pub(crate) const SHORT: usize = 5;

/// The largest rate × cell for [`SHORT`].
pub(super) const SHORT_CELL: f64 = 1.0 / 1024.0;

/// How far from a node its series is taken, in cells.
const REACH: f64 = 0.75;

/// The constants of a motion, or of several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turns<T = f64> {
    /// 1/M.
    pub(crate) inverse_mass: T,
    /// λ.
    pub(crate) lambda: T,
    /// k.
    pub(crate) stiffness: T,
    /// k/M.
    pub(crate) spring: T,
    /// κ, 0 without an amplifier.
    pub(crate) rate: T,
    /// κ/M.
    pub(crate) driven: T,
    /// The width of a cell.
    pub(crate) cell: T,
}

/// A motion at the node that a stop is nearest to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near<T = f64> {
    /// The way there.
    pub(crate) way: T,
    /// v, v̇ and v̈ there.
    pub(crate) velocity: T,
    pub(crate) slope: T,
    pub(crate) bend: T,
    /// e there.
    pub(crate) excess: T,
    /// About how long after the node the stop is.
    pub(crate) time: T,
}

/// What acts on the device from a time on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Onward<T = f64> {
    /// The ways of the map of the node, for a force and for an excess of 1.
    pub(crate) way: [T; 2],
    /// The velocities.
    pub(crate) velocity: [T; 2],
    /// The excess, of one of 1.
    pub(crate) decay: T,
    /// The force that is added.
    pub(crate) push: T,
    /// The excess that begins to fade.
    pub(crate) excess: T,
    /// By how much the time to the end of the interval is shorter than that of the node.
    pub(crate) time: T,
}

impl<const W: usize> Turns<Wide<W>> {
    /// v and its derivatives, of which the first two follow v, and e.
    #[inline(always)]
    fn derivatives<const T: usize, const LAG: bool, const ARM: bool>(
        &self,
        [v, slope, bend]: [Wide<W>; 3],
        e: Wide<W>,
    ) -> [Wide<W>; T] {
        let mut d = [v; T];
        (d[1], d[2]) = (slope, bend);
        let mut lagging = if LAG { self.driven * e } else { e };
        for n in 3..T {
            if LAG {
                lagging = -(self.rate * lagging);
            }
            d[n] = self.next::<LAG, ARM>([d[n - 2], d[n - 1]], lagging);
        }
        d
    }

    /// dₙ₊₂. What is not there, lag or arm, is not computed; a κ or a k of 0 adds nothing.
    #[inline(always)]
    fn next<const LAG: bool, const ARM: bool>(
        &self,
        [before, last]: [Wide<W>; 2],
        lagging: Wide<W>,
    ) -> Wide<W> {
        let damped = self.lambda * last;
        match (LAG, ARM) {
            (true, true) => (lagging - self.spring * before) - damped,
            (true, false) => lagging - damped,
            (false, true) => -(self.spring * before) - damped,
            (false, false) => -damped,
        }
    }

    /// When the stop near a node is, after it, and 1 where it has been found.
    #[inline(always)]
    pub(crate) fn stop<const T: usize, const LAG: bool, const ARM: bool>(
        &self,
        near: &Near<Wide<W>>,
    ) -> (Wide<W>, [f64; W]) {
        // After a step s of Newton's the error is about |v̈/2v̇|·s².
        const CLOSE: f64 = f64::EPSILON;
        const MOST_STEPS: u32 = 4;
        let d = self.near::<T, LAG, ARM>(near);
        let mut time = near.time;
        let mut found = [0.0; W];
        for _ in 0..MOST_STEPS {
            let parts = parts::<W, T>(time);
            let slope = derivative(&d, &parts);
            let step = value(&d, &parts) / slope;
            let error = step * step * near.bend;
            let mut pending = false;
            for (i, found) in found.iter_mut().enumerate() {
                let close = error.0[i].abs() <= CLOSE * slope.0[i].abs();
                let before = *found > 0.0;
                time.0[i] -= if before { 0.0 } else { step.0[i] };
                *found = if close | before { 1.0 } else { 0.0 };
                pending |= !(close | before);
            }
            if !pending {
                break;
            }
        }
        let (bend, most) = (near.bend * self.cell, self.cell * REACH);
        for (i, found) in found.iter_mut().enumerate() {
            // The velocity falls all through the cell, and is 0 once.
            let straight = bend.0[i].abs() < near.slope.0[i].abs();
            let near = time.0[i].abs() <= most.0[i];
            *found = if straight & near { *found } else { 0.0 };
        }
        (time, found)
    }

    /// v and its derivatives at a node.
    #[inline(always)]
    fn near<const T: usize, const LAG: bool, const ARM: bool>(
        &self,
        near: &Near<Wide<W>>,
    ) -> [Wide<W>; T] {
        self.derivatives::<T, LAG, ARM>([near.velocity, near.slope, near.bend], near.excess)
    }

    /// The way to a stop so long after a node, and the excess there.
    #[inline(always)]
    pub(crate) fn reached<const T: usize, const LAG: bool, const ARM: bool>(
        &self,
        near: &Near<Wide<W>>,
        time: Wide<W>,
    ) -> [Wide<W>; 2] {
        let d = self.near::<T, LAG, ARM>(near);
        let parts = parts::<W, T>(time);
        let way = near.way + integral(&d, &parts);
        if LAG {
            [way, near.excess * self.decay(&parts)]
        } else {
            [way, near.excess]
        }
    }

    /// e^(−κt).
    #[inline(always)]
    fn decay<const T: usize>(&self, parts: &[Wide<W>; T]) -> Wide<W> {
        let one = Wide::splat(1.0);
        let mut sum = one - self.rate * parts[T - 1];
        for n in (0..T - 1).rev() {
            sum = one - self.rate * parts[n] * sum;
        }
        sum
    }

    /// The way and the velocity at the end of an interval, of a device at rest on which a force acts from a
    /// time on.
    #[inline(always)]
    pub(crate) fn onward<const T: usize, const LAG: bool, const ARM: bool>(
        &self,
        of: &Onward<Wide<W>>,
    ) -> [Wide<W>; 2] {
        let ([way, lagging_way], [velocity, lagging_velocity]) = (of.way, of.velocity);
        let mut way = of.push * way;
        let mut velocity = of.push * velocity;
        let (mut force, mut excess) = (of.push, of.excess);
        if LAG {
            way = way + of.excess * lagging_way;
            velocity = velocity + of.excess * lagging_velocity;
            excess = of.excess * of.decay;
            force = force + (of.excess - excess);
        }
        if ARM {
            force = force - self.stiffness * way;
        }
        let slope = force * self.inverse_mass - self.lambda * velocity;
        let bend = self.next::<LAG, ARM>([velocity, slope], self.driven * excess);
        let d = self.derivatives::<T, LAG, ARM>([velocity, slope, bend], excess);
        let parts = parts::<W, T>(-of.time);
        [way + integral(&d, &parts), value(&d, &parts)]
    }
}

impl Turns {
    /// The constants of a single motion.
    #[inline(always)]
    pub(super) const fn single(&self) -> Turns<Wide<1>> {
        Turns {
            inverse_mass: Wide([self.inverse_mass]),
            lambda: Wide([self.lambda]),
            stiffness: Wide([self.stiffness]),
            spring: Wide([self.spring]),
            rate: Wide([self.rate]),
            driven: Wide([self.driven]),
            cell: Wide([self.cell]),
        }
    }
}

impl Near {
    /// A single motion.
    #[inline(always)]
    pub(super) fn wide(&self) -> Near<Wide<1>> {
        Near {
            way: Wide([self.way]),
            velocity: Wide([self.velocity]),
            slope: Wide([self.slope]),
            bend: Wide([self.bend]),
            excess: Wide([self.excess]),
            time: Wide([self.time]),
        }
    }
}

impl Onward {
    /// A single motion.
    #[inline(always)]
    pub(super) fn wide(&self) -> Onward<Wide<1>> {
        Onward {
            way: self.way.map(|x| Wide([x])),
            velocity: self.velocity.map(|x| Wide([x])),
            decay: Wide([self.decay]),
            push: Wide([self.push]),
            excess: Wide([self.excess]),
            time: Wide([self.time]),
        }
    }
}

/// t/n for each term.
#[inline(always)]
fn parts<const W: usize, const T: usize>(t: Wide<W>) -> [Wide<W>; T] {
    let mut parts = [t; T];
    let mut n = 1;
    // Not by iterators: those are not unrolled, for all that T is known.
    while n < T {
        parts[n] = t * INVERSE[n + 1];
        n += 1;
    }
    parts
}

/// Σ dₙtⁿ/n!.
#[inline(always)]
fn value<const W: usize, const T: usize>(d: &[Wide<W>; T], parts: &[Wide<W>; T]) -> Wide<W> {
    let mut sum = d[T - 1];
    for n in (0..T - 1).rev() {
        sum = d[n] + parts[n] * sum;
    }
    sum
}

/// Its derivative.
#[inline(always)]
fn derivative<const W: usize, const T: usize>(d: &[Wide<W>; T], parts: &[Wide<W>; T]) -> Wide<W> {
    let mut sum = d[T - 1];
    for n in (1..T - 1).rev() {
        sum = d[n] + parts[n - 1] * sum;
    }
    sum
}

/// Its integral.
#[inline(always)]
fn integral<const W: usize, const T: usize>(d: &[Wide<W>; T], parts: &[Wide<W>; T]) -> Wide<W> {
    let mut sum = d[T - 1];
    for n in (0..T - 1).rev() {
        sum = d[n] + parts[n + 1] * sum;
    }
    parts[0] * sum
}
