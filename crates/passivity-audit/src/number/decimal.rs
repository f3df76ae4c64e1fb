//! Short decimals as a log has them, read without big numbers.

/// A short decimal as a numerator and a power of ten: `-12`, `0.375`. `None` for one of more than 19 digits
/// and for all else.
#[inline]
pub(crate) fn decimal(text: &[u8]) -> Option<(i64, i64)> {
    /// 64 bits hold any number of as many digits.
    const MOST: usize = 19;
    fn digits(text: &[u8], mut value: u64) -> (u64, &[u8]) {
        let mut rest = text;
        while let Some((digit @ b'0'..=b'9', after)) = rest.split_first() {
            value = value.wrapping_mul(10).wrapping_add(u64::from(digit - b'0'));
            rest = after;
        }
        (value, rest)
    }
    let (negative, text) = match text.split_first()? {
        (b'-', rest) => (true, rest),
        (b'+', rest) => (false, rest),
        _ => (false, text),
    };
    let (value, rest) = digits(text, 0);
    let whole = text.len() - rest.len();
    let (value, decimals) = match rest.split_first() {
        None => (value, 0),
        Some((b'.', fraction)) => match digits(fraction, value) {
            (value, []) => (value, fraction.len()),
            _ => return None,
        },
        Some(_) => return None,
    };
    if !(1..=MOST).contains(&(whole + decimals)) {
        return None;
    }
    let value = i64::try_from(value).ok()?;
    let power = power_of_ten(u32::try_from(decimals).ok()?)?;
    Some((if negative { -value } else { value }, power))
}

/// 10^k, where 64 bits hold it.
#[inline]
pub(crate) fn power_of_ten(k: u32) -> Option<i64> {
    const POWERS: [i64; 19] = [
        1,
        10,
        100,
        1_000,
        10_000,
        100_000,
        1_000_000,
        10_000_000,
        100_000_000,
        1_000_000_000,
        10_000_000_000,
        100_000_000_000,
        1_000_000_000_000,
        10_000_000_000_000,
        100_000_000_000_000,
        1_000_000_000_000_000,
        10_000_000_000_000_000,
        100_000_000_000_000_000,
        1_000_000_000_000_000_000,
    ];
    POWERS.get(usize::try_from(k).ok()?).copied()
}

/// A short decimal up to `end` or a line break at the start of a text, as [`decimal`] reads it, and where it
/// ends.
#[inline]
pub(crate) fn leading_decimal(text: &[u8], end: u8) -> Option<((i64, i64), usize)> {
    /// 64 bits hold any number of as many digits.
    const MOST: usize = 18;
    let mut rest = text.iter();
    let (mut value, mut digits, mut decimals, mut negative) = (0_i64, 0_usize, None, false);
    loop {
        match rest.next() {
            Some(byte @ b'0'..=b'9') => {
                value = value.wrapping_mul(10).wrapping_add(i64::from(byte - b'0'));
                digits += 1;
            }
            Some(b'.') if decimals.is_none() => decimals = Some(digits),
            Some(b'-') if digits == 0 && decimals.is_none() && !negative => negative = true,
            Some(byte) if *byte == end || *byte == b'\n' => break,
            Some(b'\r') if rest.as_slice().first() == Some(&b'\n') => break,
            _ => return None,
        }
    }
    if digits == 0 || digits > MOST {
        return None;
    }
    let decimals = decimals.map_or(0, |before| digits - before);
    let power = power_of_ten(u32::try_from(decimals).ok()?)?;
    let length = text.len() - rest.as_slice().len() - 1;
    Some(((if negative { -value } else { value }, power), length))
}

/// A short literal without an exponent: `-12`, `0.375`, `3/8`. `None` for all else, which is then for the
/// full parser to read or to refuse.
pub(crate) fn short(text: &[u8]) -> Option<(i64, i64)> {
    if let Some(decimal) = decimal(text) {
        return Some(decimal);
    }
    let slash = memchr::memchr(b'/', text)?;
    let (numerator, denominator) = text.split_at_checked(slash)?;
    match (decimal(numerator)?, decimal(denominator.get(1..)?)?) {
        ((n, 1), (d @ 1.., 1)) if denominator.iter().skip(1).all(u8::is_ascii_digit) => {
            Some((n, d))
        }
        _ => None,
    }
}
