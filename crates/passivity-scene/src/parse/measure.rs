//! What each key measures: its units, for a linear and for a rotary device.

use passivity_core::parameter;

use crate::scene::Motion;
use crate::units::{Dimension, Unit};

/// A kind of quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// A mass or a moment of inertia.
    Inertia,
    /// A mass, never a moment of inertia.
    Mass,
    /// Force or torque per speed.
    Viscous,
    /// Force or torque.
    Force,
    /// Force or torque per displacement.
    Stiffness,
    /// Length or angle.
    Position,
    /// Displacement per time.
    Speed,
    Time,
    Rate,
}

const FORCE: Dimension = Dimension::new(1, 1, -2, 0);
const TORQUE: Dimension = Dimension::new(1, 2, -2, 0);

/// What a row of the table says: the dimension for each motion, the powers of the angle that a
/// rotary one may carry (`N m s` is as good as `N m s/rad`), and an example of each.
struct Row {
    linear: Dimension,
    rotary: Dimension,
    angles: &'static [i8],
    examples: [&'static str; 2],
    words: [&'static str; 2],
}

impl Measure {
    /// What a parameter with this unit measures.
    pub(super) fn of(unit: parameter::Unit) -> Self {
        match unit {
            parameter::Unit::INERTIA => Self::Inertia,
            parameter::Unit::VISCOUS => Self::Viscous,
            parameter::Unit::FORCE => Self::Force,
            parameter::Unit::POSITION => Self::Position,
            parameter::Unit::SPEED => Self::Speed,
            parameter::Unit::TIME => Self::Time,
            // No parameter has another unit; a test looks at each.
            _ => Self::Stiffness,
        }
    }

    const fn row(self) -> Row {
        match self {
            Self::Inertia => Row {
                linear: Dimension::new(1, 0, 0, 0),
                rotary: Dimension::new(1, 2, 0, 0),
                angles: &[0, -1, -2],
                examples: ["0.075 kg", "6.28e-6 kg m^2"],
                words: ["a mass", "a moment of inertia"],
            },
            Self::Mass => Row {
                rotary: Dimension::new(1, 0, 0, 0),
                angles: &[],
                examples: ["0.075 kg", "0.075 kg"],
                words: ["a mass", "a mass"],
                ..Self::Inertia.row()
            },
            Self::Viscous => Row {
                linear: Dimension::new(1, 0, -1, 0),
                rotary: Dimension::new(1, 2, -1, 0),
                angles: &[-1, 0],
                examples: ["0.5 N s/m", "9e-6 N m s/rad"],
                words: ["a linear damping", "a rotary damping"],
            },
            Self::Force => Row {
                linear: FORCE,
                rotary: TORQUE,
                angles: &[0],
                examples: ["0.04 N", "2e-3 N m"],
                words: ["a force", "a torque"],
            },
            Self::Stiffness => Row {
                linear: Dimension::new(1, 0, -2, 0),
                rotary: TORQUE,
                angles: &[-1],
                examples: ["1 N/mm", "2 N m/rad"],
                words: ["a linear stiffness", "a torsional stiffness"],
            },
            Self::Position => Row {
                linear: Dimension::new(0, 1, 0, 0),
                rotary: Dimension::NONE,
                angles: &[1],
                examples: ["0.03 mm", "0.1 deg"],
                words: ["a length", "an angle"],
            },
            Self::Speed => Row {
                linear: Dimension::new(0, 1, -1, 0),
                rotary: Dimension::new(0, 0, -1, 0),
                angles: &[1],
                examples: ["0.2 m/s", "10 rad/s"],
                words: ["a speed", "an angular speed"],
            },
            Self::Time => Row {
                linear: Dimension::new(0, 0, 1, 0),
                rotary: Dimension::new(0, 0, 1, 0),
                angles: &[],
                examples: ["1 ms", "1 ms"],
                words: ["a time", "a time"],
            },
            Self::Rate => Row {
                linear: Dimension::new(0, 0, -1, 0),
                rotary: Dimension::new(0, 0, -1, 0),
                angles: &[],
                examples: ["1 kHz", "1 kHz"],
                words: ["a rate", "a rate"],
            },
        }
    }

    /// Whether a dimension fits, and the motion that it tells of; times tell of none.
    pub(super) fn accepts(self, dimension: Dimension) -> Option<Option<Motion>> {
        let row = self.row();
        let is_rotary = |angle: &i8| row.rotary.with_angle(*angle) == dimension;
        if row.linear == dimension {
            let tells = self.tells_motion() || self == Self::Mass;
            return Some(tells.then_some(Motion::Linear));
        }
        row.angles
            .iter()
            .any(is_rotary)
            .then_some(Some(Motion::Rotary))
    }

    /// The motion that a unit tells of, where it fits, and the weight that it stands for where that is what fits.
    pub(super) fn reads(self, unit: &Unit) -> Option<(Option<Motion>, Option<Unit>)> {
        if let Some(motion) = self.accepts(unit.dimension()) {
            return Some((motion, None));
        }
        let weight = self.weight(unit)?;
        let motion = self.accepts(weight.dimension())?;
        Some((motion, Some(weight)))
    }

    /// The unit with its masses as weights, where data sheets mean that: not for a bare mass, which may
    /// be a slip of the key.
    pub(super) fn weight(self, unit: &Unit) -> Option<Unit> {
        let bare = Self::Mass.row().linear;
        unit.as_weight().filter(|_| unit.dimension() != bare)
    }

    const fn tells_motion(self) -> bool {
        !matches!(self, Self::Time | Self::Rate | Self::Mass)
    }

    /// What was expected, with examples: of one motion when it is known.
    pub(super) fn expected(self, motion: Option<Motion>) -> String {
        let row = self.row();
        let [linear, rotary] = row.words;
        let [first, second] = row.examples;
        match motion {
            _ if !self.tells_motion() => format!("{linear} such as `\"{first}\"`"),
            Some(Motion::Linear) => format!("{linear} such as `\"{first}\"`"),
            Some(Motion::Rotary) => format!("{rotary} such as `\"{second}\"`"),
            _ => format!("{linear} such as `\"{first}\"` or {rotary} such as `\"{second}\"`"),
        }
    }
}

/// What a dimension measures, in words, when it is one of those in a scene.
pub(super) fn describe(dimension: Dimension) -> String {
    const ALL: [Measure; 8] = [
        Measure::Force,
        Measure::Stiffness,
        Measure::Viscous,
        Measure::Inertia,
        Measure::Position,
        Measure::Speed,
        Measure::Time,
        Measure::Rate,
    ];
    for measure in ALL {
        let [linear, rotary] = measure.row().words;
        match measure.accepts(dimension) {
            Some(Some(Motion::Rotary)) => return rotary.to_owned(),
            Some(_) => return linear.to_owned(),
            None => {}
        }
    }
    if dimension == Dimension::NONE {
        "a plain number".to_owned()
    } else {
        format!("something in {dimension}")
    }
}
