//! Exact numbers on the grid: rounded down, up, or outward.

use num_traits::ToPrimitive as _;
use passivity_core::BigRational;

use super::ONE;
use crate::number::Reduced;

/// The first number rounded down to the grid and the second one rounded up, where that fits.
pub(crate) fn on_both_sides(lo: &BigRational, hi: &BigRational) -> Option<[i128; 2]> {
    let scaled = |x: &BigRational| x * BigRational::from_integer(ONE.into());
    let lo = scaled(lo).floor().to_integer().to_i128()?;
    Some([lo, scaled(hi).ceil().to_integer().to_i128()?])
}

/// The numbers rounded outward to the grid, where that fits.
pub(crate) fn outward([lo, hi]: [Reduced; 2]) -> [Reduced; 2] {
    let x = hi.to_rational();
    let above = on_both_sides(&x, &x).map_or(hi, |[_, above]| Reduced::Small(above, ONE));
    [below_on_grid(lo), above]
}

/// The number rounded down to the grid, where that fits.
pub(crate) fn below_on_grid(x: Reduced) -> Reduced {
    let exact = x.to_rational();
    on_both_sides(&exact, &exact).map_or(x, |[below, _]| Reduced::Small(below, ONE))
}

/// How many units of the grid an end of a span is.
pub(crate) const fn units(end: &Reduced) -> Option<i128> {
    match end {
        Reduced::Small(n, ONE) => Some(*n),
        _ => None,
    }
}

/// A number of units of the grid.
pub(crate) fn on_grid(n: i128) -> BigRational {
    BigRational::new(n.into(), ONE.into())
}
