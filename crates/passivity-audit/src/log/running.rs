//! A running sum and its least value so far.

use num_bigint::BigInt;
use num_integer::Integer as _;
use passivity_core::course::{Course, Least};
use passivity_core::{BigRational, Scalar};

use crate::number::{Number, Reduced};
use crate::reading::Reading;
use crate::span::ONE;
use crate::sum::Sum;

/// A running sum that starts at zero, and the least value it had, the start included.
#[derive(Clone, Debug)]
pub(crate) struct RunningSum {
    /// Over the common denominator; where that is given up, `at` goes on here, and the rest in `big`.
    course: Course<i128>,
    denominator: i128,
    steps: u64,
    /// Takes over, from what it holds, when machine integers no longer do.
    big: Option<Box<Big>>,
}

#[derive(Clone, Debug)]
struct Big {
    now: Sum,
    /// Near `now`, to tell cheaply when it is far above the least value.
    near: f64,
    least: BigRational,
    least_near: f64,
}

impl Default for RunningSum {
    fn default() -> Self {
        Self {
            course: Course::default(),
            denominator: 1,
            steps: 0,
            big: None,
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
        match self.big {
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
        if self.big.is_some() {
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

    /// Adds a step.
    pub(crate) fn add(&mut self, step: &Reduced) {
        if let Reduced::Small(n, d) = step
            && let Some(scaled) = self.scaled(*n, *d)
            && self.add_scaled(scaled)
        {
            return;
        }
        self.add_big(&step.to_rational());
    }

    fn add_big(&mut self, step: &BigRational) {
        let (
            Course {
                sum: now, least, ..
            },
            denominator,
        ) = (self.course, self.denominator);
        let big = self.big.get_or_insert_with(|| {
            let ratio = |n: i128| BigRational::new(n.into(), denominator.into());
            let mut sum = Sum::of_log();
            sum.add_rational(&ratio(now));
            Box::new(Big {
                near: near(&ratio(now)),
                now: sum,
                least_near: near(&ratio(least)),
                least: ratio(least),
            })
        });
        self.steps += 1;
        big.now.add_rational(step);
        big.near += near(step);
        if big.near < big.least_near + slack(big.near, big.least_near) {
            let now = big.now.value().lo().clone();
            big.near = near(&now);
            if now < big.least {
                big.least_near = big.near;
                big.least = now;
                self.course.at = self.steps;
            }
        }
    }

    /// The sum.
    pub(crate) fn total(&self) -> BigRational {
        match &self.big {
            None => BigRational::new(self.course.sum.into(), self.denominator.into()),
            Some(big) => big.now.value().lo().clone(),
        }
    }

    /// How many steps there were.
    pub(crate) const fn steps(&self) -> u64 {
        self.steps
    }

    /// A sum that was kept elsewhere: its total, its least value and after how many steps it was there.
    pub(crate) fn from_parts(total: &BigRational, least: (BigRational, u64), steps: u64) -> Self {
        let mut sum = Self::default();
        sum.add(&Reduced::from(total.clone()));
        sum.course.least = 0;
        sum.set_least(least.0);
        (sum.course.at, sum.steps) = (least.1, steps);
        sum
    }

    /// A denominator of all steps.
    pub(crate) fn common(&self) -> BigInt {
        match &self.big {
            None => self.denominator.into(),
            Some(big) => big.now.denominator(),
        }
    }

    /// A double near the sum.
    pub(crate) fn near(&self) -> f64 {
        match &self.big {
            #[allow(clippy::cast_precision_loss)]
            None => self.course.sum as f64 / self.denominator as f64,
            Some(big) => big.near,
        }
    }

    /// The least value, and after how many steps it was there.
    pub(crate) fn least(&self) -> (BigRational, u64) {
        let least = match &self.big {
            None => BigRational::new(self.course.least.into(), self.denominator.into()),
            Some(big) => big.least.clone(),
        };
        (least, self.course.at)
    }

    /// The course in exact fractions.
    fn exact(&self) -> Course<BigRational> {
        let ((least, at), sum) = (self.least(), self.total());
        Course { sum, least, at }
    }

    /// Goes on with another sum, which started at zero where this one ends.
    pub(crate) fn append(&mut self, other: &Self) {
        if self.stays_above(other) {
            let before = self.steps;
            self.add_big(&other.total());
            self.steps = before + other.steps;
            return;
        }
        let (mut both, before) = (self.exact(), self.steps);
        let (other, steps) = (other.exact(), other.steps);
        let is_lower = both.append(&other, before);
        self.add(&other.sum.into());
        if is_lower {
            self.course.at = both.at;
            match &mut self.big {
                Some(big) => {
                    big.least_near = near(&both.least);
                    big.least = both.least;
                }
                None => self.set_least(both.least),
            }
        }
        self.steps = before + steps;
    }

    /// Whether this sum of long fractions surely does not get to its least value by going on with another one:
    /// told by doubles, for reducing long fractions takes long.
    fn stays_above(&self, other: &Self) -> bool {
        let (Some(big), None) = (&self.big, &other.big) else {
            return false;
        };
        #[allow(clippy::cast_precision_loss)]
        let [least, total] =
            [other.course.least, other.course.sum].map(|n| n as f64 / other.denominator as f64);
        let lowest = big.near + f64::min(least, total);
        lowest > big.least_near + slack(big.near, big.least_near)
    }

    fn set_least(&mut self, lowest: BigRational) {
        let scaled = match Reduced::from(lowest.clone()) {
            Reduced::Small(n, d) => self.scaled(n, d),
            Reduced::Big(_) => None,
        };
        match scaled {
            Some(least) => self.course.least = least,
            None => {
                self.add_big(&BigRational::integer(0));
                if let Some(big) = &mut self.big {
                    big.least_near = near(&lowest);
                    big.least = lowest;
                }
            }
        }
    }
}

/// More than doubles near these sums are off: by 2⁻⁵³ a step, of which a billion are within this.
fn slack(a: f64, b: f64) -> f64 {
    1e-6 * (1.0 + a.abs().max(b.abs()))
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
    pub(crate) value: BigRational,
    /// After how many intervals.
    pub(crate) h: u64,
    near: f64,
}

impl Lowest {
    pub(crate) fn new(value: BigRational, h: u64) -> Self {
        let near = near(&value);
        Self { value, h, near }
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
        let mut least = Least(slot.clone().map(of));
        if found.is_some() && least.append(&Least(found.map(of)), &sum.total(), sum.steps()) {
            *slot = least.0.map(|(value, h)| Self::new(value, h));
        }
    }

    /// Keeps the sum and what stands beside it after `h` intervals, if that is lower; compared in
    /// doubles first.
    pub(crate) fn keep_sum(slot: &mut Option<Self>, sum: &RunningSum, beside: &Reduced, h: u64) {
        let now = sum.near() + beside.near();
        let slack = 1e-6 * (1.0 + now.abs() + sum.near().abs());
        if slot
            .as_ref()
            .is_some_and(|lowest| now > lowest.near + slack)
        {
            return;
        }
        Self::keep(slot, Self::new(sum.total() + beside.to_rational(), h));
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
