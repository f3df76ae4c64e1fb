//! How the numbers of a log become ticks, sampling periods and KΔ.

use std::sync::Arc;

use num_integer::Integer as _;
use passivity_core::{Exact, Interval, Loop, Scalar, pi};
use passivity_scene::units::{Dimension, Unit};
use passivity_scene::{Motion, Scene};

use crate::ball::Ball;
use crate::log::error::TraceError;
use crate::log::header::read_unit;
use crate::log::irrational::Irrational;
use crate::log::numbers::Kind;
use crate::log::running::near;
use crate::number::{Number, power_of_ten, product};
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

    /// What is known of n over 10^k as a position or a force; `None` where that takes longer to find out.
    #[inline]
    pub(crate) fn near(&self, kind: Kind, n: i64, k: u8) -> Option<Ball> {
        match self {
            Self::One => Some(Ball::of_reading(&Number::Small(n, power_of_ten(k.into())?))),
            Self::Factor(factor) => {
                let x = Number::Small(n, power_of_ten(k.into())?);
                Some(Ball::of_reading(&product(&x, factor)))
            }
            Self::Irrational(by) => by.near(kind, n, k),
        }
    }

    /// What is known of doubles, several at a time: their middles and radii, with no number in the middle where that takes
    /// longer to find out.
    pub(crate) fn near_doubles(&self, values: &[f64], balls: (&mut [f64], &mut [f64])) {
        if let Self::Irrational(by) = self {
            by.of_several(values, balls);
        }
    }

    /// The same of a double; `None` where it takes longer still.
    #[inline]
    pub(crate) fn near_double(&self, kind: Kind, x: f64) -> Option<Ball> {
        match self {
            Self::One => Ball::of_double(x),
            Self::Factor(factor) => near_product(factor, x),
            Self::Irrational(by) => by.of_double(kind, x).or_else(|| by.near_double(kind, x)),
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

/// The ball of the product of a double with a factor; `None` where it takes longer.
fn near_product(factor: &Number, x: f64) -> Option<Ball> {
    let Number::Small(p, q) = *factor else {
        return None;
    };
    // n/2^k, n odd or zero.
    let (n, k) = match Number::from_f64(x)? {
        Number::Small(n, d) => (n, d.trailing_zeros()),
        Number::Tiny(n, k) => (n, k),
        Number::Big(_) => return None,
    };
    if n == 0 {
        return Some(Ball::whole(0));
    }
    let (size, q) = (n.unsigned_abs(), q.cast_unsigned());
    // Of p/q and n/2^k nothing else can be shortened.
    // Most q are short: then so is what one division leaves to look for a divisor in.
    let (divisor, twos) = (q.gcd(&(size % q)), k.min(p.trailing_zeros()));
    let numerator = u128::from(size) * u128::from(p.unsigned_abs());
    let shortest = match divisor {
        1 => numerator >> twos,
        _ => (numerator >> twos) / u128::from(divisor),
    };
    let bits = u64::BITS - (q / divisor).leading_zeros() + (k - twos);
    if let (Ok(shortest), true) = (i64::try_from(shortest), bits < i64::BITS) {
        let numerator = if (n < 0) == (p < 0) {
            shortest
        } else {
            -shortest
        };
        let denominator = ((q / divisor) << (k - twos)).cast_signed();
        return Some(Ball::of_shortest(numerator, denominator));
    }
    Ball::of_scaled_quotient((n < 0) != (p < 0), numerator, q, k)
}

fn unit(text: Option<&str>, example: &str) -> Result<Unit, TraceError> {
    match text {
        Some(text) => read_unit(text),
        None => {
            let message = format!("a column with a unit is needed, as in `{example}`");
            Err(TraceError::new("unit", message))
        }
    }
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
    let unit = unit(text, "x [rad]")?;
    expect(&unit, Dimension::new(0, 1, 0, 0), scene, "a position")?;
    let scale = Scale::of(exact(&unit).over(nominal(scene).length()))?;
    if scale.is_irrational() && !scene.given.has_encoder() {
        let message = "without an encoder positions must be in radians or metres";
        return Err(TraceError::new("unit", message));
    }
    Ok(scale)
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

pub(crate) fn time_scale(text: Option<&str>, scene: &Scene) -> Result<Number, TraceError> {
    needs_units(scene, "tau")?;
    let unit = unit(text, "t [s]")?;
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
    let unit = unit(text, "f [N]")?;
    needs_units(scene, "f")?;
    expect(&unit, Dimension::new(1, 1, -2, 0), scene, "a force")?;
    Scale::of(exact(&unit).over(nominal(scene).force_unit()))
}

/// A unit of velocity in ticks per sampling period: a double, for velocities are compared only.
pub(crate) fn velocity_scale(text: Option<&str>, scene: &Scene) -> Result<f64, TraceError> {
    if text.is_none() && scene.motion == Motion::Dimensionless {
        return Ok(1.0);
    }
    let unit = unit(text, "v [rad/s]")?;
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
        #![proptest_config(ProptestConfig { cases: 4000, ..ProptestConfig::default() })]

        #[test]
        fn a_product_is_known_as_closely_as_by_big_numbers(
            x in double(),
            p in prop_oneof![1..2000_i64, Just(100_000_i64), 1..i64::MAX],
            q in prop_oneof![1..2000_i64, Just(3_i64), 1..i64::MAX],
            count: i16, reversed: bool,
        ) {
            let factor = Number::Small(if reversed { -p } else { p }, q).reduced();
            // The width of some ticks, too, which is close to the border between two of them.
            let ticks = f64::from(count) * q as f64 / p as f64;
            for x in [x, ticks] {
                let Some(found) = near_product(&factor, x) else {
                    continue;
                };
                let written = Number::from_f64(x).unwrap();
                let expected = Reading::Exact(product(&written, &factor)).to_near();
                prop_assert_eq!(found.parts(), expected.lo().parts());
            }
        }
    }
}
