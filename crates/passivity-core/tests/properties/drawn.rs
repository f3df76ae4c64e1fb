//! TH-LTI, TH-LATENCY: motions that draw energy, with what is not known of the forces taken from their gain.

use std::sync::Arc;

use passivity_core::actuator::Actuator;
use passivity_core::drawn::{Drawn, Search};
use passivity_core::linear_part::{Command, LinearPart};
use passivity_core::periodic::Motion;
use passivity_core::wave::Wave;
use passivity_core::{BigRational, Friction, Interval};

use crate::common::{half, magnitude, q, zero};
use crate::transfer::Controller;

type Range = Interval<BigRational>;

/// A number and what it may be off by.
fn about(x: BigRational, off: &BigRational) -> Range {
    Interval::hull(&x - off, x + off)
}

/// 1 + B(1 − z⁻¹) behind a delay.
fn damped(damping: Range, delay: u16) -> LinearPart {
    LinearPart {
        command: Command::Spring {
            damping,
            pole: Interval::point(zero()),
        },
        delay,
        actuator: None,
        linear: true,
    }
}

/// Without an encoder and without bounds.
fn search<'a>(part: &'a LinearPart, friction: &'a Friction<BigRational>) -> Search<'a> {
    Search {
        part,
        friction,
        encoder: false,
        force_step: None,
        max_force: None,
        speed_bound: None,
    }
}

fn motion(search: &Search<'_>) -> Option<Motion<BigRational>> {
    match search.find()? {
        Drawn::Motion(motion) => Some(motion),
        Drawn::Wave(_) => None,
    }
}

/// The largest change from one to the next round a period.
fn change(values: &[BigRational]) -> BigRational {
    let before = values.iter().cycle().skip(values.len() - 1);
    values
        .iter()
        .zip(before)
        .map(|(x, y)| magnitude(&(x - y)))
        .max()
        .unwrap()
}

/// The forces from B known to within `off`, and held half a sample late to within `late`: each may be off by
/// e = off·|ΔQ| + δ/2, and for how late it is by late·(|ΔF| + 2e) more.
#[test]
fn th_latency_drawn_gain_by_hand() {
    let friction = Friction::new(q(1, 10), q(1, 1000));
    for (b, off, step, late) in [
        (q(1, 3), zero(), None, zero()),
        (zero(), zero(), None, q(1, 100)),
        (q(1, 3), zero(), Some([q(1, 50), q(1, 25)]), zero()),
        (q(1, 3), q(1, 200), None, zero()),
        (q(2, 3), q(1, 200), Some([q(1, 25), q(1, 25)]), zero()),
        (q(1, 3), q(1, 200), Some([q(1, 50), q(1, 25)]), q(1, 100)),
    ] {
        let part = LinearPart {
            actuator: Some(Actuator {
                latency: about(half(), &late),
                time_constant: Interval::point(zero()),
            }),
            ..damped(about(b.clone(), &off), 0)
        };
        let step_range = step.clone().map(|[lo, hi]| Interval::hull(lo, hi));
        let mut search = search(&part, &friction);
        search.force_step = step_range.as_ref();
        let found = motion(&search).unwrap();
        let positions = &found.positions;
        let n = positions.len();
        let force = |h: usize| {
            let before = &positions[(h + n - 1) % n];
            -(&positions[h] + &b * (&positions[h] - before))
        };
        let forces: Vec<BigRational> = (0..n).map(force).collect();
        let rounding = step.map_or_else(zero, |[_, hi]| hi * half());
        let error = off * change(positions) + rounding;
        let all = &error + &late * (change(&forces) + &error * q(2, 1));
        let mut gain = zero();
        for h in 0..n {
            let way = &positions[(h + 1) % n] - &positions[h];
            let mean = (&forces[h] + &forces[(h + n - 1) % n]) * half();
            let spent = &friction.beta * &way * &way + (&friction.sigma + &all) * magnitude(&way);
            gain += mean * way - spent;
        }
        assert!(gain > zero());
        assert_eq!(found.gain, gain);
        // The actuator has to give the largest force, whatever it is off by.
        let largest = forces.iter().map(magnitude).max().unwrap() + error;
        let less = &largest - q(1, 1_000_000);
        for (most, enough) in [(&largest, true), (&less, false)] {
            search.max_force = Some(most);
            assert_eq!(motion(&search), enough.then(|| found.clone()));
        }
    }
}

/// So little below λ(0) = 3/2 that no motion is short enough to be written down: a formula draws energy from a
/// force that is linear and known exactly, and from no other.
#[test]
fn th_lti_drawn_waves_are_of_exact_forces() {
    let little = q(1, 1_000_000_000);
    let friction = Friction::new(q(3, 2) - &little, q(1, 2));
    let exact = damped(Interval::point(zero()), 1);
    let late = |off: BigRational| LinearPart {
        actuator: Some(Actuator {
            latency: about(q(1, 1), &off),
            time_constant: Interval::point(zero()),
        }),
        ..damped(Interval::point(zero()), 0)
    };
    let wave = |sigma: BigRational| {
        let friction = Friction::new(friction.beta.clone(), sigma);
        Wave::of(&Controller::wall().delayed(1), &friction).map(Drawn::Wave)
    };
    assert!(wave(half()).is_some());
    for part in [&exact, &late(zero())] {
        let mut search = search(part, &friction);
        assert_eq!(search.find(), wave(half()));
        // What a converter rounds at most, which its largest step says.
        let step = Interval::hull(q(1, 8), q(1, 4));
        search.force_step = Some(&step);
        assert_eq!(search.find(), wave(half() + q(1, 8)));
        search.force_step = None;
        let most = q(1_000_000_000, 1);
        search.max_force = Some(&most);
        assert_eq!(search.find(), None);
        search.max_force = None;
        search.speed_bound = Some(&most);
        assert_eq!(search.find(), None);
    }
    for part in [&damped(about(q(1, 100), &q(1, 100)), 1), &late(q(1, 1000))] {
        assert_eq!(search(part, &friction).find(), None);
    }
}

/// Of a law with fractions: H(1) = 5/12 and g₁ = −1/3.
#[test]
fn th_lti_drawn_gain_of_a_controller_by_hand() {
    let law = Controller::new([q(3, 4), q(-1, 3)], [q(1, 1)]).unwrap();
    let friction = Friction::new(q(1, 10), q(1, 1000));
    let part = LinearPart {
        command: Command::Controller(Arc::new(law)),
        ..damped(Interval::point(zero()), 0)
    };
    let found = motion(&search(&part, &friction)).unwrap();
    let positions = &found.positions;
    let n = positions.len();
    let gained = (0..n).map(|h| {
        let before = &positions[(h + n - 1) % n];
        let force = q(1, 3) * before - q(3, 4) * &positions[h];
        let way = &positions[(h + 1) % n] - &positions[h];
        force * &way - &friction.beta * &way * &way - &friction.sigma * magnitude(&way)
    });
    assert_eq!(found.gain, gained.fold(zero(), |sum, gain| sum + gain));
    assert!(found.gain > zero());
}
