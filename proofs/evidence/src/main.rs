//! `passivity-collect`: gathers records, makes the table, finds what is stale.
#![allow(clippy::print_stdout)]

use std::path::Path;
use std::process::ExitCode;

use passivity_collect::imported::Imported;
use passivity_collect::{COMMITTED, collect, mutants, root, table, tools};
use passivity_evidence::{
    Claims, Engine, Evidence, EvidenceError, Freshness, Outcome, RunOutcome, assess, in_tree, read,
};

const USAGE: &str = "usage: passivity-collect collect FOLDER OUT | commit EVIDENCE | mutants FOLDER | import | table | stale | needed";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words.as_slice() {
        ["collect", folder, out] => gather(Path::new(folder), Path::new(out)),
        ["commit", evidence] => commit(Path::new(evidence)),
        ["mutants", folder] => judge_mutants(folder),
        ["import"] => import(),
        ["table"] => write_table(),
        ["stale"] => stale(),
        ["needed"] => needed(),
        _ => Err(EvidenceError::new(USAGE)),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The evidence in a file.
fn evidence_in(path: &Path) -> Result<Evidence, EvidenceError> {
    Evidence::parse(&path.display().to_string(), &read(path)?)
}

/// What failed in the evidence, a line each.
fn failures(evidence: &Evidence) -> Vec<String> {
    let failures = evidence.records.iter().filter_map(|record| {
        let Outcome::Failed(failures) = &record.outcome else {
            return None;
        };
        let lines: Vec<String> = failures
            .iter()
            .map(|f| format!("{}: {f}", record.id()))
            .collect();
        Some(lines.join("\n"))
    });
    failures.collect()
}

/// Gathers the records, says what they show, and fails when an engine did not show what it ran for.
fn gather(folder: &Path, out: &Path) -> Result<(), EvidenceError> {
    let evidence = collect(&root(), folder, &Claims::read(&root())?)?;
    write(out, &evidence.to_text()?)?;
    for run in &evidence.runs {
        let engine = run.engine.words();
        match &run.outcome {
            RunOutcome::NotRun(why) => println!("{engine:<20} not run here: {why}"),
            RunOutcome::Ran { parts, seconds } => {
                println!(
                    "{engine:<20} {parts} parts, {seconds:.0} s ({})",
                    tools(run)
                );
            }
        }
    }
    println!("{} records in {}", evidence.records.len(), out.display());
    let failures = failures(&evidence);
    if failures.is_empty() {
        Ok(())
    } else {
        Err(EvidenceError::new(failures.join("\n")))
    }
}

/// Makes an evidence file the committed one, and the table from it.
fn commit(path: &Path) -> Result<(), EvidenceError> {
    let evidence = evidence_in(path)?;
    let failures = failures(&evidence);
    if !failures.is_empty() {
        return Err(EvidenceError::new(failures.join("\n")));
    }
    write(&root().join(COMMITTED), &evidence.to_text()?)?;
    write_table()
}

/// Puts what the model checker said elsewhere into the committed evidence, and makes the table.
fn import() -> Result<(), EvidenceError> {
    let path = root().join(COMMITTED);
    let imported = Imported::read(&root())?
        .ok_or_else(|| EvidenceError::new("`make prove-kani REPORT=… COMMIT=…` comes first"))?;
    let mut evidence = evidence_in(&path)?;
    imported.put_into(&root(), &Claims::read(&root())?, &mut evidence)?;
    write(&path, &evidence.to_text()?)?;
    println!(
        "{} is in {COMMITTED} and proofs/README.md",
        imported.words()
    );
    write_table()
}

fn write_table() -> Result<(), EvidenceError> {
    let evidence = evidence_in(&root().join(COMMITTED))?;
    let claims = Claims::read(&root())?;
    let text = table(&claims, &evidence, |path| in_tree(&root(), path))?;
    write(&root().join("proofs/README.md"), &text)
}

/// Compares the survivors of a mutation run with the explained ones; writes `last.json`. Fails on
/// survivors that nobody explained.
fn judge_mutants(folder: &str) -> Result<(), EvidenceError> {
    let explained = mutants::Explained::read(&root())?;
    let (mutation, faults) = mutants::judge(&root(), Path::new(folder), &explained)?;
    let searching = mutation
        .searches
        .iter()
        .map(|search| search.survivors.len());
    println!(
        "{} mutants compile ({} do not, {} were left out), {} noticed, {} explained survivors, {} in \
         functions that only search, {} open",
        mutation.mutants,
        mutation.unviable,
        mutation.left_out.len(),
        mutation.caught,
        mutation.survivors.len(),
        searching.sum::<usize>(),
        mutation.open.len()
    );
    let text = serde_json::to_string_pretty(&mutation)
        .map_err(|error| EvidenceError::within(mutants::LAST, error))?;
    write(&root().join(mutants::LAST), &format!("{text}\n"))?;
    if faults.is_empty() {
        return Ok(());
    }
    Err(EvidenceError::new(faults.join("\n")))
}

/// Lists the committed records whose claim or sources have changed; fails when there are any.
fn stale() -> Result<(), EvidenceError> {
    let claims = Claims::read(&root())?;
    let evidence = evidence_in(&root().join(COMMITTED))?;
    let now = |path: &str| in_tree(&root(), path);
    let mut stale = 0;
    for record in &evidence.records {
        if claims.find(&record.claim).is_none() {
            stale += 1;
            println!("{}: the claim is gone", record.id());
        }
    }
    for assessed in assess(&claims, &evidence, now)? {
        if matches!(assessed.freshness, Freshness::Stale(_)) {
            stale += 1;
            println!("{}: {}", assessed.id(), assessed.freshness);
        }
    }
    if let Some(mutation) = &evidence.mutation {
        let changes = mutation.changes(now)?;
        if !changes.is_empty() {
            stale += 1;
            println!("mutants: {}", Freshness::Stale(changes));
        }
    }
    println!("{stale} of {} records are stale", evidence.records.len());
    if stale == 0 {
        Ok(())
    } else {
        Err(EvidenceError::new("run `proofs/prove --commit`"))
    }
}

/// Lists the engines that have to run before the committed evidence speaks of what is there.
fn needed() -> Result<(), EvidenceError> {
    let evidence = evidence_in(&root().join(COMMITTED))?;
    let now = |path: &str| in_tree(&root(), path);
    let all = assess(&Claims::read(&root())?, &evidence, now)?;
    for engine in Engine::ALL {
        let of_engine = all.iter().filter(|assessed| assessed.engine == engine);
        if of_engine
            .clone()
            .any(|assessed| assessed.freshness != Freshness::Fresh)
        {
            println!("{engine}");
        }
    }
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<(), EvidenceError> {
    std::fs::write(path, text).map_err(|error| EvidenceError::io(path, &error))
}
