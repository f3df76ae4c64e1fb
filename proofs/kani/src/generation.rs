//! Bounds of generated energy: (21) as far as it holds, TH-LIN, TH-QUANT and TH-TELESCOPE.

use passivity_core::{Quantized, Scalar, Step, generation, ledger, quantizer::held_force, spring};

use crate::Dyadic;
use crate::domain::{coarse_position, position};

/// The most by which the two counterparts, and the two bounds, differ.
const EIGHTH: Dyadic = Dyadic::new(1, 3);

/// EQ-21a: what quantization generates is at most ½|D|.
#[kani::proof]
fn eq_21a_quantization_generates_at_most_half_a_tick() {
    let step = Step::new(position(), position());
    let effect = generation::quantization_effect(&step);
    let bound = generation::bound_21(&step.ticks());
    kani::cover!(
        effect == bound && step.ticks() < Dyadic::zero(),
        "the bound is reached by a crossing"
    );
    kani::assert(effect <= bound, "EQ-21a: E_gq ≤ ½|D|");
}

/// TH-LIN: E_gᴸ as the kernel has it is the integral (18) against the linear spring.
#[kani::proof]
fn th_lin_is_the_integral_18() {
    let step = Step::new(position(), position());
    kani::cover!(
        step.ticks() > Dyadic::integer(1),
        "several ticks are crossed"
    );
    let integral = generation::generated(
        &held_force(&step.start),
        &step,
        &spring::linear_potential(&step.start),
        &spring::linear_potential(&step.end),
    );
    kani::assert(
        integral == generation::generated_linear(&step),
        "TH-LIN: E_gᴸ is the integral (18) against the linear spring",
    );
}

/// TH-LIN: E_gᴸ ≤ ½d² + ½|d| for every step.
#[kani::proof]
fn th_lin_bound() {
    let step = Step::new(position(), position());
    let d = step.displacement();
    kani::cover!(d < Dyadic::zero(), "the wall is left");
    kani::cover!(d > Dyadic::zero(), "the wall is entered");
    kani::assert(
        generation::generated_linear(&step) <= generation::bound_22(&d),
        "TH-LIN: E_gᴸ ≤ ½d² + ½|d|",
    );
}

/// TH-LIN: how far the bound is away: ρ₀|d| for d ≤ 0, (1 − ρ₀)d for d > 0.
///
/// So it is reached at ρ₀ = 0, d ≤ 0, and approached as ρ₀ → 1, d > 0.
#[kani::proof]
fn th_lin_bound_is_tight() {
    let step = Step::new(position(), position());
    let d = step.displacement();
    let rho = Quantized::of(&step.start).residue;
    kani::cover!(
        rho == Dyadic::zero() && d < Dyadic::zero(),
        "the bound is reached"
    );
    let gap = generation::bound_22(&d) - generation::generated_linear(&step);
    let expected = if d > Dyadic::zero() {
        (Dyadic::one() - rho) * d
    } else {
        -(rho * d)
    };
    kani::assert(gap == expected, "TH-LIN: the bound is tight");
}

/// TH-QUANT: E_g ≤ ½d² + ½|d| + ½f(1 − f) for every step.
#[kani::proof]
fn th_quant_bound() {
    let step = Step::new(position(), position());
    let d = step.displacement();
    let generated = generation::generated_quantized(&step);
    kani::cover!(
        generated > generation::bound_22(&d),
        "more is generated than (22) allows"
    );
    kani::assert(
        generated <= generation::bound_quantized(&d),
        "TH-QUANT: E_g ≤ ½d² + ½|d| + ½f(1 − f)",
    );
}

/// TH-QUANT: the bound is reached by every step down from a whole tick.
#[kani::proof]
fn th_quant_bound_is_tight() {
    let d = position();
    if d <= Dyadic::zero() {
        kani::cover!(
            Quantized::of(&d).residue == Dyadic::new(1, 1),
            "half a tick too much"
        );
        // From tick 1; the kernel is the same from every whole tick (see TH-TELESCOPE).
        let step = Step::new(Dyadic::one(), Dyadic::one() + d);
        kani::assert(
            generation::generated_quantized(&step) == generation::bound_quantized(&d),
            "TH-QUANT: the bound is tight",
        );
    }
}

/// TH-QUANT: the bound interpolates (22) linearly between whole ticks, at most 1/8 above it.
#[kani::proof]
fn th_quant_bound_interpolates_22() {
    let d = position();
    let Quantized { tick, residue } = Quantized::of(&d.abs());
    kani::cover!(
        residue == Dyadic::new(1, 1),
        "the middle between whole ticks"
    );
    let below = generation::bound_22(&tick);
    let above = generation::bound_22(&(tick + Dyadic::one()));
    let bound = generation::bound_quantized(&d);
    kani::assert(
        bound == below + residue * (above - below),
        "TH-QUANT: the bound interpolates (22) at whole ticks",
    );
    kani::assert(
        bound - generation::bound_22(&d) <= EIGHTH,
        "TH-QUANT: the bound exceeds (22) by at most 1/8",
    );
}

/// TH-TELESCOPE: over one step E_g − E_gᴸ is the change of ½ρ(1 − ρ).
#[kani::proof]
fn th_telescope_counterparts_differ_by_a_potential() {
    let step = Step::new(position(), position());
    let difference = generation::generated_quantized(&step) - generation::generated_linear(&step);
    kani::cover!(difference == EIGHTH, "the counterparts differ by 1/8");
    kani::assert(
        difference == ledger::counterparts_differ_by(&step.start, &step.end),
        "TH-TELESCOPE: E_g − E_gᴸ is a change of potential",
    );
}

/// TH-TELESCOPE: over a run of steps the differences add up, and stay within 1/8.
///
/// Two steps in a row, each of any length: the step of an induction over the intervals.
#[kani::proof]
fn th_telescope_sums_stay_within_an_eighth() {
    let first = coarse_position();
    let between = coarse_position();
    let last = coarse_position();
    let sum = ledger::counterparts_differ_by(&first, &between)
        + ledger::counterparts_differ_by(&between, &last);
    let whole = ledger::counterparts_differ_by(&first, &last);
    kani::cover!(whole == -EIGHTH, "the least difference");
    kani::assert(sum == whole, "TH-TELESCOPE: the differences telescope");
    kani::assert(
        whole <= EIGHTH && whole >= -EIGHTH,
        "TH-TELESCOPE: the counterparts differ by at most 1/8 in all",
    );
}
