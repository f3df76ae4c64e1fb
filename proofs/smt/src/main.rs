//! `passivity-smt write` prints the queries; `passivity-smt check FOLDER` asks both solvers.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words.as_slice() {
        ["write"] => passivity_smt::run::write(),
        ["check", folder] => passivity_smt::run::check(Path::new(folder), ""),
        ["check", folder, only] => passivity_smt::run::check(Path::new(folder), only),
        _ => Err("usage: passivity-smt write | check SOLVERS [ONLY]".to_owned()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
