//! The motion under the kernel's controller with the kernel's account, for any [`Real`]: one text for
//! rationals, numbers of any precision and rigorous intervals.

mod between;
mod motion;
mod part;
mod steps;

use std::cmp::Ordering;

use passivity_core::controller::Memory;
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{BigRational, Controller, Loop, Step};
use passivity_scene::Point;

use crate::error::SimError;
use crate::flow::{Flow, State};
use crate::latency;
use crate::law;
use crate::ledger::Entry;
use crate::number::{Real, Undecided};
use crate::plan::Plan;
use motion::Motion;
use part::{Part, Way};
use steps::Steps;

/// A scene in the numbers of a method.
#[derive(Clone, Debug)]
pub(crate) struct Model<R> {
    dimensionless: Loop<R>,
    controller: Controller<R>,
    steps: Option<Steps>,
    /// See [`law::forgets_after`].
    forgets_after: Option<u64>,
    /// Of the device.
    mass: R,
    /// The parts of an interval under different forces: one, but for a latency.
    parts: Vec<Part<R>>,
    forces: Option<Forces<R>>,
    /// Of a whole interval, as far as the loop has an amplifier or an arm.
    flow: Option<Flow<R>>,
    start: [R; 2],
}

/// The operator's force: one per interval, and the range of each with all that follow.
#[derive(Clone, Debug)]
struct Forces<R> {
    samples: Vec<R>,
    from_here: Vec<[R; 2]>,
}

/// An interval of a run; energies in KΔ².
#[derive(Clone, Debug, PartialEq)]
pub struct IntervalRow<R> {
    /// The interval.
    pub h: u64,
    /// ξ at its start and end.
    pub step: Step<R>,
    /// ξ̇ at its start and end.
    pub velocity: [R; 2],
    /// E_gᴸ and E_g.
    pub generated: [R; 2],
    /// E_d.
    pub dissipated: R,
    /// What the balance (13) is off by.
    pub residual: R,
}

impl<R> IntervalRow<R> {
    /// The same row in other numbers.
    pub(crate) fn map<U>(&self, f: impl Fn(&R) -> U) -> IntervalRow<U> {
        IntervalRow {
            h: self.h,
            step: Step {
                start: f(&self.step.start),
                end: f(&self.step.end),
            },
            velocity: self.velocity.each_ref().map(&f),
            generated: self.generated.each_ref().map(&f),
            dissipated: f(&self.dissipated),
            residual: f(&self.residual),
        }
    }
}

impl<R: Real> IntervalRow<R> {
    /// The row in doubles.
    pub(crate) fn entry(&self) -> Entry {
        let near = self.map(Real::approximate);
        let ([v0, v1], [generated_linear, generated_quantized]) = (near.velocity, near.generated);
        Entry {
            h: near.h,
            xi0: near.step.start,
            xi1: near.step.end,
            v0,
            v1,
            generated_linear,
            generated_quantized,
            dissipated: near.dissipated,
            residual: near.residual,
        }
    }
}

/// How a run of a model stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Halt {
    /// At rest for ever from this interval on.
    Rest(u64),
    /// Divergence is certain from this interval on.
    Growing(u64),
    /// All intervals were run, or the caller stopped it.
    Ran(u64),
    /// The numbers could not tell an edge, a sign or a stop in this interval.
    Undecided(u64),
    /// The numbers have grown past the caller's bound on their length.
    TooLong(u64),
}

/// The state at the end of a run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ended<R> {
    /// How it stopped.
    pub(crate) halt: Halt,
    /// How many intervals were run.
    pub(crate) intervals: u64,
    /// ξ.
    pub(crate) xi: R,
    /// ξ̇.
    pub(crate) velocity: R,
}

/// What acts on the device over an interval.
struct Acting<R> {
    /// The force of the sample before, where it goes on into the interval.
    earlier: Option<R>,
    held: R,
    /// The operator's.
    force: R,
}

impl<R: Real> Model<R> {
    /// A scene's point in the numbers that `of` makes; the point has been compiled to `plan` before.
    ///
    /// # Errors
    ///
    /// A scene without inertia.
    pub(crate) fn new(
        point: &Point,
        plan: &Plan,
        of: impl Fn(&BigRational) -> R,
    ) -> Result<Self, SimError> {
        let dimensionless = point.at.map(|_, x| of(x));
        let part = |the_loop: Loop<R>, time, plan: &Plan| {
            let mass = the_loop.inertia.clone().ok_or(SimError::NoInertia)?;
            let flow = plan.flow.as_ref();
            Ok(Part {
                time,
                flow: flow.map(|fast| Flow::of(&the_loop, mass.clone(), fast.pieces)),
                motion: Motion::new(mass, &the_loop),
            })
        };
        let whole = part(dimensionless.clone(), None, plan)?;
        let flow = whole.flow.clone();
        let mass = whole.motion.mass().clone();
        let mut parts = vec![whole];
        if let Some(times) = latency::times(&point.at) {
            // Each divided exactly, then put into the numbers.
            let of_time = |(time, (_, plan)): (&BigRational, &(f64, Plan))| {
                let the_loop = latency::part(&point.at, time);
                part(the_loop.map(|_, x| of(x)), Some(of(time)), plan)
            };
            let of_times = times.iter().zip(&plan.parts).map(of_time);
            parts = of_times.collect::<Result<_, SimError>>()?;
        }
        let controller = law::controller(&point.at, BigRational::clone)?;
        let forgets_after = law::forgets_after(&controller);
        let (steps, controller) = (Steps::of(&controller), controller.map(&of));
        Ok(Self {
            forgets_after,
            steps,
            controller,
            mass,
            parts,
            forces: point.forces.as_ref().map(|forces| Forces::new(forces, &of)),
            flow,
            start: point.start().map(|x| of(&x)),
            dimensionless,
        })
    }

    /// How many bits its numbers have.
    #[cfg(feature = "multiprecision")]
    pub(crate) fn bits(&self) -> u32 {
        self.mass.bits()
    }

    /// Runs the model for at most `intervals` intervals, numbers no longer than `longest` bits.
    ///
    /// `growing` says from which state on divergence is certain; `each` sees every interval, and stops
    /// the run by saying `false`.
    pub(crate) fn run(
        &self,
        intervals: u64,
        longest: u64,
        mut growing: impl FnMut(&State<R>, &Memory<R>) -> Result<bool, Undecided>,
        mut each: impl FnMut(&IntervalRow<R>) -> bool,
    ) -> Ended<R> {
        let [xi, velocity] = self.start.clone();
        let mut memory = self.controller.at_rest(&xi);
        let mut steps = self.steps.clone();
        let measured = self.controller.measured(&xi);
        let settled = self.controller.settled(&measured);
        let exactly = steps
            .as_mut()
            .and_then(|steps| steps.start(&measured, &self.controller));
        let mut state = State {
            // The amplifier has settled on what the controller commanded before the start.
            output: exactly.unwrap_or(settled),
            xi,
            velocity,
        };
        let late = self.is_late();
        let mut earlier = late.then(|| state.output.clone());
        let mut resting = 0;
        for h in 0..intervals {
            match growing(&state, &memory) {
                Ok(false) => {}
                Ok(true) => return state.ended(Halt::Growing(h), h),
                Err(Undecided) => return state.ended(Halt::Undecided(h), h),
            }
            let mut held = self.controller.sample(&mut memory, &state.xi);
            if let Some(steps) = &mut steps {
                let measured = self.controller.measured(&state.xi);
                held = steps.sample(&measured, &self.controller).unwrap_or(held);
            }
            let Ok((rests, acting, output, row)) = self.interval(h, &state, earlier, held, &memory)
            else {
                return state.ended(Halt::Undecided(h), h);
            };
            earlier = late.then_some(acting.held);
            resting = if rests { resting + 1 } else { 0 };
            if let Some(needed) = self.forgets_after.filter(|needed| resting > *needed) {
                return state.ended(Halt::Rest(h - needed), h);
            }
            let go_on = each(&row);
            let [_, velocity] = row.velocity;
            state = State {
                xi: row.step.end,
                velocity,
                output,
            };
            let remembered = memory.past.front().map_or(0, Real::length);
            if state.xi.length().max(remembered) > longest {
                return state.ended(Halt::TooLong(h), h + 1);
            }
            if !go_on {
                return state.ended(Halt::Ran(h + 1), h + 1);
            }
        }
        state.ended(Halt::Ran(intervals), intervals)
    }

    /// Whether the force of a sample goes on into the interval after it.
    const fn is_late(&self) -> bool {
        self.parts.len() > 1
    }

    /// One interval: whether the device rests in it for good as far as it goes, what acted, the
    /// amplifier's output at its end, and its account.
    fn interval(
        &self,
        h: u64,
        state: &State<R>,
        earlier: Option<R>,
        held: R,
        memory: &Memory<R>,
    ) -> Result<(bool, Acting<R>, R, IntervalRow<R>), Undecided> {
        let acting = Acting {
            earlier,
            held: held.decided()?,
            force: self.force(h),
        };
        let remembered = [memory.samples.front(), memory.past.front()];
        if !remembered.into_iter().flatten().all(Real::is_defined) {
            return Err(Undecided); // A sample that a delayed force will ask for.
        }
        let rests = match state.velocity.sign() {
            _ if self.forgets_after.is_none() => false, // Never for certain, so nobody asks.
            Some(sign) => sign == Ordering::Equal && self.rests(h, state, &acting)?,
            // Resting or not quite: what comes is the same, but when it began is not known.
            None if self.rests(h, state, &acting)? => return Err(Undecided),
            None => false,
        };
        let way = self.way(state, &acting)?;
        let row = self.account(h, state, &acting, &way)?;
        Ok((rests, acting, way.end.output, row))
    }

    /// The motion over an interval.
    fn way(&self, state: &State<R>, acting: &Acting<R>) -> Result<Way<R>, Undecided> {
        let mut all: Option<Way<R>> = None;
        let commands = acting.earlier.iter().chain([&acting.held]);
        for (part, command) in self.parts.iter().zip(commands) {
            let from = all.as_ref().map_or(state, |way| &way.end);
            let way = part.way(from, command, &acting.force)?;
            all = Some(match all {
                None => way,
                Some(before) => before.and(way),
            });
        }
        all.ok_or(Undecided)
    }

    /// The account of an interval: what was generated is the kernel's, by the force that acted.
    fn account(
        &self,
        h: u64,
        state: &State<R>,
        acting: &Acting<R>,
        way: &Way<R>,
    ) -> Result<IntervalRow<R>, Undecided> {
        let step = Step::new(state.xi.clone(), way.end.xi.clone());
        let d = step.displacement();
        let interval = HeldInterval {
            step,
            force: acting.held.clone(),
            dtau: R::one(),
            extra_storage: None,
        };
        let mut generated = ledger::generated(&self.dimensionless, &interval);
        if self.is_late() || self.flow.as_ref().is_some_and(|flow| flow.rate.is_some()) {
            // Behind a latency or an amplifier another force acted than the one that was held.
            let difference = way.work.clone() - acting.held.clone() * d.clone();
            generated = generated.map(|energy| energy + difference.clone());
        }
        let [linear, quantized] = generated;
        let mass = self.flow.as_ref().map_or(&self.mass, |flow| &flow.mass);
        let squares = way.end.velocity.square() - state.velocity.square();
        let kinetic = (mass.clone() * squares).half();
        let by_operator = acting.force.clone() * d;
        let residual =
            kinetic + way.dissipated.clone() + way.arm.clone() - way.work.clone() - by_operator;
        Ok(IntervalRow {
            h,
            step: interval.step,
            velocity: [state.velocity.clone(), way.end.velocity.clone()],
            generated: [linear.decided()?, quantized.decided()?],
            dissipated: way.dissipated.clone().decided()?,
            residual: residual.decided()?,
        })
    }

    /// The operator's force over interval h.
    fn force(&self, h: u64) -> R {
        let forces = self.forces.as_ref();
        let force = forces.and_then(|forces| of_interval(&forces.samples, h));
        force.cloned().unwrap_or_else(R::zero)
    }

    /// Whether friction takes the forces that act and the one that it tends to, and with every force of
    /// the operator to come.
    fn rests(&self, h: u64, state: &State<R>, acting: &Acting<R>) -> Result<bool, Undecided> {
        let held = &acting.held;
        let sigma = self.dimensionless.coulomb_friction();
        let now = match &self.flow {
            Some(flow) if flow.rate.is_some() => &state.output,
            _ => held,
        };
        let arm = self.flow.as_ref().and_then(|flow| flow.arm.as_ref());
        let forces = self.forces.as_ref();
        let range = forces.and_then(|forces| of_interval(&forces.from_here, h));
        let range = range.cloned().unwrap_or_else(|| [R::zero(), R::zero()]);
        let settled = (!self.controller.filter.ends()).then(|| {
            let measured = self.controller.measured(&state.xi);
            self.controller.settled(&measured)
        });
        let commands = [now, held].into_iter().chain(&acting.earlier);
        for output in commands.chain(&settled) {
            for force in &range {
                let mut net = output.clone() + force.clone();
                if let Some([_, stiffness]) = arm {
                    net = net - stiffness.clone() * state.xi.clone();
                }
                if net.abs().compare(&sigma).ok_or(Undecided)?.is_gt() {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }
}

/// The item of interval h; the last one stays.
fn of_interval<T>(items: &[T], h: u64) -> Option<&T> {
    let index = usize::try_from(h).ok();
    index.and_then(|index| items.get(index)).or(items.last())
}

impl<R> Forces<R> {
    fn new(samples: &[BigRational], of: &impl Fn(&BigRational) -> R) -> Self {
        let mut from_here = Vec::with_capacity(samples.len());
        let mut range: Option<[&BigRational; 2]> = None;
        for force in samples.iter().rev() {
            let [least, most] = range.unwrap_or([force, force]);
            let now = [least.min(force), most.max(force)];
            range = Some(now);
            from_here.push(now.map(of));
        }
        from_here.reverse();
        Self {
            samples: samples.iter().map(of).collect(),
            from_here,
        }
    }
}

impl<R> State<R> {
    /// The end of a run in this state.
    fn ended(self, halt: Halt, intervals: u64) -> Ended<R> {
        Ended {
            halt,
            intervals,
            xi: self.xi,
            velocity: self.velocity,
        }
    }
}
