//! Writes the generated files into the folder given, or the folder of the proofs.

use std::path::PathBuf;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = env::args_os().nth(1).map_or_else(
        || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(".."),
        PathBuf::from,
    );
    for (name, text) in passivity_rocq_bridge::files() {
        fs::write(folder.join(name), text)?;
    }
    Ok(())
}
