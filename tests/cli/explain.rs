//! `passivity explain`.

use crate::harness::{Dir, shipped};

#[test]
fn lists_just_the_effects_in_the_scene() {
    let dir = Dir::new();
    let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n";
    let name = dir.write("point.toml", scene);
    let run = dir.run(&["explain", &name]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(
        run.stdout.contains("(3/5 − 1/2) + (3/5 − 1/2)/v ≥ 0"),
        "{}",
        run.stdout
    );
    let (derivation, rest) = run
        .stdout
        .split_once("Not in this scene")
        .expect("a list of absent effects");
    assert!(rest.contains("virtual damping"));
    for word in ["damping", "delay", "amplifier", "sat("] {
        assert!(!derivation.contains(word), "{word}: {derivation}");
    }
}

#[test]
fn explains_every_shipped_scene_in_both_formats() {
    let dir = Dir::new();
    for path in shipped() {
        let name = path.to_str().expect("a UTF-8 path");
        let text = dir.run(&["explain", name]);
        assert_eq!(text.code, 0, "{name}: {}", text.stderr);
        assert!(text.stdout.contains("Derivation") && text.stdout.contains("Verdict"));
        let document = dir.run(&["explain", "--format", "json", name]).json();
        assert!(
            !document["derivation"].as_array().expect("lines").is_empty(),
            "{name}"
        );
        assert!(document["check"]["verdict"].is_string(), "{name}");
    }
}

/// The margin is the left side of (8), (β − ½) + (σ − ½)/V: 9e-3 − ½ + (…)/V at re35's bound of 3 rad/s.
#[test]
fn the_margin_is_the_left_side_of_the_criterion_that_is_printed() {
    let dir = Dir::new();
    let scene = shipped();
    let scene = scene.iter().find(|path| path.ends_with("re35.toml"));
    let scene = scene.and_then(|path| path.to_str()).expect("re35");
    let text = dir.run(&["explain", scene]).stdout;
    let number = |before: &str, after: &str| -> f64 {
        let (_, rest) = text
            .split_once(before)
            .unwrap_or_else(|| panic!("{before}: {text}"));
        let (figure, _) = rest.split_once(after).expect(after);
        let (a, b) = figure.split_once('/').unwrap_or((figure, "1"));
        a.parse::<f64>().expect(figure) / b.parse::<f64>().expect(figure)
    };
    let (beta, sigma) = (
        number("              (", " − 1/2) + ("),
        number(" − 1/2) + (", " − 1/2)/v ≥ 0"),
    );
    let speed = number("  V = ", " ticks/sample");
    let margin = number("margin, the left side of (8), there ", "\n");
    let expected = beta - 0.5 + (sigma - 0.5) / speed;
    // Half a unit in the fifth digit of σ, and of V by (σ − ½)/V, which is less than one.
    assert!(
        (margin - expected).abs() < 1e-4 / speed,
        "{margin} {expected}"
    );
}

/// What `check` decides is the hardest device within the tolerances: at the critical speed of the desk's arm, 1.4, there is
/// (0 − ½) + (6/5 − ½)/1.4 = 0, and the tolerance of re35's viscous friction is one of 1/20 about ½.
#[test]
fn the_criterion_of_tolerances_is_that_of_their_ends() {
    let dir = Dir::new();
    for (file, beta, lines) in [
        (
            "desk/arm.toml",
            "β = (0 … 0.1)/(1000 · 0.001) = 0 … 0.1",
            "at the hardest end of the tolerances: (0 − 1/2) + (6/5 − 1/2)/v ≥ 0; at the easiest: \
             (1/10 − 1/2) + (1200 − 1/2)/v ≥ 0",
        ),
        (
            "tolerance-straddling.toml",
            "β = (8.1e-6 … 9.9e-6)/(0.018 · 0.001) = 0.45 … 0.55",
            "at the hardest end of the tolerances: (9/20 − 1/2) + (115.89 − 1/2)/v ≥ 0; at the \
             easiest: (11/20 − 1/2) + (173.84 − 1/2)/v ≥ 0",
        ),
    ] {
        let scene = format!("{}/../../scenes/{file}", env!("CARGO_MANIFEST_DIR"));
        let text = dir.run(&["explain", &scene]).stdout;
        let words: Vec<&str> = text.split_whitespace().collect();
        let text = words.join(" ");
        for expected in [beta, lines] {
            assert!(text.contains(expected), "{file}: {text}");
        }
    }
}

/// Where virtual damping is behind an encoder, a short period costs Coulomb friction BΔ/T and a long one viscous friction:
/// no end of the period is the harder one for both.
#[test]
fn terms_that_are_least_at_different_ends_are_said_each_for_itself() {
    let dir = Dir::new();
    let scene = "[device]\nviscous = \"4 N s/m\"\ncoulomb = \"2 N\"\n[sampling]\n\
                 period = \"0.5 … 1 s\"\n[encoder]\nresolution = \"1 m\"\n[wall]\n\
                 stiffness = \"1 N/m\"\ndamping = \"1 N s/m\"\n";
    let name = dir.write("both.toml", scene);
    let text = dir.run(&["explain", &name]).stdout;
    // c − KΔ/2 − BΔ/T is ½ at T = 1 and −½ at T = ½; (b − KT/2 − B)/(KT) is 5/2 at T = 1 and 11/2 at T = ½.
    assert!(text.contains("DEPENDS"), "{text}");
    let words: Vec<&str> = text.split_whitespace().collect();
    let says = "over the tolerances, each term for itself: (2.5 … 5.5) + (-0.5 … 0.5)/v ≥ 0";
    assert!(words.join(" ").contains(says), "{text}");
}

/// A force that changes within an interval may be moved against there and back: what is generated then, with no distance
/// from sample to sample, grows with the way that was gone. So an actuator is charged by the velocity at every instant
/// (TH-LAG, TH-LATENCY), and friction takes it so (23).
#[test]
fn an_actuator_is_charged_by_the_velocity_at_every_instant() {
    let dir = Dir::new();
    let plain = "[dimensionless]\nmu = \"50\"\nbeta = \"3\"\nsigma = \"3\"\n";
    for (more, generated, friction) in [
        ("", "E_g ≤ ½·d² + ½·|d|\n", "E_d ≥ β·d²/Δτ + σ·|d|\n"),
        (
            "[sampling]\nlatency = \"1/2\"\n",
            "ΣE_g ≤ Σ(κ·∫ξ̇²dτ + ½·∫|ξ̇|dτ) + the decrease of the extra storage\n",
            "E_d ≥ β·∫ξ̇²dτ + σ·∫|ξ̇|dτ\n",
        ),
        (
            "[amplifier]\ntime_constant = \"1/2\"\n[wall]\ndamping = \"1/4\"\n",
            "ΣE_g ≤ Σ((H(1)·κ + Σ|g_j|)·∫ξ̇²dτ + (½ + B)·∫|ξ̇|dτ) + the decrease of the extra storage\n",
            "E_d ≥ β·∫ξ̇²dτ + σ·∫|ξ̇|dτ\n",
        ),
    ] {
        let scene = dir.write("scene.toml", format!("{plain}{more}"));
        let run = dir.run(&["explain", &scene]);
        // Long lines are wrapped.
        let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        for line in [generated, friction] {
            assert!(
                words(&run.stdout).contains(&words(line)),
                "{more}{line}{}{}",
                run.stdout,
                run.stderr
            );
        }
    }
}
