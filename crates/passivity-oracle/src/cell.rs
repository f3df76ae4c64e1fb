//! What a trace says of a position: the number itself, or the encoder's tick that it lies in.

use passivity_core::{Ordered, Quantized, Scalar};

use crate::span::Span;

/// A position n + ρ in ticks, with ρ exact or anywhere in its span.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar};
/// use passivity_oracle::Cell;
///
/// assert_eq!(Cell::of(&Fixed::new(-1, 4)).tick, Fixed::integer(-1));
/// let counted = Cell::count(Fixed::integer(7));
/// assert_eq!(counted.position().hi(), &Fixed::integer(8));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Cell<S> {
    /// n = ⌊ξ⌋ (15).
    pub tick: S,
    /// ρ = ξ − n, within [0, 1].
    pub residue: Span<S>,
}

impl<S: Scalar> Cell<S> {
    /// An exact position.
    #[must_use]
    pub fn of(xi: &S) -> Self {
        let Quantized { tick, residue } = Quantized::of(xi);
        Self {
            tick,
            residue: Span::At(residue),
        }
    }

    /// All that an encoder count says: ξ in [n, n + 1). The enclosure is that of its closure.
    #[must_use]
    pub fn count(tick: S) -> Self {
        Self {
            tick,
            residue: Span::Between(S::zero(), S::one()),
        }
    }

    /// What the force law is given: ⌊ξ⌋ + ½ with an encoder, else ξ.
    #[must_use]
    pub fn measured(&self, encoder: bool) -> S {
        let within = if encoder {
            S::one().half()
        } else {
            self.residue.lo().clone()
        };
        self.tick.clone() + within
    }
}

impl<S: Ordered> Cell<S> {
    /// ξ.
    #[must_use]
    pub fn position(&self) -> Span<S> {
        self.residue.rising(|rho| self.tick.clone() + rho.clone())
    }
}
