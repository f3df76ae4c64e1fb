//! `passivity simulate`.

use serde_json::Value;

use crate::harness::{Dir, ratio, rational};

/// A scene that comes to rest, without viscous friction so that every method can do it.
pub(crate) fn gliding(dir: &Dir) -> String {
    let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"0\"\nsigma = \"3/5\"\n\
                 [start]\nvelocity = \"1/8\"\n[run]\nintervals = 200\n";
    dir.write("glide.toml", scene)
}

fn cycling(dir: &Dir) -> String {
    let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"2/5\"\n\
                 [start]\nvelocity = \"2\"\n[run]\nintervals = 300\n";
    dir.write("cycle.toml", scene)
}

#[test]
fn every_method_finds_the_same_rest() {
    let dir = Dir::new();
    let scene = gliding(&dir);
    let run = |method: &str| {
        let run = dir.run(&["simulate", &scene, "--method", method, "--format", "json"]);
        assert_eq!(run.code, 0, "{method}: {}", run.stderr);
        run.json()
    };
    let exact = run("exact");
    let state = &exact["final"]["exact"];
    assert_eq!(rational(&state["velocity"]), ratio(0, 1));
    let xi = exact["final"]["xi"].as_f64().expect("a number");
    assert_eq!(exact["totals"]["residual_max"].as_f64(), Some(0.0));
    for method in [
        "closed-form",
        "reference:30",
        "enclosure",
        "euler:1000",
        "rk4:1000",
        "adaptive:1e-10",
    ] {
        let document = run(method);
        assert_eq!(document["method_parameter"], method);
        let outcome = &document["outcome"];
        assert_eq!(outcome["exact"], "at_rest", "{method}");
        assert_eq!(outcome["paper"], "converged", "{method}");
        let name = document["method"].as_str().expect("a word");
        let off = (document["final"]["xi"].as_f64().expect("a number") - xi).abs();
        if ["closed-form", "reference", "enclosure"].contains(&name) {
            assert_eq!(outcome["at_interval"], exact["outcome"]["at_interval"]);
            // Fewer than 200 intervals, 30 roundings each, of numbers below a tick.
            assert!(off < 200.0 * 30.0 * f64::EPSILON, "{method}: {off:e}");
        } else {
            // Steps of 1/1000 miss the instant of rest by one: at most 1.1/50/1000 in velocity.
            assert!(off < 200.0 * 1.1 / 50.0 / 1000.0, "{method}: {off:e}");
        }
    }
    let range = &run("enclosure")["final"]["enclosure"]["xi"];
    let [lo, hi] = ["lo", "hi"].map(|end| range[end].as_f64().expect("a number"));
    assert!(lo <= xi && xi <= hi && hi - lo < 1e-10);
}

#[test]
fn the_document_has_the_fields_that_are_promised() {
    let dir = Dir::new();
    let run = dir.run(&["simulate", &cycling(&dir), "--format", "json"]);
    assert_eq!(run.code, 1, "a motion that does not rest");
    let document = run.json();
    assert_eq!(document["scene"], "cycle");
    assert_eq!(document["intervals"], 300);
    assert_eq!(document["outcome"]["exact"], "never_at_rest");
    assert_eq!(document["outcome"]["at_interval"], Value::Null);
    let effects: Vec<&str> = document["effects"]
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(Value::as_str)
        .collect();
    assert_eq!(
        effects.len(),
        4,
        "hold, two frictions, encoder: {effects:?}"
    );
    for field in [
        "generated_linear",
        "generated_quantized",
        "dissipated",
        "residual_max",
    ] {
        assert!(document["totals"][field].is_number(), "{field}");
    }
    for field in ["xi", "velocity"] {
        assert!(document["final"][field].is_number(), "{field}");
    }
    assert!(
        document["outcome"]["because"]
            .as_str()
            .is_some_and(|s| s.contains("0.4"))
    );
    // The same input gives the same bytes; the clock is looked at on request.
    assert!(document["seconds"].is_null());
}

#[test]
fn a_trace_has_the_ledger_of_every_interval_and_can_be_audited() {
    let dir = Dir::new();
    let scene = cycling(&dir);
    let run = dir.run(&["simulate", &scene, "--out", "trace.csv"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let trace = std::fs::read_to_string(dir.path("trace.csv")).expect("a trace");
    let mut lines = trace.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    for column in [
        "h",
        "xi0",
        "xi1",
        "dtau",
        "generated_linear",
        "generated_quantized",
        "bound_22",
        "bound_quantized",
        "dissipated_lower",
        "net_linear",
        "net_quantized",
        "margin",
        "criterion_holds",
        "violates_linear",
        "violates_quantized",
        "v0",
        "v1",
        "dissipated",
    ] {
        assert!(header.contains(&column), "{column} in {header:?}");
    }
    let column = |name: &str| header.iter().position(|c| *c == name).expect("a column");
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 300);
    for (h, pair) in rows.windows(2).enumerate() {
        assert_eq!(pair[0][column("h")], h.to_string());
        assert_eq!(pair[0][column("xi1")], pair[1][column("xi0")]);
        let number = |name: &str| pair[0][column(name)].parse::<f64>().expect("a number");
        // (26); equal when the speed is constant, so up to a rounding of the sum.
        let rounding = 4.0 * f64::EPSILON * number("dissipated");
        assert!(
            number("dissipated_lower") <= number("dissipated") + rounding,
            "{pair:?}"
        );
    }
    let audit = dir.run(&["audit", "trace.csv", "--scene", &scene]);
    assert!(audit.code < 2, "{}", audit.stderr);

    let run = dir.run(&[
        "simulate",
        &gliding(&dir),
        "--method",
        "exact",
        "--out",
        "exact.csv",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let text = std::fs::read_to_string(dir.path("exact.csv")).expect("a trace");
    let first = text.lines().nth(1).expect("a row");
    assert!(
        first.contains('/') && !first.contains('.'),
        "rationals: {first}"
    );
    let run = dir.run(&[
        "simulate",
        &scene,
        "--method",
        "enclosure",
        "--out",
        "bounds.csv",
    ]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let text = std::fs::read_to_string(dir.path("bounds.csv")).expect("a trace");
    assert!(
        text.starts_with("h,xi0_lo,xi0_hi,xi1_lo,xi1_hi,dtau"),
        "{text}"
    );
}

#[test]
fn pictures_name_their_axes() {
    let dir = Dir::new();
    let run = dir.run(&["simulate", &cycling(&dir), "--plot", "motion.svg"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("motion.svg")).expect("a picture");
    for word in [
        "position (ticks)",
        "velocity (ticks/sample)",
        "held force (KΔ)",
        "energy (KΔ²)",
        "generated in each interval (linear spring)",
        "dissipated in each interval",
        "time (sampling periods)",
    ] {
        assert!(svg.contains(word), "{word}");
    }
    let run = dir.run(&["simulate", &cycling(&dir), "--plot", "motion.png"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let png = std::fs::read(dir.path("motion.png")).expect("a picture");
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n") && png.len() > 10_000);
}

#[test]
fn a_picture_is_in_the_units_of_the_scene_with_ticks_beside_them() {
    let dir = Dir::new();
    let arm = "[device]\nmass = \"75 g\"\ncoulomb = \"0.04 N\"\n[sampling]\nrate = \"1 kHz\"\n[encoder]\n\
               resolution = \"0.03 mm\"\n[wall]\nstiffness = \"1 N/mm\"\nunilateral = true\n[start]\n\
               velocity = \"40 mm/s\"\n[run]\nintervals = 40\n";
    let arm = dir.write("arm.toml", arm);
    let args = [
        "simulate",
        &arm,
        "--plot",
        "motion.svg",
        "--plot-from",
        "5",
        "--plot-until",
        "25",
    ];
    let run = dir.run(&args);
    assert!(run.code < 2, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("motion.svg")).expect("a picture");
    for word in [
        "position (mm)",
        "velocity (mm/s)",
        "held force (N)",
        "energy (µJ)",
        "time (ms)",
        ">ticks<",
        ">ticks/sample<",
        ">KΔ²<",
        "generated in each interval",
    ] {
        assert!(svg.contains(word), "{word}");
    }
}

#[test]
fn a_picture_that_cannot_be_written_is_refused_before_the_run() {
    let dir = Dir::new();
    let scene = cycling(&dir);
    for (name, expected) in [
        ("no/such/motion.svg", "no/such/motion.svg"),
        ("motion.bmp", "expected a name that ends in .svg or .png"),
    ] {
        // A run of this many intervals would take minutes.
        let run = dir.run(&[
            "simulate",
            &scene,
            "--intervals",
            "1000000000",
            "--plot",
            name,
        ]);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains(expected), "{}", run.stderr);
    }
    assert!(!dir.path("motion.bmp").exists());
}

#[test]
fn more_intervals_than_a_scene_may_have_are_refused() {
    let dir = Dir::new();
    let scene = cycling(&dir);
    for verb in [
        &["simulate"][..],
        &["accuracy"],
        &["sweep", "--beta", "1", "--sigma", "1"],
    ] {
        for count in ["0", "1000000001", "-1", "1.5", "many"] {
            let run = dir.run(&[verb, &[&scene, "--intervals", count]].concat());
            assert_eq!(run.code, 2, "{verb:?}");
            let expected = "expected a whole number from 1 to 1000000000";
            assert!(run.stderr.contains(expected), "{}", run.stderr);
        }
    }
}

#[test]
fn a_start_at_rest_says_so_and_another_speed_can_be_given() {
    let dir = Dir::new();
    let scene = dir.write(
        "still.toml",
        "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n",
    );
    let run = dir.run(&["simulate", &scene]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("--speed"), "{}", run.stdout);
    let run = dir.run(&["simulate", &scene, "--speed", "-5/2", "--format", "json"]);
    assert!(run.json()["intervals"].as_u64().is_some_and(|n| n > 10));
    let run = dir.run(&["simulate", &scene, "--speed", "fast"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("--speed `fast`"), "{}", run.stderr);
}

#[test]
fn what_cannot_be_done_is_said() {
    let dir = Dir::new();
    let scene = cycling(&dir);
    let lagging = dir.write(
        "lag.toml",
        "[dimensionless]\nmu = \"50\"\nsigma = \"2/5\"\n[sampling]\nperiod = \"1 ms\"\n\
         [amplifier]\ntime_constant = \"0.2 ms\"\n",
    );
    for (args, expected) in [
        (
            &["simulate", &scene, "--method", "exact"][..],
            "device.viscous",
        ),
        (
            &["simulate", &scene, "--method", "magic"],
            "one of closed-form",
        ),
        (&["simulate", &scene, "--method", "euler:0"], "1 to 1000000"),
        (&["simulate", &lagging, "--method", "enclosure"], "lag.toml"),
        (
            &["simulate", &scene, "--out", "no/such/folder.csv"],
            "no/such/folder.csv",
        ),
    ] {
        let run = dir.run(args);
        assert_eq!(run.code, 2, "{args:?}");
        assert!(run.stderr.contains(expected), "{args:?}: {}", run.stderr);
    }
    if cfg!(target_os = "linux") {
        let run = dir.run(&["simulate", &scene, "--out", "/dev/full"]);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains("/dev/full"), "{}", run.stderr);
    }
}

#[test]
fn the_plan_is_explained() {
    let dir = Dir::new();
    let run = dir.run(&["explain", &cycling(&dir)]);
    assert!(run.stdout.contains("loop `plain`"), "{}", run.stdout);
    assert!(!run.stdout.contains("actuator:"), "no saturation, no line");
}

#[test]
fn the_same_input_gives_the_same_bytes_unless_the_time_is_asked_for() {
    let dir = Dir::new();
    let scene = cycling(&dir);
    let once = dir.run(&["simulate", &scene, "--format", "json"]);
    let again = dir.run(&["simulate", &scene, "--format", "json"]);
    assert_eq!(once.stdout, again.stdout);
    let timed = dir.run(&["simulate", &scene, "--format", "json", "--timing"]);
    assert!(timed.json()["seconds"].is_number());
}

/// A slide with a resolution of 0.01 mm at 1 kHz: a tick per sample is 10 mm/s.
const SLIDE: &str = "[device]\nmass = \"0.5 kg\"\nviscous = \"1 N s/m\"\ncoulomb = \"0.01 N\"\n\
                     [sampling]\nrate = \"1 kHz\"\n[encoder]\nresolution = \"0.01 mm\"\n\
                     [wall]\nstiffness = \"1 N/mm\"\n[run]\nintervals = 200\n";

#[test]
fn a_speed_may_have_a_unit() {
    let dir = Dir::new();
    let scene = dir.write("slide.toml", SLIDE);
    let run = |speed: &str| dir.run(&["simulate", &scene, "--format", "json", "--speed", speed]);
    let by_unit = run("20 mm/s");
    assert_eq!(by_unit.stdout, run("2").stdout, "{}", by_unit.stderr);
    assert_eq!(by_unit.json()["totals"], run("1.2 m/min").json()["totals"]);
    let wrong = run("20 rad/s");
    assert_eq!(wrong.code, 2);
    assert!(
        wrong
            .stderr
            .contains("`20 rad/s` is of another motion than the scene"),
        "{}",
        wrong.stderr
    );
    assert_eq!(run("20 mm").code, 2);
}

#[test]
fn a_ledger_in_si_units_is_the_other_one_times_the_units() {
    let dir = Dir::new();
    let scene = dir.write("slide.toml", SLIDE);
    let table = |more: &[&str]| {
        let mut args = vec![
            "simulate",
            &scene,
            "--speed",
            "20 mm/s",
            "--out",
            "trace.csv",
        ];
        args.extend(more);
        let run = dir.run(&args);
        assert!(run.code < 2, "{}", run.stderr);
        let text = std::fs::read_to_string(dir.path("trace.csv")).expect("a trace");
        let mut lines = text.lines().map(str::to_owned);
        let header = lines.next().expect("a header");
        (header, lines.collect::<Vec<_>>())
    };
    let (header, plain) = table(&[]);
    let (si_header, si) = table(&["--si"]);
    assert_eq!(
        si_header,
        "h,t [s],x [m],v [m/s],generated_linear [J],generated_quantized [J],dissipated [J],\
         criterion_holds,violates_linear,violates_quantized"
    );
    // The sample that ends the run is a row as well.
    assert_eq!(plain.len() + 1, si.len());
    let figure = |header: &str, row: &str, name: &str| {
        let at = header.split(',').position(|column| column == name);
        let cell = row.split(',').nth(at.unwrap_or_else(|| panic!("{name}")));
        cell.and_then(|cell| cell.parse::<f64>().ok())
            .unwrap_or_else(|| panic!("{name}"))
    };
    // Δ = 1e-5 m, T = 1e-3 s, K = 1000 N/m: KΔ² = 1e-7 J.
    for (row, si_row) in plain.iter().zip(&si) {
        for (name, si_name, unit) in [
            ("h", "t [s]", 1e-3),
            ("xi0", "x [m]", 1e-5),
            ("v0", "v [m/s]", 1e-2),
            ("generated_quantized", "generated_quantized [J]", 1e-7),
            ("dissipated", "dissipated [J]", 1e-7),
        ] {
            let expected = figure(&header, row, name) * unit;
            let found = figure(&si_header, si_row, si_name);
            // The unit and the product are each rounded once, here and there.
            assert!(
                (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
                "{si_name}"
            );
        }
    }
    let bounds = dir.run(&[
        "simulate",
        &scene,
        "--method",
        "enclosure",
        "--out",
        "e.csv",
        "--si",
    ]);
    assert_eq!(bounds.code, 2);
    assert!(
        bounds.stderr.contains("`--si` needs a scene in units"),
        "{}",
        bounds.stderr
    );
}
