//! Every figure of a check of several joints: one type for programs and people.

use num_traits::Zero as _;
use passivity_core::joint_criterion::Asked;
use passivity_core::joint_cycle::JointCycle;
use passivity_core::joints::{Joint, Joints, Place, Shape};
use passivity_core::parameter::Hurts;
use passivity_core::verdict::End;
use passivity_core::{BigRational, Effect, Enclosed, Interval, Parameter, Truth, Wide};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use super::JointScene;
use super::limits::{self, JointLimit};
use crate::check::{BITS, Verdict, figure, unit_of};
use crate::json::shape;
use crate::scene::Motion;
use crate::written::Written;

/// What is asked of a joint, and what it has.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OfJoint {
    /// What the joint is called, where the scene says it.
    pub name: Option<String>,
    /// `linear` or `rotary`: SI units are those of metres and newtons, or of radians and newton metres.
    pub motion: &'static str,
    /// b; 0 without viscous friction.
    #[serde(with = "shape::Interval")]
    pub viscous: Interval<BigRational>,
    /// c; 0 without Coulomb friction.
    #[serde(with = "shape::Interval")]
    pub coulomb: Interval<BigRational>,
    /// Δ of the encoder.
    #[serde(with = "shape::OptionalInterval")]
    pub resolution: Option<Interval<BigRational>>,
    /// The bound on the joint's speed.
    #[serde(with = "shape::OptionalInterval")]
    pub max_speed: Option<Interval<BigRational>>,
    /// ½Σⱼ|Kᵢⱼ|Δⱼ: the Coulomb friction that the encoders ask of the joint at every speed.
    #[serde(with = "shape::Interval")]
    pub coulomb_needed: Interval<BigRational>,
    /// c less that.
    #[serde(with = "shape::Interval")]
    pub spare_coulomb: Interval<BigRational>,
    /// The unit in which the scene gives Coulomb friction.
    #[serde(skip)]
    pub coulomb_written: Written,
}

/// A motion of the joints that draws energy each time round (TH-NDOF).
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointWitness {
    /// The unit of each joint in `from` and `moves`: `ticks` of its encoder, or `rad` or `m` without one.
    pub units: Vec<&'static str>,
    /// Where the joints start, a sampling instant.
    #[serde(serialize_with = "crate::check::rationals")]
    #[schemars(with = "Vec<shape::Rational>")]
    pub from: Vec<BigRational>,
    /// Displacements of the joints, one list a sampling interval, each at constant speed; after the last
    /// one they are where they started.
    #[serde(serialize_with = "moves")]
    #[schemars(with = "Vec<Vec<shape::Rational>>")]
    pub moves: Vec<Vec<BigRational>>,
    /// What the operator gains at least each time round, in joules.
    #[serde(with = "shape::Rational")]
    pub gain_per_cycle: BigRational,
}

/// Figures of a device of one joint that have no counterpart here: all null.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct OneJointOnly {
    region: (),
    mu: (),
    beta: (),
    sigma: (),
    cost: (),
    spare: (),
    critical_speed: (),
    critical_speed_si: (),
    speed_bound: (),
    speed_bound_si: (),
    margin_at_speed_bound: (),
    colgate: (),
    abbott_okamura: (),
    unforced: (),
}

/// What a check found out about a scene of several joints.
///
/// Serialised it is one of the `scenes` of `check --format json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointReport {
    /// The scene's name.
    pub scene: String,
    /// How the wall moves: it fixes the unit of its stiffness.
    #[serde(skip)]
    pub wall: Motion,
    /// The unit in which the scene gives the stiffness.
    #[serde(skip)]
    pub stiffness_written: Written,
    /// The direction of the wall as the scene writes it; empty for a matrix.
    #[serde(skip)]
    pub direction_texts: Vec<String>,
    /// The verdict, about any operator.
    pub verdict: Verdict,
    /// Whether the criterion holds at every speed, also where joints have bounds on their speed.
    pub at_every_speed: bool,
    /// Whether joints have bounds on their speed that the verdict may use.
    pub is_bounded: bool,
    /// The ids of the theorems that the verdict rests on.
    pub because: Vec<&'static str>,
    /// The effects in the scene.
    #[serde(with = "shape::Effects")]
    pub effects: Vec<Effect>,
    /// How values of the file were taken, where a reader could have taken them otherwise.
    pub remarks: Vec<String>,
    /// The effects that no theorem covers: none, a scene with one is refused.
    #[serde(with = "shape::Effects")]
    pub not_covered: Vec<Effect>,
    /// The joints, in the order of the file.
    pub joints: Vec<OfJoint>,
    /// Whether diag(b) − (T/2)𝐊 is positive semidefinite; null where it depends on the tolerances.
    pub viscous_definite: Option<bool>,
    /// The direction of the wall, a = Jᵀn, in SI units; null for a matrix.
    #[serde(serialize_with = "optional_intervals")]
    #[schemars(with = "Option<Vec<shape::Interval>>")]
    pub direction: Option<Vec<Interval<BigRational>>>,
    /// The stiffest wall along the direction at every speed, SI; 0 when there is none, null for a matrix
    /// and where there is no stiffest.
    #[serde(with = "shape::OptionalInterval")]
    pub max_stiffness_all_speeds: Option<Interval<BigRational>>,
    /// The same at every speed up to the bounds of the joints; null without bounds.
    #[serde(with = "shape::OptionalInterval")]
    pub max_stiffness_at_speed_bound: Option<Interval<BigRational>>,
    /// The largest factor of the stiffness matrix at the speeds that the headline speaks of; null for a
    /// direction.
    #[serde(with = "shape::OptionalInterval")]
    pub max_matrix_factor: Option<Interval<BigRational>>,
    /// A motion that draws energy, where the verdict is that the wall is not passive.
    pub witness: Option<JointWitness>,
    /// The keys of the parameters whose tolerance decides, when the verdict depends.
    pub decided_by: Vec<String>,
    /// How far each parameter can go, or has to go, at the speeds that the headline speaks of.
    #[schemars(with = "Vec<limits::JointLimitShape<'static>>")]
    pub limits: Vec<JointLimit>,
    /// The limits' names, by joint.
    #[serde(skip)]
    pub joint_names: Vec<String>,
    /// Figures of a device of one joint that have no counterpart here.
    #[serde(flatten)]
    pub one_joint_only: OneJointOnly,
}

/// Checks a scene of several joints.
///
/// # Example
///
/// ```
/// use passivity_scene::{AnyScene, check::Verdict};
///
/// let text = r#"
///     [[joint]]
///     viscous = "0.01 N m s/rad"
///     coulomb = "0.02 N m"
///     encoder = { counts_per_revolution = 4096 }
///     [[joint]]
///     viscous = "0.01 N m s/rad"
///     coulomb = "0.02 N m"
///     encoder = { counts_per_revolution = 4096 }
///     [sampling]
///     rate = "1 kHz"
///     [wall]
///     stiffness = "100 N/m"
///     direction = ["0.2 m/rad", "0.1 m/rad"]
/// "#;
/// let AnyScene::Joints(scene) = AnyScene::from_toml("arm", text).unwrap() else { panic!() };
/// assert_eq!(passivity_scene::joints::check(&scene).verdict, Verdict::Passive);
/// ```
#[must_use]
pub fn check(scene: &JointScene) -> JointReport {
    let bounds = scene.bounds();
    // Where there is no π, plain fractions do, and faster.
    let shape = bounds.shape.try_map(Wide::of);
    let rational = bounds.try_map(|_, range| range.try_map(Wide::of));
    let report = match rational.zip(shape) {
        Some((rational, shape)) => checked(scene, &rational.reshaped(shape)),
        None => checked(scene, &bounds),
    };
    report.unwrap_or_else(|| {
        unreachable!("the figures of a scene are defined: its units are above zero")
    })
}

/// The report, or `None` where a figure is undefined.
fn checked<S: Enclosed>(
    scene: &JointScene,
    bounds: &Joints<Interval<S>, S>,
) -> Option<JointReport> {
    let unbounded = bounds.decide(Asked::EverySpeed);
    let at_every_speed = unbounded == Truth::Holds;
    let is_bounded = bounds.is_bounded()?;
    let asked = if at_every_speed || !is_bounded {
        Asked::EverySpeed
    } else {
        Asked::UpToBounds
    };
    let truth = bounds.decide(asked);
    let cycle = match truth {
        Truth::Fails => bounds.find_cycle(),
        Truth::Holds | Truth::Depends => None,
    };
    let verdict = match truth {
        Truth::Holds => Verdict::Passive,
        Truth::Depends => Verdict::Depends,
        Truth::Fails if cycle.is_some() => Verdict::NotPassive,
        Truth::Fails => Verdict::NotGuaranteed,
    };
    let optional = |range: Option<Interval<S>>| match range {
        Some(range) => figure(&range).map(Some),
        None => Some(None),
    };
    let is_direction = !scene.has_matrix();
    let stiffest = |asked, wanted: bool| {
        let range = wanted.then(|| limits::stiffest(bounds, asked)).flatten();
        optional(range)
    };
    let mut because = vec!["TH-NDOF"];
    if scene.given.unilateral {
        because.push("TH-UNI");
    }
    Some(JointReport {
        scene: scene.name.clone(),
        wall: scene.wall,
        stiffness_written: scene.given.stiffness.written.clone(),
        direction_texts: scene.ways.iter().map(|way| way.text.clone()).collect(),
        verdict,
        at_every_speed,
        is_bounded,
        because,
        effects: scene.effects(),
        remarks: remarks(scene, bounds, is_bounded),
        not_covered: Vec::new(),
        joints: of_joints(scene, bounds)?,
        viscous_definite: match bounds.decide_viscous() {
            Truth::Holds => Some(true),
            Truth::Fails => Some(false),
            Truth::Depends => None,
        },
        direction: match &bounds.shape {
            Shape::Matrix(_) => None,
            Shape::Direction(a) => {
                let point = |x: &S| figure(&Interval::point(x.clone()));
                Some(a.iter().map(point).collect::<Option<_>>()?)
            }
        },
        max_stiffness_all_speeds: stiffest(Asked::EverySpeed, is_direction)?,
        max_stiffness_at_speed_bound: stiffest(Asked::UpToBounds, is_direction && is_bounded)?,
        max_matrix_factor: stiffest(asked, !is_direction)?,
        witness: match cycle {
            Some(cycle) => Some(witness(scene, cycle)?),
            None => None,
        },
        decided_by: match verdict {
            Verdict::Depends => deciding(scene, bounds, asked),
            _ => Vec::new(),
        },
        limits: limits::limits(scene, bounds, asked),
        joint_names: (0..scene.motions.len())
            .map(|joint| scene.joint_text(joint))
            .collect(),
        one_joint_only: OneJointOnly::default(),
    })
}

fn remarks<S: Enclosed>(
    scene: &JointScene,
    bounds: &Joints<Interval<S>, S>,
    is_bounded: bool,
) -> Vec<String> {
    let mut remarks = scene.remarks();
    let has_bound = bounds.joints.iter().any(|joint| joint.max_speed.is_some());
    if has_bound && !is_bounded {
        remarks.push(
            "the criterion does not use `max_speed`: the wall couples a joint that has one to a joint \
             without; only a motion that is shown to draw energy keeps to it"
                .to_owned(),
        );
    }
    remarks
}

/// What is asked of each joint and what it has, from the least to the most over the tolerances.
fn of_joints<S: Enclosed>(
    scene: &JointScene,
    bounds: &Joints<Interval<S>, S>,
) -> Option<Vec<OfJoint>> {
    let [hardest, easiest] = [End::Hardest, End::Easiest].map(|end| bounds.at(end));
    let needed = easiest
        .coulomb_needed()
        .into_iter()
        .zip(hardest.coulomb_needed());
    let spare = hardest
        .spare_coulomb()
        .into_iter()
        .zip(easiest.spare_coulomb());
    let zero = || Interval::point(BigRational::zero());
    let given = |range: &Option<Interval<S>>| match range {
        Some(range) => figure(range).map(Some),
        None => Some(None),
    };
    let mut joints = Vec::new();
    for (at, ((joint, needed), spare)) in bounds.joints.iter().zip(needed).zip(spare).enumerate() {
        let place = Place {
            parameter: Parameter::Coulomb,
            joint: Some(at),
        };
        let motion = scene.motion(place);
        let Joint {
            viscous,
            coulomb,
            resolution,
            max_speed,
        } = joint;
        joints.push(OfJoint {
            name: scene.names.get(at)?.clone(),
            motion: match motion {
                Motion::Linear => "linear",
                Motion::Rotary | Motion::Dimensionless => "rotary",
            },
            viscous: given(viscous)?.unwrap_or_else(zero),
            coulomb: given(coulomb)?.unwrap_or_else(zero),
            resolution: given(resolution)?,
            max_speed: given(max_speed)?,
            coulomb_needed: figure(&Interval::hull(needed.0, needed.1))?,
            spare_coulomb: figure(&Interval::hull(spare.0, spare.1))?,
            coulomb_written: match scene.given.get(place) {
                Some(given) => given.written.clone(),
                None => Written::si(unit_of(Parameter::Coulomb, motion)),
            },
        });
    }
    Some(joints)
}

fn witness<S: Enclosed>(scene: &JointScene, cycle: JointCycle<S>) -> Option<JointWitness> {
    let unit =
        |(joint, motion): (&Joint<crate::scene::Given>, &Motion)| match (&joint.resolution, motion)
        {
            (Some(_), _) => "ticks",
            (None, Motion::Linear) => "m",
            (None, _) => "rad",
        };
    let joints = scene.given.joints.iter().zip(&scene.motions);
    let back = cycle.step.iter().map(|x| -x).collect();
    Some(JointWitness {
        units: joints.map(unit).collect(),
        from: cycle.from,
        moves: vec![cycle.step, back],
        gain_per_cycle: cycle.gain.enclosed(BITS)?.lo().clone(),
    })
}

/// The keys of the parameters whose tolerance alone flips the verdict, with all others at their hardest
/// or all at their easiest; where none does alone, all that have a tolerance.
fn deciding<S: Enclosed>(
    scene: &JointScene,
    bounds: &Joints<Interval<S>, S>,
    asked: Asked,
) -> Vec<String> {
    let is_toleranced = |place: &Place| {
        scene.has_tolerance(*place) && place.parameter.row().hurts != Hurts::Neither
    };
    let toleranced: Vec<Place> = bounds.places().filter(is_toleranced).collect();
    let alone = |place: &&Place| {
        [End::Hardest, End::Easiest].into_iter().any(|end| {
            let pinned = bounds.try_map(|other, range| {
                Some(match other == **place {
                    true => range.clone(),
                    false => Interval::point(end.of(other.parameter, range).clone()),
                })
            });
            pinned.is_some_and(|pinned| pinned.decide(asked) == Truth::Depends)
        })
    };
    let decisive: Vec<&Place> = toleranced.iter().filter(alone).collect();
    let places = if decisive.is_empty() {
        toleranced.iter().collect()
    } else {
        decisive
    };
    places.into_iter().map(|place| scene.key(*place)).collect()
}

fn moves<S: Serializer>(moves: &[Vec<BigRational>], serializer: S) -> Result<S::Ok, S::Error> {
    let texts = |step: &Vec<BigRational>| -> Vec<serde_json::Value> {
        step.iter().map(crate::json::rational).collect()
    };
    serializer.collect_seq(moves.iter().map(texts))
}

fn optional_intervals<S: Serializer>(
    list: &Option<Vec<Interval<BigRational>>>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let list = list.as_ref();
    let values: Option<Vec<_>> = list.map(|list| list.iter().map(crate::json::interval).collect());
    values.serialize(serializer)
}

impl JointReport {
    /// The report as a JSON object, one of the `scenes` of `check --format json`.
    #[must_use]
    pub fn to_json(&self) -> serde_json::Value {
        crate::json::of(self)
    }
}
