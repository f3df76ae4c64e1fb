//! Simulated experiments: devices over decades, pushed in four ways, recorded by an encoder whose counts are
//! off by up to a tick.

use passivity_audit::{Number, Reading, Sampled};
use passivity_random::Random;
use passivity_scene::Scene;

/// A device, dimensionless.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Device {
    pub(crate) viscous: f64,
    pub(crate) coulomb: f64,
    pub(crate) inertia: f64,
}

/// How it is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    PushAndCoast,
    BothWays,
    Ramp,
    Swing,
}

pub(crate) const KINDS: [Kind; 4] = [Kind::PushAndCoast, Kind::BothWays, Kind::Ramp, Kind::Swing];

/// An experiment and what is true of its device.
pub(crate) struct Trial {
    pub(crate) device: Device,
    pub(crate) kind: Kind,
    pub(crate) log: Sampled,
}

impl Device {
    /// Position and velocity after a time under a constant force: the closed form, in doubles, with its
    /// stops. Written without the library's motion.
    pub(crate) fn moved(&self, [mut x, mut v]: [f64; 2], force: f64, mut time: f64) -> [f64; 2] {
        while time > 0.0 {
            let direction = if v != 0.0 { v.signum() } else { force.signum() };
            if v == 0.0 && force.abs() <= self.coulomb {
                return [x, v];
            }
            let drive = force - direction * self.coulomb;
            let (a, rate) = (drive / self.inertia, self.viscous / self.inertia);
            let stop = match v * a < 0.0 {
                true if rate * v.abs() < 1e-9 * a.abs() => -v / a,
                true => (-rate * v / a).ln_1p() / rate,
                false => f64::INFINITY,
            };
            let step = stop.min(time);
            let z = rate * step;
            let (first, second) = match z < 1e-4 {
                true => (
                    step * (1.0 - z / 2.0 + z * z / 6.0),
                    step * step * (0.5 - z / 6.0 + z * z / 24.0),
                ),
                false => {
                    let first = -(-z).exp_m1() / rate;
                    (first, (step - first) / rate)
                }
            };
            x += first * v + second * a;
            v = if stop <= time {
                0.0
            } else {
                v + first * (a - rate * v)
            };
            time -= step;
        }
        [x, v]
    }
}

/// Records a device under the forces that `law` gives from the sample's number and count.
pub(crate) fn recorded(
    device: &Device,
    start: f64,
    durations: &[Number],
    random: &mut Random,
    noise: bool,
    law: impl Fn(usize, i64) -> f64,
) -> Sampled {
    let mut state = [start, 0.0];
    let mut log = Sampled::default();
    for row in 0..=durations.len() {
        let off = if noise { random.below(3) as i64 - 1 } else { 0 };
        let count = state[0].floor() as i64 + off;
        // A force of some digits, as a log has it.
        let force = (law(row, count) * 1e6).round() / 1e6;
        log.positions.push(Reading::Count(count));
        log.forces
            .push(Reading::Exact(Number::from_f64(force).unwrap()));
        if let Some(duration) = durations.get(row) {
            state = device.moved(state, force, near(duration));
        }
    }
    log.durations = durations.to_vec();
    log
}

pub(crate) fn near(x: &Number) -> f64 {
    match x {
        Number::Small(n, d) => *n as f64 / *d as f64,
        Number::Tiny(..) | Number::Big(_) => unreachable!("short numbers only"),
    }
}

/// The experiment with this number: each number another device.
pub(crate) fn trial(number: u64) -> Trial {
    let mut random = Random::new(0x1de7 + number);
    let kind = KINDS[(number % 4) as usize];
    let speed = random.over_decades(5.0, 200.0);
    let inertia = random.over_decades(1.0, 1e4);
    // In how many samples each friction would stop the device.
    let device = Device {
        viscous: inertia / random.over_decades(50.0, 3000.0),
        coulomb: inertia * speed / random.over_decades(50.0, 3000.0),
        inertia,
    };
    let pushed = random.between(20.0, 80.0).round() as usize;
    let push = device.coulomb + device.viscous * speed + inertia * speed / pushed as f64;
    let samples = 300 + random.below(400) as usize;
    let even = random.below(3) > 0;
    let mut duration = || match even {
        true => Number::whole(1),
        false => Number::Small(800 + random.below(400) as i64, 1000),
    };
    let durations: Vec<Number> = (0..samples).map(|_| duration()).collect();
    let phase = random.between(0.0, 1.0);
    let log = match kind {
        Kind::PushAndCoast => recorded(&device, phase, &durations, &mut random, true, |row, _| {
            if row < pushed { push } else { 0.0 }
        }),
        Kind::BothWays => recorded(
            &device,
            phase,
            &durations,
            &mut random,
            true,
            |row, _| match row * 4 / samples {
                0 => push,
                2 => -push,
                _ => 0.0,
            },
        ),
        Kind::Ramp => recorded(&device, phase, &durations, &mut random, true, |row, _| {
            let share = row as f64 / samples as f64;
            push * (1.5 * share).min(1.0) * if share < 0.8 { 1.0 } else { 0.0 }
        }),
        Kind::Swing => {
            let period = random.between(40.0, 150.0);
            let spring = inertia * (std::f64::consts::TAU / period).powi(2);
            // Far enough for friction not to hold it.
            let offset = speed * period / 6.0 + 3.0 * device.coulomb / spring;
            recorded(
                &device,
                offset + phase,
                &durations,
                &mut random,
                true,
                |_, count| -spring * count as f64,
            )
        }
    };
    Trial { device, kind, log }
}

/// A sketch of a device with this inertia, known within a percentage.
pub(crate) fn sketch(inertia: f64, percent: f64) -> Scene {
    let text = format!("[dimensionless]\nmu = \"{inertia:e} ± {percent}%\"");
    Scene::from_toml("sketch", &text).unwrap()
}
