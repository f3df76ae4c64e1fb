//! Limits of the parameters: where the criterion is met with equality, one parameter at a time
//! (CHECK-LIMITS).

use std::cmp::Ordering;
use std::iter;

use num_traits::Signed as _;
use passivity_core::parameter::Hurts;
use passivity_core::verdict::{End, Speeds};
use passivity_core::{BigRational, Enclosed, Exact, Interval, Loop, Parameter, Truth, stiffness};
use schemars::JsonSchema;
use serde::Serialize;

use self::search::{DOUBLINGS, STEPS, bisected, longest_period, searched};
use super::figure;
use super::text::unit_of;
use crate::display::Rounding;
use crate::scene::Scene;
use crate::written::{Form, Written};

/// On which side of a limit the criterion holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// At the limit and above it: friction.
    AtLeast,
    /// At the limit and below it: stiffness, sampling period, encoder resolution.
    AtMost,
}

impl Side {
    pub(super) const fn other(self) -> Self {
        match self {
            Self::AtLeast => Self::AtMost,
            Self::AtMost => Self::AtLeast,
        }
    }

    pub(super) const fn rounding(self) -> Rounding {
        match self {
            Self::AtLeast => Rounding::Up,
            Self::AtMost => Rounding::Down,
        }
    }

    /// The end of a border that is safe over all tolerances.
    pub(super) const fn hardest<T>(self, border: &Interval<T>) -> &T {
        match self {
            Self::AtLeast => border.hi(),
            Self::AtMost => border.lo(),
        }
    }
}

/// Where the values of a parameter that pass end, on one side of it or on both.
#[derive(Clone, Debug)]
pub(super) struct Ends<S> {
    /// On which side of `border` the criterion holds.
    pub(super) side: Side,
    pub(super) border: Interval<S>,
    /// The end on the other side, where there is one or where it is not shown that there is none.
    pub(super) far: Option<Interval<S>>,
}

/// The limit of one parameter, all others as they are: what to change, and by how much.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The parameter.
    pub parameter: Parameter,
    /// What it is now.
    pub now: Interval<BigRational>,
    /// Where the criterion is met with equality, over the tolerances of the others, at the speeds
    /// that the limits are for. A limit that no formula says is a bracket of its hardest end.
    pub border: Interval<BigRational>,
    /// On which side of the border the criterion holds.
    pub side: Side,
    /// Whether the parameter alone, moved to the hardest end of `border`, is enough.
    pub suffices: bool,
    /// The hardest end of `border` in SI with five digits or a few more, rounded to the side on
    /// which the criterion holds: typed into the scene, it passes. `None` where the parameter alone
    /// is not enough.
    pub printed: Option<String>,
    /// How the scene file writes the parameter.
    pub written: Written,
    /// The same as `printed` in the form and unit of the scene file, without the unit.
    pub typed: Option<String>,
    /// Where the values that pass end on the other side, beyond `border`; `None` where they do not.
    pub far: Option<FarEnd>,
}

/// The other end of the values that pass.
#[derive(Clone, Debug, PartialEq)]
pub struct FarEnd {
    /// A bracket of it.
    pub border: Interval<BigRational>,
    /// What is printed of it, as of a [`Limit`].
    pub printed: Option<String>,
    /// The same in the form and unit of the scene file, without the unit.
    pub typed: Option<String>,
}

impl Limit {
    /// The end of the border that is safe over all tolerances.
    #[must_use]
    pub const fn hardest(&self) -> &BigRational {
        self.side.hardest(&self.border)
    }

    /// Where the values that pass end on one side; `None` where they do not.
    #[must_use]
    pub fn end(&self, side: Side) -> Option<&Interval<BigRational>> {
        match &self.far {
            _ if self.side == side => Some(&self.border),
            far => far.as_ref().map(|far| &far.border),
        }
    }
}

/// The parameters that limits are computed of.
const LIMITED: [Parameter; 9] = [
    Parameter::Viscous,
    Parameter::Coulomb,
    Parameter::Stiffness,
    Parameter::Period,
    Parameter::Resolution,
    Parameter::Damping,
    Parameter::DampingTimeConstant,
    Parameter::Latency,
    Parameter::TimeConstant,
];

/// The limits of every parameter that the criterion limits, at the speeds asked for.
pub(super) fn limits<S: Enclosed>(
    scene: &Scene,
    bounds: &Loop<Interval<S>>,
    speeds: &Speeds<Interval<S>>,
) -> Vec<Limit> {
    let of = |parameter| limit(parameter, scene, bounds, speeds);
    LIMITED.into_iter().filter_map(of).collect()
}

/// Where the values of a parameter that pass end, over the tolerances of all other parameters, as far as
/// that is not below zero; `None` where the criterion does not limit the parameter.
pub(super) fn ends<S: Enclosed>(
    parameter: Parameter,
    bounds: &Loop<Interval<S>>,
    speeds: &Speeds<Interval<S>>,
) -> Option<Ends<S>> {
    let side = match parameter.row().hurts {
        Hurts::Less => Side::AtLeast,
        Hurts::More => Side::AtMost,
        Hurts::Neither => return None,
    };
    let both_ways = bounds.period_pulls_both_ways();
    let ends = if is_searched(parameter, bounds) {
        searched(parameter, side, bounds, speeds)?
    } else if parameter == Parameter::Period && both_ways {
        longest_period(bounds, speeds)?
    } else {
        let border = border(parameter, side, bounds, speeds)?;
        let border = match both_ways && !bounds.period.is_point() {
            true => with_periods_between(parameter, side, border, bounds, speeds)?,
            false => border,
        };
        Ends {
            side,
            border,
            far: None,
        }
    };
    let clamped = |x: &S| x.clone().max(S::zero());
    Some(Ends {
        border: ends.border.map(clamped),
        ..ends
    })
}

/// The limit of one parameter; `None` where the criterion does not limit it, or where no value of
/// it is enough.
pub(super) fn limit<S: Enclosed>(
    parameter: Parameter,
    scene: &Scene,
    bounds: &Loop<Interval<S>>,
    speeds: &Speeds<Interval<S>>,
) -> Option<Limit> {
    let Ends { side, border, far } = ends(parameter, bounds, speeds)?;
    let hardest = side.hardest(&border);
    if side == Side::AtMost && hardest.is_positive() != Some(true) {
        return None;
    }
    let suffices = |x: &S| {
        let moved = bounds.clone().with(parameter, Interval::point(x.clone()));
        moved.surely_holds(speeds)
    };
    let written = written(parameter, scene);
    // A unit with π where the scene has none: then the limit is shown in SI.
    let printed = |border: &Interval<BigRational>, side: Side| {
        [&Written::si(""), &written]
            .map(|form| typed_back(form, side.hardest(border), side.rounding(), suffices))
    };
    let far_end = |border: Interval<S>| {
        let border = figure(&border)?;
        let [printed, typed] = printed(&border, side.other());
        Some(FarEnd {
            border,
            printed,
            typed,
        })
    };
    let far = match far {
        Some(border) => Some(far_end(border)?),
        None => None,
    };
    let border_figure = figure(&border)?;
    let [printed, typed] = printed(&border_figure, side);
    Some(Limit {
        parameter,
        now: figure(&now(parameter, bounds)?)?,
        suffices: suffices(hardest),
        border: border_figure,
        side,
        printed,
        typed,
        far,
        written: written.clone(),
    })
}

/// The first number of at least five digits, rounded to the safe side, that passes when it is typed
/// into the scene file.
pub(crate) fn typed_back<S: Enclosed>(
    written: &Written,
    border: &BigRational,
    rounding: Rounding,
    suffices: impl Fn(&S) -> bool,
) -> Option<String> {
    let passes = |text: &String| {
        let number = crate::number::parse(text).ok()?;
        if written.form() != Form::Value && !number.is_positive() {
            return None;
        }
        S::of(&written.typed(&number)).map(|x| suffices(&x))
    };
    // Where π cancels in the unit of the file, the limit may be a short number after all.
    let short = written.short(border).into_iter();
    let rounded = (5..20).filter_map(|digits| written.rounded(border, digits, rounding));
    short.chain(rounded).find(|text| passes(text) == Some(true))
}

/// How the scene file writes a parameter: in SI where it does not have it.
fn written(parameter: Parameter, scene: &Scene) -> Written {
    match scene.given.get(parameter) {
        Some(given) => given.written.clone(),
        None => Written::si(unit_of(parameter, scene.motion)),
    }
}

/// What the parameter is now; zero for an absent friction.
fn now<S: Enclosed>(parameter: Parameter, bounds: &Loop<Interval<S>>) -> Option<Interval<S>> {
    let default = || Some(Interval::point(S::integer(parameter.row().default?)));
    bounds.get(parameter).cloned().or_else(default)
}

/// The border of a parameter, from that at the hardest to that at the easiest end of the others.
pub(crate) fn border<S: Enclosed>(
    parameter: Parameter,
    side: Side,
    bounds: &Loop<Interval<S>>,
    speeds: &Speeds<Interval<S>>,
) -> Option<Interval<S>> {
    let [longest, shortest] = bounds.hardest();
    let at_end = |corner: &Loop<S>, end: End| at(parameter, corner, &speeds.at(end));
    let hardest = at_end(&longest, End::Hardest)?;
    let other = at_end(&shortest, End::Hardest)?;
    let hardest = match side {
        Side::AtLeast => hardest.max(other),
        Side::AtMost => hardest.min(other),
    };
    let [longest, shortest] = bounds.easiest();
    let easiest = at_end(&longest, End::Easiest)?;
    let other = at_end(&shortest, End::Easiest)?;
    let easiest = match side {
        Side::AtLeast => easiest.min(other),
        Side::AtMost => easiest.max(other),
    };
    Some(Interval::hull(hardest, easiest))
}

/// The border with the loops of periods between the ends of the tolerance, among which one may be
/// easier than both ends are: where the period pulls both ways. Its easiest end is bracketed then.
fn with_periods_between<S: Enclosed>(
    parameter: Parameter,
    side: Side,
    border: Interval<S>,
    bounds: &Loop<Interval<S>>,
    speeds: &Speeds<Interval<S>>,
) -> Option<Interval<S>> {
    let fails = |x: &S| {
        let at = Interval::point(x.clone());
        bounds.clone().with(parameter, at).decide(speeds) == Some(Truth::Fails)
    };
    let easiest = match side {
        Side::AtLeast => border.lo().clone().max(S::zero()),
        Side::AtMost => border.hi().clone(),
    };
    let doubled = |x: &S| Some(x.clone() + x.clone());
    let beyond = match side {
        Side::AtLeast => Some(S::zero()),
        Side::AtMost => iter::successors(Some(easiest.clone()), doubled)
            .take(DOUBLINGS as usize)
            .find(fails),
    };
    // Alone it is not enough whatever it is, or it is always.
    let Some(beyond) = beyond.filter(|_| !fails(&easiest)) else {
        return Some(border);
    };
    if !fails(&beyond) {
        return Some(border.joined(&Interval::point(beyond)));
    }
    let found = bisected(easiest.clone(), &beyond, STEPS, |x| !fails(x))?;
    let unmoved = |end: &S| end.compare(&easiest) == Some(Ordering::Equal);
    let is_at_an_end = unmoved(found.lo()) || unmoved(found.hi());
    Some(match is_at_an_end {
        true => border,
        false => border.joined(&found),
    })
}

/// Where a loop meets the criterion with equality, at every speed or at every speed up to a bound.
fn at<S: Enclosed>(parameter: Parameter, corner: &Loop<S>, speeds: &Speeds<S>) -> Option<S> {
    let bound = match speeds {
        Speeds::All => None,
        Speeds::UpTo(v) => Some(v),
        Speeds::UpToSquared(_) => return None,
    };
    match (parameter, bound) {
        (Parameter::Viscous, None) => Some(stiffness::viscous_needed(corner)),
        (Parameter::Viscous, Some(v)) => Some(stiffness::viscous_needed_at_speed(corner, v)),
        (Parameter::Coulomb, None) => Some(stiffness::coulomb_needed(corner)),
        (Parameter::Coulomb, Some(v)) => Some(stiffness::coulomb_needed_up_to_speed(corner, v)),
        (Parameter::Stiffness, None) => Some(stiffness::limit_at_all_speeds(corner)),
        (Parameter::Stiffness, Some(v)) => Some(stiffness::limit_up_to_speed(corner, v)),
        (Parameter::Period, None) => Some(stiffness::longest_period(corner)),
        (Parameter::Period, Some(v)) => Some(stiffness::longest_period_at_speed(corner, v)),
        (Parameter::Resolution, None) => stiffness::coarsest_resolution(corner),
        (Parameter::Resolution, Some(v)) => stiffness::coarsest_resolution_up_to_speed(corner, v),
        _ => None,
    }
}

/// Whether no formula says the border of a parameter, because what the effects cost depends on it, or
/// differs over the tolerances of others.
pub(crate) fn is_searched<S: Enclosed>(parameter: Parameter, bounds: &Loop<Interval<S>>) -> bool {
    let constant = bounds.controller.is_some() && !bounds.has_actuator();
    let varies = bounds.has_computed_costs() && !constant;
    match parameter {
        Parameter::Damping
        | Parameter::DampingTimeConstant
        | Parameter::Latency
        | Parameter::TimeConstant => true,
        // A controller in units of the stiffness costs the same whatever K and T are.
        Parameter::Stiffness | Parameter::Period => varies,
        // Friction and the resolution are no part of what is computed.
        _ => {
            let cost = bounds.viscous_cost.as_ref();
            let given = bounds
                .get(parameter)
                .is_some_and(|x| x.hi().is_positive() == Some(true));
            varies && given && cost.is_some_and(|cost| !cost.is_point() && differs(cost))
        }
    }
}

/// Whether a cost is a range over tolerances, and not just an enclosure of one number.
fn differs<S: Enclosed>(cost: &Interval<S>) -> bool {
    let close = S::of(&Exact::of(&BigRational::from_integer((1_i64 << 48).into())));
    let width = cost.hi().clone() - cost.lo().clone();
    close.is_none_or(|close| (width * close).compare(cost.hi()) != Some(Ordering::Less))
}

mod search;
