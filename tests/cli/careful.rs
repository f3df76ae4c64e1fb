//! What every command takes care of: names that move the cursor, files of others, and how many threads are asked for.

use crate::harness::Dir;
use crate::logs::SCENE;

#[test]
fn names_never_move_the_cursor_or_turn_the_text_around() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    let hidden = "\u{1b}[2J\u{202e}\u{9b}31m\u{2066}";
    let named = format!("log{}.csv", "\u{202e}");
    for (name, text) in [
        ("log.csv", format!("x{hidden} [rad],time\n0,0\n1,1\n")),
        (
            "log.csv",
            format!("x [rad],note{hidden}\n0,{hidden}\n{hidden},0\n"),
        ),
        ("log.csv", format!("position{hidden},time\n0,0\n1,1\n")),
        (&named, "count\n1\nx\n".to_owned()),
    ] {
        dir.write(name, text);
        for format in ["text", "json"] {
            let run = dir.run(&["audit", name, "--scene", "scene.toml", "--format", format]);
            for said in [run.stdout, run.stderr] {
                let bad = |c: char| c != '\n' && (c.is_control() || "\u{202e}\u{2066}".contains(c));
                assert!(!said.contains(bad), "{said:?}");
            }
        }
    }
    // Nor in a scene, or in its name.
    let scene =
        format!("[device]\nviscous{hidden} = \"1\"\n[wall{hidden}]\nstiffness = \"{hidden}\"\n");
    for name in ["scene.toml", "scene\u{202e}.toml"] {
        dir.write(name, &scene);
        for verb in ["check", "explain"] {
            let run = dir.run(&[verb, name]);
            assert_eq!(run.code, 2);
            let bad = |c: char| c != '\n' && (c.is_control() || "\u{202e}\u{2066}".contains(c));
            assert!(!run.stderr.contains(bad), "{verb} {name}: {:?}", run.stderr);
        }
    }
    dir.write("good\u{202e}.toml", SCENE);
    for format in ["text", "json"] {
        let run = dir.run(&["check", "good\u{202e}.toml", "--format", format]);
        assert!(!run.stdout.contains('\u{202e}'), "{}", run.stdout);
    }
}

#[test]
fn what_was_typed_never_moves_the_cursor_either() {
    let dir = Dir::new();
    let hidden = "x\u{202e}\u{1b}[31m\u{2066}";
    for args in [
        &[hidden][..],
        &["check", "--format", hidden, "scene.toml"],
        &[
            "audit",
            "log.csv",
            "--scene",
            "scene.toml",
            &format!("--{hidden}"),
        ],
        &["man", hidden],
    ] {
        let run = dir.run(args);
        assert_eq!(run.code, 2, "{args:?}");
        let bad = |c: char| c != '\n' && (c.is_control() || "\u{202e}\u{2066}".contains(c));
        assert!(!run.stderr.contains(bad), "{:?}", run.stderr);
        assert!(run.stderr.contains("\\u{202e}"), "{:?}", run.stderr);
    }
}

#[cfg(unix)]
#[test]
fn a_title_has_no_character_that_xml_refuses() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    dir.write("log\u{1b}[2J.csv", "count\n0\n1\n0\n");
    for picture in ["energy.svg", "energy.png"] {
        let args = [
            "audit",
            "log\u{1b}[2J.csv",
            "--scene",
            "scene.toml",
            "--plot",
            picture,
        ];
        assert_eq!(dir.run(&args).code, 0);
    }
    let svg = std::fs::read_to_string(dir.path("energy.svg")).unwrap();
    assert!(svg.contains("log\\u{1b}[2J.csv"), "{svg}");
    assert!(!svg.contains(|c: char| c.is_control() && c != '\n'));
}

#[cfg(unix)]
#[test]
fn nothing_but_a_plain_file_is_replaced() {
    use std::os::unix::fs::{FileTypeExt as _, symlink};
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    dir.write("log.csv", "count\n0\n1\n0\n");
    dir.write("other.txt", "kept");
    symlink(dir.path("other.txt"), dir.path("link.csv")).unwrap();
    std::fs::create_dir(dir.path("folder")).unwrap();
    for (option, file, says) in [
        ("--out", "/dev/null", "is no plain file"),
        ("--out", "link.csv", "is a symbolic link"),
        ("--plot", "link.csv", "is a symbolic link"),
        ("--certificate", "/dev/full", "is no plain file"),
        ("--out", "folder", "is no plain file"),
        ("--out", "-", "is not standard output here"),
        ("--out", "scene.toml", "is read by this audit"),
        ("--out", "./log.csv", "is read by this audit"),
    ] {
        let run = dir.run(&["audit", "log.csv", "--scene", "scene.toml", option, file]);
        assert_eq!(run.code, 2, "{file}: {}", run.stdout);
        assert!(run.stderr.contains(says), "{file}: {}", run.stderr);
    }
    let simulate = ["simulate", "scene.toml", "--speed", "1", "--intervals", "3"];
    let sweep = [
        "sweep",
        "scene.toml",
        "--beta",
        "1",
        "--sigma",
        "1",
        "--speed",
        "1",
        "--intervals",
        "3",
    ];
    for (verb, args) in [("simulation", &simulate[..]), ("sweep", &sweep[..])] {
        for (file, says) in [
            ("/dev/null", "is no plain file"),
            ("-", "is not standard output here"),
            ("link.csv", "is a symbolic link"),
            ("scene.toml", &format!("is read by this {verb}")),
        ] {
            let run = dir.run(&[args, &["--out", file]].concat());
            assert_eq!(run.code, 2, "{verb} {file}: {}", run.stdout);
            assert!(run.stderr.contains(says), "{verb} {file}: {}", run.stderr);
        }
    }
    assert_eq!(
        std::fs::read_to_string(dir.path("other.txt")).unwrap(),
        "kept"
    );
    assert_eq!(
        std::fs::read_to_string(dir.path("scene.toml")).unwrap(),
        SCENE
    );
    assert!(
        std::fs::metadata("/dev/null")
            .unwrap()
            .file_type()
            .is_char_device()
    );
}

#[test]
fn threads_are_bounded() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    dir.write("log.csv", "count\n0\n1\n0\n");
    for (threads, code) in [("1", 0), ("1024", 0), ("1025", 2), ("65536", 2), ("-1", 2)] {
        let run = dir.run(&[
            "audit",
            "log.csv",
            "--scene",
            "scene.toml",
            &format!("--threads={threads}"),
        ]);
        assert_eq!(
            run.code.min(2),
            code,
            "{threads}: {}{}",
            run.stdout,
            run.stderr
        );
    }
}
