//! What a command reads, by name, by a link or as standard input, is not written over by it.

use std::process::Command;

use super::{files, folder, refused};

#[test]
fn what_is_read_is_not_written_over() {
    let dir = folder();
    let plane = "plane device.toml --axes stiffness,damping";
    let read = "is read by this";
    refused(&dir, &format!("{plane} --out device.toml"), read);
    refused(
        &dir,
        &format!("{plane} --measured bench.csv --out bench.csv"),
        read,
    );
    for verb in [
        "simulate forced.toml --speed 1",
        "sweep forced.toml --beta 1 --sigma 1 --speed 1",
        "audit log.csv --scene forced.toml",
    ] {
        for file in ["forces.csv", "./forces.csv"] {
            refused(&dir, &format!("{verb} --out {file}"), read);
        }
    }
    refused(&dir, "check forced.toml --certificate forces.csv", read);
    refused(
        &dir,
        "audit log.tmp --scene scene.toml --partial log.tmp",
        read,
    );
    // Beside an input whose name was that of a file on the way.
    let run = dir.run(&[
        "audit",
        "log.tmp",
        "--scene",
        "scene.toml",
        "--partial",
        "log",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(
        std::fs::read(dir.path("log.tmp")).unwrap(),
        b"count\n0\n1\n0\n"
    );
}

#[cfg(unix)]
#[test]
fn what_is_read_as_standard_input_is_not_written_over() {
    let dir = folder();
    std::fs::hard_link(dir.path("log.csv"), dir.path("hard.csv")).unwrap();
    for (command, input) in [
        ("audit - --scene scene.toml --out log.csv", "log.csv"),
        ("audit - --scene scene.toml --out hard.csv", "log.csv"),
        ("audit log.csv --scene - --out scene.toml", "scene.toml"),
        ("check - --certificate scene.toml", "scene.toml"),
        (
            "simulate - --speed 1 --intervals 9 --out scene.toml",
            "scene.toml",
        ),
    ] {
        let before = files(&dir);
        let run = |command: &str| {
            Command::new(env!("CARGO_BIN_EXE_passivity"))
                .args(command.split_whitespace())
                .current_dir(dir.path(""))
                .stdin(std::fs::File::open(dir.path(input)).unwrap())
                .output()
                .unwrap()
        };
        let refused = run(command);
        assert_eq!(refused.status.code(), Some(2), "{command}");
        let says = String::from_utf8(refused.stderr).unwrap();
        assert!(says.contains("is read by this"), "{command}: {says}");
        assert!(files(&dir) == before, "{command}: the files are others");
        // Another file is written.
        let (command, _) = command.rsplit_once(' ').unwrap();
        assert!(run(&format!("{command} other")).status.code() < Some(2));
        std::fs::remove_file(dir.path("other")).unwrap();
    }
}

#[cfg(unix)]
#[test]
fn links_lead_to_no_file_that_is_written() {
    use std::os::unix::fs::symlink;
    let dir = folder();
    dir.write("kept.txt", "kept");
    for link in ["link.csv", "link.svg", "part.tmp"] {
        symlink("kept.txt", dir.path(link)).unwrap();
    }
    symlink("kept.txt", dir.path("rows.tmp")).unwrap();
    for (name, of) in [("hard.csv", "log.csv"), ("hard.toml", "scene.toml")] {
        std::fs::hard_link(dir.path(of), dir.path(name)).unwrap();
    }
    let (read, link) = ("is read by this", "is a symbolic link");
    let audit = "audit log.csv --scene scene.toml";
    refused(&dir, &format!("{audit} --out hard.csv"), read);
    refused(&dir, &format!("{audit} --partial hard.toml"), read);
    refused(&dir, "simulate scene.toml --speed 1 --out hard.toml", read);
    refused(&dir, "explain device.toml --plot link.svg", link);
    refused(&dir, "accuracy scene.toml --speed 1 --plot link.svg", link);
    refused(&dir, "plane device.toml --plot link.svg", link);
    refused(
        &dir,
        "plane device.toml --axes stiffness,damping --out link.csv",
        link,
    );
    // Where a file on the way was written through a link.
    let sweep = "sweep scene.toml --beta 1 --sigma 1 --speed 1 --intervals 9 --out rows";
    for command in [&format!("{audit} --partial part"), sweep] {
        let run = dir.run(&command.split_whitespace().collect::<Vec<_>>());
        assert_eq!(run.code, 0, "{}", run.stderr);
    }
    assert_eq!(std::fs::read(dir.path("kept.txt")).unwrap(), b"kept");
}
