//! Loops with any linear controller, filter, delay, latency and lag: what they cost, decided exactly,
//! and the motions that draw energy below it, computed again from the encoder and the difference
//! equation alone (TH-LTI, TH-LATENCY, TH-LAG).

use num_traits::{Signed as _, Zero as _};
use passivity_core::{BigRational, Interval, Region};
use passivity_scene::Scene;
use passivity_scene::check::{Report, Verdict, check};
use passivity_scene::explain::explain;

use crate::dimensionless::{approx, q, report};

/// Verdicts at β, and 10⁻³⁰ below.
fn beside(beta: &str, sections: &str) -> [Report; 2] {
    let least = q("1e-30");
    [q(beta), q(beta) - least].map(|beta| report(&beta, "10", sections))
}

#[test]
fn a_delay_and_damping_partly_cancel() {
    let [at, below] = beside("5/4", "[sampling]\ndelay = 1\n[wall]\ndamping = \"1/2\"\n");
    assert_eq!(at.cost.viscous, Interval::point(q("5/4")));
    assert_eq!(
        (at.verdict, below.verdict),
        (Verdict::Passive, Verdict::NotPassive)
    );
    // THEORY's motion of period 6: D = 1, ½, −½, −1, −½, ½ times an amplitude.
    assert_eq!(below.witness.unwrap().positions.len(), 6);
    let [at, below] = beside("41/16", "[sampling]\ndelay = 1\n[wall]\ndamping = \"2\"\n");
    assert_eq!(at.cost.viscous, Interval::point(q("41/16")));
    assert_eq!(
        (at.verdict, below.verdict),
        (Verdict::Passive, Verdict::NotPassive)
    );
    assert!(at.because.contains(&"TH-LTI"));
}

/// What the theorems say beside a computed cost is true there.
#[test]
fn effects_together_cost_at_most_what_the_theorems_say() {
    let sections =
        "[sampling]\ndelay = 1\n[wall]\ndamping = \"2\"\ndamping_time_constant = \"3\"\n";
    let text = format!("[dimensionless]\nbeta = \"3\"\nsigma = \"3\"\n{sections}");
    let explanation = explain(&Scene::from_toml("scene", &text).unwrap());
    let says = |id: &str| {
        let mut theorems = explanation.theorems.iter();
        theorems.find(|theorem| theorem.id == id).expect(id).says
    };
    assert!(says("TH-DELAY").contains("by at most 1"));
    assert!(says("TH-DAMP").contains("by at most B each"));
    // Of 3/2 for the delay and 2 for the damping.
    let cost = &explanation.report.cost;
    assert!(*cost.viscous.hi() < q("7/2") && *cost.viscous.lo() > q("3/2"));
    assert!(*cost.coulomb.hi() < q("5/2"));
}

/// From ξ = −2 to −17/10 a wall on one side generates nothing, and one on both sides less than that: ½d² + (ρ₀ − ½)d.
/// It is the bound that they share.
#[test]
fn a_one_sided_wall_may_generate_more_and_has_the_same_bound() {
    let d = q("3/10");
    let half = q("1/2");
    let two_sided = &half * &d * &d - &half * &d;
    assert_eq!(two_sided, q("-0.105"));
    let bound = &half * &d * &d + &half * &d;
    assert!(two_sided < q("0") && q("0") <= bound);
    let text = "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n[wall]\nunilateral = true\nmax_force = \"9\"\n";
    let explanation = explain(&Scene::from_toml("scene", text).unwrap());
    for id in ["TH-UNI", "TH-LAW"] {
        let theorem = explanation.theorems.iter().find(|theorem| theorem.id == id);
        let says = theorem.expect(id).says;
        assert!(says.starts_with("the bound on what "), "{id}: {says}");
    }
}

#[test]
fn a_one_sided_wall_pays_for_delay_and_damping_one_by_one() {
    let sections = "[sampling]\ndelay = 1\n[wall]\nunilateral = true\ndamping = \"1/2\"\n";
    let [at, below] = beside("2", sections);
    assert_eq!(at.cost.viscous, Interval::point(q("2")));
    assert_eq!(
        (at.verdict, below.verdict),
        (Verdict::Passive, Verdict::NotGuaranteed)
    );
    // Far enough below, a motion inside the wall draws energy.
    assert_eq!(
        report(&q("6/5"), "10", sections).verdict,
        Verdict::NotPassive
    );
}

#[test]
fn filtered_damping_costs_what_the_filter_leaves() {
    // a = τ/(T + τ) = ½ for τ = T: ½ + B/3 and ½ + B/2.
    let sections = "[wall]\ndamping = \"1\"\ndamping_time_constant = \"1\"\n";
    let at = report(&q("5/6"), "1", sections);
    assert_eq!(at.cost.viscous, Interval::point(q("5/6")));
    assert_eq!(at.cost.coulomb, Interval::point(q("1")));
    assert_eq!(at.verdict, Verdict::Passive);
    // B = 10, a = 0.95: 0.756 instead of 10.5.
    let slow = "[wall]\ndamping = \"10\"\ndamping_time_constant = \"19\"\n";
    let cost = report(&q("1"), "3", slow).cost;
    assert_eq!(cost.viscous, Interval::point(q("1/2") + q("10/39")));
    assert_eq!(cost.coulomb, Interval::point(q("1")));
    // A cutoff f is the time constant 1/(2πf), which has a π in it.
    let cutoff =
        "[wall]\ndamping = \"1\"\ndamping_cutoff = \"0.1591549430918953357688837633725144\"\n";
    let cost = report(&q("1"), "2", cutoff).cost;
    assert!((approx(cost.viscous.lo()) - 5.0 / 6.0).abs() < 1e-15);
    assert!(cost.viscous.hi() - cost.viscous.lo() < q("1e-50"));
}

#[test]
fn latency_and_lag_cost_their_kappa() {
    // κ = ½(0.8 + √0.85) for 0.3 samples, and 1.51354… for a lag of one sample.
    let late = report(&q("1"), "10", "[sampling]\nlatency = \"0.3\"\n")
        .cost
        .viscous;
    let root = |x: &BigRational| (x.clone() + x.clone() - q("0.8")).pow(2);
    assert!(root(late.lo()) <= q("0.85") && root(late.hi()) >= q("0.85"));
    assert!(late.hi() - late.lo() < q("1e-50"));
    let lag = report(&q("2"), "10", "[amplifier]\ntime_constant = \"1\"\n")
        .cost
        .viscous;
    assert!((approx(lag.lo()) - 1.51354).abs() < 5e-6);
    // A whole sample of latency is a sample of delay.
    let whole = report(&q("3/2"), "1/2", "[sampling]\nlatency = \"1\"\n");
    assert_eq!(whole.cost.viscous, Interval::point(q("3/2")));
    assert_eq!(whole.verdict, Verdict::Passive);
    let short = report(&q("3/2"), "1/2", "[sampling]\nlatency = \"1.01\"\n");
    assert_eq!(short.verdict, Verdict::NotPassive);
}

#[test]
fn latency_draws_what_its_witness_says() {
    let late = report(&q("0.7"), "10", "[sampling]\nlatency = \"0.3\"\n");
    assert_eq!(late.verdict, Verdict::NotPassive);
    let witness = late.witness.unwrap();
    // The command of the sample before acts for the first 0.3 of an interval.
    let positions = &witness.positions;
    let n = positions.len();
    let mut gain = BigRational::zero();
    for h in 0..n {
        let held = |i: usize| -(positions[(i + n) % n].floor() + q("1/2"));
        let d = &positions[(h + 1) % n] - &positions[h];
        let mean = held(h + n - 1) * q("0.3") + held(h) * q("0.7");
        gain += mean * &d - q("0.7") * &d * &d - q("10") * d.abs();
    }
    assert_eq!(gain, witness.gain_per_cycle);
    assert!(gain.is_positive());
}

#[test]
fn between_mean_delay_and_kappa_nothing_is_promised() {
    // ½ + m = 0.8 < κ = 0.86098: constant speeds draw nothing here.
    let late = report(&q("0.83"), "10", "[sampling]\nlatency = \"0.3\"\n");
    assert_eq!(late.verdict, Verdict::NotGuaranteed);
}

#[test]
fn the_best_pattern_across_an_edge_is_the_witness_of_coulomb_friction() {
    // c = (½, −1, 1.2, 0.4): s* = 1.15 < ½‖c‖₁ = 1.55, λ = 3.15 by THEORY 7.
    let sections = "[controller]\nnumerator = [\"0.5\", \"-1\", \"1.2\", \"0.4\"]\n";
    let verdict = |sigma: &str| report(&q("4"), sigma, sections).verdict;
    assert_eq!(verdict("1.55"), Verdict::Passive);
    assert_eq!(verdict("1.549"), Verdict::NotGuaranteed);
    assert_eq!(verdict("1.15"), Verdict::NotGuaranteed);
    assert_eq!(verdict("1.149"), Verdict::NotPassive);
}

#[test]
fn controllers_that_no_loop_can_have_are_refused() {
    let refused = |lists: &str| {
        let text = format!("[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n[controller]\n{lists}\n");
        Scene::from_toml("scene", &text).unwrap_err().to_string()
    };
    for (lists, says) in [
        (
            "numerator = [\"1\"]\ndenominator = [\"1\", \"-1\"]",
            "not stable",
        ),
        (
            "numerator = [\"1\"]\ndenominator = [\"1\", \"-2\"]",
            "not stable",
        ),
        (
            "numerator = [\"1\"]\ndenominator = [\"0\", \"1\"]",
            "not proper",
        ),
        ("numerator = [\"-1\"]", "pushes away from the wall"),
        ("numerator = []", "has 0 entries"),
        ("numerator = [\"x\"]", "no exact number"),
        ("numerator = [true]", "a boolean"),
        ("denominator = [\"1\"]", "[controller] has no `numerator`"),
        ("numerator = \"1\"", "is text"),
        (
            "numerator = [\"1\"]\ndenominator = [\"1\", \"0\", \"-0.9999999999\"]",
            "forgets too slowly",
        ),
    ] {
        let error = refused(lists);
        assert!(error.contains(says), "{lists}: {error}");
    }
    let both = "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n[wall]\ndamping = \"1\"\n[controller]\nnumerator = [\"1\"]\n";
    let error = Scene::from_toml("scene", both).unwrap_err().to_string();
    assert!(error.contains("cannot both be given"), "{error}");
}

/// b = KT/2 + B behind a law that is not linear: the hardest corner asks for 9.71087. Late by five samples the loop asks
/// for a thousandth more than there is at every corner, and so in between.
#[test]
fn tolerances_beside_a_filter_are_decided() {
    let one_sided = "coulomb 0.00265788, period 0.0004046 … 0.0004946, resolution 7.711e-6, stiffness 141, \
                     damping 9.485 … 9.676, damping_time_constant 0.03524, unilateral true";
    let late = "viscous 0.737017, coulomb 0, smooth, delay 5, period 0.0003265 … 0.0003331, stiffness 486.2, \
                damping 0.5445, damping_time_constant 4.309e-5 … 4.396e-5, max_speed 0.008486";
    for (values, verdict) in [
        (format!("viscous 9.71184, {one_sided}"), Verdict::Passive),
        (format!("viscous 9.7108, {one_sided}"), Verdict::Depends),
        (late.to_owned(), Verdict::NotGuaranteed),
    ] {
        assert_eq!(crate::wall::report(&values).verdict, verdict, "{values}");
    }
}

/// Five samples late, damping of 5KT costs the most in the middle of this tolerance of its filter,
/// 6.11429 at τ = 1.3335 ms, and at both ends less: what it bends between the ends counts.
#[test]
fn a_filter_may_cost_the_most_inside_its_tolerance() {
    let of = |viscous: &str, filter: &str| {
        let text = format!(
            "device.viscous = \"{viscous} N s/m\"\n\
             device.coulomb = \"1 N\"\n\
             sampling.period = \"1 ms\"\n\
             sampling.delay = 5\n\
             wall.stiffness = \"1000 N/m\"\n\
             wall.damping = \"5 N s/m\"\n\
             wall.damping_time_constant = \"{filter}\"\n"
        );
        check(&Scene::from_toml("scene", &text).unwrap())
    };
    let whole = "1.3335 ms ± 30%";
    assert_eq!(of("6.1138", whole).verdict, Verdict::Depends);
    assert_eq!(of("6.1138", "1.3335 ms").verdict, Verdict::NotPassive);
    for end in ["0.93345 ms", "1.73355 ms"] {
        assert_eq!(of("6.1138", end).verdict, Verdict::Passive, "{end}");
    }
    assert!(*of("6.11428", whole).cost.viscous.hi() >= q("6.11429"));
}

/// Figures of damping beside a tolerance of the stiffness are those of the walls in it, each checked alone: the worst is that of
/// the softest or the stiffest, and so is the best where the cost is a sum. Late by a sample, the best may be in between, and is
/// enclosed.
#[test]
fn figures_of_damping_are_those_of_one_wall_each() {
    let of = |viscous: &str, stiffness: &str, more: &str| {
        let text = format!(
            "device = {{ viscous = \"{viscous} N s/m\", coulomb = \"1 N\" }}\n\
             sampling.period = \"1 s\"\n\
             encoder.resolution = \"0.1 m\"\n\
             wall.stiffness = \"{stiffness} N/m\"\n\
             wall.damping = \"1 N s/m\"\n\
             {more}"
        );
        check(&Scene::from_toml("scene", &text).unwrap())
    };
    let filter = "wall.damping_time_constant = \"0.5 s\"\n";
    let late = "sampling.delay = 1\n";
    let others = [
        format!("{filter}wall.unilateral = true\n{late}"),
        format!("{filter}sampling.latency = \"1.3 s\"\n"),
        format!("{filter}{late}"),
    ];
    let [one_sided, latent, both] = others.each_ref().map(String::as_str);
    // Whether the cost is a sum, and the wall locally stable throughout.
    for (viscous, percent, more, is_sum, is_local) in [
        ("0.93", 2, filter, true, true),
        ("0.9", 30, filter, true, false),
        ("0.55", 80, filter, true, true),
        ("1.2", 80, one_sided, true, true),
        ("1.1", 80, latent, true, true),
        ("0.5", 80, both, false, true),
        ("0.5", 60, late, false, true),
        ("1.4", 80, late, false, false),
    ] {
        let box_of_walls = format!("1 ± {percent}%");
        let report = of(viscous, &box_of_walls, more);
        let context = format!("{viscous} ± {percent} % {more}");
        // Where the cost is a sum, it is of no other form in between.
        let parts = if is_sum { 2 } else { 4 };
        let wall = |i: i32| {
            of(
                viscous,
                &format!("{}e-3", 1000 + percent * 10 * i / parts),
                more,
            )
        };
        let walls: Vec<_> = (-parts..=parts).map(wall).collect();
        let stable = Some(Region::LocallyStable);
        assert_eq!(report.region, stable.filter(|_| is_local), "{context}");
        assert_eq!(
            walls.iter().all(|wall| wall.region == stable),
            is_local,
            "{context}"
        );

        let rounding = q("1e-40");
        let is_range_of =
            |whole: &Interval<_>, walls: Vec<Interval<BigRational>>, worst_is_least| {
                let least = walls.iter().map(Interval::lo).min().unwrap();
                let most = walls.iter().map(Interval::hi).max().unwrap();
                assert!(whole.lo() <= least && whole.hi() >= most, "{context}");
                if is_sum || worst_is_least {
                    assert!(*whole.lo() >= least - &rounding, "{context}");
                }
                if is_sum || !worst_is_least {
                    assert!(*whole.hi() <= most + &rounding, "{context}");
                }
            };
        let of_walls = |of: fn(&Report) -> &Interval<_>| walls.iter().map(of).cloned().collect();
        is_range_of(
            &report.spare.viscous,
            of_walls(|of| &of.spare.viscous),
            true,
        );
        is_range_of(&report.cost.viscous, of_walls(|of| &of.cost.viscous), false);
        is_range_of(&report.cost.coulomb, of_walls(|of| &of.cost.coulomb), false);
        if let Some(speed) = &report.critical_speed_si {
            is_range_of(
                speed,
                of_walls(|of| of.critical_speed_si.as_ref().unwrap()),
                true,
            );
        }

        // A wall that is passive at every speed has no slowest.
        let speeds = walls
            .iter()
            .filter_map(|wall| wall.critical_speed_si.clone());
        let slowest = speeds.map(|v| v.lo().clone()).min().unwrap();
        let set = report.advice.max_speed.unwrap();
        // Five digits are printed, rounded down.
        let fastest = &slowest * q("0.9999");
        assert!(
            set.value <= slowest && set.value >= fastest,
            "{context}: {}",
            set.typed
        );
        let bound = format!("operator.max_speed = \"{}\"\n{more}", set.typed);
        let bounded = of(viscous, &box_of_walls, &bound);
        assert_eq!(bounded.verdict, Verdict::Passive, "{context}");
        assert!(
            *bounded.margin_at_speed_bound.unwrap().lo() > q("0"),
            "{context}"
        );
    }
}

/// ‖c‖₁ of a long response is enclosed, that of one which gives nothing too, and is no less than nothing.
#[test]
fn a_controller_that_gives_nothing_costs_no_less_than_nothing() {
    let nothing = "[controller]\nnumerator = [\"0\"]\ndenominator = [\"1\", \"0.1\", \"0.1\"]\n";
    let cost = report(&q("1"), "1", nothing).cost.coulomb;
    assert!(cost.lo().is_zero() && *cost.hi() < q("1e-50"), "{cost:?}");
}
