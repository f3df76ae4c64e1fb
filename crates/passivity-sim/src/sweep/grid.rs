//! The points of a sweep: ranges of β, σ and the speed at the start, or of parameters of the scene.

use std::fmt;

use passivity_core::{BigRational, Exact, Ordered as _, Parameter, Scalar as _};
use passivity_scene::display::{Rounding, rounded};
use passivity_scene::{Axis, Point, Scene};

use crate::error::SimError;
use crate::plan::in_range;
use crate::sweep::range::{Doubles, Range};
use crate::sweep::shard::Shard;

/// The most values of a range, and the most points that are simulated in one run.
pub const MOST_POINTS: usize = 100_000_000;

/// The most points of a grid, which is then simulated in shards.
const MOST_OF_GRID: usize = 1_000_000_000_000;

/// A grid of points, the first axis outermost.
#[derive(Clone)]
pub struct Grid {
    /// The values of up to three axes; one that is not asked for has the one value 0.
    pub values: [Range; 3],
    axes: Axes,
}

/// What tells one grid from another.
impl fmt::Debug for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Grid")
            .field("values", &self.values)
            .field("doubles", &self.values.each_ref().map(Doubles))
            .field("axes", &self.axes)
            .finish()
    }
}

/// What the values are of.
#[derive(Clone, Debug, PartialEq)]
enum Axes {
    /// β ≥ 0, σ ≥ 0 and ξ̇(0) in ticks per sample.
    Plane,
    /// Parameters of the scene file in their units.
    Parameters(Vec<Axis>),
}

impl Grid {
    /// The grid of three ranges of β, σ and the speed at the start.
    ///
    /// # Errors
    ///
    /// A friction below zero, a value that cannot be simulated or is there twice, or too many points.
    pub fn new(beta: Range, sigma: Range, speed: Range) -> Result<Self, SimError> {
        for (name, range, parameter) in [
            ("β", &beta, Parameter::Viscous),
            ("σ", &sigma, Parameter::Coulomb),
            ("speed", &speed, Parameter::StartVelocity),
        ] {
            let values = parameter.row().values;
            if let Some(x) = range.first_not(|x| x.sign().is_some_and(|sign| values.allow(sign))) {
                let expected = values.expected();
                return Err(SimError::Method(format!(
                    "{name} = {x}: expected {expected}"
                )));
            }
            if let Some(x) = range.first_not(|x| in_range(x, parameter).is_ok()) {
                let shown = rounded(&x, 6, Rounding::Down);
                let why = in_range(&x, parameter).err().map(|error| error.to_string());
                let why = why.unwrap_or_default();
                return Err(SimError::Method(format!("{name} = {shown}: {why}")));
            }
        }
        Self::of([beta, sigma, speed], Axes::Plane)
    }

    /// The grid of two or three different parameters of a scene, in the units of their axes.
    ///
    /// # Errors
    ///
    /// Another number of parameters, one that the scene cannot have, a value that its parameter cannot have
    /// or that is there twice, or too many points.
    pub fn of_parameters(parameters: Vec<(Axis, Range)>, scene: &Scene) -> Result<Self, SimError> {
        let fail = |message: String| Err(SimError::Method(message));
        if !(2..=3).contains(&parameters.len()) {
            let count = parameters.len();
            let parameters = if count == 1 {
                "parameter"
            } else {
                "parameters"
            };
            return fail(format!(
                "{count} {parameters} to vary: expected two or three"
            ));
        }
        let mut axes: Vec<Axis> = Vec::new();
        let mut values = [(); 3].map(|()| Range::from(vec![BigRational::integer(0)]));
        for (slot, (axis, range)) in values.iter_mut().zip(parameters) {
            let name = axis.name();
            if axes
                .iter()
                .any(|other| other.parameter() == axis.parameter())
            {
                return fail(format!("`{name}`: the same parameter is varied twice"));
            }
            if let Some(why) = Self::refusal(axis.parameter()) {
                return fail(format!("`{name}` {why}"));
            }
            let fits =
                |x: &BigRational| axis.si(x).is_some() && (!axis.is_whole() || x.is_integer());
            if let Some(x) = range.first_not(fits) {
                let row = axis.parameter().row();
                let expected = if axis.is_whole() {
                    "a whole number above zero"
                } else {
                    row.values.expected()
                };
                return fail(format!("`{name}` = {x}: expected {expected}"));
            }
            *slot = range;
            axes.push(axis);
        }
        Axis::fit(&axes, scene).map_err(|error| SimError::Method(error.to_string()))?;
        Self::of(values, Axes::Parameters(axes))
    }

    /// Why no grid varies a parameter, for [`Axis::parse_for`].
    pub(super) fn refusal(parameter: Parameter) -> Option<&'static str> {
        (parameter == Parameter::MaxSpeed).then_some("has no part in the motion")
    }

    fn of(values: [Range; 3], axes: Axes) -> Result<Self, SimError> {
        let [a, b, c] = values.each_ref().map(Range::len);
        let size = a.checked_mul(b).and_then(|size| size.checked_mul(c));
        if size.is_none_or(|size| size > MOST_OF_GRID) {
            return Err(SimError::Method(format!(
                "a grid of {a} × {b} × {c} points: expected at most {MOST_OF_GRID}"
            )));
        }
        let grid = Self { values, axes };
        for (name, range) in grid.columns().iter().zip(&grid.values) {
            if let Some(x) = range.twice() {
                return Err(SimError::Method(format!(
                    "`{name}` has {x} twice: expected values that are different as doubles, by which a row is told"
                )));
            }
        }
        Ok(grid)
    }

    /// The parameters that are varied; none where β, σ and the speed are.
    #[must_use]
    pub fn parameters(&self) -> &[Axis] {
        match &self.axes {
            Axes::Plane => &[],
            Axes::Parameters(axes) => axes,
        }
    }

    /// The indices of the points of a shard.
    ///
    /// # Errors
    ///
    /// More points than are simulated in one run.
    pub fn points(&self, shard: Shard) -> Result<std::ops::Range<usize>, SimError> {
        let range = shard.range(self.len());
        if range.len() <= MOST_POINTS {
            return Ok(range);
        }
        Err(SimError::Method(format!(
            "{} points in one run: expected at most {MOST_POINTS}; cut the grid into more shards",
            range.len()
        )))
    }

    /// The names of the columns with the values of a point.
    #[must_use]
    pub fn columns(&self) -> Vec<String> {
        match &self.axes {
            Axes::Plane => ["beta", "sigma", "speed"].map(str::to_owned).to_vec(),
            Axes::Parameters(axes) => axes.iter().map(Axis::column).collect(),
        }
    }

    /// How many points there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.values.iter().map(Range::len).product()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The index of a point that has these values of the axes, counted from 0.
    #[cfg(feature = "plot")]
    pub(crate) const fn index(&self, [first, second, third]: [usize; 3]) -> usize {
        let [_, b, c] = &self.values;
        (first * b.len() + second) * c.len() + third
    }

    /// The index of the point that has these doubles, one for each axis.
    pub(super) fn place(&self, doubles: [f64; 3]) -> Option<usize> {
        let [a, b, c] = &self.values;
        let [x, y, z] = doubles;
        Some((a.place(x)? * b.len() + b.place(y)?) * c.len() + c.place(z)?)
    }

    /// What each axis has at a point.
    fn at<T>(&self, index: usize, value: impl Fn(&Range, usize) -> T) -> [T; 3] {
        let [a, b, c] = &self.values;
        let (rest, third) = (index / c.len(), index % c.len());
        let (first, second) = (rest / b.len(), rest % b.len());
        [value(a, first), value(b, second), value(c, third)]
    }

    /// The values of a point.
    ///
    /// # Panics
    ///
    /// When `index` is not below [`Self::len`].
    #[must_use]
    pub fn values(&self, index: usize) -> [BigRational; 3] {
        self.at(index, Range::value)
    }

    /// The doubles nearest to the values of a point.
    ///
    /// # Panics
    ///
    /// When `index` is not below [`Self::len`].
    #[must_use]
    pub fn doubles(&self, index: usize) -> [f64; 3] {
        self.at(index, Range::double)
    }

    /// A scene's point with the values of a point of the grid.
    #[must_use]
    pub fn point(&self, scene: &Point, index: usize) -> Point {
        let values = self.values(index);
        match &self.axes {
            Axes::Plane => {
                let [beta, sigma, speed] = values;
                let mut point = scene.clone();
                point.at.viscous = Some(beta);
                point.at.coulomb = Some(sigma);
                point.at.start_velocity = Some(speed);
                point
            }
            Axes::Parameters(axes) => {
                let varied = axes.iter().zip(values);
                varied.fold(scene.clone(), |point, (axis, value)| {
                    match axis.si(&value).and_then(|si| near(&si)) {
                        Some(si) => point.with(axis.parameter(), &si),
                        None => unreachable!("the values of a grid are those of its parameters"),
                    }
                })
            }
        }
    }

    /// The scene without what the grid varies: what tells one sweep from another.
    pub(super) fn without(&self, scene: &Point) -> Point {
        let mut scene = scene.clone();
        match &self.axes {
            Axes::Plane => {
                (scene.at.viscous, scene.at.coulomb, scene.at.start_velocity) = (None, None, None);
                scene
            }
            Axes::Parameters(_) => self.point(&scene, 0),
        }
    }
}

/// A number as a rational: near it where it has π in it, to more digits than a double has.
fn near(x: &Exact) -> Option<BigRational> {
    const BITS: u32 = 200;
    Some(x.enclosure(BITS)?.middle())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "[device]\nmass = \"75 g\"\nviscous = \"0.5 N s/m\"\ncoulomb = \"0.04 N\"\n\
                        [sampling]\nrate = \"1 kHz\"\n[encoder]\nresolution = \"0.03 mm\"\n[wall]\n\
                        stiffness = \"1 N/mm\"\n[operator]\nforce = \"0.1 N\"\n[start]\nvelocity = \"40 mm/s\"\n";

    #[test]
    fn a_point_with_another_parameter_is_the_scene_with_it_typed_in() {
        let scene = Scene::from_toml("arm", TEXT).unwrap();
        for (name, values, from, to) in [
            ("stiffness [N/m]", "250,500", "1 N/mm", "500 N/m"),
            ("rate [Hz]", "200,400", "1 kHz", "400 Hz"),
            ("resolution [um]", "20,50", "0.03 mm", "50 um"),
            ("mass [kg]", "1,2", "75 g", "2 kg"),
            ("force [mN]", "1,-5", "0.1 N", "-5 mN"),
            ("velocity [mm/s]", "1,2", "40 mm/s", "2 mm/s"),
        ] {
            let other = Axis::parse("viscous [N s/m]", &scene).unwrap();
            let axis = Axis::parse(name, &scene).unwrap();
            let range = |text| Range::parse(text).unwrap();
            let grid =
                Grid::of_parameters(vec![(axis, range(values)), (other, range("1/2"))], &scene)
                    .unwrap();
            let typed = Scene::from_toml("arm", &TEXT.replace(from, to)).unwrap();
            assert_eq!(grid.point(&scene.point(), 1), typed.point(), "{name}");
        }
    }

    #[test]
    fn parameters_that_cannot_be_varied_are_refused() {
        let scene = Scene::from_toml("arm", TEXT).unwrap();
        let error = |parameters: &[(&str, &str)]| {
            let of = |(name, range): &(&str, &str)| {
                (
                    Axis::parse(name, &scene).unwrap(),
                    Range::parse(range).unwrap(),
                )
            };
            let grid = Grid::of_parameters(parameters.iter().map(of).collect(), &scene);
            grid.unwrap_err().to_string()
        };
        assert_eq!(
            error(&[("stiffness", "1")]),
            "1 parameter to vary: expected two or three"
        );
        assert_eq!(
            error(&[("stiffness", "0:1:3"), ("viscous", "1")]),
            "`stiffness` = 0: expected a value above zero"
        );
        assert_eq!(
            error(&[("rate", "1"), ("period", "1")]),
            "`period`: the same parameter is varied twice"
        );
        assert_eq!(
            error(&[("max_speed", "1"), ("period", "1")]),
            "`max_speed` has no part in the motion"
        );
    }
}
