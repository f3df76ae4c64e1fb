//! `passivity vectors`: the committed files, and other implementations driven through them.

use std::fs;
use std::path::{Path, PathBuf};

use crate::harness::Dir;

fn tests() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests")
}

#[test]
fn writes_the_committed_files_byte_for_byte() {
    let dir = Dir::new();
    for _ in 0..2 {
        assert_eq!(dir.run(&["vectors", "--out", "vectors"]).code, 0);
    }
    let mut files = 0;
    for entry in fs::read_dir(dir.path("vectors")).unwrap() {
        let entry = entry.unwrap();
        let committed = tests().join("vectors").join(entry.file_name());
        assert!(
            fs::read(entry.path()).unwrap() == fs::read(&committed).unwrap(),
            "{}",
            committed.display()
        );
        files += 1;
    }
    assert_eq!(
        files,
        fs::read_dir(tests().join("vectors")).unwrap().count()
    );
}

#[test]
fn another_implementation_passes_and_a_broken_copy_is_told_where_it_differs() {
    let dir = Dir::new();
    let text = fs::read_to_string(tests().join("conformance/passivity_ref.py")).unwrap();
    dir.write("sound.py", &text);
    for module in ["costs.py", "drawn.py"] {
        let path = tests().join("conformance").join(module);
        dir.write(module, fs::read_to_string(path).unwrap());
    }
    let run = dir.run(&["vectors", "--against", "python3 sound.py"]);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    assert!(
        run.stdout.trim_end().ends_with(" tests, 0 differences"),
        "{}",
        run.stdout
    );
    // The paper's bound (22) without the absolute value.
    let sound = "HALF * d * d + HALF * abs(d)";
    assert_eq!(text.matches(sound).count(), 1);
    dir.write("broken.py", text.replace(sound, "HALF * d * d + HALF * d"));
    let run = dir.run(&[
        "vectors",
        "--against",
        "python3 broken.py",
        "--format",
        "json",
    ]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let report = run.json();
    assert!(report["tests"].as_u64().unwrap() >= 2000);
    let differences = report["differences"].as_array().unwrap();
    assert!(
        differences
            .iter()
            .any(|d| d["group"] == "errata" && d["field"] == "bound_22")
    );
    for difference in differences {
        let field = difference["field"].as_str().unwrap();
        assert!(
            field.contains("bound_22") || field.contains("bound_quantized"),
            "{difference}"
        );
    }
}

#[test]
fn silence_talk_and_a_command_that_is_not_there_fail_every_test() {
    let dir = Dir::new();
    for command in ["true", "yes", "passivity-no-such-command 2>/dev/null"] {
        let run = dir.run(&["vectors", "--against", command]);
        assert_eq!(run.code, 1, "{command}: {}", run.stderr);
        let last = run.stdout.lines().last().unwrap();
        let numbers: Vec<usize> = last
            .split_whitespace()
            .filter_map(|word| word.parse().ok())
            .collect();
        assert!(
            numbers[0] >= 2000 && numbers[0] == numbers[1],
            "{command}: {last}"
        );
    }
}
