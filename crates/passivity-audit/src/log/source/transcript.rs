//! What a program for serial ports writes around the numbers of a log: how it is taken away.

use crate::log::error::shown;

/// What is said of a text with such lines; `None` where its first row is none.
pub(super) fn remedy(names: &[u8], rows: &[&[u8]]) -> Option<String> {
    let row = rows.first().copied().unwrap_or(names);
    if is_stamped(row) {
        return Some(format!(
            "each line starts with the time at which it was received, as the Serial Monitor writes it, `{}`: take that away, as \
             with `sed 's/^[0-9:.]* -> //'`",
            shown(row)
        ));
    }
    if !is_labelled(row) {
        return None;
    }
    // The labels of the first line become the names.
    let with_names = match is_labelled(names) {
        true => "1{h;s/:[-+.0-9eE]*//g;p;g;}' -e '",
        false => "1!",
    };
    Some(format!(
        "each number stands behind its name, as for the Serial Plotter, `{}`: write the names in the first line alone, as with \
         `sed -e '{with_names}s/[A-Za-z_][A-Za-z_0-9]*://g'`",
        shown(row)
    ))
}

/// Whether a line starts as `12:34:56.789 -> ` does.
fn is_stamped(line: &[u8]) -> bool {
    let line = String::from_utf8_lossy(line);
    let is_of_time = |c: char| c.is_ascii_digit() || ":.".contains(c);
    let time = line.split_once(" -> ").map(|(time, _)| time);
    time.is_some_and(|time| time.contains(':') && time.chars().all(is_of_time))
}

/// Whether all fields of a line are like `count:12`.
fn is_labelled(line: &[u8]) -> bool {
    let line = String::from_utf8_lossy(line);
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let is_one = |field: &str| {
        field.trim().split_once(':').is_some_and(|(name, number)| {
            name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
                && name.chars().all(is_name)
                && number.parse::<f64>().is_ok()
        })
    };
    let fields = line.trim().split([',', ';', '\t', ' ']);
    let mut fields = fields.filter(|field| !field.is_empty()).peekable();
    fields.peek().is_some() && fields.all(is_one)
}
