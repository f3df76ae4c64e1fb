//! `evidence.json`: what engines did, and what they said of each claim.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use serde::{Deserialize, Serialize};

use crate::engine::Engine;
use crate::error::EvidenceError;
use crate::mutation::Mutation;
use crate::sha256::Sha256;

/// The form of the file, raised when it changes.
pub const FORMAT: u64 = 2;

/// What machines have shown.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Evidence {
    /// [`FORMAT`].
    pub format: u64,
    /// What each engine did.
    pub runs: Vec<Run>,
    /// One record for each claim and engine.
    pub records: Vec<Record>,
    /// The last mutation run, when there was one.
    pub mutation: Option<Mutation>,
}

/// What an engine did.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The engine.
    pub engine: Engine,
    /// The tools that it consists of.
    pub tools: Vec<Tool>,
    /// The commit of the sources, for a run that was made elsewhere, such as in continuous integration.
    pub commit: Option<String>,
    /// Whether it ran.
    pub outcome: RunOutcome,
    /// The files that its records refer to, as the engine read them.
    pub files: BTreeMap<String, Sha256>,
}

/// Whether an engine ran.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum RunOutcome {
    /// It ran.
    Ran {
        /// The harnesses, queries, tests or theorems that it went through.
        parts: u64,
        /// The time that they took, added up.
        seconds: f64,
    },
    /// It did not run, for this reason.
    NotRun(String),
}

/// A tool with its version, where the run recorded one.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Tool {
    /// The name.
    pub name: String,
    /// The version.
    pub version: Option<String>,
}

impl fmt::Display for Tool {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.version {
            Some(version) => write!(f, "{} {version}", self.name),
            None => f.write_str(&self.name),
        }
    }
}

/// What one engine says of one claim.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// The claim's id.
    pub claim: String,
    /// The engine.
    pub engine: Engine,
    /// What it said.
    pub outcome: Outcome,
    /// What part of the claim that is said of; `None` for the whole.
    pub scope: Option<String>,
    /// The domains, in words.
    pub domains: Vec<String>,
    /// The inputs that were tried, where they can be counted.
    pub cases: Option<u64>,
    /// The time that its parts took.
    pub seconds: f64,
    /// The names of the harnesses, queries, tests or theorems.
    pub parts: Vec<String>,
    /// SHA-256 of what the claim said, with its scope, assumptions and caveats:
    /// [`Claims::statement`](crate::Claims::statement).
    pub statement: Sha256,
    /// The files that it rests on; the run has their sums.
    pub sources: Vec<String>,
}

/// What an engine said of a claim.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// It showed the claim, in these ways.
    Shown(Vec<Shown>),
    /// It ran, and these parts of it did not show the claim.
    Failed(Vec<Failure>),
    /// It did not run, for this reason.
    NotRun(String),
}

/// In which sense a claim was shown. There are no other words for it.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Shown {
    /// Proved for all reals.
    AllReals,
    /// Proved for all inputs in so many domains.
    AllInputs {
        /// The domains.
        domains: u64,
    },
    /// Every input of so many domains was run.
    Exhausted {
        /// The domains.
        domains: u64,
    },
    /// So many inputs were drawn and run.
    Sampled {
        /// The inputs.
        cases: u64,
    },
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counted = |count: u64, what: &str| {
            let plural = if count == 1 { "" } else { "s" };
            format!("{count} {what}{plural}")
        };
        match self {
            Self::AllReals => f.write_str("proved for all reals"),
            Self::AllInputs { domains } => {
                write!(
                    f,
                    "proved for all inputs in {}",
                    counted(*domains, "domain")
                )
            }
            Self::Exhausted { domains } => {
                write!(f, "exhausted on {}", counted(*domains, "domain"))
            }
            Self::Sampled { cases } => write!(f, "sampled, {}", counted(*cases, "case")),
        }
    }
}

/// A part that did not show its claim.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Failure {
    /// The harness, query, test or theorem.
    pub part: String,
    /// What went wrong.
    pub why: String,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.part, self.why)
    }
}

impl Outcome {
    /// The outcome in the project's words: `proved for all reals`, `not run here`, `not shown`.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::Shown(ways) => {
                let ways: Vec<String> = ways.iter().map(ToString::to_string).collect();
                ways.join("; ")
            }
            Self::Failed(_) => "not shown".to_owned(),
            Self::NotRun(_) => "not run here".to_owned(),
        }
    }
}

impl Evidence {
    /// Reads the text of a file called `name`.
    ///
    /// # Errors
    ///
    /// A text that is not such a file, or contradicts itself: a record of an engine that has no run,
    /// two records of the same, words that the engine is not entitled to.
    pub fn parse(name: &str, text: &str) -> Result<Self, EvidenceError> {
        let evidence: Self =
            serde_json::from_str(text).map_err(|error| EvidenceError::within(name, error))?;
        evidence
            .contradiction()
            .map_or(Ok(evidence), |what| Err(EvidenceError::within(name, what)))
    }

    /// What in the evidence cannot be so.
    fn contradiction(&self) -> Option<String> {
        if self.format != FORMAT {
            return Some(format!("expected evidence of format {FORMAT}"));
        }
        let mut engines = BTreeSet::new();
        if let Some(run) = self.runs.iter().find(|run| !engines.insert(run.engine)) {
            return Some(format!("two runs of {}", run.engine));
        }
        let mut seen = BTreeSet::new();
        self.records.iter().find_map(|record| {
            let id = record.id();
            if !seen.insert((&record.claim, record.engine)) {
                return Some(format!("two records {id}"));
            }
            self.fault_of(record).map(|what| format!("{id}: {what}"))
        })
    }

    fn fault_of(&self, record: &Record) -> Option<String> {
        let Some(run) = self.run(record.engine) else {
            return Some("no run of its engine is recorded".to_owned());
        };
        let unknown = |path: &&String| !run.files.contains_key(*path);
        if let Some(path) = record.sources.iter().find(unknown) {
            return Some(format!("no sum of `{path}` is recorded"));
        }
        if !(record.seconds >= 0.0 && record.seconds.is_finite()) {
            return Some(format!("it took {} seconds", record.seconds));
        }
        match (&record.outcome, &run.outcome) {
            (Outcome::NotRun(_), _) => None,
            (_, RunOutcome::NotRun(_)) => {
                Some("there is an outcome, and the engine did not run".to_owned())
            }
            (Outcome::Failed(failures), _) if failures.is_empty() => {
                Some("it failed, and no part of it did".to_owned())
            }
            (Outcome::Failed(_), _) => None,
            (Outcome::Shown(ways), _) if ways.is_empty() || record.parts.is_empty() => {
                Some("it was shown, and by nothing".to_owned())
            }
            (Outcome::Shown(_), _) if record.sources.is_empty() => {
                Some("it is bound to no source".to_owned())
            }
            (Outcome::Shown(ways), _) => ways
                .iter()
                .find(|way| !record.engine.can_show(way))
                .map(|way| format!("{} cannot say `{way}`", record.engine)),
        }
    }

    /// The text of the file.
    ///
    /// # Errors
    ///
    /// A number that JSON cannot write.
    pub fn to_text(&self) -> Result<String, EvidenceError> {
        let text = serde_json::to_string_pretty(self)
            .map_err(|error| EvidenceError::new(format!("the evidence has no text: {error}")))?;
        Ok(format!("{text}\n"))
    }

    /// What an engine did.
    #[must_use]
    pub fn run(&self, engine: Engine) -> Option<&Run> {
        self.runs.iter().find(|run| run.engine == engine)
    }

    /// What an engine said of a claim.
    #[must_use]
    pub fn find(&self, claim: &str, engine: Engine) -> Option<&Record> {
        self.records
            .iter()
            .find(|record| record.claim == claim && record.engine == engine)
    }
}

impl Record {
    /// The claim's id and the engine, which name the record: `TH-LIN/smt`.
    #[must_use]
    pub fn id(&self) -> String {
        format!("{}/{}", self.claim, self.engine)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn evidence() -> Evidence {
        let sum = Sha256::of(b"source");
        Evidence {
            format: FORMAT,
            runs: vec![Run {
                engine: Engine::Smt,
                tools: vec![Tool {
                    name: "z3".into(),
                    version: Some("5".into()),
                }],
                commit: None,
                outcome: RunOutcome::Ran {
                    parts: 1,
                    seconds: 1.0,
                },
                files: BTreeMap::from([("a.rs".to_owned(), sum)]),
            }],
            records: vec![Record {
                claim: "TH-X".into(),
                engine: Engine::Smt,
                outcome: Outcome::Shown(vec![Shown::AllReals]),
                scope: None,
                domains: Vec::new(),
                cases: None,
                seconds: 1.0,
                parts: vec!["th_x".into()],
                statement: sum,
                sources: vec!["a.rs".into()],
            }],
            mutation: None,
        }
    }

    #[test]
    fn what_is_written_is_read_again() {
        let evidence = evidence();
        let text = evidence.to_text().unwrap();
        assert_eq!(Evidence::parse("e", &text), Ok(evidence));
    }

    #[test]
    fn evidence_that_contradicts_itself_is_refused() {
        type Edit = fn(&mut Evidence);
        let cases: [(&str, Edit); 9] = [
            ("format 2", |e| e.format = 1),
            ("no run", |e| e.runs.clear()),
            ("two runs", |e| e.runs.push(e.runs[0].clone())),
            ("two records", |e| e.records.push(e.records[0].clone())),
            ("no sum of `a.rs`", |e| e.runs[0].files.clear()),
            ("cannot say `sampled, 2 cases`", |e| {
                e.records[0].outcome = Outcome::Shown(vec![Shown::Sampled { cases: 2 }]);
            }),
            ("shown, and by nothing", |e| e.records[0].parts.clear()),
            ("bound to no source", |e| e.records[0].sources.clear()),
            ("did not run", |e| {
                e.runs[0].outcome = RunOutcome::NotRun("not here".into());
            }),
        ];
        for (says, edit) in cases {
            let mut wrong = evidence();
            edit(&mut wrong);
            let error = Evidence::parse("e.json", &wrong.to_text().unwrap()).unwrap_err();
            let message = error.to_string();
            assert!(
                message.contains(says) && message.contains("e.json"),
                "{message}"
            );
        }
    }

    #[test]
    fn a_field_that_nobody_knows_is_refused() {
        let text = evidence().to_text().unwrap();
        let text = text.replacen("\"records\"", "\"more\": 1, \"records\"", 1);
        assert!(Evidence::parse("e", &text).is_err());
        assert!(Evidence::parse("e", "").is_err(), "an empty file is none");
    }
}
