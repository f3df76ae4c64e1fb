//! The figures of a box of rigs, as enclosures that are exact where nothing has a tolerance.

use passivity_core::effects::Effects;
use passivity_core::verdict::RigBox;
use passivity_core::{Interval, Ordered, Region, Rig, Scalar, Truth, Wide, region};

/// A box of rigs whose figures are asked for.
pub(super) struct Figures<'a> {
    pub(super) rigs: &'a RigBox<Wide>,
}

impl Figures<'_> {
    /// μ for an inertia.
    pub(super) fn mu(&self, inertia: &Interval<Wide>) -> Interval<Wide> {
        let rigs = self.rigs;
        Interval::hull(rigs.worst().mu(inertia.lo()), rigs.best().mu(inertia.hi()))
    }

    /// The critical speed in SI units, where the region has one.
    pub(super) fn critical_speed(&self, region: Option<Region>) -> Option<Interval<Wide>> {
        let (worst, best) = self.rigs.criteria();
        let speed = region::critical_speed::<Wide>;
        match region? {
            Region::LocallyStable | Region::LimitCycles => {
                Some(Interval::hull(speed(&worst), speed(&best)))
            }
            Region::GloballyStable | Region::Unstable => None,
        }
    }

    /// What friction has to spare when the wall itself takes none, b − B and c − F/2 − BΔ/T.
    fn spare(&self) -> (Interval<Wide>, Interval<Wide>) {
        let without_wall = RigBox {
            stiffness: Interval::point(Wide::zero()),
            ..self.rigs.clone()
        };
        let (worst, best) = without_wall.criteria();
        (
            Interval::hull(worst.viscous, best.viscous),
            Interval::hull(worst.coulomb, best.coulomb),
        )
    }

    /// What the wall takes, in KT and KΔ: ½ + k, and ½ with an encoder.
    fn taken(&self) -> (Wide, Wide) {
        let wall = Effects {
            encoder: self.rigs.encoder,
            delay: self.rigs.delay,
            damping: None,
            force_step: None,
        };
        let cost = wall.cost();
        (cost.viscous, cost.coulomb)
    }

    /// The coefficients of the dimensionless criterion, β − ½ and σ − ½ less the effects'.
    fn coefficients(&self) -> (Interval<Wide>, Interval<Wide>) {
        let (viscous, coulomb) = self.spare();
        let (viscous_taken, coulomb_taken) = self.taken();
        let viscous_unit = product(&self.rigs.stiffness, &self.rigs.period);
        let force_unit = product(&self.rigs.stiffness, &self.rigs.length);
        (
            quotient(&viscous, &viscous_unit).map(|x| x.clone() - viscous_taken.clone()),
            quotient(&coulomb, &force_unit).map(|x| x.clone() - coulomb_taken.clone()),
        )
    }

    /// The smaller coefficient of the dimensionless criterion.
    pub(super) fn margin_at_all_speeds(&self) -> Interval<Wide> {
        let (viscous, coulomb) = self.coefficients();
        Interval::hull(
            viscous.lo().clone().min(coulomb.lo().clone()),
            viscous.hi().clone().min(coulomb.hi().clone()),
        )
    }

    /// The margin of (8), (β − ½) + (σ − ½)/v, at a speed in SI units; `None` where that may be 0.
    pub(super) fn margin_at(&self, speed: &Interval<Wide>) -> Option<Interval<Wide>> {
        let ticks = super::bounds::in_ticks(speed, self.rigs);
        if ticks.lo().is_positive() != Some(true) {
            return None;
        }
        let (viscous, coulomb) = self.coefficients();
        let coulomb = quotient(&coulomb, &ticks);
        Some(Interval::hull(
            viscous.lo().clone() + coulomb.lo().clone(),
            viscous.hi().clone() + coulomb.hi().clone(),
        ))
    }

    /// b ≥ KT/2 + B.
    pub(super) fn colgate(&self) -> Truth {
        self.over(|rig| {
            let damping = rig.effects.damping.clone().unwrap_or_else(Wide::zero);
            rig.viscous.clone() - rig.viscous_unit().half() - damping
        })
    }

    /// K ≤ min(2b/T, 2c/Δ); without an encoder K ≤ 2b/T.
    pub(super) fn abbott_okamura(&self) -> Truth {
        self.over(|rig| {
            let viscous = rig.viscous.clone() - rig.viscous_unit().half();
            let coulomb = rig.coulomb.clone() - rig.force_unit().half();
            // Both in one number: only its sign is used.
            if rig.effects.encoder {
                viscous.min(coulomb)
            } else {
                viscous
            }
        })
    }

    /// Whether a margin that friction raises and all else lowers is at least zero over the box.
    fn over(&self, margin: impl Fn(&Rig<Wide>) -> Wide) -> Truth {
        let holds = |rig: &Rig<Wide>| margin(rig).is_nonnegative() == Some(true);
        Truth::over(holds(&self.rigs.worst()), holds(&self.rigs.best()))
    }
}

/// The products of two intervals of non-negative numbers.
fn product(a: &Interval<Wide>, b: &Interval<Wide>) -> Interval<Wide> {
    Interval::hull(
        a.lo().clone() * b.lo().clone(),
        a.hi().clone() * b.hi().clone(),
    )
}

/// The quotients of an interval by one of positive numbers.
fn quotient(a: &Interval<Wide>, by: &Interval<Wide>) -> Interval<Wide> {
    let nonnegative = |x: &Wide| x.is_nonnegative() == Some(true);
    let least = if nonnegative(a.lo()) {
        by.hi()
    } else {
        by.lo()
    };
    let most = if nonnegative(a.hi()) {
        by.lo()
    } else {
        by.hi()
    };
    Interval::hull(
        a.lo().clone().over(least.clone()),
        a.hi().clone().over(most.clone()),
    )
}
