//! The command-line arguments, from which help, man page and completions are made.

#[cfg(any(feature = "audit", feature = "simulate", feature = "vectors"))]
use std::{fmt::Display, ops::RangeInclusive, str::FromStr};

use clap::{Parser, Subcommand};

use crate::verbs;

/// Says, exactly and with proof, whether a haptic device can render a virtual wall without feeding
/// energy to the hand that holds it.
///
/// Exit codes: 0 the claim holds; 1 it does not, or it depends; 2 bad input or usage; 3 the scene
/// has an effect that no theorem covers.
#[derive(Debug, Parser)]
#[command(
    name = "passivity",
    version,
    max_term_width = 100,
    arg_required_else_help = true
)]
#[command(after_help = "Examples:
  passivity check scenes/re35.toml
  passivity check --format json scenes/*.toml
  passivity explain scenes/re35.toml
  passivity design scenes/re35.toml
  passivity plane scenes/re35*.toml --plot plane.svg
  passivity case scenes/re35.toml --out case")]
pub(crate) struct Args {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// The verbs.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Check(verbs::check::Args),
    Explain(verbs::explain::Args),
    Design(verbs::design::Args),
    Export(verbs::export::Args),
    Init(verbs::init::Args),
    Schema(verbs::schema::Args),
    Simulate(verbs::simulate::Args),
    Sweep(verbs::sweep::Args),
    Plane(verbs::plane::Args),
    Accuracy(verbs::accuracy::Args),
    Audit(verbs::audit::Args),
    Identify(verbs::identify::Args),
    Oracle(verbs::oracle::Args),
    Vectors(verbs::vectors::Args),
    Case(verbs::case::Args),
    Completions(verbs::completions::Args),
    Man(verbs::man::Args),
}

/// Reads a whole number in a range.
#[cfg(any(feature = "audit", feature = "simulate", feature = "vectors"))]
pub(crate) fn whole<T>(range: RangeInclusive<T>) -> impl Fn(&str) -> Result<T, String> + Clone
where
    T: Clone + Display + FromStr + PartialOrd,
{
    move |text| match text.parse() {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => Err(format!(
            "expected a whole number from {} to {}",
            range.start(),
            range.end()
        )),
    }
}

/// Reads a number of something, said with its unit and an example.
#[cfg(feature = "identify")]
pub(crate) fn number(of: &'static str) -> impl Fn(&str) -> Result<f64, String> + Clone {
    move |text| {
        let number = text.parse().ok();
        let number = number.filter(|x: &f64| *x >= 0.0 && x.is_finite());
        number.ok_or_else(|| format!("expected a number {of}, zero or above it"))
    }
}

/// Reads a share of something, below 1.
#[cfg(feature = "identify")]
pub(crate) fn share(text: &str) -> Result<f64, String> {
    let share = text.parse().ok().filter(|x| (0.0..1.0).contains(x));
    share.ok_or_else(|| "expected a share from 0 to below 1, such as 0.05 for 5 %".to_owned())
}

/// What a count may be off by.
#[cfg(feature = "identify")]
pub(crate) const TICKS: &str = "of ticks, such as 0.5";

/// What a force may be off by.
#[cfg(feature = "identify")]
pub(crate) const FORCE: &str =
    "of N, or of N m where the device turns, without the unit, such as 0.0001";
