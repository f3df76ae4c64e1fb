//! TH-LTI: boxes of loops whose costs are computed, against figures that are known.
//!
//! Behind a delay of one sample λ is 5/4 for a damping of B = ½ and 41/16 for B = 2, as in the tests of
//! `frequency`. An encoder then asks for σ ≥ ½ + B.

use passivity_core::verdict::Speeds;
use passivity_core::{Fraction, Friction, Interval, Loop, Scalar, Truth, Wide};

type Ends = Interval<Wide>;

fn w(n: i32, d: i32) -> Wide {
    Wide::integer(n).over(Wide::integer(d))
}

fn between(lo: Wide, hi: Wide) -> Ends {
    Interval::hull(lo, hi)
}

fn exactly(x: Wide) -> Ends {
    Interval::point(x)
}

/// A wall with K = T = Δ = 1, a delay of one sample, virtual damping and friction.
fn late(damping: Ends, viscous: Ends, coulomb: Ends) -> Loop<Ends> {
    let plain: Loop<Wide> = Loop::plain(Friction::new(w(1, 1), w(1, 1)));
    Loop {
        delay: 1,
        damping: Some(damping),
        viscous: Some(viscous),
        coulomb: Some(coulomb),
        ..plain.map(|_, x| exactly(x.clone()))
    }
}

const HOLDS: (Option<Truth>, bool) = (Some(Truth::Holds), true);
const FAILS: (Option<Truth>, bool) = (Some(Truth::Fails), false);
const DEPENDS: (Option<Truth>, bool) = (Some(Truth::Depends), false);

/// What is said of a box, and whether the quick way says that it holds.
fn said(of: &Loop<Ends>, speeds: &Speeds<Ends>) -> (Option<Truth>, bool) {
    (of.truth(speeds), of.surely_holds(speeds))
}

fn tiny() -> Wide {
    w(1, 1 << 30)
}

#[test]
fn th_lti_decision_of_one_loop_is_exact_at_the_border() {
    let half = || exactly(w(1, 2));
    let of = |b: Wide, c: Wide| said(&late(half(), exactly(b), exactly(c)), &Speeds::All);
    assert_eq!(of(w(5, 4), w(1, 1)), HOLDS);
    assert_eq!(of(w(5, 4) - tiny(), w(1, 1)), FAILS);
    assert_eq!(of(w(5, 4), w(1, 1) - tiny()), FAILS);
    assert_eq!(of(w(2, 1), w(2, 1)), HOLDS);
}

#[test]
fn th_lti_decision_over_tolerances_of_friction() {
    let half = || exactly(w(1, 2));
    let of = |b: Ends, c: Ends| said(&late(half(), b, c), &Speeds::All);
    let (enough, more) = (w(5, 4), w(2, 1));
    assert_eq!(
        of(between(enough.clone(), more.clone()), exactly(w(1, 1))),
        HOLDS
    );
    assert_eq!(
        of(
            between(enough.clone() - tiny(), more.clone()),
            exactly(w(1, 1))
        ),
        DEPENDS
    );
    assert_eq!(
        of(between(w(1, 1), enough.clone()), exactly(w(1, 1))),
        DEPENDS
    );
    assert_eq!(
        of(between(w(1, 1), enough - tiny()), exactly(w(1, 1))),
        FAILS
    );
    assert_eq!(of(exactly(more.clone()), between(w(1, 1), w(2, 1))), HOLDS);
    assert_eq!(
        of(exactly(more.clone()), between(w(1, 2), w(1, 1))),
        DEPENDS
    );
    assert_eq!(of(exactly(more), between(w(1, 2), w(1, 1) - tiny())), FAILS);
}

/// A speed bound V lets Coulomb friction help: b + (c − 1)/V ≥ 5/4.
#[test]
fn th_lti_decision_up_to_a_speed() {
    let of = |b: Wide, c: Wide, speeds: Ends| {
        said(
            &late(exactly(w(1, 2)), exactly(b), exactly(c)),
            &Speeds::UpTo(speeds),
        )
    };
    let v = |lo: Wide, hi: Wide| between(lo, hi);
    // 1 + ½/2 = 5/4.
    assert_eq!(of(w(1, 1), w(3, 2), v(w(1, 1), w(2, 1))), HOLDS);
    assert_eq!(of(w(1, 1), w(3, 2), v(w(2, 1), w(3, 1))), DEPENDS);
    assert_eq!(of(w(1, 1), w(3, 2), v(w(2, 1) + tiny(), w(3, 1))), FAILS);
    assert_eq!(of(w(1, 1), w(1, 2), v(w(1, 4), w(1, 2))), FAILS);
    let squared = |v: Wide| Speeds::UpToSquared(exactly(v.clone() * v));
    let at = |speeds: &Speeds<Ends>| {
        late(exactly(w(1, 2)), exactly(w(1, 1)), exactly(w(3, 2))).truth(speeds)
    };
    assert_eq!(at(&squared(w(15, 8))), Some(Truth::Holds));
    assert_eq!(at(&squared(w(17, 8))), Some(Truth::Fails));
}

/// λ is convex in B, so that it is largest at an end.
#[test]
fn th_lti_decision_over_a_tolerance_of_the_damping() {
    let of = |b: Wide, c: Wide| {
        said(
            &late(between(w(1, 2), w(2, 1)), exactly(b), exactly(c)),
            &Speeds::All,
        )
    };
    assert_eq!(of(w(41, 16), w(5, 2)), HOLDS);
    assert_eq!(of(w(41, 16) - tiny(), w(5, 2)), DEPENDS);
    assert_eq!(of(w(41, 16), w(5, 2) - tiny()), DEPENDS);
    assert_eq!(of(w(5, 4), w(5, 2)), DEPENDS);
    assert_eq!(of(w(1, 1), w(5, 2)), FAILS);
}

/// With a damping of B N·s/m, b has to be KT·λ(B/(KT)), which is convex in KT: 5/4 at KT = 1 and B = ½.
/// At KT = ½ it is ½·λ(1), and λ(1) ≤ ⅔·5/4 + ⅓·41/16 < 2 because λ is convex. At KT = 2 it is more than
/// at 1, because it grows from ½ to 1 and is convex.
#[test]
fn th_lti_decision_over_tolerances_of_stiffness_and_period() {
    let scaled = |stiffness: Ends, period: Ends, b: Wide| {
        let of = Loop {
            stiffness,
            period,
            resolution: None,
            ..late(exactly(w(1, 2)), exactly(b), exactly(w(4, 1)))
        };
        said(&of, &Speeds::All)
    };
    let one = || exactly(w(1, 1));
    assert_eq!(scaled(between(w(1, 2), w(1, 1)), one(), w(5, 4)), HOLDS);
    assert_eq!(scaled(one(), between(w(1, 2), w(1, 1)), w(5, 4)), HOLDS);
    assert_eq!(scaled(between(w(1, 1), w(2, 1)), one(), w(5, 4)), DEPENDS);
    assert_eq!(scaled(one(), between(w(1, 1), w(2, 1)), w(5, 4)), DEPENDS);
    assert_eq!(scaled(between(w(1, 1), w(2, 1)), one(), w(1, 1)), FAILS);
}

/// Costs over a box hold those of its loops, and those of a loop are the figures.
#[test]
fn th_lti_decision_costs_are_enclosed() {
    let friction = || exactly(w(1, 1));
    let cost = |damping: Ends| {
        let of = late(damping, friction(), friction())
            .with_costs(64)
            .unwrap();
        let viscous = of.viscous_cost.unwrap();
        (viscous.lo().clone(), viscous.hi().clone())
    };
    assert_eq!(cost(exactly(w(1, 2))), (w(5, 4), w(5, 4)));
    assert_eq!(cost(exactly(w(2, 1))), (w(41, 16), w(41, 16)));
    let (lo, hi) = cost(between(w(1, 2), w(2, 1)));
    assert!(lo <= w(5, 4) && w(41, 16) <= hi);
    // Where nothing is computed nothing is added.
    let plain: Loop<Fraction<_>> = Loop::plain(Friction::new(w(1, 1), w(1, 1)));
    let plain = plain.map(|_, x| exactly(x.clone()));
    assert_eq!(plain.with_costs(64).unwrap().viscous_cost, None);
    assert_eq!(said(&plain, &Speeds::All), HOLDS);
}
