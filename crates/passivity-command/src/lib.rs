//! The command `passivity`, which connects the command line with the libraries that do the work.
//!
//! It is a library so that it can be built for its size. The program is `passivity-cli`: with its settings the compiler
//! optimises once more what all libraries have, and with them the loops over the rows of a log.

mod args;
mod exit;
mod files;
mod output;
#[cfg(any(feature = "audit", feature = "plot", feature = "simulate"))]
mod picture;
#[cfg(any(feature = "identify", feature = "simulate"))]
mod progress;
#[cfg(feature = "audit")]
mod typed;
mod verbs;

use clap::Parser as _;

/// Frees a large block, of which nothing was used.
///
/// The GNU C library asks the system for each block that is larger than any which was freed before, and gives memory back
/// once twice as much is free: new memory for each stretch of a log would take longer than to read its numbers. Others
/// do nothing but to take and free it.
fn keep_freed_memory() {
    const LARGEST: usize = 16 << 20;
    let mut block = Vec::<u8>::new();
    // Where there is not as much memory, there is none to be kept.
    let _ = block.try_reserve_exact(LARGEST);
    drop(std::hint::black_box(block));
}

/// Gives the help or the version that was asked for, or says what is wrong with the arguments: without colours
/// where these have characters that a terminal would obey.
fn answer(error: &clap::Error) -> std::process::ExitCode {
    let mut words = std::env::args_os().map(|word| word.to_string_lossy().into_owned());
    if error.use_stderr() && words.any(|word| word.contains(output::is_hidden)) {
        output::tell(&error.render().to_string());
    } else {
        // As where nobody reads: there is nothing else to say it on.
        let _ = error.print();
    }
    match error.exit_code() {
        0 => exit::Exit::Holds.into(),
        _ => exit::Exit::BadInput.into(),
    }
}

/// Does what the arguments of the process ask for, and gives the code to exit with.
///
/// # Example
///
/// ```no_run
/// fn main() -> std::process::ExitCode {
///     passivity_command::run()
/// }
/// ```
#[must_use]
pub fn run() -> std::process::ExitCode {
    keep_freed_memory();
    let args = match args::Args::try_parse() {
        Ok(args) => args,
        Err(error) => return answer(&error),
    };
    match verbs::run(&args.command) {
        Ok(exit) => exit.into(),
        Err(failure) => failure.report(),
    }
}
