//! The channels of an MCAP file: which topic each is of, and how its messages are decoded.

use std::collections::HashMap;

use mcap::records::Record;

use crate::log::error::{TraceError, shown};
use crate::log::mcap::schema::{MOST_TEXT, Ros, Schema};
use crate::log::mcap::value::Value;
use crate::log::mcap::{binary, json};

/// The most that all definitions of messages may take, in bytes.
const MOST_TEXTS: usize = 64 << 20;

/// The longest message that is decoded, in bytes: decoded it can take some hundred times as much.
const MOST_MESSAGE: usize = 4 << 20;

/// How the messages of a channel are decoded.
pub(crate) enum Decoder {
    Cdr(Schema),
    Ros1(Schema),
    Json,
}

/// What defines messages.
struct Definition {
    name: String,
    encoding: String,
    text: Vec<u8>,
}

/// A channel.
pub(crate) struct Channel {
    pub(crate) topic: String,
    /// Or why its messages are not decoded.
    pub(crate) decoder: Result<Decoder, String>,
}

/// The channels that have been announced so far.
#[derive(Default)]
pub(crate) struct Channels {
    definitions: HashMap<u16, Definition>,
    channels: HashMap<u16, Channel>,
    bytes: usize,
}

/// A message as it stands in a file.
pub(crate) struct Message<'r> {
    pub(crate) channel: u16,
    pub(crate) log_time: u64,
    pub(crate) publish_time: u64,
    pub(crate) bytes: &'r [u8],
}

impl Decoder {
    /// The decoder of messages in an encoding, with the definition that goes with it.
    fn of(encoding: &str, definition: Option<&Definition>) -> Result<Self, String> {
        let by = definition.map_or("", |definition| definition.encoding.as_str());
        let schema = |ros| match definition {
            Some(definition) => Schema::parse(&definition.name, &definition.text, ros),
            None => Err("it has no definition".to_owned()),
        };
        match (encoding, by) {
            ("cdr", "ros2msg") => Ok(Self::Cdr(schema(Ros::Two)?)),
            ("ros1", "ros1msg") => Ok(Self::Ros1(schema(Ros::One)?)),
            ("json", _) => Ok(Self::Json),
            _ => {
                let by = match by {
                    "" => "no definition".to_owned(),
                    by => format!("definitions in `{}`", shown(by.as_bytes())),
                };
                Err(format!("`{}` with {by}", shown(encoding.as_bytes())))
            }
        }
    }

    /// Decodes a message.
    pub(crate) fn decode<'a>(&'a self, message: &'a [u8]) -> Result<Value<'a>, &'static str> {
        if message.len() > MOST_MESSAGE {
            return Err("it is longer than 4 MiB");
        }
        match self {
            Self::Cdr(schema) => binary::cdr(schema, message),
            Self::Ros1(schema) => binary::ros1(schema, message),
            Self::Json => json::decode(message),
        }
    }
}

impl Channels {
    /// Takes what a record says of channels; gives it back when it is something else.
    pub(crate) fn take<'r>(
        &mut self,
        record: Record<'r>,
    ) -> Result<Option<Record<'r>>, TraceError> {
        match record {
            Record::Schema { header, data } => {
                if self.definitions.contains_key(&header.id) {
                    return Ok(None);
                }
                // What is too long is refused where it is needed.
                let text = data.get(..MOST_TEXT + 1).unwrap_or(&data).to_vec();
                self.bytes += text.len();
                if self.bytes > MOST_TEXTS {
                    let message = format!("its definitions of messages pass {MOST_TEXTS} bytes");
                    return Err(TraceError::new("mcap", message));
                }
                let definition = Definition {
                    name: header.name,
                    encoding: header.encoding,
                    text,
                };
                self.definitions.insert(header.id, definition);
                Ok(None)
            }
            Record::Channel(channel) => {
                if self.channels.contains_key(&channel.id) {
                    return Ok(None);
                }
                let definition = self.definitions.get(&channel.schema_id);
                let decoder = Decoder::of(&channel.message_encoding, definition);
                let topic = channel.topic;
                self.channels.insert(channel.id, Channel { topic, decoder });
                Ok(None)
            }
            other => Ok(Some(other)),
        }
    }

    /// The channel of a message.
    pub(crate) fn of(&self, message: &Message<'_>) -> Result<&Channel, TraceError> {
        let number = message.channel;
        self.channels.get(&number).ok_or_else(|| {
            let message = format!("a message is of channel {number}, which nothing announced");
            TraceError::new("mcap", message)
        })
    }

    /// The channels, by their numbers.
    pub(crate) fn all(&self) -> impl Iterator<Item = (u16, &Channel)> {
        self.channels
            .iter()
            .map(|(number, channel)| (*number, channel))
    }
}
