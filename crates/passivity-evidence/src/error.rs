//! Why claims or evidence could not be used.

use std::fmt;
use std::path::Path;

/// One message for people: which file, and what is wrong in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EvidenceError {
    message: String,
}

impl EvidenceError {
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

    /// Something that is wrong in the file called `name`.
    pub fn within(name: &str, what: impl fmt::Display) -> Self {
        Self::new(format!("`{name}`: {what}"))
    }
}

impl fmt::Display for EvidenceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for EvidenceError {}
