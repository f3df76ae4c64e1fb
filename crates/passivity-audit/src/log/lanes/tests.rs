mod counts;
mod exactly;

use std::ops::Range;

use passivity_core::course::Course;
use passivity_core::{BigRational, Scalar as _, quantizer, rational};
use passivity_random::draws;
use passivity_scene::Scene;
use proptest::prelude::*;

use super::written::{Before, Rows, compute};
use super::*;
use crate::entry::{Entry, Recorded, entry};
use crate::figure::Figure;
use crate::ledger::Ledger;
use crate::log::known::{Known, Starts};
use crate::log::motion::Addend;
use crate::number::Number;
use crate::rows::Form;

pub(super) const EXACT: &str = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"7/10\"";

/// Friction between two ends that are far apart.
pub(super) const BETWEEN: &str = "[device]\nviscous = \"9e-6 N m s/rad ± 20%\"\ncoulomb = \"2e-3 N m ± 30%\"\n[sampling]\n\
    period = \"1 ms\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"1 N m/rad\"\n";

pub(super) fn ledger(text: &str) -> Ledger {
    Ledger::of_scene(&Scene::from_toml("s", text).unwrap())
}

/// Numbers of all sizes: short ones, on the edges of ticks, near them, and any.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => (-40_i32..40).prop_map(|n| f64::from(n) / 8.0),
        3 => (-4000_i32..4000, 1..400_i32).prop_map(|(n, d)| f64::from(n) / f64::from(d)),
        1 => (-4_i32..4).prop_map(|n| f64::from(n) + f64::EPSILON * f64::from(n)),
        1 => -1e9..1e9,
        1 => -1e-9..1e-9,
        1 => any::<f64>().prop_filter("a number", |x| x.is_finite()),
    ]
}

pub(super) fn ball() -> impl Strategy<Value = Ball> {
    let radius =
        prop_oneof![3 => Just(0.0), 3 => 0.0..1e-12, 1 => 0.0..0.3, 1 => Just(f64::INFINITY)];
    (number(), radius).prop_map(|(middle, radius)| match radius < 1.0 {
        true => Ball::from_parts(middle, radius * middle.abs()),
        false => Ball::UNDEFINED,
    })
}

#[derive(Clone, Copy, Debug)]
struct Row {
    ends: [Ball; 2],
    still: bool,
    lasts: Ball,
    force: Ball,
}

fn row() -> impl Strategy<Value = Row> {
    let lasts = (1..5000_i32, 1..5000_i32).prop_map(|(n, d)| {
        let middle = f64::from(n) / f64::from(d);
        Ball::from_parts(middle, f64::EPSILON * middle)
    });
    let lasts = prop_oneof![1 => Just(Ball::one()), 2 => lasts];
    (ball(), ball(), 0..4, lasts, ball(), any::<bool>()).prop_map(
        |(start, end, how, lasts, force, own)| {
            let end = match how {
                0 => start,
                1 => start + Ball::one().half().half(),
                _ => end,
            };
            let force = if own {
                quantizer::held_force(&start)
            } else {
                force
            };
            Row {
                ends: [start, end],
                still: how == 0,
                lasts,
                force,
            }
        },
    )
}

impl Tile {
    /// What a row adds.
    fn truths(&self, i: usize, applied: bool) -> Truths {
        truths(self.truths[usize::from(applied)][i])
    }

    pub(crate) fn addend(&self, i: usize, applied: bool) -> Option<Addend> {
        let at = |column: &Column| column.get(i).on_grid();
        let known = Known {
            displacement: Ball::zero(),
            commanded: Ball::zero(),
            generated: [at(&self.linear)?, at(&self.quantized)?],
            observed: at(&self.observed)?,
            dissipated: [at(&self.taken[0])?, at(&self.taken[1])?],
            criterion_holds: self.truths(i, applied).criterion_holds,
            potential: at(&self.potential)?,
        };
        known.with_work(if applied { at(&self.more)? } else { [0, 0] })
    }
}

/// The row as it is computed on its own.
fn alone(ledger: &Ledger, row: &Row, applied: bool) -> Option<Addend> {
    let wall = Wall::of(ledger).unwrap();
    let known = Known::of(
        (ledger.near(), wall.reach.as_ref()),
        &mut Starts::default(),
        row.ends,
        row.still,
        &row.lasts,
    )?;
    known.addend(applied.then_some(row.force))
}

fn intervals(rows: &[Row]) -> Intervals {
    let mut all = Intervals::new();
    all.lasts.middles.fill(1.0);
    for (i, row) in rows.iter().enumerate() {
        all.start.set(i, row.ends[0]);
        all.end.set(i, row.ends[1]);
        all.lasts.set(i, row.lasts);
        all.force.set(i, row.force);
        all.still[i] = u64::from(row.still);
    }
    all.len = rows.len();
    all
}

fn same(a: &Addend, b: &Addend) -> bool {
    (a.sums, a.observed, a.potential, a.truths) == (b.sums, b.observed, b.potential, b.truths)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(250)))]

    #[test]
    fn rows_are_those_that_are_computed_alone(
        rows in prop::collection::vec(row(), 1..TILE + 1), exact: bool,
    ) {
        let ledger = ledger(if exact { EXACT } else { BETWEEN });
        let wall = Wall::of(&ledger).unwrap();
        prop_assert_eq!(wall.friction_is_exact, exact);
        check_rows(&ledger, &rows)?;
    }
}

/// How many rows of a tile are decided, under the force of the wall and under that in the log together: each is what it is
/// when it is computed alone.
fn check_rows(ledger: &Ledger, rows: &[Row]) -> Result<usize, TestCaseError> {
    let wall = Wall::of(ledger).unwrap().lanes();
    let mut tile = Tile::new();
    tile.fill(&wall, &intervals(rows), true);
    let mut several = 0;
    for applied in [false, true] {
        let mut at = 0;
        while at < rows.len() {
            let decided = at..tile.decided(at, TILE, applied);
            for i in decided.clone() {
                let found = tile.addend(i, applied).unwrap();
                let expected = alone(ledger, &rows[i], applied);
                let agrees = expected
                    .as_ref()
                    .is_some_and(|expected| same(expected, &found));
                prop_assert!(agrees, "{:?} {found:?} {expected:?}", rows[i]);
                prop_assert_eq!(tile.truths(i, applied), found.truths);
            }
            if !decided.is_empty() {
                check_sums(&tile, &decided, applied)?;
            }
            several += decided.len();
            at = decided.end + 1;
        }
    }
    Ok(several)
}

/// A wall on one side or on both, saturated at ten ticks.
const ENDS: &str = "[device]\nmass = \"75 g\"\nviscous = \"9 N s/m\"\ncoulomb = \"0.04 N\"\n[sampling]\nperiod = \"1 ms\"\n\
    [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"1 N/mm\"\n";

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(250)))]

    #[test]
    fn rows_of_walls_that_end_are_those_that_are_computed_alone(
        rows in prop::collection::vec((row(), -15.0..15.0, -1.0..1.0, 0.0..1e-12, any::<bool>()), 1..TILE + 1),
        one_sided: bool,
        // Of ticks that are whole and of others.
        saturated in prop::sample::select(vec!["", "max_force = \"0.3 N\"\n", "max_force = \"0.31 N\"\n"]),
    ) {
        let ledger = ledger(&format!("{ENDS}unilateral = {one_sided}\n{saturated}"));
        // Of all sizes, and around the ends of the wall.
        let rows: Vec<Row> = rows.into_iter().map(|(row, start, step, off, any)| {
            let near = |x: f64| Ball::from_parts((x * 64.0).round() / 64.0, if row.lasts == Ball::one() { 0.0 } else { off });
            let ends = if row.still { [near(start); 2] } else { [near(start), near(start + step)] };
            Row { ends: if any { row.ends } else { ends }, ..row }
        }).collect();
        let decided = check_rows(&ledger, &rows)?;
        prop_assert!(decided > 0 || rows.len() < 12);
    }

    #[test]
    fn rows_of_walls_that_end_hold_the_exact_ones(
        rows in prop::collection::vec((row(), -15.0..15.0, -1.0..1.0), 1..TILE + 1),
        one_sided: bool, saturated in prop_oneof![Just(""), Just("max_force = \"0.3 N\"\n")],
    ) {
        let ledger = ledger(&format!("{ENDS}unilateral = {one_sided}\n{saturated}"));
        let wall = Wall::of(&ledger).unwrap().lanes();
        prop_assert_eq!(wall.reach.is_some(), one_sided || !saturated.is_empty());
        let mut decided = 0;
        // Numbers that are known exactly, of all sizes and near the ends of the wall.
        let rows: Vec<Row> = rows.into_iter().map(|(row, start, step)| {
            let exactly = |ball: Ball| Ball::from_parts(ball.parts().0, 0.0);
            let ends = match row.still {
                true => row.ends.map(exactly),
                false => [start, start + step].map(|x: f64| Ball::from_parts((x * 64.0).round() / 64.0, 0.0)),
            };
            Row { ends, lasts: Ball::one(), force: exactly(row.force), ..row }
        }).collect();
        let mut tile = Tile::new();
        tile.fill(&wall, &intervals(&rows), true);
        for (i, row) in rows.iter().enumerate() {
            let wide = |ball: Ball| Number::from_f64(ball.parts().0).unwrap().to_wide();
            for applied in [false, true] {
                if tile.decided(i, i + 1, applied) == i {
                    continue;
                }
                decided += 1;
                let found = tile.addend(i, applied).unwrap();
                let [start, end, force] = [row.ends[0], row.ends[1], row.force].map(|x| Figure::Exact(wide(x)));
                let dtau = wide(row.lasts);
                let interval = Recorded { samples: &[start], end: &end, dtau: &dtau, force: applied.then_some(&force) };
                let exact = entry(ledger.wide(), &interval).unwrap();
                prop_assert_eq!(found.truths, exact.truths(), "{:?}", row);
                for (ends, figure) in found.sums.iter().zip(exact.summed()) {
                    let unit = BigRational::from_integer(crate::span::ONE.into());
                    let figure = rational::from_wide(figure.lo()).unwrap() * unit;
                    let [lo, hi] = ends.map(|n| BigRational::from_integer(n.into()));
                    prop_assert!(lo <= figure && figure <= hi, "{:?} {} {} {}", row, lo, figure, hi);
                }
                let potential = ledger.wide().least.law().potential(&wide(row.ends[1]));
                let potential = rational::from_wide(&potential).unwrap();
                let [lo, hi] = found.potential.map(crate::span::on_grid);
                prop_assert!(lo <= potential && potential <= hi);
            }
        }
        // Those that are in one part of the wall.
        prop_assert!(decided > 0 || rows.len() < 12);
    }
}

/// The row of one period as it is written on its own.
fn written_alone(ledger: &Ledger, row: &Row, form: Form) -> Option<Vec<u8>> {
    let [xi0, xi1] = row.ends.map(Figure::Exact);
    let at = |ball: Ball| Figure::Exact(if row.still { ball.one_of() } else { ball });
    let force = Figure::Exact(row.force);
    let (start, end) = (at(row.ends[0]), at(row.ends[1]));
    let interval = Recorded {
        samples: &[start],
        end: &end,
        dtau: &row.lasts,
        force: form.force.then_some(&force),
    };
    let entry = entry(ledger.near(), &interval)?;
    let entry = Entry { xi0, xi1, ..entry }.with_margin(ledger.near())?;
    let (mut text, mut rest) = (Vec::new(), Vec::new());
    form.write_near(&entry, &Number::whole(1), [&mut text, &mut rest])?;
    text.append(&mut rest);
    Some(text)
}

/// How many rows are written several at a time: as they are on their own, after any other one.
fn written(ledger: &Ledger, rows: &[Row], form: Form) -> Result<usize, TestCaseError> {
    let mut found = Rows::new();
    compute(
        &mut found,
        &Wall::of(ledger).unwrap().lanes(),
        &intervals(rows),
        form.force,
    );
    let mut several = 0;
    for (i, row) in rows.iter().enumerate() {
        let (start, length) = (row.ends[0], Length(1, 1));
        let (mut before, mut out) = (Before::new(), Vec::new());
        let is_written = found.write(i, (start, length), &mut before, form, &mut out);
        if is_written.is_none() {
            continue;
        }
        several += 1;
        let expected = written_alone(ledger, row, form);
        prop_assert_eq!(Some(&out), expected.as_ref(), "{:?}", row);
        // Another row that starts where it ends has that position, and how long it lasts, from it.
        let end = row.ends[1];
        let next = Row {
            ends: [end; 2],
            still: true,
            ..*row
        };
        let mut after = Rows::new();
        compute(
            &mut after,
            &Wall::of(ledger).unwrap().lanes(),
            &intervals(&[next]),
            form.force,
        );
        let from = out.len();
        if after
            .write(0, (end, length), &mut before, form, &mut out)
            .is_some()
        {
            let expected = written_alone(ledger, &next, form);
            prop_assert_eq!(Some(&out[from..]), expected.as_deref(), "{:?}", next);
        }
    }
    Ok(several)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(75)))]

    #[test]
    fn rows_are_written_as_they_are_alone(
        rows in prop::collection::vec(row(), 1..TILE + 1), exact: bool, force: bool,
    ) {
        let ledger = ledger(if exact { EXACT } else { BETWEEN });
        written(&ledger, &rows, Form { enclosures: true, force, accounted: true })?;
    }
}

fn check_sums(tile: &Tile, rows: &Range<usize>, applied: bool) -> Result<(), TestCaseError> {
    let sums = tile.sums(rows, applied);
    let mut all = [[0, 0]; 5];
    let (mut courses, mut observer) = (Courses::default(), Course::default());
    for (i, h) in rows.clone().zip(1..) {
        let addend = tile.addend(i, applied).unwrap();
        for (sum, figure) in all.iter_mut().zip(addend.sums) {
            *sum = [sum[0] + figure[0], sum[1] + figure[1]];
        }
        let (net, potential) = (addend.sums[3], addend.potential);
        courses.step((net[0], potential[0]), Some([net, potential]), h);
        observer.step(addend.observed, h);
        prop_assert!(sums.least_row <= addend.sums[3][0]);
        prop_assert!(sums.least_net <= all[3][0]);
        prop_assert!(sums.least_stored <= all[3][0] + addend.potential[0]);
        prop_assert!(sums.least_observed <= observer.sum);
    }
    prop_assert_eq!((sums.sums, sums.observed), (all, observer.sum));
    // Where they are least, without the sums of all rows.
    let asked = Asked {
        net: true,
        worst: true,
        supply: [true; 2],
    };
    let mut tile = Under::new(tile, applied);
    tile.add_up(rows, true, None).unwrap();
    let mut found = tile.courses(rows, (asked, &sums));
    for (found, course) in found.supply.iter_mut().zip(courses.supply) {
        found.sum = course.sum;
    }
    found.net.sum = courses.net.sum;
    prop_assert_eq!(found, courses);
    tile.add_up(rows, false, None).unwrap();
    found = tile.courses(rows, (asked, &sums));
    prop_assert_eq!(
        (found.stored, found.net.at),
        (courses.lowest[0], courses.net.at)
    );
    let found = tile.observer(rows, &sums);
    prop_assert_eq!((found.least, found.at), (observer.least, observer.at));
    Ok(())
}

#[test]
fn most_rows_of_a_log_are_decided() {
    let ledger = ledger(BETWEEN);
    let wall = Wall::of(&ledger).unwrap().lanes();
    let rows: Vec<Row> = (0..TILE)
        .map(|i| {
            let at = |i: usize| {
                let middle = 20.0 * (0.03 * i as f64).sin() + 0.013;
                Ball::from_parts(middle, f64::EPSILON * middle.abs())
            };
            Row {
                ends: [at(i), at(i + 1)],
                still: false,
                lasts: Ball::from_parts(0.99, f64::EPSILON),
                force: quantizer::held_force(&at(i)) + Ball::from_parts(0.01, f64::EPSILON),
            }
        })
        .collect();
    let mut tile = Tile::new();
    tile.fill(&wall, &intervals(&rows), true);
    for applied in [false, true] {
        assert_eq!(tile.decided(0, TILE, applied), TILE);
        check_sums(&tile, &(0..TILE), applied).unwrap();
        check_sums(&tile, &(3..50), applied).unwrap();
        let form = Form {
            enclosures: true,
            force: applied,
            accounted: true,
        };
        assert_eq!(written(&ledger, &rows, form).unwrap(), TILE);
    }
}
