//! What stored values mean by their types: numbers of all widths, decimals, clocks.

use std::path::Path;
use std::sync::Arc;

use parquet::data_type::{
    BoolType, ByteArray, ByteArrayType, DoubleType, FixedLenByteArray, FixedLenByteArrayType,
    FloatType, Int32Type, Int64Type, Int96, Int96Type,
};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use passivity_audit::{Audit, Options, TraceError, Values, audit, audit_columns, audit_csv};
use passivity_scene::Scene;

use super::read;
use crate::scratch::Scratch;

/// A value as it is stored, whatever its type says that it means.
enum Stored {
    Short(i32),
    Long(i64),
    Single(f32),
    Double(f64),
    Bytes(&'static [u8]),
    /// A day, and the nanoseconds in it.
    Day(u32, u64),
}

/// Writes columns of stored values, each with its field of the schema.
fn store(columns: &[(&str, Vec<Stored>)]) -> Scratch {
    let fields: String = columns
        .iter()
        .map(|(field, _)| format!("required {field};"))
        .collect();
    let schema = Arc::new(parse_message_type(&format!("message trace {{ {fields} }}")).unwrap());
    let properties = Arc::new(WriterProperties::builder().build());
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, properties).unwrap();
    let mut group = writer.next_row_group().unwrap();
    for (field, values) in columns {
        let mut column = group.next_column().unwrap().unwrap();
        for value in values {
            match value {
                Stored::Short(n) if field.starts_with("int32") => {
                    column
                        .typed::<Int32Type>()
                        .write_batch(&[*n], None, None)
                        .unwrap();
                }
                Stored::Short(n) => {
                    column
                        .typed::<BoolType>()
                        .write_batch(&[*n != 0], None, None)
                        .unwrap();
                }
                Stored::Long(n) => {
                    column
                        .typed::<Int64Type>()
                        .write_batch(&[*n], None, None)
                        .unwrap();
                }
                Stored::Single(x) => {
                    column
                        .typed::<FloatType>()
                        .write_batch(&[*x], None, None)
                        .unwrap();
                }
                Stored::Double(x) => {
                    column
                        .typed::<DoubleType>()
                        .write_batch(&[*x], None, None)
                        .unwrap();
                }
                Stored::Day(day, nanoseconds) => {
                    let words = [*nanoseconds as u32, (*nanoseconds >> 32) as u32, *day];
                    column
                        .typed::<Int96Type>()
                        .write_batch(&[Int96::from(words.to_vec())], None, None)
                        .unwrap();
                }
                Stored::Bytes(bytes) if field.starts_with("binary") => {
                    let value = ByteArray::from(bytes.to_vec());
                    column
                        .typed::<ByteArrayType>()
                        .write_batch(&[value], None, None)
                        .unwrap();
                }
                Stored::Bytes(bytes) => {
                    let value = FixedLenByteArray::from(ByteArray::from(bytes.to_vec()));
                    column
                        .typed::<FixedLenByteArrayType>()
                        .write_batch(&[value], None, None)
                        .unwrap();
                }
            };
        }
        column.close().unwrap();
    }
    group.close().unwrap();
    Scratch::new("parquet", &writer.into_inner().unwrap())
}

#[test]
fn types_mean_what_they_say() {
    use Stored::{Bytes, Long, Short};
    let positions = |audit: &Audit| {
        let rows = audit.to_json()["rows"].clone();
        let row = |name: &str| match &rows[0][name] {
            serde_json::Value::String(text) => text.clone(),
            range => range["lo"].as_str().unwrap().to_owned(),
        };
        [row("xi0"), row("xi1")]
    };
    let cases: [(&str, Vec<Stored>, [&str; 2]); 11] = [
        (
            "int32 count (INTEGER(32,false))",
            vec![Short(-1), Short(-2)],
            ["4294967295", "4294967294"],
        ),
        (
            "int32 count (UINT_8)",
            vec![Short(255), Short(3)],
            ["255", "3"],
        ),
        (
            "int32 count (INTEGER(8,true))",
            vec![Short(-5), Short(3)],
            ["-5", "3"],
        ),
        (
            "int64 xi (INTEGER(64,false))",
            vec![Long(-1), Long(7)],
            ["18446744073709551615", "7"],
        ),
        (
            "int32 xi (DECIMAL(9,3))",
            vec![Short(1250), Short(-500)],
            ["5/4", "-1/2"],
        ),
        (
            "int64 count (DECIMAL(18,2))",
            vec![Long(300), Long(-200)],
            ["3", "-2"],
        ),
        (
            "int64 xi (DECIMAL(18,2))",
            vec![Long(301), Long(-200)],
            ["301/100", "-2"],
        ),
        (
            "fixed_len_byte_array(3) xi (DECIMAL(6,1))",
            vec![Bytes(&[0xff, 0xff, 0xfb]), Bytes(&[0, 1, 0])],
            ["-1/2", "128/5"],
        ),
        (
            "binary xi (DECIMAL(30,2))",
            vec![Bytes(&[0x19]), Bytes(&[0xff, 0x38])],
            ["1/4", "-2"],
        ),
        (
            "binary xi (STRING)",
            vec![Bytes(b"1/3"), Bytes(b"2")],
            ["1/3", "2"],
        ),
        ("binary xi", vec![Bytes(b"1/3"), Bytes(b"2")], ["1/3", "2"]),
    ];
    for (field, values, expected) in cases {
        let path = store(&[(field, values)]);
        let audit = read(&path).unwrap();
        assert_eq!(audit.error(), None, "{field}");
        assert_eq!(positions(&audit), expected, "{field}");
    }
    for (field, values) in [
        ("int32 xi (DATE)", vec![Short(1), Short(2)]),
        ("boolean xi", vec![Short(1), Short(0)]),
        (
            "fixed_len_byte_array(2) xi (FLOAT16)",
            vec![Bytes(&[0, 0x3c])],
        ),
        ("fixed_len_byte_array(2) xi", vec![Bytes(&[0, 0x3c])]),
        ("binary xi (JSON)", vec![Bytes(b"1")]),
        ("int64 xi (TIMESTAMP(MICROS,true))", vec![Long(1), Long(2)]),
    ] {
        let path = store(&[(field, values)]);
        let error = match read(&path) {
            Err(error) => error,
            Ok(audit) => audit
                .error()
                .unwrap_or_else(|| panic!("{field}: it is read"))
                .clone(),
        };
        assert_eq!(
            (error.kind, error.column.as_deref()),
            ("type", Some("xi")),
            "{field}: {error}"
        );
    }
    // A count past 63 bits is none.
    let path = store(&[("int64 count (INTEGER(64,false))", vec![Long(-1), Long(0)])]);
    assert_eq!(read(&path).unwrap().error().unwrap().kind, "count");
}

/// A type that leaves out some whole numbers rounds a count past them to another.
#[test]
fn counts_that_their_type_may_have_rounded_are_refused() {
    use Stored::{Double, Single};
    let (single, double) = (16_777_216.0, 9_007_199_254_740_992.0);
    for (field, largest, next, bits) in [
        ("float count", Single(single - 1.0), Single(single), 24),
        ("double count", Double(double - 1.0), Double(-double), 53),
    ] {
        let path = store(&[(field, vec![largest, next])]);
        let error = read(&path).unwrap().error().unwrap().clone();
        let place = (error.kind, error.row, error.column.as_deref());
        assert_eq!(place, ("count", Some(2), Some("count")), "{error}");
        let says = format!("a whole number below 2^{bits}, from which on its type leaves out some");
        assert!(error.message.contains(&says), "{error}");
    }
    let scene = Scene::from_toml("s", "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n").unwrap();
    let counts = Values::Doubles(vec![double - 1.0, double]);
    let audit = audit_columns(
        vec![("count".to_owned(), counts)],
        &scene,
        Options::default(),
    )
    .unwrap();
    let error = audit.error().unwrap();
    assert_eq!((error.kind, error.row), ("count", Some(2)), "{error}");
}

/// Of a log with a clock, at a wall that is sampled a thousand times a second.
fn audited(path: &Path, columns: Option<&str>) -> Result<Audit, TraceError> {
    let scene = Scene::from_toml(
        "test",
        "[device]\nviscous = \"1 N s/m\"\n[sampling]\nperiod = \"1 ms\"\n[encoder]\nresolution = \"1 mm\"\n\
         [wall]\nstiffness = \"1 N/mm\"",
    );
    let mut options = Options::default();
    options.dialect.columns = columns.map(|text| text.parse().unwrap());
    audit(path, &scene.unwrap(), options)
}

#[test]
fn a_clock_has_the_unit_of_its_type() {
    use Stored::{Long, Short};
    let epoch = 1_700_000_000_000_000_i64;
    for (unit, times) in [
        (
            "TIMESTAMP(MILLIS,true)",
            [epoch / 1000, epoch / 1000 + 1, epoch / 1000 + 3],
        ),
        (
            "TIMESTAMP(MICROS,true)",
            [epoch, epoch + 1000, epoch + 3000],
        ),
        (
            "TIMESTAMP(NANOS,false)",
            [
                epoch * 1000,
                epoch * 1000 + 1_000_000,
                epoch * 1000 + 3_000_000,
            ],
        ),
        ("TIMESTAMP_MICROS", [epoch, epoch + 1000, epoch + 3000]),
    ] {
        let positions = || vec![Short(0), Short(1), Short(3)];
        let clock = times.map(Long).into_iter().collect();
        let fields = [
            format!("int64 t ({unit})"),
            "int32 pos (DECIMAL(9,4))".to_owned(),
        ];
        let path = store(&[(&fields[0], clock), (&fields[1], positions())]);
        // The name of the position is not understood; the proposal is.
        let error = audited(&path, None).unwrap_err();
        let proposal = error.proposal.unwrap();
        assert_eq!(proposal.columns, "t=t, x=pos [m]", "{unit}");
        let audit = audited(&path, Some(&proposal.columns)).unwrap();
        assert_eq!(uneven_and_missed(&audit), (1, 1), "{unit}");
        // A header may repeat the unit, not contradict it.
        let error = audited(&path, Some("t=t [s], x=pos [m]")).unwrap_err();
        assert_eq!(error.kind, "unit", "{error}");
        // And a clock is no torque.
        let error = audited(&path, Some("f=t [N], x=pos [m]")).unwrap_err();
        assert_eq!(error.kind, "type", "{error}");
    }
}

/// How many intervals were not of one period, and how many samples were missed.
fn uneven_and_missed(audit: &Audit) -> (u64, u64) {
    let timing = audit.report().timing.as_ref().unwrap();
    (timing.uneven, timing.missed_samples)
}

#[test]
fn a_day_with_its_nanoseconds_is_a_clock() {
    const DAY: u64 = 86_400_000_000_000;
    let clock = vec![
        Stored::Day(2_440_588, DAY - 1_000_000),
        Stored::Day(2_440_589, 0),
        Stored::Day(2_440_589, 2_000_000),
    ];
    let positions = [0, 1, 3].map(Stored::Long).into_iter().collect();
    let path = store(&[("int96 timestamp", clock), ("int64 count", positions)]);
    let error = audited(&path, None).unwrap_err();
    let columns = error.proposal.unwrap().columns;
    assert_eq!(columns, "t=timestamp, count=count");
    let audit = audited(&path, Some(&columns)).unwrap();
    assert_eq!(uneven_and_missed(&audit), (1, 1));
}

#[test]
fn a_stamp_in_two_columns_is_a_clock() {
    let long = |values: [i64; 3]| values.map(Stored::Long).into_iter().collect::<Vec<_>>();
    let stored = |nanoseconds: [i64; 3]| {
        store(&[
            ("int64 stamp.sec", long([7, 8, 8])),
            ("int64 stamp.nanosec", long(nanoseconds)),
            ("int64 count", long([0, 1, 3])),
        ])
    };
    let path = stored([999_000_000, 0, 2_000_000]);
    let columns = audited(&path, None).unwrap_err().proposal.unwrap().columns;
    assert_eq!(columns, "t=stamp.sec [s] + stamp.nanosec [ns], count=count");
    let audit = audited(&path, Some(&columns)).unwrap();
    assert_eq!(uneven_and_missed(&audit), (1, 1));
    let audit = audited(&stored([0, 1, 1_000_000_000]), Some(&columns)).unwrap();
    let error = audit.error().unwrap();
    assert_eq!((error.kind, error.row), ("split_time", Some(3)));
}

#[test]
fn a_force_is_not_left_out_among_many_columns_or_for_its_type() {
    let names: Vec<String> = (0..100).map(|i| format!("int64 c{i}")).collect();
    let mut columns: Vec<(&str, Vec<Stored>)> = Vec::new();
    for name in &names {
        columns.push((name, vec![Stored::Long(0), Stored::Long(0)]));
    }
    columns.push(("int64 count", vec![Stored::Long(0), Stored::Long(1)]));
    for (force, values, says) in [
        (
            "int64 force",
            vec![Stored::Long(1), Stored::Long(1)],
            "the column `force` is not read under this name",
        ),
        (
            "boolean force",
            vec![Stored::Short(1), Stored::Short(0)],
            "the column `force` cannot be read (row 1 has no number there)",
        ),
    ] {
        columns.push((force, values));
        let path = store(&columns);
        let error = read(&path).unwrap_err();
        assert!(error.to_string().contains(says), "{error}");
        columns.pop();
    }
}

/// Forces of the wall to a thousandth of a mN m, whatever they are stored as: none of them is the law's but for that.
#[test]
fn forces_are_compared_within_half_a_unit_of_what_their_type_says() {
    use Stored::{Bytes, Long, Short};
    let motor = "[device]\ninertia = \"2e-5 kg m^2\"\nviscous = \"4e-5 N m s/rad\"\ncoulomb = \"3e-3 N m\"\n\
                 [sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 4096\n\
                 [wall]\nstiffness = \"0.5 N m/rad\"\n[operator]\nmax_speed = \"3 rad/s\"\n";
    let scene = Scene::from_toml("test", motor).unwrap();
    let options = || {
        let mut options = Options::default();
        options.dialect.columns = Some("count=count, f=f [mN m]".parse().unwrap());
        options
    };
    let counts = [0, 1, 2, 3, 4, 3, 2, 1];
    let in_units = |unit: f64| counts.map(|n| law(n, unit));
    let of_csv = |forces: [String; 8]| {
        let rows = counts.iter().zip(forces).map(|(n, f)| format!("{n},{f}\n"));
        let text = format!("count,f\n{}", rows.collect::<String>());
        audit_csv(Box::new(std::io::Cursor::new(text)), &scene, options()).unwrap()
    };
    let thousandths = in_units(1e-3);
    let csv = of_csv(thousandths.map(|n| format!("{:.3}", f64::from(n) * 1e-3)));
    assert!(csv.report().force.as_ref().unwrap().agrees);
    let shortest = of_csv(thousandths.map(|n| (f64::from(n) * 1e-3).to_string()));
    let whole = of_csv(in_units(1.0).map(|n| n.to_string()));
    assert_eq!(whole.report().force.as_ref().unwrap().mismatches, 0);
    let text = |n: f64, decimals: Option<usize>| {
        let text = decimals.map_or_else(|| n.to_string(), |k| format!("{n:.k$}"));
        Bytes(text.leak().as_bytes())
    };
    let bytes = |n: i32| Bytes(n.to_be_bytes().to_vec().leak());
    let fixed = |n: i32| text(f64::from(n) * 1e-3, Some(3));
    let cases: [(&str, [Stored; 8], &Audit); 9] = [
        ("int32 f (DECIMAL(8,3))", thousandths.map(Short), &csv),
        (
            "int64 f (DECIMAL(18,3))",
            thousandths.map(|n| Long(n.into())),
            &csv,
        ),
        (
            "fixed_len_byte_array(4) f (DECIMAL(8,3))",
            thousandths.map(bytes),
            &csv,
        ),
        ("binary f (DECIMAL(8,3))", thousandths.map(bytes), &csv),
        ("binary f (STRING)", thousandths.map(fixed), &csv),
        (
            "binary f",
            thousandths.map(|n| text(f64::from(n) * 1e-3, None)),
            &shortest,
        ),
        ("int32 f", in_units(1.0).map(Short), &whole),
        ("int64 f", in_units(1.0).map(|n| Long(n.into())), &whole),
        (
            "int64 f (DECIMAL(18,0))",
            in_units(1.0).map(|n| Long(n.into())),
            &whole,
        ),
    ];
    for (field, forces, csv) in cases {
        let path = store(&[
            ("int32 count", counts.map(Short).into_iter().collect()),
            (field, forces.into_iter().collect()),
        ]);
        let audit = audit(&path, &scene, options()).unwrap();
        assert_eq!(audit.to_json(), csv.to_json(), "{field}");
    }
    let columns = [("count", counts), ("f", in_units(1.0))];
    let columns = columns.map(|(name, values)| {
        (
            name.to_owned(),
            Values::Whole(values.map(i64::from).to_vec()),
        )
    });
    let audit = audit_columns(columns.into_iter().collect(), &scene, options()).unwrap();
    assert_eq!(audit.to_json(), whole.to_json());
}

/// The force of a wall of 0.5 N m/rad at a count of 4096 in a revolution, in multiples of so many mN m.
fn law(count: i32, unit: f64) -> i32 {
    let tick = 500.0 * std::f64::consts::TAU / 4096.0;
    (-tick * (f64::from(count) + 0.5) / unit).round() as i32
}
