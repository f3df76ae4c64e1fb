//! Every reader on its committed inputs, and on a fixed number of mutations of them.
//!
//! The mutations come from a fixed seed, so that a failure comes back. They are a net under what
//! libFuzzer found (`fuzz/run`), not a replacement for it.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use passivity_fuzz::{Random, TARGETS};

/// Mutated inputs of each reader; together they take some seconds.
const MUTATIONS: u32 = 1000;

/// Pieces that change what a reader does.
const WORDS: [&[u8]; 28] = [
    b"\n",
    b"\r\n",
    b",",
    b"\"",
    b"\xef\xbb\xbf",
    b"\xff",
    b"\0",
    b"NaN",
    b"inf",
    b"-",
    b"1/0",
    b"1e999999999",
    b"1e-4096",
    b"9223372036854775807",
    b"-9223372036854775808",
    b"0.1",
    b"2147483648",
    b"xi",
    b"count",
    b"x [rad]",
    b"t [s]",
    b"{",
    b"}",
    b"[",
    b"]",
    b"null",
    b"PAR1",
    b"\xff\xff\xff\x7f",
];

fn corpus(name: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("corpus")
        .join(name);
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    let read = |path: PathBuf| (path.clone(), std::fs::read(path).unwrap());
    files.into_iter().map(read).collect()
}

fn mutated(inputs: &[(PathBuf, Vec<u8>)], random: &mut Random) -> Vec<u8> {
    let mut bytes = inputs[random.below(inputs.len())].1.clone();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(9)).min(bytes.len());
        match random.below(6) {
            0 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            1 => bytes.truncate(at),
            2 => drop(bytes.drain(at..end)),
            3 => drop(bytes.splice(at..at, random.pick(&WORDS).iter().copied())),
            4 => {
                let other = &inputs[random.below(inputs.len())].1;
                let from = random.below(other.len() + 1);
                drop(bytes.splice(at..end, other[from..].iter().copied().take(64)));
            }
            _ => {
                let piece = bytes[at..end].to_vec();
                drop(bytes.splice(at..at, piece));
            }
        }
    }
    bytes
}

fn holds(run: fn(&[u8]), bytes: &[u8], what: &str) {
    let outcome = catch_unwind(AssertUnwindSafe(|| run(bytes)));
    assert!(
        outcome.is_ok(),
        "{what}: {:?}",
        String::from_utf8_lossy(bytes)
    );
}

fn replay(name: &str) {
    let target = passivity_fuzz::target(name);
    let inputs = corpus(name);
    assert!(inputs.len() >= 5, "{name} has {} inputs", inputs.len());
    for (path, bytes) in &inputs {
        holds(target.run, bytes, &path.display().to_string());
    }
    holds(target.run, b"", name);
    let mut random = Random::new(name.len() as u64);
    for i in 0..passivity_random::draws(MUTATIONS) {
        holds(
            target.run,
            &mutated(&inputs, &mut random),
            &format!("{name}, mutation {i}"),
        );
    }
}

#[test]
fn scenes() {
    replay("scene");
}

#[test]
fn csv_traces() {
    replay("csv");
}

#[test]
fn parquet_traces() {
    replay("parquet");
}

#[test]
fn mcap_traces() {
    replay("mcap");
}

#[test]
fn requests() {
    replay("request");
}

#[test]
fn answers() {
    replay("answers");
}

#[test]
fn every_target_has_a_corpus_and_a_fuzzer() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifest = std::fs::read_to_string(here.join("libfuzzer/Cargo.toml")).unwrap();
    let mut folders: Vec<String> = std::fs::read_dir(here.join("corpus"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let mut names: Vec<&str> = TARGETS.iter().map(|target| target.name).collect();
    for name in &names {
        let text =
            std::fs::read_to_string(here.join(format!("libfuzzer/targets/{name}.rs"))).unwrap();
        assert!(text.contains(&format!("target(\"{name}\")")), "{name}");
        assert!(manifest.contains(&format!("targets/{name}.rs")), "{name}");
    }
    names.sort_unstable();
    folders.sort_unstable();
    assert_eq!(folders, names);
}
