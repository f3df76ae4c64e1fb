//! Several joints in one log: the one that moves is proposed, and the others are named.

use super::{as_proposed, audited, proposed, refused};

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
fn an_axis_is_not_taken_for_the_one_at_the_wall_beside_another_that_moves() {
    for (header, row) in [
        ("x [mm],y [mm]", "0.1,0.2"),
        ("y [mm],x [mm]", "0.1,0.2"),
        ("x [mm],y [mm],z [mm]", "0.1,0,0.3"),
        ("x [mm],Y [mm],f [N]", "0.1,0.2,0"),
        ("x [mm],z_um,f [N]", "0.1,0.2,0"),
    ] {
        let zeros = row
            .replace(|c: char| c != ',' && c != '-', "")
            .replace(',', ",0");
        let log = format!("t [s],{header}\n0,0{zeros}\n0.001,{row}\n");
        let error = refused(&log, None);
        let text = error.to_string();
        let proposal = error.proposal.unwrap();
        let force = if header.ends_with("f [N]") {
            ", f=f [N]"
        } else {
            ""
        };
        assert_eq!(proposal.columns, format!("t=t [s], x=x [mm]{force}"));
        let other = if header.contains("z [mm]") { 2 } else { 1 };
        assert_eq!(proposal.others.len(), other, "{text}");
        assert!(
            text.contains("the column `x [mm]` is one of several axes"),
            "{text}"
        );
        assert!(
            !text.contains("`x [mm]` is not read under this name"),
            "{text}"
        );
        audited(&log, Some(&proposal.columns)).unwrap();
    }
    // Where `x` rests the other one is proposed.
    let log = "t [s],x [mm],y [mm]\n0,0.5,0\n0.001,0.5,0.1\n";
    let proposal = refused(log, None).proposal.unwrap();
    assert_eq!(proposal.columns, "t=t [s], x=y [mm]");
    assert_eq!(proposal.others, ["x [mm]"]);
    // One that rests, an output of something else, and what is called otherwise are no other axes.
    for (header, row) in [
        ("x [mm],y [mm]", "0.1,0"),
        ("x [mm],y", "0.1,0.2"),
        ("x [mm],y [V]", "0.1,0.2"),
        ("x [mm],z [deg]", "0.1,0.2"),
        ("x [mm],y_ref [mm]", "0.1,0.2"),
        ("x [mm],h [mm]", "0.1,0.2"),
    ] {
        let log = format!("t [s],{header}\n0,0,0\n0.001,{row}\n");
        audited(&log, None).unwrap_or_else(|error| panic!("{header}: {error}"));
    }
}

#[test]
fn many_others_are_counted() {
    let names: String = (0..20).map(|i| format!(",pos{i}")).collect();
    let zeros = ",0".repeat(20);
    let error = refused(&format!("t [s]{names}\n0{zeros}\n0.001{zeros}\n"), None);
    assert_eq!(error.proposal.as_ref().unwrap().others.len(), 19);
    assert!(error.to_string().contains("`pos6` and 13 more)"), "{error}");
}
