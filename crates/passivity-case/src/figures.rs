//! Pictures of a scene: its place in the plane, its motion with the energy ledger, and what accuracy
//! costs.

use passivity_core::{BigRational, Interval, Scalar as _};
use passivity_plot::plane::{self, Mark};
use passivity_scene::display::range;
use passivity_scene::number::nearest_f64;
use passivity_scene::{Exact, Given, Point, Scene};
use passivity_sim::plot::motion::{self, Motion};
use passivity_sim::{Exactly, Plan, accuracy, plot, run};

use crate::document::{Block, Figure, Line};
use crate::study::Study;

/// A motion is simulated for at most this many intervals: enough for rest or certain growth on the
/// shipped scenes, and a matter of a second on any.
const MOST_INTERVALS: u64 = 50_000;

/// What accuracy costs is measured over at most this many intervals.
const MOST_MEASURED: u64 = 500;

fn say(text: impl Into<String>) -> Vec<Block> {
    vec![Block::Paragraph(Line::text(text))]
}

/// The (β, σ) plane with the scene in it: the rectangle of its tolerances.
#[must_use]
pub fn of_plane(study: &Study) -> Vec<Block> {
    let report = study.report();
    let Some(sigma) = &report.sigma else {
        return say(
            "Without an encoder the scene has no place in the (β, σ) plane: σ needs a resolution Δ.",
        );
    };
    let ends = |x: &Interval<BigRational>| (nearest_f64(x.lo()), nearest_f64(x.hi()));
    let middle = |x: &Interval<BigRational>| nearest_f64(&(x.lo() + x.hi()).half());
    // Enclosures of π are no tolerance.
    let parameters = study.scene.parameters();
    let has_tolerance = parameters.iter().any(|given| given.has_tolerance());
    // The critical line of the largest speed within the bound is the one to stay above.
    let speed = report.speed_bound.as_ref();
    let speed = speed.map(|v| (nearest_f64(v.hi()), format!("{} ticks/sample", range(v))));
    let mark = Mark {
        name: study.name().to_owned(),
        beta: middle(&report.beta),
        sigma: middle(sigma),
        tolerance: has_tolerance.then(|| [ends(&report.beta), ends(sigma)]),
        speed: speed.filter(|(v, _)| *v > 0.0),
        verdict: report.verdict.name().replace('_', " "),
    };
    let at = format!("β = {}, σ = {}", range(&report.beta), range(sigma));
    let alt = format!(
        "The plane of effective viscous friction β and effective Coulomb friction σ, with the lines \
         β = ½ and σ = ½ that part the regions. The scene is at {at}: {}.",
        mark.verdict
    );
    let place = if has_tolerance {
        "The rectangle holds every value within the tolerances. "
    } else {
        ""
    };
    match plane::draw(&[mark]) {
        Ok(svg) => vec![Block::Figure(Figure {
            id: study.anchor("plane"),
            svg,
            caption: format!(
                "«{}» in the (β, σ) plane, at {at}. {place}The arrows show where another \
                 stiffness, sampling period or resolution would move it.",
                study.name()
            ),
            alt,
            small: false,
        })],
        Err(error) => say(format!("There is no picture of the plane: {error}.")),
    }
}

/// The scene with each parameter that decides at the end of its tolerance at which the criterion is
/// hardest to meet, and whether that is another scene.
fn at_hardest_end(scene: &Scene) -> (Scene, bool) {
    let mut scene = scene.clone();
    let mut moved = false;
    let mut pin = |given: &mut Given, end: fn(&Interval<BigRational>) -> &BigRational| {
        moved |= given.has_tolerance();
        let value = end(given.value.range()).clone();
        given.nominal = Exact::new(Interval::point(value), given.value.pi_power());
    };
    for given in [&mut scene.viscous, &mut scene.coulomb]
        .into_iter()
        .flatten()
    {
        pin(given, Interval::lo);
    }
    let others = [
        &mut scene.resolution,
        &mut scene.damping,
        &mut scene.force_step,
        &mut scene.max_speed,
    ];
    for given in others.into_iter().flatten() {
        pin(given, Interval::hi);
    }
    for given in [&mut scene.stiffness, &mut scene.period] {
        pin(given, Interval::hi);
    }
    (scene, moved)
}

/// The motion to show: where it starts, in which words; `None` for a scene with neither a start nor
/// a bound on the speed.
fn to_simulate(study: &Study) -> Option<(Point, String)> {
    let (scene, moved) = at_hardest_end(&study.scene);
    let mut point = scene.point();
    let mut from = if scene.start.is_some() {
        "from the start in the scene".to_owned()
    } else {
        let bound = scene.max_speed.as_ref()?;
        let speed = bound.nominal.middle() * &point.units.period / &point.units.length;
        from_surface(&mut point, speed);
        format!(
            "from the surface of the wall at the speed bound, {}",
            bound.text
        )
    };
    if moved {
        from.push_str(", at the end of the tolerances at which the criterion is hardest to meet");
    }
    Some((point, from))
}

fn from_surface(point: &mut Point, speed: BigRational) {
    point.start = [BigRational::integer(0), speed];
}

/// The motion of a scene and its energy ledger; a paragraph that says why not, where there is none.
#[must_use]
pub fn of_motion(study: &Study) -> Vec<Block> {
    if study.scene.inertia.is_none() {
        return say("No motion is shown: the scene has no inertia.");
    }
    let Some((mut point, from)) = to_simulate(study) else {
        return say("No motion is shown: the scene has neither a start nor a bound on the speed.");
    };
    point.intervals = point.intervals.min(MOST_INTERVALS);
    let plan = match Plan::compile(&point) {
        Ok(plan) => plan,
        Err(error) => return say(format!("No motion is shown: {error}.")),
    };
    let mut samples = Motion::default();
    let (end, totals) = run::ledger(&plan, |entry| {
        samples.add(entry);
        true
    });
    let outcome = match end.outcome.exact {
        Exactly::AtRest => format!("comes to exact rest after {} intervals", end.intervals),
        Exactly::Growing => format!(
            "grows without end, which is certain after {} intervals",
            end.intervals
        ),
        Exactly::NeverAtRest => "never comes to rest".to_owned(),
        Exactly::Undecided => format!("is undecided after {} intervals", end.intervals),
    };
    let caption = format!(
        "One motion of «{}», {from}, simulated in double precision: it {outcome}. The lowest panel \
         is the energy ledger: {:.5} KΔ² generated and {:.5} KΔ² dissipated in all; the energy \
         balance (13) closes to {:.1e} in every interval. The picture is no part of the proof.",
        study.name(),
        totals.generated_linear,
        totals.dissipated,
        totals.residual_max,
    );
    match motion::draw(study.name(), samples) {
        Ok(svg) => vec![Block::Figure(Figure {
            id: study.anchor("motion"),
            svg,
            alt: format!(
                "Position, velocity and energies over time, and the phase plane. {caption}"
            ),
            caption,
            small: false,
        })],
        Err(error) => say(format!("There is no picture of the motion: {error}.")),
    }
}

/// What accuracy costs in time: measured now, so different at every run.
#[must_use]
pub fn of_accuracy(study: &Study) -> Vec<Block> {
    let simulated = to_simulate(study).filter(|_| study.scene.inertia.is_some());
    let Some((point, _)) = simulated else {
        return Vec::new();
    };
    let table = match accuracy::measure(&point, MOST_MEASURED, |_| {}) {
        Ok(table) => table,
        Err(error) => return say(format!("What accuracy costs was not measured: {error}.")),
    };
    let caption = format!(
        "What accuracy costs on «{}»: error against a reference of 50 digits, and time per interval, \
         measured on this machine over {} intervals when the case was written",
        study.name(),
        table.intervals
    );
    match plot::accuracy::draw(study.name(), &table) {
        Ok(svg) => vec![Block::Figure(Figure {
            id: study.anchor("accuracy"),
            svg,
            alt: caption.clone(),
            caption,
            small: false,
        })],
        Err(error) => say(format!(
            "There is no picture of what accuracy costs: {error}."
        )),
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn the_hardest_end_is_that_of_each_parameter() {
        let text = "[device]\nmass = \"1 kg\"\nviscous = \"4 N s/m ± 1\"\ncoulomb = \"3 N ± 1\"\n\
                    [sampling]\nperiod = \"2 s ± 1\"\n[encoder]\nresolution = \"1 m ± 0.5\"\n\
                    [wall]\nstiffness = \"5 N/m ± 2\"\n[operator]\nmax_speed = \"6 m/s ± 1\"\n";
        let scene = Scene::from_toml("s", text).unwrap();
        let (hardest, moved) = at_hardest_end(&scene);
        let middle = |given: &Given| nearest_f64(&given.nominal.middle());
        let values = [
            hardest.viscous.as_ref(),
            hardest.coulomb.as_ref(),
            Some(&hardest.period),
            hardest.resolution.as_ref(),
            Some(&hardest.stiffness),
            hardest.max_speed.as_ref(),
        ];
        let values: Vec<f64> = values.into_iter().flatten().map(middle).collect();
        assert!(moved);
        assert_eq!(values, [3.0, 2.0, 3.0, 1.5, 7.0, 7.0]);
        let study = Study::new(scene, text.to_owned(), Path::new("s.toml"));
        // 7 m/s over 3 s and 1.5 m: 14 ticks in a sampling period.
        let (point, _) = to_simulate(&study).unwrap();
        assert_eq!(nearest_f64(&point.start[1]), 14.0);
    }
}
