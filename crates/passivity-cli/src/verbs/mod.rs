//! One file per verb.

pub(crate) mod completions;
pub(crate) mod man;

use crate::args::Command;
use crate::exit::{Exit, Failure};

/// Runs a verb.
pub(crate) fn run(command: &Command) -> Result<Exit, Failure> {
    match command {
        Command::Completions(args) => completions::run(args),
        Command::Man(args) => man::run(args),
    }
}
