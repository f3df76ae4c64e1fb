//! Why a case could not be written or checked.

use std::fmt;
use std::path::Path;

/// One message for people: where, and what is wrong there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CaseError {
    message: String,
}

impl CaseError {
    /// An error with its message.
    pub fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
        }
    }

    /// A file or folder that cannot be read or written.
    #[must_use]
    pub fn io(path: &Path, error: &std::io::Error) -> Self {
        Self::new(format!("`{}`: {error}", path.display()))
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for CaseError {}
