//! Decimal digits of whole numbers, eight or sixteen at a time, and the line that they are written to.

use ethnum::U256;

use super::digits::in_eights;

/// The lower half of 64 bits.
pub(super) const HALF: u64 = (1 << 32) - 1;

/// Sixteen times the character of zero.
const ZEROS: u128 = u128::from_ne_bytes([b'0'; 16]);

/// Eight times the same.
pub(super) const EIGHT_ZEROS: u64 = u64::from_ne_bytes([b'0'; 8]);

pub(super) const EIGHT: u64 = 10_u64.pow(8);

pub(super) const SIXTEEN: u64 = 10_u64.pow(16);

/// As many characters of a denominator are copied at a time.
const WIDTH: usize = 64;

/// "/2", "/4" and so on up to "/170141183460469231731687303715884105728" by their logarithm, nothing for one; and behind each
/// how long it is.
static OVER_POWERS: [[u8; WIDTH]; u128::BITS as usize] = over_powers();

#[expect(
    clippy::indexing_slicing,
    reason = "the compiler, which computes this, refuses an index that is out of bounds"
)]
const fn over_powers() -> [[u8; WIDTH]; u128::BITS as usize] {
    let mut all = [[0; WIDTH]; u128::BITS as usize];
    let mut k = 1;
    while k < all.len() {
        let text = &mut all[k];
        text[0] = b'/';
        let mut rest = 1_u128 << k;
        let mut place = 2 + rest.ilog10() as usize;
        text[WIDTH - 1] = place as u8;
        while rest > 0 {
            place -= 1;
            text[place] = b'0' + (rest % 10) as u8;
            rest /= 10;
        }
        k += 1;
    }
    all
}

/// Room for what is written of a row, and where it ends.
#[derive(Debug)]
pub(crate) struct Line<'a> {
    pub(super) text: &'a mut [u8; Line::ROOM],
    pub(super) length: usize,
}

impl<'a> Line<'a> {
    /// No row is as long.
    pub(crate) const ROOM: usize = 2048;

    /// A line that has so many characters already.
    #[inline(always)]
    pub(crate) const fn new(text: &'a mut [u8; Line::ROOM], length: usize) -> Self {
        Self { text, length }
    }

    /// How long it is.
    #[inline(always)]
    pub(crate) const fn len(&self) -> usize {
        self.length
    }

    /// Takes back what is written behind so many characters.
    pub(crate) const fn truncate(&mut self, length: usize) {
        self.length = length;
    }

    /// What is written.
    #[inline(always)]
    pub(crate) fn text(&self) -> &[u8] {
        self.text.get(..self.length).unwrap_or_default()
    }

    /// Appends some characters; `None`, and nothing, where there is no room.
    #[inline(always)]
    pub(crate) fn append(&mut self, text: &[u8]) -> Option<()> {
        let end = self.length.wrapping_add(text.len());
        self.text.get_mut(self.length..end)?.copy_from_slice(text);
        self.length = end;
        Some(())
    }

    /// Appends what stands behind a numerator whose denominator is this power of two, below 2¹²⁸; `None` where there is no
    /// room.
    #[inline(always)]
    pub(crate) fn append_over_power(&mut self, logarithm: u64) -> Option<()> {
        let text = OVER_POWERS.get(usize::try_from(logarithm).ok()?)?;
        let [.., length] = *text;
        self.append_some(*text, length.into())
    }

    /// Appends a whole number.
    #[inline]
    pub(crate) fn append_whole(&mut self, n: u64) -> Option<()> {
        if n < EIGHT {
            let digits = eight(n);
            // Zeros on the left are shifted out, but for the last one of zero.
            let zeros = ((digits ^ EIGHT_ZEROS).trailing_zeros() / 8).min(7);
            return self.append_some((digits >> (8 * zeros)).to_le_bytes(), 8 - zeros);
        }
        if n >= SIXTEEN {
            self.append_whole(n / SIXTEEN)?;
            return self.append_some(sixteen(n % SIXTEEN).to_le_bytes(), 16);
        }
        let digits = sixteen(n);
        let zeros = (digits ^ ZEROS).trailing_zeros() / 8;
        self.append_some((digits >> (8 * zeros)).to_le_bytes(), 16 - zeros)
    }

    /// Appends the first of some characters, of which there is room for all.
    #[inline(always)]
    pub(crate) fn append_some<const N: usize>(&mut self, text: [u8; N], first: u32) -> Option<()> {
        *self.text.get_mut(self.length..)?.first_chunk_mut()? = text;
        self.length = self.length.wrapping_add(first as usize);
        Some(())
    }

    /// Appends a whole number that may be longer than the machine's word.
    #[inline]
    pub(crate) fn append_wide(&mut self, n: u128) -> Option<()> {
        let [low, high] = [n, n >> u64::BITS].map(|half| half as u64);
        if high == 0 && low < SIXTEEN {
            return self.append_whole(low);
        }
        if high >= 1 << 37 {
            let upper = n / u128::from(SIXTEEN);
            let lower = n.wrapping_sub(upper.wrapping_mul(SIXTEEN.into()));
            self.append_wide(upper)?;
            return self.append_some(sixteen(lower as u64).to_le_bytes(), 16);
        }
        let [a, b, lower @ ..] = in_eights([low, high]);
        self.append_whole(a.wrapping_mul(EIGHT).wrapping_add(b))?;
        let [c, d] = lower.map(|n| u128::from(eight(n)));
        self.append_some((c | d << u64::BITS).to_le_bytes(), 16)
    }

    /// The same of one that is longer still.
    pub(crate) fn append_widest(&mut self, n: U256) -> Option<()> {
        let (0, n) = n.into_words() else {
            let sixteen_digits = U256::from(SIXTEEN);
            let upper = n / sixteen_digits;
            let lower = n.wrapping_sub(upper.wrapping_mul(sixteen_digits));
            self.append_widest(upper)?;
            return self.append_some(sixteen(lower.as_u64()).to_le_bytes(), 16);
        };
        self.append_wide(n)
    }
}

/// The characters of a number below 10¹⁶, with zeros before it.
#[inline(always)]
fn sixteen(n: u64) -> u128 {
    u128::from(eight(n / EIGHT)) | u128::from(eight(n % EIGHT)) << u64::BITS
}

/// The characters of a number below 10⁸, with zeros before it.
#[inline(always)]
fn eight(n: u64) -> u64 {
    // As in `four`, of both at once.
    let fours = fours(n);
    let hundreds = (fours.wrapping_mul(5243) >> 19) & 0x0000_007f_0000_007f;
    let pairs = (fours << 16).wrapping_sub(hundreds.wrapping_mul((100 << 16) - 1));
    let tens = (pairs.wrapping_mul(103) >> 10) & 0x000f_000f_000f_000f;
    (pairs << 8).wrapping_sub(tens.wrapping_mul((10 << 8) - 1)) | EIGHT_ZEROS
}

/// A number below 10⁸ as two of four digits, each in half of the bits.
#[inline(always)]
pub(super) const fn fours(n: u64) -> u64 {
    // 109951163/2⁴⁰ is above 10⁻⁴ by less than 10⁻¹²: the quotients of such numbers are these.
    let upper = (n & HALF).wrapping_mul(109_951_163) >> 40;
    let lower = n.wrapping_sub(upper.wrapping_mul(10_000));
    upper | (lower << 32)
}

/// The characters of a number below 10⁴: pairs of digits, then digits.
#[inline(always)]
pub(super) const fn four(n: u32) -> u32 {
    // 5243/2¹⁹ is so little above 1/100, and 103/2¹⁰ above 1/10, that the quotients of such numbers are these.
    let hundreds = n.wrapping_mul(5243) >> 19;
    // What is left of n goes 16 bits further up, and of each pair 8.
    let pairs = (n << 16).wrapping_sub(hundreds.wrapping_mul((100 << 16) - 1));
    let tens = (pairs.wrapping_mul(103) >> 10) & 0x000f_000f;
    (pairs << 8).wrapping_sub(tens.wrapping_mul((10 << 8) - 1)) | 0x3030_3030
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_groups_of_four_digits_are_written_before_and_behind_others() {
        for n in 0..10_000 {
            for n in [n * 10_000, n * 10_000 + 9_999, n, 99_990_000 + n] {
                let fours = fours(n).to_le_bytes();
                let digits = fours
                    .as_chunks()
                    .0
                    .iter()
                    .flat_map(|digits| four(u32::from_le_bytes(*digits)).to_le_bytes());
                assert_eq!(digits.collect::<Vec<_>>(), format!("{n:08}").as_bytes());
                assert_eq!(eight(n).to_le_bytes(), format!("{n:08}").as_bytes());
            }
        }
    }

    #[test]
    fn whole_numbers_are_written_as_they_are() {
        let tens = (0..20).map(|k| 10_u64.pow(k));
        let twos = (0..64).map(|k| 1 << k);
        for n in tens
            .chain(twos)
            .flat_map(|n: u64| [n - 1, n, n.saturating_mul(7)])
        {
            let mut room = [0; Line::ROOM];
            let mut line = Line::new(&mut room, 0);
            line.append_whole(n).unwrap();
            line.append(b",").unwrap();
            assert_eq!(line.text(), format!("{n},").as_bytes());
            for n in [
                u128::from(n) << 64,
                u128::MAX - u128::from(n),
                u128::from(n) * 10_u128.pow(19),
            ] {
                let mut line = Line::new(&mut room, 0);
                line.append_wide(n).unwrap();
                assert_eq!(line.text(), n.to_string().as_bytes());
            }
        }
    }
}
