//! `passivity check`: the verdict.

use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use passivity_scene::AnyScene;
use passivity_scene::any::AnyReport;
use passivity_scene::check::Verdict;
use schemars::JsonSchema;
use serde::Serialize;

use crate::exit::{Exit, Failure};
use crate::files::{may_be_written, sources, write};
use crate::output::{Format, emit_json, emit_to_reader, look, scene_at, tell, tell_drawn};

/// Say whether the wall of each scene is passive, exactly.
///
/// Prints the verdict, the region of the (β, σ) plane, margins, the critical speed, the stiffest
/// wall, what to change and by how much, and, when the wall is not passive, a motion of the
/// operator that draws energy from it. β = b/(KT) is viscous friction b over stiffness K and sampling
/// period T, and σ = c/(KΔ) Coulomb friction c over stiffness and the encoder's resolution Δ.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity check scenes/re35.toml
  passivity check --format json scenes/re35.toml | jq '.scenes[0].verdict'
  passivity init rotary | passivity check -
  passivity check --watch knob.toml
  passivity check --certificate frequencies.json scenes/digital-controller.toml

Exit codes: 0 every scene is passive; 1 one is not, or it depends; 2 bad input; 3 one has an
effect that no theorem covers.")]
pub(crate) struct Args {
    /// Scene files; `-` is standard input.
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Check again whenever one of the files is saved, until interrupted.
    #[arg(long, conflicts_with = "format")]
    watch: bool,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Write the decision whether viscous friction is enough at every frequency to a JSON file, with what
    /// shows it; of one scene.
    #[arg(long, value_name = "FILE", conflicts_with = "watch")]
    certificate: Option<PathBuf>,
}

/// What `check --format json` prints.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Check")]
pub(crate) struct Document {
    /// The units of the figures: programs get SI, whatever the scene was written in.
    units: &'static str,
    scenes: Vec<AnyReport>,
    /// What is wrong with the files that could not be read; left out when all could.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    errors: Vec<serde_json::Value>,
}

/// How often the files are looked at.
const GLANCE: Duration = Duration::from_millis(200);

/// Checks each scene; with `--watch` again whenever one of the files was saved.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    if args.certificate.is_some() && args.scenes.len() > 1 {
        return Err(Failure::input("a certificate is of one scene"));
    }
    if !args.watch {
        return check_all(args).map(|(exit, _)| exit);
    }
    if args.scenes.iter().any(|path| path.as_os_str() == "-") {
        return Err(Failure::input(
            "standard input is read once: `--watch` needs files",
        ));
    }
    loop {
        let seen = saved(&args.scenes);
        let (exit, is_heard) = check_all(args)?;
        if !is_heard {
            return Ok(exit);
        }
        tell("-- watching; interrupt to end");
        while saved(&args.scenes) == seen {
            std::thread::sleep(GLANCE);
        }
    }
}

/// When each file was saved last, and its size; `None` where it is not there.
fn saved(paths: &[PathBuf]) -> Vec<Option<(SystemTime, u64)>> {
    let one = |path: &PathBuf| {
        let meta = std::fs::metadata(path).ok()?;
        Some((meta.modified().ok()?, meta.len()))
    };
    paths.iter().map(one).collect()
}

/// Checks each scene, and says whether somebody still reads that; one that cannot be read does not keep the others
/// from being checked.
fn check_all(args: &Args) -> Result<(Exit, bool), Failure> {
    let (mut exit, mut is_heard) = (Exit::Holds, true);
    let mut document = Document {
        units: "SI: m, rad, s, kg, N, N m, J; ticks and samples where a name says nothing of SI; without an encoder m or rad for ticks",
        scenes: Vec::new(),
        errors: Vec::new(),
    };
    for path in &args.scenes {
        match scene_at(path) {
            Ok(scene) => {
                let report = scene.check();
                if let Some(certificate) = &args.certificate {
                    certify(certificate, path, &scene, &report)?;
                }
                exit = exit.and(exit_of(&report));
                if args.format == Format::Text {
                    is_heard &= emit_to_reader(&report.to_text())?;
                }
                document.scenes.push(report);
            }
            Err(error) => {
                exit = exit.and(Exit::BadInput);
                tell_drawn(&error.render(look()));
                document.errors.push(error.to_json());
            }
        }
    }
    if args.format == Format::Json {
        emit_json(&document)?;
    }
    Ok((exit, is_heard))
}

/// Writes what shows the decision about viscous friction, or says why nothing does.
fn certify(
    certificate: &PathBuf,
    path: &Path,
    scene: &AnyScene,
    report: &AnyReport,
) -> Result<(), Failure> {
    let inputs = match scene {
        AnyScene::One(scene) => sources(scene, path),
        AnyScene::Joints(_) => vec![path.to_owned()],
    };
    may_be_written(&[("--certificate", Some(certificate))], &inputs, "check")?;
    match scene.certificate(report) {
        Ok(shown) => {
            let text = serde_json::to_string_pretty(&shown);
            let text = text.map_err(|error| Failure::input(format!("no certificate: {error}")))?;
            write(certificate, &(text + "\n"))
        }
        Err(because) => {
            tell(&format!("no certificate is written: {because}"));
            Ok(())
        }
    }
}

fn exit_of(report: &AnyReport) -> Exit {
    match report.verdict() {
        Verdict::Passive => Exit::Holds,
        Verdict::NotPassive | Verdict::NotGuaranteed | Verdict::Depends => Exit::Fails,
        Verdict::NotCovered => Exit::NotCovered,
    }
}
