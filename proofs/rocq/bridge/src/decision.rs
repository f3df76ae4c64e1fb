//! The functions that branch on signs: each way through them is a lemma.

use std::cmp::Ordering;
use std::fmt::Write;

use passivity_core::verdict::{Speeds, decide};
use passivity_core::{Region, start};
use passivity_terms::paths::{self, Path, Sign};
use passivity_terms::rocq;

use crate::plain::{criterion, var};

fn premise(sign: &Sign) -> String {
    let term = rocq::print(&sign.term);
    match sign.sign {
        Ordering::Less => format!("{term} < 0"),
        Ordering::Equal => format!("{term} = 0"),
        Ordering::Greater => format!("0 < {term}"),
    }
}

const fn region_name(region: Region) -> &'static str {
    match region {
        Region::GloballyStable => "globally_stable",
        Region::LocallyStable => "locally_stable",
        Region::LimitCycles => "limit_cycles",
        Region::Unstable => "unstable",
    }
}

/// One lemma a path: the signs on it imply what `conclusion` says of its result.
fn lemmas<T>(
    text: &mut String,
    name: &str,
    variables: &str,
    paths: &[Path<Option<T>>],
    conclusion: impl Fn(&T) -> String,
) {
    for (i, path) in paths.iter().enumerate() {
        let premises = path
            .signs
            .iter()
            .map(|s| premise(s) + " ->")
            .collect::<Vec<_>>()
            .join(" ");
        let conclusion = path.result.as_ref().map_or("False".to_owned(), &conclusion);
        // Writing to a string does not fail.
        let _ = write!(
            text,
            "\nLemma {name}_{} : forall {variables} : R,\n  {premises}\n  {conclusion}.\nProof. decide_signs. Qed.\n",
            i + 1
        );
    }
}

/// The text of `Decisions.v`.
pub(crate) fn decisions() -> String {
    let mut text = String::from(
        "(** * Decisions: each way through the kernel's branches says what the criterion says.\n\n    \
         Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)\n\n\
         From Coq Require Import Reals.\n\
         From Passivity Require Import Definitions DecisionTactics.\n\
         Open Scope R_scope.\n",
    );
    text.push_str("\n(** ** [Region::of] (TH-REGION) *)\n");
    let of = paths::of(|| Region::of(&criterion()));
    lemmas(&mut text, "region", "viscous coulomb", &of, |region| {
        format!("{} viscous coulomb", region_name(*region))
    });

    text.push_str("\n(** ** [verdict::decide] at every speed *)\n");
    let all = paths::of(|| decide(&criterion(), &Speeds::All));
    lemmas(&mut text, "decide_all", "viscous coulomb", &all, |d| {
        format!("{}(holds_at_all viscous coulomb)", truth(d.holds))
    });

    text.push_str("\n(** ** [verdict::decide] up to a speed *)\n");
    let up_to = paths::of(|| decide(&criterion(), &Speeds::UpTo(var("V"))));
    lemmas(
        &mut text,
        "decide_up_to",
        "viscous coulomb V",
        &up_to,
        |d| format!("0 < V -> {}(holds_up_to viscous coulomb V)", truth(d.holds)),
    );

    text.push_str("\n(** ** [verdict::decide] up to a speed given by its square *)\n");
    let squared = paths::of(|| decide(&criterion(), &Speeds::UpToSquared(var("V2"))));
    lemmas(
        &mut text,
        "decide_squared",
        "viscous coulomb V2",
        &squared,
        |d| {
            format!(
                "forall V, 0 < V -> V ^ 2 = V2 -> {}(holds_up_to viscous coulomb V)",
                truth(d.holds)
            )
        },
    );

    text.push_str("\n(** ** [start::holds_up_to] (TH-START) *)\n");
    let started = paths::of(|| start::holds_up_to(&criterion(), &var("V2")));
    lemmas(
        &mut text,
        "start",
        "viscous coulomb V2",
        &started,
        |holds| {
            format!(
                "forall V, 0 < V -> V ^ 2 = V2 -> {}(holds_up_to viscous coulomb V)",
                truth(*holds)
            )
        },
    );
    text
}

const fn truth(holds: bool) -> &'static str {
    if holds { "" } else { "~ " }
}
