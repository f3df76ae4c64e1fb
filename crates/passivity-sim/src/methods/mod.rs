//! Simulating a scene: the closed form, its exact, rigorous and very precise relatives, and what people
//! use today, to compare with.

#[cfg(feature = "adaptive")]
mod adaptive;
mod general;
#[cfg(feature = "multiprecision")]
mod precise;
mod steps;

use passivity_scene::Point;

use crate::error::SimError;
use crate::ledger::Entry;
use crate::method::Method;
use crate::plan::{Beyond, Plan};
use crate::run;
use crate::simulated::{Detail, Each, Line, Simulated};

/// Simulates a scene's point.
///
/// # Errors
///
/// A scene that cannot be compiled, or has effects that the method cannot do; for the exact method,
/// numbers that grow too long.
///
/// # Example
///
/// ```
/// use passivity_scene::Scene;
/// use passivity_sim::{ExactOutcome, Method, simulate};
///
/// let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"0\"\nsigma = \"3/5\"\n\
///              [start]\nvelocity = \"1/4\"\n[run]\nintervals = 2000";
/// let point = Scene::from_toml("glide", scene).unwrap().point();
/// let run = simulate(&point, &Method::Exact, None).unwrap();
/// assert_eq!(run.end.outcome.exact, ExactOutcome::AtRest);
/// ```
pub fn simulate(
    point: &Point,
    method: &Method,
    each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    planned(point, &Plan::compile(point)?, method, each)
}

/// [`simulate`], and on after divergence became certain: the outcome stays what it was, while the end and
/// the sums are of all the intervals that were run.
///
/// # Errors
///
/// Those of [`simulate`].
///
/// # Example
///
/// ```
/// use passivity_scene::Scene;
/// use passivity_sim::{Beyond, ExactOutcome, Method, simulate_beyond};
///
/// let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"0\"\nsigma = \"0\"\n\
///              [start]\nposition = \"100\"\n[run]\nintervals = 20";
/// let point = Scene::from_toml("grow", scene).unwrap().point();
/// let run = simulate_beyond(&point, &Method::ClosedForm, Beyond::All, None).unwrap();
/// assert_eq!(run.end.outcome.exact, ExactOutcome::Growing);
/// assert_eq!((run.end.outcome.at_interval, run.end.intervals), (Some(0), 20));
/// ```
pub fn simulate_beyond(
    point: &Point,
    method: &Method,
    beyond: Beyond,
    mut each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    let plan = Plan::compile(point)?;
    let first = match &mut each {
        Some(each) => planned(point, &plan, method, Some(&mut **each))?,
        None => planned(point, &plan, method, None)?,
    };
    let Some(plan) = plan.beyond(&first.end, beyond) else {
        return Ok(first);
    };
    // The same intervals again, which have been seen, and those after them.
    let seen = first.end.intervals;
    let mut rest =
        |line: &Line<'_>| line.interval() < seen || each.as_mut().is_none_or(|each| each(line));
    let second = planned(point, &plan, method, Some(&mut rest))?;
    Ok(second.judged_as(first.end.outcome, plan.intervals))
}

/// [`simulate`] with the plan of the point compiled before.
pub(crate) fn planned(
    point: &Point,
    plan: &Plan,
    method: &Method,
    each: Option<Each<'_>>,
) -> Result<Simulated, SimError> {
    let effects = method.unsupported(point);
    if !effects.is_empty() {
        return Err(SimError::Unsupported {
            method: method.name(),
            effects,
        });
    }
    let (end, totals) = match *method {
        Method::ClosedForm => run::ledger(plan, see(each)),
        Method::Euler { substeps } => {
            run::stepped(plan, None, |part| steps::euler(part, substeps), see(each))
        }
        Method::Rk4 { substeps } => {
            run::stepped(plan, None, |part| steps::rk4(part, substeps), see(each))
        }
        #[cfg(feature = "adaptive")]
        Method::Adaptive { tolerance } => {
            let make = |part: &Plan| adaptive::steps(part, tolerance);
            run::stepped(plan, Some(tolerance), make, see(each))
        }
        Method::Exact => return general::exact(point, plan, each),
        #[cfg(feature = "multiprecision")]
        Method::Reference { digits } => return precise::reference(point, plan, digits, each),
        #[cfg(feature = "multiprecision")]
        Method::Enclosure => return precise::enclosure(point, plan, each),
        #[cfg(not(feature = "adaptive"))]
        Method::Adaptive { .. } => {
            return Err(SimError::NotBuiltIn {
                what: "the method `adaptive` is",
                feature: "adaptive",
            });
        }
        #[cfg(not(feature = "multiprecision"))]
        Method::Reference { .. } | Method::Enclosure => {
            return Err(SimError::NotBuiltIn {
                what: "the methods `reference` and `enclosure` are",
                feature: "multiprecision",
            });
        }
    };
    Ok(Simulated {
        end,
        totals,
        detail: Detail::None,
    })
}

/// Shows intervals in doubles to who sees them, if anyone does.
fn see(mut each: Option<Each<'_>>) -> impl FnMut(&Entry) -> bool {
    move |entry| each.as_mut().is_none_or(|each| each(&Line::Double(entry)))
}
