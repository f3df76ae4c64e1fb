//! Parquet traces: as CSV ones, and an error for every file that is cut short or corrupt.

mod types;

use std::fs;
use std::path::Path;
use std::sync::Arc;

use parquet::basic::Compression;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use passivity_audit::{
    Audit, Options, Stretch, TraceError, Verdict, audit, audit_csv, audit_files, audit_part,
    merge_parts,
};
use passivity_scene::Scene;

use crate::scratch::Scratch;

fn scene() -> Scene {
    Scene::from_toml("test", "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"").unwrap()
}

enum Column {
    Whole(Vec<i64>),
    Double(Vec<f64>),
    Text(Vec<&'static str>),
    /// Doubles with gaps.
    Sparse(Vec<Option<f64>>),
}

/// Writes a file with groups of two rows each.
fn write(columns: &[(&str, Column)], compression: Compression) -> Scratch {
    let field = |(name, column): &(&str, Column)| match column {
        Column::Whole(_) => format!("required int64 {name};"),
        Column::Double(_) => format!("required double {name};"),
        Column::Text(_) => format!("required binary {name} (UTF8);"),
        Column::Sparse(_) => format!("optional double {name};"),
    };
    let fields: String = columns.iter().map(field).collect();
    let schema = Arc::new(parse_message_type(&format!("message trace {{ {fields} }}")).unwrap());
    let properties = WriterProperties::builder()
        .set_compression(compression)
        .build();
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties)).unwrap();
    let rows = columns
        .iter()
        .map(|(_, column)| match column {
            Column::Whole(values) => values.len(),
            Column::Double(values) => values.len(),
            Column::Text(values) => values.len(),
            Column::Sparse(values) => values.len(),
        })
        .max()
        .unwrap();
    for start in (0..rows).step_by(2) {
        let mut group = writer.next_row_group().unwrap();
        let range = start..rows.min(start + 2);
        for (_, column) in columns {
            let mut writer = group.next_column().unwrap().unwrap();
            match column {
                Column::Whole(values) => {
                    writer
                        .typed::<Int64Type>()
                        .write_batch(&values[range.clone()], None, None)
                        .unwrap();
                }
                Column::Double(values) => {
                    writer
                        .typed::<DoubleType>()
                        .write_batch(&values[range.clone()], None, None)
                        .unwrap();
                }
                Column::Text(values) => {
                    let texts: Vec<ByteArray> =
                        values[range.clone()].iter().map(|t| (*t).into()).collect();
                    writer
                        .typed::<ByteArrayType>()
                        .write_batch(&texts, None, None)
                        .unwrap();
                }
                Column::Sparse(values) => {
                    let levels: Vec<i16> = values[range.clone()]
                        .iter()
                        .map(|v| i16::from(v.is_some()))
                        .collect();
                    let there: Vec<f64> = values[range.clone()].iter().copied().flatten().collect();
                    writer
                        .typed::<DoubleType>()
                        .write_batch(&there, Some(&levels), None)
                        .unwrap();
                }
            }
            writer.close().unwrap();
        }
        group.close().unwrap();
    }
    Scratch::new("parquet", &writer.into_inner().unwrap())
}

fn read(path: &Path) -> Result<Audit, TraceError> {
    audit(
        path,
        &scene(),
        Options {
            threads: 2,
            ..Options::default()
        },
    )
}

fn csv(text: &str) -> Audit {
    audit_csv(
        Box::new(std::io::Cursor::new(text.to_owned())),
        &scene(),
        Options::default(),
    )
    .unwrap()
}

#[test]
fn parquet_and_csv_agree() {
    let counts = || Column::Whole(vec![0, 1, 3, 2, -1]);
    let times = || Column::Double(vec![0.0, 1.0, 2.5, 3.0, 4.0]);
    for compression in [
        Compression::UNCOMPRESSED,
        Compression::SNAPPY,
        Compression::LZ4_RAW,
        Compression::ZSTD(Default::default()),
        Compression::GZIP(Default::default()),
        Compression::BROTLI(Default::default()),
    ] {
        let path = write(&[("count", counts()), ("tau", times())], compression);
        let table = read(&path).unwrap().to_json();
        let text = csv("count,tau\n0,0\n1,1\n3,2.5\n2,3\n-1,4\n").to_json();
        assert_eq!(table, text, "{compression}");
    }
    let path = write(
        &[("xi", Column::Text(vec!["1/3", "-0.5", "2e1"]))],
        Compression::SNAPPY,
    );
    assert_eq!(
        read(&path).unwrap().to_json(),
        csv("xi\n1/3\n-1/2\n20\n").to_json()
    );
    let path = write(
        &[("xi", Column::Double(vec![0.1, 0.5]))],
        Compression::SNAPPY,
    );
    // The dyadic rational that the double is, not 1/10.
    let json = read(&path).unwrap().to_json();
    assert_eq!(json["rows"][0]["xi0"], "3602879701896397/36028797018963968");
}

#[test]
fn a_wrong_value_has_its_row() {
    for (name, column, kind, row) in [
        (
            "nan",
            Column::Double(vec![0.0, 1.0, 2.0, f64::NAN, 4.0]),
            "not_finite",
            4,
        ),
        (
            "inf",
            Column::Double(vec![f64::INFINITY, 1.0]),
            "not_finite",
            1,
        ),
        (
            "null",
            Column::Sparse(vec![Some(0.0), Some(1.0), None, Some(1.0)]),
            "missing",
            3,
        ),
        (
            "word",
            Column::Text(vec!["0", "one"]),
            "malformed_number",
            2,
        ),
    ] {
        let path = write(&[("xi", column)], Compression::SNAPPY);
        let audit = read(&path).unwrap();
        let error = audit.error().unwrap();
        assert_eq!(
            (error.kind, error.row),
            (kind, Some(row)),
            "{name}: {error}"
        );
        assert_eq!(audit.totals().intervals, u64::saturating_sub(row, 2));
        assert_eq!(audit.verdict(), Verdict::Broken);
    }
}

#[test]
fn a_ledger_breaks_as_in_csv_wherever_a_group_of_rows_ends() {
    // The row from which on the start is another, and the one that lasts no time.
    for (gap, still, kind, row) in [
        (3, 9, "gap", 3),
        (4, 9, "gap", 4),
        (9, 3, "time", 3),
        (9, 4, "time", 4),
        (9, 5, "time", 5),
        (3, 3, "time", 3),
        (4, 2, "time", 2),
    ] {
        let start = |h: i64| if h < gap { h } else { h + 5 };
        let lasts = |h: i64| i64::from(h != still);
        let column = |of: &dyn Fn(i64) -> i64| Column::Whole((1..6).map(of).collect());
        let path = write(
            &[
                ("xi0", column(&start)),
                ("xi1", column(&|h| start(h) + 1)),
                ("dtau", column(&lasts)),
            ],
            Compression::SNAPPY,
        );
        let line = |h| format!("{},{},{}\n", start(h), start(h) + 1, lasts(h));
        let lines: String = (1..6).map(line).collect();
        let text = csv(&format!("xi0,xi1,dtau\n{lines}"));
        let table = read(&path).unwrap();
        assert_eq!(table.to_json(), text.to_json());
        let error = table.error().unwrap();
        assert_eq!((error.kind, error.row), (kind, Some(row)), "{error}");
        assert_eq!(table.totals().intervals, row - 1, "{error}");
    }
}

#[test]
fn every_prefix_and_every_flipped_byte_ends_in_a_report_or_an_error() {
    // Six groups of rows: every byte of the file is tried, so it is kept short.
    let counts: Vec<i64> = (0..12).map(|i| i * i % 17).collect();
    let path = write(&[("count", Column::Whole(counts))], Compression::SNAPPY);
    let whole = fs::read(&*path).unwrap();
    let hostile = Scratch::new("hostile", &whole);
    let mut refused = 0;
    for end in (0..whole.len()).step_by(7) {
        fs::write(&*hostile, &whole[..end]).unwrap();
        // A file cut short has no footer.
        assert!(read(&hostile).is_err(), "{end} of {} bytes", whole.len());
    }
    for at in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x55;
        fs::write(&*hostile, &bytes).unwrap();
        match read(&hostile) {
            Err(_) => refused += 1,
            Ok(audit) => assert!(audit.to_json().is_object()),
        }
    }
    assert!(refused > 0);
}

#[test]
fn merged_pieces_are_the_report_of_the_whole() {
    let scene = scene();
    let counts: Vec<i64> = (0..41).map(|i| (i * i) % 7).collect();
    let mut forces: Vec<Option<f64>> = counts.iter().map(|n| Some(-(*n as f64))).collect();
    let whole_file = write(
        &[
            ("count", Column::Whole(counts.clone())),
            ("f", Column::Sparse(forces.clone())),
        ],
        Compression::UNCOMPRESSED,
    );
    forces[29] = None;
    let broken_file = write(
        &[
            ("count", Column::Whole(counts)),
            ("f", Column::Sparse(forces)),
        ],
        Compression::SNAPPY,
    );
    for path in [whole_file, broken_file] {
        let whole = audit(&path, &scene, Options::default()).unwrap().to_json();
        let merged = |stretches: &[Stretch]| {
            let part = |stretch: &Stretch| {
                let part = audit_part(&path, &scene, *stretch, Options::default()).unwrap();
                (format!("{stretch:?}"), part)
            };
            let parts: Vec<_> = stretches.iter().map(part).collect();
            merge_parts(&parts, &scene).unwrap().to_json()
        };
        for n in [1, 2, 3, 7, 20, 60] {
            let shards: Vec<Stretch> = (1..=n).map(|i| Stretch::Shard(i, n)).collect();
            assert_eq!(merged(&shards), whole, "{n}");
        }
        for cut in 0..44 {
            let stretches = [Stretch::Samples(0, Some(cut)), Stretch::Samples(cut, None)];
            assert_eq!(merged(&stretches), whole, "{cut}");
        }
    }
}

/// How long texts are is seen in all groups and files from the first row on, as in CSV, and by each piece.
#[test]
fn forces_as_text_have_the_digits_of_those_in_csv() {
    let counts = [0, 1, 10, 3, 1, 0, 2];
    // Of two digits at the most -10 may be -10.5, but -1 is -1.0.
    let forces = ["-0.5", "-1", "-10", "-3.5", "-3/2", "-0.5", "-2.5"];
    let stored = |rows: std::ops::Range<usize>| {
        let counts = Column::Whole(counts[rows.clone()].to_vec());
        let forces = Column::Text(forces[rows].to_vec());
        write(&[("count", counts), ("f", forces)], Compression::SNAPPY)
    };
    let rows = counts.iter().zip(forces);
    let lines: String = rows.map(|(n, f)| format!("{n},{f}\n")).collect();
    let expected = csv(&format!("count,f\n{lines}")).to_json();
    let mismatches = &expected["force"]["mismatches"];
    assert_eq!(mismatches, 1, "{}", expected["force"]);
    let path = stored(0..7);
    assert_eq!(read(&path).unwrap().to_json(), expected);
    for n in [1, 2, 4] {
        let part = |i| {
            let part = audit_part(&path, &scene(), Stretch::Shard(i, n), Options::default());
            (i.to_string(), part.unwrap())
        };
        let parts: Vec<_> = (1..=n).map(part).collect();
        let merged = merge_parts(&parts, &scene()).unwrap();
        assert_eq!(merged.to_json(), expected, "{n}");
    }
    let files = [stored(0..2), stored(2..7)];
    let paths = files.each_ref().map(|file| file.to_path_buf());
    let audit = audit_files(&paths, &scene(), Options::default()).unwrap();
    assert_eq!(audit.to_json()["force"], expected["force"]);
}

/// Counts 0, 0, 0, 8, 0, 0, 0 in a page with a checksum, which our writer has none of.
const CHECKED: &str = "\
    5041523115001544154415c78fd1ea0a1c150e1500150615061c000000020000000e01000000000000000000000000080000\
    000000000000000000000000001504192c35001806736368656d61150200150225021805636f756e7400160e191c191c2600\
    1c150219250600191805636f756e741500160e167616762608491c150015001502003c29061926000e0000001676160e2608\
    1676002820706172717565742d6370702d6172726f772076657273696f6e2032362e302e31191c1c00000082000000504152\
    31";

#[test]
fn a_page_that_its_checksum_does_not_fit_is_an_error() {
    let digits = CHECKED
        .as_bytes()
        .chunks(2)
        .map(|pair| str::from_utf8(pair).unwrap());
    let mut bytes: Vec<u8> = digits
        .map(|byte| u8::from_str_radix(byte, 16).unwrap())
        .collect();
    let said = |bytes: &[u8]| read(&Scratch::new("parquet", bytes)).map(|audit| audit.to_text());
    assert_eq!(
        said(&bytes).unwrap(),
        csv("count\n0\n0\n0\n8\n0\n0\n0\n").to_text()
    );
    // The count of 8 becomes one of 0.
    let at = bytes.iter().position(|byte| *byte == 8).unwrap();
    bytes[at] = 0;
    let text = said(&bytes).unwrap_or_else(|error| error.to_string());
    assert!(text.contains("checksum"), "{text}");
}

#[test]
fn lists_are_named() {
    let schema = "message trace { optional group position (LIST) { repeated group list { required double element; } } }";
    let schema = Arc::new(parse_message_type(schema).unwrap());
    let properties = Arc::new(WriterProperties::builder().build());
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, properties).unwrap();
    let mut group = writer.next_row_group().unwrap();
    let mut column = group.next_column().unwrap().unwrap();
    let values = column.typed::<DoubleType>();
    values
        .write_batch(&[0.5, 1.5], Some(&[2, 2]), Some(&[0, 1]))
        .unwrap();
    column.close().unwrap();
    group.close().unwrap();
    let path = Scratch::new("parquet", &writer.into_inner().unwrap());
    let error = read(&path).unwrap_err().to_string();
    assert!(
        error.contains("the column `position.list.element` holds lists, which are not read"),
        "{error}"
    );
}

#[test]
fn doubles_that_are_whole_ticks_apart_have_no_few_digits() {
    let scene = "[device]\nviscous = \"0.48 N s/m\"\ncoulomb = \"0.008 N\"\n[sampling]\nperiod = \"1 ms\"\n\
                 [encoder]\nresolution = \"0.25 mm\"\n[wall]\nstiffness = \"32 N/m\"\n";
    let at = (0..90).map(|i| f64::from(i * i % 7) * 0.25);
    let log = write(
        &[("x_mm", Column::Double(at.collect()))],
        Compression::UNCOMPRESSED,
    );
    let scene = Scene::from_toml("s", scene).unwrap();
    let audit = audit(&log, &scene, Options::default()).unwrap();
    let kinds: Vec<_> = audit.report().findings.iter().map(|it| it.kind).collect();
    assert_eq!(
        (audit.error(), &kinds[..]),
        (None, &["counted_positions"][..])
    );
}
