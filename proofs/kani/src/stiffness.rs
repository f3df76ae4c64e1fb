//! TH-STIFF: border values of each parameter.
//!
//! A quotient is never computed: fractions are compared by cross-multiplication. T and Δ are
//! constants: they fix the units of time and length, in which every claim here is homogeneous.

use passivity_core::{Criterion, Rig, Scalar, effects::Effects, stiffness};

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

/// A rig with an encoder, one sample of delay, virtual damping and a D/A converter.
fn rig() -> Rig<Ratio> {
    Rig {
        effects: Effects {
            delay: 1,
            damping: Some(below(UNITS)),
            force_step: Some(below(UNITS)),
            ..Effects::encoder()
        },
        ..plain()
    }
}

/// A rig with an encoder and nothing else.
fn plain() -> Rig<Ratio> {
    Rig {
        viscous: below(FRICTION),
        coulomb: below(FRICTION),
        stiffness: up_to(UNITS),
        period: Ratio::integer(PERIOD),
        length: Ratio::integer(LENGTH),
        effects: Effects::encoder(),
    }
}

fn is_zero(x: Ratio) -> bool {
    x == Ratio::zero()
}

/// Whether a margin is at least zero; an undefined one is not.
fn holds(margin: Ratio) -> bool {
    margin >= Ratio::zero()
}

fn border(criterion: &Criterion<Ratio>, speed: &Ratio) -> bool {
    is_zero(criterion.margin(speed))
}

/// TH-STIFF: without further effects the limits are 2(bv + c)/(Tv + Δ), 2b/T and 2c/Δ.
#[kani::proof]
fn th_stiff_limits_are_those_printed() {
    let rig = plain();
    let speed = up_to(UNITS);
    let at_speed = stiffness::limit_at_speed(&rig, &speed);
    kani::cover!(at_speed > rig.stiffness, "the wall could be stiffer");
    kani::assert(
        at_speed * (rig.period * speed + rig.length)
            == (rig.viscous * speed + rig.coulomb).double(),
        "TH-STIFF: the limit at a speed is 2(bv + c)/(Tv + Δ)",
    );
    let viscous = stiffness::viscous_limit(&rig);
    kani::assert(
        viscous * rig.period == rig.viscous.double(),
        "TH-STIFF: the viscous limit is 2b/T",
    );
    let coulomb = stiffness::coulomb_limit(&rig);
    kani::assert(
        coulomb.is_some_and(|limit| limit * rig.length == rig.coulomb.double()),
        "TH-STIFF: the Coulomb limit is 2c/Δ",
    );
}

/// TH-STIFF: K is within the limit at a speed exactly when (11) holds there.
#[kani::proof]
fn th_stiff_limit_at_a_speed() {
    let rig = rig();
    let speed = up_to(UNITS);
    let holds = holds(rig.criterion().margin(&speed));
    kani::cover!(holds, "the criterion holds");
    kani::assert(
        holds == (rig.stiffness <= stiffness::limit_at_speed(&rig, &speed)),
        "TH-STIFF: K is admissible at v exactly up to the limit",
    );
}

/// TH-STIFF: K is within the limit at all speeds exactly when (11) holds at every speed.
#[kani::proof]
fn th_stiff_limit_at_all_speeds() {
    let rig = rig();
    let criterion = rig.criterion();
    let limit = stiffness::limit_at_all_speeds(&rig);
    kani::cover!(rig.stiffness == limit, "on the border");
    kani::assert(
        holds(criterion.margin_at_all_speeds()) == (rig.stiffness <= limit),
        "TH-STIFF: K is admissible at every speed exactly up to the limit",
    );
    kani::assert(
        holds(criterion.viscous) == (rig.stiffness <= stiffness::viscous_limit(&rig)),
        "TH-STIFF: the viscous limit is where viscous friction is just enough",
    );
    kani::assert(
        stiffness::coulomb_limit(&rig)
            .is_some_and(|limit| holds(criterion.coulomb) == (rig.stiffness <= limit)),
        "TH-STIFF: the Coulomb limit is where Coulomb friction is just enough",
    );
}

/// TH-STIFF: K is within the limit up to a speed exactly when (11) holds at every speed up to it.
#[kani::proof]
fn th_stiff_limit_up_to_a_speed() {
    let rig = rig();
    let speed = up_to(UNITS);
    let holds = holds(rig.criterion().margin_up_to(&speed));
    kani::cover!(!holds, "the criterion fails somewhere");
    kani::assert(
        holds == (rig.stiffness <= stiffness::limit_up_to_speed(&rig, &speed)),
        "TH-STIFF: K is admissible up to v exactly up to the limit",
    );
}

/// TH-STIFF: without an encoder Coulomb friction sets no limit.
#[kani::proof]
fn th_stiff_limits_without_an_encoder() {
    let rig = Rig {
        effects: Effects::smooth(),
        ..plain()
    };
    let speed = up_to(UNITS);
    kani::cover!(is_zero(rig.coulomb), "without Coulomb friction");
    kani::assert(
        stiffness::coulomb_limit(&rig).is_none()
            && stiffness::coarsest_resolution(&rig).is_none()
            && stiffness::coarsest_resolution_up_to_speed(&rig, &speed).is_none(),
        "TH-STIFF: no encoder, no limit by it",
    );
    let criterion = rig.criterion();
    kani::assert(
        stiffness::limit_at_all_speeds(&rig) * rig.period == rig.viscous.double()
            && holds(criterion.margin(&speed))
                == (rig.stiffness <= stiffness::limit_up_to_speed(&rig, &speed)),
        "TH-STIFF: without an encoder the limits are 2b/T and 2(bv + c)/(Tv)",
    );
}

/// TH-STIFF: the friction needed leaves a margin of zero.
#[kani::proof]
fn th_stiff_friction_needed() {
    let rig = rig();
    let speed = up_to(UNITS);
    kani::cover!(holds(rig.criterion().viscous), "there is more than needed");
    let viscous = Rig {
        viscous: stiffness::viscous_needed(&rig),
        ..rig
    };
    kani::assert(
        is_zero(viscous.criterion().viscous),
        "TH-STIFF: the viscous friction needed is just enough",
    );
    let at_speed = Rig {
        viscous: stiffness::viscous_needed_at_speed(&rig, &speed),
        ..rig
    };
    kani::assert(
        border(&at_speed.criterion(), &speed),
        "TH-STIFF: the viscous friction needed at a speed is just enough",
    );
    let coulomb = Rig {
        coulomb: stiffness::coulomb_needed(&rig),
        ..rig
    };
    kani::assert(
        is_zero(coulomb.criterion().coulomb),
        "TH-STIFF: the Coulomb friction needed is just enough",
    );
    let up_to_speed = Rig {
        coulomb: stiffness::coulomb_needed_up_to_speed(&rig, &speed),
        ..rig
    };
    kani::assert(
        is_zero(up_to_speed.criterion().margin_up_to(&speed)),
        "TH-STIFF: the Coulomb friction needed up to a speed is just enough",
    );
}

/// TH-STIFF: the longest sampling period leaves a margin of zero.
#[kani::proof]
fn th_stiff_longest_period() {
    let rig = rig();
    let speed = up_to(UNITS);
    kani::cover!(holds(rig.criterion().viscous), "the period could be longer");
    let longest = Rig {
        period: stiffness::longest_period(&rig),
        ..rig
    };
    kani::assert(
        is_zero(longest.criterion().viscous),
        "TH-STIFF: the longest period takes all viscous friction",
    );
    // BΔ/T is kept as it is there, so the margin is zero only without damping.
    let undamped = Rig {
        effects: Effects {
            damping: None,
            ..rig.effects
        },
        ..rig
    };
    let at_speed = Rig {
        period: stiffness::longest_period_at_speed(&undamped, &speed),
        ..undamped
    };
    kani::assert(
        border(&at_speed.criterion(), &speed),
        "TH-STIFF: the longest period at a speed takes all friction",
    );
}

/// TH-STIFF: the coarsest encoder leaves a margin of zero.
#[kani::proof]
fn th_stiff_coarsest_resolution() {
    let rig = rig();
    kani::cover!(
        holds(rig.criterion().coulomb),
        "the encoder could be coarser"
    );
    let coarsest = stiffness::coarsest_resolution(&rig)
        .is_some_and(|length| is_zero(Rig { length, ..rig }.criterion().coulomb));
    kani::assert(
        coarsest,
        "TH-STIFF: the coarsest encoder takes all Coulomb friction",
    );
}

/// TH-STIFF: the coarsest encoder up to a speed leaves a margin of zero there.
#[kani::proof]
fn th_stiff_coarsest_resolution_up_to_a_speed() {
    let rig = Rig {
        effects: Effects {
            damping: Some(below(UNITS)),
            ..Effects::encoder()
        },
        ..plain()
    };
    let speed = up_to(UNITS);
    kani::cover!(
        holds(rig.criterion().margin_up_to(&speed)),
        "the encoder could be coarser"
    );
    let up_to_speed = stiffness::coarsest_resolution_up_to_speed(&rig, &speed)
        .is_some_and(|length| is_zero(Rig { length, ..rig }.criterion().margin_up_to(&speed)));
    kani::assert(
        up_to_speed,
        "TH-STIFF: the coarsest encoder up to a speed takes all friction there",
    );
}
