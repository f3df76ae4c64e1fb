//! Time per interval of the inner loops: `cargo bench -p passivity-bench --features criterion --bench motion`.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use passivity_sim::{Plain, Plan, lanes, run};

const INTERVALS: u64 = 10_000;

fn point(beta: f64, sigma: f64) -> Plain {
    Plain {
        mu: 50.0,
        beta,
        sigma,
        xi: 0.0,
        velocity: 2.0,
    }
}

fn motion(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("interval");
    group.throughput(Throughput::Elements(INTERVALS));
    for (name, beta, sigma) in [("cycle", 1.0, 0.1), ("chatter", 0.6, 0.4)] {
        let plan = Plan::plain(&point(beta, sigma), INTERVALS);
        group.bench_function(format!("scalar, {name}"), |b| {
            b.iter(|| run::outcome(black_box(&plan)))
        });
        group.bench_function(format!("ledger, {name}"), |b| {
            b.iter(|| run::ledger(black_box(&plan), |_| true));
        });
    }
    group.throughput(Throughput::Elements(INTERVALS * 64));
    group.bench_function("lanes, 64 points", |b| {
        b.iter(|| {
            let mut queue = (0..64).map(|i| (i, point(0.6 + 0.01 * i as f64, 0.2)));
            lanes::run(
                INTERVALS,
                || queue.next(),
                |_, end| {
                    black_box(end.xi);
                },
            );
        });
    });
    group.finish();
}

criterion_group!(benches, motion);
criterion_main!(benches);
