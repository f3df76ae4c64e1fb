//! The values of an axis of a sweep: typed one by one, or computed where they are asked for.

use std::cmp::Ordering;
use std::fmt;

use num_bigint::{BigInt, Sign};
use passivity_core::BigRational;
use passivity_scene::number;

use crate::error::SimError;
use crate::number::to_double;
use crate::sweep::grid::MOST_POINTS;

/// The values of a parameter, exactly.
#[derive(Clone)]
pub struct Range(Values);

#[derive(Clone)]
enum Values {
    /// Each with the double that is nearest to it, and their indices by size.
    List(Vec<(BigRational, f64)>, Vec<usize>),
    Even(Even),
}

/// (first + i·step)/denominator for every i below `count`: nothing is kept for each, so that a range costs
/// no more than its ends.
#[derive(Clone, Debug)]
struct Even {
    first: BigInt,
    step: BigInt,
    denominator: BigInt,
    count: usize,
    /// The first three, where numerators and denominator are doubles: the division of two doubles is rounded
    /// once, as the nearest double of the fraction is.
    short: Option<[i64; 3]>,
}

/// Up to this a whole number is a double.
const WHOLE: i64 = 1 << 53;

/// From this many values on, a range says in a hash what it is made of, and not each of them.
const LONG: usize = 10_000;

impl Even {
    fn new(start: &BigRational, stop: &BigRational, count: usize) -> Self {
        let steps = BigInt::from(count.saturating_sub(1).max(1));
        let step = (stop - start) / BigRational::from_integer(steps.clone());
        // The least common one.
        let more = BigRational::new(start.denom().clone(), step.denom().clone());
        let denominator = start.denom() * more.denom();
        let [first, step] = [start, &step].map(|x| x.numer() * (&denominator / x.denom()));
        let last = &first + &step * steps;
        let is_double = |x: &BigInt| x.magnitude() <= BigInt::from(WHOLE).magnitude();
        let is_short = [&first, &last, &denominator].into_iter().all(is_double);
        let short = |x: &BigInt| i64::try_from(x).ok().filter(|_| is_short);
        let all = (short(&first), short(&step), short(&denominator));
        Self {
            short: match all {
                (Some(first), Some(step), Some(denominator)) => Some([first, step, denominator]),
                _ => None,
            },
            first,
            step,
            denominator,
            count,
        }
    }

    fn value(&self, index: usize) -> BigRational {
        let numerator = &self.first + &self.step * BigInt::from(index);
        BigRational::new(numerator, self.denominator.clone())
    }

    #[expect(
        clippy::cast_precision_loss,
        reason = "whole numbers that are doubles, as they are between the ends"
    )]
    fn double(&self, index: usize) -> f64 {
        match (self.short, i64::try_from(index)) {
            (Some([first, step, denominator]), Ok(index)) => {
                (first + step * index) as f64 / denominator as f64
            }
            _ => to_double(&self.value(index)),
        }
    }
}

impl From<Vec<BigRational>> for Range {
    fn from(values: Vec<BigRational>) -> Self {
        let with_double = |x: BigRational| {
            let double = to_double(&x);
            (x, double)
        };
        let list: Vec<(BigRational, f64)> = values.into_iter().map(with_double).collect();
        let mut order: Vec<(usize, f64)> = list.iter().map(|(_, x)| *x).enumerate().collect();
        order.sort_by(|(_, a), (_, b)| a.total_cmp(b));
        Self(Values::List(
            list,
            order.into_iter().map(|(index, _)| index).collect(),
        ))
    }
}

impl Range {
    /// Reads `start:stop:count`, both ends included, or a list `1,2,5`.
    ///
    /// # Errors
    ///
    /// Text that is neither, with what was expected.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_sim::sweep::Range;
    ///
    /// let thirds = Range::parse("0:1:4").unwrap();
    /// assert_eq!(thirds.value(1).to_string(), "1/3");
    /// assert_eq!(Range::parse("1/2,3").unwrap().len(), 2);
    /// let error = Range::parse("0:1").unwrap_err().to_string();
    /// assert_eq!(error, "range `0:1`: expected start:stop:count or a list as in 1,2,5");
    /// ```
    pub fn parse(text: &str) -> Result<Self, SimError> {
        let fail = |what: String| SimError::Method(format!("range `{text}`: {what}"));
        let number = |part: &str| {
            let part = part.trim();
            number::parse(part).map_err(|error| {
                let error = error.to_string();
                // Once is enough where it is the whole range, or the reason has it.
                let is_named = part == text || error.contains(&format!("`{part}`"));
                fail(if is_named {
                    error
                } else {
                    format!("`{part}`: {error}")
                })
            })
        };
        let parts: Vec<&str> = text.split(':').collect();
        match parts.as_slice() {
            [list] => {
                let values: Result<Vec<_>, _> = list.split(',').map(number).collect();
                Ok(Self::from(values?))
            }
            [start, stop, count] => {
                let (start, stop) = (number(start)?, number(stop)?);
                let count: Option<usize> = count.trim().parse().ok();
                let count = count
                    .filter(|n| (1..=MOST_POINTS).contains(n))
                    .ok_or_else(|| fail(format!("expected a count from 1 to {MOST_POINTS}")))?;
                if count == 1 && start != stop {
                    return Err(fail(
                        "a count of 1 needs start and stop to be equal".to_owned(),
                    ));
                }
                Ok(Self(Values::Even(Even::new(&start, &stop, count))))
            }
            _ => Err(fail(
                "expected start:stop:count or a list as in 1,2,5".to_owned(),
            )),
        }
    }

    /// How many values there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        match &self.0 {
            Values::List(list, _) => list.len(),
            Values::Even(even) => even.count,
        }
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The value with an index, from 0.
    ///
    /// # Panics
    ///
    /// When `index` is not below [`Self::len`].
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "a panic that is announced")]
    pub fn value(&self, index: usize) -> BigRational {
        match &self.0 {
            Values::List(list, _) => list[index].0.clone(),
            Values::Even(even) => {
                assert!(index < even.count, "value {index} of {}", even.count);
                even.value(index)
            }
        }
    }

    /// The double nearest to the value with an index, from 0.
    ///
    /// # Panics
    ///
    /// When `index` is not below [`Self::len`].
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "a panic that is announced")]
    pub fn double(&self, index: usize) -> f64 {
        match &self.0 {
            Values::List(list, _) => list[index].1,
            Values::Even(even) => {
                assert!(index < even.count, "value {index} of {}", even.count);
                even.double(index)
            }
        }
    }

    /// The values in order.
    pub fn iter(&self) -> impl Iterator<Item = BigRational> {
        (0..self.len()).map(|index| self.value(index))
    }

    /// The doubles nearest to the values, in order.
    pub fn doubles(&self) -> impl Iterator<Item = f64> {
        (0..self.len()).map(|index| self.double(index))
    }

    /// The first value that is not among those that are allowed: all numbers between two, or all whole ones
    /// of these.
    ///
    /// Values at even steps are all whole if the first two are, and run into what is not allowed once, so
    /// that it is found by halving.
    pub(super) fn first_not(&self, allowed: impl Fn(&BigRational) -> bool) -> Option<BigRational> {
        let even = match &self.0 {
            Values::List(list, _) => {
                let mut values = list.iter().map(|(x, _)| x);
                return values.find(|x| !allowed(x)).cloned();
            }
            Values::Even(even) => even,
        };
        let is_allowed = |index: usize| allowed(&even.value(index));
        let last = even.count.checked_sub(1)?;
        for index in [0, 1.min(last)] {
            if !is_allowed(index) {
                return Some(even.value(index));
            }
        }
        if is_allowed(last) {
            return None;
        }
        let (mut inside, mut outside) = (0, last);
        while outside - inside > 1 {
            let middle = inside.midpoint(outside);
            match is_allowed(middle) {
                true => inside = middle,
                false => outside = middle,
            }
        }
        Some(even.value(outside))
    }

    /// The first double that is nearest to two values next to each other in size.
    pub(super) fn twice(&self) -> Option<f64> {
        let even = match &self.0 {
            Values::List(_, order) => {
                let by_size = || order.iter().map(|index| self.double(*index));
                let mut pairs = by_size().zip(by_size().skip(1));
                return pairs.find(|(a, b)| a == b).map(|(a, _)| a);
            }
            Values::Even(even) => even,
        };
        // Values further apart than a rounding of the largest are different doubles.
        let [first, last] = [0, even.count.checked_sub(1)?].map(|index| even.double(index).abs());
        let rounding = (first.max(last) * f64::EPSILON).max(f64::from_bits(1));
        let step = BigRational::new(even.step.clone(), even.denominator.clone());
        if even.count == 1 || to_double(&step).abs() > rounding {
            return None;
        }
        let mut doubles = self.doubles().zip(self.doubles().skip(1));
        doubles.find(|(a, b)| a == b).map(|(a, _)| a)
    }

    /// The index of the value that this double is nearest to.
    pub(super) fn place(&self, double: f64) -> Option<usize> {
        let (order, rises) = match &self.0 {
            Values::List(_, order) => (Some(order), true),
            Values::Even(even) => (None, even.step.sign() != Sign::Minus),
        };
        let index = |rank: usize| order.map_or(Some(rank), |order| order.get(rank).copied());
        let (mut from, mut to) = (0, self.len());
        while from < to {
            let middle = from.midpoint(to);
            let at = index(middle)?;
            match (self.double(at).total_cmp(&double), rises) {
                (Ordering::Equal, _) => return Some(at),
                (Ordering::Less, true) | (Ordering::Greater, false) => from = middle + 1,
                (Ordering::Less, false) | (Ordering::Greater, true) => to = middle,
            }
        }
        None
    }

    /// The ends of a range of so many values that no hash is to go through all of them.
    fn long(&self) -> Option<&Even> {
        match &self.0 {
            Values::Even(even) if even.count >= LONG => Some(even),
            _ => None,
        }
    }
}

/// What a hash of the grid is made from: equal values, equal text, as long as they are not too many.
impl fmt::Debug for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.long() {
            Some(even) => even.fmt(f),
            None => f.debug_list().entries(self.iter()).finish(),
        }
    }
}

/// The doubles of a range as text; those of a long one follow from its ends.
pub(super) struct Doubles<'a>(pub(super) &'a Range);

impl fmt::Debug for Doubles<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.long() {
            Some(_) => Ok(()),
            None => f.debug_list().entries(self.0.doubles()).finish(),
        }
    }
}

#[cfg(test)]
mod tests {
    use passivity_random::Random;

    use super::*;

    #[test]
    fn a_value_is_the_one_of_its_index_and_its_double_the_nearest() {
        let mut random = Random::new(11);
        let mut number = |size: u32| {
            let numerator = random.between(-1.0, 1.0) * 10_f64.powi(i32::try_from(size).unwrap());
            format!("{}/{}", numerator.round(), 1 + size * size)
        };
        for size in 1..40 {
            for count in [2, 3, 41, 99_999_989] {
                let (start, stop) = (number(size), number(40 - size));
                let range = Range::parse(&format!("{start}:{stop}:{count}")).unwrap();
                let [from, to] = [&start, &stop].map(|text| number::parse(text).unwrap());
                let last = BigRational::from_integer((count - 1).into());
                for index in [0, 1, count / 2, count - 2, count - 1] {
                    let at = BigRational::from_integer(index.into());
                    let value = &from + (&to - &from) / &last * at;
                    assert_eq!(range.value(index), value);
                    assert_eq!(range.double(index).to_bits(), to_double(&value).to_bits());
                }
            }
        }
    }

    #[test]
    fn values_that_no_double_tells_apart_are_found() {
        for (text, expected) in [
            ("1,2,5,5", Some(5.0)),
            ("3,1e-400,0", Some(0.0)),
            ("-1:1:99999999", None),
            ("1:1:1", None),
            ("1:1:3", Some(1.0)),
            ("1:1.0000000000000001:2", Some(1.0)),
            ("1:1.0000000000000003:2", None),
            ("1e-400:2e-400:2", Some(0.0)),
            ("-1e9:-1000000000.00001:99999999", Some(-1e9)),
        ] {
            assert_eq!(Range::parse(text).unwrap().twice(), expected, "{text}");
        }
    }

    #[test]
    fn a_value_is_found_by_its_double() {
        for text in [
            "0:1:12345",
            "3:-2:99",
            "3:3:1",
            "5,-1,2,1e300,1/3",
            "1e-320:1e-318:7",
        ] {
            let range = Range::parse(text).unwrap();
            for (index, double) in range.doubles().enumerate() {
                assert_eq!(range.place(double), Some(index), "{text}");
            }
            for other in [-0.0, 0.7, 1e9, -1e9, f64::NAN, f64::INFINITY] {
                assert_eq!(range.place(other), None, "{text}: {other}");
            }
        }
    }

    #[test]
    fn a_range_is_the_same_text_as_the_list_of_its_values() {
        let [range, list] = ["-1:1:5", "-1,-1/2,0,1/2,1"].map(|text| Range::parse(text).unwrap());
        assert_eq!(format!("{range:?}"), format!("{list:?}"));
        assert_eq!(
            format!("{range:?}"),
            format!("{:?}", list.iter().collect::<Vec<_>>())
        );
        let [range, list] = [&range, &list].map(Doubles);
        assert_eq!(format!("{range:?}"), format!("{list:?}"));
        // Long ranges that differ differ in their text.
        let long = ["0:1:20000", "0:1:20001", "0:2:20000", "1:0:20000"];
        let texts = long.map(|text| format!("{:?}", Range::parse(text).unwrap()));
        for (i, text) in texts.iter().enumerate() {
            assert!(text.len() < 200, "{text}");
            assert!(texts.iter().skip(i + 1).all(|other| other != text));
        }
    }

    #[test]
    fn the_first_value_that_is_not_allowed_is_found() {
        for (text, expected) in [
            ("1:7:4", None),
            ("-3:3:7", Some("-3")),
            ("3:-3:1000", Some("-1/333")),
            ("0:1:2", Some("0")),
            ("1,2,-2,-1", Some("-2")),
            ("5:5:1", None),
        ] {
            let found = Range::parse(text)
                .unwrap()
                .first_not(|x| x.numer() > &0.into());
            assert_eq!(found.map(|x| x.to_string()).as_deref(), expected, "{text}");
        }
        let whole = |text: &str| {
            Range::parse(text)
                .unwrap()
                .first_not(BigRational::is_integer)
        };
        assert_eq!(whole("1:99999999:50000000"), None);
        assert_eq!(
            whole("1:100000000:99999999").unwrap().to_string(),
            "199999997/99999998"
        );
    }
}
