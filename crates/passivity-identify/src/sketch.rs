//! What a sketch says of the device, in doubles.

use passivity_core::parameter::Unit;
use passivity_core::{BigRational, Effect, Exact, Interval, Loop, Scalar as _};
use passivity_scene::{Motion, Scene};
use passivity_sim::{Double, Enclosed};

use crate::identified::IdentifyError;

/// Refuses what TH-IDENT does not cover: a force that changes between samples, and a hand.
pub(crate) fn covered(sketch: &Scene) -> Result<(), IdentifyError> {
    let refused = [Effect::Latency, Effect::Amplifier, Effect::Arm];
    let mut effects = sketch.effects();
    effects.retain(|effect| {
        refused.contains(effect) || (*effect == Effect::Force && !sketch.is_unforced())
    });
    if let Some(effect) = effects.first() {
        let error = IdentifyError::new(format!(
            "the sketch has {}: TH-IDENT is about a device that nobody touches, under a force that is \
             held from each sample to the next",
            effect.name()
        ));
        return Err(IdentifyError {
            is_not_covered: true,
            ..error
        });
    }
    if sketch.motion != Motion::Dimensionless && !sketch.given.has_encoder() {
        return Err(IdentifyError::new(
            "the sketch needs an [encoder]: its resolution says how well positions are known",
        ));
    }
    Ok(())
}

/// KT, KΔ and KT², between doubles.
pub(crate) fn units(nominal: &Loop<Exact>) -> Result<[[f64; 2]; 3], IdentifyError> {
    let [viscous, coulomb, inertia] =
        [Unit::VISCOUS, Unit::FORCE, Unit::INERTIA].map(|unit| ends(&nominal.unit(unit)));
    Ok([viscous?, coulomb?, inertia?])
}

/// Doubles around a number.
pub(crate) fn ends(x: &Exact) -> Result<[f64; 2], IdentifyError> {
    /// Bits of an enclosure: past those of a double.
    const BITS: u32 = 80;
    let undefined = || IdentifyError::new("a number of the sketch is not defined");
    let known = x.enclosure(BITS).ok_or_else(undefined)?;
    Ok(around(&known))
}

fn around(known: &Interval<BigRational>) -> [f64; 2] {
    let [lo, _] = Enclosed::<Double>::from(known.lo()).bounds();
    let [_, hi] = Enclosed::<Double>::from(known.hi()).bounds();
    [lo, hi]
}

pub(crate) fn middle([lo, hi]: [f64; 2]) -> f64 {
    0.5 * lo + 0.5 * hi
}

/// μ over the tolerance of the sketch; `None` where it has no inertia.
pub(crate) fn inertia(
    sketch: &Scene,
    nominal: &Loop<Exact>,
) -> Result<Option<[f64; 2]>, IdentifyError> {
    let Some(given) = &sketch.given.inertia else {
        return Ok(None);
    };
    let unit = nominal.unit(Unit::INERTIA);
    let [lo, _] = ends(&given.value.lo().clone().over(unit.clone()))?;
    let [_, hi] = ends(&given.value.hi().clone().over(unit))?;
    Ok(Some([lo, hi]))
}
