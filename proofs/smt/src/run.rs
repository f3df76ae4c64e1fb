//! Writes the scripts, and checks them with both solvers.
#![allow(clippy::print_stdout)] // this is what the program prints

use std::collections::BTreeMap;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use serde_json::json;

use crate::solvers::{Outcome, Solver, Worker};
use crate::{Answer, Query, Script, claims, replay};

/// A statement, one of its scripts, and who is asked.
type Question<'a> = (&'a Query, Script, &'a Solver);

/// Solvers that run at a time.
const WORKERS: usize = 2;

/// The folder of the committed scripts.
#[must_use]
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("queries")
}

/// Every script's file name and text, as the code has it now.
#[must_use]
pub fn texts() -> BTreeMap<String, String> {
    let scripts = claims::all().into_iter().flat_map(|query| query.scripts());
    scripts
        .map(|script| (format!("{}.smt2", script.name), script.text))
        .collect()
}

/// Writes the scripts, and removes those that no query has any more.
///
/// # Errors
///
/// A sentence, when a file cannot be written.
pub fn write() -> Result<(), String> {
    let folder = folder();
    let texts = texts();
    let io = |e: std::io::Error| format!("{}: {e}", folder.display());
    std::fs::create_dir_all(&folder).map_err(io)?;
    for entry in std::fs::read_dir(&folder).map_err(io)? {
        let path = entry.map_err(io)?.path();
        let name = path
            .file_name()
            .map(|n| n.to_string_lossy().into_owned())
            .unwrap_or_default();
        if name.ends_with(".smt2") && !texts.contains_key(&name) {
            std::fs::remove_file(&path).map_err(io)?;
        }
    }
    for (name, text) in texts {
        std::fs::write(folder.join(name), text).map_err(io)?;
    }
    Ok(())
}

/// Asks both solvers every question whose name has `only` in it.
///
/// # Errors
///
/// A sentence, when a solver is not there, or gives another answer than the expected one.
pub fn check(solvers: &Path, only: &str) -> Result<(), String> {
    let Some(solvers) = Solver::installed(solvers) else {
        return Err(format!(
            "not run here: no z3 and cvc5 in {}; `proofs/smt/install` puts them there",
            solvers.display()
        ));
    };
    let started = Instant::now();
    let scratch = std::env::temp_dir().join(format!("passivity-smt-{}", std::process::id()));
    let queries = claims::all();
    let questions: Vec<Question<'_>> = queries
        .iter()
        .flat_map(|query| {
            query
                .scripts()
                .into_iter()
                .map(move |script| (query, script))
        })
        .filter(|(_, script)| script.name.contains(only))
        .flat_map(|(query, script)| solvers.iter().map(move |s| (query, script.clone(), s)))
        .collect();
    let next = AtomicUsize::new(0);
    let faults = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..WORKERS {
            scope.spawn(|| {
                let mut worker = Worker::default();
                while let Some(question) = questions.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if let Err(fault) = ask(&mut worker, question, &scratch) {
                        faults
                            .lock()
                            .unwrap_or_else(PoisonError::into_inner)
                            .push(fault);
                    }
                }
            });
        }
    });
    let _ = std::fs::remove_dir_all(&scratch);
    let faults = faults.into_inner().unwrap_or_else(PoisonError::into_inner);
    println!(
        "{} questions of {} statements, each to z3 {} and cvc5 {}: {} faults, {:.0} s",
        questions.len() / solvers.len(),
        queries.len(),
        solvers[0].version,
        solvers[1].version,
        faults.len(),
        started.elapsed().as_secs_f64()
    );
    if faults.is_empty() && !questions.is_empty() {
        Ok(())
    } else {
        Err(faults.join("\n"))
    }
}

/// Asks one solver one question.
fn ask(
    worker: &mut Worker,
    (query, script, solver): &Question<'_>,
    scratch: &Path,
) -> Result<(), String> {
    let values = script.expected == Answer::Sat;
    let outcome = worker
        .run(solver, script, values, scratch)
        .map_err(|e| format!("{}: {e}", solver.name))?;
    let fault = judge(script, &outcome);
    report(query, script, solver, &outcome, fault.as_deref())?;
    match fault {
        Some(fault) => Err(format!("{} ({}): {fault}", script.name, solver.name)),
        None => Ok(()),
    }
}

/// What is wrong with an answer, if anything.
fn judge(script: &Script, outcome: &Outcome) -> Option<String> {
    match &outcome.answer {
        Ok(answer) if *answer != script.expected => Some(format!(
            "answered {}, expected {}",
            answer.word(),
            script.expected.word()
        )),
        Ok(Answer::Sat) => match &outcome.model {
            Ok(model) => replay::confirms(script, model).err(),
            Err(said) => Some(format!("gave a model that is not read: {said}")),
        },
        Ok(Answer::Unsat) => None,
        Err(said) => Some(format!("gave no answer: {said}")),
    }
}

/// Prints a line, and appends a record where `PASSIVITY_EVIDENCE_DIR` says.
fn report(
    query: &Query,
    script: &Script,
    solver: &Solver,
    outcome: &Outcome,
    fault: Option<&str>,
) -> Result<(), String> {
    let Outcome { seconds, model, .. } = outcome;
    let values: Vec<String> = model
        .iter()
        .flatten()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    println!(
        "{:<44} {:<5} {:>6.2} s  {}{}",
        script.name,
        solver.name,
        seconds,
        fault.unwrap_or(script.expected.word()),
        if values.is_empty() {
            String::new()
        } else {
            format!("  {}", values.join(", "))
        },
    );
    let Some(folder) = std::env::var_os("PASSIVITY_EVIDENCE_DIR") else {
        return Ok(());
    };
    let record = json!({
        "engine": solver.name,
        "version": solver.version,
        "claim": query.claim,
        "says": query.says,
        "source": query.source,
        "script": script.name,
        "expected": script.expected.word(),
        "passed": fault.is_none(),
        "fault": fault,
        "model": values,
        "seconds": (seconds * 1000.0).round() / 1000.0,
    });
    let folder = PathBuf::from(folder);
    std::fs::create_dir_all(&folder)
        .and_then(|()| {
            std::fs::OpenOptions::new()
                .create(true)
                .append(true)
                .open(folder.join("smt.jsonl"))
        })
        .and_then(|mut file| file.write_all(format!("{record}\n").as_bytes()))
        .map_err(|e| format!("cannot write the record: {e}"))
}
