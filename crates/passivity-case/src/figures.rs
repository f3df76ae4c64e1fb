//! Pictures of a scene's motion and of its energy.

use crate::document::Block;
use crate::study::Study;

/// The motion of a scene from its start, and its energy ledger.
#[must_use]
pub fn of_motion(_study: &Study) -> Vec<Block> {
    Vec::new()
}
