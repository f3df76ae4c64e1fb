//! A number as a trace gives it: exact, or enclosed between two ends.

use passivity_core::{BigRational, Fixed, Interval, Ordered, Scalar, Wide, rational};

use crate::ball::Ball;
use crate::figure::Figure;
use crate::number::{Ample, Number, ample, to_ample};
use crate::span::{self, Span};

/// A position in ticks, or a force in KΔ, as a trace gives it.
#[derive(Clone, Debug, PartialEq)]
pub enum Reading {
    /// Exactly this number.
    Exact(Number),
    /// An encoder's count n: a position in [n, n + 1).
    Count(i64),
    /// A number in an interval, as when Δ has π in it; of a position, within one tick.
    Within(Scaled),
}

/// A number of a trace after a factor with π in it: enclosed, and known to be the same as another where
/// the trace has the same number.
#[derive(Clone, Debug, PartialEq)]
pub struct Scaled {
    written: Number,
    span: Span,
}

impl Scaled {
    /// The number that is `written` in the trace, scaled into `span`.
    pub(crate) const fn new(written: Number, span: Span) -> Self {
        Self { written, span }
    }

    /// On a coarser grid, which machine integers have room to compute with.
    fn coarse(&self) -> Interval<i128> {
        const DROPPED: u32 = span::BITS - GRID_BITS;
        let [lo, hi] = self.span.ends();
        Interval::new_unchecked(lo >> DROPPED, -(-hi >> DROPPED))
    }

    /// The number as the trace has it.
    pub(crate) const fn written(&self) -> &Number {
        &self.written
    }

    /// Between which multiples of 2⁻⁶⁴ it is.
    pub(crate) const fn ends(&self) -> [i128; 2] {
        self.span.ends()
    }

    /// A double near the number, where it is defined.
    #[inline]
    pub(crate) fn near(&self) -> Option<f64> {
        Ball::of_span(self.span).near()
    }

    /// An interval that holds the number.
    #[must_use]
    pub fn range(&self) -> Interval<BigRational> {
        self.coarse()
            .map(|n| BigRational::new((*n).into(), (1_i128 << GRID_BITS).into()))
    }
}

/// Steps of the coarser grid per tick, or per KΔ, as a power of two.
pub(crate) const GRID_BITS: u32 = 40;

impl Reading {
    /// What is known of the number, on machine integers; `None` when they do not hold it.
    #[must_use]
    pub fn to_fixed(&self) -> Option<Figure<Fixed>> {
        match self {
            Self::Exact(x) => x.to_fixed().map(Figure::Exact),
            Self::Count(n) => count(Fixed::new((*n).into(), 1)),
            Self::Within(x) => {
                let range = x.coarse().map(|n| Fixed::new(*n, 1 << GRID_BITS));
                Some(Figure::Enclosed(range))
            }
        }
    }

    /// The same, a short fraction over a multiple of its denominator.
    pub(crate) fn over(&self, common: i64) -> Option<Figure<Fixed>> {
        match self {
            Self::Exact(Number::Small(n, d)) => {
                let n = i128::from(*n) * i128::from(common / d);
                Some(Figure::Exact(Fixed::new(n, common.into())))
            }
            other => other.to_fixed(),
        }
    }

    /// Whether it is known to be the same number as another, which a count never is: what stands still
    /// generates nothing, however little is known of where.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Count(_), _) => false,
            // However it is spelt, and whichever way it was enclosed.
            (Self::Within(own), Self::Within(other)) => own.written == other.written,
            _ => self == other,
        }
    }

    /// What is known of the number, in doubles.
    #[inline]
    pub(crate) fn to_near(&self) -> Figure<Ball> {
        match self {
            Self::Exact(x) => Figure::Exact(Ball::of_reading(x)),
            Self::Count(n) => {
                // The end of the last tick of all is no whole number of 64 bits.
                let [tick, next] =
                    [Some(*n), n.checked_add(1)].map(|n| n.map_or(Ball::UNDEFINED, Ball::whole));
                Figure::Enclosed(Interval::new_unchecked(tick, next))
            }
            Self::Within(x) => Figure::Exact(Ball::of_span(x.span)),
        }
    }

    /// What is known of the number, on whole numbers of any size.
    #[must_use]
    pub fn to_ample(&self) -> Figure<Ample> {
        match self {
            Self::Exact(x) => Figure::Exact(x.to_ample()),
            Self::Count(n) => {
                let tick = ample(*n, 1);
                Figure::Enclosed(Interval::hull(tick.clone(), tick + Ample::one()))
            }
            Self::Within(x) => Figure::Enclosed(x.range().map(to_ample)),
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
            Self::Within(x) => Figure::Enclosed(x.range().map(rational::to_wide)),
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
            Self::Within(x) => x.range(),
        }
    }
}

/// [n, n + 1]: the closure of where the position may be.
fn count<S: Ordered>(tick: S) -> Option<Figure<S>> {
    Figure::between(tick.clone(), tick + S::one())
}
