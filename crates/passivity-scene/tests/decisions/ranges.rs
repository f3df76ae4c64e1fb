//! Ranges as text.

use passivity_core::{BigRational, Interval};

pub(crate) fn range(x: &Interval<BigRational>) -> String {
    match x.is_point() {
        true => x.lo().to_string(),
        false => format!("{} … {}", x.lo(), x.hi()),
    }
}
