//! How many digits the numbers of a column have, and how far off each of them may have been rounded.

use crate::number::power_of_ten;

/// The most digits that the numbers of a column are written with, in its first rows.
///
/// Writers round to decimals, as `%.3f` does, or to significant digits, as `%.6g` and the shortest decimals of doubles do,
/// and many leave out zeros at the end: beside `2.38125`, `2` stands for 2.00000. A number's own last digit is then no
/// measure of its rounding, only the most that it may be. Let numbers have d decimals and p significant digits at the most,
/// and a number its first digit at 10^e. Its unit is the greater of 10^-d and 10^(e+1-p), or that of its own last digit where
/// that is less:
///
/// - Rounded to d decimals, the longest number has its first digit at 10^(p-1-d), not below e: the greater one is 10^-d.
/// - Rounded to p significant digits, the least number has its first digit at 10^(p-1-d), not above e: it is 10^(e+1-p).
///
/// Zero has no first digit: of it d decimals are kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Digits {
    /// How many are decimals.
    pub(crate) decimals: i32,
    /// How many there are from the first that is not zero: none where all numbers are zero, or nothing is known.
    pub(crate) significant: i32,
}

/// What the first rows of a log say of the digits of a column.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Seen {
    pub(crate) digits: Digits,
    /// How many bytes of rows were looked at, and how many since the first number that is not zero.
    bytes: [usize; 2],
}

impl Seen {
    /// So many bytes are looked at from the first number on that is not zero: a device may move on for a while before it meets
    /// the wall.
    const FEW: usize = 1 << 16;
    /// No more are looked at in all.
    const MANY: usize = 1 << 20;

    /// Whether no more rows are looked at.
    pub(crate) const fn is_done(&self) -> bool {
        let [all, since] = self.bytes;
        since >= Self::FEW || all >= Self::MANY
    }

    /// Looks at a row of so many bytes, and at its number where there is one.
    pub(crate) fn see(&mut self, bytes: usize, place: Option<Place>) {
        if let Some(place) = place {
            self.digits.see(place);
        }
        let [all, since] = &mut self.bytes;
        *all += bytes;
        if self.digits.significant > 0 {
            *since += bytes;
        }
    }
}

/// Where the digits of a decimal start and end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    /// The power of ten of the first digit that is not zero; `None` of zero.
    first: Option<i32>,
    /// The power of ten of the last digit, with the other sign: how many decimals there are.
    decimals: i32,
}

impl Digits {
    /// Looks at one more number.
    fn see(&mut self, place: Place) {
        self.decimals = self.decimals.max(place.decimals);
        if let Some(first) = place.first {
            let significant = first.saturating_add(place.decimals).saturating_add(1);
            self.significant = self.significant.max(significant);
        }
    }

    /// Half a unit to which a number was rounded, at the most.
    #[inline]
    pub(crate) fn half_a_unit(self, place: Place) -> f64 {
        let kept = match place.first {
            Some(first) => (self.significant - 1).saturating_sub(first),
            None => self.decimals,
        };
        half_a_unit(place.decimals.max(self.decimals.min(kept)))
    }

    /// The same of n/10^k.
    #[inline(always)]
    pub(crate) fn half_a_unit_of(self, n: i64, k: u8) -> f64 {
        let decimals = i32::from(k);
        match decimals < self.decimals {
            true => self.half_a_unit(Place::of(n, decimals)),
            // Of as many as any has, none was left out.
            false => half_a_unit(decimals),
        }
    }
}

impl Place {
    fn of(n: i64, decimals: i32) -> Self {
        // Of 64 bits, 19 at the most.
        let digits = n.unsigned_abs().checked_ilog10();
        let first = digits.and_then(|k| i32::try_from(k).ok());
        Self {
            first: first.map(|k| k - decimals),
            decimals,
        }
    }

    /// Of a decimal, with an exponent or without, and with a point or a comma before its decimals; `None` of all else, as of
    /// fractions, which are exact.
    pub(crate) fn read(text: &[u8]) -> Option<Self> {
        let end = text.iter().position(|b| matches!(b, b'e' | b'E'));
        let (mantissa, exponent) = text.split_at(end.unwrap_or(text.len()));
        let exponent: i32 = match exponent.get(1..) {
            Some(exponent) => std::str::from_utf8(exponent).ok()?.parse().ok()?,
            None => 0,
        };
        let (mut digits, mut decimals, mut first) = (0_i32, None, None);
        for byte in mantissa
            .strip_prefix(b"-")
            .or_else(|| mantissa.strip_prefix(b"+"))
            .unwrap_or(mantissa)
        {
            match byte {
                b'.' | b',' if decimals.is_none() => decimals = Some(0),
                b'0'..=b'9' => {
                    digits = digits.checked_add(1)?;
                    decimals = decimals.map(|k: i32| k + 1);
                    if *byte != b'0' {
                        first = first.or(Some(digits));
                    }
                }
                _ => return None,
            }
        }
        let decimals = decimals.unwrap_or(0);
        let power = |nth: i32| (digits - decimals - nth).saturating_add(exponent);
        (digits > 0).then(|| Self {
            first: first.map(power),
            decimals: decimals.saturating_sub(exponent),
        })
    }
}

/// Half a unit of the last of so many decimals.
#[allow(clippy::cast_precision_loss)] // of powers of ten within 64 bits nothing is lost
pub(crate) fn half_a_unit(decimals: i32) -> f64 {
    let power = u32::try_from(decimals).ok().and_then(power_of_ten);
    power.map_or_else(|| 0.5 * 10_f64.powi(-decimals), |power| 0.5 / power as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half a unit of the first number, as powers of ten have it, in a column with the others.
    fn unit(number: &str, others: &[&str]) -> f64 {
        let mut digits = Digits::default();
        for text in others.iter().chain([&number]) {
            digits.see(Place::read(text.as_bytes()).unwrap());
        }
        let found = digits.half_a_unit(Place::read(number.as_bytes()).unwrap());
        if let Some((n, power)) = crate::number::decimal(number.as_bytes()) {
            let k = u8::try_from(power.ilog10()).unwrap();
            assert_eq!(digits.half_a_unit_of(n, k), found, "{number}");
        }
        2.0 * found
    }

    #[test]
    fn fixed_decimals_are_rounded_to_their_last() {
        let column = ["-12.500", "0.000", "123.456", "2.000"];
        for number in column {
            assert_eq!(unit(number, &column), 1e-3, "{number}");
        }
        assert_eq!(unit("2", &["12", "-1234", "0"]), 1.0);
        assert_eq!(unit("2", &[]), 1.0);
    }

    #[test]
    fn zeros_that_were_left_out_are_digits() {
        // As `%.6g` writes them.
        let column = ["2.38125", "-0.015", "1.5e-07", "0", "-2", "120"];
        assert_eq!(unit("-2", &column), 1e-5);
        assert_eq!(unit("2.5", &column), 1e-5);
        assert_eq!(unit("120", &column), 1e-3);
        assert_eq!(unit("0", &column), 1e-8);
        // As `%.3g` does.
        let column = ["0.00123", "2.38", "2e+03"];
        assert_eq!(unit("123", &column), 1.0);
        assert_eq!(unit("2e+03", &column), 10.0);
        assert_eq!(unit("2.38", &column), 1e-2);
        // The shortest of doubles, and those that were rounded to two decimals.
        assert_eq!(unit("2", &["0.30000000000000004"]), 1e-16);
        assert_eq!(unit("-2.0", &["12.38", "0.0"]), 1e-2);
        assert_eq!(unit("0.0", &["12.38"]), 1e-2);
    }

    #[test]
    fn exponents_are_read_and_fractions_have_no_last_digit() {
        assert_eq!(unit("1.234e+00", &["5.678e-09"]), 1e-3);
        assert_eq!(unit("5,678E-9", &[]), 1e-12);
        assert_eq!(unit("2e30", &["3"]), 1e30);
        for text in ["1/8", "", "-", ".", "1.2.3", "nan", "1e", "2e99999999999"] {
            assert_eq!(Place::read(text.as_bytes()), None, "{text}");
        }
        let far = Place::read(b"1e2147483647").unwrap();
        assert_eq!(Digits::default().half_a_unit(far), f64::INFINITY);
    }
}
