//! What a report says of small scenes of two joints, with figures by hand (TH-NDOF): a direction a and a
//! stiffness k make the wall k·aaᵀ, which asks for k·T/2·Σ aᵢ²/bᵢ ≤ 1 and cᵢ ≥ ½k|aᵢ|Σ|aⱼ|Δⱼ.

use passivity_core::{BigRational, Exact, Interval, Scalar as _, pi};
use passivity_scene::check::{Side, Verdict};
use passivity_scene::joints::{JointLimit, JointReport};
use passivity_scene::number::parse;
use passivity_scene::{AnyScene, JointScene};

use crate::ranges::range;

fn scene(text: &str) -> JointScene {
    match AnyScene::from_toml("two", text) {
        Ok(AnyScene::Joints(scene)) => *scene,
        Ok(AnyScene::One(_)) => panic!("a scene of one joint:\n{text}"),
        Err(error) => panic!("{error}\n{text}"),
    }
}

/// Two sliding joints: viscous and Coulomb friction, resolution and bound of each (`-` for none), and
/// the wall; T = 1 s.
fn report(joints: [[&str; 4]; 2], wall: &str) -> JointReport {
    let mut text = String::new();
    for [viscous, coulomb, resolution, max_speed] in joints {
        text += "[[joint]]\n";
        for (key, value, unit) in [
            ("viscous", viscous, "N s/m"),
            ("coulomb", coulomb, "N"),
            ("max_speed", max_speed, "m/s"),
        ] {
            if value != "-" {
                text += &format!("{key} = \"{value} {unit}\"\n");
            }
        }
        if resolution != "-" {
            text += &format!("encoder = {{ resolution = \"{resolution} m\" }}\n");
        }
    }
    passivity_scene::joints::check(&scene(&format!(
        "{text}[sampling]\nperiod = \"1 s\"\n[wall]\n{wall}\n"
    )))
}

fn q(text: &str) -> BigRational {
    parse(text).unwrap()
}

fn said(of: &JointLimit) -> String {
    let limit = &of.limit;
    let side = match limit.side {
        Side::AtLeast => "≥",
        Side::AtMost => "≤",
    };
    assert_eq!(limit.suffices, limit.printed.is_some(), "{}", of.key);
    assert_eq!(limit.printed, limit.typed, "{}: in SI units", of.key);
    let printed = limit.printed.as_deref().unwrap_or("not enough alone");
    format!("{} {side} {}: {printed}", of.key, range(&limit.border))
}

const WALL: &str = "stiffness = \"1/2 N/m\"\ndirection = [\"1\", \"2\"]";

const TWO: [[&str; 4]; 2] = [["1", "0.8", "1", "-"], ["4", "3", "1/2", "-"]];

fn limits(joints: [[&str; 4]; 2], wall: &str) -> Vec<String> {
    report(joints, wall).limits.iter().map(said).collect()
}

#[test]
fn limits_of_two_joints_are_those_of_the_formulas() {
    for (joints, wall, expected) in [
        // ¼(1/b₁ + 4/b₂) ≤ 1; c₁ ≥ ¼(Δ₁ + 2Δ₂) and c₂ ≥ ½(Δ₁ + 2Δ₂).
        (
            TWO,
            WALL,
            vec![
                "wall.stiffness ≤ 4/5: 0.8",
                "sampling.period ≤ 2: 2",
                "joint[1].viscous ≥ 1/3: 0.33334",
                "joint[1].coulomb ≥ 1/2: 0.5",
                "joint[1].encoder.resolution ≤ 11/5: 2.2",
                "joint[2].viscous ≥ 4/3: 1.3334",
                "joint[2].coulomb ≥ 1: 1",
                "joint[2].encoder.resolution ≤ 11/10: 1.1",
            ],
        ),
        // From the hardest to the easiest end of the others.
        (
            [
                ["1 … 2", "0.8 … 1", "1 … 1.1", "-"],
                ["4 … 5", "3", "1/2", "-"],
            ],
            "stiffness = \"0.4 … 0.5 N/m\"\ndirection = [\"1\", \"2\"]",
            vec![
                "wall.stiffness ≤ 16/21 … 1: 0.7619",
                "sampling.period ≤ 2 … 50/13: 2",
                "joint[1].viscous ≥ 5/21 … 1/3: 0.33334",
                "joint[1].coulomb ≥ 2/5 … 21/40: 0.525",
                "joint[1].encoder.resolution ≤ 11/5 … 4: 2.2",
                "joint[2].viscous ≥ 8/9 … 4/3: 1.3334",
                "joint[2].coulomb ≥ 4/5 … 21/20: 1.05",
                "joint[2].encoder.resolution ≤ 21/20 … 2: 1.05",
            ],
        ),
        // A joint that the wall does not move needs no friction, and nothing is said of it.
        (
            TWO,
            "stiffness = \"1/2 N/m\"\ndirection = [\"1\", \"0\"]",
            vec![
                "wall.stiffness ≤ 8/5: 1.6",
                "sampling.period ≤ 4: 4",
                "joint[1].viscous ≥ 1/4: 0.25",
                "joint[1].coulomb ≥ 1/4: 0.25",
                "joint[1].encoder.resolution ≤ 16/5: 3.2",
            ],
        ),
        // No wall and no period is enough for a joint without viscous friction …
        (
            [["-", "0.8", "1", "-"], ["4", "3", "1/2", "-"]],
            WALL,
            vec![
                "joint[1].viscous ≥ 1/3: 0.33334",
                "joint[1].coulomb ≥ 1/2: not enough alone",
                "joint[1].encoder.resolution ≤ 11/5: not enough alone",
                "joint[2].coulomb ≥ 1: not enough alone",
                "joint[2].encoder.resolution ≤ 11/10: not enough alone",
            ],
        ),
        // … and no wall and no encoder for one without Coulomb friction.
        (
            [["1", "0", "1", "-"], ["4", "3", "1/2", "-"]],
            WALL,
            vec![
                "sampling.period ≤ 2: not enough alone",
                "joint[1].viscous ≥ 1/3: not enough alone",
                "joint[1].coulomb ≥ 1/2: 0.5",
                "joint[2].viscous ≥ 4/3: not enough alone",
                "joint[2].coulomb ≥ 1: not enough alone",
            ],
        ),
        (
            [["1", "0.8", "-", "-"], ["4", "3", "-", "-"]],
            WALL,
            vec![
                "wall.stiffness ≤ 1: 1",
                "sampling.period ≤ 2: 2",
                "joint[1].viscous ≥ 1/3: 0.33334",
                "joint[2].viscous ≥ 4/3: 1.3334",
            ],
        ),
    ] {
        assert_eq!(limits(joints, wall), expected, "{joints:?} {wall}");
    }
    // Bounds that are not needed change nothing.
    let bounded = [["1", "0.8", "1", "1/100"], ["4", "3", "1/2", "1/100"]];
    assert_eq!(limits(bounded, WALL), limits(TWO, WALL));
}

/// Up to bounds Vᵢ: cᵢ + bᵢvᵢ ≥ ½Σ|Kᵢⱼ|(Δⱼ + T·vⱼ) for all vᵢ ≤ Vᵢ; here K is ½, 1 and 2.
#[test]
fn limits_up_to_the_bounds_of_the_joints() {
    let bounded = |viscous: [&'static str; 2], bound: &'static str| {
        [
            [viscous[0], "0.8", "1", bound],
            [viscous[1], "3", "1/2", "1"],
        ]
    };
    let two = bounded(["1/4", "1"], "1/2");
    assert_eq!(
        limits(two, WALL),
        [
            // 0.8 against k(½ + 3/2) while joint 1 rests; 0.8 against ½(1 + T).
            "wall.stiffness ≤ 2/5: 0.4",
            "sampling.period ≤ 3/5: 0.6",
            "joint[1].viscous ≥ 13/20: not enough alone",
            "joint[1].coulomb ≥ 1: 1",
            "joint[1].encoder.resolution ≤ 1/5: 0.2",
            "joint[1].max_speed ≤ 4: not enough alone",
            "joint[2].coulomb ≥ 5/4: not enough alone",
            "joint[2].encoder.resolution ≤ 1/10: 0.1",
            "joint[2].max_speed ≤ 3/5: 0.6",
        ]
    );
    let bounds = report(bounded(["1/4", "1"], "1/2 … 1"), WALL);
    let said: Vec<_> = bounds.limits.iter().map(said).collect();
    assert!(
        said.contains(&"joint[1].viscous ≥ 9/20 … 13/20: not enough alone".to_owned()),
        "{said:?}"
    );
    assert!(
        said.contains(&"joint[2].coulomb ≥ 5/4 … 3/2: not enough alone".to_owned()),
        "{said:?}"
    );
    // None may be needed, or some: 5/4 − c₁ at V₁ = 1.
    let some = [["1/4", "1.1 … 1.3", "1", "1/2 … 1"], ["1", "3", "1/2", "1"]];
    let some = limits(some, WALL);
    let viscous = some
        .iter()
        .find(|said| said.starts_with("joint[1].viscous"));
    assert!(
        viscous.is_some_and(|said| said.contains("≥ 0 … 3/20: ")),
        "{some:?}"
    );
    let stiffest = |report: &JointReport| {
        [
            &report.max_stiffness_all_speeds,
            &report.max_stiffness_at_speed_bound,
        ]
        .map(|x| x.as_ref().map(range))
    };
    // ½k(4 + 4) ≤ 1.
    assert_eq!(
        stiffest(&bounds),
        [Some("1/4".to_owned()), Some("2/5".to_owned())]
    );
    assert_eq!(stiffest(&report(TWO, WALL)), [Some("4/5".to_owned()), None]);
    // None where Coulomb friction may be zero, and c₁ ≥ ½k(1 + 2·½) where it is 1/2; or is zero.
    for (coulomb, expected) in [("0 … 1/2", "0 … 1/2"), ("0", "0")] {
        let none = report([["1", coulomb, "1", "-"], ["4", "3", "1/2", "-"]], WALL);
        assert_eq!(stiffest(&none), [Some(expected.to_owned()), None]);
    }
}

const MATRIX: &str = "stiffness_matrix = [[\"1/2 N/m\", \"1/4 N/m\"], [\"1/4 N/m\", \"1 N/m\"]]";

#[test]
fn limits_of_a_matrix_are_those_of_the_formulas() {
    // c₁ ≥ ½(Δ₁/2 + Δ₂/4), c₂ ≥ ½(Δ₁/4 + Δ₂), (b₁ − T/4)(b₂ − T/2) ≥ (T/8)².
    let mut found = limits(TWO, MATRIX);
    // 4 − 3T/2 + 7T²/64 = 0.
    let period = found.remove(1);
    assert!(period.ends_with(": 3.6246"), "{period}");
    assert_eq!(
        found,
        [
            "wall.stiffness_matrix ≤ 64/25: 2.56",
            "joint[1].viscous ≥ 57/224: 0.25447",
            "joint[1].coulomb ≥ 5/16: 0.3125",
            "joint[1].encoder.resolution ≤ 59/20: 2.95",
            "joint[2].viscous ≥ 25/48: 0.52084",
            "joint[2].coulomb ≥ 3/8: 0.375",
            "joint[2].encoder.resolution ≤ 22/5: 4.4",
        ]
    );
    let plain = report(TWO, MATRIX);
    // Of the matrix the limit is a factor; the period's is a time.
    let text = plain.to_text();
    assert!(
        text.contains("    sampling period T: at most 3.6246 s"),
        "{text}"
    );
    assert_eq!(
        plain.max_matrix_factor.as_ref().map(range).as_deref(),
        Some("64/25")
    );
    assert_eq!(
        (
            plain.max_stiffness_all_speeds,
            plain.max_stiffness_at_speed_bound
        ),
        (None, None)
    );
    // c₁ ≥ ½f(1/2 + 1/8).
    let none = report([["1", "0 … 1/4", "1", "-"], ["4", "3", "1/2", "-"]], MATRIX);
    assert_eq!(
        none.max_matrix_factor.as_ref().map(range).as_deref(),
        Some("0 … 4/5")
    );
    let bounded = report([["1/4", "0.8", "1", "1/2"], ["1", "3", "1/2", "1"]], MATRIX);
    // 0.8 + ¼·½ against ½f(½·3/2 + ¼·3/2), both joints at their bounds.
    assert_eq!(
        bounded.max_matrix_factor.as_ref().map(range).as_deref(),
        Some("74/45")
    );
    assert_eq!(bounded.max_stiffness_at_speed_bound, None);
    assert_eq!(
        (bounded.verdict, bounded.at_every_speed),
        (Verdict::Passive, false)
    );
}

const NOT_USED: &str = "the criterion does not use `max_speed`: the wall couples a joint that has one to a joint \
     without; only a motion that is shown to draw energy keeps to it";

/// A motion keeps to a bound that the criterion cannot use: joint 1 without viscous friction draws only fast.
#[test]
fn a_bound_of_one_joint_holds_for_what_draws() {
    for (bound, expected) in [
        ("-", Verdict::NotPassive),
        ("100", Verdict::NotPassive),
        ("1/100", Verdict::NotGuaranteed),
    ] {
        let report = report([["0", "2", "1", bound], ["4", "3", "1/2", "-"]], WALL);
        assert_eq!(report.verdict, expected, "{bound}");
        let remarks: &[&str] = match bound {
            "-" => &[],
            _ => &[NOT_USED],
        };
        assert_eq!(report.remarks, remarks);
        let moves = report.witness.map(|witness| witness.moves);
        assert_eq!(moves.is_some(), expected == Verdict::NotPassive);
        if let (Some(moves), "100") = (moves, bound) {
            // Ticks of 1 m in 1 s.
            assert!(moves.iter().all(|step| step[0] < q("100")), "{moves:?}");
        }
    }
}

#[test]
fn what_each_joint_needs_and_has() {
    let report = report(
        [["1 … 2", "0.8 … 1", "1 … 1.1", "1/2"], ["4", "-", "-", "-"]],
        "stiffness = \"0.4 … 0.5 N/m\"\ndirection = [\"1\", \"2\"]",
    );
    let [first, second] = &report.joints[..] else {
        panic!("two joints")
    };
    let of = |x: &Option<Interval<BigRational>>| x.as_ref().map(range);
    assert_eq!(
        [&first.viscous, &first.coulomb].map(range),
        ["1 … 2", "4/5 … 1"]
    );
    assert_eq!(
        (
            of(&first.resolution).as_deref(),
            of(&first.max_speed).as_deref()
        ),
        (Some("1 … 11/10"), Some("1/2"))
    );
    // ½k|aᵢ|Δ₁: 0.2·1 to 0.25·1.1.
    assert_eq!(
        [&first.coulomb_needed, &first.spare_coulomb].map(range),
        ["1/5 … 11/40", "21/40 … 4/5"]
    );
    assert_eq!(
        [&second.coulomb_needed, &second.spare_coulomb].map(range),
        ["2/5 … 11/20", "-11/20 … -2/5"]
    );
    assert_eq!(
        (of(&second.resolution), of(&second.max_speed)),
        (None, None)
    );
    assert_eq!(report.remarks, [NOT_USED]);
    assert!(self::report(TWO, WALL).remarks.is_empty());
    assert!(
        self::report([["1", "0.8", "1", "1"], ["4", "3", "1/2", "1"]], WALL)
            .remarks
            .is_empty()
    );
}

/// c₁ ≥ ¼(Δ₁ + 2Δ₂) by m in the middle, and each tolerance moves it by so much.
#[test]
fn what_decides_is_what_alone_turns_the_verdict() {
    for (coulomb, first, second, expected) in [
        // m = 0 and ±1/20 by each of three: none alone.
        (
            "0.5 ± 0.05",
            "1 ± 0.2",
            "0.5 ± 0.1",
            vec![
                "joint[1].coulomb",
                "joint[1].encoder.resolution",
                "joint[2].encoder.resolution",
            ],
        ),
        // ±1/10, ±3/100, ±3/100 about 1/20 and −1/20.
        (
            "0.55 ± 0.1",
            "1 ± 0.12",
            "0.5 ± 0.06",
            vec!["joint[1].coulomb"],
        ),
        (
            "0.45 ± 0.1",
            "1 ± 0.12",
            "0.5 ± 0.06",
            vec!["joint[1].coulomb"],
        ),
    ] {
        let report = report([["1", coulomb, first, "-"], ["4", "3", second, "-"]], WALL);
        assert_eq!(
            (report.verdict, report.decided_by),
            (
                Verdict::Depends,
                expected.into_iter().map(str::to_owned).collect()
            )
        );
    }
}

#[test]
fn limits_are_written_as_the_file_writes_them() {
    let joint = "[[joint]]\nviscous = \"2 N s/m\"\ncoulomb = \"800 mN\"\nencoder = { resolution = \"30 cm\" }\n";
    let text = format!(
        "{joint}[sampling]\nrate = \"1 Hz\"\n[wall]\nstiffness = \"1 N/m\"\ndirection = [\"1\"]\n"
    );
    let report = passivity_scene::joints::check(&scene(&text));
    let typed = |limit: &JointLimit| {
        let [printed, typed] =
            [&limit.limit.printed, &limit.limit.typed].map(|x| x.clone().unwrap());
        format!("{printed} {typed}{}", limit.limit.written.unit())
    };
    let typed: Vec<_> = report.limits.iter().map(typed).collect();
    // 2b/T and 2c/Δ.
    assert_eq!(
        typed,
        [
            "4 4 N/m",
            "4 0.25 Hz",
            "0.5 0.5 N s/m",
            "0.15 150 mN",
            "1.6 160 cm"
        ]
    );
}

/// What is gained is at least what is said, with π as well: KΔ²·s for each way of s ticks by what the held
/// force changes, less what friction takes.
#[test]
fn a_witness_with_pi_gains_what_it_says() {
    let joint = "[[joint]]\nviscous = \"1/4 N m s/rad\"\ncoulomb = \"1e-3 N m\"\nencoder = { counts_per_revolution = 2000 }\n";
    let text = format!(
        "{joint}[sampling]\nperiod = \"1 s\"\n[wall]\nstiffness = \"1 N m/rad\"\ndirection = [\"1\"]\n"
    );
    let report = passivity_scene::joints::check(&scene(&text));
    let witness = report.witness.unwrap();
    assert_eq!(witness.units, ["ticks"]);
    let (from, step) = (&witness.from[0], &witness.moves[0][0]);
    let held = (from + step).floor() - from.floor();
    let tick = pi::pi().over(Exact::of(&q("1000")));
    let way = tick.clone() * Exact::of(step);
    let spent =
        way.clone() * way.clone() * Exact::of(&q("1/2")) + way.abs() * Exact::of(&q("2e-3"));
    let gain = way * tick * Exact::of(&held) - spent;
    assert!(Exact::of(&witness.gain_per_cycle) <= gain);
    assert!(gain - Exact::of(&witness.gain_per_cycle) < Exact::of(&q("1e-50")));
}
