//! Units: in a line of their own, anywhere in a name, and in words.

use passivity_scene::Scene;

use super::{audited, audited_on, proposed, refused, rotary, scene};
use crate::scratch::Scratch;
use passivity_audit::{Options, audit_files};

const ROWS: &str = "0,0,0\n0.001,0.3,-0.9\n0.002,1.2,-3.6\n0.003,0.4,-1.2\n";

#[test]
fn a_line_of_units_may_not_contradict_the_header() {
    for (names, units, column) in [
        ("t,x_m,f", "s,mm,N", "x_m"),
        ("t [s],x [m],f [N]", "s,mm,N", "x [m]"),
        ("t,x,f [N]", "s,mm,mN", "f [N]"),
        ("t [ms],x,f", "s,mm,N", "t [ms]"),
    ] {
        let error = refused(&format!("{names}\n{units}\n{ROWS}"), None);
        assert!(
            error
                .to_string()
                .starts_with(&format!("column `{column}`: its name has the unit")),
            "{error}"
        );
    }
    let same = audited(&format!("t [s],x [mm],f\nseconds,mm,N\n{ROWS}"), None).unwrap();
    let expected = audited(&format!("t [s],x [mm],f [N]\n{ROWS}"), None).unwrap();
    assert_eq!(same.to_text(), expected.to_text());
    // Nor that of a file that goes on with the log.
    let header = "t [s],x [mm],f [N]\n";
    let files = [format!("{header}{ROWS}"), format!("{header}s,um,N\n{ROWS}")]
        .map(|text| Scratch::new("csv", text.as_bytes()));
    let files = files.each_ref().map(|file| file.to_path_buf());
    let audit = audit_files(&files, &scene(), Options::default()).unwrap();
    let error = audit.error().unwrap().to_string();
    assert!(
        error.contains("its name has the unit `mm`, and the line after it `um`"),
        "{error}"
    );
}

#[test]
fn a_line_of_units_may_have_others_for_columns_that_are_not_read() {
    let expected = audited(&format!("t [s],x [mm],f [N]\n{ROWS}"), None)
        .unwrap()
        .to_json();
    let rows = ROWS.replace('\n', ",7\n");
    for other in ["V", "%", "°C", "n/a", "text", "1", "[A]", "", "-"] {
        let audit = audited(&format!("t,x,f,aux\ns,mm,N,{other}\n{rows}"), None).unwrap();
        assert_eq!(
            audit.to_json()["dissipated_lower"],
            expected["dissipated_lower"],
            "{other}"
        );
        assert_eq!(audit.to_json()["intervals"], 3, "{other}");
    }
    // A row with text is none.
    let error = refused("t,x,f\ns,2,N\n0,0,0\n", None);
    assert!(
        error.to_string().contains("`t` is given without a unit") || error.kind == "unit",
        "{error}"
    );
}

#[test]
fn units_anywhere_in_a_name_are_proposed() {
    for (name, unit) in [
        ("x [mm] raw", "mm"),
        ("Position [mm] (raw)", "mm"),
        ("x (mm) joint 1", "mm"),
        ("pos_mm_raw", "mm"),
        ("pos_mm_filt", "mm"),
        ("position in world", "m"),
        ("pos millimeters", "mm"),
        ("pos inches", "in"),
    ] {
        let found = proposed(&format!("t [s],{name},f [N]\n{ROWS}"), None);
        assert_eq!(found, format!("t=t [s], x={name} [{unit}], f=f [N]"));
    }
    // In brackets and behind an underscore they are read.
    for unit in [
        "microns",
        "inches",
        "millimeters",
        "millimetres",
        "centimetres",
    ] {
        for name in [
            format!("pos_{unit}"),
            format!("pos [{unit}]"),
            format!("pos ({unit})"),
        ] {
            let found = proposed(&format!("t [s],{name},f [N]\n{ROWS}"), None);
            assert_eq!(found, format!("t=t [s], x={name}, f=f [N]"));
        }
    }
    for (name, unit) in [
        ("f [mN] (cmd)", "mN"),
        ("force_mN_cmd", "mN"),
        ("force_grams", "g"),
        ("force milliNewton", "mN"),
    ] {
        let found = proposed(&format!("t [s],x [mm],{name}\n{ROWS}"), None);
        assert_eq!(found, format!("t=t [s], x=x [mm], f={name} [{unit}]"));
    }
}

#[test]
fn nothing_is_proposed_for_units_that_are_not_read() {
    for (name, says) in [
        ("pos_100um", "a number stands before its unit, `um`"),
        ("pos_0.1mm", "a number stands before its unit, `mm`"),
        ("position_mils", "`mil` is no unit of a position like `m`"),
        ("x [N] raw", "`N` is no unit of a position like `m`"),
        ("pos_Grad", "`grad` is no unit of a position like `m`"),
        (
            "x [Grad]",
            "`Grad` may be degrees or gradians: write `deg` or `gon`",
        ),
        (
            "pos [Grad]",
            "`Grad` may be degrees or gradians: write `deg` or `gon`",
        ),
        ("pos [Mmm]", "unknown unit `Mmm`"),
    ] {
        let error = refused(&format!("t [s],{name},f [N]\n{ROWS}"), None);
        assert_eq!(error.proposal, None, "{error}");
        assert!(error.to_string().contains(says), "{error}");
    }
}

#[test]
fn units_in_cyrillic_letters_are_read() {
    let expected = audited(&format!("t [s],x [mm],f [N]\n{ROWS}"), None).unwrap();
    let audit = audited(&format!("t [с],x [мм],f [Н]\n{ROWS}"), None).unwrap();
    assert_eq!(audit.to_json(), expected.to_json());
    for (name, columns) in [
        ("время (мс)", "t=время (мс), x=x [mm]"),
        ("время_мс", "t=время_мс, x=x [mm]"),
        ("время, мс", "t=\"время, мс\", x=x [mm]"),
    ] {
        let log = format!("\"{name}\",x [mm]\n0,0\n1,1\n");
        assert_eq!(proposed(&log, None), columns);
    }
}

/// The columns that are proposed on a rotary device, or else why none are.
fn proposed_of_turning(name: &str) -> Result<String, String> {
    let log = format!("Zeit [s],{name}\n0,0\n0.001,-2.8125\n0.002,0\n0.003,-2.8125\n");
    let error = audited_on(&rotary(), &log, None).unwrap_err();
    let proposal = error.proposal.map(|proposal| proposal.columns);
    proposal.ok_or(error.message)
}

/// Degrees were taken for radians, and a log that fails held.
#[test]
fn signs_of_units_are_seen_wherever_they_stand() {
    for name in [
        "Winkel °",
        "phi°",
        "Winkel in °",
        "angle °",
        "°Winkel",
        "angle º",
        "phi ˚",
        "pos_°_raw",
        "deg angle",
        "angle in deg",
        "angle degrees",
    ] {
        let columns = format!("t=Zeit [s], x={name} [deg]");
        assert_eq!(proposed_of_turning(name), Ok(columns));
    }
    assert_eq!(
        proposed_of_turning("phi µrad"),
        Ok("t=Zeit [s], x=phi µrad [urad]".to_owned())
    );
    for name in ["Weg µm", "Weg in µm", "pos \u{3bc}m", "Wegµm", "µm Weg"] {
        let found = proposed(&format!("t [s],{name},f [N]\n{ROWS}"), None);
        assert_eq!(found, format!("t=t [s], x={name} [um], f=f [N]"));
    }
    let found = proposed(&format!("t [s],x [mm],Kraft µN\n{ROWS}"), None);
    assert_eq!(found, "t=t [s], x=x [mm], f=Kraft µN [uN]");
}

#[test]
fn units_in_words_are_not_taken_for_others() {
    for (name, unit) in [
        ("angle gons", "gon"),
        ("angle arcmin", "arcmin"),
        ("pos revs", "rev"),
        ("Winkel Umdrehungen", "rev"),
    ] {
        let columns = format!("t=Zeit [s], x={name} [{unit}]");
        assert_eq!(proposed_of_turning(name), Ok(columns));
    }
    for (name, unit) in [
        ("pos nanometers", "nm"),
        ("pos nm", "nm"),
        ("pos feet", "ft"),
        ("Weg Mikrometer", "um"),
    ] {
        let found = proposed(&format!("t [s],{name},f [N]\n{ROWS}"), None);
        assert_eq!(found, format!("t=t [s], x={name} [{unit}], f=f [N]"));
    }
    for name in ["pos_nanometers", "pos_feet", "pos [nanometres]"] {
        let found = proposed(&format!("t [s],{name},Kraft\n{ROWS}"), None);
        assert_eq!(found, format!("t=t [s], x={name}, f=Kraft [N]"));
        let why = proposed_of_turning(name).unwrap_err();
        assert!(why.contains("is no unit of a position like `rad`"), "{why}");
    }
    for name in ["angle_gons", "pos_revs"] {
        let columns = format!("t=Zeit [s], x={name}");
        assert_eq!(proposed_of_turning(name), Ok(columns));
    }
    for (name, unit) in [
        ("pos_volts", "volt"),
        ("angle %", "%"),
        ("pos_mV", "mV"),
        ("Winkel °C", "°C"),
        ("angle_mm_raw", "mm"),
        ("pos yards", "yard"),
    ] {
        let why = proposed_of_turning(name).unwrap_err();
        let says = format!("`{unit}` is no unit of a position like `rad`");
        assert!(why.contains(&says), "{name}: {why}");
    }
}

/// Products of units are none of the letters that they have, and letters within a name may be of more than a unit.
#[test]
fn units_are_not_made_of_the_letters_of_others() {
    let found = proposed(&format!("t [s],weg_ft_filt,f [N]\n{ROWS}"), None);
    assert_eq!(found, "t=t [s], x=weg_ft_filt [ft], f=f [N]");
    for (names, is_wrong) in [
        ("t [s],Drehmoment / N.m,f [N]", "[nm]"),
        ("t [s],pos,torque N.m", "[nm]"),
        ("impulse [N s],x [mm],f [N]", "[ns]"),
    ] {
        let said = match audited(&format!("{names}\n{ROWS}"), None) {
            Ok(audit) => audit.to_text(),
            Err(error) => error.to_string(),
        };
        assert!(!said.contains(is_wrong), "{said}");
    }
    for name in ["angle°C", "Winkel °C", "x°F"] {
        let why = proposed_of_turning(name).unwrap_err();
        assert!(why.contains("is no unit of a position"), "{name}: {why}");
    }
    for name in ["rev pos_ist", "displacement_rev_filt"] {
        let why = proposed_of_turning(name).unwrap_err();
        assert!(why.contains("`rev` may be its unit"), "{name}: {why}");
    }
}

#[test]
fn positions_without_a_unit_are_proposed_in_both_that_are_usual() {
    let log = "t [ms],Winkel,speed,f [N m]\n0,0.5,0.1,0.1\n1,0.7,0.1,-0.1\n2,0.9,0.1,-0.2\n";
    let columns = |x, v| format!("t=t [ms], x=Winkel [{x}], v=speed [{v}], f=f [N m]");
    let error = audited_on(&rotary(), log, None).unwrap_err();
    let says = format!(
        "did you mean {}, or {} where positions are in deg? (units that the header does not give are assumed: x in rad",
        columns("rad", "rad/s"),
        columns("deg", "deg/s")
    );
    assert!(error.to_string().contains(&says), "{error}");
    let proposal = error.proposal.unwrap();
    for columns in [&proposal.columns, &proposal.otherwise[0].columns] {
        assert!(audited_on(&rotary(), log, Some(columns)).is_ok());
    }
    // What the name or the typed columns say is not in question.
    for (name, told, unit) in [
        ("Winkel_deg", None, ""),
        ("Winkel", Some("x=Winke [rad]"), " [rad]"),
    ] {
        let log = log.replace("Winkel", name);
        let error = audited_on(&rotary(), &log, told).unwrap_err();
        let proposal = error.proposal.unwrap();
        assert!(
            proposal.columns.contains(&format!("x={name}{unit}, ")),
            "{}",
            proposal.columns
        );
        assert_eq!(proposal.otherwise, []);
    }
    let linear = refused(&log.replace("N m", "N"), None).proposal.unwrap();
    assert!(linear.columns.contains("x=Winkel [m], v=speed [m/s]"));
    assert!(
        linear.otherwise[0]
            .columns
            .contains("x=Winkel [mm], v=speed [mm/s]")
    );
    // Without an encoder degrees cannot be read.
    let error = audited_on(&smooth(), log, None).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("positions in deg are to be converted first"),
        "{error}"
    );
    assert_eq!(error.proposal.unwrap().otherwise, []);
}

/// A device that turns, without an encoder.
fn smooth() -> Scene {
    let text = "[device]\nviscous = \"9e-4 N m s/rad\"\n[sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"1 N m/rad\"";
    Scene::from_toml("smooth", text).unwrap()
}

#[test]
fn degrees_without_an_encoder_are_refused_with_what_makes_radians_of_them() {
    let scene = smooth();
    for (name, radians) in [
        ("angle_deg", "0.017453292519943295"),
        ("x [deg]", "0.017453292519943295"),
        ("x [rev]", "6.283185307179586"),
    ] {
        let log = format!("t [s],{name},torque_Nm\n0,0.1,-0.5\n.001,0.2,-1\n");
        let error = audited_on(&scene, &log, None).unwrap_err();
        assert_eq!(error.proposal, None, "{error}");
        let column = format!("the column `{name}` cannot be read: without an encoder in the scene");
        let multiply = format!("multiply its numbers by {radians} and call the column `x [rad]`");
        let line = format!(
            "awk -F',' -v OFS=',' 'NR == 1 {{$2 = \"x [rad]\"}} NR > 1 {{$2 = sprintf(\"%.15g\", $2 * {radians})}} 1'"
        );
        for says in [&column, &multiply, &line] {
            assert!(error.message.contains(says), "{error}");
        }
        // Of what is named, and where nothing else is to be asked.
        let columns = format!("t=t, x={name}, f=torque_Nm");
        let named = audited_on(&scene, &log, Some(&columns)).unwrap_err();
        assert!(named.message.contains(&multiply), "{named}");
        if name.starts_with('x') {
            let own = log.replace("torque_Nm", "f [N m]");
            let error = audited_on(&scene, &own, None).unwrap_err();
            assert!(error.message.contains(&multiply), "{error}");
        }
    }
    // Beside an encoder, and of radians, nothing is said.
    for (scene, unit) in [(rotary(), "deg"), (scene, "rad")] {
        let log = format!("t [s],angle_{unit},torque_Nm\n0,0.1,-0.5\n.001,0.2,-1\n");
        let error = audited_on(&scene, &log, None).unwrap_err();
        assert!(!error.message.contains("radians"), "{error}");
        assert!(error.proposal.is_some(), "{error}");
    }
}

#[test]
fn forces_off_by_the_factor_of_two_units_of_positions_name_these() {
    // A spring of 1 N m/rad, and angles in degrees that are read as radians.
    let law = |i: i32| {
        (
            f64::from(i % 40 - 20) * 0.5,
            -f64::from(i % 40 - 20) * 0.5_f64.to_radians(),
        )
    };
    let rows: String = (0..400)
        .map(law)
        .map(|(x, f)| format!("{x},{f}\n"))
        .collect();
    for (unit, is_said) in [("rad", true), ("deg", false)] {
        let audit = audited_on(&rotary(), &format!("x [{unit}],f [N m]\n{rows}"), None).unwrap();
        let says = "or correct the unit of the positions, as the factor is that between rad and deg, or of the force";
        let text = audit
            .to_text()
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        assert_eq!(text.contains(says), is_said, "{}", audit.to_text());
    }
}
