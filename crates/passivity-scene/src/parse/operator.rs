//! The operator: a bound on the speed, a force, an arm.

use passivity_core::bounds::Quantity;
use passivity_core::{BigRational, Scalar};

use crate::diagnostic::{Diagnostic, Kind};
use crate::parse::measure::Measure;
use crate::parse::node::{Content, Entry};
use crate::parse::reader::{Reader, Section, Spec, Told};
use crate::parse::samples;
use crate::point::default_given;
use crate::scene::{Arm, Force, Given};

#[derive(Default)]
pub(super) struct Operator {
    pub(super) max_speed: Option<Given>,
    pub(super) force: Option<Force>,
    pub(super) arm: Option<Arm>,
}

pub(super) fn read(section: Option<Section>, reader: &mut Reader<'_>) -> Operator {
    let Some(mut section) = section else {
        return Operator::default();
    };
    let speed = Spec::new("operator.max_speed", Measure::Speed, Quantity::MaxSpeed);
    let max_speed = section.take(speed.key);
    let force = section.take("force");
    let arm = section.take("arm");
    let operator = Operator {
        max_speed: max_speed.and_then(|entry| reader.quantity(entry, &speed)),
        force: force.and_then(|entry| read_force(entry, reader)),
        arm: arm.and_then(|entry| read_arm(entry, reader)),
    };
    reader.leftovers(section);
    operator
}

fn read_force(entry: Entry, reader: &mut Reader<'_>) -> Option<Force> {
    const KEY: &str = "operator.force";
    let is_path = |text: &str| text.trim_end().to_lowercase().ends_with(".csv");
    match &entry.node.content {
        Content::Text(text, _) if is_path(text) => {
            let path = text.clone();
            read_samples(&entry, &path, None, reader)
        }
        Content::Table(_) => {
            let (path, column) = named_file(&entry, reader)?;
            read_samples(&entry, &path, column.as_deref(), reader)
        }
        _ => {
            let spec = Spec::any_sign(KEY, Measure::Force);
            let given = reader.quantity(entry, &spec)?;
            Some(Force::Constant(Box::new(given)))
        }
    }
}

/// `{ file = "forces.csv", column = "f" }`.
fn named_file(entry: &Entry, reader: &mut Reader<'_>) -> Option<(String, Option<String>)> {
    let Content::Table(entries) = &entry.node.content else {
        return None;
    };
    let (mut file, mut column) = (None, None);
    for inner in entries {
        match (inner.key.as_str(), &inner.node.content) {
            ("file", Content::Text(text, _)) => file = Some(text.clone()),
            ("column", Content::Text(text, _)) => column = Some(text.clone()),
            ("file" | "column", _) => reader.report(
                Diagnostic::new(Kind::WrongType, format!("`{}` is text", inner.key))
                    .at(inner.node.span.clone())
                    .key("operator.force")
                    .expected("text")
                    .found(inner.node.words()),
            ),
            _ => reader.report(
                Diagnostic::new(Kind::UnknownKey, "a file of forces has no such key")
                    .at(inner.key_span.clone())
                    .key("operator.force")
                    .expected("`file`, and `column` where it is not `f`"),
            ),
        }
    }
    if file.is_none() {
        let diagnostic = Diagnostic::new(Kind::MissingKey, "a force has no `file`")
            .at(entry.node.span.clone())
            .key("operator.force")
            .expected("`{ file = \"forces.csv\" }`");
        reader.report(diagnostic);
    }
    Some((file?, column))
}

fn read_samples(
    entry: &Entry,
    path: &str,
    column: Option<&str>,
    reader: &mut Reader<'_>,
) -> Option<Force> {
    let read = match reader.folder {
        Some(folder) => samples::read(&folder.join(path), column, reader.dimensionless),
        None => Err("only a scene that is a file itself can name one".to_owned()),
    };
    match read {
        Ok(samples) => {
            if let Some(motion) = samples.motion {
                reader.told.push(Told {
                    key: "operator.force",
                    measure: Some(Measure::Force),
                    motion,
                    unit: "in the header of the file".to_owned(),
                    span: entry.node.span.clone(),
                });
            }
            Some(Force::Samples {
                path: path.to_owned(),
                values: samples.values,
            })
        }
        Err(message) => {
            let shown = super::keys::shorten(path);
            let diagnostic = Diagnostic::new(Kind::Samples, format!("`{shown}`: {message}"))
                .at(entry.node.span.clone())
                .key("operator.force")
                .expected("a CSV file with a column `f`, as in `f [N]`, or one number a line");
            reader.report(diagnostic);
            None
        }
    }
}

fn read_arm(entry: Entry, reader: &mut Reader<'_>) -> Option<Arm> {
    let specs = [
        Spec::of_arm("operator.arm.mass", Measure::Inertia, Quantity::Inertia),
        Spec::of_arm("operator.arm.damping", Measure::Viscous, Quantity::Viscous),
        Spec::of_arm(
            "operator.arm.stiffness",
            Measure::Stiffness,
            Quantity::Stiffness,
        ),
    ];
    let Content::Table(entries) = entry.node.content else {
        let words = entry.node.words();
        let diagnostic = Diagnostic::new(Kind::WrongType, format!("`operator.arm` is {words}"))
            .at(entry.node.span)
            .key("operator.arm")
            .expected("`{ mass = \"…\", damping = \"…\", stiffness = \"…\" }`")
            .found(words);
        reader.report(diagnostic);
        return None;
    };
    let mut section = Section {
        name: "operator.arm",
        span: entry.key_span,
        entries,
    };
    let found = specs.map(|spec| (spec, section.take(spec.key)));
    if found.iter().all(|(_, entry)| entry.is_none()) {
        let what = "`mass`, `damping` or `stiffness`";
        reader.missing(Some(&section), "operator.arm", what);
    }
    reader.leftovers(section);
    // What an arm has not is zero.
    let [mass, damping, stiffness] = found.map(|(spec, entry)| match entry {
        Some(entry) => reader.quantity(entry, &spec),
        None => Some(default_given(spec.key, BigRational::zero())),
    });
    Some(Arm {
        mass: mass?,
        damping: damping?,
        stiffness: stiffness?,
    })
}
