//! How fast the device moved in a log, beside the speed up to which the verdict is asked.
//!
//! An audit asks whether the criterion holds at the speed of an interval, which it may do beyond `operator.max_speed`. The
//! speeds are those of the rows that `passivity audit --out` writes.

use std::io::{self, Write};

use num_traits::{Signed as _, ToPrimitive as _};
use passivity_core::BigRational;

/// Counts the intervals that are surely faster than a bound, of the rows of a ledger that are written to it as CSV.
pub(super) struct Speeds {
    /// In ticks per sampling period.
    bound: BigRational,
    /// Where ξ₀ at the least and at the most, ξ₁ the same and the duration are in a row, once the header was read.
    columns: Option<[usize; 5]>,
    /// What is written of a row so far.
    row: Vec<u8>,
    /// How many are surely faster.
    pub(super) faster: u64,
}

impl Speeds {
    pub(super) const fn new(bound: BigRational) -> Self {
        Self {
            bound,
            columns: None,
            row: Vec::new(),
            faster: 0,
        }
    }

    /// Takes a row, or the header.
    fn take(&mut self) {
        let row = String::from_utf8_lossy(&self.row);
        let fields: Vec<&str> = row.split(',').collect();
        match self.columns {
            None => {
                let at = |name: &str| fields.iter().position(|field| *field == name);
                // Positions that are known have one column.
                let end = |name: &str, end: &str| at(&format!("{name}_{end}")).or_else(|| at(name));
                let found = [
                    end("xi0", "lo"),
                    end("xi0", "hi"),
                    end("xi1", "lo"),
                    end("xi1", "hi"),
                    at("dtau"),
                ];
                // Without these columns no row is told to be faster.
                self.columns = Some(found.map(|column| column.unwrap_or(usize::MAX)));
            }
            Some(columns) => {
                let fields = columns.map(|at| fields.get(at).copied().unwrap_or_default());
                if is_faster(fields, &self.bound) == Some(true) {
                    self.faster += 1;
                }
            }
        }
        self.row.clear();
    }
}

impl Write for Speeds {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for line in bytes.split_inclusive(|byte| *byte == b'\n') {
            let text = line.strip_suffix(b"\n");
            self.row.extend_from_slice(text.unwrap_or(line));
            if text.is_some() {
                self.take();
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Whether the least distance between ξ₀ and ξ₁ is more than the bound allows in the duration; `None` where a field is no
/// number.
fn is_faster(fields: [&str; 5], bound: &BigRational) -> Option<bool> {
    let near = fields.map(near);
    let [from, _, to, _, lasts] = near;
    // Most rows are slower by so much that doubles tell.
    if let (Some(from), Some(to), Some(lasts), Some(bound)) = (from, to, lasts, bound.to_f64())
        && (to - from).abs() + 3.0 + 1e-9 * (to.abs() + from.abs()) < bound * lasts
    {
        return Some(false);
    }
    let [from_lo, from_hi, to_lo, to_hi, lasts] =
        fields.map(|field| field.parse::<BigRational>().ok());
    let (up, down) = (to_lo? - from_hi?, from_lo? - to_hi?);
    let least = if up > down { up } else { down };
    Some(least.is_positive() && least > bound * lasts?)
}

/// The double near a number, `p/q` or `p`; `None` where it is no finite one.
fn near(text: &str) -> Option<f64> {
    let (p, q) = text.split_once('/').unwrap_or((text, "1"));
    let value = p.parse::<f64>().ok()? / q.parse::<f64>().ok()?;
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_surely_faster_is_counted_however_the_rows_are_cut() {
        let known =
            "h,xi0,xi1,dtau,margin\n0,0,3/2,1,0\n1,3/2,0,1,0\n2,0,7/2,2,0\n3,0,1,1,\n4,0,,1,0\n";
        let counts = "h,xi0_lo,xi0_hi,xi1_lo,xi1_hi,dtau\n0,0,1,2,3,1\n1,2,3,5,6,1\n2,90,91,5,6,1\n3,5,6,5,6,1\n";
        for (text, faster) in [(known, 3), (counts, 2)] {
            for size in 1..text.len() {
                let bound = BigRational::new(5.into(), 4.into());
                let mut speeds = Speeds::new(bound);
                for part in text.as_bytes().chunks(size) {
                    speeds.write_all(part).expect("a writer");
                }
                assert_eq!(speeds.faster, faster, "{text}");
            }
        }
    }
}
