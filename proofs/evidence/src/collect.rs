//! From what the engines left behind to [`Evidence`].
//!
//! `proofs/prove` runs the engines with `PASSIVITY_EVIDENCE_DIR` set. They leave `properties.txt`
//! (the report of the property tests) and `properties.jsonl` (their cases), `kani-standin.jsonl`,
//! `kani.jsonl`, `smt.jsonl` and `rocq.json`. What is not there did not run.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde_json::Value;

use crate::claims::{Claim, Claims};
use crate::imported::Imported;
use crate::record::{Engine, Evidence, Mutation, Record, Run};

/// One harness, query, test or list of theorems, of one claim.
pub(crate) struct Part {
    pub(crate) claims: Vec<String>,
    pub(crate) name: String,
    pub(crate) verdict: Verdict,
    pub(crate) domain: Option<String>,
    pub(crate) cases: Option<u64>,
    pub(crate) seconds: f64,
    pub(crate) failure: Option<String>,
}

/// What a part shows when it passes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verdict {
    AllReals,
    AllInputs,
    Exhausted,
    Sampled,
}

/// All that an engine left.
pub(crate) struct Report {
    pub(crate) engine: Engine,
    pub(crate) tool: String,
    pub(crate) parts: Vec<Part>,
    pub(crate) not_run: Option<String>,
}

/// Gathers what the engines left in a folder; `mutation` is the last mutation run.
///
/// # Errors
///
/// A sentence, when a file is not what its engine writes, or speaks of an unknown claim.
pub fn collect(root: &Path, folder: &Path, claims: &Claims) -> Result<Evidence, String> {
    let mut evidence = Evidence::default();
    // What Kani said elsewhere counts where it does not run.
    let mut kani = kani(folder)?;
    let elsewhere = Imported::read(root)?.filter(|_| kani.not_run.is_some());
    if let Some(imported) = &elsewhere {
        kani = imported.report(claims);
    }
    let reports = [
        smt(folder)?,
        rocq(root, folder)?,
        kani,
        stand_in(folder)?,
        tests(folder, claims)?,
        prusti(folder),
    ];
    for report in &reports {
        for id in report.parts.iter().flat_map(|part| &part.claims) {
            if claims.find(id).is_none() {
                return Err(format!("{}: unknown claim `{id}`", report.engine));
            }
        }
        evidence.runs.push(run(report));
    }
    for claim in &claims.claims {
        for report in &reports {
            let imported = elsewhere.as_ref().filter(|_| report.engine == Engine::Kani);
            evidence
                .records
                .extend(record(root, claim, report, imported)?);
        }
    }
    let mutation = root.join("proofs/mutants/last.json");
    if mutation.exists() {
        let text = crate::read(&mutation)?;
        let read: Result<Mutation, _> = serde_json::from_str(&text);
        evidence.mutation = Some(read.map_err(|e| format!("{}: {e}", mutation.display()))?);
    }
    Ok(evidence)
}

/// What an engine did.
pub(crate) fn run(report: &Report) -> Run {
    Run {
        engine: report.engine,
        tool: report.tool.clone(),
        parts: u64::try_from(report.parts.len()).unwrap_or(u64::MAX),
        seconds: round(report.parts.iter().map(|part| part.seconds).sum()),
        not_run: report.not_run.clone(),
    }
}

/// What an engine says of a claim, here or, as `imported` has it, elsewhere; `None` when it has
/// nothing to say and was not asked to.
pub(crate) fn record(
    root: &Path,
    claim: &Claim,
    report: &Report,
    imported: Option<&Imported>,
) -> Result<Option<Record>, String> {
    let parts: Vec<&Part> = report
        .parts
        .iter()
        .filter(|part| part.claims.contains(&claim.id))
        .collect();
    if parts.is_empty() && !claim.evidence.contains(&report.engine) {
        return Ok(None);
    }
    let mut not_run = report.not_run.clone();
    if parts.is_empty() && not_run.is_none() {
        not_run = Some("the engine ran, and nothing in it names this claim".to_owned());
    }
    let failures: Vec<String> = parts
        .iter()
        .filter_map(|part| Some(format!("{}: {}", part.name, part.failure.as_ref()?)))
        .collect();
    let cases: u64 = parts.iter().filter_map(|part| part.cases).sum();
    let result = match (&not_run, failures.is_empty()) {
        (Some(_), _) => Some("not run here".to_owned()),
        (None, true) => Some(words(&parts)),
        (None, false) => None,
    };
    let mut domain: Vec<String> = parts
        .iter()
        .filter_map(|part| part.domain.clone())
        .collect();
    domain.dedup();
    let mut record = Record {
        claim: claim.id.clone(),
        engine: report.engine,
        tool: report.tool.clone(),
        result,
        scope: claim.scope.get(&report.engine).cloned(),
        domain,
        cases: (cases > 0).then_some(cases),
        seconds: round(parts.iter().map(|part| part.seconds).sum()),
        parts: parts.iter().map(|part| part.name.clone()).collect(),
        failures,
        not_run,
        claim_sha256: claim.sha256(),
        sources: claim.sources(root)?,
    };
    if let Some(imported) = imported {
        imported.bind(&mut record);
    }
    Ok(Some(record))
}

/// The result in the project's words, and no more than the parts show.
fn words(parts: &[&Part]) -> String {
    let of = |verdict| parts.iter().filter(move |part| part.verdict == verdict);
    let mut words = Vec::new();
    if of(Verdict::AllReals).next().is_some() {
        words.push("proved for all reals".to_owned());
    }
    let domains = |count: usize| {
        if count == 1 {
            "1 domain".to_owned()
        } else {
            format!("{count} domains")
        }
    };
    match of(Verdict::AllInputs).count() {
        0 => {}
        count => words.push(format!("proved for all inputs in {}", domains(count))),
    }
    match of(Verdict::Exhausted).count() {
        0 => {}
        count => words.push(format!("exhausted on {}", domains(count))),
    }
    if of(Verdict::Sampled).next().is_some() {
        let cases: u64 = of(Verdict::Sampled).filter_map(|part| part.cases).sum();
        words.push(format!(
            "sampled, {cases} case{}",
            if cases == 1 { "" } else { "s" }
        ));
    }
    words.join("; ")
}

fn round(seconds: f64) -> f64 {
    (seconds * 1000.0).round() / 1000.0
}

/// The lines of a file of records; `None` when there is no such file.
fn lines(path: &Path) -> Result<Option<Vec<Value>>, String> {
    if !path.exists() {
        return Ok(None);
    }
    let text = crate::read(path)?;
    let parse =
        |line: &str| serde_json::from_str(line).map_err(|e| format!("{}: {e}", path.display()));
    text.lines().map(parse).collect::<Result<_, _>>().map(Some)
}

fn text(line: &Value, field: &str) -> Result<String, String> {
    let value = line.get(field).and_then(Value::as_str);
    value
        .map(str::to_owned)
        .ok_or_else(|| format!("a record has no text `{field}`: {line}"))
}

fn passed(line: &Value) -> Result<bool, String> {
    let value = line.get("passed").and_then(Value::as_bool);
    value.ok_or_else(|| format!("a record has no truth `passed`: {line}"))
}

fn seconds(line: &Value) -> f64 {
    line.get("seconds").and_then(Value::as_f64).unwrap_or(0.0)
}

fn claims_of(line: &Value) -> Vec<String> {
    let listed = line.get("claims").and_then(Value::as_array);
    listed.map_or_else(Vec::new, |ids| {
        ids.iter()
            .filter_map(Value::as_str)
            .map(str::to_owned)
            .collect()
    })
}

/// A report of an engine that left nothing.
fn absent(engine: Engine, why: &str) -> Report {
    Report {
        engine,
        tool: String::new(),
        parts: Vec::new(),
        not_run: Some(why.to_owned()),
    }
}

/// z3 and cvc5: a statement is shown when both gave the expected answer to all its scripts.
fn smt(folder: &Path) -> Result<Report, String> {
    let Some(lines) = lines(&folder.join("smt.jsonl"))? else {
        return Ok(absent(Engine::Smt, "z3 and cvc5 were not installed"));
    };
    let mut versions = BTreeMap::new();
    let mut parts: BTreeMap<String, (Part, Vec<String>)> = BTreeMap::new();
    for line in &lines {
        versions.insert(text(line, "engine")?, text(line, "version")?);
        let script = text(line, "script")?;
        let name = script.split('.').next().unwrap_or(&script).to_owned();
        let (part, answered) = parts.entry(name.clone()).or_insert_with(|| {
            let part = Part {
                claims: Vec::new(),
                name,
                verdict: Verdict::AllReals,
                domain: None,
                cases: None,
                seconds: 0.0,
                failure: None,
            };
            (part, Vec::new())
        });
        part.claims = vec![text(line, "claim")?];
        part.domain = Some(text(line, "says")?);
        part.seconds += seconds(line);
        answered.push(text(line, "engine")?);
        if !passed(line)? {
            part.failure = Some(format!(
                "{} on {script}: {}",
                text(line, "engine")?,
                line["fault"]
            ));
        }
    }
    let parts = parts.into_values().map(|(mut part, answered)| {
        let times = |name: &str| answered.iter().filter(|engine| *engine == name).count();
        if times("z3") != times("cvc5") || times("z3") < 2 {
            part.failure = Some("the two solvers were not asked the same".to_owned());
        }
        part
    });
    let tool: Vec<String> = versions
        .iter()
        .map(|(name, version)| format!("{name} {version}"))
        .collect();
    Ok(Report {
        engine: Engine::Smt,
        tool: tool.join(", "),
        parts: parts.collect(),
        not_run: None,
    })
}

/// Rocq's verdict on the whole development, and which theorems speak of which claim.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Rocq {
    tool: String,
    passed: bool,
    seconds: f64,
    not_run: Option<String>,
}

#[derive(Deserialize)]
struct Theorems {
    claim: Vec<TheoremsOf>,
}

#[derive(Deserialize)]
struct TheoremsOf {
    id: String,
    theorems: Vec<String>,
}

fn rocq(root: &Path, folder: &Path) -> Result<Report, String> {
    let path = folder.join("rocq.json");
    if !path.exists() {
        return Ok(absent(Engine::Rocq, "`make prove-rocq` was not called"));
    }
    let run: Rocq = serde_json::from_str(&crate::read(&path)?)
        .map_err(|e| format!("{}: {e}", path.display()))?;
    if let Some(why) = &run.not_run {
        return Ok(absent(Engine::Rocq, why));
    }
    let list = root.join("proofs/rocq/theorems.toml");
    let theorems: Theorems =
        toml::from_str(&crate::read(&list)?).map_err(|e| format!("{}: {e}", list.display()))?;
    let expected = crate::read(&root.join("proofs/rocq/assumptions.expected"))?;
    let count = f64::from(u32::try_from(theorems.claim.len()).unwrap_or(u32::MAX));
    let part = |TheoremsOf { id, theorems }: TheoremsOf| {
        let missing = theorems.iter().find(|name| {
            let prefix = format!("Passivity.{name}:");
            !expected.lines().any(|line| line.starts_with(&prefix))
        });
        Part {
            claims: vec![id],
            name: theorems.join(", "),
            verdict: Verdict::AllReals,
            domain: None,
            cases: None,
            // The development is compiled as one.
            seconds: run.seconds / count,
            failure: match (run.passed, missing) {
                (false, _) => {
                    Some("the development does not compile, or rests on other axioms".to_owned())
                }
                (true, Some(name)) => Some(format!("`{name}` is not in assumptions.expected")),
                (true, None) => None,
            },
        }
    };
    let parts = theorems.claim.into_iter().map(part).collect();
    Ok(Report {
        engine: Engine::Rocq,
        tool: run.tool,
        parts,
        not_run: None,
    })
}

fn harness(line: &Value, verdict: Verdict) -> Result<Part, String> {
    Ok(Part {
        claims: claims_of(line),
        name: text(line, "harness")?,
        verdict,
        domain: Some(text(line, "domain")?),
        cases: line.get("cases").and_then(Value::as_u64),
        seconds: seconds(line),
        failure: if passed(line)? {
            None
        } else {
            Some(text(line, "result")?)
        },
    })
}

fn kani(folder: &Path) -> Result<Report, String> {
    let Some(lines) = lines(&folder.join("kani.jsonl"))? else {
        return Ok(absent(Engine::Kani, "`make prove-kani` was not called"));
    };
    if let Some(line) = lines.iter().find(|line| line["result"] == "not run here") {
        return Ok(absent(Engine::Kani, &text(line, "reason")?));
    }
    let version = lines
        .first()
        .map_or(Ok(String::new()), |line| text(line, "version"))?;
    let parts = lines
        .iter()
        .map(|line| harness(line, Verdict::AllInputs))
        .collect::<Result<_, _>>()?;
    Ok(Report {
        engine: Engine::Kani,
        tool: format!("Kani {version}"),
        parts,
        not_run: None,
    })
}

fn stand_in(folder: &Path) -> Result<Report, String> {
    let Some(lines) = lines(&folder.join("kani-standin.jsonl"))? else {
        return Ok(absent(
            Engine::StandIn,
            "the tests of proofs/kani were not run",
        ));
    };
    let part = |line: &Value| {
        let exhausted = text(line, "mode")? == "exhausted";
        harness(
            line,
            if exhausted {
                Verdict::Exhausted
            } else {
                Verdict::Sampled
            },
        )
    };
    let parts = lines.iter().map(part).collect::<Result<_, _>>()?;
    Ok(Report {
        engine: Engine::StandIn,
        tool: "cargo test -p passivity-kani".to_owned(),
        parts,
        not_run: None,
    })
}

/// The property tests: what the test runner says decides, the records add the cases.
fn tests(folder: &Path, claims: &Claims) -> Result<Report, String> {
    let path = folder.join("properties.txt");
    if !path.exists() {
        return Ok(absent(
            Engine::Tests,
            "the tests of passivity-core were not run",
        ));
    }
    let mut cases = BTreeMap::new();
    for line in lines(&folder.join("properties.jsonl"))?.unwrap_or_default() {
        let sampled = line.get("cases").and_then(Value::as_u64).unwrap_or(0);
        cases.insert(text(&line, "test")?, (sampled, seconds(&line)));
    }
    let report = crate::read(&path)?;
    let parts: Vec<Part> = report
        .lines()
        .filter_map(|line| line.strip_prefix("test ")?.split_once(" ... "))
        .map(|(name, outcome)| {
            let function = name.rsplit("::").next().unwrap_or(name);
            // A test that samples nothing is one case.
            let (cases, seconds) = cases.get(name).copied().unwrap_or((1, 0.0));
            Part {
                claims: claims
                    .named(function)
                    .into_iter()
                    .map(str::to_owned)
                    .collect(),
                name: name.to_owned(),
                verdict: Verdict::Sampled,
                domain: None,
                cases: Some(cases),
                seconds,
                failure: (outcome.trim() != "ok").then(|| outcome.trim().to_owned()),
            }
        })
        .collect();
    if parts.is_empty() {
        return Err(format!("{}: no test ran", path.display()));
    }
    Ok(Report {
        engine: Engine::Tests,
        tool: "cargo test -p passivity-core".to_owned(),
        parts,
        not_run: None,
    })
}

/// The contracts are read by nothing here: never more than "not run here".
fn prusti(folder: &Path) -> Report {
    let why = crate::read(&folder.join("prusti.txt")).unwrap_or_default();
    let why = if why.trim().is_empty() {
        "`make prove-prusti` was not called"
    } else {
        why.trim()
    };
    absent(Engine::Prusti, why)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What `rocq` makes of a record of `proofs/prove`.
    fn rocq_says(name: &str, record: &str) -> Report {
        let folder = std::env::temp_dir().join(format!("passivity-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("rocq.json"), record).unwrap();
        let report = rocq(&crate::root(), &folder);
        std::fs::remove_dir_all(&folder).unwrap();
        report.unwrap()
    }

    #[test]
    fn theorems_that_compiled_show_their_claims() {
        let record = r#"{"tool": "Rocq 8", "passed": true, "seconds": 60, "not_run": null}"#;
        let report = rocq_says("compiled", record);
        assert!(!report.parts.is_empty());
        for part in &report.parts {
            assert_eq!(part.failure, None, "{}", part.name);
        }
    }

    #[test]
    fn theorems_that_did_not_compile_show_nothing() {
        let record = r#"{"tool": "Rocq 8", "passed": false, "seconds": 60, "not_run": null}"#;
        let report = rocq_says("not-compiled", record);
        assert!(!report.parts.is_empty());
        assert!(report.parts.iter().all(|part| part.failure.is_some()));
    }

    #[test]
    fn theorems_that_were_left_out_are_not_run() {
        let record = r#"{"tool": "Rocq 8", "passed": false, "seconds": 0, "not_run": "left out"}"#;
        let report = rocq_says("left-out", record);
        assert_eq!(report.not_run.as_deref(), Some("left out"));
        assert!(report.parts.is_empty());
    }
}
