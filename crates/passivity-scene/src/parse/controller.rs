//! A digital controller in place of the spring: `[controller]` with its numerator and denominator.

use std::sync::Arc;

use passivity_core::transfer::{Refused, TransferFunction};
use passivity_core::{BigRational, Parameter};

use crate::diagnostic::{Diagnostic, Kind};
use crate::number;
use crate::parse::build::Parameters;
use crate::parse::keys::shorten;
use crate::parse::node::{Content, Entry, Node};
use crate::parse::reader::{Reader, Section};

/// The most coefficients of a numerator or a denominator.
const MAX_COEFFICIENTS: usize = 64;

/// What is wrong with a controller that has virtual damping beside it.
pub(super) fn two_laws(is_controlled: bool, is_damped: bool) -> Option<Diagnostic> {
    let message = "[controller] and `wall.damping` cannot both be given";
    let diagnostic = Diagnostic::new(Kind::ConflictingKeys, message)
        .key("controller")
        .expected("one of the two: a controller says what damping it has");
    (is_controlled && is_damped).then_some(diagnostic)
}

/// What is wrong with a filter on virtual damping that is not there.
pub(super) fn nothing_to_filter(is_filtered: bool, is_damped: bool) -> Option<Diagnostic> {
    let message = "the filter on the virtual damping has no damping to filter";
    let diagnostic = Diagnostic::new(Kind::MissingKey, message)
        .key("wall.damping")
        .expected("`damping` beside `damping_cutoff` or `damping_time_constant`");
    (is_filtered && !is_damped).then_some(diagnostic)
}

/// Reads H(z) = (n₀ + n₁z⁻¹ + …)/(d₀ + d₁z⁻¹ + …), in units of the stiffness.
pub(super) fn read(
    mut section: Section,
    parameters: &Parameters,
    reader: &mut Reader<'_>,
) -> Option<Arc<TransferFunction<BigRational>>> {
    let span = section.span.clone();
    if let Some(diagnostic) = two_laws(true, parameters.get(Parameter::Damping).is_some()) {
        reader.report(diagnostic.at(span.clone()));
    }
    let numerator = section.take("numerator");
    let denominator = section.take("denominator");
    if numerator.is_none() {
        reader.missing(Some(&section), "controller", "`numerator`");
    }
    reader.leftovers(section);
    let denominator = match denominator {
        Some(entry) => coefficients(&entry, "controller.denominator", reader)?,
        None => vec![BigRational::from_integer(1.into())],
    };
    let numerator = coefficients(&numerator?, "controller.numerator", reader)?;
    match TransferFunction::new(numerator, denominator) {
        Ok(controller) => Some(Arc::new(controller)),
        Err(refused) => {
            let (message, expected) = words(refused);
            let diagnostic = Diagnostic::new(Kind::OutOfBounds, message)
                .at(span)
                .key("controller")
                .expected(expected);
            reader.report(diagnostic);
            None
        }
    }
}

const fn words(refused: Refused) -> (&'static str, &'static str) {
    match refused {
        Refused::Improper => (
            "the controller is not proper: d₀ is 0, so it would need samples that are still to come",
            "a first entry of `denominator` that is not 0",
        ),
        Refused::Unstable => (
            "the controller is not stable: a root of its denominator is on or outside the unit circle",
            "roots of d₀zⁿ + d₁zⁿ⁻¹ + … + dₙ inside the unit circle",
        ),
        Refused::NegativeStiffness => (
            "the controller pushes away from the wall: H(1), what it gives at rest, is below 0",
            "a sum of `numerator` over the sum of `denominator` of 0 or above",
        ),
        Refused::Undefined => (
            "the coefficients of the controller are too long to compute with",
            "shorter numbers",
        ),
    }
}

/// A list of exact numbers, at least one of them.
fn coefficients(
    entry: &Entry,
    key: &'static str,
    reader: &mut Reader<'_>,
) -> Option<Vec<BigRational>> {
    let expected =
        format!("a list of 1 to {MAX_COEFFICIENTS} numbers such as `[\"1.5\", \"-0.5\"]`");
    let wrong = |node: &Node, kind: Kind, message: String| {
        Diagnostic::new(kind, message)
            .at(node.span.clone())
            .key(key)
            .expected(expected.clone())
    };
    let Content::List(items) = &entry.node.content else {
        let message = format!("`{key}` is {}", entry.node.words());
        reader.report(wrong(&entry.node, Kind::WrongType, message));
        return None;
    };
    if items.is_empty() || items.len() > MAX_COEFFICIENTS {
        let message = format!("`{key}` has {} entries", items.len());
        reader.report(wrong(&entry.node, Kind::OutOfBounds, message));
        return None;
    }
    let mut numbers = Vec::with_capacity(items.len());
    for item in items {
        let (Content::Text(text, _) | Content::Number(text)) = &item.content else {
            let message = format!("an entry of `{key}` is {}", item.words());
            reader.report(wrong(item, Kind::WrongType, message));
            continue;
        };
        match number::parse(text) {
            Ok(number) => numbers.push(number),
            Err(error) => {
                let message = format!("an entry of `{key}` is no exact number: {error}");
                let found = format!("`{}`", shorten(text));
                let diagnostic = wrong(item, Kind::Number(error.kind()), message);
                reader.report(diagnostic.found(found));
            }
        }
    }
    (numbers.len() == items.len()).then_some(numbers)
}
