//! `proofs/README.md`: claims and evidence in tables.

use std::fmt::Write as _;

use passivity_evidence::{Claim, Claims, Engine, Evidence, Mutation, Outcome, Record, RunOutcome};

/// The engines that count as evidence, a column each.
const COLUMNS: [Engine; 5] = [
    Engine::Smt,
    Engine::Rocq,
    Engine::Kani,
    Engine::StandIn,
    Engine::Tests,
];

/// The text of `proofs/README.md`.
#[must_use]
pub fn table(claims: &Claims, evidence: &Evidence) -> String {
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
            let _ = write!(text, " {} |", cell(evidence.find(&claim.id, engine)));
        }
        let _ = writeln!(
            text,
            " {} | {} |",
            list(&claim.assumptions),
            list(&claim.caveats)
        );
    }
    engines(&mut text, evidence);
    mutation(&mut text, evidence.mutation.as_ref());
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
    text
}

/// What an engine says of a claim, and by how many parts.
fn cell(record: Option<&Record>) -> String {
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
    format!(
        "{words}{scope} ({count} {})",
        if count == 1 { one } else { many }
    )
}

fn engines(text: &mut String, evidence: &Evidence) {
    text.push_str(
        "\n## What ran\n\n| engine | tool | parts | seconds, all parts |\n| --- | --- | --- | --- |\n",
    );
    for run in &evidence.runs {
        let name = run.engine.words();
        let tools: Vec<String> = run.tools.iter().map(ToString::to_string).collect();
        let at = run
            .commit
            .as_ref()
            .map_or_else(String::new, |commit| format!(", at commit {commit}"));
        let _ = match &run.outcome {
            RunOutcome::NotRun(why) => writeln!(
                text,
                "| {name} | **not run here**: {} | – | – |",
                escaped(why)
            ),
            RunOutcome::Ran { parts, seconds } => writeln!(
                text,
                "| {name} | {}{at} | {parts} | {seconds:.0} |",
                escaped(&tools.join(", ")),
            ),
        };
    }
    text.push_str(
        "\nPrusti's contracts stand in the sources of the kernel. While nothing runs them they are \
         comments, and no claim counts them.\n",
    );
}

fn mutation(text: &mut String, mutation: Option<&Mutation>) {
    text.push_str("\n## Mutants\n\n");
    let Some(mutation) = mutation else {
        text.push_str("`make mutate`: not run here.\n");
        return;
    };
    let files: Vec<String> = mutation.sources.keys().map(|f| format!("`{f}`")).collect();
    let _ = writeln!(
        text,
        "{} changed {}, and no other file, in {} places so that they compile; the property tests noticed {}.",
        mutation.tool,
        files.join(", "),
        mutation.mutants,
        mutation.caught,
    );
    if mutation.survivors.is_empty() {
        return;
    }
    text.push_str("The others change nothing of what is computed:\n\n");
    text.push_str("| mutant | why no test can notice it |\n| --- | --- |\n");
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
and caveats, to the sources of its code, and to the harnesses, queries, tests or theorems that were run: `cargo run -p passivity-collect -- stale` lists the records that no longer speak of what is there.
";
