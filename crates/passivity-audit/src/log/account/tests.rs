//! The account of a trace is that of its pieces, in whatever order they are joined.

use passivity_random::draws;
use passivity_scene::Scene;
use proptest::prelude::*;

use super::Account;
use crate::ledger::{Ledger, Logged};
use crate::log::computed::Computed;
use crate::log::header::Heading;
use crate::log::layout::Layout;
use crate::log::preview::Preview;
use crate::log::running::{Lowest, RunningSum};
use crate::log::task::Task;
use crate::number::Number;
use crate::reading::Reading;

/// All that an account has, in a form that can be compared: numbers as fractions.
fn figures(account: &Account) -> String {
    let course = |sum: &RunningSum| (sum.total(), sum.least(), sum.steps());
    let lowest = |lowest: Option<&Lowest>| lowest.map(|lowest| (lowest.value(), lowest.h));
    let supply = &account.supply;
    let [first, second] = supply.sums();
    let [least, most] = supply.lowest();
    format!(
        "{:?}",
        (
            (account.intervals, account.tallies, &account.timing),
            account.sums.each_ref().map(crate::sum::FigureSum::value),
            (course(&account.net), course(&account.observer)),
            lowest(account.stored.as_ref()),
            (course(first), course(second), lowest(least), lowest(most)),
            &supply.excess,
            (&account.worst, &account.firsts, &account.last),
        )
    )
}

/// The account of some intervals after another one, as in a long trace or in a short one.
fn accounted(
    task: &Task<'_>,
    intervals: &[Logged],
    late: bool,
    before: Option<&Logged>,
) -> Account {
    let computed = |interval: &Logged| match late {
        true => Computed::of(task, interval).unwrap(),
        false => Computed::exactly(task, interval).unwrap(),
    };
    let mut account = Account::default();
    if let (true, Some(before)) = (task.running, before) {
        account.supply.excess = computed(before).contribution.map(|c| c.excess().clone());
    }
    for interval in intervals {
        account.timing.add(&interval.dtau, account.intervals);
        computed(interval)
            .account(task, interval, &mut account)
            .unwrap();
        account.last = Some(interval.clone());
    }
    account
}

/// What the samples of a trace are.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// Encoder counts.
    Counts,
    /// Positions in quarters of a tick.
    Quarters,
    /// Positions in fractions whose energies have no common denominator that machine integers hold.
    Odd,
}

fn reading(kind: Kind, x: i64) -> Reading {
    match kind {
        Kind::Counts => Reading::Count(x),
        Kind::Quarters => Reading::Exact(Number::Small(x, 4).reduced()),
        Kind::Odd => Reading::Exact(Number::Small(x, 1_000_003 + x.rem_euclid(5)).reduced()),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(64)))]
    #[test]
    fn th_merge_pieces_joined_in_any_order_are_the_whole(
        path in prop::collection::vec((-6..7_i64, -9..10_i64, 1..5_i64), 2..24),
        cuts in prop::collection::vec(0..24_usize, 0..6),
        order in prop::collection::vec(0..24_usize, 8),
        kind in prop::sample::select(vec![Kind::Counts, Kind::Quarters, Kind::Odd]),
        (applied, late) in any::<(bool, bool)>(),
    ) {
        let scene = Scene::from_toml("s", "[dimensionless]\nbeta = \"3/5\"\nsigma = \"1/5\"").unwrap();
        let ledger = Ledger::of_scene(&scene);
        let names = ["xi", "f"].into_iter().take(1 + usize::from(applied));
        let headings = names.map(|name| Heading::plain(name.to_owned())).collect();
        let layout = Layout::read(headings, None, &Preview::of_rows(&[]), &scene).unwrap();
        let task = Task::new(&scene, &ledger, &layout, false);
        prop_assert_eq!(task.running, applied);
        let mut at = 0;
        let mut intervals = Vec::new();
        for (step, force, quarters) in path {
            let start = reading(kind, at);
            at += step;
            intervals.push(Logged {
                samples: vec![start],
                end: reading(kind, at),
                dtau: Number::Small(quarters, 2).reduced(),
                force: applied.then(|| Reading::Exact(Number::Small(force, 2).reduced())),
            });
        }
        let whole = accounted(&task, &intervals, late, None);

        let mut ends: Vec<usize> = cuts.into_iter().map(|cut| cut.min(intervals.len())).collect();
        ends.push(intervals.len());
        ends.sort_unstable();
        let mut from = 0_usize;
        let mut pieces = Vec::new();
        for to in ends {
            let before = from.checked_sub(1).and_then(|i| intervals.get(i));
            pieces.push(accounted(&task, &intervals[from..to], late, before));
            from = to;
        }
        let mut order = order.into_iter().cycle();
        while pieces.len() > 1 {
            let i = order.next().unwrap() % (pieces.len() - 1);
            let next = pieces.remove(i + 1);
            pieces[i].append(next);
        }
        prop_assert_eq!(figures(&pieces[0]), figures(&whole));
    }
}
