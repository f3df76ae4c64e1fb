//! The row of an interval, and what an account keeps of it.

use crate::ball::Ball;
use crate::entry::Entry;
use crate::ledger::{Ledger, Logged, Row, Truths, on_entry};
use crate::log::account::{Account, Place};
use crate::log::counted;
use crate::log::error::TraceError;
use crate::log::known::{Known, known_force};
use crate::log::motion::Addend;
use crate::log::running::Lowest;
use crate::log::step::undefined;
use crate::log::supply::{Contribution, observed, potential, potential_on};
use crate::log::task::Task;
use crate::number::{Number, Reduced, Written as _};
use crate::reading::Reading;
use crate::rows::Form;
use crate::span::{ONE, below_on_grid, on_both_sides, outward};
use crate::sum::FigureSum;

/// The row of an interval: of exact numbers, or of doubles where nothing is left open by them.
pub(crate) enum Accounted {
    Exact(Row),
    Near(Box<Entry<Ball>>),
    /// Between known positions or of a plain wall, of doubles.
    Quick(Box<Addend>),
    /// Decided by exact numbers, and summed up on the grid: so that the denominators of sums stay
    /// short.
    Decided(Row),
}

impl Accounted {
    pub(crate) fn truths(&self) -> Truths {
        match self {
            Self::Exact(row) | Self::Decided(row) => row.truths(),
            Self::Near(entry) => entry.truths(),
            Self::Quick(addend) => addend.truths,
        }
    }

    /// Adds the figures that totals are kept of, `times` over; `None` when one is undefined.
    pub(crate) fn add_to(&self, sums: &mut [FigureSum; 5], times: u64) -> Option<()> {
        match self {
            Self::Exact(row) => row.add_to(sums, times),
            Self::Near(entry) => entry.add_to(sums, times),
            Self::Quick(addend) => {
                for (sum, ends) in sums.iter_mut().zip(addend.sums) {
                    sum.add_on_grid(ends, times);
                }
                Some(())
            }
            Self::Decided(row) => {
                for (sum, figure) in sums.iter_mut().zip(row.figures()?) {
                    match on_both_sides(figure.lo(), figure.hi()) {
                        Some(ends) => sum.add_on_grid(ends, times),
                        None => sum.add_times(&figure, times)?,
                    }
                }
                Some(())
            }
        }
    }

    /// The least that net energy may be.
    fn least_net(&self) -> Option<Reduced> {
        match self {
            Self::Exact(row) => on_entry!(row, entry => entry.account.net_linear.lo().below()),
            Self::Near(entry) => entry.account.net_linear.lo().below(),
            Self::Quick(addend) => {
                let [_, _, _, [least, _], _] = addend.sums;
                Some(Reduced::Small(least, ONE))
            }
            Self::Decided(row) => {
                let net = row.net_linear()?.lo().clone();
                Some(below_on_grid(net.into()))
            }
        }
    }
}

/// One period.
pub(crate) const UNIT: Number = Number::whole(1);

/// Whether the row of an interval of this length and with this end is one of exact numbers also in a long trace: one of
/// counts one period apart under their own law, of which there are few different ones.
pub(crate) fn is_exact(task: &Task<'_>, end: &Reading, dtau: &Number) -> bool {
    matches!(end, Reading::Count(_)) && *dtau == UNIT && !task.applied
}

/// A row, and what is kept of it.
pub(crate) struct Computed {
    pub(crate) row: Accounted,
    /// Net energy at the least.
    pub(crate) net: Reduced,
    /// What the observer adds.
    pub(crate) observed: Reduced,
    pub(crate) contribution: Option<Contribution>,
    /// The row as CSV, where it is written.
    pub(crate) written: Text,
}

/// A row as CSV: its positions, and what follows them, which intervals elsewhere may have in common with it.
#[derive(Default)]
pub(crate) struct Text {
    positions: Vec<u8>,
    account: Vec<u8>,
}

impl Text {
    /// Becomes the row of an interval that doubles decide, in the room of the one before.
    pub(crate) fn fill(&mut self, task: &Task<'_>, interval: &Logged, form: Form) -> Option<()> {
        self.clear();
        if self.near(task.ledger, interval, form).is_some() {
            return Some(());
        }
        self.clear();
        self.exact(&task.ledger.row(interval)?, form)
    }

    fn clear(&mut self) {
        self.positions.clear();
        self.account.clear();
    }

    /// A row enclosed by doubles: of positions or a force that a factor with π in it leaves enclosed in any
    /// case, and where doubles leave nothing open.
    fn near(&mut self, ledger: &Ledger, interval: &Logged, form: Form) -> Option<()> {
        let is_scaled = |reading: &Reading| matches!(reading, Reading::Within(_));
        if !(is_scaled(&interval.end) || interval.force.as_ref().is_some_and(is_scaled)) {
            return None;
        }
        let entry = ledger.near_entry(interval.read(), &interval.dtau)?;
        let entry = entry.with_margin(ledger.near())?;
        let text = [&mut self.positions, &mut self.account];
        form.write_near(&entry, &interval.dtau, text)
    }

    fn exact(&mut self, row: &Row, form: Form) -> Option<()> {
        form.write_positions(row, &mut self.positions)?;
        form.write_account(row, &mut self.account)
    }

    /// Appends the row of an interval between two other counts.
    pub(crate) fn append_between(&self, counts: [i64; 2], rows: &mut Vec<u8>) {
        let mut digits = itoa::Buffer::new();
        for n in counts {
            rows.push(b',');
            rows.extend_from_slice(digits.format(n).as_bytes());
            rows.push(b',');
            match n.checked_add(1) {
                Some(next) => rows.extend_from_slice(digits.format(next).as_bytes()),
                None => rows.extend_from_slice(digits.format(i128::from(n) + 1).as_bytes()),
            }
        }
        rows.extend_from_slice(&self.account);
    }

    pub(crate) fn append_to(&self, rows: &mut Vec<u8>) {
        rows.extend_from_slice(&self.positions);
        rows.extend_from_slice(&self.account);
    }
}

impl Computed {
    /// The row of an interval: of doubles where these leave nothing open.
    pub(crate) fn of(task: &Task<'_>, interval: &Logged) -> Result<Self, TraceError> {
        let exact = is_exact(task, &interval.end, &interval.dtau);
        Self::defined(task, interval, exact).ok_or_else(undefined)
    }

    /// The row of an interval of a short trace: of exact numbers, unless π enters.
    pub(crate) fn exactly(task: &Task<'_>, interval: &Logged) -> Result<Self, TraceError> {
        let exact = !matches!(interval.end, Reading::Within(_));
        Self::defined(task, interval, exact).ok_or_else(undefined)
    }

    fn defined(task: &Task<'_>, interval: &Logged, exact: bool) -> Option<Self> {
        let quick = || {
            let force = known_force(interval)?;
            let addend = match Known::of_interval(task, interval) {
                Some(known) => known.addend(force)?,
                None => counted::Figures::of_interval(task.ledger, interval)?.addend(),
            };
            Self::of_row(task, interval, Accounted::Quick(Box::new(addend)))
        };
        let near = || {
            let entry = task.ledger.near_entry(interval.read(), &interval.dtau);
            // What has no room in sums of doubles is for exact numbers.
            let entry = entry.filter(Entry::can_be_added)?;
            Self::of_row(task, interval, Accounted::Near(Box::new(entry)))
        };
        let near = if exact { None } else { quick().or_else(near) };
        let mut written = Text::default();
        let computed = match near {
            Some(near) => {
                if let Some(form) = task.rows {
                    written.fill(task, interval, form)?;
                }
                near
            }
            None => {
                let row = task.ledger.row(interval)?;
                if let Some(form) = task.rows {
                    written.exact(&row, form)?;
                }
                let row = match exact {
                    true => Accounted::Exact(row),
                    false => Accounted::Decided(row),
                };
                Self::of_row(task, interval, row)?
            }
        };
        Some(Self {
            written,
            ..computed
        })
    }

    fn of_row(task: &Task<'_>, interval: &Logged, row: Accounted) -> Option<Self> {
        let contribution = match task.running {
            true => Some(Contribution::of(task.ledger, interval, &row)?),
            false => None,
        };
        Some(Self {
            net: row.least_net()?,
            observed: observed(&row)?,
            contribution,
            written: Text::default(),
            row,
        })
    }

    /// Adds the row of one interval to the account, all but its sums and tallies.
    pub(crate) fn enter(
        &self,
        observed: &Reduced,
        account: &mut Account,
    ) -> Result<(), TraceError> {
        account.net.add(&self.net);
        account.observer.add(observed);
        account.intervals += 1;
        if let Some(contribution) = &self.contribution {
            let added = account.supply.add(contribution, account.intervals);
            added.ok_or_else(undefined)?;
        }
        Ok(())
    }

    /// Adds the row of one interval to the account.
    pub(crate) fn account(
        &self,
        task: &Task<'_>,
        interval: &Logged,
        account: &mut Account,
    ) -> Result<(), TraceError> {
        self.written.append_to(&mut account.rows);
        let h = account.intervals;
        let place = || {
            Some(Place {
                h,
                interval: interval.clone(),
            })
        };
        let noted = account.note(&self.row, &self.net, h, 1, place);
        noted.ok_or_else(undefined)?;
        self.enter(&self.observed, account)?;
        note_stored(task, &self.row, &interval.end, account)
    }
}

/// Takes note of net energy plus potential after the latest interval, which ends at `sample`.
pub(crate) fn note_stored(
    task: &Task<'_>,
    row: &Accounted,
    sample: &Reading,
    account: &mut Account,
) -> Result<(), TraceError> {
    // No potential is negative.
    if task.running || Lowest::is_below_sum(account.stored.as_ref(), &account.net) {
        return Ok(());
    }
    let ledger = task.ledger;
    let near = || potential_on(ledger.near(), &sample.to_near());
    let decided = || potential(ledger, sample).map(outward);
    let potential = match (row, sample) {
        // The row of counts may be that of another interval, as long and elsewhere.
        (Accounted::Near(_), _) | (Accounted::Quick(_), Reading::Count(_)) => {
            near().or_else(decided)
        }
        (Accounted::Quick(addend), _) => Some(addend.potential.map(|end| Reduced::Small(end, ONE))),
        (Accounted::Exact(_), _) => potential(ledger, sample),
        (Accounted::Decided(_), _) => decided(),
    };
    let [least, _] = potential.ok_or_else(undefined)?;
    Lowest::keep_sum(&mut account.stored, &account.net, &least, account.intervals);
    Ok(())
}
