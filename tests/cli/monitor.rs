//! The monitor in the loop and `passivity audit` of the log give the same account.
//!
//! What can have been given at the most is the same, but that the monitor rounds each interval outward to its unit;
//! what was given at the least is exact in the monitor, and in an audit never more.

#[path = "../../crates/passivity-monitor-capi/tests/bare/mod.rs"]
mod bare;

use std::io::{BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use num_bigint::BigInt;
use num_traits::ToPrimitive as _;
use passivity_core::{BigRational, Controller, Friction, Loop, Scalar as _};
use passivity_monitor::{Answer, Config, Monitor};
use passivity_scene::Scene;
use passivity_sim::{Method, simulate};
use serde_json::Value;

use crate::harness::{Dir, root};

fn ratio(n: i128, d: i128) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// What a monitor says of a run, energies in halves of the unit of force times a tick.
struct Watched {
    answer: Answer,
    least: i128,
    most: i128,
}

/// Holds an audit of the same run to what the monitor said. `stiffness` is KΔ in the monitor's unit.
fn compare(name: &str, document: &Value, watched: &Watched, first: i64, stiffness: i64) {
    let number = |value: &Value| {
        let text = value.as_str().expect("a rational");
        let (n, d) = text.split_once('/').unwrap_or((text, "1"));
        BigRational::new(n.parse().expect("digits"), d.parse().expect("digits"))
    };
    let supply = &document["running"]["supply"];
    let in_k = |energy: i128| ratio(energy, 2 * i128::from(stiffness));
    // Of the counts n to n + 1 the farther from zero.
    let stored = ratio(first.abs().max((first + 1).abs()).into(), 1);
    let floor = -(stored.clone() * stored).half();
    assert_eq!(number(&supply["floor"]), floor, "{name}");

    // What is left of the stored energy is what was not given. Each interval, and the end, is rounded by
    // less than a unit.
    let rounding = in_k(i128::from(document["samples"].as_u64().expect("a number")));
    let least = Ord::min(floor - in_k(watched.most), BigRational::zero());
    let audited = number(&supply["least"]);
    assert!(
        least <= audited && audited < least.clone() + rounding,
        "{name}: the most that was given leaves {least}, by the audit {audited}"
    );
    let surely = match &supply["surely_drawn"] {
        Value::Null => BigRational::zero(),
        drawn => number(drawn),
    };
    assert!(
        surely <= Ord::max(in_k(watched.least), BigRational::zero()),
        "{name}: surely drawn {surely}, at the least {}",
        watched.least
    );
    if document["judged"] == "running" {
        let verdict = document["verdict"].as_str();
        match watched.answer {
            // Of another force than the wall's the audit does not take for stored what the spring stores, but for a tick.
            Answer::SurelyPassive => {
                let mut findings = document["findings"].as_array().expect("a list").iter();
                let is_stored = findings.any(|finding| finding["kind"] == "stored_energy");
                let expected = if is_stored { "depends" } else { "holds" };
                assert_eq!(verdict, Some(expected), "{name}");
                let half = BigRational::new(1.into(), 2.into());
                assert!(
                    !is_stored || -number(&supply["least"]) > half,
                    "{name}: {supply}"
                );
            }
            Answer::Open => assert_eq!(verdict, Some("depends"), "{name}"),
            // The audit may not be sure.
            Answer::SurelyActive => assert_ne!(verdict, Some("holds"), "{name}"),
            Answer::Unknown => panic!("{name}: a number did not fit"),
        }
    }
}

/// A run of counts with the forces that were held, in KΔ.
struct Run {
    name: String,
    friction: Friction<BigRational>,
    counts: Vec<i64>,
    forces: Vec<BigRational>,
}

impl Run {
    /// A small unit of force in which every number of the run is whole: KΔ is that many.
    fn unit(&self) -> i64 {
        let numbers = self
            .forces
            .iter()
            .chain([&self.friction.beta, &self.friction.sigma]);
        let unit = numbers.fold(BigInt::from(2), |unit, x| num_integer_lcm(&unit, x.denom()));
        1000 * unit.to_i64().expect("the numbers of the vectors are short")
    }

    fn watch(&self, stiffness: i64) -> Watched {
        let whole = |x: &BigRational| {
            let x = x * ratio(stiffness.into(), 1);
            assert!(x.is_integer());
            x.to_integer()
                .to_i64()
                .expect("the numbers of the vectors are short")
        };
        let Friction { beta, sigma } = &self.friction;
        let config = Config::new(stiffness, whole(beta), whole(sigma)).expect("in range");
        let mut samples = self.counts.iter().zip(self.forces.iter().map(whole));
        let (count, force) = samples.next().expect("a run has a sample");
        let mut monitor = Monitor::<i128>::start(config, *count, force);
        let (mut least, mut most) = (i128::MIN, i128::MIN);
        for (count, force) in samples {
            monitor.sample(*count, force);
            let given = monitor.given().expect("128 bits are enough");
            least = least.max(given.least);
            most = most.max(given.most);
        }
        Watched {
            answer: monitor.answer(),
            least,
            most,
        }
    }

    fn check(&self, dir: &Dir) {
        let Friction { beta, sigma } = &self.friction;
        let scene = format!("[dimensionless]\nbeta = \"{beta}\"\nsigma = \"{sigma}\"\n");
        let scene = dir.write("run.toml", scene);
        let mut log = String::from("count,f\n");
        for (count, force) in self.counts.iter().zip(&self.forces) {
            log.push_str(&format!("{count},{force}\n"));
        }
        let log = dir.write("run.csv", log);
        let run = dir.run(&["audit", &log, "--scene", &scene, "--format", "json"]);
        let stiffness = self.unit();
        let watched = self.watch(stiffness);
        compare(&self.name, &run.json(), &watched, self.counts[0], stiffness);
    }
}

/// The least common multiple.
fn num_integer_lcm(a: &BigInt, b: &BigInt) -> BigInt {
    let (mut x, mut y) = (a.clone(), b.clone());
    while y != BigInt::ZERO {
        (x, y) = (y.clone(), x % y);
    }
    a * b / x
}

fn of_text(value: &Value) -> BigRational {
    let text = value.as_str().expect("a rational");
    let (n, d) = text.split_once('/').unwrap_or((text, "1"));
    BigRational::new(n.parse().expect("digits"), d.parse().expect("digits"))
}

/// The run of a vector, as an encoder and the loop's own controller would log it.
fn of_vector(test: &Value) -> Option<Run> {
    let request = &test["request"];
    if request["encoder"] == false || request.get("dtau").is_some_and(Value::is_array) {
        return None;
    }
    let of = |key: &str| request.get(key).map(of_text);
    let counts: Vec<i64> = match (&request["op"], request.get("count"), request.get("xi")) {
        (Value::String(op), ..) if op == "interval" => ["count0", "count1"]
            .map(|key| request[key].as_i64().expect("a count"))
            .to_vec(),
        (_, Some(counts), _) => {
            let counts = counts.as_array().expect("a list");
            let count = |n: &Value| n.as_str().and_then(|n| n.parse().ok()).expect("a count");
            counts.iter().map(count).collect()
        }
        (_, None, Some(positions)) => {
            let positions = positions.as_array().expect("a list");
            let tick = |xi: &Value| of_text(xi).floor().to_integer().to_i64();
            positions
                .iter()
                .map(|xi| tick(xi).expect("a short number"))
                .collect()
        }
        _ => panic!("neither counts nor positions: {request}"),
    };
    let dtau = of("dtau").unwrap_or_else(BigRational::one);
    let friction = Friction::new(of("beta")? / dtau, of("sigma")?);
    let mut dimensionless = Loop::plain(friction.clone());
    dimensionless.damping = of("damping");
    dimensionless.force_step = of("force_step");
    dimensionless.max_force = of("max_force");
    dimensionless.unilateral = request["unilateral"] == true;
    dimensionless.delay = match request.get("delay").map(Value::as_u64) {
        None => 0,
        Some(delay) => delay
            .expect("a number of samples")
            .try_into()
            .expect("a few"),
    };
    let controller = Controller::of(&dimensionless);
    let measured: Vec<BigRational> = counts
        .iter()
        .map(|n| controller.measured(&BigRational::from_integer((*n).into())))
        .collect();
    let forces = (0..counts.len()).map(|h| {
        let known: Vec<BigRational> = measured[..=h].iter().rev().cloned().collect();
        controller.held_force(&known)
    });
    Some(Run {
        name: format!("vector {}", test["id"]),
        friction,
        forces: forces.collect(),
        counts,
    })
}

#[test]
fn every_vector_of_counts_or_with_a_law_agrees() {
    let dir = Dir::new();
    let mut agreed = 0;
    for group in ["counts", "runs", "effects"] {
        let path = root().join(format!("tests/vectors/{group}.json"));
        let text = std::fs::read_to_string(path).expect("the vectors are there");
        let document: Value = serde_json::from_str(&text).expect("they are JSON");
        for run in document["tests"]
            .as_array()
            .expect("a list")
            .iter()
            .filter_map(of_vector)
        {
            run.check(&dir);
            agreed += 1;
        }
    }
    assert_eq!(agreed, 195 + 100 + 210);
}

/// The C example at one end, the simulator at the other, a thousand samples of a kilohertz.
#[test]
fn the_loop_in_c_against_the_simulator_agrees() {
    let dir = Dir::new();
    let program = compiled(&dir);
    saturates(&program);
    for (name, velocity, push) in [
        ("left alone", 3.0, 0.0),
        ("pushed into the wall", 0.0, 40.0),
        ("shaken", 1.0, 25.0),
    ] {
        let mut child = Command::new(&program)
            .arg(dir.path("log.csv"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the loop starts");
        let mut counter = child.stdin.take().expect("a pipe");
        let mut amplifier = BufReader::new(child.stdout.take().expect("a pipe"));
        let (mut xi, mut v) = (0.25_f64, velocity);
        let mut counts = Vec::new();
        for h in 0..1000 {
            let count = xi.floor();
            counts.push(count);
            writeln!(counter, "{count}").expect("the loop reads");
            let mut force = String::new();
            amplifier.read_line(&mut force).expect("the loop writes");
            let held: f64 = force.trim().parse().expect("a number");
            let hand = match name {
                "shaken" => push * f64::from(h / 7 % 3 - 1),
                _ => push,
            };
            (xi, v) = interval(xi, v, held / 1000.0 + hand);
        }
        drop(counter);
        let output = child.wait_with_output().expect("the loop ends");
        assert!(output.status.success());
        let said = String::from_utf8(output.stderr).expect("text");
        let said: Vec<i128> = said
            .split_whitespace()
            .map(|word| word.parse().expect("numbers"))
            .collect();
        let [answer, least, most] = said[..] else {
            panic!("{name}: {said:?}");
        };
        let answer = match answer {
            0 => Answer::SurelyPassive,
            1 => Answer::Open,
            2 => Answer::SurelyActive,
            _ => Answer::Unknown,
        };
        let scene = dir.write(
            "loop.toml",
            "[dimensionless]\nbeta = \"2.5\"\nsigma = \"1.2\"\n",
        );
        let run = dir.run(&["audit", "log.csv", "--scene", &scene, "--format", "json"]);
        let document = run.json();
        assert_eq!(
            document["judged"], "running",
            "{name}: the damping is not the wall's"
        );
        assert_eq!(document["samples"], 1000);
        compare(
            name,
            &document,
            &Watched {
                answer,
                least,
                most,
            },
            0,
            1000,
        );
        assert_ne!(
            answer,
            Answer::SurelyActive,
            "{name}: β and σ are more than damping asks for"
        );
        let moved = counts.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert!(moved > 4, "{name}: it moved in {moved} intervals");
    }
}

/// Counts whose force does not fit into 32 bits, and after which the loop stops rendering: the step of the first run
/// is too long, the energy stored at the start of the others too large.
fn saturates(program: &Path) {
    for (counts, forces) in [
        (
            "2000000\n2147483647\n2147483647\n0\n",
            "-2000000500\n-2147483647\n0\n0\n",
        ),
        ("2147483647\n2147483647\n", "-2147483647\n0\n"),
        ("-2147483648\n-2147483648\n", "2147483647\n0\n"),
    ] {
        assert_eq!(forces_at(program, counts), forces, "{counts}");
    }
}

/// What the loop commands at these counts.
fn forces_at(program: &Path, counts: &str) -> String {
    let mut child = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the loop starts");
    let mut counter = child.stdin.take().expect("a pipe");
    counter
        .write_all(counts.as_bytes())
        .expect("the loop reads");
    drop(counter);
    let output = child.wait_with_output().expect("the loop ends");
    String::from_utf8(output.stdout).expect("text")
}

/// One interval of the simulator under a force: its own wall is on one side and far away.
fn interval(xi: f64, v: f64, force: f64) -> (f64, f64) {
    const FAR: f64 = 65536.0;
    let scene = format!(
        "[dimensionless]\nmu = \"50\"\nbeta = \"2.5\"\nsigma = \"1.2\"\n[wall]\nunilateral = true\n\
         [operator]\nforce = \"{force:.9}\"\n[start]\nposition = \"{:.12}\"\nvelocity = \"{v:.12}\"\n\
         [run]\nintervals = 1\n",
        xi - FAR
    );
    let point = Scene::from_toml("interval", &scene)
        .expect("a scene")
        .point();
    let end = simulate(&point, &Method::ClosedForm, None)
        .expect("it runs")
        .end;
    (end.xi + FAR, end.velocity)
}

/// The example, linked with the library as for a microcontroller.
fn compiled(dir: &Dir) -> PathBuf {
    let capi = root().join("crates/passivity-monitor-capi");
    let library = bare::library(&capi);
    let program = dir.path("loop");
    let status = Command::new("cc")
        .args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-I"])
        .arg(capi.join("include"))
        .arg(capi.join("examples/loop.c"))
        .arg(library)
        .arg("-o")
        .arg(&program)
        .status()
        .expect("there is a C compiler");
    assert!(status.success(), "the example does not compile");
    program
}
