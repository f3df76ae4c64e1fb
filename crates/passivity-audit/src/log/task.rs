//! What is asked of every chunk of a log.

use passivity_scene::Scene;

use crate::ledger::{Ledger, Logged};
use crate::log::chunk::{Chunk, Samples};
use crate::log::computed::UNIT;
use crate::log::error::TraceError;
use crate::log::layout::Layout;
use crate::log::step::{duration, interval, undefined};
use crate::log::wall::{Part, Parts, Reach, Wall};
use crate::log::wraps::Periods;
use crate::number::Number;
use crate::reading::Reading;
use crate::rows;

/// What is asked of every chunk.
#[derive(Clone, Debug)]
pub(crate) struct Task<'a> {
    pub(crate) ledger: &'a Ledger,
    pub(crate) layout: &'a Layout,
    /// Whether rows are written, and how.
    pub(crate) rows: Option<rows::Form>,
    /// Whether the report carries the rows of a short log.
    pub(crate) reports_rows: bool,
    pub(crate) points: bool,
    /// Whether the account is of the forces in the trace.
    pub(crate) applied: bool,
    /// Whether the verdict is about what the operator has drawn so far.
    pub(crate) running: bool,
    /// Whether the forces, velocities and times of the trace are compared with what they should be.
    pub(crate) compares: bool,
    /// Whether the forces of the scene's law follow from the positions in the trace.
    pub(crate) knows_law: bool,
    /// By what a position jumps where its counter wraps around.
    pub(crate) periods: Periods,
    /// The names of the files, where there are several.
    pub(crate) files: &'a [String],
    /// Whether the columns are read as they were told to be.
    pub(crate) told: bool,
    /// A wall behind an encoder, whose rows take no longer to compute than to look up, and its parts; `None` where there is
    /// more to the loop.
    pub(crate) wall: Option<Wall>,
    pub(crate) parts: Option<Parts>,
}

impl<'a> Task<'a> {
    /// The account of the forces in the trace where it has any, and of the scene's law else or where
    /// that is asked for.
    pub(crate) fn new(scene: &Scene, ledger: &'a Ledger, layout: &'a Layout, law: bool) -> Self {
        let applied = layout.force.is_some() && !law;
        let wall = Wall::of(ledger);
        Self {
            ledger,
            layout,
            rows: None,
            reports_rows: true,
            points: false,
            applied,
            running: applied || ledger.has_memory(),
            compares: true,
            knows_law: scene.unaccounted(false).is_empty(),
            periods: Periods::of(scene, layout),
            files: &[],
            told: false,
            parts: wall.as_ref().map(Wall::parts),
            wall,
        }
    }

    /// Whether there is an account of the wall's own law, where that is known, beside that of the forces in the trace.
    pub(crate) const fn has_by_law(&self) -> bool {
        self.applied && self.knows_law
    }

    /// Beside the account of the forces in the trace, that of the wall's own law, where it is known.
    pub(crate) fn by_law(&self) -> Option<Self> {
        self.has_by_law().then(|| Task {
            rows: None,
            reports_rows: false,
            points: false,
            applied: false,
            running: self.ledger.has_memory(),
            compares: false,
            ..self.clone()
        })
    }

    /// Whether sums and what rows answer are all that is told of the account: of one by the law beside another, which is
    /// judged interval by interval.
    pub(crate) const fn sums_alone(&self) -> bool {
        !self.compares && !self.running
    }

    /// Whether the forces in the trace are compared with those of the scene's law.
    pub(crate) const fn compares_forces(&self) -> bool {
        self.compares && self.knows_law && self.layout.force.is_some()
    }

    /// Whether the row that starts at sample `i` is one of counts that may come again, to be looked up.
    #[inline]
    pub(crate) fn looks_up(&self, chunk: &Chunk, i: usize, dtau: &Number) -> bool {
        if !matches!(chunk.samples, Samples::Counts(_)) {
            return false;
        }
        let unit = *dtau == UNIT;
        match self.applied {
            // Of forces scaled by π none but zero is exact, too few to come again.
            true => {
                unit && self.parts.is_none()
                    && !self.layout.per_force().is_irrational()
                    && matches!(chunk.forces.get(i), Some(Reading::Exact(Number::Small(..))))
            }
            false => unit || self.parts.is_none(),
        }
    }

    /// In which part of the wall an interval between two counts is, under its own force.
    #[inline]
    pub(crate) fn part(&self, from: i64, to: i64) -> Option<Part> {
        let parts = self.parts.as_ref().filter(|_| !self.applied)?;
        parts.of(from, to)
    }

    /// Where a wall is linear, whose rows are computed several at a time; `None` for everywhere, and of other loops.
    pub(crate) fn reach(&self) -> Option<&Reach> {
        self.wall.as_ref()?.reach.as_ref()
    }

    /// How many samples before an interval's own a chunk must have for it to be accounted for.
    pub(crate) fn lead(&self) -> usize {
        self.ledger.window() - 1 + usize::from(self.running)
    }

    /// The interval that starts at sample `i` of a chunk.
    pub(crate) fn logged(&self, chunk: &Chunk, i: usize) -> Result<Logged, TraceError> {
        let dtau = duration(self.layout, chunk, i)?.unwrap_or(UNIT).reduced();
        let found = interval(chunk, i, self.ledger.window(), self.applied, dtau);
        found.ok_or_else(undefined)
    }
}
