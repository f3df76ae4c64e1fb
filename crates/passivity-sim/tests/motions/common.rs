//! Points to simulate, written as exact numbers.

#![allow(dead_code, unreachable_pub)]

use passivity_core::{BigRational, Friction, Loop, Scalar};
use passivity_scene::Point;
use passivity_scene::number::{nearest_f64, parse};
use passivity_scene::point::Units;

/// The number that a text spells.
pub fn q(text: &str) -> BigRational {
    parse(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The nearest double.
pub fn double(x: &BigRational) -> f64 {
    nearest_f64(x)
}

/// The paper's own scene.
pub fn point(mu: &str, beta: &str, sigma: &str, start: [&str; 2], intervals: u64) -> Point {
    let one = BigRational::one();
    let [position, velocity] = start.map(q);
    Point {
        at: Loop {
            inertia: Some(q(mu)),
            start_position: Some(position),
            start_velocity: Some(velocity),
            ..Loop::plain(Friction::new(q(beta), q(sigma)))
        },
        forces: None,
        intervals,
        units: Units {
            period: one.clone(),
            length: one.clone(),
            stiffness: one,
            length_unit: None,
        },
    }
}

/// The paper's scene at (β, σ) with μ = 50, from ξ = 0.
pub fn paper(beta: &str, sigma: &str, speed: &str, intervals: u64) -> Point {
    point("50", beta, sigma, ["0", speed], intervals)
}
