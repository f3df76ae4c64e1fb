//! What a log is taken to be by its header and its first rows, and what is proposed where that is not understood.

mod axes;
mod clocks;
mod counters;
mod forces;
mod hints;
mod joints;
mod labels;
mod letters;
mod others;
mod preamble;
mod quotes;
mod rising;
mod rivals;
mod sides;
mod spaces;
mod steps;
mod units;
mod wanted;
mod whole;

use passivity_audit::{Audit, Dialect, Options, TraceError, audit_csv};
use passivity_scene::Scene;

/// A linear device that is sampled a thousand times a second.
fn scene() -> Scene {
    let text = "[device]\nmass = \"0.1 kg\"\nviscous = \"0.3 N s/m\"\ncoulomb = \"0.005 N\"\n\
        [sampling]\nperiod = \"1 ms\"\n[encoder]\nresolution = \"0.01 mm\"\n[wall]\nstiffness = \"500 N/m\"";
    Scene::from_toml("linear", text).unwrap()
}

/// A rotary device that is sampled a thousand times a second.
fn rotary() -> Scene {
    let text = "[device]\nviscous = \"9e-4 N m s/rad\"\ncoulomb = \"2e-2 N m\"\n\
        [sampling]\nperiod = \"1 ms\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"1 N m/rad\"";
    Scene::from_toml("rotary", text).unwrap()
}

fn dialect(columns: Option<&str>) -> Dialect {
    Dialect {
        columns: columns.map(|text| text.parse().unwrap()),
        ..Dialect::default()
    }
}

/// Of a log with this text, with the columns that were told.
fn audited(csv: &str, columns: Option<&str>) -> Result<Audit, TraceError> {
    audited_on(&scene(), csv, columns)
}

fn audited_on(scene: &Scene, csv: &str, columns: Option<&str>) -> Result<Audit, TraceError> {
    let input = Box::new(std::io::Cursor::new(csv.as_bytes().to_vec()));
    let options = Options {
        dialect: dialect(columns),
        ..Options::default()
    };
    audit_csv(input, scene, options)
}

fn refused(csv: &str, columns: Option<&str>) -> TraceError {
    match audited(csv, columns) {
        Err(error) => error,
        Ok(audit) => panic!("{csv}: {}", audit.to_text()),
    }
}

/// The columns that are proposed for it; empty where none are.
fn proposed(csv: &str, columns: Option<&str>) -> String {
    let proposal = refused(csv, columns).proposal;
    proposal.map_or_else(String::new, |proposal| proposal.columns)
}

/// By the columns that are proposed for it, and which these are.
fn as_proposed(csv: &str) -> (String, Audit) {
    let columns = proposed(csv, None);
    let audit = audited(csv, Some(&columns)).unwrap_or_else(|e| panic!("{csv}: {columns}: {e}"));
    assert_eq!(audit.error(), None, "{csv}: {columns}");
    (columns, audit)
}

/// How many samples a log with a clock has missed; `None` where no clock was read.
fn missed(audit: &Audit) -> Option<u64> {
    let timing = audit.report().timing.as_ref();
    timing.map(|timing| timing.missed_samples)
}

#[test]
fn forces_of_other_names_are_not_passed_over() {
    for name in [
        "Fx",
        "Kraft",
        "force_cmd",
        "Fcmd",
        "FCmd",
        "Fmotor",
        "Ftot",
        "Tcmd",
        "FORCEX",
        "gripforce",
        "forceout",
        "Motorkraft",
        "Stellkraft",
        "forza",
        "fuerza",
        "kracht",
        "тяга",
        "сила",
        "Момент_двигателя",
        "トルク",
        "モータトルク",
        "力矩",
        "电机扭矩",
        "力",
        "wrench",
        "wrench_x",
        "thrust",
    ] {
        let log = format!("t [s],x [mm],{name}\n0,0,0\n0.001,0,0\n");
        assert_eq!(
            proposed(&log, None),
            format!("t=t [s], x=x [mm], f={name} [N]")
        );
    }
}

#[test]
fn what_is_not_read_is_listed_whether_columns_were_told_or_not() {
    let log = "t [s],x [mm],dt,w,\n0,0,1,2,3\n0.001,0,1,2,3\n";
    for columns in [None, Some("t=t [s], x=x [mm]")] {
        let audit = audited(log, columns).unwrap();
        assert_eq!(
            audit.to_json()["not_read"],
            serde_json::json!(["dt", "w", "number 5"])
        );
        let text = audit.to_text();
        assert!(
            text.contains("  not read                     dt, w, number 5\n"),
            "{text}"
        );
    }
    let all_read = audited("t [s],x [mm]\n0,0\n0.001,0\n", None).unwrap();
    assert!(!all_read.to_text().contains("not read"));
    // A line of text has room for so many.
    let names: String = (0..300).map(|i| format!(",channel{i}")).collect();
    let audit = audited(
        &format!("count{names}\n0{0}\n1{0}\n", ",0".repeat(300)),
        None,
    )
    .unwrap();
    assert_eq!(audit.report().not_read.len(), 300);
    let text = audit.to_text();
    let line = text.lines().find(|line| line.contains("not read")).unwrap();
    assert!(
        line.chars().count() < 150 && line.contains("channel7"),
        "{line}"
    );
    assert!(line.ends_with(" more"), "{line}");
}

#[test]
fn what_was_told_is_kept_in_what_is_proposed() {
    let log = "time,pos,trq\n0,0,1\n1,0.1,2\n2,0.2,3\n";
    for (told, expected) in [
        ("x=posi [um]", "t=time [ms], x=pos [um], f=trq [N]"),
        (
            "t=time [ns], x=posi [um], f=-trq [mN]",
            "t=time [ns], x=pos [um], f=-trq [mN]",
        ),
        (
            "x=-posi [um], f=-torq [mN]",
            "t=time [ms], x=-pos [um], f=-trq [mN]",
        ),
        (
            "t=pos [ms], x=pos [um]",
            "t=time [ms], x=pos [um], f=trq [N]",
        ),
        (
            "t=time [us], x=angle [um]",
            "t=time [us], x=pos [um], f=trq [N]",
        ),
        (
            "t=\"tim\" [us], x=\"pos\" [um]",
            "t=time [us], x=pos [um], f=trq [N]",
        ),
        // There is no velocity.
        ("x=posi [um], v=pos [m/s]", ""),
        ("x=pos [um], v=speed [m/s]", ""),
    ] {
        assert_eq!(proposed(log, Some(told)), expected, "{told}");
    }
    let error = refused(log, Some("t=time [ns], x=posi [um]")).to_string();
    assert!(error.contains("are assumed: f in N)"), "{error}");
    // Of several joints the one whose name is the most like what was typed.
    let log = "t [s],joint1_pos,joint2_pos\n0,0,0\n1,0.1,1\n";
    assert_eq!(
        proposed(log, Some("x=joint2_po [mm]")),
        "t=t [s], x=joint2_pos [mm]"
    );
}

#[test]
fn what_stands_in_the_way_of_a_header_is_named() {
    for (log, says) in [
        (
            "1700000000,0,world,knob,0.1,0,-1\n1700000000,1,world,knob,0.2,0,-1\n",
            "holds numbers, not names",
        ),
        ("0,0\n0.001,1\n", "the first line holds numbers"),
        (
            "# measured at 1 kHz\n0,0\n0.001,1\n",
            "the names of the columns, `measured at 1 kHz`, are 1, but the first row has 2 fields",
        ),
        ("t [s],count\r0,0\r0.001,1\r", "`tr '\\r' '\\n'`"),
        (
            "{\"count\":1}\n{\"count\":2}\n",
            "the file is JSON, which is not read",
        ),
        ("#ROSBAG V2.0\n", "the file is a ROS 1 bag"),
        ("SQLite format 3\0xxxx", "`ros2 bag convert`"),
        (
            "BZh91AY&SY",
            "compressed by bzip2, which is not read: decompress it",
        ),
        ("PK\u{3}\u{4}", "a ZIP archive"),
        ("ARROW1\0\0", "Feather"),
        ("MATLAB 5.0 MAT-file, Platform", "`writetable`"),
    ] {
        let error = refused(log, None).to_string();
        assert!(error.contains(says), "{log}: {error}");
    }
    let long = format!("count\r{}", "1\r".repeat(1 << 20));
    assert!(refused(&long, None).to_string().contains("carriage return"));
    let bytes = |bytes: &[u8]| {
        let input = Box::new(std::io::Cursor::new(bytes.to_vec()));
        audit_csv(input, &scene(), Options::default())
            .unwrap_err()
            .to_string()
    };
    let utf_16: Vec<u8> = "\u{feff}count\n0\n"
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    assert!(
        bytes(&utf_16).contains("`iconv -f UTF-16 -t UTF-8`"),
        "{}",
        bytes(&utf_16)
    );
    // Without a mark at its start.
    for (order, ends) in [
        ("LE", u16::to_le_bytes as fn(u16) -> [u8; 2]),
        ("BE", u16::to_be_bytes),
    ] {
        let text: Vec<u8> = "count\n0\n".encode_utf16().flat_map(ends).collect();
        let says = format!(
            "text in UTF-16, which is not read: convert it with `iconv -f UTF-16{order} -t UTF-8`"
        );
        assert!(bytes(&text).contains(&says), "{}", bytes(&text));
    }
    // A stored block of gzip that holds the start of another such file.
    let head = b"\x1f\x8b\x08\0\0\0\0\0\0\x03";
    let twice = [&head[..], b"\x01\x10\0\xef\xff", head, &[0; 6]].concat();
    assert!(
        bytes(&twice).contains("compressed twice"),
        "{}",
        bytes(&twice)
    );
    for (start, says) in [
        (&b"\xfd7zXZ\0\0"[..], "compressed by xz"),
        (b"\x89HDF\r\n\x1a\n", "the file is HDF5"),
        (b"\x93NUMPY\x01", "a NumPy array"),
        (b"\x04\x22\x4d\x18@", "compressed by lz4"),
    ] {
        assert!(bytes(start).contains(says), "{}", bytes(start));
    }
    let many = "# a comment\n".repeat(1001);
    let error = refused(&format!("{many}count\n0\n"), None).to_string();
    assert!(
        error.contains("more than 1000 lines of comments"),
        "{error}"
    );
}

#[test]
fn comments_a_line_of_excel_and_units_of_their_own_stand_before_the_rows() {
    let rows = "0,0,0\n0.001,1,-0.5\n0.002,3,-1\n";
    let plain = audited(&format!("t [s],count,f [N]\n{rows}"), None).unwrap();
    for before in [
        // As `numpy.savetxt` writes the names, where its comments are those of MATLAB too.
        "# t [s],count,f [N]\n",
        "%t [s],count,f [N]\n",
        "# a linear device\n#\n# t [s],count,f [N]\n",
        "\u{feff}# a linear device\r\n% at 1 kHz\r\nt [s],count,f [N]\r\n",
        "sep=,\nt [s],count,f [N]\n",
        "\u{feff}# a linear device\nsep=,\nt [s],count,f [N]\n",
        "t,count,f\n[s],,(N)\n",
        "# a linear device\nt,count,f\ns,-,N\n",
    ] {
        let audit = audited(&format!("{before}{rows}"), None);
        let audit = audit.unwrap_or_else(|error| panic!("{before}: {error}"));
        assert_eq!(audit.to_json(), plain.to_json(), "{before}");
    }
    let semicolons = format!("sep=;\nt [s],count,f [N]\n{rows}").replace(',', ";");
    let audit = audited(&semicolons, None).unwrap();
    assert_eq!(audit.to_json(), plain.to_json());
    // What names do not say is proposed as it is where nothing stands before them.
    for (log, columns, delimiter) in [
        ("# time,count\n0,0\n1,1\n", "t=time [ms], count=count", None),
        ("# t count\n0 0\n1 1\n", "t=t [ms], count=count", Some(' ')),
        (
            "time,position,torque\ns,m,N\n0,0,0\n0.001,0,0\n",
            "t=time [s], x=position [m], f=torque [N]",
            None,
        ),
        (
            "time\tposition\tx [mm]\ns\tdeg\t\n0\t0\t0\n0.001\t0\t1\n",
            "t=time [s], x=x [mm]",
            Some('\t'),
        ),
        (
            "sep=;\ntime [s];count\n0,000;0\n0,001;1\n",
            "t=time [s], count=count",
            Some(';'),
        ),
    ] {
        let proposal = refused(log, None)
            .proposal
            .unwrap_or_else(|| panic!("{log}"));
        assert_eq!(
            (proposal.columns.as_str(), proposal.delimiter),
            (columns, delimiter),
            "{log}"
        );
    }
}

#[test]
fn a_column_called_count_is_no_angle_whatever_was_typed() {
    let csv = "t [s],count\n0,0\n1e-3,1\n";
    let typed = "t=t [s], x=angle [mm]";
    assert_eq!(proposed(csv, Some(typed)), "t=t [s], count=count");
    let csv = "t [s],pos\n0,0\n1e-3,1\n";
    assert_eq!(proposed(csv, Some(typed)), "t=t [s], x=pos [mm]");
}
