//! The friction of a haptic device, and its inertia, from logs of its motion: a box that surely holds them,
//! and the best estimate in it (TH-IDENT).
//!
//! A log is one experiment: the device starts at rest, nobody touches it, and the force that was commanded
//! is known and held from each sample to the next. The model is m·v̇ = u − b·v − c·sgn(v), with rest where
//! |u| ≤ c. Positions are known to a tick and the error of a count. Every part of the parameters that is
//! discarded is refuted by an enclosure of all its motions (see `motion`), so the box holds the true ones,
//! if the device is one of this model; where nothing is left, it is none.
//!
//! Dimensionless inside: positions in ticks, times in sampling periods, forces in KΔ.
//!
//! What it is **not**: it does not say whether a wall is passive, and it takes no part of the motion under a
//! hand.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

mod directed;
mod estimate;
mod fitting;
mod hash;
mod identified;
mod kept;
mod lacks;
mod log;
mod motion;
mod options;
#[cfg(feature = "plot")]
mod picture;
mod propagator;
mod region;
mod report;
mod search;
mod sketch;
mod stop;
mod suspects;
mod written;

pub use hash::sha256;
pub use identified::{Bounds, Identified, IdentifyError, Refutation, identify, read};
pub use lacks::Lack;
pub use options::{Inertia, Options};
pub use passivity_audit::{Dialect, Sampled, TraceError};
pub use report::{Known, LogReport, Parameters, RefutedBy, Report, nearest};
pub use written::{Provenance, read_sketch, remarks};
