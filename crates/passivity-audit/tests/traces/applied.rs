//! Where a trace has forces, the account is of those forces, and what they are to the wall's law is
//! said beside it.

mod late;
mod told;

use std::fmt::Write as _;

use num_traits::{Signed as _, Zero as _};
use passivity_audit::{Audit, Judged, Options, Values, Verdict, audit_columns, audit_csv};
use passivity_core::BigRational;
use passivity_random::draws;
use passivity_scene::Scene;
use proptest::prelude::*;
use serde_json::Value;

fn scene(text: &str) -> Scene {
    Scene::from_toml("test", text).unwrap()
}

fn three_fifths() -> Scene {
    scene("[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"")
}

fn audited_as(csv: &str, scene: &Scene, law: bool, block: usize) -> (Audit, String) {
    let mut rows = Vec::new();
    let options = Options {
        rows: Some(&mut rows),
        law,
        threads: 2,
        block,
        ..Options::default()
    };
    let input = Box::new(std::io::Cursor::new(csv.to_owned()));
    let audit = audit_csv(input, scene, options).unwrap();
    assert_eq!(audit.error(), None, "{csv}");
    (audit, String::from_utf8(rows).unwrap())
}

fn audited(csv: &str, scene: &Scene) -> Audit {
    audited_as(csv, scene, false, 0).0
}

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn rational(value: &Value) -> BigRational {
    passivity_scene::json::read_rational(value).unwrap()
}

/// A hand that presses in, lets go, and comes back.
const PATH: [i64; 16] = [0, 1, 3, 6, 8, 9, 9, 8, 4, 0, -3, -7, -5, 0, 2, 3];

/// The force of the wall at a count, `lag` samples late and `scale` times.
fn law(path: &[i64], i: usize, lag: usize, scale: f64) -> f64 {
    -scale * (path[i.saturating_sub(lag)] as f64 + 0.5)
}

fn trace(column: &str, path: &[i64], force: impl Fn(usize) -> f64) -> String {
    let mut csv = format!("{column},f\n");
    for (i, n) in path.iter().enumerate() {
        writeln!(csv, "{n},{}", force(i)).unwrap();
    }
    csv
}

/// A fraction has no last digit within which it might be another number: the same forces, as fractions and as decimals,
/// have the same verdict.
#[test]
fn forces_as_fractions_are_exact() {
    let thousandths = [
        -3359_i64, -7606, -6476, -5382, -9275, -10_210, -12_557, -13_470,
    ];
    let counts = [3_i64, 7, 6, 5, 9, 10, 12, 13];
    let scene = scene("[dimensionless]\nbeta = \"0\"\nsigma = \"2/5\"");
    let mut texts = ["count,f\n"; 2].map(str::to_owned);
    for (count, force) in counts.iter().zip(thousandths) {
        let [fraction, decimal] = &mut texts;
        writeln!(fraction, "{count},{force}/1000").unwrap();
        writeln!(decimal, "{count},{}", force as f64 / 1000.0).unwrap();
    }
    let [fraction, decimal] = texts.map(|text| audited(&text, &scene));
    assert_eq!(fraction.to_json(), decimal.to_json());
    let force = fraction.report().force.as_ref().unwrap();
    assert_eq!((force.agrees, force.mismatches), (false, force.compared));
}

#[test]
fn a_doubled_reversed_or_late_force_does_not_hold_by_the_law() {
    let scene = three_fifths();
    for (lag, scale) in [(0, 2.0), (0, -1.0), (1, 1.0), (3, 1.0)] {
        let said = format!("{lag} late, {scale} times");
        let csv = |column| trace(column, &PATH, |i| law(&PATH, i, lag, scale));
        let exact = audited(&csv("xi"), &scene);
        assert_eq!(exact.verdict(), Verdict::Fails, "{said}");
        assert_eq!(exact.report().judged, Judged::Running);
        // The counts leave room for some of it, but nobody says that it holds.
        let counted = audited(&csv("count"), &scene);
        assert_ne!(counted.verdict(), Verdict::Holds, "{said}");
        // The law's own force, asked for, holds; what was found of the forces is the same.
        let (by_law, _) = audited_as(&csv("count"), &scene, true, 0);
        assert_eq!(by_law.verdict(), Verdict::Holds);
        assert_eq!(by_law.report().judged, Judged::Interval);
        let headline = by_law.report().headline();
        let says = "HOLDS for the wall's own law, which the forces in the trace are not: ";
        assert!(headline.starts_with(says), "{headline}");
        assert_eq!(by_law.report().force, counted.report().force);
        let found = counted.report().force.as_ref().unwrap();
        assert!(!found.agrees);
        let fit = found.fit.unwrap();
        assert_eq!((fit.delay, fit.scale), (lag, scale), "{said}");
        assert!(fit.residual < 1e-9);
    }
    // A long push against a wall that pushes the other way.
    let path: Vec<i64> = (0..100).collect();
    let reversed = trace("count", &path, |i| law(&path, i, 0, -1.0));
    assert_eq!(audited(&reversed, &scene).verdict(), Verdict::Fails);
    let text = audited(&reversed, &scene).to_text();
    assert!(
        text.contains("FAILS: the operator surely drew more than was stored at the start, by ")
    );
    assert!(
        text.contains("with the opposite sign and no delay it agrees"),
        "{text}"
    );
    let doubled = trace("count", &path, |i| law(&path, i, 0, 2.0));
    let text = audited(&doubled, &scene).to_text();
    assert!(
        text.contains("it is 2 times the law with no delay"),
        "{text}"
    );
}

/// Rows with their forces left out.
fn without_force(value: &Value) -> Value {
    match value {
        Value::Object(fields) => {
            let fields = fields.iter().filter(|(name, _)| *name != "force");
            let kept = fields.map(|(name, value)| (name.clone(), without_force(value)));
            Value::Object(kept.collect())
        }
        Value::Array(items) => items.iter().map(without_force).collect(),
        other => other.clone(),
    }
}

/// A column whose digits leave room for any force of the wall says nothing of it.
#[test]
fn a_force_with_too_few_digits_does_not_agree_with_the_law() {
    // 0.02 N m for a turn of 20 mrad, and forces in whole 10 mN m.
    let scene = scene(
        "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nperiod = \"1 ms\"\n\
         [encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"1 N m/rad\"\n",
    );
    let csv = |digits: usize| {
        let mut csv = "count,f [N m]\n".to_owned();
        for n in PATH {
            let force = -(n as f64 + 0.5) * std::f64::consts::TAU / 8192.0;
            writeln!(csv, "{n},{force:.digits$}").unwrap();
        }
        csv
    };
    let rough = audited(&csv(2), &scene);
    let force = rough.report().force.clone().unwrap();
    assert!(force.rough && !force.agrees);
    assert_eq!(rough.report().judged, Judged::Running);
    assert_eq!(rough.to_json()["findings"][0]["kind"], "rough_force");
    assert!(rough.report().to_text().contains("too few digits"));
    let fine = audited(&csv(9), &scene).report().force.clone().unwrap();
    assert!(fine.agrees && !fine.rough);
}

/// Zeros with few digits or many, as fractions and as doubles.
#[test]
fn a_force_that_is_zero_throughout_is_asked_for_another_column() {
    let all_zero = |audit: &Audit| {
        let findings = &audit.report().findings;
        assert_eq!(findings.len(), 1);
        assert_eq!(findings[0].kind, "zero_force");
        assert!(findings[0].says.contains("is it the right column?"));
        let text = audit.to_text();
        assert!(text.contains("zero in all 3 rows"), "{text}");
    };
    for zero in ["0", "0.0", "0.00000000", "0/1", "-0.0"] {
        let csv = format!("count,f\n0,{zero}\n3,{zero}\n5,{zero}\n");
        all_zero(&audited(&csv, &three_fifths()));
        // Where the wall's is zero too there is nothing to ask for.
        let csv = format!("count,f\n-3,{zero}\n-2,{zero}\n");
        let outside = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n[wall]\nunilateral = true";
        let audit = audited(&csv, &scene(outside));
        assert_eq!(audit.report().findings.len(), 0);
    }
    let counts = ("count".to_owned(), Values::Whole(vec![0, 3, 5]));
    let forces = ("f".to_owned(), Values::Doubles(vec![0.0, -0.0, 0.0]));
    let audit = audit_columns(vec![counts, forces], &three_fifths(), Options::default());
    all_zero(&audit.unwrap());
}

/// What is not the law's by more than the digits is another force, however near it is; and digits are not the cause. Of
/// positions it may be: one next to the border of a tick may have been rounded over it.
#[test]
fn a_force_that_is_near_the_law_is_another() {
    let path: Vec<i64> = (0..60).map(|i| [0, 4, 9, 12, 9, 4][i % 6]).collect();
    let moved = |i: usize| (path[i] - path[i.saturating_sub(1)]) as f64;
    let found = |column: &str, force: &dyn Fn(usize, f64) -> f64| {
        let forces = |i: usize| force(i, law(&path, i, 0, 1.0));
        let audit = audited(&trace(column, &path, forces), &three_fifths());
        let text = audit.to_text();
        assert!(!text.contains("more digits"), "{text}");
        let findings = audit.to_json()["findings"].as_array().unwrap().clone();
        let kinds = findings
            .iter()
            .map(|f| f["kind"].as_str().unwrap().to_owned());
        (kinds.collect::<Vec<_>>(), text)
    };
    let damped = |i: usize, law: f64| law - moved(i) / 16.0;
    let stiffer = |i: usize, law: f64| 1.2 * damped(i, law);
    let kicked = |i: usize, law: f64| if i == 20 { law + 1.0 } else { law };
    for (column, kind) in [("count", "other_force"), ("xi", "near_force")] {
        for force in [&damped as &dyn Fn(usize, f64) -> f64, &kicked] {
            let (kinds, text) = found(column, force);
            assert_eq!(kinds.last().unwrap(), kind, "{text}");
        }
    }
    let (_, text) = found("count", &kicked);
    let says = "differs from the wall's law in 1 of 60 rows by more than its digits are off, by 1.63 % of its size (RMS)";
    assert!(text.contains(says), "{text}");
    // A scale does not hide what is beside it.
    let (kinds, text) = found("count", &stiffer);
    assert_eq!(kinds, ["scale", "other_force"], "{text}");
    // Digits do not hide a scale, however near one it is.
    let (kinds, text) = found("count", &|_, law| 1.0001 * law);
    assert_eq!(kinds, ["scale"]);
    assert!(text.contains("the force is 1.0001 times"), "{text}");
    // What is left beside it is told from digits, and a scale that is near one from what is left.
    let sign = |i: usize| [1.0, -1.0][i / 6 % 2];
    let (kinds, text) = found("count", &|i, law| {
        ((1.1 * law + 0.01 * sign(i)) * 100.0).round() / 100.0
    });
    assert_eq!(kinds, ["scale", "other_force"], "{text}");
    let (kinds, text) = found("count", &|i, law| 1.005 * law * (1.0 + 0.001 * sign(i)));
    assert_eq!(kinds, ["other_force"], "{text}");
    // Of a multiple in full digits nothing is left but what sums of doubles are off.
    let (kinds, text) = found("count", &|_, law| 1.005_000_000_17 * law);
    assert_eq!(kinds, ["scale"], "{text}");
    // In single precision it is the law's.
    let (kinds, _) = found("count", &|_, law| f64::from((law * 0.1) as f32) * 10.0);
    assert_eq!(kinds.len(), 0, "{kinds:?}");
}

#[test]
fn the_laws_own_force_is_judged_interval_by_interval() {
    let scene = three_fifths();
    for column in ["xi", "count"] {
        let audit = audited(&trace(column, &PATH, |i| law(&PATH, i, 0, 1.0)), &scene);
        let report = audit.report();
        assert_eq!(
            (audit.verdict(), report.judged),
            (Verdict::Holds, Judged::Interval)
        );
        assert!(report.force.as_ref().unwrap().agrees);
        // The figures are those of the law's account.
        let mut csv = format!("{column}\n");
        PATH.iter().for_each(|n| writeln!(csv, "{n}").unwrap());
        let (plain, applied) = (audited(&csv, &scene).to_json(), audit.to_json());
        for field in ["observer", "worst", "first", "rows"] {
            let applied = without_force(&applied[field]);
            assert_eq!(plain[field], applied, "{column}: {field}");
        }
        assert_eq!(
            plain["running"]["net_linear"],
            applied["running"]["net_linear"]
        );
    }
}

#[test]
fn a_row_is_of_the_force_as_it_is_written() {
    // u·d + ½ξ₁² − ½ξ₀² with u = −0.1: −0.1·2 + ½·9 − ½ = 3.8.
    let (audit, rows) = audited_as("xi,f\n1,-0.1\n3,7\n", &three_fifths(), false, 0);
    let row = &audit.to_json()["rows"][0];
    assert_eq!(
        (&row["force"], &row["generated_linear"]),
        (&"-1/10".into(), &"19/5".into())
    );
    assert_eq!(row["dissipated_lower"], "18/5");
    assert_eq!(audit.to_json()["observer"]["energy"], "1/5");
    let header = rows.lines().next().unwrap();
    assert!(header.ends_with("violates_quantized,force"), "{header}");
    assert!(rows.ends_with(",-1/10\n"), "{rows}");
    // The rows are a trace of their own, under the same force.
    let (_, again) = audited_as(&rows, &three_fifths(), false, 0);
    assert_eq!(again, rows);
    // Against the quantized spring: −0.1·2 + (9/2 + 0) − (½ + 0).
    assert_eq!(row["generated_quantized"], "19/5");
}

#[test]
fn forces_with_a_pi_in_their_unit_are_enclosed() {
    let scene = scene(
        "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"2 N m/rad\"",
    );
    let audit = audited("count,f [mN m]\n3,-5.37\n4,-6.9\n5,0\n", &scene);
    let force = &audit.to_json()["rows"][0]["force"];
    // 5.37e-3/(2·2π/8192) = 3.5006…
    let approx = force["approx"].as_f64().unwrap();
    assert!((approx + 5.37e-3 * 8192.0 / (4.0 * std::f64::consts::PI)).abs() < 1e-9);
    let width = rational(&force["hi"]) - rational(&force["lo"]);
    assert!(width.is_positive() && width <= ratio(1, 1 << 39));
    assert_eq!(
        audit.to_json()["rows"][1]["force"]["lo"]
            .as_str()
            .unwrap()
            .get(..1),
        Some("-")
    );
}

#[test]
fn a_loop_with_memory_is_judged_by_what_the_operator_drew() {
    // β < ½ + 1: the criterion of a delay of one sample fails at every speed.
    let late = scene("[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n[sampling]\ndelay = 1");
    let mut csv = "xi\n".to_owned();
    PATH.iter().for_each(|n| writeln!(csv, "{n}").unwrap());
    let audit = audited(&csv, &late);
    assert_eq!(audit.report().judged, Judged::Running);
    // As the late force of a trace, above.
    assert_eq!(audit.verdict(), Verdict::Fails);
    let supply = &audit.to_json()["running"]["supply"];
    assert_eq!(supply["surely_drawn"], "188/5");
    assert_eq!(supply["least"], "-188/5");
    let drawn = |scene: &Scene| {
        let json = audited("xi\n0\n1\n", scene).to_json();
        let supply = json["running"]["supply"].as_object().unwrap().clone();
        ["surely_drawn", "surely_drawn_after"].map(|key| supply.get(key).cloned())
    };
    // Null says that nothing surely was; where the verdict does not ask, nothing is said.
    assert_eq!(drawn(&late), [const { Some(Value::Null) }; 2]);
    assert_eq!(drawn(&three_fifths()), [const { None }; 2]);
    let damped = scene(
        "[dimensionless]\nbeta = \"3\"\nsigma = \"3\"\n[sampling]\ndelay = 1\n[wall]\ndamping = \"1/4\"",
    );
    assert_eq!(audited(&csv, &damped).verdict(), Verdict::Holds);
}

fn scenes() -> impl Strategy<Value = &'static str> {
    prop_oneof![
        Just(""),
        Just("[wall]\nunilateral = true"),
        Just("[wall]\nmax_force = \"7/3\""),
        Just("[sampling]\ndelay = 2"),
        Just("[sampling]\ndelay = 1\n[wall]\ndamping = \"1/4\"\nforce_step = \"2/3\""),
    ]
}

/// V(ξ) of a scene of [`scenes`], by its own means.
fn potential(wall: &str, xi: &BigRational) -> BigRational {
    let square = |x: &BigRational| x * x / ratio(2, 1);
    if wall.contains("unilateral") && xi.is_negative() {
        return BigRational::zero();
    }
    let limit = ratio(7, 3);
    match wall.contains("max_force") && xi.abs() > limit {
        true => (xi.abs() - &limit) * &limit + square(&limit),
        false => square(xi),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(75)))]

    /// T = V(ξ₀) + Σ(βd² + σ|d| − F·d), by its own means, of positions that a trace of counts leaves
    /// room for: within what the audit says, and exactly that for a trace of positions.
    #[test]
    fn what_the_operator_drew_is_enclosed(
        wall in scenes(),
        (beta, sigma) in (0..9_i64, 0..9_i64),
        samples in prop::collection::vec((-3..4_i64, 0..8_i64, -40..40_i64), 2..40),
        scale in 1..12_i64,
        block in 20..200_usize,
    ) {
        let text = format!("[dimensionless]\nbeta = \"{beta}/4\"\nsigma = \"{sigma}/4\"\n{wall}\n");
        let scene = scene(&text);
        let (mut counts, mut exact) = ("count,f\n".to_owned(), "xi,f\n".to_owned());
        let mut path = Vec::new();
        let mut tick = 0;
        for (step, residue, force) in &samples {
            tick += step;
            let force = format!("{}/4", force * scale);
            writeln!(counts, "{tick},{force}").unwrap();
            writeln!(exact, "{}/8,{force}", 8 * tick + residue).unwrap();
            path.push((ratio(8 * tick + residue, 8), rational(&force.into())));
        }
        let start = potential(wall, &path[0].0);
        let mut left = start.clone();
        let mut lowest: Option<BigRational> = None;
        for pair in path.windows(2) {
            let d = &pair[1].0 - &pair[0].0;
            left += ratio(beta, 4) * &d * &d + ratio(sigma, 4) * d.abs() - &pair[0].1 * &d;
            if lowest.as_ref().is_none_or(|lowest| left < *lowest) {
                lowest = Some(left.clone());
            }
        }
        let lowest = lowest.unwrap();
        for (csv, is_exact) in [(&exact, true), (&counts, false)] {
            let (whole, rows) = audited_as(csv, &scene, false, 0);
            let (cut, same) = audited_as(csv, &scene, false, block);
            prop_assert_eq!(whole.to_json().to_string(), cut.to_json().to_string());
            prop_assert_eq!(rows, same);
            // By chance the forces may be the law's.
            prop_assume!(whole.report().judged == Judged::Running);
            let supply = whole.report().running.supply.as_ref().unwrap();
            let drawn = supply.drawn.clone().unwrap().surely_drawn;
            let is_drawn = lowest.is_negative();
            if is_exact {
                prop_assert_eq!(&supply.floor, &-start.clone());
                let least = (&lowest - &start).min(BigRational::zero());
                prop_assert_eq!(&supply.least, &least);
                prop_assert_eq!(drawn, is_drawn.then(|| -&lowest));
                // What the wall of the scene stores at the start was not stored by another.
                let verdict = match (is_drawn, least.is_negative()) {
                    (true, _) => Verdict::Fails,
                    (false, true) => Verdict::Depends,
                    (false, false) => Verdict::Holds,
                };
                prop_assert_eq!(whole.verdict(), verdict);
            } else {
                prop_assert!(&supply.least - &supply.floor <= lowest);
                prop_assert!(drawn.is_none_or(|drawn| lowest <= -drawn));
                match whole.verdict() {
                    Verdict::Fails => prop_assert!(is_drawn),
                    Verdict::Holds => prop_assert!(!is_drawn),
                    _ => {}
                }
            }
        }
    }
}
