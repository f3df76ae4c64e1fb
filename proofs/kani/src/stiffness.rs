//! TH-STIFF: border values of each parameter.
//!
//! A quotient is never computed: fractions are compared by cross-multiplication. T and Δ are
//! constants: they fix the units of time and length, in which every claim here is homogeneous.

use passivity_core::{Criterion, Loop, Parameter, Scalar, stiffness};

use crate::Ratio;
use crate::domain::{below, up_to};

/// Whole units of K, v, virtual damping and D/A steps: up to 3, since several are multiplied.
const UNITS: u8 = 3;

/// T in its unit; unlike Δ, so that one taken for the other shows.
const PERIOD: i32 = 2;

/// Δ in its unit.
const LENGTH: i32 = 3;

/// Whole units of b and c: below 8, so that both sides of every border are there.
const FRICTION: u8 = 8;

/// A loop with an encoder, one sample of delay, virtual damping and a D/A converter.
fn with_effects() -> Loop<Ratio> {
    Loop {
        delay: 1,
        damping: Some(below(UNITS)),
        force_step: Some(below(UNITS)),
        ..plain()
    }
}

/// A loop with an encoder and nothing else.
fn plain() -> Loop<Ratio> {
    Loop {
        viscous: Some(below(FRICTION)),
        coulomb: Some(below(FRICTION)),
        resolution: Some(Ratio::integer(LENGTH)),
        ..Loop::new(up_to(UNITS), Ratio::integer(PERIOD))
    }
}

fn is_zero(x: Ratio) -> bool {
    x == Ratio::zero()
}

/// Whether a margin is at least zero; an undefined one is not.
fn holds(margin: Ratio) -> bool {
    margin >= Ratio::zero()
}

/// The criterion of the loop with one parameter at another value.
fn with(the_loop: &Loop<Ratio>, parameter: Parameter, value: Ratio) -> Criterion<Ratio> {
    the_loop.clone().with(parameter, value).criterion()
}

fn border(criterion: &Criterion<Ratio>, speed: &Ratio) -> bool {
    is_zero(criterion.margin(speed))
}

/// TH-STIFF: without further effects the limits are 2(bv + c)/(Tv + Δ), 2b/T and 2c/Δ.
#[kani::proof]
fn th_stiff_limits_are_those_printed() {
    let the_loop = plain();
    let speed = up_to(UNITS);
    let at_speed = stiffness::limit_at_speed(&the_loop, &speed);
    kani::cover!(at_speed > the_loop.stiffness, "the wall could be stiffer");
    kani::assert(
        at_speed * (the_loop.period * speed + Ratio::integer(LENGTH))
            == (the_loop.viscous_friction() * speed + the_loop.coulomb_friction()).double(),
        "TH-STIFF: the limit at a speed is 2(bv + c)/(Tv + Δ)",
    );
    let viscous = stiffness::viscous_limit(&the_loop);
    kani::assert(
        viscous * the_loop.period == the_loop.viscous_friction().double(),
        "TH-STIFF: the viscous limit is 2b/T",
    );
    let coulomb = stiffness::coulomb_limit(&the_loop);
    kani::assert(
        coulomb.is_some_and(|limit| {
            limit * Ratio::integer(LENGTH) == the_loop.coulomb_friction().double()
        }),
        "TH-STIFF: the Coulomb limit is 2c/Δ",
    );
}

/// TH-STIFF: K is within the limit at a speed exactly when (11) holds there.
#[kani::proof]
fn th_stiff_limit_at_a_speed() {
    let the_loop = with_effects();
    let speed = up_to(UNITS);
    let holds = holds(the_loop.criterion().margin(&speed));
    kani::cover!(holds, "the criterion holds");
    kani::assert(
        holds == (the_loop.stiffness <= stiffness::limit_at_speed(&the_loop, &speed)),
        "TH-STIFF: K is admissible at v exactly up to the limit",
    );
}

/// TH-STIFF: K is within the limit at all speeds exactly when (11) holds at every speed.
#[kani::proof]
fn th_stiff_limit_at_all_speeds() {
    let the_loop = with_effects();
    let criterion = the_loop.criterion();
    let limit = stiffness::limit_at_all_speeds(&the_loop);
    kani::cover!(the_loop.stiffness == limit, "on the border");
    kani::assert(
        holds(criterion.margin_at_all_speeds()) == (the_loop.stiffness <= limit),
        "TH-STIFF: K is admissible at every speed exactly up to the limit",
    );
    kani::assert(
        holds(criterion.viscous) == (the_loop.stiffness <= stiffness::viscous_limit(&the_loop)),
        "TH-STIFF: the viscous limit is where viscous friction is just enough",
    );
    kani::assert(
        stiffness::coulomb_limit(&the_loop)
            .is_some_and(|limit| holds(criterion.coulomb) == (the_loop.stiffness <= limit)),
        "TH-STIFF: the Coulomb limit is where Coulomb friction is just enough",
    );
}

/// TH-STIFF: K is within the limit up to a speed exactly when (11) holds at every speed up to it.
#[kani::proof]
fn th_stiff_limit_up_to_a_speed() {
    let the_loop = with_effects();
    let speed = up_to(UNITS);
    let holds = holds(the_loop.criterion().margin_up_to(&speed));
    kani::cover!(!holds, "the criterion fails somewhere");
    kani::assert(
        holds == (the_loop.stiffness <= stiffness::limit_up_to_speed(&the_loop, &speed)),
        "TH-STIFF: K is admissible up to v exactly up to the limit",
    );
}

/// TH-STIFF: without an encoder Coulomb friction sets no limit.
#[kani::proof]
fn th_stiff_limits_without_an_encoder() {
    let the_loop = Loop {
        resolution: None,
        ..plain()
    };
    let speed = up_to(UNITS);
    kani::cover!(
        is_zero(the_loop.coulomb_friction()),
        "without Coulomb friction"
    );
    kani::assert(
        stiffness::coulomb_limit(&the_loop).is_none()
            && stiffness::coarsest_resolution(&the_loop).is_none()
            && stiffness::coarsest_resolution_up_to_speed(&the_loop, &speed).is_none(),
        "TH-STIFF: no encoder, no limit by it",
    );
    let criterion = the_loop.criterion();
    kani::assert(
        stiffness::limit_at_all_speeds(&the_loop) * the_loop.period
            == the_loop.viscous_friction().double()
            && holds(criterion.margin(&speed))
                == (the_loop.stiffness <= stiffness::limit_up_to_speed(&the_loop, &speed)),
        "TH-STIFF: without an encoder the limits are 2b/T and 2(bv + c)/(Tv)",
    );
}

/// TH-STIFF: the friction needed leaves a margin of zero.
#[kani::proof]
fn th_stiff_friction_needed() {
    let the_loop = with_effects();
    let speed = up_to(UNITS);
    kani::cover!(
        holds(the_loop.criterion().viscous),
        "there is more than needed"
    );
    let viscous = with(
        &the_loop,
        Parameter::Viscous,
        stiffness::viscous_needed(&the_loop),
    );
    kani::assert(
        is_zero(viscous.viscous),
        "TH-STIFF: the viscous friction needed is just enough",
    );
    let at_speed = with(
        &the_loop,
        Parameter::Viscous,
        stiffness::viscous_needed_at_speed(&the_loop, &speed),
    );
    kani::assert(
        border(&at_speed, &speed),
        "TH-STIFF: the viscous friction needed at a speed is just enough",
    );
    let coulomb = with(
        &the_loop,
        Parameter::Coulomb,
        stiffness::coulomb_needed(&the_loop),
    );
    kani::assert(
        is_zero(coulomb.coulomb),
        "TH-STIFF: the Coulomb friction needed is just enough",
    );
    let up_to_speed = with(
        &the_loop,
        Parameter::Coulomb,
        stiffness::coulomb_needed_up_to_speed(&the_loop, &speed),
    );
    kani::assert(
        is_zero(up_to_speed.margin_up_to(&speed)),
        "TH-STIFF: the Coulomb friction needed up to a speed is just enough",
    );
}

/// TH-STIFF: the longest sampling period leaves a margin of zero.
///
/// At a given speed there is one where a shorter period costs nothing, so without virtual damping
/// behind an encoder.
#[kani::proof]
fn th_stiff_longest_period() {
    let the_loop = with_effects();
    let speed = up_to(UNITS);
    kani::cover!(
        holds(the_loop.criterion().viscous),
        "the period could be longer"
    );
    let longest = with(
        &the_loop,
        Parameter::Period,
        stiffness::longest_period(&the_loop),
    );
    kani::assert(
        is_zero(longest.viscous),
        "TH-STIFF: the longest period takes all viscous friction",
    );
    let undamped = Loop {
        damping: None,
        ..the_loop
    };
    let at_speed = with(
        &undamped,
        Parameter::Period,
        stiffness::longest_period_at_speed(&undamped, &speed),
    );
    kani::assert(
        border(&at_speed, &speed),
        "TH-STIFF: the longest period at a speed takes all friction",
    );
}

/// TH-STIFF: the shortest sampling period leaves no Coulomb friction.
#[kani::proof]
fn th_stiff_shortest_period() {
    let the_loop = with_effects();
    let undamped = Loop {
        damping: None,
        ..the_loop.clone()
    };
    kani::assert(
        stiffness::shortest_period(&undamped).is_none(),
        "TH-STIFF: without virtual damping no period is too short",
    );
    let damped = the_loop.damping > Some(Ratio::zero());
    if damped && undamped.criterion().coulomb > Ratio::zero() {
        let criterion = the_loop.criterion();
        kani::cover!(!holds(criterion.coulomb), "the period is too short");
        let shortest = stiffness::shortest_period(&the_loop);
        kani::assert(
            shortest.is_some_and(|shortest| {
                holds(criterion.coulomb) == (the_loop.period >= shortest)
                    && is_zero(with(&the_loop, Parameter::Period, shortest).coulomb)
            }),
            "TH-STIFF: the shortest period takes all Coulomb friction",
        );
    }
}

/// TH-STIFF: the coarsest encoder leaves a margin of zero.
#[kani::proof]
fn th_stiff_coarsest_resolution() {
    let the_loop = with_effects();
    kani::cover!(
        holds(the_loop.criterion().coulomb),
        "the encoder could be coarser"
    );
    let coarsest = stiffness::coarsest_resolution(&the_loop)
        .is_some_and(|length| is_zero(with(&the_loop, Parameter::Resolution, length).coulomb));
    kani::assert(
        coarsest,
        "TH-STIFF: the coarsest encoder takes all Coulomb friction",
    );
}

/// TH-STIFF: the coarsest encoder up to a speed leaves a margin of zero there.
#[kani::proof]
fn th_stiff_coarsest_resolution_up_to_a_speed() {
    let the_loop = Loop {
        damping: Some(below(UNITS)),
        ..plain()
    };
    let speed = up_to(UNITS);
    kani::cover!(
        holds(the_loop.criterion().margin_up_to(&speed)),
        "the encoder could be coarser"
    );
    let up_to_speed =
        stiffness::coarsest_resolution_up_to_speed(&the_loop, &speed).is_some_and(|length| {
            is_zero(with(&the_loop, Parameter::Resolution, length).margin_up_to(&speed))
        });
    kani::assert(
        up_to_speed,
        "TH-STIFF: the coarsest encoder up to a speed takes all friction there",
    );
}
