//! Short decimals as a log has them, read without big numbers.

/// A short decimal as a numerator and a power of ten: `-12`, `0.375`, `3.75e-1`. `None` for one of more than 19 digits, or
/// whose last digit is above the ones, and for all else.
#[inline]
pub(crate) fn decimal(text: &[u8]) -> Option<(i64, i64)> {
    /// 64 bits hold any number of as many digits.
    const MOST: usize = 19;
    let (negative, text) = match text.split_first()? {
        (b'-', rest) => (true, rest),
        (b'+', rest) => (false, rest),
        _ => (false, text),
    };
    let (value, whole) = digits(text, 0)?;
    let (value, decimals) = match text.get(whole..)?.split_first() {
        Some((b'.', fraction)) => digits(fraction, value)?,
        _ => (value, 0),
    };
    let at = whole + decimals + usize::from(text.get(whole) == Some(&b'.'));
    let (exponent, length) = exponent(text.get(at..)?);
    if !(1..=MOST).contains(&(whole + decimals)) || at + length != text.len() {
        return None;
    }
    let value = i64::try_from(value).ok()?;
    let power = power_of_ten(u32::try_from(i32::try_from(decimals).ok()? - exponent).ok()?)?;
    Some((if negative { -value } else { value }, power))
}

/// A power of ten as `e-05` at the start of a text, and its length: none where no such is there.
#[inline(always)]
fn exponent(text: &[u8]) -> (i32, usize) {
    match text.first() {
        Some(b'e' | b'E') => written_exponent(text).unwrap_or((0, 0)),
        _ => (0, 0),
    }
}

/// The same, of few digits.
fn written_exponent(text: &[u8]) -> Option<(i32, usize)> {
    const FEW: usize = 3;
    let sign = usize::from(matches!(text.get(1)?, b'-' | b'+'));
    let digits = text.get(1 + sign..)?.iter();
    let digits = digits.take_while(|byte| byte.is_ascii_digit()).count();
    let end = 1 + sign + digits;
    let number = std::str::from_utf8(text.get(1..end)?).ok()?;
    let number = number.parse().ok().filter(|_| digits <= FEW)?;
    Some((number, end))
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

/// How many decimals a [leading decimal](leading_decimal) has at the most: 64 bits hold 5 to that power.
pub(crate) const MOST_DECIMALS: u8 = 27;

/// A short decimal up to `end` or a line break at the start of a text, as a numerator and how many of its
/// digits are decimals, and where it ends. Doubles near zero are written with as many decimals as 10^k has no room for.
#[inline]
pub(crate) fn leading_decimal(text: &[u8], end: u8) -> Option<((i64, u8), usize)> {
    /// 64 bits without a sign hold any number of as many digits, such as the nanoseconds since 1970.
    const MOST: usize = 19;
    let negative = text.first() == Some(&b'-');
    let start = usize::from(negative);
    let (whole, before) = few_digits(text.get(start..)?)?;
    let mut at = start + before;
    let (mut value, mut decimals) = (whole, 0);
    if text.get(at) == Some(&b'.') {
        (value, decimals) = digits(text.get(at + 1..)?, whole)?;
        at += 1 + decimals;
    }
    if before + decimals == 0 {
        return None;
    }
    if before + decimals > MOST && before + decimals - zeros_before(text.get(start..at)?) > MOST {
        return None;
    }
    let (exponent, length) = exponent(text.get(at..)?);
    at += length;
    match text.get(at)? {
        b'\n' => {}
        b'\r' if text.get(at + 1) == Some(&b'\n') => {}
        byte if *byte == end => {}
        _ => return None,
    }
    let value = i64::try_from(value).ok()?;
    let decimals = i32::try_from(decimals).ok()? - exponent;
    let decimals = u8::try_from(decimals).ok();
    let decimals = decimals.filter(|k| *k <= MOST_DECIMALS)?;
    Some(((if negative { -value } else { value }, decimals), at))
}

/// How many zeros stand before the first other digit, which they do not change. Few numbers have so many digits that this is
/// asked.
#[cold]
#[inline(never)]
fn zeros_before(mantissa: &[u8]) -> usize {
    let zeros = mantissa.iter();
    let zeros = zeros.take_while(|byte| matches!(byte, b'0' | b'.'));
    zeros.filter(|byte| **byte == b'0').count()
}

/// The digits at the start of a text, of which there may be few: as [`digits`] has them.
#[inline(always)]
fn few_digits(text: &[u8]) -> Option<(u64, usize)> {
    /// As many are read faster one by one.
    const FEW: usize = 4;
    let mut value = 0;
    for (i, byte) in text.iter().take(FEW).enumerate() {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return Some((value, i));
        }
        value = 10 * value + u64::from(digit);
    }
    let (value, more) = digits(text.get(FEW..)?, value)?;
    Some((value, FEW + more))
}

/// Appends the digits at the start of a text to a number, and says how many there are; `None` for more than 24.
#[inline(always)]
fn digits(text: &[u8], value: u64) -> Option<(u64, usize)> {
    let word = match text.first_chunk::<8>() {
        Some(word) => u64::from_le_bytes(*word),
        None => {
            let mut word = [0; 8];
            word.iter_mut()
                .zip(text)
                .for_each(|(slot, byte)| *slot = *byte);
            u64::from_le_bytes(word)
        }
    };
    // Of a digit the upper half is zero now, and adding six does not change that.
    let found = word ^ 0x3030_3030_3030_3030;
    let other = (found.wrapping_add(0x0606_0606_0606_0606) | found) & 0xf0f0_f0f0_f0f0_f0f0;
    let here = (other.trailing_zeros() / 8) as usize;
    if here == 0 {
        return Some((value, 0));
    }
    // The first digit is in the lowest byte: those behind the last one are shifted out, zeros come before.
    let eight = found << (64 - 8 * here);
    let pairs = eight.wrapping_mul(10).wrapping_add(eight >> 8) & 0x00ff_00ff_00ff_00ff;
    let fours = pairs.wrapping_mul(100).wrapping_add(pairs >> 16) & 0x0000_ffff_0000_ffff;
    let all = fours.wrapping_mul(10_000).wrapping_add(fours >> 32) & 0xffff_ffff;
    let power = power_of_ten(u32::try_from(here).ok()?)?;
    let mut value = value.wrapping_mul(power.cast_unsigned()).wrapping_add(all);
    if here < 8 {
        return Some((value, here));
    }
    // Few numbers have many more.
    let mut count = here;
    for byte in text.get(here..)?.iter().take(17) {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return Some((value, count));
        }
        value = value.wrapping_mul(10).wrapping_add(digit.into());
        count += 1;
    }
    (count <= 24).then_some((value, count))
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
        ((n, 1), (d @ 1.., 1))
            if denominator.iter().skip(1).all(u8::is_ascii_digit)
                && !numerator.iter().any(u8::is_ascii_alphabetic) =>
        {
            Some((n, d))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Number;
    use num_bigint::BigInt;
    use passivity_core::BigRational;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_short_decimal_is_the_number_that_it_spells(
            text in "[-+]?[0-9]{0,20}(\\.[0-9]{0,20})?([eE][-+]?[0-9]{0,4})?",
        ) {
            if let Some((n, power)) = decimal(text.as_bytes()) {
                let expected = passivity_scene::number::parse(&text).unwrap();
                prop_assert_eq!(Number::Small(n, power), Number::from(expected));
            }
        }

        #[test]
        fn a_leading_decimal_is_the_decimal_up_to_its_end(
            text in prop_oneof![
                "-?[0-9]{0,20}(\\.[0-9]{0,20})?[,;x\n]?",
                "-?[0-9]{0,3}(\\.[0-9]{0,20})?[eE][-+]?[0-9]{0,4}[,;x\n]?",
                "-?0{0,20}\\.0{0,10}[1-9][0-9]{0,18}([eE]-?[0-9]{1,2})?[,\n]",
                "[-.0-9/:+e ]{0,6}[,\n]",
                "[ -~\r\n]{0,12}",
            ],
            rest in "[0-9.,\n\r-]{0,12}",
        ) {
            let all = format!("{text}{rest}");
            let found = leading_decimal(all.as_bytes(), b',');
            let end = all.find([',', '\n']);
            let field = end.map(|end| {
                let field = all[..end].strip_suffix('\r').filter(|_| all.as_bytes()[end] == b'\n');
                field.unwrap_or(&all[..end])
            });
            let expected = field.and_then(|field| {
                let (n, power) = decimal(field.as_bytes()).filter(|_| !field.starts_with('+'))?;
                let decimals = u8::try_from(power.ilog10()).unwrap();
                Some(((n, decimals), field.len()))
            });
            if let (None, Some(((n, k), length))) = (expected, found) {
                // It has zeros before its digits, or more decimals.
                let field = field.unwrap();
                let spelt = passivity_scene::number::parse(field).unwrap();
                let power = BigRational::from_integer(BigInt::from(10).pow(k.into()));
                prop_assert_eq!(spelt, BigRational::from_integer(n.into()) / power);
                prop_assert!(length == field.len() && k <= MOST_DECIMALS);
            } else {
                prop_assert_eq!(found, expected);
            }
        }
    }
}
