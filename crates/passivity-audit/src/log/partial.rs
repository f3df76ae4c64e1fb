//! The account of a stretch of a log in a file of its own, and the report of the whole log from all of them.
//!
//! Every figure of an account is a sum, a least value, a count or a first interval, and each is kept exactly:
//! that of two stretches is made of those of each, whichever way they are grouped. A stretch starts with the
//! samples before it that its first intervals look back to, so that nothing is left over between two of them.

use std::path::{Path, PathBuf};

use passivity_scene::Scene;
use passivity_scene::display::hexadecimal;
use passivity_scene::parse::bytes_of;
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use crate::ledger::Ledger;
use crate::log::dates;
use crate::log::error::TraceError;
use crate::log::found::Findings;
use crate::log::header::Heading;
use crate::log::layout::Layout;
use crate::log::outcome::Audit;
use crate::log::piece::{self, Piece, Place, Said, Stretch};
use crate::log::preview::Preview;
use crate::log::saved::wrong;
use crate::log::saved_findings::SavedFindings;
use crate::log::source::Dialect;
use crate::log::step::undefined;
use crate::log::task::Task;
use crate::log::{Options, Reading, account};

const FORMAT: &str = "passivity-audit-partial-4";

/// The account of a stretch of a log, exactly.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Partial {
    format: String,
    /// Of this program.
    version: String,
    /// A hash of the scene.
    scene: String,
    place: Place,
    dialect: SavedDialect,
    headings: Vec<(String, Option<String>)>,
    /// The first rows, by which the header was judged: doubles as hexadecimal digits.
    preview: Vec<Vec<Option<String>>>,
    law: bool,
    found: SavedFindings,
    /// The account of the wall's own law, where the account is of the forces in the trace.
    by_law: Option<SavedFindings>,
}

/// A [`Dialect`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedDialect {
    columns: Option<String>,
    delimiter: Option<u8>,
    decimal_comma: bool,
}

/// What wrote a file.
#[derive(Deserialize)]
struct WrittenBy {
    format: String,
    version: String,
}

impl Partial {
    /// The largest file, in bytes: a hundred times what the account of a log with a thousand columns needs.
    const MAX_BYTES: u64 = 64 << 20;

    /// Reads a file with what [`to_json`](Self::to_json) writes.
    ///
    /// # Errors
    ///
    /// A file that cannot be read or is larger than 64 MiB, and as [`from_json`](Self::from_json).
    pub fn read(path: &Path) -> Result<Self, TraceError> {
        let bytes = bytes_of(path, Self::MAX_BYTES).map_err(|why| TraceError::new("io", why))?;
        let text = std::str::from_utf8(&bytes).map_err(|error| wrong(&error.to_string()))?;
        Self::from_json(text)
    }

    /// Reads what [`to_json`](Self::to_json) writes.
    ///
    /// # Errors
    ///
    /// Text that is something else, or was written by another version.
    pub fn from_json(text: &str) -> Result<Self, TraceError> {
        let wrong_at = |error: serde_json::Error| wrong(&error.to_string());
        // Asked first: another version may have other fields.
        let by: WrittenBy = serde_json::from_str(text).map_err(wrong_at)?;
        match by.format == FORMAT && by.version == env!("CARGO_PKG_VERSION") {
            true => serde_json::from_str(text).map_err(wrong_at),
            false => Err(wrong(&format!(
                "it was written by another version of this program, {}",
                crate::log::error::shown(by.version.as_bytes())
            ))),
        }
    }

    /// One JSON document.
    ///
    /// # Errors
    ///
    /// None that is known: JSON has a form for all that it holds.
    pub fn to_json(&self) -> Result<String, TraceError> {
        serde_json::to_string(self).map_err(|error| wrong(&error.to_string()))
    }

    /// How many intervals it accounts for.
    #[must_use]
    pub const fn intervals(&self) -> u64 {
        self.found.intervals()
    }

    /// How many samples of its own it has: the first piece one more than intervals.
    #[must_use]
    pub const fn samples(&self) -> u64 {
        self.found.samples
    }

    /// The layout that the log has, as it was read.
    fn layout(&self, dialect: &Dialect, scene: &Scene) -> Result<Layout, TraceError> {
        let headings = self.headings.iter().map(|(name, unit)| {
            let unit = match unit.as_deref() {
                None => None,
                Some("ms") => Some("ms"),
                Some("us") => Some("us"),
                Some("ns") => Some("ns"),
                Some(dates::UNIT) => Some(dates::UNIT),
                Some(_) => return Err(wrong("a unit that no type has")),
            };
            Ok(Heading {
                name: name.clone(),
                unit,
            })
        });
        let field = |bits: &String| match u64::from_str_radix(bits, 16) {
            Ok(bits) => Ok(f64::from_bits(bits)),
            Err(_) => Err(wrong("a row that is none")),
        };
        let row = |row: &Vec<Option<String>>| -> Result<Vec<Option<f64>>, TraceError> {
            row.iter()
                .map(|x| x.as_ref().map(field).transpose())
                .collect()
        };
        let rows: Vec<_> = self.preview.iter().map(row).collect::<Result<_, _>>()?;
        let said = Said {
            headings: headings.collect::<Result<_, _>>()?,
            preview: Preview::of_rows(&rows),
        };
        said.layout(dialect, scene)
    }

    /// In words, why another is no part of the same audit; `None` when it is.
    fn differs(&self, other: &Self) -> Option<&'static str> {
        if self.place.log != other.place.log || self.place.unit != other.place.unit {
            return Some("is of another log");
        }
        let same = self.dialect == other.dialect
            && self.law == other.law
            && self.headings == other.headings;
        (!same).then_some("was read with other columns or options")
    }
}

impl SavedDialect {
    fn of(dialect: &Dialect) -> Self {
        Self {
            columns: dialect.columns.as_ref().map(ToString::to_string),
            delimiter: dialect.delimiter,
            decimal_comma: dialect.decimal_comma,
        }
    }

    fn value(&self) -> Result<Dialect, TraceError> {
        Ok(Dialect {
            columns: self.columns.as_deref().map(str::parse).transpose()?,
            delimiter: self.delimiter,
            decimal_comma: self.decimal_comma,
        })
    }
}

/// What tells one scene from another.
fn fingerprint(scene: &Scene) -> String {
    hexadecimal(&Sha256::digest(format!("{scene:?}")))
}

/// The account of a stretch of a log in a file; CSV that is not compressed, or Parquet.
///
/// # Errors
///
/// As [`audit`](crate::audit()).
///
/// # Example
///
/// ```
/// use passivity_audit::{Options, Stretch, audit, audit_part, merge_parts};
/// use passivity_scene::Scene;
///
/// let scene = Scene::from_toml("s", "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"").unwrap();
/// let path = std::env::temp_dir().join(format!("passivity-{}.csv", std::process::id()));
/// std::fs::write(&path, "count\n0\n2\n3\n1\n-1\n0\n").unwrap();
/// let part = |stretch: &str| {
///     let stretch: Stretch = stretch.parse().unwrap();
///     let part = audit_part(&path, &scene, stretch, Options::default()).unwrap();
///     (stretch_name(stretch), part)
/// };
/// # fn stretch_name(stretch: Stretch) -> String { format!("{stretch:?}") }
/// let whole = audit(&path, &scene, Options::default()).unwrap();
/// let merged = merge_parts(&[part("2:"), part("0:2")], &scene).unwrap();
/// assert_eq!(merged.to_json(), whole.to_json());
/// # std::fs::remove_file(&path).unwrap();
/// ```
pub fn audit_part(
    path: &Path,
    scene: &Scene,
    stretch: Stretch,
    options: Options<'_>,
) -> Result<Partial, TraceError> {
    let path: PathBuf = piece::is_file(path)?;
    let (dialect, law) = (options.dialect.clone(), options.law);
    let block = piece::block(options.block);
    let mut piece = Piece::open(&path, scene, &dialect, stretch, block)?;
    let ledger = Ledger::of_scene(scene);
    let task = Task::new(scene, &ledger, &piece.layout, law);
    let by_law = task.by_law();
    let reading = Reading {
        lead: piece.lead,
        ends: piece.place.ends,
    };
    let (found, by_law) = account(&mut piece.source, &task, by_law.as_ref(), options, reading)?;
    let said = piece.heading;
    let bits = |x: &Option<f64>| x.map(|x| format!("{:016x}", x.to_bits()));
    Ok(Partial {
        format: FORMAT.to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: fingerprint(scene),
        place: piece.place,
        dialect: SavedDialect::of(&dialect),
        headings: said
            .headings
            .into_iter()
            .map(|heading| (heading.name, heading.unit.map(str::to_owned)))
            .collect(),
        preview: said
            .preview
            .rows()
            .iter()
            .map(|row| row.iter().map(bits).collect())
            .collect(),
        law,
        found: SavedFindings::of(&found),
        by_law: by_law.as_ref().map(SavedFindings::of),
    })
}

/// The report on a whole log from the accounts of its stretches, each under its name, in whatever order: the
/// same as that of [`audit`](crate::audit()).
///
/// # Errors
///
/// A stretch that is missing, there twice, or of another log, scene or reading of the columns.
pub fn merge_parts(parts: &[(String, Partial)], scene: &Scene) -> Result<Audit, TraceError> {
    let parts = in_order(parts, scene)?;
    let Some((name, first)) = parts.first() else {
        return Err(TraceError::new(
            "partial",
            "there is no partial account to merge",
        ));
    };
    let dialect = first.dialect.value().map_err(|error| error.of(name))?;
    let layout = first.layout(&dialect, scene);
    let layout = layout.map_err(|error| error.of(name))?;
    let ledger = Ledger::of_scene(scene);
    let task = Task {
        told: dialect.columns.is_some(),
        ..Task::new(scene, &ledger, &layout, first.law)
    };
    let found = joined(&parts, &ledger, |part| Some(&part.found))?;
    let beside = joined(&parts, &ledger, |part| part.by_law.as_ref())?;
    match found {
        Some(found) => found.audit(&task, scene, beside),
        None => Err(wrong("it holds no account")),
    }
}

/// One account of all stretches, up to the first mistake in the log.
fn joined(
    parts: &[&(String, Partial)],
    ledger: &Ledger,
    account: impl Fn(&Partial) -> Option<&SavedFindings>,
) -> Result<Option<Findings>, TraceError> {
    let mut all: Option<Findings> = None;
    for (name, part) in parts {
        let Some(saved) = account(part) else {
            return Ok(None);
        };
        let found = saved.value(ledger).map_err(|error| error.of(name))?;
        if !found.is_defined(ledger) {
            return Err(undefined().of(name));
        }
        if let Some(error) = &found.error
            && error.row == Some(0)
        {
            let message =
                format!("`{name}` could not be read, but what comes before it could: {error}");
            return Err(TraceError::new("partial", message));
        }
        match &mut all {
            None => all = Some(found),
            Some(all) => all.append(found),
        }
        if all.as_ref().is_some_and(|all| all.error.is_some()) {
            break;
        }
    }
    Ok(all)
}

/// The stretches from the start of the log to its end.
fn in_order<'p>(
    parts: &'p [(String, Partial)],
    scene: &Scene,
) -> Result<Vec<&'p (String, Partial)>, TraceError> {
    let refuse = |message: String| Err(TraceError::new("partial", message));
    let own = fingerprint(scene);
    let mut sorted: Vec<&(String, Partial)> = parts.iter().collect();
    sorted.sort_by_key(|(_, part)| (part.place.from, part.place.to, part.place.ends));
    if let Some((_, first)) = parts.first() {
        for (name, part) in parts {
            if part.scene != own {
                return refuse(format!("`{name}` is an account in another scene"));
            }
            if let Some(why) = part.differs(first) {
                return refuse(format!("`{name}` {why}"));
            }
        }
    }
    let whole = |(_, part): &&&(String, Partial)| part.place.from == part.place.to;
    // A stretch without a sample of its own may stand anywhere.
    let mut at: Option<(&str, u64)> = None;
    for (name, part) in sorted.iter().filter(|part| !whole(part)) {
        let (before, expected) = at.unwrap_or(("", part.place.start));
        let unit = &part.place.unit;
        match part.place.from.cmp(&expected) {
            std::cmp::Ordering::Equal => {}
            std::cmp::Ordering::Greater => {
                return refuse(format!(
                    "the account of {unit} {expected} to {} of the log is missing, before `{name}`",
                    part.place.from
                ));
            }
            std::cmp::Ordering::Less => {
                return refuse(format!(
                    "`{name}` and `{before}` account for the same samples"
                ));
            }
        }
        at = Some((name.as_str(), part.place.to));
    }
    if sorted.iter().any(|(_, part)| part.place.ends) || sorted.is_empty() {
        return Ok(sorted);
    }
    let (name, to) = at.unwrap_or_default();
    refuse(format!(
        "the account of the end of the log is missing, from {to} on, after `{name}`"
    ))
}
