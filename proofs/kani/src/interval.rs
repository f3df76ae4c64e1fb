//! The central claim, TH-INTERVAL, and what follows from it: TH-RUN and TH-JITTER.
//!
//! TH-INTERVAL is a chain: generated ≤ bound (positions alone: TH-LIN), bound ≤ dissipated
//! (|d|, v̄, β and σ alone, here), and the whole at once on a smaller domain. Δτ does not appear:
//! v̄ = |d|/Δτ does, and Δτ ≤ 1 says |d| ≤ v̄.

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{Criterion, Friction, Loop, Ordered, Scalar, Step, generation, spring};

use crate::domain::{
    COARSE_EXPONENT, COARSE_LIMIT, FRICTION_EXPONENT, SPEED_LIMIT, coarse_position,
    friction_coefficient, speed, up_to,
};
use crate::{Dyadic, Ratio};

/// β and σ in the harness of the whole claim: [0, 1) by 1/8, 3 bits.
const SMALL_FRICTION_LIMIT: u8 = 8;

fn small_friction() -> Friction<Dyadic> {
    let beta = kani::any_where(|n: &u8| *n < SMALL_FRICTION_LIMIT);
    let sigma = kani::any_where(|n: &u8| *n < SMALL_FRICTION_LIMIT);
    Friction::new(
        Dyadic::new(i32::from(beta), FRICTION_EXPONENT),
        Dyadic::new(i32::from(sigma), FRICTION_EXPONENT),
    )
}

/// A speed in [0, 8) by 1 tick per sample.
fn whole_speed() -> Dyadic {
    let n = kani::any_where(|n: &u8| *n < SPEED_LIMIT && *n % 4 == 0);
    Dyadic::new(i32::from(n), COARSE_EXPONENT)
}

/// TH-INTERVAL: the criterion at v̄ makes ½d² + ½|d| at most βd²/Δτ + σ|d|, for Δτ ≤ 1.
#[kani::proof]
fn th_interval_criterion_makes_friction_cover_the_bound() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let d = coarse_position();
    let speed = speed();
    if speed >= d.abs()
        && Criterion::of_friction(&friction)
            .margin(&speed)
            .is_at_least_zero()
    {
        kani::cover!(
            friction.beta < Dyadic::new(1, 1) && d != Dyadic::zero(),
            "with too little viscous friction alone"
        );
        kani::cover!(
            friction.sigma < Dyadic::new(1, 1) && d != Dyadic::zero(),
            "with too little Coulomb friction alone"
        );
        kani::assert(
            generation::bound_22(&d) <= friction.dissipated_lower(&d, &speed),
            "TH-INTERVAL: the criterion makes friction cover ½d² + ½|d|",
        );
    }
}

/// TH-INTERVAL: whenever the criterion holds at v̄, friction dissipates what is generated.
///
/// All at once, from the position at the sampling instant to the energies.
#[kani::proof]
fn th_interval_generated_is_at_most_dissipated() {
    let friction = small_friction();
    let step = Step::new(coarse_position(), coarse_position());
    let d = step.displacement();
    let speed = speed();
    if speed >= d.abs()
        && Criterion::of_friction(&friction)
            .margin(&speed)
            .is_at_least_zero()
    {
        kani::cover!(
            step.ticks() < Dyadic::zero(),
            "the criterion holds and ticks are crossed"
        );
        kani::assert(
            generation::generated_linear(&step) <= friction.dissipated_lower(&d, &speed),
            "TH-INTERVAL: E_gᴸ ≤ E_d whenever the criterion holds",
        );
    }
}

/// Quarters: position, Δτ and friction of the ledger's rows, 2 or 3 bits each; a row
/// multiplies five of them.
const ROW_PARTS: i32 = 4;

fn row_fraction(low: i8, high: i8) -> Ratio {
    let n = kani::any_where(|n: &i8| *n >= low && *n <= high);
    Ratio::new(i32::from(n), ROW_PARTS)
}

/// TH-INTERVAL: a row of the ledger, from Δτ itself.
#[kani::proof]
fn th_interval_row_of_the_ledger() {
    let step = Step::new(row_fraction(0, 3), row_fraction(-4, 4));
    let friction = Friction::new(row_fraction(0, 4), row_fraction(0, 4));
    let dtau = up_to(2).half();
    let row = ledger::row(&Loop::plain(friction), &HeldInterval::plain(step, dtau));
    let holds = row.margin.is_nonnegative();
    kani::cover!(holds == Some(true), "the criterion holds");
    kani::assert(holds.is_some(), "TH-INTERVAL: the row is defined");
    if holds == Some(true) {
        kani::assert(
            row.violates_linear() == Some(false),
            "TH-INTERVAL: no row with a margin violates the linear account",
        );
    }
    kani::assert(
        row.net_linear == row.dissipated_lower - row.generated_linear
            && row.net_quantized == row.dissipated_lower - row.generated_quantized,
        "TH-INTERVAL: the row's nets are dissipated less generated",
    );
    kani::assert(
        row.violates_quantized() == Some(row.net_quantized < Ratio::zero()),
        "TH-INTERVAL: the paper's account is short when its net is below zero",
    );
    kani::assert(
        row.generated_linear <= row.bound_22 && row.generated_quantized <= row.bound_quantized,
        "TH-INTERVAL: the row's bounds bound",
    );
}

/// Quarters of a tick: what positions in ±4 can be apart, 6 bits.
const APART_LIMIT: i8 = 2 * COARSE_LIMIT;

/// TH-JITTER: the bound is what friction dissipates less ½d² + ½|d|.
///
/// With TH-LIN, E_g ≤ ½d² + ½|d|, it is a lower bound of E_d − E_gᴸ, whatever the friction and v̄.
#[kani::proof]
fn th_jitter_bound_is_dissipation_less_the_bound_of_generation() {
    let friction = small_friction();
    let n = kani::any_where(|n: &i8| *n > -APART_LIMIT && *n < APART_LIMIT);
    let d = Dyadic::new(i32::from(n), COARSE_EXPONENT);
    let speed = speed();
    let bound = ledger::jitter_bound(&friction, &d, &speed);
    kani::cover!(bound < Dyadic::zero(), "more may be generated");
    kani::assert(
        bound == friction.dissipated_lower(&d, &speed) - generation::bound_22(&d),
        "TH-JITTER: the bound is E_d less ½d² + ½|d|",
    );
}

/// TH-JITTER: for an interval of any length, E_d − E_gᴸ ≥ (β/Δτ − ½)d² + (σ − ½)|d|.
///
/// All at once, of whole speeds; for the others see the harness before.
#[kani::proof]
fn th_jitter_bound_for_any_length() {
    let friction = small_friction();
    let step = Step::new(coarse_position(), coarse_position());
    let d = step.displacement();
    let speed = whole_speed();
    kani::cover!(speed < d.abs(), "a late sample: Δτ > 1");
    let net = friction.dissipated_lower(&d, &speed) - generation::generated_linear(&step);
    kani::assert(
        net >= ledger::jitter_bound(&friction, &d, &speed),
        "TH-JITTER: E_d − E_gᴸ is at least the bound",
    );
}

/// TH-JITTER: the bound as written.
#[kani::proof]
fn th_jitter_bound_is_the_formula() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let d = coarse_position();
    let speed = speed();
    let bound = ledger::jitter_bound(&friction, &d, &speed);
    kani::cover!(bound > Dyadic::zero(), "friction is ahead");
    // (β/Δτ)d² is |d|·β·v̄.
    let dissipated = d.abs() * (friction.beta * speed + friction.sigma);
    kani::assert(
        bound == dissipated - (d.square() + d.abs()).half(),
        "TH-JITTER: the bound is (β/Δτ)d² + σ|d| − ½d² − ½|d|",
    );
}

/// TH-JITTER: the criterion makes the bound non-negative for Δτ ≤ 1.
#[kani::proof]
fn th_jitter_bound_follows_from_the_criterion() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let d = coarse_position();
    let speed = speed();
    let bound = ledger::jitter_bound(&friction, &d, &speed);
    if Criterion::of_friction(&friction)
        .margin(&speed)
        .is_at_least_zero()
    {
        kani::cover!(
            bound < Dyadic::zero(),
            "for Δτ > 1 the criterion implies nothing"
        );
        kani::assert(
            kani::implies!(speed >= d.abs() => bound.is_at_least_zero()),
            "TH-JITTER: for Δτ ≤ 1 the criterion implies that it is at least zero",
        );
    }
}

/// Energies of the induction, in whole units: every term is linear, so 4 bits show all orders.
const ENERGY_LIMIT: i8 = 8;

fn energy() -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= -ENERGY_LIMIT && *n < ENERGY_LIMIT);
    Dyadic::integer(i32::from(n))
}

fn stored() -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= 0 && *n < ENERGY_LIMIT);
    Dyadic::integer(i32::from(n))
}

/// TH-RUN: the step of the induction.
///
/// If the operator's work so far is at least the storage gained so far, and the next interval
/// generates at most what it dissipates, then that is still so one interval later. Storage is
/// never negative, so the energy drawn is at most the storage at the start.
#[kani::proof]
fn th_run_step_of_the_induction() {
    let (at_start, now, next) = (stored(), stored(), stored());
    let work = energy();
    let generated = energy();
    let dissipated = energy();
    if work >= now - at_start && generated <= dissipated {
        kani::cover!(work < Dyadic::zero() && next < now, "energy is being drawn");
        let work = work + ledger::operator_work(&now, &next, &dissipated, &generated);
        kani::assert(
            work >= next - at_start,
            "TH-RUN: the work done is at least the storage gained",
        );
        kani::assert(
            -work <= at_start,
            "TH-RUN: the energy drawn is at most the storage at the start",
        );
    }
}

/// TH-RUN: (13) balances: storage gained is work and generated energy less what is dissipated.
#[kani::proof]
fn th_run_operator_work_balances_13() {
    let (now, next) = (stored(), stored());
    let generated = energy();
    let dissipated = energy();
    let work = ledger::operator_work(&now, &next, &dissipated, &generated);
    kani::cover!(work < Dyadic::zero(), "energy is drawn");
    kani::assert(
        next == now + work + generated - dissipated,
        "TH-RUN: the operator's work balances (13)",
    );
}

/// TH-RUN: the storage S is never negative, and zero at rest in the middle.
#[kani::proof]
fn th_run_storage_is_never_negative() {
    let mu = friction_coefficient();
    let xi = coarse_position();
    let v = coarse_position();
    let storage = spring::storage(&mu, &xi, &v);
    kani::cover!(storage == Dyadic::zero(), "nothing is stored");
    kani::assert(storage.is_at_least_zero(), "TH-RUN: S ≥ 0");
}

/// TH-RUN: one interval of a run, from positions to the operator's work.
///
/// Friction may dissipate more than (26) says; here it dissipates `extra` more.
#[kani::proof]
fn th_run_interval_of_a_run() {
    let friction = small_friction();
    let step = Step::new(coarse_position(), coarse_position());
    let d = step.displacement();
    let speed = whole_speed();
    let extra = Dyadic::new(1, 4);
    if speed >= d.abs()
        && Criterion::of_friction(&friction)
            .margin(&speed)
            .is_at_least_zero()
    {
        let (now, next) = (Dyadic::integer(3), Dyadic::integer(1));
        let dissipated = friction.dissipated_lower(&d, &speed) + extra;
        let generated = generation::generated_linear(&step);
        let work = ledger::operator_work(&now, &next, &dissipated, &generated);
        kani::cover!(work < Dyadic::zero(), "energy is drawn from the storage");
        kani::assert(
            work >= next - now + extra,
            "TH-RUN: in an interval with a margin no energy comes from elsewhere",
        );
    }
}
