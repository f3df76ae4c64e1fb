//! What is written, and what stays: results beside what is read, refused commands, readers that have gone.

mod read;

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::harness::Dir;

const SCENE: &str = "[dimensionless]\nmu = \"50\"\nbeta = \"1\"\nsigma = \"1\"\n";

/// A folder with a scene, one that takes its forces from a file, one that is not passive, logs, and measured points.
fn folder() -> Dir {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    let forces = "[operator]\nforce = \"forces.csv\"\n[run]\nintervals = 9\n";
    dir.write("forced.toml", format!("{SCENE}{forces}"));
    dir.write("forces.csv", "f\n0\n1\n0\n");
    dir.write("device.toml", crate::logs::SCENE);
    dir.write(
        "free.toml",
        "[dimensionless]\nbeta = \"0\"\nsigma = \"0\"\n",
    );
    let stiff = crate::logs::SCENE.replace("\"1 N m/rad", "\"1000 N m/rad");
    dir.write("stiff.toml", stiff);
    dir.write("log.csv", "count\n0\n1\n0\n");
    dir.write("log.tmp", "count\n0\n1\n0\n");
    dir.write("torn.csv", "count\n0\n1\n0\nx\n");
    let points = "stiffness [N m/rad],damping [N m s/rad],stable\n0.1,1e-5,stable\n";
    dir.write("bench.csv", points);
    dir
}

/// The files of a folder with what is in them; links are followed.
fn files(dir: &Dir) -> Vec<(String, Vec<u8>)> {
    let entries = std::fs::read_dir(dir.path("")).unwrap();
    let mut files: Vec<_> = entries
        .map(|entry| entry.unwrap())
        .filter(|entry| !entry.path().is_dir())
        .map(|entry| {
            let name = entry.file_name().into_string().unwrap();
            (name, std::fs::read(entry.path()).unwrap())
        })
        .collect();
    files.sort();
    files
}

/// Runs a command that is refused, and loses nothing and leaves nothing behind.
#[track_caller]
fn refused(dir: &Dir, command: &str, says: &str) {
    let before = files(dir);
    let run = dir.run(&command.split_whitespace().collect::<Vec<_>>());
    assert_eq!(run.code, 2, "{command}: {}{}", run.stdout, run.stderr);
    assert!(run.stderr.contains(says), "{command}: {}", run.stderr);
    assert!(files(dir) == before, "{command}: the files are others");
}

#[test]
fn a_command_that_is_refused_leaves_what_was_there() {
    let dir = folder();
    dir.write(
        "light.toml",
        "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n",
    );
    for there in [true, false] {
        if there {
            dir.write("rows.csv", "earlier rows\n");
        } else {
            std::fs::remove_file(dir.path("rows.csv")).unwrap();
        }
        for (command, says) in [
            ("audit missing.csv --scene scene.toml", "missing.csv"),
            ("audit rows.toml --scene scene.toml", "rows.toml"),
            ("audit forces.csv --scene scene.toml", "forces.csv"),
            (
                "simulate scene.toml --speed 1 --method exact",
                "viscous friction",
            ),
            (
                "sweep light.toml --beta 1 --sigma 1 --speed 1",
                "light.toml",
            ),
            (
                "sweep scene.toml --beta 1 --sigma 1 --speed 1e300",
                "speed = 1e300",
            ),
        ] {
            refused(&dir, &format!("{command} --out rows.csv"), says);
        }
    }
    // One point of many, where the others can be simulated.
    dir.write("rows.csv", "earlier rows\n");
    refused(
        &dir,
        "sweep scene.toml --vary beta=0:1:9 --vary velocity=1,1e300 --out rows.csv",
        "1e120",
    );
}

#[test]
fn a_folder_that_is_not_there_is_refused_before_any_work() {
    let dir = folder();
    for (command, option) in [
        ("audit log.csv --scene scene.toml", "--plot"),
        ("identify log.csv --scene scene.toml", "--plot"),
        ("identify log.csv --scene scene.toml", "--out"),
        ("check scene.toml", "--certificate"),
    ] {
        let command = format!("{command} {option} absent/picture.svg");
        let says = format!("absent/picture.svg: there is no folder `absent` for {option}");
        refused(&dir, &command, &says);
        let run = dir.run(&command.split(' ').collect::<Vec<_>>());
        assert_eq!(run.stdout, "", "{command}");
    }
}

#[test]
fn rows_before_a_mistake_are_kept() {
    let dir = folder();
    dir.write("rows.csv", "earlier rows\n");
    let args = ["audit", "torn.csv", "--scene", "scene.toml", "--out"];
    let run = dir.run(&[&args[..], &["rows.csv"]].concat());
    assert_eq!(run.code, 2, "{}", run.stdout);
    let rows = std::fs::read_to_string(dir.path("rows.csv")).unwrap();
    // A header, and the two intervals before the mistake.
    assert_eq!(rows.lines().count(), 3, "{rows}");
}

#[test]
fn a_killed_command_leaves_what_was_there() {
    use std::io::Write as _;
    let dir = folder();
    dir.write("rows.csv", "earlier rows\n");
    let mut child = Command::new(env!("CARGO_BIN_EXE_passivity"))
        .args(["audit", "-", "--scene", "scene.toml", "--out", "rows.csv"])
        .current_dir(dir.path(""))
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let mut log = child.stdin.take().unwrap();
    log.write_all(b"count\n0\n1\n0\n").unwrap();
    // By name alone: the file that is made and removed before the work may be gone when it would be read.
    let is_beside = || {
        let mut entries = std::fs::read_dir(dir.path("")).unwrap();
        entries.any(|entry| {
            entry
                .unwrap()
                .file_name()
                .to_string_lossy()
                .starts_with(".passivity-")
        })
    };
    let begin = Instant::now();
    let mut seen = false;
    while !seen && begin.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(1));
        seen = is_beside();
    }
    assert!(seen);
    child.kill().unwrap();
    child.wait().unwrap();
    let rows = std::fs::read_to_string(dir.path("rows.csv")).unwrap();
    assert_eq!(rows, "earlier rows\n");
}

#[test]
fn two_results_have_two_files() {
    let dir = folder();
    dir.write("there.svg", "<svg/>");
    let audit = "audit log.csv --scene scene.toml";
    for (command, options) in [
        (audit, ["--out", "--certificate"]),
        (audit, ["--out", "--plot"]),
        (audit, ["--plot", "--certificate"]),
        ("simulate scene.toml --speed 1", ["--out", "--plot"]),
        (
            "sweep scene.toml --beta 1 --sigma 1 --speed 1",
            ["--out", "--plot"],
        ),
        (
            "plane device.toml --axes stiffness,damping",
            ["--plot", "--out"],
        ),
        ("identify log.csv --scene device.toml", ["--out", "--plot"]),
    ] {
        let [first, second] = options;
        let says = format!("is the file of {first} and of {second}");
        for file in ["new.svg", "there.svg"] {
            let command = format!("{command} {first} {file} {second} ./{file}");
            refused(&dir, &command, &says);
        }
    }
}

#[test]
fn csv_is_written_under_no_name_of_another_format() {
    let dir = folder();
    for (command, ends) in [
        (
            "audit log.csv --scene scene.toml",
            "parquet json csv.gz zst MCAP",
        ),
        ("simulate scene.toml --speed 1", "parquet json csv.zst"),
        (
            "plane device.toml --axes stiffness,damping",
            "parquet json csv.gz",
        ),
        (
            "sweep scene.toml --beta 1 --sigma 1 --speed 1",
            "json csv.gz mcap",
        ),
        (
            "sweep scene.toml --beta 1,2 --sigma 1 --speed 1 --shard 1/2",
            "json",
        ),
    ] {
        for end in ends.split(' ') {
            let says =
                format!("`new.{end}`: these rows are CSV: expected a name that ends in .csv");
            refused(&dir, &format!("{command} --out new.{end}"), &says);
        }
        // A sweep takes the place of no other rows.
        let _ = std::fs::remove_file(dir.path("rows.txt"));
        let run = dir.run(
            &format!("{command} --out rows.txt")
                .split(' ')
                .collect::<Vec<_>>(),
        );
        assert!(
            run.code < 2 && dir.path("rows.txt").exists(),
            "{}",
            run.stderr
        );
    }
}

#[test]
fn vectors_replace_none_but_vectors() {
    let dir = Dir::new();
    let args = ["vectors", "--group", "errata", "--out", "."];
    let run = |says: Option<&str>| {
        let run = dir.run(&args);
        assert_eq!(
            run.code,
            if says.is_some() { 2 } else { 0 },
            "{}",
            run.stderr
        );
        assert!(
            run.stderr.contains(says.unwrap_or_default()),
            "{}",
            run.stderr
        );
    };
    for foreign in ["{\"title\": \"my own\"}", "{}", "no JSON", ""] {
        for name in ["schema.json", "errata.json"] {
            dir.write(name, foreign);
            run(Some("is not overwritten"));
            assert_eq!(files(&dir), [(name.to_owned(), foreign.into())]);
            std::fs::remove_file(dir.path(name)).unwrap();
        }
    }
    run(None);
    let written = files(&dir);
    assert_eq!(written.len(), 2);
    // Those of another version are made anew.
    let path = dir.path("errata.json");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(
        &path,
        text.replace("\"header\": \"", "\"header\": \"Earlier. "),
    )
    .unwrap();
    assert_ne!(files(&dir), written);
    run(None);
    assert_eq!(files(&dir), written);
}

/// The exit code of a command whose standard output nobody reads.
fn code_unread(dir: &Dir, command: &str, stderr: impl Into<Stdio>) -> Option<i32> {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let status = Command::new(env!("CARGO_BIN_EXE_passivity"))
        .args(command.split_whitespace())
        .current_dir(dir.path(""))
        .stdout(writer)
        .stderr(stderr)
        .status();
    status.unwrap().code()
}

#[test]
fn the_exit_code_says_the_verdict_when_nobody_reads() {
    let dir = folder();
    dir.write("wild.csv", "count\n0\n9\n-9\n0\n");
    let wild = dir.run(&["audit", "wild.csv", "--scene", "free.toml"]);
    assert_eq!(wild.code, 1, "{}", wild.stdout);
    for (command, code) in [
        ("audit log.csv --scene scene.toml", 0),
        ("audit wild.csv --scene free.toml", 1),
        ("audit wild.csv --scene free.toml --format json", 1),
        ("audit torn.csv --scene scene.toml", 2),
        ("check scene.toml", 0),
        ("check free.toml", 1),
        ("check free.toml scene.toml --format json", 1),
        ("check --watch scene.toml", 0),
    ] {
        let found = code_unread(&dir, command, Stdio::null());
        assert_eq!(found, Some(code), "{command}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_error_is_no_panic() {
    let dir = folder();
    dir.write("bad.toml", "[device]\n");
    for (command, code) in [
        ("audit missing.csv --scene scene.toml", 2),
        ("check bad.toml", 2),
        ("explain bad.toml", 2),
        ("chek", 2),
        ("export stiff.toml --for c", 1),
        ("check --watch scene.toml bad.toml", 2),
    ] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full");
        let found = code_unread(&dir, command, full.unwrap());
        assert_eq!(found, Some(code), "{command}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_takes_no_verdict_away_and_names_the_file() {
    let dir = folder();
    dir.write("long.csv", format!("count\n{}", "0\n1\n".repeat(20_000)));
    dir.write("wild.csv", "count\n0\n9\n-9\n0\n");
    dir.write("rows.csv", "earlier rows\n");
    // Files of as many blocks of 512 bytes, as on a disk that is full then: in the midst of the rows, and at their end.
    for (blocks, command, file) in [
        (
            200,
            "long.csv --scene scene.toml --out rows.csv",
            "rows.csv",
        ),
        (0, "log.csv --scene scene.toml --out rows.csv", "rows.csv"),
        (0, "log.csv --scene scene.toml --plot rows.svg", "rows.svg"),
        (
            0,
            "wild.csv --scene free.toml --certificate rows.json",
            "rows.json",
        ),
    ] {
        let before = files(&dir);
        let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" audit {command}");
        let run = Command::new("sh")
            .args(["-c", &script, env!("CARGO_BIN_EXE_passivity")])
            .current_dir(dir.path(""))
            .output()
            .unwrap();
        let [out, err] = [run.stdout, run.stderr].map(|text| String::from_utf8(text).unwrap());
        assert_eq!(run.status.code(), Some(2), "{command}: {err}");
        assert!(
            err.contains(file) && err.contains("File too large"),
            "{command}: {err}"
        );
        assert!(
            !err.contains(".csv: row") && out.contains("intervals  "),
            "{command}: {out}"
        );
        assert!(files(&dir) == before, "{command}: the files are others");
    }
}

#[test]
fn a_picture_has_something_to_draw() {
    let dir = folder();
    let simulate = "simulate scene.toml --speed 1 --intervals 37 --plot motion.svg";
    for (options, says) in [
        ("--plot-from 1000", "--plot-from 1000"),
        ("--plot-from 37", "37 intervals"),
        ("--plot-from 10 --plot-until 5", "--plot-until 5"),
        ("--plot-from 10 --plot-until 10", "--plot-until 10"),
        ("--plot-until 0", "--plot-until 0"),
    ] {
        refused(&dir, &format!("{simulate} {options}"), says);
    }
    // Where the device comes to rest before; the rows are right, and stay.
    let args = "simulate scene.toml --speed 1 --plot-from 49999 --plot motion.svg --out rows.csv";
    let run = dir.run(&args.split_whitespace().collect::<Vec<_>>());
    assert_eq!(run.code, 2, "{}", run.stdout);
    assert!(run.stderr.contains("nothing to draw"), "{}", run.stderr);
    assert!(dir.path("rows.csv").exists() && !dir.path("motion.svg").exists());
}

#[test]
fn an_axis_is_no_longer_than_numbers_tell_apart() {
    let dir = folder();
    dir.write(
        "far.csv",
        "stiffness [N m/rad],rate [Hz],stable\n1e308,1000,stable\n",
    );
    for (more, says) in [
        ("--x 0:1e400", "--x `0:1e400`: expected TO up to 1.8e308"),
        ("--x 1e-200:1e200", "say less of it with --x FROM:TO"),
        ("--measured far.csv", "say less of it with --x FROM:TO"),
    ] {
        let command = format!("plane device.toml --axes stiffness,rate --plot far.svg {more}");
        refused(&dir, &command, says);
    }
}
