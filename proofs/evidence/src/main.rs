//! `passivity-evidence`: gathers records, makes the table, finds what is stale.
#![allow(clippy::print_stdout)]

use std::path::Path;
use std::process::ExitCode;

use passivity_evidence::imported::Imported;
use passivity_evidence::{Claims, Evidence, collect, mutants, root, table};

const USAGE: &str = "usage: passivity-evidence collect FOLDER OUT | commit EVIDENCE | mutants FOLDER... | import | table | stale";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words.as_slice() {
        ["collect", folder, out] => gather(Path::new(folder), Path::new(out)),
        ["commit", evidence] => commit(Path::new(evidence)),
        ["mutants", folders @ ..] if !folders.is_empty() => judge_mutants(folders),
        ["import"] => import(),
        ["table"] => write_table(),
        ["stale"] => stale(),
        _ => Err(USAGE.to_owned()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Gathers the records, says what they show, and fails when an engine did not show what it ran for.
fn gather(folder: &Path, out: &Path) -> Result<(), String> {
    let evidence = collect(&root(), folder, &Claims::read(&root())?)?;
    write(out, &evidence.text()?)?;
    for run in &evidence.runs {
        match &run.not_run {
            Some(why) => println!("{:<20} not run here: {why}", run.engine.words()),
            None => println!(
                "{:<20} {} parts, {:.0} s ({})",
                run.engine.words(),
                run.parts,
                run.seconds,
                run.tool
            ),
        }
    }
    let failures: Vec<String> = evidence
        .records
        .iter()
        .flat_map(|record| {
            record
                .failures
                .iter()
                .map(|f| format!("{} ({}): {f}", record.claim, record.engine))
        })
        .collect();
    println!("{} records in {}", evidence.records.len(), out.display());
    if failures.is_empty() {
        Ok(())
    } else {
        Err(failures.join("\n"))
    }
}

/// Makes an evidence file the committed one, and the table from it.
fn commit(evidence: &Path) -> Result<(), String> {
    let evidence = Evidence::read(evidence)?;
    if let Some(record) = evidence
        .records
        .iter()
        .find(|record| !record.failures.is_empty())
    {
        return Err(format!("{}: {}", record.claim, record.failures.join("; ")));
    }
    write(&root().join("proofs/evidence.json"), &evidence.text()?)?;
    write_table()
}

/// Puts what the model checker said elsewhere into the committed evidence, and makes the table.
fn import() -> Result<(), String> {
    let (root, path) = (root(), root().join("proofs/evidence.json"));
    let imported =
        Imported::read(&root)?.ok_or("`make prove-kani REPORT=… COMMIT=…` comes first")?;
    let mut evidence = Evidence::read(&path)?;
    imported.put_into(&root, &Claims::read(&root)?, &mut evidence)?;
    write(&path, &evidence.text()?)?;
    println!(
        "{} is in proofs/evidence.json and proofs/README.md",
        imported.words()
    );
    write_table()
}

fn write_table() -> Result<(), String> {
    let evidence = Evidence::read(&root().join("proofs/evidence.json"))?;
    write(
        &root().join("proofs/README.md"),
        &table(&Claims::read(&root())?, &evidence),
    )
}

/// Compares the survivors of mutation runs with the explained ones; writes `last.json`.
fn judge_mutants(folders: &[&str]) -> Result<(), String> {
    let explained = mutants::explained(&root())?;
    let folders: Vec<&Path> = folders.iter().map(Path::new).collect();
    let (mutation, faults) = mutants::judge(&root(), &folders, &explained)?;
    let text = serde_json::to_string_pretty(&mutation).map_err(|e| e.to_string())?;
    println!(
        "{} mutants compile, {} noticed, {} explained survivors",
        mutation.mutants,
        mutation.caught,
        mutation.survivors.len()
    );
    if !faults.is_empty() {
        return Err(faults.join("\n"));
    }
    write(
        &root().join("proofs/mutants/last.json"),
        &format!("{text}\n"),
    )
}

/// Lists the committed records whose claim or sources have changed; fails when there are any.
fn stale() -> Result<(), String> {
    let claims = Claims::read(&root())?;
    let evidence = Evidence::read(&root().join("proofs/evidence.json"))?;
    let imported = Imported::read(&root())?;
    let mut stale = 0;
    for record in &evidence.records {
        let mut changed = match claims.find(&record.claim) {
            Some(claim) => record.stale(&claim.sha256(), &claim.sources(&root())?),
            None => vec!["the claim is gone".to_owned()],
        };
        if let Some(imported) = &imported {
            changed.extend(imported.changed(&root(), record)?);
        }
        if !changed.is_empty() {
            stale += 1;
            println!(
                "{} ({}): changed since: {}",
                record.claim,
                record.engine,
                changed.join(", ")
            );
        }
    }
    if let Some(mutation) = &evidence.mutation {
        let changed = mutation.stale(&root())?;
        if !changed.is_empty() {
            stale += 1;
            println!("mutants: changed since: {}", changed.join(", "));
        }
    }
    println!("{stale} of {} records are stale", evidence.records.len());
    if stale == 0 {
        Ok(())
    } else {
        Err("run `make prove`, and commit its evidence".to_owned())
    }
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    std::fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))
}
