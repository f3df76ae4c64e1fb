//! The columns of a trace: which there are, in which units, and how their values become ticks,
//! sampling periods and KΔ.

use num_bigint::BigInt;
use num_traits::Zero as _;
use passivity_core::{BigRational, Exact, Interval, Loop, Scalar, pi};
use passivity_scene::units::{Dimension, Unit};
use passivity_scene::{Motion, Scene};

use crate::log::chunk::Force;
use crate::log::error::{TraceError, shown};
use crate::log::running::near;
use crate::number::{Number, difference, is_positive, product, quotient};
use crate::reading::Reading;

/// The most columns of a trace.
pub(crate) const MAX_COLUMNS: usize = 4096;

/// In what form the trace gives positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `xi`, in ticks.
    Xi,
    /// `x [unit]`.
    X,
    /// `count`.
    Count,
    /// `xi0`, `xi1` and perhaps `dtau`: the rows of a ledger.
    Ledger,
}

impl Form {
    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Xi => "xi",
            Self::X => "x",
            Self::Count => "count",
            Self::Ledger => "ledger",
        }
    }
}

/// What the header says.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    pub(crate) form: Form,
    /// The column of the position; of `xi0` in a ledger.
    pub(crate) position: usize,
    /// The column of `xi1` in a ledger.
    pub(crate) end: Option<usize>,
    pub(crate) dtau: Option<usize>,
    pub(crate) time: Option<usize>,
    pub(crate) force: Option<usize>,
    /// How many columns there are.
    pub(crate) width: usize,
    pub(crate) names: Vec<String>,
    scale: Scale,
    /// Units of time over the sampling period.
    per_period: Number,
    per_force: Scale,
}

/// How a number of the trace becomes one in ticks or in KΔ.
#[derive(Clone, Debug)]
enum Scale {
    /// It is one.
    One,
    /// By a rational factor.
    Factor(Number),
    /// By a factor with π in it, which is in the interval.
    Irrational(Exact, Interval<BigRational>),
}

impl Scale {
    fn of(factor: Exact) -> Result<Self, TraceError> {
        /// Bits of the enclosure: past those of the longest logs and of the grid by far.
        const BITS: u32 = 256;
        if let Some(x) = factor.to_rational() {
            return Ok(Self::Factor(Number::from(x)));
        }
        match factor.enclosure(BITS) {
            Some(range) => Ok(Self::Irrational(factor, range)),
            None => Err(TraceError::new(
                "unit",
                "the unit of this column is not defined",
            )),
        }
    }

    const fn is_irrational(&self) -> bool {
        matches!(self, Self::Irrational(..))
    }
}

/// The columns whose names a trace may have, as they were found.
struct Names<'n>(&'n [String]);

impl Layout {
    /// Reads the names of the columns.
    pub(crate) fn read(names: Vec<String>, scene: &Scene) -> Result<Self, TraceError> {
        if names.len() > MAX_COLUMNS {
            return Err(header(format!("a trace may have {MAX_COLUMNS} columns")));
        }
        let columns = Names(&names);
        let (form, (position, unit), end) = columns.positions()?;
        let is_ledger = form == Form::Ledger;
        if form == Form::Count && !scene.given.has_encoder() {
            return Err(header("counts need a scene with an encoder").column("count"));
        }
        let scale = match (form, unit) {
            (Form::X, unit) => {
                position_scale(unit, scene).map_err(|e| e.column(columns.name(position)))?
            }
            (_, Some(_)) => {
                let message = "ticks have no unit: `x [unit]` is for positions with one";
                return Err(header(message).column(columns.name(position)));
            }
            (_, None) => Scale::One,
        };
        let time = columns.find("t")?;
        let per_period = match time {
            Some((i, unit)) => time_scale(unit, scene).map_err(|e| e.column(columns.name(i)))?,
            None => Number::whole(1),
        };
        let time = time.or(columns.find("tau")?).map(|(i, _)| i);
        // A ledger says under which force its intervals were, when that is not the law's.
        let force = columns.find(if is_ledger { "force" } else { "f" })?;
        let per_force = match force {
            Some((i, unit)) if !is_ledger => {
                force_scale(unit, scene).map_err(|e| e.column(columns.name(i)))?
            }
            _ => Scale::One,
        };
        let dtau = match is_ledger {
            true => columns.find("dtau")?.map(|(i, _)| i),
            false => None,
        };
        Ok(Self {
            form,
            position,
            end,
            dtau,
            time,
            force: force.map(|(i, _)| i),
            width: names.len(),
            names,
            scale,
            per_period,
            per_force,
        })
    }

    /// The name of a column.
    pub(crate) fn name(&self, column: usize) -> String {
        Names(&self.names).name(column)
    }

    /// Whether positions, or forces that are `applied`, are known only between two ends.
    pub(crate) const fn encloses(&self, applied: bool) -> bool {
        matches!(self.form, Form::Count)
            || self.scale.is_irrational()
            || (applied && self.per_force.is_irrational())
    }

    /// Δτ between two times; `None` unless the second is later.
    pub(crate) fn duration(&self, from: &Number, to: &Number) -> Option<Number> {
        let dt = difference(to, from);
        is_positive(&dt).then(|| quotient(&dt, &self.per_period))
    }

    /// How many of the intervals between these times, from the first on, last exactly one period.
    pub(crate) fn even(&self, times: &[Number]) -> usize {
        let Number::Small(n, d) = &self.per_period else {
            return 0;
        };
        let (n, d) = (i128::from(*n), i128::from(*d));
        let is_period = |from: &Number, to: &Number| {
            let (Number::Small(a, b), Number::Small(p, q)) = (from, to) else {
                return None;
            };
            let [a, b, p, q] = [*a, *b, *p, *q].map(i128::from);
            // p/q − a/b = n/d
            let (numerator, denominator): (i128, i128) = match b == q {
                true => (p - a, b),
                false => (p * b - a * q, b * q),
            };
            Some(numerator.checked_mul(d)? == n.checked_mul(denominator)?)
        };
        let pairs = times.iter().zip(times.iter().skip(1));
        pairs
            .take_while(|(from, to)| is_period(from, to) == Some(true))
            .count()
    }

    /// A position as it is known.
    pub(crate) fn sample(&self, x: Number) -> Result<Reading, TraceError> {
        match &self.scale {
            Scale::One => Ok(Reading::Exact(x)),
            Scale::Factor(factor) => Ok(Reading::Exact(product(&x, factor))),
            Scale::Irrational(factor, range) => within_a_tick(&x.to_rational(), factor, range),
        }
    }

    /// A force as it is known, written to within `rounding` of its unit.
    pub(crate) fn force(&self, x: Number, rounding: f64) -> Force {
        let (value, unit) = match &self.per_force {
            Scale::One => (Reading::Exact(x), 1.0),
            Scale::Factor(factor) => {
                let unit = near(&factor.to_rational());
                (Reading::Exact(product(&x, factor)), unit)
            }
            Scale::Irrational(_, range) => {
                let x = x.to_rational();
                let range_of_force = Interval::hull(&x * range.lo(), &x * range.hi());
                (enclosed(&on_grid(&range_of_force)), near(range.lo()))
            }
        };
        Force {
            value,
            rounding: rounding * unit.abs(),
        }
    }
}

fn header(message: impl Into<String>) -> TraceError {
    TraceError::new("header", message)
}

/// A column, and the unit in its name.
type Column<'n> = (usize, Option<&'n str>);

impl<'n> Names<'n> {
    fn name(&self, column: usize) -> String {
        match self.0.get(column) {
            Some(name) => name.clone(),
            None => format!("number {}", column + 1),
        }
    }

    /// The column with this name, its unit aside.
    fn find(&self, base: &str) -> Result<Option<Column<'n>>, TraceError> {
        let mut found = None;
        for (i, name) in self.0.iter().enumerate() {
            let (stem, unit) = split(name);
            if stem != base {
                continue;
            }
            let unit = unit.map_err(|message| header(message).column(name))?;
            if found.is_some() {
                return Err(header(format!("the column `{base}` is given twice")).column(name));
            }
            found = Some((i, unit));
        }
        Ok(found)
    }

    /// The form of positions, their column, and that of where a row of a ledger ends.
    fn positions(&self) -> Result<(Form, Column<'n>, Option<usize>), TraceError> {
        if let (Some((start, _)), Some((end, _))) = (self.find("xi0")?, self.find("xi1")?) {
            // A ledger may repeat where its intervals start as `xi`: its own columns say more.
            return Ok((Form::Ledger, (start, None), Some(end)));
        }
        let forms = [
            (Form::Xi, self.find("xi")?),
            (Form::X, self.find("x")?),
            (Form::Count, self.find("count")?),
        ];
        let mut present = forms
            .into_iter()
            .filter_map(|(form, column)| Some((form, column?)));
        match (present.next(), present.next()) {
            (Some((form, column)), None) => Ok((form, column, None)),
            (Some((form, _)), Some((other, _))) => Err(header(format!(
                "expected one of `xi`, `x [unit]` and `count`, found `{}` and `{}`",
                form.name(),
                other.name()
            ))),
            (None, _) => {
                let found = self.0.iter().take(8).map(|n| shown(n.as_bytes()));
                let found = found.collect::<Vec<_>>().join("`, `");
                Err(header(format!(
                    "expected a column `xi`, `x [unit]` or `count`, found `{found}`"
                )))
            }
        }
    }
}

/// `x [rad]` as `x` and `rad`, or why the brackets say nothing.
fn split(name: &str) -> (&str, Result<Option<&str>, &'static str>) {
    match name.split_once('[') {
        Some((stem, rest)) => {
            let unit = rest.trim_end().strip_suffix(']');
            let unit = unit.map(|unit| Some(unit.trim()));
            (stem.trim(), unit.ok_or("the bracket is not closed"))
        }
        None => (name.trim(), Ok(None)),
    }
}

fn unit(text: Option<&str>, example: &str) -> Result<Unit, TraceError> {
    let Some(text) = text else {
        let message = format!("a column with a unit is needed, as in `{example}`");
        return Err(TraceError::new("unit", message));
    };
    Unit::parse(text).map_err(|error| {
        let message = format!("`{}`: {error}", shown(text.as_bytes()));
        TraceError::new("unit", message)
    })
}

fn needs_units(scene: &Scene, instead: &str) -> Result<(), TraceError> {
    if scene.motion == Motion::Dimensionless {
        let message = format!("the scene is dimensionless: give `{instead}`");
        return Err(TraceError::new("unit", message));
    }
    Ok(())
}

/// Whether a unit measures what the scene's own does, radians being no dimension to insist on.
fn expect(unit: &Unit, linear: Dimension, scene: &Scene, what: &str) -> Result<(), TraceError> {
    let rotary = match what {
        "a position" => Dimension::NONE.with_angle(1),
        _ => Dimension::new(1, 2, -2, 0),
    };
    let found = unit.dimension().with_angle(0);
    let (expected, example) = match (scene.motion, what) {
        (Motion::Linear, "a position") => (linear, "mm"),
        (Motion::Linear, _) => (linear, "N"),
        (_, "a position") => (rotary, "rad"),
        (_, _) => (rotary, "N m"),
    };
    if found == expected.with_angle(0) {
        return Ok(());
    }
    let message = format!("expected the unit of {what}, such as `{example}`");
    Err(TraceError::new("unit", message))
}

fn position_scale(text: Option<&str>, scene: &Scene) -> Result<Scale, TraceError> {
    needs_units(scene, "xi")?;
    let unit = unit(text, "x [rad]")?;
    expect(&unit, Dimension::new(0, 1, 0, 0), scene, "a position")?;
    let scale = Scale::of(exact(&unit).over(nominal(scene).length()))?;
    if scale.is_irrational() && !scene.given.has_encoder() {
        let message = "without an encoder positions must be in radians or metres";
        return Err(TraceError::new("unit", message));
    }
    Ok(scale)
}

/// A unit in SI.
fn exact(unit: &Unit) -> Exact {
    let power = (0..unit.pi_power().unsigned_abs()).fold(Exact::one(), |x, _| x * pi::pi());
    let scale = Exact::of(unit.scale());
    if unit.pi_power() < 0 {
        scale.over(power)
    } else {
        scale * power
    }
}

/// The parameters of a scene at their nominal values.
fn nominal(scene: &Scene) -> Loop<Exact> {
    scene.given.map(|_, given| given.nominal.clone())
}

fn time_scale(text: Option<&str>, scene: &Scene) -> Result<Number, TraceError> {
    needs_units(scene, "tau")?;
    let unit = unit(text, "t [s]")?;
    if unit.dimension() != Dimension::new(0, 0, 1, 0) {
        let message = "expected a unit of time, such as `s`";
        return Err(TraceError::new("unit", message));
    }
    match nominal(scene).period.over(exact(&unit)).to_rational() {
        Some(x) => Ok(Number::from(x)),
        None => Err(TraceError::new("unit", "a unit of time has no π in it")),
    }
}

fn force_scale(text: Option<&str>, scene: &Scene) -> Result<Scale, TraceError> {
    if text.is_none() && scene.motion == Motion::Dimensionless {
        return Ok(Scale::One);
    }
    let unit = unit(text, "f [N]")?;
    needs_units(scene, "f")?;
    expect(&unit, Dimension::new(1, 1, -2, 0), scene, "a force")?;
    Scale::of(exact(&unit).over(nominal(scene).force_unit()))
}

/// x·`factor`, enclosed on a fine grid within one tick.
fn within_a_tick(
    x: &BigRational,
    factor: &Exact,
    range: &Interval<BigRational>,
) -> Result<Reading, TraceError> {
    if x.is_zero() {
        return Ok(Reading::Exact(Number::whole(0)));
    }
    let fine = Interval::hull(x * range.lo(), x * range.hi());
    // No position is a whole number of ticks: π would be rational.
    let tick = match fine.lo().floor() == fine.hi().floor() {
        true => fine.lo().floor(),
        false => (Exact::of(x) * factor.clone())
            .floor()
            .to_rational()
            .ok_or_else(|| {
                let message = "too close to the border between two ticks to tell which it is in";
                TraceError::new("position", message)
            })?,
    };
    let coarse = on_grid(&fine);
    let above = &tick + BigRational::one();
    let lo = Ord::max(coarse.lo(), &tick).clone();
    // The enclosure may touch the next tick from below: that is its closure.
    let hi = Ord::min(coarse.hi(), &above).clone();
    Ok(enclosed(&Interval::hull(lo, hi)))
}

/// The interval rounded outward to a grid, small enough for machine integers.
fn on_grid(range: &Interval<BigRational>) -> Interval<BigRational> {
    /// Steps of the grid per tick, or per KΔ, as a power of two.
    const GRID_BITS: u32 = 40;
    let grid = BigRational::from_integer(BigInt::from(1_u64 << GRID_BITS));
    Interval::hull(
        (range.lo() * &grid).floor() / &grid,
        (range.hi() * &grid).ceil() / &grid,
    )
}

fn enclosed(range: &Interval<BigRational>) -> Reading {
    Reading::Within(Box::new(range.clone()))
}
