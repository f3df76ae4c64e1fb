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
