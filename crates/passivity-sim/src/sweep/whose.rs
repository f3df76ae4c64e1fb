//! Which sweep the rows of a file are of, and which shard of it.

use std::path::Path;

use passivity_scene::Point;
use passivity_scene::display::hexadecimal;

use crate::error::SimError;
use crate::sweep::disk::failed;
use crate::sweep::form::Form;
use crate::sweep::grid::Grid;
use crate::sweep::manifest::Manifest;
use crate::sweep::shard::Shard;

/// What tells one sweep from another: a hash of the scene, the grid and the shard, exactly.
pub(super) fn fingerprint(scene: &Point, grid: &Grid, shard: Option<Shard>) -> String {
    let sweep = of_sweep(scene, grid);
    match shard {
        None => format!("{sweep}\n"),
        Some(shard) => format!("{sweep} {shard}\n"),
    }
}

fn of_sweep(scene: &Point, grid: &Grid) -> String {
    let scene = grid.without(scene);
    format!(
        "passivity sweep 2 {}",
        hash(&format!("{scene:?}\n{grid:?}\n"))
    )
}

/// SHA-256 as hexadecimal digits.
pub(super) fn hash(text: &str) -> String {
    use sha2::Digest as _;
    hexadecimal(&sha2::Sha256::digest(text))
}

/// Whether the fingerprint beside a sweep that was left unfinished is that of the one asked for.
pub(super) fn is_taken_up(
    path: &Path,
    saved: &str,
    scene: &Point,
    grid: &Grid,
    shard: Option<Shard>,
) -> Result<(), SimError> {
    let asked = shard.unwrap_or(Shard::WHOLE);
    let of_this = saved.strip_prefix(&of_sweep(scene, grid));
    let found = of_this.and_then(|rest| match rest.trim() {
        "" => Some(Shard::WHOLE),
        shard => Shard::parse(shard).ok(),
    });
    match found {
        Some(found) if found == asked => Ok(()),
        Some(found) => Err(failed(path, &found.instead_of(asked))),
        None => Err(SimError::File(format!(
            "`{}` is of a sweep of another scene, other ranges or another number of intervals: give the same ones, or \
             another --out",
            path.display()
        ))),
    }
}

/// The error of a finished file that says itself that it is another shard than the one asked for, or of another sweep.
pub(super) fn of_another(path: &Path, form: Form, asked: &Manifest) -> Option<SimError> {
    let found = Manifest::read(path, form).ok()?;
    let why = match found.is_of_sweep(asked) {
        Err(why) => format!("{why}: give another --out"),
        Ok(()) => {
            let (found, asked) = (found.place().ok()?, asked.place().ok()?);
            (found != asked).then(|| found.instead_of(asked))?
        }
    };
    Some(failed(path, &why))
}

/// The error of rows that nothing says the sweep of.
pub(super) fn unbound(path: &Path, why: &str) -> SimError {
    let message = format!(
        "{why}, and no file `.run` beside it says of which sweep it is: leave out --resume to start anew"
    );
    failed(path, &message)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::range::Range;
    use passivity_scene::Scene;

    #[test]
    fn an_unfinished_sweep_says_which_shard_it_is() {
        let scene = Scene::from_toml("s", "[dimensionless]\nbeta = 1\nsigma = 1\n").unwrap();
        let scene = scene.point();
        let grid = |speeds| Grid::new(range("0:1:3"), range("1"), range(speeds)).unwrap();
        fn range(text: &str) -> Range {
            Range::parse(text).unwrap()
        }
        let shard = |text| Some(Shard::parse(text).unwrap());
        let taken_up = |saved, speeds, asked| {
            let saved = fingerprint(&scene, &grid("5"), saved);
            let taken = is_taken_up(Path::new("a.csv"), &saved, &scene, &grid(speeds), asked);
            taken.err().map(|error| error.to_string())
        };
        for (saved, asked, says) in [
            (None, None, None),
            (shard("1/1"), None, None),
            (shard("2/3"), shard("2/3"), None),
            (
                shard("2/3"),
                shard("2/2"),
                Some("is shard 2 of 3, not of 2: give --shard 2/3"),
            ),
            (
                shard("1-2/3"),
                None,
                Some("is shards 1 to 2 of 3, not the whole sweep"),
            ),
            (
                None,
                shard("1/3"),
                Some("is the whole sweep, not shard 1 of 3: leave out --shard"),
            ),
        ] {
            match (taken_up(saved, "5", asked), says) {
                (None, None) => {}
                (Some(error), Some(says)) => assert!(error.contains(says), "{error}"),
                (error, says) => panic!("{error:?}, not {says:?}"),
            }
        }
        let error = taken_up(shard("2/3"), "4", shard("2/3")).unwrap();
        assert!(error.contains("another scene, other ranges"), "{error}");
    }
}
