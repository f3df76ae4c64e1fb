//! Every figure of a check, exact or exactly enclosed: one type for programs and people.

use passivity_core::verdict::Speeds;
use passivity_core::{
    BigRational, Effect, Enclosed, Interval, Loop, Parameter, Region, Scalar, Truth, Wide,
};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use super::advice::{self, Advice};
use super::decide::{self, Verdict};
use super::figures::Figures;
use super::limits::{self, Limit, Side};
use super::text::speed_unit;
use super::unforced::{self, StartSpeed, Unforced};
use super::witness::{Witness, witness};
use super::{BITS, figure};
use crate::json::shape;
use crate::scene::{Motion, Scene};
use crate::written::Written;

/// What the effects of a scene ask of β and σ.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Costs {
    /// Of effective viscous friction: ½ + k + B, or λ or κ where the effects act together.
    #[serde(with = "shape::Interval")]
    pub viscous: Interval<BigRational>,
    /// Of effective Coulomb friction: ½(‖c‖₁ + δ), with ½‖c‖₁ = ½ + B of damping; without an encoder
    /// ½δ.
    #[serde(with = "shape::Interval")]
    pub coulomb: Interval<BigRational>,
}

/// What friction has to spare beyond the cost of the effects: at every speed the criterion holds
/// exactly when neither is negative.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Spare {
    /// β less its cost.
    #[serde(with = "shape::Interval")]
    pub viscous: Interval<BigRational>,
    /// σ less its cost.
    #[serde(with = "shape::Interval")]
    pub coulomb: Interval<BigRational>,
}

/// What a check found out about a scene.
///
/// Serialised it is one of the `scenes` of `check --format json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Report {
    /// The scene's name.
    pub scene: String,
    /// How the device moves: it fixes the units of people's text.
    #[serde(skip)]
    pub motion: Motion,
    /// The unit in which people read speeds: the scene's, or SI where it gives no speed.
    #[serde(skip)]
    pub speed_written: Written,
    /// The unit in which the scene gives the stiffness.
    #[serde(skip)]
    pub stiffness_written: Written,
    /// The region of the (β, σ) plane; `None` when it depends on tolerances.
    #[serde(with = "shape::Region")]
    pub region: Option<Region>,
    /// The verdict, about any operator.
    pub verdict: Verdict,
    /// Whether the criterion holds at every speed, also where a bound on the speed is given.
    pub at_every_speed: bool,
    /// The ids of the theorems that the verdict rests on.
    pub because: Vec<&'static str>,
    /// The effects in the scene.
    #[serde(with = "shape::Effects")]
    pub effects: Vec<Effect>,
    /// How values of the file were taken, where a reader could have taken them otherwise.
    pub remarks: Vec<String>,
    /// The effects that no theorem covers.
    #[serde(with = "shape::Effects")]
    pub not_covered: Vec<Effect>,
    /// μ, when the scene has an inertia.
    #[serde(with = "shape::OptionalInterval")]
    pub mu: Option<Interval<BigRational>>,
    /// β; 0 without viscous friction.
    #[serde(with = "shape::Interval")]
    pub beta: Interval<BigRational>,
    /// σ; 0 without Coulomb friction, `None` without an encoder.
    #[serde(with = "shape::OptionalInterval")]
    pub sigma: Option<Interval<BigRational>>,
    /// What the effects ask of β and σ.
    pub cost: Costs,
    /// What β and σ have to spare.
    pub spare: Spare,
    /// Where the criterion meets equality, in ticks per sample; `None` when no single speed does.
    #[serde(with = "shape::OptionalInterval")]
    pub critical_speed: Option<Interval<BigRational>>,
    /// The same in m/s or rad/s; `None` for a dimensionless scene.
    #[serde(with = "shape::OptionalInterval")]
    pub critical_speed_si: Option<Interval<BigRational>>,
    /// V of `operator.max_speed`, up to which the verdict is asked, in ticks per sample.
    #[serde(with = "shape::OptionalInterval")]
    pub speed_bound: Option<Interval<BigRational>>,
    /// V in SI units; `None` for a dimensionless scene.
    #[serde(with = "shape::OptionalInterval")]
    pub speed_bound_si: Option<Interval<BigRational>>,
    /// The margin of (8) at V, (β − ½) + (σ − ½)/V with the costs of the effects.
    #[serde(with = "shape::OptionalInterval")]
    pub margin_at_speed_bound: Option<Interval<BigRational>>,
    /// The stiffest wall at every speed, SI; 0 when there is none.
    #[serde(with = "shape::OptionalInterval")]
    pub max_stiffness_all_speeds: Option<Interval<BigRational>>,
    /// The stiffest wall at every speed up to V, SI.
    #[serde(with = "shape::OptionalInterval")]
    pub max_stiffness_at_speed_bound: Option<Interval<BigRational>>,
    /// Colgate's b ≥ KT/2 + B, for comparison: no quantization, no Coulomb friction. `None` where it
    /// does not apply: with a delay, a latency, filtered damping, a controller or an amplifier.
    #[serde(with = "shape::OptionalTruth")]
    pub colgate: Option<Truth>,
    /// Abbott and Okamura's K ≤ min(2b/T, 2c/Δ), for comparison. `None` like `colgate`.
    #[serde(with = "shape::OptionalTruth")]
    pub abbott_okamura: Option<Truth>,
    /// A cycle that draws energy, where the verdict is that the wall is not passive.
    pub witness: Option<Witness>,
    /// What holds of the device left alone at the scene's start; `None` without one, or when its
    /// speed needs an inertia that is not given.
    #[schemars(with = "Option<UnforcedShape<'static>>")]
    pub unforced: Option<Unforced>,
    /// The keys of the parameters whose tolerance decides, when the verdict depends.
    pub decided_by: Vec<&'static str>,
    /// How far each parameter can go, or has to go, at the speeds that the headline speaks of.
    #[schemars(with = "Vec<LimitShape<'static>>")]
    pub limits: Vec<Limit>,
    /// What uses up the friction, and what to change.
    pub advice: Advice,
}

/// Checks a scene.
///
/// # Example
///
/// ```
/// use passivity_scene::{Scene, check::{Verdict, check}};
///
/// let text = "[dimensionless]\nmu = \"50\"\nbeta = \"1/2\"\nsigma = \"1/2\"\n";
/// let scene = Scene::from_toml("corner", text).unwrap();
/// let report = check(&scene);
/// assert_eq!(report.verdict, Verdict::Passive); // equality is passive
/// assert_eq!(report.spare.viscous.lo().to_string(), "0");
/// ```
#[must_use]
pub fn check(scene: &Scene) -> Report {
    let bounds = scene.bounds();
    // Where there is no π, plain fractions do, and faster.
    let rational = bounds.try_map(|_, range| range.try_map(Wide::of));
    let report = match rational {
        Some(rational) => checked(scene, &rational),
        None => checked(scene, &bounds),
    };
    report.unwrap_or_else(|| {
        unreachable!("the figures of a scene are defined: its units are above zero")
    })
}

/// The report, or `None` where a figure is undefined.
fn checked<S: Enclosed>(scene: &Scene, bounds: &Loop<Interval<S>>) -> Option<Report> {
    let figures = Figures::of(bounds);
    let asked = bounds.speeds();
    let unbounded = bounds.truth(&Speeds::All)?;
    let at_every_speed = unbounded == Truth::Holds;
    let truth = if at_every_speed || bounds.max_speed.is_none() {
        unbounded
    } else {
        bounds.truth(&asked)?
    };
    let not_covered = scene.not_covered();
    let cycle = match truth {
        Truth::Fails if not_covered.is_empty() => decide::find_witness(scene, bounds),
        _ => None,
    };
    let verdict = match truth {
        _ if !not_covered.is_empty() => Verdict::NotCovered,
        Truth::Holds => Verdict::Passive,
        Truth::Depends => Verdict::Depends,
        Truth::Fails if cycle.is_some() => Verdict::NotPassive,
        Truth::Fails => Verdict::NotGuaranteed,
    };
    // What is decided of all loops says more than figures that are enclosed one by one.
    let region = match at_every_speed {
        true => Some(Region::GloballyStable),
        false => figures.region(),
    };
    let decided = |range: Interval<BigRational>, holds: bool| match holds {
        true => range.map(|end| Scalar::max(end.clone(), Scalar::zero())),
        false => range,
    };
    let has_units = scene.motion != Motion::Dimensionless;
    let optional = |range: Option<Interval<S>>| match range {
        Some(range) => figure(&range).map(Some),
        None => Some(None),
    };
    let si = |range: &Option<Interval<S>>| optional(range.clone().filter(|_| has_units));
    let critical = figures.critical_speed(region);
    let [viscous_cost, coulomb_cost] = figures.cost();
    let [viscous_spare, coulomb_spare] = figures.spare();
    let bounded = bounds.max_speed.as_ref();
    let of_limits = if at_every_speed { &Speeds::All } else { &asked };
    let limits = limits::limits(scene, bounds, of_limits);
    // One of the two is among the limits already.
    let stiffest = |is_listed: bool, speeds: &Speeds<Interval<S>>| {
        let is_stiffness = |limit: &&Limit| limit.parameter == Parameter::Stiffness;
        let listed = limits.iter().find(is_stiffness).filter(|_| is_listed);
        // Where no wall is soft enough over all tolerances, some may be over a part of them.
        let border = || limits::ends(Parameter::Stiffness, bounds, speeds);
        let found = listed.map(|limit| limit.border.clone());
        found
            .or_else(|| figure(&border()?.border))
            .unwrap_or_else(|| Interval::point(Scalar::zero()))
    };
    let speed_written = speed_written(scene);
    let advice = advice::of(&figures, of_limits, verdict, &limits, &speed_written)?;
    Some(Report {
        scene: scene.name.clone(),
        motion: scene.motion,
        speed_written,
        stiffness_written: scene.given.stiffness.written.clone(),
        effects: scene.effects(),
        remarks: scene.remarks(),
        region,
        verdict,
        at_every_speed,
        because: because(scene, verdict),
        mu: optional(figures.mu())?,
        beta: figure(&figures.between(|corner| corner.friction().beta))?,
        sigma: optional(
            scene
                .given
                .has_encoder()
                .then(|| figures.between(|corner| corner.friction().sigma)),
        )?,
        cost: Costs {
            viscous: figure(&viscous_cost)?,
            // It is a sum of sizes, however that is enclosed.
            coulomb: decided(figure(&coulomb_cost)?, true),
        },
        spare: Spare {
            viscous: decided(figure(&viscous_spare)?, at_every_speed),
            coulomb: decided(figure(&coulomb_spare)?, at_every_speed),
        },
        critical_speed_si: si(&critical)?,
        critical_speed: optional(critical.map(|v| figures.in_ticks(&v)))?,
        speed_bound: optional(bounded.map(|v| figures.in_ticks(v)))?,
        speed_bound_si: si(&bounds.max_speed)?,
        margin_at_speed_bound: optional(bounded.map(|v| figures.margin_at(v)))?
            .map(|margin| decided(margin, truth == Truth::Holds)),
        max_stiffness_all_speeds: has_units
            .then(|| stiffest(at_every_speed || bounded.is_none(), &Speeds::All)),
        max_stiffness_at_speed_bound: bounded
            .filter(|_| has_units)
            .map(|_| stiffest(!at_every_speed, &asked)),
        colgate: figures.colgate(),
        abbott_okamura: figures.abbott_okamura(),
        decided_by: match verdict {
            Verdict::Depends => decide::deciding(scene, bounds),
            _ => Vec::new(),
        },
        limits,
        advice,
        witness: match cycle {
            Some(cycle) => Some(witness(cycle, bounds, has_units)?),
            None => None,
        },
        unforced: left_alone(scene, &figures, &not_covered)?,
        not_covered,
    })
}

/// The unit of the speeds in a scene file: of the bound, else of the start, else that of the encoder's
/// resolution per second, else SI.
fn speed_written(scene: &Scene) -> Written {
    let given = &scene.given;
    let speed = given.max_speed.as_ref().or(given.start_velocity.as_ref());
    let resolution = given.resolution.as_ref();
    let per_second = || match scene.motion {
        Motion::Dimensionless => None,
        _ => resolution?.written.per_second(),
    };
    match speed {
        Some(given) => given.written.clone(),
        None => per_second().unwrap_or_else(|| Written::si(speed_unit(scene.motion))),
    }
}

/// What TH-START says of the scene's start.
fn left_alone<S: Enclosed>(
    scene: &Scene,
    figures: &Figures<'_, S>,
    not_covered: &[Effect],
) -> Option<Option<Unforced>> {
    let Some(start) = StartSpeed::of(scene, figures.bounds) else {
        return Some(None);
    };
    let holds = match not_covered {
        [] => unforced::holds(figures.bounds, &start.speeds())?,
        _ => Truth::Depends,
    };
    let speed = start.enclosure(BITS)?;
    let factor = figure(&figures.in_ticks(&Interval::point(Scalar::one())))?;
    let ticks = Interval::hull(speed.lo() * factor.lo(), speed.hi() * factor.hi());
    Some(Some(Unforced {
        holds,
        assumes: unforced::assumes(scene),
        speed: ticks,
        speed_si: (scene.motion != Motion::Dimensionless).then_some(speed),
    }))
}

/// The theorems that a verdict rests on.
fn because(scene: &Scene, verdict: Verdict) -> Vec<&'static str> {
    let mut ids = Vec::new();
    match verdict {
        Verdict::NotCovered => return ids,
        Verdict::NotPassive if scene.given.is_plain() => ids.push("TH-ACTIVE"),
        Verdict::NotPassive => ids.push("TH-LTI"),
        // What a loop remembers has theorems of its own, of runs.
        _ if scene.given.has_memory() => ids.push("TH-REGION"),
        _ => ids.extend(["TH-REGION", "TH-INTERVAL", "TH-RUN"]),
    }
    if !scene.given.has_encoder() {
        ids.push("TH-SMOOTH");
    }
    // A cycle that gains energy is no matter of what an interval generates at most, and in a loop with memory an interval
    // may generate more than friction takes.
    let aside = verdict == Verdict::NotPassive || scene.given.has_memory();
    let beside = aside.then_some("TH-INTERVAL");
    // A delay and damping that partly cancel are one controller.
    let together = scene.given.delay > 0 && scene.has(Effect::Damping) && scene.given.is_linear();
    if together && !ids.contains(&"TH-LTI") {
        ids.push("TH-LTI");
    }
    for id in scene.effects().into_iter().filter_map(Effect::theorem) {
        if !ids.contains(&id) && beside != Some(id) {
            ids.push(id);
        }
    }
    ids
}

/// What holds of the device left alone, as it is written.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Unforced")]
struct UnforcedShape<'a> {
    /// Null where it is not shown.
    holds: Option<bool>,
    /// The speed of the start, in ticks per sample.
    #[serde(with = "shape::Interval")]
    speed: &'a Interval<BigRational>,
    /// The same in m/s or rad/s.
    #[serde(with = "shape::OptionalInterval")]
    speed_si: &'a Option<Interval<BigRational>>,
    /// What it assumes of the controller's memory; null where it has none.
    assumes: Option<&'static str>,
}

impl Serialize for Unforced {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let shape = UnforcedShape {
            holds: match self.holds {
                Truth::Holds => Some(true),
                Truth::Fails => Some(false),
                Truth::Depends => None,
            },
            speed: &self.speed,
            speed_si: &self.speed_si,
            assumes: self.assumes,
        };
        shape.serialize(serializer)
    }
}

/// A limit, as it is written.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Limit")]
struct LimitShape<'a> {
    /// The key of the parameter in a scene file.
    parameter: &'static str,
    #[serde(flatten)]
    figures: LimitFigures<'a>,
}

/// What is written of a limit, whichever parameter it is of.
#[derive(Serialize, JsonSchema)]
pub(crate) struct LimitFigures<'a> {
    /// What it is now.
    #[serde(with = "shape::Interval")]
    now: &'a Interval<BigRational>,
    /// Where the criterion is met with equality.
    #[serde(with = "shape::Interval")]
    border: &'a Interval<BigRational>,
    /// On which side of the border the criterion holds.
    holds: Side,
    /// Whether this parameter alone is enough.
    suffices: bool,
    /// The border in SI, rounded to the safe side; null where it is not enough alone.
    printed: &'a Option<String>,
    /// The other end of the values that pass: below it, or above it, they fail, or are not shown to
    /// pass; null where there is none.
    other_end: Option<FarEndFigures<'a>>,
}

/// What is written of the other end of the values that pass.
#[derive(Serialize, JsonSchema)]
struct FarEndFigures<'a> {
    /// Where the criterion is met with equality.
    #[serde(with = "shape::Interval")]
    border: &'a Interval<BigRational>,
    /// The border in SI, rounded to the safe side.
    printed: &'a Option<String>,
}

impl<'a> LimitFigures<'a> {
    pub(crate) fn of(limit: &'a Limit) -> Self {
        Self {
            now: &limit.now,
            border: &limit.border,
            holds: limit.side,
            suffices: limit.suffices,
            printed: &limit.printed,
            other_end: limit.far.as_ref().map(|far| FarEndFigures {
                border: &far.border,
                printed: &far.printed,
            }),
        }
    }
}

impl Serialize for Limit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let shape = LimitShape {
            parameter: self.parameter.row().key,
            figures: LimitFigures::of(self),
        };
        shape.serialize(serializer)
    }
}

impl Report {
    /// The report as a JSON object, one of the `scenes` of `check --format json`.
    #[must_use]
    pub fn to_json(&self) -> serde_json::Value {
        crate::json::of(self)
    }
}
