//! The first rows of a log, by which its header is judged.

/// The first rows of a log, as numbers near by.
#[derive(Clone, Debug, Default)]
pub(crate) struct Preview {
    /// The fields of each row; `None` where a field is no number.
    pub(crate) rows: Vec<Vec<Option<f64>>>,
}

impl Preview {
    fn column(&self, column: usize) -> impl Iterator<Item = Option<f64>> + '_ {
        self.rows
            .iter()
            .map(move |row| row.get(column).copied().flatten())
    }

    pub(crate) fn is_of_numbers(&self, column: usize) -> bool {
        self.column(column).all(|x| x.is_some())
    }

    pub(crate) fn is_whole(&self, column: usize) -> bool {
        !self.rows.is_empty()
            && self
                .column(column)
                .all(|x| x.is_some_and(|x| x.fract() == 0.0))
    }

    pub(crate) fn increases(&self, column: usize) -> bool {
        let values: Vec<f64> = self.column(column).flatten().collect();
        values.iter().zip(values.iter().skip(1)).all(|(a, b)| a < b)
    }

    /// Whether a value is less than the one before it.
    pub(crate) fn runs_backward(&self, column: usize) -> bool {
        let values: Vec<f64> = self.column(column).flatten().collect();
        values.iter().zip(values.iter().skip(1)).any(|(a, b)| a > b)
    }

    /// The mean step from row to row.
    pub(crate) fn step(&self, column: usize) -> Option<f64> {
        let values: Vec<f64> = self.column(column).flatten().collect();
        let (first, last) = (values.first()?, values.last()?);
        #[allow(clippy::cast_precision_loss)] // some twenty rows
        let steps = values.len().checked_sub(1).filter(|n| *n > 0)? as f64;
        Some((last - first) / steps)
    }
}
