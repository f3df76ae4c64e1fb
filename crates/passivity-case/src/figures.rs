//! Pictures of a scene: its place in the plane, its motion with the energy ledger, and what accuracy
//! costs.

use passivity_core::BigRational;
use passivity_plot::plane::{self, Mark};
use passivity_scene::display::{range, significant};
use passivity_scene::{Point, Scene};
use passivity_sim::plot::motion::{self, Motion};
use passivity_sim::scales::Scales;
use passivity_sim::{ExactOutcome, Plan, accuracy, plot, run};

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
    let (Some(sigma), Some(mark)) = (&report.sigma, Mark::of(&study.scene, report)) else {
        return say(
            "Without an encoder the scene has no place in the (β, σ) plane: σ needs a resolution Δ.",
        );
    };
    let has_tolerance = mark.beta[0] < mark.beta[1] || mark.sigma[0] < mark.sigma[1];
    let has_costs = mark.has_costs;
    let at = format!("β = {}, σ = {}", range(&report.beta), range(sigma));
    let alt = format!(
        "The plane of effective viscous friction β and effective Coulomb friction σ, with the lines \
         β = ½ and σ = ½ that part the regions. The scene is at {at}: {}.",
        mark.verdict.name().replace('_', " ")
    );
    let mut place = String::new();
    if has_tolerance {
        place += "The disc and the arrows are at the hardest of the ends of the tolerances; the rectangle \
                  holds every value within them, as far as the picture goes. ";
    }
    if has_costs {
        place += "It is drawn at β and σ less what its effects cost beyond the two halves of \
                  sampling and quantization. ";
    }
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

/// The motion to show: of which device within the tolerances, where it starts, in which words; `None` for a scene with
/// neither a start nor a bound on the speed.
fn to_simulate(study: &Study) -> Option<(Scene, Point, String)> {
    let scene = study.scene.hardest();
    let mut point = scene.point();
    let mut from = if scene.has_start() {
        "from the start in the scene".to_owned()
    } else {
        let bound = scene.given.max_speed.as_ref()?;
        let speed = point.at.max_speed.clone()?;
        from_surface(&mut point, speed);
        format!(
            "from the surface of the wall at the speed bound, {}",
            bound.text
        )
    };
    if study.scene.has_ends() {
        from.push_str(
            ", at that of the ends of the tolerances at which the criterion is hardest to meet",
        );
    }
    Some((scene, point, from))
}

fn from_surface(point: &mut Point, speed: BigRational) {
    point.at.start_position = None;
    point.at.start_velocity = Some(speed);
}

/// The motion of a scene and its energy ledger; a paragraph that says why not, where there is none.
#[must_use]
pub fn of_motion(study: &Study) -> Vec<Block> {
    if study.scene.given.inertia.is_none() {
        return say("No motion is shown: the scene has no inertia.");
    }
    let Some((hardest, mut point, from)) = to_simulate(study) else {
        return say("No motion is shown: the scene has neither a start nor a bound on the speed.");
    };
    point.intervals = point.intervals.min(MOST_INTERVALS);
    let plan = match Plan::compile(&point) {
        Ok(plan) => plan,
        Err(error) => return say(format!("No motion is shown: {error}.")),
    };
    let mut samples = Motion::new(&plan);
    let (end, totals) = run::ledger(&plan, |entry| {
        samples.add(entry);
        true
    });
    let outcome = match end.outcome.exact {
        ExactOutcome::AtRest => format!("comes to exact rest after {} intervals", end.intervals),
        ExactOutcome::Growing => format!(
            "grows without end, which is certain after {} intervals",
            end.intervals
        ),
        ExactOutcome::NeverAtRest => "never comes to rest".to_owned(),
        ExactOutcome::Undecided => format!("is undecided after {} intervals", end.intervals),
    };
    let scales = Scales::of(&hardest);
    let energy = |x: f64| match scales.ticks {
        true => format!("{} KΔ²", significant(x)),
        false => format!(
            "{} {}",
            significant(x * scales.energy.one),
            scales.energy.unit
        ),
    };
    let caption = format!(
        "One motion of «{}», {from}, simulated in double precision: it {outcome}. The lowest panel \
         is the energy ledger, interval by interval: {} generated and {} dissipated in all; the energy \
         balance (13) is met within {} in every interval. The picture is no part of the proof.",
        study.name(),
        energy(totals.generated_linear),
        energy(totals.dissipated),
        energy(totals.residual_max),
    );
    vec![Block::Figure(Figure {
        id: study.anchor("motion"),
        svg: motion::draw(study.name(), samples, &scales),
        alt: format!("Position, velocity, held force and energy over time. {caption}"),
        caption,
        small: false,
    })]
}

/// What accuracy costs in time: measured now, so different at every run.
#[must_use]
pub fn of_accuracy(study: &Study) -> Vec<Block> {
    let simulated = to_simulate(study).filter(|_| study.scene.given.inertia.is_some());
    let Some((_, point, _)) = simulated else {
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

    use passivity_core::Parameter;

    use super::*;

    #[test]
    fn the_hardest_end_is_that_of_each_parameter() {
        let text = "[device]\nmass = \"1 kg\"\nviscous = \"4 N s/m ± 1\"\ncoulomb = \"3 N ± 1\"\n\
                    [sampling]\nperiod = \"2 s ± 1\"\n[encoder]\nresolution = \"1 m ± 0.5\"\n\
                    [wall]\nstiffness = \"5 N/m ± 2\"\n[operator]\nmax_speed = \"6 m/s ± 1\"\n";
        let scene = Scene::from_toml("s", text).unwrap();
        let hardest = scene.hardest();
        let value = |parameter| {
            let given = hardest.given.get(parameter).unwrap();
            given.nominal.to_rational().unwrap().to_string()
        };
        let parameters = [
            Parameter::Viscous,
            Parameter::Coulomb,
            Parameter::Period,
            Parameter::Resolution,
            Parameter::Stiffness,
            Parameter::MaxSpeed,
        ];
        assert!(scene.has_ends() && !hardest.has_ends());
        assert_eq!(parameters.map(value), ["3", "2", "3", "3/2", "7", "7"]);
        let study = Study::new(scene, text.to_owned(), Path::new("s.toml"));
        // 7 m/s over 3 s and 1.5 m: 14 ticks in a sampling period.
        let (_, point, _) = to_simulate(&study).unwrap();
        assert_eq!(point.start()[1].to_string(), "14");
    }

    /// Behind a delay, damping makes viscous friction cheaper, ½ + 1 − B as far as ¼, and a long period makes it dearer.
    #[test]
    fn the_hardest_end_of_damping_behind_a_delay_is_the_least_damping() {
        let text = |viscous: &str| {
            format!(
                "[device]\nviscous = \"{viscous}\"\ncoulomb = \"50 N\"\n[sampling]\nperiod = \"1 s\"\ndelay = 1\n\
                 [encoder]\nresolution = \"1 m\"\n[wall]\nstiffness = \"1 N/m\"\ndamping = \"0 … 0.5 N s/m\"\n"
            )
        };
        // At a bound on the speed it is what is left of (8) there: at a long period, though a short one leaves a little less
        // of σ.
        let bounded = "[device]\nviscous = \"2.992e-05 N m s/rad\"\ncoulomb = \"0.000991463 N m\"\n[sampling]\n\
            period = \"1.54081 ms ± 30%\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\n\
            stiffness = \"0.00552576 N m/rad\"\ndamping = \"1.6672e-05 N m s/rad\"\n\
            damping_time_constant = \"4.52659 ms\"\n[operator]\nmax_speed = \"1.01703 rad/s\"\n";
        let scene = Scene::from_toml("s", bounded).unwrap();
        let period = &scene.given.period;
        assert_eq!(scene.hardest().given.period.nominal, *period.value.hi());
        for viscous in ["1.3 N s/m", "2.5 N s/m"] {
            let scene = Scene::from_toml("s", &text(viscous)).unwrap();
            let hardest = scene.hardest().given.damping.unwrap().nominal;
            assert_eq!(hardest.to_rational().unwrap().to_string(), "0", "{viscous}");
        }
    }
}
