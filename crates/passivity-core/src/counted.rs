//! The extremes of the row of an interval between two encoder counts, in closed form (TH-COUNTS).
//!
//! The counts n₀ and n₀ + k leave ξ₀ = n₀ + x and ξ₁ = n₀ + k + y, x and y anywhere in [0, 1], so that the
//! displacement d = k + y − x is in [k − 1, k + 1]. Under a force F that is held, with the excess f = F + n₀ + ½ over
//! the force of the wall at the middle of the tick, what is generated against a linear wall on both sides and against
//! its quantized form is
//!
//! * E_gᴸ = d(f + ½(d − 1) + x) = a(k + y) − a(x) with a(u) = u(f + ½(u − 1)), which is convex;
//! * E_g = a(k) + (f + k)y − fx.
//!
//! Both are a function of y less one of x. Net energy, β′d² + σ|d| less that, is for each d extreme at the least or
//! at the largest x, or y, that d leaves: on each side of d = k along one parabola in d. Turning both directions
//! around (k, f and d change their signs, x becomes 1 − x and y becomes 1 − y) changes no net energy, so the text
//! below is of k ≥ 0, and of d ≥ 0 too: what of k = 0 goes back is what goes ahead under −f. So net energy is least,
//! and largest, where such a parabola turns or at a corner, where x and y are 0 or 1.

use crate::dissipation::Friction;
use crate::scalar::{Ordered, Scalar};

/// αd² in a parabola that turns where its slope is zero.
///
/// # Example
///
/// ```
/// use passivity_core::counted::Bend;
/// use passivity_core::{Fixed, Scalar};
///
/// assert_eq!(Bend::of(Fixed::integer(2)).turn, Fixed::new(1, 4));
/// assert_eq!(Bend::of(Fixed::zero()).turn, Fixed::zero());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Bend<S> {
    /// α.
    pub square: S,
    /// 1/2α; any number where α is zero.
    pub turn: S,
}

impl<S: Ordered> Bend<S> {
    /// With this α.
    #[inline(always)]
    #[must_use]
    pub fn of(square: S) -> Self {
        let twice = square.double();
        let turn = match is_zero(&square) {
            true => S::zero(),
            false => S::one().over(twice),
        };
        Self { square, turn }
    }
}

/// What friction takes over an interval of one length, βd²/Δτ + σ|d| (26), and what is made of it against a wall.
#[derive(Clone, Debug)]
pub struct Resistance<S> {
    /// σ.
    pub sigma: S,
    /// β/Δτ.
    pub own: Bend<S>,
    /// β/Δτ − ½.
    pub less: Bend<S>,
    /// β/Δτ + ½.
    pub more: Bend<S>,
}

impl<S: Scalar> Resistance<S> {
    /// What it takes over a distance |d|.
    #[inline(always)]
    #[must_use]
    pub fn taken(&self, distance: &S) -> S {
        distance.clone() * (self.own.square.clone() * distance.clone() + self.sigma.clone())
    }

    /// The same over a displacement d, less what a force does along it: of what stands still, nothing.
    #[inline(always)]
    fn net(&self, d: &S, force: &S) -> S {
        self.taken(&d.abs()) - d.clone() * force.clone()
    }
}

impl<S: Ordered> Resistance<S> {
    /// Of friction over an interval of Δτ = `dtau` > 0 sampling periods.
    #[inline(always)]
    #[must_use]
    pub fn new(friction: &Friction<S>, dtau: &S) -> Self {
        let viscous = friction.beta.clone().over(dtau.clone());
        let half = S::one().half();
        Self {
            sigma: friction.sigma.clone(),
            less: Bend::of(viscous.clone() - half.clone()),
            more: Bend::of(viscous.clone() + half),
            own: Bend::of(viscous),
        }
    }
}

/// An interval between two counts.
#[derive(Clone, Debug)]
pub struct Crossing<S> {
    /// k, the ticks from one count to the other.
    pub ticks: S,
    /// f, what is held beyond the force of the wall at the middle of the first tick, in KΔ.
    pub excess: S,
}

/// A part of a parabola: d(αd + γ) + κ, d between two ends.
#[derive(Clone, Debug)]
pub struct Arc<S> {
    /// α.
    pub bend: Bend<S>,
    /// γ.
    pub slope: S,
    /// κ.
    pub constant: S,
    /// Between which d is.
    pub ends: [S; 2],
}

impl<S: Scalar> Arc<S> {
    /// The value at d.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, d: &S) -> S {
        d.clone() * (self.bend.square.clone() * d.clone() + self.slope.clone())
            + self.constant.clone()
    }

    /// The value where the parabola turns, or at the end that is nearest to there; of a straight line, at any place.
    ///
    /// With the values at both ends it is the least and the largest one.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::counted::{Arc, Bend};
    /// use passivity_core::{Fixed, Scalar};
    ///
    /// // d² − d from 0 to 2 is least at ½.
    /// let (bend, slope) = (Bend::of(Fixed::one()), Fixed::integer(-1));
    /// let arc = Arc { bend, slope, constant: Fixed::zero(), ends: [Fixed::zero(), Fixed::integer(2)] };
    /// assert_eq!(arc.turn(), Fixed::new(-1, 4));
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn turn(&self) -> S {
        let [from, to] = &self.ends;
        self.at(&clamp(
            -(self.slope.clone() * self.bend.turn.clone()),
            from,
            to,
        ))
    }
}

/// An interval of k ≥ 0: what there is of it before and behind d = k, each as one of d ≥ 0.
struct Sides<S> {
    ticks: S,
    /// f, of the direction in which that part goes.
    excess: [S; 2],
    /// Between which ends |d| is.
    ends: [[S; 2]; 2],
    /// Whether both of them are of one direction: k > 0.
    one_way: bool,
}

impl<S: Scalar> Sides<S> {
    /// The parabolas before and behind d = k with these bends, slopes at zero but for the excess, and constants.
    #[inline(always)]
    fn arcs(self, [before, behind]: [(&Bend<S>, S, S); 2]) -> [Arc<S>; 2] {
        let ([short, long], [first, last]) = (self.excess, self.ends);
        [arc(before, short, first), arc(behind, long, last)]
    }
}

/// The parabola with this bend, slope at zero but for the excess, and constant.
#[inline(always)]
fn arc<S: Scalar>((bend, slope, constant): (&Bend<S>, S, S), excess: S, ends: [S; 2]) -> Arc<S> {
    Arc {
        bend: bend.clone(),
        slope: slope - excess,
        constant,
        ends,
    }
}

impl<S: Ordered> Crossing<S> {
    /// The shortest and the longest distance |d|: |k| − 1, if that is above zero, and |k| + 1.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::counted::Crossing;
    /// use passivity_core::{Fixed, Scalar};
    ///
    /// let back = Crossing { ticks: Fixed::integer(-2), excess: Fixed::zero() };
    /// assert_eq!(back.distances(), [Fixed::integer(1), Fixed::integer(3)]);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn distances(&self) -> [S; 2] {
        let ticks = self.ticks.abs();
        [(ticks.clone() - S::one()).max(S::zero()), ticks + S::one()]
    }

    /// Generated energy against the wall and against its quantized form, each at the least and at the most.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::counted::Crossing;
    /// use passivity_core::{Fixed, Scalar};
    ///
    /// // Under the wall's own force, one tick back.
    /// let back = Crossing { ticks: Fixed::integer(-1), excess: Fixed::zero() };
    /// let [_, quantized] = back.generated();
    /// assert_eq!(quantized, [Fixed::zero(), Fixed::one()]);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn generated(&self) -> [[S; 2]; 2] {
        let (zero, one, half) = (S::zero(), S::one(), S::one().half());
        let (k, f) = (&self.ticks, &self.excess);
        // The wall balances the force.
        let balance = half - f.clone();
        // a(k + 1) = a(k) + f + k, and a(1) = f.
        let (start, rise) = (self.energy(k), f.clone() + k.clone());
        let highest = start.clone() + rise.clone().max(zero.clone());
        let least = self.energy(&clamp(balance.clone(), k, &(k.clone() + one.clone())));
        let most = highest.clone() - self.energy(&clamp(balance, &zero, &one));
        let start_at_most = f.clone().max(zero.clone());
        [
            [least - start_at_most.clone(), most],
            [
                start + rise.min(zero.clone()) - start_at_most,
                highest - f.clone().min(zero),
            ],
        ]
    }

    /// The least net energy against the wall and against its quantized form.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::counted::{Crossing, Resistance};
    /// use passivity_core::{Fixed, Friction};
    ///
    /// // One tick back in one period, under the wall's own force.
    /// let friction = Friction::new(Fixed::new(3, 5), Fixed::new(3, 5));
    /// let friction = Resistance::new(&friction, &Fixed::new(1, 1));
    /// let back = Crossing::own(Fixed::new(-1, 1));
    /// assert_eq!(back.net_at_least(&friction), [Fixed::new(0, 1), Fixed::new(-1, 15)]);
    /// assert_eq!(back.net_at_most(&friction), [Fixed::new(13, 5), Fixed::new(13, 5)]);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn net_at_least(&self, friction: &Resistance<S>) -> [S; 2] {
        let ([least, _], [first, last]) = self.net_at_corners(friction);
        let corners = least.min(first).min(last);
        let ([a, b], [c, d]) = (self.least_linear(friction), self.least_quantized(friction));
        [
            corners.clone().min(a.turn()).min(b.turn()),
            corners.min(c.turn()).min(d.turn()),
        ]
    }

    /// The largest net energy against the wall and against its quantized form, which is not bent down: a corner has it.
    #[inline(always)]
    #[must_use]
    pub fn net_at_most(&self, friction: &Resistance<S>) -> [S; 2] {
        let ([_, most], [first, last]) = self.net_at_corners(friction);
        let corners = most.max(first).max(last);
        let [before, behind] = self.most_linear(friction);
        [
            corners.clone().max(before.turn()).max(behind.turn()),
            corners,
        ]
    }

    /// The least net energy against the wall that each displacement leaves, before and behind k: x is 1 before it, or
    /// −d where that goes back, and 1 + k − d behind it.
    #[inline(always)]
    #[must_use]
    pub fn least_linear(&self, friction: &Resistance<S>) -> [Arc<S>; 2] {
        let Resistance { less, more, .. } = friction;
        let sides = self.sides();
        let (slope, ticks) = (
            friction.sigma.clone() - S::one().half(),
            sides.ticks.clone(),
        );
        let bend = if sides.one_way { less } else { more };
        let behind = (more, slope.clone() - ticks, S::zero());
        sides.arcs([(bend, slope, S::zero()), behind])
    }

    /// The largest: x is k − d before it, or 1 where that goes back, and 0 behind it.
    #[inline(always)]
    #[must_use]
    pub fn most_linear(&self, friction: &Resistance<S>) -> [Arc<S>; 2] {
        let Resistance { less, more, .. } = friction;
        let sides = self.sides();
        let (slope, ticks) = (
            friction.sigma.clone() + S::one().half(),
            sides.ticks.clone(),
        );
        let bend = if sides.one_way { more } else { less };
        let before = (bend, slope.clone() - ticks, S::zero());
        sides.arcs([before, (less, slope, S::zero())])
    }

    /// The least net energy against the quantized wall: y is 1 + d − k before k and 1 behind it.
    #[inline(always)]
    #[must_use]
    pub fn least_quantized(&self, friction: &Resistance<S>) -> [Arc<S>; 2] {
        let Resistance { sigma, own, .. } = friction;
        let sides = self.sides();
        let (ticks, constant) = (sides.ticks.clone(), triangle(&sides.ticks));
        let before = (own, sigma.clone() - ticks.clone(), constant.clone());
        sides.arcs([before, (own, sigma.clone(), -(constant + ticks))])
    }

    #[inline(always)]
    fn sides(&self) -> Sides<S> {
        let ahead = match self.ticks.is_nonnegative() {
            Some(false) => -self.excess.clone(),
            _ => self.excess.clone(),
        };
        let ticks = self.ticks.abs();
        let one_way = !is_zero(&ticks);
        let back = match one_way {
            true => ahead.clone(),
            false => -ahead.clone(),
        };
        let from = (ticks.clone() - S::one()).max(S::zero());
        Sides {
            excess: [back, ahead],
            ends: [
                [from.clone(), from + S::one()],
                [ticks.clone(), ticks.clone() + S::one()],
            ],
            ticks,
            one_way,
        }
    }
}

impl<S: Scalar> Crossing<S> {
    /// Net energy where x and y are 0 or 1, against the wall and its quantized form alike: the least and the largest at
    /// d = k, and those at d = k − 1 and d = k + 1.
    #[inline(always)]
    #[must_use]
    pub fn net_at_corners(&self, friction: &Resistance<S>) -> ([S; 2], [S; 2]) {
        let (k, f, one) = (&self.ticks, &self.excess, S::one());
        let [before, after] = [k.clone() - one.clone(), k.clone() + one];
        let same = friction.net(k, &(f.clone() + before.clone().half()));
        let force = f.clone() + k.clone().half();
        (
            [
                same.clone() - k.clone().max(S::zero()),
                same - k.clone().min(S::zero()),
            ],
            [friction.net(&before, &force), friction.net(&after, &force)],
        )
    }

    /// a(u).
    #[inline(always)]
    fn energy(&self, u: &S) -> S {
        u.clone() * (self.excess.clone() + (u.clone() - S::one()).half())
    }

    /// Under the wall's own force.
    #[inline(always)]
    #[must_use]
    pub fn own(ticks: S) -> Self {
        Self {
            ticks,
            excess: S::zero(),
        }
    }

    /// The least and the most of ½ξ₁² − fy, the wall's potential where the interval ends, at count `end`, less what of
    /// the work of the excess is due to the place within the tick.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::counted::Crossing;
    /// use passivity_core::{Fixed, Scalar};
    ///
    /// // Under the wall's own force, in the tick from 1 on: from ½ to 2.
    /// let own = Crossing::own(Fixed::integer(3));
    /// assert_eq!(own.stored(&Fixed::integer(1)), [Fixed::new(1, 2), Fixed::integer(2)]);
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn stored(&self, end: &S) -> [S; 2] {
        let (zero, one) = (S::zero(), S::one());
        let slope = end.clone() - self.excess.clone();
        let base = end.square().half();
        let balance = clamp(-slope.clone(), &zero, &one);
        let beyond = balance.clone() * (slope.clone() + balance.half());
        [base.clone() + beyond, base + (slope + one.half()).max(zero)]
    }
}

/// ½k(k − 1).
#[inline(always)]
fn triangle<S: Scalar>(ticks: &S) -> S {
    (ticks.clone() * (ticks.clone() - S::one())).half()
}

#[inline(always)]
fn clamp<S: Scalar>(x: S, from: &S, to: &S) -> S {
    x.max(from.clone()).min(to.clone())
}

/// Whether a number is known to be zero.
#[inline(always)]
fn is_zero<S: Ordered>(x: &S) -> bool {
    x.sign() == Some(core::cmp::Ordering::Equal)
}
