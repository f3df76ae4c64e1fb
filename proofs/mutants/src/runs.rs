//! Which tests reach a change, and whether one of them notices.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{scope, sleep};
use std::time::{Duration, Instant};

use passivity_standin::mutate::{REACHED, VARIABLE};
use serde::{Deserialize, Serialize};

use crate::changes::Change;
use crate::copy::Built;
use crate::journal::Journal;
use crate::{SUBJECTS, root};

/// The most inputs of a property test, at first and for survivors that nobody explained.
pub(crate) const CASES: [u32; 2] = [24, 256];

/// No property test has so many inputs that it takes much longer, in seconds; but some it has.
const LONG: f64 = 0.25;
const FEWEST: u32 = 4;

/// A test that takes longer, in seconds, is asked only of survivors that nobody explained.
const SLOW: f64 = 2.0;

/// How long a test may take, in seconds, and in multiples of its time without a change for as many
/// inputs. What takes longer has not noticed.
const LIMIT: (f64, f64) = (2.0, 10.0);

/// After so many tests without an end no more are tried: at first, and where nobody has explained that
/// there was none, of which another test may well notice something.
const MOST_TIMEOUTS: (u32, u32) = (2, 16);

/// What a test may take of memory, in KiB: a change can make a list grow without end.
const MEMORY: &str = "3000000";

/// What became of a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub(crate) enum Outcome {
    Noticed,
    Survived,
    TimedOut,
    /// It does not compile.
    Unviable,
}

/// A test with what it reaches and the seconds that it takes on as many inputs as it has at first,
/// while nothing is changed.
#[derive(Deserialize, Serialize)]
pub(crate) struct Test {
    /// The crate whose test it is.
    pub(crate) subject: usize,
    program: PathBuf,
    pub(crate) name: String,
    reached: BTreeSet<u32>,
    pub(crate) seconds: f64,
}

impl Test {
    /// How many inputs it has where so many are asked for.
    fn cases(&self, most: u32) -> u32 {
        (FEWEST..=most)
            .rev()
            .find(|n| f64::from(*n) * self.seconds <= f64::from(CASES[0]) * LONG)
            .unwrap_or(FEWEST)
    }
}

/// What [`recorded`] has found, or found before with the same changes, sources and tests.
pub(crate) fn known(built: &Built, journal: &Journal, folder: &Path) -> Result<Vec<Test>, String> {
    let path = folder.join("tests.json");
    let key = (journal.of(), &built.functions, &built.programs);
    let key = serde_json::to_string(&key).map_err(|e| e.to_string())?;
    if let Ok(text) = fs::read_to_string(&path) {
        let (of, tests): (String, Vec<Test>) =
            serde_json::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))?;
        if of == key {
            return Ok(tests);
        }
    }
    let tests = recorded(built, folder)?;
    let text = serde_json::to_string(&(key, &tests)).map_err(|e| e.to_string())?;
    fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(tests)
}

/// Runs each test without a change: it must pass.
fn recorded(built: &Built, folder: &Path) -> Result<Vec<Test>, String> {
    let mut tests = Vec::new();
    let record = folder.join("reached.txt");
    for (subject, program) in &built.programs {
        let failed = |e: std::io::Error| format!("{}: {e}", program.display());
        let listed = Command::new(program)
            .args(["--list", "--format", "terse"])
            .output()
            .map_err(failed)?;
        let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
        for name in listed
            .lines()
            .filter_map(|line| line.strip_suffix(": test"))
        {
            fs::write(&record, "").map_err(failed)?;
            let mut test = Test {
                subject: *subject,
                program: program.clone(),
                name: name.to_owned(),
                reached: BTreeSet::new(),
                seconds: f64::INFINITY,
            };
            let started = Instant::now();
            let mut command = command(&test, CASES[0]);
            command.env(REACHED, &record);
            if run(&mut command, None)? != Outcome::Survived {
                return Err(format!(
                    "{name} of {} fails without a change",
                    program.display()
                ));
            }
            test.seconds = started.elapsed().as_secs_f64();
            let reached = fs::read_to_string(&record).map_err(failed)?;
            test.reached = reached
                .lines()
                .filter_map(|line| line.parse().ok())
                .collect();
            tests.push(test);
        }
    }
    Ok(tests)
}

/// The changes with the tests.
pub(crate) struct Runs<'a> {
    built: &'a Built,
    tests: &'a [Test],
    journal: &'a Journal,
    /// How often a test has noticed changes of a function, and of a file.
    noticed: Mutex<BTreeMap<(String, usize), u32>>,
}

impl<'a> Runs<'a> {
    pub(crate) const fn new(built: &'a Built, tests: &'a [Test], journal: &'a Journal) -> Self {
        Self {
            built,
            tests,
            journal,
            noticed: Mutex::new(BTreeMap::new()),
        }
    }

    /// Tries the changes of which the journal does not know what the tests say on so many inputs.
    pub(crate) fn each(&self, changes: &[Change], cases: u32, jobs: usize) -> Result<(), String> {
        let open = |change: &&Change| !self.journal.has(&change.name, cases);
        let changes: Vec<&Change> = changes.iter().filter(open).collect();
        let next = AtomicUsize::new(0);
        let work = || {
            while let Some(change) = changes.get(next.fetch_add(1, Ordering::Relaxed)) {
                let started = Instant::now();
                let found = self.tried(change, cases)?;
                let seconds = started.elapsed().as_secs_f64();
                let test = found.1.map_or("", |test| &test.name);
                println!(
                    "{:<9} {seconds:>5.1} s  {}  {test}",
                    format!("{:?}", found.0),
                    change.name
                );
                self.journal.add(&change.name, found, cases, seconds)?;
            }
            Ok(())
        };
        scope(|scope| {
            let workers: Vec<_> = (0..jobs).map(|_| scope.spawn(work)).collect();
            let mut ends = workers
                .into_iter()
                .map(|worker| worker.join().expect("no panic"));
            ends.try_for_each(|end| end)
        })
    }

    /// Whether a test notices a change. Those come first that noticed others beside it, then the
    /// quick ones; where it came to no end at first, the quick ones.
    fn tried(&self, change: &Change, cases: u32) -> Result<(Outcome, Option<&'a Test>), String> {
        let function = self.built.functions.get(&change.number);
        let function = *function.ok_or_else(|| format!("{} has no switch", change.name))?;
        let keys = [function.to_string(), change.file.clone()];
        let mut tests: Vec<(usize, &'a Test)> = self.tests.iter().enumerate().collect();
        tests.retain(|(_, test)| test.reached.contains(&function));
        // What is as quick as at first, and has no more inputs, says the same again.
        let is_slow = |test: &Test| test.seconds > SLOW;
        let ended = self.journal.outcome(&change.name) != Some(Outcome::TimedOut);
        tests.retain(|(_, test)| match cases == CASES[0] {
            true => !is_slow(test),
            false => !ended || is_slow(test) || test.cases(cases) > CASES[0],
        });
        {
            let noticed = self.noticed.lock().expect("no thread fails");
            let often = |key: &String, i| noticed.get(&(key.clone(), i)).copied().unwrap_or(0);
            tests.sort_by(|&(i, a), &(j, b)| {
                // With a change that came to no end at first, a quick one may still come to its own.
                let of = |i| {
                    keys.each_ref()
                        .map(|key| if ended { often(key, i) } else { 0 })
                };
                of(j).cmp(&of(i)).then(a.seconds.total_cmp(&b.seconds))
            });
        }
        let most_timeouts = if ended {
            MOST_TIMEOUTS.0
        } else {
            MOST_TIMEOUTS.1
        };
        let mut timeouts = 0;
        for (i, test) in tests {
            let cases = test.cases(cases);
            let more = (f64::from(cases) / f64::from(CASES[0])).max(1.0);
            let limit = Duration::from_secs_f64(LIMIT.0 + LIMIT.1 * more * test.seconds);
            let mut command = command(test, cases);
            command.env(VARIABLE, change.number.to_string());
            match run(&mut command, Some(limit))? {
                Outcome::Survived | Outcome::Unviable => {}
                Outcome::Noticed => {
                    let mut noticed = self.noticed.lock().expect("no thread fails");
                    for key in keys {
                        *noticed.entry((key, i)).or_default() += 1;
                    }
                    return Ok((Outcome::Noticed, Some(test)));
                }
                Outcome::TimedOut => timeouts += 1,
            }
            if timeouts == most_timeouts {
                break;
            }
        }
        let outcome = if timeouts == 0 {
            Outcome::Survived
        } else {
            Outcome::TimedOut
        };
        Ok((outcome, None))
    }
}

/// How many seconds of a processor a test may take: more than it is waited for, so that only one
/// whose gate was stopped ends by it.
const SECONDS: &str = "3600";

/// A run of one test. The inputs that are drawn are the same each time.
fn command(test: &Test, cases: u32) -> Command {
    let mut command = Command::new("sh");
    let limits = "ulimit -v $0 && ulimit -t $1 && shift && exec \"$@\"";
    command
        .args(["-c", limits, MEMORY, SECONDS])
        .arg(&test.program)
        .args(["--exact", &test.name, "--test-threads", "1"])
        .env("PROPTEST_CASES", cases.to_string())
        .env("PROPTEST_RNG_SEED", "1")
        .env("PROPTEST_MAX_SHRINK_ITERS", "0")
        .env("RUST_BACKTRACE", "0")
        // What a function with many changes keeps on the stack.
        .env("RUST_MIN_STACK", "67108864")
        .env_remove("PASSIVITY_EVIDENCE_DIR")
        .current_dir(root().join(SUBJECTS[test.subject].folder))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    command
}

/// How a run ended. One that took all the memory it may is one without an end.
fn run(command: &mut Command, limit: Option<Duration>) -> Result<Outcome, String> {
    let failed = |e: std::io::Error| format!("a test cannot be run: {e}");
    let mut child = command.spawn().map_err(failed)?;
    let started = Instant::now();
    let mut pause = Duration::from_millis(1);
    loop {
        if let Some(status) = child.try_wait().map_err(failed)? {
            return Ok(if status.success() {
                Outcome::Survived
            } else if said(&mut child)?.contains("memory allocation of") {
                Outcome::TimedOut
            } else {
                Outcome::Noticed
            });
        }
        if limit.is_some_and(|limit| started.elapsed() > limit) {
            child.kill().map_err(failed)?;
            child.wait().map_err(failed)?;
            return Ok(Outcome::TimedOut);
        }
        sleep(pause);
        pause = (pause * 2).min(Duration::from_millis(16));
    }
}

fn said(child: &mut Child) -> Result<String, String> {
    let mut said = Vec::new();
    let stderr = child
        .stderr
        .as_mut()
        .ok_or("a test without a standard error")?;
    stderr
        .read_to_end(&mut said)
        .map_err(|e| format!("what a test said: {e}"))?;
    Ok(String::from_utf8_lossy(&said).into_owned())
}
