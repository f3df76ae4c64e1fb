//! The rows that a file has when a sweep is taken up: none is kept, but for a few that are simulated again.

use std::ops::Range;
use std::path::Path;

use passivity_scene::Point;

use crate::error::SimError;
use crate::plan::Plan;
use crate::run;
use crate::sweep::form::Form;
use crate::sweep::grid::Grid;
use crate::sweep::row::{Found, Row};

/// What was read of a file.
pub(super) struct Taken<'t> {
    form: Form,
    path: &'t Path,
    grid: &'t Grid,
    /// The points whose rows the file has.
    range: &'t Range<usize>,
    see: &'t mut dyn FnMut(usize, &Row),
    /// Which of them have their rows.
    pub(super) done: Vec<bool>,
    pub(super) sample: Sample,
}

impl<'t> Taken<'t> {
    pub(super) fn new(
        form: Form,
        path: &'t Path,
        grid: &'t Grid,
        range: &'t Range<usize>,
        see: &'t mut dyn FnMut(usize, &Row),
    ) -> Self {
        Self {
            form,
            path,
            grid,
            range,
            see,
            done: vec![false; range.len()],
            sample: Sample::default(),
        }
    }

    /// Takes a row, with its number from 0.
    pub(super) fn take(&mut self, number: usize, (values, row): Found) -> Result<(), SimError> {
        let wrong = |what| Err(self.form.at(self.path, number, what));
        let index = self.grid.place(values).unwrap_or(usize::MAX);
        let done = index.checked_sub(self.range.start);
        match done.and_then(|at| self.done.get_mut(at)) {
            None => return wrong("a point that is not in these ranges"),
            Some(true) => return wrong("a point that was there before"),
            Some(done) => *done = true,
        }
        self.sample.take(index, row);
        (self.see)(index, &row);
        Ok(())
    }
}

/// A few rows, evenly out of all that pass: of those that ended, and of those that ran to their end, which tell of the
/// number of intervals too.
#[derive(Default)]
pub(super) struct Sample([Few; 2]);

impl Sample {
    fn take(&mut self, index: usize, row: Row) {
        let [ended, ran] = &mut self.0;
        match row.at_interval {
            Some(_) => ended.take(index, row),
            None => ran.take(index, row),
        }
    }

    /// Whether the rows come out the same, to the last bit, when they are simulated again.
    pub(super) fn is_of(&self, scene: &Point, grid: &Grid) -> Result<bool, SimError> {
        for (index, row) in self.0.iter().flat_map(|few| &few.rows) {
            let plan = Plan::compile(&grid.point(scene, *index))?;
            if Row::of(&run::outcome(&plan)).as_in_file() != *row {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// One of so many of the rows that pass, and at most [`Few::MOST`].
#[derive(Default)]
struct Few {
    rows: Vec<(usize, Row)>,
    passed: usize,
    /// The logarithm of how many pass for one that is kept, to base 2.
    between: u32,
}

impl Few {
    const MOST: usize = 8;

    fn take(&mut self, index: usize, row: Row) {
        if self.rows.len() == Self::MOST {
            let mut keep = false;
            self.rows.retain(|_| {
                keep = !keep;
                keep
            });
            self.between += 1;
        }
        if self.passed.is_multiple_of(1 << self.between) {
            self.rows.push((index, row));
        }
        self.passed += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{ExactOutcome, PaperOutcome};

    #[test]
    fn few_rows_are_kept_of_many_and_evenly() {
        let row = Row {
            paper: PaperOutcome::Converged,
            exact: ExactOutcome::AtRest,
            at_interval: Some(1),
            xi: 0.0,
            velocity: 0.0,
            within_rounding_of_edge: None,
        };
        for count in [0, 1, 8, 9, 100, 12_345] {
            let mut few = Few::default();
            (0..count).for_each(|index| few.take(index, row));
            let kept: Vec<usize> = few.rows.iter().map(|(index, _)| *index).collect();
            let expected: Vec<usize> = (0..count).step_by(1 << few.between).collect();
            assert_eq!(kept, expected);
            assert!(
                kept.len() >= count.min(4) && kept.len() <= Few::MOST,
                "{kept:?}"
            );
        }
    }
}
