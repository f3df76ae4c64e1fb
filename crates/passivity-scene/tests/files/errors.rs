//! Every kind of mistake: its place, what was found, what was expected, and how it looks.

use std::collections::BTreeSet;

use passivity_core::Parameter;
use passivity_scene::{Scene, SceneError};

const GOOD: &str = "[sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"1 N m/rad\"\n";

fn error(text: &str) -> SceneError {
    Scene::from_toml("scene.toml", text).expect_err(text)
}

/// The kinds of its mistakes, in their order.
fn kinds(error: &SceneError) -> Vec<&'static str> {
    let diagnostics = error.diagnostics().iter();
    diagnostics.map(|d| d.kind().name()).collect()
}

fn after_good(more: &str) -> SceneError {
    error(&format!("{GOOD}{more}"))
}

/// Mistakes: what stands after the good sections, kind, line, column, a part of the message.
#[rustfmt::skip]
const CASES: [(&str, &str, usize, usize, &str); 60] = [
    ("[divice]\n", "unknown_section", 5, 2, "a scene has no section `[divice]`"),
    ("[device]\nviscosity = \"1 N m s\"\n", "unknown_key", 6, 1, "`viscosity` is not a key of [device]"),
    ("[device]\ninertia.x = 1\n", "wrong_type", 6, 1, "`device.inertia` is a table"),
    ("[device]\nstiffness = \"1 N m/rad\"\n", "wrong_section", 6, 1, "`stiffness` is not a key of [device]"),
    ("[wall]\n", "duplicate", 5, 2, "this key or section is given twice"),
    ("[device]\ncoulomb = \"1 N m\"\ncoulomb = \"1 N m\"\n", "duplicate", 7, 1, "this key or section is given twice"),
    ("[device]\nviscous \"1\"\n", "syntax", 6, 9, "this is not TOML"),
    ("[device]\nviscous = \n", "syntax", 6, 11, "this is not TOML"),
    ("[device\n", "syntax", 5, 8, "this is not TOML"),
    ("[encoder]\ncounts_per_revolution = 99999999999999999999\n", "syntax", 6, 25, "expected a whole number of at most 9223372036854775807"),
    ("[device]\nviscous = \"\0 N\"\n", "syntax", 6, 12, "this is not TOML"),
    ("[device]\nmass = \"1 kg\"\ninertia = \"1 kg m^2\"\n", "conflicting_keys", 7, 1, "`device.inertia` and `device.mass` cannot both be given"),
    ("[encoder]\nresolution = \"1 deg\"\ncounts_per_revolution = 4\n", "conflicting_keys", 7, 1, "cannot both be given"),
    ("[dimensionless]\n", "conflicting_keys", 2, 1, "`sampling.period` and [dimensionless] cannot both be given"),
    ("[encoder]\n", "missing_key", 5, 2, "[encoder] has no `counts_per_revolution` or `resolution`"),
    ("[amplifier]\n", "missing_key", 5, 2, "[amplifier] has no `time_constant`"),
    ("[start]\n", "missing_key", 5, 2, "[start] has no `position` or `velocity`"),
    ("[operator]\narm = {}\n", "missing_key", 6, 1, "[operator.arm] has no `mass`, `damping` or `stiffness`"),
    ("[operator]\nforce = {}\n", "missing_key", 6, 9, "a force has no `file`"),
    ("[device]\nviscous = 9e-6\n", "missing_unit", 6, 11, "expected a rotary damping such as `\"9e-6 N m s/rad\"`"),
    ("[device]\nviscous = \"9e-6\"\n", "missing_unit", 6, 12, "`device.viscous` is a number without a unit"),
    ("[device]\nviscous = true\n", "wrong_type", 6, 11, "`device.viscous` is a boolean"),
    ("[device]\nviscous = [1]\n", "wrong_type", 6, 11, "`device.viscous` is a list"),
    ("[device]\nviscous = 2001-01-01\n", "wrong_type", 6, 11, "`device.viscous` is a date"),
    ("[[device]]\nviscous = 1\n", "wrong_type", 5, 3, "`device` is not a section"),
    ("[run]\nintervals = true\n", "wrong_type", 6, 13, "`run.intervals` is a boolean"),
    ("[operator]\narm = 3\n", "wrong_type", 6, 7, "`operator.arm` is a number"),
    ("[operator]\nforce = { file = 3 }\n", "missing_key", 6, 9, "a force has no `file`"),
    ("[device]\nviscous = \"\"\n", "empty_number", 6, 12, "expected a number, found nothing"),
    ("[device]\nviscous = \"abc N m s\"\n", "malformed_number", 6, 12, "expected a number such as `0.375` or `3/8`, found `a`"),
    ("[device]\nviscous = \"inf N m s\"\n", "not_finite", 6, 12, "`inf` is not a number that a quantity can have"),
    ("[device]\nviscous = \"1/0 N m s\"\n", "zero_denominator", 6, 14, "denominator zero"),
    ("[device]\nviscous = \"1e999999999 N m s\"\n", "exponent_too_large", 6, 14, "between -500 and 500"),
    ("[device]\nviscous = \"1 N m s ± 1e501\"\n", "exponent_too_large", 6, 24, "between -500 and 500"),
    ("[device]\nviscous = \"1 N m parsec\"\n", "unknown_unit", 6, 18, "unknown unit `parsec`"),
    ("[device]\nviscous = \"1 N m s/\"\n", "malformed_unit", 6, 20, "expected a unit here, found nothing"),
    ("[device]\nviscous = \"1 N m/rad s\"\n", "malformed_unit", 6, 22, "multiplied or divided"),
    ("[device]\nviscous = \"1 N m\"\n", "wrong_unit", 6, 14, "`device.viscous` has the unit `N m` of a torque"),
    ("[sampling.x]\n", "unknown_key", 5, 11, "`x` is not a key of [sampling]"),
    ("[device]\nviscous = \"1 N m s ±\"\n", "malformed_tolerance", 6, 20, "a tolerance is missing after the ±"),
    ("[device]\nviscous = \"1 N m s ± -1%\"\n", "malformed_tolerance", 6, 22, "a tolerance cannot be negative"),
    ("[device]\nviscous = \"1 N m s ± 1 N m\"\n", "malformed_tolerance", 6, 24, "not in the unit of the value"),
    ("[device]\nviscous = \"-1 N m s\"\n", "out_of_bounds", 6, 11, "`device.viscous` cannot be `-1 N m s`"),
    ("[device]\ninertia = \"0 kg m^2\"\n", "out_of_bounds", 6, 11, "expected a value above zero"),
    ("[device]\nviscous = \"1 N m s ± 101%\"\n", "tolerance_out_of_bounds", 6, 11, "as low as -0.01 N m s"),
    ("[device]\ninertia = \"1 kg m^2 ± 1\"\n", "tolerance_out_of_bounds", 6, 11, "expected a value above zero"),
    ("[encoder]\ncounts_per_revolution = 0\n", "out_of_bounds", 6, 25, "a whole number from 1 to"),
    ("[encoder]\ncounts_per_revolution = 8192.5\n", "out_of_bounds", 6, 25, "a whole number from 1 to"),
    ("[encoder]\ncounts_per_revolution = 1e300\n", "out_of_bounds", 6, 25, "a whole number from 1 to"),
    ("[run]\nintervals = -1\n", "out_of_bounds", 6, 13, "a whole number from 1 to"),
    ("[run]\nintervals = \"x\"\n", "malformed_number", 6, 13, "a whole number from 1 to"),
    ("[device]\ncoulomb = \"1 N\"\n", "mixed_motion", 6, 14, "`device.coulomb` is linear (`N`), but `wall.stiffness` is rotary (`N m/rad`)"),
    ("[device]\nmass = \"1 kg\"\n", "mixed_motion", 6, 11, "`device.mass` is linear"),
    ("[device]\nmass = \"1 kg\"\n", "mixed_motion", 6, 11, "expected `inertia`, a moment of inertia such as `\"6.28e-6 kg m^2\"`"),
    ("[device]\ncoulomb = \"1 N m\"\n[transmission]\nratio = \"10 mm/rev\"\n", "mixed_motion", 8, 9, "expected a plain number, such as `9.375`, of turns to turns"),
    ("[device]\nmass = \"1 kg m^2\"\n", "wrong_unit", 6, 11, "of a moment of inertia"),
    ("[encoder]\nresolution = \"1 mm\"\n", "mixed_motion", 6, 17, "expected an angle such as `\"0.1 deg\"`"),
    ("[operator]\nforce = \"forces.csv\"\n", "samples", 6, 9, "only a scene that is a file itself can name one"),
    ("[run]\nname = \"x\"\n", "wrong_section", 6, 1, "`name` is not a key of [run]"),
    ("[start]\nvelocity = \"1 tick/sample\"\n", "unknown_unit", 6, 15, "unknown unit `tick`"),
];

#[test]
fn every_mistake_has_its_kind_and_its_place() {
    for (more, kind, line, column, part) in CASES {
        let error = after_good(more);
        let first = error.diagnostics().iter().find(|d| d.kind().name() == kind);
        let first = first.unwrap_or_else(|| panic!("{more:?}: {error}"));
        assert_eq!(
            (first.line(), first.column()),
            (Some(line), Some(column)),
            "{more:?}\n{error}"
        );
        let shown = error.to_string();
        assert!(shown.contains(part), "{more:?}: {shown}");
        assert!(shown.starts_with("scene.toml:"), "{shown}");
        // The rendered text names file, line and column, marks the place, and uses no colours.
        let rendered = error.render(false);
        assert!(
            rendered.contains(&format!("[scene.toml:{line}:{column}]")),
            "{rendered}"
        );
        assert!(
            rendered.contains(kind) && !rendered.contains('\u{1b}'),
            "{rendered}"
        );
        // And for programs the same.
        let json = error.to_json();
        let listed = json["errors"].as_array().unwrap();
        let found = listed.iter().find(|e| e["kind"] == kind).unwrap();
        assert_eq!(found["at"]["line"], line);
        assert_eq!(found["at"]["column"], column);
    }
}

#[test]
fn two_keys_of_one_parameter_are_one_mistake() {
    for (section, keys) in [
        ("sampling", ["period = \"1 ms\"", "rate = \"1 kHz\""]),
        (
            "encoder",
            ["resolution = \"1 deg\"", "counts_per_revolution = 4"],
        ),
        (
            "wall",
            [
                "damping_cutoff = \"9 Hz\"",
                "damping_time_constant = \"1 ms\"",
            ],
        ),
    ] {
        let wall = "[wall]\nstiffness = \"1 N m/rad\"\ndamping = \"1e-4 N m s/rad\"\n";
        let [mut wall, mut sampling] = [wall.to_owned(), "[sampling]\n".to_owned()];
        let mut rest = String::new();
        let both = keys.join("\n") + "\n";
        match section {
            "wall" => wall += &both,
            "sampling" => sampling += &both,
            _ => rest = format!("[{section}]\n{both}"),
        }
        if section != "sampling" {
            sampling += "period = \"1 ms\"\n";
        }
        let error = error(&format!("{wall}{sampling}{rest}"));
        assert_eq!(error.diagnostics().len(), 1, "{error}");
        assert!(!error.to_string().contains("side"), "{error}");
    }
}

#[test]
fn a_dimensionless_scene_refuses_units_and_what_it_has_already() {
    let cases = [
        (
            "mu = \"1 kg\"",
            "wrong_unit",
            "`dimensionless.mu` has the unit `kg` in a dimensionless scene",
        ),
        (
            "beta = \"-1\"",
            "out_of_bounds",
            "expected zero or a value above it",
        ),
        (
            "sigma = nan",
            "not_finite",
            "not a number that a quantity can have",
        ),
        (
            "gamma = 1",
            "unknown_key",
            "expected one of `mu`, `beta`, `sigma`",
        ),
        (
            "beta = 1\n[device]\nviscous = \"1 N s/m\"",
            "conflicting_keys",
            "[device] and [dimensionless]",
        ),
        (
            "beta = 1\n[encoder]\nresolution = \"1\"",
            "conflicting_keys",
            "[encoder] and [dimensionless]",
        ),
        (
            "beta = 1\n[wall]\nstiffness = 2",
            "conflicting_keys",
            "`wall.stiffness` and [dimensionless]",
        ),
        (
            "beta = 1\n[sampling]\nrate = 2",
            "conflicting_keys",
            "`sampling.rate` and [dimensionless]",
        ),
        (
            "beta = 1\n[start]\nvelocity = \"1 rad/s\"",
            "wrong_unit",
            "in ticks per sample",
        ),
    ];
    for (more, kind, part) in cases {
        let error = error(&format!("[dimensionless]\n{more}\n"));
        assert_eq!(kinds(&error), [kind], "{more}: {error}");
        assert!(error.to_string().contains(part), "{error}");
    }
}

#[test]
fn a_scene_without_the_needful_says_what_is_missing() {
    let empty = error("");
    assert_eq!(kinds(&empty), ["missing_key", "missing_key"]);
    assert_eq!(
        empty.to_string(),
        "scene.toml:1:1: the scene has no [wall] with `stiffness`; expected `stiffness`\n\
         scene.toml:1:1: the scene has no [sampling] with `period` or `rate`; \
         expected `period` or `rate`"
    );
}

/// A row of the table that no section reads would be a key that is refused and offered in one error.
#[test]
fn every_key_of_the_table_of_parameters_is_read() {
    for parameter in Parameter::ALL {
        let row = parameter.row();
        let keys = [row.key].into_iter().filter(|key| !key.is_empty());
        let others = row.other_keys.iter().copied().chain(row.dimensionless_key);
        for key in keys.chain(others) {
            // The motor's side is read only beside the transmission that leads to the device.
            let transmission = match key.starts_with("motor.") {
                true => "transmission.ratio = 2\n",
                false => "",
            };
            let kinds = kinds(&error(&format!("{transmission}{key} = true\n")));
            assert!(kinds.contains(&"wrong_type"), "{key}: {kinds:?}");
            for kind in ["unknown_section", "unknown_key", "wrong_section"] {
                assert!(!kinds.contains(&kind), "{key}: {kinds:?}");
            }
        }
    }
}

#[test]
fn all_mistakes_are_told_at_once_in_the_order_of_the_text() {
    let text = "[device]\nviscous = \"-1 N s/m\"\nmas = \"1 kg\"\n[sampling]\nperiod = 1\n\
                [wall]\nstiffness = \"1 N/mm\"\ndamping = \"x\"\n[walls]\n";
    let error = error(text);
    let places: Vec<_> = error
        .diagnostics()
        .iter()
        .map(|d| (d.line().unwrap(), d.kind().name(), d.scene_key().unwrap()))
        .collect();
    assert_eq!(
        places,
        [
            (2, "out_of_bounds", "device.viscous"),
            (3, "unknown_key", "device.mas"),
            (5, "missing_unit", "sampling.period"),
            (8, "malformed_number", "wall.damping"),
            (9, "unknown_section", "walls"),
        ]
    );
}

#[test]
fn slips_come_with_what_may_have_been_meant() {
    let cases = [
        ("[device]\nviscuous = 1\n", "did you mean `viscous`?"),
        ("[Device]\n", "did you mean `[device]`?"),
        (
            "[encoder]\ncpr = 1\n",
            "did you mean `encoder.counts_per_revolution`?",
        ),
        ("[sampling.rate]\n", "`sampling.rate` is a table"),
        ("[wall.max-force]\n", "did you mean `max_force`?"),
        ("[device]\nviscous = \"1 Nms\"\n", "did you mean `Nm s`?"),
        (
            "[device]\nviscous = \"1,5 N m s\"\n",
            "a decimal point is written `.`",
        ),
        (
            "[operator]\nvelocity = 1\n",
            "`velocity` belongs in [start]",
        ),
    ];
    for (more, help) in cases {
        let rendered = after_good(more).render(false);
        assert!(rendered.contains(help), "{rendered}");
    }
}

#[test]
fn the_rendered_text_marks_the_place() {
    let text = "[device]\nviscous = \"9e-6 N m foo/rad\"\n";
    let expected = "\
unknown_unit

  × unknown unit `foo`
   ╭─[scene.toml:6:21]
 5 │ [device]
 6 │ viscous = \"9e-6 N m foo/rad\"
   ·                     ─┬─
   ·                      ╰── expected a rotary damping such as `\"9e-6 N m s/rad\"`
   ╰────

";
    assert_eq!(after_good(text).render(false), expected);
    let coloured = after_good(text).render(true);
    assert!(coloured.contains('\u{1b}'));
}

#[test]
fn a_long_line_is_shown_where_it_matters() {
    let filler = "x".repeat(5000);
    let text = format!("[device]\nviscous = \"1 N m {filler} s\"\n");
    let error = after_good(&text);
    assert!(error.render(false).len() < 2000, "{}", error.render(false));
    assert!(error.to_string().len() < 400);
    // A comment behind it, and characters of several bytes before it.
    let text = format!("[device]\n\"ключ\" = 1 # {filler}\n");
    let error = after_good(&text);
    assert!(error.render(false).contains("[scene.toml:6:1]"));
    assert!(error.render(false).len() < 2000);
}

#[test]
fn characters_that_move_the_cursor_are_not_passed_on() {
    let text = "[device]\nviscous = \"\u{1b}[2J\u{202e} N\"\n\"\u{9b}\" = 1\n";
    for text in [text.to_owned(), text.replace('\u{1b}', "")] {
        let rendered = after_good(&text).render(false);
        let hidden = ['\u{1b}', '\u{202e}', '\u{9b}'];
        assert!(!rendered.contains(hidden), "{rendered}");
        assert!(!after_good(&text).to_string().contains(hidden));
    }
}

#[test]
fn json_scenes_name_the_key() {
    let value = serde_json::json!({"dimensionless": {"beta": -1, "sigma": null}, "walls": {}});
    let error = Scene::from_json(&value).unwrap_err();
    let keys: Vec<_> = error
        .diagnostics()
        .iter()
        .map(|d| d.scene_key().unwrap())
        .collect();
    let keys: BTreeSet<_> = keys.into_iter().collect();
    let expected = ["dimensionless.beta", "dimensionless.sigma", "walls"];
    assert_eq!(keys, BTreeSet::from(expected));
    assert!(error.to_json()["errors"][0]["at"].is_null());
    assert!(error.to_string().contains("scene: dimensionless.beta: "));
    for value in [
        serde_json::json!(3),
        serde_json::json!([]),
        serde_json::json!(null),
    ] {
        let error = Scene::from_json(&value).unwrap_err();
        assert_eq!(error.diagnostics()[0].kind().name(), "wrong_type");
    }
}
