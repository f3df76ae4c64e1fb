//! Numbers to try, and the frame that runs a test on many of them.

use std::any::Any;
use std::cell::Cell;
use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::Path;
use std::time::Instant;

use num_bigint::{BigInt, Sign};
use num_traits::Zero as _;
use passivity_core::{BigRational, Friction, Loop};
use proptest::prelude::*;
use proptest::test_runner::{FileFailurePersistence, TestRunner};

/// Inputs that each sampled test is run on, times what `PASSIVITY_TIMES` says, unless `PROPTEST_CASES` says otherwise.
const CASES: u32 = 64;

/// The fraction n/d.
pub(crate) fn q(n: i64, d: i64) -> BigRational {
    BigRational::new(BigInt::from(n), BigInt::from(d))
}

/// ½.
pub(crate) fn half() -> BigRational {
    q(1, 2)
}

/// 0.
pub(crate) fn zero() -> BigRational {
    BigRational::zero()
}

/// The magnitude, by its own means.
pub(crate) fn magnitude(x: &BigRational) -> BigRational {
    if *x < zero() { -x } else { x.clone() }
}

/// x².
pub(crate) fn squared(x: &BigRational) -> BigRational {
    x * x
}

/// An integer of up to 6 digits of 32 bits, of all sizes alike: past all machine integers.
fn big() -> impl Strategy<Value = BigInt> {
    (prop::collection::vec(any::<u32>(), 1..=6), any::<bool>()).prop_map(|(digits, minus)| {
        let sign = if minus { Sign::Minus } else { Sign::Plus };
        BigInt::from_slice(sign, &digits)
    })
}

/// A number of up to 192 bits, over another.
fn big_ratio() -> impl Strategy<Value = BigRational> {
    (big(), big()).prop_map(|(n, d)| {
        let d = if d.is_zero() { BigInt::from(1) } else { d };
        BigRational::new(n, d)
    })
}

/// A tiny number: one over two hundred bits.
fn tiny() -> impl Strategy<Value = BigRational> {
    big_ratio().prop_map(|x| {
        let size = BigRational::from_integer(BigInt::from(1) << 200);
        let x = if x.is_zero() { q(1, 1) } else { x };
        x.recip() / size
    })
}

/// A position in ticks: on a coarse grid, beside a tick, whole, or anywhere.
pub(crate) fn position() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        2 => (-64i64..64).prop_map(|n| q(n, 16)),
        1 => (-9i64..9, tiny()).prop_map(|(n, e)| q(n, 1) + e),
        1 => big().prop_map(BigRational::from_integer),
        2 => (-9i64..9, unit()).prop_map(|(n, e)| q(n, 1) + e),
        2 => big_ratio(),
    ]
}

/// A number of either sign.
pub(crate) fn number() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        2 => (-40i64..40, 1i64..12).prop_map(|(n, d)| q(n, d)),
        1 => tiny(),
        3 => big_ratio(),
    ]
}

/// A number in (0, 1], of any size.
pub(crate) fn unit() -> impl Strategy<Value = BigRational> {
    (big(), big()).prop_map(|(n, d)| {
        let (n, d) = (n.magnitude() + 1u32, d.magnitude() + 1u32);
        let (n, d) = if n < d { (n, d) } else { (d, n) };
        BigRational::new(n.into(), d.into())
    })
}

/// A number above zero.
pub(crate) fn positive() -> impl Strategy<Value = BigRational> {
    number().prop_map(|x| if x.is_zero() { q(1, 3) } else { magnitude(&x) })
}

/// A number not below zero, sometimes zero.
pub(crate) fn nonnegative() -> impl Strategy<Value = BigRational> {
    prop_oneof![1 => Just(zero()), 5 => number().prop_map(|x| magnitude(&x))]
}

/// A friction coefficient: beside the critical ½ more often than not.
pub(crate) fn coefficient() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        3 => (0i64..16).prop_map(|n| q(n, 8)),
        1 => tiny().prop_map(|e| half() + e),
        2 => unit(),
        1 => nonnegative(),
    ]
}

/// β and σ.
pub(crate) fn friction() -> impl Strategy<Value = Friction<BigRational>> {
    (coefficient(), coefficient()).prop_map(|(beta, sigma)| Friction::new(beta, sigma))
}

/// A loop with effects of every combination, in any units.
pub(crate) fn a_loop() -> impl Strategy<Value = Loop<BigRational>> {
    let option = |x: BoxedStrategy<BigRational>| prop::option::of(x);
    (
        (positive(), positive(), option(positive().boxed())),
        (
            option(nonnegative().boxed()),
            option(nonnegative().boxed()),
            option(coefficient().boxed()),
        ),
        (option(positive().boxed()), option(positive().boxed())),
        (0u16..4, any::<bool>()),
    )
        .prop_map(
            |(
                (stiffness, period, resolution),
                (viscous, coulomb, damping),
                (force_step, max_force),
                (delay, unilateral),
            )| Loop {
                resolution,
                viscous,
                coulomb,
                damping,
                force_step,
                max_force,
                delay,
                unilateral,
                ..Loop::new(stiffness, period)
            },
        )
}

/// A dimensionless loop with effects of every combination.
pub(crate) fn dimensionless() -> impl Strategy<Value = Loop<BigRational>> {
    (a_loop(), friction()).prop_map(|(the_loop, friction)| Loop {
        stiffness: q(1, 1),
        period: q(1, 1),
        resolution: the_loop.resolution.map(|_| q(1, 1)),
        viscous: Some(friction.beta),
        coulomb: Some(friction.sigma),
        ..the_loop
    })
}

/// Declares tests that are run on many inputs.
macro_rules! sampled {
    ($($(#[$meta:meta])* fn $name:ident($($arg:pat in $strategy:expr),+ $(,)?) $body:block)*) => {$(
        $(#[$meta])*
        #[test]
        fn $name() {
            let name = concat!(module_path!(), "::", stringify!($name));
            crate::common::run(name, file!(), ($($strategy,)+), |($($arg,)+)| {
                $body
                Ok(())
            });
        }
    )*};
}
pub(crate) use sampled;

/// What a test is run on, whatever that is: so the frame is compiled once, and not for each of hundreds of tests.
trait Input: std::fmt::Debug {
    fn into_any(self: Box<Self>) -> Box<dyn Any>;
}

impl<T: std::fmt::Debug + 'static> Input for T {
    fn into_any(self: Box<Self>) -> Box<dyn Any> {
        self
    }
}

/// Runs a test on [`CASES`] inputs and leaves a record where `PASSIVITY_EVIDENCE_DIR` says.
pub(crate) fn run<S: Strategy<Value: 'static> + 'static>(
    name: &str,
    file: &'static str,
    strategy: S,
    test: fn(S::Value) -> Result<(), TestCaseError>,
) {
    let inputs = strategy.prop_map(|value| Box::new(value) as Box<dyn Input>);
    run_on(name, file, &inputs.boxed(), &|input| {
        let value = input.into_any().downcast::<S::Value>();
        test(*value.expect("what the strategy makes"))
    });
}

fn run_on(
    name: &str,
    file: &'static str,
    inputs: &BoxedStrategy<Box<dyn Input>>,
    test: &dyn Fn(Box<dyn Input>) -> Result<(), TestCaseError>,
) {
    let started = Instant::now();
    let asked = |name: &str| {
        let number = |text: String| {
            text.parse::<u32>()
                .unwrap_or_else(|e| panic!("{name}: {e}"))
        };
        std::env::var(name).ok().map(number)
    };
    // Who asks for no shrinking wants to know whether a test fails, not the input on which it does:
    // nothing is kept then.
    let shrink = asked("PROPTEST_MAX_SHRINK_ITERS").unwrap_or(20_000);
    let kept = Box::new(FileFailurePersistence::WithSource("regressions"));
    let config = ProptestConfig {
        cases: asked("PROPTEST_CASES").unwrap_or(CASES * asked("PASSIVITY_TIMES").unwrap_or(1)),
        failure_persistence: (shrink > 0).then_some(kept as _),
        source_file: Some(file),
        test_name: Some(Box::leak(name.to_owned().into_boxed_str())),
        max_shrink_iters: shrink,
        ..ProptestConfig::default()
    };
    let cases = Cell::new(0u64);
    let outcome = TestRunner::new(config).run(inputs, |input| {
        let result = test(input);
        if result.is_ok() {
            cases.set(cases.get() + 1);
        }
        result
    });
    if let Err(error) = outcome {
        panic!("{name}: {error}");
    }
    if let Some(folder) = std::env::var_os("PASSIVITY_EVIDENCE_DIR") {
        record(
            Path::new(&folder),
            name,
            cases.get(),
            started.elapsed().as_secs_f64(),
        );
    }
}

/// Appends one line to `properties.jsonl`: the test and how many inputs it passed on.
fn record(folder: &Path, name: &str, cases: u64, seconds: f64) {
    let name = name.trim_start_matches("properties::");
    let line = format!("{{\"test\":\"{name}\",\"cases\":{cases},\"seconds\":{seconds:.3}}}\n");
    std::fs::create_dir_all(folder).expect("the folder of the evidence");
    OpenOptions::new()
        .create(true)
        .append(true)
        .open(folder.join("properties.jsonl"))
        .and_then(|mut file| file.write_all(line.as_bytes()))
        .expect("the record of a test");
}
