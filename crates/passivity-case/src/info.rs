//! The fields of a case that people fill in: author, reviewer, approval, intended use, date.

use std::path::Path;

use passivity_audit::{is_day, is_placeholder};
use serde::Deserialize;

use crate::error::CaseError;
use crate::files::read_text;

/// Such a file is no larger than this.
const MOST_BYTES: u64 = 1 << 20;

/// The fields of a case that people fill in. A field that is not given is shown as such.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Info {
    /// The title of the document.
    pub title: Option<String>,
    /// Who wrote the case.
    pub author: Option<String>,
    /// Who reviewed it.
    pub reviewer: Option<String>,
    /// Who approved it, and how.
    pub approval: Option<String>,
    /// What the device is meant for.
    pub intended_use: Option<String>,
    /// The date of the case: it is given, because a clock would make every run different.
    date: Option<Date>,
    /// The text of the file.
    #[serde(skip)]
    pub text: String,
}

/// A date, in quotes or without.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(untagged)]
enum Date {
    Text(String),
    Day(toml::value::Datetime),
}

impl Info {
    /// Reads such a file.
    ///
    /// # Errors
    ///
    /// A file that cannot be read or has other fields, a field that was left to be filled in, and a
    /// date that is none.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let text = read_text(path, MOST_BYTES)?;
        Self::parse(text).map_err(|what| CaseError::within(path, what.trim_end()))
    }

    fn parse(text: String) -> Result<Self, String> {
        let mut info: Self = toml::from_str(&text).map_err(|error| error.to_string())?;
        info.text = text;
        for (name, value) in info.fields() {
            if value.is_some_and(|value| is_placeholder(&value)) {
                return Err(format!(
                    "`{name}` still has to be filled in: write what it is, or leave the field out"
                ));
            }
        }
        if info.date().is_some_and(|date| !is_day(&date)) {
            return Err("`date` must be a day, such as 2026-03-31".to_owned());
        }
        Ok(info)
    }

    /// The date as it was given.
    #[must_use]
    pub fn date(&self) -> Option<String> {
        self.date.as_ref().map(|date| match date {
            Date::Text(text) => text.clone(),
            Date::Day(day) => day.to_string(),
        })
    }

    /// Every field with its name in the file.
    #[must_use]
    pub fn fields(&self) -> [(&'static str, Option<String>); 6] {
        [
            ("title", self.title.clone()),
            ("author", self.author.clone()),
            ("reviewer", self.reviewer.clone()),
            ("approval", self.approval.clone()),
            ("intended_use", self.intended_use.clone()),
            ("date", self.date()),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_read_and_a_date_is_a_day() {
        for date in ["2026-03-31", "\"2026-03-31\""] {
            let text = format!("author = \"A. Person\"\ndate = {date}\n");
            let info = Info::parse(text).unwrap();
            assert_eq!(info.author.as_deref(), Some("A. Person"));
            assert_eq!(info.date().as_deref(), Some("2026-03-31"));
            assert_eq!(info.reviewer, None);
        }
    }

    #[test]
    fn what_is_still_to_be_filled_in_is_refused() {
        for (text, about) in [
            ("author = \"\"", "`author`"),
            ("reviewer = \"TODO\"", "`reviewer`"),
            ("approval = \"tbd by the board\"", "`approval`"),
            ("intended_use = \"…\"", "`intended_use`"),
            ("date = \"soon\"", "`date`"),
            ("date = \"2026-02-30\"", "`date`"),
            ("date = 2026-03-31T10:00:00", "`date`"),
            ("date = 7", "date = 7"),
            ("writer = \"me\"", "writer"),
        ] {
            let error = Info::parse(text.to_owned()).unwrap_err();
            assert!(error.contains(about), "{text}: {error}");
        }
    }
}
