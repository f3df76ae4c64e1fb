//! `proofs/README.md`: claims and evidence in tables.

use std::fmt::Write as _;

use passivity_evidence::{
    Change, Claim, Claims, Engine, Evidence, EvidenceError, Freshness, Mutation, Now, Outcome,
    Record, Run, RunOutcome, assess,
};

/// The engines that count as evidence, a column each.
const COLUMNS: [Engine; 5] = [
    Engine::Smt,
    Engine::Rocq,
    Engine::Kani,
    Engine::StandIn,
    Engine::Tests,
];

/// The text of `proofs/README.md`: what speaks of other sources than those that `now` gives is
/// called stale.
///
/// # Errors
///
/// A source that cannot be looked up, and a claim that refers to what is not there.
pub fn table(
    claims: &Claims,
    evidence: &Evidence,
    now: impl Fn(&str) -> Result<Now, EvidenceError>,
) -> Result<String, EvidenceError> {
    let assessed = assess(claims, evidence, &now)?;
    let changes = |id: &str, engine: Engine| {
        let of = |a: &&passivity_evidence::Assessed| a.claim == id && a.engine == engine;
        match assessed.iter().find(of).map(|a| &a.freshness) {
            Some(Freshness::Stale(changes)) => changes.as_slice(),
            _ => &[],
        }
    };
    let mut text = INTRODUCTION.to_owned();
    text.push_str("\n## What is claimed\n\n| id | claim | formula | paper | code |\n| --- | --- | --- | --- | --- |\n");
    for claim in &claims.claims {
        let status = if claim.refutes {
            "**Refuted as printed.** "
        } else {
            ""
        };
        let formula = if claim.formula.is_empty() {
            String::new()
        } else {
            escaped(&claim.formula)
        };
        let _ = writeln!(
            text,
            "| {} | {status}{} | {formula} | {} | {} |",
            claim.id,
            escaped(&claim.sentence),
            escaped(&claim.equation),
            code(claim),
        );
    }
    text.push_str("\n## What shows it\n\n| id |");
    for engine in COLUMNS {
        let _ = write!(text, " {} |", engine.words());
    }
    text.push_str(" assumptions | caveats |\n| --- |");
    text.push_str(&" --- |".repeat(COLUMNS.len() + 2));
    text.push('\n');
    for claim in &claims.claims {
        let _ = write!(text, "| {} |", claim.id);
        for engine in COLUMNS {
            let _ = write!(
                text,
                " {} |",
                cell(
                    evidence,
                    evidence.find(&claim.id, engine),
                    changes(&claim.id, engine)
                )
            );
        }
        let _ = writeln!(
            text,
            " {} | {} |",
            list(&claim.assumptions),
            list(&claim.caveats)
        );
    }
    engines(&mut text, evidence);
    if let Some(run) = &evidence.mutation {
        mutation(&mut text, run, &run.changes(now)?);
    } else {
        text.push_str("\n## Mutants\n\n`make mutate`: not run here.\n");
    }
    text.push_str("\n## Assumptions\n\n| id | what is assumed | how to check it on the bench |\n| --- | --- | --- |\n");
    for assumption in &claims.assumptions {
        let _ = writeln!(
            text,
            "| {} | {} | {} |",
            assumption.id,
            escaped(&assumption.sentence),
            escaped(&assumption.check)
        );
    }
    text.push_str("\n## Caveats\n");
    for caveat in &claims.caveats {
        let _ = write!(text, "\n**{}.** {}\n", caveat.id, caveat.text);
    }
    Ok(text)
}

/// What has changed since, in a few words.
fn since(changes: &[Change]) -> String {
    const NAMED: usize = 2;
    // Code says more than what it is built by.
    let mut named: Vec<String> = changes.iter().map(ToString::to_string).collect();
    named.sort_by_key(|change| change.contains("Cargo."));
    named.truncate(NAMED);
    let more = match changes.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    format!("changed since: {}{more}", named.join(", "))
}

/// What an engine says of a claim, by how many parts, and whether that still speaks of what is there.
fn cell(evidence: &Evidence, record: Option<&Record>, changes: &[Change]) -> String {
    let Some(record) = record else {
        return "–".to_owned();
    };
    let words = record.outcome.words();
    match record.outcome {
        Outcome::NotRun(_) => return words,
        Outcome::Failed(_) => return format!("**{words}**"),
        Outcome::Shown(_) => {}
    }
    let count = record.parts.len();
    let (one, many) = record.engine.part();
    let scope = record
        .scope
        .as_ref()
        .map_or_else(String::new, |part| format!(" for *{part}*"));
    // The model checker may have run elsewhere, at a commit: its records say so.
    let tool = match evidence.run(record.engine) {
        Some(run) if run.engine == Engine::Kani => format!("; {}", tools(run)),
        _ => String::new(),
    };
    let shown = format!(
        "{words}{scope} ({count} {}{tool})",
        if count == 1 { one } else { many }
    );
    if changes.is_empty() {
        shown
    } else {
        format!("**stale**, {}; it was {shown}", since(changes))
    }
}

/// The tools of a run and, when it was made elsewhere, its commit: `Kani 0.67.0, at commit 5cb3f4e2695e`.
#[must_use]
pub fn tools(run: &Run) -> String {
    let mut words: Vec<String> = run.tools.iter().map(ToString::to_string).collect();
    if let Some(commit) = &run.commit {
        words.push(format!("at commit {}", commit.get(..12).unwrap_or(commit)));
    }
    words.join(", ")
}

fn engines(text: &mut String, evidence: &Evidence) {
    text.push_str(
        "\n## What ran\n\n| engine | tool | parts | seconds, all parts |\n| --- | --- | --- | --- |\n",
    );
    for run in &evidence.runs {
        let name = run.engine.words();
        let _ = match &run.outcome {
            RunOutcome::NotRun(why) => writeln!(
                text,
                "| {name} | **not run here**: {} | – | – |",
                escaped(why)
            ),
            RunOutcome::Ran { parts, seconds } => writeln!(
                text,
                "| {name} | {} | {parts} | {seconds:.0} |",
                escaped(&tools(run)),
            ),
        };
    }
    text.push_str(
        "\nPrusti's contracts stand in the sources of the kernel. While nothing runs them they are \
         comments, and no claim counts them.\n",
    );
}

fn mutation(text: &mut String, mutation: &Mutation, changes: &[Change]) {
    text.push_str("\n## Mutants\n\n");
    if !changes.is_empty() {
        let _ = writeln!(text, "**Stale**, {}. When it ran:\n", since(changes));
    }
    let files: Vec<String> = mutation.sources.keys().map(|f| format!("`{f}`")).collect();
    let _ = writeln!(
        text,
        "{} changed {}, and no other file, in {} places so that they compile; the property tests noticed {}.",
        mutation.tool,
        files.join(", "),
        mutation.mutants,
        mutation.caught,
    );
    if mutation.unviable > 0 {
        let _ = writeln!(
            text,
            "{} more do not compile, and {} were left out: what a constant is computed from, and functions \
             whose branches would have different types.",
            mutation.unviable,
            mutation.left_out.len(),
        );
    }
    if !mutation.open.is_empty() {
        let open: Vec<String> = mutation.open.iter().map(|m| format!("- `{m}`\n")).collect();
        let _ = writeln!(
            text,
            "\n**The gate fails**: {} were not noticed, and nobody has said why:\n\n{}",
            open.len(),
            open.concat()
        );
    }
    if !mutation.searches.is_empty() {
        text.push_str(
            "\nThese functions only look for a motion or a number that other code then checks. A change of \
             them may lose an answer, and never give a wrong one:\n\n\
             | function | not noticed | what checks its finds |\n| --- | --- | --- |\n",
        );
    }
    for search in &mutation.searches {
        let _ = writeln!(
            text,
            "| `{}` | {} | {} |",
            escaped(&search.function),
            search.survivors.len(),
            escaped(&search.checked_by)
        );
    }
    if !mutation.survivors.is_empty() {
        text.push_str(
            "\nThese change nothing of what is decided:\n\n\
             | mutant | why no test can notice it |\n| --- | --- |\n",
        );
    }
    for survivor in &mutation.survivors {
        let _ = writeln!(
            text,
            "| `{}` | {} |",
            escaped(&survivor.mutant),
            escaped(&survivor.reason)
        );
    }
}

fn code(claim: &Claim) -> String {
    let items = claim.code.iter();
    let items = items.map(|item| format!("[`{item}`](../{})", item.file()));
    items.collect::<Vec<_>>().join(", ")
}

fn list(ids: &[String]) -> String {
    if ids.is_empty() {
        "–".to_owned()
    } else {
        ids.join(", ")
    }
}

/// A bar would end the cell.
fn escaped(text: &str) -> String {
    text.replace('|', "\\|")
}

const INTRODUCTION: &str = "\
# Claims and evidence

<!-- Generated: `cargo run -p passivity-collect -- table`. Edit claims.toml, not this file. -->

What the project claims, and what machines have shown of it. The words are: *proved for all reals*
(both solvers, or the proof assistant), *proved for all inputs in* a bound (model checker), *exhausted on* a
domain (every input was run), *sampled, N cases*, *not run here*. They are used in no other sense. What
is refuted as printed is refuted by a counterexample, which solvers and harnesses find and the kernel
computes again.

Every engine but Rocq runs the kernel's own functions, not a copy: `smt/` prints its questions from
them, `kani/` calls them at a number type of bounded width, the tests at big rationals. Rocq proves
the theorem about motions, and a generated file checks that its definitions are the kernel's.

`make prove` runs all engines and writes `target/evidence.json`; `evidence.json` here is the last one
that was committed (`proofs/prove --commit`). Each record is bound by SHA-256 to the text of its claim, with its scope, assumptions
and caveats, and to every file that was read: the sources of its code and all that they call, the harness, query, test or
theorem that was run, what printed it, the lists, the manifests and the lock file. A record that speaks of
other files than those that are there is *stale*, and is called that here. `cargo run -p passivity-collect -- stale`
lists them, and `make test` fails on one that this table calls fresh.
";
