//! All that was found in a log, or in a stretch of it: the report is made of it.

use passivity_scene::Scene;

use crate::json::NumberedRow;
use crate::ledger::{Ledger, Logged};
use crate::log::account::Account;
use crate::log::comparison::Comparison;
use crate::log::computed::{Accounted, Computed};
use crate::log::error::TraceError;
use crate::log::held::Held;
use crate::log::outcome::Audit;
use crate::log::report::UnendedRow;
use crate::log::step::undefined;
use crate::log::task::Task;
use crate::log::ticks::Steps;
use crate::log::velocity::Velocities;
use crate::log::wraps::Wrapped;
use crate::number::Number;
use crate::reading::Reading;

/// The most intervals whose rows a report carries itself.
pub(crate) const ROWS_IN_REPORT: usize = 1000;

/// All that an audit found.
pub(crate) struct Findings {
    pub(crate) account: Account,
    pub(crate) samples: u64,
    pub(crate) first: Option<Reading>,
    /// From the first sample's time to the last one's, in sampling periods.
    pub(crate) duration: Option<Number>,
    pub(crate) comparison: Option<Comparison>,
    pub(crate) velocities: Option<Velocities>,
    pub(crate) wrapped: Wrapped,
    pub(crate) steps: Steps,
    pub(crate) held: Held,
    pub(crate) head: Vec<Logged>,
    pub(crate) error: Option<TraceError>,
    /// Whether the last row lacks its line break, and the last rows of earlier files that do.
    pub(crate) unended: bool,
    pub(crate) unended_rows: Vec<UnendedRow>,
    /// The last file, where there are several, and how many samples came before it.
    pub(crate) file: Option<String>,
    pub(crate) before_file: u64,
}

impl Findings {
    /// The report, with the account of the wall's own law beside it.
    pub(crate) fn audit(
        mut self,
        task: &Task<'_>,
        scene: &Scene,
        beside: Option<Self>,
    ) -> Result<Audit, TraceError> {
        let law = match (beside, task.by_law()) {
            (Some(beside), Some(by_law)) => Some(beside.audit(&by_law, scene, None)?),
            _ => None,
        };
        if self.error.is_none() && self.account.intervals == 0 {
            let message = "a trace needs two samples at least: there is nothing to account for";
            let mut error = TraceError::new("empty", message);
            error.file.clone_from(&self.file);
            self.error = Some(error.row(self.samples + 1 - self.before_file));
        }
        let rows = match self.account.intervals > ROWS_IN_REPORT as u64 {
            true => None,
            false => self.exactly(task, scene)?,
        };
        Audit::new(task, scene, self, (law, rows))
    }

    /// Accounts for a short log once more, in exact numbers, so that its sums are exact: its rows, where these are told.
    fn exactly(
        &mut self,
        task: &Task<'_>,
        scene: &Scene,
    ) -> Result<Option<Vec<NumberedRow>>, TraceError> {
        let task = Task {
            rows: None,
            ..task.clone()
        };
        let accounted = scene.unaccounted(task.applied).is_empty();
        let mut account = Account::default();
        let mut rows = task.reports_rows.then(Vec::new);
        for (h, interval) in (0..).zip(&self.head) {
            let computed = Computed::exactly(&task, interval)?;
            computed.account(&task, interval, &mut account)?;
            let Some(rows) = &mut rows else { continue };
            let row = match computed.row {
                Accounted::Exact(row) => row,
                _ => task.ledger.row(interval).ok_or_else(undefined)?,
            };
            rows.push(NumberedRow { h, row, accounted });
        }
        let found = &mut self.account;
        account.last = found.last.take();
        account.points = std::mem::take(&mut found.points);
        account.timing = std::mem::take(&mut found.timing);
        self.account = account;
        Ok(rows)
    }

    /// Whether the intervals that are shown have figures, as those of an account that was changed may not.
    pub(crate) fn is_defined(&self, ledger: &Ledger) -> bool {
        let mut shown = self.account.shown().chain(&self.head);
        shown.all(|interval| ledger.row(interval).is_some())
    }

    /// Goes on with what was found in the stretch that follows.
    pub(crate) fn append(&mut self, next: Self) {
        let before = self.samples;
        if self.account.intervals + next.account.intervals <= ROWS_IN_REPORT as u64 {
            self.head.extend(next.head);
        }
        self.account.append(next.account);
        self.samples += next.samples;
        self.first = self.first.take().or(next.first);
        if let (Some(own), Some(next)) = (&mut self.comparison, &next.comparison) {
            own.append(next);
        }
        if let (Some(own), Some(next)) = (&mut self.velocities, &next.velocities) {
            own.append(next);
        }
        self.wrapped.append(before, &next.wrapped);
        self.steps.append(next.steps);
        self.error = next.error.map(|error| TraceError {
            row: error.row.map(|row| before + row),
            ..error
        });
        self.unended |= next.unended;
    }
}
