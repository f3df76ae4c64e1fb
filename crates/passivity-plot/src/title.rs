//! Titles that fit their picture.

use crate::frame::width;

/// The least size of letters that is read with ease, in pixels.
const SMALLEST: f64 = 13.0;

/// A title and the size of its letters, both as given where it fits in so many pixels: else in smaller letters, and if it is
/// too long for the smallest too, without its middle. Names stand in the middle of a title, and what became of them at its end.
///
/// # Example
///
/// ```
/// use passivity_plot::fitted;
///
/// assert_eq!(fitted("re35: at rest", 400.0, 18.0), ("re35: at rest".to_owned(), 18.0));
/// let (title, size) = fitted(&format!("{}.csv, up to the error in row 3", "a".repeat(90)), 400.0, 18.0);
/// assert!(title.starts_with("aaaa") && title.ends_with("a.csv, up to the error in row 3"));
/// assert_eq!(size, 13.0);
/// ```
#[must_use]
pub fn fitted(title: &str, wide: f64, size: f64) -> (String, f64) {
    let least = SMALLEST.min(size);
    let needed = width(title, size);
    if needed <= wide {
        return (title.to_owned(), size);
    }
    if width(title, least) <= wide {
        return (title.to_owned(), size * wide / needed);
    }
    let letters: Vec<char> = title.chars().collect();
    let room = (1..letters.len()).rev();
    let mut room = room.filter(|room| width(&"…".repeat(*room), least) <= wide);
    let kept = room.next().unwrap_or(1) - 1;
    let (start, end) = (kept / 3, letters.len() - (kept - kept / 3));
    let ends = letters.iter().take(start).chain(['…'].iter());
    let fits = ends.chain(letters.iter().skip(end)).collect();
    (fits, least)
}
