//! One file per verb.

#[cfg(not(feature = "full"))]
mod absent;
#[cfg(feature = "simulate")]
pub(crate) mod accuracy;
#[cfg(feature = "audit")]
pub(crate) mod audit;
#[cfg(feature = "case")]
pub(crate) mod case;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod design;
pub(crate) mod explain;
pub(crate) mod export;
#[cfg(feature = "identify")]
pub(crate) mod identify;
pub(crate) mod init;
pub(crate) mod man;
#[cfg(feature = "oracle")]
pub(crate) mod oracle;
#[cfg(feature = "plot")]
pub(crate) mod plane;
pub(crate) mod schema;
#[cfg(feature = "simulate")]
pub(crate) mod simulate;
#[cfg(feature = "simulate")]
pub(crate) mod sweep;
#[cfg(feature = "vectors")]
pub(crate) mod vectors;

#[cfg(not(feature = "full"))]
pub(crate) use absent::*;

use crate::args::Command;
use crate::exit::{Exit, Failure};

/// Runs a verb.
pub(crate) fn run(command: &Command) -> Result<Exit, Failure> {
    match command {
        Command::Check(args) => check::run(args),
        Command::Explain(args) => explain::run(args),
        Command::Design(args) => design::run(args),
        Command::Export(args) => export::run(args),
        Command::Init(args) => init::run(args),
        Command::Schema(args) => schema::run(args),
        Command::Simulate(args) => simulate::run(args),
        Command::Sweep(args) => sweep::run(args),
        Command::Plane(args) => plane::run(args),
        Command::Accuracy(args) => accuracy::run(args),
        Command::Audit(args) => audit::run(args),
        Command::Identify(args) => identify::run(args),
        Command::Oracle(args) => oracle::run(args),
        Command::Case(args) => case::run(args),
        Command::Vectors(args) => vectors::run(args),
        Command::Completions(args) => completions::run(args),
        Command::Man(args) => man::run(args),
    }
}
