//! Reading files up to a bound on their size.

use std::path::Path;

use passivity_scene::parse::bytes_of;

use crate::error::CaseError;

/// A file of a case is no larger than this.
pub(crate) const MOST_BYTES: u64 = 1 << 30;

/// The text of a file of at most `most` bytes.
pub(crate) fn read_text(path: &Path, most: u64) -> Result<String, CaseError> {
    let bytes = read_bytes(path, most)?;
    String::from_utf8(bytes).map_err(|error| CaseError::within(path, format!("not UTF-8: {error}")))
}

/// The bytes of a file of at most `most` bytes.
pub(crate) fn read_bytes(path: &Path, most: u64) -> Result<Vec<u8>, CaseError> {
    bytes_of(path, most).map_err(|why| CaseError::within(path, why))
}
