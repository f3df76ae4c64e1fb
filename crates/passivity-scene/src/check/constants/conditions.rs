//! What the numbers hold only with: what the control program does beside the spring, and what the
//! device and its amplifier are like.

use passivity_core::parameter::Hurts;
use passivity_core::{BigRational, Effect, Enclosed, Parameter};
use schemars::JsonSchema;
use serde::Serialize;

use super::typed::{Typed, Written};
use crate::number::nearest_f64;
use crate::scene::{Scene, Transmission};

/// A condition under which the constants hold.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Condition {
    /// Its name, in words with underscores between them.
    pub name: &'static str,
    /// How much.
    pub value: Amount,
    /// In which unit; empty for a pure number.
    pub unit: &'static str,
    /// What is done with it, or by what.
    pub about: &'static str,
}

/// How much a condition asks for.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Amount {
    /// A whole number.
    Whole(u16),
    /// A double.
    Double(f64),
    /// The coefficients of z⁰, z⁻¹, …
    Coefficients(Vec<f64>),
}

/// The conditions of a loop; `pole` is the double that is written of the damping's filter.
pub(super) fn of<S: Enclosed>(typed: &Typed<'_, S>, pole: Option<f64>) -> Vec<Condition> {
    let scene = typed.scene;
    let mut all = Vec::new();
    let mut whole = |name, value, unit, about| {
        all.push(Condition {
            name,
            value: Amount::Whole(value),
            unit,
            about,
        });
    };
    if scene.has(Effect::Delay) {
        let about = "after which the force of a sample is given out, and not at once";
        whole("delay", scene.given.delay, "samples", about);
    }
    if scene.has(Effect::Unilateral) {
        let about = "the force is zero while the measured position is below zero";
        whole("one_sided", 1, "", about);
    }
    let filter = match pole {
        Some(_) => "of the one-pole filter that the damping stands behind",
        None => {
            "of the one-pole filter that the damping stands behind; nothing is shown with its pole a as a double"
        }
    };
    let of_parameters = [
        (
            Parameter::DampingTimeConstant,
            "damping_time_constant",
            filter,
        ),
        (
            Parameter::Latency,
            "latency",
            "from a sample, or from the end of the delay, until the force changes",
        ),
        (
            Parameter::ForceStep,
            "force_step",
            "of the D/A converter: the force is rounded to whole steps",
        ),
        (
            Parameter::Resolution,
            "encoder_resolution",
            "of the device's position, a count",
        ),
        (
            Parameter::TimeConstant,
            "amplifier_time_constant",
            "of the amplifier's first-order lag",
        ),
    ];
    for (parameter, name, about) in of_parameters {
        all.extend(typed.double(parameter).map(|value| Condition {
            name,
            value: Amount::Double(value),
            unit: typed.unit(parameter).0,
            about,
        }));
        if parameter == Parameter::DampingTimeConstant {
            all.extend(pole.map(|pole| Condition {
                name: "damping_pole",
                value: Amount::Double(pole),
                unit: "",
                about: "a of that filter",
            }));
        }
    }
    if let Some(controller) = typed.controller() {
        let lists = [controller.numerator(), controller.denominator()];
        let is_exact =
            |x: &BigRational| BigRational::from_float(nearest_f64(x)).as_ref() == Some(x);
        let about = match lists.iter().copied().flatten().all(is_exact) {
            true => "of z^0, z^-1, ... in H",
            false => {
                "of z^0, z^-1, ... in H, near those of the scene; nothing is shown of these doubles"
            }
        };
        let names = ["controller_numerator", "controller_denominator"];
        all.extend(
            names
                .into_iter()
                .zip(lists)
                .map(|(name, coefficients)| Condition {
                    name,
                    value: Amount::Coefficients(coefficients.iter().map(nearest_f64).collect()),
                    unit: "",
                    about,
                }),
        );
    }
    all
}

/// The values of the scene that the numbers rest on, as the scene writes them.
pub(super) fn given(scene: &Scene) -> Vec<String> {
    let parameters = scene.parameters().into_iter();
    let matter = parameters.filter(|(parameter, _)| {
        parameter.row().hurts != Hurts::Neither || *parameter == Parameter::MaxForce
    });
    let values = matter.map(|(_, given)| format!("{} {}", given.key, given.text));
    let transmission = scene.transmission.as_ref().map(Transmission::remark);
    values.chain(transmission).collect()
}

/// The effects with which nothing is shown: those of the program, the device and the amplifier that
/// the scene does not have, and that the numbers do not pass with all the same.
pub(super) fn not_shown_with<S: Enclosed>(written: &Written<'_, S>) -> Vec<&'static str> {
    let any_law = written.passes_any_law();
    let absent = [
        Effect::Encoder,
        Effect::Delay,
        Effect::Latency,
        Effect::Unilateral,
        Effect::DampingFilter,
        Effect::Saturation,
        Effect::ForceStep,
        Effect::Amplifier,
    ];
    let mut absent = absent.to_vec();
    absent.retain(|effect| {
        let is_law = matches!(effect, Effect::Unilateral | Effect::Saturation);
        !(written.typed.scene.has(*effect) || (is_law && any_law))
    });
    absent.iter().map(|effect| effect.words()).collect()
}
