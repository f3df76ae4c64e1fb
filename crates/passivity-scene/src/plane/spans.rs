//! The numbers of a column that pass: from a formula, or by halving.

use num_traits::Signed as _;
use passivity_core::parameter::Hurts;
use passivity_core::{BigRational, Enclosed, Interval, Loop, verdict};

use super::extent::Extent;
use crate::check::{Side, border};
use crate::display::{Rounding, rounded};
use crate::number::nearest_f64;
use crate::parse::Axis;

/// The numbers of an axis that pass, from one end to the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    pub(super) ends: [End; 2],
}

impl Span {
    pub(super) const fn low(&self) -> End {
        let [low, _] = self.ends;
        low
    }

    pub(super) const fn high(&self) -> End {
        let [_, high] = self.ends;
        high
    }
}

/// An end of a span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    pub(super) at: f64,
    /// Whether it is a border of the region, not the edge of the picture.
    pub(super) is_border: bool,
}

/// The cells of a column that are looked at where no formula says its border.
const CELLS: u32 = 16;

/// The one span that a formula says: from the border on, to the side on which the criterion is easier.
pub(super) fn solved<S: Enclosed>(
    axis: &Axis,
    extent: &Extent,
    at: &Loop<Interval<S>>,
    speeds: &verdict::Speeds<Interval<S>>,
    passes: impl Fn(f64) -> bool,
) -> Option<Vec<Span>> {
    let parameter = axis.parameter();
    let side = match parameter.row().hurts {
        Hurts::Less => Side::AtLeast,
        _ => Side::AtMost,
    };
    let border = border(parameter, side, at, speeds)?;
    let hardest = match side {
        Side::AtLeast => border.hi().clone().max(S::zero()),
        Side::AtMost => border.lo().clone(),
    };
    // The side of the passing numbers on the axis: a rate is the reciprocal of a period.
    let upwards = (side == Side::AtLeast) != axis.is_reciprocal();
    let edges = [extent.decimal(0.0, axis), extent.decimal(1.0, axis)];
    let [low, high] = edges;
    if side == Side::AtMost && hardest.is_positive() != Some(true) {
        return Some(Vec::new());
    }
    let bits = enclosure_of(&hardest)?;
    let number = match axis.numbers(&bits) {
        Some(numbers) => numbers,
        // The reciprocal of zero: all numbers pass or none.
        None => {
            return Some(if passes(high) {
                whole(edges)
            } else {
                Vec::new()
            });
        }
    };
    let decimal = |digits: u32| {
        let (end, to) = if upwards {
            (number.hi(), Rounding::Up)
        } else {
            (number.lo(), Rounding::Down)
        };
        let text = if axis.is_whole() {
            if upwards { end.ceil() } else { end.floor() }.to_string()
        } else {
            rounded(end, digits, to)
        };
        text.parse::<f64>().ok()
    };
    let value = nearest_f64(if upwards { number.hi() } else { number.lo() });
    if (upwards && value <= low) || (!upwards && value >= high) {
        // All of the column, if the number at its hardest edge passes.
        let hardest_edge = if upwards { low } else { high };
        return Some(if passes(hardest_edge) {
            whole(edges)
        } else {
            Vec::new()
        });
    }
    let Some(at) = (7..14).filter_map(decimal).find(|w| passes(*w)) else {
        return Some(Vec::new());
    };
    if (upwards && at > high) || (!upwards && at < low) {
        return Some(Vec::new());
    }
    let border = End {
        at,
        is_border: true,
    };
    let edge = |at| End {
        at,
        is_border: false,
    };
    Some(vec![Span {
        ends: if upwards {
            [border, edge(high)]
        } else {
            [edge(low), border]
        },
    }])
}

fn enclosure_of<S: Enclosed>(x: &S) -> Option<Interval<BigRational>> {
    let bounds = x.enclosed(crate::check::BITS)?;
    let positive = !bounds.lo().is_negative();
    positive.then_some(bounds)
}

fn whole([low, high]: [f64; 2]) -> Vec<Span> {
    let edge = |at| End {
        at,
        is_border: false,
    };
    vec![Span {
        ends: [edge(low), edge(high)],
    }]
}

/// The spans of a column of which no formula knows: every change between neighbouring cells, halved
/// until its two sides are neighbouring decimals.
pub(super) fn searched(
    extent: &Extent,
    axis: &Axis,
    hints: &[f64],
    passes: impl Fn(f64) -> bool,
) -> Vec<Span> {
    let cells = (0..=CELLS).map(|i| f64::from(i) / f64::from(CELLS));
    let hinted = hints.iter().map(|w| extent.share(*w));
    let mut shares: Vec<f64> = cells
        .chain(hinted.filter(|s| (0.0..=1.0).contains(s)))
        .collect();
    shares.sort_by(f64::total_cmp);
    let looked: Vec<(f64, bool)> = shares
        .into_iter()
        .map(|share| (share, passes(extent.decimal(share, axis))))
        .collect();
    let mut spans = Vec::new();
    let mut open: Option<End> = None;
    let edge = |share| End {
        at: extent.decimal(share, axis),
        is_border: false,
    };
    if let Some((share, true)) = looked.first() {
        open = Some(edge(*share));
    }
    for pair in looked.windows(2) {
        let [(a, before), (b, after)] = pair else {
            continue;
        };
        match (before, after) {
            (false, true) => open = Some(bisected(*b, *a, extent, axis, &passes)),
            (true, false) => {
                if let Some(start) = open.take() {
                    let end = bisected(*a, *b, extent, axis, &passes);
                    spans.push(Span { ends: [start, end] });
                }
            }
            _ => {}
        }
    }
    if let (Some(start), Some((share, _))) = (open, looked.last()) {
        spans.push(Span {
            ends: [start, edge(*share)],
        });
    }
    spans
}

/// The last number that passes on the way from one that does to one that does not.
fn bisected(
    passing: f64,
    failing: f64,
    extent: &Extent,
    axis: &Axis,
    passes: impl Fn(f64) -> bool,
) -> End {
    let (mut inside, mut outside) = (passing, failing);
    loop {
        let middle = 0.5 * (inside + outside);
        let [a, m, b] = [inside, middle, outside].map(|share| extent.decimal(share, axis));
        if m == a || m == b {
            return End {
                at: a,
                is_border: true,
            };
        }
        if passes(m) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
}
