//! A position that was wanted beside the one that was measured.

use super::{audited_on, proposed, refused, rotary};

fn log(header: &str) -> String {
    format!("t [ms],{header}\n0,0,0\n1,2.5,1.5\n2,4.5,3.5\n")
}

#[test]
fn what_was_measured_goes_before_what_was_wanted() {
    for [wanted, measured] in [
        ["Position Soll [mm]", "Position Ist [mm]"],
        ["phi_soll", "phi_ist"],
        ["Position consigne", "Position mesurée"],
        ["Position Soll", "Position"],
        ["pos_sp", "pos_act"],
        ["planned_pos", "actual_pos"],
        ["x_d", "x_pos"],
        ["pos_r", "pos_m (raw)"],
        ["proxy_pos", "device_pos"],
        ["pos_goal", "pos_fb"],
        ["pos_demand", "enc_pos"],
        ["posición deseada x", "x medida"],
        ["pos1", "pos1_meas"],
        ["pos", "pos_unfiltered"],
        ["x_tgt", "x_pos"],
        ["x_dem", "x_pos"],
    ] {
        for header in [
            format!("{wanted},{measured}"),
            format!("{measured},{wanted}"),
        ] {
            let columns = proposed(&log(&header), None);
            let unit = if measured.contains('[') { "" } else { " [m]" };
            assert_eq!(columns, format!("t=t [ms], x={measured}{unit}"));
        }
    }
    for made in [
        "filt",
        "filtered",
        "lpf",
        "smooth",
        "avg",
        "estimated",
        "est",
        "hat",
        "kalman",
        "obs",
        "pred",
        "delayed",
        "prev",
        "previous",
        "model",
        "sim",
        "virtual",
        "cursor",
        "ghost",
        "slave",
        "follower",
        "min",
        "max",
        "tgt",
        "dem",
    ] {
        for (made, measured) in [
            (format!("x_{made} [mm]"), "x_raw [mm]"),
            (format!("x_{made} [mm]"), "dev_pos [mm]"),
            (format!("x_{made} [mm]"), "pos_tip [mm]"),
            (format!("x_{made} [mm]"), "position_a [mm]"),
            (format!("{made} pos [mm]"), "pos [mm]"),
            (format!("x_{made} [mm]"), "y_meas [mm]"),
        ] {
            for header in [format!("{made},{measured}"), format!("{measured},{made}")] {
                let columns = proposed(&log(&header), None);
                assert_eq!(columns, format!("t=t [ms], x={measured}"), "{header}");
            }
        }
    }
    // Alone it is what there is, and beside what may be wanted, or anything else, the others are named.
    for (header, columns, others) in [
        ("x_filt [mm],aux", "x=x_filt [mm]", &[][..]),
        ("pos_lpf [mm],x_ref [mm]", "x=pos_lpf [mm]", &["x_ref [mm]"]),
        ("x_est [mm],x_d [mm]", "x=x_est [mm]", &["x_d [mm]"]),
        ("x_hat [mm],height [mm]", "x=x_hat [mm]", &["height [mm]"]),
        ("x_hat [mm],x_filt [mm]", "x=x_hat [mm]", &["x_filt [mm]"]),
    ] {
        let proposal = refused(&log(header), None).proposal.unwrap();
        assert_eq!(proposal.columns, format!("t=t [ms], {columns}"));
        assert_eq!(proposal.others, others, "{header}");
    }
    // Of a device that turns, `m` is no unit, but measured.
    for names in [["x_d", "x_m"], ["pos_r", "pos_m"], ["theta_d", "theta_m"]] {
        let error = audited_on(&rotary(), &log(&names.join(",")), None).unwrap_err();
        let proposal = error.proposal.unwrap();
        let columns = format!("t=t [ms], x={} [rad]", names[1]);
        assert_eq!(proposal.columns, columns);
        assert_eq!(proposal.others, [names[0]]);
        audited_on(&rotary(), &log(&names.join(",")), Some(&columns)).unwrap();
    }
    // Where it is less clear, the other is named.
    for header in ["x_d,x_meas", "pos_r,pos_l"] {
        let others = refused(&log(header), None).proposal.unwrap().others;
        assert_eq!(others, [header.split(',').next().unwrap()]);
    }
}
