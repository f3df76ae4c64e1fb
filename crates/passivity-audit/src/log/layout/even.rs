//! Which intervals of a log last exactly one period.

use super::Layout;
use crate::log::numbers::Numbers;
use crate::number::{Number, power_of_ten};

impl Layout {
    /// How many of the intervals between these times, from one on, last exactly one period.
    pub(crate) fn even(&self, times: &Numbers, from: usize) -> usize {
        let Number::Small(n, d) = &self.per_period else {
            return 0;
        };
        let (n, d) = (i128::from(*n), i128::from(*d));
        let is_period = |from: &Number, to: &Number| {
            let (Number::Small(a, b), Number::Small(p, q)) = (from, to) else {
                return None;
            };
            let [a, b, p, q] = [*a, *b, *p, *q].map(i128::from);
            // p/q − a/b = n/d
            let (numerator, denominator): (i128, i128) = match b == q {
                true => (p - a, b),
                false => (p * b - a * q, b * q),
            };
            Some(numerator.checked_mul(d)? == n.checked_mul(denominator)?)
        };
        let mut even = match times {
            Numbers::Decimals(numerators, powers) => {
                even_decimals((numerators, powers), from, (n, d)).unwrap_or(0)
            }
            Numbers::Doubles(_) | Numbers::Any(_) => 0,
        };
        let mut before = times.get(from + even);
        for i in from + even + 1..times.len() {
            let next = times.get(i);
            let pair = before.as_ref().zip(next.as_ref());
            if pair.and_then(|(from, to)| is_period(from, to)) != Some(true) {
                break;
            }
            (before, even) = (next, even + 1);
        }
        even
    }
}

/// How many of the intervals between these times over powers of ten, from one on, last n/d, as long as times have one
/// power; `None` where machine integers do not tell.
fn even_decimals(
    (numerators, powers): (&[i64], &[u8]),
    from: usize,
    (n, d): (i128, i128),
) -> Option<usize> {
    let power = powers.get(from)?;
    let period = n.checked_mul(power_of_ten((*power).into())?.into())?;
    // No whole number of units is a fraction of one.
    let period = (period % d == 0).then(|| i64::try_from(period / d).ok())??;
    let pairs = numerators.get(from..)?.windows(2);
    let is_even = |(pair, own): &(&[i64], &u8)| {
        matches!(pair, [from, to] if to.checked_sub(*from) == Some(period)) && *own == power
    };
    let powers = powers.get(from + 1..)?;
    Some(pairs.zip(powers).take_while(is_even).count())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn periods_are_whole_numbers_of_units_over_one_power() {
        let even = |numerators: &[i64], powers: &[u8], from, period| {
            even_decimals((numerators, powers), from, period)
        };
        // In milliseconds, of 1/2 s: without and with a digit behind the point.
        assert_eq!(even(&[0, 500, 1000, 1501], &[0; 4], 0, (500, 1)), Some(2));
        assert_eq!(even(&[0, 499, 999, 1499], &[0; 4], 1, (500, 1)), Some(2));
        assert_eq!(even(&[5000, 10_000], &[1; 2], 0, (500, 1)), Some(1));
        // A longer power is for others to compare.
        assert_eq!(even(&[0, 500, 10_000], &[0, 0, 1], 0, (500, 1)), Some(1));
        assert_eq!(even(&[0, 1, 2], &[0; 3], 0, (1, 3)), None);
        assert_eq!(even(&[i64::MIN, i64::MAX], &[0; 2], 0, (1, 1)), Some(0));
        assert_eq!(even(&[], &[], 0, (1, 1)), None);
    }
}
