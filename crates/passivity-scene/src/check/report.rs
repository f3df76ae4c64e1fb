//! Every figure of a check, exact or exactly enclosed.

use passivity_core::{BigRational, Interval, Region, Scalar, Truth, Wide, rational, stiffness};

use super::bounds::{PRINTED, SpeedBound, in_ticks};
use super::changes::{self, Change};
use super::decide::{self, Verdict};
use super::figures::Figures;
use super::stiffest::stiffness_limit;
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
    /// The margin of (8) at V, (β − ½) + (σ − ½)/V less the effects'; `None` at V = 0.
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
    let rigs = decide::wide(&scene.rig_box(PRINTED));
    let figures = Figures { rigs: &rigs };
    let verdict = match decided.truth {
        _ if !not_covered.is_empty() => Verdict::NotCovered,
        Truth::Holds => Verdict::Passive,
        Truth::Depends => Verdict::Depends,
        Truth::Fails if decided.witness.is_some() => Verdict::NotPassive,
        Truth::Fails => Verdict::NotGuaranteed,
    };
    let has_units = scene.motion != Motion::Dimensionless;
    let si = |x: &Interval<Wide>| has_units.then(|| exact(x));
    let critical_si = figures.critical_speed(decided.region);
    let speed = bound.as_ref().map(SpeedBound::speed);
    let stiffest = bound
        .as_ref()
        .map(|bound| stiffness_limit(scene, &rigs, bound));
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
            .map(|m| exact(&figures.mu(&m.value.enclosure(PRINTED).map(rational::to_wide)))),
        beta: exact(&Interval::hull(friction.0.beta, friction.1.beta)),
        sigma: rigs
            .encoder
            .then(|| exact(&Interval::hull(friction.0.sigma, friction.1.sigma))),
        critical_speed: critical_si.as_ref().map(|v| exact(&in_ticks(v, &rigs))),
        critical_speed_si: critical_si.as_ref().and_then(si),
        margin_at_all_speeds: exact(&figures.margin_at_all_speeds()),
        speed_bound: speed.as_ref().map(|v| exact(&in_ticks(v, &rigs))),
        speed_bound_si: speed.as_ref().and_then(si),
        bound_source: bound.as_ref().map(|bound| bound.source),
        margin_at_speed_bound: speed
            .as_ref()
            .and_then(|v| figures.margin_at(v))
            .map(|m| exact(&m)),
        max_stiffness_all_speeds: has_units.then(|| {
            non_negative(
                &stiffness::limit_at_all_speeds(&rigs.worst()),
                &stiffness::limit_at_all_speeds(&rigs.best()),
            )
        }),
        max_stiffness_at_speed_bound: stiffest
            .as_ref()
            .filter(|_| has_units)
            .map(|k| non_negative(k.lo(), k.hi())),
        colgate: figures.colgate(),
        abbott_okamura: figures.abbott_okamura(),
        decided_by: match verdict {
            Verdict::Depends => decide::deciding(scene),
            _ => Vec::new(),
        },
        changes: changes::changes(
            scene,
            &rigs,
            speed.as_ref(),
            stiffest
                .as_ref()
                .filter(|_| bound.as_ref().is_some_and(SpeedBound::is_root)),
        ),
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

/// A number in lowest terms; zero for an undefined one, which no scene that was read can give.
pub(super) fn reduced(x: &Wide) -> BigRational {
    rational::from_wide(x).unwrap_or_else(BigRational::zero)
}

/// An enclosure in lowest terms.
pub(super) fn exact(range: &Interval<Wide>) -> Interval<BigRational> {
    if range.is_point() {
        return Interval::point(reduced(range.lo()));
    }
    range.map(reduced)
}

/// The interval between two values, both taken as at least zero.
pub(super) fn non_negative(a: &Wide, b: &Wide) -> Interval<BigRational> {
    let clamp = |x: &Wide| x.clone().max(Wide::zero());
    exact(&Interval::hull(clamp(a), clamp(b)))
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
