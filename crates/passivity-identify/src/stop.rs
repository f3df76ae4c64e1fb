//! Where the linear motion v′ = a − λv leads over a time, at the most, and when it comes to a stop.

use crate::directed::{add, mul};
use crate::kept::Duration;
use crate::propagator::{Propagator, range};

/// A speed and a way, both at the most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reached {
    pub(crate) velocity: f64,
    pub(crate) way: f64,
}

pub(crate) const NOWHERE: Reached = Reached {
    velocity: 0.0,
    way: 0.0,
};

/// Where numbers are too large to tell.
pub(crate) const WITHOUT_BOUND: Reached = Reached {
    velocity: f64::INFINITY,
    way: f64::INFINITY,
};

/// Where v′ = a − λv leads from v, at the most.
pub(crate) fn after(v: f64, a: f64, over: &Propagator) -> Reached {
    let most = |[lo, hi]: [f64; 2], x: f64| mul(if x > 0.0 { hi } else { lo }, x);
    Reached {
        velocity: add(most(over.decay, v), most(over.first, a)),
        way: add(most(over.first, v), most(over.second, a)),
    }
}

/// When a speed comes to its stop: surely not before the one time, and surely by the other, where that is
/// known to be within the interval.
pub(crate) struct Stop {
    pub(crate) earliest: f64,
    pub(crate) latest: Option<f64>,
}

impl Stop {
    /// Of v′ = a − λv with v and a of opposite signs, within an interval.
    ///
    /// The time comes from the library's logarithm, which is not trusted: that v has not changed its sign
    /// shortly before and has shortly after is shown by enclosures.
    pub(crate) fn find(v: f64, a: f64, slope: f64, duration: &Duration) -> Self {
        /// How far off the time is looked at.
        const ASIDE: f64 = 1e-12;
        let most = duration.hi;
        let ratio = -v / a;
        let w = slope * ratio;
        let stretch = if w > 1e-9 {
            w.ln_1p() / w
        } else {
            1.0 - 0.5 * w
        };
        let near = ratio * stretch;
        let speed = |time: f64| {
            let at = Propagator::new(&range(slope, slope), &range(time, time));
            let (up, down) = (after(v, a, &at), after(-v, -a, &at));
            // The least and the most of v, turned so that it starts above zero.
            if v > 0.0 {
                [-down.velocity, up.velocity]
            } else {
                [-up.velocity, down.velocity]
            }
        };
        let (early, late) = (near * (1.0 - ASIDE), near * (1.0 + ASIDE));
        let earliest = match early.is_finite() && early > 0.0 && speed(early.min(most))[0] >= 0.0 {
            true => early.min(most),
            false => 0.0,
        };
        let is_over = late.is_finite() && late < duration.lo && speed(late)[1] <= 0.0;
        Self {
            earliest,
            latest: is_over.then_some(late),
        }
    }
}
