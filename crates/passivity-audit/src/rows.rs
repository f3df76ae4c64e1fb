//! Ledger rows as CSV, with the column names of the interface.
//!
//! An audit may write millions of them, so they are written by hand; a test holds each field
//! against the row as JSON.

use passivity_core::Truth;

use crate::ball::Ball;
use crate::entry::{Entry, Margin};
use crate::figure::Figure;
use crate::ledger::{Row, on_entry};
use crate::number::{Number, Reduced, Written};

/// The columns of a row, in the order of the interface.
const COLUMNS: [(&str, Column); 15] = [
    ("h", Column::Plain),
    ("xi0", Column::Figure),
    ("xi1", Column::Figure),
    ("dtau", Column::Plain),
    ("generated_linear", Column::Figure),
    ("generated_quantized", Column::Figure),
    ("bound_22", Column::Figure),
    ("bound_quantized", Column::Figure),
    ("dissipated_lower", Column::Figure),
    ("net_linear", Column::Figure),
    ("net_quantized", Column::Figure),
    ("margin", Column::Figure),
    ("criterion_holds", Column::Plain),
    ("violates_linear", Column::Plain),
    ("violates_quantized", Column::Plain),
];

/// Whether a column may be an enclosure.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Column {
    Plain,
    Figure,
}

/// How the rows of a file are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Form {
    /// Whether a figure is two columns, `lo` and `hi`.
    pub enclosures: bool,
    /// Whether the applied force is a last column.
    pub force: bool,
}

impl Form {
    /// The header.
    #[must_use]
    pub fn header(self) -> String {
        let force = self.force.then_some(("force", Column::Figure));
        let columns = COLUMNS.into_iter().chain(force).map(|(name, column)| {
            if column == Column::Figure && self.enclosures {
                format!("{name}_lo,{name}_hi")
            } else {
                name.to_owned()
            }
        });
        columns.collect::<Vec<_>>().join(",")
    }

    /// Appends the positions of a row, ξ₀ and ξ₁, each after a comma; `None` when one is undefined.
    pub fn write_positions(self, row: &Row, out: &mut Vec<u8>) -> Option<()> {
        on_entry!(row, entry => self.positions(entry, out))
    }

    /// Appends what follows the positions, from a comma to the line break; a figure without meaning
    /// is empty, and so is a truth that depends. `None` when a figure is undefined.
    pub fn write_account(self, row: &Row, out: &mut Vec<u8>) -> Option<()> {
        on_entry!(row, entry => self.account(entry, &entry.dtau.to_reduced()?, out))
    }

    /// Appends a row that doubles enclose, in these two parts, but for how long it lasts, which is known: each figure
    /// between the multiples of 2⁻⁶⁴ around it. `None` where one is not between any.
    pub(crate) fn write_near(
        self,
        entry: &Entry<Ball>,
        dtau: &Number,
        [positions, account]: [&mut Vec<u8>; 2],
    ) -> Option<()> {
        self.positions(entry, positions)?;
        self.account(entry, &dtau.into(), account)
    }

    fn positions<S: Written>(self, entry: &Entry<S>, out: &mut Vec<u8>) -> Option<()> {
        self.figure(&entry.xi0, out)?;
        self.figure(&entry.xi1, out)
    }

    fn account<S: Written>(
        self,
        entry: &Entry<S>,
        dtau: &Reduced,
        out: &mut Vec<u8>,
    ) -> Option<()> {
        out.push(b',');
        dtau.write(out);
        let account = &entry.account;
        for figure in [
            &account.generated_linear,
            &account.generated_quantized,
            &account.bound_22,
            &account.bound_quantized,
            &account.dissipated_lower,
            &account.net_linear,
            &account.net_quantized,
        ] {
            self.figure(figure, out)?;
        }
        let margin = entry.margin.as_ref();
        let ends = [margin.and_then(Margin::lo), margin.and_then(Margin::hi)];
        self.ends(ends, out)?;
        for truth in [
            entry.criterion_holds,
            entry.violates_linear,
            entry.violates_quantized,
        ] {
            out.extend_from_slice(match truth {
                Truth::Holds => b",true",
                Truth::Fails => b",false",
                Truth::Depends => b",",
            });
        }
        if self.force {
            match entry.force() {
                Some(force) => self.figure(force, out)?,
                None => self.ends::<S>([None, None], out)?,
            }
        }
        out.push(b'\n');
        Some(())
    }

    fn figure<S: Written>(self, figure: &Figure<S>, out: &mut Vec<u8>) -> Option<()> {
        self.ends([Some(figure.lo()), Some(figure.hi())], out)
    }

    fn ends<S: Written>(self, [lo, hi]: [Option<&S>; 2], out: &mut Vec<u8>) -> Option<()> {
        out.push(b',');
        if let Some(x) = lo {
            x.below()?.write(out);
        }
        if self.enclosures {
            out.push(b',');
            if let Some(x) = hi {
                x.above()?.write(out);
            }
        }
        Some(())
    }
}
