//! Effects together: random walks under the force that a real loop commands.
//!
//! The force is computed here, sample by sample, as a controller would; the account of it must stay
//! within what `Effects::cost` charges, plus what the effects had stored.

use passivity_core::effects::{Effects, damping_storage, delay_storage};
use passivity_core::{BigRational, Law};
use proptest::prelude::*;

use crate::common::{effects, half, position, sampled, zero};
use crate::law::law;

/// A walk through sampling instants, with its own history before the first.
struct Walk<'a> {
    positions: &'a [BigRational],
    effects: &'a Effects<BigRational>,
    law: &'a Law<BigRational>,
}

impl Walk<'_> {
    fn late(&self) -> usize {
        usize::from(self.effects.delay)
    }

    /// The first sample whose force is commanded by samples of the walk alone.
    fn first(&self) -> usize {
        self.late() + 1
    }

    /// What the controller knows of sample i.
    fn known(&self, i: usize) -> BigRational {
        if self.effects.encoder {
            self.positions[i].floor() + half()
        } else {
            self.positions[i].clone()
        }
    }

    /// The force held from sample h on: the law and the damping, late, rounded last.
    fn force(&self, h: usize) -> BigRational {
        let seen = h - self.late();
        let mut force = -self.law.force(&self.known(seen));
        if let Some(damping) = &self.effects.damping {
            force -= damping * (self.known(seen) - self.known(seen - 1));
        }
        if let Some(step) = &self.effects.force_step {
            force = (force / step + half()).floor() * step;
        }
        force
    }

    /// E_g from sample h to the next, against the law's own potential.
    fn generated(&self, h: usize) -> BigRational {
        let (from, to) = (&self.positions[h], &self.positions[h + 1]);
        self.force(h) * (to - from) + self.law.potential(to) - self.law.potential(from)
    }

    /// The last `count` displacements before sample h, the latest first.
    fn past(&self, h: usize, count: usize) -> Vec<BigRational> {
        (0..count)
            .map(|j| &self.positions[h - j] - &self.positions[h - j - 1])
            .collect()
    }

    /// What the effects have stored at sample h.
    fn stored(&self, h: usize) -> BigRational {
        let delayed = delay_storage(&self.past(h, self.late()));
        match &self.effects.damping {
            Some(damping) => delayed + damping_storage(damping, &self.past(h, self.late() + 1)),
            None => delayed,
        }
    }
}

sampled! {
    /// Each step pays its cost once; the storage passes on the rest (TH-DELAY, TH-DAMP, TH-DAC,
    /// TH-LAW and TH-SMOOTH in every combination).
    fn th_delay_th_damp_th_dac_th_law_combined(
        positions in prop::collection::vec(position(), 6..10), effects in effects(), law in law()
    ) {
        let walk = Walk { positions: &positions, effects: &effects, law: &law };
        let cost = effects.cost();
        let (mut generated, mut paid) = (zero(), zero());
        for h in walk.first()..positions.len() - 1 {
            let bound = cost.bound(&(&positions[h + 1] - &positions[h]));
            let step = walk.generated(h);
            let drop = walk.stored(h) - walk.stored(h + 1);
            prop_assert!(step <= &bound + drop, "a single step");
            generated += step;
            paid += bound;
        }
        let drop = walk.stored(walk.first()) - walk.stored(positions.len() - 1);
        prop_assert!(generated <= paid + drop, "the whole walk");
        prop_assert!(walk.stored(walk.first()) >= zero());
    }

    /// The last interval may end anywhere: nothing more is stored than at its start.
    fn th_delay_th_damp_account_closed_within_an_interval(
        positions in prop::collection::vec(position(), 6..7), end in position(), effects in effects(),
        law in law()
    ) {
        let mut positions = positions;
        positions.push(end);
        let walk = Walk { positions: &positions, effects: &effects, law: &law };
        let h = positions.len() - 2;
        let d = &positions[h + 1] - &positions[h];
        prop_assert!(walk.generated(h) <= effects.cost().bound(&d) + walk.stored(h));
    }
}
