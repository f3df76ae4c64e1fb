//! What reports on one joint and on several say in the same words.

use std::borrow::Borrow;
use std::fmt::Write as _;

use passivity_core::{BigRational, Effect, Interval};

use super::decide::Verdict;
use super::limits::Limit;
use super::text::words;
use crate::display::{Rounding, wrapped};
use crate::scene::Motion;
use crate::written::Written;

/// Lines of figures, each with its label.
#[derive(Default)]
pub(crate) struct Lines(pub(crate) String);

impl Lines {
    pub(crate) fn add(&mut self, label: &str, value: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.0, "  {label:<24}  {}", wrapped(value, 28));
    }

    /// The stiffest walls, on the side on which the criterion holds, each with the speeds up to which it does.
    pub(crate) fn add_stiffest(
        &mut self,
        walls: [(&Option<Interval<BigRational>>, &str); 2],
        written: &Written,
        unit: &str,
    ) {
        let mut label = "stiffest wall";
        for (stiffness, speeds) in walls {
            if let Some(stiffness) = stiffness {
                let stiffness = written.rounded_text(stiffness.lo(), Rounding::Down, unit);
                self.add(label, &format!("{stiffness} {speeds}"));
                label = "";
            }
        }
    }

    /// What is in the scene, the theorems that the verdict rests on, and how values were taken.
    pub(crate) fn add_grounds(
        &mut self,
        effects: &[Effect],
        because: &[&'static str],
        remarks: &[String],
    ) {
        self.add("effects", &words(effects));
        if !because.is_empty() {
            self.add("because", &because.join(", "));
        }
        for (at, remark) in remarks.iter().enumerate() {
            self.add(if at == 0 { "taken" } else { "" }, remark);
        }
    }
}

/// The verdict in one line, at the speeds that it speaks of.
pub(crate) fn headline<T: Borrow<str>>(
    verdict: Verdict,
    speeds: &str,
    decided_by: &[T],
    not_covered: &[Effect],
) -> String {
    match verdict {
        Verdict::Passive => format!("PASSIVE {speeds}"),
        Verdict::NotPassive => "NOT PASSIVE: a cycle draws energy from it".to_owned(),
        Verdict::NotGuaranteed => format!("NOT GUARANTEED passive {speeds}: the criterion fails"),
        Verdict::Depends if decided_by.is_empty() => {
            "DEPENDS on digits of π beyond those that were looked at".to_owned()
        }
        Verdict::Depends => format!("DEPENDS on the tolerance of {}", decided_by.join(", ")),
        Verdict::NotCovered => format!("NOT COVERED by a theorem: {}", words(not_covered)),
    }
}

/// What the limits that follow are for.
pub(crate) fn limits_heading(verdict: Verdict, speeds: &str) -> String {
    if verdict == Verdict::Passive {
        format!("  Limits, one parameter at a time, to stay passive {speeds}:\n")
    } else {
        format!("  What each parameter would have to be for the criterion to hold {speeds}:\n")
    }
}

impl Limit {
    /// The limit as a line; `of` says of what the parameter is, where there are several.
    pub(crate) fn line(&self, of: &str, motion: Motion) -> String {
        let enough = if self.printed.is_some() {
            ""
        } else {
            "; this alone does not suffice"
        };
        format!(
            "    {}{of}: {} (now {}){enough}\n",
            self.name(motion),
            self.promise(motion),
            self.now(motion)
        )
    }
}
