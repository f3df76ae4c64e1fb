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
    let mut words = text.split(|c: char| !c.is_alphanumeric());
    let open = ["TODO", "TBD", "FIXME", "XXX"];
    is_blank(text) || words.any(|word| open.contains(&word.to_uppercase().as_str()))
}

/// Whether a text has neither a letter nor a digit. The name of a device may have any word, as `rig XXX-7` does.
///
/// ```
/// use passivity_audit::is_blank;
///
/// assert!(is_blank("") && is_blank(" - ") && !is_blank("rig XXX-7"));
/// ```
#[must_use]
pub fn is_blank(text: &str) -> bool {
    !text.contains(char::is_alphanumeric)
}
