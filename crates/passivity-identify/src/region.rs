//! Parts of the parameters, in coordinates in which they are searched.
//!
//! With p = b/m, q = c/m and r = 1/m the acceleration u·r − p·v − q·sgn(v) is linear in the parameters. The
//! search cuts in sheared coordinates, in which what fits is about as long as it is wide:
//!
//! ```text
//! t₁ = q + α·p + γ·r,   t₂ = p + δ·r,   t₃ = r
//! ```
//!
//! A part is a box in t, whose corners are found back by substitution, each enclosed. Which shear it is
//! decides how long a search takes, not what it finds.

use crate::directed::{add, add_down, div, mul, mul_down};

/// A number between two doubles.
pub(crate) type Ends = [f64; 2];

/// Where viscous friction stands among the parameters.
pub(crate) const VISCOUS: usize = 0;
/// Where Coulomb friction does.
pub(crate) const COULOMB: usize = 1;
/// Where the inertia does.
pub(crate) const INERTIA: usize = 2;

/// a + b.
pub(crate) fn sum(a: Ends, b: Ends) -> Ends {
    [add_down(a[0], b[0]), add(a[1], b[1])]
}

/// factor·x.
pub(crate) fn times(factor: f64, [lo, hi]: Ends) -> Ends {
    match factor >= 0.0 {
        true => [mul_down(factor, lo), mul(factor, hi)],
        false => [mul_down(factor, hi), mul(factor, lo)],
    }
}

/// p, q and r, each between its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Corner {
    pub(crate) viscous: Ends,
    pub(crate) coulomb: Ends,
    pub(crate) mobility: Ends,
}

impl Corner {
    /// The parameters b, c, m.
    pub(crate) fn at([viscous, coulomb, inertia]: [f64; 3]) -> Self {
        let over = |x: f64| {
            let near = x / inertia;
            match x == 0.0 {
                true => [0.0; 2],
                false => [near.next_down(), near.next_up()],
            }
        };
        Self {
            viscous: over(viscous),
            coulomb: over(coulomb),
            mobility: over(1.0),
        }
    }
}

/// The shear of the coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Shear {
    /// α, of p in t₁.
    pub(crate) viscous_in_coulomb: f64,
    /// γ, of r in t₁.
    pub(crate) mobility_in_coulomb: f64,
    /// δ, of r in t₂.
    pub(crate) mobility_in_viscous: f64,
}

/// A box in t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Part {
    pub(crate) ends: [Ends; 3],
}

impl Shear {
    /// The box in t around p, q and r that lie between ends.
    pub(crate) fn around(&self, all: &Corner) -> Part {
        let viscous = sum(all.viscous, times(self.mobility_in_viscous, all.mobility));
        let coulomb = sum(
            all.coulomb,
            sum(
                times(self.viscous_in_coulomb, all.viscous),
                times(self.mobility_in_coulomb, all.mobility),
            ),
        );
        Part {
            ends: [coulomb, viscous, all.mobility],
        }
    }

    /// What a place t stands for, enclosed.
    pub(crate) fn corner(&self, [t1, t2, t3]: [f64; 3]) -> Corner {
        let mobility = [t3, t3];
        let viscous = sum([t2, t2], times(-self.mobility_in_viscous, mobility));
        let coulomb = sum(
            [t1, t1],
            sum(
                times(-self.viscous_in_coulomb, viscous),
                times(-self.mobility_in_coulomb, mobility),
            ),
        );
        Corner {
            viscous,
            coulomb,
            mobility,
        }
    }

    /// The corners of a part: their hull holds it, as the substitution is affine.
    pub(crate) fn corners(&self, part: &Part) -> Vec<Corner> {
        let [first, second, third] = part.ends.map(|[lo, hi]| match lo == hi {
            true => vec![lo],
            false => vec![lo, hi],
        });
        let mut corners = Vec::with_capacity(8);
        for t1 in &first {
            for t2 in &second {
                corners.extend(third.iter().map(|t3| self.corner([*t1, *t2, *t3])));
            }
        }
        corners
    }

    /// b, c and m over a part, as far as they are not below zero; `None` for a part without such.
    ///
    /// p/r and q/r take their extremes at corners, as r is above zero.
    pub(crate) fn extent(&self, part: &Part) -> Option<[Ends; 3]> {
        let mut all = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for corner in self.corners(part) {
            let [r0, r1] = corner.mobility;
            let over = |[lo, hi]: Ends| {
                let least = if lo >= 0.0 { lo / r1 } else { lo / r0 };
                let most = if hi >= 0.0 { hi / r0 } else { hi / r1 };
                [least.next_down(), most.next_up()]
            };
            let values = [over(corner.viscous), over(corner.coulomb), over([1.0, 1.0])];
            for (all, [lo, hi]) in all.iter_mut().zip(values) {
                *all = [all[0].min(lo), all[1].max(hi)];
            }
        }
        let is_physical = all.iter().all(|[_, hi]| *hi >= 0.0);
        is_physical.then(|| all.map(|[lo, hi]| [lo.max(0.0), hi]))
    }

    /// b, c and m in the middle of a part, moved to zero where they are below.
    pub(crate) fn middle(&self, part: &Part) -> [f64; 3] {
        self.parameters(part.ends.map(|[lo, hi]| 0.5 * lo + 0.5 * hi))
    }

    /// The parameters b, c, m of one of the parts that are nearest to others, with a weight for each
    /// coordinate: these themselves where a part holds them.
    pub(crate) fn nearest(&self, parts: &[Part], weights: [f64; 3], at: [f64; 3]) -> [f64; 3] {
        let own = self.around(&Corner::at(at)).ends;
        let own = own.map(|[lo, hi]| 0.5 * lo + 0.5 * hi);
        let places = parts.iter().map(|part| {
            let mut place = own;
            let mut distance = 0.0;
            for ((t, [lo, hi]), weight) in place.iter_mut().zip(part.ends).zip(weights) {
                let moved = t.clamp(lo, hi);
                distance += ((moved - *t) * weight).powi(2);
                *t = moved;
            }
            (distance, place)
        });
        match places.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((distance, place)) if distance > 0.0 => self.parameters(place),
            _ => at,
        }
    }

    /// The parameters b, c and m that a place t stands for, moved to zero where they are below.
    fn parameters(&self, place: [f64; 3]) -> [f64; 3] {
        let at = self.corner(place);
        let [p, q, r] = [at.viscous, at.coulomb, at.mobility].map(|[lo, hi]| 0.5 * lo + 0.5 * hi);
        [(p / r).max(0.0), (q / r).max(0.0), 1.0 / r]
    }
}

impl Part {
    /// The two halves along a coordinate; they share their border.
    pub(crate) fn halves(&self, coordinate: usize) -> [Self; 2] {
        let along = |ends: Ends| {
            let mut half = *self;
            if let Some(own) = half.ends.get_mut(coordinate) {
                *own = ends;
            }
            half
        };
        let [lo, hi] = self.ends.get(coordinate).copied().unwrap_or_default();
        let middle = 0.5 * lo + 0.5 * hi;
        [along([lo, middle]), along([middle, hi])]
    }
}

/// Parts that hold all parameters up to the most, the inertia cut evenly over its decades.
pub(crate) fn parts(
    shear: &Shear,
    most: [f64; 2],
    [least, largest]: Ends,
    slabs: u32,
) -> Vec<Part> {
    let down = |x: f64| -div(-1.0, x);
    let ratio = (largest / least).powf(1.0 / f64::from(slabs));
    let mut parts = Vec::new();
    let mut upper = largest;
    for slab in 1..=slabs {
        let lower = match slab == slabs {
            true => least,
            false => (upper / ratio).max(least),
        };
        let mobility = [down(upper), div(1.0, lower)];
        let [viscous, coulomb] = most.map(|most| [0.0, mul(most, mobility[1])]);
        parts.push(shear.around(&Corner {
            viscous,
            coulomb,
            mobility,
        }));
        upper = lower;
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_holds_what_it_was_made_around() {
        let mut random = passivity_random::Random::new(4);
        for _ in 0..300 {
            let mut ends = || {
                let lo = random.between(0.0, 2.0);
                [lo, lo + random.between(0.0, 1.0)]
            };
            let all = Corner {
                viscous: ends(),
                coulomb: ends(),
                mobility: ends().map(|x| x + 0.1),
            };
            let shear = Shear {
                viscous_in_coulomb: random.between(-3.0, 3.0),
                mobility_in_coulomb: random.between(-3.0, 3.0),
                mobility_in_viscous: random.between(-3.0, 3.0),
            };
            let extent = shear.extent(&shear.around(&all)).unwrap();
            let [p, q, r] = [all.viscous, all.coulomb, all.mobility];
            for (i, j, k) in [(0, 0, 0), (1, 0, 1), (0, 1, 1), (1, 1, 0)] {
                let known = [p[i] / r[k], q[j] / r[k], 1.0 / r[k]];
                for ([lo, hi], known) in extent.into_iter().zip(known) {
                    assert!(lo <= known && known <= hi);
                }
            }
        }
    }
}
