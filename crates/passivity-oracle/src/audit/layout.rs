//! The columns of a trace: which there are, in which units, and how their values become ticks,
//! sampling periods and KΔ.

use passivity_core::{BigRational, Scalar};
use passivity_scene::units::{Dimension, Unit};
use passivity_scene::{Motion, Scene, number, pi};

use crate::audit::error::{TraceError, shown};
use crate::ledger::Sample;
use crate::number::{Number, difference, quotient};

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
    pub(crate) scale: Scale,
    /// Units of time over the sampling period.
    per_period: Number,
    /// Units of force over KΔ, rounded: forces are measured.
    pub(crate) per_force: f64,
}

/// How a position becomes ticks.
#[derive(Clone, Debug)]
pub(crate) enum Scale {
    /// It is in ticks.
    Ticks,
    /// By a rational factor.
    Factor(BigRational),
    /// By a rational factor times a power of π.
    Pi(BigRational, i8),
}

impl Layout {
    /// Reads the names of the columns.
    pub(crate) fn read(names: Vec<String>, scene: &Scene) -> Result<Self, TraceError> {
        let header = |message: String| TraceError::new("header", message);
        if names.len() > MAX_COLUMNS {
            return Err(header(format!("a trace may have {MAX_COLUMNS} columns")));
        }
        let find = |base: &str| -> Result<Option<(usize, Option<&str>)>, TraceError> {
            let mut found = None;
            for (i, name) in names.iter().enumerate() {
                let (stem, unit) = split(name);
                if stem != base {
                    continue;
                }
                if found.is_some() {
                    return Err(header(format!("the column `{base}` is there twice")).column(name));
                }
                found = Some((i, unit));
            }
            Ok(found)
        };
        let ledger = match (find("xi0")?, find("xi1")?) {
            (Some((start, _)), Some((end, _))) => Some((start, end)),
            _ => None,
        };
        // A ledger may repeat where its intervals start as `xi`: its own columns say more.
        let other = |column| {
            if ledger.is_some() {
                Ok(None)
            } else {
                find(column)
            }
        };
        let forms = [
            (Form::Xi, other("xi")?),
            (Form::X, other("x")?),
            (Form::Count, other("count")?),
            (Form::Ledger, ledger.map(|(start, _)| (start, None))),
        ];
        let mut present = forms
            .iter()
            .filter_map(|(form, column)| column.map(|column| (*form, column)));
        let Some((form, (position, unit))) = present.next() else {
            let found = names.iter().take(8).map(|n| shown(n.as_bytes()));
            let found = found.collect::<Vec<_>>().join("`, `");
            return Err(header(format!(
                "expected a column `xi`, `x [unit]` or `count`, found `{found}`"
            )));
        };
        if let Some((other, _)) = present.next() {
            return Err(header(format!(
                "expected one of `xi`, `x [unit]` and `count`, found `{}` and `{}`",
                form.name(),
                other.name()
            )));
        }
        let has_encoder = scene.resolution.is_some();
        if form == Form::Count && !has_encoder {
            return Err(header("counts need a scene with an encoder".to_owned()).column("count"));
        }
        let name_of = |i: usize| names.get(i).cloned().unwrap_or_default();
        let scale = match (form, unit) {
            (Form::X, unit) => {
                position_scale(unit, scene).map_err(|e| e.column(name_of(position)))?
            }
            (_, Some(_)) => {
                let message = "ticks have no unit: `x [unit]` is for positions with one";
                return Err(header(message.to_owned()).column(name_of(position)));
            }
            (_, None) => Scale::Ticks,
        };
        let time = find("t")?;
        let per_period = match time {
            Some((i, unit)) => time_scale(unit, scene).map_err(|e| e.column(name_of(i)))?,
            None => Number::whole(1),
        };
        let time = time.or(find("tau")?).map(|(i, _)| i);
        let force = match form {
            // A ledger's own columns say nothing of the force.
            Form::Ledger => None,
            _ => find("f")?,
        };
        let per_force = match force {
            Some((i, unit)) => force_scale(unit, scene).map_err(|e| e.column(name_of(i)))?,
            None => 1.0,
        };
        Ok(Self {
            form,
            position,
            end: ledger.filter(|_| form == Form::Ledger).map(|(_, end)| end),
            dtau: match form {
                Form::Ledger => find("dtau")?.map(|(i, _)| i),
                _ => None,
            },
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
    pub(crate) fn name(&self, column: usize) -> &str {
        self.names.get(column).map_or("", String::as_str)
    }

    /// Δτ between two times; `None` unless the second is later.
    pub(crate) fn duration(&self, from: &Number, to: &Number) -> Option<Number> {
        let dt = difference(to, from);
        let positive = match &dt {
            Number::Small(n, _) => *n > 0,
            Number::Big(x) => num_traits::Signed::is_positive(&**x),
        };
        positive.then(|| quotient(&dt, &self.per_period))
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

    /// A position as a sample.
    pub(crate) fn sample(&self, x: Number) -> Result<Sample, TraceError> {
        match &self.scale {
            Scale::Ticks => Ok(Sample::Exact(x)),
            Scale::Factor(factor) => Ok(Sample::Exact(Number::from(x.to_rational() * factor))),
            Scale::Pi(factor, power) => within_a_tick(&(x.to_rational() * factor), *power),
        }
    }
}

/// `x [rad]` as `x` and `rad`.
fn split(name: &str) -> (&str, Option<&str>) {
    match name.split_once('[') {
        Some((stem, rest)) => {
            let unit = rest.trim_end().strip_suffix(']').unwrap_or(rest);
            (stem.trim(), Some(unit.trim()))
        }
        None => (name.trim(), None),
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
    let (length, length_pi) = match &scene.resolution {
        Some(given) => (given.nominal.range().lo().clone(), given.nominal.pi_power()),
        None => (BigRational::one(), 0),
    };
    let factor = unit.scale() / length;
    match unit.pi_power() - length_pi {
        0 => Ok(Scale::Factor(factor)),
        _ if scene.resolution.is_none() => {
            let message = "without an encoder positions must be in radians or metres";
            Err(TraceError::new("unit", message))
        }
        power => Ok(Scale::Pi(factor, power)),
    }
}

fn time_scale(text: Option<&str>, scene: &Scene) -> Result<Number, TraceError> {
    needs_units(scene, "tau")?;
    let unit = unit(text, "t [s]")?;
    if unit.dimension() != Dimension::new(0, 0, 1, 0) {
        let message = "expected a unit of time, such as `s`";
        return Err(TraceError::new("unit", message));
    }
    let period = scene.period.nominal.middle();
    Ok(Number::from(period / unit.scale()))
}

fn force_scale(text: Option<&str>, scene: &Scene) -> Result<f64, TraceError> {
    let Some(_) = text else {
        if scene.motion == Motion::Dimensionless {
            return Ok(1.0);
        }
        return Err(unit(text, "f [N]")
            .err()
            .unwrap_or_else(|| TraceError::new("unit", "unit")));
    };
    needs_units(scene, "f")?;
    let unit = unit(text, "f [N]")?;
    expect(&unit, Dimension::new(1, 1, -2, 0), scene, "a force")?;
    let units = scene.point().units;
    Ok(number::nearest_f64(
        &(unit.scale() / (units.stiffness * units.length)),
    ))
}

/// x·π^power, enclosed on a fine grid within one tick.
fn within_a_tick(x: &BigRational, power: i8) -> Result<Sample, TraceError> {
    /// Steps of the grid per tick, as a power of two: small enough for machine integers.
    const GRID_BITS: u32 = 40;
    if num_traits::Zero::is_zero(x) {
        return Ok(Sample::Exact(Number::whole(0)));
    }
    let grid = BigRational::from_integer(num_bigint::BigInt::from(1_u64 << GRID_BITS));
    for level in 3..=pi::MAX_LEVEL {
        let pi = pi::enclosure(level);
        let exponent = i32::from(power);
        let (a, b) = (x * pi.lo().pow(exponent), x * pi.hi().pow(exponent));
        let (lo, hi) = if a < b { (a, b) } else { (b, a) };
        if lo.floor() != hi.floor() {
            continue;
        }
        let coarse = ((&lo * &grid).floor() / &grid, (&hi * &grid).ceil() / &grid);
        // On the grid the enclosure may touch the next tick from below: its closure.
        let ends = if coarse.1 <= lo.floor() + BigRational::one() {
            coarse
        } else {
            (lo, hi)
        };
        return Ok(Sample::Within(Box::new(ends)));
    }
    let message = "too close to the border between two ticks to tell which it is in";
    Err(TraceError::new("position", message))
}
