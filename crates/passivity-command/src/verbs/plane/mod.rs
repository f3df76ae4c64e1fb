//! `passivity plane`: scenes in the plane of two parameters.

mod answer;
mod beta_sigma;
mod parameters;

use std::path::PathBuf;

use passivity_scene::Scene;

use crate::exit::{Exit, Failure};
use crate::files::{may_be_written, sources};
use crate::output::{Format, read_scene};

/// Draw scenes in the plane of two parameters, with the border of what is passive.
///
/// Without --axes it is the (β, σ) plane of the paper's Figs. 3 and 4, with the critical line of each
/// scene at its speed bound and where another stiffness, sampling period or encoder resolution would
/// move it. A scene with tolerances stands at the hardest of their ends, the device that is nearest
/// to failing or fails the most, and its critical line and the ways are that device's; a box is what
/// the tolerances span.
/// With --axes it is the plane of any two parameters that the criterion knows, in the units
/// of the scene file: where the scene is passive at every speed, and up to operator.max_speed. A border
/// is the exact solution of the criterion where a formula says it, else it is searched for by halving;
/// every point of it is passive when it is typed into the scene.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity plane scenes/re35.toml --plot plane.svg
  passivity plane scenes/re35*.toml --plot plane.png
  passivity plane scenes/re35.toml --axes stiffness,damping --plot zwidth.svg --out border.csv
  passivity plane scenes/re35.toml --axes 'stiffness [mN m/deg],rate [kHz]' --log both \\
      --plot rate.svg
  passivity plane scenes/re35.toml --axes coulomb,viscous --x 0:4e-3 --plot friction.svg
  passivity plane knob.toml --axes stiffness,damping --measured bench.csv --plot bench.svg

A file of measured points is CSV with a header: a column for either axis, with its unit as in
`stiffness [N/mm]`, and a column `stable` with the words stable and unstable.

Behind a transmission a value is at the side where the scene gives it, unless the side stands behind
the unit, as in `coulomb [mN m at the motor]` or `coulomb [mN m at the device]`.

Exit codes: 0 it is drawn or printed, whatever the walls are; 2 bad input.")]
pub(crate) struct Args {
    /// Scene files.
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Two parameters by their keys in a scene file, each with a unit if it shall be another than the scene's.
    #[arg(long, value_name = "X,Y", default_value = "beta,sigma")]
    axes: String,
    /// Draw the plane into this file, as SVG or PNG according to its extension.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Write the points of the borders to this CSV file.
    #[arg(long, value_name = "FILE", value_parser = crate::files::csv())]
    out: Option<PathBuf>,
    /// Which axes have equal factors in equal steps; by default those with scenes and limits far apart.
    #[arg(long, value_name = "AXES")]
    log: Option<Log>,
    /// From where to where x goes, in its unit.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    x: Option<String>,
    /// From where to where y goes, in its unit.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    y: Option<String>,
    /// Draw the measured points of this CSV file too, and compare them with what the criterion says.
    #[arg(long, value_name = "FILE")]
    measured: Option<PathBuf>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Which axes are logarithmic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Log {
    X,
    Y,
    Both,
    None,
}

impl Log {
    /// Whether x and y are logarithmic.
    const fn axes(self) -> [Option<bool>; 2] {
        let (x, y) = match self {
            Self::X => (true, false),
            Self::Y => (false, true),
            Self::Both => (true, true),
            Self::None => (false, false),
        };
        [Some(x), Some(y)]
    }
}

/// Draws the scenes.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let names: Vec<&str> = args.axes.split(',').map(str::trim).collect();
    let [x, y] = names.as_slice() else {
        let axes = &args.axes;
        return Err(Failure::input(format!(
            "--axes `{axes}`: expected two parameters, as in stiffness,damping"
        )));
    };
    if [*x, *y] == ["beta", "sigma"] {
        return beta_sigma::run(args);
    }
    parameters::run(args, [x, y])
}

/// Reads the scenes, once it is clear that what is asked for can be written.
fn scenes(args: &Args) -> Result<Vec<Scene>, Failure> {
    let scenes: Vec<Scene> = args
        .scenes
        .iter()
        .map(|path| read_scene(path))
        .collect::<Result<_, _>>()?;
    let of_scenes = scenes.iter().zip(&args.scenes);
    let mut inputs: Vec<PathBuf> = of_scenes
        .flat_map(|(scene, path)| sources(scene, path))
        .collect();
    inputs.extend(args.measured.clone());
    let outputs = [("--plot", args.plot.as_ref()), ("--out", args.out.as_ref())];
    may_be_written(&outputs, &inputs, "plane")?;
    crate::picture::check(args.plot.as_deref())?;
    Ok(scenes)
}
