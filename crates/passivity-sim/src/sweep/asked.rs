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
            let range = |option: &str, text: &str| {
                Range::parse(text).map_err(|error| SimError::Method(format!("{option}: {error}")))
            };
            let speed = match self.speed {
                Some(text) => range("--speed", text)?,
                None => {
                    let [_, velocity] = point.start();
                    Range::from(vec![velocity])
                }
            };
            return Grid::new(range("--beta", beta)?, range("--sigma", sigma)?, speed);
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
    let axis =
        Axis::parse_for(&named, scene, Grid::refusal).map_err(|error| fail(error.to_string()))?;
    if axis.lacks_unit(&named) {
        return Err(fail(format!(
            "expected a unit after the range, as in {range} {}",
            axis.unit()
        )));
    }
    let range = Range::parse(range).map_err(|error| fail(error.to_string()))?;
    Ok((axis, range))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A paddle with friction and encoder at the motor, and inertia at both sides.
    const TEXT: &str = "[device]\ninertia = \"1e-3 kg m^2\"\n[transmission]\nratio = \"15:1\"\n[motor]\n\
                        inertia = \"2e-6 kg m^2\"\ncoulomb = \"0.0011 N m\"\n[sampling]\nrate = \"1 kHz\"\n\
                        [encoder]\ncounts_per_revolution = 4000\nside = \"motor\"\n[wall]\n\
                        stiffness = \"1 N m/rad\"\n[start]\nvelocity = \"1 rad/s\"\n";

    #[test]
    fn a_value_is_at_the_side_of_the_scene_unless_another_is_said() {
        let scene = Scene::from_toml("paddle", TEXT).unwrap();
        for (vary, column, from, to) in [
            (
                "coulomb=1,2 mN m",
                "coulomb [mN m at the motor]",
                "0.0011 N m",
                "2 mN m",
            ),
            (
                "coulomb=1,30 mN m at the device",
                "coulomb [mN m at the device]",
                "0.0011 N m",
                "2 mN m",
            ),
            (
                "counts_per_revolution=2000,500",
                "counts_per_revolution [at the motor]",
                "4000",
                "500",
            ),
            (
                "counts_per_revolution=2000,500 at the motor",
                "counts_per_revolution [at the motor]",
                "4000",
                "500",
            ),
            (
                "counts_per_revolution=2000,7500 at the device",
                "counts_per_revolution [at the device]",
                "4000",
                "500",
            ),
            // What the other side adds to the inertia stays.
            (
                "inertia=1,2 g m^2",
                "inertia [g m^2 at the device]",
                "1e-3 kg m^2",
                "2 g m^2",
            ),
            (
                "motor.inertia=1,50 g cm^2",
                "inertia [g cm^2 at the motor]",
                "2e-6 kg m^2",
                "50 g cm^2",
            ),
        ] {
            let vary = [vary.to_owned(), "rate=1,2 kHz".to_owned()];
            let asked = Asked {
                vary: &vary,
                ..Asked::default()
            };
            let grid = asked.grid(&scene, &scene.point()).unwrap();
            assert_eq!(grid.columns(), [column, "rate [kHz]"]);
            let typed = Scene::from_toml("paddle", &TEXT.replace(from, to)).unwrap();
            // A turn has π in it, which a point has to many digits only.
            let figures = |point: &Point| {
                let near = |x: &_| format!("{:.12e}", crate::number::to_double(x));
                let units = &point.units;
                (
                    point.at.map(|_, x| near(x)),
                    near(&units.length),
                    near(&units.period),
                )
            };
            let point = grid.point(&scene.point(), 2);
            assert_eq!(figures(&point), figures(&typed.point()), "{vary:?}");
        }
        let error = varied("coulomb=1,2 at the device", &scene).unwrap_err();
        assert!(
            error
                .to_string()
                .ends_with("expected a unit after the range, as in 1,2 N m at the device"),
            "{error}"
        );
    }
}
