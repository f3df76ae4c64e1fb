//! Mistakes in scenes of several joints, each shown in its place.

use passivity_scene::{AnyScene, Scene};

use super::{ARM, MATRIX};

/// What is wrong with a scene of several joints: its kind, line and column, and a part of the text.
const WRONG: &[(&str, &str, &str, usize, usize, &str)] = &[
    (
        "coulomb = \"20 mN m\"",
        "coulomb = \"20 mN m\"\ndamping = 1",
        "wrong_section",
        5,
        1,
        "`damping` is not a key of [[joint]]",
    ),
    (
        "coulomb = \"20 mN m\"",
        "coulomb = \"20 mN\"",
        "mixed_motion",
        4,
        15,
        "`joint.coulomb` is linear (`mN`), but `joint.viscous` is rotary",
    ),
    (
        "coulomb = \"20 mN m\"",
        "coulomb = \"-20 mN m\"",
        "out_of_bounds",
        4,
        11,
        "`joint.coulomb` cannot be `-20 mN m`; expected zero or a value above it",
    ),
    (
        "coulomb = \"20 mN m\"",
        "coulomb = 20",
        "missing_unit",
        4,
        11,
        "`joint.coulomb` is a number without a unit",
    ),
    (
        "coulomb = \"20 mN m\"",
        "inertia = \"1 kg m^2\"",
        "not_with_joints",
        4,
        1,
        "`inertia` has no part in the verdict on several joints",
    ),
    (
        "{ counts_per_revolution = 4096 }",
        "4096",
        "wrong_type",
        5,
        11,
        "`joint.encoder` is a number; expected a table such as `{ counts_per_revolution = 8192 }`",
    ),
    (
        "{ counts_per_revolution = 4096 }",
        "{ }",
        "missing_key",
        5,
        1,
        "[joint.encoder] has no `counts_per_revolution` or `resolution`",
    ),
    (
        "counts_per_revolution",
        "side = \"motor\", counts_per_revolution",
        "wrong_section",
        5,
        13,
        "`side` is not a key of [joint.encoder]",
    ),
    (
        "rate = \"1 kHz\"",
        "rate = \"1 kHz\"\ndelay = 1",
        "not_with_joints",
        18,
        1,
        "`sampling.delay` is not covered for a device of several joints",
    ),
    (
        "unilateral = true",
        "damping = \"1 N s/m\"",
        "not_with_joints",
        21,
        1,
        "`wall.damping` is not covered for a device of several joints",
    ),
    (
        "unilateral = true",
        "[operator]\nmax_speed = \"1 m/s\"",
        "not_with_joints",
        21,
        2,
        "[operator] does not go with `[[joint]]`",
    ),
    (
        "unilateral = true",
        "[start]\nposition = \"1 m\"",
        "not_with_joints",
        21,
        2,
        "[start] does not go with `[[joint]]`",
    ),
    (
        "unilateral = true",
        "[wal]",
        "unknown_section",
        21,
        2,
        "a scene has no section `[wal]`",
    ),
    (
        "\"-50 mm/rad\", ",
        "",
        "wrong_count",
        20,
        13,
        "`wall.direction` has 2 entries, and the device 3 joints",
    ),
    (
        "\"0.3\"",
        "\"0.3 m/rad\"",
        "wrong_unit",
        20,
        46,
        "an entry of `wall.direction` has the unit `m/rad`",
    ),
    (
        "\"0.2 m/rad\"",
        "0.2",
        "missing_unit",
        20,
        14,
        "expected the way of the wall for a radian of the joint, such as `\"0.2 m/rad\"`",
    ),
    (
        "\"0.3\"",
        "\"0.3 ± 0.1\"",
        "malformed_tolerance",
        20,
        41,
        "an entry of `wall.direction` has a tolerance",
    ),
    (
        "[\"0.2 m/rad\", \"-50 mm/rad\", \"0.3\"]",
        "[\"0 m\", \"0 m\", 0]",
        "out_of_bounds",
        20,
        13,
        "this wall acts on no joint",
    ),
    (
        "direction = ",
        "#",
        "missing_key",
        18,
        2,
        "[wall] has no `direction` for the joints",
    ),
    (
        "stiffness = ",
        "#",
        "missing_key",
        18,
        2,
        "[wall] has no `stiffness`",
    ),
    (
        "stiffness = \"0.1 N/mm\"",
        "stiffness_matrix = [[]]",
        "conflicting_keys",
        20,
        1,
        "`wall.direction` and `wall.stiffness_matrix` cannot both be given",
    ),
];

#[test]
fn mistakes_are_shown_in_their_place() {
    let mut wrong = Vec::new();
    for (from, to, kind, line, column, part) in WRONG {
        let text = ARM.trim_start().replacen(from, to, 1);
        let error = match AnyScene::from_toml("arm", &text) {
            Ok(_) => panic!("accepted:\n{text}"),
            Err(error) => error,
        };
        let shown = error.to_string();
        let of_kind = error
            .diagnostics()
            .iter()
            .find(|d| d.kind().name() == *kind);
        let place = of_kind.map(|d| (d.line(), d.column()));
        if place != Some((Some(*line), Some(*column))) || !shown.contains(part) {
            wrong.push(format!("{to}: {place:?} {shown}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_matrix_is_that_of_a_spring() {
    for (to, kind, part) in [
        (
            "[[\"2 N m/rad\", \"3 N m/m\"], [\"4 N/rad\", \"100 N/m\"]]",
            "not_symmetric",
            "row 2, column 1 differs from row 1, column 2",
        ),
        (
            "[[\"2 N m/rad\", \"30 N m/m\"], [\"30 N/rad\", \"100 N/m\"]]",
            "not_semidefinite",
            "has a negative energy in this wall",
        ),
        (
            "[[\"2 N m/rad\", \"3 N m/m\"]]",
            "wrong_count",
            "`wall.stiffness_matrix` has 1 entry, and the device 2 joints",
        ),
        (
            "[[\"2 N m/rad\"], [\"3 N/rad\", \"100 N/m\"]]",
            "wrong_count",
            "a row of entries, one for each of 2 joints",
        ),
        (
            "[[\"2 N m/rad\", \"3 N m\"], [\"3 N/rad\", \"100 N/m\"]]",
            "wrong_unit",
            "has the unit `N m` of a torque; expected a stiffness such as `\"3 N m/m\"`",
        ),
        (
            "\"2 N m/rad\"",
            "wrong_type",
            "`wall.stiffness_matrix` is text; expected a list of rows",
        ),
    ] {
        let before = "[[\"2 N m/rad\", \"3 N m/m\"], [\"3 N/rad\", \"100 N/m\"]]";
        let error = AnyScene::from_toml("arm", &MATRIX.replace(before, to)).unwrap_err();
        assert_eq!(error.diagnostics()[0].kind().name(), kind, "{error}");
        assert!(error.to_string().contains(part), "{error}");
    }
}

#[test]
fn a_scene_of_one_joint_is_asked_for() {
    let error = Scene::from_toml("arm", ARM).unwrap_err();
    assert_eq!(error.diagnostics()[0].kind().name(), "several_joints");
    assert_eq!(error.diagnostics()[0].line(), Some(2));
    let text =
        "[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"1 N/mm\"\ndirection = [\"1\"]\n";
    let error = Scene::from_toml("arm", text).unwrap_err();
    let part = "a wall with a `direction` acts on a device of several joints; expected `[[joint]]` for each joint";
    assert!(error.to_string().contains(part), "{error}");
}
