//! A motion that draws energy, as a report shows it.

use passivity_core::drawn::Drawn;
use passivity_core::{BigRational, Enclosed, Interval, Loop, Scalar};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use super::BITS;
use crate::json::shape;

/// A motion that draws energy from the display each time round (TH-ACTIVE, TH-LTI): ticks, or the
/// unit of length without an encoder.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Witness {
    /// Where it starts and ends.
    #[serde(with = "shape::Rational")]
    pub from: BigRational,
    /// Where it is farthest from there; of a formula, a place on the way.
    #[serde(with = "shape::Rational")]
    pub to: BigRational,
    /// Its positions at the samples of a period, in between at constant speed and after the last one
    /// back to the first; empty where the motion is a formula.
    #[serde(serialize_with = "rationals")]
    #[schemars(with = "Vec<shape::Rational>")]
    pub positions: Vec<BigRational>,
    /// The formula of a motion that may be too long to write down.
    pub wave: Option<WaveFormula>,
    /// What the operator gains at least each time round, in KΔ².
    #[serde(with = "shape::Rational")]
    pub gain_per_cycle: BigRational,
    /// The same in joules, with the softest wall and the finest encoder that the tolerances allow;
    /// `None` for a dimensionless scene.
    #[serde(with = "shape::OptionalRational")]
    pub gain_per_cycle_joules: Option<BigRational>,
}

/// Steps A·cos(2πqh/p), h = 0 … p − 1, each position rounded to a whole tick: a wave of period p.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct WaveFormula {
    /// q, as a whole number in decimals.
    pub turns: String,
    /// p, in samples.
    pub period: String,
    /// A, in whole ticks a sample.
    pub amplitude: String,
}

/// A motion as it is reported.
pub(super) fn witness<S: Enclosed>(
    drawn: Drawn,
    bounds: &Loop<Interval<S>>,
    has_units: bool,
) -> Option<Witness> {
    let least = bounds.map(|_, x| x.lo().clone());
    let energy_unit = (least.force_unit() * least.length()).enclosed(BITS)?;
    let joules = |gain: &BigRational| has_units.then(|| gain * energy_unit.lo());
    Some(match drawn {
        Drawn::Motion(motion) => {
            let from = motion.positions.first()?.clone();
            let far = |x: &&BigRational| Scalar::abs(&(*x - &from));
            let to = motion.positions.iter().max_by_key(far)?.clone();
            Witness {
                gain_per_cycle_joules: joules(&motion.gain),
                from,
                to,
                positions: motion.positions,
                wave: None,
                gain_per_cycle: motion.gain,
            }
        }
        Drawn::Wave(wave) => Witness {
            gain_per_cycle_joules: joules(&wave.gain_at_least),
            from: BigRational::zero(),
            // The wave goes up and down by A·p/(πq), which is more.
            to: BigRational::from_integer(&wave.period * &wave.amplitude / (4 * &wave.turns)),
            positions: Vec::new(),
            gain_per_cycle: wave.gain_at_least,
            wave: Some(WaveFormula {
                turns: wave.turns.to_string(),
                period: wave.period.to_string(),
                amplitude: wave.amplitude.to_string(),
            }),
        },
    })
}

pub(crate) fn rationals<S: Serializer>(
    list: &[BigRational],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(list.iter().map(crate::json::rational))
}
