//! Ten thousand mutations of the shipped scenes: read or refused with a line, never a panic.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use passivity_fuzz::Random;
use passivity_scene::Scene;
use passivity_scene::check::check;

const CASES: u64 = 10_000;

/// Every how many scenes that are read the verdict is asked as well.
const CHECKED: u64 = 20;

/// What no scene may take.
const LIMIT: Duration = Duration::from_secs(1);

/// Pieces that a parser may trip over.
const PIECES: [&[u8]; 24] = [
    b"\0",
    b"\xff",
    b"\xc3",
    b"\"",
    b"'",
    b"\"\"\"",
    b"[",
    b"]",
    b"[[",
    b"{",
    b"}",
    b"=",
    b".",
    b"#",
    b"\n",
    b"\r",
    b"\\",
    b"e999999999",
    b"nan",
    b"/0",
    b"-",
    "±".as_bytes(),
    "µ".as_bytes(),
    b"%",
];

fn mutate(scenes: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut text = scenes[random.below(scenes.len())].clone();
    for _ in 0..=random.below(3) {
        let at = random.below(text.len() + 1);
        let len = random.below(40).min(text.len() - at);
        match random.below(10) {
            0 if at < text.len() => text[at] ^= 1 << random.below(8),
            1 => text.insert(at, u8::try_from(random.below(256)).unwrap()),
            2 => drop(text.drain(at..at + len)),
            3 => {
                let piece = text[at..at + len].to_vec();
                let to = random.below(text.len() + 1);
                text.splice(to..to, piece);
            }
            4 => swap_tokens(&mut text, random),
            5 => inflate(&mut text, random),
            6 => drop(text.splice(at..at, random.pick(&PIECES).iter().copied())),
            7 => text.truncate(at),
            8 => {
                let other = &scenes[random.below(scenes.len())];
                let from = random.below(other.len());
                text.splice(at..at, other[from..].iter().copied());
            }
            _ => {
                let piece = random.pick(&PIECES).repeat(1 + random.below(5000));
                text.splice(at..at, piece);
            }
        }
    }
    text
}

/// Swaps two words.
fn swap_tokens(text: &mut Vec<u8>, random: &mut Random) {
    let mut words: Vec<Vec<u8>> = text.split(|b| *b == b' ').map(<[u8]>::to_vec).collect();
    let (a, b) = (random.below(words.len()), random.below(words.len()));
    words.swap(a, b);
    *text = words.join(&b' ');
}

/// Makes a number longer, or gives it another sign or exponent.
fn inflate(text: &mut Vec<u8>, random: &mut Random) {
    let digits: Vec<usize> = (0..text.len())
        .filter(|i| text[*i].is_ascii_digit())
        .collect();
    let Some(at) = digits.get(random.below(digits.len())).copied() else {
        return;
    };
    let more = match random.below(5) {
        0 => b"9".repeat(1 + random.below(30_000)),
        1 => b"e"
            .iter()
            .chain(&b"9".repeat(1 + random.below(8)))
            .copied()
            .collect(),
        2 => b"0.".to_vec(),
        3 => b"-".to_vec(),
        _ => b"/"
            .iter()
            .chain(&b"7".repeat(1 + random.below(400)))
            .copied()
            .collect(),
    };
    text.splice(at..at, more);
}

#[test]
fn ten_thousand_mutated_scenes_are_read_or_refused() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|f| f.unwrap().path())
        .collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == "toml"));
    paths.sort();
    let scenes: Vec<Vec<u8>> = paths.iter().map(|path| fs::read(path).unwrap()).collect();
    assert!(scenes.len() >= 13);
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mutated.toml");
    let mut random = Random::new(2005);
    let (mut read, mut refused) = (0_u64, 0_u64);
    for case in 0..CASES {
        let text = mutate(&scenes, &mut random);
        // Only bytes that are no text need a file; ten thousand files take a disk's time.
        let attempt = || match std::str::from_utf8(&text) {
            Ok(text) => Scene::from_toml("mutated", text),
            Err(_) => {
                fs::write(&target, &text).unwrap();
                Scene::read(&target)
            }
        };
        let start = Instant::now();
        let outcome = attempt();
        let mut taken = start.elapsed();
        if taken > LIMIT / 2 {
            // Slow input is slow every time, a busy machine is not.
            let again = Instant::now();
            let _ = attempt();
            taken = taken.min(again.elapsed());
        }
        assert!(taken < LIMIT, "case {case} took {taken:?}");
        match outcome {
            Ok(scene) => {
                read += 1;
                if read % CHECKED == 0 {
                    let _ = check(&scene).to_json();
                }
            }
            Err(error) => {
                refused += 1;
                for diagnostic in error.diagnostics() {
                    let line = diagnostic.line();
                    assert!(line.is_some(), "case {case} has no line: {error}");
                }
                assert!(!error.render(false).is_empty());
            }
        }
    }
    // Both ends are exercised, or the mutations are too mild or too wild.
    assert!(
        read > CASES / 20 && refused > CASES / 4,
        "{read} read, {refused} refused"
    );
}
