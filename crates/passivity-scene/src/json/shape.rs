//! How exact numbers look in JSON: of each a type that serde writes it as and schemas describe, by the one
//! attribute `#[serde(with = "shape::Interval")]`. Errors are those of the serializer.
//!
//! Types that schemas show as what they hold have comments instead of documentation, which schemas would show.
#![allow(clippy::missing_errors_doc)] // said above, once

use passivity_core::{BigRational, Effect};
use schemars::JsonSchema;
use serde::{Serialize as _, Serializer};

/// A rational in lowest terms, such as `3/8`, `-2` or `0`.
#[derive(JsonSchema)]
#[schemars(transparent)]
pub struct Rational(#[schemars(regex(pattern = r"^-?[0-9]+(/[0-9]+)?$"))] pub String);

// A rational, or null.
#[allow(missing_docs)]
#[derive(JsonSchema)]
#[schemars(transparent)]
pub struct OptionalRational(pub Option<Rational>);

/// All numbers from `lo` to `hi`.
#[derive(JsonSchema)]
pub struct Interval {
    /// The lower end.
    pub lo: Rational,
    /// The upper end.
    pub hi: Rational,
    /// The double nearest to the middle; null past the doubles.
    pub approx: Option<f64>,
}

// An interval, or null.
#[allow(missing_docs)]
#[derive(JsonSchema)]
#[schemars(transparent)]
pub struct OptionalInterval(pub Option<Interval>);

// Effects by their names.
#[allow(missing_docs)]
#[derive(JsonSchema)]
#[schemars(transparent)]
pub struct Effects(pub Vec<String>);

/// What is known of a statement.
#[derive(JsonSchema)]
#[schemars(rename_all = "snake_case")]
pub enum Truth {
    /// It holds.
    Holds,
    /// It does not.
    Fails,
    /// It depends on the tolerances.
    Depends,
}

// What is known of a statement, or null where it does not apply.
#[allow(missing_docs)]
#[derive(JsonSchema)]
#[schemars(transparent)]
pub struct OptionalTruth(pub Option<Truth>);

/// A region of the (β, σ) plane.
#[derive(JsonSchema)]
#[schemars(rename_all = "snake_case")]
pub enum Region {
    /// The criterion holds at every speed.
    GloballyStable,
    /// It holds up to the critical speed.
    LocallyStable,
    /// It fails below the critical speed.
    LimitCycles,
    /// It holds at no speed.
    Unstable,
    /// It depends on the tolerances.
    Depends,
}

impl Rational {
    /// Writes a rational as a string in lowest terms.
    pub fn serialize<S: Serializer>(x: &BigRational, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(x)
    }
}

impl OptionalRational {
    /// Writes a rational as a string in lowest terms, or null.
    pub fn serialize<S: Serializer>(
        x: &Option<BigRational>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        x.as_ref().map(ToString::to_string).serialize(serializer)
    }
}

impl Interval {
    /// Writes an interval as [`interval`](super::interval) does.
    pub fn serialize<S: Serializer>(
        x: &passivity_core::Interval<BigRational>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        super::interval(x).serialize(serializer)
    }
}

impl OptionalInterval {
    /// Writes an interval as [`interval`](super::interval) does, or null.
    pub fn serialize<S: Serializer>(
        x: &Option<passivity_core::Interval<BigRational>>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        x.as_ref().map(super::interval).serialize(serializer)
    }
}

impl Effects {
    /// Writes the names of effects.
    pub fn serialize<S: Serializer>(effects: &[Effect], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(effects.iter().map(|effect| effect.name()))
    }
}

impl OptionalTruth {
    /// Writes what is known, or null.
    pub fn serialize<S: Serializer>(
        truth: &Option<passivity_core::Truth>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        truth.map(passivity_core::Truth::name).serialize(serializer)
    }
}

impl Region {
    /// Writes the region's name, and that it depends where it is not one.
    pub fn serialize<S: Serializer>(
        region: &Option<passivity_core::Region>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(region.map_or("depends", passivity_core::Region::name))
    }
}
