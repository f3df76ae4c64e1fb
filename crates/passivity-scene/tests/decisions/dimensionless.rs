//! Scenes without units.

use num_traits::ToPrimitive as _;
use passivity_core::BigRational;
use passivity_scene::check::{Report, check};
use passivity_scene::{Scene, number};

pub(crate) fn q(text: &str) -> BigRational {
    number::parse(text).unwrap()
}

/// The report on a dimensionless scene with these further sections.
pub(crate) fn report(beta: &BigRational, sigma: &str, sections: &str) -> Report {
    let text = format!("[dimensionless]\nbeta = \"{beta}\"\nsigma = \"{sigma}\"\n{sections}");
    check(&Scene::from_toml("scene", &text).unwrap_or_else(|error| panic!("{error}\n{text}")))
}

pub(crate) fn approx(x: &BigRational) -> f64 {
    x.to_f64().unwrap()
}
