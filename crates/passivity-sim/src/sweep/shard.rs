//! Pieces of a grid that are simulated apart from each other, on as many machines as there are.

use std::ops::Range;

use crate::error::SimError;

/// One or several of a number of pieces, as even as they can be, into which the points of a grid are cut in
/// order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// The first of them, from 1.
    first: usize,
    /// The last of them.
    last: usize,
    /// Of how many.
    count: usize,
}

impl Shard {
    /// The whole grid.
    pub const WHOLE: Self = Self {
        first: 1,
        last: 1,
        count: 1,
    };

    /// The piece `index`, from 1, of `count`.
    ///
    /// # Errors
    ///
    /// An index that is not one of 1 to `count`.
    pub fn new(index: usize, count: usize) -> Result<Self, SimError> {
        Self::run(index, index, count)
    }

    /// The pieces `first` to `last`, from 1, of `count`.
    ///
    /// # Errors
    ///
    /// Numbers that are not some of 1 to `count`, in order.
    pub fn run(first: usize, last: usize, count: usize) -> Result<Self, SimError> {
        let shard = Self { first, last, count };
        if first == 0 || first > last || last > count {
            let expected = match count {
                1 => "1/1, the only piece".to_owned(),
                _ => format!(
                    "a piece from 1/{count} to {count}/{count}, or several in order, as in 1-2/{count}"
                ),
            };
            return Err(SimError::Method(format!(
                "shard `{shard}`: expected {expected}"
            )));
        }
        Ok(shard)
    }

    /// Reads `3/8`, the third of eight, or `3-5/8`, the third to the fifth.
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
    /// assert_eq!(Shard::parse("2-3/3").unwrap().range(10), 4..10);
    /// assert!(Shard::parse("4/3").is_err());
    /// ```
    pub fn parse(text: &str) -> Result<Self, SimError> {
        let number = |part: &str| part.trim().parse::<usize>().ok();
        let parts = text.split_once('/').and_then(|(pieces, count)| {
            let (first, last) = pieces.split_once('-').unwrap_or((pieces, pieces));
            let count = number(count).filter(|count| *count > 0)?;
            Some((number(first)?, number(last)?, count))
        });
        match parts {
            Some((first, last, count)) => Self::run(first, last, count),
            None => Err(SimError::Method(format!(
                "shard `{text}`: expected whole numbers, as in 3/8 for the third of eight pieces, or 3-5/8"
            ))),
        }
    }

    /// The first piece, from 1.
    #[must_use]
    pub const fn first(self) -> usize {
        self.first
    }

    /// The last piece: the first one where it is but one.
    #[must_use]
    pub const fn last(self) -> usize {
        self.last
    }

    /// How many pieces the grid has.
    #[must_use]
    pub const fn count(self) -> usize {
        self.count
    }

    /// What is said of a file of this shard where another is asked for.
    pub(super) fn instead_of(self, asked: Self) -> String {
        let words = |shard: Self| match (shard == Self::WHOLE, shard.first == shard.last) {
            (true, _) => "the whole sweep".to_owned(),
            (_, true) => format!("shard {} of {}", shard.first, shard.count),
            (_, false) => format!(
                "shards {} to {} of {}",
                shard.first, shard.last, shard.count
            ),
        };
        if self == Self::WHOLE {
            let asked = words(asked);
            return format!(
                "is the whole sweep, not {asked}: leave out --shard, or give another --out"
            );
        }
        let not = match asked != Self::WHOLE && (self.first, self.last) == (asked.first, asked.last)
        {
            true => format!("of {}", asked.count),
            false => words(asked),
        };
        format!(
            "is {}, not {not}: give --shard {self}, or another --out",
            words(self)
        )
    }

    /// The indices that are its own, of `len`.
    #[must_use]
    pub const fn range(self, len: usize) -> Range<usize> {
        // `count` pieces of `even`, and one more in each of the first `rest`.
        let (even, rest) = (len / self.count, len % self.count);
        let before = self.first - 1;
        let start = before * even + if before < rest { before } else { rest };
        let end = self.last * even + if self.last < rest { self.last } else { rest };
        start..end
    }
}

impl std::fmt::Display for Shard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.first == self.last {
            true => write!(f, "{}/{}", self.first, self.count),
            false => write!(f, "{}-{}/{}", self.first, self.last, self.count),
        }
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
                for first in 1..=count {
                    for last in first..=count {
                        let run = Shard::run(first, last, count).unwrap();
                        let ends = [first, last].map(|i| Shard::new(i, count).unwrap().range(len));
                        assert_eq!(run.range(len), ends[0].start..ends[1].end);
                        assert_eq!(Shard::parse(&run.to_string()).unwrap(), run);
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_no_piece_is_refused() {
        for text in [
            "", "3", "0/3", "4/3", "1/0", "a/b", "-1/2", "2-1/3", "2-4/3", "1-2-3/3",
        ] {
            assert!(Shard::parse(text).is_err(), "{text}");
        }
    }
}
