//! Where the criterion has its borders in the (β, σ) plane: the critical line (9) of a speed.

use std::ops::Range;

use passivity_core::{BigRational, Cost, Loop};
use passivity_scene::number::nearest_f64;

/// The corner through which all critical lines go: what the effects cost of β and σ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Borders {
    /// ½ + k + B: below it the criterion fails at high speeds.
    pub beta: f64,
    /// ½(1 + δ) + B: below it the criterion fails at low speeds.
    pub sigma: f64,
}

impl Borders {
    /// Those of the paper's loop, of sampling and quantization alone.
    pub const PAPER: Self = Self {
        beta: 0.5,
        sigma: 0.5,
    };

    /// The borders of a dimensionless loop.
    #[must_use]
    pub fn of(dimensionless: &Loop<BigRational>) -> Self {
        let Cost { viscous, coulomb } = dimensionless.cost();
        Self {
            beta: nearest_f64(&viscous),
            sigma: nearest_f64(&coulomb),
        }
    }

    /// The part of (β − λ)v + (σ − s) = 0 (9) within a window, where (λ, s) is the corner; `None`
    /// where the line does not cross it. The speed is in ticks per sample, zero or above.
    #[must_use]
    pub fn critical_line(
        self,
        speed: f64,
        width: &Range<f64>,
        height: &Range<f64>,
    ) -> Option<[(f64, f64); 2]> {
        if speed == 0.0 {
            return Some([(width.start, self.sigma), (width.end, self.sigma)]);
        }
        let sigma = |beta: f64| self.sigma - speed * (beta - self.beta);
        let beta = |sigma: f64| self.beta + (self.sigma - sigma) / speed;
        // Falling: it enters by the left or the upper edge and leaves by the right or the lower one.
        let start = if sigma(width.start) <= height.end {
            (width.start, sigma(width.start))
        } else {
            (beta(height.end), height.end)
        };
        let end = if sigma(width.end) >= height.start {
            (width.end, sigma(width.end))
        } else {
            (beta(height.start), height.start)
        };
        (start.0 < end.0).then_some([start, end])
    }
}

#[cfg(test)]
mod tests {
    use passivity_core::{Friction, Scalar as _};

    use super::*;

    #[test]
    fn critical_lines_pass_through_the_corner_and_stay_in_the_window() {
        for speed in [0.01, 0.5, 1.0, 3.0, 100.0] {
            let (x, y) = (-0.5..1.5, -0.25..1.25);
            let line = Borders::PAPER.critical_line(speed, &x, &y).unwrap();
            let [(x0, y0), (x1, y1)] = line;
            // Collinear with (½, ½): a cross product of numbers below 2, so rounding is < 1e-14.
            let cross = (x1 - x0) * (0.5 - y0) - (y1 - y0) * (0.5 - x0);
            assert!(cross.abs() < 1e-14, "{speed}: {cross}");
            for (beta, sigma) in line {
                assert!(beta >= x.start && beta <= x.end);
                assert!(sigma >= y.start && sigma <= y.end);
            }
        }
    }

    #[test]
    fn critical_lines_go_through_what_the_effects_cost() {
        let zero = BigRational::zero;
        let plain = Loop::plain(Friction::new(zero(), zero()));
        assert_eq!(Borders::of(&plain), Borders::PAPER);
        let late = Loop {
            delay: 1,
            damping: Some(BigRational::one()),
            force_step: Some(BigRational::one()),
            ..plain
        };
        let borders = Borders::of(&late);
        let expected = Borders {
            beta: 2.5,
            sigma: 2.0,
        };
        assert_eq!(borders, expected);
        // At β = 2.5 every critical line has σ = 2.
        let line = borders.critical_line(2.0, &(0.0..3.0), &(0.0..9.0));
        assert_eq!(line, Some([(0.0, 7.0), (3.0, 1.0)]));
        // Nothing of the plane's line is in a window that lies below it.
        assert_eq!(borders.critical_line(2.0, &(0.0..1.0), &(0.0..1.0)), None);
    }
}
