//! The group of linear loops: any digital controller, filter, delay, latency and lag, on both sides of
//! the border.

use serde_json::{Value, json};

use crate::build::{Dice, check, ratio, test};
use crate::{Group, Test};

pub(super) fn group() -> Group {
    let mut tests = borders();
    tests.extend(edges());
    tests.extend(actuators());
    tests.extend(walls());
    tests.extend(random());
    tests.extend(refused());
    Group {
        name: "linear",
        header: "Verdicts on loops with memory, decided exactly. A figure that is no fraction is enclosed, and an answer passes whose enclosure meets it. A witness is a motion of one position a sample, repeated for ever, or a wave of steps A·cos(2πqh/p) off by at most a tick, as a formula. An implementation finds its own, and may compute the given ones again: gain_per_cycle is the exact gain where the response ends, else a lower bound.",
        claims: vec!["TH-LTI", "TH-LATENCY", "TH-LAG", "TH-DELAY", "TH-DAMP"],
        notes: vec![
            (
                "Border",
                "β is the cost λ, or below or above it by 10⁻⁹ or 10⁻³⁰",
            ),
            (
                "Edge",
                "σ beside ½‖c‖₁, and beside the best pattern across one edge of the encoder",
            ),
            (
                "Actuator",
                "a latency or a lag costs κ, decided by squares, with coth enclosed",
            ),
            (
                "Wall",
                "a one-sided or saturated wall with memory costs absolute tail sums",
            ),
            ("Random", "controllers made of poles inside the unit circle"),
            ("NoLoop", "a controller that no loop can have"),
        ],
        tests,
    }
}

fn asked(flag: &'static str, comment: &str, point: [&str; 2], sections: &Value) -> Test {
    test(comment, &[flag], check(point[0], point[1], sections))
}

/// β on both sides of λ, where σ is enough.
fn borders() -> Vec<Test> {
    let mut tests = Vec::new();
    let loops = [
        (
            "delay 1 with damping ½ costs 5/4",
            json!({"sampling": {"delay": 1}, "wall": {"damping": "1/2"}}),
            ["1.25", "1.249999999", "1.249999999999999999999999999999"],
        ),
        (
            "delay 1 with damping 2 costs 41/16",
            json!({"sampling": {"delay": 1}, "wall": {"damping": "2"}}),
            ["2.5625", "2.562499999", "2.562499999999999999999999999999"],
        ),
        (
            "filtered damping, a = ½ and B = 1, costs 5/6",
            json!({"wall": {"damping": "1", "damping_time_constant": "1"}}),
            ["5/6", "0.833333333", "0.833333333333333333333333333333"],
        ),
        (
            "filtered damping, a = 0.95 and B = 10, costs ½ + 10/39",
            json!({"wall": {"damping": "10", "damping_time_constant": "19"}}),
            ["59/78", "0.756410256", "0.756410256410256410256410256410"],
        ),
        (
            "delay 2 costs 5/2, at the lowest frequencies",
            json!({"sampling": {"delay": 2}}),
            ["2.5", "2.499999999", "2.499999999999999999999999999999"],
        ),
        (
            "c = (½, −1, 1.2, 0.4) costs 3.15",
            json!({"controller": {"numerator": ["0.5", "-1", "1.2", "0.4"]}}),
            ["3.15", "3.149999999", "3.149999999999999999999999999999"],
        ),
    ];
    for (comment, sections, betas) in &loops {
        for beta in betas {
            tests.push(asked("Border", comment, [beta, "10"], sections));
        }
    }
    // Up to a speed: equality at V, where (β − 5/4)V + (σ − 1) = 0.
    for sigma in ["2", "1.999999999"] {
        let sections = json!({"sampling": {"delay": 1}, "wall": {"damping": "1/2"}, "operator": {"max_speed": "4"}});
        let comment = "equality at the bound on the speed";
        tests.push(asked("Border", comment, ["1", sigma], &sections));
    }
    tests
}

/// σ on both sides of ½‖c‖₁ and of the best pattern.
fn edges() -> Vec<Test> {
    let mut tests = Vec::new();
    let patterns = json!({"controller": {"numerator": ["0.5", "-1", "1.2", "0.4"]}});
    for sigma in ["1.55", "1.549999999", "1.15", "1.149999999", "0.3"] {
        let comment = "½‖c‖₁ = 1.55, and the best pattern draws 1.15";
        tests.push(asked("Edge", comment, ["4", sigma], &patterns));
    }
    let filtered = json!({"wall": {"damping": "1", "damping_time_constant": "1"}});
    for sigma in ["1", "0.999999999", "0.7"] {
        let comment = "filtered damping, a = ½ and B = 1: ½‖c‖₁ = 1";
        tests.push(asked("Edge", comment, ["2", sigma], &filtered));
    }
    let late = json!({"sampling": {"delay": 1}, "wall": {"damping": "1/2"}});
    for sigma in ["1", "0.999999999999999999999999999999"] {
        let comment = "delay with damping: above, above, below, below";
        tests.push(asked("Edge", comment, ["2", sigma], &late));
    }
    tests
}

fn actuators() -> Vec<Test> {
    let mut tests = Vec::new();
    let latency = |s: &str| json!({"sampling": {"latency": s}});
    let lag = |theta: &str| json!({"amplifier": {"time_constant": theta}});
    let all =
        json!({"sampling": {"delay": 1, "latency": "0.3"}, "amplifier": {"time_constant": "1/3"}});
    let damped = json!({"sampling": {"latency": "0.25"}, "wall": {"damping": "1/2"}});
    // A search behind a lag takes longest: few of these loops fall short.
    for (comment, sections, sigma, betas) in [
        (
            "latency 0.3: κ = ½(0.8 + √0.85)",
            latency("0.3"),
            "10",
            vec!["0.8609772229", "0.8609772228", "0.7"],
        ),
        (
            "a whole sample of latency is one of delay",
            latency("1"),
            "10",
            vec!["1.5", "1.499999999", "1"],
        ),
        (
            "lag 1: κ = 1.51354…",
            lag("1"),
            "1",
            vec!["1.5135405535", "1.5135405534", "1/4"],
        ),
        ("lag 0.2: κ = 0.7213…", lag("0.2"), "1/2", vec!["0.7214"]),
        (
            "delay, latency and lag: one κ of all",
            all,
            "1",
            vec!["2.2"],
        ),
        (
            "a controller behind a latency: H(1)κ + Σ|gⱼ|",
            damped,
            "10",
            vec!["1.4", "1.3", "0.3"],
        ),
    ] {
        for beta in betas {
            tests.push(asked("Actuator", comment, [beta, sigma], &sections));
        }
    }
    tests
}

fn walls() -> Vec<Test> {
    let mut tests = Vec::new();
    let one_sided =
        json!({"sampling": {"delay": 1}, "wall": {"damping": "1/2", "unilateral": true}});
    for beta in ["2", "1.999999999", "1.2"] {
        let comment = "delay 1 and damping ½ add up to 2";
        tests.push(asked("Wall", comment, [beta, "10"], &one_sided));
    }
    let saturated = json!({"wall": {"damping": "1", "damping_time_constant": "1", "max_force": "1000"}, "sampling": {"delay": 1}});
    for beta in ["2.5", "2.499999999", "1"] {
        let comment = "filtered damping costs B behind a limit";
        tests.push(asked("Wall", comment, [beta, "10"], &saturated));
    }
    let stepped =
        json!({"sampling": {"delay": 1}, "wall": {"damping": "1/2", "force_step": "1/5"}});
    for sigma in ["1.1", "1.099999999"] {
        let comment = "a force step of 1/5 costs 1/10 of Coulomb friction";
        tests.push(asked("Wall", comment, ["2", sigma], &stepped));
    }
    tests
}

/// Products of factors 1 − rz⁻¹ and 1 − cz⁻¹ + r²z⁻² with poles inside.
fn random() -> Vec<Test> {
    let mut dice = Dice::new(7);
    let mut tests = Vec::new();
    for i in 0..10 {
        let mut denominator = vec![100_i64];
        for _ in 0..i % 4 {
            let pole = dice.between(-7, 7) * 10;
            denominator = times(&denominator, &[100, -pole]);
        }
        if i % 3 == 2 {
            // |c| ≤ 1 + r² is inside.
            let square = dice.between(1, 6) * 10;
            denominator = times(&denominator, &[100, dice.between(-9, 9) * 10, square]);
        }
        let mut numerator: Vec<i64> = (0..=dice.between(0, 4))
            .map(|_| dice.between(-200, 200))
            .collect();
        if numerator.iter().sum::<i64>() < 0 {
            numerator.iter_mut().for_each(|n| *n = -*n);
        }
        let scale = denominator.iter().sum::<i64>();
        let list =
            |c: &[i64], unit: i64| -> Vec<String> { c.iter().map(|n| ratio(*n, unit)).collect() };
        // A gain of about 1 at rest.
        let sections = json!({
            "sampling": {"delay": dice.between(0, 2)},
            "controller": {"numerator": list(&numerator, 100), "denominator": list(&denominator, scale)},
        });
        for [beta, sigma] in [["50", "200"], ["1/10", "200"]] {
            tests.push(asked("Random", "a controller", [beta, sigma], &sections));
        }
    }
    tests
}

fn times(a: &[i64], b: &[i64]) -> Vec<i64> {
    let mut product = vec![0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

fn refused() -> Vec<Test> {
    let controllers = [
        json!({"numerator": ["1"], "denominator": ["1", "-1"]}),
        json!({"numerator": ["1"], "denominator": ["1", "-2"]}),
        json!({"numerator": ["1"], "denominator": ["1", "-1.9", "1.1"]}),
        json!({"numerator": ["1"], "denominator": ["0", "1"]}),
        json!({"numerator": ["-1"]}),
        json!({"numerator": []}),
        json!({"numerator": "1"}),
        json!({"denominator": ["1"]}),
    ];
    controllers
        .into_iter()
        .map(|controller| {
            let sections = json!({"controller": controller});
            asked("NoLoop", "not a controller", ["1", "1"], &sections)
        })
        .collect()
}
