//! Exact numbers as people read them.

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
/// ```
#[must_use]
pub fn approx(x: &BigRational) -> String {
    significant(nearest_f64(x))
}

/// Five significant digits of a double, plain between 10⁻⁴ and 10⁶ and with an exponent elsewhere.
#[must_use]
pub fn significant(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let scientific = format!("{x:.4e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        let decimals = usize::try_from(4 - exponent).unwrap_or(0);
        return trimmed(&format!("{x:.decimals$}"));
    }
    format!("{}e{exponent}", trimmed(mantissa))
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
    let (lo, hi) = (approx(x.lo()), approx(x.hi()));
    if lo == hi {
        lo
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
