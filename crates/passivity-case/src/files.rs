//! Reading files up to a bound on their size.

use std::path::Path;

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
    use std::io::Read as _;
    let file = std::fs::File::open(path).map_err(|error| CaseError::io(path, &error))?;
    let mut bytes = Vec::new();
    let read = file.take(most + 1).read_to_end(&mut bytes);
    let read = read.map_err(|error| CaseError::io(path, &error))?;
    if u64::try_from(read).is_ok_and(|read| read <= most) {
        Ok(bytes)
    } else {
        let what = format!("expected at most {most} bytes");
        Err(CaseError::within(path, what))
    }
}
