//! The energy ledger: one exact row per sampling interval, and the balance (13) over many.

use crate::dissipation::{Friction, mean_speed};
use crate::generation::{self, Step};
use crate::parameter::Loop;
use crate::quantizer;
use crate::scalar::{Ordered, Scalar};
use crate::spring;

/// A sampling interval as it was: where it led, under which force, and in what time.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldInterval<S> {
    /// From the position at the sample to that at the end.
    pub step: Step<S>,
    /// The force that was held, by the wall's law or as it was logged, in KΔ.
    pub force: S,
    /// Δτ > 0, in sampling periods.
    pub dtau: S,
    /// What the extra storages of delay and damping gain over the interval (TH-DELAY, TH-DAMP), in
    /// KΔ²; `None` without these effects.
    pub extra_storage: Option<S>,
}

impl<S: Scalar> HeldInterval<S> {
    /// The interval of the paper's loop, whose force is that of the sample at its start (5).
    #[must_use]
    pub fn plain(step: Step<S>, dtau: S) -> Self {
        Self {
            force: quantizer::held_force(&step.start),
            step,
            dtau,
            extra_storage: None,
        }
    }
}

/// The exact account of one sampling interval. Energies in KΔ².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row<S> {
    /// E_gᴸ, generated against the linear spring, or against the wall's law (TH-LIN, TH-LAW).
    pub generated_linear: S,
    /// E_g, generated against the quantized spring or law (18) to (20); without an encoder the same.
    pub generated_quantized: S,
    /// ½d² + ½|d|, the right-hand side of (22); without an encoder ½d² (TH-SMOOTH).
    pub bound_22: S,
    /// The tight bound of `generated_quantized` for the wall alone (TH-QUANT); without an encoder ½d².
    pub bound_quantized: S,
    /// The least that friction dissipates (26).
    pub dissipated_lower: S,
    /// `dissipated_lower` − `generated_linear`, less what the extra storage gained.
    pub net_linear: S,
    /// `dissipated_lower` − `generated_quantized`, less what the extra storage gained.
    pub net_quantized: S,
    /// Margin of the criterion at the mean speed v̄: (8) times v̄, so that it is defined at rest.
    pub margin: S,
}

/// The row of an interval of a dimensionless loop: the only account there is.
///
/// For `dtau` ≤ 1 and the force of the loop's own controller, `margin` ≥ 0 implies `net_linear` ≥ 0
/// (TH-INTERVAL, TH-DELAY, TH-DAMP, TH-DAC, TH-LAW); for longer intervals both are still exact, and
/// nothing is implied (TH-JITTER).
///
/// # Fixed widths
///
/// On fractions of w-bit integers every field of the paper's own loop is defined when all
/// numerators are below 2^m in magnitude and all denominators below 2^d, d ≤ m, with
/// 3m + 9d + 5 < w and m + 11d + 1 < w: the bits of `net_linear`. That is m = d = 2 for 32 bits, 4
/// for 64 and 10 for 128 ([`Fixed`](crate::Fixed)); with a common denominator far more. Beyond that
/// a field may be undefined, and none is ever wrong.
///
/// # Example
///
/// ERR-27: the criterion holds and yet more is generated than dissipated, by the paper's account.
///
/// ```
/// use passivity_core::{Fixed, Friction, Loop, Scalar, Step, ledger};
///
/// let step = Step::new(Fixed::integer(1), Fixed::new(1, 2));
/// let paper = Loop::plain(Friction::new(Fixed::new(3, 5), Fixed::new(3, 5)));
/// let row = ledger::row(&paper, &ledger::HeldInterval::plain(step, Fixed::integer(1)));
/// assert!(row.margin > Fixed::integer(0));
/// assert!(row.net_quantized < Fixed::integer(0));
/// assert!(row.net_linear > Fixed::integer(0));
/// ```
#[must_use]
pub fn row<S: Scalar>(dimensionless: &Loop<S>, interval: &HeldInterval<S>) -> Row<S> {
    let row = row_of(
        dimensionless,
        &interval.step,
        &interval.dtau,
        generated(dimensionless, interval),
    );
    match &interval.extra_storage {
        Some(gain) => Row {
            net_linear: row.net_linear.clone() - gain.clone(),
            net_quantized: row.net_quantized.clone() - gain.clone(),
            ..row
        },
        None => row,
    }
}

/// The row of a step that took Δτ, where it is known what was [`generated`] over it: against the
/// linear spring or law, and against its quantized form.
#[must_use]
pub fn row_of<S: Scalar>(
    dimensionless: &Loop<S>,
    step: &Step<S>,
    dtau: &S,
    [generated_linear, generated_quantized]: [S; 2],
) -> Row<S> {
    let d = step.displacement();
    let speed = mean_speed(&d, dtau);
    let friction = Friction::new(
        dimensionless.viscous_friction(),
        dimensionless.coulomb_friction(),
    );
    let (bound_22, bound_quantized) = if dimensionless.has_encoder() {
        (generation::bound_22(&d), generation::bound_quantized(&d))
    } else {
        (d.square().half(), d.square().half())
    };
    let dissipated_lower = friction.dissipated_lower(&d, &speed);
    Row {
        bound_22,
        bound_quantized,
        net_linear: dissipated_lower.clone() - generated_linear.clone(),
        net_quantized: dissipated_lower.clone() - generated_quantized.clone(),
        margin: dimensionless.criterion().margin(&speed),
        generated_linear,
        generated_quantized,
        dissipated_lower,
    }
}

/// What the held force generates against the wall's law, and against its quantized form (18).
///
/// Of a linear wall the part of its own force is that of the equations, in numbers that stay small;
/// what another force adds is the work of the difference.
#[must_use]
pub fn generated<S: Scalar>(dimensionless: &Loop<S>, interval: &HeldInterval<S>) -> [S; 2] {
    let HeldInterval { step, force, .. } = interval;
    let law = dimensionless.law();
    let encoder = dimensionless.has_encoder();
    if law.is_linear() {
        return generated_by_spring(step, force, encoder);
    }
    let work = force.clone() * step.displacement();
    let change =
        |potential: &dyn Fn(&S) -> S| work.clone() + potential(&step.end) - potential(&step.start);
    let linear = change(&|xi| law.potential(xi));
    if encoder {
        [linear, change(&|xi| law.quantized_potential(xi))]
    } else {
        [linear.clone(), linear]
    }
}

/// What a held force generates against a linear wall, and against its quantized form where there is an
/// `encoder`: see [`generated`].
#[inline(always)]
#[must_use]
pub fn generated_by_spring<S: Scalar>(step: &Step<S>, force: &S, encoder: bool) -> [S; 2] {
    let d = step.displacement();
    let own = if encoder {
        quantizer::held_force(&step.start)
    } else {
        -step.start.clone()
    };
    let difference = (force.clone() - own) * d.clone();
    let [linear, quantized] = if encoder {
        [
            generation::generated_linear(step),
            generation::generated_quantized(step),
        ]
    } else {
        [d.square().half(), d.square().half()]
    };
    [difference.clone() + linear, difference + quantized]
}

impl<S: Ordered> Row<S> {
    /// Whether the linear account is short: more generated than friction surely dissipates.
    #[must_use]
    pub fn violates_linear(&self) -> Option<bool> {
        self.net_linear.is_nonnegative().map(|ok| !ok)
    }

    /// Whether the paper's account is short.
    #[must_use]
    pub fn violates_quantized(&self) -> Option<bool> {
        self.net_quantized.is_nonnegative().map(|ok| !ok)
    }
}

/// The lower bound of `net_linear` for an interval of any length Δτ > 0 (TH-JITTER), in KΔ²:
/// (β/Δτ − ½)d² + (σ − ½)|d|, with `mean_speed` = |d|/Δτ.
#[must_use]
pub fn jitter_bound<S: Scalar>(friction: &Friction<S>, displacement: &S, mean_speed: &S) -> S {
    friction.dissipated_lower(displacement, mean_speed) - generation::bound_22(displacement)
}

/// Work of the operator over an interval by the balance (13): ΔS + E_d − E_g, in KΔ².
///
/// Summed over intervals, with E_g ≤ E_d in each, the energy drawn by the operator is at most the
/// storage at the start (TH-RUN).
#[must_use]
pub fn operator_work<S: Scalar>(
    storage_start: &S,
    storage_end: &S,
    dissipated: &S,
    generated: &S,
) -> S {
    storage_end.clone() - storage_start.clone() + dissipated.clone() - generated.clone()
}

/// E_g − E_gᴸ over a step, or over any run of steps from `start` to `end` (TH-TELESCOPE), in KΔ².
///
/// Between −1/8 and 1/8, however many steps there are.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, Step, generation, ledger};
///
/// let step = Step::new(Fixed::integer(1), Fixed::new(1, 2));
/// let difference =
///     generation::generated_quantized(&step) - generation::generated_linear(&step);
/// assert_eq!(ledger::counterparts_differ_by(&step.start, &step.end), difference);
/// ```
#[must_use]
pub fn counterparts_differ_by<S: Scalar>(start: &S, end: &S) -> S {
    spring::quantization_potential(end) - spring::quantization_potential(start)
}
