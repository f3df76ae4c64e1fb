//! A sweep in shards: merged, they are the bytes of one run.

use std::fs;
use std::path::{Path, PathBuf};

use passivity_scene::Point;
use passivity_sim::sweep::{Grid, Row, Shard, merge, open_shard, run_range, write_shard};

use super::{folder, grid, sweep};
use crate::common::paper;

/// Sweeps one shard into a file of its own.
fn sweep_shard(path: &Path, scene: &Point, grid: &Grid, shard: Shard) {
    let range = grid.points(shard).unwrap();
    let mut rows: Vec<Option<Row>> = vec![None; range.len()];
    let opened = open_shard(path, scene, grid, shard, true, |index, row| {
        rows[index - range.start] = Some(*row);
    })
    .unwrap();
    let mut file = opened.rows;
    let ran = run_range(scene, grid, range.clone(), &opened.done, 1, |index, row| {
        assert!(range.contains(&index));
        rows[index - range.start] = Some(row);
        file.add(grid, index, &row)
    });
    ran.unwrap();
    file.finish(grid).unwrap();
    // In one go, without a file of the rows on the way, it is the same.
    let [ours, at_once] = ["", "once."].map(|before| {
        let name = path.file_name().unwrap().to_str().unwrap();
        path.with_file_name(format!("{before}{name}"))
    });
    write_shard(&at_once, scene, grid, shard, &rows).unwrap();
    assert!(fs::read(ours).unwrap() == fs::read(&at_once).unwrap());
    fs::remove_file(at_once).unwrap();
}

#[test]
fn merged_shards_are_the_bytes_of_one_run() {
    let folder = folder("shards");
    let (scene, grid) = (paper("1", "1", "1", 300), grid("0:1:7", "0:1:7", "1,5"));
    for end in ["csv", "parquet"] {
        let whole = folder.join(format!("whole.{end}"));
        sweep(&whole, &scene, &grid, false, None).unwrap();
        for count in [1, 2, 5, 100] {
            // Parts may be of either kind, and come in any order.
            let part = |i: usize| {
                let kind = if i.is_multiple_of(3) {
                    "csv"
                } else {
                    "parquet"
                };
                folder.join(format!("{count}-{i}.{kind}"))
            };
            for i in 1..=count {
                sweep_shard(&part(i), &scene, &grid, Shard::new(i, count).unwrap());
            }
            let parts: Vec<PathBuf> = (1..=count).rev().map(part).collect();
            let merged = folder.join(format!("merged.{end}"));
            let mut seen = 0;
            merge(&parts, &merged, &scene, &grid, |index, _| {
                assert_eq!(index, seen);
                seen += 1;
            })
            .unwrap();
            assert_eq!(seen, grid.len());
            assert!(fs::read(&whole).unwrap() == fs::read(&merged).unwrap());
        }
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn shards_that_are_not_all_of_one_sweep_are_refused_by_name() {
    let folder = folder("foreign-shards");
    let (scene, grid) = (paper("1", "1", "1", 300), grid("0:1:4", "0:1:4", "1,5"));
    let other_scene = paper("1", "1", "1", 301);
    let other_grid = self::grid("0:1:4", "0:1:4", "1,6");
    let write = |name: &str, scene: &Point, grid: &Grid, shard: &str| {
        let path = folder.join(name);
        sweep_shard(&path, scene, grid, Shard::parse(shard).unwrap());
        path
    };
    let one = write("one.parquet", &scene, &grid, "1/3");
    let two = write("two.csv", &scene, &grid, "2/3");
    let three = write("three.parquet", &scene, &grid, "3/3");
    let out = folder.join("out.parquet");
    let refused = |parts: &[&PathBuf]| {
        let parts: Vec<PathBuf> = parts.iter().map(|part| (*part).clone()).collect();
        let error = merge(&parts, &out, &scene, &grid, |_, _| {}).unwrap_err();
        assert!(!out.exists());
        error.to_string()
    };
    let error = refused(&[&one, &three]);
    assert!(
        error.contains("of 3 shards these are missing: 2"),
        "{error}"
    );
    let twin = write("twin.csv", &scene, &grid, "2/3");
    let error = refused(&[&one, &two, &twin, &three]);
    assert!(
        error.contains("twin.csv") && error.contains("so is"),
        "{error}"
    );
    let foreign = write("scene.parquet", &other_scene, &grid, "2/3");
    let error = refused(&[&one, &foreign, &three]);
    assert!(
        error.contains("scene.parquet")
            && error.contains("with 301 intervals for each point, not 300"),
        "{error}"
    );
    let foreign = write("grid.csv", &scene, &other_grid, "2/3");
    let error = refused(&[&one, &foreign, &three]);
    assert!(
        error.contains("grid.csv") && error.contains("other ranges"),
        "{error}"
    );
    let fourth = write("fourth.csv", &scene, &grid, "2/4");
    let error = refused(&[&one, &fourth, &three]);
    assert!(
        error.contains("fourth.csv") && error.contains("4 shards, not in 3"),
        "{error}"
    );
    // A file that says nothing of itself, and one that lost rows.
    let whole = folder.join("whole.parquet");
    sweep(&whole, &scene, &grid, false, None).unwrap();
    let error = refused(&[&one, &whole]);
    assert!(
        error.contains("whole.parquet") && error.contains("no finished shard"),
        "{error}"
    );
    let text = fs::read_to_string(&two).unwrap();
    let (short, _) = text.trim_end().rsplit_once('\n').unwrap();
    fs::write(&two, format!("{short}\n")).unwrap();
    let error = refused(&[&one, &two, &three]);
    assert!(
        error.contains("two.csv") && error.contains("expected"),
        "{error}"
    );
    assert!(merge(&[], &out, &scene, &grid, |_, _| {}).is_err());
    fs::remove_dir_all(folder).unwrap();
}
