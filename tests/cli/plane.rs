//! `passivity plane`.

use crate::harness::Dir;

fn scenes(dir: &Dir) -> [String; 2] {
    let scene = |beta: &str, sigma: &str| {
        format!(
            "[dimensionless]\nmu = \"50\"\nbeta = \"{beta}\"\nsigma = \"{sigma}\"\n[operator]\n\
             max_speed = \"5\"\n"
        )
    };
    [
        dir.write("good.toml", scene("3/5", "3/5")),
        dir.write("slow.toml", scene("2/5", "3/5")),
    ]
}

#[test]
fn writes_svg_and_png_with_every_scene_in_the_legend() {
    let dir = Dir::new();
    let [good, slow] = scenes(&dir);
    let run = dir.run(&["plane", &good, &slow, "--plot", "plane.svg"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    assert!(svg.starts_with("<svg"));
    for word in [
        "good",
        "slow",
        "globally stable",
        "limit cycles",
        "critical line at 5 ticks/sample",
    ] {
        assert!(svg.contains(word), "{word}");
    }
    let run = dir.run(&["plane", &good, "--plot", "plane.png", "--format", "json"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(run.json()["scenes"][0]["beta"].as_f64(), Some(0.6));
    let png = std::fs::read(dir.path("plane.png")).expect("a picture");
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n") && png.len() > 10_000);
}

#[test]
fn says_what_it_cannot_draw_or_write() {
    let dir = Dir::new();
    let [good, _] = scenes(&dir);
    let run = dir.run(&["plane", &good, "--plot", "plane.bmp"]);
    assert_eq!(run.code, 2);
    assert!(
        run.stderr
            .contains("expected a name that ends in .svg or .png"),
        "{}",
        run.stderr
    );
    let run = dir.run(&["plane", &good, "--plot", "no/such/folder/plane.svg"]);
    assert_eq!(run.code, 2);
    assert!(
        run.stderr.contains("no/such/folder/plane.svg"),
        "{}",
        run.stderr
    );
}

#[test]
fn a_scene_that_is_not_passive_does_not_stand_in_the_green() {
    let dir = Dir::new();
    let scene = "[dimensionless]\nbeta = \"3/5 ± 10%\"\nsigma = \"3/5\"\n[sampling]\ndelay = 1\n\
                 [wall]\ndamping = \"1/10\"\n";
    let late = dir.write("late.toml", scene);
    let run = dir.run(&["plane", &late, "--plot", "plane.svg", "--format", "json"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let placed = &run.json()["scenes"][0];
    assert_eq!(placed["verdict"], "not_passive");
    let ends = |key: &str| [0, 1].map(|end| placed[key][end].as_f64().expect("a number"));
    // λ = ½ + 1 − B of β (TH-LTI) and ½ + B of σ are spent, the first ½ of each by the wall itself.
    let [least, most] = ends("beta_less_cost");
    assert!((least - (0.54 - 0.9)).abs() < 1e-15 && (most - (0.66 - 0.9)).abs() < 1e-15);
    assert_eq!(ends("sigma_less_cost"), [0.5, 0.5]);
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    assert!(svg.contains("less what further effects cost"));
}

const ARM: &str = "[device]\nviscous = \"0.5 N s/m ± 10%\"\ncoulomb = \"0.04 N\"\n[sampling]\n\
                   rate = \"1 kHz\"\n[encoder]\nresolution = \"0.03 mm\"\n[wall]\n\
                   stiffness = \"0.4 N/mm ± 5%\"\n[operator]\nmax_speed = \"40 mm/s\"\n";

#[test]
fn a_plane_of_two_parameters_has_its_borders_as_data() {
    let dir = Dir::new();
    let arm = dir.write("arm.toml", ARM);
    let args = [
        "plane",
        &arm,
        "--axes",
        "stiffness,damping",
        "--out",
        "border.csv",
        "--plot",
        "plane.svg",
    ];
    let run = dir.run(&args);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(
        run.stdout,
        "1 scene drawn in plane.svg\n2 borders written to border.csv\n\
         borders: solved exactly; every point passes when it is typed into the scene\n"
    );
    let table = std::fs::read_to_string(dir.path("border.csv")).expect("a table");
    let mut lines = table.lines();
    assert_eq!(
        lines.next(),
        Some("scenes,speeds,line,\"stiffness [N/mm]\",\"damping [N s/m]\"")
    );
    // At the least b = 0.45 N s/m: K ≤ 0.9 N/mm at every speed without damping.
    assert_eq!(lines.next(), Some("\"arm\",every_speed,1,0.9,0.0"));
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    for word in [
        "stiffness K (N/mm)",
        "virtual damping B (N s/m)",
        "passive at every speed",
        "passive up to 40 mm/s",
        "1: arm",
        "0.38 … 0.42 N/mm, 0 N s/m",
        "its tolerances",
    ] {
        assert!(svg.contains(word), "{word}");
    }
    let run = dir.run(&[
        "plane",
        &arm,
        "--axes",
        "stiffness,rate [Hz]",
        "--log",
        "both",
        "--format",
        "json",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let document = run.json();
    assert_eq!(document["axes"][1]["parameter"], "sampling.rate");
    assert_eq!(document["axes"][1]["unit"], "Hz");
    assert_eq!(document["axes"][1]["log"], true);
    assert_eq!(document["scenes"][0]["x"], serde_json::json!([0.38, 0.42]));
    assert_eq!(document["borders"][1]["speeds"], "up_to_max_speed");
    assert_eq!(document["borders"][1]["found_by"], "formula");
    assert!(
        document["borders"][1]["lines"][0]
            .as_array()
            .is_some_and(|line| line.len() > 2)
    );
}

#[test]
fn a_scene_without_tolerances_has_none_in_the_key() {
    let dir = Dir::new();
    let rig = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/re35.toml");
    // In degrees the stiffness has a π in it, and is known between two numbers only.
    let axes = "stiffness [mN m/deg],rate [kHz]";
    let rig = rig.to_str().expect("UTF-8");
    let run = dir.run(&[
        "plane",
        rig,
        "--axes",
        axes,
        "--log",
        "both",
        "--plot",
        "plane.svg",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    assert!(svg.contains("1: re35") && !svg.contains("its tolerances"));
}

#[test]
fn thirteen_scenes_are_all_in_the_key_and_share_borders_where_they_can() {
    let dir = Dir::new();
    let mut args = vec!["plane".to_owned()];
    for i in 1..=13 {
        let stiffness = format!("0.{i:02} N/mm");
        let damped = if i > 10 {
            "damping = \"0.05 N s/m\"\n[operator]"
        } else {
            "[operator]"
        };
        let scene = ARM
            .replace("0.4 N/mm", &stiffness)
            .replace("[operator]", damped);
        args.push(dir.write(&format!("arm-{i}.toml"), scene));
    }
    args.extend(
        [
            "--axes",
            "stiffness,viscous",
            "--plot",
            "plane.svg",
            "--format",
            "json",
        ]
        .map(String::from),
    );
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let run = dir.run(&args);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let borders = run.json()["borders"].as_array().expect("a list").len();
    assert_eq!(borders, 4, "two families at two speeds");
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    for i in 1..=13 {
        assert!(svg.contains(&format!(">{i}: arm-{i}<")), "{i}");
    }
    assert!(svg.contains("short strokes: the side that is passive"));
    assert!(
        svg.contains(">1–10<") && svg.contains(">11–13<"),
        "borders have the numbers of their scenes"
    );
}

#[test]
fn measured_points_are_compared_with_the_criterion() {
    let dir = Dir::new();
    let arm = dir.write(
        "arm.toml",
        ARM.replace("[operator]\nmax_speed = \"40 mm/s\"\n", ""),
    );
    let bench = "stiffness [N/m],damping [N s/m],stable,note\n500,0.1,stable,\n1200,0,stable,ringing\n\
                 1500,0.1,unstable,\n500,0.05,unstable,loose screw\n";
    dir.write("bench.csv", bench);
    let args = [
        "plane",
        &arm,
        "--axes",
        "stiffness,damping",
        "--measured",
        "bench.csv",
        "--plot",
        "plane.svg",
    ];
    let run = dir.run(&args);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let expected = "4 points measured: 2 agree, at 1 the criterion is stricter, at 1 it is looser\n\
                    columns not read: note\n";
    assert!(run.stdout.ends_with(expected), "{}", run.stdout);
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    assert!(svg.contains("unstable where the criterion holds"));
    let mut json = args.to_vec();
    json.extend(["--format", "json"]);
    let document = dir.run(&json).json();
    assert_eq!(document["measured"]["points"][1]["prediction"], "stricter");
    assert_eq!(document["measured"]["points"][1]["x"].as_f64(), Some(1.2));
    // A mistake in the file has its place.
    dir.write(
        "bench.csv",
        bench.replace("1500,0.1,unstable", "1500,0.1,shaky"),
    );
    let run = dir.run(&args);
    assert_eq!(run.code, 2);
    assert!(
        run.stderr.contains(
            "`bench.csv`: line 4, column 3: expected `stable` or `unstable`, found `shaky`"
        ),
        "{}",
        run.stderr
    );
}

#[test]
fn what_has_no_plane_is_said() {
    let dir = Dir::new();
    let arm = dir.write("arm.toml", ARM);
    let motor = dir.write(
        "motor.toml",
        "[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"1 N m/rad\"\n",
    );
    for (args, expected) in [
        (
            &["--axes", "stiffness"][..],
            "--axes `stiffness`: expected two parameters, as in stiffness,damping",
        ),
        (
            &["--axes", "stiffness,dampng"],
            "--axes `dampng`: expected a parameter: one of stiffness, period, rate",
        ),
        (
            &["--axes", "stiffness,inertia"],
            "`inertia` has no part in the criterion, so no border depends on it: expected one of stiffness, ",
        ),
        (
            &["--axes", "stiffness,mu"],
            "`mu` has no part in the criterion, so no border depends on it: expected one of stiffness, ",
        ),
        (
            &["--axes", "stiffness,damping [N]"],
            "the unit is that of a force",
        ),
        (
            &["--axes", "stiffness,damping", "--x", "1"],
            "--x `1`: expected FROM:TO, as in 0:2.5",
        ),
        (
            &["--axes", "stiffness,damping", "--x", "3:1"],
            "expected two numbers, the lower first",
        ),
        (
            &["--x", "0:1"],
            "--x is for a plane of parameters: name them with --axes",
        ),
        (
            &["--axes", "stiffness,damping", "--measured", "no.csv"],
            "`no.csv`: there is no such file",
        ),
        (
            &["--axes", "stiffness,damping", "--out", "no/such/border.csv"],
            "no/such/border.csv",
        ),
    ] {
        let mut all = vec!["plane", &arm, "--plot", "plane.svg"];
        all.extend(args);
        let run = dir.run(&all);
        assert_eq!(run.code, 2, "{args:?}");
        assert!(run.stderr.contains(expected), "{args:?}: {}", run.stderr);
    }
    let run = dir.run(&["plane", &arm, "--axes", "stiffness,damping"]);
    assert!(
        run.stderr.contains("give --plot, --out or --format json"),
        "{}",
        run.stderr
    );
    let run = dir.run(&[
        "plane",
        &arm,
        &motor,
        "--axes",
        "stiffness,damping",
        "--plot",
        "plane.svg",
    ]);
    assert!(
        run.stderr.contains("`arm` is linear and `motor` is rotary"),
        "{}",
        run.stderr
    );
}

#[test]
fn a_way_that_leaves_the_frame_has_no_head_and_no_name_on_it() {
    let dir = Dir::new();
    let scene = dir.write(
        "far.toml",
        "[dimensionless]\nmu = \"6\"\nbeta = \"0.009\"\nsigma = \"2.6\"\n",
    );
    let run = dir.run(&["plane", &scene, "--plot", "far.svg"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("far.svg")).expect("a picture");
    assert!(!svg.contains("<polygon fill=\"#0072b2\""), "{svg}");
    // β = 0.009 of 1.25 is 4 pixels from the left of the frame at 96.
    let name = svg.lines().find(|line| line.contains(">locally stable<"));
    let x = name.and_then(|line| line.split("x=\"").nth(1)?.split('"').next());
    let x = x.and_then(|x| x.parse::<f64>().ok()).expect("a place");
    assert!(x > 200.0, "{x}");
}

/// Of friction of which bounds are given, 0 … 0.1 and from 1.2 on, the mark is the device that `check` decides: without viscous
/// friction and with the least Coulomb friction. Its speed is 40 mm/s, 4/3 ticks per sample.
#[test]
fn a_scene_with_tolerances_stands_at_their_hardest_end() {
    let dir = Dir::new();
    let arm = format!("{}/../../scenes/desk/arm.toml", env!("CARGO_MANIFEST_DIR"));
    let run = dir.run(&["plane", &arm, "--plot", "plane.svg", "--format", "json"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let placed = &run.json()["scenes"][0];
    let numbers = ["beta", "sigma", "speed"].map(|key| placed[key].as_f64());
    assert_eq!(numbers, [Some(0.0), Some(1.2), Some(4.0 / 3.0)]);
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    for words in [
        "(0, 1.2): passive",
        "at the hardest end of its tolerances",
        "critical line at 1.3333 ticks/sample",
    ] {
        assert!(svg.contains(&format!(">{words}<")), "{words}");
    }
    // The axis of σ ends at 1.25 times 1.2, not at a multiple of the thousandfold that an open bound is taken for.
    assert!(svg.contains(">1.4<") && !svg.contains(">1000<"), "{svg}");
    // Of a period with a tolerance the line is at the speed of the same device, and is not cut short.
    let text = std::fs::read_to_string(&arm).expect("a shipped scene");
    let slow = dir.write("slow.toml", text.replace("1 kHz", "1 kHz ± 5 %"));
    let run = dir.run(&["plane", &slow, "--plot", "plane.svg"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    // 4/3 over 0.95.
    assert!(
        svg.contains(">critical line at 1.4035 ticks/sample<"),
        "{svg}"
    );
}

/// In a plane of parameters too: at 0.036 N of 0 … 0.1 N and without viscous friction, on the lower edge.
#[test]
fn a_scene_with_tolerances_stands_at_their_hardest_end_on_any_axes() {
    let dir = Dir::new();
    let arm = format!("{}/../../scenes/desk/arm.toml", env!("CARGO_MANIFEST_DIR"));
    let args = [
        "plane",
        &arm,
        "--axes",
        "coulomb,viscous",
        "--x",
        "0:0.1",
        "--y",
        "0:0.2",
    ];
    let run = dir.run(&[&args[..], &["--log", "none", "--plot", "plane.svg"]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    // 96 and 0.36 of the 604 pixels of the frame.
    assert!(svg.contains("<circle cx=\"313.44\" cy=\"560.00\""), "{svg}");
}

#[test]
fn nine_critical_lines_are_told_apart() {
    let dir = Dir::new();
    let names: Vec<String> = (1..=9)
        .map(|i| {
            let scene = format!(
                "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n[operator]\nmax_speed = \"{i}\"\n"
            );
            dir.write(&format!("s{i}.toml"), scene)
        })
        .collect();
    let mut args = vec!["plane", "--plot", "plane.svg"];
    args.extend(names.iter().map(String::as_str));
    let run = dir.run(&args);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("plane.svg")).expect("a picture");
    // Each line is in the plane and in the key, all in colours or dashes of their own.
    let lines = svg
        .lines()
        .filter(|line| line.contains("stroke-width=\"2\" stroke-linejoin"));
    let mut looks: Vec<&str> = lines
        .filter_map(|line| line.split(" points=").next())
        .collect();
    assert_eq!(looks.len(), 18, "{looks:?}");
    looks.sort_unstable();
    looks.dedup();
    assert_eq!(looks.len(), 9, "{looks:?}");
}
