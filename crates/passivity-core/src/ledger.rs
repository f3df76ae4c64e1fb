//! The energy ledger: one exact row per sampling interval, and the balance (13) over many.

use crate::criterion::Criterion;
use crate::dissipation::{Friction, mean_speed};
use crate::generation::{self, Step};
use crate::scalar::{Ordered, Scalar};
use crate::spring;

/// The exact account of one sampling interval. Energies in KΔ².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row<S> {
    /// E_gᴸ, generated against the linear spring (TH-LIN).
    pub generated_linear: S,
    /// E_g, generated against the quantized spring (18) to (20).
    pub generated_quantized: S,
    /// ½d² + ½|d|, the right-hand side of (22).
    pub bound_22: S,
    /// The tight bound of `generated_quantized` (TH-QUANT).
    pub bound_quantized: S,
    /// The least that friction dissipates (26).
    pub dissipated_lower: S,
    /// `dissipated_lower` − `generated_linear`.
    pub net_linear: S,
    /// `dissipated_lower` − `generated_quantized`.
    pub net_quantized: S,
    /// Margin of the criterion at the mean speed v̄: (8) times v̄, so that it is defined at rest.
    pub margin: S,
}

/// The row of a step that takes `dtau` > 0 sampling periods.
///
/// For `dtau` ≤ 1, `margin` ≥ 0 implies `net_linear` ≥ 0 (TH-INTERVAL); for longer intervals both
/// are still exact, and nothing is implied (TH-JITTER).
///
/// # Fixed widths
///
/// On fractions of w-bit integers every field is defined when all numerators are below 2^m in
/// magnitude and all denominators below 2^d, d ≤ m, with 3m + 9d + 5 < w and m + 11d + 1 < w: the
/// bits of `net_linear`. That is m = d = 2 for 32 bits, 4 for 64 and 10 for 128
/// ([`Fixed`](crate::Fixed)); with a common denominator far more. Beyond that a field may be
/// undefined, and none is ever wrong.
///
/// # Example
///
/// ERR-27: the criterion holds and yet more is generated than dissipated, by the paper's account.
///
/// ```
/// use passivity_core::{Fixed, Friction, Scalar, Step, ledger};
///
/// let step = Step::new(Fixed::integer(1), Fixed::new(1, 2));
/// let friction = Friction::new(Fixed::new(3, 5), Fixed::new(3, 5));
/// let row = ledger::row(&step, &friction, &Fixed::integer(1));
/// assert!(row.margin > Fixed::integer(0));
/// assert!(row.net_quantized < Fixed::integer(0));
/// assert!(row.net_linear > Fixed::integer(0));
/// ```
#[must_use]
pub fn row<S: Scalar>(step: &Step<S>, friction: &Friction<S>, dtau: &S) -> Row<S> {
    let d = step.displacement();
    let speed = mean_speed(&d, dtau);
    let generated_linear = generation::generated_linear(step);
    let generated_quantized = generation::generated_quantized(step);
    let dissipated_lower = friction.dissipated_lower(&d, &speed);
    Row {
        bound_22: generation::bound_22(&d),
        bound_quantized: generation::bound_quantized(&d),
        net_linear: dissipated_lower.clone() - generated_linear.clone(),
        net_quantized: dissipated_lower.clone() - generated_quantized.clone(),
        margin: Criterion::of_friction(friction).margin(&speed),
        generated_linear,
        generated_quantized,
        dissipated_lower,
    }
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
