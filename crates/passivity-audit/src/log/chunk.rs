//! A part of a trace, as it was read.

use crate::log::error::TraceError;
use crate::log::held::Mark;
use crate::log::layout::{Form, Layout};
use crate::log::numbers::{Kind, Numbers, Readings};
use crate::log::scale::Scale;
use crate::number::Number;
use crate::reading::Reading;

/// The samples of some consecutive rows, and what came with them.
#[derive(Debug, Default)]
pub(crate) struct Chunk {
    pub(crate) samples: Samples,
    /// One per sample, or none at all.
    pub(crate) times: Numbers,
    /// Δτ of the interval that each row is, in a ledger.
    pub(crate) dtaus: Vec<Number>,
    /// One per sample, or none at all.
    pub(crate) forces: Forces,
    /// In ticks per sampling period; one per sample, or none at all.
    pub(crate) velocities: Vec<f64>,
    /// The rows that leave out forces. No log of which pieces are accounted for has any.
    pub(crate) marks: Vec<Mark>,
    /// Where in the log it is.
    pub(crate) file: usize,
    /// Where the last row of a ledger ends.
    pub(crate) closing: Option<Reading>,
    /// Whether the last row, a whole one as it stands, lacks its line break.
    pub(crate) unended: bool,
    /// What is wrong with the row after the last sample.
    pub(crate) error: Option<TraceError>,
}

/// Commanded forces.
#[derive(Clone, Debug)]
pub(crate) struct Forces {
    /// In KΔ, as they are written.
    pub(crate) values: Readings,
    /// Half a unit of the last digit of each, in KΔ: how far off what was commanded may have been rounded.
    pub(crate) roundings: Vec<f64>,
}

impl Default for Forces {
    fn default() -> Self {
        Self::new(&Scale::One)
    }
}

impl Forces {
    fn new(scale: &Scale) -> Self {
        Self {
            values: Readings::new(Kind::Force, scale),
            roundings: Vec::new(),
        }
    }

    #[inline]
    pub(crate) fn get(&self, i: usize) -> Option<Reading> {
        self.values.get(i)
    }

    fn truncate(&mut self, len: usize) {
        self.values.truncate(len);
        self.roundings.truncate(len);
    }

    fn append(&mut self, next: &mut Self) {
        self.values.append(&mut next.values);
        self.roundings.append(&mut next.roundings);
    }

    fn split_off(&mut self, len: usize) -> Self {
        Self {
            values: self.values.split_off(len),
            roundings: split(&mut self.roundings, len),
        }
    }
}

fn split<T>(values: &mut Vec<T>, len: usize) -> Vec<T> {
    values.split_off(len.min(values.len()))
}

/// Positions, kept plain when they are counts.
#[derive(Debug)]
pub(crate) enum Samples {
    Counts(Vec<i64>),
    Any(Readings),
}

impl Default for Samples {
    fn default() -> Self {
        Self::Any(Readings::new(Kind::Position, &Scale::One))
    }
}

impl Samples {
    pub(crate) const fn len(&self) -> usize {
        match self {
            Self::Counts(counts) => counts.len(),
            Self::Any(samples) => samples.len(),
        }
    }

    #[inline]
    pub(crate) fn get(&self, i: usize) -> Option<Reading> {
        match self {
            Self::Counts(counts) => counts.get(i).map(|n| Reading::Count(*n)),
            Self::Any(samples) => samples.get(i),
        }
    }

    /// The sample at `i` and up to `window` − 1 before it, the latest first.
    pub(crate) fn back_from(&self, i: usize, window: usize) -> Vec<Reading> {
        let from = (i + 1).saturating_sub(window);
        (from..=i).rev().filter_map(|i| self.get(i)).collect()
    }
}

impl Chunk {
    /// An empty one.
    pub(crate) fn new(layout: &Layout) -> Self {
        Self {
            samples: match layout.form {
                Form::Count => Samples::Counts(Vec::new()),
                _ => Samples::Any(Readings::new(Kind::Position, layout.scale())),
            },
            forces: Forces::new(layout.per_force()),
            ..Self::default()
        }
    }

    /// Keeps the first `len` rows.
    pub(crate) fn truncate(&mut self, len: usize) {
        match &mut self.samples {
            Samples::Counts(counts) => counts.truncate(len),
            Samples::Any(samples) => samples.truncate(len),
        }
        self.times.truncate(len);
        self.dtaus.truncate(len);
        self.forces.truncate(len);
        self.velocities.truncate(len);
    }

    /// Makes room for about as many positions, times and forces as there are lines in a text.
    pub(crate) fn reserve(&mut self, text: &[u8], layout: &Layout) {
        let line = memchr::memchr(b'\n', text).map_or(text.len(), |end| end + 1);
        let rows = text.len() / line.max(1);
        if let Samples::Any(samples) = &mut self.samples {
            samples.reserve(rows);
        }
        if layout.time.is_some() {
            self.times.reserve(rows);
        }
        if layout.force.is_some() {
            self.forces.values.reserve(rows);
            self.forces.roundings.reserve(rows);
        }
    }

    /// Finds out what is known of positions and forces that were appended as they are written; the first row with
    /// one that cannot be read, and why.
    pub(crate) fn complete(&mut self, layout: &Layout) -> Result<(), (usize, TraceError)> {
        let position = match &mut self.samples {
            Samples::Any(samples) => samples.complete(),
            Samples::Counts(_) => Ok(()),
        };
        let force = self.forces.values.complete();
        let named = |found: Result<(), (usize, TraceError)>, column: Option<usize>| {
            let error = found.err()?;
            Some((error.0, error.1.column(layout.name(column?))))
        };
        let position = named(position, Some(layout.position));
        let force = named(force, layout.force);
        let both = position.into_iter().chain(force);
        both.min_by_key(|(row, _)| *row).map_or(Ok(()), Err)
    }

    /// Goes on with the rows that follow.
    pub(crate) fn append(&mut self, mut next: Self) {
        if self.samples.len() == 0 {
            self.file = next.file;
        }
        match (&mut self.samples, &mut next.samples) {
            (Samples::Counts(counts), Samples::Counts(more)) => counts.append(more),
            (Samples::Any(samples), Samples::Any(more)) => samples.append(more),
            // An empty chunk takes the kind of the next.
            (samples, _) => *samples = next.samples,
        }
        self.times.append(&mut next.times);
        self.dtaus.append(&mut next.dtaus);
        self.forces.append(&mut next.forces);
        self.velocities.append(&mut next.velocities);
        self.closing = next.closing;
        self.unended = next.unended;
        self.error = next.error;
    }

    /// Keeps the first `len` rows and gives the others.
    pub(crate) fn split_off(&mut self, len: usize) -> Self {
        let samples = match &mut self.samples {
            Samples::Counts(counts) => Samples::Counts(split(counts, len)),
            Samples::Any(samples) => Samples::Any(samples.split_off(len)),
        };
        let closing = self.closing.take();
        // In a ledger a row ends where the next starts, as was found when they were read.
        self.closing = match (&closing, samples.get(0)) {
            (Some(_), Some(next)) => Some(next),
            _ => closing.clone(),
        };
        let error = self.error.take();
        Self {
            samples,
            times: self.times.split_off(len),
            dtaus: split(&mut self.dtaus, len),
            forces: self.forces.split_off(len),
            velocities: split(&mut self.velocities, len),
            marks: Vec::new(),
            file: self.file,
            closing,
            unended: self.unended,
            error: error.map(|error| TraceError {
                row: error.row.map(|row| row.saturating_sub(len as u64)),
                ..error
            }),
        }
    }

    /// Ends the chunk with the sample at `i`, for the row after it is wrong.
    pub(crate) fn cut(&mut self, i: usize, error: TraceError) {
        let len = i + 1;
        self.truncate(len);
        self.closing = None;
        self.unended = false;
        self.error = Some(error.row(len as u64));
    }
}
