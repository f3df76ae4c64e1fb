//! What stands between the motor and the device: `[transmission]` and `[motor]`.

use num_traits::Signed as _;
use passivity_core::{BigRational, Exact, Parameter, Scalar as _};

use crate::diagnostic::{Diagnostic, Kind};
use crate::number;
use crate::parse::amount::Amount;
use crate::parse::build::Parameters;
use crate::parse::keys::shorten;
use crate::parse::node::{Content, Entry};
use crate::parse::reader::{Reader, Section, UnitNote};
use crate::scene::{Motion, Transmission};
use crate::units::{Dimension, Unit};
use crate::written::Form;

const ANGLE_PER_LENGTH: Dimension = Dimension::new(0, -1, 0, 1);
const LENGTH_PER_ANGLE: Dimension = Dimension::new(0, 1, 0, -1);
const LENGTH: Dimension = Dimension::new(0, 1, 0, 0);

/// Reads `[transmission]`: the ratio n, or the radii that it is made of.
pub(super) fn read(mut section: Section, reader: &mut Reader<'_>) -> Option<Transmission> {
    let keys = [
        "transmission.ratio",
        "transmission.motor_pulley",
        "transmission.output_pulley",
        "transmission.handle_radius",
    ];
    let [ratio, motor, output, handle] = keys.map(|key| section.take(key));
    let conflicting = ratio.is_some() && (motor.is_some() || output.is_some());
    let incomplete = ratio.is_none() && motor.is_none();
    if conflicting {
        let message = "`ratio` and the radii of pulleys cannot both be given";
        let diagnostic = Diagnostic::new(Kind::ConflictingKeys, message)
            .at(section.span.clone())
            .key("transmission.ratio")
            .expected("one of the two");
        reader.report(diagnostic);
    } else if incomplete {
        let what = "`ratio`, or `motor_pulley` with `output_pulley`";
        reader.missing(Some(&section), "transmission", what);
    }
    let mut given = Vec::new();
    for (key, entry) in keys.into_iter().zip([&ratio, &motor, &output, &handle]) {
        if let Some(Content::Text(text, _) | Content::Number(text)) =
            entry.as_ref().map(|entry| &entry.node.content)
        {
            given.push((key, text.clone()));
        }
    }
    let span = ratio
        .as_ref()
        .map_or(&section.span, |ratio| &ratio.node.span);
    let span = span.clone();
    reader.leftovers(section);
    if conflicting || incomplete {
        return None;
    }
    let [ratio_key, motor_key, output_key, handle_key] = keys;
    let radius = |entry: Option<Entry>, key, reader: &mut Reader<'_>| match entry {
        Some(entry) => length(&entry, key, reader).map(Some),
        None => Some(None),
    };
    let (turns, motion) = match ratio {
        Some(entry) => plain(&entry, ratio_key, reader)?,
        None => (Exact::one(), Motion::Rotary),
    };
    let motor = radius(motor, motor_key, reader)?;
    let output = radius(output, output_key, reader)?;
    let handle = radius(handle, handle_key, reader)?;
    // A pulley without a second one moves a cable or a rack: a metre of it is 1/r of the motor.
    let (turns, motion) = match (motor, output) {
        (Some(motor), Some(output)) => (output.over(motor), motion),
        (Some(motor), None) => (turns.over(motor), Motion::Linear),
        (None, _) => (turns, motion),
    };
    let (ratio, motion) = match handle {
        Some(_) if motion == Motion::Linear => {
            let message = "a device that moves along a line already has no `handle_radius`";
            let diagnostic = Diagnostic::new(Kind::ConflictingKeys, message)
                .at(span)
                .key(handle_key)
                .expected("`handle_radius` beside a rotary transmission");
            reader.report(diagnostic);
            return None;
        }
        Some(radius) => (turns.over(radius), Motion::Linear),
        None => (turns, motion),
    };
    reader.unit_notes.push(UnitNote {
        key: "transmission.ratio",
        measure: None,
        motion,
        unit: match motion {
            Motion::Linear => "from an angle to a length".to_owned(),
            _ => "from an angle to an angle".to_owned(),
        },
        span,
    });
    Some(Transmission { given, ratio })
}

/// A ratio: `15`, `15:1`, `90 rad/m` or `10 mm/rev`; n and how the device moves.
fn plain(entry: &Entry, key: &str, reader: &mut Reader<'_>) -> Option<(Exact, Motion)> {
    let expected = "a ratio above zero such as `15`, `\"15:1\"`, `\"90 rad/m\"` or `\"10 mm/rev\"`";
    if let Content::Text(text, _) = &entry.node.content
        && let Some((motor, device)) = text.split_once(':')
    {
        let parts = [motor, device].map(|part| number::parse(part.trim()).ok());
        if let [Some(motor), Some(device)] = parts
            && motor.is_positive()
            && device.is_positive()
        {
            return Some((Exact::of(&(motor / device)), Motion::Rotary));
        }
        reader.report(refused(entry, key, "this is no ratio", expected));
        return None;
    }
    let units = [Dimension::NONE, ANGLE_PER_LENGTH, LENGTH_PER_ANGLE];
    let (value, dimension) = exact(entry, key, expected, &units, reader)?;
    match dimension {
        Dimension::NONE => Some((value, Motion::Rotary)),
        ANGLE_PER_LENGTH => Some((value, Motion::Linear)),
        LENGTH_PER_ANGLE => Some((Exact::one().over(value), Motion::Linear)),
        _ => {
            let message = format!("`{key}` is neither a plain ratio nor an angle per length");
            reader.report(refused(entry, key, &message, expected));
            None
        }
    }
}

fn length(entry: &Entry, key: &str, reader: &mut Reader<'_>) -> Option<Exact> {
    let expected = "a radius above zero such as `\"5 mm\"`";
    let (value, dimension) = exact(entry, key, expected, &[LENGTH], reader)?;
    if dimension == LENGTH {
        return Some(value);
    }
    let message = format!("`{key}` is not a length");
    reader.report(refused(entry, key, &message, expected));
    None
}

/// A value above zero without a tolerance, in SI units, and its dimension; units of `dimensions` are proposed.
fn exact(
    entry: &Entry,
    key: &str,
    expected: &str,
    dimensions: &[Dimension],
    reader: &mut Reader<'_>,
) -> Option<(Exact, Dimension)> {
    let (Content::Text(text, _) | Content::Number(text)) = &entry.node.content else {
        let message = format!("`{key}` is {}", entry.node.words());
        reader.report(refused(entry, key, &message, expected));
        return None;
    };
    let fits = |unit: &Unit| dimensions.contains(&unit.dimension());
    let amount = match Amount::parse(text, |unit| Unit::parse_for(unit, fits)) {
        Ok(amount) => amount,
        Err(fault) => {
            let diagnostic = Diagnostic::new(fault.kind, fault.message)
                .at(entry.node.part(fault.span))
                .key(key)
                .expected(expected)
                .found(format!("`{}`", shorten(text)))
                .help(fault.help);
            reader.report(diagnostic);
            return None;
        }
    };
    if amount.lo != amount.hi || amount.bound.is_some() {
        let message = "a transmission is exact: it has no tolerance";
        reader.report(refused(entry, key, message, expected));
        return None;
    }
    if !amount.nominal.is_positive() {
        let message = format!("`{key}` cannot be `{}`", shorten(text));
        reader.report(refused(entry, key, &message, expected));
        return None;
    }
    let written = amount.written(Form::Value);
    Some((written.typed(&amount.nominal), amount.unit.dimension()))
}

fn refused(entry: &Entry, key: &str, message: &str, expected: &str) -> Diagnostic {
    Diagnostic::new(Kind::OutOfBounds, message)
        .at(entry.node.span.clone())
        .key(key)
        .expected(expected)
        .found(match &entry.node.content {
            Content::Text(text, _) | Content::Number(text) => format!("`{}`", shorten(text)),
            _ => entry.node.words().to_owned(),
        })
}

/// Reads `[motor]`: what is known at the motor's side of the transmission.
pub(super) fn read_motor(
    mut section: Section,
    parameters: &mut Parameters,
    reader: &mut Reader<'_>,
) {
    if reader.transmission.is_none() {
        let message = "[motor] needs a [transmission] that says how the motor drives the device";
        let diagnostic = Diagnostic::new(Kind::MissingKey, message)
            .at(section.span)
            .key("transmission")
            .expected("`[transmission]` with `ratio`; 1 where the hand turns the motor itself");
        // A transmission with a mistake was reported already.
        if reader.problems.is_empty() {
            reader.report(diagnostic);
        }
        return;
    }
    for parameter in [
        Parameter::Inertia,
        Parameter::Viscous,
        Parameter::Coulomb,
        Parameter::MaxForce,
        Parameter::ForceStep,
    ] {
        parameters.read(parameter, &mut section, reader);
    }
    reader.leftovers(section);
}

impl Transmission {
    /// What a value of a parameter at the motor is multiplied with to have it at the device.
    pub(crate) fn factor(&self, parameter: Parameter) -> Exact {
        let power = parameter.row().unit.transmission_power();
        let size = (0..power.unsigned_abs()).fold(Exact::one(), |x, _| x * self.ratio.clone());
        if power < 0 {
            Exact::one().over(size)
        } else {
            size
        }
    }

    /// What the transmission does to values at the motor.
    pub(crate) fn remark(&self) -> String {
        const BITS: u32 = 60;
        let times = |x: &Exact| {
            let middle = x.enclosure(BITS).map(|range| range.middle());
            let shown = |x: BigRational| crate::display::approx(&x);
            middle.map_or_else(|| "its ratio".to_owned(), shown)
        };
        let square = self.ratio.clone() * self.ratio.clone();
        format!(
            "transmission: torques at the motor × {}, inertia and viscous friction × {}, positions \
             ÷ {}; it is taken to be rigid and without backlash",
            times(&self.ratio),
            times(&square),
            times(&self.ratio)
        )
    }
}
