//! The library as for a microcontroller: nothing but Rust's `core`.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Builds the library of the crate in `capi` and gives its file.
pub(crate) fn library(capi: &Path) -> PathBuf {
    let folder = capi.join("../../target/monitor-bare");
    let status = Command::new(env!("CARGO"))
        .args(["rustc", "--quiet", "--offline", "--release", "--lib"])
        .args(["--no-default-features", "--crate-type", "staticlib"])
        .args([
            "--config",
            "profile.release.panic=\"abort\"",
            "--target-dir",
        ])
        .arg(&folder)
        .current_dir(capi)
        .status()
        .expect("cargo runs");
    assert!(status.success(), "the library does not compile without std");
    folder.join("release/libpassivity_monitor_c.a")
}
