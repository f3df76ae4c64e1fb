//! What a finished shard says that it is.

use std::fs;
use std::path::{Path, PathBuf};

use passivity_scene::{Point, files};
use serde::{Deserialize, Serialize};

use crate::error::SimError;
use crate::sweep::disk::{BESIDE, MANIFEST, failed, is_own, with_suffix};
use crate::sweep::form::Form;
use crate::sweep::grid::Grid;
#[cfg(feature = "parquet")]
use crate::sweep::parquet;
use crate::sweep::shard::Shard;
use crate::sweep::whose::hash;

const FORMAT: &str = "passivity-sweep-shard-1";

/// Which shard of which sweep a file is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Manifest {
    format: String,
    /// Of this program: other versions may simulate otherwise in the last bit.
    version: String,
    /// A hash of what the points have in common, with the number of intervals.
    scene: String,
    /// How many intervals each point has, to say what differs; 0 in files that do not say.
    #[serde(default)]
    intervals: u64,
    /// A hash of the axes and their values.
    grid: String,
    /// The first of the pieces that it is, from 1, the last, and of how many.
    pub(super) shard: usize,
    pub(super) last: usize,
    pub(super) of: usize,
    pub(super) points: usize,
}

impl Manifest {
    pub(super) fn new(scene: &Point, grid: &Grid, shard: Shard) -> Self {
        Self {
            format: FORMAT.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scene: hash(&format!("{:?}", grid.without(scene))),
            intervals: scene.intervals,
            grid: hash(&format!("{grid:?}")),
            shard: shard.first(),
            last: shard.last(),
            of: shard.count(),
            points: shard.range(grid.len()).len(),
        }
    }

    pub(super) fn to_json(&self) -> String {
        format!(
            "{{\"format\": \"{}\", \"version\": \"{}\", \"scene\": \"{}\", \"intervals\": {}, \
             \"grid\": \"{}\", \"shard\": {}, \"last\": {}, \"of\": {}, \"points\": {}}}\n",
            self.format,
            self.version,
            self.scene,
            self.intervals,
            self.grid,
            self.shard,
            self.last,
            self.of,
            self.points
        )
    }

    /// Says it beside a shard in CSV.
    pub(super) fn write(&self, path: &Path) -> Result<(), SimError> {
        let at = beside(path);
        files::write(&at, self.to_json()).map_err(|error| failed(&at, &error))
    }

    /// That of a file.
    pub(super) fn read(path: &Path, form: Form) -> Result<Self, SimError> {
        let (at, text) = match form {
            Form::Csv => {
                let at = beside(path);
                // A file that is missing is the first thing to say.
                fs::metadata(path).map_err(|error| failed(path, &error))?;
                let text = match fs::read_to_string(&at) {
                    Ok(text) => text,
                    Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                        let why = format!(
                            "is no finished shard, for `{}` is missing, which says of which sweep it is: \
                             expected both files together",
                            at.display()
                        );
                        return Err(failed(path, &why));
                    }
                    Err(error) => return Err(failed(&at, &error)),
                };
                (at, text)
            }
            #[cfg(feature = "parquet")]
            Form::Parquet => {
                let text = parquet::manifest(path).map_err(|error| failed(path, &error))?;
                let no_shard = "is no finished shard: nothing in it says of which sweep it is";
                (
                    path.to_owned(),
                    text.ok_or_else(|| failed(path, &no_shard))?,
                )
            }
        };
        serde_json::from_str(&text).map_err(|error| failed(&at, &format!("manifest: {error}")))
    }

    /// Its place in the grid.
    pub(super) fn place(&self) -> Result<Shard, SimError> {
        Shard::run(self.shard, self.last, self.of)
    }

    /// Whether another is of the same sweep; in words why not.
    pub(super) fn is_of_sweep(&self, other: &Self) -> Result<(), String> {
        let differs = |what: &str| Err(format!("is a shard of a sweep {what}"));
        if self.format != other.format || self.version != other.version {
            return differs(&format!(
                "by another version of this program, {}",
                self.version
            ));
        }
        match [self.intervals, other.intervals] {
            _ if self.scene == other.scene => {}
            [0, _] | [_, 0] => {
                return differs("of another scene or with another number of intervals");
            }
            [own, others] if own != others => {
                return differs(&format!(
                    "with {own} intervals for each point, not {others}"
                ));
            }
            _ => return differs("of another scene"),
        }
        if self.grid != other.grid {
            return differs("of other ranges");
        }
        Ok(())
    }

    /// Whether another is of the same sweep in as many shards; in words why not.
    pub(super) fn is_with(&self, other: &Self) -> Result<(), String> {
        self.is_of_sweep(other)?;
        match self.of == other.of {
            true => Ok(()),
            false => Err(format!(
                "is a shard of a sweep in {} shards, not in {}",
                self.of, other.of
            )),
        }
    }
}

/// Refuses to lose a file that says something else.
pub(super) fn spare(path: &Path) -> Result<(), SimError> {
    let says = |text: &[u8]| text.starts_with(b"{\"format\": \"passivity-sweep-shard-");
    is_own(&beside(path), BESIDE, says)
}

/// Removes what is said of a file that is replaced.
pub(super) fn forget(path: &Path) -> Result<(), SimError> {
    let said = beside(path);
    match said.exists() {
        true => fs::remove_file(&said).map_err(|error| failed(&said, &error)),
        false => Ok(()),
    }
}

/// The file that says what a shard in CSV is.
fn beside(path: &Path) -> PathBuf {
    with_suffix(path, MANIFEST)
}
