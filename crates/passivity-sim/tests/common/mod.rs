//! Points to simulate, written as exact numbers.

#![allow(dead_code, unreachable_pub)]

use passivity_core::{BigRational, Scalar};
use passivity_scene::Point;
use passivity_scene::number::parse;
use passivity_scene::point::Units;

/// The number that a text spells.
pub fn q(text: &str) -> BigRational {
    parse(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The paper's own scene.
pub fn point(mu: &str, beta: &str, sigma: &str, start: [&str; 2], intervals: u64) -> Point {
    let one = BigRational::integer(1);
    Point {
        mu: Some(q(mu)),
        beta: Some(q(beta)),
        sigma: Some(q(sigma)),
        encoder: true,
        delay: 0,
        unilateral: false,
        damping: None,
        max_force: None,
        force_step: None,
        amplifier: None,
        force: None,
        arm: None,
        start: start.map(q),
        intervals,
        units: Units {
            period: one.clone(),
            length: one.clone(),
            stiffness: one,
        },
    }
}

/// The paper's scene at (β, σ) with μ = 50, from ξ = 0.
pub fn paper(beta: &str, sigma: &str, speed: &str, intervals: u64) -> Point {
    point("50", beta, sigma, ["0", speed], intervals)
}
