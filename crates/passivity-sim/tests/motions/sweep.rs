//! Sweeps: the same points as one by one, and files that survive being killed.

mod shards;

use std::fs;
use std::path::{Path, PathBuf};

use crate::common::paper;
use passivity_scene::Point;
use passivity_sim::sweep::{Grid, Range, Row, Shard, open, open_shard, run, run_range};
use passivity_sim::{Method, SimError, simulate};

fn grid(beta: &str, sigma: &str, speed: &str) -> Grid {
    let range = |text| Range::parse(text).unwrap();
    Grid::new(range(beta), range(sigma), range(speed)).unwrap()
}

/// A folder for one test.
fn folder(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("passivity-sweep-{name}-{}", std::process::id()));
    fs::create_dir_all(&path).unwrap();
    path
}

/// Sweeps into a file, killed after `rows` rows if that is given.
fn sweep(
    path: &Path,
    scene: &Point,
    grid: &Grid,
    resume: bool,
    rows: Option<usize>,
) -> Result<usize, SimError> {
    let mut all: Vec<Option<Row>> = vec![None; grid.len()];
    let opened = open(path, scene, grid, resume, |index, row| {
        assert!(all[index].replace(*row).is_none());
    })?;
    let mut file = opened.rows;
    let mut now = 0;
    let result = run(scene, grid, &opened.done, |index, row| {
        if rows.is_some_and(|rows| now >= rows) {
            return Err(SimError::File("killed".to_owned()));
        }
        assert!(all[index].is_none(), "point {index} was done before");
        all[index] = Some(row);
        now += 1;
        file.add(grid, index, &row)
    });
    match result {
        Ok(()) => {
            file.finish(grid)?;
            Ok(now)
        }
        Err(error) => Err(error),
    }
}

/// The rows that a file has, when it is taken up.
fn found(path: &Path, scene: &Point, grid: &Grid) -> Result<Vec<(usize, Row)>, SimError> {
    let mut rows = Vec::new();
    open(path, scene, grid, true, |index, row| {
        rows.push((index, *row))
    })?;
    Ok(rows)
}

#[test]
fn a_sweep_has_the_outcome_of_every_point() {
    let grid = grid("0:1:6", "0:1.5:6", "1/2,2");
    let mut delayed = paper("1", "1", "1", 2_000);
    delayed.at.delay = 1;
    for scene in [paper("1", "1", "1", 2_000), delayed] {
        let mut rows: Vec<Option<Row>> = vec![None; grid.len()];
        run(&scene, &grid, &[], |index, row| {
            assert!(rows[index].replace(row).is_none());
            Ok(())
        })
        .unwrap();
        for (index, row) in rows.iter().enumerate() {
            let end = simulate(&grid.point(&scene, index), &Method::ClosedForm, None)
                .unwrap()
                .end;
            let row = row.unwrap();
            assert_eq!(
                (row.xi, row.velocity),
                (end.xi, end.velocity),
                "point {index}"
            );
            assert_eq!(
                (row.exact, row.paper),
                (end.outcome.exact, end.outcome.paper)
            );
            assert_eq!(row.at_interval, end.outcome.at_interval);
        }
    }
}

#[test]
fn a_killed_sweep_is_taken_up_without_redoing_or_losing_a_point() {
    let folder = folder("resume");
    let (whole, part) = (folder.join("whole.csv"), folder.join("part.csv"));
    let (scene, grid) = (paper("1", "1", "1", 500), grid("0:1:10", "0:1:10", "1,2"));
    sweep(&whole, &scene, &grid, false, None).unwrap();
    sweep(&part, &scene, &grid, false, Some(70)).unwrap_err();
    // A torn last line, as a killed process leaves it.
    let mut text = fs::read_to_string(&part).unwrap();
    text.push_str("0.1111111");
    fs::write(&part, text).unwrap();
    let error = sweep(&part, &scene, &grid, false, None)
        .unwrap_err()
        .to_string();
    assert!(error.contains("--resume"), "{error}");
    let now = sweep(&part, &scene, &grid, true, None).unwrap();
    assert_eq!(now, grid.len() - 70);
    assert_eq!(fs::read(&whole).unwrap(), fs::read(&part).unwrap());
    // Nothing is left to do, and nothing changes.
    assert_eq!(sweep(&part, &scene, &grid, true, None).unwrap(), 0);
    assert_eq!(fs::read(&whole).unwrap(), fs::read(&part).unwrap());
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_parquet_file_has_the_rows_of_the_csv() {
    let folder = folder("parquet");
    let (csv, parquet) = (folder.join("sweep.csv"), folder.join("sweep.parquet"));
    let (scene, grid) = (paper("1", "1", "1", 300), grid("0:1:7", "0:1:7", "1,5"));
    sweep(&csv, &scene, &grid, false, None).unwrap();
    // Killed, taken up, and read back when there is nothing left to do.
    sweep(&parquet, &scene, &grid, false, Some(30)).unwrap_err();
    assert!(!parquet.exists());
    assert_eq!(sweep(&parquet, &scene, &grid, true, None).unwrap(), 98 - 30);
    let files = fs::read_dir(&folder).unwrap().count();
    assert_eq!(files, 2, "nothing is left beside the two files");
    let bits = |row: &Row| [row.xi.to_bits(), row.velocity.to_bits()];
    let mut rows = found(&parquet, &scene, &grid).unwrap();
    let expected = found(&csv, &scene, &grid).unwrap();
    rows.sort_by_key(|(index, _)| *index);
    assert_eq!(rows, expected);
    assert!(
        rows.iter()
            .zip(&expected)
            .all(|(a, b)| bits(&a.1) == bits(&b.1))
    );
    for row in [0, 1] {
        let kinds = rows
            .iter()
            .filter(|(_, r)| usize::from(r.at_interval.is_some()) == row);
        assert!(kinds.count() > 0, "rows with and without an interval");
    }
    // A torn file, and one that is something else.
    let whole = fs::read(&parquet).unwrap();
    for bytes in [&whole[..whole.len() - 9], b"PAR1, it says", b""] {
        fs::write(&parquet, bytes).unwrap();
        let error = found(&parquet, &scene, &grid).unwrap_err().to_string();
        assert!(error.contains("sweep.parquet"), "{error}");
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_finished_sweep_of_another_scene_is_refused() {
    let folder = folder("finished");
    for name in ["sweep.csv", "sweep.parquet"] {
        let path = folder.join(name);
        let (scene, grid) = (paper("1", "1", "1", 300), grid("1/2:1:4", "0:1:4", "1"));
        sweep(&path, &scene, &grid, false, None).unwrap();
        let kept = fs::read(&path).unwrap();
        // More intervals only show in points that ran to the end.
        for other in [
            paper("1", "1", "1", 301),
            crate::common::point("49", "1", "1", ["0", "1"], 300),
        ] {
            let error = found(&path, &other, &grid).unwrap_err().to_string();
            assert!(error.contains("not those of this scene"), "{error}");
        }
        assert_eq!(fs::read(&path).unwrap(), kept);
    }
    let path = folder.join("part.csv");
    let rows = "beta,sigma,speed,paper,exact,at_interval,xi,velocity\n1.0,1.0,1.0,converged,at_rest,3,0.5,0.0\n";
    fs::write(&path, rows).unwrap();
    let error = found(&path, &paper("1", "1", "1", 9), &grid("1", "1", "1,2")).unwrap_err();
    assert!(error.to_string().contains("not every point"), "{error}");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_file_of_another_sweep_is_refused() {
    let folder = folder("other");
    let path = folder.join("sweep.csv");
    let (scene, small) = (paper("1", "1", "1", 500), grid("0:1:3", "0:1:3", "1"));
    sweep(&path, &scene, &small, false, Some(4)).unwrap_err();
    let kept = fs::read(&path).unwrap();
    let other = paper("1", "1", "1", 501);
    let error = sweep(&path, &other, &small, true, None)
        .unwrap_err()
        .to_string();
    assert!(error.contains("another scene, other ranges"), "{error}");
    let error = sweep(&path, &scene, &grid("0:1:3", "0:1:4", "1"), true, None).unwrap_err();
    assert!(
        error.to_string().contains("another scene, other ranges"),
        "{error}"
    );
    assert_eq!(fs::read(&path).unwrap(), kept, "what was finished stays");
    for (text, expected) in [
        ("nonsense\n1,2\n", "line 1: expected the header"),
        (
            "beta,sigma,speed,paper,exact,at_interval,xi,velocity\n1,2\n",
            "line 2: expected a row",
        ),
        (
            "beta,sigma,speed,paper,exact,at_interval,xi,velocity\n7.0,0.0,1.0,converged,at_rest,3,0.5,0.0\n",
            "line 2: a point that is not in these ranges",
        ),
    ] {
        fs::write(&path, text).unwrap();
        let error = sweep(&path, &scene, &small, true, None)
            .unwrap_err()
            .to_string();
        assert!(error.contains(expected), "{error}");
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_file_that_cannot_be_written_is_one_clear_error() {
    let (scene, grid) = (paper("1", "1", "1", 10), grid("0", "0", "1"));
    let nowhere = std::env::temp_dir()
        .join("passivity-no-such-folder")
        .join("sweep.csv");
    let error = sweep(&nowhere, &scene, &grid, false, None)
        .unwrap_err()
        .to_string();
    assert!(error.contains("sweep.csv"), "{error}");
}

#[test]
fn bad_ranges_say_what_was_expected() {
    for (text, expected) in [
        ("0:1", "start:stop:count"),
        ("0:1:0", "a count from 1"),
        ("0:1:1", "a count of 1 needs"),
        ("0:x:3", "`x`"),
        ("", "``"),
        ("0:1:100000001", "a count from 1"),
    ] {
        let error = Range::parse(text).unwrap_err().to_string();
        assert!(error.contains(expected), "{text}: {error}");
    }
    let range = |text| Range::parse(text).unwrap();
    let error = Grid::new(range("-1:1:3"), range("1"), range("1"))
        .unwrap_err()
        .to_string();
    assert_eq!(error, "β = -1: expected zero or a value above it");
    // Too many for one run, not for shards; and too many for any.
    let large = Grid::new(range("0:1:10000"), range("0:1:10000"), range("1,2")).unwrap();
    let error = large.points(Shard::WHOLE).unwrap_err().to_string();
    assert!(error.contains("cut the grid into more shards"), "{error}");
    assert_eq!(
        large.points(Shard::parse("2/2").unwrap()).unwrap(),
        100_000_000..200_000_000
    );
    let axis = || range("0:1:100000000");
    let error = Grid::new(axis(), axis(), range("1")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a grid of 100000000 × 100000000 × 1 points: expected at most 1000000000000"
    );
}

#[test]
fn a_long_axis_costs_nothing() {
    // A piece of 10¹² points, of axes whose values would be gigabytes.
    let range = |text| Range::parse(text).unwrap();
    let grid = Grid::new(range("0:1:100000000"), range("0:1:10000"), range("1")).unwrap();
    let folder = folder("long");
    let (scene, path) = (paper("1", "1", "1", 9), folder.join("sweep.csv"));
    let last = Shard::parse("100000000000/100000000000").unwrap();
    let points = grid.points(last).unwrap();
    assert_eq!(points, grid.len() - 10..grid.len());
    let opened = open_shard(&path, &scene, &grid, last, false, |_, _| {});
    let mut opened = opened.unwrap().rows;
    run_range(&scene, &grid, points, &[], 0, |index, row| {
        opened.add(&grid, index, &row)
    })
    .unwrap();
    opened.finish(&grid).unwrap();
    let opened = open_shard(&path, &scene, &grid, last, true, |_, _| {});
    assert_eq!(opened.unwrap().done, [true; 10]);
    assert_eq!(grid.doubles(grid.len() - 1), [1.0, 1.0, 1.0]);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_file_is_written_by_one_sweep_at_a_time() {
    let folder = folder("two");
    let (scene, grid) = (paper("1", "1", "1", 300), grid("1/2:1:4", "0:1:4", "1"));
    for name in ["sweep.csv", "sweep.parquet"] {
        let path = folder.join(name);
        let mark = folder.join(format!("{name}.run"));
        // Of a start that was killed before it said whose the rows are.
        fs::write(&mark, "").unwrap();
        let mut rows = open(&path, &scene, &grid, false, |_, _| {}).unwrap().rows;
        let is_refused = || {
            for resume in [false, true] {
                let error = sweep(&path, &scene, &grid, resume, None).unwrap_err();
                let error = error.to_string();
                assert!(error.contains("another process is writing"), "{error}");
            }
        };
        is_refused();
        run(&scene, &grid, &[], |index, row| {
            if index == 7 {
                is_refused();
            }
            rows.add(&grid, index, &row)
        })
        .unwrap();
        is_refused();
        rows.finish(&grid).unwrap();
        assert!(!mark.exists());
        // Nothing is left of the lock, nor is it needed for what is finished.
        assert_eq!(found(&path, &scene, &grid).unwrap().len(), grid.len());
        fs::write(&mark, "").unwrap();
        assert_eq!(found(&path, &scene, &grid).unwrap().len(), grid.len());
        assert!(!mark.exists());
        // A killed process gives it back.
        sweep(&path, &scene, &grid, false, Some(5)).unwrap_err();
        assert_eq!(found(&path, &scene, &grid).unwrap().len(), 5);
        assert_eq!(sweep(&path, &scene, &grid, true, None).unwrap(), 11);
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn rows_are_taken_up_by_their_own_sweep_only_wherever_a_start_was_killed() {
    let folder = folder("foreign");
    let (scene, grid) = (paper("1", "1", "1", 300), grid("1/2:1:4", "0:1:4", "1"));
    let other = paper("1", "1", "1", 301);
    for name in ["sweep.csv", "sweep.parquet"] {
        let path = folder.join(name);
        let mark = folder.join(format!("{name}.run"));
        let journal = match name {
            "sweep.csv" => path.clone(),
            _ => folder.join("sweep.parquet.rows"),
        };
        // An unfinished sweep is bound to its scene and grid by a hash.
        sweep(&path, &scene, &grid, false, Some(9)).unwrap_err();
        let text = fs::read_to_string(&mark).unwrap();
        assert!(
            text.len() < 100 && text.starts_with("passivity sweep 2 "),
            "{text}"
        );
        let rows = fs::read(&journal).unwrap();
        let error = found(&path, &other, &grid).unwrap_err().to_string();
        assert!(error.contains("another scene, other ranges"), "{error}");
        // A mark that was put beside the rows of another scene does not make them its own.
        fs::remove_file(&journal).unwrap();
        fs::remove_file(&mark).unwrap();
        drop(open(&path, &other, &grid, false, |_, _| {}).unwrap());
        let foreign = fs::read(&mark).unwrap();
        fs::write(&journal, &rows).unwrap();
        let error = found(&path, &other, &grid).unwrap_err().to_string();
        assert!(error.contains("not those of this scene"), "{error}");
        assert_eq!(fs::read(&journal).unwrap(), rows);
        assert_eq!(fs::read(&mark).unwrap(), foreign);
        // A start that was killed before its mark was there leaves no rows that it could be given.
        fs::remove_file(&mark).unwrap();
        let error = found(&path, &other, &grid).unwrap_err().to_string();
        assert!(error.contains("no file `.run` beside it says"), "{error}");
        // Where the mark cannot be written, what was there stays.
        fs::remove_file(&journal).unwrap();
        if path.exists() {
            fs::remove_file(&path).unwrap();
        }
        sweep(&path, &scene, &grid, false, None).unwrap();
        let whole = fs::read(&path).unwrap();
        fs::create_dir(&mark).unwrap();
        let error = open(&path, &other, &grid, false, |_, _| {})
            .unwrap_err()
            .to_string();
        assert!(error.contains(".run"), "{error}");
        assert_eq!(fs::read(&path).unwrap(), whole);
        fs::remove_dir(&mark).unwrap();
    }
    fs::remove_dir_all(folder).unwrap();
}

#[cfg(unix)]
#[test]
fn taking_a_sweep_up_leaves_its_mark_as_it_is() {
    use std::os::unix::fs::{MetadataExt as _, symlink};
    let folder = folder("mark");
    let (scene, grid) = (paper("1", "1", "1", 300), grid("1/2:1:4", "0:1:4", "1"));
    let path = folder.join("sweep.csv");
    let mark = folder.join("sweep.csv.run");
    sweep(&path, &scene, &grid, false, Some(5)).unwrap_err();
    let before = fs::metadata(&mark).unwrap();
    // Killed again at once, any number of times: nothing is orphaned.
    for _ in 0..3 {
        assert_eq!(found(&path, &scene, &grid).unwrap().len(), 5);
        let after = fs::metadata(&mark).unwrap();
        assert_eq!(
            (before.ino(), before.mtime_nsec()),
            (after.ino(), after.mtime_nsec())
        );
    }
    assert_eq!(
        sweep(&path, &scene, &grid, true, None).unwrap(),
        grid.len() - 5
    );
    assert!(!mark.exists());
    // What is no plain file is not replaced, nor written through.
    let kept = folder.join("kept.txt");
    fs::write(&kept, "kept").unwrap();
    let link = folder.join("link.csv");
    symlink(&kept, &link).unwrap();
    let folder_and_device = [&*folder, Path::new("/dev/null")].map(|path| (path, "no plain file"));
    for (path, says) in folder_and_device
        .into_iter()
        .chain([(&*link, "a symbolic link")])
    {
        let error = open(path, &scene, &grid, false, |_, _| {})
            .unwrap_err()
            .to_string();
        assert!(error.contains(says), "{error}");
    }
    assert_eq!(fs::read(&kept).unwrap(), b"kept");
    fs::remove_dir_all(folder).unwrap();
}
