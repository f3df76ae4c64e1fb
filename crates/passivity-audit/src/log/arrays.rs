//! Traces in memory: arrays of counts or of doubles.

use passivity_scene::Scene;

use super::{Audit, Options, TraceError, run};
use crate::log::chunk::{Chunk, Samples};
use crate::log::header::Heading;
use crate::log::layout::Layout;
use crate::log::preview::Preview;
use crate::log::source::{Reader, Source};
use crate::number::Number;

/// How many samples a core is given at once.
const ROWS: usize = 1 << 18;

/// Positions in memory.
#[derive(Clone, Debug, PartialEq)]
pub enum Positions {
    /// Encoder counts.
    Counts(Vec<i64>),
    /// Doubles, each the dyadic rational that it is, under the name of a column: `xi`, `x [rad]`.
    Numbers(String, Vec<f64>),
}

/// Audits a trace in memory; `times` are doubles under the name of a column, `t [s]` or `tau`.
///
/// # Errors
///
/// [`TraceError`] when a name is not one of a trace's columns, there are not as many times as
/// positions, or rows cannot be written.
///
/// # Example
///
/// ```
/// use passivity_audit::{Options, Positions, Verdict, audit_arrays};
/// use passivity_scene::Scene;
///
/// let scene = Scene::from_toml("s", "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"").unwrap();
/// let positions = Positions::Counts(vec![0, 1, 3, 2]);
/// let audit = audit_arrays(positions, None, &scene, Options::default()).unwrap();
/// assert_eq!(audit.verdict(), Verdict::Holds);
/// ```
pub fn audit_arrays(
    positions: Positions,
    times: Option<(String, Vec<f64>)>,
    scene: &Scene,
    options: Options<'_>,
) -> Result<Audit, TraceError> {
    let (name, len) = match &positions {
        Positions::Counts(counts) => ("count", counts.len()),
        Positions::Numbers(name, values) => (name.as_str(), values.len()),
    };
    let mut headings = vec![Heading::plain(name.to_owned())];
    if let Some((name, values)) = &times {
        if values.len() != len {
            let message = format!(
                "expected {len} times, one per position, found {}",
                values.len()
            );
            return Err(TraceError::new("fields", message));
        }
        headings.push(Heading::plain(name.clone()));
    }
    let layout = Layout::read(headings, None, &Preview::default(), scene)?;
    let mut chunks = Vec::new();
    for start in (0..len).step_by(ROWS) {
        let range = start..len.min(start + ROWS);
        let mut chunk = Chunk::default();
        let (samples, error) = match &positions {
            Positions::Counts(counts) => {
                let counts = counts.get(range.clone()).unwrap_or_default();
                (Samples::Counts(counts.to_vec()), None)
            }
            Positions::Numbers(_, values) => {
                let values = values.get(range.clone()).unwrap_or_default();
                let (samples, error) = until_error(values, |x| layout.sample(finite(*x)?));
                (Samples::Any(samples), error)
            }
        };
        chunk.samples = samples;
        chunk.error = error;
        if let (Some((_, values)), Some(column)) = (&times, layout.time) {
            let values = values.get(range).unwrap_or_default();
            let (times, error) = until_error(values, |x| finite(*x));
            if times.len() < chunk.samples.len() {
                chunk.truncate(times.len());
                chunk.error = error.map(|error| error.column(layout.name(column)));
            }
            chunk.times = times;
            chunk.times.truncate(chunk.samples.len());
        }
        if let Some(error) = chunk.error.take() {
            let column = error.column.clone();
            let column = column.unwrap_or_else(|| layout.name(layout.position));
            chunk.error = Some(error.row(chunk.samples.len() as u64).column(column));
        }
        chunks.push(chunk);
    }
    chunks.reverse();
    run(Source::of(Reader::Memory(chunks)), &layout, scene, options)
}

fn finite(x: f64) -> Result<Number, TraceError> {
    Number::from_f64(x)
        .ok_or_else(|| TraceError::new("not_finite", format!("expected a number, found {x}")))
}

/// What `f` makes of the values, up to the first that it refuses.
fn until_error<T>(
    values: &[f64],
    f: impl Fn(&f64) -> Result<T, TraceError>,
) -> (Vec<T>, Option<TraceError>) {
    let mut made = Vec::with_capacity(values.len());
    for value in values {
        match f(value) {
            Ok(x) => made.push(x),
            Err(error) => return (made, Some(error)),
        }
    }
    (made, None)
}
