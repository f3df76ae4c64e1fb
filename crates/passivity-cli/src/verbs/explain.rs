//! `passivity explain`: the derivation with the scene's numbers.

use std::path::PathBuf;

use passivity_scene::AnyScene;
use passivity_scene::any::AnyExplanation;
use schemars::JsonSchema;
use serde::Serialize;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, look, scene_at};

/// Show the derivation of the verdict with the scene's numbers filled in.
///
/// Lists the effects in the scene and those left out, the equations in force, the theorems used,
/// and what a simulation of the scene computes.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity explain scenes/re35.toml
  passivity explain scenes/filtered-damping.toml --plot frequency.svg")]
pub(crate) struct Args {
    /// The scene file.
    scene: PathBuf,
    /// Draw what the loop costs of β at each frequency into this file, as SVG or PNG according to its
    /// extension; for a linear loop.
    #[cfg(feature = "plot")]
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// What `explain --format json` prints.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Explain")]
pub(crate) struct Document {
    #[serde(flatten)]
    explanation: AnyExplanation,
    /// What `simulate` computes in each interval, a line for each step.
    plan: Vec<String>,
}

/// Explains the scene.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = scene_at(&args.scene).map_err(|error| Failure::Scene(error.render(look())))?;
    let explanation = scene.explain();
    #[cfg(feature = "plot")]
    if let Some(path) = &args.plot {
        let (AnyScene::One(scene), AnyExplanation::One(explanation)) = (&scene, &explanation)
        else {
            return Err(Failure::input(
                "`--plot` draws what a loop costs at each frequency: it needs a device of one joint",
            ));
        };
        let picture = passivity_plot::frequency::draw(scene, &explanation.report);
        let picture = picture
            .map_err(|error| Failure::input(format!("`{}`: {error}", args.scene.display())))?;
        passivity_plot::save(&picture, path).map_err(Failure::input)?;
    }
    let plan = match &scene {
        AnyScene::One(scene) => plan(scene),
        AnyScene::Joints(_) => vec!["none: several joints are not simulated".to_owned()],
    };
    match args.format {
        Format::Text => {
            let mut text = explanation.to_text();
            text += "\nSimulation, in each interval\n";
            for line in plan {
                text += &format!("  {line}\n");
            }
            emit(&text)?;
        }
        Format::Json => emit_json(&Document { explanation, plan })?,
    }
    Ok(Exit::Holds)
}

/// What `simulate` computes in each interval, or why it cannot.
#[cfg(feature = "simulate")]
fn plan(scene: &passivity_scene::Scene) -> Vec<String> {
    match passivity_sim::Plan::compile(&scene.point()) {
        Ok(plan) => plan.describe(),
        Err(error) => vec![format!("none: {error}")],
    }
}

#[cfg(not(feature = "simulate"))]
fn plan(_: &passivity_scene::Scene) -> Vec<String> {
    let reason = "the simulator is not in this build: build it with the feature `simulate`";
    vec![format!("none: {reason}")]
}
