//! From what the engines left behind to [`Evidence`].

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_evidence::{
    Claim, Claims, Evidence, EvidenceError, FORMAT, Failure, Outcome, Record, Run, RunOutcome,
    Sha256, Shown,
};

use crate::engines::{Done, Part, Ran, Report, reports};
use crate::mutants;
use crate::sources::Sources;

/// Gathers what the engines left in a folder, and the last mutation run.
///
/// # Errors
///
/// A file that is not what its engine writes, or that speaks of an unknown claim.
pub fn collect(root: &Path, folder: &Path, claims: &Claims) -> Result<Evidence, EvidenceError> {
    let reports = reports(root, folder, claims)?;
    let mut evidence = Evidence {
        format: FORMAT,
        runs: Vec::new(),
        records: Vec::new(),
        mutation: mutants::last(root)?,
    };
    for report in &reports {
        let mut mentioned = report.parts().iter().flat_map(|part| &part.claims);
        if let Some(id) = mentioned.find(|id| claims.find(id).is_none()) {
            let engine = report.engine.name();
            return Err(EvidenceError::within(
                engine,
                format!("unknown claim `{id}`"),
            ));
        }
    }
    let mut files: Vec<BTreeMap<String, Sha256>> = vec![BTreeMap::new(); reports.len()];
    for claim in &claims.claims {
        for (report, files) in reports.iter().zip(&mut files) {
            evidence
                .records
                .extend(record(root, claims, claim, report, files)?);
        }
    }
    for (report, files) in reports.into_iter().zip(files) {
        evidence.runs.push(run(report, files)?);
    }
    Ok(evidence)
}

pub(crate) fn run(report: Report, files: BTreeMap<String, Sha256>) -> Result<Run, EvidenceError> {
    let engine = report.engine;
    let (tools, commit, outcome) = match report.ran {
        Ran::No(why) => (Vec::new(), None, RunOutcome::NotRun(why)),
        Ran::Yes(done) => {
            let parts = counted(done.parts.len())?;
            let seconds = seconds(done.parts.iter());
            let outcome = RunOutcome::Ran { parts, seconds };
            (done.tools, done.commit, outcome)
        }
    };
    Ok(Run {
        engine,
        tools,
        commit,
        outcome,
        files,
    })
}

/// What an engine says of a claim, here or elsewhere; `None` when it has nothing to say and was not
/// asked to. The sums of what it rests on are added to `files`.
pub(crate) fn record(
    root: &Path,
    claims: &Claims,
    claim: &Claim,
    report: &Report,
    files: &mut BTreeMap<String, Sha256>,
) -> Result<Option<Record>, EvidenceError> {
    let engine = report.engine;
    let parts: Vec<&Part> = report
        .parts()
        .iter()
        .filter(|part| part.claims.contains(&claim.id))
        .collect();
    if parts.is_empty() && !claim.evidence.contains(&engine) {
        return Ok(None);
    }
    let scope = claim.scope.get(&engine).cloned();
    let (outcome, scope, statement, sources) = match &report.ran {
        Ran::No(why) => (
            Outcome::NotRun(why.clone()),
            scope,
            claims.statement(claim, engine)?,
            BTreeSet::new(),
        ),
        Ran::Yes(
            done @ Done {
                imported: Some(imported),
                ..
            },
        ) => {
            let (scope, statement, sums) = match imported.bound(&claim.id, rested_on(done, &parts))
            {
                Some((then, sums)) => (then.scope.clone(), then.statement, sums),
                None => (scope, claims.statement(claim, engine)?, BTreeMap::new()),
            };
            let sources = sums.keys().cloned().collect();
            files.extend(sums);
            (outcome(&parts)?, scope, statement, sources)
        }
        Ran::Yes(done) => {
            let tree = Sources::new(root, done.commit.clone());
            let sources = bound(claim, done, &parts);
            for path in &sources {
                if !files.contains_key(path) {
                    files.insert(path.clone(), tree.sum(path)?);
                }
            }
            (
                outcome(&parts)?,
                scope,
                statement(&tree, claims, claim, done, report)?,
                sources,
            )
        }
    };
    let cases: u64 = parts.iter().filter_map(|part| part.cases).sum();
    let mut domains: Vec<String> = parts
        .iter()
        .filter_map(|part| part.domain.clone())
        .collect();
    domains.dedup();
    Ok(Some(Record {
        claim: claim.id.clone(),
        engine,
        outcome,
        scope,
        domains,
        cases: (cases > 0).then_some(cases),
        seconds: seconds(parts.iter().copied()),
        parts: parts.iter().map(|part| part.name.clone()).collect(),
        statement,
        sources: sources.into_iter().collect(),
    }))
}

/// The statement that was shown: for a run at another commit, as the claims were there.
fn statement(
    tree: &Sources,
    claims: &Claims,
    claim: &Claim,
    done: &Done,
    report: &Report,
) -> Result<Sha256, EvidenceError> {
    if done.commit.is_none() {
        return claims.statement(claim, report.engine);
    }
    let then = Claims::parse(Claims::PATH, &tree.text(Claims::PATH)?)?;
    let claim = then.find(&claim.id).ok_or_else(|| {
        EvidenceError::within(Claims::PATH, format!("there was no claim `{}`", claim.id))
    })?;
    then.statement(claim, report.engine)
}

/// The files that a record rests on: the claim's code, and what its parts were read from.
fn bound(claim: &Claim, done: &Done, parts: &[&Part]) -> BTreeSet<String> {
    let mut files = claim.files();
    files.extend(rested_on(done, parts).cloned());
    files
}

/// The files that parts were read from.
fn rested_on<'a>(done: &'a Done, parts: &'a [&Part]) -> impl Iterator<Item = &'a String> {
    let own = parts.iter().flat_map(|part| &part.files);
    done.shared.iter().chain(own)
}

/// What the parts show together, and no more than they do.
fn outcome(parts: &[&Part]) -> Result<Outcome, EvidenceError> {
    if parts.is_empty() {
        let why = "the engine ran, and nothing in it names this claim";
        return Ok(Outcome::NotRun(why.to_owned()));
    }
    let failures: Vec<Failure> = parts
        .iter()
        .filter_map(|part| {
            Some(Failure {
                part: part.name.clone(),
                why: part.failure.clone()?,
            })
        })
        .collect();
    if !failures.is_empty() {
        return Ok(Outcome::Failed(failures));
    }
    let (mut all_reals, mut all_inputs, mut exhausted, mut sampled) = (false, 0, 0, None);
    for part in parts {
        match part.shows {
            Shown::AllReals => all_reals = true,
            Shown::AllInputs { domains } => all_inputs += domains,
            Shown::Exhausted { domains } => exhausted += domains,
            Shown::Sampled { cases } => {
                sampled = Some(sampled.map_or(cases, |sum: u64| sum + cases))
            }
        }
    }
    let mut ways = Vec::new();
    if all_reals {
        ways.push(Shown::AllReals);
    }
    if all_inputs > 0 {
        ways.push(Shown::AllInputs {
            domains: all_inputs,
        });
    }
    if exhausted > 0 {
        ways.push(Shown::Exhausted { domains: exhausted });
    }
    ways.extend(sampled.map(|cases| Shown::Sampled { cases }));
    Ok(Outcome::Shown(ways))
}

/// The time that parts took, to the millisecond.
fn seconds<'a>(parts: impl Iterator<Item = &'a Part>) -> f64 {
    // The sum of no numbers is −0.
    let sum: f64 = parts.map(|part| part.seconds).sum::<f64>() + 0.0;
    (sum * 1000.0).round() / 1000.0
}

pub(crate) fn counted(number: usize) -> Result<u64, EvidenceError> {
    u64::try_from(number).map_err(|error| EvidenceError::new(error.to_string()))
}
