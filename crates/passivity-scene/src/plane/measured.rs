//! Points that were measured, beside what the criterion says of them.

use std::path::Path;

use passivity_core::{BigRational, Truth};
use serde::Serialize;

use super::column::{Plane, PlaneError, Speeds};
use crate::number::nearest_f64;
use crate::parse::{Axis, MAX_SAMPLE_BYTES, bytes_of};
use crate::scene::Scene;

/// What the criterion says of a measured point, against what was measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Prediction {
    /// Stable and passive, or unstable and not shown to be passive.
    Agree,
    /// It was stable, and the criterion does not show that it is passive: with any hand, from any start.
    Stricter,
    /// It was unstable, and the criterion shows that it is passive.
    Looser,
}

/// A point that was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// The numbers on the axes, x and y.
    pub at: [BigRational; 2],
    /// Whether the device was stable there.
    pub stable: bool,
}

/// The points of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The points, in the order of the file.
    pub points: Vec<Measurement>,
    /// The columns that were not read.
    pub not_read: Vec<String>,
}

/// The column that says what was seen.
const STABLE: &str = "stable";

/// What may stand in it.
const YES: [&str; 5] = ["stable", "yes", "true", "1", "passive"];
const NO: [&str; 6] = ["unstable", "no", "false", "0", "active", "not passive"];

impl Measured {
    /// Reads a CSV file with a header: a column for either axis, with its unit as in
    /// `stiffness [N/mm]`, and a column `stable`. Lines that begin with `#` are comments.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, a column that is missing, and a cell that is wrong, with its place.
    pub fn read(path: &Path, plane: &Plane, scene: &Scene) -> Result<Self, PlaneError> {
        let fail = |message: String| PlaneError::new(format!("`{}`: {message}", path.display()));
        let bytes = bytes_of(path, MAX_SAMPLE_BYTES).map_err(fail)?;
        Self::parse(&bytes, plane, scene).map_err(fail)
    }

    fn parse(bytes: &[u8], plane: &Plane, scene: &Scene) -> Result<Self, String> {
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(bytes);
        let header = reader.headers().map_err(|error| not_csv(&error))?.clone();
        let layout = Layout::of(&header, plane, scene)?;
        let mut points = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| not_csv(&error))?;
            let line = record.position().map_or(0, csv::Position::line);
            points.push(
                layout
                    .point(&record, plane)
                    .map_err(|error| format!("line {line}, {error}"))?,
            );
        }
        if points.is_empty() {
            return Err("there are no points in it".to_owned());
        }
        Ok(Self {
            points,
            not_read: layout.not_read,
        })
    }
}

fn not_csv(error: &csv::Error) -> String {
    match (error.kind(), error.position()) {
        (
            csv::ErrorKind::UnequalLengths {
                expected_len, len, ..
            },
            Some(at),
        ) => format!(
            "line {}: expected {expected_len} cells as in the header, found {len}",
            at.line()
        ),
        (_, Some(at)) => format!("line {}: this is not CSV in UTF-8", at.line()),
        (_, None) => "this is not CSV in UTF-8".to_owned(),
    }
}

/// Which columns are read.
struct Layout {
    /// The column of x and of y, as an axis with the unit of the header.
    axes: [(usize, Axis); 2],
    stable: usize,
    not_read: Vec<String>,
}

impl Layout {
    fn of(header: &csv::StringRecord, plane: &Plane, scene: &Scene) -> Result<Self, String> {
        let mut found: [Option<(usize, Axis)>; 2] = [None, None];
        let mut stable = None;
        let mut not_read = Vec::new();
        for (index, cell) in header.iter().enumerate() {
            let place = |message: String| format!("line 1, column {}: {message}", index + 1);
            if cell == STABLE {
                stable = Some(index);
                continue;
            }
            let name = cell.split('[').next().unwrap_or_default().trim();
            if Axis::parse(name, scene).is_err() {
                not_read.push(cell.to_owned());
                continue;
            }
            let axis = Axis::parse(cell, scene).map_err(|error| place(error.to_string()))?;
            let which = plane
                .axes
                .iter()
                .position(|shown| shown.parameter() == axis.parameter());
            let Some(slot) = which.and_then(|which| found.get_mut(which)) else {
                let [x, y] = plane.axes.each_ref().map(Axis::name);
                return Err(place(format!(
                    "`{cell}` is no axis of this plane, which shows `{x}` and `{y}`: points at other \
                     values have no place in it"
                )));
            };
            if slot.is_some() {
                return Err(place(format!("`{cell}` is there twice")));
            }
            if axis.lacks_unit(cell) {
                let expected = axis.column();
                return Err(place(format!(
                    "`{cell}` has no unit: expected one, as in `{expected}`"
                )));
            }
            *slot = Some((index, axis));
        }
        let [x, y] = found;
        let missing = |i: usize| {
            let expected = plane.axes.get(i).map(Axis::column).unwrap_or_default();
            format!("line 1: the header has no column `{expected}`")
        };
        let stable = stable.ok_or_else(|| {
            format!("line 1: the header has no column `{STABLE}`, of `stable` and `unstable`")
        })?;
        Ok(Self {
            axes: [x.ok_or_else(|| missing(0))?, y.ok_or_else(|| missing(1))?],
            stable,
            not_read,
        })
    }

    fn point(&self, record: &csv::StringRecord, plane: &Plane) -> Result<Measurement, String> {
        let cell = |index: usize| record.get(index).unwrap_or_default();
        let place = |index: usize, message: &dyn std::fmt::Display| {
            format!("column {}: {message}", index + 1)
        };
        let mut at = Vec::new();
        for ((index, axis), shown) in self.axes.iter().zip(&plane.axes) {
            let number = axis
                .number(cell(*index))
                .map_err(|error| place(*index, &error))?;
            at.push(converted(axis, shown, &number).ok_or_else(|| {
                place(
                    *index,
                    &format!("`{}` has no place on the axis", cell(*index)),
                )
            })?);
        }
        let word = cell(self.stable).to_lowercase();
        let stable = match (YES.contains(&word.as_str()), NO.contains(&word.as_str())) {
            (true, _) => true,
            (_, true) => false,
            _ => {
                let message = format!(
                    "expected `stable` or `unstable`, found `{}`",
                    cell(self.stable)
                );
                return Err(place(self.stable, &message));
            }
        };
        match <[BigRational; 2]>::try_from(at) {
            Ok(at) => Ok(Measurement { at, stable }),
            Err(_) => Err("expected a number for either axis".to_owned()),
        }
    }
}

/// A number of one axis on another of the same parameter.
fn converted(from: &Axis, to: &Axis, number: &BigRational) -> Option<BigRational> {
    if from.is_scaled_as(to) {
        return Some(number.clone());
    }
    let si = from.si(number)?.enclosure(crate::check::BITS)?;
    Some(to.numbers(&si)?.middle())
}

impl Measurement {
    /// What the criterion says, at the speeds that the verdict on the scene is about.
    #[must_use]
    pub fn predicted(&self, plane: &Plane) -> Prediction {
        let speeds = if plane.has_speed_bound() {
            Speeds::UpToBound
        } else {
            Speeds::Every
        };
        let [x, y] = &self.at;
        let passive = plane.holds([x, y], speeds) == Some(Truth::Holds);
        match (self.stable, passive) {
            (true, false) => Prediction::Stricter,
            (false, true) => Prediction::Looser,
            _ => Prediction::Agree,
        }
    }

    /// The point as doubles.
    #[must_use]
    pub fn place(&self) -> [f64; 2] {
        self.at.each_ref().map(nearest_f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> Scene {
        let text = "[device]\nviscous = \"0.5 N s/m\"\ncoulomb = \"0.04 N\"\n[sampling]\nperiod = \"1 ms\"\n\
                    [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"0.2 N/mm\"\n";
        Scene::from_toml("arm", text).unwrap()
    }

    fn read(text: &str) -> Result<(Plane, Measured), String> {
        let scene = scene();
        let axes = ["stiffness", "damping"].map(|name| Axis::parse(name, &scene).unwrap());
        let plane = Plane::new(&scene, axes).unwrap();
        let measured = Measured::parse(text.as_bytes(), &plane, &scene)?;
        Ok((plane, measured))
    }

    #[test]
    fn points_are_converted_and_compared() {
        // At every speed the wall is passive up to K = 1 − 2B, in N/mm and N s/m.
        let text = "# bench, 2024\nno,stiffness [N/m],damping [N s/mm],stable\n1,500,1e-4,stable\n\
                    2,900,1e-4,stable\n3,500,1e-4,unstable\n4,2000,0,unstable\n";
        let (plane, measured) = read(text).unwrap();
        assert_eq!(measured.not_read, ["no"]);
        assert_eq!(measured.points[0].place(), [0.5, 0.1]);
        let predicted = measured.points.iter().map(|point| point.predicted(&plane));
        let expected = [
            Prediction::Agree,
            Prediction::Stricter,
            Prediction::Looser,
            Prediction::Agree,
        ];
        assert!(predicted.eq(expected));
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        let error = |text: &str| read(text).unwrap_err();
        assert_eq!(
            error("stiffness [N/m],stable\n1,yes\n"),
            "line 1: the header has no column `damping [N s/m]`"
        );
        assert_eq!(
            error("stiffness [N/m],damping [N s/m]\n1,2\n"),
            "line 1: the header has no column `stable`, of `stable` and `unstable`"
        );
        assert_eq!(
            error("stiffness,damping [N s/m],stable\n1,2,yes\n"),
            "line 1, column 1: `stiffness` has no unit: expected one, as in `stiffness [N/mm]`"
        );
        assert_eq!(
            error("stiffness [N m/rad],damping [N s/m],stable\n1,2,yes\n"),
            "line 1, column 1: `stiffness [N m/rad]`: the unit is that of a torsional stiffness, \
             expected a linear stiffness such as `\"1 N/mm\"`"
        );
        assert_eq!(
            error("stiffness [N/m],damping [N s/m],rate [Hz],stable\n1,2,3,yes\n"),
            "line 1, column 3: `rate [Hz]` is no axis of this plane, which shows `stiffness` and \
             `damping`: points at other values have no place in it"
        );
        let header = "stiffness [N/m],damping [N s/m],stable\n";
        assert_eq!(
            error(&format!("{header}1,2,maybe\n")),
            "line 2, column 3: expected `stable` or `unstable`, found `maybe`"
        );
        assert_eq!(
            error(&format!("{header}1,2,yes\n-1,2,no\n")),
            "line 3, column 1: `stiffness` = `-1`: expected a value above zero"
        );
        assert_eq!(
            error(&format!("{header}1,2\n")),
            "line 2: expected 3 cells as in the header, found 2"
        );
        assert_eq!(error(header), "there are no points in it");
    }
}
