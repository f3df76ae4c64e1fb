//! What a verdict must not say: each case was wrong once.

use passivity_core::{Interval, Truth};
use passivity_scene::check::Verdict;

use super::{dimensionless, linear, number, report};

#[test]
fn a_speed_bound_with_a_tolerance_is_taken_at_its_hardest() {
    let bounded = "[operator]\nmax_speed = \"1 ± 50%\"\n";
    let report = dimensionless("2/5", "3/5", bounded);
    assert_eq!(report.verdict, Verdict::Depends);
    assert_eq!(report.decided_by, ["operator.max_speed"]);
    let slower = dimensionless("2/5", "3/5", "[operator]\nmax_speed = \"1/2 ± 50%\"\n");
    assert_eq!(slower.verdict, Verdict::Passive);
}

#[test]
fn a_start_never_changes_the_verdict() {
    let bare = dimensionless("2/5", "3/5", "");
    let started = dimensionless("2/5", "3/5", "[start]\nvelocity = \"1/10\"\n");
    assert_eq!(bare.verdict, Verdict::NotPassive);
    assert_eq!(started.verdict, Verdict::NotPassive);
    assert_eq!(bare.unforced, None);
    let unforced = started.unforced.unwrap();
    assert_eq!(unforced.holds, Truth::Holds);
    assert_eq!(unforced.speed, Interval::point(number("1/10")));
    let too_fast = dimensionless("2/5", "3/5", "[start]\nvelocity = \"11/10\"\n");
    assert_eq!(too_fast.unforced.unwrap().holds, Truth::Fails);
}

#[test]
fn an_unforced_motion_says_what_it_assumes_of_the_controllers_memory() {
    let more = "[sampling]\ndelay = 2\n[start]\nvelocity = \"-1.9\"\n";
    let report = dimensionless("2", "3/2", more);
    let json = report.to_json();
    assert_eq!(json["unforced"]["holds"], true);
    let assumes = json["unforced"]["assumes"].as_str().unwrap();
    assert!(assumes.contains("rested there before, for as long as the delay looks back"));
    let text = report
        .to_text()
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    assert!(
        text.contains(&format!("(TH-START), if {assumes}")),
        "{text}"
    );
    // Without a memory nothing is assumed of it.
    let bare = dimensionless("2", "3/2", "[start]\nvelocity = \"-1.9\"\n");
    assert_eq!(bare.to_json()["unforced"]["holds"], true);
    assert_eq!(
        bare.to_json()["unforced"]["assumes"],
        serde_json::Value::Null
    );
    let text = bare.to_text();
    assert!(
        text.contains("(TH-START)\n") && !text.contains("rested"),
        "{text}"
    );
}

#[test]
fn a_pi_that_cancels_is_decided() {
    // Wall in N·m/deg and encoder in deg: σ = c/(KΔ) = ½ exactly.
    let scene = |coulomb: &str| {
        format!(
            "[device]\nviscous = \"1 N m s/deg\"\ncoulomb = \"{coulomb} N m\"\n[sampling]\n\
             period = \"1 ms\"\n[encoder]\nresolution = \"0.1 deg\"\n[wall]\nstiffness = \"1 N m/deg\"\n"
        )
    };
    let border = report(&scene("0.05"));
    assert_eq!(border.verdict, Verdict::Passive);
    assert_eq!(border.spare.coulomb, Interval::point(number("0")));
    let below = report(&scene("0.0499999999999999999999999999999999999999"));
    assert_eq!(below.verdict, Verdict::NotPassive);
    assert!(border.decided_by.is_empty() && below.decided_by.is_empty());
}

#[test]
fn damping_of_zero_is_no_damping() {
    let none = dimensionless("2/5", "3/5", "");
    let zero = dimensionless("2/5", "3/5", "[wall]\ndamping = \"0\"\n");
    assert_eq!(zero, none);
    assert_eq!(zero.verdict, Verdict::NotPassive);
}

#[test]
fn saturation_with_virtual_damping_is_covered() {
    let wall = "[wall]\ndamping = \"1/10\"\nmax_force = \"20\"\n";
    assert_eq!(dimensionless("1", "1", wall).verdict, Verdict::Passive);
}

#[test]
fn a_witness_keeps_below_the_speed_bound() {
    let bound = |v: &str| format!("[operator]\nmax_speed = \"{v}\"\n");
    for v in ["1/10", "1", "7/3", "10"] {
        let report = dimensionless("1/5", "0", &bound(v));
        let witness = report.witness.unwrap();
        assert!(&witness.to - &witness.from < number(v), "{v}");
    }
}

/// What keeps the conditions of others from applying is named, and nothing that the scene lacks.
#[test]
fn comparisons_do_not_apply_to_what_acts_late_or_is_filtered() {
    let filter = "[wall]\ndamping = \"1/10\"\ndamping_time_constant = \"1\"\n";
    for (extra, why) in [
        ("[sampling]\ndelay = 1\n", "delay of whole samples"),
        (
            "[sampling]\nlatency = \"1/2\"\n",
            "latency before the output changes",
        ),
        (filter, "one-pole filter on the virtual damping"),
        (
            "[controller]\nnumerator = [\"1\"]\ndenominator = [\"1\"]\n",
            "a digital controller",
        ),
        (
            "[amplifier]\ntime_constant = \"1/3\"\n",
            "first-order lag of the amplifier",
        ),
        (
            "[sampling]\ndelay = 1\nlatency = \"1/2\"\n",
            "delay of whole samples; latency before the output changes",
        ),
    ] {
        let report = dimensionless("2", "2", extra);
        assert_eq!((report.colgate, report.abbott_okamura), (None, None));
        // A text that fills more than a line is broken at a space.
        let text = report
            .to_text()
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        let says = format!("does not apply: {why} ");
        assert_eq!(text.matches(&says).count(), 2, "{says}{text}");
    }
}

#[test]
fn comparisons_apply_to_damping_saturation_and_a_force_step() {
    let wall = "[wall]\ndamping = \"1/10\"\nmax_force = \"20\"\nforce_step = \"1/10\"\n";
    let report = dimensionless("2", "2", wall);
    let holds = Some(Truth::Holds);
    assert_eq!((report.colgate, report.abbott_okamura), (holds, holds));
}

#[test]
fn a_period_that_pulls_both_ways_limits_the_others_at_its_shortest() {
    let report = report(&linear(&[
        ("viscous", "10"),
        ("coulomb", "0.75 ± 0.15"),
        ("period", "1 ± 0.5"),
        ("stiffness", "0.5"),
        ("damping", "0.1"),
    ]));
    assert_eq!(report.verdict, Verdict::Passive);
    let printed = |key: &str| {
        let mut limits = report.limits.iter();
        let limit = limits
            .find(|limit| limit.parameter.row().key == key)
            .unwrap();
        number(limit.printed.as_ref().unwrap())
    };
    assert_eq!(printed("wall.stiffness"), number("0.8"));
    assert_eq!(printed("encoder.resolution"), number("1.3333"));
}

#[test]
fn where_every_period_passes_or_every_one_fails_nothing_depends() {
    let both = |viscous: &str, coulomb: &str, more: &[(&str, &str)]| {
        let given = [
            ("viscous", viscous),
            ("coulomb", coulomb),
            ("period", "1 ± 0.5"),
            ("damping", "0.1"),
        ];
        report(&linear(&[&given[..], more].concat())).verdict
    };
    // 0.6V + 0.25 − T·V/2 − 0.1/T is least at T = 1/2 and 3/2: 0.4 and 0.033 at V = 1.
    assert_eq!(both("0.7", "0.75", &[("max_speed", "1")]), Verdict::Passive);
    // β ≥ ½ asks for T ≤ 0.6 and σ ≥ ½ for T ≥ 1.
    let fails = both("0.4", "0.6", &[]);
    assert_eq!(fails, Verdict::NotGuaranteed);
}

/// Figures for people are in the units of the scene file: each limit, typed into its place, passes,
/// and a little beyond it does not.
#[test]
fn limits_are_written_as_the_scene_writes_its_parameters() {
    // Each line has the value that is replaced between two bars.
    const LINES: [(&str, &str); 5] = [
        ("viscous", "viscous = \"|2e-3| N m s/deg\""),
        ("coulomb", "[device]\ncoulomb = \"|500| mN m\""),
        ("rate", "[sampling]\nrate = \"|1| kHz\""),
        ("counts", "[encoder]\ncounts_per_revolution = |720|"),
        ("stiffness", "[wall]\nstiffness = \"|0.9| N m/deg\""),
    ];
    let scene = |changed: &str, value: &str| {
        let mut order = LINES;
        order.swap(0, 1); // The section comes first.
        let mut text = String::new();
        for (key, line) in order {
            let parts: Vec<&str> = line.split('|').collect();
            let value = if key == changed { value } else { parts[1] };
            text += &format!("{}{value}{}\n", parts[0], parts[2]);
        }
        report(&format!("{text}[operator]\nmax_speed = \"300 deg/s\"\n"))
    };
    let first = scene("", "");
    assert_eq!(first.speeds_text(), "at every speed");
    assert_eq!(first.speed_bound_text(), "300 deg/s");
    let text = first.to_text();
    for expected in ["N m/deg at every speed", "margin (8) at 300 deg/s"] {
        assert!(text.contains(expected), "{text}");
    }
    assert_eq!(first.limits.len(), LINES.len());
    for (limit, (key, _)) in first
        .limits
        .iter()
        .zip([LINES[0], LINES[1], LINES[4], LINES[2], LINES[3]])
    {
        let typed = limit.typed.as_deref().expect(key);
        assert!(text.contains(typed), "{key} = {typed} in {text}");
        assert!(scene(key, typed).at_every_speed, "{key} = {typed}");
        let at_least = limit.promise(first.motion).starts_with("at least");
        let factor = if at_least { "0.998" } else { "1.002" };
        let mut beyond = number(typed) * number(factor);
        if key == "counts" {
            beyond = beyond.floor();
        }
        assert!(
            !scene(key, &beyond.to_string()).at_every_speed,
            "{key} = {beyond}"
        );
    }
}
