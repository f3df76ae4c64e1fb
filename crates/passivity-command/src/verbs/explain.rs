//! `passivity explain`: the derivation with the scene's numbers.

use std::path::PathBuf;

use passivity_scene::AnyScene;
use passivity_scene::explain::{Explanation, explain};
use passivity_scene::joints::JointExplanation;
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
  passivity explain scenes/filtered-damping.toml --plot frequency.svg

Exit codes: 0 it is explained, whatever the verdict is; 2 bad input.")]
pub(crate) struct Args {
    /// The scene file.
    scene: PathBuf,
    /// Draw what the loop costs of β at each frequency into this file, as SVG or PNG according to its
    /// extension; for a linear loop. Coulomb friction and bounds on the speed are not in the picture.
    #[cfg(feature = "plot")]
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// What `explain --format json` prints.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
#[schemars(rename = "Explain")]
pub(crate) enum Document {
    /// Of a device of one joint.
    One(Box<Planned<Explanation>>),
    /// Of a device of several joints.
    Joints(Box<Planned<JointExplanation>>),
}

/// An explanation, and what a simulation does.
#[derive(Serialize, JsonSchema)]
pub(crate) struct Planned<E> {
    #[serde(flatten)]
    explanation: E,
    /// What `simulate` computes in each interval, a line for each step.
    plan: Vec<String>,
}

/// Explains the scene.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = scene_at(&args.scene).map_err(|error| Failure::Scene(error.render(look())))?;
    let (text, document) = match &scene {
        AnyScene::One(scene) => {
            #[cfg(feature = "plot")]
            may_be_drawn(args, scene)?;
            let explanation = explain(scene);
            #[cfg(feature = "plot")]
            if let Some(path) = &args.plot {
                let picture = passivity_plot::frequency::draw(scene, &explanation.report);
                let picture = picture.map_err(|error| {
                    Failure::input(format!("`{}`: {error}", args.scene.display()))
                })?;
                passivity_plot::save(&picture, path).map_err(Failure::input)?;
            }
            let (text, plan) = (explanation.to_text(), plan(scene));
            let text = with_plan(text, &plan);
            (text, Document::One(Box::new(Planned { explanation, plan })))
        }
        AnyScene::Joints(scene) => {
            #[cfg(feature = "plot")]
            if args.plot.is_some() {
                return Err(Failure::input(
                    "`--plot` draws what a loop costs at each frequency: it needs a device of one joint",
                ));
            }
            let explanation = passivity_scene::joints::explain(scene);
            let plan = vec!["none: several joints are not simulated".to_owned()];
            let text = with_plan(explanation.to_text(), &plan);
            (
                text,
                Document::Joints(Box::new(Planned { explanation, plan })),
            )
        }
    };
    match args.format {
        Format::Text => emit(&text)?,
        Format::Json => emit_json(&document)?,
    }
    Ok(Exit::Holds)
}

/// Refuses a picture that cannot be written.
#[cfg(feature = "plot")]
fn may_be_drawn(args: &Args, scene: &passivity_scene::Scene) -> Result<(), Failure> {
    let inputs = crate::files::sources(scene, &args.scene);
    crate::files::may_be_written(&[("--plot", args.plot.as_ref())], &inputs, "explanation")?;
    crate::picture::check(args.plot.as_deref())
}

fn with_plan(mut text: String, plan: &[String]) -> String {
    text += "\nSimulation, in each interval\n";
    for line in plan {
        text += &format!("  {line}\n");
    }
    text
}

/// What `simulate` computes in each interval, or why it cannot.
#[cfg(feature = "simulate")]
fn plan(scene: &passivity_scene::Scene) -> Vec<String> {
    match passivity_sim::Plan::compile(&scene.point()) {
        Ok(plan) => {
            let nominal = scene.nominal();
            let nominal =
                nominal.map(|(_, given)| format!("at {} {}", given.key, given.nominal_text()));
            plan.describe().into_iter().chain(nominal).collect()
        }
        Err(error) => vec![format!("none: {error}")],
    }
}

#[cfg(not(feature = "simulate"))]
fn plan(_: &passivity_scene::Scene) -> Vec<String> {
    let reason = "the simulator is not in this build: build it with the feature `simulate`";
    vec![format!("none: {reason}")]
}
