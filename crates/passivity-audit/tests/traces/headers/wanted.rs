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
