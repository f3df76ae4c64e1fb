//! `passivity sweep`.

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::harness::Dir;

fn scene(dir: &Dir, intervals: u32) -> String {
    let scene = format!(
        "[dimensionless]\nmu = \"50\"\nbeta = \"1\"\nsigma = \"1\"\n[run]\nintervals = {intervals}\n"
    );
    dir.write("scene.toml", scene)
}

/// The start of a sweep's arguments, with ranges.
fn args<'a>(scene: &'a str, beta: &'a str, sigma: &'a str) -> Vec<&'a str> {
    vec![
        "sweep", scene, "--beta", beta, "--sigma", sigma, "--speed", "1,2", "--format", "json",
    ]
}

#[test]
fn a_table_has_every_point_in_order() {
    let dir = Dir::new();
    let scene = scene(&dir, 2000);
    let mut all = args(&scene, "0:1:5", "0:1.5:4");
    all.extend(["--out", "grid.csv", "--plot", "grid.svg"]);
    let run = dir.run(&all);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let document = run.json();
    assert_eq!(
        (&document["points"], &document["simulated"]),
        (&40.into(), &40.into())
    );
    let table = std::fs::read_to_string(dir.path("grid.csv")).expect("a table");
    let mut lines = table.lines();
    assert_eq!(
        lines.next(),
        Some("beta,sigma,speed,paper,exact,at_interval,xi,velocity")
    );
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 40);
    assert_eq!(rows[1][..3], ["0.0", "0.0", "2.0"]);
    assert_eq!(rows[39][..3], ["1.0", "1.5", "2.0"]);
    assert_eq!(rows[39][4], "at_rest");
    let rest = rows.iter().filter(|row| row[4] == "at_rest").count();
    assert_eq!(document["exact"]["at_rest"], rest);
    let svg = std::fs::read_to_string(dir.path("grid.svg")).expect("a picture");
    for word in [
        "(a) growing",
        "(b) never at rest",
        ">1 tick/sample<",
        ">2 ticks/sample<",
        "stroke-dasharray",
    ] {
        assert!(svg.contains(word), "{word}");
    }
    // The same as Parquet; taken up once more there is nothing to do.
    let mut all = args(&scene, "0:1:5", "0:1.5:4");
    all.extend(["--out", "grid.parquet"]);
    assert_eq!(dir.run(&all).code, 0);
    let bytes = std::fs::read(dir.path("grid.parquet")).expect("a table");
    assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    all.push("--resume");
    let again = dir.run(&all).json();
    assert_eq!(again["simulated"], 0);
    assert_eq!(again["exact"], document["exact"]);
    assert_eq!(again["paper"], document["paper"]);
}

#[test]
fn a_killed_sweep_goes_on_where_it_was() {
    let dir = Dir::new();
    // Points that keep moving: half a second or more of work.
    let scene = scene(&dir, 5_000);
    for name in ["part.csv", "part.parquet"] {
        let mut all = args(&scene, "0.6:1:24", "0:0.4:24");
        all.extend(["--out", name]);
        let mut child = Command::new(env!("CARGO_BIN_EXE_passivity"))
            .args(&all)
            .current_dir(dir.path(""))
            .stdout(Stdio::null())
            .spawn()
            .expect("the command starts");
        let journal = if name.ends_with("csv") {
            name.to_owned()
        } else {
            format!("{name}.rows")
        };
        let lines = || {
            let text = std::fs::read_to_string(dir.path(&journal)).unwrap_or_default();
            text.matches('\n').count()
        };
        let begin = Instant::now();
        while lines() < 40 && begin.elapsed() < Duration::from_secs(60) {
            std::thread::sleep(Duration::from_millis(1));
        }
        child.kill().expect("killed");
        child.wait().expect("gone");
        let kept = lines() - 1;
        assert!((30..2 * 24 * 24).contains(&kept), "{kept} rows");
        all.push("--resume");
        let run = dir.run(&all);
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert_eq!(
            run.json()["simulated"],
            2 * 24 * 24 - kept,
            "none redone, none lost"
        );
        assert!(!dir.path(&format!("{name}.run")).exists());
    }
    let mut all = args(&scene, "0.6:1:24", "0:0.4:24");
    all.extend(["--out", "whole.csv"]);
    assert_eq!(dir.run(&all).code, 0);
    let read = |name| std::fs::read_to_string(dir.path(name)).expect("a table");
    assert_eq!(read("part.csv"), read("whole.csv"));
}

#[test]
fn what_cannot_be_taken_up_or_written_is_said() {
    let dir = Dir::new();
    let scene = scene(&dir, 50);
    let mut all = args(&scene, "0:1:3", "0:1:3");
    all.extend(["--out", "grid.csv", "--resume"]);
    for (text, expected) in [
        (&b"not a table\n1,2\n"[..], "line 1: expected the header"),
        (
            b"beta,sigma,speed,paper,exact,at_interval,xi,velocity\n0.0,\xff\xfe\n",
            "line 2: expected a row of a sweep",
        ),
    ] {
        dir.write("grid.csv", text);
        let run = dir.run(&all);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains(expected), "{}", run.stderr);
        assert_eq!(std::fs::read(dir.path("grid.csv")).expect("the file"), text);
    }
    for (args, expected) in [
        (args(&scene, "1:0", "1"), "--beta: range `1:0`"),
        (
            args(&scene, "1", "nan"),
            "--sigma: range `nan`: `nan` is not a number",
        ),
        (args(&scene, "-1", "1"), "β = -1"),
        (
            args(&scene, "1,1e400", "1"),
            "error: β = 1e400: viscous friction cannot be simulated: expected a magnitude up to 1e120",
        ),
    ] {
        let run = dir.run(&args);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains(expected), "{}", run.stderr);
    }
    #[cfg(target_os = "linux")]
    {
        // No more than 512 or 1024 bytes fit into a file, by shell.
        let args = self::args(&scene, "0:1:3", "0:1:3").join(" ");
        let binary = env!("CARGO_BIN_EXE_passivity");
        let script = format!("trap '' XFSZ; ulimit -f 1; exec '{binary}' {args} --out full.csv");
        let output = Command::new("sh")
            .args(["-c", &script])
            .current_dir(dir.path(""))
            .output()
            .expect("a shell");
        let run = crate::harness::Run::from(output);
        assert_eq!(run.code, 2);
        assert!(
            run.stderr
                .contains(" of 18 points are kept: go on with --resume"),
            "{}",
            run.stderr
        );
        assert!(
            run.stderr.starts_with("error: `full.csv`"),
            "{}",
            run.stderr
        );
    }
}

#[test]
fn dots_stand_at_their_points() {
    let dir = Dir::new();
    let scene = scene(&dir, 2000);
    let (beta, sigma) = ("0,0.1,0.9,0.2,1000", "0,1e-9,0.4,2");
    let all = [
        "sweep", &scene, "--beta", beta, "--sigma", sigma, "--speed", "1", "--plot", "grid.svg",
    ];
    let run = dir.run(&all);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("grid.svg")).expect("a picture");
    // The right half is (b), 500 wide from 700: all of β but 1000 is in its first pixel.
    let places = svg.split("<circle cx=\"").skip(1);
    let places: Vec<f64> = places
        .filter_map(|rest| rest.split('"').next()?.parse().ok())
        .collect();
    assert!(!places.is_empty(), "{svg}");
    let is_at_a_value = |x: &f64| (700.0..701.5).contains(x) || (1030.0..1040.0).contains(x);
    assert!(places.iter().all(is_at_a_value), "{places:?}");
    // One point is one.
    let run = dir.run(&[
        "sweep", &scene, "--beta", "1", "--sigma", "1", "--speed", "1",
    ]);
    assert!(
        run.stdout
            .contains(": 1 point, of which 1 was simulated now"),
        "{}",
        run.stdout
    );
}

#[test]
fn the_critical_lines_are_those_of_the_scene_with_its_effects() {
    let dir = Dir::new();
    let write = |name: &str, more: &str| {
        let scene = format!("[dimensionless]\nmu = \"50\"\nbeta = \"1\"\nsigma = \"1\"\n{more}");
        dir.write(name, scene)
    };
    let drawn = |scene: &str, intervals: &str| {
        let mut all = args(scene, "0:4:5", "0:2:5");
        all.extend(["--plot", "grid.svg", "--intervals", intervals]);
        let run = dir.run(&all);
        assert_eq!(run.code, 0, "{}", run.stderr);
        std::fs::read_to_string(dir.path("grid.svg")).expect("a picture")
    };
    let plain = drawn(&write("plain.toml", ""), "100");
    let late = drawn(&write("late.toml", "[sampling]\ndelay = 1\n"), "100");
    assert!(plain.contains("critical lines") && late.contains("critical lines"));
    let lag = write("lag.toml", "[amplifier]\ntime_constant = \"1/5\"\n");
    assert!(drawn(&lag, "100").contains("critical lines"));
    // Too short a run to be sure of anything.
    assert!(drawn(&write("short.toml", ""), "1").contains("crosses: undecided"));
}

pub(crate) const ARM: &str = "[device]\nmass = \"75 g\"\nviscous = \"0.5 N s/m\"\ncoulomb = \"0.04 N\"\n[sampling]\n\
                   rate = \"1 kHz\"\n[encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"1 N/mm\"\n\
                   [operator]\nmax_speed = \"40 mm/s\"\n[start]\nvelocity = \"300 mm/s\"\n[run]\nintervals = 400\n";

#[test]
fn any_parameters_of_the_scene_can_be_varied() {
    let dir = Dir::new();
    let arm = dir.write("arm.toml", ARM);
    let mut args = vec![
        "sweep",
        &arm,
        "--vary",
        "stiffness=500:3500:4 N/m",
        "--vary",
        "wall.damping=0,0.2 N s/m",
        "--vary",
        "rate = 1/2,1 kHz",
        "--format",
        "json",
        "--out",
        "grid.csv",
        "--plot",
        "grid.svg",
    ];
    let run = dir.run(&args);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(run.json()["points"], 16);
    let table = std::fs::read_to_string(dir.path("grid.csv")).expect("a table");
    let mut lines = table.lines();
    assert_eq!(
        lines.next(),
        Some("stiffness [N/m],damping [N s/m],rate [kHz],paper,exact,at_interval,xi,velocity")
    );
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 16);
    // Each point is the scene with the numbers typed in.
    for row in &rows {
        let [stiffness, damping, rate] = [row[0], row[1], row[2]];
        let damped = format!("\"{stiffness} N/m\"\ndamping = \"{damping} N s/m\"");
        let typed = ARM
            .replace("\"1 N/mm\"", &damped)
            .replace("\"1 kHz\"", &format!("\"{rate} kHz\""));
        let typed = dir.write("typed.toml", typed);
        let document = dir.run(&["simulate", &typed, "--format", "json"]).json();
        assert_eq!(document["outcome"]["exact"], row[4], "{row:?}");
        let near = |name: &str, cell: &str| {
            let (a, b) = (document["final"][name].as_f64(), cell.parse::<f64>().ok());
            let (a, b) = (a.expect("a number"), b.expect("a number"));
            // The same loop over the same numbers gives the same bits.
            a == b
        };
        assert!(near("xi", row[6]) && near("velocity", row[7]), "{row:?}");
    }
    let svg = std::fs::read_to_string(dir.path("grid.svg")).expect("a picture");
    for word in [
        "stiffness K (N/m)",
        "virtual damping B (N s/m)",
        "rate = 0.5 kHz",
        "comes to rest",
        "border: passive at every speed",
        "border: passive up to operator.max_speed",
        "a cell stands for one point of the grid",
    ] {
        assert!(svg.contains(word), "{word}");
    }
    // Taken up again there is nothing to do, and a Parquet file has the same columns.
    args.push("--resume");
    assert_eq!(dir.run(&args).json()["simulated"], 0);
    let args: Vec<&str> = args
        .iter()
        .map(|arg| {
            if *arg == "grid.csv" {
                "grid.parquet"
            } else {
                *arg
            }
        })
        .collect();
    assert_eq!(dir.run(&args).json()["simulated"], 16);
    assert_eq!(dir.run(&args).json()["simulated"], 0);
}

#[test]
fn mistakes_in_what_is_varied_are_said() {
    let dir = Dir::new();
    let arm = dir.write("arm.toml", ARM);
    for (vary, expected) in [
        (
            &["stiffness"][..],
            "--vary `stiffness`: expected a key, a range and a unit, as in stiffness=0.1:2:41 N m/rad",
        ),
        (
            &["stiffness=1:2:3"],
            "expected a unit after the range, as in 1:2:3 N/mm",
        ),
        (&["stiffness=1:2:3 N"], "the unit is that of a force"),
        (
            &["stifness=1:2:3 N/m"],
            "expected a parameter: one of stiffness",
        ),
        (
            &["stiffness=1:2 N/m"],
            "range `1:2`: expected start:stop:count",
        ),
        (
            &["stiffness=1:2:3 N/m"],
            "1 parameter to vary: expected two or three",
        ),
        (
            &["stiffness=0:2:3 N/m", "rate=1 kHz"],
            "`stiffness` = 0: expected a value above zero",
        ),
        (
            &["stiffness=1 N/m", "max_speed=1 mm/s"],
            "`max_speed` has no part in the motion: expected one of stiffness, ",
        ),
        // As where they are typed in.
        (
            &["damping_cutoff=10:100:3 Hz", "rate=1,2 kHz"],
            "`damping_cutoff`: the filter on the virtual damping has no damping to filter in `arm`",
        ),
        (
            &["counts_per_revolution=100,200", "rate=1,2 kHz"],
            "`counts_per_revolution`: `arm` is linear: expected `resolution`",
        ),
    ] {
        let mut args = vec!["sweep", &arm];
        args.extend(vary.iter().flat_map(|text| ["--vary", text]));
        let run = dir.run(&args);
        assert_eq!(run.code, 2, "{vary:?}");
        assert!(run.stderr.contains(expected), "{vary:?}: {}", run.stderr);
    }
    let controlled = format!("{ARM}[controller]\nnumerator = [\"1.5\", \"-0.5\"]\n");
    let controlled = dir.write("controlled.toml", controlled);
    let damped = ["--vary", "damping=0,1 N s/m", "--vary", "rate=1,2 kHz"];
    let run = dir.run(&[&["sweep", &controlled][..], &damped].concat());
    assert_eq!(run.code, 2);
    let expected = "`damping`: [controller] and `wall.damping` cannot both be given";
    assert!(run.stderr.contains(expected), "{}", run.stderr);
    // A filter on damping that is varied itself has something to filter.
    let filtered = ["--vary", "damping_cutoff=10,20 Hz"];
    let run = dir.run(&[&["sweep", &arm][..], &damped, &filtered].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    // Without an encoder there is no tick to measure σ and the speed in.
    let smooth = ARM.replace("[encoder]\nresolution = \"0.03 mm\"\n", "");
    let smooth = dir.write("smooth.toml", smooth);
    let run = dir.run(&["sweep", &smooth, "--beta", "1", "--sigma", "1"]);
    assert_eq!(run.code, 2);
    assert!(
        run.stderr.contains("--sigma: `smooth` has no encoder"),
        "{}",
        run.stderr
    );
    assert!(run.stderr.contains("--vary 'coulomb=…'"), "{}", run.stderr);
    let run = dir.run(&[
        "sweep",
        &arm,
        "--vary",
        "stiffness=1 N/m",
        "--beta",
        "0:1:3",
    ]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot be used with"), "{}", run.stderr);
}

#[test]
fn shards_are_merged_into_the_file_of_one_run() {
    let dir = Dir::new();
    for verb in ["sweep", "audit"] {
        let help = dir.run(&[verb, "--help"]).stdout;
        assert!(help.contains("`3-5/8` the third to the fifth"), "{help}");
    }
    let scene = scene(&dir, 500);
    let sweep = |more: &[&str]| {
        let mut all = args(&scene, "0:1:5", "0:1.5:4");
        all.extend(more);
        dir.run(&all)
    };
    for end in ["csv", "parquet"] {
        let whole = format!("whole.{end}");
        let run = sweep(&["--out", &whole]).json();
        let parts: Vec<String> = (1..=3).map(|i| format!("part-{i}.{end}")).collect();
        for (i, part) in parts.iter().enumerate() {
            let run = sweep(&["--shard", &format!("{}/3", i + 1), "--out", part]);
            assert_eq!(run.code, 0, "{}", run.stderr);
            assert!((13..=14).contains(&run.json()["points"].as_u64().expect("a number")));
        }
        let merged = format!("merged.{end}");
        let mut more = vec!["--out", &merged, "--plot", "grid.svg", "--merge"];
        more.extend(parts.iter().map(String::as_str));
        let merge = sweep(&more);
        assert_eq!(merge.code, 0, "{}", merge.stderr);
        let merge = merge.json();
        for field in ["points", "exact", "paper", "intervals"] {
            assert_eq!(merge[field], run[field], "{field}");
        }
        assert_eq!(merge["simulated"], 0);
        let read = |name: &str| std::fs::read(dir.path(name)).expect("a table");
        assert!(read(&merged) == read(&whole));
        let run = sweep(&["--out", &merged, "--merge", &parts[0], &parts[2]]);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains("missing: 2"), "{}", run.stderr);
        // What is there is not lost for a merge that fails.
        assert!(read(&merged) == read(&whole));
    }
    for wrong in ["0/3", "4/3", "three"] {
        let run = sweep(&["--shard", wrong, "--out", "x.csv"]);
        assert_eq!(run.code, 2, "{wrong}");
    }
}
