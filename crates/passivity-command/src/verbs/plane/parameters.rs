//! The plane of two parameters: borders, scenes and measured points.

use std::path::Path;

use passivity_core::{BigRational, Interval};
use passivity_plot::parameters::{Group, Mark, Picture, Point, draw};
use passivity_scene::check::{Report, check};
use passivity_scene::number::nearest_f64;
use passivity_scene::plane::{
    Extent, Measured, Plane, PlaneError, Prediction, Region, Speeds, Window, window,
};
use passivity_scene::{Axis, Motion, Scene};

use super::answer::{Compared, Comparison, Document, axis_document, borders, placed, table, text};
use super::{Args, Log};
use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json};

/// Scenes with the same border.
pub(super) struct Family {
    pub(super) plane: Plane,
    pub(super) scenes: Vec<usize>,
    pub(super) regions: Vec<(Speeds, Region)>,
}

pub(super) fn run(args: &Args, names: [&str; 2]) -> Result<Exit, Failure> {
    if args.plot.is_none() && args.out.is_none() && args.format == Format::Text {
        let message = "nothing to write the plane to: give --plot, --out or --format json";
        return Err(Failure::input(message));
    }
    let scenes = super::scenes(args)?;
    let axes = axes(names, &scenes)?;
    let mut families: Vec<Family> = Vec::new();
    for (number, scene) in scenes.iter().enumerate() {
        let plane = Plane::new(scene, axes.clone()).map_err(of_axes(args))?;
        match families
            .iter_mut()
            .find(|family| family.plane.has_same_border(&plane))
        {
            Some(family) => family.scenes.push(number),
            None => families.push(Family {
                plane,
                scenes: vec![number],
                regions: Vec::new(),
            }),
        }
    }
    let measured = measured(args, &scenes, &families)?;
    let points: Vec<[f64; 2]> = measured
        .iter()
        .flat_map(|m| &m.points)
        .map(|p| p.place())
        .collect();
    let window = window_of(args, &scenes, &families, &points)?;
    find_regions(&mut families, &window);
    let reports: Vec<Report> = scenes.iter().map(check).collect();
    let comparison = measured.map(|measured| compared(&measured, &families));
    if let Some(path) = &args.plot {
        let picture = picture(
            &axes,
            &window,
            &scenes,
            &families,
            &reports,
            comparison.as_ref(),
        );
        passivity_plot::save(&picture, path).map_err(Failure::input)?;
    }
    if let Some(path) = &args.out {
        let table = table(&axes, &scenes, &families);
        crate::files::write(path, &table)?;
    }
    match args.format {
        Format::Text => emit(&text(args, &scenes, &families, comparison.as_ref()))?,
        Format::Json => emit_json(&Document {
            axes: [0, 1].map(|i| axis_document(&axes[i], &window[i])),
            scenes: placed(&axes, &scenes, &reports),
            borders: borders(&scenes, &families),
            measured: comparison,
            plot: shown(args.plot.as_deref()),
            out: shown(args.out.as_deref()),
        })?,
    }
    Ok(Exit::Holds)
}

fn shown(path: Option<&Path>) -> Option<String> {
    path.map(|path| path.display().to_string())
}

fn of_axes(args: &Args) -> impl Fn(PlaneError) -> Failure {
    let axes = args.axes.clone();
    move |error| Failure::input(format!("--axes `{axes}`: {error}"))
}

/// The axes, in the units of the first scene that gives the parameter.
fn axes(names: [&str; 2], scenes: &[Scene]) -> Result<[Axis; 2], Failure> {
    let Some(first) = scenes.first() else {
        return Err(Failure::input("a plane needs a scene"));
    };
    if let Some(other) = scenes.iter().find(|scene| scene.motion != first.motion) {
        let words = |motion| match motion {
            Motion::Linear => "linear",
            Motion::Rotary => "rotary",
            Motion::Dimensionless => "dimensionless",
        };
        return Err(Failure::input(format!(
            "`{}` is {} and `{}` is {}: a plane of parameters has one unit on each axis",
            first.name,
            words(first.motion),
            other.name,
            words(other.motion)
        )));
    }
    let parse = |name: &str| {
        let axis = |scene| {
            let axis = Axis::parse_for(name, scene, Plane::refusal);
            axis.map_err(|error| Failure::input(format!("--axes {error}")))
        };
        let parameter = axis(first)?.parameter();
        let gives = |scene: &&Scene| {
            scene
                .parameters()
                .iter()
                .any(|(given, _)| *given == parameter)
        };
        let scene = scenes.iter().find(gives).unwrap_or(first);
        let shown = axis(scene)?;
        let mut others = scenes.iter().filter(|other| !std::ptr::eq(*other, scene));
        match others.find(|other| !shown.is_of(other)) {
            Some(other) => Err(Failure::input(format!(
                "--axes `{}` is not the same in `{}` and `{}`, of which a transmission or the side of it differs: \
                 write it at the device, as in `{}`",
                shown.column(),
                scene.name,
                other.name,
                shown.at_device()
            ))),
            None => Ok(shown),
        }
    };
    let [x, y] = names;
    Ok([parse(x)?, parse(y)?])
}

fn measured(
    args: &Args,
    scenes: &[Scene],
    families: &[Family],
) -> Result<Option<Measured>, Failure> {
    let Some(path) = &args.measured else {
        return Ok(None);
    };
    let ([scene], [family]) = (scenes, families) else {
        return Err(Failure::input(format!(
            "--measured compares points with one scene, and {} are given",
            scenes.len()
        )));
    };
    Measured::read(path, &family.plane, scene)
        .map(Some)
        .map_err(Failure::input)
}

fn window_of(
    args: &Args,
    scenes: &[Scene],
    families: &[Family],
    points: &[[f64; 2]],
) -> Result<[Extent; 2], Failure> {
    let range = |option: &str, text: &Option<String>| -> Result<Option<[f64; 2]>, Failure> {
        let Some(text) = text else { return Ok(None) };
        let ends = text
            .split_once(':')
            .map(|(from, to)| [from, to].map(|end| end.trim().parse::<f64>().ok()));
        match ends {
            Some([Some(from), Some(_)]) if from < 0.0 => Err(Failure::input(format!(
                "{option} `{text}`: expected FROM not below zero, as in 0:2.5"
            ))),
            Some([Some(from), Some(to)]) if to.is_finite() => Ok(Some([from, to])),
            Some([Some(_), Some(_)]) => Err(Failure::input(format!(
                "{option} `{text}`: expected TO up to {:.1e}",
                f64::MAX
            ))),
            _ => Err(Failure::input(format!(
                "{option} `{text}`: expected FROM:TO, as in 0:2.5"
            ))),
        }
    };
    let log = args.log.map_or([None, None], Log::axes);
    let asked = Window {
        log,
        range: [range("--x", &args.x)?, range("--y", &args.y)?],
    };
    let planes: Vec<(&Scene, &Plane)> = families
        .iter()
        .flat_map(|family| {
            family
                .scenes
                .iter()
                .map(move |number| (&scenes[*number], &family.plane))
        })
        .collect();
    let window = window(&planes, points, &asked).map_err(Failure::input)?;
    for (option, axis) in ["--x", "--y"].into_iter().zip(&window) {
        if !axis.to.is_finite() || (axis.log && !(axis.to / axis.from).is_finite()) {
            return Err(Failure::input(format!(
                "an axis from {:e} to {:e} is longer than numbers tell apart: say less of it with {option} FROM:TO, as \
                 in 1:100, and leave out measured points that are far from it",
                axis.from, axis.to
            )));
        }
    }
    Ok(window)
}

/// Finds the regions of every family, all at once.
fn find_regions(families: &mut [Family], window: &[Extent; 2]) {
    std::thread::scope(|scope| {
        for family in families {
            scope.spawn(move || {
                let of = |speeds| (speeds, Region::of(&family.plane, window, speeds));
                family.regions = family.plane.speeds().into_iter().map(of).collect();
            });
        }
    });
}

fn compared(measured: &Measured, families: &[Family]) -> Comparison {
    let points: Vec<Compared> = measured
        .points
        .iter()
        .flat_map(|point| families.first().map(|family| (point, family)))
        .map(|(point, family)| {
            let [x, y] = point.place();
            Compared {
                x,
                y,
                stable: point.stable,
                prediction: point.predicted(&family.plane),
            }
        })
        .collect();
    let count = |prediction| {
        points
            .iter()
            .filter(|point| point.prediction == prediction)
            .count()
    };
    Comparison {
        agree: count(Prediction::Agree),
        stricter: count(Prediction::Stricter),
        looser: count(Prediction::Looser),
        not_read: measured.not_read.clone(),
        points,
    }
}

fn picture(
    axes: &[Axis; 2],
    window: &[Extent; 2],
    scenes: &[Scene],
    families: &[Family],
    reports: &[Report],
    comparison: Option<&Comparison>,
) -> String {
    let group = |family: &Family| Group {
        marks: family.scenes.clone(),
        regions: family.regions.clone(),
        bound: family
            .scenes
            .first()
            .and_then(|number| bound(&scenes[*number], axes)),
    };
    let groups: Vec<Group> = families.iter().map(group).collect();
    let mark = |(scene, report): (&Scene, &Report)| {
        let [x, y] = axes.each_ref().map(|axis| axis.of_scene(scene));
        let hardest = scene.hardest();
        let at = |axis: &Axis| Some(nearest_f64(&axis.of_scene(&hardest)?.middle()));
        let [hardest_x, hardest_y] = axes.each_ref().map(at);
        Mark {
            name: scene.name.clone(),
            place: [(&axes[0], &x), (&axes[1], &y)]
                .map(|(axis, range)| place(axis, range.as_ref())),
            ranges: x.zip(y).map(|(x, y)| [x, y]),
            at: hardest_x.zip(hardest_y).map(|(x, y)| [x, y]),
            verdict: report.verdict,
        }
    };
    let marks: Vec<Mark> = scenes.iter().zip(reports).map(mark).collect();
    let points = comparison.iter().flat_map(|comparison| &comparison.points);
    let points: Vec<Point> = points
        .map(|point| Point {
            at: [point.x, point.y],
            stable: point.stable,
            prediction: point.prediction,
        })
        .collect();
    draw(&Picture {
        axes,
        window: *window,
        groups: &groups,
        marks: &marks,
        points: &points,
    })
}

/// The bound on the speed for people, unless it is an axis.
fn bound(scene: &Scene, axes: &[Axis; 2]) -> Option<String> {
    let given = scene.given.max_speed.as_ref()?;
    let varied = axes
        .iter()
        .any(|axis| axis.parameter() == passivity_core::Parameter::MaxSpeed);
    (!varied).then(|| given.text.clone())
}

/// Where a scene stands on an axis, for people.
fn place(axis: &Axis, range: Option<&Interval<BigRational>>) -> String {
    match range {
        Some(range) => axis.range_text(range),
        None => format!("no {}", axis.name()),
    }
}
