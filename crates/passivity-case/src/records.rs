//! Claims and recorded evidence as a case uses them: from a source tree, or from what the build
//! carries, and how fresh the evidence is.

use std::collections::BTreeSet;
use std::path::Path;

use passivity_evidence as evidence;
use passivity_evidence::{
    Assessed, Change, Claim, Claims, Engine, Evidence, EvidenceError, Freshness, Now, Outcome,
    Record, Sha256, Shown, assess, in_tree,
};

use crate::error::CaseError;
use crate::files::read_text;
use crate::gsn::Standing;
use crate::tree;

/// Claims and evidence are no larger than this.
const MOST_BYTES: u64 = 64 << 20;

/// Where evidence is recorded: by the last run here, and by the last one that was committed.
const EVIDENCE: [&str; 2] = ["target/evidence.json", "proofs/evidence.json"];

/// The sources that evidence was compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Those that this `passivity` was built from.
    Build,
    /// Those of a source tree, as they are now.
    Tree,
}

impl Origin {
    /// The sources in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Build => {
                "the kernel that this passivity was built from; the harnesses, queries and theorems \
                 are not at hand here, and were not compared"
            }
            Self::Tree => "the sources of the tree, as they were when this case was written",
        }
    }
}

/// Everything that is known of the claims.
#[derive(Clone, Debug, PartialEq)]
pub struct Records {
    /// The claims.
    pub claims: Claims,
    /// What the engines did and said.
    pub evidence: Evidence,
    /// How it stands: an entry for each claim and engine.
    pub assessed: Vec<Assessed>,
    /// What has changed since the last mutation run.
    pub mutation_changes: Vec<Change>,
    /// Which sources the evidence was compared with.
    pub origin: Origin,
    /// SHA-256 of the claims' text.
    pub claims_sha256: Sha256,
    /// Where the recorded evidence is from, in words: its file, as it was given or within the tree.
    pub evidence_from: String,
    /// SHA-256 of the recorded evidence.
    pub evidence_sha256: Sha256,
    /// The commit of the sources, when known.
    pub commit: Option<String>,
}

impl Records {
    /// The records of the tree at `root`; without one, those that the build carries.
    ///
    /// `evidence` is a file to read in the place of the recorded evidence.
    ///
    /// # Errors
    ///
    /// Claims or evidence that are not there, cannot be read or are not what they should be.
    pub fn read(root: Option<&Path>, evidence: Option<&Path>) -> Result<Self, CaseError> {
        let given = match evidence {
            Some(path) => Some(Text::read(path)?),
            None => None,
        };
        match root {
            Some(root) => {
                let claims = Text::read(&root.join(Claims::PATH))?;
                let now = |path: &str| in_tree(root, path);
                let of = |evidence: &Text| Self::of_texts(&claims, evidence, Origin::Tree, now);
                let mut records = match given {
                    Some(evidence) => of(&evidence)?,
                    None => Self::recorded_in(root, of)?,
                };
                records.commit = tree::commit(root);
                Ok(records)
            }
            None => {
                let claims = Text::of_build(Claims::PATH, &evidence::claimed()?);
                let evidence = match given {
                    Some(evidence) => evidence,
                    None => Text::of_build("evidence", &evidence::recorded()?),
                };
                Self::of_texts(&claims, &evidence, Origin::Build, |path| Ok(in_build(path)))
            }
        }
    }

    /// The records of the last run in a tree. Where the ones that were committed show more of the sources as they
    /// are now, those: a run of a few engines, or of long ago, may have been left behind. What failed in the last
    /// run is never passed over.
    fn recorded_in(
        root: &Path,
        of: impl Fn(&Text) -> Result<Self, CaseError>,
    ) -> Result<Self, CaseError> {
        let mut found = Vec::new();
        for file in EVIDENCE {
            let path = root.join(file);
            if path.is_file() {
                let mut records = of(&Text::read(&path)?)?;
                records.evidence_from = file.to_owned();
                found.push(records);
            }
        }
        let mut found = found.into_iter();
        let last = found.next().ok_or_else(|| {
            let what = "no evidence is recorded: `make prove` records it";
            CaseError::within(&root.join("proofs/evidence.json"), what)
        })?;
        let failed = |assessed: &Assessed| matches!(assessed.freshness, Freshness::Failed(_));
        Ok(match found.next() {
            Some(mut committed)
                if committed.fresh() > last.fresh() && !last.assessed.iter().any(failed) =>
            {
                committed.evidence_from +=
                    &format!(", of which more is fresh than of {}", last.evidence_from);
                committed
            }
            _ => last,
        })
    }

    /// The claims and the evidence of two texts, compared with the sources as `now` gives them.
    fn of_texts(
        claims: &Text,
        evidence: &Text,
        origin: Origin,
        now: impl Fn(&str) -> Result<Now, EvidenceError>,
    ) -> Result<Self, CaseError> {
        let (claims_sha256, evidence_sha256) = (claims.sum(), evidence.sum());
        let evidence_from = evidence.name.clone();
        let claims = Claims::parse(&claims.name, &claims.text)?;
        let evidence = Evidence::parse(&evidence.name, &evidence.text)?;
        let mutation_changes = match &evidence.mutation {
            Some(mutation) => mutation.changes(&now)?,
            None => Vec::new(),
        };
        Ok(Self {
            assessed: assess(&claims, &evidence, &now)?,
            claims,
            evidence,
            mutation_changes,
            origin,
            claims_sha256,
            evidence_from,
            evidence_sha256,
            commit: None,
        })
    }

    /// What was recorded of a claim, and what should have been, an entry for each engine.
    pub fn of_claim(&self, claim: &str) -> impl Iterator<Item = &Assessed> {
        self.assessed.iter().filter(move |a| a.claim == claim)
    }

    /// How many records are fresh.
    #[must_use]
    pub fn fresh(&self) -> usize {
        let all = self.assessed.iter();
        all.filter(|a| a.freshness == Freshness::Fresh).count()
    }

    /// By what a claim is shown: the strongest of its fresh records. `None` where it is not shown.
    #[must_use]
    pub fn strength(&self, claim: &str) -> Option<Strength> {
        let fresh = self.of_claim(claim);
        let fresh = fresh.filter(|assessed| assessed.freshness == Freshness::Fresh);
        let strongest = fresh.filter_map(|assessed| Strength::of(assessed.record.as_ref()?));
        let strongest = strongest.max();
        strongest.filter(|_| self.standing(claim) == Standing::Shown)
    }

    /// How a claim stands: shown when some record shows it and none is stale or failed.
    ///
    /// A record that was not run does not speak against the claim while another one shows it, but
    /// it is listed, and a strict case refuses it.
    #[must_use]
    pub fn standing(&self, claim: &str) -> Standing {
        self.of_claim(claim)
            .map(|assessed| standing(&assessed.freshness))
            .min_by_key(|standing| match standing {
                Standing::Defeated | Standing::Open => 0,
                Standing::Stale => 1,
                Standing::Shown => 2,
                Standing::NotRun => 3,
            })
            .unwrap_or(Standing::NotRun)
    }

    /// How claims hang together with code and evidence.
    #[must_use]
    pub fn linkage(&self) -> Linkage<'_> {
        let mut linkage = Linkage::default();
        for claim in &self.claims.claims {
            let code = !claim.code.is_empty();
            let mut recorded = self.of_claim(&claim.id);
            let recorded = recorded.any(|a| !matches!(a.freshness, Freshness::NotRun(_)));
            match (code, recorded) {
                (true, true) => linkage.linked.push(&claim.id),
                (true, false) | (false, true) => linkage.partly.push(&claim.id),
                (false, false) => linkage.unlinked.push(&claim.id),
            }
            linkage.unknown.extend(self.unknown_of(claim));
        }
        let recorded = self.evidence.records.iter().map(|record| &record.claim);
        let unknown = recorded.filter(|id| self.claims.find(id).is_none());
        linkage.unknown.extend(unknown.map(String::as_str));
        linkage
    }

    /// The assumptions and caveats that a claim refers to and that are not there.
    fn unknown_of<'a>(&'a self, claim: &'a Claim) -> impl Iterator<Item = &'a str> {
        let assumptions = claim.assumptions.iter();
        let assumptions = assumptions.filter(|id| self.claims.assumption(id).is_none());
        let caveats = claim.caveats.iter();
        let caveats = caveats.filter(|id| self.claims.caveat(id).is_none());
        assumptions.chain(caveats).map(String::as_str)
    }

    /// The tools of an engine, with their versions and, for a run made elsewhere, its commit.
    #[must_use]
    pub fn tools(&self, engine: Engine) -> String {
        let Some(run) = self.evidence.run(engine) else {
            return String::new();
        };
        let tools: Vec<String> = run.tools.iter().map(ToString::to_string).collect();
        match &run.commit {
            Some(commit) => format!("{}, at commit {commit}", tools.join(", ")),
            None => tools.join(", "),
        }
    }
}

/// By what a claim is shown, from the weakest to the strongest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Strength {
    /// Inputs were drawn.
    Sampled,
    /// Every input of some domains was run.
    Exhausted,
    /// A model checker proved it for all inputs within bounds.
    AllInputs,
    /// A part of it, which the record names, is proved for all reals.
    InPart,
    /// It is proved for all reals.
    AllReals,
}

impl Strength {
    /// All of them, the strongest first.
    pub const ALL: [Self; 5] = [
        Self::AllReals,
        Self::InPart,
        Self::AllInputs,
        Self::Exhausted,
        Self::Sampled,
    ];

    /// The evidence in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::AllReals => "proved for all reals",
            Self::InPart => "proved for all reals in a part that the record names",
            Self::AllInputs => "proved for all inputs within bounds",
            Self::Exhausted => "exhausted on domains, not proved",
            Self::Sampled => "only sampled by tests",
        }
    }

    fn of(record: &Record) -> Option<Self> {
        let Outcome::Shown(ways) = &record.outcome else {
            return None;
        };
        let strengths = ways.iter().map(|shown| match shown {
            Shown::AllReals if record.scope.is_some() => Self::InPart,
            Shown::AllReals => Self::AllReals,
            Shown::AllInputs { .. } => Self::AllInputs,
            Shown::Exhausted { .. } => Self::Exhausted,
            Shown::Sampled { .. } => Self::Sampled,
        });
        strengths.max()
    }
}

/// How a record stands in an argument.
#[must_use]
pub const fn standing(freshness: &Freshness) -> Standing {
    match freshness {
        Freshness::Fresh => Standing::Shown,
        Freshness::Stale(_) => Standing::Stale,
        Freshness::NotRun(_) => Standing::NotRun,
        Freshness::Failed(_) => Standing::Open,
    }
}

/// Which claims have code and evidence, which only one of them, and ids that are no claim.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Linkage<'a> {
    /// Code and evidence.
    pub linked: Vec<&'a str>,
    /// Code or evidence.
    pub partly: Vec<&'a str>,
    /// Neither.
    pub unlinked: Vec<&'a str>,
    /// Ids that something refers to and that are not defined.
    pub unknown: BTreeSet<&'a str>,
}

/// A text, and where it is from.
struct Text {
    name: String,
    text: String,
}

impl Text {
    fn read(path: &Path) -> Result<Self, CaseError> {
        Ok(Self {
            name: path.display().to_string(),
            text: read_text(path, MOST_BYTES)?,
        })
    }

    fn of_build(name: &str, text: &str) -> Self {
        Self {
            name: format!("{name} of this build"),
            text: text.to_owned(),
        }
    }

    fn sum(&self) -> Sha256 {
        Sha256::of(self.text.as_bytes())
    }
}

/// A source file as this build has it: of the kernel every file, and no other.
fn in_build(path: &str) -> Now {
    let kernel = |path: &str| Path::new(path).parent().map(Path::to_owned);
    match evidence::KERNEL.iter().find(|(name, _)| *name == path) {
        Some((_, sum)) => Now::Is(*sum),
        None if evidence::KERNEL
            .iter()
            .any(|(name, _)| kernel(name) == kernel(path)) =>
        {
            Now::Gone
        }
        None => Now::NotAtHand,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_build_carries_the_claims_and_every_source_of_the_kernel() {
        let records = Records::read(None, None).unwrap();
        assert!(records.claims.claims.len() >= 20 && records.claims.assumptions.len() >= 5);
        // What `check` says is claimed too: its files are the scene's, and not at hand in a build.
        for file in records.claims.claims.iter().flat_map(Claim::files) {
            let of_kernel = file.starts_with("crates/passivity-core/");
            assert_eq!(matches!(in_build(&file), Now::Is(_)), of_kernel, "{file}");
            assert!(of_kernel || in_build(&file) == Now::NotAtHand, "{file}");
        }
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let kernel = root.join("crates/passivity-core/src");
        for entry in std::fs::read_dir(kernel).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            let path = format!("crates/passivity-core/src/{name}");
            assert_eq!(in_build(&path), in_tree(&root, &path).unwrap());
        }
        assert_eq!(in_build("crates/passivity-core/src/gone.rs"), Now::Gone);
        assert_eq!(in_build("proofs/smt/queries/th_lin.smt2"), Now::NotAtHand);
    }

    #[test]
    fn ids_that_are_not_there_are_unknown() {
        let mut records = Records::read(None, None).unwrap();
        records.claims.claims[0].assumptions.push("A-GONE".into());
        records.evidence.records[0].claim = "TH-GONE".into();
        let linkage = records.linkage();
        assert_eq!(
            linkage.unknown.into_iter().collect::<Vec<_>>(),
            ["A-GONE", "TH-GONE"]
        );
    }

    #[test]
    fn a_claim_stands_as_its_worst_record_that_ran() {
        let mut records = Records::read(None, None).unwrap();
        let not_run = || Freshness::NotRun("not here".to_owned());
        let stale = || Freshness::Stale(vec![Change::Statement]);
        for (freshness, expected) in [
            (vec![Freshness::Fresh, not_run()], Standing::Shown),
            (vec![Freshness::Fresh, stale()], Standing::Stale),
            (vec![stale(), Freshness::Failed(Vec::new())], Standing::Open),
            (vec![not_run()], Standing::NotRun),
            (vec![], Standing::NotRun),
        ] {
            let entry = |freshness| Assessed {
                claim: "TH-X".into(),
                engine: Engine::Smt,
                required: true,
                record: None,
                freshness,
            };
            records.assessed = freshness.into_iter().map(entry).collect();
            assert_eq!(records.standing("TH-X"), expected);
        }
    }
}
