//! The safety case: claims and recorded evidence about a scene, as an argument and a document.
//!
//! [`argue`](argument::argue) builds the argument of a scene in Goal Structuring Notation, and
//! [`draw`](draw::draw) draws it. Evidence is bound by hash to the text of its claim and to the
//! sources that it covers: what changed since is *stale*, what was never run is *not run here*. The
//! document is HTML; its print style sheet is the layout on paper, and [`mod@print`] has a browser print
//! it as PDF.
//!
//! What it is **not**: a claim of compliance with any standard, and no judge. It shows what was
//! shown, on which assumptions, and what is open.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

pub mod argument;
pub mod case;
pub mod check;
pub mod criterion;
pub mod document;
pub mod draw;
pub mod error;
pub mod figures;
mod files;
pub mod folder;
pub mod gsn;
pub mod html;
pub mod info;
pub mod manifest;
pub mod print;
pub mod recorded;
pub mod records;
pub mod sections;
mod stated;
pub mod study;
pub mod tree;

pub use case::Case;
pub use error::CaseError;
pub use info::Info;
pub use recorded::{Recorded, Recording, Recordings};
pub use records::{Origin, Records};
pub use stated::Stated;
pub use study::Study;
