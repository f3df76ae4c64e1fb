//! Help, completions, man page, mistakes in typing, and the licences that come with each package.

use std::path::Path;

use crate::harness::{Dir, root};

#[test]
fn help_shows_examples_and_exit_codes() {
    let dir = Dir::new();
    let help = dir.run(&["--help"]);
    assert_eq!(help.code, 0);
    assert!(help.stdout.contains("Examples:") && help.stdout.contains("Exit codes:"));
    let check = dir.run(&["check", "--help"]);
    assert!(check.stdout.contains("passivity check scenes/re35.toml"));
}

/// `plane` is of one joint: no example of it is of a scene that `init` begins with several.
#[test]
fn plane_is_shown_with_no_scene_of_several_joints() {
    let dir = Dir::new();
    let init = dir.run(&["init", "--help"]).stdout;
    let (_, of_joints) = init.split_once("init joints --out ").expect("an example");
    let name = of_joints.split_whitespace().next().expect("a name");
    let plane = dir.run(&["plane", "--help"]).stdout;
    assert!(!plane.contains(name), "{name}: {plane}");
}

#[test]
fn the_trace_of_the_first_example_of_audit_is_written_by_one_of_simulate() {
    let dir = Dir::new();
    let examples = |verb: &str| -> Vec<String> {
        let help = dir.run(&["help", verb]).stdout;
        let start = format!("  passivity {verb} ");
        let lines = help.lines().filter_map(|line| line.strip_prefix(&start));
        lines.map(str::to_owned).collect()
    };
    let audit = examples("audit");
    let trace = audit[0].split(' ').next().expect("a trace");
    let out = format!("--out {trace}");
    let writes: Vec<String> = examples("simulate");
    let writes: Vec<&String> = writes.iter().filter(|line| line.contains(&out)).collect();
    assert_eq!(writes.len(), 1, "{writes:?}");
    // What holds bounds only is no trace.
    assert!(!writes[0].contains("enclosure"), "{writes:?}");
}

#[test]
fn help_wraps_as_it_was_written() {
    let dir = Dir::new();
    let verbs = [
        "check", "explain", "design", "export", "init", "schema", "simulate", "sweep", "plane",
        "accuracy", "audit", "identify", "oracle", "vectors", "case",
    ];
    for verb in verbs {
        let help = dir.run(&["help", verb]).stdout;
        assert!(!help.contains("\\\""), "{verb}: {help}");
        let Some((_, after)) = help.split_once("\nExample") else {
            continue;
        };
        // A line that was too long leaves a word or a few on a line of their own.
        let lines: Vec<&str> = after.lines().collect();
        for pair in lines.windows(2) {
            let wrapped = !pair[0].starts_with(' ') && pair[0].chars().count() < 60;
            let broken = wrapped && !pair[0].is_empty() && !pair[1].is_empty();
            assert!(
                !broken || pair[0].starts_with(['s', ':']),
                "{verb}: {pair:?}"
            );
            let alone = pair[1].starts_with("  ") && pair[1].split_whitespace().count() == 1;
            assert!(!alone || pair[0].ends_with('\\'), "{verb}: {pair:?}");
        }
    }
    let oracle = dir.run(&["help", "oracle"]).stdout;
    assert!(oracle.contains("`motion`"), "{oracle}");
}

#[test]
fn completions_and_man_page_come_from_the_same_table() {
    let dir = Dir::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let run = dir.run(&["completions", shell]);
        assert_eq!(run.code, 0);
        assert!(
            run.stdout.contains("check") && run.stdout.contains("plane"),
            "{shell}"
        );
    }
    let man = dir.run(&["man"]);
    assert!(man.stdout.contains(".TH passivity") && man.stdout.contains("check"));
    let verb = dir.run(&["man", "check"]);
    assert!(verb.stdout.contains("SCENE"), "{}", verb.stdout);
}

#[test]
fn mistakes_in_typing_exit_with_2() {
    let dir = Dir::new();
    for args in [
        &["chek"][..],
        &["check"],
        &["check", "--format", "xml", "a.toml"],
        &["man", "chek"],
        &[],
    ] {
        let run = dir.run(args);
        assert_eq!(run.code, 2, "{args:?}");
        assert!(!run.stderr.is_empty() && run.stdout.is_empty(), "{args:?}");
    }
}

/// Cargo packs what is in the folder of a crate: the licences of the repository are to be there too.
/// A case is checked without scenes: the usage beside the error does not have them.
#[test]
fn a_case_is_written_of_scenes_and_checked_without() {
    let dir = Dir::new();
    let usage = "Usage: passivity case [OPTIONS] --out <DIR> <SCENE>...\n       \
                 passivity case [OPTIONS] --check <DIR>\n";
    for (word, value) in [("a.toml", None), ("--log", Some("a.csv"))] {
        let words = ["case", "--check", "case", word];
        let run = dir.run(&[&words[..], value.as_slice()].concat());
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains("cannot be used with"), "{}", run.stderr);
        assert!(run.stderr.contains(usage), "{}", run.stderr);
    }
    assert!(dir.run(&["case", "--help"]).stdout.contains(usage));
}

#[test]
fn every_crate_that_is_published_has_both_licences() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut published = 0;
    for entry in std::fs::read_dir(root.join("crates")).expect("the crates") {
        let folder = entry.expect("an entry").path();
        let Ok(manifest) = std::fs::read_to_string(folder.join("Cargo.toml")) else {
            continue;
        };
        if manifest.contains("\npublish = false\n") {
            continue;
        }
        for licence in ["LICENSE-APACHE", "LICENSE-MIT"] {
            let own = std::fs::read(folder.join(licence));
            let shared = std::fs::read(root.join(licence)).expect("a licence");
            assert!(
                own.is_ok_and(|own| own == shared),
                "{}: {licence}",
                folder.display()
            );
        }
        published += 1;
    }
    assert!(published > 10, "{published}");
}

#[test]
fn a_mistake_is_told_by_what_was_typed() {
    let dir = Dir::new();
    let text =
        "[dimensionless]\nmu = \"50\"\nbeta = \"1\"\nsigma = \"1\"\n[start]\nvelocity = \"1\"\n";
    let scene = dir.write("scene.toml", text);
    let re35 = root().join("scenes/re35.toml").display().to_string();
    let wrong = "[sampling]\nrate = \"1 kHz ± 1 ±\"\n[wall]\nstiffness = \"1 N/m\"\n";
    let wrong = dir.write("wrong.toml", wrong);
    let smooth = "[device]\nviscous = \"1e-3 N m s/rad\"\n[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"3 N m/rad\"\n";
    let smooth = dir.write("smooth.toml", smooth);
    let no_ticks = "error: --speed `5`: `smooth` has no encoder, and so no ticks: expected a speed with a unit, as in `5 rad/s`";
    for (args, says) in [
        (
            &["simulate", &scene, "--speed", "1e300"][..],
            "error: --speed `1e300`: ",
        ),
        (
            &["accuracy", &scene, "--speed", "1e300"],
            "error: --speed `1e300`: ",
        ),
        (&["check", &wrong], "expected a unit here, found `±`"),
        // A number below zero is a value, not an option.
        (
            &[
                "plane",
                &re35,
                "--axes",
                "stiffness,damping",
                "--x",
                "-1:1",
                "--plot",
                "p.svg",
            ],
            "--x `-1:1`: expected FROM not below zero",
        ),
        (&["design", &re35, "--rates", "-1 kHz"], "-1 kHz"),
        (
            &["identify", &scene, "log.csv", "--effort", "-1"],
            "expected a whole number from 1 to 100000",
        ),
        (
            &["case", &scene, "--out", "case", "--effort", "-1"],
            "expected a whole number from 1 to 100000",
        ),
        (&["simulate", &smooth, "--speed", "5"], no_ticks),
        (&["accuracy", &smooth, "--speed", "5"], no_ticks),
        (
            &["simulate", &re35, "--speed", "1 ± 10%"],
            "--speed `1 ± 10%`: expected one number of ticks per sample, without a tolerance",
        ),
    ] {
        let run = dir.run(args);
        assert_eq!(run.code, 2, "{args:?}: {}", run.stderr);
        assert!(run.stderr.contains(says), "{args:?}: {}", run.stderr);
        assert!(!run.stderr.contains("\\u{"), "{}", run.stderr);
        assert!(!run.stderr.contains("tip:"), "{}", run.stderr);
    }
    let run = dir.run(&["simulate", &scene, "--intervals", "1e1", "--format", "json"]);
    assert_eq!(run.json()["intervals"], 10, "{}", run.stderr);
}
