//! What every reader of foreign bytes must hold to, whatever the bytes: a function per reader that
//! takes any bytes, and panics when a promise is broken.
//!
//! `tests/corpus.rs` runs them on the committed corpus and on mutations of it, `tests/scenes.rs` the
//! scene reader on ten thousand mutations of the shipped scenes; `libfuzzer/` lets libFuzzer look for
//! inputs that reach new code, and `run` starts it.

mod answers;
mod random;
mod request;
mod scene;
mod trace;

pub use random::Random;

/// A reader, by name.
#[derive(Clone, Copy)]
pub struct Target {
    /// The name of its folder under `corpus`.
    pub name: &'static str,
    /// Reads the bytes and panics when a promise is broken.
    pub run: fn(&[u8]),
}

/// Every reader of foreign bytes.
pub const TARGETS: [Target; 6] = [
    Target {
        name: "scene",
        run: scene::run,
    },
    Target {
        name: "csv",
        run: trace::csv,
    },
    Target {
        name: "parquet",
        run: trace::parquet,
    },
    Target {
        name: "mcap",
        run: trace::mcap,
    },
    Target {
        name: "request",
        run: request::run,
    },
    Target {
        name: "answers",
        run: answers::run,
    },
];

/// The reader with this name.
///
/// # Panics
///
/// When there is none.
#[must_use]
pub fn target(name: &str) -> Target {
    let found = TARGETS.into_iter().find(|target| target.name == name);
    found.unwrap_or_else(|| panic!("no target `{name}`"))
}
