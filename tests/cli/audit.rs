//! `passivity audit`: traces from the simulator, broken traces, and what is written.

use std::fs;
use std::path::Path;

use num_traits::Zero as _;
use passivity_core::BigRational;
use serde_json::Value;

use crate::harness::{Dir, Run, rational, words_off};

pub(crate) const PLAIN: &str = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n";

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
    let svg = fs::read_to_string(dir.path("energy.svg")).unwrap();
    // The commanded force does the work that the hand takes.
    assert!(svg.contains("passivity observer −Σ f·Δx"));
    assert!(svg.contains("time from the start (sampling periods)"));
    assert!(svg.contains(">trace.csv in scene<"), "{svg}");
    // What ends at an error says so.
    dir.write("trace.csv", "count\n0\n1\n3\nnan\n2\n");
    let run = dir.run(&[
        "audit",
        "trace.csv",
        "--scene",
        "scene.toml",
        "--plot",
        "cut.svg",
    ]);
    assert_eq!(run.code, 2);
    let svg = fs::read_to_string(dir.path("cut.svg")).unwrap();
    assert!(
        svg.contains(">trace.csv in scene, up to the error in row 4<"),
        "{svg}"
    );
}

/// With a latency the force that acted is not the wall's law at the positions of a log: nothing is said of it.
#[test]
fn a_log_that_is_not_accounted_for_has_no_figures_of_a_force() {
    let dir = Dir::new();
    let scene = dir.write(
        "late.toml",
        format!("{PLAIN}[sampling]\nlatency = \"9/10\"\n"),
    );
    let log = dir.write("log.csv", "xi\n0\n26\n51\n40\n13\n");
    let audit = ["audit", &log, "--scene", &scene];
    let files = [
        "--plot",
        "a.svg",
        "--out",
        "rows.csv",
        "--certificate",
        "c.json",
    ];
    let run = dir.run(&[&audit[..], &files].concat());
    assert_eq!(run.code, 3, "{}", run.stderr);
    assert!(run.stderr.contains("no picture is drawn"), "{}", run.stderr);
    assert!(
        run.stderr.contains("no certificate is written"),
        "{}",
        run.stderr
    );
    assert!(!dir.path("a.svg").exists() && !dir.path("c.json").exists());
    assert!(!run.stdout.contains("deficit"), "{}", run.stdout);
    let rows = fs::read_to_string(dir.path("rows.csv")).expect("rows");
    let row = rows.lines().nth(1).expect("a row");
    assert!(row.starts_with("0,0,26,1,,,"), "{row}");
    // What is written is a trace of the same positions, and says how long intervals are.
    let again = dir.run(&["audit", "rows.csv", "--scene", &scene]);
    assert_eq!(again.code, 3);
    assert!(again.stdout.starts_with(&run.stdout), "{}", again.stdout);
    let said = dir
        .run(&[&audit[..], &["--format", "json"]].concat())
        .json();
    assert_eq!(said["totals"]["violates_linear"], Value::Null);
}

/// That an account ends at an error is what its picture must not lose.
#[test]
fn the_title_of_a_picture_with_long_names_says_where_the_error_is() {
    let dir = Dir::new();
    let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n";
    let scene = dir.write(&format!("{}.toml", "s".repeat(90)), scene);
    let trace = dir.write(&format!("{}.csv", "t".repeat(90)), "xi\n1\n2\nthree\n");
    let run = dir.run(&["audit", &trace, "--scene", &scene, "--plot", "energy.svg"]);
    assert_eq!(run.code, 2, "{}", run.stderr);
    let svg = fs::read_to_string(dir.path("energy.svg")).expect("a picture");
    assert!(
        svg.contains(">ttt") && svg.contains("sss, up to the error in row 3<"),
        "{svg}"
    );
    assert_eq!(words_off(&svg), [""; 0]);
}
