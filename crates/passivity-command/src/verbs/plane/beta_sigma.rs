//! The (β, σ) plane with scenes in it.

use passivity_plot::plane::{Mark, draw_on_axes};
use passivity_scene::check::{Verdict, check};
use serde::Serialize;

use super::{Args, Log};
use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json};

/// What `plane --format json` prints.
#[derive(Serialize)]
struct Document {
    plot: String,
    scenes: Vec<Placed>,
}

/// Where a scene stands.
#[derive(Serialize)]
struct Placed {
    scene: String,
    /// β and σ of the device at the hardest of the ends of the tolerances.
    beta: f64,
    sigma: Option<f64>,
    /// From the least to the largest over the tolerances, less what effects cost beyond ½: where it is drawn.
    beta_less_cost: [f64; 2],
    sigma_less_cost: [f64; 2],
    speed: Option<f64>,
    verdict: Verdict,
}

/// Draws the scenes.
pub(super) fn run(args: &Args) -> Result<Exit, Failure> {
    let needs_axes = [
        ("--out", args.out.is_some()),
        ("--x", args.x.is_some()),
        ("--y", args.y.is_some()),
        ("--measured", args.measured.is_some()),
    ];
    if let Some((option, _)) = needs_axes.iter().find(|(_, given)| *given) {
        return Err(Failure::input(format!(
            "{option} is for a plane of parameters: name them with --axes, as in --axes \
             stiffness,damping"
        )));
    }
    let Some(plot) = &args.plot else {
        return Err(Failure::input("nothing to write the plane to: give --plot"));
    };
    let mut marks = Vec::new();
    let mut documents = Vec::new();
    for (scene, path) in super::scenes(args)?.iter().zip(&args.scenes) {
        let report = check(scene);
        let Some(mark) = Mark::of(scene, &report) else {
            return Err(Failure::input(format!(
                "`{}`: the plane needs an encoder, and `{}` has none",
                path.display(),
                report.scene
            )));
        };
        let (beta, sigma) = mark.friction;
        documents.push(Placed {
            scene: report.scene.clone(),
            beta,
            sigma: Some(sigma),
            beta_less_cost: mark.beta,
            sigma_less_cost: mark.sigma,
            speed: mark.speed.as_ref().map(|(v, _)| *v),
            verdict: report.verdict,
        });
        marks.push(mark);
    }
    let svg =
        draw_on_axes(&marks, args.log.map_or([None, None], Log::axes)).map_err(Failure::input)?;
    passivity_plot::save(&svg, plot).map_err(Failure::input)?;
    let name = plot.display();
    match args.format {
        Format::Text => {
            let scenes = if marks.len() == 1 { "scene" } else { "scenes" };
            emit(&format!("{} {scenes} drawn in {name}", marks.len()))?;
        }
        Format::Json => emit_json(&Document {
            plot: name.to_string(),
            scenes: documents,
        })?,
    }
    Ok(Exit::Holds)
}
