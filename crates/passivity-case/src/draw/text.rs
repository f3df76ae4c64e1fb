//! Breaking text into lines of a known width.

/// Size of the letters in pixels.
pub(super) const FONT: f64 = 11.0;

/// From one line to the next, in pixels.
pub(super) const LINE: f64 = 14.0;

/// Widths of the printable ASCII letters of DejaVu Sans, from the space on, in 1/2048 of the size.
/// It is the widest of the fonts that the drawing asks for.
#[rustfmt::skip]
const ASCII: [u16; 95] = [
    651, 821, 942, 1716, 1303, 1946, 1597, 563, 799, 799, 1024, 1716,
    651, 739, 651, 690, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303,
    1303, 1303, 690, 690, 1716, 1716, 1716, 1087, 2048, 1401, 1405, 1430,
    1577, 1294, 1178, 1587, 1540, 604, 604, 1343, 1141, 1767, 1532, 1612,
    1235, 1612, 1423, 1300, 1251, 1499, 1401, 2025, 1403, 1251, 1403, 799,
    690, 799, 1716, 1024, 1024, 1255, 1300, 1126, 1300, 1260, 721, 1300,
    1298, 569, 569, 1186, 569, 1995, 1298, 1253, 1300, 1300, 842, 1067,
    803, 1298, 1212, 1675, 1212, 1212, 1075, 1303, 690, 1303, 1716,
];

/// The width of a text in pixels, in [`FONT`]: at least what it takes.
pub(super) fn width(text: &str) -> f64 {
    text.chars().map(letter_width).sum()
}

/// The width of a letter; one beyond ASCII counts as wide as it is high, which few are.
fn letter_width(letter: char) -> f64 {
    let index = u32::from(letter).checked_sub(0x20);
    let index = index.and_then(|index| usize::try_from(index).ok());
    let known = index.and_then(|index| ASCII.get(index));
    match (known, letter) {
        (Some(units), _) => f64::from(*units) / 2048.0 * FONT,
        // Greek letters, and the signs that stand between numbers.
        (None, 'α'..='ω' | 'Α'..='Ω' | '·' | '–' | '“' | '”' | '«' | '»' | '⌊' | '⌋' | '∫') => {
            0.85 * FONT
        }
        (None, _) => FONT,
    }
}

/// Lines of `text` no wider than `most`; a longer word is broken, after a hyphen, underscore,
/// full stop or slash where it has one.
pub(super) fn wrap(text: &str, most: f64) -> Vec<String> {
    let mut lines = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            let fits = width(word) <= most;
            let pieces: Vec<&str> = if fits {
                vec![word]
            } else {
                word.split_inclusive(['-', '_', '.', '/']).collect()
            };
            for (index, piece) in pieces.into_iter().enumerate() {
                let space = if line.is_empty() || index > 0 {
                    ""
                } else {
                    " "
                };
                let joined = format!("{line}{space}{piece}");
                if width(&joined) <= most {
                    line = joined;
                    continue;
                }
                if !line.is_empty() {
                    lines.push(std::mem::take(&mut line));
                }
                for letter in piece.chars() {
                    if !line.is_empty() && width(&line) + letter_width(letter) > most {
                        lines.push(std::mem::take(&mut line));
                    }
                    line.push(letter);
                }
            }
        }
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_is_wider_than_asked_and_no_letter_is_lost() {
        let text = "β = b/(KT) and a_very_long_word_that_does_not_fit_into_one_line at all";
        let lines = wrap(text, 80.0);
        assert!(lines.iter().all(|line| width(line) <= 80.0), "{lines:?}");
        let squeezed = |t: &str| t.replace(' ', "");
        assert_eq!(squeezed(&lines.concat()), squeezed(text));
        assert!(lines.len() >= 5);
    }

    #[test]
    fn widths_are_those_of_the_font() {
        // DejaVu Sans: `i` is 569 and `W` 2025 of 2048 units wide, `~` is the last, `…` a whole.
        for (letter, units) in [("i", 569.0), ("W", 2025.0), ("~", 1716.0), ("…", 2048.0)] {
            assert!(
                (width(letter) - FONT * units / 2048.0).abs() < 1e-9,
                "{letter}"
            );
        }
    }
}
