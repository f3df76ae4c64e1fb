//! Columns of a motor, where a transmission stands between it and the device.

use passivity_audit::TraceError;
use passivity_scene::Scene;

use super::{audited_on, rotary};

/// A device whose motor turns 15 times as fast, with its encoder at the motor or at the device.
fn geared(side: &str) -> Scene {
    let text = format!(
        "[motor]\nviscous = \"5.4e-6 N m s/rad\"\ncoulomb = \"2.8e-6 N m\"\n[transmission]\nratio = \"15:1\"\n\
         [sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 2000\nside = \"{side}\"\n\
         [wall]\nstiffness = \"2 N m/rad\""
    );
    Scene::from_toml("geared", &text).unwrap()
}

/// A device that a cable moves along a line.
fn cable() -> Scene {
    let text = "[motor]\nviscous = \"5.4e-6 N m s/rad\"\n[transmission]\nmotor_pulley = \"5 mm\"\n\
        [sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 2000\nside = \"motor\"\n\
        [wall]\nstiffness = \"2 N/mm\"";
    Scene::from_toml("cable", text).unwrap()
}

/// Three rows of a clock and what these columns have.
fn log(header: &str, rows: [&str; 3]) -> String {
    let [first, second, third] = rows;
    format!("t [s],{header}\n0,{first}\n0.001,{second}\n0.002,{third}\n")
}

fn refused(scene: &Scene, header: &str, rows: [&str; 3]) -> TraceError {
    match audited_on(scene, &log(header, rows), None) {
        Err(error) => error,
        Ok(audit) => panic!("{header}: {}", audit.to_text()),
    }
}

#[test]
fn a_motion_of_the_motor_is_not_proposed_as_one_of_the_device() {
    let rows = ["0.1", "0.28", "0.1"];
    for side in ["motor", "device"] {
        let scene = geared(side);
        for name in [
            "motor_angle [deg]",
            "theta_motor [deg]",
            "MotorPosition [rad]",
            "angle (motor) [deg]",
            "rotor_pos",
            "q_mot",
            "theta_m",
            "theta_m [deg]",
            "theta_M [deg]",
            "thetaM",
            "theta m",
            "theta-m",
            "theta.m",
            "m_pos",
            "m_angle [deg]",
            "mtr_angle",
            "actuator_angle [deg]",
            "servo_angle",
            "position moteur",
            "Antriebswinkel",
            "Winkel_Antrieb [deg]",
            "capstan_angle",
            "spool_pos",
            "drum_angle [rad]",
            "/motor/joint_states.position.knob",
        ] {
            let error = refused(&scene, name, rows);
            assert_eq!(error.proposal, None, "{error}");
            let text = error.to_string();
            assert!(text.contains("at the motor"), "{text}");
            assert!(text.contains("`x` is at the device"), "{text}");
            assert!(text.contains("divide its numbers by the ratio"), "{text}");
            assert!(!text.contains("x=") && !text.contains("count="), "{text}");
        }
        // Those that are called a position by nothing but their unit.
        for name in ["thm [rad]", "thetam [deg]", "mtr [rad]"] {
            let error = refused(&scene, name, rows);
            assert_eq!(error.proposal, None, "{error}");
        }
        // What is at the device is read beside it, and the motion of the motor is not.
        let error = refused(
            &scene,
            "motor_angle [deg],angle [deg]",
            ["0,0", "1.5,0.1", "3,0.2"],
        );
        let proposal = error.proposal.unwrap();
        assert_eq!(proposal.columns, "t=t [s], x=angle [deg]");
        assert_eq!(proposal.others, Vec::<String>::new());
        let both = log("motor_angle [deg],x [deg]", ["0,0", "1.5,0.1", "3,0.2"]);
        let audit = audited_on(&scene, &both, None).unwrap();
        assert_eq!(audit.report().not_read, ["motor_angle [deg]"]);
        // Who names it says that it is at the device, whatever it is called; a mistake in that is not put right.
        let own = log("motor_angle [deg]", rows);
        audited_on(&scene, &own, Some("t=t [s], x=motor_angle [deg]")).unwrap();
        let error = audited_on(&scene, &own, Some("t=t [s], x=motor_angel [deg]")).unwrap_err();
        assert_eq!(error.proposal, None, "{error}");
    }
    // A unit in brackets says nothing of a motor, and on a line metres are at the device.
    let error = refused(&geared("motor"), "position [m]", rows);
    assert!(!error.to_string().contains("motor"), "{error}");
    for (name, is_motor) in [
        ("theta_m", true),
        ("x_m", false),
        ("pos [m]", false),
        ("pos_in", false),
    ] {
        let found = audited_on(&cable(), &log(name, rows), None);
        let text = found.map_or_else(|error| error.to_string(), |_| String::new());
        assert_eq!(text.contains("at the motor"), is_motor, "{name}: {text}");
    }
    // Where the motor is what the hand holds, and where the name says nothing, there is no other side.
    for (scene, name) in [
        (rotary(), "motor_angle [deg]"),
        (geared("motor"), "angle [deg]"),
    ] {
        let proposal = refused(&scene, name, rows).proposal.unwrap();
        assert_eq!(proposal.columns, format!("t=t [s], x={name}"));
    }
}

/// The scene says where its encoder is.
#[test]
fn a_motion_of_an_encoder_at_the_motor_is_not_proposed_as_one_of_the_device() {
    let rows = ["0.1", "0.28", "0.1"];
    for name in [
        "encoder_angle [rad]",
        "encoder [rad]",
        "enc_pos [rad]",
        "shaft_angle",
        "input_angle",
        "mech_angle",
        "armature_angle [rad]",
        "axis0.encoder.pos_estimate",
        "angle_in",
        "primary_angle",
        "angle_before_gear [rad]",
    ] {
        let error = refused(&geared("motor"), name, rows);
        assert_eq!(error.proposal, None, "{error}");
        let text = error.to_string();
        assert!(text.contains("divide its numbers by the ratio"), "{text}");
        assert!(!text.contains("x=") && !text.contains("count="), "{text}");
        // Who names it says that it is at the device.
        let columns = format!("t=t [s], x={name}");
        let columns = match name.contains('[') {
            true => columns,
            false => columns + " [rad]",
        };
        audited_on(&geared("motor"), &log(name, rows), Some(&columns)).unwrap();
        if !name.starts_with("armature") {
            let proposal = refused(&geared("device"), name, rows).proposal.unwrap();
            assert_eq!(proposal.columns, columns);
        }
    }
    // A second one may be behind the transmission.
    for name in [
        "output_encoder [rad]",
        "joint_enc_pos [rad]",
        "load_drum_angle [rad]",
        "Abtriebsposition [rad]",
    ] {
        let proposal = refused(&geared("motor"), name, rows).proposal.unwrap();
        assert_eq!(proposal.columns, format!("t=t [s], x={name}"));
    }
    // Before a unit it says no side.
    for name in ["Angle in rad", "angle_in_rad", "Winkel in rad"] {
        let proposal = refused(&geared("motor"), name, rows).proposal.unwrap();
        let columns = format!("t=t [s], x={name}");
        assert!(
            proposal.columns.starts_with(&columns),
            "{}",
            proposal.columns
        );
    }
    // Its counts are those of the scene.
    for name in ["encoder", "enc_pos", "shaft_angle"] {
        let proposal = refused(&geared("motor"), name, ["0", "40", "-3"]).proposal;
        let columns = format!("t=t [s], count={name}");
        assert_eq!(proposal.unwrap().columns, columns);
    }
}

#[test]
fn an_electrical_angle_is_no_position_of_any_side() {
    let rows = ["0.1", "0.28", "0.1"];
    for scene in [rotary(), geared("motor"), geared("device"), cable()] {
        for name in [
            "electrical_angle [rad]",
            "elec_angle",
            "theta_e",
            "theta_e [rad]",
            "phi_elec [deg]",
        ] {
            let error = refused(&scene, name, rows);
            assert_eq!(error.proposal, None, "{error}");
            let text = error.to_string();
            assert!(text.contains("seems to be an electrical angle"), "{text}");
            assert!(!text.contains("x=") && !text.contains("count="), "{text}");
        }
    }
    // Who names it says that it is a position, and another one is proposed beside it.
    let own = log("theta_e", rows);
    audited_on(&rotary(), &own, Some("t=t [s], x=theta_e [rad]")).unwrap();
    let error = refused(
        &rotary(),
        "electrical_angle [rad],angle [rad]",
        ["0,0", "1.5,0.1", "3,0.2"],
    );
    let proposal = error.proposal.unwrap();
    assert_eq!(proposal.columns, "t=t [s], x=angle [rad]");
    assert_eq!(proposal.others, Vec::<String>::new());
}

#[test]
fn counts_are_at_the_side_of_the_encoder() {
    let rows = ["0", "40", "-3"];
    for name in ["motor_count", "motor_encoder", "motor_pos"] {
        let proposal = refused(&geared("motor"), name, rows).proposal.unwrap();
        assert_eq!(proposal.columns, format!("t=t [s], count={name}"));
        let error = refused(&geared("device"), name, rows);
        assert_eq!(error.proposal, None);
        let text = error.to_string();
        assert!(text.contains("whose counts are `count`"), "{text}");
    }
    // One that rests may have any unit, but none of the device.
    let text = refused(&geared("motor"), "motor_pos", ["0", "0", "0"]).to_string();
    assert!(
        text.contains("`x` is at the device") && !text.contains("x="),
        "{text}"
    );
    let text = refused(&geared("motor"), "motor_angle [deg]", ["0.1", "1", "0.1"]).to_string();
    assert!(text.contains("which is at the motor, as `count`"), "{text}");
}

#[test]
fn a_force_of_the_motor_is_not_proposed_as_one_of_the_device() {
    let rows = ["0,0.01", "40,-0.02", "-3,0.015"];
    for name in [
        "motor_torque [N m]",
        "torque_motor",
        "Motormoment [mN m]",
        "tau_m [N m]",
        "Fmot",
        "f (motor) [N m]",
        "winding_torque [N m]",
        "electromagnetic_torque",
        "Te [N m]",
        "tau_e",
        "tm [N m]",
        "Tm",
        "Antriebsmoment [N m]",
        // Where the encoder is at the motor, as an angle of this name.
        "shaft_torque [N m]",
        "input_torque",
        "torque_in",
        "tau_in",
    ] {
        let error = refused(&geared("motor"), &format!("count,{name}"), rows);
        assert_eq!(error.proposal, None, "{error}");
        let text = error.to_string();
        assert!(text.contains("multiply its numbers by the ratio"), "{text}");
        assert!(text.contains("of the wall's law"), "{text}");
        assert!(!text.contains("f="), "{text}");
        let proposal = audited_on(&rotary(), &log(&format!("count,{name}"), rows), None);
        assert!(proposal.unwrap_err().proposal.is_some(), "{name}");
    }
    // Behind the transmission, and with the encoder there.
    for (side, name) in [
        ("motor", "output_shaft_torque [N m]"),
        ("motor", "torque_oz_in"),
        ("motor", "torque_e_stop_in [N m]"),
        ("device", "shaft_torque [N m]"),
    ] {
        let error = refused(&geared(side), &format!("count,{name}"), rows);
        assert!(error.proposal.is_some(), "{error}");
    }
    // Beside the force at the device it is another column.
    let both = log(
        "count,motor_torque [N m],f [N m]",
        ["0,0.01,0.15", "40,-0.02,-0.3", "-3,0.015,0.225"],
    );
    let audit = audited_on(&geared("motor"), &both, None).unwrap();
    assert_eq!(audit.report().not_read, ["motor_torque [N m]"]);
    // A velocity leaves nothing out.
    let error = refused(&geared("motor"), "count,motor_speed [rad/s]", rows);
    assert!(
        error.to_string().contains("`v` is at the device"),
        "{error}"
    );
    assert_eq!(error.proposal.unwrap().columns, "t=t [s], count=count");
}

#[test]
fn behind_a_cable_the_angle_of_the_motor_becomes_a_length() {
    let error = refused(
        &cable(),
        "motor_angle [rad],motor_torque [N m]",
        ["0,0.01", "0.4,-0.02", "0,0"],
    );
    assert_eq!(error.proposal, None, "{error}");
    let text = error.to_string();
    for says in [
        "divide its angles in rad by the ratio in rad/m and call the column `x [m]`",
        "multiply its torques in N m by the ratio in rad/m and call the column `f [N]`",
    ] {
        assert!(text.contains(says), "{text}");
    }
}
