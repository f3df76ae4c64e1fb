//! What a person says of a recording: which device it is of, and of which day.

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
    let mut words = text
        .split(|c: char| !c.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .peekable();
    let open = ["TODO", "TBD", "FIXME", "XXX"];
    words.peek().is_none() || words.any(|word| open.contains(&word.to_uppercase().as_str()))
}
