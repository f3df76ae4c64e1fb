//! `passivity design`, `export` and `init`, scenes from a pipe, and `check --watch`.

mod cells;

use std::io::{BufRead as _, BufReader, Write as _};
use std::process::{Command, Stdio};

use crate::harness::{Dir, shipped};

const RE35: &str = r#"
[device]
viscous = "9e-6 N m s/rad"
coulomb = "2e-3 N m"
[sampling]
period = "1 ms"
[encoder]
counts_per_revolution = 8192
[wall]
stiffness = "1 N m/rad"
[operator]
max_speed = "3 rad/s"
"#;

#[test]
fn a_cell_of_the_table_typed_into_the_scene_is_passive() {
    let dir = Dir::new();
    let scene = dir.write("re35.toml", RE35);
    let whole = dir.run(&["design", &scene, "--format", "json"]).json();
    assert_eq!(whole["stiffest"].as_array().map(Vec::len), Some(6));
    let run = dir.run(&[
        "design",
        &scene,
        "--format",
        "csv",
        "--rates",
        "4 ms,1 ms,0.3 ms",
        "--encoders",
        "100,8192,20000",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let mut cells = 0;
    for line in run.stdout.lines().skip(1) {
        let [rate, counts, stiffness, enough] = line.split(',').collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        let at = |stiffness: &str| {
            let text = RE35
                .replace("1 ms", rate)
                .replace("8192", counts)
                .replace("1 N m/rad", &format!("{stiffness} N m/rad"));
            dir.check(&text).text("verdict").to_owned()
        };
        assert_eq!(at(stiffness), "passive", "{line}");
        // The claim is exact: a thousandth more is not.
        let more = stiffness.parse::<f64>().expect("a number") * 1.001;
        assert_ne!(at(&more.to_string()), "passive", "{line}");
        assert_eq!(
            enough == "true",
            stiffness.parse::<f64>().expect("a number") >= 1.0
        );
        cells += 1;
    }
    assert_eq!(cells, 9);
}

#[test]
fn the_table_is_aligned_and_marks_what_is_enough() {
    let dir = Dir::new();
    let scene = dir.write("re35.toml", RE35);
    let args = [
        "design",
        &scene,
        "--rates",
        "1 kHz, 4 kHz",
        "--encoders",
        "8192, 14 bit",
    ];
    let run = dir.run(&args);
    let expected = "\
re35: the stiffest wall in N m/rad that is passive at every speed up to 3 rad/s
                8192 (now)     14 bit
  1 kHz (now)     1.0761 *   1.1981 *
        4 kHz     2.6723 *   3.5765 *
  * as stiff as the wall of the scene, 1 N m/rad, or stiffer; – no wall is passive
";
    assert_eq!(run.stdout, expected);
    let wrong = dir.run(&["design", &scene, "--rates", "1 mm"]);
    assert_eq!(wrong.code, 2);
    assert!(
        wrong
            .stderr
            .contains("`sampling.period` has the unit `mm` of a length"),
        "{}",
        wrong.stderr
    );
    for (flag, text, cause) in [
        (
            "--rates=0 Hz",
            "`sampling.rate` cannot be `0 Hz`",
            "above zero",
        ),
        (
            "--rates=-1 kHz",
            "`sampling.rate` cannot be `-1 kHz`",
            "above zero",
        ),
        (
            "--encoders=0.1 mm",
            "`0.1 mm`",
            "of another motion than the scene",
        ),
        ("--encoders=64 bit", "`64 bit`", "a whole number from 1 to"),
    ] {
        let wrong = dir.run(&["design", &scene, flag]);
        assert_eq!(wrong.code, 2, "{flag}");
        let said = &wrong.stderr;
        assert!(
            said.contains(text) && said.contains(cause),
            "{flag}: {said}"
        );
    }
}

#[test]
fn a_list_that_cannot_be_read_is_named() {
    let dir = Dir::new();
    let scene = dir.write("re35.toml", RE35);
    for option in ["--rates", "--encoders"] {
        let run = dir.run(&["design", &scene, option, "0 ?"]);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains(option), "{}", run.stderr);
    }
}

#[test]
fn the_table_of_a_scene_without_units_is_in_its_own_stiffness() {
    let dir = Dir::new();
    let scene = dir.write(
        "u.toml",
        "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n",
    );
    let text = dir.run(&["design", &scene]).stdout;
    assert!(
        text.contains("the stiffest wall in K that is passive"),
        "{text}"
    );
    assert!(
        text.contains("wall of the scene, 1 K, or stiffer"),
        "{text}"
    );
    let csv = dir.run(&["design", &scene, "--format", "csv"]).stdout;
    assert!(
        csv.starts_with("rate,encoder,stiffness [K],enough\n"),
        "{csv}"
    );
}

#[test]
fn constants_are_on_the_safe_side() {
    let dir = Dir::new();
    let scene = dir.write("re35.toml", RE35);
    let run = dir.run(&["export", &scene, "--for", "json"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let constants = run.json();
    // A file has the same document as standard output.
    let args = ["export", &scene, "--for", "json", "--out", "wall.json"];
    assert_eq!(dir.run(&args).code, 0);
    let written = std::fs::read_to_string(dir.path("wall.json")).expect("a document");
    let written: serde_json::Value = serde_json::from_str(&written).expect("JSON");
    assert_eq!(written, constants);
    for (key, unit, from) in [
        ("max_stiffness", "N m/rad", "stiffness = \"1 N m/rad\""),
        ("max_damping", "N m s/rad", "stiffness = \"1 N m/rad\""),
    ] {
        let value = constants[key].as_f64().expect("a number");
        // Every double is a decimal: all of its digits.
        let line = match key {
            "max_stiffness" => format!("stiffness = \"{value:.80} {unit}\""),
            _ => format!("{from}\ndamping = \"{value:.80} {unit}\""),
        };
        let checked = dir.check(&RE35.replace(from, &line));
        assert_eq!(checked.text("verdict"), "passive", "{line}");
    }
    let header = dir.run(&["export", &scene, "--for", "c", "--out", "wall.h"]);
    assert_eq!(header.code, 0, "{}", header.stderr);
    let text = std::fs::read_to_string(dir.path("wall.h")).expect("a header");
    assert!(
        text.contains(
            "#define RE35_MAX_STIFFNESS 1.0761 /* N m/rad, with RE35_DAMPING and under the conditions below */"
        ),
        "{text}"
    );
    assert!(text.contains("What binds: friction at 3 rad/s"), "{text}");
    #[cfg(target_os = "linux")]
    for verb in ["export re35.toml --for c", "init joints"] {
        // No more than 512 or 1024 bytes fit into a file, by shell: nothing is left that stands in the way.
        let binary = env!("CARGO_BIN_EXE_passivity");
        let script = format!("trap '' XFSZ; ulimit -f 1; exec '{binary}' {verb} --out half");
        let output = std::process::Command::new("sh")
            .args(["-c", &script])
            .current_dir(dir.path(""))
            .output();
        assert_eq!(output.expect("a shell").status.code(), Some(2), "{verb}");
        assert!(!dir.path("half").exists(), "{verb}");
    }
    // Nothing is overwritten.
    let again = dir.run(&["export", &scene, "--for", "c", "--out", "wall.h"]);
    assert_eq!(again.code, 2);
    assert!(
        again.stderr.contains("is there already"),
        "{}",
        again.stderr
    );
    let chai3d = dir.run(&["export", &scene, "--for", "chai3d"]);
    assert!(
        chai3d
            .stdout
            .contains("info.m_maxAngularStiffness = 1.0761;\ninfo.m_maxAngularDamping = 0.0;"),
        "{}",
        chai3d.stdout
    );
    // The library reads both fields: together they pass.
    let phantom = shipped()
        .into_iter()
        .find(|path| path.ends_with("phantom-premium.toml"))
        .and_then(|path| std::fs::read_to_string(path).ok())
        .expect("a scene");
    let scene_of_phantom = dir.write("phantom.toml", &phantom);
    let fields = dir
        .run(&["export", &scene_of_phantom, "--for", "chai3d"])
        .stdout;
    let field = |name: &str| -> f64 {
        let (_, rest) = fields.split_once(name).expect(name);
        let (value, _) = rest.split_once(';').expect("a value");
        value.parse().expect("a double")
    };
    let both = format!(
        "stiffness = \"{:.80} N/m\"\ndamping = \"{:.80} N s/m\"",
        field("info.m_maxLinearStiffness = "),
        field("info.m_maxLinearDamping = ")
    );
    let stiffness = phantom.lines().find(|line| line.starts_with("stiffness"));
    let typed = phantom.replace(stiffness.expect("a stiffness"), &both);
    assert_eq!(dir.check(&typed).text("verdict"), "passive", "{both}");
    let hd = dir.run(&["export", &scene, "--for", "openhaptics"]);
    assert!(
        hd.stdout.contains("hdSetSchedulerRate(1000);"),
        "{}",
        hd.stdout
    );
}

#[test]
fn a_header_compiles() {
    let own = "stiffness = \"1 N m/rad\"";
    let soft = "stiffness = \"0.001 N m/rad\"";
    let damping = "damping = \"1e-6 N m s/rad\"\ndamping_cutoff = \"50 Hz\"";
    let filtered = RE35.replace(own, &format!("{soft}\n{damping}"));
    let led = RE35.replace(own, soft) + "[controller]\nnumerator = [\"1.5\", \"-0.5\"]\n";
    for (text, also) in [
        (RE35, "RE35_ENCODER_RESOLUTION > 0"),
        (
            &filtered,
            "RE35_DAMPING_POLE < 1 && RE35_DAMPING_TIME_CONSTANT > 0",
        ),
        (&led, "numerator[0] > 1 && numerator[1] < 0"),
    ] {
        compiles(text, also);
    }
}

/// Compiles the header of a scene, and runs a program with it that asks whether something is so.
#[track_caller]
fn compiles(text: &str, also: &str) {
    let dir = Dir::new();
    let scene = dir.write("re35.toml", text);
    let run = dir.run(&["export", &scene, "--for", "c", "--out", "wall.h"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let numerator = match also.contains("numerator") {
        true => "static const double numerator[] = RE35_CONTROLLER_NUMERATOR;\n",
        false => "",
    };
    dir.write(
        "main.c",
        format!(
            "#include \"wall.h\"\n{numerator}int main(void) {{ return RE35_STIFFNESS <= RE35_MAX_STIFFNESS && {also} ? 0 : 1; }}\n"
        ),
    );
    let compiled = Command::new("cc")
        .args(["-Wall", "-Werror", "-o", "main", "main.c"])
        .current_dir(dir.path(""))
        .status()
        .expect("a C compiler");
    assert!(compiled.success());
    let status = Command::new(dir.path("main"))
        .status()
        .expect("the program");
    assert!(status.success());
}

#[test]
fn a_scene_is_begun_and_checked_through_a_pipe() {
    let dir = Dir::new();
    for kind in ["rotary", "linear", "joints", "dimensionless"] {
        let begun = dir.run(&["init", kind]);
        assert_eq!(begun.code, 0, "{}", begun.stderr);
        let mut check = Command::new(env!("CARGO_BIN_EXE_passivity"))
            .args(["check", "-"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the command starts");
        let mut stdin = check.stdin.take().expect("a pipe");
        stdin.write_all(begun.stdout.as_bytes()).expect("written");
        drop(stdin);
        let output = check.wait_with_output().expect("it ends");
        let text = String::from_utf8(output.stdout).expect("UTF-8");
        assert!(text.starts_with("standard input: PASSIVE"), "{text}");
    }
    let out = ["init", "rotary", "--out", "mine.toml"];
    assert_eq!(dir.run(&out).code, 0);
    assert_eq!(dir.run(&out).code, 2);
}

#[test]
fn a_saved_scene_is_checked_again() {
    let dir = Dir::new();
    let scene = dir.write("re35.toml", RE35);
    let mut watch = Command::new(env!("CARGO_BIN_EXE_passivity"))
        .args(["check", "--watch", &scene])
        .current_dir(dir.path(""))
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    let mut lines = BufReader::new(watch.stdout.take().expect("a pipe")).lines();
    let mut headline = || {
        lines
            .by_ref()
            .map(|line| line.expect("UTF-8"))
            .find(|line| line.starts_with("re35:"))
            .expect("a verdict")
    };
    assert_eq!(headline(), "re35: PASSIVE at every speed up to 3 rad/s");
    dir.write("re35.toml", RE35.replace("3 rad/s", "4 rad/s "));
    assert!(headline().starts_with("re35: NOT PASSIVE"));
    watch.kill().expect("it runs");
    watch.wait().expect("it ends");
}

#[test]
fn diagnostics_keep_to_ascii_and_to_no_colour_where_that_is_asked_for() {
    let dir = Dir::new();
    let scene = dir.write("bad.toml", RE35.replace("1 ms", "1 mm"));
    let stderr = |variables: &[(&str, &str)]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_passivity"));
        for name in ["LC_ALL", "LC_CTYPE", "LANG", "NO_COLOR", "TERM"] {
            command.env_remove(name);
        }
        command.envs(variables.iter().copied());
        let output = command
            .args(["check", &scene])
            .current_dir(dir.path(""))
            .output()
            .expect("the command starts");
        String::from_utf8(output.stderr).expect("UTF-8")
    };
    for variables in [
        [("LC_ALL", "C")].as_slice(),
        &[("LANG", "de_DE.ISO-8859-1")],
        &[("TERM", "dumb")],
    ] {
        let text = stderr(variables);
        assert!(text.is_ascii(), "{variables:?}: {text}");
        assert!(text.contains("has the unit `mm` of a length"), "{text}");
    }
    let text = stderr(&[("LANG", "en_US.UTF-8")]);
    assert!(text.contains('╭') && !text.contains('\u{1b}'), "{text}");
}

#[test]
fn a_largest_wall_past_all_doubles_is_not_taken_for_none() {
    let dir = Dir::new();
    let text = "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"1e400 N m\"\n[sampling]\nrate = \"1 kHz\"\n\
                [encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"1 N m/rad\"\n\
                [operator]\nmax_speed = \"3 rad/s\"\n";
    let scene = dir.write("huge.toml", text);
    for (program, expected) in [
        (
            "c",
            "HUGE_MAX_STIFFNESS: no double is known for it, though the scene's wall is passive",
        ),
        (
            "chai3d",
            "info.m_maxAngularStiffness = 1.0; /* the scene's; the largest: no double is known",
        ),
        ("openhaptics", "kMaxStiffness: no double is known for it"),
    ] {
        let run = dir.run(&["export", &scene, "--for", program]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert!(run.stdout.contains(expected), "{}", run.stdout);
        assert!(!run.stdout.contains("no wall is passive"), "{}", run.stdout);
    }
}
