//! Input that is meant to hurt: bounded work, one clear error, never a panic.
//!
//! A program of its own: it measures by the clock, beside nothing else.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use passivity_scene::check::check;
use passivity_scene::parse::{MAX_BYTES, MAX_NUMBER_CHARS, MAX_NUMBER_EXPONENT};
use passivity_scene::{Scene, SceneError};

/// What no input may take, however slow the machine.
const LIMIT: Duration = Duration::from_secs(1);

fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("hostile");
    fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

fn read(bytes: &[u8], name: &str) -> Result<Scene, SceneError> {
    let path = scratch(name);
    fs::write(&path, bytes).unwrap();
    let attempt = || {
        let start = Instant::now();
        let scene = Scene::read(&path);
        if let Err(error) = &scene {
            // An error is worth nothing when showing it hangs.
            assert!(error.render(false).len() < 200_000);
            assert!(error.to_string().len() < 100_000);
        }
        (scene, start.elapsed())
    };
    let (scene, mut taken) = attempt();
    for _ in 0..5 {
        // Slow input is slow every time, a busy machine is not.
        if taken > LIMIT / 2 {
            taken = taken.min(attempt().1);
        }
    }
    assert!(taken < LIMIT, "{name}: {taken:?}");
    scene
}

fn kind(bytes: &[u8], name: &str) -> &'static str {
    read(bytes, name).expect_err(name).diagnostics()[0]
        .kind()
        .name()
}

#[test]
fn what_is_no_file_is_refused() {
    let missing = Scene::read(scratch("missing.toml")).unwrap_err();
    assert_eq!(missing.diagnostics()[0].kind().name(), "unreadable");
    assert!(
        missing
            .to_string()
            .contains("missing.toml: there is no such file")
    );
    let folder = Scene::read(scratch("x").parent().unwrap()).unwrap_err();
    assert_eq!(folder.diagnostics()[0].kind().name(), "not_a_file");
    assert!(folder.render(false).contains("this is a folder"));
    #[cfg(unix)]
    for device in ["/dev/zero", "/dev/null", "/dev/stdin"] {
        // What stands behind the standard input is up to who runs the test.
        let refused = Scene::read(device).unwrap_err();
        let kind = refused.diagnostics()[0].kind().name();
        assert!(
            kind == "not_a_file" || device == "/dev/stdin",
            "{device}: {kind}"
        );
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_is_refused_without_waiting_for_a_writer() {
    let path = scratch("pipe.toml");
    let _ = fs::remove_file(&path);
    let made = std::process::Command::new("mkfifo").arg(&path).status();
    assert!(made.unwrap().success());
    let start = Instant::now();
    let error = Scene::read(&path).unwrap_err();
    assert_eq!(error.diagnostics()[0].kind().name(), "not_a_file");
    assert!(start.elapsed() < LIMIT);
}

#[test]
fn large_files_are_refused_by_size() {
    let most = usize::try_from(MAX_BYTES).unwrap();
    assert_eq!(kind(&vec![b'#'; most + 1], "large.toml"), "file_too_large");
    assert_eq!(kind(&vec![b'#'; most], "full.toml"), "missing_key");
    let text = "#".repeat(most + 1);
    let error = Scene::from_toml("large", &text).unwrap_err();
    assert_eq!(error.diagnostics()[0].kind().name(), "file_too_large");
}

#[test]
fn bytes_that_are_no_text_are_shown_with_their_line() {
    let error = read(b"[device]\nviscous = \"1 \xff\"\n", "latin1.toml").unwrap_err();
    let first = &error.diagnostics()[0];
    assert_eq!(first.kind().name(), "not_utf8");
    assert_eq!((first.line(), first.column()), (Some(2), Some(14)));
    assert!(error.to_string().contains("this byte is not UTF-8"));
    for bytes in [
        &b"\0"[..],
        b"\xff\xfe[\0d\0",
        b"[device]\n\0\n",
        b"a = \"\0\"",
    ] {
        assert!(
            read(bytes, "binary.toml").unwrap_err().diagnostics()[0]
                .line()
                .is_some()
        );
    }
}

#[test]
fn depth_is_bounded() {
    let most = usize::try_from(MAX_BYTES).unwrap() - 10;
    let deep = [
        format!("a = {}", "[".repeat(most)),
        format!("a = {}", "{a=".repeat(most / 3)),
        format!("{}x = 1", "a.".repeat(most / 2)),
        format!("[{}x]", "a.".repeat(most / 2 - 1)),
        format!(
            "[wall]\nstiffness = {{{}x = 1}}",
            "a.".repeat(most / 2 - 20)
        ),
        format!("{}\n", "[".repeat(most)),
    ];
    for text in deep {
        assert!(
            read(text.as_bytes(), "deep.toml")
                .unwrap_err()
                .diagnostics()[0]
                .line()
                .is_some()
        );
    }
}

#[test]
fn many_keys_and_sections_are_bounded() {
    let numbered = |form: fn(usize) -> String| (0..9000).map(form).collect::<String>();
    let many = [
        numbered(|i| format!("[s{i}]\n")),
        numbered(|i| format!("k{i} = 1\n")),
        format!(
            "[wall]\n{}",
            numbered(|i| format!("\"stiffness{i}\" = 1\n"))
        ),
        format!("[wall]\n{}", numbered(|i| format!("k{i}.x = 1\n"))),
        "[wall]\n".repeat(30_000),
        "[[wall]]\n".repeat(25_000),
        format!("wall = {{ {} }}", numbered(|i| format!("k{i} = 1, "))),
    ];
    for text in many {
        let error = read(text.as_bytes(), "many.toml").unwrap_err();
        assert!(error.diagnostics().len() <= passivity_scene::diagnostic::MAX_DIAGNOSTICS);
        assert!(error.diagnostics()[0].line().is_some());
    }
}

#[test]
fn long_numbers_and_units_are_refused_before_they_cost() {
    let scene =
        |value: &str| format!("[wall]\nstiffness = \"{value}\"\n[sampling]\nrate = \"1 kHz\"\n");
    let digits = "9".repeat(200_000);
    let units = "N m ".repeat(50_000);
    let cases = [
        (format!("{digits} N/m"), "number_too_long"),
        (format!("1/{digits} N/m"), "number_too_long"),
        (format!("0.{digits} N/m"), "number_too_long"),
        (format!("1e{digits} N/m"), "number_too_long"),
        (
            format!("1e{} N/m", MAX_NUMBER_EXPONENT + 1),
            "exponent_too_large",
        ),
        (format!("1e-{} N/m", "9".repeat(400)), "exponent_too_large"),
        (format!("1 N/m ± {digits}"), "number_too_long"),
        ("1 N/m ± 1e99999%".to_owned(), "exponent_too_large"),
        (format!("1 {units}"), "malformed_unit"),
        (format!("1 {}N", "(".repeat(199)), "malformed_unit"),
        (format!("1 m^{}", "9".repeat(150)), "malformed_unit"),
        (format!("1 {}", "é".repeat(100_000)), "malformed_unit"),
        (" ".repeat(200_000), "empty_number"),
        ("±".repeat(100_000), "malformed_number"),
        (format!("1 N/m {}", "±".repeat(100_000)), "malformed_number"),
    ];
    for (value, expected) in cases {
        let shown: String = value.chars().take(20).collect();
        assert_eq!(
            kind(scene(&value).as_bytes(), "long.toml"),
            expected,
            "{shown}"
        );
    }
    let bare = format!("[dimensionless]\nbeta = {digits}\n");
    assert!(read(bare.as_bytes(), "bare.toml").is_err());
    let bare = format!("[dimensionless]\nbeta = 0.{digits}\n");
    assert_eq!(kind(bare.as_bytes(), "bare.toml"), "number_too_long");
    let counts = format!(
        "[encoder]\ncounts_per_revolution = \"{digits}\"\n{}",
        scene("1 N m/rad")
    );
    assert_eq!(kind(counts.as_bytes(), "counts.toml"), "number_too_long");
}

#[test]
fn the_longest_numbers_that_are_read_still_give_a_verdict() {
    let number = |seed: usize| {
        let digit = |i: usize| char::from(b'1' + u8::try_from((i * i * 7 + i * seed) % 9).unwrap());
        (0..MAX_NUMBER_CHARS - 8).map(digit).collect::<String>()
    };
    let text = format!(
        "[device]\nviscous = \"0.{} N s/m\"\ncoulomb = \"0.{} N\"\ninertia = \"0.{} kg\"\n\
         [sampling]\nperiod = \"0.{} s\"\n[encoder]\nresolution = \"0.{} m\"\n\
         [wall]\nstiffness = \"0.{} N/m\"\n",
        number(1),
        number(2),
        number(3),
        number(4),
        number(5),
        number(6),
    );
    let scene = read(text.as_bytes(), "longest.toml").unwrap_or_else(|e| panic!("{e}"));
    let attempts = [0; 2].map(|_| {
        let start = Instant::now();
        let report = check(&scene);
        assert!(report.spare.viscous.is_point() && report.spare.coulomb.is_point());
        start.elapsed()
    });
    assert!(attempts.into_iter().min() < Some(LIMIT), "{attempts:?}");
}

#[test]
fn a_file_of_forces_is_bounded_and_told_by_line() {
    let scene = |force: &str| {
        format!(
            "[wall]\nstiffness = \"1 N/mm\"\n[sampling]\nrate = \"1 kHz\"\n\
             [operator]\nforce = {force}\n"
        )
    };
    let cases = [
        ("1\n2.5\n-3/4\n", "\"f.csv\"", Ok(3)),
        (
            "t [s],f [mN]\n0,1\n0.001,2\n",
            "{ file = \"f.csv\" }",
            Ok(2),
        ),
        (
            "a,b [N]\n1,2\n",
            "{ file = \"f.csv\", column = \"b\" }",
            Ok(1),
        ),
        ("# forces\nf\n1\n", "\"f.csv\"", Ok(1)),
        ("", "\"f.csv\"", Err("there are no samples in it")),
        ("f\n", "\"f.csv\"", Err("there are no samples in it")),
        ("f\n1\nx\n", "\"f.csv\"", Err("line 3: expected a number")),
        (
            "f\n1\nnan\n",
            "\"f.csv\"",
            Err("line 3: `nan` is not a number"),
        ),
        (
            "f\n1,2\n3\n",
            "{ file = \"f.csv\", column = \"g\" }",
            Err("line 1: the header has no column `g`"),
        ),
        (
            "1,2\n",
            "\"f.csv\"",
            Err("line 1: expected a header with a column `f`"),
        ),
        ("f [N m]\n1\n", "\"f.csv\"", Err("is rotary")),
        (
            "f [kg]\n1\n",
            "\"f.csv\"",
            Err("not one of force or torque"),
        ),
        ("f [N\n1\n", "\"f.csv\"", Err("closing `]`")),
        ("f\n\u{0}\n", "\"f.csv\"", Err("line 2")),
    ];
    for (samples, force, expected) in cases {
        fs::write(scratch("f.csv"), samples).unwrap();
        match (read(scene(force).as_bytes(), "forces.toml"), expected) {
            (Ok(scene), Ok(len)) => assert_eq!(scene.point().forces.unwrap().len(), len),
            (Err(error), Err(part)) => {
                assert!(error.to_string().contains(part), "{samples:?}: {error}");
            }
            (found, _) => panic!("{samples:?}: {found:?}"),
        }
    }
    fs::write(scratch("f.csv"), b"f\n1\n\xff\n").unwrap();
    let error = read(scene("\"f.csv\"").as_bytes(), "forces.toml").unwrap_err();
    assert!(
        error
            .to_string()
            .contains("line 3: this is not CSV in UTF-8"),
        "{error}"
    );
    for (path, part) in [
        ("\"none.csv\"", "there is no such file"),
        ("{ file = \"/dev/zero\" }", "this is a pipe or a device"),
        ("{ file = \".\" }", "this is a folder"),
        ("{ file = \"\\u0000\" }", "the file cannot be read"),
    ] {
        let error = read(scene(path).as_bytes(), "forces.toml").unwrap_err();
        assert!(error.to_string().contains(part), "{path}: {error}");
    }
    let endless = "1\n".repeat(passivity_scene::parse::MAX_SAMPLES + 1);
    fs::write(scratch("endless.csv"), endless).unwrap();
    let error = Scene::read(forces_scene(&scene("\"endless.csv\""))).unwrap_err();
    assert!(
        error.to_string().contains("more than 500000 samples"),
        "{error}"
    );
    fs::write(scratch("huge.csv"), vec![b'1'; 9 << 20]).unwrap();
    let error = Scene::read(forces_scene(&scene("\"huge.csv\""))).unwrap_err();
    assert!(
        error.to_string().contains("the file is too large"),
        "{error}"
    );
}

fn forces_scene(text: &str) -> PathBuf {
    let path = scratch("forces-large.toml");
    fs::write(&path, text).unwrap();
    path
}
