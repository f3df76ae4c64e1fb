//! A scene at the ends of its tolerances.

use passivity_core::parameter::Hurts;
use passivity_core::verdict::End;
use passivity_core::{BigRational, Enclosed as _, Exact, Interval, Parameter, Scalar as _, Truth};

use crate::check::BITS;
use crate::scene::{Given, Scene};

/// The parameters that costs are computed from: which of their ends is the harder one depends on all of them.
const SHAPING: [Parameter; 6] = [
    Parameter::Stiffness,
    Parameter::Period,
    Parameter::Damping,
    Parameter::DampingTimeConstant,
    Parameter::Latency,
    Parameter::TimeConstant,
];

impl Scene {
    /// Whether a parameter that has a part in the criterion is given with a tolerance.
    #[must_use]
    pub fn has_ends(&self) -> bool {
        let given = self.parameters().into_iter();
        given.into_iter().any(|(parameter, given)| {
            given.has_tolerance() && parameter.row().hurts != Hurts::Neither
        })
    }

    /// The parameters with a tolerance of which either end may be the harder one to meet the criterion at.
    pub(crate) fn either_way(&self) -> Vec<Parameter> {
        let bounds = self.bounds();
        let (all, period) = (bounds.has_computed_costs(), bounds.period_pulls_both_ways());
        let mut shaping = SHAPING.to_vec();
        shaping.retain(|parameter| {
            let given = self.given.get(*parameter);
            given.is_some_and(Given::has_tolerance)
                && (all || period && *parameter == Parameter::Period)
        });
        shaping
    }

    /// The scene with each parameter at that end of its tolerance at which the criterion is hardest to meet; what has no
    /// part in the criterion stays as it is.
    ///
    /// Where either end of some may be the harder one, it is the hardest of the devices with these at their ends: one that
    /// does not meet the criterion, if there is one, and then the one whose margin is the least: (8) at the
    /// bound on the speed, or, without one, what is less to spare of β and of σ.
    #[must_use]
    pub fn hardest(&self) -> Self {
        let open = self.either_way();
        let corner = |number: u32| {
            self.at(
                |parameter, value| match open.iter().position(|other| *other == parameter) {
                    Some(i) if number >> i & 1 == 0 => value.lo().clone(),
                    Some(_) => value.hi().clone(),
                    None => End::Hardest.of(parameter, value).clone(),
                },
            )
        };
        let corners = (0..1 << open.len()).map(corner);
        let spared = corners.map(|scene| {
            (
                if open.is_empty() {
                    None
                } else {
                    scene.spared()
                },
                scene,
            )
        });
        let hardest = spared.min_by(|(a, _), (b, _)| a.cmp(b));
        hardest.map_or_else(|| self.clone(), |(_, scene)| scene)
    }

    /// The scene with each parameter at the end of its tolerance that the table of parameters says.
    pub(crate) fn with_ends(&self, end: End) -> Self {
        self.at(|parameter, value| end.of(parameter, value).clone())
    }

    /// The scene with each parameter of the criterion at one value of its own.
    fn at(&self, value: impl Fn(Parameter, &Interval<Exact>) -> Exact) -> Self {
        let mut scene = self.clone();
        scene.given = scene.given.map(|parameter, given| {
            if parameter.row().hurts == Hurts::Neither {
                return given.clone();
            }
            let at = value(parameter, &given.value);
            Given {
                value: Interval::point(at.clone()),
                nominal: at,
                ..given.clone()
            }
        });
        scene
    }

    /// What one device has to spare, for comparison with others: whether it meets the criterion, and by how much.
    fn spared(&self) -> Option<(u8, BigRational)> {
        let bounds = self.bounds();
        let holds = match bounds.truth(&bounds.speeds())? {
            Truth::Fails => 0,
            Truth::Depends => 1,
            Truth::Holds => 2,
        };
        let with_costs = bounds.with_costs(BITS)?.map(|_, x| x.hi().clone());
        let criterion = with_costs.dimensionless_criterion();
        let ticks = |speed: &Exact| {
            let way = speed.clone() * with_costs.period.clone();
            way.over(with_costs.resolution.clone().unwrap_or_else(Exact::one))
        };
        let spare = match with_costs.max_speed.as_ref().map(ticks) {
            // As (8) has it: per speed.
            Some(bound) => criterion.margin(&bound).over(bound),
            None => criterion.margin_at_all_speeds(),
        };
        Some((holds, spare.enclosed(BITS)?.hi().clone()))
    }
}
