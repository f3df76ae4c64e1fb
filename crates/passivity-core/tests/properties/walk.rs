//! Effects together: random walks under the force that the controller holds.
//!
//! The force is the kernel's `Controller`, sample by sample, as every program that uses the kernel
//! has it; the account of it must stay within what `Loop::cost` charges, plus what the effects had
//! stored, and the kernel's ledger row must say the same.

use passivity_core::controller::Controller;
use passivity_core::extra_storage::{damping_storage, delay_storage};
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{BigRational, Friction, Loop, Step};
use proptest::prelude::*;

use crate::common::{dimensionless, position, q, sampled, unit, zero};
use crate::ledger::{potential, quantized_potential};

/// A walk through sampling instants, with the forces that were held after each of them.
struct Walk<'a> {
    the_loop: &'a Loop<BigRational>,
    positions: &'a [BigRational],
    forces: Vec<BigRational>,
}

impl<'a> Walk<'a> {
    /// The walk of a device that has rested for ever at the first position.
    ///
    /// To have walked before is to have rested before that, so the later intervals of a walk have
    /// any history at all behind them.
    fn of(the_loop: &'a Loop<BigRational>, positions: &'a [BigRational]) -> Self {
        let controller = Controller::of(the_loop);
        let mut memory = controller.at_rest(&positions[0]);
        let force = |xi| controller.sample(&mut memory, xi);
        Self {
            the_loop,
            positions,
            forces: positions.iter().map(force).collect(),
        }
    }

    /// The last `count` displacements before sample h, the latest first.
    fn past(&self, h: usize, count: usize) -> Vec<BigRational> {
        let at = |i: Option<usize>| &self.positions[i.unwrap_or(0)];
        (0..count)
            .map(|j| at(h.checked_sub(j)) - at(h.checked_sub(j + 1)))
            .collect()
    }

    /// What the effects have stored at sample h.
    fn stored(&self, h: usize) -> BigRational {
        let late = usize::from(self.the_loop.delay);
        let delayed = delay_storage(&self.past(h, late));
        match &self.the_loop.damping {
            Some(damping) => delayed + damping_storage(damping, &self.past(h, late + 1)),
            None => delayed,
        }
    }

    /// The interval from sample h to the next, in the time `dtau`.
    fn interval(&self, h: usize, dtau: &BigRational) -> HeldInterval<BigRational> {
        HeldInterval {
            step: Step::new(self.positions[h].clone(), self.positions[h + 1].clone()),
            force: self.forces[h].clone(),
            dtau: dtau.clone(),
            extra_storage: Some(self.stored(h + 1) - self.stored(h)),
        }
    }

    /// What the held force generates from sample h to the next, against the law's own potential.
    fn generated(&self, h: usize) -> BigRational {
        let (from, to) = (&self.positions[h], &self.positions[h + 1]);
        let (low, high) = (potential(self.the_loop, from), potential(self.the_loop, to));
        &self.forces[h] * (to - from) + high - low
    }
}

fn positions() -> impl Strategy<Value = Vec<BigRational>> {
    prop::collection::vec(position(), 3..9)
}

sampled! {
    /// Each step pays its cost once; the storage passes on the rest (TH-DELAY, TH-DAMP, TH-DAC,
    /// TH-LAW, TH-UNI and TH-SMOOTH in every combination).
    fn th_delay_th_damp_th_dac_th_law_combined(the_loop in dimensionless(), positions in positions()) {
        let walk = Walk::of(&the_loop, &positions);
        let cost = the_loop.cost();
        let (mut generated, mut paid) = (zero(), zero());
        for h in 0..positions.len() - 1 {
            let bound = cost.bound(&(&positions[h + 1] - &positions[h]));
            let step = walk.generated(h);
            let drop = walk.stored(h) - walk.stored(h + 1);
            prop_assert!(step <= &bound + drop, "a single step");
            generated += step;
            paid += bound;
        }
        // Before the start the device rested, so there was nothing stored.
        prop_assert_eq!(walk.stored(0), zero());
        prop_assert!(walk.stored(positions.len() - 1) >= zero());
        prop_assert!(generated <= paid, "the whole walk");
    }

    /// The last interval may end anywhere: nothing more is stored than at its start.
    fn th_delay_th_damp_account_closed_within_an_interval(
        the_loop in dimensionless(), positions in positions(), end in position()
    ) {
        let mut positions = positions;
        positions.push(end);
        let walk = Walk::of(&the_loop, &positions);
        let h = positions.len() - 2;
        let d = &positions[h + 1] - &positions[h];
        prop_assert!(walk.generated(h) <= the_loop.cost().bound(&d) + walk.stored(h));
    }

    /// Where the criterion holds at the mean speed of a step, its row is not short, whatever the
    /// effects.
    fn th_delay_th_damp_th_dac_th_law_row(
        the_loop in dimensionless(), positions in positions(), dtau in unit()
    ) {
        let walk = Walk::of(&the_loop, &positions);
        for h in 0..positions.len() - 1 {
            let row = ledger::row(&the_loop, &walk.interval(h, &dtau));
            prop_assert_eq!(&row.generated_linear, &walk.generated(h));
            let gain = walk.stored(h + 1) - walk.stored(h);
            prop_assert_eq!(&row.net_linear, &(&row.dissipated_lower - &row.generated_linear - gain));
            let [from, to] = [&positions[h], &positions[h + 1]]
                .map(|x| quantized_potential(&the_loop, x) - potential(&the_loop, x));
            prop_assert_eq!(&row.generated_quantized, &(&row.generated_linear + to - from));
            if row.margin >= zero() {
                prop_assert!(row.net_linear >= zero());
            }
        }
    }
}

/// What the storage is for: a row without it can be short on the very border of the criterion.
#[test]
fn th_delay_storage_is_needed() {
    let the_loop = Loop {
        delay: 1,
        ..Loop::plain(Friction::new(q(3, 2), q(1, 2)))
    };
    // The force is still that of the sample before the first move.
    let positions = [q(0, 1), q(19, 1), q(29, 1)];
    let walk = Walk::of(&the_loop, &positions);
    let interval = walk.interval(1, &q(1, 1));
    let row = ledger::row(&the_loop, &interval);
    assert_eq!((row.margin, row.net_linear), (zero(), q(101, 2)));
    let forgetful = HeldInterval {
        extra_storage: None,
        ..interval
    };
    assert_eq!(ledger::row(&the_loop, &forgetful).net_linear, q(-80, 1));
}
