//! The committed files are what the kernel's code gives now. Needs no Rocq.

use std::collections::BTreeSet;
use std::path::Path;
use std::{env, fs};

fn committed(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name);
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn assert_same(name: &str, generated: &str) {
    let committed = committed(name);
    if let Some((line, (old, new))) = committed
        .lines()
        .zip(generated.lines())
        .enumerate()
        .find(|(_, (old, new))| old != new)
    {
        panic!(
            "{name}:{}: the kernel's formula changed; run `cargo run -p passivity-rocq-bridge` \
             and `make prove-rocq`\n committed: {old}\n now:       {new}",
            line + 1
        );
    }
    assert_eq!(
        committed.lines().count(),
        generated.lines().count(),
        "{name}"
    );
}

#[test]
fn committed_files_are_the_kernels() {
    for (name, text) in passivity_rocq_bridge::files() {
        assert_same(name, &text);
    }
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
}

/// A definition that no formula of the kernel is compared with, by itself or as part of another,
/// is one that the code does not need.
#[test]
fn every_definition_is_compared() {
    let files = passivity_rocq_bridge::files();
    let mut used: BTreeSet<&str> = files.iter().flat_map(|(_, text)| words(text)).collect();
    let definitions = committed("Definitions.v");
    let bodies: Vec<(&str, &str)> = definitions
        .split("\nDefinition ")
        .skip(1)
        .map(|body| body.split_once(' ').expect("a definition has a name"))
        .collect();
    // Last to first: a definition speaks only of earlier ones.
    for (name, body) in bodies.iter().rev() {
        // (8) as printed divides by the speed; the kernel has it multiplied out, and the theorem
        // `EQ_8_margin` says that the two agree.
        assert!(
            used.contains(name) || *name == "margin_8",
            "no formula of the kernel is compared with `{name}`"
        );
        used.extend(words(body));
    }
    assert!(bodies.len() > 40, "{} definitions found", bodies.len());
}

#[test]
fn names_are_unique() {
    for (file, formulas) in passivity_rocq_bridge::formulas() {
        let mut names: Vec<_> = formulas.iter().map(|f| f.name().to_owned()).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), count, "{file}");
    }
}
