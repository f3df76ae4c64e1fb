//! How the numbers of a log become ticks, sampling periods and KΔ.

use std::sync::Arc;

use passivity_core::{Exact, Interval, Loop, Scalar, pi};
use passivity_scene::units::{Dimension, Unit};
use passivity_scene::{Motion, Scene};

use crate::ball::{self, Ball, Short};
use crate::log::error::TraceError;
use crate::log::header::{read_unit, read_unit_of_force};
use crate::log::irrational::Irrational;
use crate::log::numbers::{Kind, Numbers};
use crate::log::running::near;
use crate::number::{Number, product};
use crate::reading::Reading;

/// How a number of the trace becomes one in ticks or in KΔ.
#[derive(Clone, Debug)]
pub(crate) enum Scale {
    /// It is one.
    One,
    /// By a rational factor.
    Factor(Number),
    /// By a factor with π in it.
    Irrational(Arc<Irrational>),
}

impl Scale {
    fn of(factor: Exact) -> Result<Self, TraceError> {
        /// Bits of the enclosure: past those of the longest logs and of the grid by far.
        const BITS: u32 = 256;
        if let Some(x) = factor.to_rational() {
            return Ok(Self::Factor(Number::from(x)));
        }
        match factor.enclosure(BITS) {
            Some(range) => Ok(Self::Irrational(Arc::new(Irrational::new(factor, range)))),
            None => Err(TraceError::new(
                "unit",
                "the unit of this column is not defined",
            )),
        }
    }

    pub(crate) const fn is_irrational(&self) -> bool {
        matches!(self, Self::Irrational(..))
    }

    /// With the other sign.
    pub(crate) fn reversed(self) -> Self {
        match self {
            Self::One => Self::Factor(Number::whole(-1)),
            Self::Factor(factor) => Self::Factor(product(&factor, &Number::whole(-1))),
            Self::Irrational(by) => {
                let range = Interval::hull(-by.range.lo().clone(), -by.range.hi().clone());
                let factor = Exact::zero() - by.factor.clone();
                Self::Irrational(Arc::new(Irrational::new(factor, range)))
            }
        }
    }

    /// A position or a force as it is known.
    pub(crate) fn read(&self, kind: Kind, x: Number) -> Result<Reading, TraceError> {
        match kind {
            Kind::Position => self.position(x),
            Kind::Force => self.force(x),
        }
    }

    /// A position as it is known.
    pub(crate) fn position(&self, x: Number) -> Result<Reading, TraceError> {
        match self {
            Self::One => Ok(Reading::Exact(x)),
            Self::Factor(factor) => Ok(Reading::Exact(product(&x, factor))),
            Self::Irrational(by) => by.position(x),
        }
    }

    /// A force as it is known.
    pub(crate) fn force(&self, x: Number) -> Result<Reading, TraceError> {
        match self {
            Self::One => Ok(Reading::Exact(x)),
            Self::Factor(factor) => Ok(Reading::Exact(product(&x, factor))),
            Self::Irrational(by) => by.force(x),
        }
    }

    /// The factor p/q, q > 0, where it is rational and short.
    fn ratio(&self) -> Option<(i64, i64)> {
        match self {
            Self::One => Some((1, 1)),
            Self::Factor(Number::Small(p, q)) => Some((*p, *q)),
            Self::Factor(_) | Self::Irrational(_) => None,
        }
    }

    /// What is known of n over 10^k as a position or a force; `None` where that takes longer to find out.
    #[inline]
    pub(crate) fn near_decimal(&self, kind: Kind, n: i64, k: u8) -> Option<Ball> {
        match self {
            Self::One | Self::Factor(_) => {
                let (p, q) = self.ratio()?;
                // 10^k = 5^k·2^k
                let fives = 5_i64.checked_pow(k.into())?;
                scaled(p, n, q.checked_mul(fives)?, k.into())
            }
            Self::Irrational(by) => by.near(kind, n, k),
        }
    }

    /// The same of a double.
    #[inline]
    pub(crate) fn near_double(&self, kind: Kind, x: f64) -> Option<Ball> {
        match self {
            Self::One | Self::Factor(_) => {
                let (p, q) = self.ratio()?;
                match Number::from_f64(x)? {
                    Number::Small(n, d) => scaled(p, n, q, d.trailing_zeros()),
                    Number::Tiny(n, k) => scaled(p, n, q, k),
                    Number::Big(_) => None,
                }
            }
            Self::Irrational(by) => by.of_double(kind, x).or_else(|| by.near_double(kind, x)),
        }
    }

    /// What is known of the numbers of a column from one on, several at a time: their middles and radii, which are given
    /// without a number in the middle, and stay or become so where that takes longer to find out.
    pub(crate) fn near_several(
        &self,
        kind: Kind,
        written: &Numbers,
        from: usize,
        balls: (&mut [f64], &mut [f64]),
    ) {
        let factor = self.ratio().map(|(p, q)| Short::new(p, q));
        match written {
            Numbers::Doubles(values) => {
                let values = values.get(from..).unwrap_or_default();
                match (self, factor) {
                    (Self::Irrational(by), _) => by.of_several(kind, values, balls),
                    (_, Some(factor)) => ball::scaled(values, factor, balls),
                    (_, None) => {}
                }
            }
            Numbers::Decimals(numerators, powers) => {
                let numerators = numerators.get(from..).unwrap_or_default();
                let decimals = (numerators, powers.get(from..).unwrap_or_default());
                match (self, factor) {
                    (Self::Irrational(by), _) => by.of_decimals(kind, decimals, balls),
                    (_, Some(factor)) => ball::scaled_decimals(decimals, factor, balls),
                    (_, None) => {}
                }
            }
            Numbers::Any(_) => {}
        }
    }

    /// The size of a unit of it.
    pub(crate) fn size(&self) -> f64 {
        match self {
            Self::One => 1.0,
            Self::Factor(factor) => near(&factor.to_rational()).abs(),
            Self::Irrational(by) => near(by.range.lo()).abs(),
        }
    }
}

/// The ball of p·n/(q·2^k), q > 0; `None` where it takes longer.
fn scaled(p: i64, n: i64, q: i64, k: u32) -> Option<Ball> {
    let [size, by] = [n, p].map(|x| u128::from(x.unsigned_abs()));
    Ball::of_scaled_quotient((n < 0) != (p < 0), size * by, q.unsigned_abs(), k)
}

fn given<'t>(text: Option<&'t str>, example: &str) -> Result<&'t str, TraceError> {
    text.ok_or_else(|| {
        let message = format!("a column with a unit is needed, as in `{example}`");
        TraceError::new("unit", message)
    })
}

fn needs_units(scene: &Scene, instead: &str) -> Result<(), TraceError> {
    if scene.motion == Motion::Dimensionless {
        let message = format!("the scene is dimensionless: give `{instead}`");
        return Err(TraceError::new("unit", message));
    }
    Ok(())
}

/// Whether a unit measures what the scene's own does, radians being no dimension to insist on.
fn expect(unit: &Unit, linear: Dimension, scene: &Scene, what: &str) -> Result<(), TraceError> {
    let rotary = match what {
        "a position" => Dimension::NONE.with_angle(1),
        _ => Dimension::new(1, 2, -2, 0),
    };
    let found = unit.dimension().with_angle(0);
    let (expected, example) = match (scene.motion, what) {
        (Motion::Linear, "a position") => (linear, "mm"),
        (Motion::Linear, _) => (linear, "N"),
        (_, "a position") => (rotary, "rad"),
        (_, _) => (rotary, "N m"),
    };
    if found == expected.with_angle(0) {
        return Ok(());
    }
    let message = format!("expected the unit of {what}, such as `{example}`");
    Err(TraceError::new("unit", message))
}

pub(crate) fn position_scale(text: Option<&str>, scene: &Scene) -> Result<Scale, TraceError> {
    needs_units(scene, "xi")?;
    let unit = read_unit(given(text, "x [rad]")?)?;
    expect(&unit, Dimension::new(0, 1, 0, 0), scene, "a position")?;
    if let Some(radians) = in_radians(&unit, scene) {
        return Err(TraceError::new("unit", needs_radians(radians)));
    }
    Scale::of(exact(&unit).over(nominal(scene).length()))
}

/// How many radians the unit of an angle is, where it has π in it and the scene has no encoder, without which such angles
/// are not read.
pub(crate) fn in_radians(unit: &Unit, scene: &Scene) -> Option<f64> {
    let is_angle =
        scene.motion == Motion::Rotary && unit.dimension().with_angle(0) == Dimension::NONE;
    let is_irrational = unit.pi_power() != 0 && is_angle && !scene.given.has_encoder();
    let enclosure = exact(unit).enclosure(64).filter(|_| is_irrational)?;
    Some(near(&enclosure.middle()))
}

/// Why they are not, and what is to be done about it.
pub(crate) fn needs_radians(radians: f64) -> String {
    format!(
        "without an encoder in the scene positions are accounted for in radians, of which angles in other units are no exact \
         multiple: multiply its numbers by {radians:?} and call the column `x [rad]`"
    )
}

/// A unit in SI.
fn exact(unit: &Unit) -> Exact {
    let power = (0..unit.pi_power().unsigned_abs()).fold(Exact::one(), |x, _| x * pi::pi());
    let scale = Exact::of(unit.scale());
    if unit.pi_power() < 0 {
        scale.over(power)
    } else {
        scale * power
    }
}

/// The parameters of a scene at their nominal values.
fn nominal(scene: &Scene) -> Loop<Exact> {
    scene.given.map(|_, given| given.nominal.clone())
}

/// A revolution of the device, where it is rotary, and one of the motor behind its transmission, in ticks.
pub(crate) fn revolutions(scene: &Scene) -> [Option<f64>; 2] {
    let of = |radians_per_unit: Exact| {
        let turn = (Exact::integer(2) * pi::pi()).over(radians_per_unit * nominal(scene).length());
        Some(near(&turn.enclosure(64)?.middle()))
    };
    let device = (scene.motion == Motion::Rotary).then(Exact::one);
    let motor = scene.transmission.as_ref().map(|it| it.ratio.clone());
    [device, motor].map(|ratio| ratio.and_then(of))
}

pub(crate) fn time_scale(text: Option<&str>, scene: &Scene) -> Result<Number, TraceError> {
    needs_units(scene, "tau")?;
    let unit = read_unit(given(text, "t [s]")?)?;
    if unit.dimension() != Dimension::new(0, 0, 1, 0) {
        let message = "expected a unit of time, such as `s`";
        return Err(TraceError::new("unit", message));
    }
    match nominal(scene).period.over(exact(&unit)).to_rational() {
        Some(x) => Ok(Number::from(x)),
        None => Err(TraceError::new("unit", "a unit of time has no π in it")),
    }
}

pub(crate) fn force_scale(text: Option<&str>, scene: &Scene) -> Result<Scale, TraceError> {
    if text.is_none() && scene.motion == Motion::Dimensionless {
        return Ok(Scale::One);
    }
    let unit = read_unit_of_force(given(text, "f [N]")?)?;
    needs_units(scene, "f")?;
    expect(&unit, Dimension::new(1, 1, -2, 0), scene, "a force")?;
    Scale::of(exact(&unit).over(nominal(scene).force_unit()))
}

/// A unit of velocity in ticks per sampling period: a double, for velocities are compared only.
pub(crate) fn velocity_scale(text: Option<&str>, scene: &Scene) -> Result<f64, TraceError> {
    if text.is_none() && scene.motion == Motion::Dimensionless {
        return Ok(1.0);
    }
    let unit = read_unit(given(text, "v [rad/s]")?)?;
    needs_units(scene, "v")?;
    let linear = scene.motion == Motion::Linear;
    let expected = Dimension::new(0, i8::from(linear), -1, 0);
    if unit.dimension().with_angle(0) != expected {
        let example = if linear { "m/s" } else { "rad/s" };
        let message = format!("expected the unit of a velocity, such as `{example}`");
        return Err(TraceError::new("unit", message));
    }
    let nominal = nominal(scene);
    let factor = (exact(&unit) * nominal.period.clone()).over(nominal.length());
    match factor.enclosure(64) {
        Some(range) => Ok(near(&range.middle())),
        None => Err(TraceError::new(
            "unit",
            "the unit of this column is not defined",
        )),
    }
}

#[cfg(test)]
mod tests {
    use passivity_random::draws;
    use proptest::prelude::*;

    use super::*;

    fn double() -> impl Strategy<Value = f64> {
        prop_oneof![
            4 => -1.0..1.0,
            2 => -1e6..1e6,
            2 => (-100_000_i32..100_000).prop_map(|n| f64::from(n) / 1000.0),
            1 => (-64_i32..64).prop_map(|n| f64::from(n) / 16.0),
            1 => any::<f64>().prop_filter("a number", |x| x.is_finite()),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(draws(4000)))]

        #[test]
        fn a_product_is_known_as_closely_as_by_big_numbers(
            x in double(), n in prop_oneof![any::<i64>(), -100_000..100_000_i64], k in 0..=crate::number::MOST_DECIMALS,
            p in prop_oneof![1..2000_i64, Just(100_000_i64), Just(1_i64 << 34), 1..i64::MAX],
            q in prop_oneof![1..2000_i64, Just(3_i64), 1..1_i64 << 49, 1..i64::MAX],
            count: i16, reversed: bool,
        ) {
            let factor = Number::Small(if reversed { -p } else { p }, q).reduced();
            let scale = Scale::Factor(factor.clone());
            let kind = Kind::Position;
            // The width of some ticks, too, which is close to the border between two of them.
            let ticks = f64::from(count) * q as f64 / p as f64;
            let doubles = Numbers::Doubles(vec![x, ticks, -ticks]);
            let decimals = Numbers::Decimals(vec![n, n % 1000, count.into()], vec![k, 0, 3]);
            for written in [doubles, decimals] {
                let (mut middles, mut radii) = ([0.0; 3], [0.0; 3]);
                scale.near_several(kind, &written, 0, (&mut middles, &mut radii));
                for (i, parts) in middles.into_iter().zip(radii).enumerate() {
                    let number = written.get(i).unwrap();
                    let expected = Reading::Exact(product(&number, &factor)).to_near();
                    let expected = expected.lo().parts();
                    let one = match &written {
                        Numbers::Doubles(values) => scale.near_double(kind, values[i]),
                        Numbers::Decimals(n, k) => scale.near_decimal(kind, n[i], k[i]),
                        Numbers::Any(_) => None,
                    };
                    prop_assert!(one.is_none_or(|ball| ball.parts() == expected));
                    prop_assert!(parts.0.is_nan() || parts == expected, "{:?} {:?} {}", parts, expected, number);
                    // All of usual sizes are decided.
                    let is_short = |x: i64, most: u32| x.unsigned_abs() <= 1 << most;
                    let usual = match &written {
                        Numbers::Doubles(values) => {
                            is_short(q, 49) && (values[i] == 0.0 || (1e-60..9e15).contains(&values[i].abs()))
                        }
                        Numbers::Decimals(n, k) => {
                            is_short(n[i], 52) && is_short(q, 32) && k[i] < 6
                        }
                        Numbers::Any(_) => false,
                    };
                    prop_assert!(!parts.0.is_nan() || !usual || !is_short(p, 34));
                }
            }
        }
    }
}
