//! The best estimate: least squares over the motion in closed form. It also says in which coordinates to
//! search; the box does not rest on it.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{DMatrix, DVector, Dyn, Owned};

use crate::kept::Propagators;
use crate::log::Log;
use crate::motion::simulated;
use crate::region::{Ends, Part, Shear};
use crate::search::first_bounds;

/// What was measured less what is simulated, in ticks; where the device started is what fits best.
pub(crate) fn residuals(log: &Log, at: [f64; 3]) -> Vec<f64> {
    let simulated = simulated(log, at, &mut Propagators::default());
    let mut residuals: Vec<f64> = log.middles().zip(simulated).map(|(x, y)| x - y).collect();
    #[allow(clippy::cast_precision_loss)] // at most a million
    let mean = residuals.iter().sum::<f64>() / residuals.len() as f64;
    residuals.iter_mut().for_each(|residual| *residual -= mean);
    residuals
}

fn all_residuals(logs: &[Log], at: [f64; 3]) -> DVector<f64> {
    let all = logs.iter().flat_map(|log| residuals(log, at));
    DVector::from_vec(all.collect())
}

/// Half the sum of the squares of all residuals; infinite where there is none.
fn cost(logs: &[Log], at: [f64; 3]) -> f64 {
    half_square(&all_residuals(logs, at))
}

fn half_square(residuals: &DVector<f64>) -> f64 {
    let cost = 0.5 * residuals.norm_squared();
    if cost.is_finite() {
        cost
    } else {
        f64::INFINITY
    }
}

/// What an optimiser turns for a parameter.
#[derive(Clone, Copy, Debug)]
enum Knob {
    /// It stays.
    Fixed(f64),
    /// Its logarithm.
    Logarithm,
    /// An angle θ: lo + (hi − lo)(1 + sin θ)/2, which is never outside.
    Within(Ends),
}

impl Knob {
    fn value(self, turned: f64) -> f64 {
        match self {
            Self::Fixed(x) => x,
            Self::Logarithm => turned.exp(),
            Self::Within([lo, hi]) => (lo + (hi - lo) * 0.5 * (1.0 + turned.sin())).clamp(lo, hi),
        }
    }

    fn turned(self, value: f64) -> f64 {
        /// So far from the ends, of the width, a search starts: there its slope is not zero.
        const INSET: f64 = 0.02;
        match self {
            Self::Fixed(_) => 0.0,
            Self::Logarithm => value.max(f64::MIN_POSITIVE).ln(),
            Self::Within([lo, hi]) => {
                let share = ((value - lo) / (hi - lo)).clamp(INSET, 1.0 - INSET);
                (2.0 * share - 1.0).asin()
            }
        }
    }
}

/// What was measured less what is simulated with some numbers.
type Residuals<'a> = &'a dyn Fn(&[f64]) -> DVector<f64>;

/// The least squares as the optimiser has them.
struct Fit<'a> {
    residuals: Residuals<'a>,
    knobs: &'a [Knob],
    turned: DVector<f64>,
}

impl Fit<'_> {
    fn at(&self, turned: &DVector<f64>) -> Vec<f64> {
        let mut turned = turned.iter();
        let all = self.knobs.iter().map(|knob| match knob {
            Knob::Fixed(x) => *x,
            knob => knob.value(turned.next().copied().unwrap_or(f64::NAN)),
        });
        all.collect()
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Fit<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, turned: &DVector<f64>) {
        self.turned.copy_from(turned);
    }

    fn params(&self) -> DVector<f64> {
        self.turned.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let residuals = (self.residuals)(&self.at(&self.turned));
        residuals.iter().all(|r| r.is_finite()).then_some(residuals)
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        /// Of a knob: the motion is known to some 10⁻¹³, so the difference to some 10⁻⁹.
        const STEP: f64 = 1e-4;
        let column = |index: usize| {
            let moved = |by: f64| {
                let mut turned = self.turned.clone();
                if let Some(knob) = turned.get_mut(index) {
                    *knob += by;
                }
                (self.residuals)(&self.at(&turned))
            };
            (moved(STEP) - moved(-STEP)) / (2.0 * STEP)
        };
        let columns: Vec<DVector<f64>> = (0..self.turned.len()).map(column).collect();
        let jacobian = DMatrix::from_columns(&columns);
        jacobian.iter().all(|x| x.is_finite()).then_some(jacobian)
    }
}

/// Turns the knobs of numbers from a start on; gives the numbers and what they cost.
fn turned(
    residuals: Residuals<'_>,
    knobs: &[Knob],
    start: &[f64],
    patience: usize,
) -> (Vec<f64>, f64) {
    let free = knobs
        .iter()
        .zip(start)
        .filter(|(knob, _)| !matches!(knob, Knob::Fixed(_)));
    let turned: Vec<f64> = free.map(|(knob, value)| knob.turned(*value)).collect();
    let before = half_square(&residuals(start));
    if turned.is_empty() {
        return (start.to_vec(), before);
    }
    let fit = Fit {
        residuals,
        knobs,
        turned: DVector::from_vec(turned),
    };
    let (fit, _) = LevenbergMarquardt::new()
        .with_patience(patience)
        .minimize(fit);
    let found = fit.at(&fit.turned);
    let after = half_square(&residuals(&found));
    // A search that went nowhere gives back where it started.
    if after <= before {
        (found, after)
    } else {
        (start.to_vec(), before)
    }
}

/// The parameters among some numbers, which begin with them.
fn parameters(numbers: &[f64]) -> [f64; 3] {
    let mut numbers = numbers.iter().copied();
    [0; 3].map(|_| numbers.next().unwrap_or(f64::NAN))
}

/// Turns the knobs of the parameters from a start on; gives the parameters and what they cost.
fn minimized(logs: &[Log], knobs: [Knob; 3], start: [f64; 3]) -> ([f64; 3], f64) {
    let residuals = |numbers: &[f64]| all_residuals(logs, parameters(numbers));
    let (found, cost) = turned(&residuals, &knobs, &start, 12);
    (parameters(&found), cost)
}

/// The knobs of the parameters: an inertia that is known stays.
fn knobs(inertia: Ends) -> [Knob; 3] {
    let known = inertia[1] <= 1.001 * inertia[0];
    let middle = 0.5 * inertia[0] + 0.5 * inertia[1];
    let of_inertia = if known {
        Knob::Fixed(middle)
    } else {
        Knob::Logarithm
    };
    [Knob::Logarithm, Knob::Logarithm, of_inertia]
}

/// How far the residuals of a log are apart at the least squares over the parameters and some numbers more, each
/// within its ends and from the best of some starts on, by which `logs` are other ones: at the most over the logs.
pub(crate) fn spread(
    logs: &dyn Fn(&[f64]) -> Vec<Log>,
    (ends, starts): (&[Ends], &[Vec<f64>]),
    inertia: Ends,
) -> f64 {
    /// A friction that another model has almost none of starts at this share of the most.
    const LEAST: f64 = 0.01;
    let begun = starts.iter().filter_map(|more| {
        let logs = logs(more);
        let [Some(viscous), Some(coulomb), _] = first_bounds(&logs) else {
            return None;
        };
        let [b, c, m] = first(&logs, [viscous, coulomb], inertia);
        let at = match ends.is_empty() {
            true => [b, c, m],
            false => [b.max(LEAST * viscous), c.max(LEAST * coulomb), m],
        };
        Some((cost(&logs, [b, c, m]), [&at, more.as_slice()].concat()))
    });
    let Some((_, begun)) = begun.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        return f64::INFINITY;
    };
    let of = |numbers: &[f64]| logs(numbers.get(3..).unwrap_or_default());
    let numbers = match ends {
        [] => begun,
        _ => {
            let own = ends.iter().map(|ends| Knob::Within(*ends));
            let all: Vec<Knob> = knobs(inertia).into_iter().chain(own).collect();
            let residuals = |numbers: &[f64]| all_residuals(&of(numbers), parameters(numbers));
            turned(&residuals, &all, &begun, 100).0
        }
    };
    apart(&of(&numbers), parameters(&numbers))
}

/// How far the residuals of a log are apart, at the most over the logs.
fn apart(logs: &[Log], at: [f64; 3]) -> f64 {
    let apart = |log: &Log| {
        let all = DVector::from_vec(residuals(log, at));
        match all.iter().all(|residual| residual.is_finite()) {
            true => all.max() - all.min(),
            false => f64::INFINITY,
        }
    };
    logs.iter().map(apart).fold(0.0, f64::max)
}

/// The parameters with the least squares near some, with an inertia between its ends, and how far the residuals of a
/// log are apart there, at the most over the logs.
pub(crate) fn near(logs: &[Log], start: [f64; 3], inertia: Ends) -> ([f64; 3], f64) {
    let [viscous, coulomb, of_inertia] = knobs(inertia);
    let of_inertia = match of_inertia {
        // Over decades its logarithm is turned, over less it stays between its ends.
        Knob::Logarithm if inertia[1] < 10.0 * inertia[0] => Knob::Within(inertia),
        knob => knob,
    };
    let (at, _) = minimized(logs, [viscous, coulomb, of_inertia], start);
    (at, apart(logs, at))
}

/// How many intervals of motion the costs on a grid may take.
const GRID: usize = 20_000_000;

/// Parameters near those with the least squares, b up to and c up to their most and m in its interval: from
/// a grid over decades on.
pub(crate) fn first(logs: &[Log], most: [f64; 2], inertia: Ends) -> [f64; 3] {
    let samples = logs.iter().map(Log::len).sum::<usize>().max(1);
    let knobs = knobs(inertia);
    let is_fixed = matches!(knobs, [_, _, Knob::Fixed(_)]);
    let middle = 0.5 * inertia[0] + 0.5 * inertia[1];
    let dimensions = if is_fixed { 2 } else { 3 };
    let points = (3..=9_u32)
        .rev()
        .find(|n| n.pow(dimensions) as usize * samples <= GRID);
    let points = points.unwrap_or(3);
    // From the most downwards, over four decades of b and m and two of c.
    let share = |i: u32, decades: f64| 10_f64.powf(-decades * f64::from(i) / f64::from(points));
    let mut grid = Vec::new();
    for i in 0..points {
        for j in 0..points {
            let (b, c) = (most[0] * share(i, 4.0), 0.95 * most[1] * share(j, 2.0));
            match is_fixed {
                true => grid.push([b, c, middle]),
                false => grid.extend((0..points).map(|k| [b, c, inertia[1] * share(k, 4.0)])),
            }
        }
    }
    let mut known: Vec<(f64, [f64; 3])> = grid.into_iter().map(|at| (cost(logs, at), at)).collect();
    known.sort_by(|a, b| a.0.total_cmp(&b.0));
    let tried = known
        .into_iter()
        .take(3)
        .map(|(_, at)| minimized(logs, knobs, at));
    let best = tried.min_by(|a, b| a.1.total_cmp(&b.1));
    best.map_or([most[0], most[1], middle], |(at, _)| at)
}

/// The knobs that stay in a box.
fn knobs_within(hull: &[Ends; 3]) -> [Knob; 3] {
    hull.map(|[lo, hi]| match hi > lo {
        true => Knob::Within([lo, hi]),
        false => Knob::Fixed(lo),
    })
}

/// Parameters in a box from some on, each with a smaller largest residual, or nearly so: those with the least sums of
/// ever higher powers of the residuals, which are taken from the middle of the largest and the smallest of a log.
pub(crate) fn evener<'a>(
    logs: &'a [Log],
    hull: &[Ends; 3],
    start: [f64; 3],
) -> impl Iterator<Item = [f64; 3]> + 'a {
    let knobs = knobs_within(hull);
    let of_power = move |power: i32| {
        move |numbers: &[f64]| {
            let all = logs.iter().flat_map(|log| {
                let all = DVector::from_vec(residuals(log, parameters(numbers)));
                let middle = 0.5 * all.max() + 0.5 * all.min();
                let raised = |residual: &f64| {
                    let off = residual - middle;
                    off.signum() * off.abs().powi(power)
                };
                all.iter().map(raised).collect::<Vec<f64>>()
            });
            DVector::from_vec(all.collect())
        }
    };
    [2, 4, 8, 16, 32, 64]
        .into_iter()
        .scan(start, move |at, power| {
            let (found, _) = turned(&of_power(power), &knobs, at.as_slice(), 12);
            *at = parameters(&found);
            Some(*at)
        })
}

/// The parameters with the least squares among those that are left, in a box around them; `first` are those
/// of all, near which the squares grow with the weights of the coordinates.
///
/// Those of the whole box may lie beside the parts that are left, where the errors of the counts are not evenly
/// spread. Then the place in a part is taken at which the squares have grown the least.
pub(crate) fn best(
    logs: &[Log],
    (parts, hull): (&[Part], &[Ends; 3]),
    (shear, weights): (&Shear, [f64; 3]),
    first: [f64; 3],
) -> [f64; 3] {
    let knobs = knobs_within(hull);
    let inside = |at: [f64; 3]| {
        let mut values = at.into_iter();
        hull.map(|[lo, hi]| values.next().unwrap_or(lo).clamp(lo, hi))
    };
    let middle = hull.map(|[lo, hi]| 0.5 * lo + 0.5 * hi);
    let tried = [inside(first), middle].map(|start| minimized(logs, knobs, start).0);
    let all = tried.into_iter().chain([first]).map(|at| {
        let at = inside(shear.nearest(parts, weights, at));
        (at, cost(logs, at))
    });
    let least = all.min_by(|a, b| a.1.total_cmp(&b.1));
    least.map_or(middle, |(at, _)| at)
}

/// Coordinates in which the squares around a place do not mix, and the weight of each.
///
/// With H = JᵀJ for q, p, r = c/m, b/m, 1/m the factors of H = LDLᵀ: Σ Dᵢ(Lᵀx)ᵢ².
pub(crate) fn coordinates(logs: &[Log], at: [f64; 3]) -> (Shear, [f64; 3]) {
    /// Of a parameter.
    const STEP: f64 = 1e-4;
    let [b, c, m] = at;
    let [q, p, r] = [c / m, b / m, 1.0 / m];
    // A friction of zero is moved by a small one.
    let fastest = logs
        .iter()
        .map(Log::fastest)
        .fold(f64::MIN_POSITIVE, f64::max);
    let least = 1e-3 * (q + p * fastest);
    let steps = [STEP * q.max(least), STEP * p.max(least / fastest), STEP * r];
    let of =
        |[q, p, r]: [f64; 3]| all_residuals(logs, [(p / r).max(0.0), (q / r).max(0.0), 1.0 / r]);
    let base = of([q, p, r]);
    let column = |moved: [f64; 3], step: f64| (of(moved) - &base) / step;
    let [dq, dp, dr] = steps;
    let columns = [
        column([q + dq, p, r], dq),
        column([q, p + dp, r], dp),
        column([q, p, r + dr], dr),
    ];
    let [jq, jp, jr] = &columns;
    let above_zero = |x: f64| {
        if x > 0.0 && x.is_finite() {
            x
        } else {
            f64::MIN_POSITIVE
        }
    };
    let ratio = |x: f64, y: f64| {
        let ratio = x / y;
        if ratio.is_finite() { ratio } else { 0.0 }
    };
    let first = above_zero(jq.dot(jq));
    let alpha = ratio(jq.dot(jp), first);
    let gamma = ratio(jq.dot(jr), first);
    let second = above_zero(jp.dot(jp) - alpha * jq.dot(jp));
    let mixed = jp.dot(jr) - alpha * jq.dot(jr);
    let delta = ratio(mixed, second);
    let third = above_zero(jr.dot(jr) - gamma * jq.dot(jr) - delta * mixed);
    let shear = Shear {
        viscous_in_coulomb: alpha,
        mobility_in_coulomb: gamma,
        mobility_in_viscous: delta,
    };
    (shear, [first, second, third].map(f64::sqrt))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use crate::identified::{identify, read};
    use crate::options::Options;
    use crate::region::{Corner, Part};
    use crate::written::read_sketch;

    #[test]
    fn th_ident_the_estimate_is_not_refuted() {
        // The errors of these counts have a mean, so that the least squares of all lie beside what fits.
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/identify");
        let text = std::fs::read_to_string(folder.join("sketch.toml")).unwrap();
        let sketch = read_sketch("sketch", &text).unwrap();
        let log = |name| read(&folder.join(name), &sketch, &Default::default()).unwrap();
        let (push, ramp) = (log("push.csv"), log("ramp.csv"));
        let options = Options {
            effort: 600_000,
            ..Options::default()
        };
        for logs in [vec![push.clone()], vec![ramp.clone()], vec![push, ramp]] {
            let found = identify(&logs, &sketch, &options, |_| true).unwrap();
            let at = found.shear.around(&Corner::at(found.best.unwrap()));
            let holds = |part: &Part| {
                let mut all = part.ends.iter().zip(at.ends);
                all.all(|([lo, hi], [least, most])| most >= *lo && least <= *hi)
            };
            assert!(found.found.parts.iter().any(holds), "{:?}", found.best);
        }
    }
}
