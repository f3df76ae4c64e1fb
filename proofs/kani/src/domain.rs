//! The domains that harnesses draw from: each bound has a name and a reason.
//!
//! The claims are polynomial inequalities that are piecewise in ⌊·⌋. A grid of 1/16 tick has every
//! kind of residue (0, just above it, ½, just below 1), and a few ticks have every kind of
//! crossing (none, one, several, both directions). Wider grids cost the model checker minutes and
//! show nothing new; the statement without bounds is the solver's (`proofs/smt`).

use passivity_core::Scalar;

use crate::{Dyadic, Ratio};

/// Positions are multiples of 1/2⁴ tick: all residues that matter, in 4 bits.
pub(crate) const POSITION_EXPONENT: u32 = 4;

/// Sixteenths of a tick up to which positions go: ±4 ticks, 7 bits.
pub(crate) const POSITION_LIMIT: i8 = 64;

/// Coarse positions are multiples of 1/2² tick, where three or more numbers are multiplied.
pub(crate) const COARSE_EXPONENT: u32 = 2;

/// Quarters of a tick up to which coarse positions go: ±4 ticks, 5 bits.
pub(crate) const COARSE_LIMIT: i8 = 16;

/// Friction coefficients are multiples of 1/2³ (of KT and of KΔ), so ½ is one and has neighbours.
pub(crate) const FRICTION_EXPONENT: u32 = 3;

/// Eighths up to which β and σ go: below 2, four times the critical ½, 4 bits.
pub(crate) const FRICTION_LIMIT: u8 = 16;

/// A position in [−4, 4) by 1/16 tick.
pub(crate) fn position() -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= -POSITION_LIMIT && *n < POSITION_LIMIT);
    Dyadic::new(i32::from(n), POSITION_EXPONENT)
}

/// A position in [−4, 4) by 1/4 tick.
pub(crate) fn coarse_position() -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= -COARSE_LIMIT && *n < COARSE_LIMIT);
    Dyadic::new(i32::from(n), COARSE_EXPONENT)
}

/// A friction coefficient in [0, 2) by 1/8.
pub(crate) fn friction_coefficient() -> Dyadic {
    let n = kani::any_where(|n: &u8| *n < FRICTION_LIMIT);
    Dyadic::new(i32::from(n), FRICTION_EXPONENT)
}

/// Quarters of a tick per sample up to which speeds go: below 8, 5 bits.
pub(crate) const SPEED_LIMIT: u8 = 32;

/// A speed in [0, 8) by 1/4 tick per sample.
pub(crate) fn speed() -> Dyadic {
    let n = kani::any_where(|n: &u8| *n < SPEED_LIMIT);
    Dyadic::new(i32::from(n), COARSE_EXPONENT)
}

/// A small non-negative number, in [0, 2) by 1/4: 3 bits.
pub(crate) fn share() -> Dyadic {
    let n = kani::any_where(|n: &u8| *n < SHARE_LIMIT);
    Dyadic::new(i32::from(n), COARSE_EXPONENT)
}

/// Quarters up to which virtual damping and D/A steps go: below 2, 3 bits.
pub(crate) const SHARE_LIMIT: u8 = 8;

/// A whole number in [0, limit), as a fraction.
pub(crate) fn below(limit: u8) -> Ratio {
    let n = kani::any_where(|n: &u8| *n < limit);
    Ratio::integer(i32::from(n))
}

/// A whole number in [1, limit], as a fraction.
pub(crate) fn up_to(limit: u8) -> Ratio {
    let n = kani::any_where(|n: &u8| *n >= 1 && *n <= limit);
    Ratio::integer(i32::from(n))
}
