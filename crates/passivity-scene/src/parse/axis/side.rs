//! The side of a transmission at which an axis is.

use std::fmt;

use passivity_core::{Exact, Parameter};

use super::named::Named;
use crate::scene::{Motion, Scene};

/// A side of a transmission.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum At {
    Device,
    Motor,
}

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Device => "at the device",
            Self::Motor => "at the motor",
        })
    }
}

impl At {
    /// Reads `at the motor` or `at the device`.
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let side = [Self::Device, Self::Motor]
            .into_iter()
            .find(|side| side.to_string() == words.join(" "));
        side.ok_or_else(|| {
            format!(
                "expected `at the motor` or `at the device` behind the unit, found `{}`",
                text.trim()
            )
        })
    }

    pub(super) const fn other(self) -> Self {
        match self {
            Self::Device => Self::Motor,
            Self::Motor => Self::Device,
        }
    }

    /// How that moves which is at this side: a motor turns.
    pub(super) const fn motion(self, scene: &Scene) -> Motion {
        match self {
            Self::Device => scene.motion,
            Self::Motor => Motion::Rotary,
        }
    }
}

/// At which side an axis is, and under which key its values are typed into the scene there.
pub(super) struct Place {
    pub(super) at: At,
    pub(super) key: &'static str,
    /// Whether the scene says the side, and not the text that names the axis.
    pub(super) is_free: bool,
    pub(super) says_device: bool,
    /// What a value at the motor is multiplied with to have it at the device.
    pub(super) factor: Option<Exact>,
}

impl Place {
    /// The side that is typed, else that of the key, else the one where the scene gives the parameter: the
    /// device's where both sides have a part.
    pub(super) fn of(
        parameter: Parameter,
        key: &'static str,
        named: &Named<'_>,
        scene: &Scene,
    ) -> Result<Self, String> {
        let row = parameter.row();
        let of_motor = row.other_keys.iter().find(|key| key.starts_with("motor."));
        let is_encoder = parameter == Parameter::Resolution;
        let has_sides = (of_motor.is_some() || is_encoder) && scene.motion != Motion::Dimensionless;
        let of_key = match key {
            _ if !has_sides || is_encoder => None,
            _ if key.starts_with("motor.") => Some(At::Motor),
            // What moves along a line does not turn with the motor.
            "device.mass" => Some(At::Device),
            _ => (named.name == key).then_some(At::Device),
        };
        match (named.side, of_key) {
            (Some(side), _) if !has_sides => {
                return Err(format!("no scene gives it {side}: expected the unit alone"));
            }
            (Some(side), Some(at)) if side != at => {
                return Err(format!("`{key}` is {at}: expected no side, or `{at}`"));
            }
            _ => {}
        }
        let given = scene.given.get(parameter).filter(|_| has_sides);
        let gives = |at| given.is_some_and(|given| given.part(at == At::Motor).is_some());
        let of_scene = match gives(At::Motor) && !gives(At::Device) {
            true => At::Motor,
            false => At::Device,
        };
        let typed = named.side.or(of_key);
        let at = typed.unwrap_or(of_scene);
        let factor = match (at, &scene.transmission) {
            (At::Device, _) => None,
            (At::Motor, Some(transmission)) => Some(transmission.factor(parameter)),
            (At::Motor, None) => {
                return Err(format!(
                    "`{}` has no [transmission], so no value of it is at the motor",
                    scene.name
                ));
            }
        };
        Ok(Self {
            at,
            key: of_motor.filter(|_| at == At::Motor).copied().unwrap_or(key),
            is_free: has_sides && typed.is_none() && scene.transmission.is_some(),
            says_device: at == At::Device && (named.side.is_some() || gives(At::Motor)),
            factor,
        })
    }
}
