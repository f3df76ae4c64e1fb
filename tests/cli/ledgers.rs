//! The ledger that `passivity simulate` writes and prints.

use passivity_scene::number;

use crate::harness::Dir;

/// A device that moves through several intervals, with this beside it.
fn scene(more: &str) -> String {
    let start = match more.contains("[start]") {
        true => "",
        false => "[start]\nvelocity = \"4\"\n",
    };
    format!("[dimensionless]\nmu = \"50\"\nsigma = \"3/5\"\n{more}\n{start}[run]\nintervals = 12\n")
}

/// The columns of a table with these names, row by row.
fn columns(text: &str, names: &[&str]) -> Vec<Vec<String>> {
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let find = |name: &&str| header.iter().position(|column| column == name);
    let places: Vec<usize> = names
        .iter()
        .map(|name| find(name).expect("a column"))
        .collect();
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        places.iter().map(|at| cells[*at].to_owned()).collect()
    };
    lines.map(row).collect()
}

/// The rows of `simulate --out`, and those that `audit --out` makes of them.
fn rows(scene: &str, method: &str, names: &[&str]) -> [Vec<Vec<String>>; 2] {
    let dir = Dir::new();
    let scene = dir.write("scene.toml", scene);
    let args = ["simulate", &scene, "--method", method, "--out", "own.csv"];
    let run = dir.run(&args);
    assert!(run.code < 2, "{}", run.stderr);
    let run = dir.run(&["audit", "--scene", &scene, "own.csv", "--out", "audit.csv"]);
    assert_ne!(run.code, 2, "{}", run.stderr);
    let read = |file| std::fs::read_to_string(dir.path(file)).expect("a table");
    let [own, audit] = ["own.csv", "audit.csv"].map(|file| columns(&read(file), names));
    assert!(!own.is_empty() && own.len() == audit.len());
    [own, audit]
}

#[test]
fn rows_are_those_that_an_audit_makes_of_them() {
    let friction = "beta = \"4\"\n";
    for (effect, known) in [
        ("", true),
        ("[sampling]\ndelay = 1", true),
        ("[sampling]\ndelay = 2\n[start]\nposition = \"1/5\"", true),
        ("[wall]\ndamping = \"1\"", true),
        ("[wall]\ndamping = \"1/2\"\n[sampling]\ndelay = 3", true),
        ("[wall]\nunilateral = true", true),
        ("[wall]\nmax_force = \"3\"\nforce_step = \"1/4\"", true),
        ("[operator]\nforce = \"2\"", true),
        (
            "[operator]\narm = { mass = \"5\", damping = \"1/5\", stiffness = \"1/2\" }",
            true,
        ),
        ("[sampling]\nlatency = \"1/2\"", false),
        ("[amplifier]\ntime_constant = \"1/5\"", false),
        (
            "[wall]\ndamping = \"1\"\ndamping_time_constant = \"2\"",
            false,
        ),
        (
            "[controller]\nnumerator = [\"1/2\", \"1/4\", \"1/4\"]\ndenominator = [\"1\", \"0\", \"0\"]",
            false,
        ),
    ] {
        let names = [
            "criterion_holds",
            "net_linear",
            "net_quantized",
            "violates_linear",
            "violates_quantized",
        ];
        let [own, audit] = rows(
            &scene(&format!("{friction}{effect}")),
            "closed-form",
            &names,
        );
        for (own, audit) in own.iter().zip(&audit) {
            assert_eq!(own[0], audit[0], "{effect}");
            if !known {
                assert!(own[1..].iter().all(String::is_empty), "{effect}: {own:?}");
                continue;
            }
            for (net, violates) in [(1, 3), (2, 4)] {
                let [a, b] = [own, audit].map(|row| {
                    let (n, d) = row[net].split_once('/').unwrap_or((&row[net], "1"));
                    let [n, d] = [n, d].map(|x| x.parse::<f64>().expect("a number"));
                    n / d
                });
                // Some dozen roundings of energies below 400, the reach being below 20.
                let rounding = 30.0 * f64::EPSILON * 400.0;
                assert!((a - b).abs() < rounding, "{effect}: {own:?} {audit:?}");
                let decided = b == 0.0 || b.abs() > rounding;
                assert!(!decided || own[violates] == audit[violates], "{effect}");
            }
        }
    }
}

#[test]
fn exact_rows_are_those_of_an_audit_to_the_last_digit() {
    let names = [
        "net_linear",
        "net_quantized",
        "margin",
        "criterion_holds",
        "violates_linear",
        "violates_quantized",
    ];
    for effect in ["", "[wall]\ndamping = \"1/2\"\n[sampling]\ndelay = 2"] {
        let start = "[start]\nposition = \"3/7\"\nvelocity = \"1/4\"";
        let [own, audit] = rows(&scene(&format!("{effect}\n{start}")), "exact", &names);
        assert_eq!(own, audit, "{effect}");
    }
}

#[test]
fn a_scene_without_an_encoder_has_no_ticks() {
    let dir = Dir::new();
    let run = |viscous: &str, coulomb: &str| {
        let text = format!(
            "[device]\nmass = \"0.5 kg\"\nviscous = \"{viscous} N s/m\"\ncoulomb = \"{coulomb} N\"\n[sampling]\n\
             rate = \"1 kHz\"\n[wall]\nstiffness = \"1 N/mm\"\n[start]\nvelocity = \"0.01 m/s\"\n"
        );
        let scene = dir.write("slide.toml", &text);
        let run = dir.run(&[
            "simulate",
            &scene,
            "--intervals",
            "3000",
            "--plot",
            "slide.svg",
        ]);
        assert!(run.code < 2, "{}", run.stderr);
        let svg = std::fs::read_to_string(dir.path("slide.svg")).expect("a picture");
        assert!(svg.contains("held force (N)") && !svg.contains("KΔ") && !svg.contains("tick"));
        assert!(!run.stdout.contains("tick"), "{}", run.stdout);
        assert!(!run.stdout.contains("KΔ²"), "{}", run.stdout);
        let log = dir.write("slide.csv", "x [m]\n0\n0.001\n0.003\n");
        let audit = dir.run(&["audit", &log, "--scene", &scene]).stdout;
        assert!(
            audit.contains("dissipated at least") && audit.contains(" K·(1 m)²"),
            "{audit}"
        );
        assert!(!audit.contains("KΔ²"), "{audit}");
        run.stdout
    };
    let damped = run("1", "1/100");
    for expected in [
        "start       x = 0 m, v = 0.01 m/s",
        "energy      generated ",
        " J\n",
    ] {
        assert!(damped.contains(expected), "{damped}");
    }
    let growing = run("1/10", "1/10000");
    let radius = growing.split("past the radius ").nth(1).expect("a radius");
    let (radius, _) = radius.split_once(" m of").expect("metres");
    assert!(radius.parse::<f64>().is_ok_and(|x| x > 0.0), "{growing}");
}

#[test]
fn one_interval_and_one_tick_are_in_the_singular() {
    let dir = Dir::new();
    let scene = dir.write(
        "scene.toml",
        scene("beta = \"4\"\n[start]\nposition = \"2\"\nvelocity = \"1\""),
    );
    let run = dir.run(&["simulate", &scene, "--intervals", "1"]);
    for expected in ["ξ = 2 ticks, ξ̇ = 1 tick/sample", ", 1 interval in "] {
        assert!(run.stdout.contains(expected), "{}", run.stdout);
    }
}

#[test]
fn an_audit_finds_nothing_in_the_velocities_of_a_simulation() {
    let dir = Dir::new();
    let slide = "[device]\nmass = \"0.5 kg\"\nviscous = \"1 N s/m\"\ncoulomb = \"0.01 N\"\n[sampling]\nrate = \"1 kHz\"\n\
                 [encoder]\nresolution = \"0.01 mm\"\n[wall]\nstiffness = \"1 N/mm\"\n[start]\nvelocity = \"20 mm/s\"\n";
    let slide = dir.write("slide.toml", slide);
    // A swing of half a period, and several slow ones.
    let swing = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenes/re35-locally-stable.toml"
    );
    let found = |scene: &str, columns: &[&str]| {
        let args = [
            "simulate",
            scene,
            "--intervals",
            "400",
            "--si",
            "--out",
            "si.csv",
        ];
        let run = dir.run(&args);
        assert!(run.code < 2, "{}", run.stderr);
        let run = dir.run(&[&["audit", "--scene", scene, "si.csv"], columns].concat());
        assert!(run.code < 2, "{}", run.stderr);
        run.stdout.contains("finding  ")
    };
    assert!(!found(swing, &[]));
    assert!(!found(&slide, &[]));
    assert!(
        found(&slide, &["--columns", "t=t,x=x,v=-v"]),
        "the other sign"
    );
}

/// What an audit of a simulation says, with one number where both ends of a figure read the same.
fn audited(scene: &str, more: &[&str]) -> (i32, Vec<String>) {
    let dir = Dir::new();
    let scene = dir.write("scene.toml", scene);
    let run = dir.run(&[&["simulate", &scene, "--out", "own.csv"], more].concat());
    assert!(run.code < 2, "{}", run.stderr);
    let run = dir.run(&["audit", "--scene", &scene, "own.csv"]);
    let figure = |line: &str| match line.split_once(" … ") {
        Some((start, end)) if start.rsplit(' ').next() == end.split(' ').next() => {
            format!("{}{end}", start.trim_end_matches(|c| c != ' '))
        }
        _ => line.to_owned(),
    };
    // A ledger has no velocities.
    let others = ["  columns", "  not read", "  velocity"];
    let columns = |line: &&str| !others.iter().any(|start| line.starts_with(start));
    let lines = run.stdout.lines().filter(columns).map(figure);
    (run.code, lines.collect())
}

/// Whether a line says the same as another, or has one figure where that has two ends around it.
fn is_told(line: &str, other: &str) -> bool {
    let numbers = |line: &str| -> Vec<f64> {
        line.split_whitespace()
            .filter_map(|word| word.parse().ok())
            .collect()
    };
    let words = |line: &str| -> Vec<String> {
        let words = line
            .split_whitespace()
            .filter(|word| word.parse::<f64>().is_err() && *word != "…");
        words.map(str::to_owned).collect()
    };
    match (numbers(line).as_slice(), numbers(other).as_slice()) {
        _ if line == other => true,
        ([x], [lo, hi]) => words(line) == words(other) && lo <= x && x <= hi,
        _ => false,
    }
}

#[test]
fn an_audit_of_a_ledger_in_si_units_is_that_of_the_other_one() {
    let cycles = include_str!("../../scenes/re35-limit-cycles.toml");
    let slide = |start: &str, more: &str| {
        format!(
            "[device]\nmass = \"0.5 kg\"\ncoulomb = \"0.01 N\"\n[encoder]\nresolution = \"1/3 µm\"\n\
             [wall]\nstiffness = \"1 N/mm\"\n[start]\n{start}\n[sampling]\nrate = \"3.2 kHz\"\n{more}"
        )
    };
    let fast = slide("velocity = \"20 mm/s\"", "");
    let below = |position: &str| {
        format!(
            "[device]\nmass = \"0.11 kg\"\n[encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"1000 N/m\"\n\
             [sampling]\nperiod = \"1 ms\"\n[start]\nposition = \"{position}\"\nvelocity = \"0 m/s\"\n\
             [run]\nintervals = 3\n"
        )
    };
    for (scene, more, code, first) in [
        // All that is wrong is in the last interval.
        (
            cycles.to_owned(),
            ["--intervals", "31"],
            1,
            "the first at row 31",
        ),
        // At rest before its time.
        (
            slide("position = \"14.1 µm\"", ""),
            ["--intervals", "5000"],
            0,
            "HOLDS",
        ),
        (
            slide("velocity = \"2 mm/s\"", "delay = 2"),
            ["--intervals", "25"],
            0,
            "",
        ),
        (
            slide("velocity = \"2 mm/s\"", "latency = \"0.1 ms\""),
            ["--intervals", "9"],
            3,
            "",
        ),
        // On an encoder edge that is no double in metres.
        (
            slide("position = \"49/3 µm\"", ""),
            ["--method", "exact"],
            0,
            "HOLDS",
        ),
        // Below one by less than doubles tell, on either side of the wall's.
        (
            below("0.0899999999999999999999 mm"),
            ["--method", "exact"],
            0,
            "HOLDS",
        ),
        (
            below("-0.0900000000000000000001 mm"),
            ["--method", "exact"],
            1,
            "the first at row 1",
        ),
        (fast, ["--intervals", "1"], 0, "HOLDS"),
    ] {
        let [(own, plain), (si_code, si)] = [
            audited(&scene, &more),
            audited(&scene, &[&more[..], &["--si"]].concat()),
        ];
        assert_eq!(own, si_code, "{scene}");
        assert_eq!(plain.len(), si.len(), "{scene}");
        for (plain, si) in plain.iter().zip(&si) {
            assert!(is_told(plain, si), "{plain}\n{si}\n{scene}");
        }
        assert_eq!(own, code, "{plain:?}");
        assert!(plain[0].contains(first), "{plain:?}");
    }
}

/// Ends of enclosures are read as the numbers that they spell: the shortest decimal of a double may be within.
#[test]
fn ends_of_enclosures_hold_the_motion_as_they_are_written() {
    let dir = Dir::new();
    let file = dir.write(
        "scene.toml",
        "[dimensionless]\nmu = \"5/4\"\nsigma = \"1/8\"\nbeta = \"50\"\n[wall]\nmax_force = \"2\"\n\
         [start]\nposition = \"-4\"\nvelocity = \"3\"\n[run]\nintervals = 1\n",
    );
    let json = |method: &str| {
        let words = ["simulate", &file, "--format", "json", "--method", method];
        dir.run(&words).json()["final"].clone()
    };
    let digits = json("reference:60")["digits"]["xi"].clone();
    let truth = number::parse(digits.as_str().expect("digits")).expect("a number");
    let enclosed = json("enclosure")["enclosure"]["xi"].clone();
    let [lo, hi] = ["lo", "hi"].map(|end| enclosed[end].to_string());
    let spelt = |text: &str| number::parse(text).expect("a number");
    assert!(
        spelt(&lo) < truth && truth < spelt(&hi),
        "{lo} {truth} {hi}"
    );
    assert_ne!(lo, "-3.8884375");
    // The text and the table say the same.
    let words = [
        "simulate",
        &file,
        "--method",
        "enclosure",
        "--out",
        "bounds.csv",
    ];
    let text = dir.run(&words).stdout;
    assert!(text.contains(&format!("ξ in [{lo}, {hi}]")), "{text}");
    let table = std::fs::read_to_string(dir.path("bounds.csv")).expect("the table");
    let ends = columns(&table, &["xi1_lo", "xi1_hi"]);
    assert_eq!(ends, [[lo, hi]]);
}
