//! The fast forms of controller and account in doubles, held against the kernel over all sets of
//! effects, delays and steps.
//!
//! With numbers of few binary digits every operation of the doubles is exact, and the results must be
//! the kernel's bit by bit. With any others each result has an error that is derived from the
//! operations that led to it.

use std::sync::Arc;

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::transfer::TransferFunction;
use passivity_core::{BigRational, Controller, Effect, Friction, Loop, Scalar, Step};

use crate::law::{self, HeldForce, controller, controller_in_doubles};
use crate::ledger::potential_change;
use crate::number::{Double, Real, to_double};

/// The effects of the table of 64, in the order of their bits.
const EFFECTS: [Effect; 6] = [
    Effect::Encoder,
    Effect::Delay,
    Effect::Damping,
    Effect::Unilateral,
    Effect::ForceStep,
    Effect::Saturation,
];

fn ratio(n: i32, d: i32) -> BigRational {
    BigRational::integer(n).over(BigRational::integer(d))
}

fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).expect("a finite double")
}

/// What the effects are made of.
struct Values {
    damping: BigRational,
    force_step: BigRational,
    max_force: BigRational,
}

/// The loop with a set of effects.
fn with(set: u8, delay: u16, values: &Values) -> Loop<BigRational> {
    let has = |effect| {
        let bit = EFFECTS.iter().position(|e| *e == effect);
        bit.is_some_and(|bit| set >> bit & 1 == 1)
    };
    let friction = Friction::new(ratio(3, 5), ratio(3, 5));
    Loop {
        resolution: has(Effect::Encoder).then(BigRational::one),
        delay: if has(Effect::Delay) { delay } else { 0 },
        damping: has(Effect::Damping).then(|| values.damping.clone()),
        unilateral: has(Effect::Unilateral),
        force_step: has(Effect::ForceStep).then(|| values.force_step.clone()),
        max_force: has(Effect::Saturation).then(|| values.max_force.clone()),
        ..Loop::smooth(friction)
    }
}

/// Every set of effects with every delay.
fn loops(values: &Values) -> impl Iterator<Item = (u8, Loop<BigRational>)> + '_ {
    (0..64_u8).flat_map(move |set| {
        let delays: &[u16] = if set & law::DELAY == 0 {
            &[0]
        } else {
            &[1, 2, 5]
        };
        delays
            .iter()
            .map(move |delay| (set, with(set, *delay, values)))
    })
}

/// A walk with small and large steps, over edges and on them; behind an encoder, which sees no digits
/// past them, an ulp off them too.
fn walk(encoder: bool) -> Vec<f64> {
    let mut seed = 5_u64;
    let mut walk = vec![0.0, 1.0, -1.0, 0.5, 1.0, 2.0, 2.0, -3.0];
    if encoder {
        walk.extend([1.0_f64.next_down(), -1.0, (-1.0_f64).next_down(), 0.0]);
    }
    for i in 0..60_u32 {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let reach = f64::from(1 << (i % 6));
        // Sixteenths between −reach and reach.
        let sixteenths = (seed >> 33) % (1 << (i % 6 + 5));
        walk.push(sixteenths as f64 / 16.0 - reach);
    }
    walk
}

fn compiled(dimensionless: &Loop<BigRational>) -> HeldForce {
    let controller = controller_in_doubles(dimensionless).expect("no latency");
    HeldForce::compile(&controller).expect("a loop of the table")
}

/// Walks with both controllers; `compare` sees the two forces at each sample.
fn walked(dimensionless: &Loop<BigRational>, compare: impl FnMut(f64, f64, BigRational)) {
    let kernel: Controller<BigRational> =
        controller(dimensionless, BigRational::clone).expect("no latency");
    let remembered = Some(kernel.memory() as u64);
    assert_eq!(law::forgets_after(&kernel), remembered);
    walked_for(usize::MAX, dimensionless, compare);
}

/// Walks so many samples with both controllers.
fn walked_for(
    samples: usize,
    dimensionless: &Loop<BigRational>,
    mut compare: impl FnMut(f64, f64, BigRational),
) {
    let fast = compiled(dimensionless);
    let kernel: Controller<BigRational> =
        controller(dimensionless, BigRational::clone).expect("no latency");
    let certain = law::forgets_after(&kernel);
    assert_eq!(fast.forgets_after(), certain.unwrap_or(u64::MAX));
    let mut walk = walk(dimensionless.has_encoder());
    walk.truncate(samples);
    let start = walk[0];
    let (mut memory, mut remembered) = (fast.memory(start), kernel.at_rest(&exact(start)));
    for xi in walk {
        let force = fast.law()(&fast, &mut memory, xi);
        compare(xi, force, kernel.sample(&mut remembered, &exact(xi)));
        // What both remember, for the test of growth.
        let samples = memory.latest_first().map(exact);
        assert!(
            remembered
                .samples
                .iter()
                .cloned()
                .eq(samples.take(kernel.memory()))
        );
    }
    for xi in [-2.25, -0.5, 0.0, 0.5, 7.0] {
        let settled = kernel.settled(&kernel.measured(&exact(xi)));
        compare(xi, fast.settled(xi), settled);
    }
}

#[test]
fn every_law_of_the_table_is_the_kernels_controller() {
    let mut seen = [false; 64];
    for values in [
        Values {
            damping: ratio(3, 4),
            force_step: ratio(3, 8),
            max_force: ratio(9, 4),
        },
        Values {
            damping: ratio(5, 1),
            force_step: ratio(2, 1),
            max_force: ratio(1, 4),
        },
    ] {
        for (set, dimensionless) in loops(&values) {
            let present: Vec<Effect> = EFFECTS
                .into_iter()
                .filter(|effect| dimensionless.has(*effect))
                .collect();
            assert_eq!(compiled(&dimensionless).effects, set, "{present:?}");
            seen[usize::from(set)] = true;
            walked(&dimensionless, |xi, force, kernel| {
                assert_eq!(exact(force), kernel, "{present:?} at {xi}");
            });
        }
    }
    assert!(seen.iter().all(|seen| *seen));
}

/// A controller with these coefficients.
fn law_of(numerator: &[(i32, i32)], denominator: &[(i32, i32)]) -> TransferFunction<BigRational> {
    let [numerator, denominator] = [numerator, denominator]
        .map(|of| of.iter().map(|(n, d)| ratio(*n, *d)).collect::<Vec<_>>());
    TransferFunction::new(numerator, denominator).expect("a stable controller")
}

/// The loops of all sets of effects with filtered damping or a controller in place of damping.
fn filtered(values: &Values) -> impl Iterator<Item = (u8, Loop<BigRational>)> + '_ {
    let laws = [
        law_of(&[(1, 2), (1, 4), (1, 2)], &[(1, 1)]),
        law_of(&[(1, 4), (1, 1)], &[(1, 1), (1, 4)]),
        law_of(
            &[(3, 2), (-1, 1), (1, 4), (1, 2)],
            &[(2, 1), (-2, 1), (1, 1)],
        ),
        law_of(&[(3, 1)], &[(2, 1), (0, 1), (0, 1), (-1, 1)]),
    ];
    let laws: Vec<_> = laws.into_iter().map(Arc::new).collect();
    loops(values).flat_map(move |(set, the_loop)| {
        if set & law::DAMPING != 0 {
            let filtered = Loop {
                damping_time_constant: Some(ratio(1, 1)), // a = ½
                ..the_loop
            };
            return vec![(set, filtered)];
        }
        let with = |law: &Arc<_>| Loop {
            controller: Some(Arc::clone(law)),
            ..the_loop.clone()
        };
        laws.iter().map(|law| (set, with(law))).collect()
    })
}

#[test]
fn every_law_with_a_filter_is_the_kernels_controller() {
    let values = Values {
        damping: ratio(3, 4),
        force_step: ratio(3, 8),
        max_force: ratio(9, 4),
    };
    for (set, dimensionless) in filtered(&values) {
        let fast = compiled(&dimensionless);
        let others = set & !law::DAMPING;
        assert_eq!(fast.effects, others | law::FILTER, "{dimensionless:?}");
        // Two binary digits more with every sample, on numbers of ten: exact for twenty of them.
        walked_for(20, &dimensionless, |xi, force, kernel| {
            assert_eq!(exact(force), kernel, "{dimensionless:?} at {xi}");
        });
    }
}

#[test]
fn every_filter_with_any_numbers_is_within_its_error_of_the_kernels() {
    let values = Values {
        damping: ratio(1, 3),
        force_step: ratio(1, 10),
        max_force: ratio(700, 9),
    };
    // |c|'s sum is below 4 and that of 1/d below 3.
    let law = Arc::new(law_of(
        &[(1, 3), (1, 7), (-1, 9)],
        &[(1, 1), (-2, 5), (-1, 7)],
    ));
    for (set, the_loop) in loops(&values) {
        let dimensionless = Loop {
            controller: (set & law::DAMPING == 0).then(|| Arc::clone(&law)),
            damping_time_constant: (set & law::DAMPING != 0).then(|| ratio(2, 1)), // a = ⅔
            ..the_loop
        };
        walked_for(usize::MAX, &dimensionless, |xi, force, kernel| {
            // Ten roundings of a number up to 256 at each sample, kept with a factor of at most 3 in
            // all, and two more of the force.
            let rounding = (10.0 * 3.0 + 2.0) * 128.0 * f64::EPSILON;
            let stepped = set & law::FORCE_STEP != 0;
            let step = if stepped {
                values.force_step.approximate()
            } else {
                0.0
            };
            let off = (force - to_double(&kernel)).abs();
            assert!(
                off <= step + rounding,
                "set {set} at {xi}: {force} and {kernel}"
            );
        });
    }
}

#[test]
fn rest_is_certain_behind_one_pole_that_is_not_negative() {
    let after = |law: TransferFunction<BigRational>| {
        let the_loop = Loop {
            controller: Some(Arc::new(law)),
            ..with(law::ENCODER | law::DELAY, 2, &limited(1, 1))
        };
        let kernel: Controller<BigRational> =
            controller(&the_loop, BigRational::clone).expect("no latency");
        law::forgets_after(&kernel)
    };
    let one = [(1, 1)];
    assert_eq!(after(law_of(&[(1, 1), (1, 1), (1, 1)], &one)), Some(4));
    assert_eq!(after(law_of(&one, &[(1, 1), (-9, 10)])), Some(3));
    assert_eq!(
        after(law_of(&[(1, 1), (2, 1), (3, 1)], &[(1, 1), (-1, 2)])),
        Some(4)
    );
    assert_eq!(after(law_of(&one, &[(1, 1), (9, 10)])), None);
    assert_eq!(after(law_of(&one, &[(1, 1), (-3, 4), (1, 8)])), None);
}

#[test]
fn every_law_with_any_numbers_is_within_its_error_of_the_kernels() {
    let values = Values {
        damping: ratio(1, 3),
        force_step: ratio(1, 10),
        max_force: ratio(70, 9),
    };
    for (set, dimensionless) in loops(&values) {
        let step = values.force_step.approximate();
        walked(&dimensionless, |xi, force, kernel| {
            // Three roundings of a force up to 33 + 65/3 < 64, and the rounding of B or of the limit.
            let rounding = 4.0 * 32.0 * f64::EPSILON;
            let off = (force - to_double(&kernel)).abs();
            // On the edge between two steps of the converter rounding decides: with an encoder and no
            // damping the force is exact there, so the doubles decide as the kernel does.
            let undecided = set & law::FORCE_STEP != 0 && set & law::DAMPING != 0;
            let most = if undecided { step + rounding } else { rounding };
            assert!(off <= most, "set {set} at {xi}: {force} and {kernel}");
        });
    }
}

#[test]
fn a_force_half_way_between_two_steps_rounds_as_the_kernel_does() {
    // Thirds are no doubles, but their numerator and denominator are.
    let third = Values {
        damping: ratio(0, 1),
        force_step: ratio(1, 3),
        max_force: ratio(1, 1),
    };
    let dimensionless = with(law::ENCODER | law::FORCE_STEP, 0, &third);
    let fast = compiled(&dimensionless);
    let kernel: Controller<BigRational> =
        controller(&dimensionless, BigRational::clone).expect("no latency");
    for tick in -20..20 {
        let x = f64::from(tick);
        let steps = fast.law()(&fast, &mut fast.memory(0.0), x) * 3.0;
        let expected = kernel.settled(&kernel.measured(&exact(x))) * ratio(3, 1);
        // A whole number of thirds, computed as n·1/3: within half an ulp of itself.
        assert_eq!(exact(steps.round()), expected);
        assert!((steps - steps.round()).abs() < 1e-14);
    }
}

/// Effects of which only the limit of the force matters.
fn limited(n: i32, d: i32) -> Values {
    Values {
        damping: ratio(3, 4),
        force_step: ratio(3, 8),
        max_force: ratio(n, d),
    }
}

/// What the kernel says that a held force of 0 generates: the change of both potentials.
fn potentials(dimensionless: &Loop<BigRational>, from: f64, to: f64) -> [BigRational; 2] {
    let interval = HeldInterval {
        step: Step::new(exact(from), exact(to)),
        force: BigRational::zero(),
        dtau: BigRational::one(),
        extra_storage: None,
    };
    ledger::generated(dimensionless, &interval)
}

#[test]
fn every_potential_is_the_kernels() {
    for values in [&limited(9, 4), &limited(1, 4)] {
        for set in 0..64 {
            let dimensionless = with(set, 1, values);
            let fast = compiled(&dimensionless);
            // Eighths: every operation of the doubles is exact.
            for i in (-40..=40).step_by(3) {
                for j in -40..=40 {
                    let (from, to) = (f64::from(i) / 8.0, f64::from(j) / 8.0);
                    let got = potential_change(&fast, from, to).map(exact);
                    assert_eq!(
                        got,
                        potentials(&dimensionless, from, to),
                        "{set}: {from} to {to}"
                    );
                }
            }
        }
    }
}

#[test]
fn potentials_with_any_numbers_are_within_their_error_of_the_kernels() {
    let values = limited(7, 3);
    for set in 0..64 {
        let dimensionless = with(set, 1, &values);
        let fast = compiled(&dimensionless);
        for i in -30..30 {
            let (from, to) = (f64::from(i) * 0.3, f64::from(i) * -0.17 + 0.7);
            let got = potential_change(&fast, from, to);
            for (got, want) in got.into_iter().zip(potentials(&dimensionless, from, to)) {
                // A dozen roundings of energies below ½·10², and 1/8 more.
                let off = (got - to_double(&want)).abs();
                assert!(
                    off < 12.0 * 64.0 * f64::EPSILON,
                    "{set}: {from} to {to}: {got} {want}"
                );
            }
        }
    }
}

#[test]
fn the_kernels_row_in_doubles_is_its_row() {
    for set in 0..64 {
        let dimensionless = with(set, 1, &limited(9, 4));
        let halves = Loop {
            viscous: Some(ratio(5, 8)),
            coulomb: Some(ratio(3, 4)),
            ..dimensionless
        };
        let in_doubles = halves.map(|_, x| Double::from(x));
        for (i, j) in [(0, 1), (8, 4), (-3, 5), (7, -26), (4, 4), (0, -8)] {
            let step = Step::new(ratio(i, 8), ratio(j, 8));
            let fast_step = Step::new(Double::from(&step.start), Double::from(&step.end));
            let generated = [ratio(3, 16), ratio(-5, 16)];
            let row = ledger::row_of(&halves, &step, &ratio(1, 1), generated.clone());
            let fast = ledger::row_of(
                &in_doubles,
                &fast_step,
                &Double(1.0),
                generated.each_ref().map(Double::from),
            );
            for (fast, row) in [
                (fast.bound_22, row.bound_22),
                (fast.bound_quantized, row.bound_quantized),
                (fast.dissipated_lower, row.dissipated_lower),
                (fast.net_linear, row.net_linear),
                (fast.net_quantized, row.net_quantized),
                (fast.margin, row.margin),
            ] {
                assert_eq!(exact(fast.0), row, "{set}: {i}/8 to {j}/8");
            }
        }
    }
}
