//! Exact numbers, and how they become doubles.

use passivity_core::BigRational;

use super::real::Real;

/// The nearest double, infinite when out of range.
pub(crate) fn to_double(x: &BigRational) -> f64 {
    passivity_scene::number::nearest_f64(x)
}

impl Real for BigRational {
    fn approximate(&self) -> f64 {
        to_double(self)
    }

    fn is_defined(&self) -> bool {
        true
    }

    fn bits(&self) -> u32 {
        0 // No series is ever summed: there is none at β = 0.
    }

    fn length(&self) -> u64 {
        self.numer().bits() + self.denom().bits()
    }
}
