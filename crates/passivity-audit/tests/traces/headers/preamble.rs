//! Text before the header, and names behind it that are of no column.

use super::{audited, refused};

/// What LabVIEW writes before the names.
const LVM: &str = "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t.\n\
    Multi_Headings\tNo\nX_Columns\tOne\nTime_Pref\tAbsolute\nOperator\tlab\nDate\t2026/11/22\n\
    Time\t10:22:33.1234567\n***End_of_Header***\t\n\t\nChannels\t2\t\nSamples\t1000\t1000\nDate\t2026/11/22\t2026/11/22\n\
    Time\t10:22:33.12\t10:22:33.12\nY_Unit_Label\tVolts\tVolts\nX_Dimension\tTime\tTime\nX0\t0.0E+0\t0.0E+0\n\
    Delta_X\t0.001\t0.001\n***End_of_Header***\t\t\n";

#[test]
fn the_line_of_the_names_is_said_where_text_stands_before_it() {
    for (text, number, names) in [
        (
            format!("{LVM}X_Value\tPosition\tForce\tComment\n0\t0\t0\n0.001\t1\t0\n"),
            23,
            "X_Value\\tPosition\\tForce\\tComment",
        ),
        (
            "Messung 7 vom 22.11.2026\n\nZeit [s];Weg [mm]\n0;0\n0,001;0,5\n".to_owned(),
            3,
            "Zeit [s];Weg [mm]",
        ),
        // A torn line of a serial port.
        (
            "34,0.5\ntime,pos,effort\n0,0,0\n0.001,0,0\n".to_owned(),
            2,
            "time,pos,effort",
        ),
        (
            "os,effort\ntime,pos,effort\n0,0,0\n0.001,0,0\n".to_owned(),
            2,
            "time,pos,effort",
        ),
        (
            "# recorded by hand\nroot: bench\nt,x,f\ns,mm,N\n0,0,0\n".to_owned(),
            3,
            "t,x,f",
        ),
        (
            "bench\ntime,pos\n2026-11-22 10:00:00.5,0.5\n2026-11-22 10:00:00.6,0.5\n".to_owned(),
            2,
            "time,pos",
        ),
    ] {
        let error = refused(&text, None);
        let says =
            format!("the names of the columns seem to stand in line {number}, `{names}`: remove");
        assert!(error.message.contains(&says), "{text}: {error}");
        assert_eq!(error.proposal, None, "{error}");
        // What it says to do helps.
        let marked = text
            .lines()
            .enumerate()
            .map(|(i, line)| match i + 1 < number {
                true => format!("#{line}\n"),
                false => format!("{line}\n"),
            });
        let again = audited(&marked.collect::<String>(), None).err();
        let again = again.map_or_else(String::new, |error| error.to_string());
        assert!(!again.contains("seem to stand in line"), "{again}");
    }
}

#[test]
fn names_of_no_field_are_to_be_taken_out_of_the_header() {
    let last = "take the last name, with what stands before it, out of the header";
    for (names, says) in [
        ("X_Value,Position,Comment", last),
        ("X_Value,Position,", last),
        ("X_Value,Position,,", "take the last 2 names"),
    ] {
        let error = refused(&format!("{names}\n0,0\n0.001,1\n"), None);
        assert!(error.message.contains(says), "{error}");
    }
    let audit = audited("t [s],x [mm],Comment\n0,0\n0.001,1\n", None).unwrap();
    let error = audit.error().unwrap().to_string();
    assert!(error.contains(last), "{error}");
    // Others may be of fields that were lost.
    let error = refused("X_Value,Position,effort\n0,0\n0.001,1\n", None);
    assert!(!error.message.contains("out of the header"), "{error}");
}

#[test]
fn text_in_another_encoding_is_said_to_be_converted() {
    let text = b"Zeit [s],Winkel [\xb0]\n0,0\n".to_vec();
    let input = Box::new(std::io::Cursor::new(text));
    let error =
        passivity_audit::audit_csv(input, &super::scene(), passivity_audit::Options::default());
    let error = error.unwrap_err().to_string();
    let says =
        "the header is not UTF-8 text: convert the log, as with `iconv -f WINDOWS-1252 -t UTF-8 ";
    assert!(error.contains(says), "{error}");
}

#[test]
fn what_stands_around_numbers_is_shown_with_the_way_to_take_it_away() {
    for (log, says) in [
        (
            "12:34:56.000 -> 0,0,-0.38\n12:34:56.001 -> 1010,0,-0.38\n",
            "`12:34:56.001 -> 1010,0,-0.38`: take that away, as with `sed 's/^[0-9:.]* -> //'`",
        ),
        (
            "t [us],count,f [mN]\n12:34:56.000 -> 0,0,-0.38\n12:34:56.001 -> 1010,0,-0.38\n",
            "`12:34:56.000 -> 0,0,-0.38`: take that away",
        ),
        (
            "t:0,count:0,torque:-0.0004\nt:1010,count:0,torque:-4e-4\n",
            "`sed -e '1{h;s/:[-+.0-9eE]*//g;p;g;}' -e 's/[A-Za-z_][A-Za-z_0-9]*://g'`",
        ),
        (
            "t [us],count,f [mN]\nt:0,count:0,torque:-0.0004\n",
            "`sed -e '1!s/[A-Za-z_][A-Za-z_0-9]*://g'`",
        ),
        (
            "secs,name,position,effort\n0,['knob'],[0.12],[0.1]\n0.001,['knob'],[0.13],[0.1]\n",
            "`position` cannot be read: row 1 has no number there but `[0.12]`, a list: where each has one number, take the brackets \
             away behind the first line, as with `sed '1!s/[][]//g'`",
        ),
        (
            "Time,x [mm]\n0.000000 sec,0\n0.001010 sec,0\n",
            "row 1 has no number there but `0.000000 sec`, with a unit that belongs into the name of the column: take it away, as \
             with `sed 's/ sec//'`",
        ),
        (
            "1700000000,123000000,,knob,0,0,0\n1700000000,124000000,,knob,0.001,1,-0.0005\n",
            "as `column1,column2,column3,column4,column5,column6,column7`, and in place of three of these names `t [s]` for the \
             column with the times, `count` or `x [mm]` for that with the positions and `f [N]` for that with the forces",
        ),
    ] {
        let error = refused(log, None);
        assert!(error.message.contains(says), "{error}");
        assert_eq!(error.proposal, None, "{error}");
    }
    let coarse = audited("t [ms],count\n0,0\n1,0\n1,1\n", None).unwrap();
    let says = "expected a time after 1, found 1 (a clock that stands still between two rows is too coarse: log a finer one";
    assert!(coarse.error().unwrap().to_string().contains(says));
}
