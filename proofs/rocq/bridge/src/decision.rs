//! The functions that branch on signs: each way through them is a lemma.

use std::cmp::Ordering;
use std::fmt::Write;

use passivity_core::transfer::is_stable;
use passivity_core::verdict::{Speeds, decide};
use passivity_core::{Criterion, Interval, Loop, Region, Truth, start};
use passivity_terms::paths::{self, Path, Sign};
use passivity_terms::{Term, rocq};

use crate::plain::{criterion, friction, var};

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
    lemmas_by("decide_signs", text, name, variables, paths, conclusion);
}

/// The same, proved by another tactic.
fn lemmas_by<T>(
    tactic: &str,
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
            "\nLemma {name}_{} : forall {variables} : R,\n  {premises}\n  {conclusion}.\nProof. {tactic}. Qed.\n",
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
         From Passivity Require Import Definitions Stability DecisionTactics.\n\
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
    boxes(&mut text);
    stability(&mut text);
    text
}

/// Which denominators of one and of two poles are stable.
fn stability(text: &mut String) {
    text.push_str("\n(** ** [transfer::is_stable] of one pole and of two (TH-LTI) *)\n");
    for (name, inside, letters) in [
        ("stable_one", "pole_inside", &["d0", "d1"][..]),
        ("stable_two", "poles_inside", &["d0", "d1", "d2"][..]),
    ] {
        let denominator: Vec<Term> = letters.iter().map(|letter| var(letter)).collect();
        let all = paths::of(|| is_stable(&denominator));
        let variables = letters.join(" ");
        lemmas_by("decide_stability", text, name, &variables, &all, |stable| {
            format!("d0 <> 0 -> {}({inside} {variables})", truth(*stable))
        });
    }
}

/// The boxes of which one end of each tolerance is decided: friction, and the bound on the speed.
fn boxes(text: &mut String) {
    let viscous = Term::interval("b0", "b1");
    let coulomb = Term::interval("c0", "c1");
    let printed = |beta: &Term, sigma: &Term| {
        let Criterion { viscous, coulomb } = Loop {
            viscous: Some(beta.clone()),
            coulomb: Some(sigma.clone()),
            ..Loop::plain(friction())
        }
        .criterion();
        format!("{} {}", rocq::print(&viscous), rocq::print(&coulomb))
    };
    let of = Loop {
        viscous: Some(viscous.clone()),
        coulomb: Some(coulomb.clone()),
        ..Loop::plain(friction()).map(|_, x| Interval::point(x.clone()))
    };

    text.push_str("\n(** ** [Loop::decide] over tolerances of both frictions, at every speed *)\n");
    let all = paths::of(|| of.decide(&Speeds::All));
    let ordered = "b0 <= b1 -> c0 <= c1 ->";
    let member = printed(&var("b"), &var("c"));
    let worst = printed(viscous.lo(), coulomb.lo());
    let best = printed(viscous.hi(), coulomb.hi());
    lemmas_by(
        "decide_box",
        text,
        "box_all",
        "b0 b1 c0 c1",
        &all,
        |truth| match truth {
            Truth::Holds | Truth::Fails => {
                let not = self::truth(*truth == Truth::Holds);
                format!(
                    "{ordered} forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->\n  {not}(holds_at_all {member})"
                )
            }
            Truth::Depends => {
                format!("{ordered} ~ (holds_at_all {worst}) /\\ (holds_at_all {best})")
            }
        },
    );

    text.push_str("\n(** ** [Loop::decide] over a tolerance of the bound on the speed *)\n");
    let plain = Loop::plain(friction()).map(|_, x| Interval::point(x.clone()));
    let bound = Speeds::UpTo(Term::interval("V0", "V1"));
    let up_to = paths::of(|| plain.decide(&bound));
    let member = printed(&var("beta"), &var("sigma"));
    let ordered = "0 < V0 -> V0 <= V1 ->";
    lemmas_by(
        "decide_bound",
        text,
        "box_up_to",
        "beta sigma V0 V1",
        &up_to,
        |truth| match truth {
            Truth::Holds | Truth::Fails => {
                let not = self::truth(*truth == Truth::Holds);
                format!("{ordered} forall V, V0 <= V <= V1 ->\n  {not}(holds_up_to {member} V)")
            }
            Truth::Depends => {
                format!("{ordered}\n  ~ (holds_up_to {member} V1) /\\ (holds_up_to {member} V0)")
            }
        },
    );
}

const fn truth(holds: bool) -> &'static str {
    if holds { "" } else { "~ " }
}
