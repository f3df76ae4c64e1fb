//! The reference and the enclosure method: numbers of any precision.

use std::cmp::Ordering;

use passivity_core::controller::Memory;
use passivity_core::{BigRational, Controller, Ordered as _, Scalar as _};
use passivity_scene::Point;

use crate::error::SimError;
use crate::flow::State;
use crate::law::{self, ENCODER, FORCE_STEP, HeldForce};
use crate::ledger::Totals;
use crate::methods::general::{grows, simulated};
use crate::model::{Halt, IntervalRow, Model};
use crate::number::big::Big;
use crate::number::directed::Directed;
use crate::number::enclosed::Enclosed;
use crate::number::{Double, Real, Undecided};
use crate::plan::Plan;
use crate::simulated::{Detail, Each, Line, Simulated};

/// Bits beyond what the user asked for: what 10⁸ intervals of rounding can eat, and more.
const SPARE_BITS: u32 = 64;

/// The precisions that an enclosure is tried with after doubles.
const WIDER: [usize; 3] = [128, 256, 512];

/// The motion with a number of decimal digits.
pub(super) fn reference(
    point: &Point,
    plan: &Plan,
    digits: u32,
    mut each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    // log₂ 10 < 3.322; precision comes in words of 64 bits.
    let bits = (f64::from(digits) * 3.322).ceil() as u32 + SPARE_BITS;
    let bits = bits.next_multiple_of(64) as usize;
    let model = Model::new(point, plan, |x| Big::new(x, bits))?;
    let mut totals = Totals::default();
    let mut edges = Edges::new(point, plan, digits, bits)?;
    let ended = model.run(plan.intervals, u64::MAX, grows(plan), |row| {
        let entry = row.entry();
        totals.add(&entry);
        edges.see(row);
        each.as_mut().is_none_or(|each| each(&Line::Double(&entry)))
    });
    let shown = |x: &Big, figure| {
        x.decimal(digits as usize).ok_or(SimError::NotFinite {
            interval: ended.intervals,
            figure,
        })
    };
    let detail = Detail::Digits([shown(&ended.xi, "xi")?, shown(&ended.velocity, "velocity")?]);
    let mut run = simulated(plan, &ended, totals.settled(), detail);
    run.end.within_rounding_of_edge = edges.first;
    Ok(run)
}

/// Which sample of a reference is the first that its digits do not tell from an edge.
struct Edges {
    law: HeldForce,
    /// The controller without the D/A converter, where what this rounds is not known exactly.
    unrounded: Option<(Controller<Big>, Memory<Big>)>,
    /// A step of the D/A converter.
    step: Big,
    /// The last of the digits, of a tick or of the position; and what of the position the force is off by then.
    digit: [Big; 2],
    /// The greatest |ξ| so far.
    reach: Big,
    /// Whether the device is still where it started, on an edge exactly.
    on_edge: bool,
    first: Option<u64>,
}

impl Edges {
    fn new(point: &Point, plan: &Plan, digits: u32, bits: usize) -> Result<Self, SimError> {
        let [start, _] = point.start();
        let ten = BigRational::from_integer(10.into());
        let power = (0..digits).fold(BigRational::one(), |power, _| power * &ten);
        let number = |x: &BigRational| Big::new(x, bits);
        let digit = number(&power.recip());
        let amplified = BigRational::from_float(plan.law.amplified());
        let of_force = amplified.map_or_else(Big::undefined, |x| digit.clone() * number(&x));
        let law = plan.law.clone();
        let unrounded = if law.has(FORCE_STEP) && (law.lingers() || !law.has(ENCODER)) {
            let controller = Controller {
                force_step: None,
                max_force: None,
                ..law::controller(&point.at, number)?
            };
            let memory = controller.at_rest(&number(&start));
            Some((controller, memory))
        } else {
            None
        };
        let step = point.at.force_step.as_ref();
        Ok(Self {
            unrounded,
            step: step.map_or_else(Big::one, number),
            digit: [digit, of_force],
            reach: Big::zero(),
            on_edge: if law.has(ENCODER) {
                start.is_integer()
            } else {
                start == BigRational::zero()
            },
            law,
            first: None,
        })
    }

    fn see(&mut self, row: &IntervalRow<Big>) {
        let xi = &row.step.start;
        let still = self.on_edge;
        self.on_edge &= row.step.end.compare(xi).is_some_and(Ordering::is_eq);
        if self.first.is_some() {
            return;
        }
        self.reach = self.reach.clone().max(xi.abs());
        let [digit, of_force] = &self.digit;
        let is_near = |off: Big, least: Big| !off.compare(&least).is_some_and(Ordering::is_ge);
        let off = |x: &Big| (x.clone() - (x.clone() + Big::one().half()).floor()).abs();
        let on_edge = !still
            && if self.law.has(ENCODER) {
                is_near(off(xi), digit.clone() * xi.abs().max(Big::one()))
            } else {
                self.law.jumps_at_surface() && is_near(xi.abs(), digit.clone() * self.reach.clone())
            };
        let in_middle = self.unrounded.as_mut().is_some_and(|(controller, memory)| {
            let steps = controller.sample(memory, xi).over(self.step.clone()) + Big::one().half();
            let least = of_force.clone() * self.reach.clone().max(self.step.clone());
            is_near(off(&steps) * self.step.clone(), least)
        });
        if on_edge || in_middle {
            let late = if on_edge { 0 } else { self.law.delay as u64 };
            self.first = Some(row.h.saturating_sub(late));
        }
    }
}

/// Rigorous bounds: doubles first, then more and more bits until every edge is decided.
pub(super) fn enclosure(
    point: &Point,
    plan: &Plan,
    mut each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    let narrow = Model::new(point, plan, |x| Enclosed::<Double>::from(x))?;
    let mut last = watched(plan, &narrow, false, &mut each);
    for (tried, bits) in (1..).zip(WIDER) {
        if !matches!(last.0, Halt::Undecided(_)) {
            break;
        }
        let wide = Model::new(point, plan, |x| Enclosed::wide(x, bits))?;
        last = watched(plan, &wide, tried == WIDER.len(), &mut each);
    }
    let (_, simulated) = last;
    Ok(simulated)
}

/// A run of intervals, shown to who wants to see them if it decided, or if it is the `final_try`.
fn watched<T: Directed>(
    plan: &Plan,
    model: &Model<Enclosed<T>>,
    final_try: bool,
    each: &mut Option<Each<'_>>,
) -> (Halt, Simulated) {
    let first = bounded(plan, model, None);
    let settled = final_try || !matches!(first.0, Halt::Undecided(_));
    match each.as_mut() {
        Some(each) if settled => bounded(plan, model, Some(*each)),
        _ => first,
    }
}

/// A run of intervals.
fn bounded<T: Directed>(
    plan: &Plan,
    model: &Model<Enclosed<T>>,
    mut each: Option<Each<'_>>,
) -> (Halt, Simulated) {
    let mut totals = Totals::default();
    let growing = |state: &State<Enclosed<T>>, memory: &Memory<Enclosed<T>>| {
        // At every corner of what is enclosed; the samples are decided already.
        let [xis, velocities, outputs] =
            [&state.xi, &state.velocity, &state.output].map(Enclosed::near_ends);
        let corners = xis.map(|xi| {
            velocities.map(|velocity| {
                outputs.map(|output| State {
                    xi,
                    velocity,
                    output,
                })
            })
        });
        let corners = corners.as_flattened().as_flattened().iter();
        let mut answers = corners.map(|state| {
            plan.growth
                .certain(state, memory.samples.iter().map(Real::approximate))
        });
        let first = answers.next().ok_or(Undecided)?;
        if answers.all(|other| other == first) {
            Ok(first)
        } else {
            Err(Undecided)
        }
    };
    let ended = model.run(plan.intervals, u64::MAX, growing, |row| {
        totals.add(&row.entry());
        match &mut each {
            Some(each) => {
                let narrowed = row.map(|x| {
                    let [lo, hi] = x.bounds();
                    Enclosed::new(Double(lo), Double(hi))
                });
                each(&Line::Enclosed(&narrowed))
            }
            None => true,
        }
    });
    let detail = Detail::Enclosed {
        ends: [ended.xi.bounds(), ended.velocity.bounds()],
        bits: model.bits(),
    };
    (
        ended.halt,
        simulated(plan, &ended, totals.settled(), detail),
    )
}
