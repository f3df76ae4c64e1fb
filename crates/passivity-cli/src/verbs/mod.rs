//! One file per verb.

pub(crate) mod accuracy;
pub(crate) mod audit;
pub(crate) mod case;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod explain;
pub(crate) mod man;
pub(crate) mod oracle;
pub(crate) mod plane;
pub(crate) mod simulate;
pub(crate) mod sweep;
pub(crate) mod vectors;

use crate::args::Command;
use crate::exit::{Exit, Failure};

/// Runs a verb.
pub(crate) fn run(command: &Command) -> Result<Exit, Failure> {
    match command {
        Command::Check(args) => check::run(args),
        Command::Explain(args) => explain::run(args),
        Command::Simulate(args) => simulate::run(args),
        Command::Sweep(args) => sweep::run(args),
        Command::Plane(args) => plane::run(args),
        Command::Accuracy(args) => accuracy::run(args),
        Command::Audit(args) => audit::run(args),
        Command::Oracle(args) => oracle::run(args),
        Command::Case(args) => case::run(args),
        Command::Vectors(args) => vectors::run(args),
        Command::Completions(args) => completions::run(args),
        Command::Man(args) => man::run(args),
    }
}
