//! Limits of the parameters, with figures by hand (CHECK-LIMITS): the criterion is
//! (b − KT/2)V + c − KΔ/2 ≥ 0, with T, Δ and K of 1 in SI units unless a scene says otherwise.

use num_traits::Signed as _;
use passivity_core::{BigRational, Interval, Parameter};
use passivity_scene::check::{Limit, Report, Side, check};

use crate::wall::{q, scene};

fn report(values: &str) -> Report {
    check(&scene(values))
}

/// A limit in a line: the key, the side, the border, and what is printed.
fn said(limit: &Limit) -> String {
    let key = limit.parameter.row().key.rsplit('.').next().unwrap();
    let side = match limit.side {
        Side::AtLeast => "≥",
        Side::AtMost => "≤",
    };
    let (lo, hi) = (limit.border.lo(), limit.border.hi());
    let border = match lo == hi {
        true => lo.to_string(),
        false => format!("{lo} … {hi}"),
    };
    let printed = limit.printed.as_deref().unwrap_or("not enough alone");
    assert_eq!(limit.suffices, limit.printed.is_some(), "{key}");
    assert_eq!(limit.printed, limit.typed, "{key}: in SI units");
    format!("{key} {side} {border}: {printed}")
}

#[test]
fn limits_of_a_plain_wall_are_those_of_the_formulas() {
    for (values, expected) in [
        // b ≥ KT/2, c ≥ KΔ/2, K ≤ min(2b/T, 2c/Δ), T ≤ 2b/K, Δ ≤ 2c/K.
        (
            "viscous 3/4, coulomb 4/5",
            vec![
                "viscous ≥ 1/2: 0.5",
                "coulomb ≥ 1/2: 0.5",
                "stiffness ≤ 3/2: 1.5",
                "period ≤ 3/2: 1.5",
                "resolution ≤ 8/5: 1.6",
            ],
        ),
        // The same where the others are at their hardest, and at their easiest.
        (
            "viscous 1, coulomb 1, stiffness 0.9 … 1.2, period 0.5 … 1.5, resolution 0.8 … 1.2",
            vec![
                "viscous ≥ 9/40 … 9/10: 0.9",
                "coulomb ≥ 9/25 … 18/25: 0.72",
                "stiffness ≤ 4/3 … 5/2: 1.3333",
                "period ≤ 5/3 … 20/9: 1.6666",
                "resolution ≤ 5/3 … 20/9: 1.6666",
            ],
        ),
        // Up to V = 1: b ≥ ½ − 3/10, c ≥ ½ + 1/6, K ≤ 2(1/3 + 4/5)/2, T ≤ 2(1/3 + 3/10) and Δ alike.
        (
            "viscous 1/3, coulomb 0.8, max_speed 1",
            vec![
                "viscous ≥ 1/5: 0.2",
                "coulomb ≥ 2/3: 0.66667",
                "stiffness ≤ 17/15: 1.1333",
                "period ≤ 19/15: 1.2666",
                "resolution ≤ 19/15: 1.2666",
            ],
        ),
        // b ≥ KT/2 − (c − KΔ/2)/V is least hard at V = 1, where none is needed; and so on.
        (
            "viscous 1/3, coulomb 1.5, stiffness 0.9 … 1.2, period 0.5 … 0.75, resolution 0.8 … 1.2, \
             max_speed 1 … 2",
            vec![
                "viscous ≥ 0 … 3/50: 0.06",
                "coulomb ≥ 9/25 … 143/150: 0.95334",
                "stiffness ≤ 130/81 … 110/39: 1.6049",
                "period ≤ 217/180 … 442/135: 1.2055",
                "resolution ≤ 19/9 … 10/3: 2.1111",
            ],
        ),
        // So much Coulomb friction that no viscous friction is needed up to the bound.
        (
            "viscous 1/10, coulomb 4, max_speed 1",
            vec![
                "viscous ≥ 0: 0",
                "coulomb ≥ 9/10: 0.9",
                "stiffness ≤ 41/10: 4.1",
                "period ≤ 36/5: 7.2",
                "resolution ≤ 36/5: 7.2",
            ],
        ),
        // D/A steps that cost all of c: no wall and no encoder is fine enough, and b is not to blame.
        (
            "viscous 1, coulomb 1/2, force_step 1",
            vec![
                "viscous ≥ 1/2: not enough alone",
                "coulomb ≥ 1: 1",
                "period ≤ 2: not enough alone",
            ],
        ),
    ] {
        let found: Vec<String> = report(values).limits.iter().map(said).collect();
        assert_eq!(found, expected, "{values}");
    }
}

/// With damping B behind an encoder c ≥ KΔ/2 + BΔ/T: a shorter period costs Coulomb friction.
#[test]
fn limits_hold_at_the_shortest_and_at_the_longest_period() {
    let found = |values: &str, key: &str| {
        let limits = report(values).limits.into_iter();
        let mut limits = limits.filter(|limit| limit.parameter.row().key.ends_with(key));
        limits.next().map(|limit| said(&limit))
    };
    let steady = "viscous 10 ± 1, coulomb 0.75 ± 0.15, period 1 ± 0.5, stiffness 0.5, damping 0.1";
    // b ≥ KT/2 + B is hardest at T = 3/2, c ≥ 1/4 + 1/(10T) at T = 1/2; T ≤ 2(9 − B)/K.
    for (key, expected) in [
        ("viscous", "viscous ≥ 9/40 … 19/40: 0.475"),
        // 1/4 + 1/15 and 1/4 + 1/5.
        ("coulomb", "coulomb ≥ 19/60 … 9/20: 0.45"),
        ("stiffness", "stiffness ≤ 4/5 … 5/3: 0.8"),
        ("period", "period ≤ 178/5: 35.6"),
        ("resolution", "resolution ≤ 4/3 … 54/19: 1.3333"),
    ] {
        assert_eq!(found(steady, key).as_deref(), Some(expected));
    }
    // At T = ½ and V = 2: 1/20 + 2 + (1 + 1/40 − ½)·2; at T = 1 and V = 1: 1/20 + 1 + (1 + 1/20 − ½).
    let fast = "viscous 1/2, coulomb 3, period 0.5 … 1, stiffness 1/10, damping 1, max_speed 1 … 2";
    assert_eq!(
        found(fast, "coulomb").as_deref(),
        Some("coulomb ≥ 8/5 … 31/10: 3.1")
    );
    // b asks for T ≤ 3/5 and c for T ≥ 5: no period is enough.
    let neither = "viscous 0.4, coulomb 0.52, period 0.7, damping 0.1";
    assert_eq!(found(neither, "period"), None);
}

fn limit(values: &str, parameter: Parameter) -> Limit {
    let report = report(values);
    let found = report.limits.into_iter().find(|l| l.parameter == parameter);
    found.unwrap_or_else(|| panic!("no limit of {parameter:?}: {values}"))
}

/// Where no formula says the border it is bracketed: one end passes, the other does not, and they are
/// 2⁻³² of the way apart that was searched, or as close as what the loop costs is enclosed.
fn assert_bracketed(
    values: &str,
    parameter: Parameter,
    way: &str,
    passes: impl Fn(&BigRational) -> bool,
) {
    let limit = limit(values, parameter);
    let [hard, beyond] = match limit.side {
        Side::AtLeast => [limit.border.hi(), limit.border.lo()],
        Side::AtMost => [limit.border.lo(), limit.border.hi()],
    };
    assert!(
        passes(hard) && (hard == beyond || !passes(beyond)),
        "{values}: {}",
        said(&limit)
    );
    let width = limit.border.hi() - limit.border.lo();
    let steps = BigRational::from_integer((1_u64 << 32).into());
    let apart = width * steps;
    let is_close = &apart * q("1e9") < q(way);
    assert!(apart == q(way) || is_close, "{values}: {parameter:?}");
    let printed = q(limit.printed.as_ref().unwrap());
    assert!(passes(&printed), "{values}: {printed}");
    // A thousandth beyond it does not.
    let factor = match limit.side {
        Side::AtLeast => q("0.999"),
        Side::AtMost => q("1.001"),
    };
    assert!(!passes(&(printed * factor)), "{values}");
}

/// Behind a delay of one sample damping B costs u/2 + B + u²/(8B) of viscous friction, u = KT ≤ 4B: at
/// x = cos θ it is u/2 + ux − B(2x² − 1), largest at x = u/(4B). And it costs KΔ/2 + BΔ/T of Coulomb
/// friction.
fn is_enough(viscous: &str, u: &BigRational, b: &BigRational) -> bool {
    let at_one = u * q("3/2") - b;
    let inside = u * q("1/2") + b + u * u / (b * q("8"));
    let cost = if *u <= b * q("4") { inside } else { at_one };
    cost <= q(viscous)
}

#[test]
fn limits_of_stiffness_and_period_with_a_delay_and_damping() {
    let half = q("1/2");
    // From 1 to ½, from 1 to 2, from 4 to 8.
    for (viscous, way) in [("6/5", "1/2"), ("5/4", "1"), ("6", "4")] {
        let values = format!("viscous {viscous}, coulomb 4, delay 1, damping 1/2");
        assert_bracketed(&values, Parameter::Stiffness, way, |k| {
            is_enough(viscous, k, &half) && k * &half + &half <= q("4")
        });
        assert_bracketed(&values, Parameter::Period, way, |t| {
            is_enough(viscous, t, &half)
        });
    }
}

#[test]
fn limits_of_friction_and_damping_with_a_delay() {
    // From the value on to where it fails, or back to where it passes: by factors of two.
    for (viscous, damping, way) in [
        ("3", "0.5 ± 0.1", "2.4"),
        ("5/4", "4", "1/2"),
        ("5/4", "1/2", "1/2"),
    ] {
        let values = format!("viscous {viscous}, coulomb 8, delay 1, damping {damping}");
        assert_bracketed(&values, Parameter::Damping, way, |b| {
            is_enough(viscous, &q("1"), b)
        });
    }
    // Of a point the costs are exact, and so is what friction has to be.
    let values = "viscous 5/4 ± 1/8, coulomb 2, delay 1, damping 1/2, stiffness 3/4";
    let limits: Vec<String> = report(values).limits.iter().map(said).collect();
    for exact in [
        "viscous ≥ 65/64: 1.0157",
        "coulomb ≥ 7/8: 0.875",
        "resolution ≤ 16/7: 2.2857",
    ] {
        assert!(limits.contains(&exact.to_owned()), "{limits:?}");
    }
    assert_bracketed(values, Parameter::Stiffness, "3/4", |k| {
        is_enough("9/8", k, &q("1/2"))
    });
}

/// A filter of time constant τ leaves B·T/(T + 2τ) of viscous and BΔ/(T + τ) of Coulomb friction to pay.
#[test]
fn limits_of_a_filter_on_the_damping() {
    let passes = |viscous: &str, tau: &BigRational, b: &BigRational| {
        q("1/2") + b / (q("1") + tau * q("2")) <= q(viscous)
            && q("1/2") + b / (q("1") + tau) <= q("1")
    };
    for tau in ["4", "1/4"] {
        let values = format!("viscous 5/6, coulomb 1, damping 1, damping_time_constant {tau}");
        assert_bracketed(&values, Parameter::DampingTimeConstant, "1/2", |tau| {
            passes("5/6", tau, &q("1"))
        });
        let way = if tau == "4" { "2" } else { "1/2" };
        let tau = q(tau);
        assert_bracketed(&values, Parameter::Damping, way, |b| passes("5/6", &tau, b));
    }
}

/// A latency of s periods costs KT·κ, 2κ = (½ + s) + √((½ + s)² + s(1 − s)) for s ≤ 1.
#[test]
fn limits_of_a_latency() {
    let kappa_is_at_most = |s: &BigRational, kappa: &BigRational| {
        let mean = q("1/2") + s;
        let rest = kappa * q("2") - &mean;
        !rest.is_negative() && &rest * &rest >= &mean * &mean + s * (q("1") - s)
    };
    let three_tenths = q("3/10");
    let late = "viscous 1, coulomb 2, latency 0.3";
    assert_bracketed(late, Parameter::Viscous, "1/2", |b| {
        kappa_is_at_most(&three_tenths, b)
    });
    assert_bracketed(late, Parameter::Coulomb, "1/4", |c| *c >= q("1/2"));
    assert_bracketed(late, Parameter::Stiffness, "1", |k| {
        kappa_is_at_most(&three_tenths, &(q("1") / k))
    });
    assert_bracketed(late, Parameter::Resolution, "4", |delta| *delta <= q("4"));
    assert_bracketed(late, Parameter::Latency, "3/10", |s| {
        kappa_is_at_most(s, &q("1"))
    });
    assert_bracketed(late, Parameter::Period, "1", |t| {
        kappa_is_at_most(&(&three_tenths / t), &(q("1") / t))
    });
    // A tolerance that begins at zero; κ = 0.96234… at 0.4, which the cells of a box tell to 10⁻⁵.
    let vague = limit(
        "viscous 0 … 1, coulomb 2, latency 0.3 ± 0.1",
        Parameter::Viscous,
    );
    assert_eq!(vague.printed.as_deref(), Some("0.96235"));
    assert!(vague.border.hi() - vague.border.lo() < q("1e-6"));
    let vague = "viscous 1, coulomb 0 … 1, latency 0.3";
    assert_bracketed(vague, Parameter::Coulomb, "1/4", |c| *c >= q("1/2"));
    // No friction at all.
    for none in [
        "coulomb 2, latency 0.3",
        "viscous 0, coulomb 2, latency 0.3",
    ] {
        assert_eq!(
            limit(none, Parameter::Viscous).printed.as_deref(),
            Some("0.86098")
        );
    }
}

/// A controller in units of the stiffness costs the same multiple of KT and of KΔ whatever they are:
/// 1.5 − 0.5z⁻¹ costs λ = ½ + ½ and ½‖c‖₁ = 1.
#[test]
fn limits_beside_a_controller_are_exact() {
    let found = |more: &str| -> Vec<String> {
        let values = format!("viscous 5/4, coulomb 3/2, numerator [\"1.5\",\"-0.5\"]{more}");
        report(&values).limits.iter().map(said).collect()
    };
    assert_eq!(
        found(""),
        [
            "viscous ≥ 1: 1",
            "coulomb ≥ 1: 1",
            "stiffness ≤ 5/4: 1.25",
            "period ≤ 5/4: 1.25",
            "resolution ≤ 3/2: 1.5",
        ]
    );
    assert_eq!(
        found(", stiffness 1 ± 0.2"),
        [
            "viscous ≥ 4/5 … 6/5: 1.2",
            "coulomb ≥ 4/5 … 6/5: 1.2",
            "stiffness ≤ 5/4: 1.25",
            "period ≤ 25/24 … 25/16: 1.0416",
            "resolution ≤ 5/4 … 15/8: 1.25",
        ]
    );
}

/// The margin at V = 2 is c − ½ − 1/(10T) + (b − 1/10 − T/2)·2, and the last period that passes is
/// looked for between half of what it allows without 1/(10T), or the first period that passes near
/// rest, and the whole of it.
#[test]
fn limits_of_a_period_that_pulls_both_ways() {
    let passes = |viscous: &str, coulomb: &str, t: &BigRational| {
        let spare = q(coulomb) - q("1/2") - q("1/10") / t;
        let fast = q(viscous) - q("1/10") - t / q("2");
        !spare.is_negative() && !(spare + fast * q("2")).is_negative()
    };
    let damped = "period 0.7, damping 0.1, max_speed 1 … 2";
    // 6/5 is what is allowed without 1/(10T): 0.7 + 2·(0.35 − 0.1).
    assert_bracketed(
        &format!("viscous 0.4 ± 0.05, coulomb 1.2, {damped}"),
        Parameter::Period,
        "3/5",
        |t| passes("0.35", "1.2", t),
    );
    // Near rest T ≥ 1/2 passes, and half of 0.2 + 0.6 is less.
    assert_bracketed(
        &format!("viscous 0.4, coulomb 0.7, {damped}"),
        Parameter::Period,
        "3/10",
        |t| passes("0.4", "0.7", t),
    );
}

fn border(values: &str, parameter: Parameter) -> Interval<BigRational> {
    let mut limits = report(values).limits.into_iter();
    limits
        .find(|limit| limit.parameter == parameter)
        .unwrap()
        .border
}

/// Periods between the ends of the tolerance count at the easiest end of a border. At every speed
/// b ≥ KT/2 + B, c ≥ K/2 + B/T and K ≤ min(2(b − B)/T, 2(c − B/T)).
#[test]
fn borders_over_a_period_that_pulls_both_ways() {
    // With b = c = 1 both limits of K are 9/5 at T = 1; at 1/2 one is 8/5, at 3/2 the other 6/5.
    let values = "viscous 1, coulomb 1, period 1 ± 0.5, damping 0.1";
    let border = self::border(values, Parameter::Stiffness);
    assert_eq!(*border.lo(), q("6/5"));
    let bits = BigRational::from_integer((1_i64 << 31).into()).recip();
    assert!(
        *border.hi() >= q("9/5") && *border.hi() <= q("9/5") + &bits,
        "{border:?}"
    );

    // Up to V = 1 c ≥ 1/2 + B/T and c ≥ 1/2 + B/T + B + T/2 − b. With B = 1/2 and b = 1 that is 3/2 at
    // T = 1/2, 13/12 at 3/2, and least where both are 1, at T = 1.
    let values = "viscous 1, coulomb 2, period 1 ± 0.5, damping 0.5, max_speed 1";
    let border = self::border(values, Parameter::Coulomb);
    assert_eq!(*border.hi(), q("3/2"));
    assert!(
        *border.lo() <= q("1") && *border.lo() >= q("1") - bits,
        "{border:?}"
    );
}

/// Five digits do not tell 1.24999 from the 1.25 that is needed; as many are printed as do.
#[test]
fn what_just_misses_its_limit_does_not_read_like_it() {
    let late = "coulomb 9, delay 1, damping 1/2";
    for (values, says) in [
        (
            format!("viscous 1.24999, {late}"),
            "at least 1.25 N s/m (now 1.24999 N s/m)",
        ),
        (
            format!("viscous 1.24999999999999999999999999, {late}"),
            "at least 1.25 N s/m (now 1.24999999999999999999999999 N s/m)",
        ),
        // It is what it has to be.
        (
            format!("viscous 1.25, {late}"),
            "at least 1.25 N s/m (now 1.25 N s/m)",
        ),
        (
            "viscous 1/2, coulomb 9, stiffness 1.0000004".to_owned(),
            "at most 1 N/m (now 1.0000004 N/m)",
        ),
        // Five digits are enough.
        (
            format!("viscous 1.2499, {late}"),
            "at least 1.25 N s/m (now 1.2499 N s/m)",
        ),
    ] {
        let text = report(&values).to_text();
        assert!(text.contains(says), "{says}: {text}");
    }
}
