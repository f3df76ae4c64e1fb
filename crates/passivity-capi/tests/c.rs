//! A C program, compiled and linked both ways, calls the library.

use std::path::{Path, PathBuf};
use std::process::Command;

// Makes cargo build the library before this test.
use passivity as _;

/// Where cargo put the library: beside the test, or one folder up.
fn built(name: &str) -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let folders = test.ancestors().skip(1).take(2);
    let mut found = folders
        .map(|folder| folder.join(name))
        .filter(|path| path.exists());
    found
        .next()
        .unwrap_or_else(|| panic!("{name} was not built"))
}

fn compile_and_run(name: &str, link: &[&str], library: &Path) {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let program = std::env::temp_dir().join(format!("passivity-{}-{name}", std::process::id()));
    let status = Command::new("cc")
        .args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-I"])
        .arg(here.join("include"))
        .arg(here.join("tests/example.c"))
        .arg("-o")
        .arg(&program)
        .args(link)
        .status()
        .unwrap();
    assert!(status.success(), "the C program does not compile");
    let output = Command::new(&program)
        .env("LD_LIBRARY_PATH", library.parent().unwrap())
        .output()
        .unwrap();
    std::fs::remove_file(&program).unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert_eq!(output.stdout, b"ok\n");
}

#[test]
fn static_library() {
    let library = built("libpassivity.a");
    let path = library.to_str().unwrap();
    compile_and_run("static", &[path, "-lpthread", "-ldl", "-lm"], &library);
}

#[test]
fn shared_library() {
    let library = built("libpassivity.so");
    compile_and_run("shared", &[library.to_str().unwrap()], &library);
}
