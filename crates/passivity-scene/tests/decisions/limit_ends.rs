//! Limits of parameters whose values pass from one end to another: less is not always safer.

use passivity_core::{BigRational, Parameter};
use passivity_scene::Scene;
use passivity_scene::check::{Target, Verdict, check, constants};

use crate::wall::{self, report};

/// The line of a limit, from the report on a scene.
fn line(text: &str, name: &str) -> String {
    let mut lines = text.lines().map(str::trim_start);
    let found = lines.find_map(|line| line.strip_prefix(name)?.strip_prefix(": "));
    found.unwrap_or_else(|| panic!("{name}: {text}")).to_owned()
}

const DAMPING: &str = "virtual damping B";
const PERIOD: &str = "sampling period T";
const FILTER: &str = "time constant of the damping's filter τ";

/// Behind a delay of one sample damping B costs 3/2 − B up to 1/4, and ½ + B + 1/(8B) from there on:
/// with b = 4/3 it passes from 1/6 to (5/6 + √7/6)/2 = 0.63715.
#[test]
fn damping_that_a_delay_needs_is_limited_on_both_sides() {
    let values = |damping: &str| format!("viscous 4/3, coulomb 4, delay 1, damping {damping}");
    for now in ["0.4", "0.1", "0", "2"] {
        let text = report(&values(now)).to_text();
        let Some(now) = Some(now).filter(|now| *now != "0") else {
            // Nothing to start from.
            assert!(!text.contains(DAMPING), "{text}");
            continue;
        };
        let expected = format!("from 0.16667 to 0.63714 N s/m (now {now} N s/m)");
        assert_eq!(line(&text, DAMPING), expected);
    }
    for (damping, verdict) in [
        ("0.16667", Verdict::Passive),
        ("0.63714", Verdict::Passive),
        ("0.1665", Verdict::NotPassive),
        ("0.6378", Verdict::NotPassive),
        ("0", Verdict::NotPassive),
    ] {
        assert_eq!(report(&values(damping)).verdict, verdict, "{damping}");
    }
    let json = report(&values("0.4")).to_json();
    let mut limits = json["limits"].as_array().unwrap().iter();
    let limit = limits.find(|limit| limit["parameter"] == "wall.damping");
    let limit = limit.unwrap();
    assert_eq!(
        [
            &limit["holds"],
            &limit["printed"],
            &limit["other_end"]["printed"]
        ],
        ["at_most", "0.63714", "0.16667"]
    );
    // Of what is too little the nearer end is the one to go to.
    let limits = report(&values("0.1")).limits.into_iter();
    let mut of_damping = limits.filter(|limit| limit.parameter == Parameter::Damping);
    assert_eq!(
        of_damping.next().unwrap().printed.as_deref(),
        Some("0.16667")
    );
    // With more friction none is needed, and without a delay never.
    for plain in [
        "viscous 1.6, coulomb 4, delay 1, damping 0.4",
        "viscous 3/4, coulomb 1, damping 0.1",
    ] {
        let said = line(&report(plain).to_text(), DAMPING);
        assert!(said.starts_with("at most "), "{said}");
    }
}

/// c ≥ KΔ/2 + BΔ/T: with c = 3/4 and B = 1/10 a period of at least 2/5 is needed, and of at most
/// 2(b − B); as a rate from one to the other.
#[test]
fn a_period_with_damping_is_limited_on_both_sides() {
    let values = "viscous 3/4, coulomb 3/4, damping 0.1";
    let expected = "from 0.4 to 1.3 s (now 1 s)";
    assert_eq!(line(&report(values).to_text(), PERIOD), expected);
    // Up to V = 1 the margin b − B − T/2 + c − 1/2 − B/T is zero at (1 ∓ √(1/5))/2; near rest T ≥ 1/5 is
    // enough.
    let fast = "viscous 0.1, coulomb 1, period 0.5, damping 0.1, max_speed 1";
    let said = line(&report(fast).to_text(), PERIOD);
    assert_eq!(said, "from 0.2764 to 0.7236 s (now 0.5 s)");
    let rate = "
        device.viscous = \"0.75 N s/m\"
        device.coulomb = \"0.75 N\"
        sampling.rate = \"1 Hz\"
        encoder.resolution = \"1 m\"
        wall.stiffness = \"1 N/m\"
        wall.damping = \"0.1 N s/m\"
    ";
    let text = check(&Scene::from_toml("rate", rate).unwrap()).to_text();
    let said = line(&text, "sampling rate 1/T");
    assert_eq!(said, "from 0.76924 to 2.5 Hz (now 1 Hz)");
    // Without an encoder, or without damping, the shortest is the safest.
    for free in [
        "viscous 3/4, coulomb 3/4, damping 0.1, smooth",
        "viscous 3/4, coulomb 3/4",
    ] {
        let said = line(&report(free).to_text(), PERIOD);
        assert!(said.starts_with("at most "), "{said}");
    }
    // With a delay no formula says the ends.
    let late = "viscous 1.35, coulomb 0.9, delay 1, damping 0.3";
    let said = line(&report(late).to_text(), PERIOD);
    assert!(said.starts_with("from 0.75 to "), "{said}");
}

const LATE: &str = r#"
    device.viscous = "7.80162 N s/m"
    device.coulomb = "0.029047 N"
    sampling.period = "1 ms"
    sampling.delay = 3
    encoder.resolution = "0.01 mm"
    wall.stiffness = "2308.74 N/m"
    wall.damping = "2.30874 N s/m"
    wall.damping_time_constant = "10 ms"
"#;

/// Behind a delay a filter can be too slow for the damping that is needed.
#[test]
fn a_filter_behind_a_delay_is_limited_on_both_sides() {
    let of = |tau: &str| {
        let text = LATE.replace("\"10 ms\"", &format!("\"{tau} ms\""));
        check(&Scene::from_toml("late", &text).unwrap())
    };
    let said = line(&of("10").to_text(), FILTER);
    let (from, to) = said
        .strip_prefix("from ")
        .unwrap()
        .split_once(" to ")
        .unwrap();
    let (to, now) = to.split_once(' ').unwrap();
    assert_eq!(now, "ms (now 10 ms)");
    for (end, beyond) in [(from, 0.999), (to, 1.001)] {
        assert_eq!(of(end).verdict, Verdict::Passive, "{said}");
        let beyond = end.parse::<f64>().unwrap() * beyond;
        assert_ne!(of(&beyond.to_string()).verdict, Verdict::Passive, "{said}");
    }
    assert_eq!(of("319").verdict, Verdict::NotPassive);
}

/// The encoder asks for BΔ/(T + τ) ≤ c − KΔ/2, for a period of at least 74.896 µs, and the cells of a long stretch of
/// periods do not tell so much.
#[test]
fn the_end_of_a_stretch_is_found_by_shorter_ones() {
    let values = "viscous 5.73011, coulomb 0.0987196, period 1e-3, delay 3, resolution 1e-5, stiffness 713.444, \
                  damping 3.56722, damping_time_constant 0.3e-3";
    let said = line(&report(values).to_text(), PERIOD);
    assert!(said.starts_with("from 7.489"), "{said}");
}

/// Time constants on both sides of a stretch that fails pass: the limit is the end of the stretch that
/// is known to pass from the value on.
#[test]
fn a_limit_stops_at_values_between_that_fail() {
    let of = |tau: &str| {
        report(&format!(
            "viscous 6.1138, coulomb 1, period 1e-3, delay 5, stiffness 1000, damping 5, \
             damping_time_constant {tau}, smooth"
        ))
    };
    for (tau, relation) in [("2e-3", "at least 0.0014"), ("0.5e-3", "at most 0.0012")] {
        let said = line(&of(tau).to_text(), FILTER);
        assert!(said.starts_with(relation), "{said}");
    }
    assert_ne!(of("1.3335e-3").verdict, Verdict::Passive);
}

/// Where less damping does not pass, what is exported says how much there has to be.
#[test]
fn exported_damping_has_a_smallest_beside_its_largest() {
    let found = |values: &str, target| constants(&wall::scene(values), target).unwrap();
    for values in [
        "viscous 4/3, coulomb 4, delay 1, damping 0.4",
        "viscous 4/3, coulomb 4, delay 1",
    ] {
        let late = found(values, Target::C);
        assert_eq!(
            (late.min_damping, late.max_damping),
            (Some(0.16667), Some(0.63714))
        );
        let source = late.to_source().replace("\n * ", " ");
        for says in [
            "#define TEST_MIN_DAMPING 0.16667 /* N s/m, with TEST_STIFFNESS",
            "#define TEST_MAX_DAMPING 0.63714 /* N s/m, with TEST_STIFFNESS",
            "Less damping than the smallest, or none, does not pass or is not shown to.",
        ] {
            assert!(source.contains(says), "{source}");
        }
    }
    let late = "viscous 4/3, coulomb 4, delay 1, damping 0.4";
    let source = found(late, Target::OpenHaptics).to_source();
    assert!(
        source.contains("kMinDamping = 0.00016667; /* N s/mm"),
        "{source}"
    );
    let source = found(late, Target::Chai3d)
        .to_source()
        .replace("\n * ", " ");
    assert!(
        source.contains("is not shown to hold with less"),
        "{source}"
    );
    let plain = found("viscous 3/4, coulomb 5/4, damping 0.1", Target::C);
    assert_eq!(plain.min_damping, None);
    assert!(!plain.to_source().contains("MIN_DAMPING"));
}

/// The largest and the smallest values of constants hold with the tolerance that the scene gives their parameter,
/// in the same ratio to them.
#[test]
fn the_ends_of_constants_hold_over_their_own_tolerance() {
    let of = |values: &str| constants(&wall::scene(values), Target::C).unwrap();
    // Colgate's bound 2b/T is 2, and of a quarter more 1.6; of B it is b − KT/2 = ½, and 0.4.
    for (values, stiffness, damping) in [
        ("stiffness 0.75 … 1.25", 1.6, 0.375),
        ("damping 3/16 … 5/16", 1.375, 0.4),
        ("damping 1/4", 1.5, 0.5),
    ] {
        let found = of(&format!("viscous 1, coulomb 9, {values}"));
        let ends = [found.max_stiffness, found.max_damping].map(Option::unwrap);
        for (end, border) in ends.into_iter().zip([stiffness, damping]) {
            assert!((0.9999 * border..=border).contains(&end), "{values}: {end}");
        }
        let source = found.to_source();
        let is_said = source.contains("tolerance");
        assert_eq!(is_said, values.contains('…'), "{source}");
    }
    // Behind a delay one value of the damping passes from 1/6 to 0.63715.
    let values = |damping: f64| {
        let exact = BigRational::from_float(damping).unwrap();
        let [lo, hi] = ["0.9", "1.1"].map(|factor| &exact * wall::q(factor));
        format!("viscous 4/3, coulomb 4, delay 1, damping {lo} … {hi}")
    };
    let found = of(&values(0.375));
    let verdict = |damping: f64| report(&values(damping)).verdict;
    let [least, most] = [found.min_damping, found.max_damping].map(Option::unwrap);
    assert!((0.18518..0.1853).contains(&least), "{least}");
    assert!((0.5791..0.57923).contains(&most), "{most}");
    assert_eq!([least, most].map(verdict), [Verdict::Passive; 2]);
    assert_eq!([0.185, 0.5793].map(verdict), [Verdict::Depends; 2]);
}

/// Beyond 2⁴⁰ times what the scene has, where the values that pass are one stretch.
#[test]
fn a_border_far_from_the_scene_is_found() {
    let text = "[device]\ncoulomb = \"1e3 N\"\n[sampling]\nperiod = \"1 ms\"\nlatency = \"0.1 ms\"\n[encoder]\n\
                resolution = \"1 um\"\n[wall]\nstiffness = \"K N/m\"\n[operator]\nmax_speed = \"1 mm/s\"\n";
    let of = |stiffness: &str| {
        let scene = Scene::from_toml("far", &text.replace('K', stiffness)).unwrap();
        check(&scene).to_text()
    };
    // The border does not depend on the scene's own stiffness.
    for stiffness in ["1e-6", "1e6"] {
        let text = of(stiffness);
        assert!(text.contains("8.8073e8 N/m up to 1 mm/s"), "{text}");
    }
}

/// Of a period from one to another the scene's own is one where it passes.
#[test]
fn a_shortest_period_is_not_above_one_that_passes() {
    let text = "[device]\ncoulomb = \"1e9 N\"\n[sampling]\nperiod = \"1 ms\"\n[encoder]\nresolution = \"1 um\"\n[wall]\n\
                stiffness = \"1 N/m\"\ndamping = \"0.001 N s/m\"\n[operator]\nmax_speed = \"1 mm/s\"\n";
    let with = |period: &str| {
        let text = text.replace("period = \"1 ms\"", &format!("period = \"{period} ms\""));
        check(&Scene::from_toml("short", &text).unwrap())
    };
    let said = with("1").to_text();
    let (_, rest) = said
        .split_once("sampling period T: from ")
        .expect("a range");
    let (shortest, _) = rest.split_once(" to ").expect("a range");
    assert!(shortest.parse::<f64>().unwrap() <= 1.0, "{said}");
    assert_eq!(with(shortest).verdict, Verdict::Passive);
}

/// A factor of two of the scene's own value may fall just short of a border, where cells tell of no long stretch: that is
/// not the border. The rates that pass are those from 1046.8867 to 21766.982 Hz, by κ of the lag at 60 digits.
#[test]
fn a_border_just_behind_a_factor_of_two_is_found() {
    let scene = |rate: &str| {
        let text = format!(
            "[device]\nviscous = \"0.000426 N m s/rad\"\ncoulomb = \"0.000273 N m\"\n[sampling]\nrate = \"{rate} Hz\"\n\
             [encoder]\nresolution = \"0.000297 rad\"\n[wall]\nstiffness = \"0.447 N m/rad\"\n\
             damping = \"1.74e-05 N m s/rad\"\n[amplifier]\ntime_constant = \"0.0013 s\"\n\
             [operator]\nmax_speed = \"0.515 rad/s\"\n"
        );
        check(&Scene::from_toml("lag", &text).unwrap()).to_text()
    };
    for now in ["21740", "21765", "5000", "1359", "10871"] {
        let text = scene(now);
        let words = line(&text, "sampling rate 1/T");
        let words: Vec<&str> = words.split_whitespace().collect();
        let ["from", lo, "to", hi, "Hz", ..] = words.as_slice() else {
            panic!("{text}");
        };
        let [lo, hi] = [lo, hi].map(|x| x.parse::<f64>().unwrap());
        // Each is bracketed to 2⁻¹² of a factor of two, and printed inward in five digits.
        assert!((1046.88..1047.2).contains(&lo), "{now}: {lo}");
        assert!((21755.0..21767.0).contains(&hi), "{now}: {hi}");
    }
}
