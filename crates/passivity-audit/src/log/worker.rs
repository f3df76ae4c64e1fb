//! The work of one core: what it keeps from chunk to chunk, and the account of the intervals inside one.

use crate::log::account::Account;
use crate::log::chunk::Chunk;
use crate::log::known::Starts;
use crate::log::lanes::{Counted, ManyByLaw, Tiles};
use crate::log::running::RunningSum;
use crate::log::table::Table;
use crate::log::task::Task;
use crate::log::walk::Walk;

/// About how many points of a chunk are plotted.
const POINTS: usize = 512;

/// What a core keeps from chunk to chunk.
#[derive(Default)]
pub(crate) struct Worker {
    table: Table,
    /// The room of rows of counts.
    counted: Option<Box<Counted>>,
    /// The room of what was computed of the last chunk.
    room: Shared,
    /// Those of net energy and of what the observer adds, to which the rows of the last chunk led.
    denominators: [Option<i128>; 2],
    /// The room of written rows: there are many of them, and new memory takes longer than to write them.
    pub(crate) rows: Vec<u8>,
}

/// What is computed of a chunk once, for an account and another one beside it.
#[derive(Default)]
pub(crate) struct Shared {
    /// Of positions.
    tiles: Tiles,
    /// Of counts, under the force of the wall: by the account of the forces in the log, for that of the law beside it.
    by_law: ManyByLaw,
}

impl Worker {
    /// What is computed of a chunk once, for this account and another one beside it.
    pub(crate) fn shared(&mut self, task: &Task<'_>, chunk: &Chunk) -> Shared {
        let mut shared = std::mem::take(&mut self.room);
        shared.tiles.fill(task, chunk);
        shared.by_law.clear();
        shared
    }

    /// Takes back the room of what is not needed any more.
    pub(crate) fn reuse(&mut self, shared: Shared) {
        self.room = shared;
    }

    /// The account of the intervals that start at sample `from` or later and end in the chunk, given
    /// what was computed of them.
    ///
    /// On a mistake the chunk is cut before it.
    pub(crate) fn account(
        &mut self,
        task: &Task<'_>,
        (chunk, shared): (&mut Chunk, &mut Shared),
        from: usize,
    ) -> Account {
        let mut account = Account {
            rows: std::mem::take(&mut self.rows),
            ..Account::default()
        };
        let sums = [&mut account.net, &mut account.observer];
        for (sum, denominator) in sums.into_iter().zip(self.denominators) {
            if let Some(denominator) = denominator {
                // A course that has the denominator from the start need not change it. That of another
                // course always fits in an empty one.
                let _ = sum.scaled(0, denominator);
            }
        }
        let timed = !chunk.times.is_empty() || !chunk.dtaus.is_empty();
        let mut walk = Walk {
            task,
            from,
            until: chunk.samples.len().saturating_sub(1).max(from),
            stride: (chunk.samples.len() / POINTS).max(1),
            timed,
            noted: timed && task.compares,
            even: from,
            at: from,
            key: Vec::new(),
            starts: Starts::default(),
            tiles: &shared.tiles,
            by_law: &mut shared.by_law,
            counted: self.counted.get_or_insert_with(Counted::new).cleared(),
        };
        if let Err(error) = walk.run(&mut self.table, chunk, &mut account) {
            chunk.cut(walk.at, error);
        }
        if let Err(error) = walk.settle(&mut self.table, chunk, &mut account) {
            chunk.cut(walk.at, error);
        }
        if task.sums_alone() {
            // The rest has what was computed row by row alone, and is not told.
            account = account.sums_alone();
        }
        self.denominators = [&account.net, &account.observer].map(RunningSum::denominator);
        account
    }
}
