//! Exit codes and failures of the command.

use std::fmt::Display;
use std::io;
use std::process::ExitCode;

/// What the exit code says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Exit {
    /// The claim holds.
    Holds = 0,
    /// It does not hold, or it depends.
    Fails = 1,
    /// Bad input or usage.
    BadInput = 2,
    /// The scene has an effect that no theorem covers.
    NotCovered = 3,
}

impl Exit {
    /// The exit of several answers: bad input first, then a claim that fails, then one not covered.
    pub(crate) fn and(self, other: Self) -> Self {
        let weight = |exit: Self| match exit {
            Self::Holds => 0,
            Self::NotCovered => 1,
            Self::Fails => 2,
            Self::BadInput => 3,
        };
        if weight(other) > weight(self) {
            other
        } else {
            self
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}

/// Why a command could not do its work.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Bad input or usage, with a message for people.
    Input(String),
    /// A scene that cannot be read, with its diagnostics drawn out.
    Scene(String),
}

impl Failure {
    /// Bad input: where, and what is wrong with it.
    pub(crate) fn input(what: impl Display) -> Self {
        Self::Input(what.to_string())
    }

    /// A file or stream that cannot be read or written.
    pub(crate) fn io(what: impl Display, error: &io::Error) -> Self {
        let error = error.to_string();
        // The number of the system's error tells people nothing.
        let words = error.split(" (os error").next();
        Self::Input(format!("{what}: {}", words.unwrap_or(&error)))
    }

    /// Says what went wrong on standard error and gives the exit code.
    pub(crate) fn report(&self) -> ExitCode {
        match self {
            Self::Input(message) => {
                crate::output::tell(&format!("error: {}", message.trim_end()));
                Exit::BadInput.into()
            }
            Self::Scene(diagnostics) => {
                crate::output::tell_drawn(diagnostics);
                Exit::BadInput.into()
            }
        }
    }
}
