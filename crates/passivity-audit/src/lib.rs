//! Exact energy accounts of recorded traces.
//!
//! A trace of true positions gives every figure of the account exactly. A trace of encoder counts
//! gives only ξ in [n, n + 1): then every figure is an exact enclosure and every verdict has three
//! values. See [`audit()`] for a trace in a file, [`entry()`] for one interval and [`run`] for many.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

mod ball;
mod enclosure;
pub mod ends;
pub mod entry;
pub mod figure;
pub mod json;
pub mod ledger;
mod log;
pub mod number;
mod plain;
mod provenance;
pub mod reading;
pub mod rows;
pub mod run;
mod shell;
mod span;
pub mod sum;

pub use ends::Ends;
pub use entry::{Entry, Margin, Recorded, entry};
pub use figure::Figure;
pub use json::NumberedRow;
pub use ledger::{Ledger, Logged, Row, Truths};
pub use log::{
    Agreement, Audit, ByLaw, Certificate, Columns, Dialect, Drawn, Finding, Firsts, Fitted, Force,
    Form, Found, Judged, Least, MAX_SAMPLES, MAX_THREADS, Moved, Observer, Options, Otherwise,
    Partial, Point, Positions, Proposal, Report, Role, Running, Sampled, Sampling, Shown, Stretch,
    Supplied, TraceError, UnendedRow, Values, Verdict, audit, audit_arrays, audit_columns,
    audit_csv, audit_files, audit_part, dialects, is_day, legible, merge_parts, samples,
};
pub use number::Number;
pub use provenance::{is_device, is_placeholder};
pub use reading::{Reading, Scaled};
pub use shell::{delimiter_name, notation_options, shell_word};
