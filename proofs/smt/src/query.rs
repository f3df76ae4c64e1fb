//! A claim as a question to a solver, its twin and its mutant.

use std::fmt::Write as _;
use std::panic::Location;

use passivity_terms::smt::Printer;

use crate::formula::{Formula, not};

/// What a solver answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Some numbers satisfy the assertions.
    Sat,
    /// No numbers do.
    Unsat,
}

impl Answer {
    /// The word of SMT-LIB.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Sat => "sat",
            Self::Unsat => "unsat",
        }
    }
}

/// One statement of a claim: whatever meets the premises meets the goal.
#[derive(Clone, Debug)]
pub struct Query {
    /// The id of the claim.
    pub claim: &'static str,
    /// What of the claim it is, in a word or two; with the id, the name of its files.
    pub part: &'static str,
    /// The statement in one sentence.
    pub says: &'static str,
    /// The source file that it is written in, from the root of the workspace.
    pub source: &'static str,
    /// The premises.
    pub premises: Vec<Formula>,
    /// The goal.
    pub goal: Formula,
    /// What is changed to make it false, in words, and the changed premises and goal.
    pub mutant: Option<(&'static str, Vec<Formula>, Formula)>,
    /// Whether floors are whole numbers here, or any n with n ≤ x < n + 1.
    pub whole_floors: bool,
    /// Whether the claim is false as printed: then the query must have an answer.
    pub refuted: bool,
}

/// One question in SMT-LIB.
#[derive(Clone, Debug)]
pub struct Script {
    /// The name of its file, without `.smt2`.
    pub name: String,
    /// The id of the claim.
    pub claim: &'static str,
    /// The answer it must have.
    pub expected: Answer,
    /// Its text.
    pub text: String,
    /// The variables of the query.
    pub variables: Vec<String>,
    /// What it asserts: a model is one on which the kernel computes that all of them hold.
    pub assertions: Vec<Formula>,
}

impl Query {
    /// A query of the claim, true of all numbers until premises are added.
    #[must_use]
    #[track_caller]
    pub const fn new(claim: &'static str, part: &'static str, says: &'static str) -> Self {
        Self {
            claim,
            part,
            says,
            source: Location::caller().file(),
            premises: Vec::new(),
            goal: Formula::All(Vec::new()),
            mutant: None,
            whole_floors: false,
            refuted: false,
        }
    }

    /// With more premises.
    #[must_use]
    pub fn given(mut self, premises: impl IntoIterator<Item = Formula>) -> Self {
        self.premises.extend(premises);
        self
    }

    /// With this goal.
    #[must_use]
    pub fn then(mut self, goal: Formula) -> Self {
        self.goal = goal;
        self
    }

    /// With a mutant that has the same premises and another goal.
    #[must_use]
    pub fn but_not(mut self, says: &'static str, goal: Formula) -> Self {
        self.mutant = Some((says, self.premises.clone(), goal));
        self
    }

    /// With a mutant that lacks the last `count` premises.
    #[must_use]
    pub fn not_without(mut self, says: &'static str, count: usize) -> Self {
        let kept = self.premises.len().saturating_sub(count);
        let premises = self.premises.iter().take(kept).cloned().collect();
        self.mutant = Some((says, premises, self.goal.clone()));
        self
    }

    /// With a mutant of which the query's own premises need not hold.
    #[must_use]
    pub fn rescued(
        mut self,
        says: &'static str,
        premises: impl IntoIterator<Item = Formula>,
        goal: Formula,
    ) -> Self {
        self.mutant = Some((says, premises.into_iter().collect(), goal));
        self
    }

    /// With a mutant that is looked for where these hold: a counterexample near at hand.
    #[must_use]
    pub fn at(mut self, hints: impl IntoIterator<Item = Formula>) -> Self {
        if let Some((_, premises, _)) = &mut self.mutant {
            premises.extend(hints);
        }
        self
    }

    /// With whole floors.
    #[must_use]
    pub const fn whole(mut self) -> Self {
        self.whole_floors = true;
        self
    }

    /// A claim that is false as printed.
    #[must_use]
    pub const fn refuted(mut self) -> Self {
        self.refuted = true;
        self
    }

    /// The stem of its file names: the claim's id and the part.
    #[must_use]
    pub fn name(&self) -> String {
        let id = self
            .claim
            .to_lowercase()
            .replace("..", "_")
            .replace(['-', '/'], "_");
        format!("{id}_{}", self.part.replace(' ', "_"))
    }

    /// The question itself, that the premises can be met, and the mutant.
    #[must_use]
    pub fn scripts(&self) -> Vec<Script> {
        let name = self.name();
        let expected = if self.refuted {
            Answer::Sat
        } else {
            Answer::Unsat
        };
        let question = if self.refuted {
            "as printed: refuted by every model"
        } else {
            self.says
        };
        let negated = |goal: &Formula| Some(not(goal.clone()));
        let mut scripts = vec![self.script(
            name.clone(),
            question,
            &self.premises,
            negated(&self.goal),
            expected,
        )];
        if !self.refuted {
            let twin = "the premises can be met";
            scripts.push(self.script(
                format!("{name}.premises"),
                twin,
                &self.premises,
                None,
                Answer::Sat,
            ));
        }
        if let Some((says, premises, goal)) = &self.mutant {
            let expected = if self.refuted {
                Answer::Unsat
            } else {
                Answer::Sat
            };
            scripts.push(self.script(
                format!("{name}.mutant"),
                says,
                premises,
                negated(goal),
                expected,
            ));
        }
        scripts
    }

    fn script(
        &self,
        name: String,
        says: &str,
        premises: &[Formula],
        negated_goal: Option<Formula>,
        expected: Answer,
    ) -> Script {
        let mut variables = Vec::new();
        for formula in premises.iter().chain(&negated_goal) {
            formula.variables(&mut variables);
        }
        // Whoever says that there are such numbers has to say so with whole floors.
        let body = |mut printer: Printer| {
            let mut body = String::new();
            for premise in premises {
                let text = premise.print(&mut printer);
                let _ = writeln!(body, "(assert {text})");
            }
            if let Some(goal) = &negated_goal {
                let text = goal.print(&mut printer);
                let _ = writeln!(body, "; what would contradict the goal\n(assert {text})");
            }
            (printer, body)
        };
        let (mut printer, mut text) = body(Printer::default());
        let whole = self.whole_floors || expected == Answer::Sat;
        let whole = whole && !printer.floors().is_empty();
        if whole {
            (printer, text) = body(Printer::with_whole_floors());
        }
        let linear = premises.iter().chain(&negated_goal).all(Formula::is_linear);
        let logic = match (linear, whole) {
            (true, true) => "QF_LIRA",
            (false, true) => "QF_NIRA",
            (_, false) => "QF_NRA",
        };
        let assertions = premises.iter().chain(&negated_goal).cloned().collect();
        let declared: String = variables
            .iter()
            .map(|name| format!("(declare-const {name} Real)\n"))
            .collect();
        let text = format!(
            "; {}, {}: {}\n; {says}\n; printed from the kernel's code; expected answer: {}\n\
             (set-option :produce-models true)\n(set-logic {logic})\n\
             (set-info :status {})\n{declared}{}{text}(check-sat)\n",
            self.claim,
            self.part,
            self.says,
            expected.word(),
            expected.word(),
            printer.preamble(),
        );
        Script {
            name,
            claim: self.claim,
            expected,
            text,
            variables,
            assertions,
        }
    }
}
