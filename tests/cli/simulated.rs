//! What `passivity simulate` says of the device that it simulates, and how it and `sweep` draw.

use crate::harness::{Dir, words_off};
use crate::simulate::gliding;

/// Whose number has a tolerance, that is one device of many: which one is said.
#[test]
fn what_was_taken_at_a_nominal_value_is_said() {
    let dir = Dir::new();
    let scene = |viscous: &str, speed: &str| {
        format!(
            "[device]\ninertia = \"1e-4 kg m^2\"\nviscous = \"{viscous}\"\ncoulomb = \"0.8 … 1 mN m\"\n[sampling]\n\
             rate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 4096\n[wall]\nstiffness = \"1 N m/rad\"\n\
             [operator]\nmax_speed = \"60 rad/s ± 10%\"\n[start]\nvelocity = \"{speed}\"\n"
        )
    };
    let name = dir.write("knob.toml", scene("< 1e-3 N m s/rad", "60 rad/s ± 1"));
    let text = dir.run(&["simulate", &name]).stdout;
    for line in [
        "  nominal     device.viscous 0.001 N m s/rad, the bound of < 1e-3 N m s/rad\n",
        "              device.coulomb 0.9 mN m, of 0.8 … 1 mN m\n",
        "              start.velocity 60 rad/s, of 60 rad/s ± 1\n",
    ] {
        assert!(text.contains(line), "{text}");
    }
    let taken = |args: &[&str]| {
        let all = [&["simulate", &name, "--format", "json"], args].concat();
        let document = dir.run(&all).json();
        (
            document["nominal"].clone(),
            document["nominal_values"].clone(),
        )
    };
    let (keys, values) = taken(&[]);
    assert_eq!(
        keys,
        serde_json::json!(["device.coulomb", "device.viscous", "start.velocity"])
    );
    let expected =
        serde_json::json!({"device.coulomb": 9e-4, "device.viscous": 1e-3, "start.velocity": 60.0});
    assert_eq!(values, expected);
    // What is in another form is that which the motion has.
    let of_rate = scene("1e-5 N m s/rad", "1 rad/s").replace("1 kHz", "1 kHz ± 5%");
    let of_rate = dir.write("rate.toml", of_rate);
    let document = dir.run(&["simulate", &of_rate, "--format", "json"]).json();
    assert_eq!(document["nominal"][1], "sampling.rate");
    assert_eq!(document["nominal_values"]["sampling.period"], 1e-3);
    // A speed that was typed is no number of the scene.
    let (keys, _) = taken(&["--speed", "5"]);
    assert_eq!(
        keys,
        serde_json::json!(["device.coulomb", "device.viscous"])
    );
    let explained = dir.run(&["explain", &name]).stdout;
    let line = "  at device.viscous 0.001 N m s/rad, the bound of < 1e-3 N m s/rad\n";
    assert!(explained.contains(line), "{explained}");
    // Without tolerances nothing is said.
    let name = dir.write(
        "knob.toml",
        scene("1e-3 N m s/rad", "60 rad/s").replace("0.8 … 1", "1"),
    );
    assert!(!dir.run(&["simulate", &name]).stdout.contains("nominal"));
}

/// Without an encoder KΔ is the force of a wall that is pushed in by a metre, 7000 N here: a force that is never there is
/// drawn about one newton either side.
#[test]
fn a_force_of_zero_has_an_axis_of_the_scenes_own_unit() {
    let dir = Dir::new();
    let scene = "[device]\nmass = \"75 g\"\ncoulomb = \"0.04 N\"\n[sampling]\nrate = \"1 kHz\"\n[wall]\n\
                 stiffness = \"7 N/mm\"\nunilateral = true\n[start]\nposition = \"-5 mm\"\nvelocity = \"-40 mm/s\"\n";
    let name = dir.write("away.toml", scene);
    let run = dir.run(&[
        "simulate",
        &name,
        "--intervals",
        "20",
        "--plot",
        "motion.svg",
    ]);
    assert!(run.code < 2, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("motion.svg")).expect("a picture");
    assert!(svg.contains(">0.5<") && !svg.contains(">5000<"), "{svg}");
}

#[test]
fn a_long_title_fits_and_ends_with_the_outcome() {
    let dir = Dir::new();
    let scene = std::fs::read_to_string(dir.path(&gliding(&dir))).expect("a scene");
    let name = format!("{}.toml", "long ".repeat(40).trim_end());
    let name = dir.write(&name, scene);
    for (args, end) in [
        (&["simulate"][..], "long: at rest"),
        (&["accuracy"], "long: error and time, "),
    ] {
        let run = dir.run(&[args, &[&name, "--plot", "picture.svg"]].concat());
        assert_eq!(run.code, 0, "{}", run.stderr);
        let svg = std::fs::read_to_string(dir.path("picture.svg")).expect("a picture");
        assert!(svg.contains("long long ") && svg.contains('…'), "{svg}");
        assert!(svg.contains(end), "{svg}");
        assert!(
            words_off(&svg).iter().all(|words| !words.contains("long")),
            "{svg}"
        );
    }
}

#[test]
fn a_picture_of_one_map_has_room_for_what_its_lines_mean() {
    let dir = Dir::new();
    let arm = dir.write("arm.toml", crate::sweep::ARM);
    let vary = ["stiffness=500:3500:4 N/m", "rate=1/2,1 kHz"];
    let args = [
        "sweep", &arm, "--vary", vary[0], "--vary", vary[1], "--plot", "grid.svg",
    ];
    let run = dir.run(&[&args[..], &["--out", "grid.csv"]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("grid.svg")).expect("a picture");
    assert!(svg.contains("border: passive at every speed"), "{svg}");
    assert!(
        svg.contains("border: passive up to operator.max_speed"),
        "{svg}"
    );
    assert_eq!(words_off(&svg), [""; 0]);
}
