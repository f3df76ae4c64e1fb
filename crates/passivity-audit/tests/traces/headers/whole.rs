//! Positions without a unit that may be counts.

use passivity_scene::Scene;

use super::{audited, audited_on, proposed, refused, rotary};

/// As they are called that say no unit.
const NAMES: [&str; 9] = [
    "position",
    "x",
    "pos",
    "q",
    "theta",
    "angle",
    "Pos1",
    "motor_pos",
    "joint position",
];

/// A log with such a column beside a clock and a force.
fn log<const N: usize>(name: &str, positions: [&str; N]) -> String {
    let rows = (0..).zip(positions);
    let rows = rows.map(|(i, x)| format!("0.{i:03},{x},0\n"));
    format!("t [s],{name},f [N]\n{}", rows.collect::<String>())
}

/// A device without an encoder.
fn smooth() -> Scene {
    let text = "[device]\nmass = \"0.1 kg\"\nviscous = \"0.3 N s/m\"\ncoulomb = \"0.005 N\"\n\
        [sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"500 N/m\"";
    Scene::from_toml("smooth", text).unwrap()
}

#[test]
fn whole_numbers_without_a_unit_are_no_lengths_beside_an_encoder() {
    for name in NAMES {
        let counted = log(name, ["-1", "0", "1", "3"]);
        let expected = format!("t=t [s], count={name}, f=f [N]");
        assert_eq!(proposed(&counted, None), expected);
        assert!(audited(&counted, Some(&expected)).is_ok());
        let fractions = log(name, ["-1", "0", "1", "2.5"]);
        let expected = format!("t=t [s], x={name} [m], f=f [N]");
        assert_eq!(proposed(&fractions, None), expected);
        // Of a device that rests at first nobody knows.
        let error = refused(&log(name, ["0"; 20]), None);
        assert_eq!(error.proposal, None);
        assert!(
            error.message.contains("one and the same whole number"),
            "{error}"
        );
        assert_eq!(proposed(&log(name, ["0"; 4]), None), expected);
    }
    assert_eq!(
        proposed(&log("encoder", ["7"; 4]), None),
        "t=t [s], count=encoder, f=f [N]"
    );
    let given = log("pos_mm", ["-1", "0", "1", "3"]);
    assert_eq!(proposed(&given, None), "t=t [s], x=pos_mm, f=f [N]");
    // Nor under a name that was typed wrong.
    let counted = log("position", ["-1", "0", "1", "3"]);
    assert_eq!(
        proposed(&counted, Some("t=t, x=positon, f=f")),
        "t=t [s], count=position, f=f [N]"
    );
}

#[test]
fn counts_of_no_encoder_are_no_lengths() {
    let refused = |scene: &Scene, name: &str, last: &str| {
        let text = log(name, ["-1", "0", "1", last]);
        audited_on(scene, &text, None).unwrap_err()
    };
    let counted = [
        "count",
        "encoder_counts",
        "x [counts]",
        "enc",
        "pos_cnt",
        "tick",
    ];
    for name in NAMES.into_iter().chain(counted) {
        let error = refused(&smooth(), name, "3");
        assert_eq!(error.proposal, None, "{error}");
        let says = |text: &str| error.message.contains(text);
        assert!(says("the lines `[encoder]` and `resolution = "), "{error}");
        assert_eq!(
            says("such as `m`, `mm` or `um`"),
            name != "x [counts]",
            "{error}"
        );
    }
    let turning = "[device]\nviscous = \"1e-3 N m s/rad\"\n[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"3 N m/rad\"";
    let turning = Scene::from_toml("turning", turning).unwrap();
    let log = "t [s],count,f [N m]\n0,0,0\n0.001,40,0\n";
    for columns in [None, Some("t=t, count=count, f=f")] {
        let error = audited_on(&turning, log, columns).unwrap_err();
        assert_eq!(error.proposal, None, "{error}");
        assert!(
            error.message.contains("`counts_per_revolution = …`"),
            "{error}"
        );
    }
    // A position beside them that has a unit, and numbers that are no counts.
    let both = "t [s],count,angle [rad],f [N m]\n0,0,0.5,0\n0.001,1,0.6,0\n";
    let found = |scene: &Scene, text: &str| {
        let error = audited_on(scene, text, None).unwrap_err();
        error.proposal.map(|proposal| proposal.columns)
    };
    let expected = "t=t [s], x=angle [rad], f=f [N m]";
    assert_eq!(found(&turning, both).as_deref(), Some(expected));
    let error = refused(&smooth(), "position", "2.5");
    let columns = error.proposal.map(|proposal| proposal.columns);
    assert_eq!(columns.as_deref(), Some("t=t [s], x=position [m], f=f [N]"));
    assert_eq!(refused(&smooth(), "count", "2.5").proposal, None);
    assert!(audited_on(&rotary(), log, None).is_ok());
}

/// What a recording of `identify` does first is to rest.
#[test]
fn a_position_that_rests_at_first_is_known_by_what_it_does_later() {
    let after = |rest: usize, moving: &[&str]| {
        let rows = ["0"].repeat(rest).into_iter().chain(moving.iter().copied());
        let rows = (0..).zip(rows);
        let rows: String = rows.map(|(i, x)| format!("{i},{x},0\n")).collect();
        format!("time [ms],pos,effort\n{rows}")
    };
    for (rest, moving, columns) in [
        (25, &["0.0007", "0.0015"][..], "x=pos [m]"),
        (25, &["1", "3"], "count=pos"),
        (1500, &["0.0007"], "x=pos [m]"),
        (1500, &["-1"], "count=pos"),
    ] {
        let expected = format!("t=time [ms], {columns}, f=effort [N]");
        let log = after(rest, moving);
        assert_eq!(proposed(&log, None), expected);
        let by_semicolons = log.replace(',', ";");
        assert_eq!(proposed(&by_semicolons, None), expected);
    }
    // Where it never moves both ways to read it are said, and can be typed.
    let error = refused(&after(25, &[]), None);
    assert_eq!(error.proposal, None);
    for columns in ["count=pos", "x=pos [m]", "x=pos [mm]"] {
        let columns = format!("t=time [ms], {columns}, f=effort [N]");
        let says = format!("`--columns '{columns}'`");
        assert!(error.message.contains(&says), "{error}");
        assert!(audited(&after(25, &[]), Some(&columns)).is_ok());
    }
}
