//! Logs as devices write them: each is read by the command that the error before it shows.

mod mistakes;

use std::fmt::Write as _;
use std::io::Write as _;
use std::process::Command;

use serde_json::Value;

use crate::harness::{Dir, Run};

pub(crate) const SCENE: &str = "[device]\nviscous = \"9e-5 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n\
    [sampling]\nperiod = \"350 us\"\n[encoder]\ncounts_per_revolution = 8192\n\
    [wall]\nstiffness = \"1 N m/rad\"\n";

/// One revolution over the counts of it, in radians.
const TICK: f64 = std::f64::consts::TAU / 8192.0;

/// A sample of the motion that every log has: a hand that presses in and lets go.
pub(crate) struct Sample {
    pub(crate) micros: i64,
    pub(crate) radians: f64,
    pub(crate) velocity: f64,
    /// Of the wall, from the position as it is measured.
    pub(crate) torque: f64,
}

/// `late` samples, and the torque `scale` times that of the wall.
pub(crate) fn motion(late: usize, scale: f64) -> Vec<Sample> {
    let position = |i: usize| 0.05 * (0.03 * i as f64).sin() + 1e-7;
    (0..150)
        .map(|i| Sample {
            micros: 350 * i as i64,
            radians: position(i),
            velocity: 0.05 * 0.03 / 350e-6 * (0.03 * i as f64).cos(),
            torque: -scale * ((position(i.saturating_sub(late)) / TICK).floor() + 0.5) * TICK,
        })
        .collect()
}

/// A table of these samples: its header, and how each sample is written.
fn table(header: &str, samples: &[Sample], row: impl Fn(usize, &Sample) -> String) -> String {
    let mut text = format!("{header}\n");
    for (i, sample) in samples.iter().enumerate() {
        writeln!(text, "{}", row(i, sample)).unwrap();
    }
    text
}

fn epfl(samples: &[Sample]) -> String {
    let header = "timestep [us],encoder_paddle_pos [deg],paddle_speed [deg/s],hall_voltage [V],motor_torque [N.m]";
    table(header, samples, |_, s| {
        let (x, v) = (s.radians.to_degrees(), s.velocity.to_degrees());
        format!("{},{x:.9},{v:.4},1.65,{:.12}", s.micros, s.torque)
    })
}

/// The command that an error shows, in a folder where `passivity` is ours.
fn shown(run: &Run) -> String {
    assert_eq!(run.code, 2, "{}", run.stdout);
    assert_eq!(run.stderr.lines().count(), 1, "{}", run.stderr);
    match run.stderr.trim_end().split_once(" run: passivity ") {
        // Where positions may be in degrees, that is shown behind it.
        Some((_, ways)) => ways
            .split(" (or, where ")
            .next()
            .unwrap_or_default()
            .to_owned(),
        None => panic!("no command in {}", run.stderr),
    }
}

/// Runs a shown command, as a shell takes it, for programs.
fn follow(dir: &Dir, command: &str) -> (Run, Value) {
    let script = format!(
        "'{}' {command} --format json",
        env!("CARGO_BIN_EXE_passivity")
    );
    let output = Command::new("sh")
        .args(["-c", &script])
        .current_dir(dir.path("."))
        .output()
        .expect("a shell");
    let run = Run::from(output);
    let json = run.json();
    (run, json)
}

/// Audits a log by the command that its own error shows.
pub(crate) fn told(dir: &Dir, name: &str) -> (Run, Value) {
    let refused = dir.run(&["audit", name, "--scene", "scene.toml"]);
    follow(dir, &shown(&refused))
}

#[test]
fn ten_logs_of_ten_shapes_are_read_by_the_command_that_the_error_shows() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    let samples = motion(0, 1.0);
    let gzip = |text: &str| {
        let mut file = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        file.write_all(text.as_bytes()).unwrap();
        file.finish().unwrap()
    };
    // Behind a frame that is skipped, as `pzstd` writes it.
    let zstd = |text: &str| {
        let frame = zstd::encode_all(text.as_bytes(), 1).unwrap();
        [b"\x50\x2a\x4d\x18\x04\0\0\0".to_vec(), vec![0; 4], frame].concat()
    };
    let plain = |text: String| text.into_bytes();
    let seconds = |s: &Sample| s.micros as f64 * 1e-6;
    // `t` where there is a clock, and `v` where there is a velocity.
    let shapes: [(&str, Vec<u8>, bool, bool); 10] = [
        ("epfl.csv", plain(epfl(&samples)), true, true),
        (
            "prism.csv",
            plain(table("time,theta,tau,velocity", &samples, |_, s| {
                format!(
                    "{:.6},{:.12},{:.12},{:.6}",
                    seconds(s),
                    s.radians,
                    s.torque,
                    s.velocity
                )
            })),
            true,
            true,
        ),
        (
            "greek.csv",
            plain(table("θ,τ", &samples, |_, s| {
                format!("{:.12},{:.12}", s.radians, s.torque)
            })),
            false,
            false,
        ),
        (
            "ros1.csv",
            plain(table(
                "%time,field.header.seq,field.header.frame_id,field.position0,field.velocity0,field.effort0",
                &samples,
                |i, s| {
                    let time = 1_700_000_000_000_000_000 + 1000 * s.micros;
                    format!(
                        "{time},{i},base,{:.12},{:.6},{:.12}",
                        s.radians, s.velocity, s.torque
                    )
                },
            )),
            true,
            true,
        ),
        (
            "ros2.csv",
            plain(table(
                "__time,/joint_states/position[0],/joint_states/position[1],/joint_states/velocity[0],/joint_states/effort[0]",
                &samples,
                |_, s| {
                    let time = 1_700_000_000_000_000 + s.micros;
                    let (whole, rest) = (time / 1_000_000, time % 1_000_000);
                    format!(
                        "{whole}.{rest:06},{:.12},0.5,{:.6},{:.12}",
                        s.radians, s.velocity, s.torque
                    )
                },
            )),
            true,
            true,
        ),
        (
            "semicolons.csv",
            plain(table(
                "Zeit (ms);Winkel (deg);Moment (mNm)",
                &samples,
                |_, s| {
                    let (t, x) = (s.micros as f64 * 1e-3, s.radians.to_degrees());
                    format!("{t:.3};{x:.9};{:.9}", 1e3 * s.torque).replace('.', ",")
                },
            )),
            true,
            false,
        ),
        (
            "tabs.tsv",
            plain(table("time_us\tangle_rad\ttorque_Nm", &samples, |_, s| {
                format!("{}\t{:.12}\t{:.12}", s.micros, s.radians, s.torque)
            })),
            true,
            false,
        ),
        ("epfl.csv.gz", gzip(&epfl(&samples)), true, true),
        ("epfl.csv.zst", zstd(&epfl(&samples)), true, true),
        (
            "pipes.txt",
            plain(table("t|pos|F", &samples, |_, s| {
                format!("{:.6}|{:.12}|{:.12}", seconds(s), s.radians, s.torque)
            })),
            true,
            false,
        ),
    ];
    for (name, text, has_clock, has_velocity) in shapes {
        dir.write(name, text);
        let (run, json) = told(&dir, name);
        assert_eq!(run.code, 0, "{name}: {}{}", run.stdout, run.stderr);
        assert_eq!(json["verdict"], "holds", "{name}");
        assert_eq!(json["samples"], 150, "{name}");
        assert_eq!(json["account"], "applied", "{name}");
        assert_eq!(json["force"]["agrees"], true, "{name}: {}", json["force"]);
        assert_eq!(json["timing"].is_object(), has_clock, "{name}");
        assert_eq!(json["velocity"].is_object(), has_velocity, "{name}");
        if has_clock {
            assert_eq!(json["timing"]["uneven"], 0, "{name}");
        }
        if has_velocity {
            let fit = &json["velocity"]["fit"];
            let scale = fit["scale"].as_f64().unwrap();
            assert!((scale - 1.0).abs() < 0.01, "{name}: {fit}");
        }
        assert_eq!(
            json["findings"].as_array().unwrap().len(),
            0,
            "{name}: {}",
            json["findings"]
        );
    }
}

#[test]
fn counts_clocks_with_jitter_and_gaps_are_read() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    let samples = motion(0, 1.0);
    let text = table(
        "time [s],encoder_counts,motorTorqueCmd [N-m]",
        &samples,
        |i, s| {
            // A microsecond of jitter, and a gap of ten samples.
            let micros = s.micros + (i as i64 * 7) % 3 + if i > 100 { 3500 } else { 0 };
            let counts = (s.radians / TICK).floor();
            format!(
                "{}.{:06},{counts},{:.12}",
                micros / 1_000_000,
                micros % 1_000_000,
                s.torque
            )
        },
    );
    dir.write("jitter.csv", text);
    let (run, json) = told(&dir, "jitter.csv");
    assert!(run.code <= 1, "{}", run.stderr);
    assert_eq!(json["positions"], "count");
    assert_eq!(json["timing"]["missed_samples"], 10);
    assert_eq!(json["force"]["agrees"], true);
}

#[test]
fn a_force_that_is_doubled_turned_or_late_is_found_with_what_puts_it_right() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    for (late, scale, kind, fix) in [
        (0, 2.0, "scale", "stiffness = \"2 N m/rad\""),
        (0, -1.0, "sign", "f=-motor_torque [N.m]"),
        (3, 1.0, "delay", "delay = 3"),
    ] {
        let name = dir.write("log.csv", epfl(&motion(late, scale)));
        let (run, json) = told(&dir, &name);
        let findings = json["findings"].as_array().unwrap();
        assert_eq!(findings.len(), 1, "{kind}: {findings:?}");
        assert_eq!(findings[0]["kind"], kind);
        assert!(
            findings[0]["fix"].as_str().unwrap().contains(fix),
            "{findings:?}"
        );
        // It is accounted for as it was applied, and the law's account stands beside it.
        assert_eq!(
            (&json["account"], &json["judged"]),
            (&"applied".into(), &"running".into())
        );
        assert_eq!(json["law"]["verdict"], "holds", "{kind}");
        assert_ne!(json["totals"], json["law"]["totals"], "{kind}");
        // A spring that pushes along gives what nobody put in. One that is twice as stiff or late may hold.
        if kind == "sign" {
            assert_eq!(run.code, 1, "{kind}: {}", json["verdict"]);
        }
    }
    // What the finding shows puts the sign right.
    let name = dir.write("log.csv", epfl(&motion(0, -1.0)));
    let (_, json) = told(&dir, &name);
    let fix = json["findings"][0]["fix"].as_str().unwrap();
    let (_, columns) = fix.split_once("--columns ").unwrap();
    let command = format!("audit {name} --scene scene.toml --columns {columns}");
    let (run, json) = follow(&dir, &command);
    assert_eq!(
        (run.code, &json["force"]["agrees"]),
        (0, &true.into()),
        "{}",
        run.stderr
    );
    // And so do the scene's delay and stiffness.
    for (late, scale, key, value) in [
        (
            3,
            1.0,
            "period = \"350 us\"",
            "period = \"350 us\"\ndelay = 3",
        ),
        (0, 2.0, "\"1 N m/rad\"", "\"2 N m/rad\""),
    ] {
        dir.write("scene.toml", SCENE.replace(key, value));
        let name = dir.write("log.csv", epfl(&motion(late, scale)));
        let (_, json) = told(&dir, &name);
        assert_eq!(json["force"]["agrees"], true, "{value}");
        assert_eq!(
            json["findings"].as_array().unwrap().len(),
            0,
            "{}",
            json["findings"]
        );
    }
}

#[test]
fn several_files_are_one_log_in_order() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    let whole = epfl(&motion(0, 1.0));
    let (header, rows) = whole.split_once('\n').unwrap();
    let lines: Vec<&str> = rows.lines().collect();
    let part = |range: std::ops::Range<usize>| format!("{header}\n{}\n", lines[range].join("\n"));
    dir.write("whole.csv", &whole);
    dir.write("a.csv", part(0..60));
    dir.write("b.csv", part(60..61));
    dir.write("c.csv", part(61..150));
    let columns = "t=timestep [us], x=encoder_paddle_pos [deg], f=motor_torque [N.m]";
    let audit = |files: &[&str]| {
        let more = [
            "--scene",
            "scene.toml",
            "--columns",
            columns,
            "--format",
            "json",
        ];
        dir.run(&[&["audit"], files, &more[..]].concat())
    };
    let (one, three) = (audit(&["whole.csv"]), audit(&["a.csv", "b.csv", "c.csv"]));
    assert_eq!((one.code, three.code), (0, 0), "{}", three.stderr);
    assert_eq!(one.json(), three.json());
    // In another order the clock runs backward: the file is named, with its own row.
    let wrong = audit(&["b.csv", "a.csv"]);
    assert_eq!(wrong.code, 2);
    assert!(
        wrong
            .stderr
            .starts_with("error: a.csv, row 1, column `timestep [us]`: expected a time after"),
        "{}",
        wrong.stderr
    );
    dir.write("d.csv", "timestep [us],x [deg]\n0,0\n");
    let wrong = audit(&["a.csv", "d.csv"]);
    assert_eq!(wrong.code, 2);
    assert!(
        wrong
            .stderr
            .contains("d.csv, row 1: the files of a log must have the same header"),
        "{}",
        wrong.stderr
    );
    let wrong = audit(&["a.csv", "nothing.csv"]);
    assert!(
        wrong.stderr.contains("nothing.csv, row 1: No such file"),
        "{}",
        wrong.stderr
    );
    let wrong = audit(&["nothing.csv", "a.csv"]);
    let named = "error: nothing.csv: No such file";
    assert!(wrong.stderr.starts_with(named), "{}", wrong.stderr);
}
