//! Random numbers for mutations.

/// Random numbers from a seed: the same mutations everywhere.
pub struct Random(passivity_random::Random);

impl Random {
    /// Numbers that the seed decides.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(passivity_random::Random::new(seed))
    }

    /// A number below `n`, and 0 when there is none.
    ///
    /// # Panics
    ///
    /// Never: what is below a `usize` is one.
    pub fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.0.below(n as u64)).expect("below a usize")
    }

    /// One of several things.
    ///
    /// # Panics
    ///
    /// When there is none.
    pub fn pick<'a, T: ?Sized>(&mut self, from: &[&'a T]) -> &'a T {
        from[self.below(from.len())]
    }
}
