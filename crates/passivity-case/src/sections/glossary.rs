//! The glossary of the document.

use crate::document::{Document, Row};

/// Each word or letter with its meaning.
const TERMS: [(&str, &str); 39] = [
    (
        "b, c, m",
        "The viscous friction, the Coulomb friction and the mass or inertia of the device.",
    ),
    (
        "K, T, Δ",
        "The stiffness of the wall, the sampling period, and the resolution of the encoder (the length of a tick).",
    ),
    (
        "β, σ, μ",
        "Effective viscous friction b/(KT), effective Coulomb friction c/(KΔ) and effective inertia m/(KT²): the same quantities without units.",
    ),
    (
        "ξ, d, v",
        "The position in ticks, the displacement within a sampling interval, and the speed in ticks per sampling period.",
    ),
    (
        "h, ξ_h, Δτ",
        "The number of a sampling instant, the position then, and the length of a sampling interval in sampling periods.",
    ),
    (
        "ρ, D",
        "How far the device stands into its tick, from 0 up to 1: ρ₀ at the start of a sampling interval, ρ₁ at its end. The ticks that it crosses in between.",
    ),
    (
        "φ_V, φ_H",
        "The force of the virtual wall and the force of the hand, in units of KΔ.",
    ),
    (
        "V, δ",
        "A speed that is not exceeded, and the step that the force is rounded to: in ticks per sampling period and in KΔ, where the other quantities have no units.",
    ),
    (
        "B, a, H(z)",
        "The virtual damping in units of KT; what its filter keeps from one sample to the next, τ/(T + τ) for its time constant τ; and the transfer function of the controller in units of K.",
    ),
    (
        "c_j, g_j, ‖c‖₁",
        "What the controller answers to a position of one tick in one sample, j samples later and in units of KΔ; the sum of that from sample j on; and the sum of all |c_j|.",
    ),
    (
        "λ, κ",
        "How much viscous friction a controller costs, and how much a force costs that is late or lags behind, both in units of KT. In the formulas of κ the force is late by k whole samples and the part f of one, s together; θ is the time constant of the amplifier in sampling periods; m is the mean delay in sampling periods, and Var its variance. In that of λ, θ is 2π times a frequency, times T.",
    ),
    (
        "E_g, E_d",
        "The energy that is generated in a sampling interval, and the energy that is dissipated in it. Where springs are compared, E_g is counted against the quantized spring of the paper, and E_gᴸ against the linear one.",
    ),
    (
        "Numbers in round brackets, such as (8)",
        "Equations of the paper that the first lines of this document name.",
    ),
    (
        "Sampling interval",
        "The time from one sampling instant to the next, in which the commanded force is held.",
    ),
    ("Tick", "A step of the encoder."),
    (
        "KΔ²",
        "The unit of energy: the stiffness times the square of a tick.",
    ),
    (
        "Passive",
        "At every sampling instant the work that the hand has done so far is at least the energy stored now less the energy stored at the start. The hand can then never draw more energy than was stored.",
    ),
    (
        "Storage",
        "The kinetic energy of the device and the energy of the linear spring K, with what the effects of the scene add.",
    ),
    (
        "Generated, dissipated",
        "The energy that sampling and quantization add to the motion in a sampling interval, and the energy that friction takes from it.",
    ),
    (
        "Criterion",
        "The condition (8), or (11) in SI units: friction dissipates at least what sampling and quantization generate.",
    ),
    (
        "Margin",
        "By how much the criterion is met, without units; the criterion holds where it is not negative.",
    ),
    (
        "Critical speed",
        "The speed at which the criterion is met with equality.",
    ),
    (
        "Globally stable",
        "The region of (β, σ) in which the criterion holds at every speed.",
    ),
    (
        "Locally stable",
        "The region in which the criterion holds up to the critical speed.",
    ),
    (
        "Limit cycles",
        "The region in which the criterion holds from the critical speed on, and fails below it.",
    ),
    (
        "Unstable",
        "The region in which the criterion holds at no speed.",
    ),
    (
        "Witness",
        "A motion, in exact numbers, that draws energy from the display each time round.",
    ),
    (
        "Log, audit",
        "What the device recorded of a motion: positions, and perhaps times and forces; the exact account of its energy, interval by interval.",
    ),
    (
        "Identification",
        "Ranges that surely hold the friction of the device, found from logs in which it moves freely.",
    ),
    (
        "Claim, assumption, caveat",
        "A statement that the project makes; what the statement takes for granted; what its evidence does not say.",
    ),
    (
        "Shown, fresh",
        "Evidence was recorded, for exactly these claims and sources.",
    ),
    (
        "Stale",
        "A claim or a source has changed since its evidence was recorded.",
    ),
    ("Not run here", "No result was recorded."),
    (
        "Kernel",
        "The part of passivity that decides, in exact numbers.",
    ),
    (
        "z3 and cvc5; Rocq; Kani; Prusti",
        "Solvers for formulas; a proof assistant; a model checker, which decides for all inputs of a domain; a checker of what functions promise.",
    ),
    (
        "Harnesses as tests",
        "A harness is a small program that states a claim for the model checker. As tests, the same programs were run on the inputs that the record names.",
    ),
    (
        "Big rationals",
        "Fractions of whole numbers of any size. As evidence: tests of the claim in which the kernel computes with them.",
    ),
    (
        "Open, defeated",
        "Nothing supports the element; a counterexample is at hand.",
    ),
    (
        "Proved for all reals; proved for all inputs in a domain; exhausted; sampled",
        "Proved by solvers or a proof assistant; decided by a model checker; every input of a domain was run; so many inputs were drawn and run.",
    ),
];

pub(super) fn write(document: &mut Document) {
    document.heading(2, "glossary", "Glossary");
    let rows = TERMS.map(|(term, meaning)| -> Row { [term.into(), meaning.into()].into() });
    let columns = [("Word or letter", 26), ("Meaning", 74)];
    document.table(
        "Words and letters of this document",
        &columns,
        rows.to_vec(),
    );
}
