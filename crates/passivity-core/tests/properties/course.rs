//! TH-MERGE: what pieces of a stretch keep makes what the whole keeps, whichever are joined first.

use passivity_core::BigRational;
use passivity_core::course::{Course, First, Last, Least};
use proptest::prelude::*;

use crate::common::{sampled, zero};

/// What an interval adds to the sum, what stands beside the sum where it ends, whether it is of the kind, and
/// what it hands on.
type Interval = (BigRational, BigRational, bool, Option<u8>);

#[derive(Clone, Debug, PartialEq)]
struct Account {
    steps: u64,
    course: Course<BigRational>,
    least: Least<BigRational>,
    first: First,
    last: Last<u8>,
}

impl Account {
    /// By the kernel, interval after interval.
    fn of(intervals: &[Interval]) -> Self {
        let mut account = Self {
            steps: 0,
            course: Course::default(),
            least: Least::default(),
            first: First::default(),
            last: Last(None),
        };
        for (step, beside, kind, on) in intervals {
            account.steps += 1;
            account.course.step(step.clone(), account.steps);
            let value = &account.course.sum + beside;
            account.least.keep(value, account.steps);
            if *kind {
                account.first.keep(account.steps);
            }
            account.last.append(Last(*on));
        }
        account
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

/// Small numbers that often agree, and large ones of many digits.
fn energy() -> impl Strategy<Value = BigRational> {
    let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    prop_oneof![
        (-3..4_i64).prop_map(move |n| ratio(n, 1)),
        (any::<i64>(), 1..i64::MAX).prop_map(move |(n, d)| ratio(n, d)),
    ]
}

fn stretch() -> impl Strategy<Value = Vec<Interval>> {
    let interval = (energy(), energy(), any::<bool>(), any::<Option<u8>>());
    prop::collection::vec(interval, 0..16)
}

/// The smallest of some numbers and the first place where it is.
fn least(values: &[BigRational]) -> Option<(BigRational, u64)> {
    let least = values.iter().min()?;
    let at = values.iter().position(|value| value == least)?;
    Some((least.clone(), at as u64))
}

sampled! {
    /// One pass finds the least value of the sum, its start included, where it was first, and the rest.
    fn th_merge_one_pass_finds_the_least_and_the_first(intervals in stretch()) {
        let account = Account::of(&intervals);
        let mut sums = vec![zero()];
        for (step, ..) in &intervals {
            sums.push(sums.last().unwrap() + step);
        }
        let course = &account.course;
        prop_assert_eq!(Some((course.least.clone(), course.at)), least(&sums));
        prop_assert_eq!(Some(&course.sum), sums.last());
        let ends = sums.iter().skip(1).zip(&intervals);
        let energies: Vec<BigRational> = ends.map(|(sum, (_, beside, ..))| sum + beside).collect();
        let expected = least(&energies).map(|(value, at)| (value, at + 1));
        prop_assert_eq!(account.least.0, expected);
        let first = intervals.iter().position(|(_, _, kind, _)| *kind);
        prop_assert_eq!(account.first.0, first.map(|at| at as u64 + 1));
        prop_assert_eq!(account.last.0, intervals.iter().rev().find_map(|(.., on)| *on));
    }

    fn th_merge_pieces_joined_in_any_order_are_the_whole(
        intervals in stretch(),
        cuts in prop::collection::vec(0..16_usize, 0..6),
        order in prop::collection::vec(any::<prop::sample::Index>(), 6),
    ) {
        let mut ends: Vec<usize> = cuts.into_iter().map(|cut| cut.min(intervals.len())).collect();
        ends.push(intervals.len());
        ends.sort_unstable();
        let starts = [0].into_iter().chain(ends.clone());
        let mut pieces: Vec<Account> =
            starts.zip(&ends).map(|(from, to)| Account::of(&intervals[from..*to])).collect();
        for index in order {
            if pieces.len() > 1 {
                let i = index.index(pieces.len() - 1);
                let next = pieces.remove(i + 1);
                pieces[i].append(next);
            }
        }
        prop_assert_eq!(pieces, vec![Account::of(&intervals)]);
    }
}

/// Of equals the first one stays, and what has none leaves what is there.
#[test]
fn th_merge_of_equals_the_first_stays() {
    let mut least = Least::default();
    assert!(!least.append(&Least(None), &0, 1));
    assert_eq!(least, Least(None));
    assert!(least.keep(3, 1) && !least.keep(3, 2) && !least.keep(4, 3));
    assert!(!least.append(&Least(Some((3, 1))), &0, 3));
    assert!(!least.append(&Least(None), &-9, 3));
    assert_eq!(least, Least(Some((3, 1))));
    let mut course = Course::default();
    course.step(-1, 1);
    course.step(1, 2);
    let before = course;
    // From a sum of 0 down to −1 again.
    assert!(!course.append(&before, 2));
    assert_eq!((course.least, course.at, course.sum), (-1, 1, 0));
    let mut lower = Course::default();
    lower.step(-2, 1);
    assert!(course.append(&lower, 4));
    assert_eq!((course.least, course.at), (-2, 5));
    let mut first = First::default();
    assert!(first.keep(7) && !first.keep(7) && !first.keep(8) && first.keep(6));
    assert!(!first.append(First(None), 0));
    assert_eq!(first, First(Some(6)));
}
