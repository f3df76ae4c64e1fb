//! What columns an MCAP file can give: the numbers of the first messages on each topic.

use std::collections::{BTreeSet, HashMap};
use std::path::Path;

use mcap::records::Record;

use crate::log::columns::Columns;
use crate::log::error::{TraceError, legible, shown};
use crate::log::header::{Heading, RECORDER};
use crate::log::layout::MAX_COLUMNS;
use crate::log::mcap::channels::{Channel, Channels, Message};
use crate::log::mcap::records::Records;
use crate::log::mcap::value::{Leaf, Step, written};
use crate::log::preview::Preview;

/// How many messages on a topic are looked at.
const PREVIEWED: u64 = Preview::ROWS as u64;

/// Where the numbers of a column are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// In the message.
    Within(Vec<Step>),
    /// When it was recorded.
    LogTime,
    /// When it was sent.
    PublishTime,
}

/// A column that a topic can give.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub(crate) topic: String,
    pub(crate) place: Place,
    pub(crate) name: String,
    /// The first numbers.
    first: Vec<Option<f64>>,
}

/// The columns of a file.
#[derive(Debug, Default)]
pub(crate) struct Discovered {
    pub(crate) columns: Vec<Column>,
    /// The topics whose messages are not decoded, with the reasons.
    refused: Vec<(String, String)>,
    /// All topics with messages.
    topics: BTreeSet<String>,
}

/// What has been seen of a topic.
#[derive(Default)]
struct Topic {
    messages: u64,
    columns: Vec<Column>,
}

impl Discovered {
    /// Reads the first messages on the topics that are told, or on all where none is.
    pub(crate) fn read(path: &Path, told: Option<&Columns>) -> Result<Self, TraceError> {
        if let Some(told) = told {
            let named = discover(path, &|topic| told.mentions(topic))?;
            if !named.is_empty() {
                return named.sound();
            }
        }
        discover(path, &|_| true)?.sound()
    }

    /// Whether no topic had a message.
    fn is_empty(&self) -> bool {
        self.columns.is_empty() && self.refused.is_empty()
    }

    /// Refuses what gives no columns.
    fn sound(self) -> Result<Self, TraceError> {
        match (self.columns.is_empty(), self.not_decoded()) {
            (true, Some(why)) => Err(TraceError::new("mcap", why)),
            (true, None) => Err(TraceError::new("empty", "no message holds a number")),
            (false, _) => Ok(self),
        }
    }

    /// The names of the columns.
    pub(crate) fn headings(&self) -> Vec<Heading> {
        let names = self.columns.iter().map(|column| column.name.clone());
        names.map(Heading::plain).collect()
    }

    /// The first numbers of each column, and which columns are of one topic.
    pub(crate) fn preview(&self) -> Preview {
        let mut topics: HashMap<&str, usize> = HashMap::new();
        let mut groups = Vec::new();
        for column in &self.columns {
            let next = topics.len();
            groups.push(*topics.entry(&column.topic).or_insert(next));
        }
        Preview {
            groups,
            columns: self.columns.iter().map(|c| c.first.clone()).collect(),
            ..Preview::default()
        }
    }

    /// All that is on other topics than those that are read, in words.
    pub(crate) fn others(&self, is_read: &dyn Fn(&str) -> bool) -> Vec<String> {
        const SHOWN: usize = 16;
        let others = self.topics.iter().filter(|topic| !is_read(topic));
        let mut others: Vec<String> = others
            .map(|topic| format!("all on {}", legible(topic)))
            .collect();
        let more = others.len().saturating_sub(SHOWN);
        if more > 0 {
            others.truncate(SHOWN);
            others.push(format!("and {more} topics more"));
        }
        others
    }

    /// What is added to an error in the header: the topics that are not read; `None` where all are.
    pub(crate) fn not_decoded(&self) -> Option<String> {
        const SHOWN: usize = 4;
        let topic = |(topic, why): &(String, String)| {
            let topic = shown(topic.as_bytes());
            format!("`{topic}` ({why})")
        };
        let topics: Vec<String> = self.refused.iter().take(SHOWN).map(topic).collect();
        let more = match self.refused.len() {
            len if len > SHOWN => ", …",
            _ => "",
        };
        (!topics.is_empty()).then(|| {
            let topics = topics.join(", ");
            format!(
                "the messages on {topics}{more} cannot be decoded: what is read is `cdr` with definitions in `ros2msg`, `ros1` with `ros1msg`, and `json`"
            )
        })
    }
}

/// How many messages on a channel have still to be looked at, and all topics with messages, as the summary says; `None`
/// without one.
fn counts(
    path: &Path,
    wanted: &dyn Fn(&str) -> bool,
) -> Option<(HashMap<u16, u64>, BTreeSet<String>)> {
    let mut records = Records::summary(path)?;
    let (mut channels, mut counts) = (Channels::default(), None);
    let mut take = |record: Record<'_>| {
        if let Some(Record::Statistics(found)) = channels.take(record)? {
            counts = Some(found.channel_message_counts);
        }
        Ok(())
    };
    while let Ok(Some(())) = records.next(&mut take) {}
    let mut counts: HashMap<u16, u64> = counts?.into_iter().collect();
    let mut topics = BTreeSet::new();
    for (number, channel) in channels.all() {
        if counts.get(&number).is_some_and(|count| *count > 0) {
            topics.insert(channel.topic.clone());
        }
        if !wanted(&channel.topic) {
            counts.remove(&number);
        } else if channel.decoder.is_err() {
            // One shows that it is there.
            counts
                .entry(number)
                .and_modify(|count| *count = 1.min(*count));
        }
    }
    counts.retain(|_, count| {
        *count = PREVIEWED.min(*count);
        *count > 0
    });
    Some((counts, topics))
}

/// The columns of the topics that are wanted.
fn discover(path: &Path, wanted: &dyn Fn(&str) -> bool) -> Result<Discovered, TraceError> {
    let (mut left, with_messages) = counts(path, wanted).unzip();
    let mut with_messages: BTreeSet<String> = with_messages.unwrap_or_default();
    let mut records = Records::open(path)?;
    let mut channels = Channels::default();
    let mut topics: Vec<(String, Topic)> = Vec::new();
    let mut refused: Vec<(String, String)> = Vec::new();
    let mut refuse = |topic: &str, why: &str| {
        if !refused.iter().any(|(known, _)| known == topic) {
            refused.push((topic.to_owned(), why.to_owned()));
        }
    };
    let mut failed = None;
    // What is wrong with a file after its first messages is said where it is read.
    while left.as_ref().is_none_or(|left| !left.is_empty()) {
        let took = records.next(|record| {
            let Some(record) = channels.take(record)? else {
                return Ok(());
            };
            let Record::Message { header, data } = record else {
                return Ok(());
            };
            let message = Message {
                channel: header.channel_id,
                log_time: header.log_time,
                publish_time: header.publish_time,
                bytes: &data,
            };
            let Channel { topic, decoder } = channels.of(&message)?;
            if !with_messages.contains(topic) {
                with_messages.insert(topic.clone());
            }
            if let Some(left) = &mut left
                && let Some(count) = left.get_mut(&message.channel)
            {
                *count -= 1;
                if *count == 0 {
                    left.remove(&message.channel);
                }
            }
            if !wanted(topic) {
                return Ok(());
            }
            let at = topics.iter().position(|(name, _)| name == topic);
            let at = at.unwrap_or_else(|| {
                topics.push((topic.clone(), Topic::default()));
                topics.len() - 1
            });
            let Some((_, seen)) = topics.get_mut(at).filter(|(_, t)| t.messages < PREVIEWED) else {
                return Ok(());
            };
            match decoder {
                Err(why) => refuse(topic, why),
                Ok(decoder) => match decoder.decode(message.bytes) {
                    Ok(value) => seen.add(topic, value.leaves(), &message),
                    Err(why) => refuse(topic, why),
                },
            }
            seen.messages += 1;
            Ok(())
        });
        match took {
            Ok(Some(())) => {}
            Ok(None) => break,
            Err(error) => {
                failed = Some(error);
                break;
            }
        }
    }
    let columns: Vec<Column> = topics.into_iter().flat_map(|(_, t)| t.columns).collect();
    if let (true, Some(error)) = (columns.is_empty(), failed) {
        return Err(error);
    }
    Ok(Discovered {
        columns: columns.into_iter().take(MAX_COLUMNS).collect(),
        refused,
        topics: with_messages,
    })
}

impl Topic {
    /// Adds the numbers of a message.
    fn add(&mut self, topic: &str, leaves: Vec<Leaf>, message: &Message<'_>) {
        #[allow(clippy::cast_precision_loss)] // a preview
        let [log_time, publish_time] = RECORDER;
        let times = [
            (Place::LogTime, log_time, message.log_time as f64),
            (
                Place::PublishTime,
                publish_time,
                message.publish_time as f64,
            ),
        ];
        let mut found = Vec::new();
        for Leaf {
            path,
            near,
            is_time,
        } in leaves
        {
            let unit = if is_time { " [ns]" } else { "" };
            let name = format!("{}{unit}", written(&path));
            found.push((Place::Within(path), name, near));
        }
        if !found.is_empty() {
            let times = times.into_iter();
            found.extend(times.map(|(place, name, x)| (place, name.to_owned(), Some(x))));
        }
        for (i, (place, name, near)) in found.into_iter().enumerate() {
            // Most messages have the numbers of the first one.
            let is_it = |column: &Column| column.place == place;
            let known = match self.columns.get(i).is_some_and(is_it) {
                true => Some(i),
                false => self.columns.iter().position(is_it),
            };
            if let Some(at) = known {
                let column = self.columns.get_mut(at);
                column
                    .into_iter()
                    .for_each(|column| column.first.push(near));
            } else if self.columns.len() < MAX_COLUMNS {
                self.columns.push(Column {
                    topic: topic.to_owned(),
                    place,
                    name: format!("{topic}{name}"),
                    first: vec![near],
                });
            }
        }
    }
}
