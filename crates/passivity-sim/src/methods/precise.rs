//! The reference and the enclosure method: numbers of any precision.

use passivity_scene::Point;

use crate::big::Big;
use crate::enclosed::{Directed, Enclosed};
use crate::error::SimError;
use crate::flow::State;
use crate::ledger::{Entry, Totals};
use crate::methods::general::{energies, grows, simulated};
use crate::methods::{Detail, Each, Line, Simulated};
use crate::model::{Halt, Memory, Model, Row};
use crate::plan::Plan;
use crate::real::{Real, Undecided};

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
