//! The text of this crate's own source files.
//!
//! Evidence is bound to the sources that it speaks of. A program that runs where the sources are
//! not can so still say of which kernel it was built, and which evidence speaks of it.

macro_rules! sources {
    ($($name:literal)*) => {
        &[$((concat!("crates/passivity-core/src/", $name), include_str!($name)),)*]
    };
}

/// Each source file: its path from the root of the workspace, and its text.
pub const SOURCES: &[(&str, &str)] = sources! {
    "absolute_sum.rs"
    "actuator.rs"
    "circle.rs"
    "control_loop.rs"
    "controller.rs"
    "counted.rs"
    "course.rs"
    "criterion.rs"
    "decision.rs"
    "definite.rs"
    "dissipation.rs"
    "drawn.rs"
    "drift.rs"
    "edge_cycle.rs"
    "effect.rs"
    "exponential.rs"
    "extra_storage.rs"
    "extremes.rs"
    "fraction.rs"
    "frequency.rs"
    "generation.rs"
    "interval.rs"
    "joint_criterion.rs"
    "joint_cycle.rs"
    "joints.rs"
    "law.rs"
    "ledger.rs"
    "lib.rs"
    "linear_part.rs"
    "parameter.rs"
    "periodic.rs"
    "pi.rs"
    "polynomial.rs"
    "quantizer.rs"
    "rational.rs"
    "region.rs"
    "scalar.rs"
    "smoothed.rs"
    "sources.rs"
    "spring.rs"
    "start.rs"
    "stiffness.rs"
    "sturm.rs"
    "transfer.rs"
    "verdict.rs"
    "wave.rs"
    "whole.rs"
    "witness.rs"
};
