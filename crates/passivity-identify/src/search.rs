//! Branch and prune: which parameters can have produced the logs (TH-IDENT).
//!
//! A part of the parameters is thrown away only where it is refuted: where the motions ahead of and behind
//! all of its motions leave no place for the device to have started from. What is left, and so the box
//! around it, surely holds the parameters of the device, if it is one of this model.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::directed::{add, add_down, div};
use crate::kept::Propagators;
use crate::log::Log;
use crate::motion::{Bundle, lead};
use crate::region::{Ends, Part, Shear};

/// Where in the logs a part of the parameters is refuted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place {
    /// Which log, from 0.
    pub(crate) log: usize,
    /// Which sample of it, from 0.
    pub(crate) sample: usize,
}

/// What a search has found.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    /// The parts that are left.
    pub(crate) parts: Vec<Part>,
    /// The box around them, in b, c and m; `None` where nothing is left.
    pub(crate) hull: Option<[Ends; 3]>,
    /// By which place of the logs the last part was refuted, where nothing is left.
    pub(crate) refuted_by: Option<Place>,
    /// Parameters that fit, where any were looked at.
    pub(crate) fits: Option<[f64; 3]>,
    /// Whether the work came to its bound before the box was as narrow as asked for.
    pub(crate) stopped_early: bool,
}

/// What refutes parameters: the logs, and how many intervals of motion that took.
pub(crate) struct Judge<'a> {
    logs: Vec<Kept<'a>>,
    steps: u64,
}

impl<'a> Judge<'a> {
    pub(crate) fn new(logs: &'a [Log]) -> Self {
        let kept = |log| Kept {
            log,
            propagators: Propagators::default(),
        };
        Self {
            logs: logs.iter().map(kept).collect(),
            steps: 0,
        }
    }

    /// Where the logs refute a bundle.
    pub(crate) fn refuted(&mut self, bundle: &Bundle) -> Option<Place> {
        let steps = &mut self.steps;
        let mut all = (0..).zip(&mut self.logs);
        all.find_map(|(log, kept)| {
            let sample = kept.refute(bundle, steps)?;
            Some(Place { log, sample })
        })
    }

    /// Whether the logs do not refute the parameters b, c and m.
    pub(crate) fn lets(&mut self, at: [f64; 3]) -> bool {
        self.refuted(&Bundle::point(at)).is_none()
    }
}

/// A log and what is kept for its motions.
struct Kept<'a> {
    log: &'a Log,
    propagators: Propagators,
}

impl Kept<'_> {
    /// Refutes a bundle of parameters: the first sample at which no start is left, or `None`. Adds to `steps`
    /// how many intervals of motion that took.
    fn refute(&mut self, bundle: &Bundle, steps: &mut u64) -> Option<usize> {
        let log = self.log;
        let mut start = *log.positions.first()?;
        let mut later = (1..).zip(log.positions.iter().skip(1));
        let mut refuted = None;
        lead(log, bundle, &mut self.propagators, |[ahead, behind]| {
            *steps += 2;
            let Some((sample, [lo, hi])) = later.next() else {
                return false;
            };
            // A way that is no number leaves the start as it is: `max` and `min` pass it over.
            start = [
                start[0].max(add_down(*lo, -ahead)),
                start[1].min(add(*hi, behind)),
            ];
            if start[0] > start[1] {
                refuted = Some(sample);
            }
            refuted.is_none()
        });
        refuted
    }
}

/// The parameters that are not ruled out by how far the device surely moved: all that a search needs to
/// look at. `None` for a parameter that nothing bounds.
///
/// From rest m|v| + b∫|v| + ∫c ≤ ∫|u| over the time of motion. So it moved only if c is below the largest
/// force, b·way ≤ ∫|u|, and m·way ≤ ∬|u|.
pub(crate) fn first_bounds(logs: &[Log]) -> [Option<f64>; 3] {
    let moved = logs.iter().filter(|log| log.sure_way() > 0.0);
    let bounds = moved.map(|log| {
        let (way, [once, twice]) = (log.sure_way(), log.impulses());
        [div(once, way), log.largest_force(), div(twice, way)]
    });
    let least = |a: [f64; 3], b: [f64; 3]| [a[0].min(b[0]), a[1].min(b[1]), a[2].min(b[2])];
    match bounds.reduce(least) {
        Some(bounds) => bounds.map(Some),
        None => [None; 3],
    }
}

/// How the search is done.
pub(crate) struct Task<'a> {
    pub(crate) logs: &'a [Log],
    pub(crate) shear: Shear,
    /// How much a change of each coordinate by 1 counts. Only the order of the search depends on it.
    pub(crate) weights: [f64; 3],
    /// The most that b and c can be.
    pub(crate) most: [f64; 2],
    /// Parameters that are likely to fit.
    pub(crate) near: [f64; 3],
    /// How many intervals of motion are computed at the most.
    pub(crate) effort: u64,
}

/// A face of the box is done when parameters are known that fit and lie as near to it as this share of the
/// box's width.
const SHARE: f64 = 0.03;

/// Parts narrower than this, relative to their values, are not split.
const NARROWEST: f64 = 1e-12;

/// The faces of a box: a parameter, and whether it is at its most.
const FACES: [(usize, bool); 6] = [
    (0, false),
    (0, true),
    (1, false),
    (1, true),
    (2, false),
    (2, true),
];

/// A part that is left, and what it reaches over in b, c and m.
#[derive(Clone, Copy, Debug)]
struct Left {
    part: Part,
    extent: [Ends; 3],
}

/// The parts that are left, found by how far they reach in each direction.
struct Parts {
    /// By number; `None` for those that were split.
    all: Vec<Option<Left>>,
    /// For each face the numbers of parts, the one that reaches the farthest on top.
    reaching: [BinaryHeap<(Reach, usize)>; 6],
}

/// How far a part reaches in the direction of a face: a number that can be sorted.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Reach(f64);

impl Eq for Reach {}

impl Ord for Reach {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl PartialOrd for Reach {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Parts {
    fn new() -> Self {
        Self {
            all: Vec::new(),
            reaching: Default::default(),
        }
    }

    fn add(&mut self, left: Left) {
        let number = self.all.len();
        for (heap, (dimension, is_most)) in self.reaching.iter_mut().zip(FACES) {
            let [lo, hi] = along(&left.extent, dimension);
            heap.push((Reach(if is_most { hi } else { -lo }), number));
        }
        self.all.push(Some(left));
    }

    /// The part that reaches the farthest towards a face.
    fn outermost(&mut self, face: usize) -> Option<(usize, Left)> {
        let heap = self.reaching.get_mut(face)?;
        loop {
            let (_, number) = *heap.peek()?;
            if let Some(Some(left)) = self.all.get(number) {
                return Some((number, *left));
            }
            heap.pop();
        }
    }

    /// The box around all parts.
    fn hull(&mut self) -> Option<[Ends; 3]> {
        let mut hull = [[0.0; 2]; 3];
        for (face, (dimension, is_most)) in FACES.into_iter().enumerate() {
            let (_, left) = self.outermost(face)?;
            let [lo, hi] = along(&left.extent, dimension);
            if let Some(ends) = hull.get_mut(dimension) {
                match is_most {
                    true => ends[1] = hi,
                    false => ends[0] = lo,
                }
            }
        }
        Some(hull)
    }
}

fn along(extent: &[Ends; 3], dimension: usize) -> Ends {
    extent.get(dimension).copied().unwrap_or_default()
}

/// A search that is going on.
struct Search<'a> {
    task: &'a Task<'a>,
    judge: Judge<'a>,
    parts: Parts,
    last: Option<Place>,
    /// How far towards each face parameters are known that fit, and the last of them.
    reached: [f64; 6],
    fits: Option<[f64; 3]>,
}

impl Search<'_> {
    /// Keeps a part, unless it is refuted or holds nothing that a device can be.
    fn keep(&mut self, part: Part) {
        let shear = &self.task.shear;
        let Some(extent) = shear.extent(&part) else {
            return;
        };
        let too_much = extent.iter().zip(self.task.most);
        if too_much.into_iter().any(|([lo, _], most)| *lo > most) {
            return;
        }
        match self.judge.refuted(&Bundle::new(shear.corners(&part))) {
            None => self.parts.add(Left { part, extent }),
            place => self.last = self.last.max(place),
        }
    }

    /// Notes parameters that fit, where they do.
    fn look_at(&mut self, at: [f64; 3]) {
        if self.judge.lets(at) {
            self.fits = Some(at);
            for (reached, (dimension, is_most)) in self.reached.iter_mut().zip(FACES) {
                let value = at.get(dimension).copied().unwrap_or(f64::NAN);
                *reached = reached.max(if is_most { value } else { -value });
            }
        }
    }

    /// Whether a face is as far out as it must be.
    fn is_done(&mut self, face: usize, left: &Left) -> bool {
        let (Some((dimension, is_most)), Some(hull)) = (FACES.get(face), self.parts.hull()) else {
            return true;
        };
        let [least, most] = along(&hull, *dimension);
        if is_narrow([least, most]) || left.part.ends.iter().all(|ends| is_narrow(*ends)) {
            return true;
        }
        self.look_at(self.task.shear.middle(&left.part));
        let reached = self.reached.get(face).copied().unwrap_or(f64::NEG_INFINITY);
        let face = if *is_most { most } else { -least };
        face - reached <= SHARE * (most - least)
    }
}

impl Task<'_> {
    /// Searches parts; `progress` is told how much of the effort is spent, and ends the search where it says
    /// `false`.
    pub(crate) fn search(&self, parts: Vec<Part>, mut progress: impl FnMut(u64) -> bool) -> Found {
        let mut search = Search {
            task: self,
            judge: Judge::new(self.logs),
            parts: Parts::new(),
            last: None,
            reached: [f64::NEG_INFINITY; 6],
            fits: None,
        };
        search.look_at(self.near);
        for part in parts {
            search.keep(part);
        }
        let mut done = [false; FACES.len()];
        let mut stopped_early = false;
        // Face by face, until each is done or the effort is spent.
        for face in (0..FACES.len()).cycle() {
            if done.iter().all(|done| *done) {
                break;
            }
            if done.get(face) == Some(&true) {
                continue;
            }
            let Some((number, left)) = search.parts.outermost(face) else {
                break;
            };
            if search.is_done(face, &left) {
                if let Some(done) = done.get_mut(face) {
                    *done = true;
                }
                continue;
            }
            if search.judge.steps >= self.effort {
                stopped_early = true;
                break;
            }
            if let Some(slot) = search.parts.all.get_mut(number) {
                *slot = None;
            }
            for half in left.part.halves(self.widest(&left.part)) {
                search.keep(half);
            }
            if !progress(search.judge.steps.min(self.effort)) {
                stopped_early = true;
                break;
            }
        }
        let hull = search.parts.hull();
        let left = search.parts.all.into_iter().flatten();
        Found {
            refuted_by: search.last.filter(|_| hull.is_none()),
            parts: left.map(|left| left.part).collect(),
            hull,
            fits: search.fits,
            stopped_early,
        }
    }

    /// The coordinate whose interval matters most.
    fn widest(&self, part: &Part) -> usize {
        let weighted =
            part.ends
                .iter()
                .zip(self.weights)
                .map(|([lo, hi], weight)| match is_narrow([*lo, *hi]) {
                    true => 0.0,
                    false => (hi - lo) * weight,
                });
        let widest = (0..).zip(weighted).max_by(|a, b| a.1.total_cmp(&b.1));
        widest.map_or(0, |(coordinate, _)| coordinate)
    }
}

fn is_narrow([lo, hi]: Ends) -> bool {
    hi - lo <= NARROWEST * lo.abs().max(hi.abs())
}
