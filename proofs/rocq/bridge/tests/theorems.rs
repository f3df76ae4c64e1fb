//! The list of theorems by claim names every theorem that Rocq was asked about, and no other.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use toml::Value;

fn read(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name);
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

#[test]
fn every_theorem_belongs_to_a_claim() {
    let list: Value = toml::from_str(&read("theorems.toml")).expect("theorems.toml");
    let claims = list["claim"].as_array().expect("[[claim]]");
    let named: BTreeSet<String> = claims
        .iter()
        .flat_map(|claim| claim["theorems"].as_array().expect("theorems"))
        .map(|name| format!("Passivity.{}", name.as_str().expect("a name")))
        .collect();
    let proved: BTreeSet<String> = read("assumptions.expected")
        .lines()
        .filter_map(|line| line.split_once(':'))
        .map(|(name, _)| name.to_owned())
        .collect();
    assert!(!proved.is_empty());
    assert_eq!(named, proved);
}

#[test]
fn only_the_axioms_of_the_reals() {
    let allowed = [
        "sig_forall_dec",
        "sig_not_dec",
        "functional_extensionality_dep",
        "classic",
    ];
    for line in read("assumptions.expected").lines() {
        let (name, axioms) = line.split_once(':').expect("name: axioms");
        for axiom in axioms.split_whitespace() {
            assert!(allowed.contains(&axiom), "{name} rests on `{axiom}`");
        }
    }
}
