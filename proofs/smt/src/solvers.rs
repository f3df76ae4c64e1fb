//! Runs z3 and cvc5 on every script and compares their answers with the expected ones.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};
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
    /// The values it gave to variables, where it was asked for them; the text that is no number.
    pub model: Result<Vec<(String, BigRational)>, String>,
    /// The time it took.
    pub seconds: f64,
}

impl Solver {
    /// The solvers of the folder that `proofs/smt/install` makes; `None` when it has not.
    #[must_use]
    pub fn installed(folder: &Path) -> Option<[Self; 2]> {
        let python = folder.join("bin/python");
        let runner = Path::new(env!("CARGO_MANIFEST_DIR")).join("run_solver.py");
        let solver = |name| {
            let mut of = Self {
                name,
                version: String::new(),
                command: [python.as_path(), &runner, Path::new(name)]
                    .map(PathBuf::from)
                    .to_vec(),
            };
            let output = of.command().ok()?.arg("--version").output().ok()?;
            let text = String::from_utf8(output.stdout).ok()?;
            let version = text
                .split_whitespace()
                .find(|word| word.starts_with(|c: char| c.is_ascii_digit()))?;
            version.clone_into(&mut of.version);
            output.status.success().then_some(of)
        };
        Some([solver("z3")?, solver("cvc5")?])
    }

    fn command(&self) -> std::io::Result<Command> {
        let (program, rest) = self
            .command
            .split_first()
            .ok_or(std::io::ErrorKind::NotFound)?;
        let mut command = Command::new(program);
        command.args(rest);
        Ok(command)
    }
}

/// One worker's way to the solvers, each of which is started once: to load them takes longer than most
/// answers do.
#[derive(Default)]
pub struct Worker {
    servers: HashMap<&'static str, Server>,
}

impl Worker {
    /// Asks a solver a script; `values` are variables whose values are wanted.
    ///
    /// # Errors
    ///
    /// When the solver cannot be started or the script not be written to `scratch`.
    pub fn run(
        &mut self,
        solver: &Solver,
        script: &Script,
        values: bool,
        scratch: &Path,
    ) -> std::io::Result<Outcome> {
        let mut text = script.text.clone();
        let values = values && !script.variables.is_empty();
        if values {
            text.push_str(&format!("(get-value ({}))\n", script.variables.join(" ")));
        }
        std::fs::create_dir_all(scratch)?;
        let file = scratch.join(format!("{}.{}.smt2", script.name, solver.name));
        std::fs::write(&file, text)?;
        let started = Instant::now();
        let server = match self.servers.entry(solver.name) {
            Entry::Occupied(server) => server.into_mut(),
            Entry::Vacant(none) => none.insert(Server::start(solver)?),
        };
        let said = server.ask(&file)?.unwrap_or_else(|| {
            self.servers.remove(solver.name);
            format!("it ended, or took more than {LIMIT} s")
        });
        let seconds = started.elapsed().as_secs_f64();
        let (first, rest) = said.split_once('\n').unwrap_or((&said, ""));
        let answer = match first.trim() {
            "sat" => Ok(Answer::Sat),
            "unsat" => Ok(Answer::Unsat),
            other => Err(other.to_owned()),
        };
        let wanted = values && answer == Ok(Answer::Sat);
        let model = if wanted { model(rest) } else { Ok(Vec::new()) };
        Ok(Outcome {
            answer,
            model,
            seconds,
        })
    }
}

/// `run_solver.py`, to which names of files are written and which says what the solver said to each.
struct Server {
    child: Child,
    said: BufReader<ChildStdout>,
}

impl Server {
    fn start(solver: &Solver) -> std::io::Result<Self> {
        let mut child = solver
            .command()?
            .arg(LIMIT.to_string())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let said = child.stdout.take().ok_or(std::io::ErrorKind::BrokenPipe)?;
        let said = BufReader::new(said);
        Ok(Self { child, said })
    }

    /// All that the solver says to a file; `None` where it ends before it has said it.
    fn ask(&mut self, file: &Path) -> std::io::Result<Option<String>> {
        let to = self.child.stdin.as_mut();
        writeln!(
            to.ok_or(std::io::ErrorKind::BrokenPipe)?,
            "{}",
            file.display()
        )?;
        let mut all = String::new();
        loop {
            let from = all.len();
            if self.said.read_line(&mut all)? == 0 {
                return Ok(None);
            }
            if all[from..].trim_end() == "end" {
                all.truncate(from);
                return Ok(Some(all));
            }
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // It ends where its input does.
        drop(self.child.stdin.take());
        let _ = self.child.wait();
    }
}

/// The pairs of `((x 1.0) (y (/ 1 2)))`.
fn model(text: &str) -> Result<Vec<(String, BigRational)>, String> {
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
            if let Some((name, value)) = pair.trim().split_once(char::is_whitespace) {
                pairs.push((name.to_owned(), replay::number(value)?));
            }
            current.clear();
        }
    }
    Ok(pairs)
}
