//! Whether a symmetric matrix is positive semidefinite, and where not a direction that shows it.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use num_rational::BigRational;

use crate::decision::Enclosed;
use crate::interval::Interval;
use crate::pi::Exact;
use crate::scalar::{Ordered, Scalar};

/// What a quadratic form dᵀAd does.
#[derive(Clone, Debug, PartialEq)]
pub enum Form<S> {
    /// It is never negative.
    Semidefinite,
    /// It is negative at this d.
    Negative(Vec<S>),
}

impl<S> Form<S> {
    /// The same in another kind of number; `None` when `f` gives up on one.
    fn try_map<U>(&self, f: impl Fn(&S) -> Option<U>) -> Option<Form<U>> {
        Some(match self {
            Self::Semidefinite => Form::Semidefinite,
            Self::Negative(d) => Form::Negative(d.iter().map(f).collect::<Option<_>>()?),
        })
    }

    /// Whether the form is never negative.
    #[must_use]
    pub const fn is_semidefinite(&self) -> bool {
        matches!(self, Self::Semidefinite)
    }
}

/// Decides dᵀAd ≥ 0 for all d by elimination (LDLᵀ), for a symmetric A given by rows; singular
/// matrices too (TH-NDOF). `None` when a number is undefined.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, definite::{self, Form}};
///
/// let rows = |b: i32| vec![vec![Fixed::integer(1), Fixed::integer(2)], vec![Fixed::integer(2), Fixed::integer(b)]];
/// assert_eq!(definite::decide(rows(4)), Some(Form::Semidefinite)); // singular
/// let Some(Form::Negative(d)) = definite::decide(rows(3)) else { panic!() };
/// assert_eq!(definite::quadratic(&rows(3), &d), Fixed::integer(-1));
/// ```
#[must_use]
pub fn decide<S: Ordered>(mut rows: Vec<Vec<S>>) -> Option<Form<S>> {
    // x_k = Σ_j m_j x_j over the later coordinates, for each coordinate k that is eliminated.
    let mut eliminated: Vec<Vec<S>> = Vec::new();
    while let Some(first) = rows.first().cloned() {
        let (pivot, others) = first.split_first()?;
        let multipliers = match pivot.sign()? {
            Ordering::Greater => {
                let multiplier = |x: &S| -(x.clone().over(pivot.clone()));
                others.iter().map(multiplier).collect()
            }
            Ordering::Less => return Some(lifted(unit(rows.len(), 0), &eliminated)),
            Ordering::Equal => {
                if let Some(d) = beside_zero(&rows, others)? {
                    return Some(lifted(d, &eliminated));
                }
                vec![S::zero(); others.len()]
            }
        };
        rows = reduced(&rows, others, &multipliers);
        eliminated.push(multipliers);
    }
    Some(Form::Semidefinite)
}

/// The least that the last diagonal entry of a symmetric matrix may be for dᵀAd ≥ 0, all others as they
/// are; `None` where no value is enough, or when a number is undefined.
#[must_use]
pub fn least_last<S: Ordered>(mut rows: Vec<Vec<S>>) -> Option<S> {
    let now = rows.last()?.last()?.clone();
    while let Some(first) = rows.first().cloned().filter(|_| rows.len() > 1) {
        let (pivot, others) = first.split_first()?;
        let multipliers = match pivot.sign()? {
            Ordering::Greater => {
                let multiplier = |x: &S| -(x.clone().over(pivot.clone()));
                others.iter().map(multiplier).collect()
            }
            Ordering::Equal if beside_zero(&rows, others)?.is_none() => {
                vec![S::zero(); others.len()]
            }
            _ => return None,
        };
        rows = reduced(&rows, others, &multipliers);
    }
    let left = rows.first()?.first()?.clone();
    Some(now - left)
}

/// dᵀAd.
#[must_use]
pub fn quadratic<S: Scalar>(rows: &[Vec<S>], d: &[S]) -> S {
    let row = |row: &Vec<S>| {
        let terms = row.iter().zip(d);
        terms.fold(S::zero(), |sum, (a, x)| {
            (sum + a.clone() * x.clone()).shortened()
        })
    };
    let terms = rows.iter().zip(d);
    terms.fold(S::zero(), |sum, (r, x)| {
        (sum + row(r) * x.clone()).shortened()
    })
}

fn unit<S: Scalar>(n: usize, at: usize) -> Vec<S> {
    (0..n)
        .map(|i| if i == at { S::one() } else { S::zero() })
        .collect()
}

/// Where the first diagonal entry is zero: a direction of value −1, if another entry of its row is
/// not zero. With t in the first place and 1 in place j the form is 2t·A₁ⱼ + Aⱼⱼ.
#[allow(clippy::option_option)]
fn beside_zero<S: Ordered>(rows: &[Vec<S>], others: &[S]) -> Option<Option<Vec<S>>> {
    for (j, (off, row)) in (1..).zip(others.iter().zip(rows.iter().skip(1))) {
        if off.sign()? == Ordering::Equal {
            continue;
        }
        let diagonal = row.get(j)?.clone();
        let mut d = unit(rows.len(), j);
        *d.first_mut()? = -(S::one() + diagonal).over(off.double());
        return Some(Some(d));
    }
    Some(None)
}

/// The matrix of the form once the first coordinate is the one that makes it least.
fn reduced<S: Scalar>(rows: &[Vec<S>], others: &[S], multipliers: &[S]) -> Vec<Vec<S>> {
    let rest = rows.iter().skip(1).zip(multipliers);
    let row = |(row, multiplier): (&Vec<S>, &S)| {
        let entries = row.iter().skip(1).zip(others);
        entries
            .map(|(a, other)| a.clone() + multiplier.clone() * other.clone())
            .collect()
    };
    rest.map(row).collect()
}

/// A direction in all coordinates from one in those that are left.
fn lifted<S: Scalar>(mut d: Vec<S>, eliminated: &[Vec<S>]) -> Form<S> {
    for multipliers in eliminated.iter().rev() {
        let terms = multipliers.iter().zip(&d);
        let x = terms.fold(S::zero(), |sum, (m, x)| sum + m.clone() * x.clone());
        d.insert(0, x);
    }
    Form::Negative(d)
}

/// The bits with which entries that have π in them are enclosed, one after the other.
const BITS: [u32; 3] = [48, 512, 4096];

/// Decides dᵀAd ≥ 0 for a matrix whose entries may have π in them.
///
/// Exactly where the entries are rational, or rational multiples of one diagonal entry; else by ever
/// tighter enclosures, so that `None` may also mean that the matrix is singular and has π in it.
#[must_use]
pub fn decide_enclosed<S: Enclosed>(rows: &[Vec<S>]) -> Option<Form<S>> {
    let mut scale = S::one();
    for (i, row) in rows.iter().enumerate() {
        let diagonal = row.get(i)?;
        match diagonal.sign()? {
            Ordering::Less => return Some(Form::Negative(unit(rows.len(), i))),
            Ordering::Equal => {}
            Ordering::Greater => scale = diagonal.clone(),
        }
    }
    let scaled = |x: &S| x.clone().over(scale.clone());
    let scaled: Vec<Vec<S>> = rows
        .iter()
        .map(|row| row.iter().map(scaled).collect())
        .collect();
    BITS.into_iter().find_map(|bits| enclosed(&scaled, bits))
}

/// The decision from enclosures of so many bits; `None` where they are too wide.
fn enclosed<S: Enclosed>(rows: &[Vec<S>], bits: u32) -> Option<Form<S>> {
    let mut ranges: Vec<Vec<Interval<BigRational>>> = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let range = |(j, x): (usize, &S)| match ranges.get(j) {
            // Below the diagonal stands what is above it.
            Some(above) => above.get(i).cloned(),
            None => match x.enclosed(bits)? {
                exact if exact.is_point() => Some(exact),
                // Long numbers take long.
                range => Some(range.shortened(bits)),
            },
        };
        let row: Option<Vec<_>> = row.iter().enumerate().map(range).collect();
        ranges.push(row?);
    }
    // By Gershgorin's circles every form of the enclosure is between those of these two matrices: its
    // middle, with what the entries of a row may be off by taken from the diagonal, or added to it.
    let (mut least, mut most) = (Vec::new(), Vec::new());
    for (i, row) in ranges.iter().enumerate() {
        let middle: Vec<_> = row.iter().map(Interval::middle).collect();
        let off: BigRational = row.iter().map(Interval::radius).sum();
        for (matrix, off) in [(&mut least, -off.clone()), (&mut most, off)] {
            let mut row = middle.clone();
            *row.get_mut(i)? += off;
            matrix.push(row);
        }
    }
    let Form::Negative(d) = decide(least)? else {
        return Some(Form::Semidefinite);
    };
    let is_negative = quadratic(&most, &d).sign()? == Ordering::Less;
    is_negative.then(|| Form::Negative(d).try_map(|x| S::of(&Exact::of(x))))?
}
