//! MCAP logs: as CSV ones, and an error for every file that is cut short, corrupt or in an encoding that is
//! not read.

use std::collections::BTreeMap;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use mcap::records::MessageHeader;
use mcap::{Compression, WriteOptions, Writer};
use passivity_audit::{
    Audit, Columns, Dialect, Options, Stretch, TraceError, Verdict, audit, audit_csv, audit_files,
    audit_part, samples,
};
use passivity_scene::Scene;
use proptest::prelude::*;

const LINEAR: &str = "[device]\nviscous = \"2 N s/m\"\ncoulomb = \"1/2 N\"\n[sampling]\nperiod = \"1 ms\"\n[encoder]\nresolution = \"0.25 mm\"\n[wall]\nstiffness = \"1 N/mm\"";

fn scene() -> Scene {
    Scene::from_toml("test", LINEAR).unwrap()
}

fn rotary() -> Scene {
    let text = "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"2 N m/rad\"";
    Scene::from_toml("test", text).unwrap()
}

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
struct Sent {
    topic: &'static str,
    log_time: u64,
    bytes: Vec<u8>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
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

    fn joints(self, stamp: u64, names: &[&str], position: &[f64], effort: &[f64]) -> Vec<u8> {
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

    fn wrench(self, stamp: u64, force: f64) -> Vec<u8> {
        if self == Self::Json {
            return format!(
                r#"{{"header":{{"stamp":{{"sec":{},"nsec":{}}},"frame_id":"base"}},"wrench":{{"force":{{"x":{force:?},"y":0.0,"z":0.0}},"torque":{{"x":0.0,"y":0.0,"z":0.0}}}}}}"#,
                stamp / 1_000_000_000,
                stamp % 1_000_000_000
            )
            .into_bytes();
        }
        let message = Message::new(self == Self::Cdr).header(stamp);
        [force, 0.0, 0.0, 0.0, 0.0, 0.0]
            .iter()
            .fold(message, |m, x| m.put(&x.to_le_bytes()))
            .bytes
    }
}

/// A file with these messages.
fn file(options: WriteOptions, form: Form, sent: &[Sent]) -> Vec<u8> {
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

fn put(writer: &mut Writer<&mut Cursor<Vec<u8>>>, channel_id: u16, i: u32, message: &Sent) {
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

fn save(name: &str, bytes: &[u8]) -> PathBuf {
    let path = std::env::temp_dir().join(format!("passivity-{}-{name}.mcap", std::process::id()));
    fs::write(&path, bytes).unwrap();
    path
}

const START: u64 = 1_700_000_000_123_456_789;

/// The motion of the tests: the stamp, the position in m and the force in N of each sample.
fn motion() -> impl Iterator<Item = (u64, f64, f64)> {
    (0_i32..200).map(|k| {
        let t = f64::from(k) * 0.05;
        let x = 0.004 * t.sin();
        let jitter = u64::from(k.unsigned_abs() % 3) * 1234;
        let stamp = START + u64::from(k.unsigned_abs()) * 1_000_000 + jitter;
        (stamp, x, -1000.0 * x)
    })
}

/// Joint states and wrenches, the force just before the position it goes with.
fn sent(form: Form) -> Vec<Sent> {
    let mut sent = Vec::new();
    for (stamp, x, f) in motion() {
        sent.push(Sent {
            topic: "/wrench",
            log_time: stamp + 50,
            bytes: form.wrench(stamp - 100, f),
        });
        sent.push(Sent {
            topic: "/joint_states",
            log_time: stamp + 100,
            bytes: form.joints(stamp, &["slide", "other"], &[x, 1.0], &[f, 0.0]),
        });
    }
    sent
}

/// The same as CSV, with the header that the file has.
fn csv() -> String {
    let mut csv =
        "/joint_states.header.stamp [ns],/joint_states.position.slide,/wrench.wrench.force.x\n"
            .to_owned();
    for (stamp, x, f) in motion() {
        csv.push_str(&format!("{stamp},{x:?},{f:?}\n"));
    }
    csv
}

fn dialect(columns: &str) -> Dialect {
    Dialect {
        columns: Some(columns.parse::<Columns>().unwrap()),
        ..Dialect::default()
    }
}

fn read(path: &Path, columns: &str, scene: &Scene) -> Result<Audit, TraceError> {
    let options = Options {
        dialect: dialect(columns),
        ..Options::default()
    };
    audit(path, scene, options)
}

const COLUMNS: &str = "t=/joint_states.header.stamp [ns], x=/joint_states.position.slide [m], f=/wrench.wrench.force.x [N]";

/// A report without what is only in the file.
fn report(audit: &Audit) -> (String, serde_json::Value) {
    let mut json = serde_json::to_value(audit.to_json()).unwrap();
    json.as_object_mut().unwrap().remove("not_read");
    let text = audit.to_text();
    let lines = text.lines().filter(|line| !line.starts_with("  not read"));
    (lines.collect::<Vec<_>>().join("\n"), json)
}

fn every_way() -> impl Iterator<Item = (WriteOptions, Form)> {
    let forms = [Form::Cdr, Form::Ros1, Form::Json];
    let plain = || WriteOptions::new().compression(None);
    let ways: [fn(WriteOptions) -> WriteOptions; 6] = [
        |o| o.use_chunks(false),
        |o| o.chunk_size(Some(2000)),
        |o| o.compression(Some(Compression::Zstd)),
        |o| o.compression(Some(Compression::Lz4)).chunk_size(Some(3000)),
        |o| o.emit_summary_records(false),
        |o| {
            o.emit_statistics(false)
                .calculate_chunk_crcs(false)
                .calculate_data_section_crc(false)
        },
    ];
    forms
        .into_iter()
        .flat_map(move |form| ways.map(|way| (way(plain()), form)))
}

#[test]
fn a_report_is_that_of_the_same_csv() {
    let input = Box::new(Cursor::new(csv().into_bytes()));
    let options = Options {
        dialect: dialect(COLUMNS),
        ..Options::default()
    };
    let expected = audit_csv(input, &scene(), options).unwrap();
    assert_eq!(expected.error(), None);
    assert_eq!(expected.totals().intervals, 199);
    for (i, (options, form)) in every_way().enumerate() {
        let path = save(&format!("same-{i}"), &file(options, form, &sent(form)));
        let found = read(&path, COLUMNS, &scene()).unwrap();
        assert_eq!(found.error(), None, "{i} {form:?}");
        assert_eq!(report(&found), report(&expected), "{i} {form:?}");
        let not_read = &found.report().not_read;
        assert!(
            not_read.contains(&"/joint_states.log_time [ns]".to_owned()),
            "{not_read:?}"
        );
        fs::remove_file(path).unwrap();
    }
}

#[test]
fn a_file_proposes_the_columns_that_read_it() {
    let proposed = |name: &str, sent: &[Sent], scene: &Scene| {
        let path = save(name, &file(WriteOptions::new(), Form::Cdr, sent));
        let error = audit(&path, scene, Options::default()).unwrap_err();
        let columns = error
            .proposal
            .unwrap_or_else(|| panic!("{}", error.message))
            .columns;
        let found = read(&path, &columns, scene).unwrap();
        assert_eq!(found.error(), None);
        fs::remove_file(path).unwrap();
        columns
    };
    let stamp = "t=/joint_states.header.stamp [ns]";
    let joint = "x=/joint_states.position.slide [m]";
    assert_eq!(
        proposed("both", &sent(Form::Cdr), &scene()),
        format!("{stamp}, {joint}, f=/joint_states.effort.slide [N]")
    );
    // Without effort the wrench is proposed, the force in a linear scene and the torque in a rotary one; the
    // clock is that of the position.
    let mut only = sent(Form::Cdr);
    for (message, (stamp, x, _)) in only.iter_mut().skip(1).step_by(2).zip(motion()) {
        message.bytes = Form::Cdr.joints(stamp, &["slide", "other"], &[x, 1.0], &[]);
    }
    assert_eq!(
        proposed("force", &only, &scene()),
        format!("{stamp}, {joint}, f=/wrench.wrench.force.x [N]")
    );
    assert_eq!(
        proposed("torque", &only, &rotary()),
        format!("{stamp}, x=/joint_states.position.slide [rad], f=/wrench.wrench.torque.x [N m]")
    );
}

#[test]
fn elements_without_names_have_numbers() {
    let mut sent = sent(Form::Cdr);
    for (message, (stamp, x, f)) in sent.iter_mut().skip(1).step_by(2).zip(motion()) {
        message.bytes = Form::Cdr.joints(stamp, &[], &[x, 1.0], &[f, 2.0]);
    }
    let path = save("numbers", &file(WriteOptions::new(), Form::Cdr, &sent));
    let columns =
        "t=/joint_states.log_time, x=/joint_states.position[0] [m], f=/joint_states.effort[0] [N]";
    let found = read(&path, columns, &scene()).unwrap();
    assert_eq!(found.totals().intervals, 199);
    assert_eq!(found.error(), None);
    let sampled = samples(&path, &scene(), &dialect(columns)).unwrap();
    assert_eq!(sampled.positions.len(), 200);
    fs::remove_file(path).unwrap();
}

#[test]
fn other_joints_on_the_same_topic_are_no_rows() {
    let mut sent = Vec::new();
    for (stamp, x, f) in motion() {
        for (names, x) in [(["gripper", "finger"], 9.0), (["slide", "other"], x)] {
            sent.push(Sent {
                topic: "/joint_states",
                log_time: stamp,
                bytes: Form::Cdr.joints(stamp, &names, &[x, 1.0], &[f, 0.0]),
            });
        }
    }
    let path = save("joints", &file(WriteOptions::new(), Form::Cdr, &sent));
    let columns = "t=/joint_states.header.stamp, x=/joint_states.position.slide [m], f=/joint_states.effort.slide [N]";
    let found = read(&path, columns, &scene()).unwrap();
    assert_eq!(found.error(), None);
    assert_eq!(found.totals().intervals, 199);
    fs::remove_file(path).unwrap();
}

#[test]
fn rows_before_the_first_force_are_left_out_and_said() {
    let sent: Vec<Sent> = sent(Form::Cdr)
        .into_iter()
        .enumerate()
        .filter(|(i, _)| *i != 0 && *i != 2)
        .map(|(_, s)| s)
        .collect();
    let path = save("late", &file(WriteOptions::new(), Form::Cdr, &sent));
    let found = read(&path, COLUMNS, &scene()).unwrap();
    assert_eq!(found.totals().intervals, 197);
    let said = found.report().findings.first().unwrap();
    assert_eq!(
        said.says,
        "2 messages on /joint_states came before the first on /wrench and are no rows"
    );
    // Who needs to know how the log began is told that this is not known.
    let error = samples(&path, &scene(), &dialect(COLUMNS)).unwrap_err();
    assert!(
        error.message.contains("came before") && error.message.contains("mcap filter"),
        "{error}"
    );
    // A log that goes on in another file goes on with the force that was held.
    let first = save(
        "first",
        &file(
            WriteOptions::new(),
            Form::Cdr,
            &self::sent(Form::Cdr)[..200],
        ),
    );
    let second = save(
        "second",
        &file(
            WriteOptions::new(),
            Form::Cdr,
            &self::sent(Form::Cdr)[201..],
        ),
    );
    let options = Options {
        dialect: dialect(COLUMNS),
        ..Options::default()
    };
    let found = audit_files(&[first.clone(), second.clone()], &scene(), options).unwrap();
    assert_eq!(found.error(), None);
    assert_eq!(found.totals().intervals, 199);
    // All rows before the first force.
    let never: Vec<Sent> = [1, 3, 5, 0]
        .into_iter()
        .zip(0..)
        .map(|(i, t)| Sent {
            log_time: START + t,
            ..self::sent(Form::Cdr).swap_remove(i)
        })
        .collect();
    let path_of_never = save("never", &file(WriteOptions::new(), Form::Cdr, &never));
    let error = read(&path_of_never, COLUMNS, &scene()).unwrap_err();
    assert!(
        error
            .message
            .contains("all messages on `/joint_states` come before"),
        "{error}"
    );
    for path in [path, first, second, path_of_never] {
        fs::remove_file(path).unwrap();
    }
}

#[test]
fn a_file_out_of_order_is_refused_where_it_matters() {
    let mut sent = sent(Form::Cdr);
    sent[20].log_time = START;
    let path = save("order", &file(WriteOptions::new(), Form::Cdr, &sent));
    let found = read(&path, COLUMNS, &scene()).unwrap();
    let error = found.error().unwrap();
    assert_eq!(error.row, Some(11));
    assert!(
        error.message.contains("`/wrench`") && error.message.contains("mcap sort"),
        "{error}"
    );
    // Of one topic alone the stamps tell.
    let columns = "t=/joint_states.header.stamp, x=/joint_states.position.slide [m]";
    assert_eq!(read(&path, columns, &scene()).unwrap().error(), None);
    fs::remove_file(path).unwrap();
}

#[test]
fn what_is_missing_in_a_row_is_an_error_there() {
    for (effort, why) in [(&[][..], "``"), (&[f64::NAN, 0.0][..], "NaN")] {
        let mut sent = sent(Form::Cdr);
        sent[9].bytes =
            Form::Cdr.joints(START + 4_000_000, &["slide", "other"], &[0.0, 0.0], effort);
        let path = save("missing", &file(WriteOptions::new(), Form::Cdr, &sent));
        let columns = "t=/joint_states.log_time, x=/joint_states.position.slide [m], f=/joint_states.effort.slide [N]";
        let found = read(&path, columns, &scene()).unwrap();
        let error = found.error().unwrap();
        assert_eq!(error.row, Some(5));
        assert_eq!(error.column.as_deref(), Some("/joint_states.effort.slide"));
        assert!(error.message.contains(why), "{error}");
        assert_eq!(found.totals().intervals, 3);
        fs::remove_file(path).unwrap();
    }
}

#[test]
fn other_encodings_are_refused_by_name() {
    for (encoding, definitions) in [
        ("protobuf", "protobuf"),
        ("cdr", "ros2idl"),
        ("flatbuffer", "flatbuffer"),
        ("cbor", ""),
    ] {
        let mut bytes = Cursor::new(Vec::new());
        let mut writer = Writer::new(&mut bytes).unwrap();
        let schema = match definitions {
            "" => 0,
            other => writer.add_schema("x", other, b"").unwrap(),
        };
        let channel = writer
            .add_channel(schema, "/arm", encoding, &BTreeMap::new())
            .unwrap();
        let message = Sent {
            topic: "/arm",
            log_time: START,
            bytes: vec![1, 2, 3],
        };
        put(&mut writer, channel, 1, &message);
        writer.finish().unwrap();
        drop(writer);
        let path = save("other", &bytes.into_inner());
        for told in [Dialect::default(), dialect("x=/arm.position [m]")] {
            let options = Options {
                dialect: told,
                ..Options::default()
            };
            let error = audit(&path, &scene(), options).unwrap_err();
            assert!(
                error.message.contains("`/arm`") && error.message.contains(encoding),
                "{error}"
            );
        }
        fs::remove_file(path).unwrap();
    }
}

#[test]
fn messages_that_are_long_or_wide_take_bounded_work() {
    let long = format!("{{\"data\":[{}0]}}", "0,".repeat(3 << 20));
    let list = format!("[{}0]", "0,".repeat(63));
    let lists = format!("[{}{list}]", format!("{list},").repeat(63));
    let wide = format!("{{\"data\":[{}{lists}]}}", format!("{lists},").repeat(63));
    for (message, why) in [(long, "longer than 4 MiB"), (wide, "expected a column")] {
        let mut bytes = Cursor::new(Vec::new());
        let mut writer = Writer::new(&mut bytes).unwrap();
        let channel = writer
            .add_channel(0, "/data", "json", &BTreeMap::new())
            .unwrap();
        for i in 0..3 {
            let message = Sent {
                topic: "/data",
                log_time: START,
                bytes: message.clone().into_bytes(),
            };
            put(&mut writer, channel, i, &message);
        }
        writer.finish().unwrap();
        drop(writer);
        let path = save("long", &bytes.into_inner());
        let error = audit(&path, &scene(), Options::default()).unwrap_err();
        assert!(error.message.contains(why), "{error}");
        fs::remove_file(path).unwrap();
    }
}

#[test]
fn files_that_are_cut_short_are_accounted_for_up_to_there() {
    for chunk in [None, Some(2000)] {
        let options = WriteOptions::new()
            .compression(None)
            .use_chunks(chunk.is_some())
            .chunk_size(chunk);
        let whole = file(options, Form::Cdr, &sent(Form::Cdr));
        let mut least = 0;
        for share in 1..20 {
            let len = whole.len() * share / 20;
            let path = save("cut", &whole[..len]);
            match read(&path, COLUMNS, &scene()) {
                Ok(found) => {
                    assert_eq!(found.verdict(), Verdict::Broken, "{share}");
                    let error = found.error().unwrap();
                    assert!(
                        error.message.contains("byte") || error.message.contains("checksum"),
                        "{error}"
                    );
                    assert!(found.totals().intervals >= least);
                    least = found.totals().intervals;
                }
                Err(error) => assert!(error.message.contains("byte"), "{error}"),
            }
            fs::remove_file(path).unwrap();
        }
        assert!(least > 100, "{least}");
    }
}

#[test]
fn a_file_that_was_changed_is_an_error_before_it_is_used() {
    let options = WriteOptions::new().compression(None).chunk_size(Some(4000));
    let whole = file(options, Form::Cdr, &sent(Form::Cdr));
    let at = whole.len() / 3;
    let mut changed = whole.clone();
    changed[at] ^= 1;
    let path = save("changed", &changed);
    let found = read(&path, COLUMNS, &scene()).unwrap();
    let error = found.error().unwrap();
    assert!(error.message.contains("checksum"), "{error}");
    assert!(found.totals().intervals > 10);
    fs::remove_file(path).unwrap();
}

#[test]
fn pieces_and_streams_are_refused() {
    let bytes = file(WriteOptions::new(), Form::Cdr, &sent(Form::Cdr));
    let path = save("piece", &bytes);
    let options = || Options {
        dialect: dialect(COLUMNS),
        ..Options::default()
    };
    let Err(error) = audit_part(&path, &scene(), Stretch::Shard(1, 2), options()) else {
        panic!("a piece of an MCAP file");
    };
    assert!(error.message.contains("from its start"), "{error}");
    let error = audit_csv(Box::new(Cursor::new(bytes)), &scene(), options()).unwrap_err();
    assert!(error.message.contains("must be a file"), "{error}");
    let csv = save("csv", csv().as_bytes());
    let error = audit_files(&[csv.clone(), path.clone()], &scene(), options()).unwrap();
    assert!(
        error.error().unwrap().message.contains("goes on only"),
        "{:?}",
        error.error()
    );
    for path in [path, csv] {
        fs::remove_file(path).unwrap();
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// A report or an error, whatever the file.
    #[test]
    fn any_bytes_are_a_report_or_an_error(
        bytes in prop::collection::vec(any::<u8>(), 0..400),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        way in 0_usize..18,
        told in any::<bool>(),
    ) {
        let (options, form) = every_way().nth(way).unwrap();
        let mut changed = file(options, form, &sent(form)[..12]);
        for (at, byte) in changes {
            let len = changed.len();
            changed[at.index(len)] = byte;
        }
        let mut random = b"\x89MCAP0\r\n".to_vec();
        random.extend(bytes);
        for bytes in [changed, random] {
            let path = save(&format!("any-{:?}", std::thread::current().id()).replace(['(', ')'], ""), &bytes);
            let told = if told { dialect(COLUMNS) } else { Dialect::default() };
            let options = Options { dialect: told, threads: 1, ..Options::default() };
            let found = audit(&path, &scene(), options);
            prop_assert!(found.is_err() || found.is_ok_and(|audit| !audit.to_text().is_empty()));
            let _ = fs::remove_file(&path);
        }
    }
}
