//! Exact numbers in and out, fast where they are small.

mod arithmetic;
mod decimal;
mod digits;
mod dyadic;
mod factored;
mod line;
mod terms;
mod whole;

use num_bigint::BigInt;
use num_integer::Integer as _;
use passivity_core::{BigRational, Fixed, Ordered, Wide, rational};
use passivity_scene::number::{NumberError, nearest_f64, parse};

pub use arithmetic::is_positive;
pub(crate) use arithmetic::{Denominator, difference, is_less, product, quotient};
pub(crate) use decimal::{MOST_DECIMALS, decimal, leading_decimal, power_of_ten, short};
pub(crate) use digits::{Fraction, Fractions, SEVERAL};
pub(crate) use dyadic::{Bits, Dyadic};
pub(crate) use factored::{Beside, Factored, Primes, Quotient, Split};
pub(crate) use line::Line;
pub(crate) use terms::{Exact, Size, Term, Total};
pub(crate) use whole::ample;
pub use whole::{Ample, Whole, to_ample};

/// The widest numerator or denominator that is read from a trace or a request, in bits. Exact
/// motions have at most as many, doubles need 1075; past it, arithmetic would take seconds a row.
pub const MAX_BITS: u64 = 4096;

/// An exact number, kept small when it can be.
///
/// # Example
///
/// ```
/// use passivity_audit::Number;
///
/// let x = Number::parse("0.375").unwrap();
/// assert_eq!(x.to_string(), "3/8");
/// assert!(Number::parse("1e999999999").is_err());
/// ```
#[derive(Clone, Debug)]
pub enum Number {
    /// A numerator over a denominator above zero, not reduced.
    Small(i64, i64),
    /// A double with more bits behind the point than that: n/2^k in lowest terms, k > 62.
    Tiny(i64, u32),
    /// Anything else.
    Big(Box<BigRational>),
}

/// 2^k.
fn power_of_two(k: u32) -> BigInt {
    BigInt::from(1) << k
}

impl Number {
    /// Reads what [`passivity_scene::number::parse`] reads.
    ///
    /// # Errors
    ///
    /// As that function.
    pub fn parse(text: &str) -> Result<Self, NumberError> {
        match short(text.as_bytes()) {
            Some((n, d)) => Ok(Self::Small(n, d)),
            None => parse(text).map(Self::from),
        }
    }

    /// Whether numerator and denominator have at most [`MAX_BITS`] bits.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        match self {
            // No double has more than 1074.
            Self::Small(..) | Self::Tiny(..) => true,
            Self::Big(x) => is_bounded(x),
        }
    }

    /// The dyadic rational that a double is; `None` for NaN and infinities.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_audit::Number;
    ///
    /// assert_eq!(Number::from_f64(0.375).unwrap().to_string(), "3/8");
    /// assert!(Number::from_f64(f64::NAN).is_none());
    /// ```
    #[must_use]
    pub fn from_f64(x: f64) -> Option<Self> {
        const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
        if !x.is_finite() {
            return None;
        }
        let bits = x.to_bits();
        let fraction = (bits & ((1 << FRACTION) - 1)).cast_signed();
        // Below the normal numbers the exponent is that of the least of them, without the leading one.
        let (mantissa, exponent) = match (bits >> FRACTION) & 0x7ff {
            0 => (fraction, 1),
            exponent => (fraction | 1 << FRACTION, exponent),
        };
        if mantissa == 0 {
            return Some(Self::whole(0));
        }
        let zeros = mantissa.trailing_zeros();
        let n = if x < 0.0 {
            -(mantissa >> zeros)
        } else {
            mantissa >> zeros
        };
        // x = n·2^(zeros + exponent − 1075), and the exponent is 2046 at most.
        let behind = 1075 - i32::try_from(exponent).ok()? - i32::try_from(zeros).ok()?;
        Some(match u32::try_from(behind) {
            Ok(k @ 0..=62) => Self::Small(n, 1 << k),
            Ok(k) => Self::Tiny(n, k),
            Err(_) => {
                let size = power_of_two(behind.unsigned_abs());
                BigRational::from_integer(size * n).into()
            }
        })
    }

    /// The whole number `n`.
    #[must_use]
    pub const fn whole(n: i64) -> Self {
        Self::Small(n, 1)
    }

    /// The number over checked 128-bit integers, when it fits.
    #[must_use]
    pub fn to_fixed(&self) -> Option<Fixed> {
        match self {
            Self::Small(n, d) => Some(Fixed::new((*n).into(), (*d).into())),
            Self::Tiny(n, k @ 0..=126) => Some(Fixed::new((*n).into(), 1 << *k)),
            Self::Tiny(..) => None,
            Self::Big(x) => rational::to_fixed(x),
        }
    }

    /// The number over whole numbers of any size.
    #[must_use]
    pub fn to_ample(&self) -> Ample {
        match self {
            Self::Small(n, d) => ample(*n, *d),
            Self::Tiny(n, k @ 0..=126) => ample(*n, 1_i128 << *k),
            Self::Tiny(n, k) => Ample::new(i128::from(*n).into(), power_of_two(*k).into()),
            Self::Big(x) => to_ample(x),
        }
    }

    /// The number over big integers.
    #[must_use]
    pub fn to_wide(&self) -> Wide {
        match self {
            Self::Small(n, d) => Wide::new((*n).into(), (*d).into()),
            Self::Tiny(n, k) => Wide::new((*n).into(), power_of_two(*k)),
            Self::Big(x) => rational::to_wide(x),
        }
    }

    /// The same number in lowest terms.
    #[must_use]
    pub(crate) fn reduced(self) -> Self {
        match self {
            Self::Small(n, d) => match i64::try_from(n.unsigned_abs().gcd(&d.unsigned_abs())) {
                Ok(divisor) => Self::Small(n / divisor, d / divisor),
                Err(_) => self,
            },
            Self::Tiny(..) | Self::Big(_) => self,
        }
    }

    /// The number in lowest terms.
    #[must_use]
    pub fn to_rational(&self) -> BigRational {
        match self {
            Self::Small(n, d) => BigRational::new((*n).into(), (*d).into()),
            Self::Tiny(n, k) => BigRational::new_raw((*n).into(), power_of_two(*k)),
            Self::Big(x) => (**x).clone(),
        }
    }
}

impl From<BigRational> for Number {
    fn from(x: BigRational) -> Self {
        use num_traits::ToPrimitive as _;
        match (x.numer().to_i64(), x.denom().to_i64()) {
            (Some(n), Some(d)) => Self::Small(n, d),
            _ => Self::Big(Box::new(x)),
        }
    }
}

impl std::fmt::Display for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.to_rational().fmt(f)
    }
}

/// Equal as numbers.
impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Small(n, d), Self::Small(m, e)) => {
                i128::from(*n) * i128::from(*e) == i128::from(*m) * i128::from(*d)
            }
            // Both in lowest terms.
            (Self::Tiny(n, k), Self::Tiny(m, l)) => (n, k) == (m, l),
            _ => self.to_rational() == other.to_rational(),
        }
    }
}

/// Whether numerator and denominator have at most [`MAX_BITS`] bits.
#[must_use]
pub fn is_bounded(x: &BigRational) -> bool {
    x.numer().bits().max(x.denom().bits()) <= MAX_BITS
}

/// A number in lowest terms, on machine integers when they hold it.
#[derive(Clone, Debug, PartialEq)]
pub enum Reduced {
    /// A numerator over a denominator above zero.
    Small(i128, i128),
    /// Anything else.
    Big(BigRational),
}

impl Reduced {
    /// Zero.
    pub const ZERO: Self = Self::Small(0, 1);

    /// A double near the number: off by a few units in its last place, for pictures and to tell
    /// cheaply what need not be compared exactly.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn near(&self) -> f64 {
        match self {
            Self::Small(n, d) => *n as f64 / *d as f64,
            Self::Big(x) => nearest_f64(x),
        }
    }

    /// Appends the number, `3/8`, `-2`, `0`. A multiple of 2⁻⁶⁴ may share twos with its denominator, which are
    /// left out.
    pub(crate) fn write(&self, out: &mut Vec<u8>) {
        match self {
            Self::Small(n, d) => {
                let twos = n.trailing_zeros().min(d.trailing_zeros());
                let mut digits = itoa::Buffer::new();
                // The machine's word is written faster.
                let mut append = |x: u128, out: &mut Vec<u8>| {
                    let digits = match u64::try_from(x) {
                        Ok(x) => digits.format(x),
                        Err(_) => digits.format(x),
                    };
                    out.extend_from_slice(digits.as_bytes());
                };
                if *n < 0 {
                    out.push(b'-');
                }
                append(n.unsigned_abs() >> twos, out);
                if d >> twos != 1 {
                    out.push(b'/');
                    append(d.unsigned_abs() >> twos, out);
                }
            }
            Self::Big(x) => out.extend_from_slice(x.to_string().as_bytes()),
        }
    }

    /// The number.
    #[must_use]
    pub fn to_rational(&self) -> BigRational {
        match self {
            Self::Small(n, d) => BigRational::new_raw((*n).into(), (*d).into()),
            Self::Big(x) => x.clone(),
        }
    }
}

impl From<&Number> for Reduced {
    fn from(x: &Number) -> Self {
        match x.clone().reduced() {
            Number::Small(n, d) => Self::Small(n.into(), d.into()),
            x => x.to_rational().into(),
        }
    }
}

impl From<BigRational> for Reduced {
    fn from(x: BigRational) -> Self {
        use num_traits::ToPrimitive as _;
        match x.numer().to_i128().zip(x.denom().to_i128()) {
            Some((n, d)) => Self::Small(n, d),
            None => Self::Big(x),
        }
    }
}

/// A number that can be written in lowest terms.
pub trait Written: Ordered {
    /// Whether it is the number itself that is held, not an enclosure of it.
    const EXACT: bool = true;

    /// The number in lowest terms; `None` when it is undefined, or not exactly known.
    fn to_reduced(&self) -> Option<Reduced>;

    /// Whether it is a number at all.
    fn is_number(&self) -> bool {
        self.sign().is_some()
    }

    /// The number, or one close below it.
    fn below(&self) -> Option<Reduced> {
        self.to_reduced()
    }

    /// The number, or one close above it.
    fn above(&self) -> Option<Reduced> {
        self.to_reduced()
    }

    /// The number, or one of those in an enclosure.
    fn one_of(&self) -> Self {
        self.clone()
    }

    /// The same number, written with the shortest numerator and denominator.
    fn in_lowest_terms(&self) -> Option<Self> {
        Self::from_reduced(&self.to_reduced()?)
    }

    /// A number in lowest terms as one of this kind; `None` when this kind does not hold it.
    fn from_reduced(x: &Reduced) -> Option<Self>;

    /// The number in lowest terms; `None` when it is undefined.
    fn to_rational(&self) -> Option<BigRational> {
        self.to_reduced().map(|x| x.to_rational())
    }

    /// Appends the number in lowest terms, `3/8`, `-2`, `0`; nothing, and `None`, when it is
    /// undefined.
    fn write(&self, out: &mut Vec<u8>) -> Option<()> {
        self.to_reduced()?.write(out);
        Some(())
    }
}

impl Written for Fixed {
    fn to_reduced(&self) -> Option<Reduced> {
        let (&n, &d) = self.parts()?;
        if d == 1 {
            return Some(Reduced::Small(n, d));
        }
        // The machine's word is divided faster.
        if let (Ok(n), Ok(d)) = (i64::try_from(n), i64::try_from(d))
            && let Number::Small(n, d) = Number::Small(n, d).reduced()
        {
            return Some(Reduced::Small(n.into(), d.into()));
        }
        let divisor = divisor(n.unsigned_abs(), d.unsigned_abs());
        Some(match i128::try_from(divisor) {
            Ok(1) => Reduced::Small(n, d),
            Ok(divisor) => Reduced::Small(n / divisor, d / divisor),
            // Only |n| = 2¹²⁷ has such a divisor.
            Err(_) => BigRational::new(n.into(), d.into()).into(),
        })
    }

    fn from_reduced(x: &Reduced) -> Option<Self> {
        match x {
            Reduced::Small(n, d) => Some(Self::new(*n, *d)),
            Reduced::Big(_) => None,
        }
    }
}

impl Written for Wide {
    fn to_reduced(&self) -> Option<Reduced> {
        rational::from_wide(self).map(Reduced::from)
    }

    fn from_reduced(x: &Reduced) -> Option<Self> {
        Some(match x {
            Reduced::Small(n, d) => Self::new((*n).into(), (*d).into()),
            Reduced::Big(x) => rational::to_wide(x),
        })
    }
}

impl Written for BigRational {
    fn to_reduced(&self) -> Option<Reduced> {
        Some(self.clone().into())
    }

    fn from_reduced(x: &Reduced) -> Option<Self> {
        Some(x.to_rational())
    }
}

/// The greatest common divisor of two numbers, the second above zero: by the machine's word where that holds one of them.
fn divisor(n: u128, d: u128) -> u128 {
    let of_words = |small: u64, rest: u128| match u64::try_from(rest) {
        Ok(rest) => small.gcd(&rest).into(),
        Err(_) => u128::from(small).gcd(&rest),
    };
    match (u64::try_from(n), u64::try_from(d)) {
        (_, Ok(small)) => of_words(small, n % d),
        (Ok(small), _) => of_words(small, d.checked_rem(n).unwrap_or(d)),
        _ => n.gcd(&d),
    }
}
