//! What a picture shows of an axis.

use passivity_core::BigRational;

use crate::number::parse;
use crate::parse::Axis;

/// From where to where an axis goes, and whether equal steps are equal factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// The lower end.
    pub from: f64,
    /// The upper end, above the lower one.
    pub to: f64,
    /// Whether equal steps are equal factors; then the lower end is above zero.
    pub log: bool,
}

/// One of two: an axis, or what belongs to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Along {
    X,
    Y,
}

impl Along {
    pub(super) const fn of<T>(self, [x, y]: &[T; 2]) -> &T {
        match self {
            Self::X => x,
            Self::Y => y,
        }
    }

    pub(super) const fn other(self) -> Self {
        match self {
            Self::X => Self::Y,
            Self::Y => Self::X,
        }
    }

    /// x and y, of which one is along this axis and the other beside it.
    pub(super) fn pair<T>(self, along: T, beside: T) -> [T; 2] {
        match self {
            Self::X => [along, beside],
            Self::Y => [beside, along],
        }
    }
}

/// Digits of a number of the plane: it is typed back as it is written.
const DIGITS: usize = 7;

impl Extent {
    /// The number at a share of the way from the lower to the upper end.
    #[must_use]
    pub fn at(&self, share: f64) -> f64 {
        if self.log {
            let (from, to) = (self.from.ln(), self.to.ln());
            return (from + share * (to - from)).exp().clamp(self.from, self.to);
        }
        self.from + share * (self.to - self.from)
    }

    /// The share of the way at which a number is: below 0 or above 1 outside. Zero and less is at
    /// minus infinity of a logarithmic axis.
    #[must_use]
    pub fn share(&self, x: f64) -> f64 {
        if self.log {
            return (x / self.from).ln() / (self.to / self.from).ln();
        }
        (x - self.from) / (self.to - self.from)
    }

    /// The decimal of seven digits, or the whole number, next to the number at a share of the way;
    /// one that the axis has, where it begins at a zero that it has not.
    pub(super) fn decimal(&self, share: f64, axis: &Axis) -> f64 {
        let x = self.at(share);
        if axis.is_whole() {
            return x.round().max(1.0);
        }
        if x == 0.0 && !axis.has_zero() {
            return short(1e-6 * self.to);
        }
        short(x)
    }
}

/// The double next to a decimal of seven digits.
fn short(x: f64) -> f64 {
    // Seven digits and an exponent are always read back.
    format!("{x:.*e}", DIGITS - 1).parse().unwrap_or(x)
}

/// The decimal that a double is written as, exactly; `None` for an infinity.
pub(super) fn exact(x: f64) -> Option<BigRational> {
    parse(&format!("{x:e}")).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_and_numbers_of_an_axis_go_back_and_forth() {
        for log in [false, true] {
            let extent = Extent {
                from: 0.5,
                to: 50.0,
                log,
            };
            for share in [0.0, 0.25, 0.8, 1.0] {
                let back = extent.share(extent.at(share));
                assert!((back - share).abs() < 1e-12, "{log} {share} {back}");
            }
        }
    }

    #[test]
    fn a_short_double_is_the_decimal_that_it_is_written_as() {
        assert_eq!(short(1.0 / 3.0), 0.333_333_3);
        let third = exact(short(1.0 / 3.0)).unwrap();
        assert_eq!(third.to_string(), "3333333/10000000");
        assert_eq!(exact(2.5e-7).unwrap().to_string(), "1/4000000");
        assert!(exact(f64::INFINITY).is_none());
    }
}
