//! From margins to a verdict: one rig, and a box of them.

use passivity_core::effects::Effects;
use passivity_core::verdict::{self, RigBox, Speeds, decide};
use passivity_core::{
    BigRational, Criterion, Fixed, Friction, Interval, Region, Rig, Scalar, Truth,
};
use proptest::prelude::*;

use crate::common::{coefficient, half, number, positive, q, sampled, squared, unit, zero};
use crate::rig::criterion_written_out;

/// Whether the criterion holds at every speed asked for, from its definition.
fn holds_by_hand(criterion: &Criterion<BigRational>, bound: Option<&BigRational>) -> bool {
    let Criterion { viscous, coulomb } = criterion;
    match bound {
        None => *viscous >= zero() && *coulomb >= zero(),
        Some(bound) => *coulomb >= zero() && viscous * bound + coulomb >= zero(),
    }
}

/// An interval above zero: a point, narrow, or wide.
fn interval() -> impl Strategy<Value = Interval<BigRational>> {
    (coefficient(), unit(), 0u8..3).prop_map(|(x, width, kind)| {
        let x = x + q(1, 64);
        let hi = match kind {
            0 => x.clone(),
            1 => &x + width / q(1000, 1),
            _ => &x + width,
        };
        Interval::new(x, hi).unwrap()
    })
}

fn rigs() -> impl Strategy<Value = RigBox> {
    (
        (interval(), interval(), interval(), interval(), interval()),
        (
            any::<bool>(),
            0u16..3,
            prop::option::of(interval()),
            prop::option::of(interval()),
        ),
    )
        .prop_map(
            |(
                (viscous, coulomb, stiffness, period, length),
                (encoder, delay, damping, force_step),
            )| RigBox {
                viscous,
                coulomb,
                stiffness,
                period,
                length,
                encoder,
                delay,
                damping,
                force_step,
            },
        )
}

/// The corner of the box that a mask of seven bits names: b, c, K, T, Δ, B, F, low or high.
fn corner(rigs: &RigBox, mask: u8) -> Rig<BigRational> {
    let pick = |i: &Interval<BigRational>, bit: u8| {
        if mask >> bit & 1 == 1 { i.hi() } else { i.lo() }.clone()
    };
    Rig {
        viscous: pick(&rigs.viscous, 0),
        coulomb: pick(&rigs.coulomb, 1),
        stiffness: pick(&rigs.stiffness, 2),
        period: pick(&rigs.period, 3),
        length: pick(&rigs.length, 4),
        effects: Effects {
            encoder: rigs.encoder,
            delay: rigs.delay,
            damping: rigs.damping.as_ref().map(|i| pick(i, 5)),
            force_step: rigs.force_step.as_ref().map(|i| pick(i, 6)),
        },
    }
}

/// Least friction and most of all else, and the other way round.
const HARDEST: u8 = 0b111_1100;
const EASIEST: u8 = 0b000_0011;

/// Whether the box encloses its criteria and does not reach them: T pulls both ways in BΔ/T.
fn encloses_only(rigs: &RigBox) -> bool {
    rigs.encoder && rigs.damping.is_some() && !rigs.period.is_point()
}

sampled! {
    fn th_region_decision(viscous in number(), coulomb in number(), v in positive()) {
        let criterion = Criterion { viscous, coulomb };
        let region = Region::of(&criterion);
        let decide = |speeds| decide(&criterion, &speeds).unwrap();
        for decision in [decide(Speeds::All), decide(Speeds::UpTo(v.clone()))] {
            prop_assert_eq!(Some(decision.region), region);
        }
        prop_assert_eq!(decide(Speeds::All).holds, holds_by_hand(&criterion, None));
        prop_assert_eq!(decide(Speeds::UpTo(v.clone())).holds, holds_by_hand(&criterion, Some(&v)));
        prop_assert_eq!(decide(Speeds::UpToSquared(squared(&v))).holds, holds_by_hand(&criterion, Some(&v)));
    }

    fn th_region_decision_at_the_critical_speed(viscous in positive(), coulomb in positive()) {
        let v = &coulomb / &viscous;
        let criterion = Criterion { viscous: -viscous, coulomb };
        prop_assert!(decide(&criterion, &Speeds::UpTo(v.clone())).unwrap().holds);
        let above = v * q(1_000_001, 1_000_000);
        prop_assert!(!decide(&criterion, &Speeds::UpTo(above.clone())).unwrap().holds);
        prop_assert!(!decide(&criterion, &Speeds::UpToSquared(squared(&above))).unwrap().holds);
        prop_assert!(!decide(&criterion, &Speeds::All).unwrap().holds);
    }

    fn th_region_box_verdict_agrees_with_its_members(
        rigs in rigs(), bound in prop::option::of(interval()), masks in prop::collection::vec(0u8..128, 4)
    ) {
        let (hardest, easiest) = match &bound {
            Some(bound) => (Speeds::UpTo(bound.hi().clone()), Speeds::UpTo(bound.lo().clone())),
            None => (Speeds::All, Speeds::All),
        };
        let truth = rigs.holds(&hardest, &easiest).unwrap();
        let region = rigs.region();
        let (worst, best) = rigs.criteria();
        for mask in masks.into_iter().chain([HARDEST, EASIEST]) {
            let rig = corner(&rigs, mask);
            let criterion = criterion_written_out(&rig);
            prop_assert!(worst.viscous <= criterion.viscous && criterion.viscous <= best.viscous);
            prop_assert!(worst.coulomb <= criterion.coulomb && criterion.coulomb <= best.coulomb);
            if let Some(region) = region {
                prop_assert_eq!(Region::of(&criterion), Some(region));
            }
            for speed in bound.as_ref().map_or(vec![None], |b| vec![Some(b.lo()), Some(b.hi())]) {
                match truth {
                    Truth::Holds => prop_assert!(holds_by_hand(&criterion, speed)),
                    Truth::Fails => prop_assert!(!holds_by_hand(&criterion, speed)),
                    Truth::Depends => {}
                }
            }
        }
    }

    /// Where no parameter pulls both ways, "depends" means that two members disagree.
    fn th_region_box_depends_only_where_members_differ(rigs in rigs()) {
        prop_assume!(!encloses_only(&rigs));
        let truth = rigs.holds(&Speeds::All, &Speeds::All).unwrap();
        let holds = |mask| holds_by_hand(&criterion_written_out(&corner(&rigs, mask)), None);
        let expected = match (holds(HARDEST), holds(EASIEST)) {
            (true, true) => Truth::Holds,
            (false, true) => Truth::Depends,
            (_, false) => Truth::Fails,
        };
        prop_assert_eq!(truth, expected);
    }

    fn th_region_box_of_one_rig_is_the_rig(rigs in rigs()) {
        let point = |i: &Interval<BigRational>| Interval::point(i.lo().clone());
        let rigs = RigBox {
            viscous: point(&rigs.viscous),
            coulomb: point(&rigs.coulomb),
            stiffness: point(&rigs.stiffness),
            period: point(&rigs.period),
            length: point(&rigs.length),
            damping: rigs.damping.as_ref().map(point),
            force_step: rigs.force_step.as_ref().map(point),
            ..rigs
        };
        let rig = rigs.worst();
        prop_assert_eq!(&rigs.best(), &rig);
        let expected = criterion_written_out(&rig);
        prop_assert_eq!(rigs.criteria(), (expected.clone(), expected.clone()));
        prop_assert_eq!(rigs.region(), Region::of(&expected));
        let decision = verdict::of_rig(&rig, &Speeds::All).unwrap();
        prop_assert_eq!(Some(decision.region), Region::of(&expected));
        let truth = if decision.holds { Truth::Holds } else { Truth::Fails };
        prop_assert_eq!(rigs.holds(&Speeds::All, &Speeds::All), Some(truth));
    }

    fn th_region_worst_and_best_corners(rigs in rigs()) {
        let (worst, best) = (rigs.worst(), rigs.best());
        for (rig, friction, load) in [
            (&worst, Interval::lo as fn(&Interval<BigRational>) -> &BigRational, Interval::hi as fn(&Interval<BigRational>) -> &BigRational),
            (&best, Interval::hi, Interval::lo),
        ] {
            prop_assert_eq!(&rig.viscous, friction(&rigs.viscous));
            prop_assert_eq!(&rig.coulomb, friction(&rigs.coulomb));
            prop_assert_eq!(&rig.stiffness, load(&rigs.stiffness));
            prop_assert_eq!(&rig.period, load(&rigs.period));
            prop_assert_eq!(&rig.length, load(&rigs.length));
            prop_assert_eq!(rig.effects.damping.as_ref(), rigs.damping.as_ref().map(load));
            prop_assert_eq!(rig.effects.force_step.as_ref(), rigs.force_step.as_ref().map(load));
            prop_assert_eq!((rig.effects.encoder, rig.effects.delay), (rigs.encoder, rigs.delay));
        }
    }
}

/// A box of dimensionless rigs, [β] × [σ].
fn friction_box(beta: (i64, i64), sigma: (i64, i64)) -> RigBox {
    let interval = |(lo, hi)| Interval::new(q(lo, 10), q(hi, 10)).unwrap();
    let one = || Interval::point(q(1, 1));
    RigBox {
        viscous: interval(beta),
        coulomb: interval(sigma),
        stiffness: one(),
        period: one(),
        length: one(),
        encoder: true,
        delay: 0,
        damping: None,
        force_step: None,
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
    let truth = |beta, sigma| friction_box(beta, sigma).holds(&Speeds::All, &Speeds::All);
    assert_eq!(truth((5, 9), (5, 9)), Some(Truth::Holds));
    assert_eq!(truth((4, 9), (5, 9)), Some(Truth::Depends));
    assert_eq!(truth((1, 4), (1, 9)), Some(Truth::Fails));
}

#[test]
fn th_region_rig_beyond_128_bits() {
    // One part in 2^300 below the corner: only big integers can tell.
    let tiny = BigRational::new(1.into(), num_bigint::BigInt::from(1) << 300);
    let rig = |beta| Rig::dimensionless(Friction::new(beta, half()), Effects::encoder());
    let below = verdict::of_rig(&rig(half() - &tiny), &Speeds::All).unwrap();
    assert!(!below.holds && below.region == Region::Unstable);
    let above = verdict::of_rig(&rig(half() + &tiny), &Speeds::All).unwrap();
    assert!(above.holds && above.region == Region::GloballyStable);
}

#[test]
fn th_region_speeds_are_mapped() {
    let double = |x: &BigRational| Some(x + x);
    assert_eq!(
        Speeds::UpTo(q(1, 2)).try_map(double),
        Some(Speeds::UpTo(q(1, 1)))
    );
    assert_eq!(
        Speeds::UpToSquared(q(1, 2)).try_map(double),
        Some(Speeds::UpToSquared(q(1, 1)))
    );
    assert_eq!(
        Speeds::<BigRational>::All.try_map(double),
        Some(Speeds::All)
    );
    let none = |_: &BigRational| None::<Fixed>;
    assert_eq!(Speeds::UpTo(q(1, 2)).try_map(none), None);
    assert_eq!(Speeds::UpToSquared(q(1, 2)).try_map(none), None);
    let undefined = Criterion {
        viscous: Fixed::new(1, 0),
        coulomb: Fixed::one(),
    };
    assert_eq!(decide(&undefined, &Speeds::All), None);
}
