//! Which part of the plane a picture shows.

use num_traits::Signed as _;
use passivity_core::{BigRational, Truth};

use super::column::{Plane, PlaneError};
use super::extent::{Along, Extent, exact};
use crate::number::nearest_f64;
use crate::parse::Axis;
use crate::scene::Scene;

/// What is asked of the window; what is not said is chosen so that scenes and limits are in it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Window {
    /// Whether the axes are logarithmic.
    pub log: [Option<bool>; 2],
    /// From where to where the axes go.
    pub range: [Option<[f64; 2]>; 2],
}

/// Numbers further apart than this factor are shown on a logarithmic axis.
const WIDE: f64 = 25.0;

/// The window that shows the scenes of planes with the same axes, where on either axis their limits
/// are, and `others`: points that were measured.
///
/// # Errors
///
/// A range that is none, or one that begins at zero on a logarithmic axis.
pub fn window(
    planes: &[(&Scene, &Plane)],
    others: &[[f64; 2]],
    asked: &Window,
) -> Result<[Extent; 2], PlaneError> {
    let Some((_, first)) = planes.first() else {
        return Err(PlaneError::new("a plane needs a scene"));
    };
    let of = |along: Along| {
        let axis = along.of(&first.axes);
        let mut shown: Vec<f64> = others.iter().map(|point| *along.of(point)).collect();
        for (scene, plane) in planes {
            shown.extend(ends(scene, axis));
            shown.extend(limits(scene, plane, along));
        }
        extent(axis, &shown, *along.of(&asked.log), *along.of(&asked.range))
    };
    Ok([of(Along::X)?, of(Along::Y)?])
}

/// The ends of a scene's tolerance.
fn ends(scene: &Scene, axis: &Axis) -> Vec<f64> {
    let range = axis.of_scene(scene);
    let ends = range.iter().flat_map(|range| [range.lo(), range.hi()]);
    ends.map(nearest_f64).collect()
}

/// About where the criterion begins or ceases to hold along an axis, the scene being where it is on
/// the other: looked for over twelve decades either way.
fn limits(scene: &Scene, plane: &Plane, along: Along) -> Vec<f64> {
    const DECADES: i32 = 12;
    let (axis, other) = (along.of(&plane.axes), along.other().of(&plane.axes));
    let middle = |axis: &Axis| axis.of_scene(scene).map(|range| range.middle());
    let Some(beside) = middle(other) else {
        return Vec::new();
    };
    let start = match middle(axis)
        .filter(|x| x.is_positive())
        .or_else(|| natural(scene, axis))
    {
        Some(start) => nearest_f64(&start),
        None => return Vec::new(),
    };
    let mut found = Vec::new();
    for speeds in plane.speeds() {
        let holds = |x: f64| {
            let x = exact(x)?;
            let point = along.pair(&x, &beside);
            Some(plane.holds(point, speeds)? == Truth::Holds)
        };
        let decades = (-DECADES..=DECADES).map(|n| {
            let x = start * 10.0_f64.powi(n);
            (x, holds(x))
        });
        let decades: Vec<_> = decades.collect();
        for pair in decades.windows(2) {
            let [(mut a, below), (mut b, above)] = *pair else {
                continue;
            };
            if below == above {
                continue;
            }
            for _ in 0..6 {
                let middle = (a * b).sqrt();
                if holds(middle) == below {
                    a = middle;
                } else {
                    b = middle;
                }
            }
            found.push(b);
        }
    }
    found
}

/// The unit that makes a parameter dimensionless, for one that the scene has not.
fn natural(scene: &Scene, axis: &Axis) -> Option<BigRational> {
    let nominal = scene.given.map(|_, given| given.nominal.clone());
    let unit = nominal.unit(axis.parameter().row().unit).enclosure(64)?;
    Some(axis.numbers(&unit)?.middle())
}

/// An extent around numbers, with some room.
fn extent(
    axis: &Axis,
    shown: &[f64],
    log: Option<bool>,
    range: Option<[f64; 2]>,
) -> Result<Extent, PlaneError> {
    let positive = || shown.iter().copied().filter(|x| *x > 0.0);
    let most = positive().fold(0.0, f64::max);
    let least = positive().fold(f64::INFINITY, f64::min);
    let zero = shown.iter().any(|x| *x <= 0.0);
    let log = log.unwrap_or(match range {
        Some([from, to]) => from > 0.0 && to / from > WIDE,
        None => !zero && most > WIDE * least,
    });
    let name = axis.name();
    if let Some([from, to]) = range {
        let fits = from.is_finite() && to.is_finite() && from < to && from >= 0.0;
        if !fits {
            let message =
                format!("`{name}` from {from} to {to}: expected two numbers, the lower first");
            return Err(PlaneError::new(message));
        }
        if log && from == 0.0 {
            let message = format!("`{name}` from 0: a logarithmic axis begins above zero");
            return Err(PlaneError::new(message));
        }
        return Ok(Extent { from, to, log });
    }
    if most <= 0.0 {
        // Nothing to go by: all scenes are at zero, and nothing limits the parameter.
        return Ok(if log {
            Extent {
                from: 0.01,
                to: 1.0,
                log,
            }
        } else {
            Extent {
                from: 0.0,
                to: 1.0,
                log,
            }
        });
    }
    Ok(if log {
        Extent {
            from: least / 2.5,
            to: most * 2.5,
            log,
        }
    } else {
        Extent {
            from: 0.0,
            to: 1.3 * most,
            log,
        }
    })
}
