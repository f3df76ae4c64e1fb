//! The operator: a bound on the speed, a force, an arm.

use passivity_core::Parameter;

use crate::diagnostic::{Diagnostic, Kind};
use crate::parse::build::Parameters;
use crate::parse::measure::Measure;
use crate::parse::node::{Content, Entry};
use crate::parse::reader::{Reader, Section, Spec, UnitNote};
use crate::parse::samples;
use crate::scene::ForceSamples;

/// Reads the section; what it says of parameters goes to `parameters`.
pub(super) fn read(
    mut section: Section,
    parameters: &mut Parameters,
    reader: &mut Reader<'_>,
) -> Option<ForceSamples> {
    parameters.read(Parameter::MaxSpeed, &mut section, reader);
    let force = section.take("force");
    let arm = section.take("arm");
    let samples = force.and_then(|entry| read_force(entry, parameters, reader));
    if let Some(entry) = arm {
        read_arm(entry, parameters, reader);
    }
    reader.leftovers(section);
    samples
}

fn read_force(
    entry: Entry,
    parameters: &mut Parameters,
    reader: &mut Reader<'_>,
) -> Option<ForceSamples> {
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
            let parameter = Parameter::OperatorForce;
            let spec = Spec::new(parameter, parameter.row().key);
            parameters.insert(parameter, reader.quantity(entry, &spec));
            None
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
) -> Option<ForceSamples> {
    let read = match reader.folder {
        Some(folder) => samples::read(&folder.join(path), column, reader.dimensionless),
        None => Err("only a scene that is a file itself can name one".to_owned()),
    };
    match read {
        Ok(samples) => {
            if let Some(motion) = samples.motion {
                reader.unit_notes.push(UnitNote {
                    key: "operator.force",
                    measure: Some(Measure::Force),
                    motion,
                    unit: "in the header of the file".to_owned(),
                    span: entry.node.span.clone(),
                });
            }
            Some(ForceSamples {
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

fn read_arm(entry: Entry, parameters: &mut Parameters, reader: &mut Reader<'_>) {
    let Content::Table(entries) = entry.node.content else {
        let words = entry.node.words();
        let diagnostic = Diagnostic::new(Kind::WrongType, format!("`operator.arm` is {words}"))
            .at(entry.node.span)
            .key("operator.arm")
            .expected("`{ mass = \"…\", damping = \"…\", stiffness = \"…\" }`")
            .found(words);
        reader.report(diagnostic);
        return;
    };
    let mut section = Section {
        name: "operator.arm",
        span: entry.key_span,
        entries,
    };
    let arm = [
        Parameter::ArmMass,
        Parameter::ArmDamping,
        Parameter::ArmStiffness,
    ];
    let found = arm.map(|parameter| parameters.read(parameter, &mut section, reader));
    if found == [false; 3] {
        let what = "`mass`, `damping` or `stiffness`";
        reader.missing(Some(&section), "operator.arm", what);
    }
    reader.leftovers(section);
}
