//! A report for people.

use std::fmt::Write as _;

use passivity_core::{BigRational, Interval, Region};

use super::changes::{Change, Direction};
use super::decide::Verdict;
use super::report::{BoundSource, Report};
use crate::display::{approx, range, wrapped};
use crate::effect::Effect;
use crate::scene::Motion;

impl Report {
    /// The report as text, a screen for a scene.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut out = String::new();
        let mut line = |label: &str, value: &str| {
            // Writing to a string cannot fail.
            let _ = writeln!(out, "  {label:<26}{}", wrapped(value, 28));
        };
        line("region", &self.region_text());
        line("β = b/(KT)", &range(&self.beta));
        match &self.sigma {
            Some(sigma) => line("σ = c/(KΔ)", &range(sigma)),
            None => line("σ", "none: the position is not quantized"),
        }
        if let Some(mu) = &self.mu {
            line("μ = m/(KT²)", &range(mu));
        }
        line("margin at every speed", &range(&self.margin_at_all_speeds));
        if let Some(margin) = &self.margin_at_speed_bound {
            line(&format!("margin at {}", self.bound_text()), &range(margin));
        }
        if let Some(ticks) = &self.critical_speed {
            line(
                "critical speed",
                &self.speed_text(self.critical_speed_si.as_ref(), ticks),
            );
        }
        let unit = stiffness_unit(self.motion);
        if let Some(k) = &self.max_stiffness_all_speeds {
            line(
                "stiffest wall",
                &format!("{} {unit} at every speed", range(k)),
            );
        }
        if let Some(k) = &self.max_stiffness_at_speed_bound {
            line(
                "",
                &format!("{} {unit} up to {}", range(k), self.bound_text()),
            );
        }
        line("Colgate, b ≥ KT/2", self.colgate.name());
        line("Abbott and Okamura", self.abbott_okamura.name());
        line("effects", &words(&self.effects));
        if !self.because.is_empty() {
            line("because", &self.because.join(", "));
        }
        let mut text = format!("{}: {}\n{out}", self.scene, self.headline());
        text.push_str(&self.witness_text());
        text.push_str(&self.changes_text());
        text
    }

    /// The verdict in one line.
    #[must_use]
    pub fn headline(&self) -> String {
        let bound = || match (
            &self.speed_bound,
            self.margin_at_all_speeds.is_nonnegative(),
        ) {
            (_, Some(passivity_core::Truth::Holds)) | (None, _) => "at every speed".to_owned(),
            (Some(_), _) => match self.bound_source {
                Some(BoundSource::Start) => {
                    format!("from its start, at speeds up to {}", self.bound_text())
                }
                _ => format!("at every speed up to {}", self.bound_text()),
            },
        };
        match self.verdict {
            Verdict::Passive => format!("PASSIVE {}", bound()),
            Verdict::NotPassive => "NOT PASSIVE: a cycle draws energy from it".to_owned(),
            Verdict::NotGuaranteed => {
                format!("NOT GUARANTEED passive {}: the criterion fails", bound())
            }
            Verdict::Depends => {
                format!("DEPENDS on the tolerance of {}", self.decided_by.join(", "))
            }
            Verdict::NotCovered => {
                format!("NOT COVERED by a theorem: {}", words(&self.not_covered))
            }
        }
    }

    fn region_text(&self) -> String {
        let words = match self.region {
            None => "depends on the tolerances",
            Some(Region::GloballyStable) => "globally stable: passive at every speed",
            Some(Region::LocallyStable) => "locally stable: passive up to the critical speed",
            Some(Region::LimitCycles) => "limit cycles: not passive below the critical speed",
            Some(Region::Unstable) => "unstable: passive at no speed",
        };
        words.to_owned()
    }

    fn bound_text(&self) -> String {
        match (&self.speed_bound_si, &self.speed_bound) {
            (Some(v), _) => format!("{} {}", range(v), speed_unit(self.motion)),
            (None, Some(v)) => format!("{} ticks/sample", range(v)),
            (None, None) => "every speed".to_owned(),
        }
    }

    fn speed_text(
        &self,
        si: Option<&Interval<BigRational>>,
        ticks: &Interval<BigRational>,
    ) -> String {
        match si {
            Some(v) => {
                format!(
                    "{} {} ({} ticks/sample)",
                    range(v),
                    speed_unit(self.motion),
                    range(ticks)
                )
            }
            None => format!("{} ticks/sample", range(ticks)),
        }
    }

    fn witness_text(&self) -> String {
        let Some(witness) = &self.witness else {
            return String::new();
        };
        let unit = match (&self.sigma, self.motion) {
            (Some(_), _) => "ticks",
            (None, Motion::Linear) => "m",
            (None, _) => "rad",
        };
        let energy = if self.sigma.is_some() {
            "KΔ²"
        } else {
            "K times that unit squared"
        };
        format!(
            "  Witness: move from {} to {} {unit} and back, each way at constant speed within one\n  \
             sampling interval. Every round gains at least {} {energy}.\n",
            short(&witness.from),
            short(&witness.to),
            with_size(&witness.gain_per_cycle),
        )
    }

    fn changes_text(&self) -> String {
        // What is not covered is not mended by a parameter.
        if self.changes.is_empty() || self.verdict == Verdict::NotCovered {
            return String::new();
        }
        let passive = self.verdict == Verdict::Passive;
        let mut out = if passive {
            String::from("  How far each could go alone, and the wall stay passive:\n")
        } else {
            String::from("  What each would have to be for the criterion to hold:\n")
        };
        for change in &self.changes {
            let _ = writeln!(out, "    {}", change_text(change, passive));
        }
        out
    }
}

fn change_text(change: &Change, passive: bool) -> String {
    let relation = match change.direction {
        Direction::AtLeast => "at least",
        Direction::AtMost => "at most",
    };
    // What is promised is the worst end over the tolerances.
    let border = match change.direction {
        Direction::AtLeast => change.border.hi(),
        Direction::AtMost => change.border.lo(),
    };
    let unit = if change.unit.is_empty() {
        String::new()
    } else {
        format!(" {}", change.unit)
    };
    let enough = if passive || change.suffices {
        ""
    } else {
        ", and it is not enough alone"
    };
    format!(
        "{}: {relation} {}{unit} (now {}{unit}){enough}",
        change.name,
        approx(border),
        range(&change.now),
    )
}

fn words(effects: &[Effect]) -> String {
    effects
        .iter()
        .map(|effect| effect.words())
        .collect::<Vec<_>>()
        .join("; ")
}

/// A rational with its size in decimals, unless it is too long to read.
fn with_size(x: &BigRational) -> String {
    let (exact, rounded) = (short(x), approx(x));
    if exact == rounded || exact.starts_with("about") {
        return exact;
    }
    format!("{exact} (≈ {rounded})")
}

/// A rational as it is when that is short enough to read, else rounded.
fn short(x: &BigRational) -> String {
    let exact = x.to_string();
    if exact.len() <= 40 {
        exact
    } else {
        format!("about {}", approx(x))
    }
}

/// The unit of speed of a motion.
#[must_use]
pub(crate) const fn speed_unit(motion: Motion) -> &'static str {
    match motion {
        Motion::Linear => "m/s",
        Motion::Rotary => "rad/s",
        Motion::Dimensionless => "ticks/sample",
    }
}

/// The unit of stiffness of a motion.
#[must_use]
pub(crate) const fn stiffness_unit(motion: Motion) -> &'static str {
    match motion {
        Motion::Linear => "N/m",
        Motion::Rotary => "N m/rad",
        Motion::Dimensionless => "",
    }
}
