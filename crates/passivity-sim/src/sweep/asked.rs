//! A grid as it is asked for in words.

use passivity_scene::{Axis, Point, Scene};

use crate::error::SimError;
use crate::sweep::grid::Grid;
use crate::sweep::range::Range;

/// The ranges of a sweep, as text: of β, σ and the speed at the start, or of parameters of the scene.
///
/// # Example
///
/// ```
/// use passivity_scene::Scene;
/// use passivity_sim::sweep::Asked;
///
/// let text = "[dimensionless]\nmu = \"50\"\nbeta = \"1\"\nsigma = \"1\"";
/// let scene = Scene::from_toml("fig5", text).unwrap();
/// let asked = Asked { beta: Some("0:1:5"), sigma: Some("1/2,1"), ..Asked::default() };
/// assert_eq!(asked.grid(&scene, &scene.point()).unwrap().len(), 10);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Asked<'a> {
    /// Values of β.
    pub beta: Option<&'a str>,
    /// Values of σ.
    pub sigma: Option<&'a str>,
    /// Speeds at the start, in ticks per sample; by default the scene's.
    pub speed: Option<&'a str>,
    /// Parameters of the scene, each as `stiffness=0.1:2:41 N m/rad`; in place of the others.
    pub vary: &'a [String],
}

impl Asked<'_> {
    /// The grid.
    ///
    /// # Errors
    ///
    /// A range that cannot be read, ranges that make no grid, or values of σ in a scene without an encoder.
    pub fn grid(&self, scene: &Scene, point: &Point) -> Result<Grid, SimError> {
        if let (Some(beta), Some(sigma), []) = (self.beta, self.sigma, self.vary) {
            if scene.given.resolution.is_none() {
                return Err(SimError::Method(format!(
                    "--sigma: `{}` has no encoder, and σ = c/(KΔ) no Δ: expected parameters of the scene, as in \
                     --vary 'viscous=…' --vary 'coulomb=…'",
                    scene.name
                )));
            }
            let speed = match self.speed {
                Some(text) => Range::parse(text)?,
                None => {
                    let [_, velocity] = point.start();
                    Range::from(vec![velocity])
                }
            };
            return Grid::new(Range::parse(beta)?, Range::parse(sigma)?, speed);
        }
        if self.beta.or(self.sigma).or(self.speed).is_some() {
            let expected = "expected values of β and σ, or parameters of the scene to vary";
            return Err(SimError::Method(expected.to_owned()));
        }
        let varied = self.vary.iter().map(|text| varied(text, scene));
        let varied = varied.collect::<Result<Vec<_>, _>>()?;
        Grid::of_parameters(varied, scene)
            .map_err(|error| SimError::Method(format!("--vary {error}")))
    }
}

/// Reads `stiffness=0.1:2:41 N m/rad`.
fn varied(text: &str, scene: &Scene) -> Result<(Axis, Range), SimError> {
    let fail = |what: String| SimError::Method(format!("--vary `{text}`: {what}"));
    let Some((key, rest)) = text.split_once('=') else {
        let expected = "expected a key, a range and a unit, as in stiffness=0.1:2:41 N m/rad";
        return Err(fail(expected.to_owned()));
    };
    let (key, rest) = (key.trim(), rest.trim());
    // The unit begins with the first letter after a space: a number has none there.
    let is_unit = |(at, _): &(usize, char)| {
        let first = rest.get(at + 1..).and_then(|unit| unit.chars().next());
        first.is_some_and(|c| c.is_alphabetic() || "°µ(/".contains(c))
    };
    let space = rest.char_indices().filter(|(_, c)| *c == ' ').find(is_unit);
    let (range, unit) = match space {
        Some((at, _)) => rest.split_at(at),
        None => (rest, ""),
    };
    let named = match unit.trim() {
        "" => key.to_owned(),
        unit => format!("{key} [{unit}]"),
    };
    let axis = Axis::parse(&named, scene).map_err(|error| fail(error.to_string()))?;
    if unit.is_empty() && !axis.unit().is_empty() {
        return Err(fail(format!(
            "expected a unit after the range, as in {range} {}",
            axis.unit()
        )));
    }
    let range = Range::parse(range).map_err(|error| fail(error.to_string()))?;
    Ok((axis, range))
}
