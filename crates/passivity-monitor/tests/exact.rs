//! The monitor against the exact account of the kernel, and against every corner of the ticks.

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{BigRational, Friction, Loop, Scalar, Step};
use passivity_monitor::{Answer, Config, Given, Monitor, Width};
use passivity_random::draws;
use proptest::prelude::*;

fn whole(n: i64) -> BigRational {
    BigRational::from_integer(n.into())
}

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// A sample of a motion: count, where within the tick in sixteenths, and the force held from then on.
type Sample = (i64, i64, i64);

/// Friction that the device has, in units of force.
#[derive(Clone, Copy, Debug)]
struct Device {
    stiffness: i64,
    viscous: i64,
    coulomb: i64,
}

/// What was given at each sample beyond what was stored at the start, in halves of a unit of force
/// times a tick: by the kernel's row with the force that was held.
fn exact(device: &Device, samples: &[Sample]) -> Vec<BigRational> {
    let stiffness = whole(device.stiffness);
    let of_k = |n: i64| whole(n).over(stiffness.clone());
    let friction = Friction::new(of_k(device.viscous), of_k(device.coulomb));
    let plain = Loop::plain(friction);
    let position = |(count, within, _): &Sample| whole(*count) + ratio(*within, 16);
    let potential = |xi: &BigRational| plain.law().potential(xi);
    // What is left of the energy stored at the start: V(ξ_h) + Σ net energy (TH-RUN).
    let mut net = BigRational::zero();
    let mut given = Vec::new();
    for (i, sample) in samples.iter().enumerate() {
        if let Some(before) = i.checked_sub(1).map(|i| &samples[i]) {
            let interval = HeldInterval {
                step: Step::new(position(before), position(sample)),
                force: of_k(before.2),
                dtau: BigRational::one(),
                extra_storage: None,
            };
            net += ledger::row(&plain, &interval).net_linear;
        }
        let left = net.clone() + potential(&position(sample));
        given.push(-left * (stiffness.clone() + stiffness.clone()));
    }
    given
}

/// The bounds of the monitor at each sample, and its answer at the end.
fn watched<W: Width>(config: Config, samples: &[Sample]) -> (Vec<Given<W>>, Answer)
where
    W::Input: From<i32>,
{
    let input = |n: i64| i32::try_from(n).expect("the numbers are small").into();
    let [first, rest @ ..] = samples else {
        panic!("there is a sample");
    };
    let mut monitor = Monitor::<W>::start(config, input(first.0), input(first.2));
    let given = |monitor: &Monitor<W>| monitor.given().expect("the numbers are small");
    let mut bounds = vec![given(&monitor)];
    for (count, _, force) in rest {
        monitor.sample(input(*count), input(*force));
        bounds.push(given(&monitor));
    }
    (bounds, monitor.answer())
}

fn device() -> impl Strategy<Value = Device> {
    (1..40_i64, 0..40_i64, 0..40_i64).prop_map(|(stiffness, viscous, coulomb)| Device {
        stiffness,
        viscous,
        coulomb,
    })
}

fn samples(length: usize) -> impl Strategy<Value = Vec<Sample>> {
    let sample = (-4..5_i64, 0..16_i64, -60..61_i64, any::<bool>());
    prop::collection::vec(sample, 1..length).prop_map(|drawn| {
        let mut at = 0;
        let mut samples = Vec::new();
        for (ticks, within, force, stays) in drawn {
            at += if stays { ticks.signum() } else { ticks };
            samples.push((at, within, force));
        }
        samples
    })
}

fn config(device: &Device) -> Config {
    Config::new(device.stiffness, device.viscous, device.coulomb).expect("in range")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(100)))]

    /// TH-MONITOR: whatever was between the ticks, the exact account lies within the bounds, and no
    /// answer contradicts it; both widths say the same.
    #[test]
    fn th_monitor_holds_the_exact_account(device in device(), samples in samples(40)) {
        let given = exact(&device, &samples);
        let (bounds, answer) = watched::<i64>(config(&device), &samples);
        for (given, bounds) in given.iter().zip(&bounds) {
            prop_assert!(whole(bounds.least) <= *given && *given <= whole(bounds.most));
        }
        let zero = BigRational::zero();
        match answer {
            Answer::SurelyPassive => prop_assert!(given.iter().all(|given| *given <= zero)),
            Answer::SurelyActive => prop_assert!(given.iter().any(|given| *given > zero)),
            Answer::Open => {}
            Answer::Unknown => prop_assert!(false, "the numbers are small"),
        }
        let (wide, wide_answer) = watched::<i128>(config(&device), &samples);
        prop_assert_eq!(answer, wide_answer);
        for (narrow, wide) in bounds.iter().zip(&wide) {
            prop_assert_eq!(i128::from(narrow.least), wide.least);
            prop_assert_eq!(i128::from(narrow.most), wide.most);
        }
    }

    /// TH-MONITOR: the least that was given is reached by a motion with these counts, with every
    /// position at an end of its tick: so it is told when more was given at one and the same sample, wherever the
    /// positions were.
    #[test]
    fn th_monitor_least_is_reached(device in device(), samples in samples(8)) {
        let (bounds, _) = watched::<i64>(config(&device), &samples);
        let mut least: Option<BigRational> = None;
        for corner in 0..1_u32 << samples.len() {
            let at_ends: Vec<Sample> = samples
                .iter()
                .enumerate()
                .map(|(i, (count, _, force))| (*count, if corner >> i & 1 == 1 { 16 } else { 0 }, *force))
                .collect();
            let given = exact(&device, &at_ends).pop().expect("there is a sample");
            least = Some(least.map_or(given.clone(), |least| Ord::min(least, given.clone())));
        }
        let last = bounds.last().expect("there is a sample");
        prop_assert_eq!(least, Some(whole(last.least)));
    }

    /// TH-MONITOR: where b ≥ KT/2 and c ≥ KΔ/2, a loop under the wall's own force is surely passive, for ever.
    #[test]
    fn th_monitor_calls_a_passive_wall_passive(
        half in 1..20_i64,
        spare in prop::array::uniform2(0..3_i64),
        samples in samples(60),
    ) {
        let device = Device {
            stiffness: 2 * half,
            viscous: half + spare[0],
            coulomb: half + spare[1],
        };
        let own = |(count, within, _): &Sample| (*count, *within, -(2 * half * count + half));
        let samples: Vec<Sample> = samples.iter().map(own).collect();
        prop_assert_eq!(watched::<i64>(config(&device), &samples).1, Answer::SurelyPassive);
    }

    /// TH-MONITOR: so is a loop with a wall on one side, where the device starts outside of it and nothing
    /// is stored.
    #[test]
    fn th_monitor_calls_a_one_sided_wall_passive(
        half in 1..20_i64,
        spare in prop::array::uniform2(0..3_i64),
        outside in 1..10_i64,
        samples in samples(60),
    ) {
        let (viscous, coulomb) = (half + spare[0], half + spare[1]);
        let own = |(count, within, _): &Sample| {
            let count = count - outside;
            (count, *within, -(2 * half * count + half).max(0))
        };
        let samples: Vec<Sample> = samples.iter().map(own).collect();
        prop_assume!(samples[0].0 < 0);
        let config = Config::new(2 * half, viscous, coulomb).expect("in range");
        let config = config.with_stored_at_start(0).expect("in range");
        prop_assert_eq!(watched::<i64>(config, &samples).1, Answer::SurelyPassive);
    }

    /// TH-MONITOR: friction that may be more makes the least that was given smaller, and nothing else.
    #[test]
    fn th_monitor_of_uncertain_friction_holds_both_ends(
        device in device(),
        more in prop::array::uniform2(0..20_i64),
        samples in samples(30),
    ) {
        let most = Device {
            viscous: device.viscous + more[0],
            coulomb: device.coulomb + more[1],
            ..device
        };
        let between = config(&device).with_friction_at_most(most.viscous, most.coulomb);
        let (bounds, _) = watched::<i64>(between.expect("in range"), &samples);
        let (at_least, _) = watched::<i64>(config(&device), &samples);
        let (at_most, _) = watched::<i64>(config(&most), &samples);
        for (bounds, (low, high)) in bounds.iter().zip(at_least.iter().zip(&at_most)) {
            prop_assert_eq!(bounds.most, low.most);
            prop_assert_eq!(bounds.least, high.least);
        }
    }
}
