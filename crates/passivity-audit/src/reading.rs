//! A number as a trace gives it: exact, or enclosed between two ends.

use passivity_core::{BigRational, Fixed, Interval, Ordered, Scalar, Wide, rational};

use crate::figure::Figure;
use crate::number::Number;

/// A position in ticks, or a force in KΔ, as a trace gives it.
#[derive(Clone, Debug, PartialEq)]
pub enum Reading {
    /// Exactly this number.
    Exact(Number),
    /// An encoder's count n: a position in [n, n + 1).
    Count(i64),
    /// A number in an interval, as when Δ has π in it; of a position, within one tick.
    Within(Box<Interval<BigRational>>),
}

impl Reading {
    /// What is known of the number, on machine integers; `None` when they do not hold it.
    #[must_use]
    pub fn to_fixed(&self) -> Option<Figure<Fixed>> {
        match self {
            Self::Exact(x) => x.to_fixed().map(Figure::Exact),
            Self::Count(n) => count(Fixed::new((*n).into(), 1)),
            Self::Within(range) => range.try_map(rational::to_fixed).map(Figure::Enclosed),
        }
    }

    /// What is known of the number, on big integers.
    #[must_use]
    pub fn to_wide(&self) -> Figure<Wide> {
        match self {
            Self::Exact(x) => Figure::Exact(x.to_wide()),
            Self::Count(n) => {
                let tick = Wide::new((*n).into(), 1.into());
                Figure::Enclosed(Interval::hull(tick.clone(), tick + Wide::one()))
            }
            Self::Within(range) => Figure::Enclosed(range.map(rational::to_wide)),
        }
    }

    /// What is known of the number.
    #[must_use]
    pub fn to_rational(&self) -> Interval<BigRational> {
        match self {
            Self::Exact(x) => Interval::point(x.to_rational()),
            Self::Count(n) => {
                let tick = BigRational::from_integer((*n).into());
                Interval::hull(tick.clone(), tick + BigRational::one())
            }
            Self::Within(range) => (**range).clone(),
        }
    }
}

/// [n, n + 1]: the closure of where the position may be.
fn count<S: Ordered>(tick: S) -> Option<Figure<S>> {
    Figure::between(tick.clone(), tick + S::one())
}
