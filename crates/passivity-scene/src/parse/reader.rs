//! Reads typed values from the tree and collects all mistakes.

use std::ops::Range;
use std::path::Path;

use num_traits::ToPrimitive;
use passivity_core::Parameter;
use passivity_core::parameter::Values;

use crate::diagnostic::{Diagnostic, Kind};
use crate::number;
use crate::parse::amount::{Amount, Fault};
use crate::parse::keys::{shorten, wrong_key};
use crate::parse::measure::{Measure, describe};
use crate::parse::node::{Content, Entry, Node};
use crate::scene::{Given, Motion, Transmission};
use crate::units::Unit;
use crate::written::Form;

/// A section of the file, from which keys are taken; what stays is unknown.
pub(super) struct Section {
    pub(super) name: &'static str,
    /// The place of its name.
    pub(super) span: Range<usize>,
    pub(super) entries: Vec<Entry>,
}

impl Section {
    pub(super) fn take(&mut self, key: &str) -> Option<Entry> {
        let short = key.rsplit('.').next().unwrap_or(key);
        let at = self.entries.iter().position(|entry| entry.key == short)?;
        Some(self.entries.remove(at))
    }
}

/// How a key is read: its full name, what it measures and which values it may have.
#[derive(Clone, Copy)]
pub(super) struct Spec {
    pub(super) key: &'static str,
    pub(super) measure: Measure,
    pub(super) values: Values,
    pub(super) parameter: Parameter,
    /// Whether the value is one at the motor's side of a transmission.
    pub(super) at_motor: bool,
}

impl Spec {
    /// How `key`, one of a parameter's, is read.
    pub(super) fn new(parameter: Parameter, key: &'static str) -> Self {
        let row = parameter.row();
        let measure = match key {
            "device.mass" => Measure::Mass,
            "sampling.rate" | "wall.damping_cutoff" => Measure::Rate,
            _ => Measure::of(row.unit),
        };
        Self {
            key,
            measure,
            // What is read as a reciprocal cannot be zero.
            values: match measure {
                Measure::Rate => Values::Positive,
                _ => row.values,
            },
            parameter,
            at_motor: key.starts_with("motor."),
        }
    }
}

/// A key whose unit tells how the device moves.
pub(super) struct UnitNote {
    pub(super) key: &'static str,
    pub(super) measure: Option<Measure>,
    pub(super) motion: Motion,
    pub(super) unit: String,
    pub(super) span: Range<usize>,
}

/// What was read so far beside the values: mistakes, and units that tell of a motion.
pub(super) struct Reader<'a> {
    pub(super) problems: Vec<Diagnostic>,
    pub(super) unit_notes: Vec<UnitNote>,
    pub(super) dimensionless: bool,
    /// What stands between the motor and the device.
    pub(super) transmission: Option<Transmission>,
    /// Where files that the scene names are looked for; `None` when it may name none.
    pub(super) folder: Option<&'a Path>,
}

impl Reader<'_> {
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        self.problems.push(diagnostic);
    }

    /// The motion that the units read so far tell of.
    pub(super) fn motion(&self) -> Option<Motion> {
        self.unit_notes.first().map(|note| note.motion)
    }

    /// Reads a quantity; what is wrong with it goes to the problems.
    pub(super) fn quantity(&mut self, entry: Entry, spec: &Spec) -> Option<Given> {
        self.amount(&entry.node, spec)
            .and_then(|amount| self.given(&entry.node, spec, &amount, Form::Value))
    }

    /// Reads a rate as the time that is its reciprocal.
    pub(super) fn reciprocal(&mut self, entry: Entry, spec: &Spec) -> Option<Given> {
        self.amount(&entry.node, spec)
            .and_then(|amount| self.given(&entry.node, spec, &amount, Form::Reciprocal))
    }

    /// Reads the cutoff f of a one-pole filter as its time constant 1/(2πf).
    pub(super) fn cutoff(&mut self, entry: Entry, spec: &Spec) -> Option<Given> {
        self.amount(&entry.node, spec)
            .and_then(|amount| self.given(&entry.node, spec, &amount, Form::Cutoff))
    }

    /// The motion of what a key is of, as far as it is known: a motor turns.
    fn motion_of(&self, spec: &Spec) -> Option<Motion> {
        match spec.at_motor {
            true => Some(Motion::Rotary),
            false => self.motion(),
        }
    }

    fn expected(&self, spec: &Spec) -> String {
        if !self.dimensionless {
            return spec.measure.expected(self.motion_of(spec));
        }
        let unit = match spec.measure {
            Measure::Inertia | Measure::Mass => "KT²",
            Measure::Viscous => "KT",
            Measure::Force => "KΔ",
            Measure::Stiffness => "K",
            Measure::Position => "ticks",
            Measure::Speed => "ticks per sample",
            Measure::Time | Measure::Rate => "sampling periods",
        };
        format!("a plain number such as `\"3/5\"`, in {unit}")
    }

    /// The number and the unit of a value, when it has the right form and unit.
    fn amount(&mut self, node: &Node, spec: &Spec) -> Option<Amount> {
        let expected = self.expected(spec);
        let about = |diagnostic: Diagnostic| diagnostic.key(spec.key).expected(expected.clone());
        let text = match &node.content {
            Content::Text(text, _) => text,
            // A plain number is all that a dimensionless scene needs.
            Content::Number(literal) if self.dimensionless => literal,
            Content::Number(literal) => {
                let message = format!("`{}` is a number without a unit", spec.key);
                let found = shorten(literal);
                let help = format!("write number and unit in quotes: `\"{found} …\"`");
                let diagnostic = Diagnostic::new(Kind::MissingUnit, message)
                    .at(node.span.clone())
                    .found(format!("`{found}`"))
                    .help(Some(help));
                self.report(about(diagnostic));
                return None;
            }
            _ => {
                let message = format!("`{}` is {}", spec.key, node.words());
                let diagnostic = Diagnostic::new(Kind::WrongType, message)
                    .at(node.span.clone())
                    .found(node.words());
                self.report(about(diagnostic));
                return None;
            }
        };
        let plain = |_: &str| Ok(Unit::one());
        let amount = if self.dimensionless {
            Amount::parse(text, plain)
        } else {
            let known = self.motion_of(spec);
            let fits = |unit: &Unit| {
                let read = spec.measure.reads(unit);
                read.is_some_and(|(motion, _)| {
                    motion.is_none() || known.is_none() || motion == known
                })
            };
            Amount::parse(text, |unit| Unit::parse_for(unit, fits))
        };
        let checked = amount.and_then(|amount| self.check_unit(amount, text, spec));
        match checked {
            Ok(amount) => Some(amount),
            Err(fault) => {
                let found = text.get(fault.span.clone()).unwrap_or_default();
                let tolerance = fault.kind == Kind::MalformedTolerance;
                let mut diagnostic = Diagnostic::new(fault.kind, fault.message)
                    .at(node.part(fault.span))
                    .help(fault.help);
                if !found.is_empty() {
                    diagnostic = diagnostic.found(format!("`{}`", shorten(found)));
                }
                diagnostic = about(diagnostic);
                if tolerance {
                    diagnostic = diagnostic.expected(
                        "a tolerance such as `± 10%` or `± 1e-6`, or a range with the smaller number first, such \
                         as `2 … 5`",
                    );
                }
                self.report(diagnostic);
                None
            }
        }
    }

    /// Whether the unit is one of the key; notes the motion that it tells of.
    fn check_unit(&mut self, mut amount: Amount, text: &str, spec: &Spec) -> Result<Amount, Fault> {
        if self.dimensionless {
            return check_plain(amount, spec);
        }
        let Some((unit_text, span)) = &amount.unit_text else {
            return Err(Fault {
                kind: Kind::MissingUnit,
                span: 0..text.len(),
                message: format!("`{}` is a number without a unit", spec.key),
                help: None,
            });
        };
        let dimension = amount.unit.dimension();
        let wrong = |help| Fault {
            kind: Kind::WrongUnit,
            span: span.clone(),
            message: format!(
                "`{}` has the unit `{}` of {}",
                spec.key,
                shorten(unit_text),
                describe(dimension)
            ),
            help,
        };
        let Some((motion, weight)) = spec.measure.reads(&amount.unit) else {
            let weight = amount.unit.as_weight();
            let is_weight = weight.is_some_and(|w| spec.measure.accepts(w.dimension()).is_some());
            let help = "write the weight of a mass as `gf`, `kgf`, `ozf` or `lbf`".to_owned();
            return Err(wrong(is_weight.then_some(help)));
        };
        if let Some(weight) = weight {
            amount.unit = weight;
            amount.is_weight = true;
        }
        if spec.at_motor {
            return match motion {
                Some(Motion::Linear) => Err(wrong(None)),
                _ => Ok(amount),
            };
        }
        if let Some(motion) = motion {
            self.unit_notes.push(UnitNote {
                key: spec.key,
                measure: Some(spec.measure),
                motion,
                unit: shorten(unit_text),
                span: span.clone(),
            });
        }
        Ok(amount)
    }

    /// Reads a whole number between `least` and `most`, ends included.
    pub(super) fn whole(&mut self, entry: &Entry, key: &str, range: (u64, u64)) -> Option<u64> {
        let (least, most) = range;
        let expected = format!("a whole number from {least} to {most}");
        let node = &entry.node;
        let about = |d: Diagnostic| d.at(node.span.clone()).key(key).expected(expected.clone());
        let (Content::Text(literal, _) | Content::Number(literal)) = &node.content else {
            let message = format!("`{key}` is {}", node.words());
            let diagnostic = Diagnostic::new(Kind::WrongType, message).found(node.words());
            self.report(about(diagnostic));
            return None;
        };
        let found = format!("`{}`", shorten(literal));
        match number::parse(literal) {
            Ok(value) => {
                let whole = value.is_integer().then(|| value.numer().to_u64()).flatten();
                let accepted = whole.filter(|n| (least..=most).contains(n));
                if accepted.is_none() {
                    let message = format!("`{key}` cannot be {found}");
                    let diagnostic = Diagnostic::new(Kind::OutOfBounds, message).found(found);
                    self.report(about(diagnostic));
                }
                accepted
            }
            Err(error) => {
                let kind = Kind::Number(error.kind());
                let diagnostic = Diagnostic::new(kind, error.to_string()).found(found);
                self.report(about(diagnostic));
                None
            }
        }
    }

    /// Reads `true` or `false`.
    pub(super) fn flag(&mut self, entry: &Entry, key: &str) -> Option<bool> {
        if let Content::Bool(flag) = entry.node.content {
            return Some(flag);
        }
        let message = format!("`{key}` is {}", entry.node.words());
        let diagnostic = Diagnostic::new(Kind::WrongType, message)
            .at(entry.node.span.clone())
            .key(key)
            .expected("`true` or `false`")
            .found(entry.node.words());
        self.report(diagnostic);
        None
    }

    /// Takes one of two keys that say the same; both are a mistake.
    pub(super) fn either(&mut self, section: &mut Section, keys: [&str; 2]) -> [Option<Entry>; 2] {
        let [first, second] = keys.map(|key| section.take(key));
        if let (Some(first), Some(second)) = (&first, &second) {
            let later = first.key_span.start.max(second.key_span.start);
            let (later, earlier) = if later == second.key_span.start {
                (second, keys)
            } else {
                (first, [keys[1], keys[0]])
            };
            let [kept, other] = earlier;
            let message = format!("`{other}` and `{kept}` cannot both be given");
            let diagnostic = Diagnostic::new(Kind::ConflictingKeys, message)
                .at(later.key_span.clone())
                .key(other)
                .expected("one of the two");
            self.report(diagnostic);
        }
        [first, second]
    }

    /// Says that a key is not there.
    pub(super) fn missing(&mut self, section: Option<&Section>, name: &str, what: &str) {
        let message = match section {
            Some(_) => format!("[{name}] has no {what}"),
            None => format!("the scene has no [{name}] with {what}"),
        };
        let diagnostic = Diagnostic::new(Kind::MissingKey, message)
            .at(section.map_or(0..0, |section| section.span.clone()))
            .key(name)
            .expected(what);
        self.report(diagnostic);
    }

    /// Says of every key that is left in a section that it does not belong there.
    pub(super) fn leftovers(&mut self, section: Section) {
        for entry in section.entries {
            let key = format!("{}.{}", section.name, shorten(&entry.key));
            let diagnostic = wrong_key(section.name, &entry.key);
            self.report(diagnostic.at(entry.key_span).key(key));
        }
    }
}

/// Whether a unit of a dimensionless scene is one of the words that may stand there.
fn check_plain(amount: Amount, spec: &Spec) -> Result<Amount, Fault> {
    let words: &[&str] = match spec.measure {
        Measure::Position => &["tick", "ticks"],
        Measure::Speed => &["tick/sample", "ticks/sample", "ticks per sample"],
        Measure::Time => &["sample", "samples"],
        _ => &[],
    };
    match &amount.unit_text {
        Some((unit, span)) if !words.contains(&unit.as_str()) => Err(Fault {
            kind: Kind::WrongUnit,
            span: span.clone(),
            message: format!(
                "`{}` has the unit `{}` in a dimensionless scene",
                spec.key,
                shorten(unit)
            ),
            help: None,
        }),
        _ => Ok(amount),
    }
}
