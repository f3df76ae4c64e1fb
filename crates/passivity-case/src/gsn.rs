//! Goal Structuring Notation, community standard version 3: the elements of an argument and how
//! they hang together, written as YAML in the form that the tool `gsn2x` reads.

use std::fmt::Write as _;

/// What an element is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A claim, drawn as a rectangle.
    Goal,
    /// How a goal is broken down, drawn as a parallelogram.
    Strategy,
    /// A reference to evidence, drawn as a circle.
    Solution,
    /// Where the claim is made, drawn with round ends.
    Context,
    /// What is taken for granted, drawn as an oval with an A.
    Assumption,
    /// Why the argument is made this way, drawn as an oval with a J.
    Justification,
    /// A claim against another element (dialectic extension).
    CounterGoal,
    /// Evidence for a counter goal.
    CounterSolution,
}

impl Kind {
    /// The name of the type in GSN.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Goal => "Goal",
            Self::Strategy => "Strategy",
            Self::Solution => "Solution",
            Self::Context => "Context",
            Self::Assumption => "Assumption",
            Self::Justification => "Justification",
            Self::CounterGoal => "CounterGoal",
            Self::CounterSolution => "CounterSolution",
        }
    }

    /// The type in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::CounterGoal => "counter goal",
            Self::CounterSolution => "counter evidence",
            Self::Goal => "goal",
            Self::Strategy => "strategy",
            Self::Solution => "solution",
            Self::Context => "context",
            Self::Assumption => "assumption",
            Self::Justification => "justification",
        }
    }

    /// What the ids of this type start with.
    #[must_use]
    pub const fn prefix(self) -> &'static str {
        match self {
            Self::Goal => "G",
            Self::Strategy => "S",
            Self::Solution => "Sn",
            Self::Context => "C",
            Self::Assumption => "A",
            Self::Justification => "J",
            Self::CounterGoal => "CG",
            Self::CounterSolution => "CSn",
        }
    }

    /// Whether elements of this type take part in the argument, and do not only surround it.
    #[must_use]
    pub const fn argues(self) -> bool {
        !matches!(self, Self::Context | Self::Assumption | Self::Justification)
    }
}

/// How an element stands, from worst to best: what it rests on decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Standing {
    /// Refuted by a counter goal.
    Defeated,
    /// Nothing supports it yet.
    Open,
    /// Some evidence was never recorded.
    NotRun,
    /// Some evidence was recorded for another text of its claim or sources.
    Stale,
    /// Everything under it is shown.
    Shown,
}

impl Standing {
    /// The word for it, used in every output.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Defeated => "defeated",
            Self::Open => "open",
            Self::NotRun => "not run here",
            Self::Stale => "stale",
            Self::Shown => "shown",
        }
    }
}

/// A place in the document that says more about an element of the argument.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// A claim, by its id.
    Claim(String),
    /// An assumption, by its id.
    Assumption(String),
    /// A section: its id in the document, and its title.
    Section(String, &'static str),
}

impl Anchor {
    /// The id of the place in the document.
    #[must_use]
    pub fn id(&self) -> String {
        match self {
            Self::Claim(id) => format!("claim-{id}"),
            Self::Assumption(id) => format!("assumption-{id}"),
            Self::Section(id, _) => id.clone(),
        }
    }

    /// What a reference to the place is called.
    #[must_use]
    pub fn title(&self) -> &str {
        match self {
            Self::Claim(id) | Self::Assumption(id) => id,
            Self::Section(_, title) => title,
        }
    }
}

/// An element of an argument.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Node {
    /// The id, which starts with the prefix of its kind.
    pub id: String,
    /// What it is.
    pub kind: Kind,
    /// What it says, in a sentence or two.
    pub text: String,
    /// Ids of the elements that support it.
    pub supported_by: Vec<String>,
    /// Ids of the contexts, assumptions and justifications it stands in.
    pub in_context_of: Vec<String>,
    /// The id of the element that it challenges.
    pub challenges: Option<String>,
    /// How it stands; contexts, assumptions and justifications have no standing.
    pub standing: Option<Standing>,
    /// Where the document says more about it.
    pub anchor: Option<Anchor>,
}

impl Node {
    /// An element that nothing supports yet: a goal or strategy starts out open.
    #[must_use]
    pub fn new(kind: Kind, id: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            id: id.into(),
            kind,
            text: text.into(),
            supported_by: Vec::new(),
            in_context_of: Vec::new(),
            challenges: None,
            standing: kind.argues().then_some(Standing::Open),
            anchor: None,
        }
    }

    /// The same element with a place in the document.
    #[must_use]
    pub fn at(mut self, anchor: Anchor) -> Self {
        self.anchor = Some(anchor);
        self
    }

    /// The same element with a standing of its own.
    #[must_use]
    pub const fn stands(mut self, standing: Standing) -> Self {
        self.standing = Some(standing);
        self
    }

    /// Whether it is a goal or strategy without support, drawn with a diamond.
    #[must_use]
    pub fn is_undeveloped(&self) -> bool {
        matches!(self.kind, Kind::Goal | Kind::Strategy) && self.supported_by.is_empty()
    }

    /// Whether a counter goal defeats it.
    #[must_use]
    pub fn is_defeated(&self) -> bool {
        self.standing == Some(Standing::Defeated)
    }
}

/// An argument: one top goal and everything under it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Argument {
    /// What the argument is about, in a line.
    pub title: String,
    top: Node,
    others: Vec<Node>,
}

impl Argument {
    /// An argument with its top goal.
    #[must_use]
    pub fn new(title: impl Into<String>, top: Node) -> Self {
        Self {
            title: title.into(),
            top,
            others: Vec::new(),
        }
    }

    /// The elements, the top goal first and each before what was hung under it later.
    pub fn nodes(&self) -> impl DoubleEndedIterator<Item = &Node> {
        std::iter::once(&self.top).chain(&self.others)
    }

    /// The top goal.
    #[must_use]
    pub const fn top(&self) -> &Node {
        &self.top
    }

    /// How the top goal stands.
    #[must_use]
    pub fn standing(&self) -> Standing {
        // A goal has a standing from the start.
        self.top.standing.unwrap_or(Standing::Open)
    }

    /// An element by its id.
    #[must_use]
    pub fn node(&self, id: &str) -> Option<&Node> {
        self.nodes().find(|node| node.id == id)
    }

    fn node_mut(&mut self, id: &str) -> Option<&mut Node> {
        std::iter::once(&mut self.top)
            .chain(&mut self.others)
            .find(|node| node.id == id)
    }

    /// Hangs `node` under `parent`: as support or, for a context, assumption or justification,
    /// as what the parent stands in. An id that is there already is linked and not added again.
    pub fn hang(&mut self, parent: &str, node: Node) {
        if let Some(above) = self.node_mut(parent) {
            let list = if node.kind.argues() {
                &mut above.supported_by
            } else {
                &mut above.in_context_of
            };
            // What supports several elements is there once, with its own support.
            if !list.contains(&node.id) {
                list.push(node.id.clone());
            }
        }
        if self.node(&node.id).is_none() {
            self.others.push(node);
        }
    }

    /// Adds a counter goal against `target`, which is defeated by it.
    pub fn challenge(&mut self, target: &str, mut counter: Node) {
        if let Some(below) = self.node_mut(target) {
            below.standing = Some(Standing::Defeated);
        }
        counter.challenges = Some(target.to_owned());
        self.others.push(counter);
    }

    /// Carries the standing of the evidence up: an element stands as its worst support does, one
    /// that a counter goal defeated stays defeated, and what rests on a defeated element is open.
    pub fn settle(&mut self) {
        // Supports are added after what they support, so a pass from the end sees them first, but for those of
        // several elements: another pass has them. No support goes in a circle, so this comes to an end.
        let ids: Vec<String> = self.nodes().rev().map(|node| node.id.clone()).collect();
        let mut changed = true;
        while changed {
            changed = false;
            for id in &ids {
                let worst = self.worst_support(id);
                if let (Some(node), Some(worst)) = (self.node_mut(id), worst)
                    && !node.is_defeated()
                    && node.standing != Some(worst)
                {
                    node.standing = Some(worst);
                    changed = true;
                }
            }
        }
    }

    fn worst_support(&self, id: &str) -> Option<Standing> {
        let supports = self.node(id)?.supported_by.iter();
        supports
            .filter_map(|id| self.node(id)?.standing)
            .map(|standing| standing.max(Standing::Open))
            .min()
    }

    /// The open points: goals and strategies that nothing supports, and evidence never recorded.
    pub fn open(&self) -> impl Iterator<Item = &Node> {
        self.nodes().filter(|node| {
            node.supported_by.is_empty()
                && matches!(node.standing, Some(Standing::Open | Standing::NotRun))
        })
    }

    /// The argument as YAML for `gsn2x`, with the standing of each element as a further attribute.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_case::gsn::{Argument, Kind, Node, Standing};
    ///
    /// let mut argument = Argument::new("a wall", Node::new(Kind::Goal, "G1", "It is passive."));
    /// argument.hang("G1", Node::new(Kind::Solution, "Sn1", "A proof.").stands(Standing::Shown));
    /// argument.settle();
    /// assert!(argument.to_yaml().contains("supportedBy: [Sn1]"));
    /// ```
    #[must_use]
    pub fn to_yaml(&self) -> String {
        // Writing to a string cannot fail.
        let mut out = format!("module:\n  name: {}\n", quoted(&self.title));
        for node in self.nodes() {
            let _ = write!(out, "\n{}:\n  text: {}\n", node.id, quoted(&node.text));
            if matches!(node.kind, Kind::CounterGoal | Kind::CounterSolution) {
                let _ = writeln!(out, "  nodeType: {}", node.kind.name());
            }
            for (key, ids) in [
                ("supportedBy", &node.supported_by),
                ("inContextOf", &node.in_context_of),
            ] {
                if !ids.is_empty() {
                    let _ = writeln!(out, "  {key}: [{}]", ids.join(", "));
                }
            }
            if let Some(target) = &node.challenges {
                let _ = writeln!(out, "  challenges: {target}");
            }
            if node.is_undeveloped() {
                out.push_str("  undeveloped: true\n");
            }
            if node.is_defeated() {
                out.push_str("  defeated: true\n");
            }
            if let Some(standing) = node.standing {
                let _ = writeln!(out, "  standing: {}", quoted(standing.words()));
            }
        }
        out
    }
}

/// A double-quoted YAML scalar: JSON's escapes are a subset of YAML's.
fn quoted(text: &str) -> String {
    serde_json::Value::String(text.to_owned()).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_level(standing: Standing) -> Argument {
        let mut argument = Argument::new("t", Node::new(Kind::Goal, "G1", "top"));
        argument.hang("G1", Node::new(Kind::Strategy, "S1", "how"));
        argument.hang("S1", Node::new(Kind::Goal, "G2", "one"));
        argument.hang("S1", Node::new(Kind::Goal, "G3", "two"));
        argument.hang(
            "G2",
            Node::new(Kind::Solution, "Sn1", "proof").stands(Standing::Shown),
        );
        argument.hang(
            "G3",
            Node::new(Kind::Solution, "Sn2", "proof").stands(standing),
        );
        argument
    }

    #[test]
    fn an_element_stands_as_its_worst_support_does() {
        for standing in [
            Standing::Open,
            Standing::NotRun,
            Standing::Stale,
            Standing::Shown,
        ] {
            let mut argument = two_level(standing);
            argument.settle();
            assert_eq!(argument.top().standing, Some(standing));
            assert_eq!(
                argument.node("G2").and_then(|n| n.standing),
                Some(Standing::Shown)
            );
        }
    }

    #[test]
    fn what_rests_on_a_defeated_goal_is_open_and_a_defeated_goal_stays_so() {
        let mut argument = two_level(Standing::Shown);
        argument.challenge("G3", Node::new(Kind::CounterGoal, "CG1", "no"));
        argument.settle();
        assert_eq!(
            argument.node("G3").and_then(|n| n.standing),
            Some(Standing::Defeated)
        );
        assert_eq!(argument.top().standing, Some(Standing::Open));
        argument.challenge("G1", Node::new(Kind::CounterGoal, "CG2", "no"));
        argument.settle();
        assert_eq!(argument.top().standing, Some(Standing::Defeated));
    }

    #[test]
    fn text_is_escaped() {
        let argument = Argument::new("a \"b\": #c", Node::new(Kind::Goal, "G1", "x: [y]\n- z"));
        let yaml = argument.to_yaml();
        assert!(yaml.contains(r#"name: "a \"b\": #c""#), "{yaml}");
        assert!(yaml.contains(r#"text: "x: [y]\n- z""#), "{yaml}");
        assert!(yaml.contains("undeveloped: true"), "{yaml}");
    }
}
