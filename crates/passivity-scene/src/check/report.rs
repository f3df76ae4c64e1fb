//! Every figure of a check, exact or exactly enclosed.

use num_traits::Signed;
use passivity_core::verdict::RigBox;
use passivity_core::{BigRational, Criterion, Interval, Region, Scalar, Truth, stiffness};

use super::bounds::{PRINTED, SpeedBound};
use super::changes::{self, Change};
use super::decide::{self, Verdict};
use crate::effect::Effect;
use crate::scene::{Motion, Scene};

/// Where the speed bound of a verdict comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BoundSource {
    /// `operator.max_speed`.
    MaxSpeed,
    /// The start of an unforced motion (TH-START).
    Start,
}

/// A cycle that draws energy from the display (TH-ACTIVE).
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// Where the cycle starts and ends, in ticks, or in SI units without an encoder.
    pub from: BigRational,
    /// Where it turns.
    pub to: BigRational,
    /// Energy gained each time round, in KΔ²: at least this, whatever the tolerances.
    pub gain_per_cycle: BigRational,
}

/// What `passivity check` says of a scene. Lengths are in ticks, speeds in ticks per sampling
/// period, unless the name says SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The scene's name.
    pub scene: String,
    /// How the device moves.
    pub motion: Motion,
    /// The effects in the scene.
    pub effects: Vec<Effect>,
    /// The region of the (β, σ) plane, with the terms of the effects; `None` when it depends.
    pub region: Option<Region>,
    /// The verdict.
    pub verdict: Verdict,
    /// Ids of the theorems that give it.
    pub because: Vec<&'static str>,
    /// Effects that no theorem covers.
    pub not_covered: Vec<Effect>,
    /// μ, when the scene has an inertia.
    pub mu: Option<Interval<BigRational>>,
    /// β; 0 without viscous friction.
    pub beta: Interval<BigRational>,
    /// σ; `None` without an encoder, 0 without Coulomb friction.
    pub sigma: Option<Interval<BigRational>>,
    /// Where the criterion meets equality; `None` when no single speed does.
    pub critical_speed: Option<Interval<BigRational>>,
    /// The same in m/s or rad/s; `None` for a dimensionless scene.
    pub critical_speed_si: Option<Interval<BigRational>>,
    /// The smaller of the two coefficients of the criterion, β − ½ and σ − ½ less the effects'.
    pub margin_at_all_speeds: Interval<BigRational>,
    /// V, up to which the verdict was asked.
    pub speed_bound: Option<Interval<BigRational>>,
    /// V in SI units; `None` for a dimensionless scene.
    pub speed_bound_si: Option<Interval<BigRational>>,
    /// Where V comes from.
    pub bound_source: Option<BoundSource>,
    /// The margin of the criterion at V.
    pub margin_at_speed_bound: Option<Interval<BigRational>>,
    /// The stiffest wall at every speed, SI; at most 0 when there is none.
    pub max_stiffness_all_speeds: Option<Interval<BigRational>>,
    /// The stiffest wall at every speed up to V, SI.
    pub max_stiffness_at_speed_bound: Option<Interval<BigRational>>,
    /// Colgate's b ≥ KT/2 + B, for comparison: no quantization, no Coulomb friction.
    pub colgate: Truth,
    /// Abbott and Okamura's K ≤ min(2b/T, 2c/Δ), for comparison.
    pub abbott_okamura: Truth,
    /// An exact cycle that draws energy.
    pub witness: Option<Witness>,
    /// The parameters whose tolerance decides, when the verdict depends.
    pub decided_by: Vec<&'static str>,
    /// How far each parameter can go, or has to go.
    pub changes: Vec<Change>,
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
/// assert_eq!(report.margin_at_all_speeds.lo().to_string(), "0");
/// ```
#[must_use]
pub fn check(scene: &Scene) -> Report {
    let decided = decide::decide(scene);
    let not_covered = scene.not_covered();
    let bound = SpeedBound::of(scene, PRINTED);
    let rigs = scene.rig_box(PRINTED);
    let figures = Figures { scene, rigs: &rigs };
    let verdict = match decided.truth {
        _ if !not_covered.is_empty() => Verdict::NotCovered,
        Truth::Holds => Verdict::Passive,
        Truth::Depends => Verdict::Depends,
        Truth::Fails if decided.witness.is_some() => Verdict::NotPassive,
        Truth::Fails => Verdict::NotGuaranteed,
    };
    let has_units = scene.motion != Motion::Dimensionless;
    let si = |x: Interval<BigRational>| has_units.then_some(x);
    let critical_si = figures.critical_speed(decided.region);
    let friction = (rigs.worst().friction(), rigs.best().friction());
    Report {
        scene: scene.name.clone(),
        motion: scene.motion,
        effects: scene.effects(),
        region: decided.region,
        verdict,
        because: because(scene, verdict, decided.at_all_speeds, bound.as_ref()),
        mu: scene
            .inertia
            .as_ref()
            .map(|m| figures.mu(&m.value.enclosure(PRINTED))),
        beta: Interval::hull(friction.0.beta, friction.1.beta),
        sigma: rigs
            .encoder
            .then(|| Interval::hull(friction.0.sigma, friction.1.sigma)),
        critical_speed: critical_si.as_ref().map(|v| figures.in_ticks(v)),
        critical_speed_si: critical_si.and_then(si),
        margin_at_all_speeds: figures.margin_at_all_speeds(),
        speed_bound: bound.as_ref().map(|bound| bound.in_ticks(&rigs)),
        speed_bound_si: bound.as_ref().and_then(|bound| si(bound.speed())),
        bound_source: bound.as_ref().map(|bound| bound.source),
        margin_at_speed_bound: bound
            .as_ref()
            .map(|bound| figures.margin_at(&bound.speed())),
        max_stiffness_all_speeds: has_units.then(|| {
            non_negative(
                stiffness::limit_at_all_speeds(&rigs.worst()),
                stiffness::limit_at_all_speeds(&rigs.best()),
            )
        }),
        max_stiffness_at_speed_bound: bound
            .as_ref()
            .filter(|_| has_units)
            .map(|bound| changes::stiffness_limit(scene, &rigs, bound)),
        colgate: figures.colgate(),
        abbott_okamura: figures.abbott_okamura(),
        decided_by: match verdict {
            Verdict::Depends => decide::deciding(scene),
            _ => Vec::new(),
        },
        changes: changes::changes(scene, bound.as_ref()),
        witness: decided
            .witness
            .filter(|_| verdict == Verdict::NotPassive)
            .map(|cycle| Witness {
                from: cycle.from,
                to: cycle.to,
                gain_per_cycle: cycle.gain,
            }),
        not_covered,
    }
}

/// The interval between two values, both taken as at least zero.
pub(super) fn non_negative(a: BigRational, b: BigRational) -> Interval<BigRational> {
    let clamp = |x: BigRational| {
        if x.is_negative() {
            BigRational::zero()
        } else {
            x
        }
    };
    Interval::hull(clamp(a), clamp(b))
}

/// The theorems a verdict rests on.
fn because(
    scene: &Scene,
    verdict: Verdict,
    at_all_speeds: bool,
    bound: Option<&SpeedBound>,
) -> Vec<&'static str> {
    let mut ids = Vec::new();
    match verdict {
        Verdict::NotCovered => return ids,
        Verdict::NotPassive if scene.resolution.is_some() => ids.push("TH-ACTIVE"),
        Verdict::NotPassive => ids.push("TH-SMOOTH"),
        _ => {
            ids.extend(["TH-REGION", "TH-INTERVAL", "TH-RUN"]);
            if !at_all_speeds && bound.is_some_and(|b| b.source == BoundSource::Start) {
                ids.push("TH-START");
            }
            if scene.resolution.is_none() {
                ids.push("TH-SMOOTH");
            }
        }
    }
    // A cycle that gains energy is no matter of what an interval generates at most.
    let beside = (verdict == Verdict::NotPassive).then_some("TH-INTERVAL");
    for id in scene.effects().into_iter().filter_map(Effect::theorem) {
        if !ids.contains(&id) && beside != Some(id) {
            ids.push(id);
        }
    }
    ids
}

/// The figures of a box of rigs, as exact enclosures.
struct Figures<'a> {
    scene: &'a Scene,
    rigs: &'a RigBox,
}

impl Figures<'_> {
    fn mu(&self, inertia: &Interval<BigRational>) -> Interval<BigRational> {
        Interval::hull(
            self.rigs.worst().mu(inertia.lo()),
            self.rigs.best().mu(inertia.hi()),
        )
    }

    /// A speed in SI units as ticks per sampling period (4).
    fn in_ticks(&self, speed: &Interval<BigRational>) -> Interval<BigRational> {
        let (period, length) = (&self.rigs.period, &self.rigs.length);
        Interval::hull(
            speed.lo() * period.lo() / length.hi(),
            speed.hi() * period.hi() / length.lo(),
        )
    }

    /// The critical speed in SI units, where the region has one.
    fn critical_speed(&self, region: Option<Region>) -> Option<Interval<BigRational>> {
        let (worst, best) = self.rigs.criteria();
        let speed = passivity_core::region::critical_speed::<BigRational>;
        match region? {
            // More friction raises the speed up to which the criterion holds.
            Region::LocallyStable => Some(Interval::hull(speed(&worst), speed(&best))),
            Region::LimitCycles => Some(Interval::hull(speed(&best), speed(&worst))),
            Region::GloballyStable | Region::Unstable => None,
        }
    }

    /// Each coefficient of the dimensionless criterion: `(with units) / unit`, as an enclosure.
    fn coefficients(&self) -> (Interval<BigRational>, Interval<BigRational>) {
        let (worst, best) = self.rigs.criteria();
        let viscous_unit = product(&self.rigs.stiffness, &self.rigs.period);
        let force_unit = product(&self.rigs.stiffness, &self.rigs.length);
        (
            quotient(&Interval::hull(worst.viscous, best.viscous), &viscous_unit),
            quotient(&Interval::hull(worst.coulomb, best.coulomb), &force_unit),
        )
    }

    fn margin_at_all_speeds(&self) -> Interval<BigRational> {
        let (viscous, coulomb) = self.coefficients();
        let lowest = |a: &BigRational, b: &BigRational| Ord::min(a, b).clone();
        Interval::hull(
            lowest(viscous.lo(), coulomb.lo()),
            lowest(viscous.hi(), coulomb.hi()),
        )
    }

    /// The margin at a speed in SI units, in units of KΔ.
    fn margin_at(&self, speed: &Interval<BigRational>) -> Interval<BigRational> {
        let (worst, best) = self.rigs.criteria();
        let margins = |criterion: &Criterion<BigRational>| {
            [criterion.margin(speed.lo()), criterion.margin(speed.hi())]
        };
        let least = margins(&worst).into_iter().min();
        let most = margins(&best).into_iter().max();
        let range = Interval::hull(
            least.unwrap_or_else(BigRational::zero),
            most.unwrap_or_else(BigRational::zero),
        );
        quotient(&range, &product(&self.rigs.stiffness, &self.rigs.length))
    }

    /// b ≥ KT/2 + B.
    fn colgate(&self) -> Truth {
        let holds = |rig: passivity_core::Rig<BigRational>| {
            let damping = rig
                .effects
                .damping
                .clone()
                .unwrap_or_else(BigRational::zero);
            rig.viscous >= rig.stiffness.half() * rig.period + damping
        };
        Truth::over(holds(self.rigs.worst()), holds(self.rigs.best()))
    }

    /// K ≤ min(2b/T, 2c/Δ); without an encoder K ≤ 2b/T.
    fn abbott_okamura(&self) -> Truth {
        let encoder = self.scene.resolution.is_some();
        let holds = |rig: passivity_core::Rig<BigRational>| {
            let half = rig.stiffness.half();
            rig.viscous >= &half * rig.period && (!encoder || rig.coulomb >= half * rig.length)
        };
        Truth::over(holds(self.rigs.worst()), holds(self.rigs.best()))
    }
}

/// The products of two intervals of non-negative numbers.
fn product(a: &Interval<BigRational>, b: &Interval<BigRational>) -> Interval<BigRational> {
    Interval::hull(a.lo() * b.lo(), a.hi() * b.hi())
}

/// The quotients of an interval by one of positive numbers.
fn quotient(a: &Interval<BigRational>, by: &Interval<BigRational>) -> Interval<BigRational> {
    let lo = if a.lo().is_negative() {
        a.lo() / by.lo()
    } else {
        a.lo() / by.hi()
    };
    let hi = if a.hi().is_negative() {
        a.hi() / by.hi()
    } else {
        a.hi() / by.lo()
    };
    Interval::hull(lo, hi)
}
