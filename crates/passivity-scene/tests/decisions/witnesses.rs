//! Motions that draw energy: which are found beside the border, under bounds and over tolerances (TH-LTI,
//! TH-LATENCY, TH-LAG, TH-NDOF). What each gains is computed again in `linear`, and for joints here.

use passivity_core::BigRational;
use passivity_scene::check::{Verdict, check};
use passivity_scene::{AnyScene, JointScene};

use crate::wall::{q, scene};

/// The motions of one frequency, and across an edge: how many samples they have, where they begin, how far
/// they go, and what they gain.
#[test]
fn motions_that_are_found() {
    for (values, samples, from, to, gain) in [
        // Two samples of force against one of friction: θ = 2π/17 and so on, ever longer to the border.
        ("viscous 1, coulomb 2, delay 1", 17, "18", "44", "54"),
        ("viscous 1.4, coulomb 2, delay 1", 39, "183", "398", "706/5"),
        (
            "viscous 1, coulomb 2, delay 1, smooth",
            17,
            "18",
            "44",
            "54",
        ),
        (
            "viscous 1, coulomb 2, delay 1, max_speed 8.1",
            17,
            "18",
            "44",
            "54",
        ),
        (
            "viscous 1, coulomb 2, delay 1, max_force 60",
            17,
            "18",
            "44",
            "54",
        ),
        (
            "viscous 1, coulomb 2, delay 1, force_step 1",
            17,
            "18",
            "44",
            "54",
        ),
        (
            "viscous 1, coulomb 2, delay 1, force_step 1 … 2",
            17,
            "35",
            "86",
            "422",
        ),
        // THEORY's motion of period 6, and there and back.
        (
            "viscous 1.249, coulomb 2, delay 1, damping 1/2",
            6,
            "2048",
            "8192",
            "2195456/125",
        ),
        ("viscous 0.9, coulomb 2, damping 1/2", 2, "0", "32", "384/5"),
        (
            "viscous 0.79, coulomb 9, latency 0.3",
            68,
            "21125",
            "44298",
            "2230889/5",
        ),
        (
            "viscous 1, coulomb 9, numerator [\"1.5\",\"-0.5\",\"1\"]",
            19,
            "40",
            "96",
            "1351",
        ),
        // Across an edge a is half of (s* − σ)/β or less.
        (
            "viscous 1, coulomb 1.4, delay 1, damping 1",
            4,
            "1",
            "19/20",
            "1/200",
        ),
        (
            "viscous 9, coulomb 1.4, delay 1, damping 1",
            4,
            "1",
            "179/180",
            "1/1800",
        ),
        (
            "viscous 9, coulomb 1.4, delay 1, damping 1, max_speed 1/100",
            4,
            "1",
            "199/200",
            "11/20000",
        ),
        (
            "viscous 9, coulomb 0.4, latency 0.3",
            4,
            "1",
            "179/180",
            "1/1800",
        ),
        (
            "viscous 4, coulomb 1, numerator [\"0.5\",\"-1\",\"1.2\",\"0.4\"]",
            2,
            "1",
            "53/54",
            "41/14580",
        ),
    ] {
        let report = check(&scene(values));
        assert_eq!(report.verdict, Verdict::NotPassive, "{values}");
        let witness = report.witness.unwrap();
        assert_eq!(witness.positions.len(), samples, "{values}");
        assert_eq!(
            [witness.from, witness.to, witness.gain_per_cycle],
            [from, to, gain].map(q),
            "{values}"
        );
    }
    for (values, verdict) in [
        (
            "viscous 1, coulomb 2, delay 1, max_speed 3",
            Verdict::Passive,
        ),
        (
            "viscous 1, coulomb 2, delay 1, max_speed 7.9",
            Verdict::NotGuaranteed,
        ),
        (
            "viscous 1, coulomb 2, delay 1, max_force 20",
            Verdict::NotGuaranteed,
        ),
        (
            "viscous 1.49999, coulomb 2, delay 1, max_force 1000",
            Verdict::NotGuaranteed,
        ),
    ] {
        assert_eq!(check(&scene(values)).verdict, verdict, "{values}");
    }
}

/// A lag's response never ends, so that gains are computed to 2⁻⁶⁴ and lowered by what is left out.
#[test]
fn motions_behind_an_amplifier() {
    for (values, samples, to, least, most) in [
        (
            "viscous 9, coulomb 0.4, time_constant 1",
            20,
            "180/181",
            "0.00055467664929370",
            "0.00055467664929371",
        ),
        (
            "viscous 9, coulomb 0.4, time_constant 1/2, latency 1.3, delay 1",
            20,
            "180/181",
            "0.00055553135964747",
            "0.00055553135964748",
        ),
        (
            "viscous 9, coulomb 0.6, damping 1/2, damping_time_constant 1",
            2,
            "1",
            "0.00024691",
            "0.00024692",
        ),
        (
            "viscous 0.8, coulomb 2, damping 1, damping_time_constant 1",
            2,
            "64",
            "17.0666",
            "17.0667",
        ),
        (
            "viscous 0.8333, coulomb 2, damping 1, damping_time_constant 1",
            2,
            "65536",
            "24187.15",
            "24187.16",
        ),
    ] {
        let witness = check(&scene(values)).witness.expect(values);
        assert_eq!(
            (witness.positions.len(), witness.to),
            (samples, q(to)),
            "{values}"
        );
        let gain = witness.gain_per_cycle;
        assert!(q(least) <= gain && gain <= q(most), "{values}: {gain}");
    }
}

/// Near the border the period is too long to write down: A·cos(2πqh/p), to p/4·A/q.
#[test]
fn motions_as_formulas() {
    for (values, [turns, period, amplitude], to, gain) in [
        (
            "viscous 1.49999, coulomb 2, delay 1",
            ["1", "2048", "2097152"],
            "1073741824",
            "19661091873656896/5903125",
        ),
        (
            "viscous 1.499999, coulomb 2, delay 1",
            ["5", "32768", "16777216"],
            "27487790694",
            "8476778499280230855168/57826390625",
        ),
        (
            "viscous 1.49999, coulomb 2, delay 1, force_step 1",
            ["1", "2048", "2097152"],
            "1073741824",
            "6984221419256896/5903125",
        ),
        (
            "viscous 3.1499, coulomb 9, numerator [\"0.5\",\"-1\",\"1.2\",\"0.4\"]",
            ["1", "2048", "1048576"],
            "536870912",
            "73866466080550784/8314375",
        ),
    ] {
        let witness = check(&scene(values)).witness.expect(values);
        let wave = witness.wave.expect(values);
        assert_eq!(
            [&wave.turns[..], &wave.period, &wave.amplitude],
            [turns, period, amplitude],
            "{values}"
        );
        assert_eq!(
            (witness.to, witness.gain_per_cycle),
            (q(to), q(gain)),
            "{values}"
        );
        assert!(witness.positions.is_empty() && witness.from == q("0"));
    }
}

/// Joints of b, c, Δ and a bound on the speed, `-` for none; T = 1 s.
fn joints(of: &str, wall: &str) -> JointScene {
    let mut text = String::new();
    for joint in of.split(" ; ") {
        text += "[[joint]]\n";
        let keys = [
            ("viscous", "N s/m"),
            ("coulomb", "N"),
            ("resolution", "m"),
            ("max_speed", "m/s"),
        ];
        for ((key, unit), value) in keys.iter().zip(joint.split(' ')) {
            let value = value.replace("..", " … ");
            text += &match (*key, value.as_str()) {
                (_, "-") => String::new(),
                ("resolution", _) => format!("encoder = {{ resolution = \"{value} m\" }}\n"),
                _ => format!("{key} = \"{value} {unit}\"\n"),
            };
        }
    }
    text += &format!("[sampling]\nperiod = \"1 s\"\n[wall]\n{wall}\n");
    match AnyScene::from_toml("joints", &text) {
        Ok(AnyScene::Joints(scene)) => *scene,
        Ok(AnyScene::One(_)) => panic!("a scene of one joint:\n{text}"),
        Err(error) => panic!("{error}\n{text}"),
    }
}

fn numbers(list: &[BigRational]) -> String {
    list.iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join(" ")
}

/// There and back from where, by how much, and the gain.
fn found(of: &str, wall: &str) -> Option<[String; 3]> {
    let report = passivity_scene::joints::check(&joints(of, wall));
    assert_eq!(
        report.verdict == Verdict::NotPassive,
        report.witness.is_some(),
        "{of}"
    );
    let witness = report.witness?;
    let back: Vec<BigRational> = witness.moves[0].iter().map(|x| -x).collect();
    assert_eq!(witness.moves[1..], [back]);
    Some([
        numbers(&witness.from),
        numbers(&witness.moves[0]),
        witness.gain_per_cycle.to_string(),
    ])
}

#[test]
fn th_ndof_motions_of_two_joints() {
    let [along, against] = [["1", "2"], ["1", "-2"]]
        .map(|[a, b]| format!("stiffness = \"1/2 N/m\"\ndirection = [\"{a}\", \"{b}\"]"));
    let one_sided = |wall: &str| format!("{wall}\nunilateral = true");
    let matrix = |off: &str| {
        format!("stiffness_matrix = [[\"1/2 N/m\", \"{off} N/m\"], [\"{off} N/m\", \"1 N/m\"]]")
    };
    let mirrored = "stiffness = \"1/2 N/m\"\ndirection = [\"-1\", \"2\"]";
    for (of, wall, expected) in [
        // Long ways of the joint with too little viscous friction.
        (
            "0 0.8 1 - ; 4 3 1/2 -",
            along.clone(),
            ["0 0", "4 0", "8/5"],
        ),
        (
            "0.1 0.8 1 - ; 0.2 3 1/2 -",
            along.clone(),
            ["3/4 0", "17/4 0", "17/80"],
        ),
        (
            "0.1 0.8 1 - ; 0.2 3 1/2 -",
            against.clone(),
            ["3/4 0", "17/4 0", "17/80"],
        ),
        (
            "0.1 0.8 1 - ; 0.2 3 1/2 -",
            one_sided(&along),
            ["3/4 0", "17/4 0", "17/80"],
        ),
        // Into the wall: the other joint stands where its part of the way is not below zero.
        (
            "0.1 0.8 1 - ; 0.2 3 1/2 -",
            one_sided(&against),
            ["3/4 -1", "17/4 0", "17/80"],
        ),
        (
            "0.1 0.8 - - ; 0.2 3 1/2 -",
            along.clone(),
            ["0 0", "32/3 0", "256/15"],
        ),
        (
            "0.1 0.8 - - ; 0.2 3 - -",
            along.clone(),
            ["0 0", "32/3 0", "256/15"],
        ),
        (
            "0.1 0.8 1 - ; 0.2 3 1/2 -",
            matrix("1/4"),
            ["3/4 0", "17/4 0", "17/80"],
        ),
        (
            "0.1..0.2 0.7..0.8 1..1.1 - ; 0.2 3 1/2 -",
            "stiffness = \"0.5 … 0.6 N/m\"\ndirection = [\"1\", \"2\"]".to_owned(),
            ["7/8 0", "97/8 0", "97/160"],
        ),
        // Over one edge each, the other joint by next to nothing where that is what it pays for.
        (
            "1 0 1 - ; 4 3 1/2 -",
            along.clone(),
            ["7/8 31/32", "1/8 1/32", "15/512"],
        ),
        (
            "1 0.1 1 - ; 4 0.1 1/2 -",
            along.clone(),
            ["7/8 7/8", "1/8 1/8", "3/20"],
        ),
        (
            "1 0.1 1 - ; 4 0.1 1/2 -",
            one_sided(mirrored),
            ["-9/8 1", "1/8 -1/8", "3/20"],
        ),
        (
            "1 0.1 1 - ; 4 3 1/2 -",
            matrix("1/4"),
            ["15/16 255/256", "1/16 1/256", "1387/163840"],
        ),
        (
            "1 0.3 1 - ; 4 0.2 1/2 -",
            matrix("-1/4"),
            ["255/256 1", "1/256 -1/256", "59/81920"],
        ),
        (
            "1 0.1..0.2 1..1.1 - ; 4 0.1 1/2 -",
            "stiffness = \"0.5 … 0.6 N/m\"\ndirection = [\"1\", \"2\"]".to_owned(),
            ["7/8 7/8", "1/8 1/8", "1/8"],
        ),
        // Slower than the bounds.
        (
            "0.1 0.1 1 1/2 ; 0.2 0.1 1/2 1/2",
            along.clone(),
            ["3/4 3/4", "1/4 1/4", "13/32"],
        ),
        (
            "0.1 0.1 1 1/20 ; 0.2 0.1 1/2 1/50",
            along.clone(),
            ["31/32 31/32", "1/32 1/32", "541/10240"],
        ),
        (
            "0.1 0.1 1 10 ; 0.2 0.1 1/2 20",
            along.clone(),
            ["0 0", "1 1", "7/5"],
        ),
    ] {
        assert_eq!(
            found(of, &wall),
            Some(expected.map(str::to_owned)),
            "{of} {wall}"
        );
    }
    assert_eq!(found("0.1 0.8 1 1/2 ; 0.2 3 1/2 1/2", &along), None);
}

/// A single joint is a device: d(m + 1 − 2βd − 2σ) with d = m + a ticks, and d(d − 2bd − 2c) without an encoder.
#[test]
fn th_ndof_motions_of_one_joint() {
    let wall = "stiffness = \"1 N/m\"\ndirection = [\"1\"]";
    for (of, expected) in [
        ("1/5 3/5 1 -", ["1/2", "3/2", "3/10"]),
        ("2/5 7/10 1 -", ["7/8", "25/8", "5/16"]),
        ("2/5 7/10 1 5", ["7/8", "25/8", "5/16"]),
        ("3/5 2/5 1 -", ["15/16", "1/16", "1/128"]),
        ("3/5 2/5 1 1/20", ["31/32", "1/32", "13/2560"]),
        ("2/5 7/10 - -", ["0", "14", "98/5"]),
        ("2/5 7/10 - 20", ["0", "27/2", "351/20"]),
    ] {
        let expected = expected.map(str::to_owned);
        let [b, c] = [0, 1].map(|i| q(of.split(' ').nth(i).unwrap()));
        let [from, d] = [&expected[0], &expected[1]].map(|x| q(x));
        let held = match of.split(' ').nth(2) {
            Some("-") => d.clone(),
            _ => (&from + &d).floor() - from.floor(),
        };
        let gain = &d * (held - &b * q("2") * &d - &c * q("2"));
        assert_eq!(gain, q(&expected[2]), "{of}");
        assert_eq!(found(of, wall), Some(expected), "{of}");
    }
    assert_eq!(found("2/5 7/10 1 3", wall), None);
    let toleranced = "stiffness = \"1 … 1.1 N/m\"\ndirection = [\"2\"]";
    let expected = ["0", "1", "9/5"].map(str::to_owned);
    assert_eq!(found("2/5 3/5..7/10 1 -", toleranced), Some(expected));
}
