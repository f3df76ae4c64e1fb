//! The cells of a grid: each value of an axis reaches half-way to its neighbours.

use std::ops::Range;

use crate::sweep::Range as Values;

/// A value of an axis, and the edges half-way to its neighbours.
pub(super) struct Cell {
    /// Which of the grid's values it is.
    pub(super) index: usize,
    /// The value, which is not in the middle where the values are not even.
    pub(super) at: f64,
    pub(super) low: f64,
    pub(super) high: f64,
}

/// The cells of an axis, the least value first.
pub(super) fn cells(values: &Values) -> Vec<Cell> {
    let mut sorted: Vec<(usize, f64)> = values.doubles().enumerate().collect();
    sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
    let edges: Vec<f64> = sorted
        .iter()
        .zip(sorted.iter().skip(1))
        .map(|((_, a), (_, b))| 0.5 * (a + b))
        .collect();
    // The outermost cells are as wide as their inner half.
    let outer = |value: Option<&(usize, f64)>, edge: Option<&f64>| {
        value.map(|(_, x)| edge.map_or(*x, |edge| x + (x - edge)))
    };
    let least = outer(sorted.first(), edges.first());
    let most = outer(sorted.last(), edges.last());
    let lows = least.into_iter().chain(edges.iter().copied());
    let highs = edges.iter().copied().chain(most);
    let with_edges = sorted.iter().zip(lows.zip(highs));
    let cells = with_edges.map(|((index, at), (low, high))| Cell {
        index: *index,
        at: *at,
        low,
        high,
    });
    // A single value has no neighbours: its cell is all that is shown.
    let widened = |cell: Cell| match cell.high > cell.low {
        true => cell,
        false => Cell {
            low: cell.low - 0.5,
            high: cell.high + 0.5,
            ..cell
        },
    };
    cells.map(widened).collect()
}

/// What the cells of an axis span.
pub(super) fn span(cells: &[Cell]) -> Range<f64> {
    let low = cells.first().map_or(0.0, |cell| cell.low);
    let high = cells.last().map_or(1.0, |cell| cell.high);
    low..high
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_at_its_value_wherever_that_is_in_its_cell() {
        let values = Values::parse("0,0.1,0.9,0.2,1e6").unwrap();
        let cells = cells(&values);
        let found: Vec<f64> = cells.iter().map(|cell| cell.at).collect();
        assert_eq!(found, [0.0, 0.1, 0.2, 0.9, 1e6]);
        assert!(
            cells
                .iter()
                .all(|cell| cell.low < cell.at && cell.at < cell.high)
        );
        assert_eq!(
            cells.iter().map(|cell| cell.index).collect::<Vec<_>>(),
            [0, 1, 3, 2, 4]
        );
    }
}
