//! Logs and sketches that `passivity identify` refuses.

use super::{identify, shipped};
use crate::harness::Dir;

#[test]
fn bad_input_is_refused_with_its_place() {
    let dir = Dir::new();
    let sketch = shipped("sketch.toml");
    let refused = |name: &str, log: &str, sketch: &str, word: &str| {
        let log = dir.write(name, log);
        let run = dir.run(&["identify", &log, "--scene", sketch, "--out", "out.toml"]);
        assert_eq!(run.code, 2, "{word}: {}", run.stderr);
        assert!(run.stderr.contains(word), "{word}: {}", run.stderr);
        assert!(!dir.path("out.toml").exists());
    };
    refused(
        "a.csv",
        "count\n0\n1\n",
        &sketch,
        "the force that was commanded is needed, and no column looks like one: name its column, as in `--columns \
         'count=count, f=NAME [N m]'`",
    );
    refused(
        "h.csv",
        "Zeit,Winkel\n0,0.1\n0.001,0.2\n0.002,0.4\n",
        &sketch,
        "`--columns 't=Zeit [s], x=Winkel [rad], f=NAME [N m]'`, or `--columns 't=Zeit [s], x=Winkel [deg], \
         f=NAME [N m]'` where positions are in deg\n",
    );
    refused(
        "q.csv",
        "time_s;it's count;drive\n0;1;0\n0.001;2;0\n",
        &sketch,
        "count=it'\\''s count, f=NAME [N m]'`, with `--delimiter ';'`\n",
    );
    // It is needed: what an audit would do without it is not said.
    let log = dir.write("j.csv", "t [s],count,f [N]\n0,0,0\n0.001,1,0.01\n");
    for more in [&[][..], &["--columns", "t=t [s], count=count, f=f [N]"]] {
        let run = dir.run(&[&["identify", &log, "--scene", &sketch], more].concat());
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains("such as `N m`"), "{}", run.stderr);
        assert!(!run.stderr.contains("wall's law"), "{}", run.stderr);
    }
    refused(
        "b.csv",
        "count,f [N m]\n0,1\n",
        &sketch,
        "at least two samples",
    );
    refused("c.csv", "count,f [N m]\n0,1\nx,1\n", &sketch, "row 2");
    refused(
        "d.csv",
        "count,f [N m]\n0,0\n9,0\n",
        &sketch,
        "d.csv: row 2: the device moves before there is a force",
    );
    let second = dir.write("second.csv", "count,f [N m]\n0,0\n0,0\n9,0\n");
    let run = dir.run(&[
        "identify",
        &shipped("push.csv"),
        &second,
        "--scene",
        &sketch,
    ]);
    let says = "second.csv: row 3: the device moves before there is a force";
    assert!(run.stderr.contains(says), "{}", run.stderr);
    assert!(!run.stderr.contains("log 2"), "{}", run.stderr);
    refused(
        "e.csv",
        "t [s],count,f [N m]\n0,0,1\n0,1,1\n",
        &sketch,
        "row 2",
    );
    refused(
        "f.csv",
        "pos [rad],torque [N m]\n0,1\n0.1,1\n",
        &sketch,
        "run: passivity identify f.csv",
    );
    let bare = dir.write(
        "bare.toml",
        "[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"1 N/m\"\n",
    );
    refused(
        "g.csv",
        "x [m],f [N]\n0,1\n0.1,1\n",
        &bare,
        "needs an [encoder]",
    );
    let out = dir.run(&["identify", "a.csv", "--scene", &bare, "--out", &bare]);
    assert_eq!(out.code, 2);
    assert!(
        out.stderr.contains("is read by this identification"),
        "{}",
        out.stderr
    );
    let lag = std::fs::read_to_string(&sketch).unwrap() + "[amplifier]\ntime_constant = \"1 ms\"\n";
    let lag = dir.write("lag.toml", lag);
    let run = dir.run(&["identify", &shipped("push.csv"), "--scene", &lag]);
    assert_eq!(run.code, 3, "{}", run.stderr);
}

#[test]
fn a_log_that_is_given_twice_is_refused() {
    let dir = Dir::new();
    let again = std::fs::read(shipped("push.csv")).unwrap();
    let again = dir.write("again.csv", again);
    let run = identify(&dir, "push.csv", &[&again]);
    assert_eq!(run.code, 2, "{}", run.stdout);
    let says = "again.csv: this is the same log as ";
    assert!(run.stderr.contains(says), "{}", run.stderr);
    assert!(
        run.stderr.ends_with("push.csv: give it once\n"),
        "{}",
        run.stderr
    );
}
