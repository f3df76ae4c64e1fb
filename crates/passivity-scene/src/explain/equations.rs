//! The equations of a scene, with exactly its effects.

use passivity_core::{BigRational, Effect, Loop, Scalar};

use super::frequency::Frequency;
use crate::check::Report;
use crate::display::{approx, range};
use crate::scene::Scene;

/// The force that is held, with exactly the scene's effects.
pub(super) fn held_force(scene: &Scene) -> (String, &'static str) {
    let late = scene.given.delay;
    let sample = if late == 0 {
        "h".to_owned()
    } else {
        format!("h−{late}")
    };
    let before = format!("h−{}", u32::from(late) + 1);
    let mut id = "(5)";
    if scene.has(Effect::Controller) || scene.has(Effect::DampingFilter) {
        return filtered_force(scene, &sample);
    }
    let mut force = if scene.given.has_encoder() {
        format!("⌊ξ_{sample}⌋ + ½")
    } else {
        id = "TH-SMOOTH";
        format!("ξ_{sample}")
    };
    if late > 0 {
        id = "TH-DELAY";
    }
    if scene.has(Effect::Damping) {
        id = "TH-DAMP";
        let velocity = if scene.given.has_encoder() {
            format!("(⌊ξ_{sample}⌋ − ⌊ξ_{before}⌋)")
        } else {
            format!("(ξ_{sample} − ξ_{before})")
        };
        force = format!("{force} + B·{velocity}");
    }
    let side = if scene.given.unilateral {
        ", where the bracket is 0 if the sample is below 0"
    } else {
        ""
    };
    wrapped_force(scene, &force, side, id)
}

/// The force of a filter's output, which is a sum over all samples so far.
fn filtered_force(scene: &Scene, sample: &str) -> (String, &'static str) {
    let position = if scene.given.has_encoder() {
        "⌊ξ⌋ + ½"
    } else {
        "ξ"
    };
    let side = if scene.given.unilateral {
        ", where it is 0 if the sample is below 0"
    } else {
        ""
    };
    let force = format!("the output of H at sample {sample} for {position}");
    wrapped_force(scene, &force, side, "TH-LTI")
}

/// The force as it is rounded, limited and delayed by less than a sample.
fn wrapped_force(
    scene: &Scene,
    force: &str,
    side: &str,
    mut id: &'static str,
) -> (String, &'static str) {
    // Gated first, then negated, rounded and limited, as the controller does.
    let mut held = format!("−({force})");
    if scene.has(Effect::ForceStep) {
        id = "TH-DAC";
        held = format!("δ·⌊{held}/δ + ½⌋");
    }
    if scene.has(Effect::Saturation) {
        id = "TH-LAW";
        held = format!("sat({held})");
    }
    let over = if scene.has(Effect::Latency) {
        "from the latency after sample h to that after the next"
    } else {
        "over [h, h+1)"
    };
    (format!("φ_V = {held} {over}{side}"), id)
}

/// The equation of motion, with exactly the scene's effects.
pub(super) fn motion(scene: &Scene) -> String {
    let mut left = vec!["μ·ξ̈"];
    if scene.has(Effect::Viscous) {
        left.push("β·ξ̇");
    }
    if scene.has(Effect::Coulomb) {
        left.push("σ·sgn(ξ̇)");
    }
    let wall = if scene.has(Effect::Amplifier) {
        "the lagged φ_V"
    } else {
        "φ_V"
    };
    format!("{} = φ_H + {wall}", left.join(" + "))
}

/// What a step may generate, in letters.
pub(super) struct Cost {
    /// What is generated at most, beside what the storage gives up.
    pub(super) bound: String,
    pub(super) viscous: String,
    pub(super) coulomb: String,
    pub(super) id: &'static str,
}

impl Cost {
    pub(super) fn of(scene: &Scene) -> Self {
        let at = scene.point().at;
        let (viscous, id) = viscous(&at);
        let sum = |terms: &[String]| match terms {
            [] => "0".to_owned(),
            [one] => one.clone(),
            many => format!("({})", many.join(" + ")),
        };
        let (viscous, coulomb) = (sum(&viscous), sum(&coulomb(&at)));
        let [square, distance] = measures(&at);
        let charged = format!("{viscous}·{square} + {coulomb}·{distance}");
        let bound = match (at.has_computed_costs(), at.has_memory()) {
            (true, _) => format!("ΣE_g ≤ Σ({charged}) + the decrease of the extra storage"),
            (false, true) => format!("E_g ≤ {charged} + the decrease of the extra storage"),
            (false, false) => format!("E_g ≤ {charged}"),
        };
        Self {
            bound,
            viscous,
            coulomb,
            id,
        }
    }
}

/// The criterion (8) in the numbers of a scene, at its nominal values.
pub(super) fn criterion(scene: &Scene) -> String {
    let at = scene.point().at;
    let cost = at.cost();
    let [beta, viscous, sigma, coulomb] = [
        &at.viscous_friction(),
        &cost.viscous,
        &at.coulomb_friction(),
        &cost.coulomb,
    ]
    .map(readable);
    format!("({beta} − {viscous}) + ({sigma} − {coulomb})/v ≥ 0")
}

/// What the cost in β and in σ is times: a force that changes within an interval is charged by the instant.
fn measures(at: &Loop<BigRational>) -> [&'static str; 2] {
    match at.has_actuator() {
        true => ["∫ξ̇²dτ", "∫|ξ̇|dτ"],
        false => ["d²", "|d|"],
    }
}

/// What friction takes of an interval at least, with the equation that says it.
pub(super) fn dissipated(scene: &Scene) -> (&'static str, String) {
    let at = scene.point().at;
    let [square, distance] = measures(&at);
    let mut terms = Vec::new();
    if scene.has(Effect::Viscous) {
        let per_time = if at.has_actuator() { "" } else { "/Δτ" };
        terms.push(format!("β·{square}{per_time}"));
    }
    if scene.has(Effect::Coulomb) {
        terms.push(format!("σ·{distance}"));
    }
    let id = if at.has_actuator() { "(23)" } else { "(26)" };
    let text = match terms.is_empty() {
        true => "E_d ≥ 0: the device has no friction".to_owned(),
        false => format!("E_d ≥ {}", terms.join(" + ")),
    };
    (id, text)
}

/// What is asked of β, and the theorem that says it.
fn viscous(at: &Loop<BigRational>) -> (Vec<String>, &'static str) {
    let one = |symbol: &str| vec![symbol.to_owned()];
    if at.has_actuator() {
        let id = match at.time_constant {
            Some(_) => "TH-LAG",
            None => "TH-LATENCY",
        };
        let terms = match at.controller.is_some() || at.damping.is_some() {
            true => vec!["H(1)·κ".to_owned(), "Σ|g_j|".to_owned()],
            false => one("κ"),
        };
        return (terms, id);
    }
    if at.has_computed_costs() {
        return (one("λ"), "TH-LTI");
    }
    let mut terms = one("½");
    let mut id = if at.has_encoder() {
        "TH-LIN"
    } else {
        "TH-SMOOTH"
    };
    if at.delay > 0 {
        terms.push(at.delay.to_string());
        id = "TH-DELAY";
    }
    if at.force_step.is_some() {
        id = "TH-DAC";
    }
    if at.damping.is_some() {
        terms.push("B".to_owned());
        id = "TH-DAMP";
    }
    (terms, id)
}

/// What is asked of σ.
fn coulomb(at: &Loop<BigRational>) -> Vec<String> {
    let of_controller = at.controller.is_some();
    let mut terms: Vec<String> = Vec::new();
    let first = match (at.has_encoder(), of_controller, at.force_step.is_some()) {
        (true, true, true) => "½(‖c‖₁ + δ)",
        (true, true, false) => "½‖c‖₁",
        (true, false, true) => "½(1 + δ)",
        (true, false, false) => "½",
        (false, _, true) => "½δ",
        (false, _, false) => return terms,
    };
    terms.push(first.to_owned());
    if at.has_encoder() && at.damping.is_some() {
        let filtered = at.damping_time_constant.is_some();
        terms.push(if filtered { "B(1 − a)" } else { "B" }.to_owned());
    }
    terms
}

/// H(z) in letters and in the scene's numbers, where it is more than the spring with damping.
pub(super) fn controller(scene: &Scene) -> Option<[String; 2]> {
    let at = scene.point().at;
    if let Some(controller) = &at.controller {
        let formula = "H(z) = (n₀ + n₁z⁻¹ + …)/(d₀ + d₁z⁻¹ + …), in units of K".to_owned();
        let numerator = in_z(controller.numerator());
        return Some([
            formula,
            match controller.denominator() {
                [one] if *one == BigRational::one() => format!("H(z) = {numerator}"),
                denominator => format!("H(z) = ({numerator})/({})", in_z(denominator)),
            },
        ]);
    }
    let (damping, tau) = (at.damping?, at.damping_time_constant?);
    let pole = tau.clone() / (tau + BigRational::one());
    let numbers = format!("B = {} KT, a = {}", readable(&damping), readable(&pole));
    Some([
        "H(z) = 1 + B(1 − z⁻¹)(1 − a)/(1 − a·z⁻¹), a = τ/(T + τ)".to_owned(),
        numbers,
    ])
}

/// A polynomial in z⁻¹.
fn in_z(coefficients: &[BigRational]) -> String {
    const POWERS: [&str; 4] = ["", "z⁻¹", "z⁻²", "z⁻³"];
    let mut text = String::new();
    for (j, c) in coefficients.iter().enumerate() {
        let zero = BigRational::zero();
        if *c == zero {
            continue;
        }
        let sign = match (text.is_empty(), *c < zero) {
            (true, true) => "−",
            (true, false) => "",
            (false, true) => " − ",
            (false, false) => " + ",
        };
        let power = match POWERS.get(j) {
            Some(power) => (*power).to_owned(),
            None => format!("z^(−{j})"),
        };
        let size = readable(&Scalar::abs(c));
        let size = match (size.as_str(), power.is_empty(), size.contains('/')) {
            ("1", false, _) => String::new(),
            (_, false, true) => format!("({size})"),
            _ => size,
        };
        text += &format!("{sign}{size}{power}");
    }
    text
}

/// What the effects cost together, and where, when no closed form says it.
pub(super) fn computed(scene: &Scene, report: &Report) -> Option<(&'static str, [String; 2])> {
    let at = scene.point().at;
    if !at.has_computed_costs() {
        return None;
    }
    let (_, id) = viscous(&at);
    let cost = range(&report.cost.viscous);
    let kappa = "κ = ½[½ + m + √((½ + m)² + Var)], m the mean delay";
    let behind = if at.controller.is_some() || at.damping.is_some() {
        [
            format!("H(1)·{kappa}, and Σ|g_j|"),
            format!("together {cost}"),
        ]
    } else {
        [kappa.to_owned(), format!("κ = {cost}")]
    };
    Some(match Frequency::of(scene) {
        _ if at.has_actuator() => (id, behind),
        Some(frequency) => {
            let formula = "λ = max over θ of Re[(1 − e^(−iθ))·e^(−ikθ)·H(e^(iθ))]/(2(1 − cos θ))";
            let numbers = format!("λ = {cost}, largest at {}", frequency.worst_text());
            (id, [formula.to_owned(), numbers])
        }
        None => {
            let formula = "λ ≤ H(1)(½ + k) + Σ|g_j|: the wall is one-sided or saturated".to_owned();
            (id, [formula, format!("λ ≤ {cost}")])
        }
    })
}

/// A rational as it is when short, else rounded.
fn readable(x: &BigRational) -> String {
    let exact = x.to_string();
    if exact.len() <= 12 { exact } else { approx(x) }
}
