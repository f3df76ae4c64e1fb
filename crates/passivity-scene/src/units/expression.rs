//! The grammar of units: products, quotients, powers, parentheses.

use std::ops::Range;

use super::{MAX_CHARS, Unit, UnitError, symbols};

/// How deep parentheses may stand in each other.
const MAX_DEPTH: u8 = 8;

/// The largest power of a factor.
const MAX_POWER: i8 = 9;

pub(super) fn parse(text: &str) -> Result<Unit, UnitError> {
    if text.len() > MAX_CHARS {
        let message = format!("a unit may have at most {MAX_CHARS} characters");
        return Err(malformed(0..text.len(), message));
    }
    let mut reader = Reader {
        text,
        at: 0,
        depth: 0,
    };
    let unit = reader.product()?;
    match reader.peek() {
        None => Ok(unit),
        Some(c) => Err(malformed(
            reader.at..reader.at + c.len_utf8(),
            format!("`{}` cannot stand here in a unit", c.escape_debug()),
        )),
    }
}

fn malformed(span: Range<usize>, message: impl Into<String>) -> UnitError {
    UnitError {
        unknown: false,
        span,
        message: message.into(),
        help: None,
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    depth: u8,
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn skip_spaces(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }

    fn take_if(&mut self, accepted: &[char]) -> Option<char> {
        let c = self.peek().filter(|c| accepted.contains(c))?;
        self.at += c.len_utf8();
        Some(c)
    }

    /// Takes the hyphen of `oz-in` and the point of `N.m`: one before a letter.
    fn take_joint(&mut self) {
        let behind = self.rest().strip_prefix(['-', '.']);
        let next = behind.and_then(|rest| rest.chars().next());
        if next.is_some_and(char::is_alphabetic) {
            self.at += 1;
        }
    }

    /// factor { (space | * | · | . | - | /) factor }
    fn product(&mut self) -> Result<Unit, UnitError> {
        self.skip_spaces();
        let mut unit = Unit::one();
        // A leading slash, as in `5 /s`.
        if self.peek() != Some('/') {
            unit = self.factor(&unit, 1)?;
        }
        let mut divided = false;
        loop {
            self.skip_spaces();
            let start = self.at;
            let divides = self.take_if(&['/']).is_some();
            if !divides && self.take_if(&['*', '·', '⋅', '∙']).is_none() {
                self.take_joint();
            }
            let has_sign = self.at > start;
            self.skip_spaces();
            if !has_sign && matches!(self.peek(), None | Some(')')) {
                return Ok(unit);
            }
            let factor_at = self.at;
            let next = self.factor(&unit, if divides { -1 } else { 1 })?;
            if divided && !divides {
                let mut error = malformed(
                    factor_at..self.at,
                    "it is not clear whether what follows `/…` is multiplied or divided by",
                );
                error.help = Some("write parentheses, as in `N m/(rad s)`".to_owned());
                return Err(error);
            }
            divided |= divides;
            unit = next;
        }
    }

    /// The product of `unit` with the factor that stands here, to the power `sign` times its own.
    fn factor(&mut self, unit: &Unit, sign: i8) -> Result<Unit, UnitError> {
        let start = self.at;
        let mut compound = false;
        let base = if self.take_if(&['(']).is_some() {
            self.group(start)?
        } else if self.take_one() {
            Unit::one()
        } else {
            let symbol = self.symbol()?;
            compound = symbols::is_compound(symbol);
            symbols::find(symbol).ok_or_else(|| unknown(start..self.at, symbol))?
        };
        let base_end = self.at;
        let power = self.power()?;
        if compound && self.at > base_end {
            let mut error = malformed(
                start..self.at,
                "it is not clear which unit the power belongs to",
            );
            error.help = Some("write a space between the units, as in `N m^2`".to_owned());
            return Err(error);
        }
        unit.times(&base, sign * power)
            .filter(|unit| unit.pi.unsigned_abs() <= 2)
            .ok_or_else(|| malformed(start..self.at, "the powers in this unit are too large"))
    }

    /// The `1` of `1/s`, which is no factor anywhere else: in `3.45(12) N` the digits are an uncertainty.
    fn take_one(&mut self) -> bool {
        let divided = self.rest().strip_prefix('1');
        let is_one = divided.is_some_and(|rest| rest.trim_start().starts_with('/'));
        if is_one {
            self.at += 1;
        }
        is_one
    }

    fn group(&mut self, start: usize) -> Result<Unit, UnitError> {
        let digits = self.rest().split(')').next().unwrap_or_default();
        if !digits.is_empty() && digits.bytes().all(|c| c.is_ascii_digit() || c == b'.') {
            let message = format!("expected a unit in these parentheses, found `{digits}`");
            let end = self.at + (digits.len() + 1).min(self.rest().len());
            let mut error = malformed(start..end, message);
            error.help =
                Some("a tolerance is written with `±`, as in `3.45 ± 0.12 mN m`".to_owned());
            return Err(error);
        }
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            let message = format!("parentheses more than {MAX_DEPTH} deep");
            return Err(malformed(start..self.at, message));
        }
        let unit = self.product()?;
        if self.take_if(&[')']).is_none() {
            return Err(malformed(
                start..start + 1,
                "this parenthesis is not closed",
            ));
        }
        self.depth -= 1;
        Ok(unit)
    }

    fn symbol(&mut self) -> Result<&'a str, UnitError> {
        let rest = self.rest();
        let is_letter = |c: char| c.is_alphabetic() || c == '°' || c == '\u{b5}';
        let len = rest.find(|c| !is_letter(c)).unwrap_or(rest.len());
        let Some(symbol) = rest.get(..len).filter(|symbol| !symbol.is_empty()) else {
            let mut chars = rest.chars();
            let Some(c) = chars.next() else {
                let message = "expected a unit here, found nothing";
                return Err(malformed(self.at..self.at, message));
            };
            let message = format!("expected a unit here, found `{}`", c.escape_debug());
            let mut error = malformed(self.at..self.at + c.len_utf8(), message);
            if c == ',' && chars.next().is_some_and(|next| next.is_ascii_digit()) {
                let help = "a decimal point is written `.`, as in `1.5`, and digits have no commas between them";
                error.help = Some(help.to_owned());
            }
            return Err(error);
        };
        self.at += len;
        Ok(symbol)
    }

    /// `^2`, `^-1`, `²`, `⁻¹`, or the digit of `m2`; 1 when there is none.
    fn power(&mut self) -> Result<i8, UnitError> {
        let start = self.at;
        let caret = self.take_if(&['^']).is_some();
        // In `oz-in` the hyphen is no sign of a power.
        let signed = caret || self.rest().chars().nth(1).and_then(digit).is_some();
        let minus = signed && self.take_if(&['-', '−', '⁻']).is_some();
        if !minus && caret {
            self.take_if(&['+']);
        }
        let digits_at = self.at;
        let mut value: i8 = 0;
        while let Some(digit) = self.peek().and_then(digit) {
            self.at += self.peek().map_or(0, char::len_utf8);
            value = value.saturating_mul(10).saturating_add(digit);
        }
        if self.at == digits_at {
            return if self.at == start {
                Ok(1)
            } else {
                let message = "expected a whole number as the power";
                Err(malformed(start..self.at, message))
            };
        }
        if value > MAX_POWER {
            let message = format!("a power may be at most {MAX_POWER}");
            return Err(malformed(start..self.at, message));
        }
        Ok(if minus { -value } else { value })
    }
}

fn digit(c: char) -> Option<i8> {
    const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let value = match c.to_digit(10) {
        Some(value) => usize::try_from(value).ok(),
        None => SUPERSCRIPTS.iter().position(|s| *s == c),
    };
    value.and_then(|value| i8::try_from(value).ok())
}

fn unknown(span: Range<usize>, symbol: &str) -> UnitError {
    let shown: String = symbol.chars().take(40).collect();
    UnitError {
        unknown: true,
        span,
        message: match symbols::is_ambiguous(symbol) {
            true => format!("`{shown}` may be degrees or gradians: write `deg` or `gon`"),
            false => format!("unknown unit `{shown}`"),
        },
        help: None,
    }
}

/// The most unknown symbols of one unit that others are proposed for.
const MOST_UNKNOWN: u8 = 3;

/// Which unit may have been meant, of those that fit: all that differ from the nearest in the case of letters only.
pub(super) fn proposal(text: &str, fits: &dyn Fn(&Unit) -> bool) -> Option<String> {
    let mut found = repaired(text, MOST_UNKNOWN, fits);
    let nearest = found.first()?.clone();
    found.retain(|other| other.eq_ignore_ascii_case(&nearest));
    let found: Vec<String> = found.iter().map(|unit| format!("`{unit}`")).collect();
    Some(format!("did you mean {}?", found.join(" or ")))
}

/// The text with known symbols in place of at most so many unknown ones, where it then fits.
fn repaired(text: &str, unknown: u8, fits: &dyn Fn(&Unit) -> bool) -> Vec<String> {
    let error = match parse(text) {
        Ok(unit) if fits(&unit) => return vec![text.to_owned()],
        Err(error) if error.unknown && unknown > 0 => error,
        _ => return Vec::new(),
    };
    let part = |range| text.get(range).unwrap_or_default();
    let [before, symbol, behind] = [
        part(0..error.span.start),
        part(error.span.clone()),
        part(error.span.end..text.len()),
    ];
    let meant = symbols::meant(symbol).into_iter();
    meant
        .flat_map(|symbol| repaired(&format!("{before}{symbol}{behind}"), unknown - 1, fits))
        .collect()
}
