//! From margins to a verdict: one loop. Boxes of them are in `boxes`.

use passivity_core::verdict::{self, Speeds, decide};
use passivity_core::{BigRational, Criterion, Fixed, Friction, Loop, Region, Scalar};
use proptest::prelude::*;

use crate::common::{half, number, positive, q, sampled, squared, zero};

/// Whether the criterion holds at every speed asked for, from its definition.
pub(crate) fn holds_by_hand(
    criterion: &Criterion<BigRational>,
    bound: Option<&BigRational>,
) -> bool {
    let Criterion { viscous, coulomb } = criterion;
    match bound {
        None => *viscous >= zero() && *coulomb >= zero(),
        Some(bound) => *coulomb >= zero() && viscous * bound + coulomb >= zero(),
    }
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
}

#[test]
fn th_region_loop_beyond_128_bits() {
    // One part in 2^300 below the corner: only big integers can tell.
    let tiny = BigRational::new(1.into(), num_bigint::BigInt::from(1) << 300);
    let of = |beta| {
        let plain = Loop::plain(Friction::new(beta, half()));
        verdict::of_loop(&plain, &Speeds::All).unwrap()
    };
    let below = of(half() - &tiny);
    assert!(!below.holds && below.region == Region::Unstable);
    let above = of(half() + &tiny);
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
