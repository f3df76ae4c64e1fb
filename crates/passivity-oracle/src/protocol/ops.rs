//! The operations: `interval`, `run`, `motion`, `check`, `version`.

use passivity_core::effects::Effects;
use passivity_core::{BigRational, Friction};
use passivity_scene::{Scene, check};

use super::fields::{Fields, bad, duration, list, missing, sample};
use super::{At, MAX_ANSWER, PROTOCOL, Refusal};
use crate::ledger::{Ledger, Sample};
use crate::model::Model;
use crate::motion::Piece;
use crate::number::Number;
use crate::row::write_span;
use crate::run::Run;
use crate::span::Span;

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
pub(super) fn run(fields: &Fields<'_>, out: &mut Vec<u8>) -> Result<(), Refusal> {
    match fields.text("op")? {
        "interval" => interval(fields, out),
        "run" => sequence(fields, out),
        "motion" => motion(fields, out),
        "check" => verdict(fields, out),
        "version" => version(fields, out),
        other => Err(Refusal::new(
            "unknown_op",
            At::Field("op".to_owned()),
            format!("no operation `{other}`: there are interval, run, motion, check, version"),
        )),
    }
}

/// One ledger row: `xi0` and `xi1`, or `count0` and `count1`; `dtau`, 1 if it is not there.
fn interval(fields: &Fields<'_>, out: &mut Vec<u8>) -> Result<(), Refusal> {
    let counted = fields.get(&["count0", "count1"]).is_some();
    let names = if counted {
        ["count0", "count1"]
    } else {
        ["xi0", "xi1"]
    };
    let known = [&LOOP[..], &["h", "dtau"], &names].concat();
    fields.only(&known)?;
    let position = |name: &'static str| match fields.get(&[name]) {
        Some((_, value)) => sample(value, counted, || name.to_owned()),
        None => Err(missing(name)),
    };
    let (start, end) = (position(names[0])?, position(names[1])?);
    let dtau = match fields.get(&["dtau"]) {
        Some((name, value)) => duration(value, || name.to_owned())?,
        None => Number::whole(1),
    };
    let ledger = Ledger::new(model(fields)?);
    let h = fields.natural("h", u64::MAX)?;
    let row = ledger.row(&[start], &end, &dtau);
    row.ok_or_else(undefined)?.write_json(h, out);
    Ok(())
}

/// Rows and totals: a list `xi` (or `positions`) or `count` (or `counts`), and `dtau`, a number or
/// a list with one number per interval.
fn sequence(fields: &Fields<'_>, out: &mut Vec<u8>) -> Result<(), Refusal> {
    const POSITIONS: [&str; 2] = ["xi", "positions"];
    const COUNTS: [&str; 2] = ["count", "counts"];
    let known = [&LOOP[..], &["dtau"], &POSITIONS, &COUNTS].concat();
    fields.only(&known)?;
    let (positions, counts) = (fields.get(&POSITIONS), fields.get(&COUNTS));
    let (name, value, counted) = match (positions, counts) {
        (Some((name, value)), None) => (name, value, false),
        (None, Some((name, value))) => (name, value, true),
        (None, None) => return Err(missing("xi")),
        (Some(_), Some((name, _))) => return Err(bad(name, "positions or counts, not both")),
    };
    let items = list(name, value)?;
    let samples: Result<Vec<Sample>, Refusal> = items
        .iter()
        .enumerate()
        .map(|(i, item)| sample(item, counted, || format!("{name}[{i}]")))
        .collect();
    let samples = samples?;
    if samples.len() < 2 {
        return Err(bad(name, "expected at least two positions"));
    }
    let intervals = samples.len() - 1;
    let durations = match fields.get(&["dtau"]) {
        None => vec![Number::whole(1)],
        Some((name, value @ serde_json::Value::Array(_))) => {
            let items = list(name, value)?;
            if items.len() != intervals {
                let message = format!("expected one number for each of {intervals} intervals");
                return Err(bad(name, message));
            }
            let read = |(i, item)| duration(item, || format!("{name}[{i}]"));
            items
                .iter()
                .enumerate()
                .map(read)
                .collect::<Result<_, _>>()?
        }
        Some((name, value)) => vec![duration(value, || name.to_owned())?],
    };
    let ledger = Ledger::new(model(fields)?);
    let mut run = Run::new(&ledger);
    let start = out.len();
    out.extend_from_slice(b"{\"rows\": [");
    for (i, sample) in samples.into_iter().enumerate() {
        let dtau = i.checked_sub(1).and_then(|h| durations.get(h));
        let dtau = dtau.or(durations.first()).ok_or_else(undefined)?;
        if let Some(row) = run.step(sample, dtau).ok_or_else(undefined)? {
            if i > 1 {
                out.extend_from_slice(b", ");
            }
            row.write_json(run.intervals() - 1, out);
            if out.len() - start > MAX_ANSWER {
                let message = format!("the rows take more than {MAX_ANSWER} bytes");
                let at = At::Field(format!("{name}[{i}]"));
                return Err(Refusal::new("answer_too_long", at, message));
            }
        }
    }
    out.extend_from_slice(b"], \"totals\": ");
    run.totals().write_json(out);
    out.push(b'}');
    Ok(())
}

/// Where a piece of motion at a constant force leads, enclosed between decimals.
fn motion(fields: &Fields<'_>, out: &mut Vec<u8>) -> Result<(), Refusal> {
    fields.only(&["mu", "beta", "sigma", "xi", "velocity", "force", "tau"])?;
    let [beta, _] = fields.friction("beta")?;
    let [sigma, _] = fields.friction("sigma")?;
    let number = |name| fields.rational(name);
    let piece = Piece {
        mu: fields.effect("mu", false)?.ok_or_else(|| missing("mu"))?,
        friction: Friction::new(beta, sigma),
        xi: number("xi")?,
        velocity: number("velocity")?,
        force: number("force")?,
        duration: fields.effect("tau", true)?.ok_or_else(|| missing("tau"))?,
    };
    let arrival = piece.arrival().ok_or_else(|| {
        let message = "not one piece of motion: at rest, a change of direction, or βτ/μ > 1";
        Refusal::new("out_of_range", At::Request, message)
    })?;
    let span = |[lo, hi]: [BigRational; 2]| Span::of(lo, hi);
    out.extend_from_slice(b"{\"xi\": ");
    write_span(&span(arrival.xi), out);
    out.extend_from_slice(b", \"velocity\": ");
    write_span(&span(arrival.velocity), out);
    out.push(b'}');
    Ok(())
}

/// What `passivity check` says of a scene.
fn verdict(fields: &Fields<'_>, out: &mut Vec<u8>) -> Result<(), Refusal> {
    fields.only(&["scene"])?;
    let (_, value) = fields.get(&["scene"]).ok_or_else(|| missing("scene"))?;
    let scene = Scene::from_json(value).map_err(|error| {
        let first = error.diagnostics().first();
        let key = first.and_then(|diagnostic| diagnostic.scene_key());
        let at = key.map_or_else(|| "scene".to_owned(), |key| format!("scene.{key}"));
        let kind = first.map_or("scene", |diagnostic| diagnostic.kind().name());
        Refusal::new(kind, At::Field(at), error.to_string())
    })?;
    let report = check::check(&scene).to_json();
    out.extend_from_slice(report.to_string().as_bytes());
    Ok(())
}

fn version(fields: &Fields<'_>, out: &mut Vec<u8>) -> Result<(), Refusal> {
    fields.only(&[])?;
    let text = format!(
        "{{\"name\": \"passivity\", \"version\": \"{}\", \"protocol\": {PROTOCOL}, \
         \"ops\": [\"interval\", \"run\", \"motion\", \"check\", \"version\"]}}",
        env!("CARGO_PKG_VERSION")
    );
    out.extend_from_slice(text.as_bytes());
    Ok(())
}

/// The loop of a request: `beta` and `sigma`, and the effects whose keys are there.
fn model(fields: &Fields<'_>) -> Result<Model<BigRational>, Refusal> {
    let [beta_least, beta_most] = fields.friction("beta")?;
    let [sigma_least, sigma_most] = fields.friction("sigma")?;
    let delay = fields.natural("delay", MAX_DELAY)?;
    Ok(Model {
        exact: beta_least == beta_most && sigma_least == sigma_most,
        least: Friction::new(beta_least, sigma_least),
        most: Friction::new(beta_most, sigma_most),
        effects: Effects {
            encoder: fields.flag("encoder", true)?,
            delay: u16::try_from(delay).unwrap_or(u16::MAX),
            damping: fields.effect("damping", true)?,
            force_step: fields.effect("force_step", false)?,
        },
        unilateral: fields.flag("unilateral", false)?,
        max_force: fields.effect("max_force", false)?,
    })
}

/// Every number of a request is defined and Δτ is above zero, so that this is never seen.
fn undefined() -> Refusal {
    Refusal::new("undefined", At::Request, "a figure is not defined")
}
