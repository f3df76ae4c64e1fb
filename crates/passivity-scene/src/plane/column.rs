//! A column of the plane: which numbers of one axis pass at a number of the other.

use std::fmt;

use num_traits::Signed as _;
use passivity_core::parameter::Hurts;
use passivity_core::{Enclosed, Exact, Interval, Loop, Parameter, Truth, Wide, verdict};

use super::extent::{Along, Extent, exact};
use crate::check::{border, is_searched};
use crate::display::{Rounding, rounded};
use crate::number::nearest_f64;
use crate::parse::Axis;
use crate::scene::Scene;

/// The speeds at which a region of the plane is passive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Speeds {
    /// At every speed.
    Every,
    /// Up to `operator.max_speed`.
    UpToBound,
}

/// Why a plane has no border.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaneError {
    pub(super) message: String,
}

impl PlaneError {
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
        }
    }
}

impl fmt::Display for PlaneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for PlaneError {}

/// Two parameters of a scene that may take other values.
#[derive(Clone, Debug)]
pub struct Plane {
    /// The axes, x and y.
    pub axes: [Axis; 2],
    bounds: Bounds,
}

/// The loop with its tolerances: where there is no π, plain fractions do, and faster.
#[derive(Clone, Debug)]
enum Bounds {
    Wide(Box<Loop<Interval<Wide>>>),
    Exact(Box<Loop<Interval<Exact>>>),
}

/// The numbers of an axis that pass, from one end to the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    pub(super) ends: [End; 2],
}

impl Span {
    pub(super) const fn low(&self) -> End {
        let [low, _] = self.ends;
        low
    }

    pub(super) const fn high(&self) -> End {
        let [_, high] = self.ends;
        high
    }
}

/// An end of a span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    pub(super) at: f64,
    /// Whether it is a border of the region, not the edge of the picture.
    pub(super) is_border: bool,
}

/// The cells of a column that are looked at where no formula says its border.
const CELLS: u32 = 16;

impl Plane {
    /// The plane of two different parameters of a scene that the criterion knows.
    ///
    /// # Errors
    ///
    /// A parameter that has no part in the criterion or that the scene cannot have, or a scene that
    /// no theorem covers.
    pub fn new(scene: &Scene, axes: [Axis; 2]) -> Result<Self, PlaneError> {
        let [x, y] = &axes;
        if x.parameter() == y.parameter() {
            let message = format!("`{}` and `{}` are the same parameter", x.name(), y.name());
            return Err(PlaneError::new(message));
        }
        for axis in &axes {
            refuse(scene, axis)?;
        }
        if let Some(effect) = scene.not_covered().first() {
            let message = format!("no theorem covers {} in `{}`", effect.words(), scene.name);
            return Err(PlaneError::new(message));
        }
        let bounds = scene.bounds();
        let bounds = match wide(&bounds, &axes) {
            Some(wide) => Bounds::Wide(Box::new(wide)),
            None => Bounds::Exact(Box::new(bounds)),
        };
        Ok(Self { axes, bounds })
    }

    /// Whether the scene, or one of the axes, bounds the speed.
    #[must_use]
    pub fn has_speed_bound(&self) -> bool {
        let given = match &self.bounds {
            Bounds::Wide(bounds) => bounds.max_speed.is_some(),
            Bounds::Exact(bounds) => bounds.max_speed.is_some(),
        };
        given || self.has_axis(Parameter::MaxSpeed)
    }

    fn has_axis(&self, parameter: Parameter) -> bool {
        self.axes.iter().any(|axis| axis.parameter() == parameter)
    }

    /// The speeds that are worth a region: every speed does not depend on the bound.
    #[must_use]
    pub fn speeds(&self) -> Vec<Speeds> {
        let every = !self.has_axis(Parameter::MaxSpeed);
        let every = every.then_some(Speeds::Every);
        let bound = self.has_speed_bound().then_some(Speeds::UpToBound);
        every.into_iter().chain(bound).collect()
    }

    /// Whether two planes have the same border: the scenes differ in the axes at most.
    #[must_use]
    pub fn has_same_border(&self, other: &Self) -> bool {
        fn same<S: Enclosed + PartialEq>(
            a: &Loop<Interval<S>>,
            b: &Loop<Interval<S>>,
            axes: &[Axis],
        ) -> bool {
            let part = |p: &Parameter| p.row().hurts != Hurts::Neither;
            let fixed = |p: &Parameter| axes.iter().all(|axis| axis.parameter() != *p);
            let mut others = Parameter::ALL.iter().filter(|p| part(p) && fixed(p));
            let shape = |l: &Loop<Interval<S>>| (l.delay, l.unilateral, l.max_force.is_some());
            others.all(|p| a.get(*p) == b.get(*p))
                && shape(a) == shape(b)
                && a.controller == b.controller
        }
        let same_axes = self.axes == other.axes;
        same_axes
            && match (&self.bounds, &other.bounds) {
                (Bounds::Wide(a), Bounds::Wide(b)) => same(a, b, &self.axes),
                (Bounds::Exact(a), Bounds::Exact(b)) => same(a, b, &self.axes),
                _ => false,
            }
    }

    /// Whether the criterion holds at a point, x and y in the units of the axes, over the tolerances of
    /// all other parameters; `None` where the parameters cannot have such values.
    #[must_use]
    pub fn holds(&self, point: [&passivity_core::BigRational; 2], speeds: Speeds) -> Option<Truth> {
        match &self.bounds {
            Bounds::Wide(bounds) => {
                moved(bounds, &self.axes, point)?.truth(&asked(bounds, &self.axes, point, speeds)?)
            }
            Bounds::Exact(bounds) => {
                moved(bounds, &self.axes, point)?.truth(&asked(bounds, &self.axes, point, speeds)?)
            }
        }
    }

    /// Whether a formula says the border; else it is searched for.
    #[must_use]
    pub fn has_formula(&self) -> bool {
        self.solved().is_some()
    }

    /// Which axis is solved for: one of which a formula says the border, else y.
    pub(super) fn inner(&self) -> Along {
        self.solved().unwrap_or(Along::Y)
    }

    fn solved(&self) -> Option<Along> {
        fn solved<S: Enclosed>(axes: &[Axis; 2], bounds: &Loop<Interval<S>>) -> Option<Along> {
            let one = exact(1.0)?;
            let at = moved(bounds, axes, [&one, &one])?;
            let [x, y] = axes
                .each_ref()
                .map(|axis| has_formula(axis.parameter(), &at));
            y.then_some(Along::Y).or(x.then_some(Along::X))
        }
        match &self.bounds {
            Bounds::Wide(bounds) => solved(&self.axes, bounds),
            Bounds::Exact(bounds) => solved(&self.axes, bounds),
        }
    }

    /// The numbers of the inner axis that pass at a number of the outer one, within an extent; beside
    /// the cells of the extent the `hints` are looked at.
    pub(super) fn spans(
        &self,
        inner: Along,
        outer: f64,
        extent: &Extent,
        speeds: Speeds,
        hints: &[f64],
    ) -> Vec<Span> {
        let spans = match &self.bounds {
            Bounds::Wide(bounds) => self.spans_of(bounds, inner, outer, extent, speeds, hints),
            Bounds::Exact(bounds) => self.spans_of(bounds, inner, outer, extent, speeds, hints),
        };
        // Where a number is undefined nothing is claimed.
        spans.unwrap_or_default()
    }

    fn spans_of<S: Enclosed>(
        &self,
        bounds: &Loop<Interval<S>>,
        inner: Along,
        outer: f64,
        extent: &Extent,
        speeds: Speeds,
        hints: &[f64],
    ) -> Option<Vec<Span>> {
        let outer = exact(outer)?;
        let point = |w: f64| Some(inner.pair(exact(w)?, outer.clone()));
        let passes = |w: f64| -> Option<bool> {
            let point = point(w)?;
            let point = point.each_ref();
            let at = moved(bounds, &self.axes, point)?;
            Some(at.surely_holds(&asked(bounds, &self.axes, point, speeds)?))
        };
        let axis = inner.of(&self.axes);
        let start = point(extent.decimal(0.5, axis))?;
        let start = start.each_ref();
        let at = moved(bounds, &self.axes, start)?;
        if !has_formula(axis.parameter(), &at) {
            return Some(searched(extent, axis, hints, |w| passes(w) == Some(true)));
        }
        let asked = asked(bounds, &self.axes, start, speeds)?;
        solved(axis, extent, &at, &asked, |w| passes(w) == Some(true))
    }
}

/// The loop in plain fractions: where neither it nor the axes have π in them, or where its costs have to
/// be computed, which takes too long with π. Then π is enclosed, so closely that no picture shows it;
/// what passes over the enclosure passes.
fn wide(bounds: &Loop<Interval<Exact>>, axes: &[Axis; 2]) -> Option<Loop<Interval<Wide>>> {
    let one = exact(1.0)?;
    let computed = moved(bounds, axes, [&one, &one])?.has_computed_costs();
    let plain = axes
        .iter()
        .all(|axis| axis.si(&one).is_some_and(|si| Wide::of(&si).is_some()));
    match bounds.try_map(|_, range| range.try_map(Wide::of)) {
        Some(wide) if plain || computed => Some(wide),
        _ if computed => bounds.try_map(|_, range| {
            let lo = value::<Wide>(range.lo())?.lo().clone();
            Some(Interval::hull(lo, value::<Wide>(range.hi())?.hi().clone()))
        }),
        _ => None,
    }
}

/// A number, or a close enclosure of it where this kind of number cannot hold it.
fn value<S: Enclosed>(x: &Exact) -> Option<Interval<S>> {
    const BITS: u32 = 64;
    if let Some(x) = S::of(x) {
        return Some(Interval::point(x));
    }
    x.enclosure(BITS)?.try_map(|end| S::of(&Exact::of(end)))
}

/// Refuses an axis that the criterion does not know, or that a scene cannot have.
fn refuse(scene: &Scene, axis: &Axis) -> Result<(), PlaneError> {
    let (parameter, name, given) = (axis.parameter(), axis.name(), &scene.given);
    if parameter.row().hurts == Hurts::Neither {
        let message = format!("`{name}` has no part in the criterion, so no border depends on it");
        return Err(PlaneError::new(message));
    }
    let needs = match parameter {
        Parameter::Damping | Parameter::DampingTimeConstant if given.controller.is_some() => {
            Some("a scene without a [controller]")
        }
        Parameter::DampingTimeConstant if given.damping.is_none() => {
            Some("a scene with wall.damping")
        }
        _ => None,
    };
    match needs {
        Some(needs) => {
            let message = format!("`{name}` needs {needs}: `{}` is not one", scene.name);
            Err(PlaneError::new(message))
        }
        None => Ok(()),
    }
}

/// The loop at a point of the plane.
fn moved<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    axes: &[Axis; 2],
    point: [&passivity_core::BigRational; 2],
) -> Option<Loop<Interval<S>>> {
    let mut at = bounds.clone();
    for (axis, number) in axes.iter().zip(point) {
        at = at.with(axis.parameter(), value(&axis.si(number)?)?);
    }
    Some(at)
}

/// The speeds of a region at a point of the plane.
fn asked<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    axes: &[Axis; 2],
    point: [&passivity_core::BigRational; 2],
    speeds: Speeds,
) -> Option<verdict::Speeds<Interval<S>>> {
    Some(match speeds {
        Speeds::Every => verdict::Speeds::All,
        Speeds::UpToBound => verdict::Speeds::UpTo(moved(bounds, axes, point)?.max_speed?),
    })
}

/// Whether a formula solves the criterion of a loop for a parameter.
fn has_formula<S: Enclosed>(parameter: Parameter, at: &Loop<Interval<S>>) -> bool {
    let has = match parameter {
        Parameter::Viscous | Parameter::Coulomb | Parameter::Stiffness | Parameter::Resolution => {
            true
        }
        Parameter::Period => !at.period_pulls_both_ways(),
        _ => false,
    };
    has && !is_searched(parameter, at)
}

/// The one span that a formula says: from the border on, to the side on which the criterion is easier.
fn solved<S: Enclosed>(
    axis: &Axis,
    extent: &Extent,
    at: &Loop<Interval<S>>,
    speeds: &verdict::Speeds<Interval<S>>,
    passes: impl Fn(f64) -> bool,
) -> Option<Vec<Span>> {
    use crate::check::Side;
    let parameter = axis.parameter();
    let side = match parameter.row().hurts {
        Hurts::Less => Side::AtLeast,
        _ => Side::AtMost,
    };
    let border = border(parameter, side, at, speeds)?;
    let hardest = match side {
        Side::AtLeast => border.hi().clone().max(S::zero()),
        Side::AtMost => border.lo().clone(),
    };
    // The side of the passing numbers on the axis: a rate is the reciprocal of a period.
    let upwards = (side == Side::AtLeast) != axis.is_reciprocal();
    let edges = [extent.decimal(0.0, axis), extent.decimal(1.0, axis)];
    let [low, high] = edges;
    if side == Side::AtMost && hardest.is_positive() != Some(true) {
        return Some(Vec::new());
    }
    let bits = enclosure_of(&hardest)?;
    let number = match axis.numbers(&bits) {
        Some(numbers) => numbers,
        // The reciprocal of zero: all numbers pass or none.
        None => {
            return Some(if passes(high) {
                whole(edges)
            } else {
                Vec::new()
            });
        }
    };
    let decimal = |digits: u32| {
        let (end, to) = if upwards {
            (number.hi(), Rounding::Up)
        } else {
            (number.lo(), Rounding::Down)
        };
        let text = if axis.is_whole() {
            if upwards { end.ceil() } else { end.floor() }.to_string()
        } else {
            rounded(end, digits, to)
        };
        text.parse::<f64>().ok()
    };
    let value = nearest_f64(if upwards { number.hi() } else { number.lo() });
    if (upwards && value <= low) || (!upwards && value >= high) {
        // All of the column, if the number at its hardest edge passes.
        let hardest_edge = if upwards { low } else { high };
        return Some(if passes(hardest_edge) {
            whole(edges)
        } else {
            Vec::new()
        });
    }
    let Some(at) = (7..14).filter_map(decimal).find(|w| passes(*w)) else {
        return Some(Vec::new());
    };
    if (upwards && at > high) || (!upwards && at < low) {
        return Some(Vec::new());
    }
    let border = End {
        at,
        is_border: true,
    };
    let edge = |at| End {
        at,
        is_border: false,
    };
    Some(vec![Span {
        ends: if upwards {
            [border, edge(high)]
        } else {
            [edge(low), border]
        },
    }])
}

fn enclosure_of<S: Enclosed>(x: &S) -> Option<Interval<passivity_core::BigRational>> {
    let bounds = x.enclosed(crate::check::BITS)?;
    let positive = !bounds.lo().is_negative();
    positive.then_some(bounds)
}

fn whole([low, high]: [f64; 2]) -> Vec<Span> {
    let edge = |at| End {
        at,
        is_border: false,
    };
    vec![Span {
        ends: [edge(low), edge(high)],
    }]
}

/// The spans of a column of which no formula knows: every change between neighbouring cells, halved
/// until its two sides are neighbouring decimals.
fn searched(
    extent: &Extent,
    axis: &Axis,
    hints: &[f64],
    passes: impl Fn(f64) -> bool,
) -> Vec<Span> {
    let cells = (0..=CELLS).map(|i| f64::from(i) / f64::from(CELLS));
    let hinted = hints.iter().map(|w| extent.share(*w));
    let mut shares: Vec<f64> = cells
        .chain(hinted.filter(|s| (0.0..=1.0).contains(s)))
        .collect();
    shares.sort_by(f64::total_cmp);
    let looked: Vec<(f64, bool)> = shares
        .into_iter()
        .map(|share| (share, passes(extent.decimal(share, axis))))
        .collect();
    let mut spans = Vec::new();
    let mut open: Option<End> = None;
    let edge = |share| End {
        at: extent.decimal(share, axis),
        is_border: false,
    };
    if let Some((share, true)) = looked.first() {
        open = Some(edge(*share));
    }
    for pair in looked.windows(2) {
        let [(a, before), (b, after)] = pair else {
            continue;
        };
        match (before, after) {
            (false, true) => open = Some(bisected(*b, *a, extent, axis, &passes)),
            (true, false) => {
                if let Some(start) = open.take() {
                    let end = bisected(*a, *b, extent, axis, &passes);
                    spans.push(Span { ends: [start, end] });
                }
            }
            _ => {}
        }
    }
    if let (Some(start), Some((share, _))) = (open, looked.last()) {
        spans.push(Span {
            ends: [start, edge(*share)],
        });
    }
    spans
}

/// The last number that passes on the way from one that does to one that does not.
fn bisected(
    passing: f64,
    failing: f64,
    extent: &Extent,
    axis: &Axis,
    passes: impl Fn(f64) -> bool,
) -> End {
    let (mut inside, mut outside) = (passing, failing);
    loop {
        let middle = 0.5 * (inside + outside);
        let [a, m, b] = [inside, middle, outside].map(|share| extent.decimal(share, axis));
        if m == a || m == b {
            return End {
                at: a,
                is_border: true,
            };
        }
        if passes(m) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
}
