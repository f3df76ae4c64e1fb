//! MCAP logs: as CSV ones, and an error for every file that is cut short, corrupt or in an encoding that is
//! not read.

mod clocks;
mod held;
mod mistakes;
mod write;

use std::io::Cursor;
use std::path::Path;

use mcap::{Compression, WriteOptions};
use passivity_audit::{
    Audit, Columns, Dialect, Options, TraceError, audit, audit_csv, audit_files, samples,
};
use passivity_random::draws;
use passivity_scene::Scene;
use proptest::prelude::*;

use crate::scratch::Scratch;
use write::{Form, Sent, file};

const LINEAR: &str = "[device]\nviscous = \"2 N s/m\"\ncoulomb = \"1/2 N\"\n[sampling]\nperiod = \"1 ms\"\n[encoder]\nresolution = \"0.25 mm\"\n[wall]\nstiffness = \"1 N/mm\"";

fn scene() -> Scene {
    Scene::from_toml("test", LINEAR).unwrap()
}

fn rotary() -> Scene {
    let text = "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"2 N m/rad\"";
    Scene::from_toml("test", text).unwrap()
}

fn save(bytes: &[u8]) -> Scratch {
    Scratch::new("mcap", bytes)
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
        let path = save(&file(options, form, &sent(form)));
        let found = read(&path, COLUMNS, &scene()).unwrap();
        assert_eq!(found.error(), None, "{i} {form:?}");
        assert_eq!(report(&found), report(&expected), "{i} {form:?}");
        let not_read = &found.report().not_read;
        assert!(
            not_read.contains(&"/joint_states.log_time [ns]".to_owned()),
            "{not_read:?}"
        );
    }
}

#[test]
fn a_file_proposes_the_columns_that_read_it() {
    let proposed = |sent: &[Sent], scene: &Scene| {
        let path = save(&file(WriteOptions::new(), Form::Cdr, sent));
        let error = audit(&path, scene, Options::default()).unwrap_err();
        let columns = error
            .proposal
            .unwrap_or_else(|| panic!("{}", error.message))
            .columns;
        let found = read(&path, &columns, scene).unwrap();
        assert_eq!(found.error(), None);
        columns
    };
    let stamp = "t=/joint_states.header.stamp [ns]";
    let joint = "x=/joint_states.position.slide [m]";
    assert_eq!(
        proposed(&sent(Form::Cdr), &scene()),
        format!("{stamp}, {joint}, f=/joint_states.effort.slide [N]")
    );
    // Without effort the wrench is proposed, the force in a linear scene and the torque in a rotary one; the
    // clock is that of the position.
    let mut only = sent(Form::Cdr);
    for (message, (stamp, x, _)) in only.iter_mut().skip(1).step_by(2).zip(motion()) {
        message.bytes = Form::Cdr.joints(stamp, &["slide", "other"], &[x, 1.0], &[]);
    }
    assert_eq!(
        proposed(&only, &scene()),
        format!("{stamp}, {joint}, f=/wrench.wrench.force.x [N]")
    );
    assert_eq!(
        proposed(&only, &rotary()),
        format!("{stamp}, x=/joint_states.position.slide [rad], f=/wrench.wrench.torque.x [N m]")
    );
    // Of the components one that is not zero, also where the joints have an effort that is.
    for (message, (stamp, _, f)) in only.iter_mut().step_by(2).zip(motion()) {
        message.bytes = Form::Cdr.vectors(stamp, [0.0; 3], [0.0, 0.0, f]);
    }
    for (message, (stamp, x, _)) in only.iter_mut().skip(1).step_by(2).zip(motion()) {
        message.bytes = Form::Cdr.joints(stamp, &["slide", "other"], &[x, 1.0], &[0.0, 0.0]);
    }
    assert_eq!(
        proposed(&only, &rotary()),
        format!("{stamp}, x=/joint_states.position.slide [rad], f=/wrench.wrench.torque.z [N m]")
    );
}

#[test]
fn a_float_has_no_digits_that_it_was_rounded_to() {
    // In the tick of the wall its force is -0.125 N, to one decimal -0.1.
    let of = |form: Form, first: f64, force: f64| {
        let sent: Vec<Sent> = (0..9_u32)
            .map(|k| {
                let stamp = START + u64::from(k) * 1_000_000;
                let x = f64::from(k) * 1e-5;
                let force = if k == 0 { first } else { force };
                Sent {
                    topic: "/joint_states",
                    log_time: stamp,
                    bytes: form.joints(stamp, &["slide", "other"], &[x, 1.0], &[force, 0.0]),
                }
            })
            .collect();
        let path = save(&file(WriteOptions::new(), form, &sent));
        let columns = "t=/joint_states.header.stamp, x=/joint_states.position.slide [m], f=/joint_states.effort.slide [N]";
        let found = read(&path, columns, &scene()).unwrap();
        found.report().force.clone().unwrap()
    };
    for (form, mismatches) in [(Form::Cdr, 9), (Form::Ros1, 9), (Form::Json, 0)] {
        let force = of(form, -0.1, -0.1);
        assert_eq!(force.mismatches, mismatches, "{form:?}");
        assert_eq!(force.agrees, mismatches == 0);
        assert!(of(form, 0.0, 0.0).zero);
        // Beside one with all its digits, -0.1 is -0.100.
        assert_eq!(of(form, -0.125, -0.1).mismatches, 8, "{form:?}");
    }
}

#[test]
fn topics_that_are_not_read_are_named() {
    let topics = ["/b/joints", "/a/joints", "/other/states"];
    let many: Vec<String> = (0..20).map(|i| format!("/more/{i:02}")).collect();
    let few = |sent: &[Sent], topic: &'static str| -> Vec<Sent> {
        let joints = sent.iter().skip(1).step_by(2).take(4);
        let other = joints.map(|joint| Sent {
            topic,
            log_time: joint.log_time,
            bytes: joint.bytes.clone(),
        });
        other.collect()
    };
    let audited = |topics: &[&'static str], options: WriteOptions| {
        let mut sent = sent(Form::Cdr);
        for topic in topics {
            let more = few(&sent, topic);
            sent.extend(more);
        }
        sent.sort_by_key(|sent| sent.log_time);
        let path = save(&file(options, Form::Cdr, &sent));
        let error = audit(&path, &scene(), Options::default()).unwrap_err();
        (error.message, read(&path, COLUMNS, &scene()).unwrap())
    };
    for options in [
        WriteOptions::new(),
        WriteOptions::new().emit_summary_records(false),
    ] {
        let (error, found) = audited(&topics, options);
        assert!(error.contains("all on /b/joints, all on /"), "{error}");
        let not_read = &found.report().not_read;
        let others = not_read.iter().filter(|name| name.starts_with("all on"));
        let expected = ["/a/joints", "/b/joints", "/other/states"];
        assert!(
            others.eq(&expected.map(|topic| format!("all on {topic}"))),
            "{not_read:?}"
        );
    }
    let many: Vec<&'static str> = many.into_iter().map(|name| &*name.leak()).collect();
    let (_, found) = audited(&many, WriteOptions::new());
    let last = found.report().not_read.last().unwrap();
    assert_eq!(last, "and 4 topics more");
    let (error, found) = audited(&[], WriteOptions::new());
    assert!(!error.contains("all on /joint"), "{error}");
    assert!(
        found
            .report()
            .not_read
            .iter()
            .all(|name| !name.starts_with("all on"))
    );
}

#[test]
fn elements_without_names_have_numbers() {
    let mut sent = sent(Form::Cdr);
    for (message, (stamp, x, f)) in sent.iter_mut().skip(1).step_by(2).zip(motion()) {
        message.bytes = Form::Cdr.joints(stamp, &[], &[x, 1.0], &[f, 2.0]);
    }
    let path = save(&file(WriteOptions::new(), Form::Cdr, &sent));
    let columns =
        "t=/joint_states.log_time, x=/joint_states.position[0] [m], f=/joint_states.effort[0] [N]";
    let found = read(&path, columns, &scene()).unwrap();
    assert_eq!(found.totals().intervals, 199);
    assert_eq!(found.error(), None);
    let sampled = samples(&path, &scene(), &dialect(columns)).unwrap();
    assert_eq!(sampled.positions.len(), 200);
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
    let path = save(&file(WriteOptions::new(), Form::Cdr, &sent));
    let columns = "t=/joint_states.header.stamp, x=/joint_states.position.slide [m], f=/joint_states.effort.slide [N]";
    let found = read(&path, columns, &scene()).unwrap();
    assert_eq!(found.error(), None);
    assert_eq!(found.totals().intervals, 199);
}

#[test]
fn rows_before_the_first_force_are_left_out_and_said() {
    let sent: Vec<Sent> = sent(Form::Cdr)
        .into_iter()
        .enumerate()
        .filter(|(i, _)| *i != 0 && *i != 2)
        .map(|(_, s)| s)
        .collect();
    let path = save(&file(WriteOptions::new(), Form::Cdr, &sent));
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
    let first = save(&file(
        WriteOptions::new(),
        Form::Cdr,
        &self::sent(Form::Cdr)[..200],
    ));
    let second = save(&file(
        WriteOptions::new(),
        Form::Cdr,
        &self::sent(Form::Cdr)[201..],
    ));
    let options = Options {
        dialect: dialect(COLUMNS),
        ..Options::default()
    };
    let found = audit_files(
        &[first.to_path_buf(), second.to_path_buf()],
        &scene(),
        options,
    )
    .unwrap();
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
    let path_of_never = save(&file(WriteOptions::new(), Form::Cdr, &never));
    let error = read(&path_of_never, COLUMNS, &scene()).unwrap_err();
    assert!(
        error
            .message
            .contains("all messages on `/joint_states` come before"),
        "{error}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(75)))]

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
            let path = save(&bytes);
            let told = if told { dialect(COLUMNS) } else { Dialect::default() };
            let options = Options { dialect: told, threads: 1, ..Options::default() };
            let found = audit(&path, &scene(), options);
            prop_assert!(found.is_err() || found.is_ok_and(|audit| !audit.to_text().is_empty()));
        }
    }
}

#[test]
fn a_time_may_be_in_two_fields() {
    let message = |i: u64| Sent {
        topic: "/joint_states",
        log_time: START + i,
        bytes: format!(
            r#"{{"tv_sec":{},"tv_usec":{},"slide":0.{i}}}"#,
            (998 + i) / 1000,
            (998 + i) % 1000 * 1000
        )
        .into_bytes(),
    };
    let sent: Vec<Sent> = (1..9).map(message).collect();
    let path = save(&file(WriteOptions::new(), Form::Json, &sent));
    let columns =
        "t=/joint_states.tv_sec [s] + /joint_states.tv_usec [us], x=/joint_states.slide [m]";
    let audit = read(&path, columns, &scene()).unwrap();
    assert_eq!(audit.error(), None);
    let timing = audit.report().timing.clone().unwrap();
    assert_eq!((timing.uneven, timing.missed_samples), (0, 0));
}
