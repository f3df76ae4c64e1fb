//! The cells of a grid: each value of an axis reaches half-way to its neighbours.

use std::ops::Range;

use crate::sweep::Range as Values;

/// A value of an axis, and the edges half-way to its neighbours.
pub(super) struct Cell {
    /// Which of the grid's values it is.
    pub(super) index: usize,
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Cell {
    pub(super) const fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }
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
    let cells = with_edges.map(|((index, _), (low, high))| Cell {
        index: *index,
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
