//! Whether a motion draws energy from a scene's loop, for the witnesses of another implementation.
//!
//! A motion is a list of positions at the samples of a period, at constant speed in between, for
//! ever. Its gain is the work of the held force less friction (23), computed from the encoder, the
//! controller's difference equation, the force steps, the limit and the actuator alone: latency and
//! lag are followed from sample to sample, between two ends where a lag makes e^(−1/θ) necessary.

use num_traits::Signed as _;
use passivity_core::circle::Circle;
use passivity_core::exponential::decay;
use passivity_core::frequency::ViscousCost;
use passivity_core::linear_part::{Command, LinearPart};
use passivity_core::transfer::TransferFunction;
use passivity_core::{
    BigRational, Controller, Friction, Interval, Loop, Scalar, absolute_sum, periodic, sturm,
};
use passivity_scene::Scene;
use passivity_scene::json::read_rational;
use passivity_scene::number::MAX_CHARS;
use serde_json::Value;

/// Bits to which exponentials, and what a lag makes of them, are enclosed.
const BITS: u32 = 192;

/// Bits to which the cosine of a wave is enclosed: a border may be 10⁻³⁰ away, and waves are long.
const COSINE_BITS: u32 = 600;

/// Checks the `witness` of an answer about a scene, and that it gains what is said of it; the error says what is wrong with it.
pub(super) fn check(scene: &Value, witness: &Value) -> Result<(), String> {
    let scene = Scene::from_json(scene).map_err(|error| error.to_string())?;
    let tested = Tested::of(&scene).ok_or("the scene has tolerances")?;
    let claimed = long_rational(&witness["gain_per_cycle"]);
    let claimed = claimed.filter(BigRational::is_positive);
    let claimed = claimed.ok_or("expected a gain_per_cycle above zero")?;
    if !witness["wave"].is_null() {
        return tested.check_wave(&witness["wave"], &claimed);
    }
    let given = match &witness["positions"] {
        Value::Array(positions) => positions.iter().collect(),
        _ => vec![&witness["from"], &witness["to"]],
    };
    let positions: Result<Vec<BigRational>, _> = given.into_iter().map(read_rational).collect();
    let positions = positions.map_err(|_| "expected positions, or {from, to}, or a wave")?;
    let too_fast = |d: BigRational| {
        tested
            .speed_bound
            .as_ref()
            .is_some_and(|v| Scalar::abs(&d) > *v)
    };
    if steps(&positions).any(too_fast) {
        return Err("the motion is faster than the operator".to_owned());
    }
    let gain = tested.gain(&positions).ok_or("a force is not defined")?;
    // With a lag the gain is a lower bound, some 2⁻¹⁹⁰ below what another may know.
    let slack = match tested.has_lag() {
        true => BigRational::new(1.into(), 1_000_000_000_000_i64.into()) * &gain,
        false => BigRational::zero(),
    };
    if !gain.is_positive() {
        Err(format!("the motion gains {gain} at least"))
    } else if claimed > &gain + slack {
        Err(format!("the motion gains {gain}, not {claimed}"))
    } else {
        Ok(())
    }
}

/// A figure, which may have more digits than what is given.
fn long_rational(figure: &Value) -> Option<BigRational> {
    const MOST: usize = 1 << 16;
    match figure.as_str() {
        Some(text) if text.len() > MAX_CHARS && text.len() <= MOST => text.parse().ok(),
        _ => read_rational(figure).ok(),
    }
}

/// From each position to the next, and from the last to the first.
fn steps(positions: &[BigRational]) -> impl Iterator<Item = BigRational> {
    let next = positions.iter().skip(1).chain(positions.first());
    positions.iter().zip(next).map(|(from, to)| to - from)
}

/// A loop of exact parameters, dimensionless.
struct Tested {
    law: TransferFunction<BigRational>,
    part: LinearPart,
    /// Encoder, one-sided wall, force steps and limit.
    applied: Controller<BigRational>,
    friction: Friction<BigRational>,
    speed_bound: Option<BigRational>,
}

impl Tested {
    fn of(scene: &Scene) -> Option<Self> {
        // What the effects cost is no part of a motion's gain, and may be known as an enclosure only.
        let bounds = Loop {
            viscous_cost: None,
            coulomb_cost: None,
            ..scene.bounds()
        };
        let part = bounds.linear_part(BITS)?;
        let exact = |range: &Interval<_>| -> Option<BigRational> {
            let ends = passivity_scene::check::enclosure(range)?;
            ends.is_point().then(|| ends.lo().clone())
        };
        let given: Loop<BigRational> = bounds.try_map(|_, range| exact(range))?;
        let dimensionless = given.dimensionless();
        let law = match &part.command {
            Command::Controller(controller) => controller.as_ref().clone(),
            Command::Spring { damping, pole } => {
                TransferFunction::filtered_damping(damping.lo(), pole.lo()).ok()?
            }
        };
        Some(Self {
            law,
            part,
            speed_bound: given
                .max_speed
                .as_ref()
                .map(|v| given.dimensionless_speed(v)),
            friction: given.friction(),
            applied: Controller::of(&dimensionless),
        })
    }

    fn has_lag(&self) -> bool {
        let actuator = self.part.actuator.as_ref();
        actuator.is_some_and(|actuator| *actuator.time_constant.lo() != BigRational::zero())
    }

    /// A lower bound of what the operator gains each time round; the gain itself without a lag.
    fn gain(&self, positions: &[BigRational]) -> Option<BigRational> {
        let forces = self.mean_forces(&self.commands(positions)?);
        let late = usize::from(self.part.delay) % positions.len();
        let forces = forces.iter().cycle().skip(positions.len() - late);
        Some(
            forces
                .zip(steps(positions))
                .fold(BigRational::zero(), |sum, (force, d)| {
                    let work = Scalar::min(force.lo() * &d, force.hi() * &d);
                    sum + work - self.friction.dissipated_lower(&d, &Scalar::abs(&d))
                }),
        )
    }

    /// The forces commanded from each sample on: rounded, limited, and none outside the wall.
    fn commands(&self, positions: &[BigRational]) -> Option<Vec<BigRational>> {
        let measured: Vec<_> = positions
            .iter()
            .map(|xi| self.applied.measured(xi))
            .collect();
        let of_law = periodic::commands(&self.law, &measured)?;
        let applied = of_law.into_iter().zip(&measured);
        // A force is a negated output.
        Some(
            applied
                .map(|(force, q)| self.applied.applied(&-force, std::slice::from_ref(q)))
                .collect(),
        )
    }

    /// The mean over each interval of what the actuator makes of commands that repeat for ever.
    fn mean_forces(&self, commands: &[BigRational]) -> Vec<Interval<BigRational>> {
        let Some(actuator) = &self.part.actuator else {
            return commands.iter().cloned().map(Interval::point).collect();
        };
        let (latency, theta) = (actuator.latency.lo(), actuator.time_constant.lo());
        let count = commands.len();
        let whole = usize::try_from(latency.to_integer()).unwrap_or(usize::MAX) % count;
        let first = latency - latency.floor();
        let rest = BigRational::one() - &first;
        // For `first` of an interval the command before the one of its sample acts, late by `whole`.
        let at = |h: usize| &commands[(h + 2 * count - whole) % count];
        if *theta == BigRational::zero() {
            let mean = |h: usize| at(h + count - 1) * &first + at(h) * &rest;
            return (0..count).map(|h| Interval::point(mean(h))).collect();
        }
        let [e1, e2] = [&first, &rest].map(|time| decay(&(time / theta), BITS));
        let least = commands.iter().cloned().reduce(Scalar::min);
        let most = commands.iter().cloned().reduce(Scalar::max);
        let mut output = match (least, most) {
            (Some(least), Some(most)) => Interval::hull(least, most),
            _ => return Vec::new(),
        };
        // Whatever it was at first is forgotten after so many periods.
        let forgotten = (theta * BigRational::integer(100)).ceil().to_integer();
        let rounds = usize::try_from(forgotten).unwrap_or(usize::MAX) / count + 2;
        let mut means = Vec::new();
        for h in 0..rounds * count {
            let mut mean = Interval::point(BigRational::zero());
            for (command, time, e) in [
                (at(h % count + count - 1), &first, &e1),
                (at(h % count), &rest, &e2),
            ] {
                let after = relaxed(&output, command, e);
                // The integral of the output: command · time + θ(before − after).
                let lo = mean.lo() + command * time + theta * (output.lo() - after.hi());
                let hi = mean.hi() + command * time + theta * (output.hi() - after.lo());
                mean = Interval::hull(lo, hi);
                output = after;
            }
            if h >= (rounds - 1) * count {
                means.push(mean);
            }
        }
        means
    }

    /// Checks a wave, steps A·cos θh off by at most 1 with θ = 2πq/p: with s ≤ λ(θ) − β it gains at
    /// least p·[s(½A² − 2A) − F − (σ + ½δ)(A + 1)], where F is at least every |λ − β|. And with s ≥ λ(θ) − β at most
    /// p·[s(½A² + 2A) + F + ½δ(A + 1)], for a wave is an eigenvector of the account and the rest has length √p at most.
    fn check_wave(&self, wave: &Value, claimed: &BigRational) -> Result<(), String> {
        let number = |name: &str| read_rational(&wave[name]).map_err(|_| format!("no {name}"));
        let [q, p, amplitude] = [number("turns")?, number("period")?, number("amplitude")?];
        let three = [&q, &p, &amplitude];
        let four = BigRational::integer(4);
        if three.iter().any(|x| !x.is_integer()) || !q.is_positive() || p < q || amplitude < four {
            return Err(
                "a wave has whole numbers, 0 < turns ≤ period and amplitude ≥ 4".to_owned(),
            );
        }
        let plain = self.part.linear && self.speed_bound.is_none();
        let whole = self.whole().filter(|_| plain);
        let whole = whole.ok_or("a formula is for a linear law without a lag and a bound")?;
        let one = BigRational::one();
        let bound = absolute_sum::viscous_bound(&whole, &one).ok_or("too slow a controller")?;
        let cost = ViscousCost::of(&whole);
        let beta = &self.friction.beta;
        let one_at_most =
            |end: &BigRational| Scalar::max(Scalar::min(end.clone(), one.clone()), -one.clone());
        let cosine = Circle::to(COSINE_BITS).cosine(&(q / &p)).map(one_at_most);
        let short = cost.at(cosine.lo()) - beta;
        let (spare, most) = (short.clone().half(), short.double());
        let over = cost.spare(&(beta + &spare)).scaled(&-one.clone());
        if !spare.is_positive() || !sturm::sign_over(&over, &cosine).is_nonnegative() {
            return Err("friction is enough at the frequency of the wave".to_owned());
        }
        let rounding = match &self.applied.force_step {
            Some([n, d]) => (n / d).half(),
            None => BigRational::zero(),
        };
        let at_most = cost.spare(&(beta + &most));
        let square = amplitude.square().half();
        let yields = most * (&square + amplitude.clone().double()) + bound.hi() + beta;
        let yields = p * (yields + &rounding * (&amplitude + &one));
        if !sturm::sign_over(&at_most, &cosine).is_nonnegative() || *claimed > yields {
            return Err("the wave does not gain as much as gain_per_cycle says".to_owned());
        }
        let drawn = spare * (square - amplitude.clone().double());
        let spent = bound.hi() + beta + (&self.friction.sigma + rounding) * (amplitude + one);
        if drawn > spent {
            Ok(())
        } else {
            Err("the wave is too small to gain".to_owned())
        }
    }

    /// The law with its delay and latency; `None` with a lag.
    fn whole(&self) -> Option<TransferFunction<BigRational>> {
        let late = self.law.clone().delayed(self.part.delay);
        let Some(actuator) = &self.part.actuator else {
            return Some(late);
        };
        if self.has_lag() {
            return None;
        }
        let latency = actuator.latency.lo();
        let first = latency - latency.floor();
        let rest = BigRational::one() - &first;
        let mut numerator = vec![BigRational::zero(); late.numerator().len() + 1];
        for (j, n) in late.numerator().iter().enumerate() {
            numerator[j] += n * &rest;
            numerator[j + 1] += n * &first;
        }
        let samples = u16::try_from(latency.to_integer()).ok()?;
        let whole = TransferFunction::new(numerator, late.denominator()).ok()?;
        Some(whole.delayed(samples))
    }
}

/// u + (x − u)e, rounded outwards to a grid so that the numbers stay short.
fn relaxed(
    x: &Interval<BigRational>,
    command: &BigRational,
    e: &Interval<BigRational>,
) -> Interval<BigRational> {
    let unit = BigRational::integer(2).pow(-192);
    let by = |away: BigRational, less: bool| {
        // Away from the command the larger power is farther.
        let far = away.is_negative() == less;
        command + away * if far { e.hi() } else { e.lo() }
    };
    let lo = by(x.lo() - command, true);
    let hi = by(x.hi() - command, false);
    Interval::hull((lo / &unit).floor() * &unit, (hi / &unit).ceil() * unit)
}
