//! `passivity audit`: traces from the simulator, broken traces, and what is written.

use std::fs;
use std::path::Path;

use num_traits::Zero as _;
use passivity_core::BigRational;
use serde_json::Value;

use crate::harness::{Dir, Run, rational};

const PLAIN: &str = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n";

/// Simulates a scene, audits its trace, and gives both reports.
fn simulated(dir: &Dir, scene: &str, method: &str) -> (Value, Value, Run) {
    dir.write("scene.toml", scene);
    let args = [
        "simulate",
        "scene.toml",
        "--method",
        method,
        "--out",
        "trace.csv",
    ];
    let simulation = dir.run(&[&args[..], &["--format", "json"]].concat()).json();
    let audit = dir.run(&[
        "audit",
        "trace.csv",
        "--scene",
        "scene.toml",
        "--format",
        "json",
    ]);
    (simulation, audit.json(), audit)
}

/// The middle of a total, and half its width.
fn near(total: &Value) -> (f64, f64) {
    match total {
        Value::String(_) => (passivity_scene::number::nearest_f64(&rational(total)), 0.0),
        range => {
            let ends = ["lo", "hi"]
                .map(|end| passivity_scene::number::nearest_f64(&rational(&range[end])));
            (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]))
        }
    }
}

#[test]
fn simulated_traces_hold_where_the_criterion_does_and_give_the_simulators_totals() {
    let start = "[start]\nvelocity = \"10\"\nposition = \"-1/3\"\n[run]\nintervals = 3000\n";
    let loops = [
        "beta = \"3/5\"\nsigma = \"3/5\"\n",
        "beta = \"1/2\"\nsigma = \"1/2\"\n",
        "beta = \"7/4\"\nsigma = \"3\"\n[sampling]\ndelay = 1\n",
        "beta = \"1\"\nsigma = \"1\"\n[wall]\nunilateral = true\nforce_step = \"1/2\"\n",
        "beta = \"2\"\nsigma = \"2\"\n[wall]\ndamping = \"1/4\"\n",
        "beta = \"1\"\nsigma = \"2/3\"\n[wall]\nmax_force = \"7/2\"\n",
    ];
    for text in loops {
        let dir = Dir::new();
        let scene = format!("[dimensionless]\nmu = \"50\"\n{text}{start}");
        let (simulation, audit, run) = simulated(&dir, &scene, "closed-form");
        assert_eq!(run.code, 0, "{text}{}", run.stdout);
        assert_eq!(audit["verdict"], "holds", "{text}");
        let totals = &audit["totals"];
        assert_eq!(totals["violates_linear"], 0, "{text}");
        assert_eq!(totals["criterion_fails"], 0, "{text}");
        assert_eq!(totals["intervals"], simulation["intervals"], "{text}");
        for figure in ["generated_linear", "generated_quantized"] {
            let (ours, room) = near(&totals[figure]);
            let theirs = simulation["totals"][figure].as_f64().unwrap();
            // Positions of some hundred ticks are doubles, off by 2⁻⁴⁶; a row's energy changes by
            // as much times its force and its step, below 2⁷ each; there are 3000 rows < 2¹².
            // The simulator's own sums are rounded less than that.
            assert!(
                (ours - theirs).abs() <= room + (2.0_f64).powi(7 + 12 - 46),
                "{text}{figure}: {ours} and {theirs}"
            );
        }
        let (least, _) = near(&totals["dissipated_lower"]);
        let dissipated = simulation["totals"]["dissipated"].as_f64().unwrap();
        assert!(
            least <= dissipated + 1e-7,
            "{text}: {least} of {dissipated}"
        );
    }
}

#[test]
fn exact_simulations_give_exactly_the_same_ledger() {
    let dir = Dir::new();
    // Without viscous friction the motion is rational. v_c = (σ − ½)/½ = 11.
    let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"0\"\nsigma = \"6\"\n[start]\nvelocity = \"5\"\nposition = \"-1/3\"\n[run]\nintervals = 40\n";
    let (_, audit, run) = simulated(&dir, scene, "exact");
    assert_eq!(run.code, 0, "{}", run.stdout);
    let text = fs::read_to_string(dir.path("trace.csv")).unwrap();
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().unwrap();
    let rows = audit["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 40);
    let mut sums = vec![BigRational::zero(); 2];
    for (row, line) in rows.iter().zip(lines) {
        for (name, field) in names.iter().zip(&line) {
            if let Some(Value::String(found)) = row.get(name) {
                assert_eq!(found, field, "{name} of row {}", row["h"]);
            }
        }
        for (sum, name) in sums
            .iter_mut()
            .zip(["generated_linear", "generated_quantized"])
        {
            let at = names.iter().position(|n| *n == name).unwrap();
            *sum += rational(&Value::from(line[at]));
        }
    }
    assert_eq!(rational(&audit["totals"]["generated_linear"]), sums[0]);
    assert_eq!(rational(&audit["totals"]["generated_quantized"]), sums[1]);
}

#[test]
fn a_loop_that_feeds_its_limit_cycle_is_caught_in_the_act() {
    let dir = Dir::new();
    let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"1\"\nsigma = \"1/10\"\n[start]\nvelocity = \"2\"\n[run]\nintervals = 2000\n";
    let (_, audit, run) = simulated(&dir, scene, "closed-form");
    assert_eq!(run.code, 1);
    assert_eq!(audit["verdict"], "fails");
    let first = &audit["first_violation"];
    assert_eq!(first["row"].as_u64(), first["h"].as_u64().map(|h| h + 1));
    assert_eq!(first["ledger"]["violates_linear"], true);
    assert_eq!(first["h"], audit["totals"]["first_linear"]);
}

/// Audits and gives the run with the number of rows written.
fn audited(dir: &Dir, name: &str) -> (Run, Option<usize>) {
    let _ = fs::remove_file(dir.path("rows.csv"));
    let run = dir.run(&["audit", name, "--scene", "scene.toml", "--out", "rows.csv"]);
    let rows = fs::read_to_string(dir.path("rows.csv")).ok();
    (
        run,
        rows.and_then(|rows| rows.lines().count().checked_sub(1)),
    )
}

#[test]
fn broken_traces_get_one_message_with_the_row_and_keep_what_came_before() {
    let dir = Dir::new();
    dir.write("scene.toml", PLAIN);
    let nines = "9".repeat(10_000_000);
    let wide = "7".repeat(2000);
    for (text, says, rows) in [
        (
            "count\n0\n1\n2147483649\n5\n",
            "row 3, column `count`: the count jumps from 1 to 2147483649",
            Some(1),
        ),
        (
            &format!("count\n1\n2\n{nines}\n4\n"),
            "row 3: a line longer than",
            Some(1),
        ),
        (
            &format!("xi\n1\n2\n3\n0.{nines}"),
            "row 4: a line longer than",
            Some(2),
        ),
        (
            &format!("xi\n1\n2\n{wide}\n"),
            "row 3, column `xi`: `7777777777777777777777777777777777777777…`: a number of more than 4096 bits",
            Some(1),
        ),
        ("xi\n1\n2\nNaN\n4\n", "row 3, column `xi`: `NaN`", Some(1)),
        (
            "count\n1\n2\n3\n-inf\n",
            "row 4, column `count`: `-inf`",
            Some(2),
        ),
        (
            "xi\n1\n2\n1e999999999\n",
            "row 3, column `xi`: `1e999999999`: a decimal exponent",
            Some(1),
        ),
        (
            "xi,tau\n1,0\n2,1\n3",
            "row 3: expected 2 fields, found 1 (the last line has no line break",
            Some(1),
        ),
        (
            "xi,tau\r\n1,0\r\n2,1\r\n3,1\r\n",
            "row 3, column `tau`: expected a time after 1",
            Some(1),
        ),
        (
            "\u{feff}xi\r\n1\r\n\r\n2\r\n",
            "row 2: expected a row, found a blank line",
            Some(0),
        ),
        ("xi,xi\n1,2\n", "the column `xi` is given twice", None),
        ("xi,count\n1,2\n", "found `xi` and `count`", None),
        (
            "tau\n1\n",
            "expected a column `xi`, `x [unit]` or `count`, found `tau`",
            None,
        ),
        ("", "expected a header, found nothing", None),
    ] {
        let name = dir.write("trace.csv", text);
        let (run, written) = audited(&dir, &name);
        let shown = &text[..text.len().min(60)];
        assert_eq!(run.code, 2, "{shown:?}: {}", run.stdout);
        assert_eq!(run.stderr.lines().count(), 1, "{shown:?}: {}", run.stderr);
        assert!(
            run.stderr.starts_with("error: trace.csv: "),
            "{shown:?}: {}",
            run.stderr
        );
        assert!(run.stderr.contains(says), "{shown:?}: {}", run.stderr);
        // A header that cannot be read leaves nothing to write.
        assert_eq!(written.filter(|_| rows.is_some()), rows, "{shown:?}");
        if let Some(rows) = rows {
            let accounted = match rows {
                0 => "INVALID TRACE: there is no interval before the error",
                _ => "INVALID TRACE: the account covers the rows before the error",
            };
            assert!(run.stdout.contains(accounted), "{}", run.stdout);
        }
    }
}

#[test]
fn line_breaks_and_byte_order_marks_make_no_difference() {
    let dir = Dir::new();
    dir.write("scene.toml", PLAIN);
    let mut ledgers = Vec::new();
    for text in [
        "xi\n1\n1/2\n-3\n",
        "xi\r\n1\r\n1/2\r\n-3\r\n",
        "\u{feff}\"xi\"\r\n1\r\n0.5\r\n-3e0\r\n\r\n",
    ] {
        let name = dir.write("trace.csv", text);
        let (run, _) = audited(&dir, &name);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{text:?}");
        ledgers.push(fs::read(dir.path("rows.csv")).unwrap());
    }
    assert!(ledgers.iter().all(|ledger| *ledger == ledgers[0]));
}

#[cfg(unix)]
#[test]
fn a_pipe_is_a_trace() {
    let dir = Dir::new();
    dir.write("scene.toml", PLAIN);
    for trace in ["-", "/dev/stdin"] {
        let command = format!(
            "printf 'xi\\n1\\n1/2\\n' | '{}' audit {trace} --scene scene.toml",
            env!("CARGO_BIN_EXE_passivity")
        );
        let run = std::process::Command::new("sh")
            .args(["-c", &command])
            .current_dir(dir.path("."))
            .output()
            .expect("a shell");
        let text = String::from_utf8(run.stdout).unwrap();
        assert!(run.status.success(), "{trace}: {text}");
        assert!(
            text.contains("intervals                    1\n"),
            "{trace}: {text}"
        );
    }
}

#[test]
fn corrupt_parquet_gets_one_message_too() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/parquet/snappy");
    // The first byte of a fuzzing input is the scene.
    let whole = fs::read(corpus).unwrap()[1..].to_vec();
    let dir = Dir::new();
    dir.write("scene.toml", PLAIN);
    dir.write("trace", &whole);
    assert_eq!(audited(&dir, "trace").1, Some(6));
    let mut refused = 0;
    for at in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[at] ^= 0xff;
        dir.write("trace", &bytes);
        let (run, _) = audited(&dir, "trace");
        assert!(run.code <= 2, "byte {at}");
        assert!(run.stderr.lines().count() <= 1, "byte {at}: {}", run.stderr);
        assert_eq!(
            run.code == 2,
            run.stderr.starts_with("error: trace: "),
            "byte {at}: {}",
            run.stderr
        );
        refused += usize::from(run.code == 2);
    }
    assert!(refused > whole.len() / 4, "{refused} of {}", whole.len());
    for end in [4, 5, whole.len() / 2, whole.len() - 1] {
        dir.write("trace", &whole[..end]);
        let (run, _) = audited(&dir, "trace");
        assert_eq!(
            (run.code, run.stderr.lines().count()),
            (2, 1),
            "{end} bytes"
        );
    }
}

#[test]
fn nothing_that_is_read_is_written_over() {
    let dir = Dir::new();
    dir.write("scene.toml", PLAIN);
    dir.write("trace.csv", "xi\n1\n1/2\n");
    for (option, file) in [
        ("--out", "trace.csv"),
        ("--out", "./scene.toml"),
        ("--plot", "trace.csv"),
        ("--certificate", "scene.toml"),
    ] {
        let run = dir.run(&["audit", "trace.csv", "--scene", "scene.toml", option, file]);
        assert_eq!(run.code, 2, "{}", run.stdout);
        assert!(
            run.stderr.contains("is read by this audit"),
            "{}",
            run.stderr
        );
    }
    assert_eq!(
        fs::read_to_string(dir.path("trace.csv")).unwrap(),
        "xi\n1\n1/2\n"
    );
    assert_eq!(fs::read_to_string(dir.path("scene.toml")).unwrap(), PLAIN);
}

#[test]
fn the_course_of_energy_is_drawn() {
    let dir = Dir::new();
    dir.write("scene.toml", PLAIN);
    dir.write("trace.csv", "count\n0\n1\n3\n2\n0\n-2\n");
    for (file, start) in [("energy.svg", &b"<svg"[..]), ("energy.png", b"\x89PNG")] {
        let run = dir.run(&[
            "audit",
            "trace.csv",
            "--scene",
            "scene.toml",
            "--plot",
            file,
        ]);
        assert!(run.code <= 1, "{}", run.stderr);
        assert!(
            fs::read(dir.path(file)).unwrap().starts_with(start),
            "{file}"
        );
    }
}

/// Audits a trace of a scene, with a certificate of the first violation, written as `format`.
fn certified(dir: &Dir, scene: &str, trace: &str, format: &str) -> Run {
    dir.write("scene.toml", scene);
    dir.write("trace.csv", trace);
    let audit = ["audit", "trace.csv", "--scene", "scene.toml"];
    let how = ["--certificate", "certificate.json", "--format", format];
    dir.run(&[audit, how].concat())
}

#[test]
fn the_second_implementation_confirms_violations_and_refuses_changed_figures() {
    let weak = "[dimensionless]\nbeta = \"1/10\"\nsigma = \"1/10\"\n";
    let tolerant = "[dimensionless]\nbeta = \"1/10 ± 1/20\"\nsigma = \"1/10 ± 50 %\"\n";
    let late = format!("{weak}[sampling]\ndelay = 1\n[wall]\ndamping = \"1/4\"\n");
    let bent = format!("{weak}[wall]\nunilateral = true\nmax_force = \"7/2\"\n");
    let stepped = format!("{weak}[wall]\nforce_step = \"1/3\"\n");
    let forced = "f,count\n0,0\n-1,0\n9,1\n9,4\n0,9\n";
    for (scene, trace) in [
        (weak, "xi\n0\n1/3\n5/2\n-1\n"),
        (weak, "count\n0\n0\n3\n7\n9\n"),
        (weak, "tau,count\n0,0\n1,1\n5/2,9\n"),
        (weak, forced),
        (weak, "f,xi\n0,0\n1,1\n4,2\n0,9/2\n"),
        (tolerant, "xi\n0\n1/3\n5/2\n-1\n"),
        (tolerant, "count\n0\n0\n3\n12\n"),
        (&late, "xi\n0\n1/3\n5/2\n17/3\n11/2\n-2\n-13\n"),
        (&late, "count\n0\n0\n20\n10\n-10\n-40\n"),
        (&late, forced),
        (&bent, "xi\n-1\n3/2\n3\n5/2\n-1\n"),
        (&bent, forced),
        (&stepped, "count\n0\n0\n4\n9\n"),
    ] {
        let dir = Dir::new();
        let run = certified(&dir, scene, trace, "json");
        let row = &run.json()["first_violation"]["row"];
        assert!(row.is_u64(), "{scene}{trace}: no row is violated");
        let found = dir.check_certificate("certificate.json");
        assert_eq!(found.code, 0, "{scene}{trace}{}", found.stderr);
        let says = format!("The violation is real: the net energy of row {row} is ");
        assert!(found.stdout.starts_with(&says), "{}", found.stdout);
        refuses_changes(&dir);
    }
}

/// Changes one number of the certificate after the other, figures and inputs.
fn refuses_changes(dir: &Dir) {
    let text = fs::read_to_string(dir.path("certificate.json")).unwrap();
    let whole: Value = serde_json::from_str(&text).unwrap();
    let mut places: Vec<String> = Vec::new();
    for (name, figure) in whole["figures"].as_object().unwrap() {
        match figure.is_string() {
            true => places.push(format!("/figures/{name}")),
            false => places.extend(["lo", "hi"].map(|end| format!("/figures/{name}/{end}"))),
        }
    }
    assert!(places.len() >= 3, "{text}");
    places.push("/log/dtau".to_owned());
    for place in places {
        let mut changed = whole.clone();
        let number = changed.pointer_mut(&place).unwrap();
        let one = BigRational::from_integer(1.into());
        let thousandth = BigRational::new(1.into(), 1000.into());
        let sign = if place.ends_with("/lo") { -one } else { one };
        *number = Value::from((rational(number) + sign * thousandth).to_string());
        dir.write("changed.json", changed.to_string());
        let found = dir.check_certificate("changed.json");
        assert_eq!((found.code, found.stdout.as_str()), (1, ""), "{place}");
        let figure = match place.strip_prefix("/figures/") {
            Some(figure) => figure.split('/').next().unwrap(),
            None => "dissipated_lower",
        };
        let says = format!("refused: {figure} is ");
        assert!(found.stderr.starts_with(&says), "{place}: {}", found.stderr);
    }
}

#[test]
fn without_a_violation_there_is_no_certificate() {
    let dir = Dir::new();
    let uncovered = "[amplifier]\ntime_constant = \"1/2\"\n";
    for (scene, trace, says) in [
        (
            PLAIN.to_owned(),
            "xi\n1\n1/2\n",
            "no interval surely generated more",
        ),
        (
            PLAIN.to_owned(),
            "count\n",
            "no interval surely generated more",
        ),
        (
            "[dimensionless]\nbeta = \"0\"\nsigma = \"0\"\n".to_owned() + uncovered,
            "xi\n0\n3\n",
            "the scene has an effect that the account of a log leaves out",
        ),
    ] {
        let run = certified(&dir, &scene, trace, "text");
        assert!(
            run.stderr.contains("no certificate is written: "),
            "{}",
            run.stderr
        );
        assert!(run.stderr.contains(says), "{}", run.stderr);
        assert!(!dir.path("certificate.json").exists());
    }
}

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
    let run = dir.run(&["audit", &log, "--scene", &scene, "--partial", &log]);
    assert!(
        run.code == 2 && run.stderr.contains("is read by this audit"),
        "{}",
        run.stderr
    );
}

/// Runs a job of an array as Slurm would.
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
    for id in 1..=3 {
        task(&dir, "audit.sbatch", id, 3, &["log.csv", &scene, "parts"]);
        let mut args = vec![scene.as_str(), "grid"];
        args.extend(grid);
        task(&dir, "sweep.sbatch", id, 3, &args);
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
