//! The shards of a sweep as one file: the same bytes as those of the whole in one run.

use std::cmp::Ordering;
use std::path::{Path, PathBuf};
use std::sync::mpsc;

use passivity_scene::Point;

use crate::error::SimError;
use crate::sweep::disk::{failed, plain};
use crate::sweep::file::{spare_unfinished, write_ordered};
use crate::sweep::form::Form;
use crate::sweep::grid::Grid;
use crate::sweep::manifest::Manifest;
use crate::sweep::row::Row;
use crate::sweep::shard::Shard;

/// Writes all shards of a sweep, in whatever order they are given, as one file; `see` is given each row
/// in the order of the grid. Three shards are in memory at the most.
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
    spare_unfinished(path, form)?;
    let parts = in_order(parts, path, scene, grid)?;
    std::thread::scope(|scope| {
        // One shard is read while the one before it is written.
        let (send, receive) = mpsc::sync_channel(0);
        scope.spawn(move || {
            for (part, form, manifest) in &parts {
                let place = manifest.place();
                let rows = place.and_then(|shard| shard_rows(part, *form, shard, grid));
                if send.send(rows).is_err() {
                    return; // What was read could not be written.
                }
            }
        });
        let rows = receive.into_iter().flat_map(|shard| match shard {
            Ok(rows) => rows.into_iter().map(Ok).collect(),
            Err(error) => vec![Err(error)],
        });
        let rows = rows.inspect(|row| {
            if let Ok((index, row)) = row {
                see(*index, row);
            }
        });
        write_ordered(path, form, grid, None, rows)
    })
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
        let own = Manifest::new(scene, grid, manifest.place()?);
        let mut same = manifest.is_with(&own);
        if let (Ok(()), Some((_, _, first))) = (&same, found.first()) {
            same = manifest.is_with(first);
        }
        same.map_err(|why| failed(part, &why))?;
        found.push((part, form, manifest));
    }
    found.sort_by_key(|(.., manifest)| manifest.shard);
    let of = found.first().map_or(0, |(.., manifest)| manifest.of);
    let mut missing: Vec<String> = Vec::new();
    let mut miss = |from: usize, to: usize| match to.cmp(&from) {
        Ordering::Less => {}
        Ordering::Equal => missing.push(from.to_string()),
        Ordering::Greater => missing.push(format!("{from}-{to}")),
    };
    let mut before: Option<&(&Path, Form, Manifest)> = None;
    for at in &found {
        let (part, _, manifest) = at;
        let last = before.map_or(0, |(.., before)| before.last);
        if let Some((twin, ..)) = before
            && manifest.shard <= last
        {
            let message = format!(
                "is shard {} of {}, and so is `{}`",
                manifest.shard,
                manifest.of,
                twin.display()
            );
            return Err(failed(part, &message));
        }
        miss(last + 1, manifest.shard - 1);
        before = Some(at);
    }
    miss(before.map_or(0, |(.., before)| before.last) + 1, of);
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
