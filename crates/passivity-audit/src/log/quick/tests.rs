mod ends;

use num_bigint::BigInt;
use passivity_core::rational::from_wide;
use passivity_core::{BigRational, Ordered as _, Truth, Wide};
use passivity_random::draws;
use passivity_scene::Scene;
use proptest::prelude::*;

use super::*;
use crate::ledger::Ledger;
use crate::span::BITS;

/// Dry and viscous friction of all kinds: much, none, on the border of the criterion, and between two ends.
const WALLS: [&str; 7] = [
    "[dimensionless]\nbeta = \"3/5\"\nsigma = \"7/10\"",
    "[dimensionless]\nbeta = \"1/2\"\nsigma = \"1/2\"",
    "[dimensionless]\nbeta = \"0\"\nsigma = \"0\"",
    "[dimensionless]\nbeta = \"1/3\"\nsigma = \"1/10\"",
    "[dimensionless]\nbeta = \"700\"\nsigma = \"1/1000\"",
    "[device]\nviscous = \"9e-6 N m s/rad ± 20%\"\ncoulomb = \"2e-3 N m ± 30%\"\n[sampling]\n\
     period = \"1 ms\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"1 N m/rad\"\n",
    "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nperiod = \"1 ms\"\n\
     [encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"1 N m/rad\"\n",
];

fn ledger(text: &str) -> Ledger {
    Ledger::of_scene(&Scene::from_toml("s", text).unwrap())
}

fn exactly(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

fn in_units(n: i128) -> BigRational {
    BigRational::new(n.into(), BigInt::from(1) << BITS)
}

/// The row as the kernel's text has it in exact numbers.
fn exact(
    ledger: &Ledger,
    counts: [i64; 2],
    (n, d): (i64, i64),
    force: Option<&BigRational>,
) -> Row<BigRational> {
    let number = |x: &Wide| from_wide(x).unwrap();
    let ends = ledger.wide();
    let friction = [&ends.least, &ends.most].map(|of| {
        Friction::new(
            number(&of.viscous_friction()),
            number(&of.coulomb_friction()),
        )
    });
    let criteria = ends.criteria.each_ref().map(|of| Criterion {
        viscous: number(&of.viscous),
        coulomb: number(&of.coulomb),
    });
    let [start, end] = counts.map(|n| BigRational::from_integer(n.into()));
    let of = Interval {
        start,
        end,
        lasts: BigRational::new(n.into(), d.into()),
        force: force.cloned().unwrap_or_else(BigRational::zero),
    };
    Row::of((&friction, &criteria), &of, false, force.is_some())
}

/// What the row answers, and each of its figures at the least and at the most.
fn figures(of: &Row<BigRational>, crossed: i64) -> (crate::ledger::Truths, Vec<[BigRational; 2]>) {
    let covers = |[lo, hi]: &[BigRational; 2]| [lo, hi].map(|x| x.is_nonnegative().unwrap());
    let both = |x: &BigRational| [x.clone(), x.clone()];
    let [generated, quantized] = of.generated.clone();
    let [net, net_quantized] = of.net.clone();
    (
        crate::log::counted::truths(
            [covers(&of.margin), covers(&net), covers(&net_quantized)],
            crossed,
        ),
        vec![
            generated,
            quantized,
            of.taken.clone(),
            net,
            net_quantized,
            of.own.clone(),
            both(&of.excess),
            of.stored.clone(),
            both(&-of.work.clone()),
        ],
    )
}

/// Forces far from the wall's own, near it, and just that.
fn force() -> impl Strategy<Value = Option<(f64, f64)>> {
    let more = prop_oneof![
        2 => Just(0.0),
        2 => -1.0..1.0,
        1 => (-8..9_i32).prop_map(|n| f64::from(n) / 4.0),
        1 => -1e-13..1e-13,
        1 => -1e6..1e6,
    ];
    let off = prop_oneof![2 => Just(0.0), 1 => 0.0..1e-15, 1 => 0.0..1e-7];
    prop::option::weighted(0.8, (more, off))
}

/// How much wider than the exact ones figures may be under such an excess force, which is off by so much: all that they
/// are off by is a few of the bound.
fn width(ledger: &Ledger, ticks: i64, lasts: (i64, i64), (excess, off): (f64, f64)) -> BigRational {
    let most = &ledger.near().most;
    let friction = [most.viscous_friction(), most.coulomb_friction()];
    let [(beta, of_beta), (sigma, of_sigma)] = friction.map(Ball::parts);
    let (k, dtau) = ((ticks.abs() + 1) as f64, lasts.0 as f64 / lasts.1 as f64);
    let size = k * (k * (beta / dtau + 1.0) + sigma + excess);
    let bound = size * power(44) + 3.0 * k * (k * of_beta / dtau + of_sigma + off);
    exactly(bound + power(55))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(300)))]

    /// Whatever the force is within what is known of it.
    #[test]
    fn figures_hold_what_exact_numbers_make_of_an_interval(
        wall in prop::sample::select(&WALLS[..]),
        from in prop_oneof![4 => -20..20_i64, 1 => -200_000..200_000_i64],
        ticks in prop_oneof![6 => -3..4_i64, 1 => -40..40_i64, 1 => -30_000..30_000_i64],
        lasts in prop_oneof![1 => Just((1, 1)), 4 => (1..5000_i64, 1..5000_i64), 1 => (1..1_i64 << 60, 1..1_i64 << 60)],
        force in force(),
    ) {
        let ledger = ledger(wall);
        let counts = [from, from + ticks];
        let force = force.map(|(more, off)| (more - (from as f64 + 0.5), off));
        let quick = Quick::of(&Wall::of(&ledger).unwrap());
        let ball = force.map(|(middle, off)| Ball::from_parts(middle, off));
        let found = quick.figures(counts, Length(lasts.0, lasts.1), ball);
        let rows = [-1.0, 0.0, 1.0].map(|side| {
            let force = force.map(|(middle, off)| exactly(middle) + exactly(side * off));
            figures(&exact(&ledger, counts, lasts, force.as_ref()), ticks)
        });
        let Some(found) = found else { return Ok(()) };
        let lows = found.sums.into_iter().chain([found.own, found.excess, found.stored]);
        let observed = [found.observed, i128::MAX];
        let ends: Vec<_> = lows.chain([observed]).map(|ends| ends.map(in_units)).collect();
        for (truths, exact) in &rows {
            prop_assert_eq!(*truths, found.truths);
            for (i, ([lo, hi], [least, most])) in ends.iter().zip(exact).enumerate() {
                prop_assert!(lo <= least && most <= hi, "figure {i}: {lo} {hi} {least} {most}");
            }
        }
        // Not much wider either: all together are off by a few of the bound.
        let [_, (_, middle), _] = &rows;
        let excess = force.map_or((0.0, 0.0), |(force, off)| ((force + from as f64 + 0.5).abs(), off));
        let bound = width(&ledger, ticks, lasts, excess);
        for ([lo, hi], [least, most]) in ends.iter().zip(middle).take(6) {
            prop_assert!(hi - lo <= most - least + &bound);
        }
    }
}

/// A device that may stand still is common: then nothing is open, and nothing is generated.
#[test]
fn standing_still_draws_exactly_nothing() {
    let ledger = ledger(WALLS[0]);
    let quick = Quick::of(&Wall::of(&ledger).unwrap());
    for (ticks, force) in [
        (0, None),
        (0, Some(-7.6)),
        (1, Some(-7.5)),
        (-1, Some(-7.4)),
    ] {
        let ball = force.map(|force| Ball::from_parts(force, 0.0));
        let found = quick.figures([7, 7 + ticks], Length(997, 1000), ball);
        let figures = found.unwrap();
        assert_eq!(
            figures.truths.violates_linear,
            Truth::Fails,
            "{ticks} {force:?}"
        );
        assert_eq!(figures.sums[3][0], 0);
        assert_eq!(figures.own[0], 0);
        assert_eq!(figures.sums[2][0], 0);
    }
}

/// Outside of a wall no force is held, and what is added to T is exact: nothing.
#[test]
fn no_force_draws_exactly_nothing() {
    let ledger = ledger(WALLS[0]);
    let quick = Quick::of(&Wall::of(&ledger).unwrap());
    for (from, ticks) in [(-300, 1), (-299, 0), (-299, -1)] {
        let none = Ball::from_parts(0.0, 0.0);
        let figures = quick.figures([from, from + ticks], Length(997, 1000), Some(none));
        let figures = figures.unwrap();
        let excess = i128::from(2 * from + 1) << (BITS - 1);
        assert_eq!(figures.excess, [excess; 2]);
        assert_eq!((figures.own[0], figures.observed), (0, 0));
        let at = i128::from(from + ticks);
        let [least, most] = figures.stored.map(in_units);
        let [low, high] = [0, 1].map(|y| {
            // ½ξ² − fy at both ends of the tick: it is a line, but for ½y².
            let xi = at + y;
            BigRational::new((xi * xi - i128::from(2 * from + 1) * y).into(), 2.into())
        });
        assert!(least <= low && least <= high);
        assert_eq!(most, std::cmp::max(low, high));
    }
}

#[test]
fn ends_are_moved_outward() {
    for off in [1e-300, power(59), power(58), 1e-15, 1e-5] {
        assert!(outward(off) >= off + power(59), "{off}");
        assert!(outward(off) <= off + 3.0 * power(58), "{off}");
    }
    assert_eq!(outward(0.0), 0.0);
    for x in [0.0, 0.125, -3.0, 1e9 / 3.0, -1e-9] {
        let [below, above] = around([Plain(x); 2], outward(1e-12))
            .map(units)
            .map(in_units);
        let (x, off) = (exactly(x), exactly(1e-12));
        assert!(below <= &x - &off && x + off <= above);
    }
    for n in [0, 1 << 6, -(1 << 6), (1 << 90) + (5 << 20), -(1 << 98) - 64] {
        assert_eq!(parts(n).map(units), Some(n));
    }
    assert_eq!((parts(1), parts(1 << 110)), (None, None));
}
