//! Exact values of quantities: closed rational intervals, times a power of π.

use num_traits::Signed;
use num_traits::Zero;
use passivity_core::{BigRational, Interval, Scalar};

use crate::pi;

/// A quantity's exact value in SI units: every number of [lo, hi]·π^`pi`.
///
/// A literal without tolerance is a point. The power of π is that of an angle given in turns or
/// degrees: 0 for everything else.
#[derive(Clone, Debug, PartialEq)]
pub struct Exact {
    range: Interval<BigRational>,
    pi: i8,
}

impl Exact {
    /// The point value `x`.
    #[must_use]
    pub fn point(x: BigRational) -> Self {
        Self {
            range: Interval::point(x),
            pi: 0,
        }
    }

    /// The values `range`·π^`pi`, for |`pi`| ≤ 2.
    #[must_use]
    pub const fn new(range: Interval<BigRational>, pi: i8) -> Self {
        Self { range, pi }
    }

    /// The interval without its power of π.
    #[must_use]
    pub const fn range(&self) -> &Interval<BigRational> {
        &self.range
    }

    /// The power of π.
    #[must_use]
    pub const fn pi_power(&self) -> i8 {
        self.pi
    }

    /// Whether the value is one rational number: no tolerance and no π.
    #[must_use]
    pub fn is_rational_point(&self) -> bool {
        self.range.is_point() && (self.pi == 0 || self.range.lo().is_zero())
    }

    /// A rational enclosure of the values, the tighter the higher the level of π.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{BigRational, Interval, Scalar};
    /// use passivity_scene::Exact;
    ///
    /// let half_turn = Exact::new(Interval::point(BigRational::integer(1)), 1);
    /// assert_eq!(half_turn.enclosure(0).hi().to_string(), "355/113");
    /// ```
    #[must_use]
    pub fn enclosure(&self, level: usize) -> Interval<BigRational> {
        if self.pi == 0 {
            return self.range.clone();
        }
        let pi = pi::enclosure(level);
        let power = i32::from(self.pi.unsigned_abs());
        let (mut lo, mut hi) = (pi.lo().pow(power), pi.hi().pow(power));
        if self.pi < 0 {
            (lo, hi) = (hi.recip(), lo.recip());
        }
        let scale = |x: &BigRational, when_negative: &BigRational, otherwise: &BigRational| {
            if x.is_negative() {
                x * when_negative
            } else {
                x * otherwise
            }
        };
        let least = scale(self.range.lo(), &hi, &lo);
        let most = scale(self.range.hi(), &lo, &hi);
        Interval::hull(least, most)
    }

    /// The middle of the values, with π to more digits than a double has.
    #[must_use]
    pub fn middle(&self) -> BigRational {
        let enclosure = self.enclosure(pi::PRINT_LEVEL);
        (enclosure.lo() + enclosure.hi()).half()
    }
}
