//! The motion and the controller for any [`Real`]: one text for rationals, numbers of any precision
//! and rigorous intervals. [`crate::motion`] explains the formulas; here they are written plainly.

mod interval;
mod law;

use std::cmp::Ordering;

use passivity_core::BigRational;
use passivity_scene::Point;

use crate::flow::{Flow, State};
use crate::plan::Plan;
use crate::real::{Real, Undecided};
use crate::series;
use law::Law;

/// A scene in the numbers of a method.
#[derive(Clone, Debug)]
pub struct Model<R> {
    mu: R,
    /// β, when there is viscous friction and it is not zero.
    beta: Option<R>,
    sigma: Option<R>,
    lambda: R,
    whole: series::Interval<R>,
    law: Law<R>,
    forces: Option<Forces<R>>,
    flow: Option<Flow<R>>,
    start: [R; 2],
}

/// The operator's force: one per interval, and the range of each with all that follow.
#[derive(Clone, Debug)]
struct Forces<R> {
    samples: Vec<R>,
    from_here: Vec<[R; 2]>,
}

/// What the controller remembers: samples, the latest first.
pub type Memory<R> = std::collections::VecDeque<R>;

/// Where an interval led.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved<R> {
    /// ξ at the end.
    pub xi: R,
    /// ξ̇ at the end.
    pub velocity: R,
    /// E_d.
    pub dissipated: R,
}

/// An interval of a run; energies in KΔ².
#[derive(Clone, Debug, PartialEq)]
pub struct Row<R> {
    /// The interval.
    pub h: u64,
    /// ξ at its start and end.
    pub xi: [R; 2],
    /// ξ̇ at its start and end.
    pub velocity: [R; 2],
    /// E_gᴸ.
    pub generated_linear: R,
    /// E_g.
    pub generated_quantized: R,
    /// E_d.
    pub dissipated: R,
    /// What the balance (13) is off by.
    pub residual: R,
}

/// How a run of a model stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halt {
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
pub struct Ended<R> {
    /// How it stopped.
    pub halt: Halt,
    /// How many intervals were run.
    pub intervals: u64,
    /// ξ.
    pub xi: R,
    /// ξ̇.
    pub velocity: R,
}

/// A [`Real`] with its way over an interval.
pub trait Number: Real {
    /// The motion over an interval under the force `u`.
    ///
    /// # Errors
    ///
    /// [`Undecided`] when the number cannot tell whether the device moves.
    fn over(model: &Model<Self>, xi: &Self, v: &Self, u: &Self) -> Result<Moved<Self>, Undecided> {
        model.advance(xi, v, u)
    }
}

impl Number for f64 {}
impl Number for BigRational {}
#[cfg(feature = "multiprecision")]
impl Number for crate::big::Big {}

impl<T: crate::enclosed::Directed> Number for crate::enclosed::Enclosed<T> {
    /// ξ and ξ̇ at the end grow with ξ̇ at the start, because motions under the same force do not
    /// cross: the ends of the interval lead to the ends of what comes out. So each is followed by
    /// itself, where every sign is known, and nothing widens but by rounding and by the motion.
    fn over(model: &Model<Self>, xi: &Self, v: &Self, u: &Self) -> Result<Moved<Self>, Undecided> {
        if v.is_thin() {
            return model.advance(xi, v, u);
        }
        let [low, high] = [&v.lo, &v.hi].map(|end| model.advance(&xi.zero(), &Self::thin(end), u));
        let (low, high) = (low?, high?);
        let d = low.xi.hull(high.xi);
        let velocity = low.velocity.hull(high.velocity);
        // What friction took is not monotone, but it is what the balance leaves over.
        let squares = velocity.clone() * velocity.clone() - v.clone() * v.clone();
        let kinetic = model.mu.clone() * squares * u.ratio(1, 2);
        Ok(Moved {
            dissipated: u.clone() * d.clone() - kinetic,
            xi: xi.clone() + d,
            velocity,
        })
    }
}

impl<R: Number> Model<R> {
    /// A scene's point in the numbers that `of` makes; the point has been compiled to `plan` before.
    pub fn new(point: &Point, plan: &Plan, of: impl Fn(&BigRational) -> R) -> Self {
        let zero = of(&BigRational::from_integer(0.into()));
        let number = |x: &Option<BigRational>| x.as_ref().map(&of);
        let mu = number(&point.mu).unwrap_or_else(|| zero.one());
        let beta = number(&point.beta).filter(|beta| beta.sign() != Ok(Ordering::Equal));
        let lambda = match &beta {
            Some(beta) => beta.clone() / mu.clone(),
            None => zero.clone(),
        };
        let whole = if beta.is_some() {
            series::interval(&lambda)
        } else {
            series::Interval {
                decay: zero.one(),
                phi1: zero.one(),
                phi2: zero.ratio(1, 2),
                double: zero.one(),
                chi: zero.ratio(1, 3),
            }
        };
        let flow = plan.flow.as_ref().map(|fast| Flow {
            mass: match &point.arm {
                Some([mass, ..]) => mu.clone() + of(mass),
                None => mu.clone(),
            },
            beta: beta.clone().unwrap_or_else(|| zero.clone()),
            sigma: number(&point.sigma),
            rate: point.amplifier.as_ref().map(|time| zero.one() / of(time)),
            arm: point
                .arm
                .as_ref()
                .map(|[_, damping, stiffness]| [of(damping), of(stiffness)]),
            pieces: fast.pieces,
        });
        Self {
            mu,
            beta,
            sigma: number(&point.sigma),
            lambda,
            whole,
            law: Law {
                encoder: point.encoder,
                delay: usize::from(point.delay),
                unilateral: point.unilateral,
                damping: number(&point.damping),
                step: point.force_step.as_ref().map(|step| {
                    [step.numer(), step.denom()].map(|n| of(&BigRational::from_integer(n.clone())))
                }),
                limit: number(&point.max_force),
            },
            forces: point.force.as_ref().map(|forces| Forces::new(forces, &of)),
            flow,
            start: [of(&point.start[0]), of(&point.start[1])],
        }
    }

    /// Runs the model for at most `intervals` intervals, numbers no longer than `longest` bits.
    ///
    /// `growing` says from which state on divergence is certain; `each` sees every interval, and stops
    /// the run by saying `false`.
    pub fn run(
        &self,
        intervals: u64,
        longest: u64,
        mut growing: impl FnMut(&State<R>, &Memory<R>) -> Result<bool, Undecided>,
        mut each: impl FnMut(&Row<R>) -> bool,
    ) -> Ended<R> {
        let [mut xi, mut v] = self.start.clone();
        let (mut memory, mut output) = match self.settle() {
            Ok(settled) => settled,
            Err(Undecided) => return ended(Halt::Undecided(0), 0, xi, v),
        };
        let needed = self.law.forgets_after();
        let mut resting = 0;
        for h in 0..intervals {
            let step = self.interval(h, [&xi, &v], &mut memory, &mut output, &mut growing);
            let (rests, row) = match step {
                Ok(Some(step)) => step,
                Ok(None) => return ended(Halt::Growing(h), h, xi, v),
                Err(Undecided) => return ended(Halt::Undecided(h), h, xi, v),
            };
            resting = if rests { resting + 1 } else { 0 };
            if resting > needed {
                return ended(Halt::Rest(h - needed), h, xi, v);
            }
            let go_on = each(&row);
            let ([_, next], [_, speed]) = (row.xi, row.velocity);
            (xi, v) = (next, speed);
            if xi.length() > longest {
                return ended(Halt::TooLong(h), h + 1, xi, v);
            }
            if !go_on {
                return ended(Halt::Ran(h + 1), h + 1, xi, v);
            }
        }
        ended(Halt::Ran(intervals), intervals, xi, v)
    }

    /// The controller's memory and the amplifier's output when the device has been at the start for ever.
    fn settle(&self) -> Result<(Memory<R>, R), Undecided> {
        let sample = self.law.sample(&self.start[0])?;
        let history = self.law.delay + usize::from(self.law.damping.is_some());
        let memory: Memory<R> = std::iter::repeat_n(sample, history).collect();
        let output = self.law.held(&self.start[0], &mut memory.clone())?;
        Ok((memory, output))
    }

    /// One interval: whether the device rests in it for good as far as it goes, and its account;
    /// `None` when divergence is certain.
    fn interval(
        &self,
        h: u64,
        [xi, v]: [&R; 2],
        memory: &mut Memory<R>,
        output: &mut R,
        growing: &mut impl FnMut(&State<R>, &Memory<R>) -> Result<bool, Undecided>,
    ) -> Result<Option<(bool, Row<R>)>, Undecided> {
        let state = State {
            xi: xi.clone(),
            velocity: v.clone(),
            output: output.clone(),
        };
        if growing(&state, memory)? {
            return Ok(None);
        }
        let held = self.law.held(xi, memory)?;
        let force = self.force(h, xi);
        let at_rest = match v.sign() {
            Ok(sign) => sign == Ordering::Equal,
            // Resting or not quite: what comes is the same, but when it began is not known.
            Err(Undecided) if self.rests(h, xi, &held, output)? => return Err(Undecided),
            Err(Undecided) => false,
        };
        let rests = at_rest && self.rests(h, xi, &held, output)?;
        let (end, speed, dissipated, work, arm) = match &self.flow {
            None => {
                let u = held.clone() + force.clone();
                let moved = R::over(self, xi, v, &u)?;
                let work = held.clone() * (moved.xi.clone() - xi.clone());
                (moved.xi, moved.velocity, moved.dissipated, work, xi.zero())
            }
            Some(flow) => {
                let flowed = flow.advance(&state, &held, &force, true)?;
                *output = flowed.end.output;
                let sigma = flow.sigma.clone().unwrap_or_else(|| xi.zero());
                let dissipated = flow.beta.clone() * flowed.square.clone() + sigma * flowed.path;
                let d = flowed.end.xi.clone() - xi.clone();
                let arm = match &flow.arm {
                    Some([damping, stiffness]) => {
                        let middle = xi.clone() + d.clone() * xi.ratio(1, 2);
                        damping.clone() * flowed.square + stiffness.clone() * d * middle
                    }
                    None => xi.zero(),
                };
                (
                    flowed.end.xi,
                    flowed.end.velocity,
                    dissipated,
                    flowed.work,
                    arm,
                )
            }
        };
        let mass = self
            .flow
            .as_ref()
            .map_or(&self.mu, |flow| &flow.mass)
            .clone();
        let squares = speed.clone() * speed.clone() - v.clone() * v.clone();
        let kinetic = mass * squares * xi.ratio(1, 2);
        let by_operator = force * (end.clone() - xi.clone());
        let [linear, quantized] = self.law.potentials(xi, &end)?;
        let row = Row {
            h,
            generated_linear: work.clone() + linear,
            generated_quantized: work.clone() + quantized,
            residual: kinetic + dissipated.clone() + arm - work - by_operator,
            dissipated,
            xi: [xi.clone(), end],
            velocity: [v.clone(), speed],
        };
        Ok(Some((rests, row)))
    }

    fn force(&self, h: u64, like: &R) -> R {
        let at = self
            .forces
            .as_ref()
            .and_then(|forces| at(&forces.samples, h));
        at.cloned().unwrap_or_else(|| like.zero())
    }

    /// Whether friction takes the held force now, and with every force of the operator to come.
    fn rests(&self, h: u64, xi: &R, held: &R, output: &R) -> Result<bool, Undecided> {
        let sigma = self.sigma.clone().unwrap_or_else(|| xi.zero());
        let now = match &self.flow {
            Some(flow) if flow.rate.is_some() => output,
            _ => held,
        };
        let arm = self.flow.as_ref().and_then(|flow| flow.arm.as_ref());
        let range = self
            .forces
            .as_ref()
            .and_then(|forces| at(&forces.from_here, h));
        let range = range.cloned().unwrap_or_else(|| [xi.zero(), xi.zero()]);
        for acting in [now, held] {
            for force in &range {
                let mut net = acting.clone() + force.clone();
                if let Some([_, stiffness]) = arm {
                    net = net - stiffness.clone() * xi.clone();
                }
                if net.magnitude()?.compare(&sigma)? == Ordering::Greater {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }
}

/// The item of interval h; the last one stays.
fn at<T>(items: &[T], h: u64) -> Option<&T> {
    let index = usize::try_from(h).unwrap_or(usize::MAX);
    items.get(index).or(items.last())
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

fn ended<R>(halt: Halt, intervals: u64, xi: R, velocity: R) -> Ended<R> {
    Ended {
        halt,
        intervals,
        xi,
        velocity,
    }
}
