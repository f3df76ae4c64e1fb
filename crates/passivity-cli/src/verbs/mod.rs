//! One file per verb.

pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod explain;
pub(crate) mod man;
pub(crate) mod oracle;
pub(crate) mod plane;

use crate::args::Command;
use crate::exit::{Exit, Failure};

/// Runs a verb.
pub(crate) fn run(command: &Command) -> Result<Exit, Failure> {
    match command {
        Command::Check(args) => check::run(args),
        Command::Explain(args) => explain::run(args),
        Command::Plane(args) => plane::run(args),
        Command::Oracle(args) => oracle::run(args),
        Command::Completions(args) => completions::run(args),
        Command::Man(args) => man::run(args),
    }
}
