//! Pseudo-random numbers of a seed, the same on every machine and in every version, so that what is
//! recorded of them stays what it is. For tests, fuzzing and comparisons; no product draws them.

/// How many inputs a test draws: its usual number, times what the environment variable `PASSIVITY_TIMES` says.
///
/// # Panics
///
/// When the variable is no whole number above zero, or the product is beyond 32 bits.
#[must_use]
pub fn draws(usual: u32) -> u32 {
    let times = std::env::var("PASSIVITY_TIMES").map_or(1, |times| match times.parse() {
        Ok(times) if times > 0 => times,
        _ => panic!("PASSIVITY_TIMES is {times:?}: expected a whole number above zero"),
    });
    let draws: Option<u32> = usual.checked_mul(times);
    draws.unwrap_or_else(|| panic!("PASSIVITY_TIMES: {times} times {usual} inputs are too many"))
}

/// A generator of pseudo-random numbers (Steele, Lea and Flood's SplitMix64).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// A generator from a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 bits.
    pub const fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in [lo, hi).
    #[allow(clippy::cast_precision_loss)] // 53 bits are a double
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        let share = (self.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        lo + share * (hi - lo)
    }

    /// A number in [lo, hi), its logarithm spread evenly.
    pub fn over_decades(&mut self, lo: f64, hi: f64) -> f64 {
        self.between(lo.ln(), hi.ln()).exp()
    }

    /// A whole number below `n`, and 0 when there is none.
    pub const fn below(&mut self, n: u64) -> u64 {
        self.bits() % if n == 0 { 1 } else { n }
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    /// What other implementations of SplitMix64 give for the seed 1234567.
    #[test]
    fn the_numbers_are_those_of_splitmix64() {
        let mut random = Random::new(1_234_567);
        let drawn = [random.bits(), random.bits(), random.bits()];
        let published = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
        ];
        assert_eq!(drawn, published);
    }
}
