//! Ledger rows as CSV, with the column names of the interface.
//!
//! An audit may write millions of them, so they are written by hand; a test holds each field
//! against the row as JSON.

use passivity_core::{Ordered, Truth};

use crate::ball::Ball;
use crate::entry::{Entry, Margin};
use crate::figure::Figure;
use crate::ledger::{Row, Truths, on_entry};
use crate::number::{Fraction, Line, Number, Quotient, Reduced, Size, Written};

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

/// Which of the energies are those of the force: what it generated, and what is left of what friction took.
const OF_FORCE: [bool; 7] = [true, true, false, false, false, true, true];

/// Whether a column may be an enclosure.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Column {
    Plain,
    Figure,
}

/// Where a row is written to.
pub(crate) trait Out {
    /// Appends some characters; `None` where there is no room.
    fn append(&mut self, text: &[u8]) -> Option<()>;
}

impl Out for Vec<u8> {
    #[inline(always)]
    fn append(&mut self, text: &[u8]) -> Option<()> {
        self.extend_from_slice(text);
        Some(())
    }
}

impl Out for Line<'_> {
    #[inline(always)]
    fn append(&mut self, text: &[u8]) -> Option<()> {
        Line::append(self, text)
    }
}

/// What is written of a number.
pub(crate) trait Shown<O>: Copy {
    /// Appends a comma and the number, or one close below it; `None` when it is undefined.
    fn write_below(self, out: &mut O) -> Option<()>;

    /// Appends a comma and the number, or one close above it; `None` when it is undefined.
    fn write_above(self, out: &mut O) -> Option<()>;
}

impl<S: Written> Shown<Vec<u8>> for &S {
    fn write_below(self, out: &mut Vec<u8>) -> Option<()> {
        out.push(b',');
        self.below()?.write(out);
        Some(())
    }

    fn write_above(self, out: &mut Vec<u8>) -> Option<()> {
        out.push(b',');
        self.above()?.write(out);
        Some(())
    }
}

/// A whole number.
#[derive(Clone, Copy)]
pub(crate) struct Whole(pub(crate) i64);

impl<O: Out> Shown<O> for Whole {
    #[inline(always)]
    fn write_below(self, out: &mut O) -> Option<()> {
        out.append(b",")?;
        out.append(itoa::Buffer::new().format(self.0).as_bytes())
    }

    #[inline(always)]
    fn write_above(self, out: &mut O) -> Option<()> {
        self.write_below(out)
    }
}

/// A number that was rounded already.
impl Shown<Line<'_>> for Fraction<'_> {
    #[inline(always)]
    fn write_below(self, out: &mut Line<'_>) -> Option<()> {
        self.write(out)
    }

    #[inline(always)]
    fn write_above(self, out: &mut Line<'_>) -> Option<()> {
        self.write(out)
    }
}

/// A number in lowest terms.
impl<S: Size> Shown<Line<'_>> for Quotient<S> {
    #[inline]
    fn write_below(self, out: &mut Line<'_>) -> Option<()> {
        self.write(out)
    }

    #[inline]
    fn write_above(self, out: &mut Line<'_>) -> Option<()> {
        self.write(out)
    }
}

/// What a row says behind its positions and how long it lasts: numbers at the least and at the most.
pub(crate) struct Figures<S> {
    /// The energies, in the order of their columns.
    pub(crate) energies: [[S; 2]; 7],
    pub(crate) margin: [Option<S>; 2],
    pub(crate) truths: Truths,
    /// The force that was given, where there is any.
    pub(crate) force: [Option<S>; 2],
}

impl<'a, S: Ordered> Figures<&'a S> {
    fn of(entry: &'a Entry<S>) -> Self {
        let account = &entry.account;
        let energies = [
            &account.generated_linear,
            &account.generated_quantized,
            &account.bound_22,
            &account.bound_quantized,
            &account.dissipated_lower,
            &account.net_linear,
            &account.net_quantized,
        ];
        let (margin, force) = (entry.margin.as_ref(), entry.force());
        Self {
            energies: energies.map(|figure| [figure.lo(), figure.hi()]),
            margin: [margin.and_then(Margin::lo), margin.and_then(Margin::hi)],
            truths: entry.truths(),
            force: [force.map(Figure::lo), force.map(Figure::hi)],
        }
    }
}

/// How the rows of a file are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Form {
    /// Whether a figure is two columns, `lo` and `hi`.
    pub enclosures: bool,
    /// Whether the applied force is a last column.
    pub force: bool,
    /// Whether the force of the account is the one that acted: if not, the columns of what it generated are empty.
    pub accounted: bool,
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
        on_entry!(row, entry => {
            self.duration(&entry.dtau.to_reduced()?, out);
            self.account(&Figures::of(entry), out)
        })
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
        self.duration(&dtau.into(), account);
        self.account(&Figures::of(entry), account)
    }

    fn positions<S: Written>(self, entry: &Entry<S>, out: &mut Vec<u8>) -> Option<()> {
        self.position([entry.xi0.lo(), entry.xi0.hi()], out)?;
        self.position([entry.xi1.lo(), entry.xi1.hi()], out)
    }

    /// Appends a position, after a comma.
    #[inline(always)]
    pub(crate) fn position<S: Shown<O>, O: Out>(self, [lo, hi]: [S; 2], out: &mut O) -> Option<()> {
        self.ends([Some(lo), Some(hi)], out)
    }

    /// Appends how long a row lasts, after a comma.
    pub(crate) fn duration(self, dtau: &Reduced, out: &mut Vec<u8>) {
        out.push(b',');
        dtau.write(out);
    }

    /// Appends the figures of a row, from a comma to the line break.
    #[inline(always)]
    pub(crate) fn account<S: Shown<O>, O: Out>(
        self,
        figures: &Figures<S>,
        out: &mut O,
    ) -> Option<()> {
        for ([lo, hi], of_force) in figures.energies.into_iter().zip(OF_FORCE) {
            let is_known = self.accounted || !of_force;
            self.ends([is_known.then_some(lo), is_known.then_some(hi)], out)?;
        }
        self.ends(figures.margin, out)?;
        let truths = figures.truths;
        for (truth, of_force) in [
            (truths.criterion_holds, false),
            (truths.violates_linear, true),
            (truths.violates_quantized, true),
        ] {
            let is_known = self.accounted || !of_force;
            match if is_known { truth } else { Truth::Depends } {
                Truth::Holds => out.append(b",true"),
                Truth::Fails => out.append(b",false"),
                Truth::Depends => out.append(b","),
            }?;
        }
        if self.force {
            self.ends(figures.force, out)?;
        }
        out.append(b"\n")
    }

    #[inline(always)]
    fn ends<S: Shown<O>, O: Out>(self, [lo, hi]: [Option<S>; 2], out: &mut O) -> Option<()> {
        match lo {
            Some(x) => x.write_below(out)?,
            None => out.append(b",")?,
        }
        if self.enclosures {
            match hi {
                Some(x) => x.write_above(out)?,
                None => out.append(b",")?,
            }
        }
        Some(())
    }
}
