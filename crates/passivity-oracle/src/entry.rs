//! The ledger row of one interval: exact, or exactly enclosed where the trace or the scene leaves
//! room.

use std::cmp::Ordering;

use passivity_core::effects::{damping_storage, delay_storage};
use passivity_core::{Ordered, Truth, dissipation, generation};

use crate::cell::Cell;
use crate::generated;
use crate::model::Model;
use crate::span::{Span, not};

/// One row of the ledger. Energies in KΔ².
#[derive(Clone, Debug, PartialEq)]
pub struct Entry<S> {
    /// ξ₀, in ticks.
    pub xi0: Span<S>,
    /// ξ₁, in ticks.
    pub xi1: Span<S>,
    /// Δτ, in sampling periods.
    pub dtau: S,
    /// Generated against the linear spring, or the wall's law (TH-LIN, TH-LAW).
    pub generated_linear: Span<S>,
    /// Generated against the quantized spring or law (18); without an encoder the same.
    pub generated_quantized: Span<S>,
    /// ½d² + ½|d| (22); without an encoder ½d² (TH-SMOOTH).
    pub bound_22: Span<S>,
    /// ½d² + ½|d| + ½f(1 − f) (TH-QUANT); without an encoder ½d².
    pub bound_quantized: Span<S>,
    /// βd²/Δτ + σ|d|, the least that friction dissipates (26).
    pub dissipated_lower: Span<S>,
    /// `dissipated_lower` − `generated_linear` − `extra_storage`.
    pub net_linear: Span<S>,
    /// `dissipated_lower` − `generated_quantized` − `extra_storage`.
    pub net_quantized: Span<S>,
    /// Margin of the criterion (8) at the mean speed, (β − ½) + (σ − ½)/v̄ with the terms of the
    /// effects; `None` when nothing moved.
    pub margin: Option<Margin<S>>,
    /// Whether the margin is not negative; true when nothing moved, for (27) reads 0 ≥ 0 then.
    pub criterion_holds: Truth,
    /// Whether more is generated against the linear spring than friction surely dissipates.
    pub violates_linear: Truth,
    /// The same against the quantized spring.
    pub violates_quantized: Truth,
    /// What the storages of delay and damping gain over the interval (TH-DELAY, TH-DAMP); `None`
    /// without these effects.
    pub extra_storage: Option<Span<S>>,
}

/// The margin of the criterion at a mean speed, between two ends.
///
/// An encoder that counts at most one tick leaves room for any small speed, at which (σ − ½)/v̄
/// is past every bound: such an end is `None`.
#[derive(Clone, Debug, PartialEq)]
pub enum Margin<S> {
    /// Exactly this.
    At(S),
    /// Between a lower and an upper end, as far as there are any.
    Between(Option<S>, Option<S>),
}

impl<S> Margin<S> {
    /// The lower end, when there is one.
    pub const fn lo(&self) -> Option<&S> {
        match self {
            Self::At(x) => Some(x),
            Self::Between(lo, _) => lo.as_ref(),
        }
    }

    /// The upper end, when there is one.
    pub const fn hi(&self) -> Option<&S> {
        match self {
            Self::At(x) => Some(x),
            Self::Between(_, hi) => hi.as_ref(),
        }
    }
}

/// The row of the interval that `samples[0]` starts and `end` ends, `dtau` > 0 later.
///
/// `samples` holds the latest sample first; further ones are read as far as the model's
/// [`memory`](Model::memory) goes. `None` when a number is undefined, as when a fixed width
/// overflows.
///
/// # Example
///
/// The counterexample to (22), and what an encoder's counts say of the same move.
///
/// ```
/// use passivity_core::{Fixed, Friction, Scalar, Truth};
/// use passivity_oracle::{Cell, Model, Span, entry};
///
/// let model = Model::plain(Friction::new(Fixed::new(3, 5), Fixed::new(3, 5)));
/// let one = Fixed::integer(1);
/// let row = entry(&model, &[Cell::of(&one)], &Cell::of(&Fixed::new(1, 2)), &one).unwrap();
/// assert_eq!(row.generated_quantized, Span::At(Fixed::new(1, 2)));
/// assert_eq!(row.violates_quantized, Truth::Holds);
///
/// let row = entry(&model, &[Cell::count(one)], &Cell::count(Fixed::integer(0)), &one).unwrap();
/// assert_eq!(row.generated_quantized, Span::Between(Fixed::integer(0), one));
/// assert_eq!(row.violates_quantized, Truth::Depends);
/// ```
#[must_use]
pub fn entry<S: Ordered>(
    model: &Model<S>,
    samples: &[Cell<S>],
    end: &Cell<S>,
    dtau: &S,
) -> Option<Entry<S>> {
    let start = samples.first()?;
    let encoder = model.effects.encoder;
    let displacement = displacement(start, end);
    let distance = displacement.magnitude();
    let held = model.held_force(samples);
    let dissipated_lower = dissipated(model, &distance, dtau);
    let extra_storage = extra_storage(model, samples, end);
    let generated_linear = generated::against_law(model, &held, start, end);
    let generated_quantized = generated::against_steps(model, &held, start, end);
    let generation = generated::Generation {
        model,
        held: &held,
        start,
        end,
        dtau,
    };
    let net = |generated: &Span<S>, tight: Option<Span<S>>| {
        // The tight enclosure knows that all figures belong to the same two positions.
        let net = tight.unwrap_or_else(|| dissipated_lower.minus(generated));
        match &extra_storage {
            Some(extra) => net.minus(extra),
            None => net,
        }
    };
    let net_linear = net(&generated_linear, generation.net_of_law());
    let net_quantized = net(&generated_quantized, generation.net_of_steps());
    let moved = distance.hi().is_positive()?;
    let (margin, criterion_holds) = match moved {
        true => criterion(model, &distance, dtau)?,
        false => (None, Truth::Holds),
    };
    let bound = |quantized: fn(&S) -> S| {
        move |d: &S| match encoder {
            true => quantized(d),
            false => d.square().half(),
        }
    };
    let row = Entry {
        xi0: start.position(),
        xi1: end.position(),
        dtau: dtau.clone(),
        bound_22: distance.rising(bound(generation::bound_22)),
        bound_quantized: distance.rising(bound(generation::bound_quantized)),
        criterion_holds,
        violates_linear: not(net_linear.is_nonnegative()?),
        violates_quantized: not(net_quantized.is_nonnegative()?),
        generated_linear,
        generated_quantized,
        dissipated_lower,
        net_linear,
        net_quantized,
        margin,
        extra_storage,
    };
    row.is_defined().then_some(row)
}

/// d = ξ₁ − ξ₀.
fn displacement<S: Ordered>(start: &Cell<S>, end: &Cell<S>) -> Span<S> {
    let ticks = end.tick.clone() - start.tick.clone();
    end.residue
        .minus(&start.residue)
        .rising(|d| ticks.clone() + d.clone())
}

fn dissipated<S: Ordered>(model: &Model<S>, distance: &Span<S>, dtau: &S) -> Span<S> {
    let at = |friction: &passivity_core::Friction<S>, d: &S| {
        friction.dissipated_lower(d, &dissipation::mean_speed(d, dtau))
    };
    match distance {
        Span::At(d) if model.is_exact() => Span::At(at(&model.least, d)),
        _ => Span::Between(
            at(&model.least, distance.lo()),
            at(&model.most, distance.hi()),
        ),
    }
}

/// The margin at the mean speed, and whether the criterion holds there.
fn criterion<S: Ordered>(
    model: &Model<S>,
    distance: &Span<S>,
    dtau: &S,
) -> Option<(Option<Margin<S>>, Truth)> {
    let (least, most) = model.criteria();
    let speed = distance.rising(|d| dissipation::mean_speed(d, dtau));
    let may_rest = distance.lo().sign()? == Ordering::Equal;
    // (8) times the speed is linear in it, so extreme at the ends, and has the sign of (8).
    let worst = least.margin(speed.lo()).min(least.margin(speed.hi()));
    let best = most.margin(speed.lo()).max(most.margin(speed.hi()));
    let truth = match Truth::over(worst.is_nonnegative()?, best.is_nonnegative()?) {
        // Had nothing moved, the criterion would hold.
        Truth::Fails if may_rest => Truth::Depends,
        truth => truth,
    };
    // (8) itself is monotone in the speed, and without bound at rest unless σ is on the line.
    let at = |criterion: &passivity_core::Criterion<S>, v: &S| {
        criterion.viscous.clone() + criterion.coulomb.clone().over(v.clone())
    };
    let end = |criterion: &passivity_core::Criterion<S>, grows: Ordering| {
        let sign = criterion.coulomb.sign()?;
        let v = if sign == grows {
            speed.lo()
        } else {
            speed.hi()
        };
        let unbounded = sign == grows && may_rest;
        Some((!unbounded).then(|| at(criterion, v)))
    };
    let (lo, hi) = (end(&least, Ordering::Less)?, end(&most, Ordering::Greater)?);
    let margin = match (model.is_exact(), distance, lo) {
        (true, Span::At(_), Some(margin)) => Margin::At(margin),
        (_, _, lo) => Margin::Between(lo, hi),
    };
    Some((Some(margin), truth))
}

/// What the extra storages of delay and damping gain over the interval.
fn extra_storage<S: Ordered>(
    model: &Model<S>,
    samples: &[Cell<S>],
    end: &Cell<S>,
) -> Option<Span<S>> {
    let late = usize::from(model.effects.delay);
    if model.memory() == 0 {
        return None;
    }
    // Displacements, the latest first; before the first sample nothing moved.
    let chain: Vec<&Cell<S>> = std::iter::once(end).chain(samples).collect();
    let steps: Vec<Span<S>> = chain
        .windows(2)
        .filter_map(|pair| Some(displacement(pair.get(1)?, pair.first()?).magnitude()))
        .chain(std::iter::repeat_n(Span::At(S::zero()), late + 2))
        .collect();
    let storage = |from: usize| {
        let at = |pick: fn(&Span<S>) -> &S| {
            let taken = |n: usize| -> Vec<S> {
                let recent = steps.iter().skip(from).take(n);
                recent.map(|step| pick(step).clone()).collect()
            };
            let stored = delay_storage(&taken(late));
            match &model.effects.damping {
                Some(damping) => stored + damping_storage(damping, &taken(late + 1)),
                None => stored,
            }
        };
        // Storage rises with every |d|.
        match steps.iter().all(|step| step.exact().is_some()) {
            true => Span::At(at(Span::lo)),
            false => Span::Between(at(Span::lo), at(Span::hi)),
        }
    };
    Some(storage(0).minus(&storage(1)))
}

impl<S: Ordered> Entry<S> {
    /// The energies and positions in the order of the interface, with their names.
    pub fn figures(&self) -> [(&'static str, Option<&Span<S>>); 10] {
        [
            ("xi0", Some(&self.xi0)),
            ("xi1", Some(&self.xi1)),
            ("generated_linear", Some(&self.generated_linear)),
            ("generated_quantized", Some(&self.generated_quantized)),
            ("bound_22", Some(&self.bound_22)),
            ("bound_quantized", Some(&self.bound_quantized)),
            ("dissipated_lower", Some(&self.dissipated_lower)),
            ("net_linear", Some(&self.net_linear)),
            ("net_quantized", Some(&self.net_quantized)),
            ("extra_storage", self.extra_storage.as_ref()),
        ]
    }

    fn is_defined(&self) -> bool {
        let defined = |(_, figure): &(_, Option<&Span<S>>)| match figure {
            Some(span) => span.is_defined(),
            None => true,
        };
        let margin = self
            .margin
            .iter()
            .flat_map(|m| m.lo().into_iter().chain(m.hi()));
        margin.map(Ordered::sign).all(|sign| sign.is_some())
            && self.dtau.sign().is_some()
            && self.figures().iter().all(defined)
    }
}
