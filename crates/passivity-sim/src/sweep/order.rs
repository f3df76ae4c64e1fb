//! The rows of a file in the order of the grid.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use crate::error::SimError;
use crate::sweep::csv;
use crate::sweep::disk::failed;
use crate::sweep::grid::Grid;
use crate::sweep::row::Row;

/// How many rows wait in memory for those before them, which ended later.
pub(super) const MOST_WAITING: usize = 1 << 20;

/// Reads the rows of a range in the order of the grid from a file of them in any order. A row that is further on
/// than can wait is read again.
pub(super) fn in_order(
    journal: &Path,
    grid: &Grid,
    range: Range<usize>,
    most_waiting: usize,
    add: &mut dyn FnMut(usize, &Row) -> Result<(), SimError>,
) -> Result<(), SimError> {
    let mut waiting = BTreeMap::new();
    let mut next = range.start;
    while next < range.end {
        let before = next;
        csv::read(journal, grid, &mut |_, (values, row)| {
            let index = grid.place(values).filter(|index| *index >= next);
            if let Some(index) = index.filter(|index| index - next < most_waiting) {
                waiting.insert(index, row);
            }
            while let Some(row) = waiting.remove(&next) {
                add(next, &row)?;
                next += 1;
            }
            Ok(())
        })?;
        if next == before {
            return Err(failed(journal, &"rows are gone that were written"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::outcome::{ExactOutcome, PaperOutcome};
    use crate::sweep::range::Range as Values;

    #[test]
    fn rows_come_in_order_however_few_may_wait() {
        let range = |text| Values::parse(text).unwrap();
        let grid = Grid::new(range("0:1:7"), range("3,1,2"), range("5:1:4")).unwrap();
        let row = |index: u16| Row {
            paper: PaperOutcome::Converged,
            exact: ExactOutcome::AtRest,
            at_interval: Some(index.into()),
            xi: f64::from(index),
            velocity: 0.0,
            within_rounding_of_edge: None,
        };
        let path = std::env::temp_dir().join(format!("passivity-order-{}.csv", std::process::id()));
        let mut text = format!("{}\n", csv::header(&grid));
        for index in (0..84).map(|i| (i * 53) % 84) {
            csv::write_row(&grid, index.into(), &row(index), &mut text);
        }
        text.push_str("torn");
        fs::write(&path, text).unwrap();
        for most in [1, 5, 100] {
            let mut found = Vec::new();
            in_order(&path, &grid, 0..84, most, &mut |index, found_row| {
                assert_eq!(*found_row, row(u16::try_from(index).unwrap()));
                found.push(index);
                Ok(())
            })
            .unwrap();
            assert_eq!(found, (0..84).collect::<Vec<_>>(), "{most}");
        }
        let lost = in_order(&path, &grid, 0..85, 5, &mut |_, _| Ok(())).unwrap_err();
        assert!(lost.to_string().contains("rows are gone"), "{lost}");
        fs::remove_file(path).unwrap();
    }
}
