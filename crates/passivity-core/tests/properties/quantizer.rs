//! (15) and (5).

use passivity_core::Quantized;
use passivity_core::quantizer::held_force;
use proptest::prelude::*;

use crate::common::{half, magnitude, position, q, sampled, zero};

sampled! {
    fn eq_16_17_quantizer_splits_a_position(xi in position()) {
        let split = Quantized::of(&xi);
        prop_assert!(split.tick.is_integer());
        prop_assert!(split.residue >= zero() && split.residue < q(1, 1));
        prop_assert_eq!(&split.tick + &split.residue, xi.clone());
        prop_assert_eq!(split.measured(), &split.tick + half());
        prop_assert!(magnitude(&(split.measured() - xi)) <= half());
    }

    fn eq_16_17_held_force_is_centred(xi in position()) {
        let tick = xi.floor();
        prop_assert_eq!(held_force(&xi), -(tick + half()));
    }

    fn eq_16_17_held_force_is_odd_inside_a_tick(n in -9i64..9, r in 1i64..16) {
        let xi = q(n, 1) + q(r, 16);
        prop_assert_eq!(held_force(&xi), -held_force(&-&xi));
    }
}

#[test]
fn eq_16_17_held_force_values() {
    for (xi, force) in [
        (q(0, 1), q(-1, 2)),
        (q(5, 4), q(-3, 2)),
        (q(-1, 4), q(1, 2)),
        (q(-2, 1), q(3, 2)),
    ] {
        assert_eq!(held_force(&xi), force);
    }
}
