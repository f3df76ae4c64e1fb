//! TH-ACTIVE: cycles that draw energy, and when there is one.

use passivity_core::{Friction, Scalar, witness};

use crate::domain::{COARSE_EXPONENT, FRICTION_EXPONENT, friction_coefficient};
use crate::{Dyadic, Ratio};

/// Whole ticks of the cycle beyond the first border: up to 3.
const CYCLE_TICKS: u8 = 3;

/// Eighths of a tick before the first border: 1 to 8, that is 0 < a ≤ 1.
const CYCLE_PARTS: u8 = 8;

/// Where the cycle's border lies, in ticks: ±2.
const BORDER_LIMIT: i8 = 2;

/// TH-ACTIVE: the gain of a cycle from the held force and friction is d·(m + 1 − 2βd − 2σ).
#[kani::proof]
fn th_active_gain_is_the_formula() {
    let n = kani::any_where(|n: &i8| *n >= -BORDER_LIMIT && *n < BORDER_LIMIT);
    let m = kani::any_where(|m: &u8| *m <= CYCLE_TICKS);
    let a = kani::any_where(|a: &u8| *a >= 1 && *a <= CYCLE_PARTS);
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let border = Dyadic::integer(i32::from(n));
    let m = Dyadic::integer(i32::from(m));
    let a = Dyadic::new(i32::from(a), FRICTION_EXPONENT);
    let gain = witness::gain(&(border - a), &(border + m), &friction);
    kani::cover!(gain > Dyadic::zero(), "energy is drawn");
    kani::assert(
        gain == witness::gain_formula(&m, &a, &friction),
        "TH-ACTIVE: a cycle gains d·(m + 1 − 2βd − 2σ)",
    );
}

/// Eighths: β and σ in [0, 1], on both sides of ½ and on it; each pair is a run of its own.
const POINT_LIMIT: u8 = 8;

fn point() -> Friction<Ratio> {
    let beta = kani::any_where(|n: &u8| *n <= POINT_LIMIT);
    let sigma = kani::any_where(|n: &u8| *n <= POINT_LIMIT);
    Friction::new(
        Ratio::new(i32::from(beta), 8),
        Ratio::new(i32::from(sigma), 8),
    )
}

fn half() -> Ratio {
    Ratio::new(1, 2)
}

/// TH-ACTIVE: a cycle with a gain is found exactly when β < ½ or σ < ½.
#[kani::proof]
fn th_active_cycle_exists_exactly_below_a_half() {
    let friction = point();
    let cycle = witness::quantized(&friction, None);
    let short = friction.beta < half() || friction.sigma < half();
    kani::cover!(
        cycle.is_some() && friction.sigma > half(),
        "with too little viscous friction alone"
    );
    kani::assert(
        cycle.is_some() == short,
        "TH-ACTIVE: a cycle is found exactly when β < ½ or σ < ½",
    );
    if let Some(cycle) = cycle {
        kani::assert(
            cycle.gain > Ratio::zero()
                && cycle.gain == witness::gain(&cycle.from, &cycle.to, &friction),
            "TH-ACTIVE: the cycle found gains what it says, above zero",
        );
        kani::assert(
            cycle.from >= Ratio::zero(),
            "TH-ACTIVE: the cycle found keeps within the wall",
        );
    }
}

/// TH-ACTIVE: under a speed bound a cycle that is found stays strictly below it.
#[kani::proof]
fn th_active_cycle_keeps_to_a_speed_bound() {
    let friction = point();
    let n = kani::any_where(|n: &u8| *n >= 1 && *n <= POINT_LIMIT);
    let bound = Ratio::new(i32::from(n), 1 << COARSE_EXPONENT);
    let cycle = witness::quantized(&friction, Some(&bound));
    kani::cover!(
        cycle.is_none() && friction.beta < half(),
        "the bound leaves no cycle"
    );
    if let Some(cycle) = cycle {
        let speed = cycle.to - cycle.from;
        kani::cover!(speed.double() > bound, "most of the bound is used up");
        kani::assert(
            speed < bound && cycle.gain > Ratio::zero(),
            "TH-ACTIVE: the cycle stays below the bound and gains",
        );
    }
}

/// Quarters of β and halves of σ, both in [0, 1]: the displacement, a quotient, is squared, and
/// all of it fits 32 bits.
const COARSE_POINT: (u8, u8) = (4, 2);

/// TH-SMOOTH: without an encoder a cycle is found exactly when β < ½, and gains what it says.
#[kani::proof]
fn th_smooth_cycle_exists_exactly_below_a_half() {
    let beta = kani::any_where(|n: &u8| *n <= COARSE_POINT.0);
    let sigma = kani::any_where(|n: &u8| *n <= COARSE_POINT.1);
    let friction = Friction::new(
        Ratio::new(i32::from(beta), 4),
        Ratio::new(i32::from(sigma), 2),
    );
    let cycle = witness::smooth(&friction, None);
    kani::cover!(
        cycle.is_some() && friction.sigma > half(),
        "despite Coulomb friction"
    );
    kani::assert(
        cycle.is_some() == (friction.beta < half()),
        "TH-SMOOTH: a cycle is found exactly when β < ½",
    );
    if let Some(cycle) = cycle {
        let d = cycle.to - cycle.from;
        let work = d.square() - friction.dissipated_lower(&d, &d.abs()).double();
        kani::assert(
            cycle.gain > Ratio::zero() && cycle.gain == work,
            "TH-SMOOTH: the cycle gains 2(½d² − βd² − σd), above zero",
        );
    }
}
