//! What each theorem says, for people.

use super::Theorem;

/// The theorems of some ids, each with what it says.
pub(crate) fn used(ids: &[&'static str]) -> Vec<Theorem> {
    let theorem = |id: &&'static str| Theorem {
        id,
        says: sentence(id),
    };
    ids.iter().map(theorem).collect()
}

/// What a theorem says, in a sentence.
fn sentence(id: &str) -> &'static str {
    match id {
        "TH-REGION" => "a region is the set of speeds at which the criterion holds",
        "TH-INTERVAL" => {
            "within a sampling interval no more energy is generated than friction dissipates, \
             measured against the linear spring, if the criterion holds at the mean speed"
        }
        "TH-RUN" => {
            "over any number of intervals the operator draws no more energy than was stored at the \
             start, whatever the operator does"
        }
        "TH-START" => {
            "an unforced motion never gets faster than V, so the criterion at V is enough"
        }
        "TH-ACTIVE" => {
            "if β or σ is below ½, an explicit cycle of motion draws energy in each round trip"
        }
        "TH-SMOOTH" => "without an encoder the terms of quantization vanish",
        "TH-UNI" => "the bound on what a spring generates is the same on one side as on both",
        "TH-LAW" => {
            "the bound on what the spring generates is one for every force law that is nowhere stiffer \
             than K"
        }
        "TH-DAC" => "a force step δ costs ½δ of Coulomb friction",
        "TH-DELAY" => "each sample of delay raises the β that a spring requires by at most 1",
        "TH-DAMP" => "virtual damping B raises the β and the σ that are required by at most B each",
        "TH-NDOF" => {
            "a wall of several joints draws nothing at any speed exactly when viscous friction \
             outweighs sampling in every direction, diag(b) − (T/2)K positive semidefinite, and the \
             Coulomb friction of each joint the encoders of all that it is coupled to"
        }
        "TH-LTI" => {
            "a linear controller with all its delays costs the largest λ(θ) over all frequencies of \
             the motion, no less: below it a wave draws energy; and half the sum of its response of σ"
        }
        "TH-LATENCY" => {
            "a force that is s samples late costs κ = ½[½ + s + √((½ + s)² + f(1 − f))], f the \
             fraction of s, of β"
        }
        "TH-LAG" => {
            "an amplifier that lags by θ samples costs κ = ½[½ + θ + √((½ + θ)² + Var)] of β, with \
             Var = (θ/2)·coth(1/(2θ)) − θ²"
        }
        _ => "see the table of claims",
    }
}
