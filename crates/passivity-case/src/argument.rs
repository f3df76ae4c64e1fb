//! The argument of a case: why this display renders this wall passively, or why it does not.

use std::collections::BTreeMap;

use passivity_scene::Effect;
use passivity_scene::check::{BoundSource, Report, Verdict};
use passivity_scene::display::{approx, range};

use crate::gsn::{Argument, Kind, Node, Standing};
use crate::records::Records;
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

/// The goals under the strategy: each has a drawing of its own in the document.
pub const PARTS: [&str; 6] = [
    GENERATION,
    DISSIPATION,
    SUM,
    CRITERION,
    NUMERICS,
    PARAMETERS,
];

/// The argument for one scene, with the standing of the recorded evidence.
#[must_use]
pub fn argue(study: &Study, records: &Records) -> Argument {
    let mut build = Build {
        study,
        records,
        argument: top(study),
    };
    build.surroundings();
    build.generation();
    build.claims_goal(
        DISSIPATION,
        "In every sampling interval friction dissipates at least β·d²/Δτ + σ·|d|.",
        &["EQ-23..26"],
    );
    build.sum();
    build.criterion();
    build.numerics();
    build.parameters();
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
        Node::new(Kind::Goal, TOP, text).at(study.anchor("summary")),
    )
}

impl Study {
    /// The id of one of this scene's elements in the document.
    #[must_use]
    pub fn anchor(&self, element: &str) -> String {
        format!("{}-{element}", self.slug)
    }
}

struct Build<'a> {
    study: &'a Study,
    records: &'a Records,
    argument: Argument,
}

impl<'a> Build<'a> {
    fn report(&self) -> &'a Report {
        self.study.report()
    }

    fn surroundings(&mut self) {
        let study = self.study;
        let stiffness = match study.scene.stiffness.text.as_str() {
            "" => "stiffness 1 in its own units".to_owned(),
            text => format!("stiffness {text}"),
        };
        let device = format!(
            "Device, loop and wall as in the scene file «{}»; {stiffness}.",
            study.path.file_name().unwrap_or_default().to_string_lossy()
        );
        let effects: Vec<&str> = study
            .scene
            .effects()
            .into_iter()
            .map(Effect::words)
            .collect();
        let nodes = [
            Node::new(Kind::Context, "C-device", device).at(study.anchor("parameters")),
            Node::new(
                Kind::Context,
                "C-effects",
                format!("Effects in the scene: {}.", effects.join("; ")),
            )
            .at(study.anchor("derivation")),
            Node::new(
                Kind::Context,
                "C-passive",
                "Passive: at every sampling instant the work of the hand so far is at least the \
                 stored energy less what was stored at the start.",
            )
            .at("hazards"),
        ];
        for node in nodes {
            self.argument.hang(TOP, node);
        }
        let strategy = "Argue over the energy of each sampling interval: what the held force \
                        generates is covered by what friction dissipates; then sum.";
        self.argument
            .hang(TOP, Node::new(Kind::Strategy, STRATEGY, strategy));
        let storage = "Energy is measured against the linear spring. Against the quantized spring \
                       of the paper (22) is false as printed; the conclusion stands, with another \
                       storage.";
        let storage = Node::new(Kind::Justification, "J-storage", storage).at("errata");
        self.argument.hang(STRATEGY, storage);
    }

    /// What the held force generates, with the effects that the scene has.
    fn generation(&mut self) {
        let report = self.report();
        let bound = self
            .study
            .explanation
            .lines
            .iter()
            .find(|line| line.formula.starts_with("E_g"))
            .map_or_else(
                || "E_g ≤ ½·d² + ½·|d|".to_owned(),
                |line| line.formula.clone(),
            );
        let mut ids = vec![if report.sigma.is_some() {
            "TH-LIN"
        } else {
            "TH-SMOOTH"
        }];
        let plain = ["TH-INTERVAL", "TH-RUN"];
        for id in report.effects.iter().filter_map(|effect| effect.theorem()) {
            if !plain.contains(&id) && !ids.contains(&id) {
                ids.push(id);
            }
        }
        let text = format!("In every sampling interval the held force generates at most {bound}.");
        self.claims_goal(GENERATION, &text, &ids);
    }

    /// From one interval to a whole motion.
    fn sum(&mut self) {
        let mut ids = vec!["TH-INTERVAL", "TH-RUN"];
        if self.report().bound_source == Some(BoundSource::Start) {
            ids.push("TH-START");
        }
        let text = "Where the criterion holds at the speed of every interval, no interval gains \
                    energy, and over any number of them the hand draws no more than was stored.";
        self.claims_goal(SUM, text, &ids);
    }

    /// The criterion with the numbers of the scene.
    fn criterion(&mut self) {
        let report = self.report();
        let verdict = report.verdict;
        let line = self
            .study
            .explanation
            .lines
            .iter()
            .find(|line| line.id == "(8)");
        let numbers = line.map_or("", |line| &line.numbers);
        let text = format!("The criterion holds {}: {numbers}.", self.study.speeds());
        let goal = Node::new(Kind::Goal, CRITERION, text).at(self.study.anchor("derivation"));
        self.argument.hang(STRATEGY, goal);
        let margin = report.margin_at_speed_bound.as_ref();
        let margin = margin.filter(|_| report.speed_bound.is_some() && !self.at_all_speeds());
        let (margin, at) = match margin {
            Some(margin) => (margin, "at the speed bound, in KΔ"),
            None => (&report.margin_at_all_speeds, "at every speed"),
        };
        let figure = format!(
            "Margin {} {at}: exact arithmetic, done for this case.",
            range(margin)
        );
        let claim = self.claim_goal("TH-REGION");
        match verdict {
            Verdict::Passive => {
                let solution = Node::new(Kind::Solution, "Sn-margin", figure)
                    .at(self.study.anchor("derivation"))
                    .stands(Standing::Shown);
                self.argument.hang(CRITERION, solution);
                self.hang_claim(CRITERION, claim);
            }
            // What no theorem covers takes the meaning from the figures; what depends is open.
            Verdict::NotCovered | Verdict::Depends => {}
            Verdict::NotGuaranteed | Verdict::NotPassive => {
                self.hang_claim(CRITERION, claim);
                let counter = Node::new(
                    Kind::CounterGoal,
                    "CG-criterion",
                    format!("The criterion fails {}.", self.study.speeds()),
                );
                self.argument.challenge(CRITERION, counter);
                let solution = Node::new(Kind::CounterSolution, "CSn-margin", figure)
                    .at(self.study.anchor("derivation"))
                    .stands(Standing::Shown);
                self.argument.hang("CG-criterion", solution);
            }
        }
    }

    fn at_all_speeds(&self) -> bool {
        !num_traits::Signed::is_negative(self.report().margin_at_all_speeds.lo())
    }

    /// Why the figures can be relied on.
    fn numerics(&mut self) {
        let text = "The margins, borders and regions are what the criterion says for the numbers of \
                    the scene: rationals of any size, tolerances as intervals. No rounding decides.";
        self.claims_goal(NUMERICS, text, &["NUM-EXACT", "EQ-27", "TH-STIFF"]);
        let text = "The arithmetic of rationals is a library's (num-rational on num-bigint); π is \
                    enclosed between rationals and refined until it does not matter. Both are \
                    tested, and trusted.";
        let why = Node::new(Kind::Justification, "J-arithmetic", text).at("limits");
        self.argument.hang(NUMERICS, why);
    }

    /// Where the parameters come from: what is not said is open.
    fn parameters(&mut self) {
        let text = "The parameters of the device and its loop lie within the values and \
                    tolerances of the scene file, for as long as it is used.";
        let goal = Node::new(Kind::Goal, PARAMETERS, text).at(self.study.anchor("parameters"));
        self.argument.hang(STRATEGY, goal);
        let mut at_head = Vec::new();
        let mut open = Vec::new();
        for given in self.study.scene.parameters() {
            if given.text.is_empty() {
                continue;
            }
            match self.study.source(given) {
                Source::Comment(comment) => {
                    let text = format!("{}: {}", given.key, clipped(&comment, 90));
                    let solution = Node::new(Kind::Solution, format!("Sn-{}", given.key), text)
                        .at(self.study.anchor("parameters"))
                        .stands(Standing::Shown);
                    self.argument.hang(PARAMETERS, solution);
                }
                Source::Head => at_head.push(given.key),
                Source::None => open.push(given.key),
            }
        }
        if !at_head.is_empty() {
            let text = format!(
                "Sources that the head of the scene file names, of {} parameters.",
                at_head.len()
            );
            let solution = Node::new(Kind::Solution, "Sn-head", text)
                .at(self.study.anchor("parameters"))
                .stands(Standing::Shown);
            self.argument.hang(PARAMETERS, solution);
        }
        if !open.is_empty() {
            let text = format!("The source of these is stated: {}.", open.join(", "));
            let goal = Node::new(Kind::Goal, "G-sources", text).at(self.study.anchor("parameters"));
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
            "No more energy is generated with what no theorem covers: {}.",
            words.join("; ")
        );
        let goal = Node::new(Kind::Goal, "G-not-covered", text).at("limits");
        self.argument.hang(STRATEGY, goal);
    }

    /// What defeats the top goal: a cycle that draws energy.
    fn counter(&mut self) {
        let Some(witness) = self.report().witness.clone() else {
            return;
        };
        let encoder = self.report().sigma.is_some();
        let unit = if encoder { "ticks" } else { "units of length" };
        let text = format!(
            "The hand gains energy without end: moving from {} to {} {unit} and back, each way \
             within one sampling interval, gains at least {} KΔ² every time round.",
            short(&witness.from),
            short(&witness.to),
            short(&witness.gain_per_cycle),
        );
        let counter =
            Node::new(Kind::CounterGoal, "CG-cycle", text).at(self.study.anchor("derivation"));
        self.argument.challenge(TOP, counter);
        let exact = "The work of the held force and of friction over the cycle: exact arithmetic, \
                     done for this case.";
        let solution = Node::new(Kind::CounterSolution, "CSn-witness", exact)
            .at(self.study.anchor("derivation"))
            .stands(Standing::Shown);
        self.argument.hang("CG-cycle", solution);
        let id = if encoder { "TH-ACTIVE" } else { "TH-SMOOTH" };
        let (text, standing) = self.evidence_of(id);
        let solution = Node::new(Kind::CounterSolution, format!("CSn-{id}"), text)
            .at(format!("claim-{id}"))
            .stands(standing);
        self.argument.hang("CG-cycle", solution);
    }

    /// A goal that rests on claims.
    fn claims_goal(&mut self, id: &str, text: &str, claims: &[&str]) {
        self.argument
            .hang(STRATEGY, Node::new(Kind::Goal, id, text).at("claims"));
        for claim in claims {
            let goal = self.claim_goal(claim);
            self.hang_claim(id, goal);
        }
    }

    /// A claim as a goal; `None` for an id that is no claim here.
    fn claim_goal(&self, id: &str) -> Option<Node> {
        let claim = self.records.claim(id)?;
        let text = clipped(&claim.sentence, 220);
        Some(Node::new(Kind::Goal, format!("G-{id}"), text).at(format!("claim-{id}")))
    }

    fn hang_claim(&mut self, parent: &str, goal: Option<Node>) {
        let Some(goal) = goal else { return };
        let goal_id = goal.id.clone();
        let id = goal_id.trim_start_matches("G-").to_owned();
        self.argument.hang(parent, goal);
        let (text, standing) = self.evidence_of(&id);
        let solution = Node::new(Kind::Solution, format!("Sn-{id}"), text)
            .at(format!("claim-{id}"))
            .stands(standing);
        self.argument.hang(&goal_id, solution);
    }

    /// The engines that were to show a claim, each with how it stands.
    fn evidence_of(&self, id: &str) -> (String, Standing) {
        let Some(claim) = self.records.claim(id) else {
            return ("No such claim is recorded.".to_owned(), Standing::NotRun);
        };
        let engines: Vec<String> = claim
            .evidence
            .iter()
            .map(|evidence| match evidence.standing() {
                Standing::Shown => evidence.engine.words().to_owned(),
                standing => format!("{} ({})", evidence.engine.words(), standing.words()),
            })
            .collect();
        let text = if engines.is_empty() {
            "No evidence is recorded.".to_owned()
        } else {
            format!("Evidence: {}.", engines.join(", "))
        };
        (text, claim.standing())
    }

    /// The assumptions of the claims used: at the one part that needs it, else at the strategy.
    fn assumptions(&mut self) {
        let mut users: BTreeMap<String, Vec<&str>> = BTreeMap::new();
        for part in PARTS {
            let Some(node) = self.argument.node(part) else {
                continue;
            };
            for goal in &node.supported_by {
                let Some(claim) = self.records.claim(goal.trim_start_matches("G-")) else {
                    continue;
                };
                for id in &claim.assumptions {
                    let places = users.entry(id.clone()).or_default();
                    if !places.contains(&part) {
                        places.push(part);
                    }
                }
            }
        }
        for assumption in &self.records.assumptions {
            let Some(places) = users.get(&assumption.id) else {
                continue;
            };
            let place = if let [only] = places[..] {
                only
            } else {
                STRATEGY
            };
            let id = if assumption.id.starts_with('A') {
                assumption.id.clone()
            } else {
                format!("A-{}", assumption.id)
            };
            let node = Node::new(Kind::Assumption, id, clipped(&assumption.sentence, 160))
                .at(format!("assumption-{}", assumption.id));
            self.argument.hang(place, node);
        }
    }
}

/// A number as it is when short, else rounded.
fn short(x: &passivity_core::BigRational) -> String {
    let exact = x.to_string();
    if exact.len() <= 24 {
        exact
    } else {
        format!("about {}", approx(x))
    }
}

/// A text that fits an element of the drawing.
fn clipped(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let cut: String = text.chars().take(most - 1).collect();
    let end = cut.rfind(' ').unwrap_or(cut.len());
    format!("{}…", &cut[..end])
}
