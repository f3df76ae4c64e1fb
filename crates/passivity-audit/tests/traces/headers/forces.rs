//! Columns of forces: the units that are weights, and those that no command may leave out.

use passivity_audit::{Options, audit_files};

use super::{audited, audited_on, proposed, refused, rotary, scene};
use crate::scratch::Scratch;

/// Three samples in which a force that is three times the wall's, with the other sign, is held.
fn log(force: &str, forces: [&str; 3]) -> String {
    let [first, second, third] = forces;
    format!("t [s],x [mm],{force}\n0,0,{first}\n0.001,0.1,{second}\n0.002,0.2,{third}\n")
}

#[test]
fn no_command_leaves_out_a_force_that_cannot_be_read() {
    for name in [
        "force [parsec]",
        "force [N m]",
        "Kraft (ADC) [V]",
        // Its unit says that it is a force, or a torque.
        "M [N m]",
    ] {
        let log = log(name, ["0", "1", "2"]);
        let error = refused(&log, None);
        assert_eq!(error.proposal, None, "{error}");
        assert!(error.to_string().contains("of the wall's law"), "{error}");
        // Nor where something else was told wrongly; who says so leaves it out.
        assert_eq!(proposed(&log, Some("x=posture [m]")), "");
        audited(&log, Some("t=t [s], x=x [mm]")).unwrap();
    }
    // Nor one without a number in each row.
    assert_eq!(proposed(&log("force [N]", ["0", "", "2"]), None), "");
    // Nor one that the header names, which is said beside the other columns.
    let error = refused("t [s],x_raw [mm],f [N m]\n0,0,0\n0.001,0,1\n", None);
    assert_eq!(error.proposal, None);
    assert!(
        error.to_string().contains("`f [N m]` cannot be read"),
        "{error}"
    );
    // Another force is read in its place.
    let log = "t [s],x [mm],force [V],F [N]\n0,0,0,0\n0.001,0.1,1,1\n";
    assert_eq!(proposed(log, None), "t=t [s], x=x [mm], f=F [N]");
}

/// A sensor of forces and torques is often called `ft`, which is no unit where it stands in a path.
#[test]
fn the_segments_of_a_path_before_the_quantity_are_no_units() {
    for (force, unit) in [
        ("robot/ft.force.x", "N"),
        ("/slider/ft.wrench.force.x", "N"),
        ("/robot/ft/force", "N"),
        ("/left_arm/ft_sensor/raw.wrench.force.x", "N"),
        ("/rpm_controller/force", "N"),
        ("/arm/force/ft/x", "N"),
        // Units where they can stand.
        ("/slider/force_mN.data", "mN"),
        ("/robot/ft.force_mN_cmd", "mN"),
    ] {
        let log = log(force, ["0", "0.1", "0.2"]);
        let columns = proposed(&log, None);
        assert_eq!(columns, format!("t=t [s], x=x [mm], f={force} [{unit}]"));
        let audit = audited(&log, Some(&columns)).unwrap();
        assert_eq!(audit.error(), None);
    }
    for (position, unit) in [
        ("/pos_mm.data", "mm"),
        ("/stage/ft/position", "m"),
        ("/stage_mm/position", "mm"),
        ("robot/sec/position_in", "in"),
    ] {
        let log = format!("t [s],{position}\n0,0.1\n0.001,0.2\n");
        let columns = format!("t=t [s], x={position} [{unit}]");
        assert_eq!(proposed(&log, None), columns);
        audited(&log, Some(&columns)).unwrap();
    }
    // A unit of something else where it can stand.
    let refused = refused(&log("/robot/force_mm", ["0", "1", "2"]), None);
    assert_eq!(refused.proposal, None, "{refused}");
}

#[test]
fn masses_in_the_place_of_a_force_are_their_weights() {
    let numbers = ["0", "150", "-30.5"];
    let report = |name: &str, columns: Option<&str>| {
        let text = log(name, numbers);
        let columns = columns.map_or_else(|| proposed(&text, None), str::to_owned);
        let audit = audited(&text, Some(&columns)).unwrap_or_else(|e| panic!("{columns}: {e}"));
        assert_eq!(audit.error(), None, "{columns}");
        let mut json = audit.to_json();
        json.as_object_mut().unwrap().remove("columns");
        json
    };
    for (weight, mass) in [("ozf", "oz"), ("lbf", "lb"), ("kgf", "kg"), ("gf", "g")] {
        let expected = report(&format!("force [{weight}]"), None);
        assert_eq!(report(&format!("force [{mass}]"), None), expected, "{mass}");
        assert_eq!(report(&format!("Force ({mass})"), None), expected, "{mass}");
        let told = format!("t=t [s], x=x [mm], f=force [{mass}]");
        assert_eq!(report("force", Some(&told)), expected, "{mass}");
    }
    // A bare mass of another name is no force.
    let json = audited(&log("load [kg]", numbers), None).unwrap().to_json();
    assert_eq!(json["not_read"], serde_json::json!(["load [kg]"]));
}

#[test]
fn masses_times_lengths_in_the_place_of_a_torque_are_weights_times_lengths() {
    let report = |unit: &str| {
        let log = format!("t [s],x [rad],{unit}\n0,0,0\n0.001,0.001,1.5\n0.002,0.002,-0.5\n");
        let columns = proposed_on_rotary(&log);
        let audit = audited_on(&rotary(), &log, Some(&columns)).unwrap();
        assert_eq!(audit.error(), None, "{columns}");
        let mut json = audit.to_json();
        json.as_object_mut().unwrap().remove("columns");
        json
    };
    let expected = report("torque [ozf in]");
    for unit in [
        "torque [oz in]",
        "torque (oz-in)",
        "torque [in*oz]",
        "M [oz.in]",
    ] {
        assert_eq!(report(unit), expected, "{unit}");
    }
    assert_eq!(report("torque [kg cm]"), report("torque [kgf cm]"));
    assert_eq!(report("torque [lb-ft]"), report("torque [ft lbf]"));
}

/// The columns that are proposed for a log of a rotary device.
fn proposed_on_rotary(log: &str) -> String {
    let error = audited_on(&rotary(), log, None).unwrap_err();
    let proposal = error.proposal.as_ref();
    proposal
        .unwrap_or_else(|| panic!("{log}: {error}"))
        .columns
        .clone()
}

#[test]
fn units_after_a_slash_or_a_comma_are_read() {
    let rows = "0,0,0\n0.001,0.001,1.5\n0.002,0.002,-0.5\n";
    for (header, columns) in [
        ("time/s,phi/rad,M/Nm", "t=time/s, x=phi/rad, f=M/Nm"),
        (
            "Zeit / s,Winkel / deg,M / (N m)",
            "t=Zeit / s, x=Winkel / deg, f=M / (N m)",
        ),
        (
            "\"time, s\",\"phi, rad\",\"M, Nm\"",
            "t=\"time, s\", x=\"phi, rad\", f=\"M, Nm\"",
        ),
        ("time/s,phi/rad,M/oz in", "t=time/s, x=phi/rad, f=M/oz in"),
    ] {
        let log = format!("{header}\n{rows}");
        assert_eq!(proposed_on_rotary(&log), columns);
        let audit = audited_on(&rotary(), &log, Some(columns)).unwrap();
        assert_eq!(audit.error(), None, "{columns}");
        assert_eq!(audit.to_json()["columns"], columns);
    }
    let report = |header: &str| {
        let audit = audited_on(&rotary(), &format!("{header}\n{rows}"), None);
        audit.unwrap_or_else(|e| panic!("{header}: {e}")).to_json()
    };
    assert_eq!(report("t/s,x/rad,f/Nm"), report("t [s],x [rad],f [N m]"));
}

#[test]
fn units_that_names_seem_to_give_are_proposed() {
    let log = |columns: [&str; 3]| format!("{}\n0,0,0\n0.001,0.001,1.5\n", columns.join(","));
    // That of the position of a linear device, and of its force.
    for (name, unit) in [
        ("pos_in", "in"),
        ("pos_inch", "inch"),
        ("pos_ft", "ft"),
        ("POS_MM", "mm"),
        ("POSITION [MM]", "mm"),
        ("pos", "m"),
        ("pos_raw", "m"),
    ] {
        let log = log(["t [s]", name, "f [N]"]);
        let columns = format!("t=t [s], x={name} [{unit}], f=f [N]");
        assert_eq!(proposed(&log, None), columns);
        assert_eq!(audited(&log, Some(&columns)).unwrap().error(), None);
    }
    for (name, unit) in [
        ("force_lb", "lb"),
        ("force_kg", "kg"),
        ("forceLbf", "lbf"),
        ("force_n", "N"),
        ("FORCE [MN ]", "MN"),
        ("Force_mn", "mN"),
    ] {
        let log = log(["t [s]", "x [m]", name]);
        let columns = match name.contains("MN") {
            true => "t=t [s], x=x [m], f=FORCE [MN ]".to_owned(),
            false => format!("t=t [s], x=x [m], f={name} [{unit}]"),
        };
        assert_eq!(proposed(&log, None), columns);
        assert_eq!(audited(&log, Some(&columns)).unwrap().error(), None);
    }
    for (name, unit) in [
        ("torque_ozin", "oz in"),
        ("torque_oz_in", "oz in"),
        ("torque [ozin]", "oz in"),
        ("torque_ncm", "Ncm"),
        ("torque_nm", "Nm"),
        ("torque_mnm", "mNm"),
        ("TORQUE [NM]", "Nm"),
        ("M [NM]", "Nm"),
        ("torque_lbft", "lb ft"),
        ("torque", "N m"),
    ] {
        let log = log(["TIME [S]", "ANGLE [RAD]", name]);
        let columns = format!("t=TIME [S] [s], x=ANGLE [RAD] [rad], f={name} [{unit}]");
        assert_eq!(proposed_on_rotary(&log), columns);
        let audit = audited_on(&rotary(), &log, Some(&columns)).unwrap();
        assert_eq!(audit.error(), None);
    }
    // Units of something else are not passed over.
    let log = log(["t [s]", "x [rad]", "torque_lb"]);
    let error = audited_on(&rotary(), &log, None).unwrap_err();
    assert_eq!(error.proposal, None);
    assert!(
        error
            .to_string()
            .contains("`lb` is no unit of a force like `N m`"),
        "{error}"
    );
    // A unit of the same letters is another where both measure the same.
    let log = "t [s],x [m],force [MN]\n0,0,0\n";
    let error = refused(log, Some("t=t [s], x=x [m], f=force [mN]")).to_string();
    assert!(error.contains("in `MN`, not in `mN`"), "{error}");
}

#[test]
fn how_many_digits_forces_have_does_not_depend_on_how_a_log_is_cut_into_files() {
    const HEADER: &str = "t [s],x [mm],f [N]\n";
    // In the first file no force has decimals.
    let first = "0.000,0,-0\n0.001,-0.1,0\n0.002,0.2,-0\n0.003,0.7,-1\n";
    let second = "0.004,0.9,-0.91500\n0.005,1.4,-1.39500\n";
    let whole = audited(&format!("{HEADER}{first}{second}"), None)
        .unwrap()
        .to_json();
    assert_eq!(whole["force"]["agrees"], false);
    let parts =
        [first, second].map(|rows| Scratch::new("csv", format!("{HEADER}{rows}").as_bytes()));
    let files = parts.each_ref().map(|file| file.to_path_buf());
    let mut cut = audit_files(&files, &scene(), Options::default())
        .unwrap()
        .to_json();
    cut.as_object_mut().unwrap().remove("files");
    assert_eq!(cut, whole);
}

#[test]
fn forces_that_are_called_by_their_unit_or_as_a_command_are_not_passed_over() {
    let forces = ["0.5", "-0.1", "0.25"];
    for name in [
        "T_q",
        "Tq",
        "Mz",
        "Fh",
        "load_cell",
        "ft_sensor",
        "u",
        "u_cmd",
        "cmd",
        "command",
        "control",
        "output",
        "pid_out",
        "par",
        "par_motor",
        "voima",
        "haptic_out",
        "/command.data",
        "/motor/cmd.data",
        "/haptic/u.data",
    ] {
        let columns = format!("t=t [s], x=x [mm], f={name} [N]");
        assert_eq!(proposed(&log(name, forces), None), columns);
        audited(&log(name, forces), Some(&columns)).unwrap();
        // What says more is meant where there are both.
        let both = format!("t [s],x [mm],{name},force [N]\n0,0,1,0\n0.001,0.1,0.5,0\n");
        let expected = "t=t [s], x=x [mm], f=force [N]";
        assert_eq!(proposed(&both, None), expected, "{name}");
    }
    for (name, unit) in [("N", "N"), ("mN", "mN")] {
        let columns = format!("t=t [s], x=x [mm], f={name} [{unit}]");
        assert_eq!(proposed(&log(name, forces), None), columns);
        audited(&log(name, forces), Some(&columns)).unwrap();
    }
    for unit in ["Nm", "mNm", "N m", "N.m"] {
        let log = log(unit, forces).replace("x [mm]", "x [rad]");
        let columns = format!("t=t [s], x=x [rad], f={unit} [{unit}]");
        assert_eq!(proposed_on_rotary(&log), columns);
        audited_on(&rotary(), &log, Some(&columns)).unwrap();
    }
    // Voltages and currents, motions, commands in words and the number of a row are none; nor are units of the scene's
    // other motion, flags, modes, and what stands in each row.
    let numbers = ["0", "1", "2"];
    for (name, values) in [
        ("u [V]", forces),
        ("cmd [A]", forces),
        ("pos_cmd [mm]", forces),
        ("command", ["start", "", "stop"]),
        ("N", numbers),
        ("Nm", forces),
        ("N", ["16", "16", "16"]),
        ("u", ["0.5", "0.5", "0.5"]),
        ("out", ["0", "0", "0"]),
        ("output", ["0", "1", "0"]),
        ("control", ["1", "1", "1"]),
        ("ctrl", ["2", "5", "3"]),
        ("cmd", ["-1", "1", "0"]),
    ] {
        audited(&log(name, values), None).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    let in_each = "t [s],x [rad],N\n0,0,16\n0.001,0.1,16\n0.002,0.2,16\n";
    audited_on(&rotary(), in_each, None).unwrap();
    // What only a command is called by is the force, or none.
    for (name, condition) in [("u", Some("`u` is no force")), ("f_cmd", None)] {
        let ways = refused(&log(name, forces), None)
            .proposal
            .unwrap()
            .otherwise;
        let conditions = ways.iter().map(|way| way.condition.as_str());
        assert_eq!(conditions.collect::<Vec<_>>(), Vec::from_iter(condition));
        let columns = ways.iter().map(|way| way.columns.as_str());
        let expected = condition.map(|_| "t=t [s], x=x [mm]");
        assert_eq!(columns.collect::<Vec<_>>(), Vec::from_iter(expected));
    }
    // Where no position is known, the force stands in what is to be filled in.
    let log = "tiempo_us,codificador,par_motor\n0,0,0.5\n1000,3,0.25\n2000,1,0\n";
    let error = refused(log, None).to_string();
    assert!(error.contains("count=NAME, f=par_motor [N]"), "{error}");
}
