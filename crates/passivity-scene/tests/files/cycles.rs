//! A search for counterexamples: short motions that repeat, over all sets of effects, at the least
//! friction that `check` calls passive. None may draw energy (TH-LTI, TH-LATENCY, TH-LAG, TH-LAW).
//!
//! The forces are computed here in doubles, from the encoder, the difference equation and the lag's
//! exponential alone.

use num_traits::ToPrimitive as _;
use passivity_core::BigRational;
use passivity_random::draws;
use passivity_scene::Scene;
use passivity_scene::check::{Verdict, check};
use proptest::prelude::*;

/// The effects of a loop in doubles, each a short decimal.
#[derive(Clone, Debug)]
struct Effects {
    encoder: bool,
    delay: u16,
    unilateral: bool,
    damping: Option<f64>,
    time_constant: Option<f64>,
    /// n₀, n₁, n₂ and d₁ of a controller in place of the spring.
    controller: Option<[f64; 4]>,
    force_step: Option<f64>,
    max_force: Option<f64>,
    latency: Option<f64>,
    lag: Option<f64>,
}

fn effects() -> impl Strategy<Value = Effects> {
    let tenths = |range: std::ops::RangeInclusive<i32>| range.prop_map(|n| f64::from(n) / 10.0);
    let some = |range| prop::option::of(tenths(range));
    let controller = [
        tenths(0..=20),
        tenths(-10..=10),
        tenths(-10..=10),
        tenths(-8..=8),
    ];
    (
        (
            any::<bool>(),
            0..3_u16,
            any::<bool>(),
            some(1..=30),
            some(1..=30),
        ),
        (
            prop::option::of(controller),
            some(1..=10),
            some(5..=40),
            some(1..=25),
            some(1..=25),
        ),
    )
        .prop_map(|((encoder, delay, unilateral, damping, filter), rest)| {
            let (controller, force_step, max_force, latency, lag) = rest;
            // H(1) ≥ 0 makes a controller, in place of the damping.
            let controller = controller.filter(|[a, b, c, _]| a + b + c >= 0.0);
            let damping = damping.filter(|_| controller.is_none());
            Effects {
                encoder,
                delay,
                unilateral,
                time_constant: filter.filter(|_| damping.is_some()),
                damping,
                controller,
                force_step,
                max_force,
                latency,
                lag,
            }
        })
}

impl Effects {
    fn sections(&self) -> String {
        let key =
            |name: &str, x: Option<f64>| x.map_or(String::new(), |x| format!("{name} = \"{x}\"\n"));
        let mut text = format!("[sampling]\ndelay = {}\n", self.delay);
        text += &key("latency", self.latency);
        text += &format!("[wall]\nunilateral = {}\n", self.unilateral);
        text += &key("damping", self.damping);
        text += &key("damping_time_constant", self.time_constant);
        text += &key("force_step", self.force_step);
        text += &key("max_force", self.max_force);
        if let Some([a, b, c, d]) = self.controller {
            text += &format!("[controller]\nnumerator = [\"{a}\", \"{b}\", \"{c}\"]\n");
            text += &format!("denominator = [\"1\", \"{d}\"]\n");
        }
        if self.lag.is_some() {
            text += &format!("[amplifier]\n{}", key("time_constant", self.lag));
        }
        text
    }

    /// Numerator and d₁ of H.
    fn transfer(&self) -> ([f64; 3], f64) {
        if let Some([a, b, c, d]) = self.controller {
            return ([a, b, c], d);
        }
        let b = self.damping.unwrap_or(0.0);
        let pole = self.time_constant.map_or(0.0, |tau| tau / (1.0 + tau));
        let kept = b * (1.0 - pole);
        ([1.0 + kept, -(pole + kept), 0.0], -pole)
    }

    /// What the operator gains each time round.
    fn gain(&self, positions: &[f64], beta: f64, sigma: f64) -> f64 {
        let p = positions.len();
        let measured = |h: usize| {
            let xi = positions[h % p];
            if self.encoder { xi.floor() + 0.5 } else { xi }
        };
        let (n, d) = self.transfer();
        // |d| ≤ 0.8 and e^(−1/2.5): after 400 samples the start is forgotten.
        let rounds = 400 / p + 2;
        let (mut y, mut lagged) = (0.0, 0.0);
        let mut commands: Vec<f64> = Vec::new();
        let mut means: Vec<f64> = Vec::new();
        for h in 0..rounds * p {
            let at = |back: usize| measured(h + 4 * p * p - back);
            let late = usize::from(self.delay);
            y = n[0] * at(late) + n[1] * at(late + 1) + n[2] * at(late + 2) - d * y;
            let mut force = -y;
            if self.unilateral && at(late) < 0.0 {
                force = 0.0;
            }
            if let Some(step) = self.force_step {
                force = (force / step + 0.5).floor() * step;
            }
            if let Some(most) = self.max_force {
                force = force.clamp(-most, most);
            }
            commands.push(force);
            // The output changes in the interval, after the fraction of the latency.
            let latency = self.latency.unwrap_or(0.0);
            let (whole, fraction) = (latency.floor(), latency.fract());
            let before = |back: f64| {
                let index = h as f64 - back;
                if index < 0.0 {
                    0.0
                } else {
                    commands[index as usize]
                }
            };
            let mut mean = 0.0;
            for (time, command) in [
                (fraction, before(whole + 1.0)),
                (1.0 - fraction, before(whole)),
            ] {
                match self.lag {
                    Some(theta) => {
                        let left = (-time / theta).exp();
                        mean += time * command + (lagged - command) * theta * (1.0 - left);
                        lagged = command + (lagged - command) * left;
                    }
                    None => mean += time * command,
                }
            }
            means.push(mean);
        }
        let last = (rounds - 1) * p;
        (0..p)
            .map(|h| {
                let step = positions[(h + 1) % p] - positions[h];
                means[last + h] * step - beta * step * step - sigma * step.abs()
            })
            .sum()
    }
}

fn double(x: &BigRational) -> f64 {
    x.to_f64().unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(40)))]

    #[test]
    fn no_short_cycle_draws_energy_at_the_least_friction_called_passive(
        effects in effects(),
        cycles in prop::collection::vec(prop::collection::vec(-24..=24_i32, 2..8), 40),
        fine in prop::collection::vec(prop::collection::vec(-8..=8_i32, 2..8), 40),
    ) {
        let scene = |beta: &str, sigma: &str| {
            let text = format!("[dimensionless]\nbeta = \"{beta}\"\nsigma = \"{sigma}\"\n{}", effects.sections());
            let text = if effects.encoder {
                text
            } else {
                // Without an encoder a scene has units; with K = T = 1 they are those of β and σ.
                text.replace("[dimensionless]\nbeta = ", "[device]\nviscous = ")
                    .replace("sigma = ", "coulomb = ")
            };
            units(&text, effects.encoder)
        };
        let report = |beta: &str, sigma: &str| {
            let text = scene(beta, sigma);
            let read = Scene::from_toml("scene", &text);
            check(&read.unwrap_or_else(|error| panic!("{error}\n{text}")))
        };
        let cost = report("1", "1").cost;
        let (beta, sigma) = (cost.viscous.hi(), cost.coulomb.hi());
        if !num_traits::Signed::is_negative(beta) {
            let at = report(&beta.to_string(), &sigma.to_string());
            prop_assert_eq!(at.verdict, Verdict::Passive);
        }
        let (beta, sigma) = (double(beta), double(sigma));
        let wide = cycles.iter().map(|cycle| (cycle, 4.0));
        // About one edge, and within one tick.
        let narrow = fine.iter().map(|cycle| (cycle, 64.0));
        for (cycle, scale) in wide.chain(narrow) {
            let positions: Vec<f64> = cycle.iter().map(|n| f64::from(*n) / scale).collect();
            let gain = effects.gain(&positions, beta, sigma);
            // At most 8 terms of forces and steps below 100 and 12, each rounded some 10 times.
            prop_assert!(gain <= 1e-9, "{positions:?} draws {gain}");
        }
    }
}

/// The text with units where there is no encoder.
fn units(text: &str, encoder: bool) -> String {
    if encoder {
        return text.to_owned();
    }
    let with_unit = |line: &str| {
        let unit = match line.split(" = ").next() {
            Some("viscous" | "damping") => "N s/m",
            Some("coulomb" | "force_step" | "max_force") => "N",
            Some("latency" | "damping_time_constant" | "time_constant") => "s",
            _ => return line.to_owned(),
        };
        format!("{} {unit}\"", line.trim_end_matches('"'))
    };
    let lines: Vec<String> = text.lines().map(with_unit).collect();
    let text = lines.join("\n");
    let text = text.replace("[sampling]\n", "[sampling]\nperiod = \"1 s\"\n");
    text.replace("[wall]\n", "[wall]\nstiffness = \"1 N/m\"\n") + "\n"
}
