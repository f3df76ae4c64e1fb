//! Which clock is proposed: that of the messages, or that of the recorder.

use mcap::WriteOptions;
use passivity_audit::{Options, audit};

use super::write::{Form, Sent, file};
use super::{START, motion, save, scene};

#[test]
fn the_clock_of_a_message_goes_before_that_of_the_recorder() {
    let proposed = |own: &str, other: &str| {
        let mut sent = Vec::new();
        for (stamp, x, f) in motion() {
            let seconds = (stamp - START) as f64 / 1e9;
            let json = |topic, fields: String| Sent {
                topic,
                log_time: stamp + 100,
                bytes: format!("{{{fields}}}").into_bytes(),
            };
            let clock = |name: &str| match name {
                "" => String::new(),
                name => format!("\"{name}\":{seconds:?},"),
            };
            sent.push(json("/wrench", format!("{}\"force\":{f:?}", clock(other))));
            sent.push(json("/joint", format!("{}\"position\":{x:?}", clock(own))));
        }
        let path = save(&file(WriteOptions::new(), Form::Json, &sent));
        let error = audit(&path, &scene(), Options::default()).unwrap_err();
        *error.proposal.unwrap()
    };
    let recorder = ["/joint.log_time [ns]", "/joint.publish_time [ns]"];
    for own in ["timestamp", "t", "time", "stamp", "device_time"] {
        for other in ["", "time", "stamp_ns"] {
            let found = proposed(own, other);
            let clock = format!("t=/joint.{own} [s], x=/joint.position [m]");
            assert!(found.columns.starts_with(&clock), "{}", found.columns);
            let is_named = |name: &&str| found.others.contains(&(*name).to_owned());
            assert!(recorder.iter().all(is_named), "{:?}", found.others);
        }
    }
    // Where the messages have none, it is the recorder's.
    let found = proposed("", "time");
    let clock = format!("t={}, x=/joint.position [m]", recorder[0]);
    assert!(found.columns.starts_with(&clock), "{}", found.columns);
}
