//! The controller: from a sampled position to the force that is held, with exactly the effects
//! that the scene has.
//!
//! A sample is taken (quantized by an encoder, if there is one), reaches the controller k samples
//! late, becomes a force −(q + B(q − q′)) (zero outside a one-sided wall), is rounded by the D/A
//! converter and limited by the actuator, in this order. Before the first sample the device is taken
//! to have been at its start for ever: the delay line is filled with the first sample, so that delay
//! and damping start with no energy stored.

use passivity_core::BigRational;
use passivity_scene::Effect;

use crate::plan::to_double;

/// The encoder, as a bit of a law's set of effects.
pub const ENCODER: u8 = 1;
/// The delay.
pub const DELAY: u8 = 2;
/// Virtual damping.
pub const DAMPING: u8 = 4;
/// The one-sided wall.
pub const UNILATERAL: u8 = 8;
/// The D/A converter.
pub const FORCE_STEP: u8 = 16;
/// Saturation.
pub const SATURATION: u8 = 32;

/// The controller's parameters; those of an effect that is not in `effects` are of no meaning.
#[derive(Clone, Debug, PartialEq)]
pub struct Controller {
    /// The set of effects: [`ENCODER`] | [`DELAY`] | …
    pub effects: u8,
    /// k, in samples.
    pub delay: usize,
    /// B, in KT.
    pub damping: f64,
    /// δ as numerator and denominator, so that a force half-way between two steps is seen as such.
    pub force_step: [f64; 2],
    /// The largest force, in KΔ.
    pub max_force: f64,
}

/// What the controller remembers from sample to sample.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Memory {
    /// The last k samples, a ring.
    line: Vec<f64>,
    next: usize,
    /// The sample before, for virtual damping.
    previous: f64,
}

impl Memory {
    /// The samples that are remembered, the latest first.
    pub fn latest_first(&self) -> impl Iterator<Item = f64> + '_ {
        let older = self.line.iter().skip(self.next);
        let newer = self.line.iter().take(self.next);
        newer
            .rev()
            .chain(older.rev())
            .copied()
            .chain([self.previous])
    }
}

/// A law: the held force of a sample at ξ, in KΔ.
pub type LawFn = fn(&Controller, &mut Memory, f64) -> f64;

impl Controller {
    /// The paper's controller: an encoder and nothing else.
    #[must_use]
    pub const fn encoder() -> Self {
        Self {
            effects: ENCODER,
            delay: 0,
            damping: 0.0,
            force_step: [0.0, 1.0],
            max_force: 0.0,
        }
    }

    /// Whether an effect is in the set.
    #[must_use]
    pub const fn has(&self, effect: u8) -> bool {
        self.effects & effect != 0
    }

    /// The effects of the scene that are in the set.
    #[must_use]
    pub fn listed(&self) -> Vec<Effect> {
        let names = [
            (ENCODER, Effect::Encoder),
            (DELAY, Effect::Delay),
            (UNILATERAL, Effect::Unilateral),
            (DAMPING, Effect::Damping),
            (SATURATION, Effect::Saturation),
            (FORCE_STEP, Effect::ForceStep),
        ];
        let present = names.into_iter().filter(|(bit, _)| self.has(*bit));
        present.map(|(_, effect)| effect).collect()
    }

    /// The numerator and denominator of a force step as doubles.
    #[must_use]
    pub fn step_of(delta: &BigRational) -> [f64; 2] {
        let part = |n: &num_bigint::BigInt| to_double(&BigRational::from_integer(n.clone()));
        let [numerator, denominator] = [part(delta.numer()), part(delta.denom())];
        let exact = |x: f64| x <= 9_007_199_254_740_992.0;
        if exact(numerator) && exact(denominator) {
            [numerator, denominator]
        } else {
            [to_double(delta), 1.0]
        }
    }

    /// What the controller remembers when the device has been at ξ for ever.
    #[must_use]
    pub fn memory(&self, xi: f64) -> Memory {
        let sample = self.sample(xi);
        Memory {
            line: vec![sample; if self.has(DELAY) { self.delay } else { 0 }],
            next: 0,
            previous: sample,
        }
    }

    /// The position that the controller is given for ξ: the middle of its tick (5), or ξ itself.
    #[must_use]
    pub fn sample(&self, xi: f64) -> f64 {
        if self.has(ENCODER) {
            floor(xi) + 0.5
        } else {
            xi
        }
    }

    /// The force that a sample is held with once the device has stayed there, in KΔ.
    #[must_use]
    pub fn settled(&self, sample: f64) -> f64 {
        let without_history = self.effects & !(ENCODER | DELAY | DAMPING);
        TABLE[usize::from(without_history)](self, &mut Memory::default(), sample)
    }

    /// The function that computes the law: one of 64, each with its effects and no others.
    #[must_use]
    pub fn law(&self) -> LawFn {
        TABLE[usize::from(self.effects & 63)]
    }

    /// After how many samples at rest the controller has forgotten every other.
    #[must_use]
    pub fn forgets_after(&self) -> u64 {
        let delay = if self.has(DELAY) {
            self.delay as u64
        } else {
            0
        };
        delay + u64::from(self.has(DAMPING))
    }
}

/// ⌊x⌋ without a library call and without the instruction that a plain x86-64 lacks.
///
/// Adding 1.5·2⁵² rounds to the nearest integer; beyond 2⁵¹ the library takes over.
#[inline(always)]
#[must_use]
pub fn floor(x: f64) -> f64 {
    const MAGIC: f64 = 6_755_399_441_055_744.0;
    const LIMIT: f64 = 2_251_799_813_685_248.0;
    if x.abs() >= LIMIT {
        return x.floor();
    }
    let nearest = (x + MAGIC) - MAGIC;
    nearest - if nearest > x { 1.0 } else { 0.0 }
}

/// The held force with the effects `E`: what is not in `E` is not in the code.
fn held<const E: u8>(law: &Controller, memory: &mut Memory, xi: f64) -> f64 {
    let mut q = if E & ENCODER != 0 {
        floor(xi) + 0.5
    } else {
        xi
    };
    if E & DELAY != 0 {
        // The line is never empty when there is a delay.
        if let Some(slot) = memory.line.get_mut(memory.next) {
            std::mem::swap(slot, &mut q);
        }
        memory.next += 1;
        if memory.next == memory.line.len() {
            memory.next = 0;
        }
    }
    let mut force = q;
    if E & DAMPING != 0 {
        force += law.damping * (q - memory.previous);
        memory.previous = q;
    }
    if E & UNILATERAL != 0 && q < 0.0 {
        force = 0.0;
    }
    let mut held = -force;
    if E & FORCE_STEP != 0 {
        let [numerator, denominator] = law.force_step;
        held = floor(held * denominator / numerator + 0.5) * numerator / denominator;
    }
    if E & SATURATION != 0 {
        held = held.clamp(-law.max_force, law.max_force);
    }
    held
}

macro_rules! laws {
    ($($e:literal)*) => { [$(held::<$e>),*] };
}

static TABLE: [LawFn; 64] = laws![
    0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31
    32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63
];

#[cfg(test)]
mod tests {
    use super::*;
    use passivity_core::{Scalar, effects::rounded_force, quantizer::held_force};

    fn exact(x: f64) -> BigRational {
        BigRational::from_float(x).unwrap()
    }

    #[test]
    fn floor_is_floor() {
        let edges = [
            0.0,
            1.0,
            0.5,
            1.5,
            2.5,
            1e15,
            2.251_799_813_685_248e15,
            1e300,
            5e-324,
        ];
        for x in edges
            .into_iter()
            .flat_map(|x: f64| [x, x.next_up(), x.next_down()])
        {
            assert_eq!(floor(x), x.floor(), "{x:e}");
            assert_eq!(floor(-x), (-x).floor(), "{:e}", -x);
        }
    }

    #[test]
    fn plain_law_is_the_kernels() {
        let law = Controller::encoder();
        for i in -40..=40 {
            let x = f64::from(i) / 8.0;
            let force = law.law()(&law, &mut law.memory(0.0), x);
            assert_eq!(exact(force), held_force(&exact(x)));
        }
    }

    #[test]
    fn a_force_half_way_rounds_as_the_kernel_does() {
        let third = BigRational::integer(1).over(BigRational::integer(3));
        let law = Controller {
            effects: ENCODER | FORCE_STEP,
            force_step: Controller::step_of(&third),
            ..Controller::encoder()
        };
        for tick in -20..20 {
            let x = f64::from(tick);
            let steps = law.law()(&law, &mut law.memory(0.0), x) * 3.0;
            let expected = rounded_force(&held_force(&exact(x)), &third) * exact(3.0);
            // A whole number of thirds, computed as n·1/3: within half an ulp of itself.
            assert_eq!(exact(steps.round()), expected);
            assert!((steps - steps.round()).abs() < 1e-14);
        }
    }

    #[test]
    fn delay_and_damping_start_with_nothing_stored() {
        let law = Controller {
            effects: DELAY | DAMPING,
            delay: 2,
            damping: 3.0,
            ..Controller::encoder()
        };
        let mut memory = law.memory(1.0);
        let forces: Vec<f64> = [1.0, 2.0, 4.0, 4.0, 4.0, 4.0]
            .map(|x| law.law()(&law, &mut memory, x))
            .to_vec();
        assert_eq!(forces, [-1.0, -1.0, -1.0, -5.0, -10.0, -4.0]);
    }
}
