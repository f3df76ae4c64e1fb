//! `passivity plane`: the (β, σ) plane with scenes in it.

use std::path::PathBuf;

use passivity_core::{BigRational, Interval, Scalar as _};
use passivity_plot::plane::{Mark, draw};
use passivity_scene::check::check;
use passivity_scene::display::range;
use passivity_scene::number::nearest_f64;
use serde_json::json;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, read_scene};

/// Draw the (β, σ) plane (Figs. 3 and 4 of the paper) with the scenes in it.
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
    /// Where to write the picture: a name that ends in .svg or .png.
    #[arg(long, value_name = "FILE")]
    plot: PathBuf,
    /// For people or for programs.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Draws the scenes.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let mut marks = Vec::new();
    let mut documents = Vec::new();
    for path in &args.scenes {
        let scene = read_scene(path)?;
        let report = check(&scene);
        let middle = |x: &Interval<BigRational>| nearest_f64(&(x.lo() + x.hi()).half());
        let Some(sigma) = &report.sigma else {
            return Err(Failure::input(format!(
                "`{}`: the plane needs an encoder, and `{}` has none",
                path.display(),
                report.scene
            )));
        };
        let bound = report
            .speed_bound
            .as_ref()
            .map(|v| (middle(v), format!("{} ticks/sample", range(v))));
        let mark = Mark {
            name: report.scene.clone(),
            beta: middle(&report.beta),
            sigma: middle(sigma),
            tolerance: None,
            speed: bound.filter(|(v, _)| *v > 0.0),
            verdict: report.verdict.name().replace('_', " "),
        };
        documents.push(
            json!({ "scene": mark.name, "beta": mark.beta, "sigma": mark.sigma,
            "speed": mark.speed.as_ref().map(|(v, _)| v), "verdict": report.verdict.name() }),
        );
        marks.push(mark);
    }
    let svg = draw(&marks).map_err(Failure::input)?;
    passivity_plot::save(&svg, &args.plot).map_err(Failure::input)?;
    let name = args.plot.display();
    match args.format {
        Format::Text => emit(&format!("{} scenes drawn in {name}", marks.len()))?,
        Format::Json => emit_json(&json!({ "plot": name.to_string(), "scenes": documents }))?,
    }
    Ok(Exit::Holds)
}
