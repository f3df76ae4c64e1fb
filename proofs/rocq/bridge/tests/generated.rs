//! The committed files are what the kernel's code gives now. Needs no Rocq.

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

/// A definition that no formula of the kernel is compared with is one the code does not need.
#[test]
fn every_definition_is_compared() {
    let bridge: String = passivity_rocq_bridge::files()
        .into_iter()
        .map(|(_, text)| text)
        .collect();
    let definitions = committed("Definitions.v");
    let names = definitions
        .lines()
        .filter_map(|line| line.strip_prefix("Definition "))
        .filter_map(|rest| rest.split_whitespace().next());
    // (8) as printed divides by the speed; the kernel has it multiplied out, and the theorem
    // `EQ_8_margin` says that the two agree.
    for name in names.filter(|name| *name != "margin_8") {
        let used = bridge
            .split(|c: char| !c.is_alphanumeric() && c != '_')
            .any(|word| word == name);
        assert!(used, "no formula of the kernel is compared with `{name}`");
    }
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
