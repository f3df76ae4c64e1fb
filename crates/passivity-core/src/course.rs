//! What is kept of a stretch of consecutive intervals, and what two stretches make together (TH-MERGE).
//!
//! A log is accounted for in pieces, on as many machines as there are. A piece keeps the sum of what its
//! intervals add, with the least value that the sum had on the way ([`Course`]), the least of other energies
//! ([`Least`]), the first interval of a kind ([`First`]), and what its last interval hands on ([`Last`]); and
//! `append` makes of those of two stretches, one after the other, those of both. It is associative, an empty
//! stretch changes nothing, and what is made of the pieces is what one pass over all intervals finds: so the
//! account does not depend on where a log was cut, nor on which pieces were joined first.
//!
//! The numbers are exact and in order, and their sums are: integers that do not overflow, fractions. Intervals
//! are counted within their own stretch.

use core::ops::Add;

/// The sum of the steps of a stretch, and the least value that it had, its start at zero included.
///
/// # Example
///
/// ```
/// use passivity_core::course::Course;
///
/// let of = |steps: &[i32]| {
///     let mut course = Course::default();
///     (1..).zip(steps).for_each(|(h, step)| course.step(*step, h));
///     course
/// };
/// let (mut first, second, both) = (of(&[3, -5]), of(&[1, -4, 9]), of(&[3, -5, 1, -4, 9]));
/// assert_eq!((both.sum, both.least, both.at), (4, -5, 4));
/// assert!(first.append(&second, 2)); // the second stretch has the least value
/// assert_eq!(first, both);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Course<T> {
    /// The sum of all steps.
    pub sum: T,
    /// The least value that it had.
    pub least: T,
    /// After how many steps it first had it.
    pub at: u64,
}

impl<T: Clone + PartialOrd + Add<Output = T>> Course<T> {
    /// Goes on with the step `h`, counted from 1.
    #[inline]
    pub fn step(&mut self, step: T, h: u64) {
        self.reach(self.sum.clone() + step, h);
    }

    /// Goes on to the value that the sum has after `h` steps.
    #[inline]
    pub fn reach(&mut self, sum: T, h: u64) {
        if sum < self.least {
            self.least = sum.clone();
            self.at = h;
        }
        self.sum = sum;
    }

    /// Goes on with the stretch that follows these `steps`; whether it has the least value now.
    pub fn append(&mut self, other: &Self, steps: u64) -> bool {
        let lowest = self.sum.clone() + other.least.clone();
        let is_lower = lowest < self.least;
        if is_lower {
            self.least = lowest;
            self.at = steps + other.at;
        }
        self.sum = self.sum.clone() + other.sum.clone();
        is_lower
    }
}

/// The least of some energies, and the interval where it first was; none where there is none.
///
/// # Example
///
/// ```
/// use passivity_core::course::Least;
///
/// let mut least = Least::default();
/// assert!(least.keep(3, 1));
/// assert!(!least.keep(3, 2)); // the first one stays
/// // In what follows two intervals whose sum is −4, the same energies count from there.
/// assert!(least.append(&Least(Some((1, 5))), &-4, 2));
/// assert_eq!(least, Least(Some((-3, 7))));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Least<T>(pub Option<(T, u64)>);

impl<T> Default for Least<T> {
    fn default() -> Self {
        Self(None)
    }
}

impl<T: PartialOrd> Least<T> {
    /// Keeps the energy of the interval `h`, which comes after all before; whether it is the least now.
    #[inline]
    pub fn keep(&mut self, value: T, h: u64) -> bool {
        let is_lower = match &self.0 {
            None => true,
            Some((least, _)) => value < *least,
        };
        if is_lower {
            self.0 = Some((value, h));
        }
        is_lower
    }
}

impl<T: Clone + PartialOrd + Add<Output = T>> Least<T> {
    /// Goes on with the stretch that follows these `steps`, whose energies count from `sum`; whether its own
    /// is the least now.
    pub fn append(&mut self, other: &Self, sum: &T, steps: u64) -> bool {
        match &other.0 {
            None => false,
            Some((value, h)) => self.keep(sum.clone() + value.clone(), steps + h),
        }
    }
}

/// The first interval of a kind; none where there is none.
///
/// # Example
///
/// ```
/// use passivity_core::course::First;
///
/// let mut first = First(None);
/// assert!(first.append(First(Some(3)), 10));
/// assert!(!first.keep(20));
/// assert_eq!(first, First(Some(13)));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct First(pub Option<u64>);

impl First {
    /// Takes note of an interval of the kind; whether it is the first one now.
    #[inline]
    pub fn keep(&mut self, h: u64) -> bool {
        let is_first = self.0.is_none_or(|first| h < first);
        if is_first {
            self.0 = Some(h);
        }
        is_first
    }

    /// Goes on with the stretch that follows these `steps`; whether its own is the first one now.
    pub fn append(&mut self, other: Self, steps: u64) -> bool {
        other.0.is_some_and(|h| self.keep(steps + h))
    }
}

/// What the last interval of a stretch hands on to the next; none of a stretch that has none.
///
/// # Example
///
/// ```
/// use passivity_core::course::Last;
///
/// let mut last = Last(Some("force"));
/// last.append(Last(None));
/// assert_eq!(last, Last(Some("force")));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Last<T>(pub Option<T>);

impl<T> Last<T> {
    /// Goes on with the stretch that follows.
    pub fn append(&mut self, other: Self) {
        if other.0.is_some() {
            self.0 = other.0;
        }
    }
}
