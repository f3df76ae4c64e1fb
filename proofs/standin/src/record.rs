//! The record that a run leaves for the table of evidence.

use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::Path;

use serde_json::json;

use crate::explore::{Mode, Seen};
use crate::list::Entry;

/// Appends one line to `kani-standin.jsonl` in `folder`; `proofs/kani/README.md` has its fields.
pub(crate) fn append(
    folder: &Path,
    entry: &Entry,
    seen: &Seen,
    faults: &[String],
    seconds: f64,
) -> std::io::Result<()> {
    let (mode, result) = match seen.mode {
        Mode::Exhausted => ("exhausted", format!("exhausted on {}", entry.domain)),
        Mode::Sampled => ("sampled", format!("sampled, {} cases", seen.cases)),
    };
    let record = json!({
        "engine": "stand-in",
        "harness": entry.name,
        "claims": entry.claims,
        "domain": entry.domain,
        "mode": mode,
        "cases": seen.cases,
        "must_fail": entry.must_fail,
        "covers": seen.hits,
        "passed": faults.is_empty(),
        "result": if faults.is_empty() { result } else { format!("failed: {}", faults.join("; ")) },
        "seconds": (seconds * 1000.0).round() / 1000.0,
    });
    std::fs::create_dir_all(folder)?;
    let mut file = OpenOptions::new()
        .create(true)
        .append(true)
        .open(folder.join("kani-standin.jsonl"))?;
    // One write, so that tests that run side by side do not mix their lines.
    file.write_all(format!("{record}\n").as_bytes())
}
