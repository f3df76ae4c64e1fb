//! Dimensions of quantities: powers of mass, length, time and angle.

use std::fmt;

/// Powers of mass, length, time and angle.
///
/// The angle is kept although SI counts it as a plain number: it is what tells a torsional
/// stiffness from a torque.
///
/// # Example
///
/// ```
/// use passivity_scene::units::{Dimension, Unit};
///
/// let stiffness = Unit::parse("N m/rad").unwrap().dimension();
/// assert_eq!(stiffness, Dimension::new(1, 2, -2, -1));
/// assert_eq!(stiffness.to_string(), "kg m^2/(s^2 rad)");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension {
    mass: i8,
    length: i8,
    time: i8,
    angle: i8,
}

impl Dimension {
    /// The dimension of a plain number.
    pub const NONE: Self = Self::new(0, 0, 0, 0);

    /// The dimension with these powers.
    #[must_use]
    pub const fn new(mass: i8, length: i8, time: i8, angle: i8) -> Self {
        Self {
            mass,
            length,
            time,
            angle,
        }
    }

    /// The power of the angle.
    #[must_use]
    pub const fn angle(self) -> i8 {
        self.angle
    }

    /// The dimension with another power of the angle.
    #[must_use]
    pub const fn with_angle(self, angle: i8) -> Self {
        Self { angle, ..self }
    }

    /// The dimension of a product with a power of `other`; `None` past 8 bits.
    pub(super) fn times(self, other: Self, power: i8) -> Option<Self> {
        let sum = |a: i8, b: i8| a.checked_add(b.checked_mul(power)?);
        Some(Self {
            mass: sum(self.mass, other.mass)?,
            length: sum(self.length, other.length)?,
            time: sum(self.time, other.time)?,
            angle: sum(self.angle, other.angle)?,
        })
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let powers = [
            ("kg", self.mass),
            ("m", self.length),
            ("s", self.time),
            ("rad", self.angle),
        ];
        let factors = |above: bool| {
            let chosen = powers.iter().filter(|(_, p)| (*p > 0) == above && *p != 0);
            let written = chosen.map(|(name, p)| match p.unsigned_abs() {
                1 => (*name).to_owned(),
                n => format!("{name}^{n}"),
            });
            written.collect::<Vec<_>>()
        };
        let (above, below) = (factors(true), factors(false));
        let numerator = if above.is_empty() {
            "1".to_owned()
        } else {
            above.join(" ")
        };
        match below.as_slice() {
            [] => f.write_str(&numerator),
            [one] => write!(f, "{numerator}/{one}"),
            many => write!(f, "{numerator}/({})", many.join(" ")),
        }
    }
}
