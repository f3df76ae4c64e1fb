//! TH-MERGE: the account of two stretches, one after the other, is made of those of each.
//!
//! One step of the induction, for any two accounts whatever: a step after they were joined is that step in the
//! second before they are. And some short stretches as a whole.

use passivity_core::course::{Course, First, Last, Least};

/// Energies in [−4, 4), 3 bits: less than, equal to and more than each other, with sums of both signs.
const ENERGY: i8 = 4;

/// Places within a stretch below this: different ones.
const PLACES: u8 = 2;

/// Steps of the stretches that are run through as a whole are in [−2, 2): up, down and none.
const STEP: i8 = 2;

/// Of so many intervals, cut at any of them: one piece may be empty.
const INTERVALS: usize = 3;

/// Past every place within a stretch.
const LATER: u64 = 8;

fn energy() -> i32 {
    i32::from(kani::any_where(|n: &i8| *n >= -ENERGY && *n < ENERGY))
}

fn place() -> u64 {
    u64::from(kani::any_where(|h: &u8| *h < PLACES))
}

fn course() -> Course<i32> {
    Course {
        sum: energy(),
        least: energy(),
        at: place(),
    }
}

fn least() -> Least<i32> {
    Least(kani::any::<bool>().then(|| (energy(), place())))
}

fn first() -> First {
    First(kani::any::<bool>().then(place))
}

fn joined(a: &Course<i32>, steps: u64, b: &Course<i32>) -> Course<i32> {
    let mut both = *a;
    both.append(b, steps);
    both
}

/// TH-MERGE: a step after two stretches is a step after the second of them.
#[kani::proof]
fn th_merge_a_step_after_both_is_a_step_after_the_second() {
    let (a, b, step, steps) = (course(), course(), energy(), place());
    let mut after = joined(&a, steps, &b);
    after.step(step, steps + LATER);
    let mut second = b;
    second.step(step, LATER);
    kani::cover!(after.at == steps + LATER, "the step is the lowest");
    kani::cover!(
        after.at == a.at && second.at == LATER && after.least < second.least,
        "the first stretch was lower"
    );
    kani::assert(
        after == joined(&a, steps, &second),
        "TH-MERGE: a step after both is a step after the second",
    );
}

/// TH-MERGE: it does not matter which stretches are joined first.
#[kani::proof]
fn th_merge_courses_are_associative() {
    let (a, b, c) = (course(), course(), course());
    let (first, second) = (1, 2);
    let from_the_left = joined(&joined(&a, first, &b), first + second, &c);
    let from_the_right = joined(&a, first, &joined(&b, second, &c));
    kani::cover!(
        from_the_left.least < a.least && from_the_left.at == first + second + c.at,
        "the third is lowest"
    );
    kani::assert(
        from_the_left == from_the_right,
        "TH-MERGE: joining courses is associative",
    );
}

/// TH-MERGE: the same of the least of other energies, which count from the sum before.
#[kani::proof]
fn th_merge_least_energies_are_associative() {
    let (a, b, c) = (least(), least(), least());
    let (sum, more) = (energy(), energy());
    let (first, second) = (1, 2);
    let mut from_the_left = a;
    from_the_left.append(&b, &sum, first);
    from_the_left.append(&c, &(sum + more), first + second);
    let mut last = b;
    let is_from_the_third = last.append(&c, &more, second);
    let mut from_the_right = a;
    let is_from_a_later_one = from_the_right.append(&last, &sum, first);
    kani::cover!(
        is_from_the_third && is_from_a_later_one && a.0.is_some(),
        "the third is lowest"
    );
    kani::assert(
        from_the_left == from_the_right,
        "TH-MERGE: joining least energies is associative",
    );
}

/// TH-MERGE: the same of the first interval of a kind.
#[kani::proof]
fn th_merge_first_intervals_are_associative() {
    let (a, b, c) = (first(), first(), first());
    let (steps, more) = (place(), place());
    let mut from_the_left = a;
    from_the_left.append(b, steps);
    from_the_left.append(c, steps + more);
    let mut last = b;
    last.append(c, more);
    let mut from_the_right = a;
    let is_later = from_the_right.append(last, steps);
    kani::cover!(is_later && b.0.is_none(), "only the third has one");
    kani::assert(
        from_the_left == from_the_right,
        "TH-MERGE: joining first intervals is associative",
    );
}

/// All that a stretch keeps.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Account {
    steps: u64,
    course: Course<i32>,
    least: Least<i32>,
    first: First,
    last: Last<i32>,
}

const EMPTY: Account = Account {
    steps: 0,
    course: Course {
        sum: 0,
        least: 0,
        at: 0,
    },
    least: Least(None),
    first: First(None),
    last: Last(None),
};

/// What an interval adds to the sum, and what stands beside the sum where it ends: no more than that tells
/// whether it is of the kind, and hands something on.
type Interval = (i32, i32);

impl Account {
    fn enter(&mut self, (step, beside): Interval) {
        self.steps += 1;
        self.course.step(step, self.steps);
        self.least.keep(self.course.sum + beside, self.steps);
        if beside > 0 {
            self.first.keep(self.steps);
            self.last.append(Last(Some(step)));
        }
    }

    fn append(&mut self, other: Self) {
        self.least
            .append(&other.least, &self.course.sum, self.steps);
        self.course.append(&other.course, self.steps);
        self.first.append(other.first, self.steps);
        self.last.append(other.last);
        self.steps += other.steps;
    }
}

/// TH-MERGE: the accounts of two stretches make that of both, wherever the cut is.
#[kani::proof]
#[kani::unwind(4)]
fn th_merge_two_stretches_are_the_whole() {
    let mut intervals = [(0, 0); INTERVALS];
    for interval in &mut intervals {
        let step = kani::any_where(|n: &i8| *n >= -STEP && *n < STEP);
        *interval = (i32::from(step), i32::from(kani::any::<bool>()));
    }
    let cut = kani::any_where(|n: &u8| usize::from(*n) <= INTERVALS);
    let (mut whole, mut first, mut second) = (EMPTY, EMPTY, EMPTY);
    for (i, interval) in intervals.into_iter().enumerate() {
        whole.enter(interval);
        match i < usize::from(cut) {
            true => first.enter(interval),
            false => second.enter(interval),
        }
    }
    let mut both = first;
    both.append(second);
    kani::cover!(
        cut == 1 && whole.course.at == 3 && whole.first == First(Some(2)),
        "what counts is in the second stretch"
    );
    kani::assert(
        both == whole,
        "TH-MERGE: the accounts of two stretches are that of both",
    );
}
