//! The operations: `interval`, `run`, `motion`, `check`, `version`.

use num_bigint::BigInt;
use passivity_core::rational::{from_wide, simplest_above, to_wide};
use passivity_core::{BigRational, Friction, Interval, Loop, Scalar};
use passivity_scene::AnyScene;
use serde::Serialize;

use super::fields::{Fields, bad, duration, list, missing, number, sample};
use super::work::{self, Work};
use super::{At, MAX_ANSWER, PROTOCOL, Refusal, shown};
use crate::motion::Piece;
use passivity_audit::Reading;
use passivity_audit::json::{self, NumberedRow};
use passivity_audit::number::Number;
use passivity_audit::run::Run;
use passivity_audit::{Ledger, Logged};

/// The fields that describe a loop, shared by `interval` and `run`.
const LOOP: [&str; 8] = [
    "beta",
    "sigma",
    "encoder",
    "delay",
    "damping",
    "force_step",
    "unilateral",
    "max_force",
];

/// The longest delay, in samples: that of a scene file.
const MAX_DELAY: u64 = 1000;

/// Appends the result of a request.
pub(super) fn run(fields: &Fields<'_>, work: Work, out: &mut Vec<u8>) -> Result<(), Refusal> {
    match fields.text("op")? {
        "interval" => put(&interval(fields, work)?, out),
        "run" => sequence(fields, work, out),
        "motion" => motion(fields, out),
        "check" => verdict(fields, work, out),
        "version" => {
            fields.only(&[])?;
            put(&VERSION, out)
        }
        other => Err(Refusal::new(
            "unknown_op",
            At::Field("op".to_owned()),
            format!(
                "unknown operation `{}`; expected one of {}",
                shown(other),
                OPS.join(", ")
            ),
        )),
    }
}

/// Every operation.
const OPS: [&str; 5] = ["interval", "run", "motion", "check", "version"];

/// What speaks here.
#[derive(Serialize)]
struct Version {
    name: &'static str,
    version: &'static str,
    protocol: u32,
    ops: [&'static str; 5],
}

const VERSION: Version = Version {
    name: "passivity",
    version: env!("CARGO_PKG_VERSION"),
    protocol: PROTOCOL,
    ops: OPS,
};

/// Appends a result.
fn put<T: Serialize>(result: &T, out: &mut Vec<u8>) -> Result<(), Refusal> {
    json::write(result, out)
        .map_err(|error| Refusal::new("undefined", At::Request, error.to_string()))
}

/// One ledger row: `xi0` and `xi1`, or `count0` and `count1`; `dtau`, 1 if it is not there; and
/// `force`, what was applied, that of the loop if it is not there.
fn interval(fields: &Fields<'_>, mut work: Work) -> Result<NumberedRow, Refusal> {
    const ENDS: [[&str; 2]; 2] = [["xi0", "xi1"], ["count0", "count1"]];
    let [position, count] = ENDS.map(|names| fields.get(&names));
    if let (Some(_), Some((name, _))) = (position, count) {
        return Err(bad(name, NOT_BOTH));
    }
    let counted = count.is_some();
    let [of_positions, of_counts] = ENDS;
    let names = if counted { of_counts } else { of_positions };
    let known = [&LOOP[..], &["h", "dtau", "force"], &names].concat();
    fields.only(&known)?;
    let position = |name: &'static str| match fields.get(&[name]) {
        Some((_, value)) => sample(value, counted, || name.to_owned()),
        None => Err(missing(name)),
    };
    let [start, end] = names;
    let (start, end) = (position(start)?, position(end)?);
    let dtau = match fields.get(&["dtau"]) {
        Some((name, value)) => duration(value, || name.to_owned())?,
        None => Number::whole(1),
    };
    let force = match fields.get(&["force"]) {
        Some((name, value)) => Some(Reading::Exact(number(value, || name.to_owned())?)),
        None => None,
    };
    let ledger = ledger(fields, counted, &mut work)?;
    let h = fields.natural("h", u64::MAX)?;
    let (ends, forces) = ([start.clone(), end.clone()], force.as_slice());
    let steps = work::of_row(&ledger, &ends, std::slice::from_ref(&dtau), forces);
    work.take(steps, || At::Request)?;
    let logged = Logged {
        samples: vec![start],
        end,
        dtau,
        force,
    };
    let row = ledger.row(&logged).ok_or_else(undefined)?;
    Ok(NumberedRow {
        h,
        row,
        accounted: true,
    })
}

/// Rows and totals: a list `xi` (or `positions`) or `count` (or `counts`), `dtau`, a number or a list
/// with one number per interval, and perhaps `force`, a list with one per interval.
fn sequence(fields: &Fields<'_>, mut work: Work, out: &mut Vec<u8>) -> Result<(), Refusal> {
    let known = [&LOOP[..], &["dtau", "force"], &POSITIONS, &COUNTS].concat();
    fields.only(&known)?;
    let (name, samples) = samples(fields)?;
    let intervals = samples.len() - 1;
    let durations = match fields.get(&["dtau"]) {
        None => vec![Number::whole(1)],
        Some((name, value @ serde_json::Value::Array(_))) => {
            per_interval(name, value, intervals, |value, place| {
                duration(value, place)
            })?
        }
        Some((name, value)) => vec![duration(value, || name.to_owned())?],
    };
    let forces = match fields.get(&["force"]) {
        None => Vec::new(),
        Some((name, value)) => per_interval(name, value, intervals, |value, place| {
            number(value, place).map(Reading::Exact)
        })?,
    };
    let ledger = ledger(fields, COUNTS.contains(&name), &mut work)?;
    let steps = work::of_row(&ledger, &samples, &durations, &forces);
    let rows = u64::try_from(intervals).unwrap_or(u64::MAX);
    work.take(steps.saturating_mul(rows), || At::Field(name.to_owned()))?;
    let (mut durations, mut forces) = (durations.into_iter().cycle(), forces.into_iter());
    let mut run = Run::new(&ledger);
    let start = out.len();
    out.extend_from_slice(b"{\"rows\": [");
    let mut samples = samples.into_iter().enumerate();
    if let Some((_, first)) = samples.next() {
        run.step(first, &Number::whole(1), None)
            .ok_or_else(undefined)?;
    }
    for (i, sample) in samples {
        let dtau = durations.next().ok_or_else(undefined)?;
        let row = run
            .step(sample, &dtau, forces.next())
            .ok_or_else(undefined)?;
        work.take(work::of_sums(run.width()), || {
            At::Field(format!("{name}[{i}]"))
        })?;
        if i > 1 {
            out.extend_from_slice(b", ");
        }
        let h = run.intervals() - 1;
        put(
            &row.map(|row| NumberedRow {
                h,
                row,
                accounted: true,
            }),
            out,
        )?;
        // Rows are many: they are written as they come, and no more than can be kept.
        if out.len() - start > MAX_ANSWER {
            let message = format!("the rows take more than {MAX_ANSWER} bytes");
            let at = At::Field(format!("{name}[{i}]"));
            return Err(Refusal::new("answer_too_long", at, message));
        }
    }
    out.extend_from_slice(b"], \"totals\": ");
    put(&run.totals().ok_or_else(undefined)?, out)?;
    out.push(b'}');
    Ok(())
}

const NOT_BOTH: &str = "positions or counts, not both";
const POSITIONS: [&str; 2] = ["xi", "positions"];
const COUNTS: [&str; 2] = ["count", "counts"];

/// The samples of a run, at least two, and the field that has them.
fn samples(fields: &Fields<'_>) -> Result<(&'static str, Vec<Reading>), Refusal> {
    for [name, spelling] in [POSITIONS, COUNTS] {
        if fields.get(&[name]).is_some() && fields.get(&[spelling]).is_some() {
            return Err(bad(
                spelling,
                format!("`{name}` or `{spelling}`, which are one field, not both"),
            ));
        }
    }
    let (positions, counts) = (fields.get(&POSITIONS), fields.get(&COUNTS));
    let (name, value, counted) = match (positions, counts) {
        (Some((name, value)), None) => (name, value, false),
        (None, Some((name, value))) => (name, value, true),
        (None, None) => return Err(missing("xi")),
        (Some(_), Some((name, _))) => return Err(bad(name, NOT_BOTH)),
    };
    let items = list(name, value)?.iter().enumerate();
    let samples: Result<Vec<Reading>, Refusal> = items
        .map(|(i, item)| sample(item, counted, || format!("{name}[{i}]")))
        .collect();
    let samples = samples?;
    if samples.len() < 2 {
        return Err(bad(name, "expected at least two positions"));
    }
    Ok((name, samples))
}

/// A list with one item for each interval.
fn per_interval<T>(
    name: &'static str,
    value: &serde_json::Value,
    intervals: usize,
    read: impl Fn(&serde_json::Value, &dyn Fn() -> String) -> Result<T, Refusal>,
) -> Result<Vec<T>, Refusal> {
    let items = list(name, value)?;
    if items.len() != intervals {
        let message = format!("expected one number for each of {intervals} intervals");
        return Err(bad(name, message));
    }
    let items = items.iter().enumerate();
    items
        .map(|(i, item)| read(item, &|| format!("{name}[{i}]")))
        .collect()
}

/// Where a piece of motion at a constant force leads, enclosed between decimals.
fn motion(fields: &Fields<'_>, out: &mut Vec<u8>) -> Result<(), Refusal> {
    fields.only(&["mu", "beta", "sigma", "xi", "velocity", "force", "tau"])?;
    // Exact motion of one device.
    let friction = |name: &'static str| {
        let range = fields.friction(name)?;
        match range.is_point() {
            true => Ok(range.lo().clone()),
            false => Err(bad(name, "expected one number, not an interval")),
        }
    };
    let number = |name| fields.rational(name);
    let piece = Piece {
        mu: fields.effect("mu", false)?.ok_or_else(|| missing("mu"))?,
        friction: Friction::new(friction("beta")?, friction("sigma")?),
        xi: number("xi")?,
        velocity: number("velocity")?,
        force: number("force")?,
        duration: fields.effect("tau", true)?.ok_or_else(|| missing("tau"))?,
    };
    let arrival = piece.arrival().ok_or_else(|| {
        let message = "not one piece of motion: at rest, a change of direction, or βτ/μ > 1";
        Refusal::new("out_of_range", At::Request, message)
    })?;
    put(&arrival, out)
}

/// What `passivity check` says of a scene.
fn verdict(fields: &Fields<'_>, mut work: Work, out: &mut Vec<u8>) -> Result<(), Refusal> {
    fields.only(&["scene"])?;
    let (_, value) = fields.get(&["scene"]).ok_or_else(|| missing("scene"))?;
    let place = || At::Field("scene".to_owned());
    work.take(work::of_controller(value), place)?;
    work.take(work::of_damping(value), place)?;
    let scene = AnyScene::from_json(value).map_err(|error| {
        let first = error.diagnostics().first();
        let key = first.and_then(|diagnostic| diagnostic.scene_key());
        let at = key.map_or_else(|| "scene".to_owned(), |key| format!("scene.{key}"));
        let kind = first.map_or("scene", |diagnostic| diagnostic.kind().name());
        Refusal::new(kind, At::Field(at), error.to_string())
    })?;
    work.take(work::of_joints(&scene), place)?;
    serde_json::to_writer(out, &scene.check())
        .map_err(|error| Refusal::new("undefined", At::Request, error.to_string()))
}

/// The ledger of the loop of a request: `beta` and `sigma`, and the effects whose keys are there; `counted` says
/// whether the request is of counts.
fn ledger(fields: &Fields<'_>, counted: bool, work: &mut Work) -> Result<Ledger, Refusal> {
    let one = || Interval::point(BigRational::one());
    let effect = |name, zero_allowed| {
        let value = fields.effect(name, zero_allowed)?;
        Ok::<_, Refusal>(value.map(Interval::point))
    };
    let (beta, sigma) = (fields.friction("beta")?, fields.friction("sigma")?);
    let delay = fields.natural("delay", MAX_DELAY)?;
    let encoder = fields.flag("encoder", true)?;
    if counted && !encoder {
        let message = "counts are those of an encoder: give positions, or leave `encoder` out";
        return Err(bad("encoder", message));
    }
    let dimensionless = Loop {
        viscous: Some(beta),
        coulomb: Some(sigma),
        resolution: encoder.then(one),
        damping: effect("damping", true)?,
        force_step: effect("force_step", false)?,
        max_force: effect("max_force", false)?,
        delay: u16::try_from(delay).map_err(|error| bad("delay", error.to_string()))?,
        unilateral: fields.flag("unilateral", false)?,
        ..Loop::new(one(), one())
    };
    work.take(work::of_costs(&dimensionless), || {
        At::Field("damping".to_owned())
    })?;
    let dimensionless = Loop {
        viscous_cost: viscous_cost(&dimensionless).ok_or_else(undefined)?,
        ..dimensionless
    };
    Ledger::new(&dimensionless)
        .map_err(|error| Refusal::new("bad_value", At::Request, error.to_string()))
}

/// What the loop costs of viscous friction where no closed form says it (TH-LTI): a delay with damping.
///
/// `Some(None)` where a closed form does, `None` when a number is undefined. A cost that is no fraction is
/// enclosed between short ones.
fn viscous_cost(
    dimensionless: &Loop<Interval<BigRational>>,
) -> Option<Option<Interval<BigRational>>> {
    /// How closely, as a power of two.
    const BITS: u32 = 64;
    let near = || BigRational::new(1.into(), BigInt::from(1) << BITS);
    let wide = dimensionless.try_map(|_, range| range.try_map(|x| Some(to_wide(x))))?;
    let Some(cost) = wide.with_costs(BITS)?.viscous_cost else {
        return Some(None);
    };
    let (lo, hi) = (from_wide(cost.lo())?, from_wide(cost.hi())?);
    Some(Some(match lo == hi {
        true => Interval::point(lo),
        false => Interval::hull(
            simplest_above(&(&lo - near()), &lo),
            simplest_above(&hi, &(&hi + near())),
        ),
    }))
}

/// Every number of a request is defined and Δτ is above zero, so that this is never seen.
fn undefined() -> Refusal {
    Refusal::new("undefined", At::Request, "a figure is not defined")
}
