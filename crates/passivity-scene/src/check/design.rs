//! Which rates and encoders allow how stiff a wall: the choices of a designer in one table.

use num_traits::Signed as _;
use passivity_core::verdict::Speeds;
use passivity_core::{BigRational, Enclosed, Exact, Interval, Loop, Parameter, Wide};
use schemars::JsonSchema;
use serde::Serialize;

use super::limits::{self, Limit};
use super::{Report, check};
use crate::diagnostic::SceneError;
use crate::display::{Rounding, approx, rounded};
use crate::json::shape;
use crate::parse::{MAX_COUNTS, MAX_NUMBER_EXPONENT};
use crate::scene::{Given, Motion, Scene};
use crate::written::Form;

/// A value of the sampling period or the encoder's resolution.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Setting {
    /// How the scene file would write it, with its unit.
    pub text: String,
    /// Whether it is the scene's own.
    pub is_now: bool,
    #[serde(skip)]
    value: Interval<Exact>,
}

/// The stiffest wall at a rate and an encoder.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Stiffest {
    /// As the scene file would write it, without the unit: typed there, it passes.
    pub typed: String,
    /// The same in N/m or N·m/rad.
    #[serde(with = "shape::Rational")]
    pub si: BigRational,
    /// Whether it is as stiff as the scene's own wall, or stiffer.
    pub is_enough: bool,
}

/// The stiffest wall for each of some rates and each of some encoders.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Design {
    /// The scene's name.
    pub scene: String,
    /// The speeds at which the walls are passive, in words.
    pub speeds: String,
    /// The unit of `typed`; K, the scene's own stiffness, for a dimensionless one.
    pub unit: String,
    /// The scene's own stiffness, as it was given.
    pub asked: String,
    /// The sampling rates or periods, a row each.
    pub rates: Vec<Setting>,
    /// The encoders, a column each; empty where the scene has none.
    pub encoders: Vec<Setting>,
    /// The stiffest walls, by row and column; `None` where none is passive.
    pub stiffest: Vec<Vec<Option<Stiffest>>>,
}

/// The stiffest walls of a scene for other rates and encoders; without a list, for quarters up to
/// eightfold of what it has.
///
/// # Errors
///
/// [`SceneError`] when a text of `rates` or `encoders` is no rate, period, resolution or count.
///
/// # Example
///
/// ```
/// use passivity_scene::{Scene, check::design};
///
/// let text = r#"
///     [device]
///     viscous = "1 N s/m"
///     [sampling]
///     rate = "1 kHz"
///     [wall]
///     stiffness = "1 N/mm"
/// "#;
/// let scene = Scene::from_toml("viscous", text).unwrap();
/// let table = design(&scene, &["2 kHz".to_owned()], &[]).unwrap();
/// // K ≤ 2b/T, Colgate's bound: there is no encoder.
/// assert_eq!(table.stiffest[0][0].as_ref().unwrap().typed, "4");
/// ```
pub fn design(scene: &Scene, rates: &[String], encoders: &[String]) -> Result<Design, SceneError> {
    let rates = settings(scene, &scene.given.period, rates)?;
    let encoders = match &scene.given.resolution {
        Some(resolution) => settings(scene, resolution, encoders)?,
        None => Vec::new(),
    };
    let report = check(scene);
    let bounds = scene.bounds();
    let stiffest = rates
        .iter()
        .map(|rate| {
            let bounds = bounds.clone().with(Parameter::Period, rate.value.clone());
            let cell = |bounds| stiffest(scene, &bounds, &report);
            if encoders.is_empty() {
                return vec![cell(bounds)];
            }
            let columns = encoders.iter().map(|encoder| {
                cell(
                    bounds
                        .clone()
                        .with(Parameter::Resolution, encoder.value.clone()),
                )
            });
            columns.collect()
        })
        .collect();
    Ok(Design {
        scene: scene.name.clone(),
        speeds: report.speeds_text(),
        unit: match scene.motion {
            Motion::Dimensionless => "K".to_owned(),
            _ => scene.given.stiffness.written.unit().trim().to_owned(),
        },
        asked: match scene.given.stiffness.text.as_str() {
            // What a dimensionless scene does not write is the unit.
            "" => "1 K".to_owned(),
            text => text.to_owned(),
        },
        rates,
        encoders,
        stiffest,
    })
}

/// What the unit of a value ends with that the scene gives at the motor's side of a transmission.
const AT_MOTOR: &str = " at the motor";

/// The values that texts give, or, without any, what is and factors of two of it.
fn settings(scene: &Scene, now: &Given, texts: &[String]) -> Result<Vec<Setting>, SceneError> {
    let of = |text: &String| {
        let given = scene.reread(now, text)?;
        let mut text = text.trim().to_owned();
        // No text that is typed says this: where the scene has its own does.
        if now.written.unit().ends_with(AT_MOTOR) {
            text.push_str(AT_MOTOR);
        }
        Ok(Setting {
            text,
            is_now: given.value == now.value,
            value: given.value,
        })
    };
    if texts.is_empty() {
        let doubled: Vec<String> = (-2..=3).filter_map(|power| doubled(now, power)).collect();
        return doubled.iter().map(of).collect();
    }
    texts.iter().map(of).collect()
}

/// The rate, or the fineness of the encoder, of a scene, doubled so many times, as the scene file would
/// write it: in few digits, of which the wall beside it is then computed. The scene's own value is as exact
/// as in the file. `None` for what the file cannot write.
fn doubled(own: &Given, power: i32) -> Option<String> {
    let form = own.written.form();
    let exponent = if form == Form::Value { -power } else { power };
    let factor = BigRational::from_integer(2.into()).pow(exponent);
    let written = own.written.of(&super::enclosure(&own.value)?)?;
    let (lo, hi) = (written.lo() * &factor, written.hi() * &factor);
    let text = match form {
        Form::Count => whole(&written.middle() * &factor)?,
        _ if own.has_tolerance() => format!(
            "{} … {}",
            rounded(&lo, 5, Rounding::Down),
            rounded(&hi, 5, Rounding::Up)
        ),
        _ => approx(&(written.middle() * &factor)),
    };
    // Of what has no text in the file, as the period of a scene without units, a few digits say all.
    let says_all = form == Form::Count
        || own.text.is_empty()
        || crate::number::parse(&text).is_ok_and(|x| lo == x && hi == x);
    if power == 0 && !says_all {
        return Some(own.text.clone());
    }
    let is_in_bounds = |(_, exponent): (&str, &str)| {
        let exponent = exponent.parse::<i32>().map(i32::unsigned_abs);
        exponent.is_ok_and(|exponent| exponent <= MAX_NUMBER_EXPONENT)
    };
    let mut exponents = text.split(" … ").filter_map(|x| x.split_once('e'));
    let unit = own.written.unit();
    let unit = unit.strip_suffix(AT_MOTOR).unwrap_or(&unit);
    exponents.all(is_in_bounds).then(|| format!("{text}{unit}"))
}

/// Counts, which are whole: where the nearest whole number is not what is asked for, or is more than an
/// encoder has, there is no such encoder. What is known of it up to many digits of π is near enough.
fn whole(counts: BigRational) -> Option<String> {
    let nearest = counts.round();
    let error = &counts - &nearest;
    let small = BigRational::new(1.into(), (1u64 << 40).into());
    let is_near = -small.clone() < error && error < small;
    let most = BigRational::from_integer(MAX_COUNTS.into());
    (is_near && nearest <= most).then(|| nearest.to_string())
}

/// The stiffest wall of a loop at the speeds that the scene's limits are for.
fn stiffest(scene: &Scene, bounds: &Loop<Interval<Exact>>, report: &Report) -> Option<Stiffest> {
    fn limit<S: Enclosed>(
        scene: &Scene,
        bounds: &Loop<Interval<S>>,
        every_speed: bool,
    ) -> Option<Limit> {
        let speeds = if every_speed {
            Speeds::All
        } else {
            bounds.speeds()
        };
        limits::limit(Parameter::Stiffness, scene, bounds, &speeds)
    }
    let limit = match bounds.try_map(|_, range| range.try_map(Wide::of)) {
        Some(wide) => limit(scene, &wide, report.at_every_speed),
        None => limit(scene, bounds, report.at_every_speed),
    }?;
    let typed = limit.typed.clone().or_else(|| {
        let written = &scene.given.stiffness.written;
        written.rounded(limit.hardest(), 5, Rounding::Down)
    })?;
    limit.printed.as_ref()?;
    let number = crate::number::parse(&typed).ok()?;
    let si = scene.given.stiffness.written.typed(&number);
    let si = si.enclosure(super::BITS)?.lo().clone();
    let asked = scene.given.stiffness.value.hi().enclosure(super::BITS)?;
    Some(Stiffest {
        is_enough: !(asked.lo() - limit.hardest()).is_positive(),
        typed,
        si,
    })
}

impl Design {
    /// The table for people.
    #[must_use]
    pub fn to_text(&self) -> String {
        let head = |setting: &Setting| {
            let now = if setting.is_now { " (now)" } else { "" };
            format!("{}{now}", setting.text)
        };
        let mut rows: Vec<Vec<String>> = Vec::new();
        let mut first = vec![String::new()];
        first.extend(self.encoders.iter().map(head));
        if self.encoders.is_empty() {
            first.push("no encoder".to_owned());
        }
        rows.push(first);
        for (rate, cells) in self.rates.iter().zip(&self.stiffest) {
            let mut row = vec![head(rate)];
            row.extend(cells.iter().map(|cell| match cell {
                None => "–".to_owned(),
                Some(cell) if cell.is_enough => format!("{} *", cell.typed),
                Some(cell) => format!("{}  ", cell.typed),
            }));
            rows.push(row);
        }
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |column: usize| {
            let cells = rows.iter().filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..columns).map(width).collect();
        let mut out = format!(
            "{}: the stiffest wall in {} that is passive {}\n",
            self.scene, self.unit, self.speeds
        );
        for row in &rows {
            let padded = row.iter().zip(&widths).map(|(cell, width)| {
                let gap = width - cell.chars().count();
                format!("{}{cell}", " ".repeat(gap))
            });
            let line = padded.collect::<Vec<_>>().join("   ");
            out.push_str(&format!("  {}\n", line.trim_end()));
        }
        out.push_str(&format!(
            "  * as stiff as the wall of the scene, {}, or stiffer; – no wall is passive\n",
            self.asked
        ));
        out
    }

    /// The table as CSV: rate, encoder, the stiffest wall; empty where none is passive.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let mut out = format!("rate,encoder,stiffness [{}],enough\n", self.unit);
        for (rate, cells) in self.rates.iter().zip(&self.stiffest) {
            let names = self.encoders.iter().map(|encoder| encoder.text.as_str());
            let names = names.chain(self.encoders.is_empty().then_some(""));
            for (encoder, cell) in names.zip(cells) {
                let (typed, enough) = match cell {
                    Some(cell) => (cell.typed.as_str(), cell.is_enough),
                    None => ("", false),
                };
                out.push_str(&format!("{},{encoder},{typed},{enough}\n", rate.text));
            }
        }
        out
    }
}
