//! `passivity case` on scenes that `identify --out` wrote: the sources that it says numbers have.

use super::identified::shipped;
use super::read;
use super::recorded::element;
use crate::harness::Dir;

/// What `identify --out` says of where numbers come from is said of those that it identified, in every form of a sketch.
#[test]
fn a_scene_that_was_identified_has_sources_for_friction_alone() {
    let dir = Dir::new();
    let push = shipped("push.csv");
    let inertia = "inertia = \"2e-5 kg m^2\"";
    let encoder = "encoder.counts_per_revolution = 8192\nwall.stiffness = \"0.05 N m/rad\"\n";
    let sections =
        "[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"0.05 N m/rad\"\n";
    let rate = "rate = \"1 kHz\"\n";
    for sketch in [
        format!("[device]\n{inertia}\n[sampling]\n{rate}{sections}"),
        format!(
            "#:schema scene.schema.json\ndevice = {{ {inertia} }}\nwall = {{ stiffness = \"0.05 N m/rad\" }}\n\
             [sampling]\n{rate}[encoder]\ncounts_per_revolution = 8192\n"
        ),
        format!("sampling.{rate}device.{inertia}\n{encoder}"),
        format!("device.{inertia}\nsampling.{rate}{encoder}"),
        format!(
            "device.viscous = \"1 N m s/rad\" # guess\ndevice.{inertia}\nsampling.{rate}{encoder}"
        ),
    ] {
        dir.write("sketch.toml", &sketch);
        // What was identified is a sketch again, and nothing of it is said twice.
        for (from, to) in [("sketch.toml", "first.toml"), ("first.toml", "scene.toml")] {
            let words = [
                "--effort",
                "1",
                "--device",
                "knob 3",
                "--date",
                "2026-11-20",
            ];
            let run = dir.run(
                &[
                    &["identify", &push, "--scene", from, "--out", to][..],
                    &words,
                ]
                .concat(),
            );
            assert_eq!(run.code, 0, "{sketch}: {}", run.stderr);
        }
        let written = read(&dir, "scene.toml");
        // Of both frictions, and of each.
        for (says, count) in [
            ("# Device: knob 3\n# Recorded: 2026-11-20\n# Log: ", 2),
            (
                "sha256 133c77d24f7fc6510f46a6604313b140ab401caacc401f771673f3221e32b97f\n",
                2,
            ),
            ("# Best estimate of viscous friction: ", 1),
            ("# Best estimate of Coulomb friction: ", 1),
        ] {
            assert_eq!(written.matches(says).count(), count, "{says}: {written}");
        }
        let run = dir.run(&["case", "scene.toml", "--out", "case"]);
        assert!(run.stdout.contains("top goal open"), "{}", run.stdout);
        let open = element(&dir, "G-sources");
        for key in [
            "device.inertia",
            "sampling.rate",
            "encoder.counts_per_revolution",
            "wall.stiffness",
        ] {
            assert!(open.contains(key), "{key}: {open}: {written}");
        }
        assert!(
            !open.contains("device.viscous") && !open.contains("coulomb"),
            "{open}: {written}"
        );
        // The head stays that of all.
        let headed = sketch.replace("#:schema scene.schema.json\n", "");
        let headed = format!("# Measured.\n{headed}").replace(" }\nwall", " } # drawing\nwall");
        dir.write("sketch.toml", &headed);
        let run = dir.run(&[
            "identify",
            &push,
            "--scene",
            "sketch.toml",
            "--effort",
            "1",
            "--out",
            "scene.toml",
        ]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        let run = dir.run(&["case", "scene.toml", "--out", "case"]);
        assert!(!run.stdout.contains("top goal open"), "{}", run.stdout);
        let kept = read(&dir, "scene.toml");
        assert!(kept.starts_with("# Measured.\n"), "{kept}");
        assert_eq!(
            kept.matches("# drawing\n").count(),
            headed.matches("# drawing\n").count()
        );
        assert!(!read(&dir, "case/scene.gsn.yaml").contains("G-sources"));
    }
}

/// Each number has the comment of the logs that it is from, and what somebody wrote beside it stays.
#[test]
fn a_later_identification_replaces_its_own_comments_alone() {
    let dir = Dir::new();
    let [push, back, ramp] = ["push.csv", "push-back.csv", "ramp.csv"].map(shipped);
    let identify = |logs: &[&str], from: &str, to: &str, device: &str| {
        let words = ["identify", "--scene", from, "--out", to];
        let more = ["--device", device, "--date", "2026-11-20", "--effort", "1"];
        let run = dir.run(&[&words[..], logs, &more].concat());
        assert_eq!(run.code, 0, "{}", run.stderr);
        read(&dir, to)
    };
    let sketch = shipped("sketch.toml");
    let first = identify(&[&push, &back], &sketch, "first.toml", "rig 1");
    let start = first.find("# Identified by").expect("a comment");
    let end = first.find("viscous = ").expect("a key");
    let mark = &first[start..end];
    for says in [
        "# Device: rig 1\n# Recorded: 2026-11-20\n# Log: ",
        "push-back.csv, sha256 ",
    ] {
        assert!(mark.contains(says), "{first}");
    }
    // As where the inertia was identified too.
    let inertia = format!("{}inertia = ", mark.replace("viscous friction", "inertia"));
    let anna = "# Anna has looked at it.\n# Device: it has a new belt.\nviscous = ";
    let first = first
        .replace("viscous = ", anna)
        .replace(
            "# Recorded: 2026-11-20\n",
            "# Recorded: 2026-11-20\n# In the morning.\n",
        )
        .replace("inertia = ", &inertia);
    dir.write("first.toml", &first);
    let second = identify(&[&ramp], "first.toml", "second.toml", "rig 2");
    assert!(second.contains(&inertia), "{second}");
    for (says, count) in [
        ("# Device: rig 1\n", 1),
        ("# Device: rig 2\n", 2),
        ("# In the morning.\n", 2),
        (anna, 1),
        ("ramp.csv, sha256 ", 2),
    ] {
        assert_eq!(second.matches(says).count(), count, "{says}: {second}");
    }
    // They stand where they stood, and again nothing is said twice.
    let third = identify(&[&ramp], "second.toml", "third.toml", "rig 2");
    assert_eq!(third, second);
}

/// What `identify` wrote is the source, whatever the device is called; what somebody says beside it counts.
#[test]
fn the_name_of_a_device_is_not_a_word_that_says_that_something_is_to_be_done() {
    let dir = Dir::new();
    let (push, sketch) = (shipped("push.csv"), shipped("sketch.toml"));
    let words = ["identify", &push, "--scene", &sketch, "--out", "scene.toml"];
    let device = ["--device", "rig XXX-7", "--effort", "1"];
    let run = dir.run(&[&words[..], &device].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let written = read(&dir, "scene.toml");
    for (said, is_open) in [
        ("", false),
        ("# Cold.\n", false),
        ("# TODO: again, warm\n", true),
    ] {
        dir.write(
            "scene.toml",
            written.replace("viscous = ", &format!("{said}viscous = ")),
        );
        dir.run(&["case", "scene.toml", "--out", "case"]);
        let yaml = read(&dir, "case/scene.gsn.yaml");
        assert_eq!(yaml.contains("G-sources"), is_open, "{said}");
        let html = read(&dir, "case/case.html");
        assert_eq!(
            html.matches("Device: rig XXX-7").count(),
            2 - usize::from(is_open)
        );
    }
}

/// What stands behind a number may be of the one that `identify` replaced: the logs are said before it.
#[test]
fn a_comment_behind_an_identified_number_does_not_hide_where_it_is_from() {
    let dir = Dir::new();
    let push = shipped("push.csv");
    let sketch = read(&dir, &shipped("sketch.toml"));
    let before = "[device]\nviscous = \"1e-5 N m s/rad\" # bench of 2019\n";
    dir.write("sketch.toml", sketch.replace("[device]\n", before));
    let words = ["identify", &push, "--scene", "sketch.toml", "--effort", "1"];
    let run = dir.run(&[&words[..], &["--out", "scene.toml"]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(read(&dir, "scene.toml").contains(" # bench of 2019\n"));
    dir.run(&["case", "scene.toml", "--out", "case"]);
    let source = element(&dir, "Sn-device.viscous");
    assert!(source.contains("Identified by"), "{source}");
    let page = read(&dir, "case/case.html");
    let row = page.split("bench of 2019").next().expect("a text");
    let own = row.rsplit("device.viscous").next().expect("the row");
    assert!(own.contains("sha256 133c77d24f7f"), "{own}");
}

/// What a shell hands over is read once: the case keeps what was checked.
#[cfg(unix)]
#[test]
fn a_scene_that_a_shell_hands_over_is_kept_as_it_was_read() {
    let dir = Dir::new();
    let scene = shipped("sketch.toml");
    let program = env!("CARGO_BIN_EXE_passivity");
    let line = format!("cat {scene} | {program} case /dev/stdin --out case");
    let status = std::process::Command::new("sh")
        .args(["-c", &line])
        .current_dir(dir.path("."))
        .output()
        .expect("a shell");
    assert!(status.stderr.is_empty(), "{status:?}");
    assert_eq!(read(&dir, "case/stdin.toml"), read(&dir, &scene));
}
