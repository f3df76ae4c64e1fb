//! The exact method, and what the reference and the enclosure share with it: the same model in three
//! kinds of numbers.

use passivity_core::BigRational;
use passivity_core::controller::Memory;
use passivity_scene::Point;

use crate::error::SimError;
use crate::flow::State;
use crate::ledger::Totals;
use crate::model::{Ended, Halt, Model};
use crate::number::{Real, Undecided};
use crate::outcome::{End, ExactOutcome, Stop};
use crate::plan::Plan;
use crate::run;
use crate::simulated::{Detail, Each, Line, Simulated};

/// The longest exact position, numerator and denominator together.
const LONGEST: u64 = 4096;

/// The whole motion in rational numbers.
pub(super) fn exact(
    point: &Point,
    plan: &Plan,
    mut each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    let model = Model::new(point, plan, BigRational::clone)?;
    let mut residual_max = 0.0_f64;
    let mut sums: [BigRational; 3] = Default::default();
    let ended = model.run(plan.intervals, LONGEST, grows(plan), |row| {
        let terms = row.generated.iter().chain([&row.dissipated]);
        for (sum, term) in sums.iter_mut().zip(terms) {
            *sum += term;
        }
        residual_max = residual_max.max(row.residual.approximate().abs());
        each.as_mut().is_none_or(|each| each(&Line::Exact(row)))
    });
    if let Halt::TooLong(interval) = ended.halt {
        return Err(SimError::Denominator {
            interval,
            bits: LONGEST,
        });
    }
    let totals = Totals::of(sums.map(|sum| sum.approximate()), residual_max);
    let detail = Detail::Exact([ended.xi.to_string(), ended.velocity.to_string()]);
    Ok(simulated(plan, &ended, totals, detail))
}

/// The test for certain growth, by doubles near the state; its radius has room for that.
pub(super) fn grows<R: Real>(
    plan: &Plan,
) -> impl FnMut(&State<R>, &Memory<R>) -> Result<bool, Undecided> {
    |state, memory| {
        let near = state.map(Real::approximate);
        Ok(plan
            .growth
            .certain(&near, memory.samples.iter().map(Real::approximate)))
    }
}

pub(super) fn simulated<R: Real>(
    plan: &Plan,
    ended: &Ended<R>,
    totals: Totals,
    detail: Detail,
) -> Simulated {
    let (xi, velocity) = (ended.xi.approximate(), ended.velocity.approximate());
    let stop = match ended.halt {
        Halt::Rest(h) => Stop::Rest(h),
        Halt::Growing(h) => Stop::Growing(h),
        Halt::Ran(h) | Halt::Undecided(h) | Halt::TooLong(h) => Stop::Ran(h),
    };
    let mut outcome = run::facts(plan).judge(stop, xi, velocity, &plan.growth_words());
    if let Halt::Undecided(h) = ended.halt {
        outcome.exact = ExactOutcome::Undecided;
        outcome.at_interval = Some(h);
        let words = plan.edge_words();
        let edge = if words.is_empty() {
            words
        } else {
            format!("{words} or of ")
        };
        outcome.because = format!(
            "in interval {h} an enclosure holds both sides of {edge}a stop, with the most bits that were tried"
        );
    }
    Simulated {
        end: End {
            intervals: ended.intervals,
            xi,
            velocity,
            outcome,
            within_rounding_of_edge: None,
        },
        totals,
        detail,
    }
}
