//! The table of what each quantity may be.

use std::cmp::Ordering::{Equal, Greater, Less};

use passivity_core::bounds::{Quantity, TABLE};

#[test]
fn num_exact_bounds_of_every_quantity() {
    let expected = [
        (Quantity::Inertia, "inertia", "m", false),
        (Quantity::Viscous, "viscous friction", "b", true),
        (Quantity::Coulomb, "Coulomb friction", "c", true),
        (Quantity::Stiffness, "wall stiffness", "K", false),
        (Quantity::Period, "sampling period", "T", false),
        (Quantity::Resolution, "encoder resolution", "Δ", false),
        (Quantity::Damping, "virtual damping", "B", true),
        (Quantity::ForceStep, "force step", "F", false),
        (Quantity::MaxForce, "largest force", "F_max", false),
        (Quantity::MaxSpeed, "speed bound", "V", false),
        (
            Quantity::TimeConstant,
            "amplifier time constant",
            "T_a",
            false,
        ),
    ];
    assert_eq!(TABLE.len(), expected.len());
    for (quantity, name, symbol, zero_allowed) in expected {
        let bound = quantity.bound();
        assert_eq!(bound.quantity, quantity);
        assert_eq!(
            (bound.name, bound.symbol, bound.zero_allowed),
            (name, symbol, zero_allowed)
        );
        assert!(TABLE.contains(&bound));
        assert!(!bound.allows(Less) && bound.allows(Greater));
        assert_eq!(bound.allows(Equal), zero_allowed);
        let text = if zero_allowed {
            "zero or a value above it"
        } else {
            "a value above zero"
        };
        assert_eq!(bound.expected(), text);
    }
}
