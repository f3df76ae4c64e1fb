//! The (β, σ) plane of Figs. 3 and 4: regions, critical lines, and where each scene sits.

use passivity_core::rational::{from_wide, to_wide};
use passivity_core::{BigRational, Interval, Loop, Parameter, Scalar as _, Wide};
use passivity_scene::Scene;
use passivity_scene::check::{Report, Verdict};
use passivity_scene::display::approx;
use passivity_scene::number::nearest_f64;

mod draw;
mod key;

pub use draw::{draw, draw_on_axes};

/// A scene in the plane.
///
/// It stands at β and σ less what its effects cost beyond the ½ of sampling and the ½ of
/// quantization, so that the borders of the regions are its own. Of the devices within its tolerances the mark,
/// the ways that lead from it and the critical line are all of one, that at the [hardest](Scene::hardest) of the ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What the legend calls it.
    pub name: String,
    /// Where the device stands.
    pub at: (f64, f64),
    /// β and σ of it, with nothing taken off.
    pub friction: (f64, f64),
    /// The least and the largest β less the cost, over the tolerances.
    pub beta: [f64; 2],
    /// The least and the largest σ less the cost.
    pub sigma: [f64; 2],
    /// What of the tolerances there is.
    pub tolerances: Tolerances,
    /// Where walls of other stiffness stand, from stiff to soft.
    pub softer: Vec<(f64, f64)>,
    /// Where the device stands with half the sampling period.
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

/// Whether a scene is one device, or many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tolerances {
    /// Every number is given without a tolerance.
    None,
    /// There are tolerances, all with two ends.
    Closed,
    /// Of some number one bound is given, as in `<0.1 N s/m`: the axes do not reach to where the other end is taken to be.
    Open,
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
        let at = scene.hardest().point().at;
        let friction = at.friction();
        let speed = at.max_speed.as_ref();
        let speed = speed.map(|v| (nearest_f64(v), format!("{} ticks/sample", approx(v))));
        let mut bounds = scene.parameters().into_iter();
        let tolerances = match scene.has_ends() {
            true if bounds.any(|(_, given)| given.is_bound()) => Tolerances::Open,
            true => Tolerances::Closed,
            false => Tolerances::None,
        };
        // Factors of softness in geometric steps of 9/8, 64 down and 64 up.
        let step = BigRational::new(9.into(), 8.into());
        let factors = (-64..=64_i32).map(|power| step.pow(power));
        Some(Self {
            name: report.scene.clone(),
            at: moved(&at, Parameter::Stiffness, &BigRational::one())?,
            friction: (nearest_f64(&friction.beta), nearest_f64(&friction.sigma)),
            beta: ends(&report.spare.viscous),
            sigma: ends(&report.spare.coulomb),
            tolerances,
            softer: factors
                .filter_map(|x| moved(&at, Parameter::Stiffness, &x.recip()))
                .collect(),
            faster: moved(&at, Parameter::Period, &half)?,
            finer: moved(&at, Parameter::Resolution, &half)?,
            has_costs: !at.is_plain(),
            speed: speed.filter(|(v, _)| *v > 0.0),
            verdict: report.verdict,
        })
    }

    /// What the axes are to show of β and σ.
    fn shown(&self) -> [[f64; 2]; 2] {
        let (beta, sigma) = self.at;
        match self.tolerances {
            Tolerances::Open => [[beta; 2], [sigma; 2]],
            Tolerances::None | Tolerances::Closed => [self.beta, self.sigma],
        }
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
    use passivity_scene::check::check;

    /// With K, T and Δ up to 2 and frictions down to 1 the hardest device is at β = 1/4, σ = 1/4, with V = 3 in steps of 2 in 2.
    #[test]
    fn mark_ways_and_line_are_of_the_hardest_device() {
        let text = "[device]\nviscous = \"1 … 2 N s/m\"\ncoulomb = \"1 … 2 N\"\n[sampling]\nperiod = \"1 … 2 s\"\n\
                    [encoder]\nresolution = \"1 … 2 m\"\n[wall]\nstiffness = \"1 … 2 N/m\"\n[operator]\n\
                    max_speed = \"1 … 3 m/s\"\n";
        let scene = Scene::from_toml("box", text).unwrap();
        let mark = Mark::of(&scene, &check(&scene)).unwrap();
        assert_eq!(
            (mark.at, mark.tolerances),
            ((0.25, 0.25), Tolerances::Closed)
        );
        assert_eq!((mark.faster, mark.finer), ((0.5, 0.25), (0.25, 0.5)));
        assert_eq!(mark.softer[64], mark.at);
        assert_eq!(mark.speed, Some((3.0, "3 ticks/sample".to_owned())));
    }

    #[test]
    fn a_point_too_far_out_is_an_error() {
        let mark = Mark {
            name: "far".to_owned(),
            at: (0.5, 1.0),
            friction: (0.5, 1.0),
            beta: [0.0, f64::INFINITY],
            sigma: [1.0; 2],
            tolerances: Tolerances::Closed,
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
