//! The ticks of an axis: at least two with labels, none over another.

use passivity_scene::display::figures;
use passivity_scene::plane::Extent;

use crate::frame::width;

/// The size of a label.
pub(crate) const SIZE: f64 = 13.0;

/// Which way an axis goes, and how many pixels it is long.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Along {
    /// From left to right: its labels are side by side.
    Page(f64),
    /// From below to above: its labels are one above the other.
    Side(f64),
}

/// A tick of an axis; one between others has no label.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    pub(crate) at: f64,
    pub(crate) label: String,
}

/// The digits of a label, if its ticks do not need more to be told apart.
const DIGITS: u8 = 5;
/// As many as tell all doubles apart.
const ALL_DIGITS: u8 = 17;

/// The ticks of an axis, with about as many labels as there is room for; of a single number only one.
pub(crate) fn ticks(extent: &Extent, along: Along) -> Vec<Tick> {
    /// About how many pixels are between labels.
    const BETWEEN: [f64; 2] = [90.0, 40.0];
    let wanted = match along {
        Along::Page(pixels) => pixels / BETWEEN[0],
        Along::Side(pixels) => pixels / BETWEEN[1],
    };
    let wanted = wanted.max(2.0);
    let powers = extent.log.then(|| logarithmic(extent, wanted));
    let mut choices = powers.into_iter().flatten().chain(linear(extent, wanted));
    // Where round numbers are too close to each other or to tell apart, the ends.
    let ends = [extent.from, extent.to].map(|at| {
        let mut all = (DIGITS..ALL_DIGITS).map(|digits| tick(at, digits));
        let exact = all.find(|tick| tick.label.parse() == Ok(at));
        exact.unwrap_or_else(|| tick(at, ALL_DIGITS))
    });
    let readable = choices.find_map(|all| thinned(all, extent, along));
    readable.unwrap_or_else(|| match ends {
        [from, to] if from == to => vec![from],
        ends => ends.to_vec(),
    })
}

fn tick(at: f64, digits: u8) -> Tick {
    Tick {
        at,
        label: figures(at, digits),
    }
}

/// Ticks with as many of their labels as do not touch; `None` where these are fewer than two.
fn thinned(all: Vec<Tick>, extent: &Extent, along: Along) -> Option<Vec<Tick>> {
    let labelled: Vec<&Tick> = all.iter().filter(|tick| !tick.label.is_empty()).collect();
    let are_apart = |every: &usize| {
        let kept = labelled.iter().step_by(*every);
        let mut pairs = kept.clone().zip(kept.skip(1));
        pairs.all(|(a, b)| a.label != b.label && gap(a, b, extent, along) >= 0.0)
    };
    let every = (1..labelled.len()).find(are_apart)?;
    let mut number = 0;
    let thin = |mut tick: Tick| {
        if !tick.label.is_empty() {
            if number % every != 0 {
                tick.label.clear();
            }
            number += 1;
        }
        tick
    };
    Some(all.into_iter().map(thin).collect())
}

/// The room between two labels, in pixels; below zero where they are too close.
fn gap(a: &Tick, b: &Tick, extent: &Extent, along: Along) -> f64 {
    let distance = |pixels: f64| (extent.share(b.at) - extent.share(a.at)).abs() * pixels;
    match along {
        Along::Page(pixels) => {
            let half = |tick: &Tick| 0.5 * width(&tick.label, SIZE);
            distance(pixels) - half(a) - half(b) - 0.7 * SIZE
        }
        Along::Side(pixels) => distance(pixels) - 1.1 * SIZE,
    }
}

/// Ticks at equal steps: first about as many as are wanted, then more.
fn linear(extent: &Extent, wanted: f64) -> impl Iterator<Item = Vec<Tick>> {
    let span = extent.to - extent.from;
    let power = 10.0_f64.powf((span / wanted).log10().floor());
    let steps = [10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1].map(|n| n * power);
    let fits = |step: &f64| span / *step <= wanted;
    let first = steps.iter().rposition(fits).unwrap_or(0);
    let steps = steps.into_iter().skip(first);
    steps.map(move |step| at_steps(extent, span, step))
}

fn at_steps(extent: &Extent, span: f64, step: f64) -> Vec<Tick> {
    /// Far more than are wanted.
    const MOST: f64 = 1000.0;
    let largest = extent.from.abs().max(extent.to.abs());
    let digits = (largest / step).log10().ceil() + 1.0;
    let digits = digits.clamp(DIGITS.into(), ALL_DIGITS.into()) as u8;
    let first = (extent.from / step - 1e-9).ceil();
    let count = ((extent.to / step + 1e-9).floor() - first).clamp(0.0, MOST);
    let mut all = Vec::new();
    let mut i = 0.0;
    while i <= count {
        let at = (first + i) * step;
        // What rounding leaves of zero.
        let at = if at.abs() < 1e-9 * span { 0.0 } else { at };
        if is_inside(extent, at) {
            all.push(tick(at, digits));
        }
        i += 1.0;
    }
    all
}

/// Whether an axis reaches so far, but for rounding.
fn is_inside(extent: &Extent, at: f64) -> bool {
    (-1e-9..=1.0 + 1e-9).contains(&extent.share(at))
}

/// Ticks at powers of ten and at what is between: first about as many as are wanted, then more.
fn logarithmic(extent: &Extent, wanted: f64) -> impl Iterator<Item = Vec<Tick>> {
    // Of two doubles the quotient may be none.
    let decades = extent.to.log10() - extent.from.log10();
    // Every so many decades, where even these are too many.
    let most = (decades / wanted).ceil();
    let every = std::iter::successors(Some(most), |every| Some((every / 2.0).floor()));
    let every = every.take_while(|every| *every > 1.0);
    let first: &[u8] = match 3.0 * decades <= wanted {
        true => &[1, 2, 5],
        false => &[1],
    };
    let single = [(1.0, first), (1.0, &[1, 2, 5])];
    let choices = every.map(move |every| (every, first)).chain(single);
    choices.map(|(every, labelled)| powers(extent, every, labelled))
}

/// The digits from 1 to 9 times every so many powers of ten, some of them with a label.
fn powers(extent: &Extent, every: f64, labelled: &[u8]) -> Vec<Tick> {
    let mut all = Vec::new();
    let mut exponent = extent.from.log10().floor();
    let last = extent.to.log10();
    while exponent <= last {
        for digit in 1..=9_u8 {
            let at = f64::from(digit) * 10.0_f64.powf(exponent);
            if !is_inside(extent, at) || (every > 1.0 && digit > 1) {
                continue;
            }
            let mut tick = tick(at, DIGITS);
            if !labelled.contains(&digit) || exponent.rem_euclid(every) != 0.0 {
                tick.label.clear();
            }
            all.push(tick);
        }
        exponent += 1.0;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent(from: f64, to: f64, log: bool) -> Extent {
        Extent { from, to, log }
    }

    fn labelled(extent: &Extent, along: Along) -> Vec<Tick> {
        let mut all = ticks(extent, along);
        all.retain(|tick| !tick.label.is_empty());
        all
    }

    fn labels(extent: &Extent, pixels: f64) -> Vec<String> {
        let all = labelled(extent, Along::Page(pixels)).into_iter();
        all.map(|tick| tick.label).collect()
    }

    #[test]
    fn an_axis_over_all_doubles_has_ticks() {
        let all = extent(f64::MIN_POSITIVE, f64::MAX, true);
        assert!(labelled(&all, Along::Page(540.0)).len() >= 2);
    }

    #[test]
    fn ticks_are_round_numbers_within_the_axis() {
        let linear = |from, to| labels(&extent(from, to, false), 540.0);
        assert_eq!(linear(0.0, 1.3), ["0", "0.5", "1"]);
        assert_eq!(
            linear(-0.3, 0.3),
            ["-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"]
        );
        let log = |from, to| labels(&extent(from, to, true), 540.0);
        assert_eq!(log(0.006, 3.0), ["0.01", "0.1", "1"]);
        assert_eq!(log(0.5, 20.0), ["0.5", "1", "2", "5", "10", "20"]);
        assert_eq!(log(1e-9, 1e9).len(), 7);
    }

    /// The axes of maps side by side, and the right axis of a motion, which had one label each.
    #[test]
    fn a_short_axis_has_more_than_one_label() {
        assert_eq!(labels(&extent(0.1, 3.1, false), 230.0), ["1", "2", "3"]);
        assert_eq!(
            labels(&extent(1.05, 1.95, false), 380.0),
            ["1.2", "1.4", "1.6", "1.8"]
        );
        assert_eq!(labels(&extent(2.5, 9.5, false), 230.0), ["4", "6", "8"]);
        let ticks = labelled(&extent(-488.0, 456.0, false), Along::Side(178.0));
        let at: Vec<f64> = ticks.iter().map(|tick| tick.at).collect();
        assert_eq!(at, [-400.0, -200.0, 0.0, 200.0, 400.0]);
    }

    #[track_caller]
    fn can_be_read(extent: &Extent, along: Along) {
        let all = labelled(extent, along);
        let told = || format!("{extent:?} {along:?} {all:?}");
        assert!(all.len() >= 2 && all.len() < 30, "{}", told());
        for pair in all.windows(2) {
            assert!(gap(&pair[0], &pair[1], extent, along) >= 0.0, "{}", told());
            assert_ne!(pair[0].label, pair[1].label, "{}", told());
        }
        for tick in &all {
            let said = extent.share(tick.label.parse().unwrap());
            assert!((-1e-3..=1.001).contains(&said), "{}", told());
            assert!((said - extent.share(tick.at)).abs() < 1e-3, "{}", told());
        }
    }

    #[test]
    fn every_axis_has_two_labels_at_least_and_none_over_another() {
        let sizes = [178.0, 230.0, 404.0, 900.0];
        let sizes = sizes.map(|pixels| [Along::Page(pixels), Along::Side(pixels)]);
        let starts = [0.0, 1.2, 2.5, 3.0, 4.99, 9.5, 123.456_789];
        let spans = [1e-9, 2.3e-5, 0.01, 0.27, 0.6, 0.9, 1.9, 4.4, 8.7, 77.0, 1e4];
        for one in [1e-30, 0.01, 1.0, 1e12] {
            for (start, span) in starts
                .iter()
                .flat_map(|start| spans.map(|span| (start, span)))
            {
                let (from, to) = (start * one, (start + span) * one);
                let log = match from > 0.0 {
                    true => extent(from, to, true),
                    // Over so many decades.
                    false => extent(one, one * 10_f64.powf(span.min(200.0)), true),
                };
                let around_zero = extent(-0.3 * (to - from), to - from, false);
                for extent in [
                    extent(from, to, false),
                    extent(-to, -from, false),
                    around_zero,
                    log,
                ] {
                    for along in sizes.iter().flatten() {
                        can_be_read(&extent, *along);
                    }
                }
            }
        }
    }

    #[test]
    fn an_axis_of_one_number_has_one_label() {
        for log in [false, true] {
            let all = ticks(&extent(2.0, 2.0, log), Along::Page(300.0));
            assert_eq!(all, [tick(2.0, 5)]);
        }
        // Neighbours among doubles are told apart.
        let near = extent(2.0, 2.0_f64.next_up(), false);
        assert_eq!(labels(&near, 400.0), ["2", "2.0000000000000004"]);
    }
}
