//! Units as data sheets write them: `N m s/rad`, `kg m^2`, `mN·m`, `µm`, `rpm`.
//!
//! A unit is an exact rational factor to SI, a power of π (degrees, turns) and a dimension in which
//! the angle counts, so that newtons per metre and newton-metres per radian are told apart.

mod dimension;
mod expression;
mod symbols;

pub use dimension::Dimension;

use std::ops::Range;

use num_traits::One;
use passivity_core::BigRational;

/// The longest unit that is read, in bytes.
pub const MAX_CHARS: usize = 200;

/// A unit of measurement.
///
/// # Example
///
/// ```
/// use passivity_scene::units::Unit;
///
/// let unit = Unit::parse("mN m").unwrap();
/// assert_eq!(unit.scale().to_string(), "1/1000");
/// assert_eq!(unit.dimension(), Unit::parse("kg m^2/s^2").unwrap().dimension());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    scale: BigRational,
    pi: i8,
    dimension: Dimension,
}

impl Unit {
    /// The unit of a plain number.
    #[must_use]
    pub fn one() -> Self {
        Self {
            scale: BigRational::one(),
            pi: 0,
            dimension: Dimension::NONE,
        }
    }

    /// Reads a unit: symbols with SI prefixes, multiplied by spaces, `*`, `·`, `.` or a hyphen, divided
    /// by `/`, with whole powers (`^2`, `²`, `^-1`) and parentheses.
    ///
    /// A `/` divides by the one factor that follows it; `N m/rad s` is refused because some read
    /// it one way and some the other.
    ///
    /// # Errors
    ///
    /// [`UnitError`] with the place of an unknown symbol or of what cannot stand there.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_scene::units::Unit;
    ///
    /// assert_eq!(Unit::parse("N s/mm"), Unit::parse("kN·s·m⁻¹"));
    /// assert_eq!(Unit::parse("N.m/rad"), Unit::parse("N-m/rad"));
    /// assert_eq!(Unit::parse("rpm").unwrap().pi_power(), 1);
    /// assert_eq!(Unit::parse("N foo").unwrap_err().span(), 2..5);
    /// ```
    pub fn parse(text: &str) -> Result<Self, UnitError> {
        expression::parse(text)
    }

    /// Reads a unit of which is known what it is for; that an unknown one may have been, if it then fits, is the
    /// error's [help](UnitError::help).
    ///
    /// # Errors
    ///
    /// Those of [`Unit::parse`]: whether the unit fits is not looked at.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_scene::units::Unit;
    ///
    /// let stiffness = Unit::parse("N/m").unwrap().dimension();
    /// let fits = |unit: &Unit| unit.dimension() == stiffness;
    /// let error = Unit::parse_for("KN/M", fits).unwrap_err();
    /// assert_eq!(error.help(), Some("did you mean `kN/m`?"));
    /// ```
    pub fn parse_for(text: &str, fits: impl Fn(&Self) -> bool) -> Result<Self, UnitError> {
        Self::parse(text).map_err(|error| match error.unknown {
            true => UnitError {
                help: expression::proposal(text, &fits),
                ..error
            },
            false => error,
        })
    }

    /// The factor to SI units, without its power of π.
    #[must_use]
    pub const fn scale(&self) -> &BigRational {
        &self.scale
    }

    /// The power of π in the factor to SI units: 1 for degrees and turns.
    #[must_use]
    pub const fn pi_power(&self) -> i8 {
        self.pi
    }

    /// What the unit measures.
    #[must_use]
    pub const fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// The unit with each mass in it taken as its weight at standard gravity, 9.80665 m/s² exactly (3rd
    /// General Conference on Weights and Measures, 1901): `oz in` is then a torque and `lb/in` a
    /// stiffness, as data sheets print them. `None` past the powers that are kept.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_scene::units::Unit;
    ///
    /// let torque = Unit::parse("oz in").unwrap().as_weight().unwrap();
    /// assert_eq!(torque, Unit::parse("ozf in").unwrap());
    /// ```
    #[must_use]
    pub fn as_weight(&self) -> Option<Self> {
        let gravity = Self {
            scale: BigRational::new(980_665.into(), 100_000.into()),
            pi: 0,
            dimension: Dimension::new(0, 1, -2, 0),
        };
        self.times(&gravity, 1)
    }

    /// The product with another unit's power; `None` past the powers that are kept.
    fn times(&self, other: &Self, power: i8) -> Option<Self> {
        let factor = num_traits::Pow::pow(&other.scale, i32::from(power));
        Some(Self {
            scale: &self.scale * factor,
            pi: self.pi.checked_add(other.pi.checked_mul(power)?)?,
            dimension: self.dimension.times(other.dimension, power)?,
        })
    }
}

/// Why a text is not a unit, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitError {
    unknown: bool,
    span: Range<usize>,
    message: String,
    help: Option<String>,
}

impl UnitError {
    /// Whether the text has a unit's form, but a symbol in it is unknown.
    #[must_use]
    pub const fn is_unknown_symbol(&self) -> bool {
        self.unknown
    }

    /// Where in the text, in bytes.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// What may have been meant, or how to write it.
    #[must_use]
    pub fn help(&self) -> Option<&str> {
        self.help.as_deref()
    }
}

impl std::fmt::Display for UnitError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for UnitError {}
