//! Whether a polynomial is negative anywhere in an interval, decided exactly, with a certificate.
//!
//! Sturm's theorem counts the roots of a polynomial in an interval by signs at its two ends. Roots
//! of even multiplicity, which do not change the sign, are divided out first: P = S·M² where S has
//! simple roots only. Then P ≥ 0 on [a, b] exactly when S has no root between a and b and is
//! positive in the middle. This decides TH-LTI at every frequency at once.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One as _;

use crate::interval::Interval;
use crate::polynomial::Polynomial;

/// Whether a polynomial is negative anywhere in an interval, and what shows it.
#[derive(Clone, Debug, PartialEq)]
pub enum SignOver {
    /// It is nowhere negative.
    Nonnegative(Certificate),
    /// It is negative here.
    NegativeAt(BigRational),
}

impl SignOver {
    /// Whether the polynomial is nowhere negative.
    #[must_use]
    pub const fn is_nonnegative(&self) -> bool {
        matches!(self, Self::Nonnegative(_))
    }
}

/// What shows that a polynomial P is nowhere negative in an interval [a, b].
///
/// It can be checked with polynomial multiplication, division and signs alone:
/// [`shows`](Self::shows).
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// S, of simple roots only, with P = S·M².
    pub simple: Polynomial,
    /// M.
    pub repeated: Polynomial,
    /// Sturm's sequence of S: S, S′, and from then on minus the remainder of the two before, each
    /// up to a positive factor; the last one is a number other than zero.
    pub sequence: Vec<Polynomial>,
    /// How often the sign changes along the sequence at a and at b, zeros left out.
    pub sign_changes: [usize; 2],
}

impl Certificate {
    /// Checks the certificate: that P = S·M², that the sequence is Sturm's, that its sign changes
    /// are as said and leave no root of S between the ends, and that S is positive in the middle.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{BigRational, Interval, Scalar, polynomial::Polynomial, sturm};
    ///
    /// let interval = Interval::hull(BigRational::integer(-1), BigRational::integer(1));
    /// let square = Polynomial::new([1, -2, 1].map(BigRational::integer)); // (1 − x)²
    /// let sturm::SignOver::Nonnegative(certificate) = sturm::sign_over(&square, &interval) else {
    ///     panic!("a square is not negative")
    /// };
    /// assert!(certificate.shows(&square, &interval));
    /// assert!(!certificate.shows(&square.scaled(&BigRational::integer(-1)), &interval));
    /// ```
    #[must_use]
    pub fn shows(&self, polynomial: &Polynomial, interval: &Interval<BigRational>) -> bool {
        let product = &self.simple * &(&self.repeated * &self.repeated);
        if product != *polynomial {
            return false;
        }
        if polynomial.is_zero() {
            return true;
        }
        let changes = [interval.lo(), interval.hi()].map(|x| sign_changes(&self.sequence, x));
        is_sturm_sequence(&self.sequence, &self.simple)
            && changes == self.sign_changes
            && roots_inside(&self.simple, changes, interval) == Some(0)
            && self.simple.sign_at(&interval.middle()) == Ordering::Greater
    }
}

/// Decides whether a polynomial is nowhere negative in a closed interval of more than one point.
///
/// "Nonnegative" is said exactly where the certificate passes its own check.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Interval, Scalar, polynomial::Polynomial, sturm};
///
/// let interval = Interval::hull(BigRational::integer(-1), BigRational::integer(1));
/// // 1 − x² is zero at both ends and positive between them; less 1/1000 it is negative somewhere.
/// let arch = Polynomial::new([1, 0, -1].map(BigRational::integer));
/// assert!(sturm::sign_over(&arch, &interval).is_nonnegative());
/// let lowered = &arch - &Polynomial::constant(BigRational::new(1.into(), 1000.into()));
/// assert!(!sturm::sign_over(&lowered, &interval).is_nonnegative());
/// ```
#[must_use]
pub fn sign_over(polynomial: &Polynomial, interval: &Interval<BigRational>) -> SignOver {
    let [simple, repeated] = split(polynomial);
    let sequence = sturm_sequence(&simple);
    let sign_changes = [interval.lo(), interval.hi()].map(|x| sign_changes(&sequence, x));
    let certificate = Certificate {
        simple,
        repeated,
        sequence,
        sign_changes,
    };
    if certificate.shows(polynomial, interval) {
        return SignOver::Nonnegative(certificate);
    }
    // Between two neighbouring roots the sign is that of any one point, and one of these points
    // is below zero now.
    let pieces = between_roots(&isolated_roots(polynomial, interval), interval);
    let negative = pieces
        .into_iter()
        .find(|x| polynomial.sign_at(x) == Ordering::Less);
    SignOver::NegativeAt(negative.unwrap_or_else(|| interval.middle()))
}

/// Whether the polynomial has a root in the closed interval; true of the polynomial zero.
#[must_use]
pub fn has_root(polynomial: &Polynomial, interval: &Interval<BigRational>) -> bool {
    polynomial.is_zero() || !isolated_roots(polynomial, interval).is_empty()
}

/// Where in an interval a polynomial is zero or below, as closed intervals from left to right that
/// are too wide by at most `width` at either end.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Interval, Scalar, polynomial::Polynomial, sturm};
///
/// let number = BigRational::integer;
/// let interval = Interval::hull(number(-1), number(1));
/// let parabola = Polynomial::new([number(-1).half().half(), number(0), number(1)]); // x² − ¼
/// let half = number(1).half();
/// let where_not_above = sturm::not_positive(&parabola, &interval, &half);
/// assert_eq!(where_not_above, [Interval::hull(-half.clone(), half)]);
/// ```
#[must_use]
pub fn not_positive(
    polynomial: &Polynomial,
    interval: &Interval<BigRational>,
    width: &BigRational,
) -> Vec<Interval<BigRational>> {
    if polynomial.is_zero() {
        return Vec::from([interval.clone()]);
    }
    let mut roots = isolated_roots(polynomial, interval);
    let square_free = square_free(polynomial);
    for root in &mut roots {
        while *width < root.hi() - root.lo() {
            *root = halved(&square_free, root);
        }
    }
    let pieces = between_roots(&roots, interval);
    let negative = |x: &BigRational| polynomial.sign_at(x) == Ordering::Less;
    let mut found: Vec<Interval<BigRational>> = Vec::new();
    let mut open = pieces
        .first()
        .is_some_and(negative)
        .then(|| interval.lo().clone());
    for (root, after) in roots.iter().zip(pieces.iter().skip(1)) {
        let from = open.take().unwrap_or_else(|| root.lo().clone());
        if negative(after) {
            open = Some(from);
        } else {
            found.push(Interval::hull(from, root.hi().clone()));
        }
    }
    if let Some(from) = open {
        found.push(Interval::hull(from, interval.hi().clone()));
    }
    found
}

/// P as S·M², where S has simple roots only: [S, M].
///
/// By Yun's decomposition into the factors of each multiplicity; S is the product of those of odd
/// multiplicity.
fn split(polynomial: &Polynomial) -> [Polynomial; 2] {
    let one = Polynomial::constant(BigRational::one());
    let mut repeated = one.clone();
    let slope = polynomial.derivative();
    let shared = polynomial.common_divisor(&slope);
    let exactly = |a: &Polynomial, b: &Polynomial| a.divided_by(b).map(|(quotient, _)| quotient);
    let (Some(mut rest), Some(c)) = (exactly(polynomial, &shared), exactly(&slope, &shared)) else {
        return [polynomial.clone(), repeated]; // Zero.
    };
    let mut difference = &c - &rest.derivative();
    let mut multiplicity = 1_u32;
    while rest.degree().is_some_and(|degree| degree > 0) {
        let factor = rest.common_divisor(&difference);
        for _ in 0..multiplicity / 2 {
            repeated = &repeated * &factor;
        }
        let (Some(fewer), Some(c)) = (exactly(&rest, &factor), exactly(&difference, &factor))
        else {
            break; // A greatest common divisor of a polynomial other than zero is not zero.
        };
        difference = &c - &fewer.derivative();
        rest = fewer;
        multiplicity += 1;
    }
    // Whatever the factors are, S is what M² leaves: `shows` multiplies it out again.
    match exactly(polynomial, &(&repeated * &repeated)) {
        Some(simple) => [simple, repeated],
        None => [polynomial.clone(), one],
    }
}

/// The polynomial with every root made simple.
fn square_free(polynomial: &Polynomial) -> Polynomial {
    let shared = polynomial.common_divisor(&polynomial.derivative());
    match polynomial.divided_by(&shared) {
        Some((quotient, _)) => quotient.primitive(),
        None => polynomial.clone(),
    }
}

/// Sturm's sequence, each member a positive multiple of the textbook's.
fn sturm_sequence(polynomial: &Polynomial) -> Vec<Polynomial> {
    let minus_one = -BigRational::one();
    let mut sequence = Vec::new();
    let (mut a, mut b) = (polynomial.primitive(), polynomial.derivative().primitive());
    while !a.is_zero() {
        let rest = a.remainder(&b).scaled(&minus_one);
        sequence.push(core::mem::replace(&mut a, core::mem::replace(&mut b, rest)));
    }
    sequence
}

/// Whether the sequence is Sturm's of a polynomial with simple roots, up to positive factors.
fn is_sturm_sequence(sequence: &[Polynomial], polynomial: &Polynomial) -> bool {
    let same = |a: Option<&Polynomial>, b: &Polynomial| match a {
        Some(a) => a.primitive() == b.primitive(),
        None => b.is_zero(),
    };
    let minus_one = -BigRational::one();
    let follows = |triple: &[Polynomial]| match triple {
        [a, b, c] => same(Some(c), &a.remainder(b).scaled(&minus_one)),
        _ => false,
    };
    same(sequence.first(), polynomial)
        && same(sequence.get(1), &polynomial.derivative())
        && sequence.windows(3).all(follows)
        && sequence.last().and_then(Polynomial::degree) == Some(0)
}

/// How often the sign changes along the sequence at x, zeros left out.
fn sign_changes(sequence: &[Polynomial], x: &BigRational) -> usize {
    let signs = sequence.iter().map(|p| p.sign_at(x));
    let signs: Vec<_> = signs.filter(|sign| *sign != Ordering::Equal).collect();
    signs
        .windows(2)
        .filter(|pair| pair.first() != pair.last())
        .count()
}

/// How many simple roots lie strictly between the ends, by the sign changes at the ends.
///
/// Sturm's count is that of the roots in (a, b], whether or not a is a root.
fn roots_inside(
    simple: &Polynomial,
    [at_lo, at_hi]: [usize; 2],
    interval: &Interval<BigRational>,
) -> Option<usize> {
    let at_end = usize::from(simple.sign_at(interval.hi()) == Ordering::Equal);
    at_lo.checked_sub(at_hi)?.checked_sub(at_end)
}

/// Disjoint enclosures, from left to right, of one distinct root each in a closed interval: a point
/// where the root was met, else an interval whose ends are no roots.
fn isolated_roots(
    polynomial: &Polynomial,
    interval: &Interval<BigRational>,
) -> Vec<Interval<BigRational>> {
    let square_free = square_free(polynomial);
    let sequence = sturm_sequence(&square_free);
    let is_root = |x: &BigRational| square_free.sign_at(x) == Ordering::Equal;
    let mut found = Vec::new();
    if is_root(interval.lo()) {
        found.push(Interval::point(interval.lo().clone()));
    }
    // Half-open pieces (lo, hi], the leftmost on top.
    let mut pieces = Vec::from([interval.clone()]);
    while let Some(piece) = pieces.pop() {
        let changes = [piece.lo(), piece.hi()].map(|x| sign_changes(&sequence, x));
        let [at_lo, at_hi] = changes;
        match at_lo.saturating_sub(at_hi) {
            0 => {}
            1 if is_root(piece.hi()) => found.push(Interval::point(piece.hi().clone())),
            1 if !is_root(piece.lo()) => found.push(piece),
            _ => {
                let middle = piece.middle();
                pieces.push(Interval::hull(middle.clone(), piece.hi().clone()));
                pieces.push(Interval::hull(piece.lo().clone(), middle));
            }
        }
    }
    found
}

/// The half of an enclosure of one simple root that holds the root, or the middle where that is the
/// root.
fn halved(square_free: &Polynomial, root: &Interval<BigRational>) -> Interval<BigRational> {
    let middle = root.middle();
    match square_free.sign_at(&middle) {
        Ordering::Equal => Interval::point(middle),
        // The sign changes at the root and nowhere else.
        sign if sign == square_free.sign_at(root.lo()) => Interval::hull(middle, root.hi().clone()),
        _ => Interval::hull(root.lo().clone(), middle),
    }
}

/// A point before, between and after the roots of an interval, one more than there are roots; at
/// the ends of the interval it may be a root itself.
fn between_roots(
    roots: &[Interval<BigRational>],
    interval: &Interval<BigRational>,
) -> Vec<BigRational> {
    let from = core::iter::once(interval.lo()).chain(roots.iter().map(Interval::hi));
    let to = roots.iter().map(Interval::lo).chain([interval.hi()]);
    from.zip(to)
        .map(|(a, b)| (a + b) / BigInt::from(2))
        .collect()
}
