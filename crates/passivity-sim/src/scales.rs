//! The units that a motion is shown in: those of the scene file.

use passivity_core::{BigRational, Interval};
use passivity_scene::number::{nearest_f64, parse};
use passivity_scene::written::Form;
use passivity_scene::{Axis, Given, Motion, Scene};

use crate::error::SimError;

/// How a dimensionless figure is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// What one sampling period, tick, … is in the unit.
    pub one: f64,
    /// The unit.
    pub unit: String,
}

/// How times, positions, speeds, forces and energies are shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Scales {
    /// Of sampling periods.
    pub time: Scale,
    /// Of ticks, or of the unit of length without an encoder.
    pub position: Scale,
    /// Of ticks per sample.
    pub velocity: Scale,
    /// Of KΔ.
    pub force: Scale,
    /// Of KΔ², in joules.
    pub energy: Scale,
    /// Whether there are ticks, so that the dimensionless figures are worth a second axis.
    pub ticks: bool,
    /// Whether the scene has units at all.
    pub si: bool,
}

impl Scales {
    /// The units of a scene; sampling periods, ticks, KΔ and KΔ² of a dimensionless one.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let plain = |unit: &str| Scale {
            one: 1.0,
            unit: unit.to_owned(),
        };
        if scene.motion == Motion::Dimensionless {
            return Self {
                time: plain("sampling periods"),
                position: plain("ticks"),
                velocity: plain("ticks/sample"),
                force: plain("KΔ"),
                energy: plain("KΔ²"),
                ticks: true,
                si: false,
            };
        }
        let given = &scene.given;
        let units = scene.point().units;
        let time = units.period.clone();
        let speed = &units.length / &units.period;
        let force = &units.stiffness * &units.length;
        let energy = &force * &units.length;
        let first = |all: &[&Option<Given>]| {
            let mut written = all
                .iter()
                .filter_map(|given| given.as_ref())
                .map(|given| &given.written);
            written
                .find(|written| written.form() == Form::Value)
                .map(|written| written.unit())
        };
        let period = Some(&given.period.written).filter(|written| written.form() == Form::Value);
        let in_unit =
            |name: &str, unit: Option<String>, one: &BigRational| scale(scene, name, unit, one);
        Self {
            time: in_unit("latency", period.map(|written| written.unit()), &time),
            position: in_unit(
                "position",
                first(&[&given.start_position, &given.resolution]),
                &units.length,
            ),
            velocity: in_unit(
                "velocity",
                first(&[&given.max_speed, &given.start_velocity]),
                &speed,
            ),
            force: in_unit(
                "force",
                first(&[&given.coulomb, &given.max_force, &given.operator_force]),
                &force,
            ),
            energy: Scale {
                one: nearest_f64(&energy),
                unit: "J".to_owned(),
            },
            ticks: given.has_encoder(),
            si: true,
        }
    }
}

/// Takes a speed at the start as it was typed; one without a unit is in ticks per sample, which only an encoder has.
///
/// # Errors
///
/// [`SimError::Method`] for one without a unit in a scene in units that has no encoder.
pub fn has_ticks_or_unit(scene: &Scene, speed: &str) -> Result<(), SimError> {
    let has_ticks = scene.motion == Motion::Dimensionless || scene.given.has_encoder();
    if has_ticks || parse(speed.trim()).is_err() {
        return Ok(());
    }
    let unit = match scene.motion {
        Motion::Linear => "mm/s",
        _ => "rad/s",
    };
    Err(SimError::Method(format!(
        "`{}` has no encoder, and so no ticks: expected a speed with a unit, as in `5 {unit}`",
        scene.name
    )))
}

/// What an SI value is in a unit that a key may have; in SI where the text is none.
fn scale(scene: &Scene, name: &str, unit: Option<String>, one: &BigRational) -> Scale {
    let written =
        unit.and_then(|unit| Axis::parse(&format!("{name} [{}]", unit.trim()), scene).ok());
    let axis = written.or_else(|| Axis::parse(name, scene).ok());
    let number = |axis: &Axis| {
        axis.numbers(&Interval::point(one.clone()))
            .map(|range| nearest_f64(&range.middle()))
    };
    match axis
        .as_ref()
        .and_then(|axis| Some((axis.unit(), number(axis)?)))
    {
        Some((unit, one)) => Scale { one, unit },
        None => Scale {
            one: nearest_f64(one),
            unit: "SI".to_owned(),
        },
    }
}

impl Scale {
    /// The same with an SI prefix that makes a figure of this size about 1 to 1000.
    #[must_use]
    pub fn prefixed(&self, size: f64) -> Self {
        const PREFIXES: [(&str, f64); 6] = [
            ("", 1.0),
            ("m", 1e-3),
            ("µ", 1e-6),
            ("n", 1e-9),
            ("p", 1e-12),
            ("f", 1e-15),
        ];
        let shown = (size * self.one).abs();
        let fits = |(_, factor): &&(&str, f64)| shown >= *factor;
        let (prefix, factor) = PREFIXES.iter().find(fits).unwrap_or(&("", 1.0));
        Self {
            one: self.one / factor,
            unit: format!("{prefix}{}", self.unit),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_shown_in_the_units_of_the_scene() {
        let text = "[device]\nmass = \"75 g\"\ncoulomb = \"40 mN\"\n[sampling]\nrate = \"1 kHz\"\n\
                    [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"1 N/mm\"\n[operator]\n\
                    max_speed = \"40 mm/s\"\n";
        let scales = Scales::of(&Scene::from_toml("arm", text).unwrap());
        let shown = |scale: &Scale| (scale.one, scale.unit.clone());
        assert_eq!(shown(&scales.time), (1.0, "ms".to_owned()));
        assert_eq!(shown(&scales.position), (0.03, "mm".to_owned()));
        assert_eq!(shown(&scales.velocity), (30.0, "mm/s".to_owned()));
        assert_eq!(shown(&scales.force), (30.0, "mN".to_owned()));
        assert_eq!(scales.energy.prefixed(1.0).unit, "nJ");
        assert!((scales.energy.prefixed(1.0).one - 900.0).abs() < 1e-9);
        let plain = "[dimensionless]\nbeta = \"1/2\"\nsigma = \"1/2\"\n";
        let scales = Scales::of(&Scene::from_toml("plain", plain).unwrap());
        assert_eq!(shown(&scales.position), (1.0, "ticks".to_owned()));
        assert!(!scales.si && scales.ticks);
    }
}
