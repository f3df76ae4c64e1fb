//! Propagators of the linear motion between reversals, in doubles: what the motion over a fixed time
//! makes of any state, computed once for a scene.
//!
//! With v = ξ̇, the net force p = y + F − kξ − σs and the amplifier's excess e = u − y the motion is
//!
//! > Mv̇ = p − β′v, ṗ = κe − kv, ė = −κe:
//!
//! linear and the same at every time, so that its solution over a time is a matrix. The matrix of a
//! short time is summed from the power series, those of longer ones are products of it. Each is kept
//! as what it *adds* to the state, so that a hundred products leave it good to a few ulp of that.
//! [`Table`] has them for every 1/N of an interval: a motion over any time is one of them and a power
//! series over at most half of that, to or fro: [`turn`](super::turn).
#![expect(
    clippy::indexing_slicing,
    reason = "every index is a constant below the length of a fixed array"
)]

use super::short::{INVERSE, Inner, Rates, dot};
use crate::number::MAGIC;

/// The most cells of an interval; faster motions than that have no table.
const MOST_CELLS: u32 = 8192;

/// The fewest: so that the series about a node are short ones where all is slow.
const LEAST_CELLS: u32 = 256;

/// Cells within the time in which the fastest part of the motion changes by a factor e: see
/// [`turn`](super::turn).
const CELLS_A_RATE: f64 = 64.0;

/// What a time of motion makes of v, p and e.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Map {
    /// The way, as it depends on v, p and e.
    pub(super) way: Inner,
    /// The velocity at the end.
    pub(super) velocity: Inner,
    /// The excess at the end, for an excess of 1.
    pub(super) excess: f64,
}

impl Map {
    /// The whole matrix: v, p and e at the end for v, p and e at the start.
    fn matrix(&self, rates: &Rates) -> [Inner; 3] {
        let [v, p, e] = self.way.map(|way| -rates.stiffness * way);
        [
            self.velocity,
            [v, 1.0 + p, (1.0 - self.excess) + e],
            [0.0, 0.0, self.excess],
        ]
    }
}

/// ∫v² and ∫ev over a time, as they depend on v, p and e at its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Energies {
    /// ∫v² is a quadratic form with this symmetric matrix.
    square: [Inner; 3],
    /// ∫ev is e times this product.
    lagging: Inner,
}

impl Energies {
    const NOTHING: Self = Self {
        square: [[0.0; 3]; 3],
        lagging: [0.0; 3],
    };

    /// Over the time `h`, by the power series.
    fn over(rates: &Rates, h: f64) -> Self {
        let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let all = units.map(|unit| rates.series(&unit));
        let [.., e] = &all;
        Self {
            square: all
                .each_ref()
                .map(|a| all.each_ref().map(|b| a.square_with(b, h))),
            lagging: all.each_ref().map(|velocity| e.lagging_with(velocity, h)),
        }
    }

    /// Over the time of this one, which leads from state to state by `matrix`, and then over the next.
    fn then(&self, next: &Self, matrix: &[Inner; 3]) -> Self {
        let column = |j: usize| [matrix[0][j], matrix[1][j], matrix[2][j]];
        let mut both = *self;
        for i in 0..3 {
            let led = [0, 1, 2].map(|row: usize| dot(&next.square[row], &column(i)));
            for j in 0..3 {
                both.square[i][j] += dot(&column(j), &led);
            }
            both.lagging[i] += matrix[2][2] * dot(&next.lagging, &column(i));
        }
        both
    }

    /// ∫v² and ∫ev from a state.
    #[inline(always)]
    pub(super) fn of(&self, inner: &Inner) -> [f64; 2] {
        let [.., e] = *inner;
        let led = [0, 1, 2].map(|row: usize| dot(&self.square[row], inner));
        [dot(inner, &led), e * dot(&self.lagging, inner)]
    }
}

/// A map less the identity: what it adds to v and e, and the way.
#[derive(Clone, Copy)]
struct Added {
    way: Inner,
    velocity: Inner,
    excess: f64,
}

impl Added {
    const NOTHING: Self = Self {
        way: [0.0; 3],
        velocity: [0.0; 3],
        excess: 0.0,
    };

    /// Over the time `h`, by the power series.
    fn over(rates: &Rates, h: f64) -> Self {
        let mut added = Self::NOTHING;
        for column in 0..3 {
            let mut unit = [0.0; 3];
            unit[column] = 1.0;
            let [way, velocity, excess] = rates.series(&unit).added_alone(h);
            added.way[column] = way;
            added.velocity[column] = velocity;
            if column == 2 {
                added.excess = excess;
            }
        }
        added
    }

    /// First this, then `next`.
    fn then(&self, next: &Self, rates: &Rates) -> Self {
        let mut both = Self::NOTHING;
        for column in 0..3 {
            // What the first adds to v, p and e; p rises as e falls and sinks with the way.
            let excess = if column == 2 { self.excess } else { 0.0 };
            let changed = [
                self.velocity[column],
                -excess - rates.stiffness * self.way[column],
                excess,
            ];
            both.way[column] = self.way[column] + (next.way[column] + dot(&next.way, &changed));
            both.velocity[column] =
                self.velocity[column] + (next.velocity[column] + dot(&next.velocity, &changed));
        }
        both.excess = self.excess + next.excess + self.excess * next.excess;
        both
    }

    fn map(&self) -> Map {
        let [v, p, e] = self.velocity;
        Map {
            way: self.way,
            velocity: [1.0 + v, p, e],
            excess: 1.0 + self.excess,
        }
    }
}

/// The maps over 0, 1/N, 2/N, … and 1.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Table {
    /// N + 1 of them, or that over 1 alone when N would be too many.
    maps: Vec<Map>,
    /// 1/N.
    pub(super) cell: f64,
    /// N.
    scale: f64,
    /// The energies over the same times, when they are wanted.
    energies: Vec<Energies>,
}

impl Table {
    /// The table of a motion whose largest rate is `fastest`.
    pub(super) fn new(rates: &Rates, fastest: f64) -> Self {
        // At most 64·FASTEST: far within 32 bits.
        let cells = ((CELLS_A_RATE * fastest).ceil() as u32)
            .max(LEAST_CELLS)
            .next_power_of_two();
        let cell = 1.0 / f64::from(cells);
        let mut doubled = Added::over(rates, cell);
        let mut added = vec![Added::NOTHING, doubled];
        let kept = cells <= MOST_CELLS;
        let mut count = 1;
        while count < cells {
            let twice = doubled.then(&doubled, rates);
            if kept {
                let between: Vec<Added> = added
                    .iter()
                    .skip(1)
                    .map(|rest| doubled.then(rest, rates))
                    .collect();
                added.extend(between);
            }
            doubled = twice;
            count *= 2;
        }
        let maps = if kept {
            added.iter().map(Added::map).collect()
        } else {
            vec![doubled.map()]
        };
        Self {
            maps,
            cell,
            scale: f64::from(cells),
            energies: Vec::new(),
        }
    }

    /// ⅛ of the most that |v̈| can be within an interval, for each unit of |v|, |p| and |e| at its start.
    ///
    /// Within a cell v̈ is a row r times e^(At) times the state at the cell's start, A being the matrix
    /// of the motion, and no entry of e^(At) is above that of the exponential of A's magnitudes.
    pub(super) fn sag(&self, rates: &Rates) -> Inner {
        if self.cells() == 0 {
            return [f64::INFINITY; 3];
        }
        let damped = rates.damping * rates.inverse_mass;
        let mut term = [rates.stiffness + damped * rates.damping, damped, rates.rate]
            .map(|x| 0.125 * rates.inverse_mass * x);
        let mut row = term;
        for over in &INVERSE[1..] {
            let [v, p, e] = term;
            term = [
                v * damped + p * rates.stiffness,
                v * rates.inverse_mass,
                (p + e) * rates.rate,
            ]
            .map(|x| x * self.cell * over);
            for (sum, term) in row.iter_mut().zip(term) {
                *sum += term;
            }
        }
        let mut most = [0.0_f64; 3];
        for map in &self.maps {
            let matrix = map.matrix(rates);
            for (column, most) in most.iter_mut().enumerate() {
                let column = [0, 1, 2].map(|i: usize| matrix[i][column].abs());
                *most = most.max(dot(&row, &column));
            }
        }
        // Against rounding and what the exponential's series leaves out.
        most.map(|x| x * (1.0 + 1e-9))
    }

    /// Computes the energies over every time of the table.
    pub(super) fn add_energies(&mut self, rates: &Rates) {
        let mut energies = vec![Energies::NOTHING];
        let cells = self.cells();
        if cells == 0 {
            // Over 1 alone, from its cell by doubling.
            let (mut map, mut energy) = (
                Added::over(rates, self.cell),
                Energies::over(rates, self.cell),
            );
            let mut width = self.cell;
            while width < 1.0 {
                energy = energy.then(&energy, &map.map().matrix(rates));
                map = map.then(&map, rates);
                width *= 2.0;
            }
            self.energies = vec![energy];
            return;
        }
        energies.push(Energies::over(rates, self.cell));
        while energies.len() <= cells {
            let count = energies.len() - 1;
            let matrix = self.maps[count].matrix(rates);
            let longest = energies[count];
            let further: Vec<_> = energies[1..]
                .iter()
                .map(|next| longest.then(next, &matrix))
                .collect();
            energies.extend(further);
        }
        self.energies = energies;
    }

    /// The energies over so many cells, once they have been computed.
    pub(super) fn energies(&self, cells: usize) -> &Energies {
        &self.energies[cells]
    }

    /// The energies over the whole interval.
    pub(super) fn whole_energies(&self) -> &Energies {
        &self.energies[self.energies.len() - 1]
    }

    /// N where there are maps of parts of an interval, else 0.
    #[inline(always)]
    pub(super) fn cells(&self) -> usize {
        self.maps.len() - 1
    }

    /// The map over what is left of an interval after so many cells.
    #[inline(always)]
    pub(super) fn map_before_end(&self, cells: usize) -> &Map {
        &self.maps[self.maps.len() - 1 - cells]
    }

    /// The map over so many cells; there is one for each up to N.
    #[inline(always)]
    pub(super) fn map(&self, cells: usize) -> &Map {
        &self.maps[cells]
    }

    /// The node that a time is nearest to; any number where it is none of an interval.
    #[inline(always)]
    pub(super) fn node(&self, time: f64) -> usize {
        // The last bits of the sum are those of the whole number.
        let rounded = time * self.scale + MAGIC;
        (rounded.to_bits() & 0xffff_ffff) as usize
    }

    /// The map over the whole interval.
    pub(super) fn whole(&self) -> Map {
        self.maps[self.maps.len() - 1]
    }
}
