//! The argument of a case: why this display renders this wall passively, or why it does not.

mod recorded;
mod verdict;

use std::collections::BTreeMap;

use passivity_scene::Effect;
use passivity_scene::check::Report;
use passivity_scene::explain::Step;

use crate::gsn::{Anchor, Argument, Kind, Node, Standing};
use crate::records::{Records, standing};
use crate::study::{Source, Study};

/// The top goal.
pub const TOP: &str = "G-passive";
const STRATEGY: &str = "S-energy";
const GENERATION: &str = "G-generation";
const DISSIPATION: &str = "G-dissipation";
const SUM: &str = "G-sum";
const CRITERION: &str = "G-criterion";
const NUMERICS: &str = "G-numerics";
const PARAMETERS: &str = "G-parameters";
const CYCLE: &str = "CG-cycle";

/// The goals under the strategy: each has a drawing of its own in the document.
pub const PARTS: [&str; 7] = [
    GENERATION,
    DISSIPATION,
    SUM,
    CRITERION,
    NUMERICS,
    PARAMETERS,
    recorded::RECORDED,
];

/// The argument for one scene, with the standing of the recorded evidence.
#[must_use]
pub fn argue(study: &Study, records: &Records) -> Argument {
    let mut build = Builder {
        study,
        records,
        argument: top(study),
    };
    build.surroundings();
    build.generation();
    build.dissipation();
    build.sum();
    build.criterion();
    build.numerics();
    build.parameters();
    build.recorded();
    build.not_covered();
    build.counter();
    build.assumptions();
    build.argument.settle();
    build.argument
}

fn top(study: &Study) -> Argument {
    let text = format!(
        "The display renders the virtual wall passively {}: whatever the hand does, it draws no \
         more energy than was stored at the start, for every value of the parameters within their \
         tolerances.",
        study.speeds()
    );
    Argument::new(
        study.name(),
        Node::new(Kind::Goal, TOP, text).at(study.section("verdict", "Verdict")),
    )
}

/// The records of the claims.
fn claims_section() -> Anchor {
    Anchor::Section("claims".to_owned(), "Claims and evidence")
}

/// What the case does not say.
fn limits_section() -> Anchor {
    Anchor::Section("limits".to_owned(), "Limits")
}

/// The theorems of the scene's effects, but for those of the plain wall.
fn of_effects(report: &Report) -> Vec<&'static str> {
    const PLAIN: [&str; 5] = [
        "TH-REGION",
        "TH-INTERVAL",
        "TH-RUN",
        "TH-ACTIVE",
        "TH-SMOOTH",
    ];
    let effects = report.effects.iter().filter_map(|effect| effect.theorem());
    let mut ids = Vec::new();
    for id in report.because.iter().copied().chain(effects) {
        if !PLAIN.contains(&id) && !ids.contains(&id) {
            ids.push(id);
        }
    }
    ids
}

struct Builder<'a> {
    study: &'a Study,
    records: &'a Records,
    argument: Argument,
}

impl<'a> Builder<'a> {
    fn report(&self) -> &'a Report {
        self.study.report()
    }

    fn derivation(&self) -> Anchor {
        self.study.section("derivation", "Derivation")
    }

    fn parameters_section(&self) -> Anchor {
        self.study.section("parameters", "Device and parameters")
    }

    fn surroundings(&mut self) {
        let study = self.study;
        let stiffness = match study.scene.given.stiffness.text.as_str() {
            "" => "stiffness 1 in its own units".to_owned(),
            text => format!("stiffness {text}"),
        };
        let device = format!(
            "Device, loop and wall as in the scene file «{}»; {stiffness}.",
            study.file_name()
        );
        let effects: Vec<&str> = study
            .scene
            .effects()
            .into_iter()
            .map(Effect::words)
            .collect();
        let nodes = [
            Node::new(Kind::Context, "C-device", device)
                .at(study.section("parameters", "Device and parameters")),
            Node::new(
                Kind::Context,
                "C-effects",
                format!("Effects in the scene: {}.", effects.join("; ")),
            )
            .at(self.derivation()),
            Node::new(
                Kind::Context,
                "C-passive",
                "Passive: at every sampling instant the work of the hand so far is at least the \
                 stored energy less what was stored at the start.",
            )
            .at(Anchor::Section("hazards".to_owned(), "Hazards")),
        ];
        for node in nodes {
            self.argument.hang(TOP, node);
        }
        let strategy = match self.has_memory() {
            true => {
                "Argue over the energy of a run of sampling intervals: what the held force generates, \
                 beside what the loop's memory stores and gives up, is covered by what friction \
                 dissipates."
            }
            false => {
                "Argue over the energy of each sampling interval: what the held force generates is \
                 covered by what friction dissipates; then sum."
            }
        };
        self.argument
            .hang(TOP, Node::new(Kind::Strategy, STRATEGY, strategy));
        let storage = "Energy is measured against the linear spring. Against the quantized spring \
                       of the paper (22) is false as printed; the conclusion stands, with another \
                       storage.";
        let errata = Anchor::Section("errata".to_owned(), "What the paper got wrong");
        let storage = Node::new(Kind::Justification, "J-storage", storage).at(errata);
        self.argument.hang(STRATEGY, storage);
    }

    /// What the held force generates, with the effects that the scene has.
    fn generation(&mut self) {
        let report = self.report();
        let bound = self.study.explanation.line(Step::Generated);
        let text = bound.map_or_else(
            || "What the held force generates in a sampling interval is bounded.".to_owned(),
            |line| {
                let of = match self.study.scene.point().at.has_computed_costs() {
                    true => "Over any number of sampling intervals from the first on",
                    false => "In every sampling interval",
                };
                format!(
                    "{of}, what the held force generates is bounded: {}.",
                    line.formula
                )
            },
        );
        let mut ids = vec![if report.sigma.is_some() {
            "TH-LIN"
        } else {
            "TH-SMOOTH"
        }];
        ids.extend(of_effects(report));
        self.claims_goal(GENERATION, &text, &ids);
    }

    /// What friction dissipates, as the derivation has it.
    fn dissipation(&mut self) {
        let line = self.study.explanation.line(Step::Dissipated);
        let formula = line.map_or("E_d ≥ 0", |line| line.formula.as_str());
        let text = format!("In every sampling interval, of what friction dissipates: {formula}.");
        self.claims_goal(DISSIPATION, &text, &["EQ-23..26"]);
    }

    /// From one interval to a whole motion.
    fn sum(&mut self) {
        let (ids, text) = match self.has_memory() {
            // An interval alone may gain what the memory gives up.
            true => (
                of_effects(self.report()),
                "Where the criterion holds at every speed that occurs, over any number of sampling \
                 intervals the hand draws no more than was stored, what the loop remembered at the \
                 start included.",
            ),
            false => (
                vec!["TH-INTERVAL", "TH-RUN"],
                "Where the criterion holds at the speed of every interval, no interval gains energy, \
                 and over any number of them the hand draws no more than was stored.",
            ),
        };
        self.claims_goal(SUM, text, &ids);
    }

    fn has_memory(&self) -> bool {
        self.study.scene.given.has_memory()
    }

    /// Why the figures can be relied on.
    fn numerics(&mut self) {
        let text = "The margins, borders and regions are what the criterion says for the numbers of \
                    the scene: rationals of any size, tolerances as intervals. No rounding decides.";
        self.claims_goal(NUMERICS, text, &["NUM-EXACT", "EQ-27", "TH-STIFF"]);
        let text = "The arithmetic of rationals is a library's (num-rational on num-bigint); π is \
                    enclosed between rationals and refined until it does not matter. Both are \
                    tested, and trusted.";
        let why = Node::new(Kind::Justification, "J-arithmetic", text).at(limits_section());
        self.argument.hang(NUMERICS, why);
    }

    /// Where the parameters come from: what is not said is open.
    fn parameters(&mut self) {
        let text = "The scene file says where the value of each parameter is from; that the device has \
                    these values, for as long as it is used, is to be shown on the bench.";
        let goal = Node::new(Kind::Goal, PARAMETERS, text).at(self.parameters_section());
        self.argument.hang(STRATEGY, goal);
        let mut at_head = Vec::new();
        let mut open = Vec::new();
        for stated in self.study.stated() {
            let key = stated.key;
            match stated.source {
                Source::Comment(comment) => {
                    let text = format!("{key}: {}", clipped(&comment, 90));
                    let solution = Node::new(Kind::Solution, format!("Sn-{key}"), text)
                        .at(self.parameters_section())
                        .stands(Standing::Shown);
                    self.argument.hang(PARAMETERS, solution);
                }
                // The goal about friction has it.
                Source::Identified => {}
                Source::Head => at_head.push(key),
                Source::None => open.push(key),
            }
        }
        if !at_head.is_empty() {
            let text = format!(
                "The head of the scene file, of {} parameters: {}",
                at_head.len(),
                clipped(&self.study.head().replace('\n', " "), 90)
            );
            let solution = Node::new(Kind::Solution, "Sn-head", text)
                .at(self.parameters_section())
                .stands(Standing::Shown);
            self.argument.hang(PARAMETERS, solution);
        }
        if !open.is_empty() {
            let text = format!("The scene file states the source of: {}.", open.join(", "));
            let goal = Node::new(Kind::Goal, "G-sources", text).at(self.parameters_section());
            self.argument.hang(PARAMETERS, goal);
        }
    }

    /// Effects that no theorem covers are an open goal.
    fn not_covered(&mut self) {
        let effects = &self.report().not_covered;
        if effects.is_empty() {
            return;
        }
        let words: Vec<&str> = effects.iter().map(|effect| effect.words()).collect();
        let text = format!(
            "Effects that no theorem covers generate no further energy: {}.",
            words.join("; ")
        );
        let goal = Node::new(Kind::Goal, "G-not-covered", text).at(limits_section());
        self.argument.hang(STRATEGY, goal);
    }

    /// A goal that rests on claims.
    fn claims_goal(&mut self, id: &str, text: &str, claims: &[&str]) {
        self.argument.hang(
            STRATEGY,
            Node::new(Kind::Goal, id, text).at(claims_section()),
        );
        for claim in claims {
            self.hang_claim(id, claim);
        }
    }

    /// Hangs a claim under a goal, as a goal of its own with its evidence; an id that is no claim
    /// here leaves the goal without that support.
    fn hang_claim(&mut self, parent: &str, id: &str) {
        let Some(claim) = self.records.claims.find(id) else {
            return;
        };
        let text = clipped(&claim.sentence, 220);
        let goal_id = format!("G-{id}");
        let goal = Node::new(Kind::Goal, &goal_id, text).at(Anchor::Claim(id.to_owned()));
        self.argument.hang(parent, goal);
        let solution = self.evidence_of(Kind::Solution, "Sn", id);
        self.argument.hang(&goal_id, solution);
    }

    /// The engines that were to show a claim, each with how it stands.
    fn evidence_of(&self, kind: Kind, prefix: &str, id: &str) -> Node {
        let engines: Vec<String> = self
            .records
            .of_claim(id)
            .map(|assessed| match standing(&assessed.freshness) {
                Standing::Shown => assessed.engine.words().to_owned(),
                standing => format!("{} ({})", assessed.engine.words(), standing.words()),
            })
            .collect();
        let text = if engines.is_empty() {
            "No evidence is recorded.".to_owned()
        } else {
            format!("Evidence: {}.", engines.join(", "))
        };
        Node::new(kind, format!("{prefix}-{id}"), text)
            .at(Anchor::Claim(id.to_owned()))
            .stands(self.records.standing(id))
    }

    /// The assumptions of the claims used: at the one part that needs it, else at the strategy, and what only a
    /// counterexample needs at that.
    fn assumptions(&mut self) {
        let mut users: BTreeMap<String, Vec<&str>> = BTreeMap::new();
        for part in PARTS {
            for id in self.assumptions_under(part) {
                let places = users.entry(id).or_default();
                if !places.contains(&part) {
                    places.push(part);
                }
            }
        }
        let of_cycle = self.assumptions_under(CYCLE);
        // The gain is what is left of the work if friction takes no more than the scene allows.
        let at_most = self.report().witness.as_ref().map(|_| "A-FRICTION-AT-MOST");
        for assumption in &self.records.claims.assumptions {
            let part = users.get(&assumption.id).map(|places| match places[..] {
                [only] => only,
                _ => STRATEGY,
            });
            let is_of_cycle_alone = part.is_none() && of_cycle.contains(&assumption.id);
            let is_of_cycle = is_of_cycle_alone || at_most == Some(assumption.id.as_str());
            let cycle = is_of_cycle.then_some(CYCLE);
            for place in part.into_iter().chain(cycle) {
                let text = clipped(&assumption.sentence, 160);
                let node = Node::new(Kind::Assumption, &assumption.id, text)
                    .at(Anchor::Assumption(assumption.id.clone()));
                self.argument.hang(place, node);
            }
        }
    }

    /// The assumptions of the claims that support a goal.
    fn assumptions_under(&self, goal: &str) -> Vec<String> {
        let supports = self.argument.node(goal).map(|node| &node.supported_by);
        let supports = supports.into_iter().flatten();
        let claims = supports.filter_map(|id| match &self.argument.node(id)?.anchor {
            Some(Anchor::Claim(id)) => self.records.claims.find(id),
            _ => None,
        });
        claims.flat_map(|claim| claim.assumptions.clone()).collect()
    }
}

/// A text that fits an element of the drawing.
fn clipped(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let cut: String = text.chars().take(most - 1).collect();
    match cut.rsplit_once(' ') {
        Some((whole_words, _)) => format!("{whole_words}…"),
        None => format!("{cut}…"),
    }
}
