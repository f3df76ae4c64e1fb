//! The shipped scenes: their exact parameters and their verdicts.

use std::path::{Path, PathBuf};

use num_bigint::BigInt;
use passivity_core::{BigRational, Exact, Interval, Scalar as _, pi};
use passivity_scene::check::{Verdict, check};
use passivity_scene::number::parse;
use passivity_scene::{Effect, Motion, Scene};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

fn scene(name: &str) -> Scene {
    Scene::read(folder().join(format!("{name}.toml"))).unwrap_or_else(|e| panic!("{e}"))
}

fn number(text: &str) -> BigRational {
    parse(text).unwrap()
}

/// n/d·π^−1, exactly.
fn over_pi(coefficient: &str) -> Exact {
    Exact::of(&number(coefficient)).over(pi::pi())
}

/// Whether an enclosure holds all numbers from `lo` to `hi` and hardly more: 10⁻⁵⁰ of their size.
fn encloses(found: &Interval<BigRational>, lo: &Exact, hi: &Exact) -> bool {
    let tight = Exact::of(&number("1e-50"));
    let [found_lo, found_hi] = [found.lo(), found.hi()].map(Exact::of);
    let slack = hi.clone() * tight;
    found_lo <= *lo
        && *hi <= found_hi
        && lo.clone() - found_lo < slack
        && found_hi - hi.clone() < slack
}

/// What a scene must give: β exactly, σ as a multiple of 1/π or exactly, region, verdict.
struct Expected {
    name: &'static str,
    mu: &'static str,
    beta: [&'static str; 2],
    sigma: [&'static str; 2],
    sigma_over_pi: bool,
    region: &'static str,
    verdict: Verdict,
}

const fn point(
    name: &'static str,
    mu: &'static str,
    beta: &'static str,
    sigma: &'static str,
    region: &'static str,
    verdict: Verdict,
) -> Expected {
    Expected {
        name,
        mu,
        beta: [beta, beta],
        sigma: [sigma, sigma],
        sigma_over_pi: true,
        region,
        verdict,
    }
}

/// σ = c·N/(2πK): for the RE35, (10⁻³·N/K)/π.
const EXPECTED: [Expected; 15] = [
    point(
        "re35",
        "6.28",
        "9/1000",
        "8.192",
        "locally_stable",
        Verdict::Passive,
    ),
    point(
        "re35-globally-stable",
        "12560/3",
        "3/5",
        "256/75",
        "globally_stable",
        Verdict::Passive,
    ),
    point(
        "re35-limit-cycles",
        "12560/3",
        "3/5",
        "64/75",
        "limit_cycles",
        Verdict::NotPassive,
    ),
    point(
        "re35-locally-stable",
        "6.28",
        "9/1000",
        "8.192",
        "locally_stable",
        Verdict::NotPassive,
    ),
    point(
        "re35-locally-stable-too-fast",
        "6.28",
        "9/1000",
        "8.192",
        "locally_stable",
        Verdict::NotPassive,
    ),
    point(
        "re35-unstable",
        "6.28",
        "9/1000",
        "1.024",
        "unstable",
        Verdict::NotPassive,
    ),
    Expected {
        sigma_over_pi: false,
        ..point(
            "phantom-premium",
            "75",
            "0",
            "4/3",
            "locally_stable",
            Verdict::Passive,
        )
    },
    Expected {
        sigma_over_pi: false,
        ..point(
            "dimensionless",
            "50",
            "3/5",
            "3/5",
            "globally_stable",
            Verdict::Passive,
        )
    },
    Expected {
        sigma_over_pi: false,
        ..point(
            "dimensionless-corner",
            "50",
            "1/2",
            "1/2",
            "globally_stable",
            Verdict::Passive,
        )
    },
    Expected {
        // b = 9e-6(1 ± 1/10), T = 1e-3(1 ± 1/50), c = 2e-3(1 ± 1/5).
        beta: ["45/68", "165/196"],
        sigma: ["8192/15", "4096/5"],
        ..point(
            "tolerances",
            "",
            "",
            "",
            "globally_stable",
            Verdict::Passive,
        )
    },
    Expected {
        beta: ["9/20", "11/20"],
        sigma: ["16384/45", "8192/15"],
        ..point(
            "tolerance-straddling",
            "3140/9",
            "",
            "",
            "depends",
            Verdict::Depends,
        )
    },
    point(
        "every-covered-effect",
        "15700",
        "9/4",
        "204.8",
        "globally_stable",
        Verdict::Passive,
    ),
    point(
        "amplifier-lag",
        "628",
        "9/10",
        "819.2",
        "globally_stable",
        Verdict::Passive,
    ),
    point(
        "filtered-damping",
        "3140",
        "9/2",
        "4096",
        "globally_stable",
        Verdict::Passive,
    ),
    Expected {
        sigma_over_pi: false,
        ..point(
            "digital-controller",
            "50",
            "5/4",
            "3/2",
            "globally_stable",
            Verdict::Passive,
        )
    },
];

#[test]
fn every_shipped_scene_has_its_exact_point_and_its_verdict() {
    for expected in &EXPECTED {
        let name = expected.name;
        let report = check(&scene(name));
        let [lo, hi] = expected.beta.map(number);
        assert_eq!(report.beta, Interval::new(lo, hi).unwrap(), "{name}: β");
        let sigma = report.sigma.clone().unwrap();
        if expected.sigma_over_pi {
            let [lo, hi] = expected.sigma.map(over_pi);
            assert!(encloses(&sigma, &lo, &hi), "{name}: σ");
        } else {
            let [lo, hi] = expected.sigma.map(number);
            assert_eq!(sigma, Interval::hull(lo, hi), "{name}: σ");
        }
        if !expected.mu.is_empty() {
            let mu = Interval::point(number(expected.mu));
            assert_eq!(report.mu, Some(mu), "{name}: μ");
        }
        let json = report.to_json();
        assert_eq!(json["region"], expected.region, "{name}");
        assert_eq!(report.verdict, expected.verdict, "{name}");
        assert_eq!(
            json["witness"].is_null(),
            report.verdict != Verdict::NotPassive,
            "{name}"
        );
    }
}

#[test]
fn no_shipped_scene_is_left_out() {
    let files = std::fs::read_dir(folder()).unwrap();
    let paths = files.map(|file| file.unwrap().path());
    let mut shipped: Vec<String> = paths
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    shipped.sort();
    let mut tested: Vec<&str> = EXPECTED.iter().map(|e| e.name).collect();
    tested.sort_unstable();
    assert_eq!(shipped, tested);
}

#[test]
fn the_table_of_scenes_names_each() {
    let table = std::fs::read_to_string(folder().join("README.md")).unwrap();
    for expected in &EXPECTED {
        let cell = format!("| `{}.toml` |", expected.name);
        let row = table.lines().find(|line| line.starts_with(&cell));
        let row = row.unwrap_or_else(|| panic!("no row {cell}"));
        let verdict = expected.verdict.name().replace('_', " ");
        let region = expected.region.replace('_', " ");
        assert!(row.ends_with(&format!("| {region} | {verdict} |")), "{row}");
    }
}

#[test]
fn the_papers_rig_is_exact_to_the_last_digit() {
    let scene = scene("re35");
    assert_eq!(scene.motion, Motion::Rotary);
    assert_eq!(scene.name, "re35");
    let inertia = &scene.given.inertia.as_ref().unwrap().nominal;
    assert_eq!(inertia.to_rational(), Some(number("6.28e-6")));
    let viscous = scene.given.viscous.as_ref().unwrap();
    assert_eq!(viscous.text, "9e-6 N m s/rad");
    let resolution = &scene.given.resolution.as_ref().unwrap().nominal;
    assert_eq!(*resolution, Exact::of(&number("1/4096")) * pi::pi());
    // (c − KΔ/2)/(KT/2 − b) = (2e-3 − π/8192)/4.91e-4, for π = 3.14159265358979323846…
    let critical = check(&scene).critical_speed_si.unwrap();
    let digits = BigRational::new(
        BigInt::from(314_159_265_358_979_i64),
        BigInt::from(10).pow(14),
    );
    let speed = (number("2e-3") - digits / number("8192")) / number("4.91e-4");
    // π is cut after 14 decimals, so the speed is off by less than 1e-14/(8192·4.91e-4).
    let tolerance = number("1e-14");
    assert!(&speed - critical.lo() < tolerance && critical.hi() - &speed < tolerance);
    assert!(speed > number("3.2922") && speed < number("3.2923"));
}

#[test]
fn the_effects_of_a_scene_are_its_keys() {
    let covered = scene("every-covered-effect");
    let left_out = [
        Effect::Latency,
        Effect::DampingFilter,
        Effect::Controller,
        Effect::Saturation,
        Effect::Amplifier,
        Effect::Arm,
    ];
    let expected: Vec<Effect> = Effect::ALL
        .into_iter()
        .filter(|effect| !left_out.contains(effect))
        .collect();
    assert_eq!(covered.effects(), expected);
    assert!(covered.not_covered().is_empty());
    assert_eq!(covered.given.delay, 1);
    assert_eq!(
        covered.given.operator_force.as_ref().unwrap().text,
        "1 mN m"
    );
    for has_forces in [false, true] {
        let found = scene("amplifier-lag").unaccounted(has_forces);
        assert_eq!(found, [Effect::Amplifier]);
    }
    let phantom = scene("phantom-premium");
    assert!(phantom.given.viscous.is_none() && phantom.given.unilateral);
    assert_eq!(phantom.motion, Motion::Linear);
    let dimensionless = scene("dimensionless");
    assert_eq!(dimensionless.motion, Motion::Dimensionless);
    assert_eq!(dimensionless.effects()[3], Effect::Encoder);
    assert_eq!(dimensionless.point().start()[1], number("10"));
}

#[test]
fn the_straddling_tolerance_is_named() {
    let report = check(&scene("tolerance-straddling"));
    assert_eq!(report.decided_by, ["device.viscous"]);
    assert!(check(&scene("tolerances")).decided_by.is_empty());
}

#[test]
fn the_same_scene_in_json_is_the_same_scene() {
    let value = serde_json::json!({
        "device": {"inertia": "6.28e-6 kg m^2", "viscous": "9e-6 N m s/rad", "coulomb": "2e-3 N m"},
        "sampling": {"period": "1 ms"},
        "encoder": {"counts_per_revolution": 8192},
        "wall": {"stiffness": "1 N m/rad"},
        "operator": {"max_speed": "3 rad/s"},
    });
    let from_json = Scene::from_json(&value).unwrap();
    assert_eq!(from_json.point(), scene("re35").point());
    assert_eq!(from_json.bounds(), scene("re35").bounds());
}
