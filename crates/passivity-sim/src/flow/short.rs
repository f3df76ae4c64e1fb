//! The power series of the motion over a part of an interval that is short against all its rates.
#![expect(
    clippy::indexing_slicing,
    reason = "every index is a constant below the length of a fixed array"
)]

use super::wide::Wide;

/// Terms of the series. Over 1/N of an interval, with 2·rate/N ≤ 1/32, the first one left out is
/// (1/32)⁹/9! < 2⁻⁶³ of the first one.
pub(super) const TERMS: usize = 9;

/// 1/n.
pub(super) const INVERSE: [f64; TERMS + 1] = {
    let mut inverse = [0.0; TERMS + 1];
    let mut n = 1;
    while n <= TERMS {
        inverse[n] = 1.0 / n as f64;
        n += 1;
    }
    inverse
};

/// The parameters of a motion, or of several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rates<T = f64> {
    /// 1/M.
    pub(super) inverse_mass: T,
    /// β′, the device's viscous friction and the arm's damping.
    pub(super) damping: T,
    /// k, the arm's stiffness.
    pub(super) stiffness: T,
    /// κ, 0 without an amplifier.
    pub(super) rate: T,
}

/// v, p and e.
pub(super) type Inner<T = f64> = [T; 3];

/// A polynomial of which the constant comes first.
type Polynomial<const W: usize> = [Wide<W>; TERMS];

/// The value of a polynomial by Estrin's scheme: few steps wait for another.
#[inline(always)]
fn value<const W: usize>(c: &Polynomial<W>, t: Wide<W>) -> Wide<W> {
    let t2 = t * t;
    let t4 = t2 * t2;
    let low = (c[0] + c[1] * t) + t2 * (c[2] + c[3] * t);
    let high = (c[4] + c[5] * t) + t2 * (c[6] + c[7] * t);
    low + t4 * (high + t4 * c[8])
}

/// The coefficients after the first.
#[inline(always)]
fn later<const W: usize>(c: &Polynomial<W>) -> Polynomial<W> {
    let mut later = [Wide::splat(0.0); TERMS];
    later[..TERMS - 1].copy_from_slice(&c[1..]);
    later
}

/// The power series of motions from a state: v = Σ vₙtⁿ and e = Σ eₙtⁿ.
pub(super) struct Short<const W: usize> {
    pub(super) velocity: Polynomial<W>,
    pub(super) excess: Polynomial<W>,
}

impl<const W: usize> Short<W> {
    /// From v, p and e.
    #[inline(always)]
    pub(super) fn new(rates: &Rates<Wide<W>>, [mut v, mut p, mut e]: Inner<Wide<W>>) -> Self {
        let mut series = Self {
            velocity: [Wide::splat(0.0); TERMS],
            excess: [Wide::splat(0.0); TERMS],
        };
        for n in 0..TERMS {
            (series.velocity[n], series.excess[n]) = (v, e);
            let over = INVERSE[n + 1];
            let lagging = rates.rate * e;
            (v, p, e) = (
                (p - rates.damping * v) * rates.inverse_mass * over,
                (lagging - rates.stiffness * v) * over,
                -(lagging * over),
            );
        }
        series
    }

    /// The way after the time `t`, and what has been added to v and e.
    #[inline(always)]
    pub(super) fn added(&self, t: Wide<W>) -> [Wide<W>; 3] {
        let mut way = self.velocity;
        for n in 0..TERMS {
            way[n] = way[n] * INVERSE[n + 1];
        }
        [
            value(&way, t) * t,
            value(&later(&self.velocity), t) * t,
            value(&later(&self.excess), t) * t,
        ]
    }
}

/// The sum of products.
#[inline(always)]
pub(super) fn dot<T: Copy + std::ops::Add<Output = T> + std::ops::Mul<Output = T>>(
    a: &Inner<T>,
    b: &Inner<T>,
) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The integral of the product of two series from 0 to t.
fn integral(a: &Polynomial<1>, b: &Polynomial<1>, t: f64) -> f64 {
    let mut sum = 0.0;
    for n in (0..TERMS).rev() {
        let mut term = 0.0;
        for i in 0..=n {
            term += a[i].0[0] * b[n - i].0[0];
        }
        sum = sum * t + term * INVERSE[n + 1];
    }
    sum * t
}

impl Rates {
    /// The same parameters for the series of a single motion.
    #[inline(always)]
    pub(super) fn single(&self) -> Rates<Wide<1>> {
        Rates {
            inverse_mass: Wide([self.inverse_mass]),
            damping: Wide([self.damping]),
            stiffness: Wide([self.stiffness]),
            rate: Wide([self.rate]),
        }
    }

    /// The series of a single motion.
    #[inline(always)]
    pub(super) fn series(&self, inner: &Inner) -> Short<1> {
        Short::new(&self.single(), inner.map(|x| Wide([x])))
    }
}

impl Short<1> {
    /// [`Short::added`] of a single motion.
    pub(super) fn added_alone(&self, t: f64) -> [f64; 3] {
        self.added(Wide([t])).map(|x| x.0[0])
    }

    /// ∫v² and ∫ev up to the time `t`.
    pub(super) fn energies(&self, t: f64) -> [f64; 2] {
        [self.square_with(self, t), self.lagging_with(self, t)]
    }

    /// ∫v² up to the time `t`, v being this motion's and the other's velocity.
    pub(super) fn square_with(&self, other: &Self, t: f64) -> f64 {
        integral(&self.velocity, &other.velocity, t)
    }

    /// ∫ev up to the time `t`, with this motion's excess and the other's velocity.
    pub(super) fn lagging_with(&self, other: &Self, t: f64) -> f64 {
        integral(&self.excess, &other.velocity, t)
    }
}
