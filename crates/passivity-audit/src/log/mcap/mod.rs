//! MCAP files: the messages on one topic are the rows of a log, with what other topics said last.
//!
//! Every number of a message is a column, named by its topic and its path: `/joint_states.position.knee`,
//! `/wrench.wrench.force.x`, `/readings.data[3]`. So is every time, in nanoseconds: the stamp in a header, and
//! when the message was recorded and sent. They become rows of text, which are read as those of CSV.

mod binary;
mod channels;
mod discovery;
mod json;
mod records;
mod rows;
mod schema;
mod value;

use std::path::{Path, PathBuf};

use passivity_scene::Scene;

use crate::log::columns::Columns;
use crate::log::error::TraceError;
use crate::log::guarded::guarded;
use crate::log::held::old_after;
use crate::log::layout::Layout;
use crate::log::mcap::discovery::Discovered;
pub(crate) use crate::log::mcap::rows::Rows;

/// A file whose columns are still to be found.
pub(crate) struct Log {
    path: PathBuf,
    block: usize,
}

impl Log {
    pub(crate) fn new(path: &Path, block: usize) -> Self {
        let path = path.to_owned();
        Self { path, block }
    }

    /// Finds the columns, and reads up to the first row.
    pub(crate) fn read(
        &self,
        scene: &Scene,
        told: Option<&Columns>,
    ) -> Result<(Rows, Layout), TraceError> {
        let found = guarded("mcap", || Discovered::read(&self.path, told))?;
        let layout = Layout::read(found.headings(), told, &found.preview(), scene);
        let mut layout = layout.map_err(|mut error| {
            let proposed = error
                .proposal
                .as_ref()
                .map(|p| p.columns.parse::<Columns>());
            let others = match proposed {
                Some(Ok(proposed)) => found.others(&|topic| proposed.mentions(topic)),
                _ => Vec::new(),
            };
            let others =
                (!others.is_empty()).then(|| format!("the file has more: {}", others.join(", ")));
            for more in found.not_decoded().into_iter().chain(others) {
                error.message = format!("{} ({more})", error.message);
            }
            error
        })?;
        let has_columns = |topic: &str| found.columns.iter().any(|c| c.topic == topic);
        layout.beside.topics = found.others(&has_columns);
        let mut rows = Rows::open(
            &self.path,
            &found.columns,
            &layout,
            self.block,
            old_after(scene),
        )?;
        layout.beside.finding = rows.start()?;
        if let Some(force) = layout.force {
            layout.digits = rows.digits(force);
        }
        Ok((rows, layout))
    }

    /// The rows of this file, which goes on with a log.
    pub(crate) fn go_on(&self, before: &Rows) -> Result<Rows, TraceError> {
        before.go_on(&self.path)
    }
}
