//! The speed up to which a verdict is asked: the scene's bound, or that of TH-START.

use num_traits::{Signed, Zero};
use passivity_core::verdict::{RigBox, Speeds};
use passivity_core::{BigRational, Interval};

use super::report::BoundSource;
use crate::pi;
use crate::scene::{Scene, Start};

/// A bound V on the speed, in SI units: V itself, or its square where V is a root.
pub(super) struct SpeedBound {
    pub(super) source: BoundSource,
    /// The values of V, or of V² when `squared`.
    value: Interval<BigRational>,
    squared: bool,
}

impl SpeedBound {
    /// The bound of a scene: `operator.max_speed`, or V of TH-START for an unforced scene with a
    /// start; `None` when neither is given, or TH-START lacks the inertia.
    pub(super) fn of(scene: &Scene, level: usize) -> Option<Self> {
        if let Some(speed) = &scene.max_speed {
            let value = speed.value.enclosure(level);
            return Some(Self {
                source: BoundSource::MaxSpeed,
                value,
                squared: false,
            });
        }
        let start = scene.start.as_ref().filter(|_| scene.is_unforced())?;
        Self::of_start(scene, start, &scene.stiffness.value.enclosure(level), level)
    }

    /// V of TH-START at a stiffness: V² = ẋ(0)² + (K/m)·x(0)².
    pub(super) fn of_start(
        scene: &Scene,
        start: &Start,
        stiffness: &Interval<BigRational>,
        level: usize,
    ) -> Option<Self> {
        let velocity = magnitude(&start.velocity.value.enclosure(level));
        let position = magnitude(&start.position.value.enclosure(level));
        let source = BoundSource::Start;
        if position.hi().is_zero() {
            return Some(Self {
                source,
                value: velocity,
                squared: false,
            });
        }
        let inertia = scene.inertia.as_ref()?.value.enclosure(level);
        let square = |v: &BigRational, x: &BigRational, k: &BigRational, m: &BigRational| {
            v * v + x * x * k / m
        };
        let value = Interval::hull(
            square(velocity.lo(), position.lo(), stiffness.lo(), inertia.hi()),
            square(velocity.hi(), position.hi(), stiffness.hi(), inertia.lo()),
        );
        Some(Self {
            source,
            value,
            squared: true,
        })
    }

    /// Whether V is the root of what is known exactly.
    pub(super) const fn is_root(&self) -> bool {
        self.squared
    }

    fn speeds(&self, value: &BigRational) -> Speeds<BigRational> {
        if self.squared {
            Speeds::UpToSquared(value.clone())
        } else {
            Speeds::UpTo(value.clone())
        }
    }

    /// The largest bound within the tolerances, where the criterion is hardest to meet.
    pub(super) fn hardest(&self) -> Speeds<BigRational> {
        self.speeds(self.value.hi())
    }

    /// The least bound within the tolerances.
    pub(super) fn easiest(&self) -> Speeds<BigRational> {
        self.speeds(self.value.lo())
    }

    /// An enclosure of V, in SI units.
    pub(super) fn speed(&self) -> Interval<BigRational> {
        if self.squared {
            Interval::hull(root(self.value.lo(), false), root(self.value.hi(), true))
        } else {
            self.value.clone()
        }
    }

    /// An enclosure of V in ticks per sampling period (4).
    pub(super) fn in_ticks(&self, rigs: &RigBox) -> Interval<BigRational> {
        let speed = self.speed();
        Interval::hull(
            speed.lo() * rigs.period.lo() / rigs.length.hi(),
            speed.hi() * rigs.period.hi() / rigs.length.lo(),
        )
    }

    /// The least V in ticks per sampling period: what a witness must keep to.
    pub(super) fn least_in_ticks(&self, rigs: &RigBox) -> BigRational {
        self.in_ticks(rigs).lo().clone()
    }
}

/// The magnitudes of the numbers of an interval.
fn magnitude(range: &Interval<BigRational>) -> Interval<BigRational> {
    if range.lo().is_negative() && range.hi().is_positive() {
        return Interval::hull(BigRational::zero(), range.lo().abs().max(range.hi().abs()));
    }
    Interval::hull(range.lo().abs(), range.hi().abs())
}

/// A rational root of x ≥ 0, off by less than 2⁻²⁰⁰ of its size: rounded down, or up; exact for
/// the square of a rational.
pub(super) fn root(x: &BigRational, up: bool) -> BigRational {
    let (n, d) = (x.numer(), x.denom());
    let (root_n, root_d) = (n.sqrt(), d.sqrt());
    if &root_n * &root_n == *n && &root_d * &root_d == *d {
        return BigRational::new(root_n, root_d);
    }
    // √(n/d) = √(n·d)/d; spare bits make the whole root precise relative to its size.
    let shift = 2 * (200 + d.bits());
    let whole = ((n * d) << shift).sqrt();
    let whole = if up { whole + 1 } else { whole };
    BigRational::new(whole, d << (shift / 2))
}

/// The enclosures for figures that are printed.
pub(super) const PRINTED: usize = pi::PRINT_LEVEL;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_enclose_and_are_exact_for_squares() {
        let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
        assert_eq!(root(&ratio(9, 16), false), ratio(3, 4));
        for x in [
            ratio(2, 1),
            ratio(1, 3),
            ratio(1, i64::MAX),
            ratio(i64::MAX, 7),
        ] {
            let (lo, hi) = (root(&x, false), root(&x, true));
            assert!(&lo * &lo < x && x < &hi * &hi);
            let width = (&hi - &lo) / &lo;
            assert!(width < BigRational::new(1.into(), num_bigint::BigInt::from(1) << 199));
        }
    }
}
