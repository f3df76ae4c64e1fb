//! `passivity plane`: the (β, σ) plane with scenes in it.

use std::path::PathBuf;

use passivity_core::{BigRational, Interval};
use passivity_plot::plane::{Mark, draw};
use passivity_scene::check::{Verdict, check};
use passivity_scene::number::nearest_f64;
use serde::Serialize;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, read_scene};

/// Draw the (β, σ) plane of the paper's Figs. 3 and 4 and mark the scenes in it.
///
/// Shows the regions, the critical line of each scene at its speed bound, and where another
/// stiffness, sampling period or encoder resolution would move it.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity plane scenes/re35.toml --plot plane.svg
  passivity plane scenes/re35-*.toml --plot plane.png")]
pub(crate) struct Args {
    /// Scene files.
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Draw the plane into this file, as SVG or PNG according to its extension.
    #[arg(long, value_name = "FILE")]
    plot: PathBuf,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

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
    /// β and σ in the middle of their tolerances.
    beta: f64,
    sigma: Option<f64>,
    /// From the least to the largest, less what effects cost beyond ½: where it is drawn.
    beta_less_cost: [f64; 2],
    sigma_less_cost: [f64; 2],
    speed: Option<f64>,
    verdict: Verdict,
}

/// Draws the scenes.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let mut marks = Vec::new();
    let mut documents = Vec::new();
    for path in &args.scenes {
        let scene = read_scene(path)?;
        let report = check(&scene);
        let Some(mark) = Mark::of(&scene, &report) else {
            return Err(Failure::input(format!(
                "`{}`: the plane needs an encoder, and `{}` has none",
                path.display(),
                report.scene
            )));
        };
        let middle = |x: &Interval<BigRational>| nearest_f64(&x.middle());
        documents.push(Placed {
            scene: report.scene.clone(),
            beta: middle(&report.beta),
            sigma: report.sigma.as_ref().map(middle),
            beta_less_cost: mark.beta,
            sigma_less_cost: mark.sigma,
            speed: mark.speed.as_ref().map(|(v, _)| *v),
            verdict: report.verdict,
        });
        marks.push(mark);
    }
    let svg = draw(&marks).map_err(Failure::input)?;
    passivity_plot::save(&svg, &args.plot).map_err(Failure::input)?;
    let name = args.plot.display();
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
