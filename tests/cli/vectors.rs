//! `passivity vectors`: the committed files, and other implementations driven through them.

use std::fs;
use std::path::{Path, PathBuf};

use crate::harness::Dir;

fn tests() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests")
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
    // That it passes all of them, the tests of the vectors show.
    let sound = ["vectors", "--against", "python3 sound.py"];
    let run = dir.run(&[&sound[..], &["--group", "errata", "--group", "intervals"]].concat());
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
    let groups = ["errata", "intervals", "effects"];
    let mut args = vec!["vectors", "--against", "python3 broken.py"];
    args.extend(["--format", "json"]);
    groups
        .iter()
        .for_each(|group| args.extend(["--group", group]));
    let run = dir.run(&args);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let report = run.json();
    let committed = groups.map(|group| {
        let text = fs::read_to_string(tests().join(format!("vectors/{group}.json"))).unwrap();
        let committed: serde_json::Value = serde_json::from_str(&text).unwrap();
        committed["number_of_tests"].as_u64().unwrap()
    });
    assert_eq!(report["tests"], committed.iter().sum::<u64>());
    let differences = report["differences"].as_array().unwrap();
    assert!(
        differences
            .iter()
            .any(|d| d["group"] == "errata" && d["fields"][0]["field"] == "bound_22")
    );
    let mut ids: Vec<u64> = Vec::new();
    for difference in differences {
        for field in difference["fields"].as_array().unwrap() {
            let field = field["field"].as_str().unwrap();
            assert!(
                field.contains("bound_22") || field.contains("bound_quantized"),
                "{difference}"
            );
        }
        assert!(difference["request"]["op"].is_string(), "{difference}");
        assert!(difference["expected"].is_object() && difference["answer"]["result"].is_object());
        ids.push(difference["id"].as_u64().unwrap());
    }
    // One entry a test.
    let listed = ids.len();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), listed);
}

#[test]
fn silence_talk_and_a_command_that_is_not_there_fail_every_test() {
    let dir = Dir::new();
    let counts = |run: &crate::harness::Run| -> Vec<usize> {
        let last = run.stdout.lines().last().unwrap();
        let words = last.split_whitespace();
        words.filter_map(|word| word.parse().ok()).collect()
    };
    for command in ["yes", "true", "passivity-no-such-command 2>/dev/null"] {
        let run = dir.run(&["vectors", "--against", command, "--group", "errata"]);
        assert_eq!(run.code, 1, "{command}: {}", run.stderr);
        let errata = counts(&run);
        assert!(errata[0] >= 400, "{errata:?}");
        assert_eq!(errata[0], errata[1], "{command}");
    }
}

#[test]
fn groups_are_chosen_by_name_and_written_byte_for_byte_as_committed() {
    let dir = Dir::new();
    let run = dir.run(&["vectors", "--against", "true", "--group", "errata"]);
    // Its tests keep the numbers that they have among all.
    let text = fs::read_to_string(tests().join("vectors/errata.json")).unwrap();
    let committed: serde_json::Value = serde_json::from_str(&text).unwrap();
    let number = &committed["number_of_tests"];
    let last = format!("{number} tests, {number} differences\n");
    assert!(run.stdout.ends_with(&last), "{}", run.stdout);
    // Vectors of another version are written anew.
    fs::create_dir(dir.path("two")).unwrap();
    let old = "{\"schema\": \"schema.json\", \"group\": \"edges\"}";
    dir.write("two/edges.json", old);
    let two = dir.run(&[
        "vectors",
        "--out",
        "two",
        "--group",
        "edges",
        "--group",
        "intervals",
    ]);
    assert_eq!(two.code, 0, "{}", two.stderr);
    for name in ["edges.json", "intervals.json", "schema.json"] {
        let written = fs::read(dir.path("two").join(name)).unwrap();
        assert!(written == fs::read(tests().join("vectors").join(name)).unwrap());
    }
    assert!(!dir.path("two").join("errata.json").exists());
    // What differs is shown with the request and both answers.
    assert!(run.stdout.starts_with("errata "), "{}", run.stdout);
    for word in ["\n  request:  {", "\n  expected: {", "\n  answer:   none"] {
        assert!(run.stdout.contains(word), "{}", run.stdout);
    }
    let wrong = dir.run(&["vectors", "--group", "no-such-group"]);
    assert_eq!(wrong.code, 2);
    assert!(
        wrong
            .stderr
            .contains("there is no group `no-such-group`: the groups are "),
        "{}",
        wrong.stderr
    );
}

#[test]
fn a_silent_command_is_given_up_and_ended_with_its_children() {
    let dir = Dir::new();
    // The shell starts a process of its own, which would outlive it.
    let command = "sleep 600 & echo $! > pid; wait";
    let begin = std::time::Instant::now();
    let args = [
        "vectors",
        "--against",
        command,
        "--group",
        "errata",
        "--timeout",
        "1",
    ];
    let run = dir.run(&args);
    assert_eq!(run.code, 1, "{}", run.stderr);
    assert!(begin.elapsed().as_secs() < 30);
    let pid = fs::read_to_string(dir.path("pid")).unwrap();
    let state = format!("/proc/{}/stat", pid.trim());
    // Ended, or a zombie that nobody has waited for yet.
    let is_running = |state: &str| {
        let text = fs::read_to_string(state).unwrap_or_default();
        let after = text.rsplit(") ").next().unwrap_or_default().to_owned();
        !after.is_empty() && !after.starts_with('Z')
    };
    for _ in 0..50 {
        if !is_running(&state) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(100));
    }
    panic!("process {pid} still runs");
}
