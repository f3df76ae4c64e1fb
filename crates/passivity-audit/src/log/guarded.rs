//! Libraries that assert on corrupt files, held back.

use std::cell::Cell;
use std::sync::Once;

use crate::log::error::TraceError;

thread_local! {
    /// Whether this thread is within [`guarded`].
    static GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// A library asserts on some corrupt files: what it says then is an error like any other, and not said
/// twice.
pub(crate) fn guarded<T>(
    format: &'static str,
    read: impl FnOnce() -> Result<T, TraceError>,
) -> Result<T, TraceError> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let report = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            if !GUARDED.get() {
                report(panic);
            }
        }));
    });
    let read = std::panic::AssertUnwindSafe(read);
    GUARDED.set(true);
    let outcome = std::panic::catch_unwind(read);
    GUARDED.set(false);
    outcome.unwrap_or_else(|_| {
        let (kind, name) = match format {
            "mcap" => ("mcap", "MCAP"),
            _ => ("parquet", "Parquet"),
        };
        let message = format!("cannot be read as {name}: its contents contradict each other");
        Err(TraceError::new(kind, message))
    })
}
