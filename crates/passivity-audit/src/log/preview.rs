//! The first rows of a log, by which its header is judged.

use crate::log::error::shown;

/// The first rows of a log, as numbers near by.
#[derive(Clone, Debug, Default)]
pub(crate) struct Preview {
    /// The first fields of each column; `None` where a field is no number.
    pub(crate) columns: Vec<Vec<Option<f64>>>,
    /// The text of the first field of each column that is no number, where the log is of text.
    pub(crate) texts: Vec<Option<String>>,
    /// What stands between fields, where the log is of text with decimal points.
    pub(crate) delimiter: Option<char>,
    /// Which group each column is of; all are of one where it is not said.
    pub(crate) groups: Vec<usize>,
    /// The columns of durations or times of day that rise from row to row.
    pub(crate) lasting: Vec<usize>,
    /// Fields of each column in rows after them, where some column stands still in the first: whether it has counts or a
    /// unit is seen when it moves.
    pub(crate) later: Vec<Vec<Option<f64>>>,
}

impl Preview {
    /// How many rows are looked at before a header is judged, of as many as there are.
    pub(crate) const ROWS: usize = 20;

    /// The fields of some rows; `None` where a field is no number.
    pub(crate) fn of_rows(rows: &[Vec<Option<f64>>]) -> Self {
        let width = rows.iter().map(Vec::len).max().unwrap_or(0);
        let field = |row: &Vec<Option<f64>>, column| row.get(column).copied().flatten();
        let column = |column| rows.iter().map(|row| field(row, column)).collect();
        Self {
            columns: (0..width).map(column).collect(),
            ..Self::default()
        }
    }

    /// The fields of each row.
    pub(crate) fn rows(&self) -> Vec<Vec<Option<f64>>> {
        let len = self.columns.iter().map(Vec::len).max().unwrap_or(0);
        let field = |column: &Vec<Option<f64>>, row| column.get(row).copied().flatten();
        let row = |row| {
            self.columns
                .iter()
                .map(|column| field(column, row))
                .collect()
        };
        (0..len).map(row).collect()
    }

    fn column(&self, column: usize) -> impl Iterator<Item = Option<f64>> + '_ {
        self.columns.get(column).into_iter().flatten().copied()
    }

    /// The numbers of a column in the rows after them.
    fn later(&self, column: usize) -> impl Iterator<Item = f64> + '_ {
        let fields = self.later.get(column).into_iter().flatten();
        fields.copied().flatten()
    }

    /// Whether some column has one whole number in all rows.
    pub(crate) fn stands_still(&self) -> bool {
        (0..self.columns.len()).any(|column| self.is_whole(column) && !self.moves(column))
    }

    /// The first row in which a column has no number; a column that is not in the rows has none in any.
    pub(crate) fn no_number(&self, column: usize) -> Option<usize> {
        match self.columns.get(column) {
            Some(fields) => fields.iter().position(Option::is_none),
            None => (!self.columns.is_empty()).then_some(0),
        }
    }

    /// That a column has no number in a row, with what stands there, and what is to be done about it where that is known.
    pub(crate) fn without_number(&self, column: usize) -> Option<String> {
        let row = self.no_number(column)? + 1;
        let text = self.texts.get(column).and_then(Option::as_deref);
        let Some(text) = text.filter(|text| !text.is_empty()) else {
            return Some(format!("row {row} has no number there"));
        };
        let behind = text.split_once(' ').filter(|(number, unit)| {
            number.parse::<f64>().is_ok() && unit.chars().all(char::is_alphabetic)
        });
        let remedy = match behind {
            Some((_, unit)) => format!(
                ", with a unit that belongs into the name of the column: take it away, as with `sed 's/ {unit}//'`"
            ),
            None if text.starts_with('[') => ", a list: where each has one number, take the brackets away behind the first line, as \
                                              with `sed '1!s/[][]//g'`"
                .to_owned(),
            None => String::new(),
        };
        let text = shown(text.as_bytes());
        Some(format!(
            "row {row} has no number there but `{text}`{remedy}"
        ))
    }

    /// Whether there are rows, and a column has no number in any.
    pub(crate) fn has_no_numbers(&self, column: usize) -> bool {
        self.column(column).next().is_some() && self.column(column).all(|x| x.is_none())
    }

    /// Whether two columns come from the same place.
    pub(crate) fn together(&self, a: usize, b: usize) -> bool {
        self.groups.get(a) == self.groups.get(b)
    }

    pub(crate) fn is_whole(&self, column: usize) -> bool {
        self.column(column).next().is_some()
            && self
                .column(column)
                .all(|x| x.is_some_and(|x| x.fract() == 0.0))
            && self.later(column).all(|x| x.fract() == 0.0)
    }

    /// Whether all values are whole numbers from 0 on and below this.
    pub(crate) fn is_within(&self, column: usize, below: f64) -> bool {
        let mut values = self.column(column).flatten();
        self.is_whole(column) && values.all(|x| (0.0..below).contains(&x))
    }

    /// Whether a column has nothing but zeros, as the other components of a vector.
    pub(crate) fn is_zero(&self, column: usize) -> bool {
        self.column(column).all(|x| x == Some(0.0))
    }

    /// Whether a column has no more than three values, all of them whole, as a flag or a mode does.
    pub(crate) fn is_mode(&self, column: usize) -> bool {
        const MOST: usize = 3;
        let mut values = self.numbers(column);
        values.extend(self.later(column));
        values.sort_by(f64::total_cmp);
        values.dedup();
        self.is_whole(column) && values.len() <= MOST
    }

    /// Whether these rows may not be all that there are.
    pub(crate) fn may_go_on(&self) -> bool {
        self.columns.iter().any(|fields| fields.len() >= Self::ROWS)
    }

    /// Whether a column has more than one value.
    pub(crate) fn moves(&self, column: usize) -> bool {
        let first = self.column(column).next();
        self.column(column).any(|x| Some(x) != first)
            || self.later(column).any(|x| Some(Some(x)) != first)
    }

    /// The numbers of a column.
    pub(crate) fn numbers(&self, column: usize) -> Vec<f64> {
        self.column(column).flatten().collect()
    }

    /// The first row after which a column stands still, where it runs backward nowhere.
    pub(crate) fn still(&self, column: usize) -> Option<usize> {
        let values = self.numbers(column);
        let mut pairs = values.iter().zip(values.iter().skip(1));
        let row = pairs.position(|(a, b)| a == b).map(|i| i + 1);
        row.filter(|_| !self.runs_backward(column))
    }

    pub(crate) fn increases(&self, column: usize) -> bool {
        let values = self.numbers(column);
        values.iter().zip(values.iter().skip(1)).all(|(a, b)| a < b)
    }

    /// Whether a column has a number in each row, which is above the one before it, of as many rows as tell.
    pub(crate) fn rises(&self, column: usize) -> bool {
        const LEAST: usize = 8;
        self.column(column).count() >= LEAST
            && self.no_number(column).is_none()
            && self.increases(column)
    }

    /// Whether a column rises by one in each row.
    pub(crate) fn counts_rows(&self, column: usize) -> bool {
        self.rises(column) && self.is_even(column) && self.step(column) == Some(1.0)
    }

    pub(crate) fn first(&self, column: usize) -> Option<f64> {
        self.column(column).next().flatten()
    }

    /// The step from row to row that is in the middle of all: rows may be missing, or close to each other.
    pub(crate) fn middle_step(&self, column: usize) -> Option<f64> {
        let values = self.numbers(column);
        let steps = values.iter().zip(values.iter().skip(1));
        let mut steps: Vec<f64> = steps.map(|(a, b)| b - a).collect();
        steps.sort_by(f64::total_cmp);
        steps.get(steps.len() / 2).copied()
    }

    /// Whether a column goes on by the same step from row to row, of two at least.
    pub(crate) fn is_even(&self, column: usize) -> bool {
        let values = self.numbers(column);
        let second = |three: &[f64]| matches!(three, [a, b, c] if b - a == c - b);
        values.len() > 2 && values.windows(3).all(second)
    }

    /// Whether a value is less than the one before it.
    pub(crate) fn runs_backward(&self, column: usize) -> bool {
        let values = self.numbers(column);
        values.iter().zip(values.iter().skip(1)).any(|(a, b)| a > b)
    }

    /// The mean step from row to row.
    pub(crate) fn step(&self, column: usize) -> Option<f64> {
        let values = self.numbers(column);
        let (first, last) = (values.first()?, values.last()?);
        #[allow(clippy::cast_precision_loss)] // some twenty rows
        let steps = values.len().checked_sub(1).filter(|n| *n > 0)? as f64;
        Some((last - first) / steps)
    }
}
