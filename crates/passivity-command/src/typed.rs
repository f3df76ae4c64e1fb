//! The command that was typed, with another way to read its logs.

use std::fmt::Display;

use passivity_audit::{Proposal, TraceError, notation_options, shell_word};

use crate::exit::Failure;

/// Why a log is refused, with the command that reads it as it seems to be meant. Of several files the error names its own.
pub(crate) fn refusal(log: impl Display, error: &TraceError) -> Failure {
    let why = match error.file {
        Some(_) => error.to_string(),
        None => format!("{log}: {error}"),
    };
    Failure::input(match &error.proposal {
        Some(proposal) => format!("{why} {}", run(proposal)),
        None => why,
    })
}

/// The command that was typed, with everything that it says but how its logs are read: as is proposed. Where the header
/// leaves something open, such as whether a column is a clock, all ways.
pub(crate) fn run(proposal: &Proposal) -> String {
    let run = format!("run: {}", command(proposal, &proposal.columns));
    proposal.otherwise.iter().fold(run, |run, other| {
        let command = command(proposal, &other.columns);
        format!("{run} (or, where {}: {command})", other.condition)
    })
}

fn command(proposal: &Proposal, columns: &str) -> String {
    let typed = std::env::args_os().skip(1);
    let typed = typed.map(|word| word.to_string_lossy().into_owned());
    let words = proposed(typed, read_as(proposal, columns));
    let words: Vec<String> = words.iter().map(|word| shell_word(word)).collect();
    format!("passivity {}", words.join(" "))
}

/// What was typed, with other words about how logs are read.
fn proposed(mut typed: impl Iterator<Item = String>, read_as: Vec<String>) -> Vec<String> {
    let mut words = Vec::new();
    // What follows two hyphens is no option.
    let mut rest = None;
    while let Some(word) = typed.next() {
        match word.split('=').next().unwrap_or_default() {
            "--" => {
                rest = Some(word);
                break;
            }
            name @ ("--columns" | "--delimiter") if word == name => drop(typed.next()),
            "--columns" | "--delimiter" | "--decimal-comma" => {}
            _ => words.push(word),
        }
    }
    words.extend(read_as);
    words.extend(rest.into_iter().chain(typed));
    words
}

/// The words of a command that read the columns and fields as they are proposed.
fn read_as(proposal: &Proposal, columns: &str) -> Vec<String> {
    let mut words = vec!["--columns".to_owned(), columns.to_owned()];
    words.extend(notation_options(proposal.delimiter, proposal.decimal_comma));
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_but_how_logs_are_read_is_kept() {
        for (typed, expected) in [
            (
                "audit l.csv --scene s.toml --law",
                "audit l.csv --scene s.toml --law NEW",
            ),
            (
                "identify --columns x=y --force-error 1e-4 l.csv --delimiter=; --decimal-comma --inertia=free",
                "identify --force-error 1e-4 l.csv --inertia=free NEW",
            ),
            (
                "audit --scene s -- --columns",
                "audit --scene s NEW -- --columns",
            ),
        ] {
            let words = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
            let found = proposed(words(typed).into_iter(), vec!["NEW".to_owned()]);
            assert_eq!(found, words(expected), "{typed}");
        }
    }
}
