//! The derivation of a verdict on several joints with the scene's numbers filled in.

use passivity_core::Truth;
use passivity_core::joints::{Joint, Place};

use super::JointScene;
use super::report::{JointReport, OfJoint, check};
use crate::check::figure;
use crate::display::{approx, range};
use crate::explain::{Explanation, GivenText, Line, Step, absent, used};
use crate::scene::Given;

/// What `passivity explain` shows of a scene of several joints.
pub type JointExplanation = Explanation<JointReport>;

/// Explains a scene of several joints.
#[must_use]
pub fn explain(scene: &JointScene) -> JointExplanation {
    let report = check(scene);
    JointExplanation {
        scene: scene.name.clone(),
        absent: absent(&report.effects),
        given: given(scene),
        lines: lines(scene, &report),
        theorems: used(&report.because),
        present: report.effects.clone(),
        report,
    }
}

fn given(scene: &JointScene) -> Vec<GivenText> {
    let places: Vec<Place> = scene.given.places().collect();
    let of = |place: &Place| {
        let given = scene.given.get(*place)?;
        (!given.text.is_empty()).then(|| GivenText {
            key: scene.key(*place),
            text: given.text.clone(),
        })
    };
    let ways: Vec<&str> = scene.ways.iter().map(|way| way.text.as_str()).collect();
    let direction = (!scene.has_matrix()).then(|| GivenText {
        key: "wall.direction".to_owned(),
        text: ways.join(", "),
    });
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
        self.text(&self.report.remarks, &self.report.headline())
    }
}
