//! Multiples of 2⁻⁶⁴ as fractions in decimal digits, several at a time: an audit may write a thousand million of them.

use super::line::{EIGHT, EIGHT_ZEROS, HALF, Line, SIXTEEN, four, fours};
use crate::span::BITS;

/// As many fractions are made at a time.
pub(crate) const SEVERAL: usize = 16;

/// As many characters are copied at a time.
const WIDTH: usize = 32;

/// Multiples of 2⁻⁶⁴ below 2³⁷ in lowest terms, as they are written.
#[derive(Clone, Debug)]
pub(crate) struct Fractions {
    /// The characters of the numerators, with zeros before them; behind the last one there is room to copy from.
    digits: [[[u8; 8]; 4]; SEVERAL + 1],
    /// How many characters come before those: a comma, and the sign of negative ones.
    before: [u64; SEVERAL],
    /// The logarithms of the denominators.
    denominators: [u64; SEVERAL],
}

impl Fractions {
    pub(crate) const ZERO: Self = Self {
        digits: [[[b'0'; 8]; 4]; SEVERAL + 1],
        before: [1; SEVERAL],
        denominators: [0; SEVERAL],
    };

    /// Takes numbers that are so many times 1, 2⁻³² and 2⁻⁶⁴, and that many radii of 2⁻⁶⁴ off.
    ///
    /// Without a branch, so that processors make several fractions with each instruction: to be inlined where these
    /// are chosen.
    #[inline(always)]
    pub(crate) fn take(
        &mut self,
        [wholes, uppers, lowers, radii]: [&[i64; SEVERAL]; 4],
        radius: i64,
    ) {
        let mut eights = [[0; SEVERAL]; 4];
        let [a, b, c, d] = &mut eights;
        let layers = wholes.iter().zip(uppers).zip(lowers).zip(radii);
        let results = self.before.iter_mut().zip(&mut self.denominators);
        let results = results.zip(a).zip(b).zip(c).zip(d);
        for ((((whole, upper), lower), off), (((((before, denominator), a), b), c), d)) in
            layers.zip(results)
        {
            let lower = lower.wrapping_add(radius.wrapping_mul(*off));
            let (sign, twos, number) = in_lowest_terms([*whole, *upper, lower]);
            *before = 1_u64.wrapping_sub(sign);
            *denominator = u64::from(BITS).wrapping_sub(twos);
            [*a, *b, *c, *d] = in_eights(number);
        }
        let [a, b, c, d] = &eights;
        let eights = a.iter().zip(b).zip(c).zip(d);
        for ((((a, b), c), d), digits) in eights.zip(&mut self.digits) {
            *digits = [a, b, c, d].map(|n| fours(*n).to_le_bytes());
        }
        let digits = self.digits.as_flattened_mut().as_flattened_mut();
        for digits in digits.as_chunks_mut().0 {
            *digits = four(u32::from_le_bytes(*digits)).to_le_bytes();
        }
    }
}

/// One of several.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fraction<'a>(pub(crate) &'a Fractions, pub(crate) usize);

impl Fraction<'_> {
    /// Appends the fraction after a comma: `,3/8`, `,-2`, `,0`; `None` where there is no room.
    #[inline(always)]
    pub(crate) fn write(self, line: &mut Line<'_>) -> Option<()> {
        /// Room for a comma, a sign and a numerator, and for what is copied behind them.
        const ROOM: usize = 2 + 2 * WIDTH;
        const Z: u64 = EIGHT_ZEROS;
        let Self(all, i) = self;
        let text: &mut [u8; ROOM] = line.text.get_mut(line.length..)?.first_chunk_mut()?;
        *text.first_chunk_mut()? = *b",-";
        // Zeros on the left are left out, but for the last one of zero.
        let [a, b, c, d] = all.digits.get(i)?.map(u64::from_le_bytes);
        let zeros = match [a, b, c, d] {
            [Z, Z, Z, Z] => WIDTH - 1,
            [Z, Z, ..] => 16 + leading(c, d),
            _ => leading(a, b),
        };
        // That it is no more than this the compiler does not know.
        let at = usize::try_from(*all.before.get(i)?).ok()? & 3;
        let digits = all.digits.as_flattened().as_flattened();
        let start = i.wrapping_mul(WIDTH).wrapping_add(zeros);
        *text.get_mut(at..)?.first_chunk_mut()? = *digits.get(start..)?.first_chunk::<WIDTH>()?;
        let at = at + (WIDTH - (zeros & (WIDTH - 1)));
        line.length = line.length.wrapping_add(at);
        line.append_over_power(*all.denominators.get(i)?)
    }
}

/// How many zeros there are before the first of sixteen characters that is none.
#[inline(always)]
const fn leading(upper: u64, lower: u64) -> usize {
    let zeros = match upper {
        EIGHT_ZEROS => u64::BITS + (lower ^ EIGHT_ZEROS).trailing_zeros(),
        _ => (upper ^ EIGHT_ZEROS).trailing_zeros(),
    };
    (zeros / 8) as usize
}

/// Two to 32.
const UPPER: f64 = (1_u64 << 32) as f64;

/// From here to the next power of two doubles are whole numbers, and their lower bits what they are more than this.
const WHOLE: f64 = (1_u64 << 52) as f64;

/// A number below 2⁵² as a double.
#[inline(always)]
fn double(n: u64) -> f64 {
    f64::from_bits(n | WHOLE.to_bits()) - WHOLE
}

/// The whole number that is nearest to a double below 2⁵¹.
#[inline(always)]
fn nearest(x: f64) -> u64 {
    (x + WHOLE).to_bits() ^ WHOLE.to_bits()
}

/// A quotient that may be one too large, and a rest that is then below zero, as they are.
#[inline(always)]
fn corrected(quotient: u64, rest: u64, divisor: u64) -> [u64; 2] {
    let less = (rest.cast_signed() >> (u64::BITS - 1)).cast_unsigned();
    [
        quotient.wrapping_add(less),
        rest.wrapping_add(less & divisor),
    ]
}

/// The sign of a number that is so many times 1, 2⁻³² and 2⁻⁶⁴, as 64 bits of one or of zero, the logarithm of what it
/// has in common with 2⁶⁴, and its magnitude divided by that as two words, the lower one first.
#[inline(always)]
fn in_lowest_terms([whole, upper, lower]: [i64; 3]) -> (u64, u64, [u64; 2]) {
    let upper = upper.wrapping_add(lower >> 32);
    let high = whole.wrapping_add(upper >> 32);
    let low = (upper.cast_unsigned() << 32) | (lower.cast_unsigned() & HALF);
    let sign = (high >> (u64::BITS - 1)).cast_unsigned();
    let low = (low ^ sign).wrapping_sub(sign);
    let carry = if low == 0 { sign } else { 0 };
    let high = (high.cast_unsigned() ^ sign).wrapping_sub(carry);
    let twos = u64::from(low.trailing_zeros());
    // All 64 are in common where only the upper word is left.
    let [low, high] = if low == 0 { [high, 0] } else { [low, high] };
    let shift = twos & 63;
    let low = (low >> shift) | ((high << 1) << (63 ^ shift));
    (sign, twos, [low, high >> shift])
}

/// A number below 2¹⁰¹ in base 10⁸: quotients are those of doubles, which are off by so little that the nearest whole
/// number is the quotient or one more.
#[inline(always)]
pub(super) fn in_eights([low, high]: [u64; 2]) -> [u64; 4] {
    const SHORT: f64 = 1.0 / EIGHT as f64;
    const OF_HIGH: f64 = UPPER * UPPER / SIXTEEN as f64;
    const OF_LOW: f64 = UPPER / SIXTEEN as f64;
    let quotient = nearest(double(high) * OF_HIGH + double(low >> 32) * OF_LOW);
    let rest = low.wrapping_sub(quotient.wrapping_mul(SIXTEEN));
    let [upper, lower] = corrected(quotient, rest, SIXTEEN);
    // Below 2⁴⁸ and below 2⁵⁴.
    let a = nearest(double(upper) * SHORT);
    let c = nearest(double(lower >> 32) * (UPPER * SHORT) + double(lower & HALF) * SHORT);
    let [[a, b], [c, d]] = [(a, upper), (c, lower)].map(|(quotient, n)| {
        let rest = n.wrapping_sub((quotient & HALF).wrapping_mul(EIGHT));
        corrected(quotient, rest, EIGHT)
    });
    [a, b, c, d]
}

#[cfg(test)]
mod tests {
    use passivity_core::BigRational;
    use proptest::prelude::*;

    use super::*;

    /// What is written of numbers, and read from layers that overlap by so much.
    fn written(numbers: &[i128; SEVERAL], overlap: i64, off: i64, radius: i64) -> Vec<String> {
        let mut layers = [[0; SEVERAL]; 4];
        for (i, n) in numbers.iter().enumerate() {
            let n = n - i128::from(off * radius);
            let lower = i64::try_from(n & i128::from(HALF)).unwrap() + (overlap << 32);
            let n = (n >> 32) - i128::from(overlap);
            let upper = i64::try_from(n & i128::from(HALF)).unwrap();
            let whole = i64::try_from(n >> 32).unwrap();
            for (column, layer) in layers.iter_mut().zip([whole, upper, lower, off]) {
                column[i] = layer;
            }
        }
        let mut fractions = Fractions::ZERO;
        fractions.take(layers.each_ref(), radius);
        let mut room = [0; Line::ROOM];
        let all = (0..SEVERAL).map(|i| {
            let mut line = Line::new(&mut room, 0);
            line.append(b"before,").unwrap();
            Fraction(&fractions, i).write(&mut line).unwrap();
            let text = str::from_utf8(line.text()).unwrap();
            text.strip_prefix("before,,").unwrap().to_owned()
        });
        all.collect()
    }

    fn by_big_numbers(n: i128) -> String {
        BigRational::new(n.into(), (1_i128 << BITS).into()).to_string()
    }

    #[test]
    fn every_power_is_written_and_what_is_next_to_it() {
        let tens = (0..31).map(|k| 10_i128.pow(k));
        let sixteens = (1..2000).map(|k| (k * 10_i128.pow(16)) << (k % 35));
        let twos = (0..=100).map(|k| 1_i128 << k);
        for n in tens.chain(twos).chain(sixteens) {
            let mut numbers = [0; SEVERAL];
            for (slot, n) in numbers.iter_mut().zip([n - 1, n, n + 1, 3 * n, 7 * n]) {
                *slot = if n < 1 << 101 { n } else { n >> 4 };
            }
            for numbers in [numbers, numbers.map(|n| -n)] {
                let expected = numbers.map(by_big_numbers);
                assert_eq!(written(&numbers, 0, 0, 1), expected, "{n}");
            }
        }
    }

    #[test]
    fn a_line_takes_no_more_than_it_has_room_for() {
        let mut room = [b' '; Line::ROOM];
        let mut line = Line::new(&mut room, Line::ROOM - 3);
        assert!(line.append(b"true").is_none());
        assert!(Fraction(&Fractions::ZERO, 0).write(&mut line).is_none());
        assert_eq!(line.len(), Line::ROOM - 3);
        assert!(line.append(b"yes").is_some());
        assert_eq!(line.text().trim_ascii(), b"yes");
        assert!(line.append(b",").is_none());
    }

    fn number() -> impl Strategy<Value = i128> {
        let parts = (any::<i128>(), 27..128_u32, 0..80_u32);
        parts.prop_map(|(n, shift, zeros)| n >> shift >> zeros << zeros)
    }

    proptest! {
        #[test]
        fn numbers_are_written_as_big_numbers_are(
            numbers in prop::array::uniform16(number()),
            overlap in -1000..1000_i64,
            off in 0..1_i64 << 50,
            radius in prop_oneof![Just(-1_i64), Just(1)],
        ) {
            let expected = numbers.map(by_big_numbers);
            prop_assert_eq!(written(&numbers, overlap, off, radius), expected);
        }
    }
}
