//! SHA-256 sums, as files and claims are bound by them.

use std::fmt::{self, Write as _};

use serde::{Deserialize, Serialize};
use sha2::Digest as _;

/// A SHA-256 sum; in files it is 64 hexadecimal digits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize)]
#[serde(try_from = "String", into = "String")]
pub struct Sha256(pub(crate) [u8; 32]);

impl Sha256 {
    /// The sum of some bytes.
    ///
    /// # Example
    ///
    /// ```
    /// let sum = passivity_evidence::Sha256::of(b"abc").to_string();
    /// assert!(sum.starts_with("ba7816bf") && sum.len() == 64);
    /// ```
    #[must_use]
    pub fn of(bytes: &[u8]) -> Self {
        Self(sha2::Sha256::digest(bytes).into())
    }

    /// The sum of several texts, each with its length in front, so that no two lists of texts have
    /// the same sum because they read the same one after the other.
    #[must_use]
    pub fn of_texts<'a>(texts: impl IntoIterator<Item = &'a str>) -> Self {
        let mut all = String::new();
        for text in texts {
            // Writing to a string cannot fail.
            let _ = writeln!(all, "{}:{text}", text.len());
        }
        Self::of(all.as_bytes())
    }

    /// The first twelve digits, for people who compare by eye.
    #[must_use]
    pub fn short(&self) -> String {
        self.to_string().chars().take(12).collect()
    }
}

impl fmt::Display for Sha256 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

impl fmt::Debug for Sha256 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl From<Sha256> for String {
    fn from(sum: Sha256) -> Self {
        sum.to_string()
    }
}

impl TryFrom<String> for Sha256 {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let expected =
            || format!("expected the 64 hexadecimal digits of a SHA-256, found `{text}`");
        let digit = |byte: u8| char::from(byte).to_digit(16);
        let mut sum = [0; 32];
        let mut pairs = text.as_bytes().chunks_exact(2);
        if text.len() != 64 {
            return Err(expected());
        }
        for byte in &mut sum {
            let value = match pairs.next() {
                Some(&[high, low]) => digit(high).zip(digit(low)),
                _ => None,
            };
            let (high, low) = value.ok_or_else(expected)?;
            *byte = u8::try_from(high * 16 + low).map_err(|error| error.to_string())?;
        }
        Ok(Self(sum))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_read_as_they_are_written_and_nothing_else_is_one() {
        let sum = Sha256::of(b"abc");
        assert_eq!(Sha256::try_from(sum.to_string()), Ok(sum));
        for wrong in [
            "",
            "ba78",
            &"g".repeat(64),
            &"a".repeat(63),
            &"é".repeat(32),
        ] {
            assert!(Sha256::try_from(wrong.to_owned()).is_err(), "{wrong}");
        }
    }

    #[test]
    fn lists_that_read_the_same_have_sums_of_their_own() {
        assert_ne!(Sha256::of_texts(["a", "b"]), Sha256::of_texts(["a\nb"]));
        assert_ne!(Sha256::of_texts(["ab", ""]), Sha256::of_texts(["a", "b"]));
    }
}
