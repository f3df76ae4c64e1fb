//! An exact quotient for a model checker: n/d, never reduced, nothing hidden in an option.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use passivity_core::{Ordered, Scalar};

/// The fraction n/d with d > 0, for the claims that divide; d = 0 is the undefined value.
///
/// Like the kernel's own fractions it cross-multiplies and never divides. Unlike them it keeps a
/// denominator that depends on no symbol a constant of the model checker: halving doubles it
/// whatever the numerator, and no overflow is caught. Every operation is Rust's own on `i32`,
/// whose overflow is a failure of the harness.
///
/// # Example
///
/// ```
/// use passivity_core::Scalar;
/// use passivity_kani::Ratio;
///
/// let third = Ratio::integer(1).over(Ratio::integer(3));
/// assert_eq!(third + third.half(), Ratio::integer(1).half());
/// assert_ne!(third.over(Ratio::zero()), third.over(Ratio::zero())); // undefined equals nothing
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Ratio {
    n: i32,
    d: i32,
}

impl Ratio {
    const UNDEFINED: Self = Self { n: 0, d: 0 };

    /// The fraction n/d; d > 0.
    #[must_use]
    pub const fn new(n: i32, d: i32) -> Self {
        Self { n, d }
    }

    /// Both numerators over a common denominator, and that.
    fn aligned(self, other: Self) -> (i32, i32, i32) {
        if self.d == other.d {
            (self.n, other.n, self.d)
        } else {
            (self.n * other.d, other.n * self.d, self.d * other.d)
        }
    }
}

impl Add for Ratio {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (a, b, d) = self.aligned(other);
        Self { n: a + b, d }
    }
}

impl Sub for Ratio {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let (a, b, d) = self.aligned(other);
        Self { n: a - b, d }
    }
}

impl Mul for Ratio {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            n: self.n * other.n,
            d: self.d * other.d,
        }
    }
}

impl Neg for Ratio {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            n: -self.n,
            d: self.d,
        }
    }
}

impl Scalar for Ratio {
    fn integer(n: i32) -> Self {
        Self { n, d: 1 }
    }

    fn half(self) -> Self {
        Self {
            n: self.n,
            d: self.d * 2,
        }
    }

    fn floor(&self) -> Self {
        if self.d == 0 {
            return Self::UNDEFINED;
        }
        Self {
            n: self.n.div_euclid(self.d),
            d: 1,
        }
    }

    fn abs(&self) -> Self {
        Self {
            n: if self.n < 0 { -self.n } else { self.n },
            d: self.d,
        }
    }

    fn max(self, other: Self) -> Self {
        let (a, b, d) = self.aligned(other);
        Self {
            n: if a < b { b } else { a },
            d,
        }
    }

    fn min(self, other: Self) -> Self {
        let (a, b, d) = self.aligned(other);
        Self {
            n: if b < a { b } else { a },
            d,
        }
    }

    fn over(self, divisor: Self) -> Self {
        if divisor.d == 0 {
            return Self::UNDEFINED;
        }
        let (n, d) = (self.n * divisor.d, self.d * divisor.n);
        Self {
            n: if d < 0 { -n } else { n },
            d: if d < 0 { -d } else { d },
        }
    }
}

impl Ordered for Ratio {
    fn sign(&self) -> Option<Ordering> {
        if self.d == 0 {
            None
        } else {
            Some(self.n.cmp(&0))
        }
    }
}

/// Equal as numbers: 1/2 is 2/4. An undefined value equals nothing.
impl PartialEq for Ratio {
    fn eq(&self, other: &Self) -> bool {
        let (a, b, d) = self.aligned(*other);
        d != 0 && a == b
    }
}

impl PartialOrd for Ratio {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let (a, b, d) = self.aligned(*other);
        if d == 0 { None } else { Some(a.cmp(&b)) }
    }

    // Written out: a model checker then sees one comparison of integers.
    fn le(&self, other: &Self) -> bool {
        let (a, b, d) = self.aligned(*other);
        d != 0 && a <= b
    }

    fn ge(&self, other: &Self) -> bool {
        let (a, b, d) = self.aligned(*other);
        d != 0 && a >= b
    }

    fn lt(&self, other: &Self) -> bool {
        let (a, b, d) = self.aligned(*other);
        d != 0 && a < b
    }

    fn gt(&self, other: &Self) -> bool {
        let (a, b, d) = self.aligned(*other);
        d != 0 && a > b
    }
}
