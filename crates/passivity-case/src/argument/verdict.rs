//! What the verdict is: the criterion with the scene's numbers, and what defeats it.

use passivity_scene::Motion;
use passivity_scene::check::Verdict;
use passivity_scene::display::range;

use super::{Builder, CRITERION, CYCLE, STRATEGY, TOP};
use crate::gsn::{Kind, Node, Standing};

impl Builder<'_> {
    /// The criterion with the numbers of the scene.
    pub(super) fn criterion(&mut self) {
        let report = self.report();
        let verdict = report.verdict;
        let criterion = self.study.criterion();
        let text = format!(
            "The criterion holds {}, for every value within the tolerances. {}",
            self.study.speeds(),
            criterion.sentence()
        );
        let goal = Node::new(Kind::Goal, CRITERION, text).at(self.derivation());
        self.argument.hang(STRATEGY, goal);
        let margin = report.margin_at_speed_bound.as_ref();
        let margin = margin.filter(|_| report.speed_bound.is_some() && !report.at_every_speed);
        let figure = match margin {
            Some(margin) => format!("Margin (8) at the speed bound {}", range(margin)),
            None => format!(
                "Spare at every speed: {} of β and {} of σ",
                range(&report.spare.viscous),
                range(&report.spare.coulomb)
            ),
        };
        let figure = format!("{figure}: exact arithmetic, done for this case.");
        match verdict {
            Verdict::Passive => {
                let solution = Node::new(Kind::Solution, "Sn-margin", figure)
                    .at(self.derivation())
                    .stands(Standing::Shown);
                self.argument.hang(CRITERION, solution);
                self.links_to_verdict();
            }
            // What no theorem covers takes the meaning from the figures; what depends is open.
            Verdict::NotCovered | Verdict::Depends => {}
            Verdict::NotGuaranteed | Verdict::NotPassive => {
                self.links_to_verdict();
                let text = format!(
                    "The criterion does not hold {}: at some of them it fails, whatever the values \
                     within the tolerances.",
                    self.study.speeds()
                );
                let counter = Node::new(Kind::CounterGoal, "CG-criterion", text);
                self.argument.challenge(CRITERION, counter);
                let solution = Node::new(Kind::CounterSolution, "CSn-margin", figure)
                    .at(self.derivation())
                    .stands(Standing::Shown);
                self.argument.hang("CG-criterion", solution);
            }
        }
    }

    /// What leads from the scene file to the criterion and from the criterion to the verdict.
    fn links_to_verdict(&mut self) {
        let has_units = self.study.scene.motion != Motion::Dimensionless;
        let links = [
            (has_units, "EQ-1..7"),
            (self.study.has_speed_limit(), "EQ-28"),
            (true, "TH-REGION"),
            (true, "TH-CHECK"),
            (true, "CHECK-VERDICT"),
        ];
        for (_, id) in links.into_iter().filter(|(is_needed, _)| *is_needed) {
            self.hang_claim(CRITERION, id);
        }
    }

    /// What defeats the top goal: a motion that draws energy.
    pub(super) fn counter(&mut self) {
        let Some(witness) = self.report().witness_text() else {
            return;
        };
        let text = format!("The hand draws energy without end: {witness}");
        let counter = Node::new(Kind::CounterGoal, CYCLE, text).at(self.derivation());
        self.argument.challenge(TOP, counter);
        let exact = "The work of the held force and of friction over the motion: exact arithmetic, \
                     done for this case.";
        let solution = Node::new(Kind::CounterSolution, "CSn-witness", exact)
            .at(self.derivation())
            .stands(Standing::Shown);
        self.argument.hang(CYCLE, solution);
        for id in &self.report().because {
            let solution = self.evidence_of(Kind::CounterSolution, "CSn", id);
            self.argument.hang(CYCLE, solution);
        }
    }
}
