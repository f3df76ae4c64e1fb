//! The messages of an MCAP file as rows of text, such as CSV has them.
//!
//! A row is a message that has the position. What other topics say is what their last message before it said,
//! in the order of the file.

use std::fmt::Write as _;
use std::path::Path;

use mcap::records::Record;

use crate::log::csv::{self, Notation};
use crate::log::digits::{Digits, Seen};
use crate::log::error::{TraceError, legible, shown};
use crate::log::findings::Finding;
use crate::log::guarded::guarded;
use crate::log::held::{Mark, OLD};
use crate::log::layout::Layout;
use crate::log::lines::Block;
use crate::log::mcap::channels::{Channels, Decoder, Message};
use crate::log::mcap::discovery::{Column, Place};
use crate::log::mcap::records::Records;
use crate::log::mcap::value::{Missing, Scalar, Value};

/// A column that is read.
#[derive(Clone)]
struct Wanted {
    column: Column,
    /// Which one it is in a row.
    at: usize,
    /// Whether it is of the topic that has the position.
    own: bool,
    /// What it says now, as text.
    now: Option<String>,
}

/// The force: which values no row has, and how old the last one is. In the message of the position it is always new.
#[derive(Clone)]
struct Force {
    /// Which column it is.
    at: usize,
    /// From this age on it is old, in nanoseconds.
    old: u64,
    now: Option<Scalar>,
    /// What the last row had.
    read: Option<Scalar>,
    /// How many values came since, and were followed by others.
    missed: u64,
    /// When the last one was recorded, and how many rows had it.
    since: u64,
    rows: u64,
}

impl Force {
    /// Takes the next value.
    fn say(&mut self, found: &Scalar, time: u64) {
        let is_other = |before: &Option<Scalar>| before.as_ref().is_some_and(|x| x != found);
        if self.read.is_some() && is_other(&self.now) && self.now != self.read {
            self.missed += 1;
        }
        self.now = Some(found.clone());
        (self.since, self.rows) = (time, 0);
    }

    /// Whether it is as it was commanded: a float or a whole number, and no decimal that was rounded.
    const fn is_exact(&self) -> bool {
        !matches!(self.now, Some(Scalar::Spelt(_)))
    }

    /// Gives the value to a row, recorded at this time: what it leaves out.
    fn read(&mut self, row: usize, time: u64) -> Option<Mark> {
        if self.read != self.now {
            self.read.clone_from(&self.now);
        }
        self.rows += 1;
        let age = time.saturating_sub(self.since);
        let mark = Mark {
            row,
            missed: std::mem::take(&mut self.missed),
            is_old: self.rows > OLD.into() && age > self.old,
        };
        (mark.missed > 0 || mark.is_old).then_some(mark)
    }
}

/// The rows of a file.
pub(crate) struct Rows {
    records: Records,
    channels: Channels,
    wanted: Vec<Wanted>,
    /// The column of the position.
    position: Column,
    /// How many columns a row has.
    width: usize,
    block: usize,
    /// The rows that were read and not yet given.
    text: String,
    rows: u64,
    /// The rows that leave out forces, and how many rows of the block there are.
    marks: Vec<Mark>,
    in_block: usize,
    force: Option<Force>,
    /// How many messages with a position came before the first one of another topic.
    skipped: u64,
    /// When the last message that was used was recorded.
    last: u64,
    ended: bool,
    /// What is wrong after the rows that were read.
    error: Option<TraceError>,
}

impl Rows {
    /// The rows that a layout asks for.
    pub(crate) fn open(
        path: &Path,
        columns: &[Column],
        layout: &Layout,
        block: usize,
        old: u64,
    ) -> Result<Self, TraceError> {
        let missing = || TraceError::new("mcap", "a column is missing");
        let position = columns.get(layout.position).ok_or_else(missing)?.clone();
        let mut wanted = Vec::new();
        for at in layout.read_columns() {
            let column = columns.get(at).ok_or_else(missing)?.clone();
            let own = column.topic == position.topic;
            wanted.push(Wanted {
                column,
                at,
                own,
                now: None,
            });
        }
        wanted.sort_by_key(|wanted| wanted.at);
        wanted.dedup_by_key(|wanted| wanted.at);
        let force = layout.force.map(|at| Force {
            at,
            old,
            now: None,
            read: None,
            missed: 0,
            since: 0,
            rows: 0,
        });
        Ok(Self {
            records: Records::open(path)?,
            channels: Channels::default(),
            wanted,
            position,
            width: layout.width(),
            block,
            text: String::new(),
            rows: 0,
            marks: Vec::new(),
            in_block: 0,
            force,
            skipped: 0,
            last: 0,
            ended: false,
            error: None,
        })
    }

    /// The rows of the next file of the same log, which goes on with what the topics said last.
    pub(crate) fn go_on(&self, path: &Path) -> Result<Self, TraceError> {
        Ok(Self {
            records: Records::open(path)?,
            channels: Channels::default(),
            wanted: self.wanted.clone(),
            position: self.position.clone(),
            width: self.width,
            block: self.block,
            text: String::new(),
            rows: 0,
            marks: Vec::new(),
            in_block: 0,
            force: self.force.clone(),
            skipped: 0,
            last: self.last,
            ended: false,
            error: None,
        })
    }

    /// Reads up to the first row, and says how many messages were none.
    pub(crate) fn start(&mut self) -> Result<Option<Finding>, TraceError> {
        while self.rows == 0 && !self.ended {
            self.step();
        }
        if let (0, Some(error)) = (self.rows, self.error.take()) {
            return Err(error);
        }
        if self.skipped == 0 || self.rows == 0 {
            return Ok(None);
        }
        let others = self.wanted.iter().filter(|wanted| !wanted.own);
        let mut others: Vec<String> = others.map(|w| legible(&w.column.topic)).collect();
        others.dedup();
        let messages = match self.skipped {
            1 => "1 message".to_owned(),
            n => format!("{n} messages"),
        };
        Ok(Some(Finding {
            kind: "not_yet",
            says: format!(
                "{messages} on {} came before the first on {} and {}",
                legible(&self.position.topic),
                others.join(", "),
                if self.skipped == 1 {
                    "is no row"
                } else {
                    "are no rows"
                }
            ),
            fix: "if they matter, record the other topic from an earlier time on".to_owned(),
        }))
    }

    /// How many digits the numbers of a column have in the first rows.
    pub(crate) fn digits(&mut self, column: usize) -> Digits {
        let (mut seen, mut at) = (Seen::default(), 0);
        loop {
            let rest = self.text.get(at..).unwrap_or_default();
            for line in rest.split_inclusive('\n') {
                if seen.is_done() {
                    break;
                }
                let row = line.trim_end().as_bytes();
                seen.see(line.len(), csv::place(row, column, Notation::default()));
                at += line.len();
            }
            if self.ended || seen.is_done() {
                return seen.digits;
            }
            self.step();
        }
    }

    /// The next rows; `None` after the last.
    pub(crate) fn next_block(&mut self) -> Option<Block> {
        while !self.ended && self.text.len() < self.block {
            self.step();
        }
        let error = self.error.take();
        self.in_block = 0;
        if self.text.is_empty() && error.is_none() {
            return None;
        }
        Some(Block {
            bytes: std::mem::take(&mut self.text).into_bytes(),
            last: self.ended,
            error,
            exact: self.force.as_ref().is_some_and(Force::is_exact),
            marks: std::mem::take(&mut self.marks),
        })
    }

    /// Reads a record.
    fn step(&mut self) {
        match guarded("mcap", || self.record()) {
            Ok(goes_on) => self.ended = !goes_on,
            Err(error) => {
                self.ended = true;
                self.error = Some(error);
            }
        }
    }

    /// Reads a record; whether there may be more.
    fn record(&mut self) -> Result<bool, TraceError> {
        let Self {
            records,
            channels,
            wanted,
            position,
            width,
            text,
            rows,
            skipped,
            last,
            marks,
            in_block,
            force,
            ..
        } = self;
        let took = records.next(|record| {
            let Some(Record::Message { header, data }) = channels.take(record)? else {
                return Ok(());
            };
            let message = Message {
                channel: header.channel_id,
                log_time: header.log_time,
                publish_time: header.publish_time,
                bytes: &data,
            };
            let channel = channels.of(&message)?;
            let mut read = wanted.iter_mut().filter(|w| w.column.topic == channel.topic);
            let Some(first) = read.next() else {
                return Ok(());
            };
            let place = |why: &str| {
                let topic = shown(channel.topic.as_bytes());
                TraceError::new("mcap", format!("a message on `{topic}`: {why}"))
            };
            let decoder = channel.decoder.as_ref().map_err(|why| place(why))?;
            let value = decoder.decode(message.bytes).map_err(place)?;
            let own = first.own;
            // Joints may be on one topic from several senders, and so may messages with other definitions.
            let is_other = |missing: &Missing| match missing {
                Missing::Joint => true,
                Missing::Field => !matches!(decoder, Decoder::Json),
                Missing::Other(_) => false,
            };
            let lacks = |column: &Column, missing: Missing| {
                let has = match missing {
                    Missing::Joint => "nothing of this joint".to_owned(),
                    Missing::Field => "no such field".to_owned(),
                    Missing::Other(what) => what,
                };
                no_number(column, &message, &format!("has {has}, and a number was expected"))
            };
            let is_row = match number(position, &value, &message) {
                _ if !own => false,
                Ok(_) => true,
                Err(missing) if is_other(&missing) => false,
                Err(missing) => return Err(lacks(position, missing)),
            };
            for wanted in std::iter::once(first).chain(read) {
                let mut force = force.as_mut().filter(|force| force.at == wanted.at);
                match number(&wanted.column, &value, &message) {
                    Err(missing) if !is_row && is_other(&missing) => {}
                    _ if own && !is_row && force.is_none() => {}
                    Err(missing) => return Err(lacks(&wanted.column, missing)),
                    Ok(_) if own && !is_row => {
                        let why = "has this force without the position of its row";
                        return Err(no_number(&wanted.column, &message, why));
                    }
                    Ok(found) => {
                        if let Some(force) = &mut force {
                            force.say(&found, message.log_time);
                        }
                        let now = wanted.now.get_or_insert_default();
                        now.clear();
                        // Writing to a text cannot fail.
                        let _ = write!(now, "{found}");
                    }
                }
            }
            if own && !is_row {
                return Ok(());
            }
            if wanted.iter().any(|wanted| !wanted.own) {
                if message.log_time < *last {
                    return Err(place(
                        "it was recorded before the message that stands before it, so that what other topics said at that time is not known: sort the file by time (`mcap sort`)",
                    ));
                }
                *last = message.log_time;
            }
            if own {
                match wanted.iter().all(|wanted| wanted.now.is_some()) {
                    true => {
                        row(text, wanted, *width);
                        let force = force.as_mut();
                        marks.extend(force.and_then(|f| f.read(*in_block, message.log_time)));
                        *rows += 1;
                        *in_block += 1;
                    }
                    false => *skipped += 1,
                }
            }
            Ok(())
        })?;
        match took {
            Some(()) => Ok(true),
            None if *rows > 0 => Ok(false),
            None => {
                let topic = shown(position.topic.as_bytes());
                let why = match *skipped {
                    0 => format!("has no message on `{topic}` with the position"),
                    _ => format!(
                        "has no row: all messages on `{topic}` come before those on the other topics"
                    ),
                };
                Err(TraceError::new("mcap", format!("the file {why}")))
            }
        }
    }
}

/// The error of a message in a column.
fn no_number(column: &Column, message: &Message<'_>, why: &str) -> TraceError {
    let (topic, time) = (shown(column.topic.as_bytes()), message.log_time);
    let message = format!("the message on `{topic}` recorded at {time} ns {why}");
    TraceError::new("mcap", message).column(&column.name)
}

/// What a message says in a column.
fn number(column: &Column, value: &Value<'_>, message: &Message<'_>) -> Result<Scalar, Missing> {
    match &column.place {
        Place::Within(path) => value.at(path),
        Place::LogTime => Ok(Scalar::Whole(message.log_time.into())),
        Place::PublishTime => Ok(Scalar::Whole(message.publish_time.into())),
    }
}

/// Writes a row; the columns that are not read are left empty.
fn row(text: &mut String, wanted: &[Wanted], width: usize) {
    let mut wanted = wanted.iter().peekable();
    for at in 0..width {
        if at > 0 {
            text.push(',');
        }
        if let Some(found) = wanted.next_if(|wanted| wanted.at == at) {
            text.push_str(found.now.as_deref().unwrap_or_default());
        }
    }
    text.push('\n');
}
