//! Limits of the parameters of a device of several joints, one at a time (CHECK-LIMITS).

use num_traits::Signed as _;
use passivity_core::joint_criterion::Asked;
use passivity_core::joints::{Joints, Place};
use passivity_core::parameter::Hurts;
use passivity_core::verdict::End;
use passivity_core::{Enclosed, Interval, Parameter};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use super::JointScene;
use crate::check::{Limit, LimitFigures, Side, figure, typed_back, unit_of};
use crate::display::Rounding;
use crate::written::Written;

/// The limit of one parameter of a device of several joints, all others as they are.
#[derive(Clone, Debug, PartialEq)]
pub struct JointLimit {
    /// Its key in the scene file, of a joint with the joint's number, as in `joint[2].coulomb`.
    pub key: String,
    /// Which parameter it is.
    pub place: Place,
    /// The limit, as that of a device of one joint.
    pub limit: Limit,
}

/// How a limit looks in JSON.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "JointLimit")]
pub(super) struct JointLimitShape<'a> {
    /// The key of the parameter in a scene file, of which the figures are values in SI: of a joint with its
    /// number from 1, as in `joint[2].coulomb`. Those of `wall.stiffness_matrix` are factors of the matrix.
    parameter: String,
    #[serde(flatten)]
    figures: LimitFigures<'a>,
}

impl JointLimit {
    /// The key of which the figures in SI are values: a rate, or counts, is another form of them.
    fn si_key(&self) -> String {
        let name = match self.place.parameter {
            Parameter::Period => "period",
            Parameter::Resolution => "resolution",
            _ => return self.key.clone(),
        };
        let section = self.key.rsplit_once('.').map_or("", |(section, _)| section);
        format!("{section}.{name}")
    }
}

impl Serialize for JointLimit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let shape = JointLimitShape {
            parameter: self.si_key(),
            figures: LimitFigures::of(&self.limit),
        };
        shape.serialize(serializer)
    }
}

/// The limits of all parameters that the criterion limits, at the speeds asked for.
pub(super) fn limits<S: Enclosed>(
    scene: &JointScene,
    bounds: &Joints<Interval<S>, S>,
    asked: Asked,
) -> Vec<JointLimit> {
    let of = |place| limit(place, scene, bounds, asked);
    let mut limits: Vec<JointLimit> = bounds.places().filter_map(of).collect();
    // Of a joint that needs no friction nothing is said.
    limits
        .retain(|limit| limit.limit.side == Side::AtMost || limit.limit.border.hi().is_positive());
    limits
}

/// The limit of one parameter; `None` where the criterion does not limit it, or where no value of it
/// is enough.
fn limit<S: Enclosed>(
    place: Place,
    scene: &JointScene,
    bounds: &Joints<Interval<S>, S>,
    asked: Asked,
) -> Option<JointLimit> {
    let (side, rounding) = match place.parameter.row().hurts {
        Hurts::Less => (Side::AtLeast, Rounding::Up),
        Hurts::More => (Side::AtMost, Rounding::Down),
        Hurts::Neither => return None,
    };
    // An encoder or a bound that is not there has no limit.
    let default = place.parameter.row().default;
    let now = match bounds.get(place) {
        Some(now) => now.clone(),
        None => Interval::point(S::integer(default?)),
    };
    let [hardest, easiest] = bounds.border(place, asked)?;
    if side == Side::AtMost && !hardest.is_positive()? {
        return None;
    }
    let suffices = |x: &S| {
        let moved = bounds.clone().with(place, Interval::point(x.clone()));
        moved.at(End::Hardest).holds(asked) == Some(true)
    };
    let motion = scene.motion(place);
    let written = match scene.given.get(place) {
        Some(given) => given.written.clone(),
        None => Written::si(unit_of(place.parameter, motion)),
    };
    let limit = Limit {
        parameter: place.parameter,
        now: figure(&now)?,
        suffices: suffices(&hardest),
        border: figure(&Interval::hull(hardest, easiest))?,
        side,
        printed: None,
        written,
        typed: None,
        far: None,
    };
    let border = limit.hardest();
    // Where the border itself is not enough, something else is missing.
    let typed_back = |written| match limit.suffices {
        true => typed_back(written, border, rounding, suffices),
        false => None,
    };
    let [printed, typed] = [&Written::si(""), &limit.written].map(typed_back);
    Some(JointLimit {
        key: scene.key(place),
        place,
        limit: Limit {
            printed,
            typed,
            ..limit
        },
    })
}

/// The largest stiffness at the speeds asked for, or the largest factor of a matrix, from the hardest to
/// the easiest end of the tolerances; 0 where there is none, `None` where there is no largest.
pub(super) fn stiffest<S: Enclosed>(
    bounds: &Joints<Interval<S>, S>,
    asked: Asked,
) -> Option<Interval<S>> {
    let place = Place {
        parameter: Parameter::Stiffness,
        joint: None,
    };
    let [hardest, easiest] = bounds.border(place, asked)?;
    Some(Interval::hull(hardest, easiest))
}
