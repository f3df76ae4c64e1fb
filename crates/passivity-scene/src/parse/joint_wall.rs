//! The wall of a scene of several joints: a stiffness with a direction, or a matrix.

use std::ops::Range;

use passivity_core::definite::{self, Form};
use passivity_core::joints::Shape;
use passivity_core::{Exact, Ordered, Parameter, Scalar};

use crate::diagnostic::{Diagnostic, Kind};
use crate::joints::Way;
use crate::parse::amount::Amount;
use crate::parse::joints::refuse_keys;
use crate::parse::keys::shorten;
use crate::parse::measure::describe;
use crate::parse::node::{Content, Entry, Node};
use crate::parse::reader::{Reader, Section, Spec};
use crate::scene::{Given, Motion};
use crate::units::{Dimension, Unit};
use crate::written::Form as Writing;

/// A wall as it was read.
pub(super) struct Wall {
    pub(super) stiffness: Given,
    pub(super) motion: Motion,
    pub(super) shape: Shape<Exact>,
    pub(super) ways: Vec<Way>,
    pub(super) unilateral: bool,
}

/// Reads `[wall]`; on a mistake the reader holds what is wrong.
pub(super) fn read_wall(
    section: Option<Section>,
    motions: &[Motion],
    reader: &mut Reader<'_>,
) -> Option<Wall> {
    let Some(mut section) = section else {
        reader.missing(None, "wall", "`stiffness` and `direction`");
        return None;
    };
    const REFUSED: [&str; 5] = [
        "damping",
        "damping_cutoff",
        "damping_time_constant",
        "max_force",
        "force_step",
    ];
    refuse_keys(&mut section, &REFUSED, reader);
    let matrix = section.take("stiffness_matrix");
    let direction = section.take("direction");
    let unilateral = section.take("unilateral");
    let is_one_sided = match &unilateral {
        Some(entry) => reader.flag(entry, "wall.unilateral")?,
        None => false,
    };
    reader.unit_notes.clear();
    let stiffness = section.take("wall.stiffness");
    let has_stiffness = stiffness.is_some();
    if let Some(matrix) = matrix {
        let beside = stiffness.as_ref().or(direction.as_ref());
        let one_sided = unilateral.filter(|_| is_one_sided);
        for entry in beside.into_iter().chain(&one_sided) {
            let key = entry.key.clone();
            let message = format!("`wall.{key}` and `wall.stiffness_matrix` cannot both be given");
            let diagnostic = Diagnostic::new(Kind::ConflictingKeys, message)
                .at(entry.key_span.clone())
                .key(format!("wall.{key}"))
                .expected("`stiffness` and `direction`, or `stiffness_matrix` alone");
            reader.report(diagnostic);
        }
        reader.leftovers(section);
        let shape = read_matrix(&matrix, motions, reader)?;
        return Some(Wall {
            stiffness: Given::unit(Parameter::Stiffness),
            motion: Motion::Dimensionless,
            shape,
            ways: Vec::new(),
            unilateral: false,
        });
    }
    if !has_stiffness || direction.is_none() {
        let what = match (has_stiffness, direction.is_some()) {
            (false, true) => "`stiffness`",
            (true, false) => "`direction` for the joints",
            _ => "`stiffness` and `direction`, or `stiffness_matrix`",
        };
        reader.missing(Some(&section), "wall", what);
    }
    let spec = Spec::new(Parameter::Stiffness, "wall.stiffness");
    let stiffness = stiffness.and_then(|entry| reader.quantity(entry, &spec));
    reader.leftovers(section);
    let motion = reader.motion()?;
    let ways = read_direction(&direction?, motion, motions, reader)?;
    Some(Wall {
        stiffness: stiffness?,
        motion,
        shape: Shape::Direction(ways.iter().map(|way| way.value.clone()).collect()),
        ways,
        unilateral: is_one_sided,
    })
}

/// The entries of a list with one for each joint.
fn list_of<'a>(
    node: &'a Node,
    (key, what): (&str, &str),
    joints: usize,
    reader: &mut Reader<'_>,
) -> Option<&'a [Node]> {
    let expected = format!("{what}, one for each of {}", joints_text(joints));
    let about = |kind, message: String| {
        Diagnostic::new(kind, message)
            .at(node.span.clone())
            .key(key)
            .expected(expected.clone())
    };
    let Content::List(nodes) = &node.content else {
        let message = format!("`{key}` is {}", node.words());
        reader.report(about(Kind::WrongType, message));
        return None;
    };
    // Without joints there is another mistake already.
    if joints > 0 && nodes.len() != joints {
        let n = nodes.len();
        let entries = if n == 1 { "entry" } else { "entries" };
        let message = format!(
            "`{key}` has {n} {entries}, and the device {}",
            joints_text(joints)
        );
        reader.report(about(Kind::WrongCount, message));
        return None;
    }
    Some(nodes)
}

fn joints_text(n: usize) -> String {
    match n {
        1 => "1 joint".to_owned(),
        n => format!("{n} joints"),
    }
}

/// How far a wall moves for a unit of a joint: a dimension and an example.
fn way(wall: Motion, joint: Motion) -> (Dimension, &'static str) {
    match (wall, joint) {
        (Motion::Linear, Motion::Rotary) => (Dimension::new(0, 1, 0, -1), "0.2 m/rad"),
        (Motion::Rotary, Motion::Linear) => (Dimension::new(0, -1, 0, 1), "5 rad/m"),
        _ => (Dimension::NONE, "1"),
    }
}

fn read_direction(
    entry: &Entry,
    wall: Motion,
    motions: &[Motion],
    reader: &mut Reader<'_>,
) -> Option<Vec<Way>> {
    const KEY: &str = "wall.direction";
    let what = (KEY, "a list such as `[\"0.2 m/rad\", \"0.05 m/rad\"]`");
    let nodes = list_of(&entry.node, what, motions.len(), reader)?;
    let mut ways = Vec::new();
    for (node, joint) in nodes.iter().zip(motions) {
        let (dimension, example) = way(wall, *joint);
        let moves = match wall {
            Motion::Linear => "way of the wall",
            _ => "angle of the wall",
        };
        let unit = match joint {
            Motion::Linear => "a metre",
            _ => "a radian",
        };
        let expected = format!("the {moves} for {unit} of the joint, such as `\"{example}\"`");
        ways.push(exact(node, KEY, dimension, &expected, reader));
    }
    let ways: Vec<Way> = ways.into_iter().collect::<Option<_>>()?;
    if ways.iter().all(|way| way.value == Exact::zero()) && !ways.is_empty() {
        let message = "this wall acts on no joint";
        let diagnostic = Diagnostic::new(Kind::OutOfBounds, message)
            .at(entry.node.span.clone())
            .key(KEY)
            .expected("an entry that is not zero");
        reader.report(diagnostic);
    }
    Some(ways)
}

/// Reads a number of either sign with the unit of a dimension, and without a tolerance.
fn exact(
    node: &Node,
    key: &str,
    dimension: Dimension,
    expected: &str,
    reader: &mut Reader<'_>,
) -> Option<Way> {
    let about = |diagnostic: Diagnostic| diagnostic.key(key).expected(expected);
    let text = match &node.content {
        Content::Text(text, _) => text,
        Content::Number(literal) if dimension == Dimension::NONE => literal,
        Content::Number(literal) => {
            let message = format!("an entry of `{key}` is a number without a unit");
            let diagnostic = Diagnostic::new(Kind::MissingUnit, message)
                .at(node.span.clone())
                .found(format!("`{}`", shorten(literal)));
            reader.report(about(diagnostic));
            return None;
        }
        _ => {
            let message = format!("an entry of `{key}` is {}", node.words());
            let diagnostic = Diagnostic::new(Kind::WrongType, message).at(node.span.clone());
            reader.report(about(diagnostic));
            return None;
        }
    };
    // An angle may be left out, as `N m s` is as good as `N m s/rad`.
    let fits = |unit: &Unit| [dimension, dimension.with_angle(0)].contains(&unit.dimension());
    let amount = match Amount::parse(text, |unit| Unit::parse_for(unit, fits)) {
        Ok(amount) => amount,
        Err(fault) => {
            let diagnostic = Diagnostic::new(fault.kind, fault.message)
                .at(node.part(fault.span))
                .help(fault.help);
            reader.report(about(diagnostic));
            return None;
        }
    };
    let own = amount.unit.dimension();
    if !fits(&amount.unit) {
        let (kind, span) = match &amount.unit_text {
            Some((_, span)) => (Kind::WrongUnit, node.part(span.clone())),
            None => (Kind::MissingUnit, node.span.clone()),
        };
        let message = match &amount.unit_text {
            Some((unit, _)) => format!(
                "an entry of `{key}` has the unit `{}` of {}",
                shorten(unit),
                describe(own)
            ),
            None => format!("an entry of `{key}` is a number without a unit"),
        };
        reader.report(about(Diagnostic::new(kind, message).at(span)));
        return None;
    }
    if amount.bound.is_some() || amount.lo != amount.hi {
        let message = format!("an entry of `{key}` has a tolerance");
        let diagnostic = Diagnostic::new(Kind::MalformedTolerance, message).at(node.span.clone());
        let help = "of a wall with a `direction` the `stiffness` may have a tolerance";
        reader.report(
            about(diagnostic)
                .expected("one value")
                .help(Some(help.to_owned())),
        );
        return None;
    }
    Some(Way {
        value: amount.written(Writing::Value).typed(&amount.nominal),
        text: text.clone(),
    })
}

/// The dimension of a torque or a force of one joint for a unit of another.
fn stiffness_between(torque_of: Motion, unit_of: Motion) -> (Dimension, &'static str) {
    match (torque_of, unit_of) {
        (Motion::Linear, Motion::Linear) => (Dimension::new(1, 0, -2, 0), "100 N/m"),
        (Motion::Linear, _) => (Dimension::new(1, 1, -2, -1), "3 N/rad"),
        (_, Motion::Linear) => (Dimension::new(1, 1, -2, 0), "3 N m/m"),
        (_, _) => (Dimension::new(1, 2, -2, -1), "2 N m/rad"),
    }
}

fn read_matrix(entry: &Entry, motions: &[Motion], reader: &mut Reader<'_>) -> Option<Shape<Exact>> {
    const KEY: &str = "wall.stiffness_matrix";
    let what = (KEY, "a list of rows");
    let rows = list_of(&entry.node, what, motions.len(), reader)?;
    let mut matrix: Vec<Vec<Exact>> = Vec::new();
    let mut spans: Vec<Vec<Range<usize>>> = Vec::new();
    for (row, torque_of) in rows.iter().zip(motions) {
        let entries = list_of(row, (KEY, "a row of entries"), motions.len(), reader)?;
        let mut values = Vec::new();
        for (node, unit_of) in entries.iter().zip(motions) {
            let (mut dimension, example) = stiffness_between(*torque_of, *unit_of);
            // A force for a radian may be written in N m/m too, which is symmetric to it.
            if let Content::Text(text, _) = &node.content
                && torque_of != unit_of
                && Amount::parse(text, Unit::parse)
                    .is_ok_and(|amount| amount.unit.dimension() == dimension.with_angle(-1))
            {
                dimension = dimension.with_angle(-1);
            }
            let expected = format!("a stiffness such as `\"{example}\"`");
            values.push(exact(node, KEY, dimension, &expected, reader)?.value);
        }
        matrix.push(values);
        spans.push(entries.iter().map(|node| node.span.clone()).collect());
    }
    let about = |kind, message: String, span: Range<usize>| {
        Diagnostic::new(kind, message).at(span).key(KEY)
    };
    for (i, (row, spans)) in matrix.iter().zip(&spans).enumerate() {
        for (j, (entry, span)) in row.iter().zip(spans).enumerate().take(i) {
            let opposite = matrix.get(j).and_then(|row| row.get(i))?;
            if entry.compare(opposite) != Some(std::cmp::Ordering::Equal) {
                let (i, j) = (i + 1, j + 1);
                let message = format!(
                    "the matrix is not symmetric: row {i}, column {j} differs from row {j}, column {i}"
                );
                let expected = "the same stiffness on both sides of the diagonal";
                reader.report(about(Kind::NotSymmetric, message, span.clone()).expected(expected));
                return None;
            }
        }
    }
    let problem = match definite::decide_enclosed(&matrix) {
        Some(Form::Semidefinite) => return Some(Shape::Matrix(matrix)),
        Some(Form::Negative(_)) => {
            "a displacement of the joints has a negative energy in this wall"
        }
        None => {
            "whether the matrix is positive semidefinite cannot be told: it is singular with π in it"
        }
    };
    let diagnostic = about(
        Kind::NotSemidefinite,
        problem.to_owned(),
        entry.node.span.clone(),
    );
    reader.report(diagnostic.expected("a positive semidefinite matrix, as that of a spring is"));
    None
}
