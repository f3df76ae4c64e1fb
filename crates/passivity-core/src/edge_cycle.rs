//! The most that an operator can draw by moving to and fro across one edge between two ticks: the
//! least Coulomb friction that a controller needs (the converse of TH-LTI).
//!
//! Let the device sit at n − a or at n, a small: what is measured is ε = −½ or +½ beside the edge. A
//! move draws a·(ε′ − ε)·u, where the held force u = −Σ cⱼεₕ₋ⱼ depends on the sides at the last
//! samples, and costs σa and βa². Waiting costs nothing. So below the largest mean of (ε′ − ε)·u a move,
//! over all cycles of sides, any σ is too little: s*. It is a cycle of largest ratio in a finite graph
//! whose nodes are the sides at the last samples. s* ≤ ½‖c‖₁, the σ that is always enough.

use alloc::vec;
use alloc::vec::Vec;

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;

use crate::dissipation::Friction;
use crate::periodic::Motion;
use crate::scalar::{Ordered as _, Scalar};

/// The most coefficients of a response that a cycle is looked for with: 2¹⁰ nodes.
pub const MOST_TAPS: usize = 10;

/// The best pattern of sides across one edge.
///
/// # Example
///
/// For the plain wall it is up and down, and draws the whole ½.
///
/// ```
/// use passivity_core::{BigRational, Scalar, edge_cycle::EdgeCycle};
///
/// let best = EdgeCycle::of(&[BigRational::integer(1)]).unwrap();
/// assert_eq!(best.coulomb, BigRational::integer(1).half());
/// assert_eq!(best.above.iter().filter(|above| **above).count(), 1);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeCycle {
    /// s*, what a move draws on average over the distance: below it σ is too little, in KΔ.
    pub coulomb: BigRational,
    /// Whether the device is above the edge, sample by sample, over one period; empty where no
    /// pattern draws anything.
    pub above: Vec<bool>,
}

/// Sides at the last samples as bits, the latest the lowest.
type Sides = usize;

/// What a step of the walk draws and whether it is a move, at a common scale.
struct Graph {
    /// 2·scale·u for each node.
    forces: Vec<BigInt>,
    scale: BigInt,
    taps: usize,
}

impl EdgeCycle {
    /// The best cycle for a response c₀, c₁, …, the delay included.
    ///
    /// Each better cycle raises the ratio until there is none, which is found when the largest gains
    /// of walks, at this ratio, stop growing: they are then potentials that no cycle can beat.
    ///
    /// `None` with more than [`MOST_TAPS`] coefficients.
    #[must_use]
    pub fn of(response: &[BigRational]) -> Option<Self> {
        if response.len() > MOST_TAPS {
            return None;
        }
        let graph = Graph::of(response);
        let mut best = Self {
            coulomb: BigRational::zero(),
            above: Vec::new(),
        };
        while let Some(cycle) = graph.better_than(&best.coulomb) {
            let [drawn, moves] = graph.account(&cycle);
            let coulomb = BigRational::new(drawn, &graph.scale * moves);
            if coulomb.compare(&best.coulomb) != Some(core::cmp::Ordering::Greater) {
                return None;
            }
            let above = cycle.iter().map(|sides| sides & 1 == 1).collect();
            best = Self { coulomb, above };
        }
        Some(best)
    }

    /// The motion across the edge at 1 that gains energy where σ < s*, its gain computed from the
    /// forces that `held` gives for a period of positions; `None` where σ ≥ s*, or the gain is not
    /// above zero after all.
    ///
    /// A move of a gains (s* − σ)a − βa² on average: a is half of (s* − σ)/β or less, and at most
    /// the largest that stays below `speed_bound` (ticks per sample).
    #[must_use]
    pub fn motion(
        &self,
        held: impl Fn(&[BigRational]) -> Option<Vec<BigRational>>,
        friction: &Friction<BigRational>,
        speed_bound: Option<&BigRational>,
    ) -> Option<Motion<BigRational>> {
        let one = BigRational::one();
        let over = &self.coulomb - &friction.sigma;
        if !over.is_positive()? {
            return None;
        }
        let mut most = one.clone();
        if friction.beta.is_positive()? {
            most = Scalar::min(most, (over / &friction.beta).half());
        }
        if let Some(bound) = speed_bound {
            if !bound.is_positive()? {
                return None;
            }
            // Strictly below the bound.
            most = Scalar::min(most, bound.clone().half());
        }
        // A unit fraction, at least half of it: readable.
        let a = one.clone() / most.recip().ceil();
        let below = &one - a;
        let sides = self.above.iter();
        let positions: Vec<BigRational> = sides
            .map(|above| if *above { one.clone() } else { below.clone() })
            .collect();
        Motion::below(speed_bound, positions, held, friction)?.that_draws()
    }
}

impl Graph {
    fn of(response: &[BigRational]) -> Self {
        let denominators = response.iter().map(BigRational::denom);
        let common = denominators.fold(BigInt::from(1), |common, d| common.lcm(d));
        let whole: Vec<BigInt> = response
            .iter()
            .map(|c| c.numer() * (&common / c.denom()))
            .collect();
        let force = |sides: Sides| {
            let bits = whole.iter().zip(0_u32..);
            bits.fold(BigInt::ZERO, |force, (c, j)| {
                if sides >> j & 1 == 1 {
                    force - c
                } else {
                    force + c
                }
            })
        };
        // One bit at least, so that a node knows on which side the device is.
        let taps = response.len().max(1);
        Self {
            forces: (0..1 << taps).map(force).collect(),
            scale: common * 2,
            taps,
        }
    }

    /// The nodes from which one comes to a node by one sample.
    fn before(&self, node: Sides) -> [Sides; 2] {
        let oldest = 1 << (self.taps - 1);
        [node >> 1, node >> 1 | oldest]
    }

    /// What a step draws, times the scale, and the distance moved, 0 or 1.
    fn step(&self, from: Sides, to: Sides) -> Option<[BigInt; 2]> {
        let force = self.forces.get(from)?;
        Some(match (from & 1, to & 1) {
            (0, 1) => [force.clone(), BigInt::from(1)],
            (1, 0) => [-force, BigInt::from(1)],
            _ => [BigInt::ZERO, BigInt::ZERO],
        })
    }

    /// What a cycle draws, times the scale, and how many moves it has.
    fn account(&self, cycle: &[Sides]) -> [BigInt; 2] {
        let next = cycle.iter().skip(1).chain(cycle.first());
        let steps = cycle
            .iter()
            .zip(next)
            .filter_map(|(from, to)| self.step(*from, *to));
        steps.fold([BigInt::ZERO, BigInt::ZERO], |[drawn, moves], [d, m]| {
            [drawn + d, moves + m]
        })
    }

    /// A cycle that draws more than `ratio` a move, or `None` when there is none.
    fn better_than(&self, ratio: &BigRational) -> Option<Vec<Sides>> {
        let per_move = ratio.numer() * &self.scale;
        let nodes = self.forces.len();
        let mut gains = vec![BigInt::ZERO; nodes];
        let mut from: Vec<Option<Sides>> = vec![None; nodes];
        // A walk longer than there are nodes has a cycle in it, so it ends.
        for _ in 0..=nodes {
            let mut grown = gains.clone();
            let mut changed = false;
            for (node, (gain, parent)) in grown.iter_mut().zip(&mut from).enumerate() {
                for before in self.before(node) {
                    let (Some([drawn, moves]), Some(so_far)) =
                        (self.step(before, node), gains.get(before))
                    else {
                        continue;
                    };
                    let walk = so_far + drawn * ratio.denom() - moves * &per_move;
                    if walk > *gain {
                        *gain = walk;
                        *parent = Some(before);
                        changed = true;
                    }
                }
            }
            if !changed {
                return None;
            }
            gains = grown;
            let cycles = cycles(&from).into_iter();
            let better = |cycle: &Vec<Sides>| {
                let [drawn, moves] = self.account(cycle);
                drawn * ratio.denom() > moves * &per_move
            };
            if let Some(cycle) = cycles.into_iter().find(better) {
                return Some(cycle);
            }
        }
        None
    }
}

/// The cycles among the parents, each in the order of time.
fn cycles(from: &[Option<Sides>]) -> Vec<Vec<Sides>> {
    let mut seen: Vec<Option<usize>> = vec![None; from.len()];
    let mut found = Vec::new();
    for start in 0..from.len() {
        let mut node = Some(start);
        let mut path = Vec::new();
        while let Some(at) = node {
            match seen.get_mut(at) {
                Some(mark @ None) => *mark = Some(start),
                Some(Some(by)) if *by == start => {
                    let since = path.iter().position(|on| *on == at).unwrap_or(path.len());
                    let mut cycle: Vec<Sides> = path.split_off(since);
                    cycle.reverse();
                    found.push(cycle);
                    break;
                }
                _ => break,
            }
            path.push(at);
            node = from.get(at).copied().flatten();
        }
    }
    found
}
