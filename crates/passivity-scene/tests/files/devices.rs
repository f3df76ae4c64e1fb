//! The shipped scenes of real devices: each parses, has a source beside every figure, and has the
//! region and the verdict of its row in the folder's table.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use passivity_core::Parameter;
use passivity_scene::Scene;
use passivity_scene::check::check;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/devices")
}

fn scene(name: &str) -> Scene {
    Scene::read(folder().join(format!("{name}.toml"))).unwrap_or_else(|e| panic!("{e}"))
}

/// The names of the scenes in the folder.
fn shipped() -> Vec<String> {
    let files = fs::read_dir(folder()).unwrap();
    let paths = files.map(|file| file.unwrap().path());
    let mut names: Vec<String> = paths
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// The rows of the folder's table by scene: device, what is published, what is blank, region, verdict.
fn rows() -> BTreeMap<String, Vec<String>> {
    let table = fs::read_to_string(folder().join("README.md")).unwrap();
    let cells = table.lines().filter_map(|line| {
        let (name, cells) = line.strip_prefix("| `")?.split_once(".toml` |")?;
        let cells = cells.trim_end_matches('|').split('|');
        let cells = cells.map(|cell| cell.trim().to_owned()).collect();
        Some((name.to_owned(), cells))
    });
    cells.collect()
}

#[test]
fn each_device_has_the_region_and_the_verdict_of_its_row() {
    let rows = rows();
    assert!(rows.len() >= 6);
    assert_eq!(rows.keys().cloned().collect::<Vec<_>>(), shipped());
    for (name, cells) in &rows {
        assert_eq!(cells.len(), 5, "{name}");
        assert!(cells.iter().all(|cell| !cell.is_empty()), "{name}");
        let report = check(&scene(name));
        let region = report.to_json()["region"]
            .as_str()
            .unwrap()
            .replace('_', " ");
        let verdict = report.verdict.name().replace('_', " ");
        assert_eq!([&region, &verdict], [&cells[3], &cells[4]], "{name}");
    }
}

/// Keys that say what kind of thing stands there, not how much of it.
const NO_FIGURES: [&str; 2] = ["unilateral", "side"];

#[test]
fn every_figure_has_a_source_beside_it() {
    for name in shipped() {
        let text = fs::read_to_string(folder().join(format!("{name}.toml"))).unwrap();
        assert!(text.contains("2026-11-22"), "{name}: the day of reading");
        // A comment is a source for the keys that follow it without a section or an empty line between.
        let mut sourced = false;
        for line in text.lines() {
            match line.split_once('=') {
                _ if line.starts_with('#') => sourced = true,
                Some((key, rest)) => {
                    let told = sourced || rest.contains('#') || NO_FIGURES.contains(&key.trim());
                    assert!(told, "{name}: no source for {line}");
                }
                None => sourced = false,
            }
        }
    }
}

#[test]
fn what_is_not_published_is_not_in_the_scene() {
    for name in [
        "hapkit-3",
        "haply-2diy",
        "novint-falcon",
        "smartknob",
        "smartknob-as5600",
    ] {
        let given = scene(name).given;
        for friction in [Parameter::Viscous, Parameter::Coulomb] {
            assert!(given.get(friction).is_none(), "{name}");
        }
        assert!(given.inertia.is_none(), "{name}");
    }
    for name in ["phantom-texture-250hz", "phantom-texture-40khz"] {
        assert!(scene(name).given.viscous.is_none(), "{name}");
    }
}

#[test]
fn the_paddles_friction_is_reflected_from_its_motor() {
    let given = scene("epfl-paddle").given;
    let coulomb = given.coulomb.unwrap().value;
    let ends = [coulomb.lo(), coulomb.hi()].map(|x| x.to_rational().unwrap().to_string());
    assert_eq!(ends, ["3/200", "9/500"]);
}
