//! The guides under `docs/guides`, the pages beside them and the README: every command in them runs, and says what
//! the page shows.
//!
//! In a block marked `console`, a line that starts with `$ ` is a command; the lines up to the next
//! one are its output, in which `...` stands for any text, over any number of lines.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::harness::{Dir, root};

/// The pages outside the folder of guides that show commands.
const PAGES: [&str; 5] = [
    "README.md",
    "docs/audit.md",
    "docs/devices.md",
    "docs/identify.md",
    "docs/oracle.md",
];

struct Shown {
    command: String,
    output: String,
}

/// The commands of each block, with what is shown as their output.
fn commands(guide: &str) -> Vec<Shown> {
    let mut found: Vec<Shown> = Vec::new();
    let mut within = false;
    for line in guide.lines() {
        match line {
            "```console" => within = true,
            "```" => within = false,
            _ if !within => {}
            _ => match (line.strip_prefix("$ "), found.last_mut()) {
                (Some(command), _) => {
                    found.push(Shown {
                        command: command.to_owned(),
                        output: String::new(),
                    });
                }
                (None, Some(last)) => {
                    last.output.push_str(line);
                    last.output.push('\n');
                }
                (None, None) => panic!("output without a command: {line}"),
            },
        }
    }
    found
}

/// Whether `text` is as `pattern` shows it.
fn matches(pattern: &str, text: &str) -> bool {
    let mut parts = pattern.split("...");
    let Some(mut rest) = parts.next().and_then(|first| text.strip_prefix(first)) else {
        return false;
    };
    let mut parts = parts.peekable();
    while let Some(part) = parts.next() {
        // A `...` on a line of its own takes its line break with it.
        let part = part.strip_prefix('\n').unwrap_or(part);
        if parts.peek().is_none() {
            return rest.ends_with(part);
        }
        match rest.find(part) {
            Some(at) => rest = &rest[at + part.len()..],
            None => return false,
        }
    }
    rest.is_empty()
}

#[test]
fn matching_takes_dots_for_anything_and_nothing_else() {
    assert!(matches("a\nb\n", "a\nb\n"));
    assert!(!matches("a\nb\n", "a\nb\nc\n"));
    assert!(matches("...b\n...\nd\n", "a\nb\nc\nd\n"));
    assert!(!matches("...b\n...\nd\n", "a\nb\nc\ne\n"));
    assert!(!matches("...x...\n", "a\nb\n"));
    assert!(matches(
        "{\"id\": 1, ...}\n",
        "{\"id\": 1, \"result\": 2}\n"
    ));
}

#[cfg(unix)]
#[test]
fn the_guides_show_what_the_commands_say() {
    let binary = Path::new(env!("CARGO_BIN_EXE_passivity"));
    let path = std::env::var("PATH").unwrap_or_default();
    let path = format!("{}:{path}", binary.parent().expect("a folder").display());
    let mut guides = 0;
    let entries = std::fs::read_dir(root().join("docs/guides")).expect("the guides");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.extend(PAGES.map(|page| root().join(page)));
    for file in files {
        let guide = std::fs::read_to_string(&file).expect("a guide");
        let shown = commands(&guide);
        assert!(!shown.is_empty(), "{}: shows no command", file.display());
        let dir = Dir::new();
        for shipped in ["scenes", "tests"] {
            let folder = root().join(shipped).canonicalize();
            let folder = folder.expect("a folder of the repository");
            std::os::unix::fs::symlink(folder, dir.path(shipped)).expect("a link to the folder");
        }
        let mut code = 0;
        for Shown { command, output } in shown {
            let script = format!("(exit {code}); {command}");
            let run = Command::new("sh")
                .args(["-c", &script])
                .env("PATH", &path)
                .current_dir(dir.path("."))
                .output()
                .expect("a shell");
            let text = String::from_utf8(run.stdout).expect("UTF-8");
            let errors = String::from_utf8_lossy(&run.stderr);
            assert!(
                matches(&output, &text),
                "{}: `{command}` says\n{text}{errors}\nand the guide shows\n{output}",
                file.display()
            );
            code = run.status.code().expect("the command ends by itself");
        }
        guides += 1;
    }
    assert_eq!(guides, 5 + PAGES.len());
}
