//! The costs of a loop that no closed form says (TH-LTI, TH-LATENCY, TH-LAG), computed when the scene
//! is read.

use passivity_core::{Enclosed, Exact, Interval, Loop, Parameter, Wide};

use crate::check::BITS;
use crate::diagnostic::{Diagnostic, Kind};
use crate::parse::reader::Reader;
use crate::scene::Given;

/// The loop with its computed costs, over the tolerances and without them; `None`, and a diagnostic,
/// where they are beyond what the kernel computes.
pub(super) fn computed(given: Loop<Given>, reader: &mut Reader<'_>) -> Option<Loop<Given>> {
    if !given.has_computed_costs() {
        return Some(given);
    }
    let over = of(&given.map(|_, given| given.value.clone()));
    let nominal = if given.given().any(|(_, given)| given.has_tolerance()) {
        of(&given.map(|_, given| Interval::point(given.nominal.clone())))
    } else {
        over.clone()
    };
    let (Some(over), Some(nominal)) = (over, nominal) else {
        reader.report(beyond(&given));
        return None;
    };
    let pairs = over.into_iter().zip(nominal);
    let parameters = [Parameter::ViscousCost, Parameter::CoulombCost];
    Some(
        parameters
            .into_iter()
            .zip(pairs)
            .fold(given, |given, (parameter, pair)| {
                let (Some(value), Some(nominal)) = pair else {
                    return given;
                };
                let cost = Given {
                    value,
                    // Never less than it costs.
                    nominal: nominal.hi().clone(),
                    ..Given::unit(parameter)
                };
                given.with(parameter, cost)
            }),
    )
}

/// The viscous and the Coulomb cost, where they are computed.
type Costs = [Option<Interval<Exact>>; 2];

fn of(bounds: &Loop<Interval<Exact>>) -> Option<Costs> {
    fn costs<S: Enclosed>(
        bounds: &Loop<Interval<S>>,
        exact: impl Fn(&S) -> Option<Exact>,
    ) -> Option<Costs> {
        let with = bounds.with_costs(BITS)?;
        let cost = |cost: Option<Interval<S>>| match cost {
            Some(cost) => cost.try_map(&exact).map(Some),
            None => Some(None),
        };
        Some([cost(with.viscous_cost)?, cost(with.coulomb_cost)?])
    }
    match bounds.try_map(|_, range| range.try_map(Wide::of)) {
        // Without π it is faster.
        Some(wide) => costs(&wide, |x| Some(Exact::of(x.enclosed(BITS)?.lo()))),
        None => costs(bounds, |x| Some(x.clone())),
    }
}

/// What is said where the costs cannot be computed.
fn beyond(given: &Loop<Given>) -> Diagnostic {
    let lag = given.time_constant.as_ref().or(given.latency.as_ref());
    match (&given.controller, lag) {
        (None, Some(lag)) => {
            let message = format!("`{}` is too many sampling periods", lag.key);
            Diagnostic::new(Kind::OutOfBounds, message)
                .at(lag.span.clone())
                .key(lag.key)
                .expected("a time of at most a few thousand sampling periods")
        }
        _ => {
            let message = "the controller forgets too slowly for its costs to be computed";
            Diagnostic::new(Kind::OutOfBounds, message)
                .key("controller")
                .expected("poles further away from the unit circle")
        }
    }
}
