//! Rigorous bounds of the motion behind an amplifier, from the ends of what is known at its start.
//!
//! Without an arm the motion is ordered: a larger speed, a larger output, a larger command and a larger
//! force of the operator each lead to a larger output and a larger speed at every later time (the speed
//! follows M·ξ̈ = y + F − β′ξ̇ − σs, of which friction takes no order away). So the motion from the lower
//! ends of all and that from the upper ends have every other one between them, and nothing widens but by
//! rounding and by the motion itself.

use super::part::Way;
use crate::flow::{Flow, State};
use crate::number::{Real, Undecided};

/// The motion over an interval from a state that is known to be between two.
///
/// # Errors
///
/// [`Undecided`] when the numbers cannot tell where the device stops or starts.
pub(super) fn way<R: Real>(
    flow: &Flow<R>,
    state: &State<R>,
    command: &R,
    force: &R,
) -> Result<Way<R>, Undecided> {
    let ends = |x: &R| x.ends().unwrap_or_else(|| [x.clone(), x.clone()]);
    let [velocities, outputs, commands, forces] =
        [&state.velocity, &state.output, command, force].map(ends);
    let from = |velocity: &R, output: &R, command: &R, force: &R, ledger| {
        let start = State {
            xi: R::zero(),
            velocity: velocity.clone(),
            output: output.clone(),
        };
        flow.advance(&start, command, force, ledger)
    };
    let ([v0, v1], [y0, y1], [u0, u1], [f0, f1]) = (&velocities, &outputs, &commands, &forces);
    let (low, high) = (from(v0, y0, u0, f0, true)?, from(v1, y1, u1, f1, false)?);
    let way = low.end.xi.clone().join(high.end.xi.clone());
    let velocity = low.end.velocity.join(high.end.velocity);
    // ∫yξ̇ is as that of the lower motion, but for ∫(y − y₀)ξ̇ and ∫y₀(ξ̇ − ξ̇₀), and ∫|ξ̇| as its way, but
    // for ∫(ξ̇ − ξ̇₀).
    let further = high.end.xi - low.end.xi;
    let apart = (y1.clone() - y0.clone()).max(u1.clone() - u0.clone());
    let largest = y0.abs().max(u0.abs());
    let rest = apart * (low.path + further.clone()) + largest * further;
    let work = low.work.widened(&rest);
    // What friction took is what the balance leaves over.
    let squares = velocity.square() - state.velocity.square();
    let kinetic = (flow.mass.clone() * squares).half();
    Ok(Way {
        end: State {
            xi: (state.xi.clone() + way.clone()).decided()?,
            velocity: velocity.decided()?,
            output: low.end.output.join(high.end.output),
        },
        dissipated: (work.clone() + force.clone() * way - kinetic).max(R::zero()),
        work,
        arm: R::zero(),
    })
}
