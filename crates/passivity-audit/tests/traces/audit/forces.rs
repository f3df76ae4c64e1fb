//! Logs that have the force: what is said of the wall's law beside it, and what is accounted for without one.

use std::fmt::Write as _;
use std::str::FromStr as _;

use passivity_audit::{Options, Verdict, audit_csv};
use passivity_core::{BigRational, Scalar as _};
use serde_json::Value;

use super::{audited, scene, three_fifths};

#[test]
fn forces_are_compared_with_the_law_and_their_delay_found() {
    let law = |n: i64| -(n as f64 + 0.5);
    let counts = [0_i64, 1, 3, 6, 8, 9, 9, 8, 4, 0, -3, -7, -5, 0, 2, 3];
    let trace = |lag: usize, sign: f64, off: f64| {
        let mut csv = "count,f\n".to_owned();
        for (i, n) in counts.iter().enumerate() {
            let force = sign * law(counts[i.saturating_sub(lag)]) + if i == 9 { off } else { 0.0 };
            writeln!(csv, "{n},{force}").unwrap();
        }
        audited(csv.as_bytes(), &three_fifths(), 1, 30).0.to_json()["force"].clone()
    };
    assert_eq!(trace(0, 1.0, 0.0)["agrees"], true);
    let wrong = trace(0, 1.0, 0.25);
    assert_eq!(
        (&wrong["mismatches"], &wrong["first_mismatch_row"]),
        (&1.into(), &10.into())
    );
    assert_eq!(wrong["found"]["delay"], 0);
    let late = trace(3, 1.0, 0.0);
    assert_eq!(late["agrees"], false);
    assert_eq!(
        (&late["found"]["delay"], &late["found"]["mismatches"]),
        (&3.into(), &0.into())
    );
    assert_eq!(trace(0, -1.0, 0.0)["found"]["reversed"], true);
}

#[test]
fn a_logged_force_is_accounted_for_whatever_filter_or_controller_made_it() {
    let plain = "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n";
    let filter = "[wall]\ndamping = \"1/2\"\ndamping_time_constant = \"2\"\n";
    let controller = "[controller]\nnumerator = [\"1\", \"1\"]\ndenominator = [\"2\"]\n";
    let latency = "[sampling]\nlatency = \"1/4\"\n";
    let of = |more: &str, log: &[u8]| audited(log, &scene(&format!("{plain}{more}")), 1, 0).0;
    // There and back: friction takes 2 (β + σ) = 4 and the spring stores nothing at the ends. A force
    // of 5 along the motion gives the operator 10; a force of 1 gives less than friction takes.
    let logs: [(&[u8], Verdict); 2] = [
        (b"xi,f\n0,5\n1,-5\n0,0\n", Verdict::Fails),
        (b"xi,f\n0,1\n1,-1\n0,0\n", Verdict::Holds),
    ];
    for (log, expected) in logs {
        for more in [filter, controller] {
            let audit = of(more, log);
            assert_eq!(audit.verdict(), expected, "{more}");
            // Its account is that of the wall alone, and beside it nothing is said of the law.
            assert_eq!(audit.totals().net_linear, of("", log).totals().net_linear);
            let said = audit.to_json();
            assert_eq!(said["not_covered"], serde_json::json!([]));
            assert!(said["force"].is_null() && said["law"].is_null(), "{said}");
            let text = audit.to_text();
            let spring = match more == filter {
                true => "the wall's spring stored at the start",
                false => "the spring of H(1) times the stiffness stored at the start",
            };
            assert!(text.contains(spring), "{text}");
        }
        assert_eq!(of(latency, log).verdict(), Verdict::NotCovered);
    }
    // Without forces, or where the law is asked for, nothing is known of what the memory held.
    for more in [filter, controller] {
        assert_eq!(of(more, b"xi\n0\n1\n").verdict(), Verdict::NotCovered);
    }
}

/// A controller stores ½H(1)ξ² (TH-LTI). From ξ₀ = 10¼ by one after the other with force F each way, F is what the hand
/// gets of each, and friction takes β + σ = 12/5 of it.
#[test]
fn a_controller_has_the_spring_that_it_acts_as_at_rest() {
    let of = |numerator: &str, log: &str| {
        let text = format!(
            "[dimensionless]\nbeta = \"6/5\"\nsigma = \"6/5\"\n[controller]\nnumerator = {numerator}\ndenominator = [\"1\"]"
        );
        audited(log.as_bytes(), &scene(&text), 1, 0).0
    };
    let supply =
        |numerator: &str, log: &str| of(numerator, log).to_json()["running"]["supply"].clone();
    // Of H = 2 the law commands −2(n + ½): it gives back what its spring has, 10¼², less what friction takes.
    let mut release = "xi,f\n".to_owned();
    for n in (0..=10).rev() {
        writeln!(release, "{n}.25,{}", -(2 * n + 1)).unwrap();
    }
    let given = supply("[\"2\"]", &release);
    // Σ from 1 to 10 of 2n + 1, less 12/5 each: 120 − 24.
    assert_eq!(
        (&given["least"], &given["floor"]),
        (&"-96".into(), &"-1681/16".into())
    );
    assert_eq!(given["surely_drawn"], Value::Null);
    assert_eq!(of("[\"2\"]", &release).verdict(), Verdict::Holds);
    // That of the wall alone stores half as much, and one with H(1) = 0 nothing.
    assert_eq!(of("[\"1\"]", &release).verdict(), Verdict::Fails);
    let pushed = "xi,f\n10.25,-5\n9.25,-5\n8.25,0\n";
    let drawn = supply("[\"1\", \"-1\"]", pushed);
    assert_eq!(
        (&drawn["floor"], &drawn["surely_drawn"]),
        (&"0".into(), &"26/5".into())
    );
    assert_eq!(of("[\"1\", \"-1\"]", pushed).verdict(), Verdict::Fails);
    assert_eq!(of("[\"1\"]", pushed).verdict(), Verdict::Holds);
    // Counts leave room: by a tick, and of H = 2 by ½(11² − 10²) more of what was stored.
    let counted = "count,f\n10,-5\n9,-5\n8,0\n";
    let most = |numerator: &str| {
        let supply = supply(numerator, counted);
        ["least", "floor"].map(|key| BigRational::from_str(supply[key].as_str().unwrap()).unwrap())
    };
    let ([least, wall], [same, double], [_, none]) =
        (most("[\"1\"]"), most("[\"2\"]"), most("[\"1\", \"-1\"]"));
    assert_eq!(least, same);
    assert_eq!(wall - double, BigRational::from_integer(50.into()));
    assert_eq!(none, BigRational::zero());
}

/// Of 1000 N/m, 0.03 mm and a law of −0.03 N/tick.
const LINEAR: &str = "[device]\nviscous = \"20 N s/m\"\ncoulomb = \"2 N\"\n[sampling]\nperiod = \"1 ms\"\n\
                      [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"1000 N/m\"\n";

/// A log of so many rows before the wall and 240 with the wall's force in mN, none above 2 N, as they are written.
fn clipped(before: usize, written: impl Fn(i64) -> String) -> String {
    let count = |i: i64| (80.0 * (i as f64 / 20.0).sin()) as i64;
    let force = |n: i64| (-30 * n - 15).clamp(-2000, 2000);
    let mut csv = "count,f [N]\n".to_owned();
    for n in (0..240).map(count) {
        writeln!(csv, "{n},{}", written(force(n))).unwrap();
    }
    let (header, rows) = csv.split_once('\n').unwrap();
    format!("{header}\n{}{rows}", "-1,0\n".repeat(before))
}

#[test]
fn a_limit_that_is_written_short_is_no_rounding() {
    let fixed = |f: i64| format!("{:.3}", f as f64 / 1000.0);
    let short = |f: i64| format!("{}", f as f64 / 1000.0);
    let force = |csv: &str, block: usize| {
        let force = audited(csv.as_bytes(), &scene(LINEAR), 1, block)
            .0
            .to_json()["force"]
            .clone();
        assert_eq!(force["agrees"], false, "{force}");
        force["mismatches"].clone()
    };
    let expected = force(&clipped(0, fixed), 0);
    assert_ne!(expected, 0);
    for block in [0, 30] {
        assert_eq!(force(&clipped(0, short), block), expected);
        // For the careful parser.
        assert_eq!(
            force(&clipped(0, |f| format!("\"{}\"", short(f))), block),
            expected
        );
        assert_eq!(
            force(&clipped(0, |f| format!("{}e-3", short(1000 * f))), block),
            expected
        );
    }
    // More zeros than are looked at at once come before.
    let late = |written: &dyn Fn(i64) -> String| force(&clipped(14_000, written), 0);
    assert_eq!(late(&short), late(&fixed));
}

/// The account of the wall's law beside that of the forces in a log is the one that is asked for by itself, however the
/// log is cut, of counts and of positions, and with a motion across a tick that doubles do not decide.
#[test]
fn the_laws_account_beside_another_is_that_of_itself() {
    let path = [0, 1, 3, 6, 8, 9, 9, 8, 4, 0, -3, -7, -5, 0, 2, 3];
    let scene = three_fifths();
    for column in ["count", "xi"] {
        let mut csv = format!("tau,{column},f\n");
        for i in 0..3000_i64 {
            let n = path[i as usize % path.len()] + i / 700;
            let late = [0, 7, 0, 31][i as usize % 4];
            writeln!(csv, "{i}.{late:03},{n},{}", 3 - n).unwrap();
        }
        let json = |law, block| {
            let options = Options {
                law,
                block,
                threads: 2,
                ..Options::default()
            };
            let input = Box::new(std::io::Cursor::new(csv.clone()));
            audit_csv(input, &scene, options).unwrap().to_json()
        };
        let alone = json(true, 0);
        assert_eq!(alone["intervals"], 2999);
        for block in [0, 4096] {
            let beside = &json(false, block)["law"];
            for key in ["verdict", "judged", "totals"] {
                assert_eq!(beside[key], alone[key], "{column} {key} {block}");
            }
        }
    }
}

/// What is found of a clock.
const OF_CLOCK: [&str; 3] = ["fast_clock", "oversampled", "undersampled"];

/// A clock that is a thousand times too fast makes friction a thousand times too much: what would hold is left open.
#[test]
fn a_clock_that_is_too_fast_leaves_open_what_would_hold() {
    let said = |csv: &str| {
        let audit = audited(csv.as_bytes(), &three_fifths(), 1, 0).0;
        let kinds = audit.report().findings.iter().map(|finding| finding.kind);
        let clock = kinds.filter(|kind| OF_CLOCK.contains(kind));
        (audit.verdict(), clock.collect::<Vec<_>>())
    };
    let log = |step: &str, force: &str| {
        let mut csv = format!("tau,xi{}\n", if force.is_empty() { "" } else { ",f" });
        for i in 0..4 {
            writeln!(csv, "{i}{step},{}{force}", i % 2).unwrap();
        }
        said(&csv)
    };
    for force in ["", ",1/8"] {
        assert_eq!(log("", force), (Verdict::Holds, Vec::new()));
        assert_eq!(log("e-3", force), (Verdict::Depends, vec!["fast_clock"]));
    }
    // Several rows of a sample: the law would command a force for each, and those in a log are what they are.
    assert_eq!(log("e-1", ""), (Verdict::Depends, vec!["oversampled"]));
    assert_eq!(log("e-1", ",1/8"), (Verdict::Holds, vec!["oversampled"]));
    // Forces of samples that were left out are not in the log, and a row alone may be late.
    assert_eq!(
        said("tau,xi,f\n0,0,1/8\n2,0,1/8\n4,0,1/8\n"),
        (Verdict::Depends, vec!["undersampled"])
    );
    assert_eq!(said("tau,xi\n0,0\n2,0\n"), (Verdict::Holds, Vec::new()));
    assert_eq!(
        said("tau,xi\n0,0\n1,0\n3,0\n"),
        (Verdict::Holds, Vec::new())
    );
    // A gap is no finding of this kind, and what fails, though friction takes 600, does so by any clock.
    assert_eq!(
        said("tau,xi\n0,0\n0.001,0\n1,1\n"),
        (Verdict::Holds, Vec::new())
    );
    assert_eq!(said("tau,xi,f\n0,0,900\n0.001,1,0\n").0, Verdict::Fails);
}

/// A recorder that pauses makes some intervals long, and a clock jitters: what 9 of 10 intervals are is found.
#[test]
fn a_clock_that_is_too_fast_is_found_beside_pauses() {
    let scene = three_fifths();
    // So many rows at such steps, and some pauses: whole numbers, decimals, doubles as they are printed, or fractions.
    let log = |column: &str, written: &dyn Fn(f64) -> String, step: &dyn Fn(usize) -> f64| {
        let mut csv = format!("tau,{column}\n");
        let mut time = 0.0;
        for i in 0..401 {
            writeln!(csv, "{},{}", written(time), i % 2 * 10).unwrap();
            time += step(i);
        }
        csv
    };
    let decimal = |x: f64| format!("{x:.6}");
    let double = |x: f64| x.to_string();
    let fraction = |x: f64| format!("{:.0}/1024000", x * 1_024_000.0);
    type Written<'a> = &'a dyn Fn(f64) -> String;
    let ways: [(&str, Written<'_>); 3] = [("count", &decimal), ("xi", &double), ("xi", &fraction)];
    let even = |step: f64| move |i: usize| if i % 100 == 50 { 2000.0 } else { step };
    let tenth = |step: f64| move |i: usize| if i % 10 == 5 { 7.0 } else { step };
    let ninth = |step: f64| move |i: usize| if i % 9 == 5 { 7.0 } else { step };
    let jitter = |step: f64| move |i: usize| step * [1.0, 1.1, 2.2, 0.9, 1.0][i % 5];
    type Steps<'a> = &'a dyn Fn(usize) -> f64;
    let second = |i: usize| 1.0 + (i % 2) as f64;
    let third = |i: usize| if i % 3 == 1 { 2.0 } else { 1.0 };
    let pairs = |i: usize| if i % 2 == 1 { 1.6 } else { 0.4 };
    let paused = |i: usize| if i == 200 { 2000.0 } else { pairs(i) };
    let cases: [(Steps<'_>, Option<(&str, &str)>); 16] = [
        (
            &even(0.001),
            Some((
                "fast_clock",
                "396 of 400 intervals between rows are at most 1/32 of",
            )),
        ),
        (&even(1.0 / 32.0), Some(("fast_clock", "396 of 400"))),
        (&tenth(0.001), Some(("fast_clock", "360 of 400"))),
        (&ninth(0.001), None),
        (
            &even(0.032),
            Some((
                "oversampled",
                "396 of 400 intervals between rows are at most 3/4 of",
            )),
        ),
        (&even(0.5), Some(("oversampled", "396 of 400"))),
        (&jitter(0.25), Some(("oversampled", "400 of 400"))),
        (&ninth(0.5), None),
        (&even(0.76), None),
        (&jitter(0.8), None),
        // Every second row of a log, or of some of it; and a controller that is late, but misses no sample.
        (
            &even(2.0),
            Some((
                "undersampled",
                "400 of 400 intervals between rows are at least 3/2 of",
            )),
        ),
        (&second, Some(("undersampled", "200 of 400"))),
        (&third, None),
        (&even(1.4), None),
        // Rows that come in pairs, of which none is missing but in a pause.
        (&pairs, None),
        (&paused, None),
    ];
    for (column, written) in ways {
        for (case, (step, expected)) in cases.iter().enumerate() {
            let csv = log(column, written, step);
            let whole = audited(csv.as_bytes(), &scene, 1, 0).0;
            let mut clock = whole.report().findings.iter();
            let clock = clock.find(|it| OF_CLOCK.contains(&it.kind));
            let found = clock.map(|finding| (finding.kind, &finding.says[..]));
            let is_so = match (found, expected) {
                (Some((kind, says)), Some((of, start))) => kind == *of && says.starts_with(start),
                (found, expected) => found.is_none() && expected.is_none(),
            };
            assert!(is_so, "{column} {case}: {found:?}");
            assert!(expected.is_none() || whole.verdict() != Verdict::Holds);
            // However it is cut, and without points or rows.
            let cut = audited(csv.as_bytes(), &scene, 2, 300).0;
            let input = Box::new(std::io::Cursor::new(csv));
            let alone = audit_csv(input, &scene, Options::default()).unwrap();
            for other in [cut, alone] {
                assert_eq!(
                    other.report().findings,
                    whole.report().findings,
                    "{column} {case}"
                );
            }
        }
    }
}
