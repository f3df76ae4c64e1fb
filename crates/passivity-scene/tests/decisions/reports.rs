//! What a report says of small scenes, with figures by hand (CHECK-VERDICT): T, Δ and K are 1 in SI units
//! unless a scene says otherwise.

use passivity_core::Truth;
use passivity_scene::Scene;
use passivity_scene::check::{Verdict, check};
use serde_json::Value;

use crate::ranges::range;
use crate::wall::report;

/// The figures of a report in one line, without those that are absent.
fn figures(values: &str) -> String {
    let report = report(values);
    let figures = [
        ("μ", report.mu),
        ("β", Some(report.beta)),
        ("σ", report.sigma),
        ("costs", Some(report.cost.viscous)),
        ("and", Some(report.cost.coulomb)),
        ("spares", Some(report.spare.viscous)),
        ("and", Some(report.spare.coulomb)),
        ("v_c", report.critical_speed),
        ("m/s", report.critical_speed_si),
        ("V", report.speed_bound),
        ("m/s", report.speed_bound_si),
        ("margin", report.margin_at_speed_bound),
        ("K", report.max_stiffness_all_speeds),
        ("to V", report.max_stiffness_at_speed_bound),
    ];
    let figures = figures.into_iter();
    let given = figures.filter_map(|(name, x)| Some(format!("{name} {}", range(&x?))));
    given.collect::<Vec<_>>().join(", ")
}

#[test]
fn figures_are_those_of_the_formulas() {
    for (values, expected) in [
        (
            "viscous 3/4, coulomb 4/5",
            "β 3/4, σ 4/5, costs 1/2, and 1/2, spares 1/4, and 3/10, K 3/2",
        ),
        // (8) at V = 2: ¼ + 3/10/2; K ≤ 2(b + c/2)/(T + Δ/2).
        (
            "viscous 3/4, coulomb 4/5, max_speed 2",
            "β 3/4, σ 4/5, costs 1/2, and 1/2, spares 1/4, and 3/10, V 2, m/s 2, margin 2/5, K 3/2, \
             to V 23/15",
        ),
        (
            "viscous 3/4, coulomb 4/5, max_speed 1 … 2",
            "β 3/4, σ 4/5, costs 1/2, and 1/2, spares 1/4, and 3/10, V 1 … 2, m/s 1 … 2, \
             margin 2/5 … 11/20, K 3/2, to V 23/15 … 31/20",
        ),
        // v_c = (c − KΔ/2)/(KT/2 − b), and in ticks T/Δ times that.
        (
            "viscous 2/5, coulomb 3/5, period 1.6, resolution 1/2",
            "β 1/4, σ 6/5, costs 1/2, and 1/2, spares -1/4, and 7/10, v_c 14/5, m/s 7/8, K 1/2",
        ),
        // μ = m/(KT²), β = b/(KT), σ = c/(KΔ), V·T/Δ; the margin b/(KT) − ½ + (c/(KΔ) − ½)Δ/(TV).
        (
            "viscous 2/5, coulomb 3/5, max_speed 2, inertia 2 … 4, period 0.5 … 1, resolution 1 … 2, \
             stiffness 1 … 2",
            "μ 1 … 16, β 1/5 … 4/5, σ 3/20 … 3/5, costs 1/2, and 1/2, spares -3/10 … 3/10, \
             and -7/20 … 1/10, V 1/2 … 2, m/s 2, margin -4/5 … 2/5, K 3/5 … 6/5, to V 3/5 … 6/5",
        ),
        // D/A steps of F cost F/2, damping B and BΔ/T.
        (
            "viscous 2, coulomb 2, damping 1/2, force_step 1/5, resolution 1/2",
            "β 2, σ 4, costs 1, and 6/5, spares 1, and 14/5, K 3",
        ),
        // Without an encoder steps are all that costs Coulomb friction.
        (
            "viscous 2, coulomb 2, force_step 1/5, stiffness 2, delay 1, smooth",
            "β 1, costs 3/2, and 1/20, spares -1/2, and 19/20, v_c 19/10, m/s 19/10, K 4/3",
        ),
    ] {
        assert_eq!(figures(values), expected, "{values}");
    }
}

/// With damping behind an encoder a period between the ends of its tolerance may have the largest margin:
/// b/T − B/T − ½ + (c − 1/2)/T − B/T² at V = 1 is p/T − q/T² − ½, at T = 2q/p as large as p²/(4q) − ½.
#[test]
fn the_margin_at_the_bound_is_largest_at_a_period_inside() {
    let margin = |period: &str| {
        let values = format!("viscous 3/4, coulomb 1, damping 1/2, max_speed 1, period {period}");
        range(&report(&values).margin_at_speed_bound.unwrap())
    };
    // p = ¾ and q = ½: T = 4/3.
    assert_eq!(margin("1 … 2"), "-1/4 … -7/32");
    assert_eq!(margin("1 … 4/3"), "-1/4 … -7/32");
    assert_eq!(margin("4/3 … 2"), "-1/4 … -7/32");
    assert_eq!(margin("3/2 … 2"), "-1/4 … -2/9");
    assert_eq!(margin("1/2 … 1"), "-1 … -1/4");
    assert_eq!(margin("4/3"), "-7/32");
    // With b of up to 1 it is largest at T = 1, where p = 1.
    let values = "viscous 3/4 … 1, coulomb 1, damping 1/2, max_speed 1, period 1/2 … 2";
    let margin = range(&report(values).margin_at_speed_bound.unwrap());
    assert_eq!(margin, "-1 … 0");
    // At V = 2 and K = 2 it is 3/(4T) − 1/(8T²) − ½, largest at T = 1/3.
    let values = "viscous 3/2, coulomb 2, damping 1/2, max_speed 2, stiffness 2, period 1/4 … 1";
    let margin = range(&report(values).margin_at_speed_bound.unwrap());
    assert_eq!(margin, "1/8 … 5/8");
}

#[test]
fn comparisons_are_the_papers() {
    use Truth::{Depends, Fails, Holds};
    for (values, colgate, abbott_okamura) in [
        ("viscous 1/2, coulomb 1/2", Some(Holds), Some(Holds)),
        ("viscous 0.49, coulomb 1/2", Some(Fails), Some(Fails)),
        ("viscous 1/2, coulomb 0.49", Some(Holds), Some(Fails)),
        (
            "viscous 1, coulomb 1/2, damping 1/2",
            Some(Holds),
            Some(Holds),
        ),
        (
            "viscous 1, coulomb 1/2, damping 0.51",
            Some(Fails),
            Some(Holds),
        ),
        ("viscous 0.4 … 0.6, coulomb 1", Some(Depends), Some(Depends)),
        ("viscous 1/2, smooth", Some(Holds), Some(Holds)),
        ("viscous 1, coulomb 1, delay 1", None, None),
        ("viscous 1, coulomb 1, latency 0.1", None, None),
    ] {
        let report = report(values);
        let found = (report.colgate, report.abbott_okamura);
        assert_eq!(found, (colgate, abbott_okamura), "{values}");
    }
}

#[test]
fn a_verdict_says_which_theorems_it_rests_on() {
    let holds = ["TH-REGION", "TH-INTERVAL", "TH-RUN"];
    let or_more = |more: &[&'static str]| [&holds[..], more].concat();
    // What a loop remembers may leave an interval with more than friction takes: there only runs are covered.
    let with_memory = |more: &[&'static str]| [&["TH-REGION"], more].concat();
    for (values, verdict, because) in [
        ("viscous 2, coulomb 2", Verdict::Passive, or_more(&[])),
        (
            "viscous 2, smooth",
            Verdict::Passive,
            or_more(&["TH-SMOOTH"]),
        ),
        (
            "viscous 2/5, coulomb 3/5",
            Verdict::NotPassive,
            vec!["TH-ACTIVE"],
        ),
        (
            "viscous 2/5, smooth",
            Verdict::NotPassive,
            vec!["TH-ACTIVE", "TH-SMOOTH"],
        ),
        (
            "viscous 2, coulomb 2, delay 1",
            Verdict::Passive,
            with_memory(&["TH-DELAY"]),
        ),
        (
            "viscous 2, coulomb 2, damping 1/2",
            Verdict::Passive,
            with_memory(&["TH-DAMP"]),
        ),
        (
            "viscous 2, coulomb 2, delay 1, damping 1/2",
            Verdict::Passive,
            with_memory(&["TH-LTI", "TH-DELAY", "TH-DAMP"]),
        ),
        (
            "viscous 2, coulomb 2, delay 1, damping 1/2, unilateral true",
            Verdict::Passive,
            with_memory(&["TH-DELAY", "TH-UNI", "TH-DAMP"]),
        ),
        (
            "viscous 1, coulomb 2, delay 1, damping 1/2",
            Verdict::NotPassive,
            vec!["TH-LTI", "TH-DELAY", "TH-DAMP"],
        ),
        (
            "viscous 2, coulomb 2, damping 1/2, damping_time_constant 1",
            Verdict::Passive,
            with_memory(&["TH-DAMP", "TH-LTI"]),
        ),
        (
            "viscous 2, coulomb 2, max_force 20, force_step 1/10",
            Verdict::Passive,
            or_more(&["TH-LAW", "TH-DAC"]),
        ),
        (
            "viscous 2, coulomb 2, latency 0.1, time_constant 0.1",
            Verdict::Passive,
            with_memory(&["TH-LATENCY", "TH-LAG"]),
        ),
    ] {
        let report = report(values);
        assert_eq!(
            (report.verdict, report.because),
            (verdict, because),
            "{values}"
        );
    }
}

/// (b − B − ½)V + c − ½ − B with all in the middle is m, and each tolerance moves it by so much: what alone
/// turns the hardest loop, or the easiest, decides.
#[test]
fn what_decides_is_what_alone_turns_the_verdict() {
    for (values, expected) in [
        // m = 0, and ±1/20 by each of three: none alone.
        (
            "viscous 0.4 ± 0.05, coulomb 0.8 ± 0.05, damping 0.1 ± 0.025, max_speed 1, inertia 1 ± 0.1",
            vec!["device.viscous", "device.coulomb", "wall.damping"],
        ),
        // ±1/10, ±3/100, ±3/100 about 1/20: only from the hardest end; about −1/20: only from the easiest.
        (
            "viscous 0.45 ± 0.1, coulomb 0.8 ± 0.03, damping 0.1 ± 0.015, max_speed 1",
            vec!["device.viscous"],
        ),
        (
            "viscous 0.35 ± 0.1, coulomb 0.8 ± 0.03, damping 0.1 ± 0.015, max_speed 1",
            vec!["device.viscous"],
        ),
        ("viscous 0.4 … 0.6, coulomb 1 ± 0.1", vec!["device.viscous"]),
        // KT/2 + B + (KT)²/8B, late by a sample: none alone, and the cost that is computed has no key.
        (
            "viscous 2.5625 ± 0.5%, coulomb 99, delay 1, damping 2 ± 0.5%, period 1 ± 2%",
            vec!["sampling.period", "device.viscous", "wall.damping"],
        ),
        ("viscous 1 ± 0.1, coulomb 1 ± 0.1", vec![]),
    ] {
        assert_eq!(report(values).decided_by, expected, "{values}");
    }
}

#[test]
fn json_says_what_the_report_says() {
    let json = |values: &str| report(values).to_json();
    let friction = "viscous 2/5, coulomb 3/5";
    for (start, holds) in [
        ("velocity 1/2", Value::Bool(true)),
        ("velocity 2", Value::Bool(false)),
        ("velocity 1/2 … 2", Value::Null),
    ] {
        let json = json(&format!("{friction}, {start}"));
        assert_eq!(json["unforced"]["holds"], holds, "{start}");
    }
    assert_eq!(json(friction)["region"], "locally_stable");
    assert_eq!(json("viscous 0.4 … 0.6, coulomb 1")["region"], "depends");
    assert_eq!(json("viscous 0.4 … 0.6, coulomb 1")["colgate"], "depends");
    let late = json("viscous 2, coulomb 2, delay 1");
    assert_eq!(late["colgate"], Value::Null);
    let expected = ["zero_order_hold", "viscous", "coulomb", "encoder", "delay"];
    assert_eq!(late["effects"], serde_json::json!(expected));
    let limit = &late["limits"][0];
    assert_eq!(limit["parameter"], "device.viscous");
    assert_eq!(
        (&limit["holds"], &limit["printed"]),
        (&"at_least".into(), &"1.5".into())
    );
}

#[test]
fn speeds_are_in_the_unit_of_the_scene() {
    let dimensionless = "[dimensionless]\nbeta = \"2/5\"\nsigma = \"3/5\"\n";
    let plain = check(&Scene::from_toml("test", dimensionless).unwrap());
    assert_eq!(plain.speed_written.unit(), " ticks/sample");
    assert_eq!(plain.max_stiffness_all_speeds, None);
    assert_eq!(plain.critical_speed_si, None);
    let started = format!("{dimensionless}[start]\nvelocity = \"1/2\"\n");
    let unforced = check(&Scene::from_toml("test", &started).unwrap())
        .unforced
        .unwrap();
    assert_eq!(unforced.speed_si, None);
    assert_eq!(report("viscous 1, coulomb 1").speed_written.unit(), " m/s");
}

/// Where no wall is soft enough over all tolerances, some are over a part of them.
#[test]
fn the_stiffest_wall_is_known_to_both_ends_of_the_tolerances() {
    let scene = |damping: &str| {
        let text = format!(
            "[device]\nviscous = \"0.024 N s/m ± 20%\"\ncoulomb = \"0.02 N\"\n[sampling]\nperiod = \"1 ms\"\n\
             [wall]\nstiffness = \"1 N/m\"\ndamping = \"{damping} N s/m\"\n"
        );
        check(&Scene::from_toml("s", &text).unwrap())
    };
    // K = 2(b − B)/T, of b from 0.0192 to 0.0288 N s/m.
    for (damping, least, most) in [
        ("0.019", (2, 5), (98, 5)),
        ("0.023", (0, 1), (58, 5)),
        ("0.03", (0, 1), (0, 1)),
    ] {
        let stiffest = scene(damping).max_stiffness_all_speeds.unwrap();
        let [lo, hi] = [least, most]
            .map(|(n, d): (i64, i64)| passivity_core::BigRational::new(n.into(), d.into()));
        assert_eq!((stiffest.lo(), stiffest.hi()), (&lo, &hi), "{damping}");
    }
}
