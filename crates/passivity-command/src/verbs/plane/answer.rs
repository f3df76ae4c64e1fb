//! What `passivity plane` answers for a plane of parameters: a document, a table, a few lines.

use std::fmt::Write as _;

use passivity_scene::check::{Report, Verdict};
use passivity_scene::number::nearest_f64;
use passivity_scene::plane::{Extent, Plane, Prediction, Speeds};
use passivity_scene::{Axis, Scene};
use serde::Serialize;

use super::Args;
use super::parameters::Family;

/// What `plane --axes … --format json` prints; numbers in the units of the axes.
#[derive(Serialize)]
pub(super) struct Document<'a> {
    pub(super) axes: [AxisDocument; 2],
    pub(super) scenes: Vec<Placed<'a>>,
    pub(super) borders: Vec<Border<'a>>,
    pub(super) measured: Option<Comparison>,
    pub(super) plot: Option<String>,
    pub(super) out: Option<String>,
}

#[derive(Serialize)]
pub(super) struct AxisDocument {
    pub(super) parameter: &'static str,
    pub(super) unit: String,
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) log: bool,
}

/// Where a scene stands: over its tolerances, `null` where it has no place on an axis.
#[derive(Serialize)]
pub(super) struct Placed<'a> {
    pub(super) scene: &'a str,
    pub(super) x: Option<[f64; 2]>,
    pub(super) y: Option<[f64; 2]>,
    pub(super) verdict: Verdict,
}

/// The border of a region of scenes that share it.
#[derive(Serialize)]
pub(super) struct Border<'a> {
    pub(super) scenes: Vec<&'a str>,
    pub(super) speeds: &'static str,
    pub(super) found_by: &'static str,
    /// Places x, y; the region is on the left of the way.
    pub(super) lines: &'a [Vec<[f64; 2]>],
}

#[derive(Serialize)]
pub(super) struct Comparison {
    pub(super) points: Vec<Compared>,
    pub(super) agree: usize,
    pub(super) stricter: usize,
    pub(super) looser: usize,
    pub(super) not_read: Vec<String>,
}

#[derive(Serialize)]
pub(super) struct Compared {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) stable: bool,
    pub(super) prediction: Prediction,
}

pub(super) fn axis_document(axis: &Axis, extent: &Extent) -> AxisDocument {
    AxisDocument {
        parameter: axis.key(),
        unit: axis.unit(),
        from: extent.from,
        to: extent.to,
        log: extent.log,
    }
}

pub(super) fn placed<'a>(
    axes: &[Axis; 2],
    scenes: &'a [Scene],
    reports: &[Report],
) -> Vec<Placed<'a>> {
    let ends = |axis: &Axis, scene| {
        axis.of_scene(scene)
            .map(|range| [range.lo(), range.hi()].map(nearest_f64))
    };
    let both = scenes.iter().zip(reports);
    both.map(|(scene, report)| Placed {
        scene: &scene.name,
        x: ends(&axes[0], scene),
        y: ends(&axes[1], scene),
        verdict: report.verdict,
    })
    .collect()
}

const fn words(speeds: Speeds) -> &'static str {
    match speeds {
        Speeds::Every => "every_speed",
        Speeds::UpToBound => "up_to_max_speed",
    }
}

fn names<'a>(scenes: &'a [Scene], family: &Family) -> Vec<&'a str> {
    family
        .scenes
        .iter()
        .map(|number| scenes[*number].name.as_str())
        .collect()
}

pub(super) fn borders<'a>(scenes: &'a [Scene], families: &'a [Family]) -> Vec<Border<'a>> {
    let of = |family: &'a Family| {
        family.regions.iter().map(move |(speeds, region)| Border {
            scenes: names(scenes, family),
            speeds: words(*speeds),
            found_by: found_by(&family.plane),
            lines: &region.borders,
        })
    };
    families.iter().flat_map(of).collect()
}

fn found_by(plane: &Plane) -> &'static str {
    if plane.has_formula() {
        "formula"
    } else {
        "search"
    }
}

/// The points of the borders as CSV.
pub(super) fn table(axes: &[Axis; 2], scenes: &[Scene], families: &[Family]) -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let [x, y] = axes.each_ref().map(|axis| quoted(&axis.column()));
    let mut out = format!("scenes,speeds,line,{x},{y}\n");
    for border in borders(scenes, families) {
        let names = quoted(&border.scenes.join("; "));
        for (number, line) in border.lines.iter().enumerate() {
            for [x, y] in line {
                // Writing to a string cannot fail.
                let _ = writeln!(out, "{names},{},{},{x:?},{y:?}", border.speeds, number + 1);
            }
        }
    }
    out
}

pub(super) fn text(
    args: &Args,
    scenes: &[Scene],
    families: &[Family],
    comparison: Option<&Comparison>,
) -> String {
    let count = |n: usize, one: &str| {
        if n == 1 {
            format!("1 {one}")
        } else {
            format!("{n} {one}s")
        }
    };
    let mut lines = Vec::new();
    if let Some(path) = &args.plot {
        lines.push(format!(
            "{} drawn in {}",
            count(scenes.len(), "scene"),
            path.display()
        ));
    }
    if let Some(path) = &args.out {
        let lines_of = |family: &Family| {
            family
                .regions
                .iter()
                .map(|(_, region)| region.borders.len())
                .sum::<usize>()
        };
        let all = families.iter().map(lines_of).sum();
        lines.push(format!(
            "{} written to {}",
            count(all, "border"),
            path.display()
        ));
    }
    let searched = families.iter().any(|family| !family.plane.has_formula());
    lines.push(if searched {
        "borders: searched for by halving; every point passes when it is typed into the scene"
            .to_owned()
    } else {
        "borders: solved exactly; every point passes when it is typed into the scene".to_owned()
    });
    if let Some(comparison) = comparison {
        lines.push(format!(
            "{} measured: {} agree, at {} the criterion is stricter, at {} it is looser",
            count(comparison.points.len(), "point"),
            comparison.agree,
            comparison.stricter,
            comparison.looser
        ));
        if !comparison.not_read.is_empty() {
            lines.push(format!(
                "columns not read: {}",
                comparison.not_read.join(", ")
            ));
        }
    }
    lines.join("\n")
}
