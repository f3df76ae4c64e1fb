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
