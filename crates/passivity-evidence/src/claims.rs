//! `claims.toml`.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::engine::Engine;
use crate::error::EvidenceError;
use crate::sha256::Sha256;

/// Every claim, with what claims refer to.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Claims {
    /// The assumptions.
    #[serde(rename = "assumption")]
    pub assumptions: Vec<Assumption>,
    /// What evidence does not say.
    #[serde(rename = "caveat")]
    pub caveats: Vec<Caveat>,
    /// The claims, in the order of the theory.
    #[serde(rename = "claim")]
    pub claims: Vec<Claim>,
}

/// An assumption that claims are made under.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Assumption {
    /// The id: `A-START`.
    pub id: String,
    /// What is assumed, in a sentence.
    pub sentence: String,
    /// How to check it on the bench.
    pub check: String,
}

/// What some evidence does not say.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Caveat {
    /// The id: `C-GRID`.
    pub id: String,
    /// The caveat in words.
    pub text: String,
}

/// A claim.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// The id: `TH-LIN`.
    pub id: String,
    /// What is claimed, in one sentence.
    pub sentence: String,
    /// The same as a formula; empty when the sentence says it all.
    pub formula: String,
    /// The paper's equations, or where it is beyond the paper.
    pub equation: String,
    /// Whether the claim is that a statement of the paper is false as printed.
    #[serde(default)]
    pub refutes: bool,
    /// The items that implement it, of the kernel and of the reader of scene files.
    pub code: Vec<Item>,
    /// The engines that are expected to show it.
    pub evidence: Vec<Engine>,
    /// What part of the claim an engine speaks of, where it is not the whole.
    #[serde(default)]
    pub scope: BTreeMap<Engine, String>,
    /// Ids of the assumptions that it is made under.
    pub assumptions: Vec<String>,
    /// Ids of the caveats of its evidence.
    pub caveats: Vec<String>,
}

/// An item of the kernel, in files `generation::bound_22`, the module first; of the reader of scene
/// files, `scene/check/report::check`; of the monitor, `monitor/account::net`; or of the identification,
/// `identify/motion::lead`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize)]
#[serde(try_from = "String", into = "String")]
pub struct Item {
    /// The module of the kernel; after `scene/` the file in the crate that reads scene files, after
    /// `monitor/` that of the monitor, after `identify/` that of the identification.
    pub module: String,
    /// The item within it, as in `Row::violates_linear`.
    pub name: String,
}

impl Item {
    /// The source file, from the root of the workspace.
    #[must_use]
    pub fn file(&self) -> String {
        let (folder, within) = match self.module.split_once('/') {
            Some(("scene", within)) => ("passivity-scene", within),
            Some(("monitor", within)) => ("passivity-monitor", within),
            Some(("identify", within)) => ("passivity-identify", within),
            _ => ("passivity-core", self.module.as_str()),
        };
        format!("crates/{folder}/src/{within}.rs")
    }
}

impl fmt::Display for Item {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}::{}", self.module, self.name)
    }
}

impl From<Item> for String {
    fn from(item: Item) -> Self {
        item.to_string()
    }
}

impl TryFrom<String> for Item {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        match text.split_once("::") {
            Some((module, name)) if !module.is_empty() && !name.is_empty() => Ok(Self {
                module: module.to_owned(),
                name: name.to_owned(),
            }),
            _ => Err(format!("expected `module::item`, found `{text}`")),
        }
    }
}

impl Claims {
    /// Where the claims are, from the root of the workspace.
    pub const PATH: &str = "proofs/claims.toml";

    /// Reads `proofs/claims.toml` under a root folder.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, or is no list of claims.
    pub fn read(root: &Path) -> Result<Self, EvidenceError> {
        let path = root.join(Self::PATH);
        Self::parse(&path.display().to_string(), &crate::read(&path)?)
    }

    /// Reads the text of a file called `name`.
    ///
    /// # Errors
    ///
    /// A text that is no list of claims, an id that is there twice, and an assumption or caveat
    /// whose id does not say what it is.
    pub fn parse(name: &str, text: &str) -> Result<Self, EvidenceError> {
        let claims: Self = toml::from_str(text)
            .map_err(|error| EvidenceError::within(name, error.to_string().trim_end()))?;
        claims
            .fault()
            .map_or(Ok(claims), |what| Err(EvidenceError::within(name, what)))
    }

    fn fault(&self) -> Option<String> {
        let assumptions = self.assumptions.iter().map(|a| (a.id.as_str(), "A-"));
        let caveats = self.caveats.iter().map(|c| (c.id.as_str(), "C-"));
        let claims = self.claims.iter().map(|c| (c.id.as_str(), ""));
        let mut seen = BTreeSet::new();
        assumptions
            .chain(caveats)
            .chain(claims)
            .find_map(|(id, prefix)| {
                if !id.starts_with(prefix) || id.len() == prefix.len() {
                    Some(format!(
                        "expected an id that begins with `{prefix}`: `{id}`"
                    ))
                } else if !seen.insert(id) {
                    Some(format!("`{id}` is there twice"))
                } else {
                    None
                }
            })
    }

    /// The claim of that id.
    #[must_use]
    pub fn find(&self, id: &str) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.id == id)
    }

    /// The assumption of that id.
    #[must_use]
    pub fn assumption(&self, id: &str) -> Option<&Assumption> {
        self.assumptions.iter().find(|found| found.id == id)
    }

    /// The caveat of that id.
    #[must_use]
    pub fn caveat(&self, id: &str) -> Option<&Caveat> {
        self.caveats.iter().find(|found| found.id == id)
    }

    /// SHA-256 of all that an engine's evidence for a claim is read with: the claim's id, sentence,
    /// formula and equation, the scope of the engine, and the assumptions and caveats, word for word.
    ///
    /// # Errors
    ///
    /// An assumption or caveat that the claim refers to and that is not there.
    pub fn statement(&self, claim: &Claim, engine: Engine) -> Result<Sha256, EvidenceError> {
        let unknown = |id: &String| {
            EvidenceError::new(format!("{} refers to `{id}`, which is not there", claim.id))
        };
        let refutes = if claim.refutes { "refutes" } else { "holds" };
        let scope = claim.scope.get(&engine).map_or("", String::as_str);
        let mut texts = vec![
            claim.id.as_str(),
            &claim.sentence,
            &claim.formula,
            &claim.equation,
            refutes,
            scope,
        ];
        for id in &claim.assumptions {
            let found = self.assumption(id).ok_or_else(|| unknown(id))?;
            texts.extend(["assumption", &found.id, &found.sentence]);
        }
        for id in &claim.caveats {
            let found = self.caveat(id).ok_or_else(|| unknown(id))?;
            texts.extend(["caveat", &found.id, &found.text]);
        }
        Ok(Sha256::of_texts(texts))
    }
}

impl Claim {
    /// The source files of its code, from the root of the workspace.
    #[must_use]
    pub fn files(&self) -> BTreeSet<String> {
        self.code.iter().map(Item::file).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLAIMS: &str = r#"
        [[assumption]]
        id = "A-X"
        sentence = "It is so."
        check = "Look."
        [[caveat]]
        id = "C-X"
        text = "Not all of it."
        [[claim]]
        id = "TH-X"
        sentence = "One."
        formula = "x = y"
        equation = "(1)"
        code = ["generation::x", "generation::y"]
        evidence = ["smt", "kani"]
        scope = { "kani" = "a grid" }
        assumptions = ["A-X"]
        caveats = ["C-X"]
    "#;

    fn statement(text: &str, engine: Engine) -> Sha256 {
        let claims = Claims::parse("c", text).unwrap();
        claims.statement(&claims.claims[0], engine).unwrap()
    }

    #[test]
    fn a_statement_is_all_that_the_evidence_is_read_with() {
        let before = statement(CLAIMS, Engine::Kani);
        for (old, new) in [
            ("One.", "Two."),
            ("x = y", "x ≤ y"),
            ("(1)", "(2)"),
            ("a grid", "a finer grid"),
            ("It is so.", "It may be so."),
            ("Not all of it.", "None of it."),
            ("formula", "refutes = true\nformula"),
        ] {
            let changed = CLAIMS.replacen(old, new, 1);
            assert_ne!(statement(&changed, Engine::Kani), before, "{new}");
        }
        // What to do on the bench, and which engines are asked, change nothing of what was shown.
        let other = CLAIMS.replace("Look.", "Look twice.");
        let other = other.replace("[\"smt\", \"kani\"]", "[\"kani\"]");
        assert_eq!(statement(&other, Engine::Kani), before);
        let scope = CLAIMS.replace("a grid", "a finer grid");
        assert_eq!(
            statement(&scope, Engine::Smt),
            statement(CLAIMS, Engine::Smt)
        );
    }

    #[test]
    fn files_are_those_of_the_items() {
        let claims = Claims::parse("c", CLAIMS).unwrap();
        let files: Vec<String> = claims.claims[0].files().into_iter().collect();
        assert_eq!(files, ["crates/passivity-core/src/generation.rs"]);
        let of_scenes = Item::try_from("scene/check/report::check".to_owned()).unwrap();
        assert_eq!(
            of_scenes.file(),
            "crates/passivity-scene/src/check/report.rs"
        );
    }

    #[test]
    fn what_is_no_list_of_claims_is_refused_with_its_name() {
        for (old, new) in [
            ("id = \"A-X\"", "id = \"X\""),
            ("id = \"C-X\"", "id = \"A-X\""),
            ("id = \"C-X\"", "id = \"C-\""),
            ("\"generation::x\"", "\"generation\""),
            ("\"kani\"]", "\"kanni\"]"),
            ("formula", "formulas"),
        ] {
            let error = Claims::parse("c.toml", &CLAIMS.replacen(old, new, 1)).unwrap_err();
            assert!(error.to_string().contains("c.toml"), "{error}");
        }
        let claims = Claims::parse("c", &CLAIMS.replace("[\"A-X\"]", "[\"A-Y\"]")).unwrap();
        let error = claims.statement(&claims.claims[0], Engine::Smt);
        assert!(error.unwrap_err().to_string().contains("A-Y"));
    }
}
