//! Traces, CSV, Parquet and MCAP, in one of a few scenes.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use passivity_audit::{Audit, Dialect, Options, TraceError, audit, audit_csv};
use passivity_scene::Scene;

/// The first byte of the input says which.
const SCENES: [&str; 6] = [
    "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"",
    "[dimensionless]\nbeta = \"1/4\"\nsigma = \"1 ± 1/100\"\n[wall]\nunilateral = true",
    "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n[sampling]\ndelay = 2\n[wall]\ndamping = \"1/4\"\nforce_step = \"2/3\"",
    "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"2 N m/rad\"",
    "[device]\nviscous = \"1 N s/m\"\n[sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"1 N/mm\"\nmax_force = \"3 N\"",
    "[device]\nviscous = \"1 N s/m\"\ncoulomb = \"1 N\"\n[sampling]\nperiod = \"1 ms\"\n[encoder]\nresolution = \"0.25 mm\"\n[wall]\nstiffness = \"1 N/mm\"",
];

fn scene(byte: u8) -> &'static Scene {
    static READ: OnceLock<Vec<Scene>> = OnceLock::new();
    let read = |text: &&str| Scene::from_toml("fuzz", text).unwrap_or_else(|e| panic!("{e}"));
    let scenes = READ.get_or_init(|| SCENES.iter().map(read).collect());
    &scenes[usize::from(byte) % scenes.len()]
}

/// An audit with its rows.
fn audited(csv: &[u8], scene: &Scene, threads: usize, block: usize) -> Found {
    let mut rows = Vec::new();
    let options = Options {
        rows: Some(&mut rows),
        points: true,
        law: false,
        threads,
        block,
        ..Options::default()
    };
    let input = Box::new(std::io::Cursor::new(csv.to_vec()));
    Found::of(audit_csv(input, scene, options), rows)
}

#[derive(Debug, PartialEq)]
struct Found {
    report: Result<String, TraceError>,
    rows: Vec<u8>,
}

impl Found {
    fn of(audit: Result<Audit, TraceError>, rows: Vec<u8>) -> Self {
        let report = audit.map(|audit| {
            kept(&audit, &rows);
            assert!(!audit.to_text().is_empty(), "a report without text");
            audit.to_json().to_string()
        });
        if let Err(error) = &report {
            assert!(!error.to_string().is_empty(), "an error that says nothing");
        }
        Self { report, rows }
    }
}

/// What came before a mistake is kept: a row for every interval accounted for, and the mistake in
/// the row after the last sample.
fn kept(audit: &Audit, rows: &[u8]) {
    let written = rows.iter().filter(|byte| **byte == b'\n').count() as u64;
    let totals = audit.totals();
    assert_eq!(written, totals.intervals + 1, "rows of the ledger");
    let linear = audit.tallies().linear;
    let counted = linear.holds + linear.fails + linear.depends;
    assert_eq!(counted, totals.intervals, "intervals judged");
    if let Some(error) = audit.error() {
        let row = error
            .row
            .unwrap_or_else(|| panic!("an error without its row: {error}"));
        assert!(
            row >= totals.intervals,
            "row {row} after {} intervals",
            totals.intervals
        );
    }
}

/// A report or an error, the same however the work is cut up.
pub(crate) fn csv(data: &[u8]) {
    let Some((first, csv)) = data.split_first() else {
        return;
    };
    let scene = scene(*first);
    let whole = audited(csv, scene, 1, 0);
    let block = 1 + usize::from(first / 6);
    let cut = audited(csv, scene, 2, block);
    assert_eq!(whole, cut, "blocks of {block} bytes");
}

/// A report or an error.
pub(crate) fn parquet(data: &[u8]) {
    in_file(data, "parquet", |path, scene| {
        read(path, scene, Dialect::default());
    });
}

/// A report or an error; by the columns that the error proposes, where it does.
pub(crate) fn mcap(data: &[u8]) {
    in_file(data, "mcap", |path, scene| {
        let Some(error) = read(path, scene, Dialect::default()) else {
            return;
        };
        if let Some(proposal) = error.proposal {
            let columns = proposal.columns.parse();
            let columns = columns.unwrap_or_else(|e| panic!("{}: {e}", proposal.columns));
            let told = Dialect {
                columns: Some(columns),
                ..Dialect::default()
            };
            read(path, scene, told);
        }
    });
}

/// Gives the bytes as a file, in the scene that the first byte names.
fn in_file(data: &[u8], extension: &str, read: impl Fn(&Path, &Scene)) {
    let Some((first, bytes)) = data.split_first() else {
        return;
    };
    let path = file(extension);
    if let Err(error) = fs::write(&path, bytes) {
        panic!("{}: {error}", path.display());
    }
    read(&path, scene(*first));
    // A file that stays behind in the temporary folder does no harm.
    let _ = fs::remove_file(&path);
}

/// Audits a file with its rows; gives what is refused.
fn read(path: &Path, scene: &Scene, dialect: Dialect) -> Option<TraceError> {
    let mut rows = Vec::new();
    let options = Options {
        rows: Some(&mut rows),
        threads: 1,
        dialect,
        ..Options::default()
    };
    let found = audit(path, scene, options);
    Found::of(found, rows).report.err()
}

/// A file for this thread alone.
fn file(extension: &str) -> PathBuf {
    let name = format!(
        "passivity-fuzz-{}-{:?}.{extension}",
        std::process::id(),
        std::thread::current().id()
    );
    std::env::temp_dir().join(name.replace(['(', ')'], ""))
}
