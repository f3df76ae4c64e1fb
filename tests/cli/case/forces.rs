//! `passivity case` of a scene whose forces are in a file.

use std::fs;

use super::{one_error, read};
use crate::harness::Dir;

const SCENE: &str = "# Measured.\n[device]\ninertia = \"1e-3 kg m^2\"\nviscous = \"1 N m s/rad\"\ncoulomb = \"1 N m\"\n\
    [sampling]\nperiod = \"1 ms\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"10 N m/rad\"\n\
    [operator]\nforce = { file = \"forces.csv\", column = \"f\" }\n[start]\nvelocity = \"1 rad/s\"\n";

/// The file is a part of the case: it is copied, hashed and compared, and the copy of the scene is read with it.
#[test]
fn a_file_of_forces_is_a_part_of_the_case() {
    let dir = Dir::new();
    let forces = "f [mN m]\n-2500\n";
    dir.write("forces.csv", forces);
    let path = dir.write("scene.toml", SCENE);
    let run = dir.run(&["case", &path, "--out", "case"]);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    assert_eq!(read(&dir, "case/forces.csv"), forces);
    let sum = passivity_evidence::Sha256::of(forces.as_bytes()).to_string();
    assert!(read(&dir, "case/manifest.json").contains(&sum));
    assert!(read(&dir, "case/case.html").contains("SHA-256 of the forces forces.csv"));
    let check = || dir.run(&["case", "--check", "case"]);
    assert_eq!(check().code, 0, "{}", check().stdout);
    for (name, says) in [
        ("case/forces.csv", "`forces.csv` was changed after"),
        ("forces.csv", "its forces, `forces.csv`, have changed"),
    ] {
        dir.write(name, "f [mN m]\n-1\n");
        let run = check();
        assert_eq!(run.code, 1, "{name}: {}", run.stdout);
        assert!(run.stdout.contains(says), "{name}: {}", run.stdout);
        dir.write(name, forces);
    }
    // Elsewhere the case has all that it rests on.
    fs::remove_file(dir.path("scene.toml")).expect("the scene");
    fs::remove_file(dir.path("forces.csv")).expect("the forces");
    assert_eq!(check().code, 0, "{}", check().stdout);
    // It is replaced as a whole, and nothing of it is foreign.
    let path = dir.write("scene.toml", SCENE);
    dir.write("forces.csv", "f [mN m]\n-2400\n");
    assert_eq!(dir.run(&["case", &path, "--out", "case"]).code, 0);
}

#[test]
fn forces_that_a_copy_would_not_find_are_refused() {
    let dir = Dir::new();
    fs::create_dir(dir.path("sub")).expect("a folder");
    for (name, says) in [
        ("sub/forces.csv", "is not in the folder of the scene"),
        ("case.html", "the case has another file `case.html`"),
        ("manifest.json", "the case has another file `manifest.json`"),
    ] {
        dir.write(name, "f [mN m]\n-2500\n");
        let path = dir.write("scene.toml", SCENE.replace("forces.csv", name));
        let run = dir.run(&["case", &path, "--out", "case"]);
        one_error(&run, says);
        assert!(!dir.path("case").exists(), "{name}");
    }
}
