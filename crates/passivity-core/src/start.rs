//! How fast an unforced motion can ever get (TH-START), in squares: no roots are taken.

use core::cmp::Ordering;

use crate::criterion::Criterion;
use crate::scalar::{Ordered, Scalar};

/// V² = ξ̇(0)² + ξ(0)²/μ, the square of a speed that an unforced passive motion never passes.
///
/// With ξ(0) = 0 it is the initial speed of (10). `mu` > 0; ticks and ticks per sample, or with
/// units when `mu` is m/K.
///
/// A controller with a delay or with damping must have seen nothing but rest before the start
/// (TH-START): where it remembers a motion, the bound is [`speed_squared_with_memory`].
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, start::speed_squared};
///
/// let v2 = speed_squared(&Fixed::integer(4), &Fixed::integer(8), &Fixed::integer(3));
/// assert_eq!(v2, Fixed::integer(25));
/// ```
#[must_use]
pub fn speed_squared<S: Scalar>(mu: &S, xi: &S, velocity: &S) -> S {
    velocity.square() + xi.square().over(mu.clone())
}

/// V² = ξ̇(0)² + (ξ(0)² + 2E)/μ, where the controller remembers a motion from before the start.
///
/// E ≥ 0 is the extra storage at the start, [`delay_storage`](crate::extra_storage::delay_storage)
/// and [`damping_storage`](crate::extra_storage::damping_storage) of the last steps before it
/// (TH-START); in KΔ², or with units when it is divided by K.
///
/// # Example
///
/// At rest at ξ = 0, but a sample before the device was ten ticks away: a force that is one sample
/// late still pushes.
///
/// ```
/// use passivity_core::{Fixed, Scalar, extra_storage::delay_storage, start};
///
/// let (mu, rest) = (Fixed::integer(1), Fixed::integer(0));
/// let extra = delay_storage(&[Fixed::integer(10)]);
/// assert_eq!(start::speed_squared(&mu, &rest, &rest), rest);
/// assert_eq!(start::speed_squared_with_memory(&mu, &rest, &rest, &extra), Fixed::integer(100));
/// ```
#[must_use]
pub fn speed_squared_with_memory<S: Scalar>(mu: &S, xi: &S, velocity: &S, extra: &S) -> S {
    speed_squared(mu, xi, velocity) + extra.double().over(mu.clone())
}

/// `coulomb`² − `viscous`²·V²: where `viscous` < 0 < `coulomb`, the criterion holds at speed V
/// exactly when this is not negative.
#[must_use]
pub fn margin_of_squares<S: Scalar>(criterion: &Criterion<S>, speed_squared: &S) -> S {
    criterion.coulomb.square() - criterion.viscous.square() * speed_squared.clone()
}

/// Whether the criterion holds at every speed v with 0 < v ≤ V, given V²; `None` when a number is
/// undefined.
///
/// At V = 0 nothing moves and nothing is asked, but a device that is pushed would move: the
/// answer is that of arbitrarily small speeds.
#[must_use]
#[cfg_attr(prusti, prusti_contracts::ensures(criterion.viscous.sign().is_none() ==> result.is_none()))]
#[cfg_attr(prusti, prusti_contracts::ensures(criterion.coulomb.sign().is_none() ==> result.is_none()))]
pub fn holds_up_to<S: Ordered>(criterion: &Criterion<S>, speed_squared: &S) -> Option<bool> {
    match (criterion.viscous.sign()?, criterion.coulomb.sign()?) {
        (_, Ordering::Less) => Some(false),
        (Ordering::Less, Ordering::Equal) => Some(false),
        (Ordering::Less, Ordering::Greater) => {
            margin_of_squares(criterion, speed_squared).is_nonnegative()
        }
        (_, _) => Some(true),
    }
}
