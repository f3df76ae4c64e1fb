//! Several logs in one command, of which not all have the same header.

use crate::harness::{Dir, Run, root};

/// A push with names that are not read, in a folder with the one that is shipped.
fn pushes(dir: &Dir) -> (String, String) {
    let shipped = root().join("scenes/identify/push.csv");
    let text = std::fs::read_to_string(&shipped).unwrap();
    let (_, rows) = text.split_once('\n').unwrap();
    let own = dir.write(
        "my push.csv",
        format!("Time (s),Encoder,Torque (Nm)\n{rows}"),
    );
    (shipped.display().to_string(), own)
}

const COLUMNS: &str = "t=Time (s), count=Encoder, f=Torque (Nm)";

fn identify(dir: &Dir, logs: &[&str], columns: Option<&str>) -> Run {
    let sketch = root()
        .join("scenes/identify/sketch.toml")
        .display()
        .to_string();
    let told = columns.map(|columns| ["--columns", columns]);
    let told: Vec<&str> = told.into_iter().flatten().collect();
    let words = ["identify", "--scene", &sketch, "--effort", "1"];
    dir.run(&[&words, logs, &told].concat())
}

#[test]
fn a_log_that_says_itself_what_its_columns_are_stands_beside_one_with_other_names() {
    let dir = Dir::new();
    let (shipped, own) = pushes(&dir);
    let run = identify(&dir, &[&shipped, &own], None);
    assert_eq!(run.code, 2, "{}", run.stdout);
    assert!(
        run.stderr.contains(&format!("--columns '{COLUMNS}'")),
        "{}",
        run.stderr
    );
    for logs in [[&*shipped, &*own], [&*own, &*shipped]] {
        let run = identify(&dir, &logs, Some(COLUMNS));
        assert_eq!(run.code, 0, "{}", run.stderr);
        let says = format!("{shipped}: its header has other names than --columns");
        assert!(run.stderr.contains(&says), "{}", run.stderr);
    }
    // It is read as it is: with commas, where the other has semicolons.
    let text = std::fs::read_to_string(dir.path(&own)).unwrap();
    let german = dir.write("german.csv", text.replace(',', ";").replace('.', ","));
    let words = [&*german, &shipped, "--delimiter", ";", "--decimal-comma"];
    let run = identify(&dir, &words, Some(COLUMNS));
    assert_eq!(run.code, 0, "{}", run.stderr);
}

#[test]
fn names_that_no_log_has_are_an_error_and_so_is_a_log_with_neither() {
    let dir = Dir::new();
    let (shipped, own) = pushes(&dir);
    let ramp = root()
        .join("scenes/identify/ramp.csv")
        .display()
        .to_string();
    let typo = COLUMNS.replace("Encoder", "Encodr");
    for logs in [&[&*shipped, &*ramp][..], &[&own], &[&own, &shipped]] {
        let run = identify(&dir, logs, Some(&typo));
        assert_eq!(run.code, 2, "{}", run.stdout);
        let says = format!("{}: there is no column `", logs[0]);
        assert!(run.stderr.contains(&says), "{}", run.stderr);
        assert!(run.stderr.contains(" run: "), "{}", run.stderr);
    }
    // A command for one would not read the other.
    let text = std::fs::read_to_string(dir.path(&own)).unwrap();
    let other = dir.write("other.csv", text.replace("Encoder", "enc"));
    let run = identify(&dir, &[&own, &other], Some(COLUMNS));
    assert_eq!(run.code, 2, "{}", run.stdout);
    assert!(
        run.stderr
            .contains(&format!("{other}: there is no column `Encoder`")),
        "{}",
        run.stderr
    );
    assert!(
        run.stderr.contains("must have the same names of columns"),
        "{}",
        run.stderr
    );
    assert!(!run.stderr.contains(" run: "), "{}", run.stderr);
}

#[test]
fn a_case_takes_logs_with_other_names() {
    let dir = Dir::new();
    let (_, own) = pushes(&dir);
    let sketch = root().join("scenes/identify/sketch.toml");
    let scene = std::fs::read_to_string(sketch).unwrap();
    let friction = "viscous = \"4e-5 N m s/rad\"\ncoulomb = \"1.5e-3 N m\"\n";
    let scene = dir.write(
        "scene.toml",
        scene.replace("[device]\n", &format!("[device]\n{friction}")),
    );
    let log = dir.write(
        "contact.csv",
        "t [s],count,f [N m]\n0,0,0\n0.001,0,0\n0.002,0,0\n",
    );
    let run = dir.run(&[
        "case",
        &scene,
        "--out",
        "case",
        "--device",
        "knob 3",
        "--date",
        "2026-11-20",
        "--effort",
        "1",
        "--log",
        &log,
        "--identification",
        &own,
        "--columns",
        COLUMNS,
    ]);
    assert!(run.code < 2, "{}", run.stderr);
    assert!(dir.path("case/case.html").exists());
    let check = dir.run(&["case", "--check", "case"]);
    assert_eq!(check.code, 0, "{}{}", check.stdout, check.stderr);
}
