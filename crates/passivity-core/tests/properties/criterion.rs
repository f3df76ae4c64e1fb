//! (8), (9), (27): the criterion as a margin.

use passivity_core::{BigRational, Criterion, Friction};
use proptest::prelude::*;

use crate::common::{
    coefficient, friction, half, magnitude, nonnegative, number, positive, q, sampled, squared,
    zero,
};

fn criterion() -> impl Strategy<Value = Criterion<BigRational>> {
    (number(), number()).prop_map(|(viscous, coulomb)| Criterion { viscous, coulomb })
}

sampled! {
    fn eq_27_coefficients_are_above_one_half(friction in friction()) {
        let criterion = Criterion::of_friction(&friction);
        prop_assert_eq!(criterion.viscous, &friction.beta - half());
        prop_assert_eq!(criterion.coulomb, &friction.sigma - half());
    }

    fn eq_27_surplus_is_its_left_side(friction in friction(), d in number(), dtau in positive()) {
        let criterion = Criterion::of_friction(&friction);
        let speed = magnitude(&d) / &dtau;
        let left = (&friction.beta - half()) * squared(&d) / &dtau
            + (&friction.sigma - half()) * magnitude(&d);
        prop_assert_eq!(criterion.surplus(&d, &speed), left);
    }

    /// (27) holds exactly where (8), β + σ/v ≥ ½ + 1/(2v), holds at the mean speed.
    fn eq_27_equivalent_to_8(friction in friction(), d in number(), dtau in positive()) {
        prop_assume!(d != zero());
        let speed = magnitude(&d) / &dtau;
        let eight = &friction.beta + &friction.sigma / &speed >= half() + half() / &speed;
        let criterion = Criterion::of_friction(&friction);
        prop_assert_eq!(criterion.surplus(&d, &speed) >= zero(), eight);
        prop_assert_eq!(criterion.margin(&speed) >= zero(), eight);
    }

    fn eq_27_margin_is_linear_in_speed(criterion in criterion(), v in nonnegative()) {
        let expected = &criterion.viscous * &v + &criterion.coulomb;
        prop_assert_eq!(criterion.margin(&v), expected);
    }

    fn eq_27_margin_up_to_is_the_least(criterion in criterion(), bound in positive(), k in 0i64..=8) {
        let at_bound = criterion.margin(&bound);
        let least = criterion.margin_up_to(&bound);
        prop_assert!(least == at_bound || least == criterion.coulomb);
        prop_assert!(least <= criterion.margin(&(bound * q(k, 8))));
    }

    fn eq_27_more_friction_never_hurts(
        friction in friction(), more in nonnegative(), v in nonnegative()
    ) {
        let margin = |beta: BigRational, sigma: BigRational| {
            Criterion::of_friction(&Friction::new(beta, sigma)).margin(&v)
        };
        let (beta, sigma) = (friction.beta, friction.sigma);
        let before = margin(beta.clone(), sigma.clone());
        prop_assert!(margin(&beta + &more, sigma.clone()) >= before);
        prop_assert!(margin(beta, sigma + more) >= before);
    }

    fn th_region_margin_at_all_speeds_decides_all(criterion in criterion(), v in positive()) {
        let least = criterion.margin_at_all_speeds();
        let smaller = if criterion.viscous < criterion.coulomb {
            criterion.viscous.clone()
        } else {
            criterion.coulomb.clone()
        };
        prop_assert_eq!(least.clone(), smaller);
        if least >= zero() {
            prop_assert!(criterion.margin(&v) >= zero());
        } else {
            // A speed at which it fails: slow enough, or fast enough.
            let v = if criterion.coulomb < zero() {
                -&criterion.coulomb / (magnitude(&criterion.viscous) * q(2, 1) + q(1, 1))
            } else {
                (&criterion.coulomb + q(1, 1)) / -&criterion.viscous
            };
            prop_assert!(v > zero() && criterion.margin(&v) < zero());
        }
    }

    fn eq_27_critical_line_9(beta in coefficient(), v in positive()) {
        let sigma = Criterion::critical_sigma(&beta, &v);
        prop_assert_eq!(sigma.clone(), half() - &v * (&beta - half()));
        let on_it = Criterion::of_friction(&Friction::new(beta, sigma));
        prop_assert_eq!(on_it.margin(&v), zero());
    }
}
