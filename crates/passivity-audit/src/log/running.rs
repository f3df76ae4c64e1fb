//! A running sum and its least value so far.

use std::cmp::Ordering;
use std::ops::Add;

use num_integer::Integer as _;
use passivity_core::course::{Course, Least};
use passivity_core::{BigRational, Ordered as _};

use crate::ball::Ball;
use crate::number::{Number, Reduced};
use crate::reading::Reading;
use crate::span::ONE;
use crate::sum::Sum;

/// A running sum that starts at zero, and the least value it had, the start included.
#[derive(Clone, Debug)]
pub(crate) struct RunningSum {
    /// Over the common denominator.
    course: Course<i128>,
    denominator: i128,
    steps: u64,
    /// Takes over, from what it holds, when machine integers no longer do.
    wide: Option<Box<Course<Total>>>,
}

/// A sum over the rows of a log, as the number at its lower end.
#[derive(Clone, Debug)]
struct Total(Sum);

impl Total {
    fn ratio(n: i128, d: i128) -> Self {
        Self(Sum::of_ratio(n, d))
    }

    fn value(&self) -> BigRational {
        self.0.value().lo().clone()
    }
}

impl From<&Reduced> for Total {
    fn from(x: &Reduced) -> Self {
        let mut sum = Sum::of_log();
        sum.add_reduced(x);
        Self(sum)
    }
}

impl Add for Total {
    type Output = Self;

    fn add(mut self, other: Self) -> Self {
        self.0.add_sum(&other.0);
        self
    }
}

impl PartialEq for Total {
    fn eq(&self, other: &Self) -> bool {
        self.0.compare(&other.0) == Ordering::Equal
    }
}

impl PartialOrd for Total {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.0.compare(&other.0))
    }
}

impl Default for RunningSum {
    fn default() -> Self {
        Self {
            course: Course::default(),
            denominator: 1,
            steps: 0,
            wide: None,
        }
    }
}

impl RunningSum {
    /// A sum of so many steps in units of the grid.
    pub(crate) fn of_grid(course: Course<i128>, steps: u64) -> Self {
        Self {
            course,
            steps,
            denominator: ONE,
            ..Self::default()
        }
    }

    /// The common denominator, as long as machine integers hold the sum.
    pub(crate) const fn denominator(&self) -> Option<i128> {
        match self.wide {
            None => Some(self.denominator),
            Some(_) => None,
        }
    }

    /// The sum over [`denominator`](Self::denominator).
    pub(crate) const fn now(&self) -> i128 {
        self.course.sum
    }

    /// n/d over the common denominator, which grows to hold it; `None` when it cannot.
    pub(crate) fn scaled(&mut self, n: i128, d: i128) -> Option<i128> {
        if self.wide.is_some() {
            return None;
        }
        if self.denominator == d {
            return Some(n);
        }
        if self.denominator % d != 0 {
            let divisor = self.denominator.unsigned_abs().gcd(&d.unsigned_abs());
            let factor = d / i128::try_from(divisor).ok()?;
            // Room is left for the sum to grow in: past 10¹² KΔ².
            let larger = self.denominator.checked_mul(factor)?;
            if larger > 1 << 84 {
                return None;
            }
            let sum = self.course.sum.checked_mul(factor)?;
            let least = self.course.least.checked_mul(factor)?;
            (self.course.sum, self.course.least, self.denominator) = (sum, least, larger);
        }
        n.checked_mul(self.denominator / d)
    }

    /// Adds a step that [`scaled`](Self::scaled) gave. False, and nothing added, on overflow.
    #[inline]
    pub(crate) fn add_scaled(&mut self, step: i128) -> bool {
        let Some(sum) = self.course.sum.checked_add(step) else {
            return false;
        };
        self.steps += 1;
        self.course.reach(sum, self.steps);
        true
    }

    /// Goes on with a course over the common denominator, of so many steps, where the sums have room.
    pub(crate) fn append_scaled(&mut self, course: &Course<i64>, steps: u64) {
        let wide = Course {
            sum: course.sum.into(),
            least: course.least.into(),
            at: course.at,
        };
        self.course.append(&wide, self.steps);
        self.steps += steps;
    }

    /// Adds a step.
    pub(crate) fn add(&mut self, step: &Reduced) {
        if let Reduced::Small(n, d) = step
            && let Some(scaled) = self.scaled(*n, *d)
            && self.add_scaled(scaled)
        {
            return;
        }
        self.steps += 1;
        let h = self.steps;
        self.widened().step(Total::from(step), h);
    }

    /// The course in numbers that hold any fraction.
    fn course(&self) -> Course<Total> {
        let total = |n: i128| Total::ratio(n, self.denominator);
        let course = &self.course;
        let narrow = || Course {
            sum: total(course.sum),
            least: total(course.least),
            at: course.at,
        };
        self.wide.as_deref().cloned().unwrap_or_else(narrow)
    }

    /// The same, from now on.
    fn widened(&mut self) -> &mut Course<Total> {
        let course = self.wide.take().unwrap_or_else(|| Box::new(self.course()));
        self.wide.insert(course)
    }

    /// The sum as it is.
    fn sum(&self) -> Total {
        match &self.wide {
            None => Total::ratio(self.course.sum, self.denominator),
            Some(wide) => wide.sum.clone(),
        }
    }

    /// The sum.
    pub(crate) fn total(&self) -> BigRational {
        self.sum().value()
    }

    /// How many steps there were.
    pub(crate) const fn steps(&self) -> u64 {
        self.steps
    }

    /// A sum that was kept elsewhere: its total, its least value and after how many steps it was there.
    pub(crate) fn from_parts(total: BigRational, least: (BigRational, u64), steps: u64) -> Self {
        let mut sum = Self::default();
        let (total, lowest) = (Reduced::from(total), Reduced::from(least.0));
        let course = sum.narrow([&total, &lowest], least.1);
        match course {
            Some(course) => sum.course = course,
            None => {
                *sum.widened() = Course {
                    sum: Total::from(&total),
                    least: Total::from(&lowest),
                    at: least.1,
                }
            }
        }
        sum.steps = steps;
        sum
    }

    /// A course with this sum and its least value over the common denominator, which grows to hold both; `None` when
    /// it cannot.
    fn narrow(&mut self, ends: [&Reduced; 2], at: u64) -> Option<Course<i128>> {
        let [Reduced::Small(n, d), Reduced::Small(m, e)] = ends else {
            return None;
        };
        self.scaled(0, *d)?;
        let (least, sum) = (self.scaled(*m, *e)?, self.scaled(*n, *d)?);
        Some(Course { sum, least, at })
    }

    /// A double near the sum.
    pub(crate) fn near(&self) -> f64 {
        let exactly = || near(&self.total());
        self.bounds().near().unwrap_or_else(exactly)
    }

    fn bounds(&self) -> Ball {
        match &self.wide {
            None => Ball::wide_ratio(self.course.sum, self.denominator),
            Some(wide) => wide.sum.0.near(),
        }
    }

    /// The least value, and after how many steps it was there.
    pub(crate) fn least(&self) -> (BigRational, u64) {
        let Course { least, at, .. } = self.course();
        (least.value(), at)
    }

    /// Goes on with another sum, which started at zero where this one ends.
    pub(crate) fn append(&mut self, other: &Self) {
        match self.next(other) {
            Some(course) => self.course = course,
            None => {
                let before = self.steps;
                self.widened().append(&other.course(), before);
            }
        }
        self.steps += other.steps;
    }

    /// The course with another sum that follows, where machine integers hold it.
    fn next(&mut self, other: &Self) -> Option<Course<i128>> {
        let (None, None, d) = (&self.wide, &other.wide, other.denominator) else {
            return None;
        };
        let reduced = |n: i128| Reduced::from(BigRational::new(n.into(), d.into()));
        let ends = [reduced(other.course.sum), reduced(other.course.least)];
        let next = self.narrow(ends.each_ref(), other.course.at)?;
        let mut course = self.course;
        course.sum.checked_add(next.sum)?;
        course.sum.checked_add(next.least)?;
        course.append(&next, self.steps);
        Some(course)
    }
}

/// The nearest double.
pub(crate) fn near(x: &BigRational) -> f64 {
    passivity_scene::number::nearest_f64(x)
}

/// The double nearest to a number.
pub(crate) fn near_number(x: &Number) -> f64 {
    /// Up to here whole numbers are doubles, so that one division rounds once.
    const EXACT: u64 = 1 << 53;
    match x {
        #[allow(clippy::cast_precision_loss)] // none is lost
        Number::Small(n, d) if n.unsigned_abs().max(d.unsigned_abs()) < EXACT => {
            *n as f64 / *d as f64
        }
        x => near(&x.to_rational()),
    }
}

/// The double nearest to the middle of what is known of a number.
pub(crate) fn near_reading(x: &Reading) -> f64 {
    let near_middle = || near(&x.to_rational().middle());
    match x {
        Reading::Exact(x) => near_number(x),
        Reading::Within(x) => x.near().unwrap_or_else(near_middle),
        // Of few bits, a tick has a middle that is a double.
        Reading::Count(n) => match i32::try_from(*n) {
            Ok(n) => f64::from(n) + 0.5,
            Err(_) => near_middle(),
        },
    }
}

/// Where an energy was lowest.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Lowest {
    value: Total,
    /// After how many intervals.
    pub(crate) h: u64,
}

impl Lowest {
    pub(crate) fn new(value: BigRational, h: u64) -> Self {
        let value = Total::from(&Reduced::from(value));
        Self { value, h }
    }

    /// In units of the grid.
    pub(crate) fn of_grid(n: i128, h: u64) -> Self {
        let value = Total::ratio(n, ONE);
        Self { value, h }
    }

    pub(crate) fn value(&self) -> BigRational {
        self.value.value()
    }

    /// A number that it is not above; not a number where none is known near by.
    pub(crate) fn above(&self) -> f64 {
        let (middle, radius) = self.value.0.near().parts();
        middle + radius
    }

    /// Keeps the lower one of two, the earlier where they agree.
    pub(crate) fn keep(slot: &mut Option<Self>, found: Self) {
        let mut least = Least(slot.as_ref().map(|lowest| (&lowest.value, lowest.h)));
        if least.keep(&found.value, found.h) {
            *slot = Some(found);
        }
    }

    /// Goes on with what follows so many steps and counts from their sum.
    pub(crate) fn append(slot: &mut Option<Self>, found: Option<Self>, sum: &RunningSum) {
        let of = |lowest: Self| (lowest.value, lowest.h);
        let mut least = Least(slot.take().map(of));
        least.append(&Least(found.map(of)), &sum.sum(), sum.steps());
        *slot = least.0.map(|(value, h)| Self { value, h });
    }

    /// Whether what was kept is surely below a number.
    fn is_surely_below(slot: Option<&Self>, x: Ball) -> bool {
        slot.is_some_and(|lowest| (x - lowest.value.0.near()).sign() == Some(Ordering::Greater))
    }

    /// Whether it is surely below a sum, so that nothing is kept of that and of anything beside it that is not negative.
    pub(crate) fn is_below_sum(slot: Option<&Self>, sum: &RunningSum) -> bool {
        Self::is_surely_below(slot, sum.bounds())
    }

    /// Keeps the sum and what stands beside it after `h` intervals, if that is lower; compared in
    /// doubles first.
    pub(crate) fn keep_sum(slot: &mut Option<Self>, sum: &RunningSum, beside: &Reduced, h: u64) {
        let beside_near = match beside {
            Reduced::Small(n, d) => Ball::wide_ratio(*n, *d),
            Reduced::Big(x) => Ball::of_rational(x),
        };
        if !Self::is_surely_below(slot.as_ref(), sum.bounds() + beside_near) {
            let value = sum.sum() + Total::from(beside);
            Self::keep(slot, Self { value, h });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn ratio(n: i128, d: i128) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    proptest! {
        #[test]
        fn is_the_sum_and_its_least_value(
            steps in prop::collection::vec((-50..50_i128, 1..40_i128), 0..60),
            cut in 0..60_usize,
            wide: bool,
        ) {
            let scale = if wide { i128::MAX / 1000 } else { 1 };
            let (mut now, mut least, mut at) = (ratio(0, 1), ratio(0, 1), 0);
            let (mut first, mut second) = (RunningSum::default(), RunningSum::default());
            for (i, (n, d)) in steps.iter().enumerate() {
                let step = ratio(n * scale, *d);
                now += &step;
                if now < least {
                    least = now.clone();
                    at = i as u64 + 1;
                }
                let part = if i < cut { &mut first } else { &mut second };
                part.add(&step.into());
            }
            first.append(&second);
            prop_assert_eq!(first.total(), now);
            prop_assert_eq!(first.least(), (least, at));
        }
    }
}
