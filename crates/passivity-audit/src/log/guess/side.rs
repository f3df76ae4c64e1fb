//! The side of a transmission at which a column seems to be: what the motor says is not what the device does, but a
//! multiple of it.

use passivity_scene::{Motion, Scene};

use super::kind::Kind;
use super::made::has_one;
use super::score::own_unit;
use super::whole;
use super::words::{OF_WINDING, words};
use crate::log::columns::Role;
use crate::log::header::{Heading, split};
use crate::log::preview::Preview;

/// What a motor is called, alone or as a part of a longer word: `Motorwinkel`, `servomotor`.
const MOTOR: [&str; 17] = [
    "motor",
    "armature",
    "mtr",
    "actuator",
    "servo",
    "drive",
    "moteur",
    "rotor",
    "silnik",
    "мотор",
    "двигател",
    "电机",
    "電機",
    "马达",
    "モータ",
    "모터",
    "전동기",
];

/// What is where the encoder is, as far as nothing says that it is at the device: with the encoder at the motor, its shaft is
/// the one that goes into the transmission.
const AT_ENCODER: [&str; 8] = [
    "encoder",
    "enc",
    "shaft",
    "input",
    "mech",
    "mechanical",
    "primary",
    "before",
];

/// What is behind the transmission.
const AT_DEVICE: [&str; 7] = [
    "output", "load", "device", "handle", "knob", "paddle", "joint",
];

/// What turns with the motor, before a transmission: of angles and speeds.
const TURNS_WITH_MOTOR: [&str; 5] = ["antrieb", "capstan", "spool", "drum", "pinion"];

/// What an angle is called that turns by a turn for each pair of magnet poles, and the letter for that behind an angle.
const ELECTRICAL: [&str; 6] = [
    "electrical",
    "elec",
    "elektrisch",
    "elektrischer",
    "électrique",
    "eléctrico",
];
const OF_POLES: &str = "e";

/// What only turns is called.
const ANGLES: [&str; 6] = ["theta", "phi", "θ", "φ", "angle", "winkel"];

/// Whether the name of a column seems to be that of a value at the motor, where a transmission stands between it and the
/// device. An m that is no metre may be short for it, as in `theta_m`, `thetaM` and `m_pos`: on a line, beside an angle.
pub(super) fn is_at_motor(kind: Kind, heading: &Heading, scene: &Scene) -> bool {
    if kind == Kind::Time || scene.transmission.is_none() {
        return false;
    }
    let is_moved = is_motion(kind) && !has_one(heading, &AT_DEVICE);
    let is_motor = |word: &String| {
        let is_part = |part: &&str| word.starts_with(part) || word.ends_with(part);
        let is_turned = is_moved && TURNS_WITH_MOTOR.iter().any(is_part);
        MOTOR.iter().any(is_part) || word.ends_with("mot") || is_turned
    };
    let is_short = split(&heading.name).is_ok_and(|split| {
        // In brackets it is a unit.
        let is_last = split.unit.as_deref() == Some("m") && heading.name.ends_with(['m', 'M']);
        let words = words(split.stem);
        let has = |other: &str| words.iter().any(|word| word == other);
        let is_turned = scene.motion != Motion::Linear || ANGLES.into_iter().any(has);
        // As in `thm`.
        let is_joined = |word: &String| {
            let before = word.strip_suffix('m');
            before.is_some_and(|it| it == "th" || ANGLES.contains(&it))
        };
        has("m") || (is_last && is_turned) || words.iter().any(is_joined)
    });
    let is_encoded = counts_are_at_motor(scene) && is_at_encoder(kind, heading, scene);
    is_short
        || is_encoded
        || is_of_winding(kind, heading)
        || words(&heading.name).iter().any(is_motor)
}

/// Whether the name of a column is that of a torque which only a motor has: of its winding or of its drive, as the letter e
/// behind that of a torque says too, and in one word an m.
fn is_of_winding(kind: Kind, heading: &Heading) -> bool {
    let words = words(&heading.name);
    let is_it = |word: &String| {
        OF_WINDING.iter().any(|start| word.starts_with(start))
            || ["te", "tm", "taue", "taum"].contains(&word.as_str())
    };
    let is_letter = |word: &str| ["t", "tau", "τ"].contains(&word);
    let has_e = || matches!(words.as_slice(), [letter, e, ..] if is_letter(letter) && e == "e");
    kind == Kind::Force && (words.iter().any(is_it) || has_e())
}

/// Whether the name of a column seems to be that of a value at the encoder: `encoder_angle`, `shaft_torque`, `tau_in`.
fn is_at_encoder(kind: Kind, heading: &Heading, scene: &Scene) -> bool {
    // On a line it may be the unit: `pos_in` is in inches. Right behind what is named it is none, as in `tau_in`, and before a
    // unit it says no side, as in `angle in rad`.
    let named = heading.name.split(['[', '(']).next().unwrap_or_default();
    let words = words(named);
    let is_in = match (kind, words.as_slice()) {
        (Kind::Force, [.., of, side]) => kind.is_named(of) && side == "in",
        (_, [.., side]) => scene.motion != Motion::Linear && kind != Kind::Force && side == "in",
        _ => false,
    };
    kind != Kind::Time && (is_in || has_one(heading, &AT_ENCODER)) && !has_one(heading, &AT_DEVICE)
}

const fn is_motion(kind: Kind) -> bool {
    matches!(kind, Kind::Position | Kind::Velocity)
}

/// Why a column is no position of the motor or the device, where its name says that it has electrical angles.
fn electrical(kind: Kind, heading: &Heading) -> Option<String> {
    let stem = split(&heading.name).map_or(heading.name.as_str(), |split| split.stem);
    let words = words(stem);
    let is_angle = words.iter().any(|word| ANGLES.contains(&word.as_str()));
    let is_behind = is_angle && words.last().is_some_and(|word| word == OF_POLES);
    let is_it = kind == Kind::Position && (is_behind || has_one(heading, &ELECTRICAL));
    is_it.then(|| {
        "by its name it seems to be an electrical angle, which makes a turn for each pair of magnet poles: log the angle of \
         the shaft, or the counts of the encoder"
            .to_owned()
    })
}

/// Whether the encoder of the scene is at the motor, so that the counts of a log are, too.
fn counts_are_at_motor(scene: &Scene) -> bool {
    let encoder = scene.given.resolution.as_ref();
    encoder.is_some_and(|given| given.written.unit().ends_with("at the motor"))
}

/// Why a column cannot be read as a value at the device, where it seems to be one at the motor; `None` where it does not, or
/// has the counts of an encoder there.
pub(super) fn not_at_device(
    kind: Kind,
    heading: &Heading,
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> Option<String> {
    if let Some(why) = electrical(kind, heading) {
        return Some(why);
    }
    if !is_at_motor(kind, heading, scene) {
        return None;
    }
    let counted = counts_are_at_motor(scene);
    if kind == Kind::Position && whole::counts(heading, column, preview, scene) == Ok(true) {
        let says = "by its name and its numbers it seems to have counts of an encoder at the motor, and that of the scene, \
                    whose counts are `count`, is at the device: where it is at the motor, say `side = \"motor\"` under \
                    [encoder]";
        return (!counted).then(|| says.to_owned());
    }
    let (role, verb) = match kind {
        Kind::Force => (Role::F, "multiply"),
        Kind::Velocity => (Role::V, "divide"),
        Kind::Position | Kind::Time => (Role::X, "divide"),
    };
    let what = match (scene.motion, kind) {
        (Motion::Linear, Kind::Force) => "its torques in N m by the ratio in rad/m",
        (Motion::Linear, Kind::Velocity) => "its speeds in rad/s by the ratio in rad/m",
        (Motion::Linear, _) => "its angles in rad by the ratio in rad/m",
        _ => "its numbers by the ratio",
    };
    let own = own_unit(kind, heading, scene.motion).filter(|_| scene.motion != Motion::Linear);
    let unit = own.unwrap_or_else(|| kind.unit(scene.motion).to_owned());
    let name = role.name();
    let also = match (kind, counted) {
        (Kind::Position, false) if scene.given.has_encoder() => {
            " and so is the encoder, whose counts are `count`"
        }
        _ => "",
    };
    let counts = match (kind, counted) {
        (Kind::Position, true) => {
            ", or log the counts of the encoder, which is at the motor, as `count`"
        }
        _ => "",
    };
    let by_name = match counted && is_at_encoder(kind, heading, scene) {
        true => "by its name, as the scene's encoder is there,",
        false => "by its name",
    };
    Some(format!(
        "{by_name} it seems to be at the motor, but `{name}` is at the device, behind the transmission{also}: {verb} \
         {what} and call the column `{name} [{unit}]`{counts}"
    ))
}
