//! A scene of several joints: `[[joint]]`, and a wall with a direction or a matrix.

use passivity_core::Parameter;
use passivity_core::joints::{Joint, Joints};

use crate::diagnostic::{Diagnostic, Kind};
use crate::joints::JointScene;
use crate::parse::build::{self, Parameters, Sections};
use crate::parse::joint_wall::read_wall;
use crate::parse::motion::check_motion;
use crate::parse::node::{Content, Entry};
use crate::parse::reader::{Reader, Section};
use crate::scene::{Given, Motion};

/// The most joints that a device may have.
pub const MAX_JOINTS: usize = 12;

/// The key that makes a scene one of several joints.
pub(super) const KEY: &str = "joint";

/// What the sections and keys that are refused say.
const INSTEAD: &str =
    "only `[[joint]]`, `[sampling]` and `[wall]`: no theorem covers more with several joints";

/// A joint as it was read.
struct Read {
    name: Option<String>,
    motion: Motion,
    joint: Joint<Given>,
}

/// Builds the scene; on a mistake the reader holds what is wrong.
pub(super) fn scene(
    name: &str,
    mut entries: Vec<Entry>,
    reader: &mut Reader<'_>,
) -> Option<JointScene> {
    let at = entries.iter().position(|entry| entry.key == KEY)?;
    let list = entries.remove(at);
    let (given_name, mut sections) = build::split(entries, reader);
    let (wall, sampling) = (sections.take("wall"), sections.take("sampling"));
    refuse_others(sections, reader);
    let joints = read_joints(list, reader);
    let period = read_sampling(sampling, reader);
    let motions: Vec<Motion> = joints.iter().map(|joint| joint.motion).collect();
    let wall = read_wall(wall, &motions, reader);
    if !reader.problems.is_empty() {
        return None;
    }
    let wall = wall?;
    Some(JointScene {
        name: given_name.unwrap_or_else(|| name.to_owned()),
        wall: wall.motion,
        ways: wall.ways,
        names: joints.iter().map(|joint| joint.name.clone()).collect(),
        motions,
        given: Joints {
            stiffness: wall.stiffness,
            period: period?,
            joints: joints.into_iter().map(|joint| joint.joint).collect(),
            shape: wall.shape,
            unilateral: wall.unilateral,
        },
    })
}

fn refuse_others(others: Sections, reader: &mut Reader<'_>) {
    for section in others.0 {
        let name = section.name;
        let instead = match name {
            "device" | "encoder" => Some("what is known of a joint stands in its `[[joint]]`"),
            "operator" => Some("a bound on the speed of a joint is `max_speed` in its `[[joint]]`"),
            _ => None,
        };
        let message = format!("[{name}] does not go with `[[joint]]`");
        let diagnostic = Diagnostic::new(Kind::NotWithJoints, message)
            .at(section.span)
            .key(name)
            .expected(INSTEAD)
            .help(instead.map(str::to_owned));
        reader.report(diagnostic);
    }
}

/// Refuses the keys of a section whose effect is not covered.
pub(super) fn refuse_keys(section: &mut Section, keys: &[&str], reader: &mut Reader<'_>) {
    for key in keys {
        if let Some(entry) = section.take(key) {
            let message = format!(
                "`{}.{key}` is not covered for a device of several joints",
                section.name
            );
            let diagnostic = Diagnostic::new(Kind::NotWithJoints, message)
                .at(entry.key_span)
                .key(format!("{}.{key}", section.name))
                .expected(INSTEAD);
            reader.report(diagnostic);
        }
    }
}

fn read_joints(list: Entry, reader: &mut Reader<'_>) -> Vec<Read> {
    let about = |message: String| {
        Diagnostic::new(Kind::WrongType, message)
            .key(KEY)
            .expected("a section `[[joint]]` for each joint")
    };
    let Content::List(nodes) = list.node.content else {
        let message = format!("`joint` is {}, not a list", list.node.words());
        reader.report(about(message).at(list.key_span));
        return Vec::new();
    };
    if nodes.is_empty() || nodes.len() > MAX_JOINTS {
        let message = format!("a device cannot have {} joints", nodes.len());
        let diagnostic = Diagnostic::new(Kind::OutOfBounds, message)
            .at(list.key_span)
            .key(KEY)
            .expected(format!("1 to {MAX_JOINTS} joints"));
        reader.report(diagnostic);
        return Vec::new();
    }
    let mut joints = Vec::new();
    for (at, node) in nodes.into_iter().enumerate() {
        let words = node.words();
        let Content::Table(entries) = node.content else {
            reader.report(about(format!("joint {} is {words}", at + 1)).at(node.span));
            continue;
        };
        let section = Section {
            name: KEY,
            span: node.span,
            entries,
        };
        joints.push(read_joint(section, reader));
    }
    joints
}

fn read_joint(mut section: Section, reader: &mut Reader<'_>) -> Read {
    // Each joint moves in its own way.
    reader.unit_notes.clear();
    let name = section
        .take("name")
        .and_then(|entry| read_name(&entry, reader));
    let value = |parameter, key, section: &mut Section, reader: &mut Reader<'_>| {
        let entry = section.take(key)?;
        build::value(parameter, key, false, entry, reader)
    };
    let span = section.span.clone();
    let says_nothing = section.entries.is_empty();
    let mut read = |parameter, key| value(parameter, key, &mut section, reader);
    let viscous = read(Parameter::Viscous, "joint.viscous");
    let coulomb = read(Parameter::Coulomb, "joint.coulomb");
    let max_speed = read(Parameter::MaxSpeed, "joint.max_speed");
    let resolution = section
        .take("encoder")
        .and_then(|entry| read_encoder(entry, reader));
    for key in ["inertia", "mass"] {
        if let Some(entry) = section.take(key) {
            let message = format!("`{key}` has no part in the verdict on several joints");
            let diagnostic = Diagnostic::new(Kind::NotWithJoints, message)
                .at(entry.key_span)
                .key(format!("joint.{key}"))
                .expected("`viscous`, `coulomb`, `encoder`, `max_speed` or `name`");
            reader.report(diagnostic);
        }
    }
    reader.leftovers(section);
    if says_nothing {
        let diagnostic = Diagnostic::new(
            Kind::MissingKey,
            "this joint has no friction and no encoder",
        )
        .at(span)
        .key(KEY)
        .expected("`viscous`, `coulomb` or `encoder`");
        reader.report(diagnostic);
    }
    check_motion(reader);
    let motion = reader.motion().unwrap_or(Motion::Rotary);
    reader.unit_notes.clear();
    Read {
        name,
        motion,
        joint: Joint {
            viscous,
            coulomb,
            resolution,
            max_speed,
        },
    }
}

fn read_name(entry: &Entry, reader: &mut Reader<'_>) -> Option<String> {
    if let Content::Text(text, _) = &entry.node.content
        && let Some(name) = build::read_name(text)
    {
        return Some(name);
    }
    let diagnostic = Diagnostic::new(Kind::WrongType, "this is not a name")
        .at(entry.node.span.clone())
        .key("joint.name")
        .expected("a line of text such as `\"elbow\"`");
    reader.report(diagnostic);
    None
}

/// Reads `encoder = { counts_per_revolution = 8192 }` or `{ resolution = "0.05 deg" }`.
fn read_encoder(entry: Entry, reader: &mut Reader<'_>) -> Option<Given> {
    const KEYS: [&str; 2] = [
        "joint.encoder.resolution",
        "joint.encoder.counts_per_revolution",
    ];
    let words = entry.node.words();
    let Content::Table(entries) = entry.node.content else {
        let diagnostic = Diagnostic::new(Kind::WrongType, format!("`joint.encoder` is {words}"))
            .at(entry.node.span)
            .key("joint.encoder")
            .expected("a table such as `{ counts_per_revolution = 8192 }`");
        reader.report(diagnostic);
        return None;
    };
    let mut section = Section {
        name: "joint.encoder",
        span: entry.key_span,
        entries,
    };
    let [resolution, counts] = reader.either(&mut section, KEYS);
    if resolution.is_none() && counts.is_none() {
        let what = "`counts_per_revolution` or `resolution`";
        reader.missing(Some(&section), section.name, what);
    }
    reader.leftovers(section);
    let [first, second] = KEYS;
    let entry = resolution.map(|entry| (first, entry));
    let (key, entry) = entry.or(counts.map(|entry| (second, entry)))?;
    build::value(Parameter::Resolution, key, false, entry, reader)
}

fn read_sampling(section: Option<Section>, reader: &mut Reader<'_>) -> Option<Given> {
    let Some(mut section) = section else {
        reader.missing(None, "sampling", "`period` or `rate`");
        return None;
    };
    let mut parameters = Parameters::default();
    if !parameters.read(Parameter::Period, &mut section, reader) {
        reader.missing(Some(&section), "sampling", "`period` or `rate`");
    }
    refuse_keys(&mut section, &["delay", "latency"], reader);
    reader.leftovers(section);
    parameters.get(Parameter::Period).cloned()
}

/// What is said of a scene of several joints where one of a single joint is asked for.
pub(super) fn not_here(entry: &Entry) -> Diagnostic {
    let span = match &entry.node.content {
        Content::List(nodes) => nodes.first().map(|node| node.span.clone()),
        _ => None,
    };
    Diagnostic::new(
        Kind::SeveralJoints,
        "this scene has several joints: only `check` and `explain` answer for it",
    )
    .at(span.unwrap_or_else(|| entry.key_span.clone()))
    .key(KEY)
    .expected("`[device]`, a device of one joint")
}
