//! Exact literals: a decimal is read as the rational number that it denotes.

use std::fmt;

use num_bigint::{BigInt, BigUint, Sign};
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};
use passivity_core::BigRational;

/// The longest literal that is read, in bytes. Doubles written out in full need under 1100.
pub const MAX_CHARS: usize = 4096;

/// The largest magnitude of a decimal exponent, so that `1e999999999` cannot eat memory.
pub const MAX_EXPONENT: u32 = 4096;

/// How long a literal and how large its exponent may be.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    pub(crate) chars: usize,
    pub(crate) exponent: u32,
}

const LIMITS: Limits = Limits {
    chars: MAX_CHARS,
    exponent: MAX_EXPONENT,
};

/// What is wrong with a literal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NumberErrorKind {
    /// There is nothing to read.
    Empty,
    /// More than [`MAX_CHARS`] bytes.
    TooLong,
    /// A decimal exponent past [`MAX_EXPONENT`].
    ExponentTooLarge,
    /// A fraction with denominator zero.
    ZeroDenominator,
    /// NaN or an infinity.
    NotFinite,
    /// Anything else that spells no number.
    Malformed,
}

impl NumberErrorKind {
    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Empty => "empty_number",
            Self::TooLong => "number_too_long",
            Self::ExponentTooLarge => "exponent_too_large",
            Self::ZeroDenominator => "zero_denominator",
            Self::NotFinite => "not_finite",
            Self::Malformed => "malformed_number",
        }
    }
}

/// Why a text is not an exact number, and where.
///
/// # Example
///
/// ```
/// use passivity_scene::number;
///
/// let error = number::parse("3/0").unwrap_err();
/// assert_eq!((error.kind().name(), error.at()), ("zero_denominator", 2));
/// assert_eq!(error.to_string(), "a fraction cannot have the denominator zero");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NumberError {
    kind: NumberErrorKind,
    at: usize,
    message: String,
}

impl NumberError {
    pub(crate) fn new(kind: NumberErrorKind, at: usize, message: impl Into<String>) -> Self {
        Self {
            kind,
            at,
            message: message.into(),
        }
    }

    /// What is wrong.
    #[must_use]
    pub const fn kind(&self) -> NumberErrorKind {
        self.kind
    }

    /// The offset of the first byte that is wrong, in the text that was to be read.
    #[must_use]
    pub const fn at(&self) -> usize {
        self.at
    }
}

impl fmt::Display for NumberError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for NumberError {}

/// Reads an exact number: `3/8`, `0.375`, `3.75e-1`, `-2`, `+1`.
///
/// A fraction is a sign, digits, `/` and digits; a decimal has at least one digit, and an optional
/// point and exponent. Nothing else may stand before, between or after: no spaces, no `_`.
///
/// # Errors
///
/// [`NumberError`] with the offset of the first wrong byte: nothing to read, no number, NaN or an
/// infinity, a zero denominator, more than [`MAX_CHARS`] bytes, an exponent past
/// [`MAX_EXPONENT`]. The bounds are checked before any arithmetic.
///
/// # Example
///
/// ```
/// use passivity_scene::number::parse;
///
/// assert_eq!(parse("3.75e-1"), parse("3/8"));
/// assert_eq!(parse("-2").unwrap().to_string(), "-2");
/// assert_eq!(parse("1e999999999").unwrap_err().kind().name(), "exponent_too_large");
/// assert_eq!(parse("0.1.2").unwrap_err().at(), 3);
/// ```
pub fn parse(text: &str) -> Result<BigRational, NumberError> {
    let end = literal_len(text, LIMITS)?;
    if end < text.len() {
        return Err(malformed(text, end));
    }
    value(text, LIMITS)
}

/// Reads the number that `text` starts with; also gives its length in bytes.
pub(crate) fn parse_prefix(
    text: &str,
    limits: Limits,
) -> Result<(BigRational, usize), NumberError> {
    let end = literal_len(text, limits)?;
    let literal = text.get(..end).unwrap_or(text);
    Ok((value(literal, limits)?, end))
}

/// The length of the literal at the start of `text`, checked to be one and within bounds.
fn literal_len(text: &str, limits: Limits) -> Result<usize, NumberError> {
    let bytes = text.as_bytes();
    let digits_from = |from: usize| {
        let rest = bytes.get(from..).unwrap_or_default();
        rest.iter().take_while(|b| b.is_ascii_digit()).count()
    };
    let sign = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = digits_from(sign);
    let mut end = sign + whole;
    let mut digits = whole;
    if bytes.get(end) == Some(&b'.') {
        let decimals = digits_from(end + 1);
        digits += decimals;
        end += 1 + decimals;
    }
    if digits == 0 {
        return Err(no_digits(text, sign));
    }
    let is_integer = end == sign + whole;
    if is_integer && bytes.get(end) == Some(&b'/') {
        let denominator = digits_from(end + 1);
        if denominator > 0 {
            end += 1 + denominator;
        }
    } else if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits_from(end + 1 + sign);
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    if end > limits.chars {
        let most = limits.chars;
        return Err(NumberError::new(
            NumberErrorKind::TooLong,
            most,
            format!("a number may have at most {most} characters, this one has {end}"),
        ));
    }
    Ok(end)
}

fn no_digits(text: &str, after_sign: usize) -> NumberError {
    let rest = text.get(after_sign..).unwrap_or_default();
    let word: String = rest
        .chars()
        .take_while(char::is_ascii_alphabetic)
        .take(9)
        .collect();
    match word.to_ascii_lowercase().as_str() {
        "nan" | "inf" | "infinity" => NumberError::new(
            NumberErrorKind::NotFinite,
            after_sign,
            format!("`{word}` is not a number that a quantity can have"),
        ),
        _ if text.is_empty() => NumberError::new(
            NumberErrorKind::Empty,
            0,
            "expected a number, found nothing",
        ),
        _ => malformed(text, after_sign),
    }
}

fn malformed(text: &str, at: usize) -> NumberError {
    let message = match text.get(at..).and_then(|rest| rest.chars().next()) {
        Some(c) if at == 0 => format!(
            "expected a number such as `0.375` or `3/8`, found `{}`",
            c.escape_debug()
        ),
        Some(c) => format!("`{}` cannot stand here in a number", c.escape_debug()),
        None => "the number ends too early".to_owned(),
    };
    NumberError::new(NumberErrorKind::Malformed, at, message)
}

/// The value of a literal that [`literal_len`] accepted.
fn value(literal: &str, limits: Limits) -> Result<BigRational, NumberError> {
    let negative = literal.starts_with('-');
    let sign = usize::from(literal.starts_with(['+', '-']));
    let body = literal.get(sign..).unwrap_or_default();
    let magnitude = if let Some((numerator, denominator)) = body.split_once('/') {
        let d = natural(denominator);
        if d.is_zero() {
            return Err(NumberError::new(
                NumberErrorKind::ZeroDenominator,
                sign + numerator.len() + 1,
                "a fraction cannot have the denominator zero",
            ));
        }
        BigRational::new(signed(natural(numerator)), signed(d))
    } else {
        decimal(body, sign, limits)?
    };
    Ok(if negative { -magnitude } else { magnitude })
}

/// The value of `12.5e-3`, which starts at byte `offset` of the literal.
fn decimal(body: &str, offset: usize, limits: Limits) -> Result<BigRational, NumberError> {
    let (mantissa, exponent) = match body.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => {
            let at = offset + mantissa.len() + 1;
            (mantissa, small_exponent(exponent, at, limits.exponent)?)
        }
        None => (body, 0),
    };
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let decimals = decimals.trim_end_matches('0');
    let mut digits = String::with_capacity(whole.len() + decimals.len());
    digits.push_str(whole);
    digits.push_str(decimals);
    // Both parts fit: a literal has at most MAX_CHARS bytes.
    let mut power = exponent - i64::try_from(decimals.len()).unwrap_or(i64::MAX / 2);
    let kept = digits.trim_end_matches('0').len();
    power += i64::try_from(digits.len() - kept).unwrap_or(0);
    digits.truncate(kept);
    Ok(power_of_ten(natural(&digits), power))
}

/// n·10^power in lowest terms, for an n that 10 does not divide: so without a gcd.
fn power_of_ten(n: BigUint, power: i64) -> BigRational {
    if n.is_zero() {
        return BigRational::zero();
    }
    let magnitude = u32::try_from(power.unsigned_abs()).unwrap_or(u32::MAX);
    if power >= 0 {
        return BigRational::from_integer(signed(n * BigUint::from(10_u8).pow(magnitude)));
    }
    // n has factors 2 or factors 5, never both.
    let twos = n.trailing_zeros().unwrap_or(0).min(u64::from(magnitude));
    let mut n = n >> twos;
    let mut fives = magnitude;
    if twos == 0 {
        let five = BigUint::from(5_u8);
        while fives > 0 && (&n % &five).is_zero() {
            n /= &five;
            fives -= 1;
        }
    }
    let denominator = BigUint::from(5_u8).pow(fives) << (u64::from(magnitude) - twos);
    BigRational::new_raw(signed(n), signed(denominator))
}

fn small_exponent(text: &str, at: usize, most: u32) -> Result<i64, NumberError> {
    let negative = text.starts_with('-');
    let digits = text.trim_start_matches(['+', '-']).trim_start_matches('0');
    let magnitude = match digits {
        "" => Some(0),
        // Longer than the bound's own spelling is past it.
        _ if digits.len() > 9 => None,
        _ => digits.parse::<u32>().ok(),
    };
    match magnitude {
        Some(m) if m <= most => Ok(if negative {
            -i64::from(m)
        } else {
            i64::from(m)
        }),
        _ => Err(NumberError::new(
            NumberErrorKind::ExponentTooLarge,
            at,
            format!("a decimal exponent must lie between -{most} and {most}"),
        )),
    }
}

/// The value of ASCII digits; 0 for none.
fn natural(digits: &str) -> BigUint {
    match BigUint::parse_bytes(digits.as_bytes(), 10) {
        Some(value) => value,
        None if digits.is_empty() => BigUint::ZERO,
        None => unreachable!("only digits are read as a number"),
    }
}

fn signed(n: BigUint) -> BigInt {
    BigInt::from_biguint(Sign::Plus, n)
}

/// The double nearest to an exact number; ties go to the even one, as in IEEE 754.
///
/// Past the range of doubles it is an infinity, close to zero a signless zero.
///
/// # Example
///
/// ```
/// use passivity_scene::number::{nearest_f64, parse};
///
/// assert_eq!(nearest_f64(&parse("0.1").unwrap()), 0.1);
/// assert_eq!(nearest_f64(&parse("-1/3").unwrap()), -1.0 / 3.0);
/// assert_eq!(nearest_f64(&parse("1e400").unwrap()), f64::INFINITY);
/// ```
#[must_use]
pub fn nearest_f64(x: &BigRational) -> f64 {
    let magnitude = nearest_magnitude(x.numer().magnitude(), x.denom().magnitude());
    if x.is_negative() {
        -magnitude
    } else {
        magnitude
    }
}

/// The double nearest to n/d, for d > 0.
fn nearest_magnitude(n: &BigUint, d: &BigUint) -> f64 {
    /// The exponent of the least significant bit of the smallest double.
    const LEAST: i64 = -1074;
    if n.is_zero() {
        return 0.0;
    }
    let bits = |x: &BigUint| i64::try_from(x.bits()).unwrap_or(i64::MAX / 4);
    // 2^(size − 1) < n/d < 2^(size + 1), so at this exponent the quotient has 53 or 54 bits.
    let size = bits(n) - bits(d);
    let mut exponent = (size - 53).max(LEAST);
    let (mut quotient, mut rest) = scaled_quotient(n, d, exponent);
    if quotient.bits() > 53 {
        exponent += 1;
        (quotient, rest) = scaled_quotient(n, d, exponent);
    }
    let odd = quotient.bit(0);
    let round_up = match rest {
        std::cmp::Ordering::Less => false,
        std::cmp::Ordering::Equal => odd,
        std::cmp::Ordering::Greater => true,
    };
    if round_up {
        quotient += BigUint::one();
    }
    // At most 2^53: exact. A carry to 2^53 is the next power of two, as it should be.
    match quotient.to_u64() {
        Some(significand) => compose(significand, exponent),
        None => unreachable!("a quotient of at most 53 bits"),
    }
}

/// ⌊n/d·2^−exponent⌋, and how what is left compares with one half.
fn scaled_quotient(n: &BigUint, d: &BigUint, exponent: i64) -> (BigUint, std::cmp::Ordering) {
    let shift = exponent.unsigned_abs();
    let (n, d) = if exponent < 0 {
        (n << shift, d.clone())
    } else {
        (n.clone(), d << shift)
    };
    let quotient = &n / &d;
    let rest = n - &quotient * &d;
    (quotient, (rest << 1_u8).cmp(&d))
}

/// `significand`·2^`exponent` for significand ≤ 2^53 and exponent ≥ −1074, bit by bit: exactly.
fn compose(significand: u64, exponent: i64) -> f64 {
    const FRACTION_BITS: u32 = 52;
    if significand == 0 {
        return 0.0;
    }
    // A significand of 2^53 came from a carry.
    let (significand, exponent) = if significand > (1 << FRACTION_BITS) * 2 - 1 {
        (significand >> 1, exponent + 1)
    } else {
        (significand, exponent)
    };
    if significand < 1 << FRACTION_BITS {
        // Subnormal: the exponent is −1074 then.
        return f64::from_bits(significand);
    }
    match u64::try_from(exponent + 1075) {
        Ok(biased) if biased < 2047 => {
            f64::from_bits((biased << FRACTION_BITS) | (significand & ((1 << FRACTION_BITS) - 1)))
        }
        _ => f64::INFINITY,
    }
}
