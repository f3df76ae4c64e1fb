//! Units that are not read, and columns of something else than motions and forces.

use super::{audited, audited_on, proposed, refused, rotary};

const ROWS: &str = "0,0,7.5\n0.001,0.3,7.5\n0.002,1.2,7.25\n0.003,0.4,7.5\n";

#[test]
fn no_unit_is_assumed_where_a_name_has_one_that_is_not_read() {
    for name in [
        "angle (foo)",
        "x (µrad/foo)",
        "angle (Grad)",
        "angle (foo) raw",
        "x [µrad/foo]",
        "Position [Umdr.]",
    ] {
        let log = format!("t [s],{name},aux\n{ROWS}");
        let error = audited_on(&rotary(), &log, None).unwrap_err();
        assert_eq!(error.proposal, None, "{error}");
        // Who writes it is believed.
        audited_on(&rotary(), &log, Some(&format!("t=t [s], x={name} [rad]"))).unwrap();
    }
    for (header, columns) in [
        ("time (jiffies),x [mm],aux", ""),
        ("time (local),x [mm],aux", "t=time (local) [s], x=x [mm]"),
        ("Zeit (Sekunden),x [mm],aux", "t=Zeit (Sekunden), x=x [mm]"),
        ("t [s],x [mm],force (foo)", ""),
        (
            "t [s],x [mm],force (motor side)",
            "t=t [s], x=x [mm], f=force (motor side) [N]",
        ),
        (
            "t [s],Position (mètres),aux",
            "t=t [s], x=Position (mètres)",
        ),
        ("t [s],pos (filtered),aux", "t=t [s], x=pos (filtered) [m]"),
        ("t [s],pos_metros,aux", "t=t [s], x=pos_metros"),
    ] {
        assert_eq!(
            proposed(&format!("{header}\n{ROWS}"), None),
            columns,
            "{header}"
        );
    }
    for name in [
        "angle (degrés)",
        "Ángulo [grados]",
        "x (Gradi)",
        "angle (radianes)",
    ] {
        let log = format!("t [s],{name},aux\n{ROWS}");
        let columns = match audited_on(&rotary(), &log, None) {
            Err(error) => error.proposal.unwrap().columns,
            Ok(audit) => audit.to_json()["columns"].to_string(),
        };
        assert!(!columns.contains("[rad]"), "{columns}");
    }
    let log = format!("t [s],angle_grados,aux\n{ROWS}");
    let error = audited_on(&rotary(), &log, None).unwrap_err();
    assert_eq!(error.proposal.unwrap().columns, "t=t [s], x=angle_grados");
}

#[test]
fn columns_of_something_else_are_neither_proposed_nor_refused() {
    for name in [
        "voltage (V)",
        "Vbus (V)",
        "Vbus_V",
        "bat [V]",
        "u_motor (V)",
        "v (V)",
        "current (A)",
        "Tmotor [°C]",
        "Tmot",
        "Tout",
        "fact",
        "momentum",
        "force_enabled",
        "effort_limit",
        "f (Hz)",
        "f [Hz]",
        "speed (%)",
        "q (W)",
    ] {
        let audit = audited(&format!("t [s],x [mm],{name}\n{ROWS}"), None);
        let audit = audit.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(audit.to_json()["not_read"], serde_json::json!([name]));
    }
    // Nor are they clocks, and what is called a force is not passed over for the unit of its signal.
    let rows: String = (0..20).map(|i| format!("{i}.5,{}\n", i % 5)).collect();
    audited(&format!("temperature (C),count\n{rows}"), None).unwrap();
    for name in [
        "force (V)",
        "torque [A]",
        "Kraft (%)",
        "Tmotor (C)",
        "force_mV",
        "motor_force_mA",
        "force %",
        "force_pct",
    ] {
        let log = format!("t [s],x [mm],{name}\n{ROWS}");
        let error = refused(&log, None);
        assert_eq!(error.proposal, None, "{error}");
        // Nor where it is named without a unit.
        let error = refused(&log, Some(&format!("t=t [s], x=x [mm], f=\"{name}\"")));
        assert_eq!(error.proposal, None, "{error}");
    }
    // A letter behind a name may be the label of an axis: no position is proposed with the force of another one.
    for [first, second] in [["A", "B"], ["U", "V"], ["V", "W"]] {
        let log = format!(
            "t [s],x_{first} [mm],x_{second} [mm],F_{first},F_{second}\n0,0,0,1,2\n0.001,0.3,0.1,1,2\n"
        );
        let columns = refused(&log, None).proposal.unwrap().columns;
        assert_eq!(
            columns,
            format!("t=t [s], x=x_{first} [mm], f=F_{first} [N]")
        );
    }
}
