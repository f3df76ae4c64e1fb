//! Builds the scene from the tree: the keys and their meaning.

use std::collections::BTreeMap;

use passivity_core::{Loop, Parameter};

use crate::diagnostic::{Diagnostic, Kind};
use crate::parse::keys::{sections, shorten, wrong_key, wrong_section};
use crate::parse::motion::check_motion;
use crate::parse::node::{Content, Entry};
use crate::parse::reader::{Reader, Section, Spec};
use crate::parse::{controller, costs, encoder, operator, transmission};
use crate::scene::{DEFAULT_INTERVALS, Given, Motion, Scene};

/// The most intervals that a scene may ask a simulation for.
pub const MAX_INTERVALS: u64 = 1_000_000_000;

/// The longest name of a scene, in characters.
const MAX_NAME: usize = 200;

/// The sections of a file, by name.
pub(super) struct Sections(pub(super) Vec<Section>);

impl Sections {
    pub(super) fn take(&mut self, name: &str) -> Option<Section> {
        let at = self.0.iter().position(|section| section.name == name)?;
        Some(self.0.remove(at))
    }
}

/// The parameters read so far.
#[derive(Default)]
pub(super) struct Parameters(BTreeMap<Parameter, Given>);

impl Parameters {
    /// Notes what was read; nothing where it could not be.
    pub(super) fn insert(&mut self, parameter: Parameter, given: Option<Given>) {
        if let Some(given) = given {
            self.0.insert(parameter, given);
        }
    }

    /// What was read of a parameter.
    pub(super) fn get(&self, parameter: Parameter) -> Option<&Given> {
        self.0.get(&parameter)
    }

    /// Takes a parameter from a section, by whichever of its keys stands there; whether one does.
    pub(super) fn read(
        &mut self,
        parameter: Parameter,
        section: &mut Section,
        reader: &mut Reader<'_>,
    ) -> bool {
        let row = parameter.row();
        let keys = match row.dimensionless_key {
            Some(key) if section.name == "dimensionless" => vec![key],
            _ => {
                let all = [row.key].into_iter().chain(row.other_keys.iter().copied());
                let home = |key: &'static str| key.rsplit_once('.').map(|(home, _)| home);
                all.filter(|key| home(key) == Some(section.name)).collect()
            }
        };
        let found = match keys.as_slice() {
            [first, second] => {
                let [a, b] = reader.either(section, [first, second]);
                vec![(*first, a), (*second, b)]
            }
            keys => keys.iter().map(|key| (*key, section.take(key))).collect(),
        };
        let is_there = found.iter().any(|(_, entry)| entry.is_some());
        // Two keys of one section were told of already.
        let elsewhere = self.get(parameter).cloned();
        for (key, entry) in found {
            let given = entry.and_then(|entry| value(parameter, key, false, entry, reader));
            if let (Some(own), Some(other)) = (&given, &elsewhere)
                && parameter != Parameter::Inertia
            {
                reader.report(twice(own, other));
            }
            let before = self.0.remove(&parameter);
            self.insert(
                parameter,
                match (before, given) {
                    (Some(before), Some(given)) => Some(before.and(given)),
                    (before, given) => given.or(before),
                },
            );
        }
        is_there
    }

    /// The loop of what was read; `None` where a required parameter is missing.
    fn assembled(mut self, dimensionless: bool) -> Option<Loop<Given>> {
        let mut required = |parameter| {
            let unit = || dimensionless.then(|| Given::unit(parameter));
            self.0.remove(&parameter).or_else(unit)
        };
        let stiffness = required(Parameter::Stiffness)?;
        let mut given = Loop::new(stiffness, required(Parameter::Period)?);
        if dimensionless {
            given.resolution = Some(Given::unit(Parameter::Resolution));
        }
        // Damping of zero is no damping, and a filter with no time constant no filter: the loop
        // without them is the same.
        let is_zero = |given: Option<&Given>| given.is_some_and(Given::is_zero);
        if is_zero(self.0.get(&Parameter::Damping)) {
            self.0.remove(&Parameter::Damping);
            self.0.remove(&Parameter::DampingTimeConstant);
        }
        for parameter in [Parameter::DampingTimeConstant, Parameter::Latency] {
            if is_zero(self.0.get(&parameter)) {
                self.0.remove(&parameter);
            }
        }
        let rest = self.0.into_iter();
        Some(rest.fold(given, |given, (parameter, value)| {
            given.with(parameter, value)
        }))
    }
}

/// The value of a parameter under one of its keys, at the motor where that is said of the encoder.
pub(super) fn value(
    parameter: Parameter,
    key: &'static str,
    at_motor: bool,
    entry: Entry,
    reader: &mut Reader<'_>,
) -> Option<Given> {
    let mut spec = Spec::new(parameter, key);
    spec.at_motor |= at_motor;
    match key {
        "wall.damping_cutoff" => reader.cutoff(entry, &spec),
        "sampling.rate" => reader.reciprocal(entry, &spec),
        "encoder.counts_per_revolution" | "joint.encoder.counts_per_revolution" => {
            encoder::counts_per_revolution(&entry, key, at_motor, reader)
        }
        _ => reader.quantity(entry, &spec),
    }
}

/// What is said of a parameter that is given at the device and at the motor.
fn twice(own: &Given, other: &Given) -> Diagnostic {
    let message = format!("`{}` and `{}` cannot both be given", own.key, other.key);
    Diagnostic::new(Kind::ConflictingKeys, message)
        .at(own.span.clone())
        .key(own.key)
        .expected("one of the two: the whole of it, at the side where it was measured")
}

/// Builds the scene; on a mistake the reader holds what is wrong.
pub(super) fn scene(name: &str, entries: Vec<Entry>, reader: &mut Reader<'_>) -> Option<Scene> {
    let (given_name, mut sections) = split(entries, reader);
    let mut parameters = Parameters::default();
    let point = sections.take("dimensionless");
    reader.dimensionless = point.is_some();
    if reader.dimensionless {
        refuse_beside_point(&mut sections, reader);
    }
    reader.transmission = sections
        .take("transmission")
        .and_then(|section| transmission::read(section, reader));
    // The wall comes first: its stiffness tells what units to expect of the others.
    let unilateral = read_wall(sections.take("wall"), &mut parameters, reader);
    for section in [point, sections.take("device")].into_iter().flatten() {
        let of_device = [Parameter::Inertia, Parameter::Viscous, Parameter::Coulomb];
        read_section(section, &of_device, None, &mut parameters, reader);
    }
    if let Some(section) = sections.take("motor") {
        transmission::read_motor(section, &mut parameters, reader);
    }
    if let Some(section) = sections.take("encoder") {
        encoder::read(section, &mut parameters, reader);
    }
    let delay = read_sampling(sections.take("sampling"), &mut parameters, reader);
    if let Some(section) = sections.take("amplifier") {
        let what = Some("`time_constant`");
        read_section(
            section,
            &[Parameter::TimeConstant],
            what,
            &mut parameters,
            reader,
        );
    }
    let controller = sections
        .take("controller")
        .and_then(|section| controller::read(section, &parameters, reader));
    let operator = sections.take("operator");
    let forces = operator.and_then(|section| operator::read(section, &mut parameters, reader));
    if let Some(section) = sections.take("start") {
        let start = [Parameter::StartPosition, Parameter::StartVelocity];
        let what = Some("`position` or `velocity`");
        read_section(section, &start, what, &mut parameters, reader);
    }
    let intervals = read_run(sections.take("run"), reader);
    check_motion(reader);
    if !reader.problems.is_empty() {
        return None;
    }
    let motion = if reader.dimensionless {
        Motion::Dimensionless
    } else {
        reader.motion().unwrap_or(Motion::Linear)
    };
    let mut given = parameters.assembled(reader.dimensionless)?;
    given.delay = delay;
    given.unilateral = unilateral;
    given.controller = controller;
    let given = costs::computed(given, reader)?;
    Some(Scene {
        name: given_name.unwrap_or_else(|| name.to_owned()),
        motion,
        given,
        transmission: reader.transmission.take(),
        forces,
        intervals: intervals.unwrap_or(DEFAULT_INTERVALS),
    })
}

/// Reads the parameters of a section that has nothing else. One that needs one of them says so in
/// `needed`.
fn read_section(
    mut section: Section,
    of_section: &[Parameter],
    needed: Option<&str>,
    parameters: &mut Parameters,
    reader: &mut Reader<'_>,
) {
    let mut found = false;
    for parameter in of_section {
        found |= parameters.read(*parameter, &mut section, reader);
    }
    if let (Some(what), false) = (needed, found) {
        reader.missing(Some(&section), section.name, what);
    }
    reader.leftovers(section);
}

/// The name and the sections; what is neither is reported.
pub(super) fn split(entries: Vec<Entry>, reader: &mut Reader<'_>) -> (Option<String>, Sections) {
    let mut name = None;
    let mut found = Vec::new();
    for entry in entries {
        let known = sections().find(|section| *section == entry.key);
        match (known, entry.node.content) {
            (Some(section), Content::Table(entries)) => found.push(Section {
                name: section,
                span: entry.key_span,
                entries,
            }),
            (Some(section), _) => reader.report(
                Diagnostic::new(Kind::WrongType, format!("`{section}` is not a section"))
                    .at(entry.key_span)
                    .key(section)
                    .expected(format!("a section `[{section}]` with its keys")),
            ),
            (None, Content::Text(text, _)) if entry.key == "name" => {
                name = read_name(&text);
                if name.is_none() {
                    let diagnostic = Diagnostic::new(Kind::OutOfBounds, "this is not a name")
                        .at(entry.node.span)
                        .key("name")
                        .expected(format!("a line of 1 to {MAX_NAME} printable characters"));
                    reader.report(diagnostic);
                }
            }
            (None, _) if entry.key == "name" => reader.report(
                Diagnostic::new(Kind::WrongType, "a name is text")
                    .at(entry.node.span)
                    .key("name")
                    .expected("text such as `\"my wall\"`"),
            ),
            (None, Content::Table(_)) => {
                let key = shorten(&entry.key);
                reader.report(wrong_section(&entry.key).at(entry.key_span).key(key));
            }
            (None, _) => {
                let key = shorten(&entry.key);
                reader.report(wrong_key("", &entry.key).at(entry.key_span).key(key));
            }
        }
    }
    (name, Sections(found))
}

pub(super) fn read_name(text: &str) -> Option<String> {
    let name = text.trim();
    let fits = !name.is_empty() && name.chars().count() <= MAX_NAME;
    (fits && !name.chars().any(char::is_control)).then(|| name.to_owned())
}

/// A dimensionless scene says in β, σ and μ what these sections say in units.
fn refuse_beside_point(sections: &mut Sections, reader: &mut Reader<'_>) {
    for name in ["device", "encoder", "motor", "transmission"] {
        if let Some(section) = sections.take(name) {
            let message = format!("[{name}] and [dimensionless] cannot both be given");
            let diagnostic = Diagnostic::new(Kind::ConflictingKeys, message)
                .at(section.span)
                .key(name)
                .expected("one of the two");
            reader.report(diagnostic);
        }
    }
}

/// Says of a key that a dimensionless scene has it as a unit already.
fn refuse_unit(entry: &Entry, key: &str, reader: &mut Reader<'_>) {
    let message = format!("`{key}` and [dimensionless] cannot both be given");
    let diagnostic = Diagnostic::new(Kind::ConflictingKeys, message)
        .at(entry.key_span.clone())
        .key(key)
        .expected("nothing here: K, T and Δ are the units of a dimensionless scene");
    reader.report(diagnostic);
}

/// The wall; whether it is one-sided.
fn read_wall(
    section: Option<Section>,
    parameters: &mut Parameters,
    reader: &mut Reader<'_>,
) -> bool {
    let Some(mut section) = section else {
        if !reader.dimensionless {
            reader.missing(None, "wall", "`stiffness`");
        }
        return false;
    };
    read_unit(
        Parameter::Stiffness,
        "`stiffness`",
        &mut section,
        parameters,
        reader,
    );
    let rest = [
        Parameter::DampingTimeConstant,
        Parameter::MaxForce,
        Parameter::ForceStep,
    ];
    let filter = section.span.clone();
    let [is_filtered, _, _] =
        rest.map(|parameter| parameters.read(parameter, &mut section, reader));
    let is_damped = parameters.read(Parameter::Damping, &mut section, reader);
    if let Some(diagnostic) = controller::nothing_to_filter(is_filtered, is_damped) {
        reader.report(diagnostic.at(filter));
    }
    for key in ["direction", "stiffness_matrix"] {
        if let Some(entry) = section.take(key) {
            let message = format!("a wall with a `{key}` acts on a device of several joints");
            let diagnostic = Diagnostic::new(Kind::MissingKey, message)
                .at(entry.key_span)
                .key(format!("wall.{key}"))
                .expected("`[[joint]]` for each joint, in place of [device] and [encoder]");
            reader.report(diagnostic);
        }
    }
    let unilateral = section.take("unilateral");
    let unilateral = unilateral.and_then(|entry| reader.flag(&entry, "wall.unilateral"));
    reader.leftovers(section);
    unilateral.unwrap_or(false)
}

/// Reads a parameter that every scene with units has and that is a unit of a dimensionless one.
fn read_unit(
    parameter: Parameter,
    what: &str,
    section: &mut Section,
    parameters: &mut Parameters,
    reader: &mut Reader<'_>,
) {
    if reader.dimensionless {
        let row = parameter.row();
        for key in [row.key].into_iter().chain(row.other_keys.iter().copied()) {
            if let Some(entry) = section.take(key) {
                refuse_unit(&entry, key, reader);
            }
        }
    } else if !parameters.read(parameter, section, reader) {
        reader.missing(Some(section), section.name, what);
    }
}

/// T; the delay in samples.
fn read_sampling(
    section: Option<Section>,
    parameters: &mut Parameters,
    reader: &mut Reader<'_>,
) -> u16 {
    let Some(mut section) = section else {
        if !reader.dimensionless {
            reader.missing(None, "sampling", "`period` or `rate`");
        }
        return 0;
    };
    read_unit(
        Parameter::Period,
        "`period` or `rate`",
        &mut section,
        parameters,
        reader,
    );
    parameters.read(Parameter::Latency, &mut section, reader);
    let delay = section.take("delay").and_then(|entry| {
        let whole = reader.whole(&entry, "sampling.delay", (0, u16::MAX.into()))?;
        u16::try_from(whole).ok()
    });
    reader.leftovers(section);
    delay.unwrap_or(0)
}

fn read_run(section: Option<Section>, reader: &mut Reader<'_>) -> Option<u64> {
    let mut section = section?;
    let entry = section.take("intervals");
    reader.leftovers(section);
    reader.whole(&entry?, "run.intervals", (1, MAX_INTERVALS))
}
