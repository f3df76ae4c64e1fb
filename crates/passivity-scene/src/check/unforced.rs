//! The largest speed of an unforced motion from the scene's start (TH-START).

use std::cmp::Ordering;

use num_bigint::BigInt;
use passivity_core::verdict::Speeds;
use passivity_core::{
    BigRational, Effect, Enclosed, Exact, Interval, Loop, Ordered, Scalar, Truth, start,
};

use crate::scene::Scene;

/// What holds of the device when the hand lets go of it at the scene's start.
///
/// It is assumed that before its start the device had rested there for as long as the controller
/// remembers, so that delay and damping have stored nothing yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Unforced {
    /// Whether it never gets faster than `speed`, and generates no more than friction takes.
    pub holds: Truth,
    /// What is assumed of the controller's memory, in words; `None` where it has none.
    pub assumes: Option<&'static str>,
    /// V, ticks per sample.
    pub speed: Interval<BigRational>,
    /// V in SI units; `None` for a dimensionless scene.
    pub speed_si: Option<Interval<BigRational>>,
}

/// The bound V of TH-START in the units of the loop: V² = ẋ(0)² + (K/m)·H(1)·x(0)², H being 1 without a controller.
pub(super) struct StartSpeed<S> {
    /// The values of V²; exact.
    squared: Interval<S>,
    /// The values of V where nothing is stored at x(0), so that no root is needed.
    known: Option<Interval<S>>,
}

/// What TH-START assumes of the controller's memory, in words; `None` where it has none.
pub(super) fn assumes(scene: &Scene) -> Option<&'static str> {
    match [Effect::Delay, Effect::Damping].map(|effect| scene.has(effect)) {
        [true, true] => {
            Some("the device had rested there before, for as long as delay and damping look back")
        }
        [true, false] => {
            Some("the device had rested there before, for as long as the delay looks back")
        }
        [false, true] => {
            Some("the device had rested there before, for as long as the damping looks back")
        }
        [false, false] => None,
    }
}

impl<S: Enclosed> StartSpeed<S> {
    /// The bound of a scene with a start; `None` without one, or when the inertia is needed and not
    /// given.
    pub(super) fn of(scene: &Scene, bounds: &Loop<Interval<S>>) -> Option<Self> {
        if !scene.has_start() {
            return None;
        }
        let zero = || Interval::point(S::zero());
        let of = |range: &Option<Interval<S>>| magnitude(&range.clone().unwrap_or_else(zero));
        let velocity = of(&bounds.start_velocity);
        let position = of(&bounds.start_position);
        // A controller stores ½H(1)ξ² where the wall alone stores ½ξ²: with H(1) = 0 nothing, wherever the device is.
        let at_one = match &bounds.controller {
            Some(controller) => S::of(&Exact::of(&controller.at_one()))?,
            None => S::one(),
        };
        let stores = |x: &S| x.is_positive() != Some(false);
        if !stores(position.hi()) || !stores(&at_one) {
            return Some(Self {
                squared: velocity.map(Scalar::square),
                known: Some(velocity),
            });
        }
        let inertia = bounds.inertia.as_ref()?;
        let square =
            |v: &S, x: &S, k: &S, m: &S| start::speed_squared(&m.clone().over(k.clone()), x, v);
        let stiffness = bounds.stiffness.map(|k| k.clone() * at_one.clone());
        Some(Self {
            squared: Interval::hull(
                square(velocity.lo(), position.lo(), stiffness.lo(), inertia.hi()),
                square(velocity.hi(), position.hi(), stiffness.hi(), inertia.lo()),
            ),
            known: None,
        })
    }

    /// The speeds that the criterion has to hold at.
    pub(super) fn speeds(&self) -> Speeds<Interval<S>> {
        Speeds::UpToSquared(self.squared.clone())
    }

    /// An enclosure of V.
    pub(super) fn enclosure(&self, bits: u32) -> Option<Interval<BigRational>> {
        if let Some(known) = &self.known {
            let (lo, hi) = (known.lo().enclosed(bits)?, known.hi().enclosed(bits)?);
            return Some(Interval::hull(lo.lo().clone(), hi.hi().clone()));
        }
        let (lo, hi) = (
            self.squared.lo().enclosed(bits)?,
            self.squared.hi().enclosed(bits)?,
        );
        Some(Interval::hull(root(lo.lo(), false), root(hi.hi(), true)))
    }
}

/// Whether TH-START shows that a device left alone keeps to these speeds.
///
/// Of delay and damping it says so with the sum of their costs, which may be more than the loop really costs: where that
/// sum is too much and the criterion does not fail, it depends. Of a filter, a controller, a latency and an amplifier nothing
/// is proved, so it depends.
pub(super) fn holds<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    speeds: &Speeds<Interval<S>>,
) -> Option<Truth> {
    let by_sums = bounds.clone().reshaped(|_| ());
    let is_proved = bounds.controller.is_none()
        && bounds.damping_time_constant.is_none()
        && !bounds.has_actuator();
    if !is_proved {
        return Some(Truth::Depends);
    }
    match by_sums.decide(speeds)? {
        Truth::Fails if bounds.decide(speeds)? != Truth::Fails => Some(Truth::Depends),
        found => Some(found),
    }
}

/// The magnitudes of the numbers of an interval.
fn magnitude<S: Ordered>(range: &Interval<S>) -> Interval<S> {
    let ends = Interval::hull(range.lo().abs(), range.hi().abs());
    match (range.lo().sign(), range.hi().sign()) {
        (Some(Ordering::Less), Some(Ordering::Greater)) => {
            Interval::hull(S::zero(), ends.hi().clone())
        }
        _ => ends,
    }
}

/// A rational root of x ≥ 0, off by less than 2⁻²⁰⁰ of its size: rounded down, or up; exact for
/// the square of a rational.
fn root(x: &BigRational, up: bool) -> BigRational {
    const BITS: u32 = 200;
    let (n, d) = (x.numer(), x.denom());
    let (root_n, root_d) = (n.sqrt(), d.sqrt());
    if &root_n * &root_n == *n && &root_d * &root_d == *d {
        return BigRational::new(root_n, root_d);
    }
    // √(n/d) = √(n·d)/d, and the whole number n·d is at least 1: these bits are all past its point.
    let whole = ((n * d) << (2 * BITS)).sqrt();
    let whole = if up { whole + BigInt::from(1) } else { whole };
    BigRational::new(whole, d << BITS)
}

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
            let width = (&hi - &lo) / lo;
            assert!(width < BigRational::new(1.into(), BigInt::from(1) << 199));
        }
    }
}
