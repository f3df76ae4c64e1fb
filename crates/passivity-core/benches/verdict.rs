//! What a verdict costs: on numbers of data-sheet size, and on ever larger ones.
#![allow(missing_docs)] // criterion's macros define undocumented functions

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use num_bigint::BigInt;
use passivity_core::effects::Effects;
use passivity_core::verdict::{Speeds, of_rig};
use passivity_core::{BigRational, Fixed, Rig, Scalar, Step, ledger};

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// The Maxon RE35 of the paper, with Δ = 2π/8192 by a convergent of π.
fn data_sheet() -> Rig<BigRational> {
    Rig {
        viscous: ratio(9, 1_000_000),
        coulomb: ratio(2, 1000),
        stiffness: ratio(1, 1),
        period: ratio(1, 1000),
        length: ratio(355, 113) * ratio(2, 8192),
        effects: Effects::encoder(),
    }
}

/// The same rig, every parameter off by a fraction with a denominator of `bits` bits.
fn large(bits: u64) -> Rig<BigRational> {
    let nudge = BigRational::new(BigInt::from(1), (BigInt::from(1) << bits) + 1);
    data_sheet()
        .try_map(|x| Some(x + &nudge))
        .expect("a map that never gives up")
}

fn verdicts(c: &mut Criterion) {
    let speeds = Speeds::UpTo(ratio(3, 1));
    let mut group = c.benchmark_group("verdict");
    let rig = data_sheet();
    group.bench_function("data sheet, at every speed", |b| {
        b.iter(|| of_rig(black_box(&rig), &Speeds::All));
    });
    group.bench_function("data sheet, up to 3 rad/s", |b| {
        b.iter(|| of_rig(black_box(&rig), &speeds));
    });
    let effects = Effects {
        delay: 1,
        damping: Some(ratio(1, 1_000_000)),
        ..Effects::encoder()
    };
    let with_effects = Rig {
        effects,
        ..data_sheet()
    };
    group.bench_function("data sheet, delay and damping", |b| {
        b.iter(|| of_rig(black_box(&with_effects), &speeds));
    });
    for bits in [64, 256, 1024] {
        let rig = large(bits);
        group.bench_function(format!("denominators of {bits} bits"), |b| {
            b.iter(|| of_rig(black_box(&rig), &speeds));
        });
    }
    group.finish();
}

fn rows(c: &mut Criterion) {
    let friction = passivity_core::Friction::new(Fixed::new(3, 5), Fixed::new(3, 5));
    let step = Step::new(Fixed::new(1001, 1000), Fixed::new(1, 2));
    c.bench_function("ledger row, 128-bit fractions", |b| {
        b.iter(|| ledger::row(black_box(&step), &friction, &Fixed::one()));
    });
}

criterion_group!(benches, verdicts, rows);
criterion_main!(benches);
