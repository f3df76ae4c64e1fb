//! The (β, σ) plane of Figs. 3 and 4: regions, critical lines, and where each scene sits.

use passivity_core::rational::{from_wide, to_wide};
use passivity_core::{BigRational, Interval, Loop, Parameter, Scalar as _, Wide};
use passivity_scene::Scene;
use passivity_scene::check::{Report, Verdict};
use passivity_scene::display::range;
use passivity_scene::number::nearest_f64;

mod draw;
mod key;

pub use draw::{draw, draw_on_axes};

/// A scene in the plane.
///
/// It stands at β and σ less what its effects cost beyond the ½ of sampling and the ½ of
/// quantization, so that the borders of the regions are its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What the legend calls it.
    pub name: String,
    /// The least and the largest β less the cost, over the tolerances.
    pub beta: [f64; 2],
    /// The least and the largest σ less the cost.
    pub sigma: [f64; 2],
    /// Where walls of other stiffness stand, from stiff to soft.
    pub softer: Vec<(f64, f64)>,
    /// Where the scene stands with half the sampling period.
    pub faster: (f64, f64),
    /// Where it stands with half the resolution.
    pub finer: (f64, f64),
    /// Whether effects beyond sampling and quantization cost anything.
    pub has_costs: bool,
    /// The speed of its critical line (9), in ticks per sample, and what the legend calls it.
    pub speed: Option<(f64, String)>,
    /// The verdict, for its sign and the legend.
    pub verdict: Verdict,
}

impl Mark {
    /// A scene and its report as a mark; `None` without an encoder, because σ needs one.
    #[must_use]
    pub fn of(scene: &Scene, report: &Report) -> Option<Self> {
        report.sigma.as_ref()?;
        let half = BigRational::one().half();
        let ends = |spare: &Interval<BigRational>| {
            [spare.lo(), spare.hi()].map(|x| nearest_f64(&(x + &half)))
        };
        let middle = |x: &Interval<BigRational>| nearest_f64(&x.middle());
        let bound = report.speed_bound.as_ref();
        let bound = bound.map(|v| (middle(v), format!("{} ticks/sample", range(v))));
        let at = scene.point().at;
        // Factors of softness in geometric steps of 9/8, 64 down and 64 up.
        let step = BigRational::new(9.into(), 8.into());
        let factors = (-64..=64_i32).map(|power| step.pow(power));
        Some(Self {
            name: report.scene.clone(),
            beta: ends(&report.spare.viscous),
            sigma: ends(&report.spare.coulomb),
            softer: factors
                .filter_map(|x| moved(&at, Parameter::Stiffness, &x.recip()))
                .collect(),
            faster: moved(&at, Parameter::Period, &half)?,
            finer: moved(&at, Parameter::Resolution, &half)?,
            has_costs: !at.is_plain(),
            speed: bound.filter(|(v, _)| *v > 0.0),
            verdict: report.verdict,
        })
    }

    /// The middle of the tolerances.
    fn middle(&self) -> (f64, f64) {
        let [a, b] = [self.beta, self.sigma].map(|[lo, hi]| 0.5 * (lo + hi));
        (a, b)
    }
}

/// Where a dimensionless loop stands with one parameter times a factor; `None` where a figure is
/// beyond what the kernel computes.
fn moved(at: &Loop<BigRational>, parameter: Parameter, factor: &BigRational) -> Option<(f64, f64)> {
    let wide = at.map(|_, x| Interval::point(to_wide(x)));
    let value = wide.get(parameter)?.map(|x| x.clone() * to_wide(factor));
    let loops = wide.with(parameter, value).with_costs(COST_BITS)?;
    let criterion = loops.map(|_, x| x.hi().clone()).dimensionless_criterion();
    let place = |spare: &Wide| from_wide(spare).map(|x| nearest_f64(&x) + 0.5);
    Some((place(&criterion.viscous)?, place(&criterion.coulomb)?))
}

/// Bits of the costs of a place in the picture: past those of a double.
const COST_BITS: u32 = 64;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_too_far_out_is_an_error() {
        let mark = Mark {
            name: "far".to_owned(),
            beta: [0.0, f64::INFINITY],
            sigma: [1.0; 2],
            softer: Vec::new(),
            faster: (1.2, 0.6),
            finer: (0.6, 1.2),
            has_costs: false,
            speed: None,
            verdict: Verdict::Depends,
        };
        assert!(draw(&[mark]).is_err());
    }
}
