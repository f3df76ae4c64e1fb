//! Pictures of a scene's motion with its energy ledger, and of what accuracy costs.

use passivity_core::Scalar as _;
use passivity_scene::Point;
use passivity_scene::display::range;
use passivity_sim::plot::motion::{self, Motion};
use passivity_sim::{Exactly, Plan, accuracy, plot, run};

use crate::document::{Block, Figure, Line};
use crate::study::Study;

/// A motion is simulated for at most this many intervals: enough for rest or certain growth on the
/// shipped scenes, and a matter of a second on any.
const MOST_INTERVALS: u64 = 50_000;

/// What accuracy costs is measured over at most this many intervals.
const MOST_MEASURED: u64 = 500;

/// Where the motion of a scene starts, and in which words.
fn start(study: &Study, point: &mut Point) -> Option<String> {
    if study.scene.start.is_some() {
        return Some("from the start in the scene".to_owned());
    }
    let bound = study.report().speed_bound.as_ref()?;
    let speed = (bound.lo() + bound.hi()).half();
    point.start = [passivity_core::BigRational::integer(0), speed];
    Some(format!(
        "from the surface of the wall at the speed bound, {} ticks/sample",
        range(bound)
    ))
}

/// The motion of a scene and its energy ledger; a paragraph that says why not, where there is none.
#[must_use]
pub fn of_motion(study: &Study) -> Vec<Block> {
    let say = |text: String| vec![Block::Paragraph(Line::text(text))];
    let mut point = study.scene.point();
    if point.mu.is_none() {
        return say("No motion is shown: the scene has no inertia.".to_owned());
    }
    let Some(from) = start(study, &mut point) else {
        return say(
            "No motion is shown: the scene has neither a start nor a bound on the speed."
                .to_owned(),
        );
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
            "grows without end, as is certain after {} intervals",
            end.intervals
        ),
        Exactly::NeverAtRest => "never comes to rest".to_owned(),
        Exactly::Undecided => format!("is undecided after {} intervals", end.intervals),
    };
    let caption = format!(
        "Motion of «{}» {from}, simulated in closed form in doubles: it {outcome}. The lowest panel \
         is the energy ledger: generated {:.5}, dissipated {:.5} KΔ² in all; the balance (13) closes \
         to {:.1e} in every interval. A picture, and no part of the proof.",
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
            wide: true,
        })],
        Err(error) => say(format!("No picture of the motion: {error}.")),
    }
}

/// What accuracy costs in time: measured now, so different at every run.
#[must_use]
pub fn of_accuracy(study: &Study) -> Vec<Block> {
    let say = |text: String| vec![Block::Paragraph(Line::text(text))];
    let mut point = study.scene.point();
    if point.mu.is_none() || start(study, &mut point).is_none() {
        return Vec::new();
    }
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
            wide: false,
        })],
        Err(error) => say(format!("No picture of what accuracy costs: {error}.")),
    }
}
