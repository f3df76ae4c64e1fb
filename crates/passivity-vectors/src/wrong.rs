//! The group of wrong formulas: rules for the stiffest wall that circulate in public code and notes.
//!
//! Each rule is asked about the same scenes, and those where it is wrong become its tests.

use passivity_core::BigRational;
use passivity_scene::number::parse;
use serde_json::{Value, json};

use crate::build::test;
use crate::{Formula, Group, Test};

/// A rule: what it says of K, in the units of a dimensionless scene, and the answer that follows.
struct Rule {
    flag: &'static str,
    name: &'static str,
    condition: &'static str,
    /// Whether the rule lets the wall pass, by μ and β.
    passes: fn(&BigRational, &BigRational) -> bool,
}

const RULES: [Rule; 4] = [
    Rule {
        flag: "DampingOverPeriod",
        name: "K ≤ b/T",
        condition: "β ≥ 1",
        passes: |_, beta| *beta >= fraction("1"),
    },
    Rule {
        flag: "InertiaCorrection",
        name: "K ≤ 2b/T − b²T/(2m)",
        condition: "2β − β²/(2μ) ≥ 1",
        passes: |mu, beta| {
            let two = fraction("2");
            &two * beta - beta * beta / (&two * mu) >= fraction("1")
        },
    },
    Rule {
        flag: "InertiaOverPeriod",
        name: "K ≤ 2m/T²",
        condition: "μ ≥ 1/2",
        passes: |mu, _| *mu >= fraction("1/2"),
    },
    Rule {
        flag: "HalfSample",
        name: "b ≥ K·T/2",
        condition: "β ≥ 1/2",
        passes: |_, beta| *beta >= fraction("1/2"),
    },
];

fn fraction(text: &str) -> BigRational {
    parse(text).expect("a fraction of this file")
}

pub(super) fn group() -> Group {
    let scenes = scenes();
    let tests = RULES.iter().flat_map(|rule| mistakes(rule, &scenes));
    Group {
        name: "wrong_formulas",
        header: "What circulates and is wrong: rules for the stiffest wall, each with scenes on which it gives another answer than the criterion. `formula` has the rule, the same in units of K, T and Δ, and what it says of the scene; `result` is the right answer. An implementation that answers by the rule fails every test of its flag.",
        claims: vec!["TH-REGION", "TH-ACTIVE", "TH-STIFF", "TH-DELAY", "TH-DAMP"],
        notes: vec![
            (
                "DampingOverPeriod",
                "K ≤ b/T refuses walls between b/T and 2b/T, which are passive, and knows neither encoder nor delay nor virtual damping",
            ),
            (
                "InertiaCorrection",
                "K ≤ 2b/T − b²T/(2m): passivity does not depend on the inertia. The rule refuses passive walls of a light device, and knows neither encoder nor delay nor virtual damping",
            ),
            (
                "InertiaOverPeriod",
                "K ≤ 2m/T² asks for no friction at all: a heavy device without any generates energy, and a light one with enough does not",
            ),
            (
                "HalfSample",
                "b ≥ K·T/2, half a sample of delay and nothing else: neither what the encoder asks of Coulomb friction, nor what that friction spares up to a speed, nor further delay or virtual damping",
            ),
        ],
        tests: tests.collect(),
    }
}

/// Light, middling and heavy devices on both sides of each border, with the effects that rules forget.
fn scenes() -> Vec<(Value, [BigRational; 2])> {
    let sections = [
        json!({}),
        json!({"operator": {"max_speed": "1"}}),
        json!({"sampling": {"delay": 1}}),
        json!({"wall": {"damping": "1/2"}}),
    ];
    let mut scenes = Vec::new();
    for mu in ["1/4", "50"] {
        for beta in ["1/4", "1/2", "3/4", "1", "2"] {
            for sigma in ["2/5", "1/2", "3"] {
                for section in &sections {
                    let mut scene = section.clone();
                    scene["dimensionless"] = json!({"mu": mu, "beta": beta, "sigma": sigma});
                    scenes.push((scene, [fraction(mu), fraction(beta)]));
                }
            }
        }
    }
    scenes
}

/// The scenes of which the rule says the contrary of what is proved.
fn mistakes(rule: &Rule, scenes: &[(Value, [BigRational; 2])]) -> Vec<Test> {
    let mut tests = Vec::new();
    for (scene, [mu, beta]) in scenes {
        let passes = (rule.passes)(mu, beta);
        let comment = if passes {
            "lets a wall pass that generates energy"
        } else {
            "refuses a wall that is passive"
        };
        let mut test = test(
            comment,
            &[rule.flag],
            json!({"op": "check", "scene": scene}),
        );
        let [wrong, right] = if passes {
            ["passive", "not_passive"]
        } else {
            ["not_passive", "passive"]
        };
        // Where no motion that draws energy is known, the rule is not shown to be wrong.
        if test
            .result
            .as_ref()
            .is_some_and(|result| result["verdict"] == right)
        {
            test.formula = Some(Formula {
                name: rule.name,
                condition: rule.condition,
                says: wrong,
            });
            tests.push(test);
        }
    }
    tests
}
