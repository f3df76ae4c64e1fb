//! How much work a request may ask for.

use passivity_oracle::protocol::answer;

fn ask(line: &str) -> String {
    let mut out = Vec::new();
    answer(line.as_bytes(), &mut out);
    String::from_utf8(out).unwrap()
}

#[test]
fn a_request_asks_for_bounded_work_for_its_length() {
    let number = |bits: u32, i: usize| {
        format!(
            "\"{}/{}\"",
            i * i + 1,
            (num_bigint::BigInt::from(1) << bits) + i
        )
    };
    let run = |positions: Vec<String>, more: &str| {
        format!(
            r#"{{"op": "run", "xi": [{}], {more}}}"#,
            positions.join(",")
        )
    };
    let small = r#""beta": "3", "sigma": "3""#;
    let wide = format!(
        r#""beta": "1/{}7", "sigma": "1/{}9""#,
        "1".repeat(1200),
        "1".repeat(1200)
    );
    let counted = |n: usize| (0..n).map(|i| (i % 7).to_string()).collect::<Vec<_>>();
    let fresh = |n: usize, bits| (1..=n).map(|i| number(bits, i)).collect::<Vec<_>>();
    let start = std::time::Instant::now();
    for (what, request) in [
        (
            "a long memory",
            run(counted(18_000), &format!(r#"{small}, "delay": 1000"#)),
        ),
        (
            "fresh fractions in a memory",
            run(fresh(100, 332), &format!(r#"{small}, "delay": 1000"#)),
        ),
        ("wide friction", run(counted(20_000), &wide)),
        ("wide positions", run(fresh(100, 4000), small)),
        ("fresh fractions", run(fresh(12_000, 62), small)),
        (
            "long damping behind a delay",
            run(
                counted(3),
                &format!(r#"{small}, "delay": 22, "damping": {}"#, number(2000, 1)),
            ),
        ),
    ] {
        let answer = ask(&request);
        assert!(
            answer.contains(r#""kind": "too_much_work""#),
            "{what}: {}",
            &answer[..200.min(answer.len())]
        );
    }
    // Each of these took from half a minute to ten when nothing bounded them.
    assert!(
        start.elapsed() < std::time::Duration::from_secs(120),
        "{:?}",
        start.elapsed()
    );
    for (what, request) in [
        ("many positions", run(counted(50_000), small)),
        (
            "a memory",
            run(
                counted(500),
                &format!(r#"{small}, "delay": 1000, "damping": "1/3""#),
            ),
        ),
        (
            "fractions of one denominator",
            run(
                (0..2000).map(|i| format!("\"{i}/1000000\"")).collect(),
                small,
            ),
        ),
        (
            "damping behind a delay",
            run(
                counted(3),
                &format!(r#"{small}, "delay": 22, "damping": {}"#, number(62, 1)),
            ),
        ),
        ("fresh fractions", run(fresh(500, 40), small)),
        ("wide numbers", run(counted(8), &wide)),
    ] {
        let answer = ask(&request);
        assert!(
            answer.contains(r#""totals""#),
            "{what}: {}",
            &answer[..200.min(answer.len())]
        );
    }
}

/// A matrix of joints that act on each other is eliminated for every limit of each of them.
#[test]
fn a_check_of_many_joints_asks_for_bounded_work() {
    let check = |joints: usize, tolerance: &str| {
        let joint = format!(
            r#"{{"viscous": "1e-3 N m s/rad{tolerance}", "coulomb": "1e-2 N m", "max_speed": "1 rad/s"}}"#
        );
        let row = |i: usize| {
            let entry = |j: usize| match i == j {
                true => r#""1000 N m/rad""#.to_owned(),
                false => format!(r#""{}/997 N m/rad""#, 100 + i + j),
            };
            format!(
                "[{}]",
                (0..joints).map(entry).collect::<Vec<_>>().join(", ")
            )
        };
        let rows: Vec<String> = (0..joints).map(row).collect();
        ask(&format!(
            r#"{{"op": "check", "scene": {{"joint": [{}], "sampling": {{"period": "1 ms"}},
                "wall": {{"stiffness_matrix": [{}]}}}}}}"#,
            vec![joint; joints].join(", "),
            rows.join(", ")
        ))
    };
    let start = std::time::Instant::now();
    let answer = check(12, "");
    assert!(answer.contains(r#""kind": "too_much_work""#), "{answer}");
    assert!(start.elapsed() < std::time::Duration::from_secs(2));
    for (joints, tolerance) in [(6, " ± 10%"), (7, "")] {
        let answer = check(joints, tolerance);
        assert!(answer.contains(r#""verdict":"#), "{answer}");
    }
}

/// Tolerances of filtered damping behind a delay are decided in pieces: up to some, and not behind a long one.
#[test]
fn a_check_asks_for_bounded_work() {
    let check = |delay: u32, tolerance: &str| {
        ask(&format!(
            r#"{{"op": "check", "scene": {{"device": {{"viscous": "11.28 N s/m"}},
                "sampling": {{"period": "0.5 ms ± 10%", "delay": {delay}}},
                "wall": {{"stiffness": "101 N/m{tolerance}", "damping": "16 N s/m{tolerance}",
                    "damping_time_constant": "39 us ± 1%"}}}}}}"#
        ))
    };
    let answer = check(20, " ± 0.1%");
    assert!(answer.contains(r#""kind": "too_much_work""#), "{answer}");
    assert!(answer.contains(r#""at": "scene""#), "{answer}");
    let answer = check(5, "");
    assert!(answer.contains(r#""verdict":"#), "{answer}");
}

/// Of long numbers a check asks for more work than of short ones.
#[test]
fn a_check_of_long_numbers_asks_for_more_work() {
    for (digits, is_refused) in [(490, true), (1, false)] {
        let threes = "3".repeat(digits);
        let answer = ask(&format!(
            r#"{{"op": "check", "scene": {{"device": {{"viscous": "11.28 N s/m"}},
                "sampling": {{"period": "0.5 ms ± 1%", "delay": 8}},
                "wall": {{"stiffness": "101.{threes} N/m ± 1%", "damping": "1.{threes} N s/m ± 1%"}}}}}}"#
        ));
        assert_eq!(
            answer.contains(r#""kind": "too_much_work""#),
            is_refused,
            "{answer}"
        );
    }
}

/// One long number among short ones, damping or a controller that costs a thousand bits, and tolerances as wide: each took
/// from 8 to 40 s, most of it while the scene was read.
#[test]
fn a_check_of_numbers_far_apart_asks_for_bounded_work() {
    let point = r#""dimensionless": {"beta": "1", "sigma": "1"}"#;
    let at = |friction: &str, damping: &str, period: &str, stiffness: &str| {
        format!(
            r#""device": {{"viscous": "{friction}"}}, "encoder": {{"resolution": "0.001 m"}},
                "sampling": {{"period": "{period}", "delay": 3}},
                "wall": {{"stiffness": "{stiffness}", "damping": "{damping}"}}"#
        )
    };
    let damped = |delay: u32, damping: &str, more: &str| {
        format!(
            r#"{point}, "sampling": {{"delay": {delay}}}, "wall": {{"damping": "{damping}"{more}}}"#
        )
    };
    let filtered = |constant: &str| format!(r#", "damping_time_constant": "{constant}""#);
    let controller = |last: &str| {
        format!(
            r#"{point}, "controller": {{"numerator": ["0", "0", "0", "1", "{last}", "-{last}"]}}"#
        )
    };
    let start = std::time::Instant::now();
    let few = [
        (damped(22, "1/3", &filtered("1e-499")), true),
        (damped(20, "1/3", &filtered("1e-499")), true),
        (at("1e300 N s/m", "1e300 N s/m", "1 ms", "1 N/m"), true),
        (
            at("1e300 N s/m ± 100%", "0 … 1e300 N s/m", ">0.25 s", ">1 N/m"),
            true,
        ),
        (damped(3, "1e300", ""), true),
        (damped(22, "1e12", ""), true),
        (controller("1e300"), true),
        (damped(1, "1e8", &filtered("1e300")), true),
        (damped(1, "30", &filtered("100")), false),
        (damped(22, "1/3", &filtered("1e-10")), false),
        (damped(22, "1e3", ""), false),
        (damped(3, "1e30", ""), false),
        (
            at("12 N s/m", "10 N s/m", "1 ms ± 1%", "100 N/m ± 10%"),
            false,
        ),
        (controller("1e3"), false),
    ];
    for (scene, is_refused) in few {
        let answer = ask(&format!(r#"{{"op": "check", "scene": {{{scene}}}}}"#));
        assert_eq!(
            answer.contains(r#""kind": "too_much_work""#),
            is_refused,
            "{scene}: {answer}"
        );
        assert_eq!(answer.contains(r#""verdict":"#), !is_refused, "{scene}");
    }
    let seconds = start.elapsed().as_secs_f64();
    assert!(seconds < 30.0, "{seconds} s");
    let run = |damping: &str| {
        ask(&format!(
            r#"{{"op": "run", "xi": ["1", "1/2", "0"], "beta": "1", "sigma": "1", "delay": 3, "damping": "{damping}"}}"#
        ))
    };
    assert!(run("1e300").contains(r#""kind": "too_much_work""#));
    assert!(run("1e30").contains(r#""totals""#));
}

/// A controller of long fractions, one that is slow to forget, or one that remembers many samples asks for more work than
/// others: the first took 20 s, the second 90 s, the third 27 s, and the next four from 3 to 14 s.
#[test]
fn a_check_of_a_controller_asks_for_bounded_work() {
    let fractions = |n: u32, bits: u32| {
        let one = num_bigint::BigInt::from(1);
        let mut numbers = (1..=n).map(|i| {
            format!(
                "\"{}/{}\"",
                (&one << bits) + 3 * i,
                (&one << bits) + 2 * i + 1
            )
        });
        let first = numbers.next().unwrap_or_default();
        numbers.fold(first, |list, number| list + "," + &number)
    };
    let one = || r#""1""#.to_owned();
    let after = |others: &str| format!(r#""1"{others}"#);
    let zeros = |n: usize| r#","0""#.repeat(n);
    let start = std::time::Instant::now();
    for (numerator, denominator, is_refused) in [
        (fractions(64, 100), r#""1""#, true),
        (fractions(24, 200), r#""1""#, true),
        (one(), r#""1", "-1.998", "0.998001""#, true),
        (
            vec![r#""1""#; 64].join(","),
            &after(&",\"0.015\"".repeat(63)),
            true,
        ),
        (one(), &after(&(zeros(39) + r#","0.5""#)), true),
        (one(), &after(&(zeros(62) + r#","0.5""#)), true),
        (one(), &after(&(zeros(62) + r#","0.01""#)), true),
        (fractions(8, 60), r#""1""#, false),
        // Poles of 0.99, twelve samples that are remembered, and zeros that are no order.
        (one(), r#""1", "-1.98", "0.9801""#, false),
        (one(), &after(&",\"0.05\"".repeat(11)), false),
        (one(), &after(&zeros(63)), false),
        (
            r#""1.5", "-0.5""#.to_owned(),
            r#""1", "-0.5", "0.05""#,
            false,
        ),
        (vec![r#""1.5""#; 64].join(","), r#""1""#, false),
    ] {
        let answer = ask(&format!(
            r#"{{"op": "check", "scene": {{"dimensionless": {{"beta": "300", "sigma": "200"}},
                "controller": {{"numerator": [{numerator}], "denominator": [{denominator}]}}}}}}"#
        ));
        assert_eq!(
            answer.contains(r#""kind": "too_much_work""#),
            is_refused,
            "{answer}"
        );
        assert_eq!(answer.contains(r#""verdict":"#), !is_refused, "{answer}");
    }
    let seconds = start.elapsed().as_secs_f64();
    assert!(seconds < 15.0, "{seconds} s");
    // What is not stable is said to be so.
    let answer = ask(
        r#"{"op": "check", "scene": {"dimensionless": {"beta": "3", "sigma": "2"},
            "controller": {"numerator": ["1"], "denominator": ["1", "0", "1"]}}}"#,
    );
    assert!(answer.contains("not stable"), "{answer}");
}

/// However long its seven numbers are, and without a refusal: each of the first three took more than ten seconds, the last
/// one more than forty.
#[test]
fn a_motion_takes_little_work() {
    let long = |first: char| format!("{first}{}", "7".repeat(1000));
    let below = |first| {
        format!(
            "1{}/{}",
            "3".repeat(599),
            long(first)[..600].to_owned() + "1"
        )
    };
    for (mu, beta, tau, others) in [
        ("1", "1e-1200", "1", ["0", "1", "0"]),
        ("1e1200", "1", "1", ["0", "1", "0"]),
        ("1", "1", "1e-1200", ["0", "1", "0"]),
        (
            &*below('2'),
            &*below('3'),
            &*below('5'),
            [&*long('1'), &*long('9'), &*long('4')],
        ),
    ] {
        let [xi, velocity, force] = others;
        let start = std::time::Instant::now();
        let answer = ask(&format!(
            r#"{{"op": "motion", "mu": "{mu}", "beta": "{beta}", "sigma": "0", "tau": "{tau}", "xi": "{xi}",
                "velocity": "{velocity}", "force": "{force}"}}"#
        ));
        let seconds = start.elapsed().as_secs_f64();
        assert!(
            answer.contains(r#""velocity": {"lo": "#),
            "{}",
            &answer[..200]
        );
        // Without optimisation and beside other tests: some milliseconds, and of the last some tenths of a second.
        assert!(seconds < 5.0, "{seconds} s: {mu} {beta} {tau}");
    }
}
