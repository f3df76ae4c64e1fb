//! What was recorded of the device, in the argument: each log and the identification is a goal of its
//! own, with evidence for it, against it, or none.

use super::{Builder, PARAMETERS, STRATEGY, clipped};
use crate::document::capital;
use crate::gsn::{Anchor, Kind, Node, Standing};
use crate::recorded::{Identification, Log, Outcome, Source};

/// The goal about the logs of the device in the scene.
pub(super) const RECORDED: &str = "G-recorded";
const FRICTION: &str = "G-friction";

impl Builder<'_> {
    /// The logs and the identification that the case was given.
    pub(super) fn recorded(&mut self) {
        let Some(recorded) = &self.study.recorded else {
            return;
        };
        if !recorded.logs.is_empty() {
            let text = "Wherever the device was recorded, its loop is that of the scene, and its \
                        account of energy holds.";
            let goal = Node::new(Kind::Goal, RECORDED, text).at(self.recorded_section());
            self.argument.hang(STRATEGY, goal);
        }
        for log in &recorded.logs {
            self.log(log);
        }
        if let Some(identification) = &recorded.identification {
            self.friction(identification);
        }
    }

    fn recorded_section(&self) -> Anchor {
        self.study.section("recorded", "Recordings of the device")
    }

    fn log(&mut self, log: &Log) {
        let number = log.number;
        let name = clipped(&log.source.name, 60);
        let goal = format!("G-log-{number}");
        let text = format!(
            "The log «{name}» agrees with the scene: the force is that of its wall, and the account \
             of energy holds."
        );
        let node = Node::new(Kind::Goal, &goal, text).at(self.recorded_section());
        self.argument.hang(RECORDED, node);
        let evidence = format!(
            "Audit of «{name}», {}: {}.",
            bound(&log.source),
            clipped(&log.headline(), 160)
        );
        let outcome = log.outcome(&self.study.scene);
        self.judge(&goal, &format!("log-{number}"), &outcome, evidence);
    }

    fn friction(&mut self, found: &Identification) {
        let text = "The friction of the device is that of the scene, and wherever it is in the \
                    identified ranges the verdict is the same.";
        let node = Node::new(Kind::Goal, FRICTION, text)
            .at(self.study.section("identified", "Identified friction"));
        self.argument.hang(PARAMETERS, node);
        let files: Vec<String> = found
            .sources
            .iter()
            .map(|source| format!("«{}», {}", clipped(&source.name, 60), bound(source)))
            .collect();
        let evidence = format!(
            "Identified from {}: {}.",
            files.join(" and "),
            found.headline()
        );
        self.judge(FRICTION, "identification", &found.outcome(), evidence);
        let assumption = "A-FRICTION";
        let known = self.records.claims.assumptions.iter();
        for assumption in known.filter(|known| known.id == assumption) {
            let text = clipped(&assumption.sentence, 160);
            let node = Node::new(Kind::Assumption, &assumption.id, text)
                .at(Anchor::Assumption(assumption.id.clone()));
            self.argument.hang(FRICTION, node);
        }
    }

    /// Evidence under a goal, or against it; a goal that is left open has none, and says why.
    fn judge(&mut self, goal: &str, id: &str, outcome: &Outcome, evidence: String) {
        let anchor = match goal {
            FRICTION => self.study.section("identified", "Identified friction"),
            _ => self.recorded_section(),
        };
        match outcome {
            Outcome::Supports => {
                let node = Node::new(Kind::Solution, format!("Sn-{id}"), evidence);
                let node = node.at(anchor).stands(Standing::Shown);
                self.argument.hang(goal, node);
            }
            Outcome::Open(why) => {
                let text = format!("It is left open: {}.", clipped(why, 400));
                let node = Node::new(Kind::Goal, format!("G-{id}-open"), text).at(anchor);
                self.argument.hang(goal, node);
            }
            Outcome::Contradicts(how) => {
                let counter = format!("CG-{id}");
                let text = format!("{}.", capital(&clipped(how, 400)));
                let node = Node::new(Kind::CounterGoal, &counter, text).at(anchor.clone());
                self.argument.challenge(goal, node);
                let node = Node::new(Kind::CounterSolution, format!("CSn-{id}"), evidence);
                let node = node.at(anchor).stands(Standing::Shown);
                self.argument.hang(&counter, node);
            }
        }
    }
}

/// By what evidence is bound to a file.
fn bound(source: &Source) -> String {
    format!(
        "SHA-256 {}…, recorded {} as given",
        source.sha256.short(),
        source.date
    )
}
