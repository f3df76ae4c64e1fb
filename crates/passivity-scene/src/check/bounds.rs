//! The speed up to which a verdict is asked: the scene's bound, or that of TH-START.

use std::cmp::Ordering;

use passivity_core::verdict::{RigBox, Speeds};
use passivity_core::{BigRational, Interval, Ordered, Scalar, Wide, rational, start};

use super::report::BoundSource;
use crate::pi;
use crate::scene::{Scene, Start};

/// A bound V on the speed, in SI units: V itself, or its square where V is a root.
pub(super) struct SpeedBound {
    pub(super) source: BoundSource,
    /// The values of V, or of V² when `squared`.
    value: Interval<Wide>,
    squared: bool,
}

impl SpeedBound {
    /// The bound of a scene: `operator.max_speed`, or V of TH-START for an unforced scene with a
    /// start; `None` when neither is given, or TH-START lacks the inertia.
    pub(super) fn of(scene: &Scene, level: usize) -> Option<Self> {
        if let Some(speed) = &scene.max_speed {
            let value = wide(&speed.value.enclosure(level));
            return Some(Self {
                source: BoundSource::MaxSpeed,
                value,
                squared: false,
            });
        }
        let from = scene.start.as_ref().filter(|_| scene.is_unforced())?;
        Self::of_start(
            scene,
            from,
            &wide(&scene.stiffness.value.enclosure(level)),
            level,
        )
    }

    /// V of TH-START at a stiffness: V² = ẋ(0)² + (K/m)·x(0)².
    pub(super) fn of_start(
        scene: &Scene,
        from: &Start,
        stiffness: &Interval<Wide>,
        level: usize,
    ) -> Option<Self> {
        let velocity = magnitude(&wide(&from.velocity.value.enclosure(level)));
        let position = magnitude(&wide(&from.position.value.enclosure(level)));
        let source = BoundSource::Start;
        if position.hi().is_positive() == Some(false) {
            return Some(Self {
                source,
                value: velocity,
                squared: false,
            });
        }
        let inertia = wide(&scene.inertia.as_ref()?.value.enclosure(level));
        let square = |v: &Wide, x: &Wide, k: &Wide, m: &Wide| {
            start::speed_squared(&m.clone().over(k.clone()), x, v)
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

    fn speeds(&self, value: &Wide) -> Speeds<Wide> {
        if self.squared {
            Speeds::UpToSquared(value.clone())
        } else {
            Speeds::UpTo(value.clone())
        }
    }

    /// The largest bound within the tolerances, where the criterion is hardest to meet.
    pub(super) fn hardest(&self) -> Speeds<Wide> {
        self.speeds(self.value.hi())
    }

    /// The least bound within the tolerances.
    pub(super) fn easiest(&self) -> Speeds<Wide> {
        self.speeds(self.value.lo())
    }

    /// An enclosure of V, in SI units.
    pub(super) fn speed(&self) -> Interval<Wide> {
        if self.squared {
            Interval::hull(root(self.value.lo(), false), root(self.value.hi(), true))
        } else {
            self.value.clone()
        }
    }

    /// An enclosure of V in ticks per sampling period (4).
    pub(super) fn in_ticks(&self, rigs: &RigBox<Wide>) -> Interval<Wide> {
        in_ticks(&self.speed(), rigs)
    }

    /// The least V in ticks per sampling period: what a witness must keep to.
    pub(super) fn least_in_ticks(&self, rigs: &RigBox<Wide>) -> BigRational {
        let ticks = self.in_ticks(rigs);
        super::report::reduced(ticks.lo())
    }
}

/// A speed in SI units as ticks per sampling period (4).
pub(super) fn in_ticks(speed: &Interval<Wide>, rigs: &RigBox<Wide>) -> Interval<Wide> {
    let of =
        |v: &Wide, period: &Wide, length: &Wide| (v.clone() * period.clone()).over(length.clone());
    Interval::hull(
        of(speed.lo(), rigs.period.lo(), rigs.length.hi()),
        of(speed.hi(), rigs.period.hi(), rigs.length.lo()),
    )
}

fn wide(range: &Interval<BigRational>) -> Interval<Wide> {
    range.map(rational::to_wide)
}

/// The magnitudes of the numbers of an interval.
fn magnitude(range: &Interval<Wide>) -> Interval<Wide> {
    let ends = Interval::hull(range.lo().abs(), range.hi().abs());
    match (range.lo().sign(), range.hi().sign()) {
        (Some(Ordering::Less), Some(Ordering::Greater)) => {
            Interval::hull(Wide::zero(), ends.hi().clone())
        }
        _ => ends,
    }
}

/// A rational root of x ≥ 0, off by less than 2⁻²⁰⁰ of its size: rounded down, or up; exact for
/// the square of a rational.
fn root(x: &Wide, up: bool) -> Wide {
    const BITS: u32 = 200;
    let Some((n, d)) = x.reduced() else {
        return x.clone();
    };
    let (root_n, root_d) = (n.sqrt(), d.sqrt());
    if &root_n * &root_n == n && &root_d * &root_d == d {
        return Wide::new(root_n, root_d);
    }
    // √(n/d) = √(n·d)/d, and the whole number n·d is at least 1: these bits are all past its point.
    let whole = ((n * &d) << (2 * BITS)).sqrt();
    let whole = if up { whole + 1 } else { whole };
    Wide::new(whole, d << BITS)
}

/// The enclosures for figures that are printed.
pub(super) const PRINTED: usize = pi::PRINT_LEVEL;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_enclose_and_are_exact_for_squares() {
        let ratio = |n: i64, d: i64| Wide::new(n.into(), d.into());
        assert_eq!(root(&ratio(9, 16), false), ratio(3, 4));
        for x in [
            ratio(2, 1),
            ratio(1, 3),
            ratio(1, i64::MAX),
            ratio(i64::MAX, 7),
        ] {
            let (lo, hi) = (root(&x, false), root(&x, true));
            assert!(lo.square() < x && x < hi.square());
            let width = (hi - lo.clone()).over(lo);
            assert!(width < Wide::new(1.into(), num_bigint::BigInt::from(1) << 199));
        }
    }
}
