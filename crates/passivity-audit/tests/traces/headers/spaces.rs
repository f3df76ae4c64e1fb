//! Fields that stand apart by spaces.

use passivity_audit::{Audit, Dialect, Options, audit_csv};

use super::{audited, audited_on, refused, rotary, scene};

fn by_spaces(log: &str, columns: Option<&str>) -> Audit {
    let dialect = Dialect {
        delimiter: Some(b' '),
        ..super::dialect(columns)
    };
    let options = Options {
        dialect,
        ..Options::default()
    };
    let input = Box::new(std::io::Cursor::new(log.as_bytes().to_vec()));
    audit_csv(input, &scene(), options).unwrap_or_else(|error| panic!("{log}: {error}"))
}

fn json(audit: &Audit) -> serde_json::Value {
    assert_eq!(audit.error(), None);
    let mut json = audit.to_json();
    json.as_object_mut().unwrap().remove("columns");
    json
}

#[test]
fn runs_of_spaces_are_one_and_those_at_the_ends_are_none() {
    let rows = [
        "0,0,0",
        "0.001,0.02,-0.01",
        "0.002,0,0",
        "0.003,-0.01,0.005",
    ];
    let commas = format!("t [s],x [mm],f [N]\n{}\n", rows.join("\n"));
    let expected = json(&audited(&commas, None).unwrap());
    for (between, start, end) in [
        (" ", "", ""),
        ("   ", "  ", ""),
        ("  ", "", " "),
        (" ", " ", "   \r"),
    ] {
        let row = |row: &str| format!("{start}{}{end}\n", row.replace(',', between));
        let rows: String = rows.iter().map(|it| row(it)).collect();
        let log = format!("{start}t [s]{between}x [mm]{between}f [N]{end}\n{rows}");
        assert_eq!(json(&by_spaces(&log, None)), expected, "{log}");
        // The command that an error shows reads it too.
        let header = ["Time (s)", "Position", "Torque [mN"];
        let log = format!("{} m]\n{rows}", header.join(between));
        let error = refused(&log.replace("mN m", "N"), None);
        let proposal = error.proposal.clone().unwrap();
        assert_eq!(proposal.delimiter, Some(' '), "{log}: {error}");
        assert_eq!(proposal.columns, "t=Time (s), x=Position [m], f=Torque [N]");
    }
}

#[test]
fn units_of_several_words_stand_apart_by_spaces_too() {
    let log = "Time [s]  Angle [mrad]  Torque [N m]\n0 0 0\n0.001 0.5 -0.25\n";
    let proposal = |scene| audited_on(scene, log, None).unwrap_err().proposal.unwrap();
    let columns = "t=Time [s], x=Angle [mrad], f=Torque [N m]";
    let found = proposal(&rotary());
    assert_eq!((&*found.columns, found.delimiter), (columns, Some(' ')));
    // Where there is nothing to propose, the error is not that of one long column.
    let error = refused(log, None);
    assert_eq!(error.proposal, None);
    let says = "its fields seem to stand apart by ` `, not by `,` (`--delimiter ' '` says so), and then the column `Time [s]` is not read under this name; ";
    assert!(error.to_string().starts_with(says), "{error}");
}

#[test]
fn a_field_too_many_and_one_too_few_are_errors_of_their_rows() {
    for (row, found) in [("0.001  1 2", 3), ("  0.001  ", 1)] {
        let audit = by_spaces(&format!("t [s]  count\n0  0\n{row}\n0.002 0\n"), None);
        let error = audit.error().unwrap();
        assert_eq!((error.kind, error.row), ("fields", Some(2)));
        assert!(
            error
                .message
                .contains(&format!("expected 2 fields, found {found}")),
            "{error}"
        );
    }
}

#[test]
fn names_that_do_not_pair_with_the_fields_are_not_proposed() {
    for (names, count) in [
        ("motor torque [N]   x [mm]   t [s]", 4),
        ("t / s   x / mm   f / N", 9),
    ] {
        let error = refused(&format!("{names}\n-1 1 0\n-1.1 1.1 0.001\n"), None);
        assert_eq!(error.proposal, None, "{error}");
        let says = format!(
            "its fields seem to stand apart by ` `, not by `,`, and then the names of the columns, `{names}`, are {count}, but the \
            first row has 3 fields"
        );
        assert_eq!(error.to_string(), says);
    }
}

#[test]
fn a_line_of_units_in_brackets_stands_apart_by_spaces_too() {
    let expected = json(&audited("t [s],x [mm],f [N]\n0,1,-1\n0.001,1.1,-1.1\n", None).unwrap());
    for units in ["[s]  [mm]  [N]", "s mm N", " (s) [ mm ] N"] {
        let log = format!("t  x  f\n{units}\n0 1.0 -1\n0.001 1.1 -1.1\n");
        assert_eq!(json(&by_spaces(&log, None)), expected, "{units}");
    }
}

#[test]
fn what_stands_only_at_the_end_of_the_rows_is_named() {
    let empty = "are 3, but the first row has 4 fields, the last of which is empty: take away";
    for (log, says) in [
        (
            "t [s];count;f [N]\n0.000;0;-0.1;\n0.001;1;-0.2;\n",
            "stand apart by `;`, not by `,`, and then",
        ),
        (
            "t [s];count;f [N]\n0,000;0;-0,1;\n0,001;1;-0,2;\n",
            "stand apart by `;`, not by `,`, and then",
        ),
        (
            "t\tcount\tf\n0.000\t0\t-0.1\t\n0.001\t1\t-0.2\t\n",
            "stand apart by `\\t`, not by `,`",
        ),
        (
            "time,count,force\n0.000,0,-0.1,\n0.001,1,-0.2,\n",
            "the names of the columns",
        ),
    ] {
        let error = refused(log, None);
        assert_eq!(error.proposal, None, "{error}");
        let error = error.to_string();
        assert!(error.contains(says) && error.contains(empty), "{error}");
    }
}

/// The line that is to be written before rows without names, and the options that it is read with, as they are printed.
#[test]
fn the_names_that_rows_without_any_may_have_are_written_as_the_rows_are() {
    for (scene, rows, names, meant, options) in [
        (
            rotary(),
            "0 0.00 0\n0.001 0.01 0.1\n0.002 0.03 0.1\n",
            "column1 column2 column3",
            &["t [s]", "x [rad]", "f [N m]"][..],
            Some((b' ', "--delimiter ' '")),
        ),
        (
            rotary(),
            "0\t0\t0.5\t7\t8\n0.001\t1\t0.1\t7\t8\n",
            "column1\\tcolumn2\\tcolumn3\\tcolumn4\\tcolumn5",
            &["t [s]", "count", "f [N m]"],
            Some((b'\t', "--delimiter tab")),
        ),
        (
            scene(),
            "0;0.5\n0.001;1\n",
            "column1;column2",
            &["t [s]", "x [m]"],
            Some((b';', "--delimiter ';'")),
        ),
        (
            scene(),
            "0,0\n0.001,1\n",
            "column1,column2",
            &["t [s]", "count"],
            None,
        ),
        (
            scene(),
            "0,0\n-1,0.5\n",
            "column1,column2",
            &["count", "f [N]"],
            None,
        ),
    ] {
        let error = audited_on(&scene, rows, None).unwrap_err();
        assert!(error.message.contains(&format!("as `{names}`")), "{error}");
        let says = options.map_or_else(String::new, |(_, it)| format!(" with `{it}`"));
        assert!(error.message.contains(&says), "{error}");
        let audited = |names: &str| {
            let log = format!("{}\n{rows}", names.replace("\\t", "\t"));
            let dialect = Dialect {
                delimiter: options.map(|(delimiter, _)| delimiter),
                ..Dialect::default()
            };
            let options = Options {
                dialect,
                ..Options::default()
            };
            let input = Box::new(std::io::Cursor::new(log.into_bytes()));
            audit_csv(input, &scene, options)
        };
        // As they stand they say nothing of what is what.
        assert!(audited(names).is_err(), "{names}");
        let named = (1..).zip(meant).fold(names.to_owned(), |names, (i, role)| {
            names.replace(&format!("column{i}"), role)
        });
        assert_eq!(audited(&named).unwrap().error(), None, "{named}");
    }
}

#[test]
fn rows_that_stand_apart_otherwise_than_their_names_say_so() {
    for (row, says) in [
        (
            "0 0 0",
            "` `: write the names so, too, and read the log with `--delimiter ' '`",
        ),
        (
            "0;0;0",
            "`;`: write the names so, too, and read the log with `--delimiter ';'`",
        ),
        (
            "0\t0\t0",
            "`\\t`: write the names so, too, and read the log with `--delimiter tab`",
        ),
    ] {
        let audit = audited(&format!("t [s],x [mm],f [N]\n{row}\n"), None).unwrap();
        let error = audit.error().unwrap().to_string();
        let start = "row 1: expected 3 fields, found 1 (its fields seem to stand apart by ";
        assert!(error.starts_with(start) && error.contains(says), "{error}");
    }
}
