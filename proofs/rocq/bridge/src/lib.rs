//! The bridge between the kernel and the theorems in Rocq.
//!
//! The kernel's generic functions run on [`Term`](passivity_terms::Term)s and so write down what
//! they compute. [`files`] prints each result as a Rocq definition, with the lemma that it equals
//! the definition of `Definitions.v` that the theorems speak of. Rocq proves the lemmas. So an
//! edit to a formula of the kernel, or to a definition of the theorems, shows.
//!
//! The last of them does the same for the functions that branch on signs: each way through them is
//! a lemma about what the criterion then says.
//!
//! It is **not** a translation of Rust: what is compared is the formula that the code computed
//! when it ran on variables. Loops over a list are run for the lengths that are listed.

mod actuator;
mod controller;
mod decision;
mod effects;
mod formula;
mod plain;
mod units;

pub use formula::Formula;

/// A generated file: its name and its text.
pub type File = (&'static str, String);

/// The formulas that are compared, by the file they go to.
#[must_use]
pub fn formulas() -> Vec<(&'static str, Vec<Formula>)> {
    vec![
        ("BridgePaper.v", plain::formulas()),
        ("BridgeEffects.v", effects::formulas()),
        ("BridgeUnits.v", units::formulas()),
        ("BridgeController.v", controller::formulas()),
        ("BridgeActuator.v", actuator::formulas()),
    ]
}

/// Every generated file.
#[must_use]
pub fn files() -> Vec<File> {
    let mut files: Vec<File> = formulas()
        .into_iter()
        .map(|(name, formulas)| {
            let required = match name {
                "BridgeActuator.v" => actuator::REQUIRED,
                _ => "ControllerTactics",
            };
            (name, bridge(required, &formulas))
        })
        .collect();
    files.push(("Decisions.v", decision::decisions()));
    files
}

fn bridge(required: &str, formulas: &[Formula]) -> String {
    let mut text = format!(
        "(** * Bridge: each formula of the kernel is the definition that the theorems use.\n\n    \
         Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)\n\n\
         From Coq Require Import Reals Lra.\n\
         From Passivity Require Import Definitions BridgeTactics {required}.\n\
         Open Scope R_scope.\n",
    );
    for formula in formulas {
        text.push('\n');
        text.push_str(&formula.print());
    }
    text
}
