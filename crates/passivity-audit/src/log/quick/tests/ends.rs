//! Walls on one side, and saturated ones.

use super::*;
use crate::entry::{Recorded, entry};
use crate::figure::Figure;
use crate::log::supply::contribution;
use crate::number::{Ample, Number, Reduced, Written as _};

/// A wall on one side or on both, saturated at ten ticks, a third of one later, or nowhere.
fn wall(friction: &str, one_sided: bool, saturated: &str) -> Ledger {
    ledger(&format!(
        "[device]\nmass = \"75 g\"\n{friction}\n[sampling]\nperiod = \"1 ms\"\n[encoder]\nresolution = \"0.03 mm\"\n\
         [wall]\nstiffness = \"1 N/mm\"\nunilateral = {one_sided}\n{saturated}\n"
    ))
}

/// Dry and viscous friction: some, none, and between two ends.
const FRICTIONS: [&str; 4] = [
    "viscous = \"9 N s/m\"\ncoulomb = \"0.04 N\"",
    "coulomb = \"0.04 N\"",
    "coulomb = \"0 N\"",
    "viscous = \"0.7 N s/m ± 20%\"\ncoulomb = \"0.01 N ± 30%\"",
];

const SATURATIONS: [&str; 3] = ["", "max_force = \"0.3 N\"", "max_force = \"0.31 N\""];

/// The force of such a wall from a count, near by.
fn own(from: i64, one_sided: bool, saturated: &str) -> f64 {
    let limit = match saturated {
        "" => f64::INFINITY,
        "max_force = \"0.3 N\"" => 10.0,
        _ => 31.0 / 3.0,
    };
    let middle = from as f64 + 0.5;
    -middle.clamp(if one_sided { 0.0 } else { -limit }, limit)
}

fn exact_number(x: &BigRational) -> Ample {
    Ample::from_reduced(&Reduced::from(x.clone())).unwrap()
}

/// What the row answers, and each of its figures at the least and at the most: as the kernel has it in exact numbers.
fn of_kernel(
    ledger: &Ledger,
    counts: [i64; 2],
    (n, d): (i64, i64),
    force: Option<&BigRational>,
) -> (crate::ledger::Truths, Vec<[BigRational; 2]>) {
    let whole = |n: i64| exact_number(&BigRational::from_integer(n.into()));
    let [start, end] = counts.map(|n| Figure::between(whole(n), whole(n + 1)).unwrap());
    let force = force.map(|force| Figure::Exact(exact_number(force)));
    let dtau = exact_number(&BigRational::new(n.into(), d.into()));
    let of = Recorded {
        samples: &[start],
        end: &end,
        dtau: &dtau,
        force: force.as_ref(),
    };
    let entry = entry(ledger.ample(), &of).unwrap();
    let [net, excess, stored] = contribution(ledger.ample(), &entry).unwrap().parts();
    let mut figures: Vec<_> = entry
        .summed()
        .map(|figure| [figure.lo(), figure.hi()].map(|x| x.to_rational().unwrap()))
        .to_vec();
    figures.extend([net, excess, stored].map(|ends| ends.map(|x| x.to_rational())));
    let observed = entry.observed().to_rational().unwrap();
    figures.push([observed.clone(), observed]);
    (entry.truths(), figures)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(300)))]

    #[test]
    fn figures_of_walls_that_end_hold_the_exact_ones(
        friction in prop::sample::select(&FRICTIONS[..]),
        saturated in prop::sample::select(&SATURATIONS[..]),
        one_sided: bool,
        from in prop_oneof![4 => -16..16_i64, 1 => -200..200_i64],
        ticks in prop_oneof![6 => -3..4_i64, 1 => -40..40_i64],
        lasts in prop_oneof![1 => Just((1, 1)), 4 => (1..5000_i64, 1..5000_i64)],
        force in force(),
    ) {
        let ledger = wall(friction, one_sided, saturated);
        let counts = [from, from + ticks];
        let wall = Wall::of(&ledger).unwrap();
        prop_assert_eq!(wall.reach.is_some(), one_sided || !saturated.is_empty());
        let own = own(from, one_sided, saturated);
        let ball = force.map(|(more, off)| Ball::from_parts(own + more, off));
        let length = Length(lasts.0, lasts.1);
        let quick = Quick::of(&wall).figures(counts, length, ball);
        let bent = Figures::bent(&wall, counts, Ball::of(&Number::Small(lasts.0, lasts.1)), ball);
        for side in [-1.0, 0.0, 1.0] {
            let force = force.map(|(more, off)| exactly(own + more) + exactly(side * off));
            let (truths, exact) = of_kernel(&ledger, counts, lasts, force.as_ref());
            if side == 0.0 && let Some(found) = &quick {
                let excess = ball.map_or((0.0, 0.0), |ball| ((ball.parts().0 - own).abs(), ball.parts().1));
                let bound = width(&ledger, ticks, lasts, excess);
                for (ends, [least, most]) in found.sums.map(|ends| ends.map(in_units)).iter().zip(&exact) {
                    prop_assert!(&ends[1] - &ends[0] <= most - least + &bound);
                }
            }
            for found in quick.iter().chain(&bent) {
                prop_assert_eq!(truths, found.truths);
                let ends = found.sums.into_iter().chain([found.own, found.excess, found.stored, [found.observed, i128::MAX]]);
                for (i, (ends, [least, most])) in ends.zip(&exact).enumerate() {
                    let [lo, hi] = ends.map(in_units);
                    prop_assert!(lo <= *least && *most <= hi, "figure {i}: {lo} {hi} {least} {most}");
                }
            }
        }
    }
}

/// Of the rows of a log in and around a wall, those that are in one part of it are decided, and nearly all others, one at a
/// time.
#[test]
fn rows_in_and_around_a_wall_are_decided() {
    for (friction, one_sided) in [
        (FRICTIONS[0], true),
        (FRICTIONS[1], true),
        (FRICTIONS[3], false),
    ] {
        let ledger = wall(friction, one_sided, SATURATIONS[2]);
        let wall = Wall::of(&ledger).unwrap();
        let quick = Quick::of(&wall);
        let mut bent = [0; 2];
        let part = |n: i64| match (n, one_sided) {
            (..0, true) | (..-11, false) => -2,
            (-11, false) => -1,
            (..10, _) => 0,
            (10, _) => 1,
            _ => 2,
        };
        for from in -20..20_i64 {
            for ticks in -3..4 {
                let own = Ball::from_parts(own(from, one_sided, SATURATIONS[2]), 0.0);
                let more = own + Ball::from_parts(0.013, f64::EPSILON);
                let parts = [from, from + ticks].map(part);
                let is_in_one = parts[0] == parts[1] && parts[0] % 2 == 0;
                for force in [None, Some(Ball::zero()), Some(more)] {
                    let counts = [from, from + ticks];
                    let found = quick.figures(counts, Length(997, 1000), force);
                    assert_eq!(
                        found.is_some(),
                        is_in_one,
                        "{friction} {from} {ticks} {force:?}"
                    );
                    if !is_in_one {
                        let lasts = Ball::of(&Number::Small(997, 1000));
                        let found = Figures::bent(&wall, counts, lasts, force);
                        bent[usize::from(found.is_some())] += 1;
                    }
                }
            }
        }
        let [open, decided] = bent;
        assert!(decided >= 9 * open && decided > 80, "{friction} {bent:?}");
    }
}
