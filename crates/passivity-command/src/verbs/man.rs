//! `passivity man`: the man page.

use clap::CommandFactory as _;

use crate::exit::{Exit, Failure};
use crate::output::emit;

/// Print the man page of the program or of one of its commands.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity man > passivity.1
  passivity man check | man -l -")]
pub(crate) struct Args {
    /// The command; by default the page of the program itself.
    #[arg(value_name = "COMMAND")]
    verb: Option<String>,
}

/// Writes the page to standard output.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let mut command = crate::args::Args::command();
    command.build();
    let page = match &args.verb {
        None => command,
        Some(verb) => {
            let found = command.find_subcommand(verb).ok_or_else(|| {
                Failure::input(format!(
                    "there is no command `{verb}`; `passivity help` lists the commands"
                ))
            })?;
            found.clone()
        }
    };
    let mut text = Vec::new();
    clap_mangen::Man::new(page)
        .render(&mut text)
        .map_err(|error| Failure::io("man page", &error))?;
    emit(&String::from_utf8_lossy(&text))?;
    Ok(Exit::Holds)
}
