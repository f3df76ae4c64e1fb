//! The bound that `ledger::row` states for fractions of 32 bits, on all numbers within it.

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{Fraction, Friction, Loop, Step};

/// Every fraction of two bits: numerators from `low` to 3, denominators from 1 to 3.
fn within(low: i32) -> Vec<Fraction<i32>> {
    let numerators = low..=3;
    numerators
        .flat_map(|n| (1..=3).map(move |d| Fraction::new(n, d)))
        .collect()
}

/// TH-INTERVAL: 571 536 rows, none of which overflows.
#[test]
fn every_row_within_its_bound_is_defined() {
    let (signed, positive, durations) = (within(-3), within(0), within(1));
    let mut rows = 0;
    for start in &signed {
        for end in &signed {
            for beta in &positive {
                for sigma in &positive {
                    for dtau in &durations {
                        let friction = Friction::new(*beta, *sigma);
                        let interval = HeldInterval::plain(Step::new(*start, *end), *dtau);
                        let row = ledger::row(&Loop::plain(friction), &interval);
                        let fields = [
                            row.generated_linear,
                            row.generated_quantized,
                            row.bound_22,
                            row.bound_quantized,
                            row.dissipated_lower,
                            row.net_linear,
                            row.net_quantized,
                            row.margin,
                        ];
                        assert!(fields.iter().all(Fraction::is_defined), "{start:?} {end:?}");
                        rows += 1;
                    }
                }
            }
        }
    }
    assert_eq!(rows, 571_536);
}
