//! Multiples of 2⁻⁶⁴ as fractions in decimal digits: an audit may write a thousand million of them.

use multiversion::multiversion;

use crate::span::BITS;

/// Numerators below this are written here: they have 31 digits at most, and room for a sign before them.
const MOST: u128 = 1 << 102;

/// Eight times the character of zero.
const ZEROS: u64 = u64::from_ne_bytes([b'0'; 8]);

/// As many characters are copied at a time.
const WIDTH: usize = 32;

/// "/2", "/4" and so on up to "/18446744073709551616" by their logarithm, nothing for one; and how long each is.
static DENOMINATORS: [([u8; WIDTH], usize); BITS as usize + 1] = denominators();

#[expect(
    clippy::indexing_slicing,
    reason = "the compiler, which computes this, refuses an index that is out of bounds"
)]
const fn denominators() -> [([u8; WIDTH], usize); BITS as usize + 1] {
    let mut all = [([0; WIDTH], 0); BITS as usize + 1];
    let mut k = 1;
    while k < all.len() {
        let (text, length) = &mut all[k];
        text[0] = b'/';
        let mut rest = 1_u128 << k;
        *length = 2 + rest.ilog10() as usize;
        let mut place = *length;
        while rest > 0 {
            place -= 1;
            text[place] = b'0' + (rest % 10) as u8;
            rest /= 10;
        }
        k += 1;
    }
    all
}

/// In place of the denominator of a numerator that is not below [`MOST`].
const TOO_LONG: u32 = u32::MAX;

/// A multiple of 2⁻⁶⁴ in lowest terms, as it is written.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fraction {
    /// The characters of the numerator, with zeros before them.
    digits: [[u8; 8]; 4],
    is_negative: bool,
    /// The logarithm of the denominator, or [`TOO_LONG`].
    denominator: u32,
}

impl Fraction {
    const ZERO: Self = Self {
        digits: [[0; 8]; 4],
        is_negative: false,
        denominator: 0,
    };

    /// The fractions that are so many units of 2⁻⁶⁴.
    #[inline(always)]
    pub(crate) fn all<const N: usize>(units: &[i128; N]) -> [Self; N] {
        let mut eights = [[0; 4]; N];
        let mut digits = [[[0; 8]; 4]; N];
        let mut fractions = [Self::ZERO; N];
        for ((fraction, eights), n) in fractions.iter_mut().zip(&mut eights).zip(units) {
            let size = n.unsigned_abs();
            let twos = size.trailing_zeros().min(BITS);
            *eights = in_eights(size >> twos);
            fraction.is_negative = *n < 0;
            fraction.denominator = if size < MOST { BITS - twos } else { TOO_LONG };
        }
        write_eights(eights.as_flattened(), digits.as_flattened_mut());
        for (fraction, digits) in fractions.iter_mut().zip(digits) {
            fraction.digits = digits;
        }
        fractions
    }

    /// Appends the fraction: `3/8`, `-2`, `0`; `None`, and nothing, where it is past 2³⁸.
    #[inline]
    pub(crate) fn write(&self, out: &mut Vec<u8>) -> Option<()> {
        let (denominator, length) = DENOMINATORS.get(self.denominator as usize)?;
        let [a, b, c, d] = self.digits;
        let [a, b, c, d] = [word(a), word(b), word(c), word(d)];
        // Zeros on the left are left out, but for the last one of zero.
        let zeros = match [a, b, c, d] {
            [ZEROS, ZEROS, ZEROS, ZEROS] => WIDTH - 1,
            [ZEROS, ZEROS, ..] => 16 + leading(c, d),
            _ => leading(a, b),
        };
        let mut text = [[0; 8]; 8];
        *text.first_chunk_mut()? = self.digits;
        let text = text.as_flattened_mut();
        *text.get_mut(zeros.checked_sub(1)?)? = b'-';
        let start = zeros - usize::from(self.is_negative);
        append(out, text.get(start..)?.first_chunk()?, WIDTH - start);
        append(out, denominator, *length);
        Some(())
    }
}

/// Eight characters as a machine word, the first one in its lowest byte.
#[inline(always)]
const fn word(eight: [u8; 8]) -> u64 {
    u64::from_le_bytes(eight)
}

/// How many zeros there are before the first of sixteen characters that is none.
#[inline(always)]
const fn leading(upper: u64, lower: u64) -> usize {
    let zeros = match upper {
        ZEROS => u64::BITS + (lower ^ ZEROS).trailing_zeros(),
        _ => (upper ^ ZEROS).trailing_zeros(),
    };
    (zeros / 8) as usize
}

/// Appends the first `length` of some characters: all of them are copied, which is faster than so many.
#[inline(always)]
fn append(out: &mut Vec<u8>, text: &[u8; WIDTH], length: usize) {
    let end = out.len() + length;
    out.extend_from_slice(text);
    out.truncate(end);
}

/// A number below [`MOST`] in base 10⁸.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // first quotients are below 10¹⁶, and so is what their division leaves
fn in_eights(n: u128) -> [u32; 4] {
    const SIXTEEN: u64 = 10_u64.pow(16);
    const EIGHT: u64 = 10_u64.pow(8);
    // Most are machine words: they have four digits more than sixteen, and products take the place of divisions.
    let (upper, [a, b]) = match u64::try_from(n) {
        Ok(n) => (n / SIXTEEN, [0, (n / SIXTEEN) as u32]),
        Err(_) => {
            let upper = (n / u128::from(SIXTEEN)) as u64;
            (upper, [(upper / EIGHT) as u32, (upper % EIGHT) as u32])
        }
    };
    let rest = (n as u64).wrapping_sub(upper.wrapping_mul(SIXTEEN));
    [a, b, (rest / EIGHT) as u32, (rest % EIGHT) as u32]
}

/// The characters of a number below 10⁴: pairs of digits, then digits.
#[inline(always)]
const fn four(n: u32) -> u32 {
    // 5243/2¹⁹ is so little above 1/100, and 103/2¹⁰ above 1/10, that the quotients of such numbers are these.
    let hundreds = n.wrapping_mul(5243) >> 19;
    let pairs = hundreds | (n.wrapping_sub(hundreds.wrapping_mul(100)) << 16);
    let tens = (pairs.wrapping_mul(103) >> 10) & 0x000f_000f;
    (tens | (pairs.wrapping_sub(tens.wrapping_mul(10)) << 8)) | 0x3030_3030
}

/// Writes numbers below 10⁸, as many at once as there is room for.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn write_eights(numbers: &[u32], digits: &mut [[u8; 8]]) {
    for (n, digits) in numbers.iter().zip(&mut *digits) {
        // 109951163/2⁴⁰ is above 10⁻⁴ by less than 10⁻¹²: the quotients of such numbers are these.
        let n = u64::from(*n);
        let upper = n.wrapping_mul(109_951_163) >> 40;
        let lower = n.wrapping_sub(upper.wrapping_mul(10_000));
        *digits = (upper | (lower << 32)).to_le_bytes();
    }
    for digits in digits.as_flattened_mut().as_chunks_mut().0 {
        *digits = four(u32::from_le_bytes(*digits)).to_le_bytes();
    }
}

#[cfg(test)]
mod tests {
    use passivity_core::BigRational;
    use proptest::prelude::*;

    use super::*;

    fn written(n: i128) -> Option<String> {
        let mut out = b"before,".to_vec();
        let [fraction] = Fraction::all(&[n]);
        let is_written = fraction.write(&mut out).is_some();
        let text = String::from_utf8(out).unwrap();
        let own = text.strip_prefix("before,").unwrap();
        assert_eq!(is_written, !own.is_empty());
        is_written.then(|| own.to_owned())
    }

    fn by_big_numbers(n: i128) -> String {
        BigRational::new(n.into(), (1_i128 << BITS).into()).to_string()
    }

    #[test]
    fn every_power_is_written_and_what_is_next_to_it() {
        let tens = (0..31).map(|k| 10_i128.pow(k));
        let twos = (0..=102).map(|k| 1_i128 << k);
        for n in tens.chain(twos).flat_map(|n| [n - 1, n, n + 1]) {
            for n in [n, -n] {
                let fits = n.unsigned_abs() < MOST;
                assert_eq!(written(n), fits.then(|| by_big_numbers(n)), "{n}");
            }
        }
    }

    #[test]
    fn all_groups_of_four_digits_are_written_before_and_behind_others() {
        for n in 0..10_000 {
            for n in [n * 10_000, n * 10_000 + 9_999, n, 99_990_000 + n] {
                let mut digits = [[0; 8]];
                write_eights(&[n], &mut digits);
                let text = format!("{n:08}");
                assert_eq!(digits[0].as_slice(), text.as_bytes());
            }
        }
    }

    proptest! {
        #[test]
        fn a_number_is_written_as_big_numbers_are(n in any::<i128>(), shift in 0..128_u32, zeros in 0..80_u32) {
            let n = n >> shift >> zeros << zeros;
            let fits = n.unsigned_abs() < MOST;
            prop_assert_eq!(written(n), fits.then(|| by_big_numbers(n)));
        }
    }
}
