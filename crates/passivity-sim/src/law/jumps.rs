//! Where a held force jumps, so that rounding may decide which of two forces it is.
//!
//! With an encoder that is at its edges. Without one it is at the surface of a one-sided wall, where virtual damping or a
//! filter sets in with what it makes of the speed, and half-way between two steps of a D/A converter. These are looked at
//! where a sample's force is computed; laws that have neither have none of this in their code. Behind an encoder whole
//! numbers decide of the steps.

use num_bigint::BigInt;
use passivity_core::{BigRational, Controller};

use super::{DAMPING, ENCODER, FILTER, FORCE_STEP, HeldForce, LARGEST_WHOLE, UNILATERAL};
use crate::number::to_double;
use crate::rounding::{EACH, off_edge};

/// What an error of the position is taken for that the force of the wall follows, of the greatest |ξ|: with an
/// encoder or steps a force has no error, here it has, and leads it on, by which no bound is carried along. It has
/// room for 2²⁰ times the rounding of a number.
const FOLLOWS: f64 = 1_048_576.0 * f64::EPSILON;

impl HeldForce {
    /// The same law of a controller in exact numbers, whose virtual damping and step are taken in whole numbers as far
    /// as doubles have them.
    ///
    /// With B = b/b′ and δ = n/d a force of u = q + B·Δq is of (q·b′d + Δq·bd)/(b′n) steps: of samples of an encoder,
    /// whole ticks and a half, nothing is rounded before the quotient, and a force half-way between two steps is seen as
    /// such.
    #[must_use]
    pub(crate) fn with_whole_steps(self, exact: &Controller<BigRational>) -> Self {
        let (Some([n, d]), [tail]) = (&exact.force_step, exact.filter.tails.as_slice()) else {
            return self;
        };
        let whole = |n: &BigInt| BigRational::from_integer(n.clone());
        let (b, parts) = (-whole(tail.numer()), whole(tail.denom()));
        let whole = [&parts * d, &b * d, &parts * n].map(|x| to_double(&x));
        if !self.has(DAMPING) || whole.iter().any(|x| x.abs() > LARGEST_WHOLE) {
            return self;
        }
        Self { whole, ..self }
    }

    /// Whether the force jumps at the surface of the wall: there virtual damping or a filter sets in.
    pub(crate) const fn jumps_at_surface(&self) -> bool {
        self.has(UNILATERAL) && self.has(DAMPING | FILTER)
    }

    /// Whether the force of a position that no encoder measures jumps somewhere all the same.
    pub(crate) const fn jumps(&self) -> bool {
        !self.has(ENCODER) && (self.has(FORCE_STEP) || self.jumps_at_surface())
    }

    /// Whether rounding may lead a sample to another force altogether: over an edge of the encoder or a jump.
    pub(crate) const fn has_edges(&self) -> bool {
        self.has(ENCODER) || self.jumps()
    }

    /// What its samples may be within rounding of, in words; nothing where the force follows the position.
    pub(crate) fn edge_words(&self) -> String {
        let measured = self.has(ENCODER);
        let edges = [
            (measured, "an encoder edge"),
            (
                !measured && self.jumps_at_surface(),
                "the surface of the wall",
            ),
            (
                self.has(FORCE_STEP) && (!measured || self.lingers()),
                "the middle between two steps of the D/A converter",
            ),
        ];
        let words = edges.iter().filter(|(there, _)| *there);
        words
            .map(|(_, words)| *words)
            .collect::<Vec<_>>()
            .join(" or ")
    }

    /// How far a sample that no encoder measures is from where the force jumps: from the surface of the wall, and
    /// from the middle between two steps of the D/A converter; in ticks, less what the law itself rounds.
    ///
    /// `force` is that of the wall on both sides, and `reach` the greatest |q| so far.
    #[inline(always)]
    pub(crate) fn off_jump(&self, q: f64, force: f64, reach: f64) -> f64 {
        let mut off = f64::INFINITY;
        if self.jumps_at_surface() {
            let follows = FOLLOWS * reach;
            // What jumps by less is no other force.
            if force.abs() > follows * self.amplified {
                off = q.abs() - follows;
            }
        }
        // Outside a one-sided wall the force is 0, in the middle of a step.
        if self.has(FORCE_STEP) && !(self.has(UNILATERAL) && q < 0.0) {
            let [numerator, denominator] = self.force_step;
            let step = numerator / denominator;
            let from_middle = step * off_edge(0.5 - force * denominator / numerator);
            let rounded = EACH * ((1.0 + self.rounding) * reach + step);
            let ticks = (from_middle - rounded) / self.amplified;
            // Of a filter that keeps its roundings for ever nothing is known.
            off = off.min(if ticks.is_nan() { -1.0 } else { ticks });
        }
        off
    }
}
