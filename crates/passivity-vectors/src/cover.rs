//! The groups beside the ledger: verdicts, motion in closed form, and what must be refused.

use serde_json::{Value, json};

use crate::Group;
use crate::build::{Dice, check, ratio, test};

pub(super) fn regions() -> Group {
    let values = [
        "0",
        "1/4",
        "499999999/1000000000",
        "1/2",
        "500000001/1000000000",
        "3/5",
        "2",
    ];
    let mut tests = Vec::new();
    for beta in values {
        for sigma in values {
            let request = check(beta, sigma, &json!({}));
            tests.push(test("at every speed", &["EverySpeed"], request));
        }
    }
    // Up to a speed: below, at and above the critical one, (σ − ½)/(½ − β) = 1 and 4.
    for (beta, sigma) in [
        ("2/5", "3/5"),
        ("1/4", "3/2"),
        ("3/5", "2/5"),
        ("1/4", "1/4"),
        ("3/5", "3/5"),
    ] {
        for speed in [
            "1/2",
            "999999999/1000000000",
            "1",
            "1000000001/1000000000",
            "4",
            "5",
        ] {
            let sections = json!({"operator": {"max_speed": speed}});
            tests.push(test(
                "up to a speed",
                &["SpeedBound"],
                check(beta, sigma, &sections),
            ));
        }
    }
    // TH-START: V² = v² + x²/μ with μ = 50.
    for (position, velocity) in [
        ("0", "1"),
        ("0", "2"),
        ("5", "1/2"),
        ("10", "0"),
        ("1", "99/100"),
        ("0", "1/3"),
    ] {
        for (beta, sigma) in [
            ("2/5", "3/5"),
            ("1/4", "3/2"),
            ("3/5", "2/5"),
            ("3/5", "3/5"),
        ] {
            let sections = json!({"start": {"position": position, "velocity": velocity}});
            tests.push(test(
                "from a start",
                &["Start"],
                check(beta, sigma, &sections),
            ));
        }
    }
    let effects: [(&'static str, Value); 7] = [
        ("Covered", json!({"wall": {"unilateral": true}})),
        ("Covered", json!({"wall": {"max_force": "50"}})),
        ("Covered", json!({"wall": {"force_step": "1/5"}})),
        ("Covered", json!({"wall": {"damping": "1/10"}})),
        ("Covered", json!({"sampling": {"delay": 1}})),
        (
            "Covered",
            json!({"sampling": {"delay": 2}, "wall": {"damping": "1/10", "force_step": "1/5", "unilateral": true}}),
        ),
        (
            "Covered",
            json!({"wall": {"max_force": "50", "damping": "1/10"}}),
        ),
    ];
    for (flag, sections) in &effects {
        for beta in ["2/5", "3/5", "3/2", "8/5", "27/10"] {
            for sigma in ["2/5", "3/5", "7/10", "1"] {
                tests.push(test("with effects", &[*flag], check(beta, sigma, sections)));
            }
        }
    }
    Group {
        name: "regions",
        header: "Verdicts on scenes. An answer of not_passive must come with a witness: a cycle that gains energy by (5) and (23).",
        claims: vec![
            "TH-REGION",
            "TH-ACTIVE",
            "TH-START",
            "TH-DELAY",
            "TH-DAMP",
            "TH-DAC",
            "TH-UNI",
        ],
        notes: vec![
            (
                "EverySpeed",
                "on and beside the lines β = ½ and σ = ½; equality holds",
            ),
            ("SpeedBound", "the operator keeps to a speed"),
            (
                "Start",
                "what holds of the device left alone from a position and a velocity; the verdict is about any operator",
            ),
            (
                "Covered",
                "effects that a theorem covers lower the criterion",
            ),
        ],
        tests,
    }
}

pub(super) fn motion() -> Group {
    let mut dice = Dice::new(6);
    let mut tests = Vec::new();
    while tests.len() < 120 {
        let beta = dice.pick(&["0", "2/5", "3/5", "1", "5"]);
        let mu = dice.pick(&["10", "50", "35/3"]);
        let request = json!({
            "op": "motion", "mu": mu, "beta": beta, "sigma": dice.fraction(0, 1, 10),
            "xi": dice.fraction(-20, 20, 8), "velocity": dice.fraction(-9, 9, 8),
            "force": ratio(dice.between(-41, 41), 2), "tau": ratio(dice.between(1, 8), 8),
        });
        let flag = if beta == "0" {
            "Parabola"
        } else {
            "Exponential"
        };
        let test = test("a piece of motion", &[flag], request);
        // Some turn round on the way: they are no piece.
        if test.result.is_some() {
            tests.push(test);
        }
    }
    Group {
        name: "motion",
        header: "Motion at a constant force in closed form, between decimals of 40 places. An answer passes when it is, or lies between, numbers that meet the enclosure widened by 1e-9 of its size.",
        claims: vec!["TH-START"],
        notes: vec![
            (
                "Parabola",
                "no viscous friction: the answer is one rational number",
            ),
            (
                "Exponential",
                "v(t) = v₀e^(−λt) + a·t·φ₁(−λt), ξ(t) = ξ₀ + v₀·t·φ₁(−λt) + a·t²·φ₂(−λt)",
            ),
        ],
        tests,
    }
}

pub(super) fn refusals() -> Group {
    let mut tests = Vec::new();
    let numbers = [
        "NaN",
        "inf",
        "-inf",
        "1/0",
        "0/0",
        "1e999999999",
        "-1e-999999999",
        "",
        " 1",
        "1 ",
        "1_000",
        "0x10",
        "1,5",
        "--1",
        "+-1",
        "1/2/3",
        "1/-2",
        "1.2/3",
        "1e",
        "e5",
        ".",
        "-",
        "½",
        "1e1.5",
        "١",
        "1\n",
        "1/",
        "/2",
    ];
    for number in numbers {
        for field in ["xi0", "beta", "dtau"] {
            let mut request = json!({"op": "interval", "xi0": "1", "xi1": "2", "beta": "1", "sigma": "1", "dtau": "1"});
            request[field] = json!(number);
            tests.push(test(
                format!("{field} is {number:?}"),
                &["NoNumber"],
                request,
            ));
        }
    }
    for (field, value) in [
        ("beta", json!("-1/2")),
        ("sigma", json!("-1")),
        ("dtau", json!("0")),
        ("dtau", json!("-1")),
        ("xi0", json!(null)),
        ("xi0", json!(true)),
        ("xi0", json!([1])),
        ("xi0", json!({})),
        ("xi2", json!("1")),
        ("max_force", json!("0")),
        ("delay", json!(-1)),
        ("delay", json!("1/2")),
        ("unilateral", json!("yes")),
    ] {
        let mut request = json!({"op": "interval", "xi0": "1", "xi1": "2", "beta": "1", "sigma": "1", "dtau": "1"});
        request[field] = value;
        tests.push(test(
            format!("{field} cannot be that"),
            &["OutOfRange"],
            request,
        ));
    }
    for request in [
        json!({}),
        json!({"op": "fly"}),
        json!({"op": "interval"}),
        json!({"op": "interval", "xi0": "1", "beta": "1", "sigma": "1"}),
        json!({"op": "interval", "count0": "1/2", "count1": "1", "beta": "1", "sigma": "1"}),
        json!({"op": "interval", "count0": 1, "count1": 0, "beta": "1", "sigma": "1", "encoder": false}),
        json!({"op": "run", "count": [1, 0], "beta": "1", "sigma": "1", "encoder": false}),
        json!({"op": "interval", "xi0": "1", "xi1": "2", "beta": {"lo": "1", "hi": "2", "more": "3"}, "sigma": "1"}),
        json!({"op": "motion", "mu": "1", "beta": {"lo": "1/4", "hi": "1/2"}, "sigma": "0", "xi": "0", "velocity": "1", "force": "0", "tau": "1"}),
        json!({"op": "run", "xi": [], "beta": "1", "sigma": "1"}),
        json!({"op": "run", "xi": ["1"], "beta": "1", "sigma": "1"}),
        json!({"op": "run", "xi": "1", "beta": "1", "sigma": "1"}),
        json!({"op": "run", "xi": ["1", "2"], "dtau": ["1", "1"], "beta": "1", "sigma": "1"}),
        json!({"op": "run", "xi": ["1", "2"], "count": [1, 2], "beta": "1", "sigma": "1"}),
        json!({"op": "check"}),
        json!({"op": "check", "scene": {"dimensionless": {"beta": "-1", "sigma": "1"}}}),
        json!({"op": "check", "scene": {"nonsense": {}}}),
        json!({"op": "motion", "mu": "0", "beta": "1", "sigma": "1", "xi": "0", "velocity": "1", "force": "0", "tau": "1"}),
        json!({"op": "motion", "mu": "1", "beta": "0", "sigma": "1", "xi": "0", "velocity": "1", "force": "-1", "tau": "1"}),
    ] {
        tests.push(test("not a request", &["NoRequest"], request));
    }
    Group {
        name: "refusals",
        header: "What must be answered with an error, and the next line served. The kind of the error is this library's; any error will do.",
        claims: vec![],
        notes: vec![
            (
                "NoNumber",
                "a text that spells no number, or one past the bounds of 4096 characters and exponents",
            ),
            (
                "OutOfRange",
                "a value of the wrong kind, or that the quantity cannot have",
            ),
            (
                "NoRequest",
                "no operation, or its fields are missing or contradict each other",
            ),
        ],
        tests,
    }
}
