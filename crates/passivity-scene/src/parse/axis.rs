//! A parameter as an axis: named on the command line or in the header of a table, with its unit.

use std::fmt;

use passivity_core::parameter::Values;
use passivity_core::{BigRational, Exact, Interval, Ordered as _, Parameter, Scalar as _};

use crate::check::{enclosure, unit_of};
use crate::display::range;
use crate::number;
use crate::parse::amount::Amount;
use crate::parse::controller::{nothing_to_filter, two_laws};
use crate::parse::measure::{Measure, describe};
use crate::parse::reader::Spec;
use crate::scene::{Motion, Scene};
use crate::units::Unit;
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

/// Every key of a parameter, the dimensionless one as well.
fn keys() -> impl Iterator<Item = (Parameter, &'static str)> {
    let rows = Parameter::ALL.iter().map(|p| (*p, p.row()));
    rows.filter(|(_, row)| !row.key.is_empty())
        .flat_map(|(parameter, row)| {
            let keys = [row.key].into_iter().chain(row.other_keys.iter().copied());
            let keys = keys.chain(row.dimensionless_key);
            // A value at the motor is named like the one at the device.
            let keys = keys.filter(|key| !key.starts_with("motor."));
            keys.map(move |key| (parameter, key))
        })
}

impl Axis {
    /// Reads `stiffness`, `wall.stiffness` or `stiffness [N/mm]`: a key of the scene file, with or
    /// without its section, and a unit; without one that of the scene file, or SI.
    ///
    /// # Errors
    ///
    /// A name that no parameter has, or a unit that does not fit it.
    pub fn parse(text: &str, scene: &Scene) -> Result<Self, AxisError> {
        let shown: String = text.chars().take(80).collect();
        let fail = |message: String| AxisError {
            message: format!("`{shown}`: {message}"),
        };
        let (name, unit) = match text.trim().split_once('[') {
            None => (text.trim(), None),
            Some((name, rest)) => {
                let unit = rest.strip_suffix(']');
                let unit = unit.ok_or_else(|| fail("the unit needs its closing `]`".to_owned()))?;
                (name.trim(), Some(unit.trim()))
            }
        };
        let found = keys().find(|(_, key)| *key == name || short(key) == name);
        let (parameter, key) = found.ok_or_else(|| {
            let names: Vec<&str> = keys().map(|(_, key)| short(key)).collect();
            fail(format!("expected a parameter: one of {}", names.join(", ")))
        })?;
        Self::of(parameter, key, unit, scene).map_err(fail)
    }

    fn of(
        parameter: Parameter,
        key: &'static str,
        unit: Option<&str>,
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
        if key == "encoder.counts_per_revolution" && scene.motion == Motion::Linear {
            let name = &scene.name;
            return Err(format!("`{name}` is linear: expected `resolution`"));
        }
        let form = match key {
            "sampling.rate" => Form::Reciprocal,
            "encoder.counts_per_revolution" => Form::Count,
            "wall.damping_cutoff" => Form::Cutoff,
            _ => Form::Value,
        };
        let given = scene.given.get(parameter).map(|given| &given.written);
        let written = match (unit, given) {
            (None, Some(written)) if written.form() == form => written.clone(),
            (Some(unit), _) => unit_written(unit, form, Spec::new(parameter, key).measure, scene)?,
            (None, _) => {
                let measure = Spec::new(parameter, key).measure;
                let usual = match measure {
                    _ if form == Form::Count || dimensionless => "",
                    Measure::Time => "ms",
                    Measure::Rate => "Hz",
                    _ => unit_of(parameter, scene.motion),
                };
                unit_written(usual, form, measure, scene)?
            }
        };
        Ok(Self {
            parameter,
            key,
            written,
            motion: scene.motion,
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

    /// The unit, empty for a plain number.
    #[must_use]
    pub fn unit(&self) -> String {
        self.written.unit().trim().to_owned()
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

    /// The SI value of a number on the axis; `None` for one that the parameter cannot have.
    #[must_use]
    pub fn si(&self, number: &BigRational) -> Option<Exact> {
        let allowed = self.parameter.row().values.allow(number.sign()?);
        let zero = self.is_reciprocal() && number.sign()?.is_eq();
        (allowed && !zero).then(|| self.written.typed(number))
    }

    /// The numbers on the axis of SI values; `None` for the reciprocal of zero.
    #[must_use]
    pub fn numbers(&self, si: &Interval<BigRational>) -> Option<Interval<BigRational>> {
        self.written.of(si)
    }

    /// Where a scene stands on the axis, over its tolerance; zero for an absent effect, `None` where
    /// the axis cannot show it.
    #[must_use]
    pub fn of_scene(&self, scene: &Scene) -> Option<Interval<BigRational>> {
        match scene.given.get(self.parameter) {
            Some(given) => self.numbers(&enclosure(&given.value)?),
            None => self
                .has_zero()
                .then(|| Interval::point(BigRational::zero())),
        }
    }

    /// Numbers of the axis with their unit, for people.
    #[must_use]
    pub fn range_text(&self, numbers: &Interval<BigRational>) -> String {
        format!("{}{}", range(numbers), self.written.unit())
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

/// A unit that was typed for a key, when it fits.
fn unit_written(
    unit: &str,
    form: Form,
    measure: Measure,
    scene: &Scene,
) -> Result<Written, String> {
    let plain = Amount {
        nominal: BigRational::one(),
        lo: BigRational::one(),
        hi: BigRational::one(),
        bound: None,
        unit_text: None,
        unit: Unit::one(),
        is_weight: false,
    };
    let needs_none = form == Form::Count || scene.motion == Motion::Dimensionless;
    match (needs_none, unit.is_empty()) {
        (true, true) => return Ok(plain.written(form)),
        (true, false) => return Err(format!("expected a plain number, found the unit `{unit}`")),
        (false, true) => {
            let expected = measure.expected(Some(scene.motion));
            return Err(format!("expected a unit, for {expected}"));
        }
        (false, false) => {}
    }
    let parsed = Unit::parse(unit).map_err(|error| match error.help() {
        Some(help) => format!("{error}: {help}"),
        None => error.to_string(),
    })?;
    let fits = match measure.accepts(parsed.dimension()) {
        Some(motion) => motion.is_none_or(|motion| motion == scene.motion),
        None => false,
    };
    if !fits {
        let (found, expected) = (
            describe(parsed.dimension()),
            measure.expected(Some(scene.motion)),
        );
        return Err(format!("the unit is that of {found}, expected {expected}"));
    }
    let amount = Amount {
        unit_text: Some((unit.to_owned(), 0..unit.len())),
        unit: parsed,
        ..plain
    };
    Ok(amount.written(form))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> Scene {
        let text = "[device]\nviscous = \"9 mN m s/rad ± 10%\"\n[sampling]\nrate = \"2 kHz\"\n\
                    [encoder]\ncounts_per_revolution = 512\n[wall]\nstiffness = \"2 N m/deg\"\n";
        Scene::from_toml("knob", text).unwrap()
    }

    #[test]
    fn an_axis_has_the_unit_of_the_scene_or_the_one_that_is_typed() {
        let scene = scene();
        let column = |text| Axis::parse(text, &scene).unwrap().column();
        assert_eq!(column("stiffness"), "stiffness [N m/deg]");
        assert_eq!(column("wall.stiffness [N m/rad]"), "stiffness [N m/rad]");
        assert_eq!(column("rate"), "rate [kHz]");
        assert_eq!(column("period"), "period [ms]");
        assert_eq!(column("counts_per_revolution"), "counts_per_revolution");
        assert_eq!(column("coulomb"), "coulomb [N m]");
        assert_eq!(column("arm.damping"), "arm.damping [N m s/rad]");
        let label = |text| Axis::parse(text, &scene).unwrap().label();
        assert_eq!(label("period"), "sampling period T (ms)");
        assert_eq!(label("rate"), "sampling rate 1/T (kHz)");
    }

    #[test]
    fn numbers_of_an_axis_go_to_si_and_back() {
        let scene = scene();
        let period = Axis::parse("period", &scene).unwrap();
        assert_eq!(period.of_scene(&scene).unwrap().lo().to_string(), "1/2");
        let rate = Axis::parse("rate", &scene).unwrap();
        let half = rate.si(&BigRational::new(1.into(), 2.into())).unwrap();
        assert_eq!(half.to_rational().unwrap().to_string(), "1/500");
        assert!(rate.si(&BigRational::zero()).is_none());
        let viscous = Axis::parse("viscous", &scene).unwrap();
        let box_of = viscous.of_scene(&scene).unwrap();
        assert_eq!(box_of.lo().to_string(), "81/10");
        let damping = Axis::parse("damping", &scene).unwrap();
        assert_eq!(damping.of_scene(&scene).unwrap().hi().to_string(), "0");
        // A scene without an arm has no place on an axis that begins above zero.
        assert!(
            Axis::parse("inertia", &scene)
                .unwrap()
                .of_scene(&scene)
                .is_none()
        );
    }

    #[test]
    fn counts_are_the_same_whether_the_scene_gives_counts_or_a_resolution() {
        let counts = scene();
        let text = "[sampling]\nrate = \"2 kHz\"\n[encoder]\nresolution = \"0.1 deg\"\n[wall]\n\
                    stiffness = \"2 N m/deg\"\n";
        let resolution = Scene::from_toml("knob", text).unwrap();
        let si = [&counts, &resolution].map(|scene| {
            let axis = Axis::parse("counts_per_revolution", scene).unwrap();
            axis.si(&axis.number("512").unwrap()).unwrap()
        });
        assert_eq!(si[0], si[1]);
        assert_eq!(si[0], counts.given.resolution.unwrap().nominal);
    }

    #[test]
    fn what_is_no_axis_is_said() {
        let scene = scene();
        let error = |text| Axis::parse(text, &scene).unwrap_err().to_string();
        assert!(
            error("stifness")
                .starts_with("`stifness`: expected a parameter: one of stiffness, period, rate")
        );
        assert_eq!(
            error("stiffness [N m/rad"),
            "`stiffness [N m/rad`: the unit needs its closing `]`"
        );
        assert_eq!(
            error("stiffness [N foo]"),
            "`stiffness [N foo]`: unknown unit `foo`"
        );
        assert_eq!(
            error("stiffness [N/mm]"),
            "`stiffness [N/mm]`: the unit is that of a linear stiffness, expected a torsional \
             stiffness such as `\"2 N m/rad\"`"
        );
        assert_eq!(
            error("beta"),
            "`beta`: `knob` has units: expected `viscous`"
        );
        assert_eq!(
            error("counts_per_revolution [rad]"),
            "`counts_per_revolution [rad]`: expected a plain number, found the unit `rad`"
        );
        let counts = Axis::parse("counts_per_revolution", &scene).unwrap();
        assert_eq!(
            counts.number("1.5").unwrap_err().to_string(),
            "`counts_per_revolution` = `1.5`: expected a whole number"
        );
        let period = Axis::parse("period", &scene).unwrap();
        assert_eq!(
            period.number("0").unwrap_err().to_string(),
            "`period` = `0`: expected a value above zero"
        );
        let plain = "[dimensionless]\nbeta = \"1/2\"\nsigma = \"1/2\"\n";
        let plain = Scene::from_toml("corner", plain).unwrap();
        assert_eq!(
            Axis::parse("beta", &plain).unwrap().label(),
            "viscous friction β"
        );
        assert_eq!(
            Axis::parse("stiffness", &plain).unwrap_err().to_string(),
            "`stiffness`: it is 1 in `corner`, a dimensionless scene"
        );
    }
}
