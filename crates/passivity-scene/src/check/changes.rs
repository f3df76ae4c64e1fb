//! How far each parameter can go, or has to go: the border of the criterion in each alone.

use passivity_core::verdict::RigBox;
use passivity_core::{BigRational, Interval, Ordered, Rig, Scalar, Wide, stiffness};

use super::report::{exact, non_negative};
use crate::scene::{Motion, Scene};

/// Whether a parameter must stay above its border or below it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Friction: at least the border.
    AtLeast,
    /// Stiffness, sampling period, encoder resolution, speed: at most the border.
    AtMost,
}

/// The border of one parameter, all others as they are: what to change, and by how much.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The key of the parameter.
    pub key: &'static str,
    /// Its name in words.
    pub name: &'static str,
    /// The SI unit of both figures; empty for a dimensionless one.
    pub unit: &'static str,
    /// What the parameter is now.
    pub now: Interval<BigRational>,
    /// Where the criterion is met with equality, for the speeds that the verdict asks for.
    pub border: Interval<BigRational>,
    /// On which side of the border the criterion holds.
    pub direction: Direction,
    /// Whether the parameter alone, moved to the worst end of `border`, makes the wall passive.
    pub suffices: bool,
}

/// The borders of every parameter that the criterion limits, with a speed bound or at all speeds.
///
/// `stiffest` is the border of the stiffness when V grows with it (TH-START), and so no quotient.
pub(super) fn changes(
    scene: &Scene,
    rigs: &RigBox<Wide>,
    speed: Option<&Interval<Wide>>,
    stiffest: Option<&Interval<Wide>>,
) -> Vec<Change> {
    // A bound of zero asks nothing of speed; the border is that of every speed.
    let positive = |v: &Wide| (v.is_positive() == Some(true)).then(|| v.clone());
    let worst = Corner {
        rig: rigs.worst(),
        speed: speed.and_then(|v| positive(v.hi())),
    };
    let best = Corner {
        rig: rigs.best(),
        speed: speed.and_then(|v| positive(v.lo())),
    };
    let mut changes = Vec::new();
    for (parameter, (key, name, unit)) in Parameter::ALL.into_iter().zip(names(scene.motion)) {
        let known = stiffest.filter(|_| parameter == Parameter::Stiffness);
        let border = match known {
            Some(border) => Some(border.clone()),
            None => parameter
                .border(&worst)
                .zip(parameter.border(&best))
                .map(|(a, b)| Interval::hull(a, b)),
        };
        let possible = |border: &Interval<Wide>| match parameter.direction() {
            Direction::AtLeast => true,
            // A wall, a period or a resolution of zero is none.
            Direction::AtMost => border.lo().is_positive() == Some(true),
        };
        let Some(border) = border.filter(possible) else {
            continue;
        };
        let hardest = match parameter.direction() {
            Direction::AtLeast => border.hi(),
            Direction::AtMost => border.lo(),
        };
        let now = Interval::hull(
            parameter.value(&worst.rig).clone(),
            parameter.value(&best.rig).clone(),
        );
        changes.push(Change {
            key,
            name,
            unit,
            now: exact(&now),
            direction: parameter.direction(),
            suffices: known.is_some() || worst.with(parameter, hardest).holds(),
            border: non_negative(border.lo(), border.hi()),
        });
    }
    changes
}

/// One end of the tolerances.
struct Corner {
    rig: Rig<Wide>,
    /// The speed bound, when there is one above zero.
    speed: Option<Wide>,
}

impl Corner {
    /// The same with one parameter at `x`, or at zero when that is below.
    fn with(&self, parameter: Parameter, x: &Wide) -> Self {
        let mut rig = self.rig.clone();
        let place = match parameter {
            Parameter::Viscous => &mut rig.viscous,
            Parameter::Coulomb => &mut rig.coulomb,
            Parameter::Stiffness => &mut rig.stiffness,
            Parameter::Period => &mut rig.period,
            Parameter::Resolution => &mut rig.length,
        };
        *place = x.clone().max(Wide::zero());
        Self {
            rig,
            speed: self.speed.clone(),
        }
    }

    /// Whether the criterion holds at every speed, or up to the bound.
    fn holds(&self) -> bool {
        let criterion = self.rig.criterion();
        let margin = match &self.speed {
            Some(v) => criterion.margin_up_to(v),
            None => criterion.margin_at_all_speeds(),
        };
        margin.is_nonnegative() == Some(true)
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Parameter {
    Viscous,
    Coulomb,
    Stiffness,
    Period,
    Resolution,
}

impl Parameter {
    const ALL: [Self; 5] = [
        Self::Viscous,
        Self::Coulomb,
        Self::Stiffness,
        Self::Period,
        Self::Resolution,
    ];

    const fn direction(self) -> Direction {
        match self {
            Self::Viscous | Self::Coulomb => Direction::AtLeast,
            Self::Stiffness | Self::Period | Self::Resolution => Direction::AtMost,
        }
    }

    /// Where the criterion is met with equality, at every speed or at every speed up to a bound.
    fn border(self, corner: &Corner) -> Option<Wide> {
        let rig = &corner.rig;
        match (self, &corner.speed) {
            (Self::Viscous, None) => Some(stiffness::viscous_needed(rig)),
            (Self::Viscous, Some(v)) => Some(stiffness::viscous_needed_at_speed(rig, v)),
            (Self::Coulomb, None) => Some(stiffness::coulomb_needed(rig)),
            (Self::Coulomb, Some(v)) => Some(stiffness::coulomb_needed_up_to_speed(rig, v)),
            (Self::Stiffness, None) => Some(stiffness::limit_at_all_speeds(rig)),
            (Self::Stiffness, Some(v)) => Some(stiffness::limit_up_to_speed(rig, v)),
            (Self::Period, None) => Some(stiffness::longest_period(rig)),
            (Self::Period, Some(v)) => Some(stiffness::longest_period_at_speed(rig, v)),
            (Self::Resolution, None) => stiffness::coarsest_resolution(rig),
            (Self::Resolution, Some(v)) => stiffness::coarsest_resolution_up_to_speed(rig, v),
        }
    }

    const fn value(self, rig: &Rig<Wide>) -> &Wide {
        match self {
            Self::Viscous => &rig.viscous,
            Self::Coulomb => &rig.coulomb,
            Self::Stiffness => &rig.stiffness,
            Self::Period => &rig.period,
            Self::Resolution => &rig.length,
        }
    }
}

/// Key, name and SI unit of each parameter, in the order of [`Parameter::ALL`].
const fn names(motion: Motion) -> [(&'static str, &'static str, &'static str); 5] {
    match motion {
        Motion::Linear => [
            ("device.viscous", "viscous friction b", "N s/m"),
            ("device.coulomb", "Coulomb friction c", "N"),
            ("wall.stiffness", "stiffness K", "N/m"),
            ("sampling.period", "sampling period T", "s"),
            ("encoder.resolution", "encoder resolution Δ", "m"),
        ],
        Motion::Rotary => [
            ("device.viscous", "viscous friction b", "N m s/rad"),
            ("device.coulomb", "Coulomb friction c", "N m"),
            ("wall.stiffness", "stiffness K", "N m/rad"),
            ("sampling.period", "sampling period T", "s"),
            ("encoder.resolution", "encoder resolution Δ", "rad"),
        ],
        Motion::Dimensionless => [
            ("dimensionless.beta", "effective viscous friction β", ""),
            ("dimensionless.sigma", "effective Coulomb friction σ", ""),
            ("wall.stiffness", "stiffness, as a factor of what it is", ""),
            (
                "sampling.period",
                "sampling period, as a factor of what it is",
                "",
            ),
            (
                "encoder.resolution",
                "encoder resolution, as a factor of what it is",
                "",
            ),
        ],
    }
}
