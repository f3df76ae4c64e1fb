//! Test vectors: requests of the line protocol with the answers they must get.
//!
//! A file per claim group, with notes that say what each flag means, and ids that the generator
//! assigns. Generated from the kernel, the same bytes every time; see `schema.json` beside them for
//! their form, and [`against`] for driving another implementation through them.

mod against;
mod build;
mod children;
mod cover;
mod groups;
mod linear;
mod witness;
mod wrong;

pub use against::{Difference, Judge, Outcome, PATIENCE, against};
pub use children::end_children;

use std::sync::OnceLock;

use serde_json::{Map, Value, json};

/// JSON Schema (draft 2020-12) of a vector file.
pub const SCHEMA: &str = include_str!("schema.json");

/// The version of the form of the files.
pub const FORM: u32 = 1;

/// One test: a request, and its answer or that it must be refused.
#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    /// The number of the test, from 1, unique over all files.
    pub id: u64,
    /// What the test is about.
    pub comment: String,
    /// Flags, explained in the file's notes.
    pub flags: Vec<&'static str>,
    /// The request, without its `id`.
    pub request: Value,
    /// The answer's `result`; `None` when the request must be refused.
    pub result: Option<Value>,
    /// The kind of the refusal.
    pub refusal: Option<String>,
    /// The wrong formula that the test is about.
    pub formula: Option<Formula>,
}

/// A formula that circulates, and what it wrongly says of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Formula {
    /// The formula, in the paper's symbols.
    pub name: &'static str,
    /// The same in units of K, T and Δ.
    pub condition: &'static str,
    /// The verdict by the formula: `passive` or `not_passive`.
    pub says: &'static str,
}

/// A file of tests about one group of claims.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The name of the file, without `.json`.
    pub name: &'static str,
    /// What the file is about.
    pub header: &'static str,
    /// Claim ids.
    pub claims: Vec<&'static str>,
    /// The flags that its tests have, with what they mean.
    pub notes: Vec<(&'static str, &'static str)>,
    /// The tests.
    pub tests: Vec<Test>,
}

/// Every group, with tests numbered from 1. It takes seconds to make them.
///
/// # Example
///
/// ```no_run
/// let groups = passivity_vectors::all();
/// let tests: usize = groups.iter().map(|group| group.tests.len()).sum();
/// assert!(tests >= 2000);
/// ```
#[must_use]
pub fn all() -> Vec<Group> {
    static GROUPS: OnceLock<Vec<Group>> = OnceLock::new();
    GROUPS.get_or_init(|| up_to(groups::ALL.len())).clone()
}

/// The names of the groups, in their order.
pub fn names() -> impl Iterator<Item = &'static str> {
    groups::ALL.iter().map(|(name, _)| *name)
}

/// The groups that are named, in the order of [`names`], with the numbers that their tests have among
/// all. Groups behind the last one that is named are not made.
///
/// # Errors
///
/// The first name that no group has.
///
/// # Example
///
/// ```
/// let errata = passivity_vectors::named(&["errata"]).unwrap();
/// assert_eq!(errata[0].name, "errata");
/// assert_eq!(passivity_vectors::named(&["erata"]), Err("erata"));
/// ```
pub fn named<N: AsRef<str>>(chosen: &[N]) -> Result<Vec<Group>, &str> {
    let mut end = 0;
    for name in chosen.iter().map(AsRef::as_ref) {
        let place = names().position(|known| known == name).ok_or(name)?;
        end = end.max(place + 1);
    }
    let mut groups = up_to(end);
    groups.retain(|group| chosen.iter().any(|name| name.as_ref() == group.name));
    Ok(groups)
}

/// The first groups, with their tests numbered.
fn up_to(end: usize) -> Vec<Group> {
    let mut groups: Vec<Group> = groups::ALL
        .iter()
        .take(end)
        .map(|(_, make)| make())
        .collect();
    let tests = groups.iter_mut().flat_map(|group| &mut group.tests);
    for (test, id) in tests.zip(1..) {
        test.id = id;
    }
    groups
}

impl Group {
    /// The text of the file: readable, a test a line.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut notes = Map::new();
        for (flag, meaning) in &self.notes {
            notes.insert((*flag).to_owned(), json!(meaning));
        }
        let head = json!({
            "schema": "schema.json",
            "form": FORM,
            "group": self.name,
            "header": self.header,
            "claims": self.claims,
            "notes": notes,
            "number_of_tests": self.tests.len(),
        });
        let head = format!("{head:#}");
        let mut text = head.trim_end_matches(['}', '\n']).to_owned();
        text.push_str(",\n  \"tests\": [\n");
        for (i, test) in self.tests.iter().enumerate() {
            let separator = if i + 1 < self.tests.len() { "," } else { "" };
            text.push_str(&format!("    {}{separator}\n", test.to_json()));
        }
        text.push_str("  ]\n}\n");
        text
    }
}

impl Test {
    fn to_json(&self) -> Value {
        let mut fields = Map::new();
        fields.insert("id".to_owned(), json!(self.id));
        fields.insert("comment".to_owned(), json!(self.comment));
        fields.insert("flags".to_owned(), json!(self.flags));
        fields.insert("request".to_owned(), self.request.clone());
        match &self.result {
            Some(result) => fields.insert("result".to_owned(), result.clone()),
            None => fields.insert("refusal".to_owned(), json!(self.refusal)),
        };
        if let Some(Formula {
            name,
            condition,
            says,
        }) = self.formula
        {
            let formula = json!({"name": name, "condition": condition, "says": says});
            fields.insert("formula".to_owned(), formula);
        }
        Value::Object(fields)
    }

    /// The request with its id, as a line of the protocol.
    #[must_use]
    pub fn line(&self) -> String {
        let mut request = Map::new();
        request.insert("id".to_owned(), json!(self.id));
        if let Value::Object(fields) = &self.request {
            request.extend(fields.clone());
        }
        Value::Object(request).to_string()
    }
}
