//! What devices and logs that are none of the model are suspected of: what they are is among it.

use passivity_audit::{Number, Reading, Sampled};
use passivity_identify::{Lack, Options, identify};
use passivity_random::Random;

use super::trial::{Device, near, recorded, sketch, trial};
use super::{DEVICE, assert_holds, pushed, quick};

/// Pushed one way, and perhaps the other way.
struct Pushed {
    device: Device,
    push: f64,
    pushed: usize,
    samples: usize,
    back: bool,
}

impl Pushed {
    /// Of a device of the trials.
    fn new(number: u64) -> Self {
        let device = trial(number).device;
        let (pushed, samples) = (15, 300);
        // It coasts to rest in a part of the rest.
        let speed = 60.0 * device.coulomb / device.inertia + 1.0;
        Self {
            device,
            push: device.coulomb + device.viscous * speed + device.inertia * speed / pushed as f64,
            pushed,
            samples,
            back: true,
        }
    }

    /// The force that is logged in a row.
    fn force(&self, row: usize) -> f64 {
        match row {
            _ if row < self.pushed => self.push,
            _ if !self.back => 0.0,
            _ if (150..150 + self.pushed).contains(&row) => -self.push,
            _ => 0.0,
        }
    }

    /// What is logged while another force moves the device.
    fn moved_by(&self, noise: bool, law: impl Fn(usize, i64) -> f64) -> Sampled {
        let even = vec![Number::whole(1); self.samples];
        let mut random = Random::new(17);
        let mut log = recorded(&self.device, 0.4, &even, &mut random, noise, law);
        force_by(&mut log, |row, _| self.force(row));
        log
    }

    fn logged(&self, noise: bool) -> Sampled {
        self.moved_by(noise, |row, _| self.force(row))
    }
}

/// Writes other forces into a log.
fn force_by(log: &mut Sampled, law: impl Fn(usize, f64) -> f64) {
    for (row, force) in log.forces.iter_mut().enumerate() {
        let Reading::Exact(known) = &*force else {
            panic!("forces are exact");
        };
        let known = known.to_rational();
        let near = passivity_scene::number::nearest_f64(&known);
        let other = (law(row, near) * 1e6).round() / 1e6;
        *force = Reading::Exact(Number::from_f64(other).unwrap());
    }
}

/// An encoder that follows only behind a play.
fn behind_play(log: &mut Sampled, forwards: i64, backwards: i64) {
    let mut seen: Option<i64> = None;
    for reading in &mut log.positions {
        let Reading::Count(n) = reading else {
            panic!("positions are counts");
        };
        let now = seen.unwrap_or(*n).max(*n - forwards).min(*n + backwards);
        seen = Some(now);
        *n = now;
    }
}

#[track_caller]
fn suspected(logs: &[Sampled], inertia: f64, of: &str) {
    let found = identify(logs, &sketch(inertia, 0.0), &quick(), |_| true).unwrap();
    let refuted = found.refuted_by.expect(of);
    assert!(refuted.suspicion.contains(of), "{of}: {refuted:?}");
    let alone = "with this the log fits";
    let tried = !of.contains("position") && !of.contains("static") && !of.contains("hand");
    assert_eq!(
        refuted.suspicion.contains(alone),
        tried,
        "{of}: {refuted:?}"
    );
}

/// Devices whose frictions and inertias are decades apart.
const NUMBERS: [u64; 2] = [3, 6];

#[test]
fn the_sign_of_the_force_is_suspected() {
    for number in NUMBERS {
        let pushed = Pushed::new(number);
        let mut log = pushed.logged(true);
        force_by(&mut log, |_, force| -force);
        suspected(&[log], pushed.device.inertia, "a force of the other sign");
    }
}

#[test]
fn a_motion_before_the_first_row_is_suspected() {
    for number in NUMBERS {
        let pushed = Pushed::new(number);
        let mut log = pushed.logged(true);
        log.positions.drain(..5);
        log.forces.drain(..5);
        log.durations.drain(..5);
        suspected(&[log], pushed.device.inertia, "a log must start at rest");
    }
}

#[test]
fn backlash_is_suspected() {
    for (number, play) in NUMBERS.into_iter().zip([[12, 9], [0, 30]]) {
        let pushed = Pushed::new(number);
        let mut log = pushed.logged(false);
        behind_play(&mut log, play[0], play[1]);
        suspected(&[log], pushed.device.inertia, "backlash between");
    }
}

#[test]
fn a_constant_force_is_suspected_in_one_log_and_in_two() {
    for (number, share) in NUMBERS.into_iter().zip([0.4, -0.3]) {
        let mut pushed = Pushed::new(number);
        let bias = share * pushed.device.coulomb;
        let of = |pushed: &Pushed| pushed.moved_by(true, |row, _| pushed.force(row) + bias);
        suspected(&[of(&pushed)], pushed.device.inertia, "a constant force");
        pushed.back = false;
        let there = of(&pushed);
        pushed.push = -pushed.push;
        suspected(
            &[there, of(&pushed)],
            pushed.device.inertia,
            "a constant force",
        );
    }
}

#[test]
fn a_late_force_and_another_inertia_are_suspected() {
    for (number, late) in NUMBERS.into_iter().zip([1_usize, 3]) {
        let pushed = Pushed::new(number);
        let log = pushed.moved_by(true, |row, _| {
            row.checked_sub(late).map_or(0.0, |row| pushed.force(row))
        });
        suspected(&[log], pushed.device.inertia, "later than its own");
        let log = pushed.logged(true);
        suspected(&[log], 1.5 * pushed.device.inertia, "another inertia");
    }
}

#[test]
fn what_no_fit_is_tried_for_is_named_too() {
    for number in NUMBERS {
        let pushed = Pushed::new(number);
        let coulomb = pushed.device.coulomb;
        let cogging = pushed.moved_by(true, |row, count| {
            pushed.force(row) + 0.9 * coulomb * (count as f64 / 40.0).sin()
        });
        suspected(&[cogging], pushed.device.inertia, "depends on the position");
        let hand = pushed.moved_by(true, |row, _| {
            pushed.force(row)
                + if (60..75).contains(&row) {
                    3.0 * coulomb
                } else {
                    0.0
                }
        });
        suspected(&[hand], pushed.device.inertia, "a hand on");
    }
}

#[test]
fn logs_of_the_model_are_not_refuted() {
    for number in 0..6 {
        let pushed = Pushed::new(number);
        for noise in [false, true] {
            let log = pushed.logged(noise);
            let sketch = sketch(pushed.device.inertia, 0.0);
            let found = identify(&[log], &sketch, &quick(), |_| true).unwrap();
            assert!(found.fits(), "{number}: {:?}", found.refuted_by);
        }
    }
}

/// What is suspected where nothing fits a log.
fn suspicion_of(log: Sampled, inertia: f64) -> String {
    let found = identify(&[log], &sketch(inertia, 0.0), &quick(), |_| true).unwrap();
    found.refuted_by.expect("nothing fits").suspicion
}

/// A single wrong count, and rows that are lost without a time.
#[test]
fn errors_of_the_log_are_named() {
    for number in NUMBERS {
        let pushed = Pushed::new(number);
        let mut wrong = pushed.logged(true);
        if let Reading::Count(n) = &mut wrong.positions[100] {
            *n += 5000;
        }
        let suspicion = suspicion_of(wrong, pushed.device.inertia);
        assert!(
            suspicion.starts_with("a wrong count in row 101: without it the log fits"),
            "{number}: {suspicion}"
        );
        let mut lost = pushed.logged(true);
        lost.positions.drain(8..13);
        lost.forces.drain(8..13);
        lost.durations.drain(8..13);
        let suspicion = suspicion_of(lost, pushed.device.inertia);
        let errors = [
            "rows that are lost",
            "wrong times",
            "saturated",
            "`--count-error` (raise it to what",
        ];
        for error in errors {
            assert!(suspicion.contains(error), "{number}: {suspicion}");
        }
    }
}

/// A force that is off by a factor fits as another inertia does, with friction that is off as much.
#[test]
fn a_scale_of_the_force_is_told_by_the_inertia_or_by_somebody() {
    let right = [pushed(12.0, 20, 300, 1), pushed(-20.0, 20, 300, 2)];
    let scaled = right.clone().map(|mut log| {
        for force in &mut log.forces {
            let Reading::Exact(x) = force else { continue };
            *x = Number::from_f64(1.15 * near(x)).unwrap();
        }
        log
    });
    let known = |logs: &[Sampled], tolerance: f64, scale_error: Option<f64>| {
        let options = Options {
            scale_error,
            ..quick()
        };
        identify(logs, &sketch(20.0, tolerance), &options, |_| true).unwrap()
    };
    // An inertia that is known tells it, and one that is known to some per cent does not.
    assert!(!known(&scaled, 0.0, None).fits());
    assert!(!known(&right, 0.0, None).lacks.contains(&Lack::Scale));
    for logs in [&scaled, &right] {
        let found = known(logs, 20.0, None);
        assert!(found.fits() && found.lacks.contains(&Lack::Scale) && !found.doubts().is_empty());
    }
    // 1/1.15 is 13.04 % less than one.
    for tolerance in [0.0, 20.0] {
        let found = known(&scaled, tolerance, Some(0.1305));
        assert_holds(&found, &DEVICE, 0);
        assert!(!found.lacks.contains(&Lack::Scale));
    }
    assert!(!known(&scaled, 0.0, Some(0.1)).fits());
    for wrong in [-0.1, 1.0, f64::NAN, f64::INFINITY] {
        let options = Options {
            scale_error: Some(wrong),
            ..quick()
        };
        let error = identify(&right, &sketch(20.0, 0.0), &options, |_| true).unwrap_err();
        let says = format!(
            "the error of the scale: expected a share of the force, from 0 to below 1, found {wrong}"
        );
        assert_eq!(error.to_string(), says);
    }
}

/// Of a device that is stopped within a row the inertia shows nothing, however well it is known, and tells no factor of the force.
#[test]
fn a_scale_of_the_force_is_not_told_by_an_inertia_that_does_not_show() {
    let device = Device {
        viscous: 1.0,
        coulomb: 5.0,
        inertia: 0.1,
    };
    let mut random = Random::new(8);
    let both_ways = |row, _| match row {
        0..20 => 1.15 * 25.0,
        60..80 => 1.15 * -15.0,
        _ => 0.0,
    };
    let stronger = Device {
        viscous: 1.15 * device.viscous,
        coulomb: 1.15 * device.coulomb,
        inertia: 1.15 * device.inertia,
    };
    let even = vec![Number::whole(1); 120];
    // What moves like this device under forces that are less by the factor.
    let log = recorded(&stronger, 0.3, &even, &mut random, true, both_ways);
    let found = identify(&[log], &sketch(device.inertia, 0.0), &quick(), |_| true).unwrap();
    assert!(
        found.fits() && found.lacks.contains(&Lack::Scale),
        "{found:?}"
    );
}
