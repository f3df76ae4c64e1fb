//! MCAP recordings: the command that the error shows reads them.

use crate::harness::Dir;
use crate::logs::{SCENE, Sample, motion, told};

const JOINT_STATE: &str = "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n\
    ===\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n";
const WRENCH: &str = "std_msgs/Header header\ngeometry_msgs/Wrench wrench\n===\nMSG: std_msgs/Header\n\
    builtin_interfaces/Time stamp\nstring frame_id\n===\nMSG: geometry_msgs/Wrench\nVector3 force\nVector3 torque\n\
    ===\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n";

/// The start of a message in CDR: its stamp and no frame.
fn header(sample: &Sample) -> Vec<u8> {
    let nanos = 1_700_000_000_000_000_000 + 1000 * u64::try_from(sample.micros).unwrap();
    let words = [nanos / 1_000_000_000, nanos % 1_000_000_000, 1];
    let words = words.map(|word| u32::try_from(word).unwrap().to_le_bytes());
    let mut bytes = vec![0, 1, 0, 0];
    bytes.extend(words.concat());
    bytes.extend([0; 4]);
    bytes
}

/// The joint state of a sample, with its torque or without.
fn joint_state(sample: &Sample, torque: bool) -> Vec<u8> {
    let mut bytes = header(sample);
    bytes.extend([1, 0, 0, 0, 5, 0, 0, 0]);
    bytes.extend(b"knob\0\0\0\0");
    let numbers: [(u32, f64); 3] = [
        (1, sample.radians),
        (1, sample.velocity),
        (u32::from(torque), sample.torque),
    ];
    for (len, number) in numbers {
        bytes.extend(len.to_le_bytes());
        if len > 0 {
            // Behind the four bytes in front, a double starts at a multiple of eight.
            bytes.resize((bytes.len() - 4).next_multiple_of(8) + 4, 0);
            bytes.extend(number.to_le_bytes());
        }
    }
    bytes
}

fn wrench(sample: &Sample) -> Vec<u8> {
    let mut bytes = header(sample);
    for number in [0.0, 0.0, 0.0, sample.torque, 0.0, 0.0] {
        bytes.extend(f64::to_le_bytes(number));
    }
    bytes
}

/// An MCAP file of joint states, with the torques in them or in wrenches of their own.
fn mcap(samples: &[Sample], wrenches: bool) -> Vec<u8> {
    let mut file = std::io::Cursor::new(Vec::new());
    let mut writer = mcap::Writer::new(&mut file).unwrap();
    let mut channel = |topic: &str, name: &str, text: &str| {
        let schema = writer.add_schema(name, "ros2msg", text.as_bytes()).unwrap();
        let none = std::collections::BTreeMap::new();
        writer.add_channel(schema, topic, "cdr", &none).unwrap()
    };
    let joints = channel("/joint_states", "sensor_msgs/msg/JointState", JOINT_STATE);
    let force = channel("/ft", "geometry_msgs/msg/WrenchStamped", WRENCH);
    for (sequence, sample) in (0..).zip(samples) {
        let mut put = |channel_id, bytes: &[u8]| {
            let time = u64::try_from(sample.micros).unwrap();
            let header = mcap::records::MessageHeader {
                channel_id,
                sequence,
                log_time: time,
                publish_time: time,
            };
            writer.write_to_known_channel(&header, bytes).unwrap();
        };
        if wrenches {
            put(force, &wrench(sample));
        }
        put(joints, &joint_state(sample, !wrenches));
    }
    writer.finish().unwrap();
    drop(writer);
    file.into_inner()
}

#[test]
fn mcap_is_read_by_the_command_that_the_error_shows() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    let samples = motion(0, 1.0);
    let columns = "t=/joint_states.header.stamp [ns], x=/joint_states.position.knob [rad], \
        v=/joint_states.velocity.knob [rad/s], ";
    for (wrenches, force) in [
        (false, "f=/joint_states.effort.knob [N m]"),
        (true, "f=/ft.wrench.torque.x [N m]"),
    ] {
        std::fs::write(dir.path("run.mcap"), mcap(&samples, wrenches)).unwrap();
        let (run, json) = told(&dir, "run.mcap");
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert_eq!(json["columns"], format!("{columns}{force}"));
        assert_eq!(json["intervals"], 149);
        assert_eq!(json["force"]["agrees"], true, "{}", json["force"]);
    }
    // What is cut short is accounted for up to there.
    let whole = mcap(&samples, false);
    std::fs::write(dir.path("cut.mcap"), &whole[..whole.len() / 2]).unwrap();
    let run = dir.run(&["audit", "cut.mcap", "--scene", "scene.toml"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cut short"), "{}", run.stderr);
    // A piece of it is refused.
    let piece = [
        "audit",
        "run.mcap",
        "--scene",
        "scene.toml",
        "--shard",
        "1/2",
        "--partial",
        "part.json",
    ];
    let run = dir.run(&piece);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("from its start"), "{}", run.stderr);
}
