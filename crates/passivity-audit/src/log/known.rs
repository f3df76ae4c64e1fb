//! What an interval between two known positions comes to, in doubles: most rows of most logs.

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{
    Controller, Criterion, Friction, Loop, Ordered as _, Scalar as _, Step, Truth, dissipation,
};

use crate::ball::{Ball, Lane};
use crate::ends::Ends;
use crate::figure::not;
use crate::ledger::{Logged, Truths};
use crate::log::motion::{Addend, figures};
use crate::log::task::Task;
use crate::log::wall::{Held, Reach};
use crate::reading::Reading;

/// What an interval between two known positions comes to. Energies are in units of the grid, at the
/// least and at the most.
#[derive(Clone, Debug)]
pub(crate) struct Known {
    pub(super) displacement: Ball,
    /// The force of the loop's controller,
    pub(super) commanded: Ball,
    /// what it generates against the wall's law and against its quantized form,
    pub(super) generated: [[i128; 2]; 2],
    /// and what the observer adds for it.
    pub(super) observed: [i128; 2],
    /// The least that friction takes (26), of the loop with the least and with the most friction.
    pub(super) dissipated: [[i128; 2]; 2],
    /// Whether the criterion holds at the mean speed.
    pub(super) criterion_holds: Truth,
    /// The wall's potential where it ends.
    pub(super) potential: [i128; 2],
}

/// What an interval starts with, kept from the one before it.
#[derive(Debug, Default)]
pub(crate) struct Starts {
    /// What was measured last, and the force for that: most steps are short.
    measured: Option<(Ball, Ball)>,
}

impl Starts {
    /// The force of a controller without memory.
    fn commanded(&mut self, controller: &Controller<Ball>, start: &Ball) -> Ball {
        let measured = controller.measured(start);
        match self.measured {
            Some((before, force)) if before == measured => force,
            _ => {
                let force = controller.held_force(&[measured]);
                self.measured = Some((measured, force));
                force
            }
        }
    }
}

impl Known {
    /// Of an interval of its own; `None` between counts, and of a loop whose force remembers earlier samples.
    pub(crate) fn of_interval(task: &Task<'_>, interval: &Logged) -> Option<Self> {
        match interval.samples.as_slice() {
            [start] if !task.ledger.has_memory() => Self::of(
                (task.ledger.near(), task.reach()),
                &mut Starts::default(),
                [known(start)?, known(&interval.end)?],
                start.is_same(&interval.end),
                &Ball::of(&interval.dtau),
            ),
            _ => None,
        }
    }

    /// Of an interval between two positions, the same ones where the device stood still, that lasts so many
    /// periods, at a wall that is linear within `reach` where that is told; `None` where doubles leave something open.
    pub(crate) fn of(
        (ends, reach): (&Ends<Ball>, Option<&Reach>),
        starts: &mut Starts,
        [start, end]: [Ball; 2],
        is_still: bool,
        lasts: &Ball,
    ) -> Option<Self> {
        // Of what stands still, any position that it may have stands for all.
        let step = match is_still {
            true => Step::new(start.one_of(), start.one_of()),
            false => Step::new(start, end),
        };
        let d = step.displacement();
        let speed = dissipation::mean_speed(&d, lasts);
        let dissipated = |of: &Loop<Ball>| {
            let friction = Friction::new(of.viscous_friction(), of.coulomb_friction());
            friction.dissipated_lower(&d, &speed).on_grid()
        };
        let holds = |criterion: &Criterion<Ball>| criterion.margin(&speed).is_nonnegative();
        let [least, most] = &ends.criteria;
        let taken = dissipated(&ends.least)?;
        let moves = speed.is_positive()?;
        let at_least = !moves || holds(least)?;
        // Friction that is known has one end.
        let (most_taken, at_most) = match ends.friction_is_exact() {
            true => (taken, at_least),
            false => (dissipated(&ends.most)?, !moves || holds(most)?),
        };
        let in_part = reach.and_then(|reach| in_part(reach, [start, end], &step));
        let (commanded, [linear, quantized], potential) = in_part.unwrap_or_else(|| {
            let commanded = starts.commanded(&ends.controller, &start);
            let held = HeldInterval {
                step,
                force: commanded,
                // What is generated does not depend on it.
                dtau: Ball::one(),
                extra_storage: None,
            };
            let generated = ledger::generated(&ends.least, &held);
            (commanded, generated, ends.least.law().potential(&end))
        });
        Some(Self {
            displacement: d,
            commanded,
            generated: [linear.on_grid()?, quantized.on_grid()?],
            observed: (-(commanded * d)).on_grid()?,
            dissipated: [taken, most_taken],
            criterion_holds: Truth::over(at_least, at_most),
            potential: potential.on_grid()?,
        })
    }

    /// What the interval adds to an account, under the force that the log has or, without one, under that of
    /// the loop's controller; `None` where doubles leave something open.
    #[inline(always)]
    pub(crate) fn addend(&self, force: Option<Ball>) -> Option<Addend> {
        // What another force generates is the work of the difference, and what no force changes.
        let more = match force {
            None => [0, 0],
            Some(force) => ((force - self.commanded) * self.displacement).on_grid()?,
        };
        self.with_work(more)
    }

    /// What the interval adds under a force that does so much more work than that of the loop's controller.
    #[inline(always)]
    pub(crate) fn with_work(&self, more: [i128; 2]) -> Option<Addend> {
        let [least, most] = self.dissipated;
        let sums = figures(self.generated, more, [least[0], most[1]]);
        let [linear, quantized, ..] = sums;
        let violates = |generated: [i128; 2]| {
            let at_least = covers(least, generated)?;
            let at_most = match least == most {
                true => at_least,
                false => covers(most, generated)?,
            };
            Some(not(Truth::over(at_least, at_most)))
        };
        Some(Addend {
            sums,
            observed: self.observed[0] - more[1],
            potential: self.potential,
            truths: Truths {
                criterion_holds: self.criterion_holds,
                violates_linear: violates(linear)?,
                violates_quantized: violates(quantized)?,
            },
        })
    }
}

/// The force that is held over an interval in one part of a wall, what it generates and the potential where it ends:
/// as where several are computed at a time; `None` of others.
fn in_part(reach: &Reach, ends: [Ball; 2], step: &Step<Ball>) -> Option<(Ball, [Ball; 2], Ball)> {
    let step = Step::new(step.start.lane(), step.end.lane());
    let held = Held::of(Some(reach), ends.map(Ball::lane), &step);
    (held.open == 0.0).then(|| {
        let generated = held.generated.map(Lane::alone);
        (held.commanded.alone(), generated, held.potential.alone())
    })
}

/// What is known of a number that is no count.
#[inline(always)]
fn known(reading: &Reading) -> Option<Ball> {
    reading.to_near().exact().copied()
}

/// The force of an interval in the log, where it has one; `None` where that is no number.
#[inline(always)]
pub(crate) fn known_force(interval: &Logged) -> Option<Option<Ball>> {
    match &interval.force {
        Some(force) => Some(Some(known(force)?)),
        None => Some(None),
    }
}

/// Whether what is taken is at least as much as what is generated; `None` where that is open.
#[inline(always)]
fn covers(taken: [i128; 2], generated: [i128; 2]) -> Option<bool> {
    if taken[0] >= generated[1] {
        Some(true)
    } else {
        (taken[1] < generated[0]).then_some(false)
    }
}
