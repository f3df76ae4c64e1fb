//! Devices of several joints: their scenes, and what `check` and `explain` answer for them (TH-NDOF).

mod explain;
mod limits;
mod report;
mod text;

pub use explain::{JointExplanation, explain};
pub use limits::JointLimit;
pub use report::{JointReport, JointWitness, OfJoint, check};

use num_traits::Zero as _;
use passivity_core::joints::{Joints, Place};
use passivity_core::{Effect, Exact, Interval, Parameter};

use crate::scene::{Given, Motion};

/// How far the wall moves for a unit of a joint, or an entry of its matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// The value in SI units.
    pub value: Exact,
    /// Its text in the file.
    pub text: String,
}

/// A device of several joints, its control loop and a virtual wall.
#[derive(Clone, Debug, PartialEq)]
pub struct JointScene {
    /// The file's name without folder and extension, or what `name` in it says.
    pub name: String,
    /// How the wall moves, of which the stiffness tells; [`Motion::Dimensionless`] for one that is given
    /// as a matrix, whose factor is a plain number.
    pub wall: Motion,
    /// What the joints are called, where the file says it.
    pub names: Vec<Option<String>>,
    /// How each joint moves.
    pub motions: Vec<Motion>,
    /// The direction of the wall as it was given; empty for a matrix.
    pub ways: Vec<Way>,
    /// The parameters as they were given. Of a wall that is given as a matrix the stiffness is the
    /// number 1, the factor of the matrix.
    pub given: Joints<Given, Exact>,
}

impl JointScene {
    /// The effects in the scene, in the order in which they are listed everywhere.
    #[must_use]
    pub fn effects(&self) -> Vec<Effect> {
        let any = |has: fn(&passivity_core::joints::Joint<Given>) -> bool| {
            self.given.joints.iter().any(has)
        };
        let mut effects = Vec::new();
        for effect in Effect::ALL {
            let has = match effect {
                Effect::Hold => true,
                Effect::Viscous => any(|joint| joint.viscous.is_some()),
                Effect::Coulomb => any(|joint| joint.coulomb.is_some()),
                Effect::Encoder => any(|joint| joint.resolution.is_some()),
                Effect::Unilateral => self.given.unilateral,
                // A scene of several joints that has another is refused when it is read.
                _ => false,
            };
            if has {
                effects.push(effect);
            }
        }
        effects
    }

    /// The values that each parameter may have, in SI units: the box that verdicts are made of.
    #[must_use]
    pub fn bounds(&self) -> Joints<Interval<Exact>, Exact> {
        let bounds = self.given.try_map(|_, given| Some(given.value.clone()));
        bounds.unwrap_or_else(|| unreachable!("every parameter that is given has values"))
    }

    /// Whether the wall is given as a matrix.
    #[must_use]
    pub fn has_matrix(&self) -> bool {
        self.ways.is_empty()
    }

    /// A parameter's key in the scene file; of a joint with its number, from 1, as in `joint[2].viscous`.
    #[must_use]
    pub fn key(&self, place: Place) -> String {
        let key = match self.given.get(place) {
            Some(_) if place.parameter == Parameter::Stiffness && self.has_matrix() => {
                "wall.stiffness_matrix"
            }
            Some(given) => given.key,
            None => place.parameter.row().key,
        };
        match (place.joint, key.split_once('.')) {
            (Some(joint), Some((_, key))) => format!("joint[{}].{key}", joint + 1),
            (_, _) => key.to_owned(),
        }
    }

    /// A joint in words: its number from 1 and its name.
    #[must_use]
    pub fn joint_text(&self, joint: usize) -> String {
        match self.names.get(joint) {
            Some(Some(name)) => format!("joint {} ({name})", joint + 1),
            _ => format!("joint {}", joint + 1),
        }
    }

    /// How a parameter's unit moves: as its joint does, or as the wall.
    #[must_use]
    pub fn motion(&self, place: Place) -> Motion {
        match (place.joint, place.parameter) {
            (Some(joint), _) => self.motions.get(joint).copied().unwrap_or(Motion::Rotary),
            (None, Parameter::Stiffness) => self.wall,
            (None, _) => Motion::Rotary,
        }
    }

    /// How values of the file were taken, where a reader could have taken them otherwise.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        let of = |place: Place| self.given.get(place)?.remark.clone();
        self.given.places().filter_map(of).collect()
    }

    /// Whether a parameter has a tolerance.
    pub(super) fn has_tolerance(&self, place: Place) -> bool {
        self.given.get(place).is_some_and(Given::has_tolerance)
    }

    /// Whether every way of the wall is zero but that of one joint.
    #[must_use]
    pub fn acts_on(&self, joint: usize) -> bool {
        self.ways
            .get(joint)
            .is_none_or(|way| way.value.to_rational().is_none_or(|x| !x.is_zero()))
    }
}
