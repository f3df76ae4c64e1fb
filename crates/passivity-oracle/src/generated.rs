//! Energy generated within an interval by a held force, and what is left of the dissipation.
//!
//! Of a counted position only its tick is known, so every figure is taken to its extremes over
//! the square of residues (ρ₀, ρ₁). They are exact:
//!
//! * Generated energy is F·(ξ₁ − ξ₀) + V(ξ₁) − V(ξ₀) with a held force F that is known: a function
//!   of ρ₁ less the same function of ρ₀. With V convex its least value is where V′ = −F, its
//!   largest at an end.
//! * Net energy also has βd²/Δτ + σ|d| in it. On a line of equal d it is monotone in ρ₀ (its
//!   slope is V′(ξ₀) − V′(ξ₁), of one sign; constant for the quantized spring on a pair of
//!   ticks). So its extremes are on the edge of the square, where it is a parabola in d with a
//!   kink at d = 0.

use passivity_core::{Law, Ordered, Scalar, Step, generation};

use crate::cell::Cell;
use crate::model::Model;
use crate::span::{Parabola, Span};

/// E_gᴸ = F·d + V(ξ₁) − V(ξ₀) with the potential V of the wall's law.
pub(crate) fn against_law<S: Ordered>(
    model: &Model<S>,
    held: &S,
    start: &Cell<S>,
    end: &Cell<S>,
) -> Span<S> {
    if let (true, Some(xi0), Some(xi1)) = (
        model.is_plain(),
        start.position().exact(),
        end.position().exact(),
    ) {
        let step = Step::new(xi0.clone(), xi1.clone());
        return Span::At(generation::generated_linear(&step));
    }
    let law = model.law();
    let work = |cell: &Cell<S>| {
        let at = |xi: &S| held.clone() * xi.clone() + law.potential(xi);
        match cell.position() {
            Span::At(xi) => Span::At(at(&xi)),
            Span::Between(lo, hi) => {
                // Where the law's force balances the held one, when that is in the cell.
                let balance = (-held.clone()).max(lo.clone()).min(hi.clone());
                let ends = (at(&lo), at(&hi));
                let least = at(&balance).min(ends.0.clone()).min(ends.1.clone());
                Span::Between(least, ends.0.max(ends.1))
            }
        }
    };
    work(end).minus(&work(start))
}

/// E_g (18), with the potential of the law quantized: ∫f(⌊x⌋ + ½)dx.
pub(crate) fn against_steps<S: Ordered>(
    model: &Model<S>,
    held: &S,
    start: &Cell<S>,
    end: &Cell<S>,
) -> Span<S> {
    if let (true, Some(xi0), Some(xi1)) = (
        model.is_plain(),
        start.position().exact(),
        end.position().exact(),
    ) {
        let step = Step::new(xi0.clone(), xi1.clone());
        return Span::At(generation::generated_quantized(&step));
    }
    if !model.effects.encoder {
        // What is not quantized has one counterpart only.
        return against_law(model, held, start, end);
    }
    let law = model.law();
    let work = |cell: &Cell<S>| {
        let slope = slope(&law, held, &cell.tick);
        let at_tick = held.clone() * cell.tick.clone() + steps_potential(&law, &cell.tick);
        let at = |rho: &S| at_tick.clone() + slope.clone() * rho.clone();
        match &cell.residue {
            Span::At(rho) => Span::At(at(rho)),
            Span::Between(lo, hi) => Span::Between(at(lo).min(at(hi)), at(lo).max(at(hi))),
        }
    };
    work(end).minus(&work(start))
}

/// F + f(n + ½): how the work against the quantized law grows within a tick.
fn slope<S: Scalar>(law: &Law<S>, held: &S, tick: &S) -> S {
    held.clone() + law.force(&(tick.clone() + S::one().half()))
}

/// ∫f(⌊x⌋ + ½)dx from 0 to a whole tick: H_e (16) for the wall on both sides.
///
/// The steps are whole up to the clamp: ½m² over m of them, and the clamp itself beyond.
fn steps_potential<S: Scalar>(law: &Law<S>, tick: &S) -> S {
    let side = |ticks: S, limit: Option<S>| {
        let ticks = ticks.max(S::zero());
        match limit {
            None => ticks.square().half(),
            Some(limit) => {
                let whole = (limit.clone() + S::one().half()).floor().min(ticks.clone());
                whole.square().half() + (ticks - whole) * limit
            }
        }
    };
    let below = law.lower.clone().map(|lower| -lower);
    side(tick.clone(), law.upper.clone()) + side(-tick.clone(), below)
}

/// An interval of which the net energy is enclosed.
pub(crate) struct Generation<'a, S> {
    pub(crate) model: &'a Model<S>,
    pub(crate) held: &'a S,
    pub(crate) start: &'a Cell<S>,
    pub(crate) end: &'a Cell<S>,
    pub(crate) dtau: &'a S,
}

impl<S: Ordered> Generation<'_, S> {
    /// `dissipated_lower` − E_gᴸ at its extremes; `None` where positions are exact, and where the
    /// law is clamped (the difference of the two enclosures then serves).
    pub(crate) fn net_of_law(&self) -> Option<Span<S>> {
        if self.model.is_clamped() {
            return None;
        }
        // E = ½d² + (ρ₀ + c)d.
        let c = self.start.tick.clone() + self.held.clone();
        let half = S::one().half();
        self.extremes(
            |rho_0| (-half.clone(), -(rho_0.clone() + c.clone()), S::zero()),
            // ρ₀ = D + ρ₁ − d.
            |end| (half.clone(), -(end.clone() + c.clone()), S::zero()),
        )
    }

    /// `dissipated_lower` − E_g at its extremes; `None` where positions are exact.
    pub(crate) fn net_of_steps(&self) -> Option<Span<S>> {
        let law = &self.model.law();
        let (n0, n1) = (&self.start.tick, &self.end.tick);
        let (slope_0, slope_1) = (slope(law, self.held, n0), slope(law, self.held, n1));
        let ticks = n1.clone() - n0.clone();
        let constant =
            self.held.clone() * ticks.clone() + steps_potential(law, n1) - steps_potential(law, n0);
        // E = constant + slope₁ρ₁ − slope₀ρ₀ with ρ₁ − ρ₀ = d − D.
        self.extremes(
            |rho_0| {
                let at_rest = constant.clone() + slope_1.clone() * (rho_0.clone() - ticks.clone())
                    - slope_0.clone() * rho_0.clone();
                (S::zero(), -slope_1.clone(), -at_rest)
            },
            |end| {
                let rho_1 = end.clone() - ticks.clone();
                let at_rest =
                    constant.clone() + slope_1.clone() * rho_1 - slope_0.clone() * end.clone();
                (S::zero(), -slope_0.clone(), -at_rest)
            },
        )
    }

    /// The extremes over the edge of the square of residues. On an edge of constant ρ₀, and on
    /// one of constant ρ₁ (given as D + ρ₁), net energy is (q + β/Δτ)d² + σ|d| + l·d + k: the
    /// closures give (q, l, k).
    fn extremes(
        &self,
        start_edge: impl Fn(&S) -> (S, S, S),
        end_edge: impl Fn(&S) -> (S, S, S),
    ) -> Option<Span<S>> {
        let (rho_0, rho_1) = (&self.start.residue, &self.end.residue);
        if rho_0.exact().is_some() && rho_1.exact().is_some() {
            return None;
        }
        let ticks = self.end.tick.clone() - self.start.tick.clone();
        let end_lo = ticks.clone() + rho_1.lo().clone();
        let end_hi = ticks + rho_1.hi().clone();
        let mut edges = Vec::with_capacity(4);
        for rho in [rho_0.lo(), rho_0.hi()] {
            let (from, to) = (end_lo.clone() - rho.clone(), end_hi.clone() - rho.clone());
            edges.push((start_edge(rho), from, to));
        }
        for end in [&end_lo, &end_hi] {
            let (from, to) = (
                end.clone() - rho_0.hi().clone(),
                end.clone() - rho_0.lo().clone(),
            );
            edges.push((end_edge(end), from, to));
        }
        let (mut least, mut most): (Option<S>, Option<S>) = (None, None);
        for ((square, linear, constant), from, to) in edges {
            let parabola = |friction: &passivity_core::Friction<S>| Parabola {
                square: square.clone() + friction.beta.clone().over(self.dtau.clone()),
                magnitude: friction.sigma.clone(),
                linear: linear.clone(),
                constant: constant.clone(),
            };
            // Net energy rises with both frictions.
            let (low, _) = parabola(&self.model.least).range(&from, &to)?;
            let (_, high) = parabola(&self.model.most).range(&from, &to)?;
            least = Some(match least {
                Some(least) => least.min(low),
                None => low,
            });
            most = Some(match most {
                Some(most) => most.max(high),
                None => high,
            });
        }
        Some(Span::Between(least?, most?))
    }
}
