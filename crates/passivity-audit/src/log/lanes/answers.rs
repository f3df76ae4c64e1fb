//! What rows answer, and what rows of counts come to under the force of the wall beside that in the log.

use std::ops::Range;

use multiversion::multiversion;

use super::truths;
use crate::ledger::Truths;

/// What some rows answer: the first of them, counted from zero, and how many.
pub(crate) type Answer = (Truths, usize, usize);

/// What consecutive rows of counts come to under the force of the wall, where the account is of the forces in the log.
#[derive(Debug)]
pub(crate) struct ByLaw {
    /// The first of them, and how many there are.
    pub(crate) at: usize,
    pub(crate) len: usize,
    /// As [`Sums::sums`](super::Sums::sums).
    pub(crate) sums: [[i128; 2]; 5],
    /// Which of [the answers of all](ManyByLaw::answers) are theirs.
    answers: Range<usize>,
}

/// The same of several.
#[derive(Debug, Default)]
pub(crate) struct ManyByLaw {
    all: Vec<ByLaw>,
    /// What their rows answer, as [`each_answer`] has it.
    answers: Vec<Answer>,
}

impl ManyByLaw {
    pub(crate) fn clear(&mut self) {
        self.all.clear();
        self.answers.clear();
    }

    /// Goes on with the rows from one on, of these sums and [covers](super::TileRows::covers).
    pub(super) fn push(&mut self, at: usize, sums: [[i128; 2]; 5], covers: &[u64]) {
        let before = self.answers.len();
        each_answer(covers, |truths, first, times| {
            self.answers.push((truths, first, times));
        });
        self.all.push(ByLaw {
            at,
            len: covers.len(),
            sums,
            answers: before..self.answers.len(),
        });
    }

    /// The first that start at a row or after it, and what they answer.
    pub(crate) fn from(&self, at: usize) -> Option<(&ByLaw, &[Answer])> {
        let first = self.all.partition_point(|rows| rows.at < at);
        let rows = self.all.get(first)?;
        Some((rows, self.answers.get(rows.answers.clone())?))
    }
}

/// Takes what some rows answer, by what each [covers](super::TileRows::covers): the first of those that answer the same, counted
/// from zero, and how many.
#[inline(always)]
pub(crate) fn each_answer(rows: &[u64], mut take: impl FnMut(Truths, usize, usize)) {
    let (mut left, mut seen) = (rows.len(), 0_u64);
    for (i, bits) in rows.iter().enumerate() {
        if seen >> bits & 1 == 0 {
            seen |= 1 << bits;
            let alike = alike(rows, *bits);
            take(truths(*bits), i, alike);
            left -= alike;
        }
        if left == 0 {
            break;
        }
    }
}

/// How many of some rows answer this.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn alike(rows: &[u64], bits: u64) -> usize {
    let mut alike = 0_u64;
    for other in rows {
        alike = alike.wrapping_add(u64::from(*other == bits));
    }
    alike as usize
}
