//! MCAP files as ROS writes them.

use std::collections::BTreeMap;
use std::io::Cursor;

use mcap::records::MessageHeader;
use mcap::{WriteOptions, Writer};

const LINE: &str =
    "================================================================================";

/// `sensor_msgs/JointState`, as ROS 2 or ROS 1 defines it.
fn joint_state(ros2: bool) -> String {
    let header = match ros2 {
        true => "builtin_interfaces/Time stamp\nstring frame_id",
        false => "uint32 seq\ntime stamp\nstring frame_id",
    };
    format!(
        "# joints\nstd_msgs/Header header\n\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n{LINE}\nMSG: std_msgs/Header\n{header}\n"
    )
}

fn wrench_stamped(ros2: bool) -> String {
    let joint = joint_state(ros2);
    let header = joint.split(LINE).nth(1).unwrap();
    format!(
        "std_msgs/Header header\nWrench wrench\n{LINE}{header}{LINE}\nMSG: geometry_msgs/Wrench\nVector3 force\nVector3 torque\n{LINE}\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"
    )
}

/// A message in CDR, or in that of ROS 1.
struct Message {
    bytes: Vec<u8>,
    cdr: bool,
}

impl Message {
    fn new(cdr: bool) -> Self {
        Self {
            bytes: if cdr { vec![0, 1, 0, 0] } else { Vec::new() },
            cdr,
        }
    }

    fn put(mut self, bytes: &[u8]) -> Self {
        // The gap before a number is counted from the end of the four bytes in front.
        while self.cdr && !(self.bytes.len() - 4).is_multiple_of(bytes.len()) {
            self.bytes.push(0);
        }
        self.bytes.extend(bytes);
        self
    }

    fn text(self, text: &str) -> Self {
        let ended = if self.cdr { "\0" } else { "" };
        let len = u32::try_from(text.len() + ended.len()).unwrap();
        let mut message = self.put(&len.to_le_bytes());
        message.bytes.extend(text.bytes());
        message.bytes.extend(ended.bytes());
        message
    }

    fn header(self, stamp: u64) -> Self {
        let (seconds, rest) = (stamp / 1_000_000_000, stamp % 1_000_000_000);
        let numbers = [seconds, rest].map(|x| u32::try_from(x).unwrap().to_le_bytes());
        let start = if self.cdr {
            self
        } else {
            self.put(&7_u32.to_le_bytes())
        };
        start.put(&numbers[0]).put(&numbers[1]).text("base")
    }

    fn doubles(self, values: &[f64]) -> Self {
        let len = u32::try_from(values.len()).unwrap();
        let message = self.put(&len.to_le_bytes());
        values.iter().fold(message, |m, x| m.put(&x.to_le_bytes()))
    }
}

/// What is written to a file: a topic, when, and the message.
pub(super) struct Sent {
    pub(super) topic: &'static str,
    pub(super) log_time: u64,
    pub(super) bytes: Vec<u8>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Cdr,
    Ros1,
    Json,
}

impl Form {
    /// The encoding of messages and of their definitions.
    const fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Cdr => ("cdr", "ros2msg"),
            Self::Ros1 => ("ros1", "ros1msg"),
            Self::Json => ("json", "jsonschema"),
        }
    }

    pub(super) fn joints(
        self,
        stamp: u64,
        names: &[&str],
        position: &[f64],
        effort: &[f64],
    ) -> Vec<u8> {
        if self == Self::Json {
            let (seconds, rest) = (stamp / 1_000_000_000, stamp % 1_000_000_000);
            return format!(
                r#"{{"header":{{"stamp":{{"sec":{seconds},"nsec":{rest}}},"frame_id":"base"}},"name":{names:?},"position":{position:?},"velocity":[],"effort":{effort:?}}}"#
            )
            .into_bytes();
        }
        let message = Message::new(self == Self::Cdr).header(stamp);
        let len = u32::try_from(names.len()).unwrap();
        let message = message.put(&len.to_le_bytes());
        let message = names.iter().fold(message, |m, name| m.text(name));
        message.doubles(position).doubles(&[]).doubles(effort).bytes
    }

    pub(super) fn wrench(self, stamp: u64, force: f64) -> Vec<u8> {
        self.vectors(stamp, [force, 0.0, 0.0], [0.0; 3])
    }

    /// A wrench of a force and a torque.
    pub(super) fn vectors(self, stamp: u64, force: [f64; 3], torque: [f64; 3]) -> Vec<u8> {
        if self == Self::Json {
            let vector = |[x, y, z]: [f64; 3]| format!(r#"{{"x":{x:?},"y":{y:?},"z":{z:?}}}"#);
            let (force, torque) = (vector(force), vector(torque));
            return format!(
                r#"{{"header":{{"stamp":{{"sec":{},"nsec":{}}},"frame_id":"base"}},"wrench":{{"force":{force},"torque":{torque}}}}}"#,
                stamp / 1_000_000_000,
                stamp % 1_000_000_000
            )
            .into_bytes();
        }
        let message = Message::new(self == Self::Cdr).header(stamp);
        let all = force.iter().chain(&torque);
        all.fold(message, |m, x| m.put(&x.to_le_bytes())).bytes
    }
}

/// A file with these messages.
pub(super) fn file(options: WriteOptions, form: Form, sent: &[Sent]) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let mut writer = options.create(&mut bytes).unwrap();
    let (encoding, definitions) = form.names();
    let mut channels = BTreeMap::new();
    for (i, message) in (0_u32..).zip(sent) {
        let channel_id = *channels.entry(message.topic).or_insert_with(|| {
            let (name, text) = match message.topic {
                "/wrench" => (
                    "geometry_msgs/WrenchStamped",
                    wrench_stamped(form == Form::Cdr),
                ),
                _ => ("sensor_msgs/JointState", joint_state(form == Form::Cdr)),
            };
            let name = match form {
                Form::Cdr => name.replace('/', "/msg/"),
                _ => name.to_owned(),
            };
            let schema = writer
                .add_schema(&name, definitions, text.as_bytes())
                .unwrap();
            writer
                .add_channel(schema, message.topic, encoding, &BTreeMap::new())
                .unwrap()
        });
        put(&mut writer, channel_id, i, message);
    }
    writer.finish().unwrap();
    drop(writer);
    bytes.into_inner()
}

pub(super) fn put(
    writer: &mut Writer<&mut Cursor<Vec<u8>>>,
    channel_id: u16,
    i: u32,
    message: &Sent,
) {
    let header = MessageHeader {
        channel_id,
        sequence: i,
        log_time: message.log_time,
        publish_time: message.log_time - 10,
    };
    writer
        .write_to_known_channel(&header, &message.bytes)
        .unwrap();
}
