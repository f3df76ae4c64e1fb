//! Errors in writing or checking a case.

use std::fmt;
use std::path::Path;

use passivity_audit::{Proposal, TraceError};
use passivity_evidence::EvidenceError;

/// One message for people: where, and what is wrong there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CaseError {
    message: String,
    proposal: Option<Box<Proposal>>,
}

impl CaseError {
    /// An error with its message.
    pub fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            proposal: None,
        }
    }

    /// A log that cannot be read.
    pub(crate) fn of_log(path: &Path, error: TraceError) -> Self {
        let mut refused = Self::within(path, &error);
        refused.proposal = error.proposal;
        refused
    }

    /// What the header of a log may mean, where that is why it cannot be read.
    #[must_use]
    pub fn proposal(&self) -> Option<&Proposal> {
        self.proposal.as_deref()
    }

    /// A file or folder that cannot be read or written.
    #[must_use]
    pub fn io(path: &Path, error: &std::io::Error) -> Self {
        Self::within(path, error)
    }

    /// Something that is wrong in a file or folder.
    pub fn within(path: &Path, what: impl fmt::Display) -> Self {
        Self::new(format!("`{}`: {what}", path.display()))
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for CaseError {}

impl From<EvidenceError> for CaseError {
    fn from(error: EvidenceError) -> Self {
        Self::new(error.to_string())
    }
}
