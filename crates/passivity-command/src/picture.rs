//! The option `--plot`.

use std::path::PathBuf;

/// The name of a picture's file; without the feature `plot` there is none to draw it in, and nothing
/// is done before that is said.
#[cfg(feature = "plot")]
pub(crate) fn path(text: &str) -> Result<PathBuf, std::convert::Infallible> {
    Ok(text.into())
}

/// Refuses the name of a picture's file, before any work is done for it.
#[cfg(not(feature = "plot"))]
pub(crate) fn path(_: &str) -> Result<PathBuf, &'static str> {
    Err("pictures are not in this build: build it with the feature `plot`")
}

/// Refuses a picture that cannot be written, before any work is done for it.
#[cfg(feature = "plot")]
pub(crate) fn check(path: Option<&std::path::Path>) -> Result<(), crate::exit::Failure> {
    match path {
        Some(path) => passivity_plot::check_name(path).map_err(crate::exit::Failure::input),
        None => Ok(()),
    }
}

/// Nothing to check: a name was refused before.
#[cfg(not(feature = "plot"))]
pub(crate) fn check(_: Option<&std::path::Path>) -> Result<(), crate::exit::Failure> {
    Ok(())
}
