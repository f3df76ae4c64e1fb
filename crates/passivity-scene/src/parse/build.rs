//! From the tree to the scene: which keys there are and what each of them means.

use num_bigint::BigInt;
use passivity_core::bounds::Quantity;
use passivity_core::{BigRational, Interval, Scalar};

use crate::diagnostic::{Diagnostic, Kind};
use crate::exact::Exact;
use crate::parse::keys::{sections, shorten, wrong_key, wrong_section};
use crate::parse::measure::Measure;
use crate::parse::node::{Content, Entry};
use crate::parse::operator;
use crate::parse::reader::{Reader, Section, Spec, Told};
use crate::point::default_given;
use crate::scene::{DEFAULT_INTERVALS, Given, Motion, Scene, Start};

/// The most intervals that a scene may ask a simulation for.
pub const MAX_INTERVALS: u64 = 1_000_000_000;

/// The most counts per revolution that are believed of an encoder.
pub const MAX_COUNTS: u64 = 1_000_000_000_000;

/// The longest name of a scene, in characters.
const MAX_NAME: usize = 200;

/// The sections of a file, by name.
struct Sections(Vec<Section>);

impl Sections {
    fn take(&mut self, name: &str) -> Option<Section> {
        let at = self.0.iter().position(|section| section.name == name)?;
        Some(self.0.remove(at))
    }
}

/// Builds the scene; on a mistake the reader holds what is wrong.
pub(super) fn scene(name: &str, entries: Vec<Entry>, reader: &mut Reader<'_>) -> Option<Scene> {
    let (given_name, mut sections) = split(entries, reader);
    let point = sections.take("dimensionless");
    reader.dimensionless = point.is_some();
    // The wall comes first: its stiffness tells what units to expect of the others.
    let wall = sections.take("wall");
    let wall = read_wall(wall, reader);
    let device = match point {
        Some(point) => {
            refuse_beside_point(&mut sections, reader);
            read_point(point, reader)
        }
        None => read_device(sections.take("device"), reader),
    };
    let resolution = read_encoder(sections.take("encoder"), reader);
    let (period, delay) = read_sampling(sections.take("sampling"), reader);
    let amplifier = sections.take("amplifier").and_then(|mut section| {
        let spec = Spec::new(
            "amplifier.time_constant",
            Measure::Time,
            Quantity::TimeConstant,
        );
        let entry = section.take(spec.key);
        if entry.is_none() {
            reader.missing(Some(&section), "amplifier", "`time_constant`");
        }
        let given = entry.and_then(|entry| reader.quantity(entry, &spec));
        reader.leftovers(section);
        given
    });
    let operator = operator::read(sections.take("operator"), reader);
    let start = read_start(sections.take("start"), reader);
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
    let unit = |key| default_given(key, BigRational::one());
    let by_default = |key| reader.dimensionless.then(|| unit(key));
    Some(Scene {
        name: given_name.unwrap_or_else(|| name.to_owned()),
        motion,
        inertia: device.inertia,
        viscous: device.viscous,
        coulomb: device.coulomb,
        period: period.or_else(|| by_default("sampling.period"))?,
        delay,
        resolution: resolution.or_else(|| by_default("encoder.resolution")),
        stiffness: wall.stiffness.or_else(|| by_default("wall.stiffness"))?,
        unilateral: wall.unilateral,
        damping: wall.damping,
        max_force: wall.max_force,
        force_step: wall.force_step,
        amplifier,
        max_speed: operator.max_speed,
        force: operator.force,
        arm: operator.arm,
        start,
        intervals: intervals.unwrap_or(DEFAULT_INTERVALS),
    })
}

/// The name and the sections; what is neither is reported.
fn split(entries: Vec<Entry>, reader: &mut Reader<'_>) -> (Option<String>, Sections) {
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

fn read_name(text: &str) -> Option<String> {
    let name = text.trim();
    let fits = !name.is_empty() && name.chars().count() <= MAX_NAME;
    (fits && !name.chars().any(char::is_control)).then(|| name.to_owned())
}

/// m, b and c, or their dimensionless counterparts.
#[derive(Default)]
struct Device {
    inertia: Option<Given>,
    viscous: Option<Given>,
    coulomb: Option<Given>,
}

fn read_device(section: Option<Section>, reader: &mut Reader<'_>) -> Device {
    let Some(mut section) = section else {
        return Device::default();
    };
    let inertia = Spec::new("device.inertia", Measure::Inertia, Quantity::Inertia);
    let mass = Spec::new("device.mass", Measure::Mass, Quantity::Inertia);
    let viscous = Spec::new("device.viscous", Measure::Viscous, Quantity::Viscous);
    let coulomb = Spec::new("device.coulomb", Measure::Force, Quantity::Coulomb);
    let [by_inertia, by_mass] = reader.either(&mut section, [inertia.key, mass.key]);
    let by_inertia = by_inertia.and_then(|entry| reader.quantity(entry, &inertia));
    let by_mass = by_mass.and_then(|entry| reader.quantity(entry, &mass));
    let device = Device {
        inertia: by_inertia.or(by_mass),
        viscous: optional(&mut section, reader, &viscous),
        coulomb: optional(&mut section, reader, &coulomb),
    };
    reader.leftovers(section);
    device
}

fn read_point(mut section: Section, reader: &mut Reader<'_>) -> Device {
    let mu = Spec::new("dimensionless.mu", Measure::Inertia, Quantity::Inertia);
    let beta = Spec::new("dimensionless.beta", Measure::Viscous, Quantity::Viscous);
    let sigma = Spec::new("dimensionless.sigma", Measure::Force, Quantity::Coulomb);
    let device = Device {
        inertia: optional(&mut section, reader, &mu),
        viscous: optional(&mut section, reader, &beta),
        coulomb: optional(&mut section, reader, &sigma),
    };
    reader.leftovers(section);
    device
}

/// A dimensionless scene says in β, σ and μ what these sections say in units.
fn refuse_beside_point(sections: &mut Sections, reader: &mut Reader<'_>) {
    for name in ["device", "encoder"] {
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

fn optional(section: &mut Section, reader: &mut Reader<'_>, spec: &Spec) -> Option<Given> {
    let entry = section.take(spec.key)?;
    reader.quantity(entry, spec)
}

#[derive(Default)]
struct Wall {
    stiffness: Option<Given>,
    unilateral: bool,
    damping: Option<Given>,
    max_force: Option<Given>,
    force_step: Option<Given>,
}

fn read_wall(section: Option<Section>, reader: &mut Reader<'_>) -> Wall {
    let Some(mut section) = section else {
        if !reader.dimensionless {
            reader.missing(None, "wall", "`stiffness`");
        }
        return Wall::default();
    };
    let spec = Spec::new("wall.stiffness", Measure::Stiffness, Quantity::Stiffness);
    let stiffness = match section.take(spec.key) {
        Some(entry) if reader.dimensionless => {
            refuse_unit(&entry, spec.key, reader);
            None
        }
        Some(entry) => reader.quantity(entry, &spec),
        None if reader.dimensionless => None,
        None => {
            reader.missing(Some(&section), "wall", "`stiffness`");
            None
        }
    };
    let damping = Spec::new("wall.damping", Measure::Viscous, Quantity::Damping);
    let max_force = Spec::new("wall.max_force", Measure::Force, Quantity::MaxForce);
    let force_step = Spec::new("wall.force_step", Measure::Force, Quantity::ForceStep);
    let unilateral = section.take("unilateral");
    let wall = Wall {
        stiffness,
        unilateral: unilateral
            .and_then(|entry| reader.flag(&entry, "wall.unilateral"))
            .unwrap_or(false),
        damping: optional(&mut section, reader, &damping),
        max_force: optional(&mut section, reader, &max_force),
        force_step: optional(&mut section, reader, &force_step),
    };
    reader.leftovers(section);
    wall
}

/// Δ: given, or 2π/N of N counts per revolution.
fn read_encoder(section: Option<Section>, reader: &mut Reader<'_>) -> Option<Given> {
    const COUNTS: &str = "encoder.counts_per_revolution";
    let mut section = section?;
    let spec = Spec::new(
        "encoder.resolution",
        Measure::Position,
        Quantity::Resolution,
    );
    let [by_counts, by_resolution] = reader.either(&mut section, [COUNTS, spec.key]);
    if by_counts.is_none() && by_resolution.is_none() {
        let what = "`counts_per_revolution` or `resolution`";
        reader.missing(Some(&section), "encoder", what);
    }
    reader.leftovers(section);
    let by_resolution = by_resolution.and_then(|entry| reader.quantity(entry, &spec));
    let Some(entry) = by_counts else {
        return by_resolution;
    };
    let counts = reader.whole(&entry, COUNTS, (1, MAX_COUNTS))?;
    reader.told.push(Told {
        key: COUNTS,
        measure: None,
        motion: Motion::Rotary,
        unit: "counts per revolution".to_owned(),
        span: entry.node.span.clone(),
    });
    let turn = BigRational::new(BigInt::from(2), BigInt::from(counts));
    let value = Exact::new(Interval::point(turn), 1);
    let by_counts = Given {
        key: COUNTS,
        nominal: value.clone(),
        value,
        text: counts.to_string(),
        span: entry.node.span,
    };
    by_resolution.or(Some(by_counts))
}

/// T and the delay.
fn read_sampling(
    section: Option<Section>,
    reader: &mut Reader<'_>,
) -> (Option<Given>, Option<u16>) {
    let Some(mut section) = section else {
        if !reader.dimensionless {
            reader.missing(None, "sampling", "`period` or `rate`");
        }
        return (None, None);
    };
    let period = Spec::new("sampling.period", Measure::Time, Quantity::Period);
    let rate = Spec::new("sampling.rate", Measure::Rate, Quantity::Period);
    let [by_period, by_rate] = reader.either(&mut section, [period.key, rate.key]);
    let given = if reader.dimensionless {
        for (entry, key) in [(&by_period, period.key), (&by_rate, rate.key)] {
            if let Some(entry) = entry {
                refuse_unit(entry, key, reader);
            }
        }
        None
    } else {
        if by_period.is_none() && by_rate.is_none() {
            reader.missing(Some(&section), "sampling", "`period` or `rate`");
        }
        let by_period = by_period.and_then(|entry| reader.quantity(entry, &period));
        let by_rate = by_rate.and_then(|entry| reader.reciprocal(entry, &rate));
        by_period.or(by_rate)
    };
    let delay = section.take("delay").and_then(|entry| {
        let whole = reader.whole(&entry, "sampling.delay", (0, u16::MAX.into()))?;
        u16::try_from(whole).ok()
    });
    reader.leftovers(section);
    (given, delay)
}

fn read_start(section: Option<Section>, reader: &mut Reader<'_>) -> Option<Start> {
    let mut section = section?;
    let position = Spec::any_sign("start.position", Measure::Position);
    let velocity = Spec::any_sign("start.velocity", Measure::Speed);
    let entries = [section.take(position.key), section.take(velocity.key)];
    if entries.iter().all(Option::is_none) {
        reader.missing(Some(&section), "start", "`position` or `velocity`");
    }
    reader.leftovers(section);
    let [at, with] = entries;
    let mut read = |entry: Option<Entry>, spec: &Spec| match entry {
        Some(entry) => reader.quantity(entry, spec),
        None => Some(default_given(spec.key, BigRational::zero())),
    };
    let (position, velocity) = (read(at, &position), read(with, &velocity));
    Some(Start {
        position: position?,
        velocity: velocity?,
    })
}

fn read_run(section: Option<Section>, reader: &mut Reader<'_>) -> Option<u64> {
    let mut section = section?;
    let entry = section.take("intervals");
    reader.leftovers(section);
    reader.whole(&entry?, "run.intervals", (1, MAX_INTERVALS))
}

/// Reports the units that tell of another motion than most; the stiffness decides between equals.
fn check_motion(reader: &mut Reader<'_>) {
    let count = |motion| {
        reader
            .told
            .iter()
            .filter(|told| told.motion == motion)
            .count()
    };
    let (linear, rotary) = (count(Motion::Linear), count(Motion::Rotary));
    if linear == 0 || rotary == 0 {
        return;
    }
    let kept = match linear.cmp(&rotary) {
        std::cmp::Ordering::Less => Motion::Rotary,
        std::cmp::Ordering::Greater => Motion::Linear,
        std::cmp::Ordering::Equal => reader.motion().unwrap_or(Motion::Linear),
    };
    let Some(anchor) = reader.told.iter().find(|told| told.motion == kept) else {
        return;
    };
    let word = |motion| match motion {
        Motion::Rotary => "rotary",
        _ => "linear",
    };
    let others = reader.told.iter().filter(|told| told.motion != kept);
    let mixed: Vec<Diagnostic> = others
        .map(|told| {
            let message = format!(
                "`{}` is {} (`{}`), but `{}` is {} (`{}`)",
                told.key,
                word(told.motion),
                told.unit,
                anchor.key,
                word(kept),
                anchor.unit
            );
            let expected = told.measure.map_or_else(
                || "`resolution`, a length".to_owned(),
                |measure| measure.expected(Some(kept)),
            );
            Diagnostic::new(Kind::MixedMotion, message)
                .at(told.span.clone())
                .key(told.key)
                .expected(expected)
                .found(format!("`{}`", told.unit))
        })
        .collect();
    reader.problems.extend(mixed);
}
