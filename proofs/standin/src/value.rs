//! The types that a harness may draw.

/// A type with values to draw: the integers and `bool`.
pub trait Arbitrary: Sized {
    /// The least and the greatest value, as numbers.
    const RANGE: (i128, i128);

    /// The value of a number within [`RANGE`](Self::RANGE).
    fn from_number(n: i128) -> Self;
}

macro_rules! integers {
    ($($int:ty),*) => {$(
        impl Arbitrary for $int {
            const RANGE: (i128, i128) = (<$int>::MIN as i128, <$int>::MAX as i128);

            #[inline]
            fn from_number(n: i128) -> Self {
                n as $int
            }
        }
    )*};
}
integers!(i8, u8, i16, u16, i32, u32, i64, u64);

impl Arbitrary for bool {
    const RANGE: (i128, i128) = (0, 1);

    #[inline]
    fn from_number(n: i128) -> Self {
        n != 0
    }
}

/// Random numbers, seeded by the harness's name so that every run draws the same.
pub(crate) struct Random(passivity_random::Random);

impl Random {
    /// Seeded by the FNV-1a hash of `name`.
    pub(crate) fn named(name: &str) -> Self {
        let seed = name.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
        });
        Self(passivity_random::Random::new(seed))
    }

    /// A number below `n`, which is above zero.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.0.below(n as u64) as usize
    }

    /// A number in `range`, more often than not near an end of it, near zero or of few bits.
    pub(crate) fn number(&mut self, (lo, hi): (i128, i128)) -> i128 {
        let near = self.below(3) as i128;
        match self.below(6) {
            0 => lo + near,
            1 => hi - near,
            2 => (near - 1).clamp(lo, hi),
            3 => lo + (i128::from(self.0.bits()) % (hi - lo + 1)),
            _ => {
                let bits = self.below(64) as u32;
                let magnitude = i128::from(self.0.bits() >> bits);
                let signed = if self.0.bits() & 1 == 0 {
                    magnitude
                } else {
                    -magnitude
                };
                if (lo..=hi).contains(&signed) {
                    signed
                } else {
                    near.clamp(lo, hi)
                }
            }
        }
    }
}
