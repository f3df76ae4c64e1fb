//! Positions that jump by the period of a counter: a finding, and no account that holds.

use passivity_audit::{Dialect, Finding, Options, Verdict, audit_csv, samples};
use passivity_scene::Scene;

use crate::scratch::Scratch;

const PLAIN: &str = "[dimensionless]\nbeta = \"60\"\nsigma = \"60\"\n";
const ROTARY: &str = "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nperiod = \"1 ms\"\n\
                      [encoder]\ncounts_per_revolution = 8000\n[wall]\nstiffness = \"1 N m/rad\"\n";

/// With a motor that turns ten times as far, and one whose pulley of 5 mm moves a carriage.
const GEARED: &str = "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[transmission]\nratio = \"10\"\n\
                      [sampling]\nperiod = \"1 ms\"\n[encoder]\ncounts_per_revolution = 4000\nside = \"motor\"\n\
                      [wall]\nstiffness = \"1 N m/rad\"\n";
const PULLED: &str = "[device]\nviscous = \"0.9 N s/m\"\ncoulomb = \"2 N\"\n[transmission]\nmotor_pulley = \"5 mm\"\n\
                      [sampling]\nperiod = \"1 ms\"\n[encoder]\ncounts_per_revolution = 4000\nside = \"motor\"\n\
                      [wall]\nstiffness = \"1 N/mm\"\n";

/// The verdict on a log, cut into blocks of this many bytes, and what is found of a wrap.
fn found(text: &str, scene: &str, block: usize) -> (Verdict, Option<Finding>) {
    let scene = Scene::from_toml("s", scene).unwrap();
    let options = Options {
        block,
        ..Options::default()
    };
    let audit = audit_csv(Box::new(text.to_owned().leak().as_bytes()), &scene, options).unwrap();
    assert_eq!(audit.error(), None);
    let mut wraps = audit.report().findings.iter().filter(|f| f.kind == "wrap");
    let wrap = wraps.next().cloned();
    assert_eq!(wraps.next(), None);
    (audit.verdict(), wrap)
}

/// A column of numbers under its name.
fn column(name: &str, numbers: impl IntoIterator<Item = f64>) -> String {
    let lines = numbers.into_iter().map(|x| format!("{x}\n"));
    std::iter::once(format!("{name}\n")).chain(lines).collect()
}

/// So many samples of a position that moves by `step` and wraps around within `least` and `least + period`.
fn around(period: f64, least: f64, start: f64, step: f64) -> Vec<f64> {
    let at = |i: i32| (start + step * f64::from(i) - least).rem_euclid(period) + least;
    (0..20).map(|i| (at(i) * 1e5).round() / 1e5).collect()
}

#[test]
fn a_counter_that_wraps_around_is_found_at_its_row() {
    for (name, scene, numbers, row, period) in [
        (
            "count",
            PLAIN,
            around(4096.0, 0.0, 4090.0, 1.0),
            6,
            "4096 ticks (12 bits)",
        ),
        (
            "count",
            PLAIN,
            around(8192.0, 0.0, 8185.0, 3.0),
            3,
            "8192 ticks (13 bits)",
        ),
        (
            "xi",
            PLAIN,
            around(65536.0, -32768.0, 32760.0, 1.0),
            8,
            "65536 ticks (16 bits)",
        ),
        (
            "count",
            PLAIN,
            around(65536.0, -32768.0, -32768.0, -5.0),
            1,
            "65536 ticks (16 bits)",
        ),
        (
            "count",
            PLAIN,
            around(1024.0, 0.0, 1021.0, 30.0),
            1,
            "1024 ticks (10 bits)",
        ),
        (
            "xi",
            PLAIN,
            around(4_294_967_296.0, 0.0, -19.0, 1.0),
            19,
            "4294967296 ticks (32 bits)",
        ),
        // With twice the speed beside it, and after a motion the other way.
        (
            "count",
            PLAIN,
            vec![4020.0, 4040.0, 4060.0, 4080.0, 44.0, 64.0, 84.0],
            4,
            "4096 ticks (12 bits)",
        ),
        (
            "count",
            PLAIN,
            [vec![4080.0; 5], vec![3990.0, 4.0], vec![94.0; 5]].concat(),
            6,
            "4096 ticks (12 bits)",
        ),
        (
            "count",
            ROTARY,
            around(8000.0, 0.0, 7998.0, 1.0),
            2,
            "one revolution",
        ),
        (
            "count",
            ROTARY,
            around(8192.0, 0.0, 8190.0, 1.0),
            2,
            "8192 ticks (13 bits)",
        ),
        (
            "x [deg]",
            ROTARY,
            around(360.0, 0.0, 359.5, 0.05),
            10,
            "one revolution",
        ),
        (
            "x [rad]",
            ROTARY,
            vec![3.13, 3.13, 3.13, -3.15, -3.15],
            3,
            "one revolution",
        ),
        (
            "x [rad]",
            ROTARY,
            around(std::f64::consts::TAU, -std::f64::consts::PI, 3.1, 0.01),
            5,
            "one revolution",
        ),
        (
            "count",
            GEARED,
            around(4000.0, 0.0, 3990.0, 3.0),
            4,
            "one revolution of the motor (4000 ticks)",
        ),
        (
            "x [deg]",
            GEARED,
            around(36.0, 0.0, 35.5, 0.05),
            10,
            "one revolution of the motor,",
        ),
        (
            "count",
            GEARED,
            around(40000.0, 0.0, 39990.0, 3.0),
            4,
            "one revolution (40000 ticks)",
        ),
        (
            "count",
            PULLED,
            around(4000.0, -2000.0, 1990.0, 3.0),
            4,
            "one revolution of the motor (4000 ticks)",
        ),
        (
            "x [mm]",
            PULLED,
            around(31.41593, 0.0, 31.3, 0.02),
            6,
            "one revolution of the motor,",
        ),
    ] {
        let text = column(name, numbers);
        for block in [0, 7, 40] {
            let (verdict, wrap) = found(&text, scene, block);
            let wrap = wrap.unwrap_or_else(|| panic!("{name} {period}"));
            let rows = format!("between rows {row} and {}, by about {period}", row + 1);
            assert!(wrap.says.contains(&rows), "{name}: {}", wrap.says);
            assert_ne!(verdict, Verdict::Holds, "{name}");
        }
    }
}

#[test]
fn what_is_added_to_a_position_in_units_is_in_its_unit() {
    let turn = std::f64::consts::TAU / 10.0;
    for (name, scene, numbers, says) in [
        (
            "x [rad]",
            GEARED,
            around(turn, 0.0, turn - 0.01, 0.001),
            "add one revolution of the motor (about 0.628319 in `x [rad]`) from row 11 on, or take off as much up to row 10",
        ),
        (
            "x [deg]",
            ROTARY,
            around(360.0, 0.0, 359.5, 0.05),
            "add one revolution (about 360 in `x [deg]`) from row 11 on",
        ),
    ] {
        let wrap = found(&column(name, numbers), scene, 0).1.unwrap();
        assert!(wrap.fix.contains(says), "{}", wrap.fix);
    }
}

#[test]
fn a_wrap_leaves_open_what_would_hold() {
    // The force takes out at the counter's end what the jump gives as friction.
    let (up, down) = ("4095,0\n", "0,0\n");
    let text = format!("count,f\n{}{}", up.repeat(9), down.repeat(9));
    let (verdict, wrap) = found(&text, PLAIN, 0);
    assert_eq!(verdict, Verdict::Depends);
    let wrap = wrap.unwrap();
    assert!(
        wrap.says.contains("from 4095 to 0 between rows 9 and 10"),
        "{}",
        wrap.says
    );
    assert!(
        wrap.fix.contains(
            "in the log, so that it is 0 where the wall begins: add 4096 ticks (12 bits) from row 10 on"
        ),
        "{}",
        wrap.fix
    );
    let scene = Scene::from_toml("s", PLAIN).unwrap();
    let audit = audit_csv(
        Box::new(std::io::Cursor::new(text)),
        &scene,
        Options::default(),
    );
    let said = audit.unwrap().to_text();
    assert!(said.contains("DEPENDS: a finding leaves open"), "{said}");
    // The same jump of a device on its way is one.
    let text = format!(
        "count,f\n{}3000,0\n1500,0\n{}",
        up.repeat(9),
        down.repeat(9)
    );
    assert_eq!(found(&text, PLAIN, 0), (Verdict::Holds, None));
}

#[test]
fn a_device_at_rest_where_its_counter_wraps_jumps_to_and_fro() {
    let rest = [
        4095.0, 4095.0, 0.0, 4095.0, 0.0, 0.0, 4095.0, 4095.0, 4095.0,
    ];
    for block in [0, 7, 40] {
        let wrap = found(&column("count", rest), PLAIN, block).1.unwrap();
        assert!(
            wrap.says.contains("between rows 2 and 3") && wrap.says.contains("3 times more"),
            "{}",
            wrap.says
        );
    }
    // It may be all that there is on one side.
    let wrap = found(&column("count", [0.0, 4095.0, 4096.0]), PLAIN, 0)
        .1
        .unwrap();
    assert!(wrap.fix.contains("take off 4096 ticks"), "{}", wrap.fix);
    assert!(
        found(&column("count", [1.0, 0.0, 4095.0]), PLAIN, 0)
            .1
            .is_some()
    );
    assert!(found(&column("count", [0.0, 4095.0]), PLAIN, 0).1.is_none());
}

#[test]
fn motions_are_no_wraps() {
    let speeds_up = (0..40).map(|i| f64::from(i * i * i));
    let at_one_speed = (0..40).map(|i| f64::from(i) * 4096.0);
    let starts = [0.0, 0.0, 100.0, 4196.0, 8292.0];
    let elsewhere = [0.0, 1.0, 2.0, 3000.0, 3001.0];
    let short = [511.0, 511.0, 0.0, 0.0, 0.0];
    for numbers in [
        speeds_up.collect::<Vec<_>>(),
        at_one_speed.collect(),
        starts.to_vec(),
        elsewhere.to_vec(),
        short.to_vec(),
    ] {
        assert_eq!(
            found(&column("count", numbers.clone()), PLAIN, 0).1,
            None,
            "{numbers:?}"
        );
    }
    // A sample that comes late may be far away.
    for (late, is_wrap) in [("6", true), ("604", false)] {
        let text = format!("tau,count\n1,0\n2,2\n3,4\n4,7\n5,8\n{late},4104\n{late}.5,4105\n");
        let wrap = found(&text, PLAIN, 0).1;
        assert_eq!(wrap.is_some(), is_wrap, "{wrap:?}");
    }
}

#[test]
fn a_wrap_is_32_times_as_fast_as_what_is_beside_it() {
    for (step, is_wrap) in [(124.0, true), (125.0, false), (200.0, false)] {
        let numbers = around(4096.0, 0.0, 3500.0, step);
        let wrap = found(&column("count", numbers), PLAIN, 0).1;
        assert_eq!(wrap.is_some(), is_wrap, "{step}: {wrap:?}");
    }
}

#[test]
fn samples_for_an_identification_do_not_wrap_around() {
    let scene = Scene::from_toml("s", ROTARY).unwrap();
    let told = Dialect::default();
    for (period, is_refused) in [(65536.0, true), (1e9, false)] {
        let counts = around(period, 0.0, 65530.0, 1.0).into_iter();
        let rows = counts.map(|count| format!("{count},0.5\n"));
        let text: String = std::iter::once("count,f [N m]\n".to_owned())
            .chain(rows)
            .collect();
        let log = Scratch::new("csv", text.as_bytes());
        match samples(&log, &scene, &told) {
            Ok(all) => assert!(!is_refused && all.positions.len() == 20),
            Err(error) => {
                let error = error.to_string();
                let says = "the count jumps from 65535 to 0 between rows 6 and 7, by about 65536 ticks (16 bits)";
                assert!(is_refused && error.contains(says), "{error}");
                // There is no wall here.
                let fix = "unwrap the count in the log: add 65536 ticks (16 bits) from row 7 on";
                assert!(error.contains(fix) && !error.contains("wall"), "{error}");
            }
        }
    }
}
