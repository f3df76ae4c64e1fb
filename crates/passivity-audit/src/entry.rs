//! The ledger row of one interval: exact, or exactly enclosed where the trace or the scene leaves
//! room. Every figure is the kernel's, [`ledger::row`].

use std::cmp::Ordering;

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{
    Criterion, Interval, Ordered, Scalar, Step, Truth, dissipation, extra_storage,
};

use crate::ball::Ball;
use crate::enclosure::Rectangle;
use crate::ends::Ends;
use crate::figure::{Figure, not};
use crate::ledger::Truths;
use crate::number::Written;
use crate::sum::FigureSum;

/// A sampling interval as a trace has it.
#[derive(Clone, Copy, Debug)]
pub struct Recorded<'a, S> {
    /// The samples up to its start, the latest first: as many as the loop remembers. Each is exact
    /// or within a tick.
    pub samples: &'a [Figure<S>],
    /// Where it ends.
    pub end: &'a Figure<S>,
    /// Δτ > 0, in sampling periods.
    pub dtau: &'a S,
    /// The force that was applied, in KΔ; `None` for that of the loop's controller.
    pub force: Option<&'a Figure<S>>,
}

/// One row of the ledger. Energies in KΔ².
#[derive(Clone, Debug, PartialEq)]
pub struct Entry<S> {
    /// ξ₀, in ticks.
    pub xi0: Figure<S>,
    /// ξ₁, in ticks.
    pub xi1: Figure<S>,
    /// Whether it is known that nothing moved, however little is known of where.
    pub rests: bool,
    /// Δτ, in sampling periods.
    pub dtau: S,
    /// The account, as the kernel gives it.
    pub account: ledger::Row<Figure<S>>,
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
    /// without these effects, and of a force that was applied: they pay for the loop's own force only.
    pub extra_storage: Option<Figure<S>>,
    /// The force that was held, in KΔ.
    pub held: Figure<S>,
    /// Whether that is the force that was given, not that of the loop's controller.
    pub applied: bool,
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

/// The row of an interval.
///
/// `None` when a number is undefined, as when a fixed width overflows, or when there is no sample.
///
/// # Example
///
/// The counterexample to (22), and what an encoder's counts say of the same move.
///
/// ```
/// use passivity_core::{Fixed, Friction, Loop, Scalar, Truth};
/// use passivity_audit::{Ends, Figure, Recorded, entry};
///
/// let ends = Ends::exact(Loop::plain(Friction::new(Fixed::new(3, 5), Fixed::new(3, 5))));
/// let row = |start, end| {
///     let dtau = &Fixed::integer(1);
///     entry(&ends, &Recorded { samples: &[start], end: &end, dtau, force: None }).unwrap()
/// };
/// let exact = row(Figure::Exact(Fixed::integer(1)), Figure::Exact(Fixed::new(1, 2)));
/// assert_eq!(exact.account.generated_quantized, Figure::Exact(Fixed::new(1, 2)));
/// assert_eq!(exact.violates_quantized, Truth::Holds);
///
/// let count = |n| Figure::between(Fixed::integer(n), Fixed::integer(n + 1)).unwrap();
/// let counted = row(count(1), count(0));
/// assert_eq!(counted.account.generated_quantized, count(0));
/// assert_eq!(counted.violates_quantized, Truth::Depends);
/// ```
#[must_use]
pub fn entry<S: Written>(ends: &Ends<S>, interval: &Recorded<'_, S>) -> Option<Entry<S>> {
    let start = interval.samples.first()?;
    let held = match interval.force {
        Some(force) => force.clone(),
        None => Figure::Exact(ends.held_force(interval.samples)),
    };
    let extra_storage = match interval.force {
        Some(_) => None,
        None => stored(ends, interval)?,
    };
    let account = match (start, interval.end, &held, &extra_storage) {
        (
            Figure::Exact(from),
            Figure::Exact(to),
            Figure::Exact(force),
            None | Some(Figure::Exact(_)),
        ) => {
            let exact = HeldInterval {
                step: Step::new(from.clone(), to.clone()),
                force: force.clone(),
                dtau: interval.dtau.clone(),
                extra_storage: extra_storage.as_ref().map(|gain| gain.lo().clone()),
            };
            between_frictions(ends, &exact)?
        }
        _ => {
            let rectangle = Rectangle {
                ends,
                start,
                end: interval.end,
                force: &held,
                dtau: interval.dtau,
            };
            less_stored(rectangle.row()?, extra_storage.as_ref())?
        }
    };
    let speed = mean_speed([start, interval.end], interval.dtau)?;
    let criterion_holds = criterion(&account.margin, &speed)?;
    // Of enclosures it is asked only where it is written.
    let margin = match S::EXACT {
        true => margin_at(ends, &speed)?,
        false => None,
    };
    let entry = Entry {
        xi0: start.clone(),
        xi1: interval.end.clone(),
        rests: speed
            .exact()
            .is_some_and(|v| v.sign() == Some(Ordering::Equal)),
        dtau: interval.dtau.clone(),
        margin,
        criterion_holds,
        violates_linear: not(account.net_linear.is_nonnegative()?),
        violates_quantized: not(account.net_quantized.is_nonnegative()?),
        extra_storage,
        applied: interval.force.is_some(),
        held,
        account,
    };
    entry.is_defined().then_some(entry)
}

/// The row of exact positions under an exact force: with the least and with the most friction.
fn between_frictions<S: Ordered>(
    ends: &Ends<S>,
    held: &HeldInterval<S>,
) -> Option<ledger::Row<Figure<S>>> {
    let least = ledger::row(&ends.least, held);
    let most = match ends.criterion_is_exact() {
        true => None,
        false => Some(ledger::row(&ends.most, held)),
    };
    // More friction takes more, so the ends are in order also where enclosures of them overlap; that they
    // are defined is seen to with the rest of the row.
    let by_friction = |lo: S, hi: Option<S>| match hi {
        None => Some(Figure::Exact(lo)),
        Some(hi) if hi.compare(&lo) == Some(Ordering::Less) => None,
        Some(hi) => Some(Figure::Enclosed(Interval::new_unchecked(lo, hi))),
    };
    // Of energies no cost is taken.
    let of = |pick: fn(&ledger::Row<S>) -> &S| match ends.friction_is_exact() {
        true => None,
        false => most.as_ref().map(|row| pick(row).clone()),
    };
    let best = most.as_ref().map(|row| row.margin.clone());
    Some(ledger::Row {
        dissipated_lower: by_friction(least.dissipated_lower, of(|row| &row.dissipated_lower))?,
        net_linear: by_friction(least.net_linear, of(|row| &row.net_linear))?,
        net_quantized: by_friction(least.net_quantized, of(|row| &row.net_quantized))?,
        margin: by_friction(least.margin, best)?,
        generated_linear: Figure::Exact(least.generated_linear),
        generated_quantized: Figure::Exact(least.generated_quantized),
        bound_22: Figure::Exact(least.bound_22),
        bound_quantized: Figure::Exact(least.bound_quantized),
    })
}

/// The row with what the extra storage gained taken off its net energies.
fn less_stored<S: Ordered>(
    row: ledger::Row<Figure<S>>,
    gain: Option<&Figure<S>>,
) -> Option<ledger::Row<Figure<S>>> {
    let Some(gain) = gain else { return Some(row) };
    Some(ledger::Row {
        net_linear: row.net_linear.minus(gain)?,
        net_quantized: row.net_quantized.minus(gain)?,
        ..row
    })
}

/// d = ξ₁ − ξ₀.
fn displacement<S: Ordered>(start: &Figure<S>, end: &Figure<S>) -> Option<Figure<S>> {
    end.minus(start)
}

/// The mean speed from one position to another.
fn mean_speed<S: Ordered>([start, end]: [&Figure<S>; 2], dtau: &S) -> Option<Figure<S>> {
    let distance = displacement(start, end)?.magnitude()?;
    distance.try_map(|d| Some(dissipation::mean_speed(d, dtau)))
}

/// Whether the criterion holds at the mean speed, of which this is the margin times that speed.
fn criterion<S: Ordered>(times_speed: &Figure<S>, speed: &Figure<S>) -> Option<Truth> {
    if !speed.hi().is_positive()? {
        return Some(Truth::Holds);
    }
    let may_rest = speed.lo().sign()? == Ordering::Equal;
    // (8) times the speed has the sign of (8).
    Some(match times_speed.is_nonnegative()? {
        // Had nothing moved, the criterion would hold.
        Truth::Fails if may_rest => Truth::Depends,
        truth => truth,
    })
}

/// The margin of the criterion at the mean speed: `Some(None)` where nothing moves, `None` when a number is
/// undefined.
fn margin_at<S: Ordered>(ends: &Ends<S>, speed: &Figure<S>) -> Option<Option<Margin<S>>> {
    if !speed.hi().is_positive()? {
        return Some(None);
    }
    let may_rest = speed.lo().sign()? == Ordering::Equal;
    // It is monotone in the speed, and without bound at rest unless σ is on the line.
    let end = |criterion: &Criterion<S>, grows: Ordering| {
        let sign = criterion.coulomb.sign()?;
        let v = if sign == grows {
            speed.lo()
        } else {
            speed.hi()
        };
        let unbounded = sign == grows && may_rest;
        Some((!unbounded).then(|| margin_of(criterion, v)))
    };
    let [least, most] = &ends.criteria;
    let (lo, hi) = (end(least, Ordering::Less)?, end(most, Ordering::Greater)?);
    Some(Some(match (ends.criterion_is_exact(), speed, lo) {
        (true, Figure::Exact(_), Some(margin)) => Margin::At(margin),
        (_, _, lo) => Margin::Between(lo, hi),
    }))
}

/// The margin of a criterion (8) at a speed v > 0.
#[inline(always)]
pub(crate) fn margin_of<S: Scalar>(criterion: &Criterion<S>, v: &S) -> S {
    criterion.viscous.clone() + criterion.coulomb.clone().over(v.clone())
}

/// What the extra storages of delay and damping gain over the interval: `Some(None)` without these
/// effects, `None` when a number is undefined.
fn stored<S: Ordered>(ends: &Ends<S>, interval: &Recorded<'_, S>) -> Option<Option<Figure<S>>> {
    if ends.controller.memory() == 0 {
        return Some(None);
    }
    let late = usize::from(ends.least.delay);
    // Displacements, the latest first; before the first sample nothing moved.
    let chain: Vec<&Figure<S>> = std::iter::once(interval.end)
        .chain(interval.samples)
        .collect();
    let mut steps = Vec::with_capacity(chain.len() + late + 2);
    for pair in chain.windows(2) {
        let [later, earlier] = pair else { return None };
        steps.push(displacement(earlier, later)?.magnitude()?);
    }
    steps.extend(std::iter::repeat_n(Figure::Exact(S::zero()), late + 2));
    let exact = steps.iter().all(Figure::is_exact);
    let storage = |from: usize| {
        let at = |pick: fn(&Figure<S>) -> &S| {
            let taken = |n: usize| -> Vec<S> {
                let recent = steps.iter().skip(from).take(n);
                recent.map(|step| pick(step).clone()).collect()
            };
            let stored = extra_storage::delay_storage(&taken(late));
            match &ends.least.damping {
                Some(damping) => stored + extra_storage::damping_storage(damping, &taken(late + 1)),
                None => stored,
            }
        };
        // Storage rises with every |d|.
        match exact {
            true => Some(Figure::Exact(at(Figure::lo))),
            false => Figure::between(at(Figure::lo), at(Figure::hi)),
        }
    };
    storage(0)?.minus(&storage(1)?).map(Some)
}

impl<S: Ordered> Entry<S> {
    /// The force that was given; `None` where it is that of the loop's controller.
    pub fn force(&self) -> Option<&Figure<S>> {
        self.applied.then_some(&self.held)
    }

    /// The figures that may be enclosures, with their names, but for the margin.
    pub fn figures(&self) -> [(&'static str, Option<&Figure<S>>); 11] {
        let account = &self.account;
        [
            ("xi0", Some(&self.xi0)),
            ("xi1", Some(&self.xi1)),
            ("generated_linear", Some(&account.generated_linear)),
            ("generated_quantized", Some(&account.generated_quantized)),
            ("bound_22", Some(&account.bound_22)),
            ("bound_quantized", Some(&account.bound_quantized)),
            ("dissipated_lower", Some(&account.dissipated_lower)),
            ("net_linear", Some(&account.net_linear)),
            ("net_quantized", Some(&account.net_quantized)),
            ("extra_storage", self.extra_storage.as_ref()),
            ("force", Some(&self.held)),
        ]
    }

    /// What the row answers.
    pub(crate) const fn truths(&self) -> Truths {
        Truths {
            criterion_holds: self.criterion_holds,
            violates_linear: self.violates_linear,
            violates_quantized: self.violates_quantized,
        }
    }
}

impl Entry<Ball> {
    /// The same with its margin, which a row has that is written; `None` where doubles leave it open.
    pub(crate) fn with_margin(self, ends: &Ends<Ball>) -> Option<Self> {
        let speed = mean_speed([&self.xi0, &self.xi1], &self.dtau)?;
        let margin = match self.rests {
            true => None,
            false => margin_at(ends, &speed)?,
        };
        Some(Self { margin, ..self })
    }
}

impl<S: Written> Entry<S> {
    fn is_defined(&self) -> bool {
        let defined = |(_, figure): &(_, Option<&Figure<S>>)| match figure {
            Some(figure) => figure.lo().is_number() && figure.hi().is_number(),
            None => true,
        };
        let mut margin = self
            .margin
            .iter()
            .flat_map(|m| m.lo().into_iter().chain(m.hi()));
        margin.all(S::is_number)
            && self.dtau.is_positive() == Some(true)
            && self.figures().iter().all(defined)
    }

    /// −F·Δξ, what the passivity observer adds, with enclosed numbers at their lower end: a count as it is.
    pub(crate) fn observed(&self) -> S {
        if self.rests {
            return S::zero();
        }
        let [force, from, to] = [self.held.lo(), self.xi0.lo(), self.xi1.lo()].map(S::clone);
        -(force * (to - from))
    }

    /// What friction took less what was generated against the linear spring, whatever a storage gained: at
    /// the least and at the most.
    pub(crate) fn kept(&self) -> [S; 2] {
        let (taken, generated) = (
            &self.account.dissipated_lower,
            &self.account.generated_linear,
        );
        [
            taken.lo().clone() - generated.hi().clone(),
            taken.hi().clone() - generated.lo().clone(),
        ]
    }

    /// The five figures that totals are kept of.
    pub(crate) const fn summed(&self) -> [&Figure<S>; 5] {
        let account = &self.account;
        [
            &account.generated_linear,
            &account.generated_quantized,
            &account.dissipated_lower,
            &account.net_linear,
            &account.net_quantized,
        ]
    }

    /// Whether sums have room for its figures.
    pub(crate) fn can_be_added(&self) -> bool {
        let has_room = |of: &Figure<S>| of.lo().below().is_some() && of.hi().above().is_some();
        self.summed().into_iter().all(has_room)
    }

    /// Adds these figures, `times` over; `None` when one is undefined.
    pub(crate) fn add_to(&self, sums: &mut [FigureSum; 5], times: u64) -> Option<()> {
        for (sum, figure) in sums.iter_mut().zip(self.summed()) {
            sum.add_times(figure, times)?;
        }
        Some(())
    }
}
