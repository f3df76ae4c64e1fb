//! Forces that are recorded apart from the positions, as on another topic: those that the rows of a log leave out.
//!
//! A row has the force that was recorded last before it, and it is held until the next row. The account is not of what
//! the device was commanded where
//!
//! - a force came between two rows, and another after it: no row has the first one. One that says again what was held
//!   before, or what comes after it, is not missed;
//! - a force is [old](OLD): others that were commanded since are not in the log.

use passivity_scene::{Motion, Scene};

use crate::log::chunk::Chunk;
use crate::log::findings::Finding;

/// A force is old after so many sampling periods, and as many rows. A new one is commanded in every period; some are
/// recorded late, some are lost, and some controllers run at a half or a quarter of the rate. Rows may be fewer than
/// periods: then so may the forces.
pub(crate) const OLD: u16 = 8;

/// A row that leaves out forces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    /// Which one of a block.
    pub(crate) row: usize,
    /// How many came before that of the row, and after that of the row before it.
    pub(crate) missed: u64,
    /// Whether that of the row is old.
    pub(crate) is_old: bool,
}

/// How many, and in which row first.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    count: u64,
    first: Option<u64>,
}

impl Tally {
    fn add(&mut self, count: u64, row: u64) {
        if count > 0 {
            self.count += count;
            self.first.get_or_insert(row);
        }
    }
}

/// What the rows of a log leave out.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Held {
    rows: u64,
    missed: Tally,
    old: Tally,
}

impl Held {
    /// Takes the first `rows` of a chunk.
    pub(crate) fn feed(&mut self, chunk: &Chunk, rows: usize) {
        for mark in chunk.marks.iter().filter(|mark| mark.row < rows) {
            let row = self.rows + mark.row as u64 + 1;
            self.missed.add(mark.missed, row);
            self.old.add(mark.is_old.into(), row);
        }
        self.rows += rows as u64;
    }

    /// What is said of it, given the name of the forces.
    pub(crate) fn findings(&self, name: &str) -> Vec<Finding> {
        let mut findings = Vec::new();
        if let Some(row) = self.missed.first {
            let were = match self.missed.count {
                1 => "1 value was".to_owned(),
                count => format!("{count} values were"),
            };
            findings.push(Finding {
                kind: "missed_force",
                says: format!(
                    "{were} followed by another before a row had it, the first before row {row}: the account leaves out what {name} said between positions"
                ),
                fix: "record the position as often as the force, or the force in the message of the position"
                    .to_owned(),
            });
        }
        if let Some(row) = self.old.first {
            let rows = match self.old.count {
                1 => "1 row rests".to_owned(),
                count => format!("{count} rows rest"),
            };
            findings.push(Finding {
                kind: "old_force",
                says: format!(
                    "{rows} on a value of {name} from more than {OLD} sampling periods and {OLD} rows before, the first of them row {row}"
                ),
                fix: "record every force that is commanded, or cut the log to where it has them (`mcap filter`)"
                    .to_owned(),
            });
        }
        findings
    }
}

/// So many sampling periods that a force is old, in nanoseconds; none where the scene has no seconds.
#[cfg_attr(not(feature = "mcap"), expect(dead_code, reason = "of MCAP only"))]
pub(crate) fn old_after(scene: &Scene) -> u64 {
    let period = scene.given.period.nominal.to_rational();
    let (Motion::Linear | Motion::Rotary, Some(period)) = (scene.motion, period) else {
        return 0;
    };
    let nanoseconds = passivity_scene::number::nearest_f64(&period) * 1e9 * f64::from(OLD);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "near by, above zero, and at most as many as there are"
    )]
    let whole = nanoseconds as u64;
    whole
}
