//! Forces that are called by the letter of a force or a torque with a few letters behind it, or by a word of command.

use passivity_scene::Scene;

use super::{audited_on, rotary, scene};

/// A log of a clock, a position and one more column, which moves.
fn log(scene: &Scene, name: &str, values: [&str; 4]) -> (String, String) {
    let position = match scene.name.as_str() {
        "rotary" => "x [rad]",
        _ => "x [mm]",
    };
    let rows = ["0,0", "0.001,0.1", "0.002,0.2", "0.003,0.1"];
    let rows = rows.iter().zip(values);
    let rows: String = rows
        .map(|(row, value)| format!("{row},{value}\n"))
        .collect();
    let text = format!("t [s],{position},{name}\n{rows}");
    (text, format!("t=t [s], x={position}"))
}

const MOVES: [&str; 4] = ["0", "-0.1", "-0.25", "0"];

#[test]
fn the_letter_of_a_force_with_what_stands_behind_it_is_not_passed_over() {
    let linear = "Fd Fwall Fset Fsoll Fref Fdes Fdesired fdes Fa Fm Fs Fk Ft Fe Fv Fvw Fact Fctrl Fctl Fdev Fapp Fcont \
        Fcontact Fspring Fspr Fhaptic Fhap Fvirtual rendered render Befehl Stellwert Stellgröße dac pwm drive cmdN \
        newtons_out motor.Fwall left_Fd fd /device/wrench_out.data";
    let turning = "Tm Td Tdes Tout Twall tauwall taum taud Md M_soll Msoll M T_d M_cmd Fd";
    for (scene, names, unit) in [(scene(), linear, "N"), (rotary(), turning, "N m")] {
        for name in names.split_whitespace() {
            let (log, others) = log(&scene, name, MOVES);
            let error = audited_on(&scene, &log, None).err();
            let error = error.unwrap_or_else(|| panic!("{name} is passed over"));
            let proposal = error.proposal.unwrap();
            assert_eq!(proposal.columns, format!("{others}, f={name} [{unit}]"));
            audited_on(&scene, &log, Some(&proposal.columns)).unwrap();
            // It may be something else.
            let [otherwise] = proposal.otherwise.as_slice() else {
                panic!("{name}: {:?}", proposal.otherwise);
            };
            assert_eq!(otherwise.condition, format!("`{name}` is no force"));
            assert_eq!(otherwise.columns, others);
        }
    }
    for (name, unit) in [
        ("effortcmd", "N"),
        ("/device/wrench.data", "N"),
        ("lbs", "lbs"),
        ("grams", "grams"),
        ("lbf_out", "lbf"),
    ] {
        let (log, others) = log(&scene(), name, MOVES);
        let proposal = audited_on(&scene(), &log, None).unwrap_err().proposal;
        let columns = proposal.unwrap_or_else(|| panic!("{name}")).columns;
        assert_eq!(columns, format!("{others}, f={name} [{unit}]"));
        audited_on(&scene(), &log, Some(&columns)).unwrap();
    }
}

#[test]
fn words_that_begin_with_such_a_letter_are_no_forces() {
    let names = "frame flag freq frequency fault feedback filter file fan fast far fin fit fps fs ft FS FT fact time temp mode \
        mass motor temperature table task tick test total mean max min Tick Mode Mass Motor Temp Time Task Table Text MS TS \
        force_enabled";
    let linear = "Tm Td T M T_soll M_soll Tset y";
    let turning = "tm td ms m t_cycle T_max T_sample T_ambient";
    let is_read = |scene: &Scene, name: &str, values| {
        let (log, _) = log(scene, name, values);
        let audit = audited_on(scene, &log, None);
        let audit = audit.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(audit.report().not_read, [name]);
    };
    for (scene, own) in [(scene(), linear), (rotary(), turning)] {
        for name in names.split_whitespace().chain(own.split_whitespace()) {
            is_read(&scene, name, MOVES);
        }
        // Nor is one of these that stands still, or has a few whole numbers.
        for name in ["Fs", "Fd", "Td", "dac", "drive"] {
            is_read(&scene, name, ["50"; 4]);
            is_read(&scene, name, ["0", "1", "1", "2"]);
        }
    }
    // Beside a force they are others.
    let log = "t [s],x [mm],f [N],Fwall,rendered\n0,0,0,0,0\n0.001,0.1,0,-0.5,-0.5\n";
    let audit = audited_on(&scene(), log, None).unwrap();
    assert_eq!(audit.report().not_read, ["Fwall", "rendered"]);
}
