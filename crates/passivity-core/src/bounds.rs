//! What values each quantity may take: one table for validation, error texts and test inputs.

/// A physical quantity of a rig, by the field's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// m, mass or moment of inertia.
    Inertia,
    /// b, viscous friction.
    Viscous,
    /// c, Coulomb friction.
    Coulomb,
    /// K, stiffness of the wall.
    Stiffness,
    /// T, sampling period.
    Period,
    /// Δ, encoder resolution.
    Resolution,
    /// B, virtual damping.
    Damping,
    /// F, force step of the D/A converter.
    ForceStep,
    /// The largest force that the actuator gives.
    MaxForce,
    /// A bound on the speed.
    MaxSpeed,
    /// The time constant of the amplifier.
    TimeConstant,
}

/// A row of the table: who may be zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bound {
    /// The quantity.
    pub quantity: Quantity,
    /// Its name in messages.
    pub name: &'static str,
    /// Its letter in the equations.
    pub symbol: &'static str,
    /// Whether zero is allowed; nothing below zero ever is.
    pub zero_allowed: bool,
}

/// The bounds of every quantity.
pub const TABLE: [Bound; 11] = [
    bound(Quantity::Inertia, "inertia", "m", false),
    bound(Quantity::Viscous, "viscous friction", "b", true),
    bound(Quantity::Coulomb, "Coulomb friction", "c", true),
    bound(Quantity::Stiffness, "wall stiffness", "K", false),
    bound(Quantity::Period, "sampling period", "T", false),
    bound(Quantity::Resolution, "encoder resolution", "Δ", false),
    bound(Quantity::Damping, "virtual damping", "B", true),
    bound(Quantity::ForceStep, "force step", "F", false),
    bound(Quantity::MaxForce, "largest force", "F_max", false),
    bound(Quantity::MaxSpeed, "speed bound", "V", false),
    bound(
        Quantity::TimeConstant,
        "amplifier time constant",
        "T_a",
        false,
    ),
];

const fn bound(
    quantity: Quantity,
    name: &'static str,
    symbol: &'static str,
    zero_allowed: bool,
) -> Bound {
    Bound {
        quantity,
        name,
        symbol,
        zero_allowed,
    }
}

impl Quantity {
    /// The quantity's row in [`TABLE`].
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::bounds::Quantity;
    ///
    /// assert_eq!(Quantity::Stiffness.bound().expected(), "a value above zero");
    /// ```
    #[must_use]
    pub fn bound(self) -> Bound {
        let found = TABLE.iter().find(|row| row.quantity == self).copied();
        // Every quantity has a row (tested); the fallback is the strictest.
        found.unwrap_or(bound(self, "quantity", "?", false))
    }
}

impl Bound {
    /// Whether a value with this sign is allowed.
    #[must_use]
    #[cfg_attr(prusti, prusti_contracts::ensures(matches!(sign, core::cmp::Ordering::Less) ==> !result))]
    #[cfg_attr(prusti, prusti_contracts::ensures(matches!(sign, core::cmp::Ordering::Greater) ==> result))]
    pub const fn allows(&self, sign: core::cmp::Ordering) -> bool {
        match sign {
            core::cmp::Ordering::Less => false,
            core::cmp::Ordering::Equal => self.zero_allowed,
            core::cmp::Ordering::Greater => true,
        }
    }

    /// What was expected, for an error message.
    #[must_use]
    pub const fn expected(&self) -> &'static str {
        if self.zero_allowed {
            "zero or a value above it"
        } else {
            "a value above zero"
        }
    }
}
