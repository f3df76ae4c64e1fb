//! What is proved at which level, and how the levels meet.

use passivity_evidence::Engine;

use crate::case::Case;
use crate::document::{Document, Line, Row};
use crate::gsn::Standing;
use crate::records::{Records, standing};

/// A way of showing a claim: the engine, what it speaks of, and what it leaves to the others.
struct Level {
    engine: Engine,
    name: &'static str,
    speaks_of: &'static str,
    leaves: &'static str,
}

/// From the motion of the device down to the numbers that the code computes with.
const LEVELS: [Level; 5] = [
    Level {
        engine: Engine::Rocq,
        name: "Motions",
        speaks_of: "every motion that obeys (6), with real integrals, over any number of sampling \
                    intervals, whatever force the operator applies",
        leaves: "that the formulas it speaks of are those of the code: the bridge",
    },
    Level {
        engine: Engine::Smt,
        name: "Formulas",
        speaks_of: "the formulas that the code computes, on all real numbers: one interval, or the \
                    step of an induction",
        leaves: "the sum over intervals and the integrals: the proof assistant",
    },
    Level {
        engine: Engine::Kani,
        name: "Code, all inputs in a bound",
        speaks_of: "the compiled code on every number of a grid, overflow and panic included",
        leaves: "numbers outside of the grid: the solvers and the proof assistant",
    },
    Level {
        engine: Engine::StandIn,
        name: "Code, the same harnesses",
        speaks_of: "the text of the same harnesses, run on every input where these are few, and on \
                    samples where they are many",
        leaves: "inputs that were not drawn: the model checker",
    },
    Level {
        engine: Engine::Tests,
        name: "Code, numbers as used",
        speaks_of: "the compiled code at fractions of any size, as verdicts use it, against formulas \
                    written a second time",
        leaves: "inputs that were not drawn: the levels above",
    },
];

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(2, "levels", "What is proved at which level");
    document.say(
        "No engine sees everything from the physical model to the numbers in the computer. Each level \
         below speaks of less than the one above it and is closer to what runs. The last column counts \
         the claims by how the records of the level stand.",
    );
    let rows: Vec<Row> = LEVELS
        .iter()
        .map(|level| {
            [
                Line::strong(level.name).and(format!(" ({})", level.engine.words()).into()),
                level.speaks_of.into(),
                level.leaves.into(),
                counted(&case.records, level.engine).into(),
            ]
            .into()
        })
        .collect();
    let columns = [
        ("Level", 18),
        ("Speaks of", 36),
        ("Leaves open, and to whom", 26),
        ("Claims", 20),
    ];
    document.table(
        "Levels of proof, from the motion to the code",
        &columns,
        rows,
    );
    document.say("How the levels meet:");
    let meeting = [
        (
            "Paper and motions: ",
            "the equation of motion (6) in integrated form is the model itself; the power balance and \
             all that the paper concludes from it is proved, or refuted where it is false.",
        ),
        (
            "Motions and code: ",
            "the code's functions are run on variables and print the formulas that they compute; the \
             proof assistant proves each equal to the definition that its theorems use. A function that \
             branches is printed way by way. An edit of the code or of a definition breaks this.",
        ),
        (
            "Formulas and code: ",
            "the solvers' questions are printed by the code in the same way, and a test prints them \
             again and compares.",
        ),
        (
            "One text, several kinds of number: ",
            "the functions are generic. What the solvers and the proof assistant see is the text that \
             is compiled for fractions. That fractions add, multiply, compare and round down as real \
             numbers do is tested (NUM-EXACT), not proved, and whole numbers of any size are those of \
             a library that is trusted.",
        ),
        (
            "Harnesses: ",
            "the model checker and the tests read one text; a harness that says nothing, because no \
             input meets its assumptions, fails as a test.",
        ),
        (
            "Beside all levels: ",
            "the compiler, the tools themselves, and the reading of the paper are trusted.",
        ),
    ];
    document.list(
        meeting
            .map(|(head, rest)| Line::strong(head).and(rest.into()))
            .to_vec(),
    );
}

/// How the records of an engine stand: `25 shown, 1 stale`.
fn counted(records: &Records, engine: Engine) -> String {
    let kinds = [
        (Standing::Shown, "shown"),
        (Standing::Stale, "stale"),
        (Standing::NotRun, "not run here"),
        (Standing::Open, "failed"),
    ];
    let of = |wanted| {
        let records = records.assessed.iter().filter(|a| a.engine == engine);
        let standings = records.map(|assessed| standing(&assessed.freshness));
        standings.filter(|standing| *standing == wanted).count()
    };
    let counts: Vec<String> = kinds
        .into_iter()
        .map(|(standing, word)| (of(standing), word))
        .filter(|(count, _)| *count > 0)
        .map(|(count, word)| format!("{count} {word}"))
        .collect();
    if counts.is_empty() {
        "no records".to_owned()
    } else {
        counts.join(", ")
    }
}

#[cfg(test)]
mod tests {
    use passivity_evidence::{Assessed, Change, Freshness};

    use super::*;

    #[test]
    fn records_are_counted_as_they_stand() {
        let entry = |engine, freshness| Assessed {
            claim: "TH-X".to_owned(),
            engine,
            required: true,
            record: None,
            freshness,
        };
        let mut records = Records::read(None, None).unwrap();
        records.assessed = vec![
            entry(Engine::Rocq, Freshness::Fresh),
            entry(Engine::Rocq, Freshness::Fresh),
            entry(Engine::Rocq, Freshness::Stale(vec![Change::Statement])),
            entry(Engine::Rocq, Freshness::NotRun("not here".to_owned())),
            entry(Engine::Smt, Freshness::Failed(Vec::new())),
        ];
        assert_eq!(
            counted(&records, Engine::Rocq),
            "2 shown, 1 stale, 1 not run here"
        );
        assert_eq!(counted(&records, Engine::Smt), "1 failed");
        assert_eq!(counted(&records, Engine::Kani), "no records");
    }

    #[test]
    fn every_engine_that_counts_as_evidence_is_a_level() {
        for engine in Engine::ALL {
            // The contracts are checked by nothing, and no claim counts them.
            let counts = engine != Engine::Prusti;
            let level = LEVELS.iter().any(|level| level.engine == engine);
            assert_eq!(level, counts, "{engine}");
        }
    }
}
