//! TH-REGION: the four regions and their borders.

use passivity_core::region::critical_speed;
use passivity_core::{Criterion, Fixed, Friction, Region, Scalar};
use proptest::prelude::*;

use crate::common::{friction, half, positive, q, sampled, zero};

sampled! {
    /// The region is the set of speeds at which the criterion holds.
    fn th_region_is_the_set_of_speeds(friction in friction(), v in positive()) {
        let criterion = Criterion::of_friction(&friction);
        let holds = (&friction.beta - half()) * &v + (&friction.sigma - half()) >= zero();
        let expected = match Region::of(&criterion).unwrap() {
            Region::GloballyStable => true,
            Region::Unstable => false,
            Region::LocallyStable => v <= critical_speed(&criterion),
            Region::LimitCycles => v >= critical_speed(&criterion),
        };
        prop_assert_eq!(holds, expected);
    }

    fn th_region_by_the_quadrants(friction in friction()) {
        let (b, s) = (&friction.beta, &friction.sigma);
        let h = half();
        let expected = if *b >= h && *s >= h {
            Region::GloballyStable
        } else if *b < h && *s > h {
            Region::LocallyStable
        } else if *b > h && *s < h {
            Region::LimitCycles
        } else {
            Region::Unstable
        };
        prop_assert_eq!(Region::of(&Criterion::of_friction(&friction)), Some(expected));
    }

    fn th_region_critical_speed(friction in friction()) {
        let (viscous, coulomb) = (&friction.beta - half(), &friction.sigma - half());
        prop_assume!(viscous != zero());
        let criterion = Criterion::of_friction(&friction);
        let speed = critical_speed(&criterion);
        prop_assert_eq!(speed.clone(), (half() - &friction.sigma) / viscous.clone());
        prop_assert_eq!(criterion.margin(&speed), zero());
        prop_assert_eq!(speed > zero(), viscous * coulomb < zero());
    }
}

#[test]
fn th_region_on_and_beside_the_lines() {
    use Region::{GloballyStable as G, LimitCycles as C, LocallyStable as L, Unstable as U};
    // Rows σ = 3/8, ½, 5/8; columns β = 3/8, ½, 5/8.
    let table = [[U, U, C], [U, G, G], [L, G, G]];
    for (i, row) in table.iter().enumerate() {
        for (j, expected) in row.iter().enumerate() {
            let at = |k: usize| q(3 + i64::try_from(k).unwrap(), 8);
            let friction = Friction::new(at(j), at(i));
            assert_eq!(
                Region::of(&Criterion::of_friction(&friction)),
                Some(*expected)
            );
        }
    }
}

#[test]
fn th_region_of_an_undefined_criterion_is_none() {
    let nothing = Fixed::new(1, 0);
    for (viscous, coulomb) in [(nothing, Fixed::integer(1)), (Fixed::integer(-1), nothing)] {
        assert_eq!(Region::of(&Criterion { viscous, coulomb }), None);
    }
}

#[test]
fn th_region_names() {
    let all = [
        Region::GloballyStable,
        Region::LocallyStable,
        Region::LimitCycles,
        Region::Unstable,
    ];
    let names = [
        "globally_stable",
        "locally_stable",
        "limit_cycles",
        "unstable",
    ];
    assert_eq!(all.map(Region::name), names);
}
