//! Motions that draw energy over tolerances: what they gain is of the hardest device among them (TH-ACTIVE,
//! TH-LTI).

use std::time::{Duration, Instant};

use passivity_core::{Exact, Scalar as _, pi};
use passivity_scene::Scene;
use passivity_scene::check::{Verdict, check};

use crate::wall::{q, report};

/// Of a plain wall: from 1 − a to 1 + m and back, d = m + a ticks, gains d(m + 1 − 2βd − 2σ), β and σ at
/// their largest, and the hand is slower than the slowest bound.
#[test]
fn a_witness_is_of_all_tolerances() {
    for (values, from, to, gain, joules) in [
        // β = 2/5, σ = 0, bound ¼: d = 1/5.
        (
            "viscous 1/5, coulomb 0, max_speed 1 … 2, period 0.5 … 1, resolution 1 … 2",
            "4/5",
            "1",
            "21/125",
            "21/125",
        ),
        // β = 2/5, σ = 3/5: m = 2, and 17/8·(3 − 17/10 − 6/5).
        ("viscous 2/5, coulomb 3/5", "7/8", "3", "17/80", "17/80"),
        // At most β = 40/99 and σ = 15/22; a joule is KΔ² with K = 1.1 and Δ = 0.8.
        (
            "viscous 2/5, coulomb 3/5, period 0.9 … 1, resolution 0.8 … 1, stiffness 1.1",
            "79/80",
            "3",
            "161/7920",
            "161/11250",
        ),
        // A force of 3/2 is needed at 1, times K at its stiffest.
        (
            "viscous 1/5, coulomb 0, max_force 1.5",
            "0",
            "1",
            "3/5",
            "3/5",
        ),
        (
            "viscous 1/5, coulomb 0, max_force 1.8 … 2, stiffness 1 … 1.2",
            "0",
            "1",
            "3/5",
            "3/5",
        ),
        // Without an encoder there and back over d = 2σ/(½ − β), or 1; here at V = 1 of at most 3/4.
        ("viscous 1/4, smooth", "0", "1", "1/2", "1/2"),
        (
            "viscous 1/4, coulomb 1/8, max_speed 1, smooth",
            "0",
            "3/4",
            "3/32",
            "3/32",
        ),
    ] {
        let report = report(values);
        assert_eq!(report.verdict, Verdict::NotPassive, "{values}");
        let witness = report.witness.unwrap();
        let found = [
            witness.from,
            witness.to,
            witness.gain_per_cycle,
            witness.gain_per_cycle_joules.unwrap(),
        ];
        assert_eq!(found, [from, to, gain, joules].map(q), "{values}");
    }
    for values in [
        "viscous 1/5, coulomb 0, max_force 1.499",
        "viscous 1/5, coulomb 0, max_force 1.79 … 2, stiffness 1 … 1.2",
    ] {
        assert_eq!(report(values).verdict, Verdict::NotGuaranteed, "{values}");
    }
}

/// Across one edge, a sample late: up, wait, down, wait, forces of 3/2 and ½ on a way of a gain
/// a(1 − 2e) − 2σa − 2βa², e what D/A steps take at most, and a about (½ − σ)/(2β).
#[test]
fn a_witness_of_a_late_wall_is_of_all_tolerances() {
    for (values, expected) in [
        ("coulomb 0.49", Verdict::NotPassive),
        ("coulomb 0.49, max_force 1.5", Verdict::NotPassive),
        ("coulomb 0.49, max_force 1.499", Verdict::NotGuaranteed),
        (
            "coulomb 0.4, max_force 1.8 … 2, stiffness 1 … 1.2",
            Verdict::NotPassive,
        ),
        (
            "coulomb 0.4, max_force 1.79 … 2, stiffness 1 … 1.2",
            Verdict::NotGuaranteed,
        ),
        // Steps of 0.1 to 0.2 take e = 0.1 at most, so that σ < 0.3.
        ("coulomb 0.28, force_step 0.1 … 0.2", Verdict::NotPassive),
        ("coulomb 0.32, force_step 0.1 … 0.2", Verdict::NotGuaranteed),
        // Where K may be anything, so may the step be in units of it.
        (
            "coulomb 0.28, force_step 0.2, stiffness 1 … 1.1",
            Verdict::NotPassive,
        ),
        (
            "coulomb 0.32, force_step 0.2, stiffness 1 … 1.1",
            Verdict::NotGuaranteed,
        ),
    ] {
        let values = format!("viscous 4, delay 1, {values}");
        assert_eq!(report(&values).verdict, expected, "{values}");
    }
}

/// π/1000 a tick: what is asked for to forty digits, on either side of it.
#[test]
fn a_witness_is_as_exact_with_pi() {
    let wall = |friction: &str, more: &str| {
        let text = format!(
            "[device]\n{friction}\n[sampling]\nperiod = \"1 s\"\n{more}\n\
             [encoder]\ncounts_per_revolution = 2000\n"
        );
        check(&Scene::from_toml("test", &text).unwrap_or_else(|e| panic!("{e}\n{text}")))
    };
    let stiffness = "stiffness = \"1 N m/rad\"";
    // 3/2·K·Δ, the force that is needed.
    let least = "4.712388980384689857693965074919254326295";
    let late = |force: &str| {
        let more = format!("delay = 1\n[wall]\n{stiffness}\nmax_force = \"{force}e-3 N m\"");
        let coulomb = "coulomb = \"1.4e-3 N m\"";
        wall(&format!("viscous = \"4 N m s/rad\"\n{coulomb}"), &more).verdict
    };
    assert_eq!(late(&format!("{least}7")), Verdict::NotGuaranteed);
    assert_eq!(late(&format!("{least}8")), Verdict::NotPassive);
    // Just below a fifth of a tick a sample: a fifth is too much.
    let fifth = "0.6283185307179586476925286766559005768393";
    let more = format!("[wall]\n{stiffness}\n[operator]\nmax_speed = \"{fifth}e-3 rad/s\"");
    let witness = wall("viscous = \"1/5 N m s/rad\"", &more).witness;
    assert_eq!(witness.unwrap().from, q("5/6"));
    // What is gained is at least what is said: d(m + 1 − 2βd − 2σ) with σ = c/Δ.
    let report = wall(
        "viscous = \"1/5 N m s/rad\"\ncoulomb = \"1e-3 N m\"",
        &format!("[wall]\n{stiffness}"),
    );
    let witness = report.witness.unwrap();
    let d = &witness.to - &witness.from;
    let gain = |pi: &str| {
        let spent = q("2/5") * &d + q("2") / q(pi);
        &d * (witness.to.clone() - spent)
    };
    let [least, most] = [
        "3.141592653589793238462643383279",
        "3.141592653589793238462643383280",
    ];
    assert!(witness.gain_per_cycle <= gain(least));
    assert!(gain(most) - &witness.gain_per_cycle < q("1e-18"));
    let tick = pi::pi().over(Exact::integer(1000));
    let joules = Exact::of(&witness.gain_per_cycle) * tick.clone() * tick;
    assert!(Exact::of(&witness.gain_per_cycle_joules.unwrap()) <= joules);
    // 10⁻⁴⁰ below the border there is a motion as well, and with steps of the D/A converter none is made up.
    let half = "1.570796326794896619231321691639751442098";
    let plain = |coulomb: &str| {
        let friction = format!("viscous = \"4 N m s/rad\"\ncoulomb = \"{coulomb}e-3 N m\"");
        wall(&friction, &format!("[wall]\n{stiffness}")).verdict
    };
    assert_eq!(plain(&format!("{half}5")), Verdict::NotPassive);
    assert_eq!(plain(&format!("{half}6")), Verdict::Passive);
    let stepped = wall(
        "viscous = \"4 N m s/rad\"\ncoulomb = \"1.4e-3 N m\"",
        &format!("delay = 1\n[wall]\n{stiffness}\nforce_step = \"0.6e-3 N m\""),
    );
    assert_eq!(stepped.verdict, Verdict::NotGuaranteed);
}

/// Where no witness is found, no more bits of π are tried than may help: each of these took 40 s or minutes, and takes
/// less than a second.
#[test]
fn a_search_for_a_witness_that_finds_none_ends_soon() {
    const LIMIT: Duration = Duration::from_secs(20);
    let filtered = "[device]\nviscous = \"0.3 N s/m\"\n[sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"500 N/m\"\n\
                    damping = \"1 N s/m ± 10%\"\ndamping_cutoff = \"50 Hz\"\n";
    let angles = "[device]\nviscous = \"0.3031 uN m s/deg ± 20%\"\ncoulomb = \"3.501 mN m\"\n[sampling]\n\
                  period = \"0.1421 ms\"\n[encoder]\ncounts_per_revolution = 4096\n[wall]\n\
                  stiffness = \"6.608 mN m/deg\"\ndamping = \"1.923 uN m s/deg ± 10%\"\ndamping_cutoff = \"58.6 Hz\"\n\
                  max_force = \"100 mN m\"\n";
    let late = "[device]\nviscous = \"1.907 uN m s/rad\"\n[sampling]\nperiod = \"0.1144 ms\"\nlatency = \"1345 us\"\n[wall]\n\
                stiffness = \"9.914 N m/rad\"\ndamping = \"1.686 uN m s/deg\"\n[operator]\nmax_speed = \"10.24 rpm\"\n";
    for text in [filtered, angles, late] {
        let scene = Scene::from_toml("s", text).unwrap();
        let start = Instant::now();
        assert_eq!(check(&scene).verdict, Verdict::NotGuaranteed, "{text}");
        assert!(start.elapsed() < LIMIT, "{text}: {:?}", start.elapsed());
    }
}
