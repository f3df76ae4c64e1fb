//! MCAP logs that are cut short, changed, incomplete or in an encoding that is not read.

use std::collections::BTreeMap;
use std::io::Cursor;

use mcap::{WriteOptions, Writer};
use passivity_audit::{
    Dialect, Options, Stretch, TraceError, Verdict, audit, audit_csv, audit_files, audit_part,
};

use super::write::{Form, Sent, file, put};
use super::{COLUMNS, START, Scratch, csv, dialect, read, save, scene, sent};

#[test]
fn a_file_out_of_order_is_refused_where_it_matters() {
    let mut sent = sent(Form::Cdr);
    sent[20].log_time = START;
    let path = save(&file(WriteOptions::new(), Form::Cdr, &sent));
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
}

const JOINT: &str = "t=/joint_states.log_time, x=/joint_states.position.slide [m], f=/joint_states.effort.slide [N]";

/// The error of the messages, of which the one that the fifth row is of has these bytes.
fn error_of(form: Form, columns: &str, at: usize, bytes: Vec<u8>) -> TraceError {
    let mut sent = sent(form);
    sent[at].bytes = bytes;
    let path = save(&file(WriteOptions::new(), form, &sent));
    let found = read(&path, columns, &scene()).unwrap();
    assert_eq!(found.verdict(), Verdict::Broken);
    let error = found.error().unwrap().clone();
    assert_eq!(
        (error.row, found.totals().intervals),
        (Some(5), 3),
        "{error}"
    );
    error
}

#[test]
fn what_is_missing_in_a_row_is_an_error_there() {
    let names = &["slide", "other"][..];
    let (no_position, no_effort) = ("/joint_states.position.slide", "/joint_states.effort.slide");
    for (names, position, effort, column, why) in [
        (
            names,
            &[0.0, 0.0][..],
            &[][..],
            no_effort,
            "a list of 0 there beside a list `name` of 2",
        ),
        (names, &[0.0, 0.0], &[f64::NAN, 0.0], no_effort, "NaN"),
        (
            names,
            &[],
            &[0.05, 0.0],
            no_position,
            "a list of 0 there beside a list `name` of 2",
        ),
        (
            names,
            &[0.0],
            &[0.05, 0.0],
            no_position,
            "a list of 1 there beside a list `name` of 2",
        ),
        (
            &["slide", "slide"],
            &[0.0, 0.0],
            &[0.05, 0.0],
            no_position,
            "no names of their own",
        ),
        // Of a force without a name nobody knows the joint.
        (
            &[],
            &[],
            &[0.05],
            no_effort,
            "a list of 1 there beside a list `name` of 0",
        ),
        (
            &["other"],
            &[0.0, 0.0],
            &[0.05],
            no_position,
            "beside a list `name` of 1",
        ),
    ] {
        for form in [Form::Cdr, Form::Ros1] {
            let bytes = form.joints(START + 4_000_000, names, position, effort);
            let error = error_of(form, JOINT, 9, bytes);
            assert_eq!(error.column.as_deref(), Some(column), "{error}");
            assert!(error.message.contains(why), "{error}");
        }
    }
    // A force that another joint has, whose position is not in the message.
    let columns = JOINT.replace("effort.slide", "effort.other");
    let bytes = Form::Cdr.joints(START + 4_000_000, &["other"], &[0.0], &[0.05]);
    let error = error_of(Form::Cdr, &columns, 9, bytes);
    assert!(error.message.contains("without the position"), "{error}");
}

#[test]
fn a_message_in_json_without_its_number_is_an_error() {
    let (x, f) = ("/joint_states.position.slide", "/wrench.wrench.force.x");
    let joints =
        |fields: &str| format!("{{\"header\":{{\"stamp\":{{\"sec\":1,\"nsec\":5}}}}{fields}}}");
    let wrench = |fields: &str| format!("{{\"wrench\":{fields}}}");
    for (at, bytes, column, why) in [
        (
            9,
            joints(r#","name":["slide"],"position":[null]"#),
            x,
            "has null there",
        ),
        (
            9,
            joints(r#","name":["slide"],"position":["NaN"]"#),
            x,
            "the text `NaN`",
        ),
        (
            9,
            joints(r#","name":["slide"],"position":null"#),
            x,
            "has null there",
        ),
        (9, joints(r#","name":["slide"]"#), x, "no such field"),
        (
            9,
            joints(r#","position":[0.0]"#),
            x,
            "no names of their own",
        ),
        (9, "5".to_owned(), x, "one number there"),
        (8, wrench(r#"{"force":{"x":null}}"#), f, "has null there"),
        (8, wrench(r#"{"force":{"x":"0.2"}}"#), f, "the text `0.2`"),
        (8, wrench(r#"{"force":{"x":true}}"#), f, "has true there"),
        (
            9,
            joints(r#","name":["slide"],"position":[false]"#),
            x,
            "has false there",
        ),
        (8, wrench(r#"{"force":{"y":0.0}}"#), f, "no such field"),
        (8, wrench(r#"{"force":[]}"#), f, "a list of 0 there"),
    ] {
        let error = error_of(Form::Json, COLUMNS, at, bytes.into_bytes());
        assert_eq!(error.column.as_deref(), Some(column), "{error}");
        let topic = column.split('.').next().unwrap();
        assert!(
            error.message.contains(why)
                && error.message.contains(&format!("on `{topic}` recorded at")),
            "{error}"
        );
    }
}

#[test]
fn a_message_in_json_with_a_field_twice_is_an_error() {
    let bytes = r#"{"wrench":{"force":{"x":0.2,"x":0.0}}}"#;
    let error = error_of(Form::Json, COLUMNS, 8, bytes.into());
    assert!(error.message.contains("it has a field twice"), "{error}");
}

/// A file with one message, in this encoding and with a schema of this name, encoding and text; without an encoding, none.
fn one_message(encoding: &str, (name, of, text): (&str, &str, &str), bytes: Vec<u8>) -> Scratch {
    let mut file = Cursor::new(Vec::new());
    let mut writer = Writer::new(&mut file).unwrap();
    let schema = match of {
        "" => 0,
        of => writer.add_schema(name, of, text.as_bytes()).unwrap(),
    };
    let channel = writer
        .add_channel(schema, "/arm", encoding, &BTreeMap::new())
        .unwrap();
    let message = Sent {
        topic: "/arm",
        log_time: START,
        bytes,
    };
    put(&mut writer, channel, 1, &message);
    writer.finish().unwrap();
    drop(writer);
    save(&file.into_inner())
}

#[test]
fn what_is_true_or_false_is_no_column() {
    let number = 0.5_f64.to_le_bytes();
    let cdr = [&[0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0][..], &number].concat();
    for (encoding, definitions, bytes) in [
        ("json", "", br#"{"on":true,"angle":0.5}"#.to_vec()),
        ("cdr", "ros2msg", cdr),
    ] {
        let schema = ("my/msg/Switch", definitions, "bool on\nfloat64 angle\n");
        let path = one_message(encoding, schema, bytes);
        let error = audit(&path, &scene(), Options::default()).unwrap_err();
        assert!(
            error.message.contains("`/arm.angle`") && !error.message.contains("/arm.on"),
            "{error}"
        );
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
        let path = one_message(encoding, ("x", definitions, ""), vec![1, 2, 3]);
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
        let path = save(&bytes.into_inner());
        let error = audit(&path, &scene(), Options::default()).unwrap_err();
        assert!(error.message.contains(why), "{error}");
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
            let path = save(&whole[..len]);
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
    let path = save(&changed);
    let found = read(&path, COLUMNS, &scene()).unwrap();
    let error = found.error().unwrap();
    assert!(error.message.contains("checksum"), "{error}");
    assert!(found.totals().intervals > 10);
}

#[test]
fn pieces_and_streams_are_refused() {
    let bytes = file(WriteOptions::new(), Form::Cdr, &sent(Form::Cdr));
    let path = save(&bytes);
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
    let csv = save(csv().as_bytes());
    let error = audit_files(
        &[csv.to_path_buf(), path.to_path_buf()],
        &scene(),
        options(),
    )
    .unwrap();
    assert!(
        error.error().unwrap().message.contains("goes on only"),
        "{:?}",
        error.error()
    );
}
