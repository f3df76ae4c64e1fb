//! Several joints in one log: the one that moves is proposed, and the others are named.

use super::{as_proposed, proposed, refused};

#[test]
fn the_joint_that_moves_is_proposed_with_its_force_and_the_others_are_named() {
    for (header, columns, others) in [
        (
            "position.base,position.knob,effort.base,effort.knob",
            "x=position.knob [m], f=effort.knob [N]",
            "(these may be meant as well: `position.base`, `effort.base`)",
        ),
        (
            "joint1_pos,joint2_pos,joint1_trq,joint2_trq",
            "x=joint2_pos [m], f=joint2_trq [N]",
            "`joint1_pos`, `joint1_trq`",
        ),
        (
            "position[0] [mm],position[1] [mm],effort[0] [N],effort[1] [N]",
            "x=position[1] [mm], f=effort[1] [N]",
            "`position[0] [mm]`, `effort[0] [N]`",
        ),
    ] {
        // The force of the other joint moves, and comes first.
        let log = format!("t [s],{header}\n0,0.5,0,1,-1\n0.001,0.5,0.1,2,-1\n");
        assert_eq!(as_proposed(&log).0, format!("t=t [s], {columns}"));
        let error = refused(&log, None).to_string();
        assert!(error.contains(others), "{error}");
    }
    // Of those that do not move, or do all, the first; what was typed has no others.
    let log = "t [s],pos1,pos2,trq\n0,1,1,1\n0.001,1,1,1\n";
    assert_eq!(proposed(log, None), "t=t [s], x=pos1 [m], f=trq [N]");
    let error = refused(log, Some("x=pos2 [mm], f=torq [N]")).to_string();
    assert!(!error.contains("as well"), "{error}");
}

#[test]
fn many_others_are_counted() {
    let names: String = (0..20).map(|i| format!(",pos{i}")).collect();
    let zeros = ",0".repeat(20);
    let error = refused(&format!("t [s]{names}\n0{zeros}\n0.001{zeros}\n"), None);
    assert_eq!(error.proposal.as_ref().unwrap().others.len(), 19);
    assert!(error.to_string().contains("`pos6` and 13 more)"), "{error}");
}
