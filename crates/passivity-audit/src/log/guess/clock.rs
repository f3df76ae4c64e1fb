//! Clocks: in which unit they tick.

use passivity_scene::Scene;

use super::words::words;

/// The unit that a word says.
pub(super) fn unit_of_word(word: &str) -> Option<&'static str> {
    match word {
        "s" | "sec" | "second" => Some("s"),
        "ms" | "msec" | "milli" | "millisec" | "millisecond" => Some("ms"),
        "us" | "µs" | "μs" | "usec" | "micro" | "microsec" | "microsecond" => Some("us"),
        "ns" | "nsec" | "nano" | "nanosec" | "nanosecond" => Some("ns"),
        _ => None,
    }
}

/// The unit that the words of a name say, the last that says one.
fn unit_said(name: &str) -> Option<&'static str> {
    let words = words(name);
    let last = words.len().checked_sub(1)?;
    let lower = name.to_lowercase();
    let found = words.iter().enumerate().rev().find_map(|(i, word)| {
        // Within a name these may be other words, but for `seconds` and `millis`.
        let is_another = match word.as_str() {
            "s" => i < last,
            "second" | "milli" | "micro" | "nano" => {
                i < last && !lower.contains(&format!("{word}s"))
            }
            _ => false,
        };
        unit_of_word(word).filter(|_| !is_another)
    });
    found
}

/// The unit of a clock: the one that its name says, or else the one in which it goes on by about a sampling period from
/// row to row.
pub(super) fn unit_of_time(name: &str, step: Option<f64>, scene: &Scene) -> &'static str {
    unit_said(name).unwrap_or_else(|| nearest_unit(step, scene))
}

/// The unit in which a clock goes on by about a sampling period from row to row.
fn nearest_unit(step: Option<f64>, scene: &Scene) -> &'static str {
    const UNITS: [(&str, f64); 4] = [("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)];
    let period = scene.given.map(|_, given| given.nominal.clone()).period;
    let seconds = period
        .to_rational()
        .map(|x| passivity_scene::number::nearest_f64(&x));
    let (Some(step), Some(period)) = (step, seconds) else {
        return "s";
    };
    let off = |unit: f64| (step * unit / period).ln().abs();
    let best = UNITS
        .iter()
        .min_by(|(_, a), (_, b)| off(*a).total_cmp(&off(*b)));
    best.map_or("s", |(name, _)| name)
}
