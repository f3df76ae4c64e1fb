//! Times in two columns: whole ones of a unit, and what the time is beyond them, in a smaller unit.

use super::{Layout, header};
use crate::log::error::TraceError;
use crate::log::numbers::Numbers;
use crate::number::{Number, difference, is_less, product, quotient};

/// The column of what a time is beyond whole ones of its unit.
#[derive(Clone, Debug)]
pub(crate) struct Fine {
    pub(crate) column: usize,
    /// How many of its units are one of the other column's.
    ratio: Number,
}

impl Fine {
    /// Of a column with so many units to the sampling period, beside one that has so many.
    pub(super) fn new(column: usize, own: &Number, other: &Number) -> Result<Self, TraceError> {
        let ratio = Number::from(quotient(own, other).to_rational());
        if !is_whole(&ratio) || !is_less(&Number::whole(1), &ratio) {
            let message = "the second column of a time is in a smaller unit, as in `t=sec [s] + nanosec [ns]`";
            return Err(header(message));
        }
        Ok(Self { column, ratio })
    }

    /// The time in the smaller unit; or what is wrong with this column.
    pub(crate) fn moment(&self, whole: &Number, beyond: &Number) -> Result<Number, TraceError> {
        if !is_whole(whole) {
            let message =
                format!("the time that this adds to must be a whole number, found {whole}");
            return Err(TraceError::new("split_time", message));
        }
        if is_less(beyond, &Number::whole(0)) || !is_less(beyond, &self.ratio) {
            let message = format!(
                "expected what the time is beyond whole ones, at least 0 and less than {}, found {beyond}",
                self.ratio
            );
            return Err(TraceError::new("split_time", message));
        }
        let whole = product(whole, &self.ratio);
        let nothing = Number::whole(0);
        Ok(difference(&whole, &difference(&nothing, beyond)))
    }
}

impl Layout {
    pub(crate) fn fine_column(&self) -> Option<usize> {
        self.fine.as_ref().map(|fine| fine.column)
    }

    /// The times of two columns up to the first that is wrong, and what is wrong with it; those of the first where there
    /// is no second.
    pub(crate) fn moments(
        &self,
        whole: Numbers,
        beyond: &Numbers,
    ) -> (Numbers, Option<TraceError>) {
        let Some(fine) = &self.fine else {
            return (whole, None);
        };
        let mut times = Numbers::default();
        for i in 0..whole.len() {
            let (Some(whole), Some(beyond)) = (whole.get(i), beyond.get(i)) else {
                break;
            };
            match fine.moment(&whole, &beyond) {
                Ok(time) => times.push(time),
                Err(error) => return (times, Some(error.column(self.name(fine.column)))),
            }
        }
        (times, None)
    }
}

fn is_whole(x: &Number) -> bool {
    match x {
        Number::Small(n, d) => n % d == 0,
        x => x.to_rational().is_integer(),
    }
}
