//! TH-IDENT: the box holds what is true, a log that fits nothing is refuted at its place, and one that says
//! little says what it lacks.

#[path = "trial/estimates.rs"]
mod estimates;
#[path = "trial/misfits.rs"]
mod misfits;
mod trial;

use passivity_audit::Number;
use passivity_core::Parameter;
use passivity_identify::{Bounds, Identified, Inertia, Lack, Options, Sampled, identify};
use passivity_random::Random;
use trial::{Device, recorded, sketch, trial};

/// So much work that a debug build takes a fraction of a second for a log: the box is as sure.
fn quick() -> Options {
    Options {
        effort: 600_000,
        ..Options::default()
    }
}

fn run(logs: &[Sampled], device: &Device) -> Identified {
    identify(logs, &sketch(device.inertia, 0.0), &quick(), |_| true).unwrap()
}

fn bounds(found: &Identified, parameter: Parameter) -> Bounds {
    let known = found
        .parameters
        .iter()
        .find(|(which, _)| *which == parameter);
    known
        .unwrap_or_else(|| panic!("{parameter:?} in {found:?}"))
        .1
}

fn assert_holds(found: &Identified, device: &Device, what: u64) {
    let truth = [device.viscous, device.coulomb, device.inertia];
    assert!(found.fits(), "{what}: {:?}", found.refuted_by);
    for ((parameter, bounds), truth) in found.parameters.iter().zip(truth) {
        let hi = bounds.hi.unwrap_or(f64::INFINITY);
        assert!(
            bounds.lo <= truth && truth <= hi,
            "{what}: {parameter:?} {truth} {bounds:?}"
        );
        if let Some(best) = bounds.best {
            assert!(
                bounds.lo <= best && best <= hi,
                "{what}: {parameter:?} {bounds:?}"
            );
        }
        if found.is_informative() {
            let off = bounds.best.unwrap() / truth - 1.0;
            assert!(off.abs() < 0.05, "{what}: {parameter:?} {truth} {bounds:?}");
        }
    }
}

/// The first 32 of the devices of which `examples/table.rs` runs 200.
#[test]
fn th_ident_the_true_values_are_inside() {
    let mut informative = 0;
    let mut kinds = std::collections::BTreeSet::new();
    for number in 0..32 {
        let trial = trial(number);
        kinds.insert(trial.kind);
        let found = run(std::slice::from_ref(&trial.log), &trial.device);
        assert_holds(&found, &trial.device, number);
        let best = |parameter| bounds(&found, parameter).best.unwrap();
        let device = Device {
            viscous: best(Parameter::Viscous),
            coulomb: best(Parameter::Coulomb),
            ..trial.device
        };
        let spread = estimates::spread(&device, &trial.log);
        assert!(
            !found.best_refuted && spread <= 3.0 + estimates::ROUNDING,
            "{number}: {spread} {:?}",
            found.parameters
        );
        informative += u32::from(found.is_informative());
        if trial.kind != trial::Kind::Swing {
            assert!(!found.lacks.contains(&Lack::Row), "{number}: {found:?}");
        }
    }
    assert!(informative >= 20, "{informative}");
    assert_eq!(kinds.len(), trial::KINDS.len());
}

#[test]
fn th_ident_an_inertia_within_a_tolerance_or_unknown_is_held_too() {
    for number in [0, 1, 2, 5, 9] {
        let trial = trial(number);
        let mut device = trial.device;
        let near = sketch(device.inertia * 1.15, 20.0);
        let found = identify(std::slice::from_ref(&trial.log), &near, &quick(), |_| true).unwrap();
        assert_eq!(found.parameters.len(), 2);
        assert_holds(&found, &device, number);
        let free = Options {
            inertia: Inertia::Free,
            ..quick()
        };
        let found = identify(&[trial.log], &sketch(1.0, 0.0), &free, |_| true).unwrap();
        assert_eq!(found.parameters.len(), 3);
        if found.stopped_early && !found.is_informative() {
            assert_eq!(found.lacks[0], Lack::Inertia);
        }
        // What is true of the device, not of the sketch.
        device.inertia = trial.device.inertia;
        assert_holds(&found, &device, number);
    }
}

const DEVICE: Device = Device {
    viscous: 0.05,
    coulomb: 2.0,
    inertia: 20.0,
};

fn even(samples: usize) -> Vec<Number> {
    vec![Number::whole(1); samples]
}

fn pushed(force: f64, pushed: usize, samples: usize, seed: u64) -> Sampled {
    let mut random = Random::new(seed);
    recorded(&DEVICE, 0.3, &even(samples), &mut random, true, |row, _| {
        if row < pushed { force } else { 0.0 }
    })
}

#[test]
fn several_logs_narrow_the_box() {
    let (first, second) = (pushed(12.0, 20, 300, 1), pushed(30.0, 20, 500, 2));
    let alone = run(std::slice::from_ref(&first), &DEVICE);
    let both = run(&[first, second], &DEVICE);
    assert_holds(&alone, &DEVICE, 0);
    assert_holds(&both, &DEVICE, 1);
    assert_eq!(both.samples, 301 + 501);
    for parameter in [Parameter::Viscous, Parameter::Coulomb] {
        let width = |found| {
            let bounds: Bounds = bounds(found, parameter);
            bounds.hi.unwrap() - bounds.lo
        };
        assert!(width(&both) < 0.7 * width(&alone), "{parameter:?}");
    }
}

#[test]
fn a_log_says_what_it_lacks() {
    let lacks = |log: Sampled| {
        let found = run(&[log], &DEVICE);
        assert_holds(&found, &DEVICE, 0);
        assert!(!found.is_informative());
        found.lacks
    };
    let still = |_, _| 0.0;
    let mut random = Random::new(3);
    let log = recorded(&DEVICE, 0.0, &even(50), &mut random, true, still);
    assert_eq!(lacks(log), [Lack::Force]);
    // Below Coulomb friction.
    let log = recorded(&DEVICE, 0.0, &even(50), &mut random, true, |_, _| 1.9);
    assert_eq!(lacks(log), [Lack::Motion]);
    let found = lacks(pushed(6.0, 10, 60, 4));
    assert!(
        matches!(found[..], [Lack::Way { ticks }, ..] if ticks < 100.0),
        "{found:?}"
    );
    // One speed, from the first samples on: 2 + 0.05·v = 2.4.
    let log = recorded(&DEVICE, 0.0, &even(60), &mut random, true, |row, _| {
        if row == 0 { 2.4 + 160.0 } else { 2.4 }
    });
    let found = lacks(log);
    assert!(
        found.contains(&Lack::Coasting) && found.contains(&Lack::Speeds),
        "{found:?}"
    );
    for lack in found {
        assert!(lack.to_string().len() > 30);
    }
}

#[test]
fn nothing_bounds_the_friction_of_a_device_that_stays() {
    let mut random = Random::new(3);
    let log = recorded(&DEVICE, 0.0, &even(50), &mut random, true, |_, _| 1.0);
    let found = run(&[log], &DEVICE);
    let viscous = bounds(&found, Parameter::Viscous);
    assert_eq!((viscous.lo, viscous.hi, viscous.best), (0.0, None, None));
    assert!(found.fits() && !found.is_bounded());
}

/// A device whose encoder sits behind a play of some ticks.
#[test]
fn backlash_is_refuted_after_the_reversal() {
    let mut random = Random::new(7);
    let mut log = recorded(
        &DEVICE,
        0.0,
        &even(500),
        &mut random,
        false,
        |row, _| match row {
            0..30 => 20.0,
            250..280 => -20.0,
            _ => 0.0,
        },
    );
    // Pushed forwards the play is taken up; backwards the encoder stays behind by it.
    let play = 30;
    let mut seen = i64::MIN;
    for reading in &mut log.positions {
        if let passivity_audit::Reading::Count(n) = reading {
            seen = seen.max(*n).min(*n + play);
            *n = seen;
        }
    }
    let found = run(&[log], &DEVICE);
    let refuted = found.refuted_by.clone().expect("nothing fits");
    assert!((250..450).contains(&refuted.row), "{refuted:?}");
    assert!(
        (refuted.time - (refuted.row - 1) as f64).abs() < 1e-6,
        "{refuted:?}"
    );
    assert!(refuted.suspicion.contains("backlash"), "{refuted:?}");
    assert!(found.parameters.is_empty() && !found.is_bounded());
}

#[test]
fn friction_that_depends_on_the_position_is_refuted() {
    let mut random = Random::new(8);
    // Cogging, as a force that the log does not have.
    let mut log = recorded(&DEVICE, 0.0, &even(400), &mut random, true, |row, count| {
        let push = if row < 30 { 20.0 } else { 0.0 };
        push + 1.5 * (count as f64 / 40.0).sin()
    });
    for (row, force) in log.forces.iter_mut().enumerate() {
        let push = if row < 30 { 20 } else { 0 };
        *force = passivity_audit::Reading::Exact(Number::whole(push));
    }
    let found = run(&[log], &DEVICE);
    let refuted = found.refuted_by.expect("nothing fits");
    assert!(refuted.suspicion.contains("cogging"), "{refuted:?}");
}

#[test]
fn a_log_that_does_not_start_at_rest_is_refused() {
    let mut log = pushed(20.0, 20, 200, 9);
    log.positions.drain(..30);
    log.forces.drain(..30);
    log.durations.drain(..30);
    let refused = identify(&[log], &sketch(20.0, 0.0), &quick(), |_| true);
    let message = refused.unwrap_err().to_string();
    assert!(message.contains("before there is a force"), "{message}");
}

#[test]
fn a_log_that_does_not_start_at_rest_is_refuted_where_the_force_may_be_off() {
    let mut log = pushed(20.0, 20, 200, 9);
    log.positions.drain(..30);
    log.forces.drain(..30);
    log.durations.drain(..30);
    let options = Options {
        force_error: 1e-3,
        ..quick()
    };
    let found = identify(&[log], &sketch(20.0, 0.0), &options, |_| true).unwrap();
    let suspicion = found.refuted_by.unwrap().suspicion;
    assert!(suspicion.contains("before there is a force"), "{suspicion}");
}

/// A force error above the whole force: the device may have moved before there was one in the log.
#[test]
fn a_force_error_refuses_no_log_that_starts_at_rest() {
    let mut random = Random::new(5);
    let log = recorded(
        &DEVICE,
        0.3,
        &even(300),
        &mut random,
        true,
        |row, _| match row {
            0..60 => 0.1 * row as f64,
            _ => 0.0,
        },
    );
    for force_error in [5.0, 7.0] {
        let options = Options {
            force_error,
            ..quick()
        };
        let found = identify(
            std::slice::from_ref(&log),
            &sketch(20.0, 0.0),
            &options,
            |_| true,
        );
        assert_holds(&found.unwrap(), &DEVICE, 0);
    }
}

/// Pushed with a constant force of its own that the log does not have.
fn biased(bias: f64, push: f64) -> Sampled {
    let pushes = |row| if row < 20 { push } else { 0.0 };
    let mut random = Random::new(6);
    let mut log = recorded(&DEVICE, 0.3, &even(300), &mut random, true, |row, _| {
        pushes(row) + bias
    });
    for (row, force) in log.forces.iter_mut().enumerate() {
        *force = passivity_audit::Reading::Exact(Number::from_f64(pushes(row)).unwrap());
    }
    log
}

#[test]
fn a_constant_force_is_told_from_friction_by_motion_both_ways_only() {
    let (there, back) = (biased(-0.5, 20.0), biased(-0.5, -20.0));
    let one = run(std::slice::from_ref(&there), &DEVICE);
    let coulomb = bounds(&one, Parameter::Coulomb);
    assert!(one.fits() && coulomb.lo > DEVICE.coulomb, "{coulomb:?}");
    assert!(one.lacks.contains(&Lack::OtherWay), "{:?}", one.lacks);
    let both = run(&[there, back], &DEVICE);
    let refuted = both.refuted_by.expect("nothing fits");
    assert_eq!(refuted.log, 1, "{refuted:?}");
    let both = run(&[biased(0.0, 20.0), biased(0.0, -20.0)], &DEVICE);
    assert_holds(&both, &DEVICE, 0);
    assert!(!both.lacks.contains(&Lack::OtherWay), "{:?}", both.lacks);
}

/// The same log with each force a row later, as where a program logs the force of the last sample.
fn logged_late(mut log: Sampled) -> Sampled {
    let first = log.forces.first().cloned();
    log.forces.pop();
    log.forces.splice(..0, first);
    log
}

/// Let go away from zero, under a spring force.
fn swing(seed: u64) -> Sampled {
    let mut random = Random::new(seed);
    recorded(&DEVICE, 400.3, &even(400), &mut random, false, |_, n| {
        -0.025 * n as f64
    })
}

#[test]
fn a_force_in_the_wrong_row_is_told_from_friction_by_pushes_not_by_a_swing() {
    for seed in 1..4 {
        let wrong = run(&[logged_late(swing(seed))], &DEVICE);
        let viscous = bounds(&wrong, Parameter::Viscous);
        assert!(viscous.lo > DEVICE.viscous, "{viscous:?}");
        assert!(wrong.lacks.contains(&Lack::Row), "{:?}", wrong.lacks);
    }
    let pushes = [pushed(30.0, 20, 500, 2), pushed(-30.0, 20, 500, 3)];
    let right = run(&[vec![swing(1)], pushes.to_vec()].concat(), &DEVICE);
    assert_holds(&right, &DEVICE, 0);
    assert!(right.lacks.is_empty(), "{:?}", right.lacks);
    let late = [vec![swing(1)], pushes.to_vec()].concat();
    let late: Vec<Sampled> = late.into_iter().map(logged_late).collect();
    assert!(!run(&late, &DEVICE).fits());
}

#[test]
fn an_error_of_the_force_that_makes_the_box_wide_is_named() {
    let log = pushed(12.0, 20, 300, 1);
    let options = Options {
        force_error: 0.3,
        ..quick()
    };
    let found = identify(&[log], &sketch(20.0, 0.0), &options, |_| true).unwrap();
    assert!(!found.is_informative());
    assert!(found.lacks.contains(&Lack::ForceError), "{:?}", found.lacks);
    // It coasts at a logged force of zero.
    assert!(!found.lacks.contains(&Lack::Coasting), "{:?}", found.lacks);
}

/// The ends of forces that are no whole numbers are some roundings apart, beside which the best viscous friction may be
/// nothing.
#[test]
fn a_rounding_of_the_force_is_no_error_of_it() {
    let device = Device {
        viscous: 0.1,
        coulomb: 1.0,
        inertia: 110.0,
    };
    for seed in 0..3 {
        let mut random = Random::new(seed);
        let pushes = |row, _| match row {
            0..15 => 2.8,
            200..215 => -2.8,
            _ => 0.0,
        };
        let log = recorded(
            &device,
            0.15 * seed as f64,
            &even(400),
            &mut random,
            false,
            pushes,
        );
        let found = run(&[log], &device);
        assert!(!found.is_informative());
        assert!(!found.lacks.contains(&Lack::ForceError), "{found:?}");
    }
}

#[test]
fn the_error_of_the_force_is_taken_into_account() {
    let log = pushed(12.0, 20, 300, 1);
    let exact = run(std::slice::from_ref(&log), &DEVICE);
    let loose = Options {
        force_error: 0.05,
        ..quick()
    };
    let loose = identify(&[log], &sketch(20.0, 0.0), &loose, |_| true).unwrap();
    let width = |found: &Identified| {
        let coulomb = bounds(found, Parameter::Coulomb);
        coulomb.hi.unwrap() - coulomb.lo
    };
    assert_holds(&loose, &DEVICE, 0);
    assert!(width(&loose) > width(&exact) + 0.05);
}

#[test]
fn a_search_that_is_stopped_has_bounds_that_are_wider_and_as_sure() {
    let log = pushed(12.0, 20, 300, 1);
    let whole = run(std::slice::from_ref(&log), &DEVICE);
    let mut told = 0;
    let stopped = identify(&[log], &sketch(20.0, 0.0), &quick(), |_| {
        told += 1;
        told < 20
    });
    let stopped = stopped.unwrap();
    assert_eq!(told, 20);
    assert!(stopped.stopped_early);
    assert_holds(&stopped, &DEVICE, 0);
    // It is not the log that is to blame.
    assert_eq!(stopped.lacks.first(), Some(&Lack::Effort));
    assert!(!stopped.lacks.contains(&Lack::Length), "{stopped:?}");
    for parameter in [Parameter::Viscous, Parameter::Coulomb] {
        let [whole, stopped] = [&whole, &stopped].map(|found| bounds(found, parameter));
        assert!(stopped.lo <= whole.lo && stopped.hi.is_none_or(|hi| whole.hi.unwrap() <= hi));
    }
}
