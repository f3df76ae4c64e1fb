//! `passivity case --log`: what the forces of a log say of the wall.

use super::read;
use super::recorded::{SCENE, case, scene};
use crate::harness::Dir;

#[test]
fn a_force_within_the_tolerance_of_the_stiffness_is_that_of_the_scene() {
    let dir = Dir::new();
    // 1.1 times the law of the nominal stiffness.
    let log = "tau,xi,f [N]\n0,1/4,-0.00055\n1,5/4,-0.00165\n2,1/2,-0.00055\n3,1/2,-0.00055\n";
    let log = dir.write("run.csv", log);
    for (tolerance, outcome) in [
        (" ± 20%", "supports"),
        (" ± 5%", "contradicts"),
        ("", "contradicts"),
    ] {
        let text = format!(
            "# Measured.\n[device]\nviscous = \"0.8 N s/m\"\ncoulomb = \"0.8e-3 N\"\n[sampling]\n\
             period = \"1 s\"\n[encoder]\nresolution = \"1 mm\"\n[wall]\n\
             stiffness = \"1 N/m{tolerance}\"\n"
        );
        let path = dir.write("scene.toml", text);
        let run = case(&dir, &path, &["--log", &log]);
        let found = &scene(&run)["recorded"]["logs"][0];
        assert_eq!(found["evidence"]["outcome"], outcome, "{found}");
        assert_eq!(run.code, i32::from(outcome != "supports"));
    }
}

/// What is beside the multiple is not tolerated; of positions, which may be rounded, it leaves the case open.
#[test]
fn a_force_beside_the_law_is_no_support() {
    let dir = Dir::new();
    let text = "# Measured.\n[device]\nviscous = \"0.8 N s/m\"\ncoulomb = \"0.8e-3 N\"\n[sampling]\n\
                period = \"1 s\"\n[encoder]\nresolution = \"1 mm\"\n[wall]\nstiffness = \"1 N/m ± 20%\"\n";
    let path = dir.write("scene.toml", text);
    for (column, positions, outcome) in [
        ("count", ["0", "9", "6", "0"], "contradicts"),
        ("xi", ["1/4", "37/4", "25/4", "1/4"], "open"),
    ] {
        let forces = ["-0.00055", "-0.01000", "-0.00735", "-0.00100"];
        let mut log = format!("tau,{column},f [N]\n");
        for (i, (position, force)) in positions.iter().zip(forces).enumerate() {
            log.push_str(&format!("{i},{position},{force}\n"));
        }
        let log = dir.write("run.csv", log);
        let run = case(&dir, &path, &["--log", &log]);
        let evidence = &scene(&run)["recorded"]["logs"][0]["evidence"];
        assert_eq!(evidence["outcome"], outcome, "{evidence}");
        assert!(
            evidence["because"].to_string().contains("beside that"),
            "{evidence}"
        );
        assert_eq!(run.code, 1);
    }
}

#[test]
fn forces_that_tell_nothing_of_the_wall_are_no_support() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", SCENE);
    for (text, why) in [
        (
            "tau,xi,f\n0,1/4,0\n1,1/4,0\n2,1/4,0\n",
            "is zero in every row",
        ),
        // To the nearest whole number 0.5 is 1 as well.
        ("tau,xi,f\n0,1/4,-1\n1,1/4,-1\n2,1/4,-1\n", "too few digits"),
    ] {
        let log = dir.write("run.csv", text);
        let audit = dir.run(&["audit", &log, "--scene", &path, "--format", "json"]);
        let audit = audit.json();
        assert_eq!(audit["verdict"], "holds");
        assert_eq!(audit["force"]["rough"], true);
        let run = case(&dir, &path, &["--log", &log]);
        let answer = scene(&run);
        let evidence = answer["recorded"]["logs"][0]["evidence"].clone();
        assert_eq!(evidence["outcome"], "open", "{evidence}");
        assert!(
            evidence["because"].as_str().unwrap().contains(why),
            "{evidence}"
        );
        assert_eq!((run.code, answer["standing"].as_str()), (1, Some("open")));
        assert!(!read(&dir, "case/case.html").contains("the recorded force is that of"));
    }
}

/// Whatever the columns are: a device that never touches the wall, or that does not move, shows nothing of it.
#[test]
fn a_log_in_which_no_work_was_done_is_no_support() {
    let dir = Dir::new();
    let both_sides = "# Measured.\n[device]\nviscous = \"0.8 N s/m\"\ncoulomb = \"0.8e-3 N\"\n[sampling]\n\
                      period = \"1 s\"\n[encoder]\nresolution = \"1 mm\"\n[wall]\nstiffness = \"1 N/m\"\n";
    let one_side = format!("{both_sides}unilateral = true\n");
    for (scene_text, log, why) in [
        (
            one_side.as_str(),
            "count\n-50\n-52\n-50\n-47\n",
            Some("did no work"),
        ),
        (&one_side, "count\n-50\n-50\n", Some("did no work")),
        (&one_side, "x [mm]\n-3\n-2.5\n-4\n", Some("did no work")),
        (
            &one_side,
            "count,f [N]\n-50,0\n-52,0\n-50,0\n",
            Some("is zero in every row"),
        ),
        (both_sides, "count\n3\n3\n3\n", Some("did no work")),
        (
            both_sides,
            "count,f [N]\n3,-0.0035\n3,-0.0035\n",
            Some("did no work"),
        ),
        (both_sides, "x [mm]\n0.3\n0.3\n", Some("did no work")),
        (&one_side, "count\n-5\n-1\n2\n1\n", None),
        (both_sides, "count\n3\n2\n3\n", None),
    ] {
        let path = dir.write("scene.toml", scene_text);
        let log = dir.write("run.csv", log);
        let run = case(&dir, &path, &["--log", &log]);
        let answer = scene(&run);
        let evidence = &answer["recorded"]["logs"][0]["evidence"];
        let because = evidence["because"].as_str();
        assert_eq!(because.is_some(), why.is_some(), "{evidence}");
        assert!(
            because
                .unwrap_or_default()
                .contains(why.unwrap_or_default())
        );
        let standing = if why.is_some() { "open" } else { "shown" };
        assert_eq!(answer["standing"], standing, "{evidence}");
        assert_eq!(run.code, i32::from(why.is_some()));
    }
}

/// Velocities of four times the motion: the scene may have four times as many counts as the device.
#[test]
fn a_velocity_to_another_scale_leaves_the_case_open() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", SCENE);
    for (scale, outcome) in [(1, "supports"), (4, "open")] {
        let mut text = "tau,xi,v\n".to_owned();
        for i in 0..40 {
            text += &format!("{i},{i}/2,{}\n", f64::from(scale) / 2.0);
        }
        let log = dir.write("run.csv", &text);
        let run = case(&dir, &path, &["--log", &log]);
        let found = &scene(&run)["recorded"]["logs"][0];
        assert_eq!(found["evidence"]["outcome"], outcome, "{found}");
        assert_eq!(run.code, i32::from(outcome != "supports"));
    }
}
