//! `passivity case`: the safety case.

mod recordings;

use std::path::{Path, PathBuf};

use passivity_audit::{legible, shell_word};
use passivity_case::case::Objection;
use passivity_case::check::{Findings, check};
use passivity_case::{Case, Info, Records, Study, folder, print, tree};
use passivity_scene::check::Verdict;
use serde_json::json;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json};
use recordings::Options;

/// Write the safety case of scenes, or check a written one against the sources.
///
/// The case is a folder with the document (HTML, and with --pdf also PDF), the argument of each scene
/// in Goal Structuring Notation (YAML and SVG), the scenes, and a manifest of hashes. Evidence that
/// was recorded for other sources is shown as stale, evidence that was never recorded as not run
/// here.
#[derive(Debug, clap::Args)]
#[command(
    override_usage = "passivity case [OPTIONS] --out <DIR> <SCENE>...
       passivity case [OPTIONS] --check <DIR>",
    after_help = "Examples:
  passivity case scenes/re35.toml --out case
  passivity case scenes/re35.toml --out case --strict
  passivity case scenes/re35.toml --out case --info device.toml --pdf
  passivity case scenes/re35.toml --out case --log run.csv --identification push.csv \\
      --device 'trainer 7' --date 2026-11-20
  passivity case --check case

Logs are evidence about the device: each --log is audited as passivity audit does, and friction is
identified from all --identification together as passivity identify does, with the scene as what is
known. A log that fails its audit, a force that is not the wall's, and friction outside of what the
scene says contradict the case: its top goal is then not shown. A case with logs is of one scene.

The file of --info is TOML with the fields title, author, reviewer, approval, intended_use and date,
each of which may be left out.

Exit codes: 0 every scene is passive and every log supports it (with --check: the case is current,
whatever it says); 1 not, or with --strict something is stale, missing, open or defeated; 2 bad
input, or --pdf found no browser to print with (the rest of the case is written); 3 a scene has an
effect that no theorem covers, or that the account of a log leaves out."
)]
pub(crate) struct Args {
    /// Scene files.
    #[arg(
        required_unless_present = "check",
        conflicts_with = "check",
        value_name = "SCENE"
    )]
    scenes: Vec<PathBuf>,
    /// The folder to write, new or with an earlier case in it.
    #[arg(
        long,
        value_name = "DIR",
        required_unless_present = "check",
        conflicts_with = "check"
    )]
    out: Option<PathBuf>,
    /// Check the case in this folder against the sources instead of writing one.
    #[arg(long, value_name = "DIR")]
    check: Option<PathBuf>,
    /// Exit with 1 on anything that is stale, missing, open or defeated.
    #[arg(long)]
    strict: bool,
    /// Where the claims and the sources are; by default the nearest folder, from here up, with
    /// proofs/claims.toml in it, and without one what this build carries.
    #[arg(long, value_name = "DIR")]
    root: Option<PathBuf>,
    /// Recorded evidence to read; by default what `make prove` recorded last under the root, or what was
    /// committed there if more of that is fresh.
    #[arg(long, value_name = "FILE")]
    evidence: Option<PathBuf>,
    /// Who wrote the case, who reviewed and approved it, for which use, and when: a small TOML file.
    #[arg(long, value_name = "FILE", conflicts_with = "check")]
    info: Option<PathBuf>,
    #[command(flatten)]
    recordings: Options,
    /// Also print the document as PDF, with the headless browser that the environment variable
    /// PASSIVITY_BROWSER names, else with chromium, chromium-browser or google-chrome on the PATH.
    #[arg(long, conflicts_with = "check")]
    pdf: bool,
    /// Also measure what accuracy costs in time; the figures differ from run to run.
    #[arg(long, conflicts_with = "check")]
    accuracy: bool,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

impl Args {
    /// The options that change what is written, beside the folder and what is recorded, as they are typed.
    fn typed(&self) -> Vec<String> {
        let files = [
            ("--root", &self.root),
            ("--evidence", &self.evidence),
            ("--info", &self.info),
        ];
        let files = files.into_iter().filter_map(|(name, path)| {
            let path = path.as_ref()?.to_string_lossy();
            Some(format!("{name} {}", shell_word(&legible(&path))))
        });
        let switches = [("--pdf", self.pdf), ("--accuracy", self.accuracy)];
        let switches = switches.into_iter().filter(|(_, is_on)| *is_on);
        files
            .chain(switches.map(|(name, _)| name.to_owned()))
            .collect()
    }
}

/// Writes or checks a case.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let records =
        Records::read(root(args)?.as_deref(), args.evidence.as_deref()).map_err(Failure::input)?;
    match (&args.check, &args.out) {
        (Some(folder), _) => compare(args, folder, &records),
        (None, Some(out)) => write(args, out, records),
        (None, None) => Err(Failure::input("expected --out DIR or --check DIR")),
    }
}

fn root(args: &Args) -> Result<Option<PathBuf>, Failure> {
    if let Some(root) = &args.root {
        if !root.join(tree::CLAIMS).is_file() {
            let name = root.display();
            return Err(Failure::input(format!(
                "`{name}`: expected a folder with {}",
                tree::CLAIMS
            )));
        }
        return Ok(Some(root.clone()));
    }
    let here = std::env::current_dir().map_err(|error| Failure::io("this folder", &error))?;
    Ok(tree::find_root(&here))
}

fn write(args: &Args, out: &Path, records: Records) -> Result<Exit, Failure> {
    let studies = args.scenes.iter().map(|path| Study::read(path));
    let mut studies = studies
        .collect::<Result<Vec<_>, _>>()
        .map_err(Failure::input)?;
    if let Some(given) = args.recordings.given()? {
        let [study] = studies.as_mut_slice() else {
            return Err(Failure::input(
                "a log is of a device in one scene: write a case of that scene alone",
            ));
        };
        study.recorded = Some(recordings::read(given, study)?);
    }
    let info = args.info.as_deref().map(Info::read).transpose();
    let info = info.map_err(Failure::input)?;
    let history = folder::history(out).map_err(Failure::input)?;
    let mut case = Case::new(studies, records, history);
    case.measured = args.accuracy;
    case.options = args.typed();
    case.info = info;
    folder::write(&case, out).map_err(Failure::input)?;
    if args.pdf {
        print_pdf(out)?;
    }
    let objections = case.objections();
    match args.format {
        Format::Text => emit(&summary(&case, out, &objections))?,
        Format::Json => emit_json(&document(&case, out, args.pdf, &objections))?,
    }
    let verdicts = case.studies.iter().map(|study| {
        let recorded = study.recorded.as_ref();
        let recorded = recorded.map_or(Exit::Holds, |found| {
            recordings::exit_of(found, &study.scene)
        });
        exit_of(study.report().verdict).and(recorded)
    });
    let exit = verdicts.fold(Exit::Holds, Exit::and);
    Ok(if args.strict && !objections.is_empty() {
        exit.and(Exit::Fails)
    } else {
        exit
    })
}

/// Prints the document of the written case; without a browser, says how to do it by hand.
fn print_pdf(out: &Path) -> Result<(), Failure> {
    let page = out.join(folder::HTML);
    let by_hand = format!(
        "the case is written; to print it by hand, open `{}` in a browser, choose Print, and save it \
         as PDF, outside of the folder of the case",
        page.display()
    );
    let browser = print::browser(std::env::var_os(print::VARIABLE), std::env::var_os("PATH"));
    let Some(browser) = browser else {
        return Err(Failure::input(format!(
            "--pdf: expected a browser on the PATH ({}), or one that {} names\n{by_hand}",
            print::BROWSERS.join(", "),
            print::VARIABLE
        )));
    };
    folder::add_pdf(out, &browser)
        .map_err(|error| Failure::input(format!("--pdf: {error}\n{by_hand}")))
}

const fn exit_of(verdict: Verdict) -> Exit {
    match verdict {
        Verdict::Passive => Exit::Holds,
        Verdict::NotPassive | Verdict::NotGuaranteed | Verdict::Depends => Exit::Fails,
        Verdict::NotCovered => Exit::NotCovered,
    }
}

fn summary(case: &Case, out: &Path, objections: &[Objection]) -> String {
    let mut text = format!(
        "Safety case written: {}\n",
        out.join(folder::HTML).display()
    );
    for (study, argument) in case.scenes() {
        let line = format!(
            "  {}: {}; top goal {}\n",
            study.name(),
            study.report().headline(),
            argument.standing().words()
        );
        text.push_str(&line);
        text.push_str(&recordings::summary(study));
    }
    text.push_str(&points(objections));
    text
}

/// What a strict reader objects to, a line each.
fn points(objections: &[Objection]) -> String {
    if objections.is_empty() {
        return "  Nothing is open, stale or missing.\n".to_owned();
    }
    let lines = objections
        .iter()
        .map(|objection| format!("    {objection}\n"));
    let lines: String = lines.collect();
    format!(
        "  Open, stale, missing or defeated: {}\n{lines}",
        objections.len()
    )
}

fn document(case: &Case, out: &Path, pdf: bool, objections: &[Objection]) -> serde_json::Value {
    let scenes: Vec<_> = case
        .scenes()
        .map(|(study, argument)| {
            json!({ "scene": study.name(), "name": study.slug,
                "verdict": study.report().verdict.name(),
                "top_goal": argument.top().id, "standing": argument.standing().words(),
                "recorded": study.recorded.as_ref().map(|found| found.to_json(&study.scene)) })
        })
        .collect();
    let objections: Vec<String> = objections.iter().map(ToString::to_string).collect();
    let pdf = pdf.then_some(folder::PDF);
    json!({ "out": out.to_string_lossy(), "pdf": pdf, "scenes": scenes, "objections": objections })
}

fn compare(args: &Args, folder: &Path, records: &Records) -> Result<Exit, Failure> {
    let findings = check(folder, records).map_err(Failure::input)?;
    match args.format {
        Format::Text => emit(&compared(folder, &findings))?,
        Format::Json => emit_json(&json!({
            "case": folder.to_string_lossy(), "current": findings.is_current(),
            "changed": findings.changed, "evidence": findings.stale,
            "unchanged": findings.unchanged, "not_compared": findings.not_at_hand,
            "scenes": findings.standing.iter().map(|scene| json!({
                "scene": scene.scene, "name": scene.name, "verdict": scene.verdict,
                "standing": scene.standing,
            })).collect::<Vec<_>>(),
            "objections": findings.objections.iter().map(ToString::to_string).collect::<Vec<_>>(),
        }))?,
    }
    let complete = findings.not_at_hand.is_empty() && findings.objections.is_empty();
    Ok(if findings.is_current() && (complete || !args.strict) {
        Exit::Holds
    } else {
        Exit::Fails
    })
}

fn compared(folder: &Path, findings: &Findings) -> String {
    let current = if findings.is_current() {
        "the case is current"
    } else {
        "the case is NOT current"
    };
    let mut text = format!(
        "{}: {current}\n  {} records of evidence stand as they did\n",
        folder.display(),
        findings.unchanged
    );
    let lists = [
        ("changed", &findings.changed),
        ("evidence", &findings.stale),
        ("not compared", &findings.not_at_hand),
    ];
    for (word, lines) in lists {
        for line in lines {
            text.push_str(&format!("  {word}: {line}\n"));
        }
    }
    for scene in &findings.standing {
        text.push_str(&format!(
            "  {}: {}; top goal {}\n",
            scene.scene, scene.headline, scene.standing
        ));
    }
    text.push_str(&points(&findings.objections));
    text
}
