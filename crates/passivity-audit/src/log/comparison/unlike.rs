//! Sums over the forces that are not those of the law: by these a wall that is moved is told from another stiffness. And how many
//! forces are those of the law but for half of their last digit: where all are, to the same side, it may be moved by so much.

use multiversion::multiversion;

use super::{ABSOLUTE, RELATIVE, differs};
use crate::ball::split;
use crate::log::exact::power;

/// What forces are rounded to multiples of, in KΔ, in two steps: sums of them are exact, and the same however rows are
/// grouped. What is left of squares of forces is a small difference of such sums.
const UPPER: i32 = 20;
const LOWER: i32 = 30;

/// Larger forces have no room in sums.
const LARGEST: f64 = (1_u64 << 26) as f64;

/// So many of them have room: 2^(26 + 20 + 12), and of what is left of each 2^(29 + 12).
const ROWS: usize = 1 << 12;

/// Forces at the scene's delay.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unlike {
    /// How many rows the law has a force in.
    pub(crate) acting: u64,
    /// How many are above those of the law by half of their last digit, and how many below.
    pub(crate) edges: [u64; 2],
    /// The forces, and those of the law, over the rows that are not alike, in 2⁻⁵⁰ KΔ; `None` where one has no
    /// room.
    pub(crate) sums: Option<[i128; 2]>,
}

impl Default for Unlike {
    fn default() -> Self {
        Self {
            acting: 0,
            edges: [0; 2],
            sums: Some([0; 2]),
        }
    }
}

impl Unlike {
    /// Adds some rows.
    pub(super) fn take(&mut self, forces: &[f64], law: &[f64], rounding: &[f64]) {
        let columns = forces.chunks(ROWS).zip(law.chunks(ROWS));
        for ((forces, law), rounding) in columns.zip(rounding.chunks(ROWS)) {
            let edges = edges(forces, law, rounding);
            let (acting, sums, has_room) = sums(forces, law, rounding);
            let both = |[upper, lower]: [i64; 2]| (i128::from(upper) << LOWER) + i128::from(lower);
            let sums = has_room.then(|| sums.map(both));
            self.append(Self {
                acting,
                edges,
                sums,
            });
        }
    }

    /// Goes on with other rows.
    pub(super) fn append(&mut self, other: Self) {
        self.acting += other.acting;
        for (own, other) in self.edges.iter_mut().zip(other.edges) {
            *own += other;
        }
        let both = self.sums.zip(other.sums);
        // There are not as many rows as to overflow.
        self.sums = both.map(|([a, b], [c, d])| [a.wrapping_add(c), b.wrapping_add(d)]);
    }

    /// Σ f and Σ p in KΔ.
    #[expect(clippy::cast_precision_loss, reason = "a fit is of doubles")]
    pub(super) fn values(&self) -> Option<[f64; 2]> {
        let unit = 1.0 / power(UPPER + LOWER);
        self.sums.map(|sums| sums.map(|sum| sum as f64 * unit))
    }
}

/// How many forces are half of their last digit above those of the law, and how many below.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn edges(forces: &[f64], law: &[f64], rounding: &[f64]) -> [u64; 2] {
    let mut found = [0_u64; 2];
    for ((force, law), rounding) in forces.iter().zip(law).zip(rounding) {
        // Of as many digits as a double has the last one is noise.
        let noise = RELATIVE * law.abs() + ABSOLUTE;
        let off = force - law;
        let is_half = (*rounding > 4.0 * noise) & ((off.abs() - rounding).abs() <= noise);
        found[0] = found[0].wrapping_add(u64::from(is_half & (off > 0.0)));
        found[1] = found[1].wrapping_add(u64::from(is_half & (off < 0.0)));
    }
    found
}

/// How many rows the law has a force in, the sums over those that are not alike, and whether all have room.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn sums(forces: &[f64], law: &[f64], rounding: &[f64]) -> (u64, [[i64; 2]; 2], bool) {
    let (mut acting, mut sums, mut large) = (0_u64, [[0_i64; 2]; 2], 0_u64);
    for ((force, law), rounding) in forces.iter().zip(law).zip(rounding) {
        let is_unlike = differs(*force, *law, *rounding);
        acting = acting.wrapping_add(u64::from(*law != 0.0));
        for (sums, x) in sums.iter_mut().zip([*force, *law]) {
            let (upper, rest) = split(if is_unlike { x * power(UPPER) } else { 0.0 });
            let (lower, _) = split(rest * power(LOWER));
            sums[0] = sums[0].wrapping_add(upper);
            sums[1] = sums[1].wrapping_add(lower);
        }
        let size = force.abs() + law.abs();
        large |= u64::from(size >= LARGEST) | u64::from(size.is_nan());
    }
    (acting, sums, large == 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_add_up_the_same_however_they_are_grouped() {
        let law: Vec<f64> = (0..10_000).map(|i| f64::from(i % 7) - 0.5).collect();
        let forces: Vec<f64> = law.iter().map(|p| p * 1.25 + 1e-3).collect();
        let rounding = vec![1e-6; law.len()];
        let mut whole = Unlike::default();
        whole.take(&forces, &law, &rounding);
        let mut parts = Unlike::default();
        for ((forces, law), rounding) in forces
            .chunks(333)
            .zip(law.chunks(333))
            .zip(rounding.chunks(333))
        {
            let mut part = Unlike::default();
            part.take(forces, law, rounding);
            parts.append(part);
        }
        assert_eq!(whole, parts);
        assert_eq!(whole.acting, 10_000);
        let values = whole.values().unwrap();
        for (value, column) in values.iter().zip([&forces, &law]) {
            // Each is rounded by half a unit at the most; the sum of doubles, below 2^16, by 10⁴ times 2⁻³⁸.
            let exact: f64 = column.iter().sum();
            assert!((value - exact).abs() <= 10_000.0 / power(51) + 1e-8);
        }
    }

    #[test]
    fn what_is_alike_or_has_no_room_is_left_out() {
        let sums = |force: f64, law: f64| {
            let mut sums = Unlike::default();
            sums.take(&[force], &[law], &[1e-6]);
            (sums.acting, sums.values())
        };
        assert_eq!(sums(2.5, 2.5), (1, Some([0.0; 2])));
        assert_eq!(sums(1.0, 0.0), (0, Some([1.0, 0.0])));
        assert_eq!(sums(1e9, 1.0), (1, None));
        assert_eq!(sums(f64::NAN, 1.0), (1, None));
    }
}
