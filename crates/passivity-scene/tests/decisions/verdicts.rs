//! The verdict and the limits of drawn scenes, against what is worked out by hand for each device.

mod examples;

use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::Path;
use std::time::Instant;

use passivity_core::BigRational;
use passivity_random::draws;
use passivity_scene::Scene;
use passivity_scene::check::{Report, Side, Verdict, check};
use passivity_scene::number::parse;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

fn number(text: &str) -> BigRational {
    parse(text).unwrap()
}

fn report(text: &str) -> Report {
    check(&Scene::from_toml("test", text).unwrap_or_else(|e| panic!("{e}")))
}

fn dimensionless(beta: &str, sigma: &str, more: &str) -> Report {
    report(&format!(
        "[dimensionless]\nmu = 1\nbeta = \"{beta}\"\nsigma = \"{sigma}\"\n{more}"
    ))
}

/// A scene in metres, newtons and seconds with a resolution and a stiffness of 1 unless given.
fn linear(parameters: &[(&str, &str)]) -> String {
    let sections = [
        ("device", vec![("viscous", "N s/m"), ("coulomb", "N")]),
        ("sampling", vec![("period", "s")]),
        ("encoder", vec![("resolution", "m")]),
        (
            "wall",
            vec![
                ("stiffness", "N/m"),
                ("damping", "N s/m"),
                ("force_step", "N"),
            ],
        ),
        ("operator", vec![("max_speed", "m/s")]),
    ];
    let mut text = String::new();
    for (section, keys) in sections {
        text += &format!("[{section}]\n");
        for (key, unit) in keys {
            let default = matches!(key, "resolution" | "stiffness" | "period").then_some("1");
            let given = parameters
                .iter()
                .find(|(k, _)| *k == key)
                .map(|(_, value)| *value);
            if let Some(value) = given.or(default) {
                text += &format!("{key} = \"{value} {unit}\"\n");
            }
        }
    }
    text.replace("[encoder]\n[", "[").replace(
        "[operator]\n",
        if text.contains("max_speed") {
            "[operator]\n"
        } else {
            ""
        },
    )
}

/// A number with few digits, and perhaps a tolerance.
fn quantity(least: u32, most: u32) -> impl Strategy<Value = String> {
    (least..most, prop::option::weighted(0.4, 0..40_u32)).prop_map(|(n, tolerance)| {
        let value = format!("{}.{:02}", n / 100, n % 100);
        match tolerance {
            Some(percent) => format!("{value} ± {percent}%"),
            None => value,
        }
    })
}

fn with_unit(value: &str, unit: &str) -> String {
    match value.split_once(" ±") {
        Some((value, tolerance)) => format!("{value} {unit} ±{tolerance}"),
        None => format!("{value} {unit}"),
    }
}

/// A scene with tolerances and effects, each parameter as text without its unit.
fn scenes() -> impl Strategy<Value = Vec<(&'static str, String)>> {
    let required = (
        quantity(1, 300),
        quantity(1, 300),
        quantity(1, 300),
        quantity(1, 300),
        quantity(1, 300),
    );
    let optional = (
        prop::option::of(quantity(1, 60)),
        prop::option::of(quantity(1, 60)),
        prop::option::of(quantity(1, 500)),
    );
    (required, optional).prop_map(|((b, c, t, d, k), (damping, step, speed))| {
        let mut all = vec![
            ("viscous", b),
            ("coulomb", c),
            ("period", t),
            ("resolution", d),
            ("stiffness", k),
        ];
        all.extend(damping.map(|x| ("damping", x)));
        all.extend(step.map(|x| ("force_step", x)));
        all.extend(speed.map(|x| ("max_speed", x)));
        all
    })
}

fn written(parameters: &[(&'static str, String)], delay: u16) -> String {
    let of = |section: &str, key: &str, unit: &str| {
        let found = parameters.iter().find(|(k, _)| *k == key);
        let value = found.map(|(_, value)| format!("{key} = \"{}\"\n", with_unit(value, unit)));
        (section.to_owned(), value.unwrap_or_default())
    };
    let lines = [
        of("device", "viscous", "N s/m"),
        of("device", "coulomb", "N"),
        of("sampling", "period", "s"),
        ("sampling".to_owned(), format!("delay = {delay}\n")),
        of("encoder", "resolution", "m"),
        of("wall", "stiffness", "N/m"),
        of("wall", "damping", "N s/m"),
        of("wall", "force_step", "N"),
        of("operator", "max_speed", "m/s"),
    ];
    let mut text = String::new();
    for section in ["device", "sampling", "encoder", "wall", "operator"] {
        text += &format!("[{section}]\n");
        let of_section = lines.iter().filter(|(home, _)| home == section);
        text.extend(of_section.map(|(_, line)| line.as_str()));
    }
    text
}

/// Runs a test on scenes that are drawn, and leaves a record where `PASSIVITY_EVIDENCE_DIR` says.
fn on_drawn_scenes<S: Strategy>(
    name: &str,
    cases: u32,
    inputs: S,
    test: impl Fn(S::Value) -> Result<(), TestCaseError>,
) where
    S::Value: Clone,
{
    let started = Instant::now();
    // `PROPTEST_CASES` draws fewer.
    let cases = draws(cases);
    let cases = cases.min(std::env::var("PROPTEST_CASES").map_or(cases, |n| n.parse().unwrap()));
    let mut runner = TestRunner::new(ProptestConfig {
        cases,
        failure_persistence: None,
        ..ProptestConfig::default()
    });
    runner.run(&inputs, test).unwrap_or_else(|e| panic!("{e}"));
    let Some(folder) = std::env::var_os("PASSIVITY_EVIDENCE_DIR") else {
        return;
    };
    let seconds = started.elapsed().as_secs_f64();
    let line = format!(
        "{{\"test\": \"verdicts::{name}\", \"cases\": {cases}, \"seconds\": {seconds:.3}}}\n"
    );
    let path = Path::new(&folder).join("properties.jsonl");
    let mut file = OpenOptions::new()
        .create(true)
        .append(true)
        .open(path)
        .unwrap();
    file.write_all(line.as_bytes()).unwrap();
}

/// Each printed limit, typed back, passes; a thousandth beyond it, the criterion does not hold for
/// all loops any more.
#[test]
fn check_limits_pass_when_typed_back() {
    let name = "check_limits_pass_when_typed_back";
    on_drawn_scenes(name, 60, (scenes(), 0..3_u16), |(parameters, delay)| {
        let first = report(&written(&parameters, delay));
        let speeds = |report: &Report| report.at_every_speed || !first.at_every_speed;
        for limit in &first.limits {
            let key = limit.parameter.row().key.rsplit('.').next().unwrap();
            let typed = |value: &str| {
                let mut changed = parameters.clone();
                for (k, old) in &mut changed {
                    if *k == key {
                        value.clone_into(old);
                    }
                }
                report(&written(&changed, delay))
            };
            let [near, beyond] = match limit.side {
                Side::AtLeast => ["0.999", "1.001"],
                Side::AtMost => ["1.001", "0.999"],
            };
            let far = limit.far.as_ref().and_then(|far| far.printed.as_ref());
            let ends = [(limit.printed.as_ref(), near), (far, beyond)];
            for (printed, factor) in ends {
                let Some(printed) = printed else { continue };
                let at = typed(printed);
                prop_assert!(
                    at.verdict == Verdict::Passive && speeds(&at),
                    "{key} = {printed}"
                );
                if number(printed) > number("0") {
                    let beyond = typed(&(number(printed) * number(factor)).to_string());
                    let holds = beyond.verdict == Verdict::Passive && speeds(&beyond);
                    prop_assert!(!holds, "{key}: {printed} times {factor}");
                }
            }
        }
        Ok(())
    });
}

/// λ of k samples of delay with damping B, in doubles: ½ + Σ cos jθ − B·cos (k + 1)θ, 1 ≤ j ≤ k, is a
/// polynomial in cos θ of degree k + 1 whose derivative is at most (k + 1)²(k + B), so that 10⁵ steps
/// of cos θ miss its maximum by no more than 10⁻⁵(k + 1)²(k + B), and by their squares near a maximum
/// inside.
fn lambda_by_hand(delay: u16, damping: f64) -> f64 {
    let at = |cosine: f64| {
        let cos = |j: u16| (f64::from(j) * cosine.acos()).cos();
        0.5 + (1..=delay).map(cos).sum::<f64>() - damping * cos(delay + 1)
    };
    let steps = (0..=100_000).map(|i| at(f64::from(i) / 50_000.0 - 1.0));
    steps.fold(f64::NEG_INFINITY, f64::max)
}

/// The same with a delay and damping together, in doubles; `None` within a ten-thousandth of the
/// border, which is more than λ is off by.
fn holds_together(parameters: &[(&str, BigRational)], delay: u16) -> Option<bool> {
    let given = |key: &str| {
        let found = parameters.iter().find(|(k, _)| *k == key);
        found.map(|(_, x)| num_traits::ToPrimitive::to_f64(x).unwrap())
    };
    let of = |key: &str| given(key).unwrap_or(0.0);
    let unit = of("stiffness") * of("period");
    let spent = unit * lambda_by_hand(delay, of("damping") / unit);
    let viscous = of("viscous") - spent;
    let held = of("stiffness") * of("resolution") + of("force_step");
    let damped = of("damping") * of("resolution") / of("period");
    let coulomb = of("coulomb") - held / 2.0 - damped;
    let at_end = match given("max_speed") {
        Some(speed) => [
            viscous * speed + coulomb,
            spent * speed + held / 2.0 + damped,
        ],
        None => [viscous, spent],
    };
    let margins = [[coulomb, held / 2.0 + damped], at_end];
    let clear = margins
        .iter()
        .all(|[margin, size]| margin.abs() > 1e-4 * size);
    clear.then(|| margins.iter().all(|[margin, _]| *margin >= 0.0))
}

/// The criterion (11) with the effects, written out from the theory, of a device without tolerances.
///
/// `None` where that is not exact and too near to the border.
fn holds_by_hand(parameters: &[(&str, BigRational)], delay: u16) -> Option<bool> {
    let given = |key: &str| {
        parameters
            .iter()
            .find(|(k, _)| *k == key)
            .map(|(_, x)| x.clone())
    };
    let of = |key: &str| given(key).unwrap_or_else(|| number("0"));
    if delay > 0 && of("damping") > number("0") {
        return holds_together(parameters, delay);
    }
    let (period, tick, stiffness) = (of("period"), of("resolution"), of("stiffness"));
    let late = number("1/2") + BigRational::from_integer(delay.into());
    let viscous = of("viscous") - &stiffness * &period * late - of("damping");
    let coulomb = of("coulomb")
        - (&stiffness * &tick + of("force_step")) * number("1/2")
        - of("damping") * tick / period;
    let zero = number("0");
    // A margin that is linear in the speed holds at all speeds if it does near rest and at the end.
    Some(match given("max_speed") {
        Some(speed) => coulomb >= zero && viscous * speed + coulomb >= zero,
        None => coulomb >= zero && viscous >= zero,
    })
}

/// What is said of a scene with tolerances is so of each device within them, at its corners too; and
/// of a device without tolerances exactly what the criterion, written out, says.
#[test]
fn check_verdict_is_that_of_every_device_within_the_tolerances() {
    let name = "check_verdict_is_that_of_every_device_within_the_tolerances";
    let places = prop::collection::vec(-2..=2_i64, 9);
    let inputs = (scenes(), 0..3_u16, places);
    on_drawn_scenes(name, 250, inputs, |(parameters, delay, places)| {
        let whole = report(&written(&parameters, delay));
        // Where in its tolerance each parameter is: at an end, half-way, in the middle.
        let pick = |text: &str, place: i64| match text.split_once(" ± ") {
            None => number(text),
            Some((value, tolerance)) => {
                let share = number(tolerance.trim_end_matches('%')) / number("100");
                let way = BigRational::new(place.into(), 2.into());
                number(value) * (number("1") + share * way)
            }
        };
        let with_places = parameters.iter().zip(&places);
        let point: Vec<_> = with_places.map(|((k, x), at)| (*k, pick(x, *at))).collect();
        let Some(holds) = holds_by_hand(&point, delay) else {
            return Ok(());
        };
        let texts: Vec<_> = point.iter().map(|(k, x)| (*k, x.to_string())).collect();
        let point = report(&written(&texts, delay));
        prop_assert_eq!(point.verdict == Verdict::Passive, holds);
        match whole.verdict {
            Verdict::Passive => prop_assert!(holds),
            Verdict::NotPassive | Verdict::NotGuaranteed => prop_assert!(!holds),
            Verdict::Depends => prop_assert!(!whole.decided_by.is_empty()),
            Verdict::NotCovered => prop_assert!(false, "all of it is covered"),
        }
        prop_assert_ne!(point.verdict, Verdict::Depends);
        if whole.region.is_some() {
            prop_assert_eq!(whole.region, point.region);
        }
        Ok(())
    });
}
