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

/// Frees a large block, of which nothing was used.
///
/// The GNU C library asks the system for each block that is larger than any which was freed before, and gives memory back
/// once twice as much is free: new memory for each stretch of a log would take longer than to read its numbers. Others
/// do nothing but to take and free it.
fn keep_freed_memory() {
    const LARGEST: usize = 16 << 20;
    drop(std::hint::black_box(Vec::<u8>::with_capacity(LARGEST)));
}

fn main() -> std::process::ExitCode {
    keep_freed_memory();
    let args = args::Args::parse();
    match verbs::run(&args.command) {
        Ok(exit) => exit.into(),
        Err(failure) => failure.report(),
    }
}
