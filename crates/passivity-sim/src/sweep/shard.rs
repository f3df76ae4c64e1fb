//! Pieces of a grid that are simulated apart from each other, on as many machines as there are.

use std::ops::Range;

use crate::error::SimError;

/// One of a number of pieces, as even as they can be, into which the points of a grid are cut in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which one, from 1.
    index: usize,
    /// Of how many.
    count: usize,
}

impl Shard {
    /// The whole grid.
    pub const WHOLE: Self = Self { index: 1, count: 1 };

    /// The piece `index`, from 1, of `count`.
    ///
    /// # Errors
    ///
    /// An index that is not one of 1 to `count`.
    pub fn new(index: usize, count: usize) -> Result<Self, SimError> {
        if index == 0 || index > count {
            return Err(SimError::Method(format!(
                "shard `{index}/{count}`: expected a number from 1 to {count} before the stroke"
            )));
        }
        Ok(Self { index, count })
    }

    /// Reads `3/8`, the third of eight.
    ///
    /// # Errors
    ///
    /// Text that is something else.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_sim::sweep::Shard;
    ///
    /// assert_eq!(Shard::parse("2/3").unwrap().range(10), 4..7);
    /// assert!(Shard::parse("4/3").is_err());
    /// ```
    pub fn parse(text: &str) -> Result<Self, SimError> {
        let number = |part: &str| part.trim().parse::<usize>().ok();
        let parts = text.split_once('/').and_then(|(index, count)| {
            let both = number(index).zip(number(count));
            both.filter(|(_, count)| *count > 0)
        });
        match parts {
            Some((index, count)) => Self::new(index, count),
            None => Err(SimError::Method(format!(
                "shard `{text}`: expected two whole numbers, as in 3/8 for the third of eight pieces"
            ))),
        }
    }

    /// Which piece it is, from 1.
    #[must_use]
    pub const fn index(self) -> usize {
        self.index
    }

    /// How many pieces there are.
    #[must_use]
    pub const fn count(self) -> usize {
        self.count
    }

    /// The indices that are its own, of `len`.
    #[must_use]
    pub const fn range(self, len: usize) -> Range<usize> {
        // `count` pieces of `even`, and one more in each of the first `rest`.
        let (even, rest) = (len / self.count, len % self.count);
        let before = self.index - 1;
        let extra = if before < rest { before } else { rest };
        let start = before * even + extra;
        let own = even + if before < rest { 1 } else { 0 };
        start..start + own
    }
}

impl std::fmt::Display for Shard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pieces_are_the_whole() {
        for len in [0, 1, 7, 100] {
            for count in 1..=12 {
                let mut at = 0;
                for index in 1..=count {
                    let range = Shard::new(index, count).unwrap().range(len);
                    assert_eq!(range.start, at);
                    assert!(range.len().abs_diff(len / count) <= 1);
                    at = range.end;
                }
                assert_eq!(at, len);
            }
        }
    }

    #[test]
    fn what_is_no_piece_is_refused() {
        for text in ["", "3", "0/3", "4/3", "1/0", "a/b", "-1/2"] {
            assert!(Shard::parse(text).is_err(), "{text}");
        }
    }
}
