//! Logs with mistakes in them: an error that says where, and what came before is accounted for.

use passivity_audit::{Options, TraceError, Verdict, audit, audit_csv, audit_files};
use passivity_scene::Scene;

use super::{audited, scene, three_fifths};
use crate::scratch::Scratch;

fn refusal(csv: &[u8], text: &str) -> TraceError {
    let input = Box::new(std::io::Cursor::new(csv.to_vec()));
    match audit_csv(input, &scene(text), Options::default()) {
        Err(error) => error,
        Ok(audit) => panic!("expected an error, found {}", audit.to_text()),
    }
}

#[test]
fn headers_say_what_is_wrong_with_them() {
    let plain = "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"";
    let rotary = "[sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"2 N m/rad\"";
    for (csv, text, kind, said) in [
        ("", plain, "header", "nothing"),
        ("a,b\n1,2\n", plain, "header", "found `a`, `b`"),
        ("xi,xi\n1,2\n", plain, "header", "twice"),
        ("xi,count\n1,2\n", plain, "header", "`xi` and `count`"),
        ("x\n1\n", rotary, "unit", "x [rad]"),
        ("x [mm]\n1\n", rotary, "unit", "rad"),
        ("x [rad]\n1\n", plain, "unit", "xi"),
        ("x [parsec]\n1\n", rotary, "unit", "parsec"),
        ("count,t [rad]\n1,2\n", rotary, "unit", "time"),
        ("count,t\n1,2\n", rotary, "unit", "t [s]"),
        ("count,f [N]\n1,2\n", rotary, "unit", "N m"),
        ("xi [rad]\n1\n", rotary, "header", "no unit"),
        ("x [rad\n1\n", rotary, "header", "not closed"),
        ("count,t [s\n1,2\n", rotary, "header", "not closed"),
    ] {
        let error = refusal(csv.as_bytes(), text);
        assert_eq!(error.kind, kind, "{csv}: {error}");
        assert!(error.to_string().contains(said), "{csv}: {error}");
    }
}

#[test]
fn mistakes_have_a_row_and_what_came_before_is_kept() {
    let wide = format!("count\n1\n2\n{}\n4\n", "9".repeat(10_000_000));
    let endless = format!("count\n1\n2\n{}", "9".repeat(10_000_000));
    for (csv, kind, row, intervals) in [
        ("count\n1\n2\nx\n4\n", "malformed_number", 3, 1),
        ("count\n1\n2\n3,4\n", "fields", 3, 1),
        ("count\n1\n2\nNaN\n", "not_finite", 3, 1),
        ("count\n1\n2.5\n3\n", "count", 2, 0),
        ("xi\n1\n2\n1e999999999\n", "exponent_too_large", 3, 1),
        ("xi\n1\n2\n1/0\n", "zero_denominator", 3, 1),
        ("count\n1\n\n3\n", "blank_row", 2, 0),
        ("count\n0\n1\n2147483649\n5\n", "jump", 3, 1),
        (
            "count\n9223372036854775807\n-9223372036854775808\n",
            "jump",
            2,
            0,
        ),
        ("count\n99999999999999999999\n", "count", 1, 0),
        ("count,tau\n1,1\n2,2\n3,2\n", "time", 3, 1),
        ("count,tau\n1,1\n2,2\n3,1\n", "time", 3, 1),
        ("count,tau\n1,1\n2,2\n3", "fields", 3, 1), // torn
        ("xi0,xi1\n0,1\n2,3\n", "gap", 2, 1),
        ("xi0,xi1,dtau\n0,1,1\n1,2,1\n2,3,-1\n3,4,1\n", "time", 3, 2),
        ("xi0,xi1,dtau\n0,1,1\n1,2,1\n2,3,0\n", "time", 3, 2),
        ("\u{feff}count\r\n1\r\n2\r\n-\r\n", "malformed_number", 3, 1),
        (&wide, "line_too_long", 3, 1),
        (&endless, "line_too_long", 3, 1),
    ] {
        for (threads, block) in [(1, 0), (2, 7), (3, 12)] {
            let (audit, rows) = audited(csv.as_bytes(), &three_fifths(), threads, block);
            let shown = &csv[..csv.len().min(60)];
            let error = audit
                .error()
                .unwrap_or_else(|| panic!("no error in {shown:?}"));
            assert_eq!(
                (error.kind, error.row),
                (kind, Some(row)),
                "{shown:?} {block}: {error}"
            );
            assert_eq!(audit.totals().intervals, intervals, "{shown:?} {block}");
            assert_eq!(
                rows.lines().count() as u64,
                intervals + 1,
                "{shown:?} {block}"
            );
            assert_eq!(audit.verdict(), Verdict::Broken);
        }
    }
}

#[test]
fn a_missing_file_is_an_error() {
    let path = std::env::temp_dir().join("passivity-no-such-trace.csv");
    let error = audit(&path, &three_fifths(), Options::default()).unwrap_err();
    assert_eq!(error.kind, "io");
}

#[test]
fn blank_lines_may_end_a_log_wherever_a_block_ends() {
    let scene = Scene::from_toml("s", "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"").unwrap();
    for block in 1..40 {
        let read = |text: &'static str| {
            let options = Options {
                block,
                ..Options::default()
            };
            audit_csv(Box::new(text.as_bytes()), &scene, options).unwrap()
        };
        let audit = read("count\n1\n22\n3\n\n \n\n");
        assert!(audit.error().is_none(), "{block}: {:?}", audit.error());
        assert_eq!(audit.totals().intervals, 2);
        let audit = read("count\n1\n22\n3\n\n\n4\n");
        assert_eq!(
            audit.error().map(|error| error.row),
            Some(Some(4)),
            "{block}"
        );
    }
}

#[test]
fn what_a_broken_ledger_accounts_for_does_not_depend_on_where_a_block_ends() {
    let scene = Scene::from_toml("s", "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"").unwrap();
    for block in 1..40 {
        for (last, column) in [("x", None), ("5,6\n6,7\n", Some("xi0"))] {
            let text = format!("xi0,xi1\n0,1\n1,2\n2,4\n{last}");
            let text = Box::new(std::io::Cursor::new(text));
            let options = Options {
                block,
                ..Options::default()
            };
            let audit = audit_csv(text, &scene, options).unwrap();
            assert_eq!(audit.totals().intervals, 3, "{block}");
            let error = audit.error().unwrap();
            assert_eq!(error.row, Some(4), "{block}");
            assert_eq!(error.column.as_deref(), column, "{block}");
        }
    }
}

#[test]
fn a_ledger_with_a_force_or_a_clock_under_another_name_is_refused() {
    let plain = "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"";
    for (columns, name) in [
        ("xi0,xi1,f", "f"),
        ("xi0,xi1,tau", "tau"),
        ("h,xi0,xi1,t", "t"),
        ("xi0,xi1,f [N]", "f [N]"),
        ("xi0,xi1,dtau,torque", "torque"),
        ("xi0,xi1,dtau,tau [N m]", "tau [N m]"),
        ("xi0,xi1,force,time [s]", "time [s]"),
    ] {
        let row = "1,".repeat(columns.split(',').count() - 1);
        let error = refusal(format!("{columns}\n{row}1\n").as_bytes(), plain);
        assert_eq!(error.column.as_deref(), Some(name), "{error}");
        assert!(
            error.to_string().contains("the force as `force`, in KΔ"),
            "{error}"
        );
    }
    // What these say already, and the other columns of a ledger.
    for columns in [
        "xi0,xi1,dtau,tau",
        "xi0,xi1,force,f",
        "h,xi0,xi1,net_linear,v0,xi",
    ] {
        let row = "1,".repeat(columns.split(',').count() - 1);
        audited(
            format!("{columns}\n{row}1\n").as_bytes(),
            &scene(plain),
            1,
            0,
        );
    }
}

#[test]
fn a_gap_between_two_files_leaves_the_interval_before_it() {
    let files = ["xi0,xi1\n0,0\n0,1\n1,1/2\n", "xi0,xi1\n2,3\n3,4\n"];
    let files = files.map(|text| Scratch::new("csv", text.as_bytes()));
    let paths = files.each_ref().map(|file| file.to_path_buf());
    let scene = scene("[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"2/5\"");
    let audit = audit_files(&paths, &scene, Options::default()).unwrap();
    assert_eq!(audit.totals().intervals, 3);
    let error = audit.error().unwrap();
    assert_eq!((error.kind, error.row), ("gap", Some(1)));
    assert_eq!(error.column.as_deref(), Some("xi0"));
    assert_eq!(error.file.as_deref(), paths[1].to_str());
    let alone = audit_files(&paths[..1], &scene, Options::default()).unwrap();
    assert_eq!(alone.verdict(), Verdict::Fails);
    assert_eq!(audit.to_json()["totals"], alone.to_json()["totals"]);
}

#[test]
fn a_last_row_without_its_line_break_is_told_of_each_file() {
    let text = |torn: bool| {
        if torn {
            "count\n0\n1\n2"
        } else {
            "count\n0\n1\n2\n"
        }
    };
    for torn in [
        [true, false, false],
        [false, true, true],
        [false; 3],
        [true; 3],
    ] {
        let files = torn.map(|torn| Scratch::new("csv", text(torn).as_bytes()));
        // One without rows, or with a mistake in its first, changes nothing of what came before.
        for after in [None, Some("count\n"), Some("count\n?\n")] {
            let breaks = after.is_some_and(|text| text.contains('?'));
            let after = after.map(|text| Scratch::new("csv", text.as_bytes()));
            let paths: Vec<_> = files
                .iter()
                .chain(&after)
                .map(|file| file.to_path_buf())
                .collect();
            for block in [0, 4] {
                let options = Options {
                    block,
                    ..Options::default()
                };
                let audit = audit_files(&paths, &three_fifths(), options).unwrap();
                let named = torn.iter().zip(&paths).filter(|(torn, _)| **torn);
                let rows: Vec<_> = named
                    .map(|(_, path)| serde_json::json!({ "file": path.to_str(), "row": 3 }))
                    .collect();
                let (text, json) = (audit.to_text(), audit.to_json());
                assert_eq!(json["last_row_unended"], torn[2] && !breaks);
                let told = json.get("unended_rows").and_then(|rows| rows.as_array());
                assert_eq!(told.cloned().unwrap_or_default(), rows);
                let of_first = format!("row 3 of {}", paths[0].display());
                assert_eq!(text.contains(&of_first), torn[0], "{text}");
                assert_eq!(
                    text.contains("may be incomplete"),
                    !rows.is_empty(),
                    "{text}"
                );
            }
        }
    }
}

#[test]
fn a_file_of_a_log_is_given_once() {
    let files =
        ["count\n0\n1\n2\n", "count\n3\n4\n"].map(|text| Scratch::new("csv", text.as_bytes()));
    let [first, second] = files.each_ref().map(|file| file.to_path_buf());
    let other_name = first
        .parent()
        .unwrap()
        .join(".")
        .join(first.file_name().unwrap());
    for twice in [&first, &other_name] {
        let paths = [first.clone(), second.clone(), twice.clone()];
        let error = audit_files(&paths, &three_fifths(), Options::default()).unwrap_err();
        assert_eq!(error.kind, "twice", "{error}");
        assert!(
            error.to_string().contains("the file is given twice"),
            "{error}"
        );
    }
    let once = audit_files(&[first, second], &three_fifths(), Options::default()).unwrap();
    assert_eq!(once.totals().intervals, 4);
}
