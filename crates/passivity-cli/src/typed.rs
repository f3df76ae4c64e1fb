//! The command that was typed, with another way to read its logs.

use passivity_audit::Proposal;

/// The command that was typed, with everything that it says but how its logs are read: as is proposed.
pub(crate) fn command(proposal: &Proposal) -> String {
    let typed = std::env::args_os().skip(1);
    let typed = typed.map(|word| word.to_string_lossy().into_owned());
    let words = proposed(typed, proposal);
    let words: Vec<String> = words.iter().map(|word| quoted(word)).collect();
    format!("passivity {}", words.join(" "))
}

fn proposed(typed: impl Iterator<Item = String>, proposal: &Proposal) -> Vec<String> {
    let mut typed = typed;
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
    words.extend(["--columns".to_owned(), proposal.columns.clone()]);
    if let Some(delimiter) = proposal.delimiter {
        let name = match delimiter {
            '\t' => "tab".to_owned(),
            other => other.to_string(),
        };
        words.extend(["--delimiter".to_owned(), name]);
    }
    if proposal.decimal_comma {
        words.push("--decimal-comma".to_owned());
    }
    words.extend(rest.into_iter().chain(typed));
    words
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./+:@%".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_but_how_logs_are_read_is_kept() {
        let proposal = Proposal {
            columns: "x=pos [mm]".to_owned(),
            delimiter: Some('\t'),
            decimal_comma: true,
            assumed: Vec::new(),
            others: Vec::new(),
        };
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
            let new = [
                "--columns",
                "x=pos [mm]",
                "--delimiter",
                "tab",
                "--decimal-comma",
            ];
            let expected = words(expected)
                .into_iter()
                .flat_map(|word| match word.as_str() {
                    "NEW" => new.map(str::to_owned).to_vec(),
                    _ => vec![word],
                });
            let found = proposed(words(typed).into_iter(), &proposal);
            assert_eq!(found, expected.collect::<Vec<_>>(), "{typed}");
        }
        assert_eq!(quoted("it's"), "'it'\\''s'");
    }
}
