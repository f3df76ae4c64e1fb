//! The criterion: (27) and (8) are one inequality, (9) is where it is an equality, (11) has units.

use passivity_core::{Criterion, Friction, Loop, Ordered, Scalar};

use crate::domain::{below, coarse_position, friction_coefficient, share, speed, up_to};
use crate::{Dyadic, Ratio};

/// Halves of a tick: displacements in ±4 where an equality of products is asked, 4 bits.
const DISTANCE_LIMIT: i8 = 8;

fn distance(limit: i8) -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= -limit && *n < limit);
    Dyadic::new(i32::from(n), 1)
}

/// EQ-27: the margin (8) is what friction holds against ½(v + 1).
#[kani::proof]
fn eq_27_margin_is_friction_less_half_of_v_and_1() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let speed = speed();
    let margin = Criterion::of_friction(&friction).margin(&speed);
    kani::cover!(margin < Dyadic::zero(), "too little friction");
    kani::assert(
        margin == friction.beta * speed + friction.sigma - (speed + Dyadic::one()).half(),
        "EQ-27: the margin is βv + σ − ½(v + 1)",
    );
}

/// EQ-27: the left-hand side of (27) is |d| times the margin.
///
/// With the harness before and the one after, (27) is (26) less |d|·½(v̄ + 1), the bound of (22).
/// All at once, which takes a model checker many times as long, it is asked of fewer numbers.
#[kani::proof]
fn eq_27_is_distance_times_margin() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let criterion = Criterion::of_friction(&friction);
    let d = distance(DISTANCE_LIMIT);
    let speed = speed();
    kani::cover!(d < Dyadic::zero() && speed > Dyadic::zero(), "downwards");
    kani::assert(
        criterion.surplus(&d, &speed) == d.abs() * criterion.margin(&speed),
        "EQ-27: (27) is |d| times the margin",
    );
}

/// EQ-27: (26) is |d|·(βv̄ + σ).
#[kani::proof]
fn eq_27_dissipation_is_distance_times_friction() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let d = distance(DISTANCE_LIMIT);
    let speed = speed();
    kani::cover!(d < Dyadic::zero() && speed > Dyadic::zero(), "downwards");
    kani::assert(
        friction.dissipated_lower(&d, &speed) == d.abs() * (friction.beta * speed + friction.sigma),
        "EQ-27: (26) is |d|·(βv̄ + σ)",
    );
}

/// Halves of a tick in ±1, 2 bits, and quarters of a tick per sample below 2, 3 bits: where (27)
/// is asked at once.
const SHORT_LIMIT: i8 = 2;

/// EQ-27: the left-hand side of (27) is E_d's lower bound less ½d²/Δτ + ½|d|.
#[kani::proof]
fn eq_27_is_dissipated_less_generated() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let criterion = Criterion::of_friction(&friction);
    let d = distance(SHORT_LIMIT);
    let speed = share();
    let surplus = criterion.surplus(&d, &speed);
    kani::cover!(surplus < Dyadic::zero(), "less is dissipated");
    kani::cover!(surplus > Dyadic::zero(), "more is dissipated");
    // d²/Δτ is |d|·v̄.
    let allowed = (d.abs() * speed).half() + d.abs().half();
    kani::assert(
        surplus == friction.dissipated_lower(&d, &speed) - allowed,
        "EQ-27: (27) compares (26) with the bound of (22)",
    );
}

/// EQ-27: for a step that moves, (27) holds exactly where (8) does.
#[kani::proof]
fn eq_27_holds_where_8_does() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let criterion = Criterion::of_friction(&friction);
    let d = coarse_position();
    let speed = speed();
    if d != Dyadic::zero() {
        let margin = criterion.margin(&speed);
        kani::cover!(margin == Dyadic::zero(), "on the critical line");
        kani::assert(
            criterion.surplus(&d, &speed).is_at_least_zero() == margin.is_at_least_zero(),
            "EQ-27: (27) and (8) are equivalent",
        );
    }
}

/// EQ-27: on the critical line (9) the margin is zero.
#[kani::proof]
fn eq_27_is_an_equality_on_the_critical_line_9() {
    let beta = friction_coefficient();
    let speed = speed();
    let sigma = Criterion::critical_sigma(&beta, &speed);
    kani::cover!(sigma < Dyadic::zero(), "no Coulomb friction is needed");
    let margin = Criterion::of_friction(&Friction::new(beta, sigma)).margin(&speed);
    kani::assert(
        margin == Dyadic::zero(),
        "EQ-27: the margin is zero on the line (9)",
    );
}

/// Whole units of K, T, Δ and v: 2 bits each, since up to five are multiplied.
const UNITS: u8 = 3;

/// Whole units of b, c and m, on both sides of every border.
const FRICTION: u8 = 6;

/// EQ-27: the criterion with units (11), with every effect, is (8) times KΔ.
///
/// K = 2, T = 3 and Δ = 5 fix the units of force, time and length, which no claim depends on. B
/// and F are 1: both sides are linear in them.
#[kani::proof]
fn eq_27_with_units_is_11() {
    let the_loop = Loop {
        viscous: Some(below(FRICTION)),
        coulomb: Some(below(FRICTION)),
        resolution: Some(Ratio::integer(5)),
        delay: 1,
        damping: Some(Ratio::one()),
        force_step: Some(Ratio::one()),
        ..Loop::new(Ratio::integer(2), Ratio::integer(3))
    };
    let speed = up_to(UNITS);
    let with_units = the_loop.criterion().margin(&speed);
    let margin = the_loop
        .dimensionless_criterion()
        .margin(&the_loop.dimensionless_speed(&speed));
    kani::cover!(
        with_units.is_nonnegative() == Some(false),
        "it does not hold"
    );
    kani::assert(
        with_units == margin * the_loop.force_unit(),
        "EQ-27: (11) is (8) in the units of the loop",
    );
}

/// EQ-27: without further effects (8) has β − ½ and σ − ½, and μ = m/(KT²).
#[kani::proof]
#[kani::unwind(4)]
fn eq_27_dimensionless_numbers_are_those_of_7() {
    let (viscous, coulomb) = (below(FRICTION), below(FRICTION));
    let (stiffness, period, length) = (up_to(UNITS), up_to(UNITS), up_to(UNITS));
    let the_loop = Loop {
        viscous: Some(viscous),
        coulomb: Some(coulomb),
        resolution: Some(length),
        ..Loop::new(stiffness, period)
    };
    let criterion = the_loop.dimensionless_criterion();
    let expected = Criterion::of_friction(&the_loop.friction());
    kani::cover!(
        criterion.viscous.is_nonnegative() == Some(false),
        "β is below ½"
    );
    kani::assert(
        criterion.viscous == expected.viscous && criterion.coulomb == expected.coulomb,
        "EQ-27: a loop's criterion is that of its β and σ",
    );
    let friction = the_loop.friction();
    kani::assert(
        friction.beta * (stiffness * period) == viscous
            && friction.sigma * (stiffness * length) == coulomb,
        "EQ-27: β = b/(KT) and σ = c/(KΔ)",
    );
    let inertia = below(FRICTION);
    let heavy = Loop {
        inertia: Some(inertia),
        ..the_loop
    };
    let mu = heavy.dimensionless().inertia;
    kani::assert(
        mu.is_some_and(|mu| mu * (stiffness * period.square()) == inertia),
        "EQ-27: μ = m/(KT²)",
    );
}
