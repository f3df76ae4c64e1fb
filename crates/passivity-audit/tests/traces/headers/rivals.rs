//! Columns that are called as a role is, beside others that may be meant.

use passivity_scene::Scene;

use super::{audited, audited_on, proposed, refused, rotary, scene};

/// A log of so many rows, with what each column has in each of them.
fn log(names: &str, rows: u32, row: impl Fn(u32) -> String) -> String {
    let rows: String = (0..rows).map(|i| row(i) + "\n").collect();
    format!("{names}\n{rows}")
}

/// What is proposed of a log, and where else something else is.
fn ways(scene: &Scene, log: &str) -> (String, Vec<(String, String)>, String) {
    let error = audited_on(scene, log, None).unwrap_err();
    let proposal = error
        .proposal
        .unwrap_or_else(|| panic!("{log}: {}", error.message));
    let ways = proposal.otherwise.into_iter();
    let ways = ways.map(|way| (way.condition, way.columns)).collect();
    (proposal.columns, ways, error.message)
}

#[test]
fn a_count_that_numbers_the_rows_is_not_taken_for_the_encoder_s_beside_a_position() {
    for (name, first, columns) in [
        ("angle [deg]", 0, "x=angle [deg]"),
        ("angle_deg", 1, "x=angle_deg"),
        ("theta", 0, "x=theta [rad]"),
        ("enc_angle [deg]", 0, "x=enc_angle [deg]"),
    ] {
        for rows in [4, 40] {
            let names = format!("count,{name}");
            let log = log(&names, rows, |i| format!("{},{}.5", first + i, i % 3));
            let (proposed, ways, message) = ways(&rotary(), &log);
            // Of many rows it may also be the number of the sample.
            let numbers = if rows == 40 { "tau=count, " } else { "" };
            assert_eq!(proposed, format!("{numbers}{columns}"));
            let plain = ways.iter().find(|(_, columns)| columns == "count=count");
            assert_eq!(plain.unwrap().0, "`count` is the position");
            let says = "the column `count` is the number of the row in each of the first rows";
            assert!(message.contains(says), "{message}");
            for columns in [columns, "count=count"] {
                audited_on(&rotary(), &log, Some(columns)).unwrap();
            }
        }
    }
    // Counts of which both may be the encoder's.
    for name in ["encoder", "enc_count", "position [counts]"] {
        let log = log(&format!("t [s],count,{name}"), 9, |i| {
            format!("0.00{i},{i},{}", i % 3)
        });
        let (proposed, ways, _) = ways(&scene(), &log);
        assert_eq!(proposed, format!("t=t [s], count={name}"));
        assert_eq!(ways.len(), 1);
        assert_eq!(ways[0].1, "t=t [s], count=count");
    }
    // One that moves as an encoder does is one, and one alone is all that there is.
    let moves = log("t [s],count,angle [deg]", 9, |i| {
        format!("0.00{i},{},{}.5", i % 3, i % 3)
    });
    let audit = audited_on(&rotary(), &moves, None).unwrap();
    assert_eq!(audit.report().not_read, ["angle [deg]"]);
    let alone = log("count,f [N]", 9, |i| format!("{i},0"));
    audited(&alone, None).unwrap();
}

#[test]
fn a_count_is_read_that_only_moves_evenly_or_stands_beside_what_is_no_measured_position() {
    let is_read = |names: &str, row: &dyn Fn(u32) -> String| {
        let log = log(names, 24, row);
        let audit = audited_on(&rotary(), &log, None);
        let audit = audit.unwrap_or_else(|error| panic!("{names}: {error}"));
        let other = names.split(',').next_back().unwrap();
        assert_eq!(audit.report().not_read, [other]);
    };
    // An encoder at constant speed.
    for (first, step) in [(5000, 1), (0, 10), (0, 2), (2, 1)] {
        is_read("count,angle [deg]", &|i| {
            format!("{},{}.5", first + i * step, i % 3)
        });
    }
    for name in [
        "wall_pos [rad]",
        "x_ref [rad]",
        "x_d [rad]",
        "angle_desired [deg]",
        "target_position [rad]",
        "position_error [rad]",
        "theta_err [rad]",
        "penetration [rad]",
        "proxy_pos [rad]",
        "cursor_pos [rad]",
        "x_sim [rad]",
    ] {
        is_read(&format!("count,{name}"), &|i| format!("{i},{}.5", i % 3));
    }
    is_read("count,encoder_b", &|i| format!("{},{}", i % 2, i % 3));
    // One that stands still, and another number of the row.
    is_read("count,angle [deg]", &|i| format!("{i},0.5"));
    for step in [1, 2] {
        is_read("t [ms],count,tick", &|i| format!("{i},{},{i}", i * step));
    }
}

#[test]
fn no_command_is_proposed_twice_for_a_count_that_numbers_the_rows() {
    let log = log("count,angle", 24, |i| format!("{i},{}.5", i % 3));
    let (proposed, ways, message) = ways(&rotary(), &log);
    let all: Vec<&str> = ways.iter().map(|(_, columns)| columns.as_str()).collect();
    assert_eq!(proposed, "tau=count, x=angle [rad]");
    let expected = [
        "x=angle [rad]",
        "tau=count, x=angle [deg]",
        "x=angle [deg]",
        "count=count",
    ];
    assert_eq!(all, expected, "{message}");
}

#[test]
fn a_force_that_is_commanded_is_not_passed_over_for_one_called_f() {
    for name in [
        "force_cmd [N]",
        "motor_force [N]",
        "F applied [N]",
        "f_sent [N]",
        "f_sat [N]",
        "f_saturated [N]",
        "f_limited [N]",
        "f_out [N]",
        "f_dac [N]",
        "f_held [N]",
        "f_actual [N]",
        "f_real [N]",
        "f_total [N]",
        "Fcmd [N]",
        "Fsat [N]",
        "output [N]",
    ] {
        let log = log(&format!("t [s],count,f [N],{name}"), 4, |i| {
            format!("0.00{i},{},0,{}", i % 2, i % 2)
        });
        let (proposed, ways, message) = ways(&scene(), &log);
        assert_eq!(proposed, format!("t=t [s], count=count, f={name}"));
        let plain = (
            "`f [N]` is the force that was held".to_owned(),
            "t=t [s], count=count, f=f [N]".to_owned(),
        );
        assert_eq!(ways, [plain]);
        let error = refused(&log, None);
        assert_eq!(error.proposal.unwrap().others, Vec::<String>::new());
        assert!(
            message.contains("the column `f [N]` may be another force"),
            "{message}"
        );
    }
    // Without a unit, too.
    for name in ["Fcmd", "Fsent", "output", "dac"] {
        let log = log(&format!("t [s],count,f [N],{name}"), 4, |i| {
            format!("0.00{i},{},0,{}.5", i % 2, i % 2)
        });
        let columns = format!("t=t [s], count=count, f={name} [N]");
        assert_eq!(proposed(&log, None), columns);
    }
    // Others, and one that cannot be read, are no such.
    for name in [
        "force_sensor [N]",
        "force_ref [N]",
        "torque_cmd [N m]",
        "cmd",
        "f_err [N]",
    ] {
        let log = log(&format!("count,f [N],{name}"), 4, |i| {
            format!("{},0,1", i % 2)
        });
        audited(&log, None).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

/// What was commanded is what counts: it is named where a sensor is called a force.
#[test]
fn a_commanded_force_is_named_beside_that_of_a_sensor() {
    let log = log("t [s],count,force_sensor [N],output [N]", 4, |i| {
        format!("0.00{i},{},{}.5,{}.25", i % 2, i % 2, i % 2)
    });
    let proposal = refused(&log, None).proposal.unwrap();
    let columns = "t=t [s], count=count, f=force_sensor [N]";
    assert_eq!(proposal.columns, columns);
    assert_eq!(proposal.others, ["output [N]"]);
}

#[test]
fn a_position_that_was_measured_is_not_passed_over_for_one_called_x() {
    for name in [
        "position_measured [mm]",
        "x_meas [mm]",
        "x_actual [mm]",
        "x_raw [mm]",
        "x_unfiltered [mm]",
        "x_true [mm]",
        "measured [mm]",
        "actual [mm]",
        "Ist [mm]",
        "feedback [mm]",
        // An encoder that says something else than the same, rounded.
        "x_enc [mm]",
        "enc_pos [mm]",
        "encoder [mm]",
    ] {
        let log = format!("t [s],x [mm],{name}\n0,0,0\n0.001,0,0.1\n");
        assert_eq!(proposed(&log, None), format!("t=t [s], x={name}"));
        let text = refused(&log, None).to_string();
        assert!(
            text.contains("or t=t [s], x=x [mm] where `x [mm]` is the position"),
            "{text}"
        );
        audited(&log, Some("t=t [s], x=x [mm]")).unwrap();
    }
    // A wanted one, one that was made of it, another like it, counts, and the clock in another unit.
    for name in [
        "x_ref [mm]",
        "position [mm]",
        "encoder",
        "pos_des [mm]",
        "x_filt [mm]",
        "x_sim [mm]",
        "x_est [mm]",
        "x_raw_filt [mm]",
        "x_raw [V]",
        "actual [A]",
        "timestamp_us",
        // A word that is one of a measured position says nothing beside others, nor a mark of a deviation.
        "x_dev [mm]",
        "device_gap [mm]",
        "actual_gap [mm]",
        "laser_sensor [mm]",
        "tip_deflection [mm]",
        // Not of a force.
        "fe [mm]",
    ] {
        let log = format!("t [s],x [mm],{name}\n0,0,0\n0.001,0.5,1\n0.002,0,5\n");
        audited(&log, None).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    // Nor is a flag another force.
    for name in ["f_sat", "f_clipped", "f_limited"] {
        let log = format!("t [s],x [mm],f [N],{name}\n0,0,0,0\n0.001,0.5,-0.5,1\n0.002,0,0,0\n");
        audited(&log, None).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    // The same, rounded to ticks from where the device was, and counted from elsewhere.
    for name in ["encoder [mm]", "x_enc [mm]", "enc_pos [um]"] {
        let rows: String = (0..9_i32)
            .map(|i| {
                let ticks = i * i;
                let um = name.ends_with("[um]");
                let rounded = match um {
                    true => format!("{}", (ticks + 700) * 10),
                    false => format!("{}", f64::from(ticks + 700) / 100.0),
                };
                format!("0.00{i},{:.2}4,{rounded}\n", f64::from(ticks) / 100.0)
            })
            .collect();
        let log = format!("t [s],x [mm],{name}\n{rows}");
        audited(&log, None).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}
