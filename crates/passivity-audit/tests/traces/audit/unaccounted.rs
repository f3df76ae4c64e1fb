//! Logs that are not accounted for: the force that acted is not known, so nothing is said of what it generated.

use std::fmt::Write as _;

use passivity_audit::Verdict;
use passivity_scene::Scene;
use serde_json::Value;

use super::{audited, scene};

const PLAIN: &str = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n";

/// What an effect is called and adds to a scene, and whether a log with forces is accounted for.
const EFFECTS: [(&str, bool); 4] = [
    ("[sampling]\nlatency = \"9/10\"\n", false),
    ("[amplifier]\ntime_constant = \"1/2\"\n", false),
    (
        "[controller]\nnumerator = [\"1\", \"1\"]\ndenominator = [\"2\"]\n",
        true,
    ),
    (
        "[wall]\ndamping = \"1/2\"\ndamping_time_constant = \"2\"\n",
        true,
    ),
];

/// The figures of the force: energies, and the intervals that violate an account.
const OF_FORCE: [&str; 6] = [
    "generated_linear",
    "generated_quantized",
    "net_linear",
    "net_quantized",
    "violates_linear",
    "violates_quantized",
];

/// The figures of the positions alone.
const OF_POSITIONS: [&str; 4] = [
    "bound_22",
    "bound_quantized",
    "dissipated_lower",
    "criterion_holds",
];

/// A log of so many rows that goes back and forth, with forces where these are asked for.
fn log(form: &str, rows: usize, has_force: bool) -> String {
    let mut text = format!("{form}{}\n", if has_force { ",f" } else { "" });
    for i in 0..rows {
        let position = [0, 3, 7, 4][i % 4];
        let _ = match has_force {
            true => writeln!(text, "{position},-{position}"),
            false => writeln!(text, "{position}"),
        };
    }
    text
}

/// The cells of a file by the names of their columns; an enclosure has two.
fn cells<'t>(header: &'t str, row: &'t str, name: &str) -> Vec<&'t str> {
    let named = header.split(',').zip(row.split(','));
    let is_it = |column: &str| {
        let base = column.trim_end_matches("_lo").trim_end_matches("_hi");
        base == name
    };
    let cells: Vec<&str> = named
        .filter(|(column, _)| is_it(column))
        .map(|(_, cell)| cell)
        .collect();
    assert!(!cells.is_empty(), "{name}: {header}");
    cells
}

fn check_row(row: &Value) {
    for name in OF_FORCE {
        assert!(
            row[name].is_null() && row.get(name).is_some(),
            "{name}: {row}"
        );
    }
    for name in OF_POSITIONS {
        assert!(!row[name].is_null(), "{name}: {row}");
    }
    assert!(row.get("extra_storage").is_none(), "{row}");
}

#[test]
fn of_a_force_that_did_not_act_there_are_no_figures() {
    for (effect, is_accounted_with_forces) in EFFECTS {
        for (form, has_force) in [
            ("xi", false),
            ("count", false),
            ("xi", true),
            ("count", true),
        ] {
            if has_force && is_accounted_with_forces {
                continue;
            }
            // A short log is computed exactly in the end, a long one is not.
            for rows in [40, 1500] {
                let late = scene(&format!("{PLAIN}{effect}"));
                not_accounted(&late, &log(form, rows, has_force), rows as u64 - 1);
            }
        }
    }
}

fn not_accounted(late: &Scene, log: &str, intervals: u64) {
    let (audit, written) = audited(log.as_bytes(), late, 1, 0);
    assert_eq!(audit.verdict(), Verdict::NotCovered);
    assert!(audit.points().is_empty());
    let said = audit.to_json();
    assert_eq!(said["intervals"], intervals);
    let totals = &said["totals"];
    for name in OF_FORCE
        .into_iter()
        .chain(["depends_linear", "depends_quantized", "first_linear"])
    {
        assert!(
            totals[name].is_null() && totals.get(name).is_some(),
            "{name}: {totals}"
        );
    }
    // Friction takes that at the least, whatever force acts.
    let plain = audited(log.as_bytes(), &scene(PLAIN), 1, 0).0.to_json();
    assert_eq!(
        totals["dissipated_lower"],
        plain["totals"]["dissipated_lower"]
    );
    assert!(totals["criterion_fails"].is_u64(), "{totals}");
    for at in [
        "/worst",
        "/first_violation",
        "/first/linear",
        "/first/possible_linear",
        "/first/quantized",
        "/first/possible_quantized",
        "/observer",
        "/running/net_linear",
        "/running/supply",
    ] {
        assert_eq!(said.pointer(at), Some(&Value::Null), "{at}");
    }
    let criterion = said.pointer("/first/criterion/ledger");
    let rows = said["rows"].as_array().into_iter().flatten();
    rows.chain(criterion).for_each(check_row);
    let mut lines = written.lines();
    let header = lines.next().unwrap();
    assert_eq!(written.lines().count() as u64, intervals + 1);
    for line in lines {
        assert_eq!(line.split(',').count(), header.split(',').count());
        for name in OF_FORCE {
            assert!(
                cells(header, line, name).iter().all(|cell| cell.is_empty()),
                "{name}: {line}"
            );
        }
        for name in OF_POSITIONS {
            assert!(
                cells(header, line, name)
                    .iter()
                    .all(|cell| !cell.is_empty()),
                "{name}: {line}"
            );
        }
    }
    let text = audit.to_text();
    assert!(text.contains("NOT ACCOUNTED FOR"), "{text}");
    assert!(
        text.contains("of the positions alone, whatever force acted"),
        "{text}"
    );
    assert!(text.contains("dissipated at least"), "{text}");
    for says in ["generated", "deficit", "worst", "balance", "observer"] {
        assert!(!text.contains(says), "{text}");
    }
}

#[test]
fn nor_are_there_any_before_a_mistake() {
    let late = scene(&format!("{PLAIN}{}", EFFECTS[0].0));
    let (audit, _) = audited(b"xi\n0\n3\n7\nseven\n", &late, 1, 0);
    assert_eq!(audit.verdict(), Verdict::Broken);
    let (said, text) = (audit.to_json(), audit.to_text());
    assert!(said["totals"]["net_linear"].is_null(), "{said}");
    assert!(
        !text.contains("generated") && text.contains("latency"),
        "{text}"
    );
}

/// The account is of the spring, and so is the criterion: where friction is enough for it, and not for the controller, the
/// report does not say that the criterion holds.
#[test]
fn the_criterion_of_a_spring_is_not_said_to_be_that_of_a_controller() {
    let text = "[device]\nviscous = \"0.9 N s/m\"\ncoulomb = \"0.9 N\"\n[sampling]\nperiod = \"1 s\"\n\
        [encoder]\nresolution = \"1 m\"\n[wall]\nstiffness = \"1 N/m\"\n";
    let controller = "[controller]\nnumerator = [\"1.5\", \"-0.5\"]\n";
    let log = "t [s],x [m],f [N]\n0,0,0\n1,10,-10\n2,0,0\n3,10,-10\n";
    for (more, is_said) in [(controller, true), ("", false)] {
        let scene = passivity_scene::Scene::from_toml("s", &format!("{text}{more}")).unwrap();
        let trace = Box::new(std::io::Cursor::new(log.as_bytes().to_vec()));
        let audit = passivity_audit::audit_csv(trace, &scene, passivity_audit::Options::default());
        let text = audit.unwrap().to_text();
        assert_eq!(
            text.contains("of the wall's spring alone"),
            is_said,
            "{text}"
        );
    }
}
