//! `passivity audit` in pieces: partial accounts, and the array jobs of the documentation.

use crate::harness::Dir;

#[test]
fn partial_accounts_are_merged_into_the_report_of_the_whole() {
    let dir = Dir::new();
    let scene = dir.write(
        "scene.toml",
        "[dimensionless]\nbeta = \"3/5\"\nsigma = \"1/5\"\n",
    );
    let mut text = "tau,count\n".to_owned();
    for i in 0..3000_u64 {
        text.push_str(&format!("{i},{}\n", (i * i) % 23));
    }
    let log = dir.write("log.csv", text);
    let whole = dir.run(&["audit", &log, "--scene", &scene, "--format", "json"]);
    assert_eq!(whole.code, 1);
    for (option, pieces) in [
        ("--range", ["0:100", "100:2950", "2950:"]),
        ("--shard", ["1/3", "2/3", "3/3"]),
    ] {
        for (name, piece) in ["a.json", "b.json", "c.json"].iter().zip(pieces) {
            let run = dir.run(&[
                "audit",
                &log,
                "--scene",
                &scene,
                option,
                piece,
                "--partial",
                name,
            ]);
            assert_eq!(run.code, 0, "{}", run.stderr);
            assert!(run.stdout.contains("intervals"), "{}", run.stdout);
        }
        let merge = |parts: &[&str]| {
            let mut all = vec!["audit", "--scene", &scene, "--format", "json", "--merge"];
            all.extend(parts);
            dir.run(&all)
        };
        let run = merge(&["c.json", "a.json", "b.json"]);
        assert_eq!((run.code, &run.stdout), (whole.code, &whole.stdout));
        let refused = |parts: &[&str], why: &str| {
            let run = merge(parts);
            assert_eq!(run.code, 2);
            assert!(run.stderr.contains(why), "{}", run.stderr);
        };
        refused(&["a.json", "c.json"], "is missing, before `c.json`");
        refused(&["a.json", "b.json"], "end of the log is missing");
        dir.write(
            "twin.json",
            std::fs::read(dir.path("b.json")).expect("a part"),
        );
        refused(
            &["a.json", "b.json", "twin.json", "c.json"],
            "account for the same samples",
        );
        dir.write("no.json", "{}");
        refused(
            &["a.json", "b.json", "no.json", "c.json"],
            "no.json: this is no partial account",
        );
    }
    // Of another log, and in another scene.
    let other = dir.write("other.csv", "tau,count\n0,1\n1,2\n");
    dir.run(&[
        "audit",
        &other,
        "--scene",
        &scene,
        "--partial",
        "other.json",
    ]);
    let run = dir.run(&[
        "audit",
        "--scene",
        &scene,
        "--merge",
        "a.json",
        "other.json",
    ]);
    assert!(
        run.stderr.contains("`other.json` is of another log"),
        "{}",
        run.stderr
    );
    let far = dir.write(
        "far.toml",
        "[dimensionless]\nbeta = \"4/5\"\nsigma = \"1/5\"\n",
    );
    let run = dir.run(&["audit", "--scene", &far, "--merge", "a.json"]);
    assert!(
        run.stderr
            .contains("`a.json` is an account in another scene"),
        "{}",
        run.stderr
    );
    let run = dir.run(&["audit", &log, "--scene", &scene, "--range", "1:2"]);
    assert!(
        run.code == 2 && run.stderr.contains("--partial"),
        "{}",
        run.stderr
    );
    // Nor beside what is of the whole trace.
    for piece in [["--range", "1:2"], ["--shard", "1/2"]] {
        for whole in ["--out", "--plot", "--certificate"] {
            let mut words = vec!["audit", &log, "--scene", &scene, whole, "whole.svg"];
            words.extend(piece);
            let run = dir.run(&words);
            assert!(
                run.code == 2 && run.stderr.contains("cannot be used with"),
                "{}",
                run.stderr
            );
            assert!(!dir.path("whole.svg").exists());
        }
    }
    let run = dir.run(&["audit", &log, "--scene", &scene, "--partial", &log]);
    assert!(
        run.code == 2 && run.stderr.contains("is read by this audit"),
        "{}",
        run.stderr
    );
}

/// Runs a job of an array of so many tasks as Slurm would.
fn task(dir: &Dir, script: &str, id: u32, of: u32, args: &[&str]) {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/cluster/");
    let binary = std::path::Path::new(env!("CARGO_BIN_EXE_passivity"));
    let folder = binary.parent().expect("a folder").display();
    let path = std::env::var("PATH").expect("a path");
    let run = std::process::Command::new("sh")
        .arg(format!("{root}{script}"))
        .args(args)
        .env("PATH", format!("{folder}:{path}"))
        .env("SLURM_ARRAY_TASK_ID", id.to_string())
        .env("SLURM_ARRAY_TASK_COUNT", of.to_string())
        .current_dir(dir.path(""))
        .output()
        .expect("a shell");
    assert!(
        run.status.success(),
        "{}",
        String::from_utf8_lossy(&run.stderr)
    );
}

#[test]
fn the_array_jobs_of_the_documentation_run() {
    let dir = Dir::new();
    let scene = dir.write(
        "scene.toml",
        "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n[start]\nvelocity = \"5\"\n[run]\nintervals = 300\n",
    );
    let trace = dir.run(&["simulate", &scene, "--out", "log.csv"]);
    assert!(trace.code < 2, "{}", trace.stderr);
    let grid = ["--beta", "0:1:5", "--sigma", "0:1:5"];
    // All three, and then two of them again, as those that failed: one whose piece is gone, and one whose piece is there.
    for (id, of) in [(1, 3), (2, 3), (3, 3), (2, 2), (3, 2)] {
        if (id, of) == (2, 2) {
            for part in ["parts/part-2.json", "grid/part-2.parquet"] {
                std::fs::remove_file(dir.path(part)).expect("a part");
            }
        }
        let audit = ["3", "log.csv", &scene, "parts"];
        task(&dir, "audit.sbatch", id, of, &audit);
        let mut args = vec!["3", scene.as_str(), "grid"];
        args.extend(grid);
        task(&dir, "sweep.sbatch", id, of, &args);
    }
    let parts = [
        "parts/part-1.json",
        "parts/part-2.json",
        "parts/part-3.json",
    ];
    let mut merge = vec!["audit", "--scene", &scene, "--format", "json", "--merge"];
    merge.extend(parts);
    let whole = dir.run(&["audit", "log.csv", "--scene", &scene, "--format", "json"]);
    assert_eq!(dir.run(&merge).stdout, whole.stdout);
    let sweep = |more: &[&str]| {
        let mut args = vec!["sweep", scene.as_str()];
        args.extend(grid);
        args.extend(more);
        assert_eq!(dir.run(&args).code, 0);
    };
    sweep(&["--out", "whole.parquet"]);
    let parts = [
        "grid/part-1.parquet",
        "grid/part-2.parquet",
        "grid/part-3.parquet",
    ];
    sweep(&[
        "--out",
        "merged.parquet",
        "--merge",
        parts[0],
        parts[1],
        parts[2],
    ]);
    let read = |name: &str| std::fs::read(dir.path(name)).expect("a file");
    assert!(read("whole.parquet") == read("merged.parquet"));
}

/// A partial account is a file of bounded size: neither a device nor what a shell hands over takes all memory.
#[cfg(unix)]
#[test]
fn what_has_no_end_is_no_partial_account() {
    let dir = Dir::new();
    dir.write(
        "scene.toml",
        "[dimensionless]\nbeta = \"3/5\"\nsigma = \"1/5\"\n",
    );
    for (part, says) in [
        ("/dev/zero", "this is a pipe or a device"),
        ("/dev/stdin", "at most 67108864 bytes"),
        ("none.json", "there is no such file"),
    ] {
        let command = format!(
            "'{}' audit --merge {part} --scene scene.toml < /dev/zero",
            env!("CARGO_BIN_EXE_passivity")
        );
        let run = std::process::Command::new("sh")
            .args(["-c", &command])
            .current_dir(dir.path("."))
            .output()
            .expect("a shell");
        let error = String::from_utf8(run.stderr).unwrap();
        assert_eq!(run.status.code(), Some(2), "{part}: {error}");
        assert!(
            error.contains(part) && error.contains(says),
            "{part}: {error}"
        );
    }
}
