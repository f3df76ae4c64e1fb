//! What a verdict costs: on numbers of data-sheet size, and on ever larger ones:
//! `cargo bench -p passivity-bench --features criterion --bench verdict`.
#![allow(missing_docs)] // criterion's macros define undocumented functions

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use num_bigint::BigInt;
use passivity_core::controller::Controller;
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::verdict::{Speeds, of_loop};
use passivity_core::{BigRational, Exact, Fixed, Friction, Interval, Loop, Scalar, Step, pi};

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// The Maxon RE35 of the paper, with Δ = 2π/8192 by a convergent of π.
fn data_sheet() -> Loop<BigRational> {
    Loop {
        viscous: Some(ratio(9, 1_000_000)),
        coulomb: Some(ratio(2, 1000)),
        resolution: Some(ratio(355, 113) * ratio(2, 8192)),
        ..Loop::new(ratio(1, 1), ratio(1, 1000))
    }
}

/// The same loop, every parameter off by a fraction with a denominator of `bits` bits.
fn large(bits: u64) -> Loop<BigRational> {
    let nudge = BigRational::new(BigInt::from(1), (BigInt::from(1) << bits) + 1);
    data_sheet().map(|_, x| x + &nudge)
}

fn verdicts(c: &mut Criterion) {
    let speeds = Speeds::UpTo(ratio(3, 1));
    let mut group = c.benchmark_group("verdict");
    let re35 = data_sheet();
    group.bench_function("data sheet, at every speed", |b| {
        b.iter(|| of_loop(black_box(&re35), &Speeds::All));
    });
    group.bench_function("data sheet, up to 3 rad/s", |b| {
        b.iter(|| of_loop(black_box(&re35), &speeds));
    });
    let with_effects = Loop {
        delay: 1,
        damping: Some(ratio(1, 1_000_000)),
        ..data_sheet()
    };
    group.bench_function("data sheet, delay and damping", |b| {
        b.iter(|| of_loop(black_box(&with_effects), &speeds));
    });
    for bits in [64, 256, 1024] {
        let nudged = large(bits);
        group.bench_function(format!("denominators of {bits} bits"), |b| {
            b.iter(|| of_loop(black_box(&nudged), &speeds));
        });
    }
    group.finish();
}

/// Boxes of loops, with π as a number of its own.
fn boxes(c: &mut Criterion) {
    let exact = Loop {
        damping: Some(Exact::of(&ratio(1, 1_000_000))),
        resolution: Some(pi::pi().over(Exact::integer(4096))),
        ..data_sheet().map(|_, x| Exact::of(x))
    };
    let tolerance = |x: &Exact| {
        let part = x.clone().over(Exact::integer(10));
        Interval::hull(x.clone() - part.clone(), x.clone() + part)
    };
    let a_box = exact.map(|_, x| tolerance(x));
    let speeds = Speeds::UpTo(tolerance(&Exact::integer(3)));
    c.bench_function("verdict/box with π, tolerances on all", |b| {
        b.iter(|| black_box(&a_box).decide(&speeds));
    });
}

fn rows(c: &mut Criterion) {
    let three_fifths = || Fixed::new(3, 5);
    let paper = Loop::plain(Friction::new(three_fifths(), three_fifths()));
    let step = Step::new(Fixed::new(1001, 1000), Fixed::new(1, 2));
    let interval = HeldInterval::plain(step, Fixed::one());
    c.bench_function("ledger row, 128-bit fractions", |b| {
        b.iter(|| ledger::row(&paper, black_box(&interval)));
    });
    let damped = Loop {
        damping: Some(three_fifths()),
        unilateral: true,
        max_force: Some(Fixed::integer(9)),
        ..paper
    };
    let controller = Controller::of(&damped);
    let mut memory = controller.at_rest(&Fixed::one());
    c.bench_function("controller, 128-bit fractions", |b| {
        b.iter(|| controller.sample(&mut memory, black_box(&Fixed::new(7, 2))));
    });
}

criterion_group!(benches, verdicts, boxes, rows);
criterion_main!(benches);
