//! The position of one joint, or along one axis, is not proposed with the force of another.

use super::{audited, proposed, refused};

/// Rows of a clock and four columns: positions that move, and forces of which the first rests, as before contact.
const ROWS: &str = "0,-1,0.1,0,0\n0.001,-0.9,0.3,0,-0.3\n0.002,-0.8,0.6,0,-0.6\n";

#[test]
fn the_force_of_the_position_s_own_joint_is_proposed_even_where_it_rests_at_first() {
    for (names, columns, others) in [
        (
            "x [mm],y [mm],fx [N],fy [N]",
            "x=x [mm], f=fx [N]",
            &["y [mm]", "fy [N]"][..],
        ),
        (
            "x [mm],y [mm],force_x [N],force_y [N]",
            "x=x [mm], f=force_x [N]",
            &["y [mm]", "force_y [N]"],
        ),
        (
            "position_a,position_b,force_a,force_b",
            "x=position_a [m], f=force_a [N]",
            &["position_b", "force_b"],
        ),
        ("q1,q2,tau1,tau2", "x=q1 [m], f=tau1 [N]", &["q2", "tau2"]),
        (
            "joint1_pos,joint2_pos,joint1_force,joint2_force",
            "x=joint1_pos [m], f=joint1_force [N]",
            &["joint2_pos", "joint2_force"],
        ),
        (
            "pos[0],pos[1],force[0],force[1]",
            "x=pos[0] [m], f=force[0] [N]",
            &["pos[1]", "force[1]"],
        ),
        (
            "left_pos,right_pos,left_force,right_force",
            "x=left_pos [m], f=left_force [N]",
            &["right_pos", "right_force"],
        ),
        (
            "posA,posB,ForceA,ForceB",
            "x=posA [m], f=ForceA [N]",
            &["posB", "ForceB"],
        ),
        (
            "/joint_states.position.a,/joint_states.position.b,/joint_states.effort.a,/joint_states.effort.b",
            "x=/joint_states.position.a [m], f=/joint_states.effort.a [N]",
            &["/joint_states.position.b", "/joint_states.effort.b"],
        ),
        (
            "/pose.pose.position.x,/pose.pose.position.y,/wrench.wrench.force.x,/wrench.wrench.force.y",
            "x=/pose.pose.position.x [m], f=/wrench.wrench.force.x [N]",
            &["/pose.pose.position.y", "/wrench.wrench.force.y"],
        ),
    ] {
        let log = format!("t [s],{names}\n{ROWS}");
        let proposal = refused(&log, None).proposal.unwrap();
        assert_eq!(proposal.columns, format!("t=t [s], {columns}"));
        assert_eq!(proposal.others, others);
        // Whatever comes first, and of which there are more forces than positions.
        let of_one = format!("t [s],{}\n0,0.1,-0.1,0\n0.001,0.2,-0.2,0\n", {
            let names: Vec<&str> = names.split(',').collect();
            [names[0], names[3], names[2]].join(",")
        });
        assert_eq!(proposed(&of_one, None), format!("t=t [s], {columns}"));
    }
}

#[test]
fn no_force_of_another_joint_is_proposed() {
    // Of equal positions the one that has a force.
    let log = format!("t [s],q1,q2,aux,tau2\n{ROWS}");
    assert_eq!(proposed(&log, None), "t=t [s], x=q2 [m], f=tau2 [N]");
    for (names, says) in [
        (
            "x [mm],y [mm],aux,fy [N]",
            "`fy [N]` seems to be the force of another joint or axis than `x [mm]`",
        ),
        ("pos_a,aux,effort_a_limit,effort_b", ""),
    ] {
        let log = format!("t [s],{names}\n{ROWS}");
        if says.is_empty() {
            // Nothing says that this is of another joint, as nothing is alike.
            assert_eq!(proposed(&log, None), "t=t [s], x=pos_a [m], f=effort_b [N]");
            continue;
        }
        let error = refused(&log, None);
        assert_eq!(error.proposal, None, "{error}");
        assert!(error.message.contains(says), "{error}");
        // Who names both says that they go together.
        audited(&log, Some("t=t [s], x=x [mm], f=fy [N]")).unwrap();
    }
    // Nor of a joint that rests while the other one moves.
    let log = "t [s],q1,q2,tau2\n0,0.1,0.5,0.1\n0.001,0.2,0.5,0.1\n";
    let error = refused(log, None);
    assert_eq!(error.proposal, None, "{error}");
    assert!(error.message.contains("`tau2` seems to be"), "{error}");
    // The position is that of the force that was typed.
    let log = format!("t [s],q1,q2,tau1,tau2\n{ROWS}");
    let columns = proposed(&log, Some("t=t, x=q3, f=tau2 [N]"));
    assert_eq!(columns, "t=t [s], x=q2 [m], f=tau2 [N]");
}

#[test]
fn what_is_said_of_one_and_the_same_thing_is_no_joint() {
    for (names, columns) in [
        ("x_ref,x_meas,f_meas,f_cmd", "x=x_meas [m], f=f_cmd [N]"),
        (
            "motor_pos,hand_pos,motor_force,hand_force_raw",
            "x=motor_pos [m], f=motor_force [N]",
        ),
        ("pos,angle,aux,motor_force", "x=pos [m], f=motor_force [N]"),
    ] {
        let log = format!("t [s],{names}\n{ROWS}");
        assert_eq!(proposed(&log, None), format!("t=t [s], {columns}"));
    }
    // An axis of a sensor beside the position of the only axis.
    let log = format!("t [s],x [mm],aux,aux2,fz [N]\n{ROWS}");
    assert_eq!(proposed(&log, None), "t=t [s], x=x [mm], f=fz [N]");
    // The velocity is that of the joint, too.
    let log = format!("t [s],q1,q2,omega2,omega1\n{ROWS}");
    assert_eq!(proposed(&log, None), "t=t [s], x=q1 [m], v=omega1 [m/s]");
    let log = format!("t [s],q1,q2,omega2,aux\n{ROWS}");
    assert_eq!(proposed(&log, None), "t=t [s], x=q1 [m]");
}
