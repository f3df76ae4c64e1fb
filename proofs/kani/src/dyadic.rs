//! An exact number for a model checker: n/2ᵉ with a concrete exponent.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use passivity_core::{Ordered, Scalar};

/// The dyadic rational n/2ᵉ, for bounded model checking.
///
/// The exponent never depends on a value, only on which operations were done, so to a model
/// checker it is a constant, and aligning two numbers is a shift by a constant. Nothing is
/// reduced and nothing wraps: every operation is Rust's own on `i32`, whose overflow is a failure
/// of the harness. So a harness that passes has also shown that nothing overflowed.
///
/// # Example
///
/// ```
/// use passivity_core::Scalar;
/// use passivity_kani::Dyadic;
///
/// let quarter = Dyadic::new(1, 2);
/// assert_eq!(quarter.double(), Dyadic::integer(1).half());
/// assert_eq!(Dyadic::new(-5, 2).floor(), Dyadic::integer(-2));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Dyadic {
    n: i32,
    e: u32,
}

impl Dyadic {
    /// The number n/2ᵉ.
    #[must_use]
    pub const fn new(n: i32, e: u32) -> Self {
        Self { n, e }
    }

    /// Whether the number is at least zero.
    #[must_use]
    pub const fn is_at_least_zero(self) -> bool {
        self.n >= 0
    }

    /// Both numerators over the larger of the two denominators, and its exponent.
    fn aligned(self, other: Self) -> (i32, i32, u32) {
        let e = if self.e > other.e { self.e } else { other.e };
        // A product with a power of two, not `<<`: overflow is then seen.
        (
            self.n * (1 << (e - self.e)),
            other.n * (1 << (e - other.e)),
            e,
        )
    }
}

impl Add for Dyadic {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (a, b, e) = self.aligned(other);
        Self { n: a + b, e }
    }
}

impl Sub for Dyadic {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let (a, b, e) = self.aligned(other);
        Self { n: a - b, e }
    }
}

impl Mul for Dyadic {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            n: self.n * other.n,
            e: self.e + other.e,
        }
    }
}

impl Neg for Dyadic {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            n: -self.n,
            e: self.e,
        }
    }
}

impl Scalar for Dyadic {
    fn integer(n: i32) -> Self {
        Self { n, e: 0 }
    }

    fn half(self) -> Self {
        Self {
            n: self.n,
            e: self.e + 1,
        }
    }

    fn floor(&self) -> Self {
        // The arithmetic shift rounds down.
        Self {
            n: self.n >> self.e,
            e: 0,
        }
    }

    fn abs(&self) -> Self {
        Self {
            n: if self.n < 0 { -self.n } else { self.n },
            e: self.e,
        }
    }

    fn max(self, other: Self) -> Self {
        let (a, b, e) = self.aligned(other);
        Self {
            n: if a < b { b } else { a },
            e,
        }
    }

    fn min(self, other: Self) -> Self {
        let (a, b, e) = self.aligned(other);
        Self {
            n: if b < a { b } else { a },
            e,
        }
    }

    /// # Panics
    ///
    /// Unless the divisor is 1: harnesses divide no dyadic numbers, they use fractions for that.
    fn over(self, divisor: Self) -> Self {
        assert!(
            divisor.n == 1 && divisor.e == 0,
            "dyadic numbers are not divided"
        );
        self
    }
}

impl Ordered for Dyadic {
    fn sign(&self) -> Option<Ordering> {
        Some(self.n.cmp(&0))
    }
}

/// Equal as numbers: 1/2 is 2/4.
impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        let (a, b, _) = self.aligned(*other);
        a == b
    }
}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let (a, b, _) = self.aligned(*other);
        Some(a.cmp(&b))
    }

    // Written out: a model checker then sees one comparison of integers.
    fn le(&self, other: &Self) -> bool {
        let (a, b, _) = self.aligned(*other);
        a <= b
    }

    fn ge(&self, other: &Self) -> bool {
        let (a, b, _) = self.aligned(*other);
        a >= b
    }

    fn lt(&self, other: &Self) -> bool {
        let (a, b, _) = self.aligned(*other);
        a < b
    }

    fn gt(&self, other: &Self) -> bool {
        let (a, b, _) = self.aligned(*other);
        a > b
    }
}
