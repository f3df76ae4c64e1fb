//! Dates with a time of day, as ISO 8601 and RFC 3339 write them: `2023-11-14T22:13:20.5Z`.

use num_bigint::BigInt;
use passivity_core::BigRational;

use crate::number::Number;

/// The unit of a column of dates, which are read as seconds since 1970. No type of another column is in it.
pub(crate) const UNIT: &str = "s";

/// The most digits behind the point of the seconds.
const MOST_DIGITS: usize = 24;

/// Whether a text is a day of the calendar.
///
/// # Example
///
/// ```
/// use passivity_audit::is_day;
///
/// assert!(is_day("2028-02-29"));
/// assert!(!is_day("2026-02-29") && !is_day("22.11.2026") && !is_day("2026-11-22T10:00:00"));
/// ```
#[must_use]
pub fn is_day(text: &str) -> bool {
    let parts = numbers(text, '-', [4, 2, 2]);
    parts.is_some_and(|[year, month, day]| days(year, month, day).is_some())
}

/// The seconds since 1970 that a date with a time of day is, exactly; `None` of any other text. Without a zone it is
/// taken to be in UTC. A fraction is one of a second: behind minutes it would be one of a minute, and is not read.
pub(crate) fn seconds(text: &[u8]) -> Option<Number> {
    let text = std::str::from_utf8(text).ok()?.trim();
    let (date, time) = text.split_at_checked(10)?;
    let time = time.strip_prefix(['T', 't', ' '])?;
    let [year, month, day] = numbers(date, '-', [4, 2, 2])?;
    let (time, offset) = zone(time)?;
    let (clock, fraction) = time.split_once(['.', ',']).unwrap_or((time, "0"));
    let [hour, minute, second] = match time.len() {
        5 => numbers(time, ':', [2, 2]).map(|[hour, minute]| [hour, minute, 0])?,
        _ => numbers(clock, ':', [2, 2, 2])?,
    };
    let is_digits = fraction.bytes().all(|byte| byte.is_ascii_digit());
    if hour > 23 || minute > 59 || second > 59 || !is_digits || fraction.len() > MOST_DIGITS {
        return None;
    }
    let whole = days(year, month, day)? * 86_400 + hour * 3600 + minute * 60 + second - offset;
    let digits = u32::try_from(fraction.len()).ok()?;
    let power = 10_i128.pow(digits);
    let value = i128::from(whole) * power + fraction.parse::<i128>().ok()?;
    Some(match (i64::try_from(value), i64::try_from(power)) {
        (Ok(value), Ok(power)) => Number::Small(value, power),
        _ => BigRational::new(BigInt::from(value), BigInt::from(power)).into(),
    })
}

/// About how many seconds a duration or a time of day is, as in `0 days 00:00:00.0004` and `0:01.5`: it is not read, but is a clock
/// where it rises.
pub(crate) fn lasting(text: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(text).ok()?.trim();
    let (days, clock) = match text.split_once(" day") {
        Some((days, rest)) => (days, rest.trim_start_matches(['s', ',', ' ', '+'])),
        None => ("0", text),
    };
    let is_plain = |c: char| c.is_ascii_digit() || c == '.';
    let number = |text: &str| text.parse().ok().filter(|_| text.chars().all(is_plain));
    let parts: Option<Vec<f64>> = clock.split(':').map(number).collect();
    let parts = parts.filter(|parts| (2..=3).contains(&parts.len()))?;
    let seconds = parts.iter().fold(0.0, |sum, part| 60.0 * sum + part);
    Some(86_400.0 * number(days)? + seconds)
}

/// Whole numbers of so many digits, with a sign between them.
fn numbers<const N: usize>(text: &str, between: char, digits: [usize; N]) -> Option<[i64; N]> {
    let mut numbers = [0; N];
    let mut parts = text.split(between);
    for (number, digits) in numbers.iter_mut().zip(digits) {
        let part = parts.next().filter(|part| part.len() == digits)?;
        let is_digits = part.bytes().all(|byte| byte.is_ascii_digit());
        *number = part.parse().ok().filter(|_| is_digits)?;
    }
    parts.next().is_none().then_some(numbers)
}

/// A time of day apart from its zone, and how many seconds that is ahead of UTC.
fn zone(time: &str) -> Option<(&str, i64)> {
    let Some(at) = time.find(['Z', 'z', 'U', '+', '-']) else {
        return Some((time, 0));
    };
    let (time, zone) = time.split_at_checked(at)?;
    let time = time.trim_end();
    if ["Z", "z", "UTC"].contains(&zone) {
        return Some((time, 0));
    }
    let (sign, zone) = zone.split_at_checked(1)?;
    let [hours, minutes] = match zone.len() {
        2 => numbers(zone, ':', [2]).map(|[hours]| [hours, 0])?,
        4 => {
            let (hours, minutes) = zone.split_at_checked(2)?;
            [
                numbers::<1>(hours, ':', [2])?,
                numbers::<1>(minutes, ':', [2])?,
            ]
            .map(|[number]| number)
        }
        _ => numbers(zone, ':', [2, 2])?,
    };
    let offset = hours * 3600 + minutes * 60;
    let is_one = hours < 24 && minutes < 60;
    is_one.then_some((time, if sign == "-" { -offset } else { offset }))
}

/// The days from 1970 to a day of the Gregorian calendar.
fn days(year: i64, month: i64, day: i64) -> Option<i64> {
    let is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let length = match month {
        2 => 28 + i64::from(is_leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return None,
    };
    if !(1..=length).contains(&day) {
        return None;
    }
    // Years that start in March end with the day that may be a leap day.
    let (year, month) = match month {
        3.. => (year, month - 3),
        _ => (year - 1, month + 9),
    };
    let leaps = year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400);
    // Day 719468 of this count is the first of January 1970.
    Some(year * 365 + leaps + (153 * month + 2) / 5 + day - 1 - 719_468)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_seconds_since_1970() {
        for (text, expected) in [
            ("1970-01-01T00:00:00Z", "0"),
            ("2023-11-14T22:13:20.123456789Z", "1700000000.123456789"),
            ("2023-11-14 22:13:20.000000+00:00", "1700000000"),
            ("2023-11-15T00:13:20,5+02:00", "1700000000.5"),
            ("2023-11-14T18:43:20-0330", "1700000000"),
            ("2023-11-14t22:13:20 UTC", "1700000000"),
            ("2023-11-14 22:13", "1699999980"),
            ("2024-02-29T00:00:00+01", "1709161200"),
            ("2000-03-01T00:00:00", "951868800"),
            ("1969-12-31T23:59:59.75Z", "-0.25"),
            (
                "9999-12-31T23:59:59.123456789012345678Z",
                "253402300799.123456789012345678",
            ),
        ] {
            let found = seconds(text.as_bytes()).unwrap();
            assert_eq!(found, Number::parse(expected).unwrap(), "{text}");
        }
        for text in [
            "2023-11-14",
            "2023-02-29T00:00:00Z",
            "2023-13-01T00:00:00Z",
            "2023-1-01T00:00:00Z",
            "2023-11-14T24:00:00Z",
            "2023-11-14T22:60:00Z",
            "2023-11-14T22:13:60Z",
            "2023-11-14T22:13.001Z",
            "2023-11-14 22:13,5",
            "2023-11-14T22:13.0+01:00",
            "2023-11-14T22:13.",
            "2023-11-14T22:13:20.+1Z",
            "2023-11-14T22:13:20Zulu",
            "2023-11-14T22:13:20+25:00",
            "2023-11-14T22:13:20.1234567890123456789012345Z",
            "2023-11-14x22:13:20",
            "+023-11-14T22:13:20",
            "1700000000.5",
            "θ",
            "",
        ] {
            assert!(seconds(text.as_bytes()).is_none(), "{text}");
        }
    }
}
