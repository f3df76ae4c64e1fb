//! The points of a sweep: ranges of β, σ and the speed at the start.

use passivity_core::{BigRational, Parameter, Scalar as _};
use passivity_scene::Point;
use passivity_scene::number;

use crate::error::SimError;
use crate::number::to_double;
use crate::plan::in_range;

/// The most values of a range, and the most points of a grid.
pub const MOST_POINTS: usize = 100_000_000;

/// The values of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// The values, exactly.
    pub values: Vec<BigRational>,
}

impl Range {
    /// Reads `start:stop:count`, both ends included, or a list `1,2,5`.
    ///
    /// # Errors
    ///
    /// Text that is neither, with what was expected.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_sim::sweep::Range;
    ///
    /// let thirds = Range::parse("0:1:4").unwrap();
    /// assert_eq!(thirds.values[1].to_string(), "1/3");
    /// assert_eq!(Range::parse("1/2,3").unwrap().values.len(), 2);
    /// let error = Range::parse("0:1").unwrap_err().to_string();
    /// assert_eq!(error, "range `0:1`: expected start:stop:count or a list as in 1,2,5");
    /// ```
    pub fn parse(text: &str) -> Result<Self, SimError> {
        let fail = |what: String| SimError::Method(format!("range `{text}`: {what}"));
        let number = |part: &str| {
            number::parse(part.trim()).map_err(|error| fail(format!("`{}`: {error}", part.trim())))
        };
        let parts: Vec<&str> = text.split(':').collect();
        match parts.as_slice() {
            [list] => {
                let values: Result<Vec<_>, _> = list.split(',').map(number).collect();
                Ok(Self { values: values? })
            }
            [start, stop, count] => {
                let (start, stop) = (number(start)?, number(stop)?);
                let count: Option<usize> = count.trim().parse().ok();
                let count = count
                    .filter(|n| (1..=MOST_POINTS).contains(n))
                    .ok_or_else(|| fail(format!("expected a count from 1 to {MOST_POINTS}")))?;
                if count == 1 && start != stop {
                    return Err(fail(
                        "a count of 1 needs start and stop to be equal".to_owned(),
                    ));
                }
                let last = BigRational::from_integer(count.saturating_sub(1).max(1).into());
                let step = (stop - &start) / last;
                let values = (0..count)
                    .map(|i| &start + &step * BigRational::from_integer(i.into()))
                    .collect();
                Ok(Self { values })
            }
            _ => Err(fail(
                "expected start:stop:count or a list as in 1,2,5".to_owned(),
            )),
        }
    }
}

/// A grid of points; β outermost, speed innermost.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// β ≥ 0.
    pub beta: Vec<BigRational>,
    /// σ ≥ 0.
    pub sigma: Vec<BigRational>,
    /// ξ̇(0), in ticks per sample.
    pub speed: Vec<BigRational>,
}

impl Grid {
    /// The grid of three ranges.
    ///
    /// # Errors
    ///
    /// A friction below zero, or too many points.
    pub fn new(beta: Range, sigma: Range, speed: Range) -> Result<Self, SimError> {
        for (name, range) in [("β", &beta), ("σ", &sigma)] {
            if let Some(x) = range.values.iter().find(|x| **x < BigRational::integer(0)) {
                return Err(SimError::Method(format!(
                    "{name} = {x}: expected zero or a value above it"
                )));
            }
        }
        let [a, b, c] = [&beta, &sigma, &speed].map(|range| range.values.len());
        let size = a.checked_mul(b).and_then(|size| size.checked_mul(c));
        if size.is_none_or(|size| size > MOST_POINTS) {
            return Err(SimError::Method(format!(
                "a grid of {a} × {b} × {c} points: expected at most {MOST_POINTS}"
            )));
        }
        Ok(Self {
            beta: beta.values,
            sigma: sigma.values,
            speed: speed.values,
        })
    }

    /// Whether every value can be simulated.
    pub(super) fn check(&self) -> Result<(), SimError> {
        for (parameter, values) in [
            (Parameter::Viscous, &self.beta),
            (Parameter::Coulomb, &self.sigma),
            (Parameter::StartVelocity, &self.speed),
        ] {
            for x in values {
                in_range(x, parameter)?;
            }
        }
        Ok(())
    }

    /// How many points there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.beta.len() * self.sigma.len() * self.speed.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The index of a point that has these values of β, σ and the speed, counted from 0.
    #[cfg(feature = "plot")]
    pub(crate) const fn index(&self, [beta, sigma, speed]: [usize; 3]) -> usize {
        (beta * self.sigma.len() + sigma) * self.speed.len() + speed
    }

    /// The values of a point.
    ///
    /// # Panics
    ///
    /// When `index` is not below [`Self::len`].
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "a panic that is announced")]
    pub fn values(&self, index: usize) -> [&BigRational; 3] {
        let (rest, speed) = (index / self.speed.len(), index % self.speed.len());
        let (beta, sigma) = (rest / self.sigma.len(), rest % self.sigma.len());
        [&self.beta[beta], &self.sigma[sigma], &self.speed[speed]]
    }

    /// The values of a point as doubles.
    #[must_use]
    pub fn doubles(&self, index: usize) -> [f64; 3] {
        self.values(index).map(to_double)
    }

    /// A scene's point with the values of a point of the grid.
    #[must_use]
    pub fn point(&self, scene: &Point, index: usize) -> Point {
        let [beta, sigma, speed] = self.values(index);
        let mut point = scene.clone();
        point.at.viscous = Some(beta.clone());
        point.at.coulomb = Some(sigma.clone());
        point.at.start_velocity = Some(speed.clone());
        point
    }
}
