//! From margins to a verdict, for a rig and for a box of rigs.
//!
//! [`decide`] is generic; [`of_rig`] tries it on checked 128-bit fractions and falls back to big
//! integers, so the answer is exact on any size and fast on the sizes of data sheets.

use num_rational::BigRational;

use crate::criterion::Criterion;
use crate::fraction::Wide;
use crate::interval::{Interval, Truth};
use crate::rational::{to_fixed, to_wide};
use crate::region::Region;
use crate::rig::Rig;
use crate::scalar::{Ordered, Scalar};
use crate::start;

/// Up to which speed the criterion is asked to hold, in the units of the rig.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speeds<S> {
    /// At every speed.
    All,
    /// At every speed up to V > 0.
    UpTo(S),
    /// At every speed up to V, of which the square is known (TH-START).
    UpToSquared(S),
}

/// What the criterion says of one rig.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decision {
    /// The region of the (β, σ) plane, with the terms of the effects (TH-REGION).
    pub region: Region,
    /// Whether the criterion holds at the speeds that were asked for.
    pub holds: bool,
}

/// Region and truth of a criterion; `None` when a number is undefined.
#[must_use]
pub fn decide<S: Ordered>(criterion: &Criterion<S>, speeds: &Speeds<S>) -> Option<Decision> {
    let region = Region::of(criterion)?;
    let holds = match (region, speeds) {
        (Region::GloballyStable, _) => true,
        (Region::LocallyStable, Speeds::UpTo(v)) => criterion.margin(v).is_nonnegative()?,
        (Region::LocallyStable, Speeds::UpToSquared(v)) => start::holds_up_to(criterion, v)?,
        (_, _) => false,
    };
    Some(Decision { region, holds })
}

/// The decision for a rig of big rationals, exact whatever their size.
///
/// `None` only for a rig with a zero sampling period or stiffness.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Friction, Rig, Scalar};
/// use passivity_core::{effects::Effects, verdict::{self, Speeds}};
///
/// let half = BigRational::integer(1).half();
/// let rig = Rig::dimensionless(Friction::new(half.clone(), half), Effects::encoder());
/// assert!(verdict::of_rig(&rig, &Speeds::All).unwrap().holds); // equality is passive
/// ```
#[must_use]
pub fn of_rig(rig: &Rig<BigRational>, speeds: &Speeds<BigRational>) -> Option<Decision> {
    let fixed = rig.try_map(to_fixed).zip(speeds.try_map(to_fixed));
    if let Some(decision) = fixed.and_then(|(rig, speeds)| decide(&rig.criterion(), &speeds)) {
        return Some(decision);
    }
    let wide: (Rig<Wide>, Speeds<Wide>) = rig
        .try_map(|x| Some(to_wide(x)))
        .zip(speeds.try_map(|x| Some(to_wide(x))))?;
    decide(&wide.0.criterion(), &wide.1)
}

impl<S: Scalar> Speeds<S> {
    /// The same speeds with the number taken through `f`.
    pub fn try_map<U>(&self, f: impl Fn(&S) -> Option<U>) -> Option<Speeds<U>> {
        Some(match self {
            Self::All => Speeds::All,
            Self::UpTo(v) => Speeds::UpTo(f(v)?),
            Self::UpToSquared(v) => Speeds::UpToSquared(f(v)?),
        })
    }
}

/// A box of rigs: every parameter anywhere in its interval, independently of the others.
#[derive(Clone, Debug, PartialEq)]
pub struct RigBox<S = BigRational> {
    /// b.
    pub viscous: Interval<S>,
    /// c.
    pub coulomb: Interval<S>,
    /// K.
    pub stiffness: Interval<S>,
    /// T.
    pub period: Interval<S>,
    /// Δ, or the unit of length without an encoder.
    pub length: Interval<S>,
    /// Whether an encoder quantizes the position.
    pub encoder: bool,
    /// Whole samples of delay.
    pub delay: u16,
    /// B.
    pub damping: Option<Interval<S>>,
    /// F.
    pub force_step: Option<Interval<S>>,
}

impl<S: Ordered> RigBox<S> {
    /// The same box with every number taken through `f`, which must keep their order.
    pub fn map<U: Ordered>(&self, f: impl Fn(&S) -> U) -> RigBox<U> {
        let optional = |range: &Option<Interval<S>>| range.as_ref().map(|range| range.map(&f));
        RigBox {
            viscous: self.viscous.map(&f),
            coulomb: self.coulomb.map(&f),
            stiffness: self.stiffness.map(&f),
            period: self.period.map(&f),
            length: self.length.map(&f),
            encoder: self.encoder,
            delay: self.delay,
            damping: optional(&self.damping),
            force_step: optional(&self.force_step),
        }
    }

    /// The corner where the criterion is hardest to meet: least friction, most of all else.
    ///
    /// The one parameter that pulls both ways is T when there is virtual damping and an encoder
    /// (BΔ/T), so the criterion of the box is taken term by term in [`criteria`](Self::criteria).
    #[must_use]
    pub fn worst(&self) -> Rig<S> {
        self.corner(Interval::lo, Interval::hi)
    }

    /// The corner where the criterion is easiest to meet.
    #[must_use]
    pub fn best(&self) -> Rig<S> {
        self.corner(Interval::hi, Interval::lo)
    }

    fn corner(&self, friction: fn(&Interval<S>) -> &S, load: fn(&Interval<S>) -> &S) -> Rig<S> {
        Rig {
            viscous: friction(&self.viscous).clone(),
            coulomb: friction(&self.coulomb).clone(),
            stiffness: load(&self.stiffness).clone(),
            period: load(&self.period).clone(),
            length: load(&self.length).clone(),
            effects: crate::effects::Effects {
                encoder: self.encoder,
                delay: self.delay,
                damping: self.damping.as_ref().map(|i| load(i).clone()),
                force_step: self.force_step.as_ref().map(|i| load(i).clone()),
            },
        }
    }

    /// The criterion (11) at its hardest and at its easiest, term by term.
    ///
    /// Every rig of the box lies between the two. They are those of two corners, unless T, B and
    /// an encoder pull both ways: then they enclose.
    #[must_use]
    pub fn criteria(&self) -> (Criterion<S>, Criterion<S>) {
        let (worst, best) = (self.worst(), self.best());
        // BΔ/T is largest at the shortest period.
        let worst_coulomb = Rig {
            period: self.period.lo().clone(),
            ..worst.clone()
        };
        let best_coulomb = Rig {
            period: self.period.hi().clone(),
            ..best.clone()
        };
        let of = |viscous: &Rig<S>, coulomb: &Rig<S>| Criterion {
            viscous: viscous.criterion().viscous,
            coulomb: coulomb.criterion().coulomb,
        };
        (of(&worst, &worst_coulomb), of(&best, &best_coulomb))
    }

    /// Whether the criterion holds over the box at every speed asked for.
    ///
    /// The speed is given for the hardest and for the easiest end of its own interval.
    #[must_use]
    pub fn holds(&self, hardest: &Speeds<S>, easiest: &Speeds<S>) -> Option<Truth> {
        let (worst, best) = self.criteria();
        let at_worst = decide(&worst, hardest)?.holds;
        let at_best = decide(&best, easiest)?.holds;
        Some(Truth::over(at_worst, at_best))
    }

    /// The region of every rig of the box, or `None` when it depends.
    #[must_use]
    pub fn region(&self) -> Option<Region> {
        let (worst, best) = self.criteria();
        let region = Region::of(&worst)?;
        // The coefficients' signs grow with the rig, so equal ends have equal between only when
        // the signs agree; a region is a product of sign ranges and hence convex in that order.
        (Region::of(&best)? == region && same_signs(&worst, &best, region)).then_some(region)
    }
}

/// Whether no rig between the two criteria can leave `region`, which both are in.
fn same_signs<S: Ordered>(worst: &Criterion<S>, best: &Criterion<S>, region: Region) -> bool {
    // Mixed corners: the viscous term of one end with the coulomb term of the other.
    let mixed = [(worst, best), (best, worst)];
    mixed.iter().all(|(v, c)| {
        let corner = Criterion {
            viscous: v.viscous.clone(),
            coulomb: c.coulomb.clone(),
        };
        Region::of(&corner) == Some(region)
    })
}
