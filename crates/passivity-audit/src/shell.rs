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

/// The options with which logs are read whose fields stand apart by this, and whose numbers are written so; none where that
/// is how they are read anyway.
///
/// ```
/// use passivity_audit::notation_options;
///
/// assert_eq!(notation_options(Some(';'), true), ["--delimiter", ";", "--decimal-comma"]);
/// assert!(notation_options(None, false).is_empty());
/// ```
#[must_use]
pub fn notation_options(delimiter: Option<char>, decimal_comma: bool) -> Vec<String> {
    let mut words = Vec::new();
    if let Some(delimiter) = delimiter {
        words.extend(["--delimiter".to_owned(), delimiter_name(delimiter)]);
    }
    if decimal_comma {
        words.push("--decimal-comma".to_owned());
    }
    words
}

/// The same as they are typed, in a sentence that ends with them.
pub(crate) fn with_options(delimiter: Option<char>, decimal_comma: bool) -> String {
    let words = notation_options(delimiter, decimal_comma);
    let words: Vec<String> = words.iter().map(|word| shell_word(word)).collect();
    match words.is_empty() {
        true => String::new(),
        false => format!(", with `{}`", words.join(" ")),
    }
}
