//! Regions of the (β, σ) plane (Fig. 3) and the critical speed (TH-REGION).

use core::cmp::Ordering;

use crate::criterion::Criterion;
use crate::scalar::{Ordered, Scalar};

/// A region: the set of speeds v > 0 at which the criterion holds (TH-REGION).
///
/// # Example
///
/// ```
/// use passivity_core::{Criterion, Fixed, Friction, Region};
///
/// let on_the_corner = Friction::new(Fixed::new(1, 2), Fixed::new(1, 2));
/// let region = Region::of(&Criterion::of_friction(&on_the_corner));
/// assert_eq!(region, Some(Region::GloballyStable));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Region {
    /// Every speed: β ≥ ½ and σ ≥ ½.
    GloballyStable,
    /// Speeds up to the critical one: β < ½ < σ.
    LocallyStable,
    /// Speeds from the critical one on: σ < ½ < β.
    LimitCycles,
    /// No speed.
    Unstable,
}

impl Region {
    /// The region of a criterion; `None` when a coefficient is undefined.
    #[must_use]
    #[cfg_attr(prusti, prusti_contracts::ensures(criterion.viscous.sign().is_none() ==> result.is_none()))]
    pub fn of<S: Ordered>(criterion: &Criterion<S>) -> Option<Self> {
        use Ordering::{Greater, Less};
        Some(
            match (criterion.viscous.sign()?, criterion.coulomb.sign()?) {
                (Less, Greater) => Self::LocallyStable,
                (Greater, Less) => Self::LimitCycles,
                // On a line through (½, ½) with the other coefficient short: no speed v > 0 is left.
                (Less, _) | (_, Less) => Self::Unstable,
                (_, _) => Self::GloballyStable,
            },
        )
    }

    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::GloballyStable => "globally_stable",
            Self::LocallyStable => "locally_stable",
            Self::LimitCycles => "limit_cycles",
            Self::Unstable => "unstable",
        }
    }
}

/// The speed at which the margin is zero, v_c = (½ − σ)/(β − ½) (TH-REGION, TH-STIFF).
///
/// Of use where the two coefficients have opposite signs, in
/// [`Region::LocallyStable`] and [`Region::LimitCycles`]; in the units of the criterion.
///
/// # Example
///
/// ```
/// use passivity_core::{Criterion, Fixed, Friction, Scalar, region::critical_speed};
///
/// let locally_stable = Friction::new(Fixed::new(2, 5), Fixed::new(3, 5));
/// let speed = critical_speed(&Criterion::of_friction(&locally_stable));
/// assert_eq!(speed, Fixed::integer(1));
/// ```
#[must_use]
pub fn critical_speed<S: Scalar>(criterion: &Criterion<S>) -> S {
    (-criterion.coulomb.clone()).over(criterion.viscous.clone())
}
