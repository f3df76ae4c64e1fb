//! Traces in memory: arrays of counts or of doubles.

use passivity_scene::Scene;

use super::{Audit, Options, TraceError, run};
use crate::log::chunk::{Chunk, Samples};
use crate::log::digits::half_a_unit;
use crate::log::header::Heading;
use crate::log::layout::{Form, Layout};
use crate::log::numbers::{Numbers, double};
use crate::log::preview::Preview;
use crate::log::running::near_number;
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
    let positions = match positions {
        Positions::Counts(counts) => ("count".to_owned(), Values::Whole(counts)),
        Positions::Numbers(name, values) => (name, Values::Doubles(values)),
    };
    let times = times.map(|(name, values)| (name, Values::Doubles(values)));
    let columns = std::iter::once(positions).chain(times).collect();
    audit_columns(columns, scene, options)
}

/// The values of a column in memory.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Whole numbers.
    Whole(Vec<i64>),
    /// Doubles, each the dyadic rational that it is.
    Doubles(Vec<f64>),
}

/// Audits a trace in memory, in columns whose names say what they are, as those of a file do.
///
/// # Errors
///
/// [`TraceError`] when the names are not those of a trace's columns, the columns are not of one length, or
/// rows cannot be written.
pub fn audit_columns(
    columns: Vec<(String, Values)>,
    scene: &Scene,
    options: Options<'_>,
) -> Result<Audit, TraceError> {
    let headings: Vec<Heading> = columns
        .iter()
        .map(|(name, _)| Heading::plain(name.clone()))
        .collect();
    let len = columns.first().map_or(0, |(_, values)| values.len());
    if let Some((name, values)) = columns.iter().find(|(_, values)| values.len() != len) {
        let message = format!(
            "expected {len} values, as many as in the first column, found {}",
            values.len()
        );
        return Err(TraceError::new("fields", message).column(name));
    }
    let preview = preview(&columns, len);
    let told = options.dialect.columns.as_ref();
    let layout = Layout::read(headings, told, &preview, scene)?;
    if layout.form == Form::Ledger {
        let message = "the rows of a ledger are read from a file";
        return Err(TraceError::new("header", message));
    }
    let own = layout.clone();
    let mut ended = false;
    let chunks = (0..len).step_by(ROWS).map_while(move |start| {
        if ended {
            return None;
        }
        let chunk = chunk(&columns, &own, start..len.min(start + ROWS));
        ended = chunk.error.is_some();
        Some(chunk)
    });
    run(
        Source::of(Reader::Memory(Box::new(chunks))),
        &layout,
        scene,
        options,
    )
}

/// The first rows, by which the names are judged.
#[expect(clippy::cast_precision_loss, reason = "a number near by")]
fn preview(columns: &[(String, Values)], len: usize) -> Preview {
    let field = |values: &Values, row: usize| match values {
        Values::Whole(values) => values.get(row).map(|n| *n as f64),
        Values::Doubles(values) => values.get(row).copied().filter(|x| x.is_finite()),
    };
    let rows = 0..len.min(Preview::ROWS);
    let column =
        |(_, values): &(String, Values)| rows.clone().map(|row| field(values, row)).collect();
    Preview {
        columns: columns.iter().map(column).collect(),
        ..Preview::default()
    }
}

/// Some rows of the columns, up to the first mistake.
fn chunk(columns: &[(String, Values)], layout: &Layout, range: std::ops::Range<usize>) -> Chunk {
    let (mut chunk, mut fine) = (Chunk::new(layout), Numbers::default());
    // How many rows are whole, and what is wrong with the next.
    let (mut whole, mut error) = (range.len(), None);
    let mut keep = |len: usize, found: Option<TraceError>, column: usize| {
        if let Some(found) = found.filter(|_| error.is_none() || len < whole) {
            error = Some(found.column(layout.name(column)).row(len as u64));
            whole = len;
        }
    };
    for (column, (_, values)) in columns.iter().enumerate() {
        if column == layout.position {
            let found = values.samples(range.clone(), &mut chunk.samples);
            keep(chunk.samples.len(), found, column);
            continue;
        }
        let wanted = [
            layout.time,
            layout.fine_column(),
            layout.force,
            layout.velocity,
        ];
        let [time, beyond, force, velocity] = wanted.map(|wanted| wanted == Some(column));
        if !(time || beyond || force || velocity) {
            continue;
        }
        let (numbers, found) = values.numbers(range.clone());
        keep(numbers.len(), found, column);
        if time {
            chunk.times = numbers;
        } else if beyond {
            fine = numbers;
        } else if force {
            let found = chunk.forces.values.push_all(numbers);
            let len = chunk.forces.values.len();
            let half = values.half_a_unit() * layout.size_of_force;
            chunk.forces.roundings.resize(len, half);
            keep(len, found.err(), column);
        } else {
            let near = (0..numbers.len()).filter_map(|i| numbers.get(i));
            chunk.velocities = near
                .map(|v| near_number(&v) * layout.per_velocity)
                .collect();
        }
    }
    let (times, found) = layout.moments(std::mem::take(&mut chunk.times), &fine);
    chunk.times = times;
    if let Some(found) = found.filter(|_| chunk.times.len() < whole) {
        whole = chunk.times.len();
        error = Some(found.row(whole as u64));
    }
    chunk.truncate(whole);
    chunk.error = error;
    chunk
}

impl Values {
    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self {
            Self::Whole(values) => values.len(),
            Self::Doubles(values) => values.len(),
        }
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Appends positions up to the first that is none, and says what is wrong with that.
    fn samples(&self, range: std::ops::Range<usize>, samples: &mut Samples) -> Option<TraceError> {
        match (self, samples) {
            (Self::Whole(values), Samples::Counts(counts)) => {
                counts.extend_from_slice(values.get(range).unwrap_or_default());
                None
            }
            (Self::Doubles(values), Samples::Counts(counts)) => {
                let values = values.get(range).unwrap_or_default();
                let (found, error) = until_error(values, |x| count(&double(*x)?, DOUBLE));
                *counts = found;
                error
            }
            (values, Samples::Any(samples)) => {
                let (numbers, error) = values.numbers(range);
                samples.push_all(numbers).err().or(error)
            }
        }
    }

    /// Half a unit of the last digit of each: doubles have none.
    fn half_a_unit(&self) -> f64 {
        match self {
            Self::Whole(_) => half_a_unit(0),
            Self::Doubles(_) => 0.0,
        }
    }

    /// Numbers up to the first that is none.
    fn numbers(&self, range: std::ops::Range<usize>) -> (Numbers, Option<TraceError>) {
        match self {
            Self::Whole(values) => {
                let values = values.get(range).unwrap_or_default();
                (Numbers::whole(values.to_vec()), None)
            }
            Self::Doubles(values) => {
                Numbers::doubles(values.get(range).unwrap_or_default().to_vec())
            }
        }
    }
}

/// The count that a number is, of a type that tells whole numbers below 2^bits apart: at larger ones a count was rounded to
/// what is there.
pub(crate) fn count(x: &Number, bits: u32) -> Result<i64, TraceError> {
    let whole = match x {
        Number::Small(n, d) if n % d == 0 => Some(n / d),
        _ => None,
    };
    let told = whole.filter(|n| bits == EXACT || n.unsigned_abs() >> bits == 0);
    told.ok_or_else(|| {
        let expected = match bits {
            EXACT => "of at most 64 bits".to_owned(),
            bits => format!("below 2^{bits}, from which on its type leaves out some"),
        };
        let message = format!("expected a count, which is a whole number {expected}, found {x}");
        TraceError::new("count", message)
    })
}

/// The bits of whole numbers, of the significands of doubles, and of those in single precision.
pub(crate) const EXACT: u32 = 64;
pub(crate) const DOUBLE: u32 = f64::MANTISSA_DIGITS;
#[cfg_attr(
    not(feature = "parquet"),
    expect(dead_code, reason = "of Parquet only")
)]
pub(crate) const SINGLE: u32 = f32::MANTISSA_DIGITS;

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
