//! Time between a sample and the change of the force, in parts of a period (TH-LATENCY).
//!
//! Of a latency of k + f periods, 0 ≤ f < 1, the k are samples of delay. What is left puts the change of
//! the force into the interval: up to f the force of the sample before goes on, then this one's begins.
//! So an interval is two motions under constant forces. A motion of t periods is one over a whole
//! interval of another time: with t as the unit, μ is μ/t², β is β/t, the amplifier's time constant is
//! over t, and a speed v is vt, while positions, forces and energies stay. What moves the device over
//! an interval moves it over each part.

use passivity_core::{BigRational, Loop, Scalar};

use crate::error::SimError;

/// The whole periods of a loop's latency.
///
/// # Errors
///
/// A latency longer than any delay.
pub(crate) fn whole_periods(dimensionless: &Loop<BigRational>) -> Result<usize, SimError> {
    let latency = dimensionless.latency.as_ref();
    let whole = latency.map(|latency| u16::try_from(latency.to_integer()));
    match whole {
        None => Ok(0),
        Some(Ok(whole)) => Ok(whole.into()),
        Some(Err(_)) => Err(SimError::OutOfRange {
            parameter: "latency",
            expected: "at most 65535 sampling periods",
        }),
    }
}

/// The parts of an interval, in periods: up to the change of the force, and from it on. None where the
/// force changes at the sample.
pub(crate) fn times(dimensionless: &Loop<BigRational>) -> Option<[BigRational; 2]> {
    let latency = dimensionless.latency.as_ref()?;
    let fraction = latency - latency.floor();
    let rest = BigRational::one() - &fraction;
    (fraction > BigRational::zero()).then_some([fraction, rest])
}

/// The loop of a part of an interval, with its length `time` as the unit of time.
pub(crate) fn part<S: Scalar>(dimensionless: &Loop<S>, time: &S) -> Loop<S> {
    let slower = |x: &Option<S>| x.clone().map(|x| x.over(time.clone()));
    let heavier = |x: &Option<S>| x.clone().map(|x| x.over(time.square()));
    Loop {
        inertia: heavier(&dimensionless.inertia),
        viscous: slower(&dimensionless.viscous),
        time_constant: slower(&dimensionless.time_constant),
        arm_mass: heavier(&dimensionless.arm_mass),
        arm_damping: slower(&dimensionless.arm_damping),
        ..dimensionless.clone()
    }
}
