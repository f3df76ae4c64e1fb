//! What a message consists of, by the text that defines it: `.msg` of ROS 1 and ROS 2, with the definitions
//! of the messages within it after lines of equals signs.

use crate::log::error::shown;
use crate::log::mcap::value::are_time;

/// The longest definition, in bytes.
pub(crate) const MOST_TEXT: usize = 1 << 20;

/// Which ROS wrote it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ros {
    One,
    Two,
}

/// What a field holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Bool,
    Whole {
        bytes: usize,
        signed: bool,
    },
    Single,
    Double,
    Text,
    /// Of ROS 1, where a time is no message.
    Time {
        signed: bool,
    },
    /// Another message, by its number.
    Message(usize),
}

impl Kind {
    /// How many bytes each takes, where all take as many.
    pub(crate) const fn size(self) -> Option<usize> {
        match self {
            Self::Bool => Some(1),
            Self::Whole { bytes, .. } => Some(bytes),
            Self::Single => Some(4),
            Self::Double | Self::Time { .. } => Some(8),
            Self::Text | Self::Message(_) => None,
        }
    }
}

/// How many a field holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Count {
    One,
    Fixed(usize),
    /// As many as the message says.
    Any,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Field {
    pub(crate) name: String,
    pub(crate) kind: Kind,
    pub(crate) count: Count,
}

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Message {
    pub(crate) fields: Vec<Field>,
    /// Whether it is a time or a duration.
    pub(crate) is_time: bool,
}

/// A message and those within it; the first is the one that is sent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Schema {
    pub(crate) messages: Vec<Message>,
}

/// The definition of one message.
struct Section<'t> {
    /// `package/Name`.
    name: String,
    lines: Vec<&'t str>,
}

impl Schema {
    /// Reads the definition of the message `name`.
    pub(crate) fn parse(name: &str, text: &[u8], ros: Ros) -> Result<Self, String> {
        if text.len() > MOST_TEXT {
            return Err(format!("its definition is longer than {MOST_TEXT} bytes"));
        }
        let text = std::str::from_utf8(text).map_err(|_| "its definition is not UTF-8 text")?;
        let mut sections = vec![Section {
            name: plain(name),
            lines: Vec::new(),
        }];
        for line in text.lines() {
            let line = line.trim();
            let separates = line.len() >= 3 && line.bytes().all(|byte| byte == b'=');
            match (line.strip_prefix("MSG:"), sections.last_mut()) {
                _ if separates => sections.push(Section {
                    name: String::new(),
                    lines: Vec::new(),
                }),
                (Some(name), Some(section)) if section.name.is_empty() => {
                    section.name = plain(name.trim());
                }
                (_, Some(section)) => section.lines.push(line),
                (_, None) => {}
            }
        }
        sections.retain(|section| !section.name.is_empty());
        if ros == Ros::Two {
            for name in ["builtin_interfaces/Time", "builtin_interfaces/Duration"] {
                if !sections.iter().any(|section| section.name == name) {
                    sections.push(Section {
                        name: name.to_owned(),
                        lines: vec!["int32 sec", "uint32 nanosec"],
                    });
                }
            }
        }
        let names: Vec<String> = sections.iter().map(|s| s.name.clone()).collect();
        let read = |section: &Section<'_>| message(section, &names, ros);
        let messages = sections.iter().map(read).collect::<Result<_, _>>()?;
        Ok(Self { messages })
    }
}

/// `package/msg/Name` as `package/Name`.
fn plain(name: &str) -> String {
    name.replace("/msg/", "/")
}

fn message(section: &Section<'_>, names: &[String], ros: Ros) -> Result<Message, String> {
    let mut fields = Vec::new();
    for line in &section.lines {
        if let Some(read) = field(line, &section.name, names, ros)? {
            fields.push(read);
        }
    }
    let whole =
        |field: &Field| matches!((field.kind, field.count), (Kind::Whole { .. }, Count::One));
    let is_time = match fields.as_slice() {
        [a, b] => are_time(&a.name, &b.name) && whole(a) && whole(b),
        _ => false,
    };
    Ok(Message { fields, is_time })
}

/// A line of a definition: `float64[<=3] position`, with a default value perhaps; `None` for a comment or a
/// constant.
fn field(line: &str, within: &str, names: &[String], ros: Ros) -> Result<Option<Field>, String> {
    let line = line.split('#').next().unwrap_or_default().trim();
    if line.is_empty() {
        return Ok(None);
    }
    let wrong = || format!("its definition has the line `{}`", shown(line.as_bytes()));
    let (typed, rest) = line.split_once(char::is_whitespace).ok_or_else(wrong)?;
    let rest = rest.trim_start();
    let end = rest.find(|c: char| c.is_whitespace() || c == '=');
    let (name, after) = rest.split_at(end.unwrap_or(rest.len()));
    if after.trim_start().starts_with('=') {
        return Ok(None);
    }
    let (base, count) = match typed.split_once('[') {
        None => (typed, Count::One),
        Some((base, size)) => {
            let size = size.strip_suffix(']').ok_or_else(wrong)?;
            let count = match size.parse() {
                _ if size.is_empty() || size.starts_with("<=") => Count::Any,
                Ok(size) => Count::Fixed(size),
                Err(_) => return Err(wrong()),
            };
            (base, count)
        }
    };
    // A bound on the length of a text does not change how it is written.
    let base = base.split_once("<=").map_or(base, |(base, _)| base);
    let kind = match base {
        "wstring" => {
            return Err(format!(
                "its field `{}` is a wstring",
                shown(name.as_bytes())
            ));
        }
        base => match primitive(base, ros) {
            Some(kind) => kind,
            None => Kind::Message(find(base, within, names).ok_or_else(|| {
                let base = shown(base.as_bytes());
                format!("its definition does not say what `{base}` is")
            })?),
        },
    };
    Ok(Some(Field {
        name: name.to_owned(),
        kind,
        count,
    }))
}

fn primitive(name: &str, ros: Ros) -> Option<Kind> {
    let whole = |bytes, signed| Some(Kind::Whole { bytes, signed });
    match (name, ros) {
        ("bool", _) => Some(Kind::Bool),
        ("byte", Ros::One) | ("int8", _) => whole(1, true),
        ("byte", Ros::Two) | ("char" | "uint8", _) => whole(1, false),
        ("int16", _) => whole(2, true),
        ("uint16", _) => whole(2, false),
        ("int32", _) => whole(4, true),
        ("uint32", _) => whole(4, false),
        ("int64", _) => whole(8, true),
        ("uint64", _) => whole(8, false),
        ("float32", _) => Some(Kind::Single),
        ("float64", _) => Some(Kind::Double),
        ("string", _) => Some(Kind::Text),
        ("time", Ros::One) => Some(Kind::Time { signed: false }),
        ("duration", Ros::One) => Some(Kind::Time { signed: true }),
        _ => None,
    }
}

/// The message that a definition means by a name: with its package, or of the same one.
fn find(name: &str, within: &str, names: &[String]) -> Option<usize> {
    let name = plain(name);
    let is = |full: &str| names.iter().position(|known| known == full);
    if name.contains('/') {
        return is(&name);
    }
    let package = within.split_once('/').map_or("", |(package, _)| package);
    let ends = |known: &String| known.rsplit('/').next() == Some(name.as_str());
    is(&format!("{package}/{name}"))
        .or_else(|| is(&format!("std_msgs/{name}")).filter(|_| name == "Header"))
        .or_else(|| names.iter().position(ends))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn definitions_are_read_with_what_they_hold() {
        let text = "# a comment\nstd_msgs/Header header\nstring<=10[<=3] name # more\nfloat64[2] x [0.0, 1.0]\n\
            int32 LIMIT=5\nuint8 MODE = 3\nPart[] parts\nint32 gain 7\n\
            ================\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n\
            ================\nMSG: my/Part\nbyte b\n";
        let schema = Schema::parse("my/msg/Whole", text.as_bytes(), Ros::Two).unwrap();
        let fields: Vec<_> = schema.messages[0]
            .fields
            .iter()
            .map(|f| (f.name.as_str(), f.kind, f.count))
            .collect();
        let whole = Kind::Whole {
            bytes: 4,
            signed: true,
        };
        assert_eq!(
            fields,
            [
                ("header", Kind::Message(1), Count::One),
                ("name", Kind::Text, Count::Any),
                ("x", Kind::Double, Count::Fixed(2)),
                ("parts", Kind::Message(2), Count::Any),
                ("gain", whole, Count::One),
            ]
        );
        assert!(schema.messages[3].is_time);
    }

    #[test]
    fn definitions_that_say_too_little_are_refused() {
        for (text, why) in [
            ("Part part", "does not say what `Part` is"),
            ("wstring text", "a wstring"),
            ("float64", "the line `float64`"),
            ("float64[x] y", "the line"),
        ] {
            let error = Schema::parse("my/Whole", text.as_bytes(), Ros::Two).unwrap_err();
            assert!(error.contains(why), "{error}");
        }
    }
}
