//! The motion that is ahead of every motion of a part of the parameters (TH-IDENT).
//!
//! A device with inertia m, viscous friction b and Coulomb friction c under a held force u moves with
//! v′ ∈ u·r − p·v − q·Sgn(v), where r = 1/m, p = b/m, q = c/m and Sgn(0) = [−1, 1]: the speed follows an equation
//! of its own, of one dimension, whose right side never rises with v as p, q ≥ 0. Let S(v) be its largest
//! value over the parameters of the part with p, q ≥ 0; S never rises with v either.
//!
//! *Comparison.* Let v move with parameters of the part, and w with w′ = S(w), v(0) ≤ w(0). Then v(t) ≤ w(t)
//! for all t, through stops and reversals. For suppose v > w after a last time s with v(s) = w(s); from then
//! on v′ ≤ S(v) ≤ S(w) = w′ at almost every time, so v − w does not rise from its 0 at s: a contradiction. The
//! ways follow: where w has come to is ahead of where v has. What is more, w may be replaced by anything
//! ahead of it at the end of each interval: so whatever is rounded is rounded up. The motion *behind* every
//! motion of the part is the mirror image of the one ahead under −u.
//!
//! *One interval, w of one sign.* F(w), the largest value of the right side over the *corners* of the part, is
//! not below S: the right side is linear in the parameters. As S does not rise, w stays below
//! w(0) + h·max(F(w(0)), 0). F is the largest of some linear functions of w, so it is convex and, on an
//! interval R, below every line that is above it at both ends of R. Take a line a − λw of any slope λ ≥ 0
//! that is so on R between w(0) and w(0) + h·F(w(0)). Then y with y′ = a − λy, y(0) = w(0), is ahead of w: where
//! they met, y would be in R (it starts with a slope of at least F(w(0)), which shrinks; and w is never
//! above R), so that there w′ ≤ y′. With λ near p this is as good as the part is small, and for one point it
//! is the motion itself, to rounding.

use crate::directed::{add, add_down, mul, mul_down};
use crate::kept::{Duration, Propagators, propagator};
use crate::log::Log;
use crate::propagator::{Propagator, range};
use crate::region::Corner;
use crate::stop::{NOWHERE, Reached, Stop, WITHOUT_BOUND, after};

/// Parameters of which motions are looked at, by the corners of what they lie in.
#[derive(Clone, Debug)]
pub(crate) struct Bundle {
    /// p, q and r of each corner, nearly.
    corners: Vec<[f64; 3]>,
    /// How far off u·r − p·v − q·sgn(v) may be, as computed: of p·v, of q and of u·r.
    errors: [f64; 3],
    /// λ: near the middle of p.
    slope: f64,
}

impl Bundle {
    pub(crate) fn new(corners: Vec<Corner>) -> Self {
        /// Bits that λ keeps, so that many bundles share one: it need not be exact.
        const BITS: u32 = 12;
        let mut bundle = Self::of(&corners);
        bundle.slope = f64::from_bits(bundle.slope.to_bits() >> (52 - BITS) << (52 - BITS));
        bundle
    }

    /// The motion at one place.
    pub(crate) fn point(at: [f64; 3]) -> Self {
        Self::of(&[Corner::at(at)])
    }

    fn of(corners: &[Corner]) -> Self {
        /// Two products and two sums are each off by half an ε of what they are of: together by less than
        /// 3ε of the three terms. The rest is for the rounding of the errors themselves.
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        let all = |pick: fn(&Corner) -> [f64; 2]| {
            let ends = corners.iter().map(pick);
            ends.fold([0.0_f64; 2], |[most, wide], [lo, hi]| {
                [most.max(lo.abs()).max(hi.abs()), wide.max(add(hi, -lo))]
            })
        };
        let picks: [fn(&Corner) -> [f64; 2]; 3] = [|c| c.viscous, |c| c.coulomb, |c| c.mobility];
        let ends = corners.iter().map(|corner| corner.viscous);
        let [least, most] = ends.fold([f64::INFINITY, 0.0], |[least, most], [lo, hi]| {
            [f64::min(least, lo), f64::max(most, hi)]
        });
        let slope = 0.5 * least.max(0.0) + 0.5 * most;
        Self {
            corners: corners
                .iter()
                .map(|corner| picks.map(|pick| pick(corner)[0]))
                .collect(),
            errors: picks.map(|pick| {
                let [most, wide] = all(pick);
                add(mul(ROUNDING, most), mul(1.0 + ROUNDING, wide)) + f64::MIN_POSITIVE
            }),
            slope: if slope.is_finite() { slope } else { 0.0 },
        }
    }

    /// F(v) where friction acts against a motion `forwards` or not, at the most. Not finite where numbers are
    /// too large.
    fn most(&self, force: f64, v: f64, forwards: bool) -> f64 {
        let sign = if forwards { 1.0 } else { -1.0 };
        let of_corner = |[p, q, r]: &[f64; 3]| force * r - sign * q - p * v;
        let all = self.corners.iter().map(of_corner);
        let most = all.fold(f64::NEG_INFINITY, f64::max);
        let [p, q, r] = self.errors;
        // Twice the error: its own sum is rounded too.
        let error = 2.0 * (p * v.abs() + q + r * force.abs());
        // A corner whose value is no number would be passed over: then so is the error.
        match error.is_finite() {
            true => add(most, error),
            false => f64::INFINITY,
        }
    }
}

/// The motion ahead of every motion of a bundle.
pub(crate) struct Ahead<'a> {
    bundle: &'a Bundle,
    velocity: f64,
    way: f64,
}

impl<'a> Ahead<'a> {
    /// At rest.
    pub(crate) const fn new(bundle: &'a Bundle) -> Self {
        Self {
            bundle,
            velocity: 0.0,
            way: 0.0,
        }
    }

    /// The way so far, at the most.
    pub(crate) const fn way(&self) -> f64 {
        self.way
    }

    /// Moves on for an interval under a force of at most `force`.
    fn advance(&mut self, force: f64, duration: &Duration, kept: &mut Vec<Option<Propagator>>) {
        let v = self.velocity;
        let reached = match v {
            _ if !v.is_finite() => WITHOUT_BOUND,
            _ if v > 0.0 => self.forwards(v, force, duration, kept),
            _ if v < 0.0 => self.backwards(v, force, duration, kept),
            _ => self.leave_rest(force, duration, kept),
        };
        self.velocity = reached.velocity;
        self.way = add(self.way, reached.way);
    }

    /// From rest: ahead where the force overcomes friction for some parameters, back where it does for
    /// all.
    fn leave_rest(
        &self,
        force: f64,
        duration: &Duration,
        kept: &mut Vec<Option<Propagator>>,
    ) -> Reached {
        if self.bundle.most(force, 0.0, false) < 0.0 {
            return self.backwards(0.0, force, duration, kept);
        }
        match self.bundle.most(force, 0.0, true) <= 0.0 {
            true => NOWHERE,
            false => self.forwards(0.0, force, duration, kept),
        }
    }

    /// a of a line a − λv that is above F at v, where it is `steep`, and at the other end of a stretch of
    /// speeds.
    fn line(&self, force: f64, [v, steep]: [f64; 2], other: f64, forwards: bool) -> f64 {
        let slope = self.bundle.slope;
        let here = add(steep, mul(slope, v));
        if other == v {
            return here;
        }
        let there = add(self.bundle.most(force, other, forwards), mul(slope, other));
        if here.is_nan() || there.is_nan() {
            f64::NAN
        } else {
            here.max(there)
        }
    }

    /// v ≥ 0.
    fn forwards(
        &self,
        v: f64,
        force: f64,
        duration: &Duration,
        kept: &mut Vec<Option<Propagator>>,
    ) -> Reached {
        let slope = self.bundle.slope;
        let steep = self.bundle.most(force, v, true);
        let highest = add(v, mul(steep.max(0.0), duration.hi));
        let lowest = add_down(v, mul_down(steep.min(0.0), duration.hi));
        let may_stop = lowest <= 0.0 && v > 0.0 && self.bundle.most(force, 0.0, true) < 0.0;
        let other = if steep > 0.0 {
            highest
        } else {
            lowest.max(0.0)
        };
        let a = self.line(force, [v, steep], other, true);
        let over = propagator(kept, slope, duration);
        let there = after(v, a, &over);
        if !steep.is_finite() || !a.is_finite() || !there.velocity.is_finite() {
            return WITHOUT_BOUND;
        }
        let bounded = Reached {
            // Ahead of all that is still moving; and what has stopped is not below.
            velocity: there.velocity.min(highest).max(0.0),
            way: there.way,
        };
        let least = add_down(mul_down(over.decay[0], v), mul_down(over.first[1], a));
        if !may_stop || a >= 0.0 || least > 0.0 {
            return bounded;
        }
        let stop = Stop::find(v, a, slope, duration);
        // On [earliest, latest] the speed only falls.
        let on = Propagator::new(&range(slope, slope), &range(stop.earliest, stop.earliest));
        let until = after(v, a, &on);
        let latest = stop.latest.unwrap_or(duration.hi);
        let more = mul(until.velocity.max(0.0), add(latest, -stop.earliest));
        let way = add(until.way, more);
        if stop.latest.is_none() {
            let velocity = bounded.velocity;
            return Reached { velocity, way };
        }
        let left = add_down(duration.lo, -latest);
        if left <= 0.0 || self.bundle.most(force, 0.0, false) >= 0.0 {
            return Reached { velocity: 0.0, way };
        }
        let back = self.backwards(0.0, force, &rest_of(left), kept);
        Reached {
            velocity: back.velocity,
            way: add(way, back.way),
        }
    }

    /// v ≤ 0; from rest only where the force overcomes the friction of all.
    fn backwards(
        &self,
        v: f64,
        force: f64,
        duration: &Duration,
        kept: &mut Vec<Option<Propagator>>,
    ) -> Reached {
        let slope = self.bundle.slope;
        let steep = self.bundle.most(force, v, false);
        let highest = add(v, mul(steep.max(0.0), duration.hi));
        let lowest = add_down(v, mul_down(steep.min(0.0), duration.hi));
        let other = if steep > 0.0 {
            highest.min(0.0)
        } else {
            lowest
        };
        let a = self.line(force, [v, steep], other, false);
        let over = propagator(kept, slope, duration);
        let there = after(v, a, &over);
        if !steep.is_finite() || !a.is_finite() || !there.velocity.is_finite() {
            return WITHOUT_BOUND;
        }
        let may_stop = highest >= 0.0 && self.bundle.most(force, 0.0, false) > 0.0;
        if there.velocity < 0.0 || !may_stop || a <= 0.0 {
            return Reached {
                velocity: there.velocity.min(highest).min(0.0),
                // A way back is not above zero, whatever rounding says.
                way: there.way.min(0.0),
            };
        }
        let stop = Stop::find(v, a, slope, duration);
        let on = Propagator::new(&range(slope, slope), &range(stop.earliest, stop.earliest));
        let way = after(v, a, &on).way.min(0.0);
        let left = add(duration.hi, -stop.earliest);
        if left <= 0.0 || self.bundle.most(force, 0.0, true) <= 0.0 {
            return Reached { velocity: 0.0, way };
        }
        let ahead = self.forwards(0.0, force, &rest_of(left), kept);
        Reached {
            velocity: ahead.velocity,
            way: add(way, ahead.way),
        }
    }
}

/// The rest of an interval.
const fn rest_of(left: f64) -> Duration {
    Duration {
        lo: left,
        hi: left,
        index: usize::MAX,
    }
}

/// Leads the motions ahead of and behind a bundle through a log. `each` is given, after each interval, how
/// far the one has come forwards and how far the other has come back, both at the most; while it says so,
/// the motion goes on.
pub(crate) fn lead(
    log: &Log,
    bundle: &Bundle,
    propagators: &mut Propagators,
    mut each: impl FnMut([f64; 2]) -> bool,
) {
    let kept = propagators.of_slope(bundle.slope);
    let (mut ahead, mut behind) = (Ahead::new(bundle), Ahead::new(bundle));
    for ([least, most], duration) in log.intervals() {
        ahead.advance(*most, duration, kept);
        // The mirror image: what is behind all is ahead of all under the opposite force.
        behind.advance(-least, duration, kept);
        if !each([ahead.way(), behind.way()]) {
            return;
        }
    }
}

/// The way that a device with these parameters has gone at each sample of a log, in ticks, as the encoder sees it.
pub(crate) fn simulated(log: &Log, at: [f64; 3], propagators: &mut Propagators) -> Vec<f64> {
    let bundle = Bundle::point(at);
    let kept = propagators.of_slope(bundle.slope);
    let mut motion = Ahead {
        velocity: log.guess.velocity,
        ..Ahead::new(&bundle)
    };
    let after = log.intervals().map(|([lo, hi], duration)| {
        motion.advance(0.5 * lo + 0.5 * hi, duration, kept);
        motion.way()
    });
    let ways = std::iter::once(0.0).chain(after).collect();
    log.guess.seen(ways)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::Guess;
    use crate::region::Shear;
    use passivity_random::Random;

    fn log(random: &mut Random) -> Log {
        let intervals = 120;
        let force = |random: &mut Random| random.between(-4.0, 4.0);
        let mut held = force(random);
        let mut log = Log {
            positions: vec![[0.0; 2]; intervals + 1],
            forces: Vec::new(),
            durations: Vec::new(),
            guess: Guess::default(),
        };
        for row in 0..=intervals {
            if row % 7 == 0 {
                held = force(random) * if random.below(3) == 0 { 0.0 } else { 1.0 };
            }
            log.forces.push([held, held]);
            let index = row % 3;
            let h = [1.0, 0.7, 1.9][index];
            log.durations.push(Duration {
                lo: h,
                hi: h,
                index,
            });
        }
        log.durations.truncate(intervals);
        log
    }

    /// TH-IDENT: through stops and reversals, and for sheared parts as well.
    #[test]
    fn every_motion_of_a_part_is_between_the_one_ahead_and_the_one_behind() {
        let mut random = Random::new(11);
        for _ in 0..150 {
            let log = log(&mut random);
            let mut ends = |lo: f64, hi: f64, wide: f64| {
                let least = random.between(lo, hi);
                [least, least + random.between(0.0, wide)]
            };
            let all = Corner {
                viscous: ends(0.0, 0.1, 0.05),
                coulomb: ends(0.0, 0.3, 0.2),
                mobility: ends(0.05, 0.4, 0.1),
            };
            let shear = Shear {
                viscous_in_coulomb: random.between(-2.0, 2.0),
                mobility_in_coulomb: random.between(-1.0, 1.0),
                mobility_in_viscous: random.between(-0.5, 0.5),
            };
            let bundle = Bundle::new(shear.corners(&shear.around(&all)));
            let mut bounds = Vec::new();
            lead(&log, &bundle, &mut Propagators::default(), |ways| {
                bounds.push(ways);
                true
            });
            for _ in 0..6 {
                let mut within = |[lo, hi]: [f64; 2]| random.between(lo, hi);
                let (p, q, r) = (
                    within(all.viscous),
                    within(all.coulomb),
                    within(all.mobility),
                );
                let at = [p / r, q / r, 1.0 / r];
                let ways = simulated(&log, at, &mut Propagators::default());
                for ([ahead, behind], way) in bounds.iter().zip(&ways[1..]) {
                    // What `simulated` itself is rounded by.
                    let slack = 1e-9 * (1.0 + way.abs());
                    assert!(-behind - slack <= *way && *way <= ahead + slack);
                }
            }
        }
    }

    #[test]
    fn a_stop_is_found_to_rounding_and_friction_holds_a_device_at_rest() {
        // From 9 ticks per period, 1 of deceleration: 9²/2 ticks in 9 periods; then 0.5 does not move it.
        let durations = (0..20)
            .map(|_| Duration {
                lo: 1.0,
                hi: 1.0,
                index: 0,
            })
            .collect();
        let forces = (0..21).map(|row| {
            if row == 0 {
                [10.0; 2]
            } else {
                [0.5 * f64::from(row > 12); 2]
            }
        });
        let log = Log {
            positions: vec![[0.0; 2]; 21],
            forces: forces.collect(),
            durations,
            guess: Guess::default(),
        };
        let ways = simulated(&log, [0.0, 1.0, 1.0], &mut Propagators::default());
        assert!(
            (ways[1] - 4.5).abs() < 1e-12 && (ways[20] - 45.0).abs() < 1e-9,
            "{ways:?}"
        );
        assert_eq!(ways[11], ways[20]);
    }
}
