//! The row of an interval whose positions, or whose force, are known only between two ends (TH-COUNTS).
//!
//! Every value here is one of the kernel's row, [`ledger::generated`] and [`ledger::row`], at some
//! pair of positions (ξ₀, ξ₁) in the rectangle that the trace leaves; what is ours is where to look, and
//! where that is, the kernel says ([`extremes`]).
//! Each position is within a tick, whose upper end belongs to it: with the force given, the row is
//! continuous there. So the extremes are exact:
//!
//! * What depends on the distance |d| alone rises with it.
//! * Generated energy is F·(ξ₁ − ξ₀) + V(ξ₁) − V(ξ₀): a function of ξ₁ less the same function of ξ₀.
//!   With V convex its least value is where V′ = −F, its largest at an end. The quantized potential is
//!   linear within a tick.
//! * Net energy also has βd²/Δτ + σ|d| in it. On a line of equal d it is monotone (its slope is
//!   V′(ξ₀) − V′(ξ₁), of one sign; constant for the quantized potential on a pair of ticks). So its
//!   extremes are on the edge of the rectangle, where generated energy is a parabola on each side of where the law
//!   is bent, known from three of its values, and net energy a parabola with a kink at d = 0.
//! * All of it is linear in F, so extreme at an end of the force.
//!
//! Where both positions are counts and the law is not bent there, all of that has a closed form ([`Crossings`]).

mod crossings;

use std::cmp::Ordering;

use passivity_core::extremes::{self, Parabola};
use passivity_core::ledger::{self, HeldInterval, Row};
use passivity_core::{Criterion, Friction, Interval, Loop, Ordered, Step, dissipation};

use crate::ends::Ends;
use crate::figure::Figure;
use crate::number::Written;
use crossings::Crossings;

/// A sampling interval as far as it is known.
pub(crate) struct Rectangle<'a, S> {
    pub(crate) ends: &'a Ends<S>,
    pub(crate) start: &'a Figure<S>,
    pub(crate) end: &'a Figure<S>,
    pub(crate) force: &'a Figure<S>,
    pub(crate) dtau: &'a S,
}

/// The two accounts of generated energy: against the wall's law, and against its quantized form.
type Accounts<S> = [S; 2];

impl<S: Written> Rectangle<'_, S> {
    /// The row without extra storage; `None` when a number is undefined.
    pub(crate) fn row(&self) -> Option<Row<Figure<S>>> {
        let ends = [self.start, self.end].map(|of| [of.lo(), of.hi()]);
        let [start, end] = ends;
        let (near, far) = (
            extremes::nearest(start, end)?,
            extremes::farthest(start, end)?,
        );
        let least = self.row_at(&self.ends.least, near);
        let most = self.row_at(&self.ends.most, far);
        let still = self.start.is_exact() && self.end.is_exact();
        let by_distance = |lo: S, hi: S, exact: bool| {
            if exact {
                Some(Figure::Exact(lo))
            } else {
                Figure::between(lo, hi)
            }
        };
        let dissipated_lower = by_distance(
            least.dissipated_lower,
            most.dissipated_lower,
            still && self.ends.friction_is_exact(),
        )?;
        let crossings = self.crossings();
        let crossings = crossings.as_ref();
        let [generated_linear, generated_quantized] = self.generated(crossings)?;
        let [net_linear, net_quantized] = if still {
            [&generated_linear, &generated_quantized]
                .map(|generated| dissipated_lower.minus(generated))
        } else {
            // The figures of a row belong to the same two positions.
            self.net(crossings)?.map(Some)
        };
        Some(Row {
            generated_linear,
            generated_quantized,
            bound_22: by_distance(least.bound_22, most.bound_22, still)?,
            bound_quantized: by_distance(least.bound_quantized, most.bound_quantized, still)?,
            dissipated_lower,
            net_linear: net_linear?,
            net_quantized: net_quantized?,
            margin: self.margin(near, far)?,
        })
    }

    fn held(&self, [from, to]: [&S; 2], force: &S) -> HeldInterval<S> {
        HeldInterval {
            step: Step::new(from.clone(), to.clone()),
            force: force.clone(),
            dtau: self.dtau.clone(),
            extra_storage: None,
        }
    }

    /// What the row of a pair of positions says of the distance alone: as where nothing is generated.
    fn row_at(&self, of: &Loop<S>, [from, to]: [&S; 2]) -> Row<S> {
        let step = Step::new(from.clone(), to.clone());
        ledger::row_of(of, &step, self.dtau, [S::zero(), S::zero()])
    }

    /// Margin of the criterion times the mean speed: linear in it, so extreme at an end.
    fn margin(&self, near: [&S; 2], far: [&S; 2]) -> Option<Figure<S>> {
        let speeds = [near, far].map(|[from, to]| {
            let d = to.clone() - from.clone();
            dissipation::mean_speed(&d, self.dtau)
        });
        let margins = |of: &Criterion<S>| speeds.each_ref().map(|v| of.margin(v));
        let [least, most] = &self.ends.criteria;
        let ([a, b], [c, d]) = (margins(least), margins(most));
        Figure::between(a.min(b), c.max(d))
    }

    /// What is generated at a pair of positions under a force.
    fn generated_at(&self, positions: [&S; 2], force: &S) -> Accounts<S> {
        ledger::generated(&self.ends.least, &self.held(positions, force))
    }

    fn forces(&self) -> impl Iterator<Item = &S> {
        let (lo, hi) = (self.force.lo(), self.force.hi());
        std::iter::once(lo).chain((!self.force.is_exact()).then_some(hi))
    }

    /// Both accounts at their extremes under each end of the force, as those of all between them.
    fn joined(&self, ranges: impl IntoIterator<Item = [[S; 2]; 2]>) -> Option<[Figure<S>; 2]> {
        let mut found: [Option<Interval<S>>; 2] = [None, None];
        for accounts in ranges {
            for (known, [lo, hi]) in found.iter_mut().zip(accounts) {
                join(known, Interval::new(lo, hi)?);
            }
        }
        self.figures(found)
    }

    /// Generated energy at its extremes.
    fn generated(&self, crossings: Option<&Crossings<S>>) -> Option<[Figure<S>; 2]> {
        match crossings {
            Some(crossings) => self.generated_by(crossings),
            None => self.generated_between(),
        }
    }

    /// `dissipated_lower` less generated energy, at its extremes.
    fn net(&self, crossings: Option<&Crossings<S>>) -> Option<[Figure<S>; 2]> {
        match crossings {
            Some(crossings) => self.net_by(crossings),
            None => self.net_on_edges(),
        }
    }

    /// The least friction and the most, where that is another, as β/Δτ and σ.
    fn frictions(&self) -> (Friction<S>, Option<Friction<S>>) {
        let of = |ends: &Loop<S>| {
            let friction = ends.friction();
            Friction::new(friction.beta.over(self.dtau.clone()), friction.sigma)
        };
        let most = (!self.ends.friction_is_exact()).then(|| of(&self.ends.most));
        (of(&self.ends.least), most)
    }

    /// Generated energy at its extremes, wherever the ends of the positions are.
    ///
    /// A function of ξ₁ less one of ξ₀: the extremes of each, taken with the other one fixed.
    fn generated_between(&self) -> Option<[Figure<S>; 2]> {
        let (from, to) = (self.start.lo(), self.end.lo());
        let mut found: [Option<Interval<S>>; 2] = [None, None];
        for force in self.forces() {
            let base = self.generated_at([from, to], force);
            let mut of_start = base.clone().map(Interval::point);
            let mut of_end = of_start.clone();
            let points = |of: &Figure<S>| {
                // Where the law's force balances the held one, when that is within.
                let balance = (-force.clone()).max(of.lo().clone()).min(of.hi().clone());
                let several = !of.is_exact();
                [of.hi().clone(), balance]
                    .into_iter()
                    .filter(move |_| several)
            };
            for xi in points(self.start) {
                widen(&mut of_start, self.generated_at([&xi, to], force));
            }
            for xi in points(self.end) {
                widen(&mut of_end, self.generated_at([from, &xi], force));
            }
            let both = of_start.into_iter().zip(of_end).zip(base);
            for (known, ((start, end), base)) in found.iter_mut().zip(both) {
                let at = |a: &S, b: &S| a.clone() + b.clone() - base.clone();
                let here = Interval::new(at(start.lo(), end.lo()), at(start.hi(), end.hi()))?;
                join(known, here);
            }
        }
        self.figures(found)
    }

    /// Net energy against the linear spring alone.
    pub(crate) fn net_linear(&self) -> Option<Figure<S>> {
        if self.start.is_exact() && self.end.is_exact() {
            return Some(self.row()?.net_linear);
        }
        let [linear, _] = self.net(self.crossings().as_ref())?;
        Some(linear)
    }

    /// `dissipated_lower` less generated energy, at its extremes, wherever the ends of the positions are.
    fn net_on_edges(&self) -> Option<[Figure<S>; 2]> {
        let frictions = self.frictions();
        let mut found: [Option<Interval<S>>; 2] = [None, None];
        let edges = self.edges()?;
        for force in self.forces() {
            for Edge {
                ends: [from, to],
                bends,
            } in &edges
            {
                let half_way = |a: &S, b: &S| (a.clone() + b.clone()).half();
                let middle = [half_way(&from[0], &to[0]), half_way(&from[1], &to[1])];
                let values = [from, &middle, to].map(|at| self.generated_at(at.each_ref(), force));
                let d = |[from, to]: &[S; 2]| to.clone() - from.clone();
                let [first, between, last] = values;
                let accounts = first.into_iter().zip(between).zip(last).zip(bends);
                for (known, (((a, b), c), bend)) in found.iter_mut().zip(accounts) {
                    let curve = through([a, b, c], [d(from), d(to)], bend)?;
                    let here = net_along(&frictions, &curve, [d(from), d(to)])?;
                    join(known, here);
                }
            }
        }
        self.figures(found)
    }

    /// What was found of both accounts: exact where positions and force are.
    fn figures(&self, found: [Option<Interval<S>>; 2]) -> Option<[Figure<S>; 2]> {
        let [linear, quantized] = found;
        let exact = self.start.is_exact() && self.end.is_exact() && self.force.is_exact();
        let figure = |range: Interval<S>| match exact {
            true => Figure::Exact(range.lo().clone()),
            false => Figure::Enclosed(range),
        };
        Some([figure(linear?), figure(quantized?)])
    }

    /// The edges of the rectangle, each from one corner to the next, or to where the law is bent; `None` where that is
    /// not told.
    fn edges(&self) -> Option<Vec<Edge<S>>> {
        let pair = |[from, to]: [&S; 2]| [from.clone(), to.clone()];
        let mut edges = Vec::new();
        for ([a, b], bends) in self.pieces(self.start)? {
            let ends = [self.end.lo(), self.end.hi()];
            edges.extend(ends.map(|end| Edge {
                ends: [pair([&a, end]), pair([&b, end])],
                bends: bends.each_ref().map(|bend| -bend.clone()),
            }));
        }
        for ([a, b], bends) in self.pieces(self.end)? {
            let starts = [self.start.lo(), self.start.hi()];
            edges.extend(starts.map(|start| Edge {
                ends: [pair([start, &a]), pair([start, &b])],
                bends: bends.clone(),
            }));
        }
        Some(edges)
    }

    /// A position from its lower end to its upper one, in pieces over each of which the law is not bent: none of an
    /// exact one. With each, what the square of the position is times in both potentials there.
    fn pieces(&self, of: &Figure<S>) -> Option<Vec<([S; 2], Accounts<S>)>> {
        let mut pieces = Vec::new();
        if of.is_exact() {
            return Some(pieces);
        }
        let has_encoder = self.ends.least.has_encoder();
        let bends = |is_linear: bool| {
            let linear = if is_linear {
                S::one().half()
            } else {
                S::zero()
            };
            // Within a tick the quantized force is the same.
            let quantized = if has_encoder {
                S::zero()
            } else {
                linear.clone()
            };
            [linear, quantized]
        };
        let (law, mut from) = (self.ends.least.law(), of.lo().clone());
        let mut is_linear = law.lower.is_none();
        let lower = law.lower.into_iter().map(|bend| (bend, true));
        let upper = law.upper.into_iter().map(|bend| (bend, false));
        for (bend, is_linear_behind) in lower.chain(upper) {
            if bend.compare(&from)? != Ordering::Greater {
                is_linear = is_linear_behind;
            } else if bend.compare(of.hi())? == Ordering::Less {
                let piece = [std::mem::replace(&mut from, bend.clone()), bend];
                pieces.push((piece, bends(is_linear)));
                is_linear = is_linear_behind;
            }
        }
        pieces.push(([from, of.hi().clone()], bends(is_linear)));
        Some(pieces)
    }
}

/// A part of the edge of a rectangle, over which both accounts of generated energy are parabolas.
struct Edge<S> {
    /// The positions at one end and at the other.
    ends: [[S; 2]; 2],
    /// What the square of the displacement is times in each account.
    bends: Accounts<S>,
}

/// Net energy along an edge on which generated energy is αd² + γd + κ: at its least with the least
/// friction, at its most with the most. Friction is given as β/Δτ and σ.
fn net_along<S: Ordered>(
    (least, most): &(Friction<S>, Option<Friction<S>>),
    [alpha, gamma, kappa]: &[S; 3],
    [from, to]: [S; 2],
) -> Option<Interval<S>> {
    let (from, to) = (from.clone().min(to.clone()), from.max(to));
    let range = |friction: &Friction<S>| {
        let parabola = Parabola {
            square: friction.beta.clone() - alpha.clone(),
            magnitude: friction.sigma.clone(),
            linear: -gamma.clone(),
            constant: -kappa.clone(),
        };
        parabola.range(&from, &to)
    };
    let [lowest, highest] = range(least)?;
    let highest = match most {
        None => highest,
        Some(most) => {
            let [_, highest] = range(most)?;
            highest
        }
    };
    Interval::new(lowest, highest)
}

/// Adds a range to what is known so far.
fn join<S: Ordered>(known: &mut Option<Interval<S>>, here: Interval<S>) {
    *known = Some(match known.take() {
        Some(known) => known.joined(&here),
        None => here,
    });
}

fn widen<S: Ordered>(ranges: &mut [Interval<S>; 2], values: Accounts<S>) {
    for (range, value) in ranges.iter_mut().zip(values) {
        *range = range.joined(&Interval::point(value));
    }
}

/// The parabola through three values on an edge, in short numbers: see [`extremes::through`]. What its square is times is
/// known: enclosures of values do not tell it from zero where it is that.
fn through<S: Written>(values: [S; 3], [from, to]: [S; 2], bend: &S) -> Option<[S; 3]> {
    let width = to.clone() - from.clone();
    let found = extremes::through(values, [from, to])?;
    if !S::EXACT {
        let [_, gamma, kappa] = found;
        return Some([bend.clone(), gamma, kappa]);
    }
    if width.square().compare(&S::one())? == Ordering::Equal {
        return Some(found);
    }
    // Dividing by a short width made the numbers longer than what they stand for.
    let [alpha, gamma, kappa] = found.each_ref().map(S::in_lowest_terms);
    Some([alpha?, gamma?, kappa?])
}

#[cfg(test)]
mod tests;
