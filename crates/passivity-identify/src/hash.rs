//! The hash by which a scene names the logs that it came from.

use std::fs::File;
use std::io;
use std::path::Path;

use passivity_scene::display::hexadecimal;
use sha2::{Digest as _, Sha256};

/// The SHA-256 of a file, in hexadecimal.
///
/// # Errors
///
/// What reading the file says.
pub fn sha256(path: &Path) -> io::Result<String> {
    let mut hasher = Sha256::new();
    io::copy(&mut File::open(path)?, &mut hasher)?;
    Ok(hexadecimal(&hasher.finalize()))
}
