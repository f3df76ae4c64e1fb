//! TH-START: an unforced motion and the speed that it never passes, in squares.

use passivity_core::{
    Scalar, spring, start,
    verdict::{Speeds, decide},
};

use crate::domain::{below, up_to};
use crate::region::{criterion, moving};
use crate::{Dyadic, Ratio};

/// Slower than any border of these criteria; see `region`.
const SLOW: Dyadic = Dyadic::new(1, 4);

/// TH-START: with β < ½ < σ the squares decide what (8) says at the speed V.
#[kani::proof]
fn th_start_squares_decide() {
    let criterion = criterion();
    let speed = moving();
    if criterion.viscous < Dyadic::zero() && criterion.coulomb > Dyadic::zero() {
        let margin = criterion.margin(&speed);
        kani::cover!(margin == Dyadic::zero(), "at the critical speed");
        let of_squares = start::margin_of_squares(&criterion, &speed.square());
        kani::assert(
            of_squares.is_at_least_zero() == margin.is_at_least_zero(),
            "TH-START: the margin of squares has the sign of the margin",
        );
    }
}

/// TH-START: the answer given V² is that of every speed v with 0 < v ≤ V.
#[kani::proof]
fn th_start_answer_is_that_of_every_speed_below() {
    let criterion = criterion();
    let bound = moving();
    let speed = moving();
    let squared = bound.square();
    let holds = |speed: Dyadic| criterion.margin(&speed).is_at_least_zero();
    let answer = start::holds_up_to(&criterion, &squared);
    kani::cover!(
        answer == Some(true) && criterion.viscous < Dyadic::zero(),
        "it holds thanks to the bound"
    );
    kani::assert(answer.is_some(), "TH-START: there is an answer");
    if answer == Some(true) && speed <= bound {
        kani::assert(
            holds(speed) && holds(SLOW),
            "TH-START: where it holds, (8) holds at every speed up to V",
        );
    }
    if answer == Some(false) {
        kani::assert(
            !holds(bound) || !holds(SLOW),
            "TH-START: where it does not, (8) fails at some speed up to V",
        );
    }
    let decided = decide(&criterion, &Speeds::UpToSquared(squared)).map(|d| d.holds);
    kani::assert(decided == answer, "TH-START: the verdict is this answer");
}

/// Positions and velocities of the energy argument: whole numbers below 8, since squares and μ
/// are multiplied.
const MOTION_LIMIT: u8 = 8;

/// TH-START: while S does not grow, |ξ̇| ≤ V, where V² = ξ̇(0)² + ξ(0)²/μ.
///
/// S does not grow while the criterion holds (TH-RUN without an operator), and it holds up to V.
#[kani::proof]
fn th_start_speed_is_never_passed() {
    let mu = up_to(8).half();
    let (xi_0, v_0) = (below(MOTION_LIMIT), below(MOTION_LIMIT));
    let (xi, v) = (below(MOTION_LIMIT), below(MOTION_LIMIT));
    let bound = start::speed_squared(&mu, &xi_0, &v_0);
    if spring::storage(&mu, &xi, &v) <= spring::storage(&mu, &xi_0, &v_0) {
        kani::cover!(
            v.square() == bound && xi_0 > Ratio::zero(),
            "the speed is reached"
        );
        kani::assert(v.square() <= bound, "TH-START: the speed V is never passed");
    }
    kani::assert(
        bound * mu == spring::storage(&mu, &xi_0, &v_0).double(),
        "TH-START: ½μV² is the storage at the start",
    );
}
