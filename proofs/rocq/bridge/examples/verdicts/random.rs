//! Random numbers, and random boxes of loops.

use passivity_core::{BigRational, Interval, Loop, Scalar as _};

use crate::Bounds;

/// Random loops and their parameters, always the same.
pub(crate) struct Random(passivity_random::Random);

impl Random {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(passivity_random::Random::new(seed))
    }

    pub(crate) fn below(&mut self, n: u16) -> u16 {
        let [a, b, ..] = self.0.bits().to_le_bytes();
        u16::from_le_bytes([a, b]) % n
    }

    /// Eighths below 4: borders are met often.
    pub(crate) fn eighths(&mut self, least: i32) -> BigRational {
        BigRational::integer(least + i32::from(self.below(32))) / BigRational::integer(8)
    }

    /// A point or a tolerance, of numbers of so many eighths at least.
    pub(crate) fn range(&mut self, least: i32) -> Interval<BigRational> {
        let lo = self.eighths(least);
        match self.below(3) {
            0 => Interval::point(lo),
            _ => {
                let width = self.eighths(0) / BigRational::integer(1 + i32::from(self.below(4)));
                Interval::hull(lo.clone(), lo + width)
            }
        }
    }

    pub(crate) fn sometimes(&mut self, least: i32) -> Option<Interval<BigRational>> {
        (self.below(4) > 0).then(|| self.range(least))
    }

    /// Friction is drawn about what the middle of the box asks for, so that all verdicts occur.
    pub(crate) fn any_box(&mut self) -> Bounds {
        let without_friction = Loop {
            resolution: self.sometimes(1),
            damping: self.sometimes(0),
            force_step: self.sometimes(1),
            delay: self.below(4),
            max_speed: self.sometimes(1),
            ..Loop::new(self.range(1), self.range(1))
        };
        let cost = without_friction.map(|_, x| x.lo().clone()).cost();
        let near = |random: &mut Self, need: BigRational| {
            let lo = need * random.eighths(4) / BigRational::integer(2);
            let width = random.range(0);
            Some(Interval::hull(lo.clone() + width.lo(), lo + width.hi()))
        };
        let viscous = near(self, cost.viscous);
        let coulomb = near(self, cost.coulomb);
        Loop {
            viscous: viscous.filter(|_| self.below(16) > 0),
            coulomb: coulomb.filter(|_| self.below(16) > 0),
            ..without_friction
        }
    }
}
