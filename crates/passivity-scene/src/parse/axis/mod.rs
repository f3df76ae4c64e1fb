//! A parameter as an axis: named on the command line or in the header of a table, with its unit and, behind
//! a transmission, the side on which it is.

mod named;
mod side;
#[cfg(test)]
mod tests;

use std::fmt;

use passivity_core::parameter::Values;
use passivity_core::{BigRational, Exact, Interval, Ordered as _, Parameter, Scalar as _};

use self::named::{Named, unit_written};
use self::side::{At, Place};
use crate::check::{enclosure, unit_of};
use crate::display::range;
use crate::number;
use crate::parse::controller::{nothing_to_filter, two_laws};
use crate::parse::measure::Measure;
use crate::parse::reader::Spec;
use crate::scene::{Given, Motion, Scene};
use crate::written::{Form, Written};

/// A parameter as the axis of a plane or of a sweep, in the unit in which its figures are written.
///
/// # Example
///
/// ```
/// use passivity_scene::{Axis, Scene};
///
/// let text = "[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"2 N/mm\"\n";
/// let scene = Scene::from_toml("spring", text).unwrap();
/// assert_eq!(Axis::parse("stiffness", &scene).unwrap().column(), "stiffness [N/mm]");
/// assert_eq!(Axis::parse("damping [N s/m]", &scene).unwrap().column(), "damping [N s/m]");
/// let error = Axis::parse("stiffness [N]", &scene).unwrap_err().to_string();
/// assert!(error.starts_with("`stiffness [N]`: the unit is that of a force"), "{error}");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    parameter: Parameter,
    key: &'static str,
    written: Written,
    motion: Motion,
    /// Whether the side is said though it is the device's: a reader might take the other.
    says_device: bool,
    /// What the other side of the transmission adds to every value: of an inertia.
    rest: Option<Exact>,
}

/// Why a text names no axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AxisError {
    message: String,
}

impl fmt::Display for AxisError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for AxisError {}

/// A key without its section, as it is named on the command line.
fn short(key: &str) -> &str {
    key.split_once('.').map_or(key, |(_, name)| name)
}

/// The parameter of a name, with or without its section, and the key that it has then.
fn find(name: &str) -> Option<(Parameter, &'static str)> {
    keys().find(|(_, key)| *key == name || short(key) == name)
}

/// Every key of a parameter, the dimensionless one as well.
fn keys() -> impl Iterator<Item = (Parameter, &'static str)> {
    let rows = Parameter::ALL.iter().map(|p| (*p, p.row()));
    rows.filter(|(_, row)| !row.key.is_empty())
        .flat_map(|(parameter, row)| {
            let keys = [row.key].into_iter().chain(row.other_keys.iter().copied());
            let keys = keys.chain(row.dimensionless_key);
            keys.map(move |key| (parameter, key))
        })
}

/// Why a parameter cannot be on an axis, of those that one use of axes has no place for.
type Refusal = fn(Parameter) -> Option<&'static str>;

impl Axis {
    /// Reads `stiffness`, `wall.stiffness`, `stiffness [N/mm]` or `coulomb [mN m at the motor]`: a key of
    /// the scene file, with or without its section, and a unit; without one that of the scene file, or SI.
    ///
    /// What can be at either side of a transmission is at the one where the scene gives it, unless the
    /// section of the key says which, as in `motor.coulomb`, or `at the motor` or `at the device` behind the
    /// unit.
    ///
    /// # Errors
    ///
    /// A name that no parameter has, or a unit or a side that does not fit it.
    pub fn parse(text: &str, scene: &Scene) -> Result<Self, AxisError> {
        Self::parse_for(text, scene, |_| None)
    }

    /// The same where not every parameter can be on an axis.
    ///
    /// # Errors
    ///
    /// Those of [`Axis::parse`], and a parameter that is refused. A name that is none is told which there are, without
    /// those that are refused or that the scene cannot have.
    pub fn parse_for(text: &str, scene: &Scene, refusal: Refusal) -> Result<Self, AxisError> {
        let shown: String = text.chars().take(80).collect();
        let fail = |message: String| AxisError {
            message: format!("`{shown}`: {message}"),
        };
        let named = Named::of(text).map_err(fail)?;
        let (parameter, key) = find(named.name).ok_or_else(|| {
            let names = Self::names(scene, refusal).join(", ");
            fail(format!("expected a parameter: one of {names}"))
        })?;
        if let Some(why) = refusal(parameter) {
            let names = Self::names(scene, refusal).join(", ");
            let message = format!("`{}` {why}: expected one of {names}", named.name);
            return Err(AxisError { message });
        }
        Self::of(parameter, key, &named, scene).map_err(fail)
    }

    /// The names of what can be an axis of the scene, each once: a value at the motor may be named like the one at
    /// the device.
    fn names(scene: &Scene, refusal: Refusal) -> Vec<&'static str> {
        let mut names: Vec<&str> = Vec::new();
        for (_, key) in keys() {
            let name = short(key);
            let works = || {
                let (parameter, key) = find(name).filter(|(p, _)| refusal(*p).is_none())?;
                let axis = Self::of(parameter, key, &Named::of(name).ok()?, scene).ok()?;
                Self::fit(&[axis], scene).ok()
            };
            if !names.contains(&name) && works().is_some() {
                names.push(name);
            }
        }
        names
    }

    fn of(
        parameter: Parameter,
        key: &'static str,
        named: &Named<'_>,
        scene: &Scene,
    ) -> Result<Self, String> {
        let dimensionless = scene.motion == Motion::Dimensionless;
        let is_unit = [
            Parameter::Stiffness,
            Parameter::Period,
            Parameter::Resolution,
        ];
        if dimensionless && is_unit.contains(&parameter) {
            let name = &scene.name;
            return Err(format!("it is 1 in `{name}`, a dimensionless scene"));
        }
        if !dimensionless && key.starts_with("dimensionless.") {
            let name = &scene.name;
            let key = short(parameter.row().key);
            return Err(format!("`{name}` has units: expected `{key}`"));
        }
        let place = Place::of(parameter, key, named, scene)?;
        let key = place.key;
        if key == "encoder.counts_per_revolution"
            && scene.motion == Motion::Linear
            && place.at == At::Device
        {
            let or_motor = match scene.transmission {
                Some(_) => ", or `counts_per_revolution [at the motor]`",
                None => "",
            };
            let name = &scene.name;
            return Err(format!(
                "`{name}` is linear: expected `resolution`{or_motor}"
            ));
        }
        if key == "device.mass" && scene.motion == Motion::Rotary {
            return Err(format!("`{}` is rotary: expected `inertia`", scene.name));
        }
        let form = match key {
            "sampling.rate" => Form::Reciprocal,
            "encoder.counts_per_revolution" => Form::Count,
            "wall.damping_cutoff" => Form::Cutoff,
            _ => Form::Value,
        };
        let measure = Spec::new(parameter, key).measure;
        let given = scene.given.get(parameter);
        let own = given.and_then(|given| given.part(place.at == At::Motor));
        let own = own.map(|own| &own.written);
        let written = match own {
            Some(written) if named.unit.is_empty() && written.form() == form => written.clone(),
            _ => {
                let usual = match measure {
                    _ if form == Form::Count || dimensionless => "",
                    Measure::Time => "ms",
                    Measure::Rate => "Hz",
                    _ => unit_of(parameter, place.at.motion(scene)),
                };
                let unit = match named.unit {
                    "" => usual,
                    unit => unit,
                };
                let written = |at: At| unit_written(unit, form, measure, at.motion(scene));
                let typed = written(place.at).map_err(|wrong| {
                    let other = place.at.other();
                    match place.is_free && written(other).is_ok() {
                        true => format!(
                            "{wrong} {}; for a value at the other side write `{unit} {other}`",
                            place.at
                        ),
                        false => wrong,
                    }
                })?;
                match &place.factor {
                    Some(factor) => typed.at_motor(factor),
                    None => typed,
                }
            }
        };
        // The inertia of a scene is the sum of both sides; all else is whole on one.
        let rest = given.filter(|_| parameter == Parameter::Inertia);
        let rest = rest.and_then(|given| given.part(place.at == At::Device));
        Ok(Self {
            parameter,
            key,
            written,
            motion: scene.motion,
            says_device: place.says_device,
            rest: rest.map(|rest| rest.nominal.clone()),
        })
    }

    /// Whether a scene can have these parameters together, as where they are typed into its file.
    ///
    /// # Errors
    ///
    /// Damping beside a controller, or a filter without the damping that it filters.
    pub fn fit(axes: &[Self], scene: &Scene) -> Result<(), AxisError> {
        let axis = |parameter| axes.iter().find(|axis| axis.parameter == parameter);
        let [damping, filter] = [Parameter::Damping, Parameter::DampingTimeConstant].map(axis);
        let is_damped = damping.is_some() || scene.given.damping.is_some();
        let wrong = two_laws(scene.given.controller.is_some(), damping.is_some())
            .or_else(|| nothing_to_filter(filter.is_some(), is_damped));
        match (wrong, damping.or(filter)) {
            (Some(wrong), Some(axis)) => Err(AxisError {
                message: format!("`{}`: {} in `{}`", axis.name(), wrong.message(), scene.name),
            }),
            _ => Ok(()),
        }
    }

    /// The parameter.
    #[must_use]
    pub const fn parameter(&self) -> Parameter {
        self.parameter
    }

    /// The key without its section, as in `stiffness`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        short(self.key)
    }

    /// The key with its section, as in `wall.stiffness`.
    #[must_use]
    pub const fn key(&self) -> &'static str {
        self.key
    }

    /// The unit with the side of a transmission where it has to be said; empty for a plain number.
    #[must_use]
    pub fn unit(&self) -> String {
        let side = if self.says_device {
            " at the device"
        } else {
            ""
        };
        format!("{}{side}", self.written.unit()).trim().to_owned()
    }

    /// Whether the text that names the axis leaves out its unit.
    #[must_use]
    pub fn lacks_unit(&self, text: &str) -> bool {
        self.written.has_unit() && Named::of(text).is_ok_and(|named| named.unit.is_empty())
    }

    /// Whether the numbers are the same values in a scene: it has the same transmission, or none is between,
    /// and gives the parameter at the same side where the column names none.
    #[must_use]
    pub fn is_of(&self, scene: &Scene) -> bool {
        Self::parse(&self.column(), scene).is_ok_and(|axis| axis.written == self.written)
    }

    /// The column of the same parameter at the device, in SI.
    #[must_use]
    pub fn at_device(&self) -> String {
        let row = self.parameter.row();
        let key = if self.key.starts_with("motor.") || self.is_whole() {
            row.key
        } else {
            self.key
        };
        format!(
            "{} [{} at the device]",
            short(key),
            unit_of(self.parameter, self.motion)
        )
    }

    /// Whether the same numbers are the same values on another axis of the parameter.
    pub(crate) fn is_scaled_as(&self, other: &Self) -> bool {
        self.written == other.written && self.rest == other.rest
    }

    /// The name and the unit as the header of a table has them, `stiffness [N/mm]`.
    #[must_use]
    pub fn column(&self) -> String {
        match self.unit().as_str() {
            "" => self.name().to_owned(),
            unit => format!("{} [{unit}]", self.name()),
        }
    }

    /// The words and the letter for a picture, `stiffness K (N/mm)`.
    #[must_use]
    pub fn label(&self) -> String {
        let row = self.parameter.row();
        let dimensionless = self.motion == Motion::Dimensionless;
        let symbol = row.dimensionless_symbol.filter(|_| dimensionless);
        let symbol = symbol.unwrap_or(row.symbol);
        let words = match self.written.form() {
            Form::Reciprocal => format!("sampling rate 1/{symbol}"),
            Form::Count => format!("counts per revolution 2π/{symbol}"),
            Form::Cutoff => format!("cutoff of the damping filter 1/(2π{symbol})"),
            Form::Value => format!("{} {symbol}", row.name),
        };
        match self.unit().as_str() {
            "" => words,
            unit => format!("{words} ({unit})"),
        }
    }

    /// Whether only whole numbers can be written.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.written.form() == Form::Count
    }

    /// Whether a larger number on the axis is a smaller parameter.
    #[must_use]
    pub fn is_reciprocal(&self) -> bool {
        self.written.form() != Form::Value
    }

    /// Whether zero is a number of the axis.
    #[must_use]
    pub fn has_zero(&self) -> bool {
        !self.is_reciprocal() && self.parameter.row().values != Values::Positive
    }

    /// The SI value of a number on the axis, with what the other side adds of an inertia; `None` for one
    /// that the parameter cannot have.
    #[must_use]
    pub fn si(&self, number: &BigRational) -> Option<Exact> {
        let allowed = self.parameter.row().values.allow(number.sign()?);
        let zero = self.is_reciprocal() && number.sign()?.is_eq();
        let typed = (allowed && !zero).then(|| self.written.typed(number))?;
        Some(match &self.rest {
            Some(rest) => typed + rest.clone(),
            None => typed,
        })
    }

    /// The numbers on the axis of SI values; `None` for the reciprocal of zero.
    #[must_use]
    pub fn numbers(&self, si: &Interval<BigRational>) -> Option<Interval<BigRational>> {
        let Some(rest) = &self.rest else {
            return self.written.of(si);
        };
        let rest = enclosure(&Interval::point(rest.clone()))?;
        let [lo, hi] = [si.lo() - rest.hi(), si.hi() - rest.lo()];
        self.written.of(&Interval::hull(lo, hi))
    }

    /// What a scene gives of the parameter: of an inertia the part at the axis's side.
    fn own<'s>(&self, scene: &'s Scene) -> Option<&'s Given> {
        let given = scene.given.get(self.parameter)?;
        match self.parameter {
            Parameter::Inertia => given.part(self.written.is_at_motor()),
            _ => Some(given),
        }
    }

    /// Where a scene stands on the axis, over its tolerance; zero for an absent effect, `None` where
    /// the axis cannot show it.
    #[must_use]
    pub fn of_scene(&self, scene: &Scene) -> Option<Interval<BigRational>> {
        match self.own(scene) {
            Some(given) => self.written.of(&enclosure(&given.value)?),
            None => self
                .has_zero()
                .then(|| Interval::point(BigRational::zero())),
        }
    }

    /// Numbers of the axis with their unit, for people.
    #[must_use]
    pub fn range_text(&self, numbers: &Interval<BigRational>) -> String {
        format!("{} {}", range(numbers), self.unit())
            .trim_end()
            .to_owned()
    }

    /// Reads a number of the axis.
    ///
    /// # Errors
    ///
    /// Text that is no number, or a number that the parameter cannot have.
    pub fn number(&self, text: &str) -> Result<BigRational, AxisError> {
        let fail = |message: String| AxisError {
            message: format!("`{}` = `{text}`: {message}", self.name()),
        };
        let number = number::parse(text.trim()).map_err(|error| fail(error.to_string()))?;
        if self.si(&number).is_none() {
            let expected = match self.is_reciprocal() {
                true => Values::Positive.expected(),
                false => self.parameter.row().values.expected(),
            };
            return Err(fail(format!("expected {expected}")));
        }
        if self.is_whole() && !number.is_integer() {
            return Err(fail("expected a whole number".to_owned()));
        }
        Ok(number)
    }
}
