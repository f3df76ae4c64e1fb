//! The groups of intervals and runs: what the claims say of the energy ledger.

use serde_json::{Value, json};

use crate::build::{Dice, counts, interval, ratio, test};
use crate::{Group, Test, cover, linear, wrong};

/// Every group, in the order of their numbers.
/// Makes a group.
type Make = fn() -> Group;

/// The groups in their order: the name of each and how it is made.
pub(super) const ALL: [(&str, Make); 13] = [
    ("errata", errata),
    ("intervals", intervals),
    ("edges", edges),
    ("big", big),
    ("counts", counted),
    ("jitter", jitter),
    ("runs", runs),
    ("effects", effects),
    ("regions", cover::regions),
    ("linear", linear::group),
    ("motion", cover::motion),
    ("refusals", cover::refusals),
    ("wrong_formulas", wrong::group),
];

/// Every pair on a grid of 1/16 tick over [−3, 3]² that violates (22): 425 of 9409.
fn errata() -> Group {
    let mut tests = Vec::new();
    for i in -48_i64..=48 {
        for j in -48_i64..=48 {
            // E_g = ½D² + D(ρ₁ − ½) against ½d² + ½|d|, all times 512.
            let (n0, n1) = (i.div_euclid(16), j.div_euclid(16));
            let (ticks, rho, d) = (n1 - n0, j.rem_euclid(16), (j - i).abs());
            let generated = 16 * (16 * ticks * ticks + ticks * (2 * rho - 16));
            if generated <= d * d + 16 * d {
                continue;
            }
            let comment = "generates more than (22) allows, by the account of the paper";
            let request = interval(&ratio(i, 16), &ratio(j, 16), "3/5", "3/5", "1");
            tests.push(test(comment, &["Bound22Violated"], request));
        }
    }
    // Exactly where the criterion meets equality, for the same moves.
    for (beta, sigma) in [
        ("1/2", "1/2"),
        ("3/4", "3/8"),
        ("2/5", "11/20"),
        ("1/4", "5/8"),
    ] {
        for (from, to) in [
            ("1", "1/2"),
            ("0", "-1/2"),
            ("-2", "-5/2"),
            ("3", "3/2"),
            ("1/2", "1"),
        ] {
            let request = interval(from, to, beta, sigma, "1");
            tests.push(test(
                "the criterion at or near equality",
                &["CriterionBorder"],
                request,
            ));
        }
    }
    Group {
        name: "errata",
        header: "What does not hold as printed: the bound (22), and E_g ≤ E_d for the quantized spring.",
        claims: vec!["ERR-21/22", "ERR-27", "TH-LIN", "TH-QUANT"],
        notes: vec![
            (
                "Bound22Violated",
                "generated_quantized is above bound_22, and within bound_quantized; generated_linear is within bound_22",
            ),
            (
                "CriterionBorder",
                "the margin of the criterion is zero, or close to it",
            ),
        ],
        tests,
    }
}

fn intervals() -> Group {
    let frictions = [
        ("3/5", "3/5"),
        ("2/5", "3/5"),
        ("3/5", "2/5"),
        ("0", "0"),
        ("1", "1/10"),
    ];
    let mut tests = Vec::new();
    for from in [-2_i64, 0, 1] {
        for (to, (beta, sigma)) in (-3..=3).zip(frictions.iter().cycle()) {
            let request = interval(&ratio(from, 1), &ratio(to, 1), beta, sigma, "1");
            tests.push(test("whole ticks", &["WholeTicks"], request));
        }
    }
    let mut dice = Dice::new(1);
    for _ in 0..300 {
        let (beta, sigma) = dice.pick(&frictions);
        let (from, to) = (dice.fraction(-9, 9, 16), dice.fraction(-9, 9, 16));
        let request = interval(&from, &to, beta, sigma, "1");
        tests.push(test("off the grid", &["OffGrid"], request));
    }
    for _ in 0..60 {
        let xi = dice.fraction(-9, 9, 16);
        let request = interval(&xi, &xi, "3/5", "3/5", "1");
        tests.push(test(
            "nothing moves: no margin, and the criterion holds",
            &["Still"],
            request,
        ));
    }
    Group {
        name: "intervals",
        header: "The ledger row of one interval between exact positions.",
        claims: vec![
            "EQ-16/17",
            "EQ-19/20",
            "EQ-21a",
            "EQ-23..26",
            "EQ-27",
            "TH-LIN",
            "TH-QUANT",
            "TH-INTERVAL",
        ],
        notes: vec![
            ("WholeTicks", "both positions are whole ticks"),
            ("OffGrid", "positions anywhere, on either side of zero"),
            ("Still", "d = 0: margin is null, criterion_holds is true"),
        ],
        tests,
    }
}

fn edges() -> Group {
    let mut tests = Vec::new();
    // Just above and just below a tick, on both sides and in both directions.
    let steps = [
        ratio(1, 1_000_000_007),
        ratio(-1, 1_000_000_007),
        ratio(1, 1 << 40),
        ratio(0, 1),
    ];
    for tick in [-2_i64, -1, 0, 1, 2] {
        for step in &steps {
            for to in [tick - 1, tick, tick + 1] {
                let near = sum(&ratio(tick, 1), step);
                for (from, to) in [(near.clone(), ratio(to, 1)), (ratio(to, 1), near.clone())] {
                    let request = interval(&from, &to, "3/5", "2/5", "1");
                    tests.push(test("next to a tick", &["TickEdge"], request));
                }
            }
        }
    }
    // The margin is exactly zero: σ = ½ − v(β − ½).
    for d in 1_i64..=40 {
        for (beta, from) in [("1/4", "0"), ("3/4", "-1/3")] {
            let quarter = if beta == "1/4" { d } else { -d };
            let sigma = ratio(4 * 8 + quarter * 2, 64);
            if sigma.starts_with('-') {
                continue;
            }
            let to = sum(from, &ratio(d, 8));
            let request = interval(from, &to, beta, &sigma, "1");
            tests.push(test(
                "margin zero: equality is passive",
                &["MarginZero"],
                request,
            ));
        }
    }
    // TH-LIN with equality: from a whole tick downward, β = σ = ½: net energy is exactly zero.
    for d in 1_i64..=40 {
        let request = interval("3", &sum("3", &ratio(-d, 8)), "1/2", "1/2", "1");
        tests.push(test(
            "the bound of TH-LIN is reached",
            &["NetZero"],
            request,
        ));
    }
    Group {
        name: "edges",
        header: "Borders: ticks, equality in the criterion, equality in the bound.",
        claims: vec!["TH-LIN", "TH-QUANT", "TH-INTERVAL", "EQ-27"],
        notes: vec![
            (
                "TickEdge",
                "a position is a whole tick, or closer to one than doubles near a large position could say",
            ),
            ("MarginZero", "the criterion holds with equality"),
            ("NetZero", "net_linear is zero: not a violation"),
        ],
        tests,
    }
}

fn big() -> Group {
    let mut dice = Dice::new(2);
    let mut tests = Vec::new();
    let digits = |dice: &mut Dice, n: usize| -> String {
        let first = dice.between(1, 9).to_string();
        (1..n).fold(first, |text, _| text + &dice.between(0, 9).to_string())
    };
    for n in [20_usize, 30, 40, 60, 100, 200, 400] {
        for _ in 0..12 {
            let sign = dice.pick(&["", "-"]);
            let from = format!("{sign}{}/{}", digits(&mut dice, n), digits(&mut dice, n));
            let to = format!("{}/{}", digits(&mut dice, n), digits(&mut dice, n));
            let beta = format!("{}/{}", digits(&mut dice, n), digits(&mut dice, n));
            let request = interval(&from, &to, &beta, "3/5", "1");
            tests.push(test(format!("{n} digits"), &["Big"], request));
        }
    }
    for exponent in [19_i64, 38, 77, 300, 1000] {
        let far = format!("1e{exponent}");
        let tiny = format!("1e-{exponent}");
        tests.push(test(
            "far away",
            &["Decimal"],
            interval(&far, "0", "1", "1", "1"),
        ));
        tests.push(test(
            "a tiny move",
            &["Decimal"],
            interval("0", &tiny, "1", "1", "1"),
        ));
        tests.push(test(
            "a tiny friction",
            &["Decimal"],
            interval("0", "2", &tiny, &tiny, "1"),
        ));
    }
    Group {
        name: "big",
        header: "Numbers that no machine integer holds.",
        claims: vec!["TH-LIN", "TH-QUANT"],
        notes: vec![
            ("Big", "numerators and denominators of many digits"),
            ("Decimal", "decimal exponents"),
        ],
        tests,
    }
}

fn counted() -> Group {
    let mut tests = Vec::new();
    for ticks in -6_i64..=6 {
        for (beta, sigma) in [
            ("3/5", "3/5"),
            ("2/5", "3/5"),
            ("3/5", "2/5"),
            ("1/4", "1/4"),
            ("2", "1/2"),
        ] {
            for dtau in ["1", "1/3", "2"] {
                let request = counts(
                    ticks.rem_euclid(4) - 2,
                    ticks.rem_euclid(4) - 2 + ticks,
                    beta,
                    sigma,
                    dtau,
                );
                tests.push(test(format!("{ticks} ticks"), &["Counts"], request));
            }
        }
    }
    Group {
        name: "counts",
        header: "What encoder counts say of an interval: exact enclosures and three-valued answers. null is 'it depends'; a null end of a margin is unbounded.",
        claims: vec!["TH-LIN", "TH-QUANT", "TH-INTERVAL"],
        notes: vec![(
            "Counts",
            "only the tick of each position is known: n ≤ ξ < n + 1. Ends are those of the closure",
        )],
        tests,
    }
}

fn jitter() -> Group {
    let mut dice = Dice::new(3);
    let mut tests = Vec::new();
    for i in 0..200 {
        let dtau = if i % 2 == 0 {
            dice.fraction(1, 1, 1)
        } else {
            String::new()
        };
        let dtau = if dtau.is_empty() || i % 4 == 0 {
            ratio(dice.between(1, 60), dice.between(10, 30))
        } else {
            dtau
        };
        let (from, to) = (dice.fraction(-5, 5, 12), dice.fraction(-5, 5, 12));
        let (beta, sigma) = (dice.fraction(0, 2, 20), dice.fraction(0, 2, 20));
        let request = interval(&from, &to, &beta, &sigma, &dtau);
        tests.push(test(format!("Δτ = {dtau}"), &["Jitter"], request));
    }
    Group {
        name: "jitter",
        header: "Intervals shorter and longer than a sampling period.",
        claims: vec!["TH-JITTER", "TH-INTERVAL"],
        notes: vec![(
            "Jitter",
            "for Δτ > 1 the criterion implies nothing; the ledger is still exact",
        )],
        tests,
    }
}

fn walk(dice: &mut Dice, len: usize, denominator: i64) -> Vec<String> {
    let mut at = dice.between(-2 * denominator, 2 * denominator);
    let mut walk = vec![ratio(at, denominator)];
    for _ in 1..len {
        at += dice.between(-2 * denominator, 2 * denominator);
        walk.push(ratio(at, denominator));
    }
    walk
}

fn runs() -> Group {
    let mut dice = Dice::new(4);
    let mut tests = Vec::new();
    for i in 0..60_usize {
        let denominator = dice.pick(&[1_i64, 2, 7, 16, 60]);
        let positions = walk(&mut dice, 2 + i % 9, denominator);
        let (beta, sigma) = (dice.fraction(0, 2, 10), dice.fraction(0, 2, 10));
        let request = json!({"op": "run", "xi": positions, "beta": beta, "sigma": sigma});
        tests.push(test("exact positions", &["Telescope"], request));
    }
    for i in 0..40_usize {
        let counts: Vec<Value> = walk(&mut dice, 2 + i % 9, 1)
            .iter()
            .map(|n| json!(n))
            .collect();
        let (beta, sigma) = (dice.fraction(0, 2, 10), dice.fraction(0, 2, 10));
        let request = json!({"op": "run", "count": counts, "beta": beta, "sigma": sigma});
        tests.push(test("counts", &["TightTotals"], request));
    }
    for i in 0..40_usize {
        let positions = walk(&mut dice, 2 + i % 5, 12);
        let dtau: Vec<String> = (1..positions.len())
            .map(|_| ratio(dice.between(1, 30), 12))
            .collect();
        let request =
            json!({"op": "run", "xi": positions, "beta": "3/5", "sigma": "3/5", "dtau": dtau});
        tests.push(test("uneven sampling", &["Telescope"], request));
    }
    Group {
        name: "runs",
        header: "Sequences of positions: rows and totals.",
        claims: vec!["TH-TELESCOPE", "TH-RUN"],
        notes: vec![
            (
                "Telescope",
                "the totals of both accounts differ by the change of ½ρ(1 − ρ)",
            ),
            (
                "TightTotals",
                "the total of counts is enclosed as a whole: a residue that ends one interval starts the next",
            ),
        ],
        tests,
    }
}

fn effects() -> Group {
    let mut dice = Dice::new(5);
    let mut tests: Vec<Test> = Vec::new();
    let kinds: [(&'static str, Value, usize); 10] = [
        ("Unilateral", json!({"unilateral": true}), 30),
        ("Saturation", json!({"max_force": "7/3"}), 30),
        ("ForceStep", json!({"force_step": "2/3"}), 30),
        ("Delay", json!({"delay": 2}), 30),
        ("Damping", json!({"damping": "1/4"}), 30),
        ("NoEncoder", json!({"encoder": false}), 30),
        (
            "Combined",
            json!({"unilateral": true, "delay": 1, "damping": "1/3", "force_step": "1/2"}),
            10,
        ),
        ("Cost", json!({"delay": 1, "damping": "1/2"}), 10),
        (
            "Cost",
            json!({"delay": 3, "damping": "14/9", "force_step": "1/2"}),
            10,
        ),
        (
            "Combined",
            json!({"unilateral": true, "max_force": "5/2", "delay": 1, "force_step": "1/2"}),
            30,
        ),
    ];
    for (flag, effect, count) in &kinds {
        for i in 0..*count {
            let positions = walk(&mut dice, 3 + i % 5, 6);
            let mut request = json!({"op": "run", "xi": positions, "beta": "2", "sigma": "3/2"});
            if let (Value::Object(fields), Value::Object(effect)) = (&mut request, effect) {
                fields.extend(effect.clone());
            }
            tests.push(test("exact positions", &[*flag], request));
        }
    }
    Group {
        name: "effects",
        header: "Effects beyond sampling and encoder. The force of the sample q, k late, is −(q + B(q − q′)), zero outside a one-sided wall, then rounded to force steps δ⌊u/δ + ½⌋, then limited. Before the first sample the device stood there. net_* subtract what the storages of delay and damping gain (extra_storage).",
        claims: vec![
            "TH-UNI",
            "TH-LAW",
            "TH-DAC",
            "TH-DELAY",
            "TH-DAMP",
            "TH-LTI",
            "TH-SMOOTH",
        ],
        notes: vec![
            ("Unilateral", "the wall is ξ ≥ 0 only"),
            ("Saturation", "the actuator's force is limited"),
            ("ForceStep", "the force comes in steps"),
            ("Delay", "the force is whole samples late"),
            ("Damping", "virtual damping by backward difference"),
            (
                "NoEncoder",
                "the position is known exactly; both accounts are the same, and the bounds are ½d²",
            ),
            (
                "Cost",
                "a delay with damping costs λ of viscous friction, not the sum of both; where it is no fraction the margin is enclosed",
            ),
            ("Combined", "several at once"),
        ],
        tests,
    }
}

/// The sum of two fractions as text.
fn sum(a: &str, b: &str) -> String {
    let parse = |text| passivity_scene::number::parse(text).expect("a fraction of this file");
    (parse(a) + parse(b)).to_string()
}
