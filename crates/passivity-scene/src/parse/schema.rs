//! The JSON Schema of scene files, made from the table of parameters: for editors.

use passivity_core::Parameter;
use serde_json::{Map, Value, json};

use super::keys::{all_keys, sections};
use super::measure::Measure;
use super::reader::Spec;

/// The JSON Schema (draft 7) of a scene file, as TOML or as JSON.
///
/// An editor that knows Taplo or "Even Better TOML" offers the keys and says what is wrong with one
/// when the file begins with the line `#:schema scene.schema.json`.
///
/// # Example
///
/// ```
/// let schema = passivity_scene::parse::schema();
/// let viscous = &schema["properties"]["device"]["properties"]["viscous"];
/// assert!(viscous["description"].as_str().unwrap().starts_with("viscous friction b"));
/// ```
#[must_use]
pub fn schema() -> Value {
    let mut properties = Map::new();
    properties.insert(
        "name".to_owned(),
        json!({"type": "string", "description": "the scene's name; without it that of the file"}),
    );
    for section in sections() {
        let content = match section {
            "joint" => json!({
                "type": "array",
                "description": "the joints of a device of several, in place of device and encoder",
                "minItems": 1,
                "maxItems": super::MAX_JOINTS,
                "items": table(section),
            }),
            _ => table(section),
        };
        properties.insert(section.to_owned(), content);
    }
    json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "A scene of passivity: a haptic device, its control loop and a virtual wall",
        "type": "object",
        "additionalProperties": false,
        "properties": properties,
    })
}

/// A section, with the keys that stand in it.
fn table(section: &'static str) -> Value {
    let in_section = |key: &'static str| {
        let (home, name) = key.rsplit_once('.')?;
        (home == section).then_some((key, name))
    };
    let mut properties = Map::new();
    for (key, name) in all_keys().filter_map(in_section) {
        properties.insert(name.to_owned(), value(key));
    }
    let mut table = json!({
        "type": "object",
        "description": about(section),
        "additionalProperties": false,
        "properties": properties,
    });
    if let (Some(pair), Some(table)) = (pair(section), table.as_object_mut()) {
        table.insert("not".to_owned(), json!({"required": pair}));
    }
    table
}

/// The keys of a section that say the same, of which only one may be given.
fn pair(section: &str) -> Option<[&'static str; 2]> {
    Parameter::ALL.iter().find_map(|parameter| {
        let row = parameter.row();
        let name = |key: &'static str| {
            let (home, name) = key.rsplit_once('.')?;
            (home == section.trim_start_matches("joint.")).then_some(name)
        };
        let other = row.other_keys.iter().find_map(|key| name(key))?;
        Some([name(row.key)?, other])
    })
}

/// What a section is, in a sentence.
fn about(section: &str) -> &'static str {
    match section {
        "joint" => "what is known of one joint of a device of several",
        "joint.encoder" => "the encoder of the joint; without it its position is known exactly",
        "device" => "what the hand holds: its inertia and its friction",
        "transmission" => "a rigid transmission between the motor and the device",
        "motor" => "what is known at the motor's side of the transmission",
        "sampling" => "the sampling period of the control loop, and how late its output is",
        "encoder" => "the encoder; without it the position is known exactly",
        "wall" => "the virtual wall",
        "controller" => "a digital controller H(z) in place of the spring and its damping",
        "amplifier" => "the amplifier of the actuator",
        "operator" => "the operator: a bound on the speed, a force, an arm",
        "operator.arm" => "the operator's arm, which moves with the device",
        "start" => "where a simulation starts, and the question what happens with the hand off",
        "run" => "the simulation",
        _ => "the scene in numbers without units, in place of device and encoder",
    }
}

/// The schema of one key.
fn value(key: &'static str) -> Value {
    let of_joint = [
        ("joint.viscous", Parameter::Viscous),
        ("joint.coulomb", Parameter::Coulomb),
        ("joint.max_speed", Parameter::MaxSpeed),
        ("joint.encoder.resolution", Parameter::Resolution),
    ];
    if let Some((_, parameter)) = of_joint.into_iter().find(|(joint, _)| *joint == key) {
        return quantity(parameter, key);
    }
    let parameter = Parameter::ALL.iter().find(|parameter| {
        let row = parameter.row();
        row.key == key || row.other_keys.contains(&key) || row.dimensionless_key == Some(key)
    });
    match (key, parameter) {
        ("encoder.counts_per_revolution" | "joint.encoder.counts_per_revolution", _) => json!({
            "description": "counts per revolution behind the decoder, such as 8192 or \"14 bit\"; the resolution Δ is 2π over it",
            "type": ["integer", "string"], "minimum": 1,
        }),
        ("operator.force", _) => json!({
            "description": "a constant force of the operator, a CSV file of forces, or { file, column }",
            "type": ["string", "number", "object"],
        }),
        (_, Some(parameter)) => quantity(*parameter, key),
        ("operator.arm", None) => table("operator.arm"),
        ("sampling.delay", None) => json!({
            "description": "whole samples by which the force is late",
            "type": ["integer", "string"], "minimum": 0, "maximum": u16::MAX,
        }),
        ("run.intervals", None) => json!({
            "description": "how many sampling intervals a simulation runs",
            "type": ["integer", "string"], "minimum": 1, "maximum": super::MAX_INTERVALS,
        }),
        ("wall.unilateral", None) => json!({
            "description": "whether the wall is on one side only, x ≥ 0",
            "type": "boolean",
        }),
        ("joint.encoder", None) => table("joint.encoder"),
        ("joint.name", None) => json!({
            "description": "what the joint is called, such as \"elbow\"",
            "type": "string",
        }),
        ("wall.direction", None) => json!({
            "description": "of a device of several joints: the way of the wall for a unit of each joint, Jᵀn, such as [\"0.2 m/rad\", \"0.05 m/rad\"]",
            "type": "array", "minItems": 1, "items": {"type": ["string", "number"]},
        }),
        ("wall.stiffness_matrix", None) => json!({
            "description": "of a device of several joints: torque of each joint (row) for a unit of each (column), in place of stiffness and direction",
            "type": "array", "minItems": 1,
            "items": {"type": "array", "minItems": 1, "items": {"type": ["string", "number"]}},
        }),
        ("encoder.side", None) => json!({
            "description": "where the encoder sits",
            "enum": ["device", "motor"],
        }),
        ("controller.numerator" | "controller.denominator", None) => json!({
            "description": "coefficients of H(z) by falling powers of z, in units of the stiffness",
            "type": "array", "minItems": 1, "items": {"type": ["string", "number"]},
        }),
        ("transmission.ratio", None) => json!({
            "description": "turns of the motor for one of the device, such as 15, \"15:1\", \"90 rad/m\" or \"10 mm/rev\"",
            "type": ["string", "number"],
        }),
        ("transmission.motor_pulley", None) => json!({
            "description": "radius of the pulley on the motor, such as \"5 mm\"",
            "type": "string",
        }),
        ("transmission.output_pulley", None) => json!({
            "description": "radius of the driven pulley or sector, such as \"75 mm\"",
            "type": "string",
        }),
        ("transmission.handle_radius", None) => json!({
            "description": "how far from the axis the hand moves along a line, such as \"80 mm\"",
            "type": "string",
        }),
        (_, None) => json!({}),
    }
}

/// A quantity: its name, its letter, what is expected of it.
fn quantity(parameter: Parameter, key: &'static str) -> Value {
    let row = parameter.row();
    let spec = Spec::new(parameter, key);
    let section = key.rsplit_once('.').map_or("", |(section, _)| section);
    if section == "dimensionless" {
        let symbol = row.dimensionless_symbol.unwrap_or(row.symbol);
        return json!({
            "description": format!("{symbol}: {} without units; {}", row.name, row.values.expected()),
            "type": ["string", "number"],
        });
    }
    let form = match (key, spec.measure) {
        ("wall.damping_cutoff", _) => "cutoff 1/(2πτ) of the filter on the damping".to_owned(),
        (_, Measure::Rate) => format!("rate 1/{}", row.symbol),
        _ => format!("{} {}", row.name, row.symbol),
    };
    let motion = spec.at_motor.then_some(crate::scene::Motion::Rotary);
    let expected = spec.measure.expected(motion).replace('`', "");
    let side = if spec.at_motor { " at the motor" } else { "" };
    json!({
        "description": format!("{form}{side}: {expected}; {}", spec.values.expected()),
        // A plain number in a dimensionless scene.
        "type": ["string", "number"],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the reader refuses an editor marks, and what it reads an editor accepts.
    #[test]
    fn keys_that_say_the_same_exclude_each_other() {
        let schema = schema();
        let properties = &schema["properties"];
        let joint = &properties["joint"]["items"]["properties"];
        let encoder = json!(["resolution", "counts_per_revolution"]);
        for (table, pair) in [
            (&properties["sampling"], json!(["period", "rate"])),
            (&properties["encoder"], encoder.clone()),
            (&joint["encoder"], encoder),
            (
                &properties["wall"],
                json!(["damping_time_constant", "damping_cutoff"]),
            ),
        ] {
            assert_eq!(table["not"]["required"], pair);
        }
        assert!(properties["operator"].get("not").is_none());
        let counts = &properties["encoder"]["properties"]["counts_per_revolution"];
        assert_eq!(counts["minimum"], 1);
        let delay = &properties["sampling"]["properties"]["delay"];
        assert_eq!(delay["type"], json!(["integer", "string"]));
    }

    #[test]
    fn every_key_of_a_scene_file_is_described() {
        let schema = schema();
        for key in all_keys().filter(|key| !key.starts_with('.')) {
            let mut place = &schema;
            for part in key.split('.') {
                place = &place["properties"][part];
                if place["type"] == "array" && place["items"]["type"] == "object" {
                    place = &place["items"];
                }
            }
            let description = place["description"].as_str();
            assert!(
                description.is_some_and(|text| !text.is_empty()),
                "{key}: {place}"
            );
        }
    }
}
