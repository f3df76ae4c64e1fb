//! The shards of a sweep as one file: the same bytes as those of the whole in one run.

use std::path::{Path, PathBuf};

use passivity_scene::Point;

use crate::error::SimError;
use crate::sweep::disk::{failed, plain};
use crate::sweep::file::{Form, write_ordered};
use crate::sweep::grid::Grid;
use crate::sweep::manifest::Manifest;
use crate::sweep::row::Row;
use crate::sweep::shard::Shard;

/// Writes all shards of a sweep, in whatever order they are given, as one file; `see` is given each row
/// in the order of the grid. One shard is in memory at a time.
///
/// # Errors
///
/// A shard that is missing, there twice, or of another sweep; a file that cannot be read or written.
pub fn merge(
    parts: &[PathBuf],
    path: &Path,
    scene: &Point,
    grid: &Grid,
    mut see: impl FnMut(usize, &Row),
) -> Result<(), SimError> {
    plain(path)?;
    let form = Form::of(path)?;
    let parts = in_order(parts, path, scene, grid)?;
    let shards = parts.iter().map(|(part, form, manifest)| {
        let shard = Shard::new(manifest.shard, manifest.of)?;
        shard_rows(part, *form, shard, grid)
    });
    let rows = shards.flat_map(|shard| match shard {
        Ok(rows) => rows.into_iter().map(Ok).collect(),
        Err(error) => vec![Err(error)],
    });
    let rows = rows.inspect(|row| {
        if let Ok((index, row)) = row {
            see(*index, row);
        }
    });
    write_ordered(path, form, grid, None, rows)
}

/// The files in the order of their shards, once they are all there.
fn in_order<'p>(
    parts: &'p [PathBuf],
    out: &Path,
    scene: &Point,
    grid: &Grid,
) -> Result<Vec<(&'p Path, Form, Manifest)>, SimError> {
    let mut found: Vec<(&Path, Form, Manifest)> = Vec::new();
    for part in parts {
        if let (Ok(part), Ok(out)) = (part.canonicalize(), out.canonicalize())
            && part == out
        {
            return Err(failed(&part, &"is a shard, and is not written over"));
        }
        let form = Form::of(part)?;
        let manifest = Manifest::read(part, form)?;
        let own = Manifest::new(scene, grid, Shard::new(manifest.shard, manifest.of)?);
        let mut same = manifest.is_with(&own);
        if let (Ok(()), Some((_, _, first))) = (&same, found.first()) {
            same = manifest.is_with(first);
        }
        same.map_err(|why| failed(part, &why))?;
        if let Some((twin, ..)) = found.iter().find(|(.., m)| m.shard == manifest.shard) {
            return Err(failed(
                part,
                &format!(
                    "is shard {} of {}, and so is `{}`",
                    manifest.shard,
                    manifest.of,
                    twin.display()
                ),
            ));
        }
        found.push((part, form, manifest));
    }
    found.sort_by_key(|(.., manifest)| manifest.shard);
    let of = found.first().map_or(0, |(.., manifest)| manifest.of);
    let is_there = |index: &usize| found.iter().any(|(.., manifest)| manifest.shard == *index);
    let missing: Vec<String> = (1..=of)
        .filter(|index| !is_there(index))
        .map(|index| index.to_string())
        .collect();
    if missing.is_empty() && of > 0 {
        return Ok(found);
    }
    Err(SimError::File(match of {
        0 => "there is no shard to merge".to_owned(),
        _ => format!("of {of} shards these are missing: {}", missing.join(", ")),
    }))
}

/// The rows of a shard, which are those of its points in the order of the grid.
fn shard_rows(
    part: &Path,
    form: Form,
    shard: Shard,
    grid: &Grid,
) -> Result<Vec<(usize, Row)>, SimError> {
    let range = shard.range(grid.len());
    let rows = form.read(part, grid)?;
    if rows.len() != range.len() {
        let message = format!("has {} rows, expected {}", rows.len(), range.len());
        return Err(failed(part, &message));
    }
    let mut placed = Vec::with_capacity(rows.len());
    for (number, (index, (values, row))) in range.zip(rows).enumerate() {
        if grid.doubles(index).map(f64::to_bits) != values.map(f64::to_bits) {
            return Err(form.at(part, number, "this is not the point of this place"));
        }
        placed.push((index, row));
    }
    Ok(placed)
}
