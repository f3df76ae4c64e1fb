//! Exact numbers as people read them.

use num_bigint::BigInt;
use num_traits::{Signed as _, Zero as _};
use passivity_core::{BigRational, Interval};

use crate::number::nearest_f64;

/// Five significant digits of a number.
///
/// # Example
///
/// ```
/// use passivity_core::BigRational;
/// use passivity_scene::display::approx;
///
/// let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
/// assert_eq!(approx(&ratio(2, 3)), "0.66667");
/// assert_eq!(approx(&ratio(1, 2)), "0.5");
/// assert_eq!(approx(&ratio(-9, 1_000_000)), "-9e-6");
/// assert_eq!(approx(&ratio(10, 1).pow(400)), "1e400");
/// assert_eq!(approx(&ratio(10, 1).pow(-400)), "1e-400");
/// ```
#[must_use]
pub fn approx(x: &BigRational) -> String {
    let near = nearest_f64(x);
    // No double is near what is past all of them, or too small.
    match near.is_normal() || x.is_zero() {
        true => significant(near),
        false => nearest(x, 5),
    }
}

/// Five significant digits of a double, plain between 10⁻⁴ and 10⁶ and with an exponent elsewhere.
#[must_use]
pub fn significant(x: f64) -> String {
    figures(x, 5)
}

/// That many significant digits of a double, plain between 10⁻⁴ and 10⁶ and with an exponent elsewhere.
#[must_use]
pub fn figures(x: f64, digits: u8) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let after = i32::from(digits) - 1;
    let scientific = format!("{x:.*e}", usize::try_from(after).unwrap_or(0));
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        let decimals = usize::try_from(after - exponent).unwrap_or(0);
        return trimmed(&format!("{x:.decimals$}"));
    }
    format!("{}e{exponent}", trimmed(mantissa))
}

/// To which side a figure is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To the next one below: for what may be at most this.
    Down,
    /// To the next one above: for what must be at least this.
    Up,
}

/// A number with that many significant digits, rounded to one side, plain between 10⁻⁴ and 10⁶ and
/// with an exponent elsewhere.
///
/// # Example
///
/// ```
/// use passivity_core::BigRational;
/// use passivity_scene::display::{Rounding, rounded};
///
/// let two_thirds = BigRational::new(2.into(), 3.into());
/// assert_eq!(rounded(&two_thirds, 5, Rounding::Down), "0.66666");
/// assert_eq!(rounded(&two_thirds, 5, Rounding::Up), "0.66667");
/// let small = BigRational::new(1.into(), 7_000_000.into());
/// assert_eq!(rounded(&small, 3, Rounding::Up), "1.43e-7");
/// assert_eq!(rounded(&-small, 3, Rounding::Up), "-1.42e-7");
/// assert_eq!(rounded(&BigRational::new(1.into(), 2.into()), 5, Rounding::Up), "0.5");
/// ```
#[must_use]
pub fn rounded(x: &BigRational, digits: u32, to: Rounding) -> String {
    let away = match to {
        Rounding::Down => x.is_negative(),
        Rounding::Up => !x.is_negative(),
    };
    let whole = if away {
        BigRational::ceil
    } else {
        BigRational::floor
    };
    with_digits(x, digits, whole)
}

/// A double as an end of an enclosure: the shortest decimal that reads back as the double, where the number that it spells
/// is the double or outside of it, else one of 17 digits that is.
///
/// # Example
///
/// ```
/// use passivity_scene::display::{Rounding, outward};
///
/// // The double is 0.1000000000000000055….
/// assert_eq!(outward(0.1, Rounding::Down), "0.1");
/// assert_eq!(outward(0.1, Rounding::Up), "0.10000000000000001");
/// assert_eq!(outward(-0.5, Rounding::Up), "-0.5");
/// ```
#[must_use]
pub fn outward(x: f64, to: Rounding) -> String {
    let shortest = format!("{x:?}");
    let (Some(exact), Ok(spelt)) = (BigRational::from_float(x), crate::number::parse(&shortest))
    else {
        return shortest;
    };
    let is_inside = match to {
        Rounding::Down => spelt > exact,
        Rounding::Up => spelt < exact,
    };
    if is_inside {
        rounded(&exact, 17, to)
    } else {
        shortest
    }
}

/// A number rounded to the nearest with that many significant digits, written like [`rounded`].
pub(crate) fn nearest(x: &BigRational, digits: u32) -> String {
    with_digits(x, digits, BigRational::round)
}

/// A number with so many significant digits, `whole` of its size.
fn with_digits(x: &BigRational, digits: u32, whole: fn(&BigRational) -> BigRational) -> String {
    if x.is_negative() {
        return format!("-{}", with_digits(&-x, digits, whole));
    }
    if !x.is_positive() {
        return "0".to_owned();
    }
    let ten = BigRational::from_integer(10.into());
    // The exponent of the first digit: near the difference of the lengths, then put right.
    let length = |n: &BigInt| i32::try_from(n.to_string().len()).unwrap_or(i32::MAX);
    let mut exponent = length(x.numer()) - length(x.denom());
    if *x < ten.pow(exponent) {
        exponent -= 1;
    }
    let last = exponent + 1 - i32::try_from(digits).unwrap_or(i32::MAX);
    let scaled = x / ten.pow(last);
    let mut figures = whole(&scaled).to_integer().to_string();
    if figures.len() > usize::try_from(digits).unwrap_or(usize::MAX) {
        exponent += 1;
    }
    let kept = figures.trim_end_matches('0').len();
    figures.truncate(kept);
    if !(-4..6).contains(&exponent) {
        let (first, rest) = figures.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        return format!("{first}{point}{rest}e{exponent}");
    }
    if exponent < 0 {
        let zeros = usize::try_from(-exponent - 1).unwrap_or(0);
        return format!("0.{}{figures}", "0".repeat(zeros));
    }
    let whole = usize::try_from(exponent + 1).unwrap_or(1);
    if figures.len() <= whole {
        return format!("{figures}{}", "0".repeat(whole - figures.len()));
    }
    let (before, after) = figures.split_at(whole);
    format!("{before}.{after}")
}

fn trimmed(decimal: &str) -> String {
    if !decimal.contains('.') {
        return decimal.to_owned();
    }
    decimal
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_owned()
}

/// An interval: one figure when both ends read the same, else both.
#[must_use]
pub fn range(x: &Interval<BigRational>) -> String {
    joined(&approx(x.lo()), &approx(x.hi()))
}

/// An interval like [`range`], with that many significant digits.
pub(crate) fn range_with(x: &Interval<BigRational>, digits: u32) -> String {
    joined(&nearest(x.lo(), digits), &nearest(x.hi(), digits))
}

fn joined(lo: &str, hi: &str) -> String {
    if lo == hi {
        lo.to_owned()
    } else {
        format!("{lo} … {hi}")
    }
}

/// Text in lines of at most [`LINE`] characters, each but the first after `indent` spaces.
///
/// The first line is taken to start at `indent` as well.
#[must_use]
pub fn wrapped(text: &str, indent: usize) -> String {
    let mut out = String::new();
    let mut column = indent;
    for word in text.split(' ') {
        let width = word.chars().count();
        if column > indent && column + 1 + width > LINE {
            out.push('\n');
            out.push_str(&" ".repeat(indent));
            column = indent;
        } else if column > indent {
            out.push(' ');
            column += 1;
        }
        out.push_str(word);
        column += width;
    }
    out
}

/// How wide the text for people is.
pub const LINE: usize = 96;

/// Bytes as hexadecimal digits, two of each, as a hash is written.
///
/// # Example
///
/// ```
/// assert_eq!(passivity_scene::display::hexadecimal(&[0, 0x1f, 0xa0]), "001fa0");
/// ```
#[must_use]
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
