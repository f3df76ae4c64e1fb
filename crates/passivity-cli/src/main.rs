//! The command `passivity`, which connects the command line with the libraries that do the work.

mod args;
mod exit;
mod output;
#[cfg(any(feature = "audit", feature = "simulate"))]
mod picture;
#[cfg(any(feature = "identify", feature = "simulate"))]
mod progress;
mod verbs;

use clap::Parser as _;

fn main() -> std::process::ExitCode {
    let args = args::Args::parse();
    match verbs::run(&args.command) {
        Ok(exit) => exit.into(),
        Err(failure) => failure.report(),
    }
}
