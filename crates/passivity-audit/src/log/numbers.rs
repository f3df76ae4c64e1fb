//! Columns of numbers as they are written, kept short, and what is known of them after scaling.

mod balls;
mod units;

use num_bigint::BigInt;
use passivity_core::BigRational;

use crate::ball::Ball;
use crate::log::error::TraceError;
use crate::log::scale::Scale;
use crate::log::step::undefined;
use crate::number::{Number, power_of_ten};
use crate::reading::Reading;

pub(crate) use balls::Balls;
pub(crate) use units::{Read, Unit};

/// The numbers of a column.
#[derive(Clone, Debug)]
pub(crate) enum Numbers {
    /// n over 10^k, k at most [`MOST_DECIMALS`](crate::number::MOST_DECIMALS).
    Decimals(Vec<i64>, Vec<u8>),
    /// Doubles, each the dyadic rational that it is.
    Doubles(Vec<f64>),
    Any(Vec<Number>),
}

impl Default for Numbers {
    fn default() -> Self {
        Self::Decimals(Vec::new(), Vec::new())
    }
}

/// Whether something is so of all values: asked without a branch, of several at a time.
#[inline(always)]
pub(crate) fn all<T>(values: &[T], is: impl Fn(&T) -> bool) -> bool {
    values.iter().fold(true, |all, x| all & is(x))
}

/// n over 10^k.
pub(crate) fn decimal(n: i64, k: u8) -> Number {
    match power_of_ten(k.into()) {
        Some(power) => Number::Small(n, power),
        None => {
            let power = BigInt::from(10).pow(k.into());
            BigRational::new(n.into(), power).into()
        }
    }
}

/// Whether n over 10^k is m over 10^l.
fn is_same_decimal((n, k): (i64, u8), (m, l): (i64, u8)) -> bool {
    let (n, m, more) = if k <= l { (n, m, l - k) } else { (m, n, k - l) };
    let power = 10_i128.checked_pow(more.into());
    // What has more digits than 128 bits is not m.
    power.and_then(|power| power.checked_mul(n.into())) == Some(m.into())
}

impl Numbers {
    pub(crate) fn whole(values: Vec<i64>) -> Self {
        let powers = vec![0; values.len()];
        Self::Decimals(values, powers)
    }

    /// Doubles up to the first that is no number.
    pub(crate) fn doubles(mut values: Vec<f64>) -> (Self, Option<TraceError>) {
        let wrong = if all(&values, |x| x.is_finite()) {
            None
        } else {
            values.iter().find(|x| !x.is_finite())
        };
        let error = wrong.and_then(|x| double(*x).err());
        if error.is_some() {
            let whole = values.iter().take_while(|x| x.is_finite()).count();
            values.truncate(whole);
        }
        (Self::Doubles(values), error)
    }

    #[inline]
    pub(crate) const fn len(&self) -> usize {
        match self {
            Self::Decimals(numerators, _) => numerators.len(),
            Self::Doubles(values) => values.len(),
            Self::Any(values) => values.len(),
        }
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    #[inline]
    pub(crate) fn get(&self, i: usize) -> Option<Number> {
        match self {
            Self::Decimals(numerators, powers) => {
                Some(decimal(*numerators.get(i)?, *powers.get(i)?))
            }
            Self::Doubles(values) => Number::from_f64(*values.get(i)?),
            Self::Any(values) => values.get(i).cloned(),
        }
    }

    /// Whether two of them are the same.
    #[inline]
    pub(crate) fn is_same(&self, i: usize, j: usize) -> bool {
        match self {
            Self::Decimals(numerators, powers) if powers.get(i) == powers.get(j) => {
                numerators.get(i) == numerators.get(j)
            }
            Self::Decimals(numerators, powers) => {
                let at = |i: usize| numerators.get(i).copied().zip(powers.get(i).copied());
                match (at(i), at(j)) {
                    (Some(a), Some(b)) => is_same_decimal(a, b),
                    (a, b) => a == b,
                }
            }
            Self::Doubles(values) => values.get(i) == values.get(j),
            Self::Any(_) => self.get(i) == self.get(j),
        }
    }

    /// Marks which numbers from one on are the same as the next, by what is not zero.
    pub(crate) fn mark_same(&self, from: usize, marks: &mut [u64]) {
        if let Self::Doubles(values) = self {
            let pairs = values.get(from..).unwrap_or_default().windows(2);
            for (pair, mark) in pairs.zip(marks) {
                *mark = u64::from(matches!(pair, [x, next] if x == next));
            }
            return;
        }
        for (mark, i) in marks.iter_mut().zip(from..) {
            *mark = u64::from(self.is_same(i, i + 1));
        }
    }

    pub(crate) fn reserve(&mut self, rows: usize) {
        match self {
            Self::Decimals(numerators, powers) => {
                numerators.reserve(rows);
                powers.reserve(rows);
            }
            Self::Doubles(values) => values.reserve(rows),
            Self::Any(values) => values.reserve(rows),
        }
    }

    /// Appends n over 10^k.
    #[inline]
    pub(crate) fn push_decimal(&mut self, n: i64, k: u8) {
        match self {
            Self::Decimals(numerators, powers) => {
                numerators.push(n);
                powers.push(k);
            }
            Self::Doubles(_) | Self::Any(_) => self.any().push(decimal(n, k)),
        }
    }

    pub(crate) fn push(&mut self, x: Number) {
        if let (Self::Decimals(..), Number::Small(n, d)) = (&self, &x)
            && let Some(k) = d.checked_ilog10()
            && power_of_ten(k) == Some(*d)
            && let Ok(k) = u8::try_from(k)
        {
            return self.push_decimal(*n, k);
        }
        self.any().push(x);
    }

    /// The numbers as any are.
    fn any(&mut self) -> &mut Vec<Number> {
        if !matches!(self, Self::Any(_)) {
            *self = Self::Any((0..self.len()).filter_map(|i| self.get(i)).collect());
        }
        match self {
            Self::Any(values) => values,
            Self::Decimals(..) | Self::Doubles(_) => unreachable!("they were made any just now"),
        }
    }

    pub(crate) fn truncate(&mut self, len: usize) {
        match self {
            Self::Decimals(numerators, powers) => {
                numerators.truncate(len);
                powers.truncate(len);
            }
            Self::Doubles(values) => values.truncate(len),
            Self::Any(values) => values.truncate(len),
        }
    }

    pub(crate) fn append(&mut self, next: &mut Self) {
        if self.is_empty() {
            *self = std::mem::take(next);
            return;
        }
        match (&mut *self, &mut *next) {
            (Self::Decimals(numerators, powers), Self::Decimals(more, their)) => {
                numerators.append(more);
                powers.append(their);
            }
            (Self::Doubles(values), Self::Doubles(more)) => values.append(more),
            (_, next) => self.any().append(next.any()),
        }
    }

    /// Keeps the first `len`, and gives the others.
    pub(crate) fn split_off(&mut self, len: usize) -> Self {
        let len = len.min(self.len());
        match self {
            Self::Decimals(numerators, powers) => {
                Self::Decimals(numerators.split_off(len), powers.split_off(len))
            }
            Self::Doubles(values) => Self::Doubles(values.split_off(len)),
            Self::Any(values) => Self::Any(values.split_off(len)),
        }
    }
}

impl From<Vec<Number>> for Numbers {
    fn from(numbers: Vec<Number>) -> Self {
        let mut column = Self::default();
        column.reserve(numbers.len());
        numbers.into_iter().for_each(|x| column.push(x));
        column
    }
}

/// The number that a double is.
pub(crate) fn double(x: f64) -> Result<Number, TraceError> {
    Number::from_f64(x)
        .ok_or_else(|| TraceError::new("not_finite", format!("expected a number, found {x}")))
}

/// What the numbers of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Positions, in ticks.
    Position,
    /// Forces, in KΔ.
    Force,
}

/// A column of positions or forces: as they are written, to what scale, and where they are.
#[derive(Clone, Debug)]
pub(crate) struct Readings {
    pub(crate) written: Numbers,
    /// The balls of what [`get`](Self::get) gives.
    pub(crate) near: Balls,
    kind: Kind,
    scale: Scale,
}

impl Readings {
    pub(crate) fn new(kind: Kind, scale: &Scale) -> Self {
        Self {
            written: Numbers::default(),
            near: Balls::default(),
            kind,
            scale: scale.clone(),
        }
    }

    pub(crate) const fn len(&self) -> usize {
        self.written.len()
    }

    #[inline]
    pub(crate) fn get(&self, i: usize) -> Option<Reading> {
        // What was appended can be read.
        self.scale.read(self.kind, self.written.get(i)?).ok()
    }

    /// What is known of the number at `i`.
    #[inline]
    pub(crate) fn ball(&self, i: usize) -> Option<Ball> {
        let (middle, radius) = (self.near.middles.get(i)?, self.near.radii.get(i)?);
        Some(Ball::from_parts(*middle, *radius))
    }

    /// Whether [`get`](Self::get) gives enclosures.
    pub(crate) const fn encloses(&self) -> bool {
        self.scale.is_irrational()
    }

    /// Whether that is one.
    pub(crate) fn is_enclosed(&self, i: usize) -> bool {
        self.encloses() && self.ball(i).is_some_and(|ball| !ball.is_zero())
    }

    pub(crate) fn reserve(&mut self, rows: usize) {
        self.written.reserve(rows);
        self.near.middles.reserve(rows);
        self.near.radii.reserve(rows);
    }

    /// Appends n over 10^k, of which nothing is known before [`complete`](Self::complete).
    #[inline]
    pub(crate) fn push_decimal(&mut self, n: i64, k: u8) {
        self.written.push_decimal(n, k);
    }

    /// Finds out what is known of the numbers of which nothing was known; of the first that cannot be read, where it
    /// is and why.
    pub(crate) fn complete(&mut self) -> Result<(), (usize, TraceError)> {
        let Self {
            written,
            near,
            kind,
            scale,
        } = self;
        let (written, kind) = (&*written, *kind);
        let several = |from: usize, balls: (&mut [f64], &mut [f64])| {
            scale.near_several(kind, written, from, balls);
        };
        near.complete(written.len(), several, |i| {
            let quickly = match written {
                Numbers::Decimals(numerators, powers) => {
                    let decimal = numerators.get(i).zip(powers.get(i));
                    decimal.and_then(|(n, k)| scale.near_decimal(kind, *n, *k))
                }
                Numbers::Doubles(values) => values.get(i).and_then(|x| scale.near_double(kind, *x)),
                Numbers::Any(_) => None,
            };
            match quickly {
                Some(ball) => Ok(ball),
                None => {
                    let x = written.get(i).ok_or_else(undefined)?;
                    Ok(*scale.read(kind, x)?.to_near().lo())
                }
            }
        })
    }

    /// What is known of a number, for [`push`](Self::push).
    pub(crate) fn known(&self, x: Number) -> Result<(Number, Ball), TraceError> {
        let near = *self.scale.read(self.kind, x.clone())?.to_near().lo();
        Ok((x, near))
    }

    /// Appends a number of which this is known.
    pub(crate) fn push(&mut self, (x, near): (Number, Ball)) {
        self.written.push(x);
        self.near.push(near);
    }

    /// Appends numbers up to the first that cannot be read.
    pub(crate) fn push_all(&mut self, numbers: Numbers) -> Result<(), TraceError> {
        if self.len() == 0 {
            self.written = numbers;
            return self.complete().map_err(|(row, error)| {
                self.truncate(row);
                error
            });
        }
        self.reserve(numbers.len());
        for x in (0..numbers.len()).filter_map(|i| numbers.get(i)) {
            let known = self.known(x)?;
            self.push(known);
        }
        Ok(())
    }

    pub(crate) fn truncate(&mut self, len: usize) {
        self.written.truncate(len);
        self.near.truncate(len);
    }

    pub(crate) fn append(&mut self, next: &mut Self) {
        if self.len() == 0 {
            (self.kind, self.scale) = (next.kind, next.scale.clone());
        }
        self.written.append(&mut next.written);
        self.near.append(&mut next.near);
    }

    pub(crate) fn split_off(&mut self, len: usize) -> Self {
        Self {
            written: self.written.split_off(len),
            near: self.near.split_off(len),
            kind: self.kind,
            scale: self.scale.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn decimals_are_the_same_where_their_numbers_are(
            n in prop_oneof![any::<i64>(), -1000..1000_i64], k in 0..=27_u8, l in 0..=27_u8, tens in 0..19_u32, is_scaled: bool,
        ) {
            let m = if is_scaled { n.saturating_mul(10_i64.saturating_pow(tens)) } else { n / 10_i64.pow(tens) };
            let column = Numbers::Decimals(vec![n, m], vec![k, l]);
            prop_assert_eq!(column.is_same(0, 1), column.get(0) == column.get(1));
            let l = if is_scaled { k.saturating_add(tens as u8) } else { k.saturating_sub(tens as u8) };
            let column = Numbers::Decimals(vec![n, m], vec![k, l.min(27)]);
            prop_assert_eq!(column.is_same(0, 1), column.get(0) == column.get(1));
        }
    }
}
