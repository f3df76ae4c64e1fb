//! `passivity check`: the verdict.

use std::io::IsTerminal as _;
use std::path::PathBuf;

use passivity_scene::Scene;
use passivity_scene::check::{Report, Verdict, check};
use serde::Serialize;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json};

/// Say whether the wall of each scene is passive, exactly.
///
/// Prints the verdict, the region of the (β, σ) plane, margins, the critical speed, the stiffest
/// wall, what to change and by how much, and, when the wall is not passive, a motion of the
/// operator that draws energy from it.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity check scenes/re35.toml
  passivity check --format json scenes/re35.toml | jq '.scenes[0].verdict'

Exit codes: 0 every scene is passive; 1 one is not, or it depends; 2 bad input; 3 one has an
effect that no theorem covers.")]
pub(crate) struct Args {
    /// Scene files.
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// What `check --format json` prints.
#[derive(Serialize)]
struct Document {
    scenes: Vec<Report>,
    /// What is wrong with the files that could not be read; left out when all could.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    errors: Vec<serde_json::Value>,
}

/// Checks each scene; one that cannot be read does not keep the others from being checked.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let mut exit = Exit::Holds;
    let mut document = Document {
        scenes: Vec::new(),
        errors: Vec::new(),
    };
    for path in &args.scenes {
        match Scene::read(path) {
            Ok(scene) => {
                let report = check(&scene);
                exit = exit.and(exit_of(&report));
                if args.format == Format::Text {
                    emit(&report.to_text())?;
                }
                document.scenes.push(report);
            }
            Err(error) => {
                exit = exit.and(Exit::BadInput);
                eprintln!(
                    "{}",
                    error.render(std::io::stderr().is_terminal()).trim_end()
                );
                document.errors.push(error.to_json());
            }
        }
    }
    if args.format == Format::Json {
        emit_json(&document)?;
    }
    Ok(exit)
}

fn exit_of(report: &Report) -> Exit {
    match report.verdict {
        Verdict::Passive => Exit::Holds,
        Verdict::NotPassive | Verdict::NotGuaranteed | Verdict::Depends => Exit::Fails,
        Verdict::NotCovered => Exit::NotCovered,
    }
}
