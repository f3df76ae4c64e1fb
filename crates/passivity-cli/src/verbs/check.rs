//! `passivity check`: the verdict.

use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use passivity_scene::AnyScene;
use passivity_scene::any::AnyReport;
use passivity_scene::check::Verdict;
use schemars::JsonSchema;
use serde::Serialize;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, look, may_be_written, scene_at, tell};

/// Say whether the wall of each scene is passive, exactly.
///
/// Prints the verdict, the region of the (β, σ) plane, margins, the critical speed, the stiffest
/// wall, what to change and by how much, and, when the wall is not passive, a motion of the
/// operator that draws energy from it.
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
    if let Some(path) = &args.certificate {
        if args.scenes.len() > 1 {
            return Err(Failure::input("a certificate is of one scene"));
        }
        let inputs: Vec<&Path> = args.scenes.iter().map(PathBuf::as_path).collect();
        may_be_written(path, &inputs, "check")?;
    }
    if !args.watch {
        return check_all(args);
    }
    if args.scenes.iter().any(|path| path.as_os_str() == "-") {
        return Err(Failure::input(
            "standard input is read once: `--watch` needs files",
        ));
    }
    loop {
        let seen = saved(&args.scenes);
        check_all(args)?;
        eprintln!("-- watching; interrupt to end");
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

/// Checks each scene; one that cannot be read does not keep the others from being checked.
fn check_all(args: &Args) -> Result<Exit, Failure> {
    let mut exit = Exit::Holds;
    let mut document = Document {
        units: "SI: m, rad, s, kg, N, N m, J; ticks and samples where a name says nothing of SI",
        scenes: Vec::new(),
        errors: Vec::new(),
    };
    for path in &args.scenes {
        match scene_at(path) {
            Ok(scene) => {
                let report = scene.check();
                if let Some(path) = &args.certificate {
                    certify(&scene, &report, path)?;
                }
                exit = exit.and(exit_of(&report));
                if args.format == Format::Text {
                    emit(&report.to_text())?;
                }
                document.scenes.push(report);
            }
            Err(error) => {
                exit = exit.and(Exit::BadInput);
                eprintln!("{}", error.render(look()).trim_end());
                document.errors.push(error.to_json());
            }
        }
    }
    if args.format == Format::Json {
        emit_json(&document)?;
    }
    Ok(exit)
}

/// Writes what shows the decision about viscous friction, or says why nothing does.
fn certify(scene: &AnyScene, report: &AnyReport, path: &Path) -> Result<(), Failure> {
    match scene.certificate(report) {
        Ok(certificate) => {
            let text = serde_json::to_string_pretty(&certificate);
            let text = text.map_err(|error| Failure::input(format!("no certificate: {error}")))?;
            std::fs::write(path, text + "\n").map_err(|error| Failure::io(path.display(), &error))
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
