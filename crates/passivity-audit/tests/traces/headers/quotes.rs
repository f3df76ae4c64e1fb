//! Fields in quotes: names with quotes of their own, and numbers with a comma.

use passivity_audit::{Audit, Dialect, Options, audit_csv};

use super::{as_proposed, audited, refused, scene};

#[test]
fn a_quote_that_is_written_twice_in_quotes_is_one() {
    for (name, columns, unit) in [
        ("\"pos \"\"a\"\" [mm]\"", "\"pos \"\"a\"\" [mm]\"", ""),
        ("\"pos \"\"a\"\"\"", "\"pos \"\"a\"\"\"", " [m]"),
        ("pos \"a\" [mm]", "\"pos \"\"a\"\" [mm]\"", ""),
        ("\"pos 5\"\", left\"", "\"pos 5\"\", left\"", " [m]"),
        ("\"pos [mm]\"", "pos [mm]", ""),
    ] {
        let log = format!("time,{name},f [N]\n0,0,0\n0.001,0,1\n");
        let expected = format!("t=time [s], x={columns}{unit}, f=f [N]");
        let (proposed, audit) = as_proposed(&log);
        assert_eq!(proposed, expected);
        assert_eq!(audit.to_json()["columns"], expected);
        let told: passivity_audit::Columns = expected.parse().unwrap();
        assert_eq!(told.to_string(), expected);
    }
    let log = "t,\"say \"\"x\"\"\"\ns,mm\n0,0\n0.001,1\n";
    let told = "t=t, x=\"say \"\"x\"\"\"";
    assert!(audited(log, Some(told)).is_ok());
    assert!("x=\"pos \"\"".parse::<passivity_audit::Columns>().is_err());
}

/// By the columns and signs that are proposed for it.
fn read_as_proposed(log: &str) -> Audit {
    let error = refused(log, None);
    let proposal = error.proposal.as_ref().unwrap_or_else(|| panic!("{error}"));
    let dialect = Dialect {
        columns: Some(proposal.columns.parse().unwrap()),
        delimiter: proposal.delimiter.map(|c| u8::try_from(c).unwrap()),
        decimal_comma: proposal.decimal_comma,
    };
    let options = Options {
        dialect,
        ..Options::default()
    };
    let input = Box::new(std::io::Cursor::new(log.as_bytes().to_vec()));
    audit_csv(input, &scene(), options).unwrap()
}

#[test]
fn numbers_with_a_comma_stand_in_quotes_between_commas() {
    let log = "time [s],pos [mm],force [N]\n\"0,000\",\"0,25\",\"1\"\n\"0,001\",\"-0,5\",\"2,5\"\n";
    let points = "time [s],pos [mm],force [N]\n0.000,0.25,1\n0.001,-0.5,2.5\n";
    let audit = read_as_proposed(log);
    assert_eq!(audit.error(), None);
    assert_eq!(audit.to_json(), as_proposed(points).1.to_json());
    // What stands outside of quotes is apart.
    let rows = format!("{log}0,002,0,25,1\n");
    let error = read_as_proposed(&rows).error().unwrap().to_string();
    assert!(
        error.contains("found 5 (numbers with commas stand in quotes"),
        "{error}"
    );
    // These may be thousands.
    let thousands = "time [ms],pos [um]\n\"1,000\",\"1,250\"\n\"1,001\",\"1,000\"\n";
    assert_eq!(refused(thousands, None).proposal, None);
}

/// Of a log whose numbers may be thousands or decimals, the error says both, and what to do about each.
#[test]
fn a_comma_or_a_point_that_may_stand_between_thousands_is_not_taken_for_a_decimal_sign() {
    let comma = |options: &str| {
        format!(
            "`1,700`: `,` cannot stand here in a number (is the comma a decimal sign? then add {options}; if it stands \
             between thousands, write the numbers without it)"
        )
    };
    let [quoted, bare] = ["--delimiter ',' --decimal-comma", "--decimal-comma"].map(comma);
    let point = |number: &str| {
        format!(
            "`{number}`: with --decimal-comma a point is neither a decimal sign nor read between thousands: write"
        )
    };
    let [thousand, both] = ["1.700", "1.700,5"].map(point);
    let german = Dialect {
        decimal_comma: true,
        ..Dialect::default()
    };
    let tabs = Dialect {
        delimiter: Some(b'\t'),
        ..Dialect::default()
    };
    let usual = Dialect::default();
    // In a row, and in a header that is not understood.
    for (log, dialect, says) in [
        ("t [ms],x [um]\n0,\"1,700\"\n1,\"2,300\"\n", &usual, &quoted),
        (
            "time [ms],pos [um]\n0,\"1,700\"\n1,\"2,300\"\n",
            &usual,
            &quoted,
        ),
        ("t [ms]\tx [um]\n0\t1,700\n1\t2,300\n", &tabs, &bare),
        ("time [ms]\tpos [um]\n0\t1,700\n1\t2,300\n", &usual, &bare),
        ("time [ms];pos [um]\n0;1,700\n1;2,300\n", &usual, &bare),
        ("t [ms];x [um]\n0,0;1.700\n1,0;2.300\n", &german, &thousand),
        ("t [ms];x [um]\n0,0;1.700,5\n1,0;2.300,0\n", &german, &both),
        (
            "time [ms];pos [um]\n0,0;1.700\n1,0;2.300\n",
            &german,
            &thousand,
        ),
        (
            "time [ms];pos [um]\n0,0;1.700\n1,0;2.300\n",
            &usual,
            &thousand,
        ),
        (
            "t [ms];count;f [N]\n0,0;1;1.700\n1,0;2;1\n",
            &german,
            &thousand,
        ),
    ] {
        let options = Options {
            dialect: dialect.clone(),
            ..Options::default()
        };
        let input = Box::new(std::io::Cursor::new(log.as_bytes().to_vec()));
        let error = match audit_csv(input, &scene(), options) {
            Ok(audit) => audit.error().unwrap().clone(),
            Err(error) => error,
        };
        assert!(error.to_string().contains(&**says), "{log}: {error}");
        assert_eq!(error.proposal, None, "{log}");
    }
}
