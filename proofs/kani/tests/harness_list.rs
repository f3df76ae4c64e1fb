//! `harnesses.toml` and the sources name the same harnesses, covers and failures.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use passivity_standin::list;

/// The harnesses of the sources: name, and the text up to the end of the function.
fn in_sources() -> BTreeMap<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = BTreeMap::new();
    for file in fs::read_dir(folder).expect("there are sources") {
        let path = file.expect("the folder can be read").path();
        let module = path
            .file_stem()
            .and_then(|stem| stem.to_str())
            .expect("a name")
            .to_string();
        let text = fs::read_to_string(&path).expect("a source is text");
        for part in text.split("#[kani::proof]").skip(1) {
            let (_, after) = part.split_once("fn ").expect("a function follows");
            let (name, _) = after.split_once('(').expect("it has parameters");
            // rustfmt closes a function with a brace in the first column.
            let (body, _) = part.split_once("\n}").expect("it ends");
            let name = format!("{module}::{name}");
            assert!(found.insert(name, body.to_string()).is_none());
        }
    }
    found
}

#[test]
fn the_list_and_the_sources_name_the_same_harnesses() {
    let list = list::read(Path::new(env!("CARGO_MANIFEST_DIR"))).expect("the list is well-formed");
    let listed: BTreeSet<&str> = list
        .harness
        .iter()
        .map(|entry| entry.name.as_str())
        .collect();
    assert_eq!(
        listed.len(),
        list.harness.len(),
        "a harness is listed twice"
    );
    let sources = in_sources();
    let found: BTreeSet<&str> = sources.keys().map(String::as_str).collect();
    assert_eq!(listed, found);
    for entry in &list.harness {
        let text = &sources[&entry.name];
        assert_eq!(
            entry.must_fail.is_some(),
            text.contains("#[kani::should_panic]"),
            "{}",
            entry.name
        );
        assert_eq!(
            entry.covers.len(),
            text.matches("kani::cover!").count(),
            "{}",
            entry.name
        );
        assert!(
            entry
                .covers
                .iter()
                .all(|cover| text.contains(cover.as_str())),
            "{}",
            entry.name
        );
        assert!(
            !entry.domain.is_empty() && !entry.claims.is_empty(),
            "{}",
            entry.name
        );
        assert!(
            entry.mutation.is_some(),
            "{} has no mutation that it must notice",
            entry.name
        );
    }
}

/// The file and text that each listed mutation edits is there, once: so the list does not rot.
#[test]
fn the_mutations_of_the_list_fit_the_kernel() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let list = list::read(folder).expect("the list is well-formed");
    let crates = folder.join("../../crates");
    for entry in &list.harness {
        let [file, old, new] = entry
            .mutation
            .as_ref()
            .expect("each harness has a mutation");
        let path = match file.strip_prefix("monitor/") {
            Some(file) => crates.join("passivity-monitor/src").join(file),
            None => crates.join("passivity-core/src").join(file),
        };
        let text = fs::read_to_string(path).expect("a file of the kernel or the monitor");
        assert_eq!(
            text.matches(old.as_str()).count(),
            1,
            "{}: {old}",
            entry.name
        );
        assert_ne!(old, new, "{}", entry.name);
    }
}
