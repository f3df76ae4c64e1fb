//! A C program calls the library, with an operating system and without one.

mod bare;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

fn here() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The library as for a microcontroller, built once.
fn library() -> &'static Path {
    static BUILT: OnceLock<PathBuf> = OnceLock::new();
    BUILT.get_or_init(|| bare::library(here()))
}

fn compile_and_run(name: &str, arguments: &[&str]) {
    let program = std::env::temp_dir().join(format!("monitor-{}-{name}", std::process::id()));
    let status = Command::new("cc")
        .args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-I"])
        .arg(here().join("include"))
        .arg(here().join("tests/example.c"))
        .arg(library())
        .arg("-o")
        .arg(&program)
        .args(arguments)
        .status()
        .unwrap();
    assert!(status.success(), "the C program does not compile");
    let status = Command::new(&program).status().unwrap();
    std::fs::remove_file(&program).unwrap();
    assert_eq!(status.code(), Some(0), "which check failed");
}

#[test]
fn with_an_operating_system() {
    compile_and_run("hosted", &[]);
}

/// No C library either; what is not used is not linked.
#[test]
#[cfg(all(target_arch = "x86_64", target_os = "linux"))]
fn on_bare_metal() {
    compile_and_run(
        "bare",
        &["-DBARE", "-ffreestanding", "-nostdlib", "-static"],
    );
}

/// Of other code only the copying of memory is needed, which every C compiler asks for too: nothing that
/// panics, allocates or formats.
#[test]
fn nothing_else_is_linked() {
    let output = Command::new("nm").arg(library()).output().unwrap();
    let symbols = String::from_utf8(output.stdout).unwrap();
    let ours = symbols
        .split("\n\n")
        .find(|object| object.contains(" T passivity_monitor_sample"))
        .unwrap();
    let needed: Vec<&str> = ours
        .lines()
        .filter_map(|line| line.trim_start().strip_prefix("U "))
        .filter(|name| !["memcpy", "memset"].contains(name))
        .collect();
    assert!(needed.is_empty(), "{needed:?}");
}
