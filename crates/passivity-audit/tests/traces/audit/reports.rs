//! What a report carries of a short log.

use passivity_audit::{Options, audit_csv};

use super::{scene, three_fifths};

#[test]
fn a_report_may_leave_its_rows_out_and_nothing_else() {
    let pi = "[device]\ninertia = \"6e-6 kg m^2\"\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nrate = \"1 kHz\"\n\
              [encoder]\ncounts_per_revolution = 4096\n[wall]\nstiffness = \"1 N m/rad\"\n";
    let logs = [
        (three_fifths(), "xi\n1\n1/2\n-1\n"),
        (
            scene(pi),
            "x [rad],f [N m]\n0.01,-0.01\n0.02,-0.02\n0.015,-0.01\n",
        ),
    ];
    for (scene, csv) in logs {
        let report = |without_rows: bool| {
            let input = Box::new(std::io::Cursor::new(csv.as_bytes().to_vec()));
            let options = Options {
                without_rows,
                ..Options::default()
            };
            serde_json::to_value(audit_csv(input, &scene, options).unwrap().report()).unwrap()
        };
        let (whole, mut without) = (report(false), report(true));
        assert_eq!(whole["rows"].as_array().unwrap().len(), 2);
        assert!(without["rows"].is_null());
        without["rows"] = whole["rows"].clone();
        assert_eq!(whole, without);
    }
}

#[test]
fn a_report_says_first_that_no_force_was_read() {
    let text = |csv: &str, law: bool| {
        let input = Box::new(std::io::Cursor::new(csv.as_bytes().to_vec()));
        let options = Options {
            law,
            ..Options::default()
        };
        let audit = audit_csv(input, &three_fifths(), options).unwrap();
        let text = audit.to_text();
        let line = text
            .lines()
            .find_map(|line| line.strip_prefix("  account "));
        (line.map(|line| line.trim().to_owned()), text)
    };
    let (line, whole) = text("xi\n1\n1/2\n-1\n", false);
    let says = "of the wall's own law, as no force is read";
    assert_eq!(line.as_deref(), Some(says), "{whole}");
    assert!(whole.lines().nth(2).unwrap().ends_with(says), "{whole}");
    let with_force = "xi,f\n1,-1\n1/2,-1/2\n-1,1\n";
    let applied = Some("of the force in the trace".to_owned());
    assert_eq!(text(with_force, false).0, applied);
    // Of forces that are read and not asked for another line says that they are compared.
    assert_eq!(text(with_force, true).0, None);
}
