//! `passivity oracle`: the line protocol.

use std::io::{BufReader, ErrorKind};

use passivity_oracle::protocol::serve;

use crate::exit::{Exit, Failure};

/// Answer requests on standard input, a JSON document a line, on standard output.
///
/// Operations: `interval` (one row of the energy ledger), `run` (rows and totals of a list of
/// positions or encoder counts), `motion` (where a constant force takes the device), `check` (the
/// verdict on a scene) and `version`. Numbers are exact. A bad line gets an answer with an `error`, and the next line is served.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  echo '{\"id\": 1, \"op\": \"interval\", \"xi0\": \"1\", \"xi1\": \"1/2\", \"beta\": \"3/5\", \"sigma\": \"3/5\"}' \\
    | passivity oracle")]
pub(crate) struct Args {}

/// How much is read at once: many requests.
const BUFFER: usize = 1 << 16;

/// Serves until the input ends.
pub(crate) fn run(_args: &Args) -> Result<Exit, Failure> {
    let input = BufReader::with_capacity(BUFFER, std::io::stdin().lock());
    let output = std::io::stdout().lock();
    match serve(input, output) {
        // Whoever asked has gone.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::io("the line protocol", &error))
        }
        _ => Ok(Exit::Holds),
    }
}
