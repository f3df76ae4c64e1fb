//! The exact, the reference and the enclosure method: the same model in three kinds of numbers.

use passivity_core::BigRational;
use passivity_scene::Point;

use crate::big::Big;
use crate::enclosed::{Directed, Enclosed};
use crate::error::SimError;
use crate::flow::State;
use crate::ledger::{Entry, Totals};
use crate::methods::{Detail, Each, Line, Simulated};
use crate::model::{Ended, Halt, Memory, Model, Number, Row};
use crate::outcome::{End, Exactly, Stop};
use crate::plan::Plan;
use crate::real::{Real, Undecided};
use crate::run;

/// The longest exact position, numerator and denominator together.
pub(super) const LONGEST: u64 = 4096;

/// Bits beyond what the user asked for: what 10⁸ intervals of rounding can eat, and more.
const SPARE_BITS: u32 = 64;

/// The precisions that an enclosure is tried with after doubles.
const WIDER: [usize; 3] = [128, 256, 512];

/// The whole motion in rational numbers.
pub(super) fn exact(
    point: &Point,
    plan: &Plan,
    mut each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    let model = Model::new(point, plan, BigRational::clone);
    let mut totals = Totals::default();
    let mut sums: [BigRational; 3] = Default::default();
    let ended = model.run(plan.intervals, LONGEST, grows(plan), |row| {
        for (sum, term) in sums.iter_mut().zip(energies(row)) {
            *sum += term;
        }
        totals.residual_max = totals.residual_max.max(row.residual.approximate().abs());
        each.as_mut().is_none_or(|each| each(&Line::Exact(row)))
    });
    if let Halt::TooLong(interval) = ended.halt {
        return Err(SimError::Denominator {
            interval,
            bits: LONGEST,
        });
    }
    [
        totals.generated_linear,
        totals.generated_quantized,
        totals.dissipated,
    ] = sums.map(|sum| sum.approximate());
    let detail = Detail::Exact([ended.xi.to_string(), ended.velocity.to_string()]);
    Ok(simulated(plan, &ended, totals, detail))
}

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
    let model = Model::new(point, plan, |x| Big::new(x, bits));
    let mut totals = Totals::default();
    let ended = model.run(plan.intervals, u64::MAX, grows(plan), |row| {
        let entry = in_doubles(row);
        totals.add(&entry);
        each.as_mut().is_none_or(|each| each(&Line::Double(&entry)))
    });
    let shown = |x: &Big| x.decimal(digits as usize);
    let detail = Detail::Digits([shown(&ended.xi), shown(&ended.velocity)]);
    Ok(simulated(plan, &ended, totals.settled(), detail))
}

/// Rigorous bounds: doubles first, then more and more bits until every edge is decided.
pub(super) fn enclosure(
    point: &Point,
    plan: &Plan,
    mut each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    let decided = |halt| !matches!(halt, Halt::Undecided(_));
    let narrow = Model::new(point, plan, Enclosed::double);
    let mut last = bounded(plan, &narrow, 53, None);
    if decided(last.0) {
        if each.is_some() {
            last = bounded(plan, &narrow, 53, each);
        }
        return Ok(last.1);
    }
    for bits in WIDER {
        let wide = Model::new(point, plan, |x| Enclosed::wide(x, bits));
        last = bounded(plan, &wide, bits as u32, None);
        let final_try = Some(&bits) == WIDER.last();
        if decided(last.0) || final_try {
            if each.is_some() {
                last = bounded(plan, &wide, bits as u32, each.take());
            }
            break;
        }
    }
    Ok(last.1)
}

/// A run of intervals.
fn bounded<T: Directed>(
    plan: &Plan,
    model: &Model<Enclosed<T>>,
    bits: u32,
    mut each: Option<Each<'_>>,
) -> (Halt, Simulated) {
    let mut totals = Totals::default();
    let growing = |state: &State<Enclosed<T>>, memory: &Memory<Enclosed<T>>| {
        // At every corner of what is enclosed; the samples are decided already.
        let ([a, b], [c, d]) = (state.xi.ends(), state.velocity.ends());
        let corners = [[a, c], [a, d], [b, c], [b, d]].map(|[xi, velocity]| {
            let output = state.output.approximate();
            let state = State {
                xi,
                velocity,
                output,
            };
            plan.growth
                .certain(&state, memory.iter().map(Real::approximate))
        });
        if corners.iter().all(|c| *c == corners[0]) {
            Ok(corners[0])
        } else {
            Err(Undecided)
        }
    };
    let ended = model.run(plan.intervals, u64::MAX, growing, |row| {
        totals.add(&in_doubles(row));
        match &mut each {
            Some(each) => each(&Line::Enclosed(&narrowed(row))),
            None => true,
        }
    });
    let detail = Detail::Enclosed {
        ends: [outwards(&ended.xi), outwards(&ended.velocity)],
        bits,
    };
    (
        ended.halt,
        simulated(plan, &ended, totals.settled(), detail),
    )
}

/// An enclosure by doubles of what may have more bits.
fn outwards<T: Directed>(x: &Enclosed<T>) -> [f64; 2] {
    let [lo, hi] = x.ends();
    if x.lo.precision() <= 53 {
        return [lo, hi];
    }
    [lo.next_down(), hi.next_up()]
}

fn narrowed<T: Directed>(row: &Row<Enclosed<T>>) -> Row<Enclosed<f64>> {
    let narrow = |x: &Enclosed<T>| {
        let [lo, hi] = outwards(x);
        Enclosed { lo, hi }
    };
    Row {
        h: row.h,
        xi: [narrow(&row.xi[0]), narrow(&row.xi[1])],
        velocity: [narrow(&row.velocity[0]), narrow(&row.velocity[1])],
        generated_linear: narrow(&row.generated_linear),
        generated_quantized: narrow(&row.generated_quantized),
        dissipated: narrow(&row.dissipated),
        residual: narrow(&row.residual),
    }
}

/// The test for certain growth, by doubles near the state; its radius has room for that.
fn grows<R: Real>(plan: &Plan) -> impl FnMut(&State<R>, &Memory<R>) -> Result<bool, Undecided> {
    |state, memory| {
        let near = State {
            xi: state.xi.approximate(),
            velocity: state.velocity.approximate(),
            output: state.output.approximate(),
        };
        Ok(plan
            .growth
            .certain(&near, memory.iter().map(Real::approximate)))
    }
}

fn energies<R: Clone>(row: &Row<R>) -> [R; 3] {
    [
        row.generated_linear.clone(),
        row.generated_quantized.clone(),
        row.dissipated.clone(),
    ]
}

fn in_doubles<R: Real>(row: &Row<R>) -> Entry {
    let [linear, quantized, dissipated] = energies(row).map(|x| x.approximate());
    Entry {
        h: row.h,
        xi0: row.xi[0].approximate(),
        xi1: row.xi[1].approximate(),
        v0: row.velocity[0].approximate(),
        v1: row.velocity[1].approximate(),
        held: 0.0,
        force: 0.0,
        generated_linear: linear,
        generated_quantized: quantized,
        dissipated,
        residual: row.residual.approximate(),
    }
}

fn simulated<R: Number>(
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
    let mut outcome = run::facts(plan).judge(stop, xi, velocity, &plan.growth.words());
    if let Halt::Undecided(h) = ended.halt {
        outcome.exact = Exactly::Undecided;
        outcome.at_interval = Some(h);
        outcome.because = format!(
            "in interval {h} an enclosure holds both sides of an encoder edge or of a stop, with the \
             most bits that were tried"
        );
    }
    Simulated {
        end: End {
            intervals: ended.intervals,
            xi,
            velocity,
            outcome,
        },
        totals,
        detail,
    }
}
