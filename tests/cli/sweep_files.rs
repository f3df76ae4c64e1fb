//! `passivity sweep`: its files, and those beside them.

use crate::harness::{Dir, Run};

/// Sweeps three points in a folder that has the scene.
fn sweep(dir: &Dir, more: &str) -> Run {
    let all = format!("sweep scene.toml --beta 1 --sigma 0,1/2,1 --speed 1 --format json {more}");
    dir.run(&all.split_whitespace().collect::<Vec<_>>())
}

fn folder() -> Dir {
    let dir = Dir::new();
    let text = "[dimensionless]\nmu = \"50\"\nbeta = \"1\"\nsigma = \"1\"\n[run]\nintervals = 99\n";
    dir.write("scene.toml", text);
    dir
}

fn read(dir: &Dir, name: &str) -> String {
    String::from_utf8_lossy(&std::fs::read(dir.path(name)).expect(name)).into_owned()
}

#[track_caller]
fn refused(run: &Run, says: &str) {
    assert_eq!(run.code, 2, "{}{}", run.stdout, run.stderr);
    assert!(run.stderr.contains(says), "{}", run.stderr);
}

#[test]
fn a_sweep_that_was_killed_before_its_first_row_goes_on() {
    let dir = folder();
    assert_eq!(sweep(&dir, "--out whole.csv").code, 0);
    for (out, journal) in [
        ("a.csv", "a.csv"),
        ("a.parquet", "a.parquet.rows"),
        ("b.csv --shard 1/1", "b.csv"),
    ] {
        for part in [
            "",
            "beta,sig",
            "beta,sigma,speed,paper,exact,at_interval,xi,velocity\n",
        ] {
            let _ = std::fs::remove_file(dir.path("a.parquet"));
            dir.write(journal, part);
            let run = sweep(&dir, &format!("--resume --out {out}"));
            assert_eq!(run.code, 0, "{}", run.stderr);
            assert_eq!(run.json()["simulated"], 3);
        }
    }
    assert_eq!(read(&dir, "a.csv"), read(&dir, "whole.csv"));
    // Any other text is not for this command to replace.
    dir.write("a.csv", "beta,sigma\n");
    refused(&sweep(&dir, "--resume --out a.csv"), "expected the header");
    assert_eq!(read(&dir, "a.csv"), "beta,sigma\n");
}

#[test]
fn a_merge_spares_a_sweep_that_was_not_finished() {
    let dir = folder();
    for part in ["1", "2"] {
        let run = sweep(&dir, &format!("--shard {part}/2 --out part-{part}.csv"));
        assert_eq!(run.code, 0, "{}", run.stderr);
    }
    for (out, journal) in [("a.csv", "a.csv"), ("a.parquet", "a.parquet.rows")] {
        dir.write(journal, "rows of hours");
        dir.write(&format!("{out}.run"), "passivity sweep 2\n");
        let run = sweep(&dir, &format!("--merge part-1.csv part-2.csv --out {out}"));
        refused(&run, "is of a sweep that was not finished");
        assert_eq!(read(&dir, journal), "rows of hours");
    }
}

#[test]
fn a_finished_shard_says_again_what_it_is() {
    let dir = folder();
    let shards = ["--shard 1/2 --out one.csv", "--shard 2/2 --out two.csv"];
    for shard in shards {
        assert_eq!(sweep(&dir, shard).code, 0);
    }
    let said = read(&dir, "one.csv.manifest");
    std::fs::remove_file(dir.path("one.csv.manifest")).expect("a manifest");
    let run = sweep(&dir, &format!("--resume {}", shards[0]));
    assert_eq!((run.code, &run.json()["simulated"]), (0, &0.into()));
    assert_eq!(read(&dir, "one.csv.manifest"), said);
    assert_eq!(sweep(&dir, "--merge one.csv two.csv --out all.csv").code, 0);
}

#[test]
fn a_merge_says_what_differs_and_which_file_is_missing() {
    let dir = folder();
    for part in ["1", "2"] {
        let run = sweep(&dir, &format!("--shard {part}/2 --out part-{part}.csv"));
        assert_eq!(run.code, 0, "{}", run.stderr);
    }
    let merge = "--merge part-1.csv part-2.csv --out all.csv";
    let differs = "`part-1.csv`: is a shard of a sweep with 99 intervals for each point, not 98";
    refused(&sweep(&dir, &format!("{merge} --intervals 98")), differs);
    // One that says nothing of its intervals is compared by its hashes alone.
    let said = read(&dir, "part-1.csv.manifest");
    let silent = said.replace("\"intervals\": 99, ", "");
    assert_ne!(silent, said);
    dir.write("part-1.csv.manifest", &silent);
    let differs = "of another scene or with another number of intervals";
    refused(&sweep(&dir, &format!("{merge} --intervals 98")), differs);
    assert_eq!(sweep(&dir, merge).code, 0);
    std::fs::remove_file(dir.path("part-2.csv.manifest")).expect("a manifest");
    let missing = "`part-2.csv`: is no finished shard, for `part-2.csv.manifest` is missing";
    refused(&sweep(&dir, merge), missing);
}

#[test]
fn a_shard_that_is_taken_up_as_another_says_which_one_it_is() {
    let dir = folder();
    for (is, asked, says) in [
        (
            "1/2",
            "",
            "is shard 1 of 2, not the whole sweep: give --shard 1/2, or another --out",
        ),
        (
            "1/2",
            "--shard 1/3",
            "is shard 1 of 2, not of 3: give --shard 1/2, or another --out",
        ),
        (
            "1/2",
            "--shard 3/3",
            "is shard 1 of 2, not shard 3 of 3: give --shard 1/2",
        ),
        (
            "2-3/3",
            "--shard 3/3",
            "is shards 2 to 3 of 3, not shard 3 of 3: give --shard 2-3/3",
        ),
        (
            "1/1",
            "--shard 1/2",
            "is the whole sweep, not shard 1 of 2: leave out --shard",
        ),
        (
            "1/1",
            "--intervals 98",
            "is a shard of a sweep with 99 intervals for each point, not 98: give another --out",
        ),
        (
            "1/2",
            "--shard 1/2 --intervals 98",
            "is a shard of a sweep with 99 intervals for each point, not 98",
        ),
    ] {
        for out in ["part.csv", "part.parquet"] {
            assert_eq!(sweep(&dir, &format!("--shard {is} --out {out}")).code, 0);
            let rows = read(&dir, out);
            refused(&sweep(&dir, &format!("--resume --out {out} {asked}")), says);
            assert_eq!(read(&dir, out), rows);
        }
    }
}

#[test]
fn a_shard_that_there_is_not_names_those_there_are() {
    let dir = folder();
    for (shard, says) in [
        ("2/1", "expected 1/1, the only piece"),
        (
            "0/3",
            "expected a piece from 1/3 to 3/3, or several in order, as in 1-2/3",
        ),
        ("three", "as in 3/8 for the third of eight pieces, or 3-5/8"),
    ] {
        refused(&sweep(&dir, &format!("--out x.csv --shard {shard}")), says);
    }
    let run = dir.run(&[
        "audit",
        "x.csv",
        "--scene",
        "scene.toml",
        "--partial",
        "p",
        "--shard",
        "2/1",
    ]);
    refused(
        &run,
        "from 1/8 to 8/8 or several in order, as in 3-5/8, found `2/1`",
    );
}

#[test]
fn no_file_beside_a_sweep_takes_the_name_of_what_is_read() {
    let dir = folder();
    let scene = read(&dir, "scene.toml");
    for (name, out) in [
        ("s.csv.run", "s.csv"),
        ("s.csv.manifest", "s.csv"),
        ("s.parquet.rows", "s.parquet"),
    ] {
        dir.write(name, &scene);
        let run = dir.run(&["sweep", name, "--beta", "1", "--sigma", "1", "--out", out]);
        refused(&run, &format!("{name}: is read by this sweep"));
        assert_eq!(read(&dir, name), scene);
    }
    for part in ["1", "2"] {
        let run = sweep(&dir, &format!("--shard {part}/2 --out part-{part}.csv"));
        assert_eq!(run.code, 0, "{}", run.stderr);
    }
    let merge = "--merge part-1.csv part-2.csv --out";
    refused(
        &sweep(&dir, &format!("{merge} part-1.csv.manifest")),
        "is read by this sweep",
    );
    assert_eq!(sweep(&dir, &format!("{merge} all.csv")).code, 0);
}

#[test]
fn values_that_a_row_cannot_tell_apart_are_refused() {
    let dir = folder();
    let sweep = |more: &str| {
        let all = format!("sweep scene.toml --out rows.csv {more}");
        dir.run(&all.split_whitespace().collect::<Vec<_>>())
    };
    for (ranges, says) in [
        ("--beta 1 --sigma 1 --speed 1,2,5,5", "`speed` has 5 twice"),
        ("--beta 1:1:3 --sigma 1", "`beta` has 1 twice"),
        ("--beta 1 --sigma 1e-400,0", "`sigma` has 0 twice"),
        ("--vary mu=1,2,1 --vary sigma=1", "`mu` has 1 twice"),
    ] {
        refused(&sweep(ranges), says);
        assert!(!dir.path("rows.csv").exists());
    }
}

#[test]
fn no_file_of_others_is_lost_beside_a_sweep() {
    let dir = folder();
    for part in ["1", "2"] {
        let run = sweep(&dir, &format!("--shard {part}/2 --out part-{part}.csv"));
        assert_eq!(run.code, 0, "{}", run.stderr);
    }
    let merge = "--merge part-1.csv part-2.csv";
    for (name, out, ways) in [
        ("m.csv.manifest", "m.csv", &["", "--shard 1/2", merge][..]),
        ("m.csv.run", "m.csv", &["", "--resume", merge]),
        ("m.parquet.manifest", "m.parquet", &["", merge]),
        (
            "m.parquet.rows",
            "m.parquet",
            &["", "--shard 1/2", "--resume"],
        ),
    ] {
        dir.write(name, b"important: \xff\n");
        for way in ways {
            let says = format!("`{name}`: a sweep writes a file of this name beside its own");
            refused(&sweep(&dir, &format!("{way} --out {out}")), &says);
            let kept = std::fs::read(dir.path(name)).expect(name);
            assert_eq!(kept, b"important: \xff\n", "{name} {way}");
            assert!(!dir.path(out).exists(), "{name} {way}");
        }
        // What a sweep wrote, or nobody did, makes room.
        dir.write(name, "");
        for way in [ways[0], ways[1], ""] {
            let way = way.replace("--resume", "");
            let run = sweep(&dir, &format!("{way} --out {out}"));
            assert_eq!(run.code, 0, "{name} {way}: {}", run.stderr);
        }
        std::fs::remove_file(dir.path(out)).expect(out);
    }
}

#[test]
fn rows_take_the_place_of_no_file_of_others() {
    let dir = folder();
    assert_eq!(sweep(&dir, "--shard 1/1 --out part.csv").code, 0);
    for out in ["notes.csv", "notes.parquet"] {
        dir.write(out, "time,note\n1,important\n");
        for way in ["", "--shard 1/1", "--merge part.csv"] {
            let says = format!("`{out}`: the rows of a sweep would take the place of this file");
            refused(&sweep(&dir, &format!("{way} --out {out}")), &says);
            assert_eq!(read(&dir, out), "time,note\n1,important\n", "{way}");
        }
    }
    // Rows of any sweep make room, and what has another name stays as it was.
    let old = "beta,sigma,speed,paper,exact,at_interval,xi,velocity\n9.0,";
    dir.write("old.csv", old);
    std::fs::hard_link(dir.path("old.csv"), dir.path("new.csv")).expect("a second name");
    assert_eq!(sweep(&dir, "--out new.csv").code, 0);
    assert_eq!(read(&dir, "old.csv"), old);
}

#[cfg(target_os = "linux")]
#[test]
fn rows_that_find_no_room_in_order_are_taken_up() {
    let dir = folder();
    // As much as fits into a file, by shell 512 or 1024 bytes, is enough for three rows, and too little for Parquet.
    let sweep_all = "sweep scene.toml --beta 1 --sigma 0,1/2,1 --speed 1 --out full.parquet";
    let script = format!("trap '' XFSZ; ulimit -f 1; exec \"$0\" {sweep_all}");
    let output = std::process::Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_passivity")])
        .current_dir(dir.path(""))
        .output();
    let run = Run::from(output.expect("a shell"));
    refused(&run, "; 3 of 3 points are kept: go on with --resume");
    assert!(
        run.stderr.starts_with("error: `full.parquet`: "),
        "{}",
        run.stderr
    );
    assert!(!dir.path("full.parquet").exists());
    let run = sweep(&dir, "--resume --out full.parquet");
    assert_eq!((run.code, &run.json()["simulated"]), (0, &0.into()));
}
