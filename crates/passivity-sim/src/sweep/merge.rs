//! The shards of a sweep as one file: the same bytes as those of the whole in one run.

use std::cmp::Ordering;
use std::path::{Path, PathBuf};
use std::sync::mpsc;

use passivity_scene::Point;

use crate::error::SimError;
use crate::sweep::disk::{failed, plain};
use crate::sweep::file::spare_others;
use crate::sweep::form::{Form, Writer};
use crate::sweep::grid::Grid;
use crate::sweep::manifest::Manifest;
use crate::sweep::row::Row;
use crate::sweep::shard::Shard;

/// Writes all shards of a sweep, in whatever order they are given, as one file; `see` is given each row
/// in the order of the grid. A few thousand rows are in memory at a time; of Parquet a group of rows.
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
    spare_others(path, form)?;
    let parts = in_order(parts, path, scene, grid)?;
    let mut file = Writer::new(path, form, grid, None)?;
    std::thread::scope(|scope| {
        // Rows are read while those before them are written.
        let (send, receive) = mpsc::sync_channel(2);
        scope.spawn(move || {
            let read = parts.iter().try_for_each(|(part, form, manifest)| {
                pass_on(part, *form, manifest.place()?, grid, &send)
            });
            if let Err(error) = read {
                // Where nobody waits for it, what was read could not be written.
                let _ = send.send(Err(error));
            }
        });
        for rows in receive {
            for (index, row) in rows? {
                see(index, &row);
                file.add(index, &row)?;
            }
        }
        file.finish()
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

/// Rows that are passed on at once.
const CHUNK: usize = 1 << 12;

type Rows = Result<Vec<(usize, Row)>, SimError>;

/// Passes the rows of a shard on, which are those of its points in the order of the grid.
fn pass_on(
    part: &Path,
    form: Form,
    shard: Shard,
    grid: &Grid,
    send: &mpsc::SyncSender<Rows>,
) -> Result<(), SimError> {
    let all = shard.range(grid.len());
    let (mut range, mut chunk) = (all.clone(), Vec::new());
    let pass = |chunk: &mut Vec<_>| {
        let sent = send.send(Ok(std::mem::take(chunk)));
        sent.map_err(|_| failed(part, &"is not needed any more"))
    };
    form.read(part, grid, &mut |number, (values, row)| {
        let is_here =
            |index: &usize| grid.doubles(*index).map(f64::to_bits) == values.map(f64::to_bits);
        let index = range.next().filter(is_here);
        let index =
            index.ok_or_else(|| form.at(part, number, "this is not the point of this place"))?;
        chunk.push((index, row));
        match chunk.len() {
            CHUNK => pass(&mut chunk),
            _ => Ok(()),
        }
    })?;
    if range.is_empty() {
        return pass(&mut chunk);
    }
    let message = format!(
        "has {} rows, expected {}",
        all.len() - range.len(),
        all.len()
    );
    Err(failed(part, &message))
}
