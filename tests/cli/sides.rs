//! Values at the two sides of a transmission, as `plane` and `sweep` take and write them.

use crate::harness::Dir;

/// Friction and encoder at the motor, 15:1.
const PADDLE: &str = include_str!("../../scenes/desk/paddle.toml");

#[test]
fn a_measured_friction_is_at_the_side_of_the_scene() {
    let dir = Dir::new();
    let paddle = dir.write("paddle.toml", PADDLE);
    let compared = |header: &str, row: &str| {
        dir.write("m.csv", format!("{header},stable\n{row},unstable\n"));
        let run = dir.run(&[
            "plane",
            &paddle,
            "--axes",
            "coulomb,stiffness",
            "--measured",
            "m.csv",
            "--format",
            "json",
        ]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        run.json()
    };
    for (header, row) in [
        ("coulomb [N.m],stiffness [N.m/deg]", "0.001,0.9"),
        ("coulomb [mN m at the motor],stiffness [N.m/deg]", "1,0.9"),
        ("coulomb [mN m at the device],stiffness [N.m/deg]", "15,0.9"),
    ] {
        let document = compared(header, row);
        assert_eq!(document["axes"][0]["parameter"], "motor.coulomb");
        assert_eq!(document["axes"][0]["unit"], "N.m at the motor");
        assert_eq!(document["measured"]["points"][0]["x"].as_f64(), Some(0.001));
        assert_eq!(document["measured"]["looser"], 1, "{header}");
    }
    let document = compared(
        "coulomb [N.m at the device],stiffness [N.m/deg]",
        "0.001,0.9",
    );
    assert_eq!(document["measured"]["agree"], 1);
}

#[test]
fn the_header_of_a_plane_is_read_back() {
    let dir = Dir::new();
    let paddle = dir.write("paddle.toml", PADDLE);
    for (axes, header) in [
        (
            "coulomb,stiffness",
            "\"coulomb [N.m at the motor]\",\"stiffness [N.m/deg]\"",
        ),
        (
            "viscous [N m s/rad],counts_per_revolution",
            "\"viscous [N m s/rad at the motor]\",\"counts_per_revolution [at the motor]\"",
        ),
        (
            "viscous [N m s/rad at the device],resolution [deg]",
            "\"viscous [N m s/rad at the device]\",\"resolution [deg at the motor]\"",
        ),
    ] {
        let args = ["plane", &paddle, "--axes", axes, "--out", "border.csv"];
        let run = dir.run(&args);
        assert_eq!(run.code, 0, "{axes}: {}", run.stderr);
        let border = std::fs::read_to_string(dir.path("border.csv")).expect("a border");
        let first = border.lines().next().expect("a header");
        assert_eq!(first, format!("scenes,speeds,line,{header}"));
        dir.write("m.csv", format!("{header},stable\n1,2,stable\n"));
        let measured = [
            "plane",
            &paddle,
            "--axes",
            axes,
            "--measured",
            "m.csv",
            "--format",
            "json",
        ];
        let run = dir.run(&measured);
        assert_eq!(run.code, 0, "{axes}: {}", run.stderr);
        let point = &run.json()["measured"]["points"][0];
        assert_eq!(
            [&point["x"], &point["y"]].map(|x| x.as_f64()),
            [Some(1.0), Some(2.0)]
        );
    }
}

#[test]
fn scenes_with_other_transmissions_share_an_axis_at_the_device_alone() {
    let dir = Dir::new();
    let [one, other] = ["15:1", "10:1"].map(|ratio| {
        let name = format!("r{}.toml", &ratio[..2]);
        dir.write(&name, PADDLE.replace("15:1", ratio))
    });
    let run = |axes: &str| dir.run(&["plane", &one, &other, "--axes", axes, "--out", "border.csv"]);
    let refused = run("coulomb,stiffness");
    assert_eq!(refused.code, 2);
    let expected = "--axes `coulomb [N.m at the motor]` is not the same in `r15` and `r10`, of which a \
                    transmission or the side of it differs: write it at the device, as in \
                    `coulomb [N m at the device]`";
    assert!(refused.stderr.contains(expected), "{}", refused.stderr);
    assert_eq!(run("coulomb [N m at the device],stiffness").code, 0);
}

#[test]
fn a_sweep_varies_friction_at_the_motor_where_the_scene_has_it() {
    let dir = Dir::new();
    let moving = format!("{PADDLE}[start]\nvelocity = \"1 rad/s\"\n");
    let swept = dir.write("ps.toml", &moving);
    let run = dir.run(&[
        "sweep",
        &swept,
        "--vary",
        "coulomb=1,2 mN m",
        "--vary",
        "stiffness=0.02,0.03 N m/deg",
        "--intervals",
        "300",
        "--out",
        "s.csv",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let table = std::fs::read_to_string(dir.path("s.csv")).expect("a table");
    assert!(
        table.starts_with("coulomb [mN m at the motor],stiffness [N m/deg],"),
        "{table}"
    );
    let row = table.lines().nth(1).expect("a row");
    let swept: f64 = row
        .split(',')
        .nth(5)
        .and_then(|cell| cell.parse().ok())
        .expect("a number");
    let typed = moving.replace("0.0010 … 0.0012 N.m", "1 mN m") + "[run]\nintervals = 300\n";
    let typed = dir.write("typed.toml", typed);
    let document = dir.run(&["simulate", &typed, "--format", "json"]).json();
    let typed = document["final"]["xi"].as_f64().expect("a number");
    // The same loop over the same numbers gives the same bits.
    assert_eq!(swept.to_bits(), typed.to_bits(), "{swept} {typed}");
}

#[test]
fn no_command_takes_the_angle_of_the_motor_for_that_of_the_device() {
    let dir = Dir::new();
    let scene = dir.write("paddle.toml", PADDLE);
    let rows: String = (0..40)
        .map(|h| {
            format!(
                "{:.3},{:.2},0\n",
                f64::from(h) / 1000.0,
                -0.18 * f64::from(h % 2)
            )
        })
        .collect();
    let log = dir.write(
        "log.csv",
        format!("t [s],motor_angle [deg],f [N m]\n{rows}"),
    );
    for args in [
        &["audit", &log, "--scene", &scene][..],
        &["identify", &log, "--scene", &scene],
        &[
            "case",
            &scene,
            "--device",
            "3",
            "--date",
            "2026-11-28",
            "--log",
            &log,
            "--out",
            "case",
        ],
    ] {
        let run = dir.run(args);
        assert_eq!(run.code, 2, "{args:?}: {}", run.stderr);
        let says = "`motor_angle [deg]` is not read: by its name it seems to be at the motor, but `x` is at the device";
        assert!(run.stderr.contains(says), "{}", run.stderr);
        assert!(!run.stderr.contains("x=motor"), "{}", run.stderr);
    }
}
