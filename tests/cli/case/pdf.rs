//! `passivity case --pdf`.

use std::os::unix::fs::PermissionsExt as _;
use std::process::Command;

use std::fs;
use std::path::Path;

use super::{GOOD, one_error, read};
use crate::harness::{Dir, Run, shipped};

/// Runs the command with what it finds on the PATH and in `PASSIVITY_BROWSER`.
fn run(dir: &Dir, args: &[&str], path: &Path, browser: Option<&Path>) -> Run {
    let mut command = Command::new(env!("CARGO_BIN_EXE_passivity"));
    command
        .args(args)
        .current_dir(dir.path("."))
        .env("PATH", path);
    match browser {
        Some(browser) => command.env("PASSIVITY_BROWSER", browser),
        None => command.env_remove("PASSIVITY_BROWSER"),
    };
    command.output().expect("the command starts").into()
}

/// A script in the place of a browser.
fn script(dir: &Dir, name: &str, text: &str) -> std::path::PathBuf {
    fs::create_dir_all(dir.path("bin")).expect("a folder");
    dir.write(&format!("bin/{name}"), format!("#!/bin/sh\n{text}\n"));
    let path = dir.path(&format!("bin/{name}"));
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("a script");
    path
}

const PRINTS: &str = "for a in \"$@\"; do case $a in --print-to-pdf=*) out=${a#*=};; esac; done\n\
                      echo '%PDF-1.4 printed' >\"$out\"";

#[test]
fn a_browser_prints_the_document_and_the_manifest_has_its_hash() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    script(&dir, "chromium", PRINTS);
    let args = ["case", &scene, "--out", "case", "--pdf", "--format", "json"];
    let run = run(&dir, &args, &dir.path("bin"), None);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(run.json()["pdf"], "case.pdf");
    assert_eq!(read(&dir, "case/case.pdf"), "%PDF-1.4 printed\n");
    // It is made again by the command that the document has.
    assert!(read(&dir, "case/case.html").contains("--out case \\\n    --pdf\n"));
    assert_eq!(dir.run(&["case", "--check", "case"]).code, 0);
    dir.write("case/case.pdf", "%PDF-1.4 changed");
    let check = dir.run(&["case", "--check", "case"]);
    assert_eq!(check.code, 1);
    assert!(
        check.stdout.contains("`case.pdf` was changed"),
        "{}",
        check.stdout
    );
    // A print that somebody changed is theirs.
    let again = dir.run(&["case", &scene, "--out", "case"]);
    assert_eq!(again.code, 2);
    assert_eq!(read(&dir, "case/case.pdf"), "%PDF-1.4 changed");
    dir.write("case/case.pdf", "%PDF-1.4 printed\n");
    // A case that is written again without --pdf does not keep the old print.
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
    assert!(!dir.path("case/case.pdf").exists());
}

#[test]
fn without_a_browser_the_case_is_written_and_the_error_says_how_to_print_by_hand() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    let failing = script(&dir, "failing", "echo no display >&2; exit 7");
    let nowhere = dir.path("nowhere");
    for (browser, about) in [
        (None, "PASSIVITY_BROWSER"),
        (Some(failing.as_path()), "no display"),
        (Some(nowhere.as_path()), "nowhere"),
    ] {
        let args = ["case", &scene, "--out", "case", "--pdf"];
        let run = run(&dir, &args, &nowhere, browser);
        one_error(&run, about);
        assert!(
            run.stderr
                .contains("to print it by hand, open `case/case.html`")
        );
        assert!(run.stderr.contains("outside of the folder of the case"));
        assert!(dir.path("case/case.html").is_file());
        assert!(!dir.path("case/case.pdf").exists());
        assert_eq!(dir.run(&["case", "--check", "case"]).code, 0);
    }
}

/// The pages of a PDF as browsers write it, each an object of its own.
fn pages(pdf: &[u8]) -> usize {
    let text = String::from_utf8_lossy(pdf);
    let all = text.matches("/Type /Page").count();
    all - text.matches("/Type /Pages").count()
}

#[test]
#[ignore = "needs chromium: cargo test -p passivity-cli --test cli -- --ignored real_browser"]
fn a_real_browser_prints_every_case() {
    let dir = Dir::new();
    let path = std::env::var_os("PATH").expect("a PATH");
    for scene in shipped() {
        let scene = scene.to_str().expect("UTF-8");
        let args = ["case", scene, "--out", "case", "--pdf"];
        let run = run(&dir, &args, Path::new(&path), None);
        assert_ne!(run.code, 2, "{scene}: {}", run.stderr);
        let pdf = fs::read(dir.path("case/case.pdf")).expect("a PDF");
        let pages = pages(&pdf);
        assert!((10..=40).contains(&pages), "{scene}: {pages} pages");
    }
}
