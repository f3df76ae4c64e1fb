//! The derivation of a verdict with a scene's numbers filled in.

mod equations;
mod frequency;
mod theorems;

use std::fmt::Write as _;

use passivity_core::verdict::End;
use passivity_core::{BigRational, Effect, Parameter};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use crate::check::{Report, Verdict, check, enclosure, words};
use crate::display::{range, wrapped};
use crate::json::shape;
use crate::scene::{Motion, Scene};
use equations::{Cost, held_force, motion};
pub use frequency::Frequency;
pub(crate) use theorems::used;

/// What a line of the derivation says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// β from the parameters.
    Beta,
    /// σ from the parameters.
    Sigma,
    /// μ from the parameters.
    Mu,
    /// How a wall acts on several joints.
    Wall,
    /// The digital controller H(z).
    Controller,
    /// The force that is held.
    HeldForce,
    /// The equation of motion.
    Motion,
    /// What a sampling interval generates at most.
    Generated,
    /// What the effects cost together, and at which frequency.
    Cost,
    /// What friction dissipates at least.
    Dissipated,
    /// The criterion.
    Criterion,
    /// The speed at which the criterion meets equality.
    CriticalSpeed,
    /// The speed up to which the criterion is asked.
    SpeedBound,
    /// A cycle that draws energy.
    Witness,
}

/// One line of the derivation: an equation of the paper or a claim, in general and in numbers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Line {
    /// What the line says.
    #[serde(skip)]
    pub step: Step,
    /// The paper's equation in brackets, or the id of a claim.
    pub id: &'static str,
    /// The equation with the scene's effects, in letters.
    pub formula: String,
    /// The same with the scene's numbers; empty where there is nothing to fill in.
    pub numbers: String,
}

/// A parameter as it was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GivenText {
    /// Its key with the section.
    pub key: String,
    /// Its text in the file.
    pub text: String,
}

/// A theorem and what it says.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Theorem {
    /// Its id in the table of claims.
    pub id: &'static str,
    /// What it says, in a sentence.
    pub says: &'static str,
}

/// What `passivity explain` shows; `R` is the report of its check, that of one joint or of several.
///
/// Serialised it is the JSON of `explain --format json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Explanation<R = Report> {
    /// The scene's name.
    pub scene: String,
    /// The effects in the scene.
    #[serde(rename = "effects", with = "shape::Effects")]
    pub present: Vec<Effect>,
    /// The effects that are not: nothing is computed for them.
    #[serde(with = "shape::Effects")]
    pub absent: Vec<Effect>,
    /// The parameters as they were given, with their keys.
    #[serde(serialize_with = "given_texts")]
    #[schemars(with = "std::collections::BTreeMap<String, String>")]
    pub given: Vec<GivenText>,
    /// The derivation, which ends in the verdict.
    #[serde(rename = "derivation")]
    pub lines: Vec<Line>,
    /// The theorems used, each with what it says.
    pub theorems: Vec<Theorem>,
    /// The check that the derivation ends in.
    #[serde(rename = "check")]
    pub report: R,
}

fn given_texts<S: Serializer>(given: &[GivenText], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(given.iter().map(|given| (&given.key, &given.text)))
}

/// What is given beside parameters and a transmission, and has neither a unit nor a tolerance.
fn settings(scene: &Scene) -> Vec<(&'static str, String)> {
    let given = &scene.given;
    let mut all = Vec::new();
    if given.delay > 0 {
        all.push(("sampling.delay", given.delay.to_string()));
    }
    if given.unilateral {
        all.push(("wall.unilateral", "true".to_owned()));
    }
    if let Some(controller) = &given.controller {
        let list = |numbers: &[BigRational]| {
            let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
            numbers.join(", ")
        };
        all.push(("controller.numerator", list(controller.numerator())));
        all.push(("controller.denominator", list(controller.denominator())));
    }
    all
}

/// Explains a scene.
///
/// # Example
///
/// ```
/// use passivity_scene::{Scene, explain::explain};
///
/// let text = "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n";
/// let explanation = explain(&Scene::from_toml("point", text).unwrap());
/// assert!(explanation.to_text().contains("(3/5 − 1/2) + (3/5 − 1/2)/v ≥ 0"));
/// ```
#[must_use]
pub fn explain(scene: &Scene) -> Explanation {
    let report = check(scene);
    let transmission = scene.transmission.iter().flat_map(|t| &t.given);
    let transmission = transmission.map(|(key, text)| (*key, text.clone()));
    let parameters = scene.parameters().into_iter();
    let parameters = parameters.map(|(_, given)| (given.key, given.text.clone()));
    let given = transmission
        .chain(parameters)
        .chain(settings(scene))
        .map(|(key, text)| GivenText {
            key: key.to_owned(),
            text,
        });
    Explanation {
        scene: scene.name.clone(),
        absent: absent(&report.effects),
        given: given.collect(),
        lines: lines(scene, &report),
        theorems: used(&report.because),
        present: report.effects.clone(),
        report,
    }
}

/// The effects that are not among those of a scene.
pub(crate) fn absent(present: &[Effect]) -> Vec<Effect> {
    let mut absent = Effect::ALL.to_vec();
    absent.retain(|effect| !present.contains(effect));
    absent
}

fn lines(scene: &Scene, report: &Report) -> Vec<Line> {
    let mut lines = Vec::new();
    let mut push = |step, id, formula: String, numbers: String| {
        lines.push(Line {
            step,
            id,
            formula,
            numbers,
        });
    };
    if scene.motion != Motion::Dimensionless {
        push(
            Step::Beta,
            "(7)",
            "β = b/(KT)".to_owned(),
            units_text(scene, report, 'β'),
        );
        if scene.given.has_encoder() {
            push(
                Step::Sigma,
                "(7)",
                "σ = c/(KΔ)".to_owned(),
                units_text(scene, report, 'σ'),
            );
        }
        if let Some(mu) = &report.mu {
            push(
                Step::Mu,
                "(7)",
                "μ = m/(KT²)".to_owned(),
                format!("μ = {}", range(mu)),
            );
        }
    }
    if let Some([formula, numbers]) = equations::controller(scene) {
        push(Step::Controller, "TH-LTI", formula, numbers);
    }
    let (law, law_id) = held_force(scene);
    push(Step::HeldForce, law_id, law, String::new());
    push(Step::Motion, "(6)", motion(scene), String::new());
    let cost = Cost::of(scene);
    push(Step::Generated, cost.id, cost.bound.clone(), String::new());
    if let Some((id, [formula, numbers])) = equations::computed(scene, report) {
        push(Step::Cost, id, formula, numbers);
    }
    let (id, friction) = equations::dissipated(scene);
    push(Step::Dissipated, id, friction, String::new());
    push(
        Step::Criterion,
        "(8)",
        format!(
            "(β − {}) + (σ − {})/v ≥ 0 at every speed v > 0 that occurs",
            cost.viscous, cost.coulomb
        ),
        match scene.has_ends() {
            false => equations::criterion(scene),
            // The ends of these are those of devices.
            true if scene.either_way().is_empty() => {
                let [hardest, easiest] = [End::Hardest, End::Easiest]
                    .map(|end| equations::criterion(&scene.with_ends(end)));
                format!(
                    "at the hardest end of the tolerances: {hardest}; at the easiest: {easiest}"
                )
            }
            true => format!(
                "over the tolerances, each term for itself: ({}) + ({})/v ≥ 0",
                range(&report.spare.viscous),
                range(&report.spare.coulomb)
            ),
        },
    );
    if let Some(speed) = report.critical_ticks_text() {
        let formula = "equality at the critical speed v_c".to_owned();
        push(
            Step::CriticalSpeed,
            "TH-REGION",
            formula,
            format!("v_c = {speed}"),
        );
    }
    if let Some(v) = &report.speed_bound {
        let mut numbers = format!("V = {} {}/sample", range(v), report.length_unit());
        if let Some(margin) = &report.margin_at_speed_bound {
            let _ = write!(
                numbers,
                ", margin, the left side of (8), there {}",
                range(margin)
            );
        }
        push(
            Step::SpeedBound,
            "TH-RUN",
            "speeds up to the operator's bound V".to_owned(),
            numbers,
        );
    }
    if let (Some(witness), Some(id)) = (report.witness_text(), report.because.first()) {
        let formula = "a motion that draws energy each time round".to_owned();
        push(Step::Witness, id, formula, witness);
    }
    lines
}

/// β or σ with the scene's own figures.
fn units_text(scene: &Scene, report: &Report, which: char) -> String {
    let given = |parameter: Parameter| match scene.given.get(parameter) {
        Some(given) => match enclosure(&given.value).map(|value| range(&value)) {
            Some(both) if given.has_tolerance() => format!("({both})"),
            Some(one) => one,
            None => given.text.clone(),
        },
        None => "0".to_owned(),
    };
    let stiffness = given(Parameter::Stiffness);
    let (friction, unit, value) = match (which, &report.sigma) {
        ('σ', Some(sigma)) => (Parameter::Coulomb, Parameter::Resolution, sigma),
        _ => (Parameter::Viscous, Parameter::Period, &report.beta),
    };
    let which = if friction == Parameter::Coulomb {
        'σ'
    } else {
        'β'
    };
    format!(
        "{which} = {}/({stiffness} · {}) = {}",
        given(friction),
        given(unit),
        range(value)
    )
}

impl Explanation {
    /// The first line of the derivation that says such a thing.
    #[must_use]
    pub fn line(&self, step: Step) -> Option<&Line> {
        self.lines.iter().find(|line| line.step == step)
    }

    /// The explanation for people.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut verdict = self.report.headline();
        if self.report.verdict == Verdict::NotCovered {
            verdict += "\n  The derivation above leaves out what no theorem covers.";
        }
        self.text(&self.report.remarks, &verdict)
    }
}

impl<R> Explanation<R> {
    /// The explanation for people, with how values were taken and the verdict that the report says.
    pub(crate) fn text(&self, remarks: &[String], verdict: &str) -> String {
        // Writing to a string cannot fail.
        let mut out = format!("{}\n\nIn this scene\n", self.scene);
        for effect in &self.present {
            let _ = writeln!(out, "  {}", effect.words());
        }
        if !self.given.is_empty() {
            out.push_str("\nGiven\n");
        }
        let lengths = self.given.iter().map(|given| given.key.len() + 2);
        let width = lengths.fold(32, usize::max);
        for GivenText { key, text } in &self.given {
            let _ = writeln!(out, "  {key:<width$}{text}");
        }
        for remark in remarks {
            let _ = writeln!(out, "  {}", wrapped(&format!("Taken: {remark}."), 2));
        }
        out.push_str("\nDerivation\n");
        for line in &self.lines {
            let _ = writeln!(out, "  {:<12}{}", line.id, wrapped(&line.formula, 14));
            if !line.numbers.is_empty() {
                let _ = writeln!(out, "  {:<12}{}", "", wrapped(&line.numbers, 14));
            }
        }
        if !self.theorems.is_empty() {
            out.push_str("\nTheorems used\n");
            for Theorem { id, says } in &self.theorems {
                let _ = writeln!(out, "  {id:<12}{}", wrapped(says, 14));
            }
        }
        if !self.absent.is_empty() {
            let absent = wrapped(&words(&self.absent), 2);
            let _ = writeln!(out, "\nNot in this scene, and not computed\n  {absent}");
        }
        let _ = writeln!(out, "\nVerdict\n  {verdict}");
        out
    }
}
