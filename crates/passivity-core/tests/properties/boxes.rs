//! Boxes of loops: what is said of a box is said of every loop in it, and "it depends" only where
//! two of them differ.

mod drawn;

use passivity_core::verdict::{self, End, Speeds};
use passivity_core::{
    BigRational, Criterion, Friction, Interval, Loop, Parameter, Region, Truth, stiffness,
};
use proptest::prelude::*;

use self::drawn::{any_box, boxes_pulled_both_ways, interval};
use crate::common::{half, q, sampled, squared, zero};
use crate::control_loop::criterion_written_out;
use crate::verdict::holds_by_hand;

type Box = Loop<Interval<BigRational>>;
type Member = Loop<BigRational>;

/// Every corner of a box.
fn corners(of: &Box) -> Vec<Member> {
    let free: Vec<Parameter> = of
        .given()
        .filter(|(_, interval)| !interval.is_point())
        .map(|(parameter, _)| parameter)
        .collect();
    (0..1u32 << free.len())
        .map(|mask| {
            of.map(|parameter, interval| {
                let bit = free.iter().position(|other| *other == parameter);
                let high = bit.is_some_and(|bit| mask >> bit & 1 == 1);
                if high { interval.hi() } else { interval.lo() }.clone()
            })
        })
        .collect()
}

/// The number a share of the way from the lower end of an interval to the upper one.
fn within(interval: &Interval<BigRational>, share: &BigRational) -> BigRational {
    interval.lo() + (interval.hi() - interval.lo()) * share
}

/// Loops of the box at shares of each interval, with many periods.
fn members(of: &Box, shares: &[i64]) -> Vec<Member> {
    let mut share = shares.iter().cycle();
    let one = of.map(|_, interval| within(interval, &q(*share.next().unwrap(), 8)));
    let period = |i| {
        one.clone()
            .with(Parameter::Period, within(&of.period, &q(i, 32)))
    };
    (0..=32).map(period).collect()
}

/// Least friction and most of all else, or the other way round; the period as given.
fn extreme(of: &Box, easiest: bool, period: &BigRational) -> Member {
    let end = of.map(|parameter, interval| {
        let friction = matches!(parameter, Parameter::Viscous | Parameter::Coulomb);
        if friction == easiest {
            interval.hi()
        } else {
            interval.lo()
        }
        .clone()
    });
    end.with(Parameter::Period, period.clone())
}

/// Periods among which there is one that meets the criterion, if any in the box does: the ends,
/// where Coulomb friction is just enough near rest, and where the margin times the period peaks.
fn telling_periods(of: &Box, bound: Option<&BigRational>) -> Vec<BigRational> {
    let best = extreme(of, true, &q(1, 1));
    let absent_is_zero = |x: &Option<BigRational>| x.clone().unwrap_or_else(zero);
    let (k, delta) = (&best.stiffness, absent_is_zero(&best.resolution));
    let damping = absent_is_zero(&best.damping);
    let spare = absent_is_zero(&best.coulomb)
        - k * &delta * half()
        - absent_is_zero(&best.force_step) * half();
    let mut all = vec![of.period.lo().clone(), of.period.hi().clone()];
    if spare > zero() {
        all.push(&damping * &delta / &spare);
    }
    if let Some(v) = bound {
        let late = half() + q(i64::from(best.delay), 1);
        let rise = spare + (absent_is_zero(&best.viscous) - damping) * v;
        all.push(rise / (q(2, 1) * k * late * v));
    }
    all.retain(|t| t >= of.period.lo() && t <= of.period.hi());
    all
}

/// Whether the criterion holds for all loops of a box, and for one of them, up to the bounds.
fn by_hand(of: &Box, bound: Option<&Interval<BigRational>>) -> Truth {
    let holds = |member: &Member, bound| holds_by_hand(&criterion_written_out(member), bound);
    // The margin is monotone in all but the period, and concave in that: corners are the worst.
    let all = corners(of)
        .iter()
        .all(|corner| holds(corner, bound.map(Interval::hi)));
    let slowest = bound.map(Interval::lo);
    let mut telling = telling_periods(of, slowest).into_iter();
    let some = telling.any(|period| holds(&extreme(of, true, &period), slowest));
    match (all, some) {
        (true, true) => Truth::Holds,
        (false, true) => Truth::Depends,
        (false, false) => Truth::Fails,
        (true, false) => panic!("all loops pass and none does"),
    }
}

fn speeds(bound: Option<&Interval<BigRational>>) -> Speeds<Interval<BigRational>> {
    bound.map_or(Speeds::All, |bound| Speeds::UpTo(bound.clone()))
}

fn shares() -> impl Strategy<Value = Vec<i64>> {
    prop::collection::vec(0i64..=8, 8)
}

sampled! {
    /// The verdict on a box is that on its loops: all, none, or some.
    fn th_region_box_verdict_is_that_of_its_loops(
        of in any_box(), bound in prop::option::of(interval())
    ) {
        let bound = bound.as_ref();
        prop_assert_eq!(of.decide(&speeds(bound)), Some(by_hand(&of, bound)));
    }

    /// No loop inside contradicts it, wherever it is and up to whatever bound of the interval.
    fn th_region_box_verdict_agrees_with_its_members(
        of in any_box(), bound in prop::option::of(interval()), shares in shares()
    ) {
        let truth = of.decide(&speeds(bound.as_ref())).unwrap();
        let region = of.region();
        let [worst, best] = of.criteria();
        let bounds = bound.map_or(vec![None], |b| vec![Some(b.lo().clone()), Some(within(&b, &q(1, 3))), Some(b.hi().clone())]);
        for member in members(&of, &shares) {
            let criterion = criterion_written_out(&member);
            prop_assert!(worst.viscous <= criterion.viscous && criterion.viscous <= best.viscous);
            prop_assert!(worst.coulomb <= criterion.coulomb && criterion.coulomb <= best.coulomb);
            prop_assert!(region.is_none_or(|region| Region::of(&criterion) == Some(region)));
            for speed in &bounds {
                let holds = holds_by_hand(&criterion, speed.as_ref());
                prop_assert!(truth == Truth::Depends || holds == (truth == Truth::Holds));
            }
        }
    }

    /// A bound given by its square: never wrong, and exact where the period pulls one way.
    fn th_start_box_verdict_up_to_a_square(of in any_box(), bound in interval(), shares in shares()) {
        let truth = of.decide(&Speeds::UpToSquared(bound.map(squared))).unwrap();
        let expected = by_hand(&of, Some(&bound));
        if !of.period_pulls_both_ways() || of.period.is_point() || expected != Truth::Fails {
            prop_assert_eq!(truth, expected);
        }
        for member in members(&of, &shares) {
            let holds = holds_by_hand(&criterion_written_out(&member), Some(bound.hi()));
            prop_assert!(truth != Truth::Holds || holds);
            let holds = holds_by_hand(&criterion_written_out(&member), Some(bound.lo()));
            prop_assert!(truth != Truth::Fails || !holds);
        }
    }

    /// The region of a box is that of all its loops, and there is none only where two differ.
    fn th_region_box_has_the_region_of_all_its_loops(of in any_box(), shares in shares()) {
        let region = |member: &Member| Region::of(&criterion_written_out(member)).unwrap();
        let corners: Vec<Region> = corners(&of).iter().map(region).collect();
        let first = corners[0];
        let all_agree = corners.iter().all(|other| *other == first);
        prop_assert_eq!(of.region(), all_agree.then_some(first));
        if let Some(expected) = of.region() {
            for member in members(&of, &shares) {
                prop_assert_eq!(region(&member), expected);
            }
        }
    }

    /// Each coefficient of the two criteria is the extreme one over the corners.
    fn th_region_box_criteria_are_reached(of in any_box()) {
        let corners: Vec<_> = corners(&of).iter().map(criterion_written_out).collect();
        let viscous = || corners.iter().map(|c| c.viscous.clone());
        let coulomb = || corners.iter().map(|c| c.coulomb.clone());
        let [worst, best] = of.criteria();
        prop_assert_eq!((Some(worst.viscous), Some(worst.coulomb)), (viscous().min(), coulomb().min()));
        prop_assert_eq!((Some(best.viscous), Some(best.coulomb)), (viscous().max(), coulomb().max()));
    }

    fn th_region_box_of_one_loop_is_the_loop(of in any_box(), bound in interval()) {
        let member = of.map(|_, interval| interval.lo().clone());
        let of = member.map(|_, x| Interval::point(x.clone()));
        prop_assert_eq!(&of.at(End::Hardest), &member);
        prop_assert_eq!(&of.at(End::Easiest), &member);
        let expected = criterion_written_out(&member);
        prop_assert_eq!(of.criteria(), [expected.clone(), expected.clone()]);
        prop_assert_eq!(of.region(), Region::of(&expected));
        let speed = Interval::point(bound.lo().clone());
        for speeds in [Speeds::All, Speeds::UpTo(speed)] {
            let decision = verdict::of_loop(&member, &speeds.at(End::Hardest)).unwrap();
            prop_assert_eq!(Some(decision.region), Region::of(&expected));
            let truth = if decision.holds { Truth::Holds } else { Truth::Fails };
            prop_assert_eq!(of.decide(&speeds), Some(truth));
        }
    }

    /// Each parameter at the end where it hurts, by name, and both periods.
    fn th_region_box_at_its_ends(of in any_box(), bound in interval()) {
        let (shortest, longest) = (of.period.lo(), of.period.hi());
        prop_assert_eq!(of.at(End::Hardest), extreme(&of, false, longest));
        prop_assert_eq!(of.at(End::Easiest), extreme(&of, true, shortest));
        let hardest = [extreme(&of, false, longest), extreme(&of, false, shortest)];
        prop_assert_eq!(of.hardest(), hardest);
        let speeds = Speeds::UpTo(bound.clone());
        prop_assert_eq!(speeds.at(End::Hardest), Speeds::UpTo(bound.hi().clone()));
        prop_assert_eq!(speeds.at(End::Easiest), Speeds::UpTo(bound.lo().clone()));
        let squares = Speeds::UpToSquared(bound.clone());
        prop_assert_eq!(squares.at(End::Hardest), Speeds::UpToSquared(bound.hi().clone()));
        prop_assert_eq!(squares.at(End::Easiest), Speeds::UpToSquared(bound.lo().clone()));
        prop_assert_eq!(of.period_pulls_both_ways(), of.damping.is_some() && of.resolution.is_some());
    }

    /// A limit that holds for the hardest loops holds for the box, and a little more does not.
    fn th_stiff_limits_of_the_hardest_loops(of in boxes_pulled_both_ways()) {
        let limits = of.hardest().map(|hardest| stiffness::limit_at_all_speeds(&hardest));
        let least = limits.iter().min().unwrap().clone();
        prop_assume!(least > zero());
        let with = |stiffness: BigRational| of.clone().with(Parameter::Stiffness, Interval::point(stiffness));
        prop_assert_eq!(with(least.clone()).decide(&Speeds::All), Some(Truth::Holds));
        let beyond = with(least * q(1001, 1000)).decide(&Speeds::All);
        prop_assert!(beyond.is_some() && beyond != Some(Truth::Holds));
    }
}

fn tolerance(middle: (i64, i64), width: (i64, i64)) -> Interval<BigRational> {
    let (middle, width) = (q(middle.0, middle.1), q(width.0, width.1));
    Interval::new(&middle - &width, middle + width).unwrap()
}

fn point(n: i64, d: i64) -> Interval<BigRational> {
    Interval::point(q(n, d))
}

/// A speed bound of 1 ± ½ around the critical speed of 1: neither end may be taken for the other.
/// The criterion has no inertia in it; a loop at an end of the box has the greatest, whichever end.
#[test]
fn th_region_a_parameter_without_a_part_is_at_its_upper_end() {
    let of = Interval::hull(q(1, 1), q(2, 1));
    for end in [End::Hardest, End::Easiest] {
        assert_eq!(end.of(Parameter::Inertia, &of), of.hi());
    }
}

#[test]
fn th_region_tolerance_of_the_speed_bound_depends() {
    let plain = Loop::plain(Friction::new(q(2, 5), q(3, 5))).map(|_, x| Interval::point(x.clone()));
    let up_to = |lo: (i64, i64), hi: (i64, i64)| {
        let bound = Interval::new(q(lo.0, lo.1), q(hi.0, hi.1)).unwrap();
        let squares = plain.decide(&Speeds::UpToSquared(bound.map(squared)));
        let truth = plain.decide(&Speeds::UpTo(bound));
        assert_eq!(truth, squares);
        truth
    };
    assert_eq!(up_to((1, 2), (3, 2)), Some(Truth::Depends));
    assert_eq!(up_to((1, 2), (1, 1)), Some(Truth::Holds));
    assert_eq!(up_to((3, 2), (5, 2)), Some(Truth::Fails));
}

/// 10 N s/m, 0.75 ± 0.15 N, 1 ± ½ s, 1 m, ½ N/m and 0.1 N s/m: BΔ/T is largest at the shortest T.
#[test]
fn th_stiff_limits_where_the_period_pulls_both_ways() {
    let of = Loop {
        viscous: Some(point(10, 1)),
        coulomb: Some(tolerance((3, 4), (3, 20))),
        resolution: Some(point(1, 1)),
        damping: Some(point(1, 10)),
        ..Loop::new(point(1, 2), tolerance((1, 1), (1, 2)))
    };
    assert_eq!(of.decide(&Speeds::All), Some(Truth::Holds));
    let [longest, shortest] = of.hardest();
    assert_eq!(stiffness::limit_at_all_speeds(&longest), q(16, 15));
    assert_eq!(stiffness::limit_at_all_speeds(&shortest), q(4, 5));
    assert_eq!(stiffness::coarsest_resolution(&longest), Some(q(36, 19)));
    assert_eq!(stiffness::coarsest_resolution(&shortest), Some(q(4, 3)));
    assert_eq!(stiffness::shortest_period(&shortest), Some(q(2, 7)));
    let decided = |parameter, value| {
        let other = of.clone().with(parameter, Interval::point(value));
        other.decide(&Speeds::All).unwrap()
    };
    for (parameter, limit) in [
        (Parameter::Stiffness, q(4, 5)),
        (Parameter::Resolution, q(4, 3)),
    ] {
        assert_eq!(decided(parameter, limit.clone()), Truth::Holds);
        assert_eq!(decided(parameter, limit * q(1001, 1000)), Truth::Depends);
    }
}

/// T pulls both ways, and every T passes, or none does.
#[test]
fn th_region_no_dependence_where_every_period_agrees() {
    let of = |viscous, coulomb| Loop {
        viscous: Some(viscous),
        coulomb: Some(coulomb),
        resolution: Some(point(1, 1)),
        damping: Some(point(1, 10)),
        ..Loop::new(point(1, 1), tolerance((1, 1), (1, 2)))
    };
    let up_to_one = Speeds::UpTo(point(1, 1));
    assert_eq!(
        of(point(7, 10), point(3, 4)).decide(&up_to_one),
        Some(Truth::Holds)
    );
    assert_eq!(
        of(point(2, 5), point(3, 5)).decide(&Speeds::All),
        Some(Truth::Fails)
    );
    // Viscous friction asks for T ≤ 1 and Coulomb friction for T ≥ 1: one period is left.
    assert_eq!(
        of(point(3, 5), point(3, 5)).decide(&Speeds::All),
        Some(Truth::Depends)
    );
    // Up to V = 1 the margin times T is −½(T − 1)²: zero at T = 1, negative anywhere else.
    let peak = |coulomb| Loop {
        damping: Some(point(1, 2)),
        ..of(point(7, 10), coulomb)
    };
    assert_eq!(peak(point(13, 10)).decide(&up_to_one), Some(Truth::Depends));
    assert_eq!(peak(point(129, 100)).decide(&up_to_one), Some(Truth::Fails));
}

/// All loops are unstable, though the easiest ends of both coefficients together would be stable:
/// they are those of two periods.
#[test]
fn th_region_of_a_box_is_not_that_of_a_loop_outside() {
    let of = Loop {
        viscous: Some(point(3, 2)),
        coulomb: Some(point(1, 1)),
        resolution: Some(point(1, 1)),
        damping: Some(point(1, 1)),
        ..Loop::new(point(1, 1), Interval::new(q(1, 1), q(2, 1)).unwrap())
    };
    let [_, best] = of.criteria();
    assert_eq!((best.viscous, best.coulomb), (zero(), zero()));
    assert_eq!(of.region(), Some(Region::Unstable));
    assert_eq!(of.decide(&Speeds::All), Some(Truth::Fails));
}

/// A box of dimensionless loops, [β] × [σ].
fn friction_box(beta: (i64, i64), sigma: (i64, i64)) -> Box {
    let interval = |(lo, hi)| Interval::new(q(lo, 10), q(hi, 10)).unwrap();
    Loop {
        viscous: Some(interval(beta)),
        coulomb: Some(interval(sigma)),
        resolution: Some(point(1, 1)),
        ..Loop::new(point(1, 1), point(1, 1))
    }
}

#[test]
fn th_region_boxes_across_the_lines() {
    let region = |beta, sigma| friction_box(beta, sigma).region();
    assert_eq!(region((5, 9), (5, 9)), Some(Region::GloballyStable));
    assert_eq!(region((1, 4), (6, 9)), Some(Region::LocallyStable));
    assert_eq!(region((6, 9), (1, 4)), Some(Region::LimitCycles));
    assert_eq!(region((1, 5), (1, 4)), Some(Region::Unstable));
    // Unstable at both ends, (1/10, ½) and (½, 4/10), but globally stable at (½, ½) between them.
    assert_eq!(region((1, 5), (4, 5)), None);
    assert_eq!(region((4, 5), (6, 6)), None);
    assert_eq!(region((1, 6), (1, 6)), None);
    // Unstable all over but for a mixed corner: σ up to 6/10 at β = ½ is stable.
    assert_eq!(region((1, 5), (1, 6)), None);
    let truth = |beta, sigma| friction_box(beta, sigma).decide(&Speeds::All);
    assert_eq!(truth((5, 9), (5, 9)), Some(Truth::Holds));
    assert_eq!(truth((4, 9), (5, 9)), Some(Truth::Depends));
    assert_eq!(truth((1, 4), (1, 9)), Some(Truth::Fails));
}

#[test]
fn num_exact_box_of_an_undefined_number_is_undecided() {
    use passivity_core::{Fixed, Scalar as _};
    let nothing = Fixed::new(1, 0);
    let friction = Friction::new(nothing, Fixed::one());
    let of = Loop::plain(friction).map(|_, x| Interval::point(*x));
    assert_eq!(of.decide(&Speeds::All), None);
    assert_eq!(of.region(), None);
    let one = Fixed::one();
    let plain = Loop::plain(Friction::new(Fixed::new(2, 5), one)).map(|_, x| Interval::point(*x));
    assert_eq!(plain.decide(&Speeds::UpTo(Interval::point(nothing))), None);
    let undefined = Criterion {
        viscous: nothing,
        coulomb: one,
    };
    assert_eq!(verdict::decide(&undefined, &Speeds::All), None);
}
