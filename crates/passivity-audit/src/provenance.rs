//! What a person says of a recording: which device it is of, and of which day.

/// Words that say that something still has to be written.
const OPEN: [&str; 4] = ["TODO", "TBD", "FIXME", "XXX"];

/// Whether a text is empty, or says that it still has to be written.
///
/// # Example
///
/// ```
/// use passivity_audit::is_placeholder;
///
/// assert!(is_placeholder("  ") && is_placeholder("TODO: measure it") && is_placeholder("???"));
/// assert!(!is_placeholder("Measured on 3 May, see the log of the bench."));
/// ```
#[must_use]
pub fn is_placeholder(text: &str) -> bool {
    words(text).next().is_none() || words(text).any(is_open)
}

/// Whether a text names a device. A name may have any word, as `rig XXX-7` does, and has one that does not say that the
/// name still has to be written.
///
/// # Example
///
/// ```
/// use passivity_audit::is_device;
///
/// assert!(is_device("rig XXX-7") && is_device("3"));
/// assert!(!is_device("") && !is_device(" - ") && !is_device("TODO") && !is_device("XXX"));
/// ```
#[must_use]
pub fn is_device(text: &str) -> bool {
    words(text).any(|word| !is_open(word))
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    let words = text.split(|c: char| !c.is_alphanumeric());
    words.filter(|word| !word.is_empty())
}

fn is_open(word: &str) -> bool {
    OPEN.contains(&word.to_uppercase().as_str())
}
