//! Where the values of a parameter that pass end, where no formula says it: by factors of two, then by
//! halves.

use num_bigint::BigInt;
use passivity_core::parameter::Values;
use passivity_core::verdict::{End, Speeds};
use passivity_core::{BigRational, Enclosed, Exact, Interval, Loop, Parameter, Truth, stiffness};

use super::{Ends, Side};

/// How often a value is doubled, or halved, to find one with another answer.
pub(super) const DOUBLINGS: u32 = 40;

/// The same for an end of the values that pass where these are one stretch, of which the farthest tells whether there is one.
const FAR: u32 = 120;

/// How often the way to a border is halved, how often where cells tell, and how often where each step
/// is a stretch of values.
pub(super) const STEPS: u32 = 32;
const COARSE_STEPS: u32 = 20;
const STRETCH_STEPS: u32 = 12;

/// How often a stretch is gone on with from its end, beyond which a value passes: of a shorter one cells
/// tell more.
const MOST_ROUNDS: usize = 6;

/// The ends of the values that pass of a parameter that is in the scene: around what it is, or, where
/// that fails, around the first that passes by factors of two.
///
/// `None` where no value from 2⁻⁴⁰ to 2⁴⁰ times what it is changes the answer; from 2⁻¹²⁰ to 2¹²⁰ times where the values that
/// pass are one stretch.
pub(super) fn searched<S: Enclosed>(
    parameter: Parameter,
    side: Side,
    bounds: &Loop<Interval<S>>,
    speeds: &Speeds<Interval<S>>,
) -> Option<Ends<S>> {
    // Not from the lower end, which may be zero.
    let from = bounds.get(parameter)?.hi();
    let search = Search {
        parameter,
        bounds,
        speeds,
    };
    let of = |side: Side, from: &S| {
        let both_ways = search.pulls_both_ways();
        let ends = [side, side.other()].map(|end| match both_ways || end == side {
            true => search.end(end, from),
            false => None,
        });
        let (side, border, far) = match ends {
            [Some(border), far] => (side, border, far),
            [None, Some(border)] => (side.other(), border, None),
            [None, None] => return None,
        };
        Some(Ends { side, border, far })
    };
    if search.passes(from) {
        return of(side, from);
    }
    // What has to be more is to be at least so much.
    [side, side.other()].into_iter().find_map(|near| {
        let mut further = away(from, near == Side::AtLeast).take(DOUBLINGS as usize);
        of(near, &further.find(|x| search.passes(x))?)
    })
}

/// A number doubled again and again, or halved.
fn away<S: Enclosed>(from: &S, grows: bool) -> impl Iterator<Item = S> {
    (1..).map_while(move |steps: u32| {
        let power = BigRational::from_integer(BigInt::from(1) << steps);
        let factor = S::of(&Exact::of(&power))?;
        Some(match grows {
            true => from.clone() * factor,
            false => from.clone().over(factor),
        })
    })
}

struct Search<'a, S> {
    parameter: Parameter,
    bounds: &'a Loop<Interval<S>>,
    speeds: &'a Speeds<Interval<S>>,
}

impl<S: Enclosed> Search<'_, S> {
    fn passes(&self, x: &S) -> bool {
        self.all_pass(Interval::point(x.clone()))
    }

    fn all_pass(&self, values: Interval<S>) -> bool {
        let moved = self.bounds.clone().with(self.parameter, values);
        moved.surely_holds(self.speeds)
    }

    /// Whether the filter on the damping shapes what a linear loop costs beside its delay.
    const fn is_bent(&self) -> bool {
        let bounds = self.bounds;
        bounds.damping_time_constant.is_some()
            && bounds.delay > 0
            && bounds.is_linear()
            && !bounds.has_actuator()
    }

    /// Whether a value may fail for being too small, and another for being too large: with a delay
    /// damping is needed as well as paid for, and a short period costs BΔ/T.
    fn pulls_both_ways(&self) -> bool {
        let bounds = self.bounds;
        let is_late = bounds.delay > 0 && bounds.is_linear() && !bounds.has_actuator();
        match self.parameter {
            Parameter::Damping => is_late,
            Parameter::Stiffness | Parameter::DampingTimeConstant => self.is_bent(),
            Parameter::Period => {
                let damping = bounds.damping.as_ref();
                let is_damped = damping.is_some_and(|b| b.hi().is_positive() == Some(true));
                is_damped && (bounds.has_encoder() || self.is_bent())
            }
            _ => false,
        }
    }

    /// Whether all values between two that pass do: the margin is a concave function of K and of B,
    /// and of T where nothing filters the damping or the force; and what else costs viscous or Coulomb
    /// friction grows or falls with T and τ, so that at every speed they pass from an end to another.
    const fn is_one_stretch(&self) -> bool {
        let is_plain = self.bounds.damping_time_constant.is_none() && !self.bounds.has_actuator();
        match self.parameter {
            Parameter::Period => {
                is_plain || (!self.is_bent() && matches!(self.speeds, Speeds::All))
            }
            Parameter::DampingTimeConstant => !self.is_bent(),
            _ => true,
        }
    }

    /// The end of the values that pass on one side of one that does, bracketed; `None` where there is
    /// none within as many factors of two, nor at zero. Where they may be several stretches, every value up
    /// to it is shown to pass.
    fn end(&self, end: Side, from: &S) -> Option<Interval<S>> {
        let grows = end == Side::AtMost;
        let is_one_stretch = self.is_one_stretch();
        let most = if is_one_stretch { FAR } else { DOUBLINGS };
        let mut further: Vec<S> = away(from, grows).take(most as usize).collect();
        if !grows && self.parameter.row().values != Values::Positive {
            further.push(S::zero());
        }
        let all_pass = |before: &S, x: &S| match is_one_stretch {
            true => self.passes(x),
            false => self.all_pass(Interval::hull(before.clone(), x.clone())),
        };
        if is_one_stretch && self.passes(further.last()?) {
            return None;
        }
        // Cells tell to some millionths, and take the longer the closer it is.
        let in_cells = self.bounds.has_actuator() || self.bounds.damping_time_constant.is_some();
        let steps = match is_one_stretch {
            false => STRETCH_STEPS,
            true if in_cells && has_range(self.parameter, self.bounds) => COARSE_STEPS,
            true => STEPS,
        };
        let mut before = from.clone();
        let mut further = further.iter();
        loop {
            let after = further.find(|x| {
                let passes = all_pass(&before, x);
                if passes {
                    before = (*x).clone();
                }
                !passes
            })?;
            let mut found = None;
            for _ in 0..MOST_ROUNDS {
                let border = bisected(before.clone(), after, steps, |x| all_pass(&before, x))?;
                let beyond = end.other().hardest(&border);
                let is_told = is_one_stretch || !self.passes(beyond);
                before = end.hardest(&border).clone();
                found = Some(border);
                if is_told {
                    return found;
                }
            }
            // Of the whole stretch up to there cells did not tell it: what is left of it is short.
            if !(self.passes(after) && all_pass(&before, after)) {
                return found;
            }
            before = after.clone();
        }
    }
}

/// Whether a parameter other than one has a tolerance.
fn has_range<S: Enclosed>(moved: Parameter, bounds: &Loop<Interval<S>>) -> bool {
    let is_other = |of: Parameter| of != moved && !of.row().key.is_empty();
    let mut given = bounds.given();
    given.any(|(of, range)| is_other(of) && !range.is_point())
}

/// The border between a value that passes and one that fails, bracketed to 2^−`steps` of the way.
pub(super) fn bisected<S: Enclosed>(
    passing: S,
    failing: &S,
    steps: u32,
    passes: impl Fn(&S) -> bool,
) -> Option<Interval<S>> {
    let width = failing.clone() - passing.clone();
    // Each from the ends again, so that the numbers stay short.
    let at = |k: u64| {
        let share = BigRational::new(k.into(), (1_u64 << steps).into());
        Some(passing.clone() + width.clone() * S::of(&Exact::of(&share))?)
    };
    let mut k = 0;
    for step in (0..steps).rev() {
        let further = k + (1 << step);
        if passes(&at(further)?) {
            k = further;
        }
    }
    Some(Interval::hull(at(k)?, at(k + 1)?))
}

/// The longest and the shortest period where a shorter one costs Coulomb friction as well, bracketed.
///
/// The periods that pass are an interval, because the margin is concave in the period. It starts at
/// or before the shortest period near rest and the period of the largest margin, whichever is
/// longer, and ends before the longest that viscous friction allows without BΔ/T.
pub(super) fn longest_period<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    speeds: &Speeds<Interval<S>>,
) -> Option<Ends<S>> {
    let corner = bounds.at(End::Hardest);
    let near_rest = stiffness::shortest_period(&corner)?;
    let passes = |period: &S| {
        let at = Interval::point(period.clone());
        bounds.clone().with(Parameter::Period, at).decide(speeds) == Some(Truth::Holds)
    };
    let border = match speeds.at(End::Hardest) {
        Speeds::All => {
            let longest = stiffness::longest_period(&corner);
            passes(&longest).then(|| Interval::point(longest))?
        }
        Speeds::UpTo(v) => {
            // Without damping behind the encoder, but with what damping costs of viscous friction.
            let damping = corner.damping.clone()?;
            let less = corner.viscous_friction() - damping;
            let undamped = Loop {
                damping: None,
                viscous: Some(less),
                ..corner.clone().with(Parameter::Period, S::one())
            };
            let longest = stiffness::longest_period_at_speed(&undamped, &v);
            let passing = longest.clone().half().max(near_rest.clone());
            let passing = passes(&passing).then_some(passing)?;
            bisected(passing, &longest, STEPS, passes)?
        }
        Speeds::UpToSquared(_) => return None,
    };
    // The scene's own period is the nearer one, where it passes.
    let own = bounds.get(Parameter::Period).map(|own| own.lo().clone());
    let from = own.filter(|own| passes(own));
    let from = from.unwrap_or_else(|| border.lo().clone());
    let far = match near_rest.is_positive() {
        Some(true) if passes(&near_rest) => Some(Interval::point(near_rest)),
        Some(true) => bisected(from, &near_rest, STEPS, passes),
        _ => None,
    };
    Some(Ends {
        side: Side::AtMost,
        border,
        far,
    })
}
