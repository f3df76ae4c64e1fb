//! A column of the plane: which numbers of one axis pass at a number of the other.

use std::fmt;

use passivity_core::parameter::Hurts;
use passivity_core::{
    BigRational, Enclosed, Exact, Interval, Loop, Parameter, Truth, Wide, verdict,
};

use super::extent::{Along, Extent, exact};
use super::spans::{Span, searched, solved};
use crate::check::is_searched;
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
            if let Some(why) = Self::refusal(axis.parameter()) {
                return Err(PlaneError::new(format!("`{}` {why}", axis.name())));
            }
        }
        Axis::fit(&axes, scene).map_err(|error| PlaneError::new(error.to_string()))?;
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

    /// Why no plane has a parameter on an axis, for [`Axis::parse_for`]: the criterion does not know it.
    #[must_use]
    pub fn refusal(parameter: Parameter) -> Option<&'static str> {
        (parameter.row().hurts == Hurts::Neither)
            .then_some("has no part in the criterion, so no border depends on it")
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
            // What is computed from other parameters has no key.
            let part = |p: &Parameter| p.row().hurts != Hurts::Neither && !p.row().key.is_empty();
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
    pub fn holds(&self, point: [&BigRational; 2], speeds: Speeds) -> Option<Truth> {
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
            let at = with_own_costs(bounds, axes, [&one, &one])?;
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
        let at = with_own_costs(bounds, &self.axes, start)?;
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

/// Bits of what is enclosed for a picture.
const BITS: u32 = 64;

/// A number, or a close enclosure of it where this kind of number cannot hold it.
fn value<S: Enclosed>(x: &Exact) -> Option<Interval<S>> {
    if let Some(x) = S::of(x) {
        return Some(Interval::point(x));
    }
    x.enclosure(BITS)?.try_map(|end| S::of(&Exact::of(end)))
}

/// The loop at a point of the plane.
fn moved<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    axes: &[Axis; 2],
    point: [&BigRational; 2],
) -> Option<Loop<Interval<S>>> {
    let mut at = bounds.clone();
    for (axis, number) in axes.iter().zip(point) {
        at = at.with(axis.parameter(), value(&axis.si(number)?)?);
    }
    Some(at)
}

/// The same with what it costs itself: what was computed for the scene is of the scene's own point.
fn with_own_costs<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    axes: &[Axis; 2],
    point: [&BigRational; 2],
) -> Option<Loop<Interval<S>>> {
    let at = moved(bounds, axes, point)?;
    at.reshaped(|_| ()).with_costs(BITS)
}

/// The speeds of a region at a point of the plane.
fn asked<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    axes: &[Axis; 2],
    point: [&BigRational; 2],
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
