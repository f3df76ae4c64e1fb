//! `passivity completions`: completions for a shell.

use clap::CommandFactory as _;

use crate::exit::{Exit, Failure};
use crate::output::emit;

/// Print completions for a shell.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  passivity completions bash > /etc/bash_completion.d/passivity")]
pub(crate) struct Args {
    /// The shell.
    shell: clap_complete::Shell,
}

/// Writes the completions to standard output.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let mut text = Vec::new();
    let mut command = crate::args::Args::command();
    clap_complete::generate(args.shell, &mut command, "passivity", &mut text);
    emit(&String::from_utf8_lossy(&text))?;
    Ok(Exit::Holds)
}
