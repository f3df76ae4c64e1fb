//! Embeds the claims, the recorded evidence and the kernel's sources, for a binary that runs where
//! the tree is not.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    let root = Path::new(&env::var("CARGO_MANIFEST_DIR").unwrap_or_default()).join("../..");
    let mut out = String::new();
    for (name, file) in [
        ("CLAIMS", "proofs/claims.toml"),
        ("EVIDENCE", "proofs/evidence.json"),
    ] {
        let path = root.join(file);
        println!("cargo::rerun-if-changed={}", path.display());
        // A build without recorded evidence has none to embed, and says so when it is asked.
        let text = if path.is_file() {
            format!("include_str!({path:?})")
        } else {
            "\"\"".to_owned()
        };
        let _ = writeln!(out, "pub(super) const {name}: &str = {text};");
    }
    let kernel = root.join("crates/passivity-core/src");
    println!("cargo::rerun-if-changed={}", kernel.display());
    let mut files: Vec<PathBuf> = fs::read_dir(&kernel)
        .map(|entries| entries.flatten().map(|entry| entry.path()).collect())
        .unwrap_or_default();
    files.sort();
    out.push_str("pub(super) const SOURCES: &[(&str, &[u8])] = &[\n");
    for path in files.iter().filter(|path| path.is_file()) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let name = format!("crates/passivity-core/src/{name}");
        let _ = writeln!(out, "    ({name:?}, include_bytes!({path:?})),");
    }
    out.push_str("];\n");
    let target = Path::new(&env::var("OUT_DIR").unwrap_or_default()).join("embedded.rs");
    if let Err(error) = fs::write(&target, out) {
        // Cargo shows it and stops.
        println!("cargo::error={}: {error}", target.display());
    }
}
