//! From what the engines left behind to [`Evidence`].

use std::collections::BTreeMap;
use std::path::Path;

use passivity_evidence::{
    Claim, Claims, Engine, Evidence, EvidenceError, FORMAT, Failure, Outcome, Record, Run,
    RunOutcome, Sha256, Shown, read,
};

use crate::COMMITTED;

use crate::engines::{Done, Part, Ran, Report, reports};
use crate::mutants;
use crate::reads::Reads;
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
    let collector = Collector::new(root, claims)?;
    let mut files: Vec<BTreeMap<String, Sha256>> = vec![BTreeMap::new(); reports.len()];
    for claim in &claims.claims {
        for (report, files) in reports.iter().zip(&mut files) {
            evidence
                .records
                .extend(collector.record(claim, report, files)?);
        }
    }
    for (report, files) in reports.into_iter().zip(files) {
        evidence.runs.push(run(report, files)?);
    }
    let kept = folder.join("kept.txt");
    if kept.exists() {
        let kept = read(&kept)?;
        keep(root, claims, &mut evidence, kept.split_whitespace())?;
    }
    Ok(evidence)
}

/// Puts the committed runs and records of engines, which were not asked again because nothing that
/// they rest on has changed, in the place of new ones.
fn keep<'a>(
    root: &Path,
    claims: &Claims,
    evidence: &mut Evidence,
    engines: impl Iterator<Item = &'a str>,
) -> Result<(), EvidenceError> {
    let committed = Evidence::parse(COMMITTED, &read(&root.join(COMMITTED))?)?;
    for name in engines {
        let named = |run: &&Run| run.engine.name() == name;
        let Some(old) = committed.runs.iter().find(named) else {
            return Err(EvidenceError::within(
                COMMITTED,
                format!("no run of `{name}` is there to keep"),
            ));
        };
        for run in evidence
            .runs
            .iter_mut()
            .filter(|run| run.engine == old.engine)
        {
            *run = old.clone();
        }
        let mut records = Vec::new();
        for claim in &claims.claims {
            for engine in Engine::ALL {
                let from = if engine == old.engine {
                    &committed
                } else {
                    &*evidence
                };
                records.extend(from.find(&claim.id, engine).cloned());
            }
        }
        evidence.records = records;
    }
    Ok(())
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

/// What records are made with.
pub(crate) struct Collector<'a> {
    claims: &'a Claims,
    tree: Sources,
    reads: Reads,
}

impl<'a> Collector<'a> {
    /// Reads the sources of the tree at `root`.
    pub(crate) fn new(root: &Path, claims: &'a Claims) -> Result<Self, EvidenceError> {
        let tree = Sources::new(root, None);
        let reads = Reads::new(&tree)?;
        Ok(Self {
            claims,
            tree,
            reads,
        })
    }

    /// What an engine says of a claim, here or elsewhere; `None` when it has nothing to say and was
    /// not asked to. The sums of what it rests on are added to `files`.
    pub(crate) fn record(
        &self,
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
        let mut scope = claim.scope.get(&engine).cloned();
        let mut statement = self.claims.statement(claim, engine)?;
        let (outcome, sums) = match &report.ran {
            Ran::No(why) => (Outcome::NotRun(why.clone()), BTreeMap::new()),
            Ran::Yes(Done {
                imported: Some(imported),
                ..
            }) => {
                let mut sums = BTreeMap::new();
                if let Some((then, at_commit)) = imported.bound(&claim.id) {
                    (scope, statement) = (then.scope.clone(), then.statement);
                    sums = at_commit;
                }
                (outcome(&parts)?, sums)
            }
            Ran::Yes(done) => (outcome(&parts)?, self.sums(claim, done, &parts, files)?),
        };
        let sources = sums.keys().cloned().collect();
        files.extend(sums);
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
            sources,
        }))
    }

    /// The files that a record rests on, with their sums: the claim's code and what its parts are
    /// written in, with all that these rest on, and what every part shares.
    fn sums(
        &self,
        claim: &Claim,
        done: &Done,
        parts: &[&Part],
        known: &BTreeMap<String, Sha256>,
    ) -> Result<BTreeMap<String, Sha256>, EvidenceError> {
        let mut roots = claim.files();
        roots.extend(parts.iter().flat_map(|part| &part.files).cloned());
        let mut files = self.reads.of(&self.tree, roots)?;
        files.extend(done.shared.iter().cloned());
        let of = |file: String| {
            let sum = match known.get(&file) {
                Some(sum) => *sum,
                None => self.tree.sum(&file)?,
            };
            Ok((file, sum))
        };
        files.into_iter().map(of).collect()
    }
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
