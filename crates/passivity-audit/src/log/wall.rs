//! A loop that is nothing but a linear wall behind an encoder, in doubles.

use passivity_core::{Criterion, Friction, Loop, Scalar as _};

use crate::ball::Ball;
use crate::ledger::Ledger;

/// A loop whose force is that of its linear wall on both sides, quantized and nothing else.
#[derive(Clone, Debug)]
pub(crate) struct Wall<const BRANCHES: bool = true> {
    /// The least friction and the most.
    pub(crate) frictions: [Friction<Ball<BRANCHES>>; 2],
    pub(crate) criteria: [Criterion<Ball<BRANCHES>>; 2],
    pub(crate) friction_is_exact: bool,
}

impl Wall {
    /// `None` for other loops.
    pub(crate) fn of(ledger: &Ledger) -> Option<Self> {
        let ends = ledger.near();
        let controller = &ends.controller;
        let is_plain = controller.encoder
            && controller.memory() == 0
            && controller.filter.ends()
            && controller.filter.sum == Ball::one()
            && !controller.unilateral
            && controller.force_step.is_none()
            && controller.max_force.is_none();
        let friction =
            |of: &Loop<Ball>| Friction::new(of.viscous_friction(), of.coulomb_friction());
        (is_plain && ends.least.has_encoder() && ends.least.law().is_linear()).then(|| Self {
            frictions: [friction(&ends.least), friction(&ends.most)],
            criteria: ends.criteria,
            friction_is_exact: ends.friction_is_exact(),
        })
    }

    /// The same, to compute several rows at a time.
    pub(crate) fn lanes(&self) -> Wall<false> {
        Wall {
            frictions: self
                .frictions
                .map(|of| Friction::new(of.beta.lane(), of.sigma.lane())),
            criteria: self.criteria.map(|of| Criterion {
                viscous: of.viscous.lane(),
                coulomb: of.coulomb.lane(),
            }),
            friction_is_exact: self.friction_is_exact,
        }
    }
}
