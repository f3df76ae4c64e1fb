//! Runs z3 and cvc5 on every script and compares their answers with the expected ones.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use passivity_core::BigRational;

use crate::{Answer, Script, replay};

/// Seconds that a solver may take for one script.
const LIMIT: u32 = 20;

/// A solver, and how it is started.
#[derive(Clone, Debug)]
pub struct Solver {
    /// `z3` or `cvc5`.
    pub name: &'static str,
    /// Its version.
    pub version: String,
    command: Vec<PathBuf>,
}

/// What a solver made of a script.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Its answer, or what it said instead.
    pub answer: Result<Answer, String>,
    /// The values it gave to variables, where it was asked for them.
    pub model: Vec<(String, BigRational)>,
    /// The time it took.
    pub seconds: f64,
}

impl Solver {
    /// The solvers of the folder that `proofs/smt/install` makes; `None` when it has not.
    #[must_use]
    pub fn installed(folder: &Path) -> Option<[Self; 2]> {
        let z3 = folder.join("bin/z3");
        let python = folder.join("bin/python");
        let runner = Path::new(env!("CARGO_MANIFEST_DIR")).join("run_cvc5.py");
        let version = |command: &[&Path]| {
            let (program, rest) = command.split_first()?;
            let output = Command::new(program)
                .args(rest)
                .arg("--version")
                .output()
                .ok()?;
            let text = String::from_utf8(output.stdout).ok()?;
            let version = text
                .split_whitespace()
                .find(|word| word.starts_with(|c: char| c.is_ascii_digit()))?;
            output.status.success().then(|| version.to_owned())
        };
        let z3 = Self {
            name: "z3",
            version: version(&[&z3])?,
            command: vec![z3],
        };
        let cvc5 = Self {
            name: "cvc5",
            version: version(&[&python, &runner])?,
            command: vec![python, runner],
        };
        Some([z3, cvc5])
    }

    /// Runs the solver on a script; `values` are variables whose values are wanted.
    ///
    /// # Errors
    ///
    /// When the solver cannot be started or the script not be written to `scratch`.
    pub fn run(&self, script: &Script, values: bool, scratch: &Path) -> std::io::Result<Outcome> {
        let mut text = script.text.clone();
        if values {
            text.push_str(&format!("(get-value ({}))\n", script.variables.join(" ")));
        }
        std::fs::create_dir_all(scratch)?;
        let file = scratch.join(format!("{}.{}.smt2", script.name, self.name));
        std::fs::write(&file, text)?;
        let started = Instant::now();
        let (program, rest) = self
            .command
            .split_first()
            .ok_or(std::io::ErrorKind::NotFound)?;
        let mut command = Command::new(program);
        command.args(rest);
        match self.name {
            "z3" => command.arg(format!("-T:{LIMIT}")).arg(&file),
            _ => command.arg(LIMIT.to_string()).arg(&file),
        };
        let output = command.output()?;
        let seconds = started.elapsed().as_secs_f64();
        let said = String::from_utf8_lossy(&output.stdout);
        let (first, rest) = said.split_once('\n').unwrap_or((&said, ""));
        let answer = match first.trim() {
            "sat" => Ok(Answer::Sat),
            "unsat" => Ok(Answer::Unsat),
            other => Err(
                format!("{other} {}", String::from_utf8_lossy(&output.stderr))
                    .trim()
                    .to_owned(),
            ),
        };
        let model = if values { model(rest) } else { Vec::new() };
        Ok(Outcome {
            answer,
            model,
            seconds,
        })
    }
}

/// The pairs of `((x 1.0) (y (/ 1 2)))`; a value that is no rational is left out.
fn model(text: &str) -> Vec<(String, BigRational)> {
    let inside = text.trim().trim_start_matches('(').trim_end();
    let inside = inside.strip_suffix(')').unwrap_or(inside);
    let mut pairs = Vec::new();
    let mut depth = 0;
    let mut current = String::new();
    // The first bracket was cut off above.
    for c in format!("({inside}").chars() {
        depth += i32::from(c == '(') - i32::from(c == ')');
        current.push(c);
        if depth == 0 {
            let pair = current.trim().trim_start_matches('(');
            let pair = pair.strip_suffix(')').unwrap_or(pair);
            let split = pair.trim().split_once(char::is_whitespace);
            let read = split.map(|(name, value)| (name, replay::number(value)));
            if let Some((name, Ok(value))) = read {
                pairs.push((name.to_owned(), value));
            }
            current.clear();
        }
    }
    pairs
}
