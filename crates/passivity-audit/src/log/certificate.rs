//! A violated interval with all that its figures follow from, for others to compute again.

use passivity_core::BigRational;
use serde::Serialize;

use crate::figure::Figure;
use crate::ledger::{Ledger, Row, on_entry};
use crate::log::account::Place;
use crate::number::Written;
use crate::reading::Reading;

/// The name of this format.
const FORMAT: &str = "passivity-audit-certificate-1";

/// An interval that surely generated more than friction surely dissipated: the loop, what the trace
/// says of the interval, and the figures that follow from the two.
///
/// Serialised it is the file that `audit --certificate` writes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Certificate {
    format: &'static str,
    scene: String,
    /// The keys of the parameters that were taken at their nominal value.
    nominal: Vec<&'static str>,
    r#loop: Terms,
    log: Log,
    figures: Figures,
}

/// The dimensionless loop, as far as the account uses it.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Terms {
    beta: Stated,
    sigma: Stated,
    encoder: bool,
    delay: u16,
    unilateral: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    damping: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    force_step: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    max_force: Option<String>,
}

/// What the trace says of the interval.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Log {
    /// Which interval, from 0.
    h: u64,
    /// The row of the trace that it starts at, from 1.
    row: u64,
    /// The samples before it on which it depends, the oldest first.
    before: Vec<Position>,
    start: Position,
    end: Position,
    dtau: String,
    /// The force of the trace, where the account is of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    force: Option<Stated>,
}

/// The figures of the linear account, in KΔ².
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Figures {
    generated: Stated,
    dissipated_lower: Stated,
    #[serde(skip_serializing_if = "Option::is_none")]
    extra_storage: Option<Stated>,
    net: Stated,
}

/// A rational in lowest terms, or the two ends of what is known of a number.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
enum Stated {
    Exact(String),
    Between { lo: String, hi: String },
}

/// A position as the trace gives it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
enum Position {
    Count(i64),
    Xi(Stated),
}

impl Certificate {
    /// Of a violated interval; `None` when a number is undefined.
    pub(super) fn new(
        scene: &str,
        nominal: Vec<&'static str>,
        ledger: &Ledger,
        place: &Place,
    ) -> Option<Self> {
        let interval = &place.interval;
        let (start, before) = interval.samples.split_first()?;
        Some(Self {
            format: FORMAT,
            scene: scene.to_owned(),
            nominal,
            r#loop: Terms::of(ledger)?,
            log: Log {
                h: place.h,
                row: place.h + 1,
                before: before.iter().rev().map(Position::of).collect(),
                start: Position::of(start),
                end: Position::of(&interval.end),
                dtau: interval.dtau.to_rational().to_string(),
                force: interval.force.as_ref().map(Stated::reading),
            },
            figures: Figures::of(&ledger.row(interval)?)?,
        })
    }
}

impl Terms {
    fn of(ledger: &Ledger) -> Option<Self> {
        let ends = ledger.wide();
        let rational =
            |loop_: &passivity_core::Loop<_>| loop_.try_map(|_, x| Written::to_rational(x));
        let (least, most) = (rational(&ends.least)?, rational(&ends.most)?);
        let (low, high) = (least.friction(), most.friction());
        let text = |x: &Option<BigRational>| x.as_ref().map(BigRational::to_string);
        Some(Self {
            beta: Stated::ends(&low.beta, &high.beta),
            sigma: Stated::ends(&low.sigma, &high.sigma),
            encoder: least.has_encoder(),
            delay: least.delay,
            unilateral: least.unilateral,
            damping: text(&least.damping),
            force_step: text(&least.force_step),
            max_force: text(&least.max_force),
        })
    }
}

impl Figures {
    fn of(row: &Row) -> Option<Self> {
        on_entry!(row, entry => {
            let account = &entry.account;
            Some(Self {
                generated: Stated::figure(&account.generated_linear)?,
                dissipated_lower: Stated::figure(&account.dissipated_lower)?,
                extra_storage: match &entry.extra_storage {
                    Some(gain) => Some(Stated::figure(gain)?),
                    None => None,
                },
                net: Stated::figure(&account.net_linear)?,
            })
        })
    }
}

impl Stated {
    fn ends(lo: &BigRational, hi: &BigRational) -> Self {
        match lo == hi {
            true => Self::Exact(lo.to_string()),
            false => Self::Between {
                lo: lo.to_string(),
                hi: hi.to_string(),
            },
        }
    }

    fn reading(reading: &Reading) -> Self {
        let range = reading.to_rational();
        Self::ends(range.lo(), range.hi())
    }

    fn figure<S: Written>(figure: &Figure<S>) -> Option<Self> {
        let ends = figure.try_map(Written::to_rational)?;
        Some(Self::ends(ends.lo(), ends.hi()))
    }
}

impl Position {
    fn of(reading: &Reading) -> Self {
        match reading {
            Reading::Count(n) => Self::Count(*n),
            Reading::Exact(_) | Reading::Within(_) => Self::Xi(Stated::reading(reading)),
        }
    }
}
