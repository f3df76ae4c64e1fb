//! The derivation of a verdict on several joints with the scene's numbers filled in.

use std::fmt::Write as _;

use passivity_core::joints::{Joint, Place};
use passivity_core::{Effect, Truth};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use super::JointScene;
use super::report::{JointReport, OfJoint, check};
use crate::check::figure;
use crate::display::{approx, range, wrapped};
use crate::explain::{Line, Step, Theorem};
use crate::json::shape;
use crate::scene::Given;

/// What `passivity explain` shows of a scene of several joints.
///
/// Serialised it is the JSON of `explain --format json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointExplanation {
    /// The scene's name.
    pub scene: String,
    /// The effects in the scene.
    #[serde(with = "shape::Effects")]
    pub effects: Vec<Effect>,
    /// The parameters as they were given, with their keys.
    #[serde(serialize_with = "texts")]
    #[schemars(with = "std::collections::BTreeMap<String, String>")]
    pub given: Vec<(String, String)>,
    /// The derivation, from the wall to the verdict.
    #[serde(rename = "derivation")]
    pub lines: Vec<Line>,
    /// The theorems used, each with what it says.
    pub theorems: Vec<Theorem>,
    /// The check that the derivation ends in.
    #[serde(rename = "check")]
    pub report: JointReport,
}

fn texts<S: Serializer>(given: &[(String, String)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(given.iter().map(|(key, text)| (key, text)))
}

/// Explains a scene of several joints.
#[must_use]
pub fn explain(scene: &JointScene) -> JointExplanation {
    let report = check(scene);
    let theorem = |id: &&'static str| Theorem {
        id,
        says: crate::explain::sentence(id),
    };
    JointExplanation {
        scene: scene.name.clone(),
        effects: scene.effects(),
        given: given(scene),
        lines: lines(scene, &report),
        theorems: report.because.iter().map(theorem).collect(),
        report,
    }
}

fn given(scene: &JointScene) -> Vec<(String, String)> {
    let places: Vec<Place> = scene.given.places().collect();
    let of = |place: &Place| {
        let given = scene.given.get(*place)?;
        (!given.text.is_empty()).then(|| (scene.key(*place), given.text.clone()))
    };
    let ways: Vec<&str> = scene.ways.iter().map(|way| way.text.as_str()).collect();
    let direction = ("wall.direction".to_owned(), ways.join(", "));
    let direction = Some(direction).filter(|_| !scene.has_matrix());
    places.iter().filter_map(of).chain(direction).collect()
}

fn lines(scene: &JointScene, report: &JointReport) -> Vec<Line> {
    const ID: &str = "TH-NDOF";
    let mut lines = Vec::new();
    let mut push = |step, formula: String, numbers: String| {
        lines.push(Line {
            step,
            id: ID,
            formula,
            numbers,
        });
    };
    let (wall, force) = match (scene.has_matrix(), scene.given.unilateral) {
        (true, _) => ("K as given", "−K·q̂"),
        (false, false) => ("K = k·a·aᵀ", "−k·a·(a·q̂)"),
        (false, true) => ("K = k·a·aᵀ", "−k·a·max(a·q̂, 0)"),
    };
    push(Step::Wall, wall.to_owned(), String::new());
    push(
        Step::HeldForce,
        format!("torques {force} over [h, h+1), q̂ the middles of the encoders' ticks"),
        String::new(),
    );
    push(
        Step::Generated,
        "E_g ≤ ½·dᵀKd + ½·Σ_i |d_i|·Σ_j |K_ij|·Δ_j".to_owned(),
        String::new(),
    );
    push(
        Step::Dissipated,
        "E_d ≥ Σ_i (b_i·d_i²/T + c_i·|d_i|)".to_owned(),
        String::new(),
    );
    let viscous = match scene.has_matrix() {
        true => "diag(b) − (T/2)·K is positive semidefinite".to_owned(),
        false => "diag(b) − (T/2)·K is positive semidefinite: k·T·Σ_i a_i²/b_i ≤ 2".to_owned(),
    };
    push(Step::Criterion, viscous, viscous_numbers(scene, report));
    for (joint, name) in report.joints.iter().zip(&report.joint_names) {
        push(
            Step::Criterion,
            format!("c ≥ ½·Σ_j |K_ij|·Δ_j of {name}"),
            coulomb_numbers(joint),
        );
    }
    if report.is_bounded && !report.at_every_speed {
        push(
            Step::SpeedBound,
            "up to the bounds V_i it is enough that, with x_i = 0 and with x_i = V_i·T, \
             b_i·x_i/T + c_i ≥ ½·Σ_j |K_ij|·(x_j + Δ_j) for each i, with x_j = V_j·T for all others"
                .to_owned(),
            String::new(),
        );
    }
    if let Some(witness) = &report.witness {
        push(
            Step::Witness,
            "a cycle q → q + d → q that draws energy".to_owned(),
            format!(
                "draws {} J in each round trip",
                approx(&witness.gain_per_cycle)
            ),
        );
    }
    lines
}

/// What a joint has of Coulomb friction and what is asked of it, and how they compare.
fn coulomb_numbers(joint: &OfJoint) -> String {
    let (relation, end) = match joint.spare_coulomb.is_nonnegative() {
        Some(Truth::Holds) => ("≥", ""),
        Some(Truth::Fails) => ("<", ""),
        Some(Truth::Depends) | None => ("against", ": it depends on the tolerances"),
    };
    let needed = range(&joint.coulomb_needed);
    format!("{} {relation} {needed}{end}", range(&joint.coulomb))
}

/// k·T·Σa²/b in numbers: at the values without their tolerances.
fn viscous_numbers(scene: &JointScene, report: &JointReport) -> String {
    let nominal = |given: &Given| {
        let value = figure(&passivity_core::Interval::point(given.nominal.clone()));
        value.map_or_else(|| given.text.clone(), |value| approx(value.lo()))
    };
    if scene.has_matrix() {
        return report.viscous_text().to_owned();
    }
    let term = |(way, joint): (&super::Way, &Joint<Given>)| {
        let b = joint
            .viscous
            .as_ref()
            .map_or_else(|| "0".to_owned(), nominal);
        let a = way.value.enclosure(64)?;
        Some(format!("({})²/{b}", approx(a.lo())))
    };
    let joints = scene.ways.iter().zip(&scene.given.joints).enumerate();
    let joints = joints.filter(|(at, _)| scene.acts_on(*at));
    let terms: Option<Vec<String>> = joints.map(|(_, pair)| term(pair)).collect();
    let relation = match report.viscous_definite {
        Some(true) => "≤ 2",
        Some(false) => "> 2",
        None => "against 2: it depends on the tolerances",
    };
    terms.map_or_else(String::new, |terms| {
        format!(
            "{} · {} · ({}) {relation}",
            nominal(&scene.given.stiffness),
            nominal(&scene.given.period),
            terms.join(" + ")
        )
    })
}

impl JointExplanation {
    /// The explanation for people.
    #[must_use]
    pub fn to_text(&self) -> String {
        // Writing to a string cannot fail.
        let mut out = format!("{}\n\nIn this scene\n", self.report.scene);
        for effect in &self.effects {
            let _ = writeln!(out, "  {}", effect.words());
        }
        out.push_str("\nGiven\n");
        let lengths = self.given.iter().map(|(key, _)| key.len() + 2);
        let width = lengths.fold(32, usize::max);
        for (key, text) in &self.given {
            let _ = writeln!(out, "  {key:<width$}{text}");
        }
        for remark in &self.report.remarks {
            let _ = writeln!(out, "  {}", wrapped(&format!("Taken: {remark}."), 2));
        }
        out.push_str("\nDerivation\n");
        for line in &self.lines {
            let _ = writeln!(out, "  {:<12}{}", line.id, wrapped(&line.formula, 14));
            if !line.numbers.is_empty() {
                let _ = writeln!(out, "  {:<12}{}", "", wrapped(&line.numbers, 14));
            }
        }
        out.push_str("\nTheorems used\n");
        for Theorem { id, says } in &self.theorems {
            let _ = writeln!(out, "  {id:<12}{}", wrapped(says, 14));
        }
        let _ = write!(out, "\nVerdict\n  {}\n", self.report.headline());
        out
    }
}
