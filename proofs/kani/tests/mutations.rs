//! Each harness notices the change of the kernel that `harnesses.toml` lists with it.
//!
//! The kernel, the monitor, the harnesses and their stand-in are copied into `target/kani-mutants`, the
//! copies of the kernel and the monitor with all changes in them, each with a switch. One build of it then runs every
//! harness with its change on, and all of them with none.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::thread::available_parallelism;

use passivity_standin::copy::{copy, share_libraries, workspace, write};
use passivity_standin::list::{self, List};
use passivity_standin::mutate::{Edit, SWITCH, VARIABLE, with_switches};

/// The crates that are changed, and what their files are listed under.
const CHANGED: [(&str, &str); 2] = [
    ("crates/passivity-core", ""),
    ("crates/passivity-monitor", "monitor/"),
];

/// The package of the harnesses, and the one that asks for libraries as the tree has them.
const HARNESSES: &str = "passivity-kani";
const LIBRARIES: &str = "libraries";

/// The members of the copy.
const MEMBERS: [&str; 7] = [
    CHANGED[0].0,
    CHANGED[1].0,
    "crates/passivity-random",
    "proofs/kani",
    "proofs/standin",
    "proofs/standin/macros",
    LIBRARIES,
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The changes, numbered from 1, with the harnesses that must notice each.
fn mutations(list: &List) -> BTreeMap<&[String; 3], (u32, Vec<&str>)> {
    let mut found: BTreeMap<_, (u32, Vec<&str>)> = BTreeMap::new();
    for entry in &list.harness {
        let mutation = entry
            .mutation
            .as_ref()
            .expect("each harness has a mutation");
        let next = u32::try_from(found.len()).expect("few") + 1;
        let (_, harnesses) = found.entry(mutation).or_insert((next, Vec::new()));
        harnesses.push(&entry.name);
    }
    found
}

/// What a source is listed under, if it is one that is changed.
fn listed(root: &Path, path: &Path) -> Option<String> {
    CHANGED.iter().find_map(|(folder, prefix)| {
        let file = path.strip_prefix(root.join(folder).join("src")).ok()?;
        Some(format!("{prefix}{}", file.to_str()?))
    })
}

/// Makes the copy, with a switch for each change.
fn copied(list: &List) -> PathBuf {
    let (root, copy_of) = (root(), root().join("target/kani-mutants"));
    let mut edits: BTreeMap<&str, Vec<Edit>> = BTreeMap::new();
    for ([file, old, new], (number, _)) in mutations(list) {
        edits.entry(file).or_default().push((number, old, new));
    }
    for member in MEMBERS.iter().filter(|member| **member != LIBRARIES) {
        copy(
            &root.join(member),
            &copy_of.join(member),
            &["mutation.rs"],
            &mut |path, text| match listed(&root, path).as_deref() {
                Some("lib.rs" | "monitor/lib.rs") => format!("{text}\nmod mutation;\n"),
                Some(file) => {
                    let edits = edits.get(file).map_or(&[][..], Vec::as_slice);
                    with_switches(&text, edits).unwrap_or_else(|e| panic!("{file}: {e}"))
                }
                None => text,
            },
        );
    }
    for (folder, _) in CHANGED {
        let switch = copy_of.join(folder).join("src/mutation.rs");
        write(&switch, SWITCH.as_bytes());
    }
    share_libraries(&root, &copy_of.join(LIBRARIES), HARNESSES);
    workspace(&root, &copy_of, &MEMBERS);
    copy_of
}

/// Builds the tests of the copied harnesses and finds the binary. The target folder is that of this test,
/// where the libraries are that both need.
fn build(copy_of: &Path) -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("..");
    let output = Command::new(env!("CARGO"))
        .args([
            "test",
            "--offline",
            "-p",
            HARNESSES,
            "-p",
            LIBRARIES,
            "--lib",
            "--no-run",
            // What harnesses call of the kernel is compiled with them: it is generic.
            "--config",
            "profile.dev.package.passivity-core.opt-level=0",
        ])
        .current_dir(copy_of)
        .env("CARGO_TARGET_DIR", target)
        .output()
        .expect("cargo runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success(),
        "the copy does not compile:\n{said}"
    );
    let mut executables = said
        .lines()
        .filter_map(|line| line.trim().strip_prefix("Executable ")?.split_once('('));
    let (_, binary) = executables
        .find(|(_, path)| path.contains("passivity_kani"))
        .expect("a binary");
    copy_of.join(binary.trim_end_matches(')'))
}

/// Runs harnesses with a change on, and says which of them fail.
fn failed<'a>(binary: &Path, mutation: u32, harnesses: &[&'a str]) -> Vec<&'a str> {
    let output = Command::new(binary)
        .args(harnesses.iter().map(|name| format!("{name}::stand_in")))
        .args(["--exact"])
        .env(VARIABLE, mutation.to_string())
        .env_remove("PASSIVITY_EVIDENCE_DIR")
        .env("RUST_BACKTRACE", "0")
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("the binary runs");
    let said = String::from_utf8_lossy(&output.stdout);
    let outcome =
        |name: &str, word: &str| said.contains(&format!("test {name}::stand_in ... {word}\n"));
    let ran = |name: &&str| outcome(name, "ok") || outcome(name, "FAILED");
    assert!(harnesses.iter().all(ran), "mutation {mutation}: {said}");
    let failed = harnesses.iter().filter(|name| outcome(name, "FAILED"));
    failed.copied().collect()
}

#[test]
fn each_harness_notices_its_mutation_and_passes_without() {
    let list = list::read(Path::new(env!("CARGO_MANIFEST_DIR"))).expect("the list is well-formed");
    let binary = build(&copied(&list));
    let all: Vec<&str> = list
        .harness
        .iter()
        .map(|entry| entry.name.as_str())
        .collect();
    // Each change is a run of one or two harnesses, on a core: as many at a time as there are cores.
    let mutations = mutations(&list);
    let queue = Mutex::new(mutations.iter());
    let silent = Mutex::new(Vec::new());
    let next = || queue.lock().expect("no run panics while it takes").next();
    let run = || {
        while let Some(([file, old, new], (number, harnesses))) = next() {
            let noticed = failed(&binary, *number, harnesses);
            for name in harnesses.iter().filter(|name| !noticed.contains(name)) {
                let text = format!("{name}: {file}: `{old}` → `{new}`");
                silent.lock().expect("no run panics here").push(text);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..available_parallelism().map_or(1, usize::from) {
            scope.spawn(run);
        }
    });
    let none = failed(&binary, 0, &all);
    assert!(none.is_empty(), "without a change these fail: {none:?}");
    let silent = silent.into_inner().expect("every run ended");
    assert!(silent.is_empty(), "not noticed:\n{}", silent.join("\n"));
}
