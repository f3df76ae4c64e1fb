//! Words as they are typed in a shell.

/// A word as a shell takes it: in quotes where it has more than letters, digits and few signs.
///
/// ```
/// use passivity_audit::shell_word;
///
/// assert_eq!(shell_word("log.csv"), "log.csv");
/// assert_eq!(shell_word("t=time [s]"), "'t=time [s]'");
/// assert_eq!(shell_word("it's"), r"'it'\''s'");
/// ```
#[must_use]
pub fn shell_word(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./+:@%".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

/// What `--delimiter` calls a delimiter: `tab`, or the character itself.
///
/// ```
/// assert_eq!(passivity_audit::delimiter_name('\t'), "tab");
/// assert_eq!(passivity_audit::delimiter_name(';'), ";");
/// ```
#[must_use]
pub fn delimiter_name(delimiter: char) -> String {
    match delimiter {
        '\t' => "tab".to_owned(),
        other => other.to_string(),
    }
}
